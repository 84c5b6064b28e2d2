//! generated/ holds what the generator writes, each file of it compiled, so that a change of the
//! emitted code is seen in review. Refresh it with `UPDATE_GOLDEN=1 cargo test --test golden`.

mod designs;
mod store;

use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use ptc_assure::harness::goldens::{FEW, controllers, of_axes};
use ptc_assure::harness::{empty, program, run, rustc, write};
use ptc_codegen::check::resolved::Resolved;
use ptc_codegen::emit::Language;
use ptc_codegen::family::Family;
use ptc_codegen::request::{Feedback, Spec};
use store::{Files, compare};

/// The languages whose files are kept: those of every controller in C and Rust, in the others those of a few.
const LANGUAGES: [Language; 7] = [
    Language::C,
    Language::Rust,
    Language::Cpp,
    Language::Matlab,
    Language::Python,
    Language::StructuredText,
    Language::PlcOpen,
];

fn is_kept(language: Language, spec: &Spec) -> bool {
    matches!(language, Language::C | Language::Rust) || FEW.contains(&spec.name().as_str())
}

/// Every golden by its path in generated/, generated once for all tests.
static WANTED: LazyLock<Files> = LazyLock::new(wanted);

fn wanted() -> Files {
    let mut wanted = Files::new();
    for spec in controllers().into_iter().chain(of_axes()) {
        for language in LANGUAGES.into_iter().filter(|language| is_kept(*language, &spec)) {
            let folder = language.name();
            for file in ptc_codegen::generate(&spec, language).expect("a legal spec") {
                let path = Path::new(folder).join(file.name);
                let before = wanted.insert(path, file.text);
                assert_eq!(before, None, "two controllers of one name: {}", spec.name());
            }
        }
    }
    wanted
}

#[test]
fn goldens_match_the_generator() {
    compare(&LANGUAGES.map(Language::name), &WANTED);
}

/// Goldens of the families that call no function need no `std`.
#[test]
fn goldens_without_function_calls_compile_without_std() {
    let folder = empty(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden_rust"));
    let mut modules = "#![no_std]\n".to_owned();
    for spec in controllers().into_iter().chain(of_axes()) {
        let bare = matches!(
            spec.family(),
            Some(Family::Exp | Family::Rational | Family::Tanh | Family::Soft)
        );
        if bare && spec.feedback == Feedback::Linear {
            write(&folder, &spec, Language::Rust);
            modules += &format!("pub mod {};\n", spec.name());
        }
    }
    let crate_root = folder.join("lib.rs");
    fs::write(&crate_root, modules).expect("a file");
    let mut compiler = rustc();
    compiler.args(["--crate-type=lib", "--emit=metadata", "-o"]);
    run(compiler.arg(folder.join("lib.rmeta")).arg(&crate_root));
}

#[test]
fn generating_twice_gives_the_same_bytes() {
    assert_eq!(wanted(), *WANTED);
}

/// The macro expands to the items of the golden, on the types of the facade.
#[test]
fn macro_expands_to_the_golden() {
    for spec in controllers().into_iter().chain(of_axes()) {
        let items = ptc_codegen::macro_items(&spec).expect("a legal spec");
        let file = ptc_codegen::generate(&spec, Language::Rust).expect("a legal spec").remove(0);
        assert!(items.contains("::ptc::"), "{}", spec.name());
        let real = program::real(spec.precision);
        let own = items.replace(&format!("::ptc::math::{real}::"), "math::").replace("::ptc::", "");
        // The file names the design in its head, the macro where the controller is documented.
        let design = Resolved::of(&spec).spec.fingerprint();
        assert!(file.text.contains(&format!("design {design}.")), "{}: {design}", spec.name());
        let own = own.replacen(&format!(" Design {design}."), "", 1);
        assert!(file.text.ends_with(&own), "{}: the file does not end in\n{own}", spec.name());
    }
}
