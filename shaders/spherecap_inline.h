#ifndef SPHERECAP_INLINE_H
#define SPHERECAP_INLINE_H

// Samples spherical lights uniformly in projected solid angle. Version 0.1.0 of spherecap, MIT licence.
// After C. Peters and C. Dachsbacher, Sampling Projected Spherical Caps in Real Time (2019). Generated from the
// kernels of the library by `make shaders`: do not edit. docs/source.md and docs/mathematics.md explain.
//
// spherecap_inline_surface_prepare looks at a light from a shading point: normal is the surface's, centre the sphere's
// centre minus the shading point, radius > 0 its radius, all in one unit of length. If is_sampled is false the
// light gives nothing here, or the input is bad; then densities are 0. solid_angle is the light's, and
// projected_solid_angle that above the horizon, in steradians; the other numbers are for the functions.
// spherecap_inline_surface_sample samples a direction by two random numbers in [0, 1]; _sample_once prepares, too.
// spherecap_inline_surface_pdf_direction is the density of a unit direction per steradian, 0 outside the light;
// _pdf_on_sphere is for one that is known to meet it. _importance is what the light gives to the point, to
// choose among lights by, in proportion to strength, its radiance. `surface` can be `front` or `both`, see below.
// C99 or C++11; no library but the math functions of the standard one. Compile with -mfma, or for a processor that has fused
// multiply-adds: without them each is a call. With -ffp-contract=off all results are those of the library to the bit; without it,
// densities are within 3e-7 of them, and of `both`, whose smaller side has what the larger leaves, within 1e-5.

#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "spherecap needs numbers as IEEE 754 has them: compile without -ffast-math, -Ofast or /fp:fast"
#endif

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static inline float spherecap_inline_min(float a, float b)
{
    return a < b ? a : b;
}

static inline float spherecap_inline_max(float a, float b)
{
    return a > b ? a : b;
}

// What rounding took off the product a b.
static inline float spherecap_inline_lost(float a, float b, float product)
{
    return fmaf(a, b, -product);
}

// A number without its sign and its significand.
static inline float spherecap_inline_power_of_two(float a)
{
    uint32_t bits;
    memcpy(&bits, &a, sizeof bits);
    bits &= 0x7f800000u;
    memcpy(&a, &bits, sizeof a);
    return a;
}

// The bits of a number, as a number.
static inline float spherecap_inline_bits(float a)
{
    int32_t bits;
    memcpy(&bits, &a, sizeof bits);
    return (float)bits;
}

// The number of these bits; any number where they are none.
static inline float spherecap_inline_float_of_bits(float a)
{
    const int32_t bits = a >= 0.0f && a < 2147483648.0f ? (int32_t)a : 0;
    memcpy(&a, &bits, sizeof a);
    return a;
}

// A sample.
// direction: Unit direction from the shading point.
// distance: Distance to the sphere along it, in the unit of the centre.
// normal: Unit outward normal of the sphere there.
// cosine: Cosine of the direction with the surface's normal: more precise than their product.
// pdf: Density of the direction, per steradian; 0 if nothing is sampled.
// projected_pdf: The same over |cosine|, but never infinite.
typedef struct spherecap_inline_sample {
    float direction[3];
    float distance;
    float normal[3];
    float cosine;
    float pdf;
    float projected_pdf;
} spherecap_inline_sample;

static inline spherecap_inline_sample spherecap_inline_no_sample()
{
    spherecap_inline_sample sampled;
    sampled.direction[0] = 0.0f;
    sampled.direction[1] = 0.0f;
    sampled.direction[2] = 0.0f;
    sampled.distance = 0.0f;
    sampled.normal[0] = 0.0f;
    sampled.normal[1] = 0.0f;
    sampled.normal[2] = 0.0f;
    sampled.cosine = 0.0f;
    sampled.pdf = 0.0f;
    sampled.projected_pdf = 0.0f;
    return sampled;
}

// A point on a surface that is lit from the front. The normal must be of unit length to single precision.
typedef struct spherecap_inline_surface_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float frame_0_x;
    float frame_0_y;
    float frame_0_z;
    float frame_1_x;
    float frame_1_y;
    float frame_1_z;
    float frame_2_x;
    float frame_2_y;
    float frame_2_z;
    float normal_x;
    float normal_y;
    float normal_z;
    float distance;
    float radius_sin;
    float inv_radius_sin;
    float radius_cos;
    float elevation_sin;
    float elevation_cos;
    float kappa;
    float tau;
    float width;
    float cut;
    float rise;
    float inv_above;
    float crescent_share;
    float inv_rest;
    float beyond;
    float coefficients_0;
    float coefficients_1;
    float coefficients_2;
    float coefficients_3;
    float coefficients_4;
    float coefficients_5;
    float coefficients_6;
} spherecap_inline_surface_light;

static inline spherecap_inline_surface_light spherecap_inline_surface_prepare(const float normal[3], const float centre[3], float radius)
{
    const float t1 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float t2 = spherecap_inline_power_of_two(spherecap_inline_min(t1, 8.5070587e37f));
    const float t3 = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(t2));
    const float t4 = centre[0] * t3;
    const float t5 = centre[1] * t3;
    const float t6 = centre[2] * t3;
    const float t7 = radius * t3;
    const float t8 = t4 * t4;
    const float t9 = t5 * t5;
    const float t10 = t6 * t6;
    const float t11 = t8 + t9;
    const float t12 = t11 - t8;
    const float t13 = t11 + t10;
    const float t14 = t13 - t11;
    const float t15 = spherecap_inline_lost(t4, t4, t8) + spherecap_inline_lost(t5, t5, t9) + spherecap_inline_lost(t6, t6, t10);
    const float t16 = t15 + (t8 - (t11 - t12) + (t9 - t12) + (t11 - (t13 - t14) + (t10 - t14)));
    const float t17 = t7 * t7;
    const float t18 = t13 - t17 + (t16 - spherecap_inline_lost(t7, t7, t17));
    const bool t19 = 0.0f < t18;
    const float t20 = sqrtf(t13);
    const float t21 = 1.0f / t20;
    const float t22 = normal[0] * t4;
    const float t23 = normal[1] * t5;
    const float t24 = normal[2] * t6;
    const float t25 = t22 + t23;
    const float t26 = t25 - t22;
    const float t27 = t25 + t24;
    const float t28 = t27 - t25;
    const float t29 = spherecap_inline_lost(normal[0], t4, t22) + spherecap_inline_lost(normal[1], t5, t23);
    const float t30 = t29 + spherecap_inline_lost(normal[2], t6, t24) + (t22 - (t25 - t26) + (t23 - t26) + (t25 - (t27 - t28) + (t24 - t28)));
    const float t31 = t27 + t30;
    const float t32 = t30 - (t31 - t27);
    const float t33 = t7 - t31 - t32;
    const float t34 = t7 + t31 + t32;
    const float t35 = t33 * t34;
    const bool t36 = 0.0f < t35 && t19;
    const float t37 = normal[2] * t5;
    const float t38 = fmaf(normal[1], t6, -t37) - spherecap_inline_lost(normal[2], t5, t37);
    const float t39 = normal[0] * t6;
    const float t40 = fmaf(normal[2], t4, -t39) - spherecap_inline_lost(normal[0], t6, t39);
    const float t41 = normal[1] * t4;
    const float t42 = fmaf(normal[0], t5, -t41) - spherecap_inline_lost(normal[1], t4, t41);
    const float t43 = fmaf(t38, t38, fmaf(t40, t40, t42 * t42));
    const bool t44 = 9.8607613e-32f < t43;
    const bool t45 = fabsf(t4) < fabsf(t6);
    const float t46 = t45 ? 0.0f : -t5;
    const float t47 = t45 ? -t6 : t4;
    const float t48 = t45 ? t5 : 0.0f;
    const float t49 = sqrtf(spherecap_inline_max(t18, 0.0f));
    const float radius_cos = t49 * t21;
    const float t50 = 1.0f + radius_cos;
    const float t51 = 1.0f / (t7 * t50);
    const float t52 = t51 * t50;
    const float radius_sin = t7 * t21;
    const float inv_radius_sin = t20 * t52;
    const float t53 = sqrtf(t18 + t35);
    const float t54 = sqrtf(t44 ? t43 : fmaf(t46, t46, fmaf(t47, t47, t48 * t48)));
    const float elevation_sin = t31 * t21;
    const float elevation_cos = (t36 ? t53 : t44 ? t54 : 0.0f) * t21;
    const float t55 = fabsf(elevation_sin);
    const float t56 = radius_sin * elevation_cos;
    const float t57 = spherecap_inline_max(fmaf(radius_cos, t55, t56), 9.8607613e-32f);
    const float t58 = 1.0f / (t57 * t54);
    const float t59 = t58 * t54;
    const float t60 = t58 * t57;
    const float frame_2_x = (t44 ? t38 : t46) * t60;
    const float frame_2_y = (t44 ? t40 : t47) * t60;
    const float frame_2_z = (t44 ? t42 : t48) * t60;
    const float frame_0_x = t4 * t21;
    const float frame_0_y = t5 * t21;
    const float frame_0_z = t6 * t21;
    float t_x = 0.0f;
    float t_y = 0.0f;
    float kappa = 0.0f;
    float cut = 0.0f;
    float shape = 0.0f;
    float shape_cut = 0.0f;
    float norm = 0.0f;
    float width = 0.0f;
    float inv_cut_1 = 0.0f;
    float tau = 0.0f;
    float area = 0.0f;
    if (t36) {
        const float t61 = sqrtf(t35);
        const float t62 = t53 + t49;
        const float t63 = 1.0f / (t53 * t62);
        const float t64 = t63 * t62;
        const float t65 = t49 * t64;
        const float t66 = t61 * t64;
        const float t67 = fabsf(t31) * t52;
        const float t68 = t67 * t65;
        const float t69 = t65 - 0.5f;
        const float t70 = t68 - 0.5f;
        const float t71 = t69 * t69;
        const float t72 = t70 * t70;
        const float t73 = fmaf(0.05430631f, t71, 0.080950715f);
        const float t74 = fmaf(t73, t71, 0.1684019f);
        const float t75 = fmaf(t74, t71, 0.32709444f);
        const float t76 = fmaf(t75, t71, 0.5987523f);
        const float t77 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t72, t73), t72, t74), t72, t75), t72, t76);
        const float t78 = fmaf(-0.026061837f, t71, -0.06372378f);
        const float t79 = fmaf(t78, t71, -0.11762552f);
        const float t80 = fmaf(t79, t71, -0.23594604f);
        const float t81 = fmaf(t80, t71, -0.44721135f);
        const float t82 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t72, t78), t72, t79), t72, t80), t72, t81);
        const float t83 = fmaf(t81, t71, -0.7754678f);
        const float t84 = fmaf(t83, t69, fmaf(t76, t71, 0.94559944f));
        const float t85 = fmaf(fmaf(t70, t82, t77), t69 + t70, t83);
        const float t86 = fmaf(t68, t85, t84);
        t_x = t65;
        t_y = t66;
        kappa = t67;
        cut = t68;
        shape = t84;
        shape_cut = fmaf(t68 - t65, t85, t84);
        norm = t86;
        width = t35 * t63;
        inv_cut_1 = t56 * t59;
        tau = t61 * t52;
        area = t66 * t66 * t66 * (spherecap_inline_min(t33, t34) * t52) * t86;
    }
    const float t87 = radius_sin * radius_sin;
    const float t88 = elevation_sin < 0.0f ? area : t87 * t55 * 3.1415927f + area;
    const bool t89 = t19 && 9.8607613e-32f < t87;
    const float distance = t20 * t2;
    const float projected_above = (9.403955e-38f < t88 && t89) ? t88 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t90 = 0.0f < elevation_sin;
    const float t91 = t90 ? inv_above : 0.0f;
    const bool t92 = 0.0f < tau;
    const bool t93 = t90 && t92 && 0.0f < t91;
    const float t94 = t_y * t_y * t_y * shape * t91;
    const float t95 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (!t90 && t92) {
        const float t96 = 1.0f + kappa;
        const float t97 = t96 * shape;
        const float t98 = 1.0f / (norm * t97);
        const float t99 = sqrtf(t98);
        const float t100 = norm * t99;
        const float t101 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t102 = t101 * t101;
        const float t103 = fmaf(fmaf(fmaf(-0.026061837f, t102, -0.06372378f), t102, -0.11762552f), t102, -0.23594604f);
        const float t104 = fmaf(fmaf(fmaf(0.05430631f, t102, 0.080950715f), t102, 0.1684019f), t102, 0.32709444f);
        const float t105 = fmaf(fmaf(fmaf(t103, t102, -0.44721135f), t102, -0.7754678f), t101, fmaf(fmaf(t104, t102, 0.5987523f), t102, 0.94559944f));
        const float t106 = t96 * t105 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t97 * t98);
        const float t107 = fmaf(t106, t97 * t99, -1.0f);
        const float t108 = 1.0f - t106;
        const float t109 = fmaf(fmaf(30.011856f, t107, fmaf(-41.541264f, t108, -37.009792f)), t107, fmaf(77.96775f, t108, 7.470758f));
        const float t110 = fmaf(t109, t107, fmaf(fmaf(-49.13454f, t108, -9.466533f), t108, -1.5877596f));
        const float t111 = fmaf(fmaf(fmaf(15.716111f, t108, 0.0f), t108, 9.961183f), t108, -2.61785f);
        const float t112 = t107 * fmaf(t110, t107, fmaf(t111, t108, 0.8681748f));
        const float t113 = fmaf(fmaf(7.295638f, t107, -7.236236f), t107, fmaf(fmaf(fmaf(-11.4868555f, t108, 0.0f), t108, 0.0f), t108, 3.1255686f));
        const float t114 = fmaf(fmaf(fmaf(13.728438f, t108, -7.981878f), t108, 2.025724f), t108, -0.7334958f);
        const float t115 = t107 * fmaf(t113, t107, t114);
        const float t116 = fmaf(fmaf(fmaf(9.986537f, t108, 25.22195f), t108, 0.0f), t108, -2.9581387f);
        const float t117 = fmaf(fmaf(fmaf(-19.722994f, t108, 4.6594768f), t108, -0.89538246f), t108, 0.5143498f);
        const float t118 = t107 * fmaf(fmaf(fmaf(-23.220068f, t108, 7.332055f), t107, t116), t107, t117);
        const float t119 = fmaf(fmaf(fmaf(1.946617f, t107, -3.077631f), t107, 1.4945927f), t107, -0.24140751f);
        const float t120 = t107 * t119;
        const float t121 = t107 * fmaf(fmaf(0.38173297f, t107, -0.30305624f), t107, 0.05897375f);
        coefficients_0 = t100;
        coefficients_1 = t106 - t100 + t112;
        coefficients_2 = t115 - t112;
        coefficients_3 = t118 - t115;
        coefficients_4 = t120 - t118;
        coefficients_5 = t121 - t120;
        coefficients_6 = -t121;
    }
    const bool t122 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    spherecap_inline_surface_light light;
    light.is_sampled = t122;
    light.solid_angle = t122 ? (t89 ? t87 * (t51 * t7) * 6.2831855f : 0.0f) : 0.0f;
    light.projected_solid_angle = t122 ? projected_above : 0.0f;
    light.frame_0_x = frame_0_x;
    light.frame_0_y = frame_0_y;
    light.frame_0_z = frame_0_z;
    light.frame_1_x = fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1_y = fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1_z = fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
    light.frame_2_x = frame_2_x;
    light.frame_2_y = frame_2_y;
    light.frame_2_z = frame_2_z;
    light.normal_x = normal[0];
    light.normal_y = normal[1];
    light.normal_z = normal[2];
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_inline_max(t35 * (t21 * t21) * t59, -(radius_cos * t55));
    light.inv_above = inv_above;
    light.crescent_share = t93 ? t94 : 0.0f;
    light.inv_rest = t93 ? 1.0f / (1.0f - t94) : 1.0f;
    light.beyond = t93 ? t95 * t95 * t95 * shape_cut : 0.0f;
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

