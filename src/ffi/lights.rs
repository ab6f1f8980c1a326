//! The part of the C ABI that chooses among several lights. No mathematics.

#![allow(non_camel_case_types, clippy::missing_safety_doc)] // names and words are the C header's

use super::calls::{enums, store, NULL_POINTER};
use super::instructions::instructions;
use super::single::{spherecap_receiver_t, spherecap_status_t as Status};
use crate::choice::{Choice, Total};
use crate::input::is_fraction;
use crate::lane::packet::arrays::run;
use crate::lights::LightsKernel;
use crate::strategy::{Receiver, Strategy};
use core::mem::offset_of;

/// The lights of a scene, in arrays of one number for each. An array may begin at the address of any float.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_lights_t {
    /// Number of lights, below 2^32; if 0, no array is looked at.
    pub count: usize,
    /// Their centres, in the space of the points: arrays of x, y and z.
    pub centre: [*const f32; 3],
    /// Their radii, in the same unit of length.
    pub radius: *const f32,
    /// Their radiances, in any unit: the luminance, say. Twice as much for one that shall be chosen twice as often. One that is 0,
    /// negative or not finite is never chosen.
    pub strength: *const f32,
}

/// What is known of the importances of all lights at a point: enough for the probability of each.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_total_t {
    /// Their sum.
    pub sum: f32,
    /// How many of them are positive.
    pub lit: u32,
}

/// Which light, and what is left of the random number that chose it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_choice_t {
    /// Its place in the arrays; 0 if nothing is lit.
    pub index: usize,
    /// The probability of this choice, the very bits that `spherecap_choice_probability` gives for it; 0 if nothing is lit. Times
    /// the density of a sample of that light it is the density of the sample.
    pub probability: f32,
    /// What is left of the random number, in [0, 1]: uniform again, and independent of the choice. Use it for the sample.
    pub rest: f32,
}

/// Types that C has under other names have the same layout here.
const _: () = {
    assert!(size_of::<Total>() == size_of::<spherecap_total_t>());
    assert!(offset_of!(Total, lit) == offset_of!(spherecap_total_t, lit));
    assert!(size_of::<Choice>() == size_of::<spherecap_choice_t>());
    assert!(offset_of!(Choice, probability) == offset_of!(spherecap_choice_t, probability));
    assert!(offset_of!(Choice, rest) == offset_of!(spherecap_choice_t, rest));
};

/// How much each light can give to a point (three floats), so that one can be chosen by it: about its unoccluded irradiance over pi,
/// `strength * E / pi` with the projected solid angle E, and equal to that (to 2^-21 of the distance) where all of it is above
/// the horizon.
///
/// It is what the receiver samples that counts. Both hemispheres: the irradiances of both sides. A defensive fraction: that of
/// a light in any direction, `strength * s^2 / 2` with the sine s of its angular radius, takes that fraction of the whole; so it does
/// for `SOLID_ANGLE`, whose fraction is 1. On no surface: `strength * s^2`.
///
/// Stores at `importances` one number for each light, never less than a millionth below these: so a positive one wherever
/// `spherecap_prepare` succeeds for the light's centre minus the point (in single precision) and its strength is positive. Zero for
/// a light that the point is inside of, and for one with a bad radius, centre or strength. Stores at `total` what the functions
/// below need. Keep both with the point: the probability of any light there then costs next to nothing.
///
/// Errors: NULL_POINTER (of the arrays, too), TECHNIQUE, HEMISPHERES, DEFENSIVE, NORMAL, INSTRUCTIONS; then `*total`, unless NULL, is
/// zero, and nothing else is stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_importances(
    receiver: *const spherecap_receiver_t,
    point: *const f32,
    lights: *const spherecap_lights_t,
    importances: *mut f32,
    total: *mut spherecap_total_t,
) -> u32 {
    // SAFETY: the header's contract; an array is aligned as its elements.
    let (receiver, point, lights) =
        unsafe { (receiver.as_ref(), point.cast::<[f32; 3]>().as_ref(), lights.as_ref()) };
    if total.is_null() {
        return NULL_POINTER;
    }
    let result = (|| {
        let instructions = instructions()?;
        let (Some(receiver), Some(&point), Some(lights)) = (receiver, point, lights) else {
            return Err(NULL_POINTER);
        };
        let (technique, hemispheres) = enums(receiver.technique, receiver.hemispheres)?;
        let strategy = Strategy { technique, hemispheres, defensive: receiver.defensive };
        let receiver = Receiver { normal: receiver.normal.into(), strategy };
        let kernel = LightsKernel::new(receiver, point).map_err(|refusal| Status::from(refusal) as u32)?;
        let spherecap_lights_t { count, centre: [x, y, z], radius, strength } = *lights;
        let inputs = [x, y, z, radius, strength];
        if count > 0 && (importances.is_null() || inputs.iter().any(|input| input.is_null())) {
            return Err(NULL_POINTER);
        }
        // SAFETY: the header's contract, and the CPU has these instructions.
        unsafe { run(kernel, instructions, strategy, &inputs, &[importances], count) };
        // SAFETY: as above.
        Ok(Total::of(unsafe { numbers(importances, count) }?))
    })();
    // SAFETY: the header's contract.
    unsafe { store(total.cast(), result) }
}

