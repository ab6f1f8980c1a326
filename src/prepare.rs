//! The checked way in for scalars: bad input gets an error that says what to do.

use crate::cap::Cap;
use crate::lane::{branch, lit, Lane};
use crate::math::polynomial;
use crate::offset::Offset;
use crate::sampling::{Sampler, Strategy};
use crate::vec3::Vec3;
use core::{ffi::CStr, fmt};

/// How far the length of a unit vector may be from 1: interpolated and transformed normals are that good, forgotten
/// normalisations are not.
///
/// ```
/// use spherecap::{Refusal, Sampler, Strategy, UNIT_TOLERANCE};
///
/// let prepare = |z| Sampler::<f64>::prepare(Strategy::default(), [0.0, 0.0, z], [0.0, 0.0, 2.0], 1.0);
/// assert!(prepare(1.0 + 0.9 * UNIT_TOLERANCE).is_ok());
/// assert_eq!(prepare(1.0 + 1.1 * UNIT_TOLERANCE).err(), Some(Refusal::Normal));
/// ```
pub const UNIT_TOLERANCE: f64 = 1e-3;

/// Why there is nothing to sample.
///
/// ```
/// use spherecap::{Refusal, Sampler, Strategy};
///
/// let light_at = |z| Sampler::<f32>::prepare(Strategy::default(), [0.0, 0.0, 1.0], [0.0, 0.0, z], 1.0);
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
    /// The normal is neither of unit length nor exactly zero.
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
                c"the normal must have length 1 (to within 0.001), or be exactly (0, 0, 0) on no surface: normalise it"
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
/// use spherecap::{Sampler, Scalar, Strategy};
///
/// fn irradiance<F: Scalar>(height: f64) -> F {
///     let lit = F::lit;
///     let [normal, centre] = [lit(1.0), lit(height)].map(|z| [lit(0.0), lit(0.0), z]);
///     match Sampler::prepare(Strategy::default(), normal, centre, lit(1.0)) {
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

/// Whether a normal is exactly zero, as it is on no surface.
#[inline(always)]
fn is_zero<L: Lane>(v: Vec3<L>) -> L::Mask {
    (v.x.abs() + v.y.abs() + v.z.abs()).le(L::lit(0.0))
}

/// A normal that [`Cap::new`] may be given, from one that is zero or of about unit length.
///
/// Unit vectors of single precision are used as they stand. With a longer or shorter one the cap would contradict itself:
/// a cosine would not be that of its angle.
#[inline(always)]
fn unit_or_zero<L: Lane>(normal: Vec3<L>) -> Vec3<L> {
    let excess = normal.dot(normal) - lit(1.0);
    let is_rounded = excess.abs().le(L::lit(4.0 * f64::from(f32::EPSILON)));
    // (1 + excess)^(-1/2), whose series leaves 5e-12 at the largest excess, 0.002. Zeros stay zeros.
    branch!(is_rounded, normal, { normal * polynomial(excess, &[1.0, -1.0 / 2.0, 3.0 / 8.0, -5.0 / 16.0]) })
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

impl<F: Scalar> Sampler<F> {
    /// Prepares sampling of the sphere with this `centre` (relative to the shading point) and `radius` (same unit of length)
    /// above the surface with this `normal`, or for a point on no surface if the normal is exactly zero.
    ///
    /// # Errors
    /// A [`Refusal`], also for valid input with nothing to sample.
    ///
    /// ```
    /// use spherecap::{Hemispheres, Sampler, Strategy, Technique};
    ///
    /// let strategy = Strategy { technique: Technique::Projected, hemispheres: Hemispheres::Both, defensive: 0.125 };
    /// let sampler = Sampler::<f32>::prepare(strategy, [0.0, 0.0, 1.0], [3.0, 0.0, -0.5], 1.0)?;
    /// assert!(sampler.sample(0.5, 0.5).density.solid_angle > 0.0);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn prepare(
        strategy: Strategy<F>,
        normal: impl Into<Vec3<F>>,
        centre: impl Into<Vec3<F>>,
        radius: F,
    ) -> Result<Self, Refusal> {
        let (normal, centre) = (normal.into(), centre.into());
        let (sampler, is_possible) = Self::prepare_where_possible(strategy, normal, centre, radius);
        if is_possible {
            Ok(sampler)
        } else {
            Err(refusal(strategy.defensive, normal, centre, radius, sampler.cap()))
        }
    }
}

/// Why a preparation was not possible; `cap` is what [`Cap::new`] made of the input.
#[inline(always)]
pub(crate) fn refusal<F: Scalar>(
    defensive: F,
    normal: Vec3<F>,
    centre: Vec3<F>,
    radius: F,
    cap: &Cap<F>,
) -> Refusal {
    let (zero, largest) = (F::lit(0.0), F::lit(F::MAX));
    // The squares of lengths may overflow where the length does not.
    let longest = centre.x.abs().max(centre.y.abs()).max(centre.z.abs());
    let relative = Vec3::new(centre.x / longest, centre.y / longest, centre.z / longest);
    let distance = longest * relative.dot(relative).sqrt();
    if !is_fraction(defensive) {
        Refusal::Defensive
    } else if !(is_zero(normal) || is_unit(normal)) {
        Refusal::Normal
    } else if !(zero < radius && radius <= largest) {
        Refusal::Radius
    } else if !(zero < distance && distance <= largest) {
        Refusal::Centre
    } else if cap.is_inside() {
        Refusal::Inside
    } else {
        Refusal::Invisible
    }
}

impl<L: Lane> Sampler<L> {
    /// [`Sampler::prepare`] for any lane: the mask says where it would succeed. Elsewhere, nothing about the sampler holds.
    ///
    /// Fewer tests than there are refusals: a point inside, and a radius or a centre that is not finite, leave nothing to
    /// sample or no distance.
    #[inline(always)]
    pub(crate) fn prepare_where_possible(
        strategy: Strategy<L>,
        normal: Vec3<L>,
        centre: Vec3<L>,
        radius: L,
    ) -> (Self, L::Mask) {
        let is_valid =
            is_fraction(strategy.defensive) & (is_zero(normal) | is_unit(normal)) & L::lit(0.0).lt(radius);
        let cap = Cap::new(unit_or_zero(normal), centre, radius);
        let is_near = cap.distance().le(L::lit(L::MAX));
        let sampler = Self::new(cap, strategy);
        (sampler, is_valid & is_near & !sampler.is_empty())
    }
}
