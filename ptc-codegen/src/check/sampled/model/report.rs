//! Report of the bounds of the loops of a model.

use super::super::outcome::{CLIPPED, NAME, followed, limit_of_u, split};
use super::motion::Motion;
use super::{Afterwards, Bounded, Output};
use crate::check::{Outcome, Verdict, bounds};
use crate::diagnostic::{digits, digits_up};
use crate::parameter::Name;
use crate::request::{Spec, one_or_each};

/// The verdict on these bounds, and what they are.
pub(super) fn judged(
    spec: &Spec,
    motion: &Motion,
    (outputs, found): (&[Output], &Bounded),
    afterwards: Option<&Afterwards>,
) -> Outcome {
    let totals = found.worst.iter();
    let totals = totals.map(|worst| worst.states.iter().map(|bound| bound.total()).collect());
    let totals: Vec<Vec<f64>> = totals.collect();
    let all = format!("at the deadline {}", of_chains(&totals));
    let limited = clipped(spec, &found.u);
    let (verdict, summary) = decided(spec, &motion.inputs, (outputs, &totals, &found.u), all);
    let mut details = vec![assumed(found)];
    for (k, output) in outputs.iter().enumerate() {
        let (worst, of) = (&found.worst[k], of_output(outputs, k));
        details.push(format!("{of}{}", force(&output.spec, outputs.len(), found.force[k])));
        details.extend(followed(&output.spec).map(|line| format!("{of}{line}")));
        if k == 0 && spec.has_open_limit() {
            details.push("without a limit of u, which is left to run time".to_owned());
        }
        let parts = (0..output.spec.n).map(|i| split(&output.spec, worst, i));
        details.extend(parts.map(|line| format!("{of}{line}")));
    }
    let x: Option<Vec<_>> =
        found.worst.iter().map(|worst| Some(worst.way.as_ref()?.x.clone())).collect();
    if let Some(x) = x {
        let (x, u) = (of_chains(&x), of_inputs(&motion.inputs, &found.u));
        let states = Name::listed(&motion.states);
        details.push(format!(
            "on the way, between samples too, {x}, {u}, and {states} stay within x_max"
        ));
    }
    let free = |(_, u): &&Afterwards| limited.is_none() && clipped(spec, u).is_none();
    if let Some((x, u)) = afterwards.filter(free) {
        let (x, u) = (of_chains(x), of_inputs(&motion.inputs, u));
        details.push(format!("from the deadline on {x}, {u}"));
    }
    Outcome { name: NAME, verdict, summary, details, fix: None }
}

/// The verdict on bounds of the outputs with their derivatives and of the inputs, of which `all` is the text.
pub(super) fn decided(
    spec: &Spec,
    inputs: &[Name],
    (outputs, totals, u): (&[Output], &[Vec<f64>], &[f64]),
    all: String,
) -> (Verdict, String) {
    if let Some(j) = clipped(spec, u) {
        return (
            Verdict::Undecided,
            format!("{CLIPPED}: {}", beyond_limit(spec, inputs, (j, u[j]))),
        );
    }
    if spec.promises.error.is_empty() {
        return (Verdict::NotChecked, format!("`error` is not given: {all}"));
    }
    match above(outputs, totals) {
        Some((name, error)) => {
            (Verdict::Undecided, format!("{all}, above error = {} for {name}", digits(error)))
        }
        None => (Verdict::Sound, all),
    }
}

/// The first state whose bound is above `error`, and this.
fn above(outputs: &[Output], totals: &[Vec<f64>]) -> Option<(String, f64)> {
    for (k, (output, totals)) in outputs.iter().zip(totals).enumerate() {
        let errors = &output.spec.promises.error;
        let error = |i: usize| one_or_each(errors, i).unwrap_or(f64::INFINITY);
        if let Some(i) = (0..totals.len()).find(|i| totals[*i] > error(*i)) {
            let output = if outputs.len() > 1 { format!("_{}", k + 1) } else { String::new() };
            return Some((format!("x{}{output}", i + 1), error(i)));
        }
    }
    None
}

/// The first input that may be clipped.
pub(super) fn clipped(spec: &Spec, u: &[f64]) -> Option<usize> {
    let mut all = u.iter().enumerate();
    all.position(|(j, u)| limit_of_u(spec, j).is_some_and(|(limit, _)| *u >= limit))
}

/// Reports that an input may be above its bound.
fn beyond_limit(spec: &Spec, inputs: &[Name], (j, u): (usize, f64)) -> String {
    let most = digits_up(u);
    let (limit, key) = limit_of_u(spec, j).unwrap_or((f64::INFINITY, "u_max"));
    if inputs.len() == 1 {
        return format!("|u| is only known to be below {most}, above {key}");
    }
    let name = inputs[j].text();
    format!("|{name}| is only known to be below {most}, above {key} of {}", digits(limit))
}

/// Describes the assumptions of the bounds.
fn assumed(found: &Bounded) -> String {
    let samples = found.worst.first().map_or(0, |worst| worst.samples);
    let chains = if found.worst.len() > 1 { "chains are" } else { "chain is" };
    format!(
        "the model over {samples} samples, from states within x_max whose {chains} within x0_max, at any tick"
    )
}

/// The force on a chain, and the order of the error that it leaves.
fn force(spec: &Spec, outputs: usize, force: f64) -> String {
    let n = spec.n;
    let what = match (outputs, spec.reference.is_some()) {
        (1, true) => "f + g u - r^(n)".to_owned(),
        (1, false) => "f + g u".to_owned(),
        (_, true) => format!("x{n}' - r^({n})"),
        (_, false) => format!("x{n}'"),
    };
    format!(
        "between samples {what} is within {} of what it was at the sample, which leaves an error of order h^({}-i) in x_i",
        digits_up(force),
        n + 2
    )
}

/// Says of which output a line is, where there are several.
pub(super) fn of_output(outputs: &[Output], k: usize) -> String {
    if outputs.len() > 1 { format!("output {}: ", k + 1) } else { String::new() }
}

/// Bounds of the chains.
pub(super) fn of_chains(x: &[Vec<f64>]) -> String {
    let all: Vec<_> = x.iter().map(|x| bounds(x.iter().copied())).collect();
    match all.as_slice() {
        [one] => format!("|x| <= {one}"),
        all => {
            let of = |(k, x): (usize, &String)| format!("{x} of output {k}");
            let all: Vec<_> = (1..).zip(all).map(of).collect();
            format!("|x| <= {}", all.join("; "))
        }
    }
}

/// Bounds of the inputs.
pub(super) fn of_inputs(inputs: &[Name], u: &[f64]) -> String {
    let of = |(name, u): (&Name, &f64)| format!("|{name}| <= {}", digits_up(*u));
    inputs.iter().zip(u).map(of).collect::<Vec<_>>().join(", ")
}
