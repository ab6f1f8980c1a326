// Goes wrong on demand, so that sanitizers which are not at work are noticed. C and C++.

#include <stdlib.h>

int main(int count, char **arguments) {
    volatile int largest = 2147483647;
    volatile char *byte = (volatile char *)calloc(1, 1);
    free((void *)byte);
    switch (count > 1 ? arguments[1][0] : 'n') {
    case 'a': // an address that is not ours any more
        return byte[0];
    case 'u': // undefined behaviour
        return largest + count > 0;
    default:
        return 0;
    }
}
