//! FMUs in fmpy: validated, called, run in closed loop, and compared with the emitted C.

mod inputs;
mod samples;

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, bail};
use ptc_codegen::emit::Language;
use ptc_codegen::family::Family;
use ptc_codegen::request::Spec;

use super::command::{emit, generator};
use super::projects::CMAKE;
use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::command::succeed;
use crate::harness::program::{Outcome, Program, Record, in_c};
use crate::harness::random::Random;
use crate::harness::records::records;
use crate::harness::runtime;
use crate::harness::{empty, in_pairs, write};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{GCC, PYTHON};

const RECORDS: usize = 1000;

/// Bound of |x_i| at the deadline of a closed loop, which the start values of an FMU are chosen for.
const ARRIVED: f64 = 0.01;

/// The same of `soft`, which ends at up to 0.0148, at order 4: `sampling` is undecided there, so that eps follows from
/// the sample period alone.
const ARRIVED_SOFT: f64 = 0.02;

const SCRIPT: &str = include_str!("fmu.py");

/// Package that is installed for the layer alone.
const FMPY: &str = "fmpy==0.3.32";

pub(super) const LAYER: Layer = Layer {
    name: "fmu",
    claim: "An FMU of FMI 2.0 and 3.0 is valid, gives the bits of the emitted C, arrives in closed \
            loop, and refuses what is not legal with a message that names it.",
    tools: &[GCC, CMAKE, PYTHON],
    run,
};

/// An FMU, and what is compared.
struct Trial<'a> {
    spec: &'a Spec,
    fmu: PathBuf,
    records: &'a [Record],
    program: &'a Program,
}

/// Results of a trial.
#[derive(Default)]
struct Compared {
    calls: usize,
    refused: usize,
    steps: usize,
    faults: Vec<String>,
    last: f64,
}

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("fmu");
    let python = python(context)?;
    let generator = generator()?;
    let specs = context.in_turn(context.families(context.order(4)));
    let programs = in_c(&folder, &specs);
    let records: Vec<_> = specs
        .iter()
        .enumerate()
        .map(|(index, spec)| records(spec, &mut Random(context.seed ^ index as u64), RECORDS))
        .collect();
    let mut finding = Finding::default();
    let mut rows = Vec::new();
    for lang in ["fmu2", "fmu3"] {
        let home = empty(&folder.join(lang));
        let told =
            in_pairs(&specs, |spec| emit(&generator, &format!("--lang {lang}"), spec, &home));
        for told in told {
            told?;
        }
        let trials: Vec<_> = (0..specs.len())
            .map(|index| Trial {
                spec: &specs[index],
                fmu: home.join(format!("{}.fmu", specs[index].name())),
                records: &records[index],
                program: &programs[index],
            })
            .collect();
        let mut all = Compared::default();
        for compared in exercise(&python, &home, &trials)? {
            all.calls += compared.calls;
            all.refused += compared.refused;
            all.steps += compared.steps;
            all.last = all.last.max(compared.last);
            all.faults.extend(compared.faults);
        }
        rows.push(vec![
            lang.to_owned(),
            specs.len().to_string(),
            all.calls.to_string(),
            all.refused.to_string(),
            all.steps.to_string(),
            format!("{:.1e}", all.last),
            all.faults.len().to_string(),
        ]);
        finding.failures.extend(all.faults);
    }
    finding.summary = format!(
        "{} FMUs of each version, {RECORDS} calls and as many steps of a closed loop each: {} faults",
        specs.len(),
        finding.failures.len()
    );
    finding.tables.push(Table {
        title: "In fmpy, against the emitted C".to_owned(),
        head: vec![
            "version",
            "FMUs",
            "calls",
            "of them refused",
            "steps in closed loop",
            "greatest \\|x_i\\| at a deadline",
            "faults",
        ],
        rows,
    });
    finding.notes.push(format!("Simulated and validated by {FMPY}."));
    finding.notes.push(
        "A call is one of random parameters, time and state, among them what C refuses: the FMU has \
         to return an error with a message. Every other one is made of an instance that runs, whose \
         parameters are tuned. The closed loops have the start values of the FMU. u is \
         compared by its bits, the status by its value."
            .to_owned(),
    );
    samples::run(context, &python, &generator, &mut finding)?;
    inputs::run(context, &python, &generator, &mut finding)?;
    seed(context, &python, &mut finding)?;
    Ok(finding)
}

