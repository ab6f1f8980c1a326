// Runs the functions of the inline header on what it reads, and writes what they give; compiled as C and as
// C++. It is linked with no library of this project. A record is the form, normal, centre, radius, defensive
// fraction, two random numbers, a direction and a strength.

#include "spherecap_inline.h"

#include <stdio.h>
#include <string.h>

typedef spherecap_inline_sample sample_t;

static void put(float *out, bool is_sampled, float solid_angle, float projected_solid_angle,
                const sample_t *sample, const float *rest) {
    out[0] = is_sampled ? 1.0f : 0.0f;
    out[1] = solid_angle;
    out[2] = projected_solid_angle;
    memcpy(out + 3, sample, 10 * sizeof *out);
    memcpy(out + 13, rest, 3 * sizeof *out);
}

int main(void) {
    float in[15], out[16];
    while (fread(in, sizeof in, 1, stdin) == 1) {
        const float *normal = in + 1, *centre = in + 4, *direction = in + 11;
        const float radius = in[7], defensive = in[8], u0 = in[9], u1 = in[10], strength = in[14];
        sample_t sample, once;
        float rest[3];
        if (in[0] == 0.0f) {
            const spherecap_inline_surface_light light =
                spherecap_inline_surface_prepare(normal, centre, radius);
            sample = spherecap_inline_surface_sample(&light, u0, u1);
            once = spherecap_inline_surface_sample_once(normal, centre, radius, u0, u1);
            rest[0] = spherecap_inline_surface_pdf_direction(&light, direction);
            rest[1] = spherecap_inline_surface_pdf_on_sphere(&light, direction);
            rest[2] = spherecap_inline_surface_importance(normal, centre, radius, strength);
            put(out, light.is_sampled, light.solid_angle, light.projected_solid_angle, &sample, rest);
        } else if (in[0] == 1.0f) {
            const spherecap_inline_front_light light =
                spherecap_inline_front_prepare(normal, centre, radius, defensive);
            sample = spherecap_inline_front_sample(&light, u0, u1);
            once = spherecap_inline_front_sample_once(normal, centre, radius, defensive, u0, u1);
            rest[0] = spherecap_inline_front_pdf_direction(&light, direction);
            rest[1] = spherecap_inline_front_pdf_on_sphere(&light, direction);
            rest[2] = spherecap_inline_front_importance(normal, centre, radius, defensive, strength);
            put(out, light.is_sampled, light.solid_angle, light.projected_solid_angle, &sample, rest);
        } else {
            const spherecap_inline_both_light light =
                spherecap_inline_both_prepare(normal, centre, radius, defensive);
            sample = spherecap_inline_both_sample(&light, u0, u1);
            once = spherecap_inline_both_sample_once(normal, centre, radius, defensive, u0, u1);
            rest[0] = spherecap_inline_both_pdf_direction(&light, direction);
            rest[1] = spherecap_inline_both_pdf_on_sphere(&light, direction);
            rest[2] = spherecap_inline_both_importance(normal, centre, radius, defensive, strength);
            put(out, light.is_sampled, light.solid_angle, light.projected_solid_angle, &sample, rest);
        }
        if (memcmp(&sample, &once, sizeof sample) != 0) {
            fprintf(stderr, "prepared at once, a sample has other bits\n");
            return 1;
        }
        if (fwrite(out, sizeof out, 1, stdout) != 1) {
            return 1;
        }
    }
    return 0;
}
