//! The part of the C ABI that records the kernels into a caller's expression graph. No mathematics.
//!
//! `include/spherecap_record.h` is generated from it.

#![allow(non_camel_case_types, clippy::missing_safety_doc)] // names and words are the C header's

use super::calls::{enums, store, NULL_POINTER};
use super::single::spherecap_status_t as Status;
use crate::choice::{add, Shares};
use crate::input::{is_unit, Input};
use crate::lane::recorded::{Backend, Conditional, NodeId, Op, Recorded, RecordedMask, Tape, Wanted};
use crate::lane::Lane;
use crate::sample::Sample;
use crate::sampling::Sampler;
use crate::strategy::{Receiver, Strategy};
use crate::vec3::Vec3;
use core::ffi::c_void;

/// What a node of a recorded graph computes from its operands. Numbers are single precision and operations IEEE 754's,
/// rounded to nearest; where a graph's operations are less precise, so is what it computes.
#[repr(C)]
pub enum spherecap_op_t {
    /// a + b
    SPHERECAP_OP_ADD = 0,
    /// a - b
    SPHERECAP_OP_SUB = 1,
    /// a * b
    SPHERECAP_OP_MUL = 2,
    /// a / b
    SPHERECAP_OP_DIV = 3,
    /// a * b + c, rounded once: `fmaf`.
    SPHERECAP_OP_FMA = 4,
    /// -a
    SPHERECAP_OP_NEG = 5,
    /// |a|
    SPHERECAP_OP_ABS = 6,
    /// The square root of a; NaN below zero.
    SPHERECAP_OP_SQRT = 7,
    /// a < b, a truth value; false where either is NaN.
    SPHERECAP_OP_LT = 8,
    /// a <= b, likewise.
    SPHERECAP_OP_LE = 9,
    /// a and b, of truth values.
    SPHERECAP_OP_AND = 10,
    /// a or b, of truth values.
    SPHERECAP_OP_OR = 11,
    /// not a, of a truth value.
    SPHERECAP_OP_NOT = 12,
    /// b where the truth value a is true, else c: numbers.
    SPHERECAP_OP_SELECT = 13,
    /// The number whose bit pattern is that of a, an `uint32_t`, and 0x7f800000: a without its sign and its significand.
    SPHERECAP_OP_POWER_OF_TWO = 14,
    /// The bit pattern of a, read as `int32_t`, converted to the nearest number.
    SPHERECAP_OP_BITS = 15,
    /// The number whose bit pattern is a, truncated to an `int32_t`. Where a is NaN or not in [0, 2^31) any number does: it
    /// is not used.
    SPHERECAP_OP_FLOAT_OF_BITS = 16,
}

/// A program that builds an expression graph: what it takes to record the kernels. Nodes have numbers other than 0, of the
/// program's choice: an index or a pointer. No function may call back into this library's, throw, or jump out.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_recorder_t {
    /// The first argument of each function.
    pub user: *mut c_void,
    /// Gives a node for a constant, or 0 if that fails.
    pub literal: Option<unsafe extern "C" fn(user: *mut c_void, value: f32) -> u64>,
    /// Gives a node for an operation on one to three nodes (behind a pointer that holds only during the call), or 0 if that
    /// fails. It may be the same node for the same operation on the same nodes. Where `is_rounded` is not 0 the operation's own
    /// rounding counts: it must not be fused with another, or reordered, even where a graph's compiler does so with others. (One
    /// that only fuses has to keep those products out of sums, and is done: such sums have no other products.)
    pub op: Option<
        unsafe extern "C" fn(
            user: *mut c_void,
            op: spherecap_op_t,
            operands: *const u64,
            is_rounded: u32,
        ) -> u64,
    >,
    /// Takes back a node: called once for each time that `literal`, `op` or `end_if` gave it, unless it is part of a result.
    pub release: Option<unsafe extern "C" fn(user: *mut c_void, node: u64)>,
    /// Begins a conditional and gives a name for it, or 0 for none here. Operations until its end are needed only where the
    /// mask, a truth value, is true. Conditionals nest. NULL, like `end_if`, for a graph that has none: all sides of a
    /// kernel's branches are then computed everywhere.
    pub begin_if: Option<unsafe extern "C" fn(user: *mut c_void, mask: u64) -> u64>,
    /// Ends the conditional that was begun last. `nodes` are those of its nodes that are read afterwards: puts a new node in the
    /// place of each, which has its value where the mask is true, and anything elsewhere. Gives 0 if that fails (then `nodes` is
    /// not looked at), and anything else if not.
    pub end_if: Option<
        unsafe extern "C" fn(user: *mut c_void, conditional: u64, nodes: *mut u64, count: usize) -> u32,
    >,
}

