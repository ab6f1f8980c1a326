//! The kernels as source: the inline header, compiled as C and C++ by each compiler at hand and run, gives the library's bits.
//!
//! What shaders give is held to the library by `make test-shaders`.

#[allow(dead_code)] // the kernels' tests use all of it
mod common;

use common::{dot, Random};
use spherecap::{Hemispheres, Receiver, Sample, Sampler, Strategy, Technique};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const INPUTS: usize = 15;
const OUTPUTS: usize = 16;
// Places of two of the outputs.
const PROJECTED_PDF: usize = 12;
const PDF_ON_SPHERE: usize = 14;

/// How many inputs: half of them ordinary, half hard.
const COUNT: usize = 1 << 20;

/// `2^n` for a random n, times something in [1, 2).
fn power(random: &mut Random, low: f64, high: f64) -> f64 {
    random.within(low, high).floor().exp2() * (1.0 + random.unit())
}

/// A normal, a centre and a radius. Hard ones are tiny, all but touched, or touch the horizon; or are bad input.
fn scene(random: &mut Random, is_hard: bool, is_unit: bool) -> [f32; 7] {
    let below = |random: &mut Random, n: u64| random.bits() % n;
    let sign = |random: &mut Random| if random.bits() & 1 == 0 { 1.0 } else { -1.0 };
    let mut s = random.within(0.02, 0.98);
    let mut z = random.within((-s - 0.1).max(-1.0), 1.0);
    if is_hard {
        s = match below(random, 3) {
            0 => power(random, -50.0, -1.0),
            1 => 1.0 - power(random, -26.0, -1.0),
            _ => s,
        };
        z = match below(random, 6) {
            0 => s * random.within(-1.0, 1.0),
            1 => sign(random) * (s * (1.0 + sign(random) * power(random, -26.0, -2.0))).min(1.0),
            2 => sign(random) * s * power(random, -30.0, -1.0),
            3 => 1.0 - power(random, -50.0, -1.0),
            4 => [1.0, -1.0, 0.0, s][below(random, 4) as usize],
            _ => random.within(-1.0, 1.0),
        };
    }
    let (normal, other) = (random.direction(), random.direction());
    let along = dot(normal, other);
    let across: [f64; 3] = std::array::from_fn(|i| other[i] - along * normal[i]);
    let (length, x) = (dot(across, across).sqrt(), ((1.0 - z) * (1.0 + z)).max(0.0).sqrt());
    let d = if is_hard && below(random, 8) == 0 {
        power(random, -120.0, 120.0)
    } else {
        power(random, -3.0, 3.0)
    };
    let stretch = match below(random, 8) {
        _ if is_unit => 1.0,
        0 => power(random, -60.0, 60.0),
        1 => 0.0,
        _ => 1.0,
    };
    let mut numbers = [0.0; 7];
    for i in 0..3 {
        numbers[i] = (normal[i] * stretch) as f32;
        numbers[3 + i] = (d * (z * normal[i] + x * across[i] / length)) as f32;
    }
    numbers[6] = (s * d) as f32;
    if is_hard && below(random, 32) == 0 {
        let bad = [0.0, -1.0, f32::NAN, f32::INFINITY, f32::MAX, 1e-45];
        let first = if is_unit { 3 } else { 0 };
        numbers[first + below(random, 7 - first as u64) as usize] = bad[below(random, 6) as usize];
    }
    numbers
}

/// What the library gives for a record, which is `tests/c/inline.c`'s.
fn library(record: &[f32; INPUTS]) -> [f32; OUTPUTS] {
    let &[form, nx, ny, nz, cx, cy, cz, radius, defensive, u0, u1, dx, dy, dz, strength] = record;
    let (normal, centre, direction) = ([nx, ny, nz], [cx, cy, cz], [dx, dy, dz]);
    let hemispheres = if form == 2.0 { Hemispheres::Both } else { Hemispheres::Front };
    let defensive = if form == 0.0 { 0.0 } else { defensive };
    let strategy = Strategy { technique: Technique::Projected, hemispheres, defensive };
    let receiver = Receiver { normal: normal.into(), strategy };
    let mut outputs = [0.0; OUTPUTS];
    if let Ok(sampler) = Sampler::prepare(receiver, centre, radius) {
        let Sample { offset, direction: to, distance, normal: at, density } = sampler.sample(u0, u1);
        let measures = [1.0, sampler.cap().solid_angle(), sampler.cap().projected_solid_angle()];
        outputs[..3].copy_from_slice(&measures);
        outputs[3..10].copy_from_slice(&[to.x, to.y, to.z, distance, at.x, at.y, at.z]);
        outputs[10..13].copy_from_slice(&[offset.cosine, density.solid_angle, density.projected_solid_angle]);
        outputs[13] = sampler.pdf_direction(direction).solid_angle;
        outputs[14] = sampler.pdf_on_sphere(direction).solid_angle;
    }
    outputs[15] = receiver.importance(centre, radius, strength);
    outputs
}

