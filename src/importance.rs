//! The importance of a light at a point: about the irradiance over pi that it gives there if nothing hides it, and not less. Lights are
//! chosen by it (`choice.rs`).
//!
//! With `s = r/d` and `Z` as in `cap.rs`, and `T = Z + s` what the light has above the horizon (in units of its distance), it is
//! `strength s^2 gamma` with
//!
//! | `gamma` | where |
//! |---|---|
//! | `Z` | `Z >= s`: all of the light is above, and this is its projected solid angle over pi |
//! | `T^2 / (2 (T + (s - Z) (1 - s^4)))` | the horizon cuts it; the two meet at `Z = s`, and this is `T/2`, exact, at `s = 1` |
//! | 0 | none of it is above |
//!
//! Rounding must hide no light that [`Sampler`](crate::Sampler) sees, so `Z` and `T` are raised, and `1 - s^4` lowered, by what it may
//! do: [`MARGIN`] and [`MARGIN_OF_FOURTH_POWER`]. docs/mathematics.md has the bound in the other direction.

use crate::cap::Lengths;
use crate::input::{is_fraction, unit_or_zero};
use crate::lane::{lit, Lane};
use crate::strategy::{Hemispheres, Receiver, Strategy, Technique};
use crate::vec3::Vec3;

/// Of `Z` and `T`, in epsilons. The three roundings of the height are of numbers up to the distance, half an epsilon each; after
/// them, `h + r` is exact where the light has all but set, and its product with 1/d is not rounded before the margin is added.
const MARGIN: f64 = 2.0;

/// Of `1 - s^4`, likewise: half an epsilon for each of three roundings of `d^2`, halved by the root, and for root, reciprocal and product
/// make 9/4 epsilons for `s`, and 10 for its fourth power with that of the square.
const MARGIN_OF_FOURTH_POWER: f64 = 16.0;

impl<L: Lane> Receiver<L> {
    /// How much a light can give to a point, so that one of several can be chosen by it: about its unoccluded irradiance over
    /// pi, `strength * E / pi` with the [projected solid angle](crate::Cap::projected_solid_angle) E, and equal to that (to four
    /// epsilons of the distance) where all of it is above the horizon.
    ///
    /// It is what the strategy samples that counts. Both hemispheres: the irradiances of both sides. A defensive fraction: that
    /// of a light in any direction, `strength * s^2 / 2` with the sine s of its angular radius, takes that fraction of the whole;
    /// so it does for [`Technique::SolidAngle`], whose fraction is 1. On no surface: `strength * s^2`. `centre` (relative to the
    /// point) and `radius` are in one unit of length, and `strength` is the light's radiance, in any unit.
    ///
    /// Never less than a millionth below these, so never 0 where [`Sampler::prepare`](crate::Sampler::prepare) succeeds and the
    /// strength is positive. 0 for a point inside the light; and where anything is bad input: to `prepare`, or a strength that
    /// is no positive finite number. Otherwise in [`Lane::MIN_POSITIVE`] to [`Lane::MAX`].
    ///
    /// ```
    /// use spherecap::Receiver;
    /// use std::f64::consts::PI;
    ///
    /// let floor = Receiver::new([0.0, 0.0, 1.0_f64]);
    /// // At the zenith E is pi s^2.
    /// assert!((floor.importance([0.0, 0.0, 4.0], 1.0, 7.0) - 7.0 / 16.0).abs() < 1e-14);
    /// // Half of this one is above the horizon: bounded from above.
    /// let half = spherecap::Cap::new([0.0, 0.0, 1.0], [2.0, 0.0, 0.0], 1.0).projected_solid_angle();
    /// let importance = floor.importance([2.0, 0.0, 0.0], 1.0, 1.0);
    /// assert!(half / PI < importance && importance < 1.75 * half / PI);
    /// assert_eq!(floor.importance([0.0, 0.0, -4.0], 1.0, 7.0), 0.0);
    /// ```
    #[inline(always)]
    pub fn importance(self, centre: impl Into<[L; 3]>, radius: L, strength: L) -> L {
        let unit = unit_or_zero(self.normal);
        importance_and_distance(unit, self.strategy, centre.into().into(), radius, strength).0
    }
}

/// [`Receiver::importance`], for what `unit_or_zero` made of the normal; and the distance of the light's centre.
#[inline(always)]
pub(crate) fn importance_and_distance<L: Lane>(
    unit: Vec3<L>,
    strategy: Strategy<L>,
    centre: Vec3<L>,
    radius: L,
    strength: L,
) -> (L, L) {
    let (zero, one, largest) = (L::lit(0.0), L::lit(1.0), L::lit(L::MAX));
    let Strategy { technique, hemispheres, defensive } = strategy;
    let Lengths { centre: c, radius: r, unit: unit_length } = Lengths::new(centre, radius);
    let d = c.dot(c).sqrt();
    let inv_d = lit(1.0) / d;
    let s = r * inv_d;
    let s2 = s * s;
    let distance = d * unit_length;

    // False for NaN. `s` is also that of a kernel which computes it more precisely: what that sees is seen here.
    let rounded = L::lit(1.0 + MARGIN_OF_FOURTH_POWER * L::EPSILON);
    let is_outside = s2.le(rounded) & L::lit(0.5 * L::MIN_POSITIVE / L::EPSILON).lt(s2);
    let normal2 = unit.dot(unit);
    let is_valid = is_fraction(defensive)
        & normal2.le(L::lit(2.0))
        & zero.lt(radius)
        & distance.le(largest)
        & zero.lt(strength)
        & strength.le(largest);

    let height = unit.dot(c);
    let fall = (-s2).fma(s2, L::lit(1.0 - MARGIN_OF_FOURTH_POWER * L::EPSILON)).max(zero);
    let projected = match (technique, hemispheres) {
        (Technique::SolidAngle, _) => L::lit(0.5),
        (_, Hemispheres::Front) => part_above(height, r, inv_d, s, fall),
        (_, Hemispheres::Both) => {
            part_above(height, r, inv_d, s, fall) + part_above(-height, r, inv_d, s, fall)
        }
    };
    let mixed = defensive.fma(lit(0.5) - projected, projected);
    let is_in_air = normal2.le(zero);
    let cosine = L::select(is_in_air, one, mixed);
    // Also where the product of a tiny fraction is 0.
    let is_lit = is_outside & is_valid & (zero.lt(cosine) | zero.lt(defensive));
    let importance = ((s2 * cosine) * strength).max(L::lit(L::MIN_POSITIVE)).min(largest);
    (L::select(is_lit, importance, zero), distance)
}

/// `gamma` of the side of the horizon where the height is positive.
#[inline(always)]
fn part_above<L: Lane>(height: L, r: L, inv_d: L, s: L, fall: L) -> L {
    let margin = L::lit(MARGIN * L::EPSILON);
    let z = height.fma(inv_d, margin);
    let t = (height + r).fma(inv_d, margin);
    let cut = t * t / ((s - z).fma(fall, t) * lit(2.0));
    L::select(s.le(z), z, L::select(L::lit(0.0).lt(t), cut, L::lit(0.0)))
}
