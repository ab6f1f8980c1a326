//! The crescent of a cut cap, uniformly in projected solid angle: the whole region in case 3.
//!
//! The paper warps a cut disk onto it, which varies the density by up to a factor. Here the crescent is sliced by the great
//! circles through `(1, 0, 0)`, a point of the horizon inside the cap. Write a direction as
//! `x = cos a`, `(y, z) = sin a (cos theta, sin theta)` and `h = 1 - x`. The projected area element is
//! `sqrt(h (2 - h)) dh d(cos theta)`, so that along a slice the distribution function is the area of a disk segment of height
//! h, whatever the cap: one inverse (`disk.rs`), up to the slice's end on the cap's boundary.
//!
//! Seen by stereographic projection from `(-1, 0, 0)` the crescent is a circular segment whose shape depends on kappa alone. With
//! `(c, c_bar)` on the upper half of the unit circle (a bar is `sqrt(1 - x^2)`) the slices are `tan theta = tau c_bar / c` and end at
//! `h_b = (1 - t_x) (1 - kappa c_bar) / (1 + e c_bar)`. What remains is to choose c with the density of the slices' areas.
//! For `kappa = 0`, the plain cut disk, that is uniform: `c = u = 2 u1 - 1`. In general
//! `(c, c_bar)` is proportional to `(u, u_bar B(u_bar))` with a mild, smooth B, known exactly at both ends and fitted between them
//! (`fits.rs`), with a density within 7e-6 of uniform over all kappa and t_x. docs/mathematics.md, section 6, derives all of it.

use super::split::interior;
use super::Place;
use crate::cap::{Cap, Crescent, Cut};
use crate::disk::{power_per_height, shape};
use crate::fits::CRESCENT;
use crate::lane::{branch, broadcast_fields, lit, Blend, Lane, Only};
use crate::math::polynomial_of_two;
use crate::offset::Offset;

/// B as a polynomial in u_bar, coefficients ascending.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(super) struct Marginal<L> {
    coefficients: [L; 7],
}
broadcast_fields!(Marginal { coefficients });

/// A slice through `(1, 0, 0)`, and how far along it to go.
#[derive(Clone, Copy)]
pub(super) struct Slice<L> {
    /// The share of its area.
    pub u0: L,
    /// Component of its unnormalised direction towards the zenith; the one sideways is `2 u1 - 1`.
    pub m: L,
    /// The sum of the squares of both.
    pub g2: L,
    /// Height of its end, over `g2`.
    pub end: L,
}

/// What distinguishes a crescent from the plain segment of a disk: kappa, tau and e.
#[inline(always)]
fn proportions<L: Lane>(cap: &Cap<L>, is_segment: L::Mask) -> [L; 3] {
    let (zero, one) = (L::lit(0.0), L::lit(1.0));
    let c = &cap.crescent;
    [
        L::select(is_segment, zero, c.kappa),
        L::select(is_segment, one, c.tau),
        L::select(is_segment, zero, c.cut),
    ]
}

/// The direction with `1 - x = h`: `zenith = X z - Z x`.
#[inline(always)]
pub(super) fn place<L: Lane>(cap: &Cap<L>, centre_side: L::Mask, h: L, side: L, cosine: L) -> Place<L> {
    let z = cap.elevation();
    let z = L::select(centre_side, z, -z);
    let along = lit(1.0) - h;
    let zenith = cap.elevation_cos.fma(cosine, -(z * along));
    Place { along, up: cosine, offset: Offset { zenith, side, cosine } }
}

/// The x of an offset in the crescent or beyond the chord.
///
/// By `y` and `z` it is `sqrt(1 - y^2 - z^2)`, known to epsilon (1 - x^2) / x: little next to the sphere, where the limb is at
/// `x = t_x = v/X`. By `zenith = X z - Z x` it is known to epsilon / |Z|. The mean of both, weighted by the squares of their
/// precision, is known to epsilon / sqrt(x^2 + Z^2), and in small caps, where `|Z| < s`, still to epsilon s^2.
#[inline(always)]
pub(super) fn abscissa<L: Lane>(cap: &Cap<L>, centre_side: L::Mask, offset: Offset<L>) -> L {
    let z = cap.elevation();
    let z = L::select(centre_side, z, -z);
    let sin2 = offset.side.fma(offset.side, offset.cosine * offset.cosine);
    let x2 = (lit(1.0) - sin2).max(L::lit(0.0));
    let z_x = cap.elevation_cos.fma(offset.cosine, -offset.zenith);
    x2.fma(x2.sqrt(), z * z_x) / z.fma(z, x2).max(L::lit(L::MIN_POSITIVE))
}

