//! The leading term of an expression as its variable grows, under positive parameters, and what
//! it decides: limits, and the rate at which a mapping approaches the deadline.

use std::cell::Cell;
use std::cmp::Ordering;

use super::effort::{bounded, spend};
use super::normal::normal;
use super::sign::{Sign, positive_parameters, sign};
use super::{Expression, Function, Variable};

/// Most steps of one search.
const MAX_STEPS: usize = 2000;

/// `coefficient * v^power * (ln v)^log * e^(rate v)`; only a bound of that size if not `exact`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Leading {
    pub(crate) coefficient: Expression,
    exact: bool,
    /// 1 if it grows faster than every e^(rate v), -1 if it falls so.
    fast: i32,
    pub(crate) rate: Expression,
    pub(crate) power: Expression,
    pub(crate) log: i32,
}

/// The limit of an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Limit {
    /// It grows without bound.
    Infinite,
    /// It falls without bound.
    MinusInfinite,
    /// An expression in parameters.
    Finite(Expression),
}

/// How an expression in positive parameters compares with 0.
pub(crate) fn ordering(expression: &Expression) -> Option<Ordering> {
    match sign(expression, &positive_parameters)? {
        Sign::Positive => Some(Ordering::Greater),
        Sign::Negative => Some(Ordering::Less),
        Sign::Zero => Some(Ordering::Equal),
        Sign::NotNegative | Sign::NotPositive => None,
    }
}

fn zero() -> Expression {
    Expression::integer(0)
}

impl Leading {
    fn constant(coefficient: Expression) -> Self {
        let rate = zero();
        Self { coefficient, exact: true, fast: 0, power: rate.clone(), rate, log: 0 }
    }

    fn is_zero(&self) -> bool {
        self.coefficient == zero()
    }

    /// Whether it grows, stays or vanishes.
    fn tends(&self) -> Option<Ordering> {
        let orders = [self.fast.cmp(&0), ordering(&self.rate)?, ordering(&self.power)?];
        let first = orders.into_iter().find(|o| o.is_ne());
        Some(first.unwrap_or(self.log.cmp(&0)))
    }

    fn times(self, other: Self) -> Option<Self> {
        if self.fast * other.fast < 0 {
            return None;
        }
        Some(Self {
            coefficient: normal(&self.coefficient.mul(other.coefficient)),
            exact: self.exact && other.exact,
            fast: (self.fast + other.fast).signum(),
            rate: normal(&self.rate.add(other.rate)),
            power: normal(&self.power.add(other.power)),
            log: self.log + other.log,
        })
    }

    fn raised(self, exponent: &Expression) -> Option<Self> {
        let whole = exponent.small_integer();
        let positive = ordering(&self.coefficient) == Some(Ordering::Greater);
        let known = self.exact || whole.is_some_and(|k| k > 0);
        if !known || self.is_zero() || (whole.is_none() && (self.log != 0 || !positive)) {
            return None;
        }
        let turn = match ordering(exponent)? {
            Ordering::Less => -1,
            Ordering::Equal => 0,
            Ordering::Greater => 1,
        };
        Some(Self {
            coefficient: normal(&self.coefficient.power(exponent.clone())),
            exact: self.exact,
            fast: self.fast * turn,
            rate: normal(&self.rate.mul(exponent.clone())),
            power: normal(&self.power.mul(exponent.clone())),
            log: self.log.checked_mul(whole.unwrap_or(0))?,
        })
    }

    fn compare(&self, other: &Self) -> Option<Ordering> {
        let difference = |a: &Expression, b: &Expression| ordering(&a.clone().sub(b.clone()));
        let mut order = self.fast.cmp(&other.fast);
        if self.fast != 0 && order.is_eq() {
            return None;
        }
        for (a, b) in [(&self.rate, &other.rate), (&self.power, &other.power)] {
            if order.is_eq() {
                order = difference(a, b)?;
            }
        }
        Some(order.then(self.log.cmp(&other.log)))
    }

