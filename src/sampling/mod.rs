//! Sampling a cap: one prepared [`Sampler`], three techniques, two mixtures.
//!
//! A technique is a map from the unit square onto directions, with its density and its inverse. Everything that decides
//! anything is decided once, in [`Sampler::new`]; sample, pdf and invert read it.
//!
//! | part of the cap | file | used by |
//! |---|---|---|
//! | the whole cap, by solid angle | `solid_angle.rs` | `SolidAngle`, and the defensive part of the others |
//! | case 1, and case 2 without its crescent: an ellipse | `ellipse.rs` | `ProjectedBounded`, `Projected` |
//! | the crescent, uniformly | `crescent.rs` | `Projected` |
//! | the crescent, by the paper's warp | `bounded.rs` | `ProjectedBounded` |

mod bounded;
mod crescent;
mod ellipse;
mod solid_angle;

use crate::cap::{Cap, Case, View};
use crate::disk::{
    areas_of_chord, cube_of_power, from_edge, height_per_power, power_per_height, shape_and_difference,
    square_to_disk, symmetric, two_thirds_power, DiskPoint,
};
use crate::lane::{blend_fields, branch, fork, knowing, lit, Blend, Lane};
use crate::offset::Offset;
use crate::prepare::is_unit;
use crate::vec3::Vec3;
use core::f64::consts::PI;
use crescent::Slice;

pub use bounded::density_bound_for_radius;

/// How directions are distributed.
///
/// ```
/// use spherecap::{Receiver, Sampler, Strategy, Technique};
///
/// // How much the weights of a diffuse surface's samples can differ where the horizon cuts a light.
/// let bound = |technique| {
///     let strategy = Strategy { technique, ..Strategy::default() };
///     let receiver = Receiver { normal: [0.0, 0.0, 1.0].into(), strategy };
///     let sampler = Sampler::<f64>::prepare(receiver, [2.0, 0.0, -0.5], 1.0);
///     sampler.map(|sampler| sampler.density_bound())
/// };
/// assert_eq!(bound(Technique::SolidAngle)?, f64::INFINITY);
/// assert!(bound(Technique::ProjectedBounded)? < 2.0);
/// assert_eq!(bound(Technique::Projected)?, 1.0);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Technique {
    /// Uniform in projected solid angle in every case: the density is constant to within 1e-5.
    Projected = 0,
    /// Uniform in projected solid angle where the sphere's centre is above the horizon; below it the warp of Peters and
    /// Dachsbacher 2019, whose density varies by a bounded factor ([`Sampler::density_bound`]).
    ProjectedBounded = 1,
    /// Uniform in solid angle over the whole cap, also where it is below the horizon: the usual way, and the baseline.
    SolidAngle = 2,
}

/// Which sides of the surface the projected techniques cover.
///
/// ```
/// use spherecap::{Hemispheres, Receiver, Sampler, Strategy};
///
/// let goes_below = |hemispheres| {
///     let strategy = Strategy { hemispheres, ..Strategy::default() };
///     let receiver = Receiver { normal: [0.0, 0.0, 1.0].into(), strategy };
///     let sampler = Sampler::<f32>::prepare(receiver, [2.0, 0.0, 0.1], 1.0);
///     sampler.map(|sampler| (0..8).any(|i| sampler.sample(i as f32 / 8.0, 0.5).offset.cosine < 0.0))
/// };
/// assert_eq!([goes_below(Hemispheres::Front)?, goes_below(Hemispheres::Both)?], [false, true]);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Hemispheres {
    /// Directions above the horizon: for opaque surfaces.
    Front = 0,
    /// Both sides, each sampled in proportion to |cosine|; a side is chosen by its share of the solid angle. For surfaces
    /// that transmit, or whose side is not known.
    Both = 1,
}

