//! The emitted C behind a main function.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::support;

/// What the program of the controller of `spec` and `main` prints, as numbers, a line each.
pub(super) fn run(test: &str, spec: &Spec, main: &str) -> Vec<Vec<f64>> {
    run_in(support::folder(&format!("models_{test}")), spec, main)
}

/// The same in a folder that may hold further headers.
fn run_in(folder: PathBuf, spec: &Spec, main: &str) -> Vec<Vec<f64>> {
    for file in ptc_codegen::generate(spec, Language::C).expect("a legal design") {
        fs::write(folder.join(file.name), file.text).expect("a file");
    }
    let name = spec.name();
    let head = format!("#include \"{name}.h\"\n#include <math.h>\n#include <stdio.h>\n");
    fs::write(folder.join("main.c"), head + main).expect("a file");
    let built = Command::new("gcc")
        .args(["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-o", "run"])
        .args(["main.c", &format!("{name}.c"), "-lm"])
        .current_dir(&folder)
        .output()
        .expect("gcc");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let told = Command::new(folder.join("run")).output().expect("the program runs");
    assert!(told.status.success(), "{name}: {:?}", told.status);
    let text = String::from_utf8(told.stdout).expect("text");
    let number = |word: &str| word.parse().expect("a number");
    text.lines().map(|line| line.split_whitespace().map(number).collect()).collect()
}

/// What the self-test of the controller of `spec` finds wrong: it compares the emitted C with the
/// definition in long arithmetic.
pub(super) fn selftest(test: &str, spec: &Spec) -> f64 {
    let name = spec.name();
    let folder = support::folder(&format!("models_selftest_{test}"));
    let own = ptc_codegen::generate_selftest(spec).expect("a self-test");
    let source = own.iter().find(|file| file.name.ends_with(".c")).expect("a source");
    let header = own.iter().find(|file| file.name.ends_with(".h")).expect("a header");
    fs::write(folder.join(&header.name), &header.text).expect("a file");
    let main = format!(
        "#include \"{}\"\n{}\nint main(void)\n{{\n    printf(\"%u\\n\", (unsigned){name}_selftest());\n    return 0;\n}}\n",
        header.name, source.text
    );
    run_in(folder, spec, &main)[0][0]
}
