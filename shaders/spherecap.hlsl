#ifndef SPHERECAP_HLSL
#define SPHERECAP_HLSL

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
// Shader model 5.0 or later. Define SPHERECAP_FUSED_FMA where mad() rounds once, as on all desktop GPUs: fewer instructions.

// What rounding took off the product a b.
float spherecap_lost(float a, float b, float product) {
#ifdef SPHERECAP_FUSED_FMA
    precise float lost = mad(a, b, -product);
#else
    // Products of halves are exact (Dekker).
    precise float a_high = asfloat(asuint(a) & 0xfffff000u);
    precise float b_high = asfloat(asuint(b) & 0xfffff000u);
    precise float a_low = a - a_high;
    precise float b_low = b - b_high;
    // `precise` reaches sums and products, not mad(): two of those in a row could be factored.
    precise float rest = mad(a_high, b_high, -product) + a_high * b_low;
    precise float lost = mad(a_low, b_high, rest) + a_low * b_low;
#endif
    return lost;
}

// a b + c, rounded as if once where the sum cancels.
float spherecap_fused(float a, float b, float c) {
#ifdef SPHERECAP_FUSED_FMA
    precise float sum = mad(a, b, c);
#else
    precise float product = a * b;
    precise float sum = (product + c) + spherecap_lost(a, b, product);
#endif
    return sum;
}

// A number without its sign and its significand.
float spherecap_power_of_two(float a) {
    return asfloat(asuint(a) & 0x7f800000u);
}

// The bits of a number, as a number.
float spherecap_bits(float a) {
    return float(asint(a));
}

