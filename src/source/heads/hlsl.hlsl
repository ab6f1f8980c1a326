#ifndef SPHERECAP_HLSL
#define SPHERECAP_HLSL

// {about}
// Shader model 5.0 or later. Define SPHERECAP_FUSED_FMA where mad() rounds once, as on all desktop GPUs: fewer instructions.

// What rounding took off the product a b.
float spherecap_lost(float a, float b, float product) {
#ifdef SPHERECAP_FUSED_FMA
    precise float lost = mad(a, b, -product);
#else
    // Products of halves are exact (Dekker).
    precise float a_high = asfloat(asuint(a) & 0xfffff000u);
    precise float b_high = asfloat(asuint(b) & 0xfffff000u);
    precise float a_low = a - a_high;
    precise float b_low = b - b_high;
    // `precise` reaches sums and products, not mad(): two of those in a row could be factored.
    precise float rest = mad(a_high, b_high, -product) + a_high * b_low;
    precise float lost = mad(a_low, b_high, rest) + a_low * b_low;
#endif
    return lost;
}

// a b + c, rounded as if once where the sum cancels.
float spherecap_fused(float a, float b, float c) {
#ifdef SPHERECAP_FUSED_FMA
    precise float sum = mad(a, b, c);
#else
    precise float product = a * b;
    precise float sum = (product + c) + spherecap_lost(a, b, product);
#endif
    return sum;
}

// A number without its sign and its significand.
float spherecap_power_of_two(float a) {
    return asfloat(asuint(a) & 0x7f800000u);
}

// The bits of a number, as a number.
float spherecap_bits(float a) {
    return float(asint(a));
}

// The number of these bits; any number where they are none.
float spherecap_float_of_bits(float a) {
    return asfloat(int(a));
}
