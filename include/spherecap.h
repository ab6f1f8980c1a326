#ifndef SPHERECAP_H
#define SPHERECAP_H

// Generated from src/ffi by cbindgen: `make header`. Do not edit.
//
// Samples spherical lights: prepare a sampler for a receiver and a sphere, sample directions, ask for densities.
// A first program is examples/print_samples.c; tests/c/renderer.c is a small renderer; docs/c.md explains.
//
// Threads: no function changes anything but what its arguments point to, so any number of threads may call any of them, and
// share what is only read (samplers, receivers). Nothing is allocated, and no thread is started.
//
// Floating point: rounding must be to nearest, as it is unless a program changes it; in another mode, functions on arrays and
// on single points differ in the last digits. Modes that flush subnormal numbers to zero may be on: such numbers (below 1.2e-38
// in single precision) then count as zeros.
//
// Debugging: the environment variable SPHERECAP_INSTRUCTIONS chooses instructions, see `spherecap_batch_instructions`.

#include <stddef.h>
#include <stdint.h>

// Version of this header, for `#if`; `spherecap_version()` is the library's.
#define SPHERECAP_VERSION_MAJOR 0
#define SPHERECAP_VERSION_MINOR 1
#define SPHERECAP_VERSION_PATCH 0

// Number of this binary interface. A program built against another number must not be linked with this library: compare
// with `spherecap_abi_version()`.
#define SPHERECAP_ABI 3

// How directions are distributed. Passed as `uint32_t`.
typedef enum spherecap_technique_t {
    // Uniform in projected solid angle in every case. The one to use.
    SPHERECAP_TECHNIQUE_PROJECTED = 0,
    // Uniform in projected solid angle where the sphere's centre is above the horizon, of bounded variation below it
    // (Peters and Dachsbacher 2019).
    SPHERECAP_TECHNIQUE_PROJECTED_BOUNDED = 1,
    // Uniform in solid angle over the whole cap, also where it is below the horizon: the usual way.
    SPHERECAP_TECHNIQUE_SOLID_ANGLE = 2,
} spherecap_technique_t;

// Which sides of the surface the projected techniques cover. Passed as `uint32_t`.
typedef enum spherecap_hemispheres_t {
    // Directions above the horizon: for opaque surfaces.
    SPHERECAP_HEMISPHERES_FRONT = 0,
    // Both sides, each in proportion to |cosine|: for surfaces that transmit, or whose side is not known.
    SPHERECAP_HEMISPHERES_BOTH = 1,
} spherecap_hemispheres_t;

// What every function returns that can fail. `spherecap_status_message` says it in words.
typedef enum spherecap_status_t {
    // Success.
    SPHERECAP_STATUS_OK = 0,
    // Valid input, but nothing is sampled: the sphere is not above the horizon, or looks too small for the precision. (With
    // `SOLID_ANGLE`, `BOTH` or a defensive fraction, which sample below the horizon, too, a sphere there is OK.)
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
    // The normal is not finite.
    SPHERECAP_STATUS_NORMAL = 7,
    // The centre is not at a finite distance, or is the shading point.
    SPHERECAP_STATUS_CENTRE = 8,
    // The radius is not a positive finite number.
    SPHERECAP_STATUS_RADIUS = 9,
    // A direction is not of unit length (to within 0.001), or an offset has a component outside [-1, 1] (by more than that).
    SPHERECAP_STATUS_DIRECTION = 10,
    // The sampler was never prepared with this precision and this version, or was overwritten. Noticed by its first 16 bytes
    // alone, which say how to read the rest: what other overwritten bytes give is anything, but does no harm.
    SPHERECAP_STATUS_SAMPLER = 11,
    // The environment variable `SPHERECAP_INSTRUCTIONS` is set to something else than "portable", "avx2" or "avx512", or to
    // what this CPU does not have.
    SPHERECAP_STATUS_INSTRUCTIONS = 12,
    // A function of a recorder returned 0.
    SPHERECAP_STATUS_RECORDER = 13,
    // The part of a choice that is spread evenly is not in [0, 1].
    SPHERECAP_STATUS_EVEN = 14,
} spherecap_status_t;

