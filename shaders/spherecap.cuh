#ifndef SPHERECAP_CUH
#define SPHERECAP_CUH

// Samples spherical lights uniformly in projected solid angle. Version 0.1.0 of spherecap, MIT licence.
// After C. Peters and C. Dachsbacher, Sampling Projected Spherical Caps in Real Time (2019). Generated from the
// kernels of the library by `make shaders`: do not edit. docs/source.md and docs/mathematics.md explain.
//
// spherecap_surface_prepare looks at a light from a shading point: normal is the surface's, centre the sphere's
// centre minus the shading point, radius > 0 its radius, all in one unit of length. If is_sampled is false the
// light gives nothing here, or the input is bad; then densities are 0. solid_angle is the light's, and
// projected_solid_angle that above the horizon, in steradians; the other numbers are for the functions.
// spherecap_surface_sample samples a direction by two random numbers in [0, 1]; _sample_once prepares, too.
// spherecap_surface_pdf_direction is the density of a unit direction per steradian, 0 outside the light;
// _pdf_on_sphere is for one that is known to meet it. _importance is what the light gives to the point, to
// choose among lights by, in proportion to strength, its radiance. `surface` can be `front` or `both`, see below.
// CUDA 9 or later. With -use_fast_math only divisions and roots are less precise, and subnormal numbers are zeros.

static __device__ inline float spherecap_min(float a, float b) {
    return a < b ? a : b;
}

static __device__ inline float spherecap_max(float a, float b) {
    return a > b ? a : b;
}

// What rounding took off the product a b.
static __device__ inline float spherecap_lost(float a, float b, float product) {
    return __fmaf_rn(a, b, -product);
}

// A number without its sign and its significand.
static __device__ inline float spherecap_power_of_two(float a) {
    return __int_as_float(__float_as_int(a) & 0x7f800000);
}

// The bits of a number, as a number.
static __device__ inline float spherecap_bits(float a) {
    return __int2float_rn(__float_as_int(a));
}

// The number of these bits; any number where they are none.
static __device__ inline float spherecap_float_of_bits(float a) {
    return __int_as_float(__float2int_rz(a));
}

// A sample.
// direction: Unit direction from the shading point.
// distance: Distance to the sphere along it, in the unit of the centre.
// normal: Unit outward normal of the sphere there.
// cosine: Cosine of the direction with the surface's normal: more precise than their product.
// pdf: Density of the direction, per steradian; 0 if nothing is sampled.
// projected_pdf: The same over |cosine|, but never infinite.
struct spherecap_sample {
    float3 direction;
    float distance;
    float3 normal;
    float cosine;
    float pdf;
    float projected_pdf;
};

static __device__ inline spherecap_sample spherecap_no_sample() {
    spherecap_sample sampled;
    sampled.direction = make_float3(0.0f, 0.0f, 0.0f);
    sampled.distance = 0.0f;
    sampled.normal = make_float3(0.0f, 0.0f, 0.0f);
    sampled.cosine = 0.0f;
    sampled.pdf = 0.0f;
    sampled.projected_pdf = 0.0f;
    return sampled;
}

// A point on a surface that is lit from the front. The normal must be of unit length to single precision.
struct spherecap_surface_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float3 towards_centre;
    float3 sideways;
    float3 normal;
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
    float3 third_axis;
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
};

