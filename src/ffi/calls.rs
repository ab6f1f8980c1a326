//! What the functions of the C ABI on single points do, for both precisions.

use super::double::{
    spherecap_density_f64_t, spherecap_offset_f64_t, spherecap_receiver_f64_t, spherecap_sample_f64_t,
    spherecap_sampler_f64_t,
};
use super::instructions::instructions;
use super::single::{
    spherecap_density_t, spherecap_hemispheres_t, spherecap_offset_t, spherecap_receiver_t,
    spherecap_sample_t, spherecap_sampler_t, spherecap_status_t as Status, spherecap_technique_t,
    SPHERECAP_ABI,
};
use crate::batch::Instructions;
use crate::input::{is_offset, is_unit, Input, Refusal};
use crate::offset::Offset;
use crate::prepare::Scalar;
use crate::sample::{Density, Sample};
use crate::sampling::Sampler;
use crate::strategy::{Hemispheres, Receiver, Strategy, Technique};
use core::mem::{offset_of, MaybeUninit};

pub(super) const OK: u32 = Status::SPHERECAP_STATUS_OK as u32;
pub(super) const NULL_POINTER: u32 = Status::SPHERECAP_STATUS_NULL_POINTER as u32;

/// The precisions.
pub(super) trait Precision: Scalar {
    /// The C type of a sampler, big enough for a [`Prepared`].
    type Memory;
    /// Marks memory that was prepared in this precision: "scap", what tells them apart, and the ABI.
    const SEAL: u32 = 0x7363_6170 ^ (size_of::<Self>() as u32) << 8 ^ SPHERECAP_ABI;
}
impl Precision for f32 {
    type Memory = spherecap_sampler_t;
}
impl Precision for f64 {
    type Memory = spherecap_sampler_f64_t;
}

/// The C receiver.
#[repr(C)]
#[derive(Clone, Copy)]
pub(super) struct RawReceiver<F> {
    normal: [F; 3],
    technique: u32,
    hemispheres: u32,
    defensive: F,
}

/// What a C sampler holds.
#[repr(C)]
pub(super) struct Prepared<F> {
    seal: u32,
    status: u32,
    sampler: Sampler<F>,
}

/// The first words of a [`Prepared`], checked before it is looked at as one: seal, status and the enums.
type Header = [u32; 4];
const TECHNIQUE: usize = 2;
const HEMISPHERES: usize = 3;

/// Types that C has under other names have the same layout here.
macro_rules! assert_layouts {
    ($float:ty, $sampler:ty, $receiver:ty, $offset:ty, $density:ty, $sample:ty) => {
        const _: () = {
            assert!(size_of::<Prepared<$float>>() <= size_of::<$sampler>());
            assert!(align_of::<Prepared<$float>>() == align_of::<$sampler>());
            assert!(offset_of!(Prepared<$float>, sampler.technique) == TECHNIQUE * size_of::<u32>());
            assert!(offset_of!(Prepared<$float>, sampler.hemispheres) == HEMISPHERES * size_of::<u32>());
            assert!(size_of::<RawReceiver<$float>>() == size_of::<$receiver>());
            assert!(offset_of!(RawReceiver<$float>, technique) == offset_of!($receiver, technique));
            assert!(offset_of!(RawReceiver<$float>, hemispheres) == offset_of!($receiver, hemispheres));
            assert!(offset_of!(RawReceiver<$float>, defensive) == offset_of!($receiver, defensive));
            assert!(size_of::<Offset<$float>>() == size_of::<$offset>());
            assert!(offset_of!(Offset<$float>, side) == offset_of!($offset, side));
            assert!(offset_of!(Offset<$float>, cosine) == offset_of!($offset, cosine));
            assert!(size_of::<Density<$float>>() == size_of::<$density>());
            assert!(
                offset_of!(Density<$float>, projected_solid_angle)
                    == offset_of!($density, projected_solid_angle)
            );
            assert!(size_of::<Sample<$float>>() == size_of::<$sample>());
            assert!(offset_of!(Sample<$float>, direction) == offset_of!($sample, direction));
            assert!(offset_of!(Sample<$float>, distance) == offset_of!($sample, distance));
            assert!(offset_of!(Sample<$float>, normal) == offset_of!($sample, normal));
            assert!(offset_of!(Sample<$float>, density) == offset_of!($sample, density));
        };
    };
}
assert_layouts!(
    f32,
    spherecap_sampler_t,
    spherecap_receiver_t,
    spherecap_offset_t,
    spherecap_density_t,
    spherecap_sample_t
);
assert_layouts!(
    f64,
    spherecap_sampler_f64_t,
    spherecap_receiver_f64_t,
    spherecap_offset_f64_t,
    spherecap_density_f64_t,
    spherecap_sample_f64_t
);

