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
    const spherecap_sample result = {
        make_float3(0.0f, 0.0f, 0.0f), 0.0f, make_float3(0.0f, 0.0f, 0.0f), 0.0f, 0.0f, 0.0f
    };
    return result;
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
    float b_0;
    float b_1;
    float b_2;
    float b_3;
    float b_4;
    float b_5;
    float b_6;
};

static __device__ inline spherecap_surface_light spherecap_surface_prepare(float3 normal, float3 centre, float radius) {
    const bool t1 = fmaf(centre.x, centre.x, fmaf(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0f;
    const bool t2 = 9.536743e-7f < radius && t1;
    const float t3 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t3, 8.5070587e37f));
    const float t4 = t2 ? 1.0f : spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t5 = centre.x * t4;
    const float t6 = centre.y * t4;
    const float t7 = centre.z * t4;
    const float t8 = radius * t4;
    const float t9 = __fmul_rn(t7, t7);
    const float t10 = fmaf(t5, t5, fmaf(t6, t6, t9));
    const float t11 = fmaf(-t8, t8, t10);
    float t12, t13;
    if (t11 < t10 * 0.25f) {
        const float t14 = __fmul_rn(t5, t5);
        const float t15 = __fmul_rn(t6, t6);
        const float t16 = __fadd_rn(t14, t15);
        const float t17 = __fsub_rn(t16, t14);
        t12 = __fadd_rn(t16, t9);
        const float t18 = __fsub_rn(t12, t16);
        const float t19 = spherecap_lost(t5, t5, t14) + spherecap_lost(t6, t6, t15) + spherecap_lost(t7, t7, t9);
        const float t20 = __fsub_rn(t14, __fsub_rn(t16, t17)) + __fsub_rn(t15, t17) + (__fsub_rn(t16, __fsub_rn(t12, t18)) + __fsub_rn(t9, t18));
        t13 = fmaf(-t8, t8, t12) + (t19 + t20);
    } else {
        t12 = t10;
        t13 = t11;
    }
    const float t21 = __fmul_rn(normal.z, t6);
    const float t22 = fmaf(normal.y, t7, -t21);
    const float t23 = __fmul_rn(normal.x, t7);
    const float t24 = fmaf(normal.z, t5, -t23);
    const float t25 = __fmul_rn(normal.y, t5);
    const float t26 = fmaf(normal.x, t6, -t25);
    const float t27 = fmaf(t22, t22, fmaf(t24, t24, t26 * t26));
    float t28, t29, t30, t31, t32;
    if (t27 < t12 * 0.015625f) {
        const float t33 = t22 - spherecap_lost(normal.z, t6, t21);
        const float t34 = t24 - spherecap_lost(normal.x, t7, t23);
        const float t35 = t26 - spherecap_lost(normal.y, t5, t25);
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
    const float t43 = __fmul_rn(normal.x, t5);
    const float t44 = __fmul_rn(normal.y, t6);
    const float t45 = __fmul_rn(normal.z, t7);
    const float t46 = __fadd_rn(t43, t44);
    const float t47 = __fsub_rn(t46, t43);
    const float t48 = __fadd_rn(t46, t45);
    const float t49 = __fsub_rn(t48, t46);
    const float t50 = spherecap_lost(normal.x, t5, t43) + spherecap_lost(normal.y, t6, t44) + spherecap_lost(normal.z, t7, t45);
    const float t51 = __fsub_rn(t43, __fsub_rn(t46, t47)) + __fsub_rn(t44, t47) + (__fsub_rn(t46, __fsub_rn(t48, t49)) + __fsub_rn(t45, t49));
    const float t52 = t50 + t51;
    const float t53 = __fadd_rn(t48, t52);
    const float t54 = __fsub_rn(t52, __fsub_rn(t53, t48));
    const float t55 = t8 - t53 - t54;
    const float t56 = t8 + t53 + t54;
    const float t57 = t55 * t56;
    const float t58 = sqrtf(t12);
    const float t59 = 1.0f / t58;
    const float t60 = sqrtf(t13);
    const float elevation_sin = t53 * t59;
    const bool t61 = 0.0f < t13;
    const bool t62 = 0.0f < t57 && t61;
    const bool t63 = 0.0f < elevation_sin;
    float t64;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (t62) {
        t64 = sqrtf(t13 + t57);
        const float t65 = sqrtf(t57);
        const float t66 = 1.0f / (t64 * t8);
        const float t67 = t66 * t8;
        const float t68 = t66 * t64;
        t_x = t60 * t67;
        t_y = t65 * t67;
        const float t69 = t_y * t_y;
        kappa = fabsf(t53) * t68;
        cut = kappa * t_x;
        const float t70 = t_x - 0.5f;
        const float t71 = cut - 0.5f;
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
        shape = fmaf(t84, t70, fmaf(t77, t72, 0.94559944f));
        shape_difference = fmaf(fmaf(t71, t83, t78), t70 + t71, t84);
        norm = fmaf(cut, shape_difference, shape);
        width = t69 / (1.0f + t_x);
        tau = t65 * t68;
        area = t69 * t_y * (spherecap_min(t55, t56) * t68) * norm;
    } else {
        t64 = t32;
    }
    const float radius_sin = t8 * t59;
    const float radius_cos = t60 * t59;
    const float elevation_cos = t64 * t59;
    const float t85 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t57 * (t59 * t59) / fmaf(radius_cos, t85, climb), -(radius_cos * t85));
    const float t86 = radius_sin * radius_sin;
    const float t87 = t63 ? fmaf(t86 * t85, 3.1415927f, area) : area;
    const bool t88 = 9.8607613e-32f < t86;
    const float t89 = 1.0f / t31;
    const float sideways_x = t28 * t89;
    const float sideways_y = t29 * t89;
    const float sideways_z = t30 * t89;
    const float distance = t58 * (t2 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t87 && t88 && t61) ? t87 : 0.0f;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float t90 = t63 ? inv_above : 0.0f;
    const bool t91 = t62 && t63 && 0.0f < t90;
    const float t92 = t_y * t_y * t_y * shape * t90;
    const float t93 = t_y / radius_sin;
    const float t94 = t93 * t93 * t93 * (fmaf(cut - t_x, shape_difference, shape) * 0.53033006f);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t62 && !t63) {
        const float t95 = 1.0f + kappa;
        const float t96 = t95 * shape;
        const float t97 = 1.0f / (norm * t96);
        const float t98 = sqrtf(t97);
        b_0 = norm * t98;
        const float t99 = 1.0f / (1.0f + cut);
        const float t100 = (t_x + kappa) * t99 - 0.5f;
        const float t101 = t100 * t100 * t100;
        const float t102 = fmaf(fmaf(fmaf(-0.026061837f, t100, 0.05430631f), t100, -0.06372378f), t101, fmaf(fmaf(0.080950715f, t100, -0.11762552f), t100, 0.1684019f));
        const float t103 = fmaf(t102, t101, fmaf(fmaf(-0.23594604f, t100, 0.32709444f), t100, -0.44721135f));
        const float t104 = fmaf(t103, t101, fmaf(fmaf(0.5987523f, t100, -0.7754678f), t100, 0.94559944f));
        const float t105 = t95 * t104 * (t99 * t99 * t99) * (t96 * t97);
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
        b_1 = t105 - b_0 + t111;
        b_2 = t114 - t111;
        b_3 = t117 - t114;
        b_4 = t119 - t117;
        b_5 = t120 - t119;
        b_6 = -t120;
    }
    const bool t121 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < inv_above;
    const float t122 = ((0.0f < radius_cos && t88) ? t86 / (1.0f + radius_cos) : 0.0f) * 6.2831855f;
    const spherecap_surface_light result = {
        t121, t121 ? t122 : 0.0f, t121 ? projected_above : 0.0f, make_float3(t5 * t59, t6 * t59, t7 * t59),
        make_float3(sideways_x, sideways_y, sideways_z), normal, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, inv_above,
        make_float3(fmaf(sideways_y, normal.z, -(sideways_z * normal.y)), fmaf(sideways_z, normal.x, -(sideways_x * normal.z)), fmaf(sideways_x, normal.y, -(sideways_y * normal.x))),
        t91 ? t92 : 0.0f, t91 ? 1.0f / (1.0f - t92) : 1.0f, t91 ? t94 : 0.0f, elevation_cos * radius_cos,
        radius_sin * t85, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

static __device__ inline spherecap_sample spherecap_surface_sample(spherecap_surface_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = fabsf(light.elevation_sin);
    const bool t2 = 0.0f < light.tau;
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = !(0.0f < light.elevation_sin) && t2;
    const bool t6 = light.crescent_share <= t3 && !t5;
    const bool t7 = !t2 || t6;
    const float t8 = 1.0f - t4;
    const float t9 = t4 - t8;
    const float t10 = 4.0f * t4 * t8;
    const float t11 = spherecap_max((t3 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t12 = t2 ? spherecap_min(t11, 0.99999994f) : t3;
    const float t13 = t2 ? light.beyond : 0.0f;
    const float t14 = 1.6660811f - t13;
    const float t15 = fmaf(t12, t14, t13);
    const float t16 = (1.0f - t12) * t14;
    float t18, t19, t20;
    float t17 = 0.0f;
    if (t7) {
        t18 = spherecap_min(t15, t16);
        t19 = 1.0f;
        t20 = 1.0f;
    } else {
        const float t21 = sqrtf(t10);
        const float t22 = fmaf(fmaf(fmaf(light.b_6, t10, light.b_4), t10, light.b_2), t10, light.b_0);
        const float t23 = t21 * fmaf(fmaf(fmaf(light.b_5, t10, light.b_3), t10, light.b_1), t21, t22);
        const float t24 = sqrtf(fmaf(t9, t9, t23 * t23));
        const float t25 = light.tau * t23;
        t20 = t5 ? fmaf(t9, t9, t25 * t25) : 1.0f;
        const float t26 = t5 ? fmaf(light.kappa, t23, t24) * fmaf(light.cut, t23, t24) : light.crescent_share;
        const float t27 = (t5 ? light.width : t3) / t26;
        const float t28 = t5 ? t27 : light.width;
        const float t29 = t20 * t28;
        const float t30 = fmaf(fmaf(fmaf(-0.00060778117f, t29, 1.0676054e-5f), t29, -0.0027203285f), t29 * t29 * t29, fmaf(fmaf(-0.011332183f, t29, -0.10000902f), t29, 1.0000001f));
        t17 = t5 ? t25 : t21;
        t18 = t5 ? t3 : spherecap_min(spherecap_max(t27, 5.9604645e-8f), 0.99999994f);
        t19 = t28 * t30;
    }
    const float t31 = spherecap_float_of_bits(fmaf(spherecap_bits(t18), -0.33333334f, 1419900500.0f));
    const float t32 = t18 * t31;
    const float t33 = fmaf(-t32, t31 * t31, 1.0f);
    const float t34 = t33 * t33;
    const float t35 = fmaf(fmaf(0.12666093f, t34, fmaf(0.14565912f, t33, 0.17283025f)), t34, fmaf(0.22221696f, t33, 0.33333334f));
    const float t36 = t19 * fmaf(t32 * t33, t35, t32);
    const float t37 = t36 * t20;
    const float t38 = t37 * t37 * t37;
    const float t39 = fmaf(fmaf(fmaf(0.022114987f, t37, -0.063446075f), t37, 0.085662976f), t38, fmaf(fmaf(-0.056249518f, t37, 0.030445365f), t37, 0.0074712755f));
    const float t40 = fmaf(t39, t38, fmaf(fmaf(0.03209764f, t37, 0.09996679f), t37, 1.0000004f));
    const float t41 = t36 * t40;
    const float t42 = t7 ? spherecap_min(t41, 1.0f) : t41;
    const float t43 = t20 * t42;
    const float t44 = 2.0f - t43;
    const float t45 = t42 * t44;
    const float t46 = sqrtf(t45);
    float zenith, side, cosine, t47;
    if (t7) {
        const float t48 = t15 - t16 < 0.0f ? t43 : t44;
        const float t49 = 1.0f - t48;
        const float t50 = light.radius_sin * light.radius_sin * t10;
        const float t51 = spherecap_max(fmaf(light.climb, t48, -light.rise), 0.0f);
        cosine = sqrtf(fmaf(t45, t50, t51 * t51));
        const float t52 = t1 * light.radius_cos;
        const float t53 = light.climb * t49;
        zenith = fmaf(light.elevation_cos, fmaf(t53, t53 - 2.0f * t52, t45 * t50) / (cosine + t52), -(light.half_axis * t1 * t49));
        side = light.radius_sin * t46 * t9;
        t47 = fmaf(light.half_axis, t49, light.middle);
    } else {
        cosine = t46 * t17;
        t47 = 1.0f - t43;
        zenith = fmaf(light.elevation_cos, cosine, -((t5 ? -t1 : t1) * t47));
        side = t46 * t9;
    }
    const float t54 = light.inv_above * spherecap_min(spherecap_max(cosine, 0.0f), 3.4028235e38f);
    const float t55 = fmaf(zenith, zenith, side * side);
    const float t56 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t55), 0.0f);
    const float t57 = sqrtf(t56);
    const float t58 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t56));
    const float t59 = light.radius_cos * light.radius_cos / (t58 + t57);
    const float t60 = 1.0f / light.radius_sin;
    const float t61 = t59 * t60;
    const float t62 = -fmaf(t58, t57, t55) * t60;
    const float t63 = t61 * zenith;
    const float t64 = t61 * side;
    const float t65 = fmaf(light.third_axis.x, t47, fmaf(light.sideways.x, side, light.normal.x * cosine));
    const float t66 = fmaf(light.third_axis.y, t47, fmaf(light.sideways.y, side, light.normal.y * cosine));
    const float t67 = fmaf(light.third_axis.z, t47, fmaf(light.sideways.z, side, light.normal.z * cosine));
    const float t68 = fmaf(light.elevation_cos, t62, -(light.elevation_sin * t63));
    const float t69 = fmaf(light.elevation_sin, t62, light.elevation_cos * t63);
    const float t70 = fmaf(light.third_axis.x, t68, fmaf(light.sideways.x, t64, light.normal.x * t69));
    const float t71 = fmaf(light.third_axis.y, t68, fmaf(light.sideways.y, t64, light.normal.y * t69));
    const float t72 = fmaf(light.third_axis.z, t68, fmaf(light.sideways.z, t64, light.normal.z * t69));
    const spherecap_sample result = {
        make_float3(t65, t66, t67), t59 * light.distance, make_float3(t70, t71, t72), cosine, t54,
        0.0f < cosine ? light.inv_above : 0.0f
    };
    return result;
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
    const bool t10 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t11 = t10 ? light.inv_above * spherecap_min(spherecap_max(t6, 0.0f), 3.4028235e38f) : 0.0f;
    const float t12 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t12 && t12 <= 1.002001f) ? t11 : 0.0f;
}

