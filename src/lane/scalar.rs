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
    ($float:ident, $bits:ident, $int:ident, $truncate:ident, $fits:expr, $forks:expr) => {
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
                self.to_bits() as $int as $float
            }
            #[inline(always)]
            fn float_of_bits(self) -> Self {
                <$float>::from_bits($truncate(self) as $bits)
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
scalar_lane!(f32, u32, i32, truncate_single, SINGLE, true);
// Double precision is for those who check: not at the price of code three times as large.
scalar_lane!(f64, u64, i64, truncate_double, DOUBLE, false);

// Rust's `as` takes six more instructions to saturate.
macro_rules! truncate {
    ($name:ident, $float:ident, $int:ident, $set:ident, $convert:ident) => {
        #[inline(always)]
        fn $name(x: $float) -> $int {
            #[cfg(target_arch = "x86_64")]
            {
                use core::arch::x86_64::{$convert, $set};
                // SAFETY: every x86-64 has SSE2.
                unsafe { $convert($set(x)) }
            }
            #[cfg(not(target_arch = "x86_64"))]
            {
                x as $int
            }
        }
    };
}
truncate!(truncate_single, f32, i32, _mm_set_ss, _mm_cvttss_si32);
truncate!(truncate_double, f64, i64, _mm_set_sd, _mm_cvttsd_si64);
