//! What holds for every sample, over every technique, mixture, case and hard corner, in f32 and f64.

use crate::common::{dot, hard_scenes, neighbours, oblique, strategies, widen, Random, Scene, RADII};
use spherecap::{
    Density, Hemispheres, Offset, Receiver, Refusal, Sample, Sampler, Scalar, Strategy, Technique,
};

/// Random numbers, and the corners of the unit square: both ends, and the last number below one.
fn numbers<F: Scalar>(random: &mut Random) -> Vec<[F; 2]> {
    let below_one = 1.0 - 0.5 * F::EPSILON;
    let ends = [0.0, 1e-30, 0.5 * F::EPSILON, 0.5, below_one, 1.0];
    let mut numbers: Vec<[f64; 2]> = ends.iter().flat_map(|&a| ends.map(|b| [a, b])).collect();
    numbers.extend((0..200).map(|_| [random.unit(), random.unit()]));
    numbers.into_iter().map(|pair| pair.map(F::lit)).collect()
}

fn each_sample<F: Scalar>(check: impl Fn(&Scene, Strategy<F>, &Sampler<F>, [F; 2], Sample<F>)) {
    let mut random = Random(11);
    let mut count = 0;
    for strategy in strategies::<F>() {
        let mut scenes = hard_scenes(&mut random);
        scenes.extend(RADII.map(|s| Scene { normal: [0.0; 3], ..oblique(&mut random, s, 0.3 * s) }));
        for mut scene in scenes {
            if F::SIGNIFICAND_BITS > 23 {
                // A normal of f32 precision is not of unit length to f64 precision.
                let length = dot(scene.normal, scene.normal).sqrt().max(F::MIN_POSITIVE);
                scene.normal = scene.normal.map(|x| x / length);
            }
            match scene.prepare(strategy) {
                Err(Refusal::Invisible) => {}
                Err(refusal) => panic!("{strategy:?} {scene:?}: {refusal}"),
                Ok(sampler) => {
                    for u in numbers(&mut random) {
                        check(&scene, strategy, &sampler, u, sampler.sample(u[0], u[1]));
                        count += 1;
                    }
                }
            }
        }
    }
    assert!(count > 200_000, "only {count} samples were checked");
}

macro_rules! in_both_precisions {
    ($($name:ident)*) => {$(
        mod $name {
            #[test]
            fn in_single_precision() {
                super::$name::<f32>();
            }
            #[test]
            fn in_double_precision() {
                super::$name::<f64>();
            }
        }
    )*};
}
in_both_precisions!(
    the_pdf_of_a_sample_is_the_one_it_reports
    an_empty_cap_gives_no_density
    samples_lie_in_the_cap_and_above_the_horizon
    samples_are_where_their_ray_meets_the_sphere
    direction_forms_resolve_a_few_epsilon
    inverting_a_sample_gives_its_numbers
    sampling_the_inverse_gives_the_sample
    no_unit_of_length_is_preferred
    normals_have_any_length
);

/// Bit for bit; and a density is finite and positive wherever a sample can fall.
fn the_pdf_of_a_sample_is_the_one_it_reports<F: Scalar>() {
    each_sample::<F>(|scene, strategy, sampler, u, sample| {
        let asked = sampler.pdf(sample.offset);
        assert!(asked == sample.density, "{strategy:?} {scene:?} {u:?}: {asked:?} is not {sample:?}");
        assert!(sampler.pdf_in_cap(sample.offset) == sample.density, "{strategy:?} {scene:?} {u:?}");
        for density in [sample.density.solid_angle, sample.density.projected_solid_angle] {
            let density: f64 = density.into();
            assert!(density > 0.0 && density <= F::MAX, "{strategy:?} {scene:?} {u:?}: {sample:?}");
        }
    });
}

