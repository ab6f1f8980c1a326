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
// Roundings that count are kept by bits that are zero, which the compiler cannot know: WGSL has no other word for that.

// The number as it was rounded, which the compiler cannot see through.
fn spherecap_keep(a: f32, unknown_zero: u32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a) | unknown_zero);
}

// The second where one is no number.
fn spherecap_min(a: f32, b: f32) -> f32 {
    return min(b, a);
}

fn spherecap_max(a: f32, b: f32) -> f32 {
    return max(b, a);
}

// What rounding took off the product a b: products of halves are exact (Dekker).
fn spherecap_lost(a: f32, b: f32, product: f32, unknown_zero: u32) -> f32 {
    let a_high = bitcast<f32>(bitcast<u32>(a) & 0xfffff000u);
    let b_high = bitcast<f32>(bitcast<u32>(b) & 0xfffff000u);
    let a_low = spherecap_keep(a - a_high, unknown_zero);
    let b_low = spherecap_keep(b - b_high, unknown_zero);
    var lost = spherecap_keep(a_high * b_high - product, unknown_zero);
    lost = spherecap_keep(lost + a_high * b_low, unknown_zero);
    lost = spherecap_keep(lost + a_low * b_high, unknown_zero);
    return lost + a_low * b_low;
}

// a b + c, rounded as if once where the sum cancels.
fn spherecap_fused(a: f32, b: f32, c: f32, unknown_zero: u32) -> f32 {
    let product = spherecap_keep(a * b, unknown_zero);
    return spherecap_keep(product + c, unknown_zero) + spherecap_lost(a, b, product, unknown_zero);
}

// A number without its sign and its significand.
fn spherecap_power_of_two(a: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a) & 0x7f800000u);
}

// The bits of a number, as a number.
fn spherecap_bits(a: f32) -> f32 {
    return f32(bitcast<i32>(a));
}

// The number of these bits; any number where they are none.
fn spherecap_float_of_bits(a: f32) -> f32 {
    return bitcast<f32>(i32(a));
}

// A sample.
// direction: Unit direction from the shading point.
// distance: Distance to the sphere along it, in the unit of the centre.
// normal: Unit outward normal of the sphere there.
// cosine: Cosine of the direction with the surface's normal: more precise than their product.
// pdf: Density of the direction, per steradian; 0 if nothing is sampled.
// projected_pdf: The same over |cosine|, but never infinite.
struct spherecap_sample {
    direction: vec3f,
    distance: f32,
    normal: vec3f,
    cosine: f32,
    pdf: f32,
    projected_pdf: f32,
}

fn spherecap_no_sample() -> spherecap_sample {
    var sampled: spherecap_sample;
    sampled.direction = vec3f(0.0, 0.0, 0.0);
    sampled.distance = 0.0;
    sampled.normal = vec3f(0.0, 0.0, 0.0);
    sampled.cosine = 0.0;
    sampled.pdf = 0.0;
    sampled.projected_pdf = 0.0;
    return sampled;
}

// A point on a surface that is lit from the front. The normal must be of unit length to single precision.
struct spherecap_surface_light {
    is_sampled: bool,
    solid_angle: f32,
    projected_solid_angle: f32,
    frame_0_x: f32,
    frame_0_y: f32,
    frame_0_z: f32,
    frame_1_x: f32,
    frame_1_y: f32,
    frame_1_z: f32,
    frame_2_x: f32,
    frame_2_y: f32,
    frame_2_z: f32,
    normal_x: f32,
    normal_y: f32,
    normal_z: f32,
    distance: f32,
    radius_sin: f32,
    inv_radius_sin: f32,
    radius_cos: f32,
    elevation_sin: f32,
    elevation_cos: f32,
    kappa: f32,
    tau: f32,
    width: f32,
    cut: f32,
    rise: f32,
    inv_above: f32,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    coefficients_0: f32,
    coefficients_1: f32,
    coefficients_2: f32,
    coefficients_3: f32,
    coefficients_4: f32,
    coefficients_5: f32,
    coefficients_6: f32,
}

fn spherecap_surface_prepare(normal: vec3f, centre: vec3f, radius: f32) -> spherecap_surface_light {
    let unknown_zero = bitcast<u32>(radius) & 0x80000000u;
    let t1 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let t2 = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
    let t3 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t2));
    let t4 = centre.x * t3;
    let t5 = centre.y * t3;
    let t6 = centre.z * t3;
    let t7 = radius * t3;
    let t8 = spherecap_keep(t4 * t4, unknown_zero);
    let t9 = spherecap_keep(t5 * t5, unknown_zero);
    let t10 = spherecap_keep(t6 * t6, unknown_zero);
    let t11 = spherecap_keep(t8 + t9, unknown_zero);
    let t12 = spherecap_keep(t11 - t8, unknown_zero);
    let t13 = spherecap_keep(t8 - spherecap_keep(t11 - t12, unknown_zero), unknown_zero);
    let t14 = spherecap_keep(t11 + t10, unknown_zero);
    let t15 = spherecap_keep(t14 - t11, unknown_zero);
    let t16 = spherecap_keep(t11 - spherecap_keep(t14 - t15, unknown_zero), unknown_zero);
    let t17 = spherecap_lost(t4, t4, t8, unknown_zero) + spherecap_lost(t5, t5, t9, unknown_zero);
    let t18 = t13 + spherecap_keep(t9 - t12, unknown_zero) + (t16 + spherecap_keep(t10 - t15, unknown_zero));
    let t19 = spherecap_keep(t7 * t7, unknown_zero);
    let t20 = t17 + spherecap_lost(t6, t6, t10, unknown_zero) + t18 - spherecap_lost(t7, t7, t19, unknown_zero);
    let t21 = t14 - t19 + t20;
    let t22 = 0.0 < t21;
    let t23 = sqrt(t14);
    let t24 = 1.0 / t23;
    let t25 = spherecap_keep(normal.x * t4, unknown_zero);
    let t26 = spherecap_keep(normal.y * t5, unknown_zero);
    let t27 = spherecap_keep(normal.z * t6, unknown_zero);
    let t28 = spherecap_keep(t25 + t26, unknown_zero);
    let t29 = spherecap_keep(t28 - t25, unknown_zero);
    let t30 = spherecap_keep(t25 - spherecap_keep(t28 - t29, unknown_zero), unknown_zero);
    let t31 = spherecap_keep(t28 + t27, unknown_zero);
    let t32 = spherecap_keep(t31 - t28, unknown_zero);
    let t33 = spherecap_keep(t28 - spherecap_keep(t31 - t32, unknown_zero), unknown_zero);
    let t34 = spherecap_lost(normal.x, t4, t25, unknown_zero) + spherecap_lost(normal.y, t5, t26, unknown_zero);
    let t35 = t30 + spherecap_keep(t26 - t29, unknown_zero) + (t33 + spherecap_keep(t27 - t32, unknown_zero));
    let t36 = t34 + spherecap_lost(normal.z, t6, t27, unknown_zero) + t35;
    let t37 = spherecap_keep(t31 + t36, unknown_zero);
    let t38 = spherecap_keep(t36 - spherecap_keep(t37 - t31, unknown_zero), unknown_zero);
    let t39 = t7 - t37 - t38;
    let t40 = t7 + t37 + t38;
    let t41 = t39 * t40;
    let t42 = 0.0 < t41 && t22;
    let t43 = spherecap_keep(normal.z * t5, unknown_zero);
    let t44 = spherecap_fused(normal.y, t6, -t43, unknown_zero) - spherecap_lost(normal.z, t5, t43, unknown_zero);
    let t45 = spherecap_keep(normal.x * t6, unknown_zero);
    let t46 = spherecap_fused(normal.z, t4, -t45, unknown_zero) - spherecap_lost(normal.x, t6, t45, unknown_zero);
    let t47 = spherecap_keep(normal.y * t4, unknown_zero);
    let t48 = spherecap_fused(normal.x, t5, -t47, unknown_zero) - spherecap_lost(normal.y, t4, t47, unknown_zero);
    let t49 = fma(t44, t44, fma(t46, t46, t48 * t48));
    let t50 = 9.8607613e-32 < t49;
    let t51 = abs(t4) < abs(t6);
    let t52 = select(-t5, 0.0, t51);
    let t53 = select(t4, -t6, t51);
    let t54 = select(0.0, t5, t51);
    let t55 = sqrt(spherecap_max(t21, 0.0));
    let radius_cos = t55 * t24;
    let t56 = 1.0 + radius_cos;
    let t57 = 1.0 / (t7 * t56);
    let t58 = t57 * t56;
    let radius_sin = t7 * t24;
    let inv_radius_sin = t23 * t58;
    let t59 = sqrt(t21 + t41);
    let t60 = sqrt(select(fma(t52, t52, fma(t53, t53, t54 * t54)), t49, t50));
    let elevation_sin = t37 * t24;
    let elevation_cos = select(select(0.0, t60, t50), t59, t42) * t24;
    let t61 = abs(elevation_sin);
    let t62 = radius_sin * elevation_cos;
    let t63 = spherecap_max(fma(radius_cos, t61, t62), 9.8607613e-32);
    let t64 = 1.0 / (t63 * t60);
    let t65 = t64 * t60;
    let t66 = t64 * t63;
    let frame_2_x = select(t52, t44, t50) * t66;
    let frame_2_y = select(t53, t46, t50) * t66;
    let frame_2_z = select(t54, t48, t50) * t66;
    let frame_0_x = t4 * t24;
    let frame_0_y = t5 * t24;
    let frame_0_z = t6 * t24;
    var t_x = 0.0;
    var t_y = 0.0;
    var kappa = 0.0;
    var cut = 0.0;
    var shape = 0.0;
    var shape_cut = 0.0;
    var norm = 0.0;
    var width = 0.0;
    var inv_cut_1 = 0.0;
    var tau = 0.0;
    var area = 0.0;
    if (t42) {
        let t67 = sqrt(t41);
        let t68 = t59 + t55;
        let t69 = 1.0 / (t59 * t68);
        let t70 = t69 * t68;
        let t71 = t55 * t70;
        let t72 = t67 * t70;
        let t73 = abs(t37) * t58;
        let t74 = t73 * t71;
        let t75 = t71 - 0.5;
        let t76 = t74 - 0.5;
        let t77 = t75 * t75;
        let t78 = t76 * t76;
        let t79 = fma(0.05430631, t77, 0.080950715);
        let t80 = fma(t79, t77, 0.1684019);
        let t81 = fma(t80, t77, 0.32709444);
        let t82 = fma(t81, t77, 0.5987523);
        let t83 = fma(-0.026061837, t77, -0.06372378);
        let t84 = fma(t83, t77, -0.11762552);
        let t85 = fma(t84, t77, -0.23594604);
        let t86 = fma(t85, t77, -0.44721135);
        let t87 = fma(t86, t77, -0.7754678);
        let t88 = fma(t87, t75, fma(t82, t77, 0.94559944));
        let t89 = fma(t76, fma(fma(fma(fma(-0.026061837, t78, t83), t78, t84), t78, t85), t78, t86), fma(fma(fma(fma(0.05430631, t78, t79), t78, t80), t78, t81), t78, t82));
        let t90 = fma(t89, t75 + t76, t87);
        let t91 = fma(t74, t90, t88);
        t_x = t71;
        t_y = t72;
        kappa = t73;
        cut = t74;
        shape = t88;
        shape_cut = fma(t74 - t71, t90, t88);
        norm = t91;
        width = t41 * t69;
        inv_cut_1 = t62 * t65;
        tau = t67 * t58;
        area = t72 * t72 * t72 * (spherecap_min(t39, t40) * t58) * t91;
    }
    let t92 = radius_sin * radius_sin;
    let t93 = select(t92 * t61 * 3.1415927 + area, area, elevation_sin < 0.0);
    let t94 = t22 && 9.8607613e-32 < t92;
    let distance = t23 * t2;
    let projected_above = select(0.0, t93, 9.403955e-38 < t93 && t94);
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let t95 = 0.0 < elevation_sin;
    let t96 = select(0.0, inv_above, t95);
    let t97 = 0.0 < tau;
    let t98 = t95 && t97 && 0.0 < t96;
    let t99 = t_y * t_y * t_y * shape * t96;
    let t100 = t_y * inv_radius_sin;
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    if (!t95 && t97) {
        let t101 = 1.0 + kappa;
        let t102 = t101 * shape;
        let t103 = 1.0 / (norm * t102);
        let t104 = sqrt(t103);
        let t105 = norm * t104;
        let t106 = (t_x + kappa) * inv_cut_1 - 0.5;
        let t107 = t106 * t106;
        let t108 = fma(fma(fma(-0.026061837, t107, -0.06372378), t107, -0.11762552), t107, -0.23594604);
        let t109 = fma(fma(fma(0.05430631, t107, 0.080950715), t107, 0.1684019), t107, 0.32709444);
        let t110 = fma(fma(fma(t108, t107, -0.44721135), t107, -0.7754678), t106, fma(fma(t109, t107, 0.5987523), t107, 0.94559944));
        let t111 = t101 * t110 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t102 * t103);
        let t112 = fma(t111, t102 * t104, -1.0);
        let t113 = 1.0 - t111;
        let t114 = fma(fma(30.011856, t112, fma(-41.541264, t113, -37.009792)), t112, fma(77.96775, t113, 7.470758));
        let t115 = fma(fma(fma(fma(15.716111, t113, 0.0), t113, 9.961183), t113, -2.61785), t113, 0.8681748);
        let t116 = fma(fma(t114, t112, fma(fma(-49.13454, t113, -9.466533), t113, -1.5877596)), t112, t115);
        let t117 = t112 * t116;
        let t118 = fma(fma(7.295638, t112, -7.236236), t112, fma(fma(fma(-11.4868555, t113, 0.0), t113, 0.0), t113, 3.1255686));
        let t119 = fma(fma(fma(13.728438, t113, -7.981878), t113, 2.025724), t113, -0.7334958);
        let t120 = t112 * fma(t118, t112, t119);
        let t121 = fma(fma(-23.220068, t113, 7.332055), t112, fma(fma(fma(9.986537, t113, 25.22195), t113, 0.0), t113, -2.9581387));
        let t122 = fma(fma(fma(-19.722994, t113, 4.6594768), t113, -0.89538246), t113, 0.5143498);
        let t123 = t112 * fma(t121, t112, t122);
        let t124 = fma(fma(fma(1.946617, t112, -3.077631), t112, 1.4945927), t112, -0.24140751);
        let t125 = t112 * t124;
        let t126 = t112 * fma(fma(0.38173297, t112, -0.30305624), t112, 0.05897375);
        coefficients_0 = t105;
        coefficients_1 = t111 - t105 + t117;
        coefficients_2 = t120 - t117;
        coefficients_3 = t123 - t120;
        coefficients_4 = t125 - t123;
        coefficients_5 = t126 - t125;
        coefficients_6 = -t126;
    }
    let t127 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    var light: spherecap_surface_light;
    light.is_sampled = t127;
    light.solid_angle = select(0.0, select(0.0, t92 * (t57 * t7) * 6.2831855, t94), t127);
    light.projected_solid_angle = select(0.0, projected_above, t127);
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
    light.rise = spherecap_max(t41 * (t24 * t24) * t65, -(radius_cos * t61));
    light.inv_above = inv_above;
    light.crescent_share = select(0.0, t99, t98);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t99), t98);
    light.beyond = select(0.0, t100 * t100 * t100 * shape_cut, t98);
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

