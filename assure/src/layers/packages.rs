//! Packages that users install: the packaged crates, built as they are unpacked, and the command of the wheel.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, ensure};

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
    let unpacked = unpacked(&crates, &folder)?;
    succeed(cargo(target).args(["build", "--quiet", "--workspace"]).current_dir(&unpacked))?;
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
    let source = unpacked.join(unpacked_name("ptc-codegen"));
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
    let built = succeed(cargo(target).args(["build", "--quiet"]).current_dir(&source));
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

/// Published crates.
const PUBLISHED: [&str; 3] = ["ptc", "ptc-codegen", "ptc-macros"];

/// The crates that are published, packaged together, as they depend on one another.
fn package(workspace: &Path, target: &Path) -> Result<Vec<PathBuf>> {
    let packages = empty(&target.join("package"));
    succeed(
        cargo(target)
            .args(["package", "--quiet", "--no-verify", "--allow-dirty"])
            .args(PUBLISHED.iter().flat_map(|name| ["--package", name]))
            .current_dir(workspace),
    )?;
    let made = |name: &&str| packages.join(format!("{}.crate", unpacked_name(name)));
    let crates: Vec<_> = PUBLISHED.iter().map(made).collect();
    let lacking = crates.iter().find(|path| !path.is_file());
    ensure!(lacking.is_none(), "{lacking:?} was not made");
    Ok(crates)
}

/// The folder of a package, in its archive.
fn unpacked_name(package: &str) -> String {
    format!("{package}-{}", env!("CARGO_PKG_VERSION"))
}

/// The packages, unpacked into one workspace, in which they are built from what is in them, and the generator once
/// for the command and once for the macro; cargo would verify each of them with a build of its own.
fn unpacked(crates: &[PathBuf], folder: &Path) -> Result<PathBuf> {
    let all = empty(&folder.join("unpacked"));
    for package in crates {
        succeed(Command::new("tar").arg("-xzf").arg(package).arg("-C").arg(&all))?;
    }
    let quoted = |name: &&str| format!("\"{}\"", unpacked_name(name));
    let members = PUBLISHED.iter().map(quoted).collect::<Vec<_>>().join(", ");
    let patch = |name: &&str| format!("{name} = {{ path = {} }}\n", quoted(name));
    let patches: String = PUBLISHED.iter().map(patch).collect();
    let text = format!(
        "[workspace]\nmembers = [{members}]\nresolver = \"3\"\n\n[profile.dev]\nlto = \"off\"\n\n\
         [patch.crates-io]\n{patches}"
    );
    fs::write(all.join("Cargo.toml"), text)?;
    Ok(all)
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
