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
    precise float lost = mad(a, b, -product);
#else
    // Products of halves are exact (Dekker).
    precise float a_high = asfloat(asuint(a) & 0xfffff000u);
    precise float b_high = asfloat(asuint(b) & 0xfffff000u);
    precise float a_low = a - a_high;
    precise float b_low = b - b_high;
    precise float lost = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
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
    spherecap_sample sampled;
    sampled.direction = float3(0.0, 0.0, 0.0);
    sampled.distance = 0.0;
    sampled.normal = float3(0.0, 0.0, 0.0);
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

spherecap_surface_light spherecap_surface_prepare(float3 normal, float3 centre, float radius) {
    float t1 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t2 = centre.x * scale;
    float t3 = centre.y * scale;
    float t4 = centre.z * scale;
    float t5 = radius * scale;
    precise float t6 = t2 * t2;
    precise float t7 = t3 * t3;
    precise float t8 = t4 * t4;
    precise float t9 = t6 + t7;
    precise float t10 = t9 - t6;
    precise float t11 = t9 - t10;
    precise float t12 = t6 - t11;
    precise float t13 = t7 - t10;
    precise float t14 = t9 + t8;
    precise float t15 = t14 - t9;
    precise float t16 = t14 - t15;
    precise float t17 = t9 - t16;
    precise float t18 = t8 - t15;
    float t19 = spherecap_lost(t2, t2, t6) + spherecap_lost(t3, t3, t7) + spherecap_lost(t4, t4, t8);
    precise float t20 = t5 * t5;
    float t21 = t14 - t20 + (t19 + (t12 + t13 + (t17 + t18)) - spherecap_lost(t5, t5, t20));
    bool t22 = 0.0 < t21;
    float t23 = sqrt(t14);
    float t24 = 1.0 / t23;
    precise float t25 = normal.x * t2;
    precise float t26 = normal.y * t3;
    precise float t27 = normal.z * t4;
    precise float t28 = t25 + t26;
    precise float t29 = t28 - t25;
    precise float t30 = t28 - t29;
    precise float t31 = t25 - t30;
    precise float t32 = t26 - t29;
    precise float t33 = t28 + t27;
    precise float t34 = t33 - t28;
    precise float t35 = t33 - t34;
    precise float t36 = t28 - t35;
    precise float t37 = t27 - t34;
    float t38 = spherecap_lost(normal.x, t2, t25) + spherecap_lost(normal.y, t3, t26) + spherecap_lost(normal.z, t4, t27);
    float t39 = t38 + (t31 + t32 + (t36 + t37));
    precise float t40 = t33 + t39;
    precise float t41 = t40 - t33;
    precise float t42 = t39 - t41;
    float t43 = t5 - t40 - t42;
    float t44 = t5 + t40 + t42;
    float t45 = t43 * t44;
    bool t46 = 0.0 < t45 && t22;
    precise float t47 = normal.z * t3;
    float t48 = spherecap_fused(normal.y, t4, -t47) - spherecap_lost(normal.z, t3, t47);
    precise float t49 = normal.x * t4;
    float t50 = spherecap_fused(normal.z, t2, -t49) - spherecap_lost(normal.x, t4, t49);
    precise float t51 = normal.y * t2;
    float t52 = spherecap_fused(normal.x, t3, -t51) - spherecap_lost(normal.y, t2, t51);
    float t53 = mad(t48, t48, mad(t50, t50, t52 * t52));
    bool t54 = 9.8607613e-32 < t53;
    bool t55 = abs(t2) < abs(t4);
    float t56 = t55 ? 0.0 : -t3;
    float t57 = t55 ? -t4 : t2;
    float t58 = t55 ? t3 : 0.0;
    float t59 = sqrt(spherecap_max(t21, 0.0));
    float radius_cos = t59 * t24;
    float t60 = 1.0 + radius_cos;
    float t61 = 1.0 / (t5 * t60);
    float t62 = t61 * t60;
    float radius_sin = t5 * t24;
    float inv_radius_sin = t23 * t62;
    float t63 = sqrt(t21 + t45);
    float t64 = sqrt(t54 ? t53 : mad(t56, t56, mad(t57, t57, t58 * t58)));
    float elevation_sin = t40 * t24;
    float elevation_cos = (t46 ? t63 : t54 ? t64 : 0.0) * t24;
    float t65 = abs(elevation_sin);
    float t66 = radius_sin * elevation_cos;
    float t67 = spherecap_max(mad(radius_cos, t65, t66), 9.8607613e-32);
    float t68 = 1.0 / (t67 * t64);
    float t69 = t68 * t64;
    float t70 = t68 * t67;
    float frame_2_x = (t54 ? t48 : t56) * t70;
    float frame_2_y = (t54 ? t50 : t57) * t70;
    float frame_2_z = (t54 ? t52 : t58) * t70;
    float frame_0_x = t2 * t24;
    float frame_0_y = t3 * t24;
    float frame_0_z = t4 * t24;
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
    if (t46) {
        float t71 = sqrt(t45);
        float t72 = t63 + t59;
        float t73 = 1.0 / (t63 * t72);
        float t74 = t73 * t72;
        float t75 = t59 * t74;
        float t76 = t71 * t74;
        float t77 = abs(t40) * t62;
        float t78 = t77 * t75;
        float t79 = t75 - 0.5;
        float t80 = t78 - 0.5;
        float t81 = t79 * t79;
        float t82 = t80 * t80;
        float t83 = mad(0.05430631, t81, 0.080950715);
        float t84 = mad(t83, t81, 0.1684019);
        float t85 = mad(t84, t81, 0.32709444);
        float t86 = mad(t85, t81, 0.5987523);
        float t87 = mad(-0.026061837, t81, -0.06372378);
        float t88 = mad(t87, t81, -0.11762552);
        float t89 = mad(t88, t81, -0.23594604);
        float t90 = mad(t89, t81, -0.44721135);
        float t91 = mad(t90, t81, -0.7754678);
        float t92 = mad(t91, t79, mad(t86, t81, 0.94559944));
        float t93 = mad(t80, mad(mad(mad(mad(-0.026061837, t82, t87), t82, t88), t82, t89), t82, t90), mad(mad(mad(mad(0.05430631, t82, t83), t82, t84), t82, t85), t82, t86));
        float t94 = mad(t93, t79 + t80, t91);
        float t95 = mad(t78, t94, t92);
        t_x = t75;
        t_y = t76;
        kappa = t77;
        cut = t78;
        shape = t92;
        shape_cut = mad(t78 - t75, t94, t92);
        norm = t95;
        width = t45 * t73;
        inv_cut_1 = t66 * t69;
        tau = t71 * t62;
        area = t76 * t76 * t76 * (spherecap_min(t43, t44) * t62) * t95;
    }
    float t96 = radius_sin * radius_sin;
    float t97 = elevation_sin < 0.0 ? area : t96 * t65 * 3.1415927 + area;
    bool t98 = t22 && 9.8607613e-32 < t96;
    float distance = t23 * unscale;
    float projected_above = (9.403955e-38 < t97 && t98) ? t97 : 0.0;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    bool t99 = 0.0 < elevation_sin;
    float t100 = t99 ? inv_above : 0.0;
    bool t101 = 0.0 < tau;
    bool t102 = t99 && t101 && 0.0 < t100;
    float t103 = t_y * t_y * t_y * shape * t100;
    float t104 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    if (!t99 && t101) {
        float t105 = 1.0 + kappa;
        float t106 = t105 * shape;
        float t107 = 1.0 / (norm * t106);
        float t108 = sqrt(t107);
        float t109 = norm * t108;
        float t110 = (t_x + kappa) * inv_cut_1 - 0.5;
        float t111 = t110 * t110;
        float t112 = mad(mad(mad(-0.026061837, t111, -0.06372378), t111, -0.11762552), t111, -0.23594604);
        float t113 = mad(mad(mad(0.05430631, t111, 0.080950715), t111, 0.1684019), t111, 0.32709444);
        float t114 = mad(mad(mad(t112, t111, -0.44721135), t111, -0.7754678), t110, mad(mad(t113, t111, 0.5987523), t111, 0.94559944));
        float t115 = t105 * t114 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t106 * t107);
        float t116 = mad(t115, t106 * t108, -1.0);
        float t117 = 1.0 - t115;
        float t118 = mad(mad(30.011856, t116, mad(-41.541264, t117, -37.009792)), t116, mad(77.96775, t117, 7.470758));
        float t119 = mad(mad(mad(mad(15.716111, t117, 0.0), t117, 9.961183), t117, -2.61785), t117, 0.8681748);
        float t120 = mad(mad(t118, t116, mad(mad(-49.13454, t117, -9.466533), t117, -1.5877596)), t116, t119);
        float t121 = t116 * t120;
        float t122 = mad(mad(7.295638, t116, -7.236236), t116, mad(mad(mad(-11.4868555, t117, 0.0), t117, 0.0), t117, 3.1255686));
        float t123 = mad(mad(mad(13.728438, t117, -7.981878), t117, 2.025724), t117, -0.7334958);
        float t124 = t116 * mad(t122, t116, t123);
        float t125 = mad(mad(-23.220068, t117, 7.332055), t116, mad(mad(mad(9.986537, t117, 25.22195), t117, 0.0), t117, -2.9581387));
        float t126 = mad(mad(mad(-19.722994, t117, 4.6594768), t117, -0.89538246), t117, 0.5143498);
        float t127 = t116 * mad(t125, t116, t126);
        float t128 = mad(mad(mad(1.946617, t116, -3.077631), t116, 1.4945927), t116, -0.24140751);
        float t129 = t116 * t128;
        float t130 = t116 * mad(mad(0.38173297, t116, -0.30305624), t116, 0.05897375);
        coefficients_0 = t109;
        coefficients_1 = t115 - t109 + t121;
        coefficients_2 = t124 - t121;
        coefficients_3 = t127 - t124;
        coefficients_4 = t129 - t127;
        coefficients_5 = t130 - t129;
        coefficients_6 = -t130;
    }
    bool t131 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    spherecap_surface_light light;
    light.is_sampled = t131;
    light.solid_angle = t131 ? (t98 ? t96 * (t61 * t5) * 6.2831855 : 0.0) : 0.0;
    light.projected_solid_angle = t131 ? projected_above : 0.0;
    light.frame_0 = float3(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = float3(mad(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), mad(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), mad(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = float3(frame_2_x, frame_2_y, frame_2_z);
    light.normal = float3(normal.x, normal.y, normal.z);
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
    light.rise = spherecap_max(t45 * (t24 * t24) * t69, -(radius_cos * t65));
    light.inv_above = inv_above;
    light.crescent_share = t102 ? t103 : 0.0;
    light.inv_rest = t102 ? 1.0 / (1.0 - t103) : 1.0;
    light.beyond = t102 ? t104 * t104 * t104 * shape_cut : 0.0;
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
    bool t2 = 0.0 < light.elevation_sin;
    float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    bool t5 = t2 && light.crescent_share <= t3;
    float t6 = 1.0 - t4;
    float t7 = t4 - t6;
    float t8 = 4.0 * t4 * t6;
    float t9 = 0.0;
    float t10 = 0.0;
    float t11 = 0.0;
    float t12 = 0.0;
    if (t5) {
        float t13 = spherecap_max((t3 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        float t14 = spherecap_min(t13, 0.99999994);
        float t15 = 3.1415927 - light.beyond;
        float t16 = mad(t14, t15, light.beyond);
        float t17 = (1.0 - t14) * t15;
        t9 = spherecap_min(t16, t17) * 0.53033006;
        t10 = 1.0;
        t11 = 1.0;
        t12 = t16 - t17;
    } else {
        float t18 = sqrt(t8);
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
            float t23 = mad(mad(light.coefficients_6, t8, light.coefficients_4), t8, light.coefficients_2);
            float t24 = mad(mad(light.coefficients_5, t8, light.coefficients_3), t8, light.coefficients_1);
            float t25 = t18 * mad(t24, t18, mad(t23, t8, light.coefficients_0));
            float t26 = sqrt(mad(t7, t7, t25 * t25));
            float t27 = light.tau * t25;
            t19 = t27;
            t20 = mad(t7, t7, t27 * t27);
            t21 = light.width;
            t22 = mad(light.kappa, t25, t26) * mad(light.cut, t25, t26);
        }
        float t28 = t21 / t22;
        float t29 = t2 ? light.width : t28;
        float t30 = t20 * t29;
        float t31 = t30 * t30;
        float t32 = mad(mad(mad(-0.00060778117, t31, -0.0027203285), t31, -0.10000902), t30, mad(mad(1.0676054e-5, t31, -0.011332183), t31, 1.0000001));
        t9 = t2 ? spherecap_min(spherecap_max(t28, 5.9604645e-8), 0.99999994) : t3;
        t10 = t29 * t32;
        t11 = t20;
        t12 = t19;
    }
    float t33 = spherecap_float_of_bits(mad(spherecap_bits(t9), -0.33333334, 1419900500.0));
    float t34 = mad(-(t9 * t33), t33 * t33, 1.0);
    float t35 = t34 * t34;
    float t36 = mad(mad(mad(0.110958695, t35, 0.14403293), t35, 0.22222222), t34, mad(mad(0.12482853, t35, 0.17283951), t35, 0.33333334));
    float t37 = t10 * (t9 * mad(t33, t34 * t36, t33));
    float t38 = t37 * t11;
    float t39 = t38 * t38;
    float t40 = mad(mad(mad(-0.063446075, t39, -0.056249518), t39, 0.0074712755), t39, 0.09996679);
    float t41 = mad(mad(mad(0.022114987, t39, 0.085662976), t39, 0.030445365), t39, 0.03209764);
    float t42 = t37 * mad(t40, t38, mad(t41, t39, 1.0000004));
    float t43 = t5 ? spherecap_min(t42, 1.0) : t42;
    float t44 = t11 * t43;
    float t45 = 2.0 - t44;
    float t46 = t43 * t45;
    float t47 = sqrt(t46);
    float zenith = 0.0;
    float side = 0.0;
    float cosine = 0.0;
    if (t5) {
        float t48 = light.radius_sin * light.elevation_cos;
        float t49 = t12 < 0.0 ? t44 : t45;
        float t50 = 1.0 - t49;
        float t51 = t46 * t8;
        float t52 = spherecap_max(mad(t48, t49, -light.rise), 0.0);
        float t53 = sqrt(mad(t52, t52, light.radius_sin * light.radius_sin * t51));
        float t54 = t1 * light.radius_cos;
        float t55 = mad(light.elevation_cos * t50, mad(t48, t50, -2.0 * t54), light.radius_sin * t51);
        float t56 = light.radius_sin * mad(light.elevation_cos, t55 / (t53 + t54), -(t1 * t1 * t50));
        zenith = t56;
        side = light.radius_sin * t47 * t7;
        cosine = t53;
    } else {
        float t57 = t47 * t12;
        zenith = mad(light.elevation_cos, t57, -((t2 ? t1 : -t1) * (1.0 - t44)));
        side = t47 * t7;
        cosine = t57;
    }
    float t58 = 0.0 < cosine ? light.inv_above : 0.0;
    float sin2 = mad(zenith, zenith, side * side);
    float t59 = spherecap_max(mad(light.radius_sin, light.radius_sin, -sin2), 0.0);
    float q = sqrt(t59);
    float towards_centre = sqrt(mad(light.radius_cos, light.radius_cos, t59));
    float distance = light.radius_cos * light.radius_cos / (towards_centre + q);
    float t60 = mad(light.frame_0.x, towards_centre, mad(light.frame_1.x, zenith, light.frame_2.x * side));
    float t61 = mad(light.frame_0.y, towards_centre, mad(light.frame_1.y, zenith, light.frame_2.y * side));
    float t62 = mad(light.frame_0.z, towards_centre, mad(light.frame_1.z, zenith, light.frame_2.z * side));
    float t63 = distance * light.inv_radius_sin;
    float t64 = -mad(towards_centre, q, sin2) * light.inv_radius_sin;
    float t65 = t63 * zenith;
    float t66 = t63 * side;
    float t67 = mad(light.frame_0.x, t64, mad(light.frame_1.x, t65, light.frame_2.x * t66));
    float t68 = mad(light.frame_0.y, t64, mad(light.frame_1.y, t65, light.frame_2.y * t66));
    float t69 = mad(light.frame_0.z, t64, mad(light.frame_1.z, t65, light.frame_2.z * t66));
    spherecap_sample sampled;
    sampled.direction = float3(t60, t61, t62);
    sampled.distance = distance * light.distance;
    sampled.normal = float3(t67, t68, t69);
    sampled.cosine = cosine;
    sampled.pdf = t58 * spherecap_min(abs(cosine), 3.4028235e38);
    sampled.projected_pdf = t58;
    return sampled;
}

spherecap_sample spherecap_surface_sample_once(float3 normal, float3 centre, float radius, float u0, float u1) {
    spherecap_surface_light light = spherecap_surface_prepare(normal, centre, radius);
    return spherecap_surface_sample(light, u0, u1);
}

float spherecap_surface_pdf_direction(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = mad(light.frame_0.x, direction.x, mad(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    float t2 = mad(light.frame_1.x, direction.x, mad(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    float t3 = mad(light.frame_2.x, direction.x, mad(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    float t4 = mad(light.normal.x, direction.x, mad(light.normal.y, direction.y, light.normal.z * direction.z));
    bool t5 = t1 < 0.0;
    float t6 = t5 ? 1.0 : t2;
    float t7 = t5 ? 1.0 : t3;
    float t8 = (0.0 < t4 ? light.inv_above : 0.0) * spherecap_min(abs(t4), 3.4028235e38);
    float t9 = mad(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019 ? t8 : 0.0;
    float t10 = mad(direction.x, direction.x, mad(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t10 && t10 <= 1.002001) ? t9 : 0.0;
}

float spherecap_surface_pdf_on_sphere(spherecap_surface_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = mad(light.normal.x, direction.x, mad(light.normal.y, direction.y, light.normal.z * direction.z));
    float t2 = (0.0 < t1 ? light.inv_above : 0.0) * spherecap_min(abs(t1), 3.4028235e38);
    float t3 = mad(direction.x, direction.x, mad(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t3 && t3 <= 1.002001) ? t2 : 0.0;
}

float spherecap_surface_importance(float3 normal, float3 centre, float radius, float strength) {
    float t1 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
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
    float t14 = t13 * t13 / (mad(t8 - t12, spherecap_max(mad(-t9, t9, 0.9999981), 0.0), t13) * 2.0);
    float t15 = t8 <= t12 ? t12 : 0.0 < t13 ? t14 : 0.0;
    float t16 = mad(0.0, 0.5 - t15, t15);
    float t17 = spherecap_min(spherecap_max(t9 * t16 * strength, 1.1754944e-38), 3.4028235e38);
    return (t9 <= 1.0000019 && 4.9303807e-32 < t9 && t10 && 0.0 < t16) ? t17 : 0.0;
}


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with the normal.
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

spherecap_front_light spherecap_front_prepare(float3 normal, float3 centre, float radius, float defensive) {
    float t1 = mad(normal.x, normal.x, mad(normal.y, normal.y, normal.z * normal.z)) - 1.0;
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
        float t7 = spherecap_max(sqrt(mad(t4, t4, mad(t5, t5, t6 * t6))), 1.1754944e-38);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    float t8 = mad(normal_x, normal_x, mad(normal_y, normal_y, normal_z * normal_z));
    float t9 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t10 = centre.x * scale;
    float t11 = centre.y * scale;
    float t12 = centre.z * scale;
    float t13 = radius * scale;
    precise float t14 = t10 * t10;
    precise float t15 = t11 * t11;
    precise float t16 = t12 * t12;
    precise float t17 = t14 + t15;
    precise float t18 = t17 - t14;
    precise float t19 = t17 - t18;
    precise float t20 = t14 - t19;
    precise float t21 = t15 - t18;
    precise float t22 = t17 + t16;
    precise float t23 = t22 - t17;
    precise float t24 = t22 - t23;
    precise float t25 = t17 - t24;
    precise float t26 = t16 - t23;
    float t27 = spherecap_lost(t10, t10, t14) + spherecap_lost(t11, t11, t15) + spherecap_lost(t12, t12, t16);
    precise float t28 = t13 * t13;
    float t29 = t22 - t28 + (t27 + (t20 + t21 + (t25 + t26)) - spherecap_lost(t13, t13, t28));
    bool t30 = 0.0 < t29;
    float t31 = sqrt(t22);
    float t32 = 1.0 / t31;
    precise float t33 = normal_x * t10;
    precise float t34 = normal_y * t11;
    precise float t35 = normal_z * t12;
    precise float t36 = t33 + t34;
    precise float t37 = t36 - t33;
    precise float t38 = t36 - t37;
    precise float t39 = t33 - t38;
    precise float t40 = t34 - t37;
    precise float t41 = t36 + t35;
    precise float t42 = t41 - t36;
    precise float t43 = t41 - t42;
    precise float t44 = t36 - t43;
    precise float t45 = t35 - t42;
    float t46 = spherecap_lost(normal_x, t10, t33) + spherecap_lost(normal_y, t11, t34) + spherecap_lost(normal_z, t12, t35);
    float t47 = t46 + (t39 + t40 + (t44 + t45));
    precise float t48 = t41 + t47;
    precise float t49 = t48 - t41;
    precise float t50 = t47 - t49;
    float t51 = t13 - t48 - t50;
    float t52 = t13 + t48 + t50;
    float t53 = t51 * t52;
    bool t54 = 0.0 < t8;
    bool t55 = 0.0 < t53 && t30 && t54;
    precise float t56 = normal_z * t11;
    float t57 = spherecap_fused(normal_y, t12, -t56) - spherecap_lost(normal_z, t11, t56);
    precise float t58 = normal_x * t12;
    float t59 = spherecap_fused(normal_z, t10, -t58) - spherecap_lost(normal_x, t12, t58);
    precise float t60 = normal_y * t10;
    float t61 = spherecap_fused(normal_x, t11, -t60) - spherecap_lost(normal_y, t10, t60);
    float t62 = mad(t57, t57, mad(t59, t59, t61 * t61));
    bool t63 = 9.8607613e-32 < t62;
    bool t64 = abs(t10) < abs(t12);
    float t65 = t64 ? 0.0 : -t11;
    float t66 = t64 ? -t12 : t10;
    float t67 = t64 ? t11 : 0.0;
    float t68 = sqrt(spherecap_max(t29, 0.0));
    float radius_cos = t68 * t32;
    float t69 = 1.0 + radius_cos;
    float t70 = 1.0 / (t13 * t69);
    float t71 = t70 * t69;
    float radius_sin = t13 * t32;
    float inv_radius_sin = t31 * t71;
    float t72 = sqrt(t29 + t53);
    float t73 = sqrt(t63 ? t62 : mad(t65, t65, mad(t66, t66, t67 * t67)));
    float elevation_sin = t48 * t32;
    float elevation_cos = (t55 ? t72 : t63 ? t73 : 0.0) * t32;
    float t74 = abs(elevation_sin);
    float t75 = radius_sin * elevation_cos;
    float t76 = spherecap_max(mad(radius_cos, t74, t75), 9.8607613e-32);
    float t77 = 1.0 / (t76 * t73);
    float t78 = t77 * t73;
    float t79 = t77 * t76;
    float frame_2_x = (t63 ? t57 : t65) * t79;
    float frame_2_y = (t63 ? t59 : t66) * t79;
    float frame_2_z = (t63 ? t61 : t67) * t79;
    float frame_0_x = t10 * t32;
    float frame_0_y = t11 * t32;
    float frame_0_z = t12 * t32;
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
    if (t55) {
        float t80 = sqrt(t53);
        float t81 = t72 + t68;
        float t82 = 1.0 / (t72 * t81);
        float t83 = t82 * t81;
        float t84 = t68 * t83;
        float t85 = t80 * t83;
        float t86 = abs(t48) * t71;
        float t87 = t86 * t84;
        float t88 = t84 - 0.5;
        float t89 = t87 - 0.5;
        float t90 = t88 * t88;
        float t91 = t89 * t89;
        float t92 = mad(0.05430631, t90, 0.080950715);
        float t93 = mad(t92, t90, 0.1684019);
        float t94 = mad(t93, t90, 0.32709444);
        float t95 = mad(t94, t90, 0.5987523);
        float t96 = mad(-0.026061837, t90, -0.06372378);
        float t97 = mad(t96, t90, -0.11762552);
        float t98 = mad(t97, t90, -0.23594604);
        float t99 = mad(t98, t90, -0.44721135);
        float t100 = mad(t99, t90, -0.7754678);
        float t101 = mad(t100, t88, mad(t95, t90, 0.94559944));
        float t102 = mad(t89, mad(mad(mad(mad(-0.026061837, t91, t96), t91, t97), t91, t98), t91, t99), mad(mad(mad(mad(0.05430631, t91, t92), t91, t93), t91, t94), t91, t95));
        float t103 = mad(t102, t88 + t89, t100);
        float t104 = mad(t87, t103, t101);
        t_x = t84;
        t_y = t85;
        kappa = t86;
        cut = t87;
        shape = t101;
        shape_cut = mad(t87 - t84, t103, t101);
        norm = t104;
        width = t53 * t82;
        inv_cut_1 = t75 * t78;
        tau = t80 * t71;
        area = t85 * t85 * t85 * (spherecap_min(t51, t52) * t71) * t104;
    }
    float t105 = radius_sin * radius_sin;
    float t106 = elevation_sin < 0.0 ? area : t105 * t74 * 3.1415927 + area;
    bool t107 = t30 && 9.8607613e-32 < t105;
    float distance = t31 * unscale;
    float solid_angle = t107 ? t105 * (t70 * t13) * 6.2831855 : 0.0;
    float projected_above = (9.403955e-38 < t106 && t107) ? t106 : 0.0;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    bool t108 = 0.0 < inv_above;
    bool t109 = 0.0 < elevation_sin;
    float t110 = t109 ? inv_above : 0.0;
    float t111 = t108 ? defensive : 0.0 < defensive || !t54 ? 1.0 : 0.0;
    bool t112 = 0.0 < tau;
    bool t113 = t109 && t112 && 0.0 < t110;
    float t114 = t_y * t_y * t_y * shape * t110;
    float t115 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    if (!t109 && t112) {
        float t116 = 1.0 + kappa;
        float t117 = t116 * shape;
        float t118 = 1.0 / (norm * t117);
        float t119 = sqrt(t118);
        float t120 = norm * t119;
        float t121 = (t_x + kappa) * inv_cut_1 - 0.5;
        float t122 = t121 * t121;
        float t123 = mad(mad(mad(-0.026061837, t122, -0.06372378), t122, -0.11762552), t122, -0.23594604);
        float t124 = mad(mad(mad(0.05430631, t122, 0.080950715), t122, 0.1684019), t122, 0.32709444);
        float t125 = mad(mad(mad(t123, t122, -0.44721135), t122, -0.7754678), t121, mad(mad(t124, t122, 0.5987523), t122, 0.94559944));
        float t126 = t116 * t125 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t117 * t118);
        float t127 = mad(t126, t117 * t119, -1.0);
        float t128 = 1.0 - t126;
        float t129 = mad(mad(30.011856, t127, mad(-41.541264, t128, -37.009792)), t127, mad(77.96775, t128, 7.470758));
        float t130 = mad(mad(mad(mad(15.716111, t128, 0.0), t128, 9.961183), t128, -2.61785), t128, 0.8681748);
        float t131 = mad(mad(t129, t127, mad(mad(-49.13454, t128, -9.466533), t128, -1.5877596)), t127, t130);
        float t132 = t127 * t131;
        float t133 = mad(mad(7.295638, t127, -7.236236), t127, mad(mad(mad(-11.4868555, t128, 0.0), t128, 0.0), t128, 3.1255686));
        float t134 = mad(mad(mad(13.728438, t128, -7.981878), t128, 2.025724), t128, -0.7334958);
        float t135 = t127 * mad(t133, t127, t134);
        float t136 = mad(mad(-23.220068, t128, 7.332055), t127, mad(mad(mad(9.986537, t128, 25.22195), t128, 0.0), t128, -2.9581387));
        float t137 = mad(mad(mad(-19.722994, t128, 4.6594768), t128, -0.89538246), t128, 0.5143498);
        float t138 = t127 * mad(t136, t127, t137);
        float t139 = mad(mad(mad(1.946617, t127, -3.077631), t127, 1.4945927), t127, -0.24140751);
        float t140 = t127 * t139;
        float t141 = t127 * mad(mad(0.38173297, t127, -0.30305624), t127, 0.05897375);
        coefficients_0 = t120;
        coefficients_1 = t126 - t120 + t132;
        coefficients_2 = t135 - t132;
        coefficients_3 = t138 - t135;
        coefficients_4 = t140 - t138;
        coefficients_5 = t141 - t140;
        coefficients_6 = -t141;
    }
    bool t142 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    bool t143 = t142 && (t108 || (0.0 < t111 && 0.0 < solid_angle));
    spherecap_front_light light;
    light.is_sampled = t143;
    light.solid_angle = t143 ? solid_angle : 0.0;
    light.projected_solid_angle = t143 ? projected_above : 0.0;
    light.frame_0 = float3(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = float3(mad(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), mad(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), mad(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = float3(frame_2_x, frame_2_y, frame_2_z);
    light.normal = float3(normal_x, normal_y, normal_z);
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = t107 ? t69 * (inv_radius_sin * inv_radius_sin) * 0.15915494 : 0.0;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t53 * (t32 * t32) * t78, -(radius_cos * t74));
    light.defensive = t111;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.crescent_share = t113 ? t114 : 0.0;
    light.inv_rest = t113 ? 1.0 / (1.0 - t114) : 1.0;
    light.beyond = t113 ? t115 * t115 * t115 * shape_cut : 0.0;
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
    bool t2 = 0.0 < light.elevation_sin;
    float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    bool t5 = t3 < light.defensive;
    float t6 = 1.0 - light.defensive;
    float t7 = spherecap_max((t5 ? t3 : t3 - light.defensive) / (t5 ? light.defensive : t6), 5.9604645e-8);
    float t8 = 0.0 < light.requested ? spherecap_min(t7, 0.99999994) : t3;
    bool t9 = t5 || (t2 && light.crescent_share <= t8);
    float t10 = 1.0 - t4;
    float t11 = t4 - t10;
    float t12 = 4.0 * t4 * t10;
    float t13 = 0.0;
    float t14 = 0.0;
    float t15 = 0.0;
    float t16 = 0.0;
    if (t9) {
        float t17 = spherecap_max((t8 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        float t18 = t5 ? t8 : spherecap_min(t17, 0.99999994);
        float t19 = t5 ? 0.0 : light.beyond;
        float t20 = 3.1415927 - t19;
        float t21 = mad(t18, t20, t19);
        float t22 = (1.0 - t18) * t20;
        t13 = spherecap_min(t21, t22) * 0.53033006;
        t14 = 1.0;
        t15 = 1.0;
        t16 = t21 - t22;
    } else {
        float t23 = sqrt(t12);
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
            float t28 = mad(mad(light.coefficients_6, t12, light.coefficients_4), t12, light.coefficients_2);
            float t29 = mad(mad(light.coefficients_5, t12, light.coefficients_3), t12, light.coefficients_1);
            float t30 = t23 * mad(t29, t23, mad(t28, t12, light.coefficients_0));
            float t31 = sqrt(mad(t11, t11, t30 * t30));
            float t32 = light.tau * t30;
            t24 = t32;
            t25 = mad(t11, t11, t32 * t32);
            t26 = light.width;
            t27 = mad(light.kappa, t30, t31) * mad(light.cut, t30, t31);
        }
        float t33 = t26 / t27;
        float t34 = t2 ? light.width : t33;
        float t35 = t25 * t34;
        float t36 = t35 * t35;
        float t37 = mad(mad(mad(-0.00060778117, t36, -0.0027203285), t36, -0.10000902), t35, mad(mad(1.0676054e-5, t36, -0.011332183), t36, 1.0000001));
        t13 = t2 ? spherecap_min(spherecap_max(t33, 5.9604645e-8), 0.99999994) : t8;
        t14 = t34 * t37;
        t15 = t25;
        t16 = t24;
    }
    float t38 = spherecap_float_of_bits(mad(spherecap_bits(t13), -0.33333334, 1419900500.0));
    float t39 = mad(-(t13 * t38), t38 * t38, 1.0);
    float t40 = t39 * t39;
    float t41 = mad(mad(mad(0.110958695, t40, 0.14403293), t40, 0.22222222), t39, mad(mad(0.12482853, t40, 0.17283951), t40, 0.33333334));
    float t42 = t14 * (t13 * mad(t38, t39 * t41, t38));
    float t43 = t42 * t15;
    float t44 = t43 * t43;
    float t45 = mad(mad(mad(-0.063446075, t44, -0.056249518), t44, 0.0074712755), t44, 0.09996679);
    float t46 = mad(mad(mad(0.022114987, t44, 0.085662976), t44, 0.030445365), t44, 0.03209764);
    float t47 = t42 * mad(t45, t43, mad(t46, t44, 1.0000004));
    float t48 = t9 ? spherecap_min(t47, 1.0) : t47;
    float t49 = t15 * t48;
    float t50 = 2.0 - t49;
    float t51 = t48 * t50;
    float t52 = sqrt(t51);
    float zenith = 0.0;
    float side = 0.0;
    float cosine = 0.0;
    if (t9) {
        float t53 = t16 < 0.0 ? t49 : t50;
        float t54 = 0.0;
        float t55 = 0.0;
        float t56 = 0.0;
        if (t5) {
            float t57 = light.solid_angle * 0.15915494;
            float t58 = t57 * (1.0 - t51 * t12);
            float t59 = sqrt(t57 * (2.0 - t58));
            float t60 = (t53 - 1.0) * t59;
            t54 = t60;
            t55 = t52 * t11 * t59;
            t56 = mad(light.elevation_sin, 1.0 - t58, light.elevation_cos * t60);
        } else {
            float t61 = light.radius_sin * light.elevation_cos;
            float t62 = 1.0 - t53;
            float t63 = t51 * t12;
            float t64 = spherecap_max(mad(t61, t53, -light.rise), 0.0);
            float t65 = sqrt(mad(t64, t64, light.radius_sin * light.radius_sin * t63));
            float t66 = t1 * light.radius_cos;
            float t67 = mad(light.elevation_cos * t62, mad(t61, t62, -2.0 * t66), light.radius_sin * t63);
            float t68 = light.radius_sin * mad(light.elevation_cos, t67 / (t65 + t66), -(t1 * t1 * t62));
            t54 = t68;
            t55 = light.radius_sin * t52 * t11;
            t56 = t65;
        }
        zenith = t54;
        side = t55;
        cosine = t56;
    } else {
        float t69 = t52 * t16;
        zenith = mad(light.elevation_cos, t69, -((t2 ? t1 : -t1) * (1.0 - t49)));
        side = t52 * t11;
        cosine = t69;
    }
    float t70 = spherecap_min(abs(cosine), 3.4028235e38);
    float t71 = 0.0 < cosine ? light.inv_above : 0.0;
    float t72 = 0.0;
    float t73 = 0.0;
    if (0.0 < light.defensive) {
        float t74 = light.defensive * light.inv_solid_angle;
        float t75 = mad(t71, t6, spherecap_min(t74 / spherecap_max(t70, 1.1754944e-38), 3.4028235e38));
        t72 = mad(t71, t6 * t70, t74);
        t73 = spherecap_min(t75, 3.4028235e38);
    } else {
        t72 = t71 * t70;
        t73 = t71;
    }
    float sin2 = mad(zenith, zenith, side * side);
    float t76 = spherecap_max(mad(light.radius_sin, light.radius_sin, -sin2), 0.0);
    float q = sqrt(t76);
    float towards_centre = sqrt(mad(light.radius_cos, light.radius_cos, t76));
    float distance = light.radius_cos * light.radius_cos / (towards_centre + q);
    float t77 = mad(light.frame_0.x, towards_centre, mad(light.frame_1.x, zenith, light.frame_2.x * side));
    float t78 = mad(light.frame_0.y, towards_centre, mad(light.frame_1.y, zenith, light.frame_2.y * side));
    float t79 = mad(light.frame_0.z, towards_centre, mad(light.frame_1.z, zenith, light.frame_2.z * side));
    float t80 = distance * light.inv_radius_sin;
    float t81 = -mad(towards_centre, q, sin2) * light.inv_radius_sin;
    float t82 = t80 * zenith;
    float t83 = t80 * side;
    float t84 = mad(light.frame_0.x, t81, mad(light.frame_1.x, t82, light.frame_2.x * t83));
    float t85 = mad(light.frame_0.y, t81, mad(light.frame_1.y, t82, light.frame_2.y * t83));
    float t86 = mad(light.frame_0.z, t81, mad(light.frame_1.z, t82, light.frame_2.z * t83));
    spherecap_sample sampled;
    sampled.direction = float3(t77, t78, t79);
    sampled.distance = distance * light.distance;
    sampled.normal = float3(t84, t85, t86);
    sampled.cosine = cosine;
    sampled.pdf = t72;
    sampled.projected_pdf = t73;
    return sampled;
}

spherecap_sample spherecap_front_sample_once(float3 normal, float3 centre, float radius, float defensive, float u0, float u1) {
    spherecap_front_light light = spherecap_front_prepare(normal, centre, radius, defensive);
    return spherecap_front_sample(light, u0, u1);
}

float spherecap_front_pdf_direction(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = mad(light.frame_0.x, direction.x, mad(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    float t2 = mad(light.frame_1.x, direction.x, mad(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    float t3 = mad(light.frame_2.x, direction.x, mad(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    float t4 = mad(light.normal.x, direction.x, mad(light.normal.y, direction.y, light.normal.z * direction.z));
    bool t5 = t1 < 0.0;
    float t6 = t5 ? 1.0 : t2;
    float t7 = t5 ? 1.0 : t3;
    float t8 = spherecap_min(abs(t4), 3.4028235e38);
    float t9 = 0.0 < t4 ? light.inv_above : 0.0;
    float t10 = mad(t9, (1.0 - light.defensive) * t8, light.defensive * light.inv_solid_angle);
    float t11 = mad(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.defensive ? t10 : t9 * t8) : 0.0;
    float t12 = mad(direction.x, direction.x, mad(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t12 && t12 <= 1.002001) ? t11 : 0.0;
}

float spherecap_front_pdf_on_sphere(spherecap_front_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = mad(light.normal.x, direction.x, mad(light.normal.y, direction.y, light.normal.z * direction.z));
    float t2 = spherecap_min(abs(t1), 3.4028235e38);
    float t3 = 0.0 < t1 ? light.inv_above : 0.0;
    float t4 = mad(t3, (1.0 - light.defensive) * t2, light.defensive * light.inv_solid_angle);
    float t5 = mad(direction.x, direction.x, mad(direction.y, direction.y, direction.z * direction.z));
    float t6 = (0.998001 <= t5 && t5 <= 1.002001) ? (0.0 < light.defensive ? t4 : t3 * t2) : 0.0;
    return t6;
}

float spherecap_front_importance(float3 normal, float3 centre, float radius, float defensive, float strength) {
    float t1 = mad(normal.x, normal.x, mad(normal.y, normal.y, normal.z * normal.z)) - 1.0;
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
        float t10 = spherecap_max(sqrt(mad(t7, t7, mad(t8, t8, t9 * t9))), 1.1754944e-38);
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
    float t16 = sqrt(mad(t12, t12, mad(t13, t13, t14 * t14)));
    float t17 = 1.0 / t16;
    float t18 = t15 * t17;
    float t19 = t18 * t18;
    float t20 = mad(t2, t2, mad(t3, t3, t4 * t4));
    bool t21 = 0.0 <= defensive && defensive <= 1.0 && t20 <= 2.0 && 0.0 < radius && t16 * unscale <= 3.4028235e38;
    float t22 = mad(t2, t12, mad(t3, t13, t4 * t14));
    float t23 = mad(t22, t17, 2.3841858e-7);
    float t24 = mad(t22 + t15, t17, 2.3841858e-7);
    float t25 = t24 * t24 / (mad(t18 - t23, spherecap_max(mad(-t19, t19, 0.9999981), 0.0), t24) * 2.0);
    float t26 = t18 <= t23 ? t23 : 0.0 < t24 ? t25 : 0.0;
    float t27 = t20 <= 0.0 ? 1.0 : mad(defensive, 0.5 - t26, t26);
    bool t28 = t19 <= 1.0000019 && 4.9303807e-32 < t19 && t21 && 0.0 < strength && strength <= 3.4028235e38;
    float t29 = spherecap_min(spherecap_max(t19 * t27 * strength, 1.1754944e-38), 3.4028235e38);
    return (t28 && (0.0 < t27 || 0.0 < defensive)) ? t29 : 0.0;
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

spherecap_both_light spherecap_both_prepare(float3 normal, float3 centre, float radius, float defensive) {
    float t1 = mad(normal.x, normal.x, mad(normal.y, normal.y, normal.z * normal.z)) - 1.0;
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
        float t7 = spherecap_max(sqrt(mad(t4, t4, mad(t5, t5, t6 * t6))), 1.1754944e-38);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    float t8 = mad(normal_x, normal_x, mad(normal_y, normal_y, normal_z * normal_z));
    float t9 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    float unscale = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37));
    float scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    float t10 = centre.x * scale;
    float t11 = centre.y * scale;
    float t12 = centre.z * scale;
    float t13 = radius * scale;
    precise float t14 = t10 * t10;
    precise float t15 = t11 * t11;
    precise float t16 = t12 * t12;
    precise float t17 = t14 + t15;
    precise float t18 = t17 - t14;
    precise float t19 = t17 - t18;
    precise float t20 = t14 - t19;
    precise float t21 = t15 - t18;
    precise float t22 = t17 + t16;
    precise float t23 = t22 - t17;
    precise float t24 = t22 - t23;
    precise float t25 = t17 - t24;
    precise float t26 = t16 - t23;
    float t27 = spherecap_lost(t10, t10, t14) + spherecap_lost(t11, t11, t15) + spherecap_lost(t12, t12, t16);
    precise float t28 = t13 * t13;
    float t29 = t22 - t28 + (t27 + (t20 + t21 + (t25 + t26)) - spherecap_lost(t13, t13, t28));
    bool t30 = 0.0 < t29;
    float t31 = sqrt(t22);
    float t32 = 1.0 / t31;
    precise float t33 = normal_x * t10;
    precise float t34 = normal_y * t11;
    precise float t35 = normal_z * t12;
    precise float t36 = t33 + t34;
    precise float t37 = t36 - t33;
    precise float t38 = t36 - t37;
    precise float t39 = t33 - t38;
    precise float t40 = t34 - t37;
    precise float t41 = t36 + t35;
    precise float t42 = t41 - t36;
    precise float t43 = t41 - t42;
    precise float t44 = t36 - t43;
    precise float t45 = t35 - t42;
    float t46 = spherecap_lost(normal_x, t10, t33) + spherecap_lost(normal_y, t11, t34) + spherecap_lost(normal_z, t12, t35);
    float t47 = t46 + (t39 + t40 + (t44 + t45));
    precise float t48 = t41 + t47;
    precise float t49 = t48 - t41;
    precise float t50 = t47 - t49;
    float t51 = t13 - t48 - t50;
    float t52 = t13 + t48 + t50;
    float t53 = t51 * t52;
    bool t54 = 0.0 < t8;
    bool t55 = 0.0 < t53 && t30 && t54;
    precise float t56 = normal_z * t11;
    float t57 = spherecap_fused(normal_y, t12, -t56) - spherecap_lost(normal_z, t11, t56);
    precise float t58 = normal_x * t12;
    float t59 = spherecap_fused(normal_z, t10, -t58) - spherecap_lost(normal_x, t12, t58);
    precise float t60 = normal_y * t10;
    float t61 = spherecap_fused(normal_x, t11, -t60) - spherecap_lost(normal_y, t10, t60);
    float t62 = mad(t57, t57, mad(t59, t59, t61 * t61));
    bool t63 = 9.8607613e-32 < t62;
    bool t64 = abs(t10) < abs(t12);
    float t65 = t64 ? 0.0 : -t11;
    float t66 = t64 ? -t12 : t10;
    float t67 = t64 ? t11 : 0.0;
    float t68 = sqrt(spherecap_max(t29, 0.0));
    float radius_cos = t68 * t32;
    float t69 = 1.0 + radius_cos;
    float t70 = 1.0 / (t13 * t69);
    float t71 = t70 * t69;
    float radius_sin = t13 * t32;
    float inv_radius_sin = t31 * t71;
    float t72 = sqrt(t29 + t53);
    float t73 = sqrt(t63 ? t62 : mad(t65, t65, mad(t66, t66, t67 * t67)));
    float elevation_sin = t48 * t32;
    float elevation_cos = (t55 ? t72 : t63 ? t73 : 0.0) * t32;
    float t74 = abs(elevation_sin);
    float t75 = radius_sin * elevation_cos;
    float t76 = spherecap_max(mad(radius_cos, t74, t75), 9.8607613e-32);
    float t77 = 1.0 / (t76 * t73);
    float t78 = t77 * t73;
    float t79 = t77 * t76;
    float frame_2_x = (t63 ? t57 : t65) * t79;
    float frame_2_y = (t63 ? t59 : t66) * t79;
    float frame_2_z = (t63 ? t61 : t67) * t79;
    float frame_0_x = t10 * t32;
    float frame_0_y = t11 * t32;
    float frame_0_z = t12 * t32;
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
    if (t55) {
        float t80 = sqrt(t53);
        float t81 = t72 + t68;
        float t82 = 1.0 / (t72 * t81);
        float t83 = t82 * t81;
        float t84 = t68 * t83;
        float t85 = t80 * t83;
        float t86 = abs(t48) * t71;
        float t87 = t86 * t84;
        float t88 = t84 - 0.5;
        float t89 = t87 - 0.5;
        float t90 = t88 * t88;
        float t91 = t89 * t89;
        float t92 = mad(0.05430631, t90, 0.080950715);
        float t93 = mad(t92, t90, 0.1684019);
        float t94 = mad(t93, t90, 0.32709444);
        float t95 = mad(t94, t90, 0.5987523);
        float t96 = mad(-0.026061837, t90, -0.06372378);
        float t97 = mad(t96, t90, -0.11762552);
        float t98 = mad(t97, t90, -0.23594604);
        float t99 = mad(t98, t90, -0.44721135);
        float t100 = mad(t99, t90, -0.7754678);
        float t101 = mad(t100, t88, mad(t95, t90, 0.94559944));
        float t102 = mad(t89, mad(mad(mad(mad(-0.026061837, t91, t96), t91, t97), t91, t98), t91, t99), mad(mad(mad(mad(0.05430631, t91, t92), t91, t93), t91, t94), t91, t95));
        float t103 = mad(t102, t88 + t89, t100);
        float t104 = mad(t87, t103, t101);
        t_x = t84;
        t_y = t85;
        kappa = t86;
        cut = t87;
        shape = t101;
        shape_cut = mad(t87 - t84, t103, t101);
        norm = t104;
        width = t53 * t82;
        inv_cut_1 = t75 * t78;
        tau = t80 * t71;
        area = t85 * t85 * t85 * (spherecap_min(t51, t52) * t71) * t104;
    }
    float t105 = radius_sin * radius_sin;
    float t106 = t105 * t74 * 3.1415927 + area;
    bool t107 = elevation_sin < 0.0;
    float t108 = t107 ? area : t106;
    float t109 = t107 ? t106 : area;
    bool t110 = t30 && 9.8607613e-32 < t105;
    float distance = t31 * unscale;
    float solid_angle = t110 ? t105 * (t70 * t13) * 6.2831855 : 0.0;
    float projected_above = (9.403955e-38 < t108 && t110) ? t108 : 0.0;
    float projected_below = (9.403955e-38 < t109 && t110) ? t109 : 0.0;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    float inv_below = 0.0 < projected_below ? 1.0 / projected_below : 0.0;
    bool t111 = 0.0 < inv_above + inv_below;
    bool t112 = 0.0 < elevation_sin;
    float t113 = t112 ? inv_above : inv_below;
    float t114 = t111 ? defensive : 0.0 < defensive || !t54 ? 1.0 : 0.0;
    bool t115 = 0.0 < tau;
    bool t116 = t115 && 0.0 < t113;
    float t117 = t_y * t_y * t_y * shape * t113;
    float t118 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    float t119 = 0.0;
    if (t115) {
        float t120 = 1.0 + kappa;
        float t121 = t120 * shape;
        float t122 = 1.0 / (norm * t121);
        float t123 = sqrt(t122);
        float t124 = norm * t123;
        float t125 = (t_x + kappa) * inv_cut_1 - 0.5;
        float t126 = t125 * t125;
        float t127 = mad(mad(mad(-0.026061837, t126, -0.06372378), t126, -0.11762552), t126, -0.23594604);
        float t128 = mad(mad(mad(0.05430631, t126, 0.080950715), t126, 0.1684019), t126, 0.32709444);
        float t129 = mad(mad(mad(t127, t126, -0.44721135), t126, -0.7754678), t125, mad(mad(t128, t126, 0.5987523), t126, 0.94559944));
        float t130 = t120 * t129 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t121 * t122);
        float t131 = mad(t130, t121 * t123, -1.0);
        float t132 = 1.0 - t130;
        float t133 = mad(mad(30.011856, t131, mad(-41.541264, t132, -37.009792)), t131, mad(77.96775, t132, 7.470758));
        float t134 = mad(mad(mad(mad(15.716111, t132, 0.0), t132, 9.961183), t132, -2.61785), t132, 0.8681748);
        float t135 = mad(mad(t133, t131, mad(mad(-49.13454, t132, -9.466533), t132, -1.5877596)), t131, t134);
        float t136 = t131 * t135;
        float t137 = mad(mad(7.295638, t131, -7.236236), t131, mad(mad(mad(-11.4868555, t132, 0.0), t132, 0.0), t132, 3.1255686));
        float t138 = mad(mad(mad(13.728438, t132, -7.981878), t132, 2.025724), t132, -0.7334958);
        float t139 = t131 * mad(t137, t131, t138);
        float t140 = mad(mad(-23.220068, t132, 7.332055), t131, mad(mad(mad(9.986537, t132, 25.22195), t132, 0.0), t132, -2.9581387));
        float t141 = mad(mad(mad(-19.722994, t132, 4.6594768), t132, -0.89538246), t132, 0.5143498);
        float t142 = t131 * mad(t140, t131, t141);
        float t143 = mad(mad(mad(1.946617, t131, -3.077631), t131, 1.4945927), t131, -0.24140751);
        float t144 = t131 * t143;
        float t145 = t131 * mad(mad(0.38173297, t131, -0.30305624), t131, 0.05897375);
        float t146 = 1.0 / (elevation_cos * elevation_cos);
        float t147 = tau * tau;
        float t148 = t147 * t146 / (1.0 + t_x);
        float t149 = kappa - 0.5;
        float t150 = cut - 0.5;
        float t151 = t149 * t149;
        float t152 = t150 * t150;
        float t153 = mad(0.05430631, t151, 0.080950715);
        float t154 = mad(t153, t151, 0.1684019);
        float t155 = mad(t154, t151, 0.32709444);
        float t156 = mad(mad(mad(mad(0.05430631, t152, t153), t152, t154), t152, t155), t152, mad(t155, t151, 0.5987523));
        float t157 = mad(-0.026061837, t151, -0.06372378);
        float t158 = mad(t157, t151, -0.11762552);
        float t159 = mad(t158, t151, -0.23594604);
        float t160 = mad(t159, t151, -0.44721135);
        float t161 = mad(mad(mad(mad(-0.026061837, t152, t157), t152, t158), t152, t159), t152, t160);
        float t162 = mad(kappa * t148, mad(mad(t150, t161, t156), t149 + t150, mad(t160, t151, -0.7754678)), mad(shape_cut, t148 - kappa * kappa, kappa) * t146);
        float t163 = spherecap_min(spherecap_max(t147 * tau * (radius_cos + 1.0) * t162 * 0.31830987, 0.0), 0.5);
        coefficients_0 = t124;
        coefficients_1 = t130 - t124 + t136;
        coefficients_2 = t139 - t136;
        coefficients_3 = t142 - t139;
        coefficients_4 = t144 - t142;
        coefficients_5 = t145 - t144;
        coefficients_6 = -t145;
        t119 = t163;
    }
    float share_above = 0.0 < inv_below ? (0.0 < inv_above ? (t112 ? 1.0 - t119 : t119) : 0.0) : 1.0;
    bool t164 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    bool t165 = t164 && (t111 || (0.0 < t114 && 0.0 < solid_angle));
    spherecap_both_light light;
    light.is_sampled = t165;
    light.solid_angle = t165 ? solid_angle : 0.0;
    light.projected_solid_angle = t165 ? projected_above : 0.0;
    light.frame_0 = float3(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = float3(mad(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), mad(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), mad(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = float3(frame_2_x, frame_2_y, frame_2_z);
    light.normal = float3(normal_x, normal_y, normal_z);
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = t110 ? t69 * (inv_radius_sin * inv_radius_sin) * 0.15915494 : 0.0;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t53 * (t32 * t32) * t78, -(radius_cos * t74));
    light.defensive = t114;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
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

spherecap_sample spherecap_both_sample(spherecap_both_light light, float u0, float u1) {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    float t1 = abs(light.elevation_sin);
    bool t2 = 0.0 < light.elevation_sin;
    float t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    float t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    bool t5 = t3 < light.defensive;
    float t6 = 1.0 - light.defensive;
    float t7 = spherecap_max((t5 ? t3 : t3 - light.defensive) / (t5 ? light.defensive : t6), 5.9604645e-8);
    float t8 = 0.0 < light.requested ? spherecap_min(t7, 0.99999994) : t3;
    bool t9 = t5 || t8 < light.share_above;
    float t10 = 1.0 - light.share_above;
    float t11 = spherecap_max((t9 ? t8 : t8 - light.share_above) / (t9 ? light.share_above : t10), 5.9604645e-8);
    bool t12 = (t9 && t2) || (!t9 && !t2);
    float t13 = t5 ? t8 : spherecap_min(t11, 0.99999994);
    bool t14 = t5 || (t12 && light.crescent_share <= t13);
    float t15 = 1.0 - t4;
    float t16 = t4 - t15;
    float t17 = 4.0 * t4 * t15;
    float t18 = 0.0;
    float t19 = 0.0;
    float t20 = 0.0;
    float t21 = 0.0;
    if (t14) {
        float t22 = spherecap_max((t13 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        float t23 = t5 ? t13 : spherecap_min(t22, 0.99999994);
        float t24 = t5 ? 0.0 : light.beyond;
        float t25 = 3.1415927 - t24;
        float t26 = mad(t23, t25, t24);
        float t27 = (1.0 - t23) * t25;
        t18 = spherecap_min(t26, t27) * 0.53033006;
        t19 = 1.0;
        t20 = 1.0;
        t21 = t26 - t27;
    } else {
        float t28 = sqrt(t17);
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
            float t33 = mad(mad(light.coefficients_6, t17, light.coefficients_4), t17, light.coefficients_2);
            float t34 = mad(mad(light.coefficients_5, t17, light.coefficients_3), t17, light.coefficients_1);
            float t35 = t28 * mad(t34, t28, mad(t33, t17, light.coefficients_0));
            float t36 = sqrt(mad(t16, t16, t35 * t35));
            float t37 = light.tau * t35;
            t29 = t37;
            t30 = mad(t16, t16, t37 * t37);
            t31 = light.width;
            t32 = mad(light.kappa, t35, t36) * mad(light.cut, t35, t36);
        }
        float t38 = t31 / t32;
        float t39 = t12 ? light.width : t38;
        float t40 = t30 * t39;
        float t41 = t40 * t40;
        float t42 = mad(mad(mad(-0.00060778117, t41, -0.0027203285), t41, -0.10000902), t40, mad(mad(1.0676054e-5, t41, -0.011332183), t41, 1.0000001));
        t18 = t12 ? spherecap_min(spherecap_max(t38, 5.9604645e-8), 0.99999994) : t13;
        t19 = t39 * t42;
        t20 = t30;
        t21 = t29;
    }
    float t43 = spherecap_float_of_bits(mad(spherecap_bits(t18), -0.33333334, 1419900500.0));
    float t44 = mad(-(t18 * t43), t43 * t43, 1.0);
    float t45 = t44 * t44;
    float t46 = mad(mad(mad(0.110958695, t45, 0.14403293), t45, 0.22222222), t44, mad(mad(0.12482853, t45, 0.17283951), t45, 0.33333334));
    float t47 = t19 * (t18 * mad(t43, t44 * t46, t43));
    float t48 = t47 * t20;
    float t49 = t48 * t48;
    float t50 = mad(mad(mad(-0.063446075, t49, -0.056249518), t49, 0.0074712755), t49, 0.09996679);
    float t51 = mad(mad(mad(0.022114987, t49, 0.085662976), t49, 0.030445365), t49, 0.03209764);
    float t52 = t47 * mad(t50, t48, mad(t51, t49, 1.0000004));
    float t53 = t14 ? spherecap_min(t52, 1.0) : t52;
    float t54 = t20 * t53;
    float t55 = 2.0 - t54;
    float t56 = t53 * t55;
    float t57 = sqrt(t56);
    float t58 = 0.0;
    float side = 0.0;
    float t59 = 0.0;
    if (t14) {
        float t60 = t21 < 0.0 ? t54 : t55;
        float t61 = 0.0;
        float t62 = 0.0;
        float t63 = 0.0;
        if (t5) {
            float t64 = light.solid_angle * 0.15915494;
            float t65 = t64 * (1.0 - t56 * t17);
            float t66 = sqrt(t64 * (2.0 - t65));
            float t67 = (t60 - 1.0) * t66;
            t61 = t67;
            t62 = t57 * t16 * t66;
            t63 = mad(light.elevation_sin, 1.0 - t65, light.elevation_cos * t67);
        } else {
            float t68 = light.radius_sin * light.elevation_cos;
            float t69 = 1.0 - t60;
            float t70 = t56 * t17;
            float t71 = spherecap_max(mad(t68, t60, -light.rise), 0.0);
            float t72 = sqrt(mad(t71, t71, light.radius_sin * light.radius_sin * t70));
            float t73 = t1 * light.radius_cos;
            float t74 = mad(light.elevation_cos * t69, mad(t68, t69, -2.0 * t73), light.radius_sin * t70);
            float t75 = light.radius_sin * mad(light.elevation_cos, t74 / (t72 + t73), -(t1 * t1 * t69));
            t61 = t75;
            t62 = light.radius_sin * t57 * t16;
            t63 = t72;
        }
        t58 = t61;
        side = t62;
        t59 = t63;
    } else {
        float t76 = t57 * t21;
        t58 = mad(light.elevation_cos, t76, -((t12 ? t1 : -t1) * (1.0 - t54)));
        side = t57 * t16;
        t59 = t76;
    }
    float t77 = t9 ? 1.0 : -1.0;
    float zenith = t58 * t77;
    float cosine = t59 * t77;
    float t78 = spherecap_min(abs(cosine), 3.4028235e38);
    float t79 = 0.0 < cosine ? light.inv_above * light.share_above : cosine < 0.0 ? light.inv_below * t10 : 0.0;
    float t80 = 0.0;
    float t81 = 0.0;
    if (0.0 < light.defensive) {
        float t82 = light.defensive * light.inv_solid_angle;
        float t83 = mad(t79, t6, spherecap_min(t82 / spherecap_max(t78, 1.1754944e-38), 3.4028235e38));
        t80 = mad(t79, t6 * t78, t82);
        t81 = spherecap_min(t83, 3.4028235e38);
    } else {
        t80 = t79 * t78;
        t81 = t79;
    }
    float sin2 = mad(zenith, zenith, side * side);
    float t84 = spherecap_max(mad(light.radius_sin, light.radius_sin, -sin2), 0.0);
    float q = sqrt(t84);
    float towards_centre = sqrt(mad(light.radius_cos, light.radius_cos, t84));
    float distance = light.radius_cos * light.radius_cos / (towards_centre + q);
    float t85 = mad(light.frame_0.x, towards_centre, mad(light.frame_1.x, zenith, light.frame_2.x * side));
    float t86 = mad(light.frame_0.y, towards_centre, mad(light.frame_1.y, zenith, light.frame_2.y * side));
    float t87 = mad(light.frame_0.z, towards_centre, mad(light.frame_1.z, zenith, light.frame_2.z * side));
    float t88 = distance * light.inv_radius_sin;
    float t89 = -mad(towards_centre, q, sin2) * light.inv_radius_sin;
    float t90 = t88 * zenith;
    float t91 = t88 * side;
    float t92 = mad(light.frame_0.x, t89, mad(light.frame_1.x, t90, light.frame_2.x * t91));
    float t93 = mad(light.frame_0.y, t89, mad(light.frame_1.y, t90, light.frame_2.y * t91));
    float t94 = mad(light.frame_0.z, t89, mad(light.frame_1.z, t90, light.frame_2.z * t91));
    spherecap_sample sampled;
    sampled.direction = float3(t85, t86, t87);
    sampled.distance = distance * light.distance;
    sampled.normal = float3(t92, t93, t94);
    sampled.cosine = cosine;
    sampled.pdf = t80;
    sampled.projected_pdf = t81;
    return sampled;
}

spherecap_sample spherecap_both_sample_once(float3 normal, float3 centre, float radius, float defensive, float u0, float u1) {
    spherecap_both_light light = spherecap_both_prepare(normal, centre, radius, defensive);
    return spherecap_both_sample(light, u0, u1);
}

float spherecap_both_pdf_direction(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = mad(light.frame_0.x, direction.x, mad(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    float t2 = mad(light.frame_1.x, direction.x, mad(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    float t3 = mad(light.frame_2.x, direction.x, mad(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    float t4 = mad(light.normal.x, direction.x, mad(light.normal.y, direction.y, light.normal.z * direction.z));
    bool t5 = t1 < 0.0;
    float t6 = t5 ? 1.0 : t2;
    float t7 = t5 ? 1.0 : t3;
    float t8 = spherecap_min(abs(t4), 3.4028235e38);
    float t9 = 0.0 < t4 ? light.inv_above * light.share_above : t4 < 0.0 ? light.inv_below * (1.0 - light.share_above) : 0.0;
    float t10 = mad(t9, (1.0 - light.defensive) * t8, light.defensive * light.inv_solid_angle);
    float t11 = mad(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019 ? (0.0 < light.defensive ? t10 : t9 * t8) : 0.0;
    float t12 = mad(direction.x, direction.x, mad(direction.y, direction.y, direction.z * direction.z));
    return (0.998001 <= t12 && t12 <= 1.002001) ? t11 : 0.0;
}

float spherecap_both_pdf_on_sphere(spherecap_both_light light, float3 direction) {
    if (!light.is_sampled) {
        return 0.0;
    }
    float t1 = mad(light.normal.x, direction.x, mad(light.normal.y, direction.y, light.normal.z * direction.z));
    float t2 = spherecap_min(abs(t1), 3.4028235e38);
    float t3 = 0.0 < t1 ? light.inv_above * light.share_above : t1 < 0.0 ? light.inv_below * (1.0 - light.share_above) : 0.0;
    float t4 = mad(t3, (1.0 - light.defensive) * t2, light.defensive * light.inv_solid_angle);
    float t5 = mad(direction.x, direction.x, mad(direction.y, direction.y, direction.z * direction.z));
    float t6 = (0.998001 <= t5 && t5 <= 1.002001) ? (0.0 < light.defensive ? t4 : t3 * t2) : 0.0;
    return t6;
}

float spherecap_both_importance(float3 normal, float3 centre, float radius, float defensive, float strength) {
    float t1 = mad(normal.x, normal.x, mad(normal.y, normal.y, normal.z * normal.z)) - 1.0;
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
        float t10 = spherecap_max(sqrt(mad(t7, t7, mad(t8, t8, t9 * t9))), 1.1754944e-38);
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
    float t16 = sqrt(mad(t12, t12, mad(t13, t13, t14 * t14)));
    float t17 = 1.0 / t16;
    float t18 = t15 * t17;
    float t19 = t18 * t18;
    float t20 = mad(t2, t2, mad(t3, t3, t4 * t4));
    bool t21 = 0.0 <= defensive && defensive <= 1.0 && t20 <= 2.0 && 0.0 < radius && t16 * unscale <= 3.4028235e38;
    float t22 = mad(t2, t12, mad(t3, t13, t4 * t14));
    float t23 = spherecap_max(mad(-t19, t19, 0.9999981), 0.0);
    float t24 = mad(t22, t17, 2.3841858e-7);
    float t25 = mad(t22 + t15, t17, 2.3841858e-7);
    float t26 = t18 <= t24 ? t24 : 0.0 < t25 ? t25 * t25 / (mad(t18 - t24, t23, t25) * 2.0) : 0.0;
    float t27 = mad(-t22, t17, 2.3841858e-7);
    float t28 = mad(-t22 + t15, t17, 2.3841858e-7);
    float t29 = t18 <= t27 ? t27 : 0.0 < t28 ? t28 * t28 / (mad(t18 - t27, t23, t28) * 2.0) : 0.0;
    float t30 = t26 + t29;
    float t31 = t20 <= 0.0 ? 1.0 : mad(defensive, 0.5 - t30, t30);
    bool t32 = t19 <= 1.0000019 && 4.9303807e-32 < t19 && t21 && 0.0 < strength && strength <= 3.4028235e38;
    float t33 = spherecap_min(spherecap_max(t19 * t31 * strength, 1.1754944e-38), 3.4028235e38);
    return (t32 && (0.0 < t31 || 0.0 < defensive)) ? t33 : 0.0;
}


#endif
