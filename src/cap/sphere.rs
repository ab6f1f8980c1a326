//! First step: the sphere, in a unit of length in which no square over- or underflows.

use crate::compensated::dot;
use crate::lane::{blend_fields, branch, lit, Lane};
use crate::math::power_of_two_near_reciprocal;
use crate::vec3::Vec3;

/// Distances up to this, and radii down to its reciprocal, need no other unit: the squares of their products with the smallest
/// sine of a zenith angle that is told from 0 (`frame.rs`) are normal numbers.
const MODERATE: f64 = (1 << 20) as f64;

/// Below this share of `d^2` the difference `d^2 - r^2` is compensated. Above, the roundings of `d^2` leave it, and `v^2`, two
/// epsilon over this share; below, they would leave it any number.
const NEAR: f64 = 0.25;

/// A sphere as seen from the origin.
#[derive(Clone, Copy)]
pub(super) struct Sphere<L> {
    pub lengths: Lengths<L>,
    /// `d^2`.
    pub distance2: L,
    /// `d^2 - r^2`, positive outside the sphere.
    pub gap: L,
}

#[derive(Clone, Copy)]
pub(crate) struct Lengths<L> {
    pub centre: Vec3<L>,
    pub radius: L,
    /// Their unit, in the caller's.
    pub unit: L,
}
blend_fields!(Lengths { centre, radius, unit });

impl<L: Lane> Sphere<L> {
    #[inline(always)]
    pub(super) fn new(centre: Vec3<L>, radius: L) -> Self {
        let lengths = Lengths::new(centre, radius);
        let Lengths { centre: c, radius: r, .. } = lengths;
        let distance2 = c.dot(c);
        let gap = (-r).fma(r, distance2);
        let (distance2, gap) = branch!(
            gap.lt(distance2 * lit(NEAR)),
            {
                let distance2 = dot(c, c);
                (distance2.hi, (-r).fma(r, distance2.hi).rounded() + distance2.lo)
            },
            (distance2, gap)
        );
        Self { lengths, distance2, gap }
    }
}

impl<L: Lane> Lengths<L> {
    /// In the caller's unit, where no square over- or underflows in that.
    #[inline(always)]
    pub(crate) fn new(centre: Vec3<L>, radius: L) -> Self {
        let given = Self { centre, radius, unit: L::lit(1.0) };
        let is_moderate =
            centre.dot(centre).lt(L::lit(MODERATE * MODERATE)) & L::lit(1.0 / MODERATE).lt(radius);
        branch!(is_moderate, given, given.scaled())
    }

    /// The same in a unit near the distance: a power of two, so that nothing is rounded.
    #[inline(always)]
    fn scaled(self) -> Self {
        let Self { centre, radius, .. } = self;
        let size = (centre.x.abs() + centre.y.abs()) + (centre.z.abs() + radius);
        let [scale, unit] = power_of_two_near_reciprocal(size);
        Self { centre: centre * scale, radius: radius * scale, unit }
    }
}