static inline spherecap_inline_sample spherecap_inline_surface_sample(const spherecap_inline_surface_light *light, float u0, float u1)
{
    if (!light->is_sampled) {
        return spherecap_inline_no_sample();
    }
    const float t1 = fabsf(light->elevation_sin);
    const bool t2 = 0.0f < light->elevation_sin;
    const float t3 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t2 && light->crescent_share <= t3;
    const float t6 = 1.0f - t4;
    const float t7 = t4 - t6;
    const float t8 = 4.0f * t4 * t6;
    float t9 = 0.0f;
    float t10 = 0.0f;
    float t11 = 0.0f;
    float t12 = 0.0f;
    if (t5) {
        const float t13 = spherecap_inline_max((t3 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
        const float t14 = spherecap_inline_min(t13, 0.99999994f);
        const float t15 = 3.1415927f - light->beyond;
        const float t16 = fmaf(t14, t15, light->beyond);
        const float t17 = (1.0f - t14) * t15;
        t9 = spherecap_inline_min(t16, t17) * 0.53033006f;
        t10 = 1.0f;
        t11 = 1.0f;
        t12 = t16 - t17;
    } else {
        const float t18 = sqrtf(t8);
        float t19 = 0.0f;
        float t20 = 0.0f;
        float t21 = 0.0f;
        float t22 = 0.0f;
        if (t2) {
            t19 = t18;
            t20 = 1.0f;
            t21 = t3;
            t22 = light->crescent_share;
        } else {
            const float t23 = fmaf(fmaf(light->coefficients_6, t8, light->coefficients_4), t8, light->coefficients_2);
            const float t24 = fmaf(fmaf(light->coefficients_5, t8, light->coefficients_3), t8, light->coefficients_1);
            const float t25 = t18 * fmaf(t24, t18, fmaf(t23, t8, light->coefficients_0));
            const float t26 = sqrtf(fmaf(t7, t7, t25 * t25));
            const float t27 = light->tau * t25;
            t19 = t27;
            t20 = fmaf(t7, t7, t27 * t27);
            t21 = light->width;
            t22 = fmaf(light->kappa, t25, t26) * fmaf(light->cut, t25, t26);
        }
        const float t28 = t21 / t22;
        const float t29 = spherecap_inline_min(spherecap_inline_max(t28, 5.9604645e-8f), 0.99999994f);
        const float t30 = t2 ? light->width : t28;
        const float t31 = t20 * t30;
        const float t32 = t31 * t31;
        const float t33 = fmaf(fmaf(fmaf(-0.00060778117f, t32, -0.0027203285f), t32, -0.10000902f), t31, fmaf(fmaf(1.0676054e-5f, t32, -0.011332183f), t32, 1.0000001f));
        t9 = t2 ? t29 : t3;
        t10 = t30 * t33;
        t11 = t20;
        t12 = t19;
    }
    const float t34 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t9), -0.33333334f, 1419900500.0f));
    const float t35 = fmaf(-(t9 * t34), t34 * t34, 1.0f);
    const float t36 = t35 * t35;
    const float t37 = fmaf(fmaf(fmaf(0.110958695f, t36, 0.14403293f), t36, 0.22222222f), t35, fmaf(fmaf(0.12482853f, t36, 0.17283951f), t36, 0.33333334f));
    const float t38 = t10 * (t9 * fmaf(t34, t35 * t37, t34));
    const float t39 = t38 * t11;
    const float t40 = t39 * t39;
    const float t41 = fmaf(fmaf(fmaf(-0.063446075f, t40, -0.056249518f), t40, 0.0074712755f), t40, 0.09996679f);
    const float t42 = fmaf(fmaf(fmaf(0.022114987f, t40, 0.085662976f), t40, 0.030445365f), t40, 0.03209764f);
    const float t43 = t38 * fmaf(t41, t39, fmaf(t42, t40, 1.0000004f));
    const float t44 = t5 ? spherecap_inline_min(t43, 1.0f) : t43;
    const float t45 = t11 * t44;
    const float t46 = 2.0f - t45;
    const float t47 = t44 * t46;
    const float t48 = sqrtf(t47);
    float t49 = 0.0f;
    float t50 = 0.0f;
    float t51 = 0.0f;
    if (t5) {
        const float t52 = light->radius_sin * light->elevation_cos;
        const float t53 = t12 < 0.0f ? t45 : t46;
        const float t54 = 1.0f - t53;
        const float t55 = t47 * t8;
        const float t56 = spherecap_inline_max(fmaf(t52, t53, -light->rise), 0.0f);
        const float t57 = sqrtf(fmaf(t56, t56, light->radius_sin * light->radius_sin * t55));
        const float t58 = t1 * light->radius_cos;
        const float t59 = fmaf(light->elevation_cos * t54, fmaf(t52, t54, -2.0f * t58), light->radius_sin * t55);
        const float t60 = light->radius_sin * fmaf(light->elevation_cos, t59 / (t57 + t58), -(t1 * t1 * t54));
        t49 = t60;
        t50 = light->radius_sin * t48 * t7;
        t51 = t57;
    } else {
        const float t61 = t48 * t12;
        t49 = fmaf(light->elevation_cos, t61, -((t2 ? t1 : -t1) * (1.0f - t45)));
        t50 = t48 * t7;
        t51 = t61;
    }
    const float t62 = 0.0f < t51 ? light->inv_above : 0.0f;
    const float t63 = fmaf(t49, t49, t50 * t50);
    const float t64 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t63), 0.0f);
    const float t65 = sqrtf(t64);
    const float t66 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t64));
    const float t67 = light->radius_cos * light->radius_cos / (t66 + t65);
    const float t68 = fmaf(light->frame_0_x, t66, fmaf(light->frame_1_x, t49, light->frame_2_x * t50));
    const float t69 = fmaf(light->frame_0_y, t66, fmaf(light->frame_1_y, t49, light->frame_2_y * t50));
    const float t70 = fmaf(light->frame_0_z, t66, fmaf(light->frame_1_z, t49, light->frame_2_z * t50));
    const float t71 = t67 * light->inv_radius_sin;
    const float t72 = -fmaf(t66, t65, t63) * light->inv_radius_sin;
    const float t73 = t71 * t49;
    const float t74 = t71 * t50;
    const float t75 = fmaf(light->frame_0_x, t72, fmaf(light->frame_1_x, t73, light->frame_2_x * t74));
    const float t76 = fmaf(light->frame_0_y, t72, fmaf(light->frame_1_y, t73, light->frame_2_y * t74));
    const float t77 = fmaf(light->frame_0_z, t72, fmaf(light->frame_1_z, t73, light->frame_2_z * t74));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t68;
    sampled.direction[1] = t69;
    sampled.direction[2] = t70;
    sampled.distance = t67 * light->distance;
    sampled.normal[0] = t75;
    sampled.normal[1] = t76;
    sampled.normal[2] = t77;
    sampled.cosine = t51;
    sampled.pdf = t62 * spherecap_inline_min(fabsf(t51), 3.4028235e38f);
    sampled.projected_pdf = t62;
    return sampled;
}