/// An input of a recorded kernel: a node or, where that is 0, a constant. Operations on constants are not recorded.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_term_t {
    /// A node, which stays the caller's; or 0.
    pub node: u64,
    /// The constant.
    pub constant: f32,
}

/// What `spherecap_prepare` is given. Where it would refuse, the recorded kernels have nothing to sample.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_recorded_input_t {
    /// A `spherecap_technique_t`.
    pub technique: u32,
    /// A `spherecap_hemispheres_t`.
    pub hemispheres: u32,
    /// The probability of sampling by solid angle over the whole cap instead, in [0, 1].
    pub defensive: spherecap_term_t,
    /// The surface normal, or (0, 0, 0) on no surface.
    pub normal: [spherecap_term_t; 3],
    /// The sphere's centre minus the shading point.
    pub centre: [spherecap_term_t; 3],
    /// The sphere's radius.
    pub radius: spherecap_term_t,
}

/// What is known of the importances of some lights: a `spherecap_total_t`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_recorded_total_t {
    /// Their sum.
    pub sum: spherecap_term_t,
    /// How many of them are positive.
    pub lit: spherecap_term_t,
}

/// Nodes that compute a total. They are the caller's, who has to release each.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_total_nodes_t {
    /// The sum.
    pub sum: u64,
    /// How many are positive.
    pub lit: u64,
}

/// Nodes that compute a density. They are the caller's, who has to release each.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_recorded_density_t {
    /// With respect to solid angle, per steradian.
    pub solid_angle: u64,
    /// With respect to projected solid angle: the same divided by |cosine|, but never infinite.
    pub projected_solid_angle: u64,
}

/// Nodes that compute a sample: the bits that `spherecap_sample` stores, and zeros where there is nothing to sample. They are
/// the caller's, who has to release each.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct spherecap_recorded_sample_t {
    /// A truth value: is there something to sample?
    pub is_sampled: u64,
    /// Unit direction from the shading point.
    pub direction: [u64; 3],
    /// Distance to the sphere's surface along the direction.
    pub distance: u64,
    /// Unit outward normal of the sphere there.
    pub normal: [u64; 3],
    /// Cosine of the direction with the surface normal.
    pub cosine: u64,
    /// Density of the direction.
    pub density: spherecap_recorded_density_t,
}

impl From<Op> for spherecap_op_t {
    fn from(op: Op) -> Self {
        match op {
            Op::Add => Self::SPHERECAP_OP_ADD,
            Op::Sub => Self::SPHERECAP_OP_SUB,
            Op::Mul => Self::SPHERECAP_OP_MUL,
            Op::Div => Self::SPHERECAP_OP_DIV,
            Op::Fma => Self::SPHERECAP_OP_FMA,
            Op::Neg => Self::SPHERECAP_OP_NEG,
            Op::Abs => Self::SPHERECAP_OP_ABS,
            Op::Sqrt => Self::SPHERECAP_OP_SQRT,
            Op::Lt => Self::SPHERECAP_OP_LT,
            Op::Le => Self::SPHERECAP_OP_LE,
            Op::And => Self::SPHERECAP_OP_AND,
            Op::Or => Self::SPHERECAP_OP_OR,
            Op::Not => Self::SPHERECAP_OP_NOT,
            Op::Select => Self::SPHERECAP_OP_SELECT,
            Op::PowerOfTwo => Self::SPHERECAP_OP_POWER_OF_TWO,
            Op::Bits => Self::SPHERECAP_OP_BITS,
            Op::FloatOfBits => Self::SPHERECAP_OP_FLOAT_OF_BITS,
        }
    }
}

/// A recorder that has all its functions.
struct Recorder {
    user: *mut c_void,
    literal: unsafe extern "C" fn(*mut c_void, f32) -> u64,
    op: unsafe extern "C" fn(*mut c_void, spherecap_op_t, *const u64, u32) -> u64,
    release: unsafe extern "C" fn(*mut c_void, u64),
    conditionals: Option<Conditionals>,
}

