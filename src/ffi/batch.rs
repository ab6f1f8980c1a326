//! The part of the C ABI that works on arrays. No mathematics.

#![allow(non_camel_case_types, clippy::missing_safety_doc)] // names and words are the C header's

use super::calls::{enums, prepared, NULL_POINTER, OK};
use super::instructions::instructions;
use super::single::{spherecap_sampler_t, spherecap_status_t as Status};
use crate::batch::{
    density_numbers, sample_numbers, ImportanceKernel, ManyKernel, MeasuresKernel, PdfDirectionKernel,
    PdfKernel, PdfOnSphereKernel, SampleKernel,
};
use crate::input::is_fraction;
use crate::lane::packet::arrays::{run, Kernel};
use crate::offset::Offset;
use crate::sample::{Density, Sample};
use crate::strategy::Strategy;
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
    /// Normals of the surfaces, of any length, or (0, 0, 0) on no surface: arrays of x, y and z.
    pub normal: [*const f32; 3],
    /// The spheres' centres, each minus its point: arrays of x, y and z.
    pub centre: [*const f32; 3],
    /// The spheres' radii.
    pub radius: *const f32,
}

/// Random numbers, two for each point.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_batch_random_t {
    /// First numbers of the points.
    pub u0: *const f32,
    /// Second numbers.
    pub u1: *const f32,
}

/// Offsets, one for each point: see `spherecap_offset_t`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_batch_offsets_t {
    /// Components towards the zenith.
    pub zenith: *const f32,
    /// Components sideways.
    pub side: *const f32,
    /// Cosines with the surface normals.
    pub cosine: *const f32,
}

/// Unit directions, one for each point.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_batch_directions_t {
    /// First components.
    pub x: *const f32,
    /// Second components.
    pub y: *const f32,
    /// Third components.
    pub z: *const f32,
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

/// Where to store what is measured of the spheres: each an array of one number for each point, or NULL if it is not wanted.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_batch_measures_t {
    /// What `spherecap_solid_angle` stores.
    pub solid_angle: *mut f32,
    /// What `spherecap_projected_solid_angle` stores: irradiances of unoccluded spheres of radiance 1.
    pub projected_solid_angle: *mut f32,
}

/// The instructions that the functions on arrays use: the best that this CPU has, "AVX-512", "AVX2", or "portable" for one
/// number at a time. Not to be freed. The results are the same.
///
/// For debugging, the environment variable `SPHERECAP_INSTRUCTIONS` names others, read once: "portable", which also takes all
/// fused instructions from the functions on single points (valgrind does not know each of them), "avx2" or "avx512". With
/// another word, or one that this CPU lacks, this is "none", and the functions that compute return INSTRUCTIONS.
#[no_mangle]
pub extern "C" fn spherecap_batch_instructions() -> *const c_char {
    instructions().map_or(c"none", |instructions| instructions.name()).as_ptr()
}

/// Prepares the spheres and samples a direction towards each, with two random numbers.
///
/// Stores for each point what `spherecap_sample` stores, to the bit, wherever in the arrays it is. A density of zero tells
/// where it would have failed. Stores at `refused`, unless it is NULL, at how many points some input is bad, whatever is asked
/// for; what is wrong there, `spherecap_prepare` says. A sphere that is INVISIBLE and a point INSIDE are no bad input. Arrays
/// that are stored to must not overlap each other or those that are read. For several threads, give each a part of the arrays.
///
/// Errors: NULL_POINTER (of the arrays that are read, too), TECHNIQUE, HEMISPHERES, DEFENSIVE, INSTRUCTIONS; then nothing is
/// stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_sample(
    batch: *const spherecap_batch_t,
    random: *const spherecap_batch_random_t,
    samples: *const spherecap_batch_samples_t,
    refused: *mut usize,
) -> u32 {
    // SAFETY: the header's contract.
    let (batch, random, samples) = unsafe { (batch.as_ref(), random.as_ref(), samples.as_ref()) };
    let (Some(batch), Some(&spherecap_batch_random_t { u0, u1 }), Some(&samples)) = (batch, random, samples)
    else {
        return NULL_POINTER;
    };
    let outputs = sample_numbers(samples.into());
    let [nx, ny, nz, cx, cy, cz, radius] = batch.points();
    let inputs = [nx, ny, nz, cx, cy, cz, radius, u0, u1];
    // SAFETY: the header's contract.
    unsafe { batch.run(SampleKernel, inputs, outputs, refused) }
}

