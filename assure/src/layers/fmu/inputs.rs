//! FMUs of several inputs and of axes with either clock: every u and every status of random calls, against the program
//! that is emitted.

mod designs;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::{Context as _, Result, bail};
use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Code, Instance, Shape};
use ptc_codegen::controller::{self, Controller};
use ptc_codegen::law::Law;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;
use ptc_codegen::samples;

use super::super::command::emit;
use super::{number, script};
use crate::context::Context;
use crate::harness::random::Random;
use crate::harness::{empty, optimised};
use crate::layer::{Finding, Table};
use designs::designs;

/// Calls of each FMU, and their distance in time.
const CALLS: usize = 400;
const STEP: f64 = 0.003;

/// The program of a controller.
fn program(spec: &Spec) -> Code {
    let report = examine(spec);
    match report.spec.sampled() {
        Some(sampled) => samples::controller(&report.spec, sampled, Vec::new()),
        None => {
            let (law, program) = (Law::of(&report.spec), optimised(&report.spec));
            controller::whole(&Controller {
                report: &report,
                law: &law,
                program: &program,
                measured: &[],
            })
        }
    }
}

/// A call: time, and the inputs of the FMU.
type Call = (f64, Vec<f64>);

/// Random calls, some of which are refused.
fn calls(spec: &Spec, inputs: usize, random: &mut Random) -> Vec<Call> {
    let mut number = |odd: bool| match (odd, random.below(3)) {
        (true, 0) => f64::NAN,
        (true, 1) => rounded(spec, 1e300),
        _ => rounded(spec, random.between(-2.0, 2.0)),
    };
    let call = |index: usize| {
        let mut numbers: Vec<_> = (0..inputs).map(|_| number(false)).collect();
        if index % 9 == 4 {
            numbers[index / 9 % inputs] = number(true);
        }
        #[allow(clippy::cast_precision_loss)]
        (STEP * index as f64, numbers)
    };
    (0..CALLS).map(call).collect()
}

/// What the FMU gives for each array of a call: the places of its inputs in it.
fn spread(spec: &Spec, code: &Code, numbers: &[f64]) -> Vec<(String, Vec<f64>)> {
    let step = code.function("step").map(|step| step.arguments.as_slice()).unwrap_or_default();
    let mut rest = numbers;
    let mut all = Vec::new();
    for argument in step {
        let orders = spec.decoupled().map(|coupled| coupled.orders());
        let rows: Vec<_> = match (argument.shape, argument.name.as_str(), orders) {
            // Behind the order of an output nothing is read.
            (Shape::Lists(_, length), "r", Some(orders)) => {
                orders.into_iter().map(|order| (order + 1, length)).collect()
            }
            (shape, ..) => shape.length().into_iter().map(|length| (length, length)).collect(),
        };
        let mut values = Vec::new();
        for (given, length) in rows {
            let (row, left) = rest.split_at(given);
            values.extend_from_slice(row);
            values.resize(values.len() + length - given, 0.0);
            rest = left;
        }
        if !values.is_empty() {
            all.push((argument.name.clone(), values));
        }
    }
    all
}

