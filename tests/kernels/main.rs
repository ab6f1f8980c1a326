//! The kernels: one crate, as each would compile them all again. A file for each subject, named as in `src` where one is there.

#[path = "../common/mod.rs"]
mod common;

mod accuracy;
mod approximate;
mod batch;
mod choice;
mod density;
mod exponents;
mod goodness_of_fit;
mod importance;
mod low_distortion;
mod properties;
mod reference;
mod strata;
