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
// multiply-adds: without them each is a call; and with -fno-math-errno, or each square root is checked for errors. With
// -ffp-contract=off all results are those of the library to the bit; without it, densities are within 3e-7 of them, and of
// `both`, whose smaller side has what the larger leaves, within 1e-5.

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
    const spherecap_inline_sample result = {
        {0.0f, 0.0f, 0.0f}, 0.0f, {0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 0.0f
    };
    return result;
}

// A point on a surface that is lit from the front. The normal must be of unit length to single precision.
typedef struct spherecap_inline_surface_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float towards_centre[3];
    float sideways[3];
    float normal[3];
    float distance;
    float radius_sin;
    float radius_cos;
    float elevation_sin;
    float elevation_cos;
    float tau;
    float kappa;
    float width;
    float cut;
    float rise;
    float inv_above;
    float third_axis[3];
    float crescent_share;
    float inv_rest;
    float beyond;
    float middle;
    float half_axis;
    float climb;
    float b_0;
    float b_1;
    float b_2;
    float b_3;
    float b_4;
    float b_5;
    float b_6;
} spherecap_inline_surface_light;

static inline spherecap_inline_surface_light spherecap_inline_surface_prepare(const float normal[3], const float centre[3], float radius)
{
    const float t1 = fmaf(centre[0], centre[0], fmaf(centre[1], centre[1], centre[2] * centre[2]));
    const bool t2 = t1 < 1099511600000.0f && 9.536743e-7f < radius;
    const float t3 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t3, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t4 = t2 ? 1.0f : scale;
    const float t5 = centre[0] * t4;
    const float t6 = centre[1] * t4;
    const float t7 = centre[2] * t4;
    const float t8 = radius * t4;
    const float t9 = t7 * t7;
    const float t10 = fmaf(t5, t5, fmaf(t6, t6, t9));
    const float t11 = fmaf(-t8, t8, t10);
    float t12, t13;
    if (t11 < t10 * 0.25f) {
        const float t14 = t5 * t5;
        const float t15 = t6 * t6;
        const float t16 = t14 + t15;
        const float t17 = t16 - t14;
        t12 = t16 + t9;
        const float t18 = t12 - t16;
        const float t19 = spherecap_inline_lost(t5, t5, t14) + spherecap_inline_lost(t6, t6, t15) + spherecap_inline_lost(t7, t7, t9);
        const float t20 = t19 + (t14 - (t16 - t17) + (t15 - t17) + (t16 - (t12 - t18) + (t9 - t18)));
        t13 = fmaf(-t8, t8, t12) + t20;
    } else {
        t12 = t10;
        t13 = t11;
    }
    const float t21 = normal[2] * t6;
    const float t22 = fmaf(normal[1], t7, -t21);
    const float t23 = normal[0] * t7;
    const float t24 = fmaf(normal[2], t5, -t23);
    const float t25 = normal[1] * t5;
    const float t26 = fmaf(normal[0], t6, -t25);
    const float t27 = fmaf(t22, t22, fmaf(t24, t24, t26 * t26));
    float t28, t29, t30, t31, t32;
    if (t27 < t12 * 0.015625f) {
        const float t33 = t22 - spherecap_inline_lost(normal[2], t6, t21);
        const float t34 = t24 - spherecap_inline_lost(normal[0], t7, t23);
        const float t35 = t26 - spherecap_inline_lost(normal[1], t5, t25);
        const float t36 = fmaf(t33, t33, fmaf(t34, t34, t35 * t35));
        const bool t37 = t36 < t12 * 5.169879e-26f;
        const bool t38 = fabsf(t5) < fabsf(t7);
        const float t39 = t38 ? 0.0f : -t6;
        const float t40 = t38 ? -t7 : t5;
        const float t41 = t38 ? t6 : 0.0f;
        const float t42 = sqrtf(t36);
        t28 = t37 ? t39 : t33;
        t29 = t37 ? t40 : t34;
        t30 = t37 ? t41 : t35;
        t31 = t37 ? sqrtf(fmaf(t39, t39, fmaf(t40, t40, t41 * t41))) : t42;
        t32 = t37 ? 0.0f : t42;
    } else {
        t31 = sqrtf(t27);
        t28 = t22;
        t29 = t24;
        t30 = t26;
        t32 = t31;
    }
    const float t43 = normal[0] * t5;
    const float t44 = normal[1] * t6;
    const float t45 = normal[2] * t7;
    const float t46 = t43 + t44;
    const float t47 = t46 - t43;
    const float t48 = t46 + t45;
    const float t49 = t48 - t46;
    const float t50 = spherecap_inline_lost(normal[0], t5, t43) + spherecap_inline_lost(normal[1], t6, t44);
    const float t51 = t50 + spherecap_inline_lost(normal[2], t7, t45) + (t43 - (t46 - t47) + (t44 - t47) + (t46 - (t48 - t49) + (t45 - t49)));
    const float t52 = t48 + t51;
    const float t53 = t51 - (t52 - t48);
    const float t54 = t8 - t52 - t53;
    const float t55 = t8 + t52 + t53;
    const float t56 = t54 * t55;
    const float t57 = sqrtf(t12);
    const float t58 = 1.0f / t57;
    const float t59 = sqrtf(t13);
    const float elevation_sin = t52 * t58;
    const bool t60 = 0.0f < t13;
    const bool t61 = 0.0f < t56 && t60;
    const bool t62 = 0.0f < elevation_sin;
    float t63;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (t61) {
        t63 = sqrtf(t13 + t56);
        const float t64 = sqrtf(t56);
        const float t65 = 1.0f / (t63 * t8);
        const float t66 = t65 * t8;
        const float t67 = t65 * t63;
        t_x = t59 * t66;
        t_y = t64 * t66;
        const float t68 = t_y * t_y;
        kappa = fabsf(t52) * t67;
        cut = kappa * t_x;
        const float t69 = t_x - 0.5f;
        const float t70 = cut - 0.5f;
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
        shape = fmaf(t83, t69, fmaf(t76, t71, 0.94559944f));
        shape_difference = fmaf(fmaf(t70, t82, t77), t69 + t70, t83);
        norm = fmaf(cut, shape_difference, shape);
        width = t68 / (1.0f + t_x);
        tau = t64 * t67;
        area = t68 * t_y * (spherecap_inline_min(t54, t55) * t67) * norm;
    } else {
        t63 = t32;
    }
    const float radius_sin = t8 * t58;
    const float radius_cos = t59 * t58;
    const float elevation_cos = t63 * t58;
    const float t84 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t56 * (t58 * t58) / fmaf(radius_cos, t84, climb), -(radius_cos * t84));
    const float t85 = radius_sin * radius_sin;
    const float t86 = t62 ? fmaf(t85 * t84, 3.1415927f, area) : area;
    const bool t87 = 9.8607613e-32f < t85;
    const float t88 = 1.0f / t31;
    const float sideways_x = t28 * t88;
    const float sideways_y = t29 * t88;
    const float sideways_z = t30 * t88;
    const float distance = t57 * (t2 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t86 && t87 && t60) ? t86 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float t89 = t62 ? inv_above : 0.0f;
    const bool t90 = t61 && t62 && 0.0f < t89;
    const float t91 = t_y * t_y * t_y * shape * t89;
    const float t92 = t_y / radius_sin;
    const float t93 = t92 * t92 * t92 * (fmaf(cut - t_x, shape_difference, shape) * 0.53033006f);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t61 && !t62) {
        const float t94 = 1.0f + kappa;
        const float t95 = t94 * shape;
        const float t96 = 1.0f / (norm * t95);
        const float t97 = sqrtf(t96);
        b_0 = norm * t97;
        const float t98 = 1.0f / (1.0f + cut);
        const float t99 = (t_x + kappa) * t98 - 0.5f;
        const float t100 = t99 * t99 * t99;
        const float t101 = fmaf(fmaf(fmaf(-0.026061837f, t99, 0.05430631f), t99, -0.06372378f), t100, fmaf(fmaf(0.080950715f, t99, -0.11762552f), t99, 0.1684019f));
        const float t102 = fmaf(t101, t100, fmaf(fmaf(-0.23594604f, t99, 0.32709444f), t99, -0.44721135f));
        const float t103 = fmaf(t102, t100, fmaf(fmaf(0.5987523f, t99, -0.7754678f), t99, 0.94559944f));
        const float t104 = t94 * t103 * (t98 * t98 * t98) * (t95 * t96);
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
        b_1 = t104 - b_0 + t110;
        b_2 = t113 - t110;
        b_3 = t116 - t113;
        b_4 = t118 - t116;
        b_5 = t119 - t118;
        b_6 = -t119;
    }
    const bool t120 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    const float t121 = ((0.0f < radius_cos && t87) ? t85 / (1.0f + radius_cos) : 0.0f) * 6.2831855f;
    const spherecap_inline_surface_light result = {
        t120, t120 ? t121 : 0.0f, t120 ? projected_above : 0.0f, {t5 * t58, t6 * t58, t7 * t58},
        {sideways_x, sideways_y, sideways_z}, {normal[0], normal[1], normal[2]}, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, inv_above,
        {fmaf(sideways_y, normal[2], -(sideways_z * normal[1])), fmaf(sideways_z, normal[0], -(sideways_x * normal[2])), fmaf(sideways_x, normal[1], -(sideways_y * normal[0]))},
        t90 ? t91 : 0.0f, t90 ? 1.0f / (1.0f - t91) : 1.0f, t90 ? t93 : 0.0f, elevation_cos * radius_cos,
        radius_sin * t84, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

static inline spherecap_inline_sample spherecap_inline_surface_sample(const spherecap_inline_surface_light *light, float u0, float u1)
{
    if (!light->is_sampled) {
        return spherecap_inline_no_sample();
    }
    const float t1 = fabsf(light->elevation_sin);
    const bool t2 = 0.0f < light->tau;
    const float t3 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = !(0.0f < light->elevation_sin) && t2;
    const bool t6 = light->crescent_share <= t3 && !t5;
    const bool t7 = !t2 || t6;
    const float t8 = 1.0f - t4;
    const float t9 = t4 - t8;
    const float t10 = 4.0f * t4 * t8;
    const float t11 = spherecap_inline_max((t3 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
    const float t12 = t2 ? spherecap_inline_min(t11, 0.99999994f) : t3;
    const float t13 = t2 ? light->beyond : 0.0f;
    const float t14 = 1.6660811f - t13;
    const float t15 = fmaf(t12, t14, t13);
    const float t16 = (1.0f - t12) * t14;
    float t18, t19, t20;
    float t17 = 0.0f;
    if (t7) {
        t18 = spherecap_inline_min(t15, t16);
        t19 = 1.0f;
        t20 = 1.0f;
    } else {
        const float t21 = sqrtf(t10);
        const float t22 = fmaf(fmaf(fmaf(light->b_6, t10, light->b_4), t10, light->b_2), t10, light->b_0);
        const float t23 = t21 * fmaf(fmaf(fmaf(light->b_5, t10, light->b_3), t10, light->b_1), t21, t22);
        const float t24 = sqrtf(fmaf(t9, t9, t23 * t23));
        const float t25 = light->tau * t23;
        t20 = t5 ? fmaf(t9, t9, t25 * t25) : 1.0f;
        const float t26 = t5 ? fmaf(light->kappa, t23, t24) * fmaf(light->cut, t23, t24) : light->crescent_share;
        const float t27 = (t5 ? light->width : t3) / t26;
        const float t28 = spherecap_inline_min(spherecap_inline_max(t27, 5.9604645e-8f), 0.99999994f);
        const float t29 = t5 ? t27 : light->width;
        const float t30 = t20 * t29;
        const float t31 = fmaf(fmaf(fmaf(-0.00060778117f, t30, 1.0676054e-5f), t30, -0.0027203285f), t30 * t30 * t30, fmaf(fmaf(-0.011332183f, t30, -0.10000902f), t30, 1.0000001f));
        t17 = t5 ? t25 : t21;
        t18 = t5 ? t3 : t28;
        t19 = t29 * t31;
    }
    const float t32 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t18), -0.33333334f, 1419900500.0f));
    const float t33 = t18 * t32;
    const float t34 = fmaf(-t33, t32 * t32, 1.0f);
    const float t35 = t34 * t34;
    const float t36 = fmaf(fmaf(0.12666093f, t35, fmaf(0.14565912f, t34, 0.17283025f)), t35, fmaf(0.22221696f, t34, 0.33333334f));
    const float t37 = t19 * fmaf(t33 * t34, t36, t33);
    const float t38 = t37 * t20;
    const float t39 = t38 * t38 * t38;
    const float t40 = fmaf(fmaf(fmaf(0.022114987f, t38, -0.063446075f), t38, 0.085662976f), t39, fmaf(fmaf(-0.056249518f, t38, 0.030445365f), t38, 0.0074712755f));
    const float t41 = fmaf(t40, t39, fmaf(fmaf(0.03209764f, t38, 0.09996679f), t38, 1.0000004f));
    const float t42 = t37 * t41;
    const float t43 = t7 ? spherecap_inline_min(t42, 1.0f) : t42;
    const float t44 = t20 * t43;
    const float t45 = 2.0f - t44;
    const float t46 = t43 * t45;
    const float t47 = sqrtf(t46);
    float zenith, side, cosine, t48;
    if (t7) {
        const float t49 = t15 - t16 < 0.0f ? t44 : t45;
        const float t50 = 1.0f - t49;
        const float t51 = light->radius_sin * light->radius_sin * t10;
        const float t52 = spherecap_inline_max(fmaf(light->climb, t49, -light->rise), 0.0f);
        cosine = sqrtf(fmaf(t46, t51, t52 * t52));
        const float t53 = t1 * light->radius_cos;
        const float t54 = light->climb * t50;
        zenith = fmaf(light->elevation_cos, fmaf(t54, t54 - 2.0f * t53, t46 * t51) / (cosine + t53), -(light->half_axis * t1 * t50));
        side = light->radius_sin * t47 * t9;
        t48 = fmaf(light->half_axis, t50, light->middle);
    } else {
        cosine = t47 * t17;
        t48 = 1.0f - t44;
        zenith = fmaf(light->elevation_cos, cosine, -((t5 ? -t1 : t1) * t48));
        side = t47 * t9;
    }
    const float t55 = light->inv_above * spherecap_inline_min(spherecap_inline_max(cosine, 0.0f), 3.4028235e38f);
    const float t56 = fmaf(zenith, zenith, side * side);
    const float t57 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t56), 0.0f);
    const float t58 = sqrtf(t57);
    const float t59 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t57));
    const float t60 = light->radius_cos * light->radius_cos / (t59 + t58);
    const float t61 = 1.0f / light->radius_sin;
    const float t62 = t60 * t61;
    const float t63 = -fmaf(t59, t58, t56) * t61;
    const float t64 = t62 * zenith;
    const float t65 = t62 * side;
    const float t66 = fmaf(light->third_axis[0], t48, fmaf(light->sideways[0], side, light->normal[0] * cosine));
    const float t67 = fmaf(light->third_axis[1], t48, fmaf(light->sideways[1], side, light->normal[1] * cosine));
    const float t68 = fmaf(light->third_axis[2], t48, fmaf(light->sideways[2], side, light->normal[2] * cosine));
    const float t69 = fmaf(light->elevation_cos, t63, -(light->elevation_sin * t64));
    const float t70 = fmaf(light->elevation_sin, t63, light->elevation_cos * t64);
    const float t71 = fmaf(light->third_axis[0], t69, fmaf(light->sideways[0], t65, light->normal[0] * t70));
    const float t72 = fmaf(light->third_axis[1], t69, fmaf(light->sideways[1], t65, light->normal[1] * t70));
    const float t73 = fmaf(light->third_axis[2], t69, fmaf(light->sideways[2], t65, light->normal[2] * t70));
    const spherecap_inline_sample result = {
        {t66, t67, t68}, t60 * light->distance, {t71, t72, t73}, cosine, t55,
        0.0f < cosine ? light->inv_above : 0.0f
    };
    return result;
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
    const float t1 = fmaf(light->towards_centre[1], direction[1], light->towards_centre[2] * direction[2]);
    const float t2 = fmaf(light->towards_centre[1], light->sideways[2], -(light->towards_centre[2] * light->sideways[1]));
    const float t3 = fmaf(light->towards_centre[2], light->sideways[0], -(light->towards_centre[0] * light->sideways[2]));
    const float t4 = fmaf(light->towards_centre[0], light->sideways[1], -(light->towards_centre[1] * light->sideways[0]));
    const float t5 = fmaf(light->sideways[1], direction[1], light->sideways[2] * direction[2]);
    const float t6 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const bool t7 = fmaf(light->towards_centre[0], direction[0], t1) < 0.0f;
    const float t8 = t7 ? 1.0f : fmaf(t2, direction[0], fmaf(t3, direction[1], t4 * direction[2]));
    const float t9 = t7 ? 1.0f : fmaf(light->sideways[0], direction[0], t5);
    const float t10 = light->inv_above * spherecap_inline_min(spherecap_inline_max(t6, 0.0f), 3.4028235e38f);
    const bool t11 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t12 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? t10 : 0.0f) : 0.0f;
}

