#!/bin/sh
# Builds the C and C++ programs and runs them under valgrind, to which any error and any leak is one: `make valgrind`.
# The library is the release build. With portable instructions, as valgrind does not know all others.
set -eu

if ! command -v valgrind > /dev/null; then
    echo "make valgrind needs valgrind, which is not installed: on Debian and Ubuntu, apt-get install valgrind" >&2
    exit 1
fi
out=build/valgrind
mkdir -p "$out"

build() { # source
    case $1 in
        *.cpp) compiler="${CXX:-c++} -std=c++17" ;;
        *) compiler="${CC:-cc} -std=c99" ;;
    esac
    $compiler -g -O1 -w -D_DEFAULT_SOURCE -Iinclude "$1" target/release/libspherecap.a -lpthread -ldl -lm \
        -o "$out/$(basename "$1" | tr . _)"
}

check() { # program and its arguments
    program=$1
    shift
    echo "valgrind $program $*"
    valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=all --errors-for-leak-kinds=all \
        "$out/$program" "$@" > "$out/$program.out"
}

for source in examples/print_samples.c tests/c/*.c tests/c/*.cpp; do
    case $source in
        # They call nothing of the library.
        tests/c/inline.c | tests/c/cuda.cpp) ;;
        *) build "$source" ;;
    esac
done

export SPHERECAP_INSTRUCTIONS=portable
noticed=0
check sanitizers_c address 2> /dev/null || noticed=$?
if [ "$noticed" != 99 ]; then
    echo "valgrind does not notice an address that is not the program's any more" >&2
    exit 1
fi
check print_samples_c
check calls_c
check calls_cpp
check batch_c
check fuzz_c 4000
# A light that is cut, one by solid angle with a defensive fraction on no surface, one below the horizon.
words="0 0 00000000 00000000 00000000 3f800000 40400000 00000000 3f000000 3f800000 3e800000 3f400000
1 1 3e000000 00000000 00000000 00000000 40400000 00000000 3f000000 3f800000 3e800000 3f400000
0 0 00000000 00000000 00000000 40e00000 40400000 00000000 c0000000 3f800000 3e800000 3f400000"
echo "$words" | check bits_c
echo "$words" | check record_c
echo "$words" | check lights_c
echo "0 0 0000000000000000 0000000000000000 0000000000000000 3ff0000000000000 4008000000000000 0000000000000000 \
3fe0000000000000 3ff0000000000000 3fd0000000000000 3fe8000000000000" | check bits_f64_c
printf "image 8 6\ncamera 1 -3 6 0.2 0.3 0 50\nlight 0 0 1.5 0.5 1\nrectangle 0 0 0 9 0 0 0 9 0 0.5\n" |
    check renderer_c projected independent 2 1
SPHERECAP_INSTRUCTIONS=no_such_word check no_instructions_c
