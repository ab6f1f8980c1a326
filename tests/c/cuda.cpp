// Runs the functions of shaders/spherecap.cuh as C++, with what they take from CUDA written in C++: what
// tests/c/inline.c does.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#define __device__

struct float3 {
    float x, y, z;
};

static float3 make_float3(float x, float y, float z) { return {x, y, z}; }

static float __fmul_rn(float a, float b) { return a * b; }

static float __fadd_rn(float a, float b) { return a + b; }

static float __fsub_rn(float a, float b) { return a - b; }

static float __fmaf_rn(float a, float b, float c) { return fmaf(a, b, c); }

static int32_t __float_as_int(float a) {
    int32_t bits;
    memcpy(&bits, &a, sizeof bits);
    return bits;
}

static float __int_as_float(int32_t bits) {
    float a;
    memcpy(&a, &bits, sizeof a);
    return a;
}

static float __int2float_rn(int32_t a) { return static_cast<float>(a); }

static int32_t __float2int_rz(float a) { return a >= 0 && a < 2147483648.0f ? static_cast<int32_t>(a) : 0; }

#include "spherecap.cuh"

#define RUN(form, ...)                                                                                       \
    do {                                                                                                     \
        const spherecap_##form##_light light = spherecap_##form##_prepare(__VA_ARGS__);                      \
        const spherecap_sample sampled = spherecap_##form##_sample(light, u0, u1);                           \
        const spherecap_sample once = spherecap_##form##_sample_once(__VA_ARGS__, u0, u1);                   \
        const float rest[] = {spherecap_##form##_pdf_direction(light, direction),                            \
                              spherecap_##form##_pdf_on_sphere(light, direction),                            \
                              spherecap_##form##_importance(__VA_ARGS__, strength)};                         \
        out[0] = light.is_sampled ? 1.0f : 0.0f;                                                             \
        out[1] = light.solid_angle;                                                                          \
        out[2] = light.projected_solid_angle;                                                                \
        memcpy(out + 3, &sampled, sizeof sampled);                                                           \
        memcpy(out + 13, rest, sizeof rest);                                                                 \
        if (memcmp(&sampled, &once, sizeof once) != 0) {                                                     \
            return 1;                                                                                        \
        }                                                                                                    \
    } while (false)

int main() {
    float in[15], out[16];
    while (fread(in, sizeof in, 1, stdin) == 1) {
        const float3 normal = make_float3(in[1], in[2], in[3]), centre = make_float3(in[4], in[5], in[6]);
        const float3 direction = make_float3(in[11], in[12], in[13]);
        const float radius = in[7], defensive = in[8], u0 = in[9], u1 = in[10], strength = in[14];
        if (in[0] == 0) {
            RUN(surface, normal, centre, radius);
        } else if (in[0] == 1) {
            RUN(front, normal, centre, radius, defensive);
        } else {
            RUN(both, normal, centre, radius, defensive);
        }
        if (fwrite(out, sizeof out, 1, stdout) != 1) {
            return 1;
        }
    }
    return 0;
}