/// The functions that a recorder may lack.
#[derive(Clone, Copy)]
struct Conditionals {
    begin_if: unsafe extern "C" fn(*mut c_void, u64) -> u64,
    end_if: unsafe extern "C" fn(*mut c_void, u64, *mut u64, usize) -> u32,
}

impl Backend for Recorder {
    fn literal(&self, value: f32) -> Option<NodeId> {
        // SAFETY: the header's contract.
        Some(unsafe { (self.literal)(self.user, value) }).filter(|&node| node != 0)
    }
    fn op(&self, op: Op, operands: &[NodeId], is_rounded: bool) -> Option<NodeId> {
        // SAFETY: the header's contract.
        Some(unsafe { (self.op)(self.user, op.into(), operands.as_ptr(), is_rounded.into()) })
            .filter(|&node| node != 0)
    }
    fn begin_if(&self, mask: NodeId) -> Option<Conditional> {
        // SAFETY: the header's contract.
        let conditional = self.conditionals.map(|with| unsafe { (with.begin_if)(self.user, mask) });
        conditional.filter(|&conditional| conditional != 0).map(Conditional)
    }
    fn end_if(&self, Conditional(conditional): Conditional, nodes: &mut [NodeId]) -> Option<()> {
        // SAFETY: the header's contract.
        let is_ended =
            unsafe { (self.conditionals?.end_if)(self.user, conditional, nodes.as_mut_ptr(), nodes.len()) };
        (is_ended != 0).then_some(())
    }
    fn release(&self, node: NodeId) {
        // SAFETY: the header's contract.
        unsafe { (self.release)(self.user, node) }
    }
}

/// # Safety
/// `recorder` is NULL or points to a readable `spherecap_recorder_t`.
unsafe fn complete(recorder: *const spherecap_recorder_t) -> Result<Recorder, u32> {
    // SAFETY: the caller's promise.
    let recorder = unsafe { recorder.as_ref() }.ok_or(NULL_POINTER)?;
    let spherecap_recorder_t { user, literal, op, release, begin_if, end_if } = *recorder;
    let conditionals = match (begin_if, end_if) {
        (Some(begin_if), Some(end_if)) => Some(Conditionals { begin_if, end_if }),
        (None, None) => None,
        _ => return Err(NULL_POINTER),
    };
    match (literal, op, release) {
        (Some(literal), Some(op), Some(release)) => Ok(Recorder { user, literal, op, release, conditionals }),
        _ => Err(NULL_POINTER),
    }
}

fn lane<'t>(tape: &'t Tape, term: spherecap_term_t) -> Recorded<'t> {
    match term.node {
        0 => Recorded::Lit(term.constant),
        node => tape.input(node),
    }
}

fn vector<'t>(tape: &'t Tape, terms: [spherecap_term_t; 3]) -> Vec3<Recorded<'t>> {
    terms.map(|term| lane(tape, term)).into()
}

/// # Safety
/// `input` is NULL or points to a readable `spherecap_recorded_input_t`.
unsafe fn lanes<'t>(
    tape: &'t Tape,
    input: *const spherecap_recorded_input_t,
) -> Result<Input<Recorded<'t>>, u32> {
    // SAFETY: the caller's promise.
    let input = unsafe { input.as_ref() }.ok_or(NULL_POINTER)?;
    let (technique, hemispheres) = enums(input.technique, input.hemispheres)?;
    let strategy = Strategy { technique, hemispheres, defensive: lane(tape, input.defensive) };
    let receiver = Receiver { normal: vector(tape, input.normal), strategy };
    Ok(Input { receiver, centre: vector(tape, input.centre), radius: lane(tape, input.radius) })
}

/// The prepared sampler, and where there is something to sample.
///
/// # Safety
/// That of `lanes`.
unsafe fn prepare<'t>(
    tape: &'t Tape,
    input: *const spherecap_recorded_input_t,
) -> Result<(Sampler<Recorded<'t>>, RecordedMask<'t>), u32> {
    // SAFETY: the caller's promise.
    Ok(unsafe { lanes(tape, input) }?.prepare())
}

/// Wants a number, zero where the mask is false.
fn number_where<'t>(tape: &'t Tape, mask: RecordedMask<'t>, lane: Recorded<'t>) -> Wanted {
    tape.want_number(Recorded::select(mask, lane, Recorded::Lit(0.0)))
}

