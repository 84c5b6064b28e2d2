//! Divisor of the law: refuted where it is certain to be 0 within the bounds of the inputs.

use num_traits::ToPrimitive;

use super::known::range;
use crate::algebra::BigRational;
use crate::check::{Outcome, Verdict};
use crate::diagnostic::digits;
use crate::expression::crossing::{Free, Zero, crossing};
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::Names;
use crate::expression::{Expression, Variable};
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// The check `envelope` where the divisor of the law passes through 0 in it.
pub(super) fn zero(spec: &Spec) -> Option<Outcome> {
    let (divisor, what) = divisor(spec)?;
    let (free, given) = inputs(spec, &divisor)?;
    let (word, point, details) = match crossing(&divisor, &free, &given)? {
        Zero::At(point) => ("at", point, Vec::new()),
        Zero::Near(point) => {
            let passes = "its sign changes there, and it is continuous";
            ("near", point, vec![passes.to_owned()])
        }
    };
    let place = |((name, ..), at): (&Free, &f64)| format!("{} = {}", text(spec, name), digits(*at));
    let at: Vec<_> = free.iter().zip(&point).map(place).collect();
    Some(Outcome {
        name: super::envelope::NAME,
        verdict: Verdict::Refuted,
        summary: format!(
            "{what}, {}, is 0 {word} {}: the law divides by it",
            text(spec, &divisor),
            at.join(", ")
        ),
        details,
        fix: Some("narrow `x_max` to where it keeps its sign".to_owned()),
    })
}

/// Returns the divisor of the law at each step, with its description.
fn divisor(spec: &Spec) -> Option<(Expression, &'static str)> {
    match &spec.coupled {
        Some(coupled) => Some((coupled.determinant()?, "the determinant of the decoupling matrix")),
        None => spec.input_gain.clone().map(|gain| (gain, "the gain of u")),
    }
}

/// The expression in the names that the design uses.
fn text(spec: &Spec, expression: &Expression) -> String {
    match (&spec.coupled, &spec.model) {
        (Some(coupled), _) => coupled.text(expression),
        (None, Some(model)) => model.text(expression),
        (None, None) => expression.to_string(),
    }
}

/// The names of an expression that have a range, and those that have a value; `None` where one has neither.
fn inputs(spec: &Spec, expression: &Expression) -> Option<(Vec<Free>, Names)> {
    let mut names = Vec::new();
    expression.each(&mut |e| {
        if (e.parameter().is_some() || e.variable().is_some()) && !names.contains(e) {
            names.push(e.clone());
        }
    });
    names.sort_unstable_by_key(|name| (name.parameter(), name.variable()));
    let (mut free, mut given) = (Vec::new(), Names::new());
    for name in names {
        let (low, high) = match (name.parameter(), name.variable()) {
            (Some(parameter), _) => range(spec, parameter)?,
            (None, Some(variable)) => variable_range(spec, variable)?,
            (None, None) => return None,
        };
        if low == high {
            given.insert(name, Interval::exact(&low));
        } else {
            let (low, high) = inside(&low, &high)?;
            free.push((name, low, high));
        }
    }
    Some((free, given))
}

fn number(value: &Fixed) -> Option<BigRational> {
    value.number().cloned()
}

fn variable_range(spec: &Spec, variable: Variable) -> Option<(BigRational, BigRational)> {
    let promises = &spec.promises;
    let around = |bounds: &[Fixed], j: usize| {
        let bound = number(bounds.get(j - 1)?)?;
        Some((-bound.clone(), bound))
    };
    match variable {
        Variable::State(j) => around(&promises.x_max, j),
        Variable::StateAtStart(j) => {
            around(&promises.x0_max, j).or_else(|| around(&promises.x_max, j))
        }
        Variable::Elapsed => {
            let (_, tau) = range(spec, Parameter::Tau)?;
            Some((BigRational::default(), tau))
        }
        Variable::Time => {
            let (from, to) = range(spec, Parameter::StartTime)?;
            let (_, tau) = range(spec, Parameter::Tau)?;
            Some((from, to + tau))
        }
        _ => None,
    }
}

/// The outermost doubles between two numbers.
fn inside(low: &BigRational, high: &BigRational) -> Option<(f64, f64)> {
    let exact = |value: f64| BigRational::from_float(value);
    let (mut from, mut to) = (low.to_f64()?, high.to_f64()?);
    if exact(from)? < *low {
        from = from.next_up();
    }
    if exact(to)? > *high {
        to = to.next_down();
    }
    (from <= to).then_some((from, to))
}
