//! Divisor of the law: refuted where it is certain to be 0 within the bounds of the inputs, and looked at where the plant
//! comes to rest.

use num_traits::{ToPrimitive, Zero as _};

use super::known::range;
use crate::algebra::BigRational;
use crate::check::{Outcome, Verdict};
use crate::diagnostic::digits;
use crate::expression::crossing::{Free, Zero, crossing};
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::{Evaluator, Existence, Names};
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Reference, Spec};

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

/// The check `growth` of a chain whose gain of u may be 0 where the chain comes to rest; of models `zeros` looks at it.
pub(super) fn at_rest(spec: &Spec, growth: Outcome) -> Outcome {
    let gain = spec.input_gain.as_ref().filter(|_| !spec.has_model() && growth.is_checked());
    let found = gain.and_then(|gain| Some((text(spec, gain), zero_at_rest(spec, gain)?)));
    let Some((gain, (verdict, is))) = found else { return growth };
    Outcome {
        verdict,
        summary: format!("the gain of u, {gain}, {is} where x is at rest: the law divides by it"),
        fix: Some("take coordinates in which u moves the plant at rest".to_owned()),
        ..growth
    }
}

/// Returns a verdict on the gain of u with the states of a chain at their references, and what the gain is; `None` if it
/// is not found to be 0 there, or depends on what is left to run time.
fn zero_at_rest(spec: &Spec, gain: &Expression) -> Option<(Verdict, &'static str)> {
    const ZERO: (Verdict, &str) = (Verdict::Unsound, "is 0");
    let references = match &spec.reference {
        Some(Reference::Input) => return None,
        Some(Reference::Known(_)) => spec.known_references().next().unwrap_or_default(),
        None => &[],
    };
    let rest = |j: usize| references.get(j - 1).cloned().unwrap_or(Expression::integer(0));
    let gain = normal(&gain.substitute(&|e| match e.variable() {
        Some(Variable::State(j)) => Some(rest(j)),
        _ => None,
    }));
    if let Some(number) = gain.number() {
        return number.is_zero().then_some(ZERO);
    }
    let (free, given) = inputs(spec, &gain)?;
    if !free.is_empty() {
        return crossing(&gain, &free, &given).map(|_| ZERO);
    }
    match Evaluator::new().value(&gain, &given) {
        Some(value) if value.existence == Existence::Certain => {
            value.interval.has_zero().then_some((Verdict::Undecided, "may be 0"))
        }
        _ => Some((Verdict::Undecided, "has no value that is known")),
    }
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
