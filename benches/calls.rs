//! The pieces of work. Scalars are timed through calls that cannot be inlined, compiled for the instructions that the C ABI would
//! choose on this CPU; a loop over inlined kernels would be vectorised. One sample is also drawn in one call with its
//! preparation and a technique that the compiler knows, as in a renderer that inlines the library: what that sample has no
//! use for is neither computed nor stored.

use crate::published::Published;
use crate::scenes::Scene;
use spherecap::batch::{Batch, Instructions, Samples};
use spherecap::{
    Density, Hemispheres, Lane, Offset, Receiver, Sample, Sampler, Scalar, Strategy, Technique, Vec3,
};
use std::hint::black_box;

/// Samples of a cap where there are many.
pub const SAMPLES: usize = 16;

/// What is timed, per call: columns of the table.
pub const TASKS: [&str; 7] =
    ["prepare", "sample", "pdf", "invert", "prepare, 1 sample", "prepare + 1 sample", "prepare + 16 samples"];

pub const TECHNIQUES: [(&str, Technique); 3] = [
    ("solid_angle", Technique::SolidAngle),
    ("projected_bounded", Technique::ProjectedBounded),
    ("projected", Technique::Projected),
];

pub fn strategy<L: Lane>(technique: Technique) -> Strategy<L> {
    Strategy { technique, hemispheres: Hemispheres::Front, defensive: L::lit(0.0) }
}

/// The published method, with its pow and with the library's cube root in its place.
pub const PUBLISHED: [&str; 2] = ["published", "published, cube root"];

/// Something to time or count: how many calls it makes, and a function that makes them.
pub struct Work<'a> {
    pub calls: usize,
    pub run: Box<dyn FnMut() + 'a>,
}

macro_rules! calls {
    ($(
        fn $name:ident$([$($generics:tt)*])?($($argument:ident: $type:ty),*) $(-> $result:ty)? $body:block
    )*) => {$(
        #[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
        #[inline(never)]
        pub unsafe fn $name$(<$($generics)*>)?($($argument: $type),*) $(-> $result)? $body
    )*};
}
calls! {
    fn prepare[F: Scalar](strategy: &Strategy<F>, scene: &[F; 7], sampler: &mut Sampler<F>) {
        let [nx, ny, nz, cx, cy, cz, radius] = *scene;
        *sampler = Sampler::new([nx, ny, nz], [cx, cy, cz], radius, *strategy);
    }
    fn prepare_and_sample[F: Scalar, const TECHNIQUE: usize](scene: &[F; 7], u0: F, u1: F) -> (Vec3<F>, F) {
        let [nx, ny, nz, cx, cy, cz, radius] = *scene;
        let strategy = strategy(TECHNIQUES[TECHNIQUE].1);
        let sample = Sample::once([nx, ny, nz], [cx, cy, cz], radius, strategy, u0, u1);
        (sample.direction, sample.density.solid_angle)
    }
    fn sample[F: Scalar](sampler: &Sampler<F>, u0: F, u1: F) -> (Vec3<F>, F) {
        let sample = sampler.sample(u0, u1);
        (sample.direction, sample.density.solid_angle)
    }
    fn pdf[F: Scalar](sampler: &Sampler<F>, offset: &Offset<F>) -> Density<F> {
        sampler.pdf(*offset)
    }
    fn invert[F: Scalar](sampler: &Sampler<F>, offset: &Offset<F>) -> [F; 2] {
        sampler.invert(*offset)
    }
    fn published_prepare(scene: &Scene, cap: &mut Published) {
        let Scene { normal, centre, radius } = *scene;
        *cap = Published::new(normal.into(), centre.into(), radius);
    }
    fn published_sample[const CUBE_ROOT: bool](cap: &Published, u0: f32, u1: f32) -> (glam::Vec3, f32) {
        cap.sample::<CUBE_ROOT>(u0, u1)
    }
    fn published_prepare_and_sample[const CUBE_ROOT: bool](scene: &Scene, u0: f32, u1: f32) -> (glam::Vec3, f32) {
        let Scene { normal, centre, radius } = *scene;
        Published::new(normal.into(), centre.into(), radius).sample::<CUBE_ROOT>(u0, u1)
    }
}

