#ifndef SPHERECAP_GLSL
#define SPHERECAP_GLSL

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
// GLSL 4.00, or later for Vulkan. Define SPHERECAP_FUSED_FMA where fma() rounds once, as on all desktop GPUs: fewer instructions.

// The second where one is no number.
float spherecap_min(float a, float b) {
    return min(b, a);
}

float spherecap_max(float a, float b) {
    return max(b, a);
}

// What rounding took off the product a b.
float spherecap_lost(float a, float b, float product) {
#ifdef SPHERECAP_FUSED_FMA
    precise float lost = fma(a, b, -product);
#else
    // Products of halves are exact (Dekker).
    precise float a_high = uintBitsToFloat(floatBitsToUint(a) & 0xfffff000u);
    precise float b_high = uintBitsToFloat(floatBitsToUint(b) & 0xfffff000u);
    precise float a_low = a - a_high;
    precise float b_low = b - b_high;
    precise float lost = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
#endif
    return lost;
}

// a b + c, rounded as if once where the sum cancels.
float spherecap_fused(float a, float b, float c) {
#ifdef SPHERECAP_FUSED_FMA
    precise float sum = fma(a, b, c);
#else
    precise float product = a * b;
    precise float sum = (product + c) + spherecap_lost(a, b, product);
#endif
    return sum;
}

// A number without its sign and its significand.
float spherecap_power_of_two(float a) {
    return uintBitsToFloat(floatBitsToUint(a) & 0x7f800000u);
}

// The bits of a number, as a number.
float spherecap_bits(float a) {
    return float(floatBitsToInt(a));
}

// The number of these bits; any number where they are none.
float spherecap_float_of_bits(float a) {
    return intBitsToFloat(int(a));
}

// A sample.
// direction: Unit direction from the shading point.
// distance: Distance to the sphere along it, in the unit of the centre.
// normal: Unit outward normal of the sphere there.
// cosine: Cosine of the direction with the surface's normal: more precise than their product.
// pdf: Density of the direction, per steradian; 0 if nothing is sampled.
// projected_pdf: The same over |cosine|, but never infinite.
struct spherecap_sample {
    vec3 direction;
    float distance;
    vec3 normal;
    float cosine;
    float pdf;
    float projected_pdf;
};

