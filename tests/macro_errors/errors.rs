//! Messages of `ptc_controller!` for mistakes, and the places that they point to.
//!
//! `TRYBUILD=overwrite cargo test` in this folder writes the expectations anew, with `--no-default-features` those
//! of `bare`; they hold for Rust 1.95, as other compilers word and mark some of them differently.

use trybuild::TestCases;

/// The cases, where the compiler is the one whose words they expect.
fn cases() -> Option<TestCases> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = std::process::Command::new(rustc).arg("--version").output().expect("rustc");
    if version.stdout.starts_with(b"rustc 1.95.") {
        return Some(TestCases::new());
    }
    eprintln!("not run: the expectations hold for Rust 1.95 only");
    None
}

#[cfg(feature = "std")]
#[test]
fn mistakes_are_told_at_their_token() {
    let Some(cases) = cases() else { return };
    // The package that trybuild makes of the cases, where their design file is looked for.
    let target =
        std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the target folder");
    let package = target.join("tests/trybuild").join(env!("CARGO_PKG_NAME"));
    std::fs::create_dir_all(&package).expect("the folder of the cases");
    std::fs::copy("cases/wrong.toml", package.join("wrong.toml")).expect("a design file");
    cases.compile_fail("cases/*.rs");
}

#[cfg(not(feature = "std"))]
#[test]
fn a_missing_function_names_the_feature() {
    let Some(cases) = cases() else { return };
    cases.compile_fail("bare/*.rs");
}
