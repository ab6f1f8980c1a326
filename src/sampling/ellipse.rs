//! The part of the cap on the centre's side of the horizon: all of it in case 1; in case 2 all but the crescent that lies
//! beyond the chord `x = t_x`. Uniform in projected solid angle. (Sections 1 and 2 of the paper's supplement; coordinates that
//! cancel there are replaced.)
//!
//! Dropped onto the tangent plane the boundary circle is an ellipse with half axes `s Z` and `s`. A point `(xi, eta)` of
//! the unit disk with `xi = 1` at the horizon's end goes to `x = X v + s Z xi`, `y = s eta`. The boundary circle is
//! `s X (e - xi)` above the horizon there, hence `z^2 = (s X (e - xi))^2 + s^2 (1 - xi^2 - eta^2)`: a sum of positives, with
//! `s X (e - xi) = s X (1 - xi) - rise`. The offset towards the zenith, `X z - Z x`, is `X (z - Z v) - s Z^2 xi` with
//! `z - Z v = (s X xi (s X xi - 2 Z v) + s^2 (1 - xi^2 - eta^2)) / (z + Z v)`.

use super::split::{interior, Split};
use super::Place;
use crate::cap::{Cap, Cut};
use crate::disk::{disk_to_square, DiskPoint, PER_AREA};
use crate::lane::{branch, broadcast_fields, lit, Lane};
use crate::offset::Offset;

#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(super) struct Ellipse<L> {
    /// On the centre's side, probability of the crescent beyond the chord `x = t_x`: 0 in case 1.
    pub crescent_share: L,
    /// Reciprocal of the ellipse's share.
    inv_rest: L,
    /// Area of the segment that the horizon cuts off the unit disk, in the units of `disk.rs`.
    pub beyond: L,
    /// `X v` and `s |Z|`: the projected ellipse's middle and half axis, seen from its horizon's end.
    middle: L,
    half_axis: L,
    /// `s X`: the height of the boundary circle's middle over its lower end.
    climb: L,
}
broadcast_fields!(Ellipse { crescent_share, inv_rest, beyond, middle, half_axis, climb });

impl<L: Lane> Ellipse<L> {
    /// For samplers that never use it.
    #[inline(always)]
    pub(super) fn unused() -> Self {
        let (zero, one) = (L::lit(0.0), L::lit(1.0));
        Self { crescent_share: zero, inv_rest: one, beyond: zero, middle: zero, half_axis: zero, climb: zero }
    }

    /// For samplers that use it where it `is_cut`: the others are spared the work. `inv_area` is the reciprocal projected solid angle
    /// of the centre's side.
    #[inline(always)]
    pub(super) fn new(cap: &Cap<L>, cut: &Cut<L>, is_cut: L::Mask, inv_area: L) -> Self {
        let (zero, one) = (L::lit(0.0), L::lit(1.0));
        let c = &cap.crescent;
        let (share, inv_rest, beyond) = branch!(
            is_cut & zero.lt(inv_area),
            {
                let share = c.t_y_cubed() * cut.areas.shape * inv_area;
                // Sine of half the angle that the horizon cuts off the boundary circle: tau / X.
                let half_sine = c.t_y / cap.radius_sin;
                let inv_rest = one / Split(share).rest();
                (share, inv_rest, half_sine * half_sine * half_sine * (cut.shape_cut() * lit(PER_AREA)))
            },
            (zero, one, zero)
        );
        let (s, x, z) = (cap.radius_sin, cap.elevation_cos, cap.elevation());
        Self {
            crescent_share: share,
            inv_rest,
            beyond,
            middle: x * cap.radius_cos,
            half_axis: s * z,
            climb: s * x,
        }
    }

    /// The direction for a point of the unit disk on this side of the chord, as if the centre were above the horizon.
    #[inline(always)]
    pub(super) fn place(&self, cap: &Cap<L>, point: DiskPoint<L>) -> Place<L> {
        let (s, x, z_centre) = (cap.radius_sin, cap.elevation_cos, cap.elevation());
        let xi = lit(1.0) - point.from_edge;
        // s^2 (1 - xi^2 - eta^2) but for the chord, which comes last.
        let rest = s * s * point.across_complement;
        let rim = self.climb.fma(point.from_edge, -cap.rise).max(L::lit(0.0));
        let cosine = point.chord2.fma(rest, rim * rim).sqrt();
        let side = s * point.chord * point.across;
        let zv = z_centre * cap.radius_cos;
        let climb = self.climb * xi;
        let lift = climb.fma(climb - lit(2.0) * zv, point.chord2 * rest) / (cosine + zv);
        let zenith = x.fma(lift, -(self.half_axis * z_centre * xi));
        let along = self.half_axis.fma(xi, self.middle);
        Place { along, up: cosine, offset: Offset { zenith, side, cosine } }
    }

