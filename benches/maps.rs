//! How accurate and how even the samples are, over all caps: what the figures of the report are drawn from.
//!
//! `cargo bench --bench maps`; `make report` does it. Writes `out/maps.json`. Numbers that do not exist are null.
//!
//! The published method's map from random numbers to directions is that of `ProjectedBounded`, turned round in places
//! ([`exact_numbers`]), so that this technique in f64 says what it should have given.

#![allow(missing_docs)] // a program

#[path = "maps/deviation.rs"]
mod deviation;
#[path = "maps/errors.rs"]
mod errors;
mod json;
#[path = "maps/method.rs"]
mod method;
#[path = "maps/numbers.rs"]
mod numbers;
mod published;
mod scenes;

use deviation::{deviation_maps, deviation_of_sets};
use errors::{error_maps, errors_of_sets};
use numbers::numbers;
use scenes::{Random, SEED};
use spherecap as lane; // as `src/math.rs` calls it
use spherecap::density_bound_for_radius;

/// The paper's Figure 2: the bound for all caps up to a size, over 1/s from the sphere's surface to where nothing changes.
fn bound_curve() -> String {
    let steps = 400;
    let inverse = |i: i32| 1.0 + 10.0_f64.powf(-5.0 + 5.5 * f64::from(i) / f64::from(steps - 1));
    let bounds = (0..steps).map(|i| density_bound_for_radius(1.0 / inverse(i)));
    format!("{{\"inverse_radius\": {}, \"bound\": {}}}", numbers((0..steps).map(inverse)), numbers(bounds))
}

fn main() {
    let mut random = Random(SEED);
    let random_numbers: Vec<f32> = (0..4096).map(|_| random.unit()).collect();
    let sets = scenes::sets(&mut random);
    let entries = [
        ("inverse", errors_of_sets(&sets, &random_numbers)),
        ("deviation", deviation_of_sets(&sets)),
        ("bound_curve", bound_curve()),
        ("deviation_maps", deviation_maps()),
        ("error_maps", error_maps(&mut random)),
    ];
    json::write_json("maps", "cargo bench --bench maps", SEED, &entries).expect("out/maps.json is writable");
    println!("maps are in out/maps.json");
}