fn spherecap_surface_sample(light: spherecap_surface_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = abs(light.elevation_sin);
    let t2 = 0.0 < light.elevation_sin;
    let t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    let t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    let t5 = t2 && light.crescent_share <= t3;
    let t6 = 1.0 - t4;
    let t7 = t4 - t6;
    let t8 = 4.0 * t4 * t6;
    var t9 = 0.0;
    var t10 = 0.0;
    var t11 = 0.0;
    var t12 = 0.0;
    if (t5) {
        let t13 = spherecap_max((t3 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        let t14 = spherecap_min(t13, 0.99999994);
        let t15 = 3.1415927 - light.beyond;
        let t16 = fma(t14, t15, light.beyond);
        let t17 = (1.0 - t14) * t15;
        t9 = spherecap_min(t16, t17) * 0.53033006;
        t10 = 1.0;
        t11 = 1.0;
        t12 = t16 - t17;
    } else {
        let t18 = sqrt(t8);
        var t19 = 0.0;
        var t20 = 0.0;
        var t21 = 0.0;
        var t22 = 0.0;
        if (t2) {
            t19 = t18;
            t20 = 1.0;
            t21 = t3;
            t22 = light.crescent_share;
        } else {
            let t23 = fma(fma(light.coefficients_6, t8, light.coefficients_4), t8, light.coefficients_2);
            let t24 = fma(fma(light.coefficients_5, t8, light.coefficients_3), t8, light.coefficients_1);
            let t25 = t18 * fma(t24, t18, fma(t23, t8, light.coefficients_0));
            let t26 = sqrt(fma(t7, t7, t25 * t25));
            let t27 = light.tau * t25;
            t19 = t27;
            t20 = fma(t7, t7, t27 * t27);
            t21 = light.width;
            t22 = fma(light.kappa, t25, t26) * fma(light.cut, t25, t26);
        }
        let t28 = t21 / t22;
        let t29 = select(t3, spherecap_min(spherecap_max(t28, 5.9604645e-8), 0.99999994), t2);
        let t30 = select(t28, light.width, t2);
        let t31 = t20 * t30;
        let t32 = t31 * t31;
        let t33 = fma(fma(fma(-0.00060778117, t32, -0.0027203285), t32, -0.10000902), t31, fma(fma(1.0676054e-5, t32, -0.011332183), t32, 1.0000001));
        t9 = t29;
        t10 = t30 * t33;
        t11 = t20;
        t12 = t19;
    }
    let t34 = spherecap_float_of_bits(fma(spherecap_bits(t9), -0.33333334, 1419900500.0));
    let t35 = fma(-(t9 * t34), t34 * t34, 1.0);
    let t36 = t35 * t35;
    let t37 = fma(fma(fma(0.110958695, t36, 0.14403293), t36, 0.22222222), t35, fma(fma(0.12482853, t36, 0.17283951), t36, 0.33333334));
    let t38 = t10 * (t9 * fma(t34, t35 * t37, t34));
    let t39 = t38 * t11;
    let t40 = t39 * t39;
    let t41 = fma(fma(fma(-0.063446075, t40, -0.056249518), t40, 0.0074712755), t40, 0.09996679);
    let t42 = fma(fma(fma(0.022114987, t40, 0.085662976), t40, 0.030445365), t40, 0.03209764);
    let t43 = t38 * fma(t41, t39, fma(t42, t40, 1.0000004));
    let t44 = select(t43, spherecap_min(t43, 1.0), t5);
    let t45 = t11 * t44;
    let t46 = 2.0 - t45;
    let t47 = t44 * t46;
    let t48 = sqrt(t47);
    var t49 = 0.0;
    var t50 = 0.0;
    var t51 = 0.0;
    if (t5) {
        let t52 = light.radius_sin * light.elevation_cos;
        let t53 = select(t46, t45, t12 < 0.0);
        let t54 = 1.0 - t53;
        let t55 = t47 * t8;
        let t56 = spherecap_max(fma(t52, t53, -light.rise), 0.0);
        let t57 = sqrt(fma(t56, t56, light.radius_sin * light.radius_sin * t55));
        let t58 = t1 * light.radius_cos;
        let t59 = fma(light.elevation_cos * t54, fma(t52, t54, -2.0 * t58), light.radius_sin * t55);
        let t60 = light.radius_sin * fma(light.elevation_cos, t59 / (t57 + t58), -(t1 * t1 * t54));
        t49 = t60;
        t50 = light.radius_sin * t48 * t7;
        t51 = t57;
    } else {
        let t61 = t48 * t12;
        t49 = fma(light.elevation_cos, t61, -(select(-t1, t1, t2) * (1.0 - t45)));
        t50 = t48 * t7;
        t51 = t61;
    }
    let t62 = select(0.0, light.inv_above, 0.0 < t51);
    let t63 = fma(t49, t49, t50 * t50);
    let t64 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t63), 0.0);
    let t65 = sqrt(t64);
    let t66 = sqrt(fma(light.radius_cos, light.radius_cos, t64));
    let t67 = light.radius_cos * light.radius_cos / (t66 + t65);
    let t68 = fma(light.frame_0_x, t66, fma(light.frame_1_x, t49, light.frame_2_x * t50));
    let t69 = fma(light.frame_0_y, t66, fma(light.frame_1_y, t49, light.frame_2_y * t50));
    let t70 = fma(light.frame_0_z, t66, fma(light.frame_1_z, t49, light.frame_2_z * t50));
    let t71 = t67 * light.inv_radius_sin;
    let t72 = -fma(t66, t65, t63) * light.inv_radius_sin;
    let t73 = t71 * t49;
    let t74 = t71 * t50;
    let t75 = fma(light.frame_0_x, t72, fma(light.frame_1_x, t73, light.frame_2_x * t74));
    let t76 = fma(light.frame_0_y, t72, fma(light.frame_1_y, t73, light.frame_2_y * t74));
    let t77 = fma(light.frame_0_z, t72, fma(light.frame_1_z, t73, light.frame_2_z * t74));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t68, t69, t70);
    sampled.distance = t67 * light.distance;
    sampled.normal = vec3f(t75, t76, t77);
    sampled.cosine = t51;
    sampled.pdf = t62 * spherecap_min(abs(t51), 3.4028235e38);
    sampled.projected_pdf = t62;
    return sampled;
}

