//! The part of the C ABI on single points in single precision, and what all parts share. No mathematics.

#![allow(non_camel_case_types, clippy::missing_safety_doc)] // names and words are the C header's

use super::calls;
use crate::input::Refusal;
use core::ffi::CStr;
use libc::c_char;

/// Number of this binary interface. A program built against another number must not be linked with this library: compare
/// with `spherecap_abi_version()`.
pub const SPHERECAP_ABI: u32 = 3;

/// How directions are distributed. Passed as `uint32_t`.
#[repr(C)]
pub enum spherecap_technique_t {
    /// Uniform in projected solid angle in every case. The one to use.
    SPHERECAP_TECHNIQUE_PROJECTED = 0,
    /// Uniform in projected solid angle where the sphere's centre is above the horizon, of bounded variation below it
    /// (Peters and Dachsbacher 2019).
    SPHERECAP_TECHNIQUE_PROJECTED_BOUNDED = 1,
    /// Uniform in solid angle over the whole cap, also where it is below the horizon: the usual way.
    SPHERECAP_TECHNIQUE_SOLID_ANGLE = 2,
}

/// Which sides of the surface the projected techniques cover. Passed as `uint32_t`.
#[repr(C)]
pub enum spherecap_hemispheres_t {
    /// Directions above the horizon: for opaque surfaces.
    SPHERECAP_HEMISPHERES_FRONT = 0,
    /// Both sides, each in proportion to |cosine|: for surfaces that transmit, or whose side is not known.
    SPHERECAP_HEMISPHERES_BOTH = 1,
}

/// What every function returns that can fail. `spherecap_status_message` says it in words.
#[repr(C)]
pub enum spherecap_status_t {
    /// Success.
    SPHERECAP_STATUS_OK = 0,
    /// Valid input, but nothing is sampled: the sphere is not above the horizon, or looks too small for the precision. (With
    /// `SOLID_ANGLE`, `BOTH` or a defensive fraction, which sample below the horizon, too, a sphere there is OK.)
    SPHERECAP_STATUS_INVISIBLE = 1,
    /// Valid input, but the point is inside or on the sphere: no light.
    SPHERECAP_STATUS_INSIDE = 2,
    /// A pointer is NULL.
    SPHERECAP_STATUS_NULL_POINTER = 3,
    /// The technique is no `spherecap_technique_t`.
    SPHERECAP_STATUS_TECHNIQUE = 4,
    /// The hemispheres are no `spherecap_hemispheres_t`.
    SPHERECAP_STATUS_HEMISPHERES = 5,
    /// The defensive fraction is not in [0, 1].
    SPHERECAP_STATUS_DEFENSIVE = 6,
    /// The normal is not finite.
    SPHERECAP_STATUS_NORMAL = 7,
    /// The centre is not at a finite distance, or is the shading point.
    SPHERECAP_STATUS_CENTRE = 8,
    /// The radius is not a positive finite number.
    SPHERECAP_STATUS_RADIUS = 9,
    /// A direction is not of unit length (to within 0.001), or an offset has a component outside [-1, 1] (by more than that).
    SPHERECAP_STATUS_DIRECTION = 10,
    /// The sampler was never prepared with this precision and this version, or was overwritten. Noticed by its first 16 bytes
    /// alone, which say how to read the rest: what other overwritten bytes give is anything, but does no harm.
    SPHERECAP_STATUS_SAMPLER = 11,
    /// The environment variable `SPHERECAP_INSTRUCTIONS` is set to something else than "portable", "avx2" or "avx512", or to
    /// what this CPU does not have.
    SPHERECAP_STATUS_INSTRUCTIONS = 12,
    /// A function of a recorder returned 0.
    SPHERECAP_STATUS_RECORDER = 13,
    /// The part of a choice that is spread evenly is not in [0, 1].
    SPHERECAP_STATUS_EVEN = 14,
}
/// What receives the light: a surface, or a point on none, and how its light is sampled. All zeros but a normal are the right
/// choice for a diffuse surface. Whoever asks for a density, as multiple importance sampling does, must ask with the receiver
/// that samples: so carry it along.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_receiver_t {
    /// Normal of the surface on the side to be lit, of any length; or exactly (0, 0, 0) for a point on no surface, as in a
    /// medium: then sampling is by solid angle. If its length is 1 to single precision it is used as it stands.
    pub normal: [f32; 3],
    /// A `spherecap_technique_t`.
    pub technique: u32,
    /// A `spherecap_hemispheres_t`.
    pub hemispheres: u32,
    /// The probability of sampling by solid angle over the whole cap instead, in [0, 1]; 0 unless the integrand is no multiple
    /// of the cosine with `normal`, as with shading normals. Where it is positive, a sphere wholly below the horizon is sampled,
    /// too: OK, not INVISIBLE.
    pub defensive: f32,
}

