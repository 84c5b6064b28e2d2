//! Whether a mapping that the user wrote down is of class K or M.
//!
//! mu of class M: mu(0) = 0, mu' > 0, mu -> tau, n times continuously differentiable. kappa of
//! class K: kappa(0) = 0, kappa' > 0, kappa -> inf at tau, likewise. Both are asked of one function
//! that falls: tau - mu(t) for t >= 0, and kappa as a function of w = T/tau in (0, 1].
//!
//! Signs are found for all positive parameters at once where that is possible, else by intervals
//! for the values and bounds that are given. Only a validated number refutes.

mod enclosure;
mod pieces;
mod smooth;

use std::fmt;

use num_traits::{Signed, ToPrimitive, Zero};

use self::enclosure::{Evaluator, Names};
use self::pieces::{Wanted, on_unit_interval};
use self::smooth::needs;
use super::Outcome;
use crate::algebra::{BigRational, integer};
use crate::expression::interval::Interval;
use crate::expression::leading::{Leading, Limit, leading, leading_at_zero, limit, limit_at_zero};
use crate::expression::normal::{complement, normal};
use crate::expression::sign::{Sign, sign};
use crate::expression::{Expression, Function, Subject, Variable};
use crate::mapping::Custom;
use crate::spec::Parameter;

/// What is known of one condition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds.
    Proved,
    /// It fails.
    Refuted {
        /// Where, with the values of parameters for which it fails.
        at: String,
        /// In what way.
        why: String,
    },
    /// Neither is known.
    Undecided {
        /// Start of the part on which it is not known.
        from: String,
        /// End of that part.
        to: String,
        /// What stood in the way.
        why: String,
    },
}

/// What is known of a mapping.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Membership {
    /// The value is 0 at the start.
    pub start: Verdict,
    /// The derivative is positive.
    pub growth: Verdict,
    /// mu -> tau, kappa -> infinity.
    pub limit: Verdict,
    /// It is n times continuously differentiable.
    pub smoothness: Verdict,
}

impl Membership {
    /// The conditions in words, with what is known of each.
    pub fn conditions(&self) -> [(&'static str, &Verdict); 4] {
        [
            ("it is 0 at the start", &self.start),
            ("its derivative is positive", &self.growth),
            ("it has its limit", &self.limit),
            ("it is smooth", &self.smoothness),
        ]
    }

    /// The worst of the verdicts, and its condition in words.
    pub fn worst(&self) -> (&'static str, &Verdict) {
        let rank = |verdict: &Verdict| match verdict {
            Verdict::Refuted { .. } => 0,
            Verdict::Undecided { .. } => 1,
            Verdict::Proved => 2,
        };
        let all = self.conditions();
        all.into_iter().min_by_key(|(_, verdict)| rank(verdict)).unwrap_or(all[0])
    }
}

impl From<&Membership> for Outcome {
    fn from(membership: &Membership) -> Self {
        let (condition, worst) = membership.worst();
        let verdict = match worst {
            Verdict::Proved => super::Verdict::Sound,
            Verdict::Refuted { .. } => super::Verdict::Refuted,
            Verdict::Undecided { .. } => super::Verdict::Undecided,
        };
        let summary = match worst {
            Verdict::Proved => "the mapping is of its class, proved".to_owned(),
            Verdict::Refuted { at, why } => format!("{why}, at {at}"),
            Verdict::Undecided { .. } => format!("that {condition} is {worst}"),
        };
        let detail = |(condition, verdict): (&str, &Verdict)| format!("{condition}: {verdict}");
        let fix = match worst {
            Verdict::Proved => None,
            Verdict::Refuted { .. } => Some(
                "mu rises from 0 to tau on [0, inf), kappa from 0 to infinity on [0, tau), both smoothly".to_owned(),
            ),
            Verdict::Undecided { .. } => {
                Some("values or bounds of the parameters, such as a = [0.5, 2], may decide it".to_owned())
            }
        };
        Self {
            name: "membership",
            verdict,
            summary,
            details: membership.conditions().into_iter().map(detail).collect(),
            fix,
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Proved => f.write_str("proved"),
            Self::Refuted { at, why } => write!(f, "refuted at {at}: {why}"),
            Self::Undecided { from, to, why } => {
                write!(f, "undecided from {from} to {to}: {why}")
            }
        }
    }
}

/// Values of a parameter: one (both the same), or the least and the greatest; none for any
/// positive number.
pub type Ranges<'a> = &'a dyn Fn(Parameter) -> Option<(BigRational, BigRational)>;

/// What is known of `custom` as a mapping of a chain of order `n`. Every function that
/// expressions know is smooth or has a pole or a kink, so the order decides only what is said.
pub fn prove(custom: &Custom, n: usize, ranges: Ranges<'_>) -> Membership {
    let mut problem = Problem::new(custom, n, ranges);
    let start = problem.start();
    let mut growth = problem.growth();
    let limit = problem.limit();
    let smoothness = problem.smoothness();
    if growth == Verdict::Proved && smoothness != Verdict::Proved {
        // Where there is a pole the derivative may have its sign on both sides of it.
        growth = problem.sampled().unwrap_or(growth);
    }
    Membership { start, growth, limit, smoothness }
}

struct Problem<'a> {
    n: usize,
    ranges: Ranges<'a>,
    is_mu: bool,
    /// t, or T in place of w = T/tau.
    v: Variable,
    /// mu or kappa as it was given, in t or in dt/tau, with fixed values in place.
    given: Expression,
    /// What falls, in v.
    falling: Expression,
    /// Its derivative.
    slope: Expression,
    /// Whether every parameter is positive.
    positive: bool,
    evaluator: Evaluator,
}

