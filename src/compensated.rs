//! Sums and products that carry their rounding error along, for the two differences everything hangs on: how far the
//! sphere's limb is from the horizon (`r - |n.C|`) and from the point (`d^2 - r^2`).
//!
//! Error-free transformations as in Ogita, Rump and Oishi, "Accurate sum and dot product" (2005). They hold while
//! nothing overflows or underflows; the caller scales its input.

use crate::{lane::Lane, vec3::Vec3};

/// An unevaluated sum `hi + lo` of a number and a much smaller one.
#[derive(Clone, Copy)]
pub(crate) struct Twofold<L> {
    pub hi: L,
    pub lo: L,
}

impl<L: Lane> Twofold<L> {
    /// The same sum with `|lo|` at most about half a unit in the last place of `hi` (Dekker's, which is exact unless `lo` was the
    /// larger one, and then off by the rounding of `lo`).
    #[inline(always)]
    pub(crate) fn normalised(self) -> Self {
        let hi = (self.hi + self.lo).rounded();
        Self { hi, lo: (self.lo - (hi - self.hi).rounded()).rounded() }
    }
}

/// `a b` without error.
#[inline(always)]
pub(crate) fn product<L: Lane>(a: L, b: L) -> Twofold<L> {
    let hi = (a * b).rounded();
    Twofold { hi, lo: a.fma(b, -hi) }
}

/// `a + b` without error (Knuth; no order of magnitudes assumed).
#[inline(always)]
fn sum<L: Lane>(a: L, b: L) -> Twofold<L> {
    let hi = (a + b).rounded();
    let b_part = (hi - a).rounded();
    let a_part = (hi - b_part).rounded();
    Twofold { hi, lo: (a - a_part).rounded() + (b - b_part).rounded() }
}

/// `a . b` as if computed in twice the precision and then split in two. Where the products cancel, `lo` may be as large as
/// `hi`: see [`Twofold::normalised`].
#[inline(always)]
pub(crate) fn dot<L: Lane>(a: Vec3<L>, b: Vec3<L>) -> Twofold<L> {
    let (x, y, z) = (product(a.x, b.x), product(a.y, b.y), product(a.z, b.z));
    let xy = sum(x.hi, y.hi);
    let xyz = sum(xy.hi, z.hi);
    Twofold { hi: xyz.hi, lo: ((x.lo + y.lo) + z.lo) + (xy.lo + xyz.lo) }
}
