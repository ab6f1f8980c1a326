//! The light that a floor gets from a sphere of radiance 10: one sample is as good as many.
//!
//! Here by `cargo run --release --example light`; elsewhere with `spherecap = { path = "…" }` in `Cargo.toml`.

use spherecap::{Receiver, Refusal, Sampler};

fn main() -> Result<(), Refusal> {
    let (floor, radiance) = (Receiver::new([0.0, 0.0, 1.0]), 10.0);
    let (centre, radius) = ([3.0, 0.0, 0.5], 1.0); // the horizon cuts this light
    let sampler = Sampler::<f32>::prepare(floor, centre, radius)?;
    let sample = sampler.sample(0.25, 0.75);
    println!("irradiance {:.4}", radiance * sample.offset.cosine / sample.density.solid_angle);
    Ok(())
}
