//! The wheel, and the Python module in it, against the command.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};

use super::command::generator;
use super::packages::building;
use crate::context::{Context, workspace};
use crate::harness::command::{succeed, text};
use crate::harness::{empty, runtime};
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, PYTHON, RUSTC};

/// Build requirement of `pip install .` for a wheel, installed for the layers alone.
const MATURIN: &str = "maturin>=1.9,<2";

const SCRIPT: &str = include_str!("module.py");

pub(super) const LAYER: Layer = Layer {
    name: "module",
    claim: "The Python module emits the files of the command, gives its verdicts and the bits of its \
            simulations and campaigns, reports every mistake, and stops on request; its crate has no warning; and the \
            command of the wheel is the program, with its exit codes, streams and signals.",
    tools: &[GCC, RUSTC, PYTHON],
    run,
};

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("module");
    let generator = generator()?;
    let wheel = wheel(context, &folder)?;
    let packages = ["anywidget", "mypy", "numpy>=1.26", "pandas", "pandas-stubs", "ruff"];
    let python = runtime::python(&context.shared("module"), &packages)?;
    let install = ["-m", "pip", "install", "-q", "--no-deps", "--force-reinstall"];
    succeed(Command::new(&python).args(install).arg(&wheel))?;
    let script = folder.join("module.py");
    fs::write(&script, SCRIPT)?;
    let compare = |more: &[&str]| {
        let mut command = Command::new(&python);
        command.arg(&script).arg(&generator).arg(python.with_file_name("ptc-codegen"));
        command.arg(workspace()).args(more);
        command
    };
    let mut finding = Finding::default();
    match text(&mut compare(&[])) {
        Ok(told) => finding.summary = told.trim().to_owned(),
        Err(wrong) => finding.failures.push(format!("{wrong:#}")),
    }
    let defect = compare(&["--defect"]).output()?;
    let told = String::from_utf8_lossy(&defect.stderr).lines().next().map(str::to_owned);
    let caught = told.filter(|_| !defect.status.success());
    finding.seed("a start that is one rounding away", caught);
    let hung = compare(&["--hang"]).output()?;
    let told = String::from_utf8_lossy(&hung.stderr).lines().next().map(str::to_owned);
    finding.seed("a forked process that does not answer", told.filter(|_| !hung.status.success()));
    source(context, &folder)?;
    types(&python, &mut finding);
    versions(&mut finding)?;
    Ok(finding)
}

/// Builds the wheel: its path.
pub(super) fn wheel(context: &Context, folder: &Path) -> Result<PathBuf> {
    let python = runtime::python(&context.shared("maturin"), &[MATURIN])?;
    let wheels = empty(&folder.join("wheels"));
    let mut maturin = building(python.as_ref(), context.target());
    maturin.args(["-m", "maturin", "build", "--quiet", "--profile", "dev", "--out"]).arg(&wheels);
    // Where clippy is there, it compiles the crate of the module, and so lints it.
    let clippy = Command::new("clippy-driver").arg("--version").output();
    if clippy.is_ok_and(|output| output.status.success()) {
        maturin.env("RUSTC_WORKSPACE_WRAPPER", "clippy-driver");
        maturin.env("CLIPPY_ARGS", "-D__CLIPPY_HACKERY__warnings");
    }
    succeed(maturin.current_dir(workspace()))?;
    Ok(fs::read_dir(&wheels)?.next().context("a wheel")??.path())
}

/// The source distribution holds all manifests that its crates need.
fn source(context: &Context, folder: &Path) -> Result<()> {
    let python = runtime::python(&context.shared("maturin"), &[MATURIN])?;
    let home = empty(&folder.join("source"));
    let mut maturin = Command::new(python);
    maturin.args(["-m", "maturin", "sdist", "--out"]).arg(&home);
    succeed(maturin.current_dir(workspace()))?;
    let archive = fs::read_dir(&home)?.next().context("a source distribution")??.path();
    let unpacked = empty(&folder.join("unpacked"));
    let mut tar = Command::new("tar");
    succeed(tar.arg("-xzf").arg(archive).arg("-C").arg(&unpacked).arg("--strip-components=1"))?;
    let mut cargo = Command::new("cargo");
    cargo.args(["metadata", "--locked", "--format-version=1", "--quiet"]);
    succeed(cargo.current_dir(unpacked.join("python"))).map(|_| ())
}

/// The types of the package, those that it gives the extension module, and its style.
fn types(python: &Path, finding: &mut Finding) {
    let source = workspace().join("python/ptc_codegen");
    let source = source.as_os_str();
    for arguments in [
        &["mypy".as_ref(), "--strict".as_ref(), "--no-error-summary".as_ref(), source][..],
        &["mypy.stubtest".as_ref(), "ptc_codegen._ptc".as_ref()],
        // The oldest Python that the package takes: what newer ones prefer is not there.
        &[
            "ruff".as_ref(),
            "check".as_ref(),
            "--isolated".as_ref(),
            "--no-cache".as_ref(),
            "--target-version=py39".as_ref(),
            source,
        ],
    ] {
        let mut command = Command::new(python);
        // Beside the sources a checker would take them for another package.
        command.arg("-m").args(arguments).current_dir(python.parent().unwrap_or(Path::new("/")));
        finding.failures.extend(succeed(&mut command).err().map(|wrong| format!("{wrong:#}")));
    }
}

/// The wheel has a lock file of its own: what is in both has one version, so that both round alike.
fn versions(finding: &mut Finding) -> Result<()> {
    let read = |path: &str| fs::read_to_string(workspace().join(path));
    let (own, all) = (read("python/Cargo.lock")?, read("Cargo.lock")?);
    let (own, all) = (packages(&own), packages(&all));
    ensure!(!own.is_empty(), "python/Cargo.lock names no package");
    let known = |name: &str| all.iter().any(|(other, _)| *other == name);
    let other = own.iter().filter(|package| known(package.0) && !all.contains(package));
    finding.failures.extend(other.map(|(name, version)| {
        format!("python/Cargo.lock has {name} {version}, Cargo.lock another version: copy it there, and run cargo check in python/")
    }));
    Ok(())
}

/// Names and versions of a lock file.
fn packages(lock: &str) -> Vec<(&str, &str)> {
    let value =
        |line: &'static str| move |text| str::strip_suffix(str::strip_prefix(text, line)?, '"');
    let names = lock.lines().filter_map(value("name = \""));
    // The first line is the version of the format, which is a number without quotes.
    names.zip(lock.lines().filter_map(value("version = \""))).collect()
}