/// Records, and what the library gives for them.
fn records() -> (Vec<[f32; INPUTS]>, Vec<[f32; OUTPUTS]>) {
    let mut random = Random(17);
    let (mut records, mut expected) = (Vec::new(), Vec::new());
    for i in 0..COUNT {
        let form = i / 2 % 3;
        let mut record = [0.0; INPUTS];
        record[0] = form as f32;
        record[1..8].copy_from_slice(&scene(&mut random, i % 2 == 1, form == 0));
        record[8] = [0.0, 0.125, 1.0, 0.0, -0.5, f32::NAN]
            [if i % 64 == 1 { random.bits() % 6 } else { random.bits() % 4 } as usize];
        let number = |random: &mut Random| match random.bits() % 16 {
            0 => [0.0, 1.0, -0.5, 1.5, f32::NAN, 1e-30][(random.bits() % 6) as usize],
            _ => random.unit() as f32,
        };
        (record[9], record[10]) = (number(&mut random), number(&mut random));
        // A direction that was sampled, or any.
        let sampled = library(&record);
        let any = random.direction().map(|x| x as f32);
        let direction = if random.bits().is_multiple_of(4) { &any } else { &sampled[3..6] };
        record[11..14].copy_from_slice(direction);
        record[14] = random.within(0.0, 4.0) as f32;
        records.push(record);
        expected.push(library(&record));
    }
    (records, expected)
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn out_dir() -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("source");
    fs::create_dir_all(&dir).expect("the target directory is writable");
    dir
}

/// A compiler that the machine has: its command, and the arguments that make it take C99 or C++11.
fn compilers() -> Vec<(&'static str, [&'static str; 3])> {
    let all = [
        ("gcc", ["-x", "c", "-std=c99"]),
        ("g++", ["-x", "c++", "-std=c++11"]),
        ("clang", ["-x", "c", "-std=c99"]),
        ("clang++", ["-x", "c++", "-std=c++11"]),
    ];
    let is_there = |compiler: &str| {
        let found =
            Command::new(compiler).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        found.is_ok_and(|status| status.success())
    };
    let (there, missing): (Vec<_>, Vec<_>) = all.into_iter().partition(|(compiler, _)| is_there(compiler));
    missing.iter().for_each(|(compiler, _)| println!("not tested, as this machine lacks it: {compiler}"));
    assert!(!there.is_empty(), "there is no C compiler, which this test needs: install gcc or clang");
    there
}

/// As the page has them, and warnings.
fn options() -> Vec<&'static str> {
    let mut options = vec![
        "-O2",
        "-fno-math-errno",
        "-pedantic",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-Wno-unused-function",
        "-Ishaders",
    ];
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("fma") {
        options.push("-mfma");
    }
    options
}

/// What a test program gives for the records in a file.
fn run(
    source: &str,
    compiler: &str,
    language: [&str; 3],
    contraction: &str,
    input: &Path,
) -> Vec<[f32; OUTPUTS]> {
    let stem = Path::new(source).file_stem().expect("it is a file").to_string_lossy();
    let program = out_dir().join(format!("{stem}_{compiler}_{contraction}"));
    let mut command = Command::new(compiler);
    command.args(language).args(options()).arg(format!("-ffp-contract={contraction}")).current_dir(root());
    let output = command.arg(source).args(["-x", "none", "-lm", "-o"]).arg(&program).output();
    let output = output.expect("the compiler starts");
    assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
    let stdin = File::open(input).expect("it was just written");
    let output = Command::new(&program).stdin(stdin).output().expect("what was built can be run");
    assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
    let numbers: Vec<f32> =
        output.stdout.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
    numbers.as_chunks().0.to_vec()
}

fn check_bits(
    compiler: &str,
    records: &[[f32; INPUTS]],
    expected: &[[f32; OUTPUTS]],
    found: &[[f32; OUTPUTS]],
) {
    assert_eq!(found.len(), COUNT, "{compiler}");
    for ((record, expected), found) in records.iter().zip(expected).zip(found) {
        let bits = |numbers: &[f32; OUTPUTS]| numbers.map(f32::to_bits);
        assert!(bits(expected) == bits(found), "{compiler}: {record:?} gives\n{found:?}, not\n{expected:?}");
    }
}

