//! What sampling costs, beside two plain baselines: sampling by solid angle, and the published method. Prints ratios.
//!
//! `cargo bench --bench cost`. Each figure is the median over rounds of the ratio within a round: rounds are interleaved, so that
//! what else the machine does hits all alike. Scalars are timed through calls that cannot be inlined, compiled for the
//! instructions that the C ABI would choose on this CPU; a loop over inlined kernels would be vectorised.

#![allow(missing_docs)] // a program

mod published;

use published::Published;
use spherecap::{Cap, Hemispheres, Sample, Sampler, Strategy, Technique, Vec3};
use std::hint::black_box;
use std::time::Instant;

const CAPS: usize = 512;
const ROUNDS: usize = 301;
const SAMPLES: usize = 16;

#[derive(Clone, Copy)]
struct Scene {
    normal: [f32; 3],
    centre: [f32; 3],
    radius: f32,
}

/// splitmix64, 24 bits of it.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 40) as f32 / 16_777_216.0
    }

    fn direction(&mut self) -> glam::Vec3 {
        let z = 2.0 * self.unit() - 1.0;
        let phi = std::f32::consts::TAU * self.unit();
        let r = (1.0 - z * z).sqrt();
        glam::Vec3::new(r * phi.cos(), r * phi.sin(), z)
    }
}

/// Caps with r/d uniform in [0.02, 0.9) in a random orientation; Z/s uniform in the case.
fn scenes(case: u32, random: &mut Random) -> Vec<Scene> {
    (0..CAPS)
        .map(|_| {
            let s = 0.02 + 0.88 * random.unit();
            let z = match case {
                1 => s + (0.999 - s) * random.unit(),
                2 => s * (0.001 + 0.998 * random.unit()),
                _ => -s * (0.001 + 0.998 * random.unit()),
            };
            let normal = random.direction();
            let tangent = normal.cross(random.direction()).normalize();
            let centre = (normal * z + tangent * (1.0 - z * z).sqrt()) * (0.5 + 2.0 * random.unit());
            Scene { normal: normal.into(), centre: centre.into(), radius: s * centre.length() }
        })
        .collect()
}

/// Calls that are not inlined, and compiled for the instructions that [`main`] looks for: prepare and sample, as the C ABI
/// has them.
macro_rules! calls {
    ($(fn $name:ident($($argument:ident: $type:ty),*) $(-> $result:ty)? $body:block)*) => {$(
        #[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
        #[inline(never)]
        unsafe fn $name($($argument: $type),*) $(-> $result)? $body
    )*};
}
calls! {
    fn prepare(strategy: &Strategy<f32>, scene: &Scene, sampler: &mut Sampler<f32>) {
        let Scene { normal, centre, radius } = *scene;
        *sampler = Sampler::new(Cap::new(normal.into(), centre.into(), radius), *strategy);
    }
    fn sample(sampler: &Sampler<f32>, u0: f32, u1: f32) -> (Vec3<f32>, f32) {
        let sample = sampler.sample(u0, u1);
        (sample.direction, sample.density.solid_angle)
    }
    fn full_sample(sampler: &Sampler<f32>, u0: f32, u1: f32, out: &mut Sample<f32>) {
        *out = sampler.sample(u0, u1);
    }
    fn published_prepare(scene: &Scene, cap: &mut Published) {
        let Scene { normal, centre, radius } = *scene;
        *cap = Published::new(normal.into(), centre.into(), radius);
    }
    fn published_sample(cap: &Published, u0: f32, u1: f32) -> (glam::Vec3, f32) {
        cap.sample(u0, u1)
    }
}

/// Nanoseconds per cap for preparing and then sampling `samples` times.
fn time_ours(strategy: Strategy<f32>, scenes: &[Scene], numbers: &[f32], samples: usize, full: bool) -> f64 {
    let strategy = black_box(strategy);
    let start = Instant::now();
    // SAFETY: `main` has found the CPU's features.
    unsafe {
        let first = Cap::new(scenes[0].normal.into(), scenes[0].centre.into(), scenes[0].radius);
        let mut sampler = Sampler::new(first, strategy);
        let mut out = Sample::default();
        for (i, scene) in scenes.iter().enumerate() {
            prepare(&strategy, scene, &mut sampler);
            for j in 0..samples {
                let k = 2 * ((i + j * 61) % (numbers.len() / 2));
                if full {
                    full_sample(&sampler, numbers[k], numbers[k + 1], &mut out);
                    black_box(&out);
                } else {
                    black_box(sample(&sampler, numbers[k], numbers[k + 1]));
                }
            }
        }
    }
    start.elapsed().as_secs_f64() * 1e9 / scenes.len() as f64
}