fn spherecap_surface_sample_once(normal: vec3f, centre: vec3f, radius: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_surface_sample(spherecap_surface_prepare(normal, centre, radius), u0, u1);
}

fn spherecap_surface_pdf_direction(light: spherecap_surface_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.frame_0_x, direction.x, fma(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    let t2 = fma(light.frame_1_x, direction.x, fma(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    let t3 = fma(light.frame_2_x, direction.x, fma(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    let t4 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    let t5 = t1 < 0.0;
    let t6 = select(t2, 1.0, t5);
    let t7 = select(t3, 1.0, t5);
    let t8 = select(0.0, light.inv_above, 0.0 < t4) * spherecap_min(abs(t4), 3.4028235e38);
    let t9 = select(0.0, t8, fma(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t10 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return select(0.0, t9, 0.998001 <= t10 && t10 <= 1.002001);
}

fn spherecap_surface_pdf_on_sphere(light: spherecap_surface_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    let t2 = select(0.0, light.inv_above, 0.0 < t1) * spherecap_min(abs(t1), 3.4028235e38);
    let t3 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return select(0.0, t2, 0.998001 <= t3 && t3 <= 1.002001);
}

fn spherecap_surface_importance(normal: vec3f, centre: vec3f, radius: f32, strength: f32) -> f32 {
    let t1 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let t2 = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
    let t3 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t2));
    let t4 = centre.x * t3;
    let t5 = centre.y * t3;
    let t6 = centre.z * t3;
    let t7 = radius * t3;
    let t8 = sqrt(fma(t4, t4, fma(t5, t5, t6 * t6)));
    let t9 = 1.0 / t8;
    let t10 = t7 * t9;
    let t11 = t10 * t10;
    let t12 = 0.0 < radius && t8 * t2 <= 3.4028235e38 && 0.0 < strength && strength <= 3.4028235e38;
    let t13 = fma(normal.x, t4, fma(normal.y, t5, normal.z * t6));
    let t14 = fma(t13, t9, 2.3841858e-7);
    let t15 = fma(t13 + t7, t9, 2.3841858e-7);
    let t16 = t15 * t15 / (fma(t10 - t14, spherecap_max(fma(-t11, t11, 0.9999981), 0.0), t15) * 2.0);
    let t17 = select(select(0.0, t16, 0.0 < t15), t14, t10 <= t14);
    let t18 = fma(0.0, 0.5 - t17, t17);
    let t19 = spherecap_min(spherecap_max(t11 * t18 * strength, 1.1754944e-38), 3.4028235e38);
    let t20 = select(0.0, t19, t11 <= 1.0000019 && 4.9303807e-32 < t11 && t12 && 0.0 < t18);
    return t20;
}


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with the normal.
struct spherecap_front_light {
    is_sampled: bool,
    solid_angle: f32,
    projected_solid_angle: f32,
    frame_0_x: f32,
    frame_0_y: f32,
    frame_0_z: f32,
    frame_1_x: f32,
    frame_1_y: f32,
    frame_1_z: f32,
    frame_2_x: f32,
    frame_2_y: f32,
    frame_2_z: f32,
    normal_x: f32,
    normal_y: f32,
    normal_z: f32,
    distance: f32,
    radius_sin: f32,
    inv_radius_sin: f32,
    radius_cos: f32,
    elevation_sin: f32,
    elevation_cos: f32,
    inv_solid_angle: f32,
    kappa: f32,
    tau: f32,
    width: f32,
    cut: f32,
    rise: f32,
    defensive: f32,
    requested: f32,
    inv_above: f32,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    coefficients_0: f32,
    coefficients_1: f32,
    coefficients_2: f32,
    coefficients_3: f32,
    coefficients_4: f32,
    coefficients_5: f32,
    coefficients_6: f32,
}

fn spherecap_front_prepare(normal: vec3f, centre: vec3f, radius: f32, defensive: f32) -> spherecap_front_light {
    let unknown_zero = bitcast<u32>(radius) & 0x80000000u;
    let t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    var normal_x = 0.0;
    var normal_y = 0.0;
    var normal_z = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        let t2 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        let t3 = spherecap_power_of_two(spherecap_min(t2, 8.5070587e37));
        let t4 = normal.x / t3;
        let t5 = normal.y / t3;
        let t6 = normal.z / t3;
        let t7 = spherecap_max(sqrt(fma(t4, t4, fma(t5, t5, t6 * t6))), 1.1754944e-38);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    let t8 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    let t9 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let t10 = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37));
    let t11 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t10));
    let t12 = centre.x * t11;
    let t13 = centre.y * t11;
    let t14 = centre.z * t11;
    let t15 = radius * t11;
    let t16 = spherecap_keep(t12 * t12, unknown_zero);
    let t17 = spherecap_keep(t13 * t13, unknown_zero);
    let t18 = spherecap_keep(t14 * t14, unknown_zero);
    let t19 = spherecap_keep(t16 + t17, unknown_zero);
    let t20 = spherecap_keep(t19 - t16, unknown_zero);
    let t21 = spherecap_keep(t16 - spherecap_keep(t19 - t20, unknown_zero), unknown_zero);
    let t22 = spherecap_keep(t19 + t18, unknown_zero);
    let t23 = spherecap_keep(t22 - t19, unknown_zero);
    let t24 = spherecap_keep(t19 - spherecap_keep(t22 - t23, unknown_zero), unknown_zero);
    let t25 = spherecap_lost(t12, t12, t16, unknown_zero) + spherecap_lost(t13, t13, t17, unknown_zero);
    let t26 = t21 + spherecap_keep(t17 - t20, unknown_zero) + (t24 + spherecap_keep(t18 - t23, unknown_zero));
    let t27 = spherecap_keep(t15 * t15, unknown_zero);
    let t28 = t25 + spherecap_lost(t14, t14, t18, unknown_zero) + t26 - spherecap_lost(t15, t15, t27, unknown_zero);
    let t29 = t22 - t27 + t28;
    let t30 = 0.0 < t29;
    let t31 = sqrt(t22);
    let t32 = 1.0 / t31;
    let t33 = spherecap_keep(normal_x * t12, unknown_zero);
    let t34 = spherecap_keep(normal_y * t13, unknown_zero);
    let t35 = spherecap_keep(normal_z * t14, unknown_zero);
    let t36 = spherecap_keep(t33 + t34, unknown_zero);
    let t37 = spherecap_keep(t36 - t33, unknown_zero);
    let t38 = spherecap_keep(t33 - spherecap_keep(t36 - t37, unknown_zero), unknown_zero);
    let t39 = spherecap_keep(t36 + t35, unknown_zero);
    let t40 = spherecap_keep(t39 - t36, unknown_zero);
    let t41 = spherecap_keep(t36 - spherecap_keep(t39 - t40, unknown_zero), unknown_zero);
    let t42 = spherecap_lost(normal_x, t12, t33, unknown_zero) + spherecap_lost(normal_y, t13, t34, unknown_zero);
    let t43 = t38 + spherecap_keep(t34 - t37, unknown_zero) + (t41 + spherecap_keep(t35 - t40, unknown_zero));
    let t44 = t42 + spherecap_lost(normal_z, t14, t35, unknown_zero) + t43;
    let t45 = spherecap_keep(t39 + t44, unknown_zero);
    let t46 = spherecap_keep(t44 - spherecap_keep(t45 - t39, unknown_zero), unknown_zero);
    let t47 = t15 - t45 - t46;
    let t48 = t15 + t45 + t46;
    let t49 = t47 * t48;
    let t50 = 0.0 < t8;
    let t51 = 0.0 < t49 && t30 && t50;
    let t52 = spherecap_keep(normal_z * t13, unknown_zero);
    let t53 = spherecap_fused(normal_y, t14, -t52, unknown_zero) - spherecap_lost(normal_z, t13, t52, unknown_zero);
    let t54 = spherecap_keep(normal_x * t14, unknown_zero);
    let t55 = spherecap_fused(normal_z, t12, -t54, unknown_zero) - spherecap_lost(normal_x, t14, t54, unknown_zero);
    let t56 = spherecap_keep(normal_y * t12, unknown_zero);
    let t57 = spherecap_fused(normal_x, t13, -t56, unknown_zero) - spherecap_lost(normal_y, t12, t56, unknown_zero);
    let t58 = fma(t53, t53, fma(t55, t55, t57 * t57));
    let t59 = 9.8607613e-32 < t58;
    let t60 = abs(t12) < abs(t14);
    let t61 = select(-t13, 0.0, t60);
    let t62 = select(t12, -t14, t60);
    let t63 = select(0.0, t13, t60);
    let t64 = sqrt(spherecap_max(t29, 0.0));
    let radius_cos = t64 * t32;
    let t65 = 1.0 + radius_cos;
    let t66 = 1.0 / (t15 * t65);
    let t67 = t66 * t65;
    let radius_sin = t15 * t32;
    let inv_radius_sin = t31 * t67;
    let t68 = sqrt(t29 + t49);
    let t69 = sqrt(select(fma(t61, t61, fma(t62, t62, t63 * t63)), t58, t59));
    let elevation_sin = t45 * t32;
    let elevation_cos = select(select(0.0, t69, t59), t68, t51) * t32;
    let t70 = abs(elevation_sin);
    let t71 = radius_sin * elevation_cos;
    let t72 = spherecap_max(fma(radius_cos, t70, t71), 9.8607613e-32);
    let t73 = 1.0 / (t72 * t69);
    let t74 = t73 * t69;
    let t75 = t73 * t72;
    let frame_2_x = select(t61, t53, t59) * t75;
    let frame_2_y = select(t62, t55, t59) * t75;
    let frame_2_z = select(t63, t57, t59) * t75;
    let frame_0_x = t12 * t32;
    let frame_0_y = t13 * t32;
    let frame_0_z = t14 * t32;
    var t_x = 0.0;
    var t_y = 0.0;
    var kappa = 0.0;
    var cut = 0.0;
    var shape = 0.0;
    var shape_cut = 0.0;
    var norm = 0.0;
    var width = 0.0;
    var inv_cut_1 = 0.0;
    var tau = 0.0;
    var area = 0.0;
    if (t51) {
        let t76 = sqrt(t49);
        let t77 = t68 + t64;
        let t78 = 1.0 / (t68 * t77);
        let t79 = t78 * t77;
        let t80 = t64 * t79;
        let t81 = t76 * t79;
        let t82 = abs(t45) * t67;
        let t83 = t82 * t80;
        let t84 = t80 - 0.5;
        let t85 = t83 - 0.5;
        let t86 = t84 * t84;
        let t87 = t85 * t85;
        let t88 = fma(0.05430631, t86, 0.080950715);
        let t89 = fma(t88, t86, 0.1684019);
        let t90 = fma(t89, t86, 0.32709444);
        let t91 = fma(t90, t86, 0.5987523);
        let t92 = fma(-0.026061837, t86, -0.06372378);
        let t93 = fma(t92, t86, -0.11762552);
        let t94 = fma(t93, t86, -0.23594604);
        let t95 = fma(t94, t86, -0.44721135);
        let t96 = fma(t95, t86, -0.7754678);
        let t97 = fma(t96, t84, fma(t91, t86, 0.94559944));
        let t98 = fma(t85, fma(fma(fma(fma(-0.026061837, t87, t92), t87, t93), t87, t94), t87, t95), fma(fma(fma(fma(0.05430631, t87, t88), t87, t89), t87, t90), t87, t91));
        let t99 = fma(t98, t84 + t85, t96);
        let t100 = fma(t83, t99, t97);
        t_x = t80;
        t_y = t81;
        kappa = t82;
        cut = t83;
        shape = t97;
        shape_cut = fma(t83 - t80, t99, t97);
        norm = t100;
        width = t49 * t78;
        inv_cut_1 = t71 * t74;
        tau = t76 * t67;
        area = t81 * t81 * t81 * (spherecap_min(t47, t48) * t67) * t100;
    }
    let t101 = radius_sin * radius_sin;
    let t102 = select(t101 * t70 * 3.1415927 + area, area, elevation_sin < 0.0);
    let t103 = t30 && 9.8607613e-32 < t101;
    let distance = t31 * t10;
    let solid_angle = select(0.0, t101 * (t66 * t15) * 6.2831855, t103);
    let projected_above = select(0.0, t102, 9.403955e-38 < t102 && t103);
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let t104 = 0.0 < inv_above;
    let t105 = 0.0 < elevation_sin;
    let t106 = select(0.0, inv_above, t105);
    let t107 = select(select(0.0, 1.0, 0.0 < defensive || !t50), defensive, t104);
    let t108 = 0.0 < tau;
    let t109 = t105 && t108 && 0.0 < t106;
    let t110 = t_y * t_y * t_y * shape * t106;
    let t111 = t_y * inv_radius_sin;
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    if (!t105 && t108) {
        let t112 = 1.0 + kappa;
        let t113 = t112 * shape;
        let t114 = 1.0 / (norm * t113);
        let t115 = sqrt(t114);
        let t116 = norm * t115;
        let t117 = (t_x + kappa) * inv_cut_1 - 0.5;
        let t118 = t117 * t117;
        let t119 = fma(fma(fma(-0.026061837, t118, -0.06372378), t118, -0.11762552), t118, -0.23594604);
        let t120 = fma(fma(fma(0.05430631, t118, 0.080950715), t118, 0.1684019), t118, 0.32709444);
        let t121 = fma(fma(fma(t119, t118, -0.44721135), t118, -0.7754678), t117, fma(fma(t120, t118, 0.5987523), t118, 0.94559944));
        let t122 = t112 * t121 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t113 * t114);
        let t123 = fma(t122, t113 * t115, -1.0);
        let t124 = 1.0 - t122;
        let t125 = fma(fma(30.011856, t123, fma(-41.541264, t124, -37.009792)), t123, fma(77.96775, t124, 7.470758));
        let t126 = fma(fma(fma(fma(15.716111, t124, 0.0), t124, 9.961183), t124, -2.61785), t124, 0.8681748);
        let t127 = fma(fma(t125, t123, fma(fma(-49.13454, t124, -9.466533), t124, -1.5877596)), t123, t126);
        let t128 = t123 * t127;
        let t129 = fma(fma(7.295638, t123, -7.236236), t123, fma(fma(fma(-11.4868555, t124, 0.0), t124, 0.0), t124, 3.1255686));
        let t130 = fma(fma(fma(13.728438, t124, -7.981878), t124, 2.025724), t124, -0.7334958);
        let t131 = t123 * fma(t129, t123, t130);
        let t132 = fma(fma(-23.220068, t124, 7.332055), t123, fma(fma(fma(9.986537, t124, 25.22195), t124, 0.0), t124, -2.9581387));
        let t133 = fma(fma(fma(-19.722994, t124, 4.6594768), t124, -0.89538246), t124, 0.5143498);
        let t134 = t123 * fma(t132, t123, t133);
        let t135 = fma(fma(fma(1.946617, t123, -3.077631), t123, 1.4945927), t123, -0.24140751);
        let t136 = t123 * t135;
        let t137 = t123 * fma(fma(0.38173297, t123, -0.30305624), t123, 0.05897375);
        coefficients_0 = t116;
        coefficients_1 = t122 - t116 + t128;
        coefficients_2 = t131 - t128;
        coefficients_3 = t134 - t131;
        coefficients_4 = t136 - t134;
        coefficients_5 = t137 - t136;
        coefficients_6 = -t137;
    }
    let t138 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    let t139 = t138 && (t104 || (0.0 < t107 && 0.0 < solid_angle));
    var light: spherecap_front_light;
    light.is_sampled = t139;
    light.solid_angle = select(0.0, solid_angle, t139);
    light.projected_solid_angle = select(0.0, projected_above, t139);
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
    light.inv_solid_angle = select(0.0, t65 * (inv_radius_sin * inv_radius_sin) * 0.15915494, t103);
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t49 * (t32 * t32) * t74, -(radius_cos * t70));
    light.defensive = t107;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.crescent_share = select(0.0, t110, t109);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t110), t109);
    light.beyond = select(0.0, t111 * t111 * t111 * shape_cut, t109);
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

