//! How much there is to a kernel, told by counts that are the same on every machine: the operations that are recorded of it, those
//! of them that are executed where conditionals are skipped, and the size of what is prepared. `docs/speed.md` shows them;
//! `make hashes` remakes them.

use super::{Program, Step};
use crate::batch::{MeasuresKernel, PdfDirectionKernel, PdfOnSphereKernel, SampleKernel};
use crate::lane::packet::arrays::Kernel;
use crate::{Hemispheres, Sampler, Strategy};
use std::fmt::Write;

#[path = "../../benches/scenes.rs"]
mod scenes;

use scenes::{Random, Scene, SEED};

impl Program {
    fn operations(&self) -> usize {
        self.steps.borrow().iter().filter(|step| matches!(step, Step::Op(..))).count()
    }

    /// The operations that these inputs need.
    fn executed(&self, inputs: &[f32], values: &mut Vec<f32>) -> usize {
        self.run(inputs, values);
        let (steps, inside) = (self.steps.borrow(), self.inside.borrow());
        let is_executed = |(step, masks): &(&Step, &Vec<u64>)| {
            matches!(step, Step::Op(..)) && masks.iter().all(|&mask| values[mask as usize] != 0.0)
        };
        steps.iter().zip(inside.iter()).filter(is_executed).count()
    }
}

fn recorded<K: Kernel<I, O>, const I: usize, const O: usize>(kernel: K, strategy: Strategy<f32>) -> Program {
    Program::record(kernel, strategy).0
}

fn counts() -> String {
    let mut random = Random(SEED);
    let numbers: Vec<f32> = (0..4096).map(|_| random.unit()).collect();
    let (_, mix) = scenes::sets(&mut random).pop().expect("the mix is the last");
    let mut text = format!("sampler, bytes: {}\n", size_of::<Sampler<f32>>());
    for (name, technique) in super::TECHNIQUES {
        let strategy = Strategy { technique, hemispheres: Hemispheres::Front, defensive: 0.0 };
        let sample = recorded(SampleKernel, strategy);
        let mut values = Vec::new();
        let executed: usize = mix
            .iter()
            .zip(numbers.chunks_exact(2))
            .map(|(Scene { normal: [nx, ny, nz], centre: [cx, cy, cz], radius }, u)| {
                sample.executed(&[*nx, *ny, *nz, *cx, *cy, *cz, *radius, u[0], u[1]], &mut values)
            })
            .sum();
        for (what, count) in [
            ("sample", sample.operations()),
            ("sample, executed on the mix", (executed as f64 / mix.len() as f64).round() as usize),
            ("pdf of a place on the sphere", recorded(PdfOnSphereKernel, strategy).operations()),
            ("pdf of a direction", recorded(PdfDirectionKernel, strategy).operations()),
            ("measures", recorded(MeasuresKernel, strategy).operations()),
        ] {
            writeln!(text, "{name}, {what}: {count}").expect("strings can be written to");
        }
    }
    text
}

#[test]
fn counts_are_what_they_were() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/counts.txt");
    let found = counts();
    if std::env::var_os("SPHERECAP_WRITE_HASHES").is_some() {
        std::fs::write(path, found).expect("counts can be written");
        return;
    }
    let committed = std::fs::read_to_string(path).expect("tests/data/counts.txt is there");
    assert_eq!(found, committed, "tests/data/counts.txt is stale: run `make hashes`");
}
