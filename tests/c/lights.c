// Chooses among lights, in arrays of every length that end where memory ends: the bits of one light alone, of
// batches over points, and of the total; every kind of bad input. Then prints for each line that it reads
// (they are those of `bits.c`) the bits of the sum of the one importance that it has, its first random number
// being the strength.

#include "spherecap.h" // first, so that it must be self-contained

#include "check.h"

#include <inttypes.h>
#include <math.h>

enum { MOST = 400, WORDS_IN = 12 };

static const size_t counts[] = {0, 1, 3, 16, 17, MOST};
static const float point[3] = {0.25f, -0.5f, 0.125f};

// Each just before an inaccessible page; those of fewer lights are their ends.
static float *inputs[5], *importances, *centre[3], *normal[3];

static uint32_t state = 1;

static float unit_number(void) {
    state = state * 1664525u + 1013904223u;
    return (float)(state >> 8) / 16777216.0f;
}

static float *array(void) { return (float *)guarded_memory(MOST * sizeof(float)); }

// Lights around the point, a third of them below the horizon, some of them none.
static void fill(void) {
    importances = array();
    for (int k = 0; k < 5; ++k) {
        inputs[k] = array();
    }
    for (int k = 0; k < 3; ++k) {
        centre[k] = array();
        normal[k] = array();
    }
    for (size_t i = 0; i < MOST; ++i) {
        for (int k = 0; k < 3; ++k) {
            inputs[k][i] = 6.0f * unit_number() - 2.0f;
            normal[k][i] = k == 2 ? 2.0f : 0.0f;
        }
        inputs[3][i] = 0.01f + 0.9f * unit_number();
        inputs[4][i] = 10.0f * unit_number();
        if (i % 19 == 7) {
            inputs[i / 19 % 5][i] = i % 2 == 0 ? NAN : INFINITY;
        }
        for (int k = 0; k < 3; ++k) {
            centre[k][i] = inputs[k][i] - point[k];
        }
    }
    inputs[4][MOST - 2] = 0.0f;
}

static spherecap_lights_t last(size_t count) {
    const size_t first = MOST - count;
    const spherecap_lights_t lights = {count,
                                       {inputs[0] + first, inputs[1] + first, inputs[2] + first},
                                       inputs[3] + first,
                                       inputs[4] + first};
    return lights;
}

static int is_same(const void *a, const void *b, size_t size) { return memcmp(a, b, size) == 0; }

static void every_length(uint32_t technique, uint32_t hemispheres, float defensive) {
    const spherecap_receiver_t receiver = {{0.0f, 0.0f, 2.0f}, technique, hemispheres, defensive};
    for (size_t c = 0; c < sizeof counts / sizeof *counts; ++c) {
        const size_t count = counts[c], first = MOST - count;
        const spherecap_lights_t lights = last(count);
        float *const found = importances + first;
        spherecap_total_t total, again;
        fill_with_rubbish(importances, MOST * sizeof(float));
        fill_with_rubbish(&total, sizeof total);
        CHECK(spherecap_importances(&receiver, point, &lights, found, &total) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_total(found, count, &again) == SPHERECAP_STATUS_OK);
        CHECK(total.sum == again.sum && total.lit == again.lit && total.lit <= count);
        uint32_t lit = 0;
        for (size_t i = 0; i < count; ++i) {
            const spherecap_lights_t one = {
                1,
                {lights.centre[0] + i, lights.centre[1] + i, lights.centre[2] + i},
                lights.radius + i,
                lights.strength + i};
            float alone;
            CHECK(spherecap_importances(&receiver, point, &one, &alone, &again) == SPHERECAP_STATUS_OK);
            CHECK(is_same(&alone, &found[i], sizeof alone) && again.sum == alone);
            CHECK(0.0f <= alone && alone < 10.0f && again.lit == (alone > 0.0f));
            lit += again.lit;
        }
        CHECK(total.lit == lit);

        // Over points, of which each sees its light from where it is.
        const spherecap_batch_t batch = {technique,
                                         hemispheres,
                                         defensive,
                                         count,
                                         {normal[0] + first, normal[1] + first, normal[2] + first},
                                         {centre[0] + first, centre[1] + first, centre[2] + first},
                                         inputs[3] + first};
        float expected[MOST];
        memcpy(expected, importances, sizeof expected);
        size_t refused = SIZE_MAX, bad = 0;
        CHECK(spherecap_batch_importances(&batch, lights.strength, found, &refused) == SPHERECAP_STATUS_OK);
        CHECK(is_same(importances, expected, sizeof expected));
        for (size_t i = first; i < MOST; ++i) {
            bad += i % 19 == 7;
        }
        CHECK(refused == bad);

        // Every choice has the probability that its light has.
        const float evens[] = {0.0f, 0.05f, 1.0f};
        for (int e = 0; e < 3; ++e) {
            double all = 0.0;
            for (size_t i = 0; i < count; ++i) {
                float probability;
                CHECK(spherecap_choice_probability(found[i], &total, evens[e], &probability) ==
                      SPHERECAP_STATUS_OK);
                CHECK((probability > 0.0f) == (found[i] > 0.0f));
                all += (double)probability;
            }
            CHECK(lit == 0 ? all == 0.0 : fabs(all - 1.0) < 1.2e-7);
            const float numbers[] = {NAN, -1.0f, 0.0f, unit_number(), unit_number(), 1.0f, INFINITY};
            for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
                spherecap_choice_t choice;
                float probability;
                fill_with_rubbish(&choice, sizeof choice);
                CHECK(spherecap_choose(found, count, &total, evens[e], numbers[i], &choice) ==
                      SPHERECAP_STATUS_OK);
                CHECK(0.0f <= choice.rest && choice.rest <= 1.0f);
                if (lit == 0) {
                    CHECK(choice.index == 0 && choice.probability == 0.0f && choice.rest == 0.0f);
                    continue;
                }
                CHECK(choice.index < count && choice.probability > 0.0f);
                CHECK(spherecap_choice_probability(found[choice.index], &total, evens[e], &probability) ==
                      SPHERECAP_STATUS_OK);
                CHECK(is_same(&choice.probability, &probability, sizeof probability));
                if (lit == 1) {
                    CHECK(probability == 1.0f);
                    CHECK(!(0.0f <= numbers[i] && numbers[i] <= 1.0f) || choice.rest == numbers[i]);
                }
            }
        }
    }
}

