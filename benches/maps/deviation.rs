//! How even samples are: the relative standard deviation of cosine over density, which is the noise of a diffuse surface that sees
//! the light unoccluded, and how far densities spread.

use crate::json;
use crate::method::{Method, Prepared, METHODS};
use crate::numbers::numbers;
use crate::scenes::Scene;
use spherecap::Technique;

/// Strata of each random number; samples are drawn in their middles.
const STRATA: usize = 24;

/// The middle of a stratum.
fn middle(i: usize) -> f64 {
    (i as f64 + 0.5) / STRATA as f64
}

/// Mean and standard deviation of the estimator of irradiance, cosine over density, of a radiance of 1. None where there is none.
fn moments(method: Method, scene: &Scene) -> Option<[f64; 2]> {
    let projected = Method::Ours(Technique::Projected);
    if method == Method::Ours(Technique::SolidAngle) {
        // Its samples may miss a thin crescent altogether; those of the projected technique do not.
        let exact = Prepared::new(projected, scene)?.exact;
        let cosines = (0..STRATA * STRATA)
            .map(|i| exact.sample(middle(i / STRATA), middle(i % STRATA)).offset.cosine)
            .sum::<f64>();
        let mean = exact.cap().projected_solid_angle();
        let square = exact.cap().solid_angle() * mean * cosines / (STRATA * STRATA) as f64;
        return Some([mean, (square - mean * mean).max(0.0).sqrt()]);
    }
    // In f32, as it runs.
    let prepared = Prepared::new(method, scene)?;
    let weights = (0..STRATA * STRATA).map(|i| {
        let drawn = prepared.sample([middle(i / STRATA), middle(i % STRATA)].map(|u| u as f32));
        let cosine: f64 = match drawn.offset {
            Some(offset) => offset.cosine.into(),
            None => drawn.direction.iter().zip(scene.normal).map(|(x, n)| x * f64::from(n)).sum(),
        };
        cosine / drawn.density
    });
    let weights: Vec<f64> = weights.collect();
    let count = weights.len() as f64;
    let mean = weights.iter().sum::<f64>() / count;
    let variance = weights.iter().map(|w| (w - mean).powi(2)).sum::<f64>() / count;
    Some([mean, variance.sqrt()]).filter(|_| variance.is_finite())
}

/// Largest over smallest density of the exact map.
fn spread(prepared: &Prepared) -> f64 {
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    for i in 0..STRATA * STRATA {
        let density =
            prepared.exact.sample(middle(i / STRATA), middle(i % STRATA)).density.projected_solid_angle;
        (low, high) = (low.min(density), high.max(density));
    }
    high / low
}

/// For each set and method the standard deviation of a sample of irradiance, root mean square over the caps, relative to the mean
/// irradiance; and which share of the caps gave numbers.
pub fn deviation_of_sets(sets: &[(&'static str, Vec<Scene>)]) -> String {
    let rows =
        sets.iter().flat_map(|(set, scenes)| METHODS.map(|(name, method)| (set, scenes, name, method)));
    json::list(rows.map(|(set, scenes, name, method)| {
        let found: Vec<_> = scenes.iter().filter_map(|scene| moments(method, scene)).collect();
        let count = found.len() as f64;
        let mean = found.iter().map(|[mean, _]| mean).sum::<f64>() / count;
        let rms = (found.iter().map(|[_, deviation]| deviation * deviation).sum::<f64>() / count).sqrt();
        let (relative, share) = (rms / mean, count / scenes.len() as f64);
        format!("{{\"set\": \"{set}\", \"method\": \"{name}\", \"deviation\": {relative:e}, \"finite\": {share}}}")
    }))
}

/// Maps over the centre's elevation in degrees (columns) and s = r/d (rows): each method's deviation; and for the paper's warp the
/// bound on the ratio of its densities, and the ratio that samples have.
pub fn deviation_maps() -> String {
    let (width, height) = (120, 66);
    let elevations: Vec<f64> = (0..width).map(|i| -90.0 + 180.0 * (i as f64 + 0.5) / width as f64).collect();
    let radii: Vec<f64> = (0..height).map(|i| (i as f64 + 0.5) / height as f64).collect();
    let scene = |elevation: f64, s: f64| {
        let (sine, cosine) = elevation.to_radians().sin_cos();
        Scene { normal: [0.0, 0.0, 1.0], centre: [cosine as f32, 0.0, sine as f32], radius: s as f32 }
    };
    let rows = |value: &dyn Fn(&Scene) -> f64| {
        json::list(radii.iter().map(|&s| numbers(elevations.iter().map(|&e| value(&scene(e, s))))))
    };
    let mut entries = vec![
        format!("\"elevation\": {}", numbers(elevations.iter().copied())),
        format!("\"radius\": {}", numbers(radii.iter().copied())),
    ];
    for (name, method) in METHODS {
        let value =
            |scene: &Scene| moments(method, scene).map_or(f64::NAN, |[mean, deviation]| deviation / mean);
        entries.push(format!("\"{name}\": {}", rows(&value)));
    }
    let bounded = |scene: &Scene| Prepared::new(Method::Ours(Technique::ProjectedBounded), scene);
    let bound = |scene: &Scene| bounded(scene).map_or(f64::NAN, |prepared| prepared.exact.density_bound());
    let spread = |scene: &Scene| bounded(scene).map_or(f64::NAN, |prepared| spread(&prepared));
    entries.push(format!("\"bound\": {}", rows(&bound)));
    entries.push(format!("\"spread\": {}", rows(&spread)));
    format!("{{{}}}", entries.join(", "))
}
