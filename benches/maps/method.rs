//! The methods that are compared, behind one face: single precision as it runs, and what it should have given.

use crate::published::Published;
use crate::scenes::Scene;
use spherecap::{Hemispheres, Offset, Receiver, Sampler, Scalar, Strategy, Technique, Vec3};

#[derive(Clone, Copy, PartialEq)]
pub enum Method {
    Ours(Technique),
    Published,
}

pub const METHODS: [(&str, Method); 4] = [
    ("solid_angle", Method::Ours(Technique::SolidAngle)),
    ("published", Method::Published),
    ("projected_bounded", Method::Ours(Technique::ProjectedBounded)),
    ("projected", Method::Ours(Technique::Projected)),
];

/// A sample in f32: its direction and density by solid angle, and its offset where the method has one.
pub struct Drawn {
    pub direction: [f64; 3],
    pub density: f64,
    pub offset: Option<Offset<f32>>,
}

/// A cap prepared by a method in f32, beside the same map in f64.
pub struct Prepared {
    single: Single,
    pub exact: Sampler<f64>,
}

enum Single {
    Ours(Sampler<f32>),
    Published(Published),
}

fn sampler<F: Scalar>(technique: Technique, scene: &Scene) -> Option<Sampler<F>> {
    let lane = |v: [f32; 3]| Vec3::from(v.map(|x| F::lit(x.into())));
    let strategy = Strategy { technique, hemispheres: Hemispheres::Front, defensive: F::lit(0.0) };
    let receiver = Receiver { normal: lane(scene.normal), strategy };
    Sampler::prepare(receiver, lane(scene.centre), F::lit(scene.radius.into())).ok()
}

impl Prepared {
    /// None where nothing is to be seen.
    pub fn new(method: Method, scene: &Scene) -> Option<Self> {
        let (technique, single) = match method {
            Method::Ours(technique) => (technique, Single::Ours(sampler(technique, scene)?)),
            Method::Published => {
                let cap = Published::new(scene.normal.into(), scene.centre.into(), scene.radius);
                (Technique::ProjectedBounded, Single::Published(cap))
            }
        };
        Some(Self { single, exact: sampler(technique, scene)? })
    }

    pub fn sample(&self, u: [f32; 2]) -> Drawn {
        match &self.single {
            Single::Ours(sampler) => {
                let sample = sampler.sample(u[0], u[1]);
                let direction = [sample.direction.x, sample.direction.y, sample.direction.z];
                Drawn {
                    direction: direction.map(f64::from),
                    density: sample.density.solid_angle.into(),
                    offset: Some(sample.offset),
                }
            }
            Single::Published(cap) => {
                let (direction, density) = cap.sample::<false>(u[0], u[1]);
                let direction = direction.to_array().map(f64::from);
                Drawn { direction, density: density.into(), offset: None }
            }
        }
    }

    /// The sampler in f32, of ours.
    pub fn single(&self) -> Option<&Sampler<f32>> {
        match &self.single {
            Single::Ours(sampler) => Some(sampler),
            Single::Published(_) => None,
        }
    }

    /// Random numbers between the method's square and that of the exact map: the same, but that the published method goes through
    /// ellipses from the other end.
    pub fn exact_numbers(&self, [u0, u1]: [f64; 2]) -> [f64; 2] {
        match &self.single {
            Single::Published(_) if self.exact.cap().elevation_sin() > 0.0 => [1.0 - u0, u1],
            _ => [u0, u1],
        }
    }

    /// The offset of a direction that was rounded to f32, made of unit length again; NaN where it is not finite.
    pub fn exact_offset(&self, direction: [f64; 3]) -> Offset<f64> {
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
        self.exact.offset(direction.map(|x| x / length))
    }
}

/// Distance of two offsets, across the direction to the centre.
pub fn distance(a: Offset<f64>, b: Offset<f64>) -> f64 {
    (a.zenith - b.zenith).hypot(a.side - b.side)
}

pub fn widened(offset: Offset<f32>) -> Offset<f64> {
    let Offset { zenith, side, cosine } = offset;
    Offset { zenith: zenith.into(), side: side.into(), cosine: cosine.into() }
}
