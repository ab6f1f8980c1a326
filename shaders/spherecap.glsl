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
    // `precise` reaches sums and products, not fma(): two of those in a row could be factored.
    precise float rest = fma(a_high, b_high, -product) + a_high * b_low;
    precise float lost = fma(a_low, b_high, rest) + a_low * b_low;
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
    return spherecap_sample(
        vec3(0.0, 0.0, 0.0), 0.0, vec3(0.0, 0.0, 0.0), 0.0, 0.0, 0.0
    );
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
    float b_0;
    float b_1;
    float b_2;
    float b_3;
    float b_4;
    float b_5;
    float b_6;
};

spherecap_surface_light spherecap_surface_prepare(vec3 normal, vec3 centre, float radius) {
    bool t1 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t2 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t2));
    float t3 = t1 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t4 = centre.x * t3;
    float t5 = centre.y * t3;
    float t6 = centre.z * t3;
    float t7 = radius * t3;
    precise float t8 = t6 * t6;
    float t9 = fma(t4, t4, fma(t5, t5, t8));
    float t10 = fma(-t7, t7, t9);
    float t11, t12;
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
    float t28, t29, t30, t31, t32;
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
        t31 = sqrt(t27);
        t28 = t22;
        t29 = t24;
        t30 = t26;
        t32 = t31;
    }
    precise float t43 = normal.x * t4;
    precise float t44 = normal.y * t5;
    precise float t45 = normal.z * t6;
    precise float t46 = t43 + t44;
    precise float t47 = t46 - t43;
    precise float t48 = t46 + t45;
    precise float t49 = t48 - t46;
    float t50 = spherecap_lost(normal.x, t4, t43) + spherecap_lost(normal.y, t5, t44) + spherecap_lost(normal.z, t6, t45);
    precise float t51 = t50 + (t43 - (t46 - t47) + (t44 - t47) + (t46 - (t48 - t49) + (t45 - t49)));
    precise float t52 = t48 + t51;
    precise float t53 = t51 - (t52 - t48);
    float t54 = t7 - t52 - t53;
    float t55 = t7 + t52 + t53;
    float t56 = t54 * t55;
    float t57 = sqrt(t12);
    bool t58 = 0.0 < t12;
    float t59;
    float t_x = 0.0, t_y = 0.0, width = 0.0, kappa = 0.0, cut = 0.0, shape = 0.0;
    float shape_difference = 0.0, norm = 0.0, tau = 0.0, area = 0.0;
    if (0.0 < t56 && t58) {
        t59 = sqrt(t12 + t56);
        float t60 = sqrt(t56);
        float t61 = 1.0 / (t59 * t7);
        float t62 = t61 * t7;
        float t63 = t61 * t59;
        t_x = t57 * t62;
        t_y = t60 * t62;
        float t64 = t_y * t_y;
        kappa = abs(t52) * t63;
        cut = kappa * t_x;
        float t65 = t_x - 0.5;
        float t66 = cut - 0.5;
        float t67 = t65 * t65;
        float t68 = t66 * t66;
        float t69 = fma(0.05430631, t67, 0.080950715);
        float t70 = fma(t69, t67, 0.1684019);
        float t71 = fma(t70, t67, 0.32709444);
        float t72 = fma(t71, t67, 0.5987523);
        float t73 = fma(-0.026061837, t67, -0.06372378);
        float t74 = fma(t73, t67, -0.11762552);
        float t75 = fma(t74, t67, -0.23594604);
        float t76 = fma(t75, t67, -0.44721135);
        float t77 = fma(t76, t67, -0.7754678);
        shape = fma(t77, t65, fma(t72, t67, 0.94559944));
        float t78 = fma(t66, fma(fma(fma(fma(-0.026061837, t68, t73), t68, t74), t68, t75), t68, t76), fma(fma(fma(fma(0.05430631, t68, t69), t68, t70), t68, t71), t68, t72));
        shape_difference = fma(t78, t65 + t66, t77);
        norm = fma(cut, shape_difference, shape);
        width = t64 / (1.0 + t_x);
        tau = t60 * t63;
        area = t64 * t_y * (min(t55, t54) * t63) * norm;
    } else {
        t59 = t32;
    }
    float t79 = sqrt(t11);
    float t80 = 1.0 / t79;
    float radius_sin = t7 * t80;
    float radius_cos = t57 * t80;
    float elevation_sin = t52 * t80;
    float elevation_cos = t59 * t80;
    float t81 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = max(-(radius_cos * t81), t56 * (t80 * t80) / fma(radius_cos, t81, climb));
    float t82 = radius_sin * radius_sin;
    bool t83 = 0.0 < elevation_sin;
    float t84 = t83 ? fma(t82 * t81, 3.1415927, area) : area;
    bool t85 = 9.8607613e-32 < t82;
    vec3 towards_centre = vec3(t4, t5, t6) * t80;
    float t86 = 1.0 / t31;
    vec3 sideways = vec3(t28, t29, t30) * t86;
    float distance = t79 * (t1 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t84 && t85 && t58) ? t84 : 0.0;
    bool t87 = 0.0 < tau;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    float t88 = t83 ? inv_above : 0.0;
    bool t89 = t87 && t83 && 0.0 < t88;
    float t90 = t_y * t_y * t_y * shape * t88;
    float t91 = t_y / radius_sin;
    float b_0 = 0.0, b_1 = 0.0, b_2 = 0.0, b_3 = 0.0, b_4 = 0.0, b_5 = 0.0, b_6 = 0.0;
    if (t87 && !t83) {
        float t92 = 1.0 + kappa;
        float t93 = t92 * shape;
        float t94 = 1.0 / (norm * t93);
        float t95 = sqrt(t94);
        b_0 = norm * t95;
        float t96 = 1.0 / (1.0 + cut);
        float t97 = (t_x + kappa) * t96 - 0.5;
        float t98 = t97 * t97;
        float t99 = fma(fma(fma(-0.026061837, t98, -0.06372378), t98, -0.11762552), t98, -0.23594604);
        float t100 = fma(fma(fma(0.05430631, t98, 0.080950715), t98, 0.1684019), t98, 0.32709444);
        float t101 = fma(fma(fma(t99, t98, -0.44721135), t98, -0.7754678), t97, fma(fma(t100, t98, 0.5987523), t98, 0.94559944));
        float t102 = t92 * t101 * (t96 * t96 * t96) * (t93 * t94);
        float t103 = fma(t102, t93 * t95, -1.0);
        float t104 = 1.0 - t102;
        float t105 = fma(fma(30.011856, t103, fma(-41.541264, t104, -37.009792)), t103, fma(77.96775, t104, 7.470758));
        float t106 = fma(fma(fma(15.716111 * t104, t104, 9.961183), t104, -2.61785), t104, 0.8681748);
        float t107 = fma(fma(t105, t103, fma(fma(-49.13454, t104, -9.466533), t104, -1.5877596)), t103, t106);
        float t108 = t103 * t107;
        float t109 = fma(fma(7.295638, t103, -7.236236), t103, fma(-11.4868555 * t104 * t104, t104, 3.1255686));
        float t110 = fma(fma(fma(13.728438, t104, -7.981878), t104, 2.025724), t104, -0.7334958);
        float t111 = t103 * fma(t109, t103, t110);
        float t112 = fma(fma(-23.220068, t104, 7.332055), t103, fma(fma(9.986537, t104, 25.22195) * t104, t104, -2.9581387));
        float t113 = fma(fma(fma(-19.722994, t104, 4.6594768), t104, -0.89538246), t104, 0.5143498);
        float t114 = t103 * fma(t112, t103, t113);
        float t115 = fma(fma(fma(1.946617, t103, -3.077631), t103, 1.4945927), t103, -0.24140751);
        float t116 = t103 * t115;
        float t117 = t103 * fma(fma(0.38173297, t103, -0.30305624), t103, 0.05897375);
        b_1 = t102 - b_0 + t108;
        b_2 = t111 - t108;
        b_3 = t114 - t111;
        b_4 = t116 - t114;
        b_5 = t117 - t116;
        b_6 = -t117;
    }
    bool t118 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    float t119 = t118 ? ((0.0 < radius_cos && t85) ? t82 / (1.0 + radius_cos) : 0.0) * 6.2831855 : 0.0;
    return spherecap_surface_light(
        t118, t119, t118 ? projected_above : 0.0, towards_centre, sideways, normal, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, inv_above,
        cross(sideways, normal), t89 ? t90 : 0.0, t89 ? 1.0 / (1.0 - t90) : 1.0,
        t89 ? t91 * t91 * t91 * fma(cut - t_x, shape_difference, shape) : 0.0, elevation_cos * radius_cos,
        radius_sin * t81, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    );
}