static __device__ inline spherecap_surface_light spherecap_surface_prepare(float3 normal, float3 centre, float radius) {
    const bool t1 = fmaf(centre.x, centre.x, fmaf(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0f;
    const bool t2 = t1 && 9.536743e-7f < radius;
    const float t3 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t3, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t4 = t2 ? centre.x : centre.x * scale;
    const float t5 = t2 ? centre.y : centre.y * scale;
    const float t6 = t2 ? centre.z : centre.z * scale;
    const float t7 = t2 ? radius : radius * scale;
    const float t8 = __fmul_rn(t6, t6);
    const float t9 = fmaf(t4, t4, fmaf(t5, t5, t8));
    const float t10 = fmaf(-t7, t7, t9);
    float t11 = 0.0f;
    float t12 = 0.0f;
    if (t10 < t9 * 0.25f) {
        const float t13 = __fmul_rn(t4, t4);
        const float t14 = __fmul_rn(t5, t5);
        const float t15 = __fadd_rn(t13, t14);
        const float t16 = __fsub_rn(t15, t13);
        const float t17 = __fadd_rn(t15, t8);
        const float t18 = __fsub_rn(t17, t15);
        const float t19 = spherecap_lost(t4, t4, t13) + spherecap_lost(t5, t5, t14) + spherecap_lost(t6, t6, t8);
        const float t20 = __fsub_rn(t13, __fsub_rn(t15, t16)) + __fsub_rn(t14, t16) + (__fsub_rn(t15, __fsub_rn(t17, t18)) + __fsub_rn(t8, t18));
        t11 = t17;
        t12 = fmaf(-t7, t7, t17) + (t19 + t20);
    } else {
        t11 = t9;
        t12 = t10;
    }
    const float t21 = __fmul_rn(normal.z, t5);
    const float t22 = fmaf(normal.y, t6, -t21);
    const float t23 = __fmul_rn(normal.x, t6);
    const float t24 = fmaf(normal.z, t4, -t23);
    const float t25 = __fmul_rn(normal.y, t4);
    const float t26 = fmaf(normal.x, t5, -t25);
    const float t27 = fmaf(t22, t22, fmaf(t24, t24, t26 * t26));
    float t28 = 0.0f;
    float t29 = 0.0f;
    float t30 = 0.0f;
    float t31 = 0.0f;
    float t32 = 0.0f;
    if (t27 < t11 * 0.015625f) {
        const float t33 = t22 - spherecap_lost(normal.z, t5, t21);
        const float t34 = t24 - spherecap_lost(normal.x, t6, t23);
        const float t35 = t26 - spherecap_lost(normal.y, t4, t25);
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
    const float t44 = __fmul_rn(normal.x, t4);
    const float t45 = __fmul_rn(normal.y, t5);
    const float t46 = __fmul_rn(normal.z, t6);
    const float t47 = __fadd_rn(t44, t45);
    const float t48 = __fsub_rn(t47, t44);
    const float t49 = __fadd_rn(t47, t46);
    const float t50 = __fsub_rn(t49, t47);
    const float t51 = spherecap_lost(normal.x, t4, t44) + spherecap_lost(normal.y, t5, t45) + spherecap_lost(normal.z, t6, t46);
    const float t52 = __fsub_rn(t44, __fsub_rn(t47, t48)) + __fsub_rn(t45, t48) + (__fsub_rn(t47, __fsub_rn(t49, t50)) + __fsub_rn(t46, t50));
    const float t53 = t51 + t52;
    const float t54 = __fadd_rn(t49, t53);
    const float t55 = __fsub_rn(t53, __fsub_rn(t54, t49));
    const float t56 = t7 - t54 - t55;
    const float t57 = t7 + t54 + t55;
    const float t58 = t56 * t57;
    const float t59 = sqrtf(t12);
    const bool t60 = 0.0f < t12;
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
    float t61 = 0.0f;
    if (0.0f < t58 && t60) {
        const float t62 = sqrtf(t12 + t58);
        const float t63 = sqrtf(t58);
        const float t64 = 1.0f / (t62 * t7);
        const float t65 = t64 * t7;
        const float t66 = t64 * t62;
        const float t67 = t59 * t65;
        const float t68 = t63 * t65;
        const float t69 = t68 * t68;
        const float t70 = fabsf(t54) * t66;
        const float t71 = t70 * t67;
        const float t72 = t67 - 0.5f;
        const float t73 = t71 - 0.5f;
        const float t74 = t72 * t72;
        const float t75 = t73 * t73;
        const float t76 = fmaf(0.05430631f, t74, 0.080950715f);
        const float t77 = fmaf(t76, t74, 0.1684019f);
        const float t78 = fmaf(t77, t74, 0.32709444f);
        const float t79 = fmaf(t78, t74, 0.5987523f);
        const float t80 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t75, t76), t75, t77), t75, t78), t75, t79);
        const float t81 = fmaf(-0.026061837f, t74, -0.06372378f);
        const float t82 = fmaf(t81, t74, -0.11762552f);
        const float t83 = fmaf(t82, t74, -0.23594604f);
        const float t84 = fmaf(t83, t74, -0.44721135f);
        const float t85 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t75, t81), t75, t82), t75, t83), t75, t84);
        const float t86 = fmaf(t84, t74, -0.7754678f);
        const float t87 = fmaf(t86, t72, fmaf(t79, t74, 0.94559944f));
        const float t88 = fmaf(fmaf(t73, t85, t80), t72 + t73, t86);
        const float t89 = fmaf(t71, t88, t87);
        t_x = t67;
        t_y = t68;
        width = t69 / (1.0f + t67);
        kappa = t70;
        cut = t71;
        shape = t87;
        shape_difference = t88;
        norm = t89;
        tau = t63 * t66;
        area = t69 * t68 * (spherecap_min(t56, t57) * t66) * t89;
        t61 = t62;
    } else {
        t61 = t32;
    }
    const float t90 = sqrtf(t11);
    const float t91 = 1.0f / t90;
    const float radius_sin = t7 * t91;
    const float radius_cos = t59 * t91;
    const float elevation_sin = t54 * t91;
    const float elevation_cos = t61 * t91;
    const float t92 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t58 * (t91 * t91) / fmaf(radius_cos, t92, climb), -(radius_cos * t92));
    const float t93 = radius_sin * radius_sin;
    const bool t94 = 0.0f < elevation_sin;
    const float t95 = t94 ? fmaf(t93 * t92, 3.1415927f, area) : area;
    const bool t96 = 9.8607613e-32f < t93;
    const float t97 = 1.0f / t31;
    const float sideways_x = t28 * t97;
    const float sideways_y = t29 * t97;
    const float sideways_z = t30 * t97;
    const float distance = t90 * (t2 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t95 && t96 && t60) ? t95 : 0.0f;
    const bool t98 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float t99 = t94 ? inv_above : 0.0f;
    const bool t100 = t98 && t94 && 0.0f < t99;
    const float t101 = t_y * t_y * t_y * shape * t99;
    const float t102 = t_y / radius_sin;
    const float beyond = t100 ? t102 * t102 * t102 * fmaf(cut - t_x, shape_difference, shape) : 0.0f;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (t98 && !t94) {
        const float t103 = 1.0f + kappa;
        const float t104 = t103 * shape;
        const float t105 = 1.0f / (norm * t104);
        const float t106 = sqrtf(t105);
        const float t107 = norm * t106;
        const float t108 = 1.0f / (1.0f + cut);
        const float t109 = (t_x + kappa) * t108 - 0.5f;
        const float t110 = t109 * t109;
        const float t111 = fmaf(fmaf(fmaf(-0.026061837f, t110, -0.06372378f), t110, -0.11762552f), t110, -0.23594604f);
        const float t112 = fmaf(fmaf(fmaf(0.05430631f, t110, 0.080950715f), t110, 0.1684019f), t110, 0.32709444f);
        const float t113 = fmaf(fmaf(fmaf(t111, t110, -0.44721135f), t110, -0.7754678f), t109, fmaf(fmaf(t112, t110, 0.5987523f), t110, 0.94559944f));
        const float t114 = t103 * t113 * (t108 * t108 * t108) * (t104 * t105);
        const float t115 = fmaf(t114, t104 * t106, -1.0f);
        const float t116 = 1.0f - t114;
        const float t117 = fmaf(fmaf(30.011856f, t115, fmaf(-41.541264f, t116, -37.009792f)), t115, fmaf(77.96775f, t116, 7.470758f));
        const float t118 = fmaf(t117, t115, fmaf(fmaf(-49.13454f, t116, -9.466533f), t116, -1.5877596f));
        const float t119 = fmaf(fmaf(fmaf(15.716111f, t116, 0.0f), t116, 9.961183f), t116, -2.61785f);
        const float t120 = t115 * fmaf(t118, t115, fmaf(t119, t116, 0.8681748f));
        const float t121 = fmaf(fmaf(7.295638f, t115, -7.236236f), t115, fmaf(fmaf(fmaf(-11.4868555f, t116, 0.0f), t116, 0.0f), t116, 3.1255686f));
        const float t122 = fmaf(fmaf(fmaf(13.728438f, t116, -7.981878f), t116, 2.025724f), t116, -0.7334958f);
        const float t123 = t115 * fmaf(t121, t115, t122);
        const float t124 = fmaf(fmaf(fmaf(9.986537f, t116, 25.22195f), t116, 0.0f), t116, -2.9581387f);
        const float t125 = fmaf(fmaf(fmaf(-19.722994f, t116, 4.6594768f), t116, -0.89538246f), t116, 0.5143498f);
        const float t126 = t115 * fmaf(fmaf(fmaf(-23.220068f, t116, 7.332055f), t115, t124), t115, t125);
        const float t127 = fmaf(fmaf(fmaf(1.946617f, t115, -3.077631f), t115, 1.4945927f), t115, -0.24140751f);
        const float t128 = t115 * t127;
        const float t129 = t115 * fmaf(fmaf(0.38173297f, t115, -0.30305624f), t115, 0.05897375f);
        coefficients_0 = t107;
        coefficients_1 = t114 - t107 + t120;
        coefficients_2 = t123 - t120;
        coefficients_3 = t126 - t123;
        coefficients_4 = t128 - t126;
        coefficients_5 = t129 - t128;
        coefficients_6 = -t129;
    }
    const bool t130 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    const float t131 = ((t96 && 0.0f < radius_cos) ? t93 / (1.0f + radius_cos) : 0.0f) * 6.2831855f;
    spherecap_surface_light light;
    light.is_sampled = t130;
    light.solid_angle = t130 ? t131 : 0.0f;
    light.projected_solid_angle = t130 ? projected_above : 0.0f;
    light.towards_centre = make_float3(t4 * t91, t5 * t91, t6 * t91);
    light.sideways = make_float3(sideways_x, sideways_y, sideways_z);
    light.normal = make_float3(normal.x, normal.y, normal.z);
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
    light.third_axis = make_float3(fmaf(sideways_y, normal.z, -(sideways_z * normal.y)), fmaf(sideways_z, normal.x, -(sideways_x * normal.z)), fmaf(sideways_x, normal.y, -(sideways_y * normal.x)));
    light.crescent_share = t100 ? t101 : 0.0f;
    light.inv_rest = t100 ? 1.0f / (1.0f - t101) : 1.0f;
    light.beyond = beyond;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t92;
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

