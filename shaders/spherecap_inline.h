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
    const float t1 = fmaf(centre[0], centre[0], fmaf(centre[1], centre[1], centre[2] * centre[2]));
    const bool t2 = t1 < 1099511600000.0f && 9.536743e-7f < radius;
    const float t3 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t3, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t4 = t2 ? centre[0] : centre[0] * scale;
    const float t5 = t2 ? centre[1] : centre[1] * scale;
    const float t6 = t2 ? centre[2] : centre[2] * scale;
    const float t7 = t2 ? radius : radius * scale;
    const float t8 = t6 * t6;
    const float t9 = fmaf(t4, t4, fmaf(t5, t5, t8));
    const float t10 = fmaf(-t7, t7, t9);
    float t11 = 0.0f;
    float t12 = 0.0f;
    if (t10 < t9 * 0.25f) {
        const float t13 = t4 * t4;
        const float t14 = t5 * t5;
        const float t15 = t13 + t14;
        const float t16 = t15 - t13;
        const float t17 = t15 + t8;
        const float t18 = t17 - t15;
        const float t19 = spherecap_inline_lost(t4, t4, t13) + spherecap_inline_lost(t5, t5, t14) + spherecap_inline_lost(t6, t6, t8);
        const float t20 = t19 + (t13 - (t15 - t16) + (t14 - t16) + (t15 - (t17 - t18) + (t8 - t18)));
        t11 = t17;
        t12 = fmaf(-t7, t7, t17) + t20;
    } else {
        t11 = t9;
        t12 = t10;
    }
    const float t21 = normal[2] * t5;
    const float t22 = fmaf(normal[1], t6, -t21);
    const float t23 = normal[0] * t6;
    const float t24 = fmaf(normal[2], t4, -t23);
    const float t25 = normal[1] * t4;
    const float t26 = fmaf(normal[0], t5, -t25);
    const float t27 = fmaf(t22, t22, fmaf(t24, t24, t26 * t26));
    float t28 = 0.0f;
    float t29 = 0.0f;
    float t30 = 0.0f;
    float t31 = 0.0f;
    float t32 = 0.0f;
    if (t27 < t11 * 0.015625f) {
        const float t33 = t22 - spherecap_inline_lost(normal[2], t5, t21);
        const float t34 = t24 - spherecap_inline_lost(normal[0], t6, t23);
        const float t35 = t26 - spherecap_inline_lost(normal[1], t4, t25);
        const float t36 = fmaf(t33, t33, fmaf(t34, t34, t35 * t35));
        const bool t37 = t36 < t11 * 5.169879e-26f;
        const bool t38 = fabsf(t4) < fabsf(t6);
        const float t39 = t38 ? 0.0f : -t5;
        const float t40 = t38 ? -t6 : t4;
        const float t41 = t38 ? t5 : 0.0f;
        const float t42 = sqrtf(t36);
        t28 = t37 ? t39 : t33;
        t29 = t37 ? t40 : t34;
        t30 = t37 ? t41 : t35;
        t31 = t37 ? sqrtf(fmaf(t39, t39, fmaf(t40, t40, t41 * t41))) : t42;
        t32 = t37 ? 0.0f : t42;
    } else {
        const float t43 = sqrtf(t27);
        t28 = t22;
        t29 = t24;
        t30 = t26;
        t31 = t43;
        t32 = t43;
    }
    const float t44 = normal[0] * t4;
    const float t45 = normal[1] * t5;
    const float t46 = normal[2] * t6;
    const float t47 = t44 + t45;
    const float t48 = t47 - t44;
    const float t49 = t47 + t46;
    const float t50 = t49 - t47;
    const float t51 = spherecap_inline_lost(normal[0], t4, t44) + spherecap_inline_lost(normal[1], t5, t45);
    const float t52 = t51 + spherecap_inline_lost(normal[2], t6, t46) + (t44 - (t47 - t48) + (t45 - t48) + (t47 - (t49 - t50) + (t46 - t50)));
    const float t53 = t49 + t52;
    const float t54 = t52 - (t53 - t49);
    const float t55 = t7 - t53 - t54;
    const float t56 = t7 + t53 + t54;
    const float t57 = t55 * t56;
    const float t58 = sqrtf(t12);
    const bool t59 = 0.0f < t12;
    float t_x = 0.0f;
    float t_y = 0.0f;
    float width = 0.0f;
    float kappa = 0.0f;
    float cut = 0.0f;
    float shape = 0.0f;
    float shape_difference = 0.0f;
    float norm = 0.0f;
    float tau = 0.0f;
    float area = 0.0f;
    float t60 = 0.0f;
    if (0.0f < t57 && t59) {
        const float t61 = sqrtf(t12 + t57);
        const float t62 = sqrtf(t57);
        const float t63 = 1.0f / (t61 * t7);
        const float t64 = t63 * t7;
        const float t65 = t63 * t61;
        const float t66 = t58 * t64;
        const float t67 = t62 * t64;
        const float t68 = t67 * t67;
        const float t69 = fabsf(t53) * t65;
        const float t70 = t69 * t66;
        const float t71 = t66 - 0.5f;
        const float t72 = t70 - 0.5f;
        const float t73 = t71 * t71;
        const float t74 = t72 * t72;
        const float t75 = fmaf(0.05430631f, t73, 0.080950715f);
        const float t76 = fmaf(t75, t73, 0.1684019f);
        const float t77 = fmaf(t76, t73, 0.32709444f);
        const float t78 = fmaf(t77, t73, 0.5987523f);
        const float t79 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t74, t75), t74, t76), t74, t77), t74, t78);
        const float t80 = fmaf(-0.026061837f, t73, -0.06372378f);
        const float t81 = fmaf(t80, t73, -0.11762552f);
        const float t82 = fmaf(t81, t73, -0.23594604f);
        const float t83 = fmaf(t82, t73, -0.44721135f);
        const float t84 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t74, t80), t74, t81), t74, t82), t74, t83);
        const float t85 = fmaf(t83, t73, -0.7754678f);
        const float t86 = fmaf(t85, t71, fmaf(t78, t73, 0.94559944f));
        const float t87 = fmaf(fmaf(t72, t84, t79), t71 + t72, t85);
        const float t88 = fmaf(t70, t87, t86);
        t_x = t66;
        t_y = t67;
        width = t68 / (1.0f + t66);
        kappa = t69;
        cut = t70;
        shape = t86;
        shape_difference = t87;
        norm = t88;
        tau = t62 * t65;
        area = t68 * t67 * (spherecap_inline_min(t55, t56) * t65) * t88;
        t60 = t61;
    } else {
        t60 = t32;
    }
    const float t89 = sqrtf(t11);
    const float t90 = 1.0f / t89;
    const float radius_sin = t7 * t90;
    const float radius_cos = t58 * t90;
    const float elevation_sin = t53 * t90;
    const float elevation_cos = t60 * t90;
    const float t91 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t57 * (t90 * t90) / fmaf(radius_cos, t91, climb), -(radius_cos * t91));
    const float t92 = radius_sin * radius_sin;
    const bool t93 = 0.0f < elevation_sin;
    const float t94 = t93 ? fmaf(t92 * t91, 3.1415927f, area) : area;
    const bool t95 = 9.8607613e-32f < t92;
    const float t96 = 1.0f / t31;
    const float sideways_x = t28 * t96;
    const float sideways_y = t29 * t96;
    const float sideways_z = t30 * t96;
    const float distance = t89 * (t2 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t94 && t95 && t59) ? t94 : 0.0f;
    const bool t97 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float t98 = t93 ? inv_above : 0.0f;
    const bool t99 = t97 && t93 && 0.0f < t98;
    const float t100 = t_y * t_y * t_y * shape * t98;
    const float t101 = t_y / radius_sin;
    const float beyond = t99 ? t101 * t101 * t101 * fmaf(cut - t_x, shape_difference, shape) : 0.0f;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (t97 && !t93) {
        const float t102 = 1.0f + kappa;
        const float t103 = t102 * shape;
        const float t104 = 1.0f / (norm * t103);
        const float t105 = sqrtf(t104);
        const float t106 = norm * t105;
        const float t107 = 1.0f / (1.0f + cut);
        const float t108 = (t_x + kappa) * t107 - 0.5f;
        const float t109 = t108 * t108;
        const float t110 = fmaf(fmaf(fmaf(-0.026061837f, t109, -0.06372378f), t109, -0.11762552f), t109, -0.23594604f);
        const float t111 = fmaf(fmaf(fmaf(0.05430631f, t109, 0.080950715f), t109, 0.1684019f), t109, 0.32709444f);
        const float t112 = fmaf(fmaf(fmaf(t110, t109, -0.44721135f), t109, -0.7754678f), t108, fmaf(fmaf(t111, t109, 0.5987523f), t109, 0.94559944f));
        const float t113 = t102 * t112 * (t107 * t107 * t107) * (t103 * t104);
        const float t114 = fmaf(t113, t103 * t105, -1.0f);
        const float t115 = 1.0f - t113;
        const float t116 = fmaf(fmaf(30.011856f, t114, fmaf(-41.541264f, t115, -37.009792f)), t114, fmaf(77.96775f, t115, 7.470758f));
        const float t117 = fmaf(t116, t114, fmaf(fmaf(-49.13454f, t115, -9.466533f), t115, -1.5877596f));
        const float t118 = fmaf(fmaf(fmaf(15.716111f, t115, 0.0f), t115, 9.961183f), t115, -2.61785f);
        const float t119 = t114 * fmaf(t117, t114, fmaf(t118, t115, 0.8681748f));
        const float t120 = fmaf(fmaf(7.295638f, t114, -7.236236f), t114, fmaf(fmaf(fmaf(-11.4868555f, t115, 0.0f), t115, 0.0f), t115, 3.1255686f));
        const float t121 = fmaf(fmaf(fmaf(13.728438f, t115, -7.981878f), t115, 2.025724f), t115, -0.7334958f);
        const float t122 = t114 * fmaf(t120, t114, t121);
        const float t123 = fmaf(fmaf(fmaf(9.986537f, t115, 25.22195f), t115, 0.0f), t115, -2.9581387f);
        const float t124 = fmaf(fmaf(fmaf(-19.722994f, t115, 4.6594768f), t115, -0.89538246f), t115, 0.5143498f);
        const float t125 = t114 * fmaf(fmaf(fmaf(-23.220068f, t115, 7.332055f), t114, t123), t114, t124);
        const float t126 = fmaf(fmaf(fmaf(1.946617f, t114, -3.077631f), t114, 1.4945927f), t114, -0.24140751f);
        const float t127 = t114 * t126;
        const float t128 = t114 * fmaf(fmaf(0.38173297f, t114, -0.30305624f), t114, 0.05897375f);
        coefficients_0 = t106;
        coefficients_1 = t113 - t106 + t119;
        coefficients_2 = t122 - t119;
        coefficients_3 = t125 - t122;
        coefficients_4 = t127 - t125;
        coefficients_5 = t128 - t127;
        coefficients_6 = -t128;
    }
    const bool t129 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    const float t130 = ((t95 && 0.0f < radius_cos) ? t92 / (1.0f + radius_cos) : 0.0f) * 6.2831855f;
    spherecap_inline_surface_light light;
    light.is_sampled = t129;
    light.solid_angle = t129 ? t130 : 0.0f;
    light.projected_solid_angle = t129 ? projected_above : 0.0f;
    light.towards_centre[0] = t4 * t90;
    light.towards_centre[1] = t5 * t90;
    light.towards_centre[2] = t6 * t90;
    light.sideways[0] = sideways_x;
    light.sideways[1] = sideways_y;
    light.sideways[2] = sideways_z;
    light.normal[0] = normal[0];
    light.normal[1] = normal[1];
    light.normal[2] = normal[2];
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.tau = tau;
    light.kappa = kappa;
    light.width = width;
    light.cut = cut;
    light.rise = rise;
    light.inv_above = inv_above;
    light.third_axis[0] = fmaf(sideways_y, normal[2], -(sideways_z * normal[1]));
    light.third_axis[1] = fmaf(sideways_z, normal[0], -(sideways_x * normal[2]));
    light.third_axis[2] = fmaf(sideways_x, normal[1], -(sideways_y * normal[0]));
    light.crescent_share = t99 ? t100 : 0.0f;
    light.inv_rest = t99 ? 1.0f / (1.0f - t100) : 1.0f;
    light.beyond = beyond;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t91;
    light.climb = climb;
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
    const bool t2 = 0.0f < light->tau;
    const bool t3 = t2 && !(0.0f < light->elevation_sin);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = !t2 || (!t3 && light->crescent_share <= t4);
    const float t7 = 1.0f - t5;
    const float t8 = t5 - t7;
    const float t9 = 4.0f * t5 * t7;
    const float t10 = spherecap_inline_max((t4 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
    const float t11 = t2 ? spherecap_inline_min(t10, 0.99999994f) : t4;
    const float t12 = t2 ? light->beyond : 0.0f;
    const float t13 = 3.1415927f - t12;
    const float t14 = fmaf(t11, t13, t12);
    const float t15 = (1.0f - t11) * t13;
    float t16 = 0.0f;
    float t17 = 0.0f;
    float t18 = 0.0f;
    float t19 = 0.0f;
    if (t6) {
        t17 = spherecap_inline_min(t14, t15) * 0.53033006f;
        t18 = 1.0f;
        t19 = 1.0f;
    } else {
        const float t20 = sqrtf(t9);
        const float t21 = fmaf(fmaf(light->coefficients_6, t9, light->coefficients_4), t9, light->coefficients_2);
        const float t22 = fmaf(fmaf(light->coefficients_5, t9, light->coefficients_3), t9, light->coefficients_1);
        const float t23 = t20 * fmaf(t22, t20, fmaf(t21, t9, light->coefficients_0));
        const float t24 = sqrtf(fmaf(t8, t8, t23 * t23));
        const float t25 = light->tau * t23;
        const float t26 = t3 ? fmaf(t8, t8, t25 * t25) : 1.0f;
        const float t27 = t3 ? fmaf(light->kappa, t23, t24) * fmaf(light->cut, t23, t24) : light->crescent_share;
        const float t28 = (t3 ? light->width : t4) / t27;
        const float t29 = spherecap_inline_min(spherecap_inline_max(t28, 5.9604645e-8f), 0.99999994f);
        const float t30 = t3 ? t28 : light->width;
        const float t31 = t26 * t30;
        const float t32 = t31 * t31;
        const float t33 = fmaf(fmaf(fmaf(-0.00060778117f, t32, -0.0027203285f), t32, -0.10000902f), t31, fmaf(fmaf(1.0676054e-5f, t32, -0.011332183f), t32, 1.0000001f));
        t16 = t3 ? t25 : t20;
        t17 = t3 ? t4 : t29;
        t18 = t30 * t33;
        t19 = t26;
    }
    const float t34 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t17), -0.33333334f, 1419900500.0f));
    const float t35 = fmaf(-(t17 * t34), t34 * t34, 1.0f);
    const float t36 = t35 * t35;
    const float t37 = fmaf(fmaf(fmaf(0.110958695f, t36, 0.14403293f), t36, 0.22222222f), t35, fmaf(fmaf(0.12482853f, t36, 0.17283951f), t36, 0.33333334f));
    const float t38 = t18 * (t17 * fmaf(t34, t35 * t37, t34));
    const float t39 = t38 * t19;
    const float t40 = t39 * t39;
    const float t41 = fmaf(fmaf(fmaf(-0.063446075f, t40, -0.056249518f), t40, 0.0074712755f), t40, 0.09996679f);
    const float t42 = fmaf(fmaf(fmaf(0.022114987f, t40, 0.085662976f), t40, 0.030445365f), t40, 0.03209764f);
    const float t43 = t38 * fmaf(t41, t39, fmaf(t42, t40, 1.0000004f));
    const float t44 = t6 ? spherecap_inline_min(t43, 1.0f) : t43;
    const float t45 = t19 * t44;
    const float t46 = 2.0f - t45;
    const float t47 = t44 * t46;
    const float t48 = sqrtf(t47);
    float t49 = 0.0f;
    float t50 = 0.0f;
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t6) {
        const float t51 = t14 - t15 < 0.0f ? t45 : t46;
        const float t52 = t47 * t9;
        const float t53 = 1.0f - t51;
        const float t54 = spherecap_inline_max(fmaf(light->climb, t51, -light->rise), 0.0f);
        const float t55 = sqrtf(fmaf(t54, t54, light->radius_sin * light->radius_sin * t52));
        const float t56 = t1 * light->radius_cos;
        const float t57 = fmaf(light->elevation_cos * t53, fmaf(light->climb, t53, -2.0f * t56), light->radius_sin * t52);
        const float t58 = light->radius_sin * fmaf(light->elevation_cos, t57 / (t55 + t56), -(t1 * t1 * t53));
        t49 = fmaf(light->half_axis, t53, light->middle);
        t50 = t55;
        zenith = t58;
        side = light->radius_sin * t48 * t8;
        cosine = t55;
    } else {
        const float t59 = t48 * t16;
        const float t60 = 1.0f - t45;
        t49 = t60;
        t50 = t59;
        zenith = fmaf(light->elevation_cos, t59, -((t3 ? -t1 : t1) * t60));
        side = t48 * t8;
        cosine = t59;
    }
    const float t61 = 0.0f < cosine ? light->inv_above : 0.0f;
    const float t62 = fmaf(zenith, zenith, side * side);
    const float t63 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t62), 0.0f);
    const float t64 = sqrtf(t63);
    const float t65 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t63));
    const float t66 = light->radius_cos * light->radius_cos / (t65 + t64);
    const float t67 = 1.0f / light->radius_sin;
    const float t68 = t66 * t67;
    const float t69 = -fmaf(t65, t64, t62) * t67;
    const float t70 = t68 * zenith;
    const float t71 = t68 * side;
    const float t72 = fmaf(light->third_axis[0], t49, fmaf(light->sideways[0], side, light->normal[0] * t50));
    const float t73 = fmaf(light->third_axis[1], t49, fmaf(light->sideways[1], side, light->normal[1] * t50));
    const float t74 = fmaf(light->third_axis[2], t49, fmaf(light->sideways[2], side, light->normal[2] * t50));
    const float t75 = fmaf(light->elevation_cos, t69, -(light->elevation_sin * t70));
    const float t76 = fmaf(light->elevation_sin, t69, light->elevation_cos * t70);
    const float t77 = fmaf(light->third_axis[0], t75, fmaf(light->sideways[0], t71, light->normal[0] * t76));
    const float t78 = fmaf(light->third_axis[1], t75, fmaf(light->sideways[1], t71, light->normal[1] * t76));
    const float t79 = fmaf(light->third_axis[2], t75, fmaf(light->sideways[2], t71, light->normal[2] * t76));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t72;
    sampled.direction[1] = t73;
    sampled.direction[2] = t74;
    sampled.distance = t66 * light->distance;
    sampled.normal[0] = t77;
    sampled.normal[1] = t78;
    sampled.normal[2] = t79;
    sampled.cosine = cosine;
    sampled.pdf = t61 * spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    sampled.projected_pdf = t61;
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
    float defensive_share;
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
    const float t9 = fmaf(centre[0], centre[0], fmaf(centre[1], centre[1], centre[2] * centre[2]));
    const bool t10 = t9 < 1099511600000.0f && 9.536743e-7f < radius;
    const float t11 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t11, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t12 = t10 ? centre[0] : centre[0] * scale;
    const float t13 = t10 ? centre[1] : centre[1] * scale;
    const float t14 = t10 ? centre[2] : centre[2] * scale;
    const float t15 = t10 ? radius : radius * scale;
    const float t16 = t14 * t14;
    const float t17 = fmaf(t12, t12, fmaf(t13, t13, t16));
    const float t18 = fmaf(-t15, t15, t17);
    float t19 = 0.0f;
    float t20 = 0.0f;
    if (t18 < t17 * 0.25f) {
        const float t21 = t12 * t12;
        const float t22 = t13 * t13;
        const float t23 = t21 + t22;
        const float t24 = t23 - t21;
        const float t25 = t23 + t16;
        const float t26 = t25 - t23;
        const float t27 = spherecap_inline_lost(t12, t12, t21) + spherecap_inline_lost(t13, t13, t22);
        const float t28 = t27 + spherecap_inline_lost(t14, t14, t16) + (t21 - (t23 - t24) + (t22 - t24) + (t23 - (t25 - t26) + (t16 - t26)));
        t19 = t25;
        t20 = fmaf(-t15, t15, t25) + t28;
    } else {
        t19 = t17;
        t20 = t18;
    }
    const bool t29 = 0.0f < t8;
    const float t30 = normal_z * t13;
    const float t31 = fmaf(normal_y, t14, -t30);
    const float t32 = normal_x * t14;
    const float t33 = fmaf(normal_z, t12, -t32);
    const float t34 = normal_y * t12;
    const float t35 = fmaf(normal_x, t13, -t34);
    const float t36 = fmaf(t31, t31, fmaf(t33, t33, t35 * t35));
    float up_x = 0.0f;
    float up_y = 0.0f;
    float up_z = 0.0f;
    float t37 = 0.0f;
    float t38 = 0.0f;
    float t39 = 0.0f;
    float t40 = 0.0f;
    float t41 = 0.0f;
    if (t36 < t19 * 0.015625f) {
        const float t42 = t31 - spherecap_inline_lost(normal_z, t13, t30);
        const float t43 = t33 - spherecap_inline_lost(normal_x, t14, t32);
        const float t44 = t35 - spherecap_inline_lost(normal_y, t12, t34);
        const float t45 = fmaf(t42, t42, fmaf(t43, t43, t44 * t44));
        const bool t46 = t45 < t19 * 5.169879e-26f;
        const bool t47 = fabsf(t12) < fabsf(t14);
        const float t48 = t47 ? 0.0f : -t13;
        const float t49 = t47 ? -t14 : t12;
        const float t50 = t47 ? t13 : 0.0f;
        const float t51 = sqrtf(fmaf(t48, t48, fmaf(t49, t49, t50 * t50)));
        const float t52 = sqrtf(t19);
        const float t53 = t52 * t51;
        const float t54 = sqrtf(t45);
        up_x = t46 ? (t29 ? normal_x : fmaf(t13, t50, -(t14 * t49)) / t53) : normal_x;
        up_y = t46 ? (t29 ? normal_y : fmaf(t14, t48, -(t12 * t50)) / t53) : normal_y;
        up_z = t46 ? (t29 ? normal_z : fmaf(t12, t49, -(t13 * t48)) / t53) : normal_z;
        t37 = t46 ? t48 : t42;
        t38 = t46 ? t49 : t43;
        t39 = t46 ? t50 : t44;
        t40 = t46 ? t51 : t54;
        t41 = t46 ? (t29 ? 0.0f : t52) : t54;
    } else {
        const float t55 = sqrtf(t36);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t37 = t31;
        t38 = t33;
        t39 = t35;
        t40 = t55;
        t41 = t55;
    }
    const float t56 = normal_x * t12;
    const float t57 = normal_y * t13;
    const float t58 = normal_z * t14;
    const float t59 = t56 + t57;
    const float t60 = t59 - t56;
    const float t61 = t59 + t58;
    const float t62 = t61 - t59;
    const float t63 = spherecap_inline_lost(normal_x, t12, t56) + spherecap_inline_lost(normal_y, t13, t57);
    const float t64 = t63 + spherecap_inline_lost(normal_z, t14, t58) + (t56 - (t59 - t60) + (t57 - t60) + (t59 - (t61 - t62) + (t58 - t62)));
    const float t65 = t61 + t64;
    const float t66 = t64 - (t65 - t61);
    const float t67 = t15 - t65 - t66;
    const float t68 = t15 + t65 + t66;
    const float t69 = t67 * t68;
    const float t70 = sqrtf(t20);
    const bool t71 = 0.0f < t20;
    float t_x = 0.0f;
    float t_y = 0.0f;
    float width = 0.0f;
    float kappa = 0.0f;
    float cut = 0.0f;
    float shape = 0.0f;
    float shape_difference = 0.0f;
    float norm = 0.0f;
    float tau = 0.0f;
    float area = 0.0f;
    float t72 = 0.0f;
    if (0.0f < t69 && t29 && t71) {
        const float t73 = sqrtf(t20 + t69);
        const float t74 = sqrtf(t69);
        const float t75 = 1.0f / (t73 * t15);
        const float t76 = t75 * t15;
        const float t77 = t75 * t73;
        const float t78 = t70 * t76;
        const float t79 = t74 * t76;
        const float t80 = t79 * t79;
        const float t81 = fabsf(t65) * t77;
        const float t82 = t81 * t78;
        const float t83 = t78 - 0.5f;
        const float t84 = t82 - 0.5f;
        const float t85 = t83 * t83;
        const float t86 = t84 * t84;
        const float t87 = fmaf(0.05430631f, t85, 0.080950715f);
        const float t88 = fmaf(t87, t85, 0.1684019f);
        const float t89 = fmaf(t88, t85, 0.32709444f);
        const float t90 = fmaf(t89, t85, 0.5987523f);
        const float t91 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t86, t87), t86, t88), t86, t89), t86, t90);
        const float t92 = fmaf(-0.026061837f, t85, -0.06372378f);
        const float t93 = fmaf(t92, t85, -0.11762552f);
        const float t94 = fmaf(t93, t85, -0.23594604f);
        const float t95 = fmaf(t94, t85, -0.44721135f);
        const float t96 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t86, t92), t86, t93), t86, t94), t86, t95);
        const float t97 = fmaf(t95, t85, -0.7754678f);
        const float t98 = fmaf(t97, t83, fmaf(t90, t85, 0.94559944f));
        const float t99 = fmaf(fmaf(t84, t96, t91), t83 + t84, t97);
        const float t100 = fmaf(t82, t99, t98);
        t_x = t78;
        t_y = t79;
        width = t80 / (1.0f + t78);
        kappa = t81;
        cut = t82;
        shape = t98;
        shape_difference = t99;
        norm = t100;
        tau = t74 * t77;
        area = t80 * t79 * (spherecap_inline_min(t67, t68) * t77) * t100;
        t72 = t73;
    } else {
        t72 = t41;
    }
    const float t101 = sqrtf(t19);
    const float t102 = 1.0f / t101;
    const float radius_sin = t15 * t102;
    const float radius_cos = t70 * t102;
    const float elevation_sin = t65 * t102;
    const float elevation_cos = t72 * t102;
    const float t103 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t69 * (t102 * t102) / fmaf(radius_cos, t103, climb), -(radius_cos * t103));
    const float t104 = radius_sin * radius_sin;
    const bool t105 = 0.0f < elevation_sin;
    const float t106 = t105 ? fmaf(t104 * t103, 3.1415927f, area) : area;
    const bool t107 = 9.8607613e-32f < t104;
    const float t108 = 1.0f / t40;
    const float sideways_x = t37 * t108;
    const float sideways_y = t38 * t108;
    const float sideways_z = t39 * t108;
    const float on_surface = t29 ? 1.0f : 0.0f;
    const float distance = t101 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t106 && t107 && t71) ? t106 : 0.0f;
    const bool t109 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t110 = 0.0f < inv_above;
    const float t111 = t105 ? inv_above : 0.0f;
    const float defensive_share = t110 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t112 = t109 && t105 && 0.0f < t111;
    const float t113 = t_y * t_y * t_y * shape * t111;
    const float t114 = t_y / radius_sin;
    const float beyond = t112 ? t114 * t114 * t114 * fmaf(cut - t_x, shape_difference, shape) : 0.0f;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (t109 && !t105) {
        const float t115 = 1.0f + kappa;
        const float t116 = t115 * shape;
        const float t117 = 1.0f / (norm * t116);
        const float t118 = sqrtf(t117);
        const float t119 = norm * t118;
        const float t120 = 1.0f / (1.0f + cut);
        const float t121 = (t_x + kappa) * t120 - 0.5f;
        const float t122 = t121 * t121;
        const float t123 = fmaf(fmaf(fmaf(-0.026061837f, t122, -0.06372378f), t122, -0.11762552f), t122, -0.23594604f);
        const float t124 = fmaf(fmaf(fmaf(0.05430631f, t122, 0.080950715f), t122, 0.1684019f), t122, 0.32709444f);
        const float t125 = fmaf(fmaf(fmaf(t123, t122, -0.44721135f), t122, -0.7754678f), t121, fmaf(fmaf(t124, t122, 0.5987523f), t122, 0.94559944f));
        const float t126 = t115 * t125 * (t120 * t120 * t120) * (t116 * t117);
        const float t127 = fmaf(t126, t116 * t118, -1.0f);
        const float t128 = 1.0f - t126;
        const float t129 = fmaf(fmaf(30.011856f, t127, fmaf(-41.541264f, t128, -37.009792f)), t127, fmaf(77.96775f, t128, 7.470758f));
        const float t130 = fmaf(t129, t127, fmaf(fmaf(-49.13454f, t128, -9.466533f), t128, -1.5877596f));
        const float t131 = fmaf(fmaf(fmaf(15.716111f, t128, 0.0f), t128, 9.961183f), t128, -2.61785f);
        const float t132 = t127 * fmaf(t130, t127, fmaf(t131, t128, 0.8681748f));
        const float t133 = fmaf(fmaf(7.295638f, t127, -7.236236f), t127, fmaf(fmaf(fmaf(-11.4868555f, t128, 0.0f), t128, 0.0f), t128, 3.1255686f));
        const float t134 = fmaf(fmaf(fmaf(13.728438f, t128, -7.981878f), t128, 2.025724f), t128, -0.7334958f);
        const float t135 = t127 * fmaf(t133, t127, t134);
        const float t136 = fmaf(fmaf(fmaf(9.986537f, t128, 25.22195f), t128, 0.0f), t128, -2.9581387f);
        const float t137 = fmaf(fmaf(fmaf(-19.722994f, t128, 4.6594768f), t128, -0.89538246f), t128, 0.5143498f);
        const float t138 = t127 * fmaf(fmaf(fmaf(-23.220068f, t128, 7.332055f), t127, t136), t127, t137);
        const float t139 = fmaf(fmaf(fmaf(1.946617f, t127, -3.077631f), t127, 1.4945927f), t127, -0.24140751f);
        const float t140 = t127 * t139;
        const float t141 = t127 * fmaf(fmaf(0.38173297f, t127, -0.30305624f), t127, 0.05897375f);
        coefficients_0 = t119;
        coefficients_1 = t126 - t119 + t132;
        coefficients_2 = t135 - t132;
        coefficients_3 = t138 - t135;
        coefficients_4 = t140 - t138;
        coefficients_5 = t141 - t140;
        coefficients_6 = -t141;
    }
    const bool t142 = 0.0f < defensive_share;
    const float t143 = (t107 && 0.0f < radius_cos) ? t104 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t142 ? (0.0f < t143 ? 0.15915494f / t143 : 0.0f) : 0.0f;
    const bool t144 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t110 || (t142 && 0.0f < inv_solid_angle));
    spherecap_inline_front_light light;
    light.is_sampled = t144;
    light.solid_angle = t144 ? t143 * 6.2831855f : 0.0f;
    light.projected_solid_angle = t144 ? projected_above : 0.0f;
    light.towards_centre[0] = t12 * t102;
    light.towards_centre[1] = t13 * t102;
    light.towards_centre[2] = t14 * t102;
    light.sideways[0] = sideways_x;
    light.sideways[1] = sideways_y;
    light.sideways[2] = sideways_z;
    light.normal[0] = normal_x;
    light.normal[1] = normal_y;
    light.normal[2] = normal_z;
    light.up[0] = up_x;
    light.up[1] = up_y;
    light.up[2] = up_z;
    light.on_surface = on_surface;
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.tau = tau;
    light.kappa = kappa;
    light.width = width;
    light.cut = cut;
    light.rise = rise;
    light.defensive_share = defensive_share;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.third_axis[0] = fmaf(sideways_y, up_z, -(sideways_z * up_y));
    light.third_axis[1] = fmaf(sideways_z, up_x, -(sideways_x * up_z));
    light.third_axis[2] = fmaf(sideways_x, up_y, -(sideways_y * up_x));
    light.height = t142 ? t143 : 0.0f;
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = t112 ? t113 : 0.0f;
    light.inv_rest = t112 ? 1.0f / (1.0f - t113) : 1.0f;
    light.beyond = beyond;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t103;
    light.climb = climb;
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
    const bool t2 = 0.0f < light->defensive_share;
    const float t3 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t2 && t3 < light->defensive_share;
    const float t6 = 1.0f - light->defensive_share;
    const float t7 = (t5 ? t3 : t3 - light->defensive_share) / (t5 ? light->defensive_share : t6);
    const float t8 = spherecap_inline_min(spherecap_inline_max(t7, 5.9604645e-8f), 0.99999994f);
    const float t9 = 0.0f < light->requested ? t8 : t3;
    const bool t10 = t5 || !(0.0f < light->tau);
    const bool t11 = !t10 && !(0.0f < light->elevation_sin);
    const bool t12 = t10 || (!t11 && light->crescent_share <= t9);
    const float t13 = 1.0f - t4;
    const float t14 = t4 - t13;
    const float t15 = 4.0f * t4 * t13;
    const float t16 = spherecap_inline_max((t9 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
    const float t17 = t10 ? t9 : spherecap_inline_min(t16, 0.99999994f);
    const float t18 = t10 ? 0.0f : light->beyond;
    const float t19 = 3.1415927f - t18;
    const float t20 = fmaf(t17, t19, t18);
    const float t21 = (1.0f - t17) * t19;
    float t22 = 0.0f;
    float t23 = 0.0f;
    float t24 = 0.0f;
    float t25 = 0.0f;
    if (t12) {
        t23 = spherecap_inline_min(t20, t21) * 0.53033006f;
        t24 = 1.0f;
        t25 = 1.0f;
    } else {
        const float t26 = sqrtf(t15);
        const float t27 = fmaf(fmaf(light->coefficients_6, t15, light->coefficients_4), t15, light->coefficients_2);
        const float t28 = fmaf(fmaf(light->coefficients_5, t15, light->coefficients_3), t15, light->coefficients_1);
        const float t29 = t26 * fmaf(t28, t26, fmaf(t27, t15, light->coefficients_0));
        const float t30 = sqrtf(fmaf(t14, t14, t29 * t29));
        const float t31 = light->tau * t29;
        const float t32 = t11 ? fmaf(t14, t14, t31 * t31) : 1.0f;
        const float t33 = t11 ? fmaf(light->kappa, t29, t30) * fmaf(light->cut, t29, t30) : light->crescent_share;
        const float t34 = (t11 ? light->width : t9) / t33;
        const float t35 = spherecap_inline_min(spherecap_inline_max(t34, 5.9604645e-8f), 0.99999994f);
        const float t36 = t11 ? t34 : light->width;
        const float t37 = t32 * t36;
        const float t38 = t37 * t37;
        const float t39 = fmaf(fmaf(fmaf(-0.00060778117f, t38, -0.0027203285f), t38, -0.10000902f), t37, fmaf(fmaf(1.0676054e-5f, t38, -0.011332183f), t38, 1.0000001f));
        t22 = t11 ? t31 : t26;
        t23 = t11 ? t9 : t35;
        t24 = t36 * t39;
        t25 = t32;
    }
    const float t40 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t23), -0.33333334f, 1419900500.0f));
    const float t41 = fmaf(-(t23 * t40), t40 * t40, 1.0f);
    const float t42 = t41 * t41;
    const float t43 = fmaf(fmaf(fmaf(0.110958695f, t42, 0.14403293f), t42, 0.22222222f), t41, fmaf(fmaf(0.12482853f, t42, 0.17283951f), t42, 0.33333334f));
    const float t44 = t24 * (t23 * fmaf(t40, t41 * t43, t40));
    const float t45 = t44 * t25;
    const float t46 = t45 * t45;
    const float t47 = fmaf(fmaf(fmaf(-0.063446075f, t46, -0.056249518f), t46, 0.0074712755f), t46, 0.09996679f);
    const float t48 = fmaf(fmaf(fmaf(0.022114987f, t46, 0.085662976f), t46, 0.030445365f), t46, 0.03209764f);
    const float t49 = t44 * fmaf(t47, t45, fmaf(t48, t46, 1.0000004f));
    const float t50 = t12 ? spherecap_inline_min(t49, 1.0f) : t49;
    const float t51 = t25 * t50;
    const float t52 = 2.0f - t51;
    const float t53 = t50 * t52;
    const float t54 = sqrtf(t53);
    float t55 = 0.0f;
    float t56 = 0.0f;
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t12) {
        const float t57 = t20 - t21 < 0.0f ? t51 : t52;
        const float t58 = t53 * t15;
        float t59 = 0.0f;
        float t60 = 0.0f;
        float t61 = 0.0f;
        float t62 = 0.0f;
        float t63 = 0.0f;
        if (t5) {
            const float t64 = light->height * (1.0f - t58);
            const float t65 = sqrtf(light->height * (2.0f - t64));
            const float t66 = (t57 - 1.0f) * t65;
            const float t67 = 1.0f - t64;
            const float t68 = fmaf(light->elevation_sin, t67, light->elevation_cos * t66);
            t59 = fmaf(light->elevation_cos, t67, -(light->elevation_sin * t66));
            t60 = t68;
            t61 = t66;
            t62 = t54 * t14 * t65;
            t63 = t68 * light->on_surface;
        } else {
            const float t69 = 1.0f - t57;
            const float t70 = spherecap_inline_max(fmaf(light->climb, t57, -light->rise), 0.0f);
            const float t71 = sqrtf(fmaf(t70, t70, light->radius_sin * light->radius_sin * t58));
            const float t72 = t1 * light->radius_cos;
            const float t73 = fmaf(light->elevation_cos * t69, fmaf(light->climb, t69, -2.0f * t72), light->radius_sin * t58);
            const float t74 = light->radius_sin * fmaf(light->elevation_cos, t73 / (t71 + t72), -(t1 * t1 * t69));
            t59 = fmaf(light->half_axis, t69, light->middle);
            t60 = t71;
            t61 = t74;
            t62 = light->radius_sin * t54 * t14;
            t63 = t71;
        }
        t55 = t59;
        t56 = t60;
        zenith = t61;
        side = t62;
        cosine = t63;
    } else {
        const float t75 = t54 * t22;
        const float t76 = 1.0f - t51;
        t55 = t76;
        t56 = t75;
        zenith = fmaf(light->elevation_cos, t75, -((t11 ? -t1 : t1) * t76));
        side = t54 * t14;
        cosine = t75;
    }
    const float t77 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t78 = 0.0f < cosine ? light->inv_above : 0.0f;
    const float t79 = light->defensive_share * light->inv_solid_angle;
    const float t80 = spherecap_inline_min(t79 / spherecap_inline_max(t77, 1.1754944e-38f), 3.4028235e38f);
    const float t81 = fmaf(zenith, zenith, side * side);
    const float t82 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t81), 0.0f);
    const float t83 = sqrtf(t82);
    const float t84 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t82));
    const float t85 = light->radius_cos * light->radius_cos / (t84 + t83);
    const float t86 = 1.0f / light->radius_sin;
    const float t87 = t85 * t86;
    const float t88 = -fmaf(t84, t83, t81) * t86;
    const float t89 = t87 * zenith;
    const float t90 = t87 * side;
    const float t91 = fmaf(light->third_axis[0], t55, fmaf(light->sideways[0], side, light->up[0] * t56));
    const float t92 = fmaf(light->third_axis[1], t55, fmaf(light->sideways[1], side, light->up[1] * t56));
    const float t93 = fmaf(light->third_axis[2], t55, fmaf(light->sideways[2], side, light->up[2] * t56));
    const float t94 = fmaf(light->elevation_cos, t88, -(light->elevation_sin * t89));
    const float t95 = fmaf(light->elevation_sin, t88, light->elevation_cos * t89);
    const float t96 = fmaf(light->third_axis[0], t94, fmaf(light->sideways[0], t90, light->up[0] * t95));
    const float t97 = fmaf(light->third_axis[1], t94, fmaf(light->sideways[1], t90, light->up[1] * t95));
    const float t98 = fmaf(light->third_axis[2], t94, fmaf(light->sideways[2], t90, light->up[2] * t95));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t91;
    sampled.direction[1] = t92;
    sampled.direction[2] = t93;
    sampled.distance = t85 * light->distance;
    sampled.normal[0] = t96;
    sampled.normal[1] = t97;
    sampled.normal[2] = t98;
    sampled.cosine = cosine;
    sampled.pdf = t2 ? fmaf(t78, t6 * t77, t79) : t78 * t77;
    sampled.projected_pdf = t2 ? spherecap_inline_min(fmaf(t78, t6, t80), 3.4028235e38f) : t78;
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
    const float t12 = fmaf(t11, (1.0f - light->defensive_share) * t10, light->defensive_share * light->inv_solid_angle);
    const bool t13 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t14 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t15 = (0.998001f <= t14 && t14 <= 1.002001f) ? (t13 ? (0.0f < light->defensive_share ? t12 : t11 * t10) : 0.0f) : 0.0f;
    return t15;
}

