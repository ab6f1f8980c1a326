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
    const float t57 = sqrtf(t13);
    const bool t58 = 0.0f < t13;
    float t59;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (0.0f < t56 && t58) {
        t59 = sqrtf(t13 + t56);
        const float t60 = sqrtf(t56);
        const float t61 = 1.0f / (t59 * t8);
        const float t62 = t61 * t8;
        const float t63 = t61 * t59;
        t_x = t57 * t62;
        t_y = t60 * t62;
        const float t64 = t_y * t_y;
        kappa = fabsf(t52) * t63;
        cut = kappa * t_x;
        const float t65 = t_x - 0.5f;
        const float t66 = cut - 0.5f;
        const float t67 = t65 * t65;
        const float t68 = t66 * t66;
        const float t69 = fmaf(0.05430631f, t67, 0.080950715f);
        const float t70 = fmaf(t69, t67, 0.1684019f);
        const float t71 = fmaf(t70, t67, 0.32709444f);
        const float t72 = fmaf(t71, t67, 0.5987523f);
        const float t73 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t68, t69), t68, t70), t68, t71), t68, t72);
        const float t74 = fmaf(-0.026061837f, t67, -0.06372378f);
        const float t75 = fmaf(t74, t67, -0.11762552f);
        const float t76 = fmaf(t75, t67, -0.23594604f);
        const float t77 = fmaf(t76, t67, -0.44721135f);
        const float t78 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t68, t74), t68, t75), t68, t76), t68, t77);
        const float t79 = fmaf(t77, t67, -0.7754678f);
        shape = fmaf(t79, t65, fmaf(t72, t67, 0.94559944f));
        shape_difference = fmaf(fmaf(t66, t78, t73), t65 + t66, t79);
        norm = fmaf(cut, shape_difference, shape);
        width = t64 / (1.0f + t_x);
        tau = t60 * t63;
        area = t64 * t_y * (spherecap_inline_min(t54, t55) * t63) * norm;
    } else {
        t59 = t32;
    }
    const float t80 = sqrtf(t12);
    const float t81 = 1.0f / t80;
    const float radius_sin = t8 * t81;
    const float radius_cos = t57 * t81;
    const float elevation_sin = t52 * t81;
    const float elevation_cos = t59 * t81;
    const float t82 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t56 * (t81 * t81) / fmaf(radius_cos, t82, climb), -(radius_cos * t82));
    const float t83 = radius_sin * radius_sin;
    const bool t84 = 0.0f < elevation_sin;
    const float t85 = t84 ? fmaf(t83 * t82, 3.1415927f, area) : area;
    const bool t86 = 9.8607613e-32f < t83;
    const float t87 = 1.0f / t31;
    const float sideways_x = t28 * t87;
    const float sideways_y = t29 * t87;
    const float sideways_z = t30 * t87;
    const float distance = t80 * (t2 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t85 && t86 && t58) ? t85 : 0.0f;
    const bool t88 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float t89 = t84 ? inv_above : 0.0f;
    const bool t90 = t88 && t84 && 0.0f < t89;
    const float t91 = t_y * t_y * t_y * shape * t89;
    const float t92 = t_y / radius_sin;
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t88 && !t84) {
        const float t93 = 1.0f + kappa;
        const float t94 = t93 * shape;
        const float t95 = 1.0f / (norm * t94);
        const float t96 = sqrtf(t95);
        b_0 = norm * t96;
        const float t97 = 1.0f / (1.0f + cut);
        const float t98 = (t_x + kappa) * t97 - 0.5f;
        const float t99 = t98 * t98;
        const float t100 = fmaf(fmaf(fmaf(-0.026061837f, t99, -0.06372378f), t99, -0.11762552f), t99, -0.23594604f);
        const float t101 = fmaf(fmaf(fmaf(0.05430631f, t99, 0.080950715f), t99, 0.1684019f), t99, 0.32709444f);
        const float t102 = fmaf(fmaf(fmaf(t100, t99, -0.44721135f), t99, -0.7754678f), t98, fmaf(fmaf(t101, t99, 0.5987523f), t99, 0.94559944f));
        const float t103 = t93 * t102 * (t97 * t97 * t97) * (t94 * t95);
        const float t104 = fmaf(t103, t94 * t96, -1.0f);
        const float t105 = 1.0f - t103;
        const float t106 = fmaf(fmaf(30.011856f, t104, fmaf(-41.541264f, t105, -37.009792f)), t104, fmaf(77.96775f, t105, 7.470758f));
        const float t107 = fmaf(t106, t104, fmaf(fmaf(-49.13454f, t105, -9.466533f), t105, -1.5877596f));
        const float t108 = fmaf(fmaf(fmaf(15.716111f, t105, 0.0f), t105, 9.961183f), t105, -2.61785f);
        const float t109 = t104 * fmaf(t107, t104, fmaf(t108, t105, 0.8681748f));
        const float t110 = fmaf(fmaf(7.295638f, t104, -7.236236f), t104, fmaf(fmaf(fmaf(-11.4868555f, t105, 0.0f), t105, 0.0f), t105, 3.1255686f));
        const float t111 = fmaf(fmaf(fmaf(13.728438f, t105, -7.981878f), t105, 2.025724f), t105, -0.7334958f);
        const float t112 = t104 * fmaf(t110, t104, t111);
        const float t113 = fmaf(fmaf(fmaf(9.986537f, t105, 25.22195f), t105, 0.0f), t105, -2.9581387f);
        const float t114 = fmaf(fmaf(fmaf(-19.722994f, t105, 4.6594768f), t105, -0.89538246f), t105, 0.5143498f);
        const float t115 = t104 * fmaf(fmaf(fmaf(-23.220068f, t105, 7.332055f), t104, t113), t104, t114);
        const float t116 = fmaf(fmaf(fmaf(1.946617f, t104, -3.077631f), t104, 1.4945927f), t104, -0.24140751f);
        const float t117 = t104 * t116;
        const float t118 = t104 * fmaf(fmaf(0.38173297f, t104, -0.30305624f), t104, 0.05897375f);
        b_1 = t103 - b_0 + t109;
        b_2 = t112 - t109;
        b_3 = t115 - t112;
        b_4 = t117 - t115;
        b_5 = t118 - t117;
        b_6 = -t118;
    }
    const bool t119 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    const float t120 = ((0.0f < radius_cos && t86) ? t83 / (1.0f + radius_cos) : 0.0f) * 6.2831855f;
    const spherecap_inline_surface_light result = {
        t119, t119 ? t120 : 0.0f, t119 ? projected_above : 0.0f, {t5 * t81, t6 * t81, t7 * t81},
        {sideways_x, sideways_y, sideways_z}, {normal[0], normal[1], normal[2]}, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, inv_above,
        {fmaf(sideways_y, normal[2], -(sideways_z * normal[1])), fmaf(sideways_z, normal[0], -(sideways_x * normal[2])), fmaf(sideways_x, normal[1], -(sideways_y * normal[0]))},
        t90 ? t91 : 0.0f, t90 ? 1.0f / (1.0f - t91) : 1.0f,
        t90 ? t92 * t92 * t92 * fmaf(cut - t_x, shape_difference, shape) : 0.0f, elevation_cos * radius_cos,
        radius_sin * t82, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
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
    const bool t3 = !(0.0f < light->elevation_sin) && t2;
    const float t4 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = light->crescent_share <= t4 && !t3;
    const bool t7 = !t2 || t6;
    const float t8 = 1.0f - t5;
    const float t9 = t5 - t8;
    const float t10 = 4.0f * t5 * t8;
    const float t11 = spherecap_inline_max((t4 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
    const float t12 = t2 ? spherecap_inline_min(t11, 0.99999994f) : t4;
    const float t13 = t2 ? light->beyond : 0.0f;
    const float t14 = 3.1415927f - t13;
    const float t15 = fmaf(t12, t14, t13);
    const float t16 = (1.0f - t12) * t14;
    float t18, t19, t20;
    float t17 = 0.0f;
    if (t7) {
        t18 = spherecap_inline_min(t15, t16) * 0.53033006f;
        t19 = 1.0f;
        t20 = 1.0f;
    } else {
        const float t21 = sqrtf(t10);
        const float t22 = fmaf(fmaf(fmaf(light->b_6, t10, light->b_4), t10, light->b_2), t10, light->b_0);
        const float t23 = t21 * fmaf(fmaf(fmaf(light->b_5, t10, light->b_3), t10, light->b_1), t21, t22);
        const float t24 = sqrtf(fmaf(t9, t9, t23 * t23));
        const float t25 = light->tau * t23;
        t20 = t3 ? fmaf(t9, t9, t25 * t25) : 1.0f;
        const float t26 = t3 ? fmaf(light->kappa, t23, t24) * fmaf(light->cut, t23, t24) : light->crescent_share;
        const float t27 = (t3 ? light->width : t4) / t26;
        const float t28 = spherecap_inline_min(spherecap_inline_max(t27, 5.9604645e-8f), 0.99999994f);
        const float t29 = t3 ? t27 : light->width;
        const float t30 = t20 * t29;
        const float t31 = t30 * t30;
        const float t32 = fmaf(fmaf(fmaf(-0.00060778117f, t31, -0.0027203285f), t31, -0.10000902f), t30, fmaf(fmaf(1.0676054e-5f, t31, -0.011332183f), t31, 1.0000001f));
        t17 = t3 ? t25 : t21;
        t18 = t3 ? t4 : t28;
        t19 = t29 * t32;
    }
    const float t33 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t18), -0.33333334f, 1419900500.0f));
    const float t34 = fmaf(-(t18 * t33), t33 * t33, 1.0f);
    const float t35 = t34 * t34;
    const float t36 = fmaf(fmaf(fmaf(0.110958695f, t35, 0.14403293f), t35, 0.22222222f), t34, fmaf(fmaf(0.12482853f, t35, 0.17283951f), t35, 0.33333334f));
    const float t37 = t19 * (t18 * fmaf(t33, t34 * t36, t33));
    const float t38 = t37 * t20;
    const float t39 = t38 * t38;
    const float t40 = fmaf(fmaf(fmaf(-0.063446075f, t39, -0.056249518f), t39, 0.0074712755f), t39, 0.09996679f);
    const float t41 = fmaf(fmaf(fmaf(0.022114987f, t39, 0.085662976f), t39, 0.030445365f), t39, 0.03209764f);
    const float t42 = t37 * fmaf(t40, t38, fmaf(t41, t39, 1.0000004f));
    const float t43 = t7 ? spherecap_inline_min(t42, 1.0f) : t42;
    const float t44 = t20 * t43;
    const float t45 = 2.0f - t44;
    const float t46 = t43 * t45;
    const float t47 = sqrtf(t46);
    float zenith, side, cosine, t48;
    if (t7) {
        const float t49 = t15 - t16 < 0.0f ? t44 : t45;
        const float t50 = t46 * t10;
        const float t51 = 1.0f - t49;
        const float t52 = spherecap_inline_max(fmaf(light->climb, t49, -light->rise), 0.0f);
        cosine = sqrtf(fmaf(t52, t52, light->radius_sin * light->radius_sin * t50));
        const float t53 = t1 * light->radius_cos;
        const float t54 = fmaf(light->elevation_cos * t51, fmaf(light->climb, t51, -2.0f * t53), light->radius_sin * t50);
        zenith = light->radius_sin * fmaf(light->elevation_cos, t54 / (cosine + t53), -(t1 * t1 * t51));
        side = light->radius_sin * t47 * t9;
        t48 = fmaf(light->half_axis, t51, light->middle);
    } else {
        cosine = t47 * t17;
        t48 = 1.0f - t44;
        zenith = fmaf(light->elevation_cos, cosine, -((t3 ? -t1 : t1) * t48));
        side = t47 * t9;
    }
    const float t55 = 0.0f < cosine ? light->inv_above : 0.0f;
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
        {t66, t67, t68}, t60 * light->distance, {t71, t72, t73}, cosine,
        t55 * spherecap_inline_min(fabsf(cosine), 3.4028235e38f), t55
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
    const float t10 = (0.0f < t6 ? light->inv_above : 0.0f) * spherecap_inline_min(fabsf(t6), 3.4028235e38f);
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
    const bool t29 = 0.0f < t8;
    const float t30 = normal_z * t14;
    const float t31 = fmaf(normal_y, t15, -t30);
    const float t32 = normal_x * t15;
    const float t33 = fmaf(normal_z, t13, -t32);
    const float t34 = normal_y * t13;
    const float t35 = fmaf(normal_x, t14, -t34);
    const float t36 = fmaf(t31, t31, fmaf(t33, t33, t35 * t35));
    float up_x, up_y, up_z, t37, t38, t39, t40, t41;
    if (t36 < t20 * 0.015625f) {
        const float t42 = t31 - spherecap_inline_lost(normal_z, t14, t30);
        const float t43 = t33 - spherecap_inline_lost(normal_x, t15, t32);
        const float t44 = t35 - spherecap_inline_lost(normal_y, t13, t34);
        const float t45 = fmaf(t42, t42, fmaf(t43, t43, t44 * t44));
        const bool t46 = t45 < t20 * 5.169879e-26f;
        const bool t47 = fabsf(t13) < fabsf(t15);
        const float t48 = t47 ? 0.0f : -t14;
        const float t49 = t47 ? -t15 : t13;
        const float t50 = t47 ? t14 : 0.0f;
        const float t51 = sqrtf(fmaf(t48, t48, fmaf(t49, t49, t50 * t50)));
        const float t52 = sqrtf(t20);
        const float t53 = t52 * t51;
        const float t54 = sqrtf(t45);
        up_x = t46 ? (t29 ? normal_x : fmaf(t14, t50, -(t15 * t49)) / t53) : normal_x;
        up_y = t46 ? (t29 ? normal_y : fmaf(t15, t48, -(t13 * t50)) / t53) : normal_y;
        up_z = t46 ? (t29 ? normal_z : fmaf(t13, t49, -(t14 * t48)) / t53) : normal_z;
        t37 = t46 ? t48 : t42;
        t38 = t46 ? t49 : t43;
        t39 = t46 ? t50 : t44;
        t40 = t46 ? t51 : t54;
        t41 = t46 ? (t29 ? 0.0f : t52) : t54;
    } else {
        t40 = sqrtf(t36);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t37 = t31;
        t38 = t33;
        t39 = t35;
        t41 = t40;
    }
    const float t55 = normal_x * t13;
    const float t56 = normal_y * t14;
    const float t57 = normal_z * t15;
    const float t58 = t55 + t56;
    const float t59 = t58 - t55;
    const float t60 = t58 + t57;
    const float t61 = t60 - t58;
    const float t62 = spherecap_inline_lost(normal_x, t13, t55) + spherecap_inline_lost(normal_y, t14, t56);
    const float t63 = t62 + spherecap_inline_lost(normal_z, t15, t57) + (t55 - (t58 - t59) + (t56 - t59) + (t58 - (t60 - t61) + (t57 - t61)));
    const float t64 = t60 + t63;
    const float t65 = t63 - (t64 - t60);
    const float t66 = t16 - t64 - t65;
    const float t67 = t16 + t64 + t65;
    const float t68 = t66 * t67;
    const float t69 = sqrtf(t21);
    const bool t70 = 0.0f < t21;
    float t71;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (0.0f < t68 && t29 && t70) {
        t71 = sqrtf(t21 + t68);
        const float t72 = sqrtf(t68);
        const float t73 = 1.0f / (t71 * t16);
        const float t74 = t73 * t16;
        const float t75 = t73 * t71;
        t_x = t69 * t74;
        t_y = t72 * t74;
        const float t76 = t_y * t_y;
        kappa = fabsf(t64) * t75;
        cut = kappa * t_x;
        const float t77 = t_x - 0.5f;
        const float t78 = cut - 0.5f;
        const float t79 = t77 * t77;
        const float t80 = t78 * t78;
        const float t81 = fmaf(0.05430631f, t79, 0.080950715f);
        const float t82 = fmaf(t81, t79, 0.1684019f);
        const float t83 = fmaf(t82, t79, 0.32709444f);
        const float t84 = fmaf(t83, t79, 0.5987523f);
        const float t85 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t80, t81), t80, t82), t80, t83), t80, t84);
        const float t86 = fmaf(-0.026061837f, t79, -0.06372378f);
        const float t87 = fmaf(t86, t79, -0.11762552f);
        const float t88 = fmaf(t87, t79, -0.23594604f);
        const float t89 = fmaf(t88, t79, -0.44721135f);
        const float t90 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t80, t86), t80, t87), t80, t88), t80, t89);
        const float t91 = fmaf(t89, t79, -0.7754678f);
        shape = fmaf(t91, t77, fmaf(t84, t79, 0.94559944f));
        shape_difference = fmaf(fmaf(t78, t90, t85), t77 + t78, t91);
        norm = fmaf(cut, shape_difference, shape);
        width = t76 / (1.0f + t_x);
        tau = t72 * t75;
        area = t76 * t_y * (spherecap_inline_min(t66, t67) * t75) * norm;
    } else {
        t71 = t41;
    }
    const float t92 = sqrtf(t20);
    const float t93 = 1.0f / t92;
    const float radius_sin = t16 * t93;
    const float radius_cos = t69 * t93;
    const float elevation_sin = t64 * t93;
    const float elevation_cos = t71 * t93;
    const float t94 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t68 * (t93 * t93) / fmaf(radius_cos, t94, climb), -(radius_cos * t94));
    const float t95 = radius_sin * radius_sin;
    const bool t96 = 0.0f < elevation_sin;
    const float t97 = t96 ? fmaf(t95 * t94, 3.1415927f, area) : area;
    const bool t98 = 9.8607613e-32f < t95;
    const float t99 = 1.0f / t40;
    const float sideways_x = t37 * t99;
    const float sideways_y = t38 * t99;
    const float sideways_z = t39 * t99;
    const float on_surface = t29 ? 1.0f : 0.0f;
    const float distance = t92 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t97 && t98 && t70) ? t97 : 0.0f;
    const bool t100 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t101 = 0.0f < inv_above;
    const float t102 = t96 ? inv_above : 0.0f;
    const float share = t101 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t103 = t100 && t96 && 0.0f < t102;
    const float t104 = t_y * t_y * t_y * shape * t102;
    const float t105 = t_y / radius_sin;
    const float beyond = t103 ? t105 * t105 * t105 * fmaf(cut - t_x, shape_difference, shape) : 0.0f;
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t100 && !t96) {
        const float t106 = 1.0f + kappa;
        const float t107 = t106 * shape;
        const float t108 = 1.0f / (norm * t107);
        const float t109 = sqrtf(t108);
        b_0 = norm * t109;
        const float t110 = 1.0f / (1.0f + cut);
        const float t111 = (t_x + kappa) * t110 - 0.5f;
        const float t112 = t111 * t111;
        const float t113 = fmaf(fmaf(fmaf(-0.026061837f, t112, -0.06372378f), t112, -0.11762552f), t112, -0.23594604f);
        const float t114 = fmaf(fmaf(fmaf(0.05430631f, t112, 0.080950715f), t112, 0.1684019f), t112, 0.32709444f);
        const float t115 = fmaf(fmaf(fmaf(t113, t112, -0.44721135f), t112, -0.7754678f), t111, fmaf(fmaf(t114, t112, 0.5987523f), t112, 0.94559944f));
        const float t116 = t106 * t115 * (t110 * t110 * t110) * (t107 * t108);
        const float t117 = fmaf(t116, t107 * t109, -1.0f);
        const float t118 = 1.0f - t116;
        const float t119 = fmaf(fmaf(30.011856f, t117, fmaf(-41.541264f, t118, -37.009792f)), t117, fmaf(77.96775f, t118, 7.470758f));
        const float t120 = fmaf(t119, t117, fmaf(fmaf(-49.13454f, t118, -9.466533f), t118, -1.5877596f));
        const float t121 = fmaf(fmaf(fmaf(15.716111f, t118, 0.0f), t118, 9.961183f), t118, -2.61785f);
        const float t122 = t117 * fmaf(t120, t117, fmaf(t121, t118, 0.8681748f));
        const float t123 = fmaf(fmaf(7.295638f, t117, -7.236236f), t117, fmaf(fmaf(fmaf(-11.4868555f, t118, 0.0f), t118, 0.0f), t118, 3.1255686f));
        const float t124 = fmaf(fmaf(fmaf(13.728438f, t118, -7.981878f), t118, 2.025724f), t118, -0.7334958f);
        const float t125 = t117 * fmaf(t123, t117, t124);
        const float t126 = fmaf(fmaf(fmaf(9.986537f, t118, 25.22195f), t118, 0.0f), t118, -2.9581387f);
        const float t127 = fmaf(fmaf(fmaf(-19.722994f, t118, 4.6594768f), t118, -0.89538246f), t118, 0.5143498f);
        const float t128 = t117 * fmaf(fmaf(fmaf(-23.220068f, t118, 7.332055f), t117, t126), t117, t127);
        const float t129 = fmaf(fmaf(fmaf(1.946617f, t117, -3.077631f), t117, 1.4945927f), t117, -0.24140751f);
        const float t130 = t117 * t129;
        const float t131 = t117 * fmaf(fmaf(0.38173297f, t117, -0.30305624f), t117, 0.05897375f);
        b_1 = t116 - b_0 + t122;
        b_2 = t125 - t122;
        b_3 = t128 - t125;
        b_4 = t130 - t128;
        b_5 = t131 - t130;
        b_6 = -t131;
    }
    const bool t132 = 0.0f < share;
    const float t133 = (0.0f < radius_cos && t98) ? t95 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t132 ? (0.0f < t133 ? 0.15915494f / t133 : 0.0f) : 0.0f;
    const bool t134 = 0.0f < inv_solid_angle && t132;
    const bool t135 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t101 || t134);
    const spherecap_inline_front_light result = {
        t135, t135 ? t133 * 6.2831855f : 0.0f, t135 ? projected_above : 0.0f,
        {t13 * t93, t14 * t93, t15 * t93}, {sideways_x, sideways_y, sideways_z},
        {normal_x, normal_y, normal_z}, {up_x, up_y, up_z}, on_surface, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, share, 1.0f - share, defensive,
        inv_above,
        {fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))},
        t132 ? t133 : 0.0f, inv_solid_angle, t103 ? t104 : 0.0f, t103 ? 1.0f / (1.0f - t104) : 1.0f, beyond,
        elevation_cos * radius_cos, radius_sin * t94, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
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
    const float t7 = 0.0f < light->requested ? spherecap_inline_min(t6, 0.99999994f) : t3;
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
    const float t18 = 3.1415927f - t17;
    const float t19 = fmaf(t16, t18, t17);
    const float t20 = (1.0f - t16) * t18;
    float t22, t23, t24;
    float t21 = 0.0f;
    if (t11) {
        t22 = spherecap_inline_min(t19, t20) * 0.53033006f;
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
        const float t35 = t34 * t34;
        const float t36 = fmaf(fmaf(fmaf(-0.00060778117f, t35, -0.0027203285f), t35, -0.10000902f), t34, fmaf(fmaf(1.0676054e-5f, t35, -0.011332183f), t35, 1.0000001f));
        t21 = t9 ? t29 : t25;
        t22 = t9 ? t7 : t32;
        t23 = t33 * t36;
    }
    const float t37 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t22), -0.33333334f, 1419900500.0f));
    const float t38 = fmaf(-(t22 * t37), t37 * t37, 1.0f);
    const float t39 = t38 * t38;
    const float t40 = fmaf(fmaf(fmaf(0.110958695f, t39, 0.14403293f), t39, 0.22222222f), t38, fmaf(fmaf(0.12482853f, t39, 0.17283951f), t39, 0.33333334f));
    const float t41 = t23 * (t22 * fmaf(t37, t38 * t40, t37));
    const float t42 = t41 * t24;
    const float t43 = t42 * t42;
    const float t44 = fmaf(fmaf(fmaf(-0.063446075f, t43, -0.056249518f), t43, 0.0074712755f), t43, 0.09996679f);
    const float t45 = fmaf(fmaf(fmaf(0.022114987f, t43, 0.085662976f), t43, 0.030445365f), t43, 0.03209764f);
    const float t46 = t41 * fmaf(t44, t42, fmaf(t45, t43, 1.0000004f));
    const float t47 = t11 ? spherecap_inline_min(t46, 1.0f) : t46;
    const float t48 = t24 * t47;
    const float t49 = 2.0f - t48;
    const float t50 = t47 * t49;
    const float t51 = sqrtf(t50);
    float zenith, side, cosine, t52, t53;
    if (t11) {
        const float t54 = t19 - t20 < 0.0f ? t48 : t49;
        const float t55 = t50 * t14;
        if (t5) {
            const float t56 = light->height * (1.0f - t55);
            const float t57 = sqrtf(light->height * (2.0f - t56));
            zenith = (t54 - 1.0f) * t57;
            const float t58 = 1.0f - t56;
            t53 = fmaf(light->elevation_sin, t58, light->elevation_cos * zenith);
            t52 = fmaf(light->elevation_cos, t58, -(light->elevation_sin * zenith));
            side = t51 * t13 * t57;
            cosine = t53 * light->on_surface;
        } else {
            const float t59 = 1.0f - t54;
            const float t60 = spherecap_inline_max(fmaf(light->climb, t54, -light->rise), 0.0f);
            t53 = sqrtf(fmaf(t60, t60, light->radius_sin * light->radius_sin * t55));
            const float t61 = t1 * light->radius_cos;
            const float t62 = fmaf(light->elevation_cos * t59, fmaf(light->climb, t59, -2.0f * t61), light->radius_sin * t55);
            zenith = light->radius_sin * fmaf(light->elevation_cos, t62 / (t53 + t61), -(t1 * t1 * t59));
            t52 = fmaf(light->half_axis, t59, light->middle);
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
    const float t63 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t64 = 0.0f < cosine ? light->inv_above : 0.0f;
    const float t65 = light->share * light->inv_solid_angle;
    const float t66 = spherecap_inline_min(t65 / spherecap_inline_max(t63, 1.1754944e-38f), 3.4028235e38f);
    const float t67 = t2 ? spherecap_inline_min(fmaf(t64, light->rest, t66), 3.4028235e38f) : t64;
    const float t68 = fmaf(zenith, zenith, side * side);
    const float t69 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t68), 0.0f);
    const float t70 = sqrtf(t69);
    const float t71 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t69));
    const float t72 = light->radius_cos * light->radius_cos / (t71 + t70);
    const float t73 = 1.0f / light->radius_sin;
    const float t74 = t72 * t73;
    const float t75 = -fmaf(t71, t70, t68) * t73;
    const float t76 = t74 * zenith;
    const float t77 = t74 * side;
    const float t78 = fmaf(light->third_axis[0], t52, fmaf(light->sideways[0], side, light->up[0] * t53));
    const float t79 = fmaf(light->third_axis[1], t52, fmaf(light->sideways[1], side, light->up[1] * t53));
    const float t80 = fmaf(light->third_axis[2], t52, fmaf(light->sideways[2], side, light->up[2] * t53));
    const float t81 = fmaf(light->elevation_cos, t75, -(light->elevation_sin * t76));
    const float t82 = fmaf(light->elevation_sin, t75, light->elevation_cos * t76);
    const float t83 = fmaf(light->third_axis[0], t81, fmaf(light->sideways[0], t77, light->up[0] * t82));
    const float t84 = fmaf(light->third_axis[1], t81, fmaf(light->sideways[1], t77, light->up[1] * t82));
    const float t85 = fmaf(light->third_axis[2], t81, fmaf(light->sideways[2], t77, light->up[2] * t82));
    const spherecap_inline_sample result = {
        {t78, t79, t80}, t72 * light->distance, {t83, t84, t85}, cosine,
        t2 ? fmaf(t64, light->rest * t63, t65) : t64 * t63, t67
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
    const float t10 = spherecap_inline_min(fabsf(t6), 3.4028235e38f);
    const float t11 = 0.0f < t6 ? light->inv_above : 0.0f;
    const float t12 = 0.0f < light->share ? fmaf(t11, light->rest * t10, light->share * light->inv_solid_angle) : t11 * t10;
    const bool t13 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t14 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t14 && t14 <= 1.002001f) ? (t13 ? t12 : 0.0f) : 0.0f;
}

