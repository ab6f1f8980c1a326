#ifndef SPHERECAP_RECORD_H
#define SPHERECAP_RECORD_H

// Generated from src/ffi by cbindgen: `make header`. Do not edit.
//
// Records the kernels of spherecap.h into a program's own expression graph: for renderers that compile what they run.

#include "spherecap.h"

// What a node of a recorded graph computes from its operands. Numbers are single precision and operations IEEE 754's,
// rounded to nearest; where a graph's operations are less precise, so is what it computes.
typedef enum spherecap_op_t {
    // a + b
    SPHERECAP_OP_ADD = 0,
    // a - b
    SPHERECAP_OP_SUB = 1,
    // a * b
    SPHERECAP_OP_MUL = 2,
    // a / b
    SPHERECAP_OP_DIV = 3,
    // a * b + c, rounded once: `fmaf`.
    SPHERECAP_OP_FMA = 4,
    // -a
    SPHERECAP_OP_NEG = 5,
    // |a|
    SPHERECAP_OP_ABS = 6,
    // The square root of a; NaN below zero.
    SPHERECAP_OP_SQRT = 7,
    // a < b, a truth value; false where either is NaN.
    SPHERECAP_OP_LT = 8,
    // a <= b, likewise.
    SPHERECAP_OP_LE = 9,
    // a and b, of truth values.
    SPHERECAP_OP_AND = 10,
    // a or b, of truth values.
    SPHERECAP_OP_OR = 11,
    // not a, of a truth value.
    SPHERECAP_OP_NOT = 12,
    // b where the truth value a is true, else c: numbers.
    SPHERECAP_OP_SELECT = 13,
    // The number whose bit pattern is that of a, an `uint32_t`, and 0x7f800000: a without its sign and its significand.
    SPHERECAP_OP_POWER_OF_TWO = 14,
    // The bit pattern of a, read as `int32_t`, converted to the nearest number.
    SPHERECAP_OP_BITS = 15,
    // The number whose bit pattern is a, truncated to an `int32_t`. Where a is NaN or not in [0, 2^31) any number does: it
    // is not used.
    SPHERECAP_OP_FLOAT_OF_BITS = 16,
} spherecap_op_t;

// A program that builds an expression graph: what it takes to record the kernels. Nodes have numbers other than 0, of the
// program's choice: an index or a pointer. No function may call back into this library's, throw, or jump out.
typedef struct spherecap_recorder_t {
    // The first argument of each function.
    void *user;
    // Gives a node for a constant, or 0 if that fails.
    uint64_t (*literal)(void *user, float value);
    // Gives a node for an operation on one to three nodes (behind a pointer that holds only during the call), or 0 if that
    // fails. It may be the same node for the same operation on the same nodes. Where `is_rounded` is not 0 the operation's own
    // rounding counts: it must not be fused with another, or reordered, even where a graph's compiler does so with others. (One
    // that only fuses has to keep those products out of sums, and is done: such sums have no other products.)
    uint64_t (*op)(void *user, enum spherecap_op_t op, const uint64_t *operands, uint32_t is_rounded);
    // Takes back a node: called once for each time that `literal`, `op` or `end_if` gave it, unless it is part of a result.
    void (*release)(void *user, uint64_t node);
    // Begins a conditional and gives a name for it, or 0 for none here. Operations until its end are needed only where the
    // mask, a truth value, is true. Conditionals nest. NULL, like `end_if`, for a graph that has none: all sides of a
    // kernel's branches are then computed everywhere.
    uint64_t (*begin_if)(void *user, uint64_t mask);
    // Ends the conditional that was begun last. `nodes` are those of its nodes that are read afterwards: puts a new node in the
    // place of each, which has its value where the mask is true, and anything elsewhere. Gives 0 if that fails (then `nodes` is
    // not looked at), and anything else if not.
    uint32_t (*end_if)(void *user, uint64_t conditional, uint64_t *nodes, size_t count);
} spherecap_recorder_t;

// An input of a recorded kernel: a node or, where that is 0, a constant. Operations on constants are not recorded.
typedef struct spherecap_term_t {
    // A node, which stays the caller's; or 0.
    uint64_t node;
    // The constant.
    float constant;
} spherecap_term_t;

// What `spherecap_prepare` is given. Where it would refuse, the recorded kernels have nothing to sample.
typedef struct spherecap_recorded_input_t {
    // A `spherecap_technique_t`.
    uint32_t technique;
    // A `spherecap_hemispheres_t`.
    uint32_t hemispheres;
    // The probability of sampling by solid angle over the whole cap instead, in [0, 1].
    struct spherecap_term_t defensive;
    // The surface normal, or (0, 0, 0) on no surface.
    struct spherecap_term_t normal[3];
    // The sphere's centre minus the shading point.
    struct spherecap_term_t centre[3];
    // The sphere's radius.
    struct spherecap_term_t radius;
} spherecap_recorded_input_t;

