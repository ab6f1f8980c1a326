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
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    float t88 = t62 ? inv_above : 0.0;
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
    bool t117 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    float t118 = t117 ? ((0.0 < radius_cos && t86) ? t84 / (1.0 + radius_cos) : 0.0) * 6.2831855 : 0.0;
    spherecap_surface_light result = {
        t117, t118, t117 ? projected_above : 0.0, towards_centre, sideways, normal, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, inv_above,
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
    float t41 = t7 ? min(1.0, t40) : t40;
    float t42 = t20 * t41;
    float t43 = 2.0 - t42;
    float t44 = t41 * t43;
    float t45 = sqrt(t44);
    float zenith, side, cosine, t46;
    if (t7) {
        float t47 = t15 - t16 < 0.0 ? t42 : t43;
        float t48 = 1.0 - t47;
        float t49 = light.radius_sin * light.radius_sin * t10;
        float t50 = max(0.0, mad(light.climb, t47, -light.rise));
        cosine = sqrt(mad(t44, t49, t50 * t50));
        float t51 = t1 * light.radius_cos;
        float t52 = light.climb * t48;
        zenith = mad(light.elevation_cos, mad(t52, t52 - 2.0 * t51, t44 * t49) / (cosine + t51), -(light.half_axis * t1 * t48));
        side = light.radius_sin * t45 * t9;
        t46 = mad(light.half_axis, t48, light.middle);
    } else {
        cosine = t45 * t17;
        t46 = 1.0 - t42;
        zenith = mad(light.elevation_cos, cosine, -((t5 ? -t1 : t1) * t46));
        side = t45 * t9;
    }
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
        light.third_axis * t46 + light.sideways * side + light.normal * cosine, t57 * light.distance,
        light.third_axis * t63 + light.sideways * t62 + light.normal * t64, cosine,
        light.inv_above * min(3.4028235e38, max(0.0, cosine)), 0.0 < cosine ? light.inv_above : 0.0
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
    float t4 = light.inv_above * min(3.4028235e38, max(0.0, dot(light.normal, direction)));
    float t5 = mad(t2, t2, t3 * t3) <= light.radius_sin * light.radius_sin * 1.0000019 ? t4 : 0.0;
    float t6 = dot(direction, direction);
    return (0.998001 <= t6 && t6 <= 1.002001) ? t5 : 0.0;
}

float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = light.inv_above * min(3.4028235e38, max(0.0, dot(light.normal, direction)));
    float t2 = dot(direction, direction);
    return (0.998001 <= t2 && t2 <= 1.002001) ? t1 : 0.0;
}

