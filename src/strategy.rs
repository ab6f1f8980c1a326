//! What is sampled, and how: the input that a renderer chooses.

use crate::lane::Lane;
use crate::vec3::Vec3;

/// How directions are distributed.
///
/// ```
/// use spherecap::{Receiver, Sampler, Strategy, Technique};
///
/// // How much the weights of a diffuse surface's samples can differ where the horizon cuts a light.
/// let bound = |technique| {
///     let strategy = Strategy { technique, ..Strategy::default() };
///     let receiver = Receiver { normal: [0.0, 0.0, 1.0].into(), strategy };
///     let sampler = Sampler::<f64>::prepare(receiver, [2.0, 0.0, -0.5], 1.0);
///     sampler.map(|sampler| sampler.density_bound())
/// };
/// assert_eq!(bound(Technique::SolidAngle)?, f64::INFINITY);
/// assert!(bound(Technique::ProjectedBounded)? < 2.0);
/// assert_eq!(bound(Technique::Projected)?, 1.0);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Technique {
    /// Uniform in projected solid angle in every case: the density is constant to within 1e-5.
    Projected = 0,
    /// Uniform in projected solid angle where the sphere's centre is above the horizon; below it the warp of Peters and
    /// Dachsbacher 2019, whose density varies by a bounded factor ([`Sampler::density_bound`](crate::Sampler::density_bound)).
    ProjectedBounded = 1,
    /// Uniform in solid angle over the whole cap, also where it is below the horizon: the usual way, and the baseline.
    SolidAngle = 2,
}

/// Which sides of the surface the projected techniques cover.
///
/// ```
/// use spherecap::{Hemispheres, Receiver, Sampler, Strategy};
///
/// let goes_below = |hemispheres| {
///     let strategy = Strategy { hemispheres, ..Strategy::default() };
///     let receiver = Receiver { normal: [0.0, 0.0, 1.0].into(), strategy };
///     let sampler = Sampler::<f32>::prepare(receiver, [2.0, 0.0, 0.1], 1.0);
///     sampler.map(|sampler| (0..8).any(|i| sampler.sample(i as f32 / 8.0, 0.5).offset.cosine < 0.0))
/// };
/// assert_eq!([goes_below(Hemispheres::Front)?, goes_below(Hemispheres::Both)?], [false, true]);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Hemispheres {
    /// Directions above the horizon: for opaque surfaces.
    Front = 0,
    /// Both sides, each sampled in proportion to |cosine|; a side is chosen by its share of the solid angle. For surfaces
    /// that transmit, or whose side is not known.
    Both = 1,
}

/// What a cap is sampled with.
///
/// ```
/// use spherecap::{Strategy, Technique};
///
/// // For shading normals that differ from geometric ones: every weight is at most 8 times that of plain solid angles.
/// let strategy = Strategy { defensive: 0.125_f32, ..Strategy::default() };
/// assert_eq!(strategy.technique, Technique::Projected);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strategy<L> {
    /// How directions are distributed.
    pub technique: Technique,
    /// Which sides of the surface are covered. [`Technique::SolidAngle`] always covers both.
    pub hemispheres: Hemispheres,
    /// Probability, in [0, 1], of sampling by solid angle instead. It bounds every weight by its reciprocal times that of
    /// plain solid-angle sampling, for integrands that are no multiple of the cosine (shading normals).
    pub defensive: L,
}

impl<L: Lane> Default for Strategy<L> {
    fn default() -> Self {
        Self { technique: Technique::Projected, hemispheres: Hemispheres::Front, defensive: L::lit(0.0) }
    }
}

/// What receives the light: a surface, or a point on none, and how its light is sampled. Whoever asks for a density, as
/// multiple importance sampling does, must ask with the receiver that samples: so carry it along.
///
/// ```
/// use spherecap::{Receiver, Sampler, Strategy};
///
/// let floor = Receiver::new([0.0, 0.0, 1.0]);
/// let bumpy_floor = Receiver { strategy: Strategy { defensive: 0.125, ..floor.strategy }, ..floor };
/// // Normals have any length but zero, which says that there is no surface: transformed ones need not be normalised.
/// let stretched = Receiver::new([0.0, 0.0, 7.0_f32]);
/// let sample = |receiver| Sampler::prepare(receiver, [3.0, 0.0, 0.5], 1.0).map(|s| s.sample(0.25, 0.75));
/// assert_eq!(sample(stretched)?, sample(floor)?);
/// assert!(sample(bumpy_floor)? != sample(floor)?);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Receiver<L> {
    /// Normal of the surface on the side to be lit, of any finite length; or exactly zero for a point on no surface, as in a
    /// medium: then sampling is by solid angle. One that is of unit length to single precision is used as it stands.
    pub normal: Vec3<L>,
    /// What its light is sampled with.
    pub strategy: Strategy<L>,
}

impl<L: Lane> Receiver<L> {
    /// One with this normal and the default strategy.
    ///
    /// ```
    /// # use spherecap::{Receiver, Strategy};
    /// let receiver = Receiver::<f64>::new([0.0, 0.6, 0.8]);
    /// assert_eq!(receiver.strategy, Strategy::default());
    /// ```
    #[inline(always)]
    pub fn new(normal: impl Into<[L; 3]>) -> Self {
        Self { normal: normal.into().into(), strategy: Strategy::default() }
    }
}
