//! The C ABI, from C99 and C++17 programs that are compiled, linked with the static library and run, each plainly and
//! under the address and undefined-behaviour sanitizers; and the header and the library's symbols.
//!
//! The programs are in `tests/c/` and `examples/`. A compiler or a sanitizer that is missing is a failure.

#[allow(dead_code)] // the kernels' tests use all of it
mod common;

use common::inputs::inputs;
use common::{hard_scenes, reference_caps, strategies, Random, ReferenceCap, Scene};
use spherecap::batch::Instructions;
use spherecap::{Density, Receiver, Refusal, Sampler, Scalar, Strategy};
use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

const WARNINGS: [&str; 4] = ["-pedantic", "-Wall", "-Wextra", "-Werror"];
const SANITIZERS: [&str; 2] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"];
/// What the Rust standard library in the archive needs; some of these are part of the C library on some systems.
const LIBRARIES: [&str; 3] = ["-lpthread", "-ldl", "-lm"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Where the programs are built.
fn out_dir() -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c_abi");
    fs::create_dir_all(&dir).expect("the target directory is writable");
    dir
}

/// The library as users build it. `cargo test` builds one of its own, which unwinds and has a hash in its name.
fn archive() -> &'static Path {
    static ARCHIVE: OnceLock<PathBuf> = OnceLock::new();
    ARCHIVE.get_or_init(|| {
        let target_dir =
            Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("it is inside the target directory");
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["build", "--release", "--lib", "--message-format=json-render-diagnostics"]);
        let messages = succeed(cargo.arg("--target-dir").arg(target_dir).current_dir(root()));
        let archive = messages.split('"').find(|text| text.ends_with("libspherecap.a"));
        PathBuf::from(archive.expect("cargo names the static library that it built"))
    })
}

#[derive(Clone, Copy, PartialEq)]
enum Language {
    C,
    Cpp,
}
use Language::{Cpp, C};

impl Language {
    fn standard(self) -> &'static str {
        match self {
            C => "-std=c99",
            Cpp => "-std=c++17",
        }
    }

    fn of(source: &Path) -> Self {
        if source.extension() == Some(OsStr::new("cpp")) {
            Cpp
        } else {
            C
        }
    }

    /// The compiler, with the flags that the cc crate and the environment give it.
    fn compiler(self) -> Command {
        // Outside a build script, cc must be told what cargo would tell it there.
        static HOST: OnceLock<String> = OnceLock::new();
        let host = HOST.get_or_init(|| {
            let text = succeed(Command::new("rustc").arg("-vV"));
            let host = text.lines().find_map(|line| line.strip_prefix("host: "));
            host.expect("rustc names its host").to_owned()
        });
        let mut build = cc::Build::new();
        build.cargo_metadata(false).cpp(self == Cpp).host(host).target(host).opt_level(1).debug(true);
        let name = if self == Cpp { "C++" } else { "C" };
        let tool = build.try_get_compiler();
        tool.unwrap_or_else(|error| panic!("there is no {name} compiler, which this test needs: {error}"))
            .to_command()
    }
}

/// Runs a compiler or a tool to its end, and gives its standard output, or in `Err` its standard error.
fn finish(command: &mut Command) -> Result<String, String> {
    let output = command.output().unwrap_or_else(|error| {
        let program = command.get_program();
        panic!("{program:?}, which this test needs, does not start (is it installed?): {error}")
    });
    let text = if output.status.success() { &output.stdout } else { &output.stderr };
    let text = String::from_utf8_lossy(text).into_owned();
    if output.status.success() {
        Ok(text)
    } else {
        Err(text)
    }
}

fn succeed(command: &mut Command) -> String {
    finish(command).unwrap_or_else(|errors| panic!("{command:?} failed:\n{errors}"))
}

/// Runs a program that was built here; `Err` has its standard error. The sanitizers' leak checker is off: it traces the
/// process, which containers may forbid. (The library cannot allocate, see below.)
fn run(program: &Path, arguments: &[&str], input: &str) -> Result<String, String> {
    run_by(None, program, arguments, input)
}

