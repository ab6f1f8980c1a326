//! Sixteen numbers: AVX-512F. A mask is a bit per lane, in a register of its own kind.

use super::*;
use core::arch::x86_64::*;

packet! {
    F32x16(__m512) of 16, Mask16(__mmask16),
    load: load, store: store, set: _mm512_set1_ps,
    neg: neg, add: _mm512_add_ps, sub: _mm512_sub_ps, mul: _mm512_mul_ps, div: _mm512_div_ps,
    fma: _mm512_fmadd_ps, sqrt: _mm512_sqrt_ps, abs: _mm512_abs_ps, min: _mm512_min_ps, max: _mm512_max_ps,
    lt: lt, le: le, select: select,
    power_of_two: power_of_two, bits: bits, float_of_bits: float_of_bits,
    and: and, or: or, not: not, any: any, all: all,
}

#[inline]
#[target_feature(enable = "avx512f")]
unsafe fn load(from: *const f32, count: usize) -> __m512 {
    // SAFETY: the caller's promise.
    unsafe { _mm512_maskz_loadu_ps(first(count), from) }
}

#[inline]
#[target_feature(enable = "avx512f")]
unsafe fn store(to: *mut f32, count: usize, a: __m512) {
    // A masked store costs a short kernel a tenth of its time.
    // SAFETY: the caller's promise.
    unsafe {
        if count == 16 {
            _mm512_storeu_ps(to, a);
        } else {
            _mm512_mask_storeu_ps(to, first(count), a);
        }
    }
}

/// The bits of the first `count` lanes.
#[inline]
#[target_feature(enable = "avx512f")]
fn first(count: usize) -> __mmask16 {
    ((1_u32 << count) - 1) as __mmask16
}

/// By integers: the operation on numbers is AVX-512DQ's.
#[inline]
#[target_feature(enable = "avx512f")]
fn neg(a: __m512) -> __m512 {
    _mm512_castsi512_ps(_mm512_xor_si512(_mm512_castps_si512(a), _mm512_set1_epi32(i32::MIN)))
}

#[inline]
#[target_feature(enable = "avx512f")]
fn lt(a: __m512, b: __m512) -> __mmask16 {
    _mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b)
}

#[inline]
#[target_feature(enable = "avx512f")]
fn le(a: __m512, b: __m512) -> __mmask16 {
    _mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b)
}

#[inline]
#[target_feature(enable = "avx512f")]
fn select(mask: __mmask16, yes: __m512, no: __m512) -> __m512 {
    _mm512_mask_blend_ps(mask, no, yes)
}

/// By integers, like [`neg`].
#[inline]
#[target_feature(enable = "avx512f")]
fn power_of_two(a: __m512) -> __m512 {
    let infinity = _mm512_castps_si512(_mm512_set1_ps(f32::INFINITY));
    _mm512_castsi512_ps(_mm512_and_si512(_mm512_castps_si512(a), infinity))
}

#[inline]
#[target_feature(enable = "avx512f")]
fn bits(a: __m512) -> __m512 {
    _mm512_cvtepi32_ps(_mm512_castps_si512(a))
}

#[inline]
#[target_feature(enable = "avx512f")]
fn float_of_bits(a: __m512) -> __m512 {
    _mm512_castsi512_ps(_mm512_cvttps_epi32(a))
}

#[inline]
#[target_feature(enable = "avx512f")]
fn and(a: __mmask16, b: __mmask16) -> __mmask16 {
    a & b
}

#[inline]
#[target_feature(enable = "avx512f")]
fn or(a: __mmask16, b: __mmask16) -> __mmask16 {
    a | b
}

#[inline]
#[target_feature(enable = "avx512f")]
fn not(a: __mmask16) -> __mmask16 {
    !a
}

#[inline]
#[target_feature(enable = "avx512f")]
fn any(a: __mmask16) -> bool {
    a != 0
}

#[inline]
#[target_feature(enable = "avx512f")]
fn all(a: __mmask16) -> bool {
    a == 0xffff
}