/// What a cap is sampled with.
///
/// ```
/// use spherecap::{Strategy, Technique};
///
/// // For shading normals that differ from geometric ones: every weight is at most 8 times that of plain solid angles.
/// let strategy = Strategy { defensive: 0.125_f32, ..Strategy::default() };
/// assert_eq!(strategy.technique, Technique::Projected);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strategy<L> {
    /// How directions are distributed.
    pub technique: Technique,
    /// Which sides of the surface are covered. [`Technique::SolidAngle`] always covers both.
    pub hemispheres: Hemispheres,
    /// Probability, in [0, 1], of sampling by solid angle instead. It bounds every weight by its reciprocal times that of
    /// plain solid-angle sampling, for integrands that are no multiple of the cosine (shading normals).
    pub defensive: L,
}

impl<L: Lane> Default for Strategy<L> {
    fn default() -> Self {
        Self { technique: Technique::Projected, hemispheres: Hemispheres::Front, defensive: L::lit(0.0) }
    }
}

/// What receives the light: a surface, or a point on none, and how its light is sampled. Whoever asks for a density, as
/// multiple importance sampling does, must ask with the receiver that samples: so carry it along.
///
/// ```
/// use spherecap::{Receiver, Sampler, Strategy};
///
/// let floor = Receiver::new([0.0, 0.0, 1.0]);
/// let bumpy_floor = Receiver { strategy: Strategy { defensive: 0.125, ..floor.strategy }, ..floor };
/// // Normals have any length but zero, which says that there is no surface: transformed ones need not be normalised.
/// let stretched = Receiver::new([0.0, 0.0, 7.0_f32]);
/// let sample = |receiver| Sampler::prepare(receiver, [3.0, 0.0, 0.5], 1.0).map(|s| s.sample(0.25, 0.75));
/// assert_eq!(sample(stretched)?, sample(floor)?);
/// assert!(sample(bumpy_floor)? != sample(floor)?);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Receiver<L> {
    /// Normal of the surface on the side to be lit, of any finite length; or exactly zero for a point on no surface, as in a
    /// medium: then sampling is by solid angle. One that is of unit length to single precision is used as it stands.
    pub normal: Vec3<L>,
    /// What its light is sampled with.
    pub strategy: Strategy<L>,
}

impl<L: Lane> Receiver<L> {
    /// One with this normal and the default strategy.
    ///
    /// ```
    /// # use spherecap::{Receiver, Strategy};
    /// let receiver = Receiver::<f64>::new([0.0, 0.6, 0.8]);
    /// assert_eq!(receiver.strategy, Strategy::default());
    /// ```
    #[inline(always)]
    pub fn new(normal: impl Into<[L; 3]>) -> Self {
        Self { normal: normal.into().into(), strategy: Strategy::default() }
    }
}

/// A probability density in two measures.
///
/// ```
/// use spherecap::{Density, Receiver, Sampler};
///
/// let sampler = Sampler::<f64>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 0.0, 0.5], 1.0)?;
/// let sample = sampler.sample(0.3, 0.6);
/// let Density { solid_angle, projected_solid_angle } = sample.density;
/// assert!((solid_angle / projected_solid_angle - sample.offset.cosine).abs() < 1e-14);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Density<L> {
    /// With respect to solid angle, per steradian.
    pub solid_angle: L,
    /// With respect to projected solid angle: the same divided by |cosine|, but never infinite.
    pub projected_solid_angle: L,
}

impl<L: Lane> Density<L> {
    /// The same where the mask is true, zero elsewhere.
    #[inline(always)]
    pub(crate) fn where_true(self, mask: L::Mask) -> Self {
        let zero = L::lit(0.0);
        Self {
            solid_angle: L::select(mask, self.solid_angle, zero),
            projected_solid_angle: L::select(mask, self.projected_solid_angle, zero),
        }
    }
}