static __device__ inline spherecap_sample spherecap_surface_sample(spherecap_surface_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = fabsf(light.elevation_sin);
    const bool t2 = 0.0f < light.tau;
    const bool t3 = t2 && !(0.0f < light.elevation_sin);
    const float t4 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = !t2 || (!t3 && light.crescent_share <= t4);
    const float t7 = 1.0f - t5;
    const float t8 = t5 - t7;
    const float t9 = 4.0f * t5 * t7;
    const float t10 = spherecap_max((t4 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t11 = t2 ? spherecap_min(t10, 0.99999994f) : t4;
    const float t12 = t2 ? light.beyond : 0.0f;
    const float t13 = 3.1415927f - t12;
    const float t14 = fmaf(t11, t13, t12);
    const float t15 = (1.0f - t11) * t13;
    float t16 = 0.0f;
    float t17 = 0.0f;
    float t18 = 0.0f;
    float t19 = 0.0f;
    if (t6) {
        t17 = spherecap_min(t14, t15) * 0.53033006f;
        t18 = 1.0f;
        t19 = 1.0f;
    } else {
        const float t20 = sqrtf(t9);
        const float t21 = fmaf(fmaf(light.coefficients_6, t9, light.coefficients_4), t9, light.coefficients_2);
        const float t22 = fmaf(fmaf(light.coefficients_5, t9, light.coefficients_3), t9, light.coefficients_1);
        const float t23 = t20 * fmaf(t22, t20, fmaf(t21, t9, light.coefficients_0));
        const float t24 = sqrtf(fmaf(t8, t8, t23 * t23));
        const float t25 = light.tau * t23;
        const float t26 = t3 ? fmaf(t8, t8, t25 * t25) : 1.0f;
        const float t27 = t3 ? fmaf(light.kappa, t23, t24) * fmaf(light.cut, t23, t24) : light.crescent_share;
        const float t28 = (t3 ? light.width : t4) / t27;
        const float t29 = t3 ? t28 : light.width;
        const float t30 = t26 * t29;
        const float t31 = t30 * t30;
        const float t32 = fmaf(fmaf(fmaf(-0.00060778117f, t31, -0.0027203285f), t31, -0.10000902f), t30, fmaf(fmaf(1.0676054e-5f, t31, -0.011332183f), t31, 1.0000001f));
        t16 = t3 ? t25 : t20;
        t17 = t3 ? t4 : spherecap_min(spherecap_max(t28, 5.9604645e-8f), 0.99999994f);
        t18 = t29 * t32;
        t19 = t26;
    }
    const float t33 = spherecap_float_of_bits(fmaf(spherecap_bits(t17), -0.33333334f, 1419900500.0f));
    const float t34 = fmaf(-(t17 * t33), t33 * t33, 1.0f);
    const float t35 = t34 * t34;
    const float t36 = fmaf(fmaf(fmaf(0.110958695f, t35, 0.14403293f), t35, 0.22222222f), t34, fmaf(fmaf(0.12482853f, t35, 0.17283951f), t35, 0.33333334f));
    const float t37 = t18 * (t17 * fmaf(t33, t34 * t36, t33));
    const float t38 = t37 * t19;
    const float t39 = t38 * t38;
    const float t40 = fmaf(fmaf(fmaf(-0.063446075f, t39, -0.056249518f), t39, 0.0074712755f), t39, 0.09996679f);
    const float t41 = fmaf(fmaf(fmaf(0.022114987f, t39, 0.085662976f), t39, 0.030445365f), t39, 0.03209764f);
    const float t42 = t37 * fmaf(t40, t38, fmaf(t41, t39, 1.0000004f));
    const float t43 = t6 ? spherecap_min(t42, 1.0f) : t42;
    const float t44 = t19 * t43;
    const float t45 = 2.0f - t44;
    const float t46 = t43 * t45;
    const float t47 = sqrtf(t46);
    float t48 = 0.0f;
    float t49 = 0.0f;
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t6) {
        const float t50 = t14 - t15 < 0.0f ? t44 : t45;
        const float t51 = t46 * t9;
        const float t52 = 1.0f - t50;
        const float t53 = spherecap_max(fmaf(light.climb, t50, -light.rise), 0.0f);
        const float t54 = sqrtf(fmaf(t53, t53, light.radius_sin * light.radius_sin * t51));
        const float t55 = t1 * light.radius_cos;
        const float t56 = fmaf(light.elevation_cos * t52, fmaf(light.climb, t52, -2.0f * t55), light.radius_sin * t51);
        const float t57 = light.radius_sin * fmaf(light.elevation_cos, t56 / (t54 + t55), -(t1 * t1 * t52));
        t48 = fmaf(light.half_axis, t52, light.middle);
        t49 = t54;
        zenith = t57;
        side = light.radius_sin * t47 * t8;
        cosine = t54;
    } else {
        const float t58 = t47 * t16;
        const float t59 = 1.0f - t44;
        t48 = t59;
        t49 = t58;
        zenith = fmaf(light.elevation_cos, t58, -((t3 ? -t1 : t1) * t59));
        side = t47 * t8;
        cosine = t58;
    }
    const float t60 = 0.0f < cosine ? light.inv_above : 0.0f;
    const float t61 = fmaf(zenith, zenith, side * side);
    const float t62 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t61), 0.0f);
    const float t63 = sqrtf(t62);
    const float t64 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t62));
    const float t65 = light.radius_cos * light.radius_cos / (t64 + t63);
    const float t66 = 1.0f / light.radius_sin;
    const float t67 = t65 * t66;
    const float t68 = -fmaf(t64, t63, t61) * t66;
    const float t69 = t67 * zenith;
    const float t70 = t67 * side;
    const float t71 = fmaf(light.third_axis.x, t48, fmaf(light.sideways.x, side, light.normal.x * t49));
    const float t72 = fmaf(light.third_axis.y, t48, fmaf(light.sideways.y, side, light.normal.y * t49));
    const float t73 = fmaf(light.third_axis.z, t48, fmaf(light.sideways.z, side, light.normal.z * t49));
    const float t74 = fmaf(light.elevation_cos, t68, -(light.elevation_sin * t69));
    const float t75 = fmaf(light.elevation_sin, t68, light.elevation_cos * t69);
    const float t76 = fmaf(light.third_axis.x, t74, fmaf(light.sideways.x, t70, light.normal.x * t75));
    const float t77 = fmaf(light.third_axis.y, t74, fmaf(light.sideways.y, t70, light.normal.y * t75));
    const float t78 = fmaf(light.third_axis.z, t74, fmaf(light.sideways.z, t70, light.normal.z * t75));
    spherecap_sample sampled;
    sampled.direction = make_float3(t71, t72, t73);
    sampled.distance = t65 * light.distance;
    sampled.normal = make_float3(t76, t77, t78);
    sampled.cosine = cosine;
    sampled.pdf = t60 * spherecap_min(fabsf(cosine), 3.4028235e38f);
    sampled.projected_pdf = t60;
    return sampled;
}

static __device__ inline spherecap_sample spherecap_surface_sample_once(float3 normal, float3 centre, float radius, float u0, float u1) {
    const spherecap_surface_light light = spherecap_surface_prepare(normal, centre, radius);
    return spherecap_surface_sample(light, u0, u1);
}

static __device__ inline float spherecap_surface_pdf_direction(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    const float t2 = fmaf(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    const float t3 = fmaf(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    const float t4 = fmaf(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    const float t5 = fmaf(light.sideways.x, direction.x, fmaf(light.sideways.y, direction.y, light.sideways.z * direction.z));
    const float t6 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const bool t7 = fmaf(light.towards_centre.x, direction.x, t1) < 0.0f;
    const float t8 = t7 ? 1.0f : fmaf(t2, direction.x, fmaf(t3, direction.y, t4 * direction.z));
    const float t9 = t7 ? 1.0f : t5;
    const float t10 = (0.0f < t6 ? light.inv_above : 0.0f) * spherecap_min(fabsf(t6), 3.4028235e38f);
    const bool t11 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t12 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? t10 : 0.0f) : 0.0f;
}

static __device__ inline float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = (0.0f < t1 ? light.inv_above : 0.0f) * spherecap_min(fabsf(t1), 3.4028235e38f);
    const float t3 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
}

static __device__ inline float spherecap_surface_importance(float3 normal, float3 centre, float radius, float strength) {
    const float t1 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t2 = centre.x * scale;
    const float t3 = centre.y * scale;
    const float t4 = centre.z * scale;
    const float t5 = radius * scale;
    const float t6 = sqrtf(fmaf(t2, t2, fmaf(t3, t3, t4 * t4)));
    const float t7 = 1.0f / t6;
    const float t8 = t5 * t7;
    const float t9 = t8 * t8;
    const bool t10 = 0.0f < radius && t6 * unscale <= 3.4028235e38f && 0.0f < strength && strength <= 3.4028235e38f;
    const float t11 = fmaf(normal.x, t2, fmaf(normal.y, t3, normal.z * t4));
    const float t12 = fmaf(t11, t7, 2.3841858e-7f);
    const float t13 = fmaf(t11 + t5, t7, 2.3841858e-7f);
    const float t14 = fmaf(t8 - t12, spherecap_max(fmaf(-t9, t9, 0.9999981f), 0.0f), t13) * 2.0f;
    const float t15 = t8 <= t12 ? t12 : 0.0f < t13 ? t13 * t13 / t14 : 0.0f;
    const float t16 = fmaf(0.0f, 0.5f - t15, t15);
    const float t17 = spherecap_min(spherecap_max(t9 * t16 * strength, 1.1754944e-38f), 3.4028235e38f);
    const float t18 = (t9 <= 1.0000019f && 4.9303807e-32f < t9 && t10 && 0.0f < t16) ? t17 : 0.0f;
    return t18;
}


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the
// probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with
// the normal.
struct spherecap_front_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float3 towards_centre;
    float3 sideways;
    float3 normal;
    float3 up;
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
    float3 third_axis;
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
};

