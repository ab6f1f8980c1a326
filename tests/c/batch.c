// Batches from C: the bits of single calls, for every length, in arrays that end where memory ends and begin
// at any float; and every kind of bad input. Prints the instructions that they use.

#include "spherecap.h" // first, so that it must be self-contained

#include "check.h"

#include <math.h>

enum { MOST = 40 };

static const float zenith[3] = {0.0f, 0.0f, 1.0f}, zenith_of_two[3] = {0.0f, 0.0f, 2.0f};

// Arrays of `count` numbers, each just before an inaccessible page.
typedef struct arrays_t {
    size_t count;
    float *inputs[15];  // normal, centre, radius, u0, u1, offset, direction
    float *outputs[20]; // of a sample: offset, direction, distance, normal, density; three more densities;
                        // measures
} arrays_t;

static arrays_t arrays; // of the largest size: smaller ones are their ends

static uint32_t state = 1;

static float unit_number(void) {
    state = state * 1664525u + 1013904223u;
    return (float)(state >> 8) / 16777216.0f;
}

static void allocate(void) {
    arrays.count = MOST;
    for (int i = 0; i < 15; ++i) {
        arrays.inputs[i] = (float *)guarded_memory(MOST * sizeof(float));
    }
    for (int i = 0; i < 20; ++i) {
        arrays.outputs[i] = (float *)guarded_memory(MOST * sizeof(float));
    }
}

static void put(int first, size_t i, const float *numbers, int count) {
    for (int k = 0; k < count; ++k) {
        arrays.inputs[first + k][i] = numbers[k];
    }
}

// Lights of all sizes, some below the horizon; of every eleven inputs some are bad, each in its own way.
static void fill(void) {
    for (size_t i = 0; i < MOST; ++i) {
        const float slope = 0.3f * unit_number();
        const float length = i % 5 == 0 ? 3.0f : 1.0f;
        const float normal[3] = {length * slope, i % 11 == 1 ? INFINITY : 0.0f,
                                 length * sqrtf(1.0f - slope * slope)};
        const float centre[3] = {2.0f + unit_number(), unit_number(), 2.0f * unit_number() - 1.0f};
        const float radius = i % 11 == 3 ? NAN : 0.01f + 1.9f * unit_number();
        const float u[2] = {unit_number(), i % 11 == 5 ? 2.0f : unit_number()};
        put(0, i, normal, 3);
        put(3, i, centre, 3);
        put(6, i, &radius, 1);
        put(7, i, u, 2);
        spherecap_sampler_t sampler;
        spherecap_sample_t sample;
        (void)prepare_for(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f, normal, centre,
                          radius, &sampler);
        (void)spherecap_sample(&sampler, u[0], u[0], &sample);
        sample.offset.side += i % 11 == 7 ? 2.0f : 0.0f;
        sample.direction[0] += i % 11 == 9 ? 0.1f : 0.0f;
        put(9, i, &sample.offset.zenith, 3);
        put(12, i, sample.direction, 3);
    }
}

// The last `count` elements.
static arrays_t last(size_t count) {
    arrays_t part = arrays;
    part.count = count;
    for (int i = 0; i < 15; ++i) {
        part.inputs[i] += MOST - count;
    }
    for (int i = 0; i < 20; ++i) {
        part.outputs[i] += MOST - count;
    }
    return part;
}

static spherecap_batch_t batch_of(const arrays_t *a, uint32_t technique, uint32_t hemispheres,
                                  float defensive) {
    const spherecap_batch_t batch = {technique,
                                     hemispheres,
                                     defensive,
                                     a->count,
                                     {a->inputs[0], a->inputs[1], a->inputs[2]},
                                     {a->inputs[3], a->inputs[4], a->inputs[5]},
                                     a->inputs[6]};
    return batch;
}

static spherecap_batch_samples_t samples_of(const arrays_t *a) {
    float *const *o = a->outputs;
    const spherecap_batch_samples_t samples = {
        {o[0], o[1], o[2]}, {o[3], o[4], o[5]}, o[6], {o[7], o[8], o[9]}, {o[10], o[11]}};
    return samples;
}