#[test]
fn the_inline_header_gives_the_bits_of_the_library() {
    let (records, expected) = records();
    let is_sampled = |outputs: &&[f32; OUTPUTS]| outputs[0] == 1.0;
    let sampled = expected.iter().filter(is_sampled).count();
    assert!(sampled > COUNT / 2 && sampled < COUNT - COUNT / 16, "{sampled} of {COUNT} are sampled");
    // Both, as `make test-shaders` reads them.
    let bytes =
        |numbers: &[f32]| -> Vec<u8> { numbers.iter().flat_map(|number| number.to_le_bytes()).collect() };
    let [input, output] = ["records", "expected"].map(|name| out_dir().join(name));
    fs::write(&input, bytes(records.as_flattened())).expect("the target directory is writable");
    fs::write(&output, bytes(expected.as_flattened())).expect("the target directory is writable");
    for (compiler, language) in compilers() {
        let found = run("tests/c/inline.c", compiler, language, "off", &input);
        check_bits(compiler, &records, &expected, &found);
        println!("{compiler}, contraction off: the same bits for {COUNT} inputs, {sampled} of them sampled");

        // Where compilers may fuse. Of a sample the density over the cosine: another sample has another cosine. In mixtures, too.
        let found = run("tests/c/inline.c", compiler, language, "fast", &input);
        let (mut worst, mut same) = ([0.0_f32; 3], 0);
        for ((record, expected), found) in records.iter().zip(&expected).zip(&found) {
            same += usize::from(expected.map(f32::to_bits) == found.map(f32::to_bits));
            assert!(expected[0] == found[0], "{compiler}: {record:?} is not sampled alike");
            let form = record[0] as usize;
            let is_mixed = form > 0 && record[8] > 0.0;
            let of_sample = (!is_mixed).then_some(PROJECTED_PDF);
            for i in of_sample.into_iter().chain([PDF_ON_SPHERE]).filter(|&i| expected[i] > 0.0) {
                worst[form] = worst[form].max((found[i] / expected[i] - 1.0).abs());
            }
        }
        println!(
            "{compiler}, fused: {same} have the same bits; densities by form are off by {worst:?} at most"
        );
        // Three units in the last place; of `both` the share of a side adds its own.
        assert!(worst[0].max(worst[1]) < 3e-7 && worst[2] < 6e-7, "{compiler}");
    }
}

/// The program of docs/source.md, which estimates without noise.
#[test]
fn the_program_of_the_page_prints_one_number_twice() {
    let page = fs::read_to_string(root().join("docs/source.md")).expect("the page is readable");
    let (_, rest) = page.split_once("```c\n").expect("it has a block of C");
    let (block, _) = rest.split_once("```").expect("the block ends");
    let source = out_dir().join("page.c");
    fs::write(&source, block).expect("the target directory is writable");
    for (compiler, language) in compilers() {
        let program = out_dir().join(format!("page_{compiler}"));
        let mut command = Command::new(compiler);
        command.args(language).args(options()).arg(&source).args(["-x", "none", "-lm", "-o"]).arg(&program);
        let output = command.current_dir(root()).output().expect("the compiler starts");
        assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
        let printed = Command::new(&program).output().expect("what was built can be run").stdout;
        let printed = String::from_utf8(printed).expect("it prints text");
        let numbers: Vec<f64> =
            printed.split([' ', ',', '\n']).filter_map(|word| word.parse().ok()).collect();
        assert!(numbers.len() == 2 && (numbers[0] / numbers[1] - 1.0).abs() < 1e-5, "{compiler}: {printed}");
    }
}

/// `make test-shaders` holds its picture to that of the shader.
#[test]
fn the_example_in_c_needs_the_header_alone() {
    for (compiler, language) in compilers() {
        let program = out_dir().join(format!("direct_light_{compiler}"));
        let mut command = Command::new(compiler);
        command
            .args(language)
            .args(options())
            .arg("examples/direct_light.c")
            .args(["-x", "none", "-lm", "-o"]);
        let output = command.arg(&program).current_dir(root()).output().expect("the compiler starts");
        assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
        let picture = Command::new(&program).output().expect("what was built can be run").stdout;
        let pixels = picture.strip_prefix(b"P6\n480 270\n255\n").expect("it is a picture");
        assert_eq!(pixels.len(), 480 * 270 * 3);
        let lit = pixels.iter().filter(|&&x| x > 0).count();
        assert!(2 * lit > pixels.len(), "{compiler}: {lit} numbers of {} are lit", pixels.len());
    }
}

