//! Errors of single precision against the same maps in f64.

use crate::json;
use crate::method::{distance, widened, Drawn, Method, Prepared, METHODS};
use crate::numbers::numbers;
use crate::scenes::{Random, Scene};

/// Random numbers of each cap.
const NUMBERS: usize = 16;
/// Caps of each pixel, in random orientations.
const CAPS: usize = 8;

/// The methods that promise samples above the horizon.
const MAPPED: &[(&str, Method)] = METHODS.split_at(1).1;

/// What is mapped, and what the numbers are.
const KINDS: [&str; 5] = ["area", "density", "position", "inverse", "lost"];

/// How far outside the visible cap a sample may be before it is lost, in units of the cap's radius: what would show in a picture.
const OUTSIDE: f64 = 0.01;

/// Errors of one sample: of the density that it reports, relative, against the exact one of its own direction; of its position,
/// against the exact sample, in units of the cap's radius; of what the inverse makes of it; and whether it is of no use.
fn errors(prepared: &Prepared, u: [f32; 2]) -> [f64; 4] {
    let Drawn { direction, density, offset } = prepared.sample(u);
    let s = prepared.exact.cap().radius_sin();
    let [u0, u1] = u.map(f64::from);
    let place = offset.map_or_else(|| prepared.exact_offset(direction), widened);
    let outside = place.zenith.hypot(place.side) / s - 1.0;
    let is_inside = outside < OUTSIDE && place.cosine > -OUTSIDE * s;
    if !(is_inside && density.is_finite() && density > 0.0) {
        return [f64::NAN, f64::NAN, f64::NAN, 1.0];
    }
    let [e0, e1] = prepared.exact_numbers([u0, u1]);
    let exact = prepared.exact.sample(e0, e1);
    let position = distance(place, exact.offset) / s;
    let density = (density / prepared.exact.pdf_in_cap(place).solid_angle - 1.0).abs();
    let [v0, v1] = match (prepared.single(), offset) {
        (Some(single), Some(offset)) => single.invert(offset).map(f64::from),
        _ => prepared.exact_numbers(prepared.exact.invert(place)),
    };
    [density, position, (v0 - u0).abs().max((v1 - u1).abs()), 0.0]
}

/// A cap whose centre is at the elevation of sine z, seen from the distance 1/2 to 2, in a random orientation.
fn scene(s: f64, z: f64, random: &mut Random) -> Scene {
    let mut direction = || {
        let z = 2.0 * f64::from(random.unit()) - 1.0;
        let phi = std::f64::consts::TAU * f64::from(random.unit());
        glam::DVec3::new((1.0 - z * z).sqrt() * phi.cos(), (1.0 - z * z).sqrt() * phi.sin(), z)
    };
    let normal = direction().as_vec3();
    let exact_normal = normal.as_dvec3().normalize();
    let tangent = exact_normal.cross(direction()).normalize();
    let d = 2.0 * f64::from(random.unit()) - 1.0;
    let centre = (exact_normal * z + tangent * (1.0 - z * z).sqrt()) * d.exp2();
    let centre = centre.as_vec3();
    Scene { normal: normal.into(), centre: centre.into(), radius: (s * centre.as_dvec3().length()) as f32 }
}

/// Where a column is: from -1, where the cap sets, by 0, where its centre is on the horizon, to 1, where it touches the horizon,
/// these are Z/s; from there to 2, the zenith, the rest of Z.
fn elevation_sin(column: f64, s: f64) -> f64 {
    if column < 1.0 {
        column * s
    } else {
        s + (column - 1.0) * (1.0 - s)
    }
}

