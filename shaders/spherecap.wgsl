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
    return spherecap_sample(
        vec3f(0.0, 0.0, 0.0), 0.0, vec3f(0.0, 0.0, 0.0), 0.0, 0.0, 0.0
    );
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
    density_above: f32,
    third_axis: vec3f,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    middle: f32,
    half_axis: f32,
    climb: f32,
    b_0: f32,
    b_1: f32,
    b_2: f32,
    b_3: f32,
    b_4: f32,
    b_5: f32,
    b_6: f32,
}

fn spherecap_surface_prepare(normal: vec3f, centre: vec3f, radius: f32) -> spherecap_surface_light {
    let unknown_zero = bitcast<u32>(radius) & 0x80000000u;
    let t1 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    let t2 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    let unscale = spherecap_power_of_two(min(8.5070587e37, t2));
    let t3 = select(spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale)), 1.0, t1);
    let t4 = centre.x * t3;
    let t5 = centre.y * t3;
    let t6 = centre.z * t3;
    let t7 = radius * t3;
    let t8 = spherecap_keep(t6 * t6, unknown_zero);
    let t9 = fma(t4, t4, fma(t5, t5, t8));
    let t10 = fma(-t7, t7, t9);
    var t11: f32;
    var t12: f32;
    if (t10 < t9 * 0.25) {
        let t13 = spherecap_keep(t4 * t4, unknown_zero);
        let t14 = spherecap_keep(t5 * t5, unknown_zero);
        let t15 = spherecap_keep(t13 + t14, unknown_zero);
        let t16 = spherecap_keep(t15 - t13, unknown_zero);
        let t17 = spherecap_keep(t13 - spherecap_keep(t15 - t16, unknown_zero), unknown_zero);
        t11 = spherecap_keep(t15 + t8, unknown_zero);
        let t18 = spherecap_keep(t11 - t15, unknown_zero);
        let t19 = spherecap_keep(t15 - spherecap_keep(t11 - t18, unknown_zero), unknown_zero);
        let t20 = spherecap_lost(t4, t4, t13, unknown_zero) + spherecap_lost(t5, t5, t14, unknown_zero);
        let t21 = t17 + spherecap_keep(t14 - t16, unknown_zero) + (t19 + spherecap_keep(t8 - t18, unknown_zero));
        t12 = spherecap_fused(-t7, t7, t11, unknown_zero) + (t20 + spherecap_lost(t6, t6, t8, unknown_zero) + t21);
    } else {
        t11 = t9;
        t12 = t10;
    }
    let t22 = spherecap_keep(normal.z * t5, unknown_zero);
    let t23 = spherecap_fused(normal.y, t6, -t22, unknown_zero);
    let t24 = spherecap_keep(normal.x * t6, unknown_zero);
    let t25 = spherecap_fused(normal.z, t4, -t24, unknown_zero);
    let t26 = spherecap_keep(normal.y * t4, unknown_zero);
    let t27 = spherecap_fused(normal.x, t5, -t26, unknown_zero);
    let t28 = fma(t23, t23, fma(t25, t25, t27 * t27));
    var t29: f32;
    var t30: f32;
    var t31: f32;
    var t32: f32;
    var t33: f32;
    if (t28 < t11 * 0.015625) {
        let t34 = t23 - spherecap_lost(normal.z, t5, t22, unknown_zero);
        let t35 = t25 - spherecap_lost(normal.x, t6, t24, unknown_zero);
        let t36 = t27 - spherecap_lost(normal.y, t4, t26, unknown_zero);
        let t37 = fma(t34, t34, fma(t35, t35, t36 * t36));
        let t38 = t37 < t11 * 5.169879e-26;
        let t39 = abs(t4) < abs(t6);
        let t40 = select(-t5, 0.0, t39);
        let t41 = select(t4, -t6, t39);
        let t42 = select(0.0, t5, t39);
        let t43 = sqrt(t37);
        t29 = select(t34, t40, t38);
        t30 = select(t35, t41, t38);
        t31 = select(t36, t42, t38);
        t32 = select(t43, sqrt(fma(t40, t40, fma(t41, t41, t42 * t42))), t38);
        t33 = select(t43, 0.0, t38);
    } else {
        t32 = sqrt(t28);
        t29 = t23;
        t30 = t25;
        t31 = t27;
        t33 = t32;
    }
    let t44 = spherecap_keep(normal.x * t4, unknown_zero);
    let t45 = spherecap_keep(normal.y * t5, unknown_zero);
    let t46 = spherecap_keep(normal.z * t6, unknown_zero);
    let t47 = spherecap_keep(t44 + t45, unknown_zero);
    let t48 = spherecap_keep(t47 - t44, unknown_zero);
    let t49 = spherecap_keep(t44 - spherecap_keep(t47 - t48, unknown_zero), unknown_zero);
    let t50 = spherecap_keep(t47 + t46, unknown_zero);
    let t51 = spherecap_keep(t50 - t47, unknown_zero);
    let t52 = spherecap_keep(t47 - spherecap_keep(t50 - t51, unknown_zero), unknown_zero);
    let t53 = spherecap_lost(normal.x, t4, t44, unknown_zero) + spherecap_lost(normal.y, t5, t45, unknown_zero);
    let t54 = t49 + spherecap_keep(t45 - t48, unknown_zero) + (t52 + spherecap_keep(t46 - t51, unknown_zero));
    let t55 = t53 + spherecap_lost(normal.z, t6, t46, unknown_zero) + t54;
    let t56 = spherecap_keep(t50 + t55, unknown_zero);
    let t57 = spherecap_keep(t55 - spherecap_keep(t56 - t50, unknown_zero), unknown_zero);
    let t58 = t7 - t56 - t57;
    let t59 = t7 + t56 + t57;
    let t60 = t58 * t59;
    let t61 = sqrt(t11);
    let t62 = 1.0 / t61;
    let t63 = sqrt(t12);
    let elevation_sin = t56 * t62;
    let t64 = 0.0 < t12;
    let t65 = 0.0 < t60 && t64;
    let t66 = 0.0 < elevation_sin;
    var t67: f32;
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
    if (t65) {
        t67 = sqrt(t12 + t60);
        let t68 = sqrt(t60);
        let t69 = 1.0 / (t67 * t7);
        let t70 = t69 * t7;
        let t71 = t69 * t67;
        t_x = t63 * t70;
        t_y = t68 * t70;
        let t72 = t_y * t_y;
        kappa = abs(t56) * t71;
        cut = kappa * t_x;
        let t73 = t_x - 0.5;
        let t74 = cut - 0.5;
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
        shape = fma(t85, t73, fma(t80, t75, 0.94559944));
        let t86 = fma(t74, fma(fma(fma(fma(-0.026061837, t76, t81), t76, t82), t76, t83), t76, t84), fma(fma(fma(fma(0.05430631, t76, t77), t76, t78), t76, t79), t76, t80));
        shape_difference = fma(t86, t73 + t74, t85);
        norm = fma(cut, shape_difference, shape);
        width = t72 / (1.0 + t_x);
        tau = t68 * t71;
        area = t72 * t_y * (min(t59, t58) * t71) * norm;
    } else {
        t67 = t33;
    }
    let radius_sin = t7 * t62;
    let radius_cos = t63 * t62;
    let elevation_cos = t67 * t62;
    let t87 = abs(elevation_sin);
    let climb = radius_sin * elevation_cos;
    let rise = max(-(radius_cos * t87), t60 * (t62 * t62) / fma(radius_cos, t87, climb));
    let t88 = radius_sin * radius_sin;
    let t89 = select(area, fma(t88 * t87, 3.1415927, area), t66);
    let t90 = 9.8607613e-32 < t88;
    let towards_centre = vec3f(t4, t5, t6) * t62;
    let t91 = 1.0 / t32;
    let sideways = vec3f(t29, t30, t31) * t91;
    let distance = t61 * select(unscale, 1.0, t1);
    let projected_above = select(0.0, t89, 9.403955e-38 < t89 && t90 && t64);
    let density_above = select(0.0, 1.0 / projected_above, 0.0 < projected_above);
    let t92 = select(0.0, density_above, t66);
    let t93 = t65 && t66 && 0.0 < t92;
    let t94 = t_y * t_y * t_y * shape * t92;
    let t95 = t_y / radius_sin;
    let beyond = select(0.0, t95 * t95 * t95 * (fma(cut - t_x, shape_difference, shape) * 0.53033006), t93);
    var b_0 = 0.0;
    var b_1 = 0.0;
    var b_2 = 0.0;
    var b_3 = 0.0;
    var b_4 = 0.0;
    var b_5 = 0.0;
    var b_6 = 0.0;
    if (t65 && !t66) {
        let t96 = 1.0 + kappa;
        let t97 = t96 * shape;
        let t98 = 1.0 / (norm * t97);
        let t99 = sqrt(t98);
        b_0 = norm * t99;
        let t100 = 1.0 / (1.0 + cut);
        let t101 = (t_x + kappa) * t100 - 0.5;
        let t102 = t101 * t101 * t101;
        let t103 = fma(fma(fma(-0.026061837, t101, 0.05430631), t101, -0.06372378), t102, fma(fma(0.080950715, t101, -0.11762552), t101, 0.1684019));
        let t104 = fma(t103, t102, fma(fma(-0.23594604, t101, 0.32709444), t101, -0.44721135));
        let t105 = t96 * fma(t104, t102, fma(fma(0.5987523, t101, -0.7754678), t101, 0.94559944));
        let t106 = t105 * (t100 * t100 * t100) * (t97 * t98);
        let t107 = fma(t106, t97 * t99, -1.0);
        let t108 = 1.0 - t106;
        let t109 = fma(fma(30.011856, t107, fma(-41.541264, t108, -37.009792)), t107, fma(77.96775, t108, 7.470758));
        let t110 = fma(fma(fma(15.716111 * t108, t108, 9.961183), t108, -2.61785), t108, 0.8681748);
        let t111 = fma(fma(t109, t107, fma(fma(-49.13454, t108, -9.466533), t108, -1.5877596)), t107, t110);
        let t112 = t107 * t111;
        let t113 = fma(fma(7.295638, t107, -7.236236), t107, fma(-11.4868555 * t108 * t108, t108, 3.1255686));
        let t114 = fma(fma(fma(13.728438, t108, -7.981878), t108, 2.025724), t108, -0.7334958);
        let t115 = t107 * fma(t113, t107, t114);
        let t116 = fma(fma(-23.220068, t108, 7.332055), t107, fma(fma(9.986537, t108, 25.22195) * t108, t108, -2.9581387));
        let t117 = fma(fma(fma(-19.722994, t108, 4.6594768), t108, -0.89538246), t108, 0.5143498);
        let t118 = t107 * fma(t116, t107, t117);
        let t119 = fma(fma(fma(1.946617, t107, -3.077631), t107, 1.4945927), t107, -0.24140751);
        let t120 = t107 * t119;
        let t121 = t107 * fma(fma(0.38173297, t107, -0.30305624), t107, 0.05897375);
        b_1 = t106 - b_0 + t112;
        b_2 = t115 - t112;
        b_3 = t118 - t115;
        b_4 = t120 - t118;
        b_5 = t121 - t120;
        b_6 = -t121;
    }
    let t122 = 0.0 < radius && distance <= 3.4028235e38 && 0.0 < density_above;
    let t123 = select(0.0, t88 / (1.0 + radius_cos), 0.0 < radius_cos && t90) * 6.2831855;
    return spherecap_surface_light(
        t122, select(0.0, t123, t122), select(0.0, projected_above, t122), towards_centre, sideways, normal,
        distance, radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise,
        density_above, cross(sideways, normal), select(0.0, t94, t93), select(1.0, 1.0 / (1.0 - t94), t93),
        beyond, elevation_cos * radius_cos, radius_sin * t87, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    );
}