// The number of these bits; any number where they are none.
float spherecap_float_of_bits(float a) {
    return asfloat(int(a));
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

spherecap_sample spherecap_no_sample() {
    spherecap_sample result = {
        float3(0.0, 0.0, 0.0), 0.0, float3(0.0, 0.0, 0.0), 0.0, 0.0, 0.0
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

spherecap_surface_light spherecap_surface_prepare(float3 normal, float3 centre, float radius) {
    bool t1 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t2 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t2));
    float t3 = t1 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t4 = centre.x * t3;
    float t5 = centre.y * t3;
    float t6 = centre.z * t3;
    float t7 = radius * t3;
    precise float t8 = t6 * t6;
    float t9 = mad(t4, t4, mad(t5, t5, t8));
    float t10 = mad(-t7, t7, t9);
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
    float t27 = mad(t22, t22, mad(t24, t24, t26 * t26));
    float t28, t29, t30, t31, t32;
    if (t27 < t11 * 0.015625) {
        float t33 = t22 - spherecap_lost(normal.z, t5, t21);
        float t34 = t24 - spherecap_lost(normal.x, t6, t23);
        float t35 = t26 - spherecap_lost(normal.y, t4, t25);
        float t36 = mad(t33, t33, mad(t34, t34, t35 * t35));
        bool t37 = t36 < t11 * 5.169879e-26;
        bool t38 = abs(t4) < abs(t6);
        float t39 = t38 ? 0.0 : -t5;
        float t40 = t38 ? -t6 : t4;
        float t41 = t38 ? t5 : 0.0;
        float t42 = sqrt(t36);
        t28 = t37 ? t39 : t33;
        t29 = t37 ? t40 : t34;
        t30 = t37 ? t41 : t35;
        t31 = t37 ? sqrt(mad(t39, t39, mad(t40, t40, t41 * t41))) : t42;
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
    float t57 = sqrt(t11);
    float t58 = 1.0 / t57;
    float t59 = sqrt(t12);
    float elevation_sin = t52 * t58;
    bool t60 = 0.0 < t12;
    bool t61 = 0.0 < t56 && t60;
    bool t62 = 0.0 < elevation_sin;
    float t63;
    float t_x = 0.0, t_y = 0.0, width = 0.0, kappa = 0.0, cut = 0.0, shape = 0.0;
    float shape_difference = 0.0, norm = 0.0, tau = 0.0, area = 0.0;
    if (t61) {
        t63 = sqrt(t12 + t56);
        float t64 = sqrt(t56);
        float t65 = 1.0 / (t63 * t7);
        float t66 = t65 * t7;
        float t67 = t65 * t63;
        t_x = t59 * t66;
        t_y = t64 * t66;
        float t68 = t_y * t_y;
        kappa = abs(t52) * t67;
        cut = kappa * t_x;
        float t69 = t_x - 0.5;
        float t70 = cut - 0.5;
        float t71 = t69 * t69;
        float t72 = t70 * t70;
        float t73 = mad(0.05430631, t71, 0.080950715);
        float t74 = mad(t73, t71, 0.1684019);
        float t75 = mad(t74, t71, 0.32709444);
        float t76 = mad(t75, t71, 0.5987523);
        float t77 = mad(-0.026061837, t71, -0.06372378);
        float t78 = mad(t77, t71, -0.11762552);
        float t79 = mad(t78, t71, -0.23594604);
        float t80 = mad(t79, t71, -0.44721135);
        float t81 = mad(t80, t71, -0.7754678);
        shape = mad(t81, t69, mad(t76, t71, 0.94559944));
        float t82 = mad(t70, mad(mad(mad(mad(-0.026061837, t72, t77), t72, t78), t72, t79), t72, t80), mad(mad(mad(mad(0.05430631, t72, t73), t72, t74), t72, t75), t72, t76));
        shape_difference = mad(t82, t69 + t70, t81);
        norm = mad(cut, shape_difference, shape);
        width = t68 / (1.0 + t_x);
        tau = t64 * t67;
        area = t68 * t_y * (min(t55, t54) * t67) * norm;
    } else {
        t63 = t32;
    }
    float radius_sin = t7 * t58;
    float radius_cos = t59 * t58;
    float elevation_cos = t63 * t58;
    float t83 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = max(-(radius_cos * t83), t56 * (t58 * t58) / mad(radius_cos, t83, climb));
    float t84 = radius_sin * radius_sin;
    float t85 = t62 ? mad(t84 * t83, 3.1415927, area) : area;
    bool t86 = 9.8607613e-32 < t84;
    float3 towards_centre = float3(t4, t5, t6) * t58;
    float t87 = 1.0 / t31;
    float3 sideways = float3(t28, t29, t30) * t87;
    float distance = t57 * (t1 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t85 && t86 && t60) ? t85 : 0.0;
    float density_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    float t88 = t62 ? density_above : 0.0;
    bool t89 = t61 && t62 && 0.0 < t88;
    float t90 = t_y * t_y * t_y * shape * t88;
    float t91 = t_y / radius_sin;
    float beyond = t89 ? t91 * t91 * t91 * (mad(cut - t_x, shape_difference, shape) * 0.53033006) : 0.0;
    float b_0 = 0.0, b_1 = 0.0, b_2 = 0.0, b_3 = 0.0, b_4 = 0.0, b_5 = 0.0, b_6 = 0.0;
    if (t61 && !t62) {
        float t92 = 1.0 + kappa;
        float t93 = t92 * shape;
        float t94 = 1.0 / (norm * t93);
        float t95 = sqrt(t94);
        b_0 = norm * t95;
        float t96 = 1.0 / (1.0 + cut);
        float t97 = (t_x + kappa) * t96 - 0.5;
        float t98 = t97 * t97 * t97;
        float t99 = mad(mad(mad(-0.026061837, t97, 0.05430631), t97, -0.06372378), t98, mad(mad(0.080950715, t97, -0.11762552), t97, 0.1684019));
        float t100 = mad(mad(t99, t98, mad(mad(-0.23594604, t97, 0.32709444), t97, -0.44721135)), t98, mad(mad(0.5987523, t97, -0.7754678), t97, 0.94559944));
        float t101 = t92 * t100 * (t96 * t96 * t96) * (t93 * t94);
        float t102 = mad(t101, t93 * t95, -1.0);
        float t103 = 1.0 - t101;
        float t104 = mad(mad(30.011856, t102, mad(-41.541264, t103, -37.009792)), t102, mad(77.96775, t103, 7.470758));
        float t105 = mad(mad(mad(15.716111 * t103, t103, 9.961183), t103, -2.61785), t103, 0.8681748);
        float t106 = mad(mad(t104, t102, mad(mad(-49.13454, t103, -9.466533), t103, -1.5877596)), t102, t105);
        float t107 = t102 * t106;
        float t108 = mad(mad(7.295638, t102, -7.236236), t102, mad(-11.4868555 * t103 * t103, t103, 3.1255686));
        float t109 = mad(mad(mad(13.728438, t103, -7.981878), t103, 2.025724), t103, -0.7334958);
        float t110 = t102 * mad(t108, t102, t109);
        float t111 = mad(mad(-23.220068, t103, 7.332055), t102, mad(mad(9.986537, t103, 25.22195) * t103, t103, -2.9581387));
        float t112 = mad(mad(mad(-19.722994, t103, 4.6594768), t103, -0.89538246), t103, 0.5143498);
        float t113 = t102 * mad(t111, t102, t112);
        float t114 = mad(mad(mad(1.946617, t102, -3.077631), t102, 1.4945927), t102, -0.24140751);
        float t115 = t102 * t114;
        float t116 = t102 * mad(mad(0.38173297, t102, -0.30305624), t102, 0.05897375);
        b_1 = t101 - b_0 + t107;
        b_2 = t110 - t107;
        b_3 = t113 - t110;
        b_4 = t115 - t113;
        b_5 = t116 - t115;
        b_6 = -t116;
    }
    bool t117 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < density_above;
    float t118 = t117 ? ((0.0 < radius_cos && t86) ? t84 / (1.0 + radius_cos) : 0.0) * 6.2831855 : 0.0;
    spherecap_surface_light result = {
        t117, t118, t117 ? projected_above : 0.0, towards_centre, sideways, normal, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, density_above,
        cross(sideways, normal), t89 ? t90 : 0.0, t89 ? 1.0 / (1.0 - t90) : 1.0, beyond,
        elevation_cos * radius_cos, radius_sin * t83, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

spherecap_sample spherecap_surface_sample(spherecap_surface_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    bool t2 = 0.0 < light.tau;
    float t3 = min(0.99999994, max(5.9604645e-8, u0));
    float t4 = min(0.99999994, max(5.9604645e-8, u1));
    bool t5 = !(0.0 < light.elevation_sin) && t2;
    bool t6 = light.crescent_share <= t3 && !t5;
    bool t7 = !t2 || t6;
    float t8 = 1.0 - t4;
    float t9 = t4 - t8;
    float t10 = 4.0 * t4 * t8;
    float t11 = min(0.99999994, max(5.9604645e-8, (t3 - light.crescent_share) * light.inv_rest));
    float t12 = t2 ? t11 : t3;
    float t13 = t2 ? light.beyond : 0.0;
    float t14 = 1.6660811 - t13;
    float t15 = mad(t12, t14, t13);
    float t16 = (1.0 - t12) * t14;
    float t18, t19, t20;
    float t17 = 0.0;
    if (t7) {
        t18 = min(t16, t15);
        t19 = 1.0;
        t20 = 1.0;
    } else {
        float t21 = sqrt(t10);
        float t22 = mad(mad(mad(light.b_5, t10, light.b_3), t10, light.b_1), t21, mad(mad(mad(light.b_6, t10, light.b_4), t10, light.b_2), t10, light.b_0));
        float t23 = t21 * t22;
        float t24 = sqrt(mad(t9, t9, t23 * t23));
        float t25 = light.tau * t23;
        t20 = t5 ? mad(t9, t9, t25 * t25) : 1.0;
        float t26 = t5 ? mad(light.kappa, t23, t24) * mad(light.cut, t23, t24) : light.crescent_share;
        float t27 = (t5 ? light.width : t3) / t26;
        float t28 = t5 ? t27 : light.width;
        float t29 = t20 * t28;
        float t30 = mad(mad(mad(-0.00060778117, t29, 1.0676054e-5), t29, -0.0027203285), t29 * t29 * t29, mad(mad(-0.011332183, t29, -0.10000902), t29, 1.0000001));
        t17 = t5 ? t25 : t21;
        t18 = t5 ? t3 : min(0.99999994, max(5.9604645e-8, t27));
        t19 = t28 * t30;
    }
    float t31 = spherecap_float_of_bits(mad(spherecap_bits(t18), -0.33333334, 1419900500.0));
    float t32 = t18 * t31;
    float t33 = mad(-t32, t31 * t31, 1.0);
    float t34 = t33 * t33;
    float t35 = mad(mad(0.12666093, t34, mad(0.14565912, t33, 0.17283025)), t34, mad(0.22221696, t33, 0.33333334));
    float t36 = t19 * mad(t32 * t33, t35, t32);
    float t37 = t36 * t20;
    float t38 = t37 * t37 * t37;
    float t39 = mad(mad(mad(0.022114987, t37, -0.063446075), t37, 0.085662976), t38, mad(mad(-0.056249518, t37, 0.030445365), t37, 0.0074712755));
    float t40 = t36 * mad(t39, t38, mad(mad(0.03209764, t37, 0.09996679), t37, 1.0000004));
    float t41 = t20 * t40;
    float t42 = 2.0 - t41;
    float t43 = t40 * t42;
    float t44 = sqrt(t43);
    float zenith, side, cosine, t45;
    if (t7) {
        float t46 = t15 - t16 < 0.0 ? t41 : t42;
        float t47 = 1.0 - t46;
        float t48 = light.radius_sin * light.radius_sin * t10;
        float t49 = max(0.0, mad(light.climb, t46, -light.rise));
        cosine = sqrt(mad(t43, t48, t49 * t49));
        float t50 = t1 * light.radius_cos;
        float t51 = light.climb * t47;
        zenith = mad(light.elevation_cos, mad(t51, t51 - 2.0 * t50, t43 * t48) / (cosine + t50), -(light.half_axis * t1 * t47));
        side = light.radius_sin * t44 * t9;
        t45 = mad(light.half_axis, t47, light.middle);
    } else {
        cosine = t44 * t17;
        t45 = 1.0 - t41;
        zenith = mad(light.elevation_cos, cosine, -((t5 ? -t1 : t1) * t45));
        side = t44 * t9;
    }
    float t52 = min(3.4028235e38, 0.0 / max(1.1754944e-38, min(3.4028235e38, abs(cosine))));
    float t53 = mad(zenith, zenith, side * side);
    float t54 = max(0.0, mad(light.radius_sin, light.radius_sin, -t53));
    float t55 = sqrt(t54);
    float t56 = sqrt(mad(light.radius_cos, light.radius_cos, t54));
    float t57 = light.radius_cos * light.radius_cos / (t56 + t55);
    float t58 = 1.0 / light.radius_sin;
    float t59 = t57 * t58;
    float t60 = -mad(t56, t55, t53) * t58;
    float t61 = t59 * zenith;
    float t62 = t59 * side;
    float t63 = mad(light.elevation_cos, t60, -(light.elevation_sin * t61));
    float t64 = mad(light.elevation_sin, t60, light.elevation_cos * t61);
    spherecap_sample result = {
        light.third_axis * t45 + light.sideways * side + light.normal * cosine, t57 * light.distance,
        light.third_axis * t63 + light.sideways * t62 + light.normal * t64, cosine,
        light.density_above * min(3.4028235e38, max(0.0, cosine)),
        min(3.4028235e38, (0.0 < cosine ? light.density_above : 0.0) + t52)
    };
    return result;
}

spherecap_sample spherecap_surface_sample_once(float3 normal, float3 centre, float radius, float u0, float u1) {
    spherecap_surface_light light = spherecap_surface_prepare(normal, centre, radius);
    return spherecap_surface_sample(light, u0, u1);
}

float spherecap_surface_pdf_direction(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    bool t1 = dot(light.towards_centre, direction) < 0.0;
    float t2 = t1 ? 1.0 : dot(cross(light.towards_centre, light.sideways), direction);
    float t3 = t1 ? 1.0 : dot(light.sideways, direction);
    float t4 = light.density_above * min(3.4028235e38, max(0.0, dot(light.normal, direction)));
    float t5 = mad(t2, t2, t3 * t3) <= light.radius_sin * light.radius_sin * 1.0000019 ? t4 : 0.0;
    float t6 = dot(direction, direction);
    return (0.998001 <= t6 && t6 <= 1.002001) ? t5 : 0.0;
}

float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = light.density_above * min(3.4028235e38, max(0.0, dot(light.normal, direction)));
    float t2 = dot(direction, direction);
    return (0.998001 <= t2 && t2 <= 1.002001) ? t1 : 0.0;
}

float spherecap_surface_importance(float3 normal, float3 centre, float radius, float strength) {
    bool t1 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t2 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t2));
    float t3 = t1 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t4 = centre.x * t3;
    float t5 = centre.y * t3;
    float t6 = centre.z * t3;
    float t7 = radius * t3;
    float t8 = sqrt(mad(t4, t4, mad(t5, t5, t6 * t6)));
    float t9 = 1.0 / t8;
    float t10 = t7 * t9;
    float t11 = t10 * t10;
    bool t12 = 0.0 < radius && t8 * (t1 ? 1.0 : unscale) <= 3.4028235e38 && 0.0 < strength;
    float t13 = mad(normal.x, t4, mad(normal.y, t5, normal.z * t6));
    float t14 = mad(t13, t9, 2.3841858e-7);
    float t15 = mad(t13 + t7, t9, 2.3841858e-7);
    float t16 = t15 * t15 / (mad(t10 - t14, max(0.0, mad(-t11, t11, 0.9999981)), t15) * 2.0);
    float t17 = t10 <= t14 ? t14 : 0.0 < t15 ? t16 : 0.0;
    float t18 = mad(0.0, 0.5 - t17, t17);
    bool t19 = t11 <= 1.0000019 && 4.9303807e-32 < t11 && strength <= 3.4028235e38 && t12;
    float t20 = (0.0 < t18 && t19) ? min(3.4028235e38, max(1.1754944e-38, t11 * t18 * strength)) : 0.0;
    return t20;
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

spherecap_front_light spherecap_front_prepare(float3 normal, float3 centre, float radius, float defensive) {
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
        float t6 = max(1.1754944e-38, sqrt(mad(t3, t3, mad(t4, t4, t5 * t5))));
        normal_x = t3 / t6;
        normal_y = t4 / t6;
        normal_z = t5 / t6;
    }
    float t7 = mad(normal_x, normal_x, mad(normal_y, normal_y, normal_z * normal_z));
    bool t8 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t9 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t9));
    float t10 = t8 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t11 = centre.x * t10;
    float t12 = centre.y * t10;
    float t13 = centre.z * t10;
    float t14 = radius * t10;
    precise float t15 = t13 * t13;
    float t16 = mad(t11, t11, mad(t12, t12, t15));
    float t17 = mad(-t14, t14, t16);
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
    precise float t28 = normal_z * t12;
    float t29 = spherecap_fused(normal_y, t13, -t28);
    precise float t30 = normal_x * t13;
    float t31 = spherecap_fused(normal_z, t11, -t30);
    precise float t32 = normal_y * t11;
    float t33 = spherecap_fused(normal_x, t12, -t32);
    float t34 = mad(t29, t29, mad(t31, t31, t33 * t33));
    float up_x, up_y, up_z, t35, t36, t37, t38, t39;
    if (t34 < t18 * 0.015625) {
        float t40 = t29 - spherecap_lost(normal_z, t12, t28);
        float t41 = t31 - spherecap_lost(normal_x, t13, t30);
        float t42 = t33 - spherecap_lost(normal_y, t11, t32);
        float t43 = mad(t40, t40, mad(t41, t41, t42 * t42));
        bool t44 = 0.0 < t7;
        bool t45 = t43 < t18 * 5.169879e-26;
        bool t46 = abs(t11) < abs(t13);
        float t47 = t46 ? 0.0 : -t12;
        float t48 = t46 ? -t13 : t11;
        float t49 = t46 ? t12 : 0.0;
        float t50 = sqrt(mad(t47, t47, mad(t48, t48, t49 * t49)));
        float t51 = sqrt(t18);
        float t52 = t51 * t50;
        float t53 = sqrt(t43);
        up_x = t45 ? (t44 ? normal_x : mad(t12, t49, -(t13 * t48)) / t52) : normal_x;
        up_y = t45 ? (t44 ? normal_y : mad(t13, t47, -(t11 * t49)) / t52) : normal_y;
        up_z = t45 ? (t44 ? normal_z : mad(t11, t48, -(t12 * t47)) / t52) : normal_z;
        t35 = t45 ? t47 : t40;
        t36 = t45 ? t48 : t41;
        t37 = t45 ? t49 : t42;
        t38 = t45 ? t50 : t53;
        t39 = t45 ? (t44 ? 0.0 : t51) : t53;
    } else {
        t38 = sqrt(t34);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t35 = t29;
        t36 = t31;
        t37 = t33;
        t39 = t38;
    }
    bool t54 = 0.0 < t7;
    precise float t55 = normal_x * t11;
    precise float t56 = normal_y * t12;
    precise float t57 = normal_z * t13;
    precise float t58 = t55 + t56;
    precise float t59 = t58 - t55;
    precise float t60 = t58 + t57;
    precise float t61 = t60 - t58;
    float t62 = spherecap_lost(normal_x, t11, t55) + spherecap_lost(normal_y, t12, t56) + spherecap_lost(normal_z, t13, t57);
    precise float t63 = t62 + (t55 - (t58 - t59) + (t56 - t59) + (t58 - (t60 - t61) + (t57 - t61)));
    precise float t64 = t60 + t63;
    precise float t65 = t63 - (t64 - t60);
    float t66 = t14 - t64 - t65;
    float t67 = t14 + t64 + t65;
    float t68 = t66 * t67;
    float t69 = sqrt(t18);
    float t70 = 1.0 / t69;
    float t71 = sqrt(t19);
    float elevation_sin = t64 * t70;
    bool t72 = 0.0 < t19;
    bool t73 = 0.0 < t68 && t54 && t72;
    bool t74 = 0.0 < elevation_sin;
    float t75;
    float t_x = 0.0, t_y = 0.0, width = 0.0, kappa = 0.0, cut = 0.0, shape = 0.0;
    float shape_difference = 0.0, norm = 0.0, tau = 0.0, area = 0.0;
    if (t73) {
        t75 = sqrt(t19 + t68);
        float t76 = sqrt(t68);
        float t77 = 1.0 / (t75 * t14);
        float t78 = t77 * t14;
        float t79 = t77 * t75;
        t_x = t71 * t78;
        t_y = t76 * t78;
        float t80 = t_y * t_y;
        kappa = abs(t64) * t79;
        cut = kappa * t_x;
        float t81 = t_x - 0.5;
        float t82 = cut - 0.5;
        float t83 = t81 * t81;
        float t84 = t82 * t82;
        float t85 = mad(0.05430631, t83, 0.080950715);
        float t86 = mad(t85, t83, 0.1684019);
        float t87 = mad(t86, t83, 0.32709444);
        float t88 = mad(t87, t83, 0.5987523);
        float t89 = mad(-0.026061837, t83, -0.06372378);
        float t90 = mad(t89, t83, -0.11762552);
        float t91 = mad(t90, t83, -0.23594604);
        float t92 = mad(t91, t83, -0.44721135);
        float t93 = mad(t92, t83, -0.7754678);
        shape = mad(t93, t81, mad(t88, t83, 0.94559944));
        float t94 = mad(t82, mad(mad(mad(mad(-0.026061837, t84, t89), t84, t90), t84, t91), t84, t92), mad(mad(mad(mad(0.05430631, t84, t85), t84, t86), t84, t87), t84, t88));
        shape_difference = mad(t94, t81 + t82, t93);
        norm = mad(cut, shape_difference, shape);
        width = t80 / (1.0 + t_x);
        tau = t76 * t79;
        area = t80 * t_y * (min(t67, t66) * t79) * norm;
    } else {
        t75 = t39;
    }
    float radius_sin = t14 * t70;
    float radius_cos = t71 * t70;
    float elevation_cos = t75 * t70;
    float t95 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = max(-(radius_cos * t95), t68 * (t70 * t70) / mad(radius_cos, t95, climb));
    float t96 = radius_sin * radius_sin;
    float t97 = t74 ? mad(t96 * t95, 3.1415927, area) : area;
    bool t98 = 9.8607613e-32 < t96;
    float3 towards_centre = float3(t11, t12, t13) * t70;
    float t99 = 1.0 / t38;
    float3 sideways = float3(t35, t36, t37) * t99;
    float on_surface = t54 ? 1.0 : 0.0;
    float distance = t69 * (t8 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t97 && t98 && t72) ? t97 : 0.0;
    bool t100 = 0.0 < projected_above;
    float t101 = t100 ? 1.0 / projected_above : 0.0;
    float t102 = t74 ? t101 : 0.0;
    bool t103 = t73 && t74 && 0.0 < t102;
    float t104 = t_y * t_y * t_y * shape * t102;
    float t105 = t_y / radius_sin;
    float t106 = t105 * t105 * t105 * (mad(cut - t_x, shape_difference, shape) * 0.53033006);
    float b_0 = 0.0, b_1 = 0.0, b_2 = 0.0, b_3 = 0.0, b_4 = 0.0, b_5 = 0.0, b_6 = 0.0;
    if (t73 && !t74) {
        float t107 = 1.0 + kappa;
        float t108 = t107 * shape;
        float t109 = 1.0 / (norm * t108);
        float t110 = sqrt(t109);
        b_0 = norm * t110;
        float t111 = 1.0 / (1.0 + cut);
        float t112 = (t_x + kappa) * t111 - 0.5;
        float t113 = t112 * t112 * t112;
        float t114 = mad(mad(mad(-0.026061837, t112, 0.05430631), t112, -0.06372378), t113, mad(mad(0.080950715, t112, -0.11762552), t112, 0.1684019));
        float t115 = mad(t114, t113, mad(mad(-0.23594604, t112, 0.32709444), t112, -0.44721135));
        float t116 = t107 * mad(t115, t113, mad(mad(0.5987523, t112, -0.7754678), t112, 0.94559944));
        float t117 = t116 * (t111 * t111 * t111) * (t108 * t109);
        float t118 = mad(t117, t108 * t110, -1.0);
        float t119 = 1.0 - t117;
        float t120 = mad(mad(30.011856, t118, mad(-41.541264, t119, -37.009792)), t118, mad(77.96775, t119, 7.470758));
        float t121 = mad(mad(mad(15.716111 * t119, t119, 9.961183), t119, -2.61785), t119, 0.8681748);
        float t122 = mad(mad(t120, t118, mad(mad(-49.13454, t119, -9.466533), t119, -1.5877596)), t118, t121);
        float t123 = t118 * t122;
        float t124 = mad(mad(7.295638, t118, -7.236236), t118, mad(-11.4868555 * t119 * t119, t119, 3.1255686));
        float t125 = mad(mad(mad(13.728438, t119, -7.981878), t119, 2.025724), t119, -0.7334958);
        float t126 = t118 * mad(t124, t118, t125);
        float t127 = mad(mad(-23.220068, t119, 7.332055), t118, mad(mad(9.986537, t119, 25.22195) * t119, t119, -2.9581387));
        float t128 = mad(mad(mad(-19.722994, t119, 4.6594768), t119, -0.89538246), t119, 0.5143498);
        float t129 = t118 * mad(t127, t118, t128);
        float t130 = mad(mad(mad(1.946617, t118, -3.077631), t118, 1.4945927), t118, -0.24140751);
        float t131 = t118 * t130;
        float t132 = t118 * mad(mad(0.38173297, t118, -0.30305624), t118, 0.05897375);
        b_1 = t117 - b_0 + t123;
        b_2 = t126 - t123;
        b_3 = t129 - t126;
        b_4 = t131 - t129;
        b_5 = t132 - t131;
        b_6 = -t132;
    }
    float t133 = ((0.0 < defensive || !(0.0 < on_surface)) && !t100) ? 1.0 : defensive;
    bool t134 = 0.0 < t133;
    float t135 = (0.0 < radius_cos && t98) ? t96 / (1.0 + radius_cos) : 0.0;
    float density = t134 ? t133 * (0.0 < t135 ? 0.15915494 / t135 : 0.0) : 0.0;
    float density_above = t101 * (1.0 - t133);
    bool t136 = 0.0 <= defensive && defensive <= 1.0 && t7 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && 0.0 < density_above + 0.0 + density;
    spherecap_front_light result = {
        t136, t136 ? t135 * 6.2831855 : 0.0, t136 ? projected_above : 0.0, towards_centre, sideways,
        float3(normal_x, normal_y, normal_z), float3(up_x, up_y, up_z), on_surface, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, t133, defensive,
        density_above,
        float3(mad(sideways.y, up_z, -(sideways.z * up_y)), mad(sideways.z, up_x, -(sideways.x * up_z)), mad(sideways.x, up_y, -(sideways.y * up_x))),
        t134 ? t135 : 0.0, density, t103 ? t104 : 0.0, t103 ? 1.0 / (1.0 - t104) : 1.0, t103 ? t106 : 0.0,
        elevation_cos * radius_cos, radius_sin * t95, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

spherecap_sample spherecap_front_sample(spherecap_front_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    float t2 = min(0.99999994, max(5.9604645e-8, u0));
    float t3 = min(0.99999994, max(5.9604645e-8, u1));
    bool t4 = t2 < light.defensive;
    float t5 = (t4 ? t2 : t2 - light.defensive) / (t4 ? light.defensive : 1.0 - light.defensive);
    float t6 = 0.0 < light.requested ? min(0.99999994, max(5.9604645e-8, t5)) : t2;
    bool t7 = !(0.0 < light.tau) || t4;
    bool t8 = !(0.0 < light.elevation_sin) && !t7;
    bool t9 = light.crescent_share <= t6 && !t8;
    bool t10 = t7 || t9;
    float t11 = 1.0 - t3;
    float t12 = t3 - t11;
    float t13 = 4.0 * t3 * t11;
    float t14 = min(0.99999994, max(5.9604645e-8, (t6 - light.crescent_share) * light.inv_rest));
    float t15 = t7 ? t6 : t14;
    float t16 = t7 ? 0.0 : light.beyond;
    float t17 = 1.6660811 - t16;
    float t18 = mad(t15, t17, t16);
    float t19 = (1.0 - t15) * t17;
    float t21, t22, t23;
    float t20 = 0.0;
    if (t10) {
        t21 = min(t19, t18);
        t22 = 1.0;
        t23 = 1.0;
    } else {
        float t24 = sqrt(t13);
        float t25 = mad(mad(mad(light.b_5, t13, light.b_3), t13, light.b_1), t24, mad(mad(mad(light.b_6, t13, light.b_4), t13, light.b_2), t13, light.b_0));
        float t26 = t24 * t25;
        float t27 = sqrt(mad(t12, t12, t26 * t26));
        float t28 = light.tau * t26;
        t23 = t8 ? mad(t12, t12, t28 * t28) : 1.0;
        float t29 = t8 ? mad(light.kappa, t26, t27) * mad(light.cut, t26, t27) : light.crescent_share;
        float t30 = (t8 ? light.width : t6) / t29;
        float t31 = t8 ? t30 : light.width;
        float t32 = t23 * t31;
        float t33 = mad(mad(mad(-0.00060778117, t32, 1.0676054e-5), t32, -0.0027203285), t32 * t32 * t32, mad(mad(-0.011332183, t32, -0.10000902), t32, 1.0000001));
        t20 = t8 ? t28 : t24;
        t21 = t8 ? t6 : min(0.99999994, max(5.9604645e-8, t30));
        t22 = t31 * t33;
    }
    float t34 = spherecap_float_of_bits(mad(spherecap_bits(t21), -0.33333334, 1419900500.0));
    float t35 = t21 * t34;
    float t36 = mad(-t35, t34 * t34, 1.0);
    float t37 = t36 * t36;
    float t38 = mad(mad(0.12666093, t37, mad(0.14565912, t36, 0.17283025)), t37, mad(0.22221696, t36, 0.33333334));
    float t39 = t22 * mad(t35 * t36, t38, t35);
    float t40 = t39 * t23;
    float t41 = t40 * t40 * t40;
    float t42 = mad(mad(mad(0.022114987, t40, -0.063446075), t40, 0.085662976), t41, mad(mad(-0.056249518, t40, 0.030445365), t40, 0.0074712755));
    float t43 = t39 * mad(t42, t41, mad(mad(0.03209764, t40, 0.09996679), t40, 1.0000004));
    float t44 = t23 * t43;
    float t45 = 2.0 - t44;
    float t46 = t43 * t45;
    float t47 = sqrt(t46);
    float zenith, side, cosine, t48, t49;
    if (t10) {
        float t50 = t18 - t19 < 0.0 ? t44 : t45;
        if (t4) {
            float t51 = light.height * (1.0 - t46 * t13);
            float t52 = sqrt(light.height * (2.0 - t51));
            zenith = (t50 - 1.0) * t52;
            float t53 = 1.0 - t51;
            t49 = mad(light.elevation_sin, t53, light.elevation_cos * zenith);
            t48 = mad(light.elevation_cos, t53, -(light.elevation_sin * zenith));
            side = t47 * t12 * t52;
            cosine = t49 * light.on_surface;
        } else {
            float t54 = 1.0 - t50;
            float t55 = light.radius_sin * light.radius_sin * t13;
            float t56 = max(0.0, mad(light.climb, t50, -light.rise));
            t49 = sqrt(mad(t46, t55, t56 * t56));
            float t57 = t1 * light.radius_cos;
            float t58 = light.climb * t54;
            zenith = mad(light.elevation_cos, mad(t58, t58 - 2.0 * t57, t46 * t55) / (t49 + t57), -(light.half_axis * t1 * t54));
            t48 = mad(light.half_axis, t54, light.middle);
            side = light.radius_sin * t47 * t12;
            cosine = t49;
        }
    } else {
        cosine = t47 * t20;
        t48 = 1.0 - t44;
        zenith = mad(light.elevation_cos, cosine, -((t8 ? -t1 : t1) * t48));
        side = t47 * t12;
        t49 = cosine;
    }
    float t59 = mad(light.density_above, min(3.4028235e38, max(0.0, cosine)), light.density);
    float t60 = min(3.4028235e38, light.density / max(1.1754944e-38, min(3.4028235e38, abs(cosine))));
    float t61 = mad(zenith, zenith, side * side);
    float t62 = max(0.0, mad(light.radius_sin, light.radius_sin, -t61));
    float t63 = sqrt(t62);
    float t64 = sqrt(mad(light.radius_cos, light.radius_cos, t62));
    float t65 = light.radius_cos * light.radius_cos / (t64 + t63);
    float t66 = 1.0 / light.radius_sin;
    float t67 = t65 * t66;
    float t68 = -mad(t64, t63, t61) * t66;
    float t69 = t67 * zenith;
    float t70 = t67 * side;
    float t71 = mad(light.elevation_cos, t68, -(light.elevation_sin * t69));
    float t72 = mad(light.elevation_sin, t68, light.elevation_cos * t69);
    spherecap_sample result = {
        light.third_axis * t48 + light.sideways * side + light.up * t49, t65 * light.distance,
        light.third_axis * t71 + light.sideways * t70 + light.up * t72, cosine, t59,
        min(3.4028235e38, (0.0 < cosine ? light.density_above : 0.0) + t60)
    };
    return result;
}

spherecap_sample spherecap_front_sample_once(float3 normal, float3 centre, float radius, float defensive, float u0, float u1) {
    spherecap_front_light light = spherecap_front_prepare(normal, centre, radius, defensive);
    return spherecap_front_sample(light, u0, u1);
}

float spherecap_front_pdf_direction(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    bool t1 = dot(light.towards_centre, direction) < 0.0;
    float t2 = t1 ? 1.0 : dot(cross(light.towards_centre, light.sideways), direction);
    float t3 = t1 ? 1.0 : dot(light.sideways, direction);
    float t4 = mad(light.density_above, min(3.4028235e38, max(0.0, dot(light.normal, direction))), light.density);
    float t5 = mad(t2, t2, t3 * t3) <= light.radius_sin * light.radius_sin * 1.0000019 ? t4 : 0.0;
    float t6 = dot(direction, direction);
    return (0.998001 <= t6 && t6 <= 1.002001) ? t5 : 0.0;
}

float spherecap_front_pdf_on_sphere(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = mad(light.density_above, min(3.4028235e38, max(0.0, dot(light.normal, direction))), light.density);
    float t2 = dot(direction, direction);
    return (0.998001 <= t2 && t2 <= 1.002001) ? t1 : 0.0;
}

float spherecap_front_importance(float3 normal, float3 centre, float radius, float defensive, float strength) {
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
        float t9 = max(1.1754944e-38, sqrt(mad(t6, t6, mad(t7, t7, t8 * t8))));
        t1 = t6 / t9;
        t2 = t7 / t9;
        t3 = t8 / t9;
    }
    bool t10 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t11 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t11));
    float t12 = t10 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t13 = centre.x * t12;
    float t14 = centre.y * t12;
    float t15 = centre.z * t12;
    float t16 = radius * t12;
    float t17 = sqrt(mad(t13, t13, mad(t14, t14, t15 * t15)));
    float t18 = 1.0 / t17;
    float t19 = t16 * t18;
    float t20 = t19 * t19;
    float t21 = mad(t1, t1, mad(t2, t2, t3 * t3));
    bool t22 = 0.0 <= defensive && defensive <= 1.0 && t21 <= 2.0 && 0.0 < radius && t17 * (t10 ? 1.0 : unscale) <= 3.4028235e38;
    float t23 = mad(t1, t13, mad(t2, t14, t3 * t15));
    float t24 = mad(t23, t18, 2.3841858e-7);
    float t25 = mad(t23 + t16, t18, 2.3841858e-7);
    float t26 = t25 * t25 / (mad(t19 - t24, max(0.0, mad(-t20, t20, 0.9999981)), t25) * 2.0);
    float t27 = t19 <= t24 ? t24 : 0.0 < t25 ? t26 : 0.0;
    float t28 = t21 <= 0.0 ? 1.0 : mad(defensive, 0.5 - t27, t27);
    bool t29 = t20 <= 1.0000019 && 4.9303807e-32 < t20 && 0.0 < strength && t22 && strength <= 3.4028235e38;
    float t30 = ((0.0 < t28 || 0.0 < defensive) && t29) ? min(3.4028235e38, max(1.1754944e-38, t20 * t28 * strength)) : 0.0;
    return t30;
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