static inline float spherecap_inline_surface_pdf_on_sphere(const spherecap_inline_surface_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const float t2 = light->inv_above * spherecap_inline_min(spherecap_inline_max(t1, 0.0f), 3.4028235e38f);
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
    float towards_centre[3];
    float sideways[3];
    float normal[3];
    float up[3];
    float on_surface;
    float distance;
    float radius_sin;
    float radius_cos;
    float elevation_sin;
    float elevation_cos;
    float tau;
    float kappa;
    float width;
    float cut;
    float rise;
    float share;
    float rest;
    float requested;
    float inv_above;
    float third_axis[3];
    float height;
    float inv_solid_angle;
    float crescent_share;
    float inv_rest;
    float beyond;
    float middle;
    float half_axis;
    float climb;
    float b_0;
    float b_1;
    float b_2;
    float b_3;
    float b_4;
    float b_5;
    float b_6;
} spherecap_inline_front_light;

static inline spherecap_inline_front_light spherecap_inline_front_prepare(const float normal[3], const float centre[3], float radius, float defensive)
{
    const float t1 = fmaf(normal[0], normal[0], fmaf(normal[1], normal[1], normal[2] * normal[2]));
    float normal_x, normal_y, normal_z;
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
    const float t9 = fmaf(centre[0], centre[0], fmaf(centre[1], centre[1], centre[2] * centre[2]));
    const bool t10 = t9 < 1099511600000.0f && 9.536743e-7f < radius;
    const float t11 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t11, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t12 = t10 ? 1.0f : scale;
    const float t13 = centre[0] * t12;
    const float t14 = centre[1] * t12;
    const float t15 = centre[2] * t12;
    const float t16 = radius * t12;
    const float t17 = t15 * t15;
    const float t18 = fmaf(t13, t13, fmaf(t14, t14, t17));
    const float t19 = fmaf(-t16, t16, t18);
    float t20, t21;
    if (t19 < t18 * 0.25f) {
        const float t22 = t13 * t13;
        const float t23 = t14 * t14;
        const float t24 = t22 + t23;
        const float t25 = t24 - t22;
        t20 = t24 + t17;
        const float t26 = t20 - t24;
        const float t27 = spherecap_inline_lost(t13, t13, t22) + spherecap_inline_lost(t14, t14, t23);
        const float t28 = t27 + spherecap_inline_lost(t15, t15, t17) + (t22 - (t24 - t25) + (t23 - t25) + (t24 - (t20 - t26) + (t17 - t26)));
        t21 = fmaf(-t16, t16, t20) + t28;
    } else {
        t20 = t18;
        t21 = t19;
    }
    const float t29 = normal_z * t14;
    const float t30 = fmaf(normal_y, t15, -t29);
    const float t31 = normal_x * t15;
    const float t32 = fmaf(normal_z, t13, -t31);
    const float t33 = normal_y * t13;
    const float t34 = fmaf(normal_x, t14, -t33);
    const float t35 = fmaf(t30, t30, fmaf(t32, t32, t34 * t34));
    float up_x, up_y, up_z, t36, t37, t38, t39, t40;
    if (t35 < t20 * 0.015625f) {
        const float t41 = t30 - spherecap_inline_lost(normal_z, t14, t29);
        const float t42 = t32 - spherecap_inline_lost(normal_x, t15, t31);
        const float t43 = t34 - spherecap_inline_lost(normal_y, t13, t33);
        const float t44 = fmaf(t41, t41, fmaf(t42, t42, t43 * t43));
        const bool t45 = 0.0f < t8;
        const bool t46 = t44 < t20 * 5.169879e-26f;
        const bool t47 = fabsf(t13) < fabsf(t15);
        const float t48 = t47 ? 0.0f : -t14;
        const float t49 = t47 ? -t15 : t13;
        const float t50 = t47 ? t14 : 0.0f;
        const float t51 = sqrtf(fmaf(t48, t48, fmaf(t49, t49, t50 * t50)));
        const float t52 = sqrtf(t20);
        const float t53 = t52 * t51;
        const float t54 = sqrtf(t44);
        up_x = t46 ? (t45 ? normal_x : fmaf(t14, t50, -(t15 * t49)) / t53) : normal_x;
        up_y = t46 ? (t45 ? normal_y : fmaf(t15, t48, -(t13 * t50)) / t53) : normal_y;
        up_z = t46 ? (t45 ? normal_z : fmaf(t13, t49, -(t14 * t48)) / t53) : normal_z;
        t36 = t46 ? t48 : t41;
        t37 = t46 ? t49 : t42;
        t38 = t46 ? t50 : t43;
        t39 = t46 ? t51 : t54;
        t40 = t46 ? (t45 ? 0.0f : t52) : t54;
    } else {
        t39 = sqrtf(t35);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t36 = t30;
        t37 = t32;
        t38 = t34;
        t40 = t39;
    }
    const bool t55 = 0.0f < t8;
    const float t56 = normal_x * t13;
    const float t57 = normal_y * t14;
    const float t58 = normal_z * t15;
    const float t59 = t56 + t57;
    const float t60 = t59 - t56;
    const float t61 = t59 + t58;
    const float t62 = t61 - t59;
    const float t63 = spherecap_inline_lost(normal_x, t13, t56) + spherecap_inline_lost(normal_y, t14, t57);
    const float t64 = t63 + spherecap_inline_lost(normal_z, t15, t58) + (t56 - (t59 - t60) + (t57 - t60) + (t59 - (t61 - t62) + (t58 - t62)));
    const float t65 = t61 + t64;
    const float t66 = t64 - (t65 - t61);
    const float t67 = t16 - t65 - t66;
    const float t68 = t16 + t65 + t66;
    const float t69 = t67 * t68;
    const float t70 = sqrtf(t20);
    const float t71 = 1.0f / t70;
    const float t72 = sqrtf(t21);
    const float elevation_sin = t65 * t71;
    const bool t73 = 0.0f < t21;
    const bool t74 = 0.0f < t69 && t55 && t73;
    const bool t75 = 0.0f < elevation_sin;
    float t76;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (t74) {
        t76 = sqrtf(t21 + t69);
        const float t77 = sqrtf(t69);
        const float t78 = 1.0f / (t76 * t16);
        const float t79 = t78 * t16;
        const float t80 = t78 * t76;
        t_x = t72 * t79;
        t_y = t77 * t79;
        const float t81 = t_y * t_y;
        kappa = fabsf(t65) * t80;
        cut = kappa * t_x;
        const float t82 = t_x - 0.5f;
        const float t83 = cut - 0.5f;
        const float t84 = t82 * t82;
        const float t85 = t83 * t83;
        const float t86 = fmaf(0.05430631f, t84, 0.080950715f);
        const float t87 = fmaf(t86, t84, 0.1684019f);
        const float t88 = fmaf(t87, t84, 0.32709444f);
        const float t89 = fmaf(t88, t84, 0.5987523f);
        const float t90 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t85, t86), t85, t87), t85, t88), t85, t89);
        const float t91 = fmaf(-0.026061837f, t84, -0.06372378f);
        const float t92 = fmaf(t91, t84, -0.11762552f);
        const float t93 = fmaf(t92, t84, -0.23594604f);
        const float t94 = fmaf(t93, t84, -0.44721135f);
        const float t95 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t85, t91), t85, t92), t85, t93), t85, t94);
        const float t96 = fmaf(t94, t84, -0.7754678f);
        shape = fmaf(t96, t82, fmaf(t89, t84, 0.94559944f));
        shape_difference = fmaf(fmaf(t83, t95, t90), t82 + t83, t96);
        norm = fmaf(cut, shape_difference, shape);
        width = t81 / (1.0f + t_x);
        tau = t77 * t80;
        area = t81 * t_y * (spherecap_inline_min(t67, t68) * t80) * norm;
    } else {
        t76 = t40;
    }
    const float radius_sin = t16 * t71;
    const float radius_cos = t72 * t71;
    const float elevation_cos = t76 * t71;
    const float t97 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t69 * (t71 * t71) / fmaf(radius_cos, t97, climb), -(radius_cos * t97));
    const float t98 = radius_sin * radius_sin;
    const float t99 = t75 ? fmaf(t98 * t97, 3.1415927f, area) : area;
    const bool t100 = 9.8607613e-32f < t98;
    const float t101 = 1.0f / t39;
    const float sideways_x = t36 * t101;
    const float sideways_y = t37 * t101;
    const float sideways_z = t38 * t101;
    const float on_surface = t55 ? 1.0f : 0.0f;
    const float distance = t70 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t99 && t100 && t73) ? t99 : 0.0f;
    const bool t102 = 0.0f < projected_above;
    const float inv_above = t102 ? 1.0f / projected_above : 0.0f;
    const float t103 = t75 ? inv_above : 0.0f;
    const bool t104 = t74 && t75 && 0.0f < t103;
    const float t105 = t_y * t_y * t_y * shape * t103;
    const float t106 = t_y / radius_sin;
    const float t107 = t106 * t106 * t106 * (fmaf(cut - t_x, shape_difference, shape) * 0.53033006f);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t74 && !t75) {
        const float t108 = 1.0f + kappa;
        const float t109 = t108 * shape;
        const float t110 = 1.0f / (norm * t109);
        const float t111 = sqrtf(t110);
        b_0 = norm * t111;
        const float t112 = 1.0f / (1.0f + cut);
        const float t113 = (t_x + kappa) * t112 - 0.5f;
        const float t114 = t113 * t113 * t113;
        const float t115 = fmaf(fmaf(fmaf(-0.026061837f, t113, 0.05430631f), t113, -0.06372378f), t114, fmaf(fmaf(0.080950715f, t113, -0.11762552f), t113, 0.1684019f));
        const float t116 = fmaf(t115, t114, fmaf(fmaf(-0.23594604f, t113, 0.32709444f), t113, -0.44721135f));
        const float t117 = fmaf(t116, t114, fmaf(fmaf(0.5987523f, t113, -0.7754678f), t113, 0.94559944f));
        const float t118 = t108 * t117 * (t112 * t112 * t112) * (t109 * t110);
        const float t119 = fmaf(t118, t109 * t111, -1.0f);
        const float t120 = 1.0f - t118;
        const float t121 = fmaf(fmaf(30.011856f, t119, fmaf(-41.541264f, t120, -37.009792f)), t119, fmaf(77.96775f, t120, 7.470758f));
        const float t122 = fmaf(t121, t119, fmaf(fmaf(-49.13454f, t120, -9.466533f), t120, -1.5877596f));
        const float t123 = fmaf(fmaf(fmaf(15.716111f, t120, 0.0f), t120, 9.961183f), t120, -2.61785f);
        const float t124 = t119 * fmaf(t122, t119, fmaf(t123, t120, 0.8681748f));
        const float t125 = fmaf(fmaf(7.295638f, t119, -7.236236f), t119, fmaf(fmaf(fmaf(-11.4868555f, t120, 0.0f), t120, 0.0f), t120, 3.1255686f));
        const float t126 = fmaf(fmaf(fmaf(13.728438f, t120, -7.981878f), t120, 2.025724f), t120, -0.7334958f);
        const float t127 = t119 * fmaf(t125, t119, t126);
        const float t128 = fmaf(fmaf(fmaf(9.986537f, t120, 25.22195f), t120, 0.0f), t120, -2.9581387f);
        const float t129 = fmaf(fmaf(fmaf(-19.722994f, t120, 4.6594768f), t120, -0.89538246f), t120, 0.5143498f);
        const float t130 = t119 * fmaf(fmaf(fmaf(-23.220068f, t120, 7.332055f), t119, t128), t119, t129);
        const float t131 = fmaf(fmaf(fmaf(1.946617f, t119, -3.077631f), t119, 1.4945927f), t119, -0.24140751f);
        const float t132 = t119 * t131;
        const float t133 = t119 * fmaf(fmaf(0.38173297f, t119, -0.30305624f), t119, 0.05897375f);
        b_1 = t118 - b_0 + t124;
        b_2 = t127 - t124;
        b_3 = t130 - t127;
        b_4 = t132 - t130;
        b_5 = t133 - t132;
        b_6 = -t133;
    }
    const float share = ((0.0f < defensive || !(0.0f < on_surface)) && !t102) ? 1.0f : defensive;
    const bool t134 = 0.0f < share;
    const float t135 = (0.0f < radius_cos && t100) ? t98 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t134 ? (0.0f < t135 ? 0.15915494f / t135 : 0.0f) : 0.0f;
    const bool t136 = 0.0f < inv_solid_angle && t134;
    const bool t137 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (0.0f < inv_above || t136);
    const spherecap_inline_front_light result = {
        t137, t137 ? t135 * 6.2831855f : 0.0f, t137 ? projected_above : 0.0f,
        {t13 * t71, t14 * t71, t15 * t71}, {sideways_x, sideways_y, sideways_z},
        {normal_x, normal_y, normal_z}, {up_x, up_y, up_z}, on_surface, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, share, 1.0f - share, defensive,
        inv_above,
        {fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))},
        t134 ? t135 : 0.0f, inv_solid_angle, t104 ? t105 : 0.0f, t104 ? 1.0f / (1.0f - t105) : 1.0f,
        t104 ? t107 : 0.0f, elevation_cos * radius_cos, radius_sin * t97, climb, b_0, b_1, b_2, b_3, b_4,
        b_5, b_6
    };
    return result;
}