/// In units of the cap's radius: 1e-6 in f32; in f64 1e-14, ten times the error of the fits.
fn samples_lie_in_the_cap_and_above_the_horizon<F: Scalar>() {
    each_sample::<F>(|scene, strategy, _, u, sample| {
        let [zenith, side, cosine]: [f64; 3] =
            [sample.offset.zenith.into(), sample.offset.side.into(), sample.offset.cosine.into()];
        let s = scene.radius / dot(scene.centre, scene.centre).sqrt();
        let beyond = zenith.hypot(side) / s - 1.0;
        assert!(
            beyond < (8.0 * F::EPSILON).max(1e-14),
            "{strategy:?} {scene:?} {u:?}: {beyond:e} radii outside the cap"
        );
        let covers_below = strategy.technique == Technique::SolidAngle
            || strategy.hemispheres == Hemispheres::Both
            || strategy.defensive > F::lit(0.0)
            || scene.normal == [0.0; 3];
        assert!(
            covers_below || cosine > 0.0,
            "{strategy:?} {scene:?} {u:?}: {sample:?} is below the horizon"
        );
        // A vector resolves one epsilon of its length, and the frame adds a few; next to the sphere, where the component
        // towards the centre is down to v, it comes out of a sine that leaves it epsilon / v. And a normal of a length
        // that is not quite 1 has not quite one meaning.
        let direction = <[F; 3]>::from(sample.direction).map(Into::into);
        let error = (dot(direction, scene.normal) - cosine).abs();
        let length = if scene.normal == [0.0; 3] { 1.0 } else { dot(scene.normal, scene.normal).sqrt() };
        let bound =
            8.0 * F::EPSILON + 4.0 * F::EPSILON / (1.0 - s * s).sqrt() + 2.0 * s * (length - 1.0).abs();
        assert!(error < bound, "{strategy:?} {scene:?} {u:?}: the cosine is off by {error:e}");
    });
}

/// Point + distance * direction and centre + radius * normal are one point, within a few roundings of the distance to the
/// centre; the normal looks back at the shading point.
fn samples_are_where_their_ray_meets_the_sphere<F: Scalar>() {
    each_sample::<F>(|scene, strategy, _, u, sample| {
        let direction: [f64; 3] = <[F; 3]>::from(sample.direction).map(Into::into);
        let normal: [f64; 3] = <[F; 3]>::from(sample.normal).map(Into::into);
        let distance: f64 = sample.distance.into();
        let d = dot(scene.centre, scene.centre).sqrt();
        // At the limb of a sphere nearly touched, components of the size of v come out of sines near 1.
        let s = scene.radius / d;
        let at_limb = F::EPSILON / ((1.0 - s) * (1.0 + s)).sqrt();
        for v in [direction, normal] {
            let length = dot(v, v).sqrt();
            assert!(
                (length - 1.0).abs() < 16.0 * F::EPSILON,
                "{strategy:?} {scene:?} {u:?}: length {length}"
            );
        }
        for i in 0..3 {
            let error = (distance * direction[i] - scene.centre[i] - scene.radius * normal[i]).abs() / d;
            assert!(
                error < 16.0 * F::EPSILON + 4.0 * at_limb,
                "{strategy:?} {scene:?} {u:?}: the points differ by {error:e} of the distance"
            );
        }
        assert!(
            dot(direction, normal) < 16.0 * F::EPSILON + 4.0 * at_limb,
            "{strategy:?} {scene:?} {u:?}: {sample:?}"
        );
    });
}

/// From the unit direction of a sample its offset is recovered to four epsilon, absolute: half an epsilon for each component of the
/// direction and of the frame, and the roundings of a scalar product. So is the cosine, but where the component towards the
/// centre is a square root that rounding has left with epsilon / v (see above); hence the relative error of the density by
/// solid angle, which goes with the cosine. Where those are small beside the cap nothing is lost to the horizon or the limb.
fn direction_forms_resolve_a_few_epsilon<F: Scalar>() {
    each_sample::<F>(|scene, strategy, sampler, u, sample| {
        let (exact, recovered) = (widen(sample.offset), sampler.offset(sample.direction));
        let offset = widen(recovered);
        let s = scene.radius / dot(scene.centre, scene.centre).sqrt();
        let v = ((1.0 - s) * (1.0 + s)).sqrt();
        let across = [offset.zenith - exact.zenith, offset.side - exact.side].map(f64::abs);
        assert!(
            across[0].max(across[1]) < 4.0 * F::EPSILON,
            "{strategy:?} {scene:?} {u:?}: {offset:?} is not {exact:?}"
        );
        let resolution = 8.0 * F::EPSILON + 4.0 * F::EPSILON / v;
        let cosine = (offset.cosine - exact.cosine).abs();
        assert!(cosine < resolution, "{strategy:?} {scene:?} {u:?}: {offset:?} is not {exact:?}");
        // The uniform technique by itself: its density is the cosine over the area.
        let is_plain = strategy.technique == Technique::Projected
            && strategy.hemispheres == Hemispheres::Front
            && strategy.defensive == F::lit(0.0);
        if is_plain && exact.cosine > 2.0 * resolution {
            let [density, expected]: [f64; 2] = [
                sampler.pdf_on_sphere(sample.direction).solid_angle.into(),
                sample.density.solid_angle.into(),
            ];
            let error = (density / expected - 1.0).abs();
            assert!(
                error < 2.0 * F::EPSILON + resolution / exact.cosine,
                "{strategy:?} {scene:?} {u:?}: the density of the direction is off by {error:e}"
            );
        }
    });
}

