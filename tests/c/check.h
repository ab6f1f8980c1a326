// What the C and C++ test programs share: a check that stops the program, memory that the library cannot
// leave, another mode of floating point, and a preparation by numbers.

#ifndef CHECK_H
#define CHECK_H

#include "spherecap.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#define CHECK(condition)                                                                                     \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition);                          \
            exit(1);                                                                                         \
        }                                                                                                    \
    } while (0)

static inline void fill_with_rubbish(void *memory, size_t size) { memset(memory, 0xa5, size); }

static inline int is_all_zero(const void *memory, size_t size) {
    const unsigned char *bytes = (const unsigned char *)memory;
    for (size_t i = 0; i < size; ++i) {
        if (bytes[i] != 0) {
            return 0;
        }
    }
    return 1;
}

// Memory that ends where an inaccessible page begins. The sanitizers watch only what they compiled, which the
// library is not: here the processor stops it at the first byte that it reads or writes past the end.
static inline void *guarded_memory(size_t size) {
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    CHECK(size <= page);
    char *pages = (char *)mmap(NULL, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    CHECK(pages != (char *)MAP_FAILED);
    CHECK(mprotect(pages + page, page, PROT_NONE) == 0);
    return pages + page - size;
}

// With the argument "flush", flushes subnormal numbers to zero, results and operands.
static inline void choose_mode(int count, char **arguments) {
    if (count > 1 && strcmp(arguments[1], "flush") == 0) {
#if defined(__SSE__)
        _mm_setcsr(_mm_getcsr() | 0x8040);
#else
        CHECK(!"this program knows how to flush for x86-64 alone");
#endif
    }
}

// `spherecap_prepare` with a receiver of these; of none, if there is no normal.
// Prepares a sampler of a sphere.
static inline uint32_t prepare_for(uint32_t technique, uint32_t hemispheres, float defensive,
                                   const float *normal, const float *centre, float radius,
                                   spherecap_sampler_t *sampler) {
    spherecap_receiver_t receiver = {{0.0f, 0.0f, 0.0f}, technique, hemispheres, defensive};
    if (normal != NULL) {
        memcpy(receiver.normal, normal, sizeof receiver.normal);
    }
    const spherecap_receiver_t *given = normal == NULL ? NULL : &receiver;
    const uint32_t status = spherecap_prepare(given, centre, radius, sampler);
    if (sampler == NULL) {
        return status;
    }
    // The calls that keep nothing say the same, with the same bits.
    const float zenith[3] = {0.0f, 0.0f, 1.0f};
    spherecap_sample_t kept, once;
    spherecap_density_t density, density_once;
    CHECK(spherecap_sample(sampler, 0.3f, 0.7f, &kept) == status);
    CHECK(spherecap_sample_once(given, centre, radius, 0.3f, 0.7f, &once) == status);
    CHECK(memcmp(&once, &kept, sizeof once) == 0);
    const float *direction = status == SPHERECAP_STATUS_OK ? kept.direction : zenith;
    CHECK(spherecap_pdf_on_sphere(sampler, direction, &density) == status);
    CHECK(spherecap_pdf_once(given, centre, radius, direction, &density_once) == status);
    CHECK(memcmp(&density_once, &density, sizeof density) == 0);
    return status;
}

#endif
