//! The part of the C ABI that works on arrays. No mathematics.
//!
//! `include/spherecap.h` is generated from it, too.

#![allow(non_camel_case_types, clippy::missing_safety_doc)] // names and words are the C header's

use crate::batch::{
    density_numbers, sample_numbers, Instructions, PdfDirectionKernel, PdfKernel, PdfOnSphereKernel,
    SampleKernel,
};
use crate::ffi::{hemispheres, spherecap_status_t as Status, technique};
use crate::lane::packet::arrays::{run, Kernel};
use crate::offset::Offset;
use crate::prepare::is_fraction;
use crate::sampling::{Density, Sample, Strategy};
use libc::c_char;

/// Spheres as seen from many points: what `spherecap_prepare` is given, in arrays of one number for each point. An array may
/// begin at the address of any float. The points share the strategy. (The radius is an array, too, as each point may have
/// chosen its own light. Where all see one, fill it once: it serves every batch.)
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_batch_t {
    /// A `spherecap_technique_t`.
    pub technique: u32,
    /// A `spherecap_hemispheres_t`.
    pub hemispheres: u32,
    /// The probability of sampling by solid angle over the whole cap instead, in [0, 1].
    pub defensive: f32,
    /// Number of points; if 0, no array is looked at.
    pub count: usize,
    /// Unit normals of the surfaces, or (0, 0, 0) on no surface: arrays of x, y and z.
    pub normal: [*const f32; 3],
    /// The spheres' centres, each minus its point: arrays of x, y and z.
    pub centre: [*const f32; 3],
    /// The spheres' radii.
    pub radius: *const f32,
}

/// Where to store densities: each an array of one number for each point, or NULL if it is not wanted.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_batch_densities_t {
    /// With respect to solid angle, per steradian.
    pub solid_angle: *mut f32,
    /// With respect to projected solid angle: the same divided by |cosine|, but never infinite.
    pub projected_solid_angle: *mut f32,
}

/// Where to store samples: each an array of one number for each point, or NULL if it is not wanted. See
/// `spherecap_sample_t`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_batch_samples_t {
    /// The directions in the caps' frames: arrays of the zenith, side and cosine of a `spherecap_offset_t`.
    pub offset: [*mut f32; 3],
    /// Unit directions from the points: arrays of x, y and z.
    pub direction: [*mut f32; 3],
    /// Distances to the spheres' surfaces along the directions.
    pub distance: *mut f32,
    /// Unit outward normals of the spheres there: arrays of x, y and z.
    pub normal: [*mut f32; 3],
    /// Densities of the directions.
    pub density: spherecap_batch_densities_t,
}

/// The instructions that the functions on arrays use on this CPU: "AVX-512", "AVX2", or "portable" for one number at a time.
/// Not to be freed. The results are the same.
#[no_mangle]
pub extern "C" fn spherecap_batch_instructions() -> *const c_char {
    Instructions::widest().name().as_ptr()
}

/// Prepares the spheres and samples a direction towards each, with the random numbers in the arrays `u0` and `u1`.
///
/// Stores for each point what `spherecap_sample` stores, to the bit, wherever in the arrays it is. A density of zero tells
/// where it would have failed: where nothing is above the horizon, or the input is bad, which `spherecap_prepare` can tell
/// apart. Arrays that are stored to must not overlap each other or those that are read. For several threads, give each a
/// part of the arrays.
///
/// Errors: NULL_POINTER (of the arrays that are read, too), TECHNIQUE, HEMISPHERES, DEFENSIVE; then nothing is stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_sample(
    batch: *const spherecap_batch_t,
    u0: *const f32,
    u1: *const f32,
    samples: *const spherecap_batch_samples_t,
) -> u32 {
    // SAFETY: the header's contract.
    let (batch, samples) = unsafe { (batch.as_ref(), samples.as_ref()) };
    let (Some(batch), Some(samples)) = (batch, samples) else {
        return Status::SPHERECAP_STATUS_NULL_POINTER as u32;
    };
    let spherecap_batch_samples_t { offset: [zenith, side, cosine], direction, distance, normal, density } =
        *samples;
    let outputs = sample_numbers(Sample {
        offset: Offset { zenith, side, cosine },
        direction: direction.into(),
        distance,
        normal: normal.into(),
        density: density.into(),
    });
    let [nx, ny, nz, cx, cy, cz, radius] = batch.points();
    let inputs = [nx, ny, nz, cx, cy, cz, radius, u0, u1];
    // SAFETY: the header's contract.
    unsafe { batch.run::<SampleKernel, 9, 12>(inputs, outputs) }
}

