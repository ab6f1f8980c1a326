// Calls every function on single points with good input and with every kind of bad input. Prints the statuses
// that it has met, one a line with its message, for `tests/c_abi.rs` to compare with the header's list.

#include "spherecap.h" // first, so that it must be self-contained
#include "spherecap_record.h"

#include "check.h"

#include <float.h>
#include <math.h>

#define SMALLEST 1.40129846e-45f // the smallest subnormal; FLT_TRUE_MIN came with C11

static const float zenith[3] = {0.0f, 0.0f, 1.0f};
static const float ahead[3] = {3.0f, 0.0f, 0.5f};

static int met[64];

static uint32_t meet(uint32_t status) {
    CHECK(status < sizeof met / sizeof *met);
    met[status] = 1;
    return status;
}

// The call gives this status and zeros in `out`. The call's other arguments mention `out` themselves.
#define EXPECT_NOTHING(expected, out, call)                                                                  \
    do {                                                                                                     \
        fill_with_rubbish(&(out), sizeof(out));                                                              \
        CHECK(meet(call) == (expected));                                                                     \
        CHECK(is_all_zero(&(out), sizeof(out)));                                                             \
    } while (0)

// Every function that takes a sampler gives this status for it and stores zeros.
static void expect_no_sampler(const spherecap_sampler_t *sampler, uint32_t expected) {
    const spherecap_offset_t offset = {0.0f, 0.0f, 0.5f};
    const float direction[3] = {1.0f, 0.0f, 0.0f};
    spherecap_sample_t sample;
    spherecap_density_t density;
    float u[2], number;
    EXPECT_NOTHING(expected, sample, spherecap_sample(sampler, 0.5f, 0.5f, &sample));
    EXPECT_NOTHING(expected, density, spherecap_pdf(sampler, &offset, &density));
    EXPECT_NOTHING(expected, density, spherecap_pdf_direction(sampler, direction, &density));
    EXPECT_NOTHING(expected, density, spherecap_pdf_on_sphere(sampler, direction, &density));
    EXPECT_NOTHING(expected, u, spherecap_invert(sampler, &offset, u));
    EXPECT_NOTHING(expected, number, spherecap_solid_angle(sampler, &number));
    EXPECT_NOTHING(expected, number, spherecap_projected_solid_angle(sampler, &number));
    EXPECT_NOTHING(expected, number, spherecap_density_bound(sampler, &number));
}

static spherecap_sampler_t good_sampler(uint32_t technique, uint32_t hemispheres, float defensive) {
    spherecap_sampler_t sampler;
    fill_with_rubbish(&sampler, sizeof sampler);
    CHECK(meet(prepare_for(technique, hemispheres, defensive, zenith, ahead, 1.0f, &sampler)) ==
          SPHERECAP_STATUS_OK);
    return sampler;
}

