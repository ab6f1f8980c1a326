//! What the tests share: caps that cover every case and every hard corner, reference rows, and random numbers.

pub mod distortion;
pub mod inputs;
pub mod quadrature;
pub mod strata;

use spherecap::{Hemispheres, Lane, Offset, Receiver, Refusal, Sampler, Scalar, Strategy, Technique, Vec3};

/// A normal, a centre and a radius, in f64 but exactly representable in f32.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    pub normal: [f64; 3],
    pub centre: [f64; 3],
    pub radius: f64,
}

pub fn lanes<L: Lane>(v: [f64; 3]) -> Vec3<L> {
    Vec3::from(v.map(L::lit))
}

impl Scene {
    pub fn prepare<F: Scalar>(&self, strategy: Strategy<F>) -> Result<Sampler<F>, Refusal> {
        let receiver = Receiver { normal: lanes(self.normal), strategy };
        Sampler::prepare(receiver, lanes::<F>(self.centre), F::lit(self.radius))
    }

    pub fn sampler<F: Scalar>(&self, strategy: Strategy<F>) -> Sampler<F> {
        self.prepare(strategy).unwrap_or_else(|refusal| panic!("{self:?}: {refusal}"))
    }

    /// A sphere whose centre is at the distance 1 and the elevation `sin = Z` in the plane of x and z.
    pub fn above_plane(s: f64, z: f64) -> Self {
        let x = ((1.0 - z) * (1.0 + z)).sqrt();
        Self { normal: [0.0, 0.0, 1.0], centre: [x, 0.0, z].map(to_f32), radius: to_f32(s) }
    }
}

fn to_f32(x: f64) -> f64 {
    f64::from(x as f32)
}

/// A small generator (splitmix64), so that tests have their own fixed numbers.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1), with the 24 bits that renderers use, so exact in f32.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 40) as f64 * (-24.0_f64).exp2()
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Uniform on the sphere, rounded to f32.
    pub fn direction(&mut self) -> [f64; 3] {
        let z = self.within(-1.0, 1.0);
        let phi = self.within(0.0, std::f64::consts::TAU);
        let r = (1.0 - z * z).sqrt();
        [r * phi.cos(), r * phi.sin(), z].map(to_f32)
    }
}

/// Cap radii s = r/d from tiny to nearly touching.
pub const RADII: [f64; 9] = [1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 0.9, 0.999, 1.0 - 1.0 / 16_777_216.0];

/// Every radius of [`RADII`] at elevations in every case that it allows: at the zenith, high, touching the horizon from
/// either side, cut, centred on the horizon, cut with the centre below, nearly set. Each with the normal along z and
/// with an oblique one.
pub fn hard_scenes(random: &mut Random) -> Vec<Scene> {
    let mut scenes = Vec::new();
    for s in RADII {
        let s = to_f32(s);
        for z in [1.0, 0.5 * (1.0 + s), s * (1.0 + 1e-6), s * (1.0 - 1e-6), 0.5 * s, 1e-3 * s] {
            scenes.push(Scene::above_plane(s, z.min(1.0)));
        }
        for z in [0.0, -1e-3 * s, -0.3 * s, -0.9 * s, -0.999 * s] {
            scenes.push(Scene::above_plane(s, z));
        }
        for z in [0.9, 0.5, 0.0, -0.5, -0.9] {
            scenes.push(oblique(random, s, z * s));
        }
    }
    scenes
}

