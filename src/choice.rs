//! The choice of one light by importances: by the inverse of their distribution function, so that each light keeps one interval of
//! the random number, and strata survive.
//!
//! Sums and intervals are in double precision: what rounding leaves to the last light does not grow with their number, and is about
//! as much as a random number in single precision resolves.

use crate::lane::Lane;

/// What is known of the importances of all lights at a point: enough for the probability of each.
///
/// ```
/// use spherecap::lights::Total;
///
/// let importances = [3.0, 0.0, 1.0];
/// let total = Total::of(&importances);
/// assert_eq!(total, Total { sum: 4.0, lit: 2 });
/// // By importance alone, or a fifth of it evenly.
/// assert_eq!(importances.map(|importance| total.probability(importance, 0.0)), [0.75, 0.0, 0.25]);
/// assert_eq!(importances.map(|importance| total.probability(importance, 0.2)), [0.7, 0.0, 0.3]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Total {
    /// Sum of the importances.
    pub sum: f32,
    /// How many of them are positive.
    pub lit: u32,
}

/// Which light, and what is left of the random number that chose it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Choice {
    /// Its place in the arrays; 0 if nothing is lit.
    pub index: usize,
    /// The probability of this choice, the bits of [`Total::probability`]; 0 if nothing is lit.
    pub probability: f32,
    /// What is left of the random number: another, uniform in \[0, 1\], and independent of the choice.
    pub rest: f32,
}

impl Total {
    /// Adds up importances, at most 2^32 - 1 of them. What is negative or NaN counts as 0, and what is above 2^95 as that, here and
    /// in the functions below: so no sum is infinite, and no probability wrong.
    pub fn of(importances: &[f32]) -> Self {
        let mut sums = Sums::default();
        let (chunks, rest) = importances.as_chunks();
        for chunk in chunks {
            sums.add(chunk);
        }
        let mut last = [0.0; LANES];
        // One by one: to copy so few is a call that takes longer.
        for (i, last) in last.iter_mut().enumerate() {
            if i < rest.len() {
                *last = rest[i];
            }
        }
        sums.add(&last);
        sums.total()
    }

    /// Chooses a light in proportion to the importances that were added up, by one random number `u`. The fraction `even` of the
    /// probability is spread evenly over all that are not 0, for where the bright lights are hidden. Of both, a number outside
    /// \[0, 1\] is taken for the nearer end, and NaN for 0.
    ///
    /// ```
    /// use spherecap::lights::{Choice, Total};
    ///
    /// let importances = [3.0, 0.0, 1.0];
    /// let total = Total::of(&importances);
    /// let choice = total.choose(&importances, 0.0, 0.875);
    /// assert_eq!(choice, Choice { index: 2, probability: 0.25, rest: 0.5 });
    /// ```
    pub fn choose(&self, importances: &[f32], even: f32, u: f32) -> Choice {
        let target = f64::from(fraction(u));
        let shares = self.shares(even);
        let (mut index, mut own, mut start, mut end) = (0, 0.0, 0.0, 0.0);
        for (i, &importance) in importances.iter().enumerate() {
            let share = shares.seen_in_single(importance);
            if share > 0.0 {
                (index, own, start) = (i, share, end);
                end += share;
                if target < end {
                    break;
                }
            }
        }
        // The last one takes what rounding leaves.
        let rest = if own > 0.0 { ((target - start) / own).min(1.0) } else { 0.0 };
        Choice { index, probability: own as f32, rest: rest as f32 }
    }

    /// The probability with which [`Total::choose`] gives a light of this importance, the same bits: for the density of a direction
    /// that something else has sampled, as multiple importance sampling asks for it.
    pub fn probability(&self, importance: f32, even: f32) -> f32 {
        self.shares(even).seen_in_single(importance) as f32
    }

    fn shares(&self, even: f32) -> Shares<f64> {
        Shares::new(f64::from(self.sum), f64::from(self.lit), f64::from(even))
    }
}

/// Sums side by side, of which a CPU can add several at a time: in an order that does not depend on how many.
#[derive(Default)]
struct Sums {
    weights: [f64; LANES],
    lit: [u32; LANES],
}

const LANES: usize = 8;

impl Sums {
    #[inline(always)]
    fn add(&mut self, importances: &[f32; LANES]) {
        for ((sum, lit), &importance) in self.weights.iter_mut().zip(&mut self.lit).zip(importances) {
            let weight = weight(importance);
            *sum += f64::from(weight);
            *lit += u32::from(weight > 0.0);
        }
    }

    #[inline(always)]
    fn total(self) -> Total {
        let [a, b, c, d, e, f, g, h] = self.weights;
        let sum = ((a + b) + (c + d)) + ((e + f) + (g + h));
        Total { sum: sum as f32, lit: self.lit.iter().sum() }
    }
}

/// A sum of weights and how many of them are not 0, with one more.
#[inline(always)]
pub(crate) fn add<L: Lane>(importance: L, sum: L, lit: L) -> (L, L) {
    let (zero, weight) = (L::lit(0.0), weight(importance));
    (sum + weight, L::select(zero.lt(weight), lit + L::lit(1.0), lit))
}

/// What a probability is made of: `scale` times the importance and the even part.
///
/// One light has 1 to double precision, and so 1 exactly in single.
pub(crate) struct Shares<L> {
    scale: L,
    even: L,
}

impl<L: Lane> Shares<L> {
    /// For a sum of weights, how many of them are not 0, and the fraction that is spread evenly over those.
    #[inline(always)]
    pub(crate) fn new(sum: L, lit: L, even: L) -> Self {
        let (zero, one) = (L::lit(0.0), L::lit(1.0));
        let even = fraction(even);
        let is_lit = zero.lt(sum) & zero.lt(lit);
        Self { scale: L::select(is_lit, (one - even) / sum, zero), even: L::select(is_lit, even / lit, zero) }
    }

    /// The share of a light.
    #[inline(always)]
    pub(crate) fn of(&self, importance: L) -> L {
        let (zero, weight) = (L::lit(0.0), weight(importance));
        L::select(zero.lt(weight), weight * self.scale + self.even, zero)
    }
}

impl Shares<f64> {
    /// The share of a light: 0 where its probability, in single precision, would be, so that none is chosen with a density of 0.
    fn seen_in_single(&self, importance: f32) -> f64 {
        let share = self.of(f64::from(importance));
        if share as f32 == 0.0 {
            0.0
        } else {
            share
        }
    }
}

/// What an importance counts as. 2^32 of the largest are no infinite sum.
#[inline(always)]
fn weight<L: Lane>(importance: L) -> L {
    clamped(importance, L::lit((1_u128 << 95) as f64))
}

/// A number in [0, 1]: the nearer end, or 0 for NaN.
#[inline(always)]
fn fraction<L: Lane>(x: L) -> L {
    clamped(x, L::lit(1.0))
}

/// Not by `max`, which may give either zero.
#[inline(always)]
fn clamped<L: Lane>(x: L, most: L) -> L {
    let zero = L::lit(0.0);
    L::select(zero.lt(x), x, zero).min(most)
}
