//! Samples spherical lights uniformly in projected solid angle.
//!
//! A shading point sees a spherical light as a spherical cap. Sampling the *projected* cap uniformly cancels the cosine of a
//! diffuse surface: without occlusion every sample has the same weight, so one ray shows no noise.
//!
//! ```
//! use spherecap::{Receiver, Sampler};
//!
//! // A light of radius 0.5, whose centre is below the horizon of a floor with the normal z.
//! let (floor, centre, radius) = (Receiver::new([0.0, 0.0, 1.0]), [1.0, 0.0, -0.2], 0.5);
//! let sampler = Sampler::<f32>::prepare(floor, centre, radius)?;
//! let sample = sampler.sample(0.3, 0.7);
//!
//! // A ray along `sample.direction` meets the light after `sample.distance`; the irradiance is one number,
//! // whatever the random numbers were.
//! let irradiance = sample.offset.cosine / sample.density.solid_angle;
//! assert!((irradiance / sampler.cap().projected_solid_angle() - 1.0).abs() < 1e-5);
//!
//! // The density of a sample can be asked for, and its random numbers recovered.
//! assert_eq!(sampler.pdf(sample.offset), sample.density);
//! let [u0, u1] = sampler.invert(sample.offset);
//! assert!((u0 - 0.3).abs() < 1e-5 && (u1 - 0.7).abs() < 1e-5);
//! # Ok::<(), spherecap::Refusal>(())
//! ```
//!
//! The kernels are written once, generic over a [`Lane`]: `f32` and `f64`; whatever else has its operations (a packet of
//! numbers, a node of an expression graph) runs the same code. [`Sampler::prepare`] is the checked way in for scalars,
//! [`batch`] the one for arrays of points; [`lights`] chooses among several lights; [`Cap::new`] and [`Sampler::new`] are total functions of any lane. The C ABI is
//! `include/spherecap.h`.
//!
//! # Features and dependencies
//!
//! The crate has no Cargo features, and a program that uses only the Rust API links nothing of the C ABI. It needs `std` (to find
//! out what instructions the processor has), and `libc` for the C ABI. Vectors are arrays at its boundary: [`Vec3`] says how those
//! of other libraries become one.
//!
//! # Speed
//!
//! [`batch`] finds the widest instructions when the program runs. All else is inlined into your functions, and compiled for the
//! same processor as they are. By default that is one without fused multiply-adds, each of which then is a call: so compile with
//! `-C target-cpu=x86-64-v3` or `native`, or call the kernels from functions with `#[target_feature(enable = "avx2,fma")]`. The
//! results are the same to the bit.
//!
//! After C. Peters and C. Dachsbacher, "Sampling Projected Spherical Caps in Real Time", Proc. ACM Comput. Graph. Interact. Tech.
//! 2(1), 2019, with a uniform technique where theirs is not, and numerics that hold in single precision.

pub mod batch;
mod cap;
mod choice;
mod compensated;
mod disk;
mod ffi;
mod fits;
#[cfg(test)]
mod hashes;
mod importance;
mod input;
mod lane;
pub mod lights;
mod math;
mod offset;
mod prepare;
mod sample;
mod sampling;
#[cfg(test)]
mod source;
mod strategy;
mod vec3;

pub use cap::Cap;
pub use fits::Fits;
pub use input::{Refusal, UNIT_TOLERANCE};
pub use lane::{lit, Blend, Lane, Lit, Mask};
pub use offset::Offset;
pub use prepare::Scalar;
pub use sample::{Density, Sample};
pub use sampling::{density_bound_for_radius, Sampler};
pub use strategy::{Hemispheres, Receiver, Strategy, Technique};
pub use vec3::Vec3;

/// The README's example is a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
