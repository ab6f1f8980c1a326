//! Fourth step: the part of a cut cap on the side of the horizon where its centre is not.
//!
//! Projected it has the area `t_y^3 (1 - kappa) N` with `kappa = |Z|/s`. With H of `disk.rs`, the segment that
//! the chord `x = t_x` cuts off the unit disk has the area `t_y^3 H(t_x)`, and the one it cuts off the ellipse
//! `s^2 |Z| (t_y/s)^3 H(e) = kappa t_y^3 H(e)` with `e = kappa t_x`. Their difference is
//! `t_y^3 (H(t_x) - kappa H(e)) = t_y^3 (1 - kappa) N` with `N = H(t_x) + e H[t_x, e]`, where the divided difference takes the
//! place of the cancellation (docs/mathematics.md, section 3). Measured against 25-digit values: see `tests/kernels/reference.rs`.

use super::horizon::Horizon;
use super::sphere::Sphere;
use crate::disk::shape_and_difference;
use crate::lane::{blend_fields, broadcast_fields, lit, Lane};

/// The crescent. In cases 1 and 4 `tau` is zero, and the other fields are unspecified.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct Crescent<L> {
    /// `tau = sqrt(1 - kappa^2)`.
    pub tau: L,
    /// `kappa = |Z|/s` in [0, 1).
    pub kappa: L,
    /// `t_x` and `t_y`: where boundary and horizon meet.
    pub t_x: L,
    pub t_y: L,
    /// `1 - t_x`.
    pub width: L,
    /// `e = kappa t_x = |c_z| / r_z`: where the horizon cuts the ellipse, relative to its half axis.
    pub cut: L,
}
blend_fields!(Crescent { tau; only kappa, t_x, t_y, width, cut });
broadcast_fields!(Crescent { tau, kappa, t_x, t_y, width, cut });

/// The areas at the chord: a sampler is made of them, and has no use for them afterwards. Without a crescent `area` is zero, and the
/// other fields are unspecified.
#[derive(Clone, Copy)]
pub(crate) struct Areas<L> {
    /// The crescent's projected solid angle.
    pub area: L,
    /// `H(t_x)` and `H[t_x, e]`.
    pub shape: L,
    pub shape_difference: L,
    /// `N = H(t_x) + e H[t_x, e]`, in [4/15, pi/2].
    pub norm: L,
}
blend_fields!(Areas { area; only shape, shape_difference, norm });

/// What the horizon cuts off, and `X d`.
#[derive(Clone, Copy)]
pub(crate) struct Cut<L> {
    pub crescent: Crescent<L>,
    pub areas: Areas<L>,
    pub x_d: L,
}
blend_fields!(Cut { crescent, areas, x_d });

impl<L: Lane> Cut<L> {
    /// Of a sphere that the horizon cuts, with `v d` and `X d`.
    #[inline(always)]
    pub(super) fn new(sphere: &Sphere<L>, horizon: &Horizon<L>, v_d: L, x_d: L) -> Self {
        let r = sphere.lengths.radius;
        let circle = horizon.circle2.sqrt();
        // One division for two.
        let inv_both = lit(1.0) / (x_d * r);
        let (inv_x_d, inv_r) = (inv_both * r, inv_both * x_d);
        let (t_x, t_y) = (v_d * inv_x_d, circle * inv_x_d);
        let width = t_y * t_y / (lit(1.0) + t_x);
        let kappa = horizon.height.abs() * inv_r;
        let cut = kappa * t_x;
        let (shape, shape_difference) = shape_and_difference(t_x, cut);
        let norm = cut.fma(shape_difference, shape);
        let area = t_y * t_y * t_y * (horizon.beyond * inv_r) * norm;
        // No field of a sampler names them.
        let areas = Areas {
            area,
            shape: shape.named("shape"),
            shape_difference: shape_difference.named("shape_difference"),
            norm: norm.named("norm"),
        };
        Self { crescent: Crescent { tau: circle * inv_r, kappa, t_x, t_y, width, cut }, areas, x_d }
    }

    /// Of any other.
    #[inline(always)]
    pub(super) fn none(x_d: L) -> Self {
        let zero = L::lit(0.0);
        Self {
            crescent: Crescent { tau: zero, kappa: zero, t_x: zero, t_y: zero, width: zero, cut: zero },
            areas: Areas { area: zero, shape: zero, shape_difference: zero, norm: zero },
            x_d,
        }
    }

    /// `H(e)`.
    #[inline(always)]
    pub(crate) fn shape_cut(&self) -> L {
        let (Crescent { cut, t_x, .. }, Areas { shape, shape_difference, .. }) = (self.crescent, self.areas);
        (cut - t_x).fma(shape_difference, shape)
    }
}

impl<L: Lane> Crescent<L> {
    /// Whether there is one.
    #[inline(always)]
    pub(crate) fn exists(&self) -> L::Mask {
        L::lit(0.0).lt(self.tau)
    }

    /// `t_y^3`: every area is this times something of order one.
    #[inline(always)]
    pub(crate) fn t_y_cubed(&self) -> L {
        self.t_y * self.t_y * self.t_y
    }
}
