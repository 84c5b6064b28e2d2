//! Sign of the derivative, which must be positive.

use num_traits::{Signed, Zero};

use super::Verdict;
use super::pieces::Wanted;
use super::problem::Problem;
use crate::algebra::{BigRational, integer};
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::Existence;
use crate::expression::leading::{scale, scale_at_zero};
use crate::expression::normal::normal;
use crate::expression::sign::Sign;
use crate::expression::{Expression, Function, Node};

impl Problem<'_> {
    pub(super) fn growth(&mut self) -> Verdict {
        let name = self.quantity();
        let start = if self.is_mu { integer(0) } else { integer(1) };
        let there = Expression::from(start.clone());
        let first = self.slope.substitute(&|e| (*e == self.v.into()).then(|| there.clone()));
        let kinks = |e: &Expression| matches!(e.node(), Node::Call(Function::Sign, _));
        if normal(&first) == Expression::integer(0) && !self.slope.any(&kinks) {
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
        if self.is_mu
            && let Some(piece) = self.left_open(&self.slope.clone(), &names, Wanted::Negative)
        {
            return self.open(piece, false);
        }
        let scaled = self.at_infinity();
        match self.left_open(&scaled, &names, Wanted::Negative) {
            None => Verdict::Proved,
            Some(piece) => self.open(piece, self.is_mu),
        }
    }

    /// The slope without the factor that takes it to 0 or infinity at the deadline, in 1/t for
    /// mu: what its sign is asked of on (0, 1], and close to 0.
    fn at_infinity(&self) -> Expression {
        let v = Expression::from(self.v);
        let find = if self.is_mu { scale } else { scale_at_zero };
        let known = self.positive.then(|| find(&self.slope, self.v)).flatten();
        let one = Expression::integer(1);
        let inverse = one.clone().div(v.clone());
        let scale = known.map_or(one, |scale| {
            let turned = if self.is_mu { v.clone() } else { inverse.clone() };
            let rate = Expression::call(Function::Exp, scale.rate().mul(turned.clone()));
            turned.power(scale.power()).mul(rate)
        });
        let scaled = normal(&self.slope.clone().div(scale));
        if !self.is_mu {
            return scaled;
        }
        normal(&scaled.substitute(&|e| (*e == v).then(|| inverse.clone())))
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
    pub(super) fn sampled(&mut self) -> Option<Verdict> {
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
            points.sort_unstable();
        } else {
            points.retain(Signed::is_positive);
            points.sort_unstable_by(|a, b| b.cmp(a));
        }
        let mut before: Option<(BigRational, Interval)> = None;
        for point in points {
            names.insert(self.v.into(), Interval::exact(&point));
            let at = format!("{}, {spelt}", self.at(&point));
            let slope = self.evaluator.value(&self.slope.clone(), &names)?;
            if slope.existence == Existence::Never {
                return Some(Verdict::Refuted { at, why: format!("{name} has no value") });
            }
            if slope.interval.is_not_negative() && slope.existence == Existence::Certain {
                return Some(Verdict::Refuted { at, why: format!("{name}' is not positive") });
            }
            let value = self.evaluator.value(&self.falling.clone(), &names)?.interval;
            if let Some((last, old)) = &before {
                // In the order of time, what is left of mu falls and kappa grows.
                let grown = value.minus(old);
                let back = if self.is_mu { grown.is_positive() } else { grown.is_negative() };
                if back {
                    let why = format!("{name} is less than at {}", self.at(last));
                    return Some(Verdict::Refuted { at, why });
                }
            }
            // A point on a pole decides nothing, and hides nothing from the next one.
            if value.is_bounded() {
                before = Some((point, value));
            }
        }
        None
    }
}