// At how many points each function found bad input; with a number that none finds before it is called.
typedef struct refused_t {
    size_t sample, pdf, pdf_direction, pdf_on_sphere, measures;
} refused_t;
static const refused_t nobody_knows = {SIZE_MAX, SIZE_MAX, SIZE_MAX, SIZE_MAX, SIZE_MAX};

// All functions, with the outputs where `arrays_t` says.
static refused_t run(const arrays_t *a, const spherecap_batch_t *batch, uint32_t expected) {
    refused_t refused = nobody_knows;
    const spherecap_batch_random_t random = {a->inputs[7], a->inputs[8]};
    const spherecap_batch_offsets_t offsets = {a->inputs[9], a->inputs[10], a->inputs[11]};
    const spherecap_batch_directions_t directions = {a->inputs[12], a->inputs[13], a->inputs[14]};
    const spherecap_batch_measures_t measures = {a->outputs[18], a->outputs[19]};
    const spherecap_batch_samples_t samples = samples_of(a);
    const spherecap_batch_densities_t densities[3] = {
        {a->outputs[12], a->outputs[13]}, {a->outputs[14], a->outputs[15]}, {a->outputs[16], a->outputs[17]}};
    CHECK(spherecap_batch_sample(batch, &random, &samples, &refused.sample) == expected);
    CHECK(spherecap_batch_pdf(batch, &offsets, &densities[0], &refused.pdf) == expected);
    CHECK(spherecap_batch_pdf_direction(batch, &directions, &densities[1], &refused.pdf_direction) ==
          expected);
    CHECK(spherecap_batch_pdf_on_sphere(batch, &directions, &densities[2], &refused.pdf_on_sphere) ==
          expected);
    CHECK(spherecap_batch_measures(batch, &measures, &refused.measures) == expected);
    return refused;
}

static void fill_outputs_with_rubbish(void) {
    for (int i = 0; i < 20; ++i) {
        fill_with_rubbish(arrays.outputs[i], MOST * sizeof(float));
    }
}

static int is_rubbish(float number) {
    float rubbish;
    fill_with_rubbish(&rubbish, sizeof rubbish);
    return memcmp(&number, &rubbish, sizeof rubbish) == 0;
}

// 1 where a status is about bad input.
static size_t is_bad(uint32_t status) { return status > SPHERECAP_STATUS_INSIDE; }

static void expect_single_calls(const arrays_t *a, const spherecap_batch_t *batch, const refused_t *found) {
    refused_t refused = {0, 0, 0, 0, 0};
    for (size_t i = 0; i < a->count; ++i) {
        float in[15], out[20];
        for (int k = 0; k < 15; ++k) {
            in[k] = a->inputs[k][i];
        }
        spherecap_sampler_t sampler;
        const size_t bad = is_bad(
            prepare_for(batch->technique, batch->hemispheres, batch->defensive, in, in + 3, in[6], &sampler));
        const spherecap_offset_t offset = {in[9], in[10], in[11]};
        spherecap_sample_t sample;
        spherecap_density_t densities[3];
        (void)spherecap_sample(&sampler, in[7], in[8], &sample);
        (void)spherecap_pdf(&sampler, &offset, &densities[0]);
        (void)spherecap_pdf_direction(&sampler, in + 12, &densities[1]);
        (void)spherecap_pdf_on_sphere(&sampler, in + 12, &densities[2]);
        (void)spherecap_solid_angle(&sampler, &out[18]);
        (void)spherecap_projected_solid_angle(&sampler, &out[19]);
        // A sampler of another sphere has nothing to object to but the offset and the direction.
        spherecap_sampler_t other;
        CHECK(prepare_for(0, 0, 0.0f, zenith, zenith_of_two, 1.0f, &other) == SPHERECAP_STATUS_OK);
        spherecap_density_t density;
        const size_t bad_offset = is_bad(spherecap_pdf(&other, &offset, &density));
        const size_t bad_direction = is_bad(spherecap_pdf_direction(&other, in + 12, &density));
        refused.sample += bad;
        refused.pdf += bad | bad_offset;
        refused.pdf_direction += bad | bad_direction;
        refused.pdf_on_sphere += bad | bad_direction;
        refused.measures += bad;
        memcpy(out, &sample, sizeof sample); // its fields are the first twelve arrays
        memcpy(out + 12, densities, sizeof densities);
        for (int k = 0; k < 20; ++k) {
            CHECK(memcmp(&out[k], &a->outputs[k][i], sizeof(float)) == 0);
        }
    }
    CHECK(memcmp(found, &refused, sizeof refused) == 0);
}

