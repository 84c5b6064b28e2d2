//! Objectives of the loop that runs, by its worst case.

use num_traits::Zero;

use super::super::allowance::{Comparison, over};
use super::super::{Campaign, Interval, Kind, Objective, Signal};
use super::Proof;
use super::affine::Affine;
use crate::check::sampled::{Bound, Span, Worst, causes, proved as worst_case};
use crate::diagnostic::{digits, digits_up};
use crate::expression::Expression;
use crate::expression::normal::normal;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;
use crate::syntax::number;

/// Why the worst case does not prove an objective.
enum Lack {
    /// It is not about the objective.
    Unknown(String),
    /// The bounded quantity may reach a value, and this is its bound.
    NoRoom { what: String, most: f64, bound: f64 },
}

impl From<String> for Lack {
    fn from(why: String) -> Self {
        Self::Unknown(why)
    }
}

impl From<&str> for Lack {
    fn from(why: &str) -> Self {
        Self::Unknown(why.to_owned())
    }
}

/// Why the worst case is not that of a run, if its deadline or its events change it.
pub(super) fn changes(campaign: &Campaign) -> Option<&'static str> {
    if !campaign.events.is_empty() {
        return Some("events change the run, and the proof is of one without them");
    }
    let why = "the controller may change its deadline, and the proof is of the one at `arm`";
    campaign.spec.changes_deadline().then_some(why)
}

/// For each objective whether the worst case proves it, or refutes it, or why not.
pub(super) fn proved(campaign: &Campaign) -> Vec<Proof> {
    let worst = worst(campaign);
    let one = |objective: &Objective| match &worst {
        Err(why) => Proof::NotProved { why: why.clone() },
        Ok(worst) => match holds(campaign, worst, &objective.kind) {
            Ok(scope) => Proof::Proved { scope },
            Err(Lack::Unknown(why)) => Proof::NotProved { why },
            Err(Lack::NoRoom { what, most, bound }) => {
                let why = format!(
                    "{what} may reach {}, and its bound is {}",
                    digits_up(most),
                    digits(bound)
                );
                exceeded(campaign, worst, (&objective.kind, over(most, bound)), why)
            }
        },
    };
    campaign.objectives.iter().map(one).collect()
}

/// Names the cause of most of the largest worst |x_i| at the deadline in the loop that runs, in one line; `None` where
/// its worst case is not known.
pub fn limits(campaign: &Campaign) -> Option<String> {
    if campaign.around.is_none() || changes(campaign).is_some() {
        return None;
    }
    let worst = worst(campaign).ok()?;
    let states = worst.states.iter().enumerate();
    let (state, bound) = states.max_by(|a, b| a.1.total().total_cmp(&b.1.total()))?;
    let all = causes(&campaign.spec, bound).into_iter();
    let (cause, own) = all.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let total = bound.total();
    Some(format!(
        "{cause} accounts for {:.0} % of the worst |x{}| at the deadline, {}: half of it leaves {}",
        100.0 * own / total,
        state + 1,
        digits(total),
        digits(total - 0.5 * own)
    ))
}

/// Returns the result for an objective for which the worst case leaves no room, with the excess of the worst case.
fn exceeded(campaign: &Campaign, worst: &Worst, (kind, most): (&Kind, f64), why: String) -> Proof {
    // Bounds of any signal say nothing of some.
    let is_free = |legal: &[Signal]| {
        legal.contains(&Signal::Worst) || legal.iter().all(|signal| *signal == Signal::Constant)
    };
    if !campaign.disturbances.iter().all(|(_, _, legal)| is_free(legal)) {
        let why = format!("{why}, with signals that are not all in this campaign");
        return Proof::NotProved { why };
    }
    let Some(Reached { what, value, bound }) = reached(campaign, worst, kind) else {
        return Proof::NoRoom { why, place: None };
    };
    let excess = over(value, bound);
    let reached = || format!("the worst signals of the loop reach {what} = {}", digits(value));
    match Comparison::of(excess) {
        Comparison::Exceeded => Proof::Refuted { why: reached(), excess },
        Comparison::Met if Comparison::of(most) == Comparison::Met => Proof::Met { why: reached() },
        _ => Proof::NoRoom { why, place: None },
    }
}

/// Lower bound that signals that are allowed reach.
struct Reached {
    what: String,
    value: f64,
    bound: f64,
}

