//! Directions in the cap's own frame: `w = a w_d + zenith e_b + side e_c` with `a = sqrt(1 - zenith^2 - side^2)`.

use crate::cap::Cap;
use crate::lane::{blend_fields, lit, Lane};
use crate::vec3::Vec3;

/// A direction in the cap's own frame. Its components keep their relative precision where those of a unit vector drown:
/// in small caps and near the horizon.
///
/// ```
/// use spherecap::{Receiver, Sampler};
///
/// // A light as small as a millionth of its distance: a unit vector in single precision has only some twenty directions
/// // across it, an offset has them all.
/// let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [3.0, 0.0, 4.0], 5e-6)?;
/// let [a, b] = [0.5, 0.500001].map(|u| sampler.sample(0.25, u).offset);
/// assert!(a != b && a.side.abs() <= 1e-6);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Offset<L> {
    /// Component across the direction to the centre, towards the zenith, in \[-1, 1\] (to rounding).
    pub zenith: L,
    /// Component sideways, in \[-1, 1\] (to rounding).
    pub side: L,
    /// Cosine with the surface normal, in \[-1, 1\]; negative below the horizon, 0 without a surface.
    pub cosine: L,
}

impl<L: Lane> Offset<L> {
    /// Squared sine of the angle from the direction to the centre.
    #[inline(always)]
    pub(crate) fn sin2(self) -> L {
        self.zenith.fma(self.zenith, self.side * self.side)
    }
}

impl<L: Lane> Cap<L> {
    /// The cosine with the normal of a direction with these components towards the centre and the zenith. Near the horizon
    /// its error is absolute: a sampled direction brings a better one along.
    #[inline(always)]
    pub(crate) fn cosine(&self, centre: L, zenith: L) -> L {
        self.elevation_sin.fma(centre, self.elevation_cos * zenith) * self.on_surface
    }

    /// The component towards the centre, `a = sqrt(1 - sin^2)`, of an offset in the cap.
    ///
    /// Next to the sphere the limb is at `a = v`, where rounding of the sine leaves the root epsilon / a. There the cosine,
    /// `cosine = Z a + X zenith`, tells it to epsilon / Z. The mean of both, weighted by the squares of their precision, is known to
    /// epsilon / sqrt(a^2 + Z^2).
    #[inline(always)]
    pub(crate) fn centre_component(&self, offset: Offset<L>) -> L {
        let z = self.elevation_sin;
        let a2 = (lit(1.0) - offset.sin2()).max(L::lit(0.0));
        let z_a = (-self.elevation_cos).fma(offset.zenith, offset.cosine);
        a2.fma(a2.sqrt(), z * z_a) / z.fma(z, a2).max(L::lit(L::MIN_POSITIVE))
    }

    /// The unit vector across the direction to the centre, towards the zenith.
    #[inline(always)]
    pub(crate) fn towards_zenith(&self) -> Vec3<L> {
        self.towards_centre.cross_of_distinct(self.sideways)
    }

    /// Whether the offset is in the cap, up to the rounding of `s` and of the offset itself: 2e-6 in single precision (samples
    /// stay within 1e-6), and 1e-14, ten times the error of the fits, in double.
    #[inline(always)]
    pub(crate) fn contains(&self, offset: Offset<L>) -> L::Mask {
        let s = self.radius_sin;
        offset.sin2().le(s * s * L::lit(1.0 + (16.0 * L::EPSILON).max(1e-14)))
    }

    /// The component towards the centre of a direction with this offset, and where it meets the sphere: the distance, in units of
    /// d, and the sphere's normal there, by its components towards the centre, towards the zenith, and sideways.
    ///
    /// With `q = sqrt(s^2 - sin^2)` the sphere is met at `a - q = v^2 / (a + q)`; its normal
    /// `((a - q) w - w_d) / s` has the components `(-(sin^2 + a q), (a - q) zenith, (a - q) side) / s`.
    #[inline(always)]
    pub(crate) fn hit(&self, offset: Offset<L>) -> (L, L, [L; 3]) {
        let (s, v) = (self.radius_sin, self.radius_cos);
        let sin2 = offset.sin2();
        let q2 = s.fma(s, -sin2).max(L::lit(0.0));
        // a^2 = 1 - sin^2 as q^2 + v^2: next to the sphere the vectors keep their unit length.
        let (q, a) = (q2.sqrt(), v.fma(v, q2).sqrt());
        let distance = v * v / (a + q);
        let inv_s = lit(1.0) / s;
        let across = distance * inv_s;
        (a, distance, [-a.fma(q, sin2) * inv_s, across * offset.zenith, across * offset.side])
    }
}

blend_fields!(Offset { zenith, side, cosine });
