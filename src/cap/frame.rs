//! Second step: which way is sideways.

use super::sphere::{Lengths, Sphere};
use crate::lane::{blend_fields, branch, lit, Blend, Lane};
use crate::vec3::Vec3;

/// Below this `X^2` the vector product of normal and centre is computed as if rounded once. Above, its components' roundings of
/// an epsilon of d turn it by less than eight epsilon.
const NEAR_ZENITH: f64 = 1.0 / 64.0;

/// Below this `X` (in f32) it matters to nothing: any frame does, and X is taken for 0. Above, its square is far from underflow,
/// and the vector product as precise as the input.
const AT_ZENITH2: f64 = (1_u64 << 42) as f64;

/// Which way is up, and which sideways.
#[derive(Clone, Copy)]
pub(super) struct Frame<L> {
    /// The surface's normal or, without a surface, a unit vector perpendicular to the centre.
    pub up: Vec3<L>,
    /// Perpendicular to it and the centre, not normalised.
    pub sideways: Vec3<L>,
    /// Its length.
    pub length: L,
    /// `X d`.
    pub x_d: L,
    /// 1, or 0 without a surface.
    pub on_surface: L,
}
blend_fields!(Frame { up, sideways, length, x_d, on_surface });

impl<L: Lane> Frame<L> {
    #[inline(always)]
    pub(super) fn new(normal: Vec3<L>, sphere: &Sphere<L>) -> Self {
        let Sphere { lengths: Lengths { centre, .. }, distance2, .. } = *sphere;
        // |n x C| is X d.
        let sideways = normal.cross_of_distinct(centre);
        let length2 = sideways.dot(sideways);
        branch!(
            length2.lt(distance2 * lit(NEAR_ZENITH)),
            {
                let sideways = normal.cross(centre);
                let length2 = sideways.dot(sideways);
                // Only here may there be no surface: without a normal the product is 0.
                let on_surface = L::lit(0.0).lt(normal.dot(normal));
                // No branch: this side is rare enough.
                Self::blend(
                    length2.lt(distance2 * lit(L::MIN_POSITIVE * AT_ZENITH2)),
                    Self::at_zenith(normal, on_surface, sphere),
                    Self::beside(normal, sideways, length2),
                )
            },
            Self::beside(normal, sideways, length2)
        )
    }

    #[inline(always)]
    fn beside(up: Vec3<L>, sideways: Vec3<L>, length2: L) -> Self {
        let length = length2.sqrt();
        Self { up, sideways, length, x_d: length, on_surface: L::lit(1.0) }
    }

    /// Where the centre is at the zenith (or straight below), and where there is no surface: then, the cap is as one with its
    /// centre on the horizon.
    #[inline(always)]
    fn at_zenith(normal: Vec3<L>, on_surface: L::Mask, sphere: &Sphere<L>) -> Self {
        let zero = L::lit(0.0);
        let c = sphere.lengths.centre;
        let sideways =
            Vec3::blend(c.x.abs().lt(c.z.abs()), Vec3::new(zero, -c.z, c.y), Vec3::new(-c.y, c.x, zero));
        let length = sideways.dot(sideways).sqrt();
        let d = sphere.distance2.sqrt();
        let across = c.cross_of_distinct(sideways) / (d * length);
        Self {
            up: Vec3::blend(on_surface, normal, across),
            sideways,
            length,
            x_d: L::select(on_surface, zero, d),
            on_surface: L::select(on_surface, L::lit(1.0), zero),
        }
    }
}
