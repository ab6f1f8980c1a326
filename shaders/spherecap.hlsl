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
    precise float t11 = t9 + t8;
    precise float t12 = t11 - t9;
    float t13 = spherecap_lost(t2, t2, t6) + spherecap_lost(t3, t3, t7) + spherecap_lost(t4, t4, t8);
    precise float t14 = t5 * t5;
    precise float t15 = t13 + (t6 - (t9 - t10) + (t7 - t10) + (t9 - (t11 - t12) + (t8 - t12))) - spherecap_lost(t5, t5, t14);
    float t16 = t11 - t14 + t15;
    bool t17 = 0.0 < t16;
    float t18 = sqrt(t11);
    float t19 = 1.0 / t18;
    precise float t20 = normal.x * t2;
    precise float t21 = normal.y * t3;
    precise float t22 = normal.z * t4;
    precise float t23 = t20 + t21;
    precise float t24 = t23 - t20;
    precise float t25 = t23 + t22;
    precise float t26 = t25 - t23;
    float t27 = spherecap_lost(normal.x, t2, t20) + spherecap_lost(normal.y, t3, t21) + spherecap_lost(normal.z, t4, t22);
    precise float t28 = t27 + (t20 - (t23 - t24) + (t21 - t24) + (t23 - (t25 - t26) + (t22 - t26)));
    precise float t29 = t25 + t28;
    precise float t30 = t28 - (t29 - t25);
    float t31 = t5 - t29 - t30;
    float t32 = t5 + t29 + t30;
    float t33 = t31 * t32;
    bool t34 = 0.0 < t33 && t17;
    precise float t35 = normal.z * t3;
    float t36 = spherecap_fused(normal.y, t4, -t35) - spherecap_lost(normal.z, t3, t35);
    precise float t37 = normal.x * t4;
    float t38 = spherecap_fused(normal.z, t2, -t37) - spherecap_lost(normal.x, t4, t37);
    precise float t39 = normal.y * t2;
    float t40 = spherecap_fused(normal.x, t3, -t39) - spherecap_lost(normal.y, t2, t39);
    float t41 = mad(t36, t36, mad(t38, t38, t40 * t40));
    bool t42 = 9.8607613e-32 < t41;
    bool t43 = abs(t2) < abs(t4);
    float t44 = t43 ? 0.0 : -t3;
    float t45 = t43 ? -t4 : t2;
    float t46 = t43 ? t3 : 0.0;
    float t47 = sqrt(spherecap_max(t16, 0.0));
    float radius_cos = t47 * t19;
    float t48 = 1.0 + radius_cos;
    float t49 = 1.0 / (t5 * t48);
    float t50 = t49 * t48;
    float radius_sin = t5 * t19;
    float inv_radius_sin = t18 * t50;
    float t51 = sqrt(t16 + t33);
    float t52 = sqrt(t42 ? t41 : mad(t44, t44, mad(t45, t45, t46 * t46)));
    float elevation_sin = t29 * t19;
    float elevation_cos = (t34 ? t51 : t42 ? t52 : 0.0) * t19;
    float t53 = abs(elevation_sin);
    float t54 = radius_sin * elevation_cos;
    float t55 = spherecap_max(mad(radius_cos, t53, t54), 9.8607613e-32);
    float t56 = 1.0 / (t55 * t52);
    float t57 = t56 * t52;
    float t58 = t56 * t55;
    float frame_2_x = (t42 ? t36 : t44) * t58;
    float frame_2_y = (t42 ? t38 : t45) * t58;
    float frame_2_z = (t42 ? t40 : t46) * t58;
    float frame_0_x = t2 * t19;
    float frame_0_y = t3 * t19;
    float frame_0_z = t4 * t19;
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
    if (t34) {
        float t59 = sqrt(t33);
        float t60 = t51 + t47;
        float t61 = 1.0 / (t51 * t60);
        float t62 = t61 * t60;
        float t63 = t47 * t62;
        float t64 = t59 * t62;
        float t65 = abs(t29) * t50;
        float t66 = t65 * t63;
        float t67 = t63 - 0.5;
        float t68 = t66 - 0.5;
        float t69 = t67 * t67;
        float t70 = t68 * t68;
        float t71 = mad(0.05430631, t69, 0.080950715);
        float t72 = mad(t71, t69, 0.1684019);
        float t73 = mad(t72, t69, 0.32709444);
        float t74 = mad(t73, t69, 0.5987523);
        float t75 = mad(-0.026061837, t69, -0.06372378);
        float t76 = mad(t75, t69, -0.11762552);
        float t77 = mad(t76, t69, -0.23594604);
        float t78 = mad(t77, t69, -0.44721135);
        float t79 = mad(t78, t69, -0.7754678);
        float t80 = mad(t79, t67, mad(t74, t69, 0.94559944));
        float t81 = mad(t68, mad(mad(mad(mad(-0.026061837, t70, t75), t70, t76), t70, t77), t70, t78), mad(mad(mad(mad(0.05430631, t70, t71), t70, t72), t70, t73), t70, t74));
        float t82 = mad(t81, t67 + t68, t79);
        float t83 = mad(t66, t82, t80);
        t_x = t63;
        t_y = t64;
        kappa = t65;
        cut = t66;
        shape = t80;
        shape_cut = mad(t66 - t63, t82, t80);
        norm = t83;
        width = t33 * t61;
        inv_cut_1 = t54 * t57;
        tau = t59 * t50;
        area = t64 * t64 * t64 * (spherecap_min(t31, t32) * t50) * t83;
    }
    float t84 = radius_sin * radius_sin;
    float t85 = elevation_sin < 0.0 ? area : t84 * t53 * 3.1415927 + area;
    bool t86 = t17 && 9.8607613e-32 < t84;
    float distance = t18 * unscale;
    float projected_above = (9.403955e-38 < t85 && t86) ? t85 : 0.0;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    bool t87 = 0.0 < elevation_sin;
    float t88 = t87 ? inv_above : 0.0;
    bool t89 = 0.0 < tau;
    bool t90 = t87 && t89 && 0.0 < t88;
    float t91 = t_y * t_y * t_y * shape * t88;
    float t92 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    if (!t87 && t89) {
        float t93 = 1.0 + kappa;
        float t94 = t93 * shape;
        float t95 = 1.0 / (norm * t94);
        float t96 = sqrt(t95);
        float t97 = norm * t96;
        float t98 = (t_x + kappa) * inv_cut_1 - 0.5;
        float t99 = t98 * t98;
        float t100 = mad(mad(mad(-0.026061837, t99, -0.06372378), t99, -0.11762552), t99, -0.23594604);
        float t101 = mad(mad(mad(0.05430631, t99, 0.080950715), t99, 0.1684019), t99, 0.32709444);
        float t102 = mad(mad(mad(t100, t99, -0.44721135), t99, -0.7754678), t98, mad(mad(t101, t99, 0.5987523), t99, 0.94559944));
        float t103 = t93 * t102 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t94 * t95);
        float t104 = mad(t103, t94 * t96, -1.0);
        float t105 = 1.0 - t103;
        float t106 = mad(mad(30.011856, t104, mad(-41.541264, t105, -37.009792)), t104, mad(77.96775, t105, 7.470758));
        float t107 = mad(mad(mad(mad(15.716111, t105, 0.0), t105, 9.961183), t105, -2.61785), t105, 0.8681748);
        float t108 = mad(mad(t106, t104, mad(mad(-49.13454, t105, -9.466533), t105, -1.5877596)), t104, t107);
        float t109 = t104 * t108;
        float t110 = mad(mad(7.295638, t104, -7.236236), t104, mad(mad(mad(-11.4868555, t105, 0.0), t105, 0.0), t105, 3.1255686));
        float t111 = mad(mad(mad(13.728438, t105, -7.981878), t105, 2.025724), t105, -0.7334958);
        float t112 = t104 * mad(t110, t104, t111);
        float t113 = mad(mad(-23.220068, t105, 7.332055), t104, mad(mad(mad(9.986537, t105, 25.22195), t105, 0.0), t105, -2.9581387));
        float t114 = mad(mad(mad(-19.722994, t105, 4.6594768), t105, -0.89538246), t105, 0.5143498);
        float t115 = t104 * mad(t113, t104, t114);
        float t116 = mad(mad(mad(1.946617, t104, -3.077631), t104, 1.4945927), t104, -0.24140751);
        float t117 = t104 * t116;
        float t118 = t104 * mad(mad(0.38173297, t104, -0.30305624), t104, 0.05897375);
        coefficients_0 = t97;
        coefficients_1 = t103 - t97 + t109;
        coefficients_2 = t112 - t109;
        coefficients_3 = t115 - t112;
        coefficients_4 = t117 - t115;
        coefficients_5 = t118 - t117;
        coefficients_6 = -t118;
    }
    bool t119 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    spherecap_surface_light light;
    light.is_sampled = t119;
    light.solid_angle = t119 ? (t86 ? t84 * (t49 * t5) * 6.2831855 : 0.0) : 0.0;
    light.projected_solid_angle = t119 ? projected_above : 0.0;
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
    light.rise = spherecap_max(t33 * (t19 * t19) * t57, -(radius_cos * t53));
    light.inv_above = inv_above;
    light.crescent_share = t90 ? t91 : 0.0;
    light.inv_rest = t90 ? 1.0 / (1.0 - t91) : 1.0;
    light.beyond = t90 ? t92 * t92 * t92 * shape_cut : 0.0;
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
    float t59 = mad(zenith, zenith, side * side);
    float t60 = spherecap_max(mad(light.radius_sin, light.radius_sin, -t59), 0.0);
    float t61 = sqrt(t60);
    float t62 = sqrt(mad(light.radius_cos, light.radius_cos, t60));
    float t63 = light.radius_cos * light.radius_cos / (t62 + t61);
    float t64 = mad(light.frame_0.x, t62, mad(light.frame_1.x, zenith, light.frame_2.x * side));
    float t65 = mad(light.frame_0.y, t62, mad(light.frame_1.y, zenith, light.frame_2.y * side));
    float t66 = mad(light.frame_0.z, t62, mad(light.frame_1.z, zenith, light.frame_2.z * side));
    float t67 = t63 * light.inv_radius_sin;
    float t68 = -mad(t62, t61, t59) * light.inv_radius_sin;
    float t69 = t67 * zenith;
    float t70 = t67 * side;
    float t71 = mad(light.frame_0.x, t68, mad(light.frame_1.x, t69, light.frame_2.x * t70));
    float t72 = mad(light.frame_0.y, t68, mad(light.frame_1.y, t69, light.frame_2.y * t70));
    float t73 = mad(light.frame_0.z, t68, mad(light.frame_1.z, t69, light.frame_2.z * t70));
    spherecap_sample sampled;
    sampled.direction = float3(t64, t65, t66);
    sampled.distance = t63 * light.distance;
    sampled.normal = float3(t71, t72, t73);
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


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the
// probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with
// the normal.
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
    precise float t19 = t17 + t16;
    precise float t20 = t19 - t17;
    float t21 = spherecap_lost(t10, t10, t14) + spherecap_lost(t11, t11, t15) + spherecap_lost(t12, t12, t16);
    precise float t22 = t21 + (t14 - (t17 - t18) + (t15 - t18) + (t17 - (t19 - t20) + (t16 - t20)));
    precise float t23 = t13 * t13;
    float t24 = t19 - t23 + (t22 - spherecap_lost(t13, t13, t23));
    bool t25 = 0.0 < t24;
    float t26 = sqrt(t19);
    float t27 = 1.0 / t26;
    precise float t28 = normal_x * t10;
    precise float t29 = normal_y * t11;
    precise float t30 = normal_z * t12;
    precise float t31 = t28 + t29;
    precise float t32 = t31 - t28;
    precise float t33 = t31 + t30;
    precise float t34 = t33 - t31;
    float t35 = spherecap_lost(normal_x, t10, t28) + spherecap_lost(normal_y, t11, t29) + spherecap_lost(normal_z, t12, t30);
    precise float t36 = t35 + (t28 - (t31 - t32) + (t29 - t32) + (t31 - (t33 - t34) + (t30 - t34)));
    precise float t37 = t33 + t36;
    precise float t38 = t36 - (t37 - t33);
    float t39 = t13 - t37 - t38;
    float t40 = t13 + t37 + t38;
    float t41 = t39 * t40;
    bool t42 = 0.0 < t8;
    bool t43 = 0.0 < t41 && t25 && t42;
    precise float t44 = normal_z * t11;
    float t45 = spherecap_fused(normal_y, t12, -t44) - spherecap_lost(normal_z, t11, t44);
    precise float t46 = normal_x * t12;
    float t47 = spherecap_fused(normal_z, t10, -t46) - spherecap_lost(normal_x, t12, t46);
    precise float t48 = normal_y * t10;
    float t49 = spherecap_fused(normal_x, t11, -t48) - spherecap_lost(normal_y, t10, t48);
    float t50 = mad(t45, t45, mad(t47, t47, t49 * t49));
    bool t51 = 9.8607613e-32 < t50;
    bool t52 = abs(t10) < abs(t12);
    float t53 = t52 ? 0.0 : -t11;
    float t54 = t52 ? -t12 : t10;
    float t55 = t52 ? t11 : 0.0;
    float t56 = sqrt(spherecap_max(t24, 0.0));
    float radius_cos = t56 * t27;
    float t57 = 1.0 + radius_cos;
    float t58 = 1.0 / (t13 * t57);
    float t59 = t58 * t57;
    float radius_sin = t13 * t27;
    float inv_radius_sin = t26 * t59;
    float t60 = sqrt(t24 + t41);
    float t61 = sqrt(t51 ? t50 : mad(t53, t53, mad(t54, t54, t55 * t55)));
    float elevation_sin = t37 * t27;
    float elevation_cos = (t43 ? t60 : t51 ? t61 : 0.0) * t27;
    float t62 = abs(elevation_sin);
    float t63 = radius_sin * elevation_cos;
    float t64 = spherecap_max(mad(radius_cos, t62, t63), 9.8607613e-32);
    float t65 = 1.0 / (t64 * t61);
    float t66 = t65 * t61;
    float t67 = t65 * t64;
    float frame_2_x = (t51 ? t45 : t53) * t67;
    float frame_2_y = (t51 ? t47 : t54) * t67;
    float frame_2_z = (t51 ? t49 : t55) * t67;
    float frame_0_x = t10 * t27;
    float frame_0_y = t11 * t27;
    float frame_0_z = t12 * t27;
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
    if (t43) {
        float t68 = sqrt(t41);
        float t69 = t60 + t56;
        float t70 = 1.0 / (t60 * t69);
        float t71 = t70 * t69;
        float t72 = t56 * t71;
        float t73 = t68 * t71;
        float t74 = abs(t37) * t59;
        float t75 = t74 * t72;
        float t76 = t72 - 0.5;
        float t77 = t75 - 0.5;
        float t78 = t76 * t76;
        float t79 = t77 * t77;
        float t80 = mad(0.05430631, t78, 0.080950715);
        float t81 = mad(t80, t78, 0.1684019);
        float t82 = mad(t81, t78, 0.32709444);
        float t83 = mad(t82, t78, 0.5987523);
        float t84 = mad(-0.026061837, t78, -0.06372378);
        float t85 = mad(t84, t78, -0.11762552);
        float t86 = mad(t85, t78, -0.23594604);
        float t87 = mad(t86, t78, -0.44721135);
        float t88 = mad(t87, t78, -0.7754678);
        float t89 = mad(t88, t76, mad(t83, t78, 0.94559944));
        float t90 = mad(t77, mad(mad(mad(mad(-0.026061837, t79, t84), t79, t85), t79, t86), t79, t87), mad(mad(mad(mad(0.05430631, t79, t80), t79, t81), t79, t82), t79, t83));
        float t91 = mad(t90, t76 + t77, t88);
        float t92 = mad(t75, t91, t89);
        t_x = t72;
        t_y = t73;
        kappa = t74;
        cut = t75;
        shape = t89;
        shape_cut = mad(t75 - t72, t91, t89);
        norm = t92;
        width = t41 * t70;
        inv_cut_1 = t63 * t66;
        tau = t68 * t59;
        area = t73 * t73 * t73 * (spherecap_min(t39, t40) * t59) * t92;
    }
    float t93 = radius_sin * radius_sin;
    float t94 = elevation_sin < 0.0 ? area : t93 * t62 * 3.1415927 + area;
    bool t95 = t25 && 9.8607613e-32 < t93;
    float distance = t26 * unscale;
    float solid_angle = t95 ? t93 * (t58 * t13) * 6.2831855 : 0.0;
    float projected_above = (9.403955e-38 < t94 && t95) ? t94 : 0.0;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    bool t96 = 0.0 < inv_above;
    bool t97 = 0.0 < elevation_sin;
    float t98 = t97 ? inv_above : 0.0;
    float t99 = t96 ? defensive : 0.0 < defensive || !t42 ? 1.0 : 0.0;
    bool t100 = 0.0 < tau;
    bool t101 = t97 && t100 && 0.0 < t98;
    float t102 = t_y * t_y * t_y * shape * t98;
    float t103 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    if (!t97 && t100) {
        float t104 = 1.0 + kappa;
        float t105 = t104 * shape;
        float t106 = 1.0 / (norm * t105);
        float t107 = sqrt(t106);
        float t108 = norm * t107;
        float t109 = (t_x + kappa) * inv_cut_1 - 0.5;
        float t110 = t109 * t109;
        float t111 = mad(mad(mad(-0.026061837, t110, -0.06372378), t110, -0.11762552), t110, -0.23594604);
        float t112 = mad(mad(mad(0.05430631, t110, 0.080950715), t110, 0.1684019), t110, 0.32709444);
        float t113 = mad(mad(mad(t111, t110, -0.44721135), t110, -0.7754678), t109, mad(mad(t112, t110, 0.5987523), t110, 0.94559944));
        float t114 = t104 * t113 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t105 * t106);
        float t115 = mad(t114, t105 * t107, -1.0);
        float t116 = 1.0 - t114;
        float t117 = mad(mad(30.011856, t115, mad(-41.541264, t116, -37.009792)), t115, mad(77.96775, t116, 7.470758));
        float t118 = mad(mad(mad(mad(15.716111, t116, 0.0), t116, 9.961183), t116, -2.61785), t116, 0.8681748);
        float t119 = mad(mad(t117, t115, mad(mad(-49.13454, t116, -9.466533), t116, -1.5877596)), t115, t118);
        float t120 = t115 * t119;
        float t121 = mad(mad(7.295638, t115, -7.236236), t115, mad(mad(mad(-11.4868555, t116, 0.0), t116, 0.0), t116, 3.1255686));
        float t122 = mad(mad(mad(13.728438, t116, -7.981878), t116, 2.025724), t116, -0.7334958);
        float t123 = t115 * mad(t121, t115, t122);
        float t124 = mad(mad(-23.220068, t116, 7.332055), t115, mad(mad(mad(9.986537, t116, 25.22195), t116, 0.0), t116, -2.9581387));
        float t125 = mad(mad(mad(-19.722994, t116, 4.6594768), t116, -0.89538246), t116, 0.5143498);
        float t126 = t115 * mad(t124, t115, t125);
        float t127 = mad(mad(mad(1.946617, t115, -3.077631), t115, 1.4945927), t115, -0.24140751);
        float t128 = t115 * t127;
        float t129 = t115 * mad(mad(0.38173297, t115, -0.30305624), t115, 0.05897375);
        coefficients_0 = t108;
        coefficients_1 = t114 - t108 + t120;
        coefficients_2 = t123 - t120;
        coefficients_3 = t126 - t123;
        coefficients_4 = t128 - t126;
        coefficients_5 = t129 - t128;
        coefficients_6 = -t129;
    }
    bool t130 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    bool t131 = t130 && (t96 || (0.0 < t99 && 0.0 < solid_angle));
    spherecap_front_light light;
    light.is_sampled = t131;
    light.solid_angle = t131 ? solid_angle : 0.0;
    light.projected_solid_angle = t131 ? projected_above : 0.0;
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
    light.inv_solid_angle = t95 ? t57 * (inv_radius_sin * inv_radius_sin) * 0.15915494 : 0.0;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t41 * (t27 * t27) * t66, -(radius_cos * t62));
    light.defensive = t99;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.crescent_share = t101 ? t102 : 0.0;
    light.inv_rest = t101 ? 1.0 / (1.0 - t102) : 1.0;
    light.beyond = t101 ? t103 * t103 * t103 * shape_cut : 0.0;
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
    float t76 = mad(zenith, zenith, side * side);
    float t77 = spherecap_max(mad(light.radius_sin, light.radius_sin, -t76), 0.0);
    float t78 = sqrt(t77);
    float t79 = sqrt(mad(light.radius_cos, light.radius_cos, t77));
    float t80 = light.radius_cos * light.radius_cos / (t79 + t78);
    float t81 = mad(light.frame_0.x, t79, mad(light.frame_1.x, zenith, light.frame_2.x * side));
    float t82 = mad(light.frame_0.y, t79, mad(light.frame_1.y, zenith, light.frame_2.y * side));
    float t83 = mad(light.frame_0.z, t79, mad(light.frame_1.z, zenith, light.frame_2.z * side));
    float t84 = t80 * light.inv_radius_sin;
    float t85 = -mad(t79, t78, t76) * light.inv_radius_sin;
    float t86 = t84 * zenith;
    float t87 = t84 * side;
    float t88 = mad(light.frame_0.x, t85, mad(light.frame_1.x, t86, light.frame_2.x * t87));
    float t89 = mad(light.frame_0.y, t85, mad(light.frame_1.y, t86, light.frame_2.y * t87));
    float t90 = mad(light.frame_0.z, t85, mad(light.frame_1.z, t86, light.frame_2.z * t87));
    spherecap_sample sampled;
    sampled.direction = float3(t81, t82, t83);
    sampled.distance = t80 * light.distance;
    sampled.normal = float3(t88, t89, t90);
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
    precise float t19 = t17 + t16;
    precise float t20 = t19 - t17;
    float t21 = spherecap_lost(t10, t10, t14) + spherecap_lost(t11, t11, t15) + spherecap_lost(t12, t12, t16);
    precise float t22 = t21 + (t14 - (t17 - t18) + (t15 - t18) + (t17 - (t19 - t20) + (t16 - t20)));
    precise float t23 = t13 * t13;
    float t24 = t19 - t23 + (t22 - spherecap_lost(t13, t13, t23));
    bool t25 = 0.0 < t24;
    float t26 = sqrt(t19);
    float t27 = 1.0 / t26;
    precise float t28 = normal_x * t10;
    precise float t29 = normal_y * t11;
    precise float t30 = normal_z * t12;
    precise float t31 = t28 + t29;
    precise float t32 = t31 - t28;
    precise float t33 = t31 + t30;
    precise float t34 = t33 - t31;
    float t35 = spherecap_lost(normal_x, t10, t28) + spherecap_lost(normal_y, t11, t29) + spherecap_lost(normal_z, t12, t30);
    precise float t36 = t35 + (t28 - (t31 - t32) + (t29 - t32) + (t31 - (t33 - t34) + (t30 - t34)));
    precise float t37 = t33 + t36;
    precise float t38 = t36 - (t37 - t33);
    float t39 = t13 - t37 - t38;
    float t40 = t13 + t37 + t38;
    float t41 = t39 * t40;
    bool t42 = 0.0 < t8;
    bool t43 = 0.0 < t41 && t25 && t42;
    precise float t44 = normal_z * t11;
    float t45 = spherecap_fused(normal_y, t12, -t44) - spherecap_lost(normal_z, t11, t44);
    precise float t46 = normal_x * t12;
    float t47 = spherecap_fused(normal_z, t10, -t46) - spherecap_lost(normal_x, t12, t46);
    precise float t48 = normal_y * t10;
    float t49 = spherecap_fused(normal_x, t11, -t48) - spherecap_lost(normal_y, t10, t48);
    float t50 = mad(t45, t45, mad(t47, t47, t49 * t49));
    bool t51 = 9.8607613e-32 < t50;
    bool t52 = abs(t10) < abs(t12);
    float t53 = t52 ? 0.0 : -t11;
    float t54 = t52 ? -t12 : t10;
    float t55 = t52 ? t11 : 0.0;
    float t56 = sqrt(spherecap_max(t24, 0.0));
    float radius_cos = t56 * t27;
    float t57 = 1.0 + radius_cos;
    float t58 = 1.0 / (t13 * t57);
    float t59 = t58 * t57;
    float radius_sin = t13 * t27;
    float inv_radius_sin = t26 * t59;
    float t60 = sqrt(t24 + t41);
    float t61 = sqrt(t51 ? t50 : mad(t53, t53, mad(t54, t54, t55 * t55)));
    float elevation_sin = t37 * t27;
    float elevation_cos = (t43 ? t60 : t51 ? t61 : 0.0) * t27;
    float t62 = abs(elevation_sin);
    float t63 = radius_sin * elevation_cos;
    float t64 = spherecap_max(mad(radius_cos, t62, t63), 9.8607613e-32);
    float t65 = 1.0 / (t64 * t61);
    float t66 = t65 * t61;
    float t67 = t65 * t64;
    float frame_2_x = (t51 ? t45 : t53) * t67;
    float frame_2_y = (t51 ? t47 : t54) * t67;
    float frame_2_z = (t51 ? t49 : t55) * t67;
    float frame_0_x = t10 * t27;
    float frame_0_y = t11 * t27;
    float frame_0_z = t12 * t27;
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
    if (t43) {
        float t68 = sqrt(t41);
        float t69 = t60 + t56;
        float t70 = 1.0 / (t60 * t69);
        float t71 = t70 * t69;
        float t72 = t56 * t71;
        float t73 = t68 * t71;
        float t74 = abs(t37) * t59;
        float t75 = t74 * t72;
        float t76 = t72 - 0.5;
        float t77 = t75 - 0.5;
        float t78 = t76 * t76;
        float t79 = t77 * t77;
        float t80 = mad(0.05430631, t78, 0.080950715);
        float t81 = mad(t80, t78, 0.1684019);
        float t82 = mad(t81, t78, 0.32709444);
        float t83 = mad(t82, t78, 0.5987523);
        float t84 = mad(-0.026061837, t78, -0.06372378);
        float t85 = mad(t84, t78, -0.11762552);
        float t86 = mad(t85, t78, -0.23594604);
        float t87 = mad(t86, t78, -0.44721135);
        float t88 = mad(t87, t78, -0.7754678);
        float t89 = mad(t88, t76, mad(t83, t78, 0.94559944));
        float t90 = mad(t77, mad(mad(mad(mad(-0.026061837, t79, t84), t79, t85), t79, t86), t79, t87), mad(mad(mad(mad(0.05430631, t79, t80), t79, t81), t79, t82), t79, t83));
        float t91 = mad(t90, t76 + t77, t88);
        float t92 = mad(t75, t91, t89);
        t_x = t72;
        t_y = t73;
        kappa = t74;
        cut = t75;
        shape = t89;
        shape_cut = mad(t75 - t72, t91, t89);
        norm = t92;
        width = t41 * t70;
        inv_cut_1 = t63 * t66;
        tau = t68 * t59;
        area = t73 * t73 * t73 * (spherecap_min(t39, t40) * t59) * t92;
    }
    float t93 = radius_sin * radius_sin;
    float t94 = t93 * t62 * 3.1415927 + area;
    bool t95 = elevation_sin < 0.0;
    float t96 = t95 ? area : t94;
    float t97 = t95 ? t94 : area;
    bool t98 = t25 && 9.8607613e-32 < t93;
    float distance = t26 * unscale;
    float solid_angle = t98 ? t93 * (t58 * t13) * 6.2831855 : 0.0;
    float projected_above = (9.403955e-38 < t96 && t98) ? t96 : 0.0;
    float projected_below = (9.403955e-38 < t97 && t98) ? t97 : 0.0;
    float inv_above = 0.0 < projected_above ? 1.0 / projected_above : 0.0;
    float inv_below = 0.0 < projected_below ? 1.0 / projected_below : 0.0;
    bool t99 = 0.0 < inv_above + inv_below;
    bool t100 = 0.0 < elevation_sin;
    float t101 = t100 ? inv_above : inv_below;
    float t102 = t99 ? defensive : 0.0 < defensive || !t42 ? 1.0 : 0.0;
    bool t103 = 0.0 < tau;
    bool t104 = t103 && 0.0 < t101;
    float t105 = t_y * t_y * t_y * shape * t101;
    float t106 = t_y * inv_radius_sin;
    float coefficients_0 = 0.0;
    float coefficients_1 = 0.0;
    float coefficients_2 = 0.0;
    float coefficients_3 = 0.0;
    float coefficients_4 = 0.0;
    float coefficients_5 = 0.0;
    float coefficients_6 = 0.0;
    float t107 = 0.0;
    if (t103) {
        float t108 = 1.0 + kappa;
        float t109 = t108 * shape;
        float t110 = 1.0 / (norm * t109);
        float t111 = sqrt(t110);
        float t112 = norm * t111;
        float t113 = (t_x + kappa) * inv_cut_1 - 0.5;
        float t114 = t113 * t113;
        float t115 = mad(mad(mad(-0.026061837, t114, -0.06372378), t114, -0.11762552), t114, -0.23594604);
        float t116 = mad(mad(mad(0.05430631, t114, 0.080950715), t114, 0.1684019), t114, 0.32709444);
        float t117 = mad(mad(mad(t115, t114, -0.44721135), t114, -0.7754678), t113, mad(mad(t116, t114, 0.5987523), t114, 0.94559944));
        float t118 = t108 * t117 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t109 * t110);
        float t119 = mad(t118, t109 * t111, -1.0);
        float t120 = 1.0 - t118;
        float t121 = mad(mad(30.011856, t119, mad(-41.541264, t120, -37.009792)), t119, mad(77.96775, t120, 7.470758));
        float t122 = mad(mad(mad(mad(15.716111, t120, 0.0), t120, 9.961183), t120, -2.61785), t120, 0.8681748);
        float t123 = mad(mad(t121, t119, mad(mad(-49.13454, t120, -9.466533), t120, -1.5877596)), t119, t122);
        float t124 = t119 * t123;
        float t125 = mad(mad(7.295638, t119, -7.236236), t119, mad(mad(mad(-11.4868555, t120, 0.0), t120, 0.0), t120, 3.1255686));
        float t126 = mad(mad(mad(13.728438, t120, -7.981878), t120, 2.025724), t120, -0.7334958);
        float t127 = t119 * mad(t125, t119, t126);
        float t128 = mad(mad(-23.220068, t120, 7.332055), t119, mad(mad(mad(9.986537, t120, 25.22195), t120, 0.0), t120, -2.9581387));
        float t129 = mad(mad(mad(-19.722994, t120, 4.6594768), t120, -0.89538246), t120, 0.5143498);
        float t130 = t119 * mad(t128, t119, t129);
        float t131 = mad(mad(mad(1.946617, t119, -3.077631), t119, 1.4945927), t119, -0.24140751);
        float t132 = t119 * t131;
        float t133 = t119 * mad(mad(0.38173297, t119, -0.30305624), t119, 0.05897375);
        float t134 = 1.0 / (elevation_cos * elevation_cos);
        float t135 = tau * tau;
        float t136 = t135 * t134 / (1.0 + t_x);
        float t137 = kappa - 0.5;
        float t138 = cut - 0.5;
        float t139 = t137 * t137;
        float t140 = t138 * t138;
        float t141 = mad(0.05430631, t139, 0.080950715);
        float t142 = mad(t141, t139, 0.1684019);
        float t143 = mad(t142, t139, 0.32709444);
        float t144 = mad(mad(mad(mad(0.05430631, t140, t141), t140, t142), t140, t143), t140, mad(t143, t139, 0.5987523));
        float t145 = mad(-0.026061837, t139, -0.06372378);
        float t146 = mad(t145, t139, -0.11762552);
        float t147 = mad(t146, t139, -0.23594604);
        float t148 = mad(t147, t139, -0.44721135);
        float t149 = mad(mad(mad(mad(-0.026061837, t140, t145), t140, t146), t140, t147), t140, t148);
        float t150 = mad(kappa * t136, mad(mad(t138, t149, t144), t137 + t138, mad(t148, t139, -0.7754678)), mad(shape_cut, t136 - kappa * kappa, kappa) * t134);
        float t151 = spherecap_min(spherecap_max(t135 * tau * (radius_cos + 1.0) * t150 * 0.31830987, 0.0), 0.5);
        coefficients_0 = t112;
        coefficients_1 = t118 - t112 + t124;
        coefficients_2 = t127 - t124;
        coefficients_3 = t130 - t127;
        coefficients_4 = t132 - t130;
        coefficients_5 = t133 - t132;
        coefficients_6 = -t133;
        t107 = t151;
    }
    float share_above = 0.0 < inv_below ? (0.0 < inv_above ? (t100 ? 1.0 - t107 : t107) : 0.0) : 1.0;
    bool t152 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    bool t153 = t152 && (t99 || (0.0 < t102 && 0.0 < solid_angle));
    spherecap_both_light light;
    light.is_sampled = t153;
    light.solid_angle = t153 ? solid_angle : 0.0;
    light.projected_solid_angle = t153 ? projected_above : 0.0;
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
    light.inv_solid_angle = t98 ? t57 * (inv_radius_sin * inv_radius_sin) * 0.15915494 : 0.0;
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t41 * (t27 * t27) * t66, -(radius_cos * t62));
    light.defensive = t102;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
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
    float t84 = mad(zenith, zenith, side * side);
    float t85 = spherecap_max(mad(light.radius_sin, light.radius_sin, -t84), 0.0);
    float t86 = sqrt(t85);
    float t87 = sqrt(mad(light.radius_cos, light.radius_cos, t85));
    float t88 = light.radius_cos * light.radius_cos / (t87 + t86);
    float t89 = mad(light.frame_0.x, t87, mad(light.frame_1.x, zenith, light.frame_2.x * side));
    float t90 = mad(light.frame_0.y, t87, mad(light.frame_1.y, zenith, light.frame_2.y * side));
    float t91 = mad(light.frame_0.z, t87, mad(light.frame_1.z, zenith, light.frame_2.z * side));
    float t92 = t88 * light.inv_radius_sin;
    float t93 = -mad(t87, t86, t84) * light.inv_radius_sin;
    float t94 = t92 * zenith;
    float t95 = t92 * side;
    float t96 = mad(light.frame_0.x, t93, mad(light.frame_1.x, t94, light.frame_2.x * t95));
    float t97 = mad(light.frame_0.y, t93, mad(light.frame_1.y, t94, light.frame_2.y * t95));
    float t98 = mad(light.frame_0.z, t93, mad(light.frame_1.z, t94, light.frame_2.z * t95));
    spherecap_sample sampled;
    sampled.direction = float3(t89, t90, t91);
    sampled.distance = t88 * light.distance;
    sampled.normal = float3(t96, t97, t98);
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