fn spherecap_surface_sample(light: spherecap_surface_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = abs(light.elevation_sin);
    let t2 = 0.0 < light.tau;
    let t3 = min(0.99999994, max(5.9604645e-8, u0));
    let t4 = min(0.99999994, max(5.9604645e-8, u1));
    let t5 = !(0.0 < light.elevation_sin) && t2;
    let t6 = light.crescent_share <= t3 && !t5;
    let t7 = !t2 || t6;
    let t8 = 1.0 - t4;
    let t9 = t4 - t8;
    let t10 = 4.0 * t4 * t8;
    let t11 = min(0.99999994, max(5.9604645e-8, (t3 - light.crescent_share) * light.inv_rest));
    let t12 = select(t3, t11, t2);
    let t13 = select(0.0, light.beyond, t2);
    let t14 = 1.6660811 - t13;
    let t15 = fma(t12, t14, t13);
    let t16 = (1.0 - t12) * t14;
    var t18: f32;
    var t19: f32;
    var t20: f32;
    var t17 = 0.0;
    if (t7) {
        t18 = min(t16, t15);
        t19 = 1.0;
        t20 = 1.0;
    } else {
        let t21 = sqrt(t10);
        let t22 = fma(fma(fma(light.b_5, t10, light.b_3), t10, light.b_1), t21, fma(fma(fma(light.b_6, t10, light.b_4), t10, light.b_2), t10, light.b_0));
        let t23 = t21 * t22;
        let t24 = sqrt(fma(t9, t9, t23 * t23));
        let t25 = light.tau * t23;
        t20 = select(1.0, fma(t9, t9, t25 * t25), t5);
        let t26 = select(light.crescent_share, fma(light.kappa, t23, t24) * fma(light.cut, t23, t24), t5);
        let t27 = select(t3, light.width, t5) / t26;
        let t28 = select(light.width, t27, t5);
        let t29 = t20 * t28;
        let t30 = fma(fma(fma(-0.00060778117, t29, 1.0676054e-5), t29, -0.0027203285), t29 * t29 * t29, fma(fma(-0.011332183, t29, -0.10000902), t29, 1.0000001));
        t17 = select(t21, t25, t5);
        t18 = select(min(0.99999994, max(5.9604645e-8, t27)), t3, t5);
        t19 = t28 * t30;
    }
    let t31 = spherecap_float_of_bits(fma(spherecap_bits(t18), -0.33333334, 1419900500.0));
    let t32 = t18 * t31;
    let t33 = fma(-t32, t31 * t31, 1.0);
    let t34 = t33 * t33;
    let t35 = fma(fma(0.12666093, t34, fma(0.14565912, t33, 0.17283025)), t34, fma(0.22221696, t33, 0.33333334));
    let t36 = t19 * fma(t32 * t33, t35, t32);
    let t37 = t36 * t20;
    let t38 = t37 * t37 * t37;
    let t39 = fma(fma(fma(0.022114987, t37, -0.063446075), t37, 0.085662976), t38, fma(fma(-0.056249518, t37, 0.030445365), t37, 0.0074712755));
    let t40 = t36 * fma(t39, t38, fma(fma(0.03209764, t37, 0.09996679), t37, 1.0000004));
    let t41 = t20 * t40;
    let t42 = 2.0 - t41;
    let t43 = t40 * t42;
    let t44 = sqrt(t43);
    var zenith: f32;
    var side: f32;
    var cosine: f32;
    var t45: f32;
    if (t7) {
        let t46 = select(t42, t41, t15 - t16 < 0.0);
        let t47 = 1.0 - t46;
        let t48 = light.radius_sin * light.radius_sin * t10;
        let t49 = max(0.0, fma(light.climb, t46, -light.rise));
        cosine = sqrt(fma(t43, t48, t49 * t49));
        let t50 = t1 * light.radius_cos;
        let t51 = light.climb * t47;
        zenith = fma(light.elevation_cos, fma(t51, t51 - 2.0 * t50, t43 * t48) / (cosine + t50), -(light.half_axis * t1 * t47));
        side = light.radius_sin * t44 * t9;
        t45 = fma(light.half_axis, t47, light.middle);
    } else {
        cosine = t44 * t17;
        t45 = 1.0 - t41;
        zenith = fma(light.elevation_cos, cosine, -(select(t1, -t1, t5) * t45));
        side = t44 * t9;
    }
    let t52 = min(3.4028235e38, 0.0 / max(1.1754944e-38, min(3.4028235e38, abs(cosine))));
    let t53 = fma(zenith, zenith, side * side);
    let t54 = max(0.0, fma(light.radius_sin, light.radius_sin, -t53));
    let t55 = sqrt(t54);
    let t56 = sqrt(fma(light.radius_cos, light.radius_cos, t54));
    let t57 = light.radius_cos * light.radius_cos / (t56 + t55);
    let t58 = 1.0 / light.radius_sin;
    let t59 = t57 * t58;
    let t60 = -fma(t56, t55, t53) * t58;
    let t61 = t59 * zenith;
    let t62 = t59 * side;
    let t63 = fma(light.elevation_cos, t60, -(light.elevation_sin * t61));
    let t64 = fma(light.elevation_sin, t60, light.elevation_cos * t61);
    return spherecap_sample(
        light.third_axis * t45 + light.sideways * side + light.normal * cosine, t57 * light.distance,
        light.third_axis * t63 + light.sideways * t62 + light.normal * t64, cosine,
        light.density_above * min(3.4028235e38, max(0.0, cosine)),
        min(3.4028235e38, select(0.0, light.density_above, 0.0 < cosine) + t52)
    );
}

fn spherecap_surface_sample_once(normal: vec3f, centre: vec3f, radius: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_surface_sample(spherecap_surface_prepare(normal, centre, radius), u0, u1);
}

