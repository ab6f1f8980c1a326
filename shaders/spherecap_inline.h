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
    float frame_0[3];
    float frame_1[3];
    float frame_2[3];
    float normal[3];
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
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t1, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t2 = centre[0] * scale;
    const float t3 = centre[1] * scale;
    const float t4 = centre[2] * scale;
    const float t5 = radius * scale;
    const float t6 = t2 * t2;
    const float t7 = t3 * t3;
    const float t8 = t4 * t4;
    const float t9 = t6 + t7;
    const float t10 = t9 - t6;
    const float t11 = t9 + t8;
    const float t12 = t11 - t9;
    const float t13 = spherecap_inline_lost(t2, t2, t6) + spherecap_inline_lost(t3, t3, t7) + spherecap_inline_lost(t4, t4, t8);
    const float t14 = t5 * t5;
    const float t15 = t13 + (t6 - (t9 - t10) + (t7 - t10) + (t9 - (t11 - t12) + (t8 - t12))) - spherecap_inline_lost(t5, t5, t14);
    const float t16 = t11 - t14 + t15;
    const bool t17 = 0.0f < t16;
    const float t18 = sqrtf(t11);
    const float t19 = 1.0f / t18;
    const float t20 = normal[0] * t2;
    const float t21 = normal[1] * t3;
    const float t22 = normal[2] * t4;
    const float t23 = t20 + t21;
    const float t24 = t23 - t20;
    const float t25 = t23 + t22;
    const float t26 = t25 - t23;
    const float t27 = spherecap_inline_lost(normal[0], t2, t20) + spherecap_inline_lost(normal[1], t3, t21);
    const float t28 = t27 + spherecap_inline_lost(normal[2], t4, t22) + (t20 - (t23 - t24) + (t21 - t24) + (t23 - (t25 - t26) + (t22 - t26)));
    const float t29 = t25 + t28;
    const float t30 = t28 - (t29 - t25);
    const float t31 = t5 - t29 - t30;
    const float t32 = t5 + t29 + t30;
    const float t33 = t31 * t32;
    const bool t34 = 0.0f < t33 && t17;
    const float t35 = normal[2] * t3;
    const float t36 = fmaf(normal[1], t4, -t35) - spherecap_inline_lost(normal[2], t3, t35);
    const float t37 = normal[0] * t4;
    const float t38 = fmaf(normal[2], t2, -t37) - spherecap_inline_lost(normal[0], t4, t37);
    const float t39 = normal[1] * t2;
    const float t40 = fmaf(normal[0], t3, -t39) - spherecap_inline_lost(normal[1], t2, t39);
    const float t41 = fmaf(t36, t36, fmaf(t38, t38, t40 * t40));
    const bool t42 = 9.8607613e-32f < t41;
    const bool t43 = fabsf(t2) < fabsf(t4);
    const float t44 = t43 ? 0.0f : -t3;
    const float t45 = t43 ? -t4 : t2;
    const float t46 = t43 ? t3 : 0.0f;
    const float t47 = sqrtf(spherecap_inline_max(t16, 0.0f));
    const float radius_cos = t47 * t19;
    const float t48 = 1.0f + radius_cos;
    const float t49 = 1.0f / (t5 * t48);
    const float t50 = t49 * t48;
    const float radius_sin = t5 * t19;
    const float inv_radius_sin = t18 * t50;
    const float t51 = sqrtf(t16 + t33);
    const float t52 = sqrtf(t42 ? t41 : fmaf(t44, t44, fmaf(t45, t45, t46 * t46)));
    const float elevation_sin = t29 * t19;
    const float elevation_cos = (t34 ? t51 : t42 ? t52 : 0.0f) * t19;
    const float t53 = fabsf(elevation_sin);
    const float t54 = radius_sin * elevation_cos;
    const float t55 = spherecap_inline_max(fmaf(radius_cos, t53, t54), 9.8607613e-32f);
    const float t56 = 1.0f / (t55 * t52);
    const float t57 = t56 * t52;
    const float t58 = t56 * t55;
    const float frame_2_x = (t42 ? t36 : t44) * t58;
    const float frame_2_y = (t42 ? t38 : t45) * t58;
    const float frame_2_z = (t42 ? t40 : t46) * t58;
    const float frame_0_x = t2 * t19;
    const float frame_0_y = t3 * t19;
    const float frame_0_z = t4 * t19;
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
    if (t34) {
        const float t59 = sqrtf(t33);
        const float t60 = t51 + t47;
        const float t61 = 1.0f / (t51 * t60);
        const float t62 = t61 * t60;
        const float t63 = t47 * t62;
        const float t64 = t59 * t62;
        const float t65 = fabsf(t29) * t50;
        const float t66 = t65 * t63;
        const float t67 = t63 - 0.5f;
        const float t68 = t66 - 0.5f;
        const float t69 = t67 * t67;
        const float t70 = t68 * t68;
        const float t71 = fmaf(0.05430631f, t69, 0.080950715f);
        const float t72 = fmaf(t71, t69, 0.1684019f);
        const float t73 = fmaf(t72, t69, 0.32709444f);
        const float t74 = fmaf(t73, t69, 0.5987523f);
        const float t75 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t70, t71), t70, t72), t70, t73), t70, t74);
        const float t76 = fmaf(-0.026061837f, t69, -0.06372378f);
        const float t77 = fmaf(t76, t69, -0.11762552f);
        const float t78 = fmaf(t77, t69, -0.23594604f);
        const float t79 = fmaf(t78, t69, -0.44721135f);
        const float t80 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t70, t76), t70, t77), t70, t78), t70, t79);
        const float t81 = fmaf(t79, t69, -0.7754678f);
        const float t82 = fmaf(t81, t67, fmaf(t74, t69, 0.94559944f));
        const float t83 = fmaf(fmaf(t68, t80, t75), t67 + t68, t81);
        const float t84 = fmaf(t66, t83, t82);
        t_x = t63;
        t_y = t64;
        kappa = t65;
        cut = t66;
        shape = t82;
        shape_cut = fmaf(t66 - t63, t83, t82);
        norm = t84;
        width = t33 * t61;
        inv_cut_1 = t54 * t57;
        tau = t59 * t50;
        area = t64 * t64 * t64 * (spherecap_inline_min(t31, t32) * t50) * t84;
    }
    const float t85 = radius_sin * radius_sin;
    const float t86 = elevation_sin < 0.0f ? area : t85 * t53 * 3.1415927f + area;
    const bool t87 = t17 && 9.8607613e-32f < t85;
    const float distance = t18 * unscale;
    const float projected_above = (9.403955e-38f < t86 && t87) ? t86 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t88 = 0.0f < elevation_sin;
    const float t89 = t88 ? inv_above : 0.0f;
    const bool t90 = 0.0f < tau;
    const bool t91 = t88 && t90 && 0.0f < t89;
    const float t92 = t_y * t_y * t_y * shape * t89;
    const float t93 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (!t88 && t90) {
        const float t94 = 1.0f + kappa;
        const float t95 = t94 * shape;
        const float t96 = 1.0f / (norm * t95);
        const float t97 = sqrtf(t96);
        const float t98 = norm * t97;
        const float t99 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t100 = t99 * t99;
        const float t101 = fmaf(fmaf(fmaf(-0.026061837f, t100, -0.06372378f), t100, -0.11762552f), t100, -0.23594604f);
        const float t102 = fmaf(fmaf(fmaf(0.05430631f, t100, 0.080950715f), t100, 0.1684019f), t100, 0.32709444f);
        const float t103 = fmaf(fmaf(fmaf(t101, t100, -0.44721135f), t100, -0.7754678f), t99, fmaf(fmaf(t102, t100, 0.5987523f), t100, 0.94559944f));
        const float t104 = t94 * t103 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t95 * t96);
        const float t105 = fmaf(t104, t95 * t97, -1.0f);
        const float t106 = 1.0f - t104;
        const float t107 = fmaf(fmaf(30.011856f, t105, fmaf(-41.541264f, t106, -37.009792f)), t105, fmaf(77.96775f, t106, 7.470758f));
        const float t108 = fmaf(t107, t105, fmaf(fmaf(-49.13454f, t106, -9.466533f), t106, -1.5877596f));
        const float t109 = fmaf(fmaf(fmaf(15.716111f, t106, 0.0f), t106, 9.961183f), t106, -2.61785f);
        const float t110 = t105 * fmaf(t108, t105, fmaf(t109, t106, 0.8681748f));
        const float t111 = fmaf(fmaf(7.295638f, t105, -7.236236f), t105, fmaf(fmaf(fmaf(-11.4868555f, t106, 0.0f), t106, 0.0f), t106, 3.1255686f));
        const float t112 = fmaf(fmaf(fmaf(13.728438f, t106, -7.981878f), t106, 2.025724f), t106, -0.7334958f);
        const float t113 = t105 * fmaf(t111, t105, t112);
        const float t114 = fmaf(fmaf(fmaf(9.986537f, t106, 25.22195f), t106, 0.0f), t106, -2.9581387f);
        const float t115 = fmaf(fmaf(fmaf(-19.722994f, t106, 4.6594768f), t106, -0.89538246f), t106, 0.5143498f);
        const float t116 = t105 * fmaf(fmaf(fmaf(-23.220068f, t106, 7.332055f), t105, t114), t105, t115);
        const float t117 = fmaf(fmaf(fmaf(1.946617f, t105, -3.077631f), t105, 1.4945927f), t105, -0.24140751f);
        const float t118 = t105 * t117;
        const float t119 = t105 * fmaf(fmaf(0.38173297f, t105, -0.30305624f), t105, 0.05897375f);
        coefficients_0 = t98;
        coefficients_1 = t104 - t98 + t110;
        coefficients_2 = t113 - t110;
        coefficients_3 = t116 - t113;
        coefficients_4 = t118 - t116;
        coefficients_5 = t119 - t118;
        coefficients_6 = -t119;
    }
    const bool t120 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    spherecap_inline_surface_light light;
    light.is_sampled = t120;
    light.solid_angle = t120 ? (t87 ? t85 * (t49 * t5) * 6.2831855f : 0.0f) : 0.0f;
    light.projected_solid_angle = t120 ? projected_above : 0.0f;
    light.frame_0[0] = frame_0_x;
    light.frame_0[1] = frame_0_y;
    light.frame_0[2] = frame_0_z;
    light.frame_1[0] = fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1[1] = fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1[2] = fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
    light.frame_2[0] = frame_2_x;
    light.frame_2[1] = frame_2_y;
    light.frame_2[2] = frame_2_z;
    light.normal[0] = normal[0];
    light.normal[1] = normal[1];
    light.normal[2] = normal[2];
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
    light.rise = spherecap_inline_max(t33 * (t19 * t19) * t57, -(radius_cos * t53));
    light.inv_above = inv_above;
    light.crescent_share = t91 ? t92 : 0.0f;
    light.inv_rest = t91 ? 1.0f / (1.0f - t92) : 1.0f;
    light.beyond = t91 ? t93 * t93 * t93 * shape_cut : 0.0f;
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
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t5) {
        const float t49 = light->radius_sin * light->elevation_cos;
        const float t50 = t12 < 0.0f ? t45 : t46;
        const float t51 = 1.0f - t50;
        const float t52 = t47 * t8;
        const float t53 = spherecap_inline_max(fmaf(t49, t50, -light->rise), 0.0f);
        const float t54 = sqrtf(fmaf(t53, t53, light->radius_sin * light->radius_sin * t52));
        const float t55 = t1 * light->radius_cos;
        const float t56 = fmaf(light->elevation_cos * t51, fmaf(t49, t51, -2.0f * t55), light->radius_sin * t52);
        const float t57 = light->radius_sin * fmaf(light->elevation_cos, t56 / (t54 + t55), -(t1 * t1 * t51));
        zenith = t57;
        side = light->radius_sin * t48 * t7;
        cosine = t54;
    } else {
        const float t58 = t48 * t12;
        zenith = fmaf(light->elevation_cos, t58, -((t2 ? t1 : -t1) * (1.0f - t45)));
        side = t48 * t7;
        cosine = t58;
    }
    const float t59 = 0.0f < cosine ? light->inv_above : 0.0f;
    const float t60 = fmaf(zenith, zenith, side * side);
    const float t61 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t60), 0.0f);
    const float t62 = sqrtf(t61);
    const float t63 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t61));
    const float t64 = light->radius_cos * light->radius_cos / (t63 + t62);
    const float t65 = fmaf(light->frame_0[0], t63, fmaf(light->frame_1[0], zenith, light->frame_2[0] * side));
    const float t66 = fmaf(light->frame_0[1], t63, fmaf(light->frame_1[1], zenith, light->frame_2[1] * side));
    const float t67 = fmaf(light->frame_0[2], t63, fmaf(light->frame_1[2], zenith, light->frame_2[2] * side));
    const float t68 = t64 * light->inv_radius_sin;
    const float t69 = -fmaf(t63, t62, t60) * light->inv_radius_sin;
    const float t70 = t68 * zenith;
    const float t71 = t68 * side;
    const float t72 = fmaf(light->frame_0[0], t69, fmaf(light->frame_1[0], t70, light->frame_2[0] * t71));
    const float t73 = fmaf(light->frame_0[1], t69, fmaf(light->frame_1[1], t70, light->frame_2[1] * t71));
    const float t74 = fmaf(light->frame_0[2], t69, fmaf(light->frame_1[2], t70, light->frame_2[2] * t71));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t65;
    sampled.direction[1] = t66;
    sampled.direction[2] = t67;
    sampled.distance = t64 * light->distance;
    sampled.normal[0] = t72;
    sampled.normal[1] = t73;
    sampled.normal[2] = t74;
    sampled.cosine = cosine;
    sampled.pdf = t59 * spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    sampled.projected_pdf = t59;
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
    const float t1 = fmaf(light->frame_0[0], direction[0], fmaf(light->frame_0[1], direction[1], light->frame_0[2] * direction[2]));
    const float t2 = fmaf(light->frame_1[0], direction[0], fmaf(light->frame_1[1], direction[1], light->frame_1[2] * direction[2]));
    const float t3 = fmaf(light->frame_2[0], direction[0], fmaf(light->frame_2[1], direction[1], light->frame_2[2] * direction[2]));
    const float t4 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
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
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const float t2 = (0.0f < t1 ? light->inv_above : 0.0f) * spherecap_inline_min(fabsf(t1), 3.4028235e38f);
    const float t3 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
}

