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
    float t10 = 0.0f;
    float t11 = 0.0f;
    float t12 = 0.0f;
    float t13 = 0.0f;
    if (t6) {
        const float t14 = spherecap_inline_max((t4 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
        const float t15 = t2 ? spherecap_inline_min(t14, 0.99999994f) : t4;
        const float t16 = t2 ? light->beyond : 0.0f;
        const float t17 = 3.1415927f - t16;
        const float t18 = fmaf(t15, t17, t16);
        const float t19 = (1.0f - t15) * t17;
        t10 = spherecap_inline_min(t18, t19) * 0.53033006f;
        t11 = 1.0f;
        t12 = 1.0f;
        t13 = t18 - t19;
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
        t10 = t3 ? t4 : t29;
        t11 = t30 * t33;
        t12 = t26;
        t13 = t3 ? t25 : t20;
    }
    const float t34 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t10), -0.33333334f, 1419900500.0f));
    const float t35 = fmaf(-(t10 * t34), t34 * t34, 1.0f);
    const float t36 = t35 * t35;
    const float t37 = fmaf(fmaf(fmaf(0.110958695f, t36, 0.14403293f), t36, 0.22222222f), t35, fmaf(fmaf(0.12482853f, t36, 0.17283951f), t36, 0.33333334f));
    const float t38 = t11 * (t10 * fmaf(t34, t35 * t37, t34));
    const float t39 = t38 * t12;
    const float t40 = t39 * t39;
    const float t41 = fmaf(fmaf(fmaf(-0.063446075f, t40, -0.056249518f), t40, 0.0074712755f), t40, 0.09996679f);
    const float t42 = fmaf(fmaf(fmaf(0.022114987f, t40, 0.085662976f), t40, 0.030445365f), t40, 0.03209764f);
    const float t43 = t38 * fmaf(t41, t39, fmaf(t42, t40, 1.0000004f));
    const float t44 = t6 ? spherecap_inline_min(t43, 1.0f) : t43;
    const float t45 = t12 * t44;
    const float t46 = 2.0f - t45;
    const float t47 = t44 * t46;
    const float t48 = sqrtf(t47);
    float t49 = 0.0f;
    float t50 = 0.0f;
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t6) {
        const float t51 = t13 < 0.0f ? t45 : t46;
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
        const float t59 = t48 * t13;
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
    float defensive;
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
    const float t112 = t110 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t113 = t109 && t105 && 0.0f < t111;
    const float t114 = t_y * t_y * t_y * shape * t111;
    const float t115 = t_y / radius_sin;
    const float beyond = t113 ? t115 * t115 * t115 * fmaf(cut - t_x, shape_difference, shape) : 0.0f;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (t109 && !t105) {
        const float t116 = 1.0f + kappa;
        const float t117 = t116 * shape;
        const float t118 = 1.0f / (norm * t117);
        const float t119 = sqrtf(t118);
        const float t120 = norm * t119;
        const float t121 = 1.0f / (1.0f + cut);
        const float t122 = (t_x + kappa) * t121 - 0.5f;
        const float t123 = t122 * t122;
        const float t124 = fmaf(fmaf(fmaf(-0.026061837f, t123, -0.06372378f), t123, -0.11762552f), t123, -0.23594604f);
        const float t125 = fmaf(fmaf(fmaf(0.05430631f, t123, 0.080950715f), t123, 0.1684019f), t123, 0.32709444f);
        const float t126 = fmaf(fmaf(fmaf(t124, t123, -0.44721135f), t123, -0.7754678f), t122, fmaf(fmaf(t125, t123, 0.5987523f), t123, 0.94559944f));
        const float t127 = t116 * t126 * (t121 * t121 * t121) * (t117 * t118);
        const float t128 = fmaf(t127, t117 * t119, -1.0f);
        const float t129 = 1.0f - t127;
        const float t130 = fmaf(fmaf(30.011856f, t128, fmaf(-41.541264f, t129, -37.009792f)), t128, fmaf(77.96775f, t129, 7.470758f));
        const float t131 = fmaf(t130, t128, fmaf(fmaf(-49.13454f, t129, -9.466533f), t129, -1.5877596f));
        const float t132 = fmaf(fmaf(fmaf(15.716111f, t129, 0.0f), t129, 9.961183f), t129, -2.61785f);
        const float t133 = t128 * fmaf(t131, t128, fmaf(t132, t129, 0.8681748f));
        const float t134 = fmaf(fmaf(7.295638f, t128, -7.236236f), t128, fmaf(fmaf(fmaf(-11.4868555f, t129, 0.0f), t129, 0.0f), t129, 3.1255686f));
        const float t135 = fmaf(fmaf(fmaf(13.728438f, t129, -7.981878f), t129, 2.025724f), t129, -0.7334958f);
        const float t136 = t128 * fmaf(t134, t128, t135);
        const float t137 = fmaf(fmaf(fmaf(9.986537f, t129, 25.22195f), t129, 0.0f), t129, -2.9581387f);
        const float t138 = fmaf(fmaf(fmaf(-19.722994f, t129, 4.6594768f), t129, -0.89538246f), t129, 0.5143498f);
        const float t139 = t128 * fmaf(fmaf(fmaf(-23.220068f, t129, 7.332055f), t128, t137), t128, t138);
        const float t140 = fmaf(fmaf(fmaf(1.946617f, t128, -3.077631f), t128, 1.4945927f), t128, -0.24140751f);
        const float t141 = t128 * t140;
        const float t142 = t128 * fmaf(fmaf(0.38173297f, t128, -0.30305624f), t128, 0.05897375f);
        coefficients_0 = t120;
        coefficients_1 = t127 - t120 + t133;
        coefficients_2 = t136 - t133;
        coefficients_3 = t139 - t136;
        coefficients_4 = t141 - t139;
        coefficients_5 = t142 - t141;
        coefficients_6 = -t142;
    }
    const bool t143 = 0.0f < t112;
    const float t144 = (t107 && 0.0f < radius_cos) ? t104 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t143 ? (0.0f < t144 ? 0.15915494f / t144 : 0.0f) : 0.0f;
    const bool t145 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t110 || (t143 && 0.0f < inv_solid_angle));
    spherecap_inline_front_light light;
    light.is_sampled = t145;
    light.solid_angle = t145 ? t144 * 6.2831855f : 0.0f;
    light.projected_solid_angle = t145 ? projected_above : 0.0f;
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
    light.defensive = t112;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.third_axis[0] = fmaf(sideways_y, up_z, -(sideways_z * up_y));
    light.third_axis[1] = fmaf(sideways_z, up_x, -(sideways_x * up_z));
    light.third_axis[2] = fmaf(sideways_x, up_y, -(sideways_y * up_x));
    light.height = t143 ? t144 : 0.0f;
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = t113 ? t114 : 0.0f;
    light.inv_rest = t113 ? 1.0f / (1.0f - t114) : 1.0f;
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
    const bool t2 = 0.0f < light->defensive;
    const float t3 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t2 && t3 < light->defensive;
    const float t6 = 1.0f - light->defensive;
    const float t7 = spherecap_inline_max((t5 ? t3 : t3 - light->defensive) / (t5 ? light->defensive : t6), 5.9604645e-8f);
    const float t8 = 0.0f < light->requested ? spherecap_inline_min(t7, 0.99999994f) : t3;
    const bool t9 = t5 || !(0.0f < light->tau);
    const bool t10 = !t9 && !(0.0f < light->elevation_sin);
    const bool t11 = t9 || (!t10 && light->crescent_share <= t8);
    const float t12 = 1.0f - t4;
    const float t13 = t4 - t12;
    const float t14 = 4.0f * t4 * t12;
    float t15 = 0.0f;
    float t16 = 0.0f;
    float t17 = 0.0f;
    float t18 = 0.0f;
    if (t11) {
        const float t19 = spherecap_inline_max((t8 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
        const float t20 = t9 ? t8 : spherecap_inline_min(t19, 0.99999994f);
        const float t21 = t9 ? 0.0f : light->beyond;
        const float t22 = 3.1415927f - t21;
        const float t23 = fmaf(t20, t22, t21);
        const float t24 = (1.0f - t20) * t22;
        t15 = spherecap_inline_min(t23, t24) * 0.53033006f;
        t16 = 1.0f;
        t17 = 1.0f;
        t18 = t23 - t24;
    } else {
        const float t25 = sqrtf(t14);
        const float t26 = fmaf(fmaf(light->coefficients_6, t14, light->coefficients_4), t14, light->coefficients_2);
        const float t27 = fmaf(fmaf(light->coefficients_5, t14, light->coefficients_3), t14, light->coefficients_1);
        const float t28 = t25 * fmaf(t27, t25, fmaf(t26, t14, light->coefficients_0));
        const float t29 = sqrtf(fmaf(t13, t13, t28 * t28));
        const float t30 = light->tau * t28;
        const float t31 = t10 ? fmaf(t13, t13, t30 * t30) : 1.0f;
        const float t32 = t10 ? fmaf(light->kappa, t28, t29) * fmaf(light->cut, t28, t29) : light->crescent_share;
        const float t33 = (t10 ? light->width : t8) / t32;
        const float t34 = spherecap_inline_min(spherecap_inline_max(t33, 5.9604645e-8f), 0.99999994f);
        const float t35 = t10 ? t33 : light->width;
        const float t36 = t31 * t35;
        const float t37 = t36 * t36;
        const float t38 = fmaf(fmaf(fmaf(-0.00060778117f, t37, -0.0027203285f), t37, -0.10000902f), t36, fmaf(fmaf(1.0676054e-5f, t37, -0.011332183f), t37, 1.0000001f));
        t15 = t10 ? t8 : t34;
        t16 = t35 * t38;
        t17 = t31;
        t18 = t10 ? t30 : t25;
    }
    const float t39 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t15), -0.33333334f, 1419900500.0f));
    const float t40 = fmaf(-(t15 * t39), t39 * t39, 1.0f);
    const float t41 = t40 * t40;
    const float t42 = fmaf(fmaf(fmaf(0.110958695f, t41, 0.14403293f), t41, 0.22222222f), t40, fmaf(fmaf(0.12482853f, t41, 0.17283951f), t41, 0.33333334f));
    const float t43 = t16 * (t15 * fmaf(t39, t40 * t42, t39));
    const float t44 = t43 * t17;
    const float t45 = t44 * t44;
    const float t46 = fmaf(fmaf(fmaf(-0.063446075f, t45, -0.056249518f), t45, 0.0074712755f), t45, 0.09996679f);
    const float t47 = fmaf(fmaf(fmaf(0.022114987f, t45, 0.085662976f), t45, 0.030445365f), t45, 0.03209764f);
    const float t48 = t43 * fmaf(t46, t44, fmaf(t47, t45, 1.0000004f));
    const float t49 = t11 ? spherecap_inline_min(t48, 1.0f) : t48;
    const float t50 = t17 * t49;
    const float t51 = 2.0f - t50;
    const float t52 = t49 * t51;
    const float t53 = sqrtf(t52);
    float t54 = 0.0f;
    float t55 = 0.0f;
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t11) {
        const float t56 = t18 < 0.0f ? t50 : t51;
        const float t57 = t52 * t14;
        float t58 = 0.0f;
        float t59 = 0.0f;
        float t60 = 0.0f;
        float t61 = 0.0f;
        float t62 = 0.0f;
        if (t5) {
            const float t63 = light->height * (1.0f - t57);
            const float t64 = sqrtf(light->height * (2.0f - t63));
            const float t65 = (t56 - 1.0f) * t64;
            const float t66 = 1.0f - t63;
            const float t67 = fmaf(light->elevation_sin, t66, light->elevation_cos * t65);
            t58 = fmaf(light->elevation_cos, t66, -(light->elevation_sin * t65));
            t59 = t67;
            t60 = t65;
            t61 = t53 * t13 * t64;
            t62 = t67 * light->on_surface;
        } else {
            const float t68 = 1.0f - t56;
            const float t69 = spherecap_inline_max(fmaf(light->climb, t56, -light->rise), 0.0f);
            const float t70 = sqrtf(fmaf(t69, t69, light->radius_sin * light->radius_sin * t57));
            const float t71 = t1 * light->radius_cos;
            const float t72 = fmaf(light->elevation_cos * t68, fmaf(light->climb, t68, -2.0f * t71), light->radius_sin * t57);
            const float t73 = light->radius_sin * fmaf(light->elevation_cos, t72 / (t70 + t71), -(t1 * t1 * t68));
            t58 = fmaf(light->half_axis, t68, light->middle);
            t59 = t70;
            t60 = t73;
            t61 = light->radius_sin * t53 * t13;
            t62 = t70;
        }
        t54 = t58;
        t55 = t59;
        zenith = t60;
        side = t61;
        cosine = t62;
    } else {
        const float t74 = t53 * t18;
        const float t75 = 1.0f - t50;
        t54 = t75;
        t55 = t74;
        zenith = fmaf(light->elevation_cos, t74, -((t10 ? -t1 : t1) * t75));
        side = t53 * t13;
        cosine = t74;
    }
    const float t76 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t77 = 0.0f < cosine ? light->inv_above : 0.0f;
    const float t78 = light->defensive * light->inv_solid_angle;
    const float t79 = spherecap_inline_min(t78 / spherecap_inline_max(t76, 1.1754944e-38f), 3.4028235e38f);
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
    const float t90 = fmaf(light->third_axis[0], t54, fmaf(light->sideways[0], side, light->up[0] * t55));
    const float t91 = fmaf(light->third_axis[1], t54, fmaf(light->sideways[1], side, light->up[1] * t55));
    const float t92 = fmaf(light->third_axis[2], t54, fmaf(light->sideways[2], side, light->up[2] * t55));
    const float t93 = fmaf(light->elevation_cos, t87, -(light->elevation_sin * t88));
    const float t94 = fmaf(light->elevation_sin, t87, light->elevation_cos * t88);
    const float t95 = fmaf(light->third_axis[0], t93, fmaf(light->sideways[0], t89, light->up[0] * t94));
    const float t96 = fmaf(light->third_axis[1], t93, fmaf(light->sideways[1], t89, light->up[1] * t94));
    const float t97 = fmaf(light->third_axis[2], t93, fmaf(light->sideways[2], t89, light->up[2] * t94));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t90;
    sampled.direction[1] = t91;
    sampled.direction[2] = t92;
    sampled.distance = t84 * light->distance;
    sampled.normal[0] = t95;
    sampled.normal[1] = t96;
    sampled.normal[2] = t97;
    sampled.cosine = cosine;
    sampled.pdf = t2 ? fmaf(t77, t6 * t76, t78) : t77 * t76;
    sampled.projected_pdf = t2 ? spherecap_inline_min(fmaf(t77, t6, t79), 3.4028235e38f) : t77;
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
    const float t12 = fmaf(t11, (1.0f - light->defensive) * t10, light->defensive * light->inv_solid_angle);
    const bool t13 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t14 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t15 = (0.998001f <= t14 && t14 <= 1.002001f) ? (t13 ? (0.0f < light->defensive ? t12 : t11 * t10) : 0.0f) : 0.0f;
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
    float inv_above;
    float inv_below;
    float share_above;
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
    const float t115 = t113 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t116 = t112 && 0.0f < t114;
    const float t117 = t_y * t_y * t_y * shape * t114;
    const float t118 = t_y / radius_sin;
    const float t119 = fmaf(cut - t_x, shape_difference, shape);
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    float t120 = 0.0f;
    if (t112) {
        const float t121 = 1.0f + kappa;
        const float t122 = t121 * shape;
        const float t123 = 1.0f / (norm * t122);
        const float t124 = sqrtf(t123);
        const float t125 = norm * t124;
        const float t126 = 1.0f / (1.0f + cut);
        const float t127 = (t_x + kappa) * t126 - 0.5f;
        const float t128 = t127 * t127;
        const float t129 = fmaf(fmaf(fmaf(-0.026061837f, t128, -0.06372378f), t128, -0.11762552f), t128, -0.23594604f);
        const float t130 = fmaf(fmaf(fmaf(0.05430631f, t128, 0.080950715f), t128, 0.1684019f), t128, 0.32709444f);
        const float t131 = fmaf(fmaf(fmaf(t129, t128, -0.44721135f), t128, -0.7754678f), t127, fmaf(fmaf(t130, t128, 0.5987523f), t128, 0.94559944f));
        const float t132 = t121 * t131 * (t126 * t126 * t126) * (t122 * t123);
        const float t133 = fmaf(t132, t122 * t124, -1.0f);
        const float t134 = 1.0f - t132;
        const float t135 = fmaf(fmaf(30.011856f, t133, fmaf(-41.541264f, t134, -37.009792f)), t133, fmaf(77.96775f, t134, 7.470758f));
        const float t136 = fmaf(t135, t133, fmaf(fmaf(-49.13454f, t134, -9.466533f), t134, -1.5877596f));
        const float t137 = fmaf(fmaf(fmaf(15.716111f, t134, 0.0f), t134, 9.961183f), t134, -2.61785f);
        const float t138 = t133 * fmaf(t136, t133, fmaf(t137, t134, 0.8681748f));
        const float t139 = fmaf(fmaf(7.295638f, t133, -7.236236f), t133, fmaf(fmaf(fmaf(-11.4868555f, t134, 0.0f), t134, 0.0f), t134, 3.1255686f));
        const float t140 = fmaf(fmaf(fmaf(13.728438f, t134, -7.981878f), t134, 2.025724f), t134, -0.7334958f);
        const float t141 = t133 * fmaf(t139, t133, t140);
        const float t142 = fmaf(fmaf(fmaf(9.986537f, t134, 25.22195f), t134, 0.0f), t134, -2.9581387f);
        const float t143 = fmaf(fmaf(fmaf(-19.722994f, t134, 4.6594768f), t134, -0.89538246f), t134, 0.5143498f);
        const float t144 = t133 * fmaf(fmaf(fmaf(-23.220068f, t134, 7.332055f), t133, t142), t133, t143);
        const float t145 = fmaf(fmaf(fmaf(1.946617f, t133, -3.077631f), t133, 1.4945927f), t133, -0.24140751f);
        const float t146 = t133 * t145;
        const float t147 = t133 * fmaf(fmaf(0.38173297f, t133, -0.30305624f), t133, 0.05897375f);
        const float t148 = 1.0f / (elevation_cos * elevation_cos);
        const float t149 = tau * tau;
        const float t150 = t149 * t148 / (1.0f + t_x);
        const float t151 = kappa - 0.5f;
        const float t152 = cut - 0.5f;
        const float t153 = t151 * t151;
        const float t154 = t152 * t152;
        const float t155 = fmaf(0.05430631f, t153, 0.080950715f);
        const float t156 = fmaf(t155, t153, 0.1684019f);
        const float t157 = fmaf(t156, t153, 0.32709444f);
        const float t158 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t154, t155), t154, t156), t154, t157), t154, fmaf(t157, t153, 0.5987523f));
        const float t159 = fmaf(-0.026061837f, t153, -0.06372378f);
        const float t160 = fmaf(t159, t153, -0.11762552f);
        const float t161 = fmaf(t160, t153, -0.23594604f);
        const float t162 = fmaf(t161, t153, -0.44721135f);
        const float t163 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t154, t159), t154, t160), t154, t161), t154, t162);
        const float t164 = fmaf(kappa * t150, fmaf(fmaf(t152, t163, t158), t151 + t152, fmaf(t162, t153, -0.7754678f)), fmaf(t119, t150 - kappa * kappa, kappa) * t148);
        const float t165 = spherecap_inline_max(t149 * tau * (radius_cos + 1.0f) * t164 * 0.31830987f, 0.0f);
        coefficients_0 = t125;
        coefficients_1 = t132 - t125 + t138;
        coefficients_2 = t141 - t138;
        coefficients_3 = t144 - t141;
        coefficients_4 = t146 - t144;
        coefficients_5 = t147 - t146;
        coefficients_6 = -t147;
        t120 = spherecap_inline_min(t165, 0.5f);
    }
    const bool t166 = 0.0f < t115;
    const float t167 = (t109 && 0.0f < radius_cos) ? t104 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t166 ? (0.0f < t167 ? 0.15915494f / t167 : 0.0f) : 0.0f;
    const float share_above = 0.0f < inv_below ? (0.0f < inv_above ? (t106 ? 1.0f - t120 : t120) : 0.0f) : 1.0f;
    const bool t168 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t113 || (t166 && 0.0f < inv_solid_angle));
    spherecap_inline_both_light light;
    light.is_sampled = t168;
    light.solid_angle = t168 ? t167 * 6.2831855f : 0.0f;
    light.projected_solid_angle = t168 ? projected_above : 0.0f;
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
    light.defensive = t115;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
    light.third_axis[0] = fmaf(sideways_y, up_z, -(sideways_z * up_y));
    light.third_axis[1] = fmaf(sideways_z, up_x, -(sideways_x * up_z));
    light.third_axis[2] = fmaf(sideways_x, up_y, -(sideways_y * up_x));
    light.height = t166 ? t167 : 0.0f;
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = t116 ? t117 : 0.0f;
    light.inv_rest = t116 ? 1.0f / (1.0f - t117) : 1.0f;
    light.beyond = t116 ? t118 * t118 * t118 * t119 : 0.0f;
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
    const bool t3 = 0.0f < light->defensive;
    const float t4 = spherecap_inline_min(spherecap_inline_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_inline_min(spherecap_inline_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = t3 && t4 < light->defensive;
    const float t7 = 1.0f - light->defensive;
    const float t8 = spherecap_inline_max((t6 ? t4 : t4 - light->defensive) / (t6 ? light->defensive : t7), 5.9604645e-8f);
    const float t9 = 0.0f < light->requested ? spherecap_inline_min(t8, 0.99999994f) : t4;
    const bool t10 = t6 || t9 < light->share_above;
    const float t11 = 1.0f - light->share_above;
    const float t12 = spherecap_inline_max((t10 ? t9 : t9 - light->share_above) / (t10 ? light->share_above : t11), 5.9604645e-8f);
    const float t13 = t6 ? t9 : spherecap_inline_min(t12, 0.99999994f);
    const bool t14 = t6 || !(0.0f < light->tau);
    const bool t15 = !t14 && !((t10 && t2) || (!t10 && !t2));
    const bool t16 = t14 || (!t15 && light->crescent_share <= t13);
    const float t17 = 1.0f - t5;
    const float t18 = t5 - t17;
    const float t19 = 4.0f * t5 * t17;
    float t20 = 0.0f;
    float t21 = 0.0f;
    float t22 = 0.0f;
    float t23 = 0.0f;
    if (t16) {
        const float t24 = spherecap_inline_max((t13 - light->crescent_share) * light->inv_rest, 5.9604645e-8f);
        const float t25 = t14 ? t13 : spherecap_inline_min(t24, 0.99999994f);
        const float t26 = t14 ? 0.0f : light->beyond;
        const float t27 = 3.1415927f - t26;
        const float t28 = fmaf(t25, t27, t26);
        const float t29 = (1.0f - t25) * t27;
        t20 = spherecap_inline_min(t28, t29) * 0.53033006f;
        t21 = 1.0f;
        t22 = 1.0f;
        t23 = t28 - t29;
    } else {
        const float t30 = sqrtf(t19);
        const float t31 = fmaf(fmaf(light->coefficients_6, t19, light->coefficients_4), t19, light->coefficients_2);
        const float t32 = fmaf(fmaf(light->coefficients_5, t19, light->coefficients_3), t19, light->coefficients_1);
        const float t33 = t30 * fmaf(t32, t30, fmaf(t31, t19, light->coefficients_0));
        const float t34 = sqrtf(fmaf(t18, t18, t33 * t33));
        const float t35 = light->tau * t33;
        const float t36 = t15 ? fmaf(t18, t18, t35 * t35) : 1.0f;
        const float t37 = t15 ? fmaf(light->kappa, t33, t34) * fmaf(light->cut, t33, t34) : light->crescent_share;
        const float t38 = (t15 ? light->width : t13) / t37;
        const float t39 = spherecap_inline_min(spherecap_inline_max(t38, 5.9604645e-8f), 0.99999994f);
        const float t40 = t15 ? t38 : light->width;
        const float t41 = t36 * t40;
        const float t42 = t41 * t41;
        const float t43 = fmaf(fmaf(fmaf(-0.00060778117f, t42, -0.0027203285f), t42, -0.10000902f), t41, fmaf(fmaf(1.0676054e-5f, t42, -0.011332183f), t42, 1.0000001f));
        t20 = t15 ? t13 : t39;
        t21 = t40 * t43;
        t22 = t36;
        t23 = t15 ? t35 : t30;
    }
    const float t44 = spherecap_inline_float_of_bits(fmaf(spherecap_inline_bits(t20), -0.33333334f, 1419900500.0f));
    const float t45 = fmaf(-(t20 * t44), t44 * t44, 1.0f);
    const float t46 = t45 * t45;
    const float t47 = fmaf(fmaf(fmaf(0.110958695f, t46, 0.14403293f), t46, 0.22222222f), t45, fmaf(fmaf(0.12482853f, t46, 0.17283951f), t46, 0.33333334f));
    const float t48 = t21 * (t20 * fmaf(t44, t45 * t47, t44));
    const float t49 = t48 * t22;
    const float t50 = t49 * t49;
    const float t51 = fmaf(fmaf(fmaf(-0.063446075f, t50, -0.056249518f), t50, 0.0074712755f), t50, 0.09996679f);
    const float t52 = fmaf(fmaf(fmaf(0.022114987f, t50, 0.085662976f), t50, 0.030445365f), t50, 0.03209764f);
    const float t53 = t48 * fmaf(t51, t49, fmaf(t52, t50, 1.0000004f));
    const float t54 = t16 ? spherecap_inline_min(t53, 1.0f) : t53;
    const float t55 = t22 * t54;
    const float t56 = 2.0f - t55;
    const float t57 = t54 * t56;
    const float t58 = sqrtf(t57);
    float t59 = 0.0f;
    float t60 = 0.0f;
    float t61 = 0.0f;
    float side = 0.0f;
    float t62 = 0.0f;
    if (t16) {
        const float t63 = t23 < 0.0f ? t55 : t56;
        const float t64 = t57 * t19;
        float t65 = 0.0f;
        float t66 = 0.0f;
        float t67 = 0.0f;
        float t68 = 0.0f;
        float t69 = 0.0f;
        if (t6) {
            const float t70 = light->height * (1.0f - t64);
            const float t71 = sqrtf(light->height * (2.0f - t70));
            const float t72 = (t63 - 1.0f) * t71;
            const float t73 = 1.0f - t70;
            const float t74 = fmaf(light->elevation_sin, t73, light->elevation_cos * t72);
            t65 = fmaf(light->elevation_cos, t73, -(light->elevation_sin * t72));
            t66 = t74;
            t67 = t72;
            t68 = t58 * t18 * t71;
            t69 = t74 * light->on_surface;
        } else {
            const float t75 = 1.0f - t63;
            const float t76 = spherecap_inline_max(fmaf(light->climb, t63, -light->rise), 0.0f);
            const float t77 = sqrtf(fmaf(t76, t76, light->radius_sin * light->radius_sin * t64));
            const float t78 = t1 * light->radius_cos;
            const float t79 = fmaf(light->elevation_cos * t75, fmaf(light->climb, t75, -2.0f * t78), light->radius_sin * t64);
            const float t80 = light->radius_sin * fmaf(light->elevation_cos, t79 / (t77 + t78), -(t1 * t1 * t75));
            t65 = fmaf(light->half_axis, t75, light->middle);
            t66 = t77;
            t67 = t80;
            t68 = light->radius_sin * t58 * t18;
            t69 = t77;
        }
        t59 = t65;
        t60 = t66;
        t61 = t67;
        side = t68;
        t62 = t69;
    } else {
        const float t81 = t58 * t23;
        const float t82 = 1.0f - t55;
        t59 = t82;
        t60 = t81;
        t61 = fmaf(light->elevation_cos, t81, -((t15 ? -t1 : t1) * t82));
        side = t58 * t18;
        t62 = t81;
    }
    const float t83 = t10 ? 1.0f : -1.0f;
    const float zenith = t61 * t83;
    const float cosine = t62 * t83;
    const float t84 = t60 * t83;
    const float t85 = spherecap_inline_min(fabsf(cosine), 3.4028235e38f);
    const float t86 = 0.0f < cosine ? light->inv_above * light->share_above : cosine < 0.0f ? light->inv_below * t11 : 0.0f;
    const float t87 = light->defensive * light->inv_solid_angle;
    const float t88 = spherecap_inline_min(t87 / spherecap_inline_max(t85, 1.1754944e-38f), 3.4028235e38f);
    const float t89 = fmaf(zenith, zenith, side * side);
    const float t90 = spherecap_inline_max(fmaf(light->radius_sin, light->radius_sin, -t89), 0.0f);
    const float t91 = sqrtf(t90);
    const float t92 = sqrtf(fmaf(light->radius_cos, light->radius_cos, t90));
    const float t93 = light->radius_cos * light->radius_cos / (t92 + t91);
    const float t94 = 1.0f / light->radius_sin;
    const float t95 = t93 * t94;
    const float t96 = -fmaf(t92, t91, t89) * t94;
    const float t97 = t95 * zenith;
    const float t98 = t95 * side;
    const float t99 = fmaf(light->third_axis[0], t59, fmaf(light->sideways[0], side, light->up[0] * t84));
    const float t100 = fmaf(light->third_axis[1], t59, fmaf(light->sideways[1], side, light->up[1] * t84));
    const float t101 = fmaf(light->third_axis[2], t59, fmaf(light->sideways[2], side, light->up[2] * t84));
    const float t102 = fmaf(light->elevation_cos, t96, -(light->elevation_sin * t97));
    const float t103 = fmaf(light->elevation_sin, t96, light->elevation_cos * t97);
    const float t104 = fmaf(light->third_axis[0], t102, fmaf(light->sideways[0], t98, light->up[0] * t103));
    const float t105 = fmaf(light->third_axis[1], t102, fmaf(light->sideways[1], t98, light->up[1] * t103));
    const float t106 = fmaf(light->third_axis[2], t102, fmaf(light->sideways[2], t98, light->up[2] * t103));
    spherecap_inline_sample sampled;
    sampled.direction[0] = t99;
    sampled.direction[1] = t100;
    sampled.direction[2] = t101;
    sampled.distance = t93 * light->distance;
    sampled.normal[0] = t104;
    sampled.normal[1] = t105;
    sampled.normal[2] = t106;
    sampled.cosine = cosine;
    sampled.pdf = t3 ? fmaf(t86, t7 * t85, t87) : t86 * t85;
    sampled.projected_pdf = t3 ? spherecap_inline_min(fmaf(t86, t7, t88), 3.4028235e38f) : t86;
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
    const float t11 = 0.0f < t6 ? light->inv_above * light->share_above : t6 < 0.0f ? light->inv_below * (1.0f - light->share_above) : 0.0f;
    const float t12 = fmaf(t11, (1.0f - light->defensive) * t10, light->defensive * light->inv_solid_angle);
    const bool t13 = fmaf(t8, t8, t9 * t9) <= light->radius_sin * light->radius_sin * 1.0000019f;
    const float t14 = fmaf(direction[0], direction[0], fmaf(direction[1], direction[1], direction[2] * direction[2]));
    const float t15 = (0.998001f <= t14 && t14 <= 1.002001f) ? (t13 ? (0.0f < light->defensive ? t12 : t11 * t10) : 0.0f) : 0.0f;
    return t15;
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
