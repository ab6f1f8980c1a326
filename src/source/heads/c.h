#ifndef SPHERECAP_INLINE_H
#define SPHERECAP_INLINE_H

// {about}
// C99 or C++11; no library but the math functions of the standard one. Compile with -mfma, or for a processor that has fused
// multiply-adds: without them each is a call; and with -fno-math-errno, or each square root is checked for errors. With
// -ffp-contract=off all results are those of the library to the bit; without it, densities are within 3e-7 of them, and of
// `both`, whose smaller side has what the larger leaves, within 1e-5.

#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "spherecap needs numbers as IEEE 754 has them: compile without -ffast-math, -Ofast or /fp:fast"
#endif

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static inline float spherecap_inline_min(float a, float b)
{
    return a < b ? a : b;
}

static inline float spherecap_inline_max(float a, float b)
{
    return a > b ? a : b;
}

// What rounding took off the product a b.
static inline float spherecap_inline_lost(float a, float b, float product)
{
    return fmaf(a, b, -product);
}

// A number without its sign and its significand.
static inline float spherecap_inline_power_of_two(float a)
{
    uint32_t bits;
    memcpy(&bits, &a, sizeof bits);
    bits &= 0x7f800000u;
    memcpy(&a, &bits, sizeof a);
    return a;
}

// The bits of a number, as a number.
static inline float spherecap_inline_bits(float a)
{
    int32_t bits;
    memcpy(&bits, &a, sizeof bits);
    return (float)bits;
}

// The number of these bits; any number where they are none.
static inline float spherecap_inline_float_of_bits(float a)
{
    const int32_t bits = a >= 0.0f && a < 2147483648.0f ? (int32_t)a : 0;
    memcpy(&a, &bits, sizeof a);
    return a;
}
