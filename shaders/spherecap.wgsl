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
    frame_0: vec3f,
    frame_1: vec3f,
    frame_2: vec3f,
    normal: vec3f,
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
    let unscale = spherecap_power_of_two(spherecap_min(t1, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t2 = centre.x * scale;
    let t3 = centre.y * scale;
    let t4 = centre.z * scale;
    let t5 = radius * scale;
    let t6 = spherecap_keep(t2 * t2, unknown_zero);
    let t7 = spherecap_keep(t3 * t3, unknown_zero);
    let t8 = spherecap_keep(t4 * t4, unknown_zero);
    let t9 = spherecap_keep(t6 + t7, unknown_zero);
    let t10 = spherecap_keep(t9 - t6, unknown_zero);
    let t11 = spherecap_keep(t6 - spherecap_keep(t9 - t10, unknown_zero), unknown_zero);
    let t12 = spherecap_keep(t9 + t8, unknown_zero);
    let t13 = spherecap_keep(t12 - t9, unknown_zero);
    let t14 = spherecap_keep(t9 - spherecap_keep(t12 - t13, unknown_zero), unknown_zero);
    let t15 = spherecap_lost(t2, t2, t6, unknown_zero) + spherecap_lost(t3, t3, t7, unknown_zero);
    let t16 = t11 + spherecap_keep(t7 - t10, unknown_zero) + (t14 + spherecap_keep(t8 - t13, unknown_zero));
    let t17 = spherecap_keep(t5 * t5, unknown_zero);
    let t18 = t15 + spherecap_lost(t4, t4, t8, unknown_zero) + t16 - spherecap_lost(t5, t5, t17, unknown_zero);
    let t19 = t12 - t17 + t18;
    let t20 = 0.0 < t19;
    let t21 = sqrt(t12);
    let t22 = 1.0 / t21;
    let t23 = spherecap_keep(normal.x * t2, unknown_zero);
    let t24 = spherecap_keep(normal.y * t3, unknown_zero);
    let t25 = spherecap_keep(normal.z * t4, unknown_zero);
    let t26 = spherecap_keep(t23 + t24, unknown_zero);
    let t27 = spherecap_keep(t26 - t23, unknown_zero);
    let t28 = spherecap_keep(t23 - spherecap_keep(t26 - t27, unknown_zero), unknown_zero);
    let t29 = spherecap_keep(t26 + t25, unknown_zero);
    let t30 = spherecap_keep(t29 - t26, unknown_zero);
    let t31 = spherecap_keep(t26 - spherecap_keep(t29 - t30, unknown_zero), unknown_zero);
    let t32 = spherecap_lost(normal.x, t2, t23, unknown_zero) + spherecap_lost(normal.y, t3, t24, unknown_zero);
    let t33 = t28 + spherecap_keep(t24 - t27, unknown_zero) + (t31 + spherecap_keep(t25 - t30, unknown_zero));
    let t34 = t32 + spherecap_lost(normal.z, t4, t25, unknown_zero) + t33;
    let t35 = spherecap_keep(t29 + t34, unknown_zero);
    let t36 = spherecap_keep(t34 - spherecap_keep(t35 - t29, unknown_zero), unknown_zero);
    let t37 = t5 - t35 - t36;
    let t38 = t5 + t35 + t36;
    let t39 = t37 * t38;
    let t40 = 0.0 < t39 && t20;
    let t41 = spherecap_keep(normal.z * t3, unknown_zero);
    let t42 = spherecap_fused(normal.y, t4, -t41, unknown_zero) - spherecap_lost(normal.z, t3, t41, unknown_zero);
    let t43 = spherecap_keep(normal.x * t4, unknown_zero);
    let t44 = spherecap_fused(normal.z, t2, -t43, unknown_zero) - spherecap_lost(normal.x, t4, t43, unknown_zero);
    let t45 = spherecap_keep(normal.y * t2, unknown_zero);
    let t46 = spherecap_fused(normal.x, t3, -t45, unknown_zero) - spherecap_lost(normal.y, t2, t45, unknown_zero);
    let t47 = fma(t42, t42, fma(t44, t44, t46 * t46));
    let t48 = 9.8607613e-32 < t47;
    let t49 = abs(t2) < abs(t4);
    let t50 = select(-t3, 0.0, t49);
    let t51 = select(t2, -t4, t49);
    let t52 = select(0.0, t3, t49);
    let t53 = sqrt(spherecap_max(t19, 0.0));
    let radius_cos = t53 * t22;
    let t54 = 1.0 + radius_cos;
    let t55 = 1.0 / (t5 * t54);
    let t56 = t55 * t54;
    let radius_sin = t5 * t22;
    let inv_radius_sin = t21 * t56;
    let t57 = sqrt(t19 + t39);
    let t58 = sqrt(select(fma(t50, t50, fma(t51, t51, t52 * t52)), t47, t48));
    let elevation_sin = t35 * t22;
    let elevation_cos = select(select(0.0, t58, t48), t57, t40) * t22;
    let t59 = abs(elevation_sin);
    let t60 = radius_sin * elevation_cos;
    let t61 = spherecap_max(fma(radius_cos, t59, t60), 9.8607613e-32);
    let t62 = 1.0 / (t61 * t58);
    let t63 = t62 * t58;
    let t64 = t62 * t61;
    let frame_2_x = select(t50, t42, t48) * t64;
    let frame_2_y = select(t51, t44, t48) * t64;
    let frame_2_z = select(t52, t46, t48) * t64;
    let frame_0_x = t2 * t22;
    let frame_0_y = t3 * t22;
    let frame_0_z = t4 * t22;
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
    if (t40) {
        let t65 = sqrt(t39);
        let t66 = t57 + t53;
        let t67 = 1.0 / (t57 * t66);
        let t68 = t67 * t66;
        let t69 = t53 * t68;
        let t70 = t65 * t68;
        let t71 = abs(t35) * t56;
        let t72 = t71 * t69;
        let t73 = t69 - 0.5;
        let t74 = t72 - 0.5;
        let t75 = t73 * t73;
        let t76 = t74 * t74;
        let t77 = fma(0.05430631, t75, 0.080950715);
        let t78 = fma(t77, t75, 0.1684019);
        let t79 = fma(t78, t75, 0.32709444);
        let t80 = fma(t79, t75, 0.5987523);
        let t81 = fma(-0.026061837, t75, -0.06372378);
        let t82 = fma(t81, t75, -0.11762552);
        let t83 = fma(t82, t75, -0.23594604);
        let t84 = fma(t83, t75, -0.44721135);
        let t85 = fma(t84, t75, -0.7754678);
        let t86 = fma(t85, t73, fma(t80, t75, 0.94559944));
        let t87 = fma(t74, fma(fma(fma(fma(-0.026061837, t76, t81), t76, t82), t76, t83), t76, t84), fma(fma(fma(fma(0.05430631, t76, t77), t76, t78), t76, t79), t76, t80));
        let t88 = fma(t87, t73 + t74, t85);
        let t89 = fma(t72, t88, t86);
        t_x = t69;
        t_y = t70;
        kappa = t71;
        cut = t72;
        shape = t86;
        shape_cut = fma(t72 - t69, t88, t86);
        norm = t89;
        width = t39 * t67;
        inv_cut_1 = t60 * t63;
        tau = t65 * t56;
        area = t70 * t70 * t70 * (spherecap_min(t37, t38) * t56) * t89;
    }
    let t90 = radius_sin * radius_sin;
    let t91 = select(t90 * t59 * 3.1415927 + area, area, elevation_sin < 0.0);
    let t92 = t20 && 9.8607613e-32 < t90;
    let distance = t21 * unscale;
    let projected_above = select(0.0, t91, 9.403955e-38 < t91 && t92);
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let t93 = 0.0 < elevation_sin;
    let t94 = select(0.0, inv_above, t93);
    let t95 = 0.0 < tau;
    let t96 = t93 && t95 && 0.0 < t94;
    let t97 = t_y * t_y * t_y * shape * t94;
    let t98 = t_y * inv_radius_sin;
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    if (!t93 && t95) {
        let t99 = 1.0 + kappa;
        let t100 = t99 * shape;
        let t101 = 1.0 / (norm * t100);
        let t102 = sqrt(t101);
        let t103 = norm * t102;
        let t104 = (t_x + kappa) * inv_cut_1 - 0.5;
        let t105 = t104 * t104;
        let t106 = fma(fma(fma(-0.026061837, t105, -0.06372378), t105, -0.11762552), t105, -0.23594604);
        let t107 = fma(fma(fma(0.05430631, t105, 0.080950715), t105, 0.1684019), t105, 0.32709444);
        let t108 = fma(fma(fma(t106, t105, -0.44721135), t105, -0.7754678), t104, fma(fma(t107, t105, 0.5987523), t105, 0.94559944));
        let t109 = t99 * t108 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t100 * t101);
        let t110 = fma(t109, t100 * t102, -1.0);
        let t111 = 1.0 - t109;
        let t112 = fma(fma(30.011856, t110, fma(-41.541264, t111, -37.009792)), t110, fma(77.96775, t111, 7.470758));
        let t113 = fma(fma(fma(fma(15.716111, t111, 0.0), t111, 9.961183), t111, -2.61785), t111, 0.8681748);
        let t114 = fma(fma(t112, t110, fma(fma(-49.13454, t111, -9.466533), t111, -1.5877596)), t110, t113);
        let t115 = t110 * t114;
        let t116 = fma(fma(7.295638, t110, -7.236236), t110, fma(fma(fma(-11.4868555, t111, 0.0), t111, 0.0), t111, 3.1255686));
        let t117 = fma(fma(fma(13.728438, t111, -7.981878), t111, 2.025724), t111, -0.7334958);
        let t118 = t110 * fma(t116, t110, t117);
        let t119 = fma(fma(-23.220068, t111, 7.332055), t110, fma(fma(fma(9.986537, t111, 25.22195), t111, 0.0), t111, -2.9581387));
        let t120 = fma(fma(fma(-19.722994, t111, 4.6594768), t111, -0.89538246), t111, 0.5143498);
        let t121 = t110 * fma(t119, t110, t120);
        let t122 = fma(fma(fma(1.946617, t110, -3.077631), t110, 1.4945927), t110, -0.24140751);
        let t123 = t110 * t122;
        let t124 = t110 * fma(fma(0.38173297, t110, -0.30305624), t110, 0.05897375);
        coefficients_0 = t103;
        coefficients_1 = t109 - t103 + t115;
        coefficients_2 = t118 - t115;
        coefficients_3 = t121 - t118;
        coefficients_4 = t123 - t121;
        coefficients_5 = t124 - t123;
        coefficients_6 = -t124;
    }
    let t125 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < inv_above;
    var light: spherecap_surface_light;
    light.is_sampled = t125;
    light.solid_angle = select(0.0, select(0.0, t90 * (t55 * t5) * 6.2831855, t92), t125);
    light.projected_solid_angle = select(0.0, projected_above, t125);
    light.frame_0 = vec3f(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = vec3f(fma(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), fma(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), fma(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = vec3f(frame_2_x, frame_2_y, frame_2_z);
    light.normal = vec3f(normal.x, normal.y, normal.z);
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
    light.rise = spherecap_max(t39 * (t22 * t22) * t63, -(radius_cos * t59));
    light.inv_above = inv_above;
    light.crescent_share = select(0.0, t97, t96);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t97), t96);
    light.beyond = select(0.0, t98 * t98 * t98 * shape_cut, t96);
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
    var zenith = 0.0;
    var side = 0.0;
    var cosine = 0.0;
    if (t5) {
        let t49 = light.radius_sin * light.elevation_cos;
        let t50 = select(t46, t45, t12 < 0.0);
        let t51 = 1.0 - t50;
        let t52 = t47 * t8;
        let t53 = spherecap_max(fma(t49, t50, -light.rise), 0.0);
        let t54 = sqrt(fma(t53, t53, light.radius_sin * light.radius_sin * t52));
        let t55 = t1 * light.radius_cos;
        let t56 = fma(light.elevation_cos * t51, fma(t49, t51, -2.0 * t55), light.radius_sin * t52);
        let t57 = light.radius_sin * fma(light.elevation_cos, t56 / (t54 + t55), -(t1 * t1 * t51));
        zenith = t57;
        side = light.radius_sin * t48 * t7;
        cosine = t54;
    } else {
        let t58 = t48 * t12;
        zenith = fma(light.elevation_cos, t58, -(select(-t1, t1, t2) * (1.0 - t45)));
        side = t48 * t7;
        cosine = t58;
    }
    let t59 = select(0.0, light.inv_above, 0.0 < cosine);
    let t60 = fma(zenith, zenith, side * side);
    let t61 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t60), 0.0);
    let t62 = sqrt(t61);
    let t63 = sqrt(fma(light.radius_cos, light.radius_cos, t61));
    let t64 = light.radius_cos * light.radius_cos / (t63 + t62);
    let t65 = fma(light.frame_0.x, t63, fma(light.frame_1.x, zenith, light.frame_2.x * side));
    let t66 = fma(light.frame_0.y, t63, fma(light.frame_1.y, zenith, light.frame_2.y * side));
    let t67 = fma(light.frame_0.z, t63, fma(light.frame_1.z, zenith, light.frame_2.z * side));
    let t68 = t64 * light.inv_radius_sin;
    let t69 = -fma(t63, t62, t60) * light.inv_radius_sin;
    let t70 = t68 * zenith;
    let t71 = t68 * side;
    let t72 = fma(light.frame_0.x, t69, fma(light.frame_1.x, t70, light.frame_2.x * t71));
    let t73 = fma(light.frame_0.y, t69, fma(light.frame_1.y, t70, light.frame_2.y * t71));
    let t74 = fma(light.frame_0.z, t69, fma(light.frame_1.z, t70, light.frame_2.z * t71));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t65, t66, t67);
    sampled.distance = t64 * light.distance;
    sampled.normal = vec3f(t72, t73, t74);
    sampled.cosine = cosine;
    sampled.pdf = t59 * spherecap_min(abs(cosine), 3.4028235e38);
    sampled.projected_pdf = t59;
    return sampled;
}

