//! The C ABI, from C99 and C++17 programs that are compiled, linked with the static library and run, each plainly and
//! under the address and undefined-behaviour sanitizers; and the header and the library's symbols.
//!
//! The programs are in `tests/c/` and `examples/`. A compiler or a sanitizer that is missing is a failure.

mod common;

use common::{hard_scenes, reference_caps, strategies, Random, Scene};
use spherecap::batch::Instructions;
use spherecap::{Density, Sampler, Strategy};
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
    let [stdin, stdout, stderr] = ["in", "out", "err"].map(|end| program.with_extension(end));
    fs::write(&stdin, input).expect("the target directory is writable");
    let create = |path: &Path| File::create(path).expect("the target directory is writable");
    let mut child = Command::new(program)
        .args(arguments)
        .env("ASAN_OPTIONS", "detect_leaks=0")
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

fn header() -> String {
    fs::read_to_string(root().join("include/spherecap.h")).expect("include/spherecap.h is readable")
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
        names.contains("spherecap_prepare") && names.len() >= 12,
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

#[test]
fn numbers_of_every_kind_do_no_harm() {
    print!("{}", run_both("tests/c/fuzz.c", ""));
    // The long run, of `make test-long`: more trials, without sanitizers to slow them down.
    if let Ok(trials) = std::env::var("SPHERECAP_FUZZ_TRIALS") {
        let program = build("tests/c/fuzz.c", false);
        let report = run(&program, &[&trials], "");
        print!("{}", report.unwrap_or_else(|report| panic!("{}: {report}", program.display())));
    }
}

#[test]
fn the_header_stands_alone() {
    for language in [C, Cpp] {
        let source = out_dir().join(if language == Cpp { "alone.cpp" } else { "alone.c" });
        fs::write(
            &source,
            "#include \"spherecap.h\"\n#include \"spherecap.h\"\nint main(void) { return 0; }\n",
        )
        .expect("the target directory is writable");
        let mut compiler = language.compiler();
        compiler.arg(language.standard()).args(WARNINGS).arg("-I").arg(root().join("include"));
        succeed(compiler.arg("-c").arg(&source).arg("-o").arg(source.with_extension("o")));
    }
}

#[test]
fn everything_in_the_header_is_documented_and_every_function_is_called() {
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
        if is_declaration || line.starts_with("#define SPHERECAP_ABI") {
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

    for sources in [&["tests/c/calls.c", "tests/c/batch.c"][..], &["tests/c/calls.cpp"]] {
        let read = |source| fs::read_to_string(root().join(source)).expect("the sources are readable");
        let text: String = sources.iter().map(read).collect();
        let code: String = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        for name in functions() {
            assert!(code.contains(&format!("{name}(")), "{sources:?} do not call {name}");
        }
    }
}

/// One line of `tests/c/bits.c`'s input.
fn line_in(strategy: Strategy<f32>, normal: [f32; 3], centre: [f32; 3], radius: f32, u: [f32; 2]) -> String {
    let Strategy { technique, hemispheres, defensive } = strategy;
    let floats = [&[defensive][..], &normal, &centre, &[radius], &u].concat();
    format!("{:x} {:x}{}\n", technique as u32, hemispheres as u32, bits(&floats))
}

/// The line that it should print.
fn line_out(
    strategy: Strategy<f32>,
    normal: [f32; 3],
    centre: [f32; 3],
    radius: f32,
    [u0, u1]: [f32; 2],
) -> String {
    let sampler = match Sampler::prepare(strategy, normal, centre, radius) {
        Ok(sampler) => sampler,
        Err(refusal) => return refusal.to_string(),
    };
    let sample = sampler.sample(u0, u1);
    let offset_of_direction = sampler.offset(sample.direction);
    let offset = [sample.offset.zenith, sample.offset.side, sample.offset.cosine];
    let pair = |density: Density<f32>| [density.solid_angle, density.projected_solid_angle];
    let floats = [
        &offset[..],
        &<[f32; 3]>::from(sample.direction),
        &[sample.distance],
        &<[f32; 3]>::from(sample.normal),
        &pair(sample.density),
        &pair(sampler.pdf(sample.offset)),
        &pair(sampler.pdf(offset_of_direction)),
        &pair(sampler.pdf_on_sphere(offset_of_direction)),
        &sampler.invert(sample.offset),
        &[sampler.cap().solid_angle(), sampler.cap().projected_solid_angle(), sampler.density_bound()],
    ];
    format!("ok{}", bits(&floats.concat()))
}

fn bits(floats: &[f32]) -> String {
    floats.iter().map(|x| format!(" {:08x}", x.to_bits())).collect()
}

/// The input of `tests/c/bits.c` and `tests/c/record.c`, and what the first should print.
fn lines() -> (String, Vec<String>) {
    let mut random = Random(1);
    let mut scenes = hard_scenes(&mut random);
    scenes.extend(reference_caps().iter().map(|row| row.scene));
    // And one of each that is refused.
    let good = Scene::above_plane(0.5, 0.1);
    scenes.push(Scene { normal: [0.0, 0.0, 2.0], ..good });
    scenes.push(Scene { centre: [0.0; 3], ..good });
    scenes.push(Scene { radius: f64::NAN, ..good });
    let (mut input, mut expected) = (String::new(), Vec::new());
    for scene in &scenes {
        let [normal, centre] = [scene.normal, scene.centre].map(|v| v.map(|x| x as f32));
        let radius = scene.radius as f32;
        for strategy in strategies::<f32>() {
            let u = [random.unit() as f32, random.unit() as f32];
            for u in [u, [u[0], 1.0]] {
                input += &line_in(strategy, normal, centre, radius, u);
                expected.push(line_out(strategy, normal, centre, radius, u));
            }
        }
    }
    (input, expected)
}

#[test]
fn c_gives_the_bits_that_rust_gives() {
    let (input, expected) = lines();
    let output = run_both("tests/c/bits.c", &input);
    let (lines, inputs): (Vec<&str>, Vec<&str>) = (output.lines().collect(), input.lines().collect());
    assert_eq!(lines.len(), expected.len());
    for ((line, expected), input) in lines.iter().zip(&expected).zip(inputs) {
        assert_eq!(line, expected, "C, and Rust, for {input}");
    }
    // Neither side of it is empty.
    let sampled = lines.iter().filter(|line| line.starts_with("ok")).count();
    assert!(4 * sampled > lines.len() && sampled < lines.len(), "{sampled} of {} are sampled", lines.len());
}

#[test]
fn a_recorded_kernel_gives_the_bits_of_the_scalar_one() {
    let (input, expected) = lines();
    let output = run_both("tests/c/record.c", &input);
    let counts: Vec<usize> = output.split_whitespace().map(|n| n.parse().expect("a number")).collect();
    let &[lines, sampled, sample, density, sample_ifs, density_ifs] = &counts[..] else {
        panic!("six numbers, not {output}")
    };
    assert_eq!(lines, expected.len());
    assert_eq!(sampled, expected.iter().filter(|line| line.starts_with("ok")).count());
    println!("at most {sample} operations and {sample_ifs} conditionals for a sample");
    println!("at most {density} operations and {density_ifs} conditionals for a density");
    // A budget: what is recorded is compiled and run by every user of it.
    assert!(sample <= 780 && density <= 540, "{sample} operations for a sample, {density} for a density");
    // Conditionals are skipped at the price of compiling them; without any, all sides are computed everywhere.
    assert!((1..=12).contains(&sample_ifs), "{sample_ifs} conditionals for a sample");
    assert!((1..=6).contains(&density_ifs), "{density_ifs} conditionals for a density");
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
    assert_eq!(functions().iter().filter(|name| may_allocate(name)).count(), 2);
    for name in functions().iter().filter(|name| !may_allocate(name)) {
        for need in needs(&references, &format!(".text.{name}")) {
            let is_harmless = ["fmaf", "memcpy", "memmove", "memset"].contains(&need.as_str());
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
    assert!(fused >= 6 && avx2 == 4 && avx512 == 4, "the relocations are read wrongly: {kernels:?} kernels");
}