fn spherecap_surface_pdf_direction(light: spherecap_surface_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = dot(light.towards_centre, direction) < 0.0;
    let t2 = select(dot(cross(light.towards_centre, light.sideways), direction), 1.0, t1);
    let t3 = select(dot(light.sideways, direction), 1.0, t1);
    let t4 = light.density_above * min(3.4028235e38, max(0.0, dot(light.normal, direction)));
    let t5 = select(0.0, t4, fma(t2, t2, t3 * t3) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t6 = dot(direction, direction);
    return select(0.0, t5, 0.998001 <= t6 && t6 <= 1.002001);
}

fn spherecap_surface_pdf_on_sphere(light: spherecap_surface_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = light.density_above * min(3.4028235e38, max(0.0, dot(light.normal, direction)));
    let t2 = dot(direction, direction);
    return select(0.0, t1, 0.998001 <= t2 && t2 <= 1.002001);
}

fn spherecap_surface_importance(normal: vec3f, centre: vec3f, radius: f32, strength: f32) -> f32 {
    let t1 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    let t2 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    let unscale = spherecap_power_of_two(min(8.5070587e37, t2));
    let t3 = select(spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale)), 1.0, t1);
    let t4 = centre.x * t3;
    let t5 = centre.y * t3;
    let t6 = centre.z * t3;
    let t7 = radius * t3;
    let t8 = sqrt(fma(t4, t4, fma(t5, t5, t6 * t6)));
    let t9 = 1.0 / t8;
    let t10 = t7 * t9;
    let t11 = t10 * t10;
    let t12 = 0.0 < radius && t8 * select(unscale, 1.0, t1) <= 3.4028235e38 && 0.0 < strength;
    let t13 = fma(normal.x, t4, fma(normal.y, t5, normal.z * t6));
    let t14 = fma(t13, t9, 2.3841858e-7);
    let t15 = fma(t13 + t7, t9, 2.3841858e-7);
    let t16 = t15 * t15 / (fma(t10 - t14, max(0.0, fma(-t11, t11, 0.9999981)), t15) * 2.0);
    let t17 = select(select(0.0, t16, 0.0 < t15), t14, t10 <= t14);
    let t18 = fma(0.0, 0.5 - t17, t17);
    let t19 = t11 <= 1.0000019 && 4.9303807e-32 < t11 && strength <= 3.4028235e38 && t12;
    let t20 = select(0.0, min(3.4028235e38, max(1.1754944e-38, t11 * t18 * strength)), 0.0 < t18 && t19);
    return t20;
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
    defensive: f32,
    requested: f32,
    density_above: f32,
    third_axis: vec3f,
    height: f32,
    density: f32,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    middle: f32,
    half_axis: f32,
    climb: f32,
    b_0: f32,
    b_1: f32,
    b_2: f32,
    b_3: f32,
    b_4: f32,
    b_5: f32,
    b_6: f32,
}