/// Returns the value that the bounded quantity of an objective reaches, if it is known.
fn reached(campaign: &Campaign, worst: &Worst, kind: &Kind) -> Option<Reached> {
    let spec = &campaign.spec;
    // Quanta are bounded like noise, but nobody chooses them: their part may have the other sign.
    let is_rounded = |steps: &[Fixed]| {
        steps.iter().any(|step| step.number().is_some_and(|step| !step.is_zero()))
    };
    let is_quantised =
        is_rounded(spec.promises.u_step.as_slice()) || is_rounded(&spec.promises.sensor_step);
    if is_quantised || campaign.until > 0.0 {
        return None;
    }
    let of_states = |bounds: &dyn Fn(usize) -> f64| {
        let sizes = worst.reached.iter().enumerate().map(|(i, value)| Reached {
            what: format!("|x{}| at the deadline", i + 1),
            value: *value,
            bound: bounds(i),
        });
        sizes.max_by(|a, b| (a.value / a.bound).total_cmp(&(b.value / b.bound)))
    };
    match kind {
        Kind::Attractive { error } => of_states(&|_| *error),
        Kind::AttractiveEach { errors } => {
            of_states(&|i| errors.get(i).map_or(f64::INFINITY, |(_, error)| *error))
        }
        // What is late may act after the end of the run.
        Kind::Input { upsilon } if campaign.around.as_ref()?.delay.inputs() == 0 => {
            let (value, bound) = (worst.way.as_ref()?.u_attained, constant(upsilon).ok()?);
            Some(Reached { what: "|u|".to_owned(), value, bound })
        }
        Kind::Input { .. } | Kind::Inputs { .. } | Kind::State { .. } | Kind::Within { .. } => None,
    }
}

/// The worst case of the loop of a campaign from any state of its box.
fn worst(campaign: &Campaign) -> Result<Worst, String> {
    let (least, most) = campaign.tau;
    if least < most {
        return Err("tau is an interval, and the worst case is of one".to_owned());
    }
    let mut spec: Spec = campaign.spec.clone();
    let exact = |value: f64| number(&format!("{value:e}")).ok_or("a bound is not a number");
    spec.fixed.insert(Parameter::Tau, exact(least)?);
    let middle: Vec<_> = campaign.x0.iter().map(|(low, high)| 0.5 * low + 0.5 * high).collect();
    let radius = |((low, high), middle): (&Interval, &f64)| {
        let radius = (high - middle).max(middle - low);
        // Both are rounded.
        exact(if radius > 0.0 { radius.next_up() } else { radius })
    };
    let radii = campaign.x0.iter().zip(&middle).map(radius);
    spec.promises.x0_max = radii.collect::<Result<_, _>>()?;
    let sums: Vec<_> = sums(campaign).map(|affine| affine.sum()).collect();
    worst_case(&spec, &middle, &sums)
}

/// The sums of several parts that objectives bound.
fn sums(campaign: &Campaign) -> impl Iterator<Item = Affine> {
    let of = |objective: &Objective| match &objective.kind {
        Kind::Within { h, .. } => Affine::of(h, campaign.spec.n),
        _ => None,
    };
    campaign.objectives.iter().filter_map(of).filter(|affine| !affine.is_of_one())
}

/// Bounds of a sum along a run.
struct Largest {
    span: Span,
    /// True if they hold between the samples too.
    between: bool,
    /// True if that is attained, or nearly so.
    is_close: bool,
}

impl Largest {
    /// Bounds of the parts of a sum one by one need not be attained together: that they leave no room says nothing of it.
    fn lack(&self, lack: Lack) -> Lack {
        match lack {
            Lack::NoRoom { what, most, bound } if !self.is_close => Lack::Unknown(format!(
                "with its parts bounded one by one {what} may reach {}, and its bound is {}",
                digits_up(most),
                digits(bound)
            )),
            lack => lack,
        }
    }
}