spherecap_sample spherecap_surface_sample(spherecap_surface_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    bool t2 = 0.0 < light.tau;
    bool t3 = !(0.0 < light.elevation_sin) && t2;
    float t4 = min(0.99999994, max(5.9604645e-8, u0));
    float t5 = min(0.99999994, max(5.9604645e-8, u1));
    bool t6 = light.crescent_share <= t4 && !t3;
    bool t7 = !t2 || t6;
    float t8 = 1.0 - t5;
    float t9 = t5 - t8;
    float t10 = 4.0 * t5 * t8;
    float t11 = min(0.99999994, max(5.9604645e-8, (t4 - light.crescent_share) * light.inv_rest));
    float t12 = t2 ? t11 : t4;
    float t13 = t2 ? light.beyond : 0.0;
    float t14 = 3.1415927 - t13;
    float t15 = fma(t12, t14, t13);
    float t16 = (1.0 - t12) * t14;
    float t18, t19, t20;
    float t17 = 0.0;
    if (t7) {
        t18 = min(t16, t15) * 0.53033006;
        t19 = 1.0;
        t20 = 1.0;
    } else {
        float t21 = sqrt(t10);
        float t22 = fma(fma(fma(light.b_5, t10, light.b_3), t10, light.b_1), t21, fma(fma(fma(light.b_6, t10, light.b_4), t10, light.b_2), t10, light.b_0));
        float t23 = t21 * t22;
        float t24 = sqrt(fma(t9, t9, t23 * t23));
        float t25 = light.tau * t23;
        t20 = t3 ? fma(t9, t9, t25 * t25) : 1.0;
        float t26 = t3 ? fma(light.kappa, t23, t24) * fma(light.cut, t23, t24) : light.crescent_share;
        float t27 = (t3 ? light.width : t4) / t26;
        float t28 = t3 ? t27 : light.width;
        float t29 = t20 * t28;
        float t30 = t29 * t29;
        float t31 = fma(fma(fma(-0.00060778117, t30, -0.0027203285), t30, -0.10000902), t29, fma(fma(1.0676054e-5, t30, -0.011332183), t30, 1.0000001));
        t17 = t3 ? t25 : t21;
        t18 = t3 ? t4 : min(0.99999994, max(5.9604645e-8, t27));
        t19 = t28 * t31;
    }
    float t32 = spherecap_float_of_bits(fma(spherecap_bits(t18), -0.33333334, 1419900500.0));
    float t33 = fma(-(t18 * t32), t32 * t32, 1.0);
    float t34 = t33 * t33;
    float t35 = fma(fma(fma(0.110958695, t34, 0.14403293), t34, 0.22222222), t33, fma(fma(0.12482853, t34, 0.17283951), t34, 0.33333334));
    float t36 = t19 * (t18 * fma(t32, t33 * t35, t32));
    float t37 = t36 * t20;
    float t38 = t37 * t37;
    float t39 = fma(fma(fma(-0.063446075, t38, -0.056249518), t38, 0.0074712755), t38, 0.09996679);
    float t40 = fma(fma(fma(0.022114987, t38, 0.085662976), t38, 0.030445365), t38, 0.03209764);
    float t41 = t36 * fma(t39, t37, fma(t40, t38, 1.0000004));
    float t42 = t7 ? min(1.0, t41) : t41;
    float t43 = t20 * t42;
    float t44 = 2.0 - t43;
    float t45 = t42 * t44;
    float t46 = sqrt(t45);
    float zenith, side, cosine, t47;
    if (t7) {
        float t48 = t15 - t16 < 0.0 ? t43 : t44;
        float t49 = t45 * t10;
        float t50 = 1.0 - t48;
        float t51 = max(0.0, fma(light.climb, t48, -light.rise));
        cosine = sqrt(fma(t51, t51, light.radius_sin * light.radius_sin * t49));
        float t52 = t1 * light.radius_cos;
        float t53 = fma(light.elevation_cos * t50, fma(light.climb, t50, -2.0 * t52), light.radius_sin * t49);
        zenith = light.radius_sin * fma(light.elevation_cos, t53 / (cosine + t52), -(t1 * t1 * t50));
        side = light.radius_sin * t46 * t9;
        t47 = fma(light.half_axis, t50, light.middle);
    } else {
        cosine = t46 * t17;
        t47 = 1.0 - t43;
        zenith = fma(light.elevation_cos, cosine, -((t3 ? -t1 : t1) * t47));
        side = t46 * t9;
    }
    float t54 = 0.0 < cosine ? light.inv_above : 0.0;
    float t55 = fma(zenith, zenith, side * side);
    float t56 = max(0.0, fma(light.radius_sin, light.radius_sin, -t55));
    float t57 = sqrt(t56);
    float t58 = sqrt(fma(light.radius_cos, light.radius_cos, t56));
    float t59 = light.radius_cos * light.radius_cos / (t58 + t57);
    float t60 = 1.0 / light.radius_sin;
    float t61 = t59 * t60;
    float t62 = -fma(t58, t57, t55) * t60;
    float t63 = t61 * zenith;
    float t64 = t61 * side;
    float t65 = fma(light.elevation_cos, t62, -(light.elevation_sin * t63));
    float t66 = fma(light.elevation_sin, t62, light.elevation_cos * t63);
    return spherecap_sample(
        light.third_axis * t47 + light.sideways * side + light.normal * cosine, t59 * light.distance,
        light.third_axis * t65 + light.sideways * t64 + light.normal * t66, cosine,
        t54 * min(3.4028235e38, abs(cosine)), t54
    );
}

spherecap_sample spherecap_surface_sample_once(vec3 normal, vec3 centre, float radius, float u0, float u1) {
    spherecap_surface_light light = spherecap_surface_prepare(normal, centre, radius);
    return spherecap_surface_sample(light, u0, u1);
}

float spherecap_surface_pdf_direction(spherecap_surface_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    bool t2 = dot(light.towards_centre, direction) < 0.0;
    float t3 = t2 ? 1.0 : dot(cross(light.towards_centre, light.sideways), direction);
    float t4 = t2 ? 1.0 : dot(light.sideways, direction);
    float t5 = fma(t3, t3, t4 * t4) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < t1 ? light.inv_above : 0.0) * min(3.4028235e38, abs(t1)) : 0.0;
    float t6 = dot(direction, direction);
    return (0.998001 <= t6 && t6 <= 1.002001) ? t5 : 0.0;
}

float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    float t2 = dot(direction, direction);
    float t3 = (0.998001 <= t2 && t2 <= 1.002001) ? (0.0 < t1 ? light.inv_above : 0.0) * min(3.4028235e38, abs(t1)) : 0.0;
    return t3;
}

float spherecap_surface_importance(vec3 normal, vec3 centre, float radius, float strength) {
    float t1 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t1));
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
    float t14 = t13 * t13 / (fma(t8 - t12, max(0.0, fma(-t9, t9, 0.9999981)), t13) * 2.0);
    float t15 = t8 <= t12 ? t12 : 0.0 < t13 ? t14 : 0.0;
    float t16 = fma(0.0, 0.5 - t15, t15);
    float t17 = (t9 <= 1.0000019 && 4.9303807e-32 < t9 && t10 && 0.0 < t16) ? min(3.4028235e38, max(1.1754944e-38, t9 * t16 * strength)) : 0.0;
    return t17;
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
    float share;
    float rest;
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
    float b_0;
    float b_1;
    float b_2;
    float b_3;
    float b_4;
    float b_5;
    float b_6;
};