static inline spherecap_inline_sample spherecap_inline_surface_sample_once(const float normal[3], const float centre[3], float radius, float u0, float u1)
{
    const spherecap_inline_surface_light light = spherecap_inline_surface_prepare(normal, centre, radius);
    return spherecap_inline_surface_sample(&light, u0, u1);
}

static inline float spherecap_inline_surface_pdf_direction(const spherecap_inline_surface_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->frame_0_x, direction[0], fmaf(light->frame_0_y, direction[1], light->frame_0_z * direction[2]));
    const float t2 = fmaf(light->frame_1_x, direction[0], fmaf(light->frame_1_y, direction[1], light->frame_1_z * direction[2]));
    const float t3 = fmaf(light->frame_2_x, direction[0], fmaf(light->frame_2_y, direction[1], light->frame_2_z * direction[2]));
    const float t4 = fmaf(light->normal_x, direction[0], fmaf(light->normal_y, direction[1], light->normal_z * direction[2]));
    const bool t5 = t1 < 0.0f;
    const float t6 = t5 ? 1.0f : t2;
    const float t7 = t5 ? 1.0f : t3;
    const float t8 = (0.0f < t4 ? light->inv_above : 0.0f) * spherecap_inline_min(fabsf(t4), 3.4028235e38f);
    const bool t9 = fmaf(t6, t6, t7 * t7) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t10 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t10 && t10 <= 1.002001f) ? (t9 ? t8 : 0.0f) : 0.0f;
}

static inline float spherecap_inline_surface_pdf_on_sphere(const spherecap_inline_surface_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal_x, direction[0], fmaf(light->normal_y, direction[1], light->normal_z * direction[2]));
    const float t2 = (0.0f < t1 ? light->inv_above : 0.0f) * spherecap_inline_min(fabsf(t1), 3.4028235e38f);
    const float t3 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
}

static inline float spherecap_inline_surface_importance(const float normal[3], const float centre[3], float radius, float strength)
{
    const float t1 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float t2 = spherecap_inline_power_of_two(spherecap_inline_min(t1, 8.5070587e37f));
    const float t3 = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(t2));
    const float t4 = centre[0] * t3;
    const float t5 = centre[1] * t3;
    const float t6 = centre[2] * t3;
    const float t7 = radius * t3;
    const float t8 = sqrtf(fmaf(t4, t4, fmaf(t5, t5, t6 * t6)));
    const float t9 = 1.0f / t8;
    const float t10 = t7 * t9;
    const float t11 = t10 * t10;
    const bool t12 = 0.0f < radius && t8 * t2 <= 3.4028235e38f && 0.0f < strength && strength <= 3.4028235e38f;
    const float t13 = fmaf(normal[0], t4, fmaf(normal[1], t5, normal[2] * t6));
    const float t14 = fmaf(t13, t9, 2.3841858e-7f);
    const float t15 = fmaf(t13 + t7, t9, 2.3841858e-7f);
    const float t16 = fmaf(t10 - t14, spherecap_inline_max(fmaf(-t11, t11, 0.9999981f), 0.0f), t15);
    const float t17 = t10 <= t14 ? t14 : 0.0f < t15 ? t15 * t15 / (t16 * 2.0f) : 0.0f;
    const float t18 = fmaf(0.0f, 0.5f - t17, t17);
    const float t19 = spherecap_inline_min(spherecap_inline_max(t11 * t18 * strength, 1.1754944e-38f), 3.4028235e38f);
    const float t20 = (t11 <= 1.0000019f && 4.9303807e-32f < t11 && t12 && 0.0f < t18) ? t19 : 0.0f;
    return t20;
}


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with the normal.
typedef struct spherecap_inline_front_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float frame_0_x;
    float frame_0_y;
    float frame_0_z;
    float frame_1_x;
    float frame_1_y;
    float frame_1_z;
    float frame_2_x;
    float frame_2_y;
    float frame_2_z;
    float normal_x;
    float normal_y;
    float normal_z;
    float distance;
    float radius_sin;
    float inv_radius_sin;
    float radius_cos;
    float elevation_sin;
    float elevation_cos;
    float inv_solid_angle;
    float kappa;
    float tau;
    float width;
    float cut;
    float rise;
    float defensive;
    float requested;
    float inv_above;
    float crescent_share;
    float inv_rest;
    float beyond;
    float coefficients_0;
    float coefficients_1;
    float coefficients_2;
    float coefficients_3;
    float coefficients_4;
    float coefficients_5;
    float coefficients_6;
} spherecap_inline_front_light;

