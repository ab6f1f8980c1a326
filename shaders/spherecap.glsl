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
    vec3 towards_centre;
    vec3 sideways;
    vec3 normal;
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
    vec3 third_axis;
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

spherecap_surface_light spherecap_surface_prepare(vec3 normal, vec3 centre, float radius) {
    bool t1 = fma(centre.x, centre.x, fma(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0;
    bool t2 = t1 && 9.536743e-7 < radius;
    float t3 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t3, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t4 = t2 ? centre.x : centre.x * scale;
    float t5 = t2 ? centre.y : centre.y * scale;
    float t6 = t2 ? centre.z : centre.z * scale;
    float t7 = t2 ? radius : radius * scale;
    precise float t8 = t6 * t6;
    float t9 = fma(t4, t4, fma(t5, t5, t8));
    float t10 = fma(-t7, t7, t9);
    float t11 = 0.0;
    float t12 = 0.0;
    if (t10 < t9 * 0.25) {
        precise float t13 = t4 * t4;
        precise float t14 = t5 * t5;
        precise float t15 = t13 + t14;
        precise float t16 = t15 - t13;
        precise float t17 = t15 + t8;
        precise float t18 = t17 - t15;
        float t19 = spherecap_lost(t4, t4, t13) + spherecap_lost(t5, t5, t14) + spherecap_lost(t6, t6, t8);
        precise float t20 = t19 + (t13 - (t15 - t16) + (t14 - t16) + (t15 - (t17 - t18) + (t8 - t18)));
        t11 = t17;
        t12 = spherecap_fused(-t7, t7, t17) + t20;
    } else {
        t11 = t9;
        t12 = t10;
    }
    precise float t21 = normal.z * t5;
    float t22 = spherecap_fused(normal.y, t6, -t21);
    precise float t23 = normal.x * t6;
    float t24 = spherecap_fused(normal.z, t4, -t23);
    precise float t25 = normal.y * t4;
    float t26 = spherecap_fused(normal.x, t5, -t25);
    float t27 = fma(t22, t22, fma(t24, t24, t26 * t26));
    float t28 = 0.0;
    float t29 = 0.0;
    float t30 = 0.0;
    float t31 = 0.0;
    float t32 = 0.0;
    if (t27 < t11 * 0.015625) {
        float t33 = t22 - spherecap_lost(normal.z, t5, t21);
        float t34 = t24 - spherecap_lost(normal.x, t6, t23);
        float t35 = t26 - spherecap_lost(normal.y, t4, t25);
        float t36 = fma(t33, t33, fma(t34, t34, t35 * t35));
        bool t37 = t36 < t11 * 5.169879e-26;
        bool t38 = abs(t4) < abs(t6);
        float t39 = t38 ? 0.0 : -t5;
        float t40 = t38 ? -t6 : t4;
        float t41 = t38 ? t5 : 0.0;
        float t42 = sqrt(t36);
        t28 = t37 ? t39 : t33;
        t29 = t37 ? t40 : t34;
        t30 = t37 ? t41 : t35;
        t31 = t37 ? sqrt(fma(t39, t39, fma(t40, t40, t41 * t41))) : t42;
        t32 = t37 ? 0.0 : t42;
    } else {
        float t43 = sqrt(t27);
        t28 = t22;
        t29 = t24;
        t30 = t26;
        t31 = t43;
        t32 = t43;
    }
    precise float t44 = normal.x * t4;
    precise float t45 = normal.y * t5;
    precise float t46 = normal.z * t6;
    precise float t47 = t44 + t45;
    precise float t48 = t47 - t44;
    precise float t49 = t47 + t46;
    precise float t50 = t49 - t47;
    float t51 = spherecap_lost(normal.x, t4, t44) + spherecap_lost(normal.y, t5, t45) + spherecap_lost(normal.z, t6, t46);
    precise float t52 = t51 + (t44 - (t47 - t48) + (t45 - t48) + (t47 - (t49 - t50) + (t46 - t50)));
    precise float t53 = t49 + t52;
    precise float t54 = t52 - (t53 - t49);
    float t55 = t7 - t53 - t54;
    float t56 = t7 + t53 + t54;
    float t57 = t55 * t56;
    float t58 = sqrt(t12);
    bool t59 = 0.0 < t12;
    float t_x = 0.0;
    float t_y = 0.0;
    float width = 0.0;
    float kappa = 0.0;
    float cut = 0.0;
    float shape = 0.0;
    float shape_difference = 0.0;
    float norm = 0.0;
    float tau = 0.0;
    float area = 0.0;
    float t60 = 0.0;
    if (0.0 < t57 && t59) {
        float t61 = sqrt(t12 + t57);
        float t62 = sqrt(t57);
        float t63 = 1.0 / (t61 * t7);
        float t64 = t63 * t7;
        float t65 = t63 * t61;
        float t66 = t58 * t64;
        float t67 = t62 * t64;
        float t68 = t67 * t67;
        float t69 = abs(t53) * t65;
        float t70 = t69 * t66;
        float t71 = t66 - 0.5;
        float t72 = t70 - 0.5;
        float t73 = t71 * t71;
        float t74 = t72 * t72;
        float t75 = fma(0.05430631, t73, 0.080950715);
        float t76 = fma(t75, t73, 0.1684019);
        float t77 = fma(t76, t73, 0.32709444);
        float t78 = fma(t77, t73, 0.5987523);
        float t79 = fma(-0.026061837, t73, -0.06372378);
        float t80 = fma(t79, t73, -0.11762552);
        float t81 = fma(t80, t73, -0.23594604);
        float t82 = fma(t81, t73, -0.44721135);
        float t83 = fma(t82, t73, -0.7754678);
        float t84 = fma(t83, t71, fma(t78, t73, 0.94559944));
        float t85 = fma(t72, fma(fma(fma(fma(-0.026061837, t74, t79), t74, t80), t74, t81), t74, t82), fma(fma(fma(fma(0.05430631, t74, t75), t74, t76), t74, t77), t74, t78));
        float t86 = fma(t85, t71 + t72, t83);
        float t87 = fma(t70, t86, t84);
        t_x = t66;
        t_y = t67;
        width = t68 / (1.0 + t66);
        kappa = t69;
        cut = t70;
        shape = t84;
        shape_difference = t86;
        norm = t87;
        tau = t62 * t65;
        area = t68 * t67 * (spherecap_min(t55, t56) * t65) * t87;
        t60 = t61;
    } else {
        t60 = t32;
    }
    float t88 = sqrt(t11);
    float t89 = 1.0 / t88;
    float radius_sin = t7 * t89;
    float radius_cos = t58 * t89;
    float elevation_sin = t53 * t89;
    float elevation_cos = t60 * t89;
    float t90 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = spherecap_max(t57 * (t89 * t89) / fma(radius_cos, t90, climb), -(radius_cos * t90));
    float t91 = radius_sin * radius_sin;
    bool t92 = 0.0 < elevation_sin;
    float t93 = t92 ? fma(t91 * t90, 3.1415927, area) : area;
    bool t94 = 9.8607613e-32 < t91;
    float t95 = 1.0 / t31;
    float sideways_x = t28 * t95;
    float sideways_y = t29 * t95;
    float sideways_z = t30 * t95;
    float distance = t88 * (t2 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t93 && t94 && t59) ? t93 : 0.0;
    bool t96 = 0.0 < tau;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    float t97 = t92 ? inv_above : 0.0;
    bool t98 = t96 && t92 && 0.0 < t97;
    float t99 = t_y * t_y * t_y * shape * t97;
    float t100 = t_y / radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    if (t96 && !t92) {
        float t101 = 1.0 + kappa;
        float t102 = t101 * shape;
        float t103 = 1.0 / (norm * t102);
        float t104 = sqrt(t103);
        float t105 = norm * t104;
        float t106 = 1.0 / (1.0 + cut);
        float t107 = (t_x + kappa) * t106 - 0.5;
        float t108 = t107 * t107;
        float t109 = fma(fma(fma(-0.026061837, t108, -0.06372378), t108, -0.11762552), t108, -0.23594604);
        float t110 = fma(fma(fma(0.05430631, t108, 0.080950715), t108, 0.1684019), t108, 0.32709444);
        float t111 = fma(fma(fma(t109, t108, -0.44721135), t108, -0.7754678), t107, fma(fma(t110, t108, 0.5987523), t108, 0.94559944));
        float t112 = t101 * t111 * (t106 * t106 * t106) * (t102 * t103);
        float t113 = fma(t112, t102 * t104, -1.0);
        float t114 = 1.0 - t112;
        float t115 = fma(fma(30.011856, t113, fma(-41.541264, t114, -37.009792)), t113, fma(77.96775, t114, 7.470758));
        float t116 = fma(fma(fma(fma(15.716111, t114, 0.0), t114, 9.961183), t114, -2.61785), t114, 0.8681748);
        float t117 = fma(fma(t115, t113, fma(fma(-49.13454, t114, -9.466533), t114, -1.5877596)), t113, t116);
        float t118 = t113 * t117;
        float t119 = fma(fma(7.295638, t113, -7.236236), t113, fma(fma(fma(-11.4868555, t114, 0.0), t114, 0.0), t114, 3.1255686));
        float t120 = fma(fma(fma(13.728438, t114, -7.981878), t114, 2.025724), t114, -0.7334958);
        float t121 = t113 * fma(t119, t113, t120);
        float t122 = fma(fma(-23.220068, t114, 7.332055), t113, fma(fma(fma(9.986537, t114, 25.22195), t114, 0.0), t114, -2.9581387));
        float t123 = fma(fma(fma(-19.722994, t114, 4.6594768), t114, -0.89538246), t114, 0.5143498);
        float t124 = t113 * fma(t122, t113, t123);
        float t125 = fma(fma(fma(1.946617, t113, -3.077631), t113, 1.4945927), t113, -0.24140751);
        float t126 = t113 * t125;
        float t127 = t113 * fma(fma(0.38173297, t113, -0.30305624), t113, 0.05897375);
        coefficients_0 = t105;
        coefficients_1 = t112 - t105 + t118;
        coefficients_2 = t121 - t118;
        coefficients_3 = t124 - t121;
        coefficients_4 = t126 - t124;
        coefficients_5 = t127 - t126;
        coefficients_6 = -t127;
    }
    bool t128 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    float t129 = t128 ? ((t94 && 0.0 < radius_cos) ? t91 / (1.0 + radius_cos) : 0.0) * 6.2831855 : 0.0;
    spherecap_surface_light light;
    light.is_sampled = t128;
    light.solid_angle = t129;
    light.projected_solid_angle = t128 ? projected_above : 0.0;
    light.towards_centre = vec3(t4 * t89, t5 * t89, t6 * t89);
    light.sideways = vec3(sideways_x, sideways_y, sideways_z);
    light.normal = vec3(normal.x, normal.y, normal.z);
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
    light.third_axis = vec3(fma(sideways_y, normal.z, -(sideways_z * normal.y)), fma(sideways_z, normal.x, -(sideways_x * normal.z)), fma(sideways_x, normal.y, -(sideways_y * normal.x)));
    light.crescent_share = t98 ? t99 : 0.0;
    light.inv_rest = t98 ? 1.0 / (1.0 - t99) : 1.0;
    light.beyond = t98 ? t100 * t100 * t100 * fma(cut - t_x, shape_difference, shape) : 0.0;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t90;
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

spherecap_sample spherecap_surface_sample(spherecap_surface_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    bool t2 = 0.0 < light.tau;
    bool t3 = t2 && !(0.0 < light.elevation_sin);
    float t4 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    float t5 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    bool t6 = !t2 || (!t3 && light.crescent_share <= t4);
    float t7 = 1.0 - t5;
    float t8 = t5 - t7;
    float t9 = 4.0 * t5 * t7;
    float t10 = spherecap_max((t4 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
    float t11 = t2 ? spherecap_min(t10, 0.99999994) : t4;
    float t12 = t2 ? light.beyond : 0.0;
    float t13 = 3.1415927 - t12;
    float t14 = fma(t11, t13, t12);
    float t15 = (1.0 - t11) * t13;
    float t16 = 0.0;
    float t17 = 0.0;
    float t18 = 0.0;
    float t19 = 0.0;
    if (t6) {
        t17 = spherecap_min(t14, t15) * 0.53033006;
        t18 = 1.0;
        t19 = 1.0;
    } else {
        float t20 = sqrt(t9);
        float t21 = fma(fma(light.coefficients_6, t9, light.coefficients_4), t9, light.coefficients_2);
        float t22 = fma(fma(light.coefficients_5, t9, light.coefficients_3), t9, light.coefficients_1);
        float t23 = t20 * fma(t22, t20, fma(t21, t9, light.coefficients_0));
        float t24 = sqrt(fma(t8, t8, t23 * t23));
        float t25 = light.tau * t23;
        float t26 = t3 ? fma(t8, t8, t25 * t25) : 1.0;
        float t27 = t3 ? fma(light.kappa, t23, t24) * fma(light.cut, t23, t24) : light.crescent_share;
        float t28 = (t3 ? light.width : t4) / t27;
        float t29 = t3 ? t28 : light.width;
        float t30 = t26 * t29;
        float t31 = t30 * t30;
        float t32 = fma(fma(fma(-0.00060778117, t31, -0.0027203285), t31, -0.10000902), t30, fma(fma(1.0676054e-5, t31, -0.011332183), t31, 1.0000001));
        t16 = t3 ? t25 : t20;
        t17 = t3 ? t4 : spherecap_min(spherecap_max(t28, 5.9604645e-8), 0.99999994);
        t18 = t29 * t32;
        t19 = t26;
    }
    float t33 = spherecap_float_of_bits(fma(spherecap_bits(t17), -0.33333334, 1419900500.0));
    float t34 = fma(-(t17 * t33), t33 * t33, 1.0);
    float t35 = t34 * t34;
    float t36 = fma(fma(fma(0.110958695, t35, 0.14403293), t35, 0.22222222), t34, fma(fma(0.12482853, t35, 0.17283951), t35, 0.33333334));
    float t37 = t18 * (t17 * fma(t33, t34 * t36, t33));
    float t38 = t37 * t19;
    float t39 = t38 * t38;
    float t40 = fma(fma(fma(-0.063446075, t39, -0.056249518), t39, 0.0074712755), t39, 0.09996679);
    float t41 = fma(fma(fma(0.022114987, t39, 0.085662976), t39, 0.030445365), t39, 0.03209764);
    float t42 = t37 * fma(t40, t38, fma(t41, t39, 1.0000004));
    float t43 = t6 ? spherecap_min(t42, 1.0) : t42;
    float t44 = t19 * t43;
    float t45 = 2.0 - t44;
    float t46 = t43 * t45;
    float t47 = sqrt(t46);
    float t48 = 0.0;
    float t49 = 0.0;
    float zenith = 0.0;
    float side = 0.0;
    float cosine = 0.0;
    if (t6) {
        float t50 = t14 - t15 < 0.0 ? t44 : t45;
        float t51 = t46 * t9;
        float t52 = 1.0 - t50;
        float t53 = spherecap_max(fma(light.climb, t50, -light.rise), 0.0);
        float t54 = sqrt(fma(t53, t53, light.radius_sin * light.radius_sin * t51));
        float t55 = t1 * light.radius_cos;
        float t56 = fma(light.elevation_cos * t52, fma(light.climb, t52, -2.0 * t55), light.radius_sin * t51);
        float t57 = light.radius_sin * fma(light.elevation_cos, t56 / (t54 + t55), -(t1 * t1 * t52));
        t48 = fma(light.half_axis, t52, light.middle);
        t49 = t54;
        zenith = t57;
        side = light.radius_sin * t47 * t8;
        cosine = t54;
    } else {
        float t58 = t47 * t16;
        float t59 = 1.0 - t44;
        t48 = t59;
        t49 = t58;
        zenith = fma(light.elevation_cos, t58, -((t3 ? -t1 : t1) * t59));
        side = t47 * t8;
        cosine = t58;
    }
    float t60 = 0.0 < cosine ? light.inv_above : 0.0;
    float t61 = fma(zenith, zenith, side * side);
    float t62 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t61), 0.0);
    float t63 = sqrt(t62);
    float t64 = sqrt(fma(light.radius_cos, light.radius_cos, t62));
    float t65 = light.radius_cos * light.radius_cos / (t64 + t63);
    float t66 = 1.0 / light.radius_sin;
    float t67 = t65 * t66;
    float t68 = -fma(t64, t63, t61) * t66;
    float t69 = t67 * zenith;
    float t70 = t67 * side;
    float t71 = fma(light.third_axis.x, t48, fma(light.sideways.x, side, light.normal.x * t49));
    float t72 = fma(light.third_axis.y, t48, fma(light.sideways.y, side, light.normal.y * t49));
    float t73 = fma(light.third_axis.z, t48, fma(light.sideways.z, side, light.normal.z * t49));
    float t74 = fma(light.elevation_cos, t68, -(light.elevation_sin * t69));
    float t75 = fma(light.elevation_sin, t68, light.elevation_cos * t69);
    float t76 = fma(light.third_axis.x, t74, fma(light.sideways.x, t70, light.normal.x * t75));
    float t77 = fma(light.third_axis.y, t74, fma(light.sideways.y, t70, light.normal.y * t75));
    float t78 = fma(light.third_axis.z, t74, fma(light.sideways.z, t70, light.normal.z * t75));
    spherecap_sample sampled;
    sampled.direction = vec3(t71, t72, t73);
    sampled.distance = t65 * light.distance;
    sampled.normal = vec3(t76, t77, t78);
    sampled.cosine = cosine;
    sampled.pdf = t60 * spherecap_min(abs(cosine), 3.4028235e38);
    sampled.projected_pdf = t60;
    return sampled;
}

spherecap_sample spherecap_surface_sample_once(vec3 normal, vec3 centre, float radius, float u0, float u1) {
    spherecap_surface_light light = spherecap_surface_prepare(normal, centre, radius);
    return spherecap_surface_sample(light, u0, u1);
}

float spherecap_surface_pdf_direction(spherecap_surface_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = fma(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    float t2 = fma(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    float t3 = fma(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    float t4 = fma(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    float t5 = fma(light.sideways.x, direction.x, fma(light.sideways.y, direction.y, light.sideways.z * direction.z));
    float t6 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    bool t7 = fma(light.towards_centre.x, direction.x, t1) < 0.0;
    float t8 = t7 ? 1.0 : fma(t2, direction.x, fma(t3, direction.y, t4 * direction.z));
    float t9 = t7 ? 1.0 : t5;
    float t10 = (0.0 < t6 ? light.inv_above : 0.0) * spherecap_min(abs(t6), 3.4028235e38);
    float t11 = fma(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019 ? t10 : 0.0;
    float t12 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t12 && t12 <= 1.002001) ? t11 : 0.0;
}

float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    float t2 = (0.0 < t1 ? light.inv_above : 0.0) * spherecap_min(abs(t1), 3.4028235e38);
    float t3 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t3 && t3 <= 1.002001) ? t2 : 0.0;
}

float spherecap_surface_importance(vec3 normal, vec3 centre, float radius, float strength) {
    float t1 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t2 = centre.x * scale;
    float t3 = centre.y * scale;
    float t4 = centre.z * scale;
    float t5 = radius * scale;
    float t6 = sqrt(fma(t2, t2, fma(t3, t3, t4 * t4)));
    float t7 = 1.0 / t6;
    float t8 = t5 * t7;
    float t9 = t8 * t8;
    bool t10 = 0.0 < radius && t6 * unscale <= 3.4028235e38 && 0.0 < strength && strength <= 3.4028235e38;
    float t11 = fma(normal.x, t2, fma(normal.y, t3, normal.z * t4));
    float t12 = fma(t11, t7, 2.3841858e-7);
    float t13 = fma(t11 + t5, t7, 2.3841858e-7);
    float t14 = t13 * t13 / (fma(t8 - t12, spherecap_max(fma(-t9, t9, 0.9999981), 0.0), t13) * 2.0);
    float t15 = t8 <= t12 ? t12 : 0.0 < t13 ? t14 : 0.0;
    float t16 = fma(0.0, 0.5 - t15, t15);
    float t17 = spherecap_min(spherecap_max(t9 * t16 * strength, 1.1754944e-38), 3.4028235e38);
    return (t9 <= 1.0000019 && 4.9303807e-32 < t9 && t10 && 0.0 < t16) ? t17 : 0.0;
}


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the
// probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with
// the normal.
struct spherecap_front_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    vec3 towards_centre;
    vec3 sideways;
    vec3 normal;
    vec3 up;
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
    vec3 third_axis;
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

spherecap_front_light spherecap_front_prepare(vec3 normal, vec3 centre, float radius, float defensive) {
    float t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    float normal_x = 0.0;
    float normal_y = 0.0;
    float normal_z = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        float t2 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        float t3 = spherecap_power_of_two(spherecap_min(t2, 8.5070587e37));
        float t4 = normal.x / t3;
        float t5 = normal.y / t3;
        float t6 = normal.z / t3;
        float t7 = spherecap_max(sqrt(fma(t4, t4, fma(t5, t5, t6 * t6))), 1.1754944e-38);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    float t8 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    bool t9 = fma(centre.x, centre.x, fma(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0;
    bool t10 = t9 && 9.536743e-7 < radius;
    float t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t12 = t10 ? centre.x : centre.x * scale;
    float t13 = t10 ? centre.y : centre.y * scale;
    float t14 = t10 ? centre.z : centre.z * scale;
    float t15 = t10 ? radius : radius * scale;
    precise float t16 = t14 * t14;
    float t17 = fma(t12, t12, fma(t13, t13, t16));
    float t18 = fma(-t15, t15, t17);
    float t19 = 0.0;
    float t20 = 0.0;
    if (t18 < t17 * 0.25) {
        precise float t21 = t12 * t12;
        precise float t22 = t13 * t13;
        precise float t23 = t21 + t22;
        precise float t24 = t23 - t21;
        precise float t25 = t23 + t16;
        precise float t26 = t25 - t23;
        float t27 = spherecap_lost(t12, t12, t21) + spherecap_lost(t13, t13, t22) + spherecap_lost(t14, t14, t16);
        precise float t28 = t27 + (t21 - (t23 - t24) + (t22 - t24) + (t23 - (t25 - t26) + (t16 - t26)));
        t19 = t25;
        t20 = spherecap_fused(-t15, t15, t25) + t28;
    } else {
        t19 = t17;
        t20 = t18;
    }
    bool t29 = 0.0 < t8;
    precise float t30 = normal_z * t13;
    float t31 = spherecap_fused(normal_y, t14, -t30);
    precise float t32 = normal_x * t14;
    float t33 = spherecap_fused(normal_z, t12, -t32);
    precise float t34 = normal_y * t12;
    float t35 = spherecap_fused(normal_x, t13, -t34);
    float t36 = fma(t31, t31, fma(t33, t33, t35 * t35));
    float up_x = 0.0;
    float up_y = 0.0;
    float up_z = 0.0;
    float t37 = 0.0;
    float t38 = 0.0;
    float t39 = 0.0;
    float t40 = 0.0;
    float t41 = 0.0;
    if (t36 < t19 * 0.015625) {
        float t42 = t31 - spherecap_lost(normal_z, t13, t30);
        float t43 = t33 - spherecap_lost(normal_x, t14, t32);
        float t44 = t35 - spherecap_lost(normal_y, t12, t34);
        float t45 = fma(t42, t42, fma(t43, t43, t44 * t44));
        bool t46 = t45 < t19 * 5.169879e-26;
        bool t47 = abs(t12) < abs(t14);
        float t48 = t47 ? 0.0 : -t13;
        float t49 = t47 ? -t14 : t12;
        float t50 = t47 ? t13 : 0.0;
        float t51 = sqrt(fma(t48, t48, fma(t49, t49, t50 * t50)));
        float t52 = sqrt(t19);
        float t53 = t52 * t51;
        float t54 = sqrt(t45);
        up_x = t46 ? (t29 ? normal_x : fma(t13, t50, -(t14 * t49)) / t53) : normal_x;
        up_y = t46 ? (t29 ? normal_y : fma(t14, t48, -(t12 * t50)) / t53) : normal_y;
        up_z = t46 ? (t29 ? normal_z : fma(t12, t49, -(t13 * t48)) / t53) : normal_z;
        t37 = t46 ? t48 : t42;
        t38 = t46 ? t49 : t43;
        t39 = t46 ? t50 : t44;
        t40 = t46 ? t51 : t54;
        t41 = t46 ? (t29 ? 0.0 : t52) : t54;
    } else {
        float t55 = sqrt(t36);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t37 = t31;
        t38 = t33;
        t39 = t35;
        t40 = t55;
        t41 = t55;
    }
    precise float t56 = normal_x * t12;
    precise float t57 = normal_y * t13;
    precise float t58 = normal_z * t14;
    precise float t59 = t56 + t57;
    precise float t60 = t59 - t56;
    precise float t61 = t59 + t58;
    precise float t62 = t61 - t59;
    float t63 = spherecap_lost(normal_x, t12, t56) + spherecap_lost(normal_y, t13, t57) + spherecap_lost(normal_z, t14, t58);
    precise float t64 = t63 + (t56 - (t59 - t60) + (t57 - t60) + (t59 - (t61 - t62) + (t58 - t62)));
    precise float t65 = t61 + t64;
    precise float t66 = t64 - (t65 - t61);
    float t67 = t15 - t65 - t66;
    float t68 = t15 + t65 + t66;
    float t69 = t67 * t68;
    float t70 = sqrt(t20);
    bool t71 = 0.0 < t20;
    float t_x = 0.0;
    float t_y = 0.0;
    float width = 0.0;
    float kappa = 0.0;
    float cut = 0.0;
    float shape = 0.0;
    float shape_difference = 0.0;
    float norm = 0.0;
    float tau = 0.0;
    float area = 0.0;
    float t72 = 0.0;
    if (0.0 < t69 && t29 && t71) {
        float t73 = sqrt(t20 + t69);
        float t74 = sqrt(t69);
        float t75 = 1.0 / (t73 * t15);
        float t76 = t75 * t15;
        float t77 = t75 * t73;
        float t78 = t70 * t76;
        float t79 = t74 * t76;
        float t80 = t79 * t79;
        float t81 = abs(t65) * t77;
        float t82 = t81 * t78;
        float t83 = t78 - 0.5;
        float t84 = t82 - 0.5;
        float t85 = t83 * t83;
        float t86 = t84 * t84;
        float t87 = fma(0.05430631, t85, 0.080950715);
        float t88 = fma(t87, t85, 0.1684019);
        float t89 = fma(t88, t85, 0.32709444);
        float t90 = fma(t89, t85, 0.5987523);
        float t91 = fma(-0.026061837, t85, -0.06372378);
        float t92 = fma(t91, t85, -0.11762552);
        float t93 = fma(t92, t85, -0.23594604);
        float t94 = fma(t93, t85, -0.44721135);
        float t95 = fma(t94, t85, -0.7754678);
        float t96 = fma(t95, t83, fma(t90, t85, 0.94559944));
        float t97 = fma(t84, fma(fma(fma(fma(-0.026061837, t86, t91), t86, t92), t86, t93), t86, t94), fma(fma(fma(fma(0.05430631, t86, t87), t86, t88), t86, t89), t86, t90));
        float t98 = fma(t97, t83 + t84, t95);
        float t99 = fma(t82, t98, t96);
        t_x = t78;
        t_y = t79;
        width = t80 / (1.0 + t78);
        kappa = t81;
        cut = t82;
        shape = t96;
        shape_difference = t98;
        norm = t99;
        tau = t74 * t77;
        area = t80 * t79 * (spherecap_min(t67, t68) * t77) * t99;
        t72 = t73;
    } else {
        t72 = t41;
    }
    float t100 = sqrt(t19);
    float t101 = 1.0 / t100;
    float radius_sin = t15 * t101;
    float radius_cos = t70 * t101;
    float elevation_sin = t65 * t101;
    float elevation_cos = t72 * t101;
    float t102 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = spherecap_max(t69 * (t101 * t101) / fma(radius_cos, t102, climb), -(radius_cos * t102));
    float t103 = radius_sin * radius_sin;
    bool t104 = 0.0 < elevation_sin;
    float t105 = t104 ? fma(t103 * t102, 3.1415927, area) : area;
    bool t106 = 9.8607613e-32 < t103;
    float t107 = 1.0 / t40;
    float sideways_x = t37 * t107;
    float sideways_y = t38 * t107;
    float sideways_z = t39 * t107;
    float on_surface = t29 ? 1.0 : 0.0;
    float distance = t100 * (t10 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t105 && t106 && t71) ? t105 : 0.0;
    bool t108 = 0.0 < tau;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    bool t109 = 0.0 < inv_above;
    float t110 = t104 ? inv_above : 0.0;
    float defensive_share = t109 ? defensive : 0.0 < defensive || !(0.0 < on_surface) ? 1.0 : 0.0;
    bool t111 = t108 && t104 && 0.0 < t110;
    float t112 = t_y * t_y * t_y * shape * t110;
    float t113 = t_y / radius_sin;
    float beyond = t111 ? t113 * t113 * t113 * fma(cut - t_x, shape_difference, shape) : 0.0;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    if (t108 && !t104) {
        float t114 = 1.0 + kappa;
        float t115 = t114 * shape;
        float t116 = 1.0 / (norm * t115);
        float t117 = sqrt(t116);
        float t118 = norm * t117;
        float t119 = 1.0 / (1.0 + cut);
        float t120 = (t_x + kappa) * t119 - 0.5;
        float t121 = t120 * t120;
        float t122 = fma(fma(fma(-0.026061837, t121, -0.06372378), t121, -0.11762552), t121, -0.23594604);
        float t123 = fma(fma(fma(0.05430631, t121, 0.080950715), t121, 0.1684019), t121, 0.32709444);
        float t124 = fma(fma(fma(t122, t121, -0.44721135), t121, -0.7754678), t120, fma(fma(t123, t121, 0.5987523), t121, 0.94559944));
        float t125 = t114 * t124 * (t119 * t119 * t119) * (t115 * t116);
        float t126 = fma(t125, t115 * t117, -1.0);
        float t127 = 1.0 - t125;
        float t128 = fma(fma(30.011856, t126, fma(-41.541264, t127, -37.009792)), t126, fma(77.96775, t127, 7.470758));
        float t129 = fma(fma(fma(fma(15.716111, t127, 0.0), t127, 9.961183), t127, -2.61785), t127, 0.8681748);
        float t130 = fma(fma(t128, t126, fma(fma(-49.13454, t127, -9.466533), t127, -1.5877596)), t126, t129);
        float t131 = t126 * t130;
        float t132 = fma(fma(7.295638, t126, -7.236236), t126, fma(fma(fma(-11.4868555, t127, 0.0), t127, 0.0), t127, 3.1255686));
        float t133 = fma(fma(fma(13.728438, t127, -7.981878), t127, 2.025724), t127, -0.7334958);
        float t134 = t126 * fma(t132, t126, t133);
        float t135 = fma(fma(-23.220068, t127, 7.332055), t126, fma(fma(fma(9.986537, t127, 25.22195), t127, 0.0), t127, -2.9581387));
        float t136 = fma(fma(fma(-19.722994, t127, 4.6594768), t127, -0.89538246), t127, 0.5143498);
        float t137 = t126 * fma(t135, t126, t136);
        float t138 = fma(fma(fma(1.946617, t126, -3.077631), t126, 1.4945927), t126, -0.24140751);
        float t139 = t126 * t138;
        float t140 = t126 * fma(fma(0.38173297, t126, -0.30305624), t126, 0.05897375);
        coefficients_0 = t118;
        coefficients_1 = t125 - t118 + t131;
        coefficients_2 = t134 - t131;
        coefficients_3 = t137 - t134;
        coefficients_4 = t139 - t137;
        coefficients_5 = t140 - t139;
        coefficients_6 = -t140;
    }
    bool t141 = 0.0 < defensive_share;
    float t142 = (t106 && 0.0 < radius_cos) ? t103 / (1.0 + radius_cos) : 0.0;
    float inv_solid_angle = t141 ? (0.0 < t142 ? 0.15915494 / t142 : 0.0) : 0.0;
    bool t143 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && (t109 || (t141 && 0.0 < inv_solid_angle));
    spherecap_front_light light;
    light.is_sampled = t143;
    light.solid_angle = t143 ? t142 * 6.2831855 : 0.0;
    light.projected_solid_angle = t143 ? projected_above : 0.0;
    light.towards_centre = vec3(t12 * t101, t13 * t101, t14 * t101);
    light.sideways = vec3(sideways_x, sideways_y, sideways_z);
    light.normal = vec3(normal_x, normal_y, normal_z);
    light.up = vec3(up_x, up_y, up_z);
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
    light.third_axis = vec3(fma(sideways_y, up_z, -(sideways_z * up_y)), fma(sideways_z, up_x, -(sideways_x * up_z)), fma(sideways_x, up_y, -(sideways_y * up_x)));
    light.height = t141 ? t142 : 0.0;
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = t111 ? t112 : 0.0;
    light.inv_rest = t111 ? 1.0 / (1.0 - t112) : 1.0;
    light.beyond = beyond;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t102;
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

spherecap_sample spherecap_front_sample(spherecap_front_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    bool t2 = 0.0 < light.defensive_share;
    float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    bool t5 = t2 && t3 < light.defensive_share;
    float t6 = 1.0 - light.defensive_share;
    float t7 = (t5 ? t3 : t3 - light.defensive_share) / (t5 ? light.defensive_share : t6);
    float t8 = 0.0 < light.requested ? spherecap_min(spherecap_max(t7, 5.9604645e-8), 0.99999994) : t3;
    bool t9 = t5 || !(0.0 < light.tau);
    bool t10 = !t9 && !(0.0 < light.elevation_sin);
    bool t11 = t9 || (!t10 && light.crescent_share <= t8);
    float t12 = 1.0 - t4;
    float t13 = t4 - t12;
    float t14 = 4.0 * t4 * t12;
    float t15 = spherecap_max((t8 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
    float t16 = t9 ? t8 : spherecap_min(t15, 0.99999994);
    float t17 = t9 ? 0.0 : light.beyond;
    float t18 = 3.1415927 - t17;
    float t19 = fma(t16, t18, t17);
    float t20 = (1.0 - t16) * t18;
    float t21 = 0.0;
    float t22 = 0.0;
    float t23 = 0.0;
    float t24 = 0.0;
    if (t11) {
        t22 = spherecap_min(t19, t20) * 0.53033006;
        t23 = 1.0;
        t24 = 1.0;
    } else {
        float t25 = sqrt(t14);
        float t26 = fma(fma(light.coefficients_6, t14, light.coefficients_4), t14, light.coefficients_2);
        float t27 = fma(fma(light.coefficients_5, t14, light.coefficients_3), t14, light.coefficients_1);
        float t28 = t25 * fma(t27, t25, fma(t26, t14, light.coefficients_0));
        float t29 = sqrt(fma(t13, t13, t28 * t28));
        float t30 = light.tau * t28;
        float t31 = t10 ? fma(t13, t13, t30 * t30) : 1.0;
        float t32 = t10 ? fma(light.kappa, t28, t29) * fma(light.cut, t28, t29) : light.crescent_share;
        float t33 = (t10 ? light.width : t8) / t32;
        float t34 = t10 ? t33 : light.width;
        float t35 = t31 * t34;
        float t36 = t35 * t35;
        float t37 = fma(fma(fma(-0.00060778117, t36, -0.0027203285), t36, -0.10000902), t35, fma(fma(1.0676054e-5, t36, -0.011332183), t36, 1.0000001));
        t21 = t10 ? t30 : t25;
        t22 = t10 ? t8 : spherecap_min(spherecap_max(t33, 5.9604645e-8), 0.99999994);
        t23 = t34 * t37;
        t24 = t31;
    }
    float t38 = spherecap_float_of_bits(fma(spherecap_bits(t22), -0.33333334, 1419900500.0));
    float t39 = fma(-(t22 * t38), t38 * t38, 1.0);
    float t40 = t39 * t39;
    float t41 = fma(fma(fma(0.110958695, t40, 0.14403293), t40, 0.22222222), t39, fma(fma(0.12482853, t40, 0.17283951), t40, 0.33333334));
    float t42 = t23 * (t22 * fma(t38, t39 * t41, t38));
    float t43 = t42 * t24;
    float t44 = t43 * t43;
    float t45 = fma(fma(fma(-0.063446075, t44, -0.056249518), t44, 0.0074712755), t44, 0.09996679);
    float t46 = fma(fma(fma(0.022114987, t44, 0.085662976), t44, 0.030445365), t44, 0.03209764);
    float t47 = t42 * fma(t45, t43, fma(t46, t44, 1.0000004));
    float t48 = t11 ? spherecap_min(t47, 1.0) : t47;
    float t49 = t24 * t48;
    float t50 = 2.0 - t49;
    float t51 = t48 * t50;
    float t52 = sqrt(t51);
    float t53 = 0.0;
    float t54 = 0.0;
    float zenith = 0.0;
    float side = 0.0;
    float cosine = 0.0;
    if (t11) {
        float t55 = t19 - t20 < 0.0 ? t49 : t50;
        float t56 = t51 * t14;
        float t57 = 0.0;
        float t58 = 0.0;
        float t59 = 0.0;
        float t60 = 0.0;
        float t61 = 0.0;
        if (t5) {
            float t62 = light.height * (1.0 - t56);
            float t63 = sqrt(light.height * (2.0 - t62));
            float t64 = (t55 - 1.0) * t63;
            float t65 = 1.0 - t62;
            float t66 = fma(light.elevation_sin, t65, light.elevation_cos * t64);
            t57 = fma(light.elevation_cos, t65, -(light.elevation_sin * t64));
            t58 = t66;
            t59 = t64;
            t60 = t52 * t13 * t63;
            t61 = t66 * light.on_surface;
        } else {
            float t67 = 1.0 - t55;
            float t68 = spherecap_max(fma(light.climb, t55, -light.rise), 0.0);
            float t69 = sqrt(fma(t68, t68, light.radius_sin * light.radius_sin * t56));
            float t70 = t1 * light.radius_cos;
            float t71 = fma(light.elevation_cos * t67, fma(light.climb, t67, -2.0 * t70), light.radius_sin * t56);
            float t72 = light.radius_sin * fma(light.elevation_cos, t71 / (t69 + t70), -(t1 * t1 * t67));
            t57 = fma(light.half_axis, t67, light.middle);
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
        float t73 = t52 * t21;
        float t74 = 1.0 - t49;
        t53 = t74;
        t54 = t73;
        zenith = fma(light.elevation_cos, t73, -((t10 ? -t1 : t1) * t74));
        side = t52 * t13;
        cosine = t73;
    }
    float t75 = spherecap_min(abs(cosine), 3.4028235e38);
    float t76 = 0.0 < cosine ? light.inv_above : 0.0;
    float t77 = light.defensive_share * light.inv_solid_angle;
    float t78 = fma(t76, t6, spherecap_min(t77 / spherecap_max(t75, 1.1754944e-38), 3.4028235e38));
    float t79 = fma(zenith, zenith, side * side);
    float t80 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t79), 0.0);
    float t81 = sqrt(t80);
    float t82 = sqrt(fma(light.radius_cos, light.radius_cos, t80));
    float t83 = light.radius_cos * light.radius_cos / (t82 + t81);
    float t84 = 1.0 / light.radius_sin;
    float t85 = t83 * t84;
    float t86 = -fma(t82, t81, t79) * t84;
    float t87 = t85 * zenith;
    float t88 = t85 * side;
    float t89 = fma(light.third_axis.x, t53, fma(light.sideways.x, side, light.up.x * t54));
    float t90 = fma(light.third_axis.y, t53, fma(light.sideways.y, side, light.up.y * t54));
    float t91 = fma(light.third_axis.z, t53, fma(light.sideways.z, side, light.up.z * t54));
    float t92 = fma(light.elevation_cos, t86, -(light.elevation_sin * t87));
    float t93 = fma(light.elevation_sin, t86, light.elevation_cos * t87);
    float t94 = fma(light.third_axis.x, t92, fma(light.sideways.x, t88, light.up.x * t93));
    float t95 = fma(light.third_axis.y, t92, fma(light.sideways.y, t88, light.up.y * t93));
    float t96 = fma(light.third_axis.z, t92, fma(light.sideways.z, t88, light.up.z * t93));
    spherecap_sample sampled;
    sampled.direction = vec3(t89, t90, t91);
    sampled.distance = t83 * light.distance;
    sampled.normal = vec3(t94, t95, t96);
    sampled.cosine = cosine;
    sampled.pdf = t2 ? fma(t76, t6 * t75, t77) : t76 * t75;
    sampled.projected_pdf = t2 ? spherecap_min(t78, 3.4028235e38) : t76;
    return sampled;
}

spherecap_sample spherecap_front_sample_once(vec3 normal, vec3 centre, float radius, float defensive, float u0, float u1) {
    spherecap_front_light light = spherecap_front_prepare(normal, centre, radius, defensive);
    return spherecap_front_sample(light, u0, u1);
}

float spherecap_front_pdf_direction(spherecap_front_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = fma(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    float t2 = fma(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    float t3 = fma(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    float t4 = fma(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    float t5 = fma(light.sideways.x, direction.x, fma(light.sideways.y, direction.y, light.sideways.z * direction.z));
    float t6 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    bool t7 = fma(light.towards_centre.x, direction.x, t1) < 0.0;
    float t8 = t7 ? 1.0 : fma(t2, direction.x, fma(t3, direction.y, t4 * direction.z));
    float t9 = t7 ? 1.0 : t5;
    float t10 = spherecap_min(abs(t6), 3.4028235e38);
    float t11 = 0.0 < t6 ? light.inv_above : 0.0;
    float t12 = fma(t11, (1.0 - light.defensive_share) * t10, light.defensive_share * light.inv_solid_angle);
    float t13 = fma(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.defensive_share ? t12 : t11 * t10) : 0.0;
    float t14 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t14 && t14 <= 1.002001) ? t13 : 0.0;
}

float spherecap_front_pdf_on_sphere(spherecap_front_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    float t2 = spherecap_min(abs(t1), 3.4028235e38);
    float t3 = 0.0 < t1 ? light.inv_above : 0.0;
    float t4 = fma(t3, (1.0 - light.defensive_share) * t2, light.defensive_share * light.inv_solid_angle);
    float t5 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    float t6 = (0.998001 <= t5 && t5 <= 1.002001) ? (0.0 < light.defensive_share ? t4 : t3 * t2) : 0.0;
    return t6;
}

float spherecap_front_importance(vec3 normal, vec3 centre, float radius, float defensive, float strength) {
    float t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    float t2 = 0.0;
    float t3 = 0.0;
    float t4 = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        t2 = normal.x;
        t3 = normal.y;
        t4 = normal.z;
    } else {
        float t5 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        float t6 = spherecap_power_of_two(spherecap_min(t5, 8.5070587e37));
        float t7 = normal.x / t6;
        float t8 = normal.y / t6;
        float t9 = normal.z / t6;
        float t10 = spherecap_max(sqrt(fma(t7, t7, fma(t8, t8, t9 * t9))), 1.1754944e-38);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    float t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t12 = centre.x * scale;
    float t13 = centre.y * scale;
    float t14 = centre.z * scale;
    float t15 = radius * scale;
    float t16 = sqrt(fma(t12, t12, fma(t13, t13, t14 * t14)));
    float t17 = 1.0 / t16;
    float t18 = t15 * t17;
    float t19 = t18 * t18;
    float t20 = fma(t2, t2, fma(t3, t3, t4 * t4));
    bool t21 = 0.0 <= defensive && defensive <= 1.0 && t20 <= 2.0 && 0.0 < radius && t16 * unscale <= 3.4028235e38;
    float t22 = fma(t2, t12, fma(t3, t13, t4 * t14));
    float t23 = fma(t22, t17, 2.3841858e-7);
    float t24 = fma(t22 + t15, t17, 2.3841858e-7);
    float t25 = t24 * t24 / (fma(t18 - t23, spherecap_max(fma(-t19, t19, 0.9999981), 0.0), t24) * 2.0);
    float t26 = t18 <= t23 ? t23 : 0.0 < t24 ? t25 : 0.0;
    float t27 = t20 <= 0.0 ? 1.0 : fma(defensive, 0.5 - t26, t26);
    bool t28 = t19 <= 1.0000019 && 4.9303807e-32 < t19 && t21 && 0.0 < strength && strength <= 3.4028235e38;
    float t29 = spherecap_min(spherecap_max(t19 * t27 * strength, 1.1754944e-38), 3.4028235e38);
    return (t28 && (0.0 < t27 || 0.0 < defensive)) ? t29 : 0.0;
}


// The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.
struct spherecap_both_light {
    bool is_sampled;
    float solid_angle;
    float projected_solid_angle;
    vec3 towards_centre;
    vec3 sideways;
    vec3 normal;
    vec3 up;
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
    vec3 third_axis;
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

spherecap_both_light spherecap_both_prepare(vec3 normal, vec3 centre, float radius, float defensive) {
    float t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    float normal_x = 0.0;
    float normal_y = 0.0;
    float normal_z = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        float t2 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        float t3 = spherecap_power_of_two(spherecap_min(t2, 8.5070587e37));
        float t4 = normal.x / t3;
        float t5 = normal.y / t3;
        float t6 = normal.z / t3;
        float t7 = spherecap_max(sqrt(fma(t4, t4, fma(t5, t5, t6 * t6))), 1.1754944e-38);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    float t8 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    bool t9 = fma(centre.x, centre.x, fma(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0;
    bool t10 = t9 && 9.536743e-7 < radius;
    float t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t12 = t10 ? centre.x : centre.x * scale;
    float t13 = t10 ? centre.y : centre.y * scale;
    float t14 = t10 ? centre.z : centre.z * scale;
    float t15 = t10 ? radius : radius * scale;
    precise float t16 = t14 * t14;
    float t17 = fma(t12, t12, fma(t13, t13, t16));
    float t18 = fma(-t15, t15, t17);
    float t19 = 0.0;
    float t20 = 0.0;
    if (t18 < t17 * 0.25) {
        precise float t21 = t12 * t12;
        precise float t22 = t13 * t13;
        precise float t23 = t21 + t22;
        precise float t24 = t23 - t21;
        precise float t25 = t23 + t16;
        precise float t26 = t25 - t23;
        float t27 = spherecap_lost(t12, t12, t21) + spherecap_lost(t13, t13, t22) + spherecap_lost(t14, t14, t16);
        precise float t28 = t27 + (t21 - (t23 - t24) + (t22 - t24) + (t23 - (t25 - t26) + (t16 - t26)));
        t19 = t25;
        t20 = spherecap_fused(-t15, t15, t25) + t28;
    } else {
        t19 = t17;
        t20 = t18;
    }
    bool t29 = 0.0 < t8;
    precise float t30 = normal_z * t13;
    float t31 = spherecap_fused(normal_y, t14, -t30);
    precise float t32 = normal_x * t14;
    float t33 = spherecap_fused(normal_z, t12, -t32);
    precise float t34 = normal_y * t12;
    float t35 = spherecap_fused(normal_x, t13, -t34);
    float t36 = fma(t31, t31, fma(t33, t33, t35 * t35));
    float up_x = 0.0;
    float up_y = 0.0;
    float up_z = 0.0;
    float t37 = 0.0;
    float t38 = 0.0;
    float t39 = 0.0;
    float t40 = 0.0;
    float t41 = 0.0;
    if (t36 < t19 * 0.015625) {
        float t42 = t31 - spherecap_lost(normal_z, t13, t30);
        float t43 = t33 - spherecap_lost(normal_x, t14, t32);
        float t44 = t35 - spherecap_lost(normal_y, t12, t34);
        float t45 = fma(t42, t42, fma(t43, t43, t44 * t44));
        bool t46 = t45 < t19 * 5.169879e-26;
        bool t47 = abs(t12) < abs(t14);
        float t48 = t47 ? 0.0 : -t13;
        float t49 = t47 ? -t14 : t12;
        float t50 = t47 ? t13 : 0.0;
        float t51 = sqrt(fma(t48, t48, fma(t49, t49, t50 * t50)));
        float t52 = sqrt(t19);
        float t53 = t52 * t51;
        float t54 = sqrt(t45);
        up_x = t46 ? (t29 ? normal_x : fma(t13, t50, -(t14 * t49)) / t53) : normal_x;
        up_y = t46 ? (t29 ? normal_y : fma(t14, t48, -(t12 * t50)) / t53) : normal_y;
        up_z = t46 ? (t29 ? normal_z : fma(t12, t49, -(t13 * t48)) / t53) : normal_z;
        t37 = t46 ? t48 : t42;
        t38 = t46 ? t49 : t43;
        t39 = t46 ? t50 : t44;
        t40 = t46 ? t51 : t54;
        t41 = t46 ? (t29 ? 0.0 : t52) : t54;
    } else {
        float t55 = sqrt(t36);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t37 = t31;
        t38 = t33;
        t39 = t35;
        t40 = t55;
        t41 = t55;
    }
    precise float t56 = normal_x * t12;
    precise float t57 = normal_y * t13;
    precise float t58 = normal_z * t14;
    precise float t59 = t56 + t57;
    precise float t60 = t59 - t56;
    precise float t61 = t59 + t58;
    precise float t62 = t61 - t59;
    float t63 = spherecap_lost(normal_x, t12, t56) + spherecap_lost(normal_y, t13, t57) + spherecap_lost(normal_z, t14, t58);
    precise float t64 = t63 + (t56 - (t59 - t60) + (t57 - t60) + (t59 - (t61 - t62) + (t58 - t62)));
    precise float t65 = t61 + t64;
    precise float t66 = t64 - (t65 - t61);
    float t67 = t15 - t65 - t66;
    float t68 = t15 + t65 + t66;
    float t69 = t67 * t68;
    float t70 = sqrt(t20);
    bool t71 = 0.0 < t20;
    float t_x = 0.0;
    float t_y = 0.0;
    float width = 0.0;
    float kappa = 0.0;
    float cut = 0.0;
    float shape = 0.0;
    float shape_difference = 0.0;
    float norm = 0.0;
    float tau = 0.0;
    float area = 0.0;
    float t72 = 0.0;
    if (0.0 < t69 && t29 && t71) {
        float t73 = sqrt(t20 + t69);
        float t74 = sqrt(t69);
        float t75 = 1.0 / (t73 * t15);
        float t76 = t75 * t15;
        float t77 = t75 * t73;
        float t78 = t70 * t76;
        float t79 = t74 * t76;
        float t80 = t79 * t79;
        float t81 = abs(t65) * t77;
        float t82 = t81 * t78;
        float t83 = t78 - 0.5;
        float t84 = t82 - 0.5;
        float t85 = t83 * t83;
        float t86 = t84 * t84;
        float t87 = fma(0.05430631, t85, 0.080950715);
        float t88 = fma(t87, t85, 0.1684019);
        float t89 = fma(t88, t85, 0.32709444);
        float t90 = fma(t89, t85, 0.5987523);
        float t91 = fma(-0.026061837, t85, -0.06372378);
        float t92 = fma(t91, t85, -0.11762552);
        float t93 = fma(t92, t85, -0.23594604);
        float t94 = fma(t93, t85, -0.44721135);
        float t95 = fma(t94, t85, -0.7754678);
        float t96 = fma(t95, t83, fma(t90, t85, 0.94559944));
        float t97 = fma(t84, fma(fma(fma(fma(-0.026061837, t86, t91), t86, t92), t86, t93), t86, t94), fma(fma(fma(fma(0.05430631, t86, t87), t86, t88), t86, t89), t86, t90));
        float t98 = fma(t97, t83 + t84, t95);
        float t99 = fma(t82, t98, t96);
        t_x = t78;
        t_y = t79;
        width = t80 / (1.0 + t78);
        kappa = t81;
        cut = t82;
        shape = t96;
        shape_difference = t98;
        norm = t99;
        tau = t74 * t77;
        area = t80 * t79 * (spherecap_min(t67, t68) * t77) * t99;
        t72 = t73;
    } else {
        t72 = t41;
    }
    float t100 = sqrt(t19);
    float t101 = 1.0 / t100;
    float radius_sin = t15 * t101;
    float radius_cos = t70 * t101;
    float elevation_sin = t65 * t101;
    float elevation_cos = t72 * t101;
    float t102 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = spherecap_max(t69 * (t101 * t101) / fma(radius_cos, t102, climb), -(radius_cos * t102));
    float t103 = radius_sin * radius_sin;
    float t104 = fma(t103 * t102, 3.1415927, area);
    bool t105 = 0.0 < elevation_sin;
    float t106 = t105 ? t104 : area;
    float t107 = t105 ? area : t104;
    bool t108 = 9.8607613e-32 < t103;
    bool t109 = t108 && t71;
    float t110 = 1.0 / t40;
    float sideways_x = t37 * t110;
    float sideways_y = t38 * t110;
    float sideways_z = t39 * t110;
    float on_surface = t29 ? 1.0 : 0.0;
    float distance = t100 * (t10 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t106 && t109) ? t106 : 0.0;
    float projected_below = (9.403955e-38 < t107 && t109) ? t107 : 0.0;
    bool t111 = 0.0 < tau;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    float inv_below = 0.0 < projected_below ? 1.0 / projected_below : 0.0;
    bool t112 = 0.0 < inv_above + inv_below;
    float t113 = t105 ? inv_above : inv_below;
    float defensive_share = t112 ? defensive : 0.0 < defensive || !(0.0 < on_surface) ? 1.0 : 0.0;
    bool t114 = t111 && 0.0 < t113;
    float t115 = t_y * t_y * t_y * shape * t113;
    float t116 = t_y / radius_sin;
    float t117 = fma(cut - t_x, shape_difference, shape);
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    float t118 = 0.0;
    if (t111) {
        float t119 = 1.0 + kappa;
        float t120 = t119 * shape;
        float t121 = 1.0 / (norm * t120);
        float t122 = sqrt(t121);
        float t123 = norm * t122;
        float t124 = 1.0 / (1.0 + cut);
        float t125 = (t_x + kappa) * t124 - 0.5;
        float t126 = t125 * t125;
        float t127 = fma(fma(fma(-0.026061837, t126, -0.06372378), t126, -0.11762552), t126, -0.23594604);
        float t128 = fma(fma(fma(0.05430631, t126, 0.080950715), t126, 0.1684019), t126, 0.32709444);
        float t129 = fma(fma(fma(t127, t126, -0.44721135), t126, -0.7754678), t125, fma(fma(t128, t126, 0.5987523), t126, 0.94559944));
        float t130 = t119 * t129 * (t124 * t124 * t124) * (t120 * t121);
        float t131 = fma(t130, t120 * t122, -1.0);
        float t132 = 1.0 - t130;
        float t133 = fma(fma(30.011856, t131, fma(-41.541264, t132, -37.009792)), t131, fma(77.96775, t132, 7.470758));
        float t134 = fma(fma(fma(fma(15.716111, t132, 0.0), t132, 9.961183), t132, -2.61785), t132, 0.8681748);
        float t135 = fma(fma(t133, t131, fma(fma(-49.13454, t132, -9.466533), t132, -1.5877596)), t131, t134);
        float t136 = t131 * t135;
        float t137 = fma(fma(7.295638, t131, -7.236236), t131, fma(fma(fma(-11.4868555, t132, 0.0), t132, 0.0), t132, 3.1255686));
        float t138 = fma(fma(fma(13.728438, t132, -7.981878), t132, 2.025724), t132, -0.7334958);
        float t139 = t131 * fma(t137, t131, t138);
        float t140 = fma(fma(-23.220068, t132, 7.332055), t131, fma(fma(fma(9.986537, t132, 25.22195), t132, 0.0), t132, -2.9581387));
        float t141 = fma(fma(fma(-19.722994, t132, 4.6594768), t132, -0.89538246), t132, 0.5143498);
        float t142 = t131 * fma(t140, t131, t141);
        float t143 = fma(fma(fma(1.946617, t131, -3.077631), t131, 1.4945927), t131, -0.24140751);
        float t144 = t131 * t143;
        float t145 = t131 * fma(fma(0.38173297, t131, -0.30305624), t131, 0.05897375);
        float t146 = 1.0 / (elevation_cos * elevation_cos);
        float t147 = tau * tau;
        float t148 = t147 * t146 / (1.0 + t_x);
        float t149 = kappa - 0.5;
        float t150 = cut - 0.5;
        float t151 = t149 * t149;
        float t152 = t150 * t150;
        float t153 = fma(0.05430631, t151, 0.080950715);
        float t154 = fma(t153, t151, 0.1684019);
        float t155 = fma(t154, t151, 0.32709444);
        float t156 = fma(fma(fma(fma(0.05430631, t152, t153), t152, t154), t152, t155), t152, fma(t155, t151, 0.5987523));
        float t157 = fma(-0.026061837, t151, -0.06372378);
        float t158 = fma(t157, t151, -0.11762552);
        float t159 = fma(t158, t151, -0.23594604);
        float t160 = fma(t159, t151, -0.44721135);
        float t161 = fma(fma(fma(fma(-0.026061837, t152, t157), t152, t158), t152, t159), t152, t160);
        float t162 = fma(kappa * t148, fma(fma(t150, t161, t156), t149 + t150, fma(t160, t151, -0.7754678)), fma(t117, t148 - kappa * kappa, kappa) * t146);
        float t163 = spherecap_min(spherecap_max(t147 * tau * (radius_cos + 1.0) * t162 * 0.31830987, 0.0), 0.5);
        coefficients_0 = t123;
        coefficients_1 = t130 - t123 + t136;
        coefficients_2 = t139 - t136;
        coefficients_3 = t142 - t139;
        coefficients_4 = t144 - t142;
        coefficients_5 = t145 - t144;
        coefficients_6 = -t145;
        t118 = t163;
    }
    bool t164 = 0.0 < defensive_share;
    float t165 = (t108 && 0.0 < radius_cos) ? t103 / (1.0 + radius_cos) : 0.0;
    float inv_solid_angle = t164 ? (0.0 < t165 ? 0.15915494 / t165 : 0.0) : 0.0;
    float sides_share = 0.0 < inv_below ? (0.0 < inv_above ? (t105 ? 1.0 - t118 : t118) : 0.0) : 1.0;
    bool t166 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && (t112 || (t164 && 0.0 < inv_solid_angle));
    spherecap_both_light light;
    light.is_sampled = t166;
    light.solid_angle = t166 ? t165 * 6.2831855 : 0.0;
    light.projected_solid_angle = t166 ? projected_above : 0.0;
    light.towards_centre = vec3(t12 * t101, t13 * t101, t14 * t101);
    light.sideways = vec3(sideways_x, sideways_y, sideways_z);
    light.normal = vec3(normal_x, normal_y, normal_z);
    light.up = vec3(up_x, up_y, up_z);
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
    light.third_axis = vec3(fma(sideways_y, up_z, -(sideways_z * up_y)), fma(sideways_z, up_x, -(sideways_x * up_z)), fma(sideways_x, up_y, -(sideways_y * up_x)));
    light.height = t164 ? t165 : 0.0;
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = t114 ? t115 : 0.0;
    light.inv_rest = t114 ? 1.0 / (1.0 - t115) : 1.0;
    light.beyond = t114 ? t116 * t116 * t116 * t117 : 0.0;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t102;
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

spherecap_sample spherecap_both_sample(spherecap_both_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    bool t2 = 0.0 < light.elevation_sin;
    bool t3 = 0.0 < light.defensive_share;
    float t4 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    float t5 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    bool t6 = t3 && t4 < light.defensive_share;
    float t7 = 1.0 - light.defensive_share;
    float t8 = (t6 ? t4 : t4 - light.defensive_share) / (t6 ? light.defensive_share : t7);
    float t9 = 0.0 < light.requested ? spherecap_min(spherecap_max(t8, 5.9604645e-8), 0.99999994) : t4;
    bool t10 = t6 || t9 < light.sides_share;
    float t11 = 1.0 - light.sides_share;
    float t12 = spherecap_max((t10 ? t9 : t9 - light.sides_share) / (t10 ? light.sides_share : t11), 5.9604645e-8);
    float t13 = t6 ? t9 : spherecap_min(t12, 0.99999994);
    bool t14 = t6 || !(0.0 < light.tau);
    bool t15 = !t14 && !((t10 && t2) || (!t10 && !t2));
    bool t16 = t14 || (!t15 && light.crescent_share <= t13);
    float t17 = 1.0 - t5;
    float t18 = t5 - t17;
    float t19 = 4.0 * t5 * t17;
    float t20 = spherecap_max((t13 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
    float t21 = t14 ? t13 : spherecap_min(t20, 0.99999994);
    float t22 = t14 ? 0.0 : light.beyond;
    float t23 = 3.1415927 - t22;
    float t24 = fma(t21, t23, t22);
    float t25 = (1.0 - t21) * t23;
    float t26 = 0.0;
    float t27 = 0.0;
    float t28 = 0.0;
    float t29 = 0.0;
    if (t16) {
        t27 = spherecap_min(t24, t25) * 0.53033006;
        t28 = 1.0;
        t29 = 1.0;
    } else {
        float t30 = sqrt(t19);
        float t31 = fma(fma(light.coefficients_6, t19, light.coefficients_4), t19, light.coefficients_2);
        float t32 = fma(fma(light.coefficients_5, t19, light.coefficients_3), t19, light.coefficients_1);
        float t33 = t30 * fma(t32, t30, fma(t31, t19, light.coefficients_0));
        float t34 = sqrt(fma(t18, t18, t33 * t33));
        float t35 = light.tau * t33;
        float t36 = t15 ? fma(t18, t18, t35 * t35) : 1.0;
        float t37 = t15 ? fma(light.kappa, t33, t34) * fma(light.cut, t33, t34) : light.crescent_share;
        float t38 = (t15 ? light.width : t13) / t37;
        float t39 = t15 ? t38 : light.width;
        float t40 = t36 * t39;
        float t41 = t40 * t40;
        float t42 = fma(fma(fma(-0.00060778117, t41, -0.0027203285), t41, -0.10000902), t40, fma(fma(1.0676054e-5, t41, -0.011332183), t41, 1.0000001));
        t26 = t15 ? t35 : t30;
        t27 = t15 ? t13 : spherecap_min(spherecap_max(t38, 5.9604645e-8), 0.99999994);
        t28 = t39 * t42;
        t29 = t36;
    }
    float t43 = spherecap_float_of_bits(fma(spherecap_bits(t27), -0.33333334, 1419900500.0));
    float t44 = fma(-(t27 * t43), t43 * t43, 1.0);
    float t45 = t44 * t44;
    float t46 = fma(fma(fma(0.110958695, t45, 0.14403293), t45, 0.22222222), t44, fma(fma(0.12482853, t45, 0.17283951), t45, 0.33333334));
    float t47 = t28 * (t27 * fma(t43, t44 * t46, t43));
    float t48 = t47 * t29;
    float t49 = t48 * t48;
    float t50 = fma(fma(fma(-0.063446075, t49, -0.056249518), t49, 0.0074712755), t49, 0.09996679);
    float t51 = fma(fma(fma(0.022114987, t49, 0.085662976), t49, 0.030445365), t49, 0.03209764);
    float t52 = t47 * fma(t50, t48, fma(t51, t49, 1.0000004));
    float t53 = t16 ? spherecap_min(t52, 1.0) : t52;
    float t54 = t29 * t53;
    float t55 = 2.0 - t54;
    float t56 = t53 * t55;
    float t57 = sqrt(t56);
    float t58 = 0.0;
    float t59 = 0.0;
    float t60 = 0.0;
    float side = 0.0;
    float t61 = 0.0;
    if (t16) {
        float t62 = t24 - t25 < 0.0 ? t54 : t55;
        float t63 = t56 * t19;
        float t64 = 0.0;
        float t65 = 0.0;
        float t66 = 0.0;
        float t67 = 0.0;
        float t68 = 0.0;
        if (t6) {
            float t69 = light.height * (1.0 - t63);
            float t70 = sqrt(light.height * (2.0 - t69));
            float t71 = (t62 - 1.0) * t70;
            float t72 = 1.0 - t69;
            float t73 = fma(light.elevation_sin, t72, light.elevation_cos * t71);
            t64 = fma(light.elevation_cos, t72, -(light.elevation_sin * t71));
            t65 = t73;
            t66 = t71;
            t67 = t57 * t18 * t70;
            t68 = t73 * light.on_surface;
        } else {
            float t74 = 1.0 - t62;
            float t75 = spherecap_max(fma(light.climb, t62, -light.rise), 0.0);
            float t76 = sqrt(fma(t75, t75, light.radius_sin * light.radius_sin * t63));
            float t77 = t1 * light.radius_cos;
            float t78 = fma(light.elevation_cos * t74, fma(light.climb, t74, -2.0 * t77), light.radius_sin * t63);
            float t79 = light.radius_sin * fma(light.elevation_cos, t78 / (t76 + t77), -(t1 * t1 * t74));
            t64 = fma(light.half_axis, t74, light.middle);
            t65 = t76;
            t66 = t79;
            t67 = light.radius_sin * t57 * t18;
            t68 = t76;
        }
        t58 = t64;
        t59 = t65;
        t60 = t66;
        side = t67;
        t61 = t68;
    } else {
        float t80 = t57 * t26;
        float t81 = 1.0 - t54;
        t58 = t81;
        t59 = t80;
        t60 = fma(light.elevation_cos, t80, -((t15 ? -t1 : t1) * t81));
        side = t57 * t18;
        t61 = t80;
    }
    float t82 = t10 ? 1.0 : -1.0;
    float zenith = t60 * t82;
    float cosine = t61 * t82;
    float t83 = t59 * t82;
    float t84 = spherecap_min(abs(cosine), 3.4028235e38);
    float t85 = 0.0 < cosine ? light.inv_above * light.sides_share : cosine < 0.0 ? light.inv_below * t11 : 0.0;
    float t86 = light.defensive_share * light.inv_solid_angle;
    float t87 = fma(t85, t7, spherecap_min(t86 / spherecap_max(t84, 1.1754944e-38), 3.4028235e38));
    float t88 = fma(zenith, zenith, side * side);
    float t89 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t88), 0.0);
    float t90 = sqrt(t89);
    float t91 = sqrt(fma(light.radius_cos, light.radius_cos, t89));
    float t92 = light.radius_cos * light.radius_cos / (t91 + t90);
    float t93 = 1.0 / light.radius_sin;
    float t94 = t92 * t93;
    float t95 = -fma(t91, t90, t88) * t93;
    float t96 = t94 * zenith;
    float t97 = t94 * side;
    float t98 = fma(light.third_axis.x, t58, fma(light.sideways.x, side, light.up.x * t83));
    float t99 = fma(light.third_axis.y, t58, fma(light.sideways.y, side, light.up.y * t83));
    float t100 = fma(light.third_axis.z, t58, fma(light.sideways.z, side, light.up.z * t83));
    float t101 = fma(light.elevation_cos, t95, -(light.elevation_sin * t96));
    float t102 = fma(light.elevation_sin, t95, light.elevation_cos * t96);
    float t103 = fma(light.third_axis.x, t101, fma(light.sideways.x, t97, light.up.x * t102));
    float t104 = fma(light.third_axis.y, t101, fma(light.sideways.y, t97, light.up.y * t102));
    float t105 = fma(light.third_axis.z, t101, fma(light.sideways.z, t97, light.up.z * t102));
    spherecap_sample sampled;
    sampled.direction = vec3(t98, t99, t100);
    sampled.distance = t92 * light.distance;
    sampled.normal = vec3(t103, t104, t105);
    sampled.cosine = cosine;
    sampled.pdf = t3 ? fma(t85, t7 * t84, t86) : t85 * t84;
    sampled.projected_pdf = t3 ? spherecap_min(t87, 3.4028235e38) : t85;
    return sampled;
}

spherecap_sample spherecap_both_sample_once(vec3 normal, vec3 centre, float radius, float defensive, float u0, float u1) {
    spherecap_both_light light = spherecap_both_prepare(normal, centre, radius, defensive);
    return spherecap_both_sample(light, u0, u1);
}

float spherecap_both_pdf_direction(spherecap_both_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = fma(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    float t2 = fma(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    float t3 = fma(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    float t4 = fma(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    float t5 = fma(light.sideways.x, direction.x, fma(light.sideways.y, direction.y, light.sideways.z * direction.z));
    float t6 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    bool t7 = fma(light.towards_centre.x, direction.x, t1) < 0.0;
    float t8 = t7 ? 1.0 : fma(t2, direction.x, fma(t3, direction.y, t4 * direction.z));
    float t9 = t7 ? 1.0 : t5;
    float t10 = spherecap_min(abs(t6), 3.4028235e38);
    float t11 = 0.0 < t6 ? light.inv_above * light.sides_share : t6 < 0.0 ? light.inv_below * (1.0 - light.sides_share) : 0.0;
    float t12 = fma(t11, (1.0 - light.defensive_share) * t10, light.defensive_share * light.inv_solid_angle);
    float t13 = fma(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.defensive_share ? t12 : t11 * t10) : 0.0;
    float t14 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t14 && t14 <= 1.002001) ? t13 : 0.0;
}

float spherecap_both_pdf_on_sphere(spherecap_both_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    float t2 = spherecap_min(abs(t1), 3.4028235e38);
    float t3 = 0.0 < t1 ? light.inv_above * light.sides_share : t1 < 0.0 ? light.inv_below * (1.0 - light.sides_share) : 0.0;
    float t4 = fma(t3, (1.0 - light.defensive_share) * t2, light.defensive_share * light.inv_solid_angle);
    float t5 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    float t6 = (0.998001 <= t5 && t5 <= 1.002001) ? (0.0 < light.defensive_share ? t4 : t3 * t2) : 0.0;
    return t6;
}

float spherecap_both_importance(vec3 normal, vec3 centre, float radius, float defensive, float strength) {
    float t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    float t2 = 0.0;
    float t3 = 0.0;
    float t4 = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        t2 = normal.x;
        t3 = normal.y;
        t4 = normal.z;
    } else {
        float t5 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        float t6 = spherecap_power_of_two(spherecap_min(t5, 8.5070587e37));
        float t7 = normal.x / t6;
        float t8 = normal.y / t6;
        float t9 = normal.z / t6;
        float t10 = spherecap_max(sqrt(fma(t7, t7, fma(t8, t8, t9 * t9))), 1.1754944e-38);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    float t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t12 = centre.x * scale;
    float t13 = centre.y * scale;
    float t14 = centre.z * scale;
    float t15 = radius * scale;
    float t16 = sqrt(fma(t12, t12, fma(t13, t13, t14 * t14)));
    float t17 = 1.0 / t16;
    float t18 = t15 * t17;
    float t19 = t18 * t18;
    float t20 = fma(t2, t2, fma(t3, t3, t4 * t4));
    bool t21 = 0.0 <= defensive && defensive <= 1.0 && t20 <= 2.0 && 0.0 < radius && t16 * unscale <= 3.4028235e38;
    float t22 = fma(t2, t12, fma(t3, t13, t4 * t14));
    float t23 = spherecap_max(fma(-t19, t19, 0.9999981), 0.0);
    float t24 = fma(t22, t17, 2.3841858e-7);
    float t25 = fma(t22 + t15, t17, 2.3841858e-7);
    float t26 = t18 <= t24 ? t24 : 0.0 < t25 ? t25 * t25 / (fma(t18 - t24, t23, t25) * 2.0) : 0.0;
    float t27 = fma(-t22, t17, 2.3841858e-7);
    float t28 = fma(-t22 + t15, t17, 2.3841858e-7);
    float t29 = t18 <= t27 ? t27 : 0.0 < t28 ? t28 * t28 / (fma(t18 - t27, t23, t28) * 2.0) : 0.0;
    float t30 = t26 + t29;
    float t31 = t20 <= 0.0 ? 1.0 : fma(defensive, 0.5 - t30, t30);
    bool t32 = t19 <= 1.0000019 && 4.9303807e-32 < t19 && t21 && 0.0 < strength && strength <= 3.4028235e38;
    float t33 = spherecap_min(spherecap_max(t19 * t31 * strength, 1.1754944e-38), 3.4028235e38);
    return (t32 && (0.0 < t31 || 0.0 < defensive)) ? t33 : 0.0;
}


#endif
