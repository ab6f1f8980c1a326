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
//! batch.sample([&[0.1, 0.2, 0.3], &[0.6, 0.5, 0.4]], Samples { direction, density, ..Samples::default() });
//! assert!(pdf.iter().all(|&pdf| pdf > 0.0) && x[2] < 0.0);
//! ```
//!
//! Every array has one number for each point, and every number is the one, to the bit, that [`Sampler`] gives for the point
//! alone: neither the CPU nor the length of the arrays nor the place in them matters. Where [`Sampler::prepare`] would refuse,
//! or the other input is none (a random number outside \[0, 1\], a direction that is not of unit length), there are zeros; a
//! density of zero in a sample says so, as a sample that exists has a positive one. Arrays may begin at any address. Nothing is
//! allocated, and no thread is started: give each thread a part of the arrays.
//!
//! The radius is an array, too, though often all points see one light: where each point chooses its own, it is needed, and where
//! they do not, the array is filled once for all batches.

pub use crate::lane::packet::arrays::Instructions;

use crate::lane::packet::arrays::{run_slices, Kernel};
use crate::lane::Lane;
use crate::offset::Offset;
use crate::prepare::{is_offset, is_unit};
use crate::sampling::{Density, Sample, Sampler, Strategy};
use crate::vec3::Vec3;

/// Spheres as seen from points, one for each element of the arrays: what [`Sampler::prepare`] is given.
#[derive(Clone, Copy, Debug)]
pub struct Batch<'a> {
    /// How directions are distributed, for all points.
    pub strategy: Strategy<f32>,
    /// Unit normals of the surfaces, or zero.
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