fn spherecap_front_prepare(normal: vec3f, centre: vec3f, radius: f32, defensive: f32) -> spherecap_front_light {
    let unknown_zero = bitcast<u32>(radius) & 0x80000000u;
    var normal_x: f32;
    var normal_y: f32;
    var normal_z: f32;
    if (abs(dot(normal, normal) - 1.0) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        let t1 = min(8.5070587e37, max(1.1754944e-38, abs(normal.x) + abs(normal.y) + abs(normal.z)));
        let t2 = spherecap_power_of_two(t1);
        let t3 = normal.x / t2;
        let t4 = normal.y / t2;
        let t5 = normal.z / t2;
        let t6 = max(1.1754944e-38, sqrt(fma(t3, t3, fma(t4, t4, t5 * t5))));
        normal_x = t3 / t6;
        normal_y = t4 / t6;
        normal_z = t5 / t6;
    }
    let t7 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    let t8 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    let t9 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    let unscale = spherecap_power_of_two(min(8.5070587e37, t9));
    let t10 = select(spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale)), 1.0, t8);
    let t11 = centre.x * t10;
    let t12 = centre.y * t10;
    let t13 = centre.z * t10;
    let t14 = radius * t10;
    let t15 = spherecap_keep(t13 * t13, unknown_zero);
    let t16 = fma(t11, t11, fma(t12, t12, t15));
    let t17 = fma(-t14, t14, t16);
    var t18: f32;
    var t19: f32;
    if (t17 < t16 * 0.25) {
        let t20 = spherecap_keep(t11 * t11, unknown_zero);
        let t21 = spherecap_keep(t12 * t12, unknown_zero);
        let t22 = spherecap_keep(t20 + t21, unknown_zero);
        let t23 = spherecap_keep(t22 - t20, unknown_zero);
        let t24 = spherecap_keep(t20 - spherecap_keep(t22 - t23, unknown_zero), unknown_zero);
        t18 = spherecap_keep(t22 + t15, unknown_zero);
        let t25 = spherecap_keep(t18 - t22, unknown_zero);
        let t26 = spherecap_keep(t22 - spherecap_keep(t18 - t25, unknown_zero), unknown_zero);
        let t27 = spherecap_lost(t11, t11, t20, unknown_zero) + spherecap_lost(t12, t12, t21, unknown_zero);
        let t28 = t24 + spherecap_keep(t21 - t23, unknown_zero) + (t26 + spherecap_keep(t15 - t25, unknown_zero));
        t19 = spherecap_fused(-t14, t14, t18, unknown_zero) + (t27 + spherecap_lost(t13, t13, t15, unknown_zero) + t28);
    } else {
        t18 = t16;
        t19 = t17;
    }
    let t29 = spherecap_keep(normal_z * t12, unknown_zero);
    let t30 = spherecap_fused(normal_y, t13, -t29, unknown_zero);
    let t31 = spherecap_keep(normal_x * t13, unknown_zero);
    let t32 = spherecap_fused(normal_z, t11, -t31, unknown_zero);
    let t33 = spherecap_keep(normal_y * t11, unknown_zero);
    let t34 = spherecap_fused(normal_x, t12, -t33, unknown_zero);
    let t35 = fma(t30, t30, fma(t32, t32, t34 * t34));
    var up_x: f32;
    var up_y: f32;
    var up_z: f32;
    var t36: f32;
    var t37: f32;
    var t38: f32;
    var t39: f32;
    var t40: f32;
    if (t35 < t18 * 0.015625) {
        let t41 = t30 - spherecap_lost(normal_z, t12, t29, unknown_zero);
        let t42 = t32 - spherecap_lost(normal_x, t13, t31, unknown_zero);
        let t43 = t34 - spherecap_lost(normal_y, t11, t33, unknown_zero);
        let t44 = fma(t41, t41, fma(t42, t42, t43 * t43));
        let t45 = 0.0 < t7;
        let t46 = t44 < t18 * 5.169879e-26;
        let t47 = abs(t11) < abs(t13);
        let t48 = select(-t12, 0.0, t47);
        let t49 = select(t11, -t13, t47);
        let t50 = select(0.0, t12, t47);
        let t51 = sqrt(fma(t48, t48, fma(t49, t49, t50 * t50)));
        let t52 = sqrt(t18);
        let t53 = t52 * t51;
        let t54 = sqrt(t44);
        up_x = select(normal_x, select(fma(t12, t50, -(t13 * t49)) / t53, normal_x, t45), t46);
        up_y = select(normal_y, select(fma(t13, t48, -(t11 * t50)) / t53, normal_y, t45), t46);
        up_z = select(normal_z, select(fma(t11, t49, -(t12 * t48)) / t53, normal_z, t45), t46);
        t36 = select(t41, t48, t46);
        t37 = select(t42, t49, t46);
        t38 = select(t43, t50, t46);
        t39 = select(t54, t51, t46);
        t40 = select(t54, select(t52, 0.0, t45), t46);
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
    let t55 = 0.0 < t7;
    let t56 = spherecap_keep(normal_x * t11, unknown_zero);
    let t57 = spherecap_keep(normal_y * t12, unknown_zero);
    let t58 = spherecap_keep(normal_z * t13, unknown_zero);
    let t59 = spherecap_keep(t56 + t57, unknown_zero);
    let t60 = spherecap_keep(t59 - t56, unknown_zero);
    let t61 = spherecap_keep(t56 - spherecap_keep(t59 - t60, unknown_zero), unknown_zero);
    let t62 = spherecap_keep(t59 + t58, unknown_zero);
    let t63 = spherecap_keep(t62 - t59, unknown_zero);
    let t64 = spherecap_keep(t59 - spherecap_keep(t62 - t63, unknown_zero), unknown_zero);
    let t65 = spherecap_lost(normal_x, t11, t56, unknown_zero) + spherecap_lost(normal_y, t12, t57, unknown_zero);
    let t66 = t61 + spherecap_keep(t57 - t60, unknown_zero) + (t64 + spherecap_keep(t58 - t63, unknown_zero));
    let t67 = t65 + spherecap_lost(normal_z, t13, t58, unknown_zero) + t66;
    let t68 = spherecap_keep(t62 + t67, unknown_zero);
    let t69 = spherecap_keep(t67 - spherecap_keep(t68 - t62, unknown_zero), unknown_zero);
    let t70 = t14 - t68 - t69;
    let t71 = t14 + t68 + t69;
    let t72 = t70 * t71;
    let t73 = sqrt(t18);
    let t74 = 1.0 / t73;
    let t75 = sqrt(t19);
    let elevation_sin = t68 * t74;
    let t76 = 0.0 < t19;
    let t77 = 0.0 < t72 && t55 && t76;
    let t78 = 0.0 < elevation_sin;
    var t79: f32;
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
    if (t77) {
        t79 = sqrt(t19 + t72);
        let t80 = sqrt(t72);
        let t81 = 1.0 / (t79 * t14);
        let t82 = t81 * t14;
        let t83 = t81 * t79;
        t_x = t75 * t82;
        t_y = t80 * t82;
        let t84 = t_y * t_y;
        kappa = abs(t68) * t83;
        cut = kappa * t_x;
        let t85 = t_x - 0.5;
        let t86 = cut - 0.5;
        let t87 = t85 * t85;
        let t88 = t86 * t86;
        let t89 = fma(0.05430631, t87, 0.080950715);
        let t90 = fma(t89, t87, 0.1684019);
        let t91 = fma(t90, t87, 0.32709444);
        let t92 = fma(t91, t87, 0.5987523);
        let t93 = fma(-0.026061837, t87, -0.06372378);
        let t94 = fma(t93, t87, -0.11762552);
        let t95 = fma(t94, t87, -0.23594604);
        let t96 = fma(t95, t87, -0.44721135);
        let t97 = fma(t96, t87, -0.7754678);
        shape = fma(t97, t85, fma(t92, t87, 0.94559944));
        let t98 = fma(t86, fma(fma(fma(fma(-0.026061837, t88, t93), t88, t94), t88, t95), t88, t96), fma(fma(fma(fma(0.05430631, t88, t89), t88, t90), t88, t91), t88, t92));
        shape_difference = fma(t98, t85 + t86, t97);
        norm = fma(cut, shape_difference, shape);
        width = t84 / (1.0 + t_x);
        tau = t80 * t83;
        area = t84 * t_y * (min(t71, t70) * t83) * norm;
    } else {
        t79 = t40;
    }
    let radius_sin = t14 * t74;
    let radius_cos = t75 * t74;
    let elevation_cos = t79 * t74;
    let t99 = abs(elevation_sin);
    let climb = radius_sin * elevation_cos;
    let rise = max(-(radius_cos * t99), t72 * (t74 * t74) / fma(radius_cos, t99, climb));
    let t100 = radius_sin * radius_sin;
    let t101 = select(area, fma(t100 * t99, 3.1415927, area), t78);
    let t102 = 9.8607613e-32 < t100;
    let towards_centre = vec3f(t11, t12, t13) * t74;
    let t103 = 1.0 / t39;
    let sideways = vec3f(t36, t37, t38) * t103;
    let on_surface = select(0.0, 1.0, t55);
    let distance = t73 * select(unscale, 1.0, t8);
    let projected_above = select(0.0, t101, 9.403955e-38 < t101 && t102 && t76);
    let t104 = 0.0 < projected_above;
    let t105 = select(0.0, 1.0 / projected_above, t104);
    let t106 = select(0.0, t105, t78);
    let t107 = t77 && t78 && 0.0 < t106;
    let t108 = t_y * t_y * t_y * shape * t106;
    let t109 = t_y / radius_sin;
    let t110 = t109 * t109 * t109 * (fma(cut - t_x, shape_difference, shape) * 0.53033006);
    var b_0 = 0.0;
    var b_1 = 0.0;
    var b_2 = 0.0;
    var b_3 = 0.0;
    var b_4 = 0.0;
    var b_5 = 0.0;
    var b_6 = 0.0;
    if (t77 && !t78) {
        let t111 = 1.0 + kappa;
        let t112 = t111 * shape;
        let t113 = 1.0 / (norm * t112);
        let t114 = sqrt(t113);
        b_0 = norm * t114;
        let t115 = 1.0 / (1.0 + cut);
        let t116 = (t_x + kappa) * t115 - 0.5;
        let t117 = t116 * t116 * t116;
        let t118 = fma(fma(fma(-0.026061837, t116, 0.05430631), t116, -0.06372378), t117, fma(fma(0.080950715, t116, -0.11762552), t116, 0.1684019));
        let t119 = fma(t118, t117, fma(fma(-0.23594604, t116, 0.32709444), t116, -0.44721135));
        let t120 = t111 * fma(t119, t117, fma(fma(0.5987523, t116, -0.7754678), t116, 0.94559944));
        let t121 = t120 * (t115 * t115 * t115) * (t112 * t113);
        let t122 = fma(t121, t112 * t114, -1.0);
        let t123 = 1.0 - t121;
        let t124 = fma(fma(30.011856, t122, fma(-41.541264, t123, -37.009792)), t122, fma(77.96775, t123, 7.470758));
        let t125 = fma(fma(fma(15.716111 * t123, t123, 9.961183), t123, -2.61785), t123, 0.8681748);
        let t126 = fma(fma(t124, t122, fma(fma(-49.13454, t123, -9.466533), t123, -1.5877596)), t122, t125);
        let t127 = t122 * t126;
        let t128 = fma(fma(7.295638, t122, -7.236236), t122, fma(-11.4868555 * t123 * t123, t123, 3.1255686));
        let t129 = fma(fma(fma(13.728438, t123, -7.981878), t123, 2.025724), t123, -0.7334958);
        let t130 = t122 * fma(t128, t122, t129);
        let t131 = fma(fma(-23.220068, t123, 7.332055), t122, fma(fma(9.986537, t123, 25.22195) * t123, t123, -2.9581387));
        let t132 = fma(fma(fma(-19.722994, t123, 4.6594768), t123, -0.89538246), t123, 0.5143498);
        let t133 = t122 * fma(t131, t122, t132);
        let t134 = fma(fma(fma(1.946617, t122, -3.077631), t122, 1.4945927), t122, -0.24140751);
        let t135 = t122 * t134;
        let t136 = t122 * fma(fma(0.38173297, t122, -0.30305624), t122, 0.05897375);
        b_1 = t121 - b_0 + t127;
        b_2 = t130 - t127;
        b_3 = t133 - t130;
        b_4 = t135 - t133;
        b_5 = t136 - t135;
        b_6 = -t136;
    }
    let t137 = select(defensive, 1.0, (0.0 < defensive || !(0.0 < on_surface)) && !t104);
    let t138 = 0.0 < t137;
    let t139 = select(0.0, t100 / (1.0 + radius_cos), 0.0 < radius_cos && t102);
    let density = select(0.0, t137 * select(0.0, 0.15915494 / t139, 0.0 < t139), t138);
    let density_above = t105 * (1.0 - t137);
    let t140 = 0.0 <= defensive && defensive <= 1.0 && t7 <= 2.0 && 0.0 < radius && distance <= 3.4028235e38 && 0.0 < density_above + 0.0 + density;
    return spherecap_front_light(
        t140, select(0.0, t139 * 6.2831855, t140), select(0.0, projected_above, t140), towards_centre,
        sideways, vec3f(normal_x, normal_y, normal_z), vec3f(up_x, up_y, up_z), on_surface, distance,
        radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, t137, defensive,
        density_above,
        vec3f(fma(sideways.y, up_z, -(sideways.z * up_y)), fma(sideways.z, up_x, -(sideways.x * up_z)), fma(sideways.x, up_y, -(sideways.y * up_x))),
        select(0.0, t139, t138), density, select(0.0, t108, t107), select(1.0, 1.0 / (1.0 - t108), t107),
        select(0.0, t110, t107), elevation_cos * radius_cos, radius_sin * t99, climb, b_0, b_1, b_2, b_3,
        b_4, b_5, b_6
    );
}

