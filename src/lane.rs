//! The one number type of the kernels: a scalar, a packet of scalars, or a node of somebody else's expression
//! graph. Every kernel is generic over [`Lane`] and so exists once.
//!
//! Three rules keep all executions equal to the bit:
//! - [`Lane::fma`] rounds once in every lane; `a * b + c` rounds twice in every lane (Rust never contracts).
//! - A choice is a [`Lane::select`], or a [`branch!`] where skipping the other side is worth it: a real branch for a
//!   scalar, an any/all test for a packet, when recording a conditional for a long side and a select for a short one.
//! - Elementary functions are built from the operations below (`math.rs`), never taken from a platform.

pub(crate) mod packet;
pub(crate) mod recorded;
mod scalar;

use crate::fits::Fits;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A literal that meets a lane: `lit(1.0) - x` and `x * lit(0.5)` need no type annotation.
///
/// ```
/// use spherecap::{lit, Lane, Lit};
///
/// const HALF: Lit = lit(0.5);
/// fn mean<L: Lane>(x: L, y: L) -> L {
///     HALF * (x + y)
/// }
/// assert_eq!((mean(1.0_f32, 2.0), mean(1.0_f64, 2.0)), (1.5, 1.5));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Lit(pub f64);

/// Makes a literal. In single precision it is rounded to nearest once, when it meets a lane.
///
/// ```
/// use spherecap::{lit, Lane};
///
/// fn one_minus<L: Lane>(x: L) -> L {
///     lit(1.0) - x
/// }
/// assert_eq!((one_minus(0.25_f32), one_minus(0.25_f64)), (0.75, 0.75));
/// ```
#[inline(always)]
pub const fn lit(value: f64) -> Lit {
    Lit(value)
}

macro_rules! lit_operators {
    ($($op:ident $method:ident),*) => {$(
        impl<L: Lane> $op<L> for Lit {
            type Output = L;
            #[inline(always)]
            fn $method(self, rhs: L) -> L {
                L::lit(self.0).$method(rhs)
            }
        }
    )*};
}
lit_operators!(Add add, Sub sub, Mul mul, Div div);

/// One truth value per lane.
///
/// ```
/// use spherecap::{Lane, Mask};
///
/// fn is_in_unit_interval<L: Lane>(x: L) -> L::Mask {
///     L::lit(0.0).le(x) & !L::lit(1.0).lt(x)
/// }
/// // A scalar has one truth value; of a packet, some may be true and others not.
/// assert!(is_in_unit_interval(0.5_f32).all());
/// assert!(!is_in_unit_interval(f32::INFINITY).any());
/// ```
pub trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// Whether some lane may be true. A recorded mask answers `true` unless it is the constant `false`.
    fn any(self) -> bool;
    /// Whether all lanes are known to be true. A recorded mask answers `false` unless it is the constant `true`.
    fn all(self) -> bool;
    /// Tells a recording that what follows matters only where the mask is this.
    #[doc(hidden)]
    #[inline(always)]
    fn begin_side(self, _: bool) {}
    /// Tells it where that ends.
    #[doc(hidden)]
    #[inline(always)]
    fn end_side(self) {}
}

/// What can be chosen lane by lane: lanes, and vectors, tuples and arrays of them.
///
/// ```
/// use spherecap::{Blend, Lane, Vec3};
///
/// fn facing<L: Lane>(normal: Vec3<L>, direction: Vec3<L>) -> Vec3<L> {
///     let is_behind = normal.dot(direction).lt(L::lit(0.0));
///     Blend::blend(is_behind, normal * L::lit(-1.0), normal)
/// }
/// let down = Vec3::new(0.0_f32, 0.0, -1.0);
/// assert_eq!(facing(Vec3::new(0.0, 0.0, 1.0), down), down);
/// // Where no lane takes a side, it need not be computed: anything will do for it.
/// assert_eq!(Blend::blend(true, down, Vec3::blank()), down);
/// ```
pub trait Blend<M>: Copy {
    /// A value for the side that no lane takes.
    fn blank() -> Self;
    /// `yes` where the mask is true, `no` elsewhere.
    fn blend(mask: M, yes: Self, no: Self) -> Self;
}

/// What only the lanes that took the first side of a [`branch!`] will read: in the others it may hold anything, and no
/// select is spent on them.
#[derive(Clone, Copy)]
pub(crate) struct Only<T>(pub T);

impl<M, T: Blend<M>> Blend<M> for Only<T> {
    #[inline(always)]
    fn blank() -> Self {
        Self(T::blank())
    }
    #[inline(always)]
    fn blend(_: M, yes: Self, _: Self) -> Self {
        yes
    }
}

