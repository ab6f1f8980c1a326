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
    const float t58 = sqrtf(t13);
    const bool t59 = 0.0f < t13;
    float t60;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (0.0f < t57 && t59) {
        t60 = sqrtf(t13 + t57);
        const float t61 = sqrtf(t57);
        const float t62 = 1.0f / (t60 * t8);
        const float t63 = t62 * t8;
        const float t64 = t62 * t60;
        t_x = t58 * t63;
        t_y = t61 * t63;
        const float t65 = t_y * t_y;
        kappa = fabsf(t53) * t64;
        cut = kappa * t_x;
        const float t66 = t_x - 0.5f;
        const float t67 = cut - 0.5f;
        const float t68 = t66 * t66;
        const float t69 = t67 * t67;
        const float t70 = fmaf(0.05430631f, t68, 0.080950715f);
        const float t71 = fmaf(t70, t68, 0.1684019f);
        const float t72 = fmaf(t71, t68, 0.32709444f);
        const float t73 = fmaf(t72, t68, 0.5987523f);
        const float t74 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t69, t70), t69, t71), t69, t72), t69, t73);
        const float t75 = fmaf(-0.026061837f, t68, -0.06372378f);
        const float t76 = fmaf(t75, t68, -0.11762552f);
        const float t77 = fmaf(t76, t68, -0.23594604f);
        const float t78 = fmaf(t77, t68, -0.44721135f);
        const float t79 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t69, t75), t69, t76), t69, t77), t69, t78);
        const float t80 = fmaf(t78, t68, -0.7754678f);
        shape = fmaf(t80, t66, fmaf(t73, t68, 0.94559944f));
        shape_difference = fmaf(fmaf(t67, t79, t74), t66 + t67, t80);
        norm = fmaf(cut, shape_difference, shape);
        width = t65 / (1.0f + t_x);
        tau = t61 * t64;
        area = t65 * t_y * (spherecap_min(t55, t56) * t64) * norm;
    } else {
        t60 = t32;
    }
    const float t81 = sqrtf(t12);
    const float t82 = 1.0f / t81;
    const float radius_sin = t8 * t82;
    const float radius_cos = t58 * t82;
    const float elevation_sin = t53 * t82;
    const float elevation_cos = t60 * t82;
    const float t83 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t57 * (t82 * t82) / fmaf(radius_cos, t83, climb), -(radius_cos * t83));
    const float t84 = radius_sin * radius_sin;
    const bool t85 = 0.0f < elevation_sin;
    const float t86 = t85 ? fmaf(t84 * t83, 3.1415927f, area) : area;
    const bool t87 = 9.8607613e-32f < t84;
    const float t88 = 1.0f / t31;
    const float sideways_x = t28 * t88;
    const float sideways_y = t29 * t88;
    const float sideways_z = t30 * t88;
    const float distance = t81 * (t2 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t86 && t87 && t59) ? t86 : 0.0f;
    const bool t89 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float t90 = t85 ? inv_above : 0.0f;
    const bool t91 = t89 && t85 && 0.0f < t90;
    const float t92 = t_y * t_y * t_y * shape * t90;
    const float t93 = t_y / radius_sin;
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t89 && !t85) {
        const float t94 = 1.0f + kappa;
        const float t95 = t94 * shape;
        const float t96 = 1.0f / (norm * t95);
        const float t97 = sqrtf(t96);
        b_0 = norm * t97;
        const float t98 = 1.0f / (1.0f + cut);
        const float t99 = (t_x + kappa) * t98 - 0.5f;
        const float t100 = t99 * t99;
        const float t101 = fmaf(fmaf(fmaf(-0.026061837f, t100, -0.06372378f), t100, -0.11762552f), t100, -0.23594604f);
        const float t102 = fmaf(fmaf(fmaf(0.05430631f, t100, 0.080950715f), t100, 0.1684019f), t100, 0.32709444f);
        const float t103 = fmaf(fmaf(fmaf(t101, t100, -0.44721135f), t100, -0.7754678f), t99, fmaf(fmaf(t102, t100, 0.5987523f), t100, 0.94559944f));
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
    const float t121 = ((0.0f < radius_cos && t87) ? t84 / (1.0f + radius_cos) : 0.0f) * 6.2831855f;
    const spherecap_surface_light result = {
        t120, t120 ? t121 : 0.0f, t120 ? projected_above : 0.0f, make_float3(t5 * t82, t6 * t82, t7 * t82),
        make_float3(sideways_x, sideways_y, sideways_z), normal, distance, radius_sin, radius_cos,
        elevation_sin, elevation_cos, tau, kappa, width, cut, rise, inv_above,
        make_float3(fmaf(sideways_y, normal.z, -(sideways_z * normal.y)), fmaf(sideways_z, normal.x, -(sideways_x * normal.z)), fmaf(sideways_x, normal.y, -(sideways_y * normal.x))),
        t91 ? t92 : 0.0f, t91 ? 1.0f / (1.0f - t92) : 1.0f,
        t91 ? t93 * t93 * t93 * fmaf(cut - t_x, shape_difference, shape) : 0.0f, elevation_cos * radius_cos,
        radius_sin * t83, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

static __device__ inline spherecap_sample spherecap_surface_sample(spherecap_surface_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = fabsf(light.elevation_sin);
    const bool t2 = 0.0f < light.tau;
    const bool t3 = !(0.0f < light.elevation_sin) && t2;
    const float t4 = spherecap_min(spherecap_max(u0, 5.9604645e-8f), 0.99999994f);
    const float t5 = spherecap_min(spherecap_max(u1, 5.9604645e-8f), 0.99999994f);
    const bool t6 = light.crescent_share <= t4 && !t3;
    const bool t7 = !t2 || t6;
    const float t8 = 1.0f - t5;
    const float t9 = t5 - t8;
    const float t10 = 4.0f * t5 * t8;
    const float t11 = spherecap_max((t4 - light.crescent_share) * light.inv_rest, 5.9604645e-8f);
    const float t12 = t2 ? spherecap_min(t11, 0.99999994f) : t4;
    const float t13 = t2 ? light.beyond : 0.0f;
    const float t14 = 3.1415927f - t13;
    const float t15 = fmaf(t12, t14, t13);
    const float t16 = (1.0f - t12) * t14;
    float t18, t19, t20;
    float t17 = 0.0f;
    if (t7) {
        t18 = spherecap_min(t15, t16) * 0.53033006f;
        t19 = 1.0f;
        t20 = 1.0f;
    } else {
        const float t21 = sqrtf(t10);
        const float t22 = fmaf(fmaf(fmaf(light.b_6, t10, light.b_4), t10, light.b_2), t10, light.b_0);
        const float t23 = t21 * fmaf(fmaf(fmaf(light.b_5, t10, light.b_3), t10, light.b_1), t21, t22);
        const float t24 = sqrtf(fmaf(t9, t9, t23 * t23));
        const float t25 = light.tau * t23;
        t20 = t3 ? fmaf(t9, t9, t25 * t25) : 1.0f;
        const float t26 = t3 ? fmaf(light.kappa, t23, t24) * fmaf(light.cut, t23, t24) : light.crescent_share;
        const float t27 = (t3 ? light.width : t4) / t26;
        const float t28 = t3 ? t27 : light.width;
        const float t29 = t20 * t28;
        const float t30 = t29 * t29;
        const float t31 = fmaf(fmaf(fmaf(-0.00060778117f, t30, -0.0027203285f), t30, -0.10000902f), t29, fmaf(fmaf(1.0676054e-5f, t30, -0.011332183f), t30, 1.0000001f));
        t17 = t3 ? t25 : t21;
        t18 = t3 ? t4 : spherecap_min(spherecap_max(t27, 5.9604645e-8f), 0.99999994f);
        t19 = t28 * t31;
    }
    const float t32 = spherecap_float_of_bits(fmaf(spherecap_bits(t18), -0.33333334f, 1419900500.0f));
    const float t33 = fmaf(-(t18 * t32), t32 * t32, 1.0f);
    const float t34 = t33 * t33;
    const float t35 = fmaf(fmaf(fmaf(0.110958695f, t34, 0.14403293f), t34, 0.22222222f), t33, fmaf(fmaf(0.12482853f, t34, 0.17283951f), t34, 0.33333334f));
    const float t36 = t19 * (t18 * fmaf(t32, t33 * t35, t32));
    const float t37 = t36 * t20;
    const float t38 = t37 * t37;
    const float t39 = fmaf(fmaf(fmaf(-0.063446075f, t38, -0.056249518f), t38, 0.0074712755f), t38, 0.09996679f);
    const float t40 = fmaf(fmaf(fmaf(0.022114987f, t38, 0.085662976f), t38, 0.030445365f), t38, 0.03209764f);
    const float t41 = t36 * fmaf(t39, t37, fmaf(t40, t38, 1.0000004f));
    const float t42 = t7 ? spherecap_min(t41, 1.0f) : t41;
    const float t43 = t20 * t42;
    const float t44 = 2.0f - t43;
    const float t45 = t42 * t44;
    const float t46 = sqrtf(t45);
    float zenith, side, cosine, t47;
    if (t7) {
        const float t48 = t15 - t16 < 0.0f ? t43 : t44;
        const float t49 = t45 * t10;
        const float t50 = 1.0f - t48;
        const float t51 = spherecap_max(fmaf(light.climb, t48, -light.rise), 0.0f);
        cosine = sqrtf(fmaf(t51, t51, light.radius_sin * light.radius_sin * t49));
        const float t52 = t1 * light.radius_cos;
        const float t53 = fmaf(light.elevation_cos * t50, fmaf(light.climb, t50, -2.0f * t52), light.radius_sin * t49);
        zenith = light.radius_sin * fmaf(light.elevation_cos, t53 / (cosine + t52), -(t1 * t1 * t50));
        side = light.radius_sin * t46 * t9;
        t47 = fmaf(light.half_axis, t50, light.middle);
    } else {
        cosine = t46 * t17;
        t47 = 1.0f - t43;
        zenith = fmaf(light.elevation_cos, cosine, -((t3 ? -t1 : t1) * t47));
        side = t46 * t9;
    }
    const float t54 = 0.0f < cosine ? light.inv_above : 0.0f;
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
        make_float3(t65, t66, t67), t59 * light.distance, make_float3(t70, t71, t72), cosine,
        t54 * spherecap_min(fabsf(cosine), 3.4028235e38f), t54
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
    const bool t29 = 0.0f < t8;
    const float t30 = __fmul_rn(normal_z, t14);
    const float t31 = fmaf(normal_y, t15, -t30);
    const float t32 = __fmul_rn(normal_x, t15);
    const float t33 = fmaf(normal_z, t13, -t32);
    const float t34 = __fmul_rn(normal_y, t13);
    const float t35 = fmaf(normal_x, t14, -t34);
    const float t36 = fmaf(t31, t31, fmaf(t33, t33, t35 * t35));
    float up_x, up_y, up_z, t37, t38, t39, t40, t41;
    if (t36 < t20 * 0.015625f) {
        const float t42 = t31 - spherecap_lost(normal_z, t14, t30);
        const float t43 = t33 - spherecap_lost(normal_x, t15, t32);
        const float t44 = t35 - spherecap_lost(normal_y, t13, t34);
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
    const float t55 = __fmul_rn(normal_x, t13);
    const float t56 = __fmul_rn(normal_y, t14);
    const float t57 = __fmul_rn(normal_z, t15);
    const float t58 = __fadd_rn(t55, t56);
    const float t59 = __fsub_rn(t58, t55);
    const float t60 = __fadd_rn(t58, t57);
    const float t61 = __fsub_rn(t60, t58);
    const float t62 = spherecap_lost(normal_x, t13, t55) + spherecap_lost(normal_y, t14, t56) + spherecap_lost(normal_z, t15, t57);
    const float t63 = __fsub_rn(t55, __fsub_rn(t58, t59)) + __fsub_rn(t56, t59) + (__fsub_rn(t58, __fsub_rn(t60, t61)) + __fsub_rn(t57, t61));
    const float t64 = t62 + t63;
    const float t65 = __fadd_rn(t60, t64);
    const float t66 = __fsub_rn(t64, __fsub_rn(t65, t60));
    const float t67 = t16 - t65 - t66;
    const float t68 = t16 + t65 + t66;
    const float t69 = t67 * t68;
    const float t70 = sqrtf(t21);
    const bool t71 = 0.0f < t21;
    float t72;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (0.0f < t69 && t29 && t71) {
        t72 = sqrtf(t21 + t69);
        const float t73 = sqrtf(t69);
        const float t74 = 1.0f / (t72 * t16);
        const float t75 = t74 * t16;
        const float t76 = t74 * t72;
        t_x = t70 * t75;
        t_y = t73 * t75;
        const float t77 = t_y * t_y;
        kappa = fabsf(t65) * t76;
        cut = kappa * t_x;
        const float t78 = t_x - 0.5f;
        const float t79 = cut - 0.5f;
        const float t80 = t78 * t78;
        const float t81 = t79 * t79;
        const float t82 = fmaf(0.05430631f, t80, 0.080950715f);
        const float t83 = fmaf(t82, t80, 0.1684019f);
        const float t84 = fmaf(t83, t80, 0.32709444f);
        const float t85 = fmaf(t84, t80, 0.5987523f);
        const float t86 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t81, t82), t81, t83), t81, t84), t81, t85);
        const float t87 = fmaf(-0.026061837f, t80, -0.06372378f);
        const float t88 = fmaf(t87, t80, -0.11762552f);
        const float t89 = fmaf(t88, t80, -0.23594604f);
        const float t90 = fmaf(t89, t80, -0.44721135f);
        const float t91 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t81, t87), t81, t88), t81, t89), t81, t90);
        const float t92 = fmaf(t90, t80, -0.7754678f);
        shape = fmaf(t92, t78, fmaf(t85, t80, 0.94559944f));
        shape_difference = fmaf(fmaf(t79, t91, t86), t78 + t79, t92);
        norm = fmaf(cut, shape_difference, shape);
        width = t77 / (1.0f + t_x);
        tau = t73 * t76;
        area = t77 * t_y * (spherecap_min(t67, t68) * t76) * norm;
    } else {
        t72 = t41;
    }
    const float t93 = sqrtf(t20);
    const float t94 = 1.0f / t93;
    const float radius_sin = t16 * t94;
    const float radius_cos = t70 * t94;
    const float elevation_sin = t65 * t94;
    const float elevation_cos = t72 * t94;
    const float t95 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t69 * (t94 * t94) / fmaf(radius_cos, t95, climb), -(radius_cos * t95));
    const float t96 = radius_sin * radius_sin;
    const bool t97 = 0.0f < elevation_sin;
    const float t98 = t97 ? fmaf(t96 * t95, 3.1415927f, area) : area;
    const bool t99 = 9.8607613e-32f < t96;
    const float t100 = 1.0f / t40;
    const float sideways_x = t37 * t100;
    const float sideways_y = t38 * t100;
    const float sideways_z = t39 * t100;
    const float on_surface = t29 ? 1.0f : 0.0f;
    const float distance = t93 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t98 && t99 && t71) ? t98 : 0.0f;
    const bool t101 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const bool t102 = 0.0f < inv_above;
    const float t103 = t97 ? inv_above : 0.0f;
    const float share = t102 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t104 = t101 && t97 && 0.0f < t103;
    const float t105 = t_y * t_y * t_y * shape * t103;
    const float t106 = t_y / radius_sin;
    const float beyond = t104 ? t106 * t106 * t106 * fmaf(cut - t_x, shape_difference, shape) : 0.0f;
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    if (t101 && !t97) {
        const float t107 = 1.0f + kappa;
        const float t108 = t107 * shape;
        const float t109 = 1.0f / (norm * t108);
        const float t110 = sqrtf(t109);
        b_0 = norm * t110;
        const float t111 = 1.0f / (1.0f + cut);
        const float t112 = (t_x + kappa) * t111 - 0.5f;
        const float t113 = t112 * t112;
        const float t114 = fmaf(fmaf(fmaf(-0.026061837f, t113, -0.06372378f), t113, -0.11762552f), t113, -0.23594604f);
        const float t115 = fmaf(fmaf(fmaf(0.05430631f, t113, 0.080950715f), t113, 0.1684019f), t113, 0.32709444f);
        const float t116 = fmaf(fmaf(fmaf(t114, t113, -0.44721135f), t113, -0.7754678f), t112, fmaf(fmaf(t115, t113, 0.5987523f), t113, 0.94559944f));
        const float t117 = t107 * t116 * (t111 * t111 * t111) * (t108 * t109);
        const float t118 = fmaf(t117, t108 * t110, -1.0f);
        const float t119 = 1.0f - t117;
        const float t120 = fmaf(fmaf(30.011856f, t118, fmaf(-41.541264f, t119, -37.009792f)), t118, fmaf(77.96775f, t119, 7.470758f));
        const float t121 = fmaf(t120, t118, fmaf(fmaf(-49.13454f, t119, -9.466533f), t119, -1.5877596f));
        const float t122 = fmaf(fmaf(fmaf(15.716111f, t119, 0.0f), t119, 9.961183f), t119, -2.61785f);
        const float t123 = t118 * fmaf(t121, t118, fmaf(t122, t119, 0.8681748f));
        const float t124 = fmaf(fmaf(7.295638f, t118, -7.236236f), t118, fmaf(fmaf(fmaf(-11.4868555f, t119, 0.0f), t119, 0.0f), t119, 3.1255686f));
        const float t125 = fmaf(fmaf(fmaf(13.728438f, t119, -7.981878f), t119, 2.025724f), t119, -0.7334958f);
        const float t126 = t118 * fmaf(t124, t118, t125);
        const float t127 = fmaf(fmaf(fmaf(9.986537f, t119, 25.22195f), t119, 0.0f), t119, -2.9581387f);
        const float t128 = fmaf(fmaf(fmaf(-19.722994f, t119, 4.6594768f), t119, -0.89538246f), t119, 0.5143498f);
        const float t129 = t118 * fmaf(fmaf(fmaf(-23.220068f, t119, 7.332055f), t118, t127), t118, t128);
        const float t130 = fmaf(fmaf(fmaf(1.946617f, t118, -3.077631f), t118, 1.4945927f), t118, -0.24140751f);
        const float t131 = t118 * t130;
        const float t132 = t118 * fmaf(fmaf(0.38173297f, t118, -0.30305624f), t118, 0.05897375f);
        b_1 = t117 - b_0 + t123;
        b_2 = t126 - t123;
        b_3 = t129 - t126;
        b_4 = t131 - t129;
        b_5 = t132 - t131;
        b_6 = -t132;
    }
    const bool t133 = 0.0f < share;
    const float t134 = (0.0f < radius_cos && t99) ? t96 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t133 ? (0.0f < t134 ? 0.15915494f / t134 : 0.0f) : 0.0f;
    const bool t135 = 0.0f < inv_solid_angle && t133;
    const bool t136 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t102 || t135);
    const spherecap_front_light result = {
        t136, t136 ? t134 * 6.2831855f : 0.0f, t136 ? projected_above : 0.0f,
        make_float3(t13 * t94, t14 * t94, t15 * t94), make_float3(sideways_x, sideways_y, sideways_z),
        make_float3(normal_x, normal_y, normal_z), make_float3(up_x, up_y, up_z), on_surface, distance,
        radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, share,
        1.0f - share, defensive, inv_above,
        make_float3(fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))),
        t133 ? t134 : 0.0f, inv_solid_angle, t104 ? t105 : 0.0f, t104 ? 1.0f / (1.0f - t105) : 1.0f, beyond,
        elevation_cos * radius_cos, radius_sin * t95, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
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
    const float t7 = 0.0f < light.requested ? spherecap_min(t6, 0.99999994f) : t3;
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
    const float t18 = 3.1415927f - t17;
    const float t19 = fmaf(t16, t18, t17);
    const float t20 = (1.0f - t16) * t18;
    float t22, t23, t24;
    float t21 = 0.0f;
    if (t11) {
        t22 = spherecap_min(t19, t20) * 0.53033006f;
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
        const float t34 = t33 * t33;
        const float t35 = fmaf(fmaf(fmaf(-0.00060778117f, t34, -0.0027203285f), t34, -0.10000902f), t33, fmaf(fmaf(1.0676054e-5f, t34, -0.011332183f), t34, 1.0000001f));
        t21 = t9 ? t29 : t25;
        t22 = t9 ? t7 : spherecap_min(spherecap_max(t31, 5.9604645e-8f), 0.99999994f);
        t23 = t32 * t35;
    }
    const float t36 = spherecap_float_of_bits(fmaf(spherecap_bits(t22), -0.33333334f, 1419900500.0f));
    const float t37 = fmaf(-(t22 * t36), t36 * t36, 1.0f);
    const float t38 = t37 * t37;
    const float t39 = fmaf(fmaf(fmaf(0.110958695f, t38, 0.14403293f), t38, 0.22222222f), t37, fmaf(fmaf(0.12482853f, t38, 0.17283951f), t38, 0.33333334f));
    const float t40 = t23 * (t22 * fmaf(t36, t37 * t39, t36));
    const float t41 = t40 * t24;
    const float t42 = t41 * t41;
    const float t43 = fmaf(fmaf(fmaf(-0.063446075f, t42, -0.056249518f), t42, 0.0074712755f), t42, 0.09996679f);
    const float t44 = fmaf(fmaf(fmaf(0.022114987f, t42, 0.085662976f), t42, 0.030445365f), t42, 0.03209764f);
    const float t45 = t40 * fmaf(t43, t41, fmaf(t44, t42, 1.0000004f));
    const float t46 = t11 ? spherecap_min(t45, 1.0f) : t45;
    const float t47 = t24 * t46;
    const float t48 = 2.0f - t47;
    const float t49 = t46 * t48;
    const float t50 = sqrtf(t49);
    float zenith, side, cosine, t51, t52;
    if (t11) {
        const float t53 = t19 - t20 < 0.0f ? t47 : t48;
        const float t54 = t49 * t14;
        if (t5) {
            const float t55 = light.height * (1.0f - t54);
            const float t56 = sqrtf(light.height * (2.0f - t55));
            zenith = (t53 - 1.0f) * t56;
            const float t57 = 1.0f - t55;
            t52 = fmaf(light.elevation_sin, t57, light.elevation_cos * zenith);
            t51 = fmaf(light.elevation_cos, t57, -(light.elevation_sin * zenith));
            side = t50 * t13 * t56;
            cosine = t52 * light.on_surface;
        } else {
            const float t58 = 1.0f - t53;
            const float t59 = spherecap_max(fmaf(light.climb, t53, -light.rise), 0.0f);
            t52 = sqrtf(fmaf(t59, t59, light.radius_sin * light.radius_sin * t54));
            const float t60 = t1 * light.radius_cos;
            const float t61 = fmaf(light.elevation_cos * t58, fmaf(light.climb, t58, -2.0f * t60), light.radius_sin * t54);
            zenith = light.radius_sin * fmaf(light.elevation_cos, t61 / (t52 + t60), -(t1 * t1 * t58));
            t51 = fmaf(light.half_axis, t58, light.middle);
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
    const float t62 = spherecap_min(fabsf(cosine), 3.4028235e38f);
    const float t63 = 0.0f < cosine ? light.inv_above : 0.0f;
    const float t64 = light.share * light.inv_solid_angle;
    const float t65 = fmaf(t63, light.rest, spherecap_min(t64 / spherecap_max(t62, 1.1754944e-38f), 3.4028235e38f));
    const float t66 = fmaf(zenith, zenith, side * side);
    const float t67 = spherecap_max(fmaf(light.radius_sin, light.radius_sin, -t66), 0.0f);
    const float t68 = sqrtf(t67);
    const float t69 = sqrtf(fmaf(light.radius_cos, light.radius_cos, t67));
    const float t70 = light.radius_cos * light.radius_cos / (t69 + t68);
    const float t71 = 1.0f / light.radius_sin;
    const float t72 = t70 * t71;
    const float t73 = -fmaf(t69, t68, t66) * t71;
    const float t74 = t72 * zenith;
    const float t75 = t72 * side;
    const float t76 = fmaf(light.third_axis.x, t51, fmaf(light.sideways.x, side, light.up.x * t52));
    const float t77 = fmaf(light.third_axis.y, t51, fmaf(light.sideways.y, side, light.up.y * t52));
    const float t78 = fmaf(light.third_axis.z, t51, fmaf(light.sideways.z, side, light.up.z * t52));
    const float t79 = fmaf(light.elevation_cos, t73, -(light.elevation_sin * t74));
    const float t80 = fmaf(light.elevation_sin, t73, light.elevation_cos * t74);
    const float t81 = fmaf(light.third_axis.x, t79, fmaf(light.sideways.x, t75, light.up.x * t80));
    const float t82 = fmaf(light.third_axis.y, t79, fmaf(light.sideways.y, t75, light.up.y * t80));
    const float t83 = fmaf(light.third_axis.z, t79, fmaf(light.sideways.z, t75, light.up.z * t80));
    const spherecap_sample result = {
        make_float3(t76, t77, t78), t70 * light.distance, make_float3(t81, t82, t83), cosine,
        t2 ? fmaf(t63, light.rest * t62, t64) : t63 * t62, t2 ? spherecap_min(t65, 3.4028235e38f) : t63
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
    const float t10 = spherecap_min(fabsf(t6), 3.4028235e38f);
    const float t11 = 0.0f < t6 ? light.inv_above : 0.0f;
    const float t12 = 0.0f < light.share ? fmaf(t11, light.rest * t10, light.share * light.inv_solid_angle) : t11 * t10;
    const bool t13 = fmaf(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019f;
    const float t14 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t14 && t14 <= 1.002001f) ? (t13 ? t12 : 0.0f) : 0.0f;
}

static __device__ inline float spherecap_front_pdf_on_sphere(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0f;
    }
    const float t1 = fmaf(light.normal.x, direction.x, fmaf(light.normal.y, direction.y, light.normal.z * direction.z));
    const float t2 = spherecap_min(fabsf(t1), 3.4028235e38f);
    const float t3 = 0.0f < t1 ? light.inv_above : 0.0f;
    const float t4 = 0.0f < light.share ? fmaf(t3, light.rest * t2, light.share * light.inv_solid_angle) : t3 * t2;
    const float t5 = fmaf(direction.x, direction.x, fmaf(direction.y, direction.y, direction.z * direction.z));
    return (0.998001f <= t5 && t5 <= 1.002001f) ? t4 : 0.0f;
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
    const bool t29 = 0.0f < t8;
    const float t30 = __fmul_rn(normal_z, t14);
    const float t31 = fmaf(normal_y, t15, -t30);
    const float t32 = __fmul_rn(normal_x, t15);
    const float t33 = fmaf(normal_z, t13, -t32);
    const float t34 = __fmul_rn(normal_y, t13);
    const float t35 = fmaf(normal_x, t14, -t34);
    const float t36 = fmaf(t31, t31, fmaf(t33, t33, t35 * t35));
    float up_x, up_y, up_z, t37, t38, t39, t40, t41;
    if (t36 < t20 * 0.015625f) {
        const float t42 = t31 - spherecap_lost(normal_z, t14, t30);
        const float t43 = t33 - spherecap_lost(normal_x, t15, t32);
        const float t44 = t35 - spherecap_lost(normal_y, t13, t34);
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
    const float t55 = __fmul_rn(normal_x, t13);
    const float t56 = __fmul_rn(normal_y, t14);
    const float t57 = __fmul_rn(normal_z, t15);
    const float t58 = __fadd_rn(t55, t56);
    const float t59 = __fsub_rn(t58, t55);
    const float t60 = __fadd_rn(t58, t57);
    const float t61 = __fsub_rn(t60, t58);
    const float t62 = spherecap_lost(normal_x, t13, t55) + spherecap_lost(normal_y, t14, t56) + spherecap_lost(normal_z, t15, t57);
    const float t63 = __fsub_rn(t55, __fsub_rn(t58, t59)) + __fsub_rn(t56, t59) + (__fsub_rn(t58, __fsub_rn(t60, t61)) + __fsub_rn(t57, t61));
    const float t64 = t62 + t63;
    const float t65 = __fadd_rn(t60, t64);
    const float t66 = __fsub_rn(t64, __fsub_rn(t65, t60));
    const float t67 = t16 - t65 - t66;
    const float t68 = t16 + t65 + t66;
    const float t69 = t67 * t68;
    const float t70 = sqrtf(t21);
    const bool t71 = 0.0f < t21;
    float t72;
    float t_x = 0.0f, t_y = 0.0f, width = 0.0f, kappa = 0.0f, cut = 0.0f, shape = 0.0f;
    float shape_difference = 0.0f, norm = 0.0f, tau = 0.0f, area = 0.0f;
    if (0.0f < t69 && t29 && t71) {
        t72 = sqrtf(t21 + t69);
        const float t73 = sqrtf(t69);
        const float t74 = 1.0f / (t72 * t16);
        const float t75 = t74 * t16;
        const float t76 = t74 * t72;
        t_x = t70 * t75;
        t_y = t73 * t75;
        const float t77 = t_y * t_y;
        kappa = fabsf(t65) * t76;
        cut = kappa * t_x;
        const float t78 = t_x - 0.5f;
        const float t79 = cut - 0.5f;
        const float t80 = t78 * t78;
        const float t81 = t79 * t79;
        const float t82 = fmaf(0.05430631f, t80, 0.080950715f);
        const float t83 = fmaf(t82, t80, 0.1684019f);
        const float t84 = fmaf(t83, t80, 0.32709444f);
        const float t85 = fmaf(t84, t80, 0.5987523f);
        const float t86 = fmaf(fmaf(fmaf(fmaf(0.05430631f, t81, t82), t81, t83), t81, t84), t81, t85);
        const float t87 = fmaf(-0.026061837f, t80, -0.06372378f);
        const float t88 = fmaf(t87, t80, -0.11762552f);
        const float t89 = fmaf(t88, t80, -0.23594604f);
        const float t90 = fmaf(t89, t80, -0.44721135f);
        const float t91 = fmaf(fmaf(fmaf(fmaf(-0.026061837f, t81, t87), t81, t88), t81, t89), t81, t90);
        const float t92 = fmaf(t90, t80, -0.7754678f);
        shape = fmaf(t92, t78, fmaf(t85, t80, 0.94559944f));
        shape_difference = fmaf(fmaf(t79, t91, t86), t78 + t79, t92);
        norm = fmaf(cut, shape_difference, shape);
        width = t77 / (1.0f + t_x);
        tau = t73 * t76;
        area = t77 * t_y * (spherecap_min(t67, t68) * t76) * norm;
    } else {
        t72 = t41;
    }
    const float t93 = sqrtf(t20);
    const float t94 = 1.0f / t93;
    const float radius_sin = t16 * t94;
    const float radius_cos = t70 * t94;
    const float elevation_sin = t65 * t94;
    const float elevation_cos = t72 * t94;
    const float t95 = fabsf(elevation_sin);
    const float climb = radius_sin * elevation_cos;
    const float rise = spherecap_max(t69 * (t94 * t94) / fmaf(radius_cos, t95, climb), -(radius_cos * t95));
    const float t96 = radius_sin * radius_sin;
    const float t97 = fmaf(t96 * t95, 3.1415927f, area);
    const bool t98 = 0.0f < elevation_sin;
    const float t99 = t98 ? t97 : area;
    const float t100 = t98 ? area : t97;
    const bool t101 = 9.8607613e-32f < t96;
    const bool t102 = t101 && t71;
    const float t103 = 1.0f / t40;
    const float sideways_x = t37 * t103;
    const float sideways_y = t38 * t103;
    const float sideways_z = t39 * t103;
    const float on_surface = t29 ? 1.0f : 0.0f;
    const float distance = t93 * (t10 ? 1.0f : unscale);
    const float projected_above = (9.403955e-38f < t99 && t102) ? t99 : 0.0f;
    const float projected_below = (9.403955e-38f < t100 && t102) ? t100 : 0.0f;
    const bool t104 = 0.0f < tau;
    const float inv_above = 0.0f < projected_above ? 1.0f / projected_above : 0.0f;
    const float inv_below = 0.0f < projected_below ? 1.0f / projected_below : 0.0f;
    const bool t105 = 0.0f < inv_above + inv_below;
    const float t106 = t98 ? inv_above : inv_below;
    const float defensive_share = t105 ? defensive : 0.0f < defensive || !(0.0f < on_surface) ? 1.0f : 0.0f;
    const bool t107 = 0.0f < t106 && t104;
    const float t108 = t_y * t_y * t_y * shape * t106;
    const float t109 = t_y / radius_sin;
    const float t110 = fmaf(cut - t_x, shape_difference, shape);
    float b_0 = 0.0f, b_1 = 0.0f, b_2 = 0.0f, b_3 = 0.0f, b_4 = 0.0f, b_5 = 0.0f, b_6 = 0.0f;
    float t111 = 0.0f;
    if (t104) {
        const float t112 = 1.0f + kappa;
        const float t113 = t112 * shape;
        const float t114 = 1.0f / (norm * t113);
        const float t115 = sqrtf(t114);
        b_0 = norm * t115;
        const float t116 = 1.0f / (1.0f + cut);
        const float t117 = (t_x + kappa) * t116 - 0.5f;
        const float t118 = t117 * t117;
        const float t119 = fmaf(fmaf(fmaf(-0.026061837f, t118, -0.06372378f), t118, -0.11762552f), t118, -0.23594604f);
        const float t120 = fmaf(fmaf(fmaf(0.05430631f, t118, 0.080950715f), t118, 0.1684019f), t118, 0.32709444f);
        const float t121 = fmaf(fmaf(fmaf(t119, t118, -0.44721135f), t118, -0.7754678f), t117, fmaf(fmaf(t120, t118, 0.5987523f), t118, 0.94559944f));
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
        const float t154 = fmaf(kappa * t140, fmaf(fmaf(t142, t153, t148), t141 + t142, fmaf(t152, t143, -0.7754678f)), fmaf(t110, t140 - kappa * kappa, kappa) * t138);
        const float t155 = spherecap_max(t139 * tau * (radius_cos + 1.0f) * t154 * 0.31830987f, 0.0f);
        b_1 = t122 - b_0 + t128;
        b_2 = t131 - t128;
        b_3 = t134 - t131;
        b_4 = t136 - t134;
        b_5 = t137 - t136;
        b_6 = -t137;
        t111 = spherecap_min(t155, 0.5f);
    }
    const bool t156 = 0.0f < defensive_share;
    const float t157 = (0.0f < radius_cos && t101) ? t96 / (1.0f + radius_cos) : 0.0f;
    const float inv_solid_angle = t156 ? (0.0f < t157 ? 0.15915494f / t157 : 0.0f) : 0.0f;
    const float t158 = 1.0f - t111;
    const bool t159 = 0.0f < inv_below;
    const bool t160 = 0.0f < inv_above;
    const bool t161 = 0.0f < inv_solid_angle && t156;
    const bool t162 = 0.0f <= defensive && defensive <= 1.0f && t8 <= 2.0f && 0.0f < radius && distance <= 3.4028235e38f && (t105 || t161);
    const spherecap_both_light result = {
        t162, t162 ? t157 * 6.2831855f : 0.0f, t162 ? projected_above : 0.0f,
        make_float3(t13 * t94, t14 * t94, t15 * t94), make_float3(sideways_x, sideways_y, sideways_z),
        make_float3(normal_x, normal_y, normal_z), make_float3(up_x, up_y, up_z), on_surface, distance,
        radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, defensive_share,
        1.0f - defensive_share, defensive, inv_above, inv_below,
        t159 ? (t160 ? (t98 ? t158 : t111) : 0.0f) : 1.0f, t160 ? (t159 ? (t98 ? t111 : t158) : 0.0f) : 1.0f,
        make_float3(fmaf(sideways_y, up_z, -(sideways_z * up_y)), fmaf(sideways_z, up_x, -(sideways_x * up_z)), fmaf(sideways_x, up_y, -(sideways_y * up_x))),
        t156 ? t157 : 0.0f, inv_solid_angle, t107 ? t108 : 0.0f, t107 ? 1.0f / (1.0f - t108) : 1.0f,
        t107 ? t109 * t109 * t109 * t110 : 0.0f, elevation_cos * radius_cos, radius_sin * t95, climb, b_0,
        b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
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
    const bool t6 = t4 < light.defensive_share && t3;
    const float t7 = (t6 ? t4 : t4 - light.defensive_share) / (t6 ? light.defensive_share : light.defensive_rest);
    const float t8 = 0.0f < light.requested ? spherecap_min(spherecap_max(t7, 5.9604645e-8f), 0.99999994f) : t4;
    const bool t9 = t8 < light.sides_share || t6;
    const float t10 = (t9 ? t8 : t8 - light.sides_share) / (t9 ? light.sides_share : light.sides_rest);
    const bool t11 = t9 && t2;
    const bool t12 = !t9 && !t2;
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
    const float t24 = 3.1415927f - t23;
    const float t25 = fmaf(t22, t24, t23);
    const float t26 = (1.0f - t22) * t24;
    float t28, t29, t30;
    float t27 = 0.0f;
    if (t17) {
        t28 = spherecap_min(t25, t26) * 0.53033006f;
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
        const float t40 = t39 * t39;
        const float t41 = fmaf(fmaf(fmaf(-0.00060778117f, t40, -0.0027203285f), t40, -0.10000902f), t39, fmaf(fmaf(1.0676054e-5f, t40, -0.011332183f), t40, 1.0000001f));
        t27 = t15 ? t35 : t31;
        t29 = t38 * t41;
    }
    const float t42 = spherecap_float_of_bits(fmaf(spherecap_bits(t28), -0.33333334f, 1419900500.0f));
    const float t43 = fmaf(-(t28 * t42), t42 * t42, 1.0f);
    const float t44 = t43 * t43;
    const float t45 = fmaf(fmaf(fmaf(0.110958695f, t44, 0.14403293f), t44, 0.22222222f), t43, fmaf(fmaf(0.12482853f, t44, 0.17283951f), t44, 0.33333334f));
    const float t46 = t29 * (t28 * fmaf(t42, t43 * t45, t42));
    const float t47 = t46 * t30;
    const float t48 = t47 * t47;
    const float t49 = fmaf(fmaf(fmaf(-0.063446075f, t48, -0.056249518f), t48, 0.0074712755f), t48, 0.09996679f);
    const float t50 = fmaf(fmaf(fmaf(0.022114987f, t48, 0.085662976f), t48, 0.030445365f), t48, 0.03209764f);
    const float t51 = t46 * fmaf(t49, t47, fmaf(t50, t48, 1.0000004f));
    const float t52 = t17 ? spherecap_min(t51, 1.0f) : t51;
    const float t53 = t30 * t52;
    const float t54 = 2.0f - t53;
    const float t55 = t52 * t54;
    const float t56 = sqrtf(t55);
    float side, t57, t58, t59, t60;
    if (t17) {
        const float t61 = t25 - t26 < 0.0f ? t53 : t54;
        const float t62 = t55 * t20;
        if (t6) {
            const float t63 = light.height * (1.0f - t62);
            const float t64 = sqrtf(light.height * (2.0f - t63));
            t59 = (t61 - 1.0f) * t64;
            const float t65 = 1.0f - t63;
            t58 = fmaf(light.elevation_sin, t65, light.elevation_cos * t59);
            t57 = fmaf(light.elevation_cos, t65, -(light.elevation_sin * t59));
            side = t56 * t19 * t64;
            t60 = t58 * light.on_surface;
        } else {
            const float t66 = 1.0f - t61;
            const float t67 = spherecap_max(fmaf(light.climb, t61, -light.rise), 0.0f);
            t58 = sqrtf(fmaf(t67, t67, light.radius_sin * light.radius_sin * t62));
            const float t68 = t1 * light.radius_cos;
            const float t69 = fmaf(light.elevation_cos * t66, fmaf(light.climb, t66, -2.0f * t68), light.radius_sin * t62);
            t59 = light.radius_sin * fmaf(light.elevation_cos, t69 / (t58 + t68), -(t1 * t1 * t66));
            t57 = fmaf(light.half_axis, t66, light.middle);
            side = light.radius_sin * t56 * t19;
            t60 = t58;
        }
    } else {
        t58 = t56 * t27;
        t57 = 1.0f - t53;
        side = t56 * t19;
        t59 = fmaf(light.elevation_cos, t58, -((t15 ? -t1 : t1) * t57));
        t60 = t58;
    }
    const float t70 = t9 ? 1.0f : -1.0f;
    const float zenith = t59 * t70;
    const float cosine = t60 * t70;
    const float t71 = t58 * t70;
    const float t72 = spherecap_min(fabsf(cosine), 3.4028235e38f);
    const float t73 = 0.0f < cosine ? light.inv_above * light.sides_share : cosine < 0.0f ? light.inv_below * light.sides_rest : 0.0f;
    const float t74 = light.defensive_share * light.inv_solid_angle;
    const float t75 = fmaf(t73, light.defensive_rest, spherecap_min(t74 / spherecap_max(t72, 1.1754944e-38f), 3.4028235e38f));
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
        t3 ? fmaf(t73, light.defensive_rest * t72, t74) : t73 * t72,
        t3 ? spherecap_min(t75, 3.4028235e38f) : t73
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