// Nodes that compute a density. They are the caller's, who has to release each.
typedef struct spherecap_recorded_density_t {
    // With respect to solid angle, per steradian.
    uint64_t solid_angle;
    // With respect to projected solid angle: the same divided by |cosine|, but never infinite.
    uint64_t projected_solid_angle;
} spherecap_recorded_density_t;

// Nodes that compute a sample: the bits that `spherecap_sample` stores, and zeros where there is nothing to sample. They are
// the caller's, who has to release each.
typedef struct spherecap_recorded_sample_t {
    // A truth value: is there something to sample?
    uint64_t is_sampled;
    // Unit direction from the shading point.
    uint64_t direction[3];
    // Distance to the sphere's surface along the direction.
    uint64_t distance;
    // Unit outward normal of the sphere there.
    uint64_t normal[3];
    // Cosine of the direction with the surface normal.
    uint64_t cosine;
    // Density of the direction.
    struct spherecap_recorded_density_t density;
} spherecap_recorded_sample_t;

// What is known of the importances of some lights: a `spherecap_total_t`.
typedef struct spherecap_recorded_total_t {
    // Their sum.
    struct spherecap_term_t sum;
    // How many of them are positive.
    struct spherecap_term_t lit;
} spherecap_recorded_total_t;

// Nodes that compute a total. They are the caller's, who has to release each.
typedef struct spherecap_total_nodes_t {
    // The sum.
    uint64_t sum;
    // How many are positive.
    uint64_t lit;
} spherecap_total_nodes_t;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Records `spherecap_prepare` and `spherecap_sample` with two random numbers (at `u`) as one graph. Random numbers outside
// [0, 1] are taken for the nearer end, and NaN for 0.
//
// Stores the nodes that compute the results, which are new ones and the caller's. Everything else that the recorder made is
// given back to it before the function returns. The only kind of function that allocates memory, for the time of the
// call; if there is none left the process ends.
//
// Errors: NULL_POINTER (of the recorder's functions, too), TECHNIQUE, HEMISPHERES, RECORDER; then zeros are stored, and no
// node is left.
uint32_t spherecap_record_sample(const struct spherecap_recorder_t *recorder,
                                 const struct spherecap_recorded_input_t *input,
                                 const struct spherecap_term_t *u,
                                 struct spherecap_recorded_sample_t *sample);

// Records `spherecap_prepare` and `spherecap_pdf_on_sphere` for a unit direction (three terms) as one graph. The density is
// zero where there is nothing to sample and where the direction is not of unit length.
//
// Stores the nodes that compute the density; see `spherecap_record_sample` for who owns what, and for memory.
//
// Errors: as `spherecap_record_sample`.
uint32_t spherecap_record_pdf_on_sphere(const struct spherecap_recorder_t *recorder,
                                        const struct spherecap_recorded_input_t *input,
                                        const struct spherecap_term_t *direction,
                                        struct spherecap_recorded_density_t *density);

// Records the importance of a light at a point, to choose among several by: what `spherecap_importances` stores for a light with
// this centre, radius and `strength`, to the bit.
//
// Stores the node that computes it, a new one and the caller's; zero is its value where the light gives nothing and where its
// input is bad. See `spherecap_record_sample` for memory.
//
// Errors: as `spherecap_record_sample`.
uint32_t spherecap_record_importance(const struct spherecap_recorder_t *recorder,
                                     const struct spherecap_recorded_input_t *input,
                                     const struct spherecap_term_t *strength,
                                     uint64_t *importance);

// Records the addition of a light's importance to a total: a loop of the caller's over all lights, from zeros, gives what
// `spherecap_total` does, in single precision.
//
// Stores the nodes that compute the total with it at `with`; see `spherecap_record_sample` for who owns what, and for memory. An
// importance counts as `spherecap_total` says; one that is below 2^-126, as no recorded one is, may have lost its precision.
//
// Errors: NULL_POINTER (of the recorder's functions, too), RECORDER; then zeros are stored, and no node is left.
uint32_t spherecap_record_total(const struct spherecap_recorder_t *recorder,
                                const struct spherecap_term_t *importance,
                                const struct spherecap_recorded_total_t *total,
                                struct spherecap_total_nodes_t *with);

// Records the probability with which a light of this importance is chosen: what `spherecap_choice_probability` stores, in single
// precision. `even` is as there; outside [0, 1] the nearer end, and 0 for NaN.
//
// Stores the node that computes it; see `spherecap_record_sample` for who owns what, and for memory.
//
// Errors: as `spherecap_record_total`.
uint32_t spherecap_record_choice_probability(const struct spherecap_recorder_t *recorder,
                                             const struct spherecap_term_t *importance,
                                             const struct spherecap_recorded_total_t *total,
                                             const struct spherecap_term_t *even,
                                             uint64_t *probability);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SPHERECAP_RECORD_H */
