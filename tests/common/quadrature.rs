//! The cap in its own coordinates: squared relative radius on the equal-area disk (Lambert's projection) and azimuth, both
//! over [0, 1). Cells of a grid in them have equal solid angles, however small the cap.

use super::{dot, Scene};
use spherecap::Offset;
use std::f64::consts::{PI, TAU};

/// How far the midpoint rules may be off in all: they are worst at the limb of a sphere that nearly touches, where
/// the solid angle is singular. Fifty thousand samples resolve about as much.
pub const QUADRATURE: f64 = 3e-3;

pub struct Cells {
    s: f64,
    v: f64,
    elevation: [f64; 2],
    pub rings: usize,
    pub sectors: usize,
}

impl Cells {
    pub fn new(scene: &Scene, rings: usize, sectors: usize) -> Self {
        let d2 = dot(scene.centre, scene.centre);
        let s = scene.radius / d2.sqrt();
        let z = dot(scene.normal, scene.centre) / d2.sqrt();
        let on_surface = scene.normal != [0.0; 3];
        let x = if on_surface { (1.0 - z * z).max(0.0).sqrt() } else { 0.0 };
        Self { s, v: ((1.0 - s) * (1.0 + s)).sqrt(), elevation: [x, z], rings, sectors }
    }

    pub fn len(&self) -> usize {
        self.rings * self.sectors
    }

    pub fn solid_angle(&self) -> f64 {
        TAU * self.s * self.s / (1.0 + self.v)
    }

    /// The cell of a sampled offset; in the outermost ring if rounding put it beyond the cap.
    pub fn index(&self, zenith: f64, side: f64) -> usize {
        let sin2 = zenith * zenith + side * side;
        let depth = sin2 / (1.0 + (1.0 - sin2).max(0.0).sqrt());
        let ring = depth * (1.0 + self.v) / (self.s * self.s) * self.rings as f64;
        let sector = (side.atan2(zenith) / TAU + 0.5) * self.sectors as f64;
        (ring as usize).min(self.rings - 1) * self.sectors + (sector as usize).min(self.sectors - 1)
    }

    fn offset(&self, rho2: f64, azimuth: f64) -> Offset<f64> {
        let depth = rho2 * self.s * self.s / (1.0 + self.v);
        let sin = (depth * (2.0 - depth)).sqrt();
        let phi = azimuth * TAU - PI;
        let [x, z] = self.elevation;
        let zenith = sin * phi.cos();
        Offset { zenith, side: sin * phi.sin(), cosine: z * (1.0 - depth) + x * zenith }
    }

    /// Probability of every cell by the midpoint rule, `fine` by `fine` points in each.
    pub fn probabilities(&self, fine: usize, pdf: impl Fn(Offset<f64>) -> f64) -> Vec<f64> {
        let (rings, sectors) = (self.rings * fine, self.sectors * fine);
        let weight = self.solid_angle() / (rings * sectors) as f64;
        let mut cells = vec![0.0; self.len()];
        for i in 0..rings {
            for j in 0..sectors {
                let at = |index: usize, count: usize| (index as f64 + 0.5) / count as f64;
                let offset = self.offset(at(i, rings), at(j, sectors));
                cells[i / fine * self.sectors + j / fine] += weight * pdf(offset);
            }
        }
        cells
    }
}

/// The part of a cut cap on the other side of the horizon than its centre, in coordinates that fit it however thin it is:
/// height over the horizon (by the square root of what is left to the crescent's top, where the width vanishes as a
/// square root), and the sideways position as an angle on its half width there
/// (`y = half width * sin angle`, which takes away the singularity of the solid angle `dy dz / x` where x vanishes).
pub struct CrescentCells {
    /// The elevation, positive and as if the crescent were above the horizon.
    x: f64,
    z: f64,
    v: f64,
    s: f64,
    /// -1 if the crescent is below the horizon.
    sign: f64,
    pub rows: usize,
    pub columns: usize,
}

impl CrescentCells {
    pub fn new(scene: &Scene, rows: usize, columns: usize) -> Self {
        let d2 = dot(scene.centre, scene.centre);
        let s = scene.radius / d2.sqrt();
        let z = dot(scene.normal, scene.centre) / d2.sqrt();
        let x = ((1.0 - z) * (1.0 + z)).sqrt();
        let sign = if z > 0.0 { -1.0 } else { 1.0 };
        Self { x, z: z.abs(), v: ((1.0 - s) * (1.0 + s)).sqrt(), s, sign, rows, columns }
    }