spherecap_both_light spherecap_both_prepare(float3 normal, float3 centre, float radius, float defensive) {
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
        float t6 = max(1.1754944e-38, sqrt(mad(t3, t3, mad(t4, t4, t5 * t5))));
        normal_x = t3 / t6;
        normal_y = t4 / t6;
        normal_z = t5 / t6;
    }
    float t7 = mad(normal_x, normal_x, mad(normal_y, normal_y, normal_z * normal_z));
    bool t8 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t9 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t9));
    float t10 = t8 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t11 = centre.x * t10;
    float t12 = centre.y * t10;
    float t13 = centre.z * t10;
    float t14 = radius * t10;
    precise float t15 = t13 * t13;
    float t16 = mad(t11, t11, mad(t12, t12, t15));
    float t17 = mad(-t14, t14, t16);
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
    precise float t28 = normal_z * t12;
    float t29 = spherecap_fused(normal_y, t13, -t28);
    precise float t30 = normal_x * t13;
    float t31 = spherecap_fused(normal_z, t11, -t30);
    precise float t32 = normal_y * t11;
    float t33 = spherecap_fused(normal_x, t12, -t32);
    float t34 = mad(t29, t29, mad(t31, t31, t33 * t33));
    float up_x, up_y, up_z, t35, t36, t37, t38, t39;
    if (t34 < t18 * 0.015625) {
        float t40 = t29 - spherecap_lost(normal_z, t12, t28);
        float t41 = t31 - spherecap_lost(normal_x, t13, t30);
        float t42 = t33 - spherecap_lost(normal_y, t11, t32);
        float t43 = mad(t40, t40, mad(t41, t41, t42 * t42));
        bool t44 = 0.0 < t7;
        bool t45 = t43 < t18 * 5.169879e-26;
        bool t46 = abs(t11) < abs(t13);
        float t47 = t46 ? 0.0 : -t12;
        float t48 = t46 ? -t13 : t11;
        float t49 = t46 ? t12 : 0.0;
        float t50 = sqrt(mad(t47, t47, mad(t48, t48, t49 * t49)));
        float t51 = sqrt(t18);
        float t52 = t51 * t50;
        float t53 = sqrt(t43);
        up_x = t45 ? (t44 ? normal_x : mad(t12, t49, -(t13 * t48)) / t52) : normal_x;
        up_y = t45 ? (t44 ? normal_y : mad(t13, t47, -(t11 * t49)) / t52) : normal_y;
        up_z = t45 ? (t44 ? normal_z : mad(t11, t48, -(t12 * t47)) / t52) : normal_z;
        t35 = t45 ? t47 : t40;
        t36 = t45 ? t48 : t41;
        t37 = t45 ? t49 : t42;
        t38 = t45 ? t50 : t53;
        t39 = t45 ? (t44 ? 0.0 : t51) : t53;
    } else {
        t38 = sqrt(t34);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t35 = t29;
        t36 = t31;
        t37 = t33;
        t39 = t38;
    }
    bool t54 = 0.0 < t7;
    precise float t55 = normal_x * t11;
    precise float t56 = normal_y * t12;
    precise float t57 = normal_z * t13;
    precise float t58 = t55 + t56;
    precise float t59 = t58 - t55;
    precise float t60 = t58 + t57;
    precise float t61 = t60 - t58;
    float t62 = spherecap_lost(normal_x, t11, t55) + spherecap_lost(normal_y, t12, t56) + spherecap_lost(normal_z, t13, t57);
    precise float t63 = t62 + (t55 - (t58 - t59) + (t56 - t59) + (t58 - (t60 - t61) + (t57 - t61)));
    precise float t64 = t60 + t63;
    precise float t65 = t63 - (t64 - t60);
    float t66 = t14 - t64 - t65;
    float t67 = t14 + t64 + t65;
    float t68 = t66 * t67;
    float t69 = sqrt(t18);
    float t70 = 1.0 / t69;
    float t71 = sqrt(t19);
    float elevation_sin = t64 * t70;
    bool t72 = 0.0 < t19;
    bool t73 = 0.0 < t68 && t54 && t72;
    bool t74 = 0.0 < elevation_sin;
    float t75;
    float t_x = 0.0, t_y = 0.0, width = 0.0, kappa = 0.0, cut = 0.0, shape = 0.0;
    float shape_difference = 0.0, norm = 0.0, tau = 0.0, area = 0.0;
    if (t73) {
        t75 = sqrt(t19 + t68);
        float t76 = sqrt(t68);
        float t77 = 1.0 / (t75 * t14);
        float t78 = t77 * t14;
        float t79 = t77 * t75;
        t_x = t71 * t78;
        t_y = t76 * t78;
        float t80 = t_y * t_y;
        kappa = abs(t64) * t79;
        cut = kappa * t_x;
        float t81 = t_x - 0.5;
        float t82 = cut - 0.5;
        float t83 = t81 * t81;
        float t84 = t82 * t82;
        float t85 = mad(0.05430631, t83, 0.080950715);
        float t86 = mad(t85, t83, 0.1684019);
        float t87 = mad(t86, t83, 0.32709444);
        float t88 = mad(t87, t83, 0.5987523);
        float t89 = mad(-0.026061837, t83, -0.06372378);
        float t90 = mad(t89, t83, -0.11762552);
        float t91 = mad(t90, t83, -0.23594604);
        float t92 = mad(t91, t83, -0.44721135);
        float t93 = mad(t92, t83, -0.7754678);
        shape = mad(t93, t81, mad(t88, t83, 0.94559944));
        float t94 = mad(t82, mad(mad(mad(mad(-0.026061837, t84, t89), t84, t90), t84, t91), t84, t92), mad(mad(mad(mad(0.05430631, t84, t85), t84, t86), t84, t87), t84, t88));
        shape_difference = mad(t94, t81 + t82, t93);
        norm = mad(cut, shape_difference, shape);
        width = t80 / (1.0 + t_x);
        tau = t76 * t79;
        area = t80 * t_y * (min(t67, t66) * t79) * norm;
    } else {
        t75 = t39;
    }
    float radius_sin = t14 * t70;
    float radius_cos = t71 * t70;
    float elevation_cos = t75 * t70;
    float t95 = abs(elevation_sin);
    float climb = radius_sin * elevation_cos;
    float rise = max(-(radius_cos * t95), t68 * (t70 * t70) / mad(radius_cos, t95, climb));
    float t96 = radius_sin * radius_sin;
    float t97 = mad(t96 * t95, 3.1415927, area);
    float t98 = t74 ? t97 : area;
    float t99 = t74 ? area : t97;
    bool t100 = 9.8607613e-32 < t96;
    bool t101 = t100 && t72;
    float3 towards_centre = float3(t11, t12, t13) * t70;
    float t102 = 1.0 / t38;
    float3 sideways = float3(t35, t36, t37) * t102;
    float on_surface = t54 ? 1.0 : 0.0;
    float distance = t69 * (t8 ? 1.0 : unscale);
    float projected_above = (9.403955e-38 < t98 && t101) ? t98 : 0.0;
    float projected_below = (9.403955e-38 < t99 && t101) ? t99 : 0.0;
    bool t103 = 0.0 < projected_above;
    bool t104 = 0.0 < projected_below;
    float t105 = t103 ? 1.0 / projected_above : 0.0;
    float t106 = t104 ? 1.0 / projected_below : 0.0;
    float t107 = t74 ? t105 : t106;
    bool t108 = 0.0 < t107 && t73;
    float t109 = t_y * t_y * t_y * shape * t107;
    float t110 = t_y / radius_sin;
    float t111 = mad(cut - t_x, shape_difference, shape);
    float b_0 = 0.0, b_1 = 0.0, b_2 = 0.0, b_3 = 0.0, b_4 = 0.0, b_5 = 0.0, b_6 = 0.0;
    if (t73) {
        float t112 = 1.0 + kappa;
        float t113 = t112 * shape;
        float t114 = 1.0 / (norm * t113);
        float t115 = sqrt(t114);
        b_0 = norm * t115;
        float t116 = 1.0 / (1.0 + cut);
        float t117 = (t_x + kappa) * t116 - 0.5;
        float t118 = t117 * t117 * t117;
        float t119 = mad(mad(mad(-0.026061837, t117, 0.05430631), t117, -0.06372378), t118, mad(mad(0.080950715, t117, -0.11762552), t117, 0.1684019));
        float t120 = mad(t119, t118, mad(mad(-0.23594604, t117, 0.32709444), t117, -0.44721135));
        float t121 = t112 * mad(t120, t118, mad(mad(0.5987523, t117, -0.7754678), t117, 0.94559944));
        float t122 = t121 * (t116 * t116 * t116) * (t113 * t114);
        float t123 = mad(t122, t113 * t115, -1.0);
        float t124 = 1.0 - t122;
        float t125 = mad(mad(30.011856, t123, mad(-41.541264, t124, -37.009792)), t123, mad(77.96775, t124, 7.470758));
        float t126 = mad(mad(mad(15.716111 * t124, t124, 9.961183), t124, -2.61785), t124, 0.8681748);
        float t127 = mad(mad(t125, t123, mad(mad(-49.13454, t124, -9.466533), t124, -1.5877596)), t123, t126);
        float t128 = t123 * t127;
        float t129 = mad(mad(7.295638, t123, -7.236236), t123, mad(-11.4868555 * t124 * t124, t124, 3.1255686));
        float t130 = mad(mad(mad(13.728438, t124, -7.981878), t124, 2.025724), t124, -0.7334958);
        float t131 = t123 * mad(t129, t123, t130);
        float t132 = mad(mad(-23.220068, t124, 7.332055), t123, mad(mad(9.986537, t124, 25.22195) * t124, t124, -2.9581387));
        float t133 = mad(mad(mad(-19.722994, t124, 4.6594768), t124, -0.89538246), t124, 0.5143498);
        float t134 = t123 * mad(t132, t123, t133);
        float t135 = mad(mad(mad(1.946617, t123, -3.077631), t123, 1.4945927), t123, -0.24140751);
        float t136 = t123 * t135;
        float t137 = t123 * mad(mad(0.38173297, t123, -0.30305624), t123, 0.05897375);
        b_1 = t122 - b_0 + t128;
        b_2 = t131 - t128;
        b_3 = t134 - t131;
        b_4 = t136 - t134;
        b_5 = t137 - t136;
        b_6 = -t137;
    }
    float t138 = (!(t103 || t104) && (0.0 < defensive || !(0.0 < on_surface))) ? 1.0 : defensive;
    bool t139 = 0.0 < t138;
    float t140 = (0.0 < radius_cos && t100) ? t96 / (1.0 + radius_cos) : 0.0;
    float density = t139 ? t138 * (0.0 < t140 ? 0.15915494 / t140 : 0.0) : 0.0;
    float t141 = 1.0 - t138;
    float t142 = 0.0;
    if (0.0 < tau) {
        float t143 = 1.0 / (elevation_cos * elevation_cos);
        float t144 = tau * tau;
        float t145 = t144 * t143 / (1.0 + t_x);
        float t146 = kappa - 0.5;
        float t147 = cut - 0.5;
        float t148 = t146 * t146;
        float t149 = t147 * t147;
        float t150 = mad(0.05430631, t148, 0.080950715);
        float t151 = mad(t150, t148, 0.1684019);
        float t152 = mad(t151, t148, 0.32709444);
        float t153 = mad(mad(mad(mad(0.05430631, t149, t150), t149, t151), t149, t152), t149, mad(t152, t148, 0.5987523));
        float t154 = mad(-0.026061837, t148, -0.06372378);
        float t155 = mad(t154, t148, -0.11762552);
        float t156 = mad(t155, t148, -0.23594604);
        float t157 = mad(t156, t148, -0.44721135);
        float t158 = mad(mad(mad(mad(-0.026061837, t149, t154), t149, t155), t149, t156), t149, t157);
        float t159 = mad(kappa * t145, mad(mad(t147, t158, t153), t146 + t147, mad(t157, t148, -0.7754678)), mad(t111, t145 - kappa * kappa, kappa) * t143);
        t142 = min(0.5, max(0.0, t144 * tau * (radius_cos + 1.0) * t159 * 0.31830987));
    }
    float t160 = 1.0 - t142;
    bool t161 = 0.0 < t106;
    bool t162 = 0.0 < t105;
    float above = t161 ? (t162 ? (t74 ? t160 : t142) : 0.0) : 1.0;
    float density_above = t105 * above * t141;
    float density_below = t106 * (t162 ? (t161 ? (t74 ? t142 : t160) : 0.0) : 1.0) * t141;
    bool t163 = distance <= 3.4028235e38 && 0.0 < density_above + density_below + density;
    bool t164 = 0.0 <= defensive && defensive <= 1.0 && t7 <= 2.0 && 0.0 < radius && t163;
    spherecap_both_light result = {
        t164, t164 ? t140 * 6.2831855 : 0.0, t164 ? projected_above : 0.0, towards_centre, sideways,
        float3(normal_x, normal_y, normal_z), float3(up_x, up_y, up_z), on_surface, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, t138, defensive, above,
        density_above, density_below,
        float3(mad(sideways.y, up_z, -(sideways.z * up_y)), mad(sideways.z, up_x, -(sideways.x * up_z)), mad(sideways.x, up_y, -(sideways.y * up_x))),
        t139 ? t140 : 0.0, density, t108 ? t109 : 0.0, t108 ? 1.0 / (1.0 - t109) : 1.0,
        t108 ? t110 * t110 * t110 * (t111 * 0.53033006) : 0.0, elevation_cos * radius_cos, radius_sin * t95,
        climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    };
    return result;
}