impl<L: Lane> Marginal<L> {
    /// For samplers that never use it.
    #[inline(always)]
    pub(super) fn unused() -> Self {
        Self { coefficients: [L::lit(0.0); 7] }
    }

    /// For samplers that use it `is_used`, and have one: the others are spared the work.
    #[inline(always)]
    pub(super) fn new(cut: &Cut<L>, is_used: L::Mask) -> Self {
        let Only(coefficients) = branch!(
            is_used,
            {
                let (c, areas) = (&cut.crescent, &cut.areas);
                let (one, kappa_1) = (L::lit(1.0), lit(1.0) + c.kappa);
                // B(0) = sqrt(N / P) from the crescent's ends, with P = (1 + kappa) H(t_x); B(1) from its middle. One
                // division serves both, and the quotient rho.
                let ends = kappa_1 * areas.shape;
                let inv = one / (areas.norm * ends);
                let inv_root = inv.sqrt();
                let b0 = areas.norm * inv_root;
                let inv_cut_1 = one / (lit(1.0) + c.cut);
                let middle = shape((c.t_x + c.kappa) * inv_cut_1);
                let b1 = kappa_1 * middle * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (ends * inv);
                let rho = b1.fma(ends * inv_root, -one);
                let y = one - b1;
                // One by one: a loop over all of them is not unrolled, and then no coefficient is a constant any more.
                let beta = [
                    rho * polynomial_of_two(rho, y, CRESCENT[0]),
                    rho * polynomial_of_two(rho, y, CRESCENT[1]),
                    rho * polynomial_of_two(rho, y, CRESCENT[2]),
                    rho * polynomial_of_two(rho, y, CRESCENT[3]),
                    rho * polynomial_of_two(rho, y, CRESCENT[4]),
                ];
                Only([
                    b0,
                    (b1 - b0) + beta[0],
                    beta[1] - beta[0],
                    beta[2] - beta[1],
                    beta[3] - beta[2],
                    beta[4] - beta[3],
                    -beta[4],
                ])
            },
            Blend::blank()
        );
        Self { coefficients }
    }

    /// B, given the square of `u_bar` too: its even part need not wait for the root.
    #[inline(always)]
    fn value(&self, u_bar: L, u_bar2: L) -> L {
        let [c0, c1, c2, c3, c4, c5, c6] = self.coefficients;
        let even = c6.fma(u_bar2, c4).fma(u_bar2, c2).fma(u_bar2, c0);
        c5.fma(u_bar2, c3).fma(u_bar2, c1).fma(u_bar, even)
    }

    /// B and its derivative.
    #[inline(always)]
    fn value_and_slope(&self, u_bar: L) -> (L, L) {
        let mut value = self.coefficients[6];
        let mut slope = L::lit(0.0);
        for &c in self.coefficients[..6].iter().rev() {
            slope = slope.fma(u_bar, value);
            value = value.fma(u_bar, c);
        }
        (value, slope)
    }

    /// The slice for two random numbers, in the crescent away from the centre, or (`is_segment`) in the part of the centre's side
    /// beyond the chord, as if that side were above the horizon; that part is the crescent of a cap with kappa = 0, and is
    /// chosen for `u0` below `share`. `u0 = 0` is `(1, 0, 0)` and `u0 = 1` the boundary (or the chord); `u1 = 0` and `u1 = 1` are the
    /// horizon on either side. Of `u1` it is told `u = 2 u1 - 1` and `u_bar2 = 1 - u^2`.
    #[inline(always)]
    pub(super) fn slice(
        &self,
        cap: &Cap<L>,
        is_segment: L::Mask,
        share: L,
        u0: L,
        u: L,
        u_bar2: L,
    ) -> Slice<L> {
        let Crescent { kappa, tau, cut, width, .. } = cap.crescent;
        let u_bar = u_bar2.sqrt();
        // One division for both: `Split::left_over` of the segment, and the end of the crescent's slice.
        let [m, g2, dividend, divisor] = branch!(is_segment, [u_bar, L::lit(1.0), u0, share], {
            let u_bar_b = u_bar * self.value(u_bar, u_bar2);
            let length = u.fma(u, u_bar_b * u_bar_b).sqrt();
            let m = tau * u_bar_b;
            [m, u.fma(u, m * m), width, kappa.fma(u_bar_b, length) * cut.fma(u_bar_b, length)]
        });
        let quotient = dividend / divisor;
        let (u0, end) = branch!(is_segment, (interior(quotient), width), (u0, quotient));
        Slice { u0, m, g2, end }
    }