/// As [`calls!`], but the library chooses the instructions.
#[inline(never)]
pub fn batch_sample(batch: &Batch<'_>, instructions: Instructions, u: [&[f32]; 2], samples: Samples<'_>) {
    batch.sample_with(instructions, u, samples);
}

/// Inputs of the scalar calls.
pub struct Inputs<F> {
    strategy: Strategy<F>,
    scenes: Vec<[F; 7]>,
    numbers: Vec<F>,
    samplers: Vec<Sampler<F>>,
    offsets: Vec<Offset<F>>,
}

impl<F: Scalar> Inputs<F> {
    pub fn new(strategy: Strategy<F>, scenes: &[Scene], numbers: &[f32]) -> Self {
        let lane = |x: &f32| F::lit(f64::from(*x));
        let numbers: Vec<F> = numbers.iter().map(lane).collect();
        let scenes = scenes.iter().map(|Scene { normal: [nx, ny, nz], centre: [cx, cy, cz], radius }| {
            [nx, ny, nz, cx, cy, cz, radius].map(lane)
        });
        let scenes: Vec<[F; 7]> = scenes.collect();
        let samplers: Vec<_> = scenes
            .iter()
            .map(|&[nx, ny, nz, cx, cy, cz, radius]| {
                let receiver = Receiver { normal: Vec3::new(nx, ny, nz), strategy };
                Sampler::prepare(receiver, [cx, cy, cz], radius).expect("the scenes are above the horizon")
            })
            .collect();
        let offsets = samplers.iter().zip(numbers.chunks_exact(2)).map(|(s, u)| s.sample(u[0], u[1]).offset);
        let offsets = offsets.collect();
        Self { strategy, scenes, numbers, samplers, offsets }
    }

    /// [`TASKS`]. Calls with a prepared cap are made [`SAMPLES`] times for each, so that it is in the cache, as it is after its
    /// preparation.
    ///
    /// # Safety
    /// The CPU has AVX2 and FMA.
    pub unsafe fn works(&self) -> Vec<Work<'_>> {
        let Self { strategy, scenes, numbers, samplers, offsets } = self;
        let u = move |i: usize, j: usize| {
            let k = 2 * ((i + j * 61) % (numbers.len() / 2));
            (numbers[k], numbers[k + 1])
        };
        let with_preparation = |samples: usize| {
            let mut sampler = samplers[0];
            let run = move || {
                for (i, scene) in scenes.iter().enumerate() {
                    // SAFETY: the caller's promise.
                    unsafe { prepare(black_box(strategy), scene, &mut sampler) };
                    for j in 0..samples {
                        let (u0, u1) = u(i, j);
                        // SAFETY: the caller's promise.
                        black_box(unsafe { sample(&sampler, u0, u1) });
                    }
                }
            };
            Work { calls: scenes.len() * samples.max(1), run: Box::new(run) }
        };
        let at_once = match strategy.technique {
            Technique::SolidAngle => prepare_and_sample::<F, 0>,
            Technique::ProjectedBounded => prepare_and_sample::<F, 1>,
            Technique::Projected => prepare_and_sample::<F, 2>,
        };
        let preparing_and_sampling = move || {
            for (i, scene) in scenes.iter().enumerate() {
                let (u0, u1) = u(i, 0);
                // SAFETY: the caller's promise.
                black_box(unsafe { at_once(scene, u0, u1) });
            }
        };
        let sampling = move || {
            for (i, sampler) in samplers.iter().enumerate() {
                for j in 0..SAMPLES {
                    let (u0, u1) = u(i, j);
                    // SAFETY: the caller's promise.
                    black_box(unsafe { sample(sampler, u0, u1) });
                }
            }
        };
        let densities = move || {
            for (sampler, offset) in samplers.iter().zip(offsets) {
                for _ in 0..SAMPLES {
                    // SAFETY: the caller's promise.
                    black_box(unsafe { pdf(sampler, black_box(offset)) });
                }
            }
        };
        let inverting = move || {
            for (sampler, offset) in samplers.iter().zip(offsets) {
                for _ in 0..SAMPLES {
                    // SAFETY: the caller's promise.
                    black_box(unsafe { invert(sampler, black_box(offset)) });
                }
            }
        };
        let calls = samplers.len() * SAMPLES;
        vec![
            with_preparation(0),
            Work { calls, run: Box::new(sampling) },
            Work { calls, run: Box::new(densities) },
            Work { calls, run: Box::new(inverting) },
            with_preparation(1),
            Work { calls: scenes.len(), run: Box::new(preparing_and_sampling) },
            with_preparation(SAMPLES),
        ]
    }
}

