//! Another language beside C on the same records: equal bits where no function of a library is
//! called, and the accuracy of the families where one is.

use std::path::Path;

use anyhow::Result;
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::{Fixed, Parameter, Precision};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::number::round;
use ptc_codegen::program::{Input, Program};
use ptc_codegen::request::Spec;

use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::program::{Outcome, Record, in_c};
use crate::harness::random::Random;
use crate::harness::records::records;
use crate::harness::runtime::{Home, homes};
use crate::harness::specs::{calls_a_library, spec};
use crate::harness::{empty, in_pairs, optimised, tolerance};
use crate::layer::{Finding, Table};

/// Records for each controller, where the run is not brief.
const RECORDS: usize = 1000;

/// Runs the files of controllers on their records, in a separate folder.
pub(super) type Run<'a> =
    &'a dyn Fn(&Path, &[Home<'_>], &[Vec<Record>]) -> Result<Vec<Vec<Outcome>>>;

/// A language to compare.
pub(super) struct Side<'a> {
    pub(super) language: Language,
    pub(super) run: Run<'a>,
    /// True if it has tick and axis.
    pub(super) has_axis: bool,
    /// A defect that the comparison must see.
    pub(super) defect: Defect,
}

/// The families in several orders, random controllers, and one for each feature that these may
/// lack.
pub(super) fn controllers(context: &Context) -> Vec<Spec> {
    let features: [&[(&str, &str)]; 12] = [
        &[("n", "1"), ("mu", "exp(a=1)"), ("pi0", "-psi*xi1/(abs(xi1) - phi*abs(xi1_0))^2")],
        &[("n", "2"), ("mu", "rational"), ("pi0", "-xi1 - sign(xi2)"), ("g", "2 + x1*x1")],
        &[("n", "2"), ("mu", "algebraic"), ("pi0", "max(min(-xi1 - xi2, 3), x1_0 - t0 - dt)")],
        &[("n", "3"), ("kappa", "dt/(a*(tau - dt))"), ("g", "x1"), ("guard", "result")],
        &[("n", "3"), ("mu", "tanh"), ("pi0", "extern"), ("after", "extern")],
        &[("n", "2"), ("mu", "exp"), ("pi0", "-xi1*xi1_0 - 2*xi2"), ("after", "zero")],
        &[("n", "2"), ("mu", "exp"), ("pi0", "-xi1*xi1_0 - 2*xi2"), ("what", "associated")],
        &[("n", "3"), ("mu", "rational"), ("gains", "1,3,3"), ("what", "associated")],
        &[("n", "3"), ("mu", "tanh"), ("reference", "input")],
        &[("n", "2"), ("mu", "rational"), ("reference", "w*t/(1 + dt^2)"), ("f", "x2*t")],
        &[("n", "9"), ("kappa", "tau*dt/(tau - dt) + dt")],
        &[("n", "1"), ("mu", "exp"), ("pi0", "-sinh(xi1) - tanh(xi1) - atan(xi1)*cos(xi1)")],
    ];
    let mut all = [context.families(context.order(4)), context.random(24)].concat();
    for (index, keys) in features.iter().enumerate() {
        for precision in ["f64", "f32"] {
            let name = format!("feature{index}_{precision}");
            all.push(spec(&[keys, &[("name", &*name), ("precision", precision)][..]].concat()));
        }
    }
    context.in_turn(all)
}

/// Compares a language with C.
pub(super) fn compare(context: &Context, side: &Side<'_>) -> Result<Finding> {
    let name = side.language.name();
    let folder = context.scratch(name);
    let specs = controllers(context);
    let homes = homes(&folder.join("files"), &specs, side.language)?;
    let emitted: Vec<Spec> = homes.iter().map(|(_, spec)| (*spec).clone()).collect();
    let (records, wanted) = in_c_on_records(context, &folder, &emitted);
    let found = (side.run)(&folder, &homes, &records)?;
    let mut finding = Finding::default();
    let (mut exact, mut near) = (Tally::default(), Tally::default());
    for (index, spec) in emitted.iter().enumerate() {
        let library = calls_a_library(spec);
        let reference = Reference::new(spec);
        let tally = if library { &mut near } else { &mut exact };
        tally.controllers += 1;
        for ((record, c), other) in records[index].iter().zip(&wanted[index]).zip(&found[index]) {
            let c = if side.has_axis { *c } else { without_axis(*c) };
            tally.records += 1;
            if c.bits() == other.bits() {
                continue;
            }
            tally.differing += 1;
            let wrong = if library {
                beyond(&reference, (record, spec.precision), &c, other, tally)
            } else {
                true
            };
            if wrong {
                let told = format!("{}: C {c:?}, {name} {other:?}, {record:?}", spec.name());
                finding.failures.push(told);
            }
        }
    }
    finding.summary = format!(
        "{} controllers, {} records each: {} of {} records differ where no library is called",
        emitted.len(),
        context.records(RECORDS),
        exact.differing,
        exact.records
    );
    let row = |title: &str, tally: &Tally| {
        vec![
            title.to_owned(),
            tally.controllers.to_string(),
            tally.records.to_string(),
            tally.differing.to_string(),
            format!("{:.1e}", tally.greatest),
        ]
    };
    finding.tables.push(Table {
        title: format!("{name} against C"),
        head: vec!["controllers", "number", "records", "differing", "greatest error of a family"],
        rows: vec![row("no library function", &exact), row("exp, log, pow, ...", &near)],
    });
    finding.notes.push(format!(
        "{} of {} controllers are refused by name and reason in this language.",
        specs.len() - emitted.len(),
        specs.len()
    ));
    finding.notes.push(
        "The error is that of src/harness/tolerance.rs: the difference of u over the sum of the absolute \
         values of its terms. Where the parameters are harder than those of that table, the language may be \
         wrong by four times what C is, against the law in double precision. Of controllers beside \
         the families that call a library, and of parameters beyond 1e-30 to 1e30, differences are \
         counted and not judged."
            .to_owned(),
    );
    finding.failures.truncate(8);
    seeded(context, side, &mut finding)?;
    Ok(finding)
}