    fn plus(self, other: Self) -> Option<Self> {
        if self.is_zero() || other.is_zero() {
            return Some(if self.is_zero() { other } else { self });
        }
        match self.compare(&other)? {
            Ordering::Greater => Some(self),
            Ordering::Less => Some(other),
            Ordering::Equal if self.exact && other.exact => {
                let coefficient = normal(&self.coefficient.clone().add(other.coefficient));
                // Where leading terms cancel, what is left is unknown.
                let left = ordering(&coefficient).is_none_or(Ordering::is_ne);
                left.then_some(Self { coefficient, ..self })
            }
            Ordering::Equal => {
                Some(Self { coefficient: Expression::integer(1), exact: false, ..self })
            }
        }
    }

    fn limit(&self) -> Option<Limit> {
        Some(match self.tends()? {
            Ordering::Less => Limit::Finite(zero()),
            Ordering::Equal if self.exact => Limit::Finite(self.coefficient.clone()),
            Ordering::Greater if self.exact => match ordering(&self.coefficient)? {
                Ordering::Greater => Limit::Infinite,
                Ordering::Less => Limit::MinusInfinite,
                Ordering::Equal => return None,
            },
            _ => return None,
        })
    }
}

/// The limit of an expression as `v` grows without bound.
pub(crate) fn limit(expression: &Expression, v: Variable) -> Option<Limit> {
    bounded(|| limit_of(expression, v))
}

fn limit_of(expression: &Expression, v: Variable) -> Option<Limit> {
    if let Some(found) = leading(expression, v) {
        return found.limit();
    }
    // Terms that cannot be compared before the parameters are known still have limits.
    use Limit::{Finite, Infinite, MinusInfinite};
    match expression {
        Expression::Neg(a) => Some(negative(limit(a, v)?)),
        Expression::Add(a, b) | Expression::Sub(a, b) => {
            let first = limit(a, v)?;
            let second = limit(b, v)?;
            let second = match expression {
                Expression::Sub(..) => negative(second),
                _ => second,
            };
            match (first, second) {
                (Finite(a), Finite(b)) => Some(Finite(normal(&a.add(b)))),
                (Infinite, Finite(_) | Infinite) | (Finite(_), Infinite) => Some(Infinite),
                (MinusInfinite, Finite(_) | MinusInfinite) | (Finite(_), MinusInfinite) => {
                    Some(MinusInfinite)
                }
                _ => None,
            }
        }
        Expression::Mul(a, b) => match (limit(a, v)?, limit(b, v)?) {
            (Finite(a), Finite(b)) => Some(Finite(normal(&a.mul(b)))),
            (Finite(factor), grown) | (grown, Finite(factor)) => match ordering(&factor)? {
                Ordering::Greater => Some(grown),
                Ordering::Less => Some(negative(grown)),
                Ordering::Equal => None,
            },
            _ => None,
        },
        Expression::Div(a, b) if !b.contains(v) => {
            limit(&(**a).clone().mul(Expression::integer(1).div((**b).clone())), v)
        }
        _ => None,
    }
}

fn negative(limit: Limit) -> Limit {
    match limit {
        Limit::Infinite => Limit::MinusInfinite,
        Limit::MinusInfinite => Limit::Infinite,
        Limit::Finite(value) => Limit::Finite(normal(&value.neg())),
    }
}

/// The limit of an expression as `to_go` falls to 0.
pub(crate) fn limit_at_zero(expression: &Expression, to_go: Variable) -> Option<Limit> {
    let turned = inverted(expression, to_go);
    limit(&normal(&turned), to_go).or_else(|| limit(&turned, to_go))
}

/// The expression in 1/to_go.
fn inverted(expression: &Expression, to_go: Variable) -> Expression {
    let inverse = Expression::integer(1).div(to_go.into());
    expression.substitute(&|e| (*e == to_go.into()).then(|| inverse.clone()))
}

/// The decay rate of what falls to 0 as `v` grows: -lim (ln f')'.
pub(crate) fn decay_rate(falling: &Expression, v: Variable) -> Option<Expression> {
    bounded(|| decay_rate_of(falling, v))
}

