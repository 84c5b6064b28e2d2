//! A disk that is full and a folder that is read-only, each a file system of its own in a namespace
//! of its own.

use std::path::Path;
use std::process::{Command, Output, Stdio};

use anyhow::{Context as _, Result};

use super::world::{FILE, World};
use crate::layer::Finding;

/// Contents of the file on the disk before, which have to be there after.
const OLD: &str = "old";

/// The whole run of a simulation, which is longer than what is left of the disk.
const SIMULATE: &str = "simulate stage.toml --x0=1 --plant=d=0 -o";

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let folder = world.folder("disk")?;
    if !mount(world, &folder, "true")?.status.success() {
        let note = "The attacks on a disk were NOT RUN: file systems cannot be mounted here.";
        finding.notes.push(note.to_owned());
        return Ok("full disk and read-only folder NOT RUN: nothing can be mounted".to_owned());
    }
    let fill = "head -c 1000000 /dev/zero > fill 2>/dev/null; truncate -s -4096 fill";
    let ours = format!("\"$PTC\" {SIMULATE} run.csv");
    finding.failures.extend(full(world, &folder, fill, &ours)?);
    // The writer of before: it opens the file and writes into it.
    let in_place = format!("\"$PTC\" {SIMULATE} - > run.csv");
    finding.seed("a writer in place on a full disk", full(world, &folder, fill, &in_place)?);
    let resume = format!(
        "{fill}; \"$PTC\" verify {FILE} --out rows.parquet; test $? = 2 || exit 10; rm fill; \
         \"$PTC\" verify {FILE} --out rows.parquet >/dev/null || exit 11; ls -A; cat rows.parquet >&2"
    );
    let end = mount(world, &folder, &resume)?;
    if end.status.code() != Some(0) || end.stdout != b"rows.parquet\nrun.csv\nstage.toml\n" {
        finding.failures.push(format!("a campaign on a full disk: {}", said(&end)));
    }
    if !end.stderr.ends_with(&world.rows) {
        finding.failures.push("a campaign that a full disk ended has other rows".to_owned());
    }
    let read_only = |command: &str| -> Result<Option<String>> {
        let script = format!("mount -o remount,ro . && {command}");
        let end = mount(world, &folder, &script)?;
        let told = String::from_utf8_lossy(&end.stderr).into_owned();
        let named = told.contains("cannot write") && told.contains("run");
        Ok((end.status.code() != Some(2) || !named).then(|| said(&end)))
    };
    for command in
        ["simulate stage.toml --x0=1 --plant=d=0 -o run.csv", "verify stage.toml --out run.parquet"]
    {
        finding.failures.extend(read_only(&format!("\"$PTC\" {command}"))?);
    }
    finding.seed("a failure without a reason", read_only("exit 2")?);
    Ok("a full disk and a read-only folder: an error, and every file as it was".to_owned())
}

/// Returns the loss that a command causes where the disk is full.
fn full(world: &World, folder: &Path, fill: &str, command: &str) -> Result<Option<String>> {
    let script = format!("{fill}; {command}; test $? = 2 || exit 10; ls -A; cat run.csv");
    let end = mount(world, folder, &script)?;
    let kept = end.stdout == format!("fill\nrun.csv\nstage.toml\n{OLD}").as_bytes();
    Ok((end.status.code() != Some(0) || !kept).then(|| format!("on a full disk: {}", said(&end))))
}

/// Runs a script in a small file system that holds the design and an old file, and is gone after it.
fn mount(world: &World, folder: &Path, script: &str) -> Result<Output> {
    let prepare = "mkdir -p disk && mount -t tmpfs -o size=128k tmpfs disk && cd disk && \
                   cp ../stage.toml . && printf old > run.csv || exit 9";
    let mut command = Command::new("unshare");
    command.args(["--mount", "sh", "-c", &format!("{prepare}; {script}")]);
    command.current_dir(folder).env("PTC", &world.command).stdin(Stdio::null());
    match command.output() {
        // A system without namespaces.
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            Command::new("false").output().context("false")
        }
        end => end.context("unshare"),
    }
}

fn said(end: &Output) -> String {
    let [out, error] = [&end.stdout, &end.stderr]
        .map(|bytes| String::from_utf8_lossy(&bytes[..bytes.len().min(400)]).into_owned());
    format!("{}, {out}{error}", end.status)
}
