//! Long runs and many threads under limits of memory.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;

use anyhow::Result;

use super::inputs::limited_to;
use super::world::{FILE, World};
use crate::layer::Finding;

/// Samples of a run, and the address space in KB that it may take.
const LONG: (u32, u64) = (10_000_000, 500_000);
const BRIEF: (u32, u64) = (300_000, 150_000);

/// Seconds of the processor that it may take; nothing hangs.
const SECONDS: u64 = 600;

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let folder = world.folder("memory")?;
    let (samples, memory) = if world.brief { BRIEF } else { LONG };
    let period = format!("--sample-time={:e}", 1.0 / f64::from(samples));
    let run =
        ["simulate", FILE, "--x0=1", "--plant=d=0", &period, "--plot=run.svg", "-o", "run.csv"];
    let fits = |program: &Path, arguments: &[&str]| -> Result<Option<String>> {
        let words: Vec<_> = arguments.iter().map(|word| (*word).to_owned()).collect();
        let end = limited_to((memory, SECONDS), program, &words, &folder)?;
        let told = String::from_utf8_lossy(&end.stderr);
        Ok((!end.status.success())
            .then(|| format!("{arguments:?} in {memory} KB: {}, {told}", end.status)))
    };
    finding.failures.extend(fits(&world.command, &run)?);
    let rows = BufReader::new(fs::File::open(folder.join("run.csv"))?).lines().count();
    if rows != samples as usize + 2 {
        finding.failures.push(format!("{rows} lines for {samples} samples"));
    }
    // A program that holds all rows, three times as often as a shell does.
    let held = "x=$(cat run.csv run.csv run.csv run.csv run.csv); test -n \"$x\"";
    finding.seed("a program that holds all rows", fits(Path::new("/bin/sh"), &["-c", held])?);
    // More threads than there is memory for their stacks.
    let threads = "RAYON_NUM_THREADS=99999 exec \"$0\" verify stage.toml";
    let words = ["-c", threads, &world.command.to_string_lossy()].map(str::to_owned);
    let end = limited_to((150_000, SECONDS), Path::new("/bin/sh"), &words, &folder)?;
    if end.stdout != world.verdict || end.status.code() != world.code {
        let told = String::from_utf8_lossy(&end.stderr);
        finding.failures.push(format!("threads that cannot be had: {}, {told}", end.status));
    }
    Ok(format!(
        "{samples} samples in {} MB with their picture, threads that cannot be had",
        memory / 1000
    ))
}
