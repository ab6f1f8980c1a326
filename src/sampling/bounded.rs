//! The crescent by the warp of Peters and Dachsbacher 2019: the technique of the paper, whose density in case 3 varies by at
//! most a factor given by Equation (4) of its supplement.
//!
//! A point `d` of the unit disk beyond the chord `x = t_x` is seen on the hemisphere above, where it is at the height
//! `d_z = sqrt(1 - d_x^2 - d_y^2)` in [0, t_y]. Heights are scaled linearly to [0, rise] and widths by `s_y`, so that the slice
//! at each height fills the cap's. The supplement's `s_y` (Section 1) has a factor `t_y - d_z` in numerator and denominator;
//! without it, and with `r_z - c_z = s X + v |Z|` and `s^2 tau^2 = rise (s X + v |Z|) = t_y^2 X^2`, it is
//! `s_y^2 = (1 + w_z / (s X + v |Z|)) / (1 + w_z / rise)`, which is 0/0 nowhere.

use super::crescent::{self, Slice};
use super::split::interior;
use super::Place;
use crate::cap::Cap;
use crate::disk::{power_per_height, shape};
use crate::lane::{branch, lit, Lane};
use crate::offset::Offset;

/// `s_y^2` at the height `cosine` above the horizon, in [1/2, 1].
#[inline(always)]
fn width_scale2<L: Lane>(cap: &Cap<L>, cosine: L) -> L {
    (lit(1.0) + cosine / cap.depth()) / (lit(1.0) + cosine / cap.rise)
}

/// x of the cap's boundary at the height `cosine` above the horizon: `t_x + |Z| z / X`.
#[inline(always)]
fn limb<L: Lane>(cap: &Cap<L>, cosine: L) -> L {
    cap.elevation().fma(cosine, cap.radius_cos) / cap.elevation_cos
}

/// The slice of the cut disk for two random numbers: as in `crescent.rs` for kappa = 0. `v2 = 4 u1 (1 - u1)`; with `is_segment`,
/// `u0` below `share` is what chose it.
#[inline(always)]
pub(super) fn slice<L: Lane>(cap: &Cap<L>, is_segment: L::Mask, share: L, u0: L, v2: L) -> Slice<L> {
    let u0 = branch!(is_segment, interior(u0 / share), u0);
    Slice { u0, m: v2.sqrt(), g2: L::lit(1.0), end: cap.crescent.width }
}

/// The direction for a point of the cut disk, `(1 - h, y, z)` on the hemisphere above it: in the crescent, or (`is_segment`) in the
/// part of the centre's side beyond the chord, which needs no warp.
#[inline(always)]
pub(super) fn place<L: Lane>(cap: &Cap<L>, is_segment: L::Mask, h: L, y: L, z: L) -> Place<L> {
    let c = &cap.crescent;
    let warped_z = z * (cap.rise / c.t_y);
    let scale2 = width_scale2(cap, warped_z);
    let warped_y = y * scale2.sqrt();
    // The warp sends the chord to the limb, and squared distances from it scale by s_y^2. Rounding may leave h above the width.
    let beyond_chord = (c.width - h).max(L::lit(0.0)) * (lit(1.0) - h + c.t_x);
    let limb = limb(cap, warped_z);
    let warped_x = limb.fma(limb, scale2 * beyond_chord).sqrt();
    let warped_h = warped_y.fma(warped_y, warped_z * warped_z) / (lit(1.0) + warped_x);
    let pick = |segment: L, warped: L| L::select(is_segment, segment, warped);
    crescent::place(cap, is_segment, pick(h, warped_h), pick(y, warped_y), pick(z, warped_z))
}

/// A point of the cut disk and where the warp sends it.
struct Warp<L> {
    /// The point of the cut disk.
    d_x: L,
    d_y: L,
    d_z: L,
    /// The offset's own x.
    w_x: L,
    /// `s_y`.
    width: L,
}

/// The warp that leads to an offset in the crescent, on either side of the horizon.
///
/// With `x_l` on the limb at the same height, `d_x^2 - t_x^2 = (w_x^2 - x_l^2) / s_y^2`: next to the sphere, where all four are
/// close to 0, `1 - d_y^2 - d_z^2` would lose them.
#[inline(always)]
fn unwarp<L: Lane>(cap: &Cap<L>, offset: Offset<L>) -> Warp<L> {
    let Offset { zenith, side, cosine } = offset;
    let cosine = cosine.abs();
    let scale2 = width_scale2(cap, cosine);
    let width = scale2.sqrt();
    // As above the horizon: there the zenith of a crescent's offset is positive.
    let above = Offset { zenith: zenith.abs(), side, cosine };
    let limb = limb(cap, cosine);
    // It is at least x_l in the cap, which next to the sphere rounding may hide.
    let w_x = crescent::abscissa(cap, never::<L>(), above).max(limb);
    let t_x = cap.crescent.t_x;
    let d_x = t_x.fma(t_x, (w_x - limb) * (w_x + limb) / scale2).sqrt();
    Warp { d_x, d_y: side / width, d_z: cosine * (cap.crescent.t_y / cap.rise), w_x, width }
}

