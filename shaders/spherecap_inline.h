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
    float density_above;
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
    const float density_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float t89 = t62 ? density_above : 0.0f;
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
    const bool t120 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < density_above;
    const float t121 = ((0.0f < radius_cos && t87) ? t85 / (1.0f + radius_cos) : 0.0f) * 6.2831855f;
    const spherecap_inline_surface_light result = {
        t120, t120 ? t121 : 0.0f, t120 ? projected_above : 0.0f, {t5 * t58, t6 * t58, t7 * t58},
        {sideways_x, sideways_y, sideways_z}, {normal[0], normal[1], normal[2]}, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, density_above,
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
    const float t43 = t20 * t42;
    const float t44 = 2.0f - t43;
    const float t45 = t42 * t44;
    const float t46 = sqrtf(t45);
    float zenith, side, cosine, t47;
    if (t7) {
        const float t48 = t15 - t16 < 0.0f ? t43 : t44;
        const float t49 = 1.0f - t48;
        const float t50 = light->radius_sin * light->radius_sin * t10;
        const float t51 = spherecap_inline_max(fmaf(light->climb, t48, -light->rise), 0.0f);
        cosine = sqrtf(fmaf(t45, t50, t51 * t51));
        const float t52 = t1 * light->radius_cos;
        const float t53 = light->climb * t49;
        zenith = fmaf(light->elevation_cos, fmaf(t53, t53 - 2.0f * t52, t45 * t50) / (cosine + t52), -(light->half_axis * t1 * t49));
        side = light->radius_sin * t46 * t9;
        t47 = fmaf(light->half_axis, t49, light->middle);
    } else {
        cosine = t46 * t17;
        t47 = 1.0f - t43;
        zenith = fmaf(light->elevation_cos, cosine, -((t5 ? -t1 : t1) * t47));
        side = t46 * t9;
    }
    const float t54 = fmaf(light->density_above, spherecap_inline_min(spherecap_inline_max(cosine, 0.0f), 3.4028235e38f), 0.0f);
    const float t55 = spherecap_inline_max(spherecap_inline_min(fabsf(cosine), 3.4028235e38f), 1.1754944e-38f);
    const float t56 = (0.0f < cosine ? light->density_above : 0.0f) + spherecap_inline_min(0.0f / t55, 3.4028235e38f);
    const float t57 = fmaf(zenith, zenith, side * side);
    const float t58 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t57), 0.0f);
    const float t59 = sqrtf(t58);
    const float t60 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t58));
    const float t61 = light->radius_cos * light->radius_cos / (t60 + t59);
    const float t62 = 1.0f / light->radius_sin;
    const float t63 = t61 * t62;
    const float t64 = -fmaf(t60, t59, t57) * t62;
    const float t65 = t63 * zenith;
    const float t66 = t63 * side;
    const float t67 = fmaf(light->third_axis[0], t47, fmaf(light->sideways[0], side, light->normal[0] * cosine));
    const float t68 = fmaf(light->third_axis[1], t47, fmaf(light->sideways[1], side, light->normal[1] * cosine));
    const float t69 = fmaf(light->third_axis[2], t47, fmaf(light->sideways[2], side, light->normal[2] * cosine));
    const float t70 = fmaf(light->elevation_cos, t64, -(light->elevation_sin * t65));
    const float t71 = fmaf(light->elevation_sin, t64, light->elevation_cos * t65);
    const float t72 = fmaf(light->third_axis[0], t70, fmaf(light->sideways[0], t66, light->normal[0] * t71));
    const float t73 = fmaf(light->third_axis[1], t70, fmaf(light->sideways[1], t66, light->normal[1] * t71));
    const float t74 = fmaf(light->third_axis[2], t70, fmaf(light->sideways[2], t66, light->normal[2] * t71));
    const spherecap_inline_sample result = {
        {t67, t68, t69}, t61 * light->distance, {t72, t73, t74}, cosine, t54,
        spherecap_inline_min(t56, 3.4028235e38f)
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
    const float t10 = fmaf(light->density_above, spherecap_inline_min(spherecap_inline_max(t6, 0.0f), 3.4028235e38f), 0.0f);
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
    const float t2 = fmaf(light->density_above, spherecap_inline_min(spherecap_inline_max(t1, 0.0f), 3.4028235e38f), 0.0f);
    const float t3 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
}