/// A sampled direction and where it meets the sphere.
///
/// ```
/// use spherecap::{Receiver, Sample, Sampler};
///
/// let (centre, radius) = ([2.0, 0.0, 0.5], 1.0);
/// let sampler = Sampler::<f64>::prepare(Receiver::new([0.0, 0.0, 1.0]), centre, radius)?;
/// let Sample { direction, distance, normal, .. } = sampler.sample(0.3, 0.6);
/// // The point on the light, in two ways.
/// let along_the_ray = direction.x * distance;
/// let on_the_sphere = centre[0] + radius * normal.x;
/// assert!((along_the_ray - on_the_sphere).abs() < 1e-14);
/// // As an array, from which every library of vectors makes its own.
/// let [x, y, z] = direction.into();
/// assert!((x * x + y * y + z * z - 1.0_f64).abs() < 1e-14);
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Sample<L> {
    /// The direction in the cap's frame, at full precision.
    pub offset: Offset<L>,
    /// Unit direction from the shading point.
    pub direction: Vec3<L>,
    /// Distance to the sphere's surface along the direction, in the caller's unit of length.
    pub distance: L,
    /// Unit outward normal of the sphere there: centre + radius * normal is the point itself.
    pub normal: Vec3<L>,
    /// Density of the direction, the same bits as [`Sampler::pdf`] of its offset.
    pub density: Density<L>,
}

/// A cap prepared for sampling with one [`Strategy`]. Plain data.
///
/// ```
/// use spherecap::{Receiver, Sampler};
///
/// let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
/// // Every sample estimates the same irradiance: there is no noise.
/// for i in 0..4 {
///     let sample = sampler.sample(0.25 * i as f32 + 0.1, 0.3);
///     let irradiance = sample.offset.cosine / sample.density.solid_angle;
///     assert!((irradiance / sampler.cap().projected_solid_angle() - 1.0).abs() < 1e-5);
/// }
/// # Ok::<(), spherecap::Refusal>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Sampler<L> {
    pub(crate) technique: Technique,
    pub(crate) hemispheres: Hemispheres,
    cap: Cap<L>,
    /// Probability of the solid-angle part: 0 or 1 where only one part exists.
    defensive: L,
    /// The fraction that was asked for: where it is 0, a random number has nothing to choose.
    requested: L,
    /// Reciprocal projected solid angles above and below the horizon; 0 for a side with nothing on it.
    inv_above: L,
    inv_below: L,
    /// Probability of the side above the horizon.
    share_above: L,
    /// Along the surface towards the centre, or towards the zenith: see [`follows_surface`].
    third_axis: Vec3<L>,
    whole: solid_angle::Whole<L>,
    ellipse: ellipse::Ellipse<L>,
    marginal: crescent::Marginal<L>,
}

/// A direction that was placed in the cap.
#[derive(Clone, Copy)]
struct Place<L> {
    /// Its components on the sampler's axes but the one sideways.
    along: L,
    up: L,
    /// In the cap's own frame; its `side` is the component sideways.
    offset: Offset<L>,
}
blend_fields!(Place { along, up, offset });

/// Does something with the sampler of a view, and the case that it is: `with_sampler!(Lane, view, strategy, (sampler, case) =>
/// then)`. Scalars do it once for each case.
macro_rules! with_sampler {
    ($lane:ty, $view:expr, $strategy:expr, ($sampler:ident, $case:ident) => $then:expr) => {{
        let view = $view;
        let is_cut = view.is_cut();
        $crate::lane::fork!($lane, is_cut, view.cut(), view.uncut(), cut => {
            let cap = $crate::cap::Cap::of(view, cut);
            let $case = $crate::cap::Case { is_cut, ..cap.case() };
            $crate::lane::knowing!($lane, $case.is_centre_above => {
                let $sampler = Sampler::of(cap, $case, $strategy);
                $then
            })
        })
    }};
}
pub(crate) use with_sampler;

