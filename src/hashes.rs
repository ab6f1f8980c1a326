//! Every bit that the kernels give, as hashes: the same on every lane and instruction set, and the same after every change that
//! moves code only. One that changes formulas remakes `tests/data/hashes.txt` (`make hashes`), and says why.
//!
//! Nothing is normalised: zeros have their signs, and where a kernel gave NaN that would be seen. Inputs are made by correctly
//! rounded operations only, so that they are the same on every machine.

use crate::batch::Instructions;
use crate::batch::{MeasuresKernel, PdfDirectionKernel, PdfKernel, PdfOnSphereKernel, SampleKernel};
use crate::input::Input;
use crate::lane::packet::arrays::{run_slices, Kernel};
use crate::lane::recorded::{Backend, Conditional, NodeId, Op, Recorded, Tape};
use crate::lane::Lane;
use crate::offset::Offset;
use crate::strategy::{Hemispheres, Strategy, Technique};
use core::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Write as _;

#[path = "../tests/common/inputs.rs"]
mod inputs;
mod operations;

/// Inputs that share a strategy, and how many such blocks are hashed in `make test` and in `make test-long`.
const BLOCK: usize = 1 << 10;
const QUICK: usize = 1 << 4;
const LONG: usize = 1 << 10;

const TECHNIQUES: [(&str, Technique); 3] = [
    ("projected", Technique::Projected),
    ("projected_bounded", Technique::ProjectedBounded),
    ("solid_angle", Technique::SolidAngle),
];

/// Hemispheres and defensive fractions: block by block.
const MIXTURES: [(Hemispheres, f64); 6] = [
    (Hemispheres::Front, 0.0),
    (Hemispheres::Both, 0.0),
    (Hemispheres::Front, 0.125),
    (Hemispheres::Both, 0.125),
    (Hemispheres::Front, 0.0),
    (Hemispheres::Front, 1.0),
];

/// `Sampler::invert`, which is for scalars alone.
#[derive(Clone, Copy)]
struct InvertKernel;

impl Kernel<10, 2> for InvertKernel {
    #[inline(always)]
    fn run<L: Lane>(
        self,
        strategy: Strategy<L>,
        [nx, ny, nz, cx, cy, cz, radius, zenith, side, cosine]: [L; 10],
    ) -> ([L; 2], L::Mask) {
        let (sampler, is_sampled) = Input::new(strategy, [nx, ny, nz, cx, cy, cz, radius]).prepare();
        let zero = L::lit(0.0);
        let numbers = sampler.invert(Offset { zenith, side, cosine });
        (numbers.map(|u| L::select(is_sampled, u, zero)), !is_sampled)
    }
}

