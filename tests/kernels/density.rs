//! The density against the map itself: a density is one over the area that the map gives to a unit of the square. And the
//! paper's promises on how far the density of its technique varies.

use crate::common::{dot, hard_scenes, neighbours, widen, Random, Scene, TECHNIQUES};
use spherecap::{density_bound_for_radius, Hemispheres, Receiver, Sampler, Strategy, Technique};

/// Solid angle per unit of the square around `u`, by differences of fourth order.
fn jacobian(sampler: &Sampler<f64>, u: [f64; 2], step: f64) -> f64 {
    let at = |i: usize, steps: f64| {
        let mut v = u;
        v[i] += steps * step;
        let offset = sampler.sample(v[0], v[1]).offset;
        [offset.zenith, offset.side]
    };
    let derivative = |i: usize| {
        let [far, near] = [2.0, 1.0].map(|k| {
            let (plus, minus) = (at(i, k), at(i, -k));
            [plus[0] - minus[0], plus[1] - minus[1]]
        });
        [0, 1].map(|j| (8.0 * near[j] - far[j]) / (12.0 * step))
    };
    let (d0, d1) = (derivative(0), derivative(1));
    let offset = sampler.sample(u[0], u[1]).offset;
    let towards_centre = (1.0 - offset.zenith.powi(2) - offset.side.powi(2)).sqrt();
    (d0[0] * d1[1] - d0[1] * d1[0]).abs() / towards_centre
}

/// The density times the Jacobian is one. Where the differences of two step sizes disagree (a piece of the map ends
/// between the points, or the limb is near) they are no measure, and the point is left out; few may be.
fn worst_deviation(technique: Technique, scenes: &[Scene], random: &mut Random) -> f64 {
    let strategy = Strategy { technique, ..Strategy::default() };
    let (mut worst, mut measured, mut left_out) = (0.0_f64, 0, 0);
    for scene in scenes {
        let Ok(sampler) = scene.prepare(strategy) else { continue };
        for _ in 0..300 {
            let u = [random.within(0.003, 0.997), random.within(0.003, 0.997)];
            let margin = u.iter().fold(1.0_f64, |m, &x| m.min(x).min(1.0 - x));
            let [fine, coarse] = [0.01, 0.02].map(|k| jacobian(&sampler, u, k * margin));
            if (fine / coarse - 1.0).abs() > 3e-7 {
                left_out += 1;
                continue;
            }
            let deviation = (sampler.sample(u[0], u[1]).density.solid_angle * fine - 1.0).abs();
            worst = worst.max(deviation);
            measured += 1;
        }
    }
    println!("{technique:?}: density times Jacobian deviates by {worst:.1e}; {measured} points, {left_out} left out");
    assert!(measured > 10_000 && left_out * 10 < measured, "{measured} points, {left_out} left out");
    worst
}

#[test]
fn the_density_is_that_of_the_map() {
    let mut random = Random(21);
    let scenes = hard_scenes(&mut random);
    // The marginal of the crescent is fitted to 7e-6; everything else to 5e-7 and better in f32, and to rounding in f64.
    for (technique, bound) in
        [(Technique::SolidAngle, 1e-6), (Technique::ProjectedBounded, 1e-6), (Technique::Projected, 1e-5)]
    {
        let worst = worst_deviation(technique, &scenes, &mut random);
        assert!(worst < bound, "{technique:?}: {worst:e} exceeds {bound:e}");
    }
}

/// The density that an f32 sample reports is that of the f64 map at the same numbers, so that the test above is one of both
/// precisions: to 1e-6 where it is constant. That of the warp is close to infinite at the limb of a sphere nearly touched: there
/// it is as good as an f32 offset can tell, and everywhere else good to 1e-5.
#[test]
fn single_precision_has_the_density_of_double() {
    let mut random = Random(22);
    for technique in TECHNIQUES {
        let (mut worst, mut worst_plain) = (0.0_f64, 0.0_f64);
        for scene in hard_scenes(&mut random) {
            let single = Strategy { technique, ..Strategy::default() };
            let Ok(single) = scene.prepare::<f32>(single) else { continue };
            let double = scene.sampler::<f64>(Strategy { technique, ..Strategy::default() });
            for i in 0..2000 {
                // Half of them near the limb.
                let u1 = random.unit();
                let u0 = if i % 2 == 0 { random.unit() } else { 1.0 - random.unit().powi(4) };
                let sample = single.sample(u0 as f32, u1 as f32);
                // Numbers are moved off the ends; in f64 by less.
                let [v0, v1] = [u0, u1].map(|u| f64::from(u as f32).clamp(6e-8, 1.0 - 6e-8));
                let at_same_numbers = double.sample(v0, v1).density;
                // Of a solid angle the one measure, of the others the other is what they hold constant.
                let pick = |single: f64, projected: f64| {
                    if technique == Technique::SolidAngle {
                        single
                    } else {
                        projected
                    }
                };
                let got =
                    pick(sample.density.solid_angle.into(), sample.density.projected_solid_angle.into());
                let expected = pick(at_same_numbers.solid_angle, at_same_numbers.projected_solid_angle);
                let error = (got / expected - 1.0).abs();
                let offset = widen(sample.offset);
                let at = double.pdf_in_cap(offset).projected_solid_angle;
                let mut resolution = 0.0_f64;
                if technique == Technique::ProjectedBounded {
                    for other in neighbours(&double, technique, offset, f64::from(f32::EPSILON)) {
                        let other = double.pdf_in_cap(other).projected_solid_angle;
                        resolution = resolution.max((other / at - 1.0).abs());
                    }
                }
                let target: f64 = if technique == Technique::ProjectedBounded { 1e-5 } else { 1e-6 };
                assert!(
                    error < target.max(resolution),
                    "{technique:?} {scene:?} {u0} {u1}: off by {error:e}, an offset can tell {resolution:e}"
                );
                worst = worst.max(error);
                if resolution < target {
                    worst_plain = worst_plain.max(error);
                }
            }
        }
        println!(
            "{technique:?}: f32 densities differ from f64 by {worst_plain:.1e}, at the limb by {worst:.1e}"
        );
    }
}