static __device__ inline float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t3 = (0.998001f <= t2 && t2 <= 1.002001f) ? light.inv_above * spherecap_min(spherecap_max(t1, 0.0f), 3.4028235e38f) : 0.0f;
    return t3;
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
    float share;
    float rest;
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
    float b_0;
    float b_1;
    float b_2;
    float b_3;
    float b_4;
    float b_5;
    float b_6;
};

static __device__ inline spherecap_front_light spherecap_front_prepare(float3 normal, float3 centre, float radius, float defensive) {
    const float t1 = fmaf(normal.x, normal.x, fmaf(normal.y, normal.y, normal.z * normal.z)) - 1.0f;
    float normal_x, normal_y, normal_z;
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
    const bool t10 = 9.536743e-7f < radius && t9;
    const float t11 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37f));
    const float t12 = t10 ? 1.0f : spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t13 = centre.x * t12;
    const float t14 = centre.y * t12;
    const float t15 = centre.z * t12;
    const float t16 = radius * t12;
    const float t17 = __fmul_rn(t15, t15);
    const float t18 = fmaf(t13, t13, fmaf(t14, t14, t17));
    const float t19 = fmaf(-t16, t16, t18);
    float t20, t21;
    if (t19 < t18 * 0.25f) {
        const float t22 = __fmul_rn(t13, t13);
        const float t23 = __fmul_rn(t14, t14);
        const float t24 = __fadd_rn(t22, t23);
        const float t25 = __fsub_rn(t24, t22);
        t20 = __fadd_rn(t24, t17);
        const float t26 = __fsub_rn(t20, t24);
        const float t27 = spherecap_lost(t13, t13, t22) + spherecap_lost(t14, t14, t23) + spherecap_lost(t15, t15, t17);
        const float t28 = __fsub_rn(t22, __fsub_rn(t24, t25)) + __fsub_rn(t23, t25) + (__fsub_rn(t24, __fsub_rn(t20, t26)) + __fsub_rn(t17, t26));
        t21 = fmaf(-t16, t16, t20) + (t27 + t28);
    } else {
        t20 = t18;
        t21 = t19;
    }
    const float t29 = __fmul_rn(normal_z, t14);
    const float t30 = fmaf(normal_y, t15, -t29);
    const float t31 = __fmul_rn(normal_x, t15);
    const float t32 = fmaf(normal_z, t13, -t31);
    const float t33 = __fmul_rn(normal_y, t13);
    const float t34 = fmaf(normal_x, t14, -t33);
    const float t35 = fmaf(t30, t30, fmaf(t32, t32, t34 * t34));
    float up_x, up_y, up_z, t36, t37, t38, t39, t40;
    if (t35 < t20 * 0.015625f) {
        const float t41 = t30 - spherecap_lost(normal_z, t14, t29);
        const float t42 = t32 - spherecap_lost(normal_x, t15, t31);
        const float t43 = t34 - spherecap_lost(normal_y, t13, t33);
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
    const float t56 = __fmul_rn(normal_x, t13);
    const float t57 = __fmul_rn(normal_y, t14);
    const float t58 = __fmul_rn(normal_z, t15);
    const float t59 = __fadd_rn(t56, t57);
    const float t60 = __fsub_rn(t59, t56);
    const float t61 = __fadd_rn(t59, t58);
    const float t62 = __fsub_rn(t61, t59);
    const float t63 = spherecap_lost(normal_x, t13, t56) + spherecap_lost(normal_y, t14, t57) + spherecap_lost(normal_z, t15, t58);
    const float t64 = __fsub_rn(t56, __fsub_rn(t59, t60)) + __fsub_rn(t57, t60) + (__fsub_rn(t59, __fsub_rn(t61, t62)) + __fsub_rn(t58, t62));
    const float t65 = t63 + t64;
    const float t66 = __fadd_rn(t61, t65);
    const float t67 = __fsub_rn(t65, __fsub_rn(t66, t61));
    const float t68 = t16 - t66 - t67;
    const float t69 = t16 + t66 + t67;
    const float t70 = t68 * t69;
    const float t71 = sqrtf(t20);
    const float t72 = 1.0f / t71;
    const float t73 = sqrtf(t21);
    const float elevation_sin = t66 * t72;
    const bool t74 = 0.0f < t21;
    const bool t75 = 0.0f < t70 && t55 && t74;
    const bool t76 = 0.0f < elevation_sin;
    float t77;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (t75) {
        t77 = sqrtf(t21 + t70);
        const float t78 = sqrtf(t70);
        const float t79 = 1.0f / (t77 * t16);
        const float t80 = t79 * t16;
        const float t81 = t79 * t77;
        t_x = t73 * t80;
        t_y = t78 * t80;
        const float t82 = t_y * t_y;
        kappa = fabsf(t66) * t81;
        cut = kappa * t_x;
        const float t83 = t_x - 0.5f;
        const float t84 = cut - 0.5f;
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
        shape = fmaf(t97, t83, fmaf(t90, t85, 0.94559944f));
        shape_difference = fmaf(fmaf(t84, t96, t91), t83 + t84, t97);
        norm = fmaf(cut, shape_difference, shape);
        width = t82 / (1.0f + t_x);
        tau = t78 * t81;
        area = t82 * t_y * (spherecap_min(t68, t69) * t81) * norm;
    } else {
        t77 = t40;
    }
    const float radius_sin = t16 * t72;
    const float radius_cos = t73 * t72;
    const float elevation_cos = t77 * t72;
    const float t98 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t70 * (t72 * t72) / fmaf(radius_cos, t98, climb), -(radius_cos * t98));
    const float t99 = radius_sin * radius_sin;
    const float t100 = t76 ? fmaf(t99 * t98, 3.1415927f, area) : area;
    const bool t101 = 9.8607613e-32f < t99;
    const float t102 = 1.0f / t39;
    const float sideways_x = t36 * t102;
    const float sideways_y = t37 * t102;
    const float sideways_z = t38 * t102;
    const float on_surface = t55 ? 1.0f : 0.0f;
    const float distance = t71 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t100 && t101 && t74) ? t100 : 0.0f;
    const bool t103 = 0.0f < projected_above;
    const float inv_above = t103 ? 1.0f / projected_above : 0.0f;
    const float t104 = t76 ? inv_above : 0.0f;
    const bool t105 = t75 && t76 && 0.0f < t104;
    const float t106 = t_y * t_y * t_y * shape * t104;
    const float t107 = t_y / radius_sin;
    const float t108 = t107 * t107 * t107 * (fmaf(cut - t_x, shape_difference, shape) * 0.53033006f);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t75 && !t76) {
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
    const float share = ((0.0f < defensive || !(0.0f < on_surface)) && !t103) ? 1.0f : defensive;
    const bool t135 = 0.0f < share;
    const float t136 = (0.0f < radius_cos && t101) ? t99 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t135 ? (0.0f < t136 ? 0.15915494f / t136 : 0.0f) : 0.0f;
    const bool t137 = 0.0f < inv_solid_angle && t135;
    const bool t138 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (0.0f < inv_above || t137);
    const spherecap_front_light result = {
        t138, t138 ? t136 * 6.2831855f : 0.0f, t138 ? projected_above : 0.0f,
        make_float3(t13 * t72, t14 * t72, t15 * t72), make_float3(sideways_x, sideways_y, sideways_z),
        make_float3(normal_x, normal_y, normal_z), make_float3(up_x, up_y, up_z), on_surface, distance,
        radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, share,
        1.0f - share, defensive, inv_above,
        make_float3(fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))),
        t135 ? t136 : 0.0f, inv_solid_angle, t105 ? t106 : 0.0f, t105 ? 1.0f / (1.0f - t106) : 1.0f,
        t105 ? t108 : 0.0f, elevation_cos * radius_cos, radius_sin * t98, climb, b_0, b_1, b_2, b_3, b_4,
        b_5, b_6
    };
    return result;
}