impl<'a> Problem<'a> {
    fn new(custom: &Custom, n: usize, ranges: Ranges<'a>) -> Self {
        let is_mu = custom.subject == Subject::Mu;
        let tau = Expression::from(Parameter::Tau);
        let fixed = |e: &Expression| match e {
            Expression::Parameter(parameter) => {
                ranges(*parameter).filter(|(a, b)| a == b).map(|(a, _)| Expression::Number(a))
            }
            _ => None,
        };
        let parameters = custom.given.parameters();
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
    fn sign(&self, expression: &Expression) -> Option<Sign> {
        // w = W/(W + D), with W > 0 and D >= 0 for T and dt.
        let (to_go, elapsed) =
            (Expression::from(Variable::TimeToGo), Expression::from(Variable::Elapsed));
        let both = to_go.clone().add(elapsed.clone());
        let share = |part: &Expression| part.clone().div(both.clone());
        let scaled = expression.substitute(&|e| match e {
            Expression::Variable(Variable::TimeToGo) => Some(share(&to_go)),
            Expression::Variable(Variable::Elapsed) => Some(share(&elapsed)),
            _ => None,
        });
        sign(&scaled, &|name| match name {
            Expression::Parameter(parameter) => match (self.ranges)(*parameter) {
                None => Some(Sign::Positive),
                Some((low, _)) if low.is_positive() => Some(Sign::Positive),
                Some((low, _)) if low.is_zero() => Some(Sign::NotNegative),
                Some((_, high)) if high.is_negative() => Some(Sign::Negative),
                Some(_) => None,
            },
            Expression::Variable(Variable::TimeToGo) => Some(Sign::Positive),
            Expression::Variable(_) => Some(Sign::NotNegative),
            _ => None,
        })
    }

    fn quantity(&self) -> &'static str {
        if self.is_mu { "mu" } else { "kappa" }
    }