impl From<Refusal> for Status {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Invisible => Self::SPHERECAP_STATUS_INVISIBLE,
            Refusal::Inside => Self::SPHERECAP_STATUS_INSIDE,
            Refusal::Defensive => Self::SPHERECAP_STATUS_DEFENSIVE,
            Refusal::Normal => Self::SPHERECAP_STATUS_NORMAL,
            Refusal::Centre => Self::SPHERECAP_STATUS_CENTRE,
            Refusal::Radius => Self::SPHERECAP_STATUS_RADIUS,
        }
    }
}

/// Compiles a kernel call twice, plainly and with fused multiply-adds as instructions, and takes what it is told to. The results
/// are the same to the bit; without the instruction each is a call.
macro_rules! kernel {
    (fn $name:ident($($arg:ident: $type:ty),*) -> $result:ty $body:block) => {
        #[inline]
        fn $name<F: Precision>(instructions: Instructions, $($arg: $type),*) -> $result {
            #[inline(always)]
            fn plain<F: Precision>($($arg: $type),*) -> $result $body
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2,fma")]
                fn fused<F: Precision>($($arg: $type),*) -> $result {
                    plain($($arg),*)
                }
                if instructions != Instructions::Portable {
                    // SAFETY: the CPU has these features where it has any instructions that are not portable.
                    return unsafe { fused($($arg),*) };
                }
            }
            #[cfg(not(target_arch = "x86_64"))]
            let _ = instructions;
            plain($($arg),*)
        }
    };
}

kernel! {
    fn kernel_prepare(input: Input<F>, out: &mut MaybeUninit<Prepared<F>>) -> bool {
        let (sampler, is_possible) = input.prepare();
        // Stored here, so that it is not copied.
        out.write(Prepared { seal: F::SEAL, status: Status::SPHERECAP_STATUS_OK as u32, sampler });
        is_possible
    }
}
kernel! {
    fn kernel_sample_once(input: Input<F>, u: [F; 2]) -> (Sample<F>, F, bool) {
        input.sample(u)
    }
}
kernel! {
    fn kernel_pdf_once(input: Input<F>, direction: [F; 3]) -> (Density<F>, F, bool) {
        input.pdf(direction.into())
    }
}
kernel! {
    fn kernel_sample(sampler: &Sampler<F>, u0: F, u1: F) -> Sample<F> {
        sampler.sample(u0, u1)
    }
}
kernel! {
    fn kernel_pdf(sampler: &Sampler<F>, offset: Offset<F>) -> Density<F> {
        sampler.pdf(offset)
    }
}
kernel! {
    fn kernel_pdf_direction(sampler: &Sampler<F>, direction: [F; 3]) -> Density<F> {
        sampler.pdf_direction(direction)
    }
}
kernel! {
    fn kernel_pdf_on_sphere(sampler: &Sampler<F>, direction: [F; 3]) -> Density<F> {
        sampler.pdf_on_sphere(direction)
    }
}
kernel! {
    fn kernel_density_bound(sampler: &Sampler<F>) -> F {
        sampler.density_bound()
    }
}
kernel! {
    fn kernel_invert(sampler: &Sampler<F>, offset: Offset<F>) -> [F; 2] {
        sampler.invert(offset)
    }
}

/// The technique and the hemispheres of these numbers, or the status that says which is none.
pub(super) fn enums(technique: u32, hemispheres: u32) -> Result<(Technique, Hemispheres), u32> {
    const PROJECTED: u32 = spherecap_technique_t::SPHERECAP_TECHNIQUE_PROJECTED as u32;
    const PROJECTED_BOUNDED: u32 = spherecap_technique_t::SPHERECAP_TECHNIQUE_PROJECTED_BOUNDED as u32;
    const SOLID_ANGLE: u32 = spherecap_technique_t::SPHERECAP_TECHNIQUE_SOLID_ANGLE as u32;
    const FRONT: u32 = spherecap_hemispheres_t::SPHERECAP_HEMISPHERES_FRONT as u32;
    const BOTH: u32 = spherecap_hemispheres_t::SPHERECAP_HEMISPHERES_BOTH as u32;
    let technique = match technique {
        PROJECTED => Technique::Projected,
        PROJECTED_BOUNDED => Technique::ProjectedBounded,
        SOLID_ANGLE => Technique::SolidAngle,
        _ => return Err(Status::SPHERECAP_STATUS_TECHNIQUE as u32),
    };
    let hemispheres = match hemispheres {
        FRONT => Hemispheres::Front,
        BOTH => Hemispheres::Both,
        _ => return Err(Status::SPHERECAP_STATUS_HEMISPHERES as u32),
    };
    Ok((technique, hemispheres))
}