spherecap_sample spherecap_no_sample() {
    spherecap_sample sampled;
    sampled.direction = vec3(0.0, 0.0, 0.0);
    sampled.distance = 0.0;
    sampled.normal = vec3(0.0, 0.0, 0.0);
    sampled.cosine = 0.0;
    sampled.pdf = 0.0;
    sampled.projected_pdf = 0.0;
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

spherecap_surface_light spherecap_surface_prepare(vec3 normal, vec3 centre, float radius) {
    const float t1 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    const float t2 = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
    const float t3 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t2));
    const float t4 = centre.x * t3;
    const float t5 = centre.y * t3;
    const float t6 = centre.z * t3;
    const float t7 = radius * t3;
    precise float t8 = t4 * t4;
    precise float t9 = t5 * t5;
    precise float t10 = t6 * t6;
    precise float t11 = t8 + t9;
    precise float t12 = t11 - t8;
    precise float t13 = t11 - t12;
    precise float t14 = t8 - t13;
    precise float t15 = t9 - t12;
    precise float t16 = t11 + t10;
    precise float t17 = t16 - t11;
    precise float t18 = t16 - t17;
    precise float t19 = t11 - t18;
    precise float t20 = t10 - t17;
    const float t21 = spherecap_lost(t4, t4, t8) + spherecap_lost(t5, t5, t9) + spherecap_lost(t6, t6, t10);
    precise float t22 = t7 * t7;
    const float t23 = t16 - t22 + (t21 + (t14 + t15 + (t19 + t20)) - spherecap_lost(t7, t7, t22));
    const bool t24 = 0.0 < t23;
    const float t25 = sqrt(t16);
    const float t26 = 1.0 / t25;
    precise float t27 = normal.x * t4;
    precise float t28 = normal.y * t5;
    precise float t29 = normal.z * t6;
    precise float t30 = t27 + t28;
    precise float t31 = t30 - t27;
    precise float t32 = t30 - t31;
    precise float t33 = t27 - t32;
    precise float t34 = t28 - t31;
    precise float t35 = t30 + t29;
    precise float t36 = t35 - t30;
    precise float t37 = t35 - t36;
    precise float t38 = t30 - t37;
    precise float t39 = t29 - t36;
    const float t40 = spherecap_lost(normal.x, t4, t27) + spherecap_lost(normal.y, t5, t28) + spherecap_lost(normal.z, t6, t29);
    const float t41 = t40 + (t33 + t34 + (t38 + t39));
    precise float t42 = t35 + t41;
    precise float t43 = t42 - t35;
    precise float t44 = t41 - t43;
    const float t45 = t7 - t42 - t44;
    const float t46 = t7 + t42 + t44;
    const float t47 = t45 * t46;
    const bool t48 = 0.0 < t47 && t24;
    precise float t49 = normal.z * t5;
    const float t50 = spherecap_fused(normal.y, t6, -t49) - spherecap_lost(normal.z, t5, t49);
    precise float t51 = normal.x * t6;
    const float t52 = spherecap_fused(normal.z, t4, -t51) - spherecap_lost(normal.x, t6, t51);
    precise float t53 = normal.y * t4;
    const float t54 = spherecap_fused(normal.x, t5, -t53) - spherecap_lost(normal.y, t4, t53);
    const float t55 = fma(t50, t50, fma(t52, t52, t54 * t54));
    const bool t56 = 9.8607613e-32 < t55;
    const bool t57 = abs(t4) < abs(t6);
    const float t58 = t57 ? 0.0 : -t5;
    const float t59 = t57 ? -t6 : t4;
    const float t60 = t57 ? t5 : 0.0;
    const float t61 = sqrt(spherecap_max(t23, 0.0));
    const float radius_cos = t61 * t26;
    const float t62 = 1.0 + radius_cos;
    const float t63 = 1.0 / (t7 * t62);
    const float t64 = t63 * t62;
    const float radius_sin = t7 * t26;
    const float inv_radius_sin = t25 * t64;
    const float t65 = sqrt(t23 + t47);
    const float t66 = sqrt(t56 ? t55 : fma(t58, t58, fma(t59, t59, t60 * t60)));
    const float elevation_sin = t42 * t26;
    const float elevation_cos = (t48 ? t65 : t56 ? t66 : 0.0) * t26;
    const float t67 = abs(elevation_sin);
    const float t68 = radius_sin * elevation_cos;
    const float t69 = spherecap_max(fma(radius_cos, t67, t68), 9.8607613e-32);
    const float t70 = 1.0 / (t69 * t66);
    const float t71 = t70 * t66;
    const float t72 = t70 * t69;
    const float frame_2_x = (t56 ? t50 : t58) * t72;
    const float frame_2_y = (t56 ? t52 : t59) * t72;
    const float frame_2_z = (t56 ? t54 : t60) * t72;
    const float frame_0_x = t4 * t26;
    const float frame_0_y = t5 * t26;
    const float frame_0_z = t6 * t26;
    float t_x = 0.0;
    float t_y = 0.0;
    float kappa = 0.0;
    float cut = 0.0;
    float shape = 0.0;
    float shape_cut = 0.0;
    float norm = 0.0;
    float width = 0.0;
    float inv_cut_1 = 0.0;
    float tau = 0.0;
    float area = 0.0;
    if (t48) {
        const float t73 = sqrt(t47);
        const float t74 = t65 + t61;
        const float t75 = 1.0 / (t65 * t74);
        const float t76 = t75 * t74;
        const float t77 = t61 * t76;
        const float t78 = t73 * t76;
        const float t79 = abs(t42) * t64;
        const float t80 = t79 * t77;
        const float t81 = t77 - 0.5;
        const float t82 = t80 - 0.5;
        const float t83 = t81 * t81;
        const float t84 = t82 * t82;
        const float t85 = fma(0.05430631, t83, 0.080950715);
        const float t86 = fma(t85, t83, 0.1684019);
        const float t87 = fma(t86, t83, 0.32709444);
        const float t88 = fma(t87, t83, 0.5987523);
        const float t89 = fma(-0.026061837, t83, -0.06372378);
        const float t90 = fma(t89, t83, -0.11762552);
        const float t91 = fma(t90, t83, -0.23594604);
        const float t92 = fma(t91, t83, -0.44721135);
        const float t93 = fma(t92, t83, -0.7754678);
        const float t94 = fma(t93, t81, fma(t88, t83, 0.94559944));
        const float t95 = fma(t82, fma(fma(fma(fma(-0.026061837, t84, t89), t84, t90), t84, t91), t84, t92), fma(fma(fma(fma(0.05430631, t84, t85), t84, t86), t84, t87), t84, t88));
        const float t96 = fma(t95, t81 + t82, t93);
        const float t97 = fma(t80, t96, t94);
        t_x = t77;
        t_y = t78;
        kappa = t79;
        cut = t80;
        shape = t94;
        shape_cut = fma(t80 - t77, t96, t94);
        norm = t97;
        width = t47 * t75;
        inv_cut_1 = t68 * t71;
        tau = t73 * t64;
        area = t78 * t78 * t78 * (spherecap_min(t45, t46) * t64) * t97;
    }
    const float t98 = radius_sin * radius_sin;
    const float t99 = elevation_sin < 0.0 ? area : t98 * t67 * 3.1415927 + area;
    const bool t100 = t24 && 9.8607613e-32 < t98;
    const float distance = t25 * t2;
    const float projected_above = (9.403955e-38 < t99 && t100) ? t99 : 0.0;
    const float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    const bool t101 = 0.0 < elevation_sin;
    const float t102 = t101 ? inv_above : 0.0;
    const bool t103 = 0.0 < tau;
    const bool t104 = t101 && t103 && 0.0 < t102;
    const float t105 = t_y * t_y * t_y * shape * t102;
    const float t106 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    if (!t101 && t103) {
        const float t107 = 1.0 + kappa;
        const float t108 = t107 * shape;
        const float t109 = 1.0 / (norm * t108);
        const float t110 = sqrt(t109);
        const float t111 = norm * t110;
        const float t112 = (t_x + kappa) * inv_cut_1 - 0.5;
        const float t113 = t112 * t112;
        const float t114 = fma(fma(fma(-0.026061837, t113, -0.06372378), t113, -0.11762552), t113, -0.23594604);
        const float t115 = fma(fma(fma(0.05430631, t113, 0.080950715), t113, 0.1684019), t113, 0.32709444);
        const float t116 = fma(fma(fma(t114, t113, -0.44721135), t113, -0.7754678), t112, fma(fma(t115, t113, 0.5987523), t113, 0.94559944));
        const float t117 = t107 * t116 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t108 * t109);
        const float t118 = fma(t117, t108 * t110, -1.0);
        const float t119 = 1.0 - t117;
        const float t120 = fma(fma(30.011856, t118, fma(-41.541264, t119, -37.009792)), t118, fma(77.96775, t119, 7.470758));
        const float t121 = fma(fma(fma(fma(15.716111, t119, 0.0), t119, 9.961183), t119, -2.61785), t119, 0.8681748);
        const float t122 = fma(fma(t120, t118, fma(fma(-49.13454, t119, -9.466533), t119, -1.5877596)), t118, t121);
        const float t123 = t118 * t122;
        const float t124 = fma(fma(7.295638, t118, -7.236236), t118, fma(fma(fma(-11.4868555, t119, 0.0), t119, 0.0), t119, 3.1255686));
        const float t125 = fma(fma(fma(13.728438, t119, -7.981878), t119, 2.025724), t119, -0.7334958);
        const float t126 = t118 * fma(t124, t118, t125);
        const float t127 = fma(fma(-23.220068, t119, 7.332055), t118, fma(fma(fma(9.986537, t119, 25.22195), t119, 0.0), t119, -2.9581387));
        const float t128 = fma(fma(fma(-19.722994, t119, 4.6594768), t119, -0.89538246), t119, 0.5143498);
        const float t129 = t118 * fma(t127, t118, t128);
        const float t130 = fma(fma(fma(1.946617, t118, -3.077631), t118, 1.4945927), t118, -0.24140751);
        const float t131 = t118 * t130;
        const float t132 = t118 * fma(fma(0.38173297, t118, -0.30305624), t118, 0.05897375);
        coefficients_0 = t111;
        coefficients_1 = t117 - t111 + t123;
        coefficients_2 = t126 - t123;
        coefficients_3 = t129 - t126;
        coefficients_4 = t131 - t129;
        coefficients_5 = t132 - t131;
        coefficients_6 = -t132;
    }
    const bool t133 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    spherecap_surface_light light;
    light.is_sampled = t133;
    light.solid_angle = t133 ? (t100 ? t98 * (t63 * t7) * 6.2831855 : 0.0) : 0.0;
    light.projected_solid_angle = t133 ? projected_above : 0.0;
    light.frame_0_x = frame_0_x;
    light.frame_0_y = frame_0_y;
    light.frame_0_z = frame_0_z;
    light.frame_1_x = fma(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1_y = fma(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1_z = fma(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
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
    light.rise = spherecap_max(t47 * (t26 * t26) * t71, -(radius_cos * t67));
    light.inv_above = inv_above;
    light.crescent_share = t104 ? t105 : 0.0;
    light.inv_rest = t104 ? 1.0 / (1.0 - t105) : 1.0;
    light.beyond = t104 ? t106 * t106 * t106 * shape_cut : 0.0;
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

spherecap_sample spherecap_surface_sample(spherecap_surface_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = abs(light.elevation_sin);
    const bool t2 = 0.0 < light.elevation_sin;
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    const bool t5 = t2 && light.crescent_share <= t3;
    const float t6 = 1.0 - t4;
    const float t7 = t4 - t6;
    const float t8 = 4.0 * t4 * t6;
    float t9 = 0.0;
    float t10 = 0.0;
    float t11 = 0.0;
    float t12 = 0.0;
    if (t5) {
        const float t13 = spherecap_max((t3 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        const float t14 = spherecap_min(t13, 0.99999994);
        const float t15 = 3.1415927 - light.beyond;
        const float t16 = fma(t14, t15, light.beyond);
        const float t17 = (1.0 - t14) * t15;
        t9 = spherecap_min(t16, t17) * 0.53033006;
        t10 = 1.0;
        t11 = 1.0;
        t12 = t16 - t17;
    } else {
        const float t18 = sqrt(t8);
        float t19 = 0.0;
        float t20 = 0.0;
        float t21 = 0.0;
        float t22 = 0.0;
        if (t2) {
            t19 = t18;
            t20 = 1.0;
            t21 = t3;
            t22 = light.crescent_share;
        } else {
            const float t23 = fma(fma(light.coefficients_6, t8, light.coefficients_4), t8, light.coefficients_2);
            const float t24 = fma(fma(light.coefficients_5, t8, light.coefficients_3), t8, light.coefficients_1);
            const float t25 = t18 * fma(t24, t18, fma(t23, t8, light.coefficients_0));
            const float t26 = sqrt(fma(t7, t7, t25 * t25));
            const float t27 = light.tau * t25;
            t19 = t27;
            t20 = fma(t7, t7, t27 * t27);
            t21 = light.width;
            t22 = fma(light.kappa, t25, t26) * fma(light.cut, t25, t26);
        }
        const float t28 = t21 / t22;
        const float t29 = t2 ? light.width : t28;
        const float t30 = t20 * t29;
        const float t31 = t30 * t30;
        const float t32 = fma(fma(fma(-0.00060778117, t31, -0.0027203285), t31, -0.10000902), t30, fma(fma(1.0676054e-5, t31, -0.011332183), t31, 1.0000001));
        t9 = t2 ? spherecap_min(spherecap_max(t28, 5.9604645e-8), 0.99999994) : t3;
        t10 = t29 * t32;
        t11 = t20;
        t12 = t19;
    }
    const float t33 = spherecap_float_of_bits(fma(spherecap_bits(t9), -0.33333334, 1419900500.0));
    const float t34 = fma(-(t9 * t33), t33 * t33, 1.0);
    const float t35 = t34 * t34;
    const float t36 = fma(fma(fma(0.110958695, t35, 0.14403293), t35, 0.22222222), t34, fma(fma(0.12482853, t35, 0.17283951), t35, 0.33333334));
    const float t37 = t10 * (t9 * fma(t33, t34 * t36, t33));
    const float t38 = t37 * t11;
    const float t39 = t38 * t38;
    const float t40 = fma(fma(fma(-0.063446075, t39, -0.056249518), t39, 0.0074712755), t39, 0.09996679);
    const float t41 = fma(fma(fma(0.022114987, t39, 0.085662976), t39, 0.030445365), t39, 0.03209764);
    const float t42 = t37 * fma(t40, t38, fma(t41, t39, 1.0000004));
    const float t43 = t5 ? spherecap_min(t42, 1.0) : t42;
    const float t44 = t11 * t43;
    const float t45 = 2.0 - t44;
    const float t46 = t43 * t45;
    const float t47 = sqrt(t46);
    float t48 = 0.0;
    float t49 = 0.0;
    float t50 = 0.0;
    if (t5) {
        const float t51 = light.radius_sin * light.elevation_cos;
        const float t52 = t12 < 0.0 ? t44 : t45;
        const float t53 = 1.0 - t52;
        const float t54 = t46 * t8;
        const float t55 = spherecap_max(fma(t51, t52, -light.rise), 0.0);
        const float t56 = sqrt(fma(t55, t55, light.radius_sin * light.radius_sin * t54));
        const float t57 = t1 * light.radius_cos;
        const float t58 = fma(light.elevation_cos * t53, fma(t51, t53, -2.0 * t57), light.radius_sin * t54);
        const float t59 = light.radius_sin * fma(light.elevation_cos, t58 / (t56 + t57), -(t1 * t1 * t53));
        t48 = t59;
        t49 = light.radius_sin * t47 * t7;
        t50 = t56;
    } else {
        const float t60 = t47 * t12;
        t48 = fma(light.elevation_cos, t60, -((t2 ? t1 : -t1) * (1.0 - t44)));
        t49 = t47 * t7;
        t50 = t60;
    }
    const float t61 = 0.0 < t50 ? light.inv_above : 0.0;
    const float t62 = fma(t48, t48, t49 * t49);
    const float t63 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t62), 0.0);
    const float t64 = sqrt(t63);
    const float t65 = sqrt(fma(light.radius_cos, light.radius_cos, t63));
    const float t66 = light.radius_cos * light.radius_cos / (t65 + t64);
    const float t67 = fma(light.frame_0_x, t65, fma(light.frame_1_x, t48, light.frame_2_x * t49));
    const float t68 = fma(light.frame_0_y, t65, fma(light.frame_1_y, t48, light.frame_2_y * t49));
    const float t69 = fma(light.frame_0_z, t65, fma(light.frame_1_z, t48, light.frame_2_z * t49));
    const float t70 = t66 * light.inv_radius_sin;
    const float t71 = -fma(t65, t64, t62) * light.inv_radius_sin;
    const float t72 = t70 * t48;
    const float t73 = t70 * t49;
    const float t74 = fma(light.frame_0_x, t71, fma(light.frame_1_x, t72, light.frame_2_x * t73));
    const float t75 = fma(light.frame_0_y, t71, fma(light.frame_1_y, t72, light.frame_2_y * t73));
    const float t76 = fma(light.frame_0_z, t71, fma(light.frame_1_z, t72, light.frame_2_z * t73));
    spherecap_sample sampled;
    sampled.direction = vec3(t67, t68, t69);
    sampled.distance = t66 * light.distance;
    sampled.normal = vec3(t74, t75, t76);
    sampled.cosine = t50;
    sampled.pdf = t61 * spherecap_min(abs(t50), 3.4028235e38);
    sampled.projected_pdf = t61;
    return sampled;
}

spherecap_sample spherecap_surface_sample_once(vec3 normal, vec3 centre, float radius, float u0, float u1) {
    const spherecap_surface_light light = spherecap_surface_prepare(normal, centre, radius);
    return spherecap_surface_sample(light, u0, u1);
}

float spherecap_surface_pdf_direction(spherecap_surface_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    const float t1 = fma(light.frame_0_x, direction.x, fma(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    const float t2 = fma(light.frame_1_x, direction.x, fma(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    const float t3 = fma(light.frame_2_x, direction.x, fma(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    const float t4 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    const bool t5 = t1 < 0.0;
    const float t6 = t5 ? 1.0 : t2;
    const float t7 = t5 ? 1.0 : t3;
    const float t8 = (0.0 < t4 ? light.inv_above : 0.0) * spherecap_min(abs(t4), 3.4028235e38);
    const float t9 = fma(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019 ? t8 : 0.0;
    const float t10 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t10 && t10 <= 1.002001) ? t9 : 0.0;
}

float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    const float t1 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    const float t2 = (0.0 < t1 ? light.inv_above : 0.0) * spherecap_min(abs(t1), 3.4028235e38);
    const float t3 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t3 && t3 <= 1.002001) ? t2 : 0.0;
}

float spherecap_surface_importance(vec3 normal, vec3 centre, float radius, float strength) {
    const float t1 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    const float t2 = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
    const float t3 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t2));
    const float t4 = centre.x * t3;
    const float t5 = centre.y * t3;
    const float t6 = centre.z * t3;
    const float t7 = radius * t3;
    const float t8 = sqrt(fma(t4, t4, fma(t5, t5, t6 * t6)));
    const float t9 = 1.0 / t8;
    const float t10 = t7 * t9;
    const float t11 = t10 * t10;
    const bool t12 = 0.0 < radius && t8 * t2 <= 3.4028235e38 && 0.0 < strength && strength <= 3.4028235e38;
    const float t13 = fma(normal.x, t4, fma(normal.y, t5, normal.z * t6));
    const float t14 = fma(t13, t9, 2.3841858e-7);
    const float t15 = fma(t13 + t7, t9, 2.3841858e-7);
    const float t16 = t15 * t15 / (fma(t10 - t14, spherecap_max(fma(-t11, t11, 0.9999981), 0.0), t15) * 2.0);
    const float t17 = t10 <= t14 ? t14 : 0.0 < t15 ? t16 : 0.0;
    const float t18 = fma(0.0, 0.5 - t17, t17);
    const float t19 = spherecap_min(spherecap_max(t11 * t18 * strength, 1.1754944e-38), 3.4028235e38);
    const float t20 = (t11 <= 1.0000019 && 4.9303807e-32 < t11 && t12 && 0.0 < t18) ? t19 : 0.0;
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

spherecap_front_light spherecap_front_prepare(vec3 normal, vec3 centre, float radius, float defensive) {
    const float t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    float normal_x = 0.0;
    float normal_y = 0.0;
    float normal_z = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        const float t2 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        const float t3 = spherecap_power_of_two(spherecap_min(t2, 8.5070587e37));
        const float t4 = normal.x / t3;
        const float t5 = normal.y / t3;
        const float t6 = normal.z / t3;
        const float t7 = spherecap_max(sqrt(fma(t4, t4, fma(t5, t5, t6 * t6))), 1.1754944e-38);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    const float t8 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    const float t9 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    const float t10 = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37));
    const float t11 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t10));
    const float t12 = centre.x * t11;
    const float t13 = centre.y * t11;
    const float t14 = centre.z * t11;
    const float t15 = radius * t11;
    precise float t16 = t12 * t12;
    precise float t17 = t13 * t13;
    precise float t18 = t14 * t14;
    precise float t19 = t16 + t17;
    precise float t20 = t19 - t16;
    precise float t21 = t19 - t20;
    precise float t22 = t16 - t21;
    precise float t23 = t17 - t20;
    precise float t24 = t19 + t18;
    precise float t25 = t24 - t19;
    precise float t26 = t24 - t25;
    precise float t27 = t19 - t26;
    precise float t28 = t18 - t25;
    const float t29 = spherecap_lost(t12, t12, t16) + spherecap_lost(t13, t13, t17) + spherecap_lost(t14, t14, t18);
    precise float t30 = t15 * t15;
    const float t31 = t24 - t30 + (t29 + (t22 + t23 + (t27 + t28)) - spherecap_lost(t15, t15, t30));
    const bool t32 = 0.0 < t31;
    const float t33 = sqrt(t24);
    const float t34 = 1.0 / t33;
    precise float t35 = normal_x * t12;
    precise float t36 = normal_y * t13;
    precise float t37 = normal_z * t14;
    precise float t38 = t35 + t36;
    precise float t39 = t38 - t35;
    precise float t40 = t38 - t39;
    precise float t41 = t35 - t40;
    precise float t42 = t36 - t39;
    precise float t43 = t38 + t37;
    precise float t44 = t43 - t38;
    precise float t45 = t43 - t44;
    precise float t46 = t38 - t45;
    precise float t47 = t37 - t44;
    const float t48 = spherecap_lost(normal_x, t12, t35) + spherecap_lost(normal_y, t13, t36) + spherecap_lost(normal_z, t14, t37);
    const float t49 = t48 + (t41 + t42 + (t46 + t47));
    precise float t50 = t43 + t49;
    precise float t51 = t50 - t43;
    precise float t52 = t49 - t51;
    const float t53 = t15 - t50 - t52;
    const float t54 = t15 + t50 + t52;
    const float t55 = t53 * t54;
    const bool t56 = 0.0 < t8;
    const bool t57 = 0.0 < t55 && t32 && t56;
    precise float t58 = normal_z * t13;
    const float t59 = spherecap_fused(normal_y, t14, -t58) - spherecap_lost(normal_z, t13, t58);
    precise float t60 = normal_x * t14;
    const float t61 = spherecap_fused(normal_z, t12, -t60) - spherecap_lost(normal_x, t14, t60);
    precise float t62 = normal_y * t12;
    const float t63 = spherecap_fused(normal_x, t13, -t62) - spherecap_lost(normal_y, t12, t62);
    const float t64 = fma(t59, t59, fma(t61, t61, t63 * t63));
    const bool t65 = 9.8607613e-32 < t64;
    const bool t66 = abs(t12) < abs(t14);
    const float t67 = t66 ? 0.0 : -t13;
    const float t68 = t66 ? -t14 : t12;
    const float t69 = t66 ? t13 : 0.0;
    const float t70 = sqrt(spherecap_max(t31, 0.0));
    const float radius_cos = t70 * t34;
    const float t71 = 1.0 + radius_cos;
    const float t72 = 1.0 / (t15 * t71);
    const float t73 = t72 * t71;
    const float radius_sin = t15 * t34;
    const float inv_radius_sin = t33 * t73;
    const float t74 = sqrt(t31 + t55);
    const float t75 = sqrt(t65 ? t64 : fma(t67, t67, fma(t68, t68, t69 * t69)));
    const float elevation_sin = t50 * t34;
    const float elevation_cos = (t57 ? t74 : t65 ? t75 : 0.0) * t34;
    const float t76 = abs(elevation_sin);
    const float t77 = radius_sin * elevation_cos;
    const float t78 = spherecap_max(fma(radius_cos, t76, t77), 9.8607613e-32);
    const float t79 = 1.0 / (t78 * t75);
    const float t80 = t79 * t75;
    const float t81 = t79 * t78;
    const float frame_2_x = (t65 ? t59 : t67) * t81;
    const float frame_2_y = (t65 ? t61 : t68) * t81;
    const float frame_2_z = (t65 ? t63 : t69) * t81;
    const float frame_0_x = t12 * t34;
    const float frame_0_y = t13 * t34;
    const float frame_0_z = t14 * t34;
    float t_x = 0.0;
    float t_y = 0.0;
    float kappa = 0.0;
    float cut = 0.0;
    float shape = 0.0;
    float shape_cut = 0.0;
    float norm = 0.0;
    float width = 0.0;
    float inv_cut_1 = 0.0;
    float tau = 0.0;
    float area = 0.0;
    if (t57) {
        const float t82 = sqrt(t55);
        const float t83 = t74 + t70;
        const float t84 = 1.0 / (t74 * t83);
        const float t85 = t84 * t83;
        const float t86 = t70 * t85;
        const float t87 = t82 * t85;
        const float t88 = abs(t50) * t73;
        const float t89 = t88 * t86;
        const float t90 = t86 - 0.5;
        const float t91 = t89 - 0.5;
        const float t92 = t90 * t90;
        const float t93 = t91 * t91;
        const float t94 = fma(0.05430631, t92, 0.080950715);
        const float t95 = fma(t94, t92, 0.1684019);
        const float t96 = fma(t95, t92, 0.32709444);
        const float t97 = fma(t96, t92, 0.5987523);
        const float t98 = fma(-0.026061837, t92, -0.06372378);
        const float t99 = fma(t98, t92, -0.11762552);
        const float t100 = fma(t99, t92, -0.23594604);
        const float t101 = fma(t100, t92, -0.44721135);
        const float t102 = fma(fma(fma(fma(-0.026061837, t93, t98), t93, t99), t93, t100), t93, t101);
        const float t103 = fma(t101, t92, -0.7754678);
        const float t104 = fma(t103, t90, fma(t97, t92, 0.94559944));
        const float t105 = fma(t91, t102, fma(fma(fma(fma(0.05430631, t93, t94), t93, t95), t93, t96), t93, t97));
        const float t106 = fma(t105, t90 + t91, t103);
        const float t107 = fma(t89, t106, t104);
        t_x = t86;
        t_y = t87;
        kappa = t88;
        cut = t89;
        shape = t104;
        shape_cut = fma(t89 - t86, t106, t104);
        norm = t107;
        width = t55 * t84;
        inv_cut_1 = t77 * t80;
        tau = t82 * t73;
        area = t87 * t87 * t87 * (spherecap_min(t53, t54) * t73) * t107;
    }
    const float t108 = radius_sin * radius_sin;
    const float t109 = elevation_sin < 0.0 ? area : t108 * t76 * 3.1415927 + area;
    const bool t110 = t32 && 9.8607613e-32 < t108;
    const float distance = t33 * t10;
    const float solid_angle = t110 ? t108 * (t72 * t15) * 6.2831855 : 0.0;
    const float projected_above = (9.403955e-38 < t109 && t110) ? t109 : 0.0;
    const float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    const bool t111 = 0.0 < inv_above;
    const bool t112 = 0.0 < elevation_sin;
    const float t113 = t112 ? inv_above : 0.0;
    const float t114 = t111 ? defensive : 0.0 < defensive || !t56 ? 1.0 : 0.0;
    const bool t115 = 0.0 < tau;
    const bool t116 = t112 && t115 && 0.0 < t113;
    const float t117 = t_y * t_y * t_y * shape * t113;
    const float t118 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    if (!t112 && t115) {
        const float t119 = 1.0 + kappa;
        const float t120 = t119 * shape;
        const float t121 = 1.0 / (norm * t120);
        const float t122 = sqrt(t121);
        const float t123 = norm * t122;
        const float t124 = (t_x + kappa) * inv_cut_1 - 0.5;
        const float t125 = t124 * t124;
        const float t126 = fma(fma(fma(-0.026061837, t125, -0.06372378), t125, -0.11762552), t125, -0.23594604);
        const float t127 = fma(fma(fma(0.05430631, t125, 0.080950715), t125, 0.1684019), t125, 0.32709444);
        const float t128 = fma(fma(fma(t126, t125, -0.44721135), t125, -0.7754678), t124, fma(fma(t127, t125, 0.5987523), t125, 0.94559944));
        const float t129 = t119 * t128 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t120 * t121);
        const float t130 = fma(t129, t120 * t122, -1.0);
        const float t131 = 1.0 - t129;
        const float t132 = fma(fma(30.011856, t130, fma(-41.541264, t131, -37.009792)), t130, fma(77.96775, t131, 7.470758));
        const float t133 = fma(fma(fma(fma(15.716111, t131, 0.0), t131, 9.961183), t131, -2.61785), t131, 0.8681748);
        const float t134 = fma(fma(t132, t130, fma(fma(-49.13454, t131, -9.466533), t131, -1.5877596)), t130, t133);
        const float t135 = t130 * t134;
        const float t136 = fma(fma(7.295638, t130, -7.236236), t130, fma(fma(fma(-11.4868555, t131, 0.0), t131, 0.0), t131, 3.1255686));
        const float t137 = fma(fma(fma(13.728438, t131, -7.981878), t131, 2.025724), t131, -0.7334958);
        const float t138 = t130 * fma(t136, t130, t137);
        const float t139 = fma(fma(-23.220068, t131, 7.332055), t130, fma(fma(fma(9.986537, t131, 25.22195), t131, 0.0), t131, -2.9581387));
        const float t140 = fma(fma(fma(-19.722994, t131, 4.6594768), t131, -0.89538246), t131, 0.5143498);
        const float t141 = t130 * fma(t139, t130, t140);
        const float t142 = fma(fma(fma(1.946617, t130, -3.077631), t130, 1.4945927), t130, -0.24140751);
        const float t143 = t130 * t142;
        const float t144 = t130 * fma(fma(0.38173297, t130, -0.30305624), t130, 0.05897375);
        coefficients_0 = t123;
        coefficients_1 = t129 - t123 + t135;
        coefficients_2 = t138 - t135;
        coefficients_3 = t141 - t138;
        coefficients_4 = t143 - t141;
        coefficients_5 = t144 - t143;
        coefficients_6 = -t144;
    }
    const bool t145 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    const bool t146 = t145 && (t111 || (0.0 < t114 && 0.0 < solid_angle));
    spherecap_front_light light;
    light.is_sampled = t146;
    light.solid_angle = t146 ? solid_angle : 0.0;
    light.projected_solid_angle = t146 ? projected_above : 0.0;
    light.frame_0_x = frame_0_x;
    light.frame_0_y = frame_0_y;
    light.frame_0_z = frame_0_z;
    light.frame_1_x = fma(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1_y = fma(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1_z = fma(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
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
    light.inv_solid_angle = t110 ? t71 * (inv_radius_sin * inv_radius_sin) * 0.15915494 : 0.0;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t55 * (t34 * t34) * t80, -(radius_cos * t76));
    light.defensive = t114;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.crescent_share = t116 ? t117 : 0.0;
    light.inv_rest = t116 ? 1.0 / (1.0 - t117) : 1.0;
    light.beyond = t116 ? t118 * t118 * t118 * shape_cut : 0.0;
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

spherecap_sample spherecap_front_sample(spherecap_front_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = abs(light.elevation_sin);
    const bool t2 = 0.0 < light.elevation_sin;
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    const bool t5 = t3 < light.defensive;
    const float t6 = 1.0 - light.defensive;
    const float t7 = spherecap_max((t5 ? t3 : t3 - light.defensive) / (t5 ? light.defensive : t6), 5.9604645e-8);
    const float t8 = 0.0 < light.requested ? spherecap_min(t7, 0.99999994) : t3;
    const bool t9 = t5 || (t2 && light.crescent_share <= t8);
    const float t10 = 1.0 - t4;
    const float t11 = t4 - t10;
    const float t12 = 4.0 * t4 * t10;
    float t13 = 0.0;
    float t14 = 0.0;
    float t15 = 0.0;
    float t16 = 0.0;
    if (t9) {
        const float t17 = spherecap_max((t8 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        const float t18 = t5 ? t8 : spherecap_min(t17, 0.99999994);
        const float t19 = t5 ? 0.0 : light.beyond;
        const float t20 = 3.1415927 - t19;
        const float t21 = fma(t18, t20, t19);
        const float t22 = (1.0 - t18) * t20;
        t13 = spherecap_min(t21, t22) * 0.53033006;
        t14 = 1.0;
        t15 = 1.0;
        t16 = t21 - t22;
    } else {
        const float t23 = sqrt(t12);
        float t24 = 0.0;
        float t25 = 0.0;
        float t26 = 0.0;
        float t27 = 0.0;
        if (t2) {
            t24 = t23;
            t25 = 1.0;
            t26 = t8;
            t27 = light.crescent_share;
        } else {
            const float t28 = fma(fma(light.coefficients_6, t12, light.coefficients_4), t12, light.coefficients_2);
            const float t29 = fma(fma(light.coefficients_5, t12, light.coefficients_3), t12, light.coefficients_1);
            const float t30 = t23 * fma(t29, t23, fma(t28, t12, light.coefficients_0));
            const float t31 = sqrt(fma(t11, t11, t30 * t30));
            const float t32 = light.tau * t30;
            t24 = t32;
            t25 = fma(t11, t11, t32 * t32);
            t26 = light.width;
            t27 = fma(light.kappa, t30, t31) * fma(light.cut, t30, t31);
        }
        const float t33 = t26 / t27;
        const float t34 = t2 ? light.width : t33;
        const float t35 = t25 * t34;
        const float t36 = t35 * t35;
        const float t37 = fma(fma(fma(-0.00060778117, t36, -0.0027203285), t36, -0.10000902), t35, fma(fma(1.0676054e-5, t36, -0.011332183), t36, 1.0000001));
        t13 = t2 ? spherecap_min(spherecap_max(t33, 5.9604645e-8), 0.99999994) : t8;
        t14 = t34 * t37;
        t15 = t25;
        t16 = t24;
    }
    const float t38 = spherecap_float_of_bits(fma(spherecap_bits(t13), -0.33333334, 1419900500.0));
    const float t39 = fma(-(t13 * t38), t38 * t38, 1.0);
    const float t40 = t39 * t39;
    const float t41 = fma(fma(fma(0.110958695, t40, 0.14403293), t40, 0.22222222), t39, fma(fma(0.12482853, t40, 0.17283951), t40, 0.33333334));
    const float t42 = t14 * (t13 * fma(t38, t39 * t41, t38));
    const float t43 = t42 * t15;
    const float t44 = t43 * t43;
    const float t45 = fma(fma(fma(-0.063446075, t44, -0.056249518), t44, 0.0074712755), t44, 0.09996679);
    const float t46 = fma(fma(fma(0.022114987, t44, 0.085662976), t44, 0.030445365), t44, 0.03209764);
    const float t47 = t42 * fma(t45, t43, fma(t46, t44, 1.0000004));
    const float t48 = t9 ? spherecap_min(t47, 1.0) : t47;
    const float t49 = t15 * t48;
    const float t50 = 2.0 - t49;
    const float t51 = t48 * t50;
    const float t52 = sqrt(t51);
    float t53 = 0.0;
    float t54 = 0.0;
    float t55 = 0.0;
    if (t9) {
        const float t56 = t16 < 0.0 ? t49 : t50;
        float t57 = 0.0;
        float t58 = 0.0;
        float t59 = 0.0;
        if (t5) {
            const float t60 = light.solid_angle * 0.15915494;
            const float t61 = t60 * (1.0 - t51 * t12);
            const float t62 = sqrt(t60 * (2.0 - t61));
            const float t63 = (t56 - 1.0) * t62;
            t57 = t63;
            t58 = t52 * t11 * t62;
            t59 = fma(light.elevation_sin, 1.0 - t61, light.elevation_cos * t63);
        } else {
            const float t64 = light.radius_sin * light.elevation_cos;
            const float t65 = 1.0 - t56;
            const float t66 = t51 * t12;
            const float t67 = spherecap_max(fma(t64, t56, -light.rise), 0.0);
            const float t68 = sqrt(fma(t67, t67, light.radius_sin * light.radius_sin * t66));
            const float t69 = t1 * light.radius_cos;
            const float t70 = fma(light.elevation_cos * t65, fma(t64, t65, -2.0 * t69), light.radius_sin * t66);
            const float t71 = light.radius_sin * fma(light.elevation_cos, t70 / (t68 + t69), -(t1 * t1 * t65));
            t57 = t71;
            t58 = light.radius_sin * t52 * t11;
            t59 = t68;
        }
        t53 = t57;
        t54 = t58;
        t55 = t59;
    } else {
        const float t72 = t52 * t16;
        t53 = fma(light.elevation_cos, t72, -((t2 ? t1 : -t1) * (1.0 - t49)));
        t54 = t52 * t11;
        t55 = t72;
    }
    const float t73 = spherecap_min(abs(t55), 3.4028235e38);
    const float t74 = 0.0 < t55 ? light.inv_above : 0.0;
    float t75 = 0.0;
    float t76 = 0.0;
    if (0.0 < light.defensive) {
        const float t77 = light.defensive * light.inv_solid_angle;
        const float t78 = fma(t74, t6, spherecap_min(t77 / spherecap_max(t73, 1.1754944e-38), 3.4028235e38));
        t75 = fma(t74, t6 * t73, t77);
        t76 = spherecap_min(t78, 3.4028235e38);
    } else {
        t75 = t74 * t73;
        t76 = t74;
    }
    const float t79 = fma(t53, t53, t54 * t54);
    const float t80 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t79), 0.0);
    const float t81 = sqrt(t80);
    const float t82 = sqrt(fma(light.radius_cos, light.radius_cos, t80));
    const float t83 = light.radius_cos * light.radius_cos / (t82 + t81);
    const float t84 = fma(light.frame_0_x, t82, fma(light.frame_1_x, t53, light.frame_2_x * t54));
    const float t85 = fma(light.frame_0_y, t82, fma(light.frame_1_y, t53, light.frame_2_y * t54));
    const float t86 = fma(light.frame_0_z, t82, fma(light.frame_1_z, t53, light.frame_2_z * t54));
    const float t87 = t83 * light.inv_radius_sin;
    const float t88 = -fma(t82, t81, t79) * light.inv_radius_sin;
    const float t89 = t87 * t53;
    const float t90 = t87 * t54;
    const float t91 = fma(light.frame_0_x, t88, fma(light.frame_1_x, t89, light.frame_2_x * t90));
    const float t92 = fma(light.frame_0_y, t88, fma(light.frame_1_y, t89, light.frame_2_y * t90));
    const float t93 = fma(light.frame_0_z, t88, fma(light.frame_1_z, t89, light.frame_2_z * t90));
    spherecap_sample sampled;
    sampled.direction = vec3(t84, t85, t86);
    sampled.distance = t83 * light.distance;
    sampled.normal = vec3(t91, t92, t93);
    sampled.cosine = t55;
    sampled.pdf = t75;
    sampled.projected_pdf = t76;
    return sampled;
}

spherecap_sample spherecap_front_sample_once(vec3 normal, vec3 centre, float radius, float defensive, float u0, float u1) {
    const spherecap_front_light light = spherecap_front_prepare(normal, centre, radius, defensive);
    return spherecap_front_sample(light, u0, u1);
}

float spherecap_front_pdf_direction(spherecap_front_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    const float t1 = fma(light.frame_0_x, direction.x, fma(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    const float t2 = fma(light.frame_1_x, direction.x, fma(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    const float t3 = fma(light.frame_2_x, direction.x, fma(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    const float t4 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    const bool t5 = t1 < 0.0;
    const float t6 = t5 ? 1.0 : t2;
    const float t7 = t5 ? 1.0 : t3;
    const float t8 = spherecap_min(abs(t4), 3.4028235e38);
    const float t9 = 0.0 < t4 ? light.inv_above : 0.0;
    const float t10 = fma(t9, (1.0 - light.defensive) * t8, light.defensive * light.inv_solid_angle);
    const float t11 = fma(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.defensive ? t10 : t9 * t8) : 0.0;
    const float t12 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t12 && t12 <= 1.002001) ? t11 : 0.0;
}

float spherecap_front_pdf_on_sphere(spherecap_front_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    const float t1 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    const float t2 = spherecap_min(abs(t1), 3.4028235e38);
    const float t3 = 0.0 < t1 ? light.inv_above : 0.0;
    const float t4 = fma(t3, (1.0 - light.defensive) * t2, light.defensive * light.inv_solid_angle);
    const float t5 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    const float t6 = (0.998001 <= t5 && t5 <= 1.002001) ? (0.0 < light.defensive ? t4 : t3 * t2) : 0.0;
    return t6;
}

float spherecap_front_importance(vec3 normal, vec3 centre, float radius, float defensive, float strength) {
    const float t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    float t2 = 0.0;
    float t3 = 0.0;
    float t4 = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        t2 = normal.x;
        t3 = normal.y;
        t4 = normal.z;
    } else {
        const float t5 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        const float t6 = spherecap_power_of_two(spherecap_min(t5, 8.5070587e37));
        const float t7 = normal.x / t6;
        const float t8 = normal.y / t6;
        const float t9 = normal.z / t6;
        const float t10 = spherecap_max(sqrt(fma(t7, t7, fma(t8, t8, t9 * t9))), 1.1754944e-38);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    const float t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    const float t12 = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    const float t13 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t12));
    const float t14 = centre.x * t13;
    const float t15 = centre.y * t13;
    const float t16 = centre.z * t13;
    const float t17 = radius * t13;
    const float t18 = sqrt(fma(t14, t14, fma(t15, t15, t16 * t16)));
    const float t19 = 1.0 / t18;
    const float t20 = t17 * t19;
    const float t21 = t20 * t20;
    const float t22 = fma(t2, t2, fma(t3, t3, t4 * t4));
    const bool t23 = 0.0 <= defensive && defensive <= 1.0 && t22 <= 2.0 && 0.0 < radius && t18 * t12 <= 3.4028235e38;
    const float t24 = fma(t2, t14, fma(t3, t15, t4 * t16));
    const float t25 = fma(t24, t19, 2.3841858e-7);
    const float t26 = fma(t24 + t17, t19, 2.3841858e-7);
    const float t27 = t26 * t26 / (fma(t20 - t25, spherecap_max(fma(-t21, t21, 0.9999981), 0.0), t26) * 2.0);
    const float t28 = t20 <= t25 ? t25 : 0.0 < t26 ? t27 : 0.0;
    const float t29 = t22 <= 0.0 ? 1.0 : fma(defensive, 0.5 - t28, t28);
    const bool t30 = t21 <= 1.0000019 && 4.9303807e-32 < t21 && t23 && 0.0 < strength && strength <= 3.4028235e38;
    const float t31 = spherecap_min(spherecap_max(t21 * t29 * strength, 1.1754944e-38), 3.4028235e38);
    return (t30 && (0.0 < t29 || 0.0 < defensive)) ? t31 : 0.0;
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

spherecap_both_light spherecap_both_prepare(vec3 normal, vec3 centre, float radius, float defensive) {
    const float t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    float normal_x = 0.0;
    float normal_y = 0.0;
    float normal_z = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        const float t2 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        const float t3 = spherecap_power_of_two(spherecap_min(t2, 8.5070587e37));
        const float t4 = normal.x / t3;
        const float t5 = normal.y / t3;
        const float t6 = normal.z / t3;
        const float t7 = spherecap_max(sqrt(fma(t4, t4, fma(t5, t5, t6 * t6))), 1.1754944e-38);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    const float t8 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    const float t9 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    const float t10 = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37));
    const float t11 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t10));
    const float t12 = centre.x * t11;
    const float t13 = centre.y * t11;
    const float t14 = centre.z * t11;
    const float t15 = radius * t11;
    precise float t16 = t12 * t12;
    precise float t17 = t13 * t13;
    precise float t18 = t14 * t14;
    precise float t19 = t16 + t17;
    precise float t20 = t19 - t16;
    precise float t21 = t19 - t20;
    precise float t22 = t16 - t21;
    precise float t23 = t17 - t20;
    precise float t24 = t19 + t18;
    precise float t25 = t24 - t19;
    precise float t26 = t24 - t25;
    precise float t27 = t19 - t26;
    precise float t28 = t18 - t25;
    const float t29 = spherecap_lost(t12, t12, t16) + spherecap_lost(t13, t13, t17) + spherecap_lost(t14, t14, t18);
    precise float t30 = t15 * t15;
    const float t31 = t24 - t30 + (t29 + (t22 + t23 + (t27 + t28)) - spherecap_lost(t15, t15, t30));
    const bool t32 = 0.0 < t31;
    const float t33 = sqrt(t24);
    const float t34 = 1.0 / t33;
    precise float t35 = normal_x * t12;
    precise float t36 = normal_y * t13;
    precise float t37 = normal_z * t14;
    precise float t38 = t35 + t36;
    precise float t39 = t38 - t35;
    precise float t40 = t38 - t39;
    precise float t41 = t35 - t40;
    precise float t42 = t36 - t39;
    precise float t43 = t38 + t37;
    precise float t44 = t43 - t38;
    precise float t45 = t43 - t44;
    precise float t46 = t38 - t45;
    precise float t47 = t37 - t44;
    const float t48 = spherecap_lost(normal_x, t12, t35) + spherecap_lost(normal_y, t13, t36) + spherecap_lost(normal_z, t14, t37);
    const float t49 = t48 + (t41 + t42 + (t46 + t47));
    precise float t50 = t43 + t49;
    precise float t51 = t50 - t43;
    precise float t52 = t49 - t51;
    const float t53 = t15 - t50 - t52;
    const float t54 = t15 + t50 + t52;
    const float t55 = t53 * t54;
    const bool t56 = 0.0 < t8;
    const bool t57 = 0.0 < t55 && t32 && t56;
    precise float t58 = normal_z * t13;
    const float t59 = spherecap_fused(normal_y, t14, -t58) - spherecap_lost(normal_z, t13, t58);
    precise float t60 = normal_x * t14;
    const float t61 = spherecap_fused(normal_z, t12, -t60) - spherecap_lost(normal_x, t14, t60);
    precise float t62 = normal_y * t12;
    const float t63 = spherecap_fused(normal_x, t13, -t62) - spherecap_lost(normal_y, t12, t62);
    const float t64 = fma(t59, t59, fma(t61, t61, t63 * t63));
    const bool t65 = 9.8607613e-32 < t64;
    const bool t66 = abs(t12) < abs(t14);
    const float t67 = t66 ? 0.0 : -t13;
    const float t68 = t66 ? -t14 : t12;
    const float t69 = t66 ? t13 : 0.0;
    const float t70 = sqrt(spherecap_max(t31, 0.0));
    const float radius_cos = t70 * t34;
    const float t71 = 1.0 + radius_cos;
    const float t72 = 1.0 / (t15 * t71);
    const float t73 = t72 * t71;
    const float radius_sin = t15 * t34;
    const float inv_radius_sin = t33 * t73;
    const float t74 = sqrt(t31 + t55);
    const float t75 = sqrt(t65 ? t64 : fma(t67, t67, fma(t68, t68, t69 * t69)));
    const float elevation_sin = t50 * t34;
    const float elevation_cos = (t57 ? t74 : t65 ? t75 : 0.0) * t34;
    const float t76 = abs(elevation_sin);
    const float t77 = radius_sin * elevation_cos;
    const float t78 = spherecap_max(fma(radius_cos, t76, t77), 9.8607613e-32);
    const float t79 = 1.0 / (t78 * t75);
    const float t80 = t79 * t75;
    const float t81 = t79 * t78;
    const float frame_2_x = (t65 ? t59 : t67) * t81;
    const float frame_2_y = (t65 ? t61 : t68) * t81;
    const float frame_2_z = (t65 ? t63 : t69) * t81;
    const float frame_0_x = t12 * t34;
    const float frame_0_y = t13 * t34;
    const float frame_0_z = t14 * t34;
    float t_x = 0.0;
    float t_y = 0.0;
    float kappa = 0.0;
    float cut = 0.0;
    float shape = 0.0;
    float shape_cut = 0.0;
    float norm = 0.0;
    float width = 0.0;
    float inv_cut_1 = 0.0;
    float tau = 0.0;
    float area = 0.0;
    if (t57) {
        const float t82 = sqrt(t55);
        const float t83 = t74 + t70;
        const float t84 = 1.0 / (t74 * t83);
        const float t85 = t84 * t83;
        const float t86 = t70 * t85;
        const float t87 = t82 * t85;
        const float t88 = abs(t50) * t73;
        const float t89 = t88 * t86;
        const float t90 = t86 - 0.5;
        const float t91 = t89 - 0.5;
        const float t92 = t90 * t90;
        const float t93 = t91 * t91;
        const float t94 = fma(0.05430631, t92, 0.080950715);
        const float t95 = fma(t94, t92, 0.1684019);
        const float t96 = fma(t95, t92, 0.32709444);
        const float t97 = fma(t96, t92, 0.5987523);
        const float t98 = fma(-0.026061837, t92, -0.06372378);
        const float t99 = fma(t98, t92, -0.11762552);
        const float t100 = fma(t99, t92, -0.23594604);
        const float t101 = fma(t100, t92, -0.44721135);
        const float t102 = fma(fma(fma(fma(-0.026061837, t93, t98), t93, t99), t93, t100), t93, t101);
        const float t103 = fma(t101, t92, -0.7754678);
        const float t104 = fma(t103, t90, fma(t97, t92, 0.94559944));
        const float t105 = fma(t91, t102, fma(fma(fma(fma(0.05430631, t93, t94), t93, t95), t93, t96), t93, t97));
        const float t106 = fma(t105, t90 + t91, t103);
        const float t107 = fma(t89, t106, t104);
        t_x = t86;
        t_y = t87;
        kappa = t88;
        cut = t89;
        shape = t104;
        shape_cut = fma(t89 - t86, t106, t104);
        norm = t107;
        width = t55 * t84;
        inv_cut_1 = t77 * t80;
        tau = t82 * t73;
        area = t87 * t87 * t87 * (spherecap_min(t53, t54) * t73) * t107;
    }
    const float t108 = radius_sin * radius_sin;
    const float t109 = t108 * t76 * 3.1415927 + area;
    const bool t110 = elevation_sin < 0.0;
    const float t111 = t110 ? area : t109;
    const float t112 = t110 ? t109 : area;
    const bool t113 = t32 && 9.8607613e-32 < t108;
    const float distance = t33 * t10;
    const float solid_angle = t113 ? t108 * (t72 * t15) * 6.2831855 : 0.0;
    const float projected_above = (9.403955e-38 < t111 && t113) ? t111 : 0.0;
    const float projected_below = (9.403955e-38 < t112 && t113) ? t112 : 0.0;
    const float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    const float inv_below = 0.0 < projected_below ? 1.0 / projected_below : 0.0;
    const bool t114 = 0.0 < inv_above + inv_below;
    const bool t115 = 0.0 < elevation_sin;
    const float t116 = t115 ? inv_above : inv_below;
    const float t117 = t114 ? defensive : 0.0 < defensive || !t56 ? 1.0 : 0.0;
    const bool t118 = 0.0 < tau;
    const bool t119 = t118 && 0.0 < t116;
    const float t120 = t_y * t_y * t_y * shape * t116;
    const float t121 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    float t122 = 0.0;
    if (t118) {
        const float t123 = 1.0 + kappa;
        const float t124 = t123 * shape;
        const float t125 = 1.0 / (norm * t124);
        const float t126 = sqrt(t125);
        const float t127 = norm * t126;
        const float t128 = (t_x + kappa) * inv_cut_1 - 0.5;
        const float t129 = t128 * t128;
        const float t130 = fma(fma(fma(-0.026061837, t129, -0.06372378), t129, -0.11762552), t129, -0.23594604);
        const float t131 = fma(fma(fma(0.05430631, t129, 0.080950715), t129, 0.1684019), t129, 0.32709444);
        const float t132 = fma(fma(fma(t130, t129, -0.44721135), t129, -0.7754678), t128, fma(fma(t131, t129, 0.5987523), t129, 0.94559944));
        const float t133 = t123 * t132 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t124 * t125);
        const float t134 = fma(t133, t124 * t126, -1.0);
        const float t135 = 1.0 - t133;
        const float t136 = fma(fma(30.011856, t134, fma(-41.541264, t135, -37.009792)), t134, fma(77.96775, t135, 7.470758));
        const float t137 = fma(fma(fma(fma(15.716111, t135, 0.0), t135, 9.961183), t135, -2.61785), t135, 0.8681748);
        const float t138 = fma(fma(t136, t134, fma(fma(-49.13454, t135, -9.466533), t135, -1.5877596)), t134, t137);
        const float t139 = t134 * t138;
        const float t140 = fma(fma(7.295638, t134, -7.236236), t134, fma(fma(fma(-11.4868555, t135, 0.0), t135, 0.0), t135, 3.1255686));
        const float t141 = fma(fma(fma(13.728438, t135, -7.981878), t135, 2.025724), t135, -0.7334958);
        const float t142 = t134 * fma(t140, t134, t141);
        const float t143 = fma(fma(-23.220068, t135, 7.332055), t134, fma(fma(fma(9.986537, t135, 25.22195), t135, 0.0), t135, -2.9581387));
        const float t144 = fma(fma(fma(-19.722994, t135, 4.6594768), t135, -0.89538246), t135, 0.5143498);
        const float t145 = t134 * fma(t143, t134, t144);
        const float t146 = fma(fma(fma(1.946617, t134, -3.077631), t134, 1.4945927), t134, -0.24140751);
        const float t147 = t134 * t146;
        const float t148 = t134 * fma(fma(0.38173297, t134, -0.30305624), t134, 0.05897375);
        const float t149 = 1.0 / (elevation_cos * elevation_cos);
        const float t150 = tau * tau;
        const float t151 = t150 * t149 / (1.0 + t_x);
        const float t152 = kappa - 0.5;
        const float t153 = cut - 0.5;
        const float t154 = t152 * t152;
        const float t155 = t153 * t153;
        const float t156 = fma(0.05430631, t154, 0.080950715);
        const float t157 = fma(t156, t154, 0.1684019);
        const float t158 = fma(t157, t154, 0.32709444);
        const float t159 = fma(fma(fma(fma(0.05430631, t155, t156), t155, t157), t155, t158), t155, fma(t158, t154, 0.5987523));
        const float t160 = fma(-0.026061837, t154, -0.06372378);
        const float t161 = fma(t160, t154, -0.11762552);
        const float t162 = fma(t161, t154, -0.23594604);
        const float t163 = fma(t162, t154, -0.44721135);
        const float t164 = fma(fma(fma(fma(-0.026061837, t155, t160), t155, t161), t155, t162), t155, t163);
        const float t165 = fma(kappa * t151, fma(fma(t153, t164, t159), t152 + t153, fma(t163, t154, -0.7754678)), fma(shape_cut, t151 - kappa * kappa, kappa) * t149);
        const float t166 = spherecap_min(spherecap_max(t150 * tau * (radius_cos + 1.0) * t165 * 0.31830987, 0.0), 0.5);
        coefficients_0 = t127;
        coefficients_1 = t133 - t127 + t139;
        coefficients_2 = t142 - t139;
        coefficients_3 = t145 - t142;
        coefficients_4 = t147 - t145;
        coefficients_5 = t148 - t147;
        coefficients_6 = -t148;
        t122 = t166;
    }
    const float share_above = 0.0 < inv_below ? (0.0 < inv_above ? (t115 ? 1.0 - t122 : t122) : 0.0) : 1.0;
    const bool t167 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    const bool t168 = t167 && (t114 || (0.0 < t117 && 0.0 < solid_angle));
    spherecap_both_light light;
    light.is_sampled = t168;
    light.solid_angle = t168 ? solid_angle : 0.0;
    light.projected_solid_angle = t168 ? projected_above : 0.0;
    light.frame_0_x = frame_0_x;
    light.frame_0_y = frame_0_y;
    light.frame_0_z = frame_0_z;
    light.frame_1_x = fma(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y));
    light.frame_1_y = fma(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z));
    light.frame_1_z = fma(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x));
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
    light.inv_solid_angle = t113 ? t71 * (inv_radius_sin * inv_radius_sin) * 0.15915494 : 0.0;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t55 * (t34 * t34) * t80, -(radius_cos * t76));
    light.defensive = t117;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
    light.crescent_share = t119 ? t120 : 0.0;
    light.inv_rest = t119 ? 1.0 / (1.0 - t120) : 1.0;
    light.beyond = t119 ? t121 * t121 * t121 * shape_cut : 0.0;
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