/// The published method's [`TASKS`] but for samples and densities alone, and the inverse, which it has not.
///
/// # Safety
/// The CPU has AVX2 and FMA.
pub unsafe fn published_works<'a, const CUBE_ROOT: bool>(
    scenes: &'a [Scene],
    numbers: &'a [f32],
) -> [Work<'a>; 4] {
    let u = move |i: usize, j: usize| {
        let k = 2 * ((i + j * 61) % (numbers.len() / 2));
        (numbers[k], numbers[k + 1])
    };
    let at_once = move || {
        for (i, scene) in scenes.iter().enumerate() {
            let (u0, u1) = u(i, 0);
            // SAFETY: the caller's promise.
            black_box(unsafe { published_prepare_and_sample::<CUBE_ROOT>(scene, u0, u1) });
        }
    };
    let [none, one, many] = [0, 1, SAMPLES].map(|samples| {
        let mut cap = Published::new(scenes[0].normal.into(), scenes[0].centre.into(), scenes[0].radius);
        let run = move || {
            for (i, scene) in scenes.iter().enumerate() {
                // SAFETY: the caller's promise.
                unsafe { published_prepare(scene, &mut cap) };
                for j in 0..samples {
                    let (u0, u1) = u(i, j);
                    // SAFETY: the caller's promise.
                    black_box(unsafe { published_sample::<CUBE_ROOT>(&cap, u0, u1) });
                }
            }
        };
        Work { calls: scenes.len() * samples.max(1), run: Box::new(run) as Box<dyn FnMut()> }
    });
    [none, one, Work { calls: scenes.len(), run: Box::new(at_once) }, many]
}

/// The same caps as arrays.
pub struct Arrays {
    normal: [Vec<f32>; 3],
    centre: [Vec<f32>; 3],
    radius: Vec<f32>,
    u: [Vec<f32>; 2],
}

impl Arrays {
    pub fn new(scenes: &[Scene], numbers: &[f32]) -> Self {
        Self {
            normal: [0, 1, 2].map(|axis| scenes.iter().map(|scene| scene.normal[axis]).collect()),
            centre: [0, 1, 2].map(|axis| scenes.iter().map(|scene| scene.centre[axis]).collect()),
            radius: scenes.iter().map(|scene| scene.radius).collect(),
            u: [0, 1].map(|k| numbers.chunks_exact(2).take(scenes.len()).map(|u| u[k]).collect()),
        }
    }

    /// Preparation and one sample of each.
    pub fn work(&self, instructions: Instructions, strategy: Strategy<f32>) -> Work<'_> {
        let Self { normal, centre, radius, u } = self;
        let [normal, centre] = [normal, centre].map(|v| Vec3::from(v.each_ref().map(Vec::as_slice)));
        let batch = Batch { strategy, normal, centre, radius };
        let mut outputs = [(); 4].map(|()| vec![0.0; radius.len()]);
        let run = move || {
            let [x, y, z, pdf] = outputs.each_mut().map(|output| Some(&mut output[..]));
            let density = Density { solid_angle: pdf, projected_solid_angle: None };
            let samples = Samples { direction: Vec3::new(x, y, z), density, ..Samples::default() };
            batch_sample(&batch, instructions, u.each_ref().map(Vec::as_slice), samples);
            black_box(&outputs);
        };
        Work { calls: radius.len(), run: Box::new(run) }
    }
}
