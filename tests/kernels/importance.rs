//! The importance of a light: a bound of what it gives, close to it, and never 0 where the kernel samples; by every instruction set
//! the same bits.

use crate::common::inputs::inputs;
use crate::common::strata::{nearly_set, scene, OCTAVES};
use crate::common::{dot, hard_scenes, lanes, reference_caps, Random, Scene, TECHNIQUES};
use spherecap::batch::{Batch, Instructions};
use spherecap::lights::{Lights, Total};
use spherecap::{Cap, Hemispheres, Receiver, Refusal, Sampler, Scalar, Strategy, Technique, Vec3};
use std::f64::consts::PI;

fn count() -> usize {
    inputs(120_000, 1_200_000, 1_200_000)
}

/// What roundings may take from an importance: 16 of half an epsilon, two thirds of them the square's of `s`.
const ROUNDING: f64 = 1e-6;
/// What is added to the elevation's sine so that rounding hides nothing.
const MARGIN: f64 = 2.0 * f32::EPSILON as f64;

/// A sphere that all but touches the point, of which any part is above the horizon, often next to nothing.
fn touching(random: &mut Random) -> Scene {
    let centre = random.direction().map(|x| f64::from((x * random.within(0.5, 2.0)) as f32));
    let d = dot(centre, centre).sqrt();
    let nearest = d as f32;
    let radius = if f64::from(nearest) < d { nearest } else { nearest.next_down() };
    let tilt = f64::from(-((random.bits() % 24) as i32)).exp2();
    let across = random.direction();
    let normal: [f64; 3] = std::array::from_fn(|i| tilt * across[i] - centre[i] / d);
    let length = dot(normal, normal).sqrt();
    Scene { normal: normal.map(|x| f64::from((x / length) as f32)), centre, radius: f64::from(radius) }
}

/// Caps near everything that goes wrong, at distances from 2^-80 to 2^120.
fn any_scene(i: usize, fixed: &[Scene], random: &mut Random) -> Scene {
    let Scene { normal, centre, radius } = match i % 11 {
        10 => touching(random),
        0 => fixed[random.bits() as usize % fixed.len()],
        1 => nearly_set((random.bits() % OCTAVES as u64) as i32, random),
        stratum => scene(stratum - 2, random),
    };
    let scale = f64::from((random.bits() % 161) as i32 - 60).exp2();
    let scaled = |x: f64| f64::from((x * scale) as f32);
    Scene { normal, centre: centre.map(scaled), radius: scaled(radius) }
}

fn fixed_scenes(random: &mut Random) -> Vec<Scene> {
    let mut scenes = hard_scenes(random);
    scenes.extend(reference_caps().iter().map(|row| row.scene));
    scenes
}

fn importance<F: Scalar>(scene: &Scene, strategy: Strategy<F>, strength: f64) -> f64 {
    let receiver = Receiver { normal: lanes(scene.normal), strategy };
    receiver.importance(lanes::<F>(scene.centre), F::lit(scene.radius), F::lit(strength)).into()
}

fn strategy<F: Scalar>(technique: Technique, hemispheres: Hemispheres, defensive: f64) -> Strategy<F> {
    Strategy { technique, hemispheres, defensive: F::lit(defensive) }
}

/// By how much an importance may exceed E / pi, for the part of the diameter that is above the horizon.
fn factor(part: f64) -> f64 {
    (0.8 / part.sqrt()).max(1.75)
}

