//! Sampling a cap: one prepared [`Sampler`], three techniques, two mixtures.
//!
//! A technique is a map from the unit square onto directions, with its density and its inverse. Everything that decides
//! anything is decided once, in [`Sampler::new`]; sample, pdf and invert read it.
//!
//! | part of the cap | file | used by |
//! |---|---|---|
//! | the whole cap, by solid angle | `solid_angle.rs` | `SolidAngle`, and the defensive part of the others |
//! | case 1, and case 2 without its crescent: an ellipse | `ellipse.rs` | `ProjectedBounded`, `Projected` |
//! | the crescent, uniformly | `crescent.rs` | `Projected` |
//! | the crescent, by the paper's warp | `bounded.rs` | `ProjectedBounded` |
//!
//! What chooses among them is a `Split`. `forward.rs` goes from random numbers to a direction, `density.rs` from there to its density,
//! `inverse.rs` back.

mod bounded;
mod crescent;
mod density;
mod ellipse;
mod forward;
mod inverse;
mod solid_angle;
mod split;

use crate::cap::{Cap, Case, Cut, View};
use crate::lane::{blend_fields, branch, broadcast_fields, Blend, Lane};
use crate::offset::Offset;
use crate::strategy::{Hemispheres, Strategy, Technique};
use crate::vec3::Vec3;
use split::Split;

pub use bounded::density_bound_for_radius;

/// A cap prepared for sampling with one [`Strategy`]. Plain data.
///
/// ```
/// use spherecap::{Receiver, Sampler};
///
/// let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
/// // Every sample estimates the same irradiance: there is no noise.
/// for i in 0..4 {
///     let sample = sampler.sample(0.25 * i as f32 + 0.1, 0.3);
///     let irradiance = sample.offset.cosine / sample.density.solid_angle;
///     assert!((irradiance / sampler.cap().projected_solid_angle() - 1.0).abs() < 1e-5);
/// }
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Sampler<L> {
    pub(crate) technique: Technique,
    pub(crate) hemispheres: Hemispheres,
    cap: Cap<L>,
    /// The share of samples by solid angle: 0 or 1 where only one part exists.
    defensive: L,
    /// The fraction that was asked for: where it is 0, random numbers choose nothing, so nothing is left over of them.
    requested: L,
    /// The share of the others that is above the horizon.
    above: L,
    /// The densities of those with respect to projected solid angle, above and below; 0 for a side with nothing on it.
    density_above: L,
    density_below: L,
    /// Along the surface towards the centre, or towards the zenith: see [`follows_surface`].
    third_axis: Vec3<L>,
    whole: solid_angle::Whole<L>,
    ellipse: ellipse::Ellipse<L>,
    marginal: crescent::Marginal<L>,
}
broadcast_fields!(Sampler {
    cap, defensive, requested, above, density_above, density_below, third_axis, whole, ellipse, marginal;
    same technique, hemispheres
});

/// A direction that was placed in the cap.
#[derive(Clone, Copy)]
struct Place<L> {
    /// Its components on the sampler's axes but the one sideways.
    along: L,
    up: L,
    /// In the cap's own frame; its `side` is the component sideways.
    offset: Offset<L>,
}
blend_fields!(Place { along, up, offset });

/// Does something with the sampler of a view, and the case that it is: `with_sampler!(Lane, view, strategy, (sampler, case) =>
/// then)`. Scalars do it once for each case, and for solid angles alone.
macro_rules! with_sampler {
    ($lane:ty, $view:expr, $strategy:expr, ($sampler:ident, $case:ident) => $then:expr) => {{
        let view = $view;
        let $crate::cap::Case { is_cut, is_centre_above } = view.case();
        $crate::lane::fork!($lane, is_cut, view.cut(), view.uncut(), cut => {
            $crate::lane::knowing!($lane, is_centre_above => {
                let $case = $crate::cap::Case { is_cut, is_centre_above };
                let (cap, strategy) = ($crate::cap::Cap::of(view, $case, &cut), $strategy);
                let is_alone = cap.has_solid_angle_alone(&strategy);
                $crate::lane::knowing!($lane, is_alone => {
                    let $sampler = Sampler::of(cap, &cut, $case, is_alone, strategy);
                    $then
                })
            })
        })
    }};
}
pub(crate) use with_sampler;

impl<L: Lane> Sampler<L> {
    /// Prepares sampling of the sphere with this `centre` (relative to the shading point) and `radius` (same unit of length), as seen from
    /// a surface with this `normal`: see [`Cap::new`]. [`Sampler::prepare`] checks its input.
    ///
    /// ```
    /// # use spherecap::{Sampler, Strategy};
    /// // Total: where there is nothing to sample, it says so.
    /// let sampler = Sampler::<f32>::new([0.0, 0.0, 1.0], [0.0, 0.0, -2.0], 1.0, Strategy::default());
    /// assert!(sampler.is_empty());
    /// ```
    #[inline(always)]
    pub fn new(
        normal: impl Into<[L; 3]>,
        centre: impl Into<[L; 3]>,
        radius: L,
        strategy: Strategy<L>,
    ) -> Self {
        Self::of_view(View::new(normal.into().into(), centre.into().into(), radius), strategy)
    }

    /// The same, of what is seen.
    #[inline(always)]
    pub(crate) fn of_view(view: View<L>, strategy: Strategy<L>) -> Self {
        with_sampler!(L, view, strategy, (sampler, _case) => sampler)
    }

