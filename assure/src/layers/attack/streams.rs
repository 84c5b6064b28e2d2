//! Standard outputs that are full or closed.

use std::process::{Command, Output};

use anyhow::{Context as _, Result};

use super::world::{FILE, World, names};
use crate::layer::Finding;

/// Command lines whose result is what they print.
const PRINTED: [&str; 9] = [
    "--help",
    "--version",
    "emit --help",
    "list",
    "schema",
    "show law --n 2 --mu exp",
    "emit --lang c --n 2 --mu exp -o -",
    "simulate stage.toml --x0=1 --plant=d=0",
    "verify stage.toml",
];

/// A command line whose result is a file.
const FILES: &str = "emit --lang c --n 2 --mu exp --name roll -o out";

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let folder = world.folder("streams")?;
    let shell = |script: &str| -> Result<Output> {
        let mut command = Command::new("sh");
        command.args(["-c", script]).current_dir(&folder).env("PTC", &world.command);
        command.output().context("a shell")
    };
    let full = |program: &str| -> Result<Option<String>> {
        let end = shell(&format!("{program} >/dev/full"))?;
        let told = String::from_utf8_lossy(&end.stderr);
        let reported = end.status.code() == Some(2) && told.contains("standard output");
        Ok((!reported).then(|| format!("{program} >/dev/full: {}, {told}", end.status)))
    };
    for line in PRINTED {
        finding.failures.extend(full(&format!("\"$PTC\" {line}"))?);
    }
    finding.seed("an output that is lost without a word", full("true")?);
    // A descriptor that is closed is given to the first file that is opened.
    for closed in [">&-", "2>&-", "<&- >&- 2>&-"] {
        let end = shell(&format!("rm -rf out; \"$PTC\" {FILES} {closed}; echo $?"))?;
        let files = names(&folder.join("out")).unwrap_or_default();
        let text = std::fs::read_to_string(folder.join("out/roll.h")).unwrap_or_default();
        // What is printed beside it goes where it is not closed.
        if !end.stdout.ends_with(b"0\n") || files != ["roll.c", "roll.h"] || text.contains("wrote")
        {
            finding
                .failures
                .push(format!("{closed}: {files:?}, {}", String::from_utf8_lossy(&end.stdout)));
        }
    }
    if names(&folder)? != ["out", FILE] {
        finding.failures.push(format!("{:?} after closed streams", names(&folder)?));
    }
    // A folder for temporary files that is not there.
    let end = shell(&format!("TMPDIR=/no/such/folder \"$PTC\" verify {FILE} --out - >/dev/null"))?;
    let told = String::from_utf8_lossy(&end.stderr);
    if end.status.code() != Some(2) || !told.contains("/no/such/folder") {
        finding.failures.push(format!("TMPDIR: {}, {told}", end.status));
    }
    Ok(format!("{} outputs to a full device, each an error; closed streams", PRINTED.len()))
}
