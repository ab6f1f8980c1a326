#ifndef SPHERECAP_GLSL
#define SPHERECAP_GLSL

// {about}
// GLSL 4.00, or later for Vulkan. Define SPHERECAP_FUSED_FMA where fma() rounds once, as on all desktop GPUs: fewer instructions.

// What rounding took off the product a b.
float spherecap_lost(float a, float b, float product) {
#ifdef SPHERECAP_FUSED_FMA
    precise float lost = fma(a, b, -product);
#else
    // Products of halves are exact (Dekker).
    precise float a_high = uintBitsToFloat(floatBitsToUint(a) & 0xfffff000u);
    precise float b_high = uintBitsToFloat(floatBitsToUint(b) & 0xfffff000u);
    precise float a_low = a - a_high;
    precise float b_low = b - b_high;
    // `precise` reaches sums and products, not fma(): two of those in a row could be factored.
    precise float rest = fma(a_high, b_high, -product) + a_high * b_low;
    precise float lost = fma(a_low, b_high, rest) + a_low * b_low;
#endif
    return lost;
}

// a b + c, rounded as if once where the sum cancels.
float spherecap_fused(float a, float b, float c) {
#ifdef SPHERECAP_FUSED_FMA
    precise float sum = fma(a, b, c);
#else
    precise float product = a * b;
    precise float sum = (product + c) + spherecap_lost(a, b, product);
#endif
    return sum;
}

// A number without its sign and its significand.
float spherecap_power_of_two(float a) {
    return uintBitsToFloat(floatBitsToUint(a) & 0x7f800000u);
}

// The bits of a number, as a number.
float spherecap_bits(float a) {
    return float(floatBitsToInt(a));
}

// The number of these bits; any number where they are none.
float spherecap_float_of_bits(float a) {
    return intBitsToFloat(int(a));
}
