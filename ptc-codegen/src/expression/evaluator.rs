//! Enclosures of an expression over intervals of its names, with a bound on the work.

use std::collections::BTreeMap;

use astro_float_num::Consts;

use super::enclosure::Interval;
use super::function::Domain;
use super::{Expression, Found, Function, Node};
use crate::limits::ENCLOSURE;

/// Cost of a function or a power, in such operations.
const COST_OF_CALL: usize = 32;

/// Evaluates expressions, until the work is used up.
pub(crate) struct Evaluator {
    cache: Option<Consts>,
    left: usize,
    existence: Existence,
    /// The values of the parts of an expression in which some may occur often.
    found: Option<Found<Interval>>,
}

/// For which of the arguments an expression has a value; the worst of its parts decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Existence {
    /// For all of them, within the range of doubles.
    Certain,
    /// Perhaps not where a divisor is 0 or a function has a pole, or where it leaves that range:
    /// there it may have a value by continuity only.
    ButAtPoles,
    /// Perhaps only for those within the domain of a function.
    Partly,
    /// For none.
    Never,
}

/// Enclosure and existence of the values of an expression.
pub(crate) struct Value {
    /// It holds every value that exists.
    pub(crate) interval: Interval,
    pub(crate) existence: Existence,
}

/// The intervals of names.
pub(crate) type Names = BTreeMap<Expression, Interval>;

impl Evaluator {
    pub(crate) fn new() -> Self {
        let existence = Existence::Certain;
        Self { cache: Consts::new().ok(), left: ENCLOSURE.size(), existence, found: None }
    }

    /// The same with all of the work left; the constants of its functions, which take long, are kept.
    pub(crate) fn again(&mut self) -> &mut Self {
        self.left = ENCLOSURE.size();
        self
    }

    /// A function of an interval.
    #[cfg(feature = "lab")]
    pub(crate) fn call(&mut self, function: Function, x: &Interval) -> Option<Interval> {
        Some(x.call(function, self.cache.as_mut()?))
    }

    /// x^exponent of a positive x.
    #[cfg(feature = "lab")]
    pub(crate) fn power(&mut self, x: &Interval, exponent: &Interval) -> Option<Interval> {
        Some(x.power(exponent, self.cache.as_mut()?))
    }

    /// The values of an expression that has one for every argument.
    #[cfg(feature = "lab")]
    pub(crate) fn sound(&mut self, expression: &Expression, names: &Names) -> Option<Interval> {
        let value = self.again().value(expression, names)?;
        (value.existence == Existence::Certain).then_some(value.interval)
    }

    /// Returns true if no work is left.
    pub(crate) fn is_spent(&self) -> bool {
        self.left == 0 || self.cache.is_none()
    }

    /// The values of an expression; none for an unknown name or where the work is used up.
    pub(crate) fn value(&mut self, expression: &Expression, names: &Names) -> Option<Value> {
        self.existence = Existence::Certain;
        self.found = (!expression.is_small()).then(Found::default);
        let interval = self.enclose(expression, names)?;
        Some(Value { interval, existence: self.existence })
    }

    fn note(&mut self, existence: Existence) {
        self.existence = self.existence.max(existence);
    }

    /// The values of an expression, of which every operation notes for which arguments it exists.
    fn enclose(&mut self, e: &Expression, names: &Names) -> Option<Interval> {
        if let Some(known) = self.found.as_ref().and_then(|found| found.get(e)) {
            return Some(known.clone());
        }
        let cost =
            if matches!(e.node(), Node::Call(..) | Node::Power(..)) { COST_OF_CALL } else { 1 };
        let left = self.left.checked_sub(cost);
        self.left = left.unwrap_or(0);
        left?;
        let interval = match e.node() {
            Node::Number(number) => Interval::exact(number),
            Node::Pi => Interval::pi(self.cache.as_mut()?),
            Node::Parameter(_) | Node::Variable(_) => names.get(e)?.clone(),
            Node::Neg(a) => self.enclose(a, names)?.neg(),
            Node::Add(a, b) => self.enclose(a, names)?.plus(&self.enclose(b, names)?),
            Node::Sub(a, b) => self.enclose(a, names)?.minus(&self.enclose(b, names)?),
            Node::Mul(a, b) => self.enclose(a, names)?.times(&self.enclose(b, names)?),
            Node::Div(a, b) => {
                let under = self.enclose(b, names)?;
                if under.has_zero() {
                    self.note(Existence::ButAtPoles);
                }
                self.enclose(a, names)?.over(&under)
            }
            Node::Min(a, b) => self.enclose(a, names)?.least(&self.enclose(b, names)?),
            Node::Max(a, b) => self.enclose(a, names)?.most(&self.enclose(b, names)?),
            Node::Power(a, b) => self.raised(a, b, names)?,
            Node::Call(function, a) => {
                let inner = self.enclose(a, names)?;
                self.applied(*function, &inner)?
            }
        };
        if !interval.is_within_doubles() {
            self.note(Existence::ButAtPoles);
        }
        if let Some(found) = self.found.as_mut().filter(|_| e.height() > 0) {
            found.insert(e.clone(), interval.clone());
        }
        Some(interval)
    }

    fn raised(&mut self, a: &Expression, b: &Expression, names: &Names) -> Option<Interval> {
        let base = self.enclose(a, names)?;
        if let Some(k) = b.small_integer() {
            if k < 0 && base.has_zero() {
                self.note(Existence::ButAtPoles);
            }
            return Some(base.whole_power(k));
        }
        let exponent = self.enclose(b, names)?;
        self.note(if base.is_negative() {
            Existence::Never
        } else if !base.is_not_negative() {
            Existence::Partly
        } else if base.has_zero() && !exponent.is_positive() {
            Existence::ButAtPoles
        } else {
            Existence::Certain
        });
        if !base.is_not_negative() {
            return Some(Interval::WHOLE);
        }
        Some(base.power(&exponent, self.cache.as_mut()?))
    }

    fn applied(&mut self, function: Function, inner: &Interval) -> Option<Interval> {
        let domain = function.row().domain;
        let cache = self.cache.as_mut()?;
        let existence = match domain {
            Domain::OffPoles if inner.call(Function::Cos, cache).has_zero() => {
                Existence::ButAtPoles
            }
            domain => existence_within(inner, domain),
        };
        // Only its part within the domain has values.
        let there = inner.within(domain);
        let value = there.as_ref().unwrap_or(inner).call(function, cache);
        self.note(existence);
        Some(value)
    }
}

/// For which numbers of an interval a function has a value, by the ends of its domain.
fn existence_within(inner: &Interval, domain: Domain) -> Existence {
    let [low, high] = domain.edges();
    // How far the interval is inside of each end.
    let above = low.map(|edge| (inner.minus(&Interval::integer(edge.at)), edge.closed));
    let below = high.map(|edge| (Interval::integer(edge.at).minus(inner), edge.closed));
    let of_edge = |(room, closed): (Interval, bool)| {
        if room.is_negative() {
            Existence::Never
        } else if !room.is_not_negative() {
            Existence::Partly
        } else if !closed && room.has_zero() {
            Existence::ButAtPoles
        } else {
            Existence::Certain
        }
    };
    let found = [above, below].into_iter().flatten().map(of_edge);
    found.max().unwrap_or(Existence::Certain)
}