fn spherecap_front_sample(light: spherecap_front_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = abs(light.elevation_sin);
    let t2 = 0.0 < light.elevation_sin;
    let t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    let t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    let t5 = t3 < light.defensive;
    let t6 = 1.0 - light.defensive;
    let t7 = spherecap_max(select(t3 - light.defensive, t3, t5) / select(t6, light.defensive, t5), 5.9604645e-8);
    let t8 = select(t3, spherecap_min(t7, 0.99999994), 0.0 < light.requested);
    let t9 = t5 || (t2 && light.crescent_share <= t8);
    let t10 = 1.0 - t4;
    let t11 = t4 - t10;
    let t12 = 4.0 * t4 * t10;
    var t13 = 0.0;
    var t14 = 0.0;
    var t15 = 0.0;
    var t16 = 0.0;
    if (t9) {
        let t17 = spherecap_max((t8 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        let t18 = select(spherecap_min(t17, 0.99999994), t8, t5);
        let t19 = select(light.beyond, 0.0, t5);
        let t20 = 3.1415927 - t19;
        let t21 = fma(t18, t20, t19);
        let t22 = (1.0 - t18) * t20;
        t13 = spherecap_min(t21, t22) * 0.53033006;
        t14 = 1.0;
        t15 = 1.0;
        t16 = t21 - t22;
    } else {
        let t23 = sqrt(t12);
        var t24 = 0.0;
        var t25 = 0.0;
        var t26 = 0.0;
        var t27 = 0.0;
        if (t2) {
            t24 = t23;
            t25 = 1.0;
            t26 = t8;
            t27 = light.crescent_share;
        } else {
            let t28 = fma(fma(light.coefficients_6, t12, light.coefficients_4), t12, light.coefficients_2);
            let t29 = fma(fma(light.coefficients_5, t12, light.coefficients_3), t12, light.coefficients_1);
            let t30 = t23 * fma(t29, t23, fma(t28, t12, light.coefficients_0));
            let t31 = sqrt(fma(t11, t11, t30 * t30));
            let t32 = light.tau * t30;
            t24 = t32;
            t25 = fma(t11, t11, t32 * t32);
            t26 = light.width;
            t27 = fma(light.kappa, t30, t31) * fma(light.cut, t30, t31);
        }
        let t33 = t26 / t27;
        let t34 = select(t8, spherecap_min(spherecap_max(t33, 5.9604645e-8), 0.99999994), t2);
        let t35 = select(t33, light.width, t2);
        let t36 = t25 * t35;
        let t37 = t36 * t36;
        let t38 = fma(fma(fma(-0.00060778117, t37, -0.0027203285), t37, -0.10000902), t36, fma(fma(1.0676054e-5, t37, -0.011332183), t37, 1.0000001));
        t13 = t34;
        t14 = t35 * t38;
        t15 = t25;
        t16 = t24;
    }
    let t39 = spherecap_float_of_bits(fma(spherecap_bits(t13), -0.33333334, 1419900500.0));
    let t40 = fma(-(t13 * t39), t39 * t39, 1.0);
    let t41 = t40 * t40;
    let t42 = fma(fma(fma(0.110958695, t41, 0.14403293), t41, 0.22222222), t40, fma(fma(0.12482853, t41, 0.17283951), t41, 0.33333334));
    let t43 = t14 * (t13 * fma(t39, t40 * t42, t39));
    let t44 = t43 * t15;
    let t45 = t44 * t44;
    let t46 = fma(fma(fma(-0.063446075, t45, -0.056249518), t45, 0.0074712755), t45, 0.09996679);
    let t47 = fma(fma(fma(0.022114987, t45, 0.085662976), t45, 0.030445365), t45, 0.03209764);
    let t48 = t43 * fma(t46, t44, fma(t47, t45, 1.0000004));
    let t49 = select(t48, spherecap_min(t48, 1.0), t9);
    let t50 = t15 * t49;
    let t51 = 2.0 - t50;
    let t52 = t49 * t51;
    let t53 = sqrt(t52);
    var t54 = 0.0;
    var t55 = 0.0;
    var t56 = 0.0;
    if (t9) {
        let t57 = select(t51, t50, t16 < 0.0);
        var t58 = 0.0;
        var t59 = 0.0;
        var t60 = 0.0;
        if (t5) {
            let t61 = light.solid_angle * 0.15915494;
            let t62 = t61 * (1.0 - t52 * t12);
            let t63 = sqrt(t61 * (2.0 - t62));
            let t64 = (t57 - 1.0) * t63;
            t58 = t64;
            t59 = t53 * t11 * t63;
            t60 = fma(light.elevation_sin, 1.0 - t62, light.elevation_cos * t64);
        } else {
            let t65 = light.radius_sin * light.elevation_cos;
            let t66 = 1.0 - t57;
            let t67 = t52 * t12;
            let t68 = spherecap_max(fma(t65, t57, -light.rise), 0.0);
            let t69 = sqrt(fma(t68, t68, light.radius_sin * light.radius_sin * t67));
            let t70 = t1 * light.radius_cos;
            let t71 = fma(light.elevation_cos * t66, fma(t65, t66, -2.0 * t70), light.radius_sin * t67);
            let t72 = light.radius_sin * fma(light.elevation_cos, t71 / (t69 + t70), -(t1 * t1 * t66));
            t58 = t72;
            t59 = light.radius_sin * t53 * t11;
            t60 = t69;
        }
        t54 = t58;
        t55 = t59;
        t56 = t60;
    } else {
        let t73 = t53 * t16;
        t54 = fma(light.elevation_cos, t73, -(select(-t1, t1, t2) * (1.0 - t50)));
        t55 = t53 * t11;
        t56 = t73;
    }
    let t74 = spherecap_min(abs(t56), 3.4028235e38);
    let t75 = select(0.0, light.inv_above, 0.0 < t56);
    var t76 = 0.0;
    var t77 = 0.0;
    if (0.0 < light.defensive) {
        let t78 = light.defensive * light.inv_solid_angle;
        let t79 = fma(t75, t6, spherecap_min(t78 / spherecap_max(t74, 1.1754944e-38), 3.4028235e38));
        t76 = fma(t75, t6 * t74, t78);
        t77 = spherecap_min(t79, 3.4028235e38);
    } else {
        t76 = t75 * t74;
        t77 = t75;
    }
    let t80 = fma(t54, t54, t55 * t55);
    let t81 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t80), 0.0);
    let t82 = sqrt(t81);
    let t83 = sqrt(fma(light.radius_cos, light.radius_cos, t81));
    let t84 = light.radius_cos * light.radius_cos / (t83 + t82);
    let t85 = fma(light.frame_0_x, t83, fma(light.frame_1_x, t54, light.frame_2_x * t55));
    let t86 = fma(light.frame_0_y, t83, fma(light.frame_1_y, t54, light.frame_2_y * t55));
    let t87 = fma(light.frame_0_z, t83, fma(light.frame_1_z, t54, light.frame_2_z * t55));
    let t88 = t84 * light.inv_radius_sin;
    let t89 = -fma(t83, t82, t80) * light.inv_radius_sin;
    let t90 = t88 * t54;
    let t91 = t88 * t55;
    let t92 = fma(light.frame_0_x, t89, fma(light.frame_1_x, t90, light.frame_2_x * t91));
    let t93 = fma(light.frame_0_y, t89, fma(light.frame_1_y, t90, light.frame_2_y * t91));
    let t94 = fma(light.frame_0_z, t89, fma(light.frame_1_z, t90, light.frame_2_z * t91));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t85, t86, t87);
    sampled.distance = t84 * light.distance;
    sampled.normal = vec3f(t92, t93, t94);
    sampled.cosine = t56;
    sampled.pdf = t76;
    sampled.projected_pdf = t77;
    return sampled;
}

