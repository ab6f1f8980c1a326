//! A sphere seen from a shading point: a spherical cap, cut by the horizon or not.
//!
//! Symbols in comments are those of Peters and Dachsbacher 2019 ("the paper"): the surface normal is z, the unit
//! direction to the sphere's centre is `w_d = (X, 0, Z)` with `X >= 0`, `s = r/d` (their `r_y`) and `v = sqrt(1 - s^2)`. The
//! boundary circle has its centre at `v w_d` and the extents `r_x = s Z`, `r_y = s`, `r_z = s X`; it meets the horizon at
//! `(t_x, +-t_y, 0)`.
//!
//! | case | condition | what is above the horizon |
//! |---|---|---|
//! | 1 | `Z >= s` | the whole cap |
//! | 2 | `0 < Z < s` | more than half: an ellipse and a crescent, when projected |
//! | 3 | `-s < Z <= 0` | less than half: a crescent |
//! | 4 | `Z <= -s` | nothing |
//!
//! Everything about the horizon hangs on `s^2 - Z^2 = (r - h)(r + h) / d^2` with the signed height `h = n.C` of the centre,
//! a compensated dot product; everything about nearness on `d^2 - r^2`, likewise. Lengths are first scaled by a power of
//! two near 1/d, so that no square over- or underflows.
//!
//! The crescent, projected, has the area `t_y^3 (1 - kappa) N` with `kappa = |Z|/s`. With H of `disk.rs`, the segment that
//! the chord `x = t_x` cuts off the unit disk has the area `t_y^3 H(t_x)`, and the one it cuts off the ellipse
//! `s^2 |Z| (t_y/s)^3 H(e) = kappa t_y^3 H(e)` with `e = kappa t_x`. Their difference is
//! `t_y^3 (H(t) - kappa H(e)) = t_y^3 (1 - kappa) (H(t) + e H[t, e])`, where the divided difference `H[t, e]` takes the place
//! of the cancellation. Measured against 25-digit values: see `tests/reference.rs`.

use crate::compensated::{dot, product};
use crate::disk::shape_and_difference;
use crate::lane::{branch, lit, Blend, Lane, Only};
use crate::math::power_of_two_near_reciprocal;
use crate::vec3::Vec3;
use core::f64::consts::PI;

/// A sphere as seen from a point on a surface: the geometry that every technique shares.
///
/// Lanes where the point is inside the sphere, where nothing is above the horizon, or where the sphere looks smaller than
/// this precision can weigh, have the areas 0.
///
/// ```
/// use spherecap::Cap;
///
/// // A sphere of radius 1 with its centre on the horizon, at a distance of 2.
/// let cap = Cap::<f64>::new([0.0, 0.0, 1.0], [2.0, 0.0, 0.0], 1.0);
/// assert!((cap.distance() - 2.0).abs() < 1e-15 && (cap.radius_sin() - 0.5).abs() < 1e-15);
/// assert_eq!(cap.elevation_sin(), 0.0);
/// assert!(!cap.is_inside());
/// // Half of it is above the horizon, which says nothing about its projection.
/// assert!(cap.projected_solid_angle() < 0.5 * cap.solid_angle());
/// ```
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Cap<L> {
    /// Unit vectors: towards the centre; across it, towards the zenith; sideways. A right-handed frame.
    pub(crate) frame: [Vec3<L>; 3],
    /// The surface's normal.
    pub(crate) normal: Vec3<L>,
    /// Distance to the centre, in the caller's unit of length.
    pub(crate) distance: L,
    /// `s = r/d`, the sine of the cap's angular radius, in (0, 1).
    pub(crate) radius_sin: L,
    /// `1/s`.
    pub(crate) inv_radius_sin: L,
    /// `v`, its cosine.
    pub(crate) radius_cos: L,
    /// `Z`, the sine of the centre's elevation above the horizon (its cosine with the normal), in [-1, 1].
    pub(crate) elevation_sin: L,
    /// `X`, the cosine of the elevation, in [0, 1]. Both are 0 without a surface.
    pub(crate) elevation_cos: L,
    /// Solid angle of the whole cap, in steradians, and its reciprocal; both 0 where nothing is visible.
    pub(crate) solid_angle: L,
    pub(crate) inv_solid_angle: L,
    /// What the horizon cuts off.
    pub(crate) crescent: Crescent<L>,
    /// `(s^2 - Z^2) / (s X + v |Z|)`: how far the crescent rises above (or hangs below) the horizon, `c_z + r_z` in case 3.
    /// Negative without a cut: then its magnitude is how far the cap's nearer end is from the horizon.
    pub(crate) rise: L,
    /// Projected solid angles of the parts above and below the horizon, in steradians.
    pub(crate) projected_above: L,
    pub(crate) projected_below: L,
}