static inline float spherecap_inline_surface_importance(const float normal[3], const float centre[3], float radius, float strength)
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
    const float t9 = sqrtf(fmaf(t5, t5, fmaf(t6, t6, t7 * t7)));
    const float t10 = 1.0f / t9;
    const float t11 = t8 * t10;
    const float t12 = t11 * t11;
    const bool t13 = 0.0f < radius && t9 * (t2 ? 1.0f : unscale) <= 3.4028235e38f && 0.0f < strength;
    const float t14 = fmaf(normal[0], t5, fmaf(normal[1], t6, normal[2] * t7));
    const float t15 = fmaf(t14, t10, 2.3841858e-7f);
    const float t16 = fmaf(t14 + t8, t10, 2.3841858e-7f);
    const float t17 = fmaf(t11 - t15, spherecap_inline_max(fmaf(-t12, t12, 0.9999981f), 0.0f), t16);
    const float t18 = t11 <= t15 ? t15 : 0.0f < t16 ? t16 * t16 / (t17 * 2.0f) : 0.0f;
    const float t19 = fmaf(0.0f, 0.5f - t18, t18);
    const bool t20 = t12 <= 1.0000019f && 4.9303807e-32f < t12 && strength <= 3.4028235e38f && t13;
    const float t21 = spherecap_inline_min(spherecap_inline_max(t12 * t19 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (0.0f < t19 && t20) ? t21 : 0.0f;
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
    float defensive;
    float requested;
    float density_above;
    float third_axis[3];
    float height;
    float density;
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
    const float t103 = t102 ? 1.0f / projected_above : 0.0f;
    const float t104 = t75 ? t103 : 0.0f;
    const bool t105 = t74 && t75 && 0.0f < t104;
    const float t106 = t_y * t_y * t_y * shape * t104;
    const float t107 = t_y / radius_sin;
    const float t108 = t107 * t107 * t107 * (fmaf(cut - t_x, shape_difference, shape) * 0.53033006f);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t74 && !t75) {
        const float t109 = 1.0f + kappa;
        const float t110 = t109 * shape;
        const float t111 = 1.0f / (norm * t110);
        const float t112 = sqrtf(t111);
        b_0 = norm * t112;
        const float t113 = 1.0f / (1.0f + cut);
        const float t114 = (t_x + kappa) * t113 - 0.5f;
        const float t115 = t114 * t114 * t114;
        const float t116 = fmaf(fmaf(fmaf(-0.026061837f, t114, 0.05430631f), t114, -0.06372378f), t115, fmaf(fmaf(0.080950715f, t114, -0.11762552f), t114, 0.1684019f));
        const float t117 = fmaf(t116, t115, fmaf(fmaf(-0.23594604f, t114, 0.32709444f), t114, -0.44721135f));
        const float t118 = fmaf(t117, t115, fmaf(fmaf(0.5987523f, t114, -0.7754678f), t114, 0.94559944f));
        const float t119 = t109 * t118 * (t113 * t113 * t113) * (t110 * t111);
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
        b_1 = t119 - b_0 + t125;
        b_2 = t128 - t125;
        b_3 = t131 - t128;
        b_4 = t133 - t131;
        b_5 = t134 - t133;
        b_6 = -t134;
    }
    const float t135 = ((0.0f < defensive || !(0.0f < on_surface)) && !t102) ? 1.0f : defensive;
    const bool t136 = 0.0f < t135;
    const float t137 = (0.0f < radius_cos && t100) ? t98 / (1.0f + radius_cos) : 0.0f;
    const float density = t136 ? t135 * (0.0f < t137 ? 0.15915494f / t137 : 0.0f) : 0.0f;
    const float density_above = t103 * (1.0f - t135);
    const bool t138 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && 0.0f < density_above + 0.0f + density;
    const spherecap_inline_front_light result = {
        t138, t138 ? t137 * 6.2831855f : 0.0f, t138 ? projected_above : 0.0f,
        {t13 * t71, t14 * t71, t15 * t71}, {sideways_x, sideways_y, sideways_z},
        {normal_x, normal_y, normal_z}, {up_x, up_y, up_z}, on_surface, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, t135, defensive, density_above,
        {fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))},
        t136 ? t137 : 0.0f, density, t105 ? t106 : 0.0f, t105 ? 1.0f / (1.0f - t106) : 1.0f,
        t105 ? t108 : 0.0f, elevation_cos * radius_cos, radius_sin * t97, climb, b_0, b_1, b_2, b_3, b_4,
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
    const float t2 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t3 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t4 = t2 < light->defensive;
    const float t5 = (t4 ? t2 : t2 - light->defensive) / (t4 ? light->defensive : 1.0f - light->defensive);
    const float t6 = spherecap_inline_min(spherecap_inline_max(t5, 5.9604645e-8f), 0.99999994f);
    const float t7 = 0.0f < light->requested ? t6 : t2;
    const bool t8 = !(0.0f < light->tau) || t4;
    const bool t9 = !(0.0f < light->elevation_sin) && !t8;
    const bool t10 = light->crescent_share <= t7 && !t9;
    const bool t11 = t8 || t10;
    const float t12 = 1.0f - t3;
    const float t13 = t3 - t12;
    const float t14 = 4.0f * t3 * t12;
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
    const float t47 = t24 * t46;
    const float t48 = 2.0f - t47;
    const float t49 = t46 * t48;
    const float t50 = sqrtf(t49);
    float zenith, side, cosine, t51, t52;
    if (t11) {
        const float t53 = t19 - t20 < 0.0f ? t47 : t48;
        if (t4) {
            const float t54 = light->height * (1.0f - t49 * t14);
            const float t55 = sqrtf(light->height * (2.0f - t54));
            zenith = (t53 - 1.0f) * t55;
            const float t56 = 1.0f - t54;
            t52 = fmaf(light->elevation_sin, t56, light->elevation_cos * zenith);
            t51 = fmaf(light->elevation_cos, t56, -(light->elevation_sin * zenith));
            side = t50 * t13 * t55;
            cosine = t52 * light->on_surface;
        } else {
            const float t57 = 1.0f - t53;
            const float t58 = light->radius_sin * light->radius_sin * t14;
            const float t59 = spherecap_inline_max(fmaf(light->climb, t53, -light->rise), 0.0f);
            t52 = sqrtf(fmaf(t49, t58, t59 * t59));
            const float t60 = t1 * light->radius_cos;
            const float t61 = light->climb * t57;
            zenith = fmaf(light->elevation_cos, fmaf(t61, t61 - 2.0f * t60, t49 * t58) / (t52 + t60), -(light->half_axis * t1 * t57));
            t51 = fmaf(light->half_axis, t57, light->middle);
            side = light->radius_sin * t50 * t13;
            cosine = t52;
        }
    } else {
        cosine = t50 * t21;
        t51 = 1.0f - t47;
        zenith = fmaf(light->elevation_cos, cosine, -((t9 ? -t1 : t1) * t51));
        side = t50 * t13;
        t52 = cosine;
    }
    const float t62 = fmaf(light->density_above, spherecap_inline_min(spherecap_inline_max(cosine, 0.0f), 3.4028235e38f), light->density);
    const float t63 = spherecap_inline_max(spherecap_inline_min(fabsf(cosine), 3.4028235e38f), 1.1754944e-38f);
    const float t64 = (0.0f < cosine ? light->density_above : 0.0f) + spherecap_inline_min(light->density / t63, 3.4028235e38f);
    const float t65 = fmaf(zenith, zenith, side * side);
    const float t66 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t65), 0.0f);
    const float t67 = sqrtf(t66);
    const float t68 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t66));
    const float t69 = light->radius_cos * light->radius_cos / (t68 + t67);
    const float t70 = 1.0f / light->radius_sin;
    const float t71 = t69 * t70;
    const float t72 = -fmaf(t68, t67, t65) * t70;
    const float t73 = t71 * zenith;
    const float t74 = t71 * side;
    const float t75 = fmaf(light->third_axis[0], t51, fmaf(light->sideways[0], side, light->up[0] * t52));
    const float t76 = fmaf(light->third_axis[1], t51, fmaf(light->sideways[1], side, light->up[1] * t52));
    const float t77 = fmaf(light->third_axis[2], t51, fmaf(light->sideways[2], side, light->up[2] * t52));
    const float t78 = fmaf(light->elevation_cos, t72, -(light->elevation_sin * t73));
    const float t79 = fmaf(light->elevation_sin, t72, light->elevation_cos * t73);
    const float t80 = fmaf(light->third_axis[0], t78, fmaf(light->sideways[0], t74, light->up[0] * t79));
    const float t81 = fmaf(light->third_axis[1], t78, fmaf(light->sideways[1], t74, light->up[1] * t79));
    const float t82 = fmaf(light->third_axis[2], t78, fmaf(light->sideways[2], t74, light->up[2] * t79));
    const spherecap_inline_sample result = {
        {t75, t76, t77}, t69 * light->distance, {t80, t81, t82}, cosine, t62,
        spherecap_inline_min(t64, 3.4028235e38f)
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
    const float t10 = fmaf(light->density_above, spherecap_inline_min(spherecap_inline_max(t6, 0.0f), 3.4028235e38f), light->density);
    const bool t11 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t12 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? t10 : 0.0f) : 0.0f;
}

