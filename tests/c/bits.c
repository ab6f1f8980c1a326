// Prepares, samples and evaluates what it reads, and prints the bits of all results, for `tests/c_abi.rs` to
// compare with what Rust gives. In single precision; `bits_f64.c` is the same in double precision.
//
// A line in, all words hexadecimal, numbers as their bits: technique, hemispheres, defensive, normal, centre,
// radius, u0, u1. A line out: "ok" and the bits; or the message of the status that the preparation ended
// with. With the argument "flush", subnormal numbers are flushed to zero.

#include "spherecap.h"

#include "check.h"

#include <inttypes.h>

#ifdef DOUBLE_PRECISION
typedef double number_t;
typedef uint64_t bits_t;
#define NUMBER_BITS PRIx64
#define NUMBER_WORD SCNx64
#define NUMBER_DIGITS "16"
#define OF_PRECISION(name) name##_f64
#define TYPE(name) spherecap_##name##_f64_t
#else
typedef float number_t;
typedef uint32_t bits_t;
#define NUMBER_BITS PRIx32
#define NUMBER_WORD SCNx32
#define NUMBER_DIGITS "8"
#define OF_PRECISION(name) name
#define TYPE(name) spherecap_##name##_t
#endif

enum { WORDS_IN = 12 };

static number_t as_number(bits_t bits) {
    number_t number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static int read_words(bits_t words[WORDS_IN]) {
    for (int i = 0; i < WORDS_IN; ++i) {
        if (scanf("%" NUMBER_WORD, &words[i]) != 1) {
            CHECK(i == 0 && feof(stdin));
            return 0;
        }
    }
    return 1;
}

static void print_bits(const void *memory, size_t size) {
    for (size_t i = 0; i < size; i += sizeof(bits_t)) {
        bits_t bits;
        memcpy(&bits, (const char *)memory + i, sizeof bits);
        printf(" %0" NUMBER_DIGITS NUMBER_BITS, bits);
    }
}

int main(int count, char **arguments) {
    choose_mode(count, arguments);
    bits_t words[WORDS_IN];
    while (read_words(words)) {
        number_t in[WORDS_IN];
        for (int i = 0; i < WORDS_IN; ++i) {
            in[i] = as_number(words[i]);
        }
        const TYPE(receiver)
            receiver = {{in[3], in[4], in[5]}, (uint32_t)words[0], (uint32_t)words[1], in[2]};
        TYPE(sampler) sampler;
        TYPE(sample) once;
        const uint32_t status = OF_PRECISION(spherecap_prepare)(&receiver, in + 6, in[9], &sampler);
        CHECK(OF_PRECISION(spherecap_sample_once)(&receiver, in + 6, in[9], in[10], in[11], &once) == status);
        if (status != SPHERECAP_STATUS_OK) {
            puts(spherecap_status_message(status));
            continue;
        }
        TYPE(sample) sample;
        TYPE(density) density, of_direction, on_sphere, on_sphere_once;
        number_t u[2], solid_angle, projected_solid_angle, bound;
        CHECK(OF_PRECISION(spherecap_sample)(&sampler, in[10], in[11], &sample) == SPHERECAP_STATUS_OK);
        CHECK(memcmp(&once, &sample, sizeof once) == 0);
        CHECK(OF_PRECISION(spherecap_pdf)(&sampler, &sample.offset, &density) == SPHERECAP_STATUS_OK);
        CHECK(OF_PRECISION(spherecap_pdf_direction)(&sampler, sample.direction, &of_direction) ==
              SPHERECAP_STATUS_OK);
        CHECK(OF_PRECISION(spherecap_pdf_on_sphere)(&sampler, sample.direction, &on_sphere) ==
              SPHERECAP_STATUS_OK);
        CHECK(OF_PRECISION(spherecap_pdf_once)(&receiver, in + 6, in[9], sample.direction, &on_sphere_once) ==
              SPHERECAP_STATUS_OK);
        CHECK(memcmp(&on_sphere_once, &on_sphere, sizeof on_sphere) == 0);
        CHECK(OF_PRECISION(spherecap_invert)(&sampler, &sample.offset, u) == SPHERECAP_STATUS_OK);
        CHECK(OF_PRECISION(spherecap_solid_angle)(&sampler, &solid_angle) == SPHERECAP_STATUS_OK);
        CHECK(OF_PRECISION(spherecap_projected_solid_angle)(&sampler, &projected_solid_angle) ==
              SPHERECAP_STATUS_OK);
        CHECK(OF_PRECISION(spherecap_density_bound)(&sampler, &bound) == SPHERECAP_STATUS_OK);
        printf("ok");
        print_bits(&sample.offset, sizeof sample.offset);
        print_bits(sample.direction, sizeof sample.direction);
        print_bits(&sample.distance, sizeof sample.distance);
        print_bits(sample.normal, sizeof sample.normal);
        print_bits(&sample.density, sizeof sample.density);
        print_bits(&density, sizeof density);
        print_bits(&of_direction, sizeof of_direction);
        print_bits(&on_sphere, sizeof on_sphere);
        print_bits(u, sizeof u);
        print_bits(&solid_angle, sizeof solid_angle);
        print_bits(&projected_solid_angle, sizeof projected_solid_angle);
        print_bits(&bound, sizeof bound);
        printf("\n");
    }
    return 0;
}