fn spherecap_front_sample_once(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_front_sample(spherecap_front_prepare(normal, centre, radius, defensive), u0, u1);
}

fn spherecap_front_pdf_direction(light: spherecap_front_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.frame_0_x, direction.x, fma(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    let t2 = fma(light.frame_1_x, direction.x, fma(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    let t3 = fma(light.frame_2_x, direction.x, fma(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    let t4 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    let t5 = t1 < 0.0;
    let t6 = select(t2, 1.0, t5);
    let t7 = select(t3, 1.0, t5);
    let t8 = spherecap_min(abs(t4), 3.4028235e38);
    let t9 = select(0.0, light.inv_above, 0.0 < t4);
    let t10 = fma(t9, (1.0 - light.defensive) * t8, light.defensive * light.inv_solid_angle);
    let t11 = select(0.0, select(t9 * t8, t10, 0.0 < light.defensive), fma(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t12 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return select(0.0, t11, 0.998001 <= t12 && t12 <= 1.002001);
}

fn spherecap_front_pdf_on_sphere(light: spherecap_front_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    let t2 = spherecap_min(abs(t1), 3.4028235e38);
    let t3 = select(0.0, light.inv_above, 0.0 < t1);
    let t4 = fma(t3, (1.0 - light.defensive) * t2, light.defensive * light.inv_solid_angle);
    let t5 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    let t6 = select(0.0, select(t3 * t2, t4, 0.0 < light.defensive), 0.998001 <= t5 && t5 <= 1.002001);
    return t6;
}

fn spherecap_front_importance(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, strength: f32) -> f32 {
    let t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    var t2 = 0.0;
    var t3 = 0.0;
    var t4 = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        t2 = normal.x;
        t3 = normal.y;
        t4 = normal.z;
    } else {
        let t5 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        let t6 = spherecap_power_of_two(spherecap_min(t5, 8.5070587e37));
        let t7 = normal.x / t6;
        let t8 = normal.y / t6;
        let t9 = normal.z / t6;
        let t10 = spherecap_max(sqrt(fma(t7, t7, fma(t8, t8, t9 * t9))), 1.1754944e-38);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    let t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let t12 = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    let t13 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t12));
    let t14 = centre.x * t13;
    let t15 = centre.y * t13;
    let t16 = centre.z * t13;
    let t17 = radius * t13;
    let t18 = sqrt(fma(t14, t14, fma(t15, t15, t16 * t16)));
    let t19 = 1.0 / t18;
    let t20 = t17 * t19;
    let t21 = t20 * t20;
    let t22 = fma(t2, t2, fma(t3, t3, t4 * t4));
    let t23 = 0.0 <= defensive && defensive <= 1.0 && t22 <= 2.0 && 0.0 < radius && t18 * t12 <= 3.4028235e38;
    let t24 = fma(t2, t14, fma(t3, t15, t4 * t16));
    let t25 = fma(t24, t19, 2.3841858e-7);
    let t26 = fma(t24 + t17, t19, 2.3841858e-7);
    let t27 = t26 * t26 / (fma(t20 - t25, spherecap_max(fma(-t21, t21, 0.9999981), 0.0), t26) * 2.0);
    let t28 = select(select(0.0, t27, 0.0 < t26), t25, t20 <= t25);
    let t29 = select(fma(defensive, 0.5 - t28, t28), 1.0, t22 <= 0.0);
    let t30 = t21 <= 1.0000019 && 4.9303807e-32 < t21 && t23 && 0.0 < strength && strength <= 3.4028235e38;
    let t31 = spherecap_min(spherecap_max(t21 * t29 * strength, 1.1754944e-38), 3.4028235e38);
    return select(0.0, t31, t30 && (0.0 < t29 || 0.0 < defensive));
}


// The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.
struct spherecap_both_light {
    is_sampled: bool,
    solid_angle: f32,
    projected_solid_angle: f32,
    frame_0_x: f32,
    frame_0_y: f32,
    frame_0_z: f32,
    frame_1_x: f32,
    frame_1_y: f32,
    frame_1_z: f32,
    frame_2_x: f32,
    frame_2_y: f32,
    frame_2_z: f32,
    normal_x: f32,
    normal_y: f32,
    normal_z: f32,
    distance: f32,
    radius_sin: f32,
    inv_radius_sin: f32,
    radius_cos: f32,
    elevation_sin: f32,
    elevation_cos: f32,
    inv_solid_angle: f32,
    kappa: f32,
    tau: f32,
    width: f32,
    cut: f32,
    rise: f32,
    defensive: f32,
    requested: f32,
    inv_above: f32,
    inv_below: f32,
    share_above: f32,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    coefficients_0: f32,
    coefficients_1: f32,
    coefficients_2: f32,
    coefficients_3: f32,
    coefficients_4: f32,
    coefficients_5: f32,
    coefficients_6: f32,
}

fn spherecap_both_prepare(normal: vec3f, centre: vec3f, radius: f32, defensive: f32) -> spherecap_both_light {
    let unknown_zero = bitcast<u32>(radius) & 0x80000000u;
    let t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    var normal_x = 0.0;
    var normal_y = 0.0;
    var normal_z = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        let t2 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        let t3 = spherecap_power_of_two(spherecap_min(t2, 8.5070587e37));
        let t4 = normal.x / t3;
        let t5 = normal.y / t3;
        let t6 = normal.z / t3;
        let t7 = spherecap_max(sqrt(fma(t4, t4, fma(t5, t5, t6 * t6))), 1.1754944e-38);
        normal_x = t4 / t7;
        normal_y = t5 / t7;
        normal_z = t6 / t7;
    }
    let t8 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    let t9 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let t10 = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37));
    let t11 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t10));
    let t12 = centre.x * t11;
    let t13 = centre.y * t11;
    let t14 = centre.z * t11;
    let t15 = radius * t11;
    let t16 = spherecap_keep(t12 * t12, unknown_zero);
    let t17 = spherecap_keep(t13 * t13, unknown_zero);
    let t18 = spherecap_keep(t14 * t14, unknown_zero);
    let t19 = spherecap_keep(t16 + t17, unknown_zero);
    let t20 = spherecap_keep(t19 - t16, unknown_zero);
    let t21 = spherecap_keep(t16 - spherecap_keep(t19 - t20, unknown_zero), unknown_zero);
    let t22 = spherecap_keep(t19 + t18, unknown_zero);
    let t23 = spherecap_keep(t22 - t19, unknown_zero);
    let t24 = spherecap_keep(t19 - spherecap_keep(t22 - t23, unknown_zero), unknown_zero);
    let t25 = spherecap_lost(t12, t12, t16, unknown_zero) + spherecap_lost(t13, t13, t17, unknown_zero);
    let t26 = t21 + spherecap_keep(t17 - t20, unknown_zero) + (t24 + spherecap_keep(t18 - t23, unknown_zero));
    let t27 = spherecap_keep(t15 * t15, unknown_zero);
    let t28 = t25 + spherecap_lost(t14, t14, t18, unknown_zero) + t26 - spherecap_lost(t15, t15, t27, unknown_zero);
    let t29 = t22 - t27 + t28;
    let t30 = 0.0 < t29;
    let t31 = sqrt(t22);
    let t32 = 1.0 / t31;
    let t33 = spherecap_keep(normal_x * t12, unknown_zero);
    let t34 = spherecap_keep(normal_y * t13, unknown_zero);
    let t35 = spherecap_keep(normal_z * t14, unknown_zero);
    let t36 = spherecap_keep(t33 + t34, unknown_zero);
    let t37 = spherecap_keep(t36 - t33, unknown_zero);
    let t38 = spherecap_keep(t33 - spherecap_keep(t36 - t37, unknown_zero), unknown_zero);
    let t39 = spherecap_keep(t36 + t35, unknown_zero);
    let t40 = spherecap_keep(t39 - t36, unknown_zero);
    let t41 = spherecap_keep(t36 - spherecap_keep(t39 - t40, unknown_zero), unknown_zero);
    let t42 = spherecap_lost(normal_x, t12, t33, unknown_zero) + spherecap_lost(normal_y, t13, t34, unknown_zero);
    let t43 = t38 + spherecap_keep(t34 - t37, unknown_zero) + (t41 + spherecap_keep(t35 - t40, unknown_zero));
    let t44 = t42 + spherecap_lost(normal_z, t14, t35, unknown_zero) + t43;
    let t45 = spherecap_keep(t39 + t44, unknown_zero);
    let t46 = spherecap_keep(t44 - spherecap_keep(t45 - t39, unknown_zero), unknown_zero);
    let t47 = t15 - t45 - t46;
    let t48 = t15 + t45 + t46;
    let t49 = t47 * t48;
    let t50 = 0.0 < t8;
    let t51 = 0.0 < t49 && t30 && t50;
    let t52 = spherecap_keep(normal_z * t13, unknown_zero);
    let t53 = spherecap_fused(normal_y, t14, -t52, unknown_zero) - spherecap_lost(normal_z, t13, t52, unknown_zero);
    let t54 = spherecap_keep(normal_x * t14, unknown_zero);
    let t55 = spherecap_fused(normal_z, t12, -t54, unknown_zero) - spherecap_lost(normal_x, t14, t54, unknown_zero);
    let t56 = spherecap_keep(normal_y * t12, unknown_zero);
    let t57 = spherecap_fused(normal_x, t13, -t56, unknown_zero) - spherecap_lost(normal_y, t12, t56, unknown_zero);
    let t58 = fma(t53, t53, fma(t55, t55, t57 * t57));
    let t59 = 9.8607613e-32 < t58;
    let t60 = abs(t12) < abs(t14);
    let t61 = select(-t13, 0.0, t60);
    let t62 = select(t12, -t14, t60);
    let t63 = select(0.0, t13, t60);
    let t64 = sqrt(spherecap_max(t29, 0.0));
    let radius_cos = t64 * t32;
    let t65 = 1.0 + radius_cos;
    let t66 = 1.0 / (t15 * t65);
    let t67 = t66 * t65;
    let radius_sin = t15 * t32;
    let inv_radius_sin = t31 * t67;
    let t68 = sqrt(t29 + t49);
    let t69 = sqrt(select(fma(t61, t61, fma(t62, t62, t63 * t63)), t58, t59));
    let elevation_sin = t45 * t32;
    let elevation_cos = select(select(0.0, t69, t59), t68, t51) * t32;
    let t70 = abs(elevation_sin);
    let t71 = radius_sin * elevation_cos;
    let t72 = spherecap_max(fma(radius_cos, t70, t71), 9.8607613e-32);
    let t73 = 1.0 / (t72 * t69);
    let t74 = t73 * t69;
    let t75 = t73 * t72;
    let frame_2_x = select(t61, t53, t59) * t75;
    let frame_2_y = select(t62, t55, t59) * t75;
    let frame_2_z = select(t63, t57, t59) * t75;
    let frame_0_x = t12 * t32;
    let frame_0_y = t13 * t32;
    let frame_0_z = t14 * t32;
    var t_x = 0.0;
    var t_y = 0.0;
    var kappa = 0.0;
    var cut = 0.0;
    var shape = 0.0;
    var shape_cut = 0.0;
    var norm = 0.0;
    var width = 0.0;
    var inv_cut_1 = 0.0;
    var tau = 0.0;
    var area = 0.0;
    if (t51) {
        let t76 = sqrt(t49);
        let t77 = t68 + t64;
        let t78 = 1.0 / (t68 * t77);
        let t79 = t78 * t77;
        let t80 = t64 * t79;
        let t81 = t76 * t79;
        let t82 = abs(t45) * t67;
        let t83 = t82 * t80;
        let t84 = t80 - 0.5;
        let t85 = t83 - 0.5;
        let t86 = t84 * t84;
        let t87 = t85 * t85;
        let t88 = fma(0.05430631, t86, 0.080950715);
        let t89 = fma(t88, t86, 0.1684019);
        let t90 = fma(t89, t86, 0.32709444);
        let t91 = fma(t90, t86, 0.5987523);
        let t92 = fma(-0.026061837, t86, -0.06372378);
        let t93 = fma(t92, t86, -0.11762552);
        let t94 = fma(t93, t86, -0.23594604);
        let t95 = fma(t94, t86, -0.44721135);
        let t96 = fma(t95, t86, -0.7754678);
        let t97 = fma(t96, t84, fma(t91, t86, 0.94559944));
        let t98 = fma(t85, fma(fma(fma(fma(-0.026061837, t87, t92), t87, t93), t87, t94), t87, t95), fma(fma(fma(fma(0.05430631, t87, t88), t87, t89), t87, t90), t87, t91));
        let t99 = fma(t98, t84 + t85, t96);
        let t100 = fma(t83, t99, t97);
        t_x = t80;
        t_y = t81;
        kappa = t82;
        cut = t83;
        shape = t97;
        shape_cut = fma(t83 - t80, t99, t97);
        norm = t100;
        width = t49 * t78;
        inv_cut_1 = t71 * t74;
        tau = t76 * t67;
        area = t81 * t81 * t81 * (spherecap_min(t47, t48) * t67) * t100;
    }
    let t101 = radius_sin * radius_sin;
    let t102 = t101 * t70 * 3.1415927 + area;
    let t103 = elevation_sin < 0.0;
    let t104 = select(t102, area, t103);
    let t105 = select(area, t102, t103);
    let t106 = t30 && 9.8607613e-32 < t101;
    let distance = t31 * t10;
    let solid_angle = select(0.0, t101 * (t66 * t15) * 6.2831855, t106);
    let projected_above = select(0.0, t104, 9.403955e-38 < t104 && t106);
    let projected_below = select(0.0, t105, 9.403955e-38 < t105 && t106);
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let inv_below = select(0.0, 1.0 / projected_below, 0.0 < projected_below);
    let t107 = 0.0 < inv_above + inv_below;
    let t108 = 0.0 < elevation_sin;
    let t109 = select(inv_below, inv_above, t108);
    let t110 = select(select(0.0, 1.0, 0.0 < defensive || !t50), defensive, t107);
    let t111 = 0.0 < tau;
    let t112 = t111 && 0.0 < t109;
    let t113 = t_y * t_y * t_y * shape * t109;
    let t114 = t_y * inv_radius_sin;
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    var t115 = 0.0;
    if (t111) {
        let t116 = 1.0 + kappa;
        let t117 = t116 * shape;
        let t118 = 1.0 / (norm * t117);
        let t119 = sqrt(t118);
        let t120 = norm * t119;
        let t121 = (t_x + kappa) * inv_cut_1 - 0.5;
        let t122 = t121 * t121;
        let t123 = fma(fma(fma(-0.026061837, t122, -0.06372378), t122, -0.11762552), t122, -0.23594604);
        let t124 = fma(fma(fma(0.05430631, t122, 0.080950715), t122, 0.1684019), t122, 0.32709444);
        let t125 = fma(fma(fma(t123, t122, -0.44721135), t122, -0.7754678), t121, fma(fma(t124, t122, 0.5987523), t122, 0.94559944));
        let t126 = t116 * t125 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t117 * t118);
        let t127 = fma(t126, t117 * t119, -1.0);
        let t128 = 1.0 - t126;
        let t129 = fma(fma(30.011856, t127, fma(-41.541264, t128, -37.009792)), t127, fma(77.96775, t128, 7.470758));
        let t130 = fma(fma(fma(fma(15.716111, t128, 0.0), t128, 9.961183), t128, -2.61785), t128, 0.8681748);
        let t131 = fma(fma(t129, t127, fma(fma(-49.13454, t128, -9.466533), t128, -1.5877596)), t127, t130);
        let t132 = t127 * t131;
        let t133 = fma(fma(7.295638, t127, -7.236236), t127, fma(fma(fma(-11.4868555, t128, 0.0), t128, 0.0), t128, 3.1255686));
        let t134 = fma(fma(fma(13.728438, t128, -7.981878), t128, 2.025724), t128, -0.7334958);
        let t135 = t127 * fma(t133, t127, t134);
        let t136 = fma(fma(-23.220068, t128, 7.332055), t127, fma(fma(fma(9.986537, t128, 25.22195), t128, 0.0), t128, -2.9581387));
        let t137 = fma(fma(fma(-19.722994, t128, 4.6594768), t128, -0.89538246), t128, 0.5143498);
        let t138 = t127 * fma(t136, t127, t137);
        let t139 = fma(fma(fma(1.946617, t127, -3.077631), t127, 1.4945927), t127, -0.24140751);
        let t140 = t127 * t139;
        let t141 = t127 * fma(fma(0.38173297, t127, -0.30305624), t127, 0.05897375);
        let t142 = 1.0 / (elevation_cos * elevation_cos);
        let t143 = tau * tau;
        let t144 = t143 * t142 / (1.0 + t_x);
        let t145 = kappa - 0.5;
        let t146 = cut - 0.5;
        let t147 = t145 * t145;
        let t148 = t146 * t146;
        let t149 = fma(0.05430631, t147, 0.080950715);
        let t150 = fma(t149, t147, 0.1684019);
        let t151 = fma(t150, t147, 0.32709444);
        let t152 = fma(fma(fma(fma(0.05430631, t148, t149), t148, t150), t148, t151), t148, fma(t151, t147, 0.5987523));
        let t153 = fma(-0.026061837, t147, -0.06372378);
        let t154 = fma(t153, t147, -0.11762552);
        let t155 = fma(t154, t147, -0.23594604);
        let t156 = fma(t155, t147, -0.44721135);
        let t157 = fma(fma(fma(fma(-0.026061837, t148, t153), t148, t154), t148, t155), t148, t156);
        let t158 = fma(kappa * t144, fma(fma(t146, t157, t152), t145 + t146, fma(t156, t147, -0.7754678)), fma(shape_cut, t144 - kappa * kappa, kappa) * t142);
        let t159 = spherecap_min(spherecap_max(t143 * tau * (radius_cos + 1.0) * t158 * 0.31830987, 0.0), 0.5);
        coefficients_0 = t120;
        coefficients_1 = t126 - t120 + t132;
        coefficients_2 = t135 - t132;
        coefficients_3 = t138 - t135;
        coefficients_4 = t140 - t138;
        coefficients_5 = t141 - t140;
        coefficients_6 = -t141;
        t115 = t159;
    }
    let share_above = select(1.0, select(0.0, select(t115, 1.0 - t115, t108), 0.0 < inv_above), 0.0 < inv_below);
    let t160 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    let t161 = t160 && (t107 || (0.0 < t110 && 0.0 < solid_angle));
    var light: spherecap_both_light;
    light.is_sampled = t161;
    light.solid_angle = select(0.0, solid_angle, t161);
    light.projected_solid_angle = select(0.0, projected_above, t161);
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
    light.inv_solid_angle = select(0.0, t65 * (inv_radius_sin * inv_radius_sin) * 0.15915494, t106);
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t49 * (t32 * t32) * t74, -(radius_cos * t70));
    light.defensive = t110;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
    light.crescent_share = select(0.0, t113, t112);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t113), t112);
    light.beyond = select(0.0, t114 * t114 * t114 * shape_cut, t112);
    light.coefficients_0 = coefficients_0;
    light.coefficients_1 = coefficients_1;
    light.coefficients_2 = coefficients_2;
    light.coefficients_3 = coefficients_3;
    light.coefficients_4 = coefficients_4;
    light.coefficients_5 = coefficients_5;
    light.coefficients_6 = coefficients_6;
    return light;
}

