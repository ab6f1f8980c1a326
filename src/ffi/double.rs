//! The part of the C ABI in double precision. No mathematics.

#![allow(non_camel_case_types, clippy::missing_safety_doc)] // names and words are the C header's

use super::calls;

/// `spherecap_receiver_t` in double precision.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_receiver_f64_t {
    /// Normal of the surface, or (0, 0, 0).
    pub normal: [f64; 3],
    /// A `spherecap_technique_t`.
    pub technique: u32,
    /// A `spherecap_hemispheres_t`.
    pub hemispheres: u32,
    /// The probability of sampling by solid angle instead.
    pub defensive: f64,
}

/// `spherecap_sampler_t` in double precision. Functions of the other precision refuse it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_sampler_f64_t {
    /// Opaque.
    pub words: [u64; 64],
}

/// `spherecap_offset_t` in double precision.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_offset_f64_t {
    /// Component towards the zenith.
    pub zenith: f64,
    /// Component sideways.
    pub side: f64,
    /// Cosine with the surface normal.
    pub cosine: f64,
}

/// `spherecap_density_t` in double precision.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_density_f64_t {
    /// With respect to solid angle.
    pub solid_angle: f64,
    /// With respect to projected solid angle.
    pub projected_solid_angle: f64,
}

/// `spherecap_sample_t` in double precision.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_sample_f64_t {
    /// The direction in the cap's frame.
    pub offset: spherecap_offset_f64_t,
    /// Unit direction from the shading point.
    pub direction: [f64; 3],
    /// Distance to the sphere's surface.
    pub distance: f64,
    /// Unit outward normal of the sphere there.
    pub normal: [f64; 3],
    /// Density of the direction.
    pub density: spherecap_density_f64_t,
}

/// `spherecap_prepare` in double precision. What it and the functions below return is what those without `_f64` do.
#[no_mangle]
pub unsafe extern "C" fn spherecap_prepare_f64(
    receiver: *const spherecap_receiver_f64_t,
    centre: *const f64,
    radius: f64,
    sampler: *mut spherecap_sampler_f64_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::prepare(receiver.cast(), centre, radius, sampler.cast()) }
}

/// `spherecap_sample` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_sample_f64(
    sampler: *const spherecap_sampler_f64_t,
    u0: f64,
    u1: f64,
    sample: *mut spherecap_sample_f64_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::sample(sampler.cast(), u0, u1, sample.cast()) }
}

/// `spherecap_sample_once` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_sample_once_f64(
    receiver: *const spherecap_receiver_f64_t,
    centre: *const f64,
    radius: f64,
    u0: f64,
    u1: f64,
    sample: *mut spherecap_sample_f64_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::sample_once(receiver.cast(), centre, radius, [u0, u1], sample.cast()) }
}

/// `spherecap_pdf_once` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_once_f64(
    receiver: *const spherecap_receiver_f64_t,
    centre: *const f64,
    radius: f64,
    direction: *const f64,
    density: *mut spherecap_density_f64_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::pdf_once(receiver.cast(), centre, radius, direction, density.cast()) }
}

/// `spherecap_pdf` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_f64(
    sampler: *const spherecap_sampler_f64_t,
    offset: *const spherecap_offset_f64_t,
    density: *mut spherecap_density_f64_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::pdf::<f64>(sampler.cast(), offset.cast(), density.cast()) }
}

/// `spherecap_pdf_direction` in double precision (three doubles): a unit vector resolves 1e-16.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_direction_f64(
    sampler: *const spherecap_sampler_f64_t,
    direction: *const f64,
    density: *mut spherecap_density_f64_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::pdf_direction(sampler.cast(), direction, density.cast()) }
}

/// `spherecap_pdf_on_sphere` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_on_sphere_f64(
    sampler: *const spherecap_sampler_f64_t,
    direction: *const f64,
    density: *mut spherecap_density_f64_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::pdf_on_sphere(sampler.cast(), direction, density.cast()) }
}

/// `spherecap_invert` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_invert_f64(
    sampler: *const spherecap_sampler_f64_t,
    offset: *const spherecap_offset_f64_t,
    u: *mut f64,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::invert(sampler.cast(), offset.cast(), u) }
}

/// `spherecap_solid_angle` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_solid_angle_f64(
    sampler: *const spherecap_sampler_f64_t,
    solid_angle: *mut f64,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::solid_angle(sampler.cast(), solid_angle) }
}

/// `spherecap_projected_solid_angle` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_projected_solid_angle_f64(
    sampler: *const spherecap_sampler_f64_t,
    projected_solid_angle: *mut f64,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::projected_solid_angle(sampler.cast(), projected_solid_angle) }
}

/// `spherecap_density_bound` in double precision.
#[no_mangle]
pub unsafe extern "C" fn spherecap_density_bound_f64(
    sampler: *const spherecap_sampler_f64_t,
    bound: *mut f64,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::density_bound(sampler.cast(), bound) }
}
