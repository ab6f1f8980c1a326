//! The fitted constants, made by `python -m fits`: do not edit.
//!
//! `fits/README.md` says how. All errors below are the worst ones on dense grids, of exact arithmetic with
//! the rounded coefficients: rounding in a polynomial's evaluation comes on top.

/// Polynomials for one precision; each has its coefficients in ascending order.
///
/// ```
/// use spherecap::{Fits, Lane};
///
/// let [single, double]: [Fits; 2] = [f32::FITS, f64::FITS];
/// assert!(single.shape.len() < double.shape.len());
/// ```
pub struct Fits {
    /// H(x) = (a - sin a cos a) / sin^3 a with a = acos x, for x in [0, 1], in powers of x - 1/2. Best in the
    /// relative error of d/dx (x H), which bounds the relative errors of H and of
    /// H(t) + e (H(t) - H(e)) / (t - e).
    pub shape: &'static [f64],
    /// A(h) = (segment(h) / c)^(2/3) / h with c = 4 sqrt(2) / 3, for h in [0, 1], in powers of h: the area of
    /// the segment of height h of the unit disk is c (h A)^(3/2). Best in the relative error.
    pub area: &'static [f64],
    /// P(k) = h / k, the inverse of k = h A(h), for h in [0, 1], in powers of k. Best in the relative error
    /// of the density of segments' heights h = k P(k) that samples with a uniform k^(3/2) have.
    pub height: &'static [f64],
    /// R(r) = ((1 - r)^(-1/3) - 1) / r, for |r| <= 0.1021, in powers of r. Best in the relative error of
    /// 1 + r R(r).
    pub root: &'static [f64],
}

/// For `f32`: each decimal is the shortest that reads as the number of that type that is meant.
///
/// Worst errors: shape 8.5e-08, area 1.6e-07, height 5.4e-07, root 5.0e-09.
pub const SINGLE: Fits = Fits {
    shape: &[
        0.94559944,
        -0.7754678,
        0.5987523,
        -0.44721135,
        0.32709444,
        -0.23594604,
        0.1684019,
        -0.11762552,
        0.080950715,
        -0.06372378,
        0.05430631,
        -0.026061837,
    ],
    area: &[1.0000001, -0.10000902, -0.011332183, -0.0027203285, 1.0676054e-05, -0.00060778117],
    height: &[
        1.0000004,
        0.09996679,
        0.03209764,
        0.0074712755,
        0.030445365,
        -0.056249518,
        0.085662976,
        -0.063446075,
        0.022114987,
    ],
    root: &[0.33333334, 0.22221696, 0.17283025, 0.14565912, 0.12666093],
};

/// For `f64`: each decimal is the shortest that reads as the number of that type that is meant.
///
/// Worst errors: shape 2.1e-16, area 8.1e-17, height 1.1e-15, root 5.0e-09.
pub const DOUBLE: Fits = Fits {
    shape: &[
        0.9455994348748603,
        -0.7754677969169461,
        0.5987525415548097,
        -0.4472165743226092,
        0.32709604110748736,
        -0.2358056586294262,
        0.1682078903720341,
        -0.11902592191657212,
        0.08369177912466698,
        -0.05854627571039895,
        0.04078317193934381,
        -0.02830884038269004,
        0.01959087685240964,
        -0.01352388356965382,
        0.009315053887943708,
        -0.006392935390702435,
        0.00437517117729457,
        -0.0030431798901942035,
        0.002141941666753702,
        -0.0013253641030483536,
        0.0007091485580555163,
        -0.0007187043687818459,
        0.0008419085289282981,
        -0.00039932090223657407,
    ],
    area: &[
        1.0,
        -0.09999999999997934,
        -0.01142857143048305,
        -0.002349206279191134,
        -0.0006098549870020215,
        -0.00018072289210263257,
        -5.8561059530116666e-05,
        -1.946719557054385e-05,
        -9.695678048559036e-06,
        4.087144642698942e-06,
        -1.5002038344451203e-05,
        2.0737304120485375e-05,
        -2.357933836393744e-05,
        1.8403035346526605e-05,
        -9.915418599370616e-06,
        3.2366851895509757e-06,
        -5.108519704758522e-07,
    ],
    height: &[
        1.0000000000000004,
        0.09999999999968957,
        0.03142857147157284,
        0.013063489486199845,
        0.006211300301912375,
        0.003197240551038453,
        0.0017642453656637523,
        0.0007038613473593918,
        0.0027310662684157027,
        -0.012596269614034813,
        0.060588253165065345,
        -0.22266741490341976,
        0.6552729569496492,
        -1.54286660549879,
        2.9122565568467365,
        -4.392768133906906,
        5.255874768506846,
        -4.922249883328695,
        3.5312305918854587,
        -1.8741696758889774,
        0.6937963401933932,
        -0.16010385576959557,
        0.01737424422258128,
    ],
    root: &[
        0.3333333438278878,
        0.22221696008117567,
        0.1728302464222366,
        0.14565913180067855,
        0.1266609277474087,
    ],
};

/// The marginal of a crescent, in both precisions: `CRESCENT[j][a][b]` is the coefficient of rho^a y^b in
/// beta_j, with V = sqrt(1 - u^2), which is u_bar in docs/mathematics.md, and
///
/// B(V) = B0 + (B1 - B0) V + rho V (1 - V) (sum over j of beta_j V^j), rho = B1 / B0 - 1, y = 1 - B1.
///
/// Best in the relative error of the density of the slices, for all crescents; worst error: 5.5e-06. It has
/// 36 terms; a zero stands for a term that is not used.
pub const CRESCENT: [&[&[f64]]; 5] = [
    &[
        &[0.86817479, -2.61784998, 9.96118257, 0.0, 15.71611156],
        &[-1.58775958, -9.46653311, -49.13454148],
        &[7.47075818, 77.96774846],
        &[-37.00979104, -41.54126262],
        &[30.01185618],
    ],
    &[
        &[-0.73349575, 2.02572394, -7.98187771, 13.72843796],
        &[3.12556858, 0.0, 0.0, -11.48685507],
        &[-7.23623589],
        &[7.29563804],
    ],
    &[
        &[0.5143498, -0.89538245, 4.65947688, -19.72299355],
        &[-2.95813874, 0.0, 25.22194997, 9.98653725],
        &[7.33205516, -23.22006885],
    ],
    &[&[-0.24140751], &[1.49459267], &[-3.07763089], &[1.94661705]],
    &[&[0.05897375], &[-0.30305625], &[0.38173297]],
];
