//! The self-tests: they pass here and on emulated machines, and take every branch of the controller.
//!
//! *Branches and MC/DC.* Every decision of emitted C is one condition, a chain of && alone or a chain
//! of || alone. In such a chain each condition is evaluated only if those before it left the result
//! open, and a false one (a true one in ||) alone decides it. So where gcov sees the branch of each
//! condition taken both ways, each has been shown to decide the result by itself, which is modified
//! condition/decision coverage. The premise, no decision of both operators, is examined on the text.

mod coverage;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;

use self::coverage::{Coverage, measure, mixed_decisions};
use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::goldens::{of_axes, of_inputs, of_two_inputs};
use crate::harness::machine::Machine;
use crate::harness::selftest::{main_program, sources, write_selftest};
use crate::harness::{STRICT, empty, in_pairs, in_samples, run as execute};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{ARM_GCC, GCC, NEWLIB, QEMU_ARM, ShownBy, Source, Tool};

const GCOV: Tool = Tool {
    name: "gcov",
    shown_by: ShownBy::Command(&["gcov", "--version"]),
    source: Source::Apt(&["gcc"]),
};

pub(super) const LAYER: Layer = Layer {
    name: "selftest",
    claim: "The self-test that is emitted with a controller passes on this machine and on Cortex-M0 \
            and M4F, takes every branch of the controller that an input can take, with modified \
            condition/decision coverage, and fails where the controller is altered.",
    tools: &[GCC, GCOV, ARM_GCC, NEWLIB, QEMU_ARM],
    run,
};

/// Results of the self-test of one controller.
struct Told {
    coverage: Coverage,
    machines: usize,
    failures: Vec<String>,
}

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("selftest");
    let specs = [
        context.in_samples(),
        in_samples::of_inputs(),
        context.goldens(),
        of_axes().to_vec(),
        of_two_inputs().to_vec(),
        vec![of_inputs()],
        context.families(2),
        context.random(20),
    ]
    .concat();
    let specs = context.in_turn(specs);
    let indexed: Vec<_> = specs.iter().enumerate().collect();
    let told = in_pairs(&indexed, |(index, spec)| -> Result<Told> {
        let folder = empty(&folder.join(index.to_string()));
        let sources = sources(&folder, spec)?;
        let coverage = measure(&folder, spec, &sources)?;
        let mut failures = coverage.uncovered.clone();
        failures.extend(mixed_decisions(&sources[0])?);
        // Each third of them is run under the emulator too, which takes the most time.
        let emulated: &[Machine] =
            if index % 3 == 0 { &[Machine::CortexM0, Machine::CortexM4f] } else { &[] };
        for machine in [&[Machine::Host], emulated].concat() {
            if !passes(machine, &folder, spec, &sources) {
                failures.push(format!("the self-test fails on {}", machine.name()));
            }
        }
        Ok(Told { coverage, machines: emulated.len(), failures })
    });
    let mut finding = Finding::default();
    let mut rows: BTreeMap<_, [usize; 4]> = BTreeMap::new();
    let (mut total, mut emulated) = (Coverage::default(), 0);
    for (spec, told) in specs.iter().zip(told) {
        let told = told.with_context(|| spec.command())?;
        emulated += told.machines;
        let all = told.failures.join("\n");
        if !all.is_empty() {
            finding.failures.push(format!("{}\n{all}", spec.command()));
        }
        let row =
            rows.entry((in_samples::kind(spec), format!("{:?}", spec.precision))).or_default();
        let Coverage { branches, taken, listed, .. } = told.coverage;
        for (sum, count) in row.iter_mut().zip([1, branches, taken, listed]) {
            *sum += count;
        }
        total.branches += branches;
        total.taken += taken;
        total.listed += listed;
    }
    finding.summary = format!(
        "{} of {} controllers pass, {emulated} of the runs emulated; {} of {} branches taken, {} listed as \
         never taken with the reason, {} left",
        specs.len() - finding.failures.len(),
        specs.len(),
        total.taken,
        total.branches,
        total.listed,
        total.branches - total.taken - total.listed,
    );
    let row = |((mapping, precision), counts): ((&str, String), [usize; 4])| {
        let numbers = counts.iter().map(usize::to_string);
        [mapping.to_owned(), precision.to_lowercase()].into_iter().chain(numbers).collect()
    };
    finding.tables.push(Table {
        title: "Branches of init, arm, step, tick, axis and update, by gcov".to_owned(),
        head: vec!["mapping", "precision", "controllers", "branches", "taken", "listed"],
        rows: rows.into_iter().map(row).collect(),
    });
    finding.notes.push(
        "Listed are checks of coefficients that no parameters make the first to fail, turns of an \
         iteration that no input brings about, and cases of a clock in samples that what is fixed \
         rules out: NAME_selftest.h names each with the reason. No \
         decision mixes && and ||, so branch coverage of the short-circuit code is modified \
         condition/decision coverage."
            .to_owned(),
    );
    seeded(context, &folder, &mut finding)?;
    Ok(finding)
}