    fn rise(&self) -> f64 {
        (self.s - self.z) * (self.s + self.z) / (self.s * self.x + self.v * self.z)
    }

    /// Half width of the cap at this height: the boundary circle's, from the two heights where it vanishes.
    fn half_width(&self, height: f64) -> f64 {
        let (rise, depth) = (self.rise(), self.s * self.x + self.v * self.z);
        ((rise - height) * (depth + height)).max(0.0).sqrt() / self.x
    }

    /// The cell, or the last index for an offset on the other side of the horizon.
    pub fn index(&self, offset: Offset<f64>) -> usize {
        let height = offset.cosine * self.sign;
        if height <= 0.0 {
            return self.rows * self.columns;
        }
        let row = (1.0 - (1.0 - height / self.rise()).max(0.0).sqrt()) * self.rows as f64;
        let across = (offset.side / self.half_width(height)).clamp(-1.0, 1.0);
        let column = (across.asin() / PI + 0.5) * self.columns as f64;
        (row as usize).min(self.rows - 1) * self.columns + (column as usize).min(self.columns - 1)
    }

    /// Probability of every cell, by the midpoint rule, and of the rest.
    pub fn probabilities(&self, fine: usize, pdf: impl Fn(Offset<f64>) -> f64) -> Vec<f64> {
        let (rows, columns) = (self.rows * fine, self.columns * fine);
        let mut cells = vec![0.0; self.rows * self.columns + 1];
        for i in 0..rows {
            let [low, mid, high] = [0.0, 0.5, 1.0].map(|at| {
                let from_top = 1.0 - (i as f64 + at) / rows as f64;
                self.rise() * (1.0 - from_top * from_top)
            });
            let half_width = self.half_width(mid);
            for j in 0..columns {
                let angle = ((j as f64 + 0.5) / columns as f64 - 0.5) * PI;
                let side = half_width * angle.sin();
                // x^2 = 1 - z^2 - y^2, with the part that does not vanish first.
                let at_edge = ((1.0 - half_width) * (1.0 + half_width) - mid * mid).max(0.0);
                let x = (at_edge + (half_width * angle.cos()).powi(2)).sqrt();
                // Z x, the part of the offset that does not vanish, and X times the height: as in a mirrored frame.
                let zenith = (self.x * mid + self.z * x) * self.sign;
                let offset = Offset { zenith, side, cosine: mid * self.sign };
                let area = (high - low) * half_width * angle.cos() * PI / columns as f64 / x;
                cells[i / fine * self.columns + j / fine] += area * pdf(offset);
            }
        }
        let rest = 1.0 - cells.iter().sum::<f64>();
        assert!(rest > -QUADRATURE, "the density integrates to {} or more", 1.0 - rest);
        cells[self.rows * self.columns] = if rest > QUADRATURE { rest } else { 0.0 };
        cells
    }
}

/// Pearson's chi-square of counts against probabilities, as a standard normal deviate (Wilson and Hilferty). Cells are taken
/// by falling probability, the rare ones pooled until ten are expected.
pub fn chi_square_deviate(counts: &[u64], probabilities: &[f64]) -> f64 {
    let total: u64 = counts.iter().sum();
    let mut cells: Vec<(f64, f64)> =
        probabilities.iter().zip(counts).map(|(p, &n)| (p * total as f64, n as f64)).collect();
    cells.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (mut statistic, mut freedom, mut pool) = (0.0, -1.0, (0.0, 0.0));
    for (expected, observed) in cells {
        pool = (pool.0 + expected, pool.1 + observed);
        if pool.0 >= 10.0 {
            statistic += (pool.1 - pool.0).powi(2) / pool.0;
            freedom += 1.0;
            pool = (0.0, 0.0);
        }
    }
    // What is left expects fewer than ten: many more than that is a failure all the same.
    statistic += (pool.1 - pool.0).max(0.0).powi(2) / 10.0;
    let spread = 2.0 / (9.0 * freedom);
    ((statistic / freedom).cbrt() - (1.0 - spread)) / spread.sqrt()
}
