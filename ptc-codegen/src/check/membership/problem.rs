//! The one question behind both classes, and what is known of its parameters.

use num_traits::{Signed, ToPrimitive, Zero};

use super::pieces::{Range, Wanted, left_open};
use super::{Ranges, Verdict};
use crate::algebra::{BigRational, integer};
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::{Evaluator, Names};
use crate::expression::normal::{complement, normal};
use crate::expression::sign::{Sign, sign};
use crate::expression::{Expression, Node, Subject, Variable};
use crate::mapping::Custom;
use crate::parameter::Parameter;

/// A mapping, its parameters and the work that is left for a proof.
pub(super) struct Problem<'a> {
    pub(super) n: usize,
    pub(super) ranges: Ranges<'a>,
    pub(super) is_mu: bool,
    /// t, or T in place of w = T/tau.
    pub(super) v: Variable,
    /// mu or kappa as it was given, in t or in dt/tau, with fixed values in place.
    pub(super) given: Expression,
    /// Decreasing function, in v.
    pub(super) falling: Expression,
    /// Its derivative.
    pub(super) slope: Expression,
    /// True if every parameter is positive.
    pub(super) positive: bool,
    pub(super) evaluator: Evaluator,
}

impl<'a> Problem<'a> {
    pub(super) fn new(custom: &Custom, n: usize, ranges: Ranges<'a>) -> Self {
        let is_mu = custom.subject == Subject::Mu;
        let tau = Expression::from(Parameter::Tau);
        let fixed = |e: &Expression| {
            ranges(e.parameter()?).filter(|(a, b)| a == b).map(|(a, _)| Expression::from(a))
        };
        let parameters = &custom.parameters;
        let positive =
            parameters.iter().all(|p| ranges(*p).is_none_or(|(low, _)| low.is_positive()));
        let w = Variable::TimeToGo;
        let (v, given, falling) = if is_mu {
            let limited =
                if positive { complement(&custom.given) } else { tau.sub(custom.given.clone()) };
            (Variable::SinceStart, custom.given.clone(), limited)
        } else {
            // dt = tau s in what was given, T = tau w in what falls: tau cancels where time is
            // only scaled by it.
            let scaled = |by: Expression| {
                let time = tau.clone().mul(by);
                custom.given.substitute(&|e| (*e == Variable::Elapsed.into()).then(|| time.clone()))
            };
            let to_go = Expression::integer(1).sub(w.into());
            (w, normal(&scaled(Variable::Elapsed.into())), normal(&scaled(to_go)))
        };
        let (given, falling) = (given.substitute(&fixed), normal(&falling.substitute(&fixed)));
        // A positive factor tau changes no sign.
        let mut slope = falling.derivative(v);
        let by_tau = normal(&slope.clone().div(Parameter::Tau.into()));
        let has_tau = |e: &Expression| e.parameters().contains(&Parameter::Tau);
        slope = if has_tau(&by_tau) { normal(&slope) } else { by_tau };
        let evaluator = Evaluator::new();
        Self { n, ranges, is_mu, v, given, falling, slope, positive, evaluator }
    }

    /// The sign for all values of the parameters and of time.
    pub(super) fn sign(&self, expression: &Expression) -> Option<Sign> {
        // w = W/(W + D), with W > 0 and D >= 0 for T and dt.
        let (to_go, elapsed) =
            (Expression::from(Variable::TimeToGo), Expression::from(Variable::Elapsed));
        let both = to_go.clone().add(elapsed.clone());
        let share = |part: &Expression| part.clone().div(both.clone());
        let scaled = expression.substitute(&|e| match e.node() {
            Node::Variable(Variable::TimeToGo) => Some(share(&to_go)),
            Node::Variable(Variable::Elapsed) => Some(share(&elapsed)),
            _ => None,
        });
        sign(&scaled, &|name| match name.node() {
            Node::Parameter(parameter) => match (self.ranges)(*parameter) {
                None => Some(Sign::Positive),
                Some((low, _)) if low.is_positive() => Some(Sign::Positive),
                Some((low, _)) if low.is_zero() => Some(Sign::NotNegative),
                Some((_, high)) if high.is_negative() => Some(Sign::Negative),
                Some(_) => None,
            },
            Node::Variable(Variable::TimeToGo) => Some(Sign::Positive),
            Node::Variable(_) => Some(Sign::NotNegative),
            _ => None,
        })
    }

    pub(super) fn quantity(&self) -> &'static str {
        if self.is_mu { "mu" } else { "kappa" }
    }

    /// A value of v in words.
    pub(super) fn at(&self, v: &BigRational) -> String {
        let shown = |v: &BigRational| format!("{}", v.to_f64().unwrap_or(f64::NAN));
        if self.is_mu {
            format!("t = {}", shown(v))
        } else {
            match integer(1) - v {
                start if start.is_zero() => "dt = 0".to_owned(),
                share => format!("dt = {}*tau", shown(&share)),
            }
        }
    }

    pub(super) fn undecided(&self, why: impl Into<String>) -> Verdict {
        let (from, to) = if self.is_mu { ("t = 0", "t = inf") } else { ("dt = 0", "dt = tau") };
        Verdict::Undecided { from: from.to_owned(), to: to.to_owned(), why: why.into() }
    }

    /// Values of all parameters at which a refutation may be found, and their spelling.
    pub(super) fn sample(&self) -> (Names, String) {
        let mut names = Names::new();
        let mut spelt = Vec::new();
        let mut parameters = self.given.parameters();
        parameters.insert(Parameter::Tau);
        parameters.extend(self.slope.parameters());
        parameters.extend(self.falling.parameters());
        for (index, parameter) in (0i64..).zip(parameters) {
            let value = match (self.ranges)(parameter) {
                Some((low, high)) => (low + high) / integer(2),
                // All different, so that no two of them cancel by chance.
                None => integer(1) + integer(index) / integer(8),
            };
            let shown = value.to_f64().unwrap_or(f64::NAN);
            spelt.push(format!("{} = {shown}", parameter.spelling()));
            names.insert(parameter.into(), Interval::exact(&value));
        }
        (names, spelt.join(", "))
    }

    /// The ranges of all parameters in `expression`; `None` if one of them has no bounds.
    pub(super) fn bounds(&self, expression: &Expression) -> Option<Vec<Range>> {
        let range = |p: Parameter| (self.ranges)(p).map(|(a, b)| (Expression::from(p), a, b));
        expression.parameters().into_iter().map(range).collect()
    }

    pub(super) fn left_open(
        &mut self,
        expression: &Expression,
        parameters: &[Range],
        wanted: Wanted,
    ) -> Option<(BigRational, BigRational)> {
        left_open(expression, self.v, parameters, wanted, &mut self.evaluator)
    }
}
