//! The promise of a filter: from which limits of u on no bound has to give way.

use num_traits::{Signed, ToPrimitive, Zero};

use super::{Outcome, Verdict, bounds, sampled};
use crate::algebra::{BigRational, integer};
use crate::diagnostic::{digits_down, digits_up};
use crate::internal::fault;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Edge, Keep, Spec, product_of_rates};

/// Whatever a bound has to leave to those before it.
enum Need {
    /// So much of it, in units of the state or of g u.
    Of(BigRational),
    /// A bound of another state, from 0, on this side: without it nothing limits the need.
    Bound(usize, Edge),
}

/// A bound that may have to give way.
struct Gap {
    /// The state, from 0, or n for u.
    of: usize,
    edge: Edge,
    need: Need,
}

/// The outcome of the check of the loop, for a filter.
pub(super) fn outcome(spec: &Spec, keep: &Keep) -> Outcome {
    if let Some(open) = spec.run_time_parameters().next() {
        let reason = format!("`{}` is left to run time", open.spelling());
        return Outcome::not_checked(sampled::NAME, reason);
    }
    let rates = keep.rates(spec.period_of_filter());
    let gaps = gaps(spec, keep, &rates);
    let (verdict, summary) = match gaps.first() {
        None => (
            Verdict::Sound,
            "from every safe state the bounds are kept at and between all samples, and no limit is in the way".to_owned(),
        ),
        Some(gap) => (Verdict::Undecided, gap.summary(spec)),
    };
    Outcome {
        name: sampled::NAME,
        verdict,
        summary,
        details: vec![beyond(spec, keep, &rates)],
        fix: gaps.first().map(|gap| gap.fix(spec)),
    }
}

/// Describes the effect of a force that the filter does not know.
fn beyond(spec: &Spec, keep: &Keep, rates: &[BigRational]) -> String {
    let gain = spec.known_gain().map_or(1.0, |gain| double(&gain.abs()));
    let bounded: Vec<_> = (0..spec.n).filter(|i| keep.is_bounded(*i)).collect();
    let each = bounded.iter().map(|i| {
        let product = rates[*i..].iter().fold(1.0, |product, rate| product * double(rate));
        gain / product
    });
    let names: Vec<_> = bounded.iter().map(|i| format!("x{}", i + 1)).collect();
    format!(
        "an unknown force of 1 in the unit of u moves {} beyond a bound by at most {}",
        names.join(", "),
        bounds(each)
    )
}

/// The bounds that may have to give way, those of u last.
fn gaps(spec: &Spec, keep: &Keep, rates: &[BigRational]) -> Vec<Gap> {
    let mut gaps = Vec::new();
    for of in 1..=spec.n {
        for edge in [Edge::Above, Edge::Below] {
            let known = if of < spec.n { keep.bound(of, edge).cloned() } else { limit(spec, edge) };
            let Some(known) = known else { continue };
            let room = if edge == Edge::Above { -known } else { known };
            let need = need(spec, keep, rates, of, edge);
            let met = matches!(&need, Need::Of(need) if *need <= room);
            if !met {
                gaps.push(Gap { of, edge, need });
            }
        }
    }
    gaps
}

/// The part of a bound of state `of`, from 0, or of u, that the bounds of the states before it take at most.
///
/// With x_i kept, q = (Delta + a_i) ... (Delta + a_{j-1}) z_i exceeds z_j by members of its cone and by
/// sum_k e_k(a_i, ..., a_{j-2}) z_{j-k}, k < j - i. A safe state may be beyond its bounds by their tolerance, where u is
/// held to the bound of x_i itself: that takes a_i ... a_{j-1} times its tolerance more of another state.
fn need(spec: &Spec, keep: &Keep, rates: &[BigRational], of: usize, edge: Edge) -> Need {
    let beyond = |state: usize| keep.tolerance(state, spec.precision);
    let is_state = of < spec.n;
    let mut most = integer(0);
    for i in (0..of).filter(|i| keep.bound(*i, edge.other()).is_some()) {
        let factors = product_of_rates(&rates[i..of - 1]);
        let mut sum = match is_state {
            true => rates[i..of].iter().fold(beyond(i), |product, rate| product * rate),
            false => BigRational::zero(),
        };
        for (k, factor) in factors.iter().enumerate().skip(1).take(of - 1 - i) {
            let Some(bound) = keep.bound(of - k, edge.other()) else {
                return Need::Bound(of - k, edge.other());
            };
            sum += factor * (bound.abs() + beyond(of - k));
        }
        most = most.max(sum);
    }
    let own = if is_state { beyond(of) } else { BigRational::zero() };
    Need::Of((most - own).max(BigRational::zero()))
}