fn decay_rate_of(falling: &Expression, v: Variable) -> Option<Expression> {
    if let Some(term) = leading(falling, v) {
        let known = term.exact && ordering(&term.coefficient)?.is_ne();
        let falls = known && term.fast == 0 && term.tends()?.is_lt();
        return falls.then(|| normal(&term.rate.neg()));
    }
    // Of terms that cannot be compared before the parameters are known, the slower one decides.
    match falling {
        Expression::Neg(a) => decay_rate(a, v),
        Expression::Mul(a, b) | Expression::Div(a, b) => {
            let (changed, other) = if a.contains(v) { (a, b) } else { (b, a) };
            let plain = !other.contains(v) && matches!(falling, Expression::Mul(..));
            (plain || changed == a && !other.contains(v)).then(|| decay_rate(changed, v))?
        }
        Expression::Add(a, b) => {
            // Of one sign, so that they cannot cancel.
            let signs = [leading_sign(a, v)?, leading_sign(b, v)?];
            let (a, b) = (decay_rate(a, v)?, decay_rate(b, v)?);
            (signs[0] == signs[1]).then(|| Expression::Min(Box::new(a), Box::new(b)))
        }
        _ => None,
    }
}

fn leading_sign(expression: &Expression, v: Variable) -> Option<bool> {
    match leading(expression, v) {
        Some(term) => Some(ordering(&term.coefficient).filter(|o| o.is_ne())?.is_gt()),
        None => match expression {
            Expression::Add(a, b) => {
                let first = leading_sign(a, v)?;
                (first == leading_sign(b, v)?).then_some(first)
            }
            _ => None,
        },
    }
}

/// The leading term as `to_go` falls to 0, in the variable 1/to_go.
pub(crate) fn leading_at_zero(expression: &Expression, to_go: Variable) -> Option<Leading> {
    let turned = inverted(expression, to_go);
    leading(&normal(&turned), to_go).or_else(|| leading(&turned, to_go))
}

/// The decay rate of the inverse of what grows without bound as `to_go` falls to 0: with kappa
/// = -c ln T, T falls as e^(-t/c); with a power of T as a power of t.
pub(crate) fn decay_rate_of_inverse(kappa: &Expression, to_go: Variable) -> Option<Expression> {
    let term = leading_at_zero(kappa, to_go)?;
    let grows = term.exact && term.fast == 0 && term.tends()?.is_gt();
    if !grows || ordering(&term.coefficient)?.is_le() || ordering(&term.rate)?.is_ne() {
        return None;
    }
    match (ordering(&term.power)?, term.log) {
        (Ordering::Greater, _) => Some(zero()),
        (Ordering::Equal, 1) => Some(normal(&Expression::integer(1).div(term.coefficient))),
        (Ordering::Equal, log) if log > 1 => Some(zero()),
        _ => None,
    }
}

/// The leading term as `v` grows without bound; none where it is not found.
pub(crate) fn leading(expression: &Expression, v: Variable) -> Option<Leading> {
    bounded(|| term(expression, Walk { v, left: &Cell::new(MAX_STEPS) }))
}

/// The variable, and how many steps are left: exponentials are looked at more than once.
#[derive(Clone, Copy)]
struct Walk<'a> {
    v: Variable,
    left: &'a Cell<usize>,
}

fn term(expression: &Expression, walk: Walk<'_>) -> Option<Leading> {
    use Expression as E;
    let v = walk.v;
    walk.left.set(walk.left.get().checked_sub(1)?);
    spend(expression.size())?;
    if !expression.contains(v) {
        return Some(Leading::constant(normal(expression)));
    }
    match expression {
        E::Number(_) | E::Pi | E::Parameter(_) => None,
        E::Variable(_) => Some(Leading {
            power: Expression::integer(1),
            ..Leading::constant(Expression::integer(1))
        }),
        E::Neg(a) => term(a, walk)?.times(Leading::constant(Expression::integer(-1))),
        E::Add(a, b) => term(a, walk)?.plus(term(b, walk)?),
        E::Sub(a, b) => term(a, walk)?.plus(term(&(**b).clone().neg(), walk)?),
        E::Mul(a, b) => term(a, walk)?.times(term(b, walk)?),
        E::Div(a, b) => term(a, walk)?.times(term(b, walk)?.raised(&Expression::integer(-1))?),
        E::Power(a, b) if !b.contains(v) => term(a, walk)?.raised(b),
        E::Power(a, b) => {
            exponential((**b).clone().mul(E::call(Function::Ln, (**a).clone())), walk)
        }
        E::Min(a, b) | E::Max(a, b) => {
            let difference = term(&(**a).clone().sub((**b).clone()), walk)?;
            let greater = difference.exact && ordering(&difference.coefficient)?.is_gt();
            let first = greater == matches!(expression, E::Max(..));
            term(if first { a } else { b }, walk).filter(|_| difference.exact)
        }
        E::Call(Function::Exp, a) => exponential((**a).clone(), walk),
        E::Call(Function::Ln, a) => logarithm(a, walk),
        E::Call(Function::Sqrt, a) => {
            term(a, walk)?.raised(&Expression::integer(1).div(Expression::integer(2)))
        }
        E::Call(function, a) => call(*function, a, walk),
    }
}