fn spherecap_front_sample(light: spherecap_front_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = abs(light.elevation_sin);
    let t2 = min(0.99999994, max(5.9604645e-8, u0));
    let t3 = min(0.99999994, max(5.9604645e-8, u1));
    let t4 = t2 < light.defensive;
    let t5 = select(t2 - light.defensive, t2, t4) / select(1.0 - light.defensive, light.defensive, t4);
    let t6 = select(t2, min(0.99999994, max(5.9604645e-8, t5)), 0.0 < light.requested);
    let t7 = !(0.0 < light.tau) || t4;
    let t8 = !(0.0 < light.elevation_sin) && !t7;
    let t9 = light.crescent_share <= t6 && !t8;
    let t10 = t7 || t9;
    let t11 = 1.0 - t3;
    let t12 = t3 - t11;
    let t13 = 4.0 * t3 * t11;
    let t14 = min(0.99999994, max(5.9604645e-8, (t6 - light.crescent_share) * light.inv_rest));
    let t15 = select(t14, t6, t7);
    let t16 = select(light.beyond, 0.0, t7);
    let t17 = 1.6660811 - t16;
    let t18 = fma(t15, t17, t16);
    let t19 = (1.0 - t15) * t17;
    var t21: f32;
    var t22: f32;
    var t23: f32;
    var t20 = 0.0;
    if (t10) {
        t21 = min(t19, t18);
        t22 = 1.0;
        t23 = 1.0;
    } else {
        let t24 = sqrt(t13);
        let t25 = fma(fma(fma(light.b_5, t13, light.b_3), t13, light.b_1), t24, fma(fma(fma(light.b_6, t13, light.b_4), t13, light.b_2), t13, light.b_0));
        let t26 = t24 * t25;
        let t27 = sqrt(fma(t12, t12, t26 * t26));
        let t28 = light.tau * t26;
        t23 = select(1.0, fma(t12, t12, t28 * t28), t8);
        let t29 = select(light.crescent_share, fma(light.kappa, t26, t27) * fma(light.cut, t26, t27), t8);
        let t30 = select(t6, light.width, t8) / t29;
        let t31 = select(light.width, t30, t8);
        let t32 = t23 * t31;
        let t33 = fma(fma(fma(-0.00060778117, t32, 1.0676054e-5), t32, -0.0027203285), t32 * t32 * t32, fma(fma(-0.011332183, t32, -0.10000902), t32, 1.0000001));
        t20 = select(t24, t28, t8);
        t21 = select(min(0.99999994, max(5.9604645e-8, t30)), t6, t8);
        t22 = t31 * t33;
    }
    let t34 = spherecap_float_of_bits(fma(spherecap_bits(t21), -0.33333334, 1419900500.0));
    let t35 = t21 * t34;
    let t36 = fma(-t35, t34 * t34, 1.0);
    let t37 = t36 * t36;
    let t38 = fma(fma(0.12666093, t37, fma(0.14565912, t36, 0.17283025)), t37, fma(0.22221696, t36, 0.33333334));
    let t39 = t22 * fma(t35 * t36, t38, t35);
    let t40 = t39 * t23;
    let t41 = t40 * t40 * t40;
    let t42 = fma(fma(fma(0.022114987, t40, -0.063446075), t40, 0.085662976), t41, fma(fma(-0.056249518, t40, 0.030445365), t40, 0.0074712755));
    let t43 = t39 * fma(t42, t41, fma(fma(0.03209764, t40, 0.09996679), t40, 1.0000004));
    let t44 = t23 * t43;
    let t45 = 2.0 - t44;
    let t46 = t43 * t45;
    let t47 = sqrt(t46);
    var zenith: f32;
    var side: f32;
    var cosine: f32;
    var t48: f32;
    var t49: f32;
    if (t10) {
        let t50 = select(t45, t44, t18 - t19 < 0.0);
        if (t4) {
            let t51 = light.height * (1.0 - t46 * t13);
            let t52 = sqrt(light.height * (2.0 - t51));
            zenith = (t50 - 1.0) * t52;
            let t53 = 1.0 - t51;
            t49 = fma(light.elevation_sin, t53, light.elevation_cos * zenith);
            t48 = fma(light.elevation_cos, t53, -(light.elevation_sin * zenith));
            side = t47 * t12 * t52;
            cosine = t49 * light.on_surface;
        } else {
            let t54 = 1.0 - t50;
            let t55 = light.radius_sin * light.radius_sin * t13;
            let t56 = max(0.0, fma(light.climb, t50, -light.rise));
            t49 = sqrt(fma(t46, t55, t56 * t56));
            let t57 = t1 * light.radius_cos;
            let t58 = light.climb * t54;
            zenith = fma(light.elevation_cos, fma(t58, t58 - 2.0 * t57, t46 * t55) / (t49 + t57), -(light.half_axis * t1 * t54));
            t48 = fma(light.half_axis, t54, light.middle);
            side = light.radius_sin * t47 * t12;
            cosine = t49;
        }
    } else {
        cosine = t47 * t20;
        t48 = 1.0 - t44;
        zenith = fma(light.elevation_cos, cosine, -(select(t1, -t1, t8) * t48));
        side = t47 * t12;
        t49 = cosine;
    }
    let t59 = fma(light.density_above, min(3.4028235e38, max(0.0, cosine)), light.density);
    let t60 = min(3.4028235e38, light.density / max(1.1754944e-38, min(3.4028235e38, abs(cosine))));
    let t61 = fma(zenith, zenith, side * side);
    let t62 = max(0.0, fma(light.radius_sin, light.radius_sin, -t61));
    let t63 = sqrt(t62);
    let t64 = sqrt(fma(light.radius_cos, light.radius_cos, t62));
    let t65 = light.radius_cos * light.radius_cos / (t64 + t63);
    let t66 = 1.0 / light.radius_sin;
    let t67 = t65 * t66;
    let t68 = -fma(t64, t63, t61) * t66;
    let t69 = t67 * zenith;
    let t70 = t67 * side;
    let t71 = fma(light.elevation_cos, t68, -(light.elevation_sin * t69));
    let t72 = fma(light.elevation_sin, t68, light.elevation_cos * t69);
    return spherecap_sample(
        light.third_axis * t48 + light.sideways * side + light.up * t49, t65 * light.distance,
        light.third_axis * t71 + light.sideways * t70 + light.up * t72, cosine, t59,
        min(3.4028235e38, select(0.0, light.density_above, 0.0 < cosine) + t60)
    );
}

fn spherecap_front_sample_once(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_front_sample(spherecap_front_prepare(normal, centre, radius, defensive), u0, u1);
}

fn spherecap_front_pdf_direction(light: spherecap_front_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = dot(light.towards_centre, direction) < 0.0;
    let t2 = select(dot(cross(light.towards_centre, light.sideways), direction), 1.0, t1);
    let t3 = select(dot(light.sideways, direction), 1.0, t1);
    let t4 = fma(light.density_above, min(3.4028235e38, max(0.0, dot(light.normal, direction))), light.density);
    let t5 = select(0.0, t4, fma(t2, t2, t3 * t3) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t6 = dot(direction, direction);
    return select(0.0, t5, 0.998001 <= t6 && t6 <= 1.002001);
}

fn spherecap_front_pdf_on_sphere(light: spherecap_front_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = fma(light.density_above, min(3.4028235e38, max(0.0, dot(light.normal, direction))), light.density);
    let t2 = dot(direction, direction);
    return select(0.0, t1, 0.998001 <= t2 && t2 <= 1.002001);
}

fn spherecap_front_importance(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, strength: f32) -> f32 {
    var t1: f32;
    var t2: f32;
    var t3: f32;
    if (abs(dot(normal, normal) - 1.0) <= 4.7683716e-7) {
        t1 = normal.x;
        t2 = normal.y;
        t3 = normal.z;
    } else {
        let t4 = min(8.5070587e37, max(1.1754944e-38, abs(normal.x) + abs(normal.y) + abs(normal.z)));
        let t5 = spherecap_power_of_two(t4);
        let t6 = normal.x / t5;
        let t7 = normal.y / t5;
        let t8 = normal.z / t5;
        let t9 = max(1.1754944e-38, sqrt(fma(t6, t6, fma(t7, t7, t8 * t8))));
        t1 = t6 / t9;
        t2 = t7 / t9;
        t3 = t8 / t9;
    }
    let t10 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    let t11 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    let unscale = spherecap_power_of_two(min(8.5070587e37, t11));
    let t12 = select(spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale)), 1.0, t10);
    let t13 = centre.x * t12;
    let t14 = centre.y * t12;
    let t15 = centre.z * t12;
    let t16 = radius * t12;
    let t17 = sqrt(fma(t13, t13, fma(t14, t14, t15 * t15)));
    let t18 = 1.0 / t17;
    let t19 = t16 * t18;
    let t20 = t19 * t19;
    let t21 = fma(t1, t1, fma(t2, t2, t3 * t3));
    let t22 = 0.0 <= defensive && defensive <= 1.0 && t21 <= 2.0 && 0.0 < radius && t17 * select(unscale, 1.0, t10) <= 3.4028235e38;
    let t23 = fma(t1, t13, fma(t2, t14, t3 * t15));
    let t24 = fma(t23, t18, 2.3841858e-7);
    let t25 = fma(t23 + t16, t18, 2.3841858e-7);
    let t26 = t25 * t25 / (fma(t19 - t24, max(0.0, fma(-t20, t20, 0.9999981)), t25) * 2.0);
    let t27 = select(select(0.0, t26, 0.0 < t25), t24, t19 <= t24);
    let t28 = select(fma(defensive, 0.5 - t27, t27), 1.0, t21 <= 0.0);
    let t29 = t20 <= 1.0000019 && 4.9303807e-32 < t20 && 0.0 < strength && t22 && strength <= 3.4028235e38;
    let t30 = select(0.0, min(3.4028235e38, max(1.1754944e-38, t20 * t28 * strength)), (0.0 < t28 || 0.0 < defensive) && t29);
    return t30;
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
    defensive: f32,
    requested: f32,
    above: f32,
    density_above: f32,
    density_below: f32,
    third_axis: vec3f,
    height: f32,
    density: f32,
    crescent_share: f32,
    inv_rest: f32,
    beyond: f32,
    middle: f32,
    half_axis: f32,
    climb: f32,
    b_0: f32,
    b_1: f32,
    b_2: f32,
    b_3: f32,
    b_4: f32,
    b_5: f32,
    b_6: f32,
}

