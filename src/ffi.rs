//! The C ABI: check, convert, call, store. No mathematics.
//!
//! `include/spherecap.h` is generated from this file and the other `ffi_*.rs`, comments included.

#![allow(non_camel_case_types, clippy::missing_safety_doc)] // names and words are the C header's

use crate::offset::Offset;
use crate::prepare::{is_offset, is_unit, refusal, Refusal};
use crate::sampling::{Density, Hemispheres, Sample, Sampler, Strategy, Technique};
use crate::vec3::Vec3;
use core::ffi::CStr;
use core::mem::MaybeUninit;
use libc::c_char;

/// Number of this binary interface. A program built against another number must not be linked with this library: compare
/// with `spherecap_abi_version()`.
pub const SPHERECAP_ABI: u32 = 1;

/// How directions are distributed. Passed as `uint32_t`.
#[repr(C)]
pub enum spherecap_technique_t {
    /// Uniform in solid angle over the whole cap, also where it is below the horizon: the usual way.
    SPHERECAP_TECHNIQUE_SOLID_ANGLE = 0,
    /// Uniform in projected solid angle where the sphere's centre is above the horizon, of bounded variation below it
    /// (Peters and Dachsbacher 2019).
    SPHERECAP_TECHNIQUE_PROJECTED_BOUNDED = 1,
    /// Uniform in projected solid angle in every case. The one to use.
    SPHERECAP_TECHNIQUE_PROJECTED = 2,
}

/// Which sides of the surface the projected techniques cover. Passed as `uint32_t`.
#[repr(C)]
pub enum spherecap_hemispheres_t {
    /// Directions above the horizon: for opaque surfaces.
    SPHERECAP_HEMISPHERES_FRONT = 0,
    /// Both sides, each in proportion to |cosine|: for surfaces that transmit, or whose side is not known.
    SPHERECAP_HEMISPHERES_BOTH = 1,
}

/// What every function returns. `spherecap_status_message` says it in words.
#[repr(C)]
pub enum spherecap_status_t {
    /// Success.
    SPHERECAP_STATUS_OK = 0,
    /// Valid input, but the sphere is not above the horizon (or looks too small for single precision): no light.
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
    /// The normal is neither of unit length (to within 0.001) nor exactly zero.
    SPHERECAP_STATUS_NORMAL = 7,
    /// The centre is not at a finite distance, or is the shading point.
    SPHERECAP_STATUS_CENTRE = 8,
    /// The radius is not a positive finite number.
    SPHERECAP_STATUS_RADIUS = 9,
    /// A random number is not in [0, 1].
    SPHERECAP_STATUS_RANDOM_NUMBER = 10,
    /// The cap was never prepared, or its memory was overwritten.
    SPHERECAP_STATUS_CAP = 11,
    /// A direction is not of unit length (to within 0.001), or an offset has a component outside [-1, 1].
    SPHERECAP_STATUS_DIRECTION = 12,
    /// A function of a recorder returned 0.
    SPHERECAP_STATUS_RECORDER = 13,
}
use spherecap_status_t as Status;
use Status::{
    SPHERECAP_STATUS_CAP, SPHERECAP_STATUS_CENTRE, SPHERECAP_STATUS_DEFENSIVE, SPHERECAP_STATUS_DIRECTION,
    SPHERECAP_STATUS_HEMISPHERES, SPHERECAP_STATUS_INSIDE, SPHERECAP_STATUS_INVISIBLE,
    SPHERECAP_STATUS_NORMAL, SPHERECAP_STATUS_NULL_POINTER, SPHERECAP_STATUS_OK, SPHERECAP_STATUS_RADIUS,
    SPHERECAP_STATUS_RANDOM_NUMBER, SPHERECAP_STATUS_TECHNIQUE,
};

impl From<Refusal> for Status {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Invisible => SPHERECAP_STATUS_INVISIBLE,
            Refusal::Inside => SPHERECAP_STATUS_INSIDE,
            Refusal::Defensive => SPHERECAP_STATUS_DEFENSIVE,
            Refusal::Normal => SPHERECAP_STATUS_NORMAL,
            Refusal::Centre => SPHERECAP_STATUS_CENTRE,
            Refusal::Radius => SPHERECAP_STATUS_RADIUS,
        }
    }
}

