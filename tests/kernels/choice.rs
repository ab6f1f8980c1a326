//! The choice among lights: every light as often as its probability says, what is left of the random number uniform, strata kept.

use crate::common::inputs::inputs;
use crate::common::{strategies, Random};
use spherecap::lights::{Choice, Lights, Total};
use spherecap::{Cap, Hemispheres, Receiver, Sampler, Vec3};

const EVEN: [f32; 5] = [0.0, 0.02, 0.05, 0.5, 1.0];

/// Importances of lights of which some give nothing, over `decades` powers of ten.
fn importances(count: usize, decades: f64, random: &mut Random) -> Vec<f32> {
    let one =
        |_| if random.bits().is_multiple_of(5) { 0.0 } else { 10_f64.powf(decades * random.unit()) as f32 };
    (0..count).map(one).collect()
}

/// Normal deviates of a chi-square with many degrees of freedom (Wilson and Hilferty).
fn deviates(chi2: f64, freedom: f64) -> f64 {
    let variance = 2.0 / (9.0 * freedom);
    ((chi2 / freedom).cbrt() - (1.0 - variance)) / variance.sqrt()
}

#[test]
fn lights_are_chosen_as_often_as_their_probability_says_and_the_rest_is_uniform() {
    const BINS: usize = 8;
    let trials = inputs(100_000, 1_000_000, 1_000_000);
    let mut random = Random(21);
    for (count, decades) in [(2, 1.0), (3, 4.0), (10, 2.0), (17, 0.0), (100, 3.0), (400, 1.0)] {
        let importances = importances(count, decades, &mut random);
        let total = Total::of(&importances);
        for even in EVEN {
            let mut counts = vec![0_usize; count * BINS];
            for _ in 0..trials {
                let choice = total.choose(&importances, even, random.unit() as f32);
                let Choice { index, probability, rest } = choice;
                assert_eq!(probability.to_bits(), total.probability(importances[index], even).to_bits());
                assert!(probability > 0.0 && (0.0..=1.0).contains(&rest), "{choice:?}");
                counts[index * BINS + ((rest * BINS as f32) as usize).min(BINS - 1)] += 1;
            }
            // Cells that expect few are thrown together.
            let (mut chi2, mut cells, mut few) = (0.0, -1.0, [0.0; 2]);
            for (cell, &found) in counts.iter().enumerate() {
                let probability = f64::from(total.probability(importances[cell / BINS], even)) / BINS as f64;
                let (found, expected) = (found as f64, probability * f64::from(trials));
                few = [few[0] + found, few[1] + expected];
                if few[1] >= 20.0 {
                    chi2 += (few[0] - few[1]).powi(2) / few[1];
                    cells += 1.0;
                    few = [0.0; 2];
                }
            }
            // The random numbers are fixed: 30 pairs, of which none may be beyond one in 30 000.
            assert!(deviates(chi2, cells) < 4.0, "{count} lights, even {even}: {chi2} of {cells}");
        }
    }
}

/// The error of the sum, which is single precision, and of as many probabilities as there are.
#[test]
fn probabilities_add_up_to_one() {
    let mut random = Random(22);
    for count in [1, 2, 3, 15, 16, 17, 100, 4000] {
        for decades in [0.0, 3.0, 25.0] {
            let mut importances = importances(count, decades, &mut random);
            importances[count / 2] = 1.0;
            let total = Total::of(&importances);
            assert_eq!(total.lit as usize, importances.iter().filter(|&&x| x > 0.0).count());
            let sum: f64 = importances.iter().map(|&x| f64::from(x)).sum();
            assert_eq!(total.sum, sum as f32);
            for even in EVEN {
                let all: f64 = importances.iter().map(|&x| f64::from(total.probability(x, even))).sum();
                assert!((all - 1.0).abs() < 1.2e-7, "{count} lights over {decades} decades: {all}");
            }
        }
    }
}

