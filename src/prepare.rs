//! The checked way in for scalars: bad input gets an error that says what to do.

use crate::cap::{Cap, View};
use crate::lane::{branch, lit, Lane, Mask};
use crate::math::power_of_two_near;
use crate::offset::Offset;
use crate::sampling::{with_sampler, Density, Receiver, Sample, Sampler};
use crate::vec3::Vec3;
use core::{ffi::CStr, fmt};

/// How far the length of a unit direction may be from 1: rounded ones are much better, forgotten normalisations are not.
///
/// ```
/// use spherecap::{Receiver, Sampler, UNIT_TOLERANCE};
///
/// let sampler = Sampler::<f64>::prepare(Receiver::new([0.0, 0.0, 1.0]), [0.0, 0.0, 2.0], 1.0)?;
/// let density = |length| sampler.pdf_on_sphere([0.0, 0.0, length]).solid_angle;
/// assert!(density(1.0 + 0.9 * UNIT_TOLERANCE) > 0.0);
/// assert_eq!(density(1.0 + 1.1 * UNIT_TOLERANCE), 0.0);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
pub const UNIT_TOLERANCE: f64 = 1e-3;

/// Why there is nothing to sample.
///
/// ```
/// use spherecap::{Receiver, Refusal, Sampler};
///
/// let light_at = |z| Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [0.0, 0.0, z], 1.0);
/// assert_eq!(light_at(-2.0).err(), Some(Refusal::Invisible));
/// assert_eq!(light_at(0.5).err(), Some(Refusal::Inside));
/// assert!(light_at(f32::NAN).err().unwrap().to_string().contains("finite"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Refusal {
    /// Valid input, but the sphere is not above the horizon (or looks too small for this precision): it lights nothing.
    Invisible,
    /// Valid input, but the point is inside or on the sphere: an emitter of its outer side lights nothing there.
    Inside,
    /// The defensive fraction is not in [0, 1].
    Defensive,
    /// The normal is not finite.
    Normal,
    /// The centre is not at a finite distance, or is the shading point.
    Centre,
    /// The radius is not a positive finite number.
    Radius,
}

impl Refusal {
    /// The reason in words and what to do, as the C ABI has it.
    pub(crate) const fn message(self) -> &'static CStr {
        match self {
            Self::Invisible => c"the sphere is not above the surface's horizon, so nothing is sampled: add no light",
            Self::Inside => c"the point is inside or on the sphere, so nothing is sampled: add no light",
            Self::Defensive => c"the defensive fraction must be a number in [0, 1]",
            Self::Normal => {
                c"the normal must be finite: of any length on a surface, or exactly (0, 0, 0) on none"
            }
            Self::Centre => {
                c"the centre must be at a finite distance from the shading point, relative to it and different from it"
            }
            Self::Radius => c"the radius must be a positive finite number",
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message().to_str().expect("messages are ASCII"))
    }
}

impl std::error::Error for Refusal {}

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

/// Whether a vector has length 1 to within [`UNIT_TOLERANCE`].
#[inline(always)]
pub(crate) fn is_unit<L: Lane>(v: Vec3<L>) -> L::Mask {
    let length2 = v.dot(v);
    let low = L::lit((1.0 - UNIT_TOLERANCE) * (1.0 - UNIT_TOLERANCE));
    let high = L::lit((1.0 + UNIT_TOLERANCE) * (1.0 + UNIT_TOLERANCE));
    low.le(length2) & length2.le(high)
}

/// A normal that [`Cap::new`] may be given, from one of any length: of length 1, or zero if this is zero; NaN, at least in part,
/// if this is not finite.
///
/// Unit vectors of single precision are used as they stand. With a longer or shorter one the cap would contradict itself:
/// a cosine would not be that of its angle.
#[inline(always)]
pub(crate) fn unit_or_zero<L: Lane>(normal: Vec3<L>) -> Vec3<L> {
    let excess = normal.dot(normal) - lit(1.0);
    let is_rounded = excess.abs().le(L::lit(4.0 * f64::from(f32::EPSILON)));
    branch!(is_rounded, normal, {
        // First by a power of two, so that no square over- or underflows.
        let near_one = normal / power_of_two_near(normal.x.abs() + normal.y.abs() + normal.z.abs());
        // Zeros stay zeros: every other length is at least an epsilon by now.
        near_one / near_one.dot(near_one).sqrt().max(L::lit(L::MIN_POSITIVE))
    })
}

/// Whether the defensive fraction is one.
#[inline(always)]
pub(crate) fn is_fraction<L: Lane>(defensive: L) -> L::Mask {
    L::lit(0.0).le(defensive) & defensive.le(L::lit(1.0))
}

/// Whether an offset may be that of a direction: components of a unit vector.
#[inline(always)]
pub(crate) fn is_offset<L: Lane>(offset: Offset<L>) -> L::Mask {
    let largest = L::lit(1.0 + UNIT_TOLERANCE);
    let Offset { zenith, side, cosine } = offset;
    zenith.abs().le(largest) & side.abs().le(largest) & cosine.abs().le(largest)
}

/// Whether all components are finite.
#[inline(always)]
fn is_finite<L: Lane>(v: Vec3<L>) -> L::Mask {
    let largest = L::lit(L::MAX);
    v.x.abs().le(largest) & v.y.abs().le(largest) & v.z.abs().le(largest)
}

/// What is wrong with input, each a mask.
struct Faults<M> {
    defensive: M,
    normal: M,
    radius: M,
    centre: M,
}