fn spherecap_both_prepare(normal: vec3f, centre: vec3f, radius: f32, defensive: f32) -> spherecap_both_light {
    let unknown_zero = bitcast<u32>(radius) & 0x80000000u;
    var normal_x: f32;
    var normal_y: f32;
    var normal_z: f32;
    if (abs(dot(normal, normal) - 1.0) <= 4.7683716e-7) {
        normal_x = normal.x;
        normal_y = normal.y;
        normal_z = normal.z;
    } else {
        let t1 = min(8.5070587e37, max(1.1754944e-38, abs(normal.x) + abs(normal.y) + abs(normal.z)));
        let t2 = spherecap_power_of_two(t1);
        let t3 = normal.x / t2;
        let t4 = normal.y / t2;
        let t5 = normal.z / t2;
        let t6 = max(1.1754944e-38, sqrt(fma(t3, t3, fma(t4, t4, t5 * t5))));
        normal_x = t3 / t6;
        normal_y = t4 / t6;
        normal_z = t5 / t6;
    }
    let t7 = fma(normal_x, normal_x, fma(normal_y, normal_y, normal_z * normal_z));
    let t8 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    let t9 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    let unscale = spherecap_power_of_two(min(8.5070587e37, t9));
    let t10 = select(spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale)), 1.0, t8);
    let t11 = centre.x * t10;
    let t12 = centre.y * t10;
    let t13 = centre.z * t10;
    let t14 = radius * t10;
    let t15 = spherecap_keep(t13 * t13, unknown_zero);
    let t16 = fma(t11, t11, fma(t12, t12, t15));
    let t17 = fma(-t14, t14, t16);
    var t18: f32;
    var t19: f32;
    if (t17 < t16 * 0.25) {
        let t20 = spherecap_keep(t11 * t11, unknown_zero);
        let t21 = spherecap_keep(t12 * t12, unknown_zero);
        let t22 = spherecap_keep(t20 + t21, unknown_zero);
        let t23 = spherecap_keep(t22 - t20, unknown_zero);
        let t24 = spherecap_keep(t20 - spherecap_keep(t22 - t23, unknown_zero), unknown_zero);
        t18 = spherecap_keep(t22 + t15, unknown_zero);
        let t25 = spherecap_keep(t18 - t22, unknown_zero);
        let t26 = spherecap_keep(t22 - spherecap_keep(t18 - t25, unknown_zero), unknown_zero);
        let t27 = spherecap_lost(t11, t11, t20, unknown_zero) + spherecap_lost(t12, t12, t21, unknown_zero);
        let t28 = t24 + spherecap_keep(t21 - t23, unknown_zero) + (t26 + spherecap_keep(t15 - t25, unknown_zero));
        t19 = spherecap_fused(-t14, t14, t18, unknown_zero) + (t27 + spherecap_lost(t13, t13, t15, unknown_zero) + t28);
    } else {
        t18 = t16;
        t19 = t17;
    }
    let t29 = spherecap_keep(normal_z * t12, unknown_zero);
    let t30 = spherecap_fused(normal_y, t13, -t29, unknown_zero);
    let t31 = spherecap_keep(normal_x * t13, unknown_zero);
    let t32 = spherecap_fused(normal_z, t11, -t31, unknown_zero);
    let t33 = spherecap_keep(normal_y * t11, unknown_zero);
    let t34 = spherecap_fused(normal_x, t12, -t33, unknown_zero);
    let t35 = fma(t30, t30, fma(t32, t32, t34 * t34));
    var up_x: f32;
    var up_y: f32;
    var up_z: f32;
    var t36: f32;
    var t37: f32;
    var t38: f32;
    var t39: f32;
    var t40: f32;
    if (t35 < t18 * 0.015625) {
        let t41 = t30 - spherecap_lost(normal_z, t12, t29, unknown_zero);
        let t42 = t32 - spherecap_lost(normal_x, t13, t31, unknown_zero);
        let t43 = t34 - spherecap_lost(normal_y, t11, t33, unknown_zero);
        let t44 = fma(t41, t41, fma(t42, t42, t43 * t43));
        let t45 = 0.0 < t7;
        let t46 = t44 < t18 * 5.169879e-26;
        let t47 = abs(t11) < abs(t13);
        let t48 = select(-t12, 0.0, t47);
        let t49 = select(t11, -t13, t47);
        let t50 = select(0.0, t12, t47);
        let t51 = sqrt(fma(t48, t48, fma(t49, t49, t50 * t50)));
        let t52 = sqrt(t18);
        let t53 = t52 * t51;
        let t54 = sqrt(t44);
        up_x = select(normal_x, select(fma(t12, t50, -(t13 * t49)) / t53, normal_x, t45), t46);
        up_y = select(normal_y, select(fma(t13, t48, -(t11 * t50)) / t53, normal_y, t45), t46);
        up_z = select(normal_z, select(fma(t11, t49, -(t12 * t48)) / t53, normal_z, t45), t46);
        t36 = select(t41, t48, t46);
        t37 = select(t42, t49, t46);
        t38 = select(t43, t50, t46);
        t39 = select(t54, t51, t46);
        t40 = select(t54, select(t52, 0.0, t45), t46);
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
    let t55 = 0.0 < t7;
    let t56 = spherecap_keep(normal_x * t11, unknown_zero);
    let t57 = spherecap_keep(normal_y * t12, unknown_zero);
    let t58 = spherecap_keep(normal_z * t13, unknown_zero);
    let t59 = spherecap_keep(t56 + t57, unknown_zero);
    let t60 = spherecap_keep(t59 - t56, unknown_zero);
    let t61 = spherecap_keep(t56 - spherecap_keep(t59 - t60, unknown_zero), unknown_zero);
    let t62 = spherecap_keep(t59 + t58, unknown_zero);
    let t63 = spherecap_keep(t62 - t59, unknown_zero);
    let t64 = spherecap_keep(t59 - spherecap_keep(t62 - t63, unknown_zero), unknown_zero);
    let t65 = spherecap_lost(normal_x, t11, t56, unknown_zero) + spherecap_lost(normal_y, t12, t57, unknown_zero);
    let t66 = t61 + spherecap_keep(t57 - t60, unknown_zero) + (t64 + spherecap_keep(t58 - t63, unknown_zero));
    let t67 = t65 + spherecap_lost(normal_z, t13, t58, unknown_zero) + t66;
    let t68 = spherecap_keep(t62 + t67, unknown_zero);
    let t69 = spherecap_keep(t67 - spherecap_keep(t68 - t62, unknown_zero), unknown_zero);
    let t70 = t14 - t68 - t69;
    let t71 = t14 + t68 + t69;
    let t72 = t70 * t71;
    let t73 = sqrt(t18);
    let t74 = 1.0 / t73;
    let t75 = sqrt(t19);
    let elevation_sin = t68 * t74;
    let t76 = 0.0 < t19;
    let t77 = 0.0 < t72 && t55 && t76;
    let t78 = 0.0 < elevation_sin;
    var t79: f32;
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
    if (t77) {
        t79 = sqrt(t19 + t72);
        let t80 = sqrt(t72);
        let t81 = 1.0 / (t79 * t14);
        let t82 = t81 * t14;
        let t83 = t81 * t79;
        t_x = t75 * t82;
        t_y = t80 * t82;
        let t84 = t_y * t_y;
        kappa = abs(t68) * t83;
        cut = kappa * t_x;
        let t85 = t_x - 0.5;
        let t86 = cut - 0.5;
        let t87 = t85 * t85;
        let t88 = t86 * t86;
        let t89 = fma(0.05430631, t87, 0.080950715);
        let t90 = fma(t89, t87, 0.1684019);
        let t91 = fma(t90, t87, 0.32709444);
        let t92 = fma(t91, t87, 0.5987523);
        let t93 = fma(-0.026061837, t87, -0.06372378);
        let t94 = fma(t93, t87, -0.11762552);
        let t95 = fma(t94, t87, -0.23594604);
        let t96 = fma(t95, t87, -0.44721135);
        let t97 = fma(t96, t87, -0.7754678);
        shape = fma(t97, t85, fma(t92, t87, 0.94559944));
        let t98 = fma(t86, fma(fma(fma(fma(-0.026061837, t88, t93), t88, t94), t88, t95), t88, t96), fma(fma(fma(fma(0.05430631, t88, t89), t88, t90), t88, t91), t88, t92));
        shape_difference = fma(t98, t85 + t86, t97);
        norm = fma(cut, shape_difference, shape);
        width = t84 / (1.0 + t_x);
        tau = t80 * t83;
        area = t84 * t_y * (min(t71, t70) * t83) * norm;
    } else {
        t79 = t40;
    }
    let radius_sin = t14 * t74;
    let radius_cos = t75 * t74;
    let elevation_cos = t79 * t74;
    let t99 = abs(elevation_sin);
    let climb = radius_sin * elevation_cos;
    let rise = max(-(radius_cos * t99), t72 * (t74 * t74) / fma(radius_cos, t99, climb));
    let t100 = radius_sin * radius_sin;
    let t101 = fma(t100 * t99, 3.1415927, area);
    let t102 = select(area, t101, t78);
    let t103 = select(t101, area, t78);
    let t104 = 9.8607613e-32 < t100;
    let t105 = t104 && t76;
    let towards_centre = vec3f(t11, t12, t13) * t74;
    let t106 = 1.0 / t39;
    let sideways = vec3f(t36, t37, t38) * t106;
    let on_surface = select(0.0, 1.0, t55);
    let distance = t73 * select(unscale, 1.0, t8);
    let projected_above = select(0.0, t102, 9.403955e-38 < t102 && t105);
    let projected_below = select(0.0, t103, 9.403955e-38 < t103 && t105);
    let t107 = 0.0 < projected_above;
    let t108 = 0.0 < projected_below;
    let t109 = select(0.0, 1.0 / projected_above, t107);
    let t110 = select(0.0, 1.0 / projected_below, t108);
    let t111 = select(t110, t109, t78);
    let t112 = 0.0 < t111 && t77;
    let t113 = t_y * t_y * t_y * shape * t111;
    let t114 = t_y / radius_sin;
    let t115 = fma(cut - t_x, shape_difference, shape);
    var b_0 = 0.0;
    var b_1 = 0.0;
    var b_2 = 0.0;
    var b_3 = 0.0;
    var b_4 = 0.0;
    var b_5 = 0.0;
    var b_6 = 0.0;
    if (t77) {
        let t116 = 1.0 + kappa;
        let t117 = t116 * shape;
        let t118 = 1.0 / (norm * t117);
        let t119 = sqrt(t118);
        b_0 = norm * t119;
        let t120 = 1.0 / (1.0 + cut);
        let t121 = (t_x + kappa) * t120 - 0.5;
        let t122 = t121 * t121 * t121;
        let t123 = fma(fma(fma(-0.026061837, t121, 0.05430631), t121, -0.06372378), t122, fma(fma(0.080950715, t121, -0.11762552), t121, 0.1684019));
        let t124 = fma(t123, t122, fma(fma(-0.23594604, t121, 0.32709444), t121, -0.44721135));
        let t125 = t116 * fma(t124, t122, fma(fma(0.5987523, t121, -0.7754678), t121, 0.94559944));
        let t126 = t125 * (t120 * t120 * t120) * (t117 * t118);
        let t127 = fma(t126, t117 * t119, -1.0);
        let t128 = 1.0 - t126;
        let t129 = fma(fma(30.011856, t127, fma(-41.541264, t128, -37.009792)), t127, fma(77.96775, t128, 7.470758));
        let t130 = fma(fma(fma(15.716111 * t128, t128, 9.961183), t128, -2.61785), t128, 0.8681748);
        let t131 = fma(fma(t129, t127, fma(fma(-49.13454, t128, -9.466533), t128, -1.5877596)), t127, t130);
        let t132 = t127 * t131;
        let t133 = fma(fma(7.295638, t127, -7.236236), t127, fma(-11.4868555 * t128 * t128, t128, 3.1255686));
        let t134 = fma(fma(fma(13.728438, t128, -7.981878), t128, 2.025724), t128, -0.7334958);
        let t135 = t127 * fma(t133, t127, t134);
        let t136 = fma(fma(-23.220068, t128, 7.332055), t127, fma(fma(9.986537, t128, 25.22195) * t128, t128, -2.9581387));
        let t137 = fma(fma(fma(-19.722994, t128, 4.6594768), t128, -0.89538246), t128, 0.5143498);
        let t138 = t127 * fma(t136, t127, t137);
        let t139 = fma(fma(fma(1.946617, t127, -3.077631), t127, 1.4945927), t127, -0.24140751);
        let t140 = t127 * t139;
        let t141 = t127 * fma(fma(0.38173297, t127, -0.30305624), t127, 0.05897375);
        b_1 = t126 - b_0 + t132;
        b_2 = t135 - t132;
        b_3 = t138 - t135;
        b_4 = t140 - t138;
        b_5 = t141 - t140;
        b_6 = -t141;
    }
    let t142 = select(defensive, 1.0, !(t107 || t108) && (0.0 < defensive || !(0.0 < on_surface)));
    let t143 = 0.0 < t142;
    let t144 = select(0.0, t100 / (1.0 + radius_cos), 0.0 < radius_cos && t104);
    let density = select(0.0, t142 * select(0.0, 0.15915494 / t144, 0.0 < t144), t143);
    let t145 = 1.0 - t142;
    var t146 = 0.0;
    if (0.0 < tau) {
        let t147 = 1.0 / (elevation_cos * elevation_cos);
        let t148 = tau * tau;
        let t149 = t148 * t147 / (1.0 + t_x);
        let t150 = kappa - 0.5;
        let t151 = cut - 0.5;
        let t152 = t150 * t150;
        let t153 = t151 * t151;
        let t154 = fma(0.05430631, t152, 0.080950715);
        let t155 = fma(t154, t152, 0.1684019);
        let t156 = fma(t155, t152, 0.32709444);
        let t157 = fma(fma(fma(fma(0.05430631, t153, t154), t153, t155), t153, t156), t153, fma(t156, t152, 0.5987523));
        let t158 = fma(-0.026061837, t152, -0.06372378);
        let t159 = fma(t158, t152, -0.11762552);
        let t160 = fma(t159, t152, -0.23594604);
        let t161 = fma(t160, t152, -0.44721135);
        let t162 = fma(fma(fma(fma(-0.026061837, t153, t158), t153, t159), t153, t160), t153, t161);
        let t163 = fma(kappa * t149, fma(fma(t151, t162, t157), t150 + t151, fma(t161, t152, -0.7754678)), fma(t115, t149 - kappa * kappa, kappa) * t147);
        t146 = min(0.5, max(0.0, t148 * tau * (radius_cos + 1.0) * t163 * 0.31830987));
    }
    let t164 = 1.0 - t146;
    let t165 = 0.0 < t110;
    let t166 = 0.0 < t109;
    let above = select(1.0, select(0.0, select(t146, t164, t78), t166), t165);
    let density_above = t109 * above * t145;
    let density_below = t110 * select(1.0, select(0.0, select(t164, t146, t78), t165), t166) * t145;
    let t167 = distance <= 3.4028235e38 && 0.0 < density_above + density_below + density;
    let t168 = 0.0 <= defensive && defensive <= 1.0 && t7 <= 2.0 && 0.0 < radius && t167;
    return spherecap_both_light(
        t168, select(0.0, t144 * 6.2831855, t168), select(0.0, projected_above, t168), towards_centre,
        sideways, vec3f(normal_x, normal_y, normal_z), vec3f(up_x, up_y, up_z), on_surface, distance,
        radius_sin, radius_cos, elevation_sin, elevation_cos, tau, kappa, width, cut, rise, t142, defensive,
        above, density_above, density_below,
        vec3f(fma(sideways.y, up_z, -(sideways.z * up_y)), fma(sideways.z, up_x, -(sideways.x * up_z)), fma(sideways.x, up_y, -(sideways.y * up_x))),
        select(0.0, t144, t143), density, select(0.0, t113, t112), select(1.0, 1.0 / (1.0 - t113), t112),
        select(0.0, t114 * t114 * t114 * (t115 * 0.53033006), t112), elevation_cos * radius_cos,
        radius_sin * t99, climb, b_0, b_1, b_2, b_3, b_4, b_5, b_6
    );
}