/// An arithmetic type that the kernels run on; see the module's text for its rules.
///
/// ```
/// use spherecap::{lit, Lane};
///
/// /// The larger solution of `x^2 - 2 p x + q = 0` where there is one, without cancellation where p is negative.
/// fn larger_solution<L: Lane>(p: L, q: L) -> L {
///     let root = p.fma(p, -q).max(L::lit(0.0)).sqrt();
///     let far = p.abs() + root;
///     L::select(p.lt(L::lit(0.0)), -q / far, far)
/// }
/// assert_eq!((larger_solution(2.0_f32, 3.0), larger_solution(-2.0_f64, 3.0)), (3.0, -1.0));
///
/// /// The exponent of a normal number, and the power of an exponent that the type has.
/// fn exponent<L: Lane>(x: L) -> L {
///     x.power_of_two().bits() / lit(f64::from(L::SIGNIFICAND_BITS).exp2()) - lit(f64::from(L::EXPONENT_BIAS))
/// }
/// fn power<L: Lane>(exponent: L) -> L {
///     let bias = L::lit(f64::from(L::EXPONENT_BIAS));
///     let biased = (exponent + bias).min(bias + bias);
///     (biased * lit(f64::from(L::SIGNIFICAND_BITS).exp2())).float_of_bits()
/// }
/// assert_eq!((exponent(-9.5_f32), power(3.0_f64)), (3.0, 8.0));
/// ```
pub trait Lane:
    Copy
    + Blend<Self::Mask>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<Lit, Output = Self>
    + Sub<Lit, Output = Self>
    + Mul<Lit, Output = Self>
    + Div<Lit, Output = Self>
{
    /// What a comparison gives.
    type Mask: Mask;

    /// Whether what follows a long choice is written once for each of its sides, as for `f32`, which takes one of them (a mask is
    /// true or false) and need not come back, or once for both, as for packets and recordings, which may take both. The results
    /// are the same.
    const FORKS: bool;

    /// The polynomials fitted for this precision.
    const FITS: Fits;
    /// Stored bits of the significand: 23 or 52.
    const SIGNIFICAND_BITS: i32;
    /// Exponent bias: 127 or 1023.
    const EXPONENT_BIAS: i32;
    /// Distance from 1 to the next number: `2^-SIGNIFICAND_BITS`.
    const EPSILON: f64;
    /// Smallest positive normal number.
    const MIN_POSITIVE: f64;
    /// Largest finite number.
    const MAX: f64;

    /// The lane with this value everywhere, rounded to nearest.
    fn lit(value: f64) -> Self;
    /// `self * factor + addend`, rounded once.
    fn fma(self, factor: Self, addend: Self) -> Self;
    /// The same number, with the word that its last operation's rounding counts: what runs or prints a recording of it must not fuse
    /// that operation with another, or reorder it, even where it may with others. A product that such a sum adds says so, too.
    #[doc(hidden)]
    #[inline(always)]
    fn rounded(self) -> Self {
        self
    }
    /// The same number, with what it is called where a recording of it is printed.
    #[doc(hidden)]
    #[inline(always)]
    fn named(self, _: &'static str) -> Self {
        self
    }
    /// Square root, correctly rounded; NaN below zero.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// `if self < other { self } else { other }`: `other` where either is NaN.
    fn min(self, other: Self) -> Self;
    /// `if self > other { self } else { other }`: `other` where either is NaN.
    fn max(self, other: Self) -> Self;
    /// `self < other`, false where either is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`, false where either is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// `yes` where the mask is true, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The largest power of two that is not above the absolute value: the number without its sign and its significand. 0 for
    /// subnormal numbers, infinity for NaN.
    fn power_of_two(self) -> Self;
    /// The bit pattern, read as a signed integer and converted to the nearest number of this type.
    fn bits(self) -> Self;
    /// The inverse of [`Lane::bits`]: a number in [0, 2^31) (f64: 2^63), truncated, becomes a bit pattern. Every other number becomes
    /// any.
    fn float_of_bits(self) -> Self;
}

/// Evaluates only the sides that some lane needs: `branch!(mask, if_true, if_false)`. A recording evaluates both, and marks
/// them.
///
/// A macro and not a function of closures, because a closure that is not inlined is compiled without its caller's
/// target features. Do not `return` or use `?` inside a side.
macro_rules! branch {
    ($mask:expr, $yes:expr, $no:expr) => {{
        let mask = $mask;
        let (any, all) = ($crate::lane::Mask::any(mask), $crate::lane::Mask::all(mask));
        let yes = if any {
            $crate::lane::Mask::begin_side(mask, true);
            let yes = $yes;
            $crate::lane::Mask::end_side(mask);
            yes
        } else {
            $crate::lane::Blend::blank()
        };
        if all {
            yes
        } else {
            $crate::lane::Mask::begin_side(mask, false);
            let no = $no;
            $crate::lane::Mask::end_side(mask);
            if any {
                $crate::lane::Blend::blend(mask, yes, no)
            } else {
                no
            }
        }
    }};
}
pub(crate) use branch;