static inline spherecap_inline_sample spherecap_inline_front_sample(const spherecap_inline_front_light *light, float u0, float u1)
{
    if (!light->is_sampled) {
        return spherecap_inline_no_sample();
    }
    const float t1 = fabsf(light->elevation_sin);
    const bool t2 = 0.0f < light->share;
    const float t3 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t3 < light->share && t2;
    const float t6 = spherecap_inline_max((t5 ? t3 : t3 - light->share) / (t5 ? light->share : light->rest), 5.9604645e-8f);
    const float t7 = (0.0f < light->requested && t2) ? spherecap_inline_min(t6, 0.99999994f) : t3;
    const bool t8 = !(0.0f < light->tau) || t5;
    const bool t9 = !(0.0f < light->elevation_sin) && !t8;
    const bool t10 = light->crescent_share <= t7 && !t9;
    const bool t11 = t8 || t10;
    const float t12 = 1.0f - t4;
    const float t13 = t4 - t12;
    const float t14 = 4.0f * t4 * t12;
    const float t15 = spherecap_inline_max((t7 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
    const float t16 = t8 ? t7 : spherecap_inline_min(t15, 0.99999994f);
    const float t17 = t8 ? 0.0f : light->beyond;
    const float t18 = 1.6660811f - t17;
    const float t19 = fmaf(t16, t18, t17);
    const float t20 = (1.0f - t16) * t18;
    float t22, t23, t24;
    float t21 = 0.0f;
    if (t11) {
        t22 = spherecap_inline_min(t19, t20);
        t23 = 1.0f;
        t24 = 1.0f;
    } else {
        const float t25 = sqrtf(t14);
        const float t26 = fmaf(fmaf(fmaf(light->b_6, t14, light->b_4), t14, light->b_2), t14, light->b_0);
        const float t27 = t25 * fmaf(fmaf(fmaf(light->b_5, t14, light->b_3), t14, light->b_1), t25, t26);
        const float t28 = sqrtf(fmaf(t13, t13, t27 * t27));
        const float t29 = light->tau * t27;
        t24 = t9 ? fmaf(t13, t13, t29 * t29) : 1.0f;
        const float t30 = t9 ? fmaf(light->kappa, t27, t28) * fmaf(light->cut, t27, t28) : light->crescent_share;
        const float t31 = (t9 ? light->width : t7) / t30;
        const float t32 = spherecap_inline_min(spherecap_inline_max(t31, 5.9604645e-8f), 0.99999994f);
        const float t33 = t9 ? t31 : light->width;
        const float t34 = t24 * t33;
        const float t35 = fmaf(fmaf(fmaf(-0.00060778117f, t34, 1.0676054e-5f), t34, -0.0027203285f), t34 * t34 * t34, fmaf(fmaf(-0.011332183f, t34, -0.10000902f), t34, 1.0000001f));
        t21 = t9 ? t29 : t25;
        t22 = t9 ? t7 : t32;
        t23 = t33 * t35;
    }
    const float t36 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t22), -0.33333334f, 1419900500.0f));
    const float t37 = t22 * t36;
    const float t38 = fmaf(-t37, t36 * t36, 1.0f);
    const float t39 = t38 * t38;
    const float t40 = fmaf(fmaf(0.12666093f, t39, fmaf(0.14565912f, t38, 0.17283025f)), t39, fmaf(0.22221696f, t38, 0.33333334f));
    const float t41 = t23 * fmaf(t37 * t38, t40, t37);
    const float t42 = t41 * t24;
    const float t43 = t42 * t42 * t42;
    const float t44 = fmaf(fmaf(fmaf(0.022114987f, t42, -0.063446075f), t42, 0.085662976f), t43, fmaf(fmaf(-0.056249518f, t42, 0.030445365f), t42, 0.0074712755f));
    const float t45 = fmaf(t44, t43, fmaf(fmaf(0.03209764f, t42, 0.09996679f), t42, 1.0000004f));
    const float t46 = t41 * t45;
    const float t47 = t11 ? spherecap_inline_min(t46, 1.0f) : t46;
    const float t48 = t24 * t47;
    const float t49 = 2.0f - t48;
    const float t50 = t47 * t49;
    const float t51 = sqrtf(t50);
    float zenith, side, cosine, t52, t53;
    if (t11) {
        const float t54 = t19 - t20 < 0.0f ? t48 : t49;
        if (t5) {
            const float t55 = light->height * (1.0f - t50 * t14);
            const float t56 = sqrtf(light->height * (2.0f - t55));
            zenith = (t54 - 1.0f) * t56;
            const float t57 = 1.0f - t55;
            t53 = fmaf(light->elevation_sin, t57, light->elevation_cos * zenith);
            t52 = fmaf(light->elevation_cos, t57, -(light->elevation_sin * zenith));
            side = t51 * t13 * t56;
            cosine = t53 * light->on_surface;
        } else {
            const float t58 = 1.0f - t54;
            const float t59 = light->radius_sin * light->radius_sin * t14;
            const float t60 = spherecap_inline_max(fmaf(light->climb, t54, -light->rise), 0.0f);
            t53 = sqrtf(fmaf(t50, t59, t60 * t60));
            const float t61 = t1 * light->radius_cos;
            const float t62 = light->climb * t58;
            zenith = fmaf(light->elevation_cos, fmaf(t62, t62 - 2.0f * t61, t50 * t59) / (t53 + t61), -(light->half_axis * t1 * t58));
            t52 = fmaf(light->half_axis, t58, light->middle);
            side = light->radius_sin * t51 * t13;
            cosine = t53;
        }
    } else {
        cosine = t51 * t21;
        t52 = 1.0f - t48;
        zenith = fmaf(light->elevation_cos, cosine, -((t9 ? -t1 : t1) * t52));
        side = t51 * t13;
        t53 = cosine;
    }
    const float t63 = light->share * light->inv_solid_angle;
    const float t64 = 0.0f < cosine ? light->inv_above : 0.0f;
    const float t65 = spherecap_inline_min(spherecap_inline_max(cosine, 0.0f), 3.4028235e38f);
    const float t66 = t2 ? fmaf(light->inv_above, light->rest * t65, t63) : light->inv_above * t65;
    const float t67 = spherecap_inline_max(spherecap_inline_min(fabsf(cosine), 3.4028235e38f), 1.1754944e-38f);
    const float t68 = spherecap_inline_min(fmaf(t64, light->rest, spherecap_inline_min(t63 / t67, 3.4028235e38f)), 3.4028235e38f);
    const float t69 = fmaf(zenith, zenith, side * side);
    const float t70 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t69), 0.0f);
    const float t71 = sqrtf(t70);
    const float t72 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t70));
    const float t73 = light->radius_cos * light->radius_cos / (t72 + t71);
    const float t74 = 1.0f / light->radius_sin;
    const float t75 = t73 * t74;
    const float t76 = -fmaf(t72, t71, t69) * t74;
    const float t77 = t75 * zenith;
    const float t78 = t75 * side;
    const float t79 = fmaf(light->third_axis[0], t52, fmaf(light->sideways[0], side, light->up[0] * t53));
    const float t80 = fmaf(light->third_axis[1], t52, fmaf(light->sideways[1], side, light->up[1] * t53));
    const float t81 = fmaf(light->third_axis[2], t52, fmaf(light->sideways[2], side, light->up[2] * t53));
    const float t82 = fmaf(light->elevation_cos, t76, -(light->elevation_sin * t77));
    const float t83 = fmaf(light->elevation_sin, t76, light->elevation_cos * t77);
    const float t84 = fmaf(light->third_axis[0], t82, fmaf(light->sideways[0], t78, light->up[0] * t83));
    const float t85 = fmaf(light->third_axis[1], t82, fmaf(light->sideways[1], t78, light->up[1] * t83));
    const float t86 = fmaf(light->third_axis[2], t82, fmaf(light->sideways[2], t78, light->up[2] * t83));
    const spherecap_inline_sample result = {
        {t79, t80, t81}, t73 * light->distance, {t84, t85, t86}, cosine, t66, t2 ? t68 : t64
    };
    return result;
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
    const float t1 = fmaf(light->towards_centre[1], direction[1], light->towards_centre[2] * direction[2]);
    const float t2 = fmaf(light->towards_centre[1], light->sideways[2], -(light->towards_centre[2] * light->sideways[1]));
    const float t3 = fmaf(light->towards_centre[2], light->sideways[0], -(light->towards_centre[0] * light->sideways[2]));
    const float t4 = fmaf(light->towards_centre[0], light->sideways[1], -(light->towards_centre[1] * light->sideways[0]));
    const float t5 = fmaf(light->sideways[1], direction[1], light->sideways[2] * direction[2]);
    const float t6 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const bool t7 = fmaf(light->towards_centre[0], direction[0], t1) < 0.0f;
    const float t8 = t7 ? 1.0f : fmaf(t2, direction[0], fmaf(t3, direction[1], t4 * direction[2]));
    const float t9 = t7 ? 1.0f : fmaf(light->sideways[0], direction[0], t5);
    const float t10 = spherecap_inline_min(spherecap_inline_max(t6, 0.0f), 3.4028235e38f);
    const float t11 = fmaf(light->inv_above, light->rest * t10, light->share * light->inv_solid_angle);
    const bool t12 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t13 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t14 = (0.998001f <= t13 && t13 <= 1.002001f) ? (t12 ? (0.0f < light->share ? t11 : light->inv_above * t10) : 0.0f) : 0.0f;
    return t14;
}