#[test]
fn each_light_has_one_interval_of_the_random_number() {
    let mut random = Random(23);
    for count in [2, 10, 100] {
        let importances = importances(count, 2.0, &mut random);
        let total = Total::of(&importances);
        for even in EVEN {
            let mut last = Choice { index: 0, probability: 0.0, rest: 0.0 };
            let mut start = vec![f64::NAN; count];
            const STEPS: u32 = 1 << 16;
            for step in 0..=STEPS {
                let u = step as f32 / STEPS as f32;
                let choice = total.choose(&importances, even, u);
                let Choice { index, probability, rest } = choice;
                assert!(
                    index > last.index || index == last.index && rest >= last.rest,
                    "{choice:?} after {last:?}"
                );
                // The rest is a place in the interval: where it begins is the same for all that is in it.
                let begin = f64::from(u) - f64::from(probability) * f64::from(rest);
                assert!(start[index].is_nan() || (begin - start[index]).abs() < 1e-6);
                start[index] = begin;
                last = choice;
            }
            let is_last =
                |&(i, x): &(usize, &f32)| *x > 0.0 && importances[i + 1..].iter().all(|&y| y == 0.0);
            assert_eq!(Some(last.index), importances.iter().enumerate().find(is_last).map(|(i, _)| i));
        }
    }
}

/// Ten lights, of which some are hidden, and 16 strata: the error of a mean, beside that of independent numbers.
#[test]
fn strata_survive_the_choice() {
    let mut random = Random(24);
    let importances = importances(10, 1.0, &mut random);
    let total = Total::of(&importances);
    let even = 0.02;
    const STRATA: usize = 16;
    let mut deviation = |is_stratified: bool| {
        let (mut sum, mut square) = (0.0, 0.0);
        const TRIALS: usize = 20_000;
        for _ in 0..TRIALS {
            let mut mean = 0.0;
            for stratum in 0..STRATA {
                let inner = random.unit();
                let u = if is_stratified { (stratum as f64 + inner) / STRATA as f64 } else { inner };
                let Choice { index, probability, rest } = total.choose(&importances, even, u as f32);
                let is_seen = index % 3 != 0;
                let weight = f64::from(importances[index] / total.sum / probability);
                mean += weight * f64::from(u8::from(is_seen)) * f64::from(0.5 + rest) / STRATA as f64;
            }
            (sum, square) = (sum + mean, square + mean * mean);
        }
        let mean = sum / TRIALS as f64;
        (square / TRIALS as f64 - mean * mean).sqrt()
    };
    let [independent, stratified] = [deviation(false), deviation(true)];
    println!("deviation {stratified} with strata, {independent} without");
    assert!(stratified < 0.6 * independent, "{stratified} and {independent}");
}

#[test]
fn one_light_is_as_if_there_were_no_choice() {
    let mut random = Random(25);
    for _ in 0..10_000 {
        let importance = f32::from_bits((random.bits() % 0x7f80_0000).max(1) as u32);
        let before = (random.bits() % 20) as usize;
        let mut importances = vec![0.0; before + (random.bits() % 20) as usize + 1];
        importances[before] = importance;
        let total = Total::of(&importances);
        assert_eq!(total.lit, 1);
        for u in [0.0, 1e-45, random.unit() as f32, 1.0_f32.next_down(), 1.0] {
            let even = EVEN[random.bits() as usize % EVEN.len()];
            let Choice { index, probability, rest } = total.choose(&importances, even, u);
            assert_eq!((index, probability, rest.to_bits()), (before, 1.0, u.to_bits()));
            assert_eq!(total.probability(importance, even), 1.0);
        }
    }
}

#[test]
fn nothing_is_chosen_where_nothing_is_lit() {
    for importances in [&[][..], &[0.0; 1], &[0.0; 40], &[-1.0, f32::NAN, -0.0, f32::NEG_INFINITY]] {
        let total = Total::of(importances);
        assert_eq!(total, Total { sum: 0.0, lit: 0 });
        for u in [0.0, 0.5, 1.0] {
            assert_eq!(total.choose(importances, 0.02, u), Choice::default());
        }
        assert_eq!(total.probability(1.0, 0.02), 0.0);
    }
}