static __device__ inline spherecap_front_light spherecap_front_prepare(float3 normal, float3 centre, float radius, float defensive) {
    const float t1 = fmaf(normal.x, normal.x, fmaf(normal.y, normal.y, normal.z * normal.z)) - 1.0f;
    float normal_x = 0.0f;
    float normal_y = 0.0f;
    float normal_z = 0.0f;
    if (fabsf(t1) <= 4.7683716e-7f) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        const float t2 = spherecap_max(fabsf(normal.x) + fabsf(normal.y) + fabsf(normal.z), 1.1754944e-38f);
        const float t3 = spherecap_power_of_two(spherecap_min(t2, 8.5070587e37f));
        const float t4 = normal.x / t3;
        const float t5 = normal.y / t3;
        const float t6 = normal.z / t3;
        const float t7 = spherecap_max(sqrtf(fmaf(t4, t4, fmaf(t5, t5, t6 * t6))), 1.1754944e-38f);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    const float t8 = fmaf(normal_x, normal_x, fmaf(normal_y, normal_y, normal_z * normal_z));
    const bool t9 = fmaf(centre.x, centre.x, fmaf(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0f;
    const bool t10 = t9 && 9.536743e-7f < radius;
    const float t11 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t12 = t10 ? centre.x : centre.x * scale;
    const float t13 = t10 ? centre.y : centre.y * scale;
    const float t14 = t10 ? centre.z : centre.z * scale;
    const float t15 = t10 ? radius : radius * scale;
    const float t16 = __fmul_rn(t14, t14);
    const float t17 = fmaf(t12, t12, fmaf(t13, t13, t16));
    const float t18 = fmaf(-t15, t15, t17);
    float t19 = 0.0f;
    float t20 = 0.0f;
    if (t18 < t17 * 0.25f) {
        const float t21 = __fmul_rn(t12, t12);
        const float t22 = __fmul_rn(t13, t13);
        const float t23 = __fadd_rn(t21, t22);
        const float t24 = __fsub_rn(t23, t21);
        const float t25 = __fadd_rn(t23, t16);
        const float t26 = __fsub_rn(t25, t23);
        const float t27 = spherecap_lost(t12, t12, t21) + spherecap_lost(t13, t13, t22) + spherecap_lost(t14, t14, t16);
        const float t28 = __fsub_rn(t21, __fsub_rn(t23, t24)) + __fsub_rn(t22, t24) + (__fsub_rn(t23, __fsub_rn(t25, t26)) + __fsub_rn(t16, t26));
        t19 = t25;
        t20 = fmaf(-t15, t15, t25) + (t27 + t28);
    } else {
        t19 = t17;
        t20 = t18;
    }
    const bool t29 = 0.0f < t8;
    const float t30 = __fmul_rn(normal_z, t13);
    const float t31 = fmaf(normal_y, t14, -t30);
    const float t32 = __fmul_rn(normal_x, t14);
    const float t33 = fmaf(normal_z, t12, -t32);
    const float t34 = __fmul_rn(normal_y, t12);
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
        const float t42 = t31 - spherecap_lost(normal_z, t13, t30);
        const float t43 = t33 - spherecap_lost(normal_x, t14, t32);
        const float t44 = t35 - spherecap_lost(normal_y, t12, t34);
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
    const float t56 = __fmul_rn(normal_x, t12);
    const float t57 = __fmul_rn(normal_y, t13);
    const float t58 = __fmul_rn(normal_z, t14);
    const float t59 = __fadd_rn(t56, t57);
    const float t60 = __fsub_rn(t59, t56);
    const float t61 = __fadd_rn(t59, t58);
    const float t62 = __fsub_rn(t61, t59);
    const float t63 = spherecap_lost(normal_x, t12, t56) + spherecap_lost(normal_y, t13, t57) + spherecap_lost(normal_z, t14, t58);
    const float t64 = __fsub_rn(t56, __fsub_rn(t59, t60)) + __fsub_rn(t57, t60) + (__fsub_rn(t59, __fsub_rn(t61, t62)) + __fsub_rn(t58, t62));
    const float t65 = t63 + t64;
    const float t66 = __fadd_rn(t61, t65);
    const float t67 = __fsub_rn(t65, __fsub_rn(t66, t61));
    const float t68 = t15 - t66 - t67;
    const float t69 = t15 + t66 + t67;
    const float t70 = t68 * t69;
    const float t71 = sqrtf(t20);
    const bool t72 = 0.0f < t20;
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
    float t73 = 0.0f;
    if (0.0f < t70 && t29 && t72) {
        const float t74 = sqrtf(t20 + t70);
        const float t75 = sqrtf(t70);
        const float t76 = 1.0f / (t74 * t15);
        const float t77 = t76 * t15;
        const float t78 = t76 * t74;
        const float t79 = t71 * t77;
        const float t80 = t75 * t77;
        const float t81 = t80 * t80;
        const float t82 = fabsf(t66) * t78;
        const float t83 = t82 * t79;
        const float t84 = t79 - 0.5f;
        const float t85 = t83 - 0.5f;
        const float t86 = t84 * t84;
        const float t87 = t85 * t85;
        const float t88 = fmaf(0.05430631f, t86, 0.080950715f);
        const float t89 = fmaf(t88, t86, 0.1684019f);
        const float t90 = fmaf(t89, t86, 0.32709444f);
        const float t91 = fmaf(t90, t86, 0.5987523f);
        const float t92 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t87, t88), t87, t89), t87, t90), t87, t91);
        const float t93 = fmaf(-0.026061837f, t86, -0.06372378f);
        const float t94 = fmaf(t93, t86, -0.11762552f);
        const float t95 = fmaf(t94, t86, -0.23594604f);
        const float t96 = fmaf(t95, t86, -0.44721135f);
        const float t97 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t87, t93), t87, t94), t87, t95), t87, t96);
        const float t98 = fmaf(t96, t86, -0.7754678f);
        const float t99 = fmaf(t98, t84, fmaf(t91, t86, 0.94559944f));
        const float t100 = fmaf(fmaf(t85, t97, t92), t84 + t85, t98);
        const float t101 = fmaf(t83, t100, t99);
        t_x = t79;
        t_y = t80;
        width = t81 / (1.0f + t79);
        kappa = t82;
        cut = t83;
        shape = t99;
        shape_difference = t100;
        norm = t101;
        tau = t75 * t78;
        area = t81 * t80 * (spherecap_min(t68, t69) * t78) * t101;
        t73 = t74;
    } else {
        t73 = t41;
    }
    const float t102 = sqrtf(t19);
    const float t103 = 1.0f / t102;
    const float radius_sin = t15 * t103;
    const float radius_cos = t71 * t103;
    const float elevation_sin = t66 * t103;
    const float elevation_cos = t73 * t103;
    const float t104 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t70 * (t103 * t103) / fmaf(radius_cos, t104, climb), -(radius_cos * t104));
    const float t105 = radius_sin * radius_sin;
    const bool t106 = 0.0f < elevation_sin;
    const float t107 = t106 ? fmaf(t105 * t104, 3.1415927f, area) : area;
    const bool t108 = 9.8607613e-32f < t105;
    const float t109 = 1.0f / t40;
    const float sideways_x = t37 * t109;
    const float sideways_y = t38 * t109;
    const float sideways_z = t39 * t109;
    const float on_surface = t29 ? 1.0f : 0.0f;
    const float distance = t102 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t107 && t108 && t72) ? t107 : 0.0f;
    const bool t110 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t111 = 0.0f < inv_above;
    const float t112 = t106 ? inv_above : 0.0f;
    const float defensive_share = t111 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t113 = t110 && t106 && 0.0f < t112;
    const float t114 = t_y * t_y * t_y * shape * t112;
    const float t115 = t_y / radius_sin;
    const float beyond = t113 ? t115 * t115 * t115 * fmaf(cut - t_x, shape_difference, shape) : 0.0f;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (t110 && !t106) {
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
    const bool t143 = 0.0f < defensive_share;
    const float t144 = (t108 && 0.0f < radius_cos) ? t105 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t143 ? (0.0f < t144 ? 0.15915494f / t144 : 0.0f) : 0.0f;
    const bool t145 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t111 || (t143 && 0.0f < inv_solid_angle));
    spherecap_front_light light;
    light.is_sampled = t145;
    light.solid_angle = t145 ? t144 * 6.2831855f : 0.0f;
    light.projected_solid_angle = t145 ? projected_above : 0.0f;
    light.towards_centre = make_float3(t12 * t103, t13 * t103, t14 * t103);
    light.sideways = make_float3(sideways_x, sideways_y, sideways_z);
    light.normal = make_float3(normal_x, normal_y, normal_z);
    light.up = make_float3(up_x, up_y, up_z);
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
    light.third_axis = make_float3(fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x)));
    light.height = t143 ? t144 : 0.0f;
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = t113 ? t114 : 0.0f;
    light.inv_rest = t113 ? 1.0f / (1.0f - t114) : 1.0f;
    light.beyond = beyond;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t104;
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