impl<L: Lane> Sample<L> {
    /// The sample of a sphere that is sampled once: the bits of `Sampler::new(Cap::new(normal, centre, radius), strategy).sample(u0, u1)`,
    /// of which a scalar computes what this sample needs, and no more. [`Sampler::sample_once`] checks its input.
    ///
    /// ```
    /// use spherecap::{Cap, Sample, Sampler, Strategy};
    ///
    /// let (normal, centre, radius) = ([0.0, 0.0, 1.0], [3.0, 0.0, 0.5_f32], 1.0);
    /// let sample = Sample::once(normal, centre, radius, Strategy::default(), 0.25, 0.75);
    /// let sampler = Sampler::new(Cap::new(normal, centre, radius), Strategy::default());
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
        with_sampler!(L, view, strategy, (sampler, case) => sampler.sample_case(case, u0, u1))
    }
}

impl<L: Lane> Sampler<L> {
    /// Prepares a cap for sampling.
    ///
    /// ```
    /// # use spherecap::{Cap, Sampler, Strategy};
    /// // Total: where there is nothing to sample, it says so.
    /// let cap = Cap::<f32>::new([0.0, 0.0, 1.0], [0.0, 0.0, -2.0], 1.0);
    /// let sampler = Sampler::new(cap, Strategy::default());
    /// assert!(sampler.is_empty());
    /// ```
    #[inline(always)]
    pub fn new(cap: Cap<L>, strategy: Strategy<L>) -> Self {
        Self::of(cap, cap.case(), strategy)
    }

    /// The same, of a cap whose case is known.
    #[inline(always)]
    pub(crate) fn of(cap: Cap<L>, case: Case<L::Mask>, strategy: Strategy<L>) -> Self {
        let Strategy { technique, hemispheres, defensive } = strategy;
        let zero = L::lit(0.0);
        let reciprocal = |area: L| L::select(zero.lt(area), lit(1.0) / area, zero);
        let inv_above = reciprocal(cap.projected_above);
        let inv_below = match hemispheres {
            Hemispheres::Front => zero,
            Hemispheres::Both => reciprocal(cap.projected_below),
        };
        let samples_projected = zero.lt(inv_above + inv_below);
        // With nothing for the technique to sample, a defensive sampler still covers the whole cap: a shading normal may
        // see what the geometric one does not. So does every sampler without a surface, where no cosine exists.
        let on_surface = cap.is_on_surface();
        let alone = L::select(zero.lt(defensive) | !on_surface, L::lit(1.0), zero);
        // The centre's side is the ellipse's; the other is the crescent's.
        let Case { is_cut, is_centre_above } = case;
        let (cuts_ellipse, uses_crescent) = match hemispheres {
            Hemispheres::Front => (is_cut & is_centre_above, is_cut & !is_centre_above),
            Hemispheres::Both => (is_cut, is_cut),
        };
        let requested = defensive;
        let inv_larger = L::select(is_centre_above, inv_above, inv_below);
        let (defensive, ellipse, marginal) = match technique {
            Technique::SolidAngle => (L::lit(1.0), ellipse::Ellipse::unused(), crescent::Marginal::unused()),
            Technique::ProjectedBounded => (
                L::select(samples_projected, defensive, alone),
                ellipse::Ellipse::new(&cap, cuts_ellipse, inv_larger),
                crescent::Marginal::unused(),
            ),
            Technique::Projected => (
                L::select(samples_projected, defensive, alone),
                ellipse::Ellipse::new(&cap, cuts_ellipse, inv_larger),
                crescent::Marginal::new(&cap, uses_crescent),
            ),
        };
        let whole = match technique {
            Technique::SolidAngle => solid_angle::Whole::new(&cap),
            _ => branch!(zero.lt(defensive), solid_angle::Whole::new(&cap), solid_angle::Whole::unused()),
        };
        let third_axis = if follows_surface::<L>(technique) {
            cap.sideways.cross_of_distinct(cap.up)
        } else {
            cap.towards_zenith()
        };
        let share_above = match hemispheres {
            Hemispheres::Front => L::lit(1.0),
            // A side with nothing on it (that can be weighed) gets no samples.
            Hemispheres::Both => L::select(
                zero.lt(inv_below),
                L::select(zero.lt(inv_above), share_above(&cap), zero),
                L::lit(1.0),
            ),
        };
        Self {
            technique,
            hemispheres,
            cap,
            defensive,
            requested,
            inv_above,
            inv_below,
            share_above,
            third_axis,
            whole,
            ellipse,
            marginal,
        }
    }

