//! How the horizon divides a cap's solid angle.

use super::{Cap, Cut};
use crate::disk::shape_and_difference;
use crate::lane::{branch, lit, Blend, Lane};
use core::f64::consts::PI;

impl<L: Lane> Cap<L> {
    /// Shares of the cap's solid angle that lie above the horizon and below it: docs/mathematics.md, section 10.
    ///
    /// Of the crescent's over the whole cap's it is
    /// `tau^3 (1 + v)/pi [kappa M H[kappa, e] + (H(e) (M - kappa^2) + kappa) / X^2]` with `M = (1 - t_x)/s^2 = tau^2 / (X^2 (1 + t_x))`.
    #[inline(always)]
    pub(crate) fn shares(&self, cut: &Cut<L>) -> [L; 2] {
        let one = L::lit(1.0);
        let centre_above = L::lit(0.0).lt(self.elevation_sin);
        let crescent_share = branch!(
            self.crescent.exists(),
            {
                let c = &self.crescent;
                let inv_x2 = lit(1.0) / (self.elevation_cos * self.elevation_cos);
                let per_s2 = c.tau * c.tau * inv_x2 / (lit(1.0) + c.t_x);
                let (_, difference) = shape_and_difference(c.kappa, c.cut);
                let bracket = (c.kappa * per_s2)
                    .fma(difference, cut.shape_cut().fma(per_s2 - c.kappa * c.kappa, c.kappa) * inv_x2);
                let share = c.tau * c.tau * c.tau * (self.radius_cos + lit(1.0)) * bracket * lit(1.0 / PI);
                share.max(L::lit(0.0)).min(L::lit(0.5))
            },
            L::lit(0.0)
        );
        let larger = one - crescent_share;
        Blend::blend(centre_above, [larger, crescent_share], [crescent_share, larger])
    }
}