static __device__ inline spherecap_sample spherecap_front_sample(spherecap_front_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = fabsf(light.elevation_sin);
    const bool t2 = 0.0f < light.defensive_share;
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t2 && t3 < light.defensive_share;
    const float t6 = 1.0f - light.defensive_share;
    const float t7 = (t5 ? t3 : t3 - light.defensive_share) / (t5 ? light.defensive_share : t6);
    const float t8 = 0.0f < light.requested ? spherecap_min(spherecap_max(t7, 5.9604645e-8f), 0.99999994f) : t3;
    const bool t9 = t5 || !(0.0f < light.tau);
    const bool t10 = !t9 && !(0.0f < light.elevation_sin);
    const bool t11 = t9 || (!t10 && light.crescent_share <= t8);
    const float t12 = 1.0f - t4;
    const float t13 = t4 - t12;
    const float t14 = 4.0f * t4 * t12;
    const float t15 = spherecap_max((t8 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t16 = t9 ? t8 : spherecap_min(t15, 0.99999994f);
    const float t17 = t9 ? 0.0f : light.beyond;
    const float t18 = 3.1415927f - t17;
    const float t19 = fmaf(t16, t18, t17);
    const float t20 = (1.0f - t16) * t18;
    float t21 = 0.0f;
    float t22 = 0.0f;
    float t23 = 0.0f;
    float t24 = 0.0f;
    if (t11) {
        t22 = spherecap_min(t19, t20) * 0.53033006f;
        t23 = 1.0f;
        t24 = 1.0f;
    } else {
        const float t25 = sqrtf(t14);
        const float t26 = fmaf(fmaf(light.coefficients_6, t14, light.coefficients_4), t14, light.coefficients_2);
        const float t27 = fmaf(fmaf(light.coefficients_5, t14, light.coefficients_3), t14, light.coefficients_1);
        const float t28 = t25 * fmaf(t27, t25, fmaf(t26, t14, light.coefficients_0));
        const float t29 = sqrtf(fmaf(t13, t13, t28 * t28));
        const float t30 = light.tau * t28;
        const float t31 = t10 ? fmaf(t13, t13, t30 * t30) : 1.0f;
        const float t32 = t10 ? fmaf(light.kappa, t28, t29) * fmaf(light.cut, t28, t29) : light.crescent_share;
        const float t33 = (t10 ? light.width : t8) / t32;
        const float t34 = t10 ? t33 : light.width;
        const float t35 = t31 * t34;
        const float t36 = t35 * t35;
        const float t37 = fmaf(fmaf(fmaf(-0.00060778117f, t36, -0.0027203285f), t36, -0.10000902f), t35, fmaf(fmaf(1.0676054e-5f, t36, -0.011332183f), t36, 1.0000001f));
        t21 = t10 ? t30 : t25;
        t22 = t10 ? t8 : spherecap_min(spherecap_max(t33, 5.9604645e-8f), 0.99999994f);
        t23 = t34 * t37;
        t24 = t31;
    }
    const float t38 = spherecap_float_of_bits(fmaf(spherecap_bits(t22), -0.33333334f, 1419900500.0f));
    const float t39 = fmaf(-(t22 * t38), t38 * t38, 1.0f);
    const float t40 = t39 * t39;
    const float t41 = fmaf(fmaf(fmaf(0.110958695f, t40, 0.14403293f), t40, 0.22222222f), t39, fmaf(fmaf(0.12482853f, t40, 0.17283951f), t40, 0.33333334f));
    const float t42 = t23 * (t22 * fmaf(t38, t39 * t41, t38));
    const float t43 = t42 * t24;
    const float t44 = t43 * t43;
    const float t45 = fmaf(fmaf(fmaf(-0.063446075f, t44, -0.056249518f), t44, 0.0074712755f), t44, 0.09996679f);
    const float t46 = fmaf(fmaf(fmaf(0.022114987f, t44, 0.085662976f), t44, 0.030445365f), t44, 0.03209764f);
    const float t47 = t42 * fmaf(t45, t43, fmaf(t46, t44, 1.0000004f));
    const float t48 = t11 ? spherecap_min(t47, 1.0f) : t47;
    const float t49 = t24 * t48;
    const float t50 = 2.0f - t49;
    const float t51 = t48 * t50;
    const float t52 = sqrtf(t51);
    float t53 = 0.0f;
    float t54 = 0.0f;
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t11) {
        const float t55 = t19 - t20 < 0.0f ? t49 : t50;
        const float t56 = t51 * t14;
        float t57 = 0.0f;
        float t58 = 0.0f;
        float t59 = 0.0f;
        float t60 = 0.0f;
        float t61 = 0.0f;
        if (t5) {
            const float t62 = light.height * (1.0f - t56);
            const float t63 = sqrtf(light.height * (2.0f - t62));
            const float t64 = (t55 - 1.0f) * t63;
            const float t65 = 1.0f - t62;
            const float t66 = fmaf(light.elevation_sin, t65, light.elevation_cos * t64);
            t57 = fmaf(light.elevation_cos, t65, -(light.elevation_sin * t64));
            t58 = t66;
            t59 = t64;
            t60 = t52 * t13 * t63;
            t61 = t66 * light.on_surface;
        } else {
            const float t67 = 1.0f - t55;
            const float t68 = spherecap_max(fmaf(light.climb, t55, -light.rise), 0.0f);
            const float t69 = sqrtf(fmaf(t68, t68, light.radius_sin * light.radius_sin * t56));
            const float t70 = t1 * light.radius_cos;
            const float t71 = fmaf(light.elevation_cos * t67, fmaf(light.climb, t67, -2.0f * t70), light.radius_sin * t56);
            const float t72 = light.radius_sin * fmaf(light.elevation_cos, t71 / (t69 + t70), -(t1 * t1 * t67));
            t57 = fmaf(light.half_axis, t67, light.middle);
            t58 = t69;
            t59 = t72;
            t60 = light.radius_sin * t52 * t13;
            t61 = t69;
        }
        t53 = t57;
        t54 = t58;
        zenith = t59;
        side = t60;
        cosine = t61;
    } else {
        const float t73 = t52 * t21;
        const float t74 = 1.0f - t49;
        t53 = t74;
        t54 = t73;
        zenith = fmaf(light.elevation_cos, t73, -((t10 ? -t1 : t1) * t74));
        side = t52 * t13;
        cosine = t73;
    }
    const float t75 = spherecap_min(fabsf(cosine), 3.4028235e38f);
    const float t76 = 0.0f < cosine ? light.inv_above : 0.0f;
    const float t77 = light.defensive_share * light.inv_solid_angle;
    const float t78 = fmaf(t76, t6, spherecap_min(t77 / spherecap_max(t75, 1.1754944e-38f), 3.4028235e38f));
    const float t79 = fmaf(zenith, zenith, side * side);
    const float t80 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t79), 0.0f);
    const float t81 = sqrtf(t80);
    const float t82 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t80));
    const float t83 = light.radius_cos * light.radius_cos / (t82 + t81);
    const float t84 = 1.0f / light.radius_sin;
    const float t85 = t83 * t84;
    const float t86 = -fmaf(t82, t81, t79) * t84;
    const float t87 = t85 * zenith;
    const float t88 = t85 * side;
    const float t89 = fmaf(light.third_axis.x, t53, fmaf(light.sideways.x, side, light.up.x * t54));
    const float t90 = fmaf(light.third_axis.y, t53, fmaf(light.sideways.y, side, light.up.y * t54));
    const float t91 = fmaf(light.third_axis.z, t53, fmaf(light.sideways.z, side, light.up.z * t54));
    const float t92 = fmaf(light.elevation_cos, t86, -(light.elevation_sin * t87));
    const float t93 = fmaf(light.elevation_sin, t86, light.elevation_cos * t87);
    const float t94 = fmaf(light.third_axis.x, t92, fmaf(light.sideways.x, t88, light.up.x * t93));
    const float t95 = fmaf(light.third_axis.y, t92, fmaf(light.sideways.y, t88, light.up.y * t93));
    const float t96 = fmaf(light.third_axis.z, t92, fmaf(light.sideways.z, t88, light.up.z * t93));
    spherecap_sample sampled;
    sampled.direction = make_float3(t89, t90, t91);
    sampled.distance = t83 * light.distance;
    sampled.normal = make_float3(t94, t95, t96);
    sampled.cosine = cosine;
    sampled.pdf = t2 ? fmaf(t76, t6 * t75, t77) : t76 * t75;
    sampled.projected_pdf = t2 ? spherecap_min(t78, 3.4028235e38f) : t76;
    return sampled;
}

static __device__ inline spherecap_sample spherecap_front_sample_once(float3 normal, float3 centre, float radius, float defensive, float u0, float u1) {
    const spherecap_front_light light = spherecap_front_prepare(normal, centre, radius, defensive);
    return spherecap_front_sample(light, u0, u1);
}