/// A sphere seen from a shading point, prepared for sampling. Plain data for the caller's stack: copy it freely; nothing is
/// to be freed. Only the functions read it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_cap_t {
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
    /// Cosine with the surface normal, in [-1, 1]; negative below the horizon, 0 without a surface.
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
    /// Unit direction from the shading point.
    pub direction: [f32; 3],
    /// Distance to the sphere's surface along the direction, in the caller's unit of length.
    pub distance: f32,
    /// Unit outward normal of the sphere there: centre + radius * normal is the point itself.
    pub normal: [f32; 3],
    /// Density of the direction: the very bits that `spherecap_pdf` gives for the offset.
    pub density: spherecap_density_t,
}

/// What a `spherecap_cap_t` holds.
#[repr(C)]
struct Prepared {
    seal: u32,
    status: u32,
    sampler: Sampler<f32>,
}

/// Marks prepared memory ("scap", and the ABI).
const SEAL: u32 = 0x7363_6170 ^ SPHERECAP_ABI;
/// Words of a [`Prepared`] that hold enums: checked before it is looked at as one.
const TECHNIQUE_WORD: usize = 2;
const HEMISPHERES_WORD: usize = 3;

const _: () = {
    assert!(size_of::<Prepared>() <= size_of::<spherecap_cap_t>());
    assert!(align_of::<Prepared>() == align_of::<spherecap_cap_t>());
    assert!(core::mem::offset_of!(Prepared, sampler) == TECHNIQUE_WORD * 4);
    assert!(size_of::<Sample<f32>>() == size_of::<spherecap_sample_t>());
};

/// Compiles a kernel call twice, plainly and with fused multiply-adds as instructions, and picks per call what the CPU
/// has. The results are the same to the bit; without the instruction each is a call.
macro_rules! kernel {
    (fn $name:ident($($arg:ident: $type:ty),*) -> $result:ty $body:block) => {
        #[inline]
        fn $name($($arg: $type),*) -> $result {
            #[inline(always)]
            fn plain($($arg: $type),*) -> $result $body
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2,fma")]
                fn fused($($arg: $type),*) -> $result {
                    plain($($arg),*)
                }
                if is_x86_feature_detected!("fma") && is_x86_feature_detected!("avx2") {
                    // SAFETY: the CPU has these features.
                    return unsafe { fused($($arg),*) };
                }
            }
            plain($($arg),*)
        }
    };
}

kernel! {
    fn prepare(
        strategy: Strategy<f32>, normal: [f32; 3], centre: [f32; 3], radius: f32,
        out: &mut MaybeUninit<Prepared>
    ) -> bool {
        let (sampler, is_possible) =
            Sampler::prepare_where_possible(strategy, normal.into(), centre.into(), radius);
        // Stored here, so that it is not copied.
        out.write(Prepared { seal: SEAL, status: SPHERECAP_STATUS_OK as u32, sampler });
        is_possible
    }
}
kernel! {
    fn sample(sampler: &Sampler<f32>, u0: f32, u1: f32) -> spherecap_sample_t {
        sampler.sample(u0, u1).into()
    }
}
kernel! {
    fn pdf(sampler: &Sampler<f32>, offset: Offset<f32>) -> Density<f32> {
        sampler.pdf(offset)
    }
}
kernel! {
    fn pdf_direction(sampler: &Sampler<f32>, direction: Vec3<f32>) -> Density<f32> {
        sampler.pdf(sampler.offset(direction))
    }
}
kernel! {
    fn pdf_on_sphere(sampler: &Sampler<f32>, direction: Vec3<f32>) -> Density<f32> {
        sampler.pdf_on_sphere(sampler.offset(direction))
    }
}
kernel! {
    fn density_bound(sampler: &Sampler<f32>) -> f32 {
        sampler.density_bound()
    }
}
kernel! {
    fn invert(sampler: &Sampler<f32>, offset: Offset<f32>) -> [f32; 2] {
        sampler.invert(offset)
    }
}

impl From<spherecap_offset_t> for Offset<f32> {
    fn from(spherecap_offset_t { zenith, side, cosine }: spherecap_offset_t) -> Self {
        Self { zenith, side, cosine }
    }
}

impl From<Density<f32>> for spherecap_density_t {
    fn from(Density { solid_angle, projected_solid_angle }: Density<f32>) -> Self {
        Self { solid_angle, projected_solid_angle }
    }
}

