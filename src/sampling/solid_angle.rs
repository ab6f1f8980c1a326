//! Uniform in solid angle over the whole cap, the part below the horizon included.
//!
//! The equal-area projection of the cap onto a disk (Lambert's): a point at radius rho of the unit disk goes to the
//! angle with `1 - cos = (1 - v) rho^2`, hence `sin = rho sqrt((1 - v)(2 - (1 - v) rho^2))`, with `1 - v = s^2 / (1 + v)`.

use crate::cap::Cap;
use crate::disk::{disk_to_square, DiskPoint};
use crate::lane::{blend_fields, broadcast_fields, lit, Lane};
use crate::offset::Offset;
use core::f64::consts::PI;

/// The cap by solid angle.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(super) struct Whole<L> {
    /// `1 - v`: the cap's height; 0 where nothing is visible.
    height: L,
    /// The density of this part, with respect to solid angle: its share of all samples over the solid angle; 0 likewise.
    pub density: L,
}
blend_fields!(Whole { height, density });
broadcast_fields!(Whole { height, density });

impl<L: Lane> Whole<L> {
    /// With this share of the samples.
    #[inline(always)]
    pub(super) fn new(cap: &Cap<L>, share: L) -> Self {
        let (zero, height) = (L::lit(0.0), cap.height());
        let inv_solid_angle = L::select(zero.lt(height), lit(0.5 / PI) / height, zero);
        Self { height, density: share * inv_solid_angle }
    }

    /// For samplers that never use it.
    #[inline(always)]
    pub(super) fn unused() -> Self {
        Self { height: L::lit(0.0), density: L::lit(0.0) }
    }

    /// The direction for a point of the unit disk: its component towards the centre, and its offset.
    #[inline(always)]
    pub(super) fn place(&self, cap: &Cap<L>, point: DiskPoint<L>) -> (L, Offset<L>) {
        // `(1 - v) rho^2`, by `1 - rho^2 = (1 - x^2)(1 - across^2)`.
        let depth = self.height * (lit(1.0) - point.chord2 * point.across_complement);
        let root = (self.height * (lit(2.0) - depth)).sqrt();
        let zenith = (point.from_edge - lit(1.0)) * root;
        let side = point.chord * point.across * root;
        let centre = lit(1.0) - depth;
        (centre, Offset { zenith, side, cosine: cap.cosine(centre, zenith) })
    }

    #[inline(always)]
    pub(super) fn invert(&self, cap: &Cap<L>, offset: Offset<L>) -> [L; 2] {
        let sin2 = offset.sin2();
        let depth = sin2 / (lit(1.0) + cap.centre_component(offset));
        let per_scale = lit(1.0) / (self.height * (lit(2.0) - depth)).sqrt();
        let from_edge = offset.zenith.fma(per_scale, L::lit(1.0));
        disk_to_square(from_edge, offset.side * per_scale, L::lit(0.0))
    }
}

/// The largest cosine in the cap over the smallest; infinity where that is not positive.
#[inline(always)]
pub(super) fn density_bound<L: Lane>(cap: &Cap<L>) -> L {
    let (s, v, x, z) = (cap.radius_sin, cap.radius_cos, cap.elevation_cos, cap.elevation_sin);
    let top = L::select(x.lt(s), L::lit(1.0), z.fma(v, x * s));
    let is_above = cap.rise.lt(L::lit(0.0)) & L::lit(0.0).lt(z);
    L::select(is_above, -top / cap.rise, L::lit(f64::INFINITY))
}