fn spherecap_surface_sample_once(normal: vec3f, centre: vec3f, radius: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_surface_sample(spherecap_surface_prepare(normal, centre, radius), u0, u1);
}

fn spherecap_surface_pdf_direction(light: spherecap_surface_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.frame_0.x, direction.x, fma(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    let t2 = fma(light.frame_1.x, direction.x, fma(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    let t3 = fma(light.frame_2.x, direction.x, fma(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    let t4 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
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
    frame_0: vec3f,
    frame_1: vec3f,
    frame_2: vec3f,
    normal: vec3f,
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
    let unscale = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t10 = centre.x * scale;
    let t11 = centre.y * scale;
    let t12 = centre.z * scale;
    let t13 = radius * scale;
    let t14 = spherecap_keep(t10 * t10, unknown_zero);
    let t15 = spherecap_keep(t11 * t11, unknown_zero);
    let t16 = spherecap_keep(t12 * t12, unknown_zero);
    let t17 = spherecap_keep(t14 + t15, unknown_zero);
    let t18 = spherecap_keep(t17 - t14, unknown_zero);
    let t19 = spherecap_keep(t14 - spherecap_keep(t17 - t18, unknown_zero), unknown_zero);
    let t20 = spherecap_keep(t17 + t16, unknown_zero);
    let t21 = spherecap_keep(t20 - t17, unknown_zero);
    let t22 = spherecap_keep(t17 - spherecap_keep(t20 - t21, unknown_zero), unknown_zero);
    let t23 = spherecap_lost(t10, t10, t14, unknown_zero) + spherecap_lost(t11, t11, t15, unknown_zero);
    let t24 = t19 + spherecap_keep(t15 - t18, unknown_zero) + (t22 + spherecap_keep(t16 - t21, unknown_zero));
    let t25 = spherecap_keep(t13 * t13, unknown_zero);
    let t26 = t23 + spherecap_lost(t12, t12, t16, unknown_zero) + t24 - spherecap_lost(t13, t13, t25, unknown_zero);
    let t27 = t20 - t25 + t26;
    let t28 = 0.0 < t27;
    let t29 = sqrt(t20);
    let t30 = 1.0 / t29;
    let t31 = spherecap_keep(normal_x * t10, unknown_zero);
    let t32 = spherecap_keep(normal_y * t11, unknown_zero);
    let t33 = spherecap_keep(normal_z * t12, unknown_zero);
    let t34 = spherecap_keep(t31 + t32, unknown_zero);
    let t35 = spherecap_keep(t34 - t31, unknown_zero);
    let t36 = spherecap_keep(t31 - spherecap_keep(t34 - t35, unknown_zero), unknown_zero);
    let t37 = spherecap_keep(t34 + t33, unknown_zero);
    let t38 = spherecap_keep(t37 - t34, unknown_zero);
    let t39 = spherecap_keep(t34 - spherecap_keep(t37 - t38, unknown_zero), unknown_zero);
    let t40 = spherecap_lost(normal_x, t10, t31, unknown_zero) + spherecap_lost(normal_y, t11, t32, unknown_zero);
    let t41 = t36 + spherecap_keep(t32 - t35, unknown_zero) + (t39 + spherecap_keep(t33 - t38, unknown_zero));
    let t42 = t40 + spherecap_lost(normal_z, t12, t33, unknown_zero) + t41;
    let t43 = spherecap_keep(t37 + t42, unknown_zero);
    let t44 = spherecap_keep(t42 - spherecap_keep(t43 - t37, unknown_zero), unknown_zero);
    let t45 = t13 - t43 - t44;
    let t46 = t13 + t43 + t44;
    let t47 = t45 * t46;
    let t48 = 0.0 < t8;
    let t49 = 0.0 < t47 && t28 && t48;
    let t50 = spherecap_keep(normal_z * t11, unknown_zero);
    let t51 = spherecap_fused(normal_y, t12, -t50, unknown_zero) - spherecap_lost(normal_z, t11, t50, unknown_zero);
    let t52 = spherecap_keep(normal_x * t12, unknown_zero);
    let t53 = spherecap_fused(normal_z, t10, -t52, unknown_zero) - spherecap_lost(normal_x, t12, t52, unknown_zero);
    let t54 = spherecap_keep(normal_y * t10, unknown_zero);
    let t55 = spherecap_fused(normal_x, t11, -t54, unknown_zero) - spherecap_lost(normal_y, t10, t54, unknown_zero);
    let t56 = fma(t51, t51, fma(t53, t53, t55 * t55));
    let t57 = 9.8607613e-32 < t56;
    let t58 = abs(t10) < abs(t12);
    let t59 = select(-t11, 0.0, t58);
    let t60 = select(t10, -t12, t58);
    let t61 = select(0.0, t11, t58);
    let t62 = sqrt(spherecap_max(t27, 0.0));
    let radius_cos = t62 * t30;
    let t63 = 1.0 + radius_cos;
    let t64 = 1.0 / (t13 * t63);
    let t65 = t64 * t63;
    let radius_sin = t13 * t30;
    let inv_radius_sin = t29 * t65;
    let t66 = sqrt(t27 + t47);
    let t67 = sqrt(select(fma(t59, t59, fma(t60, t60, t61 * t61)), t56, t57));
    let elevation_sin = t43 * t30;
    let elevation_cos = select(select(0.0, t67, t57), t66, t49) * t30;
    let t68 = abs(elevation_sin);
    let t69 = radius_sin * elevation_cos;
    let t70 = spherecap_max(fma(radius_cos, t68, t69), 9.8607613e-32);
    let t71 = 1.0 / (t70 * t67);
    let t72 = t71 * t67;
    let t73 = t71 * t70;
    let frame_2_x = select(t59, t51, t57) * t73;
    let frame_2_y = select(t60, t53, t57) * t73;
    let frame_2_z = select(t61, t55, t57) * t73;
    let frame_0_x = t10 * t30;
    let frame_0_y = t11 * t30;
    let frame_0_z = t12 * t30;
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
    if (t49) {
        let t74 = sqrt(t47);
        let t75 = t66 + t62;
        let t76 = 1.0 / (t66 * t75);
        let t77 = t76 * t75;
        let t78 = t62 * t77;
        let t79 = t74 * t77;
        let t80 = abs(t43) * t65;
        let t81 = t80 * t78;
        let t82 = t78 - 0.5;
        let t83 = t81 - 0.5;
        let t84 = t82 * t82;
        let t85 = t83 * t83;
        let t86 = fma(0.05430631, t84, 0.080950715);
        let t87 = fma(t86, t84, 0.1684019);
        let t88 = fma(t87, t84, 0.32709444);
        let t89 = fma(t88, t84, 0.5987523);
        let t90 = fma(-0.026061837, t84, -0.06372378);
        let t91 = fma(t90, t84, -0.11762552);
        let t92 = fma(t91, t84, -0.23594604);
        let t93 = fma(t92, t84, -0.44721135);
        let t94 = fma(t93, t84, -0.7754678);
        let t95 = fma(t94, t82, fma(t89, t84, 0.94559944));
        let t96 = fma(t83, fma(fma(fma(fma(-0.026061837, t85, t90), t85, t91), t85, t92), t85, t93), fma(fma(fma(fma(0.05430631, t85, t86), t85, t87), t85, t88), t85, t89));
        let t97 = fma(t96, t82 + t83, t94);
        let t98 = fma(t81, t97, t95);
        t_x = t78;
        t_y = t79;
        kappa = t80;
        cut = t81;
        shape = t95;
        shape_cut = fma(t81 - t78, t97, t95);
        norm = t98;
        width = t47 * t76;
        inv_cut_1 = t69 * t72;
        tau = t74 * t65;
        area = t79 * t79 * t79 * (spherecap_min(t45, t46) * t65) * t98;
    }
    let t99 = radius_sin * radius_sin;
    let t100 = select(t99 * t68 * 3.1415927 + area, area, elevation_sin < 0.0);
    let t101 = t28 && 9.8607613e-32 < t99;
    let distance = t29 * unscale;
    let solid_angle = select(0.0, t99 * (t64 * t13) * 6.2831855, t101);
    let projected_above = select(0.0, t100, 9.403955e-38 < t100 && t101);
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let t102 = 0.0 < inv_above;
    let t103 = 0.0 < elevation_sin;
    let t104 = select(0.0, inv_above, t103);
    let t105 = select(select(0.0, 1.0, 0.0 < defensive || !t48), defensive, t102);
    let t106 = 0.0 < tau;
    let t107 = t103 && t106 && 0.0 < t104;
    let t108 = t_y * t_y * t_y * shape * t104;
    let t109 = t_y * inv_radius_sin;
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    if (!t103 && t106) {
        let t110 = 1.0 + kappa;
        let t111 = t110 * shape;
        let t112 = 1.0 / (norm * t111);
        let t113 = sqrt(t112);
        let t114 = norm * t113;
        let t115 = (t_x + kappa) * inv_cut_1 - 0.5;
        let t116 = t115 * t115;
        let t117 = fma(fma(fma(-0.026061837, t116, -0.06372378), t116, -0.11762552), t116, -0.23594604);
        let t118 = fma(fma(fma(0.05430631, t116, 0.080950715), t116, 0.1684019), t116, 0.32709444);
        let t119 = fma(fma(fma(t117, t116, -0.44721135), t116, -0.7754678), t115, fma(fma(t118, t116, 0.5987523), t116, 0.94559944));
        let t120 = t110 * t119 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t111 * t112);
        let t121 = fma(t120, t111 * t113, -1.0);
        let t122 = 1.0 - t120;
        let t123 = fma(fma(30.011856, t121, fma(-41.541264, t122, -37.009792)), t121, fma(77.96775, t122, 7.470758));
        let t124 = fma(fma(fma(fma(15.716111, t122, 0.0), t122, 9.961183), t122, -2.61785), t122, 0.8681748);
        let t125 = fma(fma(t123, t121, fma(fma(-49.13454, t122, -9.466533), t122, -1.5877596)), t121, t124);
        let t126 = t121 * t125;
        let t127 = fma(fma(7.295638, t121, -7.236236), t121, fma(fma(fma(-11.4868555, t122, 0.0), t122, 0.0), t122, 3.1255686));
        let t128 = fma(fma(fma(13.728438, t122, -7.981878), t122, 2.025724), t122, -0.7334958);
        let t129 = t121 * fma(t127, t121, t128);
        let t130 = fma(fma(-23.220068, t122, 7.332055), t121, fma(fma(fma(9.986537, t122, 25.22195), t122, 0.0), t122, -2.9581387));
        let t131 = fma(fma(fma(-19.722994, t122, 4.6594768), t122, -0.89538246), t122, 0.5143498);
        let t132 = t121 * fma(t130, t121, t131);
        let t133 = fma(fma(fma(1.946617, t121, -3.077631), t121, 1.4945927), t121, -0.24140751);
        let t134 = t121 * t133;
        let t135 = t121 * fma(fma(0.38173297, t121, -0.30305624), t121, 0.05897375);
        coefficients_0 = t114;
        coefficients_1 = t120 - t114 + t126;
        coefficients_2 = t129 - t126;
        coefficients_3 = t132 - t129;
        coefficients_4 = t134 - t132;
        coefficients_5 = t135 - t134;
        coefficients_6 = -t135;
    }
    let t136 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    let t137 = t136 && (t102 || (0.0 < t105 && 0.0 < solid_angle));
    var light: spherecap_front_light;
    light.is_sampled = t137;
    light.solid_angle = select(0.0, solid_angle, t137);
    light.projected_solid_angle = select(0.0, projected_above, t137);
    light.frame_0 = vec3f(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = vec3f(fma(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), fma(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), fma(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = vec3f(frame_2_x, frame_2_y, frame_2_z);
    light.normal = vec3f(normal_x, normal_y, normal_z);
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = select(0.0, t63 * (inv_radius_sin * inv_radius_sin) * 0.15915494, t101);
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t47 * (t30 * t30) * t72, -(radius_cos * t68));
    light.defensive = t105;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.crescent_share = select(0.0, t108, t107);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t108), t107);
    light.beyond = select(0.0, t109 * t109 * t109 * shape_cut, t107);
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
    var zenith = 0.0;
    var side = 0.0;
    var cosine = 0.0;
    if (t9) {
        let t54 = select(t51, t50, t16 < 0.0);
        var t55 = 0.0;
        var t56 = 0.0;
        var t57 = 0.0;
        if (t5) {
            let t58 = light.solid_angle * 0.15915494;
            let t59 = t58 * (1.0 - t52 * t12);
            let t60 = sqrt(t58 * (2.0 - t59));
            let t61 = (t54 - 1.0) * t60;
            t55 = t61;
            t56 = t53 * t11 * t60;
            t57 = fma(light.elevation_sin, 1.0 - t59, light.elevation_cos * t61);
        } else {
            let t62 = light.radius_sin * light.elevation_cos;
            let t63 = 1.0 - t54;
            let t64 = t52 * t12;
            let t65 = spherecap_max(fma(t62, t54, -light.rise), 0.0);
            let t66 = sqrt(fma(t65, t65, light.radius_sin * light.radius_sin * t64));
            let t67 = t1 * light.radius_cos;
            let t68 = fma(light.elevation_cos * t63, fma(t62, t63, -2.0 * t67), light.radius_sin * t64);
            let t69 = light.radius_sin * fma(light.elevation_cos, t68 / (t66 + t67), -(t1 * t1 * t63));
            t55 = t69;
            t56 = light.radius_sin * t53 * t11;
            t57 = t66;
        }
        zenith = t55;
        side = t56;
        cosine = t57;
    } else {
        let t70 = t53 * t16;
        zenith = fma(light.elevation_cos, t70, -(select(-t1, t1, t2) * (1.0 - t50)));
        side = t53 * t11;
        cosine = t70;
    }
    let t71 = spherecap_min(abs(cosine), 3.4028235e38);
    let t72 = select(0.0, light.inv_above, 0.0 < cosine);
    var t73 = 0.0;
    var t74 = 0.0;
    if (0.0 < light.defensive) {
        let t75 = light.defensive * light.inv_solid_angle;
        let t76 = fma(t72, t6, spherecap_min(t75 / spherecap_max(t71, 1.1754944e-38), 3.4028235e38));
        t73 = fma(t72, t6 * t71, t75);
        t74 = spherecap_min(t76, 3.4028235e38);
    } else {
        t73 = t72 * t71;
        t74 = t72;
    }
    let t77 = fma(zenith, zenith, side * side);
    let t78 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t77), 0.0);
    let t79 = sqrt(t78);
    let t80 = sqrt(fma(light.radius_cos, light.radius_cos, t78));
    let t81 = light.radius_cos * light.radius_cos / (t80 + t79);
    let t82 = fma(light.frame_0.x, t80, fma(light.frame_1.x, zenith, light.frame_2.x * side));
    let t83 = fma(light.frame_0.y, t80, fma(light.frame_1.y, zenith, light.frame_2.y * side));
    let t84 = fma(light.frame_0.z, t80, fma(light.frame_1.z, zenith, light.frame_2.z * side));
    let t85 = t81 * light.inv_radius_sin;
    let t86 = -fma(t80, t79, t77) * light.inv_radius_sin;
    let t87 = t85 * zenith;
    let t88 = t85 * side;
    let t89 = fma(light.frame_0.x, t86, fma(light.frame_1.x, t87, light.frame_2.x * t88));
    let t90 = fma(light.frame_0.y, t86, fma(light.frame_1.y, t87, light.frame_2.y * t88));
    let t91 = fma(light.frame_0.z, t86, fma(light.frame_1.z, t87, light.frame_2.z * t88));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t82, t83, t84);
    sampled.distance = t81 * light.distance;
    sampled.normal = vec3f(t89, t90, t91);
    sampled.cosine = cosine;
    sampled.pdf = t73;
    sampled.projected_pdf = t74;
    return sampled;
}

fn spherecap_front_sample_once(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_front_sample(spherecap_front_prepare(normal, centre, radius, defensive), u0, u1);
}

fn spherecap_front_pdf_direction(light: spherecap_front_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.frame_0.x, direction.x, fma(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    let t2 = fma(light.frame_1.x, direction.x, fma(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    let t3 = fma(light.frame_2.x, direction.x, fma(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    let t4 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
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
    let t1 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
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
    frame_0: vec3f,
    frame_1: vec3f,
    frame_2: vec3f,
    normal: vec3f,
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
    let unscale = spherecap_power_of_two(spherecap_min(t9, 8.5070587e37));
    let scale = spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale));
    let t10 = centre.x * scale;
    let t11 = centre.y * scale;
    let t12 = centre.z * scale;
    let t13 = radius * scale;
    let t14 = spherecap_keep(t10 * t10, unknown_zero);
    let t15 = spherecap_keep(t11 * t11, unknown_zero);
    let t16 = spherecap_keep(t12 * t12, unknown_zero);
    let t17 = spherecap_keep(t14 + t15, unknown_zero);
    let t18 = spherecap_keep(t17 - t14, unknown_zero);
    let t19 = spherecap_keep(t14 - spherecap_keep(t17 - t18, unknown_zero), unknown_zero);
    let t20 = spherecap_keep(t17 + t16, unknown_zero);
    let t21 = spherecap_keep(t20 - t17, unknown_zero);
    let t22 = spherecap_keep(t17 - spherecap_keep(t20 - t21, unknown_zero), unknown_zero);
    let t23 = spherecap_lost(t10, t10, t14, unknown_zero) + spherecap_lost(t11, t11, t15, unknown_zero);
    let t24 = t19 + spherecap_keep(t15 - t18, unknown_zero) + (t22 + spherecap_keep(t16 - t21, unknown_zero));
    let t25 = spherecap_keep(t13 * t13, unknown_zero);
    let t26 = t23 + spherecap_lost(t12, t12, t16, unknown_zero) + t24 - spherecap_lost(t13, t13, t25, unknown_zero);
    let t27 = t20 - t25 + t26;
    let t28 = 0.0 < t27;
    let t29 = sqrt(t20);
    let t30 = 1.0 / t29;
    let t31 = spherecap_keep(normal_x * t10, unknown_zero);
    let t32 = spherecap_keep(normal_y * t11, unknown_zero);
    let t33 = spherecap_keep(normal_z * t12, unknown_zero);
    let t34 = spherecap_keep(t31 + t32, unknown_zero);
    let t35 = spherecap_keep(t34 - t31, unknown_zero);
    let t36 = spherecap_keep(t31 - spherecap_keep(t34 - t35, unknown_zero), unknown_zero);
    let t37 = spherecap_keep(t34 + t33, unknown_zero);
    let t38 = spherecap_keep(t37 - t34, unknown_zero);
    let t39 = spherecap_keep(t34 - spherecap_keep(t37 - t38, unknown_zero), unknown_zero);
    let t40 = spherecap_lost(normal_x, t10, t31, unknown_zero) + spherecap_lost(normal_y, t11, t32, unknown_zero);
    let t41 = t36 + spherecap_keep(t32 - t35, unknown_zero) + (t39 + spherecap_keep(t33 - t38, unknown_zero));
    let t42 = t40 + spherecap_lost(normal_z, t12, t33, unknown_zero) + t41;
    let t43 = spherecap_keep(t37 + t42, unknown_zero);
    let t44 = spherecap_keep(t42 - spherecap_keep(t43 - t37, unknown_zero), unknown_zero);
    let t45 = t13 - t43 - t44;
    let t46 = t13 + t43 + t44;
    let t47 = t45 * t46;
    let t48 = 0.0 < t8;
    let t49 = 0.0 < t47 && t28 && t48;
    let t50 = spherecap_keep(normal_z * t11, unknown_zero);
    let t51 = spherecap_fused(normal_y, t12, -t50, unknown_zero) - spherecap_lost(normal_z, t11, t50, unknown_zero);
    let t52 = spherecap_keep(normal_x * t12, unknown_zero);
    let t53 = spherecap_fused(normal_z, t10, -t52, unknown_zero) - spherecap_lost(normal_x, t12, t52, unknown_zero);
    let t54 = spherecap_keep(normal_y * t10, unknown_zero);
    let t55 = spherecap_fused(normal_x, t11, -t54, unknown_zero) - spherecap_lost(normal_y, t10, t54, unknown_zero);
    let t56 = fma(t51, t51, fma(t53, t53, t55 * t55));
    let t57 = 9.8607613e-32 < t56;
    let t58 = abs(t10) < abs(t12);
    let t59 = select(-t11, 0.0, t58);
    let t60 = select(t10, -t12, t58);
    let t61 = select(0.0, t11, t58);
    let t62 = sqrt(spherecap_max(t27, 0.0));
    let radius_cos = t62 * t30;
    let t63 = 1.0 + radius_cos;
    let t64 = 1.0 / (t13 * t63);
    let t65 = t64 * t63;
    let radius_sin = t13 * t30;
    let inv_radius_sin = t29 * t65;
    let t66 = sqrt(t27 + t47);
    let t67 = sqrt(select(fma(t59, t59, fma(t60, t60, t61 * t61)), t56, t57));
    let elevation_sin = t43 * t30;
    let elevation_cos = select(select(0.0, t67, t57), t66, t49) * t30;
    let t68 = abs(elevation_sin);
    let t69 = radius_sin * elevation_cos;
    let t70 = spherecap_max(fma(radius_cos, t68, t69), 9.8607613e-32);
    let t71 = 1.0 / (t70 * t67);
    let t72 = t71 * t67;
    let t73 = t71 * t70;
    let frame_2_x = select(t59, t51, t57) * t73;
    let frame_2_y = select(t60, t53, t57) * t73;
    let frame_2_z = select(t61, t55, t57) * t73;
    let frame_0_x = t10 * t30;
    let frame_0_y = t11 * t30;
    let frame_0_z = t12 * t30;
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
    if (t49) {
        let t74 = sqrt(t47);
        let t75 = t66 + t62;
        let t76 = 1.0 / (t66 * t75);
        let t77 = t76 * t75;
        let t78 = t62 * t77;
        let t79 = t74 * t77;
        let t80 = abs(t43) * t65;
        let t81 = t80 * t78;
        let t82 = t78 - 0.5;
        let t83 = t81 - 0.5;
        let t84 = t82 * t82;
        let t85 = t83 * t83;
        let t86 = fma(0.05430631, t84, 0.080950715);
        let t87 = fma(t86, t84, 0.1684019);
        let t88 = fma(t87, t84, 0.32709444);
        let t89 = fma(t88, t84, 0.5987523);
        let t90 = fma(-0.026061837, t84, -0.06372378);
        let t91 = fma(t90, t84, -0.11762552);
        let t92 = fma(t91, t84, -0.23594604);
        let t93 = fma(t92, t84, -0.44721135);
        let t94 = fma(t93, t84, -0.7754678);
        let t95 = fma(t94, t82, fma(t89, t84, 0.94559944));
        let t96 = fma(t83, fma(fma(fma(fma(-0.026061837, t85, t90), t85, t91), t85, t92), t85, t93), fma(fma(fma(fma(0.05430631, t85, t86), t85, t87), t85, t88), t85, t89));
        let t97 = fma(t96, t82 + t83, t94);
        let t98 = fma(t81, t97, t95);
        t_x = t78;
        t_y = t79;
        kappa = t80;
        cut = t81;
        shape = t95;
        shape_cut = fma(t81 - t78, t97, t95);
        norm = t98;
        width = t47 * t76;
        inv_cut_1 = t69 * t72;
        tau = t74 * t65;
        area = t79 * t79 * t79 * (spherecap_min(t45, t46) * t65) * t98;
    }
    let t99 = radius_sin * radius_sin;
    let t100 = t99 * t68 * 3.1415927 + area;
    let t101 = elevation_sin < 0.0;
    let t102 = select(t100, area, t101);
    let t103 = select(area, t100, t101);
    let t104 = t28 && 9.8607613e-32 < t99;
    let distance = t29 * unscale;
    let solid_angle = select(0.0, t99 * (t64 * t13) * 6.2831855, t104);
    let projected_above = select(0.0, t102, 9.403955e-38 < t102 && t104);
    let projected_below = select(0.0, t103, 9.403955e-38 < t103 && t104);
    let inv_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let inv_below = select(0.0, 1.0 / projected_below, 0.0 < projected_below);
    let t105 = 0.0 < inv_above + inv_below;
    let t106 = 0.0 < elevation_sin;
    let t107 = select(inv_below, inv_above, t106);
    let t108 = select(select(0.0, 1.0, 0.0 < defensive || !t48), defensive, t105);
    let t109 = 0.0 < tau;
    let t110 = t109 && 0.0 < t107;
    let t111 = t_y * t_y * t_y * shape * t107;
    let t112 = t_y * inv_radius_sin;
    var coefficients_0 = 0.0;
    var coefficients_1 = 0.0;
    var coefficients_2 = 0.0;
    var coefficients_3 = 0.0;
    var coefficients_4 = 0.0;
    var coefficients_5 = 0.0;
    var coefficients_6 = 0.0;
    var t113 = 0.0;
    if (t109) {
        let t114 = 1.0 + kappa;
        let t115 = t114 * shape;
        let t116 = 1.0 / (norm * t115);
        let t117 = sqrt(t116);
        let t118 = norm * t117;
        let t119 = (t_x + kappa) * inv_cut_1 - 0.5;
        let t120 = t119 * t119;
        let t121 = fma(fma(fma(-0.026061837, t120, -0.06372378), t120, -0.11762552), t120, -0.23594604);
        let t122 = fma(fma(fma(0.05430631, t120, 0.080950715), t120, 0.1684019), t120, 0.32709444);
        let t123 = fma(fma(fma(t121, t120, -0.44721135), t120, -0.7754678), t119, fma(fma(t122, t120, 0.5987523), t120, 0.94559944));
        let t124 = t114 * t123 * (inv_cut_1 * inv_cut_1 * inv_cut_1) * (t115 * t116);
        let t125 = fma(t124, t115 * t117, -1.0);
        let t126 = 1.0 - t124;
        let t127 = fma(fma(30.011856, t125, fma(-41.541264, t126, -37.009792)), t125, fma(77.96775, t126, 7.470758));
        let t128 = fma(fma(fma(fma(15.716111, t126, 0.0), t126, 9.961183), t126, -2.61785), t126, 0.8681748);
        let t129 = fma(fma(t127, t125, fma(fma(-49.13454, t126, -9.466533), t126, -1.5877596)), t125, t128);
        let t130 = t125 * t129;
        let t131 = fma(fma(7.295638, t125, -7.236236), t125, fma(fma(fma(-11.4868555, t126, 0.0), t126, 0.0), t126, 3.1255686));
        let t132 = fma(fma(fma(13.728438, t126, -7.981878), t126, 2.025724), t126, -0.7334958);
        let t133 = t125 * fma(t131, t125, t132);
        let t134 = fma(fma(-23.220068, t126, 7.332055), t125, fma(fma(fma(9.986537, t126, 25.22195), t126, 0.0), t126, -2.9581387));
        let t135 = fma(fma(fma(-19.722994, t126, 4.6594768), t126, -0.89538246), t126, 0.5143498);
        let t136 = t125 * fma(t134, t125, t135);
        let t137 = fma(fma(fma(1.946617, t125, -3.077631), t125, 1.4945927), t125, -0.24140751);
        let t138 = t125 * t137;
        let t139 = t125 * fma(fma(0.38173297, t125, -0.30305624), t125, 0.05897375);
        let t140 = 1.0 / (elevation_cos * elevation_cos);
        let t141 = tau * tau;
        let t142 = t141 * t140 / (1.0 + t_x);
        let t143 = kappa - 0.5;
        let t144 = cut - 0.5;
        let t145 = t143 * t143;
        let t146 = t144 * t144;
        let t147 = fma(0.05430631, t145, 0.080950715);
        let t148 = fma(t147, t145, 0.1684019);
        let t149 = fma(t148, t145, 0.32709444);
        let t150 = fma(fma(fma(fma(0.05430631, t146, t147), t146, t148), t146, t149), t146, fma(t149, t145, 0.5987523));
        let t151 = fma(-0.026061837, t145, -0.06372378);
        let t152 = fma(t151, t145, -0.11762552);
        let t153 = fma(t152, t145, -0.23594604);
        let t154 = fma(t153, t145, -0.44721135);
        let t155 = fma(fma(fma(fma(-0.026061837, t146, t151), t146, t152), t146, t153), t146, t154);
        let t156 = fma(kappa * t142, fma(fma(t144, t155, t150), t143 + t144, fma(t154, t145, -0.7754678)), fma(shape_cut, t142 - kappa * kappa, kappa) * t140);
        let t157 = spherecap_min(spherecap_max(t141 * tau * (radius_cos + 1.0) * t156 * 0.31830987, 0.0), 0.5);
        coefficients_0 = t118;
        coefficients_1 = t124 - t118 + t130;
        coefficients_2 = t133 - t130;
        coefficients_3 = t136 - t133;
        coefficients_4 = t138 - t136;
        coefficients_5 = t139 - t138;
        coefficients_6 = -t139;
        t113 = t157;
    }
    let share_above = select(1.0, select(0.0, select(t113, 1.0 - t113, t106), 0.0 < inv_above), 0.0 < inv_below);
    let t158 = 0.0 <= defensive && defensive <= 1.0 && t8 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38;
    let t159 = t158 && (t105 || (0.0 < t108 && 0.0 < solid_angle));
    var light: spherecap_both_light;
    light.is_sampled = t159;
    light.solid_angle = select(0.0, solid_angle, t159);
    light.projected_solid_angle = select(0.0, projected_above, t159);
    light.frame_0 = vec3f(frame_0_x, frame_0_y, frame_0_z);
    light.frame_1 = vec3f(fma(frame_0_y, frame_2_z, -(frame_0_z * frame_2_y)), fma(frame_0_z, frame_2_x, -(frame_0_x * frame_2_z)), fma(frame_0_x, frame_2_y, -(frame_0_y * frame_2_x)));
    light.frame_2 = vec3f(frame_2_x, frame_2_y, frame_2_z);
    light.normal = vec3f(normal_x, normal_y, normal_z);
    light.distance = distance;
    light.radius_sin = radius_sin;
    light.inv_radius_sin = inv_radius_sin;
    light.radius_cos = radius_cos;
    light.elevation_sin = elevation_sin;
    light.elevation_cos = elevation_cos;
    light.inv_solid_angle = select(0.0, t63 * (inv_radius_sin * inv_radius_sin) * 0.15915494, t104);
    light.kappa = kappa;
    light.tau = tau;
    light.width = width;
    light.cut = cut;
    light.rise = spherecap_max(t47 * (t30 * t30) * t72, -(radius_cos * t68));
    light.defensive = t108;
    light.requested = defensive;
    light.inv_above = inv_above;
    light.inv_below = inv_below;
    light.share_above = share_above;
    light.crescent_share = select(0.0, t111, t110);
    light.inv_rest = select(1.0, 1.0 / (1.0 - t111), t110);
    light.beyond = select(0.0, t112 * t112 * t112 * shape_cut, t110);
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
    var side = 0.0;
    var t60 = 0.0;
    if (t14) {
        let t61 = select(t56, t55, t21 < 0.0);
        var t62 = 0.0;
        var t63 = 0.0;
        var t64 = 0.0;
        if (t5) {
            let t65 = light.solid_angle * 0.15915494;
            let t66 = t65 * (1.0 - t57 * t17);
            let t67 = sqrt(t65 * (2.0 - t66));
            let t68 = (t61 - 1.0) * t67;
            t62 = t68;
            t63 = t58 * t16 * t67;
            t64 = fma(light.elevation_sin, 1.0 - t66, light.elevation_cos * t68);
        } else {
            let t69 = light.radius_sin * light.elevation_cos;
            let t70 = 1.0 - t61;
            let t71 = t57 * t17;
            let t72 = spherecap_max(fma(t69, t61, -light.rise), 0.0);
            let t73 = sqrt(fma(t72, t72, light.radius_sin * light.radius_sin * t71));
            let t74 = t1 * light.radius_cos;
            let t75 = fma(light.elevation_cos * t70, fma(t69, t70, -2.0 * t74), light.radius_sin * t71);
            let t76 = light.radius_sin * fma(light.elevation_cos, t75 / (t73 + t74), -(t1 * t1 * t70));
            t62 = t76;
            t63 = light.radius_sin * t58 * t16;
            t64 = t73;
        }
        t59 = t62;
        side = t63;
        t60 = t64;
    } else {
        let t77 = t58 * t21;
        t59 = fma(light.elevation_cos, t77, -(select(-t1, t1, t12) * (1.0 - t55)));
        side = t58 * t16;
        t60 = t77;
    }
    let t78 = select(-1.0, 1.0, t9);
    let zenith = t59 * t78;
    let cosine = t60 * t78;
    let t79 = spherecap_min(abs(cosine), 3.4028235e38);
    let t80 = select(select(0.0, light.inv_below * t10, cosine < 0.0), light.inv_above * light.share_above, 0.0 < cosine);
    var t81 = 0.0;
    var t82 = 0.0;
    if (0.0 < light.defensive) {
        let t83 = light.defensive * light.inv_solid_angle;
        let t84 = fma(t80, t6, spherecap_min(t83 / spherecap_max(t79, 1.1754944e-38), 3.4028235e38));
        t81 = fma(t80, t6 * t79, t83);
        t82 = spherecap_min(t84, 3.4028235e38);
    } else {
        t81 = t80 * t79;
        t82 = t80;
    }
    let t85 = fma(zenith, zenith, side * side);
    let t86 = spherecap_max(fma(light.radius_sin, light.radius_sin, -t85), 0.0);
    let t87 = sqrt(t86);
    let t88 = sqrt(fma(light.radius_cos, light.radius_cos, t86));
    let t89 = light.radius_cos * light.radius_cos / (t88 + t87);
    let t90 = fma(light.frame_0.x, t88, fma(light.frame_1.x, zenith, light.frame_2.x * side));
    let t91 = fma(light.frame_0.y, t88, fma(light.frame_1.y, zenith, light.frame_2.y * side));
    let t92 = fma(light.frame_0.z, t88, fma(light.frame_1.z, zenith, light.frame_2.z * side));
    let t93 = t89 * light.inv_radius_sin;
    let t94 = -fma(t88, t87, t85) * light.inv_radius_sin;
    let t95 = t93 * zenith;
    let t96 = t93 * side;
    let t97 = fma(light.frame_0.x, t94, fma(light.frame_1.x, t95, light.frame_2.x * t96));
    let t98 = fma(light.frame_0.y, t94, fma(light.frame_1.y, t95, light.frame_2.y * t96));
    let t99 = fma(light.frame_0.z, t94, fma(light.frame_1.z, t95, light.frame_2.z * t96));
    var sampled: spherecap_sample;
    sampled.direction = vec3f(t90, t91, t92);
    sampled.distance = t89 * light.distance;
    sampled.normal = vec3f(t97, t98, t99);
    sampled.cosine = cosine;
    sampled.pdf = t81;
    sampled.projected_pdf = t82;
    return sampled;
}

fn spherecap_both_sample_once(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_both_sample(spherecap_both_prepare(normal, centre, radius, defensive), u0, u1);
}

fn spherecap_both_pdf_direction(light: spherecap_both_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.frame_0.x, direction.x, fma(light.frame_0.y, direction.y, light.frame_0.z * direction.z));
    let t2 = fma(light.frame_1.x, direction.x, fma(light.frame_1.y, direction.y, light.frame_1.z * direction.z));
    let t3 = fma(light.frame_2.x, direction.x, fma(light.frame_2.y, direction.y, light.frame_2.z * direction.z));
    let t4 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
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
    let t1 = fma(light.normal.x, direction.x, fma(light.normal.y, direction.y, light.normal.z * direction.z));
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