/// e^u: what u has in v, in ln v and as a constant decides the rate, the power and the factor.
fn exponential(argument: Expression, walk: Walk<'_>) -> Option<Leading> {
    let mut rest = normal(&argument);
    let mut result = Leading::constant(Expression::integer(1));
    for _ in 0..4 {
        let found = term(&rest, walk)?;
        let tends = if found.is_zero() { Ordering::Less } else { found.tends()? };
        if tends.is_gt() && !found.exact {
            return None;
        }
        let c = found.coefficient.clone();
        let part = match (tends, found.power.small_integer(), found.log) {
            (Ordering::Less, ..) => return Some(result),
            (Ordering::Equal, ..) => {
                if !found.exact {
                    result.exact = false;
                    return Some(result);
                }
                result.coefficient =
                    normal(&result.coefficient.mul(Expression::call(Function::Exp, c)));
                return Some(result);
            }
            _ if found.fast != 0 || found.rate != zero() => return fast(&c),
            (_, Some(1), 0) => {
                result.rate = normal(&result.rate.add(c.clone()));
                c.mul(walk.v.into())
            }
            (_, Some(0), 1) => {
                result.power = normal(&result.power.add(c.clone()));
                c.mul(Expression::call(Function::Ln, walk.v.into()))
            }
            _ if ordering(&found.power.clone().sub(Expression::integer(1)))?.is_ge() => {
                return fast(&c);
            }
            _ => return None,
        };
        rest = normal(&rest.sub(part));
    }
    None
}

fn fast(coefficient: &Expression) -> Option<Leading> {
    let fast = if ordering(coefficient)?.is_gt() { 1 } else { -1 };
    Some(Leading { fast, ..Leading::constant(Expression::integer(1)) })
}

fn logarithm(argument: &Expression, walk: Walk<'_>) -> Option<Leading> {
    let found = term(argument, walk)?;
    if !found.exact || found.fast != 0 || !ordering(&found.coefficient)?.is_gt() {
        return None;
    }
    let of_v = |coefficient: &Expression, power, log| Leading {
        power: Expression::integer(power),
        log,
        ..Leading::constant(coefficient.clone())
    };
    if ordering(&found.rate)?.is_ne() {
        return Some(of_v(&found.rate, 1, 0));
    }
    if ordering(&found.power)?.is_ne() {
        return Some(of_v(&found.power, 0, 1));
    }
    if found.log != 0 {
        return None;
    }
    if found.coefficient == Expression::integer(1) {
        // ln(1 + h) is h to first order.
        return term(&normal(&argument.clone().sub(Expression::integer(1))), walk);
    }
    Some(Leading::constant(Expression::call(Function::Ln, found.coefficient)))
}

