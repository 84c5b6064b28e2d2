//! The outcomes of a controller in both languages, by the interpreter, and by definition.

use std::collections::BTreeMap;
use std::fmt;

use ptc_codegen::expression::{Expression, Node, Variable};
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::program::Input;
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::range::Range;
use ptc_codegen::reference::{Call, Status, evaluate, tolerance};
use ptc_codegen::request::{Feedback, Guard, Spec};

use crate::harness::optimised;
use crate::harness::program::{Outcome, Record, real};
use crate::harness::specs::{calls_a_library, rounded};

/// Every how many of the records the interpreter sees, and every how many the definition.
const INTERPRETED: usize = 7;
const REFERENCED: usize = 5;

/// Counts of the comparison.
#[derive(Default)]
pub(super) struct Counts {
    pub(super) specs: usize,
    pub(super) refused: usize,
    pub(super) calls: usize,
    pub(super) references: usize,
    pub(super) statuses: BTreeMap<i32, usize>,
    /// Worst error by mapping and precision, as a part of what is allowed.
    pub(super) worst: BTreeMap<(String, &'static str), f64>,
}

impl Counts {
    pub(super) fn add(&mut self, other: Self) {
        self.specs += other.specs;
        self.calls += other.calls;
        self.references += other.references;
        for (status, count) in other.statuses {
            *self.statuses.entry(status).or_default() += count;
        }
        for (kind, part) in other.worst {
            let worst = self.worst.entry(kind).or_default();
            *worst = worst.max(part);
        }
    }
}

/// A record on which two of them differ.
#[derive(Clone, Debug)]
pub(super) struct Difference {
    between: &'static str,
    told: String,
    record: Record,
}

impl Difference {
    /// Returns the names of the two that differ.
    pub(super) fn kind(&self) -> &'static str {
        self.between
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Record { parameters, x0, t, x } = &self.record;
        write!(
            f,
            "{} differ: {}\nrun-time parameters {parameters:?}\nx0 {x0:?}\nt {t:?}\nx {x:?}",
            self.between, self.told
        )
    }
}

/// Compares the outcomes; returns the counts and the first difference.
pub(super) fn compare(
    spec: &Spec,
    records: &[Record],
    c: &[Outcome],
    rust: &[Outcome],
) -> (Counts, Option<Difference>) {
    let mut counts = Counts { specs: 1, calls: records.len(), ..Counts::default() };
    for outcome in c {
        let status = if outcome.init == 0 { outcome.step.0 } else { outcome.init };
        *counts.statuses.entry(status).or_default() += 1;
    }
    let library = calls_a_library(spec) || spec.custom().is_some_and(|_| calls_in_mapping(spec));
    let found = languages(spec, library, records, c, rust)
        .or_else(|| if library { None } else { interpreter(spec, records, c) })
        .or_else(|| definition(spec, records, c, &mut counts));
    (counts, found)
}

/// Only the definition, for outcomes that both languages share.
pub(super) fn against_definition(
    spec: &Spec,
    records: &[Record],
    outcomes: &[Outcome],
) -> Option<Difference> {
    definition(spec, records, outcomes, &mut Counts::default())
}

/// Returns true if the law or the input gain calls a function whose last bit depends on the library.
fn calls_in_mapping(spec: &Spec) -> bool {
    use ptc_codegen::expression::Function::{Abs, Sign, Sqrt};
    let is_call = |e: &Expression| match e.node() {
        Node::Call(function, _) => !matches!(function, Abs | Sign | Sqrt),
        _ => false,
    };
    spec.expressions().any(|e| e.any(&is_call))
}

fn languages(
    spec: &Spec,
    library: bool,
    records: &[Record],
    c: &[Outcome],
    rust: &[Outcome],
) -> Option<Difference> {
    let allowed = 64.0 * tolerance::of(spec);
    let near = |a: (i32, f64), b: (i32, f64)| {
        a.0 == b.0 && ((a.1 - b.1).abs() <= allowed * a.1.abs() || a.1.to_bits() == b.1.to_bits())
    };
    for ((record, c), rust) in records.iter().zip(c).zip(rust) {
        // Where a library is called, a cancellation may leave no digit: statuses and order agree.
        let same = if library {
            c.init == rust.init
                && (near(c.step, rust.step) || is_cancelled(spec, record, c.step, rust.step))
        } else {
            c.bits() == rust.bits()
        };
        if !same {
            let told = format!("{c:?}, {rust:?}");
            return Some(Difference { between: "C and Rust", told, record: record.clone() });
        }
    }
    None
}

