//! The report of an [`Envelope`].

use super::super::{Outcome, Verdict};
use super::{Computed, Envelope, Excess};
use crate::diagnostic::digits;
use crate::parameter::Precision;
use crate::program::{Input, Op, Program, Value, number};

/// The name of a value, else its expression.
pub(crate) fn describe(program: &Program, value: Value) -> String {
    let text = expression(program, value, 2);
    let inner = text.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
    inner.map_or(text.clone(), str::to_owned)
}

/// The name of a value, else its expression, written out to `depth`.
fn expression(program: &Program, value: Value, depth: u32) -> String {
    let definition = program.get(value);
    if let Some((name, _)) = &definition.name {
        return name.clone();
    }
    let part = |v: &Value| expression(program, *v, depth - 1);
    let infix = |a, sign, b| format!("({}{sign}{})", part(a), part(b));
    let call = |name, a| format!("{name}({})", part(a));
    let call_two = |name, a, b| format!("{name}({}, {})", part(a), part(b));
    match &definition.op {
        Op::Number(number) => digits(number::round(number, program.precision)),
        Op::Input(input) => input_name(*input),
        Op::Unknown | Op::Root(_) => "stretched time".to_owned(),
        _ if depth == 0 => "...".to_owned(),
        Op::Neg(a) => format!("-{}", part(a)),
        Op::Add(a, b) => infix(a, " + ", b),
        Op::Sub(a, b) => infix(a, " - ", b),
        Op::Mul(a, b) => infix(a, "*", b),
        Op::Fused(a, b, c) => format!("({}*{} + {})", part(a), part(b), part(c)),
        Op::Div(a, b) | Op::Quotient(a, b) => infix(a, "/", b),
        Op::Power(a, exponent) => format!("{}^{exponent}", part(a)),
        Op::Max(a, b) => call_two("max", a, b),
        Op::Min(a, b) => call_two("min", a, b),
        Op::Pow(a, b) => call_two("pow", a, b),
        Op::Call(function, a) => call(function.name(), a),
        Op::Law(_) => "pi0".to_owned(),
        Op::Rows { .. } => "rows".to_owned(),
        Op::Elimination { .. } => "inputs".to_owned(),
        Op::Element(array, index) => format!("{}[{index}]", part(array)),
    }
}

/// Returns the name of an input.
pub(super) fn input_name(input: Input) -> String {
    match input {
        Input::Parameter(parameter) => match parameter.index() {
            Some(index) => format!("{}[{index}]", parameter.key()),
            None => parameter.key().to_owned(),
        },
        Input::Divisor => "g".to_owned(),
        other => other.name(),
    }
}

impl From<&Envelope> for Outcome {
    fn from(envelope: &Envelope) -> Self {
        let type_name = envelope.precision.name();
        let mut found: Vec<_> = [("step", &envelope.step), ("axis", &envelope.axis)]
            .into_iter()
            .filter_map(|(function, excess)| Some((function, excess.as_ref()?)))
            .collect();
        // What certainly happens comes before what may.
        found.sort_by_key(|(_, excess)| excess.refuted_at.is_none());
        let mut sentences =
            found.iter().map(|(function, excess)| sentence(function, excess, type_name));
        let Some(summary) = sentences.next() else {
            let covered = stretch(envelope.time_to_go);
            return Self {
                name: "envelope",
                verdict: Verdict::Sound,
                summary: format!("every value stays within {type_name} for T in {covered}"),
                details: Vec::new(),
                fix: None,
            };
        };
        let mut details: Vec<_> = sentences.collect();
        let (_, first) = found[0];
        if let Some(inputs) = &first.singular {
            let place = if inputs.is_empty() { "" } else { " for " };
            let place = format!("{place}{}", all_given(inputs));
            details.push(format!("the decoupling matrix is not shown to be regular{place}"));
        }
        details.push(format!("with {}", all_given(&first.inputs)));
        let refuted = first.refuted_at.is_some();
        let wider = if envelope.precision == Precision::F32 { ", or f64" } else { "" };
        Self {
            name: "envelope",
            verdict: if refuted { Verdict::Refuted } else { Verdict::Undecided },
            summary,
            details,
            fix: Some(format!("take a larger eps{wider}, or narrower bounds of the inputs")),
        }
    }
}

fn sentence(function: &str, excess: &Excess, type_name: &str) -> String {
    let what = &excess.what;
    match excess.refuted_at {
        Some(t) => {
            let t = digits(t);
            format!("{function} overflows {type_name} at T = {t} s; {what} may be the first to")
        }
        None => {
            let piece = stretch(excess.time_to_go);
            format!("in {function} {what} may leave the range of {type_name} for T in {piece}")
        }
    }
}

fn stretch((low, high): (f64, f64)) -> String {
    format!("[{}, {}] s", digits(low), digits(high))
}

pub(super) fn all_given(inputs: &[(String, Computed)]) -> String {
    let inputs: Vec<_> = inputs.iter().map(|(name, bound)| given(name, bound)).collect();
    inputs.join(", ")
}

fn given(name: &str, bound: &Computed) -> String {
    let [low, high] = bound.range.ends();
    if low.to_bits() == high.to_bits() {
        return format!("{name} = {}", digits(low));
    }
    format!("{name} in [{}, {}]", digits(low), digits(high))
}