/// The same with `SPHERECAP_INSTRUCTIONS` set or not.
fn run_by(
    instructions: Option<&str>,
    program: &Path,
    arguments: &[&str],
    input: &str,
) -> Result<String, String> {
    let [stdin, stdout, stderr] = ["in", "out", "err"].map(|end| program.with_extension(end));
    fs::write(&stdin, input).expect("the target directory is writable");
    let create = |path: &Path| File::create(path).expect("the target directory is writable");
    let mut child = Command::new(program)
        .args(arguments)
        .env("ASAN_OPTIONS", "detect_leaks=0")
        .env_remove("SPHERECAP_INSTRUCTIONS")
        .envs(instructions.map(|word| ("SPHERECAP_INSTRUCTIONS", word)))
        .stdin(File::open(&stdin).expect("it was just written"))
        .stdout(Stdio::from(create(&stdout)))
        .stderr(Stdio::from(create(&stderr)))
        .spawn()
        .expect("what was built can be run");
    // Each takes seconds at most, or (with millions of trials) a few minutes: one that takes longer hangs.
    let deadline = Instant::now() + Duration::from_secs(900);
    let status = loop {
        if let Some(status) = child.try_wait().expect("a child can be waited for") {
            break status;
        }
        if Instant::now() > deadline {
            child.kill().expect("a child can be killed");
            panic!("{} hangs", program.display());
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let read = |path| String::from_utf8_lossy(&fs::read(path).expect("it was just written")).into_owned();
    if status.success() {
        Ok(read(&stdout))
    } else {
        Err(format!("{status}\n{}", read(&stderr)))
    }
}

/// Compiles and links a source file of the repository, and gives the program's path.
fn build(source: &str, sanitized: bool) -> PathBuf {
    let source = root().join(source);
    let language = Language::of(&source);
    let stem = source.file_name().and_then(OsStr::to_str).expect("a file name").replace('.', "_");
    let program = out_dir().join(stem + if sanitized { "_sanitized" } else { "" });
    let mut compiler = language.compiler();
    compiler.arg(language.standard()).args(WARNINGS).arg("-I").arg(root().join("include"));
    if sanitized {
        expect_sanitizers(language);
        compiler.args(SANITIZERS);
    }
    if source.starts_with(root().join("tests")) {
        compiler.arg("-D_DEFAULT_SOURCE"); // the test programs map memory, which C99 alone does not know
    }
    succeed(compiler.arg(source).arg(archive()).args(LIBRARIES).arg("-o").arg(&program));
    program
}

/// Fails unless the sanitizers are installed and at work.
fn expect_sanitizers(language: Language) {
    static WORKING: [OnceLock<()>; 2] = [const { OnceLock::new() }; 2];
    WORKING[language as usize].get_or_init(|| {
        let program = out_dir().join(format!("sanitizers_{}", language as usize));
        let mut compiler = language.compiler();
        if language == Cpp {
            compiler.args(["-x", "c++"]);
        }
        // Without warnings: it is wrong on purpose.
        compiler.args(SANITIZERS).arg("-w").arg(root().join("tests/c/sanitizers.c")).arg("-o").arg(&program);
        finish(&mut compiler).unwrap_or_else(|errors| {
            let compiler = compiler.get_program();
            panic!(
                "{compiler:?} lacks the runtimes of {SANITIZERS:?}: install libasan and libubsan.\n{errors}"
            )
        });
        assert_eq!(run(&program, &[], ""), Ok(String::new()), "a correct program fails under the sanitizers");
        for (argument, expected) in [("address", "AddressSanitizer"), ("undefined", "runtime error")] {
            let report = run(&program, &[argument], "").expect_err("the sanitizers notice nothing");
            assert!(report.contains(expected), "{report}");
        }
    });
}

/// Builds and runs a program with and without sanitizers, and gives the output, which must be the same.
fn run_both(source: &str, input: &str) -> String {
    let [plain, sanitized] = [false, true].map(|sanitized| {
        let program = build(source, sanitized);
        run(&program, &[], input).unwrap_or_else(|report| panic!("{}: {report}", program.display()))
    });
    assert!(plain == sanitized, "{source} prints something else under sanitizers:\n{plain}\n{sanitized}");
    plain
}

/// Both headers.
fn header() -> String {
    let read =
        |name| fs::read_to_string(root().join("include").join(name)).expect("the headers are readable");
    ["spherecap.h", "spherecap_record.h"].map(read).concat()
}

/// Names of the functions that the header declares.
fn functions() -> BTreeSet<String> {
    let header = header();
    let is_code = |line: &&str| !line.trim_start().starts_with("//") && !line.starts_with('#');
    let code: String = header.lines().filter(is_code).flat_map(|line| [line, "\n"]).collect();
    let names: BTreeSet<String> = code
        .split(';')
        .filter_map(|statement| statement.split_once('('))
        .map(|(before, _)| before.rsplit([' ', '*', '\n']).next().expect("split gives something").to_owned())
        .filter(|name| !name.is_empty()) // a member that points to a function
        .collect();
    assert!(
        names.contains("spherecap_prepare") && names.len() >= 24,
        "the header is read wrongly: {names:?}"
    );
    names
}

#[test]
fn the_example_prints_samples() {
    let output = run_both("examples/print_samples.c", "");
    assert_eq!(output.lines().filter(|line| line.starts_with("direction (")).count(), 8, "{output}");
    // All samples estimate the same irradiance, to the digits printed.
    let irradiance: BTreeSet<&str> =
        output.lines().filter_map(|line| line.split_once("irradiance ")).map(|x| x.1).collect();
    assert_eq!(irradiance.len(), 1, "{output}");
    assert!(output.contains("a radius of -1: the radius must be"), "{output}");
    assert!(output.contains("a light below the horizon: the sphere is not above"), "{output}");
    // Its build instructions name the libraries that this test links with.
    let source =
        fs::read_to_string(root().join("examples/print_samples.c")).expect("the example is readable");
    assert!(source.contains(&format!("libspherecap.a {} ", LIBRARIES.join(" "))));
}

/// `tests/cross` looks at its images; here, it is a program that gives every technique all that a scene can hold.
#[test]
fn the_renderer_renders_the_same_under_sanitizers() {
    let scene = "image 16 12\ncamera 1 -3 6 0.2 0.3 0 50\nlight 0 0 0.1 0.5 1\nlight 0 0 1.5 0.5 1\n\
                 rectangle 0 0 0 9 0 0 0 9 0 0.5\nball -0.8 0.5 0.3 0.3 0.7\nbox 0.7 -0.4 0 1.2 0.4 0.5 0.5\n";
    let [plain, sanitized] = [false, true].map(|sanitized| build("tests/c/renderer.c", sanitized));
    for technique in ["solid_angle", "projected_bounded", "projected"] {
        for sampler in ["independent", "lattice"] {
            let arguments = [technique, sampler, "4", "1"];
            let [image, expected] = [&sanitized, &plain].map(|program| {
                run(program, &arguments, scene).unwrap_or_else(|report| panic!("{arguments:?}: {report}"))
            });
            assert!(image == expected, "{arguments:?} gives another image under sanitizers");
            assert!(image.starts_with("Pf\n16 12\n-1\n"), "{image:?}");
        }
    }
}

#[test]
fn good_and_bad_input_from_c_gives_every_status() {
    let output = run_both("tests/c/calls.c", "");
    let met: BTreeSet<&str> =
        output.lines().filter_map(|line| line.split_once(' ')).map(|(number, _)| number).collect();
    let header = header();
    let statuses = header.lines().filter_map(|line| line.trim().strip_prefix("SPHERECAP_STATUS_"));
    let statuses: BTreeSet<&str> = statuses
        .filter_map(|line| line.split_once(" = "))
        .map(|(_, number)| number.trim_end_matches(','))
        .collect();
    assert!(statuses.len() >= 13, "the header is read wrongly: {statuses:?}");
    assert_eq!(met, statuses, "statuses that C met, and those of the header");
}

#[test]
fn cpp_calls_every_function_and_threads_share_nothing() {
    run_both("tests/c/calls.cpp", "");
}

#[test]
fn batches_from_c_give_the_bits_of_single_calls() {
    let instructions = run_both("tests/c/batch.c", "");
    println!("instruction set exercised: {}", instructions.trim());
    assert_eq!(instructions.trim(), Instructions::widest().to_string(), "what C names, and what Rust does");
}

/// By every instruction set that the CPU has.
#[test]
fn lights_from_c_have_the_importances_that_rust_gives() {
    let lines = lines::<f32>();
    let expected: String = lines
        .iter()
        .map(|line| line.receiver.importance(line.centre, line.radius, line.u[0]))
        .map(|importance| format!("{:08x}\n", importance.to_bits()))
        .collect();
    let zeros = expected.lines().filter(|line| *line == "00000000").count();
    assert!(3 * zeros < lines.len() * 2 && zeros > 100, "{zeros} of {} are zeros", lines.len());
    let input = input(&lines);
    assert!(run_both("tests/c/lights.c", &input) == expected);
    let program = build("tests/c/lights.c", false);
    for (word, instructions) in INSTRUCTIONS {
        if instructions.are_available() {
            println!("instruction set exercised: {instructions}");
            assert!(run_by(Some(word), &program, &[], &input).as_deref() == Ok(&expected), "{word}");
        }
    }
}

#[test]
fn numbers_of_every_kind_do_no_harm() {
    print!("{}", run_both("tests/c/fuzz.c", ""));
    // The long run: more trials, without sanitizers to slow them down.
    if let Some(trials) = inputs(None, None, Some("100000000")) {
        let program = build("tests/c/fuzz.c", false);
        let report = run(&program, &[trials], "");
        print!("{}", report.unwrap_or_else(|report| panic!("{}: {report}", program.display())));
    }
}

#[test]
fn the_headers_stand_alone() {
    for (language, name) in
        [(C, "spherecap"), (Cpp, "spherecap"), (C, "spherecap_record"), (Cpp, "spherecap_record")]
    {
        let source = out_dir().join(if language == Cpp { "alone.cpp" } else { "alone.c" });
        let program = format!(
            "#include \"{name}.h\"\n#include \"{name}.h\"\n\
             #if SPHERECAP_VERSION_MAJOR * 10000 + SPHERECAP_VERSION_MINOR * 100 + SPHERECAP_VERSION_PATCH < 100\n\
             #error this is older than the first version\n#endif\nint main(void) {{ return 0; }}\n"
        );
        fs::write(&source, program).expect("the target directory is writable");
        let mut compiler = language.compiler();
        compiler.arg(language.standard()).args(WARNINGS).arg("-I").arg(root().join("include"));
        succeed(compiler.arg("-c").arg(&source).arg("-o").arg(source.with_extension("o")));
    }
}

#[test]
fn everything_in_the_headers_is_documented_and_every_function_is_called() {
    let header = header();
    let mut previous = "";
    let mut open_parentheses = 0;
    let mut documented = 0;
    for line in header.lines() {
        let is_declaration = line.ends_with([',', ';', '{', '('])
            && open_parentheses == 0
            && !line.starts_with('}')
            && !line.starts_with("extern")
            && !line.trim_start().starts_with("//");
        if is_declaration
            || line.starts_with("#define SPHERECAP_ABI")
            || line.starts_with("#define SPHERECAP_VERSION_MAJOR")
        {
            assert!(previous.trim_start().starts_with("// "), "not documented: {line}");
            documented += 1;
        }
        if !line.trim_start().starts_with("//") {
            open_parentheses += line.matches('(').count();
            open_parentheses -= line.matches(')').count();
        }
        previous = line;
    }
    assert!(documented > 40, "the header is read wrongly: {documented} declarations");

    let of_c = ["tests/c/calls.c", "tests/c/batch.c", "tests/c/lights.c", "tests/c/check.h"];
    for sources in [&of_c[..], &["tests/c/calls.cpp"]] {
        let read = |source| fs::read_to_string(root().join(source)).expect("the sources are readable");
        let text: String = sources.iter().map(read).collect();
        let code: String = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        for name in functions() {
            assert!(code.contains(&format!("{name}(")), "{sources:?} do not call {name}");
        }
    }
}

/// A scalar by its bits.
trait Bits: Scalar {
    fn hex(self) -> String;
}
impl Bits for f32 {
    fn hex(self) -> String {
        format!(" {:08x}", self.to_bits())
    }
}
impl Bits for f64 {
    fn hex(self) -> String {
        format!(" {:016x}", self.to_bits())
    }
}

fn bits<F: Bits>(floats: &[F]) -> String {
    floats.iter().map(|x| x.hex()).collect()
}

/// What `tests/c/bits.c` is given in a line.
#[derive(Clone, Copy)]
struct Line<F> {
    receiver: Receiver<F>,
    centre: [F; 3],
    radius: F,
    u: [F; 2],
}

impl<F: Bits> Line<F> {
    fn input(&self) -> String {
        let Receiver { normal, strategy: Strategy { technique, hemispheres, defensive } } = self.receiver;
        let normal: [F; 3] = normal.into();
        let floats = [&[defensive][..], &normal, &self.centre, &[self.radius], &self.u].concat();
        format!("{:x} {:x}{}\n", technique as u32, hemispheres as u32, bits(&floats))
    }

    /// The line that it should print.
    fn output(&self) -> String {
        let sampler = match Sampler::prepare(self.receiver, self.centre, self.radius) {
            Ok(sampler) => sampler,
            Err(refusal) => return refusal.to_string(),
        };
        let sample = sampler.sample(self.u[0], self.u[1]);
        let offset = [sample.offset.zenith, sample.offset.side, sample.offset.cosine];
        let pair = |density: Density<F>| [density.solid_angle, density.projected_solid_angle];
        let floats = [
            &offset[..],
            &<[F; 3]>::from(sample.direction),
            &[sample.distance],
            &<[F; 3]>::from(sample.normal),
            &pair(sample.density),
            &pair(sampler.pdf(sample.offset)),
            &pair(sampler.pdf_direction(sample.direction)),
            &pair(sampler.pdf_on_sphere(sample.direction)),
            &sampler.invert(sample.offset),
            &[sampler.cap().solid_angle(), sampler.cap().projected_solid_angle(), sampler.density_bound()],
        ];
        format!("ok{}", bits(&floats.concat()))
    }
}

/// Scenes of every kind with every strategy: the input of `tests/c/bits.c`, `bits_f64.c` and `record.c`.
fn lines<F: Bits>() -> Vec<Line<F>> {
    let mut random = Random(1);
    let mut scenes = hard_scenes(&mut random);
    scenes.extend(reference_caps().iter().map(|row| row.scene));
    // And one of each that is refused.
    let good = Scene::above_plane(0.5, 0.1);
    scenes.push(Scene { normal: [0.0, f64::NAN, 1.0], ..good });
    scenes.push(Scene { normal: [0.0, 0.0, f64::INFINITY], ..good });
    scenes.push(Scene { centre: [0.0; 3], ..good });
    scenes.push(Scene { radius: f64::NAN, ..good });
    let mut lines = Vec::new();
    // Normals of other lengths, up to the largest number and down to subnormal ones.
    let lengths = [0.999, 1.000_01, 3.0, 1e10, 0.5 * F::MAX, 1e-10, 30.0 * F::MIN_POSITIVE * F::EPSILON];
    for (i, scene) in scenes.iter().enumerate() {
        for strategy in strategies::<F>() {
            let u = [random.unit(), random.unit()].map(F::lit);
            let length = if i % 3 == 1 { lengths[i / 3 % lengths.len()] } else { 1.0 };
            let normal = scene.normal.map(|x| F::lit(x * length)).into();
            let line = Line {
                receiver: Receiver { normal, strategy },
                centre: scene.centre.map(F::lit),
                radius: F::lit(scene.radius),
                u,
            };
            let ends = [[u[0], F::lit(1.0)], [F::lit(f64::NAN), F::lit(-0.5)]];
            lines.extend([line, Line { u: ends[0], ..line }, Line { u: ends[1], ..line }]);
        }
    }
    lines
}

fn input<F: Bits>(lines: &[Line<F>]) -> String {
    lines.iter().map(Line::input).collect()
}

fn check_bits<F: Bits>(source: &str) {
    let lines = lines::<F>();
    let output = run_both(source, &input(&lines));
    let found: Vec<&str> = output.lines().collect();
    assert_eq!(found.len(), lines.len());
    for (found, line) in found.iter().zip(&lines) {
        assert_eq!(*found, line.output(), "C, and Rust, for {}", line.input());
    }
    // Neither side of it is empty.
    let sampled = found.iter().filter(|line| line.starts_with("ok")).count();
    assert!(4 * sampled > lines.len() && sampled < lines.len(), "{sampled} of {} are sampled", lines.len());
}

#[test]
fn c_gives_the_bits_that_rust_gives() {
    check_bits::<f32>("tests/c/bits.c");
}

#[test]
fn c_gives_the_bits_that_rust_gives_in_double_precision() {
    check_bits::<f64>("tests/c/bits_f64.c");
}

/// The 25-digit values, as `tests/kernels/reference.rs` holds Rust to them.
#[test]
fn areas_in_double_precision_from_c() {
    let rows = reference_caps();
    let line = |row: &ReferenceCap| {
        let Scene { normal, centre, radius } = row.scene;
        Line { receiver: Receiver::<f64>::new(normal), centre, radius, u: [0.5; 2] }
    };
    let output =
        run_both("tests/c/bits_f64.c", &rows.iter().map(|row| line(row).input()).collect::<String>());
    assert_eq!(output.lines().count(), rows.len());
    let mut worst = [0.0_f64; 2];
    for (row, found) in rows.iter().zip(output.lines()) {
        if row.projected_solid_angle == 0.0 {
            assert_eq!(found, Refusal::Invisible.to_string(), "row {}", row.id);
            continue;
        }
        let numbers: Vec<f64> = found
            .split_whitespace()
            .skip(1)
            .map(|bits| f64::from_bits(u64::from_str_radix(bits, 16).expect("hexadecimal bits")))
            .collect();
        // The last three numbers are solid angle, projected solid angle and bound.
        let measures = &numbers[numbers.len() - 3..];
        for (i, exact) in [row.solid_angle, row.projected_solid_angle].into_iter().enumerate() {
            let error = (measures[i] / exact - 1.0).abs();
            worst[i] = if error <= worst[i] { worst[i] } else { error };
        }
    }
    println!("worst relative errors of solid angles and projected ones: {worst:?}");
    assert!(worst.iter().all(|&error| error < 1e-12), "{worst:?}");
}

/// Where subnormal numbers are flushed to zero: the same bits, but where one is among the input, which then counts as zero.
#[cfg(target_arch = "x86_64")]
fn check_flushed<F: Bits>(source: &str) {
    let program = build(source, false);
    let output = |lines: &[Line<F>]| {
        run(&program, &["flush"], &input(lines)).unwrap_or_else(|report| panic!("{source}: {report}"))
    };
    let is_subnormal = |&x: &F| x.into() != 0.0 && x.into().abs() < F::MIN_POSITIVE;
    let is_plain = |line: &Line<F>| {
        ![<[F; 3]>::from(line.receiver.normal), line.centre].as_flattened().iter().any(is_subnormal)
    };
    let lines: Vec<Line<F>> = lines().into_iter().filter(is_plain).collect();
    let found = output(&lines);
    assert_eq!(found.lines().count(), lines.len());
    for (found, line) in found.lines().zip(&lines) {
        assert_eq!(found, line.output(), "flushed, and Rust, for {}", line.input());
    }
    let line = Line { radius: F::lit(0.1 * F::MIN_POSITIVE), ..lines[0] };
    assert_eq!(line.output(), Refusal::Invisible.to_string());
    assert_eq!(output(&[line]), format!("{}\n", Refusal::Radius));
}

#[test]
#[cfg(target_arch = "x86_64")]
fn flushing_subnormal_numbers_does_no_harm() {
    check_flushed::<f32>("tests/c/bits.c");
    check_flushed::<f64>("tests/c/bits_f64.c");
    let report = run(&build("tests/c/batch.c", false), &["flush"], "");
    assert!(report.is_ok(), "{report:?}");
}

/// What `SPHERECAP_INSTRUCTIONS` may be.
const INSTRUCTIONS: [(&str, Instructions); 3] =
    [("portable", Instructions::Portable), ("avx2", Instructions::Avx2), ("avx512", Instructions::Avx512)];

/// Whatever the environment names: the same bits from single points and from arrays; or, of a wrong word, a status in words.
#[test]
fn the_environment_chooses_the_instructions() {
    let (bits, batch) = (build("tests/c/bits.c", false), build("tests/c/batch.c", false));
    let calls = build("tests/c/no_instructions.c", false);
    let input = input(&lines::<f32>());
    let run_by = |word, program| {
        run_by(word, program, &[], &input).unwrap_or_else(|report| panic!("{word:?}: {report}"))
    };
    let expected = run_by(None, &bits);
    assert_eq!(run_by(Some(""), &bits), expected);
    for (word, instructions) in INSTRUCTIONS {
        if instructions.are_available() {
            println!("instruction set exercised: {instructions}");
            assert!(run_by(Some(word), &bits) == expected, "{word} gives other bits");
            assert_eq!(run_by(Some(word), &batch).trim(), instructions.to_string());
        } else {
            run_by(Some(word), &calls);
        }
    }
    for word in ["AVX2", "portable ", "avx1024", "0"] {
        run_by(Some(word), &calls);
    }
}

#[test]
fn a_recorded_kernel_gives_the_bits_of_the_scalar_one() {
    let lines_in = lines::<f32>();
    let output = run_both("tests/c/record.c", &input(&lines_in));
    let counts: Vec<usize> = output.split_whitespace().map(|n| n.parse().expect("a number")).collect();
    let &[lines, sampled, sample, density, importance, sample_ifs, density_ifs, importance_ifs] = &counts[..]
    else {
        panic!("eight numbers, not {output}")
    };
    assert_eq!(lines, lines_in.len());
    assert_eq!(sampled, lines_in.iter().filter(|line| line.output().starts_with("ok")).count());
    println!("at most {sample} operations and {sample_ifs} conditionals for a sample");
    println!("at most {density} operations and {density_ifs} conditionals for a density");
    println!("at most {importance} operations and {importance_ifs} conditionals for an importance");
    // A budget: what is recorded is compiled and run by every user of it.
    assert!(sample <= 790 && density <= 510, "{sample} operations for a sample, {density} for a density");
    assert!(importance <= 135, "{importance} operations for an importance");
    // Conditionals are skipped at the price of compiling them; without any, all sides are computed everywhere.
    assert!((1..=12).contains(&sample_ifs), "{sample_ifs} conditionals for a sample");
    assert!((1..=6).contains(&density_ifs), "{density_ifs} conditionals for a density");
    assert!(importance_ifs <= 1, "{importance_ifs} conditionals for an importance");
}

/// What readelf prints. (nm would load a plugin for the bitcode in Rust's archives, and old ones fail on it.)
fn readelf(arguments: &[&str], file: &Path) -> String {
    succeed(Command::new("readelf").arg("--wide").args(arguments).arg(file))
}

#[test]
fn the_exported_symbols_are_the_headers_functions() {
    let library = out_dir().join("everything.so");
    let mut linker = C.compiler();
    linker.args(["-shared", "-Wl,--whole-archive"]).arg(archive()).arg("-Wl,--no-whole-archive");
    succeed(linker.args(LIBRARIES).arg("-o").arg(&library));
    // Number, value, size, type, binding, visibility, section, name.
    let symbols = readelf(&["--dyn-syms"], &library);
    let exported: BTreeSet<String> = symbols
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .filter(|f| f.len() >= 8 && ["GLOBAL", "WEAK"].contains(&f[4]) && f[6] != "UND")
        .map(|f| f[7].to_owned())
        .collect();
    // Rust's own symbols are mangled, but for the routine that unwinds. They clash with nobody's.
    let is_rusts =
        |name: &str| name.starts_with("_ZN") || name.starts_with("_R") || name == "rust_eh_personality";
    let plain: BTreeSet<String> = exported.into_iter().filter(|name| !is_rusts(name)).collect();
    assert_eq!(plain, functions(), "symbols of the library, and functions of the header");
}

/// What refers to what among the sections of the library's own objects; a function has a section of its own.
fn references() -> BTreeMap<String, BTreeSet<String>> {
    let relocations = readelf(&["--relocs"], archive());
    let (mut references, mut is_own, mut section) = (BTreeMap::<_, BTreeSet<_>>::new(), false, "");
    for line in relocations.lines() {
        if let Some(member) = line.strip_prefix("File: ") {
            is_own = member.contains("(spherecap-");
        } else if let Some(rest) = line.strip_prefix("Relocation section '.rela") {
            section = rest.split('\'').next().expect("split gives something");
        } else if is_own {
            // Offset, info, type, value, name, and then the addend.
            let fields: Vec<&str> = line.split_whitespace().collect();
            if fields.len() >= 5 && fields[2].starts_with("R_") {
                references.entry(section.to_owned()).or_default().insert(fields[4].to_owned());
            }
        }
    }
    references
}

/// All that a section needs from elsewhere, directly or not.
fn needs(references: &BTreeMap<String, BTreeSet<String>>, section: &str) -> BTreeSet<String> {
    let (mut seen, mut elsewhere) = (BTreeSet::new(), BTreeSet::new());
    let mut open = vec![section.to_owned()];
    while let Some(section) = open.pop() {
        for name in references.get(&section).into_iter().flatten() {
            // A section, or the function or constant of that section; else somebody else's, or a constant that refers
            // to nothing.
            let candidates =
                ["", ".text.", ".data.rel.ro.", ".rodata."].map(|prefix| format!("{prefix}{name}"));
            match candidates.into_iter().find(|section| references.contains_key(section)) {
                Some(next) if seen.insert(next.clone()) => open.push(next),
                Some(_) => {}
                None if name.starts_with('.') => {}
                None => {
                    elsewhere.insert(name.clone());
                }
            }
        }
    }
    elsewhere
}

/// The functions that record a kernel keep a list of nodes, in memory of their own: the exception.
fn may_allocate(name: &str) -> bool {
    name.starts_with("spherecap_record_")
}

#[test]
fn no_function_can_panic_or_allocate() {
    let references = references();
    assert_eq!(functions().iter().filter(|name| may_allocate(name)).count(), 5);
    for name in functions().iter().filter(|name| !may_allocate(name)) {
        for need in needs(&references, &format!(".text.{name}")) {
            let is_harmless =
                ["fmaf", "fma", "memcpy", "memmove", "memset", "memcmp", "bcmp", "strlen", "getenv"]
                    .contains(&need.as_str());
            assert!(is_harmless || need.contains("std_detect"), "{name} may call {need}");
        }
    }
    assert!(references.contains_key(".text.spherecap_prepare"), "the relocations are read wrongly");
}

/// A call would leave the instructions that the CPU was found to have: the callee is compiled for any CPU, and there a
/// fused multiply-add is a call again.
#[test]
#[cfg(target_arch = "x86_64")]
fn kernels_for_this_cpu_call_nothing() {
    let references = references();
    let kinds = ["5fused", "6packet6arrays4avx2", "6packet6arrays6avx512"];
    let mut kernels = kinds.map(|_| 0);
    for section in references.keys().filter(|name| name.starts_with(".text.")) {
        let Some(kind) = kinds.iter().position(|kind| section.contains(kind)) else { continue };
        let calls: Vec<_> = references[section].iter().filter(|name| !name.starts_with(".LCPI")).collect();
        let is_harmless =
            |name: &str| !name.starts_with(".text") && !name.starts_with("fma") && !name.starts_with("_");
        assert!(calls.iter().all(|name| is_harmless(name)), "{section} calls {calls:?}");
        kernels[kind] += 1;
    }
    let [fused, avx2, avx512] = kernels;
    assert!(fused >= 12 && avx2 == 8 && avx512 == 8, "the relocations are read wrongly: {kernels:?} kernels");
}
