//! The published method, for comparison only: Peters and Dachsbacher 2019 with the formulas as their supplement has
//! them, in single precision and with the platform's acos, asin and pow, as their code has. It has the weaknesses that it has:
//! differences that cancel, and an inverse of the segment's area by a quintic in the area. (Theirs is not in the supplement; this
//! one was fitted for the relative error of the height, 9e-4.) With `CUBE_ROOT` its pow is the library's cube root, which leaves
//! the rest of the method alone to be compared.

// For the library's cube root, which is not public.
#[allow(dead_code, unused_imports)]
#[path = "../src/math.rs"]
mod math;

use glam::Vec3;
use math::two_thirds_power;
use std::f32::consts::{FRAC_PI_2, PI};

/// A prepared cap. Symbols are the paper's.
#[derive(Clone, Copy)]
pub struct Published {
    normal: Vec3,
    tangent: Vec3,
    sideways: Vec3,
    r_x: f32,
    r_y: f32,
    r_z: f32,
    c_x: f32,
    c_z: f32,
    t_x: f32,
    t_y: f32,
    case: u32,
    /// Area of the cut disk (cases 2 and 3) and of the ellipse or what is left of it (cases 1 and 2).
    disk_area: f32,
    ellipse_area: f32,
    /// Area of the unit disk's part that the ellipse is made of.
    kept: f32,
}

/// Height over `area^(2/3)` of a segment of the unit disk, ascending.
const QUINTIC: [f32; 6] = [0.655_748_3, 0.109_208_28, -0.201_337_03, 0.291_167, -0.188_769_8, 0.045_058_8];

/// x of the chord that cuts off this area.
#[inline(always)]
fn chord<const CUBE_ROOT: bool>(area: f32) -> f32 {
    let near = area.min(PI - area).max(0.0);
    let quintic = QUINTIC.iter().rev().fold(0.0_f32, |value, &c| value.mul_add(near, c));
    let power = if CUBE_ROOT { two_thirds_power(near) } else { near.powf(2.0 / 3.0) };
    let x = 1.0 - power * quintic;
    if area < FRAC_PI_2 {
        x
    } else {
        -x
    }
}

impl Published {
    #[inline(always)]
    pub fn new(normal: Vec3, centre: Vec3, radius: f32) -> Self {
        let inv_d = 1.0 / centre.dot(centre).sqrt();
        let w = centre * inv_d;
        let z = normal.dot(w);
        let u = 1.0 / (1.0 - z * z).sqrt();
        let tangent = (w - normal * z) * u;
        let sideways = normal.cross(tangent);
        let r_y = radius * inv_d;
        let r_x = z * r_y;
        let x = tangent.dot(w);
        let r_z = x * r_y;
        let v = (1.0 - r_y * r_y).sqrt();
        let (c_x, c_z) = (v * x, v * z);
        let mut cap = Self {
            normal,
            tangent,
            sideways,
            r_x,
            r_y,
            r_z,
            c_x,
            c_z,
            t_x: 0.0,
            t_y: 0.0,
            case: 1,
            disk_area: 0.0,
            ellipse_area: PI * r_x * r_y,
            kept: PI,
        };
        if z >= r_y {
            return cap;
        }
        cap.t_x = v * u;
        cap.t_y = (1.0 - cap.t_x * cap.t_x).sqrt();
        cap.disk_area = cap.t_x.acos() - cap.t_x * cap.t_y;
        if z > 0.0 {
            cap.case = 2;
            let end = (cap.t_x - c_x) / r_x;
            cap.kept = FRAC_PI_2 + end.asin() + end * (1.0 - end * end).sqrt();
            cap.ellipse_area = cap.kept * r_x * r_y;
        } else {
            cap.case = if z > -r_y { 3 } else { 4 };
        }
        cap
    }

    /// A direction and its density with respect to solid angle.
    #[inline(always)]
    pub fn sample<const CUBE_ROOT: bool>(&self, u0: f32, u1: f32) -> (Vec3, f32) {
        let across = u1.mul_add(2.0, -1.0);
        let (x, y, z, density);
        if self.case == 3 {
            let d_x = chord::<CUBE_ROOT>(u0 * self.disk_area);
            let d_y = across * (1.0 - d_x * d_x).max(0.0).sqrt();
            let d_z = (1.0 - d_x * d_x - d_y * d_y).max(0.0).sqrt();
            let stretch = (self.c_z + self.r_z) / self.t_y;
            z = d_z * stretch;
            let from_centre = z - self.c_z;
            let r_z2 = self.r_z * self.r_z;
            let width = self.r_y
                * ((r_z2 - from_centre * from_centre) / (r_z2 * (self.t_y * self.t_y - d_z * d_z))).sqrt();
            y = d_y * width;
            x = (1.0 - y * y - z * z).max(0.0).sqrt();
            density = x / (stretch * stretch * self.disk_area * d_x * width);
        } else {
            let total = self.ellipse_area + self.disk_area;
            let area = u0 * total;
            if area < self.ellipse_area || self.case == 1 {
                let xi = -chord::<CUBE_ROOT>(area * self.kept / self.ellipse_area);
                x = self.r_x.mul_add(xi, self.c_x);
                y = across * self.r_y * (1.0 - xi * xi).max(0.0).sqrt();
            } else {
                x = chord::<CUBE_ROOT>(total - area);
                y = across * (1.0 - x * x).max(0.0).sqrt();
            }
            z = (1.0 - x * x - y * y).max(0.0).sqrt();
            density = 1.0 / total;
        }
        (self.tangent * x + self.sideways * y + self.normal * z, density * z)
    }
}