static inline float spherecap_inline_front_pdf_on_sphere(const spherecap_inline_front_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const float t2 = fmaf(light->density_above, spherecap_inline_min(spherecap_inline_max(t1, 0.0f), 3.4028235e38f), light->density);
    const float t3 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
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
    const float t11 = fmaf(centre[0], centre[0], fmaf(centre[1], centre[1], centre[2] * centre[2]));
    const bool t12 = t11 < 1099511600000.0f && 9.536743e-7f < radius;
    const float t13 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t13, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t14 = t12 ? 1.0f : scale;
    const float t15 = centre[0] * t14;
    const float t16 = centre[1] * t14;
    const float t17 = centre[2] * t14;
    const float t18 = radius * t14;
    const float t19 = sqrtf(fmaf(t15, t15, fmaf(t16, t16, t17 * t17)));
    const float t20 = 1.0f / t19;
    const float t21 = t18 * t20;
    const float t22 = t21 * t21;
    const float t23 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t24 = 0.0f <= defensive && defensive <= 1.0f && t23 <= 2.0f && 0.0f < radius && t19 * (t12 ? 1.0f : unscale) <= 3.4028235e38f;
    const float t25 = fmaf(t2, t15, fmaf(t3, t16, t4 * t17));
    const float t26 = fmaf(t25, t20, 2.3841858e-7f);
    const float t27 = fmaf(t25 + t18, t20, 2.3841858e-7f);
    const float t28 = fmaf(t21 - t26, spherecap_inline_max(fmaf(-t22, t22, 0.9999981f), 0.0f), t27);
    const float t29 = t21 <= t26 ? t26 : 0.0f < t27 ? t27 * t27 / (t28 * 2.0f) : 0.0f;
    const float t30 = t23 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t29, t29);
    const bool t31 = t22 <= 1.0000019f && 4.9303807e-32f < t22 && 0.0f < strength && t24 && strength <= 3.4028235e38f;
    const float t32 = spherecap_inline_min(spherecap_inline_max(t22 * t30 * strength, 1.1754944e-38f), 3.4028235e38f);
    return ((0.0f < t30 || 0.0f < defensive) && t31) ? t32 : 0.0f;
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
    float defensive;
    float requested;
    float above;
    float density_above;
    float density_below;
    float third_axis[3];
    float height;
    float density;
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
    const float t107 = t105 ? 1.0f / projected_above : 0.0f;
    const float t108 = t106 ? 1.0f / projected_below : 0.0f;
    const float t109 = t75 ? t107 : t108;
    const bool t110 = 0.0f < t109 && t74;
    const float t111 = t_y * t_y * t_y * shape * t109;
    const float t112 = t_y / radius_sin;
    const float t113 = fmaf(cut - t_x, shape_difference, shape);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t74) {
        const float t114 = 1.0f + kappa;
        const float t115 = t114 * shape;
        const float t116 = 1.0f / (norm * t115);
        const float t117 = sqrtf(t116);
        b_0 = norm * t117;
        const float t118 = 1.0f / (1.0f + cut);
        const float t119 = (t_x + kappa) * t118 - 0.5f;
        const float t120 = t119 * t119 * t119;
        const float t121 = fmaf(fmaf(fmaf(-0.026061837f, t119, 0.05430631f), t119, -0.06372378f), t120, fmaf(fmaf(0.080950715f, t119, -0.11762552f), t119, 0.1684019f));
        const float t122 = fmaf(t121, t120, fmaf(fmaf(-0.23594604f, t119, 0.32709444f), t119, -0.44721135f));
        const float t123 = fmaf(t122, t120, fmaf(fmaf(0.5987523f, t119, -0.7754678f), t119, 0.94559944f));
        const float t124 = t114 * t123 * (t118 * t118 * t118) * (t115 * t116);
        const float t125 = fmaf(t124, t115 * t117, -1.0f);
        const float t126 = 1.0f - t124;
        const float t127 = fmaf(fmaf(30.011856f, t125, fmaf(-41.541264f, t126, -37.009792f)), t125, fmaf(77.96775f, t126, 7.470758f));
        const float t128 = fmaf(t127, t125, fmaf(fmaf(-49.13454f, t126, -9.466533f), t126, -1.5877596f));
        const float t129 = fmaf(fmaf(fmaf(15.716111f, t126, 0.0f), t126, 9.961183f), t126, -2.61785f);
        const float t130 = t125 * fmaf(t128, t125, fmaf(t129, t126, 0.8681748f));
        const float t131 = fmaf(fmaf(7.295638f, t125, -7.236236f), t125, fmaf(fmaf(fmaf(-11.4868555f, t126, 0.0f), t126, 0.0f), t126, 3.1255686f));
        const float t132 = fmaf(fmaf(fmaf(13.728438f, t126, -7.981878f), t126, 2.025724f), t126, -0.7334958f);
        const float t133 = t125 * fmaf(t131, t125, t132);
        const float t134 = fmaf(fmaf(fmaf(9.986537f, t126, 25.22195f), t126, 0.0f), t126, -2.9581387f);
        const float t135 = fmaf(fmaf(fmaf(-19.722994f, t126, 4.6594768f), t126, -0.89538246f), t126, 0.5143498f);
        const float t136 = t125 * fmaf(fmaf(fmaf(-23.220068f, t126, 7.332055f), t125, t134), t125, t135);
        const float t137 = fmaf(fmaf(fmaf(1.946617f, t125, -3.077631f), t125, 1.4945927f), t125, -0.24140751f);
        const float t138 = t125 * t137;
        const float t139 = t125 * fmaf(fmaf(0.38173297f, t125, -0.30305624f), t125, 0.05897375f);
        b_1 = t124 - b_0 + t130;
        b_2 = t133 - t130;
        b_3 = t136 - t133;
        b_4 = t138 - t136;
        b_5 = t139 - t138;
        b_6 = -t139;
    }
    const float t140 = (!(t105 || t106) && (0.0f < defensive || !(0.0f < on_surface))) ? 1.0f : defensive;
    const bool t141 = 0.0f < t140;
    const float t142 = (0.0f < radius_cos && t102) ? t98 / (1.0f + radius_cos) : 0.0f;
    const float density = t141 ? t140 * (0.0f < t142 ? 0.15915494f / t142 : 0.0f) : 0.0f;
    const float t143 = 1.0f - t140;
    float t144 = 0.0f;
    if (0.0f < tau) {
        const float t145 = 1.0f / (elevation_cos * elevation_cos);
        const float t146 = tau * tau;
        const float t147 = t146 * t145 / (1.0f + t_x);
        const float t148 = kappa - 0.5f;
        const float t149 = cut - 0.5f;
        const float t150 = t148 * t148;
        const float t151 = t149 * t149;
        const float t152 = fmaf(0.05430631f, t150, 0.080950715f);
        const float t153 = fmaf(t152, t150, 0.1684019f);
        const float t154 = fmaf(t153, t150, 0.32709444f);
        const float t155 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t151, t152), t151, t153), t151, t154), t151, fmaf(t154, t150, 0.5987523f));
        const float t156 = fmaf(-0.026061837f, t150, -0.06372378f);
        const float t157 = fmaf(t156, t150, -0.11762552f);
        const float t158 = fmaf(t157, t150, -0.23594604f);
        const float t159 = fmaf(t158, t150, -0.44721135f);
        const float t160 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t151, t156), t151, t157), t151, t158), t151, t159);
        const float t161 = fmaf(kappa * t147, fmaf(fmaf(t149, t160, t155), t148 + t149, fmaf(t159, t150, -0.7754678f)), fmaf(t113, t147 - kappa * kappa, kappa) * t145);
        const float t162 = spherecap_inline_max(t146 * tau * (radius_cos + 1.0f) * t161 * 0.31830987f, 0.0f);
        t144 = spherecap_inline_min(t162, 0.5f);
    }
    const float t163 = 1.0f - t144;
    const bool t164 = 0.0f < t108;
    const bool t165 = 0.0f < t107;
    const float above = t164 ? (t165 ? (t75 ? t163 : t144) : 0.0f) : 1.0f;
    const float density_above = t107 * above * t143;
    const float density_below = t108 * (t165 ? (t164 ? (t75 ? t144 : t163) : 0.0f) : 1.0f) * t143;
    const bool t166 = distance <= 3.4028235e38f && 0.0f < density_above + density_below + density;
    const bool t167 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && t166;
    const spherecap_inline_both_light result = {
        t167, t167 ? t142 * 6.2831855f : 0.0f, t167 ? projected_above : 0.0f,
        {t13 * t71, t14 * t71, t15 * t71}, {sideways_x, sideways_y, sideways_z},
        {normal_x, normal_y, normal_z}, {up_x, up_y, up_z}, on_surface, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, t140, defensive, above, density_above,
        density_below,
        {fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))},
        t141 ? t142 : 0.0f, density, t110 ? t111 : 0.0f, t110 ? 1.0f / (1.0f - t111) : 1.0f,
        t110 ? t112 * t112 * t112 * (t113 * 0.53033006f) : 0.0f, elevation_cos * radius_cos,
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
    const float t3 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t3 < light->defensive;
    const float t6 = (t5 ? t3 : t3 - light->defensive) / (t5 ? light->defensive : 1.0f - light->defensive);
    const float t7 = spherecap_inline_min(spherecap_inline_max(t6, 5.9604645e-8f), 0.99999994f);
    const float t8 = 0.0f < light->requested ? t7 : t3;
    const bool t9 = t8 < light->above || t5;
    const float t10 = (t9 ? t8 : t8 - light->above) / (t9 ? light->above : 1.0f - light->above);
    const float t11 = spherecap_inline_min(spherecap_inline_max(t10, 5.9604645e-8f), 0.99999994f);
    const bool t12 = t9 && t1;
    const bool t13 = !t9 && !t1;
    const float t14 = t5 ? t8 : t11;
    const bool t15 = !(0.0f < light->tau) || t5;
    const bool t16 = !(t12 || t13) && !t15;
    const bool t17 = light->crescent_share <= t14 && !t16;
    const bool t18 = t15 || t17;
    const float t19 = 1.0f - t4;
    const float t20 = t4 - t19;
    const float t21 = 4.0f * t4 * t19;
    const float t22 = spherecap_inline_max((t14 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
    const float t23 = t15 ? t14 : spherecap_inline_min(t22, 0.99999994f);
    const float t24 = t15 ? 0.0f : light->beyond;
    const float t25 = 1.6660811f - t24;
    const float t26 = fmaf(t23, t25, t24);
    const float t27 = (1.0f - t23) * t25;
    float t29, t30, t31;
    float t28 = 0.0f;
    if (t18) {
        t29 = spherecap_inline_min(t26, t27);
        t30 = 1.0f;
        t31 = 1.0f;
    } else {
        const float t32 = sqrtf(t21);
        const float t33 = fmaf(fmaf(fmaf(light->b_6, t21, light->b_4), t21, light->b_2), t21, light->b_0);
        const float t34 = t32 * fmaf(fmaf(fmaf(light->b_5, t21, light->b_3), t21, light->b_1), t32, t33);
        const float t35 = sqrtf(fmaf(t20, t20, t34 * t34));
        const float t36 = light->tau * t34;
        t31 = t16 ? fmaf(t20, t20, t36 * t36) : 1.0f;
        const float t37 = t16 ? fmaf(light->kappa, t34, t35) * fmaf(light->cut, t34, t35) : light->crescent_share;
        const float t38 = (t16 ? light->width : t14) / t37;
        const float t39 = spherecap_inline_min(spherecap_inline_max(t38, 5.9604645e-8f), 0.99999994f);
        const float t40 = t16 ? t38 : light->width;
        const float t41 = t31 * t40;
        const float t42 = fmaf(fmaf(fmaf(-0.00060778117f, t41, 1.0676054e-5f), t41, -0.0027203285f), t41 * t41 * t41, fmaf(fmaf(-0.011332183f, t41, -0.10000902f), t41, 1.0000001f));
        t28 = t16 ? t36 : t32;
        t29 = t16 ? t14 : t39;
        t30 = t40 * t42;
    }
    const float t43 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t29), -0.33333334f, 1419900500.0f));
    const float t44 = t29 * t43;
    const float t45 = fmaf(-t44, t43 * t43, 1.0f);
    const float t46 = t45 * t45;
    const float t47 = fmaf(fmaf(0.12666093f, t46, fmaf(0.14565912f, t45, 0.17283025f)), t46, fmaf(0.22221696f, t45, 0.33333334f));
    const float t48 = t30 * fmaf(t44 * t45, t47, t44);
    const float t49 = t48 * t31;
    const float t50 = t49 * t49 * t49;
    const float t51 = fmaf(fmaf(fmaf(0.022114987f, t49, -0.063446075f), t49, 0.085662976f), t50, fmaf(fmaf(-0.056249518f, t49, 0.030445365f), t49, 0.0074712755f));
    const float t52 = fmaf(t51, t50, fmaf(fmaf(0.03209764f, t49, 0.09996679f), t49, 1.0000004f));
    const float t53 = t48 * t52;
    const float t54 = t31 * t53;
    const float t55 = 2.0f - t54;
    const float t56 = t53 * t55;
    const float t57 = sqrtf(t56);
    float side, t58, t59, t60, t61;
    if (t18) {
        const float t62 = t26 - t27 < 0.0f ? t54 : t55;
        if (t5) {
            const float t63 = light->height * (1.0f - t56 * t21);
            const float t64 = sqrtf(light->height * (2.0f - t63));
            t60 = (t62 - 1.0f) * t64;
            const float t65 = 1.0f - t63;
            t59 = fmaf(light->elevation_sin, t65, light->elevation_cos * t60);
            t58 = fmaf(light->elevation_cos, t65, -(light->elevation_sin * t60));
            side = t57 * t20 * t64;
            t61 = t59 * light->on_surface;
        } else {
            const float t66 = 1.0f - t62;
            const float t67 = light->radius_sin * light->radius_sin * t21;
            const float t68 = spherecap_inline_max(fmaf(light->climb, t62, -light->rise), 0.0f);
            t59 = sqrtf(fmaf(t56, t67, t68 * t68));
            const float t69 = t2 * light->radius_cos;
            const float t70 = light->climb * t66;
            t60 = fmaf(light->elevation_cos, fmaf(t70, t70 - 2.0f * t69, t56 * t67) / (t59 + t69), -(light->half_axis * t2 * t66));
            t58 = fmaf(light->half_axis, t66, light->middle);
            side = light->radius_sin * t57 * t20;
            t61 = t59;
        }
    } else {
        t59 = t57 * t28;
        t58 = 1.0f - t54;
        side = t57 * t20;
        t60 = fmaf(light->elevation_cos, t59, -((t16 ? -t2 : t2) * t58));
        t61 = t59;
    }
    const float t71 = t9 ? 1.0f : -1.0f;
    const float zenith = t60 * t71;
    const float cosine = t61 * t71;
    const float t72 = t59 * t71;
    const float t73 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t74 = 0.0f < cosine ? light->density_above : cosine < 0.0f ? light->density_below : 0.0f;
    const float t75 = spherecap_inline_min(light->density / spherecap_inline_max(t73, 1.1754944e-38f), 3.4028235e38f);
    const float t76 = fmaf(zenith, zenith, side * side);
    const float t77 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t76), 0.0f);
    const float t78 = sqrtf(t77);
    const float t79 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t77));
    const float t80 = light->radius_cos * light->radius_cos / (t79 + t78);
    const float t81 = 1.0f / light->radius_sin;
    const float t82 = t80 * t81;
    const float t83 = -fmaf(t79, t78, t76) * t81;
    const float t84 = t82 * zenith;
    const float t85 = t82 * side;
    const float t86 = fmaf(light->third_axis[0], t58, fmaf(light->sideways[0], side, light->up[0] * t72));
    const float t87 = fmaf(light->third_axis[1], t58, fmaf(light->sideways[1], side, light->up[1] * t72));
    const float t88 = fmaf(light->third_axis[2], t58, fmaf(light->sideways[2], side, light->up[2] * t72));
    const float t89 = fmaf(light->elevation_cos, t83, -(light->elevation_sin * t84));
    const float t90 = fmaf(light->elevation_sin, t83, light->elevation_cos * t84);
    const float t91 = fmaf(light->third_axis[0], t89, fmaf(light->sideways[0], t85, light->up[0] * t90));
    const float t92 = fmaf(light->third_axis[1], t89, fmaf(light->sideways[1], t85, light->up[1] * t90));
    const float t93 = fmaf(light->third_axis[2], t89, fmaf(light->sideways[2], t85, light->up[2] * t90));
    const spherecap_inline_sample result = {
        {t86, t87, t88}, t80 * light->distance, {t91, t92, t93}, cosine, fmaf(t74, t73, light->density),
        spherecap_inline_min(t74 + t75, 3.4028235e38f)
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
    const float t10 = 0.0f < t6 ? light->density_above : t6 < 0.0f ? light->density_below : 0.0f;
    const float t11 = fmaf(t10, spherecap_inline_min(fabsf(t6), 3.4028235e38f), light->density);
    const bool t12 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t13 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t13 && t13 <= 1.002001f) ? (t12 ? t11 : 0.0f) : 0.0f;
}