// Nobody's arrays of nothing: they may be NULL.
static void nothing(void) {
    const spherecap_receiver_t receiver = {{0.0f, 0.0f, 1.0f}, 0, 0, 0.0f};
    const spherecap_lights_t none = {0, {NULL, NULL, NULL}, NULL, NULL};
    spherecap_total_t total;
    spherecap_choice_t choice;
    fill_with_rubbish(&total, sizeof total);
    CHECK(spherecap_importances(&receiver, point, &none, NULL, &total) == SPHERECAP_STATUS_OK);
    CHECK(total.sum == 0.0f && total.lit == 0);
    CHECK(spherecap_total(NULL, 0, &total) == SPHERECAP_STATUS_OK);
    CHECK(total.sum == 0.0f && total.lit == 0);
    fill_with_rubbish(&choice, sizeof choice);
    CHECK(spherecap_choose(NULL, 0, &total, 0.05f, 0.5f, &choice) == SPHERECAP_STATUS_OK);
    CHECK(choice.index == 0 && choice.probability == 0.0f && choice.rest == 0.0f);
    const spherecap_batch_t batch = {0, 0, 0.0f, 0, {NULL, NULL, NULL}, {NULL, NULL, NULL}, NULL};
    size_t refused = 1;
    CHECK(spherecap_batch_importances(&batch, NULL, NULL, &refused) == SPHERECAP_STATUS_OK && refused == 0);
}

// This status, a total of nothing, and no importance is stored.
static void expect_refused(const spherecap_receiver_t *receiver, const float *at,
                           const spherecap_lights_t *lights, float *out, uint32_t expected) {
    spherecap_total_t total;
    fill_with_rubbish(&total, sizeof total);
    fill_with_rubbish(importances, MOST * sizeof(float));
    const float rubbish = importances[0];
    CHECK(spherecap_importances(receiver, at, lights, out, &total) == expected);
    CHECK(is_all_zero(&total, sizeof total));
    for (size_t i = 0; i < MOST; ++i) {
        CHECK(is_same(&importances[i], &rubbish, sizeof rubbish));
    }
}