static void good_input(void) {
    CHECK(spherecap_abi_version() == SPHERECAP_ABI);
    char version[64];
    snprintf(version, sizeof version, "%d.%d.%d", SPHERECAP_VERSION_MAJOR, SPHERECAP_VERSION_MINOR,
             SPHERECAP_VERSION_PATCH);
    CHECK(strcmp(spherecap_version(), version) == 0);
    CHECK(strlen(spherecap_batch_instructions()) > 0);

    for (uint32_t technique = SPHERECAP_TECHNIQUE_PROJECTED; technique <= SPHERECAP_TECHNIQUE_SOLID_ANGLE;
         ++technique) {
        for (uint32_t both = SPHERECAP_HEMISPHERES_FRONT; both <= SPHERECAP_HEMISPHERES_BOTH; ++both) {
            for (int eighths = 0; eighths <= 8; ++eighths) {
                const spherecap_sampler_t sampler = good_sampler(technique, both, (float)eighths / 8.0f);
                float solid_angle, projected_solid_angle, bound;
                CHECK(spherecap_solid_angle(&sampler, &solid_angle) == SPHERECAP_STATUS_OK);
                CHECK(spherecap_projected_solid_angle(&sampler, &projected_solid_angle) ==
                      SPHERECAP_STATUS_OK);
                CHECK(spherecap_density_bound(&sampler, &bound) == SPHERECAP_STATUS_OK);
                CHECK(0.0f < projected_solid_angle && projected_solid_angle < solid_angle &&
                      solid_angle < 6.2f);
                CHECK(bound >= 1.0f);

                spherecap_sample_t sample;
                CHECK(spherecap_sample(&sampler, 0.25f, 1.0f, &sample) == SPHERECAP_STATUS_OK);
                CHECK(2.0f < sample.distance && sample.distance < 3.1f);
                spherecap_density_t density;
                CHECK(spherecap_pdf(&sampler, &sample.offset, &density) == SPHERECAP_STATUS_OK);
                CHECK(memcmp(&density, &sample.density, sizeof density) == 0);
                CHECK(density.solid_angle > 0.0f && density.projected_solid_angle > 0.0f);
                CHECK(spherecap_pdf_direction(&sampler, sample.direction, &density) == SPHERECAP_STATUS_OK);
                CHECK(spherecap_pdf_on_sphere(&sampler, sample.direction, &density) == SPHERECAP_STATUS_OK);
                CHECK(density.solid_angle > 0.0f);
                float u[2];
                CHECK(spherecap_invert(&sampler, &sample.offset, u) == SPHERECAP_STATUS_OK);
                CHECK(0.0f <= u[0] && u[0] <= 1.0f && 0.0f <= u[1] && u[1] <= 1.0f);
            }
        }
    }
    // A sampler is plain data: a copy is as good.
    const spherecap_sampler_t sampler =
        good_sampler(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f);
    const spherecap_sampler_t copy = sampler;
    spherecap_sample_t a, b;
    CHECK(spherecap_sample(&sampler, 0.3f, 0.7f, &a) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_sample(&copy, 0.3f, 0.7f, &b) == SPHERECAP_STATUS_OK);
    CHECK(memcmp(&a, &b, sizeof a) == 0);
}

static void expect_refused(uint32_t technique, uint32_t hemispheres, float defensive, const float *normal,
                           const float *centre, float radius, uint32_t expected) {
    spherecap_sampler_t sampler;
    fill_with_rubbish(&sampler, sizeof sampler);
    CHECK(meet(prepare_for(technique, hemispheres, defensive, normal, centre, radius, &sampler)) == expected);
    expect_no_sampler(&sampler, expected);
}

static void bad_input_to_prepare(void) {
    const uint32_t projected = SPHERECAP_TECHNIQUE_PROJECTED, front = SPHERECAP_HEMISPHERES_FRONT;
    const uint32_t no_enumerator[] = {3, 4, 255, 0x7fffffff, 0x80000000, UINT32_MAX};
    for (size_t i = 0; i < sizeof no_enumerator / sizeof *no_enumerator; ++i) {
        expect_refused(no_enumerator[i], front, 0.0f, zenith, ahead, 1.0f, SPHERECAP_STATUS_TECHNIQUE);
        expect_refused(projected, no_enumerator[i], 0.0f, zenith, ahead, 1.0f, SPHERECAP_STATUS_HEMISPHERES);
    }
    expect_refused(projected, 2, 0.0f, zenith, ahead, 1.0f, SPHERECAP_STATUS_HEMISPHERES);

    const float no_fraction[] = {NAN, INFINITY, -INFINITY, -SMALLEST, 1.0f + FLT_EPSILON, FLT_MAX};
    for (size_t i = 0; i < sizeof no_fraction / sizeof *no_fraction; ++i) {
        expect_refused(projected, front, no_fraction[i], zenith, ahead, 1.0f, SPHERECAP_STATUS_DEFENSIVE);
    }

    const float not_finite[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            float normal[3] = {0.0f, 0.0f, 1.0f};
            normal[axis] = not_finite[i];
            expect_refused(projected, front, 0.0f, normal, ahead, 1.0f, SPHERECAP_STATUS_NORMAL);
            expect_refused(SPHERECAP_TECHNIQUE_SOLID_ANGLE, front, 0.0f, normal, ahead, 1.0f,
                           SPHERECAP_STATUS_NORMAL);
        }
    }

    const float no_radius[] = {NAN, INFINITY, -INFINITY, -1.0f, -SMALLEST, -0.0f, 0.0f};
    for (size_t i = 0; i < sizeof no_radius / sizeof *no_radius; ++i) {
        expect_refused(projected, front, 0.0f, zenith, ahead, no_radius[i], SPHERECAP_STATUS_RADIUS);
    }

    for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            float centre[3] = {3.0f, 0.0f, 0.5f};
            centre[axis] = not_finite[i];
            expect_refused(projected, front, 0.0f, zenith, centre, 1.0f, SPHERECAP_STATUS_CENTRE);
        }
    }
    const float at_the_point[3] = {0.0f, -0.0f, 0.0f};
    expect_refused(projected, front, 0.0f, zenith, at_the_point, 1.0f, SPHERECAP_STATUS_CENTRE);

    expect_refused(projected, front, 0.0f, NULL, ahead, 1.0f, SPHERECAP_STATUS_NULL_POINTER);
    expect_refused(projected, front, 0.0f, zenith, NULL, 1.0f, SPHERECAP_STATUS_NULL_POINTER);
    CHECK(meet(prepare_for(projected, front, 0.0f, zenith, ahead, 1.0f, NULL)) ==
          SPHERECAP_STATUS_NULL_POINTER);
}