float spherecap_surface_importance(float3 normal, float3 centre, float radius, float strength) {
    float t1 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t1));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t2 = centre.x * scale;
    float t3 = centre.y * scale;
    float t4 = centre.z * scale;
    float t5 = radius * scale;
    float t6 = sqrt(mad(t2, t2, mad(t3, t3, t4 * t4)));
    float t7 = 1.0 / t6;
    float t8 = t5 * t7;
    float t9 = t8 * t8;
    bool t10 = 0.0 < radius && t6 * unscale <= 3.4028235e38 && 0.0 < strength && strength <= 3.4028235e38;
    float t11 = mad(normal.x, t2, mad(normal.y, t3, normal.z * t4));
    float t12 = mad(t11, t7, 2.3841858e-7);
    float t13 = mad(t11 + t5, t7, 2.3841858e-7);
    float t14 = t13 * t13 / (mad(t8 - t12, max(0.0, mad(-t9, t9, 0.9999981)), t13) * 2.0);
    float t15 = t8 <= t12 ? t12 : 0.0 < t13 ? t14 : 0.0;
    float t16 = mad(0.0, 0.5 - t15, t15);
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
    float inv_above = t100 ? 1.0 / projected_above : 0.0;
    float t101 = t74 ? inv_above : 0.0;
    bool t102 = t73 && t74 && 0.0 < t101;
    float t103 = t_y * t_y * t_y * shape * t101;
    float t104 = t_y / radius_sin;
    float t105 = t104 * t104 * t104 * (mad(cut - t_x, shape_difference, shape) * 0.53033006);
    float b_0 = 0.0, b_1 = 0.0, b_2 = 0.0, b_3 = 0.0, b_4 = 0.0, b_5 = 0.0, b_6 = 0.0;
    if (t73 && !t74) {
        float t106 = 1.0 + kappa;
        float t107 = t106 * shape;
        float t108 = 1.0 / (norm * t107);
        float t109 = sqrt(t108);
        b_0 = norm * t109;
        float t110 = 1.0 / (1.0 + cut);
        float t111 = (t_x + kappa) * t110 - 0.5;
        float t112 = t111 * t111 * t111;
        float t113 = mad(mad(mad(-0.026061837, t111, 0.05430631), t111, -0.06372378), t112, mad(mad(0.080950715, t111, -0.11762552), t111, 0.1684019));
        float t114 = mad(t113, t112, mad(mad(-0.23594604, t111, 0.32709444), t111, -0.44721135));
        float t115 = t106 * mad(t114, t112, mad(mad(0.5987523, t111, -0.7754678), t111, 0.94559944));
        float t116 = t115 * (t110 * t110 * t110) * (t107 * t108);
        float t117 = mad(t116, t107 * t109, -1.0);
        float t118 = 1.0 - t116;
        float t119 = mad(mad(30.011856, t117, mad(-41.541264, t118, -37.009792)), t117, mad(77.96775, t118, 7.470758));
        float t120 = mad(mad(mad(15.716111 * t118, t118, 9.961183), t118, -2.61785), t118, 0.8681748);
        float t121 = mad(mad(t119, t117, mad(mad(-49.13454, t118, -9.466533), t118, -1.5877596)), t117, t120);
        float t122 = t117 * t121;
        float t123 = mad(mad(7.295638, t117, -7.236236), t117, mad(-11.4868555 * t118 * t118, t118, 3.1255686));
        float t124 = mad(mad(mad(13.728438, t118, -7.981878), t118, 2.025724), t118, -0.7334958);
        float t125 = t117 * mad(t123, t117, t124);
        float t126 = mad(mad(-23.220068, t118, 7.332055), t117, mad(mad(9.986537, t118, 25.22195) * t118, t118, -2.9581387));
        float t127 = mad(mad(mad(-19.722994, t118, 4.6594768), t118, -0.89538246), t118, 0.5143498);
        float t128 = t117 * mad(t126, t117, t127);
        float t129 = mad(mad(mad(1.946617, t117, -3.077631), t117, 1.4945927), t117, -0.24140751);
        float t130 = t117 * t129;
        float t131 = t117 * mad(mad(0.38173297, t117, -0.30305624), t117, 0.05897375);
        b_1 = t116 - b_0 + t122;
        b_2 = t125 - t122;
        b_3 = t128 - t125;
        b_4 = t130 - t128;
        b_5 = t131 - t130;
        b_6 = -t131;
    }
    float share = ((0.0 < defensive || !(0.0 < on_surface)) && !t100) ? 1.0 : defensive;
    bool t132 = 0.0 < share;
    float t133 = (0.0 < radius_cos && t98) ? t96 / (1.0 + radius_cos) : 0.0;
    float inv_solid_angle = t132 ? (0.0 < t133 ? 0.15915494 / t133 : 0.0) : 0.0;
    bool t134 = 0.0 < inv_solid_angle && t132;
    bool t135 = 0.0 <= defensive && defensive <= 1.0 && t7 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && (0.0 < inv_above || t134);
    spherecap_front_light result = {
        t135, t135 ? t133 * 6.2831855 : 0.0, t135 ? projected_above : 0.0, towards_centre, sideways,
        float3(normal_x, normal_y, normal_z), float3(up_x, up_y, up_z), on_surface, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, share, 1.0 - share,
        defensive, inv_above,
        float3(mad(sideways.y, up_z, -(sideways.z * up_y)), mad(sideways.z, up_x, -(sideways.x * up_z)), mad(sideways.x, up_y, -(sideways.y * up_x))),
        t132 ? t133 : 0.0, inv_solid_angle, t102 ? t103 : 0.0, t102 ? 1.0 / (1.0 - t103) : 1.0,
        t102 ? t105 : 0.0, elevation_cos * radius_cos, radius_sin * t95, climb, b_0, b_1, b_2, b_3, b_4, b_5,
        b_6
    };
    return result;
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
    float t7 = (0.0 < light.requested && t2) ? min(0.99999994, t6) : t3;
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
    float t18 = 1.6660811 - t17;
    float t19 = mad(t16, t18, t17);
    float t20 = (1.0 - t16) * t18;
    float t22, t23, t24;
    float t21 = 0.0;
    if (t11) {
        t22 = min(t20, t19);
        t23 = 1.0;
        t24 = 1.0;
    } else {
        float t25 = sqrt(t14);
        float t26 = mad(mad(mad(light.b_5, t14, light.b_3), t14, light.b_1), t25, mad(mad(mad(light.b_6, t14, light.b_4), t14, light.b_2), t14, light.b_0));
        float t27 = t25 * t26;
        float t28 = sqrt(mad(t13, t13, t27 * t27));
        float t29 = light.tau * t27;
        t24 = t9 ? mad(t13, t13, t29 * t29) : 1.0;
        float t30 = t9 ? mad(light.kappa, t27, t28) * mad(light.cut, t27, t28) : light.crescent_share;
        float t31 = (t9 ? light.width : t7) / t30;
        float t32 = t9 ? t31 : light.width;
        float t33 = t24 * t32;
        float t34 = mad(mad(mad(-0.00060778117, t33, 1.0676054e-5), t33, -0.0027203285), t33 * t33 * t33, mad(mad(-0.011332183, t33, -0.10000902), t33, 1.0000001));
        t21 = t9 ? t29 : t25;
        t22 = t9 ? t7 : min(0.99999994, max(5.9604645e-8, t31));
        t23 = t32 * t34;
    }
    float t35 = spherecap_float_of_bits(mad(spherecap_bits(t22), -0.33333334, 1419900500.0));
    float t36 = t22 * t35;
    float t37 = mad(-t36, t35 * t35, 1.0);
    float t38 = t37 * t37;
    float t39 = mad(mad(0.12666093, t38, mad(0.14565912, t37, 0.17283025)), t38, mad(0.22221696, t37, 0.33333334));
    float t40 = t23 * mad(t36 * t37, t39, t36);
    float t41 = t40 * t24;
    float t42 = t41 * t41 * t41;
    float t43 = mad(mad(mad(0.022114987, t41, -0.063446075), t41, 0.085662976), t42, mad(mad(-0.056249518, t41, 0.030445365), t41, 0.0074712755));
    float t44 = t40 * mad(t43, t42, mad(mad(0.03209764, t41, 0.09996679), t41, 1.0000004));
    float t45 = t11 ? min(1.0, t44) : t44;
    float t46 = t24 * t45;
    float t47 = 2.0 - t46;
    float t48 = t45 * t47;
    float t49 = sqrt(t48);
    float zenith, side, cosine, t50, t51;
    if (t11) {
        float t52 = t19 - t20 < 0.0 ? t46 : t47;
        if (t5) {
            float t53 = light.height * (1.0 - t48 * t14);
            float t54 = sqrt(light.height * (2.0 - t53));
            zenith = (t52 - 1.0) * t54;
            float t55 = 1.0 - t53;
            t51 = mad(light.elevation_sin, t55, light.elevation_cos * zenith);
            t50 = mad(light.elevation_cos, t55, -(light.elevation_sin * zenith));
            side = t49 * t13 * t54;
            cosine = t51 * light.on_surface;
        } else {
            float t56 = 1.0 - t52;
            float t57 = light.radius_sin * light.radius_sin * t14;
            float t58 = max(0.0, mad(light.climb, t52, -light.rise));
            t51 = sqrt(mad(t48, t57, t58 * t58));
            float t59 = t1 * light.radius_cos;
            float t60 = light.climb * t56;
            zenith = mad(light.elevation_cos, mad(t60, t60 - 2.0 * t59, t48 * t57) / (t51 + t59), -(light.half_axis * t1 * t56));
            t50 = mad(light.half_axis, t56, light.middle);
            side = light.radius_sin * t49 * t13;
            cosine = t51;
        }
    } else {
        cosine = t49 * t21;
        t50 = 1.0 - t46;
        zenith = mad(light.elevation_cos, cosine, -((t9 ? -t1 : t1) * t50));
        side = t49 * t13;
        t51 = cosine;
    }
    float t61 = light.share * light.inv_solid_angle;
    float t62 = 0.0 < cosine ? light.inv_above : 0.0;
    float t63 = min(3.4028235e38, max(0.0, cosine));
    float t64 = min(3.4028235e38, t61 / max(1.1754944e-38, min(3.4028235e38, abs(cosine))));
    float t65 = mad(zenith, zenith, side * side);
    float t66 = max(0.0, mad(light.radius_sin, light.radius_sin, -t65));
    float t67 = sqrt(t66);
    float t68 = sqrt(mad(light.radius_cos, light.radius_cos, t66));
    float t69 = light.radius_cos * light.radius_cos / (t68 + t67);
    float t70 = 1.0 / light.radius_sin;
    float t71 = t69 * t70;
    float t72 = -mad(t68, t67, t65) * t70;
    float t73 = t71 * zenith;
    float t74 = t71 * side;
    float t75 = mad(light.elevation_cos, t72, -(light.elevation_sin * t73));
    float t76 = mad(light.elevation_sin, t72, light.elevation_cos * t73);
    spherecap_sample result = {
        light.third_axis * t50 + light.sideways * side + light.up * t51, t69 * light.distance,
        light.third_axis * t75 + light.sideways * t74 + light.up * t76, cosine,
        t2 ? mad(light.inv_above, light.rest * t63, t61) : light.inv_above * t63,
        t2 ? min(3.4028235e38, mad(t62, light.rest, t64)) : t62
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
    float t4 = min(3.4028235e38, max(0.0, dot(light.normal, direction)));
    float t5 = mad(light.inv_above, light.rest * t4, light.share * light.inv_solid_angle);
    float t6 = mad(t2, t2, t3 * t3) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.share ? t5 : light.inv_above * t4) : 0.0;
    float t7 = dot(direction, direction);
    return (0.998001 <= t7 && t7 <= 1.002001) ? t6 : 0.0;
}

