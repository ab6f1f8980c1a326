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
    float density_above;
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
    const float density_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float t90 = t63 ? density_above : 0.0f;
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
    const bool t121 = 0.0f < radius && distance <= 3.4028235e38f && 0.0f < density_above;
    const float t122 = ((0.0f < radius_cos && t88) ? t86 / (1.0f + radius_cos) : 0.0f) * 6.2831855f;
    const spherecap_surface_light result = {
        t121, t121 ? t122 : 0.0f, t121 ? projected_above : 0.0f, make_float3(t5 * t59, t6 * t59, t7 * t59),
        make_float3(sideways_x, sideways_y, sideways_z), normal, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, density_above,
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
    const float t42 = t20 * t41;
    const float t43 = 2.0f - t42;
    const float t44 = t41 * t43;
    const float t45 = sqrtf(t44);
    float zenith, side, cosine, t46;
    if (t7) {
        const float t47 = t15 - t16 < 0.0f ? t42 : t43;
        const float t48 = 1.0f - t47;
        const float t49 = light.radius_sin * light.radius_sin * t10;
        const float t50 = spherecap_max(fmaf(light.climb, t47, -light.rise), 0.0f);
        cosine = sqrtf(fmaf(t44, t49, t50 * t50));
        const float t51 = t1 * light.radius_cos;
        const float t52 = light.climb * t48;
        zenith = fmaf(light.elevation_cos, fmaf(t52, t52 - 2.0f * t51, t44 * t49) / (cosine + t51), -(light.half_axis * t1 * t48));
        side = light.radius_sin * t45 * t9;
        t46 = fmaf(light.half_axis, t48, light.middle);
    } else {
        cosine = t45 * t17;
        t46 = 1.0f - t42;
        zenith = fmaf(light.elevation_cos, cosine, -((t5 ? -t1 : t1) * t46));
        side = t45 * t9;
    }
    const float t53 = fmaf(light.density_above, spherecap_min(spherecap_max(cosine, 0.0f), 3.4028235e38f), 0.0f);
    const float t54 = spherecap_max(spherecap_min(fabsf(cosine), 3.4028235e38f), 1.1754944e-38f);
    const float t55 = (0.0f < cosine ? light.density_above : 0.0f) + spherecap_min(0.0f / t54, 3.4028235e38f);
    const float t56 = fmaf(zenith, zenith, side * side);
    const float t57 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t56), 0.0f);
    const float t58 = sqrtf(t57);
    const float t59 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t57));
    const float t60 = light.radius_cos * light.radius_cos / (t59 + t58);
    const float t61 = 1.0f / light.radius_sin;
    const float t62 = t60 * t61;
    const float t63 = -fmaf(t59, t58, t56) * t61;
    const float t64 = t62 * zenith;
    const float t65 = t62 * side;
    const float t66 = fmaf(light.third_axis.x, t46, fmaf(light.sideways.x, side, light.normal.x * cosine));
    const float t67 = fmaf(light.third_axis.y, t46, fmaf(light.sideways.y, side, light.normal.y * cosine));
    const float t68 = fmaf(light.third_axis.z, t46, fmaf(light.sideways.z, side, light.normal.z * cosine));
    const float t69 = fmaf(light.elevation_cos, t63, -(light.elevation_sin * t64));
    const float t70 = fmaf(light.elevation_sin, t63, light.elevation_cos * t64);
    const float t71 = fmaf(light.third_axis.x, t69, fmaf(light.sideways.x, t65, light.normal.x * t70));
    const float t72 = fmaf(light.third_axis.y, t69, fmaf(light.sideways.y, t65, light.normal.y * t70));
    const float t73 = fmaf(light.third_axis.z, t69, fmaf(light.sideways.z, t65, light.normal.z * t70));
    const spherecap_sample result = {
        make_float3(t66, t67, t68), t60 * light.distance, make_float3(t71, t72, t73), cosine, t53,
        spherecap_min(t55, 3.4028235e38f)
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
    const float t10 = fmaf(light.density_above, spherecap_min(spherecap_max(t6, 0.0f), 3.4028235e38f), 0.0f);
    const bool t11 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t12 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? t10 : 0.0f) : 0.0f;
}

static __device__ inline float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = fmaf(light.density_above, spherecap_min(spherecap_max(t1, 0.0f), 3.4028235e38f), 0.0f);
    const float t3 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
}