static inline float spherecap_inline_both_pdf_on_sphere(const spherecap_inline_both_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const float t2 = 0.0f < t1 ? light->density_above : t1 < 0.0f ? light->density_below : 0.0f;
    const float t3 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t4 = (0.998001f <= t3 && t3 <= 1.002001f) ? fmaf(t2, spherecap_inline_min(fabsf(t1), 3.4028235e38f), light->density) : 0.0f;
    return t4;
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
    const float t11 = fmaf(centre[0], centre[0], fmaf(centre[1], centre[1], centre[2] * centre[2]));
    const bool t12 = t11 < 1099511600000.0f && 9.536743e-7f < radius;
    const float t13 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t13, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t14 = t12 ? 1.0f : scale;
    const float t15 = centre[0] * t14;
    const float t16 = centre[1] * t14;
    const float t17 = centre[2] * t14;
    const float t18 = radius * t14;
    const float t19 = sqrtf(fmaf(t15, t15, fmaf(t16, t16, t17 * t17)));
    const float t20 = 1.0f / t19;
    const float t21 = t18 * t20;
    const float t22 = t21 * t21;
    const float t23 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t24 = 0.0f <= defensive && defensive <= 1.0f && t23 <= 2.0f && 0.0f < radius && t19 * (t12 ? 1.0f : unscale) <= 3.4028235e38f;
    const float t25 = fmaf(t2, t15, fmaf(t3, t16, t4 * t17));
    const float t26 = spherecap_inline_max(fmaf(-t22, t22, 0.9999981f), 0.0f);
    const float t27 = fmaf(t25, t20, 2.3841858e-7f);
    const float t28 = fmaf(t25 + t18, t20, 2.3841858e-7f);
    const float t29 = t21 <= t27 ? t27 : 0.0f < t28 ? t28 * t28 / (fmaf(t21 - t27, t26, t28) * 2.0f) : 0.0f;
    const float t30 = fmaf(-t25, t20, 2.3841858e-7f);
    const float t31 = fmaf(-t25 + t18, t20, 2.3841858e-7f);
    const float t32 = t21 <= t30 ? t30 : 0.0f < t31 ? t31 * t31 / (fmaf(t21 - t30, t26, t31) * 2.0f) : 0.0f;
    const float t33 = t29 + t32;
    const float t34 = t23 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t33, t33);
    const bool t35 = t22 <= 1.0000019f && 4.9303807e-32f < t22 && 0.0f < strength && t24 && strength <= 3.4028235e38f;
    const float t36 = spherecap_inline_min(spherecap_inline_max(t22 * t34 * strength, 1.1754944e-38f), 3.4028235e38f);
    return ((0.0f < t34 || 0.0f < defensive) && t35) ? t36 : 0.0f;
}


#endif