// What receives the light: a surface, or a point on none, and how its light is sampled. All zeros but a normal are the right
// choice for a diffuse surface. Whoever asks for a density, as multiple importance sampling does, must ask with the receiver
// that samples: so carry it along.
typedef struct spherecap_receiver_t {
    // Normal of the surface on the side to be lit, of any length; or exactly (0, 0, 0) for a point on no surface, as in a
    // medium: then sampling is by solid angle. If its length is 1 to single precision it is used as it stands.
    float normal[3];
    // A `spherecap_technique_t`.
    uint32_t technique;
    // A `spherecap_hemispheres_t`.
    uint32_t hemispheres;
    // The probability of sampling by solid angle over the whole cap instead, in [0, 1]; 0 unless the integrand is no multiple
    // of the cosine with `normal`, as with shading normals. Where it is positive, a sphere wholly below the horizon is sampled,
    // too: OK, not INVISIBLE.
    float defensive;
} spherecap_receiver_t;

// A sphere seen from a shading point, prepared for sampling. Plain data for the caller's stack: copy it freely; nothing is
// to be freed. Only the functions read it.
typedef struct spherecap_sampler_t {
    // Opaque.
    uint32_t words[64];
} spherecap_sampler_t;

// A direction in the cap's own frame. Its components keep their relative precision where those of a unit vector drown: in
// small caps and near the horizon.
typedef struct spherecap_offset_t {
    // Component across the direction to the centre, towards the zenith, in [-1, 1] (to rounding).
    float zenith;
    // Component sideways, in [-1, 1] (to rounding).
    float side;
    // Cosine with the surface normal, in [-1, 1]; negative below the horizon, 0 without a surface. The one to use: a unit
    // vector, rounded, may be below a horizon that this is above.
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
    // Unit direction from the shading point. For cosines take `offset.cosine`.
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
    // Normals of the surfaces, of any length, or (0, 0, 0) on no surface: arrays of x, y and z.
    const float *normal[3];
    // The spheres' centres, each minus its point: arrays of x, y and z.
    const float *centre[3];
    // The spheres' radii.
    const float *radius;
} spherecap_batch_t;

// Random numbers, two for each point.
typedef struct spherecap_batch_random_t {
    // First numbers of the points.
    const float *u0;
    // Second numbers.
    const float *u1;
} spherecap_batch_random_t;

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

// Offsets, one for each point: see `spherecap_offset_t`.
typedef struct spherecap_batch_offsets_t {
    // Components towards the zenith.
    const float *zenith;
    // Components sideways.
    const float *side;
    // Cosines with the surface normals.
    const float *cosine;
} spherecap_batch_offsets_t;

// Unit directions, one for each point.
typedef struct spherecap_batch_directions_t {
    // First components.
    const float *x;
    // Second components.
    const float *y;
    // Third components.
    const float *z;
} spherecap_batch_directions_t;

// Where to store what is measured of the spheres: each an array of one number for each point, or NULL if it is not wanted.
typedef struct spherecap_batch_measures_t {
    // What `spherecap_solid_angle` stores.
    float *solid_angle;
    // What `spherecap_projected_solid_angle` stores: irradiances of unoccluded spheres of radiance 1.
    float *projected_solid_angle;
} spherecap_batch_measures_t;

// The lights of a scene, in arrays of one number for each. An array may begin at the address of any float.
typedef struct spherecap_lights_t {
    // Number of lights, below 2^32; if 0, no array is looked at.
    size_t count;
    // Their centres, in the space of the points: arrays of x, y and z.
    const float *centre[3];
    // Their radii, in the same unit of length.
    const float *radius;
    // Their radiances, in any unit: the luminance, say. Twice as much for one that shall be chosen twice as often. One that is 0,
    // negative or not finite is never chosen.
    const float *strength;
} spherecap_lights_t;

// What is known of the importances of all lights at a point: enough for the probability of each.
typedef struct spherecap_total_t {
    // Their sum.
    float sum;
    // How many of them are positive.
    uint32_t lit;
} spherecap_total_t;

// Which light, and what is left of the random number that chose it.
typedef struct spherecap_choice_t {
    // Its place in the arrays; 0 if nothing is lit.
    size_t index;
    // The probability of this choice, the very bits that `spherecap_choice_probability` gives for it; 0 if nothing is lit. Times
    // the density of a sample of that light it is the density of the sample.
    float probability;
    // What is left of the random number, in [0, 1]: uniform again, and independent of the choice. Use it for the sample.
    float rest;
} spherecap_choice_t;