/// The total of `count` importances, below 2^32: for a caller who has added those of other lights to what `spherecap_importances`
/// stored, in the same unit, or who has his own.
///
/// An importance that is negative or NaN counts as 0, and one above 2^95 as that, here and in the functions below: so no sum is
/// infinite, and no probability wrong.
///
/// Errors: NULL_POINTER (of `importances` only if there are any), INSTRUCTIONS; then zeros are stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_total(
    importances: *const f32,
    count: usize,
    total: *mut spherecap_total_t,
) -> u32 {
    // SAFETY: the header's contract.
    let result = instructions().and_then(|_| Ok(Total::of(unsafe { numbers(importances, count) }?)));
    // SAFETY: the header's contract.
    unsafe { store(total.cast(), result) }
}

/// Chooses one of `count` lights in proportion to their importances, of which `total` is the total, by one random number `u` in
/// [0, 1]. (A number outside is taken for the nearer end, and NaN for 0.) Each light has one interval of it, so strata
/// survive. `even`, in [0, 1], is the fraction of the probability that is spread evenly over all importances that are not 0, for
/// where the bright lights are hidden: 0.05 costs little.
///
/// Stores the choice; if nothing is lit, or there is nothing to choose from, zeros: a probability of 0, and the status is OK.
///
/// Errors: NULL_POINTER (of `importances` only if there are any), EVEN, INSTRUCTIONS; then zeros are stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_choose(
    importances: *const f32,
    count: usize,
    total: *const spherecap_total_t,
    even: f32,
    u: f32,
    choice: *mut spherecap_choice_t,
) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { checked(total, even) }
        // SAFETY: the header's contract.
        .and_then(|total| Ok(total.choose(unsafe { numbers(importances, count) }?, even, u)));
    // SAFETY: the header's contract.
    unsafe { store(choice.cast(), result) }
}

/// The probability with which `spherecap_choose` gives a light of this importance, to the bit: for the density of a direction that
/// something else has sampled, as multiple importance sampling asks for it.
///
/// Errors: NULL_POINTER, EVEN, INSTRUCTIONS; then zero is stored.
#[no_mangle]
pub unsafe extern "C" fn spherecap_choice_probability(
    importance: f32,
    total: *const spherecap_total_t,
    even: f32,
    probability: *mut f32,
) -> u32 {
    // SAFETY: the header's contract.
    let result = unsafe { checked(total, even) }.map(|total| total.probability(importance, even));
    // SAFETY: the header's contract.
    unsafe { store(probability, result) }
}

/// # Safety
/// `total` is NULL or points to a readable `spherecap_total_t`.
unsafe fn checked(total: *const spherecap_total_t, even: f32) -> Result<Total, u32> {
    instructions()?;
    // SAFETY: the caller's promise.
    let total = *unsafe { total.cast::<Total>().as_ref() }.ok_or(NULL_POINTER)?;
    is_fraction(even).then_some(total).ok_or(Status::SPHERECAP_STATUS_EVEN as u32)
}

/// # Safety
/// `first` is NULL or points to `count` numbers that nobody writes while they are borrowed.
unsafe fn numbers<'a>(first: *const f32, count: usize) -> Result<&'a [f32], u32> {
    match (first.is_null(), count) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(NULL_POINTER),
        // SAFETY: the caller's promise.
        (false, _) => Ok(unsafe { core::slice::from_raw_parts(first, count) }),
    }
}
