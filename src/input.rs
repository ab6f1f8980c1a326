//! What a sampler is made of, and what may be wrong with it: bad input gets an error that says what to do.

use crate::cap::{Cap, View};
use crate::lane::{branch, lit, Lane, Mask};
use crate::math::power_of_two_near;
use crate::offset::Offset;
use crate::prepare::Scalar;
use crate::strategy::{Receiver, Strategy};
use crate::vec3::Vec3;
use core::{ffi::CStr, fmt};

/// A sphere as seen from a point. Every way into the kernels makes one of what it is given: Rust, C, batches, recordings.
#[derive(Clone, Copy)]
pub(crate) struct Input<L> {
    /// What receives the light, at the point.
    pub receiver: Receiver<L>,
    /// The sphere's centre, relative to the point, and its radius, in one unit of length.
    pub centre: Vec3<L>,
    pub radius: L,
}

impl<L: Lane> Input<L> {
    /// From the numbers that batches have for each point: normal, centre, radius.
    #[inline(always)]
    pub(crate) fn new(strategy: Strategy<L>, [nx, ny, nz, cx, cy, cz, radius]: [L; 7]) -> Self {
        let receiver = Receiver { normal: Vec3::new(nx, ny, nz), strategy };
        Self { receiver, centre: Vec3::new(cx, cy, cz), radius }
    }

    /// What is seen of the sphere, and where the input is valid.
    ///
    /// Fewer tests than there are refusals: a point inside, and a radius or a centre that is not finite, leave nothing to
    /// sample or no distance.
    #[inline(always)]
    pub(crate) fn view(&self) -> (View<L>, L::Mask) {
        let unit = unit_or_zero(self.receiver.normal);
        // False for NaN.
        let has_length = unit.dot(unit).le(L::lit(2.0));
        let is_valid =
            is_fraction(self.receiver.strategy.defensive) & has_length & L::lit(0.0).lt(self.radius);
        (View::new(unit, self.centre, self.radius), is_valid)
    }

    /// Where it is bad, other than valid input with nothing to sample; `distance` is the cap's.
    #[inline(always)]
    pub(crate) fn is_bad(&self, distance: L) -> L::Mask {
        Faults::of(self, distance).any()
    }
}

impl<F: Scalar> Input<F> {
    /// Why there is nothing to sample; `distance` is the cap's.
    #[cold]
    pub(crate) fn refusal(&self, distance: F) -> Refusal {
        let faults = Faults::of(self, distance);
        if faults.defensive {
            Refusal::Defensive
        } else if faults.normal {
            Refusal::Normal
        } else if faults.radius {
            Refusal::Radius
        } else if faults.centre {
            Refusal::Centre
        } else if Cap::new([F::lit(0.0); 3], self.centre, self.radius).is_inside() {
            Refusal::Inside
        } else {
            Refusal::Invisible
        }
    }
}

/// What is wrong with input, each a mask.
struct Faults<M> {
    defensive: M,
    normal: M,
    radius: M,
    centre: M,
}

impl<M: Mask> Faults<M> {
    #[inline(always)]
    fn of<L: Lane<Mask = M>>(input: &Input<L>, distance: L) -> Self {
        let Input { receiver, centre, radius } = input;
        let (zero, largest) = (L::lit(0.0), L::lit(L::MAX));
        let is_away = zero.lt(centre.x.abs() + centre.y.abs() + centre.z.abs());
        Self {
            defensive: !is_fraction(receiver.strategy.defensive),
            normal: !is_finite(receiver.normal),
            radius: !(zero.lt(*radius) & radius.le(largest)),
            centre: !(is_away & distance.le(largest)),
        }
    }

    #[inline(always)]
    fn any(self) -> M {
        self.defensive | self.normal | self.radius | self.centre
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