fn spherecap_both_sample(light: spherecap_both_light, u0: f32, u1: f32) -> spherecap_sample {
    if (!light.is_sampled) {
        return spherecap_no_sample();
    }
    let t1 = 0.0 < light.elevation_sin;
    let t2 = abs(light.elevation_sin);
    let t3 = min(0.99999994, max(5.9604645e-8, u0));
    let t4 = min(0.99999994, max(5.9604645e-8, u1));
    let t5 = t3 < light.defensive;
    let t6 = select(t3 - light.defensive, t3, t5) / select(1.0 - light.defensive, light.defensive, t5);
    let t7 = select(t3, min(0.99999994, max(5.9604645e-8, t6)), 0.0 < light.requested);
    let t8 = t7 < light.above || t5;
    let t9 = select(t7 - light.above, t7, t8) / select(1.0 - light.above, light.above, t8);
    let t10 = t8 && t1;
    let t11 = !t8 && !t1;
    let t12 = select(min(0.99999994, max(5.9604645e-8, t9)), t7, t5);
    let t13 = !(0.0 < light.tau) || t5;
    let t14 = !(t10 || t11) && !t13;
    let t15 = light.crescent_share <= t12 && !t14;
    let t16 = t13 || t15;
    let t17 = 1.0 - t4;
    let t18 = t4 - t17;
    let t19 = 4.0 * t4 * t17;
    let t20 = min(0.99999994, max(5.9604645e-8, (t12 - light.crescent_share) * light.inv_rest));
    let t21 = select(t20, t12, t13);
    let t22 = select(light.beyond, 0.0, t13);
    let t23 = 1.6660811 - t22;
    let t24 = fma(t21, t23, t22);
    let t25 = (1.0 - t21) * t23;
    var t27: f32;
    var t28: f32;
    var t29: f32;
    var t26 = 0.0;
    if (t16) {
        t27 = min(t25, t24);
        t28 = 1.0;
        t29 = 1.0;
    } else {
        let t30 = sqrt(t19);
        let t31 = fma(fma(fma(light.b_5, t19, light.b_3), t19, light.b_1), t30, fma(fma(fma(light.b_6, t19, light.b_4), t19, light.b_2), t19, light.b_0));
        let t32 = t30 * t31;
        let t33 = sqrt(fma(t18, t18, t32 * t32));
        let t34 = light.tau * t32;
        t29 = select(1.0, fma(t18, t18, t34 * t34), t14);
        let t35 = select(light.crescent_share, fma(light.kappa, t32, t33) * fma(light.cut, t32, t33), t14);
        let t36 = select(t12, light.width, t14) / t35;
        let t37 = select(light.width, t36, t14);
        let t38 = t29 * t37;
        let t39 = fma(fma(fma(-0.00060778117, t38, 1.0676054e-5), t38, -0.0027203285), t38 * t38 * t38, fma(fma(-0.011332183, t38, -0.10000902), t38, 1.0000001));
        t26 = select(t30, t34, t14);
        t27 = select(min(0.99999994, max(5.9604645e-8, t36)), t12, t14);
        t28 = t37 * t39;
    }
    let t40 = spherecap_float_of_bits(fma(spherecap_bits(t27), -0.33333334, 1419900500.0));
    let t41 = t27 * t40;
    let t42 = fma(-t41, t40 * t40, 1.0);
    let t43 = t42 * t42;
    let t44 = fma(fma(0.12666093, t43, fma(0.14565912, t42, 0.17283025)), t43, fma(0.22221696, t42, 0.33333334));
    let t45 = t28 * fma(t41 * t42, t44, t41);
    let t46 = t45 * t29;
    let t47 = t46 * t46 * t46;
    let t48 = fma(fma(fma(0.022114987, t46, -0.063446075), t46, 0.085662976), t47, fma(fma(-0.056249518, t46, 0.030445365), t46, 0.0074712755));
    let t49 = t45 * fma(t48, t47, fma(fma(0.03209764, t46, 0.09996679), t46, 1.0000004));
    let t50 = t29 * t49;
    let t51 = 2.0 - t50;
    let t52 = t49 * t51;
    let t53 = sqrt(t52);
    var side: f32;
    var t54: f32;
    var t55: f32;
    var t56: f32;
    var t57: f32;
    if (t16) {
        let t58 = select(t51, t50, t24 - t25 < 0.0);
        if (t5) {
            let t59 = light.height * (1.0 - t52 * t19);
            let t60 = sqrt(light.height * (2.0 - t59));
            t56 = (t58 - 1.0) * t60;
            let t61 = 1.0 - t59;
            t55 = fma(light.elevation_sin, t61, light.elevation_cos * t56);
            t54 = fma(light.elevation_cos, t61, -(light.elevation_sin * t56));
            side = t53 * t18 * t60;
            t57 = t55 * light.on_surface;
        } else {
            let t62 = 1.0 - t58;
            let t63 = light.radius_sin * light.radius_sin * t19;
            let t64 = max(0.0, fma(light.climb, t58, -light.rise));
            t55 = sqrt(fma(t52, t63, t64 * t64));
            let t65 = t2 * light.radius_cos;
            let t66 = light.climb * t62;
            t56 = fma(light.elevation_cos, fma(t66, t66 - 2.0 * t65, t52 * t63) / (t55 + t65), -(light.half_axis * t2 * t62));
            t54 = fma(light.half_axis, t62, light.middle);
            side = light.radius_sin * t53 * t18;
            t57 = t55;
        }
    } else {
        t55 = t53 * t26;
        t54 = 1.0 - t50;
        side = t53 * t18;
        t56 = fma(light.elevation_cos, t55, -(select(t2, -t2, t14) * t54));
        t57 = t55;
    }
    let t67 = select(-1.0, 1.0, t8);
    let zenith = t56 * t67;
    let cosine = t57 * t67;
    let t68 = t55 * t67;
    let t69 = min(3.4028235e38, abs(cosine));
    let t70 = select(select(0.0, light.density_below, cosine < 0.0), light.density_above, 0.0 < cosine);
    let t71 = min(3.4028235e38, t70 + min(3.4028235e38, light.density / max(1.1754944e-38, t69)));
    let t72 = fma(zenith, zenith, side * side);
    let t73 = max(0.0, fma(light.radius_sin, light.radius_sin, -t72));
    let t74 = sqrt(t73);
    let t75 = sqrt(fma(light.radius_cos, light.radius_cos, t73));
    let t76 = light.radius_cos * light.radius_cos / (t75 + t74);
    let t77 = 1.0 / light.radius_sin;
    let t78 = t76 * t77;
    let t79 = -fma(t75, t74, t72) * t77;
    let t80 = t78 * zenith;
    let t81 = t78 * side;
    let t82 = fma(light.elevation_cos, t79, -(light.elevation_sin * t80));
    let t83 = fma(light.elevation_sin, t79, light.elevation_cos * t80);
    return spherecap_sample(
        light.third_axis * t54 + light.sideways * side + light.up * t68, t76 * light.distance,
        light.third_axis * t82 + light.sideways * t81 + light.up * t83, cosine, fma(t70, t69, light.density),
        t71
    );
}

