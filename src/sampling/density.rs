//! A direction to its density.

use super::{bounded, solid_angle, Sampler};
use crate::input::is_unit;
use crate::lane::{branch, Lane};
use crate::offset::Offset;
use crate::sample::Density;
use crate::strategy::{Hemispheres, Technique};
use crate::vec3::Vec3;

impl<L: Lane> Sampler<L> {
    /// Density of the direction with this offset; zero outside the cap, and where the strategy samples nothing. For an
    /// offset that [`Sampler::sample`] returned: the very bits it returned as density.
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// let sample = sampler.sample(0.3, 0.6);
    /// assert_eq!(sampler.pdf(sample.offset), sample.density);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf(&self, offset: Offset<L>) -> Density<L> {
        self.pdf_in_cap(offset).where_true(self.cap.contains(offset))
    }

    /// Density of a unit direction; zero outside the cap, and where it is not of unit length to within
    /// [`UNIT_TOLERANCE`](crate::UNIT_TOLERANCE). To the precision of [`Sampler::offset`]: where you have the offset, ask
    /// [`Sampler::pdf`].
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// // Directions from elsewhere: from a BSDF, say.
    /// assert!(sampler.pdf_direction([0.8, 0.48, 0.36]).solid_angle > 0.0);
    /// assert_eq!(sampler.pdf_direction([0.0, 0.0, 1.0]).solid_angle, 0.0);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf_direction(&self, direction: impl Into<[L; 3]>) -> Density<L> {
        let direction = Vec3::from(direction.into());
        self.pdf(self.offset(direction)).where_true(is_unit(direction))
    }

    /// As [`Sampler::pdf_direction`], for a direction that is known to point at the sphere (a ray has hit it): only the horizon
    /// is tested, so that rounding near the limb does not lose the density.
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// # let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// // For multiple importance sampling: a ray has hit the light in this direction.
    /// let direction = sampler.sample(0.0, 0.5).direction;
    /// assert!(sampler.pdf_on_sphere(direction).solid_angle > 0.0);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf_on_sphere(&self, direction: impl Into<[L; 3]>) -> Density<L> {
        let direction = Vec3::from(direction.into());
        self.pdf_in_cap(self.offset(direction)).where_true(is_unit(direction))
    }

    /// As [`Sampler::pdf`], for an offset that is known to lie in the cap: only the horizon is tested.
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// # let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// let sample = sampler.sample(0.3, 0.6);
    /// assert_eq!(sampler.pdf_in_cap(sample.offset), sample.density);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf_in_cap(&self, offset: Offset<L>) -> Density<L> {
        self.density(self.technique, self.is_mixed(), offset)
    }

    #[inline(always)]
    pub(super) fn density(&self, technique: Technique, is_mixed: L::Mask, offset: Offset<L>) -> Density<L> {
        let largest = L::lit(L::MAX);
        let plain = self.whole.density;
        // Where nothing is sampled there may be no cosine, and the density 0 yet.
        let cosine = offset.cosine.abs().min(largest);
        let plain_projected = || (plain / cosine.max(L::lit(L::MIN_POSITIVE))).min(largest);
        if technique == Technique::SolidAngle {
            return Density { solid_angle: plain, projected_solid_angle: plain_projected() };
        }
        let weight = self.projected_density(technique, offset);
        let (factor, cosine) = match (technique, self.hemispheres) {
            // The weight is the same all over this side: on the other the cosine is 0 instead.
            (Technique::Projected, Hemispheres::Front) => {
                (self.density_above, offset.cosine.max(L::lit(0.0)).min(largest))
            }
            _ => (weight, cosine),
        };
        Density {
            solid_angle: factor.fma(cosine, plain),
            // A division is skipped where there is no part by solid angle.
            projected_solid_angle: branch!(is_mixed, (weight + plain_projected()).min(largest), weight),
        }
    }

    /// What the projected technique adds to the density with respect to projected solid angle.
    #[inline(always)]
    fn projected_density(&self, technique: Technique, offset: Offset<L>) -> L {
        let zero = L::lit(0.0);
        let (above, below) = (zero.lt(offset.cosine), offset.cosine.lt(zero));
        let weight = match self.hemispheres {
            Hemispheres::Front => L::select(above, self.density_above, zero),
            Hemispheres::Both => {
                L::select(above, self.density_above, L::select(below, self.density_below, zero))
            }
        };
        if technique == Technique::Projected {
            return weight;
        }
        let cap = &self.cap;
        let centre_above = zero.lt(cap.elevation_sin);
        let centre_side = (above & centre_above) | (below & !centre_above);
        let is_warped = zero.lt(weight) & cap.crescent.exists() & !centre_side;
        // Beside a crescent so thin that it is hardly a number, the warp has a slope that is none.
        (weight * branch!(is_warped, bounded::relative_density(cap, offset), L::lit(1.0))).min(L::lit(L::MAX))
    }

    /// The largest density within the cap over the smallest, with respect to projected solid angle and above the horizon:
    /// an upper bound, Equation (4) of the paper's supplement for [`Technique::ProjectedBounded`] in case 3, and 1 in every
    /// other case and for [`Technique::Projected`]. The density of [`Technique::SolidAngle`] has no bound: infinity where the
    /// horizon cuts or touches the cap, and the ratio of the extreme cosines elsewhere. Of the technique alone: the
    /// mixtures are not counted.
    #[inline(always)]
    pub fn density_bound(&self) -> L {
        let bound = match self.technique {
            Technique::SolidAngle => solid_angle::density_bound(&self.cap),
            Technique::ProjectedBounded => bounded::density_bound(&self.cap),
            Technique::Projected => L::lit(1.0),
        };
        bound.max(L::lit(1.0))
    }
}