static __device__ inline float spherecap_surface_importance(float3 normal, float3 centre, float radius, float strength) {
    const bool t1 = fmaf(centre.x, centre.x, fmaf(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0f;
    const bool t2 = 9.536743e-7f < radius && t1;
    const float t3 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t3, 8.5070587e37f));
    const float t4 = t2 ? 1.0f : spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t5 = centre.x * t4;
    const float t6 = centre.y * t4;
    const float t7 = centre.z * t4;
    const float t8 = radius * t4;
    const float t9 = sqrtf(fmaf(t5, t5, fmaf(t6, t6, t7 * t7)));
    const float t10 = 1.0f / t9;
    const float t11 = t8 * t10;
    const float t12 = t11 * t11;
    const bool t13 = 0.0f < radius && t9 * (t2 ? 1.0f : unscale) <= 3.4028235e38f && 0.0f < strength;
    const float t14 = fmaf(normal.x, t5, fmaf(normal.y, t6, normal.z * t7));
    const float t15 = fmaf(t14, t10, 2.3841858e-7f);
    const float t16 = fmaf(t14 + t8, t10, 2.3841858e-7f);
    const float t17 = fmaf(t11 - t15, spherecap_max(fmaf(-t12, t12, 0.9999981f), 0.0f), t16) * 2.0f;
    const float t18 = t11 <= t15 ? t15 : 0.0f < t16 ? t16 * t16 / t17 : 0.0f;
    const float t19 = fmaf(0.0f, 0.5f - t18, t18);
    const bool t20 = t12 <= 1.0000019f && 4.9303807e-32f < t12 && strength <= 3.4028235e38f && t13;
    const float t21 = spherecap_min(spherecap_max(t12 * t19 * strength, 1.1754944e-38f), 3.4028235e38f);
    return (0.0f < t19 && t20) ? t21 : 0.0f;
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
    float defensive;
    float requested;
    float density_above;
    float3 third_axis;
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
    const float t104 = t103 ? 1.0f / projected_above : 0.0f;
    const float t105 = t76 ? t104 : 0.0f;
    const bool t106 = t75 && t76 && 0.0f < t105;
    const float t107 = t_y * t_y * t_y * shape * t105;
    const float t108 = t_y / radius_sin;
    const float t109 = t108 * t108 * t108 * (fmaf(cut - t_x, shape_difference, shape) * 0.53033006f);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t75 && !t76) {
        const float t110 = 1.0f + kappa;
        const float t111 = t110 * shape;
        const float t112 = 1.0f / (norm * t111);
        const float t113 = sqrtf(t112);
        b_0 = norm * t113;
        const float t114 = 1.0f / (1.0f + cut);
        const float t115 = (t_x + kappa) * t114 - 0.5f;
        const float t116 = t115 * t115 * t115;
        const float t117 = fmaf(fmaf(fmaf(-0.026061837f, t115, 0.05430631f), t115, -0.06372378f), t116, fmaf(fmaf(0.080950715f, t115, -0.11762552f), t115, 0.1684019f));
        const float t118 = fmaf(t117, t116, fmaf(fmaf(-0.23594604f, t115, 0.32709444f), t115, -0.44721135f));
        const float t119 = fmaf(t118, t116, fmaf(fmaf(0.5987523f, t115, -0.7754678f), t115, 0.94559944f));
        const float t120 = t110 * t119 * (t114 * t114 * t114) * (t111 * t112);
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
        b_1 = t120 - b_0 + t126;
        b_2 = t129 - t126;
        b_3 = t132 - t129;
        b_4 = t134 - t132;
        b_5 = t135 - t134;
        b_6 = -t135;
    }
    const float t136 = ((0.0f < defensive || !(0.0f < on_surface)) && !t103) ? 1.0f : defensive;
    const bool t137 = 0.0f < t136;
    const float t138 = (0.0f < radius_cos && t101) ? t99 / (1.0f + radius_cos) : 0.0f;
    const float density = t137 ? t136 * (0.0f < t138 ? 0.15915494f / t138 : 0.0f) : 0.0f;
    const float density_above = t104 * (1.0f - t136);
    const bool t139 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && 0.0f < density_above + 0.0f + density;
    const spherecap_front_light result = {
        t139, t139 ? t138 * 6.2831855f : 0.0f, t139 ? projected_above : 0.0f,
        make_float3(t13 * t72, t14 * t72, t15 * t72), make_float3(sideways_x, sideways_y, sideways_z),
        make_float3(normal_x, normal_y, normal_z), make_float3(up_x, up_y, up_z), on_surface, distance,
        radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, t136, defensive,
        density_above,
        make_float3(fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))),
        t137 ? t138 : 0.0f, density, t106 ? t107 : 0.0f, t106 ? 1.0f / (1.0f - t107) : 1.0f,
        t106 ? t109 : 0.0f, elevation_cos * radius_cos, radius_sin * t98, climb, b_0, b_1, b_2, b_3, b_4,
        b_5, b_6
    };
    return result;
}

