//! Batches give, to the bit, what the scalar sampler gives for each element alone: with every instruction set that this machine
//! has, for arrays of any length, at any address.

use crate::common::strata::{scene, STRATA};
use crate::common::{hard_scenes, lanes, reference_caps, strategies, Random, Scene, TECHNIQUES};
use spherecap::batch::{Batch, Densities, Instructions, Measures, Samples};
use spherecap::{
    Density, Hemispheres, Offset, Receiver, Refusal, Sample, Sampler, Strategy, Vec3, UNIT_TOLERANCE,
};
use std::fs;

/// The instruction sets of this machine. The kernel names what the CPU has and the system allows.
fn instruction_sets() -> Vec<Instructions> {
    let found: Vec<_> = Instructions::ALL.into_iter().filter(|set| set.are_available()).collect();
    let names: Vec<_> = found.iter().map(ToString::to_string).collect();
    println!("instruction sets exercised: {}", names.join(", "));
    if cfg!(target_os = "linux") {
        let cpu = fs::read_to_string("/proc/cpuinfo").expect("Linux describes the CPU");
        let has = |flag: &str| cpu.split_whitespace().any(|word| word == flag);
        let expected = [true, has("avx2") && has("fma"), has("avx512f")];
        let expected: Vec<_> =
            Instructions::ALL.into_iter().zip(expected).filter(|set| set.1).map(|set| set.0).collect();
        assert_eq!(found, expected, "instruction sets exercised, and those that /proc/cpuinfo names");
    }
    assert_eq!(Instructions::widest(), *found.last().expect("there is a portable one"));
    found
}

/// Every technique on each side or both, alone and in mixtures, and none.
fn all_strategies() -> Vec<Strategy<f32>> {
    let mut all = Vec::new();
    for technique in TECHNIQUES {
        for hemispheres in [Hemispheres::Front, Hemispheres::Both] {
            for defensive in [0.0, 0.125, 1.0, -0.5, f32::NAN] {
                all.push(Strategy { technique, hemispheres, defensive });
            }
        }
    }
    all
}

/// Arrays of a batch, of its random numbers, and of offsets and directions whose density is asked for.
#[derive(Default)]
struct Arrays {
    normal: [Vec<f32>; 3],
    centre: [Vec<f32>; 3],
    radius: Vec<f32>,
    u: [Vec<f32>; 2],
    offset: [Vec<f32>; 3],
    direction: [Vec<f32>; 3],
}

fn slices<const N: usize>(vectors: &[Vec<f32>; N], from: usize, to: usize) -> [&[f32]; N] {
    vectors.each_ref().map(|vector| &vector[from..to])
}

fn push(vectors: &mut [Vec<f32>], numbers: &[f32]) {
    for (vector, number) in vectors.iter_mut().zip(numbers) {
        vector.push(*number);
    }
}

impl Arrays {
    fn push(&mut self, scene: &Scene, random: &mut Random) {
        let [normal, centre] = [scene.normal, scene.centre].map(|v| v.map(|x| x as f32));
        let radius = scene.radius as f32;
        push(&mut self.normal, &normal);
        push(&mut self.centre, &centre);
        self.radius.push(radius);
        let mut number = || match random.bits() % 16 {
            0 => 0.0,
            1 => 1.0,
            _ => random.unit() as f32,
        };
        let u = [number(), number()];
        push(&mut self.u, &u);
        // Of a sample, so that there is a density; or any.
        let sampler = Sampler::prepare(Receiver::new(normal), centre, radius);
        let sample = sampler.ok().filter(|_| !random.bits().is_multiple_of(8)).map(|s| s.sample(u[0], u[1]));
        let direction = sample.map_or(random.direction().map(|x| x as f32), |s| s.direction.into());
        push(&mut self.direction, &direction);
        let any = [0, 1, 2].map(|_| random.within(-1.0, 1.0) as f32);
        let offset = sample.map_or(any, |s| [s.offset.zenith, s.offset.side, s.offset.cosine]);
        push(&mut self.offset, &offset);
    }