/// The part of a cut cap on the side of the horizon where its centre is not. In cases 1 and 4 `tau` and `area` are zero, and the
/// rest is anything.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct Crescent<L> {
    /// `kappa = |Z|/s` in [0, 1).
    pub kappa: L,
    /// `sqrt(1 - kappa^2)`.
    pub tau: L,
    /// `t_x` and `t_y`: where boundary and horizon meet.
    pub t_x: L,
    pub t_y: L,
    /// `1 - t_x`.
    pub width: L,
    /// `1 / (1 + e)`.
    pub inv_cut_1: L,
    /// `e = kappa t_x = |c_z| / r_z`: where the horizon cuts the ellipse, relative to its half axis.
    pub cut: L,
    /// `H(t_x)` and `H(e)`.
    pub shape: L,
    pub shape_cut: L,
    /// `N`, in [4/15, pi/2].
    pub norm: L,
    /// Its projected solid angle.
    pub area: L,
}

impl<L: Lane> Crescent<L> {
    /// `t_y^3`: every area is this times something of order one.
    #[inline(always)]
    pub(crate) fn t_y_cubed(&self) -> L {
        self.t_y * self.t_y * self.t_y
    }
}

impl<L: Lane> Cap<L> {
    /// The cap of the sphere with this `centre` (relative to the shading point) and `radius` (same unit of length) above
    /// the surface with this `normal`.
    ///
    /// The normal must be of unit length to single precision, or exactly zero for a point that is on no surface. It is used
    /// as it stands: a cosine is a dot product with it. Total: lanes with other input give a cap with areas 0 or NaN.
    ///
    /// ```
    /// # use spherecap::Cap;
    /// assert_eq!(Cap::<f32>::new([0.0, 0.0, 1.0], [0.0, 0.0, -2.0], 1.0).projected_solid_angle(), 0.0);
    /// ```
    #[inline(always)]
    pub fn new(normal: impl Into<[L; 3]>, centre: impl Into<[L; 3]>, radius: L) -> Self {
        let (normal, centre) = (Vec3::from(normal.into()), Vec3::from(centre.into()));
        let size = (centre.x.abs() + centre.y.abs()) + (centre.z.abs() + radius);
        let [scale, unscale] = power_of_two_near_reciprocal(size);
        let (c, r) = (centre * scale, radius * scale);

        let d2 = dot(c, c);
        let r2 = product(r, r);
        // d^2 - r^2, positive outside the sphere.
        let gap = (d2.hi - r2.hi) + (d2.lo - r2.lo);
        let outside = L::lit(0.0).lt(gap);
        let d = d2.hi.sqrt();
        let inv_d = lit(1.0) / d;

        let height = dot(normal, c).normalised();
        let (r_minus_h, r_plus_h) = ((r - height.hi) - height.lo, (r + height.hi) + height.lo);
        // (s^2 - Z^2) d^2, positive where the horizon cuts the sphere.
        let q = r_minus_h * r_plus_h;
        let is_cut = L::lit(0.0).lt(q) & outside & is_on_surface(normal);

        // |n x C| is X d. Where it (nearly) vanishes, at the zenith, any frame does: below 2^-51 in f32, X matters to
        // nothing, and above, its square is far from underflow and the vector as precise as the input.
        let sideways = normal.cross(c);
        let sideways2 = sideways.dot(sideways);
        let has_side = L::lit(L::MIN_POSITIVE / L::EPSILON).lt(sideways2);
        let (side, side2) = branch!(has_side, (sideways, sideways2), {
            let side = Vec3::blend(
                c.x.abs().lt(c.z.abs()),
                Vec3::new(L::lit(0.0), -c.z, c.y),
                Vec3::new(-c.y, c.x, L::lit(0.0)),
            );
            (side, side.dot(side))
        });

        let gap_root = gap.max(L::lit(0.0)).sqrt();
        let v = gap_root * inv_d;
        // One division for two.
        let v_1 = lit(1.0) + v;
        let inv_r_v_1 = lit(1.0) / (r * v_1);
        let inv_r = inv_r_v_1 * v_1;

        let (s, inv_s) = (r * inv_d, d * inv_r);
        // (X d)^2 = d^2 - h^2 is the sum of two positives where the horizon cuts, and the vector product elsewhere.
        let Only(cut_x_d) = branch!(is_cut, Only((gap + q).sqrt()), Blend::blank());
        let side_length = side2.sqrt();
        let x_d = branch!(is_cut, cut_x_d, L::select(has_side, side_length, L::lit(0.0)));
        let elevation_sin = height.hi * inv_d;
        let elevation_cos = x_d * inv_d;
        let z = elevation_sin.abs();
        // Once more, kept far from underflow by a bound that matters to no visible sphere (below).
        let s_x = s * elevation_cos;
        let extent = v.fma(z, s_x).max(L::lit(L::MIN_POSITIVE / L::EPSILON));
        let inv_product = lit(1.0) / (extent * side_length);
        let inv_extent = inv_product * side_length;
        // At most `v |Z|` from the horizon, which a normal longer than 1 by a rounding would deny next to the sphere.
        let rise = (q * (inv_d * inv_d) * inv_extent).max(-(v * z));

        let side = side * (inv_product * extent);
        let towards_centre = c * inv_d;
        let frame = [towards_centre, towards_centre.cross_of_perpendicular(side), side];

        let (tau, area, Only([kappa, t_x, t_y, width, inv_cut_1, cut, shape, shape_cut, norm])) = branch!(
            is_cut,
            {
                let q_root = q.sqrt();
                // 1 / (X^2 (1 + t_x)), over d^2: one division for two.
                let x_d_1 = cut_x_d + gap_root;
                let inv_both = lit(1.0) / (cut_x_d * x_d_1);
                let inv_x_d = inv_both * x_d_1;
                let (t_x, t_y) = (gap_root * inv_x_d, q_root * inv_x_d);
                let kappa = height.hi.abs() * inv_r;
                let cut = kappa * t_x;
                let (shape, difference) = shape_and_difference(t_x, cut);
                let shape_cut = (cut - t_x).fma(difference, shape);
                let norm = cut.fma(difference, shape);
                let area = t_y * t_y * t_y * (r_minus_h.min(r_plus_h) * inv_r) * norm;
                let rest = [kappa, t_x, t_y, q * inv_both, s_x * inv_extent, cut, shape, shape_cut, norm];
                (q_root * inv_r, area, Only(rest))
            },
            Blend::blank()
        );
        let crescent = Crescent { kappa, tau, t_x, t_y, width, inv_cut_1, cut, shape, shape_cut, norm, area };

        // The whole cap, projected, is an ellipse with half axes s and s |Z|.
        let s2 = s * s;
        let ellipse_area = s2 * z * lit(PI);
        let larger = ellipse_area + area;
        let sets = elevation_sin.lt(L::lit(0.0));
        let above = L::select(sets, area, larger);
        let below = L::select(sets, larger, area);
        // 2 pi (1 - v), with 1 - v = s^2 / (1 + v).
        let solid_angle = s2 * (inv_r_v_1 * r) * lit(2.0 * PI);
        let inv_solid_angle = v_1 * (inv_s * inv_s) * lit(0.5 / PI);
        // A sphere that looks so small that differences of its s^2 underflow (s < 3e-16 in f32) lights nothing; nor does a
        // part of it whose density would overflow (an area below about 1e-37).
        let is_visible = outside & L::lit(L::MIN_POSITIVE / L::EPSILON).lt(s2);
        let smallest = L::lit(8.0 * L::MIN_POSITIVE);
        Self {
            frame,
            normal,
            distance: d * unscale,
            radius_sin: s,
            inv_radius_sin: inv_s,
            radius_cos: v,
            elevation_sin,
            elevation_cos,
            solid_angle: L::select(is_visible, solid_angle, L::lit(0.0)),
            inv_solid_angle: L::select(is_visible, inv_solid_angle, L::lit(0.0)),
            crescent,
            rise,
            projected_above: L::select(smallest.lt(above) & is_visible, above, L::lit(0.0)),
            projected_below: L::select(smallest.lt(below) & is_visible, below, L::lit(0.0)),
        }
    }