// Valid input that lights nothing, and its limits: lengths from the smallest to the largest number.
static void valid_input_to_prepare(void) {
    const uint32_t projected = SPHERECAP_TECHNIQUE_PROJECTED, solid_angle = SPHERECAP_TECHNIQUE_SOLID_ANGLE;
    const uint32_t front = SPHERECAP_HEMISPHERES_FRONT, both = SPHERECAP_HEMISPHERES_BOTH;
    const float lengths[] = {4.0f * SMALLEST, FLT_MIN, 1.0f, FLT_MAX};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; ++i) {
        const float d = lengths[i];
        const float above[3] = {0.0f, 0.0f, d}, below[3] = {0.0f, 0.0f, -d};
        spherecap_sampler_t sampler;
        CHECK(prepare_for(projected, front, 0.0f, zenith, above, d / 2.0f, &sampler) == SPHERECAP_STATUS_OK);
        spherecap_sample_t sample;
        CHECK(spherecap_sample(&sampler, 0.5f, 0.5f, &sample) == SPHERECAP_STATUS_OK);
        CHECK(d / 2.0f <= sample.distance && sample.distance <= d);

        expect_refused(projected, front, 0.0f, zenith, above, d, SPHERECAP_STATUS_INSIDE);
        expect_refused(projected, front, 0.0f, zenith, above, FLT_MAX, SPHERECAP_STATUS_INSIDE);
        expect_refused(projected, front, 0.0f, zenith, below, d / 2.0f, SPHERECAP_STATUS_INVISIBLE);
        // What the horizon hides is there for the techniques that sample it.
        CHECK(prepare_for(projected, both, 0.0f, zenith, below, d / 2.0f, &sampler) == SPHERECAP_STATUS_OK);
        CHECK(prepare_for(projected, front, 0.5f, zenith, below, d / 2.0f, &sampler) == SPHERECAP_STATUS_OK);
        CHECK(prepare_for(solid_angle, front, 0.0f, zenith, below, d / 2.0f, &sampler) ==
              SPHERECAP_STATUS_OK);
    }
    // Too small for any density to be a number.
    expect_refused(projected, front, 0.0f, zenith, ahead, SMALLEST, SPHERECAP_STATUS_INVISIBLE);
    expect_refused(solid_angle, front, 0.0f, zenith, ahead, SMALLEST, SPHERECAP_STATUS_INVISIBLE);

    // No surface: every technique samples by solid angle, and nothing has a cosine.
    const float none[3] = {0.0f, -0.0f, 0.0f};
    for (uint32_t technique = projected; technique <= solid_angle; ++technique) {
        spherecap_sampler_t sampler;
        spherecap_sample_t sample;
        CHECK(prepare_for(technique, front, 0.0f, none, ahead, 1.0f, &sampler) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_sample(&sampler, 0.5f, 0.5f, &sample) == SPHERECAP_STATUS_OK);
        CHECK(sample.density.solid_angle > 0.0f && sample.offset.cosine == 0.0f);
    }
}

