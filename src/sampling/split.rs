//! A region in two parts, of which one random number chooses one. Plain or projected, above the horizon or below, crescent or
//! ellipse: a sampler makes all its choices so.

use crate::lane::{branch, lit, Lane};

/// By the probability of the first part, in [0, 1], which is chosen for random numbers below it. What the choice leaves of a number, stretched to the unit interval,
/// is used again in the part: so a stratum of numbers stays one.
#[derive(Clone, Copy)]
pub(super) struct Split<L>(pub L);

impl<L: Lane> Split<L> {
    /// The probability of the second part.
    #[inline(always)]
    pub(super) fn rest(self) -> L {
        lit(1.0) - self.0
    }

    /// Whether a random number chooses the first part.
    #[inline(always)]
    pub(super) fn is_first(self, u: L) -> L::Mask {
        let is_first = u.lt(self.0);
        // Numbers are below 1, but the compiler does not know that; where it knows the share, this decides.
        if L::FORKS {
            L::lit(1.0).le(self.0) | is_first
        } else {
            is_first
        }
    }

    /// What is left of a random number in the part that it chose: off the ends of the unit interval.
    #[inline(always)]
    pub(super) fn left_over(self, u: L, is_first: L::Mask) -> L {
        let (part, whole) = branch!(is_first, (u, self.0), (u - self.0, self.rest()));
        interior(part / whole)
    }

    /// The random numbers that leave `u` in the first part and in the second.
    #[inline(always)]
    pub(super) fn numbers(self, u: L) -> [L; 2] {
        [u * self.0, self.rest().fma(u, self.0)]
    }
}

/// Moves a random number off the ends of \[0, 1\], by less than the spacing of 24-bit random numbers.
#[inline(always)]
pub(super) fn interior<L: Lane>(u: L) -> L {
    let margin = 0.5 * L::EPSILON;
    u.max(L::lit(margin)).min(L::lit(1.0 - margin))
}
