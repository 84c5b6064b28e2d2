//! No error at run time, proved by Frama-C's plug-in Eva on the harness that `--acsl` writes.

mod log;
mod seeds;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, bail};
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::request::Spec;

use self::log::Log;
use crate::context::Context;
use crate::harness::{empty, in_pairs, in_samples, write_with_proof};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{ShownBy, Source, Tool};

const FRAMA_C: Tool = Tool {
    name: "frama-c",
    shown_by: ShownBy::Command(&["frama-c", "-version"]),
    source: Source::Apt(&["frama-c-base"]),
};

pub(super) const LAYER: Layer = Layer {
    name: "eva",
    claim: "Emitted C has no error at run time with any inputs, and with finite inputs of the \
            envelope no value on the way overflows: proved by Frama-C Eva.",
    tools: &[FRAMA_C],
    run,
};

/// Controllers in one run of Frama-C, which takes half a second to begin.
const BATCH: usize = 5;

/// Random controllers beside the goldens and the families.
const RANDOM: usize = 10;

/// The two modes: their words, what is defined for them, and the special numbers that are errors.
const MODES: [(&str, Option<&str>, &str); 2] =
    [("any inputs", None, "none"), ("finite inputs", Some("-DFINITE"), "non-finite")];

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("eva");
    let mut names = BTreeSet::new();
    let random = context.random(RANDOM).into_iter().map(within_range).collect();
    let mut specs =
        [context.goldens(), context.families(context.order(6)), context.in_samples(), random]
            .map(|specs| context.in_turn(specs))
            .concat();
    // The goldens hold families of the orders 1 to 5. A duration that changes in flight has no contracts.
    specs.retain(|spec| !spec.changes_duration() && names.insert(spec.name()));
    // The iterated ones take longest: first, so that none is waited for at the end.
    specs.sort_by_key(|spec| (!spec.is_iterated(), spec.name()));
    let (iterated, plain): (Vec<Spec>, Vec<Spec>) =
        specs.iter().cloned().partition(Spec::is_iterated);
    let batches = iterated.chunks(1).chain(plain.chunks(BATCH));
    let work: Vec<_> =
        batches.flat_map(|batch| MODES.map(|mode| (batch, mode))).enumerate().collect();
    let told = in_pairs(&work, |(index, (batch, mode))| {
        prove(&empty(&folder.join(index.to_string())), batch, *mode)
    });
    let mut finding = Finding::default();
    let mut sums = [[0; 3]; 2];
    let mut trusted = BTreeSet::new();
    let mut open = Vec::new();
    let mut expected = 0;
    let mut groups = BTreeMap::<(&str, &str), [usize; 3]>::new();
    for ((index, (batch, mode)), log) in work.iter().zip(told) {
        let mut log = log?;
        let sum = &mut sums[usize::from(mode.1.is_some())];
        sum[0] += log.proved;
        sum[1] += log.unproved;
        sum[2] += log.alarms.len();
        for spec in *batch {
            let own = [format!(" {}.", spec.name()), format!("{}_eva.c", spec.name())];
            let counts = groups.entry((in_samples::kind(spec), precision(spec))).or_default();
            let alarms =
                log.alarms.iter().filter(|alarm| own.iter().any(|file| alarm.contains(file)));
            counts[1 + usize::from(mode.1.is_some())] += alarms.count();
            counts[0] += usize::from(mode.1.is_some());
        }
        if mode.1.is_some() && is_open(&batch[0]) && !log.alarms.is_empty() {
            open.push(vec![batch[0].name(), log.alarms.len().to_string(), log.alarms[0].clone()]);
            expected += log.alarms.len();
            log.forgive();
        }
        let named = |fault: &String| format!("run {index}, {}: {fault}", mode.0);
        finding.failures.extend(log.faults().iter().map(named));
        trusted.extend(log.trusted);
    }
    finding.summary = format!(
        "{} controllers, {} properties proved, {} not, {} alarms, {expected} of them expected",
        specs.len(),
        sums[0][0] + sums[1][0],
        sums[0][1] + sums[1][1],
        sums[0][2] + sums[1][2]
    );
    let row = |(mode, sum): (&(&str, _, _), &[usize; 3])| {
        let counts = sum.iter().map(usize::to_string);
        [mode.0.to_owned(), specs.len().to_string()].into_iter().chain(counts).collect()
    };
    finding.tables.push(Table {
        title: "Proofs".to_owned(),
        head: vec!["mode", "controllers", "properties proved", "not proved", "alarms"],
        rows: MODES.iter().zip(&sums).map(row).collect(),
    });
    let row = |((mapping, precision), counts): (&(&str, &str), &[usize; 3])| {
        let counts = counts.iter().map(usize::to_string);
        [*mapping, *precision].map(str::to_owned).into_iter().chain(counts).collect()
    };
    finding.tables.push(Table {
        title: "Alarms".to_owned(),
        head: vec!["mapping", "precision", "controllers", "any inputs", "finite inputs"],
        rows: groups.iter().map(row).collect(),
    });
    if !open.is_empty() {
        let title = "Not proved in finite mode: the root of a mapping of the user's own, whose \
                     bracket is too wide to be split";
        let head = vec!["controller", "alarms", "the first"];
        finding.tables.push(Table { title: title.to_owned(), head, rows: open });
    }
    let trusted: Vec<_> = trusted.into_iter().collect();
    finding.notes.push(format!(
        "Taken from Frama-C's own contracts of the C library: {}.",
        trusted.join(", ")
    ));
    seeds::seeded(&folder, context, &mut finding)?;
    Ok(finding)
}

