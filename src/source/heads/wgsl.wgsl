// {about}
// Roundings that count are kept by bits that are zero, which the compiler cannot know: WGSL has no other word for that.

// The number as it was rounded, which the compiler cannot see through.
fn spherecap_keep(a: f32, unknown_zero: u32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a) | unknown_zero);
}

// What rounding took off the product a b: products of halves are exact (Dekker).
fn spherecap_lost(a: f32, b: f32, product: f32, unknown_zero: u32) -> f32 {
    let a_high = bitcast<f32>(bitcast<u32>(a) & 0xfffff000u);
    let b_high = bitcast<f32>(bitcast<u32>(b) & 0xfffff000u);
    let a_low = spherecap_keep(a - a_high, unknown_zero);
    let b_low = spherecap_keep(b - b_high, unknown_zero);
    var lost = spherecap_keep(a_high * b_high - product, unknown_zero);
    lost = spherecap_keep(lost + a_high * b_low, unknown_zero);
    lost = spherecap_keep(lost + a_low * b_high, unknown_zero);
    return lost + a_low * b_low;
}

// a b + c, rounded as if once where the sum cancels.
fn spherecap_fused(a: f32, b: f32, c: f32, unknown_zero: u32) -> f32 {
    let product = spherecap_keep(a * b, unknown_zero);
    return spherecap_keep(product + c, unknown_zero) + spherecap_lost(a, b, product, unknown_zero);
}

// A number without its sign and its significand.
fn spherecap_power_of_two(a: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a) & 0x7f800000u);
}

// The bits of a number, as a number.
fn spherecap_bits(a: f32) -> f32 {
    return f32(bitcast<i32>(a));
}

// The number of these bits; any number where they are none.
fn spherecap_float_of_bits(a: f32) -> f32 {
    return bitcast<f32>(i32(a));
}