fn time_published(scenes: &[Scene], numbers: &[f32], samples: usize) -> f64 {
    let start = Instant::now();
    // SAFETY: `main` has found the CPU's features.
    unsafe {
        let mut cap = Published::new(scenes[0].normal.into(), scenes[0].centre.into(), scenes[0].radius);
        for (i, scene) in scenes.iter().enumerate() {
            published_prepare(scene, &mut cap);
            for j in 0..samples {
                let k = 2 * ((i + j * 61) % (numbers.len() / 2));
                black_box(published_sample(&cap, numbers[k], numbers[k + 1]));
            }
        }
    }
    start.elapsed().as_secs_f64() * 1e9 / scenes.len() as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The published method samples what it claims: its weights average to the projected solid angle. A bench of something else
/// would be no comparison.
fn check_published(scenes: &[Scene], numbers: &[f32]) {
    let mut error = 0.0_f64;
    for scene in &scenes[..64] {
        let cap = Published::new(scene.normal.into(), scene.centre.into(), scene.radius);
        let exact = Cap::<f32>::new(scene.normal.into(), scene.centre.into(), scene.radius);
        let normal = glam::Vec3::from(scene.normal);
        let mut sum = 0.0;
        let pairs = numbers.chunks_exact(2);
        let count = pairs.len() as f64;
        for u in pairs {
            let (direction, density) = cap.sample(u[0], u[1]);
            sum += f64::from(normal.dot(direction) / density);
        }
        error += sum / count / f64::from(exact.projected_solid_angle()) - 1.0;
    }
    assert!((error / 64.0).abs() < 0.02, "the published method is rendered wrongly: off by {}", error / 64.0);
}

fn main() {
    #[cfg(target_arch = "x86_64")]
    if !(is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")) {
        println!("this CPU lacks AVX2 or FMA: nothing to compare");
        return;
    }
    let mut random = Random(1);
    let numbers: Vec<f32> = (0..4096).map(|_| random.unit()).collect();
    let strategy = |technique| Strategy { technique, hemispheres: Hemispheres::Front, defensive: 0.0 };
    println!("ratios of times, scalar f32, medians of {ROUNDS} rounds over {CAPS} caps");
    println!("             prepare + 1 sample        prepare + {SAMPLES} samples      prepare alone   ns");
    println!("       over: published  solid angle   published  solid angle    solid angle");
    for case in 1..=3 {
        let scenes = scenes(case, &mut random);
        check_published(&scenes, &numbers);
        for (name, technique, full) in [
            ("projected", Technique::Projected, false),
            ("projected, all of the sample", Technique::Projected, true),
            ("projected_bounded", Technique::ProjectedBounded, false),
        ] {
            let mut ratios: [Vec<f64>; 5] = Default::default();
            let mut times = Vec::new();
            for _ in 0..ROUNDS {
                let counts = [1, SAMPLES, 0];
                let ours = counts.map(|n| time_ours(strategy(technique), &scenes, &numbers, n, full));
                let plain =
                    counts.map(|n| time_ours(strategy(Technique::SolidAngle), &scenes, &numbers, n, full));
                let published = counts.map(|n| time_published(&scenes, &numbers, n));
                let all = [
                    ours[0] / published[0],
                    ours[0] / plain[0],
                    ours[1] / published[1],
                    ours[1] / plain[1],
                    ours[2] / plain[2],
                ];
                for (list, ratio) in ratios.iter_mut().zip(all) {
                    list.push(ratio);
                }
                times.push(ours[0]);
            }
            let [a, b, c, d, e] = ratios.map(median);
            println!(
                "case {case}:        {a:.2}         {b:.2}         {c:.2}         {d:.2}           {e:.2}        {:.0}   {name}",
                median(times)
            );
        }
    }
}