// A normal says the same whatever its length.
static void normals_of_every_length(void) {
    const float lengths[] = {SMALLEST, 3.0f * SMALLEST, FLT_MIN, 1e-20f, 0.999f,
                             1.0f,     1.001f,          2.0f,    1e20f,  FLT_MAX};
    spherecap_sample_t expected = {0};
    for (int axis = 0; axis < 3; ++axis) {
        for (int sign = -1; sign <= 1; sign += 2) {
            float centre[3] = {0.4f, 0.5f, 0.6f}, unit[3] = {0.0f, 0.0f, 0.0f};
            unit[axis] = (float)sign;
            centre[axis] *= (float)sign;
            spherecap_sampler_t sampler;
            CHECK(prepare_for(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f, unit, centre,
                              0.7f, &sampler) == SPHERECAP_STATUS_OK);
            CHECK(spherecap_sample(&sampler, 0.2f, 0.3f, &expected) == SPHERECAP_STATUS_OK);
            for (size_t i = 0; i < sizeof lengths / sizeof *lengths; ++i) {
                float normal[3] = {0.0f, 0.0f, 0.0f};
                normal[axis] = unit[axis] * lengths[i];
                spherecap_sample_t sample;
                CHECK(prepare_for(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f, normal,
                                  centre, 0.7f, &sampler) == SPHERECAP_STATUS_OK);
                CHECK(spherecap_sample(&sampler, 0.2f, 0.3f, &sample) == SPHERECAP_STATUS_OK);
                CHECK(memcmp(&sample, &expected, sizeof sample) == 0);
            }
        }
    }
    // Where the sum of the components is beyond the largest number.
    const float longest[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, third = 0.57735026919f;
    const float diagonal[3] = {third, third, third};
    spherecap_sampler_t sampler;
    float cosines[2];
    for (int i = 0; i < 2; ++i) {
        spherecap_sample_t sample;
        CHECK(prepare_for(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f,
                          i == 0 ? longest : diagonal, ahead, 1.0f, &sampler) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_sample(&sampler, 0.2f, 0.3f, &sample) == SPHERECAP_STATUS_OK);
        cosines[i] = sample.offset.cosine;
    }
    CHECK(fabsf(cosines[0] - cosines[1]) < 4.0f * FLT_EPSILON);
}

static void bad_input_to_the_others(void) {
    const spherecap_sampler_t sampler =
        good_sampler(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f);
    const spherecap_offset_t centre = {0.0f, 0.0f, 0.5f};
    const float direction[3] = {1.0f, 0.0f, 0.0f};
    spherecap_sample_t sample;
    spherecap_density_t density;
    float u[2];

    const float below[] = {NAN, -INFINITY, -1.0f, -SMALLEST},
                above[] = {INFINITY, FLT_MAX, 2.0f, 1.0f + FLT_EPSILON};
    for (int i = 0; i < 8; ++i) {
        const float outside = i < 4 ? below[i] : above[i - 4], end = i < 4 ? 0.0f : 1.0f;
        spherecap_sample_t expected;
        CHECK(spherecap_sample(&sampler, outside, 0.5f, &sample) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_sample(&sampler, end, 0.5f, &expected) == SPHERECAP_STATUS_OK);
        CHECK(memcmp(&sample, &expected, sizeof sample) == 0);
        CHECK(spherecap_sample(&sampler, 0.5f, outside, &sample) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_sample(&sampler, 0.5f, end, &expected) == SPHERECAP_STATUS_OK);
        CHECK(memcmp(&sample, &expected, sizeof sample) == 0);
    }
    const float ends[] = {0.0f, -0.0f, SMALLEST, 1.0f - FLT_EPSILON / 2.0f, 1.0f};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i) {
        for (size_t j = 0; j < sizeof ends / sizeof *ends; ++j) {
            CHECK(spherecap_sample(&sampler, ends[i], ends[j], &sample) == SPHERECAP_STATUS_OK);
            CHECK(sample.density.solid_angle > 0.0f);
        }
    }

    const float not_finite[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            float v[3] = {1.0f, 0.0f, 0.0f};
            v[axis] = not_finite[i];
            const spherecap_offset_t offset = {v[0], v[1], v[2]};
            EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, density, spherecap_pdf(&sampler, &offset, &density));
            EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, density,
                           spherecap_pdf_direction(&sampler, v, &density));
            EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, density,
                           spherecap_pdf_on_sphere(&sampler, v, &density));
            EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, u, spherecap_invert(&sampler, &offset, u));
        }
    }

    // 0.001 is the tolerance that the header states, of lengths and so of components.
    const float no_length[] = {0.0f, SMALLEST, 0.9989f, 1.0011f, -2.0f, FLT_MAX};
    for (size_t i = 0; i < sizeof no_length / sizeof *no_length; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            float v[3] = {0.0f, 0.0f, 0.0f};
            v[axis] = no_length[i];
            EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, density,
                           spherecap_pdf_direction(&sampler, v, &density));
            EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, density,
                           spherecap_pdf_on_sphere(&sampler, v, &density));
            if (fabsf(v[axis]) > 1.0f) {
                const spherecap_offset_t offset = {v[0], v[1], v[2]};
                EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, density,
                               spherecap_pdf(&sampler, &offset, &density));
                EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, u, spherecap_invert(&sampler, &offset, u));
            }
        }
    }

    // Inputs that are NULL, one at a time.
    const uint32_t null = SPHERECAP_STATUS_NULL_POINTER;
    expect_no_sampler(NULL, null);
    EXPECT_NOTHING(null, density, spherecap_pdf(&sampler, NULL, &density));
    EXPECT_NOTHING(null, density, spherecap_pdf_direction(&sampler, NULL, &density));
    EXPECT_NOTHING(null, density, spherecap_pdf_on_sphere(&sampler, NULL, &density));
    EXPECT_NOTHING(null, u, spherecap_invert(&sampler, NULL, u));
    // Outputs that are.
    CHECK(spherecap_sample(&sampler, 0.5f, 0.5f, NULL) == null);
    CHECK(spherecap_pdf(&sampler, &centre, NULL) == null);
    CHECK(spherecap_pdf_direction(&sampler, direction, NULL) == null);
    CHECK(spherecap_pdf_on_sphere(&sampler, direction, NULL) == null);
    const spherecap_receiver_t receiver = {{0.0f, 0.0f, 1.0f}, 0, 0, 0.0f};
    CHECK(spherecap_sample_once(&receiver, ahead, 1.0f, 0.5f, 0.5f, NULL) == null);
    CHECK(spherecap_pdf_once(&receiver, ahead, 1.0f, direction, NULL) == null);
    EXPECT_NOTHING(null, density, spherecap_pdf_once(&receiver, ahead, 1.0f, NULL, &density));
    const float too_long[3] = {1.1f, 0.0f, 0.0f};
    EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, density,
                   spherecap_pdf_once(&receiver, ahead, 1.0f, too_long, &density));
    CHECK(spherecap_invert(&sampler, &centre, NULL) == null);
    CHECK(spherecap_solid_angle(&sampler, NULL) == null);
    CHECK(spherecap_projected_solid_angle(&sampler, NULL) == null);
    CHECK(spherecap_density_bound(&sampler, NULL) == null);
}

