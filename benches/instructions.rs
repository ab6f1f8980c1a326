//! How many instructions sampling takes: counted one by one, so the same whatever else the machine does.
//!
//! `make instructions`, or `cargo bench --bench instructions`. Prints tables, and writes all of them to `out/instructions.json`.
//! What is counted are the calls of `calls.rs`, and nothing around them.

#![allow(missing_docs)] // a program

mod calls;
mod json;
mod published;
mod scenes;
mod steps;

use calls::{published_works, strategy, Arrays, Inputs, Work, PUBLISHED, SAMPLES, TASKS, TECHNIQUES};
use scenes::{Random, Scene, CAPS, SEED};
use spherecap as lane; // as `src/math.rs` calls it
use spherecap::batch::Instructions;
use spherecap::Strategy;
use std::io::{stdout, Write};

/// Caps that count, of each set: one step takes microseconds.
const COUNTED: usize = CAPS / 4;

/// Where the functions begin that count.
fn entries() -> [u64; 11] {
    let functions = [
        calls::prepare::<f32> as *const (),
        calls::sample::<f32> as *const (),
        calls::prepare_and_sample::<f32, 0> as *const (),
        calls::prepare_and_sample::<f32, 1> as *const (),
        calls::prepare_and_sample::<f32, 2> as *const (),
        calls::published_prepare as *const (),
        calls::published_sample::<false> as *const (),
        calls::published_sample::<true> as *const (),
        calls::published_prepare_and_sample::<false> as *const (),
        calls::published_prepare_and_sample::<true> as *const (),
        calls::batch_sample as *const (),
    ];
    functions.map(|function| function as u64)
}

/// The instructions of the batches that count.
fn batches() -> impl Iterator<Item = Instructions> {
    [Instructions::Avx2, Instructions::Avx512].into_iter().filter(|set| set.are_available())
}

/// A set's columns: preparation and one sample, and many, of scalars; and batches.
fn columns() -> Vec<(String, &'static str)> {
    let [.., apart, one, many] = TASKS;
    let batches = batches().map(|instructions| (instructions.to_string(), one));
    [apart, one, many].map(|task| ("f32".to_owned(), task)).into_iter().chain(batches).collect()
}

/// The pieces of work of [`columns`] with one technique.
///
/// # Safety
/// The CPU has AVX2 and FMA.
unsafe fn works<'a>(inputs: &'a Inputs<f32>, arrays: &'a Arrays, strategy: Strategy<f32>) -> Vec<Work<'a>> {
    // SAFETY: the caller's promise.
    let mut works = unsafe { inputs.works() }.split_off(4);
    works.extend(batches().map(|instructions| arrays.work(instructions, strategy)));
    works
}

/// Counts and prints a line of a set's table.
fn line(set: &str, method: &str, works: Vec<Work<'_>>) -> Vec<String> {
    print!("{method:<20}");
    let mut rows = Vec::new();
    for (Work { calls, mut run }, (lane, task)) in works.into_iter().zip(columns()) {
        let count = steps::count(&entries(), &mut run).expect("this program may trace its children");
        let each = count as f64 / calls as f64;
        print!("{each:>22.1}");
        stdout().flush().expect("somebody reads this");
        let [set, lane, method, task] = [set, &lane, method, task].map(json::quoted);
        rows.push(format!(
            "{{\"set\": {set}, \"lane\": {lane}, \"method\": {method}, \"task\": {task}, \"instructions\": {each:.2}}}"
        ));
    }
    println!();
    rows
}

/// Counts and prints a set's table.
///
/// # Safety
/// The CPU has AVX2 and FMA.
unsafe fn table(set: &str, scenes: &[Scene], numbers: &[f32]) -> Vec<String> {
    print!("{set:<20}");
    columns().iter().for_each(|(lane, task)| print!("{:>22}", if lane == "f32" { task } else { &lane[..] }));
    println!();
    let arrays = Arrays::new(scenes, numbers);
    let mut rows = Vec::new();
    for (method, technique) in TECHNIQUES {
        let strategy = strategy(technique);
        let inputs = Inputs::new(strategy, scenes, numbers);
        // SAFETY: the caller's promise.
        rows.extend(line(set, method, unsafe { works(&inputs, &arrays, strategy) }));
    }
    // SAFETY: the caller's promise.
    let published =
        unsafe { [published_works::<false>(scenes, numbers), published_works::<true>(scenes, numbers)] };
    for (method, [_, works @ ..]) in PUBLISHED.into_iter().zip(published) {
        rows.extend(line(set, method, works.into()));
    }
    println!();
    rows
}

fn main() {
    if !Instructions::Avx2.are_available() {
        println!("this CPU lacks AVX2 or FMA: nothing to compare");
        return;
    }
    let mut random = Random(SEED);
    let numbers: Vec<f32> = (0..4096).map(|_| random.unit()).collect();
    println!("instructions per call, means over {COUNTED} caps; with {SAMPLES} samples: for one\n");
    let mut rows = Vec::new();
    for (set, scenes) in scenes::sets(&mut random) {
        // SAFETY: the CPU has them.
        rows.extend(unsafe { table(set, &scenes[..COUNTED], &numbers) });
    }
    let rows = [("rows", json::list(rows.into_iter()))];
    json::write_json("instructions", "make instructions", SEED, &rows).expect("out is writable");
    println!("all of this is in out/instructions.json");
}