/// Maps of [`KINDS`] for each method, over columns as in [`elevation_sin`] and rows even in log(s / (1 - s)): the worst of a pixel,
/// of "lost" the share. A pixel has a number if any of its samples has one.
pub fn error_maps(random: &mut Random) -> String {
    let (width, height) = (90, 60);
    let columns: Vec<f64> = (0..width).map(|i| -1.0 + 3.0 * (i as f64 + 0.5) / width as f64).collect();
    let decades = |i: usize| -6.0 + 12.0 * (i as f64 + 0.5) / height as f64;
    let radii: Vec<f64> = (0..height).map(|i| 1.0 / (1.0 + 10.0_f64.powf(-decades(i)))).collect();
    let complements: Vec<f64> = (0..height).map(|i| 1.0 / (1.0 + 10.0_f64.powf(decades(i)))).collect();
    // [method][kind][row][column]
    let mut maps = vec![vec![vec![vec![f64::NAN; width]; height]; KINDS.len()]; MAPPED.len()];
    for (row, &s) in radii.iter().enumerate() {
        for (column, &place) in columns.iter().enumerate() {
            for _ in 0..CAPS {
                let scene = scene(s, elevation_sin(place, s), random);
                let pairs: Vec<_> = (0..NUMBERS).map(|_| [random.unit(), random.unit()]).collect();
                for ((_, method), maps) in MAPPED.iter().zip(&mut maps) {
                    let Some(prepared) = Prepared::new(*method, &scene) else { continue };
                    let mut add = |kind: usize, error: f64| {
                        let pixel = &mut maps[kind][row][column];
                        *pixel = if kind == 4 {
                            pixel.max(0.0) + error / (CAPS * NUMBERS) as f64
                        } else {
                            pixel.max(error)
                        };
                    };
                    if let Some(single) = prepared.single() {
                        let exact = prepared.exact.cap().projected_solid_angle();
                        add(0, (f64::from(single.cap().projected_solid_angle()) / exact - 1.0).abs());
                    }
                    for &u in &pairs {
                        let found = errors(&prepared, u);
                        (0..4).for_each(|kind| add(kind + 1, found[kind]));
                    }
                }
            }
        }
    }
    let mut entries = vec![
        format!("\"column\": {}", numbers(columns.into_iter())),
        format!("\"radius\": {}", numbers(radii.into_iter())),
        format!("\"radius_complement\": {}", numbers(complements.into_iter())),
        format!("\"samples\": {}", CAPS * NUMBERS),
    ];
    for ((name, _), maps) in MAPPED.iter().zip(&maps) {
        let kinds = KINDS.iter().zip(maps).map(|(kind, map)| {
            let rows = json::list(map.iter().map(|row| numbers(row.iter().copied())));
            format!("\"{kind}\": {rows}")
        });
        entries.push(format!("\"{name}\": {{{}}}", kinds.collect::<Vec<_>>().join(", ")));
    }
    format!("{{{}}}", entries.join(", "))
}

/// For each set and method the error of the inverse: what the exact inverse makes of the unit direction in f32, which is what a
/// renderer gets, against the random numbers. Root mean square and worst, and the share of samples that have one.
pub fn errors_of_sets(sets: &[(&'static str, Vec<Scene>)], random_numbers: &[f32]) -> String {
    let rows =
        sets.iter().flat_map(|(set, scenes)| METHODS.map(|(name, method)| (set, scenes, name, method)));
    json::list(rows.map(|(set, scenes, name, method)| {
        let (mut sum, mut worst, mut count, mut all) = (0.0, 0.0, 0.0, 0.0);
        for (i, scene) in scenes.iter().enumerate() {
            let Some(prepared) = Prepared::new(method, scene) else { continue };
            for j in 0..NUMBERS {
                let k = 2 * ((i + j * 61) % (random_numbers.len() / 2));
                let u = [random_numbers[k], random_numbers[k + 1]];
                let place = prepared.exact_offset(prepared.sample(u).direction);
                let [v0, v1] = prepared.exact_numbers(prepared.exact.invert(place));
                let error = (v0 - f64::from(u[0])).abs().max((v1 - f64::from(u[1])).abs());
                all += 1.0;
                if error.is_finite() {
                    (sum, worst, count) = (sum + error * error, f64::max(worst, error), count + 1.0);
                }
            }
        }
        let (rms, share): (f64, f64) = ((sum / count).sqrt(), count / all);
        format!(
            "{{\"set\": \"{set}\", \"method\": \"{name}\", \"rms\": {rms:e}, \"worst\": {worst:e}, \"finite\": {share}}}"
        )
    }))
}
