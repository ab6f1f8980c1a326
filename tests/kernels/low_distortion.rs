//! The maps are continuous where their parts meet: along the numbers, and as the centre crosses the horizon or the sphere starts to
//! touch it. What low-discrepancy points gain by that is measured in `tests/kernels/accuracy.rs`.

use crate::common::TECHNIQUES;
use spherecap::{Hemispheres, Offset, Receiver, Sampler, Strategy, Technique};

fn sampler(technique: Technique, s: f64, z: f64) -> Sampler<f64> {
    let x = ((1.0 - z) * (1.0 + z)).sqrt();
    let strategy = Strategy { technique, hemispheres: Hemispheres::Front, defensive: 0.0 };
    let receiver = Receiver { normal: [0.0, 0.0, 1.0].into(), strategy };
    Sampler::prepare(receiver, [x, 0.0, z], s).expect("it is above the horizon")
}

fn distance(a: Offset<f64>, b: Offset<f64>, s: f64) -> f64 {
    (a.zenith - b.zenith).hypot(a.side - b.side) / s
}

/// Neighbouring numbers give neighbouring directions, also across the chord where crescent and ellipse meet. Heights grow as
/// u0^(2/3) and the directions of the crescent's slices as sqrt(u1) at worst, next to the ends; a jump would not shrink at all.
#[test]
fn no_part_of_a_map_ends_in_a_jump() {
    for technique in TECHNIQUES {
        for s in [1e-3, 0.5, 0.99] {
            for z in [1.5, 1.0, 0.9, 0.5, 0.1, 0.0, -0.5, -0.9].map(|k: f64| (k * s).min(1.0)) {
                let sampler = sampler(technique, s, z);
                for steps in [1 << 10, 1 << 14] {
                    let at = |i: i32| f64::from(i) / f64::from(steps);
                    for fixed in [0.1, 0.5, 0.8] {
                        let mut worst = [0.0_f64; 2];
                        for i in 0..steps {
                            let along_u0 = [at(i), at(i + 1)].map(|u| sampler.sample(u, fixed).offset);
                            let along_u1 = [at(i), at(i + 1)].map(|u| sampler.sample(fixed, u).offset);
                            worst[0] = worst[0].max(distance(along_u0[0], along_u0[1], s));
                            worst[1] = worst[1].max(distance(along_u1[0], along_u1[1], s));
                        }
                        let step = 1.0 / f64::from(steps);
                        assert!(
                            worst[0] < 4.0 * step.cbrt() && worst[1] < 4.0 * step.sqrt(),
                            "{technique:?}, s = {s}, Z = {z}, {steps} steps: {worst:?}"
                        );
                    }
                }
            }
        }
    }
}

/// As the centre crosses the horizon (Z = 0) and as the cap starts to be cut (Z = s), the same numbers give the same direction. What
/// lies between is a share of the area that goes with the distance t, and so, next to the ends, t^(1/3) of the radius at most. (But
/// for that share itself: u0 above 1 - 2 t is what becomes the ellipse as the centre rises over the horizon.)
#[test]
fn no_case_starts_with_a_jump() {
    for technique in [Technique::ProjectedBounded, Technique::Projected] {
        for s in [1e-3, 0.5, 0.99] {
            for z in [0.0, s] {
                for t in [1e-3, 1e-6, 1e-9, 1e-12] {
                    let [before, after] = [-t, t].map(|t| sampler(technique, s, z + t * s));
                    for i in 0..=99 {
                        for j in 0..=100 {
                            let [u0, u1] = [i, j].map(|i| f64::from(i) / 100.0);
                            let [a, b] = [&before, &after].map(|sampler| sampler.sample(u0, u1).offset);
                            let far = distance(a, b, s);
                            assert!(
                                far < 4.0 * t.cbrt(),
                                "{technique:?}, s = {s}, Z = {z} +- {t:e} s, {u0} {u1}: {far:e}"
                            );
                        }
                    }
                }
            }
        }
    }
}
