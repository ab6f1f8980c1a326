// Prints a few directions towards a spherical light, as a renderer would sample them.
//
//     cargo build --release
//     cc -Iinclude examples/print_samples.c target/release/libspherecap.a -lpthread -ldl -lm -o print_samples
//     ./print_samples

#include "spherecap.h"

#include <stdio.h>

// Says in words what went wrong, if something did.
static int failed(const char *what, uint32_t status) {
    if (status == SPHERECAP_STATUS_OK) {
        return 0;
    }
    printf("%s: %s.\n", what, spherecap_status_message(status));
    return 1;
}

int main(void) {
    if (spherecap_abi_version() != SPHERECAP_ABI) {
        printf("The header's ABI is %d, the library's %u: rebuild.\n", SPHERECAP_ABI,
               (unsigned)spherecap_abi_version());
        return 1;
    }

    const spherecap_receiver_t floor = {{0.0f, 0.0f, 1.0f}, // its normal
                                        SPHERECAP_TECHNIQUE_PROJECTED,
                                        SPHERECAP_HEMISPHERES_FRONT,
                                        0.0f};
    const float centre[3] = {3.0f, 0.0f, 0.5f}; // of the light, minus the shading point; the horizon cuts it
    spherecap_sampler_t sampler;
    uint32_t status = spherecap_prepare(&floor, centre, 1.0f, &sampler);
    if (failed("prepare", status)) {
        return 1;
    }

    for (int i = 0; i < 8; ++i) {
        const float u0 = ((float)i + 0.5f) / 8.0f, u1 = ((float)(3 * i % 8) + 0.5f) / 8.0f;
        spherecap_sample_t sample;
        if (failed("sample", spherecap_sample(&sampler, u0, u1, &sample))) {
            return 1;
        }
        // What a renderer sums up, for a light of radiance 1. Here all samples agree: there is no noise.
        const float irradiance = sample.offset.cosine / sample.density.solid_angle;
        printf("direction (%f, %f, %f), distance %f, pdf %f, irradiance %f\n", sample.direction[0],
               sample.direction[1], sample.direction[2], sample.distance, sample.density.solid_angle,
               irradiance);
    }

    // Bad input gives a status and samples nothing. So does a light that lights nothing.
    status = spherecap_prepare(&floor, centre, -1.0f, &sampler);
    failed("a radius of -1", status);
    const float below[3] = {3.0f, 0.0f, -2.0f};
    status = spherecap_prepare(&floor, below, 1.0f, &sampler);
    failed("a light below the horizon", status);
    return 0;
}
