//! FMUs of a clock in samples in closed loop, against the program that is emitted.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail};
use ptc_codegen::code::{Code, Instance};
use ptc_codegen::request::Spec;
use ptc_codegen::samples;

use super::super::command::emit;
use super::{number, script};
use crate::context::Context;
use crate::harness::empty;
use crate::harness::specs::spec;
use crate::layer::{Finding, Table};

/// Largest remainder of the state at sample N, as a part of 1, with the fewest digits.
const ARRIVED: f64 = 1e-6;

/// All parameters open; an observer, delay and an end at 0; an observer in single precision; the
/// one sample of delay of an importer that reads u after the step, with and without an observer.
fn designs() -> Vec<Spec> {
    let clock = [("mu", "exp(a=1)"), ("clock", "samples")];
    let design = |more: &[(&str, &str)]| spec(&[&clock[..], more].concat());
    vec![
        design(&[("n", "3"), ("name", "undecided")]),
        design(&[
            ("n", "2"),
            ("name", "stage"),
            ("sample_time", "1e-3"),
            ("tau", "0.8"),
            ("delay", "2"),
            ("poles", "-4,-5,-6,-7"),
            ("measured", "x1"),
            ("observer_poles", "-4,-5,-6"),
            ("disturbance", "constant"),
            ("after", "zero"),
        ]),
        design(&[
            ("n", "2"),
            ("name", "single"),
            ("precision", "f32"),
            ("sample_time", "0.01"),
            ("measured", "x1"),
            ("observer_poles", "-4,-5"),
        ]),
        design(&[
            ("n", "2"),
            ("name", "explicit_master"),
            ("sample_time", "1e-3"),
            ("tau", "0.8"),
            ("delay", "1"),
            ("poles", "-4,-5,-6"),
        ]),
        design(&[
            ("n", "3"),
            ("name", "observed"),
            ("sample_time", "0.01"),
            ("delay", "1"),
            ("poles", "-4,-5,-6,-7"),
            ("measured", "x1"),
            ("observer_poles", "-4,-5,-6"),
        ]),
    ]
}

/// An FMU in a closed loop.
struct Loop<'a> {
    spec: &'a Spec,
    /// True if u is read after the step, which makes one sample of delay.
    explicit: bool,
}

impl Loop<'_> {
    /// The file of its numbers.
    fn file(&self, home: &Path) -> PathBuf {
        let order = if self.explicit { "step_get" } else { "get_step" };
        home.join(format!("{}_{order}.loop", self.spec.name()))
    }
}

/// Every design in both orders of calls, where its delay lets u be read after the step.
fn loops(designs: &[Spec]) -> Vec<Loop<'_>> {
    let orders = |spec| [false, true].map(|explicit| Loop { spec, explicit });
    let possible = |one: &Loop<'_>| !one.explicit || delay(one.spec) > 0;
    designs.iter().flat_map(orders).filter(possible).collect()
}

/// Samples after which u acts.
fn delay(spec: &Spec) -> usize {
    spec.sampled().map_or(0, |sampled| sampled.delay.inputs())
}

/// Runs the loops, and compares each u with that of the program.
pub(super) fn run(
    context: &Context,
    python: &Path,
    generator: &Path,
    finding: &mut Finding,
) -> Result<()> {
    let designs = designs();
    let mut rows = Vec::new();
    for lang in ["fmu2", "fmu3"] {
        let home = empty(&context.scratch("fmu_samples").join(lang));
        let mut list = String::new();
        for spec in &designs {
            emit(generator, &format!("--lang {lang}"), spec, &home)?;
        }
        for one in loops(&designs) {
            let fmu = home.join(format!("{}.fmu", one.spec.name()));
            let (file, n, delay) = (one.file(&home), one.spec.n, delay(one.spec));
            let (fmu, file, explicit) = (fmu.display(), file.display(), u8::from(one.explicit));
            writeln!(list, "{fmu}\t{file}\t{n}\t{delay}\t{explicit}")?;
        }
        let listed = home.join("list");
        fs::write(&listed, list)?;
        script(python, &home, &["samples".as_ref(), &listed])?;
        for one in loops(&designs) {
            let told = fs::read_to_string(one.file(&home))?;
            let (samples, left, faults) = compared(one.spec, &told)?;
            let order = if one.explicit { "set, step, get" } else { "set, get, step" };
            let name = format!("{}, {lang}, {order}", one.spec.name());
            finding.failures.extend(faults.into_iter().map(|fault| format!("{name}: {fault}")));
            rows.push(vec![name, samples.to_string(), format!("{left:.1e}")]);
        }
    }
    finding.tables.push(Table {
        title: "Clocks in samples, in closed loop".to_owned(),
        head: vec!["FMU", "samples", "greatest \\|x_i\\| at sample N"],
        rows,
    });
    Ok(())
}

/// The estimates behind a call, that of the disturbance last.
fn estimated(controller: &mut Instance, code: &Code) -> Vec<f64> {
    let functions = ["estimate", "disturbance"];
    let known = functions.into_iter().filter(|function| code.function(function).is_some());
    known
        .flat_map(|function| controller.call(function, &[]).results.into_values().flatten())
        .collect()
}

/// The samples of a loop, what is left of the state, and what differs from the program.
fn compared(spec: &Spec, told: &str) -> Result<(usize, f64, Vec<String>)> {
    if let Some(problems) = told.strip_prefix("invalid ") {
        return Ok((0, f64::NAN, vec![problems.to_owned()]));
    }
    let sampled = spec.sampled().context("a clock in samples")?;
    let code = samples::controller(spec, sampled, Vec::new());
    let mut lines = told.lines();
    let values = lines.next().context("values of parameters")?.split_whitespace().map(number);
    let given = spec.run_time_parameters().zip(values.collect::<Result<Vec<_>>>()?);
    let Ok(mut controller) = Instance::with_parameters(&code, given) else {
        bail!("init refuses the start values")
    };
    let (mut faults, mut samples, mut left) = (Vec::new(), 0_usize, f64::NAN);
    for line in lines {
        let (status, rest) = line.split_once(' ').context("a status and numbers")?;
        if status == "error" {
            faults.push(rest.to_owned());
            continue;
        }
        let numbers: Vec<_> = rest.split(' ').map(number).collect::<Result<_>>()?;
        let Some((x, [u, estimates @ ..])) = numbers.split_at_checked(spec.n) else {
            bail!("{line}")
        };
        let k = u32::try_from(samples)?;
        let given = [("k", &[f64::from(k)][..]), ("x", x), ("y", &x[..sampled.measured])];
        let outcome = controller.call("step", &given);
        let own = outcome.results.get("u").and_then(|u| u.first()).copied().unwrap_or(f64::NAN);
        let same = own.to_bits() == u.to_bits() && outcome.status.number().to_string() == status;
        if !same && faults.is_empty() {
            faults.push(format!("sample {k}: {status}, {u:e} where the program gives {own:e}"));
        }
        let behind = estimated(&mut controller, &code);
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        if bits(estimates) != bits(&behind) && faults.is_empty() {
            faults
                .push(format!("sample {k}: {estimates:?} where the program estimates {behind:?}"));
        }
        samples += 1;
        left = x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    }
    if left.is_nan() || left > ARRIVED {
        faults.push(format!("|x| = {left:e} at sample N"));
    }
    Ok((samples, left, faults))
}
