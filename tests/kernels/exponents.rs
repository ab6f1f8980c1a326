//! Every exponent that r/d can have in single precision, and distances over all the scales that worlds have: the sphere at the
//! zenith, centred on the horizon, cut and nearly set; against the f64 kernel on the same inputs.

use crate::common::{dot, Scene};
use spherecap::{Cap, Refusal, Strategy};

/// Below `s^2 = MIN_POSITIVE / EPSILON` (`cap.rs`) differences of `s^2` underflow: such a sphere lights nothing.
const SMALLEST: f64 = 3.15e-16;
/// A part whose density would overflow lights nothing either.
const SMALLEST_AREA: f64 = 1e-37;

fn scenes(scale: f64) -> Vec<Scene> {
    let mut scenes = Vec::new();
    let radii = (1..=149).map(|e| f64::from(-e).exp2());
    // And every distance from the sphere that f32 knows.
    let radii = radii.chain((1..=24).map(|e| 1.0 - f64::from(-e).exp2()));
    for s in radii.flat_map(|s| [s, 1.375 * s]).filter(|&s| s < 1.0) {
        for z in [1.0, 0.5, 0.0, 0.5 * s, -0.5 * s, -0.75 * s] {
            let x = ((1.0 - z) * (1.0 + z)).sqrt();
            for (normal, centre) in
                [([0.0, 0.0, 1.0], [x, 0.0, z]), ([0.0, -1.0, 0.0], [0.6 * x, -z, -0.8 * x])]
            {
                let centre = centre.map(|c: f64| f64::from((c * scale) as f32));
                scenes.push(Scene { normal, centre, radius: f64::from((s * scale) as f32) });
            }
        }
    }
    scenes
}

#[test]
fn every_ratio_of_radius_to_distance_at_every_scale() {
    let numbers = [0.0_f32, 0.25, 0.7, 1.0 - f32::EPSILON / 2.0, 1.0];
    let (mut sampled, mut refused, mut worst) = (0, 0, 0.0_f64);
    for scale in [1e-18, 1e-12, 1e-5, 1.0, 3e4, 1e11, 1e18] {
        for scene in scenes(scale) {
            let s = scene.radius / dot(scene.centre, scene.centre).sqrt();
            // A subnormal radius was rounded to another, but is a number like any other; a radius of zero is refused.
            if scene.radius == 0.0 || s >= 1.0 {
                continue;
            }
            let exact = Cap::new(scene.normal, scene.centre, scene.radius);
            let exact = exact.projected_solid_angle();
            let sampler = match scene.prepare::<f32>(Strategy::default()) {
                Ok(sampler) => sampler,
                Err(Refusal::Invisible) if s < SMALLEST || exact < SMALLEST_AREA => {
                    refused += 1;
                    continue;
                }
                Err(refusal) => panic!("{scene:?}, s = {s:e}: {refusal}"),
            };
            let area = f64::from(sampler.cap().projected_solid_angle());
            let error = (area / exact - 1.0).abs();
            worst = if error <= worst { worst } else { error };
            assert!(error < 1e-6, "{scene:?}, s = {s:e}: the area {area:e} is off by {error:e}");
            for u in numbers.into_iter().flat_map(|a| numbers.map(|b| [a, b])) {
                let sample = sampler.sample(u[0], u[1]);
                let offset = sample.offset;
                let sin = f64::from(offset.zenith).hypot(f64::from(offset.side));
                assert!(sin <= s * (1.0 + 1e-6), "{scene:?} {u:?}: {offset:?} is outside");
                assert!(
                    offset.cosine > 0.0 && offset.cosine <= 1.0 + 2.0 * f32::EPSILON,
                    "{scene:?} {u:?}: {offset:?}"
                );
                let density = sample.density;
                assert!(density == sampler.pdf(offset), "{scene:?} {u:?}");
                for density in [density.solid_angle, density.projected_solid_angle] {
                    assert!(density > 0.0 && density.is_finite(), "{scene:?} {u:?}: {density}");
                }
                let d = f64::from(sample.distance);
                let reach = dot(scene.centre, scene.centre).sqrt();
                assert!((0.0..=reach * 1.000_001).contains(&d), "{scene:?} {u:?}: at the distance {d:e}");
                sampled += 1;
            }
        }
    }
    println!("{sampled} samples, {refused} refused, areas off by {worst:.1e} at most");
    assert!(sampled > 100_000 && refused > 1000, "{sampled} samples, {refused} refused");
}
