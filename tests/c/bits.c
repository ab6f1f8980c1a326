// Prepares, samples and evaluates what it reads, and prints the bits of all results, for `tests/c_abi.rs` to
// compare with what Rust gives.
//
// A line in, all words hexadecimal, floats as their bits: technique, hemispheres, defensive, normal, centre,
// radius, u0, u1. A line out: "ok" and the bits; or the message of the status that the preparation ended
// with.

#include "spherecap.h"

#include "check.h"

enum { WORDS_IN = 12 };

static float as_float(uint32_t bits) {
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static int read_words(uint32_t words[WORDS_IN]) {
    for (int i = 0; i < WORDS_IN; ++i) {
        unsigned word;
        if (scanf("%x", &word) != 1) {
            CHECK(i == 0 && feof(stdin));
            return 0;
        }
        words[i] = word;
    }
    return 1;
}

static void print_bits(const void *memory, size_t size) {
    for (size_t i = 0; i < size; i += sizeof(uint32_t)) {
        uint32_t word;
        memcpy(&word, (const char *)memory + i, sizeof word);
        printf(" %08x", (unsigned)word);
    }
}

int main(void) {
    uint32_t words[WORDS_IN];
    while (read_words(words)) {
        float in[WORDS_IN];
        for (int i = 0; i < WORDS_IN; ++i) {
            in[i] = as_float(words[i]);
        }
        spherecap_cap_t cap;
        const uint32_t status = spherecap_prepare(words[0], words[1], in[2], in + 3, in + 6, in[9], &cap);
        if (status != SPHERECAP_STATUS_OK) {
            puts(spherecap_status_message(status));
            continue;
        }
        spherecap_sample_t sample;
        spherecap_density_t density, of_direction, on_sphere;
        float u[2], solid_angle, projected_solid_angle, bound;
        CHECK(spherecap_sample(&cap, in[10], in[11], &sample) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_pdf(&cap, &sample.offset, &density) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_pdf_direction(&cap, sample.direction, &of_direction) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_pdf_on_sphere(&cap, sample.direction, &on_sphere) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_invert(&cap, &sample.offset, u) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_solid_angle(&cap, &solid_angle) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_projected_solid_angle(&cap, &projected_solid_angle) == SPHERECAP_STATUS_OK);
        CHECK(spherecap_density_bound(&cap, &bound) == SPHERECAP_STATUS_OK);
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