    fn numbers(&mut self) -> impl Iterator<Item = &mut Vec<f32>> {
        let Self { normal, centre, radius, u, offset, direction } = self;
        normal.iter_mut().chain(centre).chain([radius]).chain(u).chain(offset).chain(direction)
    }

    fn batch(&self, strategy: Strategy<f32>, from: usize, to: usize) -> Batch<'_> {
        let [normal, centre] = [&self.normal, &self.centre].map(|v| Vec3::from(slices(v, from, to)));
        Batch { strategy, normal, centre, radius: &self.radius[from..to] }
    }

    /// What the scalar sampler gives for one element, or zeros: sample, the three densities, and the measures. And for which of
    /// the five the input is bad.
    fn expected(&self, strategy: Strategy<f32>, i: usize) -> ([f32; 20], [bool; 5]) {
        let vector = |v: &[Vec<f32>; 3]| Vec3::new(v[0][i], v[1][i], v[2][i]);
        let mut numbers = [0.0; 20];
        let Vec3 { x: zenith, y: side, z: cosine } = vector(&self.offset);
        let largest = (1.0 + UNIT_TOLERANCE) as f32;
        let is_offset = [zenith, side, cosine].iter().all(|x| x.abs() <= largest);
        let direction = vector(&self.direction);
        let length = f64::from(direction.dot(direction)).sqrt();
        let is_unit = (length - 1.0).abs() <= UNIT_TOLERANCE;
        let receiver = Receiver { normal: vector(&self.normal), strategy };
        let sampler = Sampler::prepare(receiver, vector(&self.centre), self.radius[i]);
        let is_point =
            !matches!(&sampler, Err(refusal) if !matches!(refusal, Refusal::Invisible | Refusal::Inside));
        let is_good = [true, is_offset, is_unit, is_unit, true].map(|is_rest_good| is_point && is_rest_good);
        let is_bad = is_good.map(|is_good| !is_good);
        let Ok(sampler) = sampler else { return (numbers, is_bad) };
        let [u0, u1] = [self.u[0][i], self.u[1][i]];
        let Sample { offset: o, direction: w, distance, normal: n, density } = sampler.sample(u0, u1);
        let Density { solid_angle, projected_solid_angle } = density;
        assert!(solid_angle > 0.0, "a sample has a density");
        numbers[..12].copy_from_slice(&[
            o.zenith,
            o.side,
            o.cosine,
            w.x,
            w.y,
            w.z,
            distance,
            n.x,
            n.y,
            n.z,
            solid_angle,
            projected_solid_angle,
        ]);
        let pair = |density: Density<f32>| [density.solid_angle, density.projected_solid_angle];
        if is_offset {
            numbers[12..14].copy_from_slice(&pair(sampler.pdf(Offset { zenith, side, cosine })));
        }
        if is_unit {
            numbers[14..16].copy_from_slice(&pair(sampler.pdf(sampler.offset(direction))));
            numbers[16..18].copy_from_slice(&pair(sampler.pdf_in_cap(sampler.offset(direction))));
        }
        assert_eq!(numbers[14..16], pair(sampler.pdf_direction(direction)));
        assert_eq!(numbers[16..18], pair(sampler.pdf_on_sphere(direction)));
        numbers[18..].copy_from_slice(&[sampler.cap().solid_angle(), sampler.cap().projected_solid_angle()]);
        (numbers, is_bad)
    }

    /// What batches give for elements `from..to`.
    fn found(&self, set: Instructions, strategy: Strategy<f32>, from: usize, to: usize) -> Found {
        let mut results = [(); 20].map(|()| vec![CANARY; to - from + 2 * MARGIN]);
        let mut outputs = results.each_mut().map(|r| Some(&mut r[MARGIN..][..to - from])).into_iter();
        let mut next = || outputs.next().expect("there are 20");
        let samples = Samples {
            offset: Offset { zenith: next(), side: next(), cosine: next() },
            direction: Vec3::new(next(), next(), next()),
            distance: next(),
            normal: Vec3::new(next(), next(), next()),
            density: Density { solid_angle: next(), projected_solid_angle: next() },
        };
        let densities = [(); 3].map(|()| Densities { solid_angle: next(), projected_solid_angle: next() });
        let measures = Measures { solid_angle: next(), projected_solid_angle: next() };
        drop(outputs);
        let batch = self.batch(strategy, from, to);
        let [of_offset, of_direction, on_sphere] = densities;
        let [zenith, side, cosine] = slices(&self.offset, from, to);
        let direction = Vec3::from(slices(&self.direction, from, to));
        let refused = [
            batch.sample_with(set, slices(&self.u, from, to), samples),
            batch.pdf_with(set, Offset { zenith, side, cosine }, of_offset),
            batch.pdf_direction_with(set, direction, of_direction),
            batch.pdf_on_sphere_with(set, direction, on_sphere),
            batch.measures_with(set, measures),
        ];
        let numbers = results.map(|result| {
            let (before, rest) = result.split_at(MARGIN);
            let (result, after) = rest.split_at(to - from);
            assert!(before.iter().chain(after).all(|&x| x == CANARY), "written outside the array");
            result.to_vec()
        });
        Found { numbers, refused }
    }
}

