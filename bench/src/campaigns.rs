//! Campaigns of `verify`: processor time and instructions a scenario, threads, memory.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde::{Deserialize, Serialize};

use crate::callgrind;
use crate::failure::{Failure, Result, While};
use crate::tools::{binaries, run, scratch, workspace};

/// Scenarios of a run at most, beside which what else it does is small; that is taken off all the same.
const SCENARIOS: u32 = 524_288;

/// Processor seconds that a run may take: where a scenario takes milliseconds, fewer will do.
const LONG: f64 = 4.0;

/// Scenarios of the run whose cost is taken off.
const FEW: u32 = 64;

/// The same under callgrind.
const COUNTED: [u32; 2] = [64, 256];

/// Rounds, of which the least time counts.
const ROUNDS: usize = 3;

/// Cost of a campaign.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Campaign {
    pub(crate) what: String,
    /// Instructions a scenario.
    pub(crate) instructions: f64,
    /// Processor milliseconds a scenario, on one thread.
    pub(crate) milliseconds: f64,
    /// Scenarios a second on one thread and on two.
    pub(crate) pace: [f64; 2],
    /// Largest memory of the process, in MB.
    pub(crate) memory: f64,
}

/// The example, and what is other than in it.
fn designs() -> Result<Vec<(String, String)>> {
    let example = workspace().join("examples/campaign.toml");
    let example = std::fs::read_to_string(&example).while_doing(example.display())?;
    let with = |from: &str, to: &str| example.replace(from, to);
    let mut designs = vec![("examples/campaign.toml".to_owned(), example.clone())];
    let families = [
        "rational(a=1)",
        "power(a=1, m=1/2)",
        "tan(a=1)",
        "tanh(a=2)",
        "algebraic(a=1)",
        "exp_sum(rates=[1, 2])",
    ];
    for mu in families {
        designs.push((format!("`{mu}`"), with("exp(a=1)", mu)));
    }
    for n in [1, 2, 6] {
        let poles: Vec<_> = (0..n).map(|i| format!("{}", -(n + 1 + i))).collect();
        let states: String = (1..=n).map(|j| format!("x{j} = [-1, 1]\n")).collect();
        let text = with("n = 3", &format!("n = {n}"))
            .replace("-4, -5, -6", &poles.join(", "))
            .replace("damping*x3", &format!("damping*x{n}"))
            .replace("x1 = [-1, 1]\nx2 = [-1, 1]\nx3 = [-1, 1]\n", &states);
        designs.push((format!("n = {n}"), text));
    }
    designs.push(("`sin(x1)` in f".to_owned(), with("gust -", "sin(x1) + gust -")));
    // No run comes near the first bound, and some to the second.
    for bound in [5000, 500] {
        let text = with("[plant]", &format!("[params]\nu_max = {bound}\n\n[plant]"));
        designs.push((format!("`u_max = {bound}`"), text));
    }
    let linear = example.replace(
        "f = \"gust - damping*x3 + slip*u\"\ndamping = [0, 0.5]\nslip = [-0.2, 0.2]",
        "f = \"gust\"",
    );
    let sampled = linear
        .replace("[plant]", "sample_time = 0.01\n\n[params]\ntau = 1\n\n[plant]")
        .replace("tau = [0.5, 2]\n", "");
    let any = sampled.replace("gust = \"constant\"", "gust = \"any\"");
    designs.push(("linear: f = gust".to_owned(), linear));
    designs.push(("100 samples: f = gust".to_owned(), sampled));
    designs.push(("the same, of any signal".to_owned(), any));
    Ok(designs)
}

/// Measures those whose name has a text in it.
pub(crate) fn measure(only: &str) -> Result<Vec<Campaign>> {
    callgrind::available()?;
    let command = command()?;
    let folder = scratch("campaigns")?;
    let mut found = Vec::new();
    let wanted = designs()?.into_iter().filter(|(what, _)| what.contains(only));
    for (index, (what, text)) in wanted.enumerate() {
        let path = folder.join(format!("{index}.toml"));
        std::fs::write(&path, text).while_doing(path.display())?;
        println!("campaigns: {what}");
        found.push(of_design(&command, &path, what)?);
    }
    Ok(found)
}

