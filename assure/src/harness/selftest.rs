//! A controller with its self-test, as sources and as a program.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow};
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::write;

/// Writes a controller and its self-test to `folder`: their sources, that of the controller first.
///
/// # Errors
/// Fails if the design has no self-test or a file cannot be written.
pub fn sources(folder: &Path, spec: &Spec) -> Result<[PathBuf; 2]> {
    write(folder, spec, Language::C);
    write_selftest(folder, spec)
}

/// The same beside a controller that is in `folder` already.
///
/// # Errors
/// Fails if the design has no self-test or a file cannot be written.
pub fn write_selftest(folder: &Path, spec: &Spec) -> Result<[PathBuf; 2]> {
    let files = ptc_codegen::generate_selftest(spec)
        .map_err(|found| anyhow!("{}", found.first().map_or("", |one| &one.message)))?;
    for file in files {
        fs::write(folder.join(file.name), file.text)?;
    }
    let name = spec.name();
    Ok([folder.join(format!("{name}.c")), folder.join(format!("{name}_selftest.c"))])
}

/// Writes a main program whose exit code is 1 where the self-test counts failures.
///
/// # Errors
/// A file that cannot be written.
pub fn main_program(folder: &Path, spec: &Spec) -> Result<PathBuf> {
    let (name, path) = (spec.name(), folder.join("main.c"));
    let text = format!(
        "#include \"{name}_selftest.h\"\n\nint main(void)\n{{\n    return ({name}_selftest() == 0U) ? 0 : 1;\n}}\n"
    );
    fs::write(&path, text)?;
    Ok(path)
}
