// The light that a floor gets from a sphere of radiance 10: one sample is as good as many.
#include <spherecap.h>
#include <stdio.h>

int main(void) {
    const spherecap_receiver_t floor = {
        {0, 0, 1}, SPHERECAP_TECHNIQUE_PROJECTED, SPHERECAP_HEMISPHERES_FRONT, 0};
    const float centre[3] = {3, 0, 0.5f}, radius = 1, radiance = 10; // the horizon cuts this light
    spherecap_sampler_t sampler;
    spherecap_sample_t sample;
    uint32_t status = spherecap_prepare(&floor, centre, radius, &sampler);
    if (status == SPHERECAP_STATUS_OK)
        status = spherecap_sample(&sampler, 0.25f, 0.75f, &sample);
    if (status == SPHERECAP_STATUS_OK)
        printf("irradiance %.4f\n", radiance * sample.offset.cosine / sample.density.solid_angle);
    else
        puts(spherecap_status_message(status));
    return (int)status;
}