    /// Solid angle of the whole cap, the part below the horizon included, in steradians, in (0, 2 pi] (to
    /// rounding). 0 for a point inside the sphere.
    ///
    /// ```
    /// # use spherecap::Cap;
    /// # use std::f64::consts::PI;
    /// let cap = Cap::<f64>::new([0.0, 0.0, 1.0], [0.0, 0.0, 5.0], 3.0);
    /// let cosine = 0.8; // of its angular radius, whose sine is 3/5
    /// assert!((cap.solid_angle() - 2.0 * PI * (1.0 - cosine)).abs() < 1e-14);
    /// ```
    #[inline(always)]
    pub fn solid_angle(&self) -> L {
        self.solid_angle
    }

    /// Projected solid angle of the cap above the horizon, in steradians, in [0, pi] (to rounding).
    ///
    /// ```
    /// # use spherecap::Cap;
    /// # use std::f64::consts::PI;
    /// // At the zenith: a disk of radius s = 3/5.
    /// let cap = Cap::<f64>::new([0.0, 0.0, 1.0], [0.0, 0.0, 5.0], 3.0);
    /// assert!((cap.projected_solid_angle() - 0.36 * PI).abs() < 1e-14);
    /// ```
    #[inline(always)]
    pub fn projected_solid_angle(&self) -> L {
        self.projected_above
    }

