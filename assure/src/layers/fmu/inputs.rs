//! FMUs of several inputs and of axes with either clock: every u and every status of random calls, against the program
//! that is emitted.

mod designs;
mod program;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::Result;
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::super::command::emit;
use super::super::seeded::{Defect, with_defect};
use super::script;
use crate::context::Context;
use crate::harness::empty;
use crate::harness::random::Random;
use crate::layer::{Finding, Table};
use designs::designs;
use program::{calls, compared, inputs, program};

/// Calls of each FMU, and their distance in time.
const CALLS: usize = 400;
const STEP: f64 = 0.003;

/// Runs the calls of every design in FMUs of both versions.
pub(super) fn run(
    context: &Context,
    python: &Path,
    generator: &Path,
    finding: &mut Finding,
) -> Result<()> {
    let designs = designs();
    let mut rows = Vec::new();
    for lang in ["fmu2", "fmu3"] {
        let home = empty(&context.scratch("fmu_inputs").join(lang));
        for spec in &designs {
            emit(generator, &format!("--lang {lang}"), spec, &home)?;
        }
        let compared = exercise(context, python, &home, &designs)?;
        for (spec, (refused, faults)) in designs.iter().zip(compared) {
            let name = format!("{}, {lang}", spec.name());
            finding.failures.extend(faults.into_iter().map(|fault| format!("{name}: {fault}")));
            rows.push(vec![name, CALLS.to_string(), refused.to_string()]);
        }
    }
    finding.tables.push(Table {
        title: "Several inputs and axes, call by call".to_owned(),
        head: vec!["FMU", "calls", "of them refused"],
        rows,
    });
    seed(context, python, &designs[0], finding)
}

/// Defects in the text of an FMU of several axes, which fmpy then compiles.
const DEFECTS: [Defect; 3] = [
    (
        "instance->state.u[reference - U]",
        "instance->state.u[0]",
        "u of the first axis for every one",
    ),
    (
        "(int)instance->state.axes[reference - STATUS - 1u]",
        "instance->state.status",
        "the status of the call for that of each axis",
    ),
    ("&state->x[1][0];", "&state->x[0][1];", "an input of one axis in the place of another"),
];

fn seed(context: &Context, python: &Path, spec: &Spec, finding: &mut Finding) -> Result<()> {
    let home = empty(&context.scratch("fmu_inputs").join("seeded"));
    for defect in context.in_turn(DEFECTS.to_vec()) {
        let folder = empty(&home.join("sources"));
        with_defect(&folder, spec, Language::Fmu2, defect)?;
        let fmu = home.join(format!("{}.fmu", spec.name()));
        script(python, &home, &["pack".as_ref(), &folder, &fmu])?;
        let (_, faults) = exercise(context, python, &home, std::slice::from_ref(spec))?.remove(0);
        finding.seed(defect.2, faults.into_iter().next());
    }
    Ok(())
}

/// Runs the calls of each design in its FMU: how many are refused, and what differs.
fn exercise(
    context: &Context,
    python: &Path,
    home: &Path,
    designs: &[Spec],
) -> Result<Vec<(usize, Vec<String>)>> {
    let (mut list, mut all) = (String::new(), Vec::new());
    for spec in designs {
        let code = program(spec);
        let inputs = inputs(spec, &code);
        let own = calls(spec, inputs, &mut Random(context.seed ^ inputs as u64));
        let numbers = own.iter().flat_map(|(time, x)| std::iter::once(time).chain(x));
        let bytes: Vec<u8> = numbers.flat_map(|number| number.to_le_bytes()).collect();
        let [fmu, calls, told] =
            ["fmu", "calls", "told"].map(|suffix| home.join(format!("{}.{suffix}", spec.name())));
        fs::write(&calls, bytes)?;
        let period = if spec.sampled().is_some() { 0.01 } else { 0.0 };
        let [fmu, calls] = [fmu, calls].map(|path| path.display().to_string());
        writeln!(list, "{fmu}\t{calls}\t{}\t{period}", told.display())?;
        all.push((code, own, told));
    }
    let listed = home.join("list");
    fs::write(&listed, list)?;
    script(python, home, &["inputs".as_ref(), &listed])?;
    let compared = designs
        .iter()
        .zip(all)
        .map(|(spec, (code, own, told))| compared(spec, &code, &own, &fs::read_to_string(told)?));
    compared.collect()
}