static inline float spherecap_inline_front_pdf_on_sphere(const spherecap_inline_front_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const float t2 = spherecap_inline_min(spherecap_inline_max(t1, 0.0f), 3.4028235e38f);
    const float t3 = fmaf(light->inv_above, light->rest * t2, light->share * light->inv_solid_angle);
    const float t4 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t5 = (0.998001f <= t4 && t4 <= 1.002001f) ? (0.0f < light->share ? t3 : light->inv_above * t2) : 0.0f;
    return t5;
}

static inline float spherecap_inline_front_importance(const float normal[3], const float centre[3], float radius, float defensive, float strength)
{
    const float t1 = fmaf(normal[0], normal[0], fmaf(normal[1], normal[1], normal[2] * normal[2]));
    float t2, t3, t4;
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
    const bool t28 = t19 <= 1.0000019f && 4.9303807e-32f < t19 && 0.0f < strength && t21 && strength <= 3.4028235e38f;
    const float t29 = spherecap_inline_min(spherecap_inline_max(t19 * t27 * strength, 1.1754944e-38f), 3.4028235e38f);
    return ((0.0f < t27 || 0.0f < defensive) && t28) ? t29 : 0.0f;
}


// The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.
typedef struct spherecap_inline_both_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float towards_centre[3];
    float sideways[3];
    float normal[3];
    float up[3];
    float on_surface;
    float distance;
    float radius_sin;
    float radius_cos;
    float elevation_sin;
    float elevation_cos;
    float tau;
    float kappa;
    float width;
    float cut;
    float rise;
    float defensive_share;
    float defensive_rest;
    float requested;
    float inv_above;
    float inv_below;
    float sides_share;
    float sides_rest;
    float third_axis[3];
    float height;
    float inv_solid_angle;
    float crescent_share;
    float inv_rest;
    float beyond;
    float middle;
    float half_axis;
    float climb;
    float b_0;
    float b_1;
    float b_2;
    float b_3;
    float b_4;
    float b_5;
    float b_6;
} spherecap_inline_both_light;

