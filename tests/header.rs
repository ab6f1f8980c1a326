//! `include/spherecap.h` is what cbindgen makes of `src/ffi.rs`, `src/ffi_batch.rs` and `src/ffi_record.rs`. Remake it with `make header`.

use std::{env, fs, path::Path};

#[test]
fn the_header_is_not_stale() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut made = Vec::new();
    // The boundary files alone: public constants of other modules are no part of the ABI.
    cbindgen::Builder::new()
        .with_config(
            cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml is readable"),
        )
        .with_src(root.join("src/ffi.rs"))
        .with_src(root.join("src/ffi_batch.rs"))
        .with_src(root.join("src/ffi_record.rs"))
        .generate()
        .expect("cbindgen understands the boundary files")
        .write(&mut made);
    let made = String::from_utf8(made).expect("a header is text");
    let path = root.join("include/spherecap.h");
    if env::var_os("SPHERECAP_WRITE_HEADER").is_some() {
        fs::write(&path, &made).expect("include/spherecap.h is writable");
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        found == made,
        "include/spherecap.h is not what src/ffi*.rs give: run `make header` and look at the diff"
    );
}