    /// Distance to the sphere's centre, in the caller's unit of length.
    #[inline(always)]
    pub fn distance(&self) -> L {
        self.distance
    }

    /// Sine of the cap's angular radius: the sphere's radius over its centre's distance.
    #[inline(always)]
    pub fn radius_sin(&self) -> L {
        self.radius_sin
    }

    /// Sine of the elevation of the sphere's centre above the horizon, its cosine with the normal; 0 without a surface.
    #[inline(always)]
    pub fn elevation_sin(&self) -> L {
        self.elevation_sin
    }

    /// Whether the point is inside or on the sphere.
    #[inline(always)]
    pub fn is_inside(&self) -> L::Mask {
        !L::lit(0.0).lt(self.radius_cos)
    }

    /// Whether the point is on a surface: whether it has a normal.
    #[inline(always)]
    pub(crate) fn is_on_surface(&self) -> L::Mask {
        is_on_surface(self.normal)
    }

    /// `|Z|`.
    #[inline(always)]
    pub(crate) fn elevation(&self) -> L {
        self.elevation_sin.abs()
    }
}

#[inline(always)]
fn is_on_surface<L: Lane>(normal: Vec3<L>) -> L::Mask {
    L::lit(0.0).lt(normal.dot(normal))
}

impl<M: Copy, L: Blend<M>, const N: usize> Blend<M> for [L; N] {
    #[inline(always)]
    fn blank() -> Self {
        [L::blank(); N]
    }
    #[inline(always)]
    fn blend(mask: M, yes: Self, no: Self) -> Self {
        // Not by a closure, which might not be inlined; see `lane.rs`.
        let mut blended = yes;
        for (blended, no) in blended.iter_mut().zip(&no) {
            *blended = L::blend(mask, *blended, *no);
        }
        blended
    }
}