static __device__ inline spherecap_sample spherecap_front_sample(spherecap_front_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = fabsf(light.elevation_sin);
    const bool t2 = 0.0f < light.share;
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t3 < light.share && t2;
    const float t6 = spherecap_max((t5 ? t3 : t3 - light.share) / (t5 ? light.share : light.rest), 5.9604645e-8f);
    const float t7 = (0.0f < light.requested && t2) ? spherecap_min(t6, 0.99999994f) : t3;
    const bool t8 = !(0.0f < light.tau) || t5;
    const bool t9 = !(0.0f < light.elevation_sin) && !t8;
    const bool t10 = light.crescent_share <= t7 && !t9;
    const bool t11 = t8 || t10;
    const float t12 = 1.0f - t4;
    const float t13 = t4 - t12;
    const float t14 = 4.0f * t4 * t12;
    const float t15 = spherecap_max((t7 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t16 = t8 ? t7 : spherecap_min(t15, 0.99999994f);
    const float t17 = t8 ? 0.0f : light.beyond;
    const float t18 = 1.6660811f - t17;
    const float t19 = fmaf(t16, t18, t17);
    const float t20 = (1.0f - t16) * t18;
    float t22, t23, t24;
    float t21 = 0.0f;
    if (t11) {
        t22 = spherecap_min(t19, t20);
        t23 = 1.0f;
        t24 = 1.0f;
    } else {
        const float t25 = sqrtf(t14);
        const float t26 = fmaf(fmaf(fmaf(light.b_6, t14, light.b_4), t14, light.b_2), t14, light.b_0);
        const float t27 = t25 * fmaf(fmaf(fmaf(light.b_5, t14, light.b_3), t14, light.b_1), t25, t26);
        const float t28 = sqrtf(fmaf(t13, t13, t27 * t27));
        const float t29 = light.tau * t27;
        t24 = t9 ? fmaf(t13, t13, t29 * t29) : 1.0f;
        const float t30 = t9 ? fmaf(light.kappa, t27, t28) * fmaf(light.cut, t27, t28) : light.crescent_share;
        const float t31 = (t9 ? light.width : t7) / t30;
        const float t32 = t9 ? t31 : light.width;
        const float t33 = t24 * t32;
        const float t34 = fmaf(fmaf(fmaf(-0.00060778117f, t33, 1.0676054e-5f), t33, -0.0027203285f), t33 * t33 * t33, fmaf(fmaf(-0.011332183f, t33, -0.10000902f), t33, 1.0000001f));
        t21 = t9 ? t29 : t25;
        t22 = t9 ? t7 : spherecap_min(spherecap_max(t31, 5.9604645e-8f), 0.99999994f);
        t23 = t32 * t34;
    }
    const float t35 = spherecap_float_of_bits(fmaf(spherecap_bits(t22), -0.33333334f, 1419900500.0f));
    const float t36 = t22 * t35;
    const float t37 = fmaf(-t36, t35 * t35, 1.0f);
    const float t38 = t37 * t37;
    const float t39 = fmaf(fmaf(0.12666093f, t38, fmaf(0.14565912f, t37, 0.17283025f)), t38, fmaf(0.22221696f, t37, 0.33333334f));
    const float t40 = t23 * fmaf(t36 * t37, t39, t36);
    const float t41 = t40 * t24;
    const float t42 = t41 * t41 * t41;
    const float t43 = fmaf(fmaf(fmaf(0.022114987f, t41, -0.063446075f), t41, 0.085662976f), t42, fmaf(fmaf(-0.056249518f, t41, 0.030445365f), t41, 0.0074712755f));
    const float t44 = fmaf(t43, t42, fmaf(fmaf(0.03209764f, t41, 0.09996679f), t41, 1.0000004f));
    const float t45 = t40 * t44;
    const float t46 = t11 ? spherecap_min(t45, 1.0f) : t45;
    const float t47 = t24 * t46;
    const float t48 = 2.0f - t47;
    const float t49 = t46 * t48;
    const float t50 = sqrtf(t49);
    float zenith, side, cosine, t51, t52;
    if (t11) {
        const float t53 = t19 - t20 < 0.0f ? t47 : t48;
        if (t5) {
            const float t54 = light.height * (1.0f - t49 * t14);
            const float t55 = sqrtf(light.height * (2.0f - t54));
            zenith = (t53 - 1.0f) * t55;
            const float t56 = 1.0f - t54;
            t52 = fmaf(light.elevation_sin, t56, light.elevation_cos * zenith);
            t51 = fmaf(light.elevation_cos, t56, -(light.elevation_sin * zenith));
            side = t50 * t13 * t55;
            cosine = t52 * light.on_surface;
        } else {
            const float t57 = 1.0f - t53;
            const float t58 = light.radius_sin * light.radius_sin * t14;
            const float t59 = spherecap_max(fmaf(light.climb, t53, -light.rise), 0.0f);
            t52 = sqrtf(fmaf(t49, t58, t59 * t59));
            const float t60 = t1 * light.radius_cos;
            const float t61 = light.climb * t57;
            zenith = fmaf(light.elevation_cos, fmaf(t61, t61 - 2.0f * t60, t49 * t58) / (t52 + t60), -(light.half_axis * t1 * t57));
            t51 = fmaf(light.half_axis, t57, light.middle);
            side = light.radius_sin * t50 * t13;
            cosine = t52;
        }
    } else {
        cosine = t50 * t21;
        t51 = 1.0f - t47;
        zenith = fmaf(light.elevation_cos, cosine, -((t9 ? -t1 : t1) * t51));
        side = t50 * t13;
        t52 = cosine;
    }
    const float t62 = light.share * light.inv_solid_angle;
    const float t63 = 0.0f < cosine ? light.inv_above : 0.0f;
    const float t64 = spherecap_min(spherecap_max(cosine, 0.0f), 3.4028235e38f);
    const float t65 = t2 ? fmaf(light.inv_above, light.rest * t64, t62) : light.inv_above * t64;
    const float t66 = spherecap_max(spherecap_min(fabsf(cosine), 3.4028235e38f), 1.1754944e-38f);
    const float t67 = spherecap_min(fmaf(t63, light.rest, spherecap_min(t62 / t66, 3.4028235e38f)), 3.4028235e38f);
    const float t68 = fmaf(zenith, zenith, side * side);
    const float t69 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t68), 0.0f);
    const float t70 = sqrtf(t69);
    const float t71 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t69));
    const float t72 = light.radius_cos * light.radius_cos / (t71 + t70);
    const float t73 = 1.0f / light.radius_sin;
    const float t74 = t72 * t73;
    const float t75 = -fmaf(t71, t70, t68) * t73;
    const float t76 = t74 * zenith;
    const float t77 = t74 * side;
    const float t78 = fmaf(light.third_axis.x, t51, fmaf(light.sideways.x, side, light.up.x * t52));
    const float t79 = fmaf(light.third_axis.y, t51, fmaf(light.sideways.y, side, light.up.y * t52));
    const float t80 = fmaf(light.third_axis.z, t51, fmaf(light.sideways.z, side, light.up.z * t52));
    const float t81 = fmaf(light.elevation_cos, t75, -(light.elevation_sin * t76));
    const float t82 = fmaf(light.elevation_sin, t75, light.elevation_cos * t76);
    const float t83 = fmaf(light.third_axis.x, t81, fmaf(light.sideways.x, t77, light.up.x * t82));
    const float t84 = fmaf(light.third_axis.y, t81, fmaf(light.sideways.y, t77, light.up.y * t82));
    const float t85 = fmaf(light.third_axis.z, t81, fmaf(light.sideways.z, t77, light.up.z * t82));
    const spherecap_sample result = {
        make_float3(t78, t79, t80), t72 * light.distance, make_float3(t83, t84, t85), cosine, t65,
        t2 ? t67 : t63
    };
    return result;
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
    const float t10 = spherecap_min(spherecap_max(t6, 0.0f), 3.4028235e38f);
    const float t11 = fmaf(light.inv_above, light.rest * t10, light.share * light.inv_solid_angle);
    const bool t12 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t13 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t14 = (0.998001f <= t13 && t13 <= 1.002001f) ? (t12 ? (0.0f < light.share ? t11 : light.inv_above * t10) : 0.0f) : 0.0f;
    return t14;
}