impl From<Sample<f32>> for spherecap_sample_t {
    fn from(s: Sample<f32>) -> Self {
        let Offset { zenith, side, cosine } = s.offset;
        Self {
            offset: spherecap_offset_t { zenith, side, cosine },
            direction: s.direction.into(),
            distance: s.distance,
            normal: s.normal.into(),
            density: s.density.into(),
        }
    }
}

/// The sampler in a cap, or the status that its preparation ended with.
///
/// # Safety
/// `cap` is NULL or points to a readable `spherecap_cap_t`.
unsafe fn prepared<'a>(cap: *const spherecap_cap_t) -> Result<&'a Sampler<f32>, u32> {
    // SAFETY: the caller's promise.
    let Some(cap) = (unsafe { cap.as_ref() }) else {
        return Err(SPHERECAP_STATUS_NULL_POINTER as u32);
    };
    let [seal, status, ..] = cap.words;
    if seal != SEAL || status > SPHERECAP_STATUS_DIRECTION as u32 {
        return Err(SPHERECAP_STATUS_CAP as u32);
    }
    if status != SPHERECAP_STATUS_OK as u32 {
        return Err(status);
    }
    if technique(cap.words[TECHNIQUE_WORD]).is_none() || hemispheres(cap.words[HEMISPHERES_WORD]).is_none() {
        return Err(SPHERECAP_STATUS_CAP as u32);
    }
    // SAFETY: size and alignment fit, the enums are valid, and every other field may have any bits.
    Ok(unsafe { &(*core::ptr::from_ref(cap).cast::<Prepared>()).sampler })
}

pub(crate) fn technique(number: u32) -> Option<Technique> {
    use spherecap_technique_t::{
        SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_TECHNIQUE_PROJECTED_BOUNDED, SPHERECAP_TECHNIQUE_SOLID_ANGLE,
    };
    const SOLID_ANGLE: u32 = SPHERECAP_TECHNIQUE_SOLID_ANGLE as u32;
    const PROJECTED_BOUNDED: u32 = SPHERECAP_TECHNIQUE_PROJECTED_BOUNDED as u32;
    const PROJECTED: u32 = SPHERECAP_TECHNIQUE_PROJECTED as u32;
    match number {
        SOLID_ANGLE => Some(Technique::SolidAngle),
        PROJECTED_BOUNDED => Some(Technique::ProjectedBounded),
        PROJECTED => Some(Technique::Projected),
        _ => None,
    }
}

pub(crate) fn hemispheres(number: u32) -> Option<Hemispheres> {
    use spherecap_hemispheres_t::{SPHERECAP_HEMISPHERES_BOTH, SPHERECAP_HEMISPHERES_FRONT};
    const FRONT: u32 = SPHERECAP_HEMISPHERES_FRONT as u32;
    const BOTH: u32 = SPHERECAP_HEMISPHERES_BOTH as u32;
    match number {
        FRONT => Some(Hemispheres::Front),
        BOTH => Some(Hemispheres::Both),
        _ => None,
    }
}

/// Three floats behind a pointer that may be NULL.
///
/// # Safety
/// `vector` is NULL or points to three readable floats.
unsafe fn vector(vector: *const f32) -> Option<[f32; 3]> {
    // SAFETY: the caller's promise; an array of floats is aligned as one.
    unsafe { vector.cast::<[f32; 3]>().as_ref() }.copied()
}

/// # Safety
/// `offset` is NULL or points to a readable `spherecap_offset_t`.
unsafe fn offset(offset: *const spherecap_offset_t) -> Result<Offset<f32>, u32> {
    // SAFETY: the caller's promise.
    let offset = (*unsafe { offset.as_ref() }.ok_or(SPHERECAP_STATUS_NULL_POINTER as u32)?).into();
    is_offset(offset).then_some(offset).ok_or(SPHERECAP_STATUS_DIRECTION as u32)
}

/// # Safety
/// `direction` is NULL or points to three readable floats.
unsafe fn direction(direction: *const f32) -> Result<Vec3<f32>, u32> {
    // SAFETY: the caller's promise.
    let direction = unsafe { vector(direction) }.ok_or(SPHERECAP_STATUS_NULL_POINTER as u32)?.into();
    is_unit(direction).then_some(direction).ok_or(SPHERECAP_STATUS_DIRECTION as u32)
}