/// Runs the trials, all in one process.
fn exercise(python: &Path, home: &Path, trials: &[Trial<'_>]) -> Result<Vec<Compared>> {
    let file = |trial: &Trial<'_>, suffix: &str| trial.fmu.with_extension(suffix);
    let mut list = String::new();
    for trial in trials {
        let record = |r: &Record| -> Vec<f64> {
            r.parameters.iter().chain([&r.t]).chain(&r.x).copied().collect()
        };
        let bytes = trial.records.iter().flat_map(record).flat_map(f64::to_le_bytes);
        fs::write(file(trial, "records"), bytes.collect::<Vec<u8>>())?;
        let paths =
            [&trial.fmu, &file(trial, "records"), &file(trial, "told"), &file(trial, "loop")];
        let paths = paths.map(|path| path.display().to_string()).join("\t");
        let count = trial.spec.run_time_parameters().count();
        writeln!(list, "{paths}\t{count}\t{}", trial.spec.n)?;
    }
    let listed = home.join("list");
    fs::write(&listed, list)?;
    script(python, home, &["run".as_ref(), &listed])?;
    trials
        .iter()
        .map(|trial| {
            let told = fs::read_to_string(file(trial, "told"))?;
            let mut compared = Compared::default();
            if let Some(problems) = told.strip_prefix("invalid ") {
                compared.faults.push(format!("{}: {problems}", trial.fmu.display()));
                return Ok(compared);
            }
            calls(trial, &told, &mut compared)?;
            looped(trial, &fs::read_to_string(file(trial, "loop"))?, &mut compared)?;
            Ok(compared)
        })
        .collect()
}

/// The interpreter that has fmpy.
fn python(context: &Context) -> Result<PathBuf> {
    runtime::python(&context.shared("fmpy"), &[FMPY])
}

/// Runs fmu.py.
fn script(python: &Path, home: &Path, arguments: &[&Path]) -> Result<()> {
    let path = home.join("fmu.py");
    fs::write(&path, SCRIPT)?;
    succeed(Command::new(python).arg(&path).args(arguments)).map(|_| ())
}

/// Compares the calls; of equal faults of an FMU the first is reported.
fn calls(trial: &Trial<'_>, told: &str, compared: &mut Compared) -> Result<()> {
    let mut faults = Vec::new();
    let outcomes = trial.program.run(trial.records);
    for ((line, c), record) in told.lines().zip(outcomes).zip(trial.records) {
        compared.calls += 1;
        match line.split_once(' ').context("two words")? {
            ("error", message) => {
                compared.refused += 1;
                let legal = c.init == 0 && c.step.0 >= 0;
                // A time that is not finite may be reported in place of a parameter.
                let time = message.contains("time ");
                let names = if c.init == 0 {
                    time || message.contains("input x") || message.contains("u is not finite")
                } else {
                    let parameter = message.contains("parameter ") && message.contains("legal");
                    parameter || (time && !record.t.is_finite())
                };
                if legal || !names {
                    faults.push(format!("{message:?} where C gives {c:?}"));
                }
            }
            ("ok", numbers) => {
                let mut words = numbers.split(' ');
                let status: i32 = words.next().context("a status")?.parse()?;
                let u = number(words.next().context("u")?)?;
                if status < 0 || (c.init, c.step.0, c.step.1.to_bits()) != (0, status, u.to_bits())
                {
                    faults.push(format!("status {status}, u = {u:e} where C gives {c:?}"));
                }
            }
            _ => bail!("{line}"),
        }
    }
    if compared.calls != RECORDS {
        faults.push(format!("{} calls of {RECORDS}", compared.calls));
    }
    let (name, count) = (trial.fmu.display(), faults.len());
    compared.faults.extend(faults.first().map(|f| format!("{name}: {count} calls, first: {f}")));
    Ok(())
}

/// Compares the steps of the closed loop, and asks that the state has arrived.
fn looped(trial: &Trial<'_>, told: &str, compared: &mut Compared) -> Result<()> {
    let name = trial.fmu.display();
    let mut lines = told.lines();
    let first = lines.next().context("a first line")?;
    if first.starts_with("error ") {
        compared.faults.push(format!("{name}: closed loop: {first}"));
        return Ok(());
    }
    let numbers = |text: &str| text.split_whitespace().map(number).collect::<Result<Vec<_>>>();
    let parameters = numbers(first)?;
    let (mut records, mut wanted) = (Vec::new(), Vec::new());
    for line in lines {
        let (status, rest) = line.split_once(' ').context("a status and numbers")?;
        let [t, x @ .., u] = &numbers(rest)?[..] else { bail!("{line}") };
        wanted.push((status.parse::<i32>()?, *u));
        let (parameters, x) = (parameters.clone(), x.to_vec());
        records.push(Record { parameters, x0: Vec::new(), t: *t, x });
    }
    let same = |((status, u), c): (&(i32, f64), &Outcome)| {
        (c.init, c.step.0, c.step.1.to_bits()) == (0, *status, u.to_bits())
    };
    let outcomes = trial.program.run(&records);
    let differing = wanted.iter().zip(&outcomes).filter(|pair| !same(*pair)).count();
    compared.steps = records.len();
    compared.last =
        records.last().context("a last step")?.x.iter().fold(0.0, |m, x| m.max(x.abs()));
    if differing > 0 {
        compared.faults.push(format!("{name}: {differing} steps of the closed loop differ from C"));
    }
    let arrived = match trial.spec.family() {
        Some(Family::Soft) => ARRIVED_SOFT,
        _ => ARRIVED,
    };
    if compared.last.is_nan() || compared.last > arrived {
        compared.faults.push(format!("{name}: |x| = {:e} at the deadline", compared.last));
    }
    Ok(())
}

/// A double, by its bytes in hexadecimal digits.
fn number(text: &str) -> Result<f64> {
    let bits = u64::from_str_radix(text, 16)?;
    Ok(f64::from_bits(bits.swap_bytes()))
}

/// Defects in the text of an FMU, which fmpy then compiles.
const DEFECTS: [Defect; 7] = [
    ("built.c1 = c1;", "built.c1 = -c1;", "a wrong sign in the controller"),
    ("state->time = from + by;", "state->time = from;", "a clock that stands still"),
    (
        "*kept = value;\n    state->fresh = 0;",
        "*kept = value;",
        "outputs that are not computed again when an input is set",
    ),
    (
        "if (reference > 2u) {\n        state->armed = 0;",
        "if (reference > 99u) {\n        state->armed = 0;",
        "parameters that do not reach the controller",
    ),
    ("if (instance->logger != NULL) {", "if (0) {", "an error without a message"),
    ("if (status < 0) {", "if (0) {", "0 for a u that overflows, without an error"),
    ("valueReference=\"2\"", "valueReference=\"1\"", "two variables of one value reference"),
];

/// Sources as an importer compiles them: as they are emitted, and with defects.
fn seed(context: &Context, python: &Path, finding: &mut Finding) -> Result<()> {
    let home = context.scratch("fmu_seeded");
    let spec = context.example();
    let programs = in_c(&home, std::slice::from_ref(&spec));
    let records = records(&spec, &mut Random(context.seed), RECORDS);
    let faults = |name: &str| -> Result<Vec<String>> {
        let folder = home.join(name);
        let fmu = home.join(format!("{name}.fmu"));
        script(python, &home, &["pack".as_ref(), &folder, &fmu])?;
        let trial = Trial { spec: &spec, fmu, records: &records, program: &programs[0] };
        Ok(exercise(python, &home, &[trial])?.remove(0).faults)
    };
    for (name, language) in [("sources2", Language::Fmu2), ("sources3", Language::Fmu3)] {
        write(&empty(&home.join(name)), &spec, language);
        finding.failures.extend(faults(name)?);
    }
    for (index, defect) in context.in_turn(DEFECTS.to_vec()).into_iter().enumerate() {
        let name = format!("defect{index}");
        with_defect(&home.join(&name), &spec, Language::Fmu2, defect)?;
        // An importer that does not read it has caught it too.
        let caught = faults(&name).unwrap_or_else(|error| {
            let told = format!("{error:#}");
            vec![told.lines().last().unwrap_or_default().to_owned()]
        });
        finding.seed(defect.2, caught.into_iter().next().map(short));
    }
    finding.notes.push(
        "The sources of the defects, and those of an FMU of each version without one, are compiled by \
         fmpy, as an importer does that finds no library for its platform."
            .to_owned(),
    );
    Ok(())
}

/// A fault without the path of the FMU.
fn short(fault: String) -> String {
    fault.split_once(".fmu: ").map_or(fault.clone(), |(_, rest)| rest.to_owned())
}