    /// A value of v in words.
    fn at(&self, v: &BigRational) -> String {
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

    fn undecided(&self, why: impl Into<String>) -> Verdict {
        let (from, to) = if self.is_mu { ("t = 0", "t = inf") } else { ("dt = 0", "dt = tau") };
        Verdict::Undecided { from: from.to_owned(), to: to.to_owned(), why: why.into() }
    }

    /// Values of all parameters at which a refutation may be found, and their spelling.
    fn sample(&self) -> (Names, String) {
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

    /// The ranges of all parameters in `expression`; none where one of them has no bounds.
    fn bounds(&self, expression: &Expression) -> Option<Names> {
        let range = |p: Parameter| {
            (self.ranges)(p).map(|(a, b)| (Expression::from(p), Interval::between(&a, Some(&b))))
        };
        expression.parameters().into_iter().map(range).collect()
    }

    fn start(&mut self) -> Verdict {
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
            Some(found) if found.is_undefined => Verdict::Refuted {
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

    fn growth(&mut self) -> Verdict {
        let name = self.quantity();
        let start = if self.is_mu { integer(0) } else { integer(1) };
        let there = Expression::Number(start.clone());
        let first = self.slope.substitute(&|e| (*e == self.v.into()).then(|| there.clone()));
        if normal(&first) == Expression::integer(0) {
            return Verdict::Refuted { at: self.at(&start), why: format!("{name}' is 0") };
        }
        match self.sign(&self.slope) {
            Some(Sign::Negative) => return Verdict::Proved,
            Some(Sign::Positive | Sign::NotNegative | Sign::Zero) => {
                return Verdict::Refuted {
                    at: "all times".to_owned(),
                    why: format!("{name} does not grow"),
                };
            }
            _ => {}
        }
        if let Some(refuted) = self.sampled() {
            return refuted;
        }
        let Some(names) = self.bounds(&self.slope) else {
            return self.undecided(format!(
                "the sign of {name}' depends on parameters without a value: fix them or give bounds"
            ));
        };
        if self.is_mu {
            if let Err(piece) = self.on_unit_interval(&self.slope.clone(), &names, Wanted::Negative)
            {
                return self.open(piece, false);
            }
        }
        let scaled = self.at_infinity();
        match self.on_unit_interval(&scaled, &names, Wanted::Negative) {
            Ok(()) => Verdict::Proved,
            Err(piece) => self.open(piece, self.is_mu),
        }
    }

    /// The slope without the factor that takes it to 0 or infinity at the deadline, in 1/t for
    /// mu: what its sign is asked of on (0, 1], and close to 0.
    fn at_infinity(&self) -> Expression {
        let v = Expression::from(self.v);
        let term = if self.positive { self.leading(&self.slope) } else { None };
        let one = Expression::integer(1);
        let inverse = one.clone().div(v.clone());
        let scale = term.map_or(one, |term| {
            let turned = if self.is_mu { v.clone() } else { inverse.clone() };
            let rate = Expression::call(Function::Exp, term.rate.mul(turned.clone()));
            turned.power(term.power).mul(rate)
        });
        let scaled = normal(&self.slope.clone().div(scale));
        if !self.is_mu {
            return scaled;
        }
        normal(&scaled.substitute(&|e| (*e == v).then(|| inverse.clone())))
    }

    fn leading(&self, expression: &Expression) -> Option<Leading> {
        if self.is_mu { leading(expression, self.v) } else { leading_at_zero(expression, self.v) }
    }

    fn on_unit_interval(
        &mut self,
        expression: &Expression,
        names: &Names,
        wanted: Wanted,
    ) -> Result<(), (BigRational, BigRational)> {
        on_unit_interval(expression, self.v, names, wanted, &mut self.evaluator)
    }

    /// The piece that is left open, in v or in 1/v.
    fn open(&self, (from, to): (BigRational, BigRational), inverse: bool) -> Verdict {
        let back = |v: BigRational| match inverse {
            true if v.is_zero() => "t = inf".to_owned(),
            true => self.at(&v.recip()),
            false => self.at(&v),
        };
        // 1/t and w fall as time passes.
        let turned = inverse || !self.is_mu;
        let (from, to) = if turned { (to, from) } else { (from, to) };
        let why = if self.evaluator.is_spent() {
            "the work allowed for a proof is used up".to_owned()
        } else {
            "an enclosure of the derivative holds 0 on the smallest piece".to_owned()
        };
        Verdict::Undecided { from: back(from), to: back(to), why }
    }

    /// A refutation of growth at one of many points, for one set of parameters.
    fn sampled(&mut self) -> Option<Verdict> {
        let (mut names, spelt) = self.sample();
        let name = self.quantity();
        let part = |i: i64| integer(i) / integer(16);
        let mut points: Vec<_> = (0..=64)
            .map(|i| if self.is_mu { part(4 * i) } else { part(1) * part(4 * (64 - i)) })
            .collect();
        for k in 5..12 {
            let power = integer(1 << k);
            points.push(if self.is_mu { power } else { power.recip() });
        }
        if self.is_mu {
            points.sort();
        } else {
            points.retain(Signed::is_positive);
            points.sort_by(|a, b| b.cmp(a));
        }
        let mut before: Option<(BigRational, Interval)> = None;
        for point in points {
            names.insert(self.v.into(), Interval::exact(&point));
            let at = format!("{}, {spelt}", self.at(&point));
            let slope = self.evaluator.value(&self.slope.clone(), &names)?;
            if slope.is_undefined {
                return Some(Verdict::Refuted { at, why: format!("{name} has no value") });
            }
            if slope.interval.is_not_negative() {
                return Some(Verdict::Refuted { at, why: format!("{name}' is not positive") });
            }
            let value = self.evaluator.value(&self.falling.clone(), &names)?.interval;
            // As time passes tau - mu falls, and kappa rises.
            let risen = before.as_ref().map(|(_, old)| value.plus(&old.neg()));
            let wrong = |risen: &Interval| {
                if self.is_mu { risen.is_positive() } else { risen.is_negative() }
            };
            if let Some((last, _)) = &before
                && risen.as_ref().is_some_and(wrong)
            {
                let why = format!("{name} is less than at {}", self.at(last));
                return Some(Verdict::Refuted { at, why });
            }
            before = Some((point, value));
        }
        None
    }

    fn limit(&mut self) -> Verdict {
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

    fn smoothness(&mut self) -> Verdict {
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
                let found = on_unit_interval(&half, v, &names, wanted, &mut self.evaluator);
                if found.is_err() {
                    return self.undecided(why);
                }
            }
        }
        Verdict::Proved
    }
}

#[cfg(test)]
mod tests;
