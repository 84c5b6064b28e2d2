//! `generator`: what generating costs, as a whole process and for the Bell polynomials alone.

use std::hint::black_box;
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

use ptc_codegen::expansion::bell::bell_table;
use ptc_codegen::family::FAMILIES;
use serde::{Deserialize, Serialize};

use crate::failure::Result;
use crate::peers::OURS;
use crate::tools::{binaries, parallel, run, scratch, workspace};
use crate::{callgrind, tools};

/// Runs of which the fastest is taken.
const RUNS: usize = 20;

/// Order up to which the Bell polynomials are expanded.
const BELL: usize = 30;

/// The orders at which other tools expand them.
const BESIDE: [usize; 4] = [8, 12, 20, 30];

/// The argument that makes this program expand them and nothing else.
pub(crate) const PROBE: &str = "probe-bell";

/// One measured thing.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Speed {
    pub(crate) what: String,
    pub(crate) instructions: u64,
    pub(crate) milliseconds: f64,
}

/// Cost of the Bell polynomials in one tool.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Bell {
    pub(crate) tool: String,
    /// Order up to which they are expanded.
    pub(crate) n: usize,
    pub(crate) seconds: f64,
    /// Terms of all of them.
    pub(crate) terms: u64,
}

/// Ours and those of the peers' tools; only ours where their Python is not set up.
pub(crate) fn bells() -> Result<Vec<Bell>> {
    let mut bells = Vec::new();
    for n in BESIDE {
        let time = best(|| {
            black_box(bell_table(black_box(n)));
            Ok(())
        })?;
        let table = bell_table(n);
        let terms = table.iter().flatten().map(|entry| entry.terms().count() as u64).sum();
        bells.push(Bell { tool: OURS.to_owned(), n, seconds: time.as_secs_f64(), terms });
    }
    let folder = workspace().join("bench/peers");
    let python = folder.join("venv/bin/python");
    if python.is_file() {
        let text = run(Command::new(python).arg(folder.join("bell.py")))?;
        bells.extend(serde_json::from_str::<Vec<Bell>>(&text)?);
    } else {
        println!("Bell polynomials of other tools: not run, there is no {}", python.display());
    }
    Ok(bells)
}

/// Measures `emit` for each family at n = 3 and n = 12, and the Bell polynomials.
pub(crate) fn measure() -> Result<Vec<Speed>> {
    callgrind::available()?;
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    run(Command::new(cargo).current_dir(workspace()).args([
        "build",
        "--release",
        "-p",
        "ptc-codegen",
    ]))?;
    let program = binaries()?.join("ptc-codegen");
    let folder = scratch("generator")?;
    let mut runs: Vec<(PathBuf, String)> = Vec::new();
    for info in &FAMILIES {
        for n in [3, 12] {
            let mu = if info.name == "exp_sum" { "exp_sum(2)" } else { info.name };
            runs.push((program.clone(), format!("emit --lang c --n {n} --mu {mu} -o out")));
        }
    }
    runs.push((std::env::current_exe()?, PROBE.to_owned()));
    let instructions = parallel(&runs, |(program, arguments)| {
        let arguments: Vec<_> = arguments.split(' ').map(|word| inside(&folder, word)).collect();
        let words: Vec<_> = arguments.iter().map(String::as_str).collect();
        let out = folder.join(format!("{}.callgrind", words.join("").replace('/', "_")));
        let profile = callgrind::profile(program, &words, &out)?;
        if words == [PROBE] {
            return Ok(profile.of("ptc_bench::generator::ptc_bench_bell")?.instructions);
        }
        Ok(profile.total)
    })?;
    // Times one after the other, on a machine that does nothing else of ours.
    let mut speeds = Vec::new();
    for ((program, arguments), instructions) in runs.iter().zip(instructions) {
        let (what, time) = if arguments == PROBE {
            let what = format!("all B_{{i,j}} up to {BELL}, in process");
            (
                what,
                best(|| {
                    ptc_bench_bell();
                    Ok(())
                })?,
            )
        } else {
            let time = best(|| {
                let words = arguments.split(' ').map(|word| inside(&folder, word));
                tools::run(Command::new(program).args(words)).map(drop)
            })?;
            (format!("ptc-codegen {}", arguments.replace(" -o out", "")), time)
        };
        speeds.push(Speed { what, instructions, milliseconds: time.as_secs_f64() * 1e3 });
    }
    Ok(speeds)
}

/// Computation that [`PROBE`] runs.
#[inline(never)]
pub(crate) fn ptc_bench_bell() -> usize {
    black_box(bell_table(black_box(BELL))).len()
}

/// `word`, or the folder where it stands for that of the output.
fn inside(folder: &std::path::Path, word: &str) -> String {
    if word == "out" { folder.display().to_string() } else { word.to_owned() }
}

fn best(mut job: impl FnMut() -> Result<()>) -> Result<Duration> {
    let mut best = Duration::MAX;
    for _ in 0..RUNS {
        let start = Instant::now();
        job()?;
        best = best.min(start.elapsed());
    }
    Ok(best)
}
