// One sample by the inline header, in one call with its preparation: what benches/inline.rs counts and times.

#include "spherecap_inline.h"

void sample_once(const float *scene, float u0, float u1, float *result);

void sample_once(const float *scene, float u0, float u1, float *result) {
    const spherecap_inline_sample sample =
        spherecap_inline_surface_sample_once(scene, scene + 3, scene[6], u0, u1);
    result[0] = sample.direction[0];
    result[1] = sample.direction[1];
    result[2] = sample.direction[2];
    result[3] = sample.pdf;
}
