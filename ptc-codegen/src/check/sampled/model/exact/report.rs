//! Report of the bounds of the loops of a plant whose chains are exact at the samples.

use super::super::super::outcome::{NAME, causes};
use super::super::report::{clipped, decided, of_chains, of_inputs, of_output};
use super::{Bounded, Exactly, Sizes, both, doubles, fractions};
use crate::algebra::BigRational;
use crate::check::Outcome;
use crate::check::sampled::worst::Bound;
use crate::diagnostic::{digits, digits_up};
use crate::request::Spec;

/// The verdict on these bounds, and what they are.
pub(super) fn judged(
    plant: &Exactly<'_>,
    found: &Bounded,
    afterwards: Option<&Bounded>,
) -> Outcome {
    let spec = plant.spec;
    let inputs = &plant.exact.coupled.inputs;
    let totals = at_deadline(plant, found);
    let u = doubles(&found.sizes.u);
    let all = format!("at the deadline {}", of_chains(&totals));
    let limited = clipped(spec, &u);
    let (verdict, summary) = decided(spec, inputs, (&plant.outputs, &totals, &u), all);
    let mut details = vec![assumed(found)];
    if spec.has_open_limit() {
        details.push("without a limit of u, which is left to run time".to_owned());
    }
    for (k, (output, worst)) in plant.outputs.iter().zip(&found.worst).enumerate() {
        let of = of_output(&plant.outputs, k);
        details.push(format!("{of}{}", force(found.errors.forces[k])));
        let states = worst.states.iter().enumerate();
        details.extend(states.map(|(i, bound)| format!("{of}{}", split(&output.spec, bound, i))));
    }
    let way = |sizes: &Sizes| {
        let (x, between) = plant.on_the_way(sizes);
        let at = if between { "between samples too" } else { "at the samples" };
        let u = of_inputs(inputs, &doubles(&sizes.u));
        format!("{at}, {}, {u}", of_chains(&x))
    };
    details.push(format!("on the way, {}", way(&found.sizes)));
    let after = afterwards.and_then(|found| after(plant, found));
    let free = |sizes: &Sizes| limited.is_none() && clipped(spec, &doubles(&sizes.u)).is_none();
    details
        .extend(after.filter(free).map(|sizes| format!("from the deadline on, {}", way(&sizes))));
    Outcome { name: NAME, verdict, summary, details, fix: None }
}

/// Bounds of the outputs with their derivatives at the deadline.
fn at_deadline(plant: &Exactly<'_>, found: &Bounded) -> Vec<Vec<f64>> {
    let chains = found.worst.iter().flat_map(|worst| &worst.states).map(Bound::total);
    let totals = sums(&chains.collect::<Vec<_>>(), &found.errors.apart);
    let infinite = || plant.outputs.iter().map(|own| vec![f64::INFINITY; own.spec.n]).collect();
    totals.map_or_else(infinite, |totals| plant.at_sample(&totals))
}

/// Returns the bounds that hold from the deadline on.
fn after(plant: &Exactly<'_>, found: &Bounded) -> Option<Sizes> {
    let after = found.worst.iter().map(|worst| worst.after.as_ref());
    let after = after.collect::<Option<Vec<_>>>()?;
    let chains: Vec<_> = after.iter().flat_map(|after| after.x.iter().copied()).collect();
    let wanted: Vec<_> = after.iter().map(|after| after.u).collect();
    let chains = sums(&chains, &found.errors.apart)?;
    Some(plant.needed(chains, fractions(&wanted).ok()?).ok()?.1)
}

fn sums(a: &[f64], b: &[f64]) -> Option<Vec<BigRational>> {
    Some(both(fractions(a).ok()?, &fractions(b).ok()?))
}

/// Describes the assumptions of the bounds.
fn assumed(found: &Bounded) -> String {
    let samples = found.worst.first().map_or(0, |worst| worst.samples);
    format!(
        "the linear plant, sampled exactly, over {samples} samples, from outputs whose derivatives are within x0_max, at any tick"
    )
}

/// Describes the force on a chain in addition to v.
fn force(force: f64) -> String {
    format!(
        "xi, its chain as it is sampled, is moved by the law without an error of the period; rounding, and what sensors and inputs are off, move it like a force of at most {}",
        digits_up(force)
    )
}

/// Describes the parts of the bound of a coordinate of a chain.
fn split(spec: &Spec, bound: &Bound, i: usize) -> String {
    let chain = Spec { model: None, ..spec.clone() };
    let part = |(cause, part): &(String, f64)| match cause.as_str() {
        "f" => format!("{} force", digits(*part)),
        cause => format!("{} {}", digits(*part), cause.replace("noise of x", "error of xi")),
    };
    let parts: Vec<_> = causes(&chain, bound).iter().map(part).collect();
    format!("|xi{}| <= {}: {}", i + 1, digits_up(bound.total()), parts.join(" + "))
}
