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
    towards_centre: vec3f,
    sideways: vec3f,
    normal: vec3f,
    distance: f32,
    radius_sin: f32,
    radius_cos: f32,
    elevation_sin: f32,
    elevation_cos: f32,
    tau: f32,
    kappa: f32,
    width: f32,
    cut: f32,
    rise: f32,
    inv_above: f32,
    third_axis: vec3f,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    middle: f32,
    half_axis: f32,
    climb: f32,
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
    let t1 = fma(centre.x, centre.x, fma(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0;
    let t2 = t1 && 9.536743e-7 < radius;
    let t3 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let unscale = spherecap_power_of_two(spherecap_min(t3, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t4 = select(centre.x * scale, centre.x, t2);
    let t5 = select(centre.y * scale, centre.y, t2);
    let t6 = select(centre.z * scale, centre.z, t2);
    let t7 = select(radius * scale, radius, t2);
    let t8 = spherecap_keep(t6 * t6, unknown_zero);
    let t9 = fma(t4, t4, fma(t5, t5, t8));
    let t10 = fma(-t7, t7, t9);
    var t11 = 0.0;
    var t12 = 0.0;
    if (t10 < t9 * 0.25) {
        let t13 = spherecap_keep(t4 * t4, unknown_zero);
        let t14 = spherecap_keep(t5 * t5, unknown_zero);
        let t15 = spherecap_keep(t13 + t14, unknown_zero);
        let t16 = spherecap_keep(t15 - t13, unknown_zero);
        let t17 = spherecap_keep(t13 - spherecap_keep(t15 - t16, unknown_zero), unknown_zero);
        let t18 = spherecap_keep(t15 + t8, unknown_zero);
        let t19 = spherecap_keep(t18 - t15, unknown_zero);
        let t20 = spherecap_keep(t15 - spherecap_keep(t18 - t19, unknown_zero), unknown_zero);
        let t21 = spherecap_lost(t4, t4, t13, unknown_zero) + spherecap_lost(t5, t5, t14, unknown_zero);
        let t22 = t17 + spherecap_keep(t14 - t16, unknown_zero) + (t20 + spherecap_keep(t8 - t19, unknown_zero));
        let t23 = spherecap_fused(-t7, t7, t18, unknown_zero) + (t21 + spherecap_lost(t6, t6, t8, unknown_zero) + t22);
        t11 = t18;
        t12 = t23;
    } else {
        t11 = t9;
        t12 = t10;
    }
    let t24 = spherecap_keep(normal.z * t5, unknown_zero);
    let t25 = spherecap_fused(normal.y, t6, -t24, unknown_zero);
    let t26 = spherecap_keep(normal.x * t6, unknown_zero);
    let t27 = spherecap_fused(normal.z, t4, -t26, unknown_zero);
    let t28 = spherecap_keep(normal.y * t4, unknown_zero);
    let t29 = spherecap_fused(normal.x, t5, -t28, unknown_zero);
    let t30 = fma(t25, t25, fma(t27, t27, t29 * t29));
    var t31 = 0.0;
    var t32 = 0.0;
    var t33 = 0.0;
    var t34 = 0.0;
    var t35 = 0.0;
    if (t30 < t11 * 0.015625) {
        let t36 = t25 - spherecap_lost(normal.z, t5, t24, unknown_zero);
        let t37 = t27 - spherecap_lost(normal.x, t6, t26, unknown_zero);
        let t38 = t29 - spherecap_lost(normal.y, t4, t28, unknown_zero);
        let t39 = fma(t36, t36, fma(t37, t37, t38 * t38));
        let t40 = t39 < t11 * 5.169879e-26;
        let t41 = abs(t4) < abs(t6);
        let t42 = select(-t5, 0.0, t41);
        let t43 = select(t4, -t6, t41);
        let t44 = select(0.0, t5, t41);
        let t45 = sqrt(t39);
        t31 = select(t36, t42, t40);
        t32 = select(t37, t43, t40);
        t33 = select(t38, t44, t40);
        t34 = select(t45, sqrt(fma(t42, t42, fma(t43, t43, t44 * t44))), t40);
        t35 = select(t45, 0.0, t40);
    } else {
        let t46 = sqrt(t30);
        t31 = t25;
        t32 = t27;
        t33 = t29;
        t34 = t46;
        t35 = t46;
    }
    let t47 = spherecap_keep(normal.x * t4, unknown_zero);
    let t48 = spherecap_keep(normal.y * t5, unknown_zero);
    let t49 = spherecap_keep(normal.z * t6, unknown_zero);
    let t50 = spherecap_keep(t47 + t48, unknown_zero);
    let t51 = spherecap_keep(t50 - t47, unknown_zero);
    let t52 = spherecap_keep(t47 - spherecap_keep(t50 - t51, unknown_zero), unknown_zero);
    let t53 = spherecap_keep(t50 + t49, unknown_zero);
    let t54 = spherecap_keep(t53 - t50, unknown_zero);
    let t55 = spherecap_keep(t50 - spherecap_keep(t53 - t54, unknown_zero), unknown_zero);
    let t56 = spherecap_lost(normal.x, t4, t47, unknown_zero) + spherecap_lost(normal.y, t5, t48, unknown_zero);
    let t57 = t52 + spherecap_keep(t48 - t51, unknown_zero) + (t55 + spherecap_keep(t49 - t54, unknown_zero));
    let t58 = t56 + spherecap_lost(normal.z, t6, t49, unknown_zero) + t57;
    let t59 = spherecap_keep(t53 + t58, unknown_zero);
    let t60 = spherecap_keep(t58 - spherecap_keep(t59 - t53, unknown_zero), unknown_zero);
    let t61 = t7 - t59 - t60;
    let t62 = t7 + t59 + t60;
    let t63 = t61 * t62;
    let t64 = sqrt(t12);
    let t65 = 0.0 < t12;
    var t_x = 0.0;
    var t_y = 0.0;
    var width = 0.0;
    var kappa = 0.0;
    var cut = 0.0;
    var shape = 0.0;
    var shape_difference = 0.0;
    var norm = 0.0;
    var tau = 0.0;
    var area = 0.0;
    var t66 = 0.0;
    if (0.0 < t63 && t65) {
        let t67 = sqrt(t12 + t63);
        let t68 = sqrt(t63);
        let t69 = 1.0 / (t67 * t7);
        let t70 = t69 * t7;
        let t71 = t69 * t67;
        let t72 = t64 * t70;
        let t73 = t68 * t70;
        let t74 = t73 * t73;
        let t75 = abs(t59) * t71;
        let t76 = t75 * t72;
        let t77 = t72 - 0.5;
        let t78 = t76 - 0.5;
        let t79 = t77 * t77;
        let t80 = t78 * t78;
        let t81 = fma(0.05430631, t79, 0.080950715);
        let t82 = fma(t81, t79, 0.1684019);
        let t83 = fma(t82, t79, 0.32709444);
        let t84 = fma(t83, t79, 0.5987523);
        let t85 = fma(-0.026061837, t79, -0.06372378);
        let t86 = fma(t85, t79, -0.11762552);
        let t87 = fma(t86, t79, -0.23594604);
        let t88 = fma(t87, t79, -0.44721135);
        let t89 = fma(t88, t79, -0.7754678);
        let t90 = fma(t89, t77, fma(t84, t79, 0.94559944));
        let t91 = fma(t78, fma(fma(fma(fma(-0.026061837, t80, t85), t80, t86), t80, t87), t80, t88), fma(fma(fma(fma(0.05430631, t80, t81), t80, t82), t80, t83), t80, t84));
        let t92 = fma(t91, t77 + t78, t89);
        let t93 = fma(t76, t92, t90);
        t_x = t72;
        t_y = t73;
        width = t74 / (1.0 + t72);
        kappa = t75;
        cut = t76;
        shape = t90;
        shape_difference = t92;
        norm = t93;
        tau = t68 * t71;
        area = t74 * t73 * (spherecap_min(t61, t62) * t71) * t93;
        t66 = t67;
    } else {
        t66 = t35;
    }
    let t94 = sqrt(t11);
    let t95 = 1.0 / t94;
    let radius_sin = t7 * t95;
    let radius_cos = t64 * t95;
    let elevation_sin = t59 * t95;
    let elevation_cos = t66 * t95;
    let t96 = abs(elevation_sin);
    let climb = radius_sin * elevation_cos;
    let rise = spherecap_max(t63 * (t95 * t95) / fma(radius_cos, t96, climb), -(radius_cos * t96));
    let t97 = radius_sin * radius_sin;
    let t98 = 0.0 < elevation_sin;
    let t99 = select(area, fma(t97 * t96, 3.1415927, area), t98);
    let t100 = 9.8607613e-32 < t97;
    let t101 = 1.0 / t34;
    let sideways_x = t31 * t101;
    let sideways_y = t32 * t101;
    let sideways_z = t33 * t101;
    let distance = t94 * select(unscale, 1.0, t2);
    let projected_above = select(0.0, t99, 9.403955e-38 < t99 && t100 && t65);
    let t102 = 0.0 < tau;
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let t103 = select(0.0, inv_above, t98);
    let t104 = t102 && t98 && 0.0 < t103;
    let t105 = t_y * t_y * t_y * shape * t103;
    let t106 = t_y / radius_sin;
    let beyond = select(0.0, t106 * t106 * t106 * fma(cut - t_x, shape_difference, shape), t104);
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    if (t102 && !t98) {
        let t107 = 1.0 + kappa;
        let t108 = t107 * shape;
        let t109 = 1.0 / (norm * t108);
        let t110 = sqrt(t109);
        let t111 = norm * t110;
        let t112 = 1.0 / (1.0 + cut);
        let t113 = (t_x + kappa) * t112 - 0.5;
        let t114 = t113 * t113;
        let t115 = fma(fma(fma(-0.026061837, t114, -0.06372378), t114, -0.11762552), t114, -0.23594604);
        let t116 = fma(fma(fma(0.05430631, t114, 0.080950715), t114, 0.1684019), t114, 0.32709444);
        let t117 = fma(fma(fma(t115, t114, -0.44721135), t114, -0.7754678), t113, fma(fma(t116, t114, 0.5987523), t114, 0.94559944));
        let t118 = t107 * t117 * (t112 * t112 * t112) * (t108 * t109);
        let t119 = fma(t118, t108 * t110, -1.0);
        let t120 = 1.0 - t118;
        let t121 = fma(fma(30.011856, t119, fma(-41.541264, t120, -37.009792)), t119, fma(77.96775, t120, 7.470758));
        let t122 = fma(fma(fma(fma(15.716111, t120, 0.0), t120, 9.961183), t120, -2.61785), t120, 0.8681748);
        let t123 = fma(fma(t121, t119, fma(fma(-49.13454, t120, -9.466533), t120, -1.5877596)), t119, t122);
        let t124 = t119 * t123;
        let t125 = fma(fma(7.295638, t119, -7.236236), t119, fma(fma(fma(-11.4868555, t120, 0.0), t120, 0.0), t120, 3.1255686));
        let t126 = fma(fma(fma(13.728438, t120, -7.981878), t120, 2.025724), t120, -0.7334958);
        let t127 = t119 * fma(t125, t119, t126);
        let t128 = fma(fma(-23.220068, t120, 7.332055), t119, fma(fma(fma(9.986537, t120, 25.22195), t120, 0.0), t120, -2.9581387));
        let t129 = fma(fma(fma(-19.722994, t120, 4.6594768), t120, -0.89538246), t120, 0.5143498);
        let t130 = t119 * fma(t128, t119, t129);
        let t131 = fma(fma(fma(1.946617, t119, -3.077631), t119, 1.4945927), t119, -0.24140751);
        let t132 = t119 * t131;
        let t133 = t119 * fma(fma(0.38173297, t119, -0.30305624), t119, 0.05897375);
        coefficients_0 = t111;
        coefficients_1 = t118 - t111 + t124;
        coefficients_2 = t127 - t124;
        coefficients_3 = t130 - t127;
        coefficients_4 = t132 - t130;
        coefficients_5 = t133 - t132;
        coefficients_6 = -t133;
    }
    let t134 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    let t135 = select(0.0, t97 / (1.0 + radius_cos), t100 && 0.0 < radius_cos) * 6.2831855;
    var light: spherecap_surface_light;
    light.is_sampled = t134;
    light.solid_angle = select(0.0, t135, t134);
    light.projected_solid_angle = select(0.0, projected_above, t134);
    light.towards_centre = vec3f(t4 * t95, t5 * t95, t6 * t95);
    light.sideways = vec3f(sideways_x, sideways_y, sideways_z);
    light.normal = vec3f(normal.x, normal.y, normal.z);
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
    light.third_axis = vec3f(fma(sideways_y, normal.z, -(sideways_z * normal.y)), fma(sideways_z, normal.x, -(sideways_x * normal.z)), fma(sideways_x, normal.y, -(sideways_y * normal.x)));
    light.crescent_share = select(0.0, t105, t104);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t105), t104);
    light.beyond = beyond;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t96;
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

fn spherecap_surface_sample(light: spherecap_surface_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = abs(light.elevation_sin);
    let t2 = 0.0 < light.tau;
    let t3 = t2 && !(0.0 < light.elevation_sin);
    let t4 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    let t5 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    let t6 = !t2 || (!t3 && light.crescent_share <= t4);
    let t7 = 1.0 - t5;
    let t8 = t5 - t7;
    let t9 = 4.0 * t5 * t7;
    let t10 = spherecap_max((t4 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
    let t11 = select(t4, spherecap_min(t10, 0.99999994), t2);
    let t12 = select(0.0, light.beyond, t2);
    let t13 = 3.1415927 - t12;
    let t14 = fma(t11, t13, t12);
    let t15 = (1.0 - t11) * t13;
    var t16 = 0.0;
    var t17 = 0.0;
    var t18 = 0.0;
    var t19 = 0.0;
    if (t6) {
        t17 = spherecap_min(t14, t15) * 0.53033006;
        t18 = 1.0;
        t19 = 1.0;
    } else {
        let t20 = sqrt(t9);
        let t21 = fma(fma(light.coefficients_6, t9, light.coefficients_4), t9, light.coefficients_2);
        let t22 = fma(fma(light.coefficients_5, t9, light.coefficients_3), t9, light.coefficients_1);
        let t23 = t20 * fma(t22, t20, fma(t21, t9, light.coefficients_0));
        let t24 = sqrt(fma(t8, t8, t23 * t23));
        let t25 = light.tau * t23;
        let t26 = select(1.0, fma(t8, t8, t25 * t25), t3);
        let t27 = select(light.crescent_share, fma(light.kappa, t23, t24) * fma(light.cut, t23, t24), t3);
        let t28 = select(t4, light.width, t3) / t27;
        let t29 = select(spherecap_min(spherecap_max(t28, 5.9604645e-8), 0.99999994), t4, t3);
        let t30 = select(light.width, t28, t3);
        let t31 = t26 * t30;
        let t32 = t31 * t31;
        let t33 = fma(fma(fma(-0.00060778117, t32, -0.0027203285), t32, -0.10000902), t31, fma(fma(1.0676054e-5, t32, -0.011332183), t32, 1.0000001));
        t16 = select(t20, t25, t3);
        t17 = t29;
        t18 = t30 * t33;
        t19 = t26;
    }
    let t34 = spherecap_float_of_bits(fma(spherecap_bits(t17), -0.33333334, 1419900500.0));
    let t35 = fma(-(t17 * t34), t34 * t34, 1.0);
    let t36 = t35 * t35;
    let t37 = fma(fma(fma(0.110958695, t36, 0.14403293), t36, 0.22222222), t35, fma(fma(0.12482853, t36, 0.17283951), t36, 0.33333334));
    let t38 = t18 * (t17 * fma(t34, t35 * t37, t34));
    let t39 = t38 * t19;
    let t40 = t39 * t39;
    let t41 = fma(fma(fma(-0.063446075, t40, -0.056249518), t40, 0.0074712755), t40, 0.09996679);
    let t42 = fma(fma(fma(0.022114987, t40, 0.085662976), t40, 0.030445365), t40, 0.03209764);
    let t43 = t38 * fma(t41, t39, fma(t42, t40, 1.0000004));
    let t44 = select(t43, spherecap_min(t43, 1.0), t6);
    let t45 = t19 * t44;
    let t46 = 2.0 - t45;
    let t47 = t44 * t46;
    let t48 = sqrt(t47);
    var t49 = 0.0;
    var t50 = 0.0;
    var zenith = 0.0;
    var side = 0.0;
    var cosine = 0.0;
    if (t6) {
        let t51 = select(t46, t45, t14 - t15 < 0.0);
        let t52 = t47 * t9;
        let t53 = 1.0 - t51;
        let t54 = spherecap_max(fma(light.climb, t51, -light.rise), 0.0);
        let t55 = sqrt(fma(t54, t54, light.radius_sin * light.radius_sin * t52));
        let t56 = t1 * light.radius_cos;
        let t57 = fma(light.elevation_cos * t53, fma(light.climb, t53, -2.0 * t56), light.radius_sin * t52);
        let t58 = light.radius_sin * fma(light.elevation_cos, t57 / (t55 + t56), -(t1 * t1 * t53));
        t49 = fma(light.half_axis, t53, light.middle);
        t50 = t55;
        zenith = t58;
        side = light.radius_sin * t48 * t8;
        cosine = t55;
    } else {
        let t59 = t48 * t16;
        let t60 = 1.0 - t45;
        t49 = t60;
        t50 = t59;
        zenith = fma(light.elevation_cos, t59, -(select(t1, -t1, t3) * t60));
        side = t48 * t8;
        cosine = t59;
    }
    let t61 = select(0.0, light.inv_above, 0.0 < cosine);
    let t62 = fma(zenith, zenith, side * side);
    let t63 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t62), 0.0);
    let t64 = sqrt(t63);
    let t65 = sqrt(fma(light.radius_cos, light.radius_cos, t63));
    let t66 = light.radius_cos * light.radius_cos / (t65 + t64);
    let t67 = 1.0 / light.radius_sin;
    let t68 = t66 * t67;
    let t69 = -fma(t65, t64, t62) * t67;
    let t70 = t68 * zenith;
    let t71 = t68 * side;
    let t72 = fma(light.third_axis.x, t49, fma(light.sideways.x, side, light.normal.x * t50));
    let t73 = fma(light.third_axis.y, t49, fma(light.sideways.y, side, light.normal.y * t50));
    let t74 = fma(light.third_axis.z, t49, fma(light.sideways.z, side, light.normal.z * t50));
    let t75 = fma(light.elevation_cos, t69, -(light.elevation_sin * t70));
    let t76 = fma(light.elevation_sin, t69, light.elevation_cos * t70);
    let t77 = fma(light.third_axis.x, t75, fma(light.sideways.x, t71, light.normal.x * t76));
    let t78 = fma(light.third_axis.y, t75, fma(light.sideways.y, t71, light.normal.y * t76));
    let t79 = fma(light.third_axis.z, t75, fma(light.sideways.z, t71, light.normal.z * t76));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t72, t73, t74);
    sampled.distance = t66 * light.distance;
    sampled.normal = vec3f(t77, t78, t79);
    sampled.cosine = cosine;
    sampled.pdf = t61 * spherecap_min(abs(cosine), 3.4028235e38);
    sampled.projected_pdf = t61;
    return sampled;
}

fn spherecap_surface_sample_once(normal: vec3f, centre: vec3f, radius: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_surface_sample(spherecap_surface_prepare(normal, centre, radius), u0, u1);
}

fn spherecap_surface_pdf_direction(light: spherecap_surface_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    let t2 = fma(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    let t3 = fma(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    let t4 = fma(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    let t5 = fma(light.sideways.x, direction.x, fma(light.sideways.y, direction.y, light.sideways.z * direction.z));
    let t6 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    let t7 = fma(light.towards_centre.x, direction.x, t1) < 0.0;
    let t8 = select(fma(t2, direction.x, fma(t3, direction.y, t4 * direction.z)), 1.0, t7);
    let t9 = select(t5, 1.0, t7);
    let t10 = select(0.0, light.inv_above, 0.0 < t6) * spherecap_min(abs(t6), 3.4028235e38);
    let t11 = select(0.0, t10, fma(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t12 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return select(0.0, t11, 0.998001 <= t12 && t12 <= 1.002001);
}

fn spherecap_surface_pdf_on_sphere(light: spherecap_surface_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    let t2 = select(0.0, light.inv_above, 0.0 < t1) * spherecap_min(abs(t1), 3.4028235e38);
    let t3 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return select(0.0, t2, 0.998001 <= t3 && t3 <= 1.002001);
}

fn spherecap_surface_importance(normal: vec3f, centre: vec3f, radius: f32, strength: f32) -> f32 {
    let t1 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let unscale = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t2 = centre.x * scale;
    let t3 = centre.y * scale;
    let t4 = centre.z * scale;
    let t5 = radius * scale;
    let t6 = sqrt(fma(t2, t2, fma(t3, t3, t4 * t4)));
    let t7 = 1.0 / t6;
    let t8 = t5 * t7;
    let t9 = t8 * t8;
    let t10 = 0.0 < radius && t6 * unscale <= 3.4028235e38 && 0.0 < strength && strength <= 3.4028235e38;
    let t11 = fma(normal.x, t2, fma(normal.y, t3, normal.z * t4));
    let t12 = fma(t11, t7, 2.3841858e-7);
    let t13 = fma(t11 + t5, t7, 2.3841858e-7);
    let t14 = t13 * t13 / (fma(t8 - t12, spherecap_max(fma(-t9, t9, 0.9999981), 0.0), t13) * 2.0);
    let t15 = select(select(0.0, t14, 0.0 < t13), t12, t8 <= t12);
    let t16 = fma(0.0, 0.5 - t15, t15);
    let t17 = spherecap_min(spherecap_max(t9 * t16 * strength, 1.1754944e-38), 3.4028235e38);
    let t18 = select(0.0, t17, t9 <= 1.0000019 && 4.9303807e-32 < t9 && t10 && 0.0 < t16);
    return t18;
}


// The same with a normal of any length, or (0, 0, 0) for a point on no surface; and with a defensive fraction, the
// probability of sampling the whole cap by solid angle, 0 unless the integrand is no multiple of the cosine with
// the normal.
struct spherecap_front_light {
    is_sampled: bool,
    solid_angle: f32,
    projected_solid_angle: f32,
    towards_centre: vec3f,
    sideways: vec3f,
    normal: vec3f,
    up: vec3f,
    on_surface: f32,
    distance: f32,
    radius_sin: f32,
    radius_cos: f32,
    elevation_sin: f32,
    elevation_cos: f32,
    tau: f32,
    kappa: f32,
    width: f32,
    cut: f32,
    rise: f32,
    defensive_share: f32,
    requested: f32,
    inv_above: f32,
    third_axis: vec3f,
    height: f32,
    inv_solid_angle: f32,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    middle: f32,
    half_axis: f32,
    climb: f32,
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
    let t9 = fma(centre.x, centre.x, fma(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0;
    let t10 = t9 && 9.536743e-7 < radius;
    let t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t12 = select(centre.x * scale, centre.x, t10);
    let t13 = select(centre.y * scale, centre.y, t10);
    let t14 = select(centre.z * scale, centre.z, t10);
    let t15 = select(radius * scale, radius, t10);
    let t16 = spherecap_keep(t14 * t14, unknown_zero);
    let t17 = fma(t12, t12, fma(t13, t13, t16));
    let t18 = fma(-t15, t15, t17);
    var t19 = 0.0;
    var t20 = 0.0;
    if (t18 < t17 * 0.25) {
        let t21 = spherecap_keep(t12 * t12, unknown_zero);
        let t22 = spherecap_keep(t13 * t13, unknown_zero);
        let t23 = spherecap_keep(t21 + t22, unknown_zero);
        let t24 = spherecap_keep(t23 - t21, unknown_zero);
        let t25 = spherecap_keep(t21 - spherecap_keep(t23 - t24, unknown_zero), unknown_zero);
        let t26 = spherecap_keep(t23 + t16, unknown_zero);
        let t27 = spherecap_keep(t26 - t23, unknown_zero);
        let t28 = spherecap_keep(t23 - spherecap_keep(t26 - t27, unknown_zero), unknown_zero);
        let t29 = spherecap_lost(t12, t12, t21, unknown_zero) + spherecap_lost(t13, t13, t22, unknown_zero);
        let t30 = t25 + spherecap_keep(t22 - t24, unknown_zero) + (t28 + spherecap_keep(t16 - t27, unknown_zero));
        let t31 = spherecap_fused(-t15, t15, t26, unknown_zero) + (t29 + spherecap_lost(t14, t14, t16, unknown_zero) + t30);
        t19 = t26;
        t20 = t31;
    } else {
        t19 = t17;
        t20 = t18;
    }
    let t32 = 0.0 < t8;
    let t33 = spherecap_keep(normal_z * t13, unknown_zero);
    let t34 = spherecap_fused(normal_y, t14, -t33, unknown_zero);
    let t35 = spherecap_keep(normal_x * t14, unknown_zero);
    let t36 = spherecap_fused(normal_z, t12, -t35, unknown_zero);
    let t37 = spherecap_keep(normal_y * t12, unknown_zero);
    let t38 = spherecap_fused(normal_x, t13, -t37, unknown_zero);
    let t39 = fma(t34, t34, fma(t36, t36, t38 * t38));
    var up_x = 0.0;
    var up_y = 0.0;
    var up_z = 0.0;
    var t40 = 0.0;
    var t41 = 0.0;
    var t42 = 0.0;
    var t43 = 0.0;
    var t44 = 0.0;
    if (t39 < t19 * 0.015625) {
        let t45 = t34 - spherecap_lost(normal_z, t13, t33, unknown_zero);
        let t46 = t36 - spherecap_lost(normal_x, t14, t35, unknown_zero);
        let t47 = t38 - spherecap_lost(normal_y, t12, t37, unknown_zero);
        let t48 = fma(t45, t45, fma(t46, t46, t47 * t47));
        let t49 = t48 < t19 * 5.169879e-26;
        let t50 = abs(t12) < abs(t14);
        let t51 = select(-t13, 0.0, t50);
        let t52 = select(t12, -t14, t50);
        let t53 = select(0.0, t13, t50);
        let t54 = sqrt(fma(t51, t51, fma(t52, t52, t53 * t53)));
        let t55 = sqrt(t19);
        let t56 = t55 * t54;
        let t57 = sqrt(t48);
        let t58 = select(normal_x, select(fma(t13, t53, -(t14 * t52)) / t56, normal_x, t32), t49);
        let t59 = select(normal_y, select(fma(t14, t51, -(t12 * t53)) / t56, normal_y, t32), t49);
        let t60 = select(normal_z, select(fma(t12, t52, -(t13 * t51)) / t56, normal_z, t32), t49);
        up_x = t58;
        up_y = t59;
        up_z = t60;
        t40 = select(t45, t51, t49);
        t41 = select(t46, t52, t49);
        t42 = select(t47, t53, t49);
        t43 = select(t57, t54, t49);
        t44 = select(t57, select(t55, 0.0, t32), t49);
    } else {
        let t61 = sqrt(t39);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t40 = t34;
        t41 = t36;
        t42 = t38;
        t43 = t61;
        t44 = t61;
    }
    let t62 = spherecap_keep(normal_x * t12, unknown_zero);
    let t63 = spherecap_keep(normal_y * t13, unknown_zero);
    let t64 = spherecap_keep(normal_z * t14, unknown_zero);
    let t65 = spherecap_keep(t62 + t63, unknown_zero);
    let t66 = spherecap_keep(t65 - t62, unknown_zero);
    let t67 = spherecap_keep(t62 - spherecap_keep(t65 - t66, unknown_zero), unknown_zero);
    let t68 = spherecap_keep(t65 + t64, unknown_zero);
    let t69 = spherecap_keep(t68 - t65, unknown_zero);
    let t70 = spherecap_keep(t65 - spherecap_keep(t68 - t69, unknown_zero), unknown_zero);
    let t71 = spherecap_lost(normal_x, t12, t62, unknown_zero) + spherecap_lost(normal_y, t13, t63, unknown_zero);
    let t72 = t67 + spherecap_keep(t63 - t66, unknown_zero) + (t70 + spherecap_keep(t64 - t69, unknown_zero));
    let t73 = t71 + spherecap_lost(normal_z, t14, t64, unknown_zero) + t72;
    let t74 = spherecap_keep(t68 + t73, unknown_zero);
    let t75 = spherecap_keep(t73 - spherecap_keep(t74 - t68, unknown_zero), unknown_zero);
    let t76 = t15 - t74 - t75;
    let t77 = t15 + t74 + t75;
    let t78 = t76 * t77;
    let t79 = sqrt(t20);
    let t80 = 0.0 < t20;
    var t_x = 0.0;
    var t_y = 0.0;
    var width = 0.0;
    var kappa = 0.0;
    var cut = 0.0;
    var shape = 0.0;
    var shape_difference = 0.0;
    var norm = 0.0;
    var tau = 0.0;
    var area = 0.0;
    var t81 = 0.0;
    if (0.0 < t78 && t32 && t80) {
        let t82 = sqrt(t20 + t78);
        let t83 = sqrt(t78);
        let t84 = 1.0 / (t82 * t15);
        let t85 = t84 * t15;
        let t86 = t84 * t82;
        let t87 = t79 * t85;
        let t88 = t83 * t85;
        let t89 = t88 * t88;
        let t90 = abs(t74) * t86;
        let t91 = t90 * t87;
        let t92 = t87 - 0.5;
        let t93 = t91 - 0.5;
        let t94 = t92 * t92;
        let t95 = t93 * t93;
        let t96 = fma(0.05430631, t94, 0.080950715);
        let t97 = fma(t96, t94, 0.1684019);
        let t98 = fma(t97, t94, 0.32709444);
        let t99 = fma(t98, t94, 0.5987523);
        let t100 = fma(-0.026061837, t94, -0.06372378);
        let t101 = fma(t100, t94, -0.11762552);
        let t102 = fma(t101, t94, -0.23594604);
        let t103 = fma(t102, t94, -0.44721135);
        let t104 = fma(fma(fma(fma(-0.026061837, t95, t100), t95, t101), t95, t102), t95, t103);
        let t105 = fma(t103, t94, -0.7754678);
        let t106 = fma(t105, t92, fma(t99, t94, 0.94559944));
        let t107 = fma(t93, t104, fma(fma(fma(fma(0.05430631, t95, t96), t95, t97), t95, t98), t95, t99));
        let t108 = fma(t107, t92 + t93, t105);
        let t109 = fma(t91, t108, t106);
        t_x = t87;
        t_y = t88;
        width = t89 / (1.0 + t87);
        kappa = t90;
        cut = t91;
        shape = t106;
        shape_difference = t108;
        norm = t109;
        tau = t83 * t86;
        area = t89 * t88 * (spherecap_min(t76, t77) * t86) * t109;
        t81 = t82;
    } else {
        t81 = t44;
    }
    let t110 = sqrt(t19);
    let t111 = 1.0 / t110;
    let radius_sin = t15 * t111;
    let radius_cos = t79 * t111;
    let elevation_sin = t74 * t111;
    let elevation_cos = t81 * t111;
    let t112 = abs(elevation_sin);
    let climb = radius_sin * elevation_cos;
    let rise = spherecap_max(t78 * (t111 * t111) / fma(radius_cos, t112, climb), -(radius_cos * t112));
    let t113 = radius_sin * radius_sin;
    let t114 = 0.0 < elevation_sin;
    let t115 = select(area, fma(t113 * t112, 3.1415927, area), t114);
    let t116 = 9.8607613e-32 < t113;
    let t117 = 1.0 / t43;
    let sideways_x = t40 * t117;
    let sideways_y = t41 * t117;
    let sideways_z = t42 * t117;
    let on_surface = select(0.0, 1.0, t32);
    let distance = t110 * select(unscale, 1.0, t10);
    let projected_above = select(0.0, t115, 9.403955e-38 < t115 && t116 && t80);
    let t118 = 0.0 < tau;
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let t119 = 0.0 < inv_above;
    let t120 = select(0.0, inv_above, t114);
    let defensive_share = select(select(0.0, 1.0, 0.0 < defensive || !(0.0 < on_surface)), defensive, t119);
    let t121 = t118 && t114 && 0.0 < t120;
    let t122 = t_y * t_y * t_y * shape * t120;
    let t123 = t_y / radius_sin;
    let beyond = select(0.0, t123 * t123 * t123 * fma(cut - t_x, shape_difference, shape), t121);
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    if (t118 && !t114) {
        let t124 = 1.0 + kappa;
        let t125 = t124 * shape;
        let t126 = 1.0 / (norm * t125);
        let t127 = sqrt(t126);
        let t128 = norm * t127;
        let t129 = 1.0 / (1.0 + cut);
        let t130 = (t_x + kappa) * t129 - 0.5;
        let t131 = t130 * t130;
        let t132 = fma(fma(fma(-0.026061837, t131, -0.06372378), t131, -0.11762552), t131, -0.23594604);
        let t133 = fma(fma(fma(0.05430631, t131, 0.080950715), t131, 0.1684019), t131, 0.32709444);
        let t134 = fma(fma(fma(t132, t131, -0.44721135), t131, -0.7754678), t130, fma(fma(t133, t131, 0.5987523), t131, 0.94559944));
        let t135 = t124 * t134 * (t129 * t129 * t129) * (t125 * t126);
        let t136 = fma(t135, t125 * t127, -1.0);
        let t137 = 1.0 - t135;
        let t138 = fma(fma(30.011856, t136, fma(-41.541264, t137, -37.009792)), t136, fma(77.96775, t137, 7.470758));
        let t139 = fma(fma(fma(fma(15.716111, t137, 0.0), t137, 9.961183), t137, -2.61785), t137, 0.8681748);
        let t140 = fma(fma(t138, t136, fma(fma(-49.13454, t137, -9.466533), t137, -1.5877596)), t136, t139);
        let t141 = t136 * t140;
        let t142 = fma(fma(7.295638, t136, -7.236236), t136, fma(fma(fma(-11.4868555, t137, 0.0), t137, 0.0), t137, 3.1255686));
        let t143 = fma(fma(fma(13.728438, t137, -7.981878), t137, 2.025724), t137, -0.7334958);
        let t144 = t136 * fma(t142, t136, t143);
        let t145 = fma(fma(-23.220068, t137, 7.332055), t136, fma(fma(fma(9.986537, t137, 25.22195), t137, 0.0), t137, -2.9581387));
        let t146 = fma(fma(fma(-19.722994, t137, 4.6594768), t137, -0.89538246), t137, 0.5143498);
        let t147 = t136 * fma(t145, t136, t146);
        let t148 = fma(fma(fma(1.946617, t136, -3.077631), t136, 1.4945927), t136, -0.24140751);
        let t149 = t136 * t148;
        let t150 = t136 * fma(fma(0.38173297, t136, -0.30305624), t136, 0.05897375);
        coefficients_0 = t128;
        coefficients_1 = t135 - t128 + t141;
        coefficients_2 = t144 - t141;
        coefficients_3 = t147 - t144;
        coefficients_4 = t149 - t147;
        coefficients_5 = t150 - t149;
        coefficients_6 = -t150;
    }
    let t151 = 0.0 < defensive_share;
    let t152 = select(0.0, t113 / (1.0 + radius_cos), t116 && 0.0 < radius_cos);
    let inv_solid_angle = select(0.0, select(0.0, 0.15915494 / t152, 0.0 < t152), t151);
    let t153 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && (t119 || (t151 && 0.0 < inv_solid_angle));
    var light: spherecap_front_light;
    light.is_sampled = t153;
    light.solid_angle = select(0.0, t152 * 6.2831855, t153);
    light.projected_solid_angle = select(0.0, projected_above, t153);
    light.towards_centre = vec3f(t12 * t111, t13 * t111, t14 * t111);
    light.sideways = vec3f(sideways_x, sideways_y, sideways_z);
    light.normal = vec3f(normal_x, normal_y, normal_z);
    light.up = vec3f(up_x, up_y, up_z);
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
    light.third_axis = vec3f(fma(sideways_y, up_z, -(sideways_z * up_y)), fma(sideways_z, up_x, -(sideways_x * up_z)), fma(sideways_x, up_y, -(sideways_y * up_x)));
    light.height = select(0.0, t152, t151);
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = select(0.0, t122, t121);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t122), t121);
    light.beyond = beyond;
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t112;
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

fn spherecap_front_sample(light: spherecap_front_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = abs(light.elevation_sin);
    let t2 = 0.0 < light.defensive_share;
    let t3 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    let t4 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    let t5 = t2 && t3 < light.defensive_share;
    let t6 = 1.0 - light.defensive_share;
    let t7 = select(t3 - light.defensive_share, t3, t5) / select(t6, light.defensive_share, t5);
    let t8 = select(t3, spherecap_min(spherecap_max(t7, 5.9604645e-8), 0.99999994), 0.0 < light.requested);
    let t9 = t5 || !(0.0 < light.tau);
    let t10 = !t9 && !(0.0 < light.elevation_sin);
    let t11 = t9 || (!t10 && light.crescent_share <= t8);
    let t12 = 1.0 - t4;
    let t13 = t4 - t12;
    let t14 = 4.0 * t4 * t12;
    let t15 = spherecap_max((t8 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
    let t16 = select(spherecap_min(t15, 0.99999994), t8, t9);
    let t17 = select(light.beyond, 0.0, t9);
    let t18 = 3.1415927 - t17;
    let t19 = fma(t16, t18, t17);
    let t20 = (1.0 - t16) * t18;
    var t21 = 0.0;
    var t22 = 0.0;
    var t23 = 0.0;
    var t24 = 0.0;
    if (t11) {
        t22 = spherecap_min(t19, t20) * 0.53033006;
        t23 = 1.0;
        t24 = 1.0;
    } else {
        let t25 = sqrt(t14);
        let t26 = fma(fma(light.coefficients_6, t14, light.coefficients_4), t14, light.coefficients_2);
        let t27 = fma(fma(light.coefficients_5, t14, light.coefficients_3), t14, light.coefficients_1);
        let t28 = t25 * fma(t27, t25, fma(t26, t14, light.coefficients_0));
        let t29 = sqrt(fma(t13, t13, t28 * t28));
        let t30 = light.tau * t28;
        let t31 = select(1.0, fma(t13, t13, t30 * t30), t10);
        let t32 = select(light.crescent_share, fma(light.kappa, t28, t29) * fma(light.cut, t28, t29), t10);
        let t33 = select(t8, light.width, t10) / t32;
        let t34 = select(spherecap_min(spherecap_max(t33, 5.9604645e-8), 0.99999994), t8, t10);
        let t35 = select(light.width, t33, t10);
        let t36 = t31 * t35;
        let t37 = t36 * t36;
        let t38 = fma(fma(fma(-0.00060778117, t37, -0.0027203285), t37, -0.10000902), t36, fma(fma(1.0676054e-5, t37, -0.011332183), t37, 1.0000001));
        t21 = select(t25, t30, t10);
        t22 = t34;
        t23 = t35 * t38;
        t24 = t31;
    }
    let t39 = spherecap_float_of_bits(fma(spherecap_bits(t22), -0.33333334, 1419900500.0));
    let t40 = fma(-(t22 * t39), t39 * t39, 1.0);
    let t41 = t40 * t40;
    let t42 = fma(fma(fma(0.110958695, t41, 0.14403293), t41, 0.22222222), t40, fma(fma(0.12482853, t41, 0.17283951), t41, 0.33333334));
    let t43 = t23 * (t22 * fma(t39, t40 * t42, t39));
    let t44 = t43 * t24;
    let t45 = t44 * t44;
    let t46 = fma(fma(fma(-0.063446075, t45, -0.056249518), t45, 0.0074712755), t45, 0.09996679);
    let t47 = fma(fma(fma(0.022114987, t45, 0.085662976), t45, 0.030445365), t45, 0.03209764);
    let t48 = t43 * fma(t46, t44, fma(t47, t45, 1.0000004));
    let t49 = select(t48, spherecap_min(t48, 1.0), t11);
    let t50 = t24 * t49;
    let t51 = 2.0 - t50;
    let t52 = t49 * t51;
    let t53 = sqrt(t52);
    var t54 = 0.0;
    var t55 = 0.0;
    var zenith = 0.0;
    var side = 0.0;
    var cosine = 0.0;
    if (t11) {
        let t56 = select(t51, t50, t19 - t20 < 0.0);
        let t57 = t52 * t14;
        var t58 = 0.0;
        var t59 = 0.0;
        var t60 = 0.0;
        var t61 = 0.0;
        var t62 = 0.0;
        if (t5) {
            let t63 = light.height * (1.0 - t57);
            let t64 = sqrt(light.height * (2.0 - t63));
            let t65 = (t56 - 1.0) * t64;
            let t66 = 1.0 - t63;
            let t67 = fma(light.elevation_sin, t66, light.elevation_cos * t65);
            t58 = fma(light.elevation_cos, t66, -(light.elevation_sin * t65));
            t59 = t67;
            t60 = t65;
            t61 = t53 * t13 * t64;
            t62 = t67 * light.on_surface;
        } else {
            let t68 = 1.0 - t56;
            let t69 = spherecap_max(fma(light.climb, t56, -light.rise), 0.0);
            let t70 = sqrt(fma(t69, t69, light.radius_sin * light.radius_sin * t57));
            let t71 = t1 * light.radius_cos;
            let t72 = fma(light.elevation_cos * t68, fma(light.climb, t68, -2.0 * t71), light.radius_sin * t57);
            let t73 = light.radius_sin * fma(light.elevation_cos, t72 / (t70 + t71), -(t1 * t1 * t68));
            t58 = fma(light.half_axis, t68, light.middle);
            t59 = t70;
            t60 = t73;
            t61 = light.radius_sin * t53 * t13;
            t62 = t70;
        }
        t54 = t58;
        t55 = t59;
        zenith = t60;
        side = t61;
        cosine = t62;
    } else {
        let t74 = t53 * t21;
        let t75 = 1.0 - t50;
        t54 = t75;
        t55 = t74;
        zenith = fma(light.elevation_cos, t74, -(select(t1, -t1, t10) * t75));
        side = t53 * t13;
        cosine = t74;
    }
    let t76 = spherecap_min(abs(cosine), 3.4028235e38);
    let t77 = select(0.0, light.inv_above, 0.0 < cosine);
    let t78 = light.defensive_share * light.inv_solid_angle;
    let t79 = fma(t77, t6, spherecap_min(t78 / spherecap_max(t76, 1.1754944e-38), 3.4028235e38));
    let t80 = fma(zenith, zenith, side * side);
    let t81 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t80), 0.0);
    let t82 = sqrt(t81);
    let t83 = sqrt(fma(light.radius_cos, light.radius_cos, t81));
    let t84 = light.radius_cos * light.radius_cos / (t83 + t82);
    let t85 = 1.0 / light.radius_sin;
    let t86 = t84 * t85;
    let t87 = -fma(t83, t82, t80) * t85;
    let t88 = t86 * zenith;
    let t89 = t86 * side;
    let t90 = fma(light.third_axis.x, t54, fma(light.sideways.x, side, light.up.x * t55));
    let t91 = fma(light.third_axis.y, t54, fma(light.sideways.y, side, light.up.y * t55));
    let t92 = fma(light.third_axis.z, t54, fma(light.sideways.z, side, light.up.z * t55));
    let t93 = fma(light.elevation_cos, t87, -(light.elevation_sin * t88));
    let t94 = fma(light.elevation_sin, t87, light.elevation_cos * t88);
    let t95 = fma(light.third_axis.x, t93, fma(light.sideways.x, t89, light.up.x * t94));
    let t96 = fma(light.third_axis.y, t93, fma(light.sideways.y, t89, light.up.y * t94));
    let t97 = fma(light.third_axis.z, t93, fma(light.sideways.z, t89, light.up.z * t94));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t90, t91, t92);
    sampled.distance = t84 * light.distance;
    sampled.normal = vec3f(t95, t96, t97);
    sampled.cosine = cosine;
    sampled.pdf = select(t77 * t76, fma(t77, t6 * t76, t78), t2);
    sampled.projected_pdf = select(t77, spherecap_min(t79, 3.4028235e38), t2);
    return sampled;
}

fn spherecap_front_sample_once(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_front_sample(spherecap_front_prepare(normal, centre, radius, defensive), u0, u1);
}

fn spherecap_front_pdf_direction(light: spherecap_front_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    let t2 = fma(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    let t3 = fma(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    let t4 = fma(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    let t5 = fma(light.sideways.x, direction.x, fma(light.sideways.y, direction.y, light.sideways.z * direction.z));
    let t6 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    let t7 = fma(light.towards_centre.x, direction.x, t1) < 0.0;
    let t8 = select(fma(t2, direction.x, fma(t3, direction.y, t4 * direction.z)), 1.0, t7);
    let t9 = select(t5, 1.0, t7);
    let t10 = spherecap_min(abs(t6), 3.4028235e38);
    let t11 = select(0.0, light.inv_above, 0.0 < t6);
    let t12 = fma(t11, (1.0 - light.defensive_share) * t10, light.defensive_share * light.inv_solid_angle);
    let t13 = select(0.0, select(t11 * t10, t12, 0.0 < light.defensive_share), fma(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t14 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return select(0.0, t13, 0.998001 <= t14 && t14 <= 1.002001);
}

fn spherecap_front_pdf_on_sphere(light: spherecap_front_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    let t2 = spherecap_min(abs(t1), 3.4028235e38);
    let t3 = select(0.0, light.inv_above, 0.0 < t1);
    let t4 = fma(t3, (1.0 - light.defensive_share) * t2, light.defensive_share * light.inv_solid_angle);
    let t5 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    let t6 = select(0.0, select(t3 * t2, t4, 0.0 < light.defensive_share), 0.998001 <= t5 && t5 <= 1.002001);
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
    let unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t12 = centre.x * scale;
    let t13 = centre.y * scale;
    let t14 = centre.z * scale;
    let t15 = radius * scale;
    let t16 = sqrt(fma(t12, t12, fma(t13, t13, t14 * t14)));
    let t17 = 1.0 / t16;
    let t18 = t15 * t17;
    let t19 = t18 * t18;
    let t20 = fma(t2, t2, fma(t3, t3, t4 * t4));
    let t21 = 0.0 <= defensive && defensive <= 1.0 && t20 <= 2.0 && 0.0 < radius && t16 * unscale <= 3.4028235e38;
    let t22 = fma(t2, t12, fma(t3, t13, t4 * t14));
    let t23 = fma(t22, t17, 2.3841858e-7);
    let t24 = fma(t22 + t15, t17, 2.3841858e-7);
    let t25 = t24 * t24 / (fma(t18 - t23, spherecap_max(fma(-t19, t19, 0.9999981), 0.0), t24) * 2.0);
    let t26 = select(select(0.0, t25, 0.0 < t24), t23, t18 <= t23);
    let t27 = select(fma(defensive, 0.5 - t26, t26), 1.0, t20 <= 0.0);
    let t28 = t19 <= 1.0000019 && 4.9303807e-32 < t19 && t21 && 0.0 < strength && strength <= 3.4028235e38;
    let t29 = spherecap_min(spherecap_max(t19 * t27 * strength, 1.1754944e-38), 3.4028235e38);
    return select(0.0, t29, t28 && (0.0 < t27 || 0.0 < defensive));
}


// The same for surfaces that are lit from both sides, each of which is sampled in proportion to |cosine|.
struct spherecap_both_light {
    is_sampled: bool,
    solid_angle: f32,
    projected_solid_angle: f32,
    towards_centre: vec3f,
    sideways: vec3f,
    normal: vec3f,
    up: vec3f,
    on_surface: f32,
    distance: f32,
    radius_sin: f32,
    radius_cos: f32,
    elevation_sin: f32,
    elevation_cos: f32,
    tau: f32,
    kappa: f32,
    width: f32,
    cut: f32,
    rise: f32,
    defensive_share: f32,
    requested: f32,
    inv_above: f32,
    inv_below: f32,
    sides_share: f32,
    third_axis: vec3f,
    height: f32,
    inv_solid_angle: f32,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    middle: f32,
    half_axis: f32,
    climb: f32,
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
    let t9 = fma(centre.x, centre.x, fma(centre.y, centre.y, centre.z * centre.z)) < 1099511600000.0;
    let t10 = t9 && 9.536743e-7 < radius;
    let t11 = spherecap_max(abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius), 1.1754944e-38);
    let unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t12 = select(centre.x * scale, centre.x, t10);
    let t13 = select(centre.y * scale, centre.y, t10);
    let t14 = select(centre.z * scale, centre.z, t10);
    let t15 = select(radius * scale, radius, t10);
    let t16 = spherecap_keep(t14 * t14, unknown_zero);
    let t17 = fma(t12, t12, fma(t13, t13, t16));
    let t18 = fma(-t15, t15, t17);
    var t19 = 0.0;
    var t20 = 0.0;
    if (t18 < t17 * 0.25) {
        let t21 = spherecap_keep(t12 * t12, unknown_zero);
        let t22 = spherecap_keep(t13 * t13, unknown_zero);
        let t23 = spherecap_keep(t21 + t22, unknown_zero);
        let t24 = spherecap_keep(t23 - t21, unknown_zero);
        let t25 = spherecap_keep(t21 - spherecap_keep(t23 - t24, unknown_zero), unknown_zero);
        let t26 = spherecap_keep(t23 + t16, unknown_zero);
        let t27 = spherecap_keep(t26 - t23, unknown_zero);
        let t28 = spherecap_keep(t23 - spherecap_keep(t26 - t27, unknown_zero), unknown_zero);
        let t29 = spherecap_lost(t12, t12, t21, unknown_zero) + spherecap_lost(t13, t13, t22, unknown_zero);
        let t30 = t25 + spherecap_keep(t22 - t24, unknown_zero) + (t28 + spherecap_keep(t16 - t27, unknown_zero));
        let t31 = spherecap_fused(-t15, t15, t26, unknown_zero) + (t29 + spherecap_lost(t14, t14, t16, unknown_zero) + t30);
        t19 = t26;
        t20 = t31;
    } else {
        t19 = t17;
        t20 = t18;
    }
    let t32 = 0.0 < t8;
    let t33 = spherecap_keep(normal_z * t13, unknown_zero);
    let t34 = spherecap_fused(normal_y, t14, -t33, unknown_zero);
    let t35 = spherecap_keep(normal_x * t14, unknown_zero);
    let t36 = spherecap_fused(normal_z, t12, -t35, unknown_zero);
    let t37 = spherecap_keep(normal_y * t12, unknown_zero);
    let t38 = spherecap_fused(normal_x, t13, -t37, unknown_zero);
    let t39 = fma(t34, t34, fma(t36, t36, t38 * t38));
    var up_x = 0.0;
    var up_y = 0.0;
    var up_z = 0.0;
    var t40 = 0.0;
    var t41 = 0.0;
    var t42 = 0.0;
    var t43 = 0.0;
    var t44 = 0.0;
    if (t39 < t19 * 0.015625) {
        let t45 = t34 - spherecap_lost(normal_z, t13, t33, unknown_zero);
        let t46 = t36 - spherecap_lost(normal_x, t14, t35, unknown_zero);
        let t47 = t38 - spherecap_lost(normal_y, t12, t37, unknown_zero);
        let t48 = fma(t45, t45, fma(t46, t46, t47 * t47));
        let t49 = t48 < t19 * 5.169879e-26;
        let t50 = abs(t12) < abs(t14);
        let t51 = select(-t13, 0.0, t50);
        let t52 = select(t12, -t14, t50);
        let t53 = select(0.0, t13, t50);
        let t54 = sqrt(fma(t51, t51, fma(t52, t52, t53 * t53)));
        let t55 = sqrt(t19);
        let t56 = t55 * t54;
        let t57 = sqrt(t48);
        let t58 = select(normal_x, select(fma(t13, t53, -(t14 * t52)) / t56, normal_x, t32), t49);
        let t59 = select(normal_y, select(fma(t14, t51, -(t12 * t53)) / t56, normal_y, t32), t49);
        let t60 = select(normal_z, select(fma(t12, t52, -(t13 * t51)) / t56, normal_z, t32), t49);
        up_x = t58;
        up_y = t59;
        up_z = t60;
        t40 = select(t45, t51, t49);
        t41 = select(t46, t52, t49);
        t42 = select(t47, t53, t49);
        t43 = select(t57, t54, t49);
        t44 = select(t57, select(t55, 0.0, t32), t49);
    } else {
        let t61 = sqrt(t39);
        up_x = normal_x;
        up_y = normal_y;
        up_z = normal_z;
        t40 = t34;
        t41 = t36;
        t42 = t38;
        t43 = t61;
        t44 = t61;
    }
    let t62 = spherecap_keep(normal_x * t12, unknown_zero);
    let t63 = spherecap_keep(normal_y * t13, unknown_zero);
    let t64 = spherecap_keep(normal_z * t14, unknown_zero);
    let t65 = spherecap_keep(t62 + t63, unknown_zero);
    let t66 = spherecap_keep(t65 - t62, unknown_zero);
    let t67 = spherecap_keep(t62 - spherecap_keep(t65 - t66, unknown_zero), unknown_zero);
    let t68 = spherecap_keep(t65 + t64, unknown_zero);
    let t69 = spherecap_keep(t68 - t65, unknown_zero);
    let t70 = spherecap_keep(t65 - spherecap_keep(t68 - t69, unknown_zero), unknown_zero);
    let t71 = spherecap_lost(normal_x, t12, t62, unknown_zero) + spherecap_lost(normal_y, t13, t63, unknown_zero);
    let t72 = t67 + spherecap_keep(t63 - t66, unknown_zero) + (t70 + spherecap_keep(t64 - t69, unknown_zero));
    let t73 = t71 + spherecap_lost(normal_z, t14, t64, unknown_zero) + t72;
    let t74 = spherecap_keep(t68 + t73, unknown_zero);
    let t75 = spherecap_keep(t73 - spherecap_keep(t74 - t68, unknown_zero), unknown_zero);
    let t76 = t15 - t74 - t75;
    let t77 = t15 + t74 + t75;
    let t78 = t76 * t77;
    let t79 = sqrt(t20);
    let t80 = 0.0 < t20;
    var t_x = 0.0;
    var t_y = 0.0;
    var width = 0.0;
    var kappa = 0.0;
    var cut = 0.0;
    var shape = 0.0;
    var shape_difference = 0.0;
    var norm = 0.0;
    var tau = 0.0;
    var area = 0.0;
    var t81 = 0.0;
    if (0.0 < t78 && t32 && t80) {
        let t82 = sqrt(t20 + t78);
        let t83 = sqrt(t78);
        let t84 = 1.0 / (t82 * t15);
        let t85 = t84 * t15;
        let t86 = t84 * t82;
        let t87 = t79 * t85;
        let t88 = t83 * t85;
        let t89 = t88 * t88;
        let t90 = abs(t74) * t86;
        let t91 = t90 * t87;
        let t92 = t87 - 0.5;
        let t93 = t91 - 0.5;
        let t94 = t92 * t92;
        let t95 = t93 * t93;
        let t96 = fma(0.05430631, t94, 0.080950715);
        let t97 = fma(t96, t94, 0.1684019);
        let t98 = fma(t97, t94, 0.32709444);
        let t99 = fma(t98, t94, 0.5987523);
        let t100 = fma(-0.026061837, t94, -0.06372378);
        let t101 = fma(t100, t94, -0.11762552);
        let t102 = fma(t101, t94, -0.23594604);
        let t103 = fma(t102, t94, -0.44721135);
        let t104 = fma(fma(fma(fma(-0.026061837, t95, t100), t95, t101), t95, t102), t95, t103);
        let t105 = fma(t103, t94, -0.7754678);
        let t106 = fma(t105, t92, fma(t99, t94, 0.94559944));
        let t107 = fma(t93, t104, fma(fma(fma(fma(0.05430631, t95, t96), t95, t97), t95, t98), t95, t99));
        let t108 = fma(t107, t92 + t93, t105);
        let t109 = fma(t91, t108, t106);
        t_x = t87;
        t_y = t88;
        width = t89 / (1.0 + t87);
        kappa = t90;
        cut = t91;
        shape = t106;
        shape_difference = t108;
        norm = t109;
        tau = t83 * t86;
        area = t89 * t88 * (spherecap_min(t76, t77) * t86) * t109;
        t81 = t82;
    } else {
        t81 = t44;
    }
    let t110 = sqrt(t19);
    let t111 = 1.0 / t110;
    let radius_sin = t15 * t111;
    let radius_cos = t79 * t111;
    let elevation_sin = t74 * t111;
    let elevation_cos = t81 * t111;
    let t112 = abs(elevation_sin);
    let climb = radius_sin * elevation_cos;
    let rise = spherecap_max(t78 * (t111 * t111) / fma(radius_cos, t112, climb), -(radius_cos * t112));
    let t113 = radius_sin * radius_sin;
    let t114 = fma(t113 * t112, 3.1415927, area);
    let t115 = 0.0 < elevation_sin;
    let t116 = select(area, t114, t115);
    let t117 = select(t114, area, t115);
    let t118 = 9.8607613e-32 < t113;
    let t119 = t118 && t80;
    let t120 = 1.0 / t43;
    let sideways_x = t40 * t120;
    let sideways_y = t41 * t120;
    let sideways_z = t42 * t120;
    let on_surface = select(0.0, 1.0, t32);
    let distance = t110 * select(unscale, 1.0, t10);
    let projected_above = select(0.0, t116, 9.403955e-38 < t116 && t119);
    let projected_below = select(0.0, t117, 9.403955e-38 < t117 && t119);
    let t121 = 0.0 < tau;
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let inv_below = select(0.0, 1.0 / projected_below, 0.0 < projected_below);
    let t122 = 0.0 < inv_above + inv_below;
    let t123 = select(inv_below, inv_above, t115);
    let defensive_share = select(select(0.0, 1.0, 0.0 < defensive || !(0.0 < on_surface)), defensive, t122);
    let t124 = t121 && 0.0 < t123;
    let t125 = t_y * t_y * t_y * shape * t123;
    let t126 = t_y / radius_sin;
    let t127 = fma(cut - t_x, shape_difference, shape);
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    var t128 = 0.0;
    if (t121) {
        let t129 = 1.0 + kappa;
        let t130 = t129 * shape;
        let t131 = 1.0 / (norm * t130);
        let t132 = sqrt(t131);
        let t133 = norm * t132;
        let t134 = 1.0 / (1.0 + cut);
        let t135 = (t_x + kappa) * t134 - 0.5;
        let t136 = t135 * t135;
        let t137 = fma(fma(fma(-0.026061837, t136, -0.06372378), t136, -0.11762552), t136, -0.23594604);
        let t138 = fma(fma(fma(0.05430631, t136, 0.080950715), t136, 0.1684019), t136, 0.32709444);
        let t139 = fma(fma(fma(t137, t136, -0.44721135), t136, -0.7754678), t135, fma(fma(t138, t136, 0.5987523), t136, 0.94559944));
        let t140 = t129 * t139 * (t134 * t134 * t134) * (t130 * t131);
        let t141 = fma(t140, t130 * t132, -1.0);
        let t142 = 1.0 - t140;
        let t143 = fma(fma(30.011856, t141, fma(-41.541264, t142, -37.009792)), t141, fma(77.96775, t142, 7.470758));
        let t144 = fma(fma(fma(fma(15.716111, t142, 0.0), t142, 9.961183), t142, -2.61785), t142, 0.8681748);
        let t145 = fma(fma(t143, t141, fma(fma(-49.13454, t142, -9.466533), t142, -1.5877596)), t141, t144);
        let t146 = t141 * t145;
        let t147 = fma(fma(7.295638, t141, -7.236236), t141, fma(fma(fma(-11.4868555, t142, 0.0), t142, 0.0), t142, 3.1255686));
        let t148 = fma(fma(fma(13.728438, t142, -7.981878), t142, 2.025724), t142, -0.7334958);
        let t149 = t141 * fma(t147, t141, t148);
        let t150 = fma(fma(-23.220068, t142, 7.332055), t141, fma(fma(fma(9.986537, t142, 25.22195), t142, 0.0), t142, -2.9581387));
        let t151 = fma(fma(fma(-19.722994, t142, 4.6594768), t142, -0.89538246), t142, 0.5143498);
        let t152 = t141 * fma(t150, t141, t151);
        let t153 = fma(fma(fma(1.946617, t141, -3.077631), t141, 1.4945927), t141, -0.24140751);
        let t154 = t141 * t153;
        let t155 = t141 * fma(fma(0.38173297, t141, -0.30305624), t141, 0.05897375);
        let t156 = 1.0 / (elevation_cos * elevation_cos);
        let t157 = tau * tau;
        let t158 = t157 * t156 / (1.0 + t_x);
        let t159 = kappa - 0.5;
        let t160 = cut - 0.5;
        let t161 = t159 * t159;
        let t162 = t160 * t160;
        let t163 = fma(0.05430631, t161, 0.080950715);
        let t164 = fma(t163, t161, 0.1684019);
        let t165 = fma(t164, t161, 0.32709444);
        let t166 = fma(fma(fma(fma(0.05430631, t162, t163), t162, t164), t162, t165), t162, fma(t165, t161, 0.5987523));
        let t167 = fma(-0.026061837, t161, -0.06372378);
        let t168 = fma(t167, t161, -0.11762552);
        let t169 = fma(t168, t161, -0.23594604);
        let t170 = fma(t169, t161, -0.44721135);
        let t171 = fma(fma(fma(fma(-0.026061837, t162, t167), t162, t168), t162, t169), t162, t170);
        let t172 = fma(kappa * t158, fma(fma(t160, t171, t166), t159 + t160, fma(t170, t161, -0.7754678)), fma(t127, t158 - kappa * kappa, kappa) * t156);
        let t173 = spherecap_min(spherecap_max(t157 * tau * (radius_cos + 1.0) * t172 * 0.31830987, 0.0), 0.5);
        coefficients_0 = t133;
        coefficients_1 = t140 - t133 + t146;
        coefficients_2 = t149 - t146;
        coefficients_3 = t152 - t149;
        coefficients_4 = t154 - t152;
        coefficients_5 = t155 - t154;
        coefficients_6 = -t155;
        t128 = t173;
    }
    let t174 = 0.0 < defensive_share;
    let t175 = select(0.0, t113 / (1.0 + radius_cos), t118 && 0.0 < radius_cos);
    let inv_solid_angle = select(0.0, select(0.0, 0.15915494 / t175, 0.0 < t175), t174);
    let sides_share = select(1.0, select(0.0, select(t128, 1.0 - t128, t115), 0.0 < inv_above), 0.0 < inv_below);
    let t176 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && (t122 || (t174 && 0.0 < inv_solid_angle));
    var light: spherecap_both_light;
    light.is_sampled = t176;
    light.solid_angle = select(0.0, t175 * 6.2831855, t176);
    light.projected_solid_angle = select(0.0, projected_above, t176);
    light.towards_centre = vec3f(t12 * t111, t13 * t111, t14 * t111);
    light.sideways = vec3f(sideways_x, sideways_y, sideways_z);
    light.normal = vec3f(normal_x, normal_y, normal_z);
    light.up = vec3f(up_x, up_y, up_z);
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
    light.third_axis = vec3f(fma(sideways_y, up_z, -(sideways_z * up_y)), fma(sideways_z, up_x, -(sideways_x * up_z)), fma(sideways_x, up_y, -(sideways_y * up_x)));
    light.height = select(0.0, t175, t174);
    light.inv_solid_angle = inv_solid_angle;
    light.crescent_share = select(0.0, t125, t124);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t125), t124);
    light.beyond = select(0.0, t126 * t126 * t126 * t127, t124);
    light.middle = elevation_cos * radius_cos;
    light.half_axis = radius_sin * t112;
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

fn spherecap_both_sample(light: spherecap_both_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = abs(light.elevation_sin);
    let t2 = 0.0 < light.elevation_sin;
    let t3 = 0.0 < light.defensive_share;
    let t4 = spherecap_min(spherecap_max(u0, 5.9604645e-8), 0.99999994);
    let t5 = spherecap_min(spherecap_max(u1, 5.9604645e-8), 0.99999994);
    let t6 = t3 && t4 < light.defensive_share;
    let t7 = 1.0 - light.defensive_share;
    let t8 = select(t4 - light.defensive_share, t4, t6) / select(t7, light.defensive_share, t6);
    let t9 = select(t4, spherecap_min(spherecap_max(t8, 5.9604645e-8), 0.99999994), 0.0 < light.requested);
    let t10 = t6 || t9 < light.sides_share;
    let t11 = 1.0 - light.sides_share;
    let t12 = select(t9 - light.sides_share, t9, t10) / select(t11, light.sides_share, t10);
    let t13 = select(spherecap_min(spherecap_max(t12, 5.9604645e-8), 0.99999994), t9, t6);
    let t14 = t6 || !(0.0 < light.tau);
    let t15 = !t14 && !((t10 && t2) || (!t10 && !t2));
    let t16 = t14 || (!t15 && light.crescent_share <= t13);
    let t17 = 1.0 - t5;
    let t18 = t5 - t17;
    let t19 = 4.0 * t5 * t17;
    let t20 = spherecap_max((t13 - light.crescent_share) * light.inv_rest, 5.9604645e-8);
    let t21 = select(spherecap_min(t20, 0.99999994), t13, t14);
    let t22 = select(light.beyond, 0.0, t14);
    let t23 = 3.1415927 - t22;
    let t24 = fma(t21, t23, t22);
    let t25 = (1.0 - t21) * t23;
    var t26 = 0.0;
    var t27 = 0.0;
    var t28 = 0.0;
    var t29 = 0.0;
    if (t16) {
        t27 = spherecap_min(t24, t25) * 0.53033006;
        t28 = 1.0;
        t29 = 1.0;
    } else {
        let t30 = sqrt(t19);
        let t31 = fma(fma(light.coefficients_6, t19, light.coefficients_4), t19, light.coefficients_2);
        let t32 = fma(fma(light.coefficients_5, t19, light.coefficients_3), t19, light.coefficients_1);
        let t33 = t30 * fma(t32, t30, fma(t31, t19, light.coefficients_0));
        let t34 = sqrt(fma(t18, t18, t33 * t33));
        let t35 = light.tau * t33;
        let t36 = select(1.0, fma(t18, t18, t35 * t35), t15);
        let t37 = select(light.crescent_share, fma(light.kappa, t33, t34) * fma(light.cut, t33, t34), t15);
        let t38 = select(t13, light.width, t15) / t37;
        let t39 = select(spherecap_min(spherecap_max(t38, 5.9604645e-8), 0.99999994), t13, t15);
        let t40 = select(light.width, t38, t15);
        let t41 = t36 * t40;
        let t42 = t41 * t41;
        let t43 = fma(fma(fma(-0.00060778117, t42, -0.0027203285), t42, -0.10000902), t41, fma(fma(1.0676054e-5, t42, -0.011332183), t42, 1.0000001));
        t26 = select(t30, t35, t15);
        t27 = t39;
        t28 = t40 * t43;
        t29 = t36;
    }
    let t44 = spherecap_float_of_bits(fma(spherecap_bits(t27), -0.33333334, 1419900500.0));
    let t45 = fma(-(t27 * t44), t44 * t44, 1.0);
    let t46 = t45 * t45;
    let t47 = fma(fma(fma(0.110958695, t46, 0.14403293), t46, 0.22222222), t45, fma(fma(0.12482853, t46, 0.17283951), t46, 0.33333334));
    let t48 = t28 * (t27 * fma(t44, t45 * t47, t44));
    let t49 = t48 * t29;
    let t50 = t49 * t49;
    let t51 = fma(fma(fma(-0.063446075, t50, -0.056249518), t50, 0.0074712755), t50, 0.09996679);
    let t52 = fma(fma(fma(0.022114987, t50, 0.085662976), t50, 0.030445365), t50, 0.03209764);
    let t53 = t48 * fma(t51, t49, fma(t52, t50, 1.0000004));
    let t54 = select(t53, spherecap_min(t53, 1.0), t16);
    let t55 = t29 * t54;
    let t56 = 2.0 - t55;
    let t57 = t54 * t56;
    let t58 = sqrt(t57);
    var t59 = 0.0;
    var t60 = 0.0;
    var t61 = 0.0;
    var side = 0.0;
    var t62 = 0.0;
    if (t16) {
        let t63 = select(t56, t55, t24 - t25 < 0.0);
        let t64 = t57 * t19;
        var t65 = 0.0;
        var t66 = 0.0;
        var t67 = 0.0;
        var t68 = 0.0;
        var t69 = 0.0;
        if (t6) {
            let t70 = light.height * (1.0 - t64);
            let t71 = sqrt(light.height * (2.0 - t70));
            let t72 = (t63 - 1.0) * t71;
            let t73 = 1.0 - t70;
            let t74 = fma(light.elevation_sin, t73, light.elevation_cos * t72);
            t65 = fma(light.elevation_cos, t73, -(light.elevation_sin * t72));
            t66 = t74;
            t67 = t72;
            t68 = t58 * t18 * t71;
            t69 = t74 * light.on_surface;
        } else {
            let t75 = 1.0 - t63;
            let t76 = spherecap_max(fma(light.climb, t63, -light.rise), 0.0);
            let t77 = sqrt(fma(t76, t76, light.radius_sin * light.radius_sin * t64));
            let t78 = t1 * light.radius_cos;
            let t79 = fma(light.elevation_cos * t75, fma(light.climb, t75, -2.0 * t78), light.radius_sin * t64);
            let t80 = light.radius_sin * fma(light.elevation_cos, t79 / (t77 + t78), -(t1 * t1 * t75));
            t65 = fma(light.half_axis, t75, light.middle);
            t66 = t77;
            t67 = t80;
            t68 = light.radius_sin * t58 * t18;
            t69 = t77;
        }
        t59 = t65;
        t60 = t66;
        t61 = t67;
        side = t68;
        t62 = t69;
    } else {
        let t81 = t58 * t26;
        let t82 = 1.0 - t55;
        t59 = t82;
        t60 = t81;
        t61 = fma(light.elevation_cos, t81, -(select(t1, -t1, t15) * t82));
        side = t58 * t18;
        t62 = t81;
    }
    let t83 = select(-1.0, 1.0, t10);
    let zenith = t61 * t83;
    let cosine = t62 * t83;
    let t84 = t60 * t83;
    let t85 = spherecap_min(abs(cosine), 3.4028235e38);
    let t86 = select(select(0.0, light.inv_below * t11, cosine < 0.0), light.inv_above * light.sides_share, 0.0 < cosine);
    let t87 = light.defensive_share * light.inv_solid_angle;
    let t88 = fma(t86, t7, spherecap_min(t87 / spherecap_max(t85, 1.1754944e-38), 3.4028235e38));
    let t89 = fma(zenith, zenith, side * side);
    let t90 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t89), 0.0);
    let t91 = sqrt(t90);
    let t92 = sqrt(fma(light.radius_cos, light.radius_cos, t90));
    let t93 = light.radius_cos * light.radius_cos / (t92 + t91);
    let t94 = 1.0 / light.radius_sin;
    let t95 = t93 * t94;
    let t96 = -fma(t92, t91, t89) * t94;
    let t97 = t95 * zenith;
    let t98 = t95 * side;
    let t99 = fma(light.third_axis.x, t59, fma(light.sideways.x, side, light.up.x * t84));
    let t100 = fma(light.third_axis.y, t59, fma(light.sideways.y, side, light.up.y * t84));
    let t101 = fma(light.third_axis.z, t59, fma(light.sideways.z, side, light.up.z * t84));
    let t102 = fma(light.elevation_cos, t96, -(light.elevation_sin * t97));
    let t103 = fma(light.elevation_sin, t96, light.elevation_cos * t97);
    let t104 = fma(light.third_axis.x, t102, fma(light.sideways.x, t98, light.up.x * t103));
    let t105 = fma(light.third_axis.y, t102, fma(light.sideways.y, t98, light.up.y * t103));
    let t106 = fma(light.third_axis.z, t102, fma(light.sideways.z, t98, light.up.z * t103));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t99, t100, t101);
    sampled.distance = t93 * light.distance;
    sampled.normal = vec3f(t104, t105, t106);
    sampled.cosine = cosine;
    sampled.pdf = select(t86 * t85, fma(t86, t7 * t85, t87), t3);
    sampled.projected_pdf = select(t86, spherecap_min(t88, 3.4028235e38), t3);
    return sampled;
}

fn spherecap_both_sample_once(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_both_sample(spherecap_both_prepare(normal, centre, radius, defensive), u0, u1);
}

fn spherecap_both_pdf_direction(light: spherecap_both_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.towards_centre.y, direction.y, light.towards_centre.z * direction.z);
    let t2 = fma(light.towards_centre.y, light.sideways.z, -(light.towards_centre.z * light.sideways.y));
    let t3 = fma(light.towards_centre.z, light.sideways.x, -(light.towards_centre.x * light.sideways.z));
    let t4 = fma(light.towards_centre.x, light.sideways.y, -(light.towards_centre.y * light.sideways.x));
    let t5 = fma(light.sideways.x, direction.x, fma(light.sideways.y, direction.y, light.sideways.z * direction.z));
    let t6 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    let t7 = fma(light.towards_centre.x, direction.x, t1) < 0.0;
    let t8 = select(fma(t2, direction.x, fma(t3, direction.y, t4 * direction.z)), 1.0, t7);
    let t9 = select(t5, 1.0, t7);
    let t10 = spherecap_min(abs(t6), 3.4028235e38);
    let t11 = select(select(0.0, light.inv_below * (1.0 - light.sides_share), t6 < 0.0), light.inv_above * light.sides_share, 0.0 < t6);
    let t12 = fma(t11, (1.0 - light.defensive_share) * t10, light.defensive_share * light.inv_solid_angle);
    let t13 = select(0.0, select(t11 * t10, t12, 0.0 < light.defensive_share), fma(t8, t8, t9 * t9) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t14 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    return select(0.0, t13, 0.998001 <= t14 && t14 <= 1.002001);
}

fn spherecap_both_pdf_on_sphere(light: spherecap_both_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
    let t2 = spherecap_min(abs(t1), 3.4028235e38);
    let t3 = select(select(0.0, light.inv_below * (1.0 - light.sides_share), t1 < 0.0), light.inv_above * light.sides_share, 0.0 < t1);
    let t4 = fma(t3, (1.0 - light.defensive_share) * t2, light.defensive_share * light.inv_solid_angle);
    let t5 = fma(direction.x, direction.x, fma(direction.y, direction.y, direction.z * direction.z));
    let t6 = select(0.0, select(t3 * t2, t4, 0.0 < light.defensive_share), 0.998001 <= t5 && t5 <= 1.002001);
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
    let unscale = spherecap_power_of_two(spherecap_min(t11, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t12 = centre.x * scale;
    let t13 = centre.y * scale;
    let t14 = centre.z * scale;
    let t15 = radius * scale;
    let t16 = sqrt(fma(t12, t12, fma(t13, t13, t14 * t14)));
    let t17 = 1.0 / t16;
    let t18 = t15 * t17;
    let t19 = t18 * t18;
    let t20 = fma(t2, t2, fma(t3, t3, t4 * t4));
    let t21 = 0.0 <= defensive && defensive <= 1.0 && t20 <= 2.0 && 0.0 < radius && t16 * unscale <= 3.4028235e38;
    let t22 = fma(t2, t12, fma(t3, t13, t4 * t14));
    let t23 = spherecap_max(fma(-t19, t19, 0.9999981), 0.0);
    let t24 = fma(t22, t17, 2.3841858e-7);
    let t25 = fma(t22 + t15, t17, 2.3841858e-7);
    let t26 = select(select(0.0, t25 * t25 / (fma(t18 - t24, t23, t25) * 2.0), 0.0 < t25), t24, t18 <= t24);
    let t27 = fma(-t22, t17, 2.3841858e-7);
    let t28 = fma(-t22 + t15, t17, 2.3841858e-7);
    let t29 = select(select(0.0, t28 * t28 / (fma(t18 - t27, t23, t28) * 2.0), 0.0 < t28), t27, t18 <= t27);
    let t30 = t26 + t29;
    let t31 = select(fma(defensive, 0.5 - t30, t30), 1.0, t20 <= 0.0);
    let t32 = t19 <= 1.0000019 && 4.9303807e-32 < t19 && t21 && 0.0 < strength && strength <= 3.4028235e38;
    let t33 = spherecap_min(spherecap_max(t19 * t31 * strength, 1.1754944e-38), 3.4028235e38);
    return select(0.0, t33, t32 && (0.0 < t31 || 0.0 < defensive));
}