    /// Whether there is nothing to sample: every density is 0.
    #[inline(always)]
    pub fn is_empty(&self) -> L::Mask {
        let zero = L::lit(0.0);
        let plain = zero.lt(self.defensive) & zero.lt(self.whole.inv_solid_angle);
        !(zero.lt(self.inv_above + self.inv_below) | plain)
    }

    /// The geometry that was prepared.
    #[inline(always)]
    pub fn cap(&self) -> &Cap<L> {
        &self.cap
    }

    /// A direction for two random numbers in \[0, 1\]. The ends are allowed: numbers are moved inwards by half the
    /// precision's epsilon where they would give a direction on the horizon, whose density is zero. A number outside is taken
    /// for the nearer end, and NaN for 0.
    ///
    /// The map is continuous for each part of a mixture. An empty cap gives density 0 and an arbitrary direction.
    #[inline(always)]
    pub fn sample(&self, u0: L, u1: L) -> Sample<L> {
        self.sample_case(self.cap.case(), u0, u1)
    }

    /// The same, of a cap whose case is known.
    #[inline(always)]
    pub(crate) fn sample_case(&self, case: Case<L::Mask>, u0: L, u1: L) -> Sample<L> {
        // For scalars once for each technique, so that what one does not need is not computed for it.
        match self.technique {
            Technique::Projected if L::FORKS => self.sample_with(Technique::Projected, case, u0, u1),
            Technique::SolidAngle if L::FORKS => self.sample_with(Technique::SolidAngle, case, u0, u1),
            technique => self.sample_with(technique, case, u0, u1),
        }
    }

