// Throws numbers of every kind at every function, in memory that the library cannot leave unnoticed: nothing
// may crash, hang or store what the header excludes. The numbers are the same in every run; an argument
// changes how many (default 400000).

#include "spherecap.h"

#include "check.h"

#include <float.h>
#include <math.h>

static uint64_t state;

// splitmix64
static uint64_t random_bits(void) {
    uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

// 0, 1, ..., below - 1.
static unsigned one_of(unsigned below) { return (unsigned)(random_bits() >> 32) % below; }

// In [0, 1), as renderers make them.
static float unit_number(void) { return (float)(random_bits() >> 40) / 16777216.0f; }

// A float with random bits: three in four are ten orders of magnitude or more from 1, and one in 256 is not
// finite.
static float any_number(void) {
    const uint32_t bits = (uint32_t)random_bits();
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static float special_number(void) {
    static const float numbers[] = {0.0f,
                                    1.40129846e-45f, // the smallest subnormal
                                    FLT_MIN / 2.0f,
                                    FLT_MIN,
                                    FLT_EPSILON,
                                    0.5f,
                                    1.0f - FLT_EPSILON / 2.0f,
                                    1.0f,
                                    1.0f + FLT_EPSILON,
                                    16777216.0f,
                                    FLT_MAX / 2.0f,
                                    FLT_MAX,
                                    INFINITY,
                                    NAN};
    const float number = numbers[one_of(sizeof numbers / sizeof *numbers)];
    return one_of(2) ? number : -number;
}

static float some_number(void) {
    switch (one_of(4)) {
    case 0:
        return any_number();
    case 1:
        return special_number();
    case 2:
        return unit_number();
    default:
        return ldexpf(2.0f * unit_number() - 1.0f, (int)one_of(60) - 30);
    }
}

static void some_numbers(float v[3]) {
    const int alike = one_of(2) == 0; // of one magnitude, as real ones are
    const int exponent = (int)one_of(276) - 149;
    for (int i = 0; i < 3; ++i) {
        v[i] = alike ? ldexpf(2.0f * unit_number() - 1.0f, exponent) : some_number();
    }
}

static void unit_vector(float v[3]) {
    double length;
    double w[3];
    do {
        for (int i = 0; i < 3; ++i) {
            w[i] = 2.0 * unit_number() - 1.0;
        }
        length = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    } while (length < 0.1);
    for (int i = 0; i < 3; ++i) {
        v[i] = (float)(w[i] / length);
    }
}

static double length_of(const float v[3]) {
    return sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
}

// An offset may be outside of the cap by 1e-6 of its radius, the sine s. With the point on the limb all the
// same, the direction is longer by s^2 of that, and the normal by 1 + s^2.
static int is_unit(const float v[3]) { return fabs(length_of(v) - 1.0) <= 2e-6; }

static int is_density(spherecap_density_t density) {
    return 0.0f <= density.solid_angle && density.solid_angle <= FLT_MAX &&
           0.0f <= density.projected_solid_angle && density.projected_solid_angle <= FLT_MAX;
}

static int is_in_unit_interval(float u) { return 0.0f <= u && u <= 1.0f; }

// Arguments and results, each just before an inaccessible page.
static float *normal, *centre, *direction, *u, *number;
static spherecap_sampler_t *sampler;
static spherecap_offset_t *offset;
static spherecap_sample_t *sample;
static spherecap_density_t *density;

static void allocate(void) {
    normal = (float *)guarded_memory(3 * sizeof(float));
    centre = (float *)guarded_memory(3 * sizeof(float));
    direction = (float *)guarded_memory(3 * sizeof(float));
    u = (float *)guarded_memory(2 * sizeof(float));
    number = (float *)guarded_memory(sizeof(float));
    sampler = (spherecap_sampler_t *)guarded_memory(sizeof *sampler);
    offset = (spherecap_offset_t *)guarded_memory(sizeof *offset);
    sample = (spherecap_sample_t *)guarded_memory(sizeof *sample);
    density = (spherecap_density_t *)guarded_memory(sizeof *density);
}

// Makes a call on rubbish; what it failed to make is zero.
#define CALL(status, out, call)                                                                              \
    do {                                                                                                     \
        fill_with_rubbish(out, sizeof *(out));                                                               \
        status = (call);                                                                                     \
        CHECK(status == SPHERECAP_STATUS_OK || is_all_zero(out, sizeof *(out)));                             \
    } while (0)

static uint32_t prepare(void) {
    switch (one_of(8)) {
    case 0:
        memset(normal, 0, 3 * sizeof *normal);
        break;
    case 1:
        some_numbers(normal);
        break;
    case 2: {
        // Of nearly unit length.
        const float length = 0.999f + 0.002f * unit_number();
        unit_vector(normal);
        for (int i = 0; i < 3; ++i) {
            normal[i] *= length;
        }
        break;
    }
    default:
        unit_vector(normal);
    }
    some_numbers(centre);
    if (one_of(4) == 0) {
        // The centre on the horizon, or nearly.
        const float height = normal[0] * centre[0] + normal[1] * centre[1] + normal[2] * centre[2];
        for (int i = 0; i < 3; ++i) {
            centre[i] -= height * normal[i];
        }
    }
    float radius = some_number();
    if (one_of(4) != 0) {
        // Of use with this centre, down to where nothing can be weighed, or up to the point.
        const float near = 1.0f - ldexpf(unit_number(), -(int)one_of(24));
        radius = (float)length_of(centre) * (one_of(2) ? near : ldexpf(unit_number(), -(int)one_of(64)));
    }
    const uint32_t technique = one_of(16) == 0 ? (uint32_t)random_bits() : one_of(3);
    const uint32_t hemispheres = one_of(16) == 0 ? (uint32_t)random_bits() : one_of(2);
    const float defensive = one_of(16) == 0 ? some_number() : one_of(2) * unit_number();
    const uint32_t status = prepare_for(technique, hemispheres, defensive, normal, centre, radius, sampler);
    CHECK(status <= SPHERECAP_STATUS_RADIUS && status != SPHERECAP_STATUS_NULL_POINTER);
    return status;
}

static float random_number(void) { return one_of(4) == 0 ? some_number() : unit_number(); }

// What holds for every offset; the calls give either status.
static void use_offset(uint32_t expected, uint32_t allowed) {
    uint32_t status;
    CALL(status, density, spherecap_pdf(sampler, offset, density));
    CHECK((status == expected || status == allowed) && is_density(*density));
    fill_with_rubbish(u, 2 * sizeof *u);
    CHECK(spherecap_invert(sampler, offset, u) == status);
    CHECK(is_in_unit_interval(u[0]) && is_in_unit_interval(u[1]));
}

// What holds for a prepared sampler, and for directions that it did not sample.
static void use(uint32_t prepared) {
    uint32_t status;
    CALL(status, number, spherecap_solid_angle(sampler, number));
    CHECK(status == prepared);
    // Rounding may lead from just below 2 pi to just above, and pi likewise.
    const float above_one = 1.0f + 4 * FLT_EPSILON;
    CHECK(status || (0.0f < *number && *number <= 6.2831853f * above_one));
    CALL(status, number, spherecap_projected_solid_angle(sampler, number));
    CHECK(status == prepared && 0.0f <= *number && *number <= 3.1415927f * above_one);
    CALL(status, number, spherecap_density_bound(sampler, number));
    CHECK(status == prepared && (status || 1.0f <= *number));

    const float u0 = random_number(), u1 = random_number();
    CALL(status, sample, spherecap_sample(sampler, u0, u1, sample));
    CHECK(status == prepared);
    if (status == SPHERECAP_STATUS_OK) {
        CHECK(is_unit(sample->direction) && is_unit(sample->normal));
        CHECK(is_density(sample->density) && sample->density.solid_angle > 0.0f);
        const float largest = 1.0f + 1e-6f; // outside of the cap by as much
        CHECK(fabsf(sample->offset.zenith) <= largest && fabsf(sample->offset.side) <= largest);
        CHECK(fabsf(sample->offset.cosine) <= largest);
        // Infinite only if the centre's distance is.
        CHECK(sample->distance >= 0.0f &&
              (sample->distance <= FLT_MAX || length_of(centre) > (double)FLT_MAX));

        CALL(status, density, spherecap_pdf(sampler, &sample->offset, density));
        CHECK(status == SPHERECAP_STATUS_OK && memcmp(density, &sample->density, sizeof *density) == 0);
        CALL(status, density, spherecap_pdf_direction(sampler, sample->direction, density));
        CHECK(status == SPHERECAP_STATUS_OK && is_density(*density));
        CALL(status, density, spherecap_pdf_on_sphere(sampler, sample->direction, density));
        CHECK(status == SPHERECAP_STATUS_OK && is_density(*density));
        *offset = sample->offset;
        use_offset(prepared, prepared);
    }

    // Directions that may miss the cap.
    unit_vector(direction);
    CALL(status, density, spherecap_pdf_direction(sampler, direction, density));
    CHECK(status == prepared && is_density(*density));
    CALL(status, density, spherecap_pdf_on_sphere(sampler, direction, density));
    CHECK(status == prepared && is_density(*density));
    const float scale = ldexpf(unit_number(), -(int)one_of(64));
    *offset = (spherecap_offset_t){scale * direction[0], scale * direction[1], direction[2]};
    use_offset(prepared, prepared);

    // Numbers that are no direction, most of them: the status for that, or a density like any other.
    some_numbers(direction);
    *offset = (spherecap_offset_t){direction[0], direction[1], direction[2]};
    const uint32_t refused = prepared ? prepared : SPHERECAP_STATUS_DIRECTION;
    const int is_finite = isfinite(direction[0]) && isfinite(direction[1]) && isfinite(direction[2]);
    use_offset(is_finite ? prepared : refused, refused);
    CALL(status, density, spherecap_pdf_direction(sampler, direction, density));
    CHECK(((is_finite && status == prepared) || status == refused) && is_density(*density));
    CALL(status, density, spherecap_pdf_on_sphere(sampler, direction, density));
    CHECK(((is_finite && status == prepared) || status == refused) && is_density(*density));
}

// A sampler with other bits than the library wrote: no value is promised, only that the calls return.
static void use_overwritten(void) {
    const unsigned changes = 1 + one_of(8);
    for (unsigned i = 0; i < changes; ++i) {
        const uint32_t bits = one_of(2) ? (uint32_t)random_bits() : one_of(16);
        // The words before the fourth are checked, which would end most trials there.
        const unsigned first = one_of(8) ? 4 : 0;
        sampler->words[first + one_of(64 - first)] = bits;
    }
    uint32_t status;
    unit_vector(direction);
    *offset = (spherecap_offset_t){direction[0], direction[1], direction[2]};
    CALL(status, sample, spherecap_sample(sampler, unit_number(), unit_number(), sample));
    CALL(status, density, spherecap_pdf(sampler, offset, density));
    CALL(status, density, spherecap_pdf_direction(sampler, direction, density));
    CALL(status, density, spherecap_pdf_on_sphere(sampler, direction, density));
    CALL(status, number, spherecap_solid_angle(sampler, number));
    CALL(status, number, spherecap_projected_solid_angle(sampler, number));
    CALL(status, number, spherecap_density_bound(sampler, number));
    (void)spherecap_invert(sampler, offset, u);
}

// Several lights, all arrays ending where their memory does: x, y, z, radius, strength; and a normal for
// each.
enum { MOST_LIGHTS = 20 };
static float *numbers[5], *normals[3], *importances, *of_batch, *probability;
static spherecap_total_t *total;
static spherecap_choice_t *choice;

static void allocate_lights(void) {
    for (int k = 0; k < 5; ++k) {
        numbers[k] = (float *)guarded_memory(MOST_LIGHTS * sizeof(float));
    }
    for (int k = 0; k < 3; ++k) {
        normals[k] = (float *)guarded_memory(MOST_LIGHTS * sizeof(float));
    }
    importances = (float *)guarded_memory(MOST_LIGHTS * sizeof(float));
    of_batch = (float *)guarded_memory(MOST_LIGHTS * sizeof(float));
    probability = (float *)guarded_memory(sizeof(float));
    total = (spherecap_total_t *)guarded_memory(sizeof *total);
    choice = (spherecap_choice_t *)guarded_memory(sizeof *choice);
}

// Importances as the library stores them, one by one and in a batch. The normal is the last that was prepared
// with. Gives the status.
static uint32_t weigh_lights(size_t count) {
    const size_t first = MOST_LIGHTS - count;
    for (size_t i = first; i < MOST_LIGHTS; ++i) {
        float at[3];
        some_numbers(at);
        for (int k = 0; k < 3; ++k) {
            numbers[k][i] = at[k];
            normals[k][i] = normal[k];
        }
        numbers[3][i] = one_of(4) ? (float)length_of(at) * unit_number() : some_number();
        numbers[4][i] = one_of(4) ? unit_number() : some_number();
        importances[i] = of_batch[i] = -1.0f;
    }
    const uint32_t technique = one_of(16) == 0 ? (uint32_t)random_bits() : one_of(3);
    const uint32_t hemispheres = one_of(16) == 0 ? (uint32_t)random_bits() : one_of(2);
    const float defensive = one_of(16) == 0 ? some_number() : one_of(2) * unit_number();
    const spherecap_receiver_t receiver = {
        {normal[0], normal[1], normal[2]}, technique, hemispheres, defensive};
    const spherecap_lights_t lights = {count,
                                       {numbers[0] + first, numbers[1] + first, numbers[2] + first},
                                       numbers[3] + first,
                                       numbers[4] + first};
    const int is_at_origin = one_of(2) == 0;
    memset(direction, 0, 3 * sizeof *direction);
    if (!is_at_origin) {
        some_numbers(direction);
    }
    uint32_t status;
    CALL(status, total, spherecap_importances(&receiver, direction, &lights, importances + first, total));
    CHECK(status == SPHERECAP_STATUS_OK ||
          (SPHERECAP_STATUS_TECHNIQUE <= status && status <= SPHERECAP_STATUS_NORMAL));
    uint32_t lit = 0;
    for (size_t i = first; i < MOST_LIGHTS; ++i) {
        if (status) {
            CHECK(importances[i] == -1.0f);
            continue;
        }
        CHECK(importances[i] == 0.0f || (FLT_MIN <= importances[i] && importances[i] <= FLT_MAX));
        CHECK(importances[i] == 0.0f || (0.0f < numbers[4][i] && numbers[4][i] <= FLT_MAX));
        lit += importances[i] > 0.0f;
    }
    CHECK(total->lit == lit && 0.0f <= total->sum && total->sum <= FLT_MAX);

    // The centres minus a point of zeros are the centres: the same bits.
    const spherecap_batch_t batch = {technique,
                                     hemispheres,
                                     defensive,
                                     count,
                                     {normals[0] + first, normals[1] + first, normals[2] + first},
                                     {numbers[0] + first, numbers[1] + first, numbers[2] + first},
                                     numbers[3] + first};
    const uint32_t of_all = spherecap_batch_importances(&batch, numbers[4] + first, of_batch + first, NULL);
    CHECK(of_all == status || status == SPHERECAP_STATUS_NORMAL);
    if (is_at_origin && status == SPHERECAP_STATUS_OK) {
        CHECK(memcmp(of_batch + first, importances + first, count * sizeof *importances) == 0);
    }
    return status;
}

// Choices by importances: those of lights, or any numbers. Gives the status of the choice.
static uint32_t use_lights(unsigned long *chosen) {
    const size_t count = one_of(MOST_LIGHTS + 1), first = MOST_LIGHTS - count;
    uint32_t status = weigh_lights(count);
    if (status || one_of(2)) {
        for (size_t i = first; i < MOST_LIGHTS; ++i) {
            importances[i] = some_number();
        }
        CALL(status, total, spherecap_total(importances + first, count, total));
        CHECK(status == SPHERECAP_STATUS_OK && total->lit <= count);
        CHECK(0.0f <= total->sum && total->sum <= FLT_MAX);
    }
    const float even = one_of(4) ? unit_number() : some_number();
    const uint32_t expected = 0.0f <= even && even <= 1.0f ? SPHERECAP_STATUS_OK : SPHERECAP_STATUS_EVEN;
    CALL(status, choice, spherecap_choose(importances + first, count, total, even, random_number(), choice));
    CHECK(status == expected);
    if (total->lit == 0) {
        CHECK(choice->index == 0 && choice->probability == 0.0f);
    } else if (status == SPHERECAP_STATUS_OK) {
        ++*chosen;
        CHECK(choice->index < count && is_in_unit_interval(choice->rest));
        const float importance = importances[first + choice->index];
        CHECK(importance > 0.0f && choice->probability <= 1.0f + FLT_EPSILON);
        CHECK(0.0f < choice->probability);
        CALL(status, probability, spherecap_choice_probability(importance, total, even, probability));
        CHECK(memcmp(probability, &choice->probability, sizeof *probability) == 0);
    }
    const float any = count == 0 ? 0.0f : importances[first + one_of((unsigned)count)];
    CALL(status, probability, spherecap_choice_probability(any, total, even, probability));
    CHECK(status == expected && 0.0f <= *probability && *probability <= 1.0f + FLT_EPSILON);

    // A total that belongs to no importances: no value is promised, only that the calls return.
    const spherecap_total_t wrong = {any_number(), (uint32_t)random_bits()};
    CALL(status, choice,
         spherecap_choose(importances + first, count, &wrong, unit_number(), random_number(), choice));
    CHECK(count == 0 ? choice->index == 0 : choice->index < count);
    CALL(status, probability, spherecap_choice_probability(some_number(), &wrong, even, probability));
    return expected;
}

int main(int count, char **arguments) {
    const unsigned long trials = count > 1 ? strtoul(arguments[1], NULL, 10) : 400000;
    unsigned long met[SPHERECAP_STATUS_DIRECTION + 1] = {0};
    unsigned long chosen = 0, uneven = 0;
    allocate();
    allocate_lights();
    for (unsigned long trial = 0; trial < trials; ++trial) {
        state = trial << 32; // a failing trial can be repeated alone
        const uint32_t status = prepare();
        ++met[status];
        use(status);
        use_overwritten();
        uneven += use_lights(&chosen) == SPHERECAP_STATUS_EVEN;
    }
    // Trials that meet nothing test nothing.
    for (uint32_t status = 0; status <= SPHERECAP_STATUS_RADIUS; ++status) {
        printf("%lu of %lu: %s\n", met[status], trials, spherecap_status_message(status));
        CHECK(status == SPHERECAP_STATUS_NULL_POINTER || met[status] * 1000 > trials);
    }
    CHECK(met[SPHERECAP_STATUS_OK] * 4 > trials);
    printf("%lu of %lu: one of several lights was chosen\n", chosen, trials);
    CHECK(chosen * 2 > trials && uneven * 100 > trials);
    return 0;
}