// A recorder that numbers its nodes, counts those that are alive, and fails when it has made enough.
typedef struct counter_t {
    uint64_t made, enough, alive;
} counter_t;

static uint64_t count_node(counter_t *counter) {
    if (counter->made == counter->enough) {
        return 0;
    }
    ++counter->alive;
    return ++counter->made;
}

static uint64_t count_literal(void *user, float value) {
    (void)value;
    return count_node((counter_t *)user);
}

static uint64_t count_operation(void *user, spherecap_op_t op, const uint64_t *operands,
                                uint32_t is_rounded) {
    CHECK(op <= SPHERECAP_OP_FLOAT_OF_BITS && operands[0] != 0 && is_rounded <= 1);
    return count_node((counter_t *)user);
}

static void count_release(void *user, uint64_t node) {
    CHECK(node != 0);
    --((counter_t *)user)->alive;
}

static uint64_t count_begin_if(void *user, uint64_t mask) {
    (void)user;
    return mask;
}

static uint32_t count_end_if(void *user, uint64_t conditional, uint64_t *nodes, size_t count) {
    CHECK(conditional != 0 && count > 0);
    for (size_t i = 0; i < count; ++i) {
        const uint64_t node = count_node((counter_t *)user);
        if (node == 0) {
            while (i-- > 0) {
                count_release(user, nodes[i]);
            }
            return 0;
        }
        nodes[i] = node;
    }
    return 1;
}

