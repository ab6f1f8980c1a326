//! The ways in that check their input: for scalars, with an error; for other lanes, with a mask.

use crate::input::{Input, Refusal};
use crate::lane::Lane;
use crate::sample::{Density, Sample};
use crate::sampling::{with_sampler, Sampler};
use crate::strategy::Receiver;
use crate::vec3::Vec3;
use core::fmt;

/// The scalar lanes.
///
/// ```
/// use spherecap::{Receiver, Sampler, Scalar};
///
/// fn irradiance<F: Scalar>(height: f64) -> F {
///     let lit = F::lit;
///     let [normal, centre] = [lit(1.0), lit(height)].map(|z| [lit(0.0), lit(0.0), z]);
///     match Sampler::prepare(Receiver::new(normal), centre, lit(1.0)) {
///         Ok(sampler) => sampler.cap().projected_solid_angle(),
///         Err(_) => lit(0.0),
///     }
/// }
/// assert!((irradiance::<f64>(2.0) - f64::from(irradiance::<f32>(2.0))).abs() < 1e-6);
/// ```
pub trait Scalar: Lane<Mask = bool> + PartialOrd + Into<f64> + fmt::Debug {}
impl Scalar for f32 {}
impl Scalar for f64 {}

impl<F: Scalar> Sampler<F> {
    /// Prepares sampling of the sphere with this `centre` (relative to the shading point) and `radius` (same unit of length) for
    /// what receives its light.
    ///
    /// # Errors
    /// A [`Refusal`], also for valid input with nothing to sample.
    ///
    /// ```
    /// use spherecap::{Hemispheres, Receiver, Sampler, Strategy, Technique};
    ///
    /// let strategy = Strategy { technique: Technique::Projected, hemispheres: Hemispheres::Both, defensive: 0.125 };
    /// let leaf = Receiver { normal: [0.0, 0.0, 1.0].into(), strategy };
    /// let sampler = Sampler::<f32>::prepare(leaf, [3.0, 0.0, -0.5], 1.0)?;
    /// assert!(sampler.sample(0.5, 0.5).density.solid_angle > 0.0);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn prepare(receiver: Receiver<F>, centre: impl Into<[F; 3]>, radius: F) -> Result<Self, Refusal> {
        let input = Input { receiver, centre: centre.into().into(), radius };
        let (sampler, is_possible) = input.prepare();
        if is_possible {
            Ok(sampler)
        } else {
            Err(input.refusal(sampler.cap().distance()))
        }
    }

    /// The sample of a sphere that is sampled once, for the caller who draws one at each point: the bits of [`Sampler::prepare`] and
    /// [`Sampler::sample`], at a smaller cost, since nothing is kept for other samples.
    ///
    /// # Errors
    /// Those of [`Sampler::prepare`].
    ///
    /// ```
    /// use spherecap::{Receiver, Sampler};
    ///
    /// let (floor, centre, radius) = (Receiver::new([0.0, 0.0, 1.0]), [3.0, 0.0, 0.5_f32], 1.0);
    /// let sample = Sampler::sample_once(floor, centre, radius, 0.25, 0.75)?;
    /// assert_eq!(sample, Sampler::prepare(floor, centre, radius)?.sample(0.25, 0.75));
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn sample_once(
        receiver: Receiver<F>,
        centre: impl Into<[F; 3]>,
        radius: F,
        u0: F,
        u1: F,
    ) -> Result<Sample<F>, Refusal> {
        let input = Input { receiver, centre: centre.into().into(), radius };
        let (sample, distance, is_possible) = input.sample([u0, u1]);
        if is_possible {
            Ok(sample)
        } else {
            Err(input.refusal(distance))
        }
    }

    /// The density of a direction towards a sphere for which only this one is asked: the bits of [`Sampler::prepare`] and
    /// [`Sampler::pdf_on_sphere`].
    ///
    /// # Errors
    /// Those of [`Sampler::prepare`].
    ///
    /// ```
    /// use spherecap::{Receiver, Sampler};
    ///
    /// let (floor, centre, radius) = (Receiver::new([0.0, 0.0, 1.0]), [3.0, 0.0, 0.5_f32], 1.0);
    /// let sample = Sampler::sample_once(floor, centre, radius, 0.25, 0.75)?;
    /// let density = Sampler::pdf_once(floor, centre, radius, sample.direction)?;
    /// assert!((density.solid_angle / sample.density.solid_angle - 1.0).abs() < 1e-5);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf_once(
        receiver: Receiver<F>,
        centre: impl Into<[F; 3]>,
        radius: F,
        direction: impl Into<[F; 3]>,
    ) -> Result<Density<F>, Refusal> {
        let input = Input { receiver, centre: centre.into().into(), radius };
        let (density, distance, is_possible) = input.pdf(direction.into().into());
        if is_possible {
            Ok(density)
        } else {
            Err(input.refusal(distance))
        }
    }
}

impl<L: Lane> Input<L> {
    /// [`Sampler::prepare`] for any lane: the mask says where it would succeed. Other lanes are unspecified.
    #[inline(always)]
    pub(crate) fn prepare(&self) -> (Sampler<L>, L::Mask) {
        let (view, is_valid) = self.view();
        let sampler = Sampler::of_view(view, self.receiver.strategy);
        (sampler, is_valid & sampler.is_possible())
    }

    /// [`Sampler::sample_once`] for any lane, with the distance to the centre: the mask says where it would succeed.
    #[inline(always)]
    pub(crate) fn sample(&self, [u0, u1]: [L; 2]) -> (Sample<L>, L, L::Mask) {
        let (view, is_valid) = self.view();
        with_sampler!(L, view, self.receiver.strategy, (sampler, case) => {
            let sample = sampler.sample_case(case, sampler.is_mixed(), u0, u1);
            (sample, sampler.cap().distance(), is_valid & sampler.is_possible())
        })
    }

    /// [`Sampler::pdf_once`] for any lane, likewise.
    #[inline(always)]
    pub(crate) fn pdf(&self, direction: Vec3<L>) -> (Density<L>, L, L::Mask) {
        let (view, is_valid) = self.view();
        with_sampler!(L, view, self.receiver.strategy, (sampler, _case) => {
            (sampler.pdf_on_sphere(direction), sampler.cap().distance(), is_valid & sampler.is_possible())
        })
    }
}

impl<L: Lane> Sampler<L> {
    /// With valid input: whether there is something to sample, at a distance.
    #[inline(always)]
    fn is_possible(&self) -> L::Mask {
        self.cap().distance().le(L::lit(L::MAX)) & !self.is_empty()
    }
}