static inline spherecap_inline_front_light spherecap_inline_front_prepare(const float normal[3], const float centre[3], float radius, float defensive)
{
    const float t1 = fmaf(normal[0], normal[0], fmaf(normal[1], normal[1], normal[2] * normal[2]));
    float normal_x = 0.0f;
    float normal_y = 0.0f;
    float normal_z = 0.0f;
    if (fabsf(t1 - 1.0f) <= 4.7683716e-7f) {
        normal_x = normal[0];
        normal_y = normal[1];
        normal_z = normal[2];
    } else {
        const float t2 = spherecap_inline_max(fabsf(normal[0]) + fabsf(normal[1]) + fabsf(normal[2]), 1.1754944e-38f);
        const float t3 = spherecap_inline_power_of_two(spherecap_inline_min(t2, 8.5070587e37f));
        const float t4 = normal[0] / t3;
        const float t5 = normal[1] / t3;
        const float t6 = normal[2] / t3;
        const float t7 = spherecap_inline_max(sqrtf(fmaf(t4, t4, fmaf(t5, t5, t6 * t6))), 1.1754944e-38f);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    const float t8 = fmaf(normal_x, normal_x, fmaf(normal_y, normal_y, normal_z * normal_z));
    const float t9 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float t10 = spherecap_inline_power_of_two(spherecap_inline_min(t9, 8.5070587e37f));
    const float t11 = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(t10));
    const float t12 = centre[0] * t11;
    const float t13 = centre[1] * t11;
    const float t14 = centre[2] * t11;
    const float t15 = radius * t11;
    const float t16 = t12 * t12;
    const float t17 = t13 * t13;
    const float t18 = t14 * t14;
    const float t19 = t16 + t17;
    const float t20 = t19 - t16;
    const float t21 = t19 + t18;
    const float t22 = t21 - t19;
    const float t23 = spherecap_inline_lost(t12, t12, t16) + spherecap_inline_lost(t13, t13, t17);
    const float t24 = t23 + spherecap_inline_lost(t14, t14, t18) + (t16 - (t19 - t20) + (t17 - t20) + (t19 - (t21 - t22) + (t18 - t22)));
    const float t25 = t15 * t15;
    const float t26 = t21 - t25 + (t24 - spherecap_inline_lost(t15, t15, t25));
    const bool t27 = 0.0f < t26;
    const float t28 = sqrtf(t21);
    const float t29 = 1.0f / t28;
    const float t30 = normal_x * t12;
    const float t31 = normal_y * t13;
    const float t32 = normal_z * t14;
    const float t33 = t30 + t31;
    const float t34 = t33 - t30;
    const float t35 = t33 + t32;
    const float t36 = t35 - t33;
    const float t37 = spherecap_inline_lost(normal_x, t12, t30) + spherecap_inline_lost(normal_y, t13, t31);
    const float t38 = t37 + spherecap_inline_lost(normal_z, t14, t32) + (t30 - (t33 - t34) + (t31 - t34) + (t33 - (t35 - t36) + (t32 - t36)));
    const float t39 = t35 + t38;
    const float t40 = t38 - (t39 - t35);
    const float t41 = t15 - t39 - t40;
    const float t42 = t15 + t39 + t40;
    const float t43 = t41 * t42;
    const bool t44 = 0.0f < t8;
    const bool t45 = 0.0f < t43 && t27 && t44;
    const float t46 = normal_z * t13;
    const float t47 = fmaf(normal_y, t14, -t46) - spherecap_inline_lost(normal_z, t13, t46);
    const float t48 = normal_x * t14;
    const float t49 = fmaf(normal_z, t12, -t48) - spherecap_inline_lost(normal_x, t14, t48);
    const float t50 = normal_y * t12;
    const float t51 = fmaf(normal_x, t13, -t50) - spherecap_inline_lost(normal_y, t12, t50);
    const float t52 = fmaf(t47, t47, fmaf(t49, t49, t51 * t51));
    const bool t53 = 9.8607613e-32f < t52;
    const bool t54 = fabsf(t12) < fabsf(t14);
    const float t55 = t54 ? 0.0f : -t13;
    const float t56 = t54 ? -t14 : t12;
    const float t57 = t54 ? t13 : 0.0f;
    const float t58 = sqrtf(spherecap_inline_max(t26, 0.0f));
    const float radius_cos = t58 * t29;
    const float t59 = 1.0f + radius_cos;
    const float t60 = 1.0f / (t15 * t59);
    const float t61 = t60 * t59;
    const float radius_sin = t15 * t29;
    const float inv_radius_sin = t28 * t61;
    const float t62 = sqrtf(t26 + t43);
    const float t63 = sqrtf(t53 ? t52 : fmaf(t55, t55, fmaf(t56, t56, t57 * t57)));
    const float elevation_sin = t39 * t29;
    const float elevation_cos = (t45 ? t62 : t53 ? t63 : 0.0f) * t29;
    const float t64 = fabsf(elevation_sin);
    const float t65 = radius_sin * elevation_cos;
    const float t66 = spherecap_inline_max(fmaf(radius_cos, t64, t65), 9.8607613e-32f);
    const float t67 = 1.0f / (t66 * t63);
    const float t68 = t67 * t63;
    const float t69 = t67 * t66;
    const float frame_2_x = (t53 ? t47 : t55) * t69;
    const float frame_2_y = (t53 ? t49 : t56) * t69;
    const float frame_2_z = (t53 ? t51 : t57) * t69;
    const float frame_0_x = t12 * t29;
    const float frame_0_y = t13 * t29;
    const float frame_0_z = t14 * t29;
    float t_x = 0.0f;
    float t_y = 0.0f;
    float kappa = 0.0f;
    float cut = 0.0f;
    float shape = 0.0f;
    float shape_cut = 0.0f;
    float norm = 0.0f;
    float width = 0.0f;
    float inv_cut_1 = 0.0f;
    float tau = 0.0f;
    float area = 0.0f;
    if (t45) {
        const float t70 = sqrtf(t43);
        const float t71 = t62 + t58;
        const float t72 = 1.0f / (t62 * t71);
        const float t73 = t72 * t71;
        const float t74 = t58 * t73;
        const float t75 = t70 * t73;
        const float t76 = fabsf(t39) * t61;
        const float t77 = t76 * t74;
        const float t78 = t74 - 0.5f;
        const float t79 = t77 - 0.5f;
        const float t80 = t78 * t78;
        const float t81 = t79 * t79;
        const float t82 = fmaf(0.05430631f, t80, 0.080950715f);
        const float t83 = fmaf(t82, t80, 0.1684019f);
        const float t84 = fmaf(t83, t80, 0.32709444f);
        const float t85 = fmaf(t84, t80, 0.5987523f);
        const float t86 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t81, t82), t81, t83), t81, t84), t81, t85);
        const float t87 = fmaf(-0.026061837f, t80, -0.06372378f);
        const float t88 = fmaf(t87, t80, -0.11762552f);
        const float t89 = fmaf(t88, t80, -0.23594604f);
        const float t90 = fmaf(t89, t80, -0.44721135f);
        const float t91 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t81, t87), t81, t88), t81, t89), t81, t90);
        const float t92 = fmaf(t90, t80, -0.7754678f);
        const float t93 = fmaf(t92, t78, fmaf(t85, t80, 0.94559944f));
        const float t94 = fmaf(fmaf(t79, t91, t86), t78 + t79, t92);
        const float t95 = fmaf(t77, t94, t93);
        t_x = t74;
        t_y = t75;
        kappa = t76;
        cut = t77;
        shape = t93;
        shape_cut = fmaf(t77 - t74, t94, t93);
        norm = t95;
        width = t43 * t72;
        inv_cut_1 = t65 * t68;
        tau = t70 * t61;
        area = t75 * t75 * t75 * (spherecap_inline_min(t41, t42) * t61) * t95;
    }
    const float t96 = radius_sin * radius_sin;
    const float t97 = elevation_sin < 0.0f ? area : t96 * t64 * 3.1415927f + area;
    const bool t98 = t27 && 9.8607613e-32f < t96;
    const float distance = t28 * t10;
    const float solid_angle = t98 ? t96 * (t60 * t15) * 6.2831855f : 0.0f;
    const float projected_above = (9.403955e-38f < t97 && t98) ? t97 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t99 = 0.0f < inv_above;
    const bool t100 = 0.0f < elevation_sin;
    const float t101 = t100 ? inv_above : 0.0f;
    const float t102 = t99 ? defensive : 0.0f < defensive || !t44 ? 1.0f : 0.0f;
    const bool t103 = 0.0f < tau;
    const bool t104 = t100 && t103 && 0.0f < t101;
    const float t105 = t_y * t_y * t_y * shape * t101;
    const float t106 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (!t100 && t103) {
        const float t107 = 1.0f + kappa;
        const float t108 = t107 * shape;
        const float t109 = 1.0f / (norm * t108);
        const float t110 = sqrtf(t109);
        const float t111 = norm * t110;
        const float t112 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t113 = t112 * t112;
        const float t114 = fmaf(fmaf(fmaf(-0.026061837f, t113, -0.06372378f), t113, -0.11762552f), t113, -0.23594604f);
        const float t115 = fmaf(fmaf(fmaf(0.05430631f, t113, 0.080950715f), t113, 0.1684019f), t113, 0.32709444f);
        const float t116 = fmaf(fmaf(fmaf(t114, t113, -0.44721135f), t113, -0.7754678f), t112, fmaf(fmaf(t115, t113, 0.5987523f), t113, 0.94559944f));
        const float t117 = t107 * t116 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t108 * t109);
        const float t118 = fmaf(t117, t108 * t110, -1.0f);
        const float t119 = 1.0f - t117;
        const float t120 = fmaf(fmaf(30.011856f, t118, fmaf(-41.541264f, t119, -37.009792f)), t118, fmaf(77.96775f, t119, 7.470758f));
        const float t121 = fmaf(t120, t118, fmaf(fmaf(-49.13454f, t119, -9.466533f), t119, -1.5877596f));
        const float t122 = fmaf(fmaf(fmaf(15.716111f, t119, 0.0f), t119, 9.961183f), t119, -2.61785f);
        const float t123 = t118 * fmaf(t121, t118, fmaf(t122, t119, 0.8681748f));
        const float t124 = fmaf(fmaf(7.295638f, t118, -7.236236f), t118, fmaf(fmaf(fmaf(-11.4868555f, t119, 0.0f), t119, 0.0f), t119, 3.1255686f));
        const float t125 = fmaf(fmaf(fmaf(13.728438f, t119, -7.981878f), t119, 2.025724f), t119, -0.7334958f);
        const float t126 = t118 * fmaf(t124, t118, t125);
        const float t127 = fmaf(fmaf(fmaf(9.986537f, t119, 25.22195f), t119, 0.0f), t119, -2.9581387f);
        const float t128 = fmaf(fmaf(fmaf(-19.722994f, t119, 4.6594768f), t119, -0.89538246f), t119, 0.5143498f);
        const float t129 = t118 * fmaf(fmaf(fmaf(-23.220068f, t119, 7.332055f), t118, t127), t118, t128);
        const float t130 = fmaf(fmaf(fmaf(1.946617f, t118, -3.077631f), t118, 1.4945927f), t118, -0.24140751f);
        const float t131 = t118 * t130;
        const float t132 = t118 * fmaf(fmaf(0.38173297f, t118, -0.30305624f), t118, 0.05897375f);
        coefficients_0 = t111;
        coefficients_1 = t117 - t111 + t123;
        coefficients_2 = t126 - t123;
        coefficients_3 = t129 - t126;
        coefficients_4 = t131 - t129;
        coefficients_5 = t132 - t131;
        coefficients_6 = -t132;
    }
    const bool t133 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f;
    const bool t134 = t133 && (t99 || (0.0f < t102 && 0.0f < solid_angle));
    spherecap_inline_front_light light;
    light.is_sampled = t134;
    light.solid_angle = t134 ? solid_angle : 0.0f;
    light.projected_solid_angle = t134 ? projected_above : 0.0f;
    light.frame_0_x = frame_0_x;
    light.frame_0_y = frame_0_y;
    light.frame_0_z = frame_0_z;
    light.frame_1_x = fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1_y = fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1_z = fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
    light.frame_2_x = frame_2_x;
    light.frame_2_y = frame_2_y;
    light.frame_2_z = frame_2_z;
    light.normal_x = normal_x;
    light.normal_y = normal_y;
    light.normal_z = normal_z;
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = t98 ? t59 * (inv_radius_sin * inv_radius_sin) * 0.15915494f : 0.0f;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_inline_max(t43 * (t29 * t29) * t68, -(radius_cos * t64));
    light.defensive = t102;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.crescent_share = t104 ? t105 : 0.0f;
    light.inv_rest = t104 ? 1.0f / (1.0f - t105) : 1.0f;
    light.beyond = t104 ? t106 * t106 * t106 * shape_cut : 0.0f;
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