static __device__ inline float spherecap_front_pdf_direction(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    const float t2 = fmaf(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    const float t3 = fmaf(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    const float t4 = fmaf(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    const float t5 = fmaf(light.sideways.x, direction.x, fmaf(light.sideways.y, direction.y, light.sideways.z * direction.z));
    const float t6 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const bool t7 = fmaf(light.towards_centre.x, direction.x, t1) < 0.0f;
    const float t8 = t7 ? 1.0f : fmaf(t2, direction.x, fmaf(t3, direction.y, t4 * direction.z));
    const float t9 = t7 ? 1.0f : t5;
    const float t10 = spherecap_min(fabsf(t6), 3.4028235e38f);
    const float t11 = 0.0f < t6 ? light.inv_above : 0.0f;
    const float t12 = fmaf(t11, (1.0f - light.defensive_share) * t10, light.defensive_share * light.inv_solid_angle);
    const bool t13 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t14 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t15 = (0.998001f <= t14 && t14 <= 1.002001f) ? (t13 ? (0.0f < light.defensive_share ? t12 : t11 * t10) : 0.0f) : 0.0f;
    return t15;
}

static __device__ inline float spherecap_front_pdf_on_sphere(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = spherecap_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light.inv_above : 0.0f;
    const float t4 = fmaf(t3, (1.0f - light.defensive_share) * t2, light.defensive_share * light.inv_solid_angle);
    const float t5 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light.defensive_share ? t4 : t3 * t2) : 0.0f;
    return t6;
}

static __device__ inline float spherecap_front_importance(float3 normal, float3 centre, float radius, float defensive, float strength) {
    const float t1 = fmaf(normal.x, normal.x, fmaf(normal.y, normal.y, normal.z * normal.z)) - 1.0f;
    float t2 = 0.0f;
    float t3 = 0.0f;
    float t4 = 0.0f;
    if (fabsf(t1) <= 4.7683716e-7f) {
        t2 = normal.x;
        t3 = normal.y;
        t4 = normal.z;
    } else {
        const float t5 = spherecap_max(fabsf(normal.x) + fabsf(normal.y) + fabsf(normal.z), 1.1754944e-38f);
        const float t6 = spherecap_power_of_two(spherecap_min(t5, 8.5070587e37f));
        const float t7 = normal.x / t6;
        const float t8 = normal.y / t6;
        const float t9 = normal.z / t6;
        const float t10 = spherecap_max(sqrtf(fmaf(t7, t7, fmaf(t8, t8, t9 * t9))), 1.1754944e-38f);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    const float t11 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t12 = centre.x * scale;
    const float t13 = centre.y * scale;
    const float t14 = centre.z * scale;
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
    const float t25 = fmaf(t18 - t23, spherecap_max(fmaf(-t19, t19, 0.9999981f), 0.0f), t24) * 2.0f;
    const float t26 = t18 <= t23 ? t23 : 0.0f < t24 ? t24 * t24 / t25 : 0.0f;
    const float t27 = t20 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t26, t26);
    const bool t28 = t19 <= 1.0000019f && 4.9303807e-32f < t19 && t21 && 0.0f < strength && strength <= 3.4028235e38f;
    const float t29 = spherecap_min(spherecap_max(t19 * t27 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (t28 && (0.0f < t27 || 0.0f < defensive)) ? t29 : 0.0f;
}


// The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.
struct spherecap_both_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    float3 towards_centre;
    float3 sideways;
    float3 normal;
    float3 up;
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
    float3 third_axis;
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
};

static __device__ inline spherecap_both_light spherecap_both_prepare(float3 normal, float3 centre, float radius, float defensive) {
    const float t1 = fmaf(normal.x, normal.x, fmaf(normal.y, normal.y, normal.z * normal.z)) - 1.0f;
    float normal_x = 0.0f;
    float normal_y = 0.0f;
    float normal_z = 0.0f;
    if (fabsf(t1) <= 4.7683716e-7f) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        const float t2 = spherecap_max(fabsf(normal.x) + fabsf(normal.y) + fabsf(normal.z), 1.1754944e-38f);
        const float t3 = spherecap_power_of_two(spherecap_min(t2, 8.5070587e37f));
        const float t4 = normal.x / t3;
        const float t5 = normal.y / t3;
        const float t6 = normal.z / t3;
        const float t7 = spherecap_max(sqrtf(fmaf(t4, t4, fmaf(t5, t5, t6 * t6))), 1.1754944e-38f);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    const float t8 = fmaf(normal_x, normal_x, fmaf(normal_y, normal_y, normal_z * normal_z));
    const bool t9 = fmaf(centre.x, centre.x, fmaf(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0f;
    const bool t10 = t9 && 9.536743e-7f < radius;
    const float t11 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t12 = t10 ? centre.x : centre.x * scale;
    const float t13 = t10 ? centre.y : centre.y * scale;
    const float t14 = t10 ? centre.z : centre.z * scale;
    const float t15 = t10 ? radius : radius * scale;
    const float t16 = __fmul_rn(t14, t14);
    const float t17 = fmaf(t12, t12, fmaf(t13, t13, t16));
    const float t18 = fmaf(-t15, t15, t17);
    float t19 = 0.0f;
    float t20 = 0.0f;
    if (t18 < t17 * 0.25f) {
        const float t21 = __fmul_rn(t12, t12);
        const float t22 = __fmul_rn(t13, t13);
        const float t23 = __fadd_rn(t21, t22);
        const float t24 = __fsub_rn(t23, t21);
        const float t25 = __fadd_rn(t23, t16);
        const float t26 = __fsub_rn(t25, t23);
        const float t27 = spherecap_lost(t12, t12, t21) + spherecap_lost(t13, t13, t22) + spherecap_lost(t14, t14, t16);
        const float t28 = __fsub_rn(t21, __fsub_rn(t23, t24)) + __fsub_rn(t22, t24) + (__fsub_rn(t23, __fsub_rn(t25, t26)) + __fsub_rn(t16, t26));
        t19 = t25;
        t20 = fmaf(-t15, t15, t25) + (t27 + t28);
    } else {
        t19 = t17;
        t20 = t18;
    }
    const bool t29 = 0.0f < t8;
    const float t30 = __fmul_rn(normal_z, t13);
    const float t31 = fmaf(normal_y, t14, -t30);
    const float t32 = __fmul_rn(normal_x, t14);
    const float t33 = fmaf(normal_z, t12, -t32);
    const float t34 = __fmul_rn(normal_y, t12);
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
        const float t42 = t31 - spherecap_lost(normal_z, t13, t30);
        const float t43 = t33 - spherecap_lost(normal_x, t14, t32);
        const float t44 = t35 - spherecap_lost(normal_y, t12, t34);
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
    const float t56 = __fmul_rn(normal_x, t12);
    const float t57 = __fmul_rn(normal_y, t13);
    const float t58 = __fmul_rn(normal_z, t14);
    const float t59 = __fadd_rn(t56, t57);
    const float t60 = __fsub_rn(t59, t56);
    const float t61 = __fadd_rn(t59, t58);
    const float t62 = __fsub_rn(t61, t59);
    const float t63 = spherecap_lost(normal_x, t12, t56) + spherecap_lost(normal_y, t13, t57) + spherecap_lost(normal_z, t14, t58);
    const float t64 = __fsub_rn(t56, __fsub_rn(t59, t60)) + __fsub_rn(t57, t60) + (__fsub_rn(t59, __fsub_rn(t61, t62)) + __fsub_rn(t58, t62));
    const float t65 = t63 + t64;
    const float t66 = __fadd_rn(t61, t65);
    const float t67 = __fsub_rn(t65, __fsub_rn(t66, t61));
    const float t68 = t15 - t66 - t67;
    const float t69 = t15 + t66 + t67;
    const float t70 = t68 * t69;
    const float t71 = sqrtf(t20);
    const bool t72 = 0.0f < t20;
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
    float t73 = 0.0f;
    if (0.0f < t70 && t29 && t72) {
        const float t74 = sqrtf(t20 + t70);
        const float t75 = sqrtf(t70);
        const float t76 = 1.0f / (t74 * t15);
        const float t77 = t76 * t15;
        const float t78 = t76 * t74;
        const float t79 = t71 * t77;
        const float t80 = t75 * t77;
        const float t81 = t80 * t80;
        const float t82 = fabsf(t66) * t78;
        const float t83 = t82 * t79;
        const float t84 = t79 - 0.5f;
        const float t85 = t83 - 0.5f;
        const float t86 = t84 * t84;
        const float t87 = t85 * t85;
        const float t88 = fmaf(0.05430631f, t86, 0.080950715f);
        const float t89 = fmaf(t88, t86, 0.1684019f);
        const float t90 = fmaf(t89, t86, 0.32709444f);
        const float t91 = fmaf(t90, t86, 0.5987523f);
        const float t92 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t87, t88), t87, t89), t87, t90), t87, t91);
        const float t93 = fmaf(-0.026061837f, t86, -0.06372378f);
        const float t94 = fmaf(t93, t86, -0.11762552f);
        const float t95 = fmaf(t94, t86, -0.23594604f);
        const float t96 = fmaf(t95, t86, -0.44721135f);
        const float t97 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t87, t93), t87, t94), t87, t95), t87, t96);
        const float t98 = fmaf(t96, t86, -0.7754678f);
        const float t99 = fmaf(t98, t84, fmaf(t91, t86, 0.94559944f));
        const float t100 = fmaf(fmaf(t85, t97, t92), t84 + t85, t98);
        const float t101 = fmaf(t83, t100, t99);
        t_x = t79;
        t_y = t80;
        width = t81 / (1.0f + t79);
        kappa = t82;
        cut = t83;
        shape = t99;
        shape_difference = t100;
        norm = t101;
        tau = t75 * t78;
        area = t81 * t80 * (spherecap_min(t68, t69) * t78) * t101;
        t73 = t74;
    } else {
        t73 = t41;
    }
    const float t102 = sqrtf(t19);
    const float t103 = 1.0f / t102;
    const float radius_sin = t15 * t103;
    const float radius_cos = t71 * t103;
    const float elevation_sin = t66 * t103;
    const float elevation_cos = t73 * t103;
    const float t104 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t70 * (t103 * t103) / fmaf(radius_cos, t104, climb), -(radius_cos * t104));
    const float t105 = radius_sin * radius_sin;
    const float t106 = fmaf(t105 * t104, 3.1415927f, area);
    const bool t107 = 0.0f < elevation_sin;
    const float t108 = t107 ? t106 : area;
    const float t109 = t107 ? area : t106;
    const bool t110 = 9.8607613e-32f < t105;
    const bool t111 = t110 && t72;
    const float t112 = 1.0f / t40;
    const float sideways_x = t37 * t112;
    const float sideways_y = t38 * t112;
    const float sideways_z = t39 * t112;
    const float on_surface = t29 ? 1.0f : 0.0f;
    const float distance = t102 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t108 && t111) ? t108 : 0.0f;
    const float projected_below = (9.403955e-38f < t109 && t111) ? t109 : 0.0f;
    const bool t113 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float inv_below = 0.0f < projected_below ? 1.0f / projected_below : 0.0f;
    const bool t114 = 0.0f < inv_above + inv_below;
    const float t115 = t107 ? inv_above : inv_below;
    const float defensive_share = t114 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t116 = t113 && 0.0f < t115;
    const float t117 = t_y * t_y * t_y * shape * t115;
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
    if (t113) {
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
        const float t165 = spherecap_max(t149 * tau * (radius_cos + 1.0f) * t164 * 0.31830987f, 0.0f);
        coefficients_0 = t125;
        coefficients_1 = t132 - t125 + t138;
        coefficients_2 = t141 - t138;
        coefficients_3 = t144 - t141;
        coefficients_4 = t146 - t144;
        coefficients_5 = t147 - t146;
        coefficients_6 = -t147;
        t120 = spherecap_min(t165, 0.5f);
    }
    const bool t166 = 0.0f < defensive_share;
    const float t167 = (t110 && 0.0f < radius_cos) ? t105 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t166 ? (0.0f < t167 ? 0.15915494f / t167 : 0.0f) : 0.0f;
    const float sides_share = 0.0f < inv_below ? (0.0f < inv_above ? (t107 ? 1.0f - t120 : t120) : 0.0f) : 1.0f;
    const bool t168 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t114 || (t166 && 0.0f < inv_solid_angle));
    spherecap_both_light light;
    light.is_sampled = t168;
    light.solid_angle = t168 ? t167 * 6.2831855f : 0.0f;
    light.projected_solid_angle = t168 ? projected_above : 0.0f;
    light.towards_centre = make_float3(t12 * t103, t13 * t103, t14 * t103);
    light.sideways = make_float3(sideways_x, sideways_y, sideways_z);
    light.normal = make_float3(normal_x, normal_y, normal_z);
    light.up = make_float3(up_x, up_y, up_z);
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
    light.third_axis = make_float3(fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x)));
    light.height = t166 ? t167 : 0.0f;
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = t116 ? t117 : 0.0f;
    light.inv_rest = t116 ? 1.0f / (1.0f - t117) : 1.0f;
    light.beyond = t116 ? t118 * t118 * t118 * t119 : 0.0f;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t104;
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