spherecap_front_light spherecap_front_prepare(vec3 normal, vec3 centre, float radius, float defensive) {
    float normal_x, normal_y, normal_z;
    if (abs(dot(normal, normal) - 1.0) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        float t1 = min(8.5070587e37, max(1.1754944e-38, abs(normal.x) + abs(normal.y) + abs(normal.z)));
        float t2 = spherecap_power_of_two(t1);
        float t3 = normal.x / t2;
        float t4 = normal.y / t2;
        float t5 = normal.z / t2;
        float t6 = max(1.1754944e-38, sqrt(fma(t3, t3, fma(t4, t4, t5 * t5))));
        normal_x = t3 / t6;
        normal_y = t4 / t6;
        normal_z = t5 / t6;
    }
    float t7 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    bool t8 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t9 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t9));
    float t10 = t8 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t11 = centre.x * t10;
    float t12 = centre.y * t10;
    float t13 = centre.z * t10;
    float t14 = radius * t10;
    precise float t15 = t13 * t13;
    float t16 = fma(t11, t11, fma(t12, t12, t15));
    float t17 = fma(-t14, t14, t16);
    float t18, t19;
    if (t17 < t16 * 0.25) {
        precise float t20 = t11 * t11;
        precise float t21 = t12 * t12;
        precise float t22 = t20 + t21;
        precise float t23 = t22 - t20;
        precise float t24 = t22 + t15;
        precise float t25 = t24 - t22;
        float t26 = spherecap_lost(t11, t11, t20) + spherecap_lost(t12, t12, t21) + spherecap_lost(t13, t13, t15);
        precise float t27 = t26 + (t20 - (t22 - t23) + (t21 - t23) + (t22 - (t24 - t25) + (t15 - t25)));
        t18 = t24;
        t19 = spherecap_fused(-t14, t14, t24) + t27;
    } else {
        t18 = t16;
        t19 = t17;
    }
    bool t28 = 0.0 < t7;
    precise float t29 = normal_z * t12;
    float t30 = spherecap_fused(normal_y, t13, -t29);
    precise float t31 = normal_x * t13;
    float t32 = spherecap_fused(normal_z, t11, -t31);
    precise float t33 = normal_y * t11;
    float t34 = spherecap_fused(normal_x, t12, -t33);
    float t35 = fma(t30, t30, fma(t32, t32, t34 * t34));
    float up_x, up_y, up_z, t36, t37, t38, t39, t40;
    if (t35 < t18 * 0.015625) {
        float t41 = t30 - spherecap_lost(normal_z, t12, t29);
        float t42 = t32 - spherecap_lost(normal_x, t13, t31);
        float t43 = t34 - spherecap_lost(normal_y, t11, t33);
        float t44 = fma(t41, t41, fma(t42, t42, t43 * t43));
        bool t45 = t44 < t18 * 5.169879e-26;
        bool t46 = abs(t11) < abs(t13);
        float t47 = t46 ? 0.0 : -t12;
        float t48 = t46 ? -t13 : t11;
        float t49 = t46 ? t12 : 0.0;
        float t50 = sqrt(fma(t47, t47, fma(t48, t48, t49 * t49)));
        float t51 = sqrt(t18);
        float t52 = t51 * t50;
        float t53 = sqrt(t44);
        up_x = t45 ? (t28 ? normal_x : fma(t12, t49, -(t13 * t48)) / t52) : normal_x;
        up_y = t45 ? (t28 ? normal_y : fma(t13, t47, -(t11 * t49)) / t52) : normal_y;
        up_z = t45 ? (t28 ? normal_z : fma(t11, t48, -(t12 * t47)) / t52) : normal_z;
        t36 = t45 ? t47 : t41;
        t37 = t45 ? t48 : t42;
        t38 = t45 ? t49 : t43;
        t39 = t45 ? t50 : t53;
        t40 = t45 ? (t28 ? 0.0 : t51) : t53;
    } else {
        t39 = sqrt(t35);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t36 = t30;
        t37 = t32;
        t38 = t34;
        t40 = t39;
    }
    precise float t54 = normal_x * t11;
    precise float t55 = normal_y * t12;
    precise float t56 = normal_z * t13;
    precise float t57 = t54 + t55;
    precise float t58 = t57 - t54;
    precise float t59 = t57 + t56;
    precise float t60 = t59 - t57;
    float t61 = spherecap_lost(normal_x, t11, t54) + spherecap_lost(normal_y, t12, t55) + spherecap_lost(normal_z, t13, t56);
    precise float t62 = t61 + (t54 - (t57 - t58) + (t55 - t58) + (t57 - (t59 - t60) + (t56 - t60)));
    precise float t63 = t59 + t62;
    precise float t64 = t62 - (t63 - t59);
    float t65 = t14 - t63 - t64;
    float t66 = t14 + t63 + t64;
    float t67 = t65 * t66;
    float t68 = sqrt(t19);
    bool t69 = 0.0 < t19;
    float t70;
    float t_x = 0.0, t_y = 0.0, width = 0.0, kappa = 0.0, cut = 0.0, shape = 0.0;
    float shape_difference = 0.0, norm = 0.0, tau = 0.0, area = 0.0;
    if (0.0 < t67 && t28 && t69) {
        t70 = sqrt(t19 + t67);
        float t71 = sqrt(t67);
        float t72 = 1.0 / (t70 * t14);
        float t73 = t72 * t14;
        float t74 = t72 * t70;
        t_x = t68 * t73;
        t_y = t71 * t73;
        float t75 = t_y * t_y;
        kappa = abs(t63) * t74;
        cut = kappa * t_x;
        float t76 = t_x - 0.5;
        float t77 = cut - 0.5;
        float t78 = t76 * t76;
        float t79 = t77 * t77;
        float t80 = fma(0.05430631, t78, 0.080950715);
        float t81 = fma(t80, t78, 0.1684019);
        float t82 = fma(t81, t78, 0.32709444);
        float t83 = fma(t82, t78, 0.5987523);
        float t84 = fma(-0.026061837, t78, -0.06372378);
        float t85 = fma(t84, t78, -0.11762552);
        float t86 = fma(t85, t78, -0.23594604);
        float t87 = fma(t86, t78, -0.44721135);
        float t88 = fma(t87, t78, -0.7754678);
        shape = fma(t88, t76, fma(t83, t78, 0.94559944));
        float t89 = fma(t77, fma(fma(fma(fma(-0.026061837, t79, t84), t79, t85), t79, t86), t79, t87), fma(fma(fma(fma(0.05430631, t79, t80), t79, t81), t79, t82), t79, t83));
        shape_difference = fma(t89, t76 + t77, t88);
        norm = fma(cut, shape_difference, shape);
        width = t75 / (1.0 + t_x);
        tau = t71 * t74;
        area = t75 * t_y * (min(t66, t65) * t74) * norm;
    } else {
        t70 = t40;
    }
    float t90 = sqrt(t18);
    float t91 = 1.0 / t90;
    float radius_sin = t14 * t91;
    float radius_cos = t68 * t91;
    float elevation_sin = t63 * t91;
    float elevation_cos = t70 * t91;
    float t92 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = max(-(radius_cos * t92), t67 * (t91 * t91) / fma(radius_cos, t92, climb));
    float t93 = radius_sin * radius_sin;
    bool t94 = 0.0 < elevation_sin;
    float t95 = t94 ? fma(t93 * t92, 3.1415927, area) : area;
    bool t96 = 9.8607613e-32 < t93;
    vec3 towards_centre = vec3(t11, t12, t13) * t91;
    float t97 = 1.0 / t39;
    vec3 sideways = vec3(t36, t37, t38) * t97;
    float on_surface = t28 ? 1.0 : 0.0;
    float distance = t90 * (t8 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t95 && t96 && t69) ? t95 : 0.0;
    bool t98 = 0.0 < tau;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    bool t99 = 0.0 < inv_above;
    float t100 = t94 ? inv_above : 0.0;
    float share = t99 ? defensive : 0.0 < defensive || !(0.0 < on_surface) ? 1.0 : 0.0;
    bool t101 = t98 && t94 && 0.0 < t100;
    float t102 = t_y * t_y * t_y * shape * t100;
    float t103 = t_y / radius_sin;
    float beyond = t101 ? t103 * t103 * t103 * fma(cut - t_x, shape_difference, shape) : 0.0;
    float b_0 = 0.0, b_1 = 0.0, b_2 = 0.0, b_3 = 0.0, b_4 = 0.0, b_5 = 0.0, b_6 = 0.0;
    if (t98 && !t94) {
        float t104 = 1.0 + kappa;
        float t105 = t104 * shape;
        float t106 = 1.0 / (norm * t105);
        float t107 = sqrt(t106);
        b_0 = norm * t107;
        float t108 = 1.0 / (1.0 + cut);
        float t109 = (t_x + kappa) * t108 - 0.5;
        float t110 = t109 * t109;
        float t111 = fma(fma(fma(-0.026061837, t110, -0.06372378), t110, -0.11762552), t110, -0.23594604);
        float t112 = fma(fma(fma(0.05430631, t110, 0.080950715), t110, 0.1684019), t110, 0.32709444);
        float t113 = fma(fma(fma(t111, t110, -0.44721135), t110, -0.7754678), t109, fma(fma(t112, t110, 0.5987523), t110, 0.94559944));
        float t114 = t104 * t113 * (t108 * t108 * t108) * (t105 * t106);
        float t115 = fma(t114, t105 * t107, -1.0);
        float t116 = 1.0 - t114;
        float t117 = fma(fma(30.011856, t115, fma(-41.541264, t116, -37.009792)), t115, fma(77.96775, t116, 7.470758));
        float t118 = fma(fma(fma(15.716111 * t116, t116, 9.961183), t116, -2.61785), t116, 0.8681748);
        float t119 = fma(fma(t117, t115, fma(fma(-49.13454, t116, -9.466533), t116, -1.5877596)), t115, t118);
        float t120 = t115 * t119;
        float t121 = fma(fma(7.295638, t115, -7.236236), t115, fma(-11.4868555 * t116 * t116, t116, 3.1255686));
        float t122 = fma(fma(fma(13.728438, t116, -7.981878), t116, 2.025724), t116, -0.7334958);
        float t123 = t115 * fma(t121, t115, t122);
        float t124 = fma(fma(-23.220068, t116, 7.332055), t115, fma(fma(9.986537, t116, 25.22195) * t116, t116, -2.9581387));
        float t125 = fma(fma(fma(-19.722994, t116, 4.6594768), t116, -0.89538246), t116, 0.5143498);
        float t126 = t115 * fma(t124, t115, t125);
        float t127 = fma(fma(fma(1.946617, t115, -3.077631), t115, 1.4945927), t115, -0.24140751);
        float t128 = t115 * t127;
        float t129 = t115 * fma(fma(0.38173297, t115, -0.30305624), t115, 0.05897375);
        b_1 = t114 - b_0 + t120;
        b_2 = t123 - t120;
        b_3 = t126 - t123;
        b_4 = t128 - t126;
        b_5 = t129 - t128;
        b_6 = -t129;
    }
    bool t130 = 0.0 < share;
    float t131 = (0.0 < radius_cos && t96) ? t93 / (1.0 + radius_cos) : 0.0;
    float inv_solid_angle = t130 ? (0.0 < t131 ? 0.15915494 / t131 : 0.0) : 0.0;
    bool t132 = 0.0 < inv_solid_angle && t130;
    bool t133 = 0.0 <= defensive && defensive <= 1.0 && t7 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && (t99 || t132);
    return spherecap_front_light(
        t133, t133 ? t131 * 6.2831855 : 0.0, t133 ? projected_above : 0.0, towards_centre, sideways,
        vec3(normal_x, normal_y, normal_z), vec3(up_x, up_y, up_z), on_surface, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, share, 1.0 - share,
        defensive, inv_above,
        vec3(fma(sideways.y, up_z, -(sideways.z * up_y)), fma(sideways.z, up_x, -(sideways.x * up_z)), fma(sideways.x, up_y, -(sideways.y * up_x))),
        t130 ? t131 : 0.0, inv_solid_angle, t101 ? t102 : 0.0, t101 ? 1.0 / (1.0 - t102) : 1.0, beyond,
        elevation_cos * radius_cos, radius_sin * t92, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    );
}