fn precision(spec: &Spec) -> &'static str {
    if spec.precision == Precision::F32 { "f32" } else { "f64" }
}

/// Returns true if finite mode is known not to be proved: a mapping without a closed inverse has a bracket from the
/// start to far beyond the deadline, in which the iteration may end anywhere for all that Eva sees.
fn is_open(spec: &Spec) -> bool {
    spec.custom().is_some() && spec.is_iterated()
}

/// Without an eps that is fixed where the gains of order 6 then honestly overflow f32: the harness
/// takes a greater one.
fn within_range(mut spec: Spec) -> Spec {
    if spec.precision == Precision::F32 {
        spec.fixed.remove(&Parameter::Eps);
    }
    spec
}

/// Runs Eva over the controllers in one of the modes.
fn prove(folder: &Path, specs: &[Spec], mode: (&str, Option<&str>, &str)) -> Result<Log> {
    let files = specs.iter().flat_map(|spec| write_with_proof(folder, spec)).collect::<Vec<_>>();
    let names: Vec<_> = specs.iter().map(Spec::name).collect();
    analyse(folder, &names, &files, mode)
}

/// The same over files that are there.
fn analyse(
    folder: &Path,
    names: &[String],
    files: &[PathBuf],
    (_, define, special): (&str, Option<&str>, &str),
) -> Result<Log> {
    let declared: String = names.iter().map(|name| format!("void {name}_eva(void);\n")).collect();
    let called: String = names.iter().map(|name| format!("    {name}_eva();\n")).collect();
    fs::write(
        folder.join("all.c"),
        format!("{declared}int main(void)\n{{\n{called}    return 0;\n}}\n"),
    )?;
    let defines = ["-DPTC_EVA_PART"].into_iter().chain(define).collect::<Vec<_>>().join(" ");
    // By names without folders, as alarms quote them: a report is the same on every machine.
    let sources = files.iter().filter(|file| file.extension().is_some_and(|e| e == "c"));
    let sources = sources.filter_map(|file| file.file_name());
    let output = Command::new("frama-c")
        .current_dir(folder)
        // Frama-C looks for files from there, not from the folder in which it runs.
        .env("PWD", fs::canonicalize(folder)?)
        .arg(format!("-cpp-extra-args={defines}"))
        .args(options(files)?)
        .args(["-warn-special-float", special])
        .args(sources)
        .arg("all.c")
        .output()?;
    let text = String::from_utf8_lossy(&output.stdout);
    fs::write(folder.join("frama-c.log"), text.as_bytes())?;
    if !output.status.success() {
        let last: Vec<_> = text.lines().rev().take(8).collect();
        bail!("frama-c failed on {}:\n{}", names.join(", "), last.join("\n"));
    }
    let sources = files.iter().filter_map(|file| fs::read_to_string(file).ok());
    Ok(Log::read(&text, &emitted(names, &sources.collect::<String>())))
}

/// Eva's options as the head of a harness shows them.
fn options(files: &[PathBuf]) -> Result<Vec<String>> {
    let harness = files.iter().find(|file| file.to_string_lossy().ends_with("_eva.c"));
    let text = fs::read_to_string(harness.context("no harness")?)?;
    let line = text.lines().find(|line| line.contains("frama-c -eva"));
    let words = line.context("the harness shows no command")?.split_whitespace();
    let words = words.skip_while(|word| *word != "-eva");
    Ok(words.take_while(|word| *word != "-warn-special-float").map(str::to_owned).collect())
}

/// The functions of the controllers, and those of their harnesses that begin.
fn emitted(names: &[String], text: &str) -> Vec<String> {
    let of = |name: &String| {
        let own = [
            "init",
            "arm",
            "step",
            "tick",
            "axis",
            "rate",
            "state",
            "control",
            "time",
            "start",
            "update",
            "estimate",
            "disturbance",
            "eva",
        ];
        own.map(|function| format!("{name}_{function}")).to_vec()
    };
    let all = names.iter().flat_map(of);
    all.filter(|function| text.contains(&format!(" {function}("))).collect()
}
