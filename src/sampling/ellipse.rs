//! The part of the cap on the centre's side of the horizon: all of it in case 1; in case 2 all but the crescent that lies
//! beyond the chord `x = t_x`. Uniform in projected solid angle. (Sections 1 and 2 of the paper's supplement; coordinates that
//! cancel there are replaced.)
//!
//! Dropped onto the tangent plane the boundary circle is an ellipse with half axes `s Z` and `s`. A point `(xi, eta)` of
//! the unit disk with `xi = 1` at the horizon's end goes to `x = X v + s Z xi`, `y = s eta`. The boundary circle is
//! `s X (e - xi)` above the horizon there, hence `z^2 = (s X (e - xi))^2 + s^2 (1 - xi^2 - eta^2)`: a sum of positives, with
//! `s X (e - xi) = s X (1 - xi) - rise`. The offset towards the zenith, `X z - Z x`, is `X (z - Z v) - s Z^2 xi` with
//! `z - Z v = s (X xi (s X xi - 2 Z v) + s (1 - xi^2 - eta^2)) / (z + Z v)`.

use crate::cap::Cap;
use crate::disk::{disk_to_square, shape, square_to_disk};
use crate::lane::{branch, lit, Lane};
use crate::offset::Offset;

#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(super) struct Ellipse<L> {
    /// Probability of the crescent beyond the chord `x = t_x`, on the centre's side: 0 in case 1.
    pub crescent_share: L,
    /// Area of the segment that the horizon cuts off the unit disk.
    beyond: L,
}

impl<L: Lane> Ellipse<L> {
    /// For samplers that never use it.
    #[inline(always)]
    pub(super) fn unused() -> Self {
        Self { crescent_share: L::lit(0.0), beyond: L::lit(0.0) }
    }

    #[inline(always)]
    pub(super) fn new(cap: &Cap<L>) -> Self {
        let zero = L::lit(0.0);
        let c = &cap.crescent;
        let [crescent_share, beyond] = branch!(
            zero.lt(c.tau),
            {
                let larger = cap.projected_above.max(cap.projected_below);
                let share = L::select(zero.lt(larger), c.t_y_cubed() * c.shape / larger, zero);
                // Sine of half the angle that the horizon cuts off the boundary circle.
                let half_sine = c.tau / cap.elevation_cos;
                [share, half_sine * half_sine * half_sine * shape(c.cut)]
            },
            [zero; 2]
        );
        Self { crescent_share, beyond }
    }

    /// A direction in the centre's half, as if that were above the horizon.
    #[inline(always)]
    pub(super) fn sample(&self, cap: &Cap<L>, u0: L, u1: L) -> Offset<L> {
        let (s, x, z_centre) = (cap.radius_sin, cap.elevation_cos, cap.elevation());
        let point = square_to_disk(u0, u1, self.beyond);
        let sx = s * x;
        let xi = lit(1.0) - point.from_edge;
        let rim = sx.fma(point.from_edge, -cap.rise).max(L::lit(0.0));
        let rest = point.chord2 * point.across_complement;
        let bulge = s * s * rest;
        let cosine = rim.fma(rim, bulge).sqrt();
        let side = s * point.chord2.sqrt() * point.across;
        let zv = z_centre * cap.radius_cos;
        let climb = (x * xi).fma(sx.fma(xi, lit(-2.0) * zv), s * rest) / (cosine + zv);
        let zenith = s * x.fma(climb, -(z_centre * z_centre * xi));
        Offset { zenith, side, cosine }
    }

    /// Whether a direction on the centre's side is on the ellipse's side of the chord: always, without a cut.
    #[inline(always)]
    pub(super) fn contains(&self, cap: &Cap<L>, offset: Offset<L>) -> L::Mask {
        let a = (lit(1.0) - offset.sin2()).max(L::lit(0.0)).sqrt();
        let x = cap.elevation_cos.fma(a, -(cap.elevation() * offset.zenith));
        // Beyond the chord y^2 + z^2 is below t_y^2, and x is positive. Small caps lose x, but not y and z.
        let radius2 = offset.side.fma(offset.side, offset.cosine * offset.cosine);
        let t_y = cap.crescent.t_y;
        x.lt(L::lit(0.0)) | (t_y * t_y).le(radius2)
    }

    /// The random numbers of [`Ellipse::sample`].
    #[inline(always)]
    pub(super) fn invert(&self, cap: &Cap<L>, offset: Offset<L>) -> [L; 2] {
        let (s, x, z_centre) = (cap.radius_sin, cap.elevation_cos, cap.elevation());
        // x - X v = X (a - v) - Z zenith, with a - v = (s^2 - sin^2) / (a + v).
        let sin2 = offset.sin2();
        let a = (lit(1.0) - sin2).max(L::lit(0.0)).sqrt();
        let inwards = s.fma(s, -sin2) / (a + cap.radius_cos);
        let xi = x.fma(inwards, -(z_centre * offset.zenith)) / (s * z_centre);
        disk_to_square(lit(1.0) - xi, offset.side / s, self.beyond)
    }
}