static __device__ inline float spherecap_front_pdf_on_sphere(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = spherecap_min(spherecap_max(t1, 0.0f), 3.4028235e38f);
    const float t3 = fmaf(light.inv_above, light.rest * t2, light.share * light.inv_solid_angle);
    const float t4 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t5 = (0.998001f <= t4 && t4 <= 1.002001f) ? (0.0f < light.share ? t3 : light.inv_above * t2) : 0.0f;
    return t5;
}

static __device__ inline float spherecap_front_importance(float3 normal, float3 centre, float radius, float defensive, float strength) {
    const float t1 = fmaf(normal.x, normal.x, fmaf(normal.y, normal.y, normal.z * normal.z)) - 1.0f;
    float t2, t3, t4;
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
    const bool t28 = t19 <= 1.0000019f && 4.9303807e-32f < t19 && 0.0f < strength && t21 && strength <= 3.4028235e38f;
    const float t29 = spherecap_min(spherecap_max(t19 * t27 * strength, 1.1754944e-38f), 3.4028235e38f);
    return ((0.0f < t27 || 0.0f < defensive) && t28) ? t29 : 0.0f;
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
    float defensive_rest;
    float requested;
    float inv_above;
    float inv_below;
    float sides_share;
    float sides_rest;
    float3 third_axis;
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
};