float spherecap_front_pdf_on_sphere(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = min(3.4028235e38, max(0.0, dot(light.normal, direction)));
    float t2 = mad(light.inv_above, light.rest * t1, light.share * light.inv_solid_angle);
    float t3 = dot(direction, direction);
    float t4 = (0.998001 <= t3 && t3 <= 1.002001) ? (0.0 < light.share ? t2 : light.inv_above * t1) : 0.0;
    return t4;
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
    float t10 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t10));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t11 = centre.x * scale;
    float t12 = centre.y * scale;
    float t13 = centre.z * scale;
    float t14 = radius * scale;
    float t15 = sqrt(mad(t11, t11, mad(t12, t12, t13 * t13)));
    float t16 = 1.0 / t15;
    float t17 = t14 * t16;
    float t18 = t17 * t17;
    float t19 = mad(t1, t1, mad(t2, t2, t3 * t3));
    bool t20 = 0.0 <= defensive && defensive <= 1.0 && t19 <= 2.0 && 0.0 < radius && t15 * unscale <= 3.4028235e38;
    float t21 = mad(t1, t11, mad(t2, t12, t3 * t13));
    float t22 = mad(t21, t16, 2.3841858e-7);
    float t23 = mad(t21 + t14, t16, 2.3841858e-7);
    float t24 = t23 * t23 / (mad(t17 - t22, max(0.0, mad(-t18, t18, 0.9999981)), t23) * 2.0);
    float t25 = t17 <= t22 ? t22 : 0.0 < t23 ? t24 : 0.0;
    float t26 = t19 <= 0.0 ? 1.0 : mad(defensive, 0.5 - t25, t25);
    bool t27 = t18 <= 1.0000019 && 4.9303807e-32 < t18 && 0.0 < strength && t20 && strength <= 3.4028235e38;
    float t28 = ((0.0 < t26 || 0.0 < defensive) && t27) ? min(3.4028235e38, max(1.1754944e-38, t18 * t26 * strength)) : 0.0;
    return t28;
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
    float inv_above = t103 ? 1.0 / projected_above : 0.0;
    float inv_below = t104 ? 1.0 / projected_below : 0.0;
    float t105 = t74 ? inv_above : inv_below;
    bool t106 = 0.0 < t105 && t73;
    float t107 = t_y * t_y * t_y * shape * t105;
    float t108 = t_y / radius_sin;
    float t109 = mad(cut - t_x, shape_difference, shape);
    float b_0 = 0.0, b_1 = 0.0, b_2 = 0.0, b_3 = 0.0, b_4 = 0.0, b_5 = 0.0, b_6 = 0.0;
    if (t73) {
        float t110 = 1.0 + kappa;
        float t111 = t110 * shape;
        float t112 = 1.0 / (norm * t111);
        float t113 = sqrt(t112);
        b_0 = norm * t113;
        float t114 = 1.0 / (1.0 + cut);
        float t115 = (t_x + kappa) * t114 - 0.5;
        float t116 = t115 * t115 * t115;
        float t117 = mad(mad(mad(-0.026061837, t115, 0.05430631), t115, -0.06372378), t116, mad(mad(0.080950715, t115, -0.11762552), t115, 0.1684019));
        float t118 = mad(t117, t116, mad(mad(-0.23594604, t115, 0.32709444), t115, -0.44721135));
        float t119 = t110 * mad(t118, t116, mad(mad(0.5987523, t115, -0.7754678), t115, 0.94559944));
        float t120 = t119 * (t114 * t114 * t114) * (t111 * t112);
        float t121 = mad(t120, t111 * t113, -1.0);
        float t122 = 1.0 - t120;
        float t123 = mad(mad(30.011856, t121, mad(-41.541264, t122, -37.009792)), t121, mad(77.96775, t122, 7.470758));
        float t124 = mad(mad(mad(15.716111 * t122, t122, 9.961183), t122, -2.61785), t122, 0.8681748);
        float t125 = mad(mad(t123, t121, mad(mad(-49.13454, t122, -9.466533), t122, -1.5877596)), t121, t124);
        float t126 = t121 * t125;
        float t127 = mad(mad(7.295638, t121, -7.236236), t121, mad(-11.4868555 * t122 * t122, t122, 3.1255686));
        float t128 = mad(mad(mad(13.728438, t122, -7.981878), t122, 2.025724), t122, -0.7334958);
        float t129 = t121 * mad(t127, t121, t128);
        float t130 = mad(mad(-23.220068, t122, 7.332055), t121, mad(mad(9.986537, t122, 25.22195) * t122, t122, -2.9581387));
        float t131 = mad(mad(mad(-19.722994, t122, 4.6594768), t122, -0.89538246), t122, 0.5143498);
        float t132 = t121 * mad(t130, t121, t131);
        float t133 = mad(mad(mad(1.946617, t121, -3.077631), t121, 1.4945927), t121, -0.24140751);
        float t134 = t121 * t133;
        float t135 = t121 * mad(mad(0.38173297, t121, -0.30305624), t121, 0.05897375);
        b_1 = t120 - b_0 + t126;
        b_2 = t129 - t126;
        b_3 = t132 - t129;
        b_4 = t134 - t132;
        b_5 = t135 - t134;
        b_6 = -t135;
    }
    float defensive_share = (!(t103 || t104) && (0.0 < defensive || !(0.0 < on_surface))) ? 1.0 : defensive;
    bool t136 = 0.0 < defensive_share;
    float t137 = (0.0 < radius_cos && t100) ? t96 / (1.0 + radius_cos) : 0.0;
    float inv_solid_angle = t136 ? (0.0 < t137 ? 0.15915494 / t137 : 0.0) : 0.0;
    float t138 = 0.0;
    if (0.0 < tau) {
        float t139 = 1.0 / (elevation_cos * elevation_cos);
        float t140 = tau * tau;
        float t141 = t140 * t139 / (1.0 + t_x);
        float t142 = kappa - 0.5;
        float t143 = cut - 0.5;
        float t144 = t142 * t142;
        float t145 = t143 * t143;
        float t146 = mad(0.05430631, t144, 0.080950715);
        float t147 = mad(t146, t144, 0.1684019);
        float t148 = mad(t147, t144, 0.32709444);
        float t149 = mad(mad(mad(mad(0.05430631, t145, t146), t145, t147), t145, t148), t145, mad(t148, t144, 0.5987523));
        float t150 = mad(-0.026061837, t144, -0.06372378);
        float t151 = mad(t150, t144, -0.11762552);
        float t152 = mad(t151, t144, -0.23594604);
        float t153 = mad(t152, t144, -0.44721135);
        float t154 = mad(mad(mad(mad(-0.026061837, t145, t150), t145, t151), t145, t152), t145, t153);
        float t155 = mad(kappa * t141, mad(mad(t143, t154, t149), t142 + t143, mad(t153, t144, -0.7754678)), mad(t109, t141 - kappa * kappa, kappa) * t139);
        t138 = min(0.5, max(0.0, t140 * tau * (radius_cos + 1.0) * t155 * 0.31830987));
    }
    float t156 = 1.0 - t138;
    bool t157 = 0.0 < inv_below;
    bool t158 = 0.0 < inv_above;
    bool t159 = 0.0 < inv_solid_angle && t136;
    bool t160 = 0.0 <= defensive && defensive <= 1.0 && t7 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && (0.0 < inv_above + inv_below || t159);
    spherecap_both_light result = {
        t160, t160 ? t137 * 6.2831855 : 0.0, t160 ? projected_above : 0.0, towards_centre, sideways,
        float3(normal_x, normal_y, normal_z), float3(up_x, up_y, up_z), on_surface, distance, radius_sin,
        radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, defensive_share,
        1.0 - defensive_share, defensive, inv_above, inv_below,
        t157 ? (t158 ? (t74 ? t156 : t138) : 0.0) : 1.0, t158 ? (t157 ? (t74 ? t138 : t156) : 0.0) : 1.0,
        float3(mad(sideways.y, up_z, -(sideways.z * up_y)), mad(sideways.z, up_x, -(sideways.x * up_z)), mad(sideways.x, up_y, -(sideways.y * up_x))),
        t136 ? t137 : 0.0, inv_solid_angle, t106 ? t107 : 0.0, t106 ? 1.0 / (1.0 - t107) : 1.0,
        t106 ? t108 * t108 * t108 * (t109 * 0.53033006) : 0.0, elevation_cos * radius_cos, radius_sin * t95,
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
    bool t3 = 0.0 < light.defensive_share;
    float t4 = min(0.99999994, max(5.9604645e-8, u0));
    float t5 = min(0.99999994, max(5.9604645e-8, u1));
    bool t6 = t4 < light.defensive_share && t3;
    float t7 = (t6 ? t4 : t4 - light.defensive_share) / (t6 ? light.defensive_share : light.defensive_rest);
    float t8 = (0.0 < light.requested && t3) ? min(0.99999994, max(5.9604645e-8, t7)) : t4;
    bool t9 = t8 < light.sides_share || t6;
    float t10 = (t9 ? t8 : t8 - light.sides_share) / (t9 ? light.sides_share : light.sides_rest);
    bool t11 = t9 && t1;
    bool t12 = !t9 && !t1;
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
    float t24 = 1.6660811 - t23;
    float t25 = mad(t22, t24, t23);
    float t26 = (1.0 - t22) * t24;
    float t28, t29, t30;
    float t27 = 0.0;
    if (t17) {
        t28 = min(t26, t25);
        t29 = 1.0;
        t30 = 1.0;
    } else {
        float t31 = sqrt(t20);
        float t32 = mad(mad(mad(light.b_5, t20, light.b_3), t20, light.b_1), t31, mad(mad(mad(light.b_6, t20, light.b_4), t20, light.b_2), t20, light.b_0));
        float t33 = t31 * t32;
        float t34 = sqrt(mad(t19, t19, t33 * t33));
        float t35 = light.tau * t33;
        t30 = t15 ? mad(t19, t19, t35 * t35) : 1.0;
        float t36 = t15 ? mad(light.kappa, t33, t34) * mad(light.cut, t33, t34) : light.crescent_share;
        float t37 = (t15 ? light.width : t13) / t36;
        float t38 = t15 ? t37 : light.width;
        float t39 = t30 * t38;
        float t40 = mad(mad(mad(-0.00060778117, t39, 1.0676054e-5), t39, -0.0027203285), t39 * t39 * t39, mad(mad(-0.011332183, t39, -0.10000902), t39, 1.0000001));
        t27 = t15 ? t35 : t31;
        t28 = t15 ? t13 : min(0.99999994, max(5.9604645e-8, t37));
        t29 = t38 * t40;
    }
    float t41 = spherecap_float_of_bits(mad(spherecap_bits(t28), -0.33333334, 1419900500.0));
    float t42 = t28 * t41;
    float t43 = mad(-t42, t41 * t41, 1.0);
    float t44 = t43 * t43;
    float t45 = mad(mad(0.12666093, t44, mad(0.14565912, t43, 0.17283025)), t44, mad(0.22221696, t43, 0.33333334));
    float t46 = t29 * mad(t42 * t43, t45, t42);
    float t47 = t46 * t30;
    float t48 = t47 * t47 * t47;
    float t49 = mad(mad(mad(0.022114987, t47, -0.063446075), t47, 0.085662976), t48, mad(mad(-0.056249518, t47, 0.030445365), t47, 0.0074712755));
    float t50 = t46 * mad(t49, t48, mad(mad(0.03209764, t47, 0.09996679), t47, 1.0000004));
    float t51 = t17 ? min(1.0, t50) : t50;
    float t52 = t30 * t51;
    float t53 = 2.0 - t52;
    float t54 = t51 * t53;
    float t55 = sqrt(t54);
    float side, t56, t57, t58, t59;
    if (t17) {
        float t60 = t25 - t26 < 0.0 ? t52 : t53;
        if (t6) {
            float t61 = light.height * (1.0 - t54 * t20);
            float t62 = sqrt(light.height * (2.0 - t61));
            t58 = (t60 - 1.0) * t62;
            float t63 = 1.0 - t61;
            t57 = mad(light.elevation_sin, t63, light.elevation_cos * t58);
            t56 = mad(light.elevation_cos, t63, -(light.elevation_sin * t58));
            side = t55 * t19 * t62;
            t59 = t57 * light.on_surface;
        } else {
            float t64 = 1.0 - t60;
            float t65 = light.radius_sin * light.radius_sin * t20;
            float t66 = max(0.0, mad(light.climb, t60, -light.rise));
            t57 = sqrt(mad(t54, t65, t66 * t66));
            float t67 = t2 * light.radius_cos;
            float t68 = light.climb * t64;
            t58 = mad(light.elevation_cos, mad(t68, t68 - 2.0 * t67, t54 * t65) / (t57 + t67), -(light.half_axis * t2 * t64));
            t56 = mad(light.half_axis, t64, light.middle);
            side = light.radius_sin * t55 * t19;
            t59 = t57;
        }
    } else {
        t57 = t55 * t27;
        t56 = 1.0 - t52;
        side = t55 * t19;
        t58 = mad(light.elevation_cos, t57, -((t15 ? -t2 : t2) * t56));
        t59 = t57;
    }
    float t69 = t9 ? 1.0 : -1.0;
    float zenith = t58 * t69;
    float cosine = t59 * t69;
    float t70 = t57 * t69;
    float t71 = light.defensive_share * light.inv_solid_angle;
    float t72 = min(3.4028235e38, abs(cosine));
    float t73 = 0.0 < cosine ? light.inv_above * light.sides_share : cosine < 0.0 ? light.inv_below * light.sides_rest : 0.0;
    float t74 = mad(t73, light.defensive_rest, min(3.4028235e38, t71 / max(1.1754944e-38, t72)));
    float t75 = mad(zenith, zenith, side * side);
    float t76 = max(0.0, mad(light.radius_sin, light.radius_sin, -t75));
    float t77 = sqrt(t76);
    float t78 = sqrt(mad(light.radius_cos, light.radius_cos, t76));
    float t79 = light.radius_cos * light.radius_cos / (t78 + t77);
    float t80 = 1.0 / light.radius_sin;
    float t81 = t79 * t80;
    float t82 = -mad(t78, t77, t75) * t80;
    float t83 = t81 * zenith;
    float t84 = t81 * side;
    float t85 = mad(light.elevation_cos, t82, -(light.elevation_sin * t83));
    float t86 = mad(light.elevation_sin, t82, light.elevation_cos * t83);
    spherecap_sample result = {
        light.third_axis * t56 + light.sideways * side + light.up * t70, t79 * light.distance,
        light.third_axis * t85 + light.sideways * t84 + light.up * t86, cosine,
        t3 ? mad(t73, light.defensive_rest * t72, t71) : t73 * t72, t3 ? min(3.4028235e38, t74) : t73
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
    float t5 = min(3.4028235e38, abs(t1));
    float t6 = 0.0 < t1 ? light.inv_above * light.sides_share : t1 < 0.0 ? light.inv_below * light.sides_rest : 0.0;
    float t7 = mad(t6, light.defensive_rest * t5, light.defensive_share * light.inv_solid_angle);
    float t8 = mad(t3, t3, t4 * t4) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.defensive_share ? t7 : t6 * t5) : 0.0;
    float t9 = dot(direction, direction);
    return (0.998001 <= t9 && t9 <= 1.002001) ? t8 : 0.0;
}

