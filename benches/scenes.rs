//! What is sampled: caps in random orientation, case by case and in a scene's mix.

/// The generator's first state.
pub const SEED: u64 = 1;

/// Caps of a set. Their samplers (256 bytes each in f32) stay in the second-level cache, as those of a renderer's wavefront would.
pub const CAPS: usize = 512;

#[derive(Clone, Copy)]
pub struct Scene {
    pub normal: [f32; 3],
    pub centre: [f32; 3],
    pub radius: f32,
}

/// splitmix64, 24 bits of it.
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 40) as f32 / 16_777_216.0
    }

    fn direction(&mut self) -> glam::Vec3 {
        let z = 2.0 * self.unit() - 1.0;
        let phi = std::f32::consts::TAU * self.unit();
        let r = (1.0 - z * z).sqrt();
        glam::Vec3::new(r * phi.cos(), r * phi.sin(), z)
    }
}

/// A cap with r/d uniform in [0.02, 0.9) in a random orientation; Z/s uniform in the case.
fn scene(case: u32, random: &mut Random) -> Scene {
    let s = 0.02 + 0.88 * random.unit();
    let z = match case {
        1 => s + (0.999 - s) * random.unit(),
        2 => s * (0.001 + 0.998 * random.unit()),
        _ => -s * (0.001 + 0.998 * random.unit()),
    };
    let normal = random.direction();
    let tangent = normal.cross(random.direction()).normalize();
    let centre = (normal * z + tangent * (1.0 - z * z).sqrt()) * (0.5 + 2.0 * random.unit());
    Scene { normal: normal.into(), centre: centre.into(), radius: s * centre.length() }
}

/// Sets of caps by name. The mix has 53 % of case 1, 24 % of case 2 and 23 % of case 3, in no order: what a point of a room sees of
/// a light.
pub fn sets(random: &mut Random) -> Vec<(&'static str, Vec<Scene>)> {
    let mut sets = Vec::new();
    for (name, case) in [("case 1", 1), ("case 2", 2), ("case 3", 3)] {
        sets.push((name, (0..CAPS).map(|_| scene(case, random)).collect()));
    }
    let mixed = |_| {
        let choice = random.unit();
        scene(
            if choice < 0.53 {
                1
            } else if choice < 0.77 {
                2
            } else {
                3
            },
            random,
        )
    };
    sets.push(("mix", (0..CAPS).map(mixed).collect()));
    sets
}