/// Returns true if two results of one library each are both within the tolerance of the definition.
fn is_cancelled(spec: &Spec, record: &Record, a: (i32, f64), b: (i32, f64)) -> bool {
    let allowed = 2.0 * tolerance::of(spec);
    let Some(control) = expected(spec, record).and_then(|expected| expected.control) else {
        return false;
    };
    let edge = a.0 != b.0 && [a.0, b.0].contains(&Status::Saturated.code());
    [a.1, b.1].iter().all(|u| edge || control.error(*u) <= allowed)
}

fn parameter(spec: &Spec, record: &Record, wanted: Parameter) -> f64 {
    let at = spec.run_time_parameters().position(|p| p == wanted);
    at.map_or(f64::NAN, |at| record.parameters[at])
}

/// Returns true if the guard lets a record pass to the law.
fn passes(spec: &Spec, record: &Record) -> bool {
    let start = value(spec, record, Parameter::StartTime);
    spec.guard != Guard::Full
        || (record.t.is_finite() && record.t >= start && record.x.iter().all(|x| x.is_finite()))
}

/// A parameter, fixed or of the record.
fn value(spec: &Spec, record: &Record, wanted: Parameter) -> f64 {
    match spec.fixed.get(&wanted) {
        Some(fixed) => ptc_codegen::program::range::rounded(fixed, spec.precision),
        None => parameter(spec, record, wanted),
    }
}

/// The limits of u of a record.
fn limits(spec: &Spec, record: &Record) -> Range {
    Range::of(spec, 0, &|wanted| parameter(spec, record, wanted))
}

fn interpreter(spec: &Spec, records: &[Record], c: &[Outcome]) -> Option<Difference> {
    let program = optimised(spec);
    let settle = |value| rounded(value, spec.precision);
    let law = |arguments: &[f64]| {
        let (time, xi) = arguments.split_last().unwrap_or((&0.0, &[]));
        let sum = xi.iter().fold(0.0, |sum, xi| settle(sum + settle(-1.5 * xi)));
        settle(sum + settle(0.125 * time))
    };
    let calls = records.iter().zip(c).filter(|(record, c)| c.init == 0 && passes(spec, record));
    for (record, c) in calls.step_by(INTERPRETED) {
        let input = |input| match input {
            Input::Parameter(p) => parameter(spec, record, p),
            Input::StartTime => value(spec, record, Parameter::StartTime),
            Input::Time => record.t,
            Input::State(j) => record.x[j - 1],
            Input::StateAtStart(j) => record.x0[j - 1],
            Input::Reference(_)
            | Input::ReferenceOf(..)
            | Input::Gain(_)
            | Input::Divisor
            | Input::Drift
            | Input::Control
            | Input::Wanted(_) => f64::NAN,
        };
        let mut own = Interpreter::new(&program, &input).with_law(&law);
        let u = own.value(program.step);
        // Behind the result alone, t - t is added: a time that is no number makes u none, and -0 is 0.
        let difference = if record.t.is_finite() { 0.0 } else { f64::NAN };
        let u = if spec.guard == Guard::Result { u + difference } else { u };
        let limits = limits(spec, record);
        let agrees = match c.step.0 {
            0 | 1 => u.to_bits() == c.step.1.to_bits(),
            2 => {
                program.limits.past.is_some_and(|past| own.value(past) >= 0.0)
                    || (limits.clip(u).1 && c.step.1.to_bits() == limits.clip(u).0.to_bits())
            }
            -3 => !u.is_finite() || program.limits.past.is_some_and(|past| own.value(past) >= 0.0),
            _ => true,
        };
        if !agrees {
            let told = format!("{:?}, u = {u:e}", c.step);
            return Some(Difference {
                between: "C and the interpreter",
                told,
                record: record.clone(),
            });
        }
    }
    None
}

/// -3/2 (xi_1 + ... + xi_n) + t/8, the law that the driver gives for the user's.
fn user_law(n: usize) -> Expression {
    let three = Expression::integer(3).div(Expression::integer(2)).neg();
    let time = Expression::from(Variable::StretchedTime).div(Expression::integer(8));
    (1..=n).fold(time, |sum, i| sum.add(three.clone().mul(Variable::Xi(i).into())))
}

fn expected(spec: &Spec, record: &Record) -> Option<ptc_codegen::reference::Outcome> {
    expected_with(spec, record, value(spec, record, Parameter::Eps))
}