/// [`Blend`] of a struct of lanes, or of what else can be blended: field by field. `only` are those that nobody reads but lanes
/// that took the first side, `otherwise` those of the second: no select is spent on them.
macro_rules! blend_fields {
    ($name:ident { $($field:ident),* $(; only $($own:ident),* $(; otherwise $($other:ident),*)?)? }) => {
        impl<M: Copy, L: $crate::lane::Blend<M>> $crate::lane::Blend<M> for $name<L> {
            #[inline(always)]
            fn blank() -> Self {
                use $crate::lane::Blend;
                Self { $($field: Blend::blank(),)* $($($own: Blend::blank(),)* $($($other: Blend::blank()),*)?)? }
            }
            #[inline(always)]
            fn blend(mask: M, yes: Self, no: Self) -> Self {
                use $crate::lane::Blend;
                Self {
                    $($field: Blend::blend(mask, yes.$field, no.$field),)*
                    $($($own: yes.$own,)* $($($other: no.$other),*)?)?
                }
            }
        }
    };
}
pub(crate) use blend_fields;

/// What is the same in every lane.
pub(crate) trait Broadcast {
    /// The same of another lane.
    type Of<L: Lane>;
    /// Its numbers in every lane.
    fn broadcast<L: Lane>(self) -> Self::Of<L>;
}

impl Broadcast for f32 {
    type Of<L: Lane> = L;
    #[inline(always)]
    fn broadcast<L: Lane>(self) -> L {
        L::lit(f64::from(self))
    }
}

impl<const N: usize> Broadcast for [f32; N] {
    type Of<L: Lane> = [L; N];
    #[inline(always)]
    fn broadcast<L: Lane>(self) -> [L; N] {
        // Not by a closure, which might not be inlined.
        let mut lanes = [L::lit(0.0); N];
        for (lane, number) in lanes.iter_mut().zip(self) {
            *lane = number.broadcast();
        }
        lanes
    }
}

/// [`Broadcast`] of a struct of lanes, field by field; the fields after `same` are not of lanes.
macro_rules! broadcast_fields {
    ($name:ident { $($field:ident),* $(; same $($same:ident),*)? }) => {
        impl $crate::lane::Broadcast for $name<f32> {
            type Of<L: $crate::lane::Lane> = $name<L>;
            #[inline(always)]
            fn broadcast<L: $crate::lane::Lane>(self) -> $name<L> {
                $name { $($field: self.$field.broadcast(),)* $($($same: self.$same),*)? }
            }
        }
    };
}
pub(crate) use broadcast_fields;

/// As [`branch!`], and then what is done with the result: `fork!(Lane, mask, if_true, if_false, result => then)`. Where the lane
/// [forks](Lane::FORKS), `then` is written on both sides.
macro_rules! fork {
    ($lane:ty, $mask:expr, $yes:expr, $no:expr, $result:pat => $then:expr) => {
        if !<$lane as $crate::lane::Lane>::FORKS {
            let $result = $crate::lane::branch!($mask, $yes, $no);
            $then
        } else if $crate::lane::Mask::all($mask) {
            let $result = $yes;
            $then
        } else {
            let $result = $no;
            $then
        }
    };
}
pub(crate) use fork;

/// Writes something twice where the lane [forks](Lane::FORKS), for a mask that is true and for one that is false: `knowing!(Lane,
/// mask => then)`. What `then` decides by that variable costs nothing then.
macro_rules! knowing {
    ($lane:ty, $mask:ident => $then:expr) => {{
        let zero = <$lane as $crate::lane::Lane>::lit(0.0);
        if !<$lane as $crate::lane::Lane>::FORKS {
            $then
        } else if $crate::lane::Mask::all($mask) {
            let $mask = zero.le(zero);
            $then
        } else {
            let $mask = zero.lt(zero);
            $then
        }
    }};
}
pub(crate) use knowing;

macro_rules! blend_tuples {
    ($($name:ident $index:tt),*) => {
        impl<M: Copy, $($name: Blend<M>),*> Blend<M> for ($($name,)*) {
            #[inline(always)]
            fn blank() -> Self {
                ($($name::blank(),)*)
            }
            #[inline(always)]
            fn blend(mask: M, yes: Self, no: Self) -> Self {
                ($($name::blend(mask, yes.$index, no.$index),)*)
            }
        }
    };
}
blend_tuples!(A 0, B 1);
blend_tuples!(A 0, B 1, C 2);

impl<M: Copy, L: Blend<M>, const N: usize> Blend<M> for [L; N] {
    #[inline(always)]
    fn blank() -> Self {
        [L::blank(); N]
    }
    #[inline(always)]
    fn blend(mask: M, yes: Self, no: Self) -> Self {
        // Not by a closure, which might not be inlined.
        let mut blended = yes;
        for (blended, no) in blended.iter_mut().zip(&no) {
            *blended = L::blend(mask, *blended, *no);
        }
        blended
    }
}