spherecap_sample spherecap_front_sample(spherecap_front_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    bool t2 = 0.0 < light.share;
    float t3 = min(0.99999994, max(5.9604645e-8, u0));
    float t4 = min(0.99999994, max(5.9604645e-8, u1));
    bool t5 = t3 < light.share && t2;
    float t6 = max(5.9604645e-8, (t5 ? t3 : t3 - light.share) / (t5 ? light.share : light.rest));
    float t7 = 0.0 < light.requested ? min(0.99999994, t6) : t3;
    bool t8 = !(0.0 < light.tau) || t5;
    bool t9 = !(0.0 < light.elevation_sin) && !t8;
    bool t10 = light.crescent_share <= t7 && !t9;
    bool t11 = t8 || t10;
    float t12 = 1.0 - t4;
    float t13 = t4 - t12;
    float t14 = 4.0 * t4 * t12;
    float t15 = min(0.99999994, max(5.9604645e-8, (t7 - light.crescent_share) * light.inv_rest));
    float t16 = t8 ? t7 : t15;
    float t17 = t8 ? 0.0 : light.beyond;
    float t18 = 3.1415927 - t17;
    float t19 = fma(t16, t18, t17);
    float t20 = (1.0 - t16) * t18;
    float t22, t23, t24;
    float t21 = 0.0;
    if (t11) {
        t22 = min(t20, t19) * 0.53033006;
        t23 = 1.0;
        t24 = 1.0;
    } else {
        float t25 = sqrt(t14);
        float t26 = fma(fma(fma(light.b_5, t14, light.b_3), t14, light.b_1), t25, fma(fma(fma(light.b_6, t14, light.b_4), t14, light.b_2), t14, light.b_0));
        float t27 = t25 * t26;
        float t28 = sqrt(fma(t13, t13, t27 * t27));
        float t29 = light.tau * t27;
        t24 = t9 ? fma(t13, t13, t29 * t29) : 1.0;
        float t30 = t9 ? fma(light.kappa, t27, t28) * fma(light.cut, t27, t28) : light.crescent_share;
        float t31 = (t9 ? light.width : t7) / t30;
        float t32 = t9 ? t31 : light.width;
        float t33 = t24 * t32;
        float t34 = t33 * t33;
        float t35 = fma(fma(fma(-0.00060778117, t34, -0.0027203285), t34, -0.10000902), t33, fma(fma(1.0676054e-5, t34, -0.011332183), t34, 1.0000001));
        t21 = t9 ? t29 : t25;
        t22 = t9 ? t7 : min(0.99999994, max(5.9604645e-8, t31));
        t23 = t32 * t35;
    }
    float t36 = spherecap_float_of_bits(fma(spherecap_bits(t22), -0.33333334, 1419900500.0));
    float t37 = fma(-(t22 * t36), t36 * t36, 1.0);
    float t38 = t37 * t37;
    float t39 = fma(fma(fma(0.110958695, t38, 0.14403293), t38, 0.22222222), t37, fma(fma(0.12482853, t38, 0.17283951), t38, 0.33333334));
    float t40 = t23 * (t22 * fma(t36, t37 * t39, t36));
    float t41 = t40 * t24;
    float t42 = t41 * t41;
    float t43 = fma(fma(fma(-0.063446075, t42, -0.056249518), t42, 0.0074712755), t42, 0.09996679);
    float t44 = fma(fma(fma(0.022114987, t42, 0.085662976), t42, 0.030445365), t42, 0.03209764);
    float t45 = t40 * fma(t43, t41, fma(t44, t42, 1.0000004));
    float t46 = t11 ? min(1.0, t45) : t45;
    float t47 = t24 * t46;
    float t48 = 2.0 - t47;
    float t49 = t46 * t48;
    float t50 = sqrt(t49);
    float zenith, side, cosine, t51, t52;
    if (t11) {
        float t53 = t19 - t20 < 0.0 ? t47 : t48;
        float t54 = t49 * t14;
        if (t5) {
            float t55 = light.height * (1.0 - t54);
            float t56 = sqrt(light.height * (2.0 - t55));
            zenith = (t53 - 1.0) * t56;
            float t57 = 1.0 - t55;
            t52 = fma(light.elevation_sin, t57, light.elevation_cos * zenith);
            t51 = fma(light.elevation_cos, t57, -(light.elevation_sin * zenith));
            side = t50 * t13 * t56;
            cosine = t52 * light.on_surface;
        } else {
            float t58 = 1.0 - t53;
            float t59 = max(0.0, fma(light.climb, t53, -light.rise));
            t52 = sqrt(fma(t59, t59, light.radius_sin * light.radius_sin * t54));
            float t60 = t1 * light.radius_cos;
            float t61 = fma(light.elevation_cos * t58, fma(light.climb, t58, -2.0 * t60), light.radius_sin * t54);
            zenith = light.radius_sin * fma(light.elevation_cos, t61 / (t52 + t60), -(t1 * t1 * t58));
            t51 = fma(light.half_axis, t58, light.middle);
            side = light.radius_sin * t50 * t13;
            cosine = t52;
        }
    } else {
        cosine = t50 * t21;
        t51 = 1.0 - t47;
        zenith = fma(light.elevation_cos, cosine, -((t9 ? -t1 : t1) * t51));
        side = t50 * t13;
        t52 = cosine;
    }
    float t62 = min(3.4028235e38, abs(cosine));
    float t63 = 0.0 < cosine ? light.inv_above : 0.0;
    float t64 = light.share * light.inv_solid_angle;
    float t65 = min(3.4028235e38, fma(t63, light.rest, min(3.4028235e38, t64 / max(1.1754944e-38, t62))));
    float t66 = fma(zenith, zenith, side * side);
    float t67 = max(0.0, fma(light.radius_sin, light.radius_sin, -t66));
    float t68 = sqrt(t67);
    float t69 = sqrt(fma(light.radius_cos, light.radius_cos, t67));
    float t70 = light.radius_cos * light.radius_cos / (t69 + t68);
    float t71 = 1.0 / light.radius_sin;
    float t72 = t70 * t71;
    float t73 = -fma(t69, t68, t66) * t71;
    float t74 = t72 * zenith;
    float t75 = t72 * side;
    float t76 = fma(light.elevation_cos, t73, -(light.elevation_sin * t74));
    float t77 = fma(light.elevation_sin, t73, light.elevation_cos * t74);
    return spherecap_sample(
        light.third_axis * t51 + light.sideways * side + light.up * t52, t70 * light.distance,
        light.third_axis * t76 + light.sideways * t75 + light.up * t77, cosine,
        t2 ? fma(t63, light.rest * t62, t64) : t63 * t62, t2 ? t65 : t63
    );
}