struct Found {
    numbers: [Vec<f32>; 20],
    /// What each function returns.
    refused: [usize; 5],
}

/// What is around the outputs, and how much of it: more than a packet.
const CANARY: f32 = -123.0;
const MARGIN: usize = 20;

fn check(arrays: &Arrays, strategy: Strategy<f32>, from: usize, found: &Found) -> usize {
    let (mut sampled, mut refused) = (0, [0; 5]);
    for i in 0..found.numbers[0].len() {
        let (expected, is_bad) = arrays.expected(strategy, from + i);
        for (refused, is_bad) in refused.iter_mut().zip(is_bad) {
            *refused += usize::from(is_bad);
        }
        let found = found.numbers.each_ref().map(|result| result[i]);
        assert_eq!(
            found.map(f32::to_bits),
            expected.map(f32::to_bits),
            "{strategy:?}, element {}: {found:?}, not {expected:?}",
            from + i
        );
        sampled += usize::from(expected[10] > 0.0);
    }
    assert_eq!(found.refused, refused, "{strategy:?}");
    sampled
}

#[test]
fn batches_give_the_bits_of_scalars() {
    let mut random = Random(6);
    let mut arrays = Arrays::default();
    let mut scenes = hard_scenes(&mut random);
    scenes.extend(reference_caps().iter().map(|row| row.scene));
    // In an order in which neighbours have as little in common as in a renderer.
    for i in 0..20_000 {
        let scene = if i % 4 == 0 {
            scenes[random.bits() as usize % scenes.len()]
        } else {
            scene(random.bits() as usize % STRATA.len(), &mut random)
        };
        arrays.push(&scene, &mut random);
    }
    // Some of it on no surface, with normals of other lengths, and spoilt.
    let count = arrays.radius.len();
    for i in (0..count).step_by(11) {
        let factor = [0.0, 0.9995, 2.0, 1e30, 1e-42][i % 5];
        arrays.normal.iter_mut().for_each(|n| n[i] *= factor);
    }
    let bad =
        [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, 0.0, -0.0, f32::MAX, 1e-45, 1.0011, -f32::NAN];
    for (k, numbers) in arrays.numbers().enumerate() {
        for (i, number) in numbers.iter_mut().enumerate().skip(k * 7 % 31).step_by(131) {
            *number = bad[i % bad.len()];
        }
    }
    let sets = instruction_sets();
    for strategy in all_strategies() {
        let mut sampled = 0;
        for &set in &sets {
            sampled = check(&arrays, strategy, 0, &arrays.found(set, strategy, 0, count));
        }
        let is_valid = (0.0..=1.0).contains(&strategy.defensive);
        assert!(
            if is_valid { 2 * sampled > count } else { sampled == 0 },
            "{strategy:?}: {sampled} of {count}"
        );
    }
}