spherecap_sample spherecap_both_sample(spherecap_both_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    bool t1 = 0.0 < light.elevation_sin;
    float t2 = abs(light.elevation_sin);
    float t3 = min(0.99999994, max(5.9604645e-8, u0));
    float t4 = min(0.99999994, max(5.9604645e-8, u1));
    bool t5 = t3 < light.defensive;
    float t6 = (t5 ? t3 : t3 - light.defensive) / (t5 ? light.defensive : 1.0 - light.defensive);
    float t7 = 0.0 < light.requested ? min(0.99999994, max(5.9604645e-8, t6)) : t3;
    bool t8 = t7 < light.above || t5;
    float t9 = max(5.9604645e-8, (t8 ? t7 : t7 - light.above) / (t8 ? light.above : 1.0 - light.above));
    bool t10 = t8 && t1;
    bool t11 = !t8 && !t1;
    float t12 = t5 ? t7 : min(0.99999994, t9);
    bool t13 = !(0.0 < light.tau) || t5;
    bool t14 = !(t10 || t11) && !t13;
    bool t15 = light.crescent_share <= t12 && !t14;
    bool t16 = t13 || t15;
    float t17 = 1.0 - t4;
    float t18 = t4 - t17;
    float t19 = 4.0 * t4 * t17;
    float t20 = min(0.99999994, max(5.9604645e-8, (t12 - light.crescent_share) * light.inv_rest));
    float t21 = t13 ? t12 : t20;
    float t22 = t13 ? 0.0 : light.beyond;
    float t23 = 1.6660811 - t22;
    float t24 = mad(t21, t23, t22);
    float t25 = (1.0 - t21) * t23;
    float t27, t28, t29;
    float t26 = 0.0;
    if (t16) {
        t27 = min(t25, t24);
        t28 = 1.0;
        t29 = 1.0;
    } else {
        float t30 = sqrt(t19);
        float t31 = mad(mad(mad(light.b_5, t19, light.b_3), t19, light.b_1), t30, mad(mad(mad(light.b_6, t19, light.b_4), t19, light.b_2), t19, light.b_0));
        float t32 = t30 * t31;
        float t33 = sqrt(mad(t18, t18, t32 * t32));
        float t34 = light.tau * t32;
        t29 = t14 ? mad(t18, t18, t34 * t34) : 1.0;
        float t35 = t14 ? mad(light.kappa, t32, t33) * mad(light.cut, t32, t33) : light.crescent_share;
        float t36 = (t14 ? light.width : t12) / t35;
        float t37 = t14 ? t36 : light.width;
        float t38 = t29 * t37;
        float t39 = mad(mad(mad(-0.00060778117, t38, 1.0676054e-5), t38, -0.0027203285), t38 * t38 * t38, mad(mad(-0.011332183, t38, -0.10000902), t38, 1.0000001));
        t26 = t14 ? t34 : t30;
        t27 = t14 ? t12 : min(0.99999994, max(5.9604645e-8, t36));
        t28 = t37 * t39;
    }
    float t40 = spherecap_float_of_bits(mad(spherecap_bits(t27), -0.33333334, 1419900500.0));
    float t41 = t27 * t40;
    float t42 = mad(-t41, t40 * t40, 1.0);
    float t43 = t42 * t42;
    float t44 = mad(mad(0.12666093, t43, mad(0.14565912, t42, 0.17283025)), t43, mad(0.22221696, t42, 0.33333334));
    float t45 = t28 * mad(t41 * t42, t44, t41);
    float t46 = t45 * t29;
    float t47 = t46 * t46 * t46;
    float t48 = mad(mad(mad(0.022114987, t46, -0.063446075), t46, 0.085662976), t47, mad(mad(-0.056249518, t46, 0.030445365), t46, 0.0074712755));
    float t49 = t45 * mad(t48, t47, mad(mad(0.03209764, t46, 0.09996679), t46, 1.0000004));
    float t50 = t29 * t49;
    float t51 = 2.0 - t50;
    float t52 = t49 * t51;
    float t53 = sqrt(t52);
    float side, t54, t55, t56, t57;
    if (t16) {
        float t58 = t24 - t25 < 0.0 ? t50 : t51;
        if (t5) {
            float t59 = light.height * (1.0 - t52 * t19);
            float t60 = sqrt(light.height * (2.0 - t59));
            t56 = (t58 - 1.0) * t60;
            float t61 = 1.0 - t59;
            t55 = mad(light.elevation_sin, t61, light.elevation_cos * t56);
            t54 = mad(light.elevation_cos, t61, -(light.elevation_sin * t56));
            side = t53 * t18 * t60;
            t57 = t55 * light.on_surface;
        } else {
            float t62 = 1.0 - t58;
            float t63 = light.radius_sin * light.radius_sin * t19;
            float t64 = max(0.0, mad(light.climb, t58, -light.rise));
            t55 = sqrt(mad(t52, t63, t64 * t64));
            float t65 = t2 * light.radius_cos;
            float t66 = light.climb * t62;
            t56 = mad(light.elevation_cos, mad(t66, t66 - 2.0 * t65, t52 * t63) / (t55 + t65), -(light.half_axis * t2 * t62));
            t54 = mad(light.half_axis, t62, light.middle);
            side = light.radius_sin * t53 * t18;
            t57 = t55;
        }
    } else {
        t55 = t53 * t26;
        t54 = 1.0 - t50;
        side = t53 * t18;
        t56 = mad(light.elevation_cos, t55, -((t14 ? -t2 : t2) * t54));
        t57 = t55;
    }
    float t67 = t8 ? 1.0 : -1.0;
    float zenith = t56 * t67;
    float cosine = t57 * t67;
    float t68 = t55 * t67;
    float t69 = min(3.4028235e38, abs(cosine));
    float t70 = 0.0 < cosine ? light.density_above : cosine < 0.0 ? light.density_below : 0.0;
    float t71 = min(3.4028235e38, t70 + min(3.4028235e38, light.density / max(1.1754944e-38, t69)));
    float t72 = mad(zenith, zenith, side * side);
    float t73 = max(0.0, mad(light.radius_sin, light.radius_sin, -t72));
    float t74 = sqrt(t73);
    float t75 = sqrt(mad(light.radius_cos, light.radius_cos, t73));
    float t76 = light.radius_cos * light.radius_cos / (t75 + t74);
    float t77 = 1.0 / light.radius_sin;
    float t78 = t76 * t77;
    float t79 = -mad(t75, t74, t72) * t77;
    float t80 = t78 * zenith;
    float t81 = t78 * side;
    float t82 = mad(light.elevation_cos, t79, -(light.elevation_sin * t80));
    float t83 = mad(light.elevation_sin, t79, light.elevation_cos * t80);
    spherecap_sample result = {
        light.third_axis * t54 + light.sideways * side + light.up * t68, t76 * light.distance,
        light.third_axis * t82 + light.sideways * t81 + light.up * t83, cosine, mad(t70, t69, light.density),
        t71
    };
    return result;
}