fn is_at_end<F: Scalar>(u: [F; 2]) -> bool {
    u.iter().any(|&u| u < F::lit(1e-3) || u > F::lit(1.0 - 1e-3))
}

/// What an offset of precision F can tell of its random numbers, by definition: how far the f64 inverse moves from it to
/// offsets that are as good.
///
/// To first order: along the ellipse, where `x - X v` of size `s Z` must be told from numbers that are known to epsilon s, it is
/// epsilon (1 + X s / (Z sqrt((a + v)^2 + s^4 Z^2))); along the crescent, where x is told by `1 - y^2 - z^2` and by the zenith,
/// epsilon (1 + 1 / sqrt(x^2 + Z^2)); and across the ellipse's end, where chords of half length `sqrt(2 h)` at a height of
/// `h ~ u^(2/3)` must be measured, the first divided by h. So only next to the ends of the ellipse, in ellipses of which the
/// horizon leaves little (small Z/s), and on spheres so near that v is small, is it more than 1e-5 in f32.
fn resolution<F: Scalar>(exact: &Sampler<f64>, technique: Technique, offset: Offset<F>) -> [f64; 2] {
    let offset = widen(offset);
    let at = exact.invert(offset);
    let mut moved = [0.0_f64; 2];
    for other in neighbours(exact, technique, offset, F::EPSILON) {
        let other = exact.invert(other);
        for i in 0..2 {
            moved[i] = moved[i].max((other[i] - at[i]).abs());
        }
    }
    moved
}

/// To 84 epsilon, which is 1e-5 in f32: without exception away from what [`resolution`] names, and there to what the offset can
/// tell. (Twice that: the roundings of sample and inverse add up.)
fn inverting_a_sample_gives_its_numbers<F: Scalar>() {
    let target = 84.0 * F::EPSILON;
    let [kept, missed] = [0, 0].map(std::cell::Cell::new);
    each_sample::<F>(|scene, strategy, sampler, u, sample| {
        // Two parts of a defensive mixture give one direction, and only one of them is named.
        if strategy.defensive > F::lit(0.0) {
            return;
        }
        let exact = Strategy {
            technique: strategy.technique,
            hemispheres: strategy.hemispheres,
            defensive: strategy.defensive.into(),
        };
        let exact = scene.sampler(exact);
        let resolution = resolution(&exact, strategy.technique, sample.offset);
        let inverse: [f64; 2] = sampler.invert(sample.offset).map(Into::into);
        let (s, z) = (exact.cap().radius_sin(), exact.cap().elevation_sin());
        let is_plain = strategy.hemispheres == Hemispheres::Front
            && s < 0.99
            && !(0.0..0.1 * s).contains(&z.abs())
            && (F::lit(0.01)..F::lit(0.99)).contains(&u[0]);
        for i in 0..2 {
            let error = (inverse[i] - u[i].into()).abs();
            let bound = if is_plain { target } else { target.max(2.0 * resolution[i]) };
            let count = if error < target { &kept } else { &missed };
            count.set(count.get() + 1);
            assert!(
                error < bound,
                "{strategy:?} {scene:?} {u:?}: inverted to {inverse:?}, allowed {bound:e}"
            );
        }
    });
    // The corners and edges of the square are one pair in six, and ends of the ellipse in most.
    let (kept, missed) = (kept.get(), missed.get());
    println!("{missed} of {} numbers are recovered to more than {target:.0e}", kept + missed);
    assert!(missed * 20 < kept, "{missed} of {} numbers are off by {target:e} or more", kept + missed);
}