static inline spherecap_inline_sample spherecap_inline_front_sample(const spherecap_inline_front_light *light, float u0, float u1)
{
    if (!light->is_sampled) {
        return spherecap_inline_no_sample();
    }
    const float t1 = fabsf(light->elevation_sin);
    const bool t2 = 0.0f < light->elevation_sin;
    const float t3 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t3 < light->defensive;
    const float t6 = 1.0f - light->defensive;
    const float t7 = spherecap_inline_max((t5 ? t3 : t3 - light->defensive) / (t5 ? light->defensive : t6), 5.9604645e-8f);
    const float t8 = 0.0f < light->requested ? spherecap_inline_min(t7, 0.99999994f) : t3;
    const bool t9 = t5 || (t2 && light->crescent_share <= t8);
    const float t10 = 1.0f - t4;
    const float t11 = t4 - t10;
    const float t12 = 4.0f * t4 * t10;
    float t13 = 0.0f;
    float t14 = 0.0f;
    float t15 = 0.0f;
    float t16 = 0.0f;
    if (t9) {
        const float t17 = spherecap_inline_max((t8 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
        const float t18 = t5 ? t8 : spherecap_inline_min(t17, 0.99999994f);
        const float t19 = t5 ? 0.0f : light->beyond;
        const float t20 = 3.1415927f - t19;
        const float t21 = fmaf(t18, t20, t19);
        const float t22 = (1.0f - t18) * t20;
        t13 = spherecap_inline_min(t21, t22) * 0.53033006f;
        t14 = 1.0f;
        t15 = 1.0f;
        t16 = t21 - t22;
    } else {
        const float t23 = sqrtf(t12);
        float t24 = 0.0f;
        float t25 = 0.0f;
        float t26 = 0.0f;
        float t27 = 0.0f;
        if (t2) {
            t24 = t23;
            t25 = 1.0f;
            t26 = t8;
            t27 = light->crescent_share;
        } else {
            const float t28 = fmaf(fmaf(light->coefficients_6, t12, light->coefficients_4), t12, light->coefficients_2);
            const float t29 = fmaf(fmaf(light->coefficients_5, t12, light->coefficients_3), t12, light->coefficients_1);
            const float t30 = t23 * fmaf(t29, t23, fmaf(t28, t12, light->coefficients_0));
            const float t31 = sqrtf(fmaf(t11, t11, t30 * t30));
            const float t32 = light->tau * t30;
            t24 = t32;
            t25 = fmaf(t11, t11, t32 * t32);
            t26 = light->width;
            t27 = fmaf(light->kappa, t30, t31) * fmaf(light->cut, t30, t31);
        }
        const float t33 = t26 / t27;
        const float t34 = spherecap_inline_min(spherecap_inline_max(t33, 5.9604645e-8f), 0.99999994f);
        const float t35 = t2 ? light->width : t33;
        const float t36 = t25 * t35;
        const float t37 = t36 * t36;
        const float t38 = fmaf(fmaf(fmaf(-0.00060778117f, t37, -0.0027203285f), t37, -0.10000902f), t36, fmaf(fmaf(1.0676054e-5f, t37, -0.011332183f), t37, 1.0000001f));
        t13 = t2 ? t34 : t8;
        t14 = t35 * t38;
        t15 = t25;
        t16 = t24;
    }
    const float t39 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t13), -0.33333334f, 1419900500.0f));
    const float t40 = fmaf(-(t13 * t39), t39 * t39, 1.0f);
    const float t41 = t40 * t40;
    const float t42 = fmaf(fmaf(fmaf(0.110958695f, t41, 0.14403293f), t41, 0.22222222f), t40, fmaf(fmaf(0.12482853f, t41, 0.17283951f), t41, 0.33333334f));
    const float t43 = t14 * (t13 * fmaf(t39, t40 * t42, t39));
    const float t44 = t43 * t15;
    const float t45 = t44 * t44;
    const float t46 = fmaf(fmaf(fmaf(-0.063446075f, t45, -0.056249518f), t45, 0.0074712755f), t45, 0.09996679f);
    const float t47 = fmaf(fmaf(fmaf(0.022114987f, t45, 0.085662976f), t45, 0.030445365f), t45, 0.03209764f);
    const float t48 = t43 * fmaf(t46, t44, fmaf(t47, t45, 1.0000004f));
    const float t49 = t9 ? spherecap_inline_min(t48, 1.0f) : t48;
    const float t50 = t15 * t49;
    const float t51 = 2.0f - t50;
    const float t52 = t49 * t51;
    const float t53 = sqrtf(t52);
    float t54 = 0.0f;
    float t55 = 0.0f;
    float t56 = 0.0f;
    if (t9) {
        const float t57 = t16 < 0.0f ? t50 : t51;
        float t58 = 0.0f;
        float t59 = 0.0f;
        float t60 = 0.0f;
        if (t5) {
            const float t61 = light->solid_angle * 0.15915494f;
            const float t62 = t61 * (1.0f - t52 * t12);
            const float t63 = sqrtf(t61 * (2.0f - t62));
            const float t64 = (t57 - 1.0f) * t63;
            t58 = t64;
            t59 = t53 * t11 * t63;
            t60 = fmaf(light->elevation_sin, 1.0f - t62, light->elevation_cos * t64);
        } else {
            const float t65 = light->radius_sin * light->elevation_cos;
            const float t66 = 1.0f - t57;
            const float t67 = t52 * t12;
            const float t68 = spherecap_inline_max(fmaf(t65, t57, -light->rise), 0.0f);
            const float t69 = sqrtf(fmaf(t68, t68, light->radius_sin * light->radius_sin * t67));
            const float t70 = t1 * light->radius_cos;
            const float t71 = fmaf(light->elevation_cos * t66, fmaf(t65, t66, -2.0f * t70), light->radius_sin * t67);
            const float t72 = light->radius_sin * fmaf(light->elevation_cos, t71 / (t69 + t70), -(t1 * t1 * t66));
            t58 = t72;
            t59 = light->radius_sin * t53 * t11;
            t60 = t69;
        }
        t54 = t58;
        t55 = t59;
        t56 = t60;
    } else {
        const float t73 = t53 * t16;
        t54 = fmaf(light->elevation_cos, t73, -((t2 ? t1 : -t1) * (1.0f - t50)));
        t55 = t53 * t11;
        t56 = t73;
    }
    const float t74 = spherecap_inline_min(fabsf(t56), 3.4028235e38f);
    const float t75 = 0.0f < t56 ? light->inv_above : 0.0f;
    float t76 = 0.0f;
    float t77 = 0.0f;
    if (0.0f < light->defensive) {
        const float t78 = light->defensive * light->inv_solid_angle;
        const float t79 = spherecap_inline_min(t78 / spherecap_inline_max(t74, 1.1754944e-38f), 3.4028235e38f);
        t76 = fmaf(t75, t6 * t74, t78);
        t77 = spherecap_inline_min(fmaf(t75, t6, t79), 3.4028235e38f);
    } else {
        t76 = t75 * t74;
        t77 = t75;
    }
    const float t80 = fmaf(t54, t54, t55 * t55);
    const float t81 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t80), 0.0f);
    const float t82 = sqrtf(t81);
    const float t83 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t81));
    const float t84 = light->radius_cos * light->radius_cos / (t83 + t82);
    const float t85 = fmaf(light->frame_0_x, t83, fmaf(light->frame_1_x, t54, light->frame_2_x * t55));
    const float t86 = fmaf(light->frame_0_y, t83, fmaf(light->frame_1_y, t54, light->frame_2_y * t55));
    const float t87 = fmaf(light->frame_0_z, t83, fmaf(light->frame_1_z, t54, light->frame_2_z * t55));
    const float t88 = t84 * light->inv_radius_sin;
    const float t89 = -fmaf(t83, t82, t80) * light->inv_radius_sin;
    const float t90 = t88 * t54;
    const float t91 = t88 * t55;
    const float t92 = fmaf(light->frame_0_x, t89, fmaf(light->frame_1_x, t90, light->frame_2_x * t91));
    const float t93 = fmaf(light->frame_0_y, t89, fmaf(light->frame_1_y, t90, light->frame_2_y * t91));
    const float t94 = fmaf(light->frame_0_z, t89, fmaf(light->frame_1_z, t90, light->frame_2_z * t91));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t85;
    sampled.direction[1] = t86;
    sampled.direction[2] = t87;
    sampled.distance = t84 * light->distance;
    sampled.normal[0] = t92;
    sampled.normal[1] = t93;
    sampled.normal[2] = t94;
    sampled.cosine = t56;
    sampled.pdf = t76;
    sampled.projected_pdf = t77;
    return sampled;
}

static inline spherecap_inline_sample spherecap_inline_front_sample_once(const float normal[3], const float centre[3], float radius, float defensive, float u0, float u1)
{
    const spherecap_inline_front_light light = spherecap_inline_front_prepare(normal, centre, radius, defensive);
    return spherecap_inline_front_sample(&light, u0, u1);
}

static inline float spherecap_inline_front_pdf_direction(const spherecap_inline_front_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->frame_0_x, direction[0], fmaf(light->frame_0_y, direction[1], light->frame_0_z * direction[2]));
    const float t2 = fmaf(light->frame_1_x, direction[0], fmaf(light->frame_1_y, direction[1], light->frame_1_z * direction[2]));
    const float t3 = fmaf(light->frame_2_x, direction[0], fmaf(light->frame_2_y, direction[1], light->frame_2_z * direction[2]));
    const float t4 = fmaf(light->normal_x, direction[0], fmaf(light->normal_y, direction[1], light->normal_z * direction[2]));
    const bool t5 = t1 < 0.0f;
    const float t6 = t5 ? 1.0f : t2;
    const float t7 = t5 ? 1.0f : t3;
    const float t8 = spherecap_inline_min(fabsf(t4), 3.4028235e38f);
    const float t9 = 0.0f < t4 ? light->inv_above : 0.0f;
    const float t10 = fmaf(t9, (1.0f - light->defensive) * t8, light->defensive * light->inv_solid_angle);
    const bool t11 = fmaf(t6, t6, t7 * t7) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t12 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t13 = (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? (0.0f < light->defensive ? t10 : t9 * t8) : 0.0f) : 0.0f;
    return t13;
}

static inline float spherecap_inline_front_pdf_on_sphere(const spherecap_inline_front_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal_x, direction[0], fmaf(light->normal_y, direction[1], light->normal_z * direction[2]));
    const float t2 = spherecap_inline_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light->inv_above : 0.0f;
    const float t4 = fmaf(t3, (1.0f - light->defensive) * t2, light->defensive * light->inv_solid_angle);
    const float t5 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light->defensive ? t4 : t3 * t2) : 0.0f;
    return t6;
}

