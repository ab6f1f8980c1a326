//! What sampling gives: a direction, where it meets the sphere, and its density.

use crate::lane::Lane;
use crate::offset::Offset;
use crate::vec3::Vec3;

/// A probability density in two measures.
///
/// ```
/// use spherecap::{Density, Receiver, Sampler};
///
/// let sampler = Sampler::<f64>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 0.0, 0.5], 1.0)?;
/// let sample = sampler.sample(0.3, 0.6);
/// let Density { solid_angle, projected_solid_angle } = sample.density;
/// assert!((solid_angle / projected_solid_angle - sample.offset.cosine).abs() < 1e-14);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Density<L> {
    /// With respect to solid angle, per steradian.
    pub solid_angle: L,
    /// With respect to projected solid angle: the same divided by |cosine|, but never infinite.
    pub projected_solid_angle: L,
}

impl<L: Lane> Density<L> {
    /// The same where the mask is true, zero elsewhere.
    #[inline(always)]
    pub(crate) fn where_true(self, mask: L::Mask) -> Self {
        let zero = L::lit(0.0);
        Self {
            solid_angle: L::select(mask, self.solid_angle, zero),
            projected_solid_angle: L::select(mask, self.projected_solid_angle, zero),
        }
    }
}

/// A sampled direction and where it meets the sphere.
///
/// ```
/// use spherecap::{Receiver, Sample, Sampler};
///
/// let (centre, radius) = ([2.0, 0.0, 0.5], 1.0);
/// let sampler = Sampler::<f64>::prepare(Receiver::new([0.0, 0.0, 1.0]), centre, radius)?;
/// let Sample { direction, distance, normal, .. } = sampler.sample(0.3, 0.6);
/// // The point on the light, in two ways.
/// let along_the_ray = direction.x * distance;
/// let on_the_sphere = centre[0] + radius * normal.x;
/// assert!((along_the_ray - on_the_sphere).abs() < 1e-14);
/// // As an array, from which every library of vectors makes its own.
/// let [x, y, z] = direction.into();
/// assert!((x * x + y * y + z * z - 1.0_f64).abs() < 1e-14);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Sample<L> {
    /// The direction in the cap's frame, at full precision.
    pub offset: Offset<L>,
    /// Unit direction from the shading point.
    pub direction: Vec3<L>,
    /// Distance to the sphere's surface along the direction, in the caller's unit of length.
    pub distance: L,
    /// Unit outward normal of the sphere there: centre + radius * normal is the point itself.
    pub normal: Vec3<L>,
    /// Density of the direction, the same bits as [`Sampler::pdf`](crate::Sampler::pdf) of its offset.
    pub density: Density<L>,
}