/// Samples `count` directions towards the sphere of one sampler, with two random numbers for each: for resampling, or many shadow rays
/// at one point.
///
/// Stores what `spherecap_sample` stores for each pair of random numbers, to the bit. The arrays of `random` and `samples` have one
/// number for each sample; those that are stored to must not overlap each other or those that are read.
///
/// Errors: NULL_POINTER (of the arrays that are read, too), SAMPLER, INSTRUCTIONS, and the status with which the preparation of the
/// sampler ended; then nothing is stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_sample_many(
    sampler: *const spherecap_sampler_t,
    count: usize,
    random: *const spherecap_batch_random_t,
    samples: *const spherecap_batch_samples_t,
) -> u32 {
    // SAFETY: the header's contract.
    let (random, samples) = unsafe { (random.as_ref(), samples.as_ref()) };
    let (Some(&spherecap_batch_random_t { u0, u1 }), Some(&samples)) = (random, samples) else {
        return NULL_POINTER;
    };
    // SAFETY: the header's contract.
    let (&sampler, instructions) = match unsafe { prepared::<f32>(sampler.cast()) } {
        Ok(prepared) => prepared,
        Err(status) => return status,
    };
    let inputs = [u0, u1];
    if count > 0 && inputs.iter().any(|input| input.is_null()) {
        return NULL_POINTER;
    }
    let outputs = sample_numbers(samples.into());
    // SAFETY: the header's contract, and the CPU has these instructions.
    unsafe { run(ManyKernel { sampler }, instructions, Strategy::default(), &inputs, &outputs, count) };
    OK
}

/// `spherecap_pdf` for each point. The density is also zero where the sphere or the offset would be refused.
///
/// `refused` and errors: as of `spherecap_batch_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_pdf(
    batch: *const spherecap_batch_t,
    offsets: *const spherecap_batch_offsets_t,
    densities: *const spherecap_batch_densities_t,
    refused: *mut usize,
) -> u32 {
    // SAFETY: the header's contract.
    let offsets = unsafe { offsets.as_ref() }.map(|o| [o.zenith, o.side, o.cosine]);
    // SAFETY: the header's contract.
    unsafe { densities_of(PdfKernel, batch, offsets, densities, refused) }
}

/// `spherecap_pdf_direction` for each point. The density is also zero where the sphere or the direction would be refused.
///
/// `refused` and errors: as of `spherecap_batch_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_pdf_direction(
    batch: *const spherecap_batch_t,
    directions: *const spherecap_batch_directions_t,
    densities: *const spherecap_batch_densities_t,
    refused: *mut usize,
) -> u32 {
    // SAFETY: the header's contract.
    let directions = unsafe { directions.as_ref() }.map(|d| [d.x, d.y, d.z]);
    // SAFETY: the header's contract.
    unsafe { densities_of(PdfDirectionKernel, batch, directions, densities, refused) }
}

/// `spherecap_pdf_on_sphere` for each point; otherwise as `spherecap_batch_pdf_direction`.
///
/// `refused` and errors: as of `spherecap_batch_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_pdf_on_sphere(
    batch: *const spherecap_batch_t,
    directions: *const spherecap_batch_directions_t,
    densities: *const spherecap_batch_densities_t,
    refused: *mut usize,
) -> u32 {
    // SAFETY: the header's contract.
    let directions = unsafe { directions.as_ref() }.map(|d| [d.x, d.y, d.z]);
    // SAFETY: the header's contract.
    unsafe { densities_of(PdfOnSphereKernel, batch, directions, densities, refused) }
}

/// `spherecap_solid_angle` and `spherecap_projected_solid_angle` for each point, to the bit; both are zero where
/// `spherecap_prepare` would fail, as for a sphere that is INVISIBLE. So the solid angle of one below the horizon depends on
/// technique, hemispheres and defensive fraction; projected solid angles depend on none of them.
///
/// `refused` and errors: as of `spherecap_batch_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_measures(
    batch: *const spherecap_batch_t,
    measures: *const spherecap_batch_measures_t,
    refused: *mut usize,
) -> u32 {
    // SAFETY: the header's contract.
    let (batch, measures) = unsafe { (batch.as_ref(), measures.as_ref()) };
    let (Some(batch), Some(measures)) = (batch, measures) else { return NULL_POINTER };
    let outputs = [measures.solid_angle, measures.projected_solid_angle];
    // SAFETY: the header's contract.
    unsafe { batch.run(MeasuresKernel, batch.points(), outputs, refused) }
}

