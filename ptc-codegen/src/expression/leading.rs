//! The leading term of an expression as its variable grows, under positive parameters, and what
//! it decides: limits, and the rate at which a mapping approaches the deadline.

use std::cmp::Ordering;

use super::normal::normal;
use super::sign::{Sign, positive_parameters, sign};
use super::{Expression, Function, Variable};

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

    fn to_the(self, exponent: &Expression) -> Option<Self> {
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
            Ordering::Equal => {
                let coefficient = normal(&self.coefficient.clone().add(other.coefficient));
                let exact = self.exact && other.exact;
                // Where leading terms cancel, what is left is unknown.
                let left = !exact || ordering(&coefficient).is_none_or(Ordering::is_ne);
                left.then_some(Self { coefficient, exact, ..self })
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
    leading(expression, v)?.limit()
}

/// The decay rate of what falls to 0 as `v` grows: -lim (ln f')'.
pub(crate) fn decay_rate(falling: &Expression, v: Variable) -> Option<Expression> {
    if let Some(term) = leading(falling, v) {
        let falls = term.exact && term.fast == 0 && term.tends()?.is_lt();
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
    let inverse = Expression::integer(1).div(to_go.into());
    let turned = expression.substitute(&|e| (*e == to_go.into()).then(|| inverse.clone()));
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
    use Expression as E;
    if !expression.contains(v) {
        return Some(Leading::constant(normal(expression)));
    }
    match expression {
        E::Number(_) | E::Pi | E::Parameter(_) => None,
        E::Variable(_) => Some(Leading {
            power: Expression::integer(1),
            ..Leading::constant(Expression::integer(1))
        }),
        E::Neg(a) => leading(a, v)?.times(Leading::constant(Expression::integer(-1))),
        E::Add(a, b) => leading(a, v)?.plus(leading(b, v)?),
        E::Sub(a, b) => leading(a, v)?.plus(leading(&(**b).clone().neg(), v)?),
        E::Mul(a, b) => leading(a, v)?.times(leading(b, v)?),
        E::Div(a, b) => leading(a, v)?.times(leading(b, v)?.to_the(&Expression::integer(-1))?),
        E::Power(a, b) if !b.contains(v) => leading(a, v)?.to_the(b),
        E::Power(a, b) => exponential((**b).clone().mul(E::call(Function::Ln, (**a).clone())), v),
        E::Min(a, b) | E::Max(a, b) => {
            let difference = leading(&(**a).clone().sub((**b).clone()), v)?;
            let greater = difference.exact && ordering(&difference.coefficient)?.is_gt();
            let first = greater == matches!(expression, E::Max(..));
            leading(if first { a } else { b }, v).filter(|_| difference.exact)
        }
        E::Call(Function::Exp, a) => exponential((**a).clone(), v),
        E::Call(Function::Ln, a) => logarithm(a, v),
        E::Call(Function::Sqrt, a) => {
            leading(a, v)?.to_the(&Expression::integer(1).div(Expression::integer(2)))
        }
        E::Call(function, a) => call(*function, a, v),
    }
}

/// e^u: what u has in v, in ln v and as a constant decides the rate, the power and the factor.
fn exponential(argument: Expression, v: Variable) -> Option<Leading> {
    let mut rest = normal(&argument);
    let mut result = Leading::constant(Expression::integer(1));
    for _ in 0..4 {
        let term = leading(&rest, v)?;
        let tends = if term.is_zero() { Ordering::Less } else { term.tends()? };
        if tends.is_gt() && !term.exact {
            return None;
        }
        let c = term.coefficient.clone();
        let part = match (tends, term.power.small_integer(), term.log) {
            (Ordering::Less, ..) => return Some(result),
            (Ordering::Equal, ..) => {
                if !term.exact {
                    result.exact = false;
                    return Some(result);
                }
                result.coefficient =
                    normal(&result.coefficient.mul(Expression::call(Function::Exp, c)));
                return Some(result);
            }
            _ if term.fast != 0 || term.rate != zero() => return fast(&c),
            (_, Some(1), 0) => {
                result.rate = normal(&result.rate.add(c.clone()));
                c.mul(v.into())
            }
            (_, Some(0), 1) => {
                result.power = normal(&result.power.add(c.clone()));
                c.mul(Expression::call(Function::Ln, v.into()))
            }
            _ if ordering(&term.power.clone().sub(Expression::integer(1)))?.is_ge() => {
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

fn logarithm(argument: &Expression, v: Variable) -> Option<Leading> {
    let term = leading(argument, v)?;
    if !term.exact || term.fast != 0 || !ordering(&term.coefficient)?.is_gt() {
        return None;
    }
    let of_v = |coefficient: &Expression, power, log| Leading {
        power: Expression::integer(power),
        log,
        ..Leading::constant(coefficient.clone())
    };
    if ordering(&term.rate)?.is_ne() {
        return Some(of_v(&term.rate, 1, 0));
    }
    if ordering(&term.power)?.is_ne() {
        return Some(of_v(&term.power, 0, 1));
    }
    if term.log != 0 {
        return None;
    }
    if term.coefficient == Expression::integer(1) {
        // ln(1 + h) is h to first order.
        return leading(&normal(&argument.clone().sub(Expression::integer(1))), v);
    }
    Some(Leading::constant(Expression::call(Function::Ln, term.coefficient)))
}

fn call(function: Function, a: &Expression, v: Variable) -> Option<Leading> {
    use Function as F;
    let number = |value| Some(Leading::constant(Expression::integer(value)));
    let inner = leading(a, v)?;
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
            let grown = exponential(if up()? { a.clone() } else { a.clone().neg() }, v)?;
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
            ("mean(exp(a=a), exp(a=b), exp(a=c))", "min(min(a, b), c)"),
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