spherecap_sample spherecap_both_sample(spherecap_both_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    const float t1 = abs(light.elevation_sin);
    const bool t2 = 0.0 < light.elevation_sin;
    const float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    const float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    const bool t5 = t3 < light.defensive;
    const float t6 = 1.0 - light.defensive;
    const float t7 = spherecap_max((t5 ? t3 : t3 - light.defensive) / (t5 ? light.defensive : t6), 5.9604645e-8);
    const float t8 = 0.0 < light.requested ? spherecap_min(t7, 0.99999994) : t3;
    const bool t9 = t5 || t8 < light.share_above;
    const float t10 = 1.0 - light.share_above;
    const float t11 = spherecap_max((t9 ? t8 : t8 - light.share_above) / (t9 ? light.share_above : t10), 5.9604645e-8);
    const bool t12 = (t9 && t2) || (!t9 && !t2);
    const float t13 = t5 ? t8 : spherecap_min(t11, 0.99999994);
    const bool t14 = t5 || (t12 && light.crescent_share <= t13);
    const float t15 = 1.0 - t4;
    const float t16 = t4 - t15;
    const float t17 = 4.0 * t4 * t15;
    float t18 = 0.0;
    float t19 = 0.0;
    float t20 = 0.0;
    float t21 = 0.0;
    if (t14) {
        const float t22 = spherecap_max((t13 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        const float t23 = t5 ? t13 : spherecap_min(t22, 0.99999994);
        const float t24 = t5 ? 0.0 : light.beyond;
        const float t25 = 3.1415927 - t24;
        const float t26 = fma(t23, t25, t24);
        const float t27 = (1.0 - t23) * t25;
        t18 = spherecap_min(t26, t27) * 0.53033006;
        t19 = 1.0;
        t20 = 1.0;
        t21 = t26 - t27;
    } else {
        const float t28 = sqrt(t17);
        float t29 = 0.0;
        float t30 = 0.0;
        float t31 = 0.0;
        float t32 = 0.0;
        if (t12) {
            t29 = t28;
            t30 = 1.0;
            t31 = t13;
            t32 = light.crescent_share;
        } else {
            const float t33 = fma(fma(light.coefficients_6, t17, light.coefficients_4), t17, light.coefficients_2);
            const float t34 = fma(fma(light.coefficients_5, t17, light.coefficients_3), t17, light.coefficients_1);
            const float t35 = t28 * fma(t34, t28, fma(t33, t17, light.coefficients_0));
            const float t36 = sqrt(fma(t16, t16, t35 * t35));
            const float t37 = light.tau * t35;
            t29 = t37;
            t30 = fma(t16, t16, t37 * t37);
            t31 = light.width;
            t32 = fma(light.kappa, t35, t36) * fma(light.cut, t35, t36);
        }
        const float t38 = t31 / t32;
        const float t39 = t12 ? light.width : t38;
        const float t40 = t30 * t39;
        const float t41 = t40 * t40;
        const float t42 = fma(fma(fma(-0.00060778117, t41, -0.0027203285), t41, -0.10000902), t40, fma(fma(1.0676054e-5, t41, -0.011332183), t41, 1.0000001));
        t18 = t12 ? spherecap_min(spherecap_max(t38, 5.9604645e-8), 0.99999994) : t13;
        t19 = t39 * t42;
        t20 = t30;
        t21 = t29;
    }
    const float t43 = spherecap_float_of_bits(fma(spherecap_bits(t18), -0.33333334, 1419900500.0));
    const float t44 = fma(-(t18 * t43), t43 * t43, 1.0);
    const float t45 = t44 * t44;
    const float t46 = fma(fma(fma(0.110958695, t45, 0.14403293), t45, 0.22222222), t44, fma(fma(0.12482853, t45, 0.17283951), t45, 0.33333334));
    const float t47 = t19 * (t18 * fma(t43, t44 * t46, t43));
    const float t48 = t47 * t20;
    const float t49 = t48 * t48;
    const float t50 = fma(fma(fma(-0.063446075, t49, -0.056249518), t49, 0.0074712755), t49, 0.09996679);
    const float t51 = fma(fma(fma(0.022114987, t49, 0.085662976), t49, 0.030445365), t49, 0.03209764);
    const float t52 = t47 * fma(t50, t48, fma(t51, t49, 1.0000004));
    const float t53 = t14 ? spherecap_min(t52, 1.0) : t52;
    const float t54 = t20 * t53;
    const float t55 = 2.0 - t54;
    const float t56 = t53 * t55;
    const float t57 = sqrt(t56);
    float t58 = 0.0;
    float t59 = 0.0;
    float t60 = 0.0;
    if (t14) {
        const float t61 = t21 < 0.0 ? t54 : t55;
        float t62 = 0.0;
        float t63 = 0.0;
        float t64 = 0.0;
        if (t5) {
            const float t65 = light.solid_angle * 0.15915494;
            const float t66 = t65 * (1.0 - t56 * t17);
            const float t67 = sqrt(t65 * (2.0 - t66));
            const float t68 = (t61 - 1.0) * t67;
            t62 = t68;
            t63 = t57 * t16 * t67;
            t64 = fma(light.elevation_sin, 1.0 - t66, light.elevation_cos * t68);
        } else {
            const float t69 = light.radius_sin * light.elevation_cos;
            const float t70 = 1.0 - t61;
            const float t71 = t56 * t17;
            const float t72 = spherecap_max(fma(t69, t61, -light.rise), 0.0);
            const float t73 = sqrt(fma(t72, t72, light.radius_sin * light.radius_sin * t71));
            const float t74 = t1 * light.radius_cos;
            const float t75 = fma(light.elevation_cos * t70, fma(t69, t70, -2.0 * t74), light.radius_sin * t71);
            const float t76 = light.radius_sin * fma(light.elevation_cos, t75 / (t73 + t74), -(t1 * t1 * t70));
            t62 = t76;
            t63 = light.radius_sin * t57 * t16;
            t64 = t73;
        }
        t58 = t62;
        t59 = t63;
        t60 = t64;
    } else {
        const float t77 = t57 * t21;
        t58 = fma(light.elevation_cos, t77, -((t12 ? t1 : -t1) * (1.0 - t54)));
        t59 = t57 * t16;
        t60 = t77;
    }
    const float t78 = t9 ? 1.0 : -1.0;
    const float t79 = t58 * t78;
    const float t80 = t60 * t78;
    const float t81 = spherecap_min(abs(t80), 3.4028235e38);
    const float t82 = 0.0 < t80 ? light.inv_above * light.share_above : t80 < 0.0 ? light.inv_below * t10 : 0.0;
    float t83 = 0.0;
    float t84 = 0.0;
    if (0.0 < light.defensive) {
        const float t85 = light.defensive * light.inv_solid_angle;
        const float t86 = fma(t82, t6, spherecap_min(t85 / spherecap_max(t81, 1.1754944e-38), 3.4028235e38));
        t83 = fma(t82, t6 * t81, t85);
        t84 = spherecap_min(t86, 3.4028235e38);
    } else {
        t83 = t82 * t81;
        t84 = t82;
    }
    const float t87 = fma(t79, t79, t59 * t59);
    const float t88 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t87), 0.0);
    const float t89 = sqrt(t88);
    const float t90 = sqrt(fma(light.radius_cos, light.radius_cos, t88));
    const float t91 = light.radius_cos * light.radius_cos / (t90 + t89);
    const float t92 = fma(light.frame_0_x, t90, fma(light.frame_1_x, t79, light.frame_2_x * t59));
    const float t93 = fma(light.frame_0_y, t90, fma(light.frame_1_y, t79, light.frame_2_y * t59));
    const float t94 = fma(light.frame_0_z, t90, fma(light.frame_1_z, t79, light.frame_2_z * t59));
    const float t95 = t91 * light.inv_radius_sin;
    const float t96 = -fma(t90, t89, t87) * light.inv_radius_sin;
    const float t97 = t95 * t79;
    const float t98 = t95 * t59;
    const float t99 = fma(light.frame_0_x, t96, fma(light.frame_1_x, t97, light.frame_2_x * t98));
    const float t100 = fma(light.frame_0_y, t96, fma(light.frame_1_y, t97, light.frame_2_y * t98));
    const float t101 = fma(light.frame_0_z, t96, fma(light.frame_1_z, t97, light.frame_2_z * t98));
    spherecap_sample sampled;
    sampled.direction = vec3(t92, t93, t94);
    sampled.distance = t91 * light.distance;
    sampled.normal = vec3(t99, t100, t101);
    sampled.cosine = t80;
    sampled.pdf = t83;
    sampled.projected_pdf = t84;
    return sampled;
}