static inline spherecap_inline_both_light spherecap_inline_both_prepare(const float normal[3], const float centre[3], float radius, float defensive)
{
    const float t1 = fmaf(normal[0], normal[0], fmaf(normal[1], normal[1], normal[2] * normal[2]));
    float normal_x, normal_y, normal_z;
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
    const float t9 = fmaf(centre[0], centre[0], fmaf(centre[1], centre[1], centre[2] * centre[2]));
    const bool t10 = t9 < 1099511600000.0f && 9.536743e-7f < radius;
    const float t11 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t11, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t12 = t10 ? 1.0f : scale;
    const float t13 = centre[0] * t12;
    const float t14 = centre[1] * t12;
    const float t15 = centre[2] * t12;
    const float t16 = radius * t12;
    const float t17 = t15 * t15;
    const float t18 = fmaf(t13, t13, fmaf(t14, t14, t17));
    const float t19 = fmaf(-t16, t16, t18);
    float t20, t21;
    if (t19 < t18 * 0.25f) {
        const float t22 = t13 * t13;
        const float t23 = t14 * t14;
        const float t24 = t22 + t23;
        const float t25 = t24 - t22;
        t20 = t24 + t17;
        const float t26 = t20 - t24;
        const float t27 = spherecap_inline_lost(t13, t13, t22) + spherecap_inline_lost(t14, t14, t23);
        const float t28 = t27 + spherecap_inline_lost(t15, t15, t17) + (t22 - (t24 - t25) + (t23 - t25) + (t24 - (t20 - t26) + (t17 - t26)));
        t21 = fmaf(-t16, t16, t20) + t28;
    } else {
        t20 = t18;
        t21 = t19;
    }
    const float t29 = normal_z * t14;
    const float t30 = fmaf(normal_y, t15, -t29);
    const float t31 = normal_x * t15;
    const float t32 = fmaf(normal_z, t13, -t31);
    const float t33 = normal_y * t13;
    const float t34 = fmaf(normal_x, t14, -t33);
    const float t35 = fmaf(t30, t30, fmaf(t32, t32, t34 * t34));
    float up_x, up_y, up_z, t36, t37, t38, t39, t40;
    if (t35 < t20 * 0.015625f) {
        const float t41 = t30 - spherecap_inline_lost(normal_z, t14, t29);
        const float t42 = t32 - spherecap_inline_lost(normal_x, t15, t31);
        const float t43 = t34 - spherecap_inline_lost(normal_y, t13, t33);
        const float t44 = fmaf(t41, t41, fmaf(t42, t42, t43 * t43));
        const bool t45 = 0.0f < t8;
        const bool t46 = t44 < t20 * 5.169879e-26f;
        const bool t47 = fabsf(t13) < fabsf(t15);
        const float t48 = t47 ? 0.0f : -t14;
        const float t49 = t47 ? -t15 : t13;
        const float t50 = t47 ? t14 : 0.0f;
        const float t51 = sqrtf(fmaf(t48, t48, fmaf(t49, t49, t50 * t50)));
        const float t52 = sqrtf(t20);
        const float t53 = t52 * t51;
        const float t54 = sqrtf(t44);
        up_x = t46 ? (t45 ? normal_x : fmaf(t14, t50, -(t15 * t49)) / t53) : normal_x;
        up_y = t46 ? (t45 ? normal_y : fmaf(t15, t48, -(t13 * t50)) / t53) : normal_y;
        up_z = t46 ? (t45 ? normal_z : fmaf(t13, t49, -(t14 * t48)) / t53) : normal_z;
        t36 = t46 ? t48 : t41;
        t37 = t46 ? t49 : t42;
        t38 = t46 ? t50 : t43;
        t39 = t46 ? t51 : t54;
        t40 = t46 ? (t45 ? 0.0f : t52) : t54;
    } else {
        t39 = sqrtf(t35);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t36 = t30;
        t37 = t32;
        t38 = t34;
        t40 = t39;
    }
    const bool t55 = 0.0f < t8;
    const float t56 = normal_x * t13;
    const float t57 = normal_y * t14;
    const float t58 = normal_z * t15;
    const float t59 = t56 + t57;
    const float t60 = t59 - t56;
    const float t61 = t59 + t58;
    const float t62 = t61 - t59;
    const float t63 = spherecap_inline_lost(normal_x, t13, t56) + spherecap_inline_lost(normal_y, t14, t57);
    const float t64 = t63 + spherecap_inline_lost(normal_z, t15, t58) + (t56 - (t59 - t60) + (t57 - t60) + (t59 - (t61 - t62) + (t58 - t62)));
    const float t65 = t61 + t64;
    const float t66 = t64 - (t65 - t61);
    const float t67 = t16 - t65 - t66;
    const float t68 = t16 + t65 + t66;
    const float t69 = t67 * t68;
    const float t70 = sqrtf(t20);
    const float t71 = 1.0f / t70;
    const float t72 = sqrtf(t21);
    const float elevation_sin = t65 * t71;
    const bool t73 = 0.0f < t21;
    const bool t74 = 0.0f < t69 && t55 && t73;
    const bool t75 = 0.0f < elevation_sin;
    float t76;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (t74) {
        t76 = sqrtf(t21 + t69);
        const float t77 = sqrtf(t69);
        const float t78 = 1.0f / (t76 * t16);
        const float t79 = t78 * t16;
        const float t80 = t78 * t76;
        t_x = t72 * t79;
        t_y = t77 * t79;
        const float t81 = t_y * t_y;
        kappa = fabsf(t65) * t80;
        cut = kappa * t_x;
        const float t82 = t_x - 0.5f;
        const float t83 = cut - 0.5f;
        const float t84 = t82 * t82;
        const float t85 = t83 * t83;
        const float t86 = fmaf(0.05430631f, t84, 0.080950715f);
        const float t87 = fmaf(t86, t84, 0.1684019f);
        const float t88 = fmaf(t87, t84, 0.32709444f);
        const float t89 = fmaf(t88, t84, 0.5987523f);
        const float t90 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t85, t86), t85, t87), t85, t88), t85, t89);
        const float t91 = fmaf(-0.026061837f, t84, -0.06372378f);
        const float t92 = fmaf(t91, t84, -0.11762552f);
        const float t93 = fmaf(t92, t84, -0.23594604f);
        const float t94 = fmaf(t93, t84, -0.44721135f);
        const float t95 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t85, t91), t85, t92), t85, t93), t85, t94);
        const float t96 = fmaf(t94, t84, -0.7754678f);
        shape = fmaf(t96, t82, fmaf(t89, t84, 0.94559944f));
        shape_difference = fmaf(fmaf(t83, t95, t90), t82 + t83, t96);
        norm = fmaf(cut, shape_difference, shape);
        width = t81 / (1.0f + t_x);
        tau = t77 * t80;
        area = t81 * t_y * (spherecap_inline_min(t67, t68) * t80) * norm;
    } else {
        t76 = t40;
    }
    const float radius_sin = t16 * t71;
    const float radius_cos = t72 * t71;
    const float elevation_cos = t76 * t71;
    const float t97 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t69 * (t71 * t71) / fmaf(radius_cos, t97, climb), -(radius_cos * t97));
    const float t98 = radius_sin * radius_sin;
    const float t99 = fmaf(t98 * t97, 3.1415927f, area);
    const float t100 = t75 ? t99 : area;
    const float t101 = t75 ? area : t99;
    const bool t102 = 9.8607613e-32f < t98;
    const bool t103 = t102 && t73;
    const float t104 = 1.0f / t39;
    const float sideways_x = t36 * t104;
    const float sideways_y = t37 * t104;
    const float sideways_z = t38 * t104;
    const float on_surface = t55 ? 1.0f : 0.0f;
    const float distance = t70 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t100 && t103) ? t100 : 0.0f;
    const float projected_below = (9.403955e-38f < t101 && t103) ? t101 : 0.0f;
    const bool t105 = 0.0f < projected_above;
    const bool t106 = 0.0f < projected_below;
    const float inv_above = t105 ? 1.0f / projected_above : 0.0f;
    const float inv_below = t106 ? 1.0f / projected_below : 0.0f;
    const float t107 = t75 ? inv_above : inv_below;
    const bool t108 = 0.0f < t107 && t74;
    const float t109 = t_y * t_y * t_y * shape * t107;
    const float t110 = t_y / radius_sin;
    const float t111 = fmaf(cut - t_x, shape_difference, shape);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t74) {
        const float t112 = 1.0f + kappa;
        const float t113 = t112 * shape;
        const float t114 = 1.0f / (norm * t113);
        const float t115 = sqrtf(t114);
        b_0 = norm * t115;
        const float t116 = 1.0f / (1.0f + cut);
        const float t117 = (t_x + kappa) * t116 - 0.5f;
        const float t118 = t117 * t117 * t117;
        const float t119 = fmaf(fmaf(fmaf(-0.026061837f, t117, 0.05430631f), t117, -0.06372378f), t118, fmaf(fmaf(0.080950715f, t117, -0.11762552f), t117, 0.1684019f));
        const float t120 = fmaf(t119, t118, fmaf(fmaf(-0.23594604f, t117, 0.32709444f), t117, -0.44721135f));
        const float t121 = fmaf(t120, t118, fmaf(fmaf(0.5987523f, t117, -0.7754678f), t117, 0.94559944f));
        const float t122 = t112 * t121 * (t116 * t116 * t116) * (t113 * t114);
        const float t123 = fmaf(t122, t113 * t115, -1.0f);
        const float t124 = 1.0f - t122;
        const float t125 = fmaf(fmaf(30.011856f, t123, fmaf(-41.541264f, t124, -37.009792f)), t123, fmaf(77.96775f, t124, 7.470758f));
        const float t126 = fmaf(t125, t123, fmaf(fmaf(-49.13454f, t124, -9.466533f), t124, -1.5877596f));
        const float t127 = fmaf(fmaf(fmaf(15.716111f, t124, 0.0f), t124, 9.961183f), t124, -2.61785f);
        const float t128 = t123 * fmaf(t126, t123, fmaf(t127, t124, 0.8681748f));
        const float t129 = fmaf(fmaf(7.295638f, t123, -7.236236f), t123, fmaf(fmaf(fmaf(-11.4868555f, t124, 0.0f), t124, 0.0f), t124, 3.1255686f));
        const float t130 = fmaf(fmaf(fmaf(13.728438f, t124, -7.981878f), t124, 2.025724f), t124, -0.7334958f);
        const float t131 = t123 * fmaf(t129, t123, t130);
        const float t132 = fmaf(fmaf(fmaf(9.986537f, t124, 25.22195f), t124, 0.0f), t124, -2.9581387f);
        const float t133 = fmaf(fmaf(fmaf(-19.722994f, t124, 4.6594768f), t124, -0.89538246f), t124, 0.5143498f);
        const float t134 = t123 * fmaf(fmaf(fmaf(-23.220068f, t124, 7.332055f), t123, t132), t123, t133);
        const float t135 = fmaf(fmaf(fmaf(1.946617f, t123, -3.077631f), t123, 1.4945927f), t123, -0.24140751f);
        const float t136 = t123 * t135;
        const float t137 = t123 * fmaf(fmaf(0.38173297f, t123, -0.30305624f), t123, 0.05897375f);
        b_1 = t122 - b_0 + t128;
        b_2 = t131 - t128;
        b_3 = t134 - t131;
        b_4 = t136 - t134;
        b_5 = t137 - t136;
        b_6 = -t137;
    }
    const float defensive_share = (!(t105 || t106) && (0.0f < defensive || !(0.0f < on_surface))) ? 1.0f : defensive;
    const bool t138 = 0.0f < defensive_share;
    const float t139 = (0.0f < radius_cos && t102) ? t98 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t138 ? (0.0f < t139 ? 0.15915494f / t139 : 0.0f) : 0.0f;
    float t140 = 0.0f;
    if (0.0f < tau) {
        const float t141 = 1.0f / (elevation_cos * elevation_cos);
        const float t142 = tau * tau;
        const float t143 = t142 * t141 / (1.0f + t_x);
        const float t144 = kappa - 0.5f;
        const float t145 = cut - 0.5f;
        const float t146 = t144 * t144;
        const float t147 = t145 * t145;
        const float t148 = fmaf(0.05430631f, t146, 0.080950715f);
        const float t149 = fmaf(t148, t146, 0.1684019f);
        const float t150 = fmaf(t149, t146, 0.32709444f);
        const float t151 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t147, t148), t147, t149), t147, t150), t147, fmaf(t150, t146, 0.5987523f));
        const float t152 = fmaf(-0.026061837f, t146, -0.06372378f);
        const float t153 = fmaf(t152, t146, -0.11762552f);
        const float t154 = fmaf(t153, t146, -0.23594604f);
        const float t155 = fmaf(t154, t146, -0.44721135f);
        const float t156 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t147, t152), t147, t153), t147, t154), t147, t155);
        const float t157 = fmaf(kappa * t143, fmaf(fmaf(t145, t156, t151), t144 + t145, fmaf(t155, t146, -0.7754678f)), fmaf(t111, t143 - kappa * kappa, kappa) * t141);
        const float t158 = spherecap_inline_max(t142 * tau * (radius_cos + 1.0f) * t157 * 0.31830987f, 0.0f);
        t140 = spherecap_inline_min(t158, 0.5f);
    }
    const float t159 = 1.0f - t140;
    const bool t160 = 0.0f < inv_below;
    const bool t161 = 0.0f < inv_above;
    const bool t162 = 0.0f < inv_solid_angle && t138;
    const bool t163 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (0.0f < inv_above + inv_below || t162);
    const spherecap_inline_both_light result = {
        t163, t163 ? t139 * 6.2831855f : 0.0f, t163 ? projected_above : 0.0f,
        {t13 * t71, t14 * t71, t15 * t71}, {sideways_x, sideways_y, sideways_z},
        {normal_x, normal_y, normal_z}, {up_x, up_y, up_z}, on_surface, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, defensive_share, 1.0f - defensive_share,
        defensive, inv_above, inv_below, t160 ? (t161 ? (t75 ? t159 : t140) : 0.0f) : 1.0f,
        t161 ? (t160 ? (t75 ? t140 : t159) : 0.0f) : 1.0f,
        {fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))},
        t138 ? t139 : 0.0f, inv_solid_angle, t108 ? t109 : 0.0f, t108 ? 1.0f / (1.0f - t109) : 1.0f,
        t108 ? t110 * t110 * t110 * (t111 * 0.53033006f) : 0.0f, elevation_cos * radius_cos,
        radius_sin * t97, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