    /// The same, of a cap of which this is known.
    #[inline(always)]
    pub(crate) fn of(
        cap: Cap<L>,
        cut: &Cut<L>,
        case: Case<L::Mask>,
        is_alone: L::Mask,
        strategy: Strategy<L>,
    ) -> Self {
        let Strategy { technique, hemispheres, defensive } = strategy;
        let (zero, one) = (L::lit(0.0), L::lit(1.0));
        let reciprocal = |area: L| L::select(zero.lt(area), one / area, zero);
        let inv_above = reciprocal(cap.projected_above);
        let inv_below = match hemispheres {
            Hemispheres::Front => zero,
            Hemispheres::Both => reciprocal(cap.projected_below),
        };
        // The centre's side is the ellipse's; the other is the crescent's.
        let Case { is_cut, is_centre_above } = case;
        let (cuts_ellipse, uses_crescent) = match hemispheres {
            Hemispheres::Front => (is_cut & is_centre_above, is_cut & !is_centre_above),
            Hemispheres::Both => (is_cut, is_cut),
        };
        let inv_larger = L::select(is_centre_above, inv_above, inv_below);
        let ellipse = match technique {
            Technique::SolidAngle => ellipse::Ellipse::unused(),
            _ => ellipse::Ellipse::new(&cap, cut, cuts_ellipse, inv_larger),
        };
        let marginal = match technique {
            Technique::Projected => crescent::Marginal::new(cut, uses_crescent),
            _ => crescent::Marginal::unused(),
        };
        let plain_share = L::select(is_alone, one, defensive);
        let whole = match technique {
            Technique::SolidAngle => solid_angle::Whole::new(&cap, one),
            _ => {
                let (new, unused) = (solid_angle::Whole::new, solid_angle::Whole::unused);
                branch!(zero.lt(plain_share), new(&cap, plain_share), unused())
            }
        };
        let third_axis = if follows_surface::<L>(technique) {
            cap.sideways.cross_of_distinct(cap.up)
        } else {
            cap.towards_zenith()
        };
        let rest = Split(plain_share).rest();
        let (above, [density_above, density_below]) = match (technique, hemispheres) {
            (Technique::SolidAngle, _) => (one, [zero; 2]),
            (_, Hemispheres::Front) => (one, [inv_above * rest, zero]),
            // A side with nothing on it (that can be weighed) gets no samples.
            (_, Hemispheres::Both) => {
                let [above, below] = cap.shares(cut);
                let of = |own: L, inv_own: L, inv_other: L| {
                    L::select(zero.lt(inv_other), L::select(zero.lt(inv_own), own, zero), one)
                };
                let [above, below] = [of(above, inv_above, inv_below), of(below, inv_below, inv_above)];
                // Each share to its own precision, however small it is.
                (above, [inv_above * above * rest, inv_below * below * rest])
            }
        };
        Self {
            technique,
            hemispheres,
            cap,
            defensive: plain_share,
            requested: defensive,
            above,
            density_above,
            density_below,
            third_axis,
            whole,
            ellipse,
            marginal,
        }
    }

    /// Whether there is nothing to sample: every density is 0.
    #[inline(always)]
    pub fn is_empty(&self) -> L::Mask {
        !L::lit(0.0).lt(self.density_above + self.density_below + self.whole.density)
    }

    /// Whether there may be a part by solid angle, alone or beside another. To know it spares those lanes much that fork; to the others
    /// a share of 0 says enough.
    #[inline(always)]
    pub(crate) fn is_mixed(&self) -> L::Mask {
        let zero = L::lit(0.0);
        if L::FORKS {
            zero.lt(self.defensive)
        } else {
            zero.le(zero)
        }
    }

    /// The geometry that was prepared.
    #[inline(always)]
    pub fn cap(&self) -> &Cap<L> {
        &self.cap
    }

    /// Offset of a unit direction, to the precision that the direction has: four epsilon (5e-7 in f32) for its components, so
    /// that of a cap with `s = 1e-6` little is left; for the cosine eight and what the limb of a sphere nearly touched adds, four
    /// over `v`. A density by solid angle is as good as that over the cosine. Directions away from the sphere give an offset
    /// outside the cap.
    #[inline(always)]
    pub fn offset(&self, direction: impl Into<[L; 3]>) -> Offset<L> {
        let direction = Vec3::from(direction.into());
        let centre = self.cap.towards_centre.dot(direction);
        let (zenith, side) = (self.cap.towards_zenith().dot(direction), self.cap.sideways.dot(direction));
        let cosine = self.cap.normal.dot(direction);
        // The offset of the direction's mirror image behind the point would be the same.
        let behind = centre.lt(L::lit(0.0));
        let outside = Offset { zenith: L::lit(1.0), side: L::lit(1.0), cosine };
        Offset::blend(behind, outside, Offset { zenith, side, cosine })
    }
}

/// Whether the axes that a sampler puts directions together on are those of the surface (along it towards the centre, and its
/// normal), where the projected techniques find a point. Else they are those of the cap (towards the centre, and towards the
/// zenith), where sampling by solid angle does; and so in double precision, where a normal may be of unit length to single
/// precision only, which must not show in the directions.
#[inline(always)]
fn follows_surface<L: Lane>(technique: Technique) -> bool {
    L::SIGNIFICAND_BITS == 23 && technique != Technique::SolidAngle
}