static __device__ inline spherecap_both_light spherecap_both_prepare(float3 normal, float3 centre, float radius, float defensive) {
    const float t1 = fmaf(normal.x, normal.x, fmaf(normal.y, normal.y, normal.z * normal.z)) - 1.0f;
    float normal_x, normal_y, normal_z;
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
    const bool t10 = 9.536743e-7f < radius && t9;
    const float t11 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37f));
    const float t12 = t10 ? 1.0f : spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t13 = centre.x * t12;
    const float t14 = centre.y * t12;
    const float t15 = centre.z * t12;
    const float t16 = radius * t12;
    const float t17 = __fmul_rn(t15, t15);
    const float t18 = fmaf(t13, t13, fmaf(t14, t14, t17));
    const float t19 = fmaf(-t16, t16, t18);
    float t20, t21;
    if (t19 < t18 * 0.25f) {
        const float t22 = __fmul_rn(t13, t13);
        const float t23 = __fmul_rn(t14, t14);
        const float t24 = __fadd_rn(t22, t23);
        const float t25 = __fsub_rn(t24, t22);
        t20 = __fadd_rn(t24, t17);
        const float t26 = __fsub_rn(t20, t24);
        const float t27 = spherecap_lost(t13, t13, t22) + spherecap_lost(t14, t14, t23) + spherecap_lost(t15, t15, t17);
        const float t28 = __fsub_rn(t22, __fsub_rn(t24, t25)) + __fsub_rn(t23, t25) + (__fsub_rn(t24, __fsub_rn(t20, t26)) + __fsub_rn(t17, t26));
        t21 = fmaf(-t16, t16, t20) + (t27 + t28);
    } else {
        t20 = t18;
        t21 = t19;
    }
    const float t29 = __fmul_rn(normal_z, t14);
    const float t30 = fmaf(normal_y, t15, -t29);
    const float t31 = __fmul_rn(normal_x, t15);
    const float t32 = fmaf(normal_z, t13, -t31);
    const float t33 = __fmul_rn(normal_y, t13);
    const float t34 = fmaf(normal_x, t14, -t33);
    const float t35 = fmaf(t30, t30, fmaf(t32, t32, t34 * t34));
    float up_x, up_y, up_z, t36, t37, t38, t39, t40;
    if (t35 < t20 * 0.015625f) {
        const float t41 = t30 - spherecap_lost(normal_z, t14, t29);
        const float t42 = t32 - spherecap_lost(normal_x, t15, t31);
        const float t43 = t34 - spherecap_lost(normal_y, t13, t33);
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
    const float t56 = __fmul_rn(normal_x, t13);
    const float t57 = __fmul_rn(normal_y, t14);
    const float t58 = __fmul_rn(normal_z, t15);
    const float t59 = __fadd_rn(t56, t57);
    const float t60 = __fsub_rn(t59, t56);
    const float t61 = __fadd_rn(t59, t58);
    const float t62 = __fsub_rn(t61, t59);
    const float t63 = spherecap_lost(normal_x, t13, t56) + spherecap_lost(normal_y, t14, t57) + spherecap_lost(normal_z, t15, t58);
    const float t64 = __fsub_rn(t56, __fsub_rn(t59, t60)) + __fsub_rn(t57, t60) + (__fsub_rn(t59, __fsub_rn(t61, t62)) + __fsub_rn(t58, t62));
    const float t65 = t63 + t64;
    const float t66 = __fadd_rn(t61, t65);
    const float t67 = __fsub_rn(t65, __fsub_rn(t66, t61));
    const float t68 = t16 - t66 - t67;
    const float t69 = t16 + t66 + t67;
    const float t70 = t68 * t69;
    const float t71 = sqrtf(t20);
    const float t72 = 1.0f / t71;
    const float t73 = sqrtf(t21);
    const float elevation_sin = t66 * t72;
    const bool t74 = 0.0f < t21;
    const bool t75 = 0.0f < t70 && t55 && t74;
    const bool t76 = 0.0f < elevation_sin;
    float t77;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (t75) {
        t77 = sqrtf(t21 + t70);
        const float t78 = sqrtf(t70);
        const float t79 = 1.0f / (t77 * t16);
        const float t80 = t79 * t16;
        const float t81 = t79 * t77;
        t_x = t73 * t80;
        t_y = t78 * t80;
        const float t82 = t_y * t_y;
        kappa = fabsf(t66) * t81;
        cut = kappa * t_x;
        const float t83 = t_x - 0.5f;
        const float t84 = cut - 0.5f;
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
        shape = fmaf(t97, t83, fmaf(t90, t85, 0.94559944f));
        shape_difference = fmaf(fmaf(t84, t96, t91), t83 + t84, t97);
        norm = fmaf(cut, shape_difference, shape);
        width = t82 / (1.0f + t_x);
        tau = t78 * t81;
        area = t82 * t_y * (spherecap_min(t68, t69) * t81) * norm;
    } else {
        t77 = t40;
    }
    const float radius_sin = t16 * t72;
    const float radius_cos = t73 * t72;
    const float elevation_cos = t77 * t72;
    const float t98 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t70 * (t72 * t72) / fmaf(radius_cos, t98, climb), -(radius_cos * t98));
    const float t99 = radius_sin * radius_sin;
    const float t100 = fmaf(t99 * t98, 3.1415927f, area);
    const float t101 = t76 ? t100 : area;
    const float t102 = t76 ? area : t100;
    const bool t103 = 9.8607613e-32f < t99;
    const bool t104 = t103 && t74;
    const float t105 = 1.0f / t39;
    const float sideways_x = t36 * t105;
    const float sideways_y = t37 * t105;
    const float sideways_z = t38 * t105;
    const float on_surface = t55 ? 1.0f : 0.0f;
    const float distance = t71 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t101 && t104) ? t101 : 0.0f;
    const float projected_below = (9.403955e-38f < t102 && t104) ? t102 : 0.0f;
    const bool t106 = 0.0f < projected_above;
    const bool t107 = 0.0f < projected_below;
    const float inv_above = t106 ? 1.0f / projected_above : 0.0f;
    const float inv_below = t107 ? 1.0f / projected_below : 0.0f;
    const float t108 = t76 ? inv_above : inv_below;
    const bool t109 = 0.0f < t108 && t75;
    const float t110 = t_y * t_y * t_y * shape * t108;
    const float t111 = t_y / radius_sin;
    const float t112 = fmaf(cut - t_x, shape_difference, shape);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t75) {
        const float t113 = 1.0f + kappa;
        const float t114 = t113 * shape;
        const float t115 = 1.0f / (norm * t114);
        const float t116 = sqrtf(t115);
        b_0 = norm * t116;
        const float t117 = 1.0f / (1.0f + cut);
        const float t118 = (t_x + kappa) * t117 - 0.5f;
        const float t119 = t118 * t118 * t118;
        const float t120 = fmaf(fmaf(fmaf(-0.026061837f, t118, 0.05430631f), t118, -0.06372378f), t119, fmaf(fmaf(0.080950715f, t118, -0.11762552f), t118, 0.1684019f));
        const float t121 = fmaf(t120, t119, fmaf(fmaf(-0.23594604f, t118, 0.32709444f), t118, -0.44721135f));
        const float t122 = fmaf(t121, t119, fmaf(fmaf(0.5987523f, t118, -0.7754678f), t118, 0.94559944f));
        const float t123 = t113 * t122 * (t117 * t117 * t117) * (t114 * t115);
        const float t124 = fmaf(t123, t114 * t116, -1.0f);
        const float t125 = 1.0f - t123;
        const float t126 = fmaf(fmaf(30.011856f, t124, fmaf(-41.541264f, t125, -37.009792f)), t124, fmaf(77.96775f, t125, 7.470758f));
        const float t127 = fmaf(t126, t124, fmaf(fmaf(-49.13454f, t125, -9.466533f), t125, -1.5877596f));
        const float t128 = fmaf(fmaf(fmaf(15.716111f, t125, 0.0f), t125, 9.961183f), t125, -2.61785f);
        const float t129 = t124 * fmaf(t127, t124, fmaf(t128, t125, 0.8681748f));
        const float t130 = fmaf(fmaf(7.295638f, t124, -7.236236f), t124, fmaf(fmaf(fmaf(-11.4868555f, t125, 0.0f), t125, 0.0f), t125, 3.1255686f));
        const float t131 = fmaf(fmaf(fmaf(13.728438f, t125, -7.981878f), t125, 2.025724f), t125, -0.7334958f);
        const float t132 = t124 * fmaf(t130, t124, t131);
        const float t133 = fmaf(fmaf(fmaf(9.986537f, t125, 25.22195f), t125, 0.0f), t125, -2.9581387f);
        const float t134 = fmaf(fmaf(fmaf(-19.722994f, t125, 4.6594768f), t125, -0.89538246f), t125, 0.5143498f);
        const float t135 = t124 * fmaf(fmaf(fmaf(-23.220068f, t125, 7.332055f), t124, t133), t124, t134);
        const float t136 = fmaf(fmaf(fmaf(1.946617f, t124, -3.077631f), t124, 1.4945927f), t124, -0.24140751f);
        const float t137 = t124 * t136;
        const float t138 = t124 * fmaf(fmaf(0.38173297f, t124, -0.30305624f), t124, 0.05897375f);
        b_1 = t123 - b_0 + t129;
        b_2 = t132 - t129;
        b_3 = t135 - t132;
        b_4 = t137 - t135;
        b_5 = t138 - t137;
        b_6 = -t138;
    }
    const float defensive_share = (!(t106 || t107) && (0.0f < defensive || !(0.0f < on_surface))) ? 1.0f : defensive;
    const bool t139 = 0.0f < defensive_share;
    const float t140 = (0.0f < radius_cos && t103) ? t99 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t139 ? (0.0f < t140 ? 0.15915494f / t140 : 0.0f) : 0.0f;
    float t141 = 0.0f;
    if (0.0f < tau) {
        const float t142 = 1.0f / (elevation_cos * elevation_cos);
        const float t143 = tau * tau;
        const float t144 = t143 * t142 / (1.0f + t_x);
        const float t145 = kappa - 0.5f;
        const float t146 = cut - 0.5f;
        const float t147 = t145 * t145;
        const float t148 = t146 * t146;
        const float t149 = fmaf(0.05430631f, t147, 0.080950715f);
        const float t150 = fmaf(t149, t147, 0.1684019f);
        const float t151 = fmaf(t150, t147, 0.32709444f);
        const float t152 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t148, t149), t148, t150), t148, t151), t148, fmaf(t151, t147, 0.5987523f));
        const float t153 = fmaf(-0.026061837f, t147, -0.06372378f);
        const float t154 = fmaf(t153, t147, -0.11762552f);
        const float t155 = fmaf(t154, t147, -0.23594604f);
        const float t156 = fmaf(t155, t147, -0.44721135f);
        const float t157 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t148, t153), t148, t154), t148, t155), t148, t156);
        const float t158 = fmaf(kappa * t144, fmaf(fmaf(t146, t157, t152), t145 + t146, fmaf(t156, t147, -0.7754678f)), fmaf(t112, t144 - kappa * kappa, kappa) * t142);
        const float t159 = spherecap_max(t143 * tau * (radius_cos + 1.0f) * t158 * 0.31830987f, 0.0f);
        t141 = spherecap_min(t159, 0.5f);
    }
    const float t160 = 1.0f - t141;
    const bool t161 = 0.0f < inv_below;
    const bool t162 = 0.0f < inv_above;
    const bool t163 = 0.0f < inv_solid_angle && t139;
    const bool t164 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (0.0f < inv_above + inv_below || t163);
    const spherecap_both_light result = {
        t164, t164 ? t140 * 6.2831855f : 0.0f, t164 ? projected_above : 0.0f,
        make_float3(t13 * t72, t14 * t72, t15 * t72), make_float3(sideways_x, sideways_y, sideways_z),
        make_float3(normal_x, normal_y, normal_z), make_float3(up_x, up_y, up_z), on_surface, distance,
        radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, defensive_share,
        1.0f - defensive_share, defensive, inv_above, inv_below,
        t161 ? (t162 ? (t76 ? t160 : t141) : 0.0f) : 1.0f, t162 ? (t161 ? (t76 ? t141 : t160) : 0.0f) : 1.0f,
        make_float3(fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))),
        t139 ? t140 : 0.0f, inv_solid_angle, t109 ? t110 : 0.0f, t109 ? 1.0f / (1.0f - t110) : 1.0f,
        t109 ? t111 * t111 * t111 * (t112 * 0.53033006f) : 0.0f, elevation_cos * radius_cos,
        radius_sin * t98, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

