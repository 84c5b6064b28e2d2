//! The zero dynamics of a model: what its other states do while the output is at rest.

use super::{Outcome, Verdict};
use crate::algebra::polynomial::Polynomial;
use crate::collect::map;
use crate::expression::Expression;
use crate::linear::roots;
use crate::model::zeros::{Zeros, singular_at_rest, zeros};
use crate::model::{Coupled, Values};
use crate::parameter::Fixed;
use crate::request::{Reference, Spec};

/// Name of the check.
pub(crate) const NAME: &str = "zeros";

/// The values of the parameters that are fixed.
fn values(spec: &Spec) -> Values {
    let number = |value: &Fixed| value.number().cloned();
    map(spec.fixed.iter().filter_map(|(p, value)| Some((*p, number(value)?))))
}

/// The check of a plant with several inputs and outputs.
pub(crate) fn of_coupled(spec: &Spec, coupled: &Coupled) -> Outcome {
    let orders = coupled.orders();
    let (sum, states) = (orders.iter().sum::<usize>(), coupled.states.len());
    let all: Vec<_> = orders.iter().map(ToString::to_string).collect();
    let degrees = format!("the relative degrees are {}", all.join(", "));
    let of =
        |verdict, summary, fix| Outcome { name: NAME, verdict, summary, details: Vec::new(), fix };
    match singular_at_rest(coupled, &values(spec)) {
        Some(determinant) => of(
            Verdict::Unsound,
            format!(
                "the determinant of the decoupling matrix, {determinant}, is 0 at the origin: the law divides by it"
            ),
            Some("take outputs that the inputs move one by one at rest".to_owned()),
        ),
        None if sum == states => {
            of(Verdict::Sound, format!("none: {degrees}, whose sum is the number of states"), None)
        }
        None => of(
            Verdict::Undecided,
            format!(
                "{degrees} of {states} states; what the others do with the outputs at rest is not examined"
            ),
            None,
        ),
    }
}

/// The check of a design that has a model.
pub(crate) fn outcome(spec: &Spec) -> Option<Outcome> {
    // One output of several has no dynamics of its own.
    let model = spec.model.as_ref().filter(|model| !model.dynamics.is_empty())?;
    let values = values(spec);
    let one = Expression::integer(1);
    let gain = spec.input_gain.as_ref().unwrap_or(&one);
    let (r, states) = (spec.n, model.states.len());
    let order = states - r;
    let degree = format!("the relative degree is {r} of {states} states");
    let at = |p: &Polynomial| match roots(p) {
        Some(roots) => {
            let roots: Vec<_> = roots.iter().map(ToString::to_string).collect();
            let roots = roots.join(", ");
            format!("{degree}; at the origin the zero dynamics have the roots {roots} 1/s")
        }
        None => format!("{degree}; the zero dynamics are of order {order}"),
    };
    let (verdict, summary, fix) = match zeros(model, gain, &values) {
        Zeros::None => (
            Verdict::Sound,
            format!("none: the relative degree is {r}, the number of states"),
            None,
        ),
        Zeros::Singular => (
            Verdict::Unsound,
            format!(
                "the gain of u, {}, is 0 at the origin: the law divides by it",
                model.text(gain)
            ),
            Some("take an output whose derivative of that order u moves at rest".to_owned()),
        ),
        Zeros::Stable(p) => (Verdict::Sound, at(&p), None),
        Zeros::Unstable(p) => (
            Verdict::Unsound,
            format!("{}: with the output at rest other states leave the origin", at(&p)),
            Some(
                "take an output with stable zero dynamics, or more of the states in it".to_owned(),
            ),
        ),
        Zeros::Critical(p) => (
            Verdict::Undecided,
            format!("{}: on the imaginary axis the linearisation does not decide", at(&p)),
            None,
        ),
        Zeros::Open(why) => (
            Verdict::Undecided,
            format!("{degree}; the zero dynamics are of order {order}: {why}"),
            None,
        ),
    };
    let mut details = match order {
        0 => Vec::new(),
        _ => vec!["from the linearisation: it holds near the origin".to_owned()],
    };
    if order > 0 && spec.reference.as_ref().is_some_and(Reference::moves) {
        let driven =
            "with the output at rest: on a reference that moves it drives the other states";
        details.push(driven.to_owned());
    }
    Some(Outcome { name: NAME, verdict, summary, details, fix })
}
