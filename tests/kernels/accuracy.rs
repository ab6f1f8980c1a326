//! `docs/accuracy.md` is what the kernels give. Remake it with `make accuracy`.
//!
//! Nothing in it depends on the machine: the kernels fuse what they say they fuse and call no platform's functions, and the inputs
//! are made by exact or correctly rounded operations.

use crate::common::distortion::errors;
use crate::common::strata::{scene, STRATA};
use crate::common::{reference_caps, widen, Random, Scene, TECHNIQUES};
use spherecap::{Hemispheres, Offset, Sampler, Scalar, Strategy, Technique};
use std::fmt::Write as _;
use std::{env, fs, path::Path};

/// Scenes per stratum and random numbers per scene.
const SCENES: usize = 400;
const NUMBERS: usize = 16;

/// Errors of one function in one group, with the input of the worst.
#[derive(Default)]
struct Errors {
    all: Vec<f64>,
    worst: f64,
    input: String,
}

impl Errors {
    fn add(&mut self, error: f64, input: impl Fn() -> String) {
        assert!(error.is_finite(), "{}", input());
        if error > self.worst || self.all.is_empty() {
            self.worst = error;
            self.input = input();
        }
        self.all.push(error);
    }

    /// Worst and median, with two significant digits.
    fn cells(&mut self) -> String {
        if self.all.is_empty() {
            return "| – | – ".to_owned();
        }
        self.all.sort_by(f64::total_cmp);
        format!("| {} | {} ", digits(self.worst), digits(self.all[self.all.len() / 2]))
    }
}

fn digits(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else {
        format!("{x:.1e}")
    }
}

/// Bits of f32 numbers: normal, centre, radius, and the random numbers if there are any.
fn bits(scene: &Scene, numbers: &[f32]) -> String {
    let scene = scene.normal.into_iter().chain(scene.centre).chain([scene.radius]).map(|x| x as f32);
    let words: Vec<String> =
        scene.chain(numbers.iter().copied()).map(|x| format!("{:08x}", x.to_bits())).collect();
    format!("`{}`", words.join(" "))
}

/// A function's table: for each group the errors in f32 and in f64.
struct Table {
    title: &'static str,
    text: &'static str,
    groups: Vec<(&'static str, [Errors; 2])>,
}

impl Table {
    fn new(title: &'static str, text: &'static str) -> Self {
        Self { title, text, groups: Vec::new() }
    }

    fn group(&mut self, name: &'static str) -> &mut [Errors; 2] {
        if let Some(i) = self.groups.iter().position(|(other, _)| *other == name) {
            return &mut self.groups[i].1;
        }
        self.groups.push((name, Default::default()));
        &mut self.groups.last_mut().expect("it was just pushed").1
    }