/// The sampler in prepared memory and the instructions to use, or the status that its preparation ended with.
///
/// # Safety
/// `sampler` is NULL or points to a readable C sampler.
pub(super) unsafe fn prepared<'a, F: Precision>(
    sampler: *const Prepared<F>,
) -> Result<(&'a Sampler<F>, Instructions), u32> {
    let instructions = instructions()?;
    // SAFETY: the caller's promise; a header fits into the memory.
    let header = unsafe { sampler.cast::<Header>().as_ref() };
    let &[seal, status, technique, hemispheres] = header.ok_or(NULL_POINTER)?;
    if seal != F::SEAL || status > Status::SPHERECAP_STATUS_RADIUS as u32 {
        return Err(Status::SPHERECAP_STATUS_SAMPLER as u32);
    }
    if status != OK {
        return Err(status);
    }
    if enums(technique, hemispheres).is_err() {
        return Err(Status::SPHERECAP_STATUS_SAMPLER as u32);
    }
    // SAFETY: size and alignment fit, the enums are valid, and every other field may have any bits.
    Ok((unsafe { &(*sampler).sampler }, instructions))
}

/// # Safety
/// `offset` is NULL or points to a readable offset.
unsafe fn checked_offset<F: Precision>(offset: *const Offset<F>) -> Result<Offset<F>, u32> {
    // SAFETY: the caller's promise.
    let offset = *unsafe { offset.as_ref() }.ok_or(NULL_POINTER)?;
    is_offset(offset).then_some(offset).ok_or(Status::SPHERECAP_STATUS_DIRECTION as u32)
}

/// # Safety
/// `direction` is NULL or points to three readable numbers.
unsafe fn checked_direction<F: Precision>(direction: *const F) -> Result<[F; 3], u32> {
    // SAFETY: the caller's promise; an array is aligned as its elements.
    let direction = *unsafe { direction.cast::<[F; 3]>().as_ref() }.ok_or(NULL_POINTER)?;
    is_unit(direction.into()).then_some(direction).ok_or(Status::SPHERECAP_STATUS_DIRECTION as u32)
}

/// Stores a value, or zeros where there is none, behind a pointer that may be NULL, and gives the status.
///
/// # Safety
/// `out` is NULL or points to a writable `T`, for which all zeros is a value.
pub(super) unsafe fn store<T>(out: *mut T, value: Result<T, u32>) -> u32 {
    if out.is_null() {
        return NULL_POINTER;
    }
    match value {
        Ok(value) => {
            // SAFETY: the caller's promise.
            unsafe { out.write(value) };
            OK
        }
        Err(status) => {
            // SAFETY: the caller's promise.
            unsafe { out.write_bytes(0, 1) };
            status
        }
    }
}

/// A sphere as seen from a point, checked as far as types go.
///
/// # Safety
/// `receiver` and `centre` are NULL or point to what their types say, `centre` to three numbers.
unsafe fn input<F: Precision>(
    receiver: *const RawReceiver<F>,
    centre: *const F,
    radius: F,
) -> Result<Input<F>, u32> {
    // SAFETY: the caller's promise; an array is aligned as its elements.
    let (receiver, centre) = unsafe { (receiver.as_ref(), centre.cast::<[F; 3]>().as_ref()) };
    let (Some(receiver), Some(&centre)) = (receiver, centre) else { return Err(NULL_POINTER) };
    let (technique, hemispheres) = enums(receiver.technique, receiver.hemispheres)?;
    let strategy = Strategy { technique, hemispheres, defensive: receiver.defensive };
    let receiver = Receiver { normal: receiver.normal.into(), strategy };
    Ok(Input { receiver, centre: centre.into(), radius })
}

// What the functions of the header do. Their safety is its contract: pointers are NULL, or to what their types say.

pub(super) unsafe fn prepare<F: Precision>(
    receiver: *const RawReceiver<F>,
    centre: *const F,
    radius: F,
    sampler: *mut Prepared<F>,
) -> u32 {
    if sampler.is_null() {
        return NULL_POINTER;
    }
    let result = (|| {
        let instructions = instructions()?;
        // SAFETY: the header's contract.
        let input = unsafe { input(receiver, centre, radius) }?;
        // SAFETY: not NULL, so writable by the header's contract; a `Prepared` fits (asserted above).
        let out = unsafe { &mut *sampler.cast::<MaybeUninit<Prepared<F>>>() };
        if kernel_prepare(instructions, input, out) {
            return Ok(());
        }
        // SAFETY: just written.
        let distance = unsafe { out.assume_init_ref() }.sampler.cap().distance();
        Err(Status::from(input.refusal(distance)) as u32)
    })();
    let Err(status) = result else { return OK };
    // SAFETY: not NULL, so writable by the header's contract; a header fits.
    unsafe {
        sampler.cast::<F::Memory>().write_bytes(0, 1);
        sampler.cast::<Header>().write([F::SEAL, status, 0, 0]);
    }
    status
}