fn spherecap_both_sample_once(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, u0: f32, u1: f32) -> spherecap_sample {
    return spherecap_both_sample(spherecap_both_prepare(normal, centre, radius, defensive), u0, u1);
}

fn spherecap_both_pdf_direction(light: spherecap_both_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = dot(light.normal, direction);
    let t2 = dot(light.towards_centre, direction) < 0.0;
    let t3 = select(dot(cross(light.towards_centre, light.sideways), direction), 1.0, t2);
    let t4 = select(dot(light.sideways, direction), 1.0, t2);
    let t5 = select(select(0.0, light.density_below, t1 < 0.0), light.density_above, 0.0 < t1);
    let t6 = select(0.0, fma(t5, min(3.4028235e38, abs(t1)), light.density), fma(t3, t3, t4 * t4) <= light.radius_sin * light.radius_sin * 1.0000019);
    let t7 = dot(direction, direction);
    return select(0.0, t6, 0.998001 <= t7 && t7 <= 1.002001);
}

fn spherecap_both_pdf_on_sphere(light: spherecap_both_light, direction: vec3f) -> f32 {
    if (!light.is_sampled) {
        return 0.0;
    }
    let t1 = dot(light.normal, direction);
    let t2 = select(select(0.0, light.density_below, t1 < 0.0), light.density_above, 0.0 < t1);
    let t3 = dot(direction, direction);
    let t4 = select(0.0, fma(t2, min(3.4028235e38, abs(t1)), light.density), 0.998001 <= t3 && t3 <= 1.002001);
    return t4;
}

fn spherecap_both_importance(normal: vec3f, centre: vec3f, radius: f32, defensive: f32, strength: f32) -> f32 {
    var t1: f32;
    var t2: f32;
    var t3: f32;
    if (abs(dot(normal, normal) - 1.0) <= 4.7683716e-7) {
        t1 = normal.x;
        t2 = normal.y;
        t3 = normal.z;
    } else {
        let t4 = min(8.5070587e37, max(1.1754944e-38, abs(normal.x) + abs(normal.y) + abs(normal.z)));
        let t5 = spherecap_power_of_two(t4);
        let t6 = normal.x / t5;
        let t7 = normal.y / t5;
        let t8 = normal.z / t5;
        let t9 = max(1.1754944e-38, sqrt(fma(t6, t6, fma(t7, t7, t8 * t8))));
        t1 = t6 / t9;
        t2 = t7 / t9;
        t3 = t8 / t9;
    }
    let t10 = dot(centre, centre) < 1099511600000.0 && 9.536743e-7 < radius;
    let t11 = max(1.1754944e-38, abs(centre.x) + abs(centre.y) + (abs(centre.z) + radius));
    let unscale = spherecap_power_of_two(min(8.5070587e37, t11));
    let t12 = select(spherecap_float_of_bits(2130706400.0 - spherecap_bits(unscale)), 1.0, t10);
    let t13 = centre.x * t12;
    let t14 = centre.y * t12;
    let t15 = centre.z * t12;
    let t16 = radius * t12;
    let t17 = sqrt(fma(t13, t13, fma(t14, t14, t15 * t15)));
    let t18 = 1.0 / t17;
    let t19 = t16 * t18;
    let t20 = t19 * t19;
    let t21 = fma(t1, t1, fma(t2, t2, t3 * t3));
    let t22 = 0.0 <= defensive && defensive <= 1.0 && t21 <= 2.0 && 0.0 < radius && t17 * select(unscale, 1.0, t10) <= 3.4028235e38;
    let t23 = fma(t1, t13, fma(t2, t14, t3 * t15));
    let t24 = max(0.0, fma(-t20, t20, 0.9999981));
    let t25 = fma(t23, t18, 2.3841858e-7);
    let t26 = fma(t23 + t16, t18, 2.3841858e-7);
    let t27 = select(select(0.0, t26 * t26 / (fma(t19 - t25, t24, t26) * 2.0), 0.0 < t26), t25, t19 <= t25);
    let t28 = fma(-t23, t18, 2.3841858e-7);
    let t29 = fma(-t23 + t16, t18, 2.3841858e-7);
    let t30 = select(select(0.0, t29 * t29 / (fma(t19 - t28, t24, t29) * 2.0), 0.0 < t29), t28, t19 <= t28);
    let t31 = t27 + t30;
    let t32 = select(fma(defensive, 0.5 - t31, t31), 1.0, t21 <= 0.0);
    let t33 = t20 <= 1.0000019 && 4.9303807e-32 < t20 && 0.0 < strength && t22 && strength <= 3.4028235e38;
    let t34 = select(0.0, min(3.4028235e38, max(1.1754944e-38, t20 * t32 * strength)), (0.0 < t32 || 0.0 < defensive) && t33);
    return t34;
}