static void every_length(void) {
    int sampled = 0;
    for (size_t count = 0; count <= MOST; ++count) {
        const arrays_t part = last(count);
        const float defensive = count % 2 == 0 ? 0.0f : 0.25f;
        const spherecap_batch_t batch = batch_of(&part, count % 3, count / 3 % 2, defensive);
        fill_outputs_with_rubbish();
        const refused_t refused = run(&part, &batch, SPHERECAP_STATUS_OK);
        expect_single_calls(&part, &batch, &refused);
        for (int k = 0; k < 20; ++k) {
            for (size_t i = 0; i < MOST - count; ++i) {
                CHECK(is_rubbish(arrays.outputs[k][i]));
            }
        }
        for (size_t i = 0; i < count; ++i) {
            sampled += part.outputs[10][i] > 0.0f;
        }
    }
    CHECK(sampled > 400 && sampled < 800); // of 820
}

static void nothing(void) {
    // Nobody's arrays of nothing: they may be NULL.
    const spherecap_batch_random_t random = {NULL, NULL};
    const spherecap_batch_offsets_t offsets = {NULL, NULL, NULL};
    const spherecap_batch_directions_t directions = {NULL, NULL, NULL};
    const spherecap_batch_t batch = {SPHERECAP_TECHNIQUE_PROJECTED,
                                     SPHERECAP_HEMISPHERES_FRONT,
                                     0.0f,
                                     0,
                                     {NULL, NULL, NULL},
                                     {NULL, NULL, NULL},
                                     NULL};
    const spherecap_batch_densities_t densities = {NULL, NULL};
    const spherecap_batch_measures_t measures = {NULL, NULL};
    const spherecap_batch_samples_t samples = {
        {NULL, NULL, NULL}, {NULL, NULL, NULL}, NULL, {NULL, NULL, NULL}, {NULL, NULL}};
    size_t refused = 1;
    CHECK(spherecap_batch_sample(&batch, &random, &samples, &refused) == SPHERECAP_STATUS_OK && refused == 0);
    CHECK(spherecap_batch_pdf(&batch, &offsets, &densities, NULL) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_batch_pdf_direction(&batch, &directions, &densities, NULL) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_batch_pdf_on_sphere(&batch, &directions, &densities, NULL) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_batch_measures(&batch, &measures, NULL) == SPHERECAP_STATUS_OK);
}

static void only_what_is_wanted(void) {
    const arrays_t all = last(MOST);
    const spherecap_batch_t batch =
        batch_of(&all, SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f);
    fill_outputs_with_rubbish();
    const refused_t refused = run(&all, &batch, SPHERECAP_STATUS_OK);
    CHECK(refused.sample > 0 && refused.pdf > refused.sample && refused.measures == refused.sample);
    float expected[MOST];
    memcpy(expected, all.outputs[10], sizeof expected);
    for (int wanted = 0; wanted < 20; ++wanted) {
        arrays_t some = all;
        for (int i = 0; i < 20; ++i) {
            some.outputs[i] = i == wanted ? all.outputs[i] : NULL;
        }
        fill_outputs_with_rubbish();
        const refused_t found = run(&some, &batch, SPHERECAP_STATUS_OK);
        CHECK(memcmp(&found, &refused, sizeof found) == 0);
        for (int i = 0; i < 20; ++i) {
            CHECK(is_rubbish(all.outputs[i][0]) == (i != wanted));
        }
        CHECK(wanted != 10 || memcmp(expected, all.outputs[10], sizeof expected) == 0);
    }
}