/// The limit of g u + f; `None` for an infinite one.
fn limit(spec: &Spec, edge: Edge) -> Option<BigRational> {
    let gain = spec.known_gain()?;
    let own = if gain.is_negative() { edge.other() } else { edge };
    let fixed = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number).cloned();
    let limit = match (own, spec.u_min) {
        (Edge::Below, _) => fixed(Parameter::UMax)?,
        (Edge::Above, true) => fixed(Parameter::UMin)?,
        (Edge::Above, false) => -fixed(Parameter::UMax)?,
    };
    Some(limit * gain + force(spec))
}

impl Gap {
    /// The input that would do, where it is one of u: rounded to what is printed, away from 0.
    fn input(&self, spec: &Spec) -> Option<String> {
        let Need::Of(need) = &self.need else { return None };
        let signed = if self.edge == Edge::Above { -need.clone() } else { need.clone() };
        let input = double(&((signed - force(spec)) / spec.known_gain()?));
        Some(if input < 0.0 { digits_down(input) } else { digits_up(input) })
    }

    fn summary(&self, spec: &Spec) -> String {
        let what = if self.of == spec.n { "u".to_owned() } else { format!("x{}", self.of + 1) };
        let side = if self.edge == Edge::Above { "lower" } else { "upper" };
        match &self.need {
            Need::Bound(i, edge) => {
                let other = if *edge == Edge::Above { "lower" } else { "upper" };
                format!(
                    "without {} {other} bound of x{} the {side} limit of {what} may not be enough",
                    if *edge == Edge::Above { "a" } else { "an" },
                    i + 1
                )
            }
            Need::Of(need) => match self.input(spec).filter(|_| self.of == spec.n) {
                Some(input) => {
                    format!("the bounds may need u = {input}, beyond its limits")
                }
                None => format!(
                    "the {side} bound of {what} may give way to those before it, which need {}",
                    digits_up(double(need))
                ),
            },
        }
    }

    fn fix(&self, spec: &Spec) -> String {
        let key = if self.edge == Edge::Above { "keep_above" } else { "keep_below" };
        match &self.need {
            Need::Bound(i, edge) => {
                let key = if *edge == Edge::Above { "keep_above" } else { "keep_below" };
                format!("give `{key}` a number for x{}", i + 1)
            }
            Need::Of(need) => match self.input(spec).filter(|_| self.of == spec.n) {
                Some(input) => format!(
                    "allow u = {input}, lower the bounds of x2..xn, or take slower `keep_poles`"
                ),
                None => {
                    let need = double(need);
                    let room = match self.edge {
                        Edge::Above => digits_down(-need),
                        Edge::Below => digits_up(need),
                    };
                    format!(
                        "give `{key}` of x{} at least the size of {}, lower the bounds before it, or take slower `keep_poles`",
                        self.of + 1,
                        room
                    )
                }
            },
        }
    }
}

/// The known force f, which the reader of a filter demands.
fn force(spec: &Spec) -> BigRational {
    spec.known_force().unwrap_or_else(|| fault("a filter without a known f"))
}

fn double(number: &BigRational) -> f64 {
    number.to_f64().unwrap_or(f64::NAN)
}
