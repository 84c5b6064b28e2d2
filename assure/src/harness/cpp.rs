//! Controllers in C++ as programs that read records and write outcomes.

use std::path::Path;
use std::process::Command;

use ptc_codegen::request::Spec;

use super::program::{Program, driver, glue_arguments, main_arguments};
use super::run;

/// The strict C++ flags: those of C and C++'s own, as for firmware, and no contraction.
pub const STRICT_CPP: [&str; 18] = [
    "-std=c++17",
    "-O2",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wsign-conversion",
    "-Wdouble-promotion",
    "-Wfloat-equal",
    "-Wshadow",
    "-Wold-style-cast",
    "-Wcast-align",
    "-Wnon-virtual-dtor",
    "-Woverloaded-virtual",
    "-Werror",
    "-fno-exceptions",
    "-fno-rtti",
    "-ffp-contract=off",
];

/// The C++ compiler of this machine: `CXX`, else g++.
pub fn cpp_compiler() -> Command {
    Command::new(std::env::var_os("CXX").unwrap_or_else(|| "g++".into()))
}

/// The program for the header of `spec` in `folder`.
pub fn in_cpp_from(folder: &Path, spec: &Spec) -> Program {
    let (object, path) = (folder.join("glue.o"), folder.join("program"));
    run(cpp_compiler()
        .args(STRICT_CPP)
        .args(glue_arguments(folder, spec, &spec.type_name(), &format!("{}.hpp", spec.name())))
        .arg("-c")
        .arg(driver("glue.cpp"))
        .arg("-o")
        .arg(&object));
    run(cpp_compiler()
        .args(["-x", "c++"])
        .args(main_arguments(folder, &[spec]))
        .args(["-x", "none"])
        .arg(object)
        .arg("-o")
        .arg(&path));
    Program::of_one(path, spec.precision)
}
