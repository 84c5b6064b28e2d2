//! Random calls of a controller of several inputs, and what its program gives for them.

use anyhow::{Context as _, Result, bail};
use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Code, Instance, Shape};
use ptc_codegen::controller::{self, Controller};
use ptc_codegen::law::Law;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;
use ptc_codegen::samples;

use super::super::number;
use super::{CALLS, STEP};
use crate::harness::optimised;
use crate::harness::random::Random;

/// The program of a controller.
pub(super) fn program(spec: &Spec) -> Code {
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
pub(super) type Call = (f64, Vec<f64>);

/// Random calls, some of which are refused.
pub(super) fn calls(spec: &Spec, inputs: usize, random: &mut Random) -> Vec<Call> {
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

/// Returns the arrays that the FMU passes in a call, with its inputs in their places.
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

/// The number of inputs of an FMU.
pub(super) fn inputs(spec: &Spec, code: &Code) -> usize {
    let step = code.function("step").map(|step| step.arguments.as_slice()).unwrap_or_default();
    let length = |name| step.iter().find(|a| a.name == name).and_then(|a| a.shape.length());
    let references = match (length("r"), spec.decoupled()) {
        (Some(_), Some(coupled)) => coupled.orders().into_iter().map(|order| order + 1).sum(),
        (given, _) => given.unwrap_or(0),
    };
    length("x").unwrap_or(0) + references
}

/// Returns the number of refused calls, and the differences from the program.
pub(super) fn compared(
    spec: &Spec,
    code: &Code,
    calls: &[Call],
    told: &str,
) -> Result<(usize, Vec<String>)> {
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
