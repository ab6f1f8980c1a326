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

int main(int count, char **arguments) {
    const unsigned long trials = count > 1 ? strtoul(arguments[1], NULL, 10) : 400000;
    unsigned long met[SPHERECAP_STATUS_DIRECTION + 1] = {0};
    allocate();
    for (unsigned long trial = 0; trial < trials; ++trial) {
        state = trial << 32; // a failing trial can be repeated alone
        const uint32_t status = prepare();
        ++met[status];
        use(status);
        use_overwritten();
    }
    // Trials that meet nothing test nothing.
    for (uint32_t status = 0; status <= SPHERECAP_STATUS_RADIUS; ++status) {
        printf("%lu of %lu: %s\n", met[status], trials, spherecap_status_message(status));
        CHECK(status == SPHERECAP_STATUS_NULL_POINTER || met[status] * 1000 > trials);
    }
    CHECK(met[SPHERECAP_STATUS_OK] * 4 > trials);
    return 0;
}