spherecap_sample spherecap_both_sample_once(float3 normal, float3 centre, float radius, float defensive, float u0, float u1) {
    spherecap_both_light light = spherecap_both_prepare(normal, centre, radius, defensive);
    return spherecap_both_sample(light, u0, u1);
}

float spherecap_both_pdf_direction(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    bool t2 = dot(light.towards_centre, direction) < 0.0;
    float t3 = t2 ? 1.0 : dot(cross(light.towards_centre, light.sideways), direction);
    float t4 = t2 ? 1.0 : dot(light.sideways, direction);
    float t5 = mad(0.0 < t1 ? light.density_above : t1 < 0.0 ? light.density_below : 0.0, min(3.4028235e38, abs(t1)), light.density);
    float t6 = mad(t3, t3, t4 * t4) <= light.radius_sin * light.radius_sin * 1.0000019 ? t5 : 0.0;
    float t7 = dot(direction, direction);
    return (0.998001 <= t7 && t7 <= 1.002001) ? t6 : 0.0;
}

float spherecap_both_pdf_on_sphere(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    float t2 = mad(0.0 < t1 ? light.density_above : t1 < 0.0 ? light.density_below : 0.0, min(3.4028235e38, abs(t1)), light.density);
    float t3 = dot(direction, direction);
    return (0.998001 <= t3 && t3 <= 1.002001) ? t2 : 0.0;
}

