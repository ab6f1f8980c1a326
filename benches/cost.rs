//! What sampling costs, beside two plain baselines: sampling by solid angle, and the published method.
//!
//! `make bench`, or `cargo bench --bench cost`. Prints tables, and writes all of them to `out/bench.json`.

#![allow(missing_docs)] // a program

mod calls;
mod json;
mod lights;
mod published;
mod report;
mod scenes;
mod timing;

use calls::{published_works, strategy, Arrays, Inputs, PUBLISHED, SAMPLES, TASKS, TECHNIQUES};
use published::Published;
use report::Row;
use scenes::{Random, Scene, CAPS, SEED};
use spherecap as lane; // as `src/math.rs` calls it
use spherecap::batch::Instructions;
use spherecap::Cap;
use timing::{median, ratio, rounds, ROUNDS};

/// The published method samples what it claims: its weights average to the projected solid angle. A bench of something else
/// would be no comparison.
fn check_published<const CUBE_ROOT: bool>(scenes: &[Scene], numbers: &[f32]) {
    let mut error = 0.0_f64;
    for scene in &scenes[..64] {
        let cap = Published::new(scene.normal.into(), scene.centre.into(), scene.radius);
        let exact = Cap::<f32>::new(scene.normal, scene.centre, scene.radius);
        let normal = glam::Vec3::from(scene.normal);
        let mut sum = 0.0;
        let pairs = numbers.chunks_exact(2);
        let count = pairs.len() as f64;
        for u in pairs {
            let (direction, density) = cap.sample::<CUBE_ROOT>(u[0], u[1]);
            sum += f64::from(normal.dot(direction) / density);
        }
        error += sum / count / f64::from(exact.projected_solid_angle()) - 1.0;
    }
    assert!((error / 64.0).abs() < 0.02, "the published method is rendered wrongly: off by {}", error / 64.0);
}

/// All rows of a set of caps.
///
/// # Safety
/// The CPU has AVX2 and FMA.
unsafe fn measure(set: &'static str, scenes: &[Scene], numbers: &[f32]) -> Vec<Row> {
    let [prepare, .., apart, one, many] = TASKS;
    let single = TECHNIQUES.map(|(_, t)| Inputs::<f32>::new(strategy(t), scenes, numbers));
    let double = TECHNIQUES.map(|(_, t)| Inputs::<f64>::new(strategy(t), scenes, numbers));
    let arrays = Arrays::new(scenes, numbers);
    let (mut names, mut works) = (Vec::new(), Vec::new());
    for ((method, _), inputs) in TECHNIQUES.iter().zip(&single) {
        names.extend(TASKS.map(|task| ("f32".to_owned(), *method, task)));
        // SAFETY: the caller's promise.
        works.extend(unsafe { inputs.works() });
    }
    for method in PUBLISHED {
        names.extend([prepare, apart, one, many].map(|task| ("f32".to_owned(), method, task)));
    }
    // SAFETY: the caller's promise.
    works.extend(unsafe { published_works::<false>(scenes, numbers) });
    // SAFETY: the caller's promise.
    works.extend(unsafe { published_works::<true>(scenes, numbers) });
    for ((method, _), inputs) in TECHNIQUES.iter().zip(&double) {
        names.extend(TASKS.map(|task| ("f64".to_owned(), *method, task)));
        // SAFETY: the caller's promise.
        works.extend(unsafe { inputs.works() });
    }
    for instructions in Instructions::ALL.into_iter().filter(|set| set.are_available()) {
        for (method, technique) in TECHNIQUES {
            names.push((instructions.to_string(), method, one));
            works.push(arrays.work(instructions, strategy(technique)));
        }
    }
    let times = rounds(&mut works);
    let row = |((lane, method, task), found): ((String, &'static str, &'static str), &Vec<f64>)| {
        // `solid_angle` in f32 comes first, with all tasks.
        let baseline = TASKS.iter().position(|&other| other == task).expect("a task");
        let (nanoseconds, ratio) = (median(found.clone()), ratio(found, &times[baseline]));
        Row { set, lane, method, task, nanoseconds, ratio }
    };
    names.into_iter().zip(&times).map(row).collect()
}

fn main() {
    if !Instructions::Avx2.are_available() {
        println!("this CPU lacks AVX2 or FMA: nothing to compare");
        return;
    }
    let mut random = Random(SEED);
    let numbers: Vec<f32> = (0..4096).map(|_| random.unit()).collect();
    println!("medians of {ROUNDS} rounds over {CAPS} caps; calls with {SAMPLES} samples: the time of one\n");
    let mut rows = Vec::new();
    for (set, scenes) in scenes::sets(&mut random) {
        check_published::<false>(&scenes, &numbers);
        check_published::<true>(&scenes, &numbers);
        // SAFETY: the CPU has them.
        let measured = unsafe { measure(set, &scenes, &numbers) };
        println!("{}", report::table(&measured, &TASKS));
        rows.extend(measured);
        if set == "mix" {
            // SAFETY: as above.
            unsafe { lights::print(set, &scenes, &numbers) };
        }
    }
    let rows = json::list(rows.iter().map(|Row { set, lane, method, task, nanoseconds, ratio }| {
        let [set, lane, method, task] = [set, &**lane, method, task].map(json::quoted);
        format!(
            "{{\"set\": {set}, \"lane\": {lane}, \"method\": {method}, \"task\": {task}, \
             \"nanoseconds\": {nanoseconds:.3}, \"ratio\": {ratio:.4}}}"
        )
    }));
    json::write_json("bench", "make bench", SEED, &[("rows", rows)]).expect("out/bench.json is writable");
    println!("all of this is in out/bench.json");
}