/// The mask that is false.
#[inline(always)]
fn never<L: Lane>() -> L::Mask {
    L::lit(1.0).lt(L::lit(0.0))
}

/// The density over that of a uniform one: `t_y^2 E w_x / (rise^2 A_D d_x s_y)` with the area `A_D` of the cut disk and
/// `E` of the crescent (Section 2 of the supplement).
#[inline(always)]
pub(super) fn relative_density<L: Lane>(cap: &Cap<L>, offset: Offset<L>) -> L {
    let c = &cap.crescent;
    let Warp { d_x, w_x, width, .. } = unwarp(cap, offset);
    let stretch = c.t_y / cap.rise;
    // The crescent is where the centre is not.
    let area = L::select(L::lit(0.0).lt(cap.elevation_sin), cap.projected_below, cap.projected_above);
    let areas = area / (c.t_y_cubed() * shape(c.t_x));
    stretch * stretch * areas * w_x / (d_x * width)
}

/// The random numbers of [`slice`] and [`place`]: with `is_segment`, `u0` over the share.
#[inline(always)]
pub(super) fn invert<L: Lane>(cap: &Cap<L>, is_segment: L::Mask, offset: Offset<L>) -> [L; 2] {
    let Warp { d_x, d_y, d_z, .. } = unwarp(cap, offset);
    let x = L::select(is_segment, crescent::abscissa(cap, is_segment, offset), d_x);
    let y = L::select(is_segment, offset.side, d_y);
    let z = L::select(is_segment, offset.cosine, d_z);
    let h = y.fma(y, z * z) / (lit(1.0) + x);
    let end = cap.crescent.width;
    let ratio = h * power_per_height(h) / (end * power_per_height(end));
    let radius = y.fma(y, z * z).sqrt();
    [ratio * ratio.sqrt(), (y / radius).fma(L::lit(0.5), L::lit(0.5))]
}

/// Equation (4) of the supplement: largest over smallest density, in case 3; 1 elsewhere. In its terms
/// `(c_x - r_x)/t_x sqrt((r_z - c_z)/r_z)`, with `c_x - r_x = X v + s |Z|` and `(r_z - c_z)/r_z = 1 + e`.
#[inline(always)]
pub(super) fn density_bound<L: Lane>(cap: &Cap<L>) -> L {
    let c = &cap.crescent;
    let reach = cap.elevation_cos.fma(cap.radius_cos, cap.radius_sin * cap.elevation());
    let bound = reach / c.t_x * (lit(1.0) + c.cut).sqrt();
    let is_case_3 = c.exists() & cap.elevation_sin.le(L::lit(0.0));
    L::select(is_case_3, bound, L::lit(1.0))
}

/// The conservative bound of Section 3.4 of the supplement: the largest [`Sampler::density_bound`](crate::Sampler::density_bound) of any cap with this `s = r/d`
/// in (0, 1), and hence of any smaller one. It is sqrt 2 for `s <= 1/2` and below two for `s <= 1/1.094`.
///
/// The bound of the caps with one s, `(X v + s |Z|) X/v sqrt(1 + kappa v / X)`, is sqrt 2 as they set (`kappa -> 1`) and has
/// at most one maximum before (checked on a dense grid in the tests): a golden-section search finds the larger.
///
/// ```
/// use spherecap::density_bound_for_radius;
///
/// assert!((density_bound_for_radius(0.5) - 2.0_f64.sqrt()).abs() < 1e-12);
/// assert!(density_bound_for_radius(1.0 / 1.094) < 2.0);
/// ```
pub fn density_bound_for_radius(s: f64) -> f64 {
    let v = ((1.0 - s) * (1.0 + s)).sqrt();
    let bound = |kappa: f64| {
        let z = kappa * s;
        let x = ((1.0 - z) * (1.0 + z)).sqrt();
        (x * v + s * z) * x / v * (1.0 + kappa * v / x).sqrt()
    };
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut low, mut high) = (0.0, 1.0);
    // The maximum is flat: sqrt(f64::EPSILON) of kappa is all that shows, reached after 38 steps.
    for _ in 0..38 {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if bound(a) < bound(b) {
            low = a;
        } else {
            high = b;
        }
    }
    bound(0.5 * (low + high)).max(2.0_f64.sqrt())
}