fn in_c_on_records(
    context: &Context,
    folder: &Path,
    specs: &[Spec],
) -> (Vec<Vec<Record>>, Vec<Vec<Outcome>>) {
    let records: Vec<_> = specs
        .iter()
        .enumerate()
        .map(|(index, spec)| {
            records(spec, &mut Random(context.seed ^ index as u64), context.records(RECORDS))
        })
        .collect();
    let programs = in_c(&empty(&folder.join("c")), specs);
    let calls: Vec<_> = programs.iter().zip(&records).collect();
    let outcomes = in_pairs(&calls, |(program, records)| program.run(records));
    (records, outcomes)
}

/// Counts of the comparison of one kind of controllers.
#[derive(Default)]
struct Tally {
    controllers: usize,
    records: usize,
    differing: usize,
    greatest: f64,
}

/// The outcome of a language that has no tick and axis.
fn without_axis(outcome: Outcome) -> Outcome {
    Outcome { axis: (0, 12345.0), ..outcome }
}

/// Law in double precision, for the numbers of a record of any precision.
struct Reference {
    spec: Spec,
    program: Program,
}

impl Reference {
    fn new(spec: &Spec) -> Self {
        let spec = Spec { precision: Precision::F64, ..spec.clone() };
        let program = optimised(&spec);
        Self { spec, program }
    }

    /// u, clipped, and the sum of the absolute values of its terms; `None` if u is not finite, or the
    /// law no sum of gains.
    fn at(&self, record: &Record) -> Option<(f64, f64)> {
        let free: Vec<_> = self.spec.run_time_parameters().collect();
        let parameter = |wanted: Parameter| match free.iter().position(|p| *p == wanted) {
            Some(at) => record.parameters[at],
            None => self
                .spec
                .fixed
                .get(&wanted)
                .and_then(Fixed::number)
                .map_or(f64::NAN, |number| round(number, Precision::F64)),
        };
        let input = |input: Input| match input {
            Input::Parameter(p) => parameter(p),
            Input::StartTime => parameter(Parameter::StartTime),
            Input::Time => record.t,
            Input::State(j) => record.x[j - 1],
            Input::Reference(order) => record.x[self.spec.states() + order],
            Input::ReferenceOf(..)
            | Input::StateAtStart(_)
            | Input::Gain(_)
            | Input::Divisor
            | Input::Drift
            | Input::Control
            | Input::Wanted(_) => f64::NAN,
        };
        let mut interpreter = Interpreter::new(&self.program, &input);
        let terms = self.program.gains.iter().zip(&record.x);
        let scale: f64 = terms.map(|(gain, x)| (interpreter.value(*gain) * x).abs()).sum();
        let u = interpreter.value(self.program.step);
        let limit = self.program.limits.u_max.map_or(f64::INFINITY, |v| interpreter.value(v));
        (u.is_finite() && scale > 0.0 && scale.is_finite()).then(|| (u.clamp(-limit, limit), scale))
    }
}

/// Returns true if outcomes that differ in their bits are worse than the accuracy of the family: against the reference,
/// the error of the other language may be as large as the family allows, and where the parameters are harder than that,
/// four times that of C.
fn beyond(
    reference: &Reference,
    (record, precision): (&Record, Precision),
    c: &Outcome,
    other: &Outcome,
    tally: &mut Tally,
) -> bool {
    let Some(family) = reference.spec.family() else { return false };
    if c.init != other.init {
        return true;
    }
    // A rate or a gain that is nearly no number at all decides by its last digit what overflows.
    let hard = |p: &f64| p.abs() < 1e-30 || p.abs() > 1e30;
    let Some((u, scale)) = reference.at(record) else { return false };
    if record.parameters.iter().any(hard) {
        return false;
    }
    let allowed = tolerance::control(family, precision);
    [(c.step, other.step), (c.axis, other.axis)].into_iter().any(|(a, b)| {
        // On the edge of the bound the last digit decides whether u is clipped.
        let status = a.0 == b.0 || (a.0.max(b.0) == 2 && a.0.min(b.0) >= 0);
        if a.1.to_bits() == b.1.to_bits() && status {
            return false;
        }
        let error = |v: f64| (v - u).abs() / scale;
        let error_of_both = (a.1 - b.1).abs() / scale;
        tally.greatest = tally.greatest.max(error_of_both);
        let fine = error(b.1) <= allowed.max(4.0 * error(a.1));
        !status || !fine
    })
}

/// The example with a defect must give other outcomes than C.
fn seeded(context: &Context, side: &Side<'_>, finding: &mut Finding) -> Result<()> {
    let folder = context.scratch(&format!("{}_seeded", side.language.name()));
    let specs = [context.example()];
    let home = folder.join("files");
    with_defect(&home, &specs[0], side.language, side.defect)?;
    let (records, wanted) = in_c_on_records(context, &folder, &specs);
    let found = (side.run)(&folder, &[(home, &specs[0])], &records)?;
    let bits = |outcome: &Outcome| (outcome.init, outcome.bits().1);
    let differing = wanted[0].iter().zip(&found[0]).filter(|(c, other)| bits(c) != bits(other));
    let differing = differing.count();
    let all = records[0].len();
    let caught = (differing > 0).then(|| format!("{differing} of {all} records differ"));
    finding.seed(side.defect.2, caught);
    Ok(())
}
