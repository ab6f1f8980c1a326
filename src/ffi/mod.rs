//! The C ABI: check, convert, call, store. No mathematics.
//!
//! `include/spherecap.h` is generated from `single.rs`, `batch.rs`, `lights.rs` and `double.rs`, comments included, and
//! `include/spherecap_record.h` from `record.rs`. The functions on single points are written out for both precisions because
//! cbindgen expands no macros; what they do is in `calls.rs`, once.

mod batch;
mod calls;
mod double;
mod instructions;
mod lights;
mod record;
mod single;
