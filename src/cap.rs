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
//! Everything about the horizon hangs on `s^2 - Z^2 = (r - z_C)(r + z_C) / d^2` with the signed height `z_C = n.C` of the centre,
//! a compensated dot product; everything about nearness on `d^2 - r^2`, likewise where it is small. Extreme lengths
//! are first scaled by a power of two near 1/d, so that no square over- or underflows.
//!
//! A cap is made in four steps: `sphere.rs` (scaled lengths), `frame.rs`, `horizon.rs`, `crescent.rs`.

mod crescent;
mod frame;
mod horizon;
mod share;
mod sphere;

use crate::lane::{branch, broadcast_fields, lit, Lane};
use crate::strategy::{Hemispheres, Strategy, Technique};
use crate::vec3::Vec3;
use core::f64::consts::PI;
use crescent::Areas;
use frame::Frame;
use horizon::Horizon;
use sphere::Sphere;

pub(crate) use crescent::{Crescent, Cut};
pub(crate) use sphere::Lengths;

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
    /// Unit vectors: towards the centre; sideways, across it and the normal.
    pub(crate) towards_centre: Vec3<L>,
    pub(crate) sideways: Vec3<L>,
    /// The surface's normal, or zero; and, without a surface, any unit vector perpendicular to the others.
    pub(crate) normal: Vec3<L>,
    pub(crate) up: Vec3<L>,
    /// 1, or 0 without a surface.
    pub(crate) on_surface: L,
    /// Distance to the centre, in the caller's unit of length.
    pub(crate) distance: L,
    /// `s = r/d`, the sine of the cap's angular radius, in (0, 1).
    pub(crate) radius_sin: L,
    /// `v`, its cosine; not positive, or NaN, inside the sphere.
    pub(crate) radius_cos: L,
    /// `Z`, the sine of the centre's elevation above the horizon (its cosine with the normal), in [-1, 1]. 0 without a surface.
    pub(crate) elevation_sin: L,
    /// `X`, the cosine of the elevation, in [0, 1]. 1 without a surface.
    pub(crate) elevation_cos: L,
    /// What the horizon cuts off.
    pub(crate) crescent: Crescent<L>,
    /// `s X - v |Z| = (s^2 - Z^2) / (s X + v |Z|)`: how far the crescent rises above (or hangs below) the horizon, `c_z + r_z` in
    /// case 3. Negative without a cut: then its magnitude is how far the cap's nearer end is from the horizon.
    pub(crate) rise: L,
    /// Projected solid angles of the parts above and below the horizon, in steradians.
    pub(crate) projected_above: L,
    pub(crate) projected_below: L,
}

broadcast_fields!(Cap {
    towards_centre,
    sideways,
    normal,
    up,
    on_surface,
    distance,
    radius_sin,
    radius_cos,
    elevation_sin,
    elevation_cos,
    crescent,
    rise,
    projected_above,
    projected_below
});

/// What is known of a cap before the horizon cuts it.
#[derive(Clone, Copy)]
pub(crate) struct View<L: Lane> {
    normal: Vec3<L>,
    on_surface: L::Mask,
    sphere: Sphere<L>,
    frame: Frame<L>,
    horizon: Horizon<L>,
    /// `d`, its reciprocal, and `v d`.
    d: L,
    inv_d: L,
    v_d: L,
    /// `Z`.
    elevation_sin: L,
}

impl<L: Lane> View<L> {
    /// The first three steps; the arguments are those of [`Cap::new`].
    #[inline(always)]
    pub(crate) fn new(normal: Vec3<L>, centre: Vec3<L>, radius: L) -> Self {
        let sphere = Sphere::new(centre, radius);
        let frame = Frame::new(normal, &sphere);
        // Who does not fork may not need the frame otherwise.
        let on_surface = if L::FORKS { frame.on_surface } else { normal.dot(normal) };
        let on_surface = L::lit(0.0).lt(on_surface);
        let horizon = Horizon::new(normal, &sphere);
        let d = sphere.distance2.sqrt();
        let inv_d = lit(1.0) / d;
        let (v_d, elevation_sin) = (sphere.gap.sqrt(), horizon.height * inv_d);
        Self { normal, on_surface, sphere, frame, horizon, d, inv_d, v_d, elevation_sin }
    }

    /// Which case it is: [`Cap::case`] will say the same.
    #[inline(always)]
    pub(crate) fn case(&self) -> Case<L::Mask> {
        let zero = L::lit(0.0);
        let is_outside = zero.lt(self.sphere.gap);
        let is_cut = zero.lt(self.horizon.circle2) & self.on_surface & is_outside;
        Case { is_cut, is_centre_above: zero.lt(self.elevation_sin) }
    }

    /// What it cuts off, where it does: `(X d)^2 = d^2 - h^2` is the sum of two positives there.
    #[inline(always)]
    pub(crate) fn cut(&self) -> Cut<L> {
        let x_d = (self.sphere.gap + self.horizon.circle2).sqrt();
        Cut::new(&self.sphere, &self.horizon, self.v_d, x_d)
    }

