//! Many points at once: sampling and densities over arrays of numbers, by the widest instructions that the CPU has.
//!
//! ```
//! use spherecap::{batch::{Batch, Densities, Samples}, Strategy, Vec3};
//!
//! // A light of radius 1, seen from three points of a floor.
//! let (zeros, ones, centre_x) = ([0.0; 3], [1.0; 3], [3.0, 2.0, -2.0]);
//! let normal = Vec3::new(&zeros[..], &zeros, &ones);
//! let centre = Vec3::new(&centre_x[..], &zeros, &zeros);
//! let batch = Batch { strategy: Strategy::default(), normal, centre, radius: &ones };
//!
//! let [mut x, mut y, mut z, mut pdf] = [[0.0; 3]; 4];
//! let direction = Vec3::new(Some(&mut x[..]), Some(&mut y[..]), Some(&mut z[..]));
//! let density = Densities { solid_angle: Some(&mut pdf), ..Densities::default() };
//! // What is not asked for is not stored.
//! let u: [&[f32]; 2] = [&[0.1, 0.2, 0.3], &[0.6, 0.5, 0.4]];
//! let refused = batch.sample(u, Samples { direction, density, ..Samples::default() });
//! assert!(refused == 0 && pdf.iter().all(|&pdf| pdf > 0.0) && x[2] < 0.0);
//! ```
//!
//! Every array has one number for each point, and every number is the one, to the bit, that [`Sampler`] gives for the point
//! alone: neither the CPU nor the length of the arrays nor the place in them matters. Where [`Sampler::prepare`] would refuse,
//! or the other input is none (a direction that is not of unit length, an offset with a component outside \[-1, 1\]), there are
//! zeros; a density of zero in a sample says so, as a sample that exists has a positive one. Every function returns at how many
//! points that was because of bad input: not where a light is merely invisible, or a point inside it. Arrays may begin at any
//! address. Nothing is allocated, and no thread is started: give each thread a part of the arrays.
//!
//! The radius is an array, too, though often all points see one light: where each point chooses its own, it is needed, and where
//! they do not, the array is filled once for all batches.

pub use crate::lane::packet::arrays::Instructions;

use crate::importance::importance_and_distance;
use crate::input::{is_offset, is_unit, unit_or_zero, Input};
use crate::lane::packet::arrays::{run_slices, Kernel};
use crate::lane::{Broadcast, Lane, Mask};
use crate::offset::Offset;
use crate::sample::{Density, Sample};
use crate::sampling::Sampler;
use crate::strategy::Strategy;
use crate::vec3::Vec3;

/// Spheres as seen from points, one for each element of the arrays: what [`Sampler::prepare`] is given.
#[derive(Clone, Copy, Debug)]
pub struct Batch<'a> {
    /// How directions are distributed, for all points.
    pub strategy: Strategy<f32>,
    /// Normals of the surfaces, of any length, or zero: see [`Receiver`](crate::Receiver).
    pub normal: Vec3<&'a [f32]>,
    /// The spheres' centres, each relative to its point.
    pub centre: Vec3<&'a [f32]>,
    /// Their radii, in the same unit of length.
    pub radius: &'a [f32],
}

/// Arrays for the samples, each `None` if it is not wanted.
pub type Samples<'a> = Sample<Option<&'a mut [f32]>>;

/// Arrays for the densities, each `None` if it is not wanted.
pub type Densities<'a> = Density<Option<&'a mut [f32]>>;

/// Arrays for what is measured of each sphere, each `None` if it is not wanted.
#[derive(Debug, Default)]
pub struct Measures<'a> {
    /// [`Cap::solid_angle`](crate::Cap::solid_angle).
    pub solid_angle: Option<&'a mut [f32]>,
    /// [`Cap::projected_solid_angle`](crate::Cap::projected_solid_angle): the irradiance of an unoccluded sphere of radiance 1.
    pub projected_solid_angle: Option<&'a mut [f32]>,
}

