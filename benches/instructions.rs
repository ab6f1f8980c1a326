//! How many instructions sampling takes: counted by Valgrind, so the same whatever else the machine does. Valgrind runs no
//! AVX-512: batches are those of AVX2.
//!
//! `make instructions`, or `cargo bench --bench instructions`. What is counted are the calls of `calls.rs`, and nothing around them.

#![allow(missing_docs)] // a program

mod calls;
mod published;
mod scenes;

use calls::{published_works, Arrays, Inputs, Work, SAMPLES, TASKS};
use scenes::{Random, CAPS, SEED};
use spherecap::batch::Instructions;
use spherecap::{Hemispheres, Strategy, Technique};
use std::env;
use std::process::{exit, Command};

/// Set when the program runs under Valgrind: what it is to do.
const CHOICE: &str = "SPHERECAP_COUNT";

const SETS: [&str; 4] = ["case 1", "case 2", "case 3", "mix"];
const METHODS: [&str; 4] = ["solid_angle", "projected_bounded", "projected", "published"];
const COLUMNS: [&str; 3] = [TASKS[4], TASKS[5], "AVX2 batch"];

/// The functions whose instructions count.
const COUNTED: [&str; 5] = [
    "*::calls::prepare",
    "*::calls::sample",
    "*::calls::published_prepare",
    "*::calls::published_sample",
    "*::arrays::avx2",
];

/// Runs one piece of work once, and prints how many calls that was.
fn run(set: usize, method: usize, column: usize) {
    let mut random = Random(SEED);
    let numbers: Vec<f32> = (0..4096).map(|_| random.unit()).collect();
    let scenes = scenes::sets(&mut random).swap_remove(set).1;
    let do_it = |mut works: Vec<Work<'_>>, index: usize| {
        (works[index].run)();
        print!("{}", works[index].calls);
    };
    let techniques = [Technique::SolidAngle, Technique::ProjectedBounded, Technique::Projected];
    let Some(&technique) = techniques.get(method) else {
        // SAFETY: `main` has found the CPU's features.
        return do_it(unsafe { published_works(&scenes, &numbers) }.into(), 1 + column);
    };
    let strategy = Strategy { technique, hemispheres: Hemispheres::Front, defensive: 0.0 };
    match column {
        2 => do_it(vec![Arrays::new(&scenes, &numbers).work(Instructions::Avx2, strategy)], 0),
        // SAFETY: `main` has found the CPU's features.
        _ => do_it(unsafe { Inputs::new(strategy, &scenes, &numbers).works() }, 4 + column),
    }
}

/// Instructions per call, counted by running this program under Valgrind.
fn count(set: usize, method: usize, column: usize) -> f64 {
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
    valgrind.args(COUNTED.map(|function| format!("--toggle-collect={function}")));
    valgrind.arg(env::current_exe().expect("programs know themselves"));
    let output = valgrind.env(CHOICE, format!("{set} {method} {column}")).output().unwrap_or_else(|error| {
        eprintln!("valgrind, which counts the instructions, does not start (is it installed?): {error}");
        exit(1);
    });
    let report = String::from_utf8_lossy(&output.stderr);
    let collected = report.split("Collected : ").nth(1).and_then(|rest| rest.split_whitespace().next());
    let collected = collected.and_then(|number| number.parse().ok()).filter(|&count: &f64| count > 0.0);
    let calls: Option<f64> = String::from_utf8_lossy(&output.stdout).parse().ok();
    let (Some(collected), Some(calls)) = (collected, calls) else {
        eprintln!("valgrind has counted nothing:\n{report}");
        exit(1);
    };
    collected / calls
}

fn main() {
    if !Instructions::Avx2.are_available() {
        println!("this CPU lacks AVX2 or FMA: nothing to compare");
        return;
    }
    if let Ok(choice) = env::var(CHOICE) {
        let numbers: Vec<usize> = choice.split(' ').map(|n| n.parse().expect("a number")).collect();
        return run(numbers[0], numbers[1], numbers[2]);
    }
    println!("instructions per call, means over {CAPS} caps; with {SAMPLES} samples: for one\n");
    for (set, name) in SETS.iter().enumerate() {
        print!("{name:<20}");
        COLUMNS.iter().for_each(|column| print!("{column:>22}"));
        println!();
        for (method, name) in METHODS.iter().enumerate() {
            print!("{name:<20}");
            let columns = if *name == "published" { 2 } else { 3 };
            (0..columns).for_each(|column| print!("{:>22.1}", count(set, method, column)));
            println!();
        }
        println!();
    }
}
