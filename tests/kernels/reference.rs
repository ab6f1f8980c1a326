//! The 25-digit reference values: projected solid angles of 400 caps and 416 densities of the paper's case 3. No row is
//! excused: the inputs are exact in binary32, so conditioning is no reason to miss one.

use crate::common::{dot, hex_float, lanes, reference_caps, rows, Scene};
use spherecap::{Cap, Hemispheres, Offset, Refusal, Scalar, Strategy, Technique};
use std::collections::BTreeMap;

/// Worst relative error per group, printed and compared with a bound.
#[derive(Default)]
struct Groups(BTreeMap<String, (usize, f64)>);

impl Groups {
    fn add(&mut self, group: &str, error: f64) {
        let entry = self.0.entry(group.to_owned()).or_default();
        entry.0 += 1;
        // A NaN must not get lost in a maximum.
        entry.1 = if error <= entry.1 { entry.1 } else { error };
    }

    fn check(&self, title: &str, bound: f64) {
        println!("{title}: worst relative error per group, bound {bound:.0e}");
        for (group, (count, worst)) in &self.0 {
            println!("  {group:24} {count:4} rows  {worst:.2e}");
        }
        for (group, (_, worst)) in &self.0 {
            assert!(*worst <= bound, "{title}, {group}: {worst:e} exceeds {bound:e}");
        }
    }
}

fn check_caps<F: Scalar>(title: &str, bound: f64) {
    let mut projected = Groups::default();
    let mut solid = Groups::default();
    let caps = reference_caps();
    assert_eq!(caps.len(), 400, "tests/data/caps.csv is not whole");
    for row in caps {
        let Scene { normal, centre, radius } = row.scene;
        let cap = Cap::new(lanes::<F>(normal), lanes::<F>(centre), F::lit(radius));
        let (got, expected): (f64, f64) = (cap.projected_solid_angle().into(), row.projected_solid_angle);
        if expected == 0.0 {
            assert_eq!(got, 0.0, "row {} is wholly below the horizon", row.id);
            let refusal = row.scene.prepare::<F>(Strategy::default()).err();
            assert_eq!(refusal, Some(Refusal::Invisible), "row {}", row.id);
        } else {
            projected.add(&format!("{}, case {}", row.group, row.case), (got / expected - 1.0).abs());
        }
        let got: f64 = cap.solid_angle().into();
        solid.add(row.group, (got / row.solid_angle - 1.0).abs());
    }
    projected.check(&format!("projected solid angle in {title}"), bound);
    solid.check(&format!("solid angle in {title}"), bound);
}

#[test]
fn areas_in_double_precision() {
    check_caps::<f64>("f64", 1e-12);
}

#[test]
fn areas_in_single_precision() {
    check_caps::<f32>("f32", 1e-6);
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

/// The offset of a direction in the frame of n/|n|, which is the reference's; the cap itself uses n as it stands.
fn offset_in_reference_frame(scene: &Scene, direction: [f64; 3]) -> Offset<f64> {
    let Scene { normal, centre, .. } = *scene;
    let (n, c) = (unit(normal), unit(centre));
    let along = dot(n, c);
    let tangent = unit(std::array::from_fn(|i| c[i] - along * n[i]));
    let side = [
        n[1] * tangent[2] - n[2] * tangent[1],
        n[2] * tangent[0] - n[0] * tangent[2],
        n[0] * tangent[1] - n[1] * tangent[0],
    ];
    let w = unit(direction);
    let elevation = dot(normal, centre) / dot(centre, centre).sqrt();
    let zenith = (1.0 - elevation * elevation).sqrt() * dot(n, w) - elevation * dot(tangent, w);
    Offset { zenith, side: dot(side, w), cosine: dot(n, w) }
}

/// Errors for the rows whose normal is exactly of unit length, and for the others. In those the reference takes the
/// direction's components along n/|n| but the cap's elevation from n as it stands, and binary32 normals are off by up to
/// 6e-8 in length: one density has two meanings that differ by about that.
fn densities<F: Scalar>() -> [Groups; 2] {
    let mut groups = [Groups::default(), Groups::default()];
    let caps = reference_caps();
    let strategy = Strategy {
        technique: Technique::ProjectedBounded,
        hemispheres: Hemispheres::Front,
        defensive: F::lit(0.0),
    };
    let mut count = 0;
    for row in rows(include_str!("../data/densities.csv")) {
        let cap = &caps[row[1].parse::<usize>().expect("an id")];
        let direction = [2, 3, 4].map(|i| hex_float(row[i]));
        let expected: f64 = row[5].parse().expect("a density");
        let Offset { zenith, side, cosine } = offset_in_reference_frame(&cap.scene, direction);
        let offset = Offset { zenith: F::lit(zenith), side: F::lit(side), cosine: F::lit(cosine) };
        let got: f64 = cap.scene.sampler(strategy).pdf(offset).projected_solid_angle.into();
        let is_exact = dot(cap.scene.normal, cap.scene.normal) == 1.0;
        groups[usize::from(!is_exact)].add(cap.group, (got / expected - 1.0).abs());
        count += 1;
    }
    assert_eq!(count, 416, "tests/data/densities.csv is not whole");
    groups
}

#[test]
fn densities_of_the_bounded_technique() {
    let [exact, rounded] = densities::<f64>();
    exact.check("density of projected_bounded at an offset, exact normals, f64", 1e-12);
    rounded.check("density of projected_bounded at an offset, rounded normals, f64", 6e-8);
    let [exact, rounded] = densities::<f32>();
    exact.check("density of projected_bounded at an offset, exact normals, f32", 1e-5);
    rounded.check("density of projected_bounded at an offset, rounded normals, f32", 1e-5);
}
