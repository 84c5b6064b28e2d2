//! Behaviour of the emitted C at the edges of its accepted inputs and in closed loop; the checks are in
//! support/behaviour.c.

use crate::support;

use std::path::{Path, PathBuf};
use std::process::Command;

use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;
use support::{STRICT, c_compiler, folder, run, specs, tolerance, write};

/// The controllers of the C program, of all of which one source is made.
fn controllers() -> Vec<Spec> {
    let all_fixed = [("gains", "6,5"), ("tau", "1"), ("eps", "0.125")];
    let spec = |keys: &[&[(&str, &str)]]| specs::spec(&keys.concat());
    vec![
        spec(&[&[("n", "1"), ("mu", "exp"), ("name", "exp_1")]]),
        spec(&[&[("n", "2"), ("mu", "exp"), ("name", "exp_2")]]),
        spec(&[&[("n", "2"), ("mu", "rational"), ("name", "rational_2")]]),
        spec(&[&[("n", "2"), ("mu", "power"), ("name", "power_2")]]),
        spec(&[&[("n", "2"), ("mu", "exp_sum"), ("name", "sum_2")]]),
        spec(&[&[("n", "2"), ("mu", "exp"), ("name", "single"), ("precision", "f32")]]),
        spec(&[
            &[("n", "2"), ("mu", "exp(a=1)"), ("name", "bare"), ("t0", "0"), ("u_max", "inf")],
            &all_fixed,
        ]),
        spec(&[
            &[("n", "2"), ("mu", "exp(a=1)"), ("name", "bounded"), ("u_max", "2.5")],
            &all_fixed,
        ]),
    ]
}

/// The C sources of the controllers, in `folder`.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let files = controllers().into_iter().flat_map(|spec| write(folder, &spec, Language::C));
    files.filter(|file| file.extension().is_some_and(|e| e == "c")).collect()
}

fn behaves(test: &str, mut compiler: Command) {
    let folder = folder(test);
    let sources = sources(&folder);
    let program = folder.join("behaviour");
    run(compiler
        .args(STRICT)
        .arg("-I")
        .arg(&folder)
        .arg(format!("-DTRAJECTORY={:e}", tolerance::TRAJECTORY))
        .arg(format!("-DSIMULATION={:e}", tolerance::SIMULATION))
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/emitted/behaviour.c"))
        .args(sources)
        .arg("-o")
        .arg(&program)
        .arg("-lm"));
    let output = Command::new(&program).output().expect("a program");
    let told = String::from_utf8_lossy(&output.stdout);
    println!("{told}");
    assert!(output.status.success(), "{}\n{told}", output.status);
}

#[test]
fn c_behaves() {
    behaves("behaviour", c_compiler());
}

/// The same with another compiler, where it is installed.
#[test]
fn c_behaves_with_clang() {
    if Command::new("clang").arg("--version").output().is_err() {
        eprintln!("not run: clang is not installed");
        return;
    }
    behaves("behaviour_clang", Command::new("clang"));
}

/// C++ takes the headers, all in one file, and links with the C functions.
#[test]
fn headers_are_cpp_too() {
    let mut cpp = Command::new(std::env::var_os("CXX").unwrap_or_else(|| "g++".into()));
    if cpp.arg("--version").output().is_err() {
        eprintln!("not run: g++ is not installed");
        return;
    }
    let folder = folder("cpp");
    let mut text = String::new();
    for spec in controllers() {
        write(&folder, &spec, Language::C);
        // Twice, for a header may be met more than once.
        text.push_str(&format!("#include \"{0}.h\"\n#include \"{0}.h\"\n", spec.name()));
    }
    text.push_str(
        "int main() { exp_2 self; exp_2_params params = {1, 0, 0.1, 1, 1, {6, 5}}; \
         return exp_2_init(&self, &params) == PTC_OK ? 0 : 1; }\n",
    );
    let (main, object, program) =
        (folder.join("main.cpp"), folder.join("exp_2.o"), folder.join("main"));
    std::fs::write(&main, text).expect("a program");
    run(c_compiler().args(STRICT).arg("-c").arg(folder.join("exp_2.c")).arg("-o").arg(&object));
    let mut cpp = Command::new(cpp.get_program());
    run(cpp
        .args(["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I"])
        .arg(&folder)
        .args([&main, &object])
        .arg("-o")
        .arg(&program)
        .arg("-lm"));
    run(&mut Command::new(&program));
}
