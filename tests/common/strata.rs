//! Hard inputs by name: caps of f32 numbers in random orientation, each stratum near one thing that goes wrong. Made by exact or
//! correctly rounded operations only (no sin, cos or pow), so that they are the same on every machine.

use super::{dot, Random, Scene};

/// What of [`scene`] there is.
pub const STRATA: [(&str, &str); 8] = [
    ("small", "s from 2^-30 to 1/2, any elevation that is not below the horizon"),
    ("cut", "s from 2^-30 to 1/2, the centre within the radius of the horizon"),
    ("near the surface", "1 - s from 2^-24 to 1/2, any elevation"),
    ("near the surface, cut", "1 - s from 2^-24 to 1/2, |Z| from 2^-20 to s, on both sides"),
    ("touching from above", "Z = s (1 - t), t from 2^-24 to 1/4, on both sides of the tangent"),
    ("nearly set", "Z = -s (1 - t), t from 2^-12 to 1/4"),
    ("on the horizon", "|Z| / s from 2^-30 to 1/4, on both sides"),
    ("near the zenith", "X from 2^-30 to 1/4"),
];

fn power(random: &mut Random, low: i32, high: i32) -> f64 {
    let exponent = low + (random.bits() % (high - low) as u64) as i32;
    f64::from(exponent).exp2() * random.within(1.0, 2.0)
}

fn sign(random: &mut Random) -> f64 {
    if random.bits().is_multiple_of(2) {
        1.0
    } else {
        -1.0
    }
}

fn unit(random: &mut Random) -> [f64; 3] {
    loop {
        let v: [f64; 3] = std::array::from_fn(|_| random.within(-1.0, 1.0));
        let length2 = dot(v, v);
        if (0.01..1.0).contains(&length2) {
            return v.map(|x| x / length2.sqrt());
        }
    }
}

/// A scene of a stratum of [`STRATA`]; its parameters hold up to the rounding of the vectors to f32.
pub fn scene(stratum: usize, random: &mut Random) -> Scene {
    let s = match stratum {
        2 | 3 => 1.0 - power(random, -24, -1),
        _ => power(random, -30, -1),
    };
    let z = match stratum {
        0 => s + (1.0 - s) * random.unit(),
        1 => s * random.within(-0.99, 1.0),
        2 => random.within(-0.99 * s, 1.0),
        3 => s * power(random, -20, 0) * sign(random) * 0.5,
        4 => (s * (1.0 - sign(random) * power(random, -24, -2))).min(1.0),
        5 => -s * (1.0 - power(random, -12, -2)),
        6 => s * sign(random) * power(random, -30, -2),
        _ => {
            let x = power(random, -30, -2);
            ((1.0 - x) * (1.0 + x)).sqrt()
        }
    };
    let (normal, centre) = oriented(z, random);
    // Rounded down, or a sphere nearly touched would be one around the point.
    let radius = (s * dot(centre, centre).sqrt()) as f32;
    Scene { normal, centre, radius: f64::from(radius.next_down()) }
}

/// A normal and a centre at the elevation `sin = z` (up to their rounding to f32), in random orientation, at any distance.
fn oriented(z: f64, random: &mut Random) -> ([f64; 3], [f64; 3]) {
    let x = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    let to_f32 = |x: f64| f64::from(x as f32);
    let normal = unit(random).map(to_f32);
    let other = unit(random);
    let along = dot(normal, other) / dot(normal, normal);
    let across: [f64; 3] = std::array::from_fn(|i| other[i] - along * normal[i]);
    let length = dot(across, across).sqrt();
    let d = power(random, -20, 20);
    (normal, std::array::from_fn(|i| to_f32(d * (z * normal[i] + x * across[i] / length))))
}

/// How many of [`nearly_set`] there are: the last has s near 2^-28.
pub const OCTAVES: i32 = 28;

/// A sphere with s just below 2^-octave, down to half of it, of which 2^-43 to 2^-29 of the distance are above the horizon: whatever
/// the rounding of the centre, the radius is chosen for it, and rounded up to f32.
pub fn nearly_set(octave: i32, random: &mut Random) -> Scene {
    let s = f64::from(-octave).exp2() * random.within(0.5, 0.999);
    let (normal, centre) = oriented(-s, random);
    let least = power(random, -43, -29) * dot(centre, centre).sqrt() - dot(normal, centre);
    let nearest = least as f32;
    let radius = if f64::from(nearest) < least { nearest.next_up() } else { nearest };
    Scene { normal, centre, radius: f64::from(radius) }
}
