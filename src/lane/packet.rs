//! Packets: as many single-precision numbers as a register of the CPU holds. One file per instruction set; `arrays.rs`
//! runs kernels on them. Lane for lane they give the bits of scalar `f32`.
//!
//! A packet's operations are single instructions only inside functions that are compiled for its instruction set, so
//! everything between such a function and the operations is `inline(always)`. `tests/c_abi.rs` checks that it was inlined.

pub(crate) mod arrays;
#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;

use super::Lane;
#[cfg(target_arch = "x86_64")]
use {
    super::{Blend, Lit, Mask},
    crate::fits::Fits,
    core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub},
};

/// A lane that lies in memory as [`Packet::WIDTH`] numbers.
pub(crate) trait Packet: Lane {
    /// How many numbers it holds.
    const WIDTH: usize;

    /// The numbers at `from`, and zeros in the place of those beyond the first `count`.
    ///
    /// # Safety
    /// `count` is 1 to [`Packet::WIDTH`], and so many numbers can be read at `from`, which may be aligned as one of them.
    unsafe fn load(from: *const f32, count: usize) -> Self;

    /// Stores the first `count`.
    ///
    /// # Safety
    /// `count` is 1 to [`Packet::WIDTH`], and so many numbers can be written at `to`, which may be aligned as one of them.
    unsafe fn store(self, to: *mut f32, count: usize);
}

/// The packet of one, for CPUs without an instruction set of their own here.
impl Packet for f32 {
    const WIDTH: usize = 1;

    #[inline(always)]
    unsafe fn load(from: *const f32, _: usize) -> Self {
        // SAFETY: the caller's promise.
        unsafe { *from }
    }
    #[inline(always)]
    unsafe fn store(self, to: *mut f32, _: usize) {
        // SAFETY: the caller's promise.
        unsafe { *to = self }
    }
}

/// Makes a lane of a register, given the functions (most of them intrinsics) that are its operations.
#[cfg(target_arch = "x86_64")]
macro_rules! packet {
    (
        $packet:ident($register:ty) of $width:literal, $mask:ident($mask_register:ty),
        load: $load:ident, store: $store:ident, set: $set:ident,
        neg: $neg:ident, add: $add:ident, sub: $sub:ident, mul: $mul:ident, div: $div:ident,
        fma: $fma:ident, sqrt: $sqrt:ident, abs: $abs:ident, min: $min:ident, max: $max:ident,
        lt: $lt:ident, le: $le:ident, select: $select:ident,
        power_of_two: $power_of_two:ident, bits: $bits:ident, float_of_bits: $float_of_bits:ident,
        and: $and:ident, or: $or:ident, not: $not:ident, any: $any:ident, all: $all:ident,
    ) => {
        /// Numbers. Made only where the CPU has the instructions: `arrays.rs` sees to that.
        #[derive(Clone, Copy)]
        pub(super) struct $packet($register);

        /// What their comparisons give.
        #[derive(Clone, Copy)]
        pub(super) struct $mask($mask_register);

        packet!(@operators $packet, Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);
        packet!(@operators $mask, BitAnd bitand $and, BitOr bitor $or);
        packet!(@negation $packet, Neg neg $neg);
        packet!(@negation $mask, Not not $not);

        impl Mask for $mask {
            packet!(@function any() -> bool $any);
            packet!(@function all() -> bool $all);
        }

        impl Blend<$mask> for $packet {
            #[inline(always)]
            fn blank() -> Self {
                Self::lit(0.0)
            }
            #[inline(always)]
            fn blend(mask: $mask, yes: Self, no: Self) -> Self {
                Self::select(mask, yes, no)
            }
        }

        impl Lane for $packet {
            type Mask = $mask;
            const FORKS: bool = false;
            const FITS: Fits = <f32 as Lane>::FITS;
            const SIGNIFICAND_BITS: i32 = <f32 as Lane>::SIGNIFICAND_BITS;
            const EXPONENT_BIAS: i32 = <f32 as Lane>::EXPONENT_BIAS;
            const EPSILON: f64 = <f32 as Lane>::EPSILON;
            const MIN_POSITIVE: f64 = <f32 as Lane>::MIN_POSITIVE;
            const MAX: f64 = <f32 as Lane>::MAX;

            #[inline(always)]
            fn lit(value: f64) -> Self {
                // SAFETY: the CPU has the instructions.
                Self(unsafe { $set(value as f32) })
            }
            #[inline(always)]
            fn select(mask: $mask, yes: Self, no: Self) -> Self {
                // SAFETY: the CPU has the instructions.
                Self(unsafe { $select(mask.0, yes.0, no.0) })
            }
            packet!(@function fma(factor, addend) -> Self $fma);
            packet!(@function sqrt() -> Self $sqrt);
            packet!(@function abs() -> Self $abs);
            packet!(@function min(other) -> Self $min);
            packet!(@function max(other) -> Self $max);
            packet!(@function lt(other) -> $mask $lt);
            packet!(@function le(other) -> $mask $le);
            packet!(@function power_of_two() -> Self $power_of_two);
            packet!(@function bits() -> Self $bits);
            packet!(@function float_of_bits() -> Self $float_of_bits);
        }

        impl Packet for $packet {
            const WIDTH: usize = $width;

            #[inline(always)]
            unsafe fn load(from: *const f32, count: usize) -> Self {
                // SAFETY: the caller's promise, and the CPU has the instructions.
                Self(unsafe { $load(from, count) })
            }
            #[inline(always)]
            unsafe fn store(self, to: *mut f32, count: usize) {
                // SAFETY: the caller's promise, and the CPU has the instructions.
                unsafe { $store(to, count, self.0) }
            }
        }
    };
    (@function $name:ident($($operand:ident),*) -> bool $function:ident) => {
        #[inline(always)]
        fn $name(self $(, $operand: Self)*) -> bool {
            // SAFETY: the CPU has the instructions.
            unsafe { $function(self.0 $(, $operand.0)*) }
        }
    };
    (@function $name:ident($($operand:ident),*) -> $result:ident $function:ident) => {
        #[inline(always)]
        fn $name(self $(, $operand: Self)*) -> $result {
            // SAFETY: the CPU has the instructions.
            $result(unsafe { $function(self.0 $(, $operand.0)*) })
        }
    };
    (@operators $type:ident, $($op:ident $method:ident $function:ident),*) => {$(
        impl $op for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: the CPU has the instructions.
                Self(unsafe { $function(self.0, other.0) })
            }
        }
        packet!(@literals $type $op $method);
    )*};
    (@literals $packet:ident BitAnd bitand) => {};
    (@literals $packet:ident BitOr bitor) => {};
    (@literals $packet:ident $op:ident $method:ident) => {
        impl $op<Lit> for $packet {
            type Output = Self;
            #[inline(always)]
            fn $method(self, literal: Lit) -> Self {
                self.$method(Self::lit(literal.0))
            }
        }
    };
    (@negation $type:ident, $op:ident $method:ident $function:ident) => {
        impl $op for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self) -> Self {
                // SAFETY: the CPU has the instructions.
                Self(unsafe { $function(self.0) })
            }
        }
    };
}
#[cfg(target_arch = "x86_64")]
use packet;
