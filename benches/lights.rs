//! What the choice among lights costs, per light, beside a preparation and a sample of one.

use crate::calls::{strategy, Inputs, Work, TASKS, TECHNIQUES};
use crate::scenes::{Random, Scene, SEED};
use crate::timing::{median, rounds};
use spherecap::batch::Instructions;
use spherecap::lights::{Lights, Total};
use spherecap::{Receiver, Vec3};
use std::hint::black_box;

/// Calls of a work: each from another point, with another number.
const POINTS: usize = 256;

/// Prints a table: medians, beside a preparation and a sample of these caps.
///
/// # Safety
/// The CPU has AVX2 and FMA.
pub unsafe fn print(set: &str, scenes: &[Scene], numbers: &[f32]) {
    let mut random = Random(SEED);
    let mut array = |count: usize, low: f32, high: f32| -> Vec<f32> {
        (0..count).map(|_| low + (high - low) * random.unit()).collect()
    };
    let points = array(3 * POINTS, -5.0, 5.0);
    let points: Vec<[f32; 3]> = points.chunks_exact(3).map(|p| [p[0], p[1], 0.01 * p[2]]).collect();
    // Over a floor, a fifth of them cut by its plane or below it.
    const MOST: usize = 400;
    let [x, y, z] = [(-6.0, 6.0), (-6.0, 6.0), (-1.0, 4.0)].map(|(low, high)| array(MOST, low, high));
    let (radius, strength) = (array(MOST, 0.05, 0.5), array(MOST, 0.0, 10.0));

    let floor = Receiver::new([0.0, 0.0, 1.0]);
    let inputs = Inputs::<f32>::new(strategy(TECHNIQUES[2].1), scenes, numbers);
    // SAFETY: the caller's promise.
    let baseline = unsafe { inputs.works() }.swap_remove(4);
    let (mut names, mut works) = (vec![(0, format!("{} of {set}", TASKS[4]))], vec![baseline]);
    let sets: Vec<_> = Instructions::ALL.into_iter().filter(|set| set.are_available()).collect();
    for count in [1, 2, 10, 16, 100, MOST] {
        let centre = Vec3::new(&x[..count], &y[..count], &z[..count]);
        let lights = Lights { centre, radius: &radius[..count], strength: &strength[..count] };
        for &instructions in &sets {
            let (points, mut importances) = (&points, vec![0.0; count]);
            let run = move || {
                for &point in points {
                    black_box(
                        lights
                            .importances_with(instructions, black_box(floor), point, &mut importances)
                            .expect("the floor is good"),
                    );
                }
            };
            names.push((count, format!("importances, {instructions}")));
            works.push(Work { calls: POINTS, run: Box::new(run) });
        }
        let all: Vec<(Vec<f32>, Total)> = points
            .iter()
            .map(|&point| {
                let mut importances = vec![0.0; count];
                let total = lights.importances(floor, point, &mut importances).expect("the floor is good");
                (importances, total)
            })
            .collect();
        let run = move || {
            for ((importances, total), &u) in all.iter().zip(numbers) {
                black_box(total.choose(black_box(importances), 0.02, u));
            }
        };
        names.push((count, "choose".to_owned()));
        works.push(Work { calls: POINTS, run: Box::new(run) });
    }
    let times: Vec<f64> = rounds(&mut works).into_iter().map(median).collect();
    println!("lights; nanoseconds for all of them and for each, and each in per cent of the first line");
    for ((count, name), time) in names.iter().zip(&times) {
        match count {
            0 => println!("{:>4} {name:<32} {time:8.1}", ""),
            _ => {
                let each = time / *count as f64;
                println!("{count:>4} {name:<32} {time:8.1} {each:7.2} {:6.2} %", 100.0 * each / times[0]);
            }
        }
    }
}