/// The inverse names a pair of numbers that gives the direction, whichever part of a mixture it came from.
fn sampling_the_inverse_gives_the_sample<F: Scalar>() {
    each_sample::<F>(|scene, strategy, sampler, u, sample| {
        // Of a defensive sample outside the projected part's reach no number is named; at the ends parts of the map meet.
        let is_defensive = strategy.defensive > F::lit(0.0) && strategy.technique != Technique::SolidAngle;
        if is_defensive || is_at_end(u) {
            return;
        }
        let [u0, u1] = sampler.invert(sample.offset);
        let again = sampler.sample(u0, u1).offset;
        let s = scene.radius / dot(scene.centre, scene.centre).sqrt();
        let difference = |a: F, b: F| -> f64 { <F as Into<f64>>::into(a) - <F as Into<f64>>::into(b) };
        let error = difference(again.zenith, sample.offset.zenith)
            .hypot(difference(again.side, sample.offset.side))
            / s;
        // Numbers are known to epsilon. Directions vary fastest with u0 at the crescent's corner, as its cube root.
        let bound = if strategy.hemispheres == Hemispheres::Both {
            F::EPSILON.cbrt()
        } else {
            80.0 * F::EPSILON + 16.0 * F::EPSILON / (1.0 - s * s).sqrt()
        };
        assert!(
            error < bound,
            "{strategy:?} {scene:?} {u:?}: sampled again {error:e} radii away, allowed {bound:e}"
        );
    });
}

/// Every offset has a density that is a number, also one beside a crescent that is as thin as numbers are.
#[test]
fn offsets_beside_the_thinnest_crescents_have_finite_densities() {
    let normal = [0.0, -1.0, (-48.0_f32).exp2()];
    let strategy = Strategy { technique: Technique::ProjectedBounded, ..Strategy::default() };
    // A sphere that all but touches the point, with its centre all but straight below.
    let (centre, radius) = ([-5.0, 335.0, 14.0], 335.0);
    let sampler = Sampler::prepare(Receiver { normal: normal.into(), strategy }, centre, radius)
        .expect("it is visible");
    let offset = Offset { zenith: -2.905_233_6e-9, side: 4.360_559_6e-8, cosine: 0.639_939 };
    let Density { solid_angle, projected_solid_angle } = sampler.pdf(offset);
    assert!(
        solid_angle.is_finite() && projected_solid_angle.is_finite(),
        "{solid_angle} {projected_solid_angle}"
    );
}

/// Which is why a cosine is to be taken from the offset: of spheres whose top is a rounding above the floor many directions,
/// rounded, point below it. (Not where the floor's normal is an axis: there a direction's component is the rounded cosine.)
#[test]
fn rounded_directions_dip_below_the_horizon_and_cosines_do_not() {
    let mut random = Random(14);
    let mut below = 0;
    for _ in 0..100 {
        let mut scene = oblique(&mut random, 0.4, -0.4);
        // The smallest that rises above the floor.
        let depth = -dot(scene.normal, scene.centre) as f32;
        scene.radius = f32::from_bits(depth.to_bits() + 1).into();
        let sampler = scene.sampler::<f32>(Strategy::default());
        for _ in 0..100 {
            let sample = sampler.sample(random.unit() as f32, random.unit() as f32);
            assert!(sample.offset.cosine > 0.0);
            let direction = <[f32; 3]>::from(sample.direction).map(f64::from);
            below += usize::from(dot(direction, scene.normal) < 0.0);
        }
    }
    println!("{below} of 10000 directions are below the horizon");
    assert!(below > 1000, "{below}");
}

