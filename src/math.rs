//! The few elementary functions, from the lane's own operations.

use crate::lane::{lit, Lane};

/// `c[0] + c[1] x + c[2] x^2 + ...`, by Horner's rule in the third power of x, whose coefficients are three terms each: two products
/// more than by Horner's rule in x, and half as long a chain of steps that wait for each other. Up to five terms the square, with two
/// terms each, makes as short a chain with a product less.
#[inline(always)]
pub(crate) fn polynomial<L: Lane>(x: L, coefficients: &[f64]) -> L {
    let x2 = x * x;
    if coefficients.len() <= 5 {
        by_powers::<L, 2>(x, x2, coefficients)
    } else {
        by_powers::<L, 3>(x, x2 * x, coefficients)
    }
}

/// By Horner's rule in a power of x, with so many terms for each coefficient.
#[inline(always)]
fn by_powers<L: Lane, const TERMS: usize>(x: L, power: L, coefficients: &[f64]) -> L {
    // The highest part may have fewer terms. Slices are cut where the compiler, which unrolls this, sees that they are long enough.
    let (mut lower, highest) = coefficients.split_at((coefficients.len() - 1) / TERMS * TERMS);
    let mut value = horner(x, highest);
    while let Some((rest, part)) = lower.split_last_chunk::<TERMS>() {
        value = value.fma(power, horner(x, part));
        lower = rest;
    }
    value
}

/// The same by Horner's rule in x, for the short ones.
#[inline(always)]
fn horner<L: Lane>(x: L, coefficients: &[f64]) -> L {
    let mut value = L::lit(0.0);
    for (i, &c) in coefficients.iter().rev().enumerate() {
        // The first step is no multiplication: what the optimiser may not fold, recording would keep.
        value = if i == 0 { L::lit(c) } else { value.fma(x, L::lit(c)) };
    }
    value
}

/// A polynomial's value at x and its divided difference, `(p(x), (p(x) - p(y)) / (x - y))`, without cancellation also for
/// `x = y`. With the even part `E(x^2)` and the odd one `x O(x^2)`, the difference is
/// `(x + y) E[x^2, y^2] + O(x^2) + y (x + y) O[x^2, y^2]`.
#[inline(always)]
pub(crate) fn polynomial_and_difference<L: Lane>(x: L, y: L, coefficients: &[f64]) -> (L, L) {
    let (x2, y2, sum) = (x * x, y * y, x + y);
    let (even, even_difference) = horner_and_difference(x2, y2, coefficients);
    let (odd, odd_difference) = horner_and_difference(x2, y2, &coefficients[1..]);
    (odd.fma(x, even), y.fma(odd_difference, even_difference).fma(sum, odd))
}

/// Value and divided difference of the polynomial with the coefficients 0, 2, 4, ...
#[inline(always)]
fn horner_and_difference<L: Lane>(x: L, y: L, coefficients: &[f64]) -> (L, L) {
    let (mut value, mut difference) = (L::lit(0.0), L::lit(0.0));
    let count = coefficients.len().div_ceil(2);
    for i in 0..count {
        let c = L::lit(coefficients[2 * (count - 1 - i)]);
        if i == 0 {
            value = c;
        } else {
            difference = if i == 1 { value } else { difference.fma(y, value) };
            value = value.fma(x, c);
        }
    }
    (value, difference)
}

/// The sum of `c[a][b] x^a y^b`.
#[inline(always)]
pub(crate) fn polynomial_of_two<L: Lane>(x: L, y: L, coefficients: &[&[f64]]) -> L {
    let mut value = L::lit(0.0);
    for (i, &by_y) in coefficients.iter().rev().enumerate() {
        let inner = horner(y, by_y);
        value = if i == 0 { inner } else { value.fma(x, inner) };
    }
    value
}