// All functions give this status and zeros.
static void expect_no_record(const spherecap_recorder_t *recorder, const spherecap_recorded_input_t *input,
                             const spherecap_term_t *u, const spherecap_term_t *direction,
                             uint32_t expected) {
    spherecap_recorded_sample_t sample;
    spherecap_recorded_density_t density;
    EXPECT_NOTHING(expected, sample, spherecap_record_sample(recorder, input, u, &sample));
    EXPECT_NOTHING(expected, density, spherecap_record_pdf_on_sphere(recorder, input, direction, &density));
    uint64_t importance;
    EXPECT_NOTHING(expected, importance, spherecap_record_importance(recorder, input, u, &importance));
}

static void expect_no_choice(const spherecap_recorder_t *recorder, const spherecap_term_t *importance,
                             const spherecap_recorded_total_t *total, const spherecap_term_t *even,
                             uint32_t expected) {
    uint64_t probability;
    EXPECT_NOTHING(expected, probability,
                   spherecap_record_choice_probability(recorder, importance, total, even, &probability));
    spherecap_total_nodes_t with;
    if (even != NULL) {
        EXPECT_NOTHING(expected, with, spherecap_record_total(recorder, importance, total, &with));
    }
}

static void recorders(void) {
    const uint32_t null = SPHERECAP_STATUS_NULL_POINTER;
    counter_t counter = {100, UINT64_MAX, 0};
    const spherecap_recorder_t recorder = {&counter,      count_literal,  count_operation,
                                           count_release, count_begin_if, count_end_if};
    const spherecap_term_t term[3] = {{1, 0.0f}, {2, 0.0f}, {3, 0.0f}};
    const spherecap_recorded_input_t good = {
        SPHERECAP_TECHNIQUE_PROJECTED,     SPHERECAP_HEMISPHERES_BOTH,        {0, 0.125f},
        {{4, 0.0f}, {5, 0.0f}, {6, 0.0f}}, {{7, 0.0f}, {8, 0.0f}, {9, 0.0f}}, {10, 0.0f}};
    spherecap_recorded_sample_t sample;
    spherecap_recorded_density_t density;
    CHECK(spherecap_record_sample(&recorder, &good, term, &sample) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_record_pdf_on_sphere(&recorder, &good, term, &density) == SPHERECAP_STATUS_OK);
    uint64_t importance;
    CHECK(spherecap_record_importance(&recorder, &good, term, &importance) == SPHERECAP_STATUS_OK);
    const spherecap_recorded_total_t total = {{2, 0.0f}, {3, 0.0f}};
    spherecap_total_nodes_t with;
    CHECK(spherecap_record_total(&recorder, term, &total, &with) == SPHERECAP_STATUS_OK);
    uint64_t probability;
    CHECK(spherecap_record_choice_probability(&recorder, term, &total, term, &probability) ==
          SPHERECAP_STATUS_OK);
    CHECK(counter.alive == 17 && sample.density.solid_angle != 0 && density.solid_angle != 0);
    CHECK(importance != 0 && with.sum != 0 && with.lit != 0 && probability != 0);
    counter.alive = 0;

    counter.enough = counter.made + 50;
    expect_no_record(&recorder, &good, term, term, SPHERECAP_STATUS_RECORDER);
    CHECK(counter.alive == 0 && counter.made == counter.enough);
    expect_no_choice(&recorder, term, &total, term, SPHERECAP_STATUS_RECORDER);
    CHECK(counter.alive == 0);
    counter.enough = UINT64_MAX;

    for (int i = 0; i < 5; ++i) {
        spherecap_recorder_t incomplete = recorder;
        incomplete.literal = i == 0 ? NULL : incomplete.literal;
        incomplete.op = i == 1 ? NULL : incomplete.op;
        incomplete.release = i == 2 ? NULL : incomplete.release;
        incomplete.begin_if = i == 3 ? NULL : incomplete.begin_if;
        incomplete.end_if = i == 4 ? NULL : incomplete.end_if;
        expect_no_record(&incomplete, &good, term, term, null);
        expect_no_choice(&incomplete, term, &total, term, null);
    }
    expect_no_choice(NULL, term, &total, term, null);
    expect_no_choice(&recorder, NULL, &total, term, null);
    expect_no_choice(&recorder, term, NULL, term, null);
    expect_no_choice(&recorder, term, &total, NULL, null);
    CHECK(spherecap_record_total(&recorder, term, &total, NULL) == null);
    CHECK(spherecap_record_choice_probability(&recorder, term, &total, term, NULL) == null);
    expect_no_record(NULL, &good, term, term, null);
    expect_no_record(&recorder, NULL, term, term, null);
    expect_no_record(&recorder, &good, NULL, NULL, null);
    CHECK(spherecap_record_sample(&recorder, &good, term, NULL) == null);
    CHECK(spherecap_record_pdf_on_sphere(&recorder, &good, term, NULL) == null);
    CHECK(spherecap_record_importance(&recorder, &good, term, NULL) == null);
    spherecap_recorded_input_t input = good;
    input.technique = 3;
    expect_no_record(&recorder, &input, term, term, SPHERECAP_STATUS_TECHNIQUE);
    input = good;
    input.hemispheres = UINT32_MAX;
    expect_no_record(&recorder, &input, term, term, SPHERECAP_STATUS_HEMISPHERES);
    CHECK(counter.alive == 0);
}

