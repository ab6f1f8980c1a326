//! Two random numbers to a direction.

use super::crescent::{self, Slice};
use super::split::{interior, Split};
use super::{bounded, follows_surface, with_sampler, Place, Sampler};
use crate::cap::{Cap, Case, View};
use crate::disk::{
    areas_of_chord, from_edge, height_per_power, power_per_height, square_to_disk, symmetric, DiskPoint,
};
use crate::lane::{blend_fields, branch, fork, knowing, lit, Lane};
use crate::math::two_thirds_power;
use crate::offset::Offset;
use crate::sample::Sample;
use crate::strategy::{Hemispheres, Strategy, Technique};
use crate::vec3::Vec3;

/// A segment of the unit disk, by its area: on the near or far side of a chord of a disk, or along a slice of the crescent.
#[derive(Clone, Copy)]
struct Segment<L> {
    /// Its power of two thirds, scaled, is that of the segment's area over `g2`: a disk's area itself, or a share of a slice's.
    area: L,
    scale: L,
    /// The square of the length of a slice's direction; 1 for a disk.
    g2: L,
    /// Of a disk: negative where the chord is nearer to its near end than to the far one.
    near_minus_far: L,
    /// Of a slice: the component of its direction towards the zenith.
    m: L,
}
blend_fields!(Segment { area, scale, g2; only near_minus_far; otherwise m });

impl<L: Lane> Sample<L> {
    /// The sample of a sphere that is sampled once: the bits of `Sampler::new(normal, centre, radius, strategy).sample(u0, u1)`,
    /// of which a scalar computes what this sample needs, and no more. [`Sampler::sample_once`] checks its input.
    ///
    /// ```
    /// use spherecap::{Sample, Sampler, Strategy};
    ///
    /// let (normal, centre, radius) = ([0.0, 0.0, 1.0], [3.0, 0.0, 0.5_f32], 1.0);
    /// let sample = Sample::once(normal, centre, radius, Strategy::default(), 0.25, 0.75);
    /// let sampler = Sampler::new(normal, centre, radius, Strategy::default());
    /// assert_eq!(sample, sampler.sample(0.25, 0.75));
    /// ```
    #[inline(always)]
    pub fn once(
        normal: impl Into<[L; 3]>,
        centre: impl Into<[L; 3]>,
        radius: L,
        strategy: Strategy<L>,
        u0: L,
        u1: L,
    ) -> Self {
        let view = View::new(normal.into().into(), centre.into().into(), radius);
        with_sampler!(L, view, strategy, (sampler, case) => {
            sampler.sample_case(case, sampler.is_mixed(), u0, u1)
        })
    }
}

impl<L: Lane> Sampler<L> {
    /// A direction for two random numbers in \[0, 1\]. The ends are allowed: numbers are moved inwards by half the
    /// precision's epsilon where they would give a direction on the horizon, whose density is zero. A number outside is taken
    /// for the nearer end, and NaN for 0.
    ///
    /// The map is continuous for each part of a mixture. An empty cap gives density 0 and an arbitrary direction.
    #[inline(always)]
    pub fn sample(&self, u0: L, u1: L) -> Sample<L> {
        let is_mixed = self.is_mixed();
        knowing!(L, is_mixed => self.sample_case(self.cap.case(), is_mixed, u0, u1))
    }

    /// The same, where this is known.
    #[inline(always)]
    pub(crate) fn sample_case(&self, case: Case<L::Mask>, is_mixed: L::Mask, u0: L, u1: L) -> Sample<L> {
        // For scalars once for each technique, so that what one does not need is not computed for it.
        match self.technique {
            Technique::Projected if L::FORKS => {
                self.sample_with(Technique::Projected, case, is_mixed, u0, u1)
            }
            Technique::SolidAngle if L::FORKS => {
                self.sample_with(Technique::SolidAngle, case, is_mixed, u0, u1)
            }
            technique => self.sample_with(technique, case, is_mixed, u0, u1),
        }
    }

    #[inline(always)]
    fn sample_with(
        &self,
        technique: Technique,
        case: Case<L::Mask>,
        is_mixed: L::Mask,
        u0: L,
        u1: L,
    ) -> Sample<L> {
        let (u0, u1) = (interior(u0), interior(u1));
        let Place { along, up, offset } = match technique {
            Technique::SolidAngle => {
                let (along, offset) = self.whole.place(&self.cap, square_to_disk(u0, u1));
                Place { along, up: offset.zenith, offset }
            }
            _ => self.sample_mixture(technique, is_mixed, case, u0, u1),
        };
        let density = self.density(technique, is_mixed, offset);
        let (centre, distance, normal) = self.cap.hit(offset);
        let direction = if follows_surface::<L>(technique) || technique == Technique::SolidAngle {
            self.vector(technique, along, offset.side, up)
        } else {
            self.vector(technique, centre, offset.side, offset.zenith)
        };
        let [centre, zenith, side] = normal;
        let [along, up] = self.along_and_up(technique, centre, zenith);
        let normal = self.vector(technique, along, side, up);
        Sample { offset, direction, distance: distance * self.cap.distance, normal, density }
    }

    /// The vector with these components on the sampler's axes.
    #[inline(always)]
    fn vector(&self, technique: Technique, along: L, side: L, up: L) -> Vec3<L> {
        let Cap { towards_centre, sideways, up: normal, .. } = self.cap;
        let axes = if follows_surface::<L>(technique) {
            [self.third_axis, sideways, normal]
        } else {
            [towards_centre, sideways, self.third_axis]
        };
        Vec3::combine(axes, [along, side, up])
    }

