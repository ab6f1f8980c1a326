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
};

static __device__ inline spherecap_surface_light spherecap_surface_prepare(float3 normal, float3 centre, float radius) {
    const float t1 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float t2 = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37f));
    const float t3 = spherecap_float_of_bits(2130706400.0f - spherecap_bits(t2));
    const float t4 = centre.x * t3;
    const float t5 = centre.y * t3;
    const float t6 = centre.z * t3;
    const float t7 = radius * t3;
    const float t8 = __fmul_rn(t4, t4);
    const float t9 = __fmul_rn(t5, t5);
    const float t10 = __fmul_rn(t6, t6);
    const float t11 = __fadd_rn(t8, t9);
    const float t12 = __fsub_rn(t11, t8);
    const float t13 = __fadd_rn(t11, t10);
    const float t14 = __fsub_rn(t13, t11);
    const float t15 = spherecap_lost(t4, t4, t8) + spherecap_lost(t5, t5, t9) + spherecap_lost(t6, t6, t10);
    const float t16 = __fsub_rn(t8, __fsub_rn(t11, t12)) + __fsub_rn(t9, t12) + (__fsub_rn(t11, __fsub_rn(t13, t14)) + __fsub_rn(t10, t14));
    const float t17 = __fmul_rn(t7, t7);
    const float t18 = t13 - t17 + (t15 + t16 - spherecap_lost(t7, t7, t17));
    const bool t19 = 0.0f < t18;
    const float t20 = sqrtf(t13);
    const float t21 = 1.0f / t20;
    const float t22 = __fmul_rn(normal.x, t4);
    const float t23 = __fmul_rn(normal.y, t5);
    const float t24 = __fmul_rn(normal.z, t6);
    const float t25 = __fadd_rn(t22, t23);
    const float t26 = __fsub_rn(t25, t22);
    const float t27 = __fadd_rn(t25, t24);
    const float t28 = __fsub_rn(t27, t25);
    const float t29 = spherecap_lost(normal.x, t4, t22) + spherecap_lost(normal.y, t5, t23) + spherecap_lost(normal.z, t6, t24);
    const float t30 = __fsub_rn(t22, __fsub_rn(t25, t26)) + __fsub_rn(t23, t26) + (__fsub_rn(t25, __fsub_rn(t27, t28)) + __fsub_rn(t24, t28));
    const float t31 = t29 + t30;
    const float t32 = __fadd_rn(t27, t31);
    const float t33 = __fsub_rn(t31, __fsub_rn(t32, t27));
    const float t34 = t7 - t32 - t33;
    const float t35 = t7 + t32 + t33;
    const float t36 = t34 * t35;
    const bool t37 = 0.0f < t36 && t19;
    const float t38 = __fmul_rn(normal.z, t5);
    const float t39 = fmaf(normal.y, t6, -t38) - spherecap_lost(normal.z, t5, t38);
    const float t40 = __fmul_rn(normal.x, t6);
    const float t41 = fmaf(normal.z, t4, -t40) - spherecap_lost(normal.x, t6, t40);
    const float t42 = __fmul_rn(normal.y, t4);
    const float t43 = fmaf(normal.x, t5, -t42) - spherecap_lost(normal.y, t4, t42);
    const float t44 = fmaf(t39, t39, fmaf(t41, t41, t43 * t43));
    const bool t45 = 9.8607613e-32f < t44;
    const bool t46 = fabsf(t4) < fabsf(t6);
    const float t47 = t46 ? 0.0f : -t5;
    const float t48 = t46 ? -t6 : t4;
    const float t49 = t46 ? t5 : 0.0f;
    const float t50 = sqrtf(spherecap_max(t18, 0.0f));
    const float radius_cos = t50 * t21;
    const float t51 = 1.0f + radius_cos;
    const float t52 = 1.0f / (t7 * t51);
    const float t53 = t52 * t51;
    const float radius_sin = t7 * t21;
    const float inv_radius_sin = t20 * t53;
    const float t54 = sqrtf(t18 + t36);
    const float t55 = sqrtf(t45 ? t44 : fmaf(t47, t47, fmaf(t48, t48, t49 * t49)));
    const float elevation_sin = t32 * t21;
    const float elevation_cos = (t37 ? t54 : t45 ? t55 : 0.0f) * t21;
    const float t56 = fabsf(elevation_sin);
    const float t57 = radius_sin * elevation_cos;
    const float t58 = spherecap_max(fmaf(radius_cos, t56, t57), 9.8607613e-32f);
    const float t59 = 1.0f / (t58 * t55);
    const float t60 = t59 * t55;
    const float t61 = t59 * t58;
    const float frame_2_x = (t45 ? t39 : t47) * t61;
    const float frame_2_y = (t45 ? t41 : t48) * t61;
    const float frame_2_z = (t45 ? t43 : t49) * t61;
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
    if (t37) {
        const float t62 = sqrtf(t36);
        const float t63 = t54 + t50;
        const float t64 = 1.0f / (t54 * t63);
        const float t65 = t64 * t63;
        const float t66 = t50 * t65;
        const float t67 = t62 * t65;
        const float t68 = fabsf(t32) * t53;
        const float t69 = t68 * t66;
        const float t70 = t66 - 0.5f;
        const float t71 = t69 - 0.5f;
        const float t72 = t70 * t70;
        const float t73 = t71 * t71;
        const float t74 = fmaf(0.05430631f, t72, 0.080950715f);
        const float t75 = fmaf(t74, t72, 0.1684019f);
        const float t76 = fmaf(t75, t72, 0.32709444f);
        const float t77 = fmaf(t76, t72, 0.5987523f);
        const float t78 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t73, t74), t73, t75), t73, t76), t73, t77);
        const float t79 = fmaf(-0.026061837f, t72, -0.06372378f);
        const float t80 = fmaf(t79, t72, -0.11762552f);
        const float t81 = fmaf(t80, t72, -0.23594604f);
        const float t82 = fmaf(t81, t72, -0.44721135f);
        const float t83 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t73, t79), t73, t80), t73, t81), t73, t82);
        const float t84 = fmaf(t82, t72, -0.7754678f);
        const float t85 = fmaf(t84, t70, fmaf(t77, t72, 0.94559944f));
        const float t86 = fmaf(fmaf(t71, t83, t78), t70 + t71, t84);
        const float t87 = fmaf(t69, t86, t85);
        t_x = t66;
        t_y = t67;
        kappa = t68;
        cut = t69;
        shape = t85;
        shape_cut = fmaf(t69 - t66, t86, t85);
        norm = t87;
        width = t36 * t64;
        inv_cut_1 = t57 * t60;
        tau = t62 * t53;
        area = t67 * t67 * t67 * (spherecap_min(t34, t35) * t53) * t87;
    }
    const float t88 = radius_sin * radius_sin;
    const float t89 = elevation_sin < 0.0f ? area : t88 * t56 * 3.1415927f + area;
    const bool t90 = t19 && 9.8607613e-32f < t88;
    const float distance = t20 * t2;
    const float projected_above = (9.403955e-38f < t89 && t90) ? t89 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t91 = 0.0f < elevation_sin;
    const float t92 = t91 ? inv_above : 0.0f;
    const bool t93 = 0.0f < tau;
    const bool t94 = t91 && t93 && 0.0f < t92;
    const float t95 = t_y * t_y * t_y * shape * t92;
    const float t96 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (!t91 && t93) {
        const float t97 = 1.0f + kappa;
        const float t98 = t97 * shape;
        const float t99 = 1.0f / (norm * t98);
        const float t100 = sqrtf(t99);
        const float t101 = norm * t100;
        const float t102 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t103 = t102 * t102;
        const float t104 = fmaf(fmaf(fmaf(-0.026061837f, t103, -0.06372378f), t103, -0.11762552f), t103, -0.23594604f);
        const float t105 = fmaf(fmaf(fmaf(0.05430631f, t103, 0.080950715f), t103, 0.1684019f), t103, 0.32709444f);
        const float t106 = fmaf(fmaf(fmaf(t104, t103, -0.44721135f), t103, -0.7754678f), t102, fmaf(fmaf(t105, t103, 0.5987523f), t103, 0.94559944f));
        const float t107 = t97 * t106 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t98 * t99);
        const float t108 = fmaf(t107, t98 * t100, -1.0f);
        const float t109 = 1.0f - t107;
        const float t110 = fmaf(fmaf(30.011856f, t108, fmaf(-41.541264f, t109, -37.009792f)), t108, fmaf(77.96775f, t109, 7.470758f));
        const float t111 = fmaf(t110, t108, fmaf(fmaf(-49.13454f, t109, -9.466533f), t109, -1.5877596f));
        const float t112 = fmaf(fmaf(fmaf(15.716111f, t109, 0.0f), t109, 9.961183f), t109, -2.61785f);
        const float t113 = t108 * fmaf(t111, t108, fmaf(t112, t109, 0.8681748f));
        const float t114 = fmaf(fmaf(7.295638f, t108, -7.236236f), t108, fmaf(fmaf(fmaf(-11.4868555f, t109, 0.0f), t109, 0.0f), t109, 3.1255686f));
        const float t115 = fmaf(fmaf(fmaf(13.728438f, t109, -7.981878f), t109, 2.025724f), t109, -0.7334958f);
        const float t116 = t108 * fmaf(t114, t108, t115);
        const float t117 = fmaf(fmaf(fmaf(9.986537f, t109, 25.22195f), t109, 0.0f), t109, -2.9581387f);
        const float t118 = fmaf(fmaf(fmaf(-19.722994f, t109, 4.6594768f), t109, -0.89538246f), t109, 0.5143498f);
        const float t119 = t108 * fmaf(fmaf(fmaf(-23.220068f, t109, 7.332055f), t108, t117), t108, t118);
        const float t120 = fmaf(fmaf(fmaf(1.946617f, t108, -3.077631f), t108, 1.4945927f), t108, -0.24140751f);
        const float t121 = t108 * t120;
        const float t122 = t108 * fmaf(fmaf(0.38173297f, t108, -0.30305624f), t108, 0.05897375f);
        coefficients_0 = t101;
        coefficients_1 = t107 - t101 + t113;
        coefficients_2 = t116 - t113;
        coefficients_3 = t119 - t116;
        coefficients_4 = t121 - t119;
        coefficients_5 = t122 - t121;
        coefficients_6 = -t122;
    }
    const bool t123 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    spherecap_surface_light light;
    light.is_sampled = t123;
    light.solid_angle = t123 ? (t90 ? t88 * (t52 * t7) * 6.2831855f : 0.0f) : 0.0f;
    light.projected_solid_angle = t123 ? projected_above : 0.0f;
    light.frame_0_x = frame_0_x;
    light.frame_0_y = frame_0_y;
    light.frame_0_z = frame_0_z;
    light.frame_1_x = fmaf(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1_y = fmaf(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1_z = fmaf(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
    light.frame_2_x = frame_2_x;
    light.frame_2_y = frame_2_y;
    light.frame_2_z = frame_2_z;
    light.normal_x = normal.x;
    light.normal_y = normal.y;
    light.normal_z = normal.z;
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
    light.rise = spherecap_max(t36 * (t21 * t21) * t60, -(radius_cos * t56));
    light.inv_above = inv_above;
    light.crescent_share = t94 ? t95 : 0.0f;
    light.inv_rest = t94 ? 1.0f / (1.0f - t95) : 1.0f;
    light.beyond = t94 ? t96 * t96 * t96 * shape_cut : 0.0f;
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
    float t48 = 0.0f;
    float t49 = 0.0f;
    float t50 = 0.0f;
    if (t5) {
        const float t51 = light.radius_sin * light.elevation_cos;
        const float t52 = t12 < 0.0f ? t44 : t45;
        const float t53 = 1.0f - t52;
        const float t54 = t46 * t8;
        const float t55 = spherecap_max(fmaf(t51, t52, -light.rise), 0.0f);
        const float t56 = sqrtf(fmaf(t55, t55, light.radius_sin * light.radius_sin * t54));
        const float t57 = t1 * light.radius_cos;
        const float t58 = fmaf(light.elevation_cos * t53, fmaf(t51, t53, -2.0f * t57), light.radius_sin * t54);
        const float t59 = light.radius_sin * fmaf(light.elevation_cos, t58 / (t56 + t57), -(t1 * t1 * t53));
        t48 = t59;
        t49 = light.radius_sin * t47 * t7;
        t50 = t56;
    } else {
        const float t60 = t47 * t12;
        t48 = fmaf(light.elevation_cos, t60, -((t2 ? t1 : -t1) * (1.0f - t44)));
        t49 = t47 * t7;
        t50 = t60;
    }
    const float t61 = 0.0f < t50 ? light.inv_above : 0.0f;
    const float t62 = fmaf(t48, t48, t49 * t49);
    const float t63 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t62), 0.0f);
    const float t64 = sqrtf(t63);
    const float t65 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t63));
    const float t66 = light.radius_cos * light.radius_cos / (t65 + t64);
    const float t67 = fmaf(light.frame_0_x, t65, fmaf(light.frame_1_x, t48, light.frame_2_x * t49));
    const float t68 = fmaf(light.frame_0_y, t65, fmaf(light.frame_1_y, t48, light.frame_2_y * t49));
    const float t69 = fmaf(light.frame_0_z, t65, fmaf(light.frame_1_z, t48, light.frame_2_z * t49));
    const float t70 = t66 * light.inv_radius_sin;
    const float t71 = -fmaf(t65, t64, t62) * light.inv_radius_sin;
    const float t72 = t70 * t48;
    const float t73 = t70 * t49;
    const float t74 = fmaf(light.frame_0_x, t71, fmaf(light.frame_1_x, t72, light.frame_2_x * t73));
    const float t75 = fmaf(light.frame_0_y, t71, fmaf(light.frame_1_y, t72, light.frame_2_y * t73));
    const float t76 = fmaf(light.frame_0_z, t71, fmaf(light.frame_1_z, t72, light.frame_2_z * t73));
    spherecap_sample sampled;
    sampled.direction = make_float3(t67, t68, t69);
    sampled.distance = t66 * light.distance;
    sampled.normal = make_float3(t74, t75, t76);
    sampled.cosine = t50;
    sampled.pdf = t61 * spherecap_min(fabsf(t50), 3.4028235e38f);
    sampled.projected_pdf = t61;
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
    const float t1 = fmaf(light.frame_0_x, direction.x, fmaf(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    const float t2 = fmaf(light.frame_1_x, direction.x, fmaf(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    const float t3 = fmaf(light.frame_2_x, direction.x, fmaf(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    const float t4 = fmaf(light.normal_x, direction.x, fmaf(light.normal_y, direction.y, light.normal_z * direction.z));
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
    const float t1 = fmaf(light.normal_x, direction.x, fmaf(light.normal_y, direction.y, light.normal_z * direction.z));
    const float t2 = (0.0f < t1 ? light.inv_above : 0.0f) * spherecap_min(fabsf(t1), 3.4028235e38f);
    const float t3 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
}

static __device__ inline float spherecap_surface_importance(float3 normal, float3 centre, float radius, float strength) {
    const float t1 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float t2 = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37f));
    const float t3 = spherecap_float_of_bits(2130706400.0f - spherecap_bits(t2));
    const float t4 = centre.x * t3;
    const float t5 = centre.y * t3;
    const float t6 = centre.z * t3;
    const float t7 = radius * t3;
    const float t8 = sqrtf(fmaf(t4, t4, fmaf(t5, t5, t6 * t6)));
    const float t9 = 1.0f / t8;
    const float t10 = t7 * t9;
    const float t11 = t10 * t10;
    const bool t12 = 0.0f < radius && t8 * t2 <= 3.4028235e38f && 0.0f < strength && strength <= 3.4028235e38f;
    const float t13 = fmaf(normal.x, t4, fmaf(normal.y, t5, normal.z * t6));
    const float t14 = fmaf(t13, t9, 2.3841858e-7f);
    const float t15 = fmaf(t13 + t7, t9, 2.3841858e-7f);
    const float t16 = fmaf(t10 - t14, spherecap_max(fmaf(-t11, t11, 0.9999981f), 0.0f), t15) * 2.0f;
    const float t17 = t10 <= t14 ? t14 : 0.0f < t15 ? t15 * t15 / t16 : 0.0f;
    const float t18 = fmaf(0.0f, 0.5f - t17, t17);
    const float t19 = spherecap_min(spherecap_max(t11 * t18 * strength, 1.1754944e-38f), 3.4028235e38f);
    const float t20 = (t11 <= 1.0000019f && 4.9303807e-32f < t11 && t12 && 0.0f < t18) ? t19 : 0.0f;
    return t20;
}


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with the normal.
struct spherecap_front_light {
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
    const float t10 = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37f));
    const float t11 = spherecap_float_of_bits(2130706400.0f - spherecap_bits(t10));
    const float t12 = centre.x * t11;
    const float t13 = centre.y * t11;
    const float t14 = centre.z * t11;
    const float t15 = radius * t11;
    const float t16 = __fmul_rn(t12, t12);
    const float t17 = __fmul_rn(t13, t13);
    const float t18 = __fmul_rn(t14, t14);
    const float t19 = __fadd_rn(t16, t17);
    const float t20 = __fsub_rn(t19, t16);
    const float t21 = __fadd_rn(t19, t18);
    const float t22 = __fsub_rn(t21, t19);
    const float t23 = spherecap_lost(t12, t12, t16) + spherecap_lost(t13, t13, t17) + spherecap_lost(t14, t14, t18);
    const float t24 = __fsub_rn(t16, __fsub_rn(t19, t20)) + __fsub_rn(t17, t20) + (__fsub_rn(t19, __fsub_rn(t21, t22)) + __fsub_rn(t18, t22));
    const float t25 = __fmul_rn(t15, t15);
    const float t26 = t21 - t25 + (t23 + t24 - spherecap_lost(t15, t15, t25));
    const bool t27 = 0.0f < t26;
    const float t28 = sqrtf(t21);
    const float t29 = 1.0f / t28;
    const float t30 = __fmul_rn(normal_x, t12);
    const float t31 = __fmul_rn(normal_y, t13);
    const float t32 = __fmul_rn(normal_z, t14);
    const float t33 = __fadd_rn(t30, t31);
    const float t34 = __fsub_rn(t33, t30);
    const float t35 = __fadd_rn(t33, t32);
    const float t36 = __fsub_rn(t35, t33);
    const float t37 = spherecap_lost(normal_x, t12, t30) + spherecap_lost(normal_y, t13, t31) + spherecap_lost(normal_z, t14, t32);
    const float t38 = __fsub_rn(t30, __fsub_rn(t33, t34)) + __fsub_rn(t31, t34) + (__fsub_rn(t33, __fsub_rn(t35, t36)) + __fsub_rn(t32, t36));
    const float t39 = t37 + t38;
    const float t40 = __fadd_rn(t35, t39);
    const float t41 = __fsub_rn(t39, __fsub_rn(t40, t35));
    const float t42 = t15 - t40 - t41;
    const float t43 = t15 + t40 + t41;
    const float t44 = t42 * t43;
    const bool t45 = 0.0f < t8;
    const bool t46 = 0.0f < t44 && t27 && t45;
    const float t47 = __fmul_rn(normal_z, t13);
    const float t48 = fmaf(normal_y, t14, -t47) - spherecap_lost(normal_z, t13, t47);
    const float t49 = __fmul_rn(normal_x, t14);
    const float t50 = fmaf(normal_z, t12, -t49) - spherecap_lost(normal_x, t14, t49);
    const float t51 = __fmul_rn(normal_y, t12);
    const float t52 = fmaf(normal_x, t13, -t51) - spherecap_lost(normal_y, t12, t51);
    const float t53 = fmaf(t48, t48, fmaf(t50, t50, t52 * t52));
    const bool t54 = 9.8607613e-32f < t53;
    const bool t55 = fabsf(t12) < fabsf(t14);
    const float t56 = t55 ? 0.0f : -t13;
    const float t57 = t55 ? -t14 : t12;
    const float t58 = t55 ? t13 : 0.0f;
    const float t59 = sqrtf(spherecap_max(t26, 0.0f));
    const float radius_cos = t59 * t29;
    const float t60 = 1.0f + radius_cos;
    const float t61 = 1.0f / (t15 * t60);
    const float t62 = t61 * t60;
    const float radius_sin = t15 * t29;
    const float inv_radius_sin = t28 * t62;
    const float t63 = sqrtf(t26 + t44);
    const float t64 = sqrtf(t54 ? t53 : fmaf(t56, t56, fmaf(t57, t57, t58 * t58)));
    const float elevation_sin = t40 * t29;
    const float elevation_cos = (t46 ? t63 : t54 ? t64 : 0.0f) * t29;
    const float t65 = fabsf(elevation_sin);
    const float t66 = radius_sin * elevation_cos;
    const float t67 = spherecap_max(fmaf(radius_cos, t65, t66), 9.8607613e-32f);
    const float t68 = 1.0f / (t67 * t64);
    const float t69 = t68 * t64;
    const float t70 = t68 * t67;
    const float frame_2_x = (t54 ? t48 : t56) * t70;
    const float frame_2_y = (t54 ? t50 : t57) * t70;
    const float frame_2_z = (t54 ? t52 : t58) * t70;
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
    if (t46) {
        const float t71 = sqrtf(t44);
        const float t72 = t63 + t59;
        const float t73 = 1.0f / (t63 * t72);
        const float t74 = t73 * t72;
        const float t75 = t59 * t74;
        const float t76 = t71 * t74;
        const float t77 = fabsf(t40) * t62;
        const float t78 = t77 * t75;
        const float t79 = t75 - 0.5f;
        const float t80 = t78 - 0.5f;
        const float t81 = t79 * t79;
        const float t82 = t80 * t80;
        const float t83 = fmaf(0.05430631f, t81, 0.080950715f);
        const float t84 = fmaf(t83, t81, 0.1684019f);
        const float t85 = fmaf(t84, t81, 0.32709444f);
        const float t86 = fmaf(t85, t81, 0.5987523f);
        const float t87 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t82, t83), t82, t84), t82, t85), t82, t86);
        const float t88 = fmaf(-0.026061837f, t81, -0.06372378f);
        const float t89 = fmaf(t88, t81, -0.11762552f);
        const float t90 = fmaf(t89, t81, -0.23594604f);
        const float t91 = fmaf(t90, t81, -0.44721135f);
        const float t92 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t82, t88), t82, t89), t82, t90), t82, t91);
        const float t93 = fmaf(t91, t81, -0.7754678f);
        const float t94 = fmaf(t93, t79, fmaf(t86, t81, 0.94559944f));
        const float t95 = fmaf(fmaf(t80, t92, t87), t79 + t80, t93);
        const float t96 = fmaf(t78, t95, t94);
        t_x = t75;
        t_y = t76;
        kappa = t77;
        cut = t78;
        shape = t94;
        shape_cut = fmaf(t78 - t75, t95, t94);
        norm = t96;
        width = t44 * t73;
        inv_cut_1 = t66 * t69;
        tau = t71 * t62;
        area = t76 * t76 * t76 * (spherecap_min(t42, t43) * t62) * t96;
    }
    const float t97 = radius_sin * radius_sin;
    const float t98 = elevation_sin < 0.0f ? area : t97 * t65 * 3.1415927f + area;
    const bool t99 = t27 && 9.8607613e-32f < t97;
    const float distance = t28 * t10;
    const float solid_angle = t99 ? t97 * (t61 * t15) * 6.2831855f : 0.0f;
    const float projected_above = (9.403955e-38f < t98 && t99) ? t98 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t100 = 0.0f < inv_above;
    const bool t101 = 0.0f < elevation_sin;
    const float t102 = t101 ? inv_above : 0.0f;
    const float t103 = t100 ? defensive : 0.0f < defensive || !t45 ? 1.0f : 0.0f;
    const bool t104 = 0.0f < tau;
    const bool t105 = t101 && t104 && 0.0f < t102;
    const float t106 = t_y * t_y * t_y * shape * t102;
    const float t107 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    if (!t101 && t104) {
        const float t108 = 1.0f + kappa;
        const float t109 = t108 * shape;
        const float t110 = 1.0f / (norm * t109);
        const float t111 = sqrtf(t110);
        const float t112 = norm * t111;
        const float t113 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t114 = t113 * t113;
        const float t115 = fmaf(fmaf(fmaf(-0.026061837f, t114, -0.06372378f), t114, -0.11762552f), t114, -0.23594604f);
        const float t116 = fmaf(fmaf(fmaf(0.05430631f, t114, 0.080950715f), t114, 0.1684019f), t114, 0.32709444f);
        const float t117 = fmaf(fmaf(fmaf(t115, t114, -0.44721135f), t114, -0.7754678f), t113, fmaf(fmaf(t116, t114, 0.5987523f), t114, 0.94559944f));
        const float t118 = t108 * t117 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t109 * t110);
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
        coefficients_0 = t112;
        coefficients_1 = t118 - t112 + t124;
        coefficients_2 = t127 - t124;
        coefficients_3 = t130 - t127;
        coefficients_4 = t132 - t130;
        coefficients_5 = t133 - t132;
        coefficients_6 = -t133;
    }
    const bool t134 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f;
    const bool t135 = t134 && (t100 || (0.0f < t103 && 0.0f < solid_angle));
    spherecap_front_light light;
    light.is_sampled = t135;
    light.solid_angle = t135 ? solid_angle : 0.0f;
    light.projected_solid_angle = t135 ? projected_above : 0.0f;
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
    light.inv_solid_angle = t99 ? t60 * (inv_radius_sin * inv_radius_sin) * 0.15915494f : 0.0f;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t44 * (t29 * t29) * t69, -(radius_cos * t65));
    light.defensive = t103;
    light.requested = defensive;
    light.inv_above = inv_above;
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
    float t53 = 0.0f;
    float t54 = 0.0f;
    float t55 = 0.0f;
    if (t9) {
        const float t56 = t16 < 0.0f ? t49 : t50;
        float t57 = 0.0f;
        float t58 = 0.0f;
        float t59 = 0.0f;
        if (t5) {
            const float t60 = light.solid_angle * 0.15915494f;
            const float t61 = t60 * (1.0f - t51 * t12);
            const float t62 = sqrtf(t60 * (2.0f - t61));
            const float t63 = (t56 - 1.0f) * t62;
            t57 = t63;
            t58 = t52 * t11 * t62;
            t59 = fmaf(light.elevation_sin, 1.0f - t61, light.elevation_cos * t63);
        } else {
            const float t64 = light.radius_sin * light.elevation_cos;
            const float t65 = 1.0f - t56;
            const float t66 = t51 * t12;
            const float t67 = spherecap_max(fmaf(t64, t56, -light.rise), 0.0f);
            const float t68 = sqrtf(fmaf(t67, t67, light.radius_sin * light.radius_sin * t66));
            const float t69 = t1 * light.radius_cos;
            const float t70 = fmaf(light.elevation_cos * t65, fmaf(t64, t65, -2.0f * t69), light.radius_sin * t66);
            const float t71 = light.radius_sin * fmaf(light.elevation_cos, t70 / (t68 + t69), -(t1 * t1 * t65));
            t57 = t71;
            t58 = light.radius_sin * t52 * t11;
            t59 = t68;
        }
        t53 = t57;
        t54 = t58;
        t55 = t59;
    } else {
        const float t72 = t52 * t16;
        t53 = fmaf(light.elevation_cos, t72, -((t2 ? t1 : -t1) * (1.0f - t49)));
        t54 = t52 * t11;
        t55 = t72;
    }
    const float t73 = spherecap_min(fabsf(t55), 3.4028235e38f);
    const float t74 = 0.0f < t55 ? light.inv_above : 0.0f;
    float t75 = 0.0f;
    float t76 = 0.0f;
    if (0.0f < light.defensive) {
        const float t77 = light.defensive * light.inv_solid_angle;
        const float t78 = fmaf(t74, t6, spherecap_min(t77 / spherecap_max(t73, 1.1754944e-38f), 3.4028235e38f));
        t75 = fmaf(t74, t6 * t73, t77);
        t76 = spherecap_min(t78, 3.4028235e38f);
    } else {
        t75 = t74 * t73;
        t76 = t74;
    }
    const float t79 = fmaf(t53, t53, t54 * t54);
    const float t80 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t79), 0.0f);
    const float t81 = sqrtf(t80);
    const float t82 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t80));
    const float t83 = light.radius_cos * light.radius_cos / (t82 + t81);
    const float t84 = fmaf(light.frame_0_x, t82, fmaf(light.frame_1_x, t53, light.frame_2_x * t54));
    const float t85 = fmaf(light.frame_0_y, t82, fmaf(light.frame_1_y, t53, light.frame_2_y * t54));
    const float t86 = fmaf(light.frame_0_z, t82, fmaf(light.frame_1_z, t53, light.frame_2_z * t54));
    const float t87 = t83 * light.inv_radius_sin;
    const float t88 = -fmaf(t82, t81, t79) * light.inv_radius_sin;
    const float t89 = t87 * t53;
    const float t90 = t87 * t54;
    const float t91 = fmaf(light.frame_0_x, t88, fmaf(light.frame_1_x, t89, light.frame_2_x * t90));
    const float t92 = fmaf(light.frame_0_y, t88, fmaf(light.frame_1_y, t89, light.frame_2_y * t90));
    const float t93 = fmaf(light.frame_0_z, t88, fmaf(light.frame_1_z, t89, light.frame_2_z * t90));
    spherecap_sample sampled;
    sampled.direction = make_float3(t84, t85, t86);
    sampled.distance = t83 * light.distance;
    sampled.normal = make_float3(t91, t92, t93);
    sampled.cosine = t55;
    sampled.pdf = t75;
    sampled.projected_pdf = t76;
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
    const float t1 = fmaf(light.frame_0_x, direction.x, fmaf(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    const float t2 = fmaf(light.frame_1_x, direction.x, fmaf(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    const float t3 = fmaf(light.frame_2_x, direction.x, fmaf(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    const float t4 = fmaf(light.normal_x, direction.x, fmaf(light.normal_y, direction.y, light.normal_z * direction.z));
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
    const float t1 = fmaf(light.normal_x, direction.x, fmaf(light.normal_y, direction.y, light.normal_z * direction.z));
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
    const float t12 = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37f));
    const float t13 = spherecap_float_of_bits(2130706400.0f - spherecap_bits(t12));
    const float t14 = centre.x * t13;
    const float t15 = centre.y * t13;
    const float t16 = centre.z * t13;
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
    const float t27 = fmaf(t20 - t25, spherecap_max(fmaf(-t21, t21, 0.9999981f), 0.0f), t26) * 2.0f;
    const float t28 = t20 <= t25 ? t25 : 0.0f < t26 ? t26 * t26 / t27 : 0.0f;
    const float t29 = t22 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t28, t28);
    const bool t30 = t21 <= 1.0000019f && 4.9303807e-32f < t21 && t23 && 0.0f < strength && strength <= 3.4028235e38f;
    const float t31 = spherecap_min(spherecap_max(t21 * t29 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (t30 && (0.0f < t29 || 0.0f < defensive)) ? t31 : 0.0f;
}


// The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.
struct spherecap_both_light {
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
    const float t10 = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37f));
    const float t11 = spherecap_float_of_bits(2130706400.0f - spherecap_bits(t10));
    const float t12 = centre.x * t11;
    const float t13 = centre.y * t11;
    const float t14 = centre.z * t11;
    const float t15 = radius * t11;
    const float t16 = __fmul_rn(t12, t12);
    const float t17 = __fmul_rn(t13, t13);
    const float t18 = __fmul_rn(t14, t14);
    const float t19 = __fadd_rn(t16, t17);
    const float t20 = __fsub_rn(t19, t16);
    const float t21 = __fadd_rn(t19, t18);
    const float t22 = __fsub_rn(t21, t19);
    const float t23 = spherecap_lost(t12, t12, t16) + spherecap_lost(t13, t13, t17) + spherecap_lost(t14, t14, t18);
    const float t24 = __fsub_rn(t16, __fsub_rn(t19, t20)) + __fsub_rn(t17, t20) + (__fsub_rn(t19, __fsub_rn(t21, t22)) + __fsub_rn(t18, t22));
    const float t25 = __fmul_rn(t15, t15);
    const float t26 = t21 - t25 + (t23 + t24 - spherecap_lost(t15, t15, t25));
    const bool t27 = 0.0f < t26;
    const float t28 = sqrtf(t21);
    const float t29 = 1.0f / t28;
    const float t30 = __fmul_rn(normal_x, t12);
    const float t31 = __fmul_rn(normal_y, t13);
    const float t32 = __fmul_rn(normal_z, t14);
    const float t33 = __fadd_rn(t30, t31);
    const float t34 = __fsub_rn(t33, t30);
    const float t35 = __fadd_rn(t33, t32);
    const float t36 = __fsub_rn(t35, t33);
    const float t37 = spherecap_lost(normal_x, t12, t30) + spherecap_lost(normal_y, t13, t31) + spherecap_lost(normal_z, t14, t32);
    const float t38 = __fsub_rn(t30, __fsub_rn(t33, t34)) + __fsub_rn(t31, t34) + (__fsub_rn(t33, __fsub_rn(t35, t36)) + __fsub_rn(t32, t36));
    const float t39 = t37 + t38;
    const float t40 = __fadd_rn(t35, t39);
    const float t41 = __fsub_rn(t39, __fsub_rn(t40, t35));
    const float t42 = t15 - t40 - t41;
    const float t43 = t15 + t40 + t41;
    const float t44 = t42 * t43;
    const bool t45 = 0.0f < t8;
    const bool t46 = 0.0f < t44 && t27 && t45;
    const float t47 = __fmul_rn(normal_z, t13);
    const float t48 = fmaf(normal_y, t14, -t47) - spherecap_lost(normal_z, t13, t47);
    const float t49 = __fmul_rn(normal_x, t14);
    const float t50 = fmaf(normal_z, t12, -t49) - spherecap_lost(normal_x, t14, t49);
    const float t51 = __fmul_rn(normal_y, t12);
    const float t52 = fmaf(normal_x, t13, -t51) - spherecap_lost(normal_y, t12, t51);
    const float t53 = fmaf(t48, t48, fmaf(t50, t50, t52 * t52));
    const bool t54 = 9.8607613e-32f < t53;
    const bool t55 = fabsf(t12) < fabsf(t14);
    const float t56 = t55 ? 0.0f : -t13;
    const float t57 = t55 ? -t14 : t12;
    const float t58 = t55 ? t13 : 0.0f;
    const float t59 = sqrtf(spherecap_max(t26, 0.0f));
    const float radius_cos = t59 * t29;
    const float t60 = 1.0f + radius_cos;
    const float t61 = 1.0f / (t15 * t60);
    const float t62 = t61 * t60;
    const float radius_sin = t15 * t29;
    const float inv_radius_sin = t28 * t62;
    const float t63 = sqrtf(t26 + t44);
    const float t64 = sqrtf(t54 ? t53 : fmaf(t56, t56, fmaf(t57, t57, t58 * t58)));
    const float elevation_sin = t40 * t29;
    const float elevation_cos = (t46 ? t63 : t54 ? t64 : 0.0f) * t29;
    const float t65 = fabsf(elevation_sin);
    const float t66 = radius_sin * elevation_cos;
    const float t67 = spherecap_max(fmaf(radius_cos, t65, t66), 9.8607613e-32f);
    const float t68 = 1.0f / (t67 * t64);
    const float t69 = t68 * t64;
    const float t70 = t68 * t67;
    const float frame_2_x = (t54 ? t48 : t56) * t70;
    const float frame_2_y = (t54 ? t50 : t57) * t70;
    const float frame_2_z = (t54 ? t52 : t58) * t70;
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
    if (t46) {
        const float t71 = sqrtf(t44);
        const float t72 = t63 + t59;
        const float t73 = 1.0f / (t63 * t72);
        const float t74 = t73 * t72;
        const float t75 = t59 * t74;
        const float t76 = t71 * t74;
        const float t77 = fabsf(t40) * t62;
        const float t78 = t77 * t75;
        const float t79 = t75 - 0.5f;
        const float t80 = t78 - 0.5f;
        const float t81 = t79 * t79;
        const float t82 = t80 * t80;
        const float t83 = fmaf(0.05430631f, t81, 0.080950715f);
        const float t84 = fmaf(t83, t81, 0.1684019f);
        const float t85 = fmaf(t84, t81, 0.32709444f);
        const float t86 = fmaf(t85, t81, 0.5987523f);
        const float t87 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t82, t83), t82, t84), t82, t85), t82, t86);
        const float t88 = fmaf(-0.026061837f, t81, -0.06372378f);
        const float t89 = fmaf(t88, t81, -0.11762552f);
        const float t90 = fmaf(t89, t81, -0.23594604f);
        const float t91 = fmaf(t90, t81, -0.44721135f);
        const float t92 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t82, t88), t82, t89), t82, t90), t82, t91);
        const float t93 = fmaf(t91, t81, -0.7754678f);
        const float t94 = fmaf(t93, t79, fmaf(t86, t81, 0.94559944f));
        const float t95 = fmaf(fmaf(t80, t92, t87), t79 + t80, t93);
        const float t96 = fmaf(t78, t95, t94);
        t_x = t75;
        t_y = t76;
        kappa = t77;
        cut = t78;
        shape = t94;
        shape_cut = fmaf(t78 - t75, t95, t94);
        norm = t96;
        width = t44 * t73;
        inv_cut_1 = t66 * t69;
        tau = t71 * t62;
        area = t76 * t76 * t76 * (spherecap_min(t42, t43) * t62) * t96;
    }
    const float t97 = radius_sin * radius_sin;
    const float t98 = t97 * t65 * 3.1415927f + area;
    const bool t99 = elevation_sin < 0.0f;
    const float t100 = t99 ? area : t98;
    const float t101 = t99 ? t98 : area;
    const bool t102 = t27 && 9.8607613e-32f < t97;
    const float distance = t28 * t10;
    const float solid_angle = t102 ? t97 * (t61 * t15) * 6.2831855f : 0.0f;
    const float projected_above = (9.403955e-38f < t100 && t102) ? t100 : 0.0f;
    const float projected_below = (9.403955e-38f < t101 && t102) ? t101 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float inv_below = 0.0f < projected_below ? 1.0f / projected_below : 0.0f;
    const bool t103 = 0.0f < inv_above + inv_below;
    const bool t104 = 0.0f < elevation_sin;
    const float t105 = t104 ? inv_above : inv_below;
    const float t106 = t103 ? defensive : 0.0f < defensive || !t45 ? 1.0f : 0.0f;
    const bool t107 = 0.0f < tau;
    const bool t108 = t107 && 0.0f < t105;
    const float t109 = t_y * t_y * t_y * shape * t105;
    const float t110 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0f;
    float coefficients_1 = 0.0f;
    float coefficients_2 = 0.0f;
    float coefficients_3 = 0.0f;
    float coefficients_4 = 0.0f;
    float coefficients_5 = 0.0f;
    float coefficients_6 = 0.0f;
    float t111 = 0.0f;
    if (t107) {
        const float t112 = 1.0f + kappa;
        const float t113 = t112 * shape;
        const float t114 = 1.0f / (norm * t113);
        const float t115 = sqrtf(t114);
        const float t116 = norm * t115;
        const float t117 = (t_x + kappa) * inv_cut_1 - 0.5f;
        const float t118 = t117 * t117;
        const float t119 = fmaf(fmaf(fmaf(-0.026061837f, t118, -0.06372378f), t118, -0.11762552f), t118, -0.23594604f);
        const float t120 = fmaf(fmaf(fmaf(0.05430631f, t118, 0.080950715f), t118, 0.1684019f), t118, 0.32709444f);
        const float t121 = fmaf(fmaf(fmaf(t119, t118, -0.44721135f), t118, -0.7754678f), t117, fmaf(fmaf(t120, t118, 0.5987523f), t118, 0.94559944f));
        const float t122 = t112 * t121 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t113 * t114);
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
        const float t138 = 1.0f / (elevation_cos * elevation_cos);
        const float t139 = tau * tau;
        const float t140 = t139 * t138 / (1.0f + t_x);
        const float t141 = kappa - 0.5f;
        const float t142 = cut - 0.5f;
        const float t143 = t141 * t141;
        const float t144 = t142 * t142;
        const float t145 = fmaf(0.05430631f, t143, 0.080950715f);
        const float t146 = fmaf(t145, t143, 0.1684019f);
        const float t147 = fmaf(t146, t143, 0.32709444f);
        const float t148 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t144, t145), t144, t146), t144, t147), t144, fmaf(t147, t143, 0.5987523f));
        const float t149 = fmaf(-0.026061837f, t143, -0.06372378f);
        const float t150 = fmaf(t149, t143, -0.11762552f);
        const float t151 = fmaf(t150, t143, -0.23594604f);
        const float t152 = fmaf(t151, t143, -0.44721135f);
        const float t153 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t144, t149), t144, t150), t144, t151), t144, t152);
        const float t154 = fmaf(kappa * t140, fmaf(fmaf(t142, t153, t148), t141 + t142, fmaf(t152, t143, -0.7754678f)), fmaf(shape_cut, t140 - kappa * kappa, kappa) * t138);
        const float t155 = spherecap_max(t139 * tau * (radius_cos + 1.0f) * t154 * 0.31830987f, 0.0f);
        coefficients_0 = t116;
        coefficients_1 = t122 - t116 + t128;
        coefficients_2 = t131 - t128;
        coefficients_3 = t134 - t131;
        coefficients_4 = t136 - t134;
        coefficients_5 = t137 - t136;
        coefficients_6 = -t137;
        t111 = spherecap_min(t155, 0.5f);
    }
    const float share_above = 0.0f < inv_below ? (0.0f < inv_above ? (t104 ? 1.0f - t111 : t111) : 0.0f) : 1.0f;
    const bool t156 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f;
    const bool t157 = t156 && (t103 || (0.0f < t106 && 0.0f < solid_angle));
    spherecap_both_light light;
    light.is_sampled = t157;
    light.solid_angle = t157 ? solid_angle : 0.0f;
    light.projected_solid_angle = t157 ? projected_above : 0.0f;
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
    light.inv_solid_angle = t102 ? t60 * (inv_radius_sin * inv_radius_sin) * 0.15915494f : 0.0f;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t44 * (t29 * t29) * t69, -(radius_cos * t65));
    light.defensive = t106;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
    light.crescent_share = t108 ? t109 : 0.0f;
    light.inv_rest = t108 ? 1.0f / (1.0f - t109) : 1.0f;
    light.beyond = t108 ? t110 * t110 * t110 * shape_cut : 0.0f;
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
    float t60 = 0.0f;
    float t61 = 0.0f;
    if (t14) {
        const float t62 = t21 < 0.0f ? t55 : t56;
        float t63 = 0.0f;
        float t64 = 0.0f;
        float t65 = 0.0f;
        if (t5) {
            const float t66 = light.solid_angle * 0.15915494f;
            const float t67 = t66 * (1.0f - t57 * t17);
            const float t68 = sqrtf(t66 * (2.0f - t67));
            const float t69 = (t62 - 1.0f) * t68;
            t63 = t69;
            t64 = t58 * t16 * t68;
            t65 = fmaf(light.elevation_sin, 1.0f - t67, light.elevation_cos * t69);
        } else {
            const float t70 = light.radius_sin * light.elevation_cos;
            const float t71 = 1.0f - t62;
            const float t72 = t57 * t17;
            const float t73 = spherecap_max(fmaf(t70, t62, -light.rise), 0.0f);
            const float t74 = sqrtf(fmaf(t73, t73, light.radius_sin * light.radius_sin * t72));
            const float t75 = t1 * light.radius_cos;
            const float t76 = fmaf(light.elevation_cos * t71, fmaf(t70, t71, -2.0f * t75), light.radius_sin * t72);
            const float t77 = light.radius_sin * fmaf(light.elevation_cos, t76 / (t74 + t75), -(t1 * t1 * t71));
            t63 = t77;
            t64 = light.radius_sin * t58 * t16;
            t65 = t74;
        }
        t59 = t63;
        t60 = t64;
        t61 = t65;
    } else {
        const float t78 = t58 * t21;
        t59 = fmaf(light.elevation_cos, t78, -((t12 ? t1 : -t1) * (1.0f - t55)));
        t60 = t58 * t16;
        t61 = t78;
    }
    const float t79 = t9 ? 1.0f : -1.0f;
    const float t80 = t59 * t79;
    const float t81 = t61 * t79;
    const float t82 = spherecap_min(fabsf(t81), 3.4028235e38f);
    const float t83 = 0.0f < t81 ? light.inv_above * light.share_above : t81 < 0.0f ? light.inv_below * t10 : 0.0f;
    float t84 = 0.0f;
    float t85 = 0.0f;
    if (0.0f < light.defensive) {
        const float t86 = light.defensive * light.inv_solid_angle;
        const float t87 = fmaf(t83, t6, spherecap_min(t86 / spherecap_max(t82, 1.1754944e-38f), 3.4028235e38f));
        t84 = fmaf(t83, t6 * t82, t86);
        t85 = spherecap_min(t87, 3.4028235e38f);
    } else {
        t84 = t83 * t82;
        t85 = t83;
    }
    const float t88 = fmaf(t80, t80, t60 * t60);
    const float t89 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t88), 0.0f);
    const float t90 = sqrtf(t89);
    const float t91 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t89));
    const float t92 = light.radius_cos * light.radius_cos / (t91 + t90);
    const float t93 = fmaf(light.frame_0_x, t91, fmaf(light.frame_1_x, t80, light.frame_2_x * t60));
    const float t94 = fmaf(light.frame_0_y, t91, fmaf(light.frame_1_y, t80, light.frame_2_y * t60));
    const float t95 = fmaf(light.frame_0_z, t91, fmaf(light.frame_1_z, t80, light.frame_2_z * t60));
    const float t96 = t92 * light.inv_radius_sin;
    const float t97 = -fmaf(t91, t90, t88) * light.inv_radius_sin;
    const float t98 = t96 * t80;
    const float t99 = t96 * t60;
    const float t100 = fmaf(light.frame_0_x, t97, fmaf(light.frame_1_x, t98, light.frame_2_x * t99));
    const float t101 = fmaf(light.frame_0_y, t97, fmaf(light.frame_1_y, t98, light.frame_2_y * t99));
    const float t102 = fmaf(light.frame_0_z, t97, fmaf(light.frame_1_z, t98, light.frame_2_z * t99));
    spherecap_sample sampled;
    sampled.direction = make_float3(t93, t94, t95);
    sampled.distance = t92 * light.distance;
    sampled.normal = make_float3(t100, t101, t102);
    sampled.cosine = t81;
    sampled.pdf = t84;
    sampled.projected_pdf = t85;
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
    const float t1 = fmaf(light.frame_0_x, direction.x, fmaf(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    const float t2 = fmaf(light.frame_1_x, direction.x, fmaf(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    const float t3 = fmaf(light.frame_2_x, direction.x, fmaf(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    const float t4 = fmaf(light.normal_x, direction.x, fmaf(light.normal_y, direction.y, light.normal_z * direction.z));
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
    const float t1 = fmaf(light.normal_x, direction.x, fmaf(light.normal_y, direction.y, light.normal_z * direction.z));
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
    const float t12 = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37f));
    const float t13 = spherecap_float_of_bits(2130706400.0f - spherecap_bits(t12));
    const float t14 = centre.x * t13;
    const float t15 = centre.y * t13;
    const float t16 = centre.z * t13;
    const float t17 = radius * t13;
    const float t18 = sqrtf(fmaf(t14, t14, fmaf(t15, t15, t16 * t16)));
    const float t19 = 1.0f / t18;
    const float t20 = t17 * t19;
    const float t21 = t20 * t20;
    const float t22 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t23 = 0.0f <= defensive && defensive <= 1.0f && t22 <= 2.0f && 0.0f < radius && t18 * t12 <= 3.4028235e38f;
    const float t24 = fmaf(t2, t14, fmaf(t3, t15, t4 * t16));
    const float t25 = spherecap_max(fmaf(-t21, t21, 0.9999981f), 0.0f);
    const float t26 = fmaf(t24, t19, 2.3841858e-7f);
    const float t27 = fmaf(t24 + t17, t19, 2.3841858e-7f);
    const float t28 = t20 <= t26 ? t26 : 0.0f < t27 ? t27 * t27 / (fmaf(t20 - t26, t25, t27) * 2.0f) : 0.0f;
    const float t29 = fmaf(-t24, t19, 2.3841858e-7f);
    const float t30 = fmaf(-t24 + t17, t19, 2.3841858e-7f);
    const float t31 = t20 <= t29 ? t29 : 0.0f < t30 ? t30 * t30 / (fmaf(t20 - t29, t25, t30) * 2.0f) : 0.0f;
    const float t32 = t28 + t31;
    const float t33 = t22 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t32, t32);
    const bool t34 = t21 <= 1.0000019f && 4.9303807e-32f < t21 && t23 && 0.0f < strength && strength <= 3.4028235e38f;
    const float t35 = spherecap_min(spherecap_max(t21 * t33 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (t34 && (0.0f < t33 || 0.0f < defensive)) ? t35 : 0.0f;
}


#endif
