//! Several lights: one is chosen at each point by what each can give to it, and then sampled.
//!
//! ```
//! use spherecap::{lights::Lights, Receiver, Sampler, Vec3};
//!
//! // Three lights over a floor; the strength is the radiance.
//! let (x, y, z) = ([0.0, 4.0, -3.0_f32], [0.0, 1.0, 2.0], [2.0, 1.5, 3.0]);
//! let (radius, strength) = ([0.5, 0.3, 1.0], [1.0, 20.0, 5.0]);
//! let lights = Lights { centre: Vec3::new(&x[..], &y, &z), radius: &radius, strength: &strength };
//!
//! let (floor, point) = (Receiver::new([0.0, 0.0, 1.0]), [0.5, 0.0, 0.0]);
//! let mut importances = [0.0; 3];
//! let total = lights.importances(floor, point, &mut importances)?;
//! let choice = total.choose(&importances, 0.05, 0.4);
//! let i = choice.index;
//! let centre = [x[i] - point[0], y[i] - point[1], z[i] - point[2]];
//! let sample = Sampler::prepare(floor, centre, radius[i])?.sample(choice.rest, 0.7);
//! // The density of this light's direction; that of any other light costs no more loop.
//! let density = choice.probability * sample.density.solid_angle;
//! assert_eq!(choice.probability, total.probability(importances[i], 0.05));
//!
//! // Nothing is hidden here, and the estimate of the irradiance is all but free of noise.
//! let estimate = strength[i] * sample.offset.cosine / density;
//! let exact = std::f32::consts::PI * total.sum;
//! assert!((estimate / exact - 1.0).abs() < 0.1);
//! # Ok::<(), spherecap::Refusal>(())
//! ```
//!
//! A light that gives less than another is chosen less often, and its density is its own times the probability of the choice: it is
//! exact, so that occlusion and multiple importance sampling are as with one light. Choice and sample are apart: importances are
//! plain numbers, in the unit irradiance over pi, to which those of other kinds of light can be added, and a renderer may choose
//! by a tree of its own.

pub use crate::choice::{Choice, Total};

use crate::importance::importance_and_distance;
use crate::input::{receiver_refusal, unit_or_zero, Refusal};
use crate::lane::packet::arrays::{run_slices, Instructions, Kernel};
use crate::lane::{Broadcast, Lane};
use crate::strategy::{Receiver, Strategy};
use crate::vec3::Vec3;

/// The lights of a scene, one for each element of the arrays.
#[derive(Clone, Copy, Debug)]
pub struct Lights<'a> {
    /// Their centres, in the space of the points.
    pub centre: Vec3<&'a [f32]>,
    /// Their radii, in the same unit of length.
    pub radius: &'a [f32],
    /// Their radiances, in any unit: the luminance, say. Twice as much for one that shall be chosen twice as often.
    pub strength: &'a [f32],
}

impl Lights<'_> {
    /// [`Receiver::importance`] of each light at a point, by the widest instructions that the CPU has, and what choosing needs to
    /// know of all. Nothing is allocated. A light that is no light (see there) gets 0.
    ///
    /// Centres are taken relative to the point in single precision: as `Sampler::prepare` wants them.
    ///
    /// # Errors
    /// [`Refusal::Defensive`] and [`Refusal::Normal`]; then nothing is stored.
    ///
    /// # Panics
    /// If the arrays, the lights' own included, differ in length.
    pub fn importances(
        &self,
        receiver: Receiver<f32>,
        point: impl Into<[f32; 3]>,
        importances: &mut [f32],
    ) -> Result<Total, Refusal> {
        self.importances_with(Instructions::widest(), receiver, point.into(), importances)
    }

    /// The same by given instructions, for tests and benches.
    ///
    /// # Panics
    /// If this CPU does not have them.
    #[doc(hidden)]
    pub fn importances_with(
        &self,
        instructions: Instructions,
        receiver: Receiver<f32>,
        point: [f32; 3],
        importances: &mut [f32],
    ) -> Result<Total, Refusal> {
        let kernel = LightsKernel::new(receiver, point)?;
        let Self { centre, radius, strength } = *self;
        let inputs = [centre.x, centre.y, centre.z, radius, strength];
        run_slices(kernel, instructions, receiver.strategy, inputs, [Some(&mut *importances)]);
        Ok(Total::of(importances))
    }
}

/// [`Receiver::importance`] at one point: a light gives a number.
#[derive(Clone, Copy)]
pub(crate) struct LightsKernel {
    normal: Vec3<f32>,
    point: Vec3<f32>,
}

impl LightsKernel {
    #[inline]
    pub(crate) fn new(receiver: Receiver<f32>, point: [f32; 3]) -> Result<Self, Refusal> {
        match receiver_refusal(&receiver) {
            Some(refusal) => Err(refusal),
            None => Ok(Self { normal: receiver.normal, point: point.into() }),
        }
    }
}

impl Kernel<5, 1> for LightsKernel {
    #[inline(always)]
    fn run<L: Lane>(self, strategy: Strategy<L>, [x, y, z, radius, strength]: [L; 5]) -> ([L; 1], L::Mask) {
        let (unit, point) = (unit_or_zero(self.normal.broadcast::<L>()), self.point.broadcast::<L>());
        let centre = Vec3::new(x - point.x, y - point.y, z - point.z);
        let (importance, _) = importance_and_distance(unit, strategy, centre, radius, strength);
        // A light that is none is no error.
        ([importance], L::lit(0.0).lt(L::lit(0.0)))
    }
}
