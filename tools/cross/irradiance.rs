//! The irradiance of spherical lights of radiance 1 on a horizontal plane, in double precision.
//!
//! A filter: reads records of four little-endian `f64` from standard input (the light's centre minus the shading
//! point, z up; its radius), and writes an `f64` for each: the projected solid angle of what is above the plane, 0 for
//! a point inside the light.

use spherecap::{Receiver, Refusal, Sampler};
use std::error::Error;
use std::io::{self, Read, Write};

fn irradiance([x, y, z, radius]: [f64; 4]) -> Result<f64, Refusal> {
    match Sampler::prepare(Receiver::new([0.0, 0.0, 1.0]), [x, y, z], radius) {
        Ok(sampler) => Ok(sampler.cap().projected_solid_angle()),
        Err(Refusal::Invisible | Refusal::Inside) => Ok(0.0),
        Err(refusal) => Err(refusal),
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut input = Vec::new();
    io::stdin().read_to_end(&mut input)?;
    let numbers: Vec<f64> = input
        .chunks_exact(8)
        .map(|bytes| f64::from_le_bytes(bytes.try_into().expect("eight bytes")))
        .collect();
    if input.len() % 32 != 0 {
        return Err("the input is not a whole number of records of four f64".into());
    }
    let mut output = Vec::new();
    for (i, record) in numbers.chunks_exact(4).enumerate() {
        let value = irradiance(record.try_into().expect("four numbers"))
            .map_err(|refusal| format!("record {i}: {refusal}"))?;
        output.extend(value.to_le_bytes());
    }
    io::stdout().write_all(&output)?;
    Ok(())
}