/// A normal says the same whatever its length: to the roundings of its division by it, and for lengths that differ by a power of
/// two to the bit.
fn normals_have_any_length<F: Scalar>() {
    let mut random = Random(13);
    for _ in 0..100 {
        let scene = oblique(&mut random, 0.5, 0.1);
        let length = dot(scene.normal, scene.normal).sqrt();
        let with = |factor: f64| {
            let normal = scene.normal.map(|x| x / length * factor);
            Scene { normal, ..scene }.sampler::<F>(Strategy::default())
        };
        let expected: f64 = with(1.0).cap().projected_solid_angle().into();
        for factor in [0.7, 1.01, 3.0, 0.1 * F::MAX, F::MIN_POSITIVE / F::EPSILON] {
            let [one, half] =
                [with(factor), with(0.5 * factor)].map(|sampler| sampler.sample(F::lit(0.3), F::lit(0.6)));
            assert_eq!(one, half, "{scene:?} {factor:e}");
            let found: f64 = with(factor).cap().projected_solid_angle().into();
            assert!(
                (found / expected - 1.0).abs() < 32.0 * F::EPSILON,
                "{scene:?} {factor:e}: {found} {expected}"
            );
        }
    }
}

/// A power of two as unit of length changes no bit of a direction, over the range of the type.
fn no_unit_of_length_is_preferred<F: Scalar>() {
    let mut random = Random(12);
    let largest: f64 = if F::SIGNIFICAND_BITS == 23 { 100.0 } else { 900.0 };
    for scene in hard_scenes(&mut random) {
        let Ok(sampler) = scene.prepare::<F>(Strategy::default()) else { continue };
        for exponent in [-0.9 * largest, -60.0, 60.0, largest] {
            let unit = exponent.round().exp2();
            let radius = scene.radius * unit;
            // Only normal numbers scale without rounding.
            let is_exact = |x: f64| x == 0.0 || F::lit(x).into() == x && x.abs() >= F::MIN_POSITIVE;
            if !(is_exact(radius) && scene.centre.iter().all(|x| is_exact(x * unit))) {
                continue;
            }
            let scaled = Scene { centre: scene.centre.map(|x| x * unit), radius, ..scene };
            let scaled = scaled.sampler::<F>(Strategy::default());
            for u in numbers(&mut random) {
                let (a, b) = (sampler.sample(u[0], u[1]), scaled.sample(u[0], u[1]));
                assert!(a.offset == b.offset && a.density == b.density, "{scene:?} times {unit:e}, {u:?}");
                assert!(a.distance * F::lit(unit) == b.distance, "{scene:?} times {unit:e}, {u:?}");
            }
        }
    }
}

/// A point inside or on the sphere has its own refusal, however close to the surface.
/// Also where nothing was checked before: below the horizon, inside, on the sphere, at its centre, too small to be seen.
fn an_empty_cap_gives_no_density<F: Scalar>() {
    let mut empty = 0;
    for strategy in strategies::<F>() {
        for (height, radius) in [(-2.0, 1.0), (0.5, 1.0), (1.0, 1.0), (0.0, 1.0), (1.0, F::MIN_POSITIVE)] {
            let (zero, one) = (F::lit(0.0), F::lit(1.0));
            let (normal, centre) = ([zero, zero, one], [zero, zero, F::lit(height)]);
            let sampler = Sampler::new(normal, centre, F::lit(radius), strategy);
            let sample = sampler.sample(F::lit(0.5), F::lit(0.3));
            if sampler.is_empty() {
                empty += 1;
                for density in [sample.density, sampler.pdf(sample.offset)] {
                    let none = Density { solid_angle: zero, projected_solid_angle: zero };
                    assert_eq!(density, none, "{strategy:?} {height} {radius:e}");
                }
            }
        }
    }
    assert!(empty > 30, "only {empty} caps were empty");
}

#[test]
fn points_inside_are_refused() {
    let mut random = Random(13);
    for factor in [0.0_f32, 0.5, 1.0 - f32::EPSILON, 1.0] {
        for _ in 0..100 {
            let centre = random.direction().map(|x| x as f32 * factor);
            let length2: f64 = centre.iter().map(|&x| f64::from(x) * f64::from(x)).sum();
            let radius = length2.sqrt() as f32;
            if f64::from(radius).powi(2) < length2 {
                continue;
            }
            let radius = if factor == 0.0 { 1.0 } else { radius };
            let refusal = Sampler::prepare(Receiver::new([0.0, 0.0, 1.0]), centre, radius).err();
            let expected = if factor == 0.0 { Refusal::Centre } else { Refusal::Inside };
            assert_eq!(refusal, Some(expected), "{centre:?} {radius}");
        }
    }
}
