//! A direction back to its random numbers.

use super::split::Split;
use super::{bounded, Sampler};
use crate::lane::{branch, Lane};
use crate::offset::Offset;
use crate::strategy::{Hemispheres, Technique};

impl<L: Lane> Sampler<L> {
    /// The random numbers that give this offset: [`Sampler::sample`] of them returns it, to rounding. In the defensive mixture
    /// the numbers of the projected part, where there is one. Within \[0, 1\] for offsets that the strategy samples.
    ///
    /// To 84 epsilon (1e-5 in f32) but for what three numbers of this precision cannot tell: at the ends of u0 where the
    /// centre's side is sampled, chords get short, and u1 is a ratio of lengths; where the horizon leaves little of the
    /// ellipse (small Z/s), and on spheres nearly touched (`v` and `|Z|` both small). `tests/kernels/properties.rs` has the bound.
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// let sampler = Sampler::<f64>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// let [u0, u1] = sampler.invert(sampler.sample(0.3, 0.6).offset);
    /// assert!((u0 - 0.3).abs() < 1e-12 && (u1 - 0.6).abs() < 1e-12);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn invert(&self, offset: Offset<L>) -> [L; 2] {
        let zero = L::lit(0.0);
        let cap = &self.cap;
        let plain = || self.whole.invert(cap, offset);
        let [u0, u1] = match self.technique {
            Technique::SolidAngle => plain(),
            _ => {
                let is_plain = L::lit(1.0).le(self.defensive);
                branch!(is_plain, plain(), {
                    let above = zero.lt(offset.cosine);
                    let sign = L::select(above, L::lit(1.0), L::lit(-1.0));
                    let mirrored = Offset {
                        zenith: offset.zenith * sign,
                        side: offset.side,
                        cosine: offset.cosine.abs(),
                    };
                    let centre_above = zero.lt(cap.elevation_sin);
                    let centre_side = (above & centre_above) | (!above & !centre_above);
                    let [u0, u1] = self.invert_side(centre_side, mirrored);
                    let u0 = match self.hemispheres {
                        Hemispheres::Front => u0,
                        Hemispheres::Both => {
                            let [in_above, in_below] = Split(self.above).numbers(u0);
                            L::select(above, in_above, in_below)
                        }
                    };
                    let [_, in_projected] = Split(self.defensive).numbers(u0);
                    [in_projected, u1]
                })
            }
        };
        let unit = |u: L| u.max(zero).min(L::lit(1.0));
        [unit(u0), unit(u1)]
    }

    /// The inverse of [`Sampler::sample_part`], but for its plain part.
    #[inline(always)]
    fn invert_side(&self, centre_side: L::Mask, offset: Offset<L>) -> [L; 2] {
        let split = self.ellipse.split();
        // In case 2 the chord x = t_x divides them: x = X a - Z zenith.
        let cap = &self.cap;
        let in_ellipse = centre_side & self.ellipse.contains(cap, offset);
        branch!(
            in_ellipse,
            {
                let [u0, u1] = self.ellipse.invert(cap, offset);
                let [_, in_ellipse] = split.numbers(u0);
                [in_ellipse, u1]
            },
            {
                let [u0, u1] = match self.technique {
                    Technique::Projected => self.marginal.invert(cap, centre_side, offset),
                    _ => bounded::invert(cap, centre_side, offset),
                };
                let [in_crescent, _] = split.numbers(u0);
                [L::select(centre_side, in_crescent, u0), u1]
            }
        )
    }
}