/// The definition with `eps` in place of the record's own.
fn expected_with(
    spec: &Spec,
    record: &Record,
    eps: f64,
) -> Option<ptc_codegen::reference::Outcome> {
    let law = user_law(spec.n);
    let mut of = spec.clone();
    of.fixed.remove(&Parameter::Eps);
    evaluate(
        &of,
        &Call {
            parameter: &|p| if p == Parameter::Eps { eps } else { parameter(spec, record, p) },
            x0: &record.x0,
            t: record.t,
            x: &record.x,
            laws: if spec.feedback == Feedback::Extern { std::slice::from_ref(&law) } else { &[] },
            after: -record.x[0],
        },
    )
}

/// The definition a unit of the last place of time-to-go later, also of one that is held.
fn moved(spec: &Spec, record: &Record) -> Option<ptc_codegen::reference::Outcome> {
    let tau = value(spec, record, Parameter::Tau);
    let place = match spec.precision {
        Precision::F64 => f64::EPSILON,
        Precision::F32 => f64::from(f32::EPSILON),
    };
    let ends = record.t + place * tau.max(record.t.abs());
    let t = if spec.precision == Precision::F32 { ends } else { ends.max(record.t.next_up()) };
    let eps = value(spec, record, Parameter::Eps) * (1.0 - place);
    expected_with(spec, &Record { t, ..record.clone() }, eps)
}

fn definition(
    spec: &Spec,
    records: &[Record],
    c: &[Outcome],
    counts: &mut Counts,
) -> Option<Difference> {
    let kind = (spec.mapping_name().to_owned(), real(spec.precision));
    let calls = records.iter().zip(c).filter(|(record, c)| c.init == 0 && is_usual(spec, record));
    for (record, c) in calls.step_by(REFERENCED) {
        let Some(expected) = expected(spec, record) else { continue };
        let difference = |told: String| {
            Some(Difference { between: "C and the definition", told, record: record.clone() })
        };
        let Some(control) = &expected.control else {
            if expected.status.code() != c.step.0 && spec.guard == Guard::Full {
                return difference(format!("{:?}, {expected:?}", c.step));
            }
            continue;
        };
        let (least, most) = match spec.precision {
            Precision::F64 => (1e-200, 1e150),
            Precision::F32 => (1e-20, 1e20),
        };
        if !(least..most).contains(&control.scale()) {
            continue;
        }
        counts.references += 1;
        let allowed = tolerance::of(spec);
        let room = 2.0 * allowed * control.scale();
        let edge = limits(spec, record).finite().any(|limit| (control.u() - limit).abs() <= room);
        let eps = value(spec, record, Parameter::Eps);
        let at_eps = (expected.time_to_go - eps).abs() <= 1e-6 * eps;
        if c.step.0 != expected.status.code() && !edge && !at_eps {
            return difference(format!(
                "{:?}, {:?} with u = {:e}",
                c.step,
                expected.status,
                control.u()
            ));
        }
        if matches!(c.step.0, 0 | 1) && !at_eps {
            let mut error = control.error(c.step.1) / allowed;
            // What one unit of the last place of time-to-go does to u, where terms of u that are
            // nearly 0 hide it from the scale.
            if error > 1.0 {
                let moved = moved(spec, record).and_then(|moved| moved.control);
                let by = moved.map_or(0.0, |moved| (moved.u() - control.u()).abs());
                error /= 1.0 + 4.0 * by / (allowed * control.scale());
            }
            let worst = counts.worst.entry(kind.clone()).or_default();
            *worst = worst.max(error);
            if error.is_nan() || error > 1.0 {
                let told = format!(
                    "{:?}, u = {:e} with scale {:e}: {error:.2} of what is allowed",
                    c.step,
                    control.u(),
                    control.scale()
                );
                return difference(told);
            }
        }
    }
    None
}

/// Returns true if the numbers are of the sizes for which the accuracy is promised, tests/data/README.md.
fn is_usual(spec: &Spec, record: &Record) -> bool {
    let within =
        |value: f64, low: f64, high: f64| value == 0.0 || (low..high).contains(&value.abs());
    let parameters = spec.run_time_parameters().all(|p| {
        let value = parameter(spec, record, p);
        match p {
            Parameter::Tau => within(value, 0.1, 1e2),
            Parameter::A | Parameter::Rate(_) | Parameter::M | Parameter::Named(_) => {
                within(value, 0.1, 4.0)
            }
            Parameter::Start => within(value, 0.05, 1.5),
            Parameter::Gain(_) => within(value, 1e-3, 1e3),
            Parameter::StartTime
            | Parameter::Eps
            | Parameter::UMax
            | Parameter::UMin
            | Parameter::Samples
            | Parameter::SampleTime
            | Parameter::Deadbeat => true,
        }
    });
    parameters && record.x.iter().chain(&record.x0).all(|x| !x.is_finite() || within(*x, 1e-3, 1e3))
}
