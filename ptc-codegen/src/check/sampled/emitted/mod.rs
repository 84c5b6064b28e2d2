//! A controller in samples as rows: what its program makes of one sample is linear in what it keeps
//! and in what is measured, and rounding is charged to each of these by itself.
//!
//! Counts are known numbers, so that every test of the program is decided but those of clipping and
//! of finite values, which are taken as passed.

mod sample;

use std::ops::RangeInclusive;

use super::chain::{Chain, Step, Unit};
use super::followed::Followed;
use super::lost::{lost, shifts};
use super::rounded::Rounded;
use crate::code::{Code, Expr, Place, Statement};
use crate::request::{After, Gate, Observer, Reference, Sampled, Spec};
use sample::Sample;

/// What a name holds at one sample.
#[derive(Clone, Debug)]
enum Held {
    Count(u32),
    /// The same at every state.
    Known(Rounded),
    /// A sum over what is kept, what is measured, and the reference.
    Linear(Vec<Rounded>),
}

/// Samples of a loop, where the input that acts is kept, and of what a controller keeps the unit and how large it
/// may be at the start.
pub(super) type Steps = (Vec<Step>, Option<usize>, Vec<(Unit, f64)>);

/// The `samples` of the loop of a controller; `None` if a value is not enclosed.
pub(super) fn steps(
    spec: &Spec,
    sampled: &Sampled,
    chain: &Chain,
    followed: Option<&Followed>,
    samples: RangeInclusive<usize>,
) -> Option<Steps> {
    // What follows the deadline is no part of the law before it, and how the reference comes about none of what
    // is done with it.
    let reference = spec.reference.as_ref().map(|_| Reference::Input);
    let spec = &Spec { after: After::Hold, reference, ..spec.clone() };
    // Every reading is believed, which the innovations have to bear out.
    let coasts = sampled.observer.as_ref().is_some_and(|observer| observer.gate.coasts());
    let observer = sampled.observer.clone();
    let observer = observer.map(|own| Observer { gate: Gate::default(), ..own });
    let sampled = &Sampled { follows: None, observer, ..sampled.clone() };
    let code = crate::samples::controller(spec, sampled, Vec::new());
    let kept: Vec<_> = kept(&code).collect();
    let acting = format!("u{}", chain.delay);
    let acting = kept.iter().position(|name| *name == acting).map(|at| chain.n + at);
    let unit = |name: &&str| {
        let state = name.strip_prefix('x').and_then(|name| name.split('_').next()?.parse().ok());
        state.map_or(Unit::Power(0), |j: usize| chain.unit(j))
    };
    let terms = followed.map(|followed| shifts(followed, &kept, sampled, &chain.shares));
    let start = |at: usize| terms.as_ref().map_or(0.0, |terms| terms[at].0);
    let units = kept.iter().enumerate().map(|(at, name)| (unit(name), start(at))).collect();
    let mut steps = Vec::with_capacity(samples.clone().count());
    // What `init` computes is the same at every sample.
    let mut begun = Sample::new(&code, &kept, (sampled, spec.references()))?;
    begun.block(&code.init)?;
    for k in samples {
        let mut sample = begun.at(k)?;
        sample.block(&code.function("step")?.body)?;
        let control = sample.end(&code.function("step")?.finish)?;
        let u = sample.row(&control, chain, true)?;
        let rows: Option<Vec<_>> = kept
            .iter()
            .map(|name| match sample.fields.get(*name)? {
                Held::Count(_) => None,
                held => sample.row(&held.clone(), chain, false),
            })
            .collect();
        let mut step = chain.step(&u, &rows?, acting);
        let lost = |held: &Held| match (held, &terms) {
            (Held::Linear(sum), Some(terms)) => lost(sum, terms),
            _ => 0.0,
        };
        if coasts {
            let rows = sample
                .innovations()
                .into_iter()
                .map(|miss| Some((sample.row(&miss, chain, false)?, lost(&miss))));
            step.innovations = rows.collect::<Option<_>>()?;
        }
        if terms.is_some() {
            step.lost_of_u = lost(&control);
            let of_u = if acting.is_none() { step.lost_of_u } else { 0.0 };
            let plant = chain.input.iter().map(|(b, error)| (b.abs() + error) * of_u);
            let rows = kept.iter().map(|name| lost(&sample.fields[*name]));
            step.lost = plant.chain(rows).map(|own| (own, 0.0)).collect();
        }
        steps.push(step);
    }
    Some((steps, acting, units))
}

/// The numbers that the controller changes from sample to sample.
fn kept(code: &Code) -> impl Iterator<Item = &str> {
    let body = code.function("step").map(|step| step.body.as_slice()).unwrap_or_default();
    let all = body.iter().filter_map(|statement| match statement {
        Statement::Set(Place::Field(name), Expr::Local(_) | Expr::Field(_)) => Some(name.as_str()),
        _ => None,
    });
    all.filter(|name| !is_rate(name))
}

/// Whether a field is rho of an input under way.
fn is_rate(name: &str) -> bool {
    name.starts_with("rho")
}