spherecap_sample spherecap_front_sample_once(vec3 normal, vec3 centre, float radius, float defensive, float u0, float u1) {
    spherecap_front_light light = spherecap_front_prepare(normal, centre, radius, defensive);
    return spherecap_front_sample(light, u0, u1);
}

float spherecap_front_pdf_direction(spherecap_front_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    bool t2 = dot(light.towards_centre, direction) < 0.0;
    float t3 = t2 ? 1.0 : dot(cross(light.towards_centre, light.sideways), direction);
    float t4 = t2 ? 1.0 : dot(light.sideways, direction);
    float t5 = min(3.4028235e38, abs(t1));
    float t6 = 0.0 < t1 ? light.inv_above : 0.0;
    float t7 = 0.0 < light.share ? fma(t6, light.rest * t5, light.share * light.inv_solid_angle) : t6 * t5;
    float t8 = fma(t3, t3, t4 * t4) <= light.radius_sin * light.radius_sin * 1.0000019 ? t7 : 0.0;
    float t9 = dot(direction, direction);
    return (0.998001 <= t9 && t9 <= 1.002001) ? t8 : 0.0;
}

float spherecap_front_pdf_on_sphere(spherecap_front_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    float t2 = min(3.4028235e38, abs(t1));
    float t3 = 0.0 < t1 ? light.inv_above : 0.0;
    float t4 = 0.0 < light.share ? fma(t3, light.rest * t2, light.share * light.inv_solid_angle) : t3 * t2;
    float t5 = dot(direction, direction);
    return (0.998001 <= t5 && t5 <= 1.002001) ? t4 : 0.0;
}

float spherecap_front_importance(vec3 normal, vec3 centre, float radius, float defensive, float strength) {
    float t1, t2, t3;
    if (abs(dot(normal, normal) - 1.0) <= 4.7683716e-7) {
        t1 = normal.x;
        t2 = normal.y;
        t3 = normal.z;
    } else {
        float t4 = min(8.5070587e37, max(1.1754944e-38, abs(normal.x) + abs(normal.y) + abs(normal.z)));
        float t5 = spherecap_power_of_two(t4);
        float t6 = normal.x / t5;
        float t7 = normal.y / t5;
        float t8 = normal.z / t5;
        float t9 = max(1.1754944e-38, sqrt(fma(t6, t6, fma(t7, t7, t8 * t8))));
        t1 = t6 / t9;
        t2 = t7 / t9;
        t3 = t8 / t9;
    }
    float t10 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t10));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t11 = centre.x * scale;
    float t12 = centre.y * scale;
    float t13 = centre.z * scale;
    float t14 = radius * scale;
    float t15 = sqrt(fma(t11, t11, fma(t12, t12, t13 * t13)));
    float t16 = 1.0 / t15;
    float t17 = t14 * t16;
    float t18 = t17 * t17;
    float t19 = fma(t1, t1, fma(t2, t2, t3 * t3));
    bool t20 = 0.0 <= defensive && defensive <= 1.0 && t19 <= 2.0 && 0.0 < radius && t15 * unscale <= 3.4028235e38;
    float t21 = fma(t1, t11, fma(t2, t12, t3 * t13));
    float t22 = fma(t21, t16, 2.3841858e-7);
    float t23 = fma(t21 + t14, t16, 2.3841858e-7);
    float t24 = t23 * t23 / (fma(t17 - t22, max(0.0, fma(-t18, t18, 0.9999981)), t23) * 2.0);
    float t25 = t17 <= t22 ? t22 : 0.0 < t23 ? t24 : 0.0;
    float t26 = t19 <= 0.0 ? 1.0 : fma(defensive, 0.5 - t25, t25);
    bool t27 = t18 <= 1.0000019 && 4.9303807e-32 < t18 && 0.0 < strength && t20 && strength <= 3.4028235e38;
    float t28 = ((0.0 < t26 || 0.0 < defensive) && t27) ? min(3.4028235e38, max(1.1754944e-38, t18 * t26 * strength)) : 0.0;
    return t28;
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
    float defensive_rest;
    float requested;
    float inv_above;
    float inv_below;
    float sides_share;
    float sides_rest;
    vec3 third_axis;
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

