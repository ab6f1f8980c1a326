// Run where `SPHERECAP_INSTRUCTIONS` names nothing that the CPU has: every function that computes refuses,
// and stores zeros or nothing.

#include "spherecap.h"

#include "check.h"

static const float zenith[3] = {0.0f, 0.0f, 1.0f};
static const float ahead[3] = {3.0f, 0.0f, 0.5f};

int main(void) {
    const uint32_t expected = SPHERECAP_STATUS_INSTRUCTIONS;
    const char *message = spherecap_status_message(expected);
    CHECK(strstr(message, "SPHERECAP_INSTRUCTIONS") != NULL && strstr(message, "portable") != NULL &&
          strstr(message, "avx2") != NULL && strstr(message, "avx512") != NULL);
    CHECK(strcmp(spherecap_batch_instructions(), "none") == 0);

    spherecap_sampler_t sampler;
    spherecap_sample_t sample;
    spherecap_density_t density;
    float u[2], number;
    fill_with_rubbish(&sample, sizeof sample);
    CHECK(prepare_for(SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0.0f, zenith, ahead, 1.0f,
                      &sampler) == expected);
    CHECK(spherecap_sample(&sampler, 0.5f, 0.5f, &sample) == expected);
    CHECK(is_all_zero(&sample, sizeof sample));
    CHECK(spherecap_pdf(&sampler, &sample.offset, &density) == expected);
    CHECK(spherecap_pdf_direction(&sampler, zenith, &density) == expected);
    CHECK(spherecap_pdf_on_sphere(&sampler, zenith, &density) == expected);
    CHECK(spherecap_invert(&sampler, &sample.offset, u) == expected);
    CHECK(spherecap_solid_angle(&sampler, &number) == expected);
    CHECK(spherecap_projected_solid_angle(&sampler, &number) == expected);
    CHECK(spherecap_density_bound(&sampler, &number) == expected);

    const spherecap_receiver_f64_t receiver = {{0.0, 0.0, 1.0}, 0, 0, 0.0};
    const double centre[3] = {3.0, 0.0, 0.5};
    spherecap_sampler_f64_t double_sampler;
    spherecap_sample_f64_t double_sample;
    CHECK(spherecap_prepare_f64(&receiver, centre, 1.0, &double_sampler) == expected);
    CHECK(spherecap_sample_f64(&double_sampler, 0.5, 0.5, &double_sample) == expected);

    const spherecap_batch_t batch = {0, 0, 0.0f, 0, {NULL, NULL, NULL}, {NULL, NULL, NULL}, NULL};
    const spherecap_batch_random_t random = {NULL, NULL};
    const spherecap_batch_offsets_t offsets = {NULL, NULL, NULL};
    const spherecap_batch_directions_t directions = {NULL, NULL, NULL};
    const spherecap_batch_densities_t densities = {NULL, NULL};
    const spherecap_batch_measures_t measures = {NULL, NULL};
    const spherecap_batch_samples_t samples = {
        {NULL, NULL, NULL}, {NULL, NULL, NULL}, NULL, {NULL, NULL, NULL}, {NULL, NULL}};
    CHECK(spherecap_batch_sample(&batch, &random, &samples, NULL) == expected);
    CHECK(spherecap_sample_many(&sampler, 0, &random, &samples) == expected);
    CHECK(spherecap_batch_pdf(&batch, &offsets, &densities, NULL) == expected);
    CHECK(spherecap_batch_pdf_direction(&batch, &directions, &densities, NULL) == expected);
    CHECK(spherecap_batch_pdf_on_sphere(&batch, &directions, &densities, NULL) == expected);
    CHECK(spherecap_batch_measures(&batch, &measures, NULL) == expected);
    CHECK(spherecap_batch_importances(&batch, NULL, NULL, NULL) == expected);

    const spherecap_receiver_t floor = {{0.0f, 0.0f, 1.0f}, 0, 0, 0.0f};
    const spherecap_lights_t lights = {0, {NULL, NULL, NULL}, NULL, NULL};
    const spherecap_total_t one = {1.0f, 1};
    spherecap_total_t total;
    spherecap_choice_t choice;
    CHECK(spherecap_importances(&floor, zenith, &lights, NULL, &total) == expected);
    CHECK(is_all_zero(&total, sizeof total));
    CHECK(spherecap_total(zenith, 3, &total) == expected);
    CHECK(spherecap_choose(zenith, 3, &one, 0.0f, 0.5f, &choice) == expected);
    CHECK(is_all_zero(&choice, sizeof choice));
    CHECK(spherecap_choice_probability(1.0f, &one, 0.0f, &number) == expected);
    return 0;
}