static inline float spherecap_inline_surface_importance(const float normal[3], const float centre[3], float radius, float strength)
{
    const float t1 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t1, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t2 = centre[0] * scale;
    const float t3 = centre[1] * scale;
    const float t4 = centre[2] * scale;
    const float t5 = radius * scale;
    const float t6 = sqrtf(fmaf(t2, t2, fmaf(t3, t3, t4 * t4)));
    const float t7 = 1.0f / t6;
    const float t8 = t5 * t7;
    const float t9 = t8 * t8;
    const bool t10 = 0.0f < radius && t6 * unscale <= 3.4028235e38f && 0.0f < strength && strength <= 3.4028235e38f;
    const float t11 = fmaf(normal[0], t2, fmaf(normal[1], t3, normal[2] * t4));
    const float t12 = fmaf(t11, t7, 2.3841858e-7f);
    const float t13 = fmaf(t11 + t5, t7, 2.3841858e-7f);
    const float t14 = fmaf(t8 - t12, spherecap_inline_max(fmaf(-t9, t9, 0.9999981f), 0.0f), t13);
    const float t15 = t8 <= t12 ? t12 : 0.0f < t13 ? t13 * t13 / (t14 * 2.0f) : 0.0f;
    const float t16 = fmaf(0.0f, 0.5f - t15, t15);
    const float t17 = spherecap_inline_min(spherecap_inline_max(t9 * t16 * strength, 1.1754944e-38f), 3.4028235e38f);
    const float t18 = (t9 <= 1.0000019f && 4.9303807e-32f < t9 && t10 && 0.0f < t16) ? t17 : 0.0f;
    return t18;
}


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the
// probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with
// the normal.
typedef struct spherecap_inline_front_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float frame_0[3];
    float frame_1[3];
    float frame_2[3];
    float normal[3];
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
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t9, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t10 = centre[0] * scale;
    const float t11 = centre[1] * scale;
    const float t12 = centre[2] * scale;
    const float t13 = radius * scale;
    const float t14 = t10 * t10;
    const float t15 = t11 * t11;
    const float t16 = t12 * t12;
    const float t17 = t14 + t15;
    const float t18 = t17 - t14;
    const float t19 = t17 + t16;
    const float t20 = t19 - t17;
    const float t21 = spherecap_inline_lost(t10, t10, t14) + spherecap_inline_lost(t11, t11, t15);
    const float t22 = t21 + spherecap_inline_lost(t12, t12, t16) + (t14 - (t17 - t18) + (t15 - t18) + (t17 - (t19 - t20) + (t16 - t20)));
    const float t23 = t13 * t13;
    const float t24 = t19 - t23 + (t22 - spherecap_inline_lost(t13, t13, t23));
    const bool t25 = 0.0f < t24;
    const float t26 = sqrtf(t19);
    const float t27 = 1.0f / t26;
    const float t28 = normal_x * t10;
    const float t29 = normal_y * t11;
    const float t30 = normal_z * t12;
    const float t31 = t28 + t29;
    const float t32 = t31 - t28;
    const float t33 = t31 + t30;
    const float t34 = t33 - t31;
    const float t35 = spherecap_inline_lost(normal_x, t10, t28) + spherecap_inline_lost(normal_y, t11, t29);
    const float t36 = t35 + spherecap_inline_lost(normal_z, t12, t30) + (t28 - (t31 - t32) + (t29 - t32) + (t31 - (t33 - t34) + (t30 - t34)));
    const float t37 = t33 + t36;
    const float t38 = t36 - (t37 - t33);
    const float t39 = t13 - t37 - t38;
    const float t40 = t13 + t37 + t38;
    const float t41 = t39 * t40;
    const bool t42 = 0.0f < t8;
    const bool t43 = 0.0f < t41 && t25 && t42;
    const float t44 = normal_z * t11;
    const float t45 = fmaf(normal_y, t12, -t44) - spherecap_inline_lost(normal_z, t11, t44);
    const float t46 = normal_x * t12;
    const float t47 = fmaf(normal_z, t10, -t46) - spherecap_inline_lost(normal_x, t12, t46);
    const float t48 = normal_y * t10;
    const float t49 = fmaf(normal_x, t11, -t48) - spherecap_inline_lost(normal_y, t10, t48);
    const float t50 = fmaf(t45, t45, fmaf(t47, t47, t49 * t49));
    const bool t51 = 9.8607613e-32f < t50;
    const bool t52 = fabsf(t10) < fabsf(t12);
    const float t53 = t52 ? 0.0f : -t11;
    const float t54 = t52 ? -t12 : t10;
    const float t55 = t52 ? t11 : 0.0f;
    const float t56 = sqrtf(spherecap_inline_max(t24, 0.0f));
    const float radius_cos = t56 * t27;
    const float t57 = 1.0f + radius_cos;
    const float t58 = 1.0f / (t13 * t57);
    const float t59 = t58 * t57;
    const float radius_sin = t13 * t27;
    const float inv_radius_sin = t26 * t59;
    const float t60 = sqrtf(t24 + t41);
    const float t61 = sqrtf(t51 ? t50 : fmaf(t53, t53, fmaf(t54, t54, t55 * t55)));
    const float elevation_sin = t37 * t27;
    const float elevation_cos = (t43 ? t60 : t51 ? t61 : 0.0f) * t27;
    const float t62 = fabsf(elevation_sin);
    const float t63 = radius_sin * elevation_cos;
    const float t64 = spherecap_inline_max(fmaf(radius_cos, t62, t63), 9.8607613e-32f);
    const float t65 = 1.0f / (t64 * t61);
    const float t66 = t65 * t61;
    const float t67 = t65 * t64;
    const float frame_2_x = (t51 ? t45 : t53) * t67;
    const float frame_2_y = (t51 ? t47 : t54) * t67;
    const float frame_2_z = (t51 ? t49 : t55) * t67;
    const float frame_0_x = t10 * t27;
    const float frame_0_y = t11 * t27;
    const float frame_0_z = t12 * t27;
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
    if (t43) {
        const float t68 = sqrtf(t41);
        const float t69 = t60 + t56;
        const float t70 = 1.0f / (t60 * t69);
        const float t71 = t70 * t69;
        const float t72 = t56 * t71;
        const float t73 = t68 * t71;
        const float t74 = fabsf(t37) * t59;
        const float t75 = t74 * t72;
        const float t76 = t72 - 0.5f;
        const float t77 = t75 - 0.5f;
        const float t78 = t76 * t76;
        const float t79 = t77 * t77;
        const float t80 = fmaf(0.05430631f, t78, 0.080950715f);
        const float t81 = fmaf(t80, t78, 0.1684019f);
        const float t82 = fmaf(t81, t78, 0.32709444f);
        const float t83 = fmaf(t82, t78, 0.5987523f);
        const float t84 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t79, t80), t79, t81), t79, t82), t79, t83);
        const float t85 = fmaf(-0.026061837f, t78, -0.06372378f);
        const float t86 = fmaf(t85, t78, -0.11762552f);
        const float t87 = fmaf(t86, t78, -0.23594604f);
        const float t88 = fmaf(t87, t78, -0.44721135f);
        const float t89 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t79, t85), t79, t86), t79, t87), t79, t88);
        const float t90 = fmaf(t88, t78, -0.7754678f);
        const float t91 = fmaf(t90, t76, fmaf(t83, t78, 0.94559944f));
        const float t92 = fmaf(fmaf(t77, t89, t84), t76 + t77, t90);
        const float t93 = fmaf(t75, t92, t91);
        t_x = t72;
        t_y = t73;
        kappa = t74;
        cut = t75;
        shape = t91;
        shape_cut = fmaf(t75 - t72, t92, t91);
        norm = t93;
        width = t41 * t70;
        inv_cut_1 = t63 * t66;
        tau = t68 * t59;
        area = t73 * t73 * t73 * (spherecap_inline_min(t39, t40) * t59) * t93;
    }
    const float t94 = radius_sin * radius_sin;
    const float t95 = elevation_sin < 0.0f ? area : t94 * t62 * 3.1415927f + area;
    const bool t96 = t25 && 9.8607613e-32f < t94;
    const float distance = t26 * unscale;
    const float solid_angle = t96 ? t94 * (t58 * t13) * 6.2831855f : 0.0f;
    const float projected_above = (9.403955e-38f < t95 && t96) ? t95 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t97 = 0.0f < inv_above;
    const bool t98 = 0.0f < elevation_sin;
    const float t99 = t98 ? inv_above : 0.0f;
    const float t100 = t97 ? defensive : 0.0f < defensive || !t42 ? 1.0f : 0.0f;
    const bool t101 = 0.0f < tau;
    const bool t102 = t98 && t101 && 0.0f < t99;
    const float t103 = t_y * t_y * t_y * shape * t99;
    const float t104 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (!t98 && t101) {
        const float t105 = 1.0f + kappa;
        const float t106 = t105 * shape;
        const float t107 = 1.0f / (norm * t106);
        const float t108 = sqrtf(t107);
        const float t109 = norm * t108;
        const float t110 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t111 = t110 * t110;
        const float t112 = fmaf(fmaf(fmaf(-0.026061837f, t111, -0.06372378f), t111, -0.11762552f), t111, -0.23594604f);
        const float t113 = fmaf(fmaf(fmaf(0.05430631f, t111, 0.080950715f), t111, 0.1684019f), t111, 0.32709444f);
        const float t114 = fmaf(fmaf(fmaf(t112, t111, -0.44721135f), t111, -0.7754678f), t110, fmaf(fmaf(t113, t111, 0.5987523f), t111, 0.94559944f));
        const float t115 = t105 * t114 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t106 * t107);
        const float t116 = fmaf(t115, t106 * t108, -1.0f);
        const float t117 = 1.0f - t115;
        const float t118 = fmaf(fmaf(30.011856f, t116, fmaf(-41.541264f, t117, -37.009792f)), t116, fmaf(77.96775f, t117, 7.470758f));
        const float t119 = fmaf(t118, t116, fmaf(fmaf(-49.13454f, t117, -9.466533f), t117, -1.5877596f));
        const float t120 = fmaf(fmaf(fmaf(15.716111f, t117, 0.0f), t117, 9.961183f), t117, -2.61785f);
        const float t121 = t116 * fmaf(t119, t116, fmaf(t120, t117, 0.8681748f));
        const float t122 = fmaf(fmaf(7.295638f, t116, -7.236236f), t116, fmaf(fmaf(fmaf(-11.4868555f, t117, 0.0f), t117, 0.0f), t117, 3.1255686f));
        const float t123 = fmaf(fmaf(fmaf(13.728438f, t117, -7.981878f), t117, 2.025724f), t117, -0.7334958f);
        const float t124 = t116 * fmaf(t122, t116, t123);
        const float t125 = fmaf(fmaf(fmaf(9.986537f, t117, 25.22195f), t117, 0.0f), t117, -2.9581387f);
        const float t126 = fmaf(fmaf(fmaf(-19.722994f, t117, 4.6594768f), t117, -0.89538246f), t117, 0.5143498f);
        const float t127 = t116 * fmaf(fmaf(fmaf(-23.220068f, t117, 7.332055f), t116, t125), t116, t126);
        const float t128 = fmaf(fmaf(fmaf(1.946617f, t116, -3.077631f), t116, 1.4945927f), t116, -0.24140751f);
        const float t129 = t116 * t128;
        const float t130 = t116 * fmaf(fmaf(0.38173297f, t116, -0.30305624f), t116, 0.05897375f);
        coefficients_0 = t109;
        coefficients_1 = t115 - t109 + t121;
        coefficients_2 = t124 - t121;
        coefficients_3 = t127 - t124;
        coefficients_4 = t129 - t127;
        coefficients_5 = t130 - t129;
        coefficients_6 = -t130;
    }
    const bool t131 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f;
    const bool t132 = t131 && (t97 || (0.0f < t100 && 0.0f < solid_angle));
    spherecap_inline_front_light light;
    light.is_sampled = t132;
    light.solid_angle = t132 ? solid_angle : 0.0f;
    light.projected_solid_angle = t132 ? projected_above : 0.0f;
    light.frame_0[0] = frame_0_x;
    light.frame_0[1] = frame_0_y;
    light.frame_0[2] = frame_0_z;
    light.frame_1[0] = fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1[1] = fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1[2] = fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
    light.frame_2[0] = frame_2_x;
    light.frame_2[1] = frame_2_y;
    light.frame_2[2] = frame_2_z;
    light.normal[0] = normal_x;
    light.normal[1] = normal_y;
    light.normal[2] = normal_z;
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = t96 ? t57 * (inv_radius_sin * inv_radius_sin) * 0.15915494f : 0.0f;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_inline_max(t41 * (t27 * t27) * t66, -(radius_cos * t62));
    light.defensive = t100;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.crescent_share = t102 ? t103 : 0.0f;
    light.inv_rest = t102 ? 1.0f / (1.0f - t103) : 1.0f;
    light.beyond = t102 ? t104 * t104 * t104 * shape_cut : 0.0f;
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
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t9) {
        const float t54 = t16 < 0.0f ? t50 : t51;
        float t55 = 0.0f;
        float t56 = 0.0f;
        float t57 = 0.0f;
        if (t5) {
            const float t58 = light->solid_angle * 0.15915494f;
            const float t59 = t58 * (1.0f - t52 * t12);
            const float t60 = sqrtf(t58 * (2.0f - t59));
            const float t61 = (t54 - 1.0f) * t60;
            t55 = t61;
            t56 = t53 * t11 * t60;
            t57 = fmaf(light->elevation_sin, 1.0f - t59, light->elevation_cos * t61);
        } else {
            const float t62 = light->radius_sin * light->elevation_cos;
            const float t63 = 1.0f - t54;
            const float t64 = t52 * t12;
            const float t65 = spherecap_inline_max(fmaf(t62, t54, -light->rise), 0.0f);
            const float t66 = sqrtf(fmaf(t65, t65, light->radius_sin * light->radius_sin * t64));
            const float t67 = t1 * light->radius_cos;
            const float t68 = fmaf(light->elevation_cos * t63, fmaf(t62, t63, -2.0f * t67), light->radius_sin * t64);
            const float t69 = light->radius_sin * fmaf(light->elevation_cos, t68 / (t66 + t67), -(t1 * t1 * t63));
            t55 = t69;
            t56 = light->radius_sin * t53 * t11;
            t57 = t66;
        }
        zenith = t55;
        side = t56;
        cosine = t57;
    } else {
        const float t70 = t53 * t16;
        zenith = fmaf(light->elevation_cos, t70, -((t2 ? t1 : -t1) * (1.0f - t50)));
        side = t53 * t11;
        cosine = t70;
    }
    const float t71 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t72 = 0.0f < cosine ? light->inv_above : 0.0f;
    float t73 = 0.0f;
    float t74 = 0.0f;
    if (0.0f < light->defensive) {
        const float t75 = light->defensive * light->inv_solid_angle;
        const float t76 = spherecap_inline_min(t75 / spherecap_inline_max(t71, 1.1754944e-38f), 3.4028235e38f);
        t73 = fmaf(t72, t6 * t71, t75);
        t74 = spherecap_inline_min(fmaf(t72, t6, t76), 3.4028235e38f);
    } else {
        t73 = t72 * t71;
        t74 = t72;
    }
    const float t77 = fmaf(zenith, zenith, side * side);
    const float t78 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t77), 0.0f);
    const float t79 = sqrtf(t78);
    const float t80 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t78));
    const float t81 = light->radius_cos * light->radius_cos / (t80 + t79);
    const float t82 = fmaf(light->frame_0[0], t80, fmaf(light->frame_1[0], zenith, light->frame_2[0] * side));
    const float t83 = fmaf(light->frame_0[1], t80, fmaf(light->frame_1[1], zenith, light->frame_2[1] * side));
    const float t84 = fmaf(light->frame_0[2], t80, fmaf(light->frame_1[2], zenith, light->frame_2[2] * side));
    const float t85 = t81 * light->inv_radius_sin;
    const float t86 = -fmaf(t80, t79, t77) * light->inv_radius_sin;
    const float t87 = t85 * zenith;
    const float t88 = t85 * side;
    const float t89 = fmaf(light->frame_0[0], t86, fmaf(light->frame_1[0], t87, light->frame_2[0] * t88));
    const float t90 = fmaf(light->frame_0[1], t86, fmaf(light->frame_1[1], t87, light->frame_2[1] * t88));
    const float t91 = fmaf(light->frame_0[2], t86, fmaf(light->frame_1[2], t87, light->frame_2[2] * t88));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t82;
    sampled.direction[1] = t83;
    sampled.direction[2] = t84;
    sampled.distance = t81 * light->distance;
    sampled.normal[0] = t89;
    sampled.normal[1] = t90;
    sampled.normal[2] = t91;
    sampled.cosine = cosine;
    sampled.pdf = t73;
    sampled.projected_pdf = t74;
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
    const float t1 = fmaf(light->frame_0[0], direction[0], fmaf(light->frame_0[1], direction[1], light->frame_0[2] * direction[2]));
    const float t2 = fmaf(light->frame_1[0], direction[0], fmaf(light->frame_1[1], direction[1], light->frame_1[2] * direction[2]));
    const float t3 = fmaf(light->frame_2[0], direction[0], fmaf(light->frame_2[1], direction[1], light->frame_2[2] * direction[2]));
    const float t4 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
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
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
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
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t11, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t12 = centre[0] * scale;
    const float t13 = centre[1] * scale;
    const float t14 = centre[2] * scale;
    const float t15 = radius * scale;
    const float t16 = sqrtf(fmaf(t12, t12, fmaf(t13, t13, t14 * t14)));
    const float t17 = 1.0f / t16;
    const float t18 = t15 * t17;
    const float t19 = t18 * t18;
    const float t20 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t21 = 0.0f <= defensive && defensive <= 1.0f && t20 <= 2.0f && 0.0f < radius && t16 * unscale <= 3.4028235e38f;
    const float t22 = fmaf(t2, t12, fmaf(t3, t13, t4 * t14));
    const float t23 = fmaf(t22, t17, 2.3841858e-7f);
    const float t24 = fmaf(t22 + t15, t17, 2.3841858e-7f);
    const float t25 = fmaf(t18 - t23, spherecap_inline_max(fmaf(-t19, t19, 0.9999981f), 0.0f), t24);
    const float t26 = t18 <= t23 ? t23 : 0.0f < t24 ? t24 * t24 / (t25 * 2.0f) : 0.0f;
    const float t27 = t20 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t26, t26);
    const bool t28 = t19 <= 1.0000019f && 4.9303807e-32f < t19 && t21 && 0.0f < strength && strength <= 3.4028235e38f;
    const float t29 = spherecap_inline_min(spherecap_inline_max(t19 * t27 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (t28 && (0.0f < t27 || 0.0f < defensive)) ? t29 : 0.0f;
}


// The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.
typedef struct spherecap_inline_both_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float frame_0[3];
    float frame_1[3];
    float frame_2[3];
    float normal[3];
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
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t9, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t10 = centre[0] * scale;
    const float t11 = centre[1] * scale;
    const float t12 = centre[2] * scale;
    const float t13 = radius * scale;
    const float t14 = t10 * t10;
    const float t15 = t11 * t11;
    const float t16 = t12 * t12;
    const float t17 = t14 + t15;
    const float t18 = t17 - t14;
    const float t19 = t17 + t16;
    const float t20 = t19 - t17;
    const float t21 = spherecap_inline_lost(t10, t10, t14) + spherecap_inline_lost(t11, t11, t15);
    const float t22 = t21 + spherecap_inline_lost(t12, t12, t16) + (t14 - (t17 - t18) + (t15 - t18) + (t17 - (t19 - t20) + (t16 - t20)));
    const float t23 = t13 * t13;
    const float t24 = t19 - t23 + (t22 - spherecap_inline_lost(t13, t13, t23));
    const bool t25 = 0.0f < t24;
    const float t26 = sqrtf(t19);
    const float t27 = 1.0f / t26;
    const float t28 = normal_x * t10;
    const float t29 = normal_y * t11;
    const float t30 = normal_z * t12;
    const float t31 = t28 + t29;
    const float t32 = t31 - t28;
    const float t33 = t31 + t30;
    const float t34 = t33 - t31;
    const float t35 = spherecap_inline_lost(normal_x, t10, t28) + spherecap_inline_lost(normal_y, t11, t29);
    const float t36 = t35 + spherecap_inline_lost(normal_z, t12, t30) + (t28 - (t31 - t32) + (t29 - t32) + (t31 - (t33 - t34) + (t30 - t34)));
    const float t37 = t33 + t36;
    const float t38 = t36 - (t37 - t33);
    const float t39 = t13 - t37 - t38;
    const float t40 = t13 + t37 + t38;
    const float t41 = t39 * t40;
    const bool t42 = 0.0f < t8;
    const bool t43 = 0.0f < t41 && t25 && t42;
    const float t44 = normal_z * t11;
    const float t45 = fmaf(normal_y, t12, -t44) - spherecap_inline_lost(normal_z, t11, t44);
    const float t46 = normal_x * t12;
    const float t47 = fmaf(normal_z, t10, -t46) - spherecap_inline_lost(normal_x, t12, t46);
    const float t48 = normal_y * t10;
    const float t49 = fmaf(normal_x, t11, -t48) - spherecap_inline_lost(normal_y, t10, t48);
    const float t50 = fmaf(t45, t45, fmaf(t47, t47, t49 * t49));
    const bool t51 = 9.8607613e-32f < t50;
    const bool t52 = fabsf(t10) < fabsf(t12);
    const float t53 = t52 ? 0.0f : -t11;
    const float t54 = t52 ? -t12 : t10;
    const float t55 = t52 ? t11 : 0.0f;
    const float t56 = sqrtf(spherecap_inline_max(t24, 0.0f));
    const float radius_cos = t56 * t27;
    const float t57 = 1.0f + radius_cos;
    const float t58 = 1.0f / (t13 * t57);
    const float t59 = t58 * t57;
    const float radius_sin = t13 * t27;
    const float inv_radius_sin = t26 * t59;
    const float t60 = sqrtf(t24 + t41);
    const float t61 = sqrtf(t51 ? t50 : fmaf(t53, t53, fmaf(t54, t54, t55 * t55)));
    const float elevation_sin = t37 * t27;
    const float elevation_cos = (t43 ? t60 : t51 ? t61 : 0.0f) * t27;
    const float t62 = fabsf(elevation_sin);
    const float t63 = radius_sin * elevation_cos;
    const float t64 = spherecap_inline_max(fmaf(radius_cos, t62, t63), 9.8607613e-32f);
    const float t65 = 1.0f / (t64 * t61);
    const float t66 = t65 * t61;
    const float t67 = t65 * t64;
    const float frame_2_x = (t51 ? t45 : t53) * t67;
    const float frame_2_y = (t51 ? t47 : t54) * t67;
    const float frame_2_z = (t51 ? t49 : t55) * t67;
    const float frame_0_x = t10 * t27;
    const float frame_0_y = t11 * t27;
    const float frame_0_z = t12 * t27;
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
    if (t43) {
        const float t68 = sqrtf(t41);
        const float t69 = t60 + t56;
        const float t70 = 1.0f / (t60 * t69);
        const float t71 = t70 * t69;
        const float t72 = t56 * t71;
        const float t73 = t68 * t71;
        const float t74 = fabsf(t37) * t59;
        const float t75 = t74 * t72;
        const float t76 = t72 - 0.5f;
        const float t77 = t75 - 0.5f;
        const float t78 = t76 * t76;
        const float t79 = t77 * t77;
        const float t80 = fmaf(0.05430631f, t78, 0.080950715f);
        const float t81 = fmaf(t80, t78, 0.1684019f);
        const float t82 = fmaf(t81, t78, 0.32709444f);
        const float t83 = fmaf(t82, t78, 0.5987523f);
        const float t84 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t79, t80), t79, t81), t79, t82), t79, t83);
        const float t85 = fmaf(-0.026061837f, t78, -0.06372378f);
        const float t86 = fmaf(t85, t78, -0.11762552f);
        const float t87 = fmaf(t86, t78, -0.23594604f);
        const float t88 = fmaf(t87, t78, -0.44721135f);
        const float t89 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t79, t85), t79, t86), t79, t87), t79, t88);
        const float t90 = fmaf(t88, t78, -0.7754678f);
        const float t91 = fmaf(t90, t76, fmaf(t83, t78, 0.94559944f));
        const float t92 = fmaf(fmaf(t77, t89, t84), t76 + t77, t90);
        const float t93 = fmaf(t75, t92, t91);
        t_x = t72;
        t_y = t73;
        kappa = t74;
        cut = t75;
        shape = t91;
        shape_cut = fmaf(t75 - t72, t92, t91);
        norm = t93;
        width = t41 * t70;
        inv_cut_1 = t63 * t66;
        tau = t68 * t59;
        area = t73 * t73 * t73 * (spherecap_inline_min(t39, t40) * t59) * t93;
    }
    const float t94 = radius_sin * radius_sin;
    const float t95 = t94 * t62 * 3.1415927f + area;
    const bool t96 = elevation_sin < 0.0f;
    const float t97 = t96 ? area : t95;
    const float t98 = t96 ? t95 : area;
    const bool t99 = t25 && 9.8607613e-32f < t94;
    const float distance = t26 * unscale;
    const float solid_angle = t99 ? t94 * (t58 * t13) * 6.2831855f : 0.0f;
    const float projected_above = (9.403955e-38f < t97 && t99) ? t97 : 0.0f;
    const float projected_below = (9.403955e-38f < t98 && t99) ? t98 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float inv_below = 0.0f < projected_below ? 1.0f / projected_below : 0.0f;
    const bool t100 = 0.0f < inv_above + inv_below;
    const bool t101 = 0.0f < elevation_sin;
    const float t102 = t101 ? inv_above : inv_below;
    const float t103 = t100 ? defensive : 0.0f < defensive || !t42 ? 1.0f : 0.0f;
    const bool t104 = 0.0f < tau;
    const bool t105 = t104 && 0.0f < t102;
    const float t106 = t_y * t_y * t_y * shape * t102;
    const float t107 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    float t108 = 0.0f;
    if (t104) {
        const float t109 = 1.0f + kappa;
        const float t110 = t109 * shape;
        const float t111 = 1.0f / (norm * t110);
        const float t112 = sqrtf(t111);
        const float t113 = norm * t112;
        const float t114 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t115 = t114 * t114;
        const float t116 = fmaf(fmaf(fmaf(-0.026061837f, t115, -0.06372378f), t115, -0.11762552f), t115, -0.23594604f);
        const float t117 = fmaf(fmaf(fmaf(0.05430631f, t115, 0.080950715f), t115, 0.1684019f), t115, 0.32709444f);
        const float t118 = fmaf(fmaf(fmaf(t116, t115, -0.44721135f), t115, -0.7754678f), t114, fmaf(fmaf(t117, t115, 0.5987523f), t115, 0.94559944f));
        const float t119 = t109 * t118 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t110 * t111);
        const float t120 = fmaf(t119, t110 * t112, -1.0f);
        const float t121 = 1.0f - t119;
        const float t122 = fmaf(fmaf(30.011856f, t120, fmaf(-41.541264f, t121, -37.009792f)), t120, fmaf(77.96775f, t121, 7.470758f));
        const float t123 = fmaf(t122, t120, fmaf(fmaf(-49.13454f, t121, -9.466533f), t121, -1.5877596f));
        const float t124 = fmaf(fmaf(fmaf(15.716111f, t121, 0.0f), t121, 9.961183f), t121, -2.61785f);
        const float t125 = t120 * fmaf(t123, t120, fmaf(t124, t121, 0.8681748f));
        const float t126 = fmaf(fmaf(7.295638f, t120, -7.236236f), t120, fmaf(fmaf(fmaf(-11.4868555f, t121, 0.0f), t121, 0.0f), t121, 3.1255686f));
        const float t127 = fmaf(fmaf(fmaf(13.728438f, t121, -7.981878f), t121, 2.025724f), t121, -0.7334958f);
        const float t128 = t120 * fmaf(t126, t120, t127);
        const float t129 = fmaf(fmaf(fmaf(9.986537f, t121, 25.22195f), t121, 0.0f), t121, -2.9581387f);
        const float t130 = fmaf(fmaf(fmaf(-19.722994f, t121, 4.6594768f), t121, -0.89538246f), t121, 0.5143498f);
        const float t131 = t120 * fmaf(fmaf(fmaf(-23.220068f, t121, 7.332055f), t120, t129), t120, t130);
        const float t132 = fmaf(fmaf(fmaf(1.946617f, t120, -3.077631f), t120, 1.4945927f), t120, -0.24140751f);
        const float t133 = t120 * t132;
        const float t134 = t120 * fmaf(fmaf(0.38173297f, t120, -0.30305624f), t120, 0.05897375f);
        const float t135 = 1.0f / (elevation_cos * elevation_cos);
        const float t136 = tau * tau;
        const float t137 = t136 * t135 / (1.0f + t_x);
        const float t138 = kappa - 0.5f;
        const float t139 = cut - 0.5f;
        const float t140 = t138 * t138;
        const float t141 = t139 * t139;
        const float t142 = fmaf(0.05430631f, t140, 0.080950715f);
        const float t143 = fmaf(t142, t140, 0.1684019f);
        const float t144 = fmaf(t143, t140, 0.32709444f);
        const float t145 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t141, t142), t141, t143), t141, t144), t141, fmaf(t144, t140, 0.5987523f));
        const float t146 = fmaf(-0.026061837f, t140, -0.06372378f);
        const float t147 = fmaf(t146, t140, -0.11762552f);
        const float t148 = fmaf(t147, t140, -0.23594604f);
        const float t149 = fmaf(t148, t140, -0.44721135f);
        const float t150 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t141, t146), t141, t147), t141, t148), t141, t149);
        const float t151 = fmaf(kappa * t137, fmaf(fmaf(t139, t150, t145), t138 + t139, fmaf(t149, t140, -0.7754678f)), fmaf(shape_cut, t137 - kappa * kappa, kappa) * t135);
        const float t152 = spherecap_inline_max(t136 * tau * (radius_cos + 1.0f) * t151 * 0.31830987f, 0.0f);
        coefficients_0 = t113;
        coefficients_1 = t119 - t113 + t125;
        coefficients_2 = t128 - t125;
        coefficients_3 = t131 - t128;
        coefficients_4 = t133 - t131;
        coefficients_5 = t134 - t133;
        coefficients_6 = -t134;
        t108 = spherecap_inline_min(t152, 0.5f);
    }
    const float share_above = 0.0f < inv_below ? (0.0f < inv_above ? (t101 ? 1.0f - t108 : t108) : 0.0f) : 1.0f;
    const bool t153 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f;
    const bool t154 = t153 && (t100 || (0.0f < t103 && 0.0f < solid_angle));
    spherecap_inline_both_light light;
    light.is_sampled = t154;
    light.solid_angle = t154 ? solid_angle : 0.0f;
    light.projected_solid_angle = t154 ? projected_above : 0.0f;
    light.frame_0[0] = frame_0_x;
    light.frame_0[1] = frame_0_y;
    light.frame_0[2] = frame_0_z;
    light.frame_1[0] = fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1[1] = fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1[2] = fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
    light.frame_2[0] = frame_2_x;
    light.frame_2[1] = frame_2_y;
    light.frame_2[2] = frame_2_z;
    light.normal[0] = normal_x;
    light.normal[1] = normal_y;
    light.normal[2] = normal_z;
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = t99 ? t57 * (inv_radius_sin * inv_radius_sin) * 0.15915494f : 0.0f;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_inline_max(t41 * (t27 * t27) * t66, -(radius_cos * t62));
    light.defensive = t103;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
    light.crescent_share = t105 ? t106 : 0.0f;
    light.inv_rest = t105 ? 1.0f / (1.0f - t106) : 1.0f;
    light.beyond = t105 ? t107 * t107 * t107 * shape_cut : 0.0f;
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
    float side = 0.0f;
    float t60 = 0.0f;
    if (t14) {
        const float t61 = t21 < 0.0f ? t55 : t56;
        float t62 = 0.0f;
        float t63 = 0.0f;
        float t64 = 0.0f;
        if (t5) {
            const float t65 = light->solid_angle * 0.15915494f;
            const float t66 = t65 * (1.0f - t57 * t17);
            const float t67 = sqrtf(t65 * (2.0f - t66));
            const float t68 = (t61 - 1.0f) * t67;
            t62 = t68;
            t63 = t58 * t16 * t67;
            t64 = fmaf(light->elevation_sin, 1.0f - t66, light->elevation_cos * t68);
        } else {
            const float t69 = light->radius_sin * light->elevation_cos;
            const float t70 = 1.0f - t61;
            const float t71 = t57 * t17;
            const float t72 = spherecap_inline_max(fmaf(t69, t61, -light->rise), 0.0f);
            const float t73 = sqrtf(fmaf(t72, t72, light->radius_sin * light->radius_sin * t71));
            const float t74 = t1 * light->radius_cos;
            const float t75 = fmaf(light->elevation_cos * t70, fmaf(t69, t70, -2.0f * t74), light->radius_sin * t71);
            const float t76 = light->radius_sin * fmaf(light->elevation_cos, t75 / (t73 + t74), -(t1 * t1 * t70));
            t62 = t76;
            t63 = light->radius_sin * t58 * t16;
            t64 = t73;
        }
        t59 = t62;
        side = t63;
        t60 = t64;
    } else {
        const float t77 = t58 * t21;
        t59 = fmaf(light->elevation_cos, t77, -((t12 ? t1 : -t1) * (1.0f - t55)));
        side = t58 * t16;
        t60 = t77;
    }
    const float t78 = t9 ? 1.0f : -1.0f;
    const float zenith = t59 * t78;
    const float cosine = t60 * t78;
    const float t79 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t80 = 0.0f < cosine ? light->inv_above * light->share_above : cosine < 0.0f ? light->inv_below * t10 : 0.0f;
    float t81 = 0.0f;
    float t82 = 0.0f;
    if (0.0f < light->defensive) {
        const float t83 = light->defensive * light->inv_solid_angle;
        const float t84 = spherecap_inline_min(t83 / spherecap_inline_max(t79, 1.1754944e-38f), 3.4028235e38f);
        t81 = fmaf(t80, t6 * t79, t83);
        t82 = spherecap_inline_min(fmaf(t80, t6, t84), 3.4028235e38f);
    } else {
        t81 = t80 * t79;
        t82 = t80;
    }
    const float t85 = fmaf(zenith, zenith, side * side);
    const float t86 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t85), 0.0f);
    const float t87 = sqrtf(t86);
    const float t88 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t86));
    const float t89 = light->radius_cos * light->radius_cos / (t88 + t87);
    const float t90 = fmaf(light->frame_0[0], t88, fmaf(light->frame_1[0], zenith, light->frame_2[0] * side));
    const float t91 = fmaf(light->frame_0[1], t88, fmaf(light->frame_1[1], zenith, light->frame_2[1] * side));
    const float t92 = fmaf(light->frame_0[2], t88, fmaf(light->frame_1[2], zenith, light->frame_2[2] * side));
    const float t93 = t89 * light->inv_radius_sin;
    const float t94 = -fmaf(t88, t87, t85) * light->inv_radius_sin;
    const float t95 = t93 * zenith;
    const float t96 = t93 * side;
    const float t97 = fmaf(light->frame_0[0], t94, fmaf(light->frame_1[0], t95, light->frame_2[0] * t96));
    const float t98 = fmaf(light->frame_0[1], t94, fmaf(light->frame_1[1], t95, light->frame_2[1] * t96));
    const float t99 = fmaf(light->frame_0[2], t94, fmaf(light->frame_1[2], t95, light->frame_2[2] * t96));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t90;
    sampled.direction[1] = t91;
    sampled.direction[2] = t92;
    sampled.distance = t89 * light->distance;
    sampled.normal[0] = t97;
    sampled.normal[1] = t98;
    sampled.normal[2] = t99;
    sampled.cosine = cosine;
    sampled.pdf = t81;
    sampled.projected_pdf = t82;
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
    const float t1 = fmaf(light->frame_0[0], direction[0], fmaf(light->frame_0[1], direction[1], light->frame_0[2] * direction[2]));
    const float t2 = fmaf(light->frame_1[0], direction[0], fmaf(light->frame_1[1], direction[1], light->frame_1[2] * direction[2]));
    const float t3 = fmaf(light->frame_2[0], direction[0], fmaf(light->frame_2[1], direction[1], light->frame_2[2] * direction[2]));
    const float t4 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
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
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
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
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t11, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t12 = centre[0] * scale;
    const float t13 = centre[1] * scale;
    const float t14 = centre[2] * scale;
    const float t15 = radius * scale;
    const float t16 = sqrtf(fmaf(t12, t12, fmaf(t13, t13, t14 * t14)));
    const float t17 = 1.0f / t16;
    const float t18 = t15 * t17;
    const float t19 = t18 * t18;
    const float t20 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t21 = 0.0f <= defensive && defensive <= 1.0f && t20 <= 2.0f && 0.0f < radius && t16 * unscale <= 3.4028235e38f;
    const float t22 = fmaf(t2, t12, fmaf(t3, t13, t4 * t14));
    const float t23 = spherecap_inline_max(fmaf(-t19, t19, 0.9999981f), 0.0f);
    const float t24 = fmaf(t22, t17, 2.3841858e-7f);
    const float t25 = fmaf(t22 + t15, t17, 2.3841858e-7f);
    const float t26 = t18 <= t24 ? t24 : 0.0f < t25 ? t25 * t25 / (fmaf(t18 - t24, t23, t25) * 2.0f) : 0.0f;
    const float t27 = fmaf(-t22, t17, 2.3841858e-7f);
    const float t28 = fmaf(-t22 + t15, t17, 2.3841858e-7f);
    const float t29 = t18 <= t27 ? t27 : 0.0f < t28 ? t28 * t28 / (fmaf(t18 - t27, t23, t28) * 2.0f) : 0.0f;
    const float t30 = t26 + t29;
    const float t31 = t20 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t30, t30);
    const bool t32 = t19 <= 1.0000019f && 4.9303807e-32f < t19 && t21 && 0.0f < strength && strength <= 3.4028235e38f;
    const float t33 = spherecap_inline_min(spherecap_inline_max(t19 * t31 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (t32 && (0.0f < t31 || 0.0f < defensive)) ? t33 : 0.0f;
}


#endif