static __device__ inline spherecap_sample spherecap_both_sample(spherecap_both_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const bool t1 = 0.0f < light.elevation_sin;
    const float t2 = fabsf(light.elevation_sin);
    const bool t3 = 0.0f < light.defensive_share;
    const float t4 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = t4 < light.defensive_share && t3;
    const float t7 = (t6 ? t4 : t4 - light.defensive_share) / (t6 ? light.defensive_share : light.defensive_rest);
    const float t8 = (0.0f < light.requested && t3) ? spherecap_min(spherecap_max(t7, 5.9604645e-8f), 0.99999994f) : t4;
    const bool t9 = t8 < light.sides_share || t6;
    const float t10 = (t9 ? t8 : t8 - light.sides_share) / (t9 ? light.sides_share : light.sides_rest);
    const bool t11 = t9 && t1;
    const bool t12 = !t9 && !t1;
    const float t13 = t6 ? t8 : spherecap_min(spherecap_max(t10, 5.9604645e-8f), 0.99999994f);
    const bool t14 = !(0.0f < light.tau) || t6;
    const bool t15 = !(t11 || t12) && !t14;
    const bool t16 = light.crescent_share <= t13 && !t15;
    const bool t17 = t14 || t16;
    const float t18 = 1.0f - t5;
    const float t19 = t5 - t18;
    const float t20 = 4.0f * t5 * t18;
    const float t21 = spherecap_max((t13 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t22 = t14 ? t13 : spherecap_min(t21, 0.99999994f);
    const float t23 = t14 ? 0.0f : light.beyond;
    const float t24 = 1.6660811f - t23;
    const float t25 = fmaf(t22, t24, t23);
    const float t26 = (1.0f - t22) * t24;
    float t28, t29, t30;
    float t27 = 0.0f;
    if (t17) {
        t28 = spherecap_min(t25, t26);
        t29 = 1.0f;
        t30 = 1.0f;
    } else {
        const float t31 = sqrtf(t20);
        const float t32 = fmaf(fmaf(fmaf(light.b_6, t20, light.b_4), t20, light.b_2), t20, light.b_0);
        const float t33 = t31 * fmaf(fmaf(fmaf(light.b_5, t20, light.b_3), t20, light.b_1), t31, t32);
        const float t34 = sqrtf(fmaf(t19, t19, t33 * t33));
        const float t35 = light.tau * t33;
        t30 = t15 ? fmaf(t19, t19, t35 * t35) : 1.0f;
        const float t36 = t15 ? fmaf(light.kappa, t33, t34) * fmaf(light.cut, t33, t34) : light.crescent_share;
        const float t37 = (t15 ? light.width : t13) / t36;
        t28 = t15 ? t13 : spherecap_min(spherecap_max(t37, 5.9604645e-8f), 0.99999994f);
        const float t38 = t15 ? t37 : light.width;
        const float t39 = t30 * t38;
        const float t40 = fmaf(fmaf(fmaf(-0.00060778117f, t39, 1.0676054e-5f), t39, -0.0027203285f), t39 * t39 * t39, fmaf(fmaf(-0.011332183f, t39, -0.10000902f), t39, 1.0000001f));
        t27 = t15 ? t35 : t31;
        t29 = t38 * t40;
    }
    const float t41 = spherecap_float_of_bits(fmaf(spherecap_bits(t28), -0.33333334f, 1419900500.0f));
    const float t42 = t28 * t41;
    const float t43 = fmaf(-t42, t41 * t41, 1.0f);
    const float t44 = t43 * t43;
    const float t45 = fmaf(fmaf(0.12666093f, t44, fmaf(0.14565912f, t43, 0.17283025f)), t44, fmaf(0.22221696f, t43, 0.33333334f));
    const float t46 = t29 * fmaf(t42 * t43, t45, t42);
    const float t47 = t46 * t30;
    const float t48 = t47 * t47 * t47;
    const float t49 = fmaf(fmaf(fmaf(0.022114987f, t47, -0.063446075f), t47, 0.085662976f), t48, fmaf(fmaf(-0.056249518f, t47, 0.030445365f), t47, 0.0074712755f));
    const float t50 = fmaf(t49, t48, fmaf(fmaf(0.03209764f, t47, 0.09996679f), t47, 1.0000004f));
    const float t51 = t46 * t50;
    const float t52 = t17 ? spherecap_min(t51, 1.0f) : t51;
    const float t53 = t30 * t52;
    const float t54 = 2.0f - t53;
    const float t55 = t52 * t54;
    const float t56 = sqrtf(t55);
    float side, t57, t58, t59, t60;
    if (t17) {
        const float t61 = t25 - t26 < 0.0f ? t53 : t54;
        if (t6) {
            const float t62 = light.height * (1.0f - t55 * t20);
            const float t63 = sqrtf(light.height * (2.0f - t62));
            t59 = (t61 - 1.0f) * t63;
            const float t64 = 1.0f - t62;
            t58 = fmaf(light.elevation_sin, t64, light.elevation_cos * t59);
            t57 = fmaf(light.elevation_cos, t64, -(light.elevation_sin * t59));
            side = t56 * t19 * t63;
            t60 = t58 * light.on_surface;
        } else {
            const float t65 = 1.0f - t61;
            const float t66 = light.radius_sin * light.radius_sin * t20;
            const float t67 = spherecap_max(fmaf(light.climb, t61, -light.rise), 0.0f);
            t58 = sqrtf(fmaf(t55, t66, t67 * t67));
            const float t68 = t2 * light.radius_cos;
            const float t69 = light.climb * t65;
            t59 = fmaf(light.elevation_cos, fmaf(t69, t69 - 2.0f * t68, t55 * t66) / (t58 + t68), -(light.half_axis * t2 * t65));
            t57 = fmaf(light.half_axis, t65, light.middle);
            side = light.radius_sin * t56 * t19;
            t60 = t58;
        }
    } else {
        t58 = t56 * t27;
        t57 = 1.0f - t53;
        side = t56 * t19;
        t59 = fmaf(light.elevation_cos, t58, -((t15 ? -t2 : t2) * t57));
        t60 = t58;
    }
    const float t70 = t9 ? 1.0f : -1.0f;
    const float zenith = t59 * t70;
    const float cosine = t60 * t70;
    const float t71 = t58 * t70;
    const float t72 = light.defensive_share * light.inv_solid_angle;
    const float t73 = spherecap_min(fabsf(cosine), 3.4028235e38f);
    const float t74 = 0.0f < cosine ? light.inv_above * light.sides_share : cosine < 0.0f ? light.inv_below * light.sides_rest : 0.0f;
    const float t75 = fmaf(t74, light.defensive_rest, spherecap_min(t72 / spherecap_max(t73, 1.1754944e-38f), 3.4028235e38f));
    const float t76 = fmaf(zenith, zenith, side * side);
    const float t77 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t76), 0.0f);
    const float t78 = sqrtf(t77);
    const float t79 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t77));
    const float t80 = light.radius_cos * light.radius_cos / (t79 + t78);
    const float t81 = 1.0f / light.radius_sin;
    const float t82 = t80 * t81;
    const float t83 = -fmaf(t79, t78, t76) * t81;
    const float t84 = t82 * zenith;
    const float t85 = t82 * side;
    const float t86 = fmaf(light.third_axis.x, t57, fmaf(light.sideways.x, side, light.up.x * t71));
    const float t87 = fmaf(light.third_axis.y, t57, fmaf(light.sideways.y, side, light.up.y * t71));
    const float t88 = fmaf(light.third_axis.z, t57, fmaf(light.sideways.z, side, light.up.z * t71));
    const float t89 = fmaf(light.elevation_cos, t83, -(light.elevation_sin * t84));
    const float t90 = fmaf(light.elevation_sin, t83, light.elevation_cos * t84);
    const float t91 = fmaf(light.third_axis.x, t89, fmaf(light.sideways.x, t85, light.up.x * t90));
    const float t92 = fmaf(light.third_axis.y, t89, fmaf(light.sideways.y, t85, light.up.y * t90));
    const float t93 = fmaf(light.third_axis.z, t89, fmaf(light.sideways.z, t85, light.up.z * t90));
    const spherecap_sample result = {
        make_float3(t86, t87, t88), t80 * light.distance, make_float3(t91, t92, t93), cosine,
        t3 ? fmaf(t74, light.defensive_rest * t73, t72) : t74 * t73,
        t3 ? spherecap_min(t75, 3.4028235e38f) : t74
    };
    return result;
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
    const float t11 = 0.0f < t6 ? light.inv_above * light.sides_share : t6 < 0.0f ? light.inv_below * light.sides_rest : 0.0f;
    const float t12 = fmaf(t11, light.defensive_rest * t10, light.defensive_share * light.inv_solid_angle);
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
    const float t3 = 0.0f < t1 ? light.inv_above * light.sides_share : t1 < 0.0f ? light.inv_below * light.sides_rest : 0.0f;
    const float t4 = fmaf(t3, light.defensive_rest * t2, light.defensive_share * light.inv_solid_angle);
    const float t5 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    const float t6 = (0.998001f <= t5 && t5 <= 1.002001f) ? (0.0f < light.defensive_share ? t4 : t3 * t2) : 0.0f;
    return t6;
}

static __device__ inline float spherecap_both_importance(float3 normal, float3 centre, float radius, float defensive, float strength) {
    const float t1 = fmaf(normal.x, normal.x, fmaf(normal.y, normal.y, normal.z * normal.z)) - 1.0f;
    float t2, t3, t4;
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
    const bool t32 = t19 <= 1.0000019f && 4.9303807e-32f < t19 && 0.0f < strength && t21 && strength <= 3.4028235e38f;
    const float t33 = spherecap_min(spherecap_max(t19 * t31 * strength, 1.1754944e-38f), 3.4028235e38f);
    return ((0.0f < t31 || 0.0f < defensive) && t32) ? t33 : 0.0f;
}


#endif
