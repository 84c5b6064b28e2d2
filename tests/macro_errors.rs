//! What `ptc_controller!` says of a mistake, and where it points.
//!
//! `TRYBUILD=overwrite cargo test --test macro_errors` writes the expectations anew; they hold for
//! Rust 1.95, as other compilers word and mark some of them differently.

use std::path::Path;

/// Whether the compiler is the one whose words the expectations hold.
fn compiler_is_known() -> bool {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = std::process::Command::new(rustc).arg("--version").output().expect("rustc");
    let known = version.stdout.starts_with(b"rustc 1.95.");
    if !known {
        eprintln!("not run: the expectations hold for Rust 1.95 only");
    }
    known
}

#[test]
fn mistakes_are_told_at_their_token() {
    if !compiler_is_known() {
        return;
    }
    // The crate that trybuild makes for the cases, where their design file is looked for.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the target folder");
    let cases = target.join("tests/trybuild/ptc");
    std::fs::create_dir_all(&cases).expect("the folder of the cases");
    std::fs::copy("tests/designs/wrong.toml", cases.join("wrong.toml")).expect("a design file");
    trybuild::TestCases::new().compile_fail("tests/compile_fail/*.rs");
}

#[cfg(not(any(feature = "std", feature = "libm")))]
#[test]
fn a_missing_function_names_the_feature() {
    if !compiler_is_known() {
        return;
    }
    trybuild::TestCases::new().compile_fail("tests/compile_fail_bare/*.rs");
}