impl Batch<'_> {
    /// [`Sampler::sample`] for each point, with the two random numbers that `u` has for it.
    ///
    /// # Panics
    /// If the arrays, the batch's own included, differ in length.
    pub fn sample(&self, u: [&[f32]; 2], samples: Samples<'_>) -> usize {
        self.sample_with(Instructions::widest(), u, samples)
    }

    /// [`Sampler::pdf`] of an offset for each point.
    ///
    /// ```
    /// # use spherecap::{batch::{Batch, Densities, Samples}, Offset, Strategy, Vec3};
    /// # let (zeros, ones, centre_x) = ([0.0; 2], [1.0; 2], [3.0, 2.0]);
    /// # let normal = Vec3::new(&zeros[..], &zeros, &ones);
    /// # let centre = Vec3::new(&centre_x[..], &zeros, &zeros);
    /// # let batch = Batch { strategy: Strategy::default(), normal, centre, radius: &ones };
    /// let [mut zenith, mut side, mut cosine, mut sampled, mut pdf] = [[0.0; 2]; 5];
    /// let offset = Offset { zenith: Some(&mut zenith[..]), side: Some(&mut side), cosine: Some(&mut cosine) };
    /// let density = Densities { solid_angle: Some(&mut sampled), ..Densities::default() };
    /// batch.sample([&[0.1, 0.2], &[0.6, 0.5]], Samples { offset, density, ..Samples::default() });
    ///
    /// let offset = Offset { zenith: &zenith[..], side: &side, cosine: &cosine };
    /// batch.pdf(offset, Densities { solid_angle: Some(&mut pdf), ..Densities::default() });
    /// assert_eq!(pdf, sampled);
    /// ```
    ///
    /// # Panics
    /// If the arrays, the batch's own included, differ in length.
    pub fn pdf(&self, offset: Offset<&[f32]>, densities: Densities<'_>) -> usize {
        self.pdf_with(Instructions::widest(), offset, densities)
    }

    /// [`Sampler::pdf`] of a unit direction for each point, to the precision of [`Sampler::offset`].
    ///
    /// ```
    /// # use spherecap::{batch::{Batch, Densities}, Strategy, Vec3};
    /// # let (zeros, ones, centre_x) = ([0.0; 2], [1.0; 2], [3.0, 2.0]);
    /// # let normal = Vec3::new(&zeros[..], &zeros, &ones);
    /// # let centre = Vec3::new(&centre_x[..], &zeros, &zeros);
    /// # let batch = Batch { strategy: Strategy::default(), normal, centre, radius: &ones };
    /// // Of two directions from a BSDF, one is towards the light.
    /// let direction = Vec3::new(&[0.96, 0.0][..], &[0.0, 0.0], &[0.28, 1.0]);
    /// let mut pdf = [0.0; 2];
    /// batch.pdf_direction(direction, Densities { solid_angle: Some(&mut pdf), ..Densities::default() });
    /// assert!(pdf[0] > 0.0 && pdf[1] == 0.0);
    /// ```
    ///
    /// # Panics
    /// If the arrays, the batch's own included, differ in length.
    pub fn pdf_direction(&self, direction: Vec3<&[f32]>, densities: Densities<'_>) -> usize {
        self.pdf_direction_with(Instructions::widest(), direction, densities)
    }

    /// [`Sampler::pdf_on_sphere`] of a unit direction for each point: one that is known to point at the sphere.
    ///
    /// ```
    /// # use spherecap::{batch::{Batch, Densities}, Strategy, Vec3};
    /// # let (zeros, ones, centre_x) = ([0.0; 2], [1.0; 2], [3.0, 2.0]);
    /// # let normal = Vec3::new(&zeros[..], &zeros, &ones);
    /// # let centre = Vec3::new(&centre_x[..], &zeros, &zeros);
    /// # let batch = Batch { strategy: Strategy::default(), normal, centre, radius: &ones };
    /// // For multiple importance sampling: in these directions, rays have hit the light.
    /// let direction = Vec3::new(&[0.96, 0.96][..], &[0.0, 0.224], &[0.28, 0.168]);
    /// let mut pdf = [0.0; 2];
    /// batch.pdf_on_sphere(direction, Densities { projected_solid_angle: Some(&mut pdf), ..Densities::default() });
    /// assert!(pdf.iter().all(|&pdf| pdf > 0.0));
    /// ```
    ///
    /// # Panics
    /// If the arrays, the batch's own included, differ in length.
    pub fn pdf_on_sphere(&self, direction: Vec3<&[f32]>, densities: Densities<'_>) -> usize {
        self.pdf_on_sphere_with(Instructions::widest(), direction, densities)
    }

    /// What is measured of each sphere, where [`Sampler::prepare`] succeeds; zeros elsewhere.
    ///
    /// ```
    /// # use spherecap::{batch::{Batch, Measures}, Strategy, Vec3};
    /// # let (zeros, ones) = ([0.0; 2], [1.0; 2]);
    /// # let normal = Vec3::new(&zeros[..], &zeros, &ones);
    /// // One light at the zenith, one below the horizon.
    /// let centre = Vec3::new(&zeros[..], &zeros, &[2.0, -2.0]);
    /// let batch = Batch { strategy: Strategy::default(), normal, centre, radius: &ones };
    /// let mut irradiance = [0.0; 2];
    /// batch.measures(Measures { projected_solid_angle: Some(&mut irradiance), ..Measures::default() });
    /// assert!((irradiance[0] - 0.25 * std::f32::consts::PI).abs() < 1e-6 && irradiance[1] == 0.0);
    /// ```
    ///
    /// # Panics
    /// If the arrays, the batch's own included, differ in length.
    pub fn measures(&self, measures: Measures<'_>) -> usize {
        self.measures_with(Instructions::widest(), measures)
    }

    /// [`Receiver::importance`](crate::Receiver::importance) for each point, of a light whose strength `strength` has for it. Strengths that are negative or not
    /// finite are bad input, too.
    ///
    /// ```
    /// # use spherecap::{batch::Batch, Strategy, Vec3};
    /// # let (zeros, ones) = ([0.0; 2], [1.0; 2]);
    /// # let normal = Vec3::new(&zeros[..], &zeros, &ones);
    /// // One light at the zenith, one below the horizon.
    /// let centre = Vec3::new(&zeros[..], &zeros, &[2.0, -2.0]);
    /// let batch = Batch { strategy: Strategy::default(), normal, centre, radius: &ones };
    /// let mut importances = [0.0; 2];
    /// assert_eq!(batch.importances(&[8.0, 8.0], &mut importances), 0);
    /// assert!((importances[0] - 2.0).abs() < 1e-5 && importances[1] == 0.0);
    /// ```
    ///
    /// # Panics
    /// If the arrays, the batch's own included, differ in length.
    pub fn importances(&self, strength: &[f32], importances: &mut [f32]) -> usize {
        self.importances_with(Instructions::widest(), strength, importances)
    }
}