/// The importance of a light at each point, to choose among several by: what `spherecap_importances` stores for the light alone, to
/// the bit. `strength` has the light's radiance, in any unit, one number for each point. Zero also where `spherecap_prepare` finds
/// bad input.
///
/// `refused` and errors: as of `spherecap_batch_sample`. A strength that is negative or not finite is bad input, too.
#[no_mangle]
pub unsafe extern "C" fn spherecap_batch_importances(
    batch: *const spherecap_batch_t,
    strength: *const f32,
    importances: *mut f32,
    refused: *mut usize,
) -> u32 {
    // SAFETY: the header's contract.
    let Some(batch) = (unsafe { batch.as_ref() }) else { return NULL_POINTER };
    if batch.count > 0 && importances.is_null() {
        return NULL_POINTER;
    }
    let [nx, ny, nz, cx, cy, cz, radius] = batch.points();
    let inputs = [nx, ny, nz, cx, cy, cz, radius, strength];
    // SAFETY: the header's contract.
    unsafe { batch.run(ImportanceKernel, inputs, [importances], refused) }
}

/// # Safety
/// That of the functions above.
unsafe fn densities_of(
    kernel: impl Kernel<10, 2>,
    batch: *const spherecap_batch_t,
    vectors: Option<[*const f32; 3]>,
    densities: *const spherecap_batch_densities_t,
    refused: *mut usize,
) -> u32 {
    // SAFETY: the header's contract.
    let (batch, densities) = unsafe { (batch.as_ref(), densities.as_ref()) };
    let (Some(batch), Some([x, y, z]), Some(&densities)) = (batch, vectors, densities) else {
        return NULL_POINTER;
    };
    let [nx, ny, nz, cx, cy, cz, radius] = batch.points();
    let inputs = [nx, ny, nz, cx, cy, cz, radius, x, y, z];
    // SAFETY: the header's contract.
    unsafe { batch.run(kernel, inputs, density_numbers(densities.into()), refused) }
}

impl spherecap_batch_t {
    fn points(&self) -> [*const f32; 7] {
        let ([nx, ny, nz], [cx, cy, cz]) = (self.normal, self.centre);
        [nx, ny, nz, cx, cy, cz, self.radius]
    }

    /// # Safety
    /// That of the functions above.
    unsafe fn run<const I: usize, const O: usize>(
        &self,
        kernel: impl Kernel<I, O>,
        inputs: [*const f32; I],
        outputs: [*mut f32; O],
        refused: *mut usize,
    ) -> u32 {
        let instructions = match instructions() {
            Ok(instructions) => instructions,
            Err(status) => return status,
        };
        let (technique, hemispheres) = match enums(self.technique, self.hemispheres) {
            Ok(enums) => enums,
            Err(status) => return status,
        };
        if !is_fraction(self.defensive) {
            return Status::SPHERECAP_STATUS_DEFENSIVE as u32;
        }
        if self.count > 0 && inputs.iter().any(|input| input.is_null()) {
            return NULL_POINTER;
        }
        let strategy = Strategy { technique, hemispheres, defensive: self.defensive };
        // SAFETY: the header's contract, and the CPU has these instructions.
        let bad = unsafe { run(kernel, instructions, strategy, &inputs, &outputs, self.count) };
        if !refused.is_null() {
            // SAFETY: the header's contract.
            unsafe { refused.write(bad) };
        }
        OK
    }
}

impl From<spherecap_batch_samples_t> for Sample<*mut f32> {
    fn from(samples: spherecap_batch_samples_t) -> Self {
        let spherecap_batch_samples_t {
            offset: [zenith, side, cosine],
            direction,
            distance,
            normal,
            density,
        } = samples;
        Self {
            offset: Offset { zenith, side, cosine },
            direction: direction.into(),
            distance,
            normal: normal.into(),
            density: density.into(),
        }
    }
}

impl From<spherecap_batch_densities_t> for Density<*mut f32> {
    fn from(densities: spherecap_batch_densities_t) -> Self {
        let spherecap_batch_densities_t { solid_angle, projected_solid_angle } = densities;
        Self { solid_angle, projected_solid_angle }
    }
}
