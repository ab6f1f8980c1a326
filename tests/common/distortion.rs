//! Integrals over the cap by low-discrepancy and by independent points.

use super::Random;
use spherecap::{Offset, Sampler};

/// The first two dimensions of Sobol's sequence, both shifted by an exclusive or: a (0, 2)-sequence in base 2.
fn sobol(index: u32, scramble: [u32; 2]) -> [f64; 2] {
    let first = index.reverse_bits();
    let (mut second, mut direction) = (0, 1_u32 << 31);
    let mut rest = index;
    while rest != 0 {
        if rest & 1 == 1 {
            second ^= direction;
        }
        direction ^= direction >> 1;
        rest >>= 1;
    }
    [first ^ scramble[0], second ^ scramble[1]].map(|x| (f64::from(x) + 0.5) * f64::from(-32).exp2())
}

/// A smooth function over the cap, and a half plane through a point near its middle: in units of the cap's radius.
fn integrands(offset: Offset<f64>, s: f64) -> [f64; 2] {
    let (b, c) = (offset.zenith / s, offset.side / s);
    let smooth = (1.3 * b + 0.4).sin() * (0.7 * c - 0.2).cos() + 0.5 * b * c;
    let half_plane = f64::from(u8::from(0.6 * (b - 0.2) + 0.8 * c > 0.0));
    [smooth, half_plane]
}

/// Root-mean-square errors of the means of both integrands at `count` points, over shifts: with Sobol and with independent
/// points, relative to the integrand's deviation.
pub fn errors(sampler: &Sampler<f64>, count: u32, random: &mut Random) -> [[f64; 2]; 2] {
    let s = sampler.cap().radius_sin();
    let weight = |offset: Offset<f64>| {
        // The integral is over projected solid angle: a weight of one for the uniform techniques, times the area.
        let [a, b] = integrands(offset, s);
        let density = sampler.pdf_in_cap(offset).projected_solid_angle;
        let weight = 1.0 / (density * sampler.cap().projected_solid_angle());
        [a * weight, b * weight]
    };
    let mean = |points: &mut dyn FnMut(u32) -> [f64; 2], count: u32| {
        let mut sums = [0.0; 2];
        for i in 0..count {
            let [u0, u1] = points(i);
            let [a, b] = weight(sampler.sample(u0, u1).offset);
            sums = [sums[0] + a, sums[1] + b];
        }
        sums.map(|sum| sum / f64::from(count))
    };
    // 2^15 points are far closer than any of those below.
    let exact = mean(&mut |i| sobol(i, [0; 2]), 1 << 15);
    const SHIFTS: u32 = 24;
    let mut squares = [[0.0_f64; 2]; 2];
    for _ in 0..SHIFTS {
        let shift = [random.bits() as u32, random.bits() as u32];
        let results =
            [mean(&mut |i| sobol(i, shift), count), mean(&mut |_| [random.unit(), random.unit()], count)];
        for (square, result) in squares.iter_mut().zip(results) {
            for i in 0..2 {
                square[i] += (result[i] - exact[i]).powi(2);
            }
        }
    }
    squares.map(|square| square.map(|x| (x / f64::from(SHIFTS)).sqrt()))
}