    /// Components on the sampler's axes, from those towards the centre and the zenith.
    #[inline(always)]
    fn along_and_up(&self, technique: Technique, centre: L, zenith: L) -> [L; 2] {
        let (x, z) = (self.cap.elevation_cos, self.cap.elevation_sin);
        if follows_surface::<L>(technique) {
            [x.fma(centre, -(z * zenith)), z.fma(centre, x * zenith)]
        } else {
            [centre, zenith]
        }
    }

    /// A direction by solid angle or by the projected technique, on one side or both: `u0` chooses, and what is left of it is
    /// used again.
    #[inline(always)]
    fn sample_mixture(
        &self,
        technique: Technique,
        is_mixed: L::Mask,
        case: Case<L::Mask>,
        u0: L,
        u1: L,
    ) -> Place<L> {
        let one = L::lit(1.0);
        let parts = Split(self.defensive);
        let is_plain = is_mixed & parts.is_first(u0);
        let is_choice = is_mixed & L::lit(0.0).lt(self.requested);
        let u0 = branch!(is_choice, parts.left_over(u0, is_plain), u0);
        let Case { is_cut, is_centre_above } = case;
        match self.hemispheres {
            Hemispheres::Front => self.sample_part(technique, is_plain, is_cut, is_centre_above, u0, u1),
            Hemispheres::Both => {
                let sides = Split(self.above);
                let above = is_plain | sides.is_first(u0);
                let side_u0 = sides.left_over(u0, above);
                // The centre's side is the one where both or neither are above.
                let centre_side = (above & is_centre_above) | (!above & !is_centre_above);
                let u0 = L::select(is_plain, u0, side_u0);
                let Place { along, up, offset } =
                    self.sample_part(technique, is_plain, is_cut, centre_side, u0, u1);
                // Below the horizon all is mirrored.
                let sign = L::select(above, one, -one);
                let Offset { zenith, side, cosine } = offset;
                let offset = Offset { zenith: zenith * sign, side, cosine: cosine * sign };
                Place { along, up: up * sign, offset }
            }
        }
    }

    /// A direction in the whole cap by solid angle, or on the side of the horizon where the centre is, or on the other as if
    /// that side were above.
    #[inline(always)]
    fn sample_part(
        &self,
        technique: Technique,
        is_plain: L::Mask,
        is_cut: L::Mask,
        centre_side: L::Mask,
        u0: L,
        u1: L,
    ) -> Place<L> {
        knowing!(L, is_plain => {
            // All of a disk, without anything cut off; else the crescent alone; else a part of either.
            let is_whole = is_plain | !is_cut;
            knowing!(L, is_whole => {
                let is_crescent = !is_whole & !centre_side;
                knowing!(L, is_crescent => self.place(technique, is_plain, is_whole, is_crescent, u0, u1))
            })
        })
    }

    #[inline(always)]
    fn place(
        &self,
        technique: Technique,
        is_plain: L::Mask,
        is_whole: L::Mask,
        is_crescent: L::Mask,
        u0: L,
        u1: L,
    ) -> Place<L> {
        let cap = &self.cap;
        let one = L::lit(1.0);
        let share = self.ellipse.crescent_share;
        let is_disk = is_whole | (!is_crescent & share.le(u0));
        let is_segment = !is_crescent;
        let (across, across_complement) = symmetric(u1);

        // The disk and the slices of the crescent are measured by the same segments: what they share is written once, so
        // that packets and graphs, which may follow both sides, pay for it once.
        fork!(
            L,
            is_disk,
            {
                let ellipse = &self.ellipse;
                let (u0, beyond) = branch!(is_whole, (u0, L::lit(0.0)), (ellipse.left_over(u0), ellipse.beyond));
                let [near, far] = areas_of_chord(u0, beyond);
                Segment { area: near.min(far), scale: one, g2: one, near_minus_far: near - far, m: one }
            },
            {
                let Slice { u0, m, g2, end } = match technique {
                    Technique::Projected => {
                        self.marginal.slice(cap, is_segment, share, u0, across, across_complement)
                    }
                    _ => bounded::slice(cap, is_segment, share, u0, across_complement),
                };
                Segment { area: u0, scale: end * power_per_height(g2 * end), g2, near_minus_far: one, m }
            },
            Segment { area, scale, g2, near_minus_far, m } => {
            // Heights over g2, so that thin slices keep their digits.
            let k = scale * two_thirds_power(area);
            let h1 = k * height_per_power(k * g2);
            let h = g2 * h1;
            let chord2 = h1 * (lit(2.0) - h);
            let chord = chord2.sqrt();
            branch!(
                is_disk,
                {
                    let from_edge = from_edge(h, near_minus_far.lt(L::lit(0.0)));
                    let point = DiskPoint { from_edge, chord, chord2, across, across_complement };
                    branch!(
                        is_plain,
                        {
                            let (centre, offset) = self.whole.place(cap, point);
                            let [along, up] = self.along_and_up(technique, centre, offset.zenith);
                            Place { along, up, offset }
                        },
                        self.ellipse.place(cap, point)
                    )
                },
                {
                    let (side, cosine) = (chord * across, chord * m);
                    match technique {
                        Technique::Projected => crescent::place(cap, is_segment, h, side, cosine),
                        _ => bounded::place(cap, is_segment, h, side, cosine),
                    }
                }
            )
            }
        )
    }
}