/// A scene of this s and Z (to f32 rounding of its vectors) in a random orientation, at a random distance.
pub fn oblique(random: &mut Random, s: f64, z: f64) -> Scene {
    let normal = random.direction();
    let other = random.direction();
    let along = dot(normal, other);
    let tangent: [f64; 3] = std::array::from_fn(|i| other[i] - along * normal[i]);
    let length = dot(tangent, tangent).sqrt();
    let x = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    let d = random.within(-3.0, 3.0).exp2();
    let centre: [f64; 3] = std::array::from_fn(|i| to_f32(d * (z * normal[i] + x * tangent[i] / length)));
    Scene { normal, centre, radius: to_f32(s * dot(centre, centre).sqrt() * (1.0 - 1e-7)) }
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub const TECHNIQUES: [Technique; 3] =
    [Technique::SolidAngle, Technique::ProjectedBounded, Technique::Projected];

/// Every technique alone, and the mixtures.
pub fn strategies<F: Scalar>() -> Vec<Strategy<F>> {
    let mut all = vec![Strategy {
        technique: Technique::SolidAngle,
        hemispheres: Hemispheres::Front,
        defensive: F::lit(0.0),
    }];
    for technique in [Technique::ProjectedBounded, Technique::Projected] {
        for hemispheres in [Hemispheres::Front, Hemispheres::Both] {
            for defensive in [0.0, 0.125] {
                all.push(Strategy { technique, hemispheres, defensive: F::lit(defensive) });
            }
        }
    }
    all
}

/// An offset in f64.
pub fn widen<F: Scalar>(offset: Offset<F>) -> Offset<f64> {
    Offset { zenith: offset.zenith.into(), side: offset.side.into(), cosine: offset.cosine.into() }
}

/// The offsets that are as good as this one to precision `epsilon`: with its three numbers moved by eight units in their last
/// places, as the rounding of a sample (and of s) may have moved it. For the components that is a unit of the cap's radius
/// (they are sums over the whole cap), and for the cosine one of its own; or, where it is no coordinate of the map but
/// computed from the components, one of theirs.
pub fn neighbours(
    exact: &Sampler<f64>,
    technique: Technique,
    offset: Offset<f64>,
    epsilon: f64,
) -> [Offset<f64>; 8] {
    let s = exact.cap().radius_sin();
    let cosine_unit = match technique {
        Technique::SolidAngle => exact.cap().elevation_sin().abs() + s,
        _ => offset.cosine.abs(),
    };
    std::array::from_fn(|corner| {
        let unit = |bit: usize| if corner >> bit & 1 == 0 { 8.0 * epsilon } else { -8.0 * epsilon };
        Offset {
            zenith: offset.zenith + unit(0) * s,
            side: offset.side + unit(1) * s,
            cosine: offset.cosine + unit(2) * cosine_unit,
        }
    })
}

/// Rows of a reference file, the header left out.
pub fn rows(file: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    file.lines().skip(1).map(|line| line.split(',').collect())
}

/// A C hex float.
pub fn hex_float(text: &str) -> f64 {
    let (sign, digits) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (significand, exponent) = digits
        .strip_prefix("0x")
        .and_then(|d| d.split_once('p'))
        .unwrap_or_else(|| panic!("{text} is no hex float"));
    let (whole, fraction) = significand.split_once('.').unwrap_or((significand, ""));
    let integer = u64::from_str_radix(&format!("{whole}{fraction}"), 16).expect("hex digits") as f64;
    let exponent: i32 = exponent.parse().expect("a decimal exponent");
    sign * integer * f64::from(exponent - 4 * fraction.len() as i32).exp2()
}

/// The caps of `tests/data/caps.csv`.
pub struct ReferenceCap {
    pub id: usize,
    pub group: &'static str,
    pub case: &'static str,
    pub scene: Scene,
    pub projected_solid_angle: f64,
    pub solid_angle: f64,
}

pub fn reference_caps() -> Vec<ReferenceCap> {
    rows(include_str!("../data/caps.csv"))
        .map(|row| {
            let v: Vec<f64> = row[2..9].iter().map(|text| hex_float(text)).collect();
            let number = |text: &str| text.parse().unwrap_or(f64::NAN);
            ReferenceCap {
                id: row[0].parse().expect("an id"),
                group: row[1],
                case: row[9],
                scene: Scene { normal: [v[0], v[1], v[2]], centre: [v[3], v[4], v[5]], radius: v[6] },
                projected_solid_angle: number(row[10]),
                solid_angle: number(row[11]),
            }
        })
        .collect()
}
