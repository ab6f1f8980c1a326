//! Eight numbers: AVX2 and FMA. A mask is a register with all bits of a lane set, or none.

use super::*;
use core::arch::x86_64::*;

packet! {
    F32x8(__m256) of 8, Mask8(__m256),
    load: load, store: store, set: _mm256_set1_ps,
    neg: neg, add: _mm256_add_ps, sub: _mm256_sub_ps, mul: _mm256_mul_ps, div: _mm256_div_ps,
    fma: _mm256_fmadd_ps, sqrt: _mm256_sqrt_ps, abs: abs, min: _mm256_min_ps, max: _mm256_max_ps,
    lt: lt, le: le, select: select,
    power_of_two: power_of_two, bits: bits, float_of_bits: float_of_bits,
    and: _mm256_and_ps, or: _mm256_or_ps, not: not, any: any, all: all,
}

#[inline]
#[target_feature(enable = "avx2,fma")]
unsafe fn load(from: *const f32, count: usize) -> __m256 {
    // SAFETY: the caller's promise.
    unsafe {
        if count == 8 {
            _mm256_loadu_ps(from)
        } else {
            _mm256_maskload_ps(from, first(count))
        }
    }
}

#[inline]
#[target_feature(enable = "avx2,fma")]
unsafe fn store(to: *mut f32, count: usize, a: __m256) {
    // SAFETY: the caller's promise.
    unsafe {
        if count == 8 {
            _mm256_storeu_ps(to, a);
        } else {
            _mm256_maskstore_ps(to, first(count), a);
        }
    }
}

/// All bits set in the first `count` lanes.
#[inline]
#[target_feature(enable = "avx2,fma")]
fn first(count: usize) -> __m256i {
    _mm256_cmpgt_epi32(_mm256_set1_epi32(count as i32), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7))
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn neg(a: __m256) -> __m256 {
    _mm256_xor_ps(a, _mm256_set1_ps(-0.0))
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn abs(a: __m256) -> __m256 {
    _mm256_andnot_ps(_mm256_set1_ps(-0.0), a)
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn lt(a: __m256, b: __m256) -> __m256 {
    _mm256_cmp_ps::<_CMP_LT_OQ>(a, b)
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn le(a: __m256, b: __m256) -> __m256 {
    _mm256_cmp_ps::<_CMP_LE_OQ>(a, b)
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn select(mask: __m256, yes: __m256, no: __m256) -> __m256 {
    _mm256_blendv_ps(no, yes, mask)
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn power_of_two(a: __m256) -> __m256 {
    _mm256_and_ps(a, _mm256_set1_ps(f32::INFINITY))
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn bits(a: __m256) -> __m256 {
    _mm256_cvtepi32_ps(_mm256_castps_si256(a))
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn float_of_bits(a: __m256) -> __m256 {
    _mm256_castsi256_ps(_mm256_cvttps_epi32(a))
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn not(a: __m256) -> __m256 {
    _mm256_xor_ps(a, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn any(a: __m256) -> bool {
    _mm256_movemask_ps(a) != 0
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn all(a: __m256) -> bool {
    _mm256_movemask_ps(a) == 0xff
}