    fn print(&mut self, page: &mut String) {
        writeln!(page, "\n## {}\n\n{}\n", self.title, self.text).expect("strings grow");
        page.push_str("| group | inputs | f32 worst | median | f64 worst | median | worst f32 input |\n");
        page.push_str("|---|--:|--:|--:|--:|--:|---|\n");
        for (name, [single, double]) in &mut self.groups {
            let count = single.all.len().max(double.all.len());
            let cells = single.cells() + &double.cells();
            writeln!(page, "| {name} | {count} {cells}| {} |", single.input).expect("strings grow");
        }
    }
}

fn strategy<F: Scalar>(technique: Technique) -> Strategy<F> {
    Strategy { technique, hemispheres: Hemispheres::Front, defensive: F::lit(0.0) }
}

fn sampler<F: Scalar>(technique: Technique, scene: &Scene) -> Option<Sampler<F>> {
    scene.prepare(strategy(technique)).ok()
}

fn areas(page: &mut String) {
    let mut projected = Table::new(
        "Projected solid angle",
        "Relative error. The reference groups are against 25 digits; the strata are f32 against f64. The worst errors are those of \
         spheres, large or small, of which next to nothing is left above the horizon: with an oblique normal a centre's height is \
         known in f32 to about 2^-48 of its distance d, and the area goes with up to the 5/2 power of what is left, b = r + n·C. So \
         beside some 1e-6 an area is off by about 5/2 · 2^-48 d/b, and never by more than 7 times that, which matters where \
         b < 1e-8 d. (`tests/kernels/strata.rs` derives it, and holds spheres of every size to it.)",
    );
    let mut solid = Table::new("Solid angle", "Relative error, likewise.");
    for row in reference_caps() {
        let input = || format!("row {}", row.id);
        let caps = (
            sampler::<f32>(Technique::SolidAngle, &row.scene),
            sampler::<f64>(Technique::SolidAngle, &row.scene),
        );
        let (Some(single), Some(double)) = caps else { continue };
        let (single, double) = (single.cap(), double.cap());
        let solid = solid.group(row.group);
        solid[0].add((f64::from(single.solid_angle()) / row.solid_angle - 1.0).abs(), input);
        solid[1].add((double.solid_angle() / row.solid_angle - 1.0).abs(), input);
        if row.projected_solid_angle > 0.0 {
            let exact = row.projected_solid_angle;
            let projected = projected.group(row.group);
            projected[0].add((f64::from(single.projected_solid_angle()) / exact - 1.0).abs(), input);
            projected[1].add((double.projected_solid_angle() / exact - 1.0).abs(), input);
        }
    }
    for (i, (name, _)) in STRATA.iter().enumerate() {
        let mut random = Random(100 + i as u64);
        for _ in 0..16 * SCENES {
            let scene = scene(i, &mut random);
            let input = || bits(&scene, &[]);
            let caps =
                (sampler::<f32>(Technique::Projected, &scene), sampler::<f64>(Technique::Projected, &scene));
            let (Some(single), Some(double)) = caps else { continue };
            let error = |single: f32, double: f64| (f64::from(single) / double - 1.0).abs();
            let (single, double) = (single.cap(), double.cap());
            projected.group(name)[0]
                .add(error(single.projected_solid_angle(), double.projected_solid_angle()), input);
            solid.group(name)[0].add(error(single.solid_angle(), double.solid_angle()), input);
        }
    }
    projected.print(page);
    solid.print(page);
}

fn distance(a: Offset<f64>, b: Offset<f64>) -> f64 {
    let (zenith, side) = (a.zenith - b.zenith, a.side - b.side);
    (zenith * zenith + side * side).sqrt()
}

fn samples(page: &mut String) {
    let mut offsets = Table::new(
        "Sample",
        "Distance of the f32 offset from the f64 one for the same random numbers, in units of the cap's radius (`projected`). \
         Numbers from 0.01 to 0.99, as in all that follows: at the ends of the square the maps are steep.",
    );
    let mut cosines = Table::new(
        "Cosine of a sample",
        "Relative error of the f32 offset's cosine with the normal against the f64 one's (`projected`).",
    );
    let names = [
        ["Density of `solid_angle`", "Density of `projected_bounded`", "Density of `projected`"],
        ["Inverse of `solid_angle`", "Inverse of `projected_bounded`", "Inverse of `projected`"],
    ];
    let mut densities = names[0].map(|name| {
        Table::new(
            name,
            "Relative error of the density that an f32 sample reports against that of the f64 map at the same numbers: by \
             solid angle, or projected solid angle for the projected techniques.",
        )
    });
    let mut inverses = names[1].map(|name| {
        Table::new(
            name,
            "Largest of |invert(sample(u)) - u|, each precision by itself. Three numbers of a precision do not tell everything: \
             `tests/kernels/properties.rs` has what they tell, and holds the inverse to it. (In f64 a normal of f32 numbers is off unit length by up to 1e-7, and so are some inverses.)",
        )
    });
    let mut directions = Table::new(
        "Direction forms",
        "Distance of the offset that is recovered from a sample's unit direction from the sample's own, absolute: what a unit \
         vector resolves. In units of the cap's radius that is 1/s times as much.",
    );
    for (t, technique) in TECHNIQUES.into_iter().enumerate() {
        for (i, (name, _)) in STRATA.iter().enumerate() {
            let mut random = Random(200 + i as u64);
            for _ in 0..SCENES {
                let scene = scene(i, &mut random);
                let pair = (sampler::<f32>(technique, &scene), sampler::<f64>(technique, &scene));
                let (Some(single), Some(double)) = pair else { continue };
                let s = double.cap().radius_sin();
                for _ in 0..NUMBERS {
                    let u = [0, 1].map(|_| random.within(0.01, 0.99) as f32);
                    let [v0, v1] = u.map(f64::from);
                    let input = || bits(&scene, &u);
                    let (sample, exact) = (single.sample(u[0], u[1]), double.sample(v0, v1));
                    let error = |got: f32, expected: f64| (f64::from(got) / expected - 1.0).abs();
                    let density = match technique {
                        Technique::SolidAngle => error(sample.density.solid_angle, exact.density.solid_angle),
                        _ => {
                            let expected = exact.density.projected_solid_angle;
                            error(sample.density.projected_solid_angle, expected)
                        }
                    };
                    densities[t].group(name)[0].add(density, input);
                    let largest = |[a, b]: [f64; 2]| (a - v0).abs().max((b - v1).abs());
                    let inverse = inverses[t].group(name);
                    inverse[0].add(largest(single.invert(sample.offset).map(f64::from)), input);
                    inverse[1].add(largest(double.invert(exact.offset)), input);
                    if technique == Technique::Projected {
                        let offset = widen(sample.offset);
                        offsets.group(name)[0].add(distance(offset, exact.offset) / s, input);
                        cosines.group(name)[0].add(error(sample.offset.cosine, exact.offset.cosine), input);
                        let direction = directions.group(name);
                        direction[0].add(distance(widen(single.offset(sample.direction)), offset), input);
                        direction[1].add(distance(double.offset(exact.direction), exact.offset), input);
                    }
                }
            }
        }
    }
    offsets.print(page);
    cosines.print(page);
    for table in densities.iter_mut().chain(&mut inverses) {
        table.print(page);
    }
    directions.print(page);
}

/// What low-discrepancy points gain, and that they do: by theory the error of independent points falls with the count to the
/// power -1/2, that of (0, 2)-points to -3/4 for a half plane (its edge cuts the square root of n of n strata) and to -1 or so
/// for a smooth function. A map with jumps or without bounds on its stretching would bring both towards -1/2. The bounds leave what
/// 24 shifts leave to chance: a twentieth of a slope at each end of six octaves, four times, and the half plane's own scatter.
fn distortion(page: &mut String) {
    let scenes = [[0.1, 0.5], [0.1, 0.05], [0.1, -0.03], [0.9, 0.95], [0.9, 0.4], [0.9, -0.3], [0.9, -0.8]];
    let (few, many) = (64_u32, 4096_u32);
    let octaves = (f64::from(many) / f64::from(few)).log2();
    writeln!(
        page,
        "\n## Low distortion\n\n\
         Root-mean-square errors of integrals over projected solid angle with Sobol points (shifted at random) and independent ones, \
         for a smooth function and for a half plane that occludes: the slope of the error over the count, from {few} to {many} \
         points, and how many times smaller than with independent points (slope -0.5) it then is.\n\n\
         | technique | s | Z | smooth: slope | gain | half plane: slope | gain |\n|---|--:|--:|--:|--:|--:|--:|"
    )
    .expect("strings grow");
    let mut random = Random(31);
    for (technique, name) in
        [(Technique::ProjectedBounded, "projected_bounded"), (Technique::Projected, "projected")]
    {
        for [s, z] in scenes {
            let sampler = Scene::above_plane(s, z).sampler::<f64>(strategy(technique));
            let [at_few, at_many] = [few, many].map(|n| errors(&sampler, n, &mut random));
            let slope = |points: usize, f: usize| (at_many[points][f] / at_few[points][f]).log2() / octaves;
            let gain = |f: usize| at_many[1][f] / at_many[0][f];
            assert!(slope(0, 0) < -0.85 && gain(0) > 25.0, "{name} {s} {z}: {} {}", slope(0, 0), gain(0));
            assert!(slope(0, 1) < -0.58 && gain(1) > 4.0, "{name} {s} {z}: {} {}", slope(0, 1), gain(1));
            for f in 0..2 {
                assert!((slope(1, f) + 0.5).abs() < 0.2, "{name} {s} {z}: independent {}", slope(1, f));
            }
            writeln!(
                page,
                "| `{name}` | {s} | {z} | {:.2} | {:.0} | {:.2} | {:.1} |",
                slope(0, 0),
                gain(0),
                slope(0, 1),
                gain(1)
            )
            .expect("strings grow");
        }
    }
}

fn page() -> String {
    let mut page = String::from(
        "# Accuracy\n\n\
         Made by `make accuracy` from `tests/kernels/accuracy.rs`; a test fails when it is stale. Worst and median errors, and the\n\
         input that gives the worst: a row of `tests/data/caps.csv`, or the bits of f32 numbers (normal, centre, radius, and the\n\
         random numbers where there are any).\n\n\
         The first groups are those of the reference values (`tests/kernels/reference.rs`), whose inputs are exact. The others are strata\n\
         of caps near one hard thing, in random orientation, at distances from 2^-20 to 2^20:\n\n",
    );
    for (name, text) in STRATA {
        writeln!(page, "- {name}: {text}").expect("strings grow");
    }
    areas(&mut page);
    samples(&mut page);
    distortion(&mut page);
    page
}

#[test]
fn the_page_is_not_stale() {
    let made = page();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/accuracy.md");
    if env::var_os("SPHERECAP_WRITE_ACCURACY").is_some() {
        fs::write(&path, &made).expect("docs/accuracy.md is writable");
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    for (line, (made, found)) in made.lines().zip(found.lines()).enumerate() {
        assert!(
            made == found,
            "docs/accuracy.md is not what the kernels give: run `make accuracy` and look at the diff\nline {}: {made}",
            line + 1
        );
    }
    assert!(found == made, "docs/accuracy.md is not what the kernels give: run `make accuracy`");
}
