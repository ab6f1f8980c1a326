/* What the C that ptx2c.py writes is made of: how a GPU computes in single precision.

   Numbers are flushed to zero where an instruction says so. Reciprocals and roots of the special function
   unit are rounded correctly, or off by up to STUB_ULPS units in the last place; by how many depends on the
   operand and on STUB_SEED alone. */

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef uint8_t pred, b8, u8;
typedef uint16_t b16, u16;
typedef uint32_t b32, u32;
typedef uint64_t b64, u64;
typedef int16_t s16;
typedef int32_t s32;
typedef int64_t s64;
typedef float f32;

/// Which thread of which block this is, and how many there are.
static u32 thread, threads, block, blocks;

static u32 ulps, seed;

__attribute__((constructor)) static void read_environment(void) {
    const char *text = getenv("STUB_ULPS");
    ulps = text ? atoi(text) : 0;
    text = getenv("STUB_SEED");
    seed = text ? atoi(text) : 0;
}

static inline f32 f32_of(u64 bits) {
    const u32 low = bits;
    f32 x;
    memcpy(&x, &low, 4);
    return x;
}

static inline u32 bits_of(f32 x) {
    u32 bits;
    memcpy(&bits, &x, 4);
    return isnan(x) ? 0x7fffffff : bits;
}

static inline f32 ftz(f32 x) { return fpclassify(x) == FP_SUBNORMAL ? copysignf(0, x) : x; }

/// The number, if one is NaN; negative zero is less than zero.
static inline f32 min_f32(f32 x, f32 y) {
    return isnan(x) ? y : isnan(y) ? x : x < y || (x == y && signbit(x)) ? x : y;
}

static inline f32 max_f32(f32 x, f32 y) { return -min_f32(-x, -y); }

/// Rounded towards zero.
static inline s32 s32_rzi(f32 x) {
    return isnan(x) ? 0 : x < -0x1p31f ? INT32_MIN : x >= 0x1p31f ? INT32_MAX : (s32)x;
}

/// An exact value as the special function unit gives it for an operand. What is a number, it gives exactly.
static inline f32 approximate(double exact, u32 operand) {
    const f32 rounded = exact;
    if (ulps == 0 || rounded == exact || !isnormal(rounded))
        return rounded;
    // A hash with good avalanches (the 32-bit finalizer of "lowbias32").
    u32 x = operand ^ seed * 0x9e3779b9;
    x = (x ^ x >> 16) * 0x7feb352d;
    x = (x ^ x >> 15) * 0x846ca68b;
    x ^= x >> 16;
    return f32_of(bits_of(rounded) + x % (2 * ulps + 1) - ulps);
}

// Their operands are flushed already; subnormal results are flushed by who calls.
static inline f32 rcp_approx(f32 x) { return approximate(1. / x, bits_of(x)); }
static inline f32 sqrt_approx(f32 x) { return approximate(sqrt(x), ~bits_of(x)); }
static inline f32 rsqrt_approx(f32 x) { return approximate(1 / sqrt(x), bits_of(x) ^ 0x55555555); }
static inline f32 div_approx(f32 x, f32 y) { return x * ftz(rcp_approx(y)); }