#[test]
fn importances_bound_what_lights_give_and_are_close_to_it() {
    let mut random = Random(15);
    let fixed = fixed_scenes(&mut random);
    let (mut least, mut most, mut equal, mut cut, mut set) = (f64::INFINITY, 0.0_f64, 0, 0, 0);
    for i in 0..count() {
        let scene = any_scene(i, &fixed, &mut random);
        let exact = Cap::new(lanes::<f64>(scene.normal), lanes(scene.centre), scene.radius);
        let opposite = Cap::new(lanes::<f64>(scene.normal.map(|x| -x)), lanes(scene.centre), scene.radius);
        let s = exact.radius_sin();
        // Rounding may leave a sphere that is none.
        if exact.is_inside() || scene.normal == [0.0; 3] || scene.radius <= 0.0 {
            continue;
        }
        let given = exact.projected_solid_angle() / PI;
        let both = given + opposite.projected_solid_angle() / PI;
        let (h, d) = (dot(scene.normal, scene.centre), exact.distance());
        let part = (h + scene.radius) / (2.0 * scene.radius);

        let front = importance(&scene, strategy::<f32>(Technique::Projected, Hemispheres::Front, 0.0), 1.0);
        assert!(front >= (1.0 - ROUNDING) * given, "{front:e} of {given:e}: {scene:?}");
        if part > 0.01 && h + scene.radius > 1e-4 * d {
            let ratio = front / (given * factor(part));
            assert!(ratio <= 1.0, "{ratio} of what is allowed, {part} is above: {scene:?}");
            most = most.max(ratio);
            cut += usize::from(part < 1.0);
        }
        if h >= scene.radius {
            let error = (front - given).abs();
            // The margin, and the roundings that it is for.
            assert!(error <= s * s * 2.0 * MARGIN + ROUNDING * given, "{front:e}, not {given:e}: {scene:?}");
            equal += 1;
        }
        if h < -scene.radius - 2.0 * MARGIN * d {
            assert_eq!(front, 0.0, "{scene:?} has set");
            set += 1;
        }
        if given > 0.0 {
            least = least.min(front / given);
        }

        let of_both = importance(&scene, strategy::<f32>(Technique::Projected, Hemispheres::Both, 0.0), 1.0);
        assert!(of_both >= (1.0 - ROUNDING) * both, "{of_both:e} of {both:e}: {scene:?}");
        assert!(s < 1e-4 || of_both <= 1.75 * both, "{of_both:e} of {both:e}: {scene:?}");

        let delta = f64::from(random.unit() as f32);
        let mixed =
            importance(&scene, strategy::<f32>(Technique::ProjectedBounded, Hemispheres::Front, delta), 1.0);
        let floor = (1.0 - delta) * given + 0.5 * delta * s * s;
        assert!(mixed >= (1.0 - ROUNDING) * floor, "{mixed:e} of {floor:e}, defensive {delta}: {scene:?}");

        let omega = exact.solid_angle() / PI;
        let [low, high] = [0.5 * (1.0 - ROUNDING) * omega, (1.0 + ROUNDING) * omega];
        let in_air = importance(&Scene { normal: [0.0; 3], ..scene }, Strategy::<f32>::default(), 1.0);
        assert!((low..=high).contains(&in_air), "{in_air:e} of {omega:e}: {scene:?}");
        let plain = importance(&scene, strategy::<f32>(Technique::SolidAngle, Hemispheres::Front, 0.0), 1.0);
        assert_eq!(plain, 0.5 * in_air, "{scene:?}");

        let double = importance(&scene, strategy::<f64>(Technique::Projected, Hemispheres::Front, 0.0), 1.0);
        assert!(double >= (1.0 - 1e-13) * given, "{double:e} of {given:e} in f64: {scene:?}");
    }
    println!("from {least} of E / pi to {most} of the upper bound; {equal} above, {cut} cut, {set} set");
    assert!(equal > count() / 10 && cut > count() / 10 && set > count() / 1000);
    // The bounds are no empty promise.
    assert!(least < 1.0 && most > 0.9);
}

