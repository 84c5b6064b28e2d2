//! Objectives of the loop that runs, by its worst case.

use super::super::objective::over;
use super::super::{Campaign, Interval, Kind, Objective, Signal};
use super::Proof;
use crate::check::sampled::{Bound, Worst, causes, proved as worst_case};
use crate::diagnostic::{digits, digits_up};
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};
use crate::parameter::Parameter;
use crate::request::Spec;
use crate::syntax::number;

/// For each objective whether the worst case proves it, or refutes it, or why not.
pub(super) fn proved(campaign: &Campaign) -> Vec<Proof> {
    let worst = worst(campaign);
    let one = |objective: &Objective| match &worst {
        Err(why) => Proof::NotProved { why: why.clone() },
        Ok(worst) => match holds(campaign, worst, &objective.kind) {
            Ok(scope) => Proof::Proved { scope },
            Err(why) => {
                exceeded(campaign, worst, &objective.kind).unwrap_or(Proof::NotProved { why })
            }
        },
    };
    campaign.objectives.iter().map(one).collect()
}

/// What limits the loop that runs: the cause of most of its largest worst |x_i| at the deadline, in one
/// line; `None` where its worst case is not known.
pub fn limits(campaign: &Campaign) -> Option<String> {
    campaign.around.as_ref()?;
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

/// Whether signals that are allowed exceed an objective.
fn exceeded(campaign: &Campaign, worst: &Worst, kind: &Kind) -> Option<Proof> {
    // The worst signals begin at a corner of a box around 0, and are at a bound of what disturbs.
    let around_0 = campaign.x0.iter().all(|(low, high)| low + high == 0.0);
    let any = |legal: &[Signal]| legal.contains(&Signal::Worst);
    if !around_0 || !campaign.disturbances.iter().all(|(_, _, legal)| any(legal)) {
        return None;
    }
    let (reached, bound, what) = match kind {
        Kind::Attractive { error } => {
            let sizes = worst.reached.iter().enumerate();
            let (state, most) = sizes.max_by(|a, b| a.1.total_cmp(b.1))?;
            (*most, *error, format!("|x{}| at the deadline", state + 1))
        }
        // What is late may act after the end of the run.
        Kind::Input { upsilon } if campaign.around.as_ref()?.delay.inputs() == 0 => {
            (worst.way.as_ref()?.u_attained, constant(upsilon).ok()?, "|u|".to_owned())
        }
        Kind::Input { .. } | Kind::Inputs { .. } | Kind::State { .. } | Kind::Within { .. } => {
            return None;
        }
    };
    (reached > bound).then(|| Proof::Refuted {
        why: format!("the worst signals of the loop reach {what} = {}", digits(reached)),
        excess: over(reached, bound),
    })
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
    let radius = |(low, high): &Interval| exact(low.abs().max(high.abs()));
    spec.promises.x0_max = campaign.x0.iter().map(radius).collect::<Result<_, _>>()?;
    worst_case(&spec)
}

/// What of the run a proof of the objective is about, or why it is not proved.
fn holds(campaign: &Campaign, worst: &Worst, kind: &Kind) -> Result<String, String> {
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
    // The largest |x_i|, or |u|, from t0 to the end.
    let largest = |part: Part| -> Result<(f64, bool), String> {
        let (way, after) = (way()?, after()?);
        let of = |x: &[f64], u: f64| match part {
            Part::State(i) => x.get(i).copied().unwrap_or(f64::INFINITY),
            Part::Control => u,
        };
        let on_way = of(&way.x, way.u);
        let later = after.map_or(0.0, |after| of(&after.x, after.u));
        let between = way.between && after.is_none_or(|after| after.between);
        Ok((on_way.max(later), between || part == Part::Control))
    };
    match kind {
        Kind::Attractive { error } => {
            let at_deadline = size(worst.states.iter().map(Bound::total));
            let later = after()?.map_or(0.0, |after| size(after.x.iter().copied()));
            let most = at_deadline.max(later);
            let scope = match after()? {
                Some(after) => between(after.between),
                None => "the emitted program with its rounding, at the deadline",
            };
            within(most, *error, "|x|").map(|()| scope.to_owned())
        }
        Kind::Input { upsilon } => {
            let (most, of_all) = largest(Part::Control)?;
            within(most, constant(upsilon)?, "|u|").map(|()| between(of_all).to_owned())
        }
        Kind::Inputs { .. } => Err("the plant has several inputs".to_owned()),
        Kind::Within { h, low, high } => {
            let part = Part::of(h).ok_or("the worst case bounds x1..xn and u, and not h")?;
            let (most, of_all) = largest(part)?;
            if let Some(high) = high {
                within(most, constant(high)?, "h")?;
            }
            if let Some(low) = low {
                within(most, -constant(low)?, "-h")?;
            }
            Ok(between(of_all).to_owned())
        }
        Kind::State { .. } => {
            Err("the worst case is of the box of initial states, and the bound goes with x0"
                .to_owned())
        }
    }
}

/// What the worst case bounds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    State(usize),
    Control,
}

impl Part {
    fn of(h: &Expression) -> Option<Self> {
        match h.variable()? {
            Variable::State(j) => Some(Self::State(j - 1)),
            Variable::Control => Some(Self::Control),
            _ => None,
        }
    }
}

/// The Euclidean norm of what is bounded in each part, rounded up.
fn size(parts: impl Iterator<Item = f64>) -> f64 {
    let sum: f64 = parts.map(|x| x * x).sum();
    // Each of n <= 12 squares, sums and the root is off by at most 2^-53 of itself.
    sum.sqrt() * (1.0 + 1e-14)
}

fn constant(bound: &Expression) -> Result<f64, String> {
    let exact = normal(bound).number().cloned();
    exact
        .and_then(|value| num_traits::ToPrimitive::to_f64(&value))
        .ok_or_else(|| format!("its bound {bound} goes with time, and the worst case does not"))
}

fn within(most: f64, bound: f64, what: &str) -> Result<(), String> {
    match most < bound {
        true => Ok(()),
        false => {
            let (most, bound) = (digits_up(most), digits(bound));
            Err(format!("{what} may reach {most}, and its bound is {bound}"))
        }
    }
}