spherecap_both_light spherecap_both_prepare(vec3 normal, vec3 centre, float radius, float defensive) {
    float normal_x, normal_y, normal_z;
    if (abs(dot(normal, normal) - 1.0) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        float t1 = min(8.5070587e37, max(1.1754944e-38, abs(normal.x) + abs(normal.y) + abs(normal.z)));
        float t2 = spherecap_power_of_two(t1);
        float t3 = normal.x / t2;
        float t4 = normal.y / t2;
        float t5 = normal.z / t2;
        float t6 = max(1.1754944e-38, sqrt(fma(t3, t3, fma(t4, t4, t5 * t5))));
        normal_x = t3 / t6;
        normal_y = t4 / t6;
        normal_z = t5 / t6;
    }
    float t7 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    bool t8 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t9 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t9));
    float t10 = t8 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t11 = centre.x * t10;
    float t12 = centre.y * t10;
    float t13 = centre.z * t10;
    float t14 = radius * t10;
    precise float t15 = t13 * t13;
    float t16 = fma(t11, t11, fma(t12, t12, t15));
    float t17 = fma(-t14, t14, t16);
    float t18, t19;
    if (t17 < t16 * 0.25) {
        precise float t20 = t11 * t11;
        precise float t21 = t12 * t12;
        precise float t22 = t20 + t21;
        precise float t23 = t22 - t20;
        precise float t24 = t22 + t15;
        precise float t25 = t24 - t22;
        float t26 = spherecap_lost(t11, t11, t20) + spherecap_lost(t12, t12, t21) + spherecap_lost(t13, t13, t15);
        precise float t27 = t26 + (t20 - (t22 - t23) + (t21 - t23) + (t22 - (t24 - t25) + (t15 - t25)));
        t18 = t24;
        t19 = spherecap_fused(-t14, t14, t24) + t27;
    } else {
        t18 = t16;
        t19 = t17;
    }
    bool t28 = 0.0 < t7;
    precise float t29 = normal_z * t12;
    float t30 = spherecap_fused(normal_y, t13, -t29);
    precise float t31 = normal_x * t13;
    float t32 = spherecap_fused(normal_z, t11, -t31);
    precise float t33 = normal_y * t11;
    float t34 = spherecap_fused(normal_x, t12, -t33);
    float t35 = fma(t30, t30, fma(t32, t32, t34 * t34));
    float up_x, up_y, up_z, t36, t37, t38, t39, t40;
    if (t35 < t18 * 0.015625) {
        float t41 = t30 - spherecap_lost(normal_z, t12, t29);
        float t42 = t32 - spherecap_lost(normal_x, t13, t31);
        float t43 = t34 - spherecap_lost(normal_y, t11, t33);
        float t44 = fma(t41, t41, fma(t42, t42, t43 * t43));
        bool t45 = t44 < t18 * 5.169879e-26;
        bool t46 = abs(t11) < abs(t13);
        float t47 = t46 ? 0.0 : -t12;
        float t48 = t46 ? -t13 : t11;
        float t49 = t46 ? t12 : 0.0;
        float t50 = sqrt(fma(t47, t47, fma(t48, t48, t49 * t49)));
        float t51 = sqrt(t18);
        float t52 = t51 * t50;
        float t53 = sqrt(t44);
        up_x = t45 ? (t28 ? normal_x : fma(t12, t49, -(t13 * t48)) / t52) : normal_x;
        up_y = t45 ? (t28 ? normal_y : fma(t13, t47, -(t11 * t49)) / t52) : normal_y;
        up_z = t45 ? (t28 ? normal_z : fma(t11, t48, -(t12 * t47)) / t52) : normal_z;
        t36 = t45 ? t47 : t41;
        t37 = t45 ? t48 : t42;
        t38 = t45 ? t49 : t43;
        t39 = t45 ? t50 : t53;
        t40 = t45 ? (t28 ? 0.0 : t51) : t53;
    } else {
        t39 = sqrt(t35);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t36 = t30;
        t37 = t32;
        t38 = t34;
        t40 = t39;
    }
    precise float t54 = normal_x * t11;
    precise float t55 = normal_y * t12;
    precise float t56 = normal_z * t13;
    precise float t57 = t54 + t55;
    precise float t58 = t57 - t54;
    precise float t59 = t57 + t56;
    precise float t60 = t59 - t57;
    float t61 = spherecap_lost(normal_x, t11, t54) + spherecap_lost(normal_y, t12, t55) + spherecap_lost(normal_z, t13, t56);
    precise float t62 = t61 + (t54 - (t57 - t58) + (t55 - t58) + (t57 - (t59 - t60) + (t56 - t60)));
    precise float t63 = t59 + t62;
    precise float t64 = t62 - (t63 - t59);
    float t65 = t14 - t63 - t64;
    float t66 = t14 + t63 + t64;
    float t67 = t65 * t66;
    float t68 = sqrt(t19);
    bool t69 = 0.0 < t19;
    float t70;
    float t_x = 0.0, t_y = 0.0, width = 0.0, kappa = 0.0, cut = 0.0, shape = 0.0;
    float shape_difference = 0.0, norm = 0.0, tau = 0.0, area = 0.0;
    if (0.0 < t67 && t28 && t69) {
        t70 = sqrt(t19 + t67);
        float t71 = sqrt(t67);
        float t72 = 1.0 / (t70 * t14);
        float t73 = t72 * t14;
        float t74 = t72 * t70;
        t_x = t68 * t73;
        t_y = t71 * t73;
        float t75 = t_y * t_y;
        kappa = abs(t63) * t74;
        cut = kappa * t_x;
        float t76 = t_x - 0.5;
        float t77 = cut - 0.5;
        float t78 = t76 * t76;
        float t79 = t77 * t77;
        float t80 = fma(0.05430631, t78, 0.080950715);
        float t81 = fma(t80, t78, 0.1684019);
        float t82 = fma(t81, t78, 0.32709444);
        float t83 = fma(t82, t78, 0.5987523);
        float t84 = fma(-0.026061837, t78, -0.06372378);
        float t85 = fma(t84, t78, -0.11762552);
        float t86 = fma(t85, t78, -0.23594604);
        float t87 = fma(t86, t78, -0.44721135);
        float t88 = fma(t87, t78, -0.7754678);
        shape = fma(t88, t76, fma(t83, t78, 0.94559944));
        float t89 = fma(t77, fma(fma(fma(fma(-0.026061837, t79, t84), t79, t85), t79, t86), t79, t87), fma(fma(fma(fma(0.05430631, t79, t80), t79, t81), t79, t82), t79, t83));
        shape_difference = fma(t89, t76 + t77, t88);
        norm = fma(cut, shape_difference, shape);
        width = t75 / (1.0 + t_x);
        tau = t71 * t74;
        area = t75 * t_y * (min(t66, t65) * t74) * norm;
    } else {
        t70 = t40;
    }
    float t90 = sqrt(t18);
    float t91 = 1.0 / t90;
    float radius_sin = t14 * t91;
    float radius_cos = t68 * t91;
    float elevation_sin = t63 * t91;
    float elevation_cos = t70 * t91;
    float t92 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = max(-(radius_cos * t92), t67 * (t91 * t91) / fma(radius_cos, t92, climb));
    float t93 = radius_sin * radius_sin;
    float t94 = fma(t93 * t92, 3.1415927, area);
    bool t95 = 0.0 < elevation_sin;
    float t96 = t95 ? t94 : area;
    float t97 = t95 ? area : t94;
    bool t98 = 9.8607613e-32 < t93;
    bool t99 = t98 && t69;
    vec3 towards_centre = vec3(t11, t12, t13) * t91;
    float t100 = 1.0 / t39;
    vec3 sideways = vec3(t36, t37, t38) * t100;
    float on_surface = t28 ? 1.0 : 0.0;
    float distance = t90 * (t8 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t96 && t99) ? t96 : 0.0;
    float projected_below = (9.403955e-38 < t97 && t99) ? t97 : 0.0;
    bool t101 = 0.0 < tau;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    float inv_below = 0.0 < projected_below ? 1.0 / projected_below : 0.0;
    bool t102 = 0.0 < inv_above + inv_below;
    float t103 = t95 ? inv_above : inv_below;
    float defensive_share = t102 ? defensive : 0.0 < defensive || !(0.0 < on_surface) ? 1.0 : 0.0;
    bool t104 = 0.0 < t103 && t101;
    float t105 = t_y * t_y * t_y * shape * t103;
    float t106 = t_y / radius_sin;
    float t107 = fma(cut - t_x, shape_difference, shape);
    float b_0 = 0.0, b_1 = 0.0, b_2 = 0.0, b_3 = 0.0, b_4 = 0.0, b_5 = 0.0, b_6 = 0.0, t108 = 0.0;
    if (t101) {
        float t109 = 1.0 + kappa;
        float t110 = t109 * shape;
        float t111 = 1.0 / (norm * t110);
        float t112 = sqrt(t111);
        b_0 = norm * t112;
        float t113 = 1.0 / (1.0 + cut);
        float t114 = (t_x + kappa) * t113 - 0.5;
        float t115 = t114 * t114;
        float t116 = fma(fma(fma(-0.026061837, t115, -0.06372378), t115, -0.11762552), t115, -0.23594604);
        float t117 = fma(fma(fma(0.05430631, t115, 0.080950715), t115, 0.1684019), t115, 0.32709444);
        float t118 = fma(fma(fma(t116, t115, -0.44721135), t115, -0.7754678), t114, fma(fma(t117, t115, 0.5987523), t115, 0.94559944));
        float t119 = t109 * t118 * (t113 * t113 * t113) * (t110 * t111);
        float t120 = fma(t119, t110 * t112, -1.0);
        float t121 = 1.0 - t119;
        float t122 = fma(fma(30.011856, t120, fma(-41.541264, t121, -37.009792)), t120, fma(77.96775, t121, 7.470758));
        float t123 = fma(fma(fma(15.716111 * t121, t121, 9.961183), t121, -2.61785), t121, 0.8681748);
        float t124 = fma(fma(t122, t120, fma(fma(-49.13454, t121, -9.466533), t121, -1.5877596)), t120, t123);
        float t125 = t120 * t124;
        float t126 = fma(fma(7.295638, t120, -7.236236), t120, fma(-11.4868555 * t121 * t121, t121, 3.1255686));
        float t127 = fma(fma(fma(13.728438, t121, -7.981878), t121, 2.025724), t121, -0.7334958);
        float t128 = t120 * fma(t126, t120, t127);
        float t129 = fma(fma(-23.220068, t121, 7.332055), t120, fma(fma(9.986537, t121, 25.22195) * t121, t121, -2.9581387));
        float t130 = fma(fma(fma(-19.722994, t121, 4.6594768), t121, -0.89538246), t121, 0.5143498);
        float t131 = t120 * fma(t129, t120, t130);
        float t132 = fma(fma(fma(1.946617, t120, -3.077631), t120, 1.4945927), t120, -0.24140751);
        float t133 = t120 * t132;
        float t134 = t120 * fma(fma(0.38173297, t120, -0.30305624), t120, 0.05897375);
        float t135 = 1.0 / (elevation_cos * elevation_cos);
        float t136 = tau * tau;
        float t137 = t136 * t135 / (1.0 + t_x);
        float t138 = kappa - 0.5;
        float t139 = cut - 0.5;
        float t140 = t138 * t138;
        float t141 = t139 * t139;
        float t142 = fma(0.05430631, t140, 0.080950715);
        float t143 = fma(t142, t140, 0.1684019);
        float t144 = fma(t143, t140, 0.32709444);
        float t145 = fma(fma(fma(fma(0.05430631, t141, t142), t141, t143), t141, t144), t141, fma(t144, t140, 0.5987523));
        float t146 = fma(-0.026061837, t140, -0.06372378);
        float t147 = fma(t146, t140, -0.11762552);
        float t148 = fma(t147, t140, -0.23594604);
        float t149 = fma(t148, t140, -0.44721135);
        float t150 = fma(fma(fma(fma(-0.026061837, t141, t146), t141, t147), t141, t148), t141, t149);
        float t151 = fma(kappa * t137, fma(fma(t139, t150, t145), t138 + t139, fma(t149, t140, -0.7754678)), fma(t107, t137 - kappa * kappa, kappa) * t135);
        b_1 = t119 - b_0 + t125;
        b_2 = t128 - t125;
        b_3 = t131 - t128;
        b_4 = t133 - t131;
        b_5 = t134 - t133;
        b_6 = -t134;
        t108 = min(0.5, max(0.0, t136 * tau * (radius_cos + 1.0) * t151 * 0.31830987));
    }
    bool t152 = 0.0 < defensive_share;
    float t153 = (0.0 < radius_cos && t98) ? t93 / (1.0 + radius_cos) : 0.0;
    float inv_solid_angle = t152 ? (0.0 < t153 ? 0.15915494 / t153 : 0.0) : 0.0;
    float t154 = 1.0 - t108;
    bool t155 = 0.0 < inv_below;
    bool t156 = 0.0 < inv_above;
    bool t157 = 0.0 < inv_solid_angle && t152;
    bool t158 = 0.0 <= defensive && defensive <= 1.0 && t7 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && (t102 || t157);
    return spherecap_both_light(
        t158, t158 ? t153 * 6.2831855 : 0.0, t158 ? projected_above : 0.0, towards_centre, sideways,
        vec3(normal_x, normal_y, normal_z), vec3(up_x, up_y, up_z), on_surface, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, defensive_share,
        1.0 - defensive_share, defensive, inv_above, inv_below,
        t155 ? (t156 ? (t95 ? t154 : t108) : 0.0) : 1.0, t156 ? (t155 ? (t95 ? t108 : t154) : 0.0) : 1.0,
        vec3(fma(sideways.y, up_z, -(sideways.z * up_y)), fma(sideways.z, up_x, -(sideways.x * up_z)), fma(sideways.x, up_y, -(sideways.y * up_x))),
        t152 ? t153 : 0.0, inv_solid_angle, t104 ? t105 : 0.0, t104 ? 1.0 / (1.0 - t105) : 1.0,
        t104 ? t106 * t106 * t106 * t107 : 0.0, elevation_cos * radius_cos, radius_sin * t92, climb, b_0,
        b_1, b_2, b_3, b_4, b_5, b_6
    );
}

