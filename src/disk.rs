//! Area of a segment of the unit disk, and its inverse.
//!
//! A segment of height `h` in [0, 1] is what a chord at distance `1 - h` from the centre cuts off. With
//! `a = acos(1 - h)` its area is `a - sin a cos a`, in [0, pi/2]. Both directions go by powers of the cube root: the area
//! grows as `h^(3/2)`, so its power of two thirds and `h` are smooth functions of each other, and `h` keeps its *relative*
//! precision down to the thinnest segment. Areas here are in units of `c = 4 sqrt(2) / 3`: thin segments have `c h^(3/2)`. (Peters
//! and Dachsbacher invert the area by a quintic in the area itself, which is off by up to 3.4e-3 relative in the height, and 0.5 %
//! in the density.)
//!
//! Worst relative errors of the fits: see `fits.rs`.

use crate::lane::{lit, Lane};
use crate::math::{polynomial, polynomial_and_difference, two_thirds_power};
use core::f64::consts::PI;

/// `1 / c`: areas times this are in units of c.
pub(crate) const PER_AREA: f64 = 0.530_330_085_889_910_6;

/// That of the disk.
const DISK: f64 = PI * PER_AREA;

/// `H(x) = (a - sin a cos a) / sin^3 a` with `a = acos x` and `x` in [0, 1]: the shape of a segment's area. It falls from
/// pi/2 to 2/3.
#[inline(always)]
pub(crate) fn shape<L: Lane>(x: L) -> L {
    polynomial(x - lit(0.5), L::FITS.shape)
}

/// `(H(t), (H(t) - H(e)) / (t - e))`, the divided difference without cancellation also for `e = t`.
#[inline(always)]
pub(crate) fn shape_and_difference<L: Lane>(t: L, e: L) -> (L, L) {
    polynomial_and_difference(t - lit(0.5), e - lit(0.5), L::FITS.shape)
}

/// The area's power of two thirds, from the height in [0, 1] and relative to it: `k / h`.
#[inline(always)]
pub(crate) fn power_per_height<L: Lane>(height: L) -> L {
    polynomial(height, L::FITS.area)
}

/// The height relative to the area's power of two thirds: `h / k`.
#[inline(always)]
pub(crate) fn height_per_power<L: Lane>(k: L) -> L {
    polynomial(k, L::FITS.height)
}

/// Area of the segment of this height in [0, 1].
#[inline(always)]
pub(crate) fn segment_area<L: Lane>(height: L) -> L {
    let k = height * power_per_height(height);
    k * k.sqrt()
}

/// Height in [0, 1] of the segment of this area, at most half the disk's.
#[inline(always)]
pub(crate) fn segment_height<L: Lane>(area: L) -> L {
    let k = two_thirds_power(area);
    k * height_per_power(k)
}

/// A point of the unit disk, in the terms that keep their digits near the edge.
#[derive(Clone, Copy)]
pub(crate) struct DiskPoint<L> {
    /// `1 - x` in [0, 2], with the relative precision of both ends.
    pub from_edge: L,
    /// Half length of the chord through the point, `sqrt(1 - x^2)`, and its square.
    pub chord: L,
    pub chord2: L,
    /// `y` relative to that half length, in (-1, 1), and `1` minus its square.
    pub across: L,
    pub across_complement: L,
}

/// The areas on the near (`x = 1`) and the far side of the chord that `u0` of what remains of the unit disk lies before, when the
/// segment of area `beyond` is cut off at its near end.
#[inline(always)]
pub(crate) fn areas_of_chord<L: Lane>(u0: L, beyond: L) -> [L; 2] {
    let kept = L::lit(DISK) - beyond;
    [u0.fma(kept, beyond), (lit(1.0) - u0) * kept]
}

/// A point of the unit disk, uniformly; `u0 = 0` is the edge `x = 1` and `u0 = 1` the edge `x = -1`. Continuous in both numbers.
#[inline(always)]
pub(crate) fn square_to_disk<L: Lane>(u0: L, u1: L) -> DiskPoint<L> {
    let [near, far] = areas_of_chord(u0, L::lit(0.0));
    let height = segment_height(near.min(far));
    let chord2 = height * (lit(2.0) - height);
    let (across, across_complement) = symmetric(u1);
    DiskPoint {
        from_edge: from_edge(height, near.lt(far)),
        chord: chord2.sqrt(),
        chord2,
        across,
        across_complement,
    }
}

/// `1 - x` of the chord of a segment that is near or far.
#[inline(always)]
pub(crate) fn from_edge<L: Lane>(height: L, is_near: L::Mask) -> L {
    L::select(is_near, height, lit(2.0) - height)
}

