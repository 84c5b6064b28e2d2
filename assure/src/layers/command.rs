//! The command `ptc-codegen` of this workspace, as a user runs it.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result};
use ptc_codegen::request::Spec;

use crate::context::workspace;
use crate::harness::command::{succeed, text};

/// Builds the command and returns its path, which is beside this program's.
pub(super) fn generator() -> Result<PathBuf> {
    let own = std::env::current_exe()?;
    let folder = own.parent().context("this program is in a folder")?;
    let mut cargo = Command::new("cargo");
    cargo
        .args(["build", "--quiet", "--package", "ptc-codegen", "--features", "lab"])
        .current_dir(workspace());
    if folder.ends_with("release") {
        cargo.arg("--release");
    }
    let target = folder.parent().context("a folder of cargo's")?;
    succeed(cargo.env("CARGO_TARGET_DIR", target))?;
    Ok(folder.join("ptc-codegen"))
}

/// Runs `emit` on a spec, by the words of its command line.
pub(super) fn emit(generator: &Path, target: &str, spec: &Spec, out: &Path) -> Result<String> {
    let line = format!(
        "'{}' emit {target} {} -o '{}'",
        generator.display(),
        spec.command(),
        out.display()
    );
    text(Command::new("sh").args(["-c", &line]))
}