/// `spherecap_pdf` for each point, of the offsets in three arrays (at `offset`): zenith, side and cosine. The density is also
/// zero where the sphere or the offset would be refused.
///
/// Errors: as `spherecap_batch_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_pdf(
    batch: *const spherecap_batch_t,
    offset: *const *const f32,
    densities: *const spherecap_batch_densities_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { densities_of::<PdfKernel>(batch, offset, densities) }
}

/// `spherecap_pdf_direction` for each point, of the unit directions in three arrays (at `direction`): x, y and z. The density
/// is also zero where the sphere or the direction would be refused.
///
/// Errors: as `spherecap_batch_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_pdf_direction(
    batch: *const spherecap_batch_t,
    direction: *const *const f32,
    densities: *const spherecap_batch_densities_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { densities_of::<PdfDirectionKernel>(batch, direction, densities) }
}

/// `spherecap_pdf_on_sphere` for each point; otherwise as `spherecap_batch_pdf_direction`.
///
/// Errors: as `spherecap_batch_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_pdf_on_sphere(
    batch: *const spherecap_batch_t,
    direction: *const *const f32,
    densities: *const spherecap_batch_densities_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { densities_of::<PdfOnSphereKernel>(batch, direction, densities) }
}

/// # Safety
/// That of the functions above.
unsafe fn densities_of<K: Kernel<10, 2>>(
    batch: *const spherecap_batch_t,
    vector: *const *const f32,
    densities: *const spherecap_batch_densities_t,
) -> u32 {
    // SAFETY: the header's contract; an array of pointers is aligned as one.
    let (batch, vector, densities) =
        unsafe { (batch.as_ref(), vector.cast::<[*const f32; 3]>().as_ref(), densities.as_ref()) };
    let (Some(batch), Some(&[x, y, z]), Some(&densities)) = (batch, vector, densities) else {
        return Status::SPHERECAP_STATUS_NULL_POINTER as u32;
    };
    let [nx, ny, nz, cx, cy, cz, radius] = batch.points();
    let inputs = [nx, ny, nz, cx, cy, cz, radius, x, y, z];
    // SAFETY: the header's contract.
    unsafe { batch.run::<K, 10, 2>(inputs, density_numbers(densities.into())) }
}

impl spherecap_batch_t {
    fn points(&self) -> [*const f32; 7] {
        let ([nx, ny, nz], [cx, cy, cz]) = (self.normal, self.centre);
        [nx, ny, nz, cx, cy, cz, self.radius]
    }

    /// # Safety
    /// That of the functions above.
    unsafe fn run<K: Kernel<I, O>, const I: usize, const O: usize>(
        &self,
        inputs: [*const f32; I],
        outputs: [*mut f32; O],
    ) -> u32 {
        let Some(technique) = technique(self.technique) else {
            return Status::SPHERECAP_STATUS_TECHNIQUE as u32;
        };
        let Some(hemispheres) = hemispheres(self.hemispheres) else {
            return Status::SPHERECAP_STATUS_HEMISPHERES as u32;
        };
        if !is_fraction(self.defensive) {
            return Status::SPHERECAP_STATUS_DEFENSIVE as u32;
        }
        if self.count > 0 && inputs.iter().any(|input| input.is_null()) {
            return Status::SPHERECAP_STATUS_NULL_POINTER as u32;
        }
        let strategy = Strategy { technique, hemispheres, defensive: self.defensive };
        // SAFETY: the header's contract, and the CPU has these instructions.
        unsafe { run::<K, I, O>(Instructions::widest(), strategy, &inputs, &outputs, self.count) };
        Status::SPHERECAP_STATUS_OK as u32
    }
}

impl From<spherecap_batch_densities_t> for Density<*mut f32> {
    fn from(densities: spherecap_batch_densities_t) -> Self {
        let spherecap_batch_densities_t { solid_angle, projected_solid_angle } = densities;
        Self { solid_angle, projected_solid_angle }
    }
}
