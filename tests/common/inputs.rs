//! How many inputs the tests take. The environment variable `SPHERECAP_TESTS` is `quick` (`make check`), `full` (as where it is
//! not set, `make test`) or `long` (`make test-long`).

/// One of three numbers.
pub fn inputs<T>(quick: T, full: T, long: T) -> T {
    match std::env::var_os("SPHERECAP_TESTS").as_ref().map(|word| word.to_str()) {
        Some(Some("quick")) => quick,
        None | Some(Some("full")) => full,
        Some(Some("long")) => long,
        _ => panic!(
            "the environment variable SPHERECAP_TESTS must be quick, full or long: correct or unset it"
        ),
    }
}