static inline spherecap_inline_sample spherecap_inline_both_sample(const spherecap_inline_both_light *light, float u0, float u1)
{
    if (!light->is_sampled) {
        return spherecap_inline_no_sample();
    }
    const bool t1 = 0.0f < light->elevation_sin;
    const float t2 = fabsf(light->elevation_sin);
    const bool t3 = 0.0f < light->defensive_share;
    const float t4 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = t4 < light->defensive_share && t3;
    const float t7 = (t6 ? t4 : t4 - light->defensive_share) / (t6 ? light->defensive_share : light->defensive_rest);
    const float t8 = spherecap_inline_min(spherecap_inline_max(t7, 5.9604645e-8f), 0.99999994f);
    const float t9 = (0.0f < light->requested && t3) ? t8 : t4;
    const bool t10 = t9 < light->sides_share || t6;
    const float t11 = (t10 ? t9 : t9 - light->sides_share) / (t10 ? light->sides_share : light->sides_rest);
    const float t12 = spherecap_inline_min(spherecap_inline_max(t11, 5.9604645e-8f), 0.99999994f);
    const bool t13 = t10 && t1;
    const bool t14 = !t10 && !t1;
    const float t15 = t6 ? t9 : t12;
    const bool t16 = !(0.0f < light->tau) || t6;
    const bool t17 = !(t13 || t14) && !t16;
    const bool t18 = light->crescent_share <= t15 && !t17;
    const bool t19 = t16 || t18;
    const float t20 = 1.0f - t5;
    const float t21 = t5 - t20;
    const float t22 = 4.0f * t5 * t20;
    const float t23 = spherecap_inline_max((t15 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
    const float t24 = t16 ? t15 : spherecap_inline_min(t23, 0.99999994f);
    const float t25 = t16 ? 0.0f : light->beyond;
    const float t26 = 1.6660811f - t25;
    const float t27 = fmaf(t24, t26, t25);
    const float t28 = (1.0f - t24) * t26;
    float t30, t31, t32;
    float t29 = 0.0f;
    if (t19) {
        t30 = spherecap_inline_min(t27, t28);
        t31 = 1.0f;
        t32 = 1.0f;
    } else {
        const float t33 = sqrtf(t22);
        const float t34 = fmaf(fmaf(fmaf(light->b_6, t22, light->b_4), t22, light->b_2), t22, light->b_0);
        const float t35 = t33 * fmaf(fmaf(fmaf(light->b_5, t22, light->b_3), t22, light->b_1), t33, t34);
        const float t36 = sqrtf(fmaf(t21, t21, t35 * t35));
        const float t37 = light->tau * t35;
        t32 = t17 ? fmaf(t21, t21, t37 * t37) : 1.0f;
        const float t38 = t17 ? fmaf(light->kappa, t35, t36) * fmaf(light->cut, t35, t36) : light->crescent_share;
        const float t39 = (t17 ? light->width : t15) / t38;
        const float t40 = spherecap_inline_min(spherecap_inline_max(t39, 5.9604645e-8f), 0.99999994f);
        const float t41 = t17 ? t39 : light->width;
        const float t42 = t32 * t41;
        const float t43 = fmaf(fmaf(fmaf(-0.00060778117f, t42, 1.0676054e-5f), t42, -0.0027203285f), t42 * t42 * t42, fmaf(fmaf(-0.011332183f, t42, -0.10000902f), t42, 1.0000001f));
        t29 = t17 ? t37 : t33;
        t30 = t17 ? t15 : t40;
        t31 = t41 * t43;
    }
    const float t44 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t30), -0.33333334f, 1419900500.0f));
    const float t45 = t30 * t44;
    const float t46 = fmaf(-t45, t44 * t44, 1.0f);
    const float t47 = t46 * t46;
    const float t48 = fmaf(fmaf(0.12666093f, t47, fmaf(0.14565912f, t46, 0.17283025f)), t47, fmaf(0.22221696f, t46, 0.33333334f));
    const float t49 = t31 * fmaf(t45 * t46, t48, t45);
    const float t50 = t49 * t32;
    const float t51 = t50 * t50 * t50;
    const float t52 = fmaf(fmaf(fmaf(0.022114987f, t50, -0.063446075f), t50, 0.085662976f), t51, fmaf(fmaf(-0.056249518f, t50, 0.030445365f), t50, 0.0074712755f));
    const float t53 = fmaf(t52, t51, fmaf(fmaf(0.03209764f, t50, 0.09996679f), t50, 1.0000004f));
    const float t54 = t49 * t53;
    const float t55 = t19 ? spherecap_inline_min(t54, 1.0f) : t54;
    const float t56 = t32 * t55;
    const float t57 = 2.0f - t56;
    const float t58 = t55 * t57;
    const float t59 = sqrtf(t58);
    float side, t60, t61, t62, t63;
    if (t19) {
        const float t64 = t27 - t28 < 0.0f ? t56 : t57;
        if (t6) {
            const float t65 = light->height * (1.0f - t58 * t22);
            const float t66 = sqrtf(light->height * (2.0f - t65));
            t62 = (t64 - 1.0f) * t66;
            const float t67 = 1.0f - t65;
            t61 = fmaf(light->elevation_sin, t67, light->elevation_cos * t62);
            t60 = fmaf(light->elevation_cos, t67, -(light->elevation_sin * t62));
            side = t59 * t21 * t66;
            t63 = t61 * light->on_surface;
        } else {
            const float t68 = 1.0f - t64;
            const float t69 = light->radius_sin * light->radius_sin * t22;
            const float t70 = spherecap_inline_max(fmaf(light->climb, t64, -light->rise), 0.0f);
            t61 = sqrtf(fmaf(t58, t69, t70 * t70));
            const float t71 = t2 * light->radius_cos;
            const float t72 = light->climb * t68;
            t62 = fmaf(light->elevation_cos, fmaf(t72, t72 - 2.0f * t71, t58 * t69) / (t61 + t71), -(light->half_axis * t2 * t68));
            t60 = fmaf(light->half_axis, t68, light->middle);
            side = light->radius_sin * t59 * t21;
            t63 = t61;
        }
    } else {
        t61 = t59 * t29;
        t60 = 1.0f - t56;
        side = t59 * t21;
        t62 = fmaf(light->elevation_cos, t61, -((t17 ? -t2 : t2) * t60));
        t63 = t61;
    }
    const float t73 = t10 ? 1.0f : -1.0f;
    const float zenith = t62 * t73;
    const float cosine = t63 * t73;
    const float t74 = t61 * t73;
    const float t75 = light->defensive_share * light->inv_solid_angle;
    const float t76 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t77 = 0.0f < cosine ? light->inv_above * light->sides_share : cosine < 0.0f ? light->inv_below * light->sides_rest : 0.0f;
    const float t78 = spherecap_inline_min(t75 / spherecap_inline_max(t76, 1.1754944e-38f), 3.4028235e38f);
    const float t79 = spherecap_inline_min(fmaf(t77, light->defensive_rest, t78), 3.4028235e38f);
    const float t80 = fmaf(zenith, zenith, side * side);
    const float t81 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t80), 0.0f);
    const float t82 = sqrtf(t81);
    const float t83 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t81));
    const float t84 = light->radius_cos * light->radius_cos / (t83 + t82);
    const float t85 = 1.0f / light->radius_sin;
    const float t86 = t84 * t85;
    const float t87 = -fmaf(t83, t82, t80) * t85;
    const float t88 = t86 * zenith;
    const float t89 = t86 * side;
    const float t90 = fmaf(light->third_axis[0], t60, fmaf(light->sideways[0], side, light->up[0] * t74));
    const float t91 = fmaf(light->third_axis[1], t60, fmaf(light->sideways[1], side, light->up[1] * t74));
    const float t92 = fmaf(light->third_axis[2], t60, fmaf(light->sideways[2], side, light->up[2] * t74));
    const float t93 = fmaf(light->elevation_cos, t87, -(light->elevation_sin * t88));
    const float t94 = fmaf(light->elevation_sin, t87, light->elevation_cos * t88);
    const float t95 = fmaf(light->third_axis[0], t93, fmaf(light->sideways[0], t89, light->up[0] * t94));
    const float t96 = fmaf(light->third_axis[1], t93, fmaf(light->sideways[1], t89, light->up[1] * t94));
    const float t97 = fmaf(light->third_axis[2], t93, fmaf(light->sideways[2], t89, light->up[2] * t94));
    const spherecap_inline_sample result = {
        {t90, t91, t92}, t84 * light->distance, {t95, t96, t97}, cosine,
        t3 ? fmaf(t77, light->defensive_rest * t76, t75) : t77 * t76, t3 ? t79 : t77
    };
    return result;
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
    const float t1 = fmaf(light->towards_centre[1], direction[1], light->towards_centre[2] * direction[2]);
    const float t2 = fmaf(light->towards_centre[1], light->sideways[2], -(light->towards_centre[2] * light->sideways[1]));
    const float t3 = fmaf(light->towards_centre[2], light->sideways[0], -(light->towards_centre[0] * light->sideways[2]));
    const float t4 = fmaf(light->towards_centre[0], light->sideways[1], -(light->towards_centre[1] * light->sideways[0]));
    const float t5 = fmaf(light->sideways[1], direction[1], light->sideways[2] * direction[2]);
    const float t6 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const bool t7 = fmaf(light->towards_centre[0], direction[0], t1) < 0.0f;
    const float t8 = t7 ? 1.0f : fmaf(t2, direction[0], fmaf(t3, direction[1], t4 * direction[2]));
    const float t9 = t7 ? 1.0f : fmaf(light->sideways[0], direction[0], t5);
    const float t10 = spherecap_inline_min(fabsf(t6), 3.4028235e38f);
    const float t11 = 0.0f < t6 ? light->inv_above * light->sides_share : t6 < 0.0f ? light->inv_below * light->sides_rest : 0.0f;
    const float t12 = fmaf(t11, light->defensive_rest * t10, light->defensive_share * light->inv_solid_angle);
    const bool t13 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t14 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t15 = (0.998001f <= t14 && t14 <= 1.002001f) ? (t13 ? (0.0f < light->defensive_share ? t12 : t11 * t10) : 0.0f) : 0.0f;
    return t15;
}

static inline float spherecap_inline_both_pdf_on_sphere(const spherecap_inline_both_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const float t2 = spherecap_inline_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light->inv_above * light->sides_share : t1 < 0.0f ? light->inv_below * light->sides_rest : 0.0f;
    const float t4 = fmaf(t3, light->defensive_rest * t2, light->defensive_share * light->inv_solid_angle);
    const float t5 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light->defensive_share ? t4 : t3 * t2) : 0.0f;
    return t6;
}

static inline float spherecap_inline_both_importance(const float normal[3], const float centre[3], float radius, float defensive, float strength)
{
    const float t1 = fmaf(normal[0], normal[0], fmaf(normal[1], normal[1], normal[2] * normal[2]));
    float t2, t3, t4;
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
    const bool t32 = t19 <= 1.0000019f && 4.9303807e-32f < t19 && 0.0f < strength && t21 && strength <= 3.4028235e38f;
    const float t33 = spherecap_inline_min(spherecap_inline_max(t19 * t31 * strength, 1.1754944e-38f), 3.4028235e38f);
    return ((0.0f < t31 || 0.0f < defensive) && t32) ? t33 : 0.0f;
}


#endif
