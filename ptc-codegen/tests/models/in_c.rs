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

/// u at each of these times and states, with static parameters `params`.
pub(super) fn inputs<const N: usize>(
    test: &str,
    spec: &Spec,
    params: &str,
    calls: &[(f64, [f64; N])],
) -> Vec<f64> {
    let rows: Vec<_> = calls
        .iter()
        .map(|(t, x)| {
            let x: Vec<_> = x.iter().map(|x| format!("{x:e}")).collect();
            format!("{{ {t:e}, {} }}", x.join(", "))
        })
        .collect();
    let name = spec.name();
    let main = format!(
        "{params}\n\
         static const double calls[][{}] = {{ {} }};\n\
         int main(void)\n{{\n    {name} control;\n\
         \x20   if ({name}_init(&control, &params) != PTC_OK) {{ return 1; }}\n\
         \x20   for (unsigned i = 0; i < sizeof calls / sizeof calls[0]; i++) {{\n\
         \x20       double u;\n\
         \x20       if ({name}_step(&control, calls[i][0], calls[i] + 1, &u) < 0) {{ return 2; }}\n\
         \x20       printf(\"%.17g\\n\", u);\n    }}\n    return 0;\n}}\n",
        N + 1,
        rows.join(", ")
    );
    run(test, spec, &main).into_iter().map(|line| line[0]).collect()
}