// Nothing is stored.
static void expect_refused(const arrays_t *a, const spherecap_batch_t *batch, uint32_t expected) {
    fill_outputs_with_rubbish();
    const refused_t refused = run(a, batch, expected);
    CHECK(memcmp(&refused, &nobody_knows, sizeof refused) == 0);
    for (int i = 0; i < 20; ++i) {
        for (size_t k = 0; k < MOST; ++k) {
            CHECK(is_rubbish(arrays.outputs[i][k]));
        }
    }
}

static void bad_input(void) {
    const arrays_t all = last(MOST);
    const uint32_t projected = SPHERECAP_TECHNIQUE_PROJECTED, null = SPHERECAP_STATUS_NULL_POINTER;
    spherecap_batch_t batch = batch_of(&all, 3, 0, 0.0f);
    expect_refused(&all, &batch, SPHERECAP_STATUS_TECHNIQUE);
    batch = batch_of(&all, projected, UINT32_MAX, 0.0f);
    expect_refused(&all, &batch, SPHERECAP_STATUS_HEMISPHERES);
    const float no_fraction[] = {NAN, -0.1f, 1.1f, INFINITY};
    for (int i = 0; i < 4; ++i) {
        batch = batch_of(&all, projected, 0, no_fraction[i]);
        expect_refused(&all, &batch, SPHERECAP_STATUS_DEFENSIVE);
    }
    expect_refused(&all, NULL, null);
    // Arrays that are NULL, one at a time: those of the batch, and those of each function.
    for (int i = 0; i < 7; ++i) {
        arrays_t some = all;
        some.inputs[i] = NULL;
        batch = batch_of(&some, projected, 0, 0.0f);
        expect_refused(&some, &batch, null);
    }
    batch = batch_of(&all, projected, 0, 0.0f);
    const spherecap_batch_samples_t samples = samples_of(&all);
    const spherecap_batch_densities_t densities = samples.density;
    fill_outputs_with_rubbish();
    const spherecap_batch_measures_t measures = {all.outputs[18], all.outputs[19]};
    const float *const vector[3] = {all.inputs[9], all.inputs[10], all.inputs[11]};
    for (int i = 0; i < 3; ++i) {
        const float *some[3] = {vector[0], vector[1], vector[2]};
        some[i] = NULL;
        const spherecap_batch_random_t random = {i == 0 ? NULL : vector[0], i == 1 ? NULL : vector[1]};
        const spherecap_batch_offsets_t offsets = {some[0], some[1], some[2]};
        const spherecap_batch_directions_t directions = {some[0], some[1], some[2]};
        CHECK(i == 2 || spherecap_batch_sample(&batch, &random, &samples, NULL) == null);
        CHECK(spherecap_batch_pdf(&batch, &offsets, &densities, NULL) == null);
        CHECK(spherecap_batch_pdf_direction(&batch, &directions, &densities, NULL) == null);
        CHECK(spherecap_batch_pdf_on_sphere(&batch, &directions, &densities, NULL) == null);
    }
    const spherecap_batch_random_t random = {vector[0], vector[1]};
    const spherecap_batch_offsets_t offsets = {vector[0], vector[1], vector[2]};
    const spherecap_batch_directions_t directions = {vector[0], vector[1], vector[2]};
    CHECK(spherecap_batch_sample(&batch, NULL, &samples, NULL) == null);
    CHECK(spherecap_batch_sample(&batch, &random, NULL, NULL) == null);
    CHECK(spherecap_batch_pdf(&batch, NULL, &densities, NULL) == null);
    CHECK(spherecap_batch_pdf(&batch, &offsets, NULL, NULL) == null);
    CHECK(spherecap_batch_pdf_direction(&batch, NULL, &densities, NULL) == null);
    CHECK(spherecap_batch_pdf_direction(&batch, &directions, NULL, NULL) == null);
    CHECK(spherecap_batch_pdf_on_sphere(&batch, NULL, &densities, NULL) == null);
    CHECK(spherecap_batch_pdf_on_sphere(&batch, &directions, NULL, NULL) == null);
    CHECK(spherecap_batch_measures(&batch, NULL, NULL) == null);
    CHECK(spherecap_batch_measures(NULL, &measures, NULL) == null);
    CHECK(is_rubbish(all.outputs[10][0]) && is_rubbish(all.outputs[11][0]));
}