/// Stores a value, or zeros where there is none, behind a pointer that may be NULL, and gives the status.
///
/// # Safety
/// `out` is NULL or points to a writable `T`, for which all zeros is a value.
pub(crate) unsafe fn store<T>(out: *mut T, value: Result<T, u32>) -> u32 {
    if out.is_null() {
        return SPHERECAP_STATUS_NULL_POINTER as u32;
    }
    match value {
        Ok(value) => {
            // SAFETY: the caller's promise.
            unsafe { out.write(value) };
            SPHERECAP_STATUS_OK as u32
        }
        Err(status) => {
            // SAFETY: the caller's promise.
            unsafe { out.write_bytes(0, 1) };
            status
        }
    }
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
    const MESSAGES: [&CStr; 14] = [
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
        c"a random number must be in [0, 1]",
        c"the cap was never prepared, or overwritten: call spherecap_prepare on it first",
        c"a direction must have length 1 (to within 0.001), and an offset components in [-1, 1]",
        c"the recorder failed to make a node: its functions returned 0",
    ];
    MESSAGES.get(status as usize).copied().unwrap_or(c"this number is not a spherecap_status_t").as_ptr()
}

/// Prepares a cap for sampling.
///
/// `technique` is a `spherecap_technique_t` and `hemispheres` a `spherecap_hemispheres_t`. `defensive`, in [0, 1], is the
/// probability of sampling by solid angle over the whole cap instead; 0 unless the integrand is no multiple of the cosine
/// with `normal`, as with shading normals. `normal` (three floats) is the unit normal of the surface on the side to be
/// lit: used as it stands if its length is 1 to single precision, brought to unit length if it is to within 0.001; or
/// exactly (0, 0, 0) for a point on no surface, as in a medium: then sampling is by solid angle. `centre` (three floats)
/// is the sphere's centre minus the shading point, `radius` > 0 its radius, both in any one unit of length.
///
/// Errors: NULL_POINTER, TECHNIQUE, HEMISPHERES, DEFENSIVE, NORMAL, CENTRE, RADIUS; and INVISIBLE and INSIDE for valid
/// input with nothing to sample. Then `*cap`, unless NULL, remembers the status, and every function on it returns
/// that and stores zeros.
#[no_mangle]
pub unsafe extern "C" fn spherecap_prepare(
    technique: u32,
    hemispheres: u32,
    defensive: f32,
    normal: *const f32,
    centre: *const f32,
    radius: f32,
    cap: *mut spherecap_cap_t,
) -> u32 {
    // SAFETY: the header's contract.
    let (normal, centre) = unsafe { (vector(normal), vector(centre)) };
    if cap.is_null() {
        return SPHERECAP_STATUS_NULL_POINTER as u32;
    }
    let result = (|| {
        let (Some(normal), Some(centre)) = (normal, centre) else {
            return Err(SPHERECAP_STATUS_NULL_POINTER);
        };
        let technique = self::technique(technique).ok_or(SPHERECAP_STATUS_TECHNIQUE)?;
        let hemispheres = self::hemispheres(hemispheres).ok_or(SPHERECAP_STATUS_HEMISPHERES)?;
        let strategy = Strategy { technique, hemispheres, defensive };
        // SAFETY: not NULL, so writable by the header's contract; a `Prepared` fits (asserted above).
        let out = unsafe { &mut *cap.cast::<MaybeUninit<Prepared>>() };
        if prepare(strategy, normal, centre, radius, out) {
            return Ok(());
        }
        // SAFETY: just written.
        let cap = unsafe { out.assume_init_ref() }.sampler.cap();
        Err(refusal(defensive, normal.into(), centre.into(), radius, cap).into())
    })();
    let Err(status) = result else { return SPHERECAP_STATUS_OK as u32 };
    let status = status as u32;
    // SAFETY: not NULL, so writable by the header's contract.
    let words = unsafe { &mut (*cap).words };
    words.fill(0);
    words[..2].copy_from_slice(&[SEAL, status]);
    status
}

/// Samples a direction towards the sphere with two random numbers in [0, 1], both ends allowed.
///
/// Stores the sample, or zeros (so a density of 0) on failure. Errors: NULL_POINTER, RANDOM_NUMBER, CAP, and what
/// `spherecap_prepare` returned for the cap.
#[no_mangle]
pub unsafe extern "C" fn spherecap_sample(
    cap: *const spherecap_cap_t,
    u0: f32,
    u1: f32,
    sample: *mut spherecap_sample_t,
) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { prepared(cap) }.and_then(|sampler| {
        let unit = 0.0..=1.0;
        if !(unit.contains(&u0) && unit.contains(&u1)) {
            return Err(SPHERECAP_STATUS_RANDOM_NUMBER as u32);
        }
        Ok(self::sample(sampler, u0, u1))
    });
    // SAFETY: the header's contract.
    unsafe { store(sample, result) }
}

