//! Sums and products that carry their rounding error along, for the two differences everything hangs on: how far the
//! sphere's limb is from the horizon (`r - |n.C|`) and from the point (`d^2 - r^2`).
//!
//! Error-free transformations as in Ogita, Rump and Oishi, "Accurate sum and dot product" (2005). They hold while
//! nothing overflows or underflows; the caller scales its input.

use crate::{lane::Lane, vec3::Vec3};

/// An unevaluated sum `hi + lo` with `|lo|` at most about half a unit in the last place of `hi`.
#[derive(Clone, Copy)]
pub(crate) struct Twofold<L> {
    pub hi: L,
    pub lo: L,
}

/// `a b` without error.
#[inline(always)]
pub(crate) fn product<L: Lane>(a: L, b: L) -> Twofold<L> {
    let hi = a * b;
    Twofold { hi, lo: a.fma(b, -hi) }
}

/// `a + b` without error (Knuth; no order of magnitudes assumed).
#[inline(always)]
fn sum<L: Lane>(a: L, b: L) -> Twofold<L> {
    let hi = a + b;
    let b_part = hi - a;
    Twofold { hi, lo: (a - (hi - b_part)) + (b - b_part) }
}

/// `a . b` as if computed in twice the precision and then split in two.
#[inline(always)]
pub(crate) fn dot<L: Lane>(a: Vec3<L>, b: Vec3<L>) -> Twofold<L> {
    let (x, y, z) = (product(a.x, b.x), product(a.y, b.y), product(a.z, b.z));
    let xy = sum(x.hi, y.hi);
    let xyz = sum(xy.hi, z.hi);
    let error = ((x.lo + y.lo) + z.lo) + (xy.lo + xyz.lo);
    // Cancellation may leave the error as large as the sum: normalise.
    sum(xyz.hi, error)
}