/// Names the part of the run that a proof of the objective is about, or why it is not proved.
fn holds(campaign: &Campaign, worst: &Worst, kind: &Kind) -> Result<String, Lack> {
    let way = || worst.way.as_ref().ok_or("there are more samples than it bounds one by one");
    let beyond = campaign.until < 0.0;
    let after = || match beyond {
        true => worst.after.as_ref().map(Some).ok_or("no bounds are found after the deadline"),
        false => Ok(None),
    };
    let between = |between: bool| match between {
        true => "the emitted program with its rounding, between the samples too",
        false => "the emitted program with its rounding, at the samples",
    };
    // Interval of a sum over x and the acting u, from t0 to the end.
    let largest = |affine: &Affine| -> Result<Largest, Lack> {
        let (way, after) = (way()?, after()?);
        let between = way.between && after.is_none_or(|after| after.between);
        // A sample that is early or late is not among the bounded ones.
        if !between
            && affine.has_states()
            && campaign.around.as_ref().is_some_and(|a| a.jitter > 0.0)
        {
            return Err("it bounds the samples alone, and jitter moves them".into());
        }
        let place = sums(campaign).position(|other| other == *affine);
        let exact = place.and_then(|place| way.sums.get(place)).map(|sum| affine.moved(*sum));
        let apart = affine.over(&way.within, way.acts);
        let on_way = exact.map_or(apart, |exact| exact.common(apart));
        let later = after.map(|after| {
            let states: Vec<_> = after.x.iter().map(|size| Span::of_size(*size)).collect();
            affine.over(&states, Span::of_size(after.acts))
        });
        let is_close = affine.is_of_one() || exact.is_some() && later.is_none();
        let span = later.map_or(on_way, |later| on_way.hull(later));
        Ok(Largest { span, between: between || !affine.has_states(), is_close })
    };
    // |x_i| at the deadline, and from there on.
    let at_end = || -> Result<Vec<f64>, Lack> {
        if campaign.until > 0.0 {
            return Err("the run ends before the deadline, and it bounds x there".into());
        }
        let after = after()?;
        let later = |i: usize| after.and_then(|after| after.x.get(i)).copied().unwrap_or(0.0);
        let states = worst.states.iter().enumerate();
        Ok(states.map(|(i, bound)| bound.total().max(later(i))).collect())
    };
    let scope_at_end = || -> Result<String, Lack> {
        Ok(match after()? {
            Some(after) => between(after.between),
            None => "the emitted program with its rounding, at the deadline",
        }
        .to_owned())
    };
    match kind {
        Kind::Attractive { error } => {
            let at_deadline = size(worst.states.iter().map(Bound::total));
            let later = after()?.map_or(0.0, |after| size(after.x.iter().copied()));
            at_end()?;
            within(at_deadline.max(later), *error, "|x|")?;
            scope_at_end()
        }
        Kind::AttractiveEach { errors } => {
            for (most, (index, error)) in at_end()?.into_iter().zip(errors) {
                within(most, *error, &format!("|x{index}|"))?;
            }
            scope_at_end()
        }
        Kind::Input { upsilon } => {
            let found = largest(&Affine::control())?;
            within(found.span.size(), constant(upsilon)?, "|u|")?;
            Ok(between(found.between).to_owned())
        }
        Kind::Inputs { .. } => Err("the plant has several inputs".into()),
        Kind::Within { h, low, high } => {
            let affine = Affine::of(h, campaign.spec.n);
            let affine = affine.ok_or("the worst case bounds sums of x1..xn and u, and not h")?;
            let found = largest(&affine)?;
            if let Some(high) = high {
                within(found.span.high, constant(high)?, "h").map_err(|lack| found.lack(lack))?;
            }
            if let Some(low) = low {
                within(-found.span.low, -constant(low)?, "-h").map_err(|lack| found.lack(lack))?;
            }
            Ok(between(found.between).to_owned())
        }
        Kind::State { .. } => {
            Err("the worst case is of the box of initial states, and the bound goes with x0".into())
        }
    }
}

/// The value of an expression without variables, in doubles.
pub(super) fn number_of(expression: &Expression) -> Option<f64> {
    let exact = normal(expression).number().cloned();
    exact.and_then(|value| num_traits::ToPrimitive::to_f64(&value))
}

/// The Euclidean norm of what is bounded in each part, rounded up.
fn size(parts: impl Iterator<Item = f64>) -> f64 {
    let sum: f64 = parts.map(|x| x * x).sum();
    // Each of n <= 12 squares, sums and the root is off by at most 2^-53 of itself.
    sum.sqrt() * (1.0 + 1e-14)
}

fn constant(bound: &Expression) -> Result<f64, String> {
    number_of(bound)
        .ok_or_else(|| format!("its bound {bound} goes with time, and the worst case does not"))
}

fn within(most: f64, bound: f64, what: &str) -> Result<(), Lack> {
    match most < bound {
        true => Ok(()),
        false => Err(Lack::NoRoom { what: what.to_owned(), most, bound }),
    }
}