    #[inline(always)]
    fn sample_with(&self, technique: Technique, case: Case<L::Mask>, u0: L, u1: L) -> Sample<L> {
        let (u0, u1) = (interior(u0), interior(u1));
        let is_mixed = is_mixed(technique, self.defensive);
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
        let is_plain = is_mixed & u0.lt(self.defensive);
        let u0 = branch!(L::lit(0.0).lt(self.requested), left_over(u0, self.defensive, is_plain), u0);
        let Case { is_cut, is_centre_above } = case;
        match self.hemispheres {
            Hemispheres::Front => self.sample_part(technique, is_plain, is_cut, is_centre_above, u0, u1),
            Hemispheres::Both => {
                let above = is_plain | u0.lt(self.share_above);
                let side_u0 = left_over(u0, self.share_above, above);
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
        // that packets and graphs, which may follow both sides, pay for it once. Of its own the disk has which side of its
        // middle a point is on, and a slice has its m.
        fork!(
            L,
            is_disk,
            {
                let ellipse = &self.ellipse;
                let (u0, beyond) = branch!(is_whole, (u0, L::lit(0.0)), (ellipse.remap(u0), ellipse.beyond));
                let [near, far] = areas_of_chord(u0, beyond);
                ([cube_of_power(near.min(far)), one, one], near - far)
            },
            {
                let Slice { u0, m, g2, end } = match technique {
                    Technique::Projected => {
                        self.marginal.slice(cap, is_segment, share, u0, across, across_complement)
                    }
                    _ => bounded::slice(cap, is_segment, share, u0, across_complement),
                };
                ([u0, end * power_per_height(g2 * end), g2], m)
            },
            ([cube, scale, g2], own) => {
            // Heights over g2, so that thin slices keep their digits.
            let k = scale * two_thirds_power(cube);
            let h1 = k * height_per_power(k * g2);
            // The middle of the disk is as far as its segments go.
            let h1 = branch!(is_disk, h1.min(one), h1);
            let h = g2 * h1;
            let chord2 = h1 * (lit(2.0) - h);
            let chord = chord2.sqrt();
            branch!(
                is_disk,
                {
                    let from_edge = from_edge(h, own.lt(L::lit(0.0)));
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
                    let (side, cosine) = (chord * across, chord * own);
                    match technique {
                        Technique::Projected => crescent::place(cap, is_segment, h, side, cosine),
                        _ => bounded::place(cap, is_segment, h, side, cosine),
                    }
                }
            )
            }
        )
    }

    /// Density of the direction with this offset; zero outside the cap, and where the strategy samples nothing. For an
    /// offset that [`Sampler::sample`] returned: the very bits it returned as density.
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// let sample = sampler.sample(0.3, 0.6);
    /// assert_eq!(sampler.pdf(sample.offset), sample.density);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf(&self, offset: Offset<L>) -> Density<L> {
        self.pdf_in_cap(offset).where_true(self.cap.contains(offset))
    }

    /// Density of a unit direction; zero outside the cap, and where it is not of unit length to within
    /// [`UNIT_TOLERANCE`](crate::UNIT_TOLERANCE). To the precision of [`Sampler::offset`]: where you have the offset, ask
    /// [`Sampler::pdf`].
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// // Directions from elsewhere: from a BSDF, say.
    /// assert!(sampler.pdf_direction([0.8, 0.48, 0.36]).solid_angle > 0.0);
    /// assert_eq!(sampler.pdf_direction([0.0, 0.0, 1.0]).solid_angle, 0.0);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf_direction(&self, direction: impl Into<[L; 3]>) -> Density<L> {
        let direction = Vec3::from(direction.into());
        self.pdf(self.offset(direction)).where_true(is_unit(direction))
    }