static inline float spherecap_inline_front_importance(const float normal[3], const float centre[3], float radius, float defensive, float strength)
{
    const float t1 = fmaf(normal[0], normal[0], fmaf(normal[1], normal[1], normal[2] * normal[2]));
    float t2 = 0.0f;
    float t3 = 0.0f;
    float t4 = 0.0f;
    if (fabsf(t1 - 1.0f) <= 4.7683716e-7f) {
        t2 = normal[0];
        t3 = normal[1];
        t4 = normal[2];
    } else {
        const float t5 = spherecap_inline_max(fabsf(normal[0]) + fabsf(normal[1]) + fabsf(normal[2]), 1.1754944e-38f);
        const float t6 = spherecap_inline_power_of_two(spherecap_inline_min(t5, 8.5070587e37f));
        const float t7 = normal[0] / t6;
        const float t8 = normal[1] / t6;
        const float t9 = normal[2] / t6;
        const float t10 = spherecap_inline_max(sqrtf(fmaf(t7, t7, fmaf(t8, t8, t9 * t9))), 1.1754944e-38f);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    const float t11 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float t12 = spherecap_inline_power_of_two(spherecap_inline_min(t11, 8.5070587e37f));
    const float t13 = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(t12));
    const float t14 = centre[0] * t13;
    const float t15 = centre[1] * t13;
    const float t16 = centre[2] * t13;
    const float t17 = radius * t13;
    const float t18 = sqrtf(fmaf(t14, t14, fmaf(t15, t15, t16 * t16)));
    const float t19 = 1.0f / t18;
    const float t20 = t17 * t19;
    const float t21 = t20 * t20;
    const float t22 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t23 = 0.0f <= defensive && defensive <= 1.0f && t22 <= 2.0f && 0.0f < radius && t18 * t12 <= 3.4028235e38f;
    const float t24 = fmaf(t2, t14, fmaf(t3, t15, t4 * t16));
    const float t25 = fmaf(t24, t19, 2.3841858e-7f);
    const float t26 = fmaf(t24 + t17, t19, 2.3841858e-7f);
    const float t27 = fmaf(t20 - t25, spherecap_inline_max(fmaf(-t21, t21, 0.9999981f), 0.0f), t26);
    const float t28 = t20 <= t25 ? t25 : 0.0f < t26 ? t26 * t26 / (t27 * 2.0f) : 0.0f;
    const float t29 = t22 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t28, t28);
    const bool t30 = t21 <= 1.0000019f && 4.9303807e-32f < t21 && t23 && 0.0f < strength && strength <= 3.4028235e38f;
    const float t31 = spherecap_inline_min(spherecap_inline_max(t21 * t29 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (t30 && (0.0f < t29 || 0.0f < defensive)) ? t31 : 0.0f;
}


// The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.
typedef struct spherecap_inline_both_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float frame_0_x;
    float frame_0_y;
    float frame_0_z;
    float frame_1_x;
    float frame_1_y;
    float frame_1_z;
    float frame_2_x;
    float frame_2_y;
    float frame_2_z;
    float normal_x;
    float normal_y;
    float normal_z;
    float distance;
    float radius_sin;
    float inv_radius_sin;
    float radius_cos;
    float elevation_sin;
    float elevation_cos;
    float inv_solid_angle;
    float kappa;
    float tau;
    float width;
    float cut;
    float rise;
    float defensive;
    float requested;
    float inv_above;
    float inv_below;
    float share_above;
    float crescent_share;
    float inv_rest;
    float beyond;
    float coefficients_0;
    float coefficients_1;
    float coefficients_2;
    float coefficients_3;
    float coefficients_4;
    float coefficients_5;
    float coefficients_6;
} spherecap_inline_both_light;

static inline spherecap_inline_both_light spherecap_inline_both_prepare(const float normal[3], const float centre[3], float radius, float defensive)
{
    const float t1 = fmaf(normal[0], normal[0], fmaf(normal[1], normal[1], normal[2] * normal[2]));
    float normal_x = 0.0f;
    float normal_y = 0.0f;
    float normal_z = 0.0f;
    if (fabsf(t1 - 1.0f) <= 4.7683716e-7f) {
        normal_x = normal[0];
        normal_y = normal[1];
        normal_z = normal[2];
    } else {
        const float t2 = spherecap_inline_max(fabsf(normal[0]) + fabsf(normal[1]) + fabsf(normal[2]), 1.1754944e-38f);
        const float t3 = spherecap_inline_power_of_two(spherecap_inline_min(t2, 8.5070587e37f));
        const float t4 = normal[0] / t3;
        const float t5 = normal[1] / t3;
        const float t6 = normal[2] / t3;
        const float t7 = spherecap_inline_max(sqrtf(fmaf(t4, t4, fmaf(t5, t5, t6 * t6))), 1.1754944e-38f);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    const float t8 = fmaf(normal_x, normal_x, fmaf(normal_y, normal_y, normal_z * normal_z));
    const float t9 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float t10 = spherecap_inline_power_of_two(spherecap_inline_min(t9, 8.5070587e37f));
    const float t11 = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(t10));
    const float t12 = centre[0] * t11;
    const float t13 = centre[1] * t11;
    const float t14 = centre[2] * t11;
    const float t15 = radius * t11;
    const float t16 = t12 * t12;
    const float t17 = t13 * t13;
    const float t18 = t14 * t14;
    const float t19 = t16 + t17;
    const float t20 = t19 - t16;
    const float t21 = t19 + t18;
    const float t22 = t21 - t19;
    const float t23 = spherecap_inline_lost(t12, t12, t16) + spherecap_inline_lost(t13, t13, t17);
    const float t24 = t23 + spherecap_inline_lost(t14, t14, t18) + (t16 - (t19 - t20) + (t17 - t20) + (t19 - (t21 - t22) + (t18 - t22)));
    const float t25 = t15 * t15;
    const float t26 = t21 - t25 + (t24 - spherecap_inline_lost(t15, t15, t25));
    const bool t27 = 0.0f < t26;
    const float t28 = sqrtf(t21);
    const float t29 = 1.0f / t28;
    const float t30 = normal_x * t12;
    const float t31 = normal_y * t13;
    const float t32 = normal_z * t14;
    const float t33 = t30 + t31;
    const float t34 = t33 - t30;
    const float t35 = t33 + t32;
    const float t36 = t35 - t33;
    const float t37 = spherecap_inline_lost(normal_x, t12, t30) + spherecap_inline_lost(normal_y, t13, t31);
    const float t38 = t37 + spherecap_inline_lost(normal_z, t14, t32) + (t30 - (t33 - t34) + (t31 - t34) + (t33 - (t35 - t36) + (t32 - t36)));
    const float t39 = t35 + t38;
    const float t40 = t38 - (t39 - t35);
    const float t41 = t15 - t39 - t40;
    const float t42 = t15 + t39 + t40;
    const float t43 = t41 * t42;
    const bool t44 = 0.0f < t8;
    const bool t45 = 0.0f < t43 && t27 && t44;
    const float t46 = normal_z * t13;
    const float t47 = fmaf(normal_y, t14, -t46) - spherecap_inline_lost(normal_z, t13, t46);
    const float t48 = normal_x * t14;
    const float t49 = fmaf(normal_z, t12, -t48) - spherecap_inline_lost(normal_x, t14, t48);
    const float t50 = normal_y * t12;
    const float t51 = fmaf(normal_x, t13, -t50) - spherecap_inline_lost(normal_y, t12, t50);
    const float t52 = fmaf(t47, t47, fmaf(t49, t49, t51 * t51));
    const bool t53 = 9.8607613e-32f < t52;
    const bool t54 = fabsf(t12) < fabsf(t14);
    const float t55 = t54 ? 0.0f : -t13;
    const float t56 = t54 ? -t14 : t12;
    const float t57 = t54 ? t13 : 0.0f;
    const float t58 = sqrtf(spherecap_inline_max(t26, 0.0f));
    const float radius_cos = t58 * t29;
    const float t59 = 1.0f + radius_cos;
    const float t60 = 1.0f / (t15 * t59);
    const float t61 = t60 * t59;
    const float radius_sin = t15 * t29;
    const float inv_radius_sin = t28 * t61;
    const float t62 = sqrtf(t26 + t43);
    const float t63 = sqrtf(t53 ? t52 : fmaf(t55, t55, fmaf(t56, t56, t57 * t57)));
    const float elevation_sin = t39 * t29;
    const float elevation_cos = (t45 ? t62 : t53 ? t63 : 0.0f) * t29;
    const float t64 = fabsf(elevation_sin);
    const float t65 = radius_sin * elevation_cos;
    const float t66 = spherecap_inline_max(fmaf(radius_cos, t64, t65), 9.8607613e-32f);
    const float t67 = 1.0f / (t66 * t63);
    const float t68 = t67 * t63;
    const float t69 = t67 * t66;
    const float frame_2_x = (t53 ? t47 : t55) * t69;
    const float frame_2_y = (t53 ? t49 : t56) * t69;
    const float frame_2_z = (t53 ? t51 : t57) * t69;
    const float frame_0_x = t12 * t29;
    const float frame_0_y = t13 * t29;
    const float frame_0_z = t14 * t29;
    float t_x = 0.0f;
    float t_y = 0.0f;
    float kappa = 0.0f;
    float cut = 0.0f;
    float shape = 0.0f;
    float shape_cut = 0.0f;
    float norm = 0.0f;
    float width = 0.0f;
    float inv_cut_1 = 0.0f;
    float tau = 0.0f;
    float area = 0.0f;
    if (t45) {
        const float t70 = sqrtf(t43);
        const float t71 = t62 + t58;
        const float t72 = 1.0f / (t62 * t71);
        const float t73 = t72 * t71;
        const float t74 = t58 * t73;
        const float t75 = t70 * t73;
        const float t76 = fabsf(t39) * t61;
        const float t77 = t76 * t74;
        const float t78 = t74 - 0.5f;
        const float t79 = t77 - 0.5f;
        const float t80 = t78 * t78;
        const float t81 = t79 * t79;
        const float t82 = fmaf(0.05430631f, t80, 0.080950715f);
        const float t83 = fmaf(t82, t80, 0.1684019f);
        const float t84 = fmaf(t83, t80, 0.32709444f);
        const float t85 = fmaf(t84, t80, 0.5987523f);
        const float t86 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t81, t82), t81, t83), t81, t84), t81, t85);
        const float t87 = fmaf(-0.026061837f, t80, -0.06372378f);
        const float t88 = fmaf(t87, t80, -0.11762552f);
        const float t89 = fmaf(t88, t80, -0.23594604f);
        const float t90 = fmaf(t89, t80, -0.44721135f);
        const float t91 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t81, t87), t81, t88), t81, t89), t81, t90);
        const float t92 = fmaf(t90, t80, -0.7754678f);
        const float t93 = fmaf(t92, t78, fmaf(t85, t80, 0.94559944f));
        const float t94 = fmaf(fmaf(t79, t91, t86), t78 + t79, t92);
        const float t95 = fmaf(t77, t94, t93);
        t_x = t74;
        t_y = t75;
        kappa = t76;
        cut = t77;
        shape = t93;
        shape_cut = fmaf(t77 - t74, t94, t93);
        norm = t95;
        width = t43 * t72;
        inv_cut_1 = t65 * t68;
        tau = t70 * t61;
        area = t75 * t75 * t75 * (spherecap_inline_min(t41, t42) * t61) * t95;
    }
    const float t96 = radius_sin * radius_sin;
    const float t97 = t96 * t64 * 3.1415927f + area;
    const bool t98 = elevation_sin < 0.0f;
    const float t99 = t98 ? area : t97;
    const float t100 = t98 ? t97 : area;
    const bool t101 = t27 && 9.8607613e-32f < t96;
    const float distance = t28 * t10;
    const float solid_angle = t101 ? t96 * (t60 * t15) * 6.2831855f : 0.0f;
    const float projected_above = (9.403955e-38f < t99 && t101) ? t99 : 0.0f;
    const float projected_below = (9.403955e-38f < t100 && t101) ? t100 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float inv_below = 0.0f < projected_below ? 1.0f / projected_below : 0.0f;
    const bool t102 = 0.0f < inv_above + inv_below;
    const bool t103 = 0.0f < elevation_sin;
    const float t104 = t103 ? inv_above : inv_below;
    const float t105 = t102 ? defensive : 0.0f < defensive || !t44 ? 1.0f : 0.0f;
    const bool t106 = 0.0f < tau;
    const bool t107 = t106 && 0.0f < t104;
    const float t108 = t_y * t_y * t_y * shape * t104;
    const float t109 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    float t110 = 0.0f;
    if (t106) {
        const float t111 = 1.0f + kappa;
        const float t112 = t111 * shape;
        const float t113 = 1.0f / (norm * t112);
        const float t114 = sqrtf(t113);
        const float t115 = norm * t114;
        const float t116 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t117 = t116 * t116;
        const float t118 = fmaf(fmaf(fmaf(-0.026061837f, t117, -0.06372378f), t117, -0.11762552f), t117, -0.23594604f);
        const float t119 = fmaf(fmaf(fmaf(0.05430631f, t117, 0.080950715f), t117, 0.1684019f), t117, 0.32709444f);
        const float t120 = fmaf(fmaf(fmaf(t118, t117, -0.44721135f), t117, -0.7754678f), t116, fmaf(fmaf(t119, t117, 0.5987523f), t117, 0.94559944f));
        const float t121 = t111 * t120 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t112 * t113);
        const float t122 = fmaf(t121, t112 * t114, -1.0f);
        const float t123 = 1.0f - t121;
        const float t124 = fmaf(fmaf(30.011856f, t122, fmaf(-41.541264f, t123, -37.009792f)), t122, fmaf(77.96775f, t123, 7.470758f));
        const float t125 = fmaf(t124, t122, fmaf(fmaf(-49.13454f, t123, -9.466533f), t123, -1.5877596f));
        const float t126 = fmaf(fmaf(fmaf(15.716111f, t123, 0.0f), t123, 9.961183f), t123, -2.61785f);
        const float t127 = t122 * fmaf(t125, t122, fmaf(t126, t123, 0.8681748f));
        const float t128 = fmaf(fmaf(7.295638f, t122, -7.236236f), t122, fmaf(fmaf(fmaf(-11.4868555f, t123, 0.0f), t123, 0.0f), t123, 3.1255686f));
        const float t129 = fmaf(fmaf(fmaf(13.728438f, t123, -7.981878f), t123, 2.025724f), t123, -0.7334958f);
        const float t130 = t122 * fmaf(t128, t122, t129);
        const float t131 = fmaf(fmaf(fmaf(9.986537f, t123, 25.22195f), t123, 0.0f), t123, -2.9581387f);
        const float t132 = fmaf(fmaf(fmaf(-19.722994f, t123, 4.6594768f), t123, -0.89538246f), t123, 0.5143498f);
        const float t133 = t122 * fmaf(fmaf(fmaf(-23.220068f, t123, 7.332055f), t122, t131), t122, t132);
        const float t134 = fmaf(fmaf(fmaf(1.946617f, t122, -3.077631f), t122, 1.4945927f), t122, -0.24140751f);
        const float t135 = t122 * t134;
        const float t136 = t122 * fmaf(fmaf(0.38173297f, t122, -0.30305624f), t122, 0.05897375f);
        const float t137 = 1.0f / (elevation_cos * elevation_cos);
        const float t138 = tau * tau;
        const float t139 = t138 * t137 / (1.0f + t_x);
        const float t140 = kappa - 0.5f;
        const float t141 = cut - 0.5f;
        const float t142 = t140 * t140;
        const float t143 = t141 * t141;
        const float t144 = fmaf(0.05430631f, t142, 0.080950715f);
        const float t145 = fmaf(t144, t142, 0.1684019f);
        const float t146 = fmaf(t145, t142, 0.32709444f);
        const float t147 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t143, t144), t143, t145), t143, t146), t143, fmaf(t146, t142, 0.5987523f));
        const float t148 = fmaf(-0.026061837f, t142, -0.06372378f);
        const float t149 = fmaf(t148, t142, -0.11762552f);
        const float t150 = fmaf(t149, t142, -0.23594604f);
        const float t151 = fmaf(t150, t142, -0.44721135f);
        const float t152 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t143, t148), t143, t149), t143, t150), t143, t151);
        const float t153 = fmaf(kappa * t139, fmaf(fmaf(t141, t152, t147), t140 + t141, fmaf(t151, t142, -0.7754678f)), fmaf(shape_cut, t139 - kappa * kappa, kappa) * t137);
        const float t154 = spherecap_inline_max(t138 * tau * (radius_cos + 1.0f) * t153 * 0.31830987f, 0.0f);
        coefficients_0 = t115;
        coefficients_1 = t121 - t115 + t127;
        coefficients_2 = t130 - t127;
        coefficients_3 = t133 - t130;
        coefficients_4 = t135 - t133;
        coefficients_5 = t136 - t135;
        coefficients_6 = -t136;
        t110 = spherecap_inline_min(t154, 0.5f);
    }
    const float share_above = 0.0f < inv_below ? (0.0f < inv_above ? (t103 ? 1.0f - t110 : t110) : 0.0f) : 1.0f;
    const bool t155 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f;
    const bool t156 = t155 && (t102 || (0.0f < t105 && 0.0f < solid_angle));
    spherecap_inline_both_light light;
    light.is_sampled = t156;
    light.solid_angle = t156 ? solid_angle : 0.0f;
    light.projected_solid_angle = t156 ? projected_above : 0.0f;
    light.frame_0_x = frame_0_x;
    light.frame_0_y = frame_0_y;
    light.frame_0_z = frame_0_z;
    light.frame_1_x = fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1_y = fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1_z = fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
    light.frame_2_x = frame_2_x;
    light.frame_2_y = frame_2_y;
    light.frame_2_z = frame_2_z;
    light.normal_x = normal_x;
    light.normal_y = normal_y;
    light.normal_z = normal_z;
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = t101 ? t59 * (inv_radius_sin * inv_radius_sin) * 0.15915494f : 0.0f;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_inline_max(t43 * (t29 * t29) * t68, -(radius_cos * t64));
    light.defensive = t105;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
    light.crescent_share = t107 ? t108 : 0.0f;
    light.inv_rest = t107 ? 1.0f / (1.0f - t108) : 1.0f;
    light.beyond = t107 ? t109 * t109 * t109 * shape_cut : 0.0f;
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