// `spherecap_receiver_t` in double precision.
typedef struct spherecap_receiver_f64_t {
    // Normal of the surface, or (0, 0, 0).
    double normal[3];
    // A `spherecap_technique_t`.
    uint32_t technique;
    // A `spherecap_hemispheres_t`.
    uint32_t hemispheres;
    // The probability of sampling by solid angle instead.
    double defensive;
} spherecap_receiver_f64_t;

// `spherecap_sampler_t` in double precision. Functions of the other precision refuse it.
typedef struct spherecap_sampler_f64_t {
    // Opaque.
    uint64_t words[64];
} spherecap_sampler_f64_t;

// `spherecap_offset_t` in double precision.
typedef struct spherecap_offset_f64_t {
    // Component towards the zenith.
    double zenith;
    // Component sideways.
    double side;
    // Cosine with the surface normal.
    double cosine;
} spherecap_offset_f64_t;

// `spherecap_density_t` in double precision.
typedef struct spherecap_density_f64_t {
    // With respect to solid angle.
    double solid_angle;
    // With respect to projected solid angle.
    double projected_solid_angle;
} spherecap_density_f64_t;

// `spherecap_sample_t` in double precision.
typedef struct spherecap_sample_f64_t {
    // The direction in the cap's frame.
    struct spherecap_offset_f64_t offset;
    // Unit direction from the shading point.
    double direction[3];
    // Distance to the sphere's surface.
    double distance;
    // Unit outward normal of the sphere there.
    double normal[3];
    // Density of the direction.
    struct spherecap_density_f64_t density;
} spherecap_sample_f64_t;

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

// Prepares a sampler of the sphere with this centre and radius, for what receives its light.
//
// `centre` (three floats) is the sphere's centre minus the shading point, `radius` > 0 its radius, both in any one unit of
// length. A receiver is only read.
//
// Errors: NULL_POINTER, TECHNIQUE, HEMISPHERES, DEFENSIVE, NORMAL, CENTRE, RADIUS, INSTRUCTIONS; and INVISIBLE and INSIDE for
// valid input with nothing to sample. Then `*sampler`, unless NULL, remembers the status, and every function on it returns
// that and stores zeros.
uint32_t spherecap_prepare(const struct spherecap_receiver_t *receiver,
                           const float *centre,
                           float radius,
                           struct spherecap_sampler_t *sampler);

// Samples a direction towards the sphere with two random numbers in [0, 1], both ends allowed. A number outside is taken for
// the nearer end, and NaN for 0.
//
// Stores the sample, or zeros (so a density of 0) on failure. Errors: NULL_POINTER, SAMPLER, INSTRUCTIONS, and what
// `spherecap_prepare` returned for the sampler.
uint32_t spherecap_sample(const struct spherecap_sampler_t *sampler,
                          float u0,
                          float u1,
                          struct spherecap_sample_t *sample);

// The sample of a sphere that is sampled once, for the caller who draws one at each point: what `spherecap_prepare` and
// `spherecap_sample` would give, to the bit, at a smaller cost, since nothing is kept for other samples.
//
// Stores the sample, or zeros (so a density of 0) on failure. Errors: those of `spherecap_prepare`.
uint32_t spherecap_sample_once(const struct spherecap_receiver_t *receiver,
                               const float *centre,
                               float radius,
                               float u0,
                               float u1,
                               struct spherecap_sample_t *sample);

// The density of a unit direction towards a sphere for which only this one is asked: what `spherecap_prepare` and
// `spherecap_pdf_on_sphere` would give, to the bit. For multiple importance sampling, where a ray has hit the sphere.
//
// Stores the density, or zeros on failure. Errors: those of `spherecap_prepare`, and DIRECTION.
uint32_t spherecap_pdf_once(const struct spherecap_receiver_t *receiver,
                            const float *centre,
                            float radius,
                            const float *direction,
                            struct spherecap_density_t *density);

