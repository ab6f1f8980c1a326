//! Vectors of three lanes, with just the operations that the kernels need.

use crate::lane::{blend_fields, broadcast_fields, Lane};
use core::ops::{Div, Mul};

/// A vector of three lanes, laid out as `[x, y, z]`. It converts from and into such an array, and so into what other libraries
/// call a vector: functions here take everything that converts into an array.
///
/// ```
/// use spherecap::Vec3;
///
/// let v: Vec3<f32> = [1.0, 2.0, 3.0].into();
/// assert_eq!(v.dot(Vec3::new(0.0, 0.0, 1.0)), 3.0);
/// assert_eq!(<[f32; 3]>::from(v), [1.0, 2.0, 3.0]);
/// // With glam, of whatever version:
/// let v = glam::Vec3::from(<[f32; 3]>::from(v));
/// let receiver = spherecap::Receiver::new(v);
/// assert_eq!(receiver.normal.z, v.z);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Vec3<L> {
    /// First component.
    pub x: L,
    /// Second component.
    pub y: L,
    /// Third component.
    pub z: L,
}

impl<L> Vec3<L> {
    /// The vector with these components.
    #[inline(always)]
    pub const fn new(x: L, y: L, z: L) -> Self {
        Self { x, y, z }
    }
}

impl<L: Lane> Vec3<L> {
    /// Scalar product, rounded three times.
    #[inline(always)]
    pub fn dot(self, other: Self) -> L {
        self.x.fma(other.x, self.y.fma(other.y, self.z * other.z))
    }

    /// Vector product, each component to within 1.5 units in its last place (Kahan's difference of products), so
    /// that the product of nearly parallel vectors keeps its direction.
    ///
    /// ```
    /// # use spherecap::Vec3;
    /// let [x, y] = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
    /// assert_eq!(x.cross(y), Vec3::new(0.0_f64, 0.0, 1.0));
    /// ```
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            difference_of_products(self.y, other.z, self.z, other.y),
            difference_of_products(self.z, other.x, self.x, other.z),
            difference_of_products(self.x, other.y, self.y, other.x),
        )
    }

    /// Vector product, each component to within an epsilon of the lengths' product: of vectors far from parallel, where nothing
    /// cancels that would matter to the length.
    #[inline(always)]
    pub(crate) fn cross_of_distinct(self, other: Self) -> Self {
        Self::new(
            self.y.fma(other.z, -(self.z * other.y)),
            self.z.fma(other.x, -(self.x * other.z)),
            self.x.fma(other.y, -(self.y * other.x)),
        )
    }

    /// `self * a + other * b + third * c`: a vector given by its components in a frame.
    #[inline(always)]
    pub(crate) fn combine(frame: [Self; 3], [a, b, c]: [L; 3]) -> Self {
        let component = |f: [L; 3]| f[0].fma(a, f[1].fma(b, f[2] * c));
        let [u, v, w] = frame;
        Self::new(component([u.x, v.x, w.x]), component([u.y, v.y, w.y]), component([u.z, v.z, w.z]))
    }
}

/// `a b - c d`, as if rounded once (Jeannerod, Louvet and Muller 2013: within 1.5 units in the last place).
#[inline(always)]
fn difference_of_products<L: Lane>(a: L, b: L, c: L, d: L) -> L {
    let cd = (c * d).rounded();
    let error = (-c).fma(d, cd);
    a.fma(b, -cd).rounded() + error
}

impl<L: Lane> Mul<L> for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: L) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl<L: Lane> Div<L> for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn div(self, divisor: L) -> Self {
        Self::new(self.x / divisor, self.y / divisor, self.z / divisor)
    }
}

blend_fields!(Vec3 { x, y, z });
broadcast_fields!(Vec3 { x, y, z });

impl<L> From<[L; 3]> for Vec3<L> {
    #[inline(always)]
    fn from([x, y, z]: [L; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<L> From<Vec3<L>> for [L; 3] {
    #[inline(always)]
    fn from(v: Vec3<L>) -> Self {
        [v.x, v.y, v.z]
    }
}