spherecap_sample spherecap_both_sample(spherecap_both_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    bool t2 = 0.0 < light.elevation_sin;
    bool t3 = 0.0 < light.defensive_share;
    float t4 = min(0.99999994, max(5.9604645e-8, u0));
    float t5 = min(0.99999994, max(5.9604645e-8, u1));
    bool t6 = t4 < light.defensive_share && t3;
    float t7 = (t6 ? t4 : t4 - light.defensive_share) / (t6 ? light.defensive_share : light.defensive_rest);
    float t8 = 0.0 < light.requested ? min(0.99999994, max(5.9604645e-8, t7)) : t4;
    bool t9 = t8 < light.sides_share || t6;
    float t10 = (t9 ? t8 : t8 - light.sides_share) / (t9 ? light.sides_share : light.sides_rest);
    bool t11 = t9 && t2;
    bool t12 = !t9 && !t2;
    float t13 = t6 ? t8 : min(0.99999994, max(5.9604645e-8, t10));
    bool t14 = !(0.0 < light.tau) || t6;
    bool t15 = !(t11 || t12) && !t14;
    bool t16 = light.crescent_share <= t13 && !t15;
    bool t17 = t14 || t16;
    float t18 = 1.0 - t5;
    float t19 = t5 - t18;
    float t20 = 4.0 * t5 * t18;
    float t21 = min(0.99999994, max(5.9604645e-8, (t13 - light.crescent_share) * light.inv_rest));
    float t22 = t14 ? t13 : t21;
    float t23 = t14 ? 0.0 : light.beyond;
    float t24 = 3.1415927 - t23;
    float t25 = fma(t22, t24, t23);
    float t26 = (1.0 - t22) * t24;
    float t28, t29, t30;
    float t27 = 0.0;
    if (t17) {
        t28 = min(t26, t25) * 0.53033006;
        t29 = 1.0;
        t30 = 1.0;
    } else {
        float t31 = sqrt(t20);
        float t32 = fma(fma(fma(light.b_5, t20, light.b_3), t20, light.b_1), t31, fma(fma(fma(light.b_6, t20, light.b_4), t20, light.b_2), t20, light.b_0));
        float t33 = t31 * t32;
        float t34 = sqrt(fma(t19, t19, t33 * t33));
        float t35 = light.tau * t33;
        t30 = t15 ? fma(t19, t19, t35 * t35) : 1.0;
        float t36 = t15 ? fma(light.kappa, t33, t34) * fma(light.cut, t33, t34) : light.crescent_share;
        float t37 = (t15 ? light.width : t13) / t36;
        float t38 = t15 ? t37 : light.width;
        float t39 = t30 * t38;
        float t40 = t39 * t39;
        float t41 = fma(fma(fma(-0.00060778117, t40, -0.0027203285), t40, -0.10000902), t39, fma(fma(1.0676054e-5, t40, -0.011332183), t40, 1.0000001));
        t27 = t15 ? t35 : t31;
        t28 = t15 ? t13 : min(0.99999994, max(5.9604645e-8, t37));
        t29 = t38 * t41;
    }
    float t42 = spherecap_float_of_bits(fma(spherecap_bits(t28), -0.33333334, 1419900500.0));
    float t43 = fma(-(t28 * t42), t42 * t42, 1.0);
    float t44 = t43 * t43;
    float t45 = fma(fma(fma(0.110958695, t44, 0.14403293), t44, 0.22222222), t43, fma(fma(0.12482853, t44, 0.17283951), t44, 0.33333334));
    float t46 = t29 * (t28 * fma(t42, t43 * t45, t42));
    float t47 = t46 * t30;
    float t48 = t47 * t47;
    float t49 = fma(fma(fma(-0.063446075, t48, -0.056249518), t48, 0.0074712755), t48, 0.09996679);
    float t50 = fma(fma(fma(0.022114987, t48, 0.085662976), t48, 0.030445365), t48, 0.03209764);
    float t51 = t46 * fma(t49, t47, fma(t50, t48, 1.0000004));
    float t52 = t17 ? min(1.0, t51) : t51;
    float t53 = t30 * t52;
    float t54 = 2.0 - t53;
    float t55 = t52 * t54;
    float t56 = sqrt(t55);
    float side, t57, t58, t59, t60;
    if (t17) {
        float t61 = t25 - t26 < 0.0 ? t53 : t54;
        float t62 = t55 * t20;
        if (t6) {
            float t63 = light.height * (1.0 - t62);
            float t64 = sqrt(light.height * (2.0 - t63));
            t59 = (t61 - 1.0) * t64;
            float t65 = 1.0 - t63;
            t58 = fma(light.elevation_sin, t65, light.elevation_cos * t59);
            t57 = fma(light.elevation_cos, t65, -(light.elevation_sin * t59));
            side = t56 * t19 * t64;
            t60 = t58 * light.on_surface;
        } else {
            float t66 = 1.0 - t61;
            float t67 = max(0.0, fma(light.climb, t61, -light.rise));
            t58 = sqrt(fma(t67, t67, light.radius_sin * light.radius_sin * t62));
            float t68 = t1 * light.radius_cos;
            float t69 = fma(light.elevation_cos * t66, fma(light.climb, t66, -2.0 * t68), light.radius_sin * t62);
            t59 = light.radius_sin * fma(light.elevation_cos, t69 / (t58 + t68), -(t1 * t1 * t66));
            t57 = fma(light.half_axis, t66, light.middle);
            side = light.radius_sin * t56 * t19;
            t60 = t58;
        }
    } else {
        t58 = t56 * t27;
        t57 = 1.0 - t53;
        side = t56 * t19;
        t59 = fma(light.elevation_cos, t58, -((t15 ? -t1 : t1) * t57));
        t60 = t58;
    }
    float t70 = t9 ? 1.0 : -1.0;
    float zenith = t59 * t70;
    float cosine = t60 * t70;
    float t71 = t58 * t70;
    float t72 = min(3.4028235e38, abs(cosine));
    float t73 = 0.0 < cosine ? light.inv_above * light.sides_share : cosine < 0.0 ? light.inv_below * light.sides_rest : 0.0;
    float t74 = light.defensive_share * light.inv_solid_angle;
    float t75 = fma(t73, light.defensive_rest, min(3.4028235e38, t74 / max(1.1754944e-38, t72)));
    float t76 = fma(zenith, zenith, side * side);
    float t77 = max(0.0, fma(light.radius_sin, light.radius_sin, -t76));
    float t78 = sqrt(t77);
    float t79 = sqrt(fma(light.radius_cos, light.radius_cos, t77));
    float t80 = light.radius_cos * light.radius_cos / (t79 + t78);
    float t81 = 1.0 / light.radius_sin;
    float t82 = t80 * t81;
    float t83 = -fma(t79, t78, t76) * t81;
    float t84 = t82 * zenith;
    float t85 = t82 * side;
    float t86 = fma(light.elevation_cos, t83, -(light.elevation_sin * t84));
    float t87 = fma(light.elevation_sin, t83, light.elevation_cos * t84);
    return spherecap_sample(
        light.third_axis * t57 + light.sideways * side + light.up * t71, t80 * light.distance,
        light.third_axis * t86 + light.sideways * t85 + light.up * t87, cosine,
        t3 ? fma(t73, light.defensive_rest * t72, t74) : t73 * t72, t3 ? min(3.4028235e38, t75) : t73
    );
}

