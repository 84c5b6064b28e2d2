//! The emitted C behind a main function.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use crate::support;

/// Runs the controller of `spec` with `main` in C, and returns the numbers of each line that it prints.
#[track_caller]
pub(crate) fn run(test: &str, spec: &Spec, main: &str) -> Vec<Vec<f64>> {
    run_in(support::folder(test), spec, main)
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

/// A function that advances `x`, of order `n`, from t over a time h by the method of Runge and Kutta of order
/// four, with the rates of the function `rates`; whether these were refused.
pub(crate) fn advance(n: usize) -> String {
    format!(
        "static int advance(double t, double h, double *x)\n{{\n    double k[4][{n}], y[{n}];\n\
         \x20   const double part[4] = {{ 0.0, 0.5, 0.5, 1.0 }}, weight[4] = {{ 1.0, 2.0, 2.0, 1.0 }};\n\
         \x20   for (int s = 0; s < 4; s++) {{\n\
         \x20       for (int j = 0; j < {n}; j++) {{ y[j] = x[j] + (s > 0 ? part[s] * h * k[s - 1][j] : 0.0); }}\n\
         \x20       if (rates(t + part[s] * h, y, k[s])) {{ return 1; }}\n    }}\n\
         \x20   for (int j = 0; j < {n}; j++) {{\n\
         \x20       for (int s = 0; s < 4; s++) {{ x[j] += h / 6.0 * weight[s] * k[s][j]; }}\n    }}\n\
         \x20   return 0;\n}}\n"
    )
}

/// Returns the result of the self-test of the controller of `spec`, which compares the emitted C with the
/// definition in long arithmetic.
#[track_caller]
pub(crate) fn selftest(test: &str, spec: &Spec) -> f64 {
    selftest_of(test, spec, spec)
}

/// Returns the result of the self-test of `spec` on another controller with the same name and parameters.
#[track_caller]
pub(crate) fn selftest_of(test: &str, spec: &Spec, other: &Spec) -> f64 {
    let name = spec.name();
    let folder = support::folder(&format!("selftest_{test}"));
    let own = ptc_codegen::generate_selftest(spec).expect("a self-test");
    let source = own.iter().find(|file| file.name.ends_with(".c")).expect("a source");
    let header = own.iter().find(|file| file.name.ends_with(".h")).expect("a header");
    fs::write(folder.join(&header.name), &header.text).expect("a file");
    let main = format!(
        "#include \"{}\"\n{}\nint main(void)\n{{\n    printf(\"%u\\n\", (unsigned){name}_selftest());\n    return 0;\n}}\n",
        header.name, source.text
    );
    run_in(folder, other, &main)[0][0]
}