/// Importances of any bits, as callers may add them: the probabilities still are some, and only what is positive is chosen.
#[test]
fn no_importance_makes_a_probability_wrong() {
    let mut random = Random(26);
    let hard = [f32::INFINITY, f32::MAX, 1e29, f32::NAN, -1.0, f32::NEG_INFINITY, 1e-45, f32::MIN_POSITIVE];
    for trial in 0..20_000 {
        let one = |i: usize| match (trial + i) % 3 {
            0 => hard[random.bits() as usize % hard.len()],
            _ => f32::from_bits(random.bits() as u32),
        };
        let importances: Vec<f32> = (0..1 + trial % 40).map(one).collect();
        let total = Total::of(&importances);
        assert!(total.sum.is_finite());
        let even = EVEN[trial % EVEN.len()];
        let probabilities = importances.iter().map(|&x| f64::from(total.probability(x, even)));
        let all: f64 = probabilities.inspect(|p| assert!((0.0..=1.0).contains(p))).sum();
        let is_any = importances.iter().any(|&x| x > 0.0);
        assert!(if is_any { (all - 1.0).abs() < 1.2e-7 } else { all == 0.0 }, "{all}: {importances:?}");
        for u in [f32::NAN, -1.0, 0.0, 0.3, 1.0, 2.0, f32::INFINITY] {
            let choice = total.choose(&importances, even, u);
            assert!((0.0..=1.0).contains(&choice.rest));
            assert!(!is_any || importances[choice.index] > 0.0);
            let clamped = total.choose(&importances, even, if u > 0.0 { u.min(1.0) } else { 0.0 });
            assert_eq!(choice, clamped);
        }
    }
    // A part outside [0, 1] is the nearer end, in both functions.
    let total = Total::of(&[3.0, 1.0]);
    for (even, expected) in [(f32::NAN, 0.75), (-2.0, 0.75), (2.0, 0.5)] {
        assert_eq!(total.probability(3.0, even), expected);
        assert_eq!(total.choose(&[3.0, 1.0], even, 0.0).probability, expected);
    }
}

/// Lights above, cut, below, around the point, too strong to be true and none at all: samples of one at a time average to the
/// irradiance of all, by every strategy, whose samples reach both sides or one.
#[test]
fn samples_of_one_light_at_a_time_add_up_to_what_all_give() {
    let mut random = Random(27);
    // A deviation that would be noticed goes with one over the root of the trials.
    let (trials, noticed) = inputs((75_000, 0.04), (1_200_000, 0.01), (1_200_000, 0.01));
    const COUNT: usize = 24;
    let mut array = |low, high| (0..COUNT).map(|_| random.within(low, high) as f32).collect::<Vec<f32>>();
    let [x, y, z] = [array(-4.0, 4.0), array(-4.0, 4.0), array(-1.5, 3.0)];
    let (mut radius, mut strength) = (array(0.1, 1.2), array(0.0, 10.0));
    (radius[3], radius[4], strength[5], strength[6], strength[7]) =
        (f32::NAN, 50.0, 0.0, f32::INFINITY, -3.0);
    let lights = Lights { centre: Vec3::new(&x[..], &y, &z), radius: &radius, strength: &strength };
    let normal = Vec3::new(0.0, 0.0, 1.0);
    for strategy in strategies::<f32>() {
        let is_both = strategy.hemispheres == Hemispheres::Both;
        let receiver = Receiver { normal, strategy };
        for point in [[0.0, 0.0, 0.0], [2.0, -1.0, 0.1]] {
            let mut importances = [0.0; COUNT];
            let total = lights.importances(receiver, point, &mut importances).expect("a good receiver");
            let centre = |i: usize| [x[i] - point[0], y[i] - point[1], z[i] - point[2]];
            let exact: f64 = (0..COUNT)
                .filter(|&i| strength[i] > 0.0 && strength[i].is_finite())
                .map(|i| {
                    let of = |normal: [f64; 3]| {
                        let cap = Cap::new(normal, centre(i).map(f64::from), f64::from(radius[i]));
                        cap.projected_solid_angle()
                    };
                    let below = if is_both { of([0.0, 0.0, -1.0]) } else { 0.0 };
                    f64::from(strength[i]) * (of([0.0, 0.0, 1.0]) + below)
                })
                .sum();
            let (mut sum, mut square) = (0.0, 0.0);
            for _ in 0..trials {
                let Choice { index: i, probability, rest } =
                    total.choose(&importances, 0.05, random.unit() as f32);
                // A light that has set by a rounding may be chosen, and gives nothing.
                let Ok(sampler) = Sampler::prepare(receiver, centre(i), radius[i]) else { continue };
                let sample = sampler.sample(rest, random.unit() as f32);
                let cosine = sample.offset.cosine;
                let cosine = if is_both { cosine.abs() } else { cosine.max(0.0) };
                let weight =
                    f64::from(strength[i] * cosine) / f64::from(probability * sample.density.solid_angle);
                (sum, square) = (sum + weight, square + weight * weight);
            }
            let mean = sum / f64::from(trials);
            let deviation = ((square / f64::from(trials) - mean * mean) / f64::from(trials)).sqrt();
            assert!(
                (mean - exact).abs() < 4.0 * deviation,
                "{strategy:?} {point:?}: {mean}, not {exact}, to {deviation}"
            );
            assert!(4.0 * deviation < noticed * exact, "{strategy:?} {point:?}: {mean} to {deviation}");
        }
    }
}