static __device__ inline spherecap_sample spherecap_front_sample(spherecap_front_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = fabsf(light.elevation_sin);
    const float t2 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t3 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t4 = t2 < light.defensive;
    const float t5 = (t4 ? t2 : t2 - light.defensive) / (t4 ? light.defensive : 1.0f - light.defensive);
    const float t6 = 0.0f < light.requested ? spherecap_min(spherecap_max(t5, 5.9604645e-8f), 0.99999994f) : t2;
    const bool t7 = !(0.0f < light.tau) || t4;
    const bool t8 = !(0.0f < light.elevation_sin) && !t7;
    const bool t9 = light.crescent_share <= t6 && !t8;
    const bool t10 = t7 || t9;
    const float t11 = 1.0f - t3;
    const float t12 = t3 - t11;
    const float t13 = 4.0f * t3 * t11;
    const float t14 = spherecap_max((t6 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t15 = t7 ? t6 : spherecap_min(t14, 0.99999994f);
    const float t16 = t7 ? 0.0f : light.beyond;
    const float t17 = 1.6660811f - t16;
    const float t18 = fmaf(t15, t17, t16);
    const float t19 = (1.0f - t15) * t17;
    float t21, t22, t23;
    float t20 = 0.0f;
    if (t10) {
        t21 = spherecap_min(t18, t19);
        t22 = 1.0f;
        t23 = 1.0f;
    } else {
        const float t24 = sqrtf(t13);
        const float t25 = fmaf(fmaf(fmaf(light.b_6, t13, light.b_4), t13, light.b_2), t13, light.b_0);
        const float t26 = t24 * fmaf(fmaf(fmaf(light.b_5, t13, light.b_3), t13, light.b_1), t24, t25);
        const float t27 = sqrtf(fmaf(t12, t12, t26 * t26));
        const float t28 = light.tau * t26;
        t23 = t8 ? fmaf(t12, t12, t28 * t28) : 1.0f;
        const float t29 = t8 ? fmaf(light.kappa, t26, t27) * fmaf(light.cut, t26, t27) : light.crescent_share;
        const float t30 = (t8 ? light.width : t6) / t29;
        const float t31 = t8 ? t30 : light.width;
        const float t32 = t23 * t31;
        const float t33 = fmaf(fmaf(fmaf(-0.00060778117f, t32, 1.0676054e-5f), t32, -0.0027203285f), t32 * t32 * t32, fmaf(fmaf(-0.011332183f, t32, -0.10000902f), t32, 1.0000001f));
        t20 = t8 ? t28 : t24;
        t21 = t8 ? t6 : spherecap_min(spherecap_max(t30, 5.9604645e-8f), 0.99999994f);
        t22 = t31 * t33;
    }
    const float t34 = spherecap_float_of_bits(fmaf(spherecap_bits(t21), -0.33333334f, 1419900500.0f));
    const float t35 = t21 * t34;
    const float t36 = fmaf(-t35, t34 * t34, 1.0f);
    const float t37 = t36 * t36;
    const float t38 = fmaf(fmaf(0.12666093f, t37, fmaf(0.14565912f, t36, 0.17283025f)), t37, fmaf(0.22221696f, t36, 0.33333334f));
    const float t39 = t22 * fmaf(t35 * t36, t38, t35);
    const float t40 = t39 * t23;
    const float t41 = t40 * t40 * t40;
    const float t42 = fmaf(fmaf(fmaf(0.022114987f, t40, -0.063446075f), t40, 0.085662976f), t41, fmaf(fmaf(-0.056249518f, t40, 0.030445365f), t40, 0.0074712755f));
    const float t43 = fmaf(t42, t41, fmaf(fmaf(0.03209764f, t40, 0.09996679f), t40, 1.0000004f));
    const float t44 = t39 * t43;
    const float t45 = t23 * t44;
    const float t46 = 2.0f - t45;
    const float t47 = t44 * t46;
    const float t48 = sqrtf(t47);
    float zenith, side, cosine, t49, t50;
    if (t10) {
        const float t51 = t18 - t19 < 0.0f ? t45 : t46;
        if (t4) {
            const float t52 = light.height * (1.0f - t47 * t13);
            const float t53 = sqrtf(light.height * (2.0f - t52));
            zenith = (t51 - 1.0f) * t53;
            const float t54 = 1.0f - t52;
            t50 = fmaf(light.elevation_sin, t54, light.elevation_cos * zenith);
            t49 = fmaf(light.elevation_cos, t54, -(light.elevation_sin * zenith));
            side = t48 * t12 * t53;
            cosine = t50 * light.on_surface;
        } else {
            const float t55 = 1.0f - t51;
            const float t56 = light.radius_sin * light.radius_sin * t13;
            const float t57 = spherecap_max(fmaf(light.climb, t51, -light.rise), 0.0f);
            t50 = sqrtf(fmaf(t47, t56, t57 * t57));
            const float t58 = t1 * light.radius_cos;
            const float t59 = light.climb * t55;
            zenith = fmaf(light.elevation_cos, fmaf(t59, t59 - 2.0f * t58, t47 * t56) / (t50 + t58), -(light.half_axis * t1 * t55));
            t49 = fmaf(light.half_axis, t55, light.middle);
            side = light.radius_sin * t48 * t12;
            cosine = t50;
        }
    } else {
        cosine = t48 * t20;
        t49 = 1.0f - t45;
        zenith = fmaf(light.elevation_cos, cosine, -((t8 ? -t1 : t1) * t49));
        side = t48 * t12;
        t50 = cosine;
    }
    const float t60 = fmaf(light.density_above, spherecap_min(spherecap_max(cosine, 0.0f), 3.4028235e38f), light.density);
    const float t61 = spherecap_max(spherecap_min(fabsf(cosine), 3.4028235e38f), 1.1754944e-38f);
    const float t62 = (0.0f < cosine ? light.density_above : 0.0f) + spherecap_min(light.density / t61, 3.4028235e38f);
    const float t63 = fmaf(zenith, zenith, side * side);
    const float t64 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t63), 0.0f);
    const float t65 = sqrtf(t64);
    const float t66 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t64));
    const float t67 = light.radius_cos * light.radius_cos / (t66 + t65);
    const float t68 = 1.0f / light.radius_sin;
    const float t69 = t67 * t68;
    const float t70 = -fmaf(t66, t65, t63) * t68;
    const float t71 = t69 * zenith;
    const float t72 = t69 * side;
    const float t73 = fmaf(light.third_axis.x, t49, fmaf(light.sideways.x, side, light.up.x * t50));
    const float t74 = fmaf(light.third_axis.y, t49, fmaf(light.sideways.y, side, light.up.y * t50));
    const float t75 = fmaf(light.third_axis.z, t49, fmaf(light.sideways.z, side, light.up.z * t50));
    const float t76 = fmaf(light.elevation_cos, t70, -(light.elevation_sin * t71));
    const float t77 = fmaf(light.elevation_sin, t70, light.elevation_cos * t71);
    const float t78 = fmaf(light.third_axis.x, t76, fmaf(light.sideways.x, t72, light.up.x * t77));
    const float t79 = fmaf(light.third_axis.y, t76, fmaf(light.sideways.y, t72, light.up.y * t77));
    const float t80 = fmaf(light.third_axis.z, t76, fmaf(light.sideways.z, t72, light.up.z * t77));
    const spherecap_sample result = {
        make_float3(t73, t74, t75), t67 * light.distance, make_float3(t78, t79, t80), cosine, t60,
        spherecap_min(t62, 3.4028235e38f)
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
    const float t10 = fmaf(light.density_above, spherecap_min(spherecap_max(t6, 0.0f), 3.4028235e38f), light.density);
    const bool t11 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t12 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? t10 : 0.0f) : 0.0f;
}