fn of_design(command: &Path, design: &Path, what: String) -> Result<Campaign> {
    let few = few_and(1, command, design, FEW)?;
    let more = few_and(1, command, design, 8 * FEW)?;
    let all = scenarios((more.processor - few.processor) / f64::from(7 * FEW));
    let many = few_and(1, command, design, all)?;
    let two = [few_and(2, command, design, FEW)?, few_and(2, command, design, all)?];
    let count = f64::from(all - FEW);
    let pace = |few: &Usage, many: &Usage| count / (many.elapsed - few.elapsed);
    let [less, more] = COUNTED.map(|scenarios| instructions(command, design, scenarios));
    Ok(Campaign {
        what,
        instructions: (more? - less?) / f64::from(COUNTED[1] - COUNTED[0]),
        milliseconds: 1e3 * (many.processor - few.processor) / count,
        pace: [pace(&few, &many), pace(&two[0], &two[1])],
        memory: many.memory.max(two[1].memory),
    })
}

/// Returns the number of scenarios of a run, from the seconds of each beyond the work that all runs share.
fn scenarios(seconds: f64) -> u32 {
    let mut count = SCENARIOS;
    while count > 8 * FEW && seconds * f64::from(count) > LONG {
        count /= 2;
    }
    count
}

/// The command with the laboratory, built as a release is.
fn command() -> Result<PathBuf> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let words = ["build", "--quiet", "--release", "-p", "ptc-codegen", "--features", "lab"];
    run(Command::new(cargo).args(words).current_dir(workspace()))?;
    Ok(binaries()?.join("ptc-codegen"))
}

#[derive(Clone, Copy, Debug)]
struct Usage {
    processor: f64,
    elapsed: f64,
    memory: f64,
}

/// The least of some runs.
fn few_and(threads: u32, command: &Path, design: &Path, scenarios: u32) -> Result<Usage> {
    let mut least = Usage { processor: f64::INFINITY, elapsed: f64::INFINITY, memory: 0.0 };
    for _ in 0..ROUNDS {
        let Usage { processor, elapsed, memory } = once(threads, command, design, scenarios)?;
        least.processor = least.processor.min(processor);
        least.elapsed = least.elapsed.min(elapsed);
        least.memory = least.memory.max(memory);
    }
    Ok(least)
}

/// A run, whatever its verdict is.
fn once(threads: u32, command: &Path, design: &Path, scenarios: u32) -> Result<Usage> {
    let mut time = Command::new("sh");
    time.args(["-c", "/usr/bin/time -q -f '%U %S %e %M' \"$@\" 2>&1 >/dev/null | tail -n 1", "sh"]);
    time.arg(command).arg("verify").arg(design).args(["--scenarios", &scenarios.to_string()]);
    let told = run(time.env("RAYON_NUM_THREADS", threads.to_string()))?;
    let numbers = told.split_whitespace().map(|word| word.parse::<f64>().ok());
    match numbers.collect::<Option<Vec<_>>>().as_deref() {
        Some([user, system, elapsed, kilobytes]) => {
            Ok(Usage { processor: user + system, elapsed: *elapsed, memory: kilobytes / 1024.0 })
        }
        _ => Err(Failure::new(format!("/usr/bin/time printed `{}`", told.trim()))),
    }
}

/// Instructions of a run on one thread.
fn instructions(command: &Path, design: &Path, scenarios: u32) -> Result<f64> {
    let out = design.with_extension("callgrind");
    let words = [
        "-c",
        "valgrind --tool=callgrind --callgrind-out-file=\"$1\" \"$2\" verify \"$3\" --scenarios \"$4\" >/dev/null 2>&1; grep '^totals:' \"$1\"",
        "sh",
    ];
    let mut valgrind = Command::new("sh");
    valgrind.args(words).arg(&out).arg(command).arg(design).arg(scenarios.to_string());
    let told = run(valgrind.env("RAYON_NUM_THREADS", "1"))?;
    let total = told.split_whitespace().nth(1).and_then(|word| word.parse().ok());
    total.ok_or_else(|| Failure::new(format!("callgrind printed `{}`", told.trim())))
}