fn spherecap_both_sample(light: spherecap_both_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = abs(light.elevation_sin);
    let t2 = 0.0 < light.elevation_sin;
    let t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    let t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    let t5 = t3 < light.defensive;
    let t6 = 1.0 - light.defensive;
    let t7 = spherecap_max(select(t3 - light.defensive, t3, t5) / select(t6, light.defensive, t5), 5.9604645e-8);
    let t8 = select(t3, spherecap_min(t7, 0.99999994), 0.0 < light.requested);
    let t9 = t5 || t8 < light.share_above;
    let t10 = 1.0 - light.share_above;
    let t11 = select(t8 - light.share_above, t8, t9) / select(t10, light.share_above, t9);
    let t12 = (t9 && t2) || (!t9 && !t2);
    let t13 = select(spherecap_min(spherecap_max(t11, 5.9604645e-8), 0.99999994), t8, t5);
    let t14 = t5 || (t12 && light.crescent_share <= t13);
    let t15 = 1.0 - t4;
    let t16 = t4 - t15;
    let t17 = 4.0 * t4 * t15;
    var t18 = 0.0;
    var t19 = 0.0;
    var t20 = 0.0;
    var t21 = 0.0;
    if (t14) {
        let t22 = spherecap_max((t13 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
        let t23 = select(spherecap_min(t22, 0.99999994), t13, t5);
        let t24 = select(light.beyond, 0.0, t5);
        let t25 = 3.1415927 - t24;
        let t26 = fma(t23, t25, t24);
        let t27 = (1.0 - t23) * t25;
        t18 = spherecap_min(t26, t27) * 0.53033006;
        t19 = 1.0;
        t20 = 1.0;
        t21 = t26 - t27;
    } else {
        let t28 = sqrt(t17);
        var t29 = 0.0;
        var t30 = 0.0;
        var t31 = 0.0;
        var t32 = 0.0;
        if (t12) {
            t29 = t28;
            t30 = 1.0;
            t31 = t13;
            t32 = light.crescent_share;
        } else {
            let t33 = fma(fma(light.coefficients_6, t17, light.coefficients_4), t17, light.coefficients_2);
            let t34 = fma(fma(light.coefficients_5, t17, light.coefficients_3), t17, light.coefficients_1);
            let t35 = t28 * fma(t34, t28, fma(t33, t17, light.coefficients_0));
            let t36 = sqrt(fma(t16, t16, t35 * t35));
            let t37 = light.tau * t35;
            t29 = t37;
            t30 = fma(t16, t16, t37 * t37);
            t31 = light.width;
            t32 = fma(light.kappa, t35, t36) * fma(light.cut, t35, t36);
        }
        let t38 = t31 / t32;
        let t39 = select(t13, spherecap_min(spherecap_max(t38, 5.9604645e-8), 0.99999994), t12);
        let t40 = select(t38, light.width, t12);
        let t41 = t30 * t40;
        let t42 = t41 * t41;
        let t43 = fma(fma(fma(-0.00060778117, t42, -0.0027203285), t42, -0.10000902), t41, fma(fma(1.0676054e-5, t42, -0.011332183), t42, 1.0000001));
        t18 = t39;
        t19 = t40 * t43;
        t20 = t30;
        t21 = t29;
    }
    let t44 = spherecap_float_of_bits(fma(spherecap_bits(t18), -0.33333334, 1419900500.0));
    let t45 = fma(-(t18 * t44), t44 * t44, 1.0);
    let t46 = t45 * t45;
    let t47 = fma(fma(fma(0.110958695, t46, 0.14403293), t46, 0.22222222), t45, fma(fma(0.12482853, t46, 0.17283951), t46, 0.33333334));
    let t48 = t19 * (t18 * fma(t44, t45 * t47, t44));
    let t49 = t48 * t20;
    let t50 = t49 * t49;
    let t51 = fma(fma(fma(-0.063446075, t50, -0.056249518), t50, 0.0074712755), t50, 0.09996679);
    let t52 = fma(fma(fma(0.022114987, t50, 0.085662976), t50, 0.030445365), t50, 0.03209764);
    let t53 = t48 * fma(t51, t49, fma(t52, t50, 1.0000004));
    let t54 = select(t53, spherecap_min(t53, 1.0), t14);
    let t55 = t20 * t54;
    let t56 = 2.0 - t55;
    let t57 = t54 * t56;
    let t58 = sqrt(t57);
    var t59 = 0.0;
    var t60 = 0.0;
    var t61 = 0.0;
    if (t14) {
        let t62 = select(t56, t55, t21 < 0.0);
        var t63 = 0.0;
        var t64 = 0.0;
        var t65 = 0.0;
        if (t5) {
            let t66 = light.solid_angle * 0.15915494;
            let t67 = t66 * (1.0 - t57 * t17);
            let t68 = sqrt(t66 * (2.0 - t67));
            let t69 = (t62 - 1.0) * t68;
            t63 = t69;
            t64 = t58 * t16 * t68;
            t65 = fma(light.elevation_sin, 1.0 - t67, light.elevation_cos * t69);
        } else {
            let t70 = light.radius_sin * light.elevation_cos;
            let t71 = 1.0 - t62;
            let t72 = t57 * t17;
            let t73 = spherecap_max(fma(t70, t62, -light.rise), 0.0);
            let t74 = sqrt(fma(t73, t73, light.radius_sin * light.radius_sin * t72));
            let t75 = t1 * light.radius_cos;
            let t76 = fma(light.elevation_cos * t71, fma(t70, t71, -2.0 * t75), light.radius_sin * t72);
            let t77 = light.radius_sin * fma(light.elevation_cos, t76 / (t74 + t75), -(t1 * t1 * t71));
            t63 = t77;
            t64 = light.radius_sin * t58 * t16;
            t65 = t74;
        }
        t59 = t63;
        t60 = t64;
        t61 = t65;
    } else {
        let t78 = t58 * t21;
        t59 = fma(light.elevation_cos, t78, -(select(-t1, t1, t12) * (1.0 - t55)));
        t60 = t58 * t16;
        t61 = t78;
    }
    let t79 = select(-1.0, 1.0, t9);
    let t80 = t59 * t79;
    let t81 = t61 * t79;
    let t82 = spherecap_min(abs(t81), 3.4028235e38);
    let t83 = select(select(0.0, light.inv_below * t10, t81 < 0.0), light.inv_above * light.share_above, 0.0 < t81);
    var t84 = 0.0;
    var t85 = 0.0;
    if (0.0 < light.defensive) {
        let t86 = light.defensive * light.inv_solid_angle;
        let t87 = fma(t83, t6, spherecap_min(t86 / spherecap_max(t82, 1.1754944e-38), 3.4028235e38));
        t84 = fma(t83, t6 * t82, t86);
        t85 = spherecap_min(t87, 3.4028235e38);
    } else {
        t84 = t83 * t82;
        t85 = t83;
    }
    let t88 = fma(t80, t80, t60 * t60);
    let t89 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t88), 0.0);
    let t90 = sqrt(t89);
    let t91 = sqrt(fma(light.radius_cos, light.radius_cos, t89));
    let t92 = light.radius_cos * light.radius_cos / (t91 + t90);
    let t93 = fma(light.frame_0_x, t91, fma(light.frame_1_x, t80, light.frame_2_x * t60));
    let t94 = fma(light.frame_0_y, t91, fma(light.frame_1_y, t80, light.frame_2_y * t60));
    let t95 = fma(light.frame_0_z, t91, fma(light.frame_1_z, t80, light.frame_2_z * t60));
    let t96 = t92 * light.inv_radius_sin;
    let t97 = -fma(t91, t90, t88) * light.inv_radius_sin;
    let t98 = t96 * t80;
    let t99 = t96 * t60;
    let t100 = fma(light.frame_0_x, t97, fma(light.frame_1_x, t98, light.frame_2_x * t99));
    let t101 = fma(light.frame_0_y, t97, fma(light.frame_1_y, t98, light.frame_2_y * t99));
    let t102 = fma(light.frame_0_z, t97, fma(light.frame_1_z, t98, light.frame_2_z * t99));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t93, t94, t95);
    sampled.distance = t92 * light.distance;
    sampled.normal = vec3f(t100, t101, t102);
    sampled.cosine = t81;
    sampled.pdf = t84;
    sampled.projected_pdf = t85;
    return sampled;
}

