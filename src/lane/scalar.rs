//! The scalar lanes `f32` and `f64`: a mask is a `bool`, and a branch is a branch.

use super::{Blend, Lane, Lit, Mask};
use crate::fits::{Fits, DOUBLE, SINGLE};
use core::ops::{Add, Div, Mul, Sub};

impl Mask for bool {
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
}

macro_rules! scalar_lane {
    ($float:ident, $bits:ident, $float_of_bits:ident, $fits:expr, $forks:expr) => {
        scalar_lane!(@operators $float, Add add, Sub sub, Mul mul, Div div);

        impl Blend<bool> for $float {
            #[inline(always)]
            fn blank() -> Self {
                0.0
            }
            #[inline(always)]
            fn blend(mask: bool, yes: Self, no: Self) -> Self {
                Self::select(mask, yes, no)
            }
        }

        impl Lane for $float {
            type Mask = bool;
            const FORKS: bool = $forks;
            const FITS: Fits = $fits;
            const SIGNIFICAND_BITS: i32 = $float::MANTISSA_DIGITS as i32 - 1;
            const EXPONENT_BIAS: i32 = $float::MAX_EXP - 1;
            const EPSILON: f64 = $float::EPSILON as f64;
            const MIN_POSITIVE: f64 = $float::MIN_POSITIVE as f64;
            const MAX: f64 = $float::MAX as f64;

            #[inline(always)]
            fn lit(value: f64) -> Self {
                value as $float
            }
            #[inline(always)]
            fn fma(self, factor: Self, addend: Self) -> Self {
                self.mul_add(factor, addend)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn le(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            #[inline(always)]
            fn power_of_two(self) -> Self {
                $float::from_bits(self.to_bits() & $float::INFINITY.to_bits())
            }
            #[inline(always)]
            fn bits(self) -> Self {
                $bits(self)
            }
            #[inline(always)]
            fn float_of_bits(self) -> Self {
                $float_of_bits(self)
            }
        }
    };
    (@operators $float:ident, $($op:ident $method:ident),*) => {$(
        impl $op<Lit> for $float {
            type Output = $float;
            #[inline(always)]
            fn $method(self, rhs: Lit) -> $float {
                self.$method(<$float as Lane>::lit(rhs.0))
            }
        }
    )*};
}
scalar_lane!(f32, bits_single, float_of_bits_single, SINGLE, true);
// Double precision is for those who check: not at the price of code three times as large.
scalar_lane!(f64, bits_double, float_of_bits_double, DOUBLE, false);

/// [`Lane::bits`] of an `f32`.
#[inline(always)]
fn bits_single(x: f32) -> f32 {
    x.to_bits() as i32 as f32
}

/// [`Lane::float_of_bits`] of an `f32`: where Rust's `as` takes six more instructions to saturate. By vectors: the way through an
/// integer register takes twice as long.
#[inline(always)]
fn float_of_bits_single(x: f32) -> f32 {
    #[cfg(target_arch = "x86_64")]
    {
        use core::arch::x86_64::{_mm_castsi128_ps, _mm_cvtss_f32, _mm_cvttps_epi32, _mm_set1_ps};
        // SAFETY: every x86-64 has SSE2.
        unsafe { _mm_cvtss_f32(_mm_castsi128_ps(_mm_cvttps_epi32(_mm_set1_ps(x)))) }
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        f32::from_bits(x as i32 as u32)
    }
}

/// [`Lane::bits`] of an `f64`.
#[inline(always)]
fn bits_double(x: f64) -> f64 {
    x.to_bits() as i64 as f64
}

/// [`Lane::float_of_bits`] of an `f64`.
#[inline(always)]
fn float_of_bits_double(x: f64) -> f64 {
    #[cfg(target_arch = "x86_64")]
    {
        use core::arch::x86_64::{_mm_cvttsd_si64, _mm_set_sd};
        // SAFETY: every x86-64 has SSE2.
        f64::from_bits(unsafe { _mm_cvttsd_si64(_mm_set_sd(x)) } as u64)
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        f64::from_bits(x as i64 as u64)
    }
}