static inline spherecap_inline_sample spherecap_inline_both_sample(const spherecap_inline_both_light *light, float u0, float u1)
{
    if (!light->is_sampled) {
        return spherecap_inline_no_sample();
    }
    const float t1 = fabsf(light->elevation_sin);
    const bool t2 = 0.0f < light->elevation_sin;
    const float t3 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t3 < light->defensive;
    const float t6 = 1.0f - light->defensive;
    const float t7 = spherecap_inline_max((t5 ? t3 : t3 - light->defensive) / (t5 ? light->defensive : t6), 5.9604645e-8f);
    const float t8 = 0.0f < light->requested ? spherecap_inline_min(t7, 0.99999994f) : t3;
    const bool t9 = t5 || t8 < light->share_above;
    const float t10 = 1.0f - light->share_above;
    const float t11 = spherecap_inline_max((t9 ? t8 : t8 - light->share_above) / (t9 ? light->share_above : t10), 5.9604645e-8f);
    const bool t12 = (t9 && t2) || (!t9 && !t2);
    const float t13 = t5 ? t8 : spherecap_inline_min(t11, 0.99999994f);
    const bool t14 = t5 || (t12 && light->crescent_share <= t13);
    const float t15 = 1.0f - t4;
    const float t16 = t4 - t15;
    const float t17 = 4.0f * t4 * t15;
    float t18 = 0.0f;
    float t19 = 0.0f;
    float t20 = 0.0f;
    float t21 = 0.0f;
    if (t14) {
        const float t22 = spherecap_inline_max((t13 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
        const float t23 = t5 ? t13 : spherecap_inline_min(t22, 0.99999994f);
        const float t24 = t5 ? 0.0f : light->beyond;
        const float t25 = 3.1415927f - t24;
        const float t26 = fmaf(t23, t25, t24);
        const float t27 = (1.0f - t23) * t25;
        t18 = spherecap_inline_min(t26, t27) * 0.53033006f;
        t19 = 1.0f;
        t20 = 1.0f;
        t21 = t26 - t27;
    } else {
        const float t28 = sqrtf(t17);
        float t29 = 0.0f;
        float t30 = 0.0f;
        float t31 = 0.0f;
        float t32 = 0.0f;
        if (t12) {
            t29 = t28;
            t30 = 1.0f;
            t31 = t13;
            t32 = light->crescent_share;
        } else {
            const float t33 = fmaf(fmaf(light->coefficients_6, t17, light->coefficients_4), t17, light->coefficients_2);
            const float t34 = fmaf(fmaf(light->coefficients_5, t17, light->coefficients_3), t17, light->coefficients_1);
            const float t35 = t28 * fmaf(t34, t28, fmaf(t33, t17, light->coefficients_0));
            const float t36 = sqrtf(fmaf(t16, t16, t35 * t35));
            const float t37 = light->tau * t35;
            t29 = t37;
            t30 = fmaf(t16, t16, t37 * t37);
            t31 = light->width;
            t32 = fmaf(light->kappa, t35, t36) * fmaf(light->cut, t35, t36);
        }
        const float t38 = t31 / t32;
        const float t39 = spherecap_inline_min(spherecap_inline_max(t38, 5.9604645e-8f), 0.99999994f);
        const float t40 = t12 ? light->width : t38;
        const float t41 = t30 * t40;
        const float t42 = t41 * t41;
        const float t43 = fmaf(fmaf(fmaf(-0.00060778117f, t42, -0.0027203285f), t42, -0.10000902f), t41, fmaf(fmaf(1.0676054e-5f, t42, -0.011332183f), t42, 1.0000001f));
        t18 = t12 ? t39 : t13;
        t19 = t40 * t43;
        t20 = t30;
        t21 = t29;
    }
    const float t44 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t18), -0.33333334f, 1419900500.0f));
    const float t45 = fmaf(-(t18 * t44), t44 * t44, 1.0f);
    const float t46 = t45 * t45;
    const float t47 = fmaf(fmaf(fmaf(0.110958695f, t46, 0.14403293f), t46, 0.22222222f), t45, fmaf(fmaf(0.12482853f, t46, 0.17283951f), t46, 0.33333334f));
    const float t48 = t19 * (t18 * fmaf(t44, t45 * t47, t44));
    const float t49 = t48 * t20;
    const float t50 = t49 * t49;
    const float t51 = fmaf(fmaf(fmaf(-0.063446075f, t50, -0.056249518f), t50, 0.0074712755f), t50, 0.09996679f);
    const float t52 = fmaf(fmaf(fmaf(0.022114987f, t50, 0.085662976f), t50, 0.030445365f), t50, 0.03209764f);
    const float t53 = t48 * fmaf(t51, t49, fmaf(t52, t50, 1.0000004f));
    const float t54 = t14 ? spherecap_inline_min(t53, 1.0f) : t53;
    const float t55 = t20 * t54;
    const float t56 = 2.0f - t55;
    const float t57 = t54 * t56;
    const float t58 = sqrtf(t57);
    float t59 = 0.0f;
    float t60 = 0.0f;
    float t61 = 0.0f;
    if (t14) {
        const float t62 = t21 < 0.0f ? t55 : t56;
        float t63 = 0.0f;
        float t64 = 0.0f;
        float t65 = 0.0f;
        if (t5) {
            const float t66 = light->solid_angle * 0.15915494f;
            const float t67 = t66 * (1.0f - t57 * t17);
            const float t68 = sqrtf(t66 * (2.0f - t67));
            const float t69 = (t62 - 1.0f) * t68;
            t63 = t69;
            t64 = t58 * t16 * t68;
            t65 = fmaf(light->elevation_sin, 1.0f - t67, light->elevation_cos * t69);
        } else {
            const float t70 = light->radius_sin * light->elevation_cos;
            const float t71 = 1.0f - t62;
            const float t72 = t57 * t17;
            const float t73 = spherecap_inline_max(fmaf(t70, t62, -light->rise), 0.0f);
            const float t74 = sqrtf(fmaf(t73, t73, light->radius_sin * light->radius_sin * t72));
            const float t75 = t1 * light->radius_cos;
            const float t76 = fmaf(light->elevation_cos * t71, fmaf(t70, t71, -2.0f * t75), light->radius_sin * t72);
            const float t77 = light->radius_sin * fmaf(light->elevation_cos, t76 / (t74 + t75), -(t1 * t1 * t71));
            t63 = t77;
            t64 = light->radius_sin * t58 * t16;
            t65 = t74;
        }
        t59 = t63;
        t60 = t64;
        t61 = t65;
    } else {
        const float t78 = t58 * t21;
        t59 = fmaf(light->elevation_cos, t78, -((t12 ? t1 : -t1) * (1.0f - t55)));
        t60 = t58 * t16;
        t61 = t78;
    }
    const float t79 = t9 ? 1.0f : -1.0f;
    const float t80 = t59 * t79;
    const float t81 = t61 * t79;
    const float t82 = spherecap_inline_min(fabsf(t81), 3.4028235e38f);
    const float t83 = 0.0f < t81 ? light->inv_above * light->share_above : t81 < 0.0f ? light->inv_below * t10 : 0.0f;
    float t84 = 0.0f;
    float t85 = 0.0f;
    if (0.0f < light->defensive) {
        const float t86 = light->defensive * light->inv_solid_angle;
        const float t87 = spherecap_inline_min(t86 / spherecap_inline_max(t82, 1.1754944e-38f), 3.4028235e38f);
        t84 = fmaf(t83, t6 * t82, t86);
        t85 = spherecap_inline_min(fmaf(t83, t6, t87), 3.4028235e38f);
    } else {
        t84 = t83 * t82;
        t85 = t83;
    }
    const float t88 = fmaf(t80, t80, t60 * t60);
    const float t89 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t88), 0.0f);
    const float t90 = sqrtf(t89);
    const float t91 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t89));
    const float t92 = light->radius_cos * light->radius_cos / (t91 + t90);
    const float t93 = fmaf(light->frame_0_x, t91, fmaf(light->frame_1_x, t80, light->frame_2_x * t60));
    const float t94 = fmaf(light->frame_0_y, t91, fmaf(light->frame_1_y, t80, light->frame_2_y * t60));
    const float t95 = fmaf(light->frame_0_z, t91, fmaf(light->frame_1_z, t80, light->frame_2_z * t60));
    const float t96 = t92 * light->inv_radius_sin;
    const float t97 = -fmaf(t91, t90, t88) * light->inv_radius_sin;
    const float t98 = t96 * t80;
    const float t99 = t96 * t60;
    const float t100 = fmaf(light->frame_0_x, t97, fmaf(light->frame_1_x, t98, light->frame_2_x * t99));
    const float t101 = fmaf(light->frame_0_y, t97, fmaf(light->frame_1_y, t98, light->frame_2_y * t99));
    const float t102 = fmaf(light->frame_0_z, t97, fmaf(light->frame_1_z, t98, light->frame_2_z * t99));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t93;
    sampled.direction[1] = t94;
    sampled.direction[2] = t95;
    sampled.distance = t92 * light->distance;
    sampled.normal[0] = t100;
    sampled.normal[1] = t101;
    sampled.normal[2] = t102;
    sampled.cosine = t81;
    sampled.pdf = t84;
    sampled.projected_pdf = t85;
    return sampled;
}