/// splitmix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        (self.bits() >> 32) % n
    }

    /// In [0, 1), with 24 bits.
    fn unit(&mut self) -> f64 {
        (self.bits() >> 40) as f64 / 16_777_216.0
    }

    /// In `[2^low, 2^high)`.
    fn power(&mut self, low: i64, high: i64) -> f64 {
        let exponent = low + self.below((high - low) as u64) as i64;
        f64::from_bits(((exponent + 1023) as u64) << 52) * (1.0 + self.unit())
    }

    fn sign(&mut self) -> f64 {
        [1.0, -1.0][self.below(2) as usize]
    }

    fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = [0; 3].map(|_| 2.0 * self.unit() - 1.0);
            let length2 = dot(v, v);
            if (0.01..1.0).contains(&length2) {
                return v.map(|x| x / length2.sqrt());
            }
        }
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Normal, centre and radius, everything that goes wrong included.
fn scene(random: &mut Random) -> [f64; 7] {
    let kind = random.below(20);
    let s = match kind {
        // Tiny; next to the surface, and next to inside; anything.
        0..=2 => random.power(-56, -1),
        3 | 4 => 1.0 - random.power(-30, -1),
        _ => 0.02 + 0.97 * random.unit(),
    };
    let z = match random.below(12) {
        // Cut, sunk; touching from either side, from above and below; on the horizon; near the zenith; at it.
        0..=2 => s * (2.0 * random.unit() - 1.0),
        3 => -s - (1.0 - s) * random.unit(),
        4 => random.sign() * (s * (1.0 + random.sign() * random.power(-26, -2))).min(1.0),
        5 => s * random.sign() * random.power(-30, -1),
        6 => 1.0 - random.power(-60, -1),
        7 => [1.0, -1.0, 0.0, s][random.below(4) as usize],
        _ => s + (1.0 - s) * random.unit(),
    };
    let x = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    let axes = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
    let normal = if kind < 12 { random.direction() } else { axes[random.below(3) as usize] };
    let other = random.direction();
    let along = dot(normal, other);
    let across: [f64; 3] = core::array::from_fn(|i| other[i] - along * normal[i]);
    let length = dot(across, across).sqrt();
    // Lengths near the ends of single precision, too.
    let d = if kind == 5 { random.power(-124, 124) } else { random.power(-4, 4) };
    let mut numbers = [0.0; 7];
    // Normals of any length, and none.
    let stretch = match random.below(16) {
        0 => 0.0,
        1 => random.power(-100, 100),
        2 => 1.0 + random.sign() * random.power(-24, -20),
        _ => 1.0,
    };
    for i in 0..3 {
        numbers[i] = normal[i] * stretch;
        numbers[3 + i] = d * (z * normal[i] + x * across[i] / length);
    }
    numbers[6] = s * d;
    // Bad input.
    if random.below(24) == 0 {
        let bad = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 1e-45];
        numbers[random.below(7) as usize] = bad[random.below(7) as usize];
    }
    if random.below(128) == 0 {
        numbers[3..6].fill(0.0);
    }
    numbers
}

fn number(random: &mut Random) -> f64 {
    match random.below(16) {
        0 => [0.0, 1.0, 1.0 - f64::from(f32::EPSILON), 1e-30][random.below(4) as usize],
        1 => random.power(-60, 0),
        2 => [-0.5, 1.5, f64::NAN, f64::INFINITY][random.below(4) as usize],
        _ => random.unit(),
    }
}

/// 64-bit FNV-1a over the bits of numbers.
#[derive(Clone, Copy, PartialEq)]
struct Hash(u64);