    /// The random numbers that give an offset: with `is_segment`, `u0` over the share.
    #[inline(always)]
    pub(super) fn invert(&self, cap: &Cap<L>, is_segment: L::Mask, offset: Offset<L>) -> [L; 2] {
        let [kappa, tau, cut] = proportions(cap, is_segment);
        let (y, z) = (offset.side, offset.cosine);
        // (u, u_bar B) is proportional to (tau |y|, z): Newton's method for f = u_bar B a - z u on the unit circle.
        let a = y.abs() * tau;
        let plain = |(value, slope): (L, L)| {
            (L::select(is_segment, L::lit(1.0), value), L::select(is_segment, L::lit(0.0), slope))
        };
        let normalise = |u: L, u_bar: L| {
            let scale = lit(1.0) / u.fma(u, u_bar * u_bar).sqrt();
            (u * scale, u_bar * scale)
        };
        let (start, _) =
            plain(((self.coefficients[0] + self.value_and_slope(L::lit(1.0)).0) * lit(0.5), L::lit(0.0)));
        let (mut u, mut u_bar) = normalise(a * start, z);
        for _ in 0..NEWTON_STEPS {
            let (b, slope) = plain(self.value_and_slope(u_bar));
            let f = u_bar * b * a - z * u;
            let delta = -f / (a * u).fma(u_bar.fma(slope, b), z * u_bar);
            (u, u_bar) = normalise((-delta).fma(u_bar, u), delta.fma(u, u_bar));
        }
        let (b, _) = plain(self.value_and_slope(u_bar));
        let u_bar_b = u_bar * b;
        let (length, m) = (u.fma(u, u_bar_b * u_bar_b).sqrt(), tau * u_bar_b);
        let h = y.fma(y, z * z) / (lit(1.0) + abscissa(cap, is_segment, offset));
        let per_g2 = cap.crescent.width / (kappa.fma(u_bar_b, length) * cut.fma(u_bar_b, length));
        let h_end = u.fma(u, m * m) * per_g2;
        let ratio = h * power_per_height(h) / (h_end * power_per_height(h_end));
        let smaller = u_bar * u_bar / ((lit(1.0) + u) * lit(2.0));
        [ratio * ratio.sqrt(), L::select(y.lt(L::lit(0.0)), smaller, lit(1.0) - smaller)]
    }
}

/// Two steps leave 4e-10 (B varies by at most 40 %), a third nothing in f64.
const NEWTON_STEPS: usize = 3;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disk::exhaustive;
    use crate::sampling::Sampler;
    use crate::strategy::Strategy;

    fn sampler<L: Lane>(s: f64, kappa: f64) -> Sampler<L> {
        let (z, lit) = (-kappa * s, L::lit);
        let x = ((1.0 - z) * (1.0 + z)).sqrt();
        let (normal, centre) = ([lit(0.0), lit(0.0), lit(1.0)], [lit(x), lit(0.0), lit(z)]);
        Sampler::new(normal, centre, lit(s), Strategy::default())
    }

    /// Along a slice all 2^24 numbers give heights over the horizon that are finite, monotone and not above the cap's top; and
    /// the f64 inverse gives back every 1024th, to what rounding of the offset makes of it: 5e-6 (`tests/kernels/properties.rs`).
    fn check(s: f64, kappa: f64) {
        let (single, double) = (sampler::<f32>(s, kappa), sampler::<f64>(s, kappa));
        let mut worst = 0.0_f64;
        let mut calls = 0_u32;
        exhaustive::check(single.cap().rise * (1.0 + 4.0 * f32::EPSILON), |u| {
            let Offset { zenith, side, cosine } = single.sample(u, 0.4).offset;
            if calls.is_multiple_of(1024) && u > 0.0 {
                let offset = Offset { zenith: zenith.into(), side: side.into(), cosine: cosine.into() };
                let [u0, u1] = double.invert(offset);
                worst = worst.max((u0 - f64::from(u)).abs()).max((u1 - f64::from(0.4_f32)).abs());
            }
            calls += 1;
            cosine
        });
        println!("s = {s}, kappa = {kappa}: numbers off by {worst:.1e} at most");
        assert!(worst < 5e-6, "s = {s}, kappa = {kappa}: {worst:e}");
    }

    #[test]
    fn every_number_has_its_place_on_a_slice_of_a_small_cap() {
        check(1e-6, 0.3);
    }

    #[test]
    fn every_number_has_its_place_on_a_slice_of_a_large_cap() {
        check(0.99, 0.9);
    }
}