static inline spherecap_inline_sample spherecap_inline_both_sample_once(const float normal[3], const float centre[3], float radius, float defensive, float u0, float u1)
{
    const spherecap_inline_both_light light = spherecap_inline_both_prepare(normal, centre, radius, defensive);
    return spherecap_inline_both_sample(&light, u0, u1);
}

static inline float spherecap_inline_both_pdf_direction(const spherecap_inline_both_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->frame_0_x, direction[0], fmaf(light->frame_0_y, direction[1], light->frame_0_z * direction[2]));
    const float t2 = fmaf(light->frame_1_x, direction[0], fmaf(light->frame_1_y, direction[1], light->frame_1_z * direction[2]));
    const float t3 = fmaf(light->frame_2_x, direction[0], fmaf(light->frame_2_y, direction[1], light->frame_2_z * direction[2]));
    const float t4 = fmaf(light->normal_x, direction[0], fmaf(light->normal_y, direction[1], light->normal_z * direction[2]));
    const bool t5 = t1 < 0.0f;
    const float t6 = t5 ? 1.0f : t2;
    const float t7 = t5 ? 1.0f : t3;
    const float t8 = spherecap_inline_min(fabsf(t4), 3.4028235e38f);
    const float t9 = 0.0f < t4 ? light->inv_above * light->share_above : t4 < 0.0f ? light->inv_below * (1.0f - light->share_above) : 0.0f;
    const float t10 = fmaf(t9, (1.0f - light->defensive) * t8, light->defensive * light->inv_solid_angle);
    const bool t11 = fmaf(t6, t6, t7 * t7) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t12 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t13 = (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? (0.0f < light->defensive ? t10 : t9 * t8) : 0.0f) : 0.0f;
    return t13;
}

static inline float spherecap_inline_both_pdf_on_sphere(const spherecap_inline_both_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal_x, direction[0], fmaf(light->normal_y, direction[1], light->normal_z * direction[2]));
    const float t2 = spherecap_inline_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light->inv_above * light->share_above : t1 < 0.0f ? light->inv_below * (1.0f - light->share_above) : 0.0f;
    const float t4 = fmaf(t3, (1.0f - light->defensive) * t2, light->defensive * light->inv_solid_angle);
    const float t5 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light->defensive ? t4 : t3 * t2) : 0.0f;
    return t6;
}

static inline float spherecap_inline_both_importance(const float normal[3], const float centre[3], float radius, float defensive, float strength)
{
    const float t1 = fmaf(normal[0], normal[0], fmaf(normal[1], normal[1], normal[2] * normal[2]));
    float t2 = 0.0f;
    float t3 = 0.0f;
    float t4 = 0.0f;
    if (fabsf(t1 - 1.0f) <= 4.7683716e-7f) {
        t2 = normal[0];
        t3 = normal[1];
        t4 = normal[2];
    } else {
        const float t5 = spherecap_inline_max(fabsf(normal[0]) + fabsf(normal[1]) + fabsf(normal[2]), 1.1754944e-38f);
        const float t6 = spherecap_inline_power_of_two(spherecap_inline_min(t5, 8.5070587e37f));
        const float t7 = normal[0] / t6;
        const float t8 = normal[1] / t6;
        const float t9 = normal[2] / t6;
        const float t10 = spherecap_inline_max(sqrtf(fmaf(t7, t7, fmaf(t8, t8, t9 * t9))), 1.1754944e-38f);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    const float t11 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float t12 = spherecap_inline_power_of_two(spherecap_inline_min(t11, 8.5070587e37f));
    const float t13 = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(t12));
    const float t14 = centre[0] * t13;
    const float t15 = centre[1] * t13;
    const float t16 = centre[2] * t13;
    const float t17 = radius * t13;
    const float t18 = sqrtf(fmaf(t14, t14, fmaf(t15, t15, t16 * t16)));
    const float t19 = 1.0f / t18;
    const float t20 = t17 * t19;
    const float t21 = t20 * t20;
    const float t22 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t23 = 0.0f <= defensive && defensive <= 1.0f && t22 <= 2.0f && 0.0f < radius && t18 * t12 <= 3.4028235e38f;
    const float t24 = fmaf(t2, t14, fmaf(t3, t15, t4 * t16));
    const float t25 = spherecap_inline_max(fmaf(-t21, t21, 0.9999981f), 0.0f);
    const float t26 = fmaf(t24, t19, 2.3841858e-7f);
    const float t27 = fmaf(t24 + t17, t19, 2.3841858e-7f);
    const float t28 = t20 <= t26 ? t26 : 0.0f < t27 ? t27 * t27 / (fmaf(t20 - t26, t25, t27) * 2.0f) : 0.0f;
    const float t29 = fmaf(-t24, t19, 2.3841858e-7f);
    const float t30 = fmaf(-t24 + t17, t19, 2.3841858e-7f);
    const float t31 = t20 <= t29 ? t29 : 0.0f < t30 ? t30 * t30 / (fmaf(t20 - t29, t25, t30) * 2.0f) : 0.0f;
    const float t32 = t28 + t31;
    const float t33 = t22 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t32, t32);
    const bool t34 = t21 <= 1.0000019f && 4.9303807e-32f < t21 && t23 && 0.0f < strength && strength <= 3.4028235e38f;
    const float t35 = spherecap_inline_min(spherecap_inline_max(t21 * t33 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (t34 && (0.0f < t33 || 0.0f < defensive)) ? t35 : 0.0f;
}


#endif