static inline float spherecap_inline_front_pdf_on_sphere(const spherecap_inline_front_light *light, const float direction[3])
{
    if (!light->is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light->normal[0], direction[0], fmaf(light->normal[1], direction[1], light->normal[2] * direction[2]));
    const float t2 = spherecap_inline_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light->inv_above : 0.0f;
    const float t4 = fmaf(t3, (1.0f - light->defensive_share) * t2, light->defensive_share * light->inv_solid_angle);
    const float t5 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light->defensive_share ? t4 : t3 * t2) : 0.0f;
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
    float requested;
    float inv_above;
    float inv_below;
    float sides_share;
    float third_axis[3];
    float height;
    float inv_solid_angle;
    float crescent_share;
    float inv_rest;
    float beyond;
    float middle;
    float half_axis;
    float climb;
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
    const float t9 = fmaf(centre[0], centre[0], fmaf(centre[1], centre[1], centre[2] * centre[2]));
    const bool t10 = t9 < 1099511600000.0f && 9.536743e-7f < radius;
    const float t11 = spherecap_inline_max(fabsf(centre[0]) + fabsf(centre[1]) + (fabsf(centre[2]) + radius), 1.1754944e-38f);
    const float unscale = spherecap_inline_power_of_two(spherecap_inline_min(t11, 8.5070587e37f));
    const float scale = spherecap_inline_float_of_bits(2130706400.0f - spherecap_inline_bits(unscale));
    const float t12 = t10 ? centre[0] : centre[0] * scale;
    const float t13 = t10 ? centre[1] : centre[1] * scale;
    const float t14 = t10 ? centre[2] : centre[2] * scale;
    const float t15 = t10 ? radius : radius * scale;
    const float t16 = t14 * t14;
    const float t17 = fmaf(t12, t12, fmaf(t13, t13, t16));
    const float t18 = fmaf(-t15, t15, t17);
    float t19 = 0.0f;
    float t20 = 0.0f;
    if (t18 < t17 * 0.25f) {
        const float t21 = t12 * t12;
        const float t22 = t13 * t13;
        const float t23 = t21 + t22;
        const float t24 = t23 - t21;
        const float t25 = t23 + t16;
        const float t26 = t25 - t23;
        const float t27 = spherecap_inline_lost(t12, t12, t21) + spherecap_inline_lost(t13, t13, t22);
        const float t28 = t27 + spherecap_inline_lost(t14, t14, t16) + (t21 - (t23 - t24) + (t22 - t24) + (t23 - (t25 - t26) + (t16 - t26)));
        t19 = t25;
        t20 = fmaf(-t15, t15, t25) + t28;
    } else {
        t19 = t17;
        t20 = t18;
    }
    const bool t29 = 0.0f < t8;
    const float t30 = normal_z * t13;
    const float t31 = fmaf(normal_y, t14, -t30);
    const float t32 = normal_x * t14;
    const float t33 = fmaf(normal_z, t12, -t32);
    const float t34 = normal_y * t12;
    const float t35 = fmaf(normal_x, t13, -t34);
    const float t36 = fmaf(t31, t31, fmaf(t33, t33, t35 * t35));
    float up_x = 0.0f;
    float up_y = 0.0f;
    float up_z = 0.0f;
    float t37 = 0.0f;
    float t38 = 0.0f;
    float t39 = 0.0f;
    float t40 = 0.0f;
    float t41 = 0.0f;
    if (t36 < t19 * 0.015625f) {
        const float t42 = t31 - spherecap_inline_lost(normal_z, t13, t30);
        const float t43 = t33 - spherecap_inline_lost(normal_x, t14, t32);
        const float t44 = t35 - spherecap_inline_lost(normal_y, t12, t34);
        const float t45 = fmaf(t42, t42, fmaf(t43, t43, t44 * t44));
        const bool t46 = t45 < t19 * 5.169879e-26f;
        const bool t47 = fabsf(t12) < fabsf(t14);
        const float t48 = t47 ? 0.0f : -t13;
        const float t49 = t47 ? -t14 : t12;
        const float t50 = t47 ? t13 : 0.0f;
        const float t51 = sqrtf(fmaf(t48, t48, fmaf(t49, t49, t50 * t50)));
        const float t52 = sqrtf(t19);
        const float t53 = t52 * t51;
        const float t54 = sqrtf(t45);
        up_x = t46 ? (t29 ? normal_x : fmaf(t13, t50, -(t14 * t49)) / t53) : normal_x;
        up_y = t46 ? (t29 ? normal_y : fmaf(t14, t48, -(t12 * t50)) / t53) : normal_y;
        up_z = t46 ? (t29 ? normal_z : fmaf(t12, t49, -(t13 * t48)) / t53) : normal_z;
        t37 = t46 ? t48 : t42;
        t38 = t46 ? t49 : t43;
        t39 = t46 ? t50 : t44;
        t40 = t46 ? t51 : t54;
        t41 = t46 ? (t29 ? 0.0f : t52) : t54;
    } else {
        const float t55 = sqrtf(t36);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t37 = t31;
        t38 = t33;
        t39 = t35;
        t40 = t55;
        t41 = t55;
    }
    const float t56 = normal_x * t12;
    const float t57 = normal_y * t13;
    const float t58 = normal_z * t14;
    const float t59 = t56 + t57;
    const float t60 = t59 - t56;
    const float t61 = t59 + t58;
    const float t62 = t61 - t59;
    const float t63 = spherecap_inline_lost(normal_x, t12, t56) + spherecap_inline_lost(normal_y, t13, t57);
    const float t64 = t63 + spherecap_inline_lost(normal_z, t14, t58) + (t56 - (t59 - t60) + (t57 - t60) + (t59 - (t61 - t62) + (t58 - t62)));
    const float t65 = t61 + t64;
    const float t66 = t64 - (t65 - t61);
    const float t67 = t15 - t65 - t66;
    const float t68 = t15 + t65 + t66;
    const float t69 = t67 * t68;
    const float t70 = sqrtf(t20);
    const bool t71 = 0.0f < t20;
    float t_x = 0.0f;
    float t_y = 0.0f;
    float width = 0.0f;
    float kappa = 0.0f;
    float cut = 0.0f;
    float shape = 0.0f;
    float shape_difference = 0.0f;
    float norm = 0.0f;
    float tau = 0.0f;
    float area = 0.0f;
    float t72 = 0.0f;
    if (0.0f < t69 && t29 && t71) {
        const float t73 = sqrtf(t20 + t69);
        const float t74 = sqrtf(t69);
        const float t75 = 1.0f / (t73 * t15);
        const float t76 = t75 * t15;
        const float t77 = t75 * t73;
        const float t78 = t70 * t76;
        const float t79 = t74 * t76;
        const float t80 = t79 * t79;
        const float t81 = fabsf(t65) * t77;
        const float t82 = t81 * t78;
        const float t83 = t78 - 0.5f;
        const float t84 = t82 - 0.5f;
        const float t85 = t83 * t83;
        const float t86 = t84 * t84;
        const float t87 = fmaf(0.05430631f, t85, 0.080950715f);
        const float t88 = fmaf(t87, t85, 0.1684019f);
        const float t89 = fmaf(t88, t85, 0.32709444f);
        const float t90 = fmaf(t89, t85, 0.5987523f);
        const float t91 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t86, t87), t86, t88), t86, t89), t86, t90);
        const float t92 = fmaf(-0.026061837f, t85, -0.06372378f);
        const float t93 = fmaf(t92, t85, -0.11762552f);
        const float t94 = fmaf(t93, t85, -0.23594604f);
        const float t95 = fmaf(t94, t85, -0.44721135f);
        const float t96 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t86, t92), t86, t93), t86, t94), t86, t95);
        const float t97 = fmaf(t95, t85, -0.7754678f);
        const float t98 = fmaf(t97, t83, fmaf(t90, t85, 0.94559944f));
        const float t99 = fmaf(fmaf(t84, t96, t91), t83 + t84, t97);
        const float t100 = fmaf(t82, t99, t98);
        t_x = t78;
        t_y = t79;
        width = t80 / (1.0f + t78);
        kappa = t81;
        cut = t82;
        shape = t98;
        shape_difference = t99;
        norm = t100;
        tau = t74 * t77;
        area = t80 * t79 * (spherecap_inline_min(t67, t68) * t77) * t100;
        t72 = t73;
    } else {
        t72 = t41;
    }
    const float t101 = sqrtf(t19);
    const float t102 = 1.0f / t101;
    const float radius_sin = t15 * t102;
    const float radius_cos = t70 * t102;
    const float elevation_sin = t65 * t102;
    const float elevation_cos = t72 * t102;
    const float t103 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_inline_max(t69 * (t102 * t102) / fmaf(radius_cos, t103, climb), -(radius_cos * t103));
    const float t104 = radius_sin * radius_sin;
    const float t105 = fmaf(t104 * t103, 3.1415927f, area);
    const bool t106 = 0.0f < elevation_sin;
    const float t107 = t106 ? t105 : area;
    const float t108 = t106 ? area : t105;
    const bool t109 = 9.8607613e-32f < t104;
    const bool t110 = t109 && t71;
    const float t111 = 1.0f / t40;
    const float sideways_x = t37 * t111;
    const float sideways_y = t38 * t111;
    const float sideways_z = t39 * t111;
    const float on_surface = t29 ? 1.0f : 0.0f;
    const float distance = t101 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t107 && t110) ? t107 : 0.0f;
    const float projected_below = (9.403955e-38f < t108 && t110) ? t108 : 0.0f;
    const bool t112 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float inv_below = 0.0f < projected_below ? 1.0f / projected_below : 0.0f;
    const bool t113 = 0.0f < inv_above + inv_below;
    const float t114 = t106 ? inv_above : inv_below;
    const float defensive_share = t113 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t115 = t112 && 0.0f < t114;
    const float t116 = t_y * t_y * t_y * shape * t114;
    const float t117 = t_y / radius_sin;
    const float t118 = fmaf(cut - t_x, shape_difference, shape);
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    float t119 = 0.0f;
    if (t112) {
        const float t120 = 1.0f + kappa;
        const float t121 = t120 * shape;
        const float t122 = 1.0f / (norm * t121);
        const float t123 = sqrtf(t122);
        const float t124 = norm * t123;
        const float t125 = 1.0f / (1.0f + cut);
        const float t126 = (t_x + kappa) * t125 - 0.5f;
        const float t127 = t126 * t126;
        const float t128 = fmaf(fmaf(fmaf(-0.026061837f, t127, -0.06372378f), t127, -0.11762552f), t127, -0.23594604f);
        const float t129 = fmaf(fmaf(fmaf(0.05430631f, t127, 0.080950715f), t127, 0.1684019f), t127, 0.32709444f);
        const float t130 = fmaf(fmaf(fmaf(t128, t127, -0.44721135f), t127, -0.7754678f), t126, fmaf(fmaf(t129, t127, 0.5987523f), t127, 0.94559944f));
        const float t131 = t120 * t130 * (t125 * t125 * t125) * (t121 * t122);
        const float t132 = fmaf(t131, t121 * t123, -1.0f);
        const float t133 = 1.0f - t131;
        const float t134 = fmaf(fmaf(30.011856f, t132, fmaf(-41.541264f, t133, -37.009792f)), t132, fmaf(77.96775f, t133, 7.470758f));
        const float t135 = fmaf(t134, t132, fmaf(fmaf(-49.13454f, t133, -9.466533f), t133, -1.5877596f));
        const float t136 = fmaf(fmaf(fmaf(15.716111f, t133, 0.0f), t133, 9.961183f), t133, -2.61785f);
        const float t137 = t132 * fmaf(t135, t132, fmaf(t136, t133, 0.8681748f));
        const float t138 = fmaf(fmaf(7.295638f, t132, -7.236236f), t132, fmaf(fmaf(fmaf(-11.4868555f, t133, 0.0f), t133, 0.0f), t133, 3.1255686f));
        const float t139 = fmaf(fmaf(fmaf(13.728438f, t133, -7.981878f), t133, 2.025724f), t133, -0.7334958f);
        const float t140 = t132 * fmaf(t138, t132, t139);
        const float t141 = fmaf(fmaf(fmaf(9.986537f, t133, 25.22195f), t133, 0.0f), t133, -2.9581387f);
        const float t142 = fmaf(fmaf(fmaf(-19.722994f, t133, 4.6594768f), t133, -0.89538246f), t133, 0.5143498f);
        const float t143 = t132 * fmaf(fmaf(fmaf(-23.220068f, t133, 7.332055f), t132, t141), t132, t142);
        const float t144 = fmaf(fmaf(fmaf(1.946617f, t132, -3.077631f), t132, 1.4945927f), t132, -0.24140751f);
        const float t145 = t132 * t144;
        const float t146 = t132 * fmaf(fmaf(0.38173297f, t132, -0.30305624f), t132, 0.05897375f);
        const float t147 = 1.0f / (elevation_cos * elevation_cos);
        const float t148 = tau * tau;
        const float t149 = t148 * t147 / (1.0f + t_x);
        const float t150 = kappa - 0.5f;
        const float t151 = cut - 0.5f;
        const float t152 = t150 * t150;
        const float t153 = t151 * t151;
        const float t154 = fmaf(0.05430631f, t152, 0.080950715f);
        const float t155 = fmaf(t154, t152, 0.1684019f);
        const float t156 = fmaf(t155, t152, 0.32709444f);
        const float t157 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t153, t154), t153, t155), t153, t156), t153, fmaf(t156, t152, 0.5987523f));
        const float t158 = fmaf(-0.026061837f, t152, -0.06372378f);
        const float t159 = fmaf(t158, t152, -0.11762552f);
        const float t160 = fmaf(t159, t152, -0.23594604f);
        const float t161 = fmaf(t160, t152, -0.44721135f);
        const float t162 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t153, t158), t153, t159), t153, t160), t153, t161);
        const float t163 = fmaf(kappa * t149, fmaf(fmaf(t151, t162, t157), t150 + t151, fmaf(t161, t152, -0.7754678f)), fmaf(t118, t149 - kappa * kappa, kappa) * t147);
        const float t164 = spherecap_inline_max(t148 * tau * (radius_cos + 1.0f) * t163 * 0.31830987f, 0.0f);
        coefficients_0 = t124;
        coefficients_1 = t131 - t124 + t137;
        coefficients_2 = t140 - t137;
        coefficients_3 = t143 - t140;
        coefficients_4 = t145 - t143;
        coefficients_5 = t146 - t145;
        coefficients_6 = -t146;
        t119 = spherecap_inline_min(t164, 0.5f);
    }
    const bool t165 = 0.0f < defensive_share;
    const float t166 = (t109 && 0.0f < radius_cos) ? t104 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t165 ? (0.0f < t166 ? 0.15915494f / t166 : 0.0f) : 0.0f;
    const float sides_share = 0.0f < inv_below ? (0.0f < inv_above ? (t106 ? 1.0f - t119 : t119) : 0.0f) : 1.0f;
    const bool t167 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t113 || (t165 && 0.0f < inv_solid_angle));
    spherecap_inline_both_light light;
    light.is_sampled = t167;
    light.solid_angle = t167 ? t166 * 6.2831855f : 0.0f;
    light.projected_solid_angle = t167 ? projected_above : 0.0f;
    light.towards_centre[0] = t12 * t102;
    light.towards_centre[1] = t13 * t102;
    light.towards_centre[2] = t14 * t102;
    light.sideways[0] = sideways_x;
    light.sideways[1] = sideways_y;
    light.sideways[2] = sideways_z;
    light.normal[0] = normal_x;
    light.normal[1] = normal_y;
    light.normal[2] = normal_z;
    light.up[0] = up_x;
    light.up[1] = up_y;
    light.up[2] = up_z;
    light.on_surface = on_surface;
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.tau = tau;
    light.kappa = kappa;
    light.width = width;
    light.cut = cut;
    light.rise = rise;
    light.defensive_share = defensive_share;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.sides_share = sides_share;
    light.third_axis[0] = fmaf(sideways_y, up_z, -(sideways_z * up_y));
    light.third_axis[1] = fmaf(sideways_z, up_x, -(sideways_x * up_z));
    light.third_axis[2] = fmaf(sideways_x, up_y, -(sideways_y * up_x));
    light.height = t165 ? t166 : 0.0f;
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = t115 ? t116 : 0.0f;
    light.inv_rest = t115 ? 1.0f / (1.0f - t116) : 1.0f;
    light.beyond = t115 ? t117 * t117 * t117 * t118 : 0.0f;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t103;
    light.climb = climb;
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
    const bool t3 = 0.0f < light->defensive_share;
    const float t4 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = t3 && t4 < light->defensive_share;
    const float t7 = 1.0f - light->defensive_share;
    const float t8 = (t6 ? t4 : t4 - light->defensive_share) / (t6 ? light->defensive_share : t7);
    const float t9 = spherecap_inline_min(spherecap_inline_max(t8, 5.9604645e-8f), 0.99999994f);
    const float t10 = 0.0f < light->requested ? t9 : t4;
    const bool t11 = t6 || t10 < light->sides_share;
    const float t12 = 1.0f - light->sides_share;
    const float t13 = (t11 ? t10 : t10 - light->sides_share) / (t11 ? light->sides_share : t12);
    const float t14 = spherecap_inline_min(spherecap_inline_max(t13, 5.9604645e-8f), 0.99999994f);
    const float t15 = t6 ? t10 : t14;
    const bool t16 = t6 || !(0.0f < light->tau);
    const bool t17 = !t16 && !((t11 && t2) || (!t11 && !t2));
    const bool t18 = t16 || (!t17 && light->crescent_share <= t15);
    const float t19 = 1.0f - t5;
    const float t20 = t5 - t19;
    const float t21 = 4.0f * t5 * t19;
    const float t22 = spherecap_inline_max((t15 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
    const float t23 = t16 ? t15 : spherecap_inline_min(t22, 0.99999994f);
    const float t24 = t16 ? 0.0f : light->beyond;
    const float t25 = 3.1415927f - t24;
    const float t26 = fmaf(t23, t25, t24);
    const float t27 = (1.0f - t23) * t25;
    float t28 = 0.0f;
    float t29 = 0.0f;
    float t30 = 0.0f;
    float t31 = 0.0f;
    if (t18) {
        t29 = spherecap_inline_min(t26, t27) * 0.53033006f;
        t30 = 1.0f;
        t31 = 1.0f;
    } else {
        const float t32 = sqrtf(t21);
        const float t33 = fmaf(fmaf(light->coefficients_6, t21, light->coefficients_4), t21, light->coefficients_2);
        const float t34 = fmaf(fmaf(light->coefficients_5, t21, light->coefficients_3), t21, light->coefficients_1);
        const float t35 = t32 * fmaf(t34, t32, fmaf(t33, t21, light->coefficients_0));
        const float t36 = sqrtf(fmaf(t20, t20, t35 * t35));
        const float t37 = light->tau * t35;
        const float t38 = t17 ? fmaf(t20, t20, t37 * t37) : 1.0f;
        const float t39 = t17 ? fmaf(light->kappa, t35, t36) * fmaf(light->cut, t35, t36) : light->crescent_share;
        const float t40 = (t17 ? light->width : t15) / t39;
        const float t41 = spherecap_inline_min(spherecap_inline_max(t40, 5.9604645e-8f), 0.99999994f);
        const float t42 = t17 ? t40 : light->width;
        const float t43 = t38 * t42;
        const float t44 = t43 * t43;
        const float t45 = fmaf(fmaf(fmaf(-0.00060778117f, t44, -0.0027203285f), t44, -0.10000902f), t43, fmaf(fmaf(1.0676054e-5f, t44, -0.011332183f), t44, 1.0000001f));
        t28 = t17 ? t37 : t32;
        t29 = t17 ? t15 : t41;
        t30 = t42 * t45;
        t31 = t38;
    }
    const float t46 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t29), -0.33333334f, 1419900500.0f));
    const float t47 = fmaf(-(t29 * t46), t46 * t46, 1.0f);
    const float t48 = t47 * t47;
    const float t49 = fmaf(fmaf(fmaf(0.110958695f, t48, 0.14403293f), t48, 0.22222222f), t47, fmaf(fmaf(0.12482853f, t48, 0.17283951f), t48, 0.33333334f));
    const float t50 = t30 * (t29 * fmaf(t46, t47 * t49, t46));
    const float t51 = t50 * t31;
    const float t52 = t51 * t51;
    const float t53 = fmaf(fmaf(fmaf(-0.063446075f, t52, -0.056249518f), t52, 0.0074712755f), t52, 0.09996679f);
    const float t54 = fmaf(fmaf(fmaf(0.022114987f, t52, 0.085662976f), t52, 0.030445365f), t52, 0.03209764f);
    const float t55 = t50 * fmaf(t53, t51, fmaf(t54, t52, 1.0000004f));
    const float t56 = t18 ? spherecap_inline_min(t55, 1.0f) : t55;
    const float t57 = t31 * t56;
    const float t58 = 2.0f - t57;
    const float t59 = t56 * t58;
    const float t60 = sqrtf(t59);
    float t61 = 0.0f;
    float t62 = 0.0f;
    float t63 = 0.0f;
    float side = 0.0f;
    float t64 = 0.0f;
    if (t18) {
        const float t65 = t26 - t27 < 0.0f ? t57 : t58;
        const float t66 = t59 * t21;
        float t67 = 0.0f;
        float t68 = 0.0f;
        float t69 = 0.0f;
        float t70 = 0.0f;
        float t71 = 0.0f;
        if (t6) {
            const float t72 = light->height * (1.0f - t66);
            const float t73 = sqrtf(light->height * (2.0f - t72));
            const float t74 = (t65 - 1.0f) * t73;
            const float t75 = 1.0f - t72;
            const float t76 = fmaf(light->elevation_sin, t75, light->elevation_cos * t74);
            t67 = fmaf(light->elevation_cos, t75, -(light->elevation_sin * t74));
            t68 = t76;
            t69 = t74;
            t70 = t60 * t20 * t73;
            t71 = t76 * light->on_surface;
        } else {
            const float t77 = 1.0f - t65;
            const float t78 = spherecap_inline_max(fmaf(light->climb, t65, -light->rise), 0.0f);
            const float t79 = sqrtf(fmaf(t78, t78, light->radius_sin * light->radius_sin * t66));
            const float t80 = t1 * light->radius_cos;
            const float t81 = fmaf(light->elevation_cos * t77, fmaf(light->climb, t77, -2.0f * t80), light->radius_sin * t66);
            const float t82 = light->radius_sin * fmaf(light->elevation_cos, t81 / (t79 + t80), -(t1 * t1 * t77));
            t67 = fmaf(light->half_axis, t77, light->middle);
            t68 = t79;
            t69 = t82;
            t70 = light->radius_sin * t60 * t20;
            t71 = t79;
        }
        t61 = t67;
        t62 = t68;
        t63 = t69;
        side = t70;
        t64 = t71;
    } else {
        const float t83 = t60 * t28;
        const float t84 = 1.0f - t57;
        t61 = t84;
        t62 = t83;
        t63 = fmaf(light->elevation_cos, t83, -((t17 ? -t1 : t1) * t84));
        side = t60 * t20;
        t64 = t83;
    }
    const float t85 = t11 ? 1.0f : -1.0f;
    const float zenith = t63 * t85;
    const float cosine = t64 * t85;
    const float t86 = t62 * t85;
    const float t87 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t88 = 0.0f < cosine ? light->inv_above * light->sides_share : cosine < 0.0f ? light->inv_below * t12 : 0.0f;
    const float t89 = light->defensive_share * light->inv_solid_angle;
    const float t90 = spherecap_inline_min(t89 / spherecap_inline_max(t87, 1.1754944e-38f), 3.4028235e38f);
    const float t91 = fmaf(zenith, zenith, side * side);
    const float t92 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t91), 0.0f);
    const float t93 = sqrtf(t92);
    const float t94 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t92));
    const float t95 = light->radius_cos * light->radius_cos / (t94 + t93);
    const float t96 = 1.0f / light->radius_sin;
    const float t97 = t95 * t96;
    const float t98 = -fmaf(t94, t93, t91) * t96;
    const float t99 = t97 * zenith;
    const float t100 = t97 * side;
    const float t101 = fmaf(light->third_axis[0], t61, fmaf(light->sideways[0], side, light->up[0] * t86));
    const float t102 = fmaf(light->third_axis[1], t61, fmaf(light->sideways[1], side, light->up[1] * t86));
    const float t103 = fmaf(light->third_axis[2], t61, fmaf(light->sideways[2], side, light->up[2] * t86));
    const float t104 = fmaf(light->elevation_cos, t98, -(light->elevation_sin * t99));
    const float t105 = fmaf(light->elevation_sin, t98, light->elevation_cos * t99);
    const float t106 = fmaf(light->third_axis[0], t104, fmaf(light->sideways[0], t100, light->up[0] * t105));
    const float t107 = fmaf(light->third_axis[1], t104, fmaf(light->sideways[1], t100, light->up[1] * t105));
    const float t108 = fmaf(light->third_axis[2], t104, fmaf(light->sideways[2], t100, light->up[2] * t105));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t101;
    sampled.direction[1] = t102;
    sampled.direction[2] = t103;
    sampled.distance = t95 * light->distance;
    sampled.normal[0] = t106;
    sampled.normal[1] = t107;
    sampled.normal[2] = t108;
    sampled.cosine = cosine;
    sampled.pdf = t3 ? fmaf(t88, t7 * t87, t89) : t88 * t87;
    sampled.projected_pdf = t3 ? spherecap_inline_min(fmaf(t88, t7, t90), 3.4028235e38f) : t88;
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
    const float t11 = 0.0f < t6 ? light->inv_above * light->sides_share : t6 < 0.0f ? light->inv_below * (1.0f - light->sides_share) : 0.0f;
    const float t12 = fmaf(t11, (1.0f - light->defensive_share) * t10, light->defensive_share * light->inv_solid_angle);
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
    const float t3 = 0.0f < t1 ? light->inv_above * light->sides_share : t1 < 0.0f ? light->inv_below * (1.0f - light->sides_share) : 0.0f;
    const float t4 = fmaf(t3, (1.0f - light->defensive_share) * t2, light->defensive_share * light->inv_solid_angle);
    const float t5 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light->defensive_share ? t4 : t3 * t2) : 0.0f;
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