/// Numbers of any bits: what the kernel samples has an importance, what is no light has none, and nothing is NaN or negative.
#[test]
fn whatever_the_kernel_samples_has_an_importance() {
    let mut random = Random(16);
    let fixed = fixed_scenes(&mut random);
    let hard = [0.0, -0.0, 1e-45, f32::MIN_POSITIVE, f32::MAX, f32::INFINITY, f32::NAN, -1.0, 1.0];
    let (mut sampled, mut bad) = (0, 0);
    for i in 0..count() {
        let any = |random: &mut Random| match random.bits() % 8 {
            0 => hard[random.bits() as usize % hard.len()],
            _ => f32::from_bits(random.bits() as u32),
        };
        let Scene { normal, centre, radius } = any_scene(i, &fixed, &mut random);
        let [mut normal, mut centre] = [normal, centre].map(|v| v.map(|x| x as f32));
        let mut radius = radius as f32;
        let length = [1.0, 3.0, 1e-20, 1e30][i % 4];
        normal = normal.map(|x| x * length);
        match random.bits() % 12 {
            0 => normal[i % 3] = any(&mut random),
            1 => centre[i % 3] = any(&mut random),
            2 => centre = centre.map(|_| any(&mut random)),
            3 => radius = any(&mut random),
            _ => {}
        }
        let technique = TECHNIQUES[random.bits() as usize % 3];
        let hemispheres = [Hemispheres::Front, Hemispheres::Both][random.bits() as usize % 2];
        let defensive = [0.0, 0.0, 0.125, 1.0, 1e-45, -0.5, f32::NAN][random.bits() as usize % 7];
        let strategy = Strategy { technique, hemispheres, defensive };
        let receiver = Receiver { normal: normal.into(), strategy };
        let strength = match random.bits() % 4 {
            0 => any(&mut random),
            _ => 1.0,
        };
        let importance = receiver.importance(centre, radius, strength);
        let context = || format!("{importance:e}: {receiver:?} {centre:?} {radius:e} {strength:e}");
        assert!(importance == 0.0 || (f32::MIN_POSITIVE..=f32::MAX).contains(&importance), "{}", context());
        let is_strength = strength > 0.0 && strength.is_finite();
        let prepared = Sampler::prepare(receiver, centre, radius);
        let is_bad =
            matches!(&prepared, Err(refusal) if !matches!(refusal, Refusal::Invisible | Refusal::Inside));
        if prepared.is_ok() && is_strength {
            assert!(importance > 0.0, "{}", context());
            sampled += 1;
        }
        if is_bad || !is_strength {
            assert_eq!(importance, 0.0, "{}", context());
            bad += 1;
        }
        let [x, y, z] = centre.map(f64::from);
        if f64::from(radius) > (1.0 + 4e-6) * (x * x + y * y + z * z).sqrt() {
            assert_eq!(importance, 0.0, "inside: {}", context());
        }
    }
    assert!(sampled > count() / 4 && bad > count() / 4, "{sampled} sampled, {bad} bad");
}

#[test]
fn an_importance_is_proportional_to_the_strength_over_its_whole_range() {
    let floor = Receiver::<f32>::new([0.0, 0.0, 1.0]);
    let of = |strength| floor.importance([3.0, 0.0, 0.5], 1.0, strength);
    let one = of(1.0);
    for exponent in -110..=126 {
        let strength = (exponent as f32).exp2();
        assert_eq!(of(strength), one * strength);
    }
    assert_eq!(of(1e-45), f32::MIN_POSITIVE);
    // At the zenith, all but touched: as bright as can be.
    assert_eq!(floor.importance([0.0, 0.0, 1.0], 1.0_f32.next_down(), f32::MAX), f32::MAX);
    for strength in [0.0, -0.0, -1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(of(strength), 0.0);
    }
}

const CANARY: f32 = -123.0;
const MARGIN_OF_ARRAYS: usize = 20;

/// Calls a function with an array for its output that must not be left.
fn guarded<T>(length: usize, call: impl FnOnce(&mut [f32]) -> T) -> (Vec<f32>, T) {
    let mut memory = vec![CANARY; length + 2 * MARGIN_OF_ARRAYS];
    let result = call(&mut memory[MARGIN_OF_ARRAYS..][..length]);
    let (before, rest) = memory.split_at(MARGIN_OF_ARRAYS);
    let (numbers, after) = rest.split_at(length);
    assert!(before.iter().chain(after).all(|&x| x == CANARY), "written outside the array");
    (numbers.to_vec(), result)
}

