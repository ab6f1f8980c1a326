#ifndef SPHERECAP_H
#define SPHERECAP_H

// Generated from src/ffi*.rs by cbindgen: `make header`. Do not edit.
//
// A first program is examples/print_samples.c; tests/c/renderer.c is a small renderer.

#include <stddef.h>
#include <stdint.h>

// Number of this binary interface. A program built against another number must not be linked with this library: compare
// with `spherecap_abi_version()`.
#define SPHERECAP_ABI 1

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

// How directions are distributed. Passed as `uint32_t`.
typedef enum spherecap_technique_t {
    // Uniform in solid angle over the whole cap, also where it is below the horizon: the usual way.
    SPHERECAP_TECHNIQUE_SOLID_ANGLE = 0,
    // Uniform in projected solid angle where the sphere's centre is above the horizon, of bounded variation below it
    // (Peters and Dachsbacher 2019).
    SPHERECAP_TECHNIQUE_PROJECTED_BOUNDED = 1,
    // Uniform in projected solid angle in every case. The one to use.
    SPHERECAP_TECHNIQUE_PROJECTED = 2,
} spherecap_technique_t;

// Which sides of the surface the projected techniques cover. Passed as `uint32_t`.
typedef enum spherecap_hemispheres_t {
    // Directions above the horizon: for opaque surfaces.
    SPHERECAP_HEMISPHERES_FRONT = 0,
    // Both sides, each in proportion to |cosine|: for surfaces that transmit, or whose side is not known.
    SPHERECAP_HEMISPHERES_BOTH = 1,
} spherecap_hemispheres_t;

// What every function returns. `spherecap_status_message` says it in words.
typedef enum spherecap_status_t {
    // Success.
    SPHERECAP_STATUS_OK = 0,
    // Valid input, but the sphere is not above the horizon (or looks too small for single precision): no light.
    SPHERECAP_STATUS_INVISIBLE = 1,
    // Valid input, but the point is inside or on the sphere: no light.
    SPHERECAP_STATUS_INSIDE = 2,
    // A pointer is NULL.
    SPHERECAP_STATUS_NULL_POINTER = 3,
    // The technique is no `spherecap_technique_t`.
    SPHERECAP_STATUS_TECHNIQUE = 4,
    // The hemispheres are no `spherecap_hemispheres_t`.
    SPHERECAP_STATUS_HEMISPHERES = 5,
    // The defensive fraction is not in [0, 1].
    SPHERECAP_STATUS_DEFENSIVE = 6,
    // The normal is neither of unit length (to within 0.001) nor exactly zero.
    SPHERECAP_STATUS_NORMAL = 7,
    // The centre is not at a finite distance, or is the shading point.
    SPHERECAP_STATUS_CENTRE = 8,
    // The radius is not a positive finite number.
    SPHERECAP_STATUS_RADIUS = 9,
    // A random number is not in [0, 1].
    SPHERECAP_STATUS_RANDOM_NUMBER = 10,
    // The cap was never prepared, or its memory was overwritten.
    SPHERECAP_STATUS_CAP = 11,
    // A direction is not of unit length (to within 0.001), or an offset has a component outside [-1, 1].
    SPHERECAP_STATUS_DIRECTION = 12,
    // A function of a recorder returned 0.
    SPHERECAP_STATUS_RECORDER = 13,
} spherecap_status_t;

// A sphere seen from a shading point, prepared for sampling. Plain data for the caller's stack: copy it freely; nothing is
// to be freed. Only the functions read it.
typedef struct spherecap_cap_t {
    // Opaque.
    uint32_t words[64];
} spherecap_cap_t;

// A direction in the cap's own frame. Its components keep their relative precision where those of a unit vector drown: in
// small caps and near the horizon.
typedef struct spherecap_offset_t {
    // Component across the direction to the centre, towards the zenith, in [-1, 1] (to rounding).
    float zenith;
    // Component sideways, in [-1, 1] (to rounding).
    float side;
    // Cosine with the surface normal, in [-1, 1]; negative below the horizon, 0 without a surface.
    float cosine;
} spherecap_offset_t;

// A probability density in two measures.
typedef struct spherecap_density_t {
    // With respect to solid angle, per steradian.
    float solid_angle;
    // With respect to projected solid angle: the same divided by |cosine|, but never infinite.
    float projected_solid_angle;
} spherecap_density_t;

// A sampled direction and where it meets the sphere.
typedef struct spherecap_sample_t {
    // The direction in the cap's frame, at full precision.
    struct spherecap_offset_t offset;
    // Unit direction from the shading point.
    float direction[3];
    // Distance to the sphere's surface along the direction, in the caller's unit of length.
    float distance;
    // Unit outward normal of the sphere there: centre + radius * normal is the point itself.
    float normal[3];
    // Density of the direction: the very bits that `spherecap_pdf` gives for the offset.
    struct spherecap_density_t density;
} spherecap_sample_t;