/// `x^(2/3)` for `x >= 0`, with a relative error below 3e-7 in f32 and 5e-16 in f64; 0 at 0. Subnormal `x` give a value of the
/// right magnitude only.
///
/// The first guess `y` of `x^(-1/3)` divides the bit pattern by -3 (the trick of the fast inverse square root); 0.068 makes the
/// residual `r = 1 - x y^3` as small as possible, 0.102. The rest is `(1 - r)^(-1/3)`, by a fit; in double precision a step of
/// Newton's method follows, which takes its error of 5e-9 to 5e-17.
#[inline(always)]
pub(crate) fn two_thirds_power<L: Lane>(x: L) -> L {
    let unit = (L::SIGNIFICAND_BITS as f64).exp2();
    let magic = (4.0 / 3.0 * L::EXPONENT_BIAS as f64 - 0.068) * unit;
    let y = x.bits().fma(L::lit(-1.0 / 3.0), L::lit(magic)).float_of_bits();
    // x y is the power, but for the same factor.
    let (power, r) = power_and_residual(x, y);
    let per_residual = polynomial(r, L::FITS.root);
    if L::SIGNIFICAND_BITS == 23 {
        return (power * r).fma(per_residual, power);
    }
    let (power, r) = power_and_residual(x, (y * r).fma(per_residual, y));
    power.fma(r * lit(1.0 / 3.0), power)
}

/// `(x y, 1 - x y^3)`.
#[inline(always)]
fn power_and_residual<L: Lane>(x: L, y: L) -> (L, L) {
    let power = x * y;
    (power, (-power).fma(y * y, L::lit(1.0)))
}

/// The power of two that is not above `x`, or not above the smallest normal number or a quarter of the largest if `x` is out of
/// their range, as infinity is; that of the former for NaN.
#[inline(always)]
pub(crate) fn power_of_two_near<L: Lane>(x: L) -> L {
    x.max(L::lit(L::MIN_POSITIVE)).min(L::lit(0.25 * L::MAX)).power_of_two()
}

/// A power of two `p` such that `p x` lies in [1, 2), or in [1, 8] for the largest `x` and below 1 for subnormal ones; a power of two
/// for every other `x`, infinity and NaN too. Exact, so that scaling a scene by it loses nothing. And its reciprocal; both are
/// normal numbers.
#[inline(always)]
pub(crate) fn power_of_two_near_reciprocal<L: Lane>(x: L) -> [L; 2] {
    let power = power_of_two_near(x);
    // The biased exponents of a power of two and of its reciprocal add up to twice the bias.
    let ones = 2.0 * L::EXPONENT_BIAS as f64 * (L::SIGNIFICAND_BITS as f64).exp2();
    [(lit(ones) - power.bits()).float_of_bits().named("scale"), power.named("unscale")]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_power_of_two_thirds_keeps_its_bound_over_all_exponents() {
        let mut worst = (0.0_f64, 0.0_f64);
        for exponent in -1020..1020 {
            for step in 0..600 {
                let x = (1.0 + f64::from(step) / 600.0) * f64::from(exponent).exp2();
                worst.1 = worst.1.max((two_thirds_power(x) / x.cbrt().powi(2) - 1.0).abs());
                if (-125..127).contains(&exponent) {
                    let x = x as f32;
                    let exact = f64::from(x).cbrt().powi(2);
                    worst.0 = worst.0.max((f64::from(two_thirds_power(x)) / exact - 1.0).abs());
                }
            }
        }
        assert!(worst.0 < 3e-7 && worst.1 < 5e-16, "{worst:?}");
        assert_eq!((two_thirds_power(0.0_f32), two_thirds_power(0.0_f64)), (0.0, 0.0));
    }

    #[test]
    fn scales_are_powers_of_two_that_bring_any_length_near_one() {
        for exponent in -126..=127 {
            for fraction in [1.0_f32, 1.3, 1.5, 1.999_999_9] {
                let x = fraction * (exponent as f32).exp2();
                let [p, inverse] = power_of_two_near_reciprocal(x);
                assert_eq!(inverse * p, 1.0, "{x} {p}");
                assert_eq!(p.to_bits() & 0x007f_ffff, 0, "{x} {p}");
                assert!((1.0..=8.0).contains(&(p * x)), "{x} {p}");
            }
        }
        for x in [0.0_f32, f32::INFINITY, f32::NAN, 1e-45] {
            let [p, inverse] = power_of_two_near_reciprocal(x);
            assert_eq!(inverse * p, 1.0, "{x} {p}");
            assert!(p.is_normal() && p > 0.0 && p.to_bits() & 0x007f_ffff == 0, "{x} {p}");
        }
        assert!((1.0..2.0).contains(&(power_of_two_near_reciprocal(1e300_f64)[0] * 1e300)));
    }
}