impl Sampler<f32> {
    /// [`Sampler::sample`] for many pairs of random numbers: for resampling, or many shadow rays at one point.
    ///
    /// ```
    /// use spherecap::{batch::Samples, Receiver, Sampler, Vec3};
    ///
    /// let sampler = Sampler::prepare(Receiver::new([0.0, 0.0, 1.0]), [2.0, 0.0, 0.5], 1.0)?;
    /// let u: [&[f32]; 2] = [&[0.1, 0.3, 0.5, 0.7], &[0.4, 0.8, 0.2, 0.6]];
    /// let mut z = [0.0; 4];
    /// let direction = Vec3::new(None, None, Some(&mut z[..]));
    /// sampler.sample_many(u, Samples { direction, ..Samples::default() });
    /// assert_eq!(z[2], sampler.sample(0.5, 0.2).direction.z);
    /// # Ok::<(), spherecap::Refusal>(())
    /// ```
    ///
    /// # Panics
    /// If the arrays differ in length.
    pub fn sample_many(&self, u: [&[f32]; 2], samples: Samples<'_>) {
        self.sample_many_with(Instructions::widest(), u, samples);
    }

    /// The same by given instructions, for tests and benches.
    ///
    /// # Panics
    /// If this CPU does not have them.
    #[doc(hidden)]
    pub fn sample_many_with(&self, instructions: Instructions, u: [&[f32]; 2], samples: Samples<'_>) {
        let kernel = ManyKernel { sampler: *self };
        run_slices(kernel, instructions, Strategy::default(), u, sample_numbers(samples));
    }
}