/// Returns true if the self-test counts no failure on `machine`.
fn passes(machine: Machine, folder: &Path, spec: &Spec, sources: &[PathBuf; 2]) -> bool {
    let Ok(main) = main_program(folder, spec) else { return false };
    let program = folder.join(machine.stem());
    let mut compiler = machine.c_compiler();
    compiler.args(STRICT).args(sources).arg(main).args(machine.link_arguments());
    execute(compiler.arg("-lm").arg("-o").arg(&program));
    let mut command = machine.command(&program, &[]);
    command.current_dir(folder).output().is_ok_and(|output| output.status.success())
}

/// Defects of the controller of the example.
const DEFECTS: [Defect; 12] = [
    ("const double c1 = -K1;", "const double c1 = K1;", "the sign of a coefficient"),
    ("+ 1.0;", "- 1.0;", "the sign of b_n in a coefficient"),
    ("(past < self->hold_from) ? past : self->hold_from", "past", "no hold of time-to-go"),
    ("if (v > self->u_max) {", "if (v > (4.0 * self->u_max)) {", "no clipping from above"),
    ("(v < -self->u_max)", "(v < (-4.0 * self->u_max))", "no clipping from below"),
    (" && PTC_FINITE_F64(x[1])) {", ") {", "a state that is not checked"),
    (
        "if (t >= self->t0) {",
        "if (t >= (self->t0 - (4.0 * self->tau))) {",
        "a time before the start",
    ),
    ("            && (eps < tau)", "", "an eps above tau"),
    ("            && (1e-150 <= a)\n", "", "a rate below 0"),
    ("(t0 - (deadline - v1)) + (self->tau - v1)", "0.0 * v1", "no second part of the deadline"),
    ("PTC_FINITE_F64(deadline)", "PTC_FINITE_F64(t0)", "a deadline beyond the range"),
    ("gains->status = status;", "gains->status = PTC_OK;", "the hold forgotten by tick"),
];

/// Defects of the example in samples.
const IN_SAMPLES: [Defect; 6] = [
    ("k - self->start", "k", "a start that is not subtracted from the tick"),
    ("self->u1 = u_now", "self->u1 = v", "an input kept before it is clipped"),
    ("self->seen = 1U", "self->seen = 0U", "estimates that begin anew at each call"),
    ("u_now = -STAGE_U_MAX", "u_now = STAGE_U_MAX", "no clipping from below, in samples"),
    ("PTC_FINITE_F64(y[0])", "(y[0] < 1e300)", "a measurement that is not checked"),
    ("status = PTC_HOLD", "status = PTC_OK", "no status of the hold"),
];

fn seeded(context: &Context, folder: &Path, finding: &mut Finding) -> Result<()> {
    let spec = Spec { precision: Precision::F64, ..context.example() };
    let in_samples = in_samples::example();
    let defects = DEFECTS.into_iter().map(|defect| (&spec, defect));
    let defects = defects.chain(IN_SAMPLES.into_iter().map(|defect| (&in_samples, defect)));
    for (index, (spec, defect)) in context.in_turn(defects.collect()).into_iter().enumerate() {
        let folder = folder.join(format!("seeded{index}"));
        with_defect(&folder, spec, Language::C, defect)?;
        let sources = write_selftest(&folder, spec)?;
        let told = [Machine::Host, Machine::CortexM4f].map(|m| passes(m, &folder, spec, &sources));
        let caught = told == [false, false];
        finding
            .seed(defect.2, caught.then(|| "the self-test, here and on a Cortex-M4F".to_owned()));
    }
    // A session fewer must show in the coverage.
    let folder = empty(&folder.join("fewer"));
    let sources = sources(&folder, &spec)?;
    let text = fs::read_to_string(&sources[1])?;
    let loops: Vec<_> = text.match_indices("session->count; j++").collect();
    let fewer = text.replace("session->count; j++", "(session->count / 4U); j++");
    fs::write(&sources[1], fewer)?;
    let coverage = measure(&folder, &spec, &sources)?;
    let seen = !loops.is_empty() && !coverage.uncovered.is_empty();
    finding.seed("calls left out of the self-test", seen.then(|| coverage.uncovered[0].clone()));
    Ok(())
}