/// With numbers on the ends of [0, 1] and outside, and NaN.
#[test]
fn many_samples_of_one_sampler_are_those_of_one_at_a_time() {
    let mut random = Random(8);
    let mut arrays = Arrays::default();
    let scenes = hard_scenes(&mut random);
    for scene in &scenes {
        arrays.push(scene, &mut random);
    }
    arrays.u[0][3] = f32::NAN;
    arrays.u[1][4] = 2.0;
    let u = arrays.u.each_ref().map(Vec::as_slice);
    let mut sampled = 0;
    for strategy in strategies::<f32>() {
        for scene in &scenes {
            let Ok(sampler) = scene.prepare(strategy) else { continue };
            let expected: Vec<[u32; 6]> =
                u[0].iter().zip(u[1]).map(|(&u0, &u1)| bits(sampler.sample(u0, u1))).collect();
            for &set in &instruction_sets() {
                let mut results = [(); 6].map(|()| vec![CANARY; u[0].len()]);
                let [x, y, z, distance, cosine, pdf] = results.each_mut().map(|result| Some(&mut result[..]));
                let samples = Samples {
                    offset: Offset { zenith: None, side: None, cosine },
                    direction: Vec3::new(x, y, z),
                    distance,
                    density: Density { solid_angle: pdf, projected_solid_angle: None },
                    ..Samples::default()
                };
                sampler.sample_many_with(set, u, samples);
                for (i, expected) in expected.iter().enumerate() {
                    let found = results.each_ref().map(|result| result[i].to_bits());
                    assert_eq!(found, *expected, "{set}, {strategy:?}, {scene:?}: numbers {i}");
                    sampled += 1;
                }
            }
        }
    }
    assert!(sampled > 100_000, "only {sampled} samples were compared");
}

/// Of a sample, what the test above asks for.
fn bits(sample: Sample<f32>) -> [u32; 6] {
    let Sample { direction: w, distance, offset, density, .. } = sample;
    [w.x, w.y, w.z, distance, offset.cosine, density.solid_angle].map(f32::to_bits)
}

#[test]
fn any_length_at_any_address_gives_the_same_bits_and_touches_nothing_else() {
    let mut random = Random(7);
    let mut arrays = Arrays::default();
    let scenes = hard_scenes(&mut random);
    for i in 0..64 {
        arrays.push(&scenes[i * 37 % scenes.len()], &mut random);
    }
    for set in instruction_sets() {
        for length in 0..=40 {
            for from in [0, 1, 3, 8, 15] {
                let strategy = Strategy { defensive: 0.125, ..Strategy::default() };
                check(&arrays, strategy, from, &arrays.found(set, strategy, from, from + length));
            }
        }
    }
}

#[test]
fn only_what_is_wanted_is_stored() {
    let mut random = Random(8);
    let mut arrays = Arrays::default();
    (0..50).for_each(|_| arrays.push(&scene(1, &mut random), &mut random));
    let strategy = Strategy::default();
    for set in instruction_sets() {
        let Found { numbers: all, refused } = arrays.found(set, strategy, 0, 50);
        assert_eq!(refused, [0; 5]);
        let mut y = vec![CANARY; 50];
        let direction = Vec3::new(None, Some(&mut y[..]), None);
        let batch = arrays.batch(strategy, 0, 50);
        batch.sample_with(set, slices(&arrays.u, 0, 50), Samples { direction, ..Samples::default() });
        assert_eq!(y, all[4]);
    }
}

#[test]
#[should_panic(expected = "an array has 2 numbers, and the first one of the points has 3")]
fn arrays_of_different_length_are_refused() {
    let numbers = [0.5; 3];
    let three = lanes::<f32>([0.0; 3]);
    let [x, y, z] = <[f32; 3]>::from(three).map(|x| [x; 3]);
    let vector = Vec3::new(&x[..], &y, &z);
    let batch = Batch { strategy: Strategy::default(), normal: vector, centre: vector, radius: &numbers };
    batch.sample([&numbers, &numbers[..2]], Samples::default());
}