static void bad_input(void) {
    const uint32_t null = SPHERECAP_STATUS_NULL_POINTER, even = SPHERECAP_STATUS_EVEN;
    const spherecap_receiver_t good = {{0.0f, 0.0f, 1.0f}, 0, 0, 0.0f};
    const spherecap_lights_t lights = last(3);
    float *const out = importances + MOST - 3;
    spherecap_total_t total;
    expect_refused(NULL, point, &lights, out, null);
    expect_refused(&good, NULL, &lights, out, null);
    expect_refused(&good, point, NULL, out, null);
    expect_refused(&good, point, &lights, NULL, null);
    CHECK(spherecap_importances(&good, point, &lights, out, NULL) == null);
    for (int k = 0; k < 5; ++k) {
        spherecap_lights_t some = lights;
        if (k < 3) {
            some.centre[k] = NULL;
        } else if (k == 3) {
            some.radius = NULL;
        } else {
            some.strength = NULL;
        }
        expect_refused(&good, point, &some, out, null);
    }
    spherecap_receiver_t receiver = good;
    receiver.technique = 3;
    expect_refused(&receiver, point, &lights, out, SPHERECAP_STATUS_TECHNIQUE);
    receiver = good;
    receiver.hemispheres = UINT32_MAX;
    expect_refused(&receiver, point, &lights, out, SPHERECAP_STATUS_HEMISPHERES);
    const float bad[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; ++i) {
        receiver = good;
        receiver.defensive = bad[i];
        expect_refused(&receiver, point, &lights, out, SPHERECAP_STATUS_DEFENSIVE);
        receiver = good;
        receiver.normal[i] = bad[i];
        expect_refused(&receiver, point, &lights, out, SPHERECAP_STATUS_NORMAL);
        // From nowhere, no light is seen.
        float nowhere[3] = {0.0f, 0.0f, 0.0f};
        nowhere[i] = bad[i];
        CHECK(spherecap_importances(&good, nowhere, &lights, out, &total) == SPHERECAP_STATUS_OK);
        CHECK(total.sum == 0.0f && total.lit == 0);
    }

    const float three[3] = {3.0f, 0.0f, 1.0f};
    spherecap_choice_t choice;
    float probability;
    CHECK(spherecap_total(three, 3, NULL) == null);
    fill_with_rubbish(&total, sizeof total);
    CHECK(spherecap_total(NULL, 3, &total) == null && is_all_zero(&total, sizeof total));
    CHECK(spherecap_total(three, 3, &total) == SPHERECAP_STATUS_OK && total.sum == 4.0f && total.lit == 2);
    CHECK(spherecap_choose(three, 3, &total, 0.0f, 0.5f, NULL) == null);
    CHECK(spherecap_choice_probability(3.0f, &total, 0.0f, NULL) == null);
    fill_with_rubbish(&choice, sizeof choice);
    CHECK(spherecap_choose(NULL, 3, &total, 0.0f, 0.5f, &choice) == null);
    CHECK(is_all_zero(&choice, sizeof choice));
    fill_with_rubbish(&choice, sizeof choice);
    CHECK(spherecap_choose(three, 3, NULL, 0.0f, 0.5f, &choice) == null);
    CHECK(is_all_zero(&choice, sizeof choice));
    CHECK(spherecap_choice_probability(3.0f, NULL, 0.0f, &probability) == null && probability == 0.0f);
    const float no_fraction[] = {NAN, -0.1f, 1.1f, INFINITY};
    for (int i = 0; i < 4; ++i) {
        fill_with_rubbish(&choice, sizeof choice);
        CHECK(spherecap_choose(three, 3, &total, no_fraction[i], 0.5f, &choice) == even);
        CHECK(is_all_zero(&choice, sizeof choice));
        fill_with_rubbish(&probability, sizeof probability);
        CHECK(spherecap_choice_probability(3.0f, &total, no_fraction[i], &probability) == even);
        CHECK(probability == 0.0f);
    }
    // Totals that no importances have choose nothing.
    const spherecap_total_t wrong[] = {{NAN, 2}, {-1.0f, 2}, {0.0f, 2}, {1.0f, 0}};
    for (int i = 0; i < 4; ++i) {
        CHECK(spherecap_choose(three, 3, &wrong[i], 0.5f, 0.5f, &choice) == SPHERECAP_STATUS_OK);
        CHECK(choice.index == 0 && choice.probability == 0.0f);
    }

    const spherecap_batch_t batch = {
        0, 0, 0.0f, MOST, {normal[0], normal[1], normal[2]}, {centre[0], centre[1], centre[2]}, inputs[3]};
    CHECK(spherecap_batch_importances(NULL, inputs[4], importances, NULL) == null);
    CHECK(spherecap_batch_importances(&batch, NULL, importances, NULL) == null);
    CHECK(spherecap_batch_importances(&batch, inputs[4], NULL, NULL) == null);
}

int main(void) {
    fill();
    for (uint32_t technique = 0; technique < 3; ++technique) {
        for (uint32_t both = 0; both < 2; ++both) {
            every_length(technique, both, 0.0f);
            every_length(technique, both, 0.25f);
        }
    }
    nothing();
    bad_input();
    for (;;) {
        float in[WORDS_IN];
        uint32_t words[WORDS_IN];
        for (int i = 0; i < WORDS_IN; ++i) {
            if (scanf("%" SCNx32, &words[i]) != 1) {
                CHECK(i == 0 && feof(stdin));
                return 0;
            }
            memcpy(&in[i], &words[i], sizeof in[i]);
        }
        const spherecap_receiver_t receiver = {{in[3], in[4], in[5]}, words[0], words[1], in[2]};
        const spherecap_lights_t light = {1, {&in[6], &in[7], &in[8]}, &in[9], &in[10]};
        const float origin[3] = {0.0f, 0.0f, 0.0f};
        spherecap_total_t total;
        (void)spherecap_importances(&receiver, origin, &light, importances, &total);
        uint32_t bits;
        memcpy(&bits, &total.sum, sizeof bits);
        printf("%08" PRIx32 "\n", bits);
    }
}