fn bounded(s: f64, kappa: f64) -> Sampler<f64> {
    let z = -kappa * s;
    let centre = [((1.0 - z) * (1.0 + z)).sqrt(), 0.0, z];
    let strategy =
        Strategy { technique: Technique::ProjectedBounded, hemispheres: Hemispheres::Front, defensive: 0.0 };
    let receiver = Receiver { normal: [0.0, 0.0, 1.0].into(), strategy };
    Sampler::prepare(receiver, centre, s).expect("a cap in case 3")
}

/// Equation (4), and that it is at most the bound for all caps of the radius.
#[test]
fn the_bounded_density_keeps_its_bound() {
    for i in 1..40 {
        let s = f64::from(i) / 40.0;
        for j in 0..40 {
            let sampler = bounded(s, f64::from(j) / 40.0);
            let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
            for a in 0..=24 {
                for b in 0..=24 {
                    let sample = sampler.sample(f64::from(a) / 24.0, f64::from(b) / 24.0);
                    let density = sample.density.projected_solid_angle;
                    least = least.min(density);
                    most = most.max(density);
                }
            }
            let bound = sampler.density_bound();
            let rounding = 1.0 + 1e-9;
            assert!(
                most / least <= bound * rounding,
                "s = {s}, kappa = {j}/40: {} exceeds {bound}",
                most / least
            );
            assert!(bound <= density_bound_for_radius(s) * rounding, "s = {s}, kappa = {j}/40: {bound}");
        }
    }
}

/// Section 3.4: sqrt 2 for a light at twice its radius and beyond, below two from 1.094 radii, without bound at its surface.
#[test]
fn the_conservative_bound_is_the_papers() {
    let root = 2.0_f64.sqrt();
    let mut last = root;
    for i in 1..2000 {
        let s = f64::from(i) / 2000.0;
        let bound = density_bound_for_radius(s);
        assert!(bound >= last - 1e-12, "the bound falls at s = {s}");
        if s <= 0.5 {
            assert!((bound / root - 1.0).abs() < 1e-12, "s = {s}: {bound}");
        }
        if s <= 1.0 / 1.094 {
            assert!(bound < 2.0, "s = {s}: {bound}");
        }
        // A dense grid finds nothing larger, and at most one maximum: the search cannot miss it.
        let grid: Vec<f64> = (0..1000).map(|j| bounded(s, f64::from(j) / 1000.0).density_bound()).collect();
        let largest = grid.iter().fold(0.0_f64, |m, &x| m.max(x));
        assert!(largest <= bound * (1.0 + 1e-12), "s = {s}: {largest} exceeds {bound}");
        let falls_then_rises = grid.windows(3).any(|w| w[1] < w[0] - 1e-12 && w[2] > w[1] + 1e-12);
        assert!(!falls_then_rises, "s = {s}: the bound has two maxima");
        last = bound;
    }
    assert!(density_bound_for_radius(1.0 / 1.09) > 2.0, "two is reached just inside 1.094 radii");
    assert!(density_bound_for_radius(1.0 - 1e-9) > 1e3);
}

/// Where the technique is uniform the bound is one, and that of solid-angle sampling the ratio of the extreme cosines.
#[test]
fn other_bounds() {
    for technique in TECHNIQUES {
        let strategy = Strategy { technique, ..Strategy::default() };
        let above = Scene { normal: [0.0, 0.0, 1.0], centre: [0.6, 0.0, 0.8], radius: 0.5 };
        let cut = Scene { normal: [0.0, 0.0, 1.0], centre: [0.8, 0.0, 0.1], radius: 0.5 };
        let expected = if technique == Technique::SolidAngle {
            let (centre, radius) = (0.8_f64.asin(), 0.5_f64.asin());
            [(centre + radius).sin() / (centre - radius).sin(), f64::INFINITY]
        } else {
            [1.0, 1.0]
        };
        for (scene, expected) in [above, cut].into_iter().zip(expected) {
            let length = dot(scene.centre, scene.centre).sqrt();
            assert!(length > scene.radius);
            let bound = scene.sampler::<f64>(strategy).density_bound();
            assert!(bound == expected || (bound / expected - 1.0).abs() < 1e-12, "{technique:?}: {bound}");
        }
    }
}