static __device__ inline spherecap_sample spherecap_both_sample(spherecap_both_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = fabsf(light.elevation_sin);
    const bool t2 = 0.0f < light.elevation_sin;
    const bool t3 = 0.0f < light.defensive_share;
    const float t4 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = t3 && t4 < light.defensive_share;
    const float t7 = 1.0f - light.defensive_share;
    const float t8 = (t6 ? t4 : t4 - light.defensive_share) / (t6 ? light.defensive_share : t7);
    const float t9 = 0.0f < light.requested ? spherecap_min(spherecap_max(t8, 5.9604645e-8f), 0.99999994f) : t4;
    const bool t10 = t6 || t9 < light.sides_share;
    const float t11 = 1.0f - light.sides_share;
    const float t12 = spherecap_max((t10 ? t9 : t9 - light.sides_share) / (t10 ? light.sides_share : t11), 5.9604645e-8f);
    const float t13 = t6 ? t9 : spherecap_min(t12, 0.99999994f);
    const bool t14 = t6 || !(0.0f < light.tau);
    const bool t15 = !t14 && !((t10 && t2) || (!t10 && !t2));
    const bool t16 = t14 || (!t15 && light.crescent_share <= t13);
    const float t17 = 1.0f - t5;
    const float t18 = t5 - t17;
    const float t19 = 4.0f * t5 * t17;
    const float t20 = spherecap_max((t13 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t21 = t14 ? t13 : spherecap_min(t20, 0.99999994f);
    const float t22 = t14 ? 0.0f : light.beyond;
    const float t23 = 3.1415927f - t22;
    const float t24 = fmaf(t21, t23, t22);
    const float t25 = (1.0f - t21) * t23;
    float t26 = 0.0f;
    float t27 = 0.0f;
    float t28 = 0.0f;
    float t29 = 0.0f;
    if (t16) {
        t27 = spherecap_min(t24, t25) * 0.53033006f;
        t28 = 1.0f;
        t29 = 1.0f;
    } else {
        const float t30 = sqrtf(t19);
        const float t31 = fmaf(fmaf(light.coefficients_6, t19, light.coefficients_4), t19, light.coefficients_2);
        const float t32 = fmaf(fmaf(light.coefficients_5, t19, light.coefficients_3), t19, light.coefficients_1);
        const float t33 = t30 * fmaf(t32, t30, fmaf(t31, t19, light.coefficients_0));
        const float t34 = sqrtf(fmaf(t18, t18, t33 * t33));
        const float t35 = light.tau * t33;
        const float t36 = t15 ? fmaf(t18, t18, t35 * t35) : 1.0f;
        const float t37 = t15 ? fmaf(light.kappa, t33, t34) * fmaf(light.cut, t33, t34) : light.crescent_share;
        const float t38 = (t15 ? light.width : t13) / t37;
        const float t39 = t15 ? t13 : spherecap_min(spherecap_max(t38, 5.9604645e-8f), 0.99999994f);
        const float t40 = t15 ? t38 : light.width;
        const float t41 = t36 * t40;
        const float t42 = t41 * t41;
        const float t43 = fmaf(fmaf(fmaf(-0.00060778117f, t42, -0.0027203285f), t42, -0.10000902f), t41, fmaf(fmaf(1.0676054e-5f, t42, -0.011332183f), t42, 1.0000001f));
        t26 = t15 ? t35 : t30;
        t27 = t39;
        t28 = t40 * t43;
        t29 = t36;
    }
    const float t44 = spherecap_float_of_bits(fmaf(spherecap_bits(t27), -0.33333334f, 1419900500.0f));
    const float t45 = fmaf(-(t27 * t44), t44 * t44, 1.0f);
    const float t46 = t45 * t45;
    const float t47 = fmaf(fmaf(fmaf(0.110958695f, t46, 0.14403293f), t46, 0.22222222f), t45, fmaf(fmaf(0.12482853f, t46, 0.17283951f), t46, 0.33333334f));
    const float t48 = t28 * (t27 * fmaf(t44, t45 * t47, t44));
    const float t49 = t48 * t29;
    const float t50 = t49 * t49;
    const float t51 = fmaf(fmaf(fmaf(-0.063446075f, t50, -0.056249518f), t50, 0.0074712755f), t50, 0.09996679f);
    const float t52 = fmaf(fmaf(fmaf(0.022114987f, t50, 0.085662976f), t50, 0.030445365f), t50, 0.03209764f);
    const float t53 = t48 * fmaf(t51, t49, fmaf(t52, t50, 1.0000004f));
    const float t54 = t16 ? spherecap_min(t53, 1.0f) : t53;
    const float t55 = t29 * t54;
    const float t56 = 2.0f - t55;
    const float t57 = t54 * t56;
    const float t58 = sqrtf(t57);
    float t59 = 0.0f;
    float t60 = 0.0f;
    float t61 = 0.0f;
    float side = 0.0f;
    float t62 = 0.0f;
    if (t16) {
        const float t63 = t24 - t25 < 0.0f ? t55 : t56;
        const float t64 = t57 * t19;
        float t65 = 0.0f;
        float t66 = 0.0f;
        float t67 = 0.0f;
        float t68 = 0.0f;
        float t69 = 0.0f;
        if (t6) {
            const float t70 = light.height * (1.0f - t64);
            const float t71 = sqrtf(light.height * (2.0f - t70));
            const float t72 = (t63 - 1.0f) * t71;
            const float t73 = 1.0f - t70;
            const float t74 = fmaf(light.elevation_sin, t73, light.elevation_cos * t72);
            t65 = fmaf(light.elevation_cos, t73, -(light.elevation_sin * t72));
            t66 = t74;
            t67 = t72;
            t68 = t58 * t18 * t71;
            t69 = t74 * light.on_surface;
        } else {
            const float t75 = 1.0f - t63;
            const float t76 = spherecap_max(fmaf(light.climb, t63, -light.rise), 0.0f);
            const float t77 = sqrtf(fmaf(t76, t76, light.radius_sin * light.radius_sin * t64));
            const float t78 = t1 * light.radius_cos;
            const float t79 = fmaf(light.elevation_cos * t75, fmaf(light.climb, t75, -2.0f * t78), light.radius_sin * t64);
            const float t80 = light.radius_sin * fmaf(light.elevation_cos, t79 / (t77 + t78), -(t1 * t1 * t75));
            t65 = fmaf(light.half_axis, t75, light.middle);
            t66 = t77;
            t67 = t80;
            t68 = light.radius_sin * t58 * t18;
            t69 = t77;
        }
        t59 = t65;
        t60 = t66;
        t61 = t67;
        side = t68;
        t62 = t69;
    } else {
        const float t81 = t58 * t26;
        const float t82 = 1.0f - t55;
        t59 = t82;
        t60 = t81;
        t61 = fmaf(light.elevation_cos, t81, -((t15 ? -t1 : t1) * t82));
        side = t58 * t18;
        t62 = t81;
    }
    const float t83 = t10 ? 1.0f : -1.0f;
    const float zenith = t61 * t83;
    const float cosine = t62 * t83;
    const float t84 = t60 * t83;
    const float t85 = spherecap_min(fabsf(cosine), 3.4028235e38f);
    const float t86 = 0.0f < cosine ? light.inv_above * light.sides_share : cosine < 0.0f ? light.inv_below * t11 : 0.0f;
    const float t87 = light.defensive_share * light.inv_solid_angle;
    const float t88 = fmaf(t86, t7, spherecap_min(t87 / spherecap_max(t85, 1.1754944e-38f), 3.4028235e38f));
    const float t89 = fmaf(zenith, zenith, side * side);
    const float t90 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t89), 0.0f);
    const float t91 = sqrtf(t90);
    const float t92 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t90));
    const float t93 = light.radius_cos * light.radius_cos / (t92 + t91);
    const float t94 = 1.0f / light.radius_sin;
    const float t95 = t93 * t94;
    const float t96 = -fmaf(t92, t91, t89) * t94;
    const float t97 = t95 * zenith;
    const float t98 = t95 * side;
    const float t99 = fmaf(light.third_axis.x, t59, fmaf(light.sideways.x, side, light.up.x * t84));
    const float t100 = fmaf(light.third_axis.y, t59, fmaf(light.sideways.y, side, light.up.y * t84));
    const float t101 = fmaf(light.third_axis.z, t59, fmaf(light.sideways.z, side, light.up.z * t84));
    const float t102 = fmaf(light.elevation_cos, t96, -(light.elevation_sin * t97));
    const float t103 = fmaf(light.elevation_sin, t96, light.elevation_cos * t97);
    const float t104 = fmaf(light.third_axis.x, t102, fmaf(light.sideways.x, t98, light.up.x * t103));
    const float t105 = fmaf(light.third_axis.y, t102, fmaf(light.sideways.y, t98, light.up.y * t103));
    const float t106 = fmaf(light.third_axis.z, t102, fmaf(light.sideways.z, t98, light.up.z * t103));
    spherecap_sample sampled;
    sampled.direction = make_float3(t99, t100, t101);
    sampled.distance = t93 * light.distance;
    sampled.normal = make_float3(t104, t105, t106);
    sampled.cosine = cosine;
    sampled.pdf = t3 ? fmaf(t86, t7 * t85, t87) : t86 * t85;
    sampled.projected_pdf = t3 ? spherecap_min(t88, 3.4028235e38f) : t86;
    return sampled;
}