    /// As [`Sampler::pdf_direction`], for a direction that is known to point at the sphere (a ray has hit it): only the horizon
    /// is tested, so that rounding near the limb does not lose the density.
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// # let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// // For multiple importance sampling: a ray has hit the light in this direction.
    /// let direction = sampler.sample(0.0, 0.5).direction;
    /// assert!(sampler.pdf_on_sphere(direction).solid_angle > 0.0);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf_on_sphere(&self, direction: impl Into<[L; 3]>) -> Density<L> {
        let direction = Vec3::from(direction.into());
        self.pdf_in_cap(self.offset(direction)).where_true(is_unit(direction))
    }

    /// As [`Sampler::pdf`], for an offset that is known to lie in the cap: only the horizon is tested.
    ///
    /// ```
    /// # use spherecap::{Receiver, Sampler};
    /// # let sampler = Sampler::<f32>::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 1.0, 0.5], 1.0)?;
    /// let sample = sampler.sample(0.3, 0.6);
    /// assert_eq!(sampler.pdf_in_cap(sample.offset), sample.density);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    #[inline(always)]
    pub fn pdf_in_cap(&self, offset: Offset<L>) -> Density<L> {
        self.density(self.technique, is_mixed(self.technique, self.defensive), offset)
    }

    #[inline(always)]
    fn density(&self, technique: Technique, is_mixed: L::Mask, offset: Offset<L>) -> Density<L> {
        let zero = L::lit(0.0);
        // An empty cap's samples may have none, and the density 0 yet.
        let cosine = offset.cosine.abs().min(L::lit(L::MAX));
        let weight =
            if technique == Technique::SolidAngle { zero } else { self.projected_density(technique, offset) };
        // The mixture's arithmetic is skipped where there is no solid-angle part.
        let (solid_angle, projected_solid_angle) = branch!(
            is_mixed,
            {
                let plain = self.defensive * self.whole.inv_solid_angle;
                let plain_projected = (plain / cosine.max(L::lit(L::MIN_POSITIVE))).min(L::lit(L::MAX));
                let rest = lit(1.0) - self.defensive;
                (weight.fma(rest * cosine, plain), weight.fma(rest, plain_projected).min(L::lit(L::MAX)))
            },
            (weight * cosine, weight)
        );
        Density { solid_angle, projected_solid_angle }
    }

    /// Density of the projected technique alone, with respect to projected solid angle.
    #[inline(always)]
    fn projected_density(&self, technique: Technique, offset: Offset<L>) -> L {
        let zero = L::lit(0.0);
        let (above, below) = (zero.lt(offset.cosine), offset.cosine.lt(zero));
        let weight = match self.hemispheres {
            Hemispheres::Front => L::select(above, self.inv_above, zero),
            Hemispheres::Both => {
                let share_below = lit(1.0) - self.share_above;
                let below = L::select(below, self.inv_below * share_below, zero);
                L::select(above, self.inv_above * self.share_above, below)
            }
        };
        if technique == Technique::Projected {
            return weight;
        }
        let cap = &self.cap;
        let centre_above = zero.lt(cap.elevation_sin);
        let centre_side = (above & centre_above) | (below & !centre_above);
        let is_warped = zero.lt(weight) & cap.crescent.exists() & !centre_side;
        // Beside a crescent so thin that it is hardly a number, the warp has a slope that is none.
        (weight * branch!(is_warped, bounded::relative_density(cap, offset), L::lit(1.0))).min(L::lit(L::MAX))
    }

    /// The largest density within the cap over the smallest, with respect to projected solid angle and above the horizon:
    /// an upper bound, Equation (4) of the paper's supplement for [`Technique::ProjectedBounded`] in case 3, and 1 in every
    /// other case and for [`Technique::Projected`]. The density of [`Technique::SolidAngle`] has no bound: infinity where the
    /// horizon cuts or touches the cap, and the ratio of the extreme cosines elsewhere. Of the technique alone: the
    /// mixtures are not counted.
    #[inline(always)]
    pub fn density_bound(&self) -> L {
        let bound = match self.technique {
            Technique::SolidAngle => solid_angle::density_bound(&self.cap),
            Technique::ProjectedBounded => bounded::density_bound(&self.cap),
            Technique::Projected => L::lit(1.0),
        };
        bound.max(L::lit(1.0))
    }

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
                            let share = self.share_above;
                            L::select(above, u0 * share, (lit(1.0) - share).fma(u0, share))
                        }
                    };
                    [(lit(1.0) - self.defensive).fma(u0, self.defensive), u1]
                })
            }
        };
        let unit = |u: L| u.max(zero).min(L::lit(1.0));
        [unit(u0), unit(u1)]
    }

    /// The inverse of [`Sampler::sample_part`], but for its plain part.
    #[inline(always)]
    fn invert_side(&self, centre_side: L::Mask, offset: Offset<L>) -> [L; 2] {
        let share = self.ellipse.crescent_share;
        // In case 2 the chord x = t_x divides them: x = X a - Z zenith.
        let cap = &self.cap;
        let in_ellipse = centre_side & self.ellipse.contains(cap, offset);
        branch!(
            in_ellipse,
            {
                let [u0, u1] = self.ellipse.invert(cap, offset);
                [(lit(1.0) - share).fma(u0, share), u1]
            },
            {
                let [u0, u1] = match self.technique {
                    Technique::Projected => self.marginal.invert(cap, centre_side, offset),
                    _ => bounded::invert(cap, centre_side, offset),
                };
                [L::select(centre_side, u0 * share, u0), u1]
            }
        )
    }

    /// Offset of a unit direction, to the precision that the direction has: four epsilon (5e-7 in f32) for its components, so
    /// that of a cap with `s = 1e-6` little is left; for the cosine eight and what the limb of a sphere nearly touched adds, four
    /// over `v`. A density by solid angle is as good as that over the cosine. Directions away from the sphere give an offset
    /// outside the cap.
    #[inline(always)]
    pub fn offset(&self, direction: impl Into<[L; 3]>) -> Offset<L> {
        let direction = Vec3::from(direction.into());
        let centre = self.cap.towards_centre.dot(direction);
        let (zenith, side) = (self.cap.towards_zenith().dot(direction), self.cap.sideways.dot(direction));
        let cosine = self.cap.normal.dot(direction);
        // The offset of the direction's mirror image behind the point would be the same.
        let behind = centre.lt(L::lit(0.0));
        let outside = Offset { zenith: L::lit(1.0), side: L::lit(1.0), cosine };
        Offset::blend(behind, outside, Offset { zenith, side, cosine })
    }
}