    /// The same elsewhere.
    #[inline(always)]
    pub(crate) fn uncut(&self) -> Cut<L> {
        Cut::none(self.frame.x_d)
    }
}

/// What the horizon does to a cap, for whoever decides by it.
#[derive(Clone, Copy)]
pub(crate) struct Case<M> {
    /// Whether it cuts the cap: cases 2 and 3.
    pub is_cut: M,
    /// Whether the centre is above it.
    pub is_centre_above: M,
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
        let view = View::new(normal.into().into(), centre.into().into(), radius);
        let case = view.case();
        let cut = branch!(case.is_cut, view.cut(), view.uncut());
        Self::of(view, case, &cut)
    }

    /// The last step: all in units of the distance, and the areas.
    #[inline(always)]
    pub(crate) fn of(view: View<L>, case: Case<L::Mask>, cut: &Cut<L>) -> Self {
        let Cut { crescent, areas: Areas { area, .. }, x_d } = *cut;
        let View { normal, on_surface, sphere, frame, horizon, d, inv_d, v_d, elevation_sin } = view;
        let Sphere { lengths: Lengths { centre, radius, unit }, gap, .. } = sphere;
        let (s, v, elevation_cos) = (radius * inv_d, v_d * inv_d, x_d * inv_d);
        let z = elevation_sin.abs();
        // At most `v |Z|` from the horizon, which a normal longer than 1 by a rounding would deny next to the sphere.
        let rise = (horizon.circle2 * (inv_d * inv_d) / v.fma(z, s * elevation_cos)).max(-(v * z));

        // The whole cap, projected, is an ellipse with half axes s and s |Z|.
        let s2 = s * s;
        let larger = (s2 * z).fma(L::lit(PI), area.named("area"));
        let above = L::select(case.is_centre_above, larger, area);
        let below = L::select(case.is_centre_above, area, larger);
        // A part whose density would overflow (an area below about 1e-37) lights nothing.
        let is_visible = is_visible(s2, gap);
        let smallest = L::lit(8.0 * L::MIN_POSITIVE);
        Self {
            towards_centre: centre * inv_d,
            sideways: frame.sideways * (lit(1.0) / frame.length),
            normal,
            up: frame.up,
            on_surface: L::select(on_surface, L::lit(1.0), L::lit(0.0)),
            distance: d * unit,
            radius_sin: s,
            radius_cos: v,
            elevation_sin,
            elevation_cos,
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
        self.height() * lit(2.0 * PI)
    }

    /// `1 - v = s^2 / (1 + v)`: the cap's height; 0 where nothing is visible.
    #[inline(always)]
    pub(crate) fn height(&self) -> L {
        let s2 = self.radius_sin * self.radius_sin;
        let is_visible = is_visible(s2, self.radius_cos);
        L::select(is_visible, s2 / (lit(1.0) + self.radius_cos), L::lit(0.0))
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
        L::lit(0.0).lt(self.on_surface)
    }

    /// `s X + v |Z|`: how far the cap's other end is from the horizon.
    #[inline(always)]
    pub(crate) fn depth(&self) -> L {
        self.radius_sin.fma(self.elevation_cos, self.radius_cos * self.elevation())
    }

    /// Which case this is.
    #[inline(always)]
    pub(crate) fn case(&self) -> Case<L::Mask> {
        Case { is_cut: self.crescent.exists(), is_centre_above: L::lit(0.0).lt(self.elevation_sin) }
    }

    /// Whether this strategy samples the cap by nothing but solid angles: by that technique always. With nothing for a projected one to
    /// sample, a defensive sampler still covers the whole cap, for a shading normal may see what the geometric one does not; so does
    /// every sampler without a surface, where no cosine exists.
    #[inline(always)]
    pub(crate) fn has_solid_angle_alone(&self, strategy: &Strategy<L>) -> L::Mask {
        let zero = L::lit(0.0);
        let is_seen = match strategy {
            Strategy { technique: Technique::SolidAngle, .. } => return zero.le(zero),
            Strategy { hemispheres: Hemispheres::Front, .. } => zero.lt(self.projected_above),
            Strategy { hemispheres: Hemispheres::Both, .. } => {
                zero.lt(self.projected_above) | zero.lt(self.projected_below)
            }
        };
        !is_seen & (zero.lt(strategy.defensive) | !self.is_on_surface())
    }

    /// `|Z|`.
    #[inline(always)]
    pub(crate) fn elevation(&self) -> L {
        self.elevation_sin.abs()
    }
}

/// Whether there is a sphere outside the point (`gap` is positive) that does not look so small that differences of its `s^2`
/// underflow (s < 3e-16 in f32).
#[inline(always)]
fn is_visible<L: Lane>(s2: L, gap: L) -> L::Mask {
    L::lit(L::MIN_POSITIVE / L::EPSILON).lt(s2) & L::lit(0.0).lt(gap)
}