fn call(function: Function, a: &Expression, walk: Walk<'_>) -> Option<Leading> {
    use Function as F;
    let number = |value| Some(Leading::constant(Expression::integer(value)));
    let inner = term(a, walk)?;
    let whether = inner.tends()?;
    let up =
        || ordering(&inner.coefficient).filter(|o| inner.exact && o.is_ne()).map(Ordering::is_gt);
    let signed = |value: Expression| up().map(|up| if up { value.clone() } else { value.neg() });
    match (function, whether) {
        (F::Abs, _) => {
            let sign = up()?;
            if sign { Some(inner) } else { inner.times(Leading::constant(Expression::integer(-1))) }
        }
        (F::Sign, _) => number(if up()? { 1 } else { -1 }),
        (F::Cos | F::Cosh, Ordering::Less) => number(1),
        (_, Ordering::Less) => Some(inner),
        (_, Ordering::Equal) if inner.exact => {
            let value = &inner.coefficient;
            let bound = match function {
                F::Tan => Some(Expression::Pi.div(Expression::integer(2))),
                F::Atanh => Some(Expression::integer(1)),
                _ => None,
            };
            // Beyond the bound, or at it, there may be a pole.
            if let Some(bound) = bound {
                let inside = [bound.clone().sub(value.clone()), bound.add(value.clone())];
                if !inside.iter().all(|room| ordering(room) == Some(Ordering::Greater)) {
                    return None;
                }
            }
            Some(Leading::constant(normal(&Expression::call(function, inner.coefficient))))
        }
        (F::Sin | F::Cos, _) => {
            Some(Leading { exact: false, ..Leading::constant(Expression::integer(1)) })
        }
        (F::Tanh, _) => Some(Leading::constant(signed(Expression::integer(1))?)),
        (F::Atan, _) => {
            Some(Leading::constant(signed(Expression::Pi.div(Expression::integer(2)))?))
        }
        (F::Sinh | F::Cosh, _) => {
            let grown = exponential(if up()? { a.clone() } else { a.clone().neg() }, walk)?;
            let half = Expression::integer(1).div(Expression::integer(2));
            let half = if function == F::Cosh { half } else { signed(half)? };
            grown.times(Leading::constant(half))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Subject;
    use crate::expression::testing::{kappa, mu};
    use crate::mapping::Custom;

    fn of(text: &str) -> String {
        match limit(&mu(text), Variable::SinceStart) {
            Some(Limit::Finite(value)) => value.to_string(),
            Some(Limit::Infinite) => "inf".to_owned(),
            Some(Limit::MinusInfinite) => "-inf".to_owned(),
            None => "?".to_owned(),
        }
    }

    #[test]
    fn limits() {
        for (text, value) in [
            ("exp", "tau"),
            ("tan", "tau"),
            ("tau*(1 - exp(a*t))", "-inf"),
            ("2*tau*(1 - exp(-a*t))", "2*tau"),
            ("tau*t/(1 + t^2)", "0"),
            ("t*exp(-t) + ln(t)/sqrt(t)", "0"),
            ("(1 + t)^a - t", "?"),
            ("tau*(1 - exp(-t)*cos(5*t))", "tau"),
            ("sin(t)", "?"),
            ("tau*(1 - exp(-t^2))", "tau"),
            ("min(t, 3*tau) + max(2, 1/t)", "2 + 3*tau"),
            ("t^2/(3*t^2 + ln(t))", "1/3"),
            ("exp(t^2/(1 + t))*exp(-t)", "exp(-1)"),
            ("exp(t^2/(1 + t) - t)", "exp(-1)"),
            ("exp(-a*t) + exp(-b*t)", "0"),
            ("(sin(t) - cos(t))", "?"),
            ("tan(pi/2 + 1/t)", "?"),
            ("tanh(-t) + sinh(t)/exp(t)", "-1/2"),
        ] {
            assert_eq!(of(text), value, "{text}");
        }
    }

    #[test]
    fn decay_rates() {
        let show = |custom: Custom| custom.decay_rate().map_or("?".to_owned(), |e| e.to_string());
        for (text, rate) in [
            ("exp", "a"),
            ("rational", "0"),
            ("power", "0"),
            ("tan", "0"),
            ("tanh", "2*a"),
            ("algebraic", "0"),
            ("mean(exp(a=a), exp(a=b))", "min(a, b)"),
            ("mean(exp(a=a), exp(a=b), exp(a=c))", "min(a, b, c)"),
            ("mean(exp(a=1), exp(a=2))", "1"),
            ("mean(exp(a=1), rational(a=2))", "0"),
            ("tau*(1 - 1.5*exp(-t) + 0.5*exp(-2*t))", "1"),
            ("tau*(1 - exp(-t^2))", "?"),
        ] {
            assert_eq!(show(Custom::new(Subject::Mu, mu(text)).expect(text)), rate, "{text}");
        }
        for (text, rate) in [
            ("exp", "a"),
            ("rational", "0"),
            ("power", "0"),
            ("tan", "0"),
            ("tanh", "2*a"),
            ("algebraic", "0"),
            ("-ln(1 - dt/tau) + dt", "1"),
            ("ln((tau + 9*dt)/(tau - dt))", "1"),
            ("dt/tau", "?"),
        ] {
            assert_eq!(show(Custom::new(Subject::Kappa, kappa(text)).expect(text)), rate, "{text}");
        }
    }
}