fn spherecap_both_sample_once(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_both_sample(spherecap_both_prepare(normal, centre, radius, defensive), u0, u1);
}

fn spherecap_both_pdf_direction(light: spherecap_both_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.frame_0_x, direction.x, fma(light.frame_0_y, direction.y, light.frame_0_z * direction.z));
    let t2 = fma(light.frame_1_x, direction.x, fma(light.frame_1_y, direction.y, light.frame_1_z * direction.z));
    let t3 = fma(light.frame_2_x, direction.x, fma(light.frame_2_y, direction.y, light.frame_2_z * direction.z));
    let t4 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    let t5 = t1 < 0.0;
    let t6 = select(t2, 1.0, t5);
    let t7 = select(t3, 1.0, t5);
    let t8 = spherecap_min(abs(t4), 3.4028235e38);
    let t9 = select(select(0.0, light.inv_below * (1.0 - light.share_above), t4 < 0.0), light.inv_above * light.share_above, 0.0 < t4);
    let t10 = fma(t9, (1.0 - light.defensive) * t8, light.defensive * light.inv_solid_angle);
    let t11 = select(0.0, select(t9 * t8, t10, 0.0 < light.defensive), fma(t6, t6, t7 * t7) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t12 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return select(0.0, t11, 0.998001 <= t12 && t12 <= 1.002001);
}