/// Records `spherecap_prepare` and `spherecap_sample` with two random numbers (at `u`) as one graph. Random numbers outside
/// [0, 1] are taken for the nearer end, and NaN for 0.
///
/// Stores the nodes that compute the results, which are new ones and the caller's. Everything else that the recorder made is
/// given back to it before the function returns. The only kind of function that allocates memory, for the time of the
/// call; if there is none left the process ends.
///
/// Errors: NULL_POINTER (of the recorder's functions, too), TECHNIQUE, HEMISPHERES, RECORDER; then zeros are stored, and no
/// node is left.
#[no_mangle]
pub unsafe extern "C" fn spherecap_record_sample(
    recorder: *const spherecap_recorder_t,
    input: *const spherecap_recorded_input_t,
    u: *const spherecap_term_t,
    sample: *mut spherecap_recorded_sample_t,
) -> u32 {
    // SAFETY: the header's contract; an array is aligned as its elements.
    let (recorder, u) = unsafe { (complete(recorder), u.cast::<[spherecap_term_t; 2]>().as_ref()) };
    let result = recorder.and_then(|recorder| {
        let u = *u.filter(|_| !sample.is_null()).ok_or(NULL_POINTER)?;
        let tape = Tape::default();
        // SAFETY: the header's contract.
        let (sampler, mask) = unsafe { prepare(&tape, input) }?;
        let [u0, u1] = u.map(|term| lane(&tape, term));
        let Sample { offset, direction, distance, normal, density } = sampler.sample(u0, u1);
        let number = |lane| number_where(&tape, mask, lane);
        let wanted = [
            tape.want_mask(mask),
            number(direction.x),
            number(direction.y),
            number(direction.z),
            number(distance),
            number(normal.x),
            number(normal.y),
            number(normal.z),
            number(offset.cosine),
            number(density.solid_angle),
            number(density.projected_solid_angle),
        ];
        let [is_sampled, dx, dy, dz, distance, nx, ny, nz, cosine, solid_angle, projected_solid_angle] =
            tape.play(&recorder, wanted).ok_or(Status::SPHERECAP_STATUS_RECORDER as u32)?;
        Ok(spherecap_recorded_sample_t {
            is_sampled,
            direction: [dx, dy, dz],
            distance,
            normal: [nx, ny, nz],
            cosine,
            density: spherecap_recorded_density_t { solid_angle, projected_solid_angle },
        })
    });
    // SAFETY: the header's contract.
    unsafe { store(sample, result) }
}

/// Records `spherecap_prepare` and `spherecap_pdf_on_sphere` for a unit direction (three terms) as one graph. The density is
/// zero where there is nothing to sample and where the direction is not of unit length.
///
/// Stores the nodes that compute the density; see `spherecap_record_sample` for who owns what, and for memory.
///
/// Errors: as `spherecap_record_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_record_pdf_on_sphere(
    recorder: *const spherecap_recorder_t,
    input: *const spherecap_recorded_input_t,
    direction: *const spherecap_term_t,
    density: *mut spherecap_recorded_density_t,
) -> u32 {
    // SAFETY: the header's contract; an array is aligned as its elements.
    let (recorder, direction) =
        unsafe { (complete(recorder), direction.cast::<[spherecap_term_t; 3]>().as_ref()) };
    let result = recorder.and_then(|recorder| {
        let direction = *direction.filter(|_| !density.is_null()).ok_or(NULL_POINTER)?;
        let tape = Tape::default();
        // SAFETY: the header's contract.
        let (sampler, mask) = unsafe { prepare(&tape, input) }?;
        let direction = vector(&tape, direction);
        let density = sampler.pdf_in_cap(sampler.offset(direction));
        let mask = mask & is_unit(direction);
        let wanted = [density.solid_angle, density.projected_solid_angle];
        let [solid_angle, projected_solid_angle] = tape
            .play(&recorder, wanted.map(|lane| number_where(&tape, mask, lane)))
            .ok_or(Status::SPHERECAP_STATUS_RECORDER as u32)?;
        Ok(spherecap_recorded_density_t { solid_angle, projected_solid_angle })
    });
    // SAFETY: the header's contract.
    unsafe { store(density, result) }
}

