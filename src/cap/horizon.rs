//! Third step: how high the centre is above the horizon, and whether the horizon cuts the sphere.

use super::sphere::{Lengths, Sphere};
use crate::compensated::dot;
use crate::lane::Lane;
use crate::vec3::Vec3;

/// Lengths and squares of lengths, in the sphere's unit.
#[derive(Clone, Copy)]
pub(super) struct Horizon<L> {
    /// `z_C = n.C`, the height of the centre: 0 without a surface.
    pub height: L,
    /// `r - |z_C|`, to its own precision: how much of the radius is beyond the horizon.
    pub beyond: L,
    /// `r^2 - z_C^2 = (s^2 - Z^2) d^2`, likewise: where the horizon cuts the sphere, in a circle, that one's squared radius; else not
    /// positive.
    pub circle2: L,
}

impl<L: Lane> Horizon<L> {
    #[inline(always)]
    pub(super) fn new(normal: Vec3<L>, sphere: &Sphere<L>) -> Self {
        let Lengths { centre, radius: r, .. } = sphere.lengths;
        let height = dot(normal, centre).normalised();
        let (below, above) = ((r - height.hi) - height.lo, (r + height.hi) + height.lo);
        Self { height: height.hi, beyond: below.min(above), circle2: below * above }
    }
}