fn spherecap_both_pdf_on_sphere(light: spherecap_both_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.normal_x, direction.x, fma(light.normal_y, direction.y, light.normal_z * direction.z));
    let t2 = spherecap_min(abs(t1), 3.4028235e38);
    let t3 = select(select(0.0, light.inv_below * (1.0 - light.share_above), t1 < 0.0), light.inv_above * light.share_above, 0.0 < t1);
    let t4 = fma(t3, (1.0 - light.defensive) * t2, light.defensive * light.inv_solid_angle);
    let t5 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    let t6 = select(0.0, select(t3 * t2, t4, 0.0 < light.defensive), 0.998001 <= t5 && t5 <= 1.002001);
    return t6;
}

fn spherecap_both_importance(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, strength: f32) -> f32 {
    let t1 = fma(normal.x, normal.x, fma(normal.y, normal.y, normal.z * normal.z)) - 1.0;
    var t2 = 0.0;
    var t3 = 0.0;
    var t4 = 0.0;
    if (abs(t1) <= 4.7683716e-7) {
        t2 = normal.x;
        t3 = normal.y;
        t4 = normal.z;
    } else {
        let t5 = spherecap_max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.1754944e-38);
        let t6 = spherecap_power_of_two(spherecap_min(t5, 8.5070587e37));
        let t7 = normal.x / t6;
        let t8 = normal.y / t6;
        let t9 = normal.z / t6;
        let t10 = spherecap_max(sqrt(fma(t7, t7, fma(t8, t8, t9 * t9))), 1.1754944e-38);
        t2 = t7 / t10;
        t3 = t8 / t10;
        t4 = t9 / t10;
    }
    let t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let t12 = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    let t13 = spherecap_float_of_bits(2130706400.0 - spherecap_bits(t12));
    let t14 = centre.x * t13;
    let t15 = centre.y * t13;
    let t16 = centre.z * t13;
    let t17 = radius * t13;
    let t18 = sqrt(fma(t14, t14, fma(t15, t15, t16 * t16)));
    let t19 = 1.0 / t18;
    let t20 = t17 * t19;
    let t21 = t20 * t20;
    let t22 = fma(t2, t2, fma(t3, t3, t4 * t4));
    let t23 = 0.0 <= defensive && defensive <= 1.0 && t22 <= 2.0 && 0.0 < radius && t18 * t12 <= 3.4028235e38;
    let t24 = fma(t2, t14, fma(t3, t15, t4 * t16));
    let t25 = spherecap_max(fma(-t21, t21, 0.9999981), 0.0);
    let t26 = fma(t24, t19, 2.3841858e-7);
    let t27 = fma(t24 + t17, t19, 2.3841858e-7);
    let t28 = select(select(0.0, t27 * t27 / (fma(t20 - t26, t25, t27) * 2.0), 0.0 < t27), t26, t20 <= t26);
    let t29 = fma(-t24, t19, 2.3841858e-7);
    let t30 = fma(-t24 + t17, t19, 2.3841858e-7);
    let t31 = select(select(0.0, t30 * t30 / (fma(t20 - t29, t25, t30) * 2.0), 0.0 < t30), t29, t20 <= t29);
    let t32 = t28 + t31;
    let t33 = select(fma(defensive, 0.5 - t32, t32), 1.0, t22 <= 0.0);
    let t34 = t21 <= 1.0000019 && 4.9303807e-32 < t21 && t23 && 0.0 < strength && strength <= 3.4028235e38;
    let t35 = spherecap_min(spherecap_max(t21 * t33 * strength, 1.1754944e-38), 3.4028235e38);
    return select(0.0, t35, t34 && (0.0 < t33 || 0.0 < defensive));
}

