//! The inline header in C beside the inlined Rust: instructions and times of one sample in one call with its preparation.
//!
//! `make bench-inline`, or `cargo bench --bench inline`. C is compiled by gcc and by clang, whichever the machine has, with the options
//! of docs/source.md. All check their input, and give the same bits.

#![allow(missing_docs)] // a program

#[allow(dead_code)] // other benches use all of them
mod calls;
#[allow(dead_code)]
mod published;
#[allow(dead_code)]
mod scenes;
mod steps;
#[allow(dead_code)]
mod timing;

use calls::Work;
use scenes::{Random, Scene, CAPS, SEED};
use spherecap as lane; // as `src/math.rs` calls it
use spherecap::batch::Instructions;
use spherecap::{Receiver, Sampler};
use std::ffi::CString;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use timing::{median, rounds, ROUNDS};

/// Caps that count, of each set: one step takes microseconds.
const COUNTED: usize = CAPS / 4;

/// Normal, centre and radius; two random numbers; direction and density.
type Once = unsafe extern "C" fn(*const f32, f32, f32, *mut f32);

/// What a renderer in Rust would inline.
///
/// # Safety
/// The CPU has AVX2 and FMA; the pointers are to seven and to four numbers.
#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
unsafe extern "C" fn by_rust(scene: *const f32, u0: f32, u1: f32, result: *mut f32) {
    // SAFETY: the caller's promise.
    let ([nx, ny, nz, cx, cy, cz, radius], result) =
        unsafe { (*scene.cast::<[f32; 7]>(), &mut *result.cast::<[f32; 4]>()) };
    let sample = Sampler::sample_once(Receiver::new([nx, ny, nz]), [cx, cy, cz], radius, u0, u1);
    *result = sample.map_or([0.0; 4], |sample| {
        let [x, y, z] = sample.direction.into();
        [x, y, z, sample.density.solid_angle]
    });
}

/// The function of benches/inline.c as this compiler makes it, if the machine has it.
fn by_c(compiler: &str) -> Option<Once> {
    let library = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("inline_{compiler}.so"));
    let options = [
        "-std=c99",
        "-O2",
        "-fno-math-errno",
        "-mavx2",
        "-mfma",
        "-ffp-contract=off",
        "-Ishaders",
        "-shared",
        "-fPIC",
    ];
    let mut command = Command::new(compiler);
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(options).arg("benches/inline.c").arg("-o");
    let done = command.arg(&library).arg("-lm").status().ok()?;
    assert!(done.success(), "{compiler} does not compile benches/inline.c");
    let path = CString::new(library.to_str().expect("it is text")).expect("it has no zero");
    // SAFETY: it was just made, and nothing in it runs when it is loaded; the symbol is this function's.
    unsafe {
        let symbol = libc::dlsym(libc::dlopen(path.as_ptr(), libc::RTLD_NOW), c"sample_once".as_ptr());
        assert!(!symbol.is_null(), "{compiler}'s library cannot be loaded");
        Some(std::mem::transmute::<*mut libc::c_void, Once>(symbol))
    }
}

fn run(once: Once, scenes: &[[f32; 7]], numbers: &[f32]) -> Vec<[f32; 4]> {
    let mut results = vec![[0.0; 4]; scenes.len()];
    for ((scene, u), result) in scenes.iter().zip(numbers.chunks_exact(2)).zip(&mut results) {
        // SAFETY: `main` has looked at the CPU; these are seven and four numbers.
        unsafe { once(scene.as_ptr(), u[0], u[1], result.as_mut_ptr()) };
    }
    results
}

fn main() {
    if !Instructions::Avx2.are_available() {
        println!("this CPU lacks AVX2 or FMA: nothing to compare");
        return;
    }
    let by_compilers = ["gcc", "clang"].into_iter().filter_map(|name| Some((name, by_c(name)?)));
    let methods: Vec<(&str, Once)> = [("Rust", by_rust as Once)].into_iter().chain(by_compilers).collect();
    let mut random = Random(SEED);
    let numbers: Vec<f32> = (0..2 * CAPS).map(|_| random.unit()).collect();
    println!("means over {COUNTED} caps; medians of {ROUNDS} rounds over {CAPS}\n");
    println!("{:<20}{:>12}{:>16}{:>16}", "caps", "by", "instructions", "nanoseconds");
    for (set, scenes) in scenes::sets(&mut random) {
        let flat = |Scene { normal: [nx, ny, nz], centre: [cx, cy, cz], radius }: &Scene| {
            [*nx, *ny, *nz, *cx, *cy, *cz, *radius]
        };
        let scenes: Vec<[f32; 7]> = scenes.iter().map(flat).collect();
        let expected = run(by_rust, &scenes, &numbers);
        let mut works: Vec<Work<'_>> = Vec::new();
        for &(name, once) in &methods {
            assert!(run(once, &scenes, &numbers) == expected, "{name} gives other samples than Rust");
            let (scenes, numbers) = (&scenes, &numbers);
            let run = move || {
                black_box(run(once, scenes, numbers));
            };
            works.push(Work { calls: CAPS, run: Box::new(run) });
        }
        let times = rounds(&mut works);
        for ((name, once), times) in methods.iter().zip(times) {
            let counted = || {
                black_box(run(*once, &scenes[..COUNTED], &numbers));
            };
            let count =
                steps::count(&[*once as usize as u64], counted).expect("this program may trace its children");
            let each = count as f64 / COUNTED as f64;
            println!("{set:<20}{name:>12}{each:>16.1}{:>16.1}", median(times));
        }
    }
}