    /// The choice between that crescent and the ellipse.
    #[inline(always)]
    pub(super) fn split(&self) -> Split<L> {
        Split(self.crescent_share)
    }

    /// What is left of the random number that chose the ellipse: [`Split::left_over`], with the division done in advance.
    #[inline(always)]
    pub(super) fn left_over(&self, u0: L) -> L {
        interior((u0 - self.crescent_share) * self.inv_rest)
    }

    /// Whether a direction on the centre's side is on the ellipse's side of the chord: always, without a cut.
    #[inline(always)]
    pub(super) fn contains(&self, cap: &Cap<L>, offset: Offset<L>) -> L::Mask {
        let zero = L::lit(0.0);
        let c = &cap.crescent;
        let (x, z) = (cap.elevation_cos, cap.elevation());
        let a = (lit(1.0) - offset.sin2()).max(zero).sqrt();
        let is_behind = x.fma(a, -(z * offset.zenith)).lt(zero);
        // How far x is beyond t_x, by y^2 + z^2 = 1 - x^2, which small caps resolve, and by Z x = X z - zenith, which the
        // limb of large ones does: weighted as in `crescent::abscissa`.
        let radius2 = offset.side.fma(offset.side, offset.cosine * offset.cosine);
        let by_radius = c.t_y.fma(c.t_y, -radius2) * ((lit(1.0) - radius2).max(zero).sqrt() + c.t_x);
        let by_zenith = z * (x.fma(offset.cosine, -offset.zenith) - z * c.t_x);
        let is_beyond = c.exists() & zero.lt(by_radius + by_zenith);
        is_behind | !is_beyond
    }

    /// The random numbers of [`place`].
    #[inline(always)]
    pub(super) fn invert(&self, cap: &Cap<L>, offset: Offset<L>) -> [L; 2] {
        let (s, x, z_centre) = (cap.radius_sin, cap.elevation_cos, cap.elevation());
        let (zero, one) = (L::lit(0.0), L::lit(1.0));
        let (v, s2) = (cap.radius_cos, s * s);
        // What follows is x - X v three times over, in means weighted by the squares of the precision.
        // First, X (a - v) - Z zenith. By the sine, a - v = (s^2 - sin^2) / (a + v), known to epsilon s^2 / (a + v); by the
        // cosine, a - v = (z - X zenith - Z v) / Z, known to epsilon / Z: next to the sphere that is better.
        let sin2 = offset.sin2();
        let sum = (one - sin2).max(zero).sqrt() + v;
        let s4z = s2 * s2 * z_centre;
        let by_cosine = (-x).fma(offset.zenith, (-z_centre).fma(v, offset.cosine));
        let sum2 = s4z.fma(z_centre, sum * sum);
        let inwards = s.fma(s, -sin2).fma(sum, s4z * by_cosine) / sum2;
        let across = x.fma(inwards, -(z_centre * offset.zenith));
        let unit = z_centre.fma(s, x * s2 / sum2.sqrt());
        // Second, by 1 - x = (y^2 + z^2) / (1 + x), known to epsilon (1 - x): better where the cap touches the horizon. There
        // the zenith tells nothing of x.
        let abscissa = x.fma(v, across);
        let depth = offset.side.fma(offset.side, offset.cosine * offset.cosine) / (one + abscissa.max(zero));
        // Both from the horizon's end, where x is X v + s Z and the boundary at the height -rise.
        let sz = s * z_centre;
        let end_depth = cap.rise * cap.rise / (one + x.fma(v, sz));
        let ratio = depth / unit;
        let weight = ratio * ratio;
        let mean = weight.fma(sz - across, depth - end_depth) / (weight + one);
        let from_end = L::select(zero.lt(abscissa), mean, sz - across);
        disk_to_square(from_end / sz, offset.side / s, self.beyond)
    }
}