static inline float spherecap_inline_front_pdf_on_sphere(const spherecap_inline_front_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const float t2 = spherecap_inline_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light->inv_above : 0.0f;
    const float t4 = 0.0f < light->share ? fmaf(t3, light->rest * t2, light->share * light->inv_solid_angle) : t3 * t2;
    const float t5 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    return (0.998001f <= t5 && t5 <= 1.002001f) ? t4 : 0.0f;
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
    const bool t29 = 0.0f < t8;
    const float t30 = normal_z * t14;
    const float t31 = fmaf(normal_y, t15, -t30);
    const float t32 = normal_x * t15;
    const float t33 = fmaf(normal_z, t13, -t32);
    const float t34 = normal_y * t13;
    const float t35 = fmaf(normal_x, t14, -t34);
    const float t36 = fmaf(t31, t31, fmaf(t33, t33, t35 * t35));
    float up_x, up_y, up_z, t37, t38, t39, t40, t41;
    if (t36 < t20 * 0.015625f) {
        const float t42 = t31 - spherecap_inline_lost(normal_z, t14, t30);
        const float t43 = t33 - spherecap_inline_lost(normal_x, t15, t32);
        const float t44 = t35 - spherecap_inline_lost(normal_y, t13, t34);
        const float t45 = fmaf(t42, t42, fmaf(t43, t43, t44 * t44));
        const bool t46 = t45 < t20 * 5.169879e-26f;
        const bool t47 = fabsf(t13) < fabsf(t15);
        const float t48 = t47 ? 0.0f : -t14;
        const float t49 = t47 ? -t15 : t13;
        const float t50 = t47 ? t14 : 0.0f;
        const float t51 = sqrtf(fmaf(t48, t48, fmaf(t49, t49, t50 * t50)));
        const float t52 = sqrtf(t20);
        const float t53 = t52 * t51;
        const float t54 = sqrtf(t45);
        up_x = t46 ? (t29 ? normal_x : fmaf(t14, t50, -(t15 * t49)) / t53) : normal_x;
        up_y = t46 ? (t29 ? normal_y : fmaf(t15, t48, -(t13 * t50)) / t53) : normal_y;
        up_z = t46 ? (t29 ? normal_z : fmaf(t13, t49, -(t14 * t48)) / t53) : normal_z;
        t37 = t46 ? t48 : t42;
        t38 = t46 ? t49 : t43;
        t39 = t46 ? t50 : t44;
        t40 = t46 ? t51 : t54;
        t41 = t46 ? (t29 ? 0.0f : t52) : t54;
    } else {
        t40 = sqrtf(t36);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t37 = t31;
        t38 = t33;
        t39 = t35;
        t41 = t40;
    }
    const float t55 = normal_x * t13;
    const float t56 = normal_y * t14;
    const float t57 = normal_z * t15;
    const float t58 = t55 + t56;
    const float t59 = t58 - t55;
    const float t60 = t58 + t57;
    const float t61 = t60 - t58;
    const float t62 = spherecap_inline_lost(normal_x, t13, t55) + spherecap_inline_lost(normal_y, t14, t56);
    const float t63 = t62 + spherecap_inline_lost(normal_z, t15, t57) + (t55 - (t58 - t59) + (t56 - t59) + (t58 - (t60 - t61) + (t57 - t61)));
    const float t64 = t60 + t63;
    const float t65 = t63 - (t64 - t60);
    const float t66 = t16 - t64 - t65;
    const float t67 = t16 + t64 + t65;
    const float t68 = t66 * t67;
    const float t69 = sqrtf(t21);
    const bool t70 = 0.0f < t21;
    float t71;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (0.0f < t68 && t29 && t70) {
        t71 = sqrtf(t21 + t68);
        const float t72 = sqrtf(t68);
        const float t73 = 1.0f / (t71 * t16);
        const float t74 = t73 * t16;
        const float t75 = t73 * t71;
        t_x = t69 * t74;
        t_y = t72 * t74;
        const float t76 = t_y * t_y;
        kappa = fabsf(t64) * t75;
        cut = kappa * t_x;
        const float t77 = t_x - 0.5f;
        const float t78 = cut - 0.5f;
        const float t79 = t77 * t77;
        const float t80 = t78 * t78;
        const float t81 = fmaf(0.05430631f, t79, 0.080950715f);
        const float t82 = fmaf(t81, t79, 0.1684019f);
        const float t83 = fmaf(t82, t79, 0.32709444f);
        const float t84 = fmaf(t83, t79, 0.5987523f);
        const float t85 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t80, t81), t80, t82), t80, t83), t80, t84);
        const float t86 = fmaf(-0.026061837f, t79, -0.06372378f);
        const float t87 = fmaf(t86, t79, -0.11762552f);
        const float t88 = fmaf(t87, t79, -0.23594604f);
        const float t89 = fmaf(t88, t79, -0.44721135f);
        const float t90 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t80, t86), t80, t87), t80, t88), t80, t89);
        const float t91 = fmaf(t89, t79, -0.7754678f);
        shape = fmaf(t91, t77, fmaf(t84, t79, 0.94559944f));
        shape_difference = fmaf(fmaf(t78, t90, t85), t77 + t78, t91);
        norm = fmaf(cut, shape_difference, shape);
        width = t76 / (1.0f + t_x);
        tau = t72 * t75;
        area = t76 * t_y * (spherecap_inline_min(t66, t67) * t75) * norm;
    } else {
        t71 = t41;
    }
    const float t92 = sqrtf(t20);
    const float t93 = 1.0f / t92;
    const float radius_sin = t16 * t93;
    const float radius_cos = t69 * t93;
    const float elevation_sin = t64 * t93;
    const float elevation_cos = t71 * t93;
    const float t94 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t68 * (t93 * t93) / fmaf(radius_cos, t94, climb), -(radius_cos * t94));
    const float t95 = radius_sin * radius_sin;
    const float t96 = fmaf(t95 * t94, 3.1415927f, area);
    const bool t97 = 0.0f < elevation_sin;
    const float t98 = t97 ? t96 : area;
    const float t99 = t97 ? area : t96;
    const bool t100 = 9.8607613e-32f < t95;
    const bool t101 = t100 && t70;
    const float t102 = 1.0f / t40;
    const float sideways_x = t37 * t102;
    const float sideways_y = t38 * t102;
    const float sideways_z = t39 * t102;
    const float on_surface = t29 ? 1.0f : 0.0f;
    const float distance = t92 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t98 && t101) ? t98 : 0.0f;
    const float projected_below = (9.403955e-38f < t99 && t101) ? t99 : 0.0f;
    const bool t103 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float inv_below = 0.0f < projected_below ? 1.0f / projected_below : 0.0f;
    const bool t104 = 0.0f < inv_above + inv_below;
    const float t105 = t97 ? inv_above : inv_below;
    const float defensive_share = t104 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t106 = 0.0f < t105 && t103;
    const float t107 = t_y * t_y * t_y * shape * t105;
    const float t108 = t_y / radius_sin;
    const float t109 = fmaf(cut - t_x, shape_difference, shape);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    float t110 = 0.0f;
    if (t103) {
        const float t111 = 1.0f + kappa;
        const float t112 = t111 * shape;
        const float t113 = 1.0f / (norm * t112);
        const float t114 = sqrtf(t113);
        b_0 = norm * t114;
        const float t115 = 1.0f / (1.0f + cut);
        const float t116 = (t_x + kappa) * t115 - 0.5f;
        const float t117 = t116 * t116;
        const float t118 = fmaf(fmaf(fmaf(-0.026061837f, t117, -0.06372378f), t117, -0.11762552f), t117, -0.23594604f);
        const float t119 = fmaf(fmaf(fmaf(0.05430631f, t117, 0.080950715f), t117, 0.1684019f), t117, 0.32709444f);
        const float t120 = fmaf(fmaf(fmaf(t118, t117, -0.44721135f), t117, -0.7754678f), t116, fmaf(fmaf(t119, t117, 0.5987523f), t117, 0.94559944f));
        const float t121 = t111 * t120 * (t115 * t115 * t115) * (t112 * t113);
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
        const float t153 = fmaf(kappa * t139, fmaf(fmaf(t141, t152, t147), t140 + t141, fmaf(t151, t142, -0.7754678f)), fmaf(t109, t139 - kappa * kappa, kappa) * t137);
        const float t154 = spherecap_inline_max(t138 * tau * (radius_cos + 1.0f) * t153 * 0.31830987f, 0.0f);
        b_1 = t121 - b_0 + t127;
        b_2 = t130 - t127;
        b_3 = t133 - t130;
        b_4 = t135 - t133;
        b_5 = t136 - t135;
        b_6 = -t136;
        t110 = spherecap_inline_min(t154, 0.5f);
    }
    const bool t155 = 0.0f < defensive_share;
    const float t156 = (0.0f < radius_cos && t100) ? t95 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t155 ? (0.0f < t156 ? 0.15915494f / t156 : 0.0f) : 0.0f;
    const float t157 = 1.0f - t110;
    const bool t158 = 0.0f < inv_below;
    const bool t159 = 0.0f < inv_above;
    const bool t160 = 0.0f < inv_solid_angle && t155;
    const bool t161 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t104 || t160);
    const spherecap_inline_both_light result = {
        t161, t161 ? t156 * 6.2831855f : 0.0f, t161 ? projected_above : 0.0f,
        {t13 * t93, t14 * t93, t15 * t93}, {sideways_x, sideways_y, sideways_z},
        {normal_x, normal_y, normal_z}, {up_x, up_y, up_z}, on_surface, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, defensive_share, 1.0f - defensive_share,
        defensive, inv_above, inv_below, t158 ? (t159 ? (t97 ? t157 : t110) : 0.0f) : 1.0f,
        t159 ? (t158 ? (t97 ? t110 : t157) : 0.0f) : 1.0f,
        {fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))},
        t155 ? t156 : 0.0f, inv_solid_angle, t106 ? t107 : 0.0f, t106 ? 1.0f / (1.0f - t107) : 1.0f,
        t106 ? t108 * t108 * t108 * t109 : 0.0f, elevation_cos * radius_cos, radius_sin * t94, climb, b_0,
        b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