/// The inverse of [`square_to_disk`], also with a segment cut off ([`areas_of_chord`]), for a point given by `1 - x` and `y`. Where
/// rounding has put it outside the disk, `y` takes precedence: near the edge a chord's length says more of the point than its
/// distance.
#[inline(always)]
pub(crate) fn disk_to_square<L: Lane>(from_edge: L, y: L, beyond: L) -> [L; 2] {
    let y2 = (y * y).min(L::lit(1.0));
    let nearest = y2 / (lit(1.0) + (lit(1.0) - y2).sqrt());
    let from_edge = from_edge.max(nearest).min(lit(2.0) - nearest);
    let chord = (from_edge * (lit(2.0) - from_edge)).sqrt();
    let across = y / chord.max(L::lit(L::MIN_POSITIVE));
    let is_near = from_edge.lt(L::lit(1.0));
    let area = segment_area(L::select(is_near, from_edge, lit(2.0) - from_edge));
    let share = L::select(is_near, area - beyond, area) / (L::lit(DISK) - beyond);
    let u0 = L::select(is_near, share, lit(1.0) - share);
    [u0, across.fma(L::lit(0.5), L::lit(0.5))]
}

/// `2 u - 1` and `1 - (2 u - 1)^2 = 4 u (1 - u)`, both with full relative precision at the ends.
#[inline(always)]
pub(crate) fn symmetric<L: Lane>(u: L) -> (L, L) {
    let complement = lit(1.0) - u;
    (u - complement, lit(4.0) * u * complement)
}

/// What a function of u is over all 2^24 random numbers of a renderer, and 1.
#[cfg(test)]
pub(crate) mod exhaustive {
    pub(crate) const COUNT: u32 = 1 << 24;

    pub(crate) fn number(i: u32) -> f32 {
        i as f32 / COUNT as f32
    }

    /// Checks that `value` is finite, in [0, `most`] and monotone: it falls by four units in its last place at most, where
    /// rounding in the polynomials is larger than the step.
    pub(crate) fn check(most: f32, mut value: impl FnMut(f32) -> f32) {
        let mut last = 0.0;
        let (mut falls, mut worst) = (0, 0.0_f32);
        for i in 0..=COUNT {
            let u = number(i);
            let now = value(u);
            assert!((0.0..=most).contains(&now), "{now} at {u}");
            if now < last {
                falls += 1;
                worst = worst.max((last - now) / now);
            }
            last = now;
        }
        println!("falls at {falls} of {COUNT} numbers, by {worst:.1e} at most");
        assert!(worst < 4.0 * f32::EPSILON, "falls by {worst:e}");
    }
}

#[cfg(test)]
mod tests {
    use super::exhaustive::{check, COUNT};
    use super::*;

    /// The residual is the error of the height that matters: of the area, relative. The fit of the inverse leaves 5e-7 of it
    /// (`fits.rs`, three halves of the height's), the rounding of the height up to 1.5 epsilon.
    #[test]
    fn every_area_has_its_height() {
        let mut worst = 0.0_f64;
        check(1.0, |u| {
            let area = u * (0.5 * DISK) as f32;
            let height = segment_height(area);
            let residual = (segment_area(f64::from(height)) / f64::from(area) - 1.0).abs();
            if area > 0.0 {
                worst = if residual <= worst { worst } else { residual };
            }
            height
        });
        println!("areas of all {COUNT} heights are off by {worst:.1e} at most");
        assert!(worst < 1e-6, "{worst:e}");
    }

    /// The whole disk, and what a chord leaves of it, over both halves. Its inverse, in f64, gives the number back to a few
    /// roundings of 1.
    #[test]
    fn every_number_has_its_place_on_the_disk() {
        for (beyond, step) in [(0.0, 1), (0.8, 16)] {
            let mut worst = 0.0_f64;
            let mut calls = 0_u32;
            let mut last = 0.0;
            check(2.0, |u| {
                calls += 1;
                if !calls.is_multiple_of(step) {
                    return last;
                }
                let [near, far] = areas_of_chord(u, beyond);
                let height = segment_height(near.min(far));
                last = from_edge(height, near < far);
                if calls.is_multiple_of(64) {
                    let [inverse, _] = disk_to_square(f64::from(last), 0.0, f64::from(beyond));
                    worst = worst.max((inverse - f64::from(u)).abs());
                }
                last
            });
            assert!(worst < 8.0 * f64::from(f32::EPSILON), "{worst:e}");
        }
    }

    /// The area against its definition, where that has no cancellation to speak of.
    #[test]
    fn areas_are_those_of_segments() {
        for i in 1..=1000 {
            let height = f64::from(i) / 1000.0;
            let angle = 2.0 * (0.5 * height).sqrt().asin();
            let area = angle - angle.sin() * angle.cos();
            let cancelled = f64::EPSILON * angle / area;
            let area = area * PER_AREA;
            assert!((segment_area(height) / area - 1.0).abs() < 1e-14 + 4.0 * cancelled, "{height}");
            assert!((segment_height(area) / height - 1.0).abs() < 1e-14 + 4.0 * cancelled, "{height}");
        }
        assert!((segment_area(1.0_f64) - 0.5 * DISK).abs() < 1e-14);
    }
}