pub(super) unsafe fn sample_once<F: Precision>(
    receiver: *const RawReceiver<F>,
    centre: *const F,
    radius: F,
    u: [F; 2],
    sample: *mut Sample<F>,
) -> u32 {
    let result = (|| {
        let instructions = instructions()?;
        // SAFETY: the header's contract.
        let input = unsafe { input(receiver, centre, radius) }?;
        let (sample, distance, is_possible) = kernel_sample_once(instructions, input, u);
        if is_possible {
            Ok(sample)
        } else {
            Err(Status::from(input.refusal(distance)) as u32)
        }
    })();
    // SAFETY: the header's contract.
    unsafe { store(sample, result) }
}

pub(super) unsafe fn pdf_once<F: Precision>(
    receiver: *const RawReceiver<F>,
    centre: *const F,
    radius: F,
    direction: *const F,
    density: *mut Density<F>,
) -> u32 {
    let result = (|| {
        let instructions = instructions()?;
        // SAFETY: the header's contract.
        let input = unsafe { input(receiver, centre, radius) }?;
        // SAFETY: the header's contract.
        let direction = unsafe { checked_direction(direction) }?;
        let (density, distance, is_possible) = kernel_pdf_once(instructions, input, direction);
        if is_possible {
            Ok(density)
        } else {
            Err(Status::from(input.refusal(distance)) as u32)
        }
    })();
    // SAFETY: the header's contract.
    unsafe { store(density, result) }
}

pub(super) unsafe fn sample<F: Precision>(
    sampler: *const Prepared<F>,
    u0: F,
    u1: F,
    sample: *mut Sample<F>,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe {
        store(sample, prepared(sampler).map(|(s, instructions)| kernel_sample(instructions, s, u0, u1)))
    }
}

pub(super) unsafe fn pdf<F: Precision>(
    sampler: *const Prepared<F>,
    offset: *const Offset<F>,
    density: *mut Density<F>,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe {
        let result =
            prepared(sampler).and_then(|(sampler, by)| Ok(kernel_pdf(by, sampler, checked_offset(offset)?)));
        store(density, result)
    }
}

pub(super) unsafe fn pdf_direction<F: Precision>(
    sampler: *const Prepared<F>,
    direction: *const F,
    density: *mut Density<F>,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe {
        let result = prepared(sampler)
            .and_then(|(sampler, by)| Ok(kernel_pdf_direction(by, sampler, checked_direction(direction)?)));
        store(density, result)
    }
}

pub(super) unsafe fn pdf_on_sphere<F: Precision>(
    sampler: *const Prepared<F>,
    direction: *const F,
    density: *mut Density<F>,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe {
        let result = prepared(sampler)
            .and_then(|(sampler, by)| Ok(kernel_pdf_on_sphere(by, sampler, checked_direction(direction)?)));
        store(density, result)
    }
}

pub(super) unsafe fn invert<F: Precision>(
    sampler: *const Prepared<F>,
    offset: *const Offset<F>,
    u: *mut F,
) -> u32 {
    // SAFETY: the header's contract; an array is aligned as its elements.
    unsafe {
        let result = prepared(sampler)
            .and_then(|(sampler, by)| Ok(kernel_invert(by, sampler, checked_offset(offset)?)));
        store(u.cast::<[F; 2]>(), result)
    }
}

pub(super) unsafe fn solid_angle<F: Precision>(sampler: *const Prepared<F>, solid_angle: *mut F) -> u32 {
    // SAFETY: the header's contract.
    unsafe { store(solid_angle, prepared(sampler).map(|(sampler, _)| sampler.cap().solid_angle())) }
}

pub(super) unsafe fn projected_solid_angle<F: Precision>(
    sampler: *const Prepared<F>,
    projected_solid_angle: *mut F,
) -> u32 {
    // SAFETY: the header's contract.
    unsafe {
        let result = prepared(sampler).map(|(sampler, _)| sampler.cap().projected_solid_angle());
        store(projected_solid_angle, result)
    }
}

pub(super) unsafe fn density_bound<F: Precision>(sampler: *const Prepared<F>, bound: *mut F) -> u32 {
    // SAFETY: the header's contract.
    unsafe { store(bound, prepared(sampler).map(|(sampler, by)| kernel_density_bound(by, sampler))) }
}