static __device__ inline float spherecap_front_pdf_on_sphere(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = fmaf(light.density_above, spherecap_min(spherecap_max(t1, 0.0f), 3.4028235e38f), light.density);
    const float t3 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
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
    const bool t11 = fmaf(centre.x, centre.x, fmaf(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0f;
    const bool t12 = 9.536743e-7f < radius && t11;
    const float t13 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t13, 8.5070587e37f));
    const float t14 = t12 ? 1.0f : spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t15 = centre.x * t14;
    const float t16 = centre.y * t14;
    const float t17 = centre.z * t14;
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
    const float t28 = fmaf(t21 - t26, spherecap_max(fmaf(-t22, t22, 0.9999981f), 0.0f), t27) * 2.0f;
    const float t29 = t21 <= t26 ? t26 : 0.0f < t27 ? t27 * t27 / t28 : 0.0f;
    const float t30 = t23 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t29, t29);
    const bool t31 = t22 <= 1.0000019f && 4.9303807e-32f < t22 && 0.0f < strength && t24 && strength <= 3.4028235e38f;
    const float t32 = spherecap_min(spherecap_max(t22 * t30 * strength, 1.1754944e-38f), 3.4028235e38f);
    return ((0.0f < t30 || 0.0f < defensive) && t31) ? t32 : 0.0f;
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
    float defensive;
    float requested;
    float above;
    float density_above;
    float density_below;
    float3 third_axis;
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
    const float t108 = t106 ? 1.0f / projected_above : 0.0f;
    const float t109 = t107 ? 1.0f / projected_below : 0.0f;
    const float t110 = t76 ? t108 : t109;
    const bool t111 = 0.0f < t110 && t75;
    const float t112 = t_y * t_y * t_y * shape * t110;
    const float t113 = t_y / radius_sin;
    const float t114 = fmaf(cut - t_x, shape_difference, shape);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t75) {
        const float t115 = 1.0f + kappa;
        const float t116 = t115 * shape;
        const float t117 = 1.0f / (norm * t116);
        const float t118 = sqrtf(t117);
        b_0 = norm * t118;
        const float t119 = 1.0f / (1.0f + cut);
        const float t120 = (t_x + kappa) * t119 - 0.5f;
        const float t121 = t120 * t120 * t120;
        const float t122 = fmaf(fmaf(fmaf(-0.026061837f, t120, 0.05430631f), t120, -0.06372378f), t121, fmaf(fmaf(0.080950715f, t120, -0.11762552f), t120, 0.1684019f));
        const float t123 = fmaf(t122, t121, fmaf(fmaf(-0.23594604f, t120, 0.32709444f), t120, -0.44721135f));
        const float t124 = fmaf(t123, t121, fmaf(fmaf(0.5987523f, t120, -0.7754678f), t120, 0.94559944f));
        const float t125 = t115 * t124 * (t119 * t119 * t119) * (t116 * t117);
        const float t126 = fmaf(t125, t116 * t118, -1.0f);
        const float t127 = 1.0f - t125;
        const float t128 = fmaf(fmaf(30.011856f, t126, fmaf(-41.541264f, t127, -37.009792f)), t126, fmaf(77.96775f, t127, 7.470758f));
        const float t129 = fmaf(t128, t126, fmaf(fmaf(-49.13454f, t127, -9.466533f), t127, -1.5877596f));
        const float t130 = fmaf(fmaf(fmaf(15.716111f, t127, 0.0f), t127, 9.961183f), t127, -2.61785f);
        const float t131 = t126 * fmaf(t129, t126, fmaf(t130, t127, 0.8681748f));
        const float t132 = fmaf(fmaf(7.295638f, t126, -7.236236f), t126, fmaf(fmaf(fmaf(-11.4868555f, t127, 0.0f), t127, 0.0f), t127, 3.1255686f));
        const float t133 = fmaf(fmaf(fmaf(13.728438f, t127, -7.981878f), t127, 2.025724f), t127, -0.7334958f);
        const float t134 = t126 * fmaf(t132, t126, t133);
        const float t135 = fmaf(fmaf(fmaf(9.986537f, t127, 25.22195f), t127, 0.0f), t127, -2.9581387f);
        const float t136 = fmaf(fmaf(fmaf(-19.722994f, t127, 4.6594768f), t127, -0.89538246f), t127, 0.5143498f);
        const float t137 = t126 * fmaf(fmaf(fmaf(-23.220068f, t127, 7.332055f), t126, t135), t126, t136);
        const float t138 = fmaf(fmaf(fmaf(1.946617f, t126, -3.077631f), t126, 1.4945927f), t126, -0.24140751f);
        const float t139 = t126 * t138;
        const float t140 = t126 * fmaf(fmaf(0.38173297f, t126, -0.30305624f), t126, 0.05897375f);
        b_1 = t125 - b_0 + t131;
        b_2 = t134 - t131;
        b_3 = t137 - t134;
        b_4 = t139 - t137;
        b_5 = t140 - t139;
        b_6 = -t140;
    }
    const float t141 = (!(t106 || t107) && (0.0f < defensive || !(0.0f < on_surface))) ? 1.0f : defensive;
    const bool t142 = 0.0f < t141;
    const float t143 = (0.0f < radius_cos && t103) ? t99 / (1.0f + radius_cos) : 0.0f;
    const float density = t142 ? t141 * (0.0f < t143 ? 0.15915494f / t143 : 0.0f) : 0.0f;
    const float t144 = 1.0f - t141;
    float t145 = 0.0f;
    if (0.0f < tau) {
        const float t146 = 1.0f / (elevation_cos * elevation_cos);
        const float t147 = tau * tau;
        const float t148 = t147 * t146 / (1.0f + t_x);
        const float t149 = kappa - 0.5f;
        const float t150 = cut - 0.5f;
        const float t151 = t149 * t149;
        const float t152 = t150 * t150;
        const float t153 = fmaf(0.05430631f, t151, 0.080950715f);
        const float t154 = fmaf(t153, t151, 0.1684019f);
        const float t155 = fmaf(t154, t151, 0.32709444f);
        const float t156 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t152, t153), t152, t154), t152, t155), t152, fmaf(t155, t151, 0.5987523f));
        const float t157 = fmaf(-0.026061837f, t151, -0.06372378f);
        const float t158 = fmaf(t157, t151, -0.11762552f);
        const float t159 = fmaf(t158, t151, -0.23594604f);
        const float t160 = fmaf(t159, t151, -0.44721135f);
        const float t161 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t152, t157), t152, t158), t152, t159), t152, t160);
        const float t162 = fmaf(kappa * t148, fmaf(fmaf(t150, t161, t156), t149 + t150, fmaf(t160, t151, -0.7754678f)), fmaf(t114, t148 - kappa * kappa, kappa) * t146);
        const float t163 = spherecap_max(t147 * tau * (radius_cos + 1.0f) * t162 * 0.31830987f, 0.0f);
        t145 = spherecap_min(t163, 0.5f);
    }
    const float t164 = 1.0f - t145;
    const bool t165 = 0.0f < t109;
    const bool t166 = 0.0f < t108;
    const float above = t165 ? (t166 ? (t76 ? t164 : t145) : 0.0f) : 1.0f;
    const float density_above = t108 * above * t144;
    const float density_below = t109 * (t166 ? (t165 ? (t76 ? t145 : t164) : 0.0f) : 1.0f) * t144;
    const bool t167 = distance <= 3.4028235e38f && 0.0f < density_above + density_below + density;
    const bool t168 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && t167;
    const spherecap_both_light result = {
        t168, t168 ? t143 * 6.2831855f : 0.0f, t168 ? projected_above : 0.0f,
        make_float3(t13 * t72, t14 * t72, t15 * t72), make_float3(sideways_x, sideways_y, sideways_z),
        make_float3(normal_x, normal_y, normal_z), make_float3(up_x, up_y, up_z), on_surface, distance,
        radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, t141, defensive,
        above, density_above, density_below,
        make_float3(fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))),
        t142 ? t143 : 0.0f, density, t111 ? t112 : 0.0f, t111 ? 1.0f / (1.0f - t112) : 1.0f,
        t111 ? t113 * t113 * t113 * (t114 * 0.53033006f) : 0.0f, elevation_cos * radius_cos,
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
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t5 = t3 < light.defensive;
    const float t6 = (t5 ? t3 : t3 - light.defensive) / (t5 ? light.defensive : 1.0f - light.defensive);
    const float t7 = 0.0f < light.requested ? spherecap_min(spherecap_max(t6, 5.9604645e-8f), 0.99999994f) : t3;
    const bool t8 = t7 < light.above || t5;
    const float t9 = spherecap_max((t8 ? t7 : t7 - light.above) / (t8 ? light.above : 1.0f - light.above), 5.9604645e-8f);
    const bool t10 = t8 && t1;
    const bool t11 = !t8 && !t1;
    const float t12 = t5 ? t7 : spherecap_min(t9, 0.99999994f);
    const bool t13 = !(0.0f < light.tau) || t5;
    const bool t14 = !(t10 || t11) && !t13;
    const bool t15 = light.crescent_share <= t12 && !t14;
    const bool t16 = t13 || t15;
    const float t17 = 1.0f - t4;
    const float t18 = t4 - t17;
    const float t19 = 4.0f * t4 * t17;
    const float t20 = spherecap_max((t12 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t21 = t13 ? t12 : spherecap_min(t20, 0.99999994f);
    const float t22 = t13 ? 0.0f : light.beyond;
    const float t23 = 1.6660811f - t22;
    const float t24 = fmaf(t21, t23, t22);
    const float t25 = (1.0f - t21) * t23;
    float t27, t28, t29;
    float t26 = 0.0f;
    if (t16) {
        t27 = spherecap_min(t24, t25);
        t28 = 1.0f;
        t29 = 1.0f;
    } else {
        const float t30 = sqrtf(t19);
        const float t31 = fmaf(fmaf(fmaf(light.b_6, t19, light.b_4), t19, light.b_2), t19, light.b_0);
        const float t32 = t30 * fmaf(fmaf(fmaf(light.b_5, t19, light.b_3), t19, light.b_1), t30, t31);
        const float t33 = sqrtf(fmaf(t18, t18, t32 * t32));
        const float t34 = light.tau * t32;
        t29 = t14 ? fmaf(t18, t18, t34 * t34) : 1.0f;
        const float t35 = t14 ? fmaf(light.kappa, t32, t33) * fmaf(light.cut, t32, t33) : light.crescent_share;
        const float t36 = (t14 ? light.width : t12) / t35;
        t27 = t14 ? t12 : spherecap_min(spherecap_max(t36, 5.9604645e-8f), 0.99999994f);
        const float t37 = t14 ? t36 : light.width;
        const float t38 = t29 * t37;
        const float t39 = fmaf(fmaf(fmaf(-0.00060778117f, t38, 1.0676054e-5f), t38, -0.0027203285f), t38 * t38 * t38, fmaf(fmaf(-0.011332183f, t38, -0.10000902f), t38, 1.0000001f));
        t26 = t14 ? t34 : t30;
        t28 = t37 * t39;
    }
    const float t40 = spherecap_float_of_bits(fmaf(spherecap_bits(t27), -0.33333334f, 1419900500.0f));
    const float t41 = t27 * t40;
    const float t42 = fmaf(-t41, t40 * t40, 1.0f);
    const float t43 = t42 * t42;
    const float t44 = fmaf(fmaf(0.12666093f, t43, fmaf(0.14565912f, t42, 0.17283025f)), t43, fmaf(0.22221696f, t42, 0.33333334f));
    const float t45 = t28 * fmaf(t41 * t42, t44, t41);
    const float t46 = t45 * t29;
    const float t47 = t46 * t46 * t46;
    const float t48 = fmaf(fmaf(fmaf(0.022114987f, t46, -0.063446075f), t46, 0.085662976f), t47, fmaf(fmaf(-0.056249518f, t46, 0.030445365f), t46, 0.0074712755f));
    const float t49 = fmaf(t48, t47, fmaf(fmaf(0.03209764f, t46, 0.09996679f), t46, 1.0000004f));
    const float t50 = t45 * t49;
    const float t51 = t29 * t50;
    const float t52 = 2.0f - t51;
    const float t53 = t50 * t52;
    const float t54 = sqrtf(t53);
    float side, t55, t56, t57, t58;
    if (t16) {
        const float t59 = t24 - t25 < 0.0f ? t51 : t52;
        if (t5) {
            const float t60 = light.height * (1.0f - t53 * t19);
            const float t61 = sqrtf(light.height * (2.0f - t60));
            t57 = (t59 - 1.0f) * t61;
            const float t62 = 1.0f - t60;
            t56 = fmaf(light.elevation_sin, t62, light.elevation_cos * t57);
            t55 = fmaf(light.elevation_cos, t62, -(light.elevation_sin * t57));
            side = t54 * t18 * t61;
            t58 = t56 * light.on_surface;
        } else {
            const float t63 = 1.0f - t59;
            const float t64 = light.radius_sin * light.radius_sin * t19;
            const float t65 = spherecap_max(fmaf(light.climb, t59, -light.rise), 0.0f);
            t56 = sqrtf(fmaf(t53, t64, t65 * t65));
            const float t66 = t2 * light.radius_cos;
            const float t67 = light.climb * t63;
            t57 = fmaf(light.elevation_cos, fmaf(t67, t67 - 2.0f * t66, t53 * t64) / (t56 + t66), -(light.half_axis * t2 * t63));
            t55 = fmaf(light.half_axis, t63, light.middle);
            side = light.radius_sin * t54 * t18;
            t58 = t56;
        }
    } else {
        t56 = t54 * t26;
        t55 = 1.0f - t51;
        side = t54 * t18;
        t57 = fmaf(light.elevation_cos, t56, -((t14 ? -t2 : t2) * t55));
        t58 = t56;
    }
    const float t68 = t8 ? 1.0f : -1.0f;
    const float zenith = t57 * t68;
    const float cosine = t58 * t68;
    const float t69 = t56 * t68;
    const float t70 = spherecap_min(fabsf(cosine), 3.4028235e38f);
    const float t71 = 0.0f < cosine ? light.density_above : cosine < 0.0f ? light.density_below : 0.0f;
    const float t72 = spherecap_min(light.density / spherecap_max(t70, 1.1754944e-38f), 3.4028235e38f);
    const float t73 = fmaf(zenith, zenith, side * side);
    const float t74 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t73), 0.0f);
    const float t75 = sqrtf(t74);
    const float t76 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t74));
    const float t77 = light.radius_cos * light.radius_cos / (t76 + t75);
    const float t78 = 1.0f / light.radius_sin;
    const float t79 = t77 * t78;
    const float t80 = -fmaf(t76, t75, t73) * t78;
    const float t81 = t79 * zenith;
    const float t82 = t79 * side;
    const float t83 = fmaf(light.third_axis.x, t55, fmaf(light.sideways.x, side, light.up.x * t69));
    const float t84 = fmaf(light.third_axis.y, t55, fmaf(light.sideways.y, side, light.up.y * t69));
    const float t85 = fmaf(light.third_axis.z, t55, fmaf(light.sideways.z, side, light.up.z * t69));
    const float t86 = fmaf(light.elevation_cos, t80, -(light.elevation_sin * t81));
    const float t87 = fmaf(light.elevation_sin, t80, light.elevation_cos * t81);
    const float t88 = fmaf(light.third_axis.x, t86, fmaf(light.sideways.x, t82, light.up.x * t87));
    const float t89 = fmaf(light.third_axis.y, t86, fmaf(light.sideways.y, t82, light.up.y * t87));
    const float t90 = fmaf(light.third_axis.z, t86, fmaf(light.sideways.z, t82, light.up.z * t87));
    const spherecap_sample result = {
        make_float3(t83, t84, t85), t77 * light.distance, make_float3(t88, t89, t90), cosine,
        fmaf(t71, t70, light.density), spherecap_min(t71 + t72, 3.4028235e38f)
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
    const float t10 = fmaf(0.0f < t6 ? light.density_above : t6 < 0.0f ? light.density_below : 0.0f, spherecap_min(fabsf(t6), 3.4028235e38f), light.density);
    const bool t11 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t12 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t12 && t12 <= 1.002001f) ? (t11 ? t10 : 0.0f) : 0.0f;
}