/// As C++: no GPU is needed to see that the operations are the same, in the same order.
#[test]
fn the_file_for_cuda_gives_the_bits_of_the_library() {
    let (records, expected) = records();
    let bytes: Vec<u8> = records.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
    let input = out_dir().join("records_for_cuda");
    fs::write(&input, bytes).expect("the target directory is writable");
    let is_cpp = |(compiler, _): &(&str, _)| compiler.ends_with("++");
    let (compiler, language) = compilers().into_iter().find(is_cpp).expect("there is a C++ compiler");
    let found = run("tests/c/cuda.cpp", compiler, language, "off", &input);
    check_bits(compiler, &records, &expected, &found);
}

#[test]
fn fast_mathematics_are_refused() {
    for (compiler, language) in compilers() {
        let output = Command::new(compiler)
            .args(language)
            .args(options())
            .args(["-ffast-math", "-c", "tests/c/inline.c", "-o", "/dev/null"])
            .current_dir(root())
            .output()
            .expect("the compiler starts");
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && message.contains("without -ffast-math"), "{compiler}: {message}");
    }
}

/// What a shader needs of the GLSL to sample a light and to weigh a direction in one form, without comments.
fn glsl_of(form: &str) -> String {
    let file = shader("spherecap.glsl");
    let forms = ["surface", "front", "both"].into_iter().filter(|other| *other != form);
    let of_others: Vec<String> = forms.map(|other| format!("_{other}_")).collect();
    let mut is_needed = false;
    let mut text = String::new();
    for line in file.lines().filter(|line| !line.trim().is_empty() && !line.trim_start().starts_with("//")) {
        if line.ends_with('{') && !line.starts_with([' ', '}']) {
            let is_other = of_others.iter().any(|other| line.contains(other));
            is_needed = !is_other && !line.contains("_pdf_on_sphere(") && !line.contains("_importance(");
        }
        if is_needed {
            text += line;
            text.push('\n');
        }
    }
    text
}

#[test]
fn the_page_says_how_large_the_files_are() {
    let page = fs::read_to_string(root().join("docs/source.md")).expect("the page is readable");
    for file in fs::read_dir(root().join("shaders")).expect("the folder is there") {
        let name = file.expect("it is there").file_name().to_string_lossy().into_owned();
        let row =
            page.lines().find(|line| line.starts_with(&format!("| `{name}` |"))).expect("each has a row");
        let size = format!("{:.0} kB", shader(&name).len() as f64 / 1e3);
        assert!(row.contains(&size), "shaders/{name} has {size} now: say so in docs/source.md");
    }
    for form in ["surface", "front"] {
        let text = glsl_of(form);
        let (lines, size) = (text.lines().count(), text.len());
        let said = format!("{lines} lines and {:.1} kB", size as f64 / 1e3);
        assert!(page.replace('\n', " ").contains(&said), "{form} has {said}: say so in docs/source.md");
        // What can be read in a sitting.
        assert!(form != "surface" || lines < 400 && size < 16_000, "{said}");
    }
}

fn shader(name: &str) -> String {
    fs::read_to_string(root().join("shaders").join(name)).expect("the shaders are readable")
}

#[test]
fn naga_takes_the_wgsl_and_the_glsl() {
    let source = shader("spherecap.wgsl");
    let module = naga::front::wgsl::parse_str(&source);
    let module = module.unwrap_or_else(|error| panic!("{}", error.emit_to_string(&source)));
    let mut validator =
        naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
    validator.validate(&module).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&source)));
    assert_eq!(module.functions.iter().filter(|(_, function)| is_public(function)).count(), 18);

    // All but the word `precise`, which it does not know.
    let glsl = shader("spherecap.glsl").replace("precise ", "");
    let source = format!("#version 450\n{glsl}\nvoid main() {{}}\n");
    let options = naga::front::glsl::Options::from(naga::ShaderStage::Compute);
    let module = naga::front::glsl::Frontend::default().parse(&options, &source);
    let module = module.unwrap_or_else(|errors| panic!("{}", errors.emit_to_string(&source)));
    assert_eq!(module.functions.iter().filter(|(_, function)| is_public(function)).count(), 18);
}

/// Whether it is one of the six functions of the three forms.
fn is_public(function: &naga::Function) -> bool {
    let forms = ["surface_", "front_", "both_"].map(|form| format!("spherecap_{form}"));
    function.name.as_ref().is_some_and(|name| forms.iter().any(|form| name.starts_with(form)))
}