impl Batch<'_> {
    /// [`Sampler::sample`] for each point, with the two random numbers that `u` has for it.
    ///
    /// # Panics
    /// If the arrays, the batch's own included, differ in length.
    pub fn sample(&self, u: [&[f32]; 2], samples: Samples<'_>) {
        self.sample_with(Instructions::widest(), u, samples);
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
    pub fn pdf(&self, offset: Offset<&[f32]>, densities: Densities<'_>) {
        self.pdf_with(Instructions::widest(), offset, densities);
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
    pub fn pdf_direction(&self, direction: Vec3<&[f32]>, densities: Densities<'_>) {
        self.pdf_direction_with(Instructions::widest(), direction, densities);
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
    pub fn pdf_on_sphere(&self, direction: Vec3<&[f32]>, densities: Densities<'_>) {
        self.pdf_on_sphere_with(Instructions::widest(), direction, densities);
    }
}

/// The same by given instructions, for tests and benches.
///
/// # Panics
/// If this CPU does not have them.
#[doc(hidden)]
#[allow(missing_docs)] // as above
impl Batch<'_> {
    pub fn sample_with(&self, instructions: Instructions, [u0, u1]: [&[f32]; 2], samples: Samples<'_>) {
        let [nx, ny, nz, cx, cy, cz, radius] = self.points();
        let inputs = [nx, ny, nz, cx, cy, cz, radius, u0, u1];
        run_slices::<SampleKernel, 9, 12>(instructions, self.strategy, inputs, sample_numbers(samples));
    }

    pub fn pdf_with(&self, instructions: Instructions, offset: Offset<&[f32]>, densities: Densities<'_>) {
        self.densities::<PdfKernel>(instructions, [offset.zenith, offset.side, offset.cosine], densities);
    }

    pub fn pdf_direction_with(
        &self,
        instructions: Instructions,
        direction: Vec3<&[f32]>,
        densities: Densities<'_>,
    ) {
        self.densities::<PdfDirectionKernel>(instructions, direction.into(), densities);
    }

    pub fn pdf_on_sphere_with(
        &self,
        instructions: Instructions,
        direction: Vec3<&[f32]>,
        densities: Densities<'_>,
    ) {
        self.densities::<PdfOnSphereKernel>(instructions, direction.into(), densities);
    }

    fn densities<K: Kernel<10, 2>>(
        &self,
        instructions: Instructions,
        [x, y, z]: [&[f32]; 3],
        densities: Densities<'_>,
    ) {
        let [nx, ny, nz, cx, cy, cz, radius] = self.points();
        let inputs = [nx, ny, nz, cx, cy, cz, radius, x, y, z];
        run_slices::<K, 10, 2>(instructions, self.strategy, inputs, density_numbers(densities));
    }

    fn points(&self) -> [&[f32]; 7] {
        let Self { normal, centre, radius, .. } = self;
        [normal.x, normal.y, normal.z, centre.x, centre.y, centre.z, radius]
    }
}

/// The sampler of a point, given by seven numbers, and where there is one.
#[inline(always)]
fn sampler<L: Lane>(
    strategy: Strategy<L>,
    [nx, ny, nz, cx, cy, cz, radius]: [L; 7],
) -> (Sampler<L>, L::Mask) {
    Sampler::prepare_where_possible(strategy, Vec3::new(nx, ny, nz), Vec3::new(cx, cy, cz), radius)
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

/// Zeros where the mask is false.
#[inline(always)]
fn or_zeros<L: Lane, const N: usize>(mask: L::Mask, mut numbers: [L; N]) -> [L; N] {
    for number in &mut numbers {
        *number = L::select(mask, *number, L::lit(0.0));
    }
    numbers
}

/// [`Sampler::sample`]: a point and two random numbers give a sample.
pub(crate) struct SampleKernel;

impl Kernel<9, 12> for SampleKernel {
    #[inline(always)]
    fn run<L: Lane>(strategy: Strategy<L>, [nx, ny, nz, cx, cy, cz, radius, u0, u1]: [L; 9]) -> [L; 12] {
        let (sampler, is_sampled) = sampler(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let (zero, one) = (L::lit(0.0), L::lit(1.0));
        let are_numbers = zero.le(u0) & u0.le(one) & zero.le(u1) & u1.le(one);
        or_zeros(is_sampled & are_numbers, sample_numbers(sampler.sample(u0, u1)))
    }
}

/// [`Sampler::pdf`]: a point and an offset give a density.
pub(crate) struct PdfKernel;

impl Kernel<10, 2> for PdfKernel {
    #[inline(always)]
    fn run<L: Lane>(strategy: Strategy<L>, [nx, ny, nz, cx, cy, cz, radius, x, y, z]: [L; 10]) -> [L; 2] {
        let (sampler, is_sampled) = sampler(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let offset = Offset { zenith: x, side: y, cosine: z };
        or_zeros(is_sampled & is_offset(offset), density_numbers(sampler.pdf(offset)))
    }
}

/// [`Sampler::pdf`] of [`Sampler::offset`]: a point and a direction give a density.
pub(crate) struct PdfDirectionKernel;

impl Kernel<10, 2> for PdfDirectionKernel {
    #[inline(always)]
    fn run<L: Lane>(strategy: Strategy<L>, [nx, ny, nz, cx, cy, cz, radius, x, y, z]: [L; 10]) -> [L; 2] {
        let (sampler, is_sampled) = sampler(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let direction = Vec3::new(x, y, z);
        let density = sampler.pdf(sampler.offset(direction));
        or_zeros(is_sampled & is_unit(direction), density_numbers(density))
    }
}

/// [`Sampler::pdf_on_sphere`], likewise.
pub(crate) struct PdfOnSphereKernel;

impl Kernel<10, 2> for PdfOnSphereKernel {
    #[inline(always)]
    fn run<L: Lane>(strategy: Strategy<L>, [nx, ny, nz, cx, cy, cz, radius, x, y, z]: [L; 10]) -> [L; 2] {
        let (sampler, is_sampled) = sampler(strategy, [nx, ny, nz, cx, cy, cz, radius]);
        let direction = Vec3::new(x, y, z);
        let density = sampler.pdf_on_sphere(sampler.offset(direction));
        or_zeros(is_sampled & is_unit(direction), density_numbers(density))
    }
}