/// The same by given instructions, for tests and benches.
///
/// # Panics
/// If this CPU does not have them.
#[doc(hidden)]
#[allow(missing_docs)] // as above
impl Batch<'_> {
    pub fn sample_with(
        &self,
        instructions: Instructions,
        [u0, u1]: [&[f32]; 2],
        samples: Samples<'_>,
    ) -> usize {
        let [nx, ny, nz, cx, cy, cz, radius] = self.points();
        let inputs = [nx, ny, nz, cx, cy, cz, radius, u0, u1];
        run_slices(SampleKernel, instructions, self.strategy, inputs, sample_numbers(samples))
    }

    pub fn pdf_with(
        &self,
        instructions: Instructions,
        offset: Offset<&[f32]>,
        densities: Densities<'_>,
    ) -> usize {
        self.densities(PdfKernel, instructions, [offset.zenith, offset.side, offset.cosine], densities)
    }

    pub fn pdf_direction_with(
        &self,
        instructions: Instructions,
        direction: Vec3<&[f32]>,
        densities: Densities<'_>,
    ) -> usize {
        self.densities(PdfDirectionKernel, instructions, direction.into(), densities)
    }

    pub fn pdf_on_sphere_with(
        &self,
        instructions: Instructions,
        direction: Vec3<&[f32]>,
        densities: Densities<'_>,
    ) -> usize {
        self.densities(PdfOnSphereKernel, instructions, direction.into(), densities)
    }

    fn densities(
        &self,
        kernel: impl Kernel<10, 2>,
        instructions: Instructions,
        [x, y, z]: [&[f32]; 3],
        densities: Densities<'_>,
    ) -> usize {
        let [nx, ny, nz, cx, cy, cz, radius] = self.points();
        let inputs = [nx, ny, nz, cx, cy, cz, radius, x, y, z];
        run_slices(kernel, instructions, self.strategy, inputs, density_numbers(densities))
    }

    pub fn measures_with(&self, instructions: Instructions, measures: Measures<'_>) -> usize {
        let Measures { solid_angle, projected_solid_angle } = measures;
        let outputs = [solid_angle, projected_solid_angle];
        run_slices(MeasuresKernel, instructions, self.strategy, self.points(), outputs)
    }

    pub fn importances_with(
        &self,
        instructions: Instructions,
        strength: &[f32],
        importances: &mut [f32],
    ) -> usize {
        let [nx, ny, nz, cx, cy, cz, radius] = self.points();
        let inputs = [nx, ny, nz, cx, cy, cz, radius, strength];
        run_slices(ImportanceKernel, instructions, self.strategy, inputs, [Some(importances)])
    }

    fn points(&self) -> [&[f32]; 7] {
        let Self { normal, centre, radius, .. } = self;
        [normal.x, normal.y, normal.z, centre.x, centre.y, centre.z, radius]
    }
}

impl<L: Lane> Input<L> {
    /// What a kernel gives: the numbers that another function made of a sampler (of whose cap the distance is told), or zeros where
    /// there is none or the rest of the input is bad; and where any input is.
    #[inline(always)]
    fn results<const N: usize>(
        &self,
        (distance, is_sampled): (L, L::Mask),
        is_rest_good: L::Mask,
        mut numbers: [L; N],
    ) -> ([L; N], L::Mask) {
        let is_good = is_sampled & is_rest_good;
        for number in &mut numbers {
            *number = L::select(is_good, *number, L::lit(0.0));
        }
        // Where there is a sampler, its input is good.
        let is_bad = if is_good.all() { !is_good } else { !is_rest_good | self.is_bad(distance) };
        (numbers, is_bad)
    }
}

/// The numbers of a sample, in the order of its fields.
#[inline(always)]
pub(crate) fn sample_numbers<T>(sample: Sample<T>) -> [T; 12] {
    let Sample { offset, direction, distance, normal, density } = sample;
    let [solid_angle, projected_solid_angle] = density_numbers(density);
    [
        offset.zenith,
        offset.side,
        offset.cosine,
        direction.x,
        direction.y,
        direction.z,
        distance,
        normal.x,
        normal.y,
        normal.z,
        solid_angle,
        projected_solid_angle,
    ]
}

/// Those of a density.
#[inline(always)]
pub(crate) fn density_numbers<T>(density: Density<T>) -> [T; 2] {
    [density.solid_angle, density.projected_solid_angle]
}

/// [`Sampler::sample`]: a point and two random numbers give a sample.
#[derive(Clone, Copy)]
pub(crate) struct SampleKernel;