spherecap_sample spherecap_both_sample_once(vec3 normal, vec3 centre, float radius, float defensive, float u0, float u1) {
    const spherecap_both_light light = spherecap_both_prepare(normal, centre, radius, defensive);
    return spherecap_both_sample(light, u0, u1);
}

float spherecap_both_pdf_direction(spherecap_both_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    const float t1 = fma(light.frame_0_x, direction.x, fma(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    const float t2 = fma(light.frame_1_x, direction.x, fma(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    const float t3 = fma(light.frame_2_x, direction.x, fma(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    const float t4 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    const bool t5 = t1 < 0.0;
    const float t6 = t5 ? 1.0 : t2;
    const float t7 = t5 ? 1.0 : t3;
    const float t8 = spherecap_min(abs(t4), 3.4028235e38);
    const float t9 = 0.0 < t4 ? light.inv_above * light.share_above : t4 < 0.0 ? light.inv_below * (1.0 - light.share_above) : 0.0;
    const float t10 = fma(t9, (1.0 - light.defensive) * t8, light.defensive * light.inv_solid_angle);
    const float t11 = fma(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.defensive ? t10 : t9 * t8) : 0.0;
    const float t12 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t12 && t12 <= 1.002001) ? t11 : 0.0;
}

float spherecap_both_pdf_on_sphere(spherecap_both_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    const float t1 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    const float t2 = spherecap_min(abs(t1), 3.4028235e38);
    const float t3 = 0.0 < t1 ? light.inv_above * light.share_above : t1 < 0.0 ? light.inv_below * (1.0 - light.share_above) : 0.0;
    const float t4 = fma(t3, (1.0 - light.defensive) * t2, light.defensive * light.inv_solid_angle);
    const float t5 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    const float t6 = (0.998001 <= t5 && t5 <= 1.002001) ? (0.0 < light.defensive ? t4 : t3 * t2) : 0.0;
    return t6;
}

float spherecap_both_importance(vec3 normal, vec3 centre, float radius, float defensive, float strength) {
    const float t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    float t2 = 0.0;
    float t3 = 0.0;
    float t4 = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        t2 = normal.x;
        t3 = normal.y;
        t4 = normal.z;
    } else {
        const float t5 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        const float t6 = spherecap_power_of_two(spherecap_min(t5, 8.5070587e37));
        const float t7 = normal.x / t6;
        const float t8 = normal.y / t6;
        const float t9 = normal.z / t6;
        const float t10 = spherecap_max(sqrt(fma(t7, t7, fma(t8, t8, t9 * t9))), 1.1754944e-38);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    const float t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    const float t12 = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    const float t13 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t12));
    const float t14 = centre.x * t13;
    const float t15 = centre.y * t13;
    const float t16 = centre.z * t13;
    const float t17 = radius * t13;
    const float t18 = sqrt(fma(t14, t14, fma(t15, t15, t16 * t16)));
    const float t19 = 1.0 / t18;
    const float t20 = t17 * t19;
    const float t21 = t20 * t20;
    const float t22 = fma(t2, t2, fma(t3, t3, t4 * t4));
    const bool t23 = 0.0 <= defensive && defensive <= 1.0 && t22 <= 2.0 && 0.0 < radius && t18 * t12 <= 3.4028235e38;
    const float t24 = fma(t2, t14, fma(t3, t15, t4 * t16));
    const float t25 = spherecap_max(fma(-t21, t21, 0.9999981), 0.0);
    const float t26 = fma(t24, t19, 2.3841858e-7);
    const float t27 = fma(t24 + t17, t19, 2.3841858e-7);
    const float t28 = t20 <= t26 ? t26 : 0.0 < t27 ? t27 * t27 / (fma(t20 - t26, t25, t27) * 2.0) : 0.0;
    const float t29 = fma(-t24, t19, 2.3841858e-7);
    const float t30 = fma(-t24 + t17, t19, 2.3841858e-7);
    const float t31 = t20 <= t29 ? t29 : 0.0 < t30 ? t30 * t30 / (fma(t20 - t29, t25, t30) * 2.0) : 0.0;
    const float t32 = t28 + t31;
    const float t33 = t22 <= 0.0 ? 1.0 : fma(defensive, 0.5 - t32, t32);
    const bool t34 = t21 <= 1.0000019 && 4.9303807e-32 < t21 && t23 && 0.0 < strength && strength <= 3.4028235e38;
    const float t35 = spherecap_min(spherecap_max(t21 * t33 * strength, 1.1754944e-38), 3.4028235e38);
    return (t34 && (0.0 < t33 || 0.0 < defensive)) ? t35 : 0.0;
}


#endif