/// Density of the direction with this offset; zero outside the cap and where nothing is sampled. For an offset from
/// `spherecap_sample`: the very bits that it stored.
///
/// Errors: NULL_POINTER, DIRECTION, CAP, and what `spherecap_prepare` returned for the cap; then zeros are stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf(
    cap: *const spherecap_cap_t,
    offset: *const spherecap_offset_t,
    density: *mut spherecap_density_t,
) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { prepared(cap) }
        // SAFETY: the header's contract.
        .and_then(|sampler| Ok(pdf(sampler, unsafe { self::offset(offset) }?).into()));
    // SAFETY: the header's contract.
    unsafe { store(density, result) }
}

/// Density of a unit direction (three floats); zero outside the cap. The convenient form: a unit vector in single
/// precision resolves 6e-8, so for a sphere with radius/distance = 1e-6 the cosine at the horizon is off by percents, and
/// the direction itself by tenths of the cap. Where you have the offset, use `spherecap_pdf`.
///
/// Errors: as `spherecap_pdf`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_direction(
    cap: *const spherecap_cap_t,
    direction: *const f32,
    density: *mut spherecap_density_t,
) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { prepared(cap) }
        // SAFETY: the header's contract.
        .and_then(|sampler| Ok(pdf_direction(sampler, unsafe { self::direction(direction) }?).into()));
    // SAFETY: the header's contract.
    unsafe { store(density, result) }
}

/// As `spherecap_pdf_direction`, for a direction that is known to point at the sphere (a ray has hit it): only the horizon is
/// tested, so that rounding near the limb does not lose the density.
///
/// Errors: as `spherecap_pdf`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_pdf_on_sphere(
    cap: *const spherecap_cap_t,
    direction: *const f32,
    density: *mut spherecap_density_t,
) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { prepared(cap) }
        // SAFETY: the header's contract.
        .and_then(|sampler| Ok(pdf_on_sphere(sampler, unsafe { self::direction(direction) }?).into()));
    // SAFETY: the header's contract.
    unsafe { store(density, result) }
}

/// The two random numbers (stored at `u`) that give this offset, to rounding; in a defensive mixture those of the
/// projected part. In [0, 1] for every offset.
///
/// Errors: as `spherecap_pdf`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_invert(
    cap: *const spherecap_cap_t,
    offset: *const spherecap_offset_t,
    u: *mut f32,
) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { prepared(cap) }
        // SAFETY: the header's contract.
        .and_then(|sampler| Ok(invert(sampler, unsafe { self::offset(offset) }?)));
    // SAFETY: the header's contract; an array of floats is aligned as one.
    unsafe { store(u.cast::<[f32; 2]>(), result) }
}

/// Solid angle of the whole cap, the part below the horizon included, in steradians, in (0, 2 pi] (to
/// rounding).
///
/// Errors: NULL_POINTER, CAP, and what `spherecap_prepare` returned for the cap; then zero is stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_solid_angle(cap: *const spherecap_cap_t, solid_angle: *mut f32) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { prepared(cap) }.map(|sampler| sampler.cap().solid_angle());
    // SAFETY: the header's contract.
    unsafe { store(solid_angle, result) }
}

/// Projected solid angle of the cap above the horizon, in steradians, in [0, pi] (to rounding): the
/// irradiance of an unoccluded sphere of radiance 1.
///
/// Errors: as `spherecap_solid_angle`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_projected_solid_angle(
    cap: *const spherecap_cap_t,
    projected_solid_angle: *mut f32,
) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { prepared(cap) }.map(|sampler| sampler.cap().projected_solid_angle());
    // SAFETY: the header's contract.
    unsafe { store(projected_solid_angle, result) }
}

/// An upper bound, at least 1, for the largest density over the smallest with respect to projected solid angle above the
/// horizon: the factor by which the weights of samples of a diffuse surface can differ. Infinity for `SOLID_ANGLE` where the
/// horizon cuts the cap. Of the technique alone; mixtures are not counted.
///
/// Errors: as `spherecap_solid_angle`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_density_bound(cap: *const spherecap_cap_t, bound: *mut f32) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { prepared(cap) }.map(density_bound);
    // SAFETY: the header's contract.
    unsafe { store(bound, result) }
}
