//! A controller in samples as rows: over one sample its program is linear in the values that it keeps and in the
//! measurements, and each of these is charged with its own rounding error.
//!
//! Counts are known numbers, so that every test of the program is decided, except those of clipping and of finite
//! values, which are assumed to pass.

mod repeats;
mod sample;

use std::ops::RangeInclusive;
use std::sync::Arc;

use super::chain::{Chain, Layout, Rows, Steps, Unit};
use super::followed::Followed;
use super::lost::{lost, shifts};
use super::rounded::Rounded;
use super::worst::Sampled as Closed;
use crate::code::{Code, Expr, Place, Statement};
use crate::request::{After, Gate, Observer, Reference, Sampled, Spec};
use sample::Sample;

/// Value of a name at one sample.
#[derive(Clone, Debug)]
enum Held {
    Count(u32),
    /// The same at every state.
    Known(Rounded),
    /// A sum over the kept values, the measurements and the reference.
    Linear(Vec<Rounded>),
}

/// Samples of a controller in a loop.
pub(super) struct Samples {
    pub(super) rows: Vec<Rows>,
    layout: Layout,
    /// Unit of each kept value of the controller, and its bound at the start.
    kept: Vec<(Unit, f64)>,
}

impl Samples {
    /// The loop of a plant and these samples.
    pub(super) fn closed(self, chain: Chain) -> Closed {
        self.after(chain, &Arc::default(), 0)
    }

    /// The same behind the first ones of other samples.
    pub(super) fn after(self, chain: Chain, free: &Arc<[Rows]>, first: usize) -> Closed {
        let samples = first + self.rows.len();
        let steps = Steps::new(self.layout, free, first, self.rows).late(chain.delay, samples);
        Closed::of(chain, steps, &self.kept)
    }
}

/// The `samples` of the loop of a controller; `None` if a value is not enclosed.
pub(super) fn samples(
    spec: &Spec,
    sampled: &Sampled,
    chain: &Chain,
    followed: Option<&Followed>,
    samples: RangeInclusive<usize>,
) -> Option<Samples> {
    // Samples after the deadline do not affect the law before it, and the source of the reference does not affect
    // its use.
    let reference = spec.reference.as_ref().map(|_| Reference::Input);
    let spec = &Spec { after: After::Hold, reference, ..spec.clone() };
    // The rows assume that every reading is believed; the bounds of the innovations have to confirm it.
    let coasts = sampled.coasts();
    let observer = sampled.observer.clone();
    let observer = observer.map(|own| Observer { gate: Gate::default(), ..own });
    // The deadline is the one that `arm` sets.
    let sampled = &Sampled { follows: None, observer, flight: None, ..sampled.clone() };
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
    // The results of `init` are the same at every sample.
    let mut begun = Sample::new(&code, &kept, (sampled, spec.references()))?;
    begun.block(&code.init)?;
    let step = code.function("step")?;
    let mut rows: Vec<Rows> = Vec::with_capacity(samples.clone().count());
    let (mut trace, mut innovations) = (None, None);
    for k in samples {
        if let Some((trace, same)) = trace.as_ref().zip(rows.last())
            && begun.repeats(trace, k)
        {
            rows.push(same.clone());
            continue;
        }
        let mut sample = begun.at(k)?;
        sample.block(&step.body)?;
        let control = sample.end(&step.finish)?;
        let u = sample.row(&control, chain, true)?;
        let kept_rows: Option<Vec<_>> = kept
            .iter()
            .map(|name| match sample.fields.get(*name)? {
                Held::Count(_) => None,
                held => sample.row(held, chain, false),
            })
            .collect();
        // Behind the kept values: the distance of each measurement from the prediction of an observer.
        let missed = if coasts { sample.innovations() } else { Vec::new() };
        if *innovations.get_or_insert(missed.len()) != missed.len() {
            return None;
        }
        let missed_rows: Option<Vec<_>> =
            missed.iter().map(|held| sample.row(held, chain, false)).collect();
        let lost = terms.as_ref().map_or_else(Vec::new, |terms| {
            let lost = |held: &Held| match held {
                Held::Linear(sum) => lost(sum, terms),
                Held::Known(_) | Held::Count(_) => 0.0,
            };
            let of_kept = kept.iter().map(|name| &sample.fields[*name]);
            std::iter::once(&control).chain(of_kept).chain(&missed).map(lost).collect()
        });
        rows.push(Rows::new(&u, &[kept_rows?, missed_rows?].concat(), &lost));
        trace = Some(sample.trace);
    }
    let layout = Layout {
        size: chain.n + kept.len(),
        causes: chain.sensors() + 1,
        innovations: innovations.unwrap_or(0),
        acting,
    };
    Some(Samples { rows, layout, kept: units })
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

/// Returns true if a field is rho of an input under way.
fn is_rate(name: &str) -> bool {
    name.starts_with("rho")
}