// Spheres as seen from many points: what `spherecap_prepare` is given, in arrays of one number for each point. An array may
// begin at the address of any float. The points share the strategy. (The radius is an array, too, as each point may have
// chosen its own light. Where all see one, fill it once: it serves every batch.)
typedef struct spherecap_batch_t {
    // A `spherecap_technique_t`.
    uint32_t technique;
    // A `spherecap_hemispheres_t`.
    uint32_t hemispheres;
    // The probability of sampling by solid angle over the whole cap instead, in [0, 1].
    float defensive;
    // Number of points; if 0, no array is looked at.
    size_t count;
    // Unit normals of the surfaces, or (0, 0, 0) on no surface: arrays of x, y and z.
    const float *normal[3];
    // The spheres' centres, each minus its point: arrays of x, y and z.
    const float *centre[3];
    // The spheres' radii.
    const float *radius;
} spherecap_batch_t;

// Where to store densities: each an array of one number for each point, or NULL if it is not wanted.
typedef struct spherecap_batch_densities_t {
    // With respect to solid angle, per steradian.
    float *solid_angle;
    // With respect to projected solid angle: the same divided by |cosine|, but never infinite.
    float *projected_solid_angle;
} spherecap_batch_densities_t;

// Where to store samples: each an array of one number for each point, or NULL if it is not wanted. See
// `spherecap_sample_t`.
typedef struct spherecap_batch_samples_t {
    // The directions in the caps' frames: arrays of the zenith, side and cosine of a `spherecap_offset_t`.
    float *offset[3];
    // Unit directions from the points: arrays of x, y and z.
    float *direction[3];
    // Distances to the spheres' surfaces along the directions.
    float *distance;
    // Unit outward normals of the spheres there: arrays of x, y and z.
    float *normal[3];
    // Densities of the directions.
    struct spherecap_batch_densities_t density;
} spherecap_batch_samples_t;