// Every function in double precision, and samplers of one precision given to functions of the other.
static void double_precision(void) {
    const spherecap_receiver_f64_t receiver = {
        {0.0, 0.0, 7.0}, SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0};
    const double centre[3] = {3.0, 0.0, 0.5}, at_the_point[3] = {0.0, 0.0, 0.0},
                 too_long[3] = {1.1, 0.0, 0.0};
    spherecap_sampler_f64_t sampler;
    spherecap_sample_f64_t sample;
    spherecap_density_f64_t density;
    double u[2], solid_angle, projected_solid_angle, bound;
    CHECK(meet(spherecap_prepare_f64(&receiver, centre, 1.0, &sampler)) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_sample_f64(&sampler, 0.25, 0.75, &sample) == SPHERECAP_STATUS_OK);
    spherecap_sample_f64_t once;
    CHECK(spherecap_sample_once_f64(&receiver, centre, 1.0, 0.25, 0.75, &once) == SPHERECAP_STATUS_OK);
    CHECK(memcmp(&once, &sample, sizeof once) == 0);
    spherecap_density_f64_t density_once;
    CHECK(spherecap_pdf_once_f64(&receiver, centre, 1.0, sample.direction, &density_once) ==
          SPHERECAP_STATUS_OK);
    CHECK(spherecap_pdf_f64(&sampler, &sample.offset, &density) == SPHERECAP_STATUS_OK);
    CHECK(memcmp(&density, &sample.density, sizeof density) == 0);
    CHECK(spherecap_pdf_direction_f64(&sampler, sample.direction, &density) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_pdf_on_sphere_f64(&sampler, sample.direction, &density) == SPHERECAP_STATUS_OK);
    CHECK(memcmp(&density_once, &density, sizeof density) == 0);
    CHECK(fabs(density.solid_angle / sample.density.solid_angle - 1.0) < 1e-12);
    CHECK(spherecap_invert_f64(&sampler, &sample.offset, u) == SPHERECAP_STATUS_OK);
    CHECK(fabs(u[0] - 0.25) < 1e-12 && fabs(u[1] - 0.75) < 1e-12);
    CHECK(spherecap_solid_angle_f64(&sampler, &solid_angle) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_projected_solid_angle_f64(&sampler, &projected_solid_angle) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_density_bound_f64(&sampler, &bound) == SPHERECAP_STATUS_OK);
    CHECK(fabs(sample.offset.cosine / sample.density.solid_angle / projected_solid_angle - 1.0) < 1e-12);
    CHECK(projected_solid_angle < solid_angle && bound == 1.0);
    spherecap_sample_f64_t end;
    CHECK(spherecap_sample_f64(&sampler, NAN, 2.0, &sample) == SPHERECAP_STATUS_OK);
    CHECK(spherecap_sample_f64(&sampler, 0.0, 1.0, &end) == SPHERECAP_STATUS_OK);
    CHECK(memcmp(&sample, &end, sizeof sample) == 0);

    EXPECT_NOTHING(SPHERECAP_STATUS_DIRECTION, density,
                   spherecap_pdf_direction_f64(&sampler, too_long, &density));
    EXPECT_NOTHING(SPHERECAP_STATUS_NULL_POINTER, sample, spherecap_sample_f64(NULL, 0.5, 0.5, &sample));
    CHECK(spherecap_prepare_f64(&receiver, centre, 1.0, NULL) == SPHERECAP_STATUS_NULL_POINTER);
    spherecap_sampler_f64_t refused;
    fill_with_rubbish(&refused, sizeof refused);
    CHECK(spherecap_prepare_f64(&receiver, at_the_point, 1.0, &refused) == SPHERECAP_STATUS_CENTRE);
    EXPECT_NOTHING(SPHERECAP_STATUS_CENTRE, sample, spherecap_sample_f64(&refused, 0.5, 0.5, &sample));

    spherecap_sampler_t single =
        good_sampler(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f);
    spherecap_sample_t single_sample;
    EXPECT_NOTHING(
        SPHERECAP_STATUS_SAMPLER, single_sample,
        spherecap_sample((const spherecap_sampler_t *)(const void *)&sampler, 0.5f, 0.5f, &single_sample));
    memcpy(&refused, &single, sizeof single);
    EXPECT_NOTHING(SPHERECAP_STATUS_SAMPLER, sample, spherecap_sample_f64(&refused, 0.5, 0.5, &sample));
}

