//! The value at the start, the limit at the deadline, and smoothness between them.

use super::Verdict;
use super::pieces::{Wanted, left_open};
use super::problem::Problem;
use super::smooth::needs;
use crate::expression::evaluator::Existence;
use crate::expression::leading::{Limit, limit, limit_at_zero};
use crate::expression::normal::normal;
use crate::expression::sign::Sign;
use crate::expression::{Expression, Variable};
use crate::parameter::Parameter;

impl Problem<'_> {
    pub(super) fn start(&mut self) -> Verdict {
        let (subject, time) =
            if self.is_mu { (Variable::SinceStart, "t") } else { (Variable::Elapsed, "dt") };
        let there = |e: &Expression| (*e == subject.into()).then(|| Expression::integer(0));
        let value = normal(&self.given.substitute(&there));
        let at = format!("{time} = 0");
        let name = self.quantity();
        match self.sign(&value) {
            Some(Sign::Zero) => return Verdict::Proved,
            Some(Sign::Positive | Sign::Negative) => {
                return Verdict::Refuted {
                    at,
                    why: format!("{name}(0) = {value}, which is not 0"),
                };
            }
            _ => {}
        }
        let (names, spelt) = self.sample();
        match self.evaluator.value(&value, &names) {
            Some(found) if found.existence == Existence::Never => Verdict::Refuted {
                at: format!("{at}, {spelt}"),
                why: format!("{name} has no value"),
            },
            Some(found) if !found.interval.has_zero() => Verdict::Refuted {
                at: format!("{at}, {spelt}"),
                why: format!("{name}(0) = {value}, which is not 0"),
            },
            _ => {
                let why = format!("{name}(0) = {value} is not found to be 0");
                Verdict::Undecided { from: at.clone(), to: at, why }
            }
        }
    }

    pub(super) fn limit(&mut self) -> Verdict {
        let name = self.quantity();
        let (at, wanted) = if self.is_mu { ("t = inf", "tau") } else { ("dt = tau", "infinity") };
        let unknown = |why: String| Verdict::Undecided { from: at.into(), to: at.into(), why };
        if !self.positive {
            return unknown("limits are found for positive parameters only".to_owned());
        }
        let find = if self.is_mu { limit } else { limit_at_zero };
        let limit = find(&self.falling, self.v);
        let refuted = |tends: String, spelt: &str| Verdict::Refuted {
            at: if spelt.is_empty() { at.to_owned() } else { format!("{at}, {spelt}") },
            why: format!("{name} tends to {tends} in place of {wanted}"),
        };
        let short = match (limit, self.is_mu) {
            (None, _) => return unknown(format!("the limit of {name} is not found")),
            (Some(Limit::Infinite), false) => return Verdict::Proved,
            (Some(Limit::Infinite), true) => return refuted("-infinity".to_owned(), ""),
            (Some(Limit::MinusInfinite), is_mu) => {
                return refuted(if is_mu { "infinity" } else { "-infinity" }.to_owned(), "");
            }
            (Some(Limit::Finite(value)), false) => return refuted(value.to_string(), ""),
            (Some(Limit::Finite(short)), true) => short,
        };
        let tau = Expression::from(Parameter::Tau);
        let tends = || normal(&tau.sub(short.clone())).to_string();
        match self.sign(&short) {
            Some(Sign::Zero) => return Verdict::Proved,
            Some(Sign::Positive | Sign::Negative) => return refuted(tends(), ""),
            _ => {}
        }
        let (names, spelt) = self.sample();
        match self.evaluator.value(&short, &names) {
            Some(value) if !value.interval.has_zero() => refuted(tends(), &spelt),
            _ => unknown(format!("tau less the limit of {name} is {short}, not found to be 0")),
        }
    }

    pub(super) fn smoothness(&mut self) -> Verdict {
        // What was given may divide 0 by 0 where its normal form does not, and the other way round.
        let given_in = if self.is_mu { self.v } else { Variable::Elapsed };
        let mut verdict = Verdict::Proved;
        for (expression, v) in [(self.given.clone(), given_in), (self.falling.clone(), self.v)] {
            verdict = self.smoothness_of(&expression, v);
            if verdict == Verdict::Proved {
                break;
            }
        }
        verdict
    }

    fn smoothness_of(&mut self, expression: &Expression, v: Variable) -> Verdict {
        for need in needs(expression, v) {
            let known = match self.sign(&need.part) {
                Some(Sign::Positive) => true,
                Some(Sign::Negative) => !need.positive,
                _ => false,
            };
            if known {
                continue;
            }
            let why = format!("{}: not known to be of class C^{}", need.why, self.n);
            let Some(names) = self.bounds(&need.part) else { return self.undecided(why) };
            let wanted = if need.positive { Wanted::Positive } else { Wanted::NotZero };
            let inverse = Expression::integer(1).div(v.into());
            let turned = need.part.substitute(&|e| (*e == v.into()).then(|| inverse.clone()));
            let halves =
                if self.is_mu { vec![need.part, normal(&turned)] } else { vec![need.part] };
            for half in halves {
                let found = left_open(&half, v, &names, wanted, &mut self.evaluator);
                if found.is_some() {
                    return self.undecided(why);
                }
            }
        }
        Verdict::Proved
    }
}
