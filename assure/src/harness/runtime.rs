//! Controllers run from their source by an interpreter: one process reads a manifest and runs all.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};
use ptc_codegen::emit::{File, Language};
use ptc_codegen::request::{After, Feedback, Spec, What};

use super::empty;
use super::program::{Outcome, Record, as_bytes, as_outcomes, has_gains, real};
use crate::layer::Missing;

/// A controller and the folder of its files.
pub type Home<'a> = (PathBuf, &'a Spec);

/// Writes the files of each controller to a folder of its own below `folder`; those that the
/// language refuses are left out.
pub fn homes<'a>(folder: &Path, specs: &'a [Spec], language: Language) -> Result<Vec<Home<'a>>> {
    let mut homes = Vec::new();
    for (index, spec) in specs.iter().enumerate() {
        let Ok(files) = ptc_codegen::generate(spec, language) else { continue };
        let home = empty(&folder.join(index.to_string()));
        for File { name, text } in files {
            fs::write(home.join(name), text)?;
        }
        homes.push((home, spec));
    }
    Ok(homes)
}

/// Runs `command`, given a manifest, on the records of each controller, and returns the outcomes.
///
/// A line of the manifest has, between tabs: the folder, in which it finds `records.bin` and leaves
/// `outcomes.bin`; the name and the type's name; n; `f64` or `f32`; the parameters, as `tau:0,k:3` with
/// the length of arrays; and whether the controller latches x0, calls pi0, calls a law after
/// the deadline, has tick and axis, is the infinite-time system, and is armed again for three quarters of tau, its first
/// parameter; and how many numbers of a
/// reference it is given.
pub fn outcomes(
    command: &mut Command,
    folder: &Path,
    homes: &[Home<'_>],
    records: &[Vec<Record>],
) -> Result<Vec<Vec<Outcome>>> {
    let mut manifest = String::new();
    for ((home, spec), records) in homes.iter().zip(records) {
        fs::write(home.join("records.bin"), as_bytes(records, spec.precision))?;
        let flags = [
            spec.latches(),
            spec.feedback == Feedback::Extern,
            spec.after == After::Extern,
            has_gains(spec),
            spec.what == What::Associated,
            spec.changes_duration(),
        ];
        let flags = flags.map(|flag| u8::from(flag).to_string()).join("\t");
        let (name, type_name) = (spec.name(), spec.type_name());
        let (home, real) = (home.display(), real(spec.precision));
        let layout = layout(spec);
        writeln!(
            manifest,
            "{home}\t{name}\t{type_name}\t{}\t{real}\t{layout}\t{flags}\t{}",
            spec.n,
            spec.references()
        )?;
    }
    let path = folder.join("manifest.tsv");
    fs::write(&path, manifest)?;
    let output = command.arg(&path).output().with_context(|| format!("{command:?}"))?;
    let told = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{command:?}: {}\n{told}", output.status);
    let read = |((home, spec), records): (&Home<'_>, &Vec<Record>)| {
        let bytes = fs::read(home.join("outcomes.bin"))?;
        let outcomes = as_outcomes(&bytes, spec.precision);
        ensure!(outcomes.len() == records.len(), "{}: too few outcomes", home.display());
        Ok(outcomes)
    };
    homes.iter().zip(records).map(read).collect()
}

/// The run-time parameters with the lengths of arrays, 0 for a scalar.
fn layout(spec: &Spec) -> String {
    let mut layout: Vec<(&str, usize)> = Vec::new();
    for parameter in spec.run_time_parameters() {
        let length = parameter.index().map_or(0, |index| index + 1);
        match layout.last_mut() {
            Some(last) if last.0 == parameter.key() => last.1 = length,
            _ => layout.push((parameter.key(), length)),
        }
    }
    layout.iter().map(|(key, length)| format!("{key}:{length}")).collect::<Vec<_>>().join(",")
}

/// The Python of an environment in `folder` that has `packages`, which it installs where they lack.
///
/// # Errors
/// [`Missing`], where they cannot be had.
pub fn python(folder: &Path, packages: &[&str]) -> Result<PathBuf> {
    let python = folder.join("bin/python");
    let succeeds =
        |command: &mut Command| command.output().is_ok_and(|output| output.status.success());
    let made =
        python.exists() || succeeds(Command::new("python3").args(["-m", "venv"]).arg(folder));
    let mut install = Command::new(&python);
    install.args(["-m", "pip", "install", "-q", "--disable-pip-version-check"]).args(packages);
    if !made || !succeeds(&mut install) {
        let told = format!("pip cannot install {} in {}", packages.join(" "), folder.display());
        return Err(Missing(told).into());
    }
    Ok(python)
}