static void samplers_that_were_never_prepared(void) {
    const int patterns[] = {0x00, 0xff, 0xa5, 0x7f};
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; ++i) {
        spherecap_sampler_t sampler;
        memset(&sampler, patterns[i], sizeof sampler);
        expect_no_sampler(&sampler, SPHERECAP_STATUS_SAMPLER);
    }
    // Overwritten ones are noticed by their first four words, which hold what must not be trusted.
    for (int word = 0; word < 4; ++word) {
        const uint32_t overwritten[] = {64, 0x80000000, UINT32_MAX};
        for (int i = 0; i < 3; ++i) {
            spherecap_sampler_t sampler =
                good_sampler(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_BOTH, 0.5f);
            sampler.words[word] = overwritten[i];
            expect_no_sampler(&sampler, SPHERECAP_STATUS_SAMPLER);
        }
    }
}

static void messages(void) {
    met[SPHERECAP_STATUS_INSTRUCTIONS] = 1; // by `no_instructions.c`
    met[SPHERECAP_STATUS_EVEN] = 1;         // by `lights.c`
    const char *no_status = spherecap_status_message(UINT32_MAX);
    for (uint32_t status = 0; status < sizeof met / sizeof *met; ++status) {
        const char *message = spherecap_status_message(status);
        CHECK(message != NULL && strlen(message) > 0);
        // A status that was met has words of its own, and every other number those for no status.
        CHECK(met[status] == (strcmp(message, no_status) != 0));
        for (uint32_t other = 0; other < status; ++other) {
            CHECK(!met[status] || strcmp(message, spherecap_status_message(other)) != 0);
        }
        if (met[status]) {
            printf("%u %s\n", (unsigned)status, message);
        }
    }
}

int main(void) {
    good_input();
    bad_input_to_prepare();
    valid_input_to_prepare();
    normals_of_every_length();
    bad_input_to_the_others();
    double_precision();
    samplers_that_were_never_prepared();
    recorders();
    messages();
    return 0;
}