/// Runs the calls of every design in FMUs of both versions.
pub(super) fn run(
    context: &Context,
    python: &Path,
    generator: &Path,
    finding: &mut Finding,
) -> Result<()> {
    let designs = designs();
    let programs: Vec<_> = designs.iter().map(program).collect();
    let mut rows = Vec::new();
    for lang in ["fmu2", "fmu3"] {
        let home = empty(&context.scratch("fmu_inputs").join(lang));
        let (mut list, mut all) = (String::new(), Vec::new());
        for (spec, code) in designs.iter().zip(&programs) {
            emit(generator, &format!("--lang {lang}"), spec, &home)?;
            let inputs = inputs(spec, code);
            let own = calls(spec, inputs, &mut Random(context.seed ^ inputs as u64));
            let numbers = own.iter().flat_map(|(time, x)| std::iter::once(time).chain(x));
            let bytes: Vec<u8> = numbers.flat_map(|number| number.to_le_bytes()).collect();
            let [fmu, calls, told] = ["fmu", "calls", "told"]
                .map(|suffix| home.join(format!("{}.{suffix}", spec.name())));
            fs::write(&calls, bytes)?;
            let period = if spec.sampled().is_some() { 0.01 } else { 0.0 };
            let [fmu, calls] = [fmu, calls].map(|path| path.display().to_string());
            writeln!(list, "{fmu}\t{calls}\t{}\t{period}", told.display())?;
            all.push((own, told));
        }
        let listed = home.join("list");
        fs::write(&listed, list)?;
        script(python, &home, &["inputs".as_ref(), &listed])?;
        for ((spec, code), (own, told)) in designs.iter().zip(&programs).zip(all) {
            let name = format!("{}, {lang}", spec.name());
            let (refused, faults) = compared(spec, code, &own, &fs::read_to_string(told)?)?;
            finding.failures.extend(faults.into_iter().map(|fault| format!("{name}: {fault}")));
            rows.push(vec![name, CALLS.to_string(), refused.to_string()]);
        }
    }
    finding.tables.push(Table {
        title: "Several inputs and axes, call by call".to_owned(),
        head: vec!["FMU", "calls", "of them refused"],
        rows,
    });
    Ok(())
}

/// The number of inputs of an FMU.
fn inputs(spec: &Spec, code: &Code) -> usize {
    let step = code.function("step").map(|step| step.arguments.as_slice()).unwrap_or_default();
    let length = |name| step.iter().find(|a| a.name == name).and_then(|a| a.shape.length());
    let references = match (length("r"), spec.decoupled()) {
        (Some(_), Some(coupled)) => coupled.orders().into_iter().map(|order| order + 1).sum(),
        (given, _) => given.unwrap_or(0),
    };
    length("x").unwrap_or(0) + references
}

/// How many calls are refused, and what differs from the program.
fn compared(spec: &Spec, code: &Code, calls: &[Call], told: &str) -> Result<(usize, Vec<String>)> {
    if let Some(problems) = told.strip_prefix("invalid ") {
        return Ok((0, vec![problems.to_owned()]));
    }
    let mut lines = told.lines();
    let values = lines.next().context("values of parameters")?.split_whitespace().map(number);
    let given = spec.run_time_parameters().zip(values.collect::<Result<Vec<_>>>()?);
    let Ok(mut controller) = Instance::with_parameters(code, given) else {
        bail!("init refuses the start values")
    };
    let (mut refused, mut k, mut faults) = (0, 0_u32, Vec::new());
    for ((time, numbers), line) in calls.iter().zip(lines) {
        let arrays = spread(spec, code, numbers);
        let clock = match spec.sampled() {
            Some(_) => ("k", vec![f64::from(k)]),
            None => ("t", vec![rounded(spec, *time)]),
        };
        let arrays = arrays.iter().map(|(name, values)| (name.as_str(), values.as_slice()));
        let given: Vec<_> = std::iter::once((clock.0, clock.1.as_slice())).chain(arrays).collect();
        let found = controller.call("step", &given);
        let is_refused = found.status.number() < 0;
        k += u32::from(!is_refused);
        refused += usize::from(is_refused);
        let mut wanted = vec![found.status.number().to_string()];
        wanted.extend(found.results["axes"].iter().map(f64::to_string));
        let hexed = |u: &f64| u.to_bits().swap_bytes();
        wanted.extend(found.results["u"].iter().map(|u| format!("{:016x}", hexed(u))));
        let same = match line.split_once(' ') {
            Some(("ok", text)) => !is_refused && text == wanted.join(" "),
            Some(("error", message)) => is_refused && !message.is_empty(),
            _ => bail!("{line}"),
        };
        if !same && faults.is_empty() {
            faults.push(format!("at {time}: {line} where the program gives {}", wanted.join(" ")));
        }
    }
    if refused == 0 {
        faults.push("no call is refused".to_owned());
    }
    Ok((refused, faults))
}

/// A number in the precision of a controller.
fn rounded(spec: &Spec, value: f64) -> f64 {
    match spec.precision {
        Precision::F64 => value,
        #[allow(clippy::cast_possible_truncation)]
        Precision::F32 => f64::from(value as f32),
    }
}