float spherecap_both_importance(float3 normal, float3 centre, float radius, float defensive, float strength) {
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
        float t9 = max(1.1754944e-38, sqrt(mad(t6, t6, mad(t7, t7, t8 * t8))));
        t1 = t6 / t9;
        t2 = t7 / t9;
        t3 = t8 / t9;
    }
    bool t10 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    float t11 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t11));
    float t12 = t10 ? 1.0 : spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t13 = centre.x * t12;
    float t14 = centre.y * t12;
    float t15 = centre.z * t12;
    float t16 = radius * t12;
    float t17 = sqrt(mad(t13, t13, mad(t14, t14, t15 * t15)));
    float t18 = 1.0 / t17;
    float t19 = t16 * t18;
    float t20 = t19 * t19;
    float t21 = mad(t1, t1, mad(t2, t2, t3 * t3));
    bool t22 = 0.0 <= defensive && defensive <= 1.0 && t21 <= 2.0 && 0.0 < radius && t17 * (t10 ? 1.0 : unscale) <= 3.4028235e38;
    float t23 = mad(t1, t13, mad(t2, t14, t3 * t15));
    float t24 = max(0.0, mad(-t20, t20, 0.9999981));
    float t25 = mad(t23, t18, 2.3841858e-7);
    float t26 = mad(t23 + t16, t18, 2.3841858e-7);
    float t27 = t19 <= t25 ? t25 : 0.0 < t26 ? t26 * t26 / (mad(t19 - t25, t24, t26) * 2.0) : 0.0;
    float t28 = mad(-t23, t18, 2.3841858e-7);
    float t29 = mad(-t23 + t16, t18, 2.3841858e-7);
    float t30 = t19 <= t28 ? t28 : 0.0 < t29 ? t29 * t29 / (mad(t19 - t28, t24, t29) * 2.0) : 0.0;
    float t31 = t27 + t30;
    float t32 = t21 <= 0.0 ? 1.0 : mad(defensive, 0.5 - t31, t31);
    bool t33 = t20 <= 1.0000019 && 4.9303807e-32 < t20 && 0.0 < strength && t22 && strength <= 3.4028235e38;
    float t34 = ((0.0 < t32 || 0.0 < defensive) && t33) ? min(3.4028235e38, max(1.1754944e-38, t20 * t32 * strength)) : 0.0;
    return t34;
}


#endif