/// Records the importance of a light at a point, to choose among several by: what `spherecap_importances` stores for a light with
/// this centre, radius and `strength`, to the bit.
///
/// Stores the node that computes it, a new one and the caller's; zero is its value where the light gives nothing and where its
/// input is bad. See `spherecap_record_sample` for memory.
///
/// Errors: as `spherecap_record_sample`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_record_importance(
    recorder: *const spherecap_recorder_t,
    input: *const spherecap_recorded_input_t,
    strength: *const spherecap_term_t,
    importance: *mut u64,
) -> u32 {
    // SAFETY: the header's contract.
    let (recorder, strength) = unsafe { (complete(recorder), strength.as_ref()) };
    let result = recorder.and_then(|recorder| {
        let strength = *strength.filter(|_| !importance.is_null()).ok_or(NULL_POINTER)?;
        let tape = Tape::default();
        // SAFETY: the header's contract.
        let Input { receiver, centre, radius } = unsafe { lanes(&tape, input) }?;
        let number = receiver.importance(centre, radius, lane(&tape, strength));
        let [node] = tape
            .play(&recorder, [tape.want_number(number)])
            .ok_or(Status::SPHERECAP_STATUS_RECORDER as u32)?;
        Ok(node)
    });
    // SAFETY: the header's contract.
    unsafe { store(importance, result) }
}

/// Records the addition of a light's importance to a total: a loop of the caller's over all lights, from zeros, gives what
/// `spherecap_total` does, in single precision.
///
/// Stores the nodes that compute the total with it at `with`; see `spherecap_record_sample` for who owns what, and for memory. An
/// importance counts as `spherecap_total` says; one that is below 2^-126, as no recorded one is, may have lost its precision.
///
/// Errors: NULL_POINTER (of the recorder's functions, too), RECORDER; then zeros are stored, and no node is left.
#[no_mangle]
pub unsafe extern "C" fn spherecap_record_total(
    recorder: *const spherecap_recorder_t,
    importance: *const spherecap_term_t,
    total: *const spherecap_recorded_total_t,
    with: *mut spherecap_total_nodes_t,
) -> u32 {
    // SAFETY: the header's contract; an array is aligned as its elements.
    let (recorder, importance, total) = unsafe { (complete(recorder), importance.as_ref(), total.as_ref()) };
    let result = recorder.and_then(|recorder| {
        let (Some(&importance), Some(total), false) = (importance, total, with.is_null()) else {
            return Err(NULL_POINTER);
        };
        let tape = Tape::default();
        let (sum, lit) = add(lane(&tape, importance), lane(&tape, total.sum), lane(&tape, total.lit));
        let [sum, lit] = tape
            .play(&recorder, [sum, lit].map(|lane| tape.want_number(lane)))
            .ok_or(Status::SPHERECAP_STATUS_RECORDER as u32)?;
        Ok(spherecap_total_nodes_t { sum, lit })
    });
    // SAFETY: the header's contract.
    unsafe { store(with, result) }
}

/// Records the probability with which a light of this importance is chosen: what `spherecap_choice_probability` stores, in single
/// precision. `even` is as there; outside [0, 1] the nearer end, and 0 for NaN.
///
/// Stores the node that computes it; see `spherecap_record_sample` for who owns what, and for memory.
///
/// Errors: as `spherecap_record_total`.
#[no_mangle]
pub unsafe extern "C" fn spherecap_record_choice_probability(
    recorder: *const spherecap_recorder_t,
    importance: *const spherecap_term_t,
    total: *const spherecap_recorded_total_t,
    even: *const spherecap_term_t,
    probability: *mut u64,
) -> u32 {
    // SAFETY: the header's contract.
    let (recorder, importance, total, even) =
        unsafe { (complete(recorder), importance.as_ref(), total.as_ref(), even.as_ref()) };
    let result = recorder.and_then(|recorder| {
        let (Some(&importance), Some(total), Some(&even), false) =
            (importance, total, even, probability.is_null())
        else {
            return Err(NULL_POINTER);
        };
        let tape = Tape::default();
        let shares = Shares::new(lane(&tape, total.sum), lane(&tape, total.lit), lane(&tape, even));
        let share = shares.of(lane(&tape, importance));
        let [node] = tape
            .play(&recorder, [tape.want_number(share)])
            .ok_or(Status::SPHERECAP_STATUS_RECORDER as u32)?;
        Ok(node)
    });
    // SAFETY: the header's contract.
    unsafe { store(probability, result) }
}