static __device__ inline float spherecap_both_pdf_on_sphere(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = fmaf(0.0f < t1 ? light.density_above : t1 < 0.0f ? light.density_below : 0.0f, spherecap_min(fabsf(t1), 3.4028235e38f), light.density);
    const float t3 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t3 && t3 <= 1.002001f) ? t2 : 0.0f;
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
    const bool t11 = fmaf(centre.x, centre.x, fmaf(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0f;
    const bool t12 = 9.536743e-7f < radius && t11;
    const float t13 = spherecap_max(fabsf(centre.x) + fabsf(centre.y) + (fabsf(centre.z) + radius), 1.1754944e-38f);
    const float unscale = spherecap_power_of_two(spherecap_min(t13, 8.5070587e37f));
    const float t14 = t12 ? 1.0f : spherecap_float_of_bits(2130706400.0f - spherecap_bits(unscale));
    const float t15 = centre.x * t14;
    const float t16 = centre.y * t14;
    const float t17 = centre.z * t14;
    const float t18 = radius * t14;
    const float t19 = sqrtf(fmaf(t15, t15, fmaf(t16, t16, t17 * t17)));
    const float t20 = 1.0f / t19;
    const float t21 = t18 * t20;
    const float t22 = t21 * t21;
    const float t23 = fmaf(t2, t2, fmaf(t3, t3, t4 * t4));
    const bool t24 = 0.0f <= defensive && defensive <= 1.0f && t23 <= 2.0f && 0.0f < radius && t19 * (t12 ? 1.0f : unscale) <= 3.4028235e38f;
    const float t25 = fmaf(t2, t15, fmaf(t3, t16, t4 * t17));
    const float t26 = spherecap_max(fmaf(-t22, t22, 0.9999981f), 0.0f);
    const float t27 = fmaf(t25, t20, 2.3841858e-7f);
    const float t28 = fmaf(t25 + t18, t20, 2.3841858e-7f);
    const float t29 = t21 <= t27 ? t27 : 0.0f < t28 ? t28 * t28 / (fmaf(t21 - t27, t26, t28) * 2.0f) : 0.0f;
    const float t30 = fmaf(-t25, t20, 2.3841858e-7f);
    const float t31 = fmaf(-t25 + t18, t20, 2.3841858e-7f);
    const float t32 = t21 <= t30 ? t30 : 0.0f < t31 ? t31 * t31 / (fmaf(t21 - t30, t26, t31) * 2.0f) : 0.0f;
    const float t33 = t29 + t32;
    const float t34 = t23 <= 0.0f ? 1.0f : fmaf(defensive, 0.5f - t33, t33);
    const bool t35 = t22 <= 1.0000019f && 4.9303807e-32f < t22 && 0.0f < strength && t24 && strength <= 3.4028235e38f;
    const float t36 = spherecap_min(spherecap_max(t22 * t34 * strength, 1.1754944e-38f), 3.4028235e38f);
    return ((0.0f < t34 || 0.0f < defensive) && t35) ? t36 : 0.0f;
}


#endif
