//! What `ptc_controller!` says of a mistake, and where it points.
//!
//! `TRYBUILD=overwrite cargo test --test macro_errors` writes the expectations anew; they hold for
//! Rust 1.95, as other compilers word and mark some of them differently.

#[test]
fn mistakes_are_told_at_their_token() {
    trybuild::TestCases::new().compile_fail("tests/compile_fail/*.rs");
}

#[cfg(not(any(feature = "std", feature = "libm")))]
#[test]
fn a_missing_function_names_the_feature() {
    trybuild::TestCases::new().compile_fail("tests/compile_fail_bare/*.rs");
}