float spherecap_both_pdf_on_sphere(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = dot(light.normal, direction);
    float t2 = min(3.4028235e38, abs(t1));
    float t3 = 0.0 < t1 ? light.inv_above * light.sides_share : t1 < 0.0 ? light.inv_below * light.sides_rest : 0.0;
    float t4 = mad(t3, light.defensive_rest * t2, light.defensive_share * light.inv_solid_angle);
    float t5 = dot(direction, direction);
    float t6 = (0.998001 <= t5 && t5 <= 1.002001) ? (0.0 < light.defensive_share ? t4 : t3 * t2) : 0.0;
    return t6;
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
    float t10 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    float unscale = spherecap_power_of_two(min(8.5070587e37, t10));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t11 = centre.x * scale;
    float t12 = centre.y * scale;
    float t13 = centre.z * scale;
    float t14 = radius * scale;
    float t15 = sqrt(mad(t11, t11, mad(t12, t12, t13 * t13)));
    float t16 = 1.0 / t15;
    float t17 = t14 * t16;
    float t18 = t17 * t17;
    float t19 = mad(t1, t1, mad(t2, t2, t3 * t3));
    bool t20 = 0.0 <= defensive && defensive <= 1.0 && t19 <= 2.0 && 0.0 < radius && t15 * unscale <= 3.4028235e38;
    float t21 = mad(t1, t11, mad(t2, t12, t3 * t13));
    float t22 = max(0.0, mad(-t18, t18, 0.9999981));
    float t23 = mad(t21, t16, 2.3841858e-7);
    float t24 = mad(t21 + t14, t16, 2.3841858e-7);
    float t25 = t17 <= t23 ? t23 : 0.0 < t24 ? t24 * t24 / (mad(t17 - t23, t22, t24) * 2.0) : 0.0;
    float t26 = mad(-t21, t16, 2.3841858e-7);
    float t27 = mad(-t21 + t14, t16, 2.3841858e-7);
    float t28 = t17 <= t26 ? t26 : 0.0 < t27 ? t27 * t27 / (mad(t17 - t26, t22, t27) * 2.0) : 0.0;
    float t29 = t25 + t28;
    float t30 = t19 <= 0.0 ? 1.0 : mad(defensive, 0.5 - t29, t29);
    bool t31 = t18 <= 1.0000019 && 4.9303807e-32 < t18 && 0.0 < strength && t20 && strength <= 3.4028235e38;
    float t32 = ((0.0 < t30 || 0.0 < defensive) && t31) ? min(3.4028235e38, max(1.1754944e-38, t18 * t30 * strength)) : 0.0;
    return t32;
}


#endif