/// A sphere seen from a shading point, prepared for sampling. Plain data for the caller's stack: copy it freely; nothing is
/// to be freed. Only the functions read it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_sampler_t {
    /// Opaque.
    pub words: [u32; 64],
}

/// A direction in the cap's own frame. Its components keep their relative precision where those of a unit vector drown: in
/// small caps and near the horizon.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_offset_t {
    /// Component across the direction to the centre, towards the zenith, in [-1, 1] (to rounding).
    pub zenith: f32,
    /// Component sideways, in [-1, 1] (to rounding).
    pub side: f32,
    /// Cosine with the surface normal, in [-1, 1]; negative below the horizon, 0 without a surface. The one to use: a unit
    /// vector, rounded, may be below a horizon that this is above.
    pub cosine: f32,
}

/// A probability density in two measures.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_density_t {
    /// With respect to solid angle, per steradian.
    pub solid_angle: f32,
    /// With respect to projected solid angle: the same divided by |cosine|, but never infinite.
    pub projected_solid_angle: f32,
}

/// A sampled direction and where it meets the sphere.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_sample_t {
    /// The direction in the cap's frame, at full precision.
    pub offset: spherecap_offset_t,
    /// Unit direction from the shading point. For cosines take `offset.cosine`.
    pub direction: [f32; 3],
    /// Distance to the sphere's surface along the direction, in the caller's unit of length.
    pub distance: f32,
    /// Unit outward normal of the sphere there: centre + radius * normal is the point itself.
    pub normal: [f32; 3],
    /// Density of the direction: the very bits that `spherecap_pdf` gives for the offset.
    pub density: spherecap_density_t,
}

/// Number of the binary interface of the linked library.
#[no_mangle]
pub extern "C" fn spherecap_abi_version() -> u32 {
    SPHERECAP_ABI
}

/// Version of the linked library, such as "0.1.0".
#[no_mangle]
pub extern "C" fn spherecap_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// What a status means and what to do about it, in English words. Never NULL; not to be freed. A number that is no status
/// gets words that say so.
#[no_mangle]
pub extern "C" fn spherecap_status_message(status: u32) -> *const c_char {
    const MESSAGES: [&CStr; 15] = [
        c"success",
        Refusal::Invisible.message(),
        Refusal::Inside.message(),
        c"a pointer is NULL: pass the address of an object that lives until the function returns",
        c"the technique must be one of the spherecap_technique_t",
        c"the hemispheres must be one of the spherecap_hemispheres_t",
        Refusal::Defensive.message(),
        Refusal::Normal.message(),
        Refusal::Centre.message(),
        Refusal::Radius.message(),
        c"a direction must have length 1 (to within 0.001), and an offset components in [-1, 1]",
        c"the sampler was never prepared with this precision, or overwritten: call spherecap_prepare (or its f64 form) on it first",
        c"the environment variable SPHERECAP_INSTRUCTIONS must be portable, avx2 or avx512, and the CPU must have them: unset it",
        c"the recorder failed to make a node: its functions returned 0",
        c"the part of a choice that is spread evenly must be a number in [0, 1]",
    ];
    MESSAGES.get(status as usize).copied().unwrap_or(c"this number is not a spherecap_status_t").as_ptr()
}

/// Prepares a sampler of the sphere with this centre and radius, for what receives its light.
///
/// `centre` (three floats) is the sphere's centre minus the shading point, `radius` > 0 its radius, both in any one unit of
/// length. A receiver is only read.
///
/// Errors: NULL_POINTER, TECHNIQUE, HEMISPHERES, DEFENSIVE, NORMAL, CENTRE, RADIUS, INSTRUCTIONS; and INVISIBLE and INSIDE for
/// valid input with nothing to sample. Then `*sampler`, unless NULL, remembers the status, and every function on it returns
/// that and stores zeros.
#[no_mangle]
pub unsafe extern "C" fn spherecap_prepare(
    receiver: *const spherecap_receiver_t,
    centre: *const f32,
    radius: f32,
    sampler: *mut spherecap_sampler_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::prepare(receiver.cast(), centre, radius, sampler.cast()) }
}

/// Samples a direction towards the sphere with two random numbers in [0, 1], both ends allowed. A number outside is taken for
/// the nearer end, and NaN for 0.
///
/// Stores the sample, or zeros (so a density of 0) on failure. Errors: NULL_POINTER, SAMPLER, INSTRUCTIONS, and what
/// `spherecap_prepare` returned for the sampler.
#[no_mangle]
pub unsafe extern "C" fn spherecap_sample(
    sampler: *const spherecap_sampler_t,
    u0: f32,
    u1: f32,
    sample: *mut spherecap_sample_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::sample(sampler.cast(), u0, u1, sample.cast()) }
}

