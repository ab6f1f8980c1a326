// `bits.c` in double precision.

#define DOUBLE_PRECISION

#include "bits.c"