static __device__ inline spherecap_sample spherecap_both_sample_once(float3 normal, float3 centre, float radius, float defensive, float u0, float u1) {
    const spherecap_both_light light = spherecap_both_prepare(normal, centre, radius, defensive);
    return spherecap_both_sample(light, u0, u1);
}

static __device__ inline float spherecap_both_pdf_direction(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    const float t2 = fmaf(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    const float t3 = fmaf(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    const float t4 = fmaf(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    const float t5 = fmaf(light.sideways.x, direction.x, fmaf(light.sideways.y, direction.y, light.sideways.z * direction.z));
    const float t6 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const bool t7 = fmaf(light.towards_centre.x, direction.x, t1) < 0.0f;
    const float t8 = t7 ? 1.0f : fmaf(t2, direction.x, fmaf(t3, direction.y, t4 * direction.z));
    const float t9 = t7 ? 1.0f : t5;
    const float t10 = spherecap_min(fabsf(t6), 3.4028235e38f);
    const float t11 = 0.0f < t6 ? light.inv_above * light.sides_share : t6 < 0.0f ? light.inv_below * (1.0f - light.sides_share) : 0.0f;
    const float t12 = fmaf(t11, (1.0f - light.defensive_share) * t10, light.defensive_share * light.inv_solid_angle);
    const bool t13 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t14 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t15 = (0.998001f <= t14 && t14 <= 1.002001f) ? (t13 ? (0.0f < light.defensive_share ? t12 : t11 * t10) : 0.0f) : 0.0f;
    return t15;
}

static __device__ inline float spherecap_both_pdf_on_sphere(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = spherecap_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light.inv_above * light.sides_share : t1 < 0.0f ? light.inv_below * (1.0f - light.sides_share) : 0.0f;
    const float t4 = fmaf(t3, (1.0f - light.defensive_share) * t2, light.defensive_share * light.inv_solid_angle);
    const float t5 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light.defensive_share ? t4 : t3 * t2) : 0.0f;
    return t6;
}

static __device__ inline float spherecap_both_importance(float3 normal, float3 centre, float radius, float defensive, float strength) {
    const float t1 = fmaf(normal.x, normal.x, fmaf(normal.y, normal.y, normal.z * normal.z)) - 1.0f;
    float t2 = 0.0f;
    float t3 = 0.0f;
    float t4 = 0.0f;
    if (fabsf(t1) <= 4.7683716e-7f) {
        t2 = normal.x;
        t3 = normal.y;
        t4 = normal.z;
    } else {
        const float t5 = spherecap_max(fabsf(normal.x) + fabsf(normal.y) + fabsf(normal.z), 1.1754944e-38f);
        const float t6 = spherecap_power_of_two(spherecap_min(t5, 8.5070587e37f));
        const float t7 = normal.x / t6;
        const float t8 = normal.y / t6;
        const float t9 = normal.z / t6;
        const float t10 = spherecap_max(sqrtf(fmaf(t7, t7, fmaf(t8, t8, t9 * t9))), 1.1754944e-38f);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    const float t11 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t12 = centre.x * scale;
    const float t13 = centre.y * scale;
    const float t14 = centre.z * scale;
    const float t15 = radius * scale;
    const float t16 = sqrtf(fmaf(t12, t12, fmaf(t13, t13, t14 * t14)));
    const float t17 = 1.0f / t16;
    const float t18 = t15 * t17;
    const float t19 = t18 * t18;
    const float t20 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t21 = 0.0f <= defensive && defensive <= 1.0f && t20 <= 2.0f && 0.0f < radius && t16 * unscale <= 3.4028235e38f;
    const float t22 = fmaf(t2, t12, fmaf(t3, t13, t4 * t14));
    const float t23 = spherecap_max(fmaf(-t19, t19, 0.9999981f), 0.0f);
    const float t24 = fmaf(t22, t17, 2.3841858e-7f);
    const float t25 = fmaf(t22 + t15, t17, 2.3841858e-7f);
    const float t26 = t18 <= t24 ? t24 : 0.0f < t25 ? t25 * t25 / (fmaf(t18 - t24, t23, t25) * 2.0f) : 0.0f;
    const float t27 = fmaf(-t22, t17, 2.3841858e-7f);
    const float t28 = fmaf(-t22 + t15, t17, 2.3841858e-7f);
    const float t29 = t18 <= t27 ? t27 : 0.0f < t28 ? t28 * t28 / (fmaf(t18 - t27, t23, t28) * 2.0f) : 0.0f;
    const float t30 = t26 + t29;
    const float t31 = t20 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t30, t30);
    const bool t32 = t19 <= 1.0000019f && 4.9303807e-32f < t19 && t21 && 0.0f < strength && strength <= 3.4028235e38f;
    const float t33 = spherecap_min(spherecap_max(t19 * t31 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (t32 && (0.0f < t31 || 0.0f < defensive)) ? t33 : 0.0f;
}


#endif