// Density of the direction with this offset; zero outside the cap and where nothing is sampled. For an offset from
// `spherecap_sample`: the very bits that it stored.
//
// Errors: NULL_POINTER, DIRECTION, SAMPLER, INSTRUCTIONS, and what `spherecap_prepare` returned for the sampler; then zeros are
// stored.
uint32_t spherecap_pdf(const struct spherecap_sampler_t *sampler,
                       const struct spherecap_offset_t *offset,
                       struct spherecap_density_t *density);

// Density of a unit direction (three floats); zero outside the cap. The convenient form: a unit vector in single
// precision resolves 6e-8, so for a sphere with radius/distance = 1e-6 the cosine at the horizon is off by percents, and
// the direction itself by tenths of the cap. Where you have the offset, use `spherecap_pdf`.
//
// Errors: as `spherecap_pdf`.
uint32_t spherecap_pdf_direction(const struct spherecap_sampler_t *sampler,
                                 const float *direction,
                                 struct spherecap_density_t *density);

// As `spherecap_pdf_direction`, for a direction that is known to point at the sphere (a ray has hit it): only the horizon is
// tested, so that rounding near the limb does not lose the density.
//
// Errors: as `spherecap_pdf`.
uint32_t spherecap_pdf_on_sphere(const struct spherecap_sampler_t *sampler,
                                 const float *direction,
                                 struct spherecap_density_t *density);

// The two random numbers (stored at `u`) that give this offset, to rounding; in a defensive mixture those of the
// projected part. In [0, 1] for every offset.
//
// Errors: as `spherecap_pdf`.
uint32_t spherecap_invert(const struct spherecap_sampler_t *sampler,
                          const struct spherecap_offset_t *offset,
                          float *u);

// Solid angle of the whole cap, the part below the horizon included, in steradians, in (0, 2 pi] (to
// rounding).
//
// Errors: NULL_POINTER, SAMPLER, INSTRUCTIONS, and what `spherecap_prepare` returned for the sampler; then zero is stored.
uint32_t spherecap_solid_angle(const struct spherecap_sampler_t *sampler,
                               float *solid_angle);

// Projected solid angle of the cap above the horizon, in steradians, in [0, pi] (to rounding): the
// irradiance of an unoccluded sphere of radiance 1.
//
// Errors: as `spherecap_solid_angle`.
uint32_t spherecap_projected_solid_angle(const struct spherecap_sampler_t *sampler,
                                         float *projected_solid_angle);

// An upper bound, at least 1, for the largest density over the smallest with respect to projected solid angle above the
// horizon: the factor by which the weights of samples of a diffuse surface can differ. Infinity for `SOLID_ANGLE` where the
// horizon cuts the cap. Of the technique alone; mixtures are not counted.
//
// Errors: as `spherecap_solid_angle`.
uint32_t spherecap_density_bound(const struct spherecap_sampler_t *sampler,
                                 float *bound);

// The instructions that the functions on arrays use: the best that this CPU has, "AVX-512", "AVX2", or "portable" for one
// number at a time. Not to be freed. The results are the same.
//
// For debugging, the environment variable `SPHERECAP_INSTRUCTIONS` names others, read once: "portable", which also takes all
// fused instructions from the functions on single points (valgrind does not know each of them), "avx2" or "avx512". With
// another word, or one that this CPU lacks, this is "none", and the functions that compute return INSTRUCTIONS.
const char *spherecap_batch_instructions(void);

// Prepares the spheres and samples a direction towards each, with two random numbers.
//
// Stores for each point what `spherecap_sample` stores, to the bit, wherever in the arrays it is. A density of zero tells
// where it would have failed. Stores at `refused`, unless it is NULL, at how many points some input is bad, whatever is asked
// for; what is wrong there, `spherecap_prepare` says. A sphere that is INVISIBLE and a point INSIDE are no bad input. Arrays
// that are stored to must not overlap each other or those that are read. For several threads, give each a part of the arrays.
//
// Errors: NULL_POINTER (of the arrays that are read, too), TECHNIQUE, HEMISPHERES, DEFENSIVE, INSTRUCTIONS; then nothing is
// stored.
uint32_t spherecap_batch_sample(const struct spherecap_batch_t *batch,
                                const struct spherecap_batch_random_t *random,
                                const struct spherecap_batch_samples_t *samples,
                                size_t *refused);