// Many samples of one sampler: the bits of one at a time, for every length; and its bad input.
static void many_of_one(void) {
    const uint32_t null = SPHERECAP_STATUS_NULL_POINTER;
    const float centre[3] = {2.0f, 0.5f, 0.3f};
    for (size_t count = 0; count <= MOST; ++count) {
        const arrays_t part = last(count);
        const spherecap_batch_random_t random = {part.inputs[7], part.inputs[8]};
        const spherecap_batch_samples_t samples = samples_of(&part);
        spherecap_sampler_t sampler;
        CHECK(prepare_for(count % 3, count / 3 % 2, count % 2 == 0 ? 0.0f : 0.25f, zenith, centre, 1.0f,
                          &sampler) == SPHERECAP_STATUS_OK);
        fill_outputs_with_rubbish();
        CHECK(spherecap_sample_many(&sampler, count, &random, &samples) == SPHERECAP_STATUS_OK);
        for (size_t i = 0; i < count; ++i) {
            spherecap_sample_t sample;
            (void)spherecap_sample(&sampler, random.u0[i], random.u1[i], &sample);
            for (int k = 0; k < 12; ++k) {
                CHECK(memcmp((const float *)&sample + k, &part.outputs[k][i], sizeof(float)) == 0);
            }
        }
        for (int k = 0; k < 20; ++k) {
            for (size_t i = 0; i < (k < 12 ? MOST - count : MOST); ++i) {
                CHECK(is_rubbish(arrays.outputs[k][i]));
            }
        }
    }
    fill_outputs_with_rubbish();
    const arrays_t all = last(MOST);
    const spherecap_batch_random_t random = {all.inputs[7], all.inputs[8]};
    const spherecap_batch_random_t no_u0 = {NULL, all.inputs[8]}, no_u1 = {all.inputs[7], NULL};
    const spherecap_batch_samples_t samples = samples_of(&all);
    spherecap_sampler_t sampler, unprepared;
    memset(&unprepared, 0, sizeof unprepared);
    CHECK(prepare_for(0, 0, 0.0f, zenith, centre, 1.0f, &sampler) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_sample_many(NULL, MOST, &random, &samples) == null);
    CHECK(spherecap_sample_many(&sampler, MOST, NULL, &samples) == null);
    CHECK(spherecap_sample_many(&sampler, MOST, &random, NULL) == null);
    CHECK(spherecap_sample_many(&sampler, MOST, &no_u0, &samples) == null);
    CHECK(spherecap_sample_many(&sampler, MOST, &no_u1, &samples) == null);
    CHECK(spherecap_sample_many(&unprepared, MOST, &random, &samples) == SPHERECAP_STATUS_SAMPLER);
    // It has nothing to sample.
    const float below[3] = {0.0f, 0.0f, -2.0f};
    CHECK(prepare_for(0, 0, 0.0f, zenith, below, 1.0f, &sampler) == SPHERECAP_STATUS_INVISIBLE);
    CHECK(spherecap_sample_many(&sampler, MOST, &random, &samples) == SPHERECAP_STATUS_INVISIBLE);
    CHECK(is_rubbish(all.outputs[3][0]) && is_rubbish(all.outputs[10][MOST - 1]));
}

int main(int count, char **arguments) {
    choose_mode(count, arguments);
    allocate();
    fill();
    every_length();
    nothing();
    only_what_is_wanted();
    bad_input();
    many_of_one();
    puts(spherecap_batch_instructions());
    return 0;
}
