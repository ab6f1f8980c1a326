// Batches from C: the bits of single calls, for every length, in arrays that end where memory ends and begin
// at any float; and every kind of bad input. Prints the instructions that they use.

#include "spherecap.h" // first, so that it must be self-contained

#include "check.h"

#include <math.h>

enum { MOST = 40 };

// Arrays of `count` numbers, each just before an inaccessible page.
typedef struct arrays_t {
    size_t count;
    float *inputs[15];  // normal, centre, radius, u0, u1, offset, direction
    float *outputs[18]; // of a sample: offset, direction, distance, normal, density; three more densities
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
    for (int i = 0; i < 18; ++i) {
        arrays.outputs[i] = (float *)guarded_memory(MOST * sizeof(float));
    }
}

static void put(int first, size_t i, const float *numbers, int count) {
    for (int k = 0; k < count; ++k) {
        arrays.inputs[first + k][i] = numbers[k];
    }
}

// Lights of all sizes, some below the horizon; every seventh input is bad.
static void fill(void) {
    for (size_t i = 0; i < MOST; ++i) {
        const float slope = 0.3f * unit_number();
        const float normal[3] = {slope, 0.0f, sqrtf(1.0f - slope * slope)};
        const float centre[3] = {2.0f + unit_number(), unit_number(), 2.0f * unit_number() - 1.0f};
        const float radius = i % 7 == 3 ? NAN : 0.01f + 1.9f * unit_number();
        const float u[2] = {unit_number(), i % 7 == 5 ? 2.0f : unit_number()};
        put(0, i, normal, 3);
        put(3, i, centre, 3);
        put(6, i, &radius, 1);
        put(7, i, u, 2);
        spherecap_cap_t cap;
        spherecap_sample_t sample;
        (void)spherecap_prepare(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f, normal,
                                centre, radius, &cap);
        (void)spherecap_sample(&cap, u[0], u[0], &sample);
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
    for (int i = 0; i < 18; ++i) {
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

// All functions, with the outputs where `arrays_t` says.
static void run(const arrays_t *a, const spherecap_batch_t *batch, uint32_t expected) {
    const float *const offset[3] = {a->inputs[9], a->inputs[10], a->inputs[11]};
    const float *const direction[3] = {a->inputs[12], a->inputs[13], a->inputs[14]};
    const spherecap_batch_samples_t samples = samples_of(a);
    const spherecap_batch_densities_t densities[3] = {
        {a->outputs[12], a->outputs[13]}, {a->outputs[14], a->outputs[15]}, {a->outputs[16], a->outputs[17]}};
    CHECK(spherecap_batch_sample(batch, a->inputs[7], a->inputs[8], &samples) == expected);
    CHECK(spherecap_batch_pdf(batch, offset, &densities[0]) == expected);
    CHECK(spherecap_batch_pdf_direction(batch, direction, &densities[1]) == expected);
    CHECK(spherecap_batch_pdf_on_sphere(batch, direction, &densities[2]) == expected);
}

static void fill_outputs_with_rubbish(void) {
    for (int i = 0; i < 18; ++i) {
        fill_with_rubbish(arrays.outputs[i], MOST * sizeof(float));
    }
}

static int is_rubbish(float number) {
    float rubbish;
    fill_with_rubbish(&rubbish, sizeof rubbish);
    return memcmp(&number, &rubbish, sizeof rubbish) == 0;
}

static void expect_single_calls(const arrays_t *a, const spherecap_batch_t *batch) {
    for (size_t i = 0; i < a->count; ++i) {
        float in[15], out[18];
        for (int k = 0; k < 15; ++k) {
            in[k] = a->inputs[k][i];
        }
        spherecap_cap_t cap;
        (void)spherecap_prepare(batch->technique, batch->hemispheres, batch->defensive, in, in + 3, in[6],
                                &cap);
        const spherecap_offset_t offset = {in[9], in[10], in[11]};
        spherecap_sample_t sample;
        spherecap_density_t densities[3];
        (void)spherecap_sample(&cap, in[7], in[8], &sample);
        (void)spherecap_pdf(&cap, &offset, &densities[0]);
        (void)spherecap_pdf_direction(&cap, in + 12, &densities[1]);
        (void)spherecap_pdf_on_sphere(&cap, in + 12, &densities[2]);
        memcpy(out, &sample, sizeof sample); // its fields are the first twelve arrays
        memcpy(out + 12, densities, sizeof densities);
        for (int k = 0; k < 18; ++k) {
            CHECK(memcmp(&out[k], &a->outputs[k][i], sizeof(float)) == 0);
        }
    }
}

static void every_length(void) {
    int sampled = 0;
    for (size_t count = 0; count <= MOST; ++count) {
        const arrays_t part = last(count);
        const float defensive = count % 2 == 0 ? 0.0f : 0.25f;
        const spherecap_batch_t batch = batch_of(&part, count % 3, count / 3 % 2, defensive);
        fill_outputs_with_rubbish();
        run(&part, &batch, SPHERECAP_STATUS_OK);
        expect_single_calls(&part, &batch);
        for (int k = 0; k < 18; ++k) {
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
    const float *const none[3] = {NULL, NULL, NULL};
    const spherecap_batch_t batch = {SPHERECAP_TECHNIQUE_PROJECTED,
                                     SPHERECAP_HEMISPHERES_FRONT,
                                     0.0f,
                                     0,
                                     {NULL, NULL, NULL},
                                     {NULL, NULL, NULL},
                                     NULL};
    const spherecap_batch_densities_t densities = {NULL, NULL};
    const spherecap_batch_samples_t samples = {
        {NULL, NULL, NULL}, {NULL, NULL, NULL}, NULL, {NULL, NULL, NULL}, {NULL, NULL}};
    CHECK(spherecap_batch_sample(&batch, NULL, NULL, &samples) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_batch_pdf(&batch, none, &densities) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_batch_pdf_direction(&batch, none, &densities) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_batch_pdf_on_sphere(&batch, none, &densities) == SPHERECAP_STATUS_OK);
}

static void only_what_is_wanted(void) {
    const arrays_t all = last(MOST);
    const spherecap_batch_t batch =
        batch_of(&all, SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f);
    fill_outputs_with_rubbish();
    run(&all, &batch, SPHERECAP_STATUS_OK);
    float expected[MOST];
    memcpy(expected, all.outputs[10], sizeof expected);
    for (int wanted = 0; wanted < 12; ++wanted) {
        arrays_t some = all;
        for (int i = 0; i < 18; ++i) {
            some.outputs[i] = i == wanted ? all.outputs[i] : NULL;
        }
        fill_outputs_with_rubbish();
        run(&some, &batch, SPHERECAP_STATUS_OK);
        for (int i = 0; i < 18; ++i) {
            CHECK(is_rubbish(all.outputs[i][0]) == (i != wanted));
        }
        CHECK(wanted != 10 || memcmp(expected, all.outputs[10], sizeof expected) == 0);
    }
}

// Nothing is stored.
static void expect_refused(const arrays_t *a, const spherecap_batch_t *batch, uint32_t expected) {
    fill_outputs_with_rubbish();
    run(a, batch, expected);
    for (int i = 0; i < 18; ++i) {
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
    CHECK(spherecap_batch_sample(&batch, NULL, all.inputs[8], &samples) == null);
    CHECK(spherecap_batch_sample(&batch, all.inputs[7], NULL, &samples) == null);
    CHECK(spherecap_batch_sample(&batch, all.inputs[7], all.inputs[8], NULL) == null);
    const float *const vector[3] = {all.inputs[9], all.inputs[10], all.inputs[11]};
    for (int i = 0; i < 4; ++i) {
        const float *some[3] = {vector[0], vector[1], vector[2]};
        if (i < 3) {
            some[i] = NULL;
        }
        const float *const *incomplete = i < 3 ? some : NULL;
        CHECK(spherecap_batch_pdf(&batch, incomplete, &densities) == null);
        CHECK(spherecap_batch_pdf_direction(&batch, incomplete, &densities) == null);
        CHECK(spherecap_batch_pdf_on_sphere(&batch, incomplete, &densities) == null);
    }
    CHECK(spherecap_batch_pdf(&batch, vector, NULL) == null);
    CHECK(spherecap_batch_pdf_direction(&batch, vector, NULL) == null);
    CHECK(spherecap_batch_pdf_on_sphere(&batch, vector, NULL) == null);
    CHECK(is_rubbish(all.outputs[10][0]) && is_rubbish(all.outputs[11][0]));
}

int main(void) {
    allocate();
    fill();
    every_length();
    nothing();
    only_what_is_wanted();
    bad_input();
    puts(spherecap_batch_instructions());
    return 0;
}