// Samples `count` directions towards the sphere of one sampler, with two random numbers for each: for resampling, or many shadow rays
// at one point.
//
// Stores what `spherecap_sample` stores for each pair of random numbers, to the bit. The arrays of `random` and `samples` have one
// number for each sample; those that are stored to must not overlap each other or those that are read.
//
// Errors: NULL_POINTER (of the arrays that are read, too), SAMPLER, INSTRUCTIONS, and the status with which the preparation of the
// sampler ended; then nothing is stored.
uint32_t spherecap_sample_many(const struct spherecap_sampler_t *sampler,
                               size_t count,
                               const struct spherecap_batch_random_t *random,
                               const struct spherecap_batch_samples_t *samples);

// `spherecap_pdf` for each point. The density is also zero where the sphere or the offset would be refused.
//
// `refused` and errors: as of `spherecap_batch_sample`.
uint32_t spherecap_batch_pdf(const struct spherecap_batch_t *batch,
                             const struct spherecap_batch_offsets_t *offsets,
                             const struct spherecap_batch_densities_t *densities,
                             size_t *refused);

// `spherecap_pdf_direction` for each point. The density is also zero where the sphere or the direction would be refused.
//
// `refused` and errors: as of `spherecap_batch_sample`.
uint32_t spherecap_batch_pdf_direction(const struct spherecap_batch_t *batch,
                                       const struct spherecap_batch_directions_t *directions,
                                       const struct spherecap_batch_densities_t *densities,
                                       size_t *refused);

// `spherecap_pdf_on_sphere` for each point; otherwise as `spherecap_batch_pdf_direction`.
//
// `refused` and errors: as of `spherecap_batch_sample`.
uint32_t spherecap_batch_pdf_on_sphere(const struct spherecap_batch_t *batch,
                                       const struct spherecap_batch_directions_t *directions,
                                       const struct spherecap_batch_densities_t *densities,
                                       size_t *refused);

// `spherecap_solid_angle` and `spherecap_projected_solid_angle` for each point, to the bit; both are zero where
// `spherecap_prepare` would fail, as for a sphere that is INVISIBLE. So the solid angle of one below the horizon depends on
// technique, hemispheres and defensive fraction; projected solid angles depend on none of them.
//
// `refused` and errors: as of `spherecap_batch_sample`.
uint32_t spherecap_batch_measures(const struct spherecap_batch_t *batch,
                                  const struct spherecap_batch_measures_t *measures,
                                  size_t *refused);

// The importance of a light at each point, to choose among several by: what `spherecap_importances` stores for the light alone, to
// the bit. `strength` has the light's radiance, in any unit, one number for each point. Zero also where `spherecap_prepare` finds
// bad input.
//
// `refused` and errors: as of `spherecap_batch_sample`. A strength that is negative or not finite is bad input, too.
uint32_t spherecap_batch_importances(const struct spherecap_batch_t *batch,
                                     const float *strength,
                                     float *importances,
                                     size_t *refused);

// How much each light can give to a point (three floats), so that one can be chosen by it: about its unoccluded irradiance over pi,
// `strength * E / pi` with the projected solid angle E, and equal to that (to 2^-21 of the distance) where all of it is above
// the horizon.
//
// It is what the receiver samples that counts. Both hemispheres: the irradiances of both sides. A defensive fraction: that of
// a light in any direction, `strength * s^2 / 2` with the sine s of its angular radius, takes that fraction of the whole; so it does
// for `SOLID_ANGLE`, whose fraction is 1. On no surface: `strength * s^2`.
//
// Stores at `importances` one number for each light, never less than a millionth below these: so a positive one wherever
// `spherecap_prepare` succeeds for the light's centre minus the point (in single precision) and its strength is positive. Zero for
// a light that the point is inside of, and for one with a bad radius, centre or strength. Stores at `total` what the functions
// below need. Keep both with the point: the probability of any light there then costs next to nothing.
//
// Errors: NULL_POINTER (of the arrays, too), TECHNIQUE, HEMISPHERES, DEFENSIVE, NORMAL, INSTRUCTIONS; then `*total`, unless NULL, is
// zero, and nothing else is stored.
uint32_t spherecap_importances(const struct spherecap_receiver_t *receiver,
                               const float *point,
                               const struct spherecap_lights_t *lights,
                               float *importances,
                               struct spherecap_total_t *total);