impl<M: Mask> Faults<M> {
    /// Those of what [`Sampler::prepare`] is given; `distance` is what [`Cap::new`] made of it.
    #[inline(always)]
    fn of<L: Lane<Mask = M>>(receiver: &Receiver<L>, centre: Vec3<L>, radius: L, distance: L) -> Self {
        let (zero, largest) = (L::lit(0.0), L::lit(L::MAX));
        let is_away = zero.lt(centre.x.abs() + centre.y.abs() + centre.z.abs());
        Self {
            defensive: !is_fraction(receiver.strategy.defensive),
            normal: !is_finite(receiver.normal),
            radius: !(zero.lt(radius) & radius.le(largest)),
            centre: !(is_away & distance.le(largest)),
        }
    }

    #[inline(always)]
    fn any(self) -> M {
        self.defensive | self.normal | self.radius | self.centre
    }
}

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
        let centre = centre.into().into();
        let (sampler, is_possible) = Self::prepare_where_possible(receiver, centre, radius);
        if is_possible {
            Ok(sampler)
        } else {
            Err(refusal(receiver, centre, radius, sampler.cap().distance()))
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
        let centre = centre.into().into();
        let (sample, distance, is_possible) = Self::sample_where_possible(receiver, centre, radius, [u0, u1]);
        if is_possible {
            Ok(sample)
        } else {
            Err(refusal(receiver, centre, radius, distance))
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
        let (centre, direction) = (centre.into().into(), direction.into().into());
        let (density, distance, is_possible) = Self::pdf_where_possible(receiver, centre, radius, direction);
        if is_possible {
            Ok(density)
        } else {
            Err(refusal(receiver, centre, radius, distance))
        }
    }
}

/// Why a preparation was not possible; `distance` is what [`Cap::new`] made of the input.
#[cold]
pub(crate) fn refusal<F: Scalar>(receiver: Receiver<F>, centre: Vec3<F>, radius: F, distance: F) -> Refusal {
    let faults = Faults::of(&receiver, centre, radius, distance);
    if faults.defensive {
        Refusal::Defensive
    } else if faults.normal {
        Refusal::Normal
    } else if faults.radius {
        Refusal::Radius
    } else if faults.centre {
        Refusal::Centre
    } else if Cap::new([F::lit(0.0); 3], centre, radius).is_inside() {
        Refusal::Inside
    } else {
        Refusal::Invisible
    }
}

/// What is wrong with a receiver, whatever it sees.
#[inline]
pub(crate) fn receiver_refusal<F: Scalar>(receiver: &Receiver<F>) -> Option<Refusal> {
    if !is_fraction(receiver.strategy.defensive) {
        Some(Refusal::Defensive)
    } else if !is_finite(receiver.normal) {
        Some(Refusal::Normal)
    } else {
        None
    }
}

/// Where the input is bad, other than valid input with nothing to sample; `distance` is the cap's.
#[inline(always)]
pub(crate) fn is_bad<L: Lane>(receiver: &Receiver<L>, centre: Vec3<L>, radius: L, distance: L) -> L::Mask {
    Faults::of(receiver, centre, radius, distance).any()
}

impl<L: Lane> Sampler<L> {
    /// [`Sampler::prepare`] for any lane: the mask says where it would succeed. Other lanes are unspecified.
    #[inline(always)]
    pub(crate) fn prepare_where_possible(
        receiver: Receiver<L>,
        centre: Vec3<L>,
        radius: L,
    ) -> (Self, L::Mask) {
        let (view, is_valid) = view_where_valid(&receiver, centre, radius);
        let cut = branch!(view.is_cut(), view.cut(), view.uncut());
        let sampler = Self::new(Cap::of(view, cut), receiver.strategy);
        (sampler, is_valid & sampler.is_possible())
    }

    /// [`Sampler::sample_once`] for any lane, with the distance to the centre: the mask says where it would succeed.
    #[inline(always)]
    pub(crate) fn sample_where_possible(
        receiver: Receiver<L>,
        centre: Vec3<L>,
        radius: L,
        [u0, u1]: [L; 2],
    ) -> (Sample<L>, L, L::Mask) {
        let (view, is_valid) = view_where_valid(&receiver, centre, radius);
        with_sampler!(L, view, receiver.strategy, (sampler, case) => {
            (sampler.sample_case(case, u0, u1), sampler.cap().distance(), is_valid & sampler.is_possible())
        })
    }

    /// [`Sampler::pdf_once`] for any lane, likewise.
    #[inline(always)]
    pub(crate) fn pdf_where_possible(
        receiver: Receiver<L>,
        centre: Vec3<L>,
        radius: L,
        direction: Vec3<L>,
    ) -> (Density<L>, L, L::Mask) {
        let (view, is_valid) = view_where_valid(&receiver, centre, radius);
        with_sampler!(L, view, receiver.strategy, (sampler, _case) => {
            (sampler.pdf_on_sphere(direction), sampler.cap().distance(), is_valid & sampler.is_possible())
        })
    }

    /// With valid input: whether there is something to sample, at a distance.
    #[inline(always)]
    fn is_possible(&self) -> L::Mask {
        self.cap().distance().le(L::lit(L::MAX)) & !self.is_empty()
    }
}

/// What is seen of a sphere, and where the input is valid.
///
/// Fewer tests than there are refusals: a point inside, and a radius or a centre that is not finite, leave nothing to
/// sample or no distance.
#[inline(always)]
fn view_where_valid<L: Lane>(receiver: &Receiver<L>, centre: Vec3<L>, radius: L) -> (View<L>, L::Mask) {
    let unit = unit_or_zero(receiver.normal);
    // False for NaN.
    let has_length = unit.dot(unit).le(L::lit(2.0));
    let is_valid = is_fraction(receiver.strategy.defensive) & has_length & L::lit(0.0).lt(radius);
    (View::new(unit, centre, radius), is_valid)
}