spherecap_sample spherecap_both_sample_once(vec3 normal, vec3 centre, float radius, float defensive, float u0, float u1) {
    spherecap_both_light light = spherecap_both_prepare(normal, centre, radius, defensive);
    return spherecap_both_sample(light, u0, u1);
}

float spherecap_both_pdf_direction(spherecap_both_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    bool t2 = dot(light.towards_centre, direction) < 0.0;
    float t3 = t2 ? 1.0 : dot(cross(light.towards_centre, light.sideways), direction);
    float t4 = t2 ? 1.0 : dot(light.sideways, direction);
    float t5 = min(3.4028235e38, abs(t1));
    float t6 = 0.0 < t1 ? light.inv_above * light.sides_share : t1 < 0.0 ? light.inv_below * light.sides_rest : 0.0;
    float t7 = fma(t6, light.defensive_rest * t5, light.defensive_share * light.inv_solid_angle);
    float t8 = fma(t3, t3, t4 * t4) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.defensive_share ? t7 : t6 * t5) : 0.0;
    float t9 = dot(direction, direction);
    return (0.998001 <= t9 && t9 <= 1.002001) ? t8 : 0.0;
}

float spherecap_both_pdf_on_sphere(spherecap_both_light light, vec3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    float t2 = min(3.4028235e38, abs(t1));
    float t3 = 0.0 < t1 ? light.inv_above * light.sides_share : t1 < 0.0 ? light.inv_below * light.sides_rest : 0.0;
    float t4 = fma(t3, light.defensive_rest * t2, light.defensive_share * light.inv_solid_angle);
    float t5 = dot(direction, direction);
    float t6 = (0.998001 <= t5 && t5 <= 1.002001) ? (0.0 < light.defensive_share ? t4 : t3 * t2) : 0.0;
    return t6;
}

float spherecap_both_importance(vec3 normal, vec3 centre, float radius, float defensive, float strength) {
    float t1, t2, t3;
    if (abs(dot(normal, normal) - 1.0) <= 4.7683716e-7) {
        t1 = normal.x;
        t2 = normal.y;
        t3 = normal.z;
    } else {
        float t4 = min(8.5070587e37, max(1.1754944e-38, abs(normal.x) + abs(normal.y) + abs(normal.z)));
        float t5 = spherecap_power_of_two(t4);
        float t6 = normal.x / t5;
        float t7 = normal.y / t5;
        float t8 = normal.z / t5;
        float t9 = max(1.1754944e-38, sqrt(fma(t6, t6, fma(t7, t7, t8 * t8))));
        t1 = t6 / t9;
        t2 = t7 / t9;
        t3 = t8 / t9;
    }
    float t10 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t10));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t11 = centre.x * scale;
    float t12 = centre.y * scale;
    float t13 = centre.z * scale;
    float t14 = radius * scale;
    float t15 = sqrt(fma(t11, t11, fma(t12, t12, t13 * t13)));
    float t16 = 1.0 / t15;
    float t17 = t14 * t16;
    float t18 = t17 * t17;
    float t19 = fma(t1, t1, fma(t2, t2, t3 * t3));
    bool t20 = 0.0 <= defensive && defensive <= 1.0 && t19 <= 2.0 && 0.0 < radius && t15 * unscale <= 3.4028235e38;
    float t21 = fma(t1, t11, fma(t2, t12, t3 * t13));
    float t22 = max(0.0, fma(-t18, t18, 0.9999981));
    float t23 = fma(t21, t16, 2.3841858e-7);
    float t24 = fma(t21 + t14, t16, 2.3841858e-7);
    float t25 = t17 <= t23 ? t23 : 0.0 < t24 ? t24 * t24 / (fma(t17 - t23, t22, t24) * 2.0) : 0.0;
    float t26 = fma(-t21, t16, 2.3841858e-7);
    float t27 = fma(-t21 + t14, t16, 2.3841858e-7);
    float t28 = t17 <= t26 ? t26 : 0.0 < t27 ? t27 * t27 / (fma(t17 - t26, t22, t27) * 2.0) : 0.0;
    float t29 = t25 + t28;
    float t30 = t19 <= 0.0 ? 1.0 : fma(defensive, 0.5 - t29, t29);
    bool t31 = t18 <= 1.0000019 && 4.9303807e-32 < t18 && 0.0 < strength && t20 && strength <= 3.4028235e38;
    float t32 = ((0.0 < t30 || 0.0 < defensive) && t31) ? min(3.4028235e38, max(1.1754944e-38, t18 * t30 * strength)) : 0.0;
    return t32;
}


#endif