// The total of `count` importances, below 2^32: for a caller who has added those of other lights to what `spherecap_importances`
// stored, in the same unit, or who has his own.
//
// An importance that is negative or NaN counts as 0, and one above 2^95 as that, here and in the functions below: so no sum is
// infinite, and no probability wrong.
//
// Errors: NULL_POINTER (of `importances` only if there are any), INSTRUCTIONS; then zeros are stored.
uint32_t spherecap_total(const float *importances,
                         size_t count,
                         struct spherecap_total_t *total);

// Chooses one of `count` lights in proportion to their importances, of which `total` is the total, by one random number `u` in
// [0, 1]. (A number outside is taken for the nearer end, and NaN for 0.) Each light has one interval of it, so strata
// survive. `even`, in [0, 1], is the fraction of the probability that is spread evenly over all importances that are not 0, for
// where the bright lights are hidden: 0.05 costs little.
//
// Stores the choice; if nothing is lit, or there is nothing to choose from, zeros: a probability of 0, and the status is OK.
//
// Errors: NULL_POINTER (of `importances` only if there are any), EVEN, INSTRUCTIONS; then zeros are stored.
uint32_t spherecap_choose(const float *importances,
                          size_t count,
                          const struct spherecap_total_t *total,
                          float even,
                          float u,
                          struct spherecap_choice_t *choice);

// The probability with which `spherecap_choose` gives a light of this importance, to the bit: for the density of a direction that
// something else has sampled, as multiple importance sampling asks for it.
//
// Errors: NULL_POINTER, EVEN, INSTRUCTIONS; then zero is stored.
uint32_t spherecap_choice_probability(float importance,
                                      const struct spherecap_total_t *total,
                                      float even,
                                      float *probability);

// `spherecap_prepare` in double precision. What it and the functions below return is what those without `_f64` do.
uint32_t spherecap_prepare_f64(const struct spherecap_receiver_f64_t *receiver,
                               const double *centre,
                               double radius,
                               struct spherecap_sampler_f64_t *sampler);

// `spherecap_sample` in double precision.
uint32_t spherecap_sample_f64(const struct spherecap_sampler_f64_t *sampler,
                              double u0,
                              double u1,
                              struct spherecap_sample_f64_t *sample);

// `spherecap_sample_once` in double precision.
uint32_t spherecap_sample_once_f64(const struct spherecap_receiver_f64_t *receiver,
                                   const double *centre,
                                   double radius,
                                   double u0,
                                   double u1,
                                   struct spherecap_sample_f64_t *sample);

// `spherecap_pdf_once` in double precision.
uint32_t spherecap_pdf_once_f64(const struct spherecap_receiver_f64_t *receiver,
                                const double *centre,
                                double radius,
                                const double *direction,
                                struct spherecap_density_f64_t *density);

// `spherecap_pdf` in double precision.
uint32_t spherecap_pdf_f64(const struct spherecap_sampler_f64_t *sampler,
                           const struct spherecap_offset_f64_t *offset,
                           struct spherecap_density_f64_t *density);

// `spherecap_pdf_direction` in double precision (three doubles): a unit vector resolves 1e-16.
uint32_t spherecap_pdf_direction_f64(const struct spherecap_sampler_f64_t *sampler,
                                     const double *direction,
                                     struct spherecap_density_f64_t *density);

// `spherecap_pdf_on_sphere` in double precision.
uint32_t spherecap_pdf_on_sphere_f64(const struct spherecap_sampler_f64_t *sampler,
                                     const double *direction,
                                     struct spherecap_density_f64_t *density);

// `spherecap_invert` in double precision.
uint32_t spherecap_invert_f64(const struct spherecap_sampler_f64_t *sampler,
                              const struct spherecap_offset_f64_t *offset,
                              double *u);

// `spherecap_solid_angle` in double precision.
uint32_t spherecap_solid_angle_f64(const struct spherecap_sampler_f64_t *sampler, double *solid_angle);

// `spherecap_projected_solid_angle` in double precision.
uint32_t spherecap_projected_solid_angle_f64(const struct spherecap_sampler_f64_t *sampler,
                                             double *projected_solid_angle);

// `spherecap_density_bound` in double precision.
uint32_t spherecap_density_bound_f64(const struct spherecap_sampler_f64_t *sampler, double *bound);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SPHERECAP_H */