/// Whether the axes that a sampler puts directions together on are those of the surface (along it towards the centre, and its
/// normal), where the projected techniques find a point. Else they are those of the cap (towards the centre, and towards the
/// zenith), where sampling by solid angle does; and so in double precision, where a normal may be of unit length to single
/// precision only, which must not show in the directions.
#[inline(always)]
fn follows_surface<L: Lane>(technique: Technique) -> bool {
    L::SIGNIFICAND_BITS == 23 && technique != Technique::SolidAngle
}

/// Whether there is a part by solid angle.
#[inline(always)]
fn is_mixed<L: Lane>(technique: Technique, defensive: L) -> L::Mask {
    match technique {
        Technique::SolidAngle => L::lit(0.0).le(L::lit(0.0)),
        _ => L::lit(0.0).lt(defensive),
    }
}

/// Moves a random number off the ends of \[0, 1\], by less than the spacing of 24-bit random numbers.
#[inline(always)]
fn interior<L: Lane>(u: L) -> L {
    let margin = 0.5 * L::EPSILON;
    u.max(L::lit(margin)).min(L::lit(1.0 - margin))
}

/// What is left of `u` after a choice, the first part for `u` in `[0, share)`: its place there, or in `[share, 1]`, as a
/// number in the unit interval.
#[inline(always)]
fn left_over<L: Lane>(u: L, share: L, is_first: L::Mask) -> L {
    let (part, whole) = branch!(is_first, (u, share), (u - share, lit(1.0) - share));
    interior(part / whole)
}

/// Share of the cap's solid angle that lies above the horizon.
///
/// By Gauss and Bonnet the crescent has the solid angle `2 (acos kappa - v acos e)`. With `acos x = sin^3 H + sin x` and
/// `1 - v = s^2 / (1 + v)` every difference in it divides out: over the whole cap's it is
/// `tau^3 (1 + v)/pi [kappa m H[kappa, e] + (H(e) (m - kappa^2) + kappa) / X^2]` with `m = (1 - t_x)/s^2 = tau^2 / (X^2 (1 + t_x))`.
#[inline(always)]
fn share_above<L: Lane>(cap: &Cap<L>) -> L {
    let one = L::lit(1.0);
    let centre_above = L::lit(0.0).lt(cap.elevation_sin);
    let crescent_share = branch!(
        cap.crescent.exists(),
        {
            let c = &cap.crescent;
            let inv_x2 = lit(1.0) / (cap.elevation_cos * cap.elevation_cos);
            let m = c.tau * c.tau * inv_x2 / (lit(1.0) + c.t_x);
            let (_, difference) = shape_and_difference(c.kappa, c.cut);
            let bracket =
                (c.kappa * m).fma(difference, c.shape_cut().fma(m - c.kappa * c.kappa, c.kappa) * inv_x2);
            let share = c.tau * c.tau * c.tau * (cap.radius_cos + lit(1.0)) * bracket * lit(1.0 / PI);
            share.max(L::lit(0.0)).min(L::lit(0.5))
        },
        L::lit(0.0)
    );
    L::select(centre_above, one - crescent_share, crescent_share)
}