impl Kernel<9, 12> for SampleKernel {
    #[inline(always)]
    fn run<L: Lane>(
        self,
        strategy: Strategy<L>,
        [nx, ny, nz, cx, cy, cz, radius, u0, u1]: [L; 9],
    ) -> ([L; 12], L::Mask) {
        let point = Input::new(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let (sample, distance, is_sampled) = point.sample([u0, u1]);
        point.results((distance, is_sampled), always::<L>(), sample_numbers(sample))
    }
}

/// [`Sampler::sample`] of one sampler: two random numbers give a sample.
#[derive(Clone, Copy)]
pub(crate) struct ManyKernel {
    pub sampler: Sampler<f32>,
}

impl Kernel<2, 12> for ManyKernel {
    #[inline(always)]
    fn run<L: Lane>(self, _: Strategy<L>, [u0, u1]: [L; 2]) -> ([L; 12], L::Mask) {
        let sample = self.sampler.broadcast::<L>().sample(u0, u1);
        (sample_numbers(sample), !always::<L>())
    }
}

/// [`Sampler::pdf`]: a point and an offset give a density.
#[derive(Clone, Copy)]
pub(crate) struct PdfKernel;

impl Kernel<10, 2> for PdfKernel {
    #[inline(always)]
    fn run<L: Lane>(
        self,
        strategy: Strategy<L>,
        [nx, ny, nz, cx, cy, cz, radius, zenith, side, cosine]: [L; 10],
    ) -> ([L; 2], L::Mask) {
        let point = Input::new(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let (sampler, is_sampled) = point.prepare();
        let offset = Offset { zenith, side, cosine };
        let density = sampler.pdf(offset);
        point.results((sampler.cap().distance(), is_sampled), is_offset(offset), density_numbers(density))
    }
}

/// [`Sampler::pdf_direction`]: a point and a direction give a density.
#[derive(Clone, Copy)]
pub(crate) struct PdfDirectionKernel;

impl Kernel<10, 2> for PdfDirectionKernel {
    #[inline(always)]
    fn run<L: Lane>(
        self,
        strategy: Strategy<L>,
        [nx, ny, nz, cx, cy, cz, radius, x, y, z]: [L; 10],
    ) -> ([L; 2], L::Mask) {
        let point = Input::new(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let (sampler, is_sampled) = point.prepare();
        let direction = Vec3::new(x, y, z);
        let density = sampler.pdf_direction(direction);
        point.results((sampler.cap().distance(), is_sampled), is_unit(direction), density_numbers(density))
    }
}

/// [`Sampler::pdf_on_sphere`], likewise.
#[derive(Clone, Copy)]
pub(crate) struct PdfOnSphereKernel;

impl Kernel<10, 2> for PdfOnSphereKernel {
    #[inline(always)]
    fn run<L: Lane>(
        self,
        strategy: Strategy<L>,
        [nx, ny, nz, cx, cy, cz, radius, x, y, z]: [L; 10],
    ) -> ([L; 2], L::Mask) {
        let point = Input::new(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let direction = Vec3::new(x, y, z);
        let (density, distance, is_sampled) = point.pdf(direction);
        point.results((distance, is_sampled), is_unit(direction), density_numbers(density))
    }
}

/// A point gives the solid angle and the projected one.
#[derive(Clone, Copy)]
pub(crate) struct MeasuresKernel;

impl Kernel<7, 2> for MeasuresKernel {
    #[inline(always)]
    fn run<L: Lane>(self, strategy: Strategy<L>, numbers: [L; 7]) -> ([L; 2], L::Mask) {
        let point = Input::new(strategy, numbers);
        let (sampler, is_sampled) = point.prepare();
        let cap = sampler.cap();
        let measures = [cap.solid_angle(), cap.projected_solid_angle()];
        point.results((sampler.cap().distance(), is_sampled), always::<L>(), measures)
    }
}

/// [`Receiver::importance`]: a point and a strength give a number.
#[derive(Clone, Copy)]
pub(crate) struct ImportanceKernel;

impl Kernel<8, 1> for ImportanceKernel {
    #[inline(always)]
    fn run<L: Lane>(
        self,
        strategy: Strategy<L>,
        [nx, ny, nz, cx, cy, cz, radius, strength]: [L; 8],
    ) -> ([L; 1], L::Mask) {
        let point = Input::new(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let unit = unit_or_zero(point.receiver.normal);
        let (importance, distance) =
            importance_and_distance(unit, strategy, point.centre, point.radius, strength);
        let is_strength = L::lit(0.0).le(strength) & strength.le(L::lit(L::MAX));
        ([importance], !is_strength | point.is_bad(distance))
    }
}

/// True.
#[inline(always)]
fn always<L: Lane>() -> L::Mask {
    L::lit(0.0).le(L::lit(0.0))
}