// A program that builds an expression graph: what it takes to record the kernels. Nodes have numbers other than 0, of the
// program's choice: an index or a pointer. No function may call back into this library's, throw, or jump out.
typedef struct spherecap_recorder_t {
    // The first argument of each function.
    void *user;
    // Gives a node for a constant, or 0 if that fails.
    uint64_t (*literal)(void *user, float value);
    // Gives a node for an operation on one to three nodes (behind a pointer that holds only during the call), or 0 if that
    // fails. It may be the same node for the same operation on the same nodes.
    uint64_t (*op)(void *user, enum spherecap_op_t op, const uint64_t *operands);
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
typedef struct spherecap_recorded_cap_t {
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
} spherecap_recorded_cap_t;

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

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Number of the binary interface of the linked library.
uint32_t spherecap_abi_version(void);

// Version of the linked library, such as "0.1.0".
const char *spherecap_version(void);

// What a status means and what to do about it, in English words. Never NULL; not to be freed. A number that is no status
// gets words that say so.
const char *spherecap_status_message(uint32_t status);

// Prepares a cap for sampling.
//
// `technique` is a `spherecap_technique_t` and `hemispheres` a `spherecap_hemispheres_t`. `defensive`, in [0, 1], is the
// probability of sampling by solid angle over the whole cap instead; 0 unless the integrand is no multiple of the cosine
// with `normal`, as with shading normals. `normal` (three floats) is the unit normal of the surface on the side to be
// lit: used as it stands if its length is 1 to single precision, brought to unit length if it is to within 0.001; or
// exactly (0, 0, 0) for a point on no surface, as in a medium: then sampling is by solid angle. `centre` (three floats)
// is the sphere's centre minus the shading point, `radius` > 0 its radius, both in any one unit of length.
//
// Errors: NULL_POINTER, TECHNIQUE, HEMISPHERES, DEFENSIVE, NORMAL, CENTRE, RADIUS; and INVISIBLE and INSIDE for valid
// input with nothing to sample. Then `*cap`, unless NULL, remembers the status, and every function on it returns
// that and stores zeros.
uint32_t spherecap_prepare(uint32_t technique,
                           uint32_t hemispheres,
                           float defensive,
                           const float *normal,
                           const float *centre,
                           float radius,
                           struct spherecap_cap_t *cap);

// Samples a direction towards the sphere with two random numbers in [0, 1], both ends allowed.
//
// Stores the sample, or zeros (so a density of 0) on failure. Errors: NULL_POINTER, RANDOM_NUMBER, CAP, and what
// `spherecap_prepare` returned for the cap.
uint32_t spherecap_sample(const struct spherecap_cap_t *cap,
                          float u0,
                          float u1,
                          struct spherecap_sample_t *sample);

// Density of the direction with this offset; zero outside the cap and where nothing is sampled. For an offset from
// `spherecap_sample`: the very bits that it stored.
//
// Errors: NULL_POINTER, DIRECTION, CAP, and what `spherecap_prepare` returned for the cap; then zeros are stored.
uint32_t spherecap_pdf(const struct spherecap_cap_t *cap,
                       const struct spherecap_offset_t *offset,
                       struct spherecap_density_t *density);

// Density of a unit direction (three floats); zero outside the cap. The convenient form: a unit vector in single
// precision resolves 6e-8, so for a sphere with radius/distance = 1e-6 the cosine at the horizon is off by percents, and
// the direction itself by tenths of the cap. Where you have the offset, use `spherecap_pdf`.
//
// Errors: as `spherecap_pdf`.
uint32_t spherecap_pdf_direction(const struct spherecap_cap_t *cap,
                                 const float *direction,
                                 struct spherecap_density_t *density);

// As `spherecap_pdf_direction`, for a direction that is known to point at the sphere (a ray has hit it): only the horizon is
// tested, so that rounding near the limb does not lose the density.
//
// Errors: as `spherecap_pdf`.
uint32_t spherecap_pdf_on_sphere(const struct spherecap_cap_t *cap,
                                 const float *direction,
                                 struct spherecap_density_t *density);

// The two random numbers (stored at `u`) that give this offset, to rounding; in a defensive mixture those of the
// projected part. In [0, 1] for every offset.
//
// Errors: as `spherecap_pdf`.
uint32_t spherecap_invert(const struct spherecap_cap_t *cap,
                          const struct spherecap_offset_t *offset,
                          float *u);

// Solid angle of the whole cap, the part below the horizon included, in steradians, in (0, 2 pi] (to
// rounding).
//
// Errors: NULL_POINTER, CAP, and what `spherecap_prepare` returned for the cap; then zero is stored.
uint32_t spherecap_solid_angle(const struct spherecap_cap_t *cap, float *solid_angle);

// Projected solid angle of the cap above the horizon, in steradians, in [0, pi] (to rounding): the
// irradiance of an unoccluded sphere of radiance 1.
//
// Errors: as `spherecap_solid_angle`.
uint32_t spherecap_projected_solid_angle(const struct spherecap_cap_t *cap, float *projected_solid_angle);

// An upper bound, at least 1, for the largest density over the smallest with respect to projected solid angle above the
// horizon: the factor by which the weights of samples of a diffuse surface can differ. Infinity for `SOLID_ANGLE` where the
// horizon cuts the cap. Of the technique alone; mixtures are not counted.
//
// Errors: as `spherecap_solid_angle`.
uint32_t spherecap_density_bound(const struct spherecap_cap_t *cap,
                                 float *bound);

// The instructions that the functions on arrays use on this CPU: "AVX-512", "AVX2", or "portable" for one number at a time.
// Not to be freed. The results are the same.
const char *spherecap_batch_instructions(void);

// Prepares the spheres and samples a direction towards each, with the random numbers in the arrays `u0` and `u1`.
//
// Stores for each point what `spherecap_sample` stores, to the bit, wherever in the arrays it is. A density of zero tells
// where it would have failed: where nothing is above the horizon, or the input is bad, which `spherecap_prepare` can tell
// apart. Arrays that are stored to must not overlap each other or those that are read. For several threads, give each a
// part of the arrays.
//
// Errors: NULL_POINTER (of the arrays that are read, too), TECHNIQUE, HEMISPHERES, DEFENSIVE; then nothing is stored.
uint32_t spherecap_batch_sample(const struct spherecap_batch_t *batch,
                                const float *u0,
                                const float *u1,
                                const struct spherecap_batch_samples_t *samples);

// `spherecap_pdf` for each point, of the offsets in three arrays (at `offset`): zenith, side and cosine. The density is also
// zero where the sphere or the offset would be refused.
//
// Errors: as `spherecap_batch_sample`.
uint32_t spherecap_batch_pdf(const struct spherecap_batch_t *batch,
                             const float *const *offset,
                             const struct spherecap_batch_densities_t *densities);

// `spherecap_pdf_direction` for each point, of the unit directions in three arrays (at `direction`): x, y and z. The density
// is also zero where the sphere or the direction would be refused.
//
// Errors: as `spherecap_batch_sample`.
uint32_t spherecap_batch_pdf_direction(const struct spherecap_batch_t *batch,
                                       const float *const *direction,
                                       const struct spherecap_batch_densities_t *densities);

// `spherecap_pdf_on_sphere` for each point; otherwise as `spherecap_batch_pdf_direction`.
//
// Errors: as `spherecap_batch_sample`.
uint32_t spherecap_batch_pdf_on_sphere(const struct spherecap_batch_t *batch,
                                       const float *const *direction,
                                       const struct spherecap_batch_densities_t *densities);

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
                                 const struct spherecap_recorded_cap_t *cap,
                                 const struct spherecap_term_t *u,
                                 struct spherecap_recorded_sample_t *sample);

// Records `spherecap_prepare` and `spherecap_pdf_on_sphere` for a unit direction (three terms) as one graph. The density is
// zero where there is nothing to sample and where the direction is not of unit length.
//
// Stores the nodes that compute the density; see `spherecap_record_sample` for who owns what, and for memory.
//
// Errors: as `spherecap_record_sample`.
uint32_t spherecap_record_pdf_on_sphere(const struct spherecap_recorder_t *recorder,
                                        const struct spherecap_recorded_cap_t *cap,
                                        const struct spherecap_term_t *direction,
                                        struct spherecap_recorded_density_t *density);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SPHERECAP_H */
