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
    float3 frame_0;
    float3 frame_1;
    float3 frame_2;
    float3 normal;
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
};

static __device__ inline spherecap_surface_light spherecap_surface_prepare(float3 normal, float3 centre, float radius) {
    const float t1 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t2 = centre.x * scale;
    const float t3 = centre.y * scale;
    const float t4 = centre.z * scale;
    const float t5 = radius * scale;
    const float t6 = __fmul_rn(t2, t2);
    const float t7 = __fmul_rn(t3, t3);
    const float t8 = __fmul_rn(t4, t4);
    const float t9 = __fadd_rn(t6, t7);
    const float t10 = __fsub_rn(t9, t6);
    const float t11 = __fadd_rn(t9, t8);
    const float t12 = __fsub_rn(t11, t9);
    const float t13 = spherecap_lost(t2, t2, t6) + spherecap_lost(t3, t3, t7) + spherecap_lost(t4, t4, t8);
    const float t14 = __fsub_rn(t6, __fsub_rn(t9, t10)) + __fsub_rn(t7, t10) + (__fsub_rn(t9, __fsub_rn(t11, t12)) + __fsub_rn(t8, t12));
    const float t15 = __fmul_rn(t5, t5);
    const float t16 = t11 - t15 + (t13 + t14 - spherecap_lost(t5, t5, t15));
    const bool t17 = 0.0f < t16;
    const float t18 = sqrtf(t11);
    const float t19 = 1.0f / t18;
    const float t20 = __fmul_rn(normal.x, t2);
    const float t21 = __fmul_rn(normal.y, t3);
    const float t22 = __fmul_rn(normal.z, t4);
    const float t23 = __fadd_rn(t20, t21);
    const float t24 = __fsub_rn(t23, t20);
    const float t25 = __fadd_rn(t23, t22);
    const float t26 = __fsub_rn(t25, t23);
    const float t27 = spherecap_lost(normal.x, t2, t20) + spherecap_lost(normal.y, t3, t21) + spherecap_lost(normal.z, t4, t22);
    const float t28 = __fsub_rn(t20, __fsub_rn(t23, t24)) + __fsub_rn(t21, t24) + (__fsub_rn(t23, __fsub_rn(t25, t26)) + __fsub_rn(t22, t26));
    const float t29 = t27 + t28;
    const float t30 = __fadd_rn(t25, t29);
    const float t31 = __fsub_rn(t29, __fsub_rn(t30, t25));
    const float t32 = t5 - t30 - t31;
    const float t33 = t5 + t30 + t31;
    const float t34 = t32 * t33;
    const bool t35 = 0.0f < t34 && t17;
    const float t36 = __fmul_rn(normal.z, t3);
    const float t37 = fmaf(normal.y, t4, -t36) - spherecap_lost(normal.z, t3, t36);
    const float t38 = __fmul_rn(normal.x, t4);
    const float t39 = fmaf(normal.z, t2, -t38) - spherecap_lost(normal.x, t4, t38);
    const float t40 = __fmul_rn(normal.y, t2);
    const float t41 = fmaf(normal.x, t3, -t40) - spherecap_lost(normal.y, t2, t40);
    const float t42 = fmaf(t37, t37, fmaf(t39, t39, t41 * t41));
    const bool t43 = 9.8607613e-32f < t42;
    const bool t44 = fabsf(t2) < fabsf(t4);
    const float t45 = t44 ? 0.0f : -t3;
    const float t46 = t44 ? -t4 : t2;
    const float t47 = t44 ? t3 : 0.0f;
    const float t48 = sqrtf(spherecap_max(t16, 0.0f));
    const float radius_cos = t48 * t19;
    const float t49 = 1.0f + radius_cos;
    const float t50 = 1.0f / (t5 * t49);
    const float t51 = t50 * t49;
    const float radius_sin = t5 * t19;
    const float inv_radius_sin = t18 * t51;
    const float t52 = sqrtf(t16 + t34);
    const float t53 = sqrtf(t43 ? t42 : fmaf(t45, t45, fmaf(t46, t46, t47 * t47)));
    const float elevation_sin = t30 * t19;
    const float elevation_cos = (t35 ? t52 : t43 ? t53 : 0.0f) * t19;
    const float t54 = fabsf(elevation_sin);
    const float t55 = radius_sin * elevation_cos;
    const float t56 = spherecap_max(fmaf(radius_cos, t54, t55), 9.8607613e-32f);
    const float t57 = 1.0f / (t56 * t53);
    const float t58 = t57 * t53;
    const float t59 = t57 * t56;
    const float frame_2_x = (t43 ? t37 : t45) * t59;
    const float frame_2_y = (t43 ? t39 : t46) * t59;
    const float frame_2_z = (t43 ? t41 : t47) * t59;
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
    if (t35) {
        const float t60 = sqrtf(t34);
        const float t61 = t52 + t48;
        const float t62 = 1.0f / (t52 * t61);
        const float t63 = t62 * t61;
        const float t64 = t48 * t63;
        const float t65 = t60 * t63;
        const float t66 = fabsf(t30) * t51;
        const float t67 = t66 * t64;
        const float t68 = t64 - 0.5f;
        const float t69 = t67 - 0.5f;
        const float t70 = t68 * t68;
        const float t71 = t69 * t69;
        const float t72 = fmaf(0.05430631f, t70, 0.080950715f);
        const float t73 = fmaf(t72, t70, 0.1684019f);
        const float t74 = fmaf(t73, t70, 0.32709444f);
        const float t75 = fmaf(t74, t70, 0.5987523f);
        const float t76 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t71, t72), t71, t73), t71, t74), t71, t75);
        const float t77 = fmaf(-0.026061837f, t70, -0.06372378f);
        const float t78 = fmaf(t77, t70, -0.11762552f);
        const float t79 = fmaf(t78, t70, -0.23594604f);
        const float t80 = fmaf(t79, t70, -0.44721135f);
        const float t81 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t71, t77), t71, t78), t71, t79), t71, t80);
        const float t82 = fmaf(t80, t70, -0.7754678f);
        const float t83 = fmaf(t82, t68, fmaf(t75, t70, 0.94559944f));
        const float t84 = fmaf(fmaf(t69, t81, t76), t68 + t69, t82);
        const float t85 = fmaf(t67, t84, t83);
        t_x = t64;
        t_y = t65;
        kappa = t66;
        cut = t67;
        shape = t83;
        shape_cut = fmaf(t67 - t64, t84, t83);
        norm = t85;
        width = t34 * t62;
        inv_cut_1 = t55 * t58;
        tau = t60 * t51;
        area = t65 * t65 * t65 * (spherecap_min(t32, t33) * t51) * t85;
    }
    const float t86 = radius_sin * radius_sin;
    const float t87 = elevation_sin < 0.0f ? area : t86 * t54 * 3.1415927f + area;
    const bool t88 = t17 && 9.8607613e-32f < t86;
    const float distance = t18 * unscale;
    const float projected_above = (9.403955e-38f < t87 && t88) ? t87 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t89 = 0.0f < elevation_sin;
    const float t90 = t89 ? inv_above : 0.0f;
    const bool t91 = 0.0f < tau;
    const bool t92 = t89 && t91 && 0.0f < t90;
    const float t93 = t_y * t_y * t_y * shape * t90;
    const float t94 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (!t89 && t91) {
        const float t95 = 1.0f + kappa;
        const float t96 = t95 * shape;
        const float t97 = 1.0f / (norm * t96);
        const float t98 = sqrtf(t97);
        const float t99 = norm * t98;
        const float t100 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t101 = t100 * t100;
        const float t102 = fmaf(fmaf(fmaf(-0.026061837f, t101, -0.06372378f), t101, -0.11762552f), t101, -0.23594604f);
        const float t103 = fmaf(fmaf(fmaf(0.05430631f, t101, 0.080950715f), t101, 0.1684019f), t101, 0.32709444f);
        const float t104 = fmaf(fmaf(fmaf(t102, t101, -0.44721135f), t101, -0.7754678f), t100, fmaf(fmaf(t103, t101, 0.5987523f), t101, 0.94559944f));
        const float t105 = t95 * t104 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t96 * t97);
        const float t106 = fmaf(t105, t96 * t98, -1.0f);
        const float t107 = 1.0f - t105;
        const float t108 = fmaf(fmaf(30.011856f, t106, fmaf(-41.541264f, t107, -37.009792f)), t106, fmaf(77.96775f, t107, 7.470758f));
        const float t109 = fmaf(t108, t106, fmaf(fmaf(-49.13454f, t107, -9.466533f), t107, -1.5877596f));
        const float t110 = fmaf(fmaf(fmaf(15.716111f, t107, 0.0f), t107, 9.961183f), t107, -2.61785f);
        const float t111 = t106 * fmaf(t109, t106, fmaf(t110, t107, 0.8681748f));
        const float t112 = fmaf(fmaf(7.295638f, t106, -7.236236f), t106, fmaf(fmaf(fmaf(-11.4868555f, t107, 0.0f), t107, 0.0f), t107, 3.1255686f));
        const float t113 = fmaf(fmaf(fmaf(13.728438f, t107, -7.981878f), t107, 2.025724f), t107, -0.7334958f);
        const float t114 = t106 * fmaf(t112, t106, t113);
        const float t115 = fmaf(fmaf(fmaf(9.986537f, t107, 25.22195f), t107, 0.0f), t107, -2.9581387f);
        const float t116 = fmaf(fmaf(fmaf(-19.722994f, t107, 4.6594768f), t107, -0.89538246f), t107, 0.5143498f);
        const float t117 = t106 * fmaf(fmaf(fmaf(-23.220068f, t107, 7.332055f), t106, t115), t106, t116);
        const float t118 = fmaf(fmaf(fmaf(1.946617f, t106, -3.077631f), t106, 1.4945927f), t106, -0.24140751f);
        const float t119 = t106 * t118;
        const float t120 = t106 * fmaf(fmaf(0.38173297f, t106, -0.30305624f), t106, 0.05897375f);
        coefficients_0 = t99;
        coefficients_1 = t105 - t99 + t111;
        coefficients_2 = t114 - t111;
        coefficients_3 = t117 - t114;
        coefficients_4 = t119 - t117;
        coefficients_5 = t120 - t119;
        coefficients_6 = -t120;
    }
    const bool t121 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    spherecap_surface_light light;
    light.is_sampled = t121;
    light.solid_angle = t121 ? (t88 ? t86 * (t50 * t5) * 6.2831855f : 0.0f) : 0.0f;
    light.projected_solid_angle = t121 ? projected_above : 0.0f;
    light.frame_0 = make_float3(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = make_float3(fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = make_float3(frame_2_x, frame_2_y, frame_2_z);
    light.normal = make_float3(normal.x, normal.y, normal.z);
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
    light.rise = spherecap_max(t34 * (t19 * t19) * t58, -(radius_cos * t54));
    light.inv_above = inv_above;
    light.crescent_share = t92 ? t93 : 0.0f;
    light.inv_rest = t92 ? 1.0f / (1.0f - t93) : 1.0f;
    light.beyond = t92 ? t94 * t94 * t94 * shape_cut : 0.0f;
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
    const bool t2 = 0.0f < light.elevation_sin;
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t2 && light.crescent_share <= t3;
    const float t6 = 1.0f - t4;
    const float t7 = t4 - t6;
    const float t8 = 4.0f * t4 * t6;
    float t9 = 0.0f;
    float t10 = 0.0f;
    float t11 = 0.0f;
    float t12 = 0.0f;
    if (t5) {
        const float t13 = spherecap_max((t3 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
        const float t14 = spherecap_min(t13, 0.99999994f);
        const float t15 = 3.1415927f - light.beyond;
        const float t16 = fmaf(t14, t15, light.beyond);
        const float t17 = (1.0f - t14) * t15;
        t9 = spherecap_min(t16, t17) * 0.53033006f;
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
            t22 = light.crescent_share;
        } else {
            const float t23 = fmaf(fmaf(light.coefficients_6, t8, light.coefficients_4), t8, light.coefficients_2);
            const float t24 = fmaf(fmaf(light.coefficients_5, t8, light.coefficients_3), t8, light.coefficients_1);
            const float t25 = t18 * fmaf(t24, t18, fmaf(t23, t8, light.coefficients_0));
            const float t26 = sqrtf(fmaf(t7, t7, t25 * t25));
            const float t27 = light.tau * t25;
            t19 = t27;
            t20 = fmaf(t7, t7, t27 * t27);
            t21 = light.width;
            t22 = fmaf(light.kappa, t25, t26) * fmaf(light.cut, t25, t26);
        }
        const float t28 = t21 / t22;
        const float t29 = t2 ? light.width : t28;
        const float t30 = t20 * t29;
        const float t31 = t30 * t30;
        const float t32 = fmaf(fmaf(fmaf(-0.00060778117f, t31, -0.0027203285f), t31, -0.10000902f), t30, fmaf(fmaf(1.0676054e-5f, t31, -0.011332183f), t31, 1.0000001f));
        t9 = t2 ? spherecap_min(spherecap_max(t28, 5.9604645e-8f), 0.99999994f) : t3;
        t10 = t29 * t32;
        t11 = t20;
        t12 = t19;
    }
    const float t33 = spherecap_float_of_bits(fmaf(spherecap_bits(t9), -0.33333334f, 1419900500.0f));
    const float t34 = fmaf(-(t9 * t33), t33 * t33, 1.0f);
    const float t35 = t34 * t34;
    const float t36 = fmaf(fmaf(fmaf(0.110958695f, t35, 0.14403293f), t35, 0.22222222f), t34, fmaf(fmaf(0.12482853f, t35, 0.17283951f), t35, 0.33333334f));
    const float t37 = t10 * (t9 * fmaf(t33, t34 * t36, t33));
    const float t38 = t37 * t11;
    const float t39 = t38 * t38;
    const float t40 = fmaf(fmaf(fmaf(-0.063446075f, t39, -0.056249518f), t39, 0.0074712755f), t39, 0.09996679f);
    const float t41 = fmaf(fmaf(fmaf(0.022114987f, t39, 0.085662976f), t39, 0.030445365f), t39, 0.03209764f);
    const float t42 = t37 * fmaf(t40, t38, fmaf(t41, t39, 1.0000004f));
    const float t43 = t5 ? spherecap_min(t42, 1.0f) : t42;
    const float t44 = t11 * t43;
    const float t45 = 2.0f - t44;
    const float t46 = t43 * t45;
    const float t47 = sqrtf(t46);
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t5) {
        const float t48 = light.radius_sin * light.elevation_cos;
        const float t49 = t12 < 0.0f ? t44 : t45;
        const float t50 = 1.0f - t49;
        const float t51 = t46 * t8;
        const float t52 = spherecap_max(fmaf(t48, t49, -light.rise), 0.0f);
        const float t53 = sqrtf(fmaf(t52, t52, light.radius_sin * light.radius_sin * t51));
        const float t54 = t1 * light.radius_cos;
        const float t55 = fmaf(light.elevation_cos * t50, fmaf(t48, t50, -2.0f * t54), light.radius_sin * t51);
        const float t56 = light.radius_sin * fmaf(light.elevation_cos, t55 / (t53 + t54), -(t1 * t1 * t50));
        zenith = t56;
        side = light.radius_sin * t47 * t7;
        cosine = t53;
    } else {
        const float t57 = t47 * t12;
        zenith = fmaf(light.elevation_cos, t57, -((t2 ? t1 : -t1) * (1.0f - t44)));
        side = t47 * t7;
        cosine = t57;
    }
    const float t58 = 0.0f < cosine ? light.inv_above : 0.0f;
    const float t59 = fmaf(zenith, zenith, side * side);
    const float t60 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t59), 0.0f);
    const float t61 = sqrtf(t60);
    const float t62 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t60));
    const float t63 = light.radius_cos * light.radius_cos / (t62 + t61);
    const float t64 = fmaf(light.frame_0.x, t62, fmaf(light.frame_1.x, zenith, light.frame_2.x * side));
    const float t65 = fmaf(light.frame_0.y, t62, fmaf(light.frame_1.y, zenith, light.frame_2.y * side));
    const float t66 = fmaf(light.frame_0.z, t62, fmaf(light.frame_1.z, zenith, light.frame_2.z * side));
    const float t67 = t63 * light.inv_radius_sin;
    const float t68 = -fmaf(t62, t61, t59) * light.inv_radius_sin;
    const float t69 = t67 * zenith;
    const float t70 = t67 * side;
    const float t71 = fmaf(light.frame_0.x, t68, fmaf(light.frame_1.x, t69, light.frame_2.x * t70));
    const float t72 = fmaf(light.frame_0.y, t68, fmaf(light.frame_1.y, t69, light.frame_2.y * t70));
    const float t73 = fmaf(light.frame_0.z, t68, fmaf(light.frame_1.z, t69, light.frame_2.z * t70));
    spherecap_sample sampled;
    sampled.direction = make_float3(t64, t65, t66);
    sampled.distance = t63 * light.distance;
    sampled.normal = make_float3(t71, t72, t73);
    sampled.cosine = cosine;
    sampled.pdf = t58 * spherecap_min(fabsf(cosine), 3.4028235e38f);
    sampled.projected_pdf = t58;
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
    const float t1 = fmaf(light.frame_0.x, direction.x, fmaf(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    const float t2 = fmaf(light.frame_1.x, direction.x, fmaf(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    const float t3 = fmaf(light.frame_2.x, direction.x, fmaf(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    const float t4 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const bool t5 = t1 < 0.0f;
    const float t6 = t5 ? 1.0f : t2;
    const float t7 = t5 ? 1.0f : t3;
    const float t8 = (0.0f < t4 ? light.inv_above : 0.0f) * spherecap_min(fabsf(t4), 3.4028235e38f);
    const bool t9 = fmaf(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t10 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t10 && t10 <= 1.002001f) ? (t9 ? t8 : 0.0f) : 0.0f;
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
    float3 frame_0;
    float3 frame_1;
    float3 frame_2;
    float3 normal;
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
    const float t9 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t10 = centre.x * scale;
    const float t11 = centre.y * scale;
    const float t12 = centre.z * scale;
    const float t13 = radius * scale;
    const float t14 = __fmul_rn(t10, t10);
    const float t15 = __fmul_rn(t11, t11);
    const float t16 = __fmul_rn(t12, t12);
    const float t17 = __fadd_rn(t14, t15);
    const float t18 = __fsub_rn(t17, t14);
    const float t19 = __fadd_rn(t17, t16);
    const float t20 = __fsub_rn(t19, t17);
    const float t21 = spherecap_lost(t10, t10, t14) + spherecap_lost(t11, t11, t15) + spherecap_lost(t12, t12, t16);
    const float t22 = __fsub_rn(t14, __fsub_rn(t17, t18)) + __fsub_rn(t15, t18) + (__fsub_rn(t17, __fsub_rn(t19, t20)) + __fsub_rn(t16, t20));
    const float t23 = __fmul_rn(t13, t13);
    const float t24 = t19 - t23 + (t21 + t22 - spherecap_lost(t13, t13, t23));
    const bool t25 = 0.0f < t24;
    const float t26 = sqrtf(t19);
    const float t27 = 1.0f / t26;
    const float t28 = __fmul_rn(normal_x, t10);
    const float t29 = __fmul_rn(normal_y, t11);
    const float t30 = __fmul_rn(normal_z, t12);
    const float t31 = __fadd_rn(t28, t29);
    const float t32 = __fsub_rn(t31, t28);
    const float t33 = __fadd_rn(t31, t30);
    const float t34 = __fsub_rn(t33, t31);
    const float t35 = spherecap_lost(normal_x, t10, t28) + spherecap_lost(normal_y, t11, t29) + spherecap_lost(normal_z, t12, t30);
    const float t36 = __fsub_rn(t28, __fsub_rn(t31, t32)) + __fsub_rn(t29, t32) + (__fsub_rn(t31, __fsub_rn(t33, t34)) + __fsub_rn(t30, t34));
    const float t37 = t35 + t36;
    const float t38 = __fadd_rn(t33, t37);
    const float t39 = __fsub_rn(t37, __fsub_rn(t38, t33));
    const float t40 = t13 - t38 - t39;
    const float t41 = t13 + t38 + t39;
    const float t42 = t40 * t41;
    const bool t43 = 0.0f < t8;
    const bool t44 = 0.0f < t42 && t25 && t43;
    const float t45 = __fmul_rn(normal_z, t11);
    const float t46 = fmaf(normal_y, t12, -t45) - spherecap_lost(normal_z, t11, t45);
    const float t47 = __fmul_rn(normal_x, t12);
    const float t48 = fmaf(normal_z, t10, -t47) - spherecap_lost(normal_x, t12, t47);
    const float t49 = __fmul_rn(normal_y, t10);
    const float t50 = fmaf(normal_x, t11, -t49) - spherecap_lost(normal_y, t10, t49);
    const float t51 = fmaf(t46, t46, fmaf(t48, t48, t50 * t50));
    const bool t52 = 9.8607613e-32f < t51;
    const bool t53 = fabsf(t10) < fabsf(t12);
    const float t54 = t53 ? 0.0f : -t11;
    const float t55 = t53 ? -t12 : t10;
    const float t56 = t53 ? t11 : 0.0f;
    const float t57 = sqrtf(spherecap_max(t24, 0.0f));
    const float radius_cos = t57 * t27;
    const float t58 = 1.0f + radius_cos;
    const float t59 = 1.0f / (t13 * t58);
    const float t60 = t59 * t58;
    const float radius_sin = t13 * t27;
    const float inv_radius_sin = t26 * t60;
    const float t61 = sqrtf(t24 + t42);
    const float t62 = sqrtf(t52 ? t51 : fmaf(t54, t54, fmaf(t55, t55, t56 * t56)));
    const float elevation_sin = t38 * t27;
    const float elevation_cos = (t44 ? t61 : t52 ? t62 : 0.0f) * t27;
    const float t63 = fabsf(elevation_sin);
    const float t64 = radius_sin * elevation_cos;
    const float t65 = spherecap_max(fmaf(radius_cos, t63, t64), 9.8607613e-32f);
    const float t66 = 1.0f / (t65 * t62);
    const float t67 = t66 * t62;
    const float t68 = t66 * t65;
    const float frame_2_x = (t52 ? t46 : t54) * t68;
    const float frame_2_y = (t52 ? t48 : t55) * t68;
    const float frame_2_z = (t52 ? t50 : t56) * t68;
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
    if (t44) {
        const float t69 = sqrtf(t42);
        const float t70 = t61 + t57;
        const float t71 = 1.0f / (t61 * t70);
        const float t72 = t71 * t70;
        const float t73 = t57 * t72;
        const float t74 = t69 * t72;
        const float t75 = fabsf(t38) * t60;
        const float t76 = t75 * t73;
        const float t77 = t73 - 0.5f;
        const float t78 = t76 - 0.5f;
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
        const float t92 = fmaf(t91, t77, fmaf(t84, t79, 0.94559944f));
        const float t93 = fmaf(fmaf(t78, t90, t85), t77 + t78, t91);
        const float t94 = fmaf(t76, t93, t92);
        t_x = t73;
        t_y = t74;
        kappa = t75;
        cut = t76;
        shape = t92;
        shape_cut = fmaf(t76 - t73, t93, t92);
        norm = t94;
        width = t42 * t71;
        inv_cut_1 = t64 * t67;
        tau = t69 * t60;
        area = t74 * t74 * t74 * (spherecap_min(t40, t41) * t60) * t94;
    }
    const float t95 = radius_sin * radius_sin;
    const float t96 = elevation_sin < 0.0f ? area : t95 * t63 * 3.1415927f + area;
    const bool t97 = t25 && 9.8607613e-32f < t95;
    const float distance = t26 * unscale;
    const float solid_angle = t97 ? t95 * (t59 * t13) * 6.2831855f : 0.0f;
    const float projected_above = (9.403955e-38f < t96 && t97) ? t96 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t98 = 0.0f < inv_above;
    const bool t99 = 0.0f < elevation_sin;
    const float t100 = t99 ? inv_above : 0.0f;
    const float t101 = t98 ? defensive : 0.0f < defensive || !t43 ? 1.0f : 0.0f;
    const bool t102 = 0.0f < tau;
    const bool t103 = t99 && t102 && 0.0f < t100;
    const float t104 = t_y * t_y * t_y * shape * t100;
    const float t105 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (!t99 && t102) {
        const float t106 = 1.0f + kappa;
        const float t107 = t106 * shape;
        const float t108 = 1.0f / (norm * t107);
        const float t109 = sqrtf(t108);
        const float t110 = norm * t109;
        const float t111 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t112 = t111 * t111;
        const float t113 = fmaf(fmaf(fmaf(-0.026061837f, t112, -0.06372378f), t112, -0.11762552f), t112, -0.23594604f);
        const float t114 = fmaf(fmaf(fmaf(0.05430631f, t112, 0.080950715f), t112, 0.1684019f), t112, 0.32709444f);
        const float t115 = fmaf(fmaf(fmaf(t113, t112, -0.44721135f), t112, -0.7754678f), t111, fmaf(fmaf(t114, t112, 0.5987523f), t112, 0.94559944f));
        const float t116 = t106 * t115 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t107 * t108);
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
        coefficients_0 = t110;
        coefficients_1 = t116 - t110 + t122;
        coefficients_2 = t125 - t122;
        coefficients_3 = t128 - t125;
        coefficients_4 = t130 - t128;
        coefficients_5 = t131 - t130;
        coefficients_6 = -t131;
    }
    const bool t132 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f;
    const bool t133 = t132 && (t98 || (0.0f < t101 && 0.0f < solid_angle));
    spherecap_front_light light;
    light.is_sampled = t133;
    light.solid_angle = t133 ? solid_angle : 0.0f;
    light.projected_solid_angle = t133 ? projected_above : 0.0f;
    light.frame_0 = make_float3(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = make_float3(fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = make_float3(frame_2_x, frame_2_y, frame_2_z);
    light.normal = make_float3(normal_x, normal_y, normal_z);
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = t97 ? t58 * (inv_radius_sin * inv_radius_sin) * 0.15915494f : 0.0f;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t42 * (t27 * t27) * t67, -(radius_cos * t63));
    light.defensive = t101;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.crescent_share = t103 ? t104 : 0.0f;
    light.inv_rest = t103 ? 1.0f / (1.0f - t104) : 1.0f;
    light.beyond = t103 ? t105 * t105 * t105 * shape_cut : 0.0f;
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
    const bool t2 = 0.0f < light.elevation_sin;
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t3 < light.defensive;
    const float t6 = 1.0f - light.defensive;
    const float t7 = spherecap_max((t5 ? t3 : t3 - light.defensive) / (t5 ? light.defensive : t6), 5.9604645e-8f);
    const float t8 = 0.0f < light.requested ? spherecap_min(t7, 0.99999994f) : t3;
    const bool t9 = t5 || (t2 && light.crescent_share <= t8);
    const float t10 = 1.0f - t4;
    const float t11 = t4 - t10;
    const float t12 = 4.0f * t4 * t10;
    float t13 = 0.0f;
    float t14 = 0.0f;
    float t15 = 0.0f;
    float t16 = 0.0f;
    if (t9) {
        const float t17 = spherecap_max((t8 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
        const float t18 = t5 ? t8 : spherecap_min(t17, 0.99999994f);
        const float t19 = t5 ? 0.0f : light.beyond;
        const float t20 = 3.1415927f - t19;
        const float t21 = fmaf(t18, t20, t19);
        const float t22 = (1.0f - t18) * t20;
        t13 = spherecap_min(t21, t22) * 0.53033006f;
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
            t27 = light.crescent_share;
        } else {
            const float t28 = fmaf(fmaf(light.coefficients_6, t12, light.coefficients_4), t12, light.coefficients_2);
            const float t29 = fmaf(fmaf(light.coefficients_5, t12, light.coefficients_3), t12, light.coefficients_1);
            const float t30 = t23 * fmaf(t29, t23, fmaf(t28, t12, light.coefficients_0));
            const float t31 = sqrtf(fmaf(t11, t11, t30 * t30));
            const float t32 = light.tau * t30;
            t24 = t32;
            t25 = fmaf(t11, t11, t32 * t32);
            t26 = light.width;
            t27 = fmaf(light.kappa, t30, t31) * fmaf(light.cut, t30, t31);
        }
        const float t33 = t26 / t27;
        const float t34 = t2 ? light.width : t33;
        const float t35 = t25 * t34;
        const float t36 = t35 * t35;
        const float t37 = fmaf(fmaf(fmaf(-0.00060778117f, t36, -0.0027203285f), t36, -0.10000902f), t35, fmaf(fmaf(1.0676054e-5f, t36, -0.011332183f), t36, 1.0000001f));
        t13 = t2 ? spherecap_min(spherecap_max(t33, 5.9604645e-8f), 0.99999994f) : t8;
        t14 = t34 * t37;
        t15 = t25;
        t16 = t24;
    }
    const float t38 = spherecap_float_of_bits(fmaf(spherecap_bits(t13), -0.33333334f, 1419900500.0f));
    const float t39 = fmaf(-(t13 * t38), t38 * t38, 1.0f);
    const float t40 = t39 * t39;
    const float t41 = fmaf(fmaf(fmaf(0.110958695f, t40, 0.14403293f), t40, 0.22222222f), t39, fmaf(fmaf(0.12482853f, t40, 0.17283951f), t40, 0.33333334f));
    const float t42 = t14 * (t13 * fmaf(t38, t39 * t41, t38));
    const float t43 = t42 * t15;
    const float t44 = t43 * t43;
    const float t45 = fmaf(fmaf(fmaf(-0.063446075f, t44, -0.056249518f), t44, 0.0074712755f), t44, 0.09996679f);
    const float t46 = fmaf(fmaf(fmaf(0.022114987f, t44, 0.085662976f), t44, 0.030445365f), t44, 0.03209764f);
    const float t47 = t42 * fmaf(t45, t43, fmaf(t46, t44, 1.0000004f));
    const float t48 = t9 ? spherecap_min(t47, 1.0f) : t47;
    const float t49 = t15 * t48;
    const float t50 = 2.0f - t49;
    const float t51 = t48 * t50;
    const float t52 = sqrtf(t51);
    float zenith = 0.0f;
    float side = 0.0f;
    float cosine = 0.0f;
    if (t9) {
        const float t53 = t16 < 0.0f ? t49 : t50;
        float t54 = 0.0f;
        float t55 = 0.0f;
        float t56 = 0.0f;
        if (t5) {
            const float t57 = light.solid_angle * 0.15915494f;
            const float t58 = t57 * (1.0f - t51 * t12);
            const float t59 = sqrtf(t57 * (2.0f - t58));
            const float t60 = (t53 - 1.0f) * t59;
            t54 = t60;
            t55 = t52 * t11 * t59;
            t56 = fmaf(light.elevation_sin, 1.0f - t58, light.elevation_cos * t60);
        } else {
            const float t61 = light.radius_sin * light.elevation_cos;
            const float t62 = 1.0f - t53;
            const float t63 = t51 * t12;
            const float t64 = spherecap_max(fmaf(t61, t53, -light.rise), 0.0f);
            const float t65 = sqrtf(fmaf(t64, t64, light.radius_sin * light.radius_sin * t63));
            const float t66 = t1 * light.radius_cos;
            const float t67 = fmaf(light.elevation_cos * t62, fmaf(t61, t62, -2.0f * t66), light.radius_sin * t63);
            const float t68 = light.radius_sin * fmaf(light.elevation_cos, t67 / (t65 + t66), -(t1 * t1 * t62));
            t54 = t68;
            t55 = light.radius_sin * t52 * t11;
            t56 = t65;
        }
        zenith = t54;
        side = t55;
        cosine = t56;
    } else {
        const float t69 = t52 * t16;
        zenith = fmaf(light.elevation_cos, t69, -((t2 ? t1 : -t1) * (1.0f - t49)));
        side = t52 * t11;
        cosine = t69;
    }
    const float t70 = spherecap_min(fabsf(cosine), 3.4028235e38f);
    const float t71 = 0.0f < cosine ? light.inv_above : 0.0f;
    float t72 = 0.0f;
    float t73 = 0.0f;
    if (0.0f < light.defensive) {
        const float t74 = light.defensive * light.inv_solid_angle;
        const float t75 = fmaf(t71, t6, spherecap_min(t74 / spherecap_max(t70, 1.1754944e-38f), 3.4028235e38f));
        t72 = fmaf(t71, t6 * t70, t74);
        t73 = spherecap_min(t75, 3.4028235e38f);
    } else {
        t72 = t71 * t70;
        t73 = t71;
    }
    const float t76 = fmaf(zenith, zenith, side * side);
    const float t77 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t76), 0.0f);
    const float t78 = sqrtf(t77);
    const float t79 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t77));
    const float t80 = light.radius_cos * light.radius_cos / (t79 + t78);
    const float t81 = fmaf(light.frame_0.x, t79, fmaf(light.frame_1.x, zenith, light.frame_2.x * side));
    const float t82 = fmaf(light.frame_0.y, t79, fmaf(light.frame_1.y, zenith, light.frame_2.y * side));
    const float t83 = fmaf(light.frame_0.z, t79, fmaf(light.frame_1.z, zenith, light.frame_2.z * side));
    const float t84 = t80 * light.inv_radius_sin;
    const float t85 = -fmaf(t79, t78, t76) * light.inv_radius_sin;
    const float t86 = t84 * zenith;
    const float t87 = t84 * side;
    const float t88 = fmaf(light.frame_0.x, t85, fmaf(light.frame_1.x, t86, light.frame_2.x * t87));
    const float t89 = fmaf(light.frame_0.y, t85, fmaf(light.frame_1.y, t86, light.frame_2.y * t87));
    const float t90 = fmaf(light.frame_0.z, t85, fmaf(light.frame_1.z, t86, light.frame_2.z * t87));
    spherecap_sample sampled;
    sampled.direction = make_float3(t81, t82, t83);
    sampled.distance = t80 * light.distance;
    sampled.normal = make_float3(t88, t89, t90);
    sampled.cosine = cosine;
    sampled.pdf = t72;
    sampled.projected_pdf = t73;
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
    const float t1 = fmaf(light.frame_0.x, direction.x, fmaf(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    const float t2 = fmaf(light.frame_1.x, direction.x, fmaf(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    const float t3 = fmaf(light.frame_2.x, direction.x, fmaf(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    const float t4 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const bool t5 = t1 < 0.0f;
    const float t6 = t5 ? 1.0f : t2;
    const float t7 = t5 ? 1.0f : t3;
    const float t8 = spherecap_min(fabsf(t4), 3.4028235e38f);
    const float t9 = 0.0f < t4 ? light.inv_above : 0.0f;
    const float t10 = fmaf(t9, (1.0f - light.defensive) * t8, light.defensive * light.inv_solid_angle);
    const bool t11 = fmaf(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t12 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t13 = (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? (0.0f < light.defensive ? t10 : t9 * t8) : 0.0f) : 0.0f;
    return t13;
}

static __device__ inline float spherecap_front_pdf_on_sphere(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = spherecap_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light.inv_above : 0.0f;
    const float t4 = fmaf(t3, (1.0f - light.defensive) * t2, light.defensive * light.inv_solid_angle);
    const float t5 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light.defensive ? t4 : t3 * t2) : 0.0f;
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
    float3 frame_0;
    float3 frame_1;
    float3 frame_2;
    float3 normal;
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
    const float t9 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37f));
    const float scale = spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t10 = centre.x * scale;
    const float t11 = centre.y * scale;
    const float t12 = centre.z * scale;
    const float t13 = radius * scale;
    const float t14 = __fmul_rn(t10, t10);
    const float t15 = __fmul_rn(t11, t11);
    const float t16 = __fmul_rn(t12, t12);
    const float t17 = __fadd_rn(t14, t15);
    const float t18 = __fsub_rn(t17, t14);
    const float t19 = __fadd_rn(t17, t16);
    const float t20 = __fsub_rn(t19, t17);
    const float t21 = spherecap_lost(t10, t10, t14) + spherecap_lost(t11, t11, t15) + spherecap_lost(t12, t12, t16);
    const float t22 = __fsub_rn(t14, __fsub_rn(t17, t18)) + __fsub_rn(t15, t18) + (__fsub_rn(t17, __fsub_rn(t19, t20)) + __fsub_rn(t16, t20));
    const float t23 = __fmul_rn(t13, t13);
    const float t24 = t19 - t23 + (t21 + t22 - spherecap_lost(t13, t13, t23));
    const bool t25 = 0.0f < t24;
    const float t26 = sqrtf(t19);
    const float t27 = 1.0f / t26;
    const float t28 = __fmul_rn(normal_x, t10);
    const float t29 = __fmul_rn(normal_y, t11);
    const float t30 = __fmul_rn(normal_z, t12);
    const float t31 = __fadd_rn(t28, t29);
    const float t32 = __fsub_rn(t31, t28);
    const float t33 = __fadd_rn(t31, t30);
    const float t34 = __fsub_rn(t33, t31);
    const float t35 = spherecap_lost(normal_x, t10, t28) + spherecap_lost(normal_y, t11, t29) + spherecap_lost(normal_z, t12, t30);
    const float t36 = __fsub_rn(t28, __fsub_rn(t31, t32)) + __fsub_rn(t29, t32) + (__fsub_rn(t31, __fsub_rn(t33, t34)) + __fsub_rn(t30, t34));
    const float t37 = t35 + t36;
    const float t38 = __fadd_rn(t33, t37);
    const float t39 = __fsub_rn(t37, __fsub_rn(t38, t33));
    const float t40 = t13 - t38 - t39;
    const float t41 = t13 + t38 + t39;
    const float t42 = t40 * t41;
    const bool t43 = 0.0f < t8;
    const bool t44 = 0.0f < t42 && t25 && t43;
    const float t45 = __fmul_rn(normal_z, t11);
    const float t46 = fmaf(normal_y, t12, -t45) - spherecap_lost(normal_z, t11, t45);
    const float t47 = __fmul_rn(normal_x, t12);
    const float t48 = fmaf(normal_z, t10, -t47) - spherecap_lost(normal_x, t12, t47);
    const float t49 = __fmul_rn(normal_y, t10);
    const float t50 = fmaf(normal_x, t11, -t49) - spherecap_lost(normal_y, t10, t49);
    const float t51 = fmaf(t46, t46, fmaf(t48, t48, t50 * t50));
    const bool t52 = 9.8607613e-32f < t51;
    const bool t53 = fabsf(t10) < fabsf(t12);
    const float t54 = t53 ? 0.0f : -t11;
    const float t55 = t53 ? -t12 : t10;
    const float t56 = t53 ? t11 : 0.0f;
    const float t57 = sqrtf(spherecap_max(t24, 0.0f));
    const float radius_cos = t57 * t27;
    const float t58 = 1.0f + radius_cos;
    const float t59 = 1.0f / (t13 * t58);
    const float t60 = t59 * t58;
    const float radius_sin = t13 * t27;
    const float inv_radius_sin = t26 * t60;
    const float t61 = sqrtf(t24 + t42);
    const float t62 = sqrtf(t52 ? t51 : fmaf(t54, t54, fmaf(t55, t55, t56 * t56)));
    const float elevation_sin = t38 * t27;
    const float elevation_cos = (t44 ? t61 : t52 ? t62 : 0.0f) * t27;
    const float t63 = fabsf(elevation_sin);
    const float t64 = radius_sin * elevation_cos;
    const float t65 = spherecap_max(fmaf(radius_cos, t63, t64), 9.8607613e-32f);
    const float t66 = 1.0f / (t65 * t62);
    const float t67 = t66 * t62;
    const float t68 = t66 * t65;
    const float frame_2_x = (t52 ? t46 : t54) * t68;
    const float frame_2_y = (t52 ? t48 : t55) * t68;
    const float frame_2_z = (t52 ? t50 : t56) * t68;
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
    if (t44) {
        const float t69 = sqrtf(t42);
        const float t70 = t61 + t57;
        const float t71 = 1.0f / (t61 * t70);
        const float t72 = t71 * t70;
        const float t73 = t57 * t72;
        const float t74 = t69 * t72;
        const float t75 = fabsf(t38) * t60;
        const float t76 = t75 * t73;
        const float t77 = t73 - 0.5f;
        const float t78 = t76 - 0.5f;
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
        const float t92 = fmaf(t91, t77, fmaf(t84, t79, 0.94559944f));
        const float t93 = fmaf(fmaf(t78, t90, t85), t77 + t78, t91);
        const float t94 = fmaf(t76, t93, t92);
        t_x = t73;
        t_y = t74;
        kappa = t75;
        cut = t76;
        shape = t92;
        shape_cut = fmaf(t76 - t73, t93, t92);
        norm = t94;
        width = t42 * t71;
        inv_cut_1 = t64 * t67;
        tau = t69 * t60;
        area = t74 * t74 * t74 * (spherecap_min(t40, t41) * t60) * t94;
    }
    const float t95 = radius_sin * radius_sin;
    const float t96 = t95 * t63 * 3.1415927f + area;
    const bool t97 = elevation_sin < 0.0f;
    const float t98 = t97 ? area : t96;
    const float t99 = t97 ? t96 : area;
    const bool t100 = t25 && 9.8607613e-32f < t95;
    const float distance = t26 * unscale;
    const float solid_angle = t100 ? t95 * (t59 * t13) * 6.2831855f : 0.0f;
    const float projected_above = (9.403955e-38f < t98 && t100) ? t98 : 0.0f;
    const float projected_below = (9.403955e-38f < t99 && t100) ? t99 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float inv_below = 0.0f < projected_below ? 1.0f / projected_below : 0.0f;
    const bool t101 = 0.0f < inv_above + inv_below;
    const bool t102 = 0.0f < elevation_sin;
    const float t103 = t102 ? inv_above : inv_below;
    const float t104 = t101 ? defensive : 0.0f < defensive || !t43 ? 1.0f : 0.0f;
    const bool t105 = 0.0f < tau;
    const bool t106 = t105 && 0.0f < t103;
    const float t107 = t_y * t_y * t_y * shape * t103;
    const float t108 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    float t109 = 0.0f;
    if (t105) {
        const float t110 = 1.0f + kappa;
        const float t111 = t110 * shape;
        const float t112 = 1.0f / (norm * t111);
        const float t113 = sqrtf(t112);
        const float t114 = norm * t113;
        const float t115 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t116 = t115 * t115;
        const float t117 = fmaf(fmaf(fmaf(-0.026061837f, t116, -0.06372378f), t116, -0.11762552f), t116, -0.23594604f);
        const float t118 = fmaf(fmaf(fmaf(0.05430631f, t116, 0.080950715f), t116, 0.1684019f), t116, 0.32709444f);
        const float t119 = fmaf(fmaf(fmaf(t117, t116, -0.44721135f), t116, -0.7754678f), t115, fmaf(fmaf(t118, t116, 0.5987523f), t116, 0.94559944f));
        const float t120 = t110 * t119 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t111 * t112);
        const float t121 = fmaf(t120, t111 * t113, -1.0f);
        const float t122 = 1.0f - t120;
        const float t123 = fmaf(fmaf(30.011856f, t121, fmaf(-41.541264f, t122, -37.009792f)), t121, fmaf(77.96775f, t122, 7.470758f));
        const float t124 = fmaf(t123, t121, fmaf(fmaf(-49.13454f, t122, -9.466533f), t122, -1.5877596f));
        const float t125 = fmaf(fmaf(fmaf(15.716111f, t122, 0.0f), t122, 9.961183f), t122, -2.61785f);
        const float t126 = t121 * fmaf(t124, t121, fmaf(t125, t122, 0.8681748f));
        const float t127 = fmaf(fmaf(7.295638f, t121, -7.236236f), t121, fmaf(fmaf(fmaf(-11.4868555f, t122, 0.0f), t122, 0.0f), t122, 3.1255686f));
        const float t128 = fmaf(fmaf(fmaf(13.728438f, t122, -7.981878f), t122, 2.025724f), t122, -0.7334958f);
        const float t129 = t121 * fmaf(t127, t121, t128);
        const float t130 = fmaf(fmaf(fmaf(9.986537f, t122, 25.22195f), t122, 0.0f), t122, -2.9581387f);
        const float t131 = fmaf(fmaf(fmaf(-19.722994f, t122, 4.6594768f), t122, -0.89538246f), t122, 0.5143498f);
        const float t132 = t121 * fmaf(fmaf(fmaf(-23.220068f, t122, 7.332055f), t121, t130), t121, t131);
        const float t133 = fmaf(fmaf(fmaf(1.946617f, t121, -3.077631f), t121, 1.4945927f), t121, -0.24140751f);
        const float t134 = t121 * t133;
        const float t135 = t121 * fmaf(fmaf(0.38173297f, t121, -0.30305624f), t121, 0.05897375f);
        const float t136 = 1.0f / (elevation_cos * elevation_cos);
        const float t137 = tau * tau;
        const float t138 = t137 * t136 / (1.0f + t_x);
        const float t139 = kappa - 0.5f;
        const float t140 = cut - 0.5f;
        const float t141 = t139 * t139;
        const float t142 = t140 * t140;
        const float t143 = fmaf(0.05430631f, t141, 0.080950715f);
        const float t144 = fmaf(t143, t141, 0.1684019f);
        const float t145 = fmaf(t144, t141, 0.32709444f);
        const float t146 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t142, t143), t142, t144), t142, t145), t142, fmaf(t145, t141, 0.5987523f));
        const float t147 = fmaf(-0.026061837f, t141, -0.06372378f);
        const float t148 = fmaf(t147, t141, -0.11762552f);
        const float t149 = fmaf(t148, t141, -0.23594604f);
        const float t150 = fmaf(t149, t141, -0.44721135f);
        const float t151 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t142, t147), t142, t148), t142, t149), t142, t150);
        const float t152 = fmaf(kappa * t138, fmaf(fmaf(t140, t151, t146), t139 + t140, fmaf(t150, t141, -0.7754678f)), fmaf(shape_cut, t138 - kappa * kappa, kappa) * t136);
        const float t153 = spherecap_max(t137 * tau * (radius_cos + 1.0f) * t152 * 0.31830987f, 0.0f);
        coefficients_0 = t114;
        coefficients_1 = t120 - t114 + t126;
        coefficients_2 = t129 - t126;
        coefficients_3 = t132 - t129;
        coefficients_4 = t134 - t132;
        coefficients_5 = t135 - t134;
        coefficients_6 = -t135;
        t109 = spherecap_min(t153, 0.5f);
    }
    const float share_above = 0.0f < inv_below ? (0.0f < inv_above ? (t102 ? 1.0f - t109 : t109) : 0.0f) : 1.0f;
    const bool t154 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f;
    const bool t155 = t154 && (t101 || (0.0f < t104 && 0.0f < solid_angle));
    spherecap_both_light light;
    light.is_sampled = t155;
    light.solid_angle = t155 ? solid_angle : 0.0f;
    light.projected_solid_angle = t155 ? projected_above : 0.0f;
    light.frame_0 = make_float3(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = make_float3(fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = make_float3(frame_2_x, frame_2_y, frame_2_z);
    light.normal = make_float3(normal_x, normal_y, normal_z);
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = t100 ? t58 * (inv_radius_sin * inv_radius_sin) * 0.15915494f : 0.0f;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t42 * (t27 * t27) * t67, -(radius_cos * t63));
    light.defensive = t104;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
    light.crescent_share = t106 ? t107 : 0.0f;
    light.inv_rest = t106 ? 1.0f / (1.0f - t107) : 1.0f;
    light.beyond = t106 ? t108 * t108 * t108 * shape_cut : 0.0f;
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
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t3 < light.defensive;
    const float t6 = 1.0f - light.defensive;
    const float t7 = spherecap_max((t5 ? t3 : t3 - light.defensive) / (t5 ? light.defensive : t6), 5.9604645e-8f);
    const float t8 = 0.0f < light.requested ? spherecap_min(t7, 0.99999994f) : t3;
    const bool t9 = t5 || t8 < light.share_above;
    const float t10 = 1.0f - light.share_above;
    const float t11 = spherecap_max((t9 ? t8 : t8 - light.share_above) / (t9 ? light.share_above : t10), 5.9604645e-8f);
    const bool t12 = (t9 && t2) || (!t9 && !t2);
    const float t13 = t5 ? t8 : spherecap_min(t11, 0.99999994f);
    const bool t14 = t5 || (t12 && light.crescent_share <= t13);
    const float t15 = 1.0f - t4;
    const float t16 = t4 - t15;
    const float t17 = 4.0f * t4 * t15;
    float t18 = 0.0f;
    float t19 = 0.0f;
    float t20 = 0.0f;
    float t21 = 0.0f;
    if (t14) {
        const float t22 = spherecap_max((t13 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
        const float t23 = t5 ? t13 : spherecap_min(t22, 0.99999994f);
        const float t24 = t5 ? 0.0f : light.beyond;
        const float t25 = 3.1415927f - t24;
        const float t26 = fmaf(t23, t25, t24);
        const float t27 = (1.0f - t23) * t25;
        t18 = spherecap_min(t26, t27) * 0.53033006f;
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
            t32 = light.crescent_share;
        } else {
            const float t33 = fmaf(fmaf(light.coefficients_6, t17, light.coefficients_4), t17, light.coefficients_2);
            const float t34 = fmaf(fmaf(light.coefficients_5, t17, light.coefficients_3), t17, light.coefficients_1);
            const float t35 = t28 * fmaf(t34, t28, fmaf(t33, t17, light.coefficients_0));
            const float t36 = sqrtf(fmaf(t16, t16, t35 * t35));
            const float t37 = light.tau * t35;
            t29 = t37;
            t30 = fmaf(t16, t16, t37 * t37);
            t31 = light.width;
            t32 = fmaf(light.kappa, t35, t36) * fmaf(light.cut, t35, t36);
        }
        const float t38 = t31 / t32;
        const float t39 = t12 ? spherecap_min(spherecap_max(t38, 5.9604645e-8f), 0.99999994f) : t13;
        const float t40 = t12 ? light.width : t38;
        const float t41 = t30 * t40;
        const float t42 = t41 * t41;
        const float t43 = fmaf(fmaf(fmaf(-0.00060778117f, t42, -0.0027203285f), t42, -0.10000902f), t41, fmaf(fmaf(1.0676054e-5f, t42, -0.011332183f), t42, 1.0000001f));
        t18 = t39;
        t19 = t40 * t43;
        t20 = t30;
        t21 = t29;
    }
    const float t44 = spherecap_float_of_bits(fmaf(spherecap_bits(t18), -0.33333334f, 1419900500.0f));
    const float t45 = fmaf(-(t18 * t44), t44 * t44, 1.0f);
    const float t46 = t45 * t45;
    const float t47 = fmaf(fmaf(fmaf(0.110958695f, t46, 0.14403293f), t46, 0.22222222f), t45, fmaf(fmaf(0.12482853f, t46, 0.17283951f), t46, 0.33333334f));
    const float t48 = t19 * (t18 * fmaf(t44, t45 * t47, t44));
    const float t49 = t48 * t20;
    const float t50 = t49 * t49;
    const float t51 = fmaf(fmaf(fmaf(-0.063446075f, t50, -0.056249518f), t50, 0.0074712755f), t50, 0.09996679f);
    const float t52 = fmaf(fmaf(fmaf(0.022114987f, t50, 0.085662976f), t50, 0.030445365f), t50, 0.03209764f);
    const float t53 = t48 * fmaf(t51, t49, fmaf(t52, t50, 1.0000004f));
    const float t54 = t14 ? spherecap_min(t53, 1.0f) : t53;
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
            const float t65 = light.solid_angle * 0.15915494f;
            const float t66 = t65 * (1.0f - t57 * t17);
            const float t67 = sqrtf(t65 * (2.0f - t66));
            const float t68 = (t61 - 1.0f) * t67;
            t62 = t68;
            t63 = t58 * t16 * t67;
            t64 = fmaf(light.elevation_sin, 1.0f - t66, light.elevation_cos * t68);
        } else {
            const float t69 = light.radius_sin * light.elevation_cos;
            const float t70 = 1.0f - t61;
            const float t71 = t57 * t17;
            const float t72 = spherecap_max(fmaf(t69, t61, -light.rise), 0.0f);
            const float t73 = sqrtf(fmaf(t72, t72, light.radius_sin * light.radius_sin * t71));
            const float t74 = t1 * light.radius_cos;
            const float t75 = fmaf(light.elevation_cos * t70, fmaf(t69, t70, -2.0f * t74), light.radius_sin * t71);
            const float t76 = light.radius_sin * fmaf(light.elevation_cos, t75 / (t73 + t74), -(t1 * t1 * t70));
            t62 = t76;
            t63 = light.radius_sin * t58 * t16;
            t64 = t73;
        }
        t59 = t62;
        side = t63;
        t60 = t64;
    } else {
        const float t77 = t58 * t21;
        t59 = fmaf(light.elevation_cos, t77, -((t12 ? t1 : -t1) * (1.0f - t55)));
        side = t58 * t16;
        t60 = t77;
    }
    const float t78 = t9 ? 1.0f : -1.0f;
    const float zenith = t59 * t78;
    const float cosine = t60 * t78;
    const float t79 = spherecap_min(fabsf(cosine), 3.4028235e38f);
    const float t80 = 0.0f < cosine ? light.inv_above * light.share_above : cosine < 0.0f ? light.inv_below * t10 : 0.0f;
    float t81 = 0.0f;
    float t82 = 0.0f;
    if (0.0f < light.defensive) {
        const float t83 = light.defensive * light.inv_solid_angle;
        const float t84 = fmaf(t80, t6, spherecap_min(t83 / spherecap_max(t79, 1.1754944e-38f), 3.4028235e38f));
        t81 = fmaf(t80, t6 * t79, t83);
        t82 = spherecap_min(t84, 3.4028235e38f);
    } else {
        t81 = t80 * t79;
        t82 = t80;
    }
    const float t85 = fmaf(zenith, zenith, side * side);
    const float t86 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t85), 0.0f);
    const float t87 = sqrtf(t86);
    const float t88 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t86));
    const float t89 = light.radius_cos * light.radius_cos / (t88 + t87);
    const float t90 = fmaf(light.frame_0.x, t88, fmaf(light.frame_1.x, zenith, light.frame_2.x * side));
    const float t91 = fmaf(light.frame_0.y, t88, fmaf(light.frame_1.y, zenith, light.frame_2.y * side));
    const float t92 = fmaf(light.frame_0.z, t88, fmaf(light.frame_1.z, zenith, light.frame_2.z * side));
    const float t93 = t89 * light.inv_radius_sin;
    const float t94 = -fmaf(t88, t87, t85) * light.inv_radius_sin;
    const float t95 = t93 * zenith;
    const float t96 = t93 * side;
    const float t97 = fmaf(light.frame_0.x, t94, fmaf(light.frame_1.x, t95, light.frame_2.x * t96));
    const float t98 = fmaf(light.frame_0.y, t94, fmaf(light.frame_1.y, t95, light.frame_2.y * t96));
    const float t99 = fmaf(light.frame_0.z, t94, fmaf(light.frame_1.z, t95, light.frame_2.z * t96));
    spherecap_sample sampled;
    sampled.direction = make_float3(t90, t91, t92);
    sampled.distance = t89 * light.distance;
    sampled.normal = make_float3(t97, t98, t99);
    sampled.cosine = cosine;
    sampled.pdf = t81;
    sampled.projected_pdf = t82;
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
    const float t1 = fmaf(light.frame_0.x, direction.x, fmaf(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    const float t2 = fmaf(light.frame_1.x, direction.x, fmaf(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    const float t3 = fmaf(light.frame_2.x, direction.x, fmaf(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    const float t4 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const bool t5 = t1 < 0.0f;
    const float t6 = t5 ? 1.0f : t2;
    const float t7 = t5 ? 1.0f : t3;
    const float t8 = spherecap_min(fabsf(t4), 3.4028235e38f);
    const float t9 = 0.0f < t4 ? light.inv_above * light.share_above : t4 < 0.0f ? light.inv_below * (1.0f - light.share_above) : 0.0f;
    const float t10 = fmaf(t9, (1.0f - light.defensive) * t8, light.defensive * light.inv_solid_angle);
    const bool t11 = fmaf(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t12 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t13 = (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? (0.0f < light.defensive ? t10 : t9 * t8) : 0.0f) : 0.0f;
    return t13;
}

static __device__ inline float spherecap_both_pdf_on_sphere(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = spherecap_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light.inv_above * light.share_above : t1 < 0.0f ? light.inv_below * (1.0f - light.share_above) : 0.0f;
    const float t4 = fmaf(t3, (1.0f - light.defensive) * t2, light.defensive * light.inv_solid_angle);
    const float t5 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light.defensive ? t4 : t3 * t2) : 0.0f;
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