impl Hash {
    fn add(&mut self, bits: u64, bytes: usize) {
        for byte in &bits.to_le_bytes()[..bytes] {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

trait Scalar: Lane<Mask = bool> {
    fn of(x: f64) -> Self;
    fn add_to(self, hash: &mut Hash);
}
impl Scalar for f32 {
    fn of(x: f64) -> Self {
        x as Self
    }
    fn add_to(self, hash: &mut Hash) {
        hash.add(u64::from(self.to_bits()), 4);
    }
}
impl Scalar for f64 {
    fn of(x: f64) -> Self {
        x
    }
    fn add_to(self, hash: &mut Hash) {
        hash.add(self.to_bits(), 8);
    }
}

/// A program of operations: what an expression graph is, run number by number. What a conditional gives where its mask is
/// false is NaN, and read by nobody.
#[derive(Default)]
struct Program {
    steps: RefCell<Vec<Step>>,
    open: RefCell<Vec<NodeId>>,
    /// Of each step the masks of the conditionals that it is in.
    inside: RefCell<Vec<Vec<NodeId>>>,
}

enum Step {
    Input,
    Literal(f32),
    Op(Op, [NodeId; 3]),
    /// A node, where the mask is true.
    If(NodeId, NodeId),
}

impl Program {
    /// What computes the outputs of a kernel, which are nodes of it.
    fn record<K: Kernel<I, O>, const I: usize, const O: usize>(
        kernel: K,
        Strategy { technique, hemispheres, defensive }: Strategy<f32>,
    ) -> (Self, [NodeId; O]) {
        let (program, tape) = (Self::default(), Tape::default());
        let nodes = [(); I].map(|()| program.push(Step::Input));
        // A constant, as renderers have it.
        let strategy = Strategy { technique, hemispheres, defensive: Recorded::Lit(defensive) };
        let (outputs, _) = kernel.run(strategy, nodes.map(|node| tape.input(node)));
        let wanted = outputs.map(|output| tape.want_number(output));
        let outputs = tape.play(&program, wanted).expect("a program never fails");
        (program, outputs)
    }

    fn push(&self, step: Step) -> NodeId {
        self.inside.borrow_mut().push(self.open.borrow().clone());
        self.steps.borrow_mut().push(step);
        self.steps.borrow().len() as NodeId
    }

    fn run(&self, inputs: &[f32], values: &mut Vec<f32>) {
        values.clear();
        values.push(f32::NAN);
        let mut inputs = inputs.iter();
        let truth = |x: bool| f32::from(u8::from(x));
        for step in self.steps.borrow().iter() {
            let value = match *step {
                Step::Input => *inputs.next().expect("there are as many inputs"),
                Step::Literal(value) => value,
                Step::If(mask, node) => {
                    if values[mask as usize] == 0.0 {
                        f32::NAN
                    } else {
                        values[node as usize]
                    }
                }
                Step::Op(op, operands) => {
                    let [a, b, c] = operands.map(|node| values[node as usize]);
                    match op {
                        Op::Add => a + b,
                        Op::Sub => a - b,
                        Op::Mul => a * b,
                        Op::Div => a / b,
                        Op::Fma => a.mul_add(b, c),
                        Op::Neg => -a,
                        Op::Abs => a.abs(),
                        Op::Sqrt => a.sqrt(),
                        Op::Lt => truth(a < b),
                        Op::Le => truth(a <= b),
                        Op::And => truth(a != 0.0 && b != 0.0),
                        Op::Or => truth(a != 0.0 || b != 0.0),
                        Op::Not => truth(a == 0.0),
                        Op::Select => {
                            if a == 0.0 {
                                c
                            } else {
                                b
                            }
                        }
                        Op::PowerOfTwo => a.power_of_two(),
                        Op::Bits => Lane::bits(a),
                        Op::FloatOfBits => a.float_of_bits(),
                    }
                }
            };
            values.push(value);
        }
    }
}

impl Backend for Program {
    fn literal(&self, value: f32) -> Option<NodeId> {
        Some(self.push(Step::Literal(value)))
    }
    fn op(&self, op: Op, operands: &[NodeId], _: bool) -> Option<NodeId> {
        let mut padded = [0; 3];
        padded[..operands.len()].copy_from_slice(operands);
        Some(self.push(Step::Op(op, padded)))
    }
    fn begin_if(&self, mask: NodeId) -> Option<Conditional> {
        self.open.borrow_mut().push(mask);
        Some(Conditional(mask))
    }
    fn end_if(&self, Conditional(mask): Conditional, nodes: &mut [NodeId]) -> Option<()> {
        assert_eq!(self.open.borrow_mut().pop(), Some(mask));
        for node in nodes {
            *node = self.push(Step::If(mask, *node));
        }
        Some(())
    }
    fn release(&self, _: NodeId) {}
}

/// What runs a kernel on numbers of a precision.
#[derive(Clone, Copy)]
enum Way {
    Scalar,
    Packets(Instructions),
    Recorded,
}

impl Way {
    fn name(self) -> String {
        match self {
            Self::Scalar => "scalar".to_owned(),
            Self::Packets(instructions) => instructions.to_string(),
            Self::Recorded => "recorded".to_owned(),
        }
    }

    /// The outputs, for each input.
    fn run<K: Kernel<I, O>, const I: usize, const O: usize>(
        self,
        kernel: K,
        strategy: Strategy<f32>,
        inputs: [&[f32]; I],
    ) -> Vec<[f32; O]> {
        let count = inputs[0].len();
        let input = |i: usize| inputs.map(|numbers| numbers[i]);
        match self {
            Self::Scalar => scalar(kernel, strategy, inputs),
            Self::Packets(instructions) => {
                let mut outputs = [(); O].map(|()| vec![0.0; count]);
                let slices = outputs.each_mut().map(|output| Some(&mut output[..]));
                run_slices(kernel, instructions, strategy, inputs, slices);
                (0..count).map(|i| outputs.each_ref().map(|output| output[i])).collect()
            }
            Self::Recorded => {
                let (program, outputs) = Program::record(kernel, strategy);
                let mut values = Vec::new();
                let outputs_of = |i| {
                    program.run(&input(i), &mut values);
                    outputs.map(|node| values[node as usize])
                };
                (0..count).map(outputs_of).collect()
            }
        }
    }
}

fn scalar<F: Scalar, K: Kernel<I, O>, const I: usize, const O: usize>(
    kernel: K,
    strategy: Strategy<F>,
    inputs: [&[F]; I],
) -> Vec<[F; O]> {
    (0..inputs[0].len()).map(|i| kernel.run(strategy, inputs.map(|numbers| numbers[i])).0).collect()
}

/// Hashes of a technique's kernels over blocks of inputs, by the name of the kernel; those of the quick run too.
#[derive(Default)]
struct Hashes(BTreeMap<(usize, &'static str), Hash>);

impl Hashes {
    fn add<F: Scalar, const O: usize>(&mut self, block: usize, name: &'static str, outputs: &[[F; O]]) {
        for blocks in [QUICK, LONG] {
            if block < blocks {
                let hash = self.0.entry((blocks, name)).or_default();
                outputs.iter().flatten().for_each(|x| x.add_to(hash));
            }
        }
    }
}

/// The kernels of one technique in one precision, run in one way.
fn hashes<F: Scalar>(technique: Technique, blocks: usize, way: impl Run<F>) -> Hashes {
    let mut hashes = Hashes::default();
    for block in 0..blocks {
        let (hemispheres, defensive) = MIXTURES[block % MIXTURES.len()];
        let strategy = Strategy { technique, hemispheres, defensive: F::of(defensive) };
        let mut random = Random(block as u64);
        let mut columns = [(); 9].map(|()| Vec::new());
        for _ in 0..BLOCK {
            let scene = scene(&mut random);
            let numbers = [number(&mut random), number(&mut random)];
            for (column, x) in columns.iter_mut().zip(scene.into_iter().chain(numbers)) {
                column.push(F::of(x));
            }
        }
        let samples = way.run(SampleKernel, strategy, columns.each_ref().map(Vec::as_slice));
        // The offsets and directions of samples have densities; some others, too.
        let mut rest = [(); 6].map(|()| Vec::new());
        for sample in &samples {
            let others = [0; 2].map(|_| random.direction().map(F::of));
            let is_other = random.below(8) == 0;
            for (i, column) in rest.iter_mut().enumerate() {
                column.push(if is_other { others[i / 3][i % 3] } else { sample[i] });
            }
        }
        let [nx, ny, nz, cx, cy, cz, radius, ..] = columns.each_ref().map(Vec::as_slice);
        let [zenith, side, cosine, x, y, z] = rest.each_ref().map(Vec::as_slice);
        let offsets = [nx, ny, nz, cx, cy, cz, radius, zenith, side, cosine];
        let directions = [nx, ny, nz, cx, cy, cz, radius, x, y, z];
        hashes.add(block, "sample", &samples);
        hashes.add(block, "pdf", &way.run(PdfKernel, strategy, offsets));
        hashes.add(block, "pdf_direction", &way.run(PdfDirectionKernel, strategy, directions));
        hashes.add(block, "pdf_on_sphere", &way.run(PdfOnSphereKernel, strategy, directions));
        if way.inverts() {
            hashes.add(block, "invert", &way.run(InvertKernel, strategy, offsets));
        }
        let points = [nx, ny, nz, cx, cy, cz, radius];
        hashes.add(block, "measures", &way.run(MeasuresKernel, strategy, points));
    }
    hashes
}

trait Run<F> {
    /// Whether `Sampler::invert` is for such lanes.
    fn inverts(&self) -> bool;
    fn run<K: Kernel<I, O>, const I: usize, const O: usize>(
        &self,
        kernel: K,
        strategy: Strategy<F>,
        inputs: [&[F]; I],
    ) -> Vec<[F; O]>;
}
impl Run<f32> for Way {
    fn inverts(&self) -> bool {
        matches!(self, Self::Scalar)
    }
    fn run<K: Kernel<I, O>, const I: usize, const O: usize>(
        &self,
        kernel: K,
        strategy: Strategy<f32>,
        inputs: [&[f32]; I],
    ) -> Vec<[f32; O]> {
        Way::run(*self, kernel, strategy, inputs)
    }
}
struct Double;
impl Run<f64> for Double {
    fn inverts(&self) -> bool {
        true
    }
    fn run<K: Kernel<I, O>, const I: usize, const O: usize>(
        &self,
        kernel: K,
        strategy: Strategy<f64>,
        inputs: [&[f64]; I],
    ) -> Vec<[f64; O]> {
        scalar(kernel, strategy, inputs)
    }
}

/// Lines of the file, one for each hash.
fn lines(text: &mut String, precision: &str, technique: &str, hashes: &Hashes) {
    for ((blocks, kernel), Hash(hash)) in &hashes.0 {
        writeln!(text, "{} {precision} {technique} {kernel} {hash:016x}", blocks * BLOCK)
            .expect("strings can be written to");
    }
}

#[test]
fn every_lane_gives_the_bits_that_it_gave() {
    let is_written = std::env::var_os("SPHERECAP_WRITE_HASHES").is_some();
    let blocks = if is_written { LONG } else { inputs::inputs(QUICK, QUICK, LONG) };
    let mut ways = vec![Way::Scalar, Way::Recorded];
    for instructions in Instructions::ALL {
        if instructions.are_available() {
            ways.push(Way::Packets(instructions));
        } else {
            println!("not hashed, as this CPU lacks it: {instructions}");
        }
    }
    let mut found = String::new();
    for (name, technique) in TECHNIQUES {
        let mut single: Option<Hashes> = None;
        for way in &ways {
            let hashes = hashes::<f32>(technique, blocks, *way);
            match &single {
                None => single = Some(hashes),
                Some(expected) => {
                    for (key, hash) in &hashes.0 {
                        let (blocks, kernel) = key;
                        assert!(
                            expected.0[key] == *hash,
                            "{name}, {kernel}, {} inputs: {} and scalars differ",
                            blocks * BLOCK,
                            way.name()
                        );
                    }
                }
            }
        }
        lines(&mut found, "f32", name, &single.expect("there are scalars"));
        lines(&mut found, "f64", name, &hashes::<f64>(technique, blocks, Double));
    }
    let names: Vec<_> = ways.iter().map(|way| way.name()).collect();
    println!("hashed over {} inputs: {}", blocks * BLOCK, names.join(", "));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/hashes.txt");
    if is_written {
        std::fs::write(path, found).expect("hashes can be written");
        return;
    }
    let committed = std::fs::read_to_string(path).expect("tests/data/hashes.txt is there");
    for line in found.lines() {
        // A quick run's hashes of all that it saw are those of the quick run.
        if line.starts_with(&format!("{} ", LONG * BLOCK)) && blocks < LONG {
            continue;
        }
        assert!(
            committed.lines().any(|other| other == line),
            "{line}: not in tests/data/hashes.txt. If a formula changed, `make hashes`, and say why"
        );
    }
}