/// The sample of a sphere that is sampled once, for the caller who draws one at each point: what `spherecap_prepare` and
/// `spherecap_sample` would give, to the bit, at a smaller cost, since nothing is kept for other samples.
///
/// Stores the sample, or zeros (so a density of 0) on failure. Errors: those of `spherecap_prepare`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_sample_once(
    receiver: *const spherecap_receiver_t,
    centre: *const f32,
    radius: f32,
    u0: f32,
    u1: f32,
    sample: *mut spherecap_sample_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::sample_once(receiver.cast(), centre, radius, [u0, u1], sample.cast()) }
}

/// The density of a unit direction towards a sphere for which only this one is asked: what `spherecap_prepare` and
/// `spherecap_pdf_on_sphere` would give, to the bit. For multiple importance sampling, where a ray has hit the sphere.
///
/// Stores the density, or zeros on failure. Errors: those of `spherecap_prepare`, and DIRECTION.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_once(
    receiver: *const spherecap_receiver_t,
    centre: *const f32,
    radius: f32,
    direction: *const f32,
    density: *mut spherecap_density_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::pdf_once(receiver.cast(), centre, radius, direction, density.cast()) }
}

/// Density of the direction with this offset; zero outside the cap and where nothing is sampled. For an offset from
/// `spherecap_sample`: the very bits that it stored.
///
/// Errors: NULL_POINTER, DIRECTION, SAMPLER, INSTRUCTIONS, and what `spherecap_prepare` returned for the sampler; then zeros are
/// stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf(
    sampler: *const spherecap_sampler_t,
    offset: *const spherecap_offset_t,
    density: *mut spherecap_density_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::pdf::<f32>(sampler.cast(), offset.cast(), density.cast()) }
}

/// Density of a unit direction (three floats); zero outside the cap. The convenient form: a unit vector in single
/// precision resolves 6e-8, so for a sphere with radius/distance = 1e-6 the cosine at the horizon is off by percents, and
/// the direction itself by tenths of the cap. Where you have the offset, use `spherecap_pdf`.
///
/// Errors: as `spherecap_pdf`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_direction(
    sampler: *const spherecap_sampler_t,
    direction: *const f32,
    density: *mut spherecap_density_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::pdf_direction(sampler.cast(), direction, density.cast()) }
}

/// As `spherecap_pdf_direction`, for a direction that is known to point at the sphere (a ray has hit it): only the horizon is
/// tested, so that rounding near the limb does not lose the density.
///
/// Errors: as `spherecap_pdf`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_on_sphere(
    sampler: *const spherecap_sampler_t,
    direction: *const f32,
    density: *mut spherecap_density_t,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::pdf_on_sphere(sampler.cast(), direction, density.cast()) }
}

/// The two random numbers (stored at `u`) that give this offset, to rounding; in a defensive mixture those of the
/// projected part. In [0, 1] for every offset.
///
/// Errors: as `spherecap_pdf`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_invert(
    sampler: *const spherecap_sampler_t,
    offset: *const spherecap_offset_t,
    u: *mut f32,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::invert(sampler.cast(), offset.cast(), u) }
}

/// Solid angle of the whole cap, the part below the horizon included, in steradians, in (0, 2 pi] (to
/// rounding).
///
/// Errors: NULL_POINTER, SAMPLER, INSTRUCTIONS, and what `spherecap_prepare` returned for the sampler; then zero is stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_solid_angle(
    sampler: *const spherecap_sampler_t,
    solid_angle: *mut f32,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::solid_angle(sampler.cast(), solid_angle) }
}

/// Projected solid angle of the cap above the horizon, in steradians, in [0, pi] (to rounding): the
/// irradiance of an unoccluded sphere of radiance 1.
///
/// Errors: as `spherecap_solid_angle`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_projected_solid_angle(
    sampler: *const spherecap_sampler_t,
    projected_solid_angle: *mut f32,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::projected_solid_angle(sampler.cast(), projected_solid_angle) }
}

/// An upper bound, at least 1, for the largest density over the smallest with respect to projected solid angle above the
/// horizon: the factor by which the weights of samples of a diffuse surface can differ. Infinity for `SOLID_ANGLE` where the
/// horizon cuts the cap. Of the technique alone; mixtures are not counted.
///
/// Errors: as `spherecap_solid_angle`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_density_bound(
    sampler: *const spherecap_sampler_t,
    bound: *mut f32,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe { calls::density_bound(sampler.cast(), bound) }
}
