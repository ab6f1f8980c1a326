//! The headers are what cbindgen makes of `src/ffi`. Remake them with `make header`.

use std::{env, fs, path::Path};

/// What the library asks of a program, and what it promises.
const PROMISES: &str = "\
// Samples spherical lights: prepare a sampler for a receiver and a sphere, sample directions, ask for densities.
// A first program is examples/print_samples.c; tests/c/renderer.c is a small renderer; docs/c.md explains.
//
// Threads: no function changes anything but what its arguments point to, so any number of threads may call any of them, and
// share what is only read (samplers, receivers). Nothing is allocated, and no thread is started.
//
// Floating point: rounding must be to nearest, as it is unless a program changes it; in another mode, functions on arrays and
// on single points differ in the last digits. Modes that flush subnormal numbers to zero may be on: such numbers (below 1.2e-38
// in single precision) then count as zeros.
//
// Debugging: the environment variable SPHERECAP_INSTRUCTIONS chooses instructions, see `spherecap_batch_instructions`.";

const RECORD: &str = "\
// Records the kernels of spherecap.h into a program's own expression graph: for renderers that compile what they run.";

const GENERATED: &str = "// Generated from src/ffi by cbindgen: `make header`. Do not edit.";

/// What cbindgen makes of files of `src/ffi`.
fn made(name: &str, sources: &[&str], change: impl FnOnce(&mut cbindgen::Config)) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut config =
        cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml is readable");
    config.include_guard = Some(name.to_uppercase().replace('.', "_"));
    change(&mut config);
    let mut builder = cbindgen::Builder::new().with_config(config);
    // The boundary files alone: public constants of other modules are no part of the ABI.
    for source in sources {
        builder = builder.with_src(root.join("src/ffi").join(source));
    }
    let mut made = Vec::new();
    builder.generate().expect("cbindgen understands the boundary files").write(&mut made);
    String::from_utf8(made).expect("a header is text")
}

fn check(name: &str, made: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include").join(name);
    if env::var_os("SPHERECAP_WRITE_HEADER").is_some() {
        fs::write(&path, made).expect("the header is writable");
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        found == made,
        "include/{name} is not what src/ffi gives: run `make header` and look at the diff"
    );
}

#[test]
fn the_header_is_not_stale() {
    let [major, minor, patch] =
        [env!("CARGO_PKG_VERSION_MAJOR"), env!("CARGO_PKG_VERSION_MINOR"), env!("CARGO_PKG_VERSION_PATCH")];
    let made = made("spherecap.h", &["single.rs", "batch.rs", "lights.rs", "double.rs"], |config| {
        config.autogen_warning = Some(format!("{GENERATED}\n//\n{PROMISES}"));
        config.sys_includes = ["stddef.h", "stdint.h"].map(String::from).into();
        config.after_includes = Some(format!(
            "\n// Version of this header, for `#if`; `spherecap_version()` is the library's.\n\
             #define SPHERECAP_VERSION_MAJOR {major}\n\
             #define SPHERECAP_VERSION_MINOR {minor}\n\
             #define SPHERECAP_VERSION_PATCH {patch}"
        ));
        // They are passed as uint32_t (another value of a Rust enum would be undefined behaviour), so no signature names them.
        config.export.include = ["spherecap_technique_t", "spherecap_hemispheres_t", "spherecap_status_t"]
            .map(String::from)
            .into();
    });
    check("spherecap.h", &made);
}

#[test]
fn the_recorders_header_is_not_stale() {
    let made = made("spherecap_record.h", &["record.rs"], |config| {
        config.autogen_warning = Some(format!("{GENERATED}\n//\n{RECORD}"));
        config.includes = vec!["spherecap.h".into()];
    });
    check("spherecap_record.h", &made);
}