/// Arrays of centres (x, y, z), radii and strengths, some of them bad.
fn arrays(count: usize, random: &mut Random) -> [Vec<f32>; 5] {
    let fixed = fixed_scenes(random);
    let mut arrays = [(); 5].map(|()| Vec::new());
    let bad = [f32::NAN, f32::INFINITY, -1.0, 0.0, f32::MAX, 1e-45];
    for i in 0..count {
        let Scene { centre, radius, .. } = any_scene(random.bits() as usize % 11, &fixed, random);
        let mut numbers =
            [centre[0], centre[1], centre[2], radius, random.within(0.0, 9.0)].map(|x| x as f32);
        if i % 7 == 3 {
            numbers[random.bits() as usize % 5] = bad[i / 7 % bad.len()];
        }
        arrays.iter_mut().zip(numbers).for_each(|(array, x)| array.push(x));
    }
    arrays
}

#[test]
fn packets_over_lights_and_over_points_give_the_bits_of_one_light() {
    let mut random = Random(17);
    let all = arrays(450, &mut random);
    let sets: Vec<_> = Instructions::ALL.into_iter().filter(|set| set.are_available()).collect();
    let lengths = (0..=40).chain([400]);
    for (i, length) in lengths.enumerate() {
        let from = [0, 1, 3, 8, 15][i % 5];
        let [x, y, z, radius, strength] = all.each_ref().map(|array| &array[from..][..length]);
        let technique = TECHNIQUES[i % 3];
        let hemispheres = [Hemispheres::Front, Hemispheres::Both][i / 3 % 2];
        let strategy = Strategy { technique, hemispheres, defensive: [0.0, 0.25][i / 6 % 2] };
        let normal = [random.direction(), [0.0; 3]][usize::from(i % 11 == 10)].map(|x| 3.0 * x as f32);
        let receiver = Receiver { normal: normal.into(), strategy };
        let point = random.direction().map(|x| x as f32);

        let single = |point: [f32; 3]| {
            let one = |j: usize| {
                let centre = [x[j] - point[0], y[j] - point[1], z[j] - point[2]];
                receiver.importance(centre, radius[j], strength[j])
            };
            (0..length).map(one).collect::<Vec<f32>>()
        };
        let lights = Lights { centre: Vec3::new(x, y, z), radius, strength };
        let [nx, ny, nz] = normal.map(|x| vec![x; length]);
        let batch =
            Batch { strategy, normal: Vec3::new(&nx[..], &ny, &nz), centre: Vec3::new(x, y, z), radius };
        let refused = (0..length).filter(|&j| {
            let refusal = Sampler::prepare(receiver, [x[j], y[j], z[j]], radius[j]).err();
            let is_light = matches!(refusal, None | Some(Refusal::Inside | Refusal::Invisible));
            !is_light || !(0.0..=f32::MAX).contains(&strength[j])
        });
        let refused = refused.count();
        for &set in &sets {
            let (found, total) =
                guarded(length, |out| lights.importances_with(set, receiver, point, out).expect("good"));
            assert_eq!(bits(&found), bits(&single(point)), "{set}, {length} lights");
            assert_eq!(total, Total::of(&found));
            let (found, count) = guarded(length, |out| batch.importances_with(set, strength, out));
            assert_eq!(bits(&found), bits(&single([0.0; 3])), "{set}, {length} points");
            assert_eq!(count, refused, "{set}, {length} points");
        }
    }
}

fn bits(numbers: &[f32]) -> Vec<u32> {
    numbers.iter().map(|x| x.to_bits()).collect()
}

#[test]
fn bad_receivers_are_refused() {
    let one = [1.0_f32];
    let lights = Lights { centre: Vec3::new(&one[..], &one, &one), radius: &one, strength: &one };
    let floor = Receiver::new([0.0, 0.0, 1.0]);
    let mut importances = [CANARY];
    let mut refusal = |receiver| lights.importances(receiver, [0.0; 3], &mut importances).err();
    let bad_normals = [[0.0, f32::NAN, 1.0], [f32::INFINITY, 0.0, 0.0]];
    for normal in bad_normals {
        assert_eq!(refusal(Receiver::new(normal)), Some(Refusal::Normal));
    }
    for defensive in [-0.1, 1.1, f32::NAN] {
        let strategy = Strategy { defensive, ..floor.strategy };
        assert_eq!(refusal(Receiver { strategy, ..floor }), Some(Refusal::Defensive));
    }
    assert_eq!(importances, [CANARY]);
}