static inline spherecap_inline_sample spherecap_inline_both_sample(const spherecap_inline_both_light *light, float u0, float u1)
{
    if (!light->is_sampled) {
        return spherecap_inline_no_sample();
    }
    const float t1 = fabsf(light->elevation_sin);
    const bool t2 = 0.0f < light->elevation_sin;
    const bool t3 = 0.0f < light->defensive_share;
    const float t4 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = t4 < light->defensive_share && t3;
    const float t7 = (t6 ? t4 : t4 - light->defensive_share) / (t6 ? light->defensive_share : light->defensive_rest);
    const float t8 = spherecap_inline_min(spherecap_inline_max(t7, 5.9604645e-8f), 0.99999994f);
    const float t9 = 0.0f < light->requested ? t8 : t4;
    const bool t10 = t9 < light->sides_share || t6;
    const float t11 = (t10 ? t9 : t9 - light->sides_share) / (t10 ? light->sides_share : light->sides_rest);
    const float t12 = spherecap_inline_min(spherecap_inline_max(t11, 5.9604645e-8f), 0.99999994f);
    const bool t13 = t10 && t2;
    const bool t14 = !t10 && !t2;
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
    const float t26 = 3.1415927f - t25;
    const float t27 = fmaf(t24, t26, t25);
    const float t28 = (1.0f - t24) * t26;
    float t30, t31, t32;
    float t29 = 0.0f;
    if (t19) {
        t30 = spherecap_inline_min(t27, t28) * 0.53033006f;
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
        const float t43 = t42 * t42;
        const float t44 = fmaf(fmaf(fmaf(-0.00060778117f, t43, -0.0027203285f), t43, -0.10000902f), t42, fmaf(fmaf(1.0676054e-5f, t43, -0.011332183f), t43, 1.0000001f));
        t29 = t17 ? t37 : t33;
        t30 = t17 ? t15 : t40;
        t31 = t41 * t44;
    }
    const float t45 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t30), -0.33333334f, 1419900500.0f));
    const float t46 = fmaf(-(t30 * t45), t45 * t45, 1.0f);
    const float t47 = t46 * t46;
    const float t48 = fmaf(fmaf(fmaf(0.110958695f, t47, 0.14403293f), t47, 0.22222222f), t46, fmaf(fmaf(0.12482853f, t47, 0.17283951f), t47, 0.33333334f));
    const float t49 = t31 * (t30 * fmaf(t45, t46 * t48, t45));
    const float t50 = t49 * t32;
    const float t51 = t50 * t50;
    const float t52 = fmaf(fmaf(fmaf(-0.063446075f, t51, -0.056249518f), t51, 0.0074712755f), t51, 0.09996679f);
    const float t53 = fmaf(fmaf(fmaf(0.022114987f, t51, 0.085662976f), t51, 0.030445365f), t51, 0.03209764f);
    const float t54 = t49 * fmaf(t52, t50, fmaf(t53, t51, 1.0000004f));
    const float t55 = t19 ? spherecap_inline_min(t54, 1.0f) : t54;
    const float t56 = t32 * t55;
    const float t57 = 2.0f - t56;
    const float t58 = t55 * t57;
    const float t59 = sqrtf(t58);
    float side, t60, t61, t62, t63;
    if (t19) {
        const float t64 = t27 - t28 < 0.0f ? t56 : t57;
        const float t65 = t58 * t22;
        if (t6) {
            const float t66 = light->height * (1.0f - t65);
            const float t67 = sqrtf(light->height * (2.0f - t66));
            t62 = (t64 - 1.0f) * t67;
            const float t68 = 1.0f - t66;
            t61 = fmaf(light->elevation_sin, t68, light->elevation_cos * t62);
            t60 = fmaf(light->elevation_cos, t68, -(light->elevation_sin * t62));
            side = t59 * t21 * t67;
            t63 = t61 * light->on_surface;
        } else {
            const float t69 = 1.0f - t64;
            const float t70 = spherecap_inline_max(fmaf(light->climb, t64, -light->rise), 0.0f);
            t61 = sqrtf(fmaf(t70, t70, light->radius_sin * light->radius_sin * t65));
            const float t71 = t1 * light->radius_cos;
            const float t72 = fmaf(light->elevation_cos * t69, fmaf(light->climb, t69, -2.0f * t71), light->radius_sin * t65);
            t62 = light->radius_sin * fmaf(light->elevation_cos, t72 / (t61 + t71), -(t1 * t1 * t69));
            t60 = fmaf(light->half_axis, t69, light->middle);
            side = light->radius_sin * t59 * t21;
            t63 = t61;
        }
    } else {
        t61 = t59 * t29;
        t60 = 1.0f - t56;
        side = t59 * t21;
        t62 = fmaf(light->elevation_cos, t61, -((t17 ? -t1 : t1) * t60));
        t63 = t61;
    }
    const float t73 = t10 ? 1.0f : -1.0f;
    const float zenith = t62 * t73;
    const float cosine = t63 * t73;
    const float t74 = t61 * t73;
    const float t75 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t76 = 0.0f < cosine ? light->inv_above * light->sides_share : cosine < 0.0f ? light->inv_below * light->sides_rest : 0.0f;
    const float t77 = light->defensive_share * light->inv_solid_angle;
    const float t78 = spherecap_inline_min(t77 / spherecap_inline_max(t75, 1.1754944e-38f), 3.4028235e38f);
    const float t79 = spherecap_inline_min(fmaf(t76, light->defensive_rest, t78), 3.4028235e38f);
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
        t3 ? fmaf(t76, light->defensive_rest * t75, t77) : t76 * t75, t3 ? t79 : t76
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
