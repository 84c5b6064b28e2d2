//! What users install: the packaged crates, built as they are unpacked, and the command of the wheel.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};

use super::module;
use crate::context::{Context, workspace};
use crate::harness::command::{succeed, text};
use crate::harness::empty;
use crate::layer::{Finding, Layer, Table};
use crate::tool::{GCC, PYTHON, RUSTC};

pub(super) const LAYER: Layer = Layer {
    name: "packages",
    claim: "The packaged crates build from what is in them, and the wheel installs a command that \
            emits.",
    tools: &[GCC, RUSTC, PYTHON],
    run,
};

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("packages");
    let target = context.target();
    let mut finding = Finding::default();
    let crates = package(workspace(), target)?;
    let mut rows = Vec::new();
    for package in &crates {
        let files = text(Command::new("tar").arg("-tzf").arg(package))?.lines().count();
        let name = package.file_name().map(|name| name.to_string_lossy().into_owned());
        rows.push(vec![
            name.unwrap_or_default(),
            files.to_string(),
            fs::metadata(package)?.len().to_string(),
            "built by cargo from what is in it".to_owned(),
        ]);
    }
    let source = unpacked(target)?;
    let installed = empty(&folder.join("installed"));
    // Debug, as cargo has built it by now.
    succeed(
        cargo(target)
            .args(["install", "--quiet", "--debug", "--path"])
            .arg(&source)
            .arg("--root")
            .arg(&installed),
    )?;
    emits(&installed.join("bin/ptc-codegen"), &folder)?;
    let wheel = module::wheel(context, &folder)?;
    let command = installed_by_pip(&wheel, &folder)?;
    emits(&command, &folder)?;
    rows.push(vec![
        wheel.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default(),
        "a module and a command".to_owned(),
        fs::metadata(&wheel)?.len().to_string(),
        "installed by pip in a fresh environment, where `ptc-codegen emit` writes C, an FMU and a \
         project"
            .to_owned(),
    ]);
    finding.summary =
        format!("{} crates packaged and built, 1 wheel built and installed", crates.len());
    finding.tables.push(Table {
        title: "Packages".to_owned(),
        head: vec!["package", "files", "bytes", "tried"],
        rows,
    });
    // What include_str! and the templates read is not there in such a package.
    fs::remove_dir_all(source.join("templates"))?;
    let built = succeed(cargo(target).args(["check", "--quiet"]).current_dir(&source));
    let told = |error: anyhow::Error| {
        let text = format!("{error:#}");
        text.lines().find(|line| line.starts_with("error")).map(str::to_owned)
    };
    finding.seed("templates left out of the package", built.err().and_then(told));
    Ok(finding)
}

/// A program that builds in `target` without lines for a debugger, as the workspace builds its
/// dependencies, so that these serve again.
pub(super) fn building(program: &OsStr, target: &Path) -> Command {
    let mut command = Command::new(program);
    command.env("CARGO_TARGET_DIR", target).env("CARGO_PROFILE_DEV_DEBUG", "false");
    command
}

fn cargo(target: &Path) -> Command {
    building("cargo".as_ref(), target)
}

/// The crates that are published, packaged together, as they depend on one another; cargo builds
/// each of them from its package.
fn package(workspace: &Path, target: &Path) -> Result<Vec<PathBuf>> {
    let excluded = ["ptc-bench", "ptc-assure", "ptc-explorer", "ptc-explorer-page"];
    let packages = empty(&target.join("package"));
    forget_unpacked()?;
    succeed(
        cargo(target)
            .args(["package", "--quiet", "--workspace", "--allow-dirty"])
            .args(excluded.iter().flat_map(|name| ["--exclude", name]))
            .current_dir(workspace),
    )?;
    let mut crates = Vec::new();
    for entry in fs::read_dir(packages)? {
        let path = entry?.path();
        crates.extend(path.extension().is_some_and(|e| e == "crate").then_some(path));
    }
    crates.sort();
    ensure!(crates.len() == 3, "ptc, ptc-codegen and ptc-macros are packaged: {crates:?}");
    Ok(crates)
}

/// Removes what cargo keeps unpacked of packages of this workspace. It takes a version for all that it
/// will ever hold, and would build a later state of the same version from the earlier one.
fn forget_unpacked() -> Result<()> {
    let own = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let user = std::env::var_os("HOME").map(|home| Path::new(&home).join(".cargo"));
    let Some(home) = own.or(user) else { return Ok(()) };
    let Ok(registries) = fs::read_dir(home.join("registry/src")) else { return Ok(()) };
    for registry in registries {
        let registry = registry?;
        // That of a folder has no name in front of its hash.
        if !registry.file_name().to_string_lossy().starts_with('-') {
            continue;
        }
        for name in ["ptc", "ptc-codegen", "ptc-macros"] {
            let unpacked = registry.path().join(format!("{name}-{}", env!("CARGO_PKG_VERSION")));
            if unpacked.is_dir() {
                fs::remove_dir_all(unpacked)?;
            }
        }
    }
    Ok(())
}

/// The folder in which cargo unpacked and built the crate of the command.
fn unpacked(target: &Path) -> Result<PathBuf> {
    let folder = target.join(format!("package/ptc-codegen-{}", env!("CARGO_PKG_VERSION")));
    // A separate workspace, though its folder is below another one.
    let manifest = folder.join("Cargo.toml");
    let text = fs::read_to_string(&manifest).context("the unpacked crate of the command")?;
    fs::write(&manifest, format!("{text}\n[workspace]\n"))?;
    Ok(folder)
}

/// Installs the wheel alone in a fresh environment: its command, which needs nothing else.
fn installed_by_pip(wheel: &Path, folder: &Path) -> Result<PathBuf> {
    let environment = empty(&folder.join("environment"));
    succeed(Command::new("python3").args(["-m", "venv"]).arg(&environment))?;
    let pip = environment.join("bin/pip");
    succeed(Command::new(pip).args(["install", "--quiet", "--no-index", "--no-deps"]).arg(wheel))?;
    Ok(environment.join("bin/ptc-codegen"))
}

/// Has an installed command print its version and emit what needs each kind of template.
fn emits(command: &Path, folder: &Path) -> Result<()> {
    let version = text(Command::new(command).arg("--version"))?;
    ensure!(version.contains(env!("CARGO_PKG_VERSION")), "{version}");
    let out = empty(&folder.join("emitted"));
    for (words, file) in [
        (["--lang", "c"], "stage.c"),
        (["--lang", "rust"], "stage.rs"),
        (["--lang", "fmu3"], "stage.fmu"),
    ] {
        let design = ["--n=2", "--mu=exp", "--name=stage", "-o"];
        succeed(Command::new(command).arg("emit").args(words).args(design).arg(&out))?;
        ensure!(out.join(file).is_file(), "{file} is not there");
    }
    let project = ["emit", "--project=cortex-m", "--n=2", "--mu=exp", "--name=stage", "-o"];
    succeed(Command::new(command).args(project).arg(out.join("firmware")))?;
    ensure!(out.join("firmware/Makefile").is_file(), "the project is not there");
    Ok(())
}
