//! The rate at which a mapping approaches the deadline.

use std::cmp::Ordering;

use super::scale::{Product, Scale};
use super::series::{Series, Term};
use super::{inverted, ordering, search, zero};
use crate::expression::normal::normal;
use crate::expression::{Expression, Node, Variable};

/// The rate at which something falls: -lim (ln f)'.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Rate {
    /// An expression in parameters; 0 where it falls more slowly than every exponential.
    Finite(Expression),
    /// It falls faster than every exponential.
    Infinite,
}

/// Decay of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Decay {
    pub(crate) rate: Rate,
    /// True if it is known to be a constant other than 0 times e^(-rate v), to leading order.
    pub(crate) pure: bool,
}

/// Returns the decay to 0 of `falling` as `v` grows.
pub(crate) fn decay(falling: &Expression, v: Variable) -> Option<Decay> {
    let found = |series: Series| match series.terms.first() {
        Some(first) => decay_of(first),
        // What is bounded by something that falls so fast falls so fast.
        None => {
            let fast = |bound: &Scale| class(bound).filter(|class| *class == Class::Fast);
            let fast = !series.rest.is_empty() && series.rest.iter().all(|r| fast(r).is_some());
            fast.then_some(Decay { rate: Rate::Infinite, pure: false })
        }
    };
    if let Some(decay) = search(falling, v, &found) {
        return Some(decay);
    }
    // Of terms that cannot be compared before the parameters are known, the slower one decides.
    match falling.node() {
        Node::Neg(a) => decay(a, v),
        Node::Mul(a, b) | Node::Div(a, b) => {
            let (changed, other) = if a.contains(v) { (a, b) } else { (b, a) };
            let plain = !other.contains(v) && matches!(falling.node(), Node::Mul(..));
            (plain || changed == a && !other.contains(v)).then(|| decay(changed, v))?
        }
        Node::Add(a, b) => {
            // Of one sign, so that they cannot cancel.
            let signs = [leading_sign(a, v)?, leading_sign(b, v)?];
            let (a, b) = (decay(a, v)?, decay(b, v)?);
            let pure = a.pure && b.pure;
            let rate = match (a.rate, b.rate) {
                (Rate::Finite(a), Rate::Finite(b)) => Rate::Finite(a.min(b)),
                (Rate::Infinite, slower) | (slower, Rate::Infinite) => slower,
            };
            (signs[0] == signs[1]).then_some(Decay { rate, pure })
        }
        _ => None,
    }
}

/// Decay of a vanishing scale compared with exponentials.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Class {
    Slow,
    Exponential,
    Fast,
}

fn class(scale: &Scale) -> Option<Class> {
    scale.tends().filter(|order| order.is_lt())?;
    if scale.fast < 0 {
        return Some(Class::Fast);
    }
    let (leading, _) = scale.leading()??;
    Some(match leading.cmp(&Product::variable()) {
        Ordering::Greater => Class::Fast,
        Ordering::Equal => Class::Exponential,
        Ordering::Less => Class::Slow,
    })
}

fn decay_of(term: &Term) -> Option<Decay> {
    ordering(&term.coefficient).filter(|order| order.is_ne())?;
    Some(match class(&term.scale)? {
        Class::Fast => Decay { rate: Rate::Infinite, pure: false },
        Class::Slow => Decay { rate: Rate::Finite(zero()), pure: false },
        Class::Exponential => Decay {
            rate: Rate::Finite(normal(&term.scale.rate().neg())),
            pure: term.scale.exponent.len() == 1 && term.scale.open.is_none(),
        },
    })
}

fn leading_sign(expression: &Expression, v: Variable) -> Option<bool> {
    match leading(expression, v) {
        Some(term) => Some(ordering(&term.coefficient).filter(|o| o.is_ne())?.is_gt()),
        None => match expression.node() {
            Node::Add(a, b) => {
                let first = leading_sign(a, v)?;
                (first == leading_sign(b, v)?).then_some(first)
            }
            _ => None,
        },
    }
}

/// Returns the decay of the inverse of a function that grows without bound as `to_go` falls to 0: with kappa = -c ln T,
/// T falls as e^(-t/c); with a power of T as a power of t.
pub(crate) fn decay_of_inverse(kappa: &Expression, to_go: Variable) -> Option<Decay> {
    let turned = inverted(kappa, to_go);
    let forms = [normal(&turned), turned];
    let find = |pure: bool| {
        let fits = |series: Series| inverse_decay(&series).filter(|decay| decay.pure || !pure);
        forms.iter().find_map(|form| search(form, to_go, &fits))
    };
    // More terms may show that the decay is pure.
    find(true).or_else(|| find(false))
}

fn inverse_decay(kappa: &Series) -> Option<Decay> {
    let first = kappa.terms.first()?;
    if !first.scale.tends()?.is_gt() || kappa.sign()? < 0 {
        return None;
    }
    let slow = Decay { rate: Rate::Finite(zero()), pure: false };
    let logarithm = Product::logarithm(1).scale()?;
    Some(match first.scale.compare(&logarithm)? {
        Ordering::Greater => slow,
        Ordering::Equal => {
            let settles = |scale: &Scale| scale.tends().is_some_and(Ordering::is_le);
            let terms = kappa.terms[1..].iter().all(|term| settles(&term.scale));
            let rest = kappa.rest.iter().all(|r| r.tends().is_some_and(Ordering::is_lt));
            let rate = normal(&Expression::integer(1).div(first.coefficient.clone()));
            Decay { rate: Rate::Finite(rate), pure: terms && rest }
        }
        Ordering::Less => Decay { rate: Rate::Infinite, pure: false },
    })
}

/// The leading term as `v` grows without bound; `None` if it is not found.
fn leading(expression: &Expression, v: Variable) -> Option<Term> {
    search(expression, v, &|series| series.terms.into_iter().next())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Subject;
    use crate::expression::testing::{kappa, mu};
    use crate::mapping::Custom;

    #[test]
    fn decay_rates_match_the_mappings() {
        let show = |custom: Custom| match custom.decay(3, &|_| None) {
            None => "?".to_owned(),
            Some(Decay { rate: Rate::Infinite, .. }) => "inf".to_owned(),
            Some(Decay { rate: Rate::Finite(rate), pure }) if rate == zero() || pure => {
                rate.to_string()
            }
            Some(Decay { rate: Rate::Finite(rate), .. }) => format!("{rate}, about"),
        };
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
            ("tau*(1 - exp(-t^2))", "inf"),
            ("tau*(1 - exp(-t - t^2))", "inf"),
            ("tau*(1 - 100^(-t))", "ln(100)"),
            ("tau*(1 - exp(-sqrt(t)))", "0"),
            ("tau*(1 - exp(-t/ln(t + 3)))", "0"),
            ("tau*(1 - exp(-t/(1 + ln(1 + t))))", "0"),
            ("tau*(1 - exp(-t*ln(1 + t)))", "inf"),
            ("tau*(1 - (1 + t)*exp(-t))", "1, about"),
            ("tau*(1 - (1 + t)^(-t))", "inf"),
            ("tau*ln(2 - exp(-t))/ln(2)", "1"),
            ("tau*(sqrt(4 - 3*exp(-2*t)) - 1)", "2"),
            ("tau*sin(pi/2*(1 - exp(-t)))", "2"),
            ("tau*tanh(sinh(t))", "inf"),
            ("2*tau*atan(sinh(t))/pi", "1"),
            ("tau*tanh(t)^3*(1 - exp(-3*t))", "2"),
            ("tau*(1 - exp(1 - sqrt(1 + t^2)))", "1"),
            ("tau*(1 - exp(-t)*(10 + 3*cos(t))/13)", "?"),
            ("tau*(1 - exp(-t) + exp(-3*t)*sin(t)/9)", "1"),
            ("tau*(1 - exp(-t) + exp(-2*t)*sin(exp(t))/9)", "?"),
            ("tau*(1 - exp(1 - exp(t)))", "inf"),
            ("tau*(1 - 1/(1 + ln(1 + t)))", "0"),
            ("tau*(1 - ((1 + exp(-t))/2)^3*exp(-t/2))", "1/2"),
            // ln 100 - 2 ln 10 is 0, which an enclosure alone does not show.
            ("tau*(1 - exp((ln(100) - 2*ln(10))*t - t))", "1 + 2*ln(10) - ln(100)"),
            ("tau*(1 - exp((ln(100) - 2*ln(10))*t)/(1 + t))", "?"),
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
            ("-ln(1 - dt/tau)/ln(8)", "ln(8)"),
            ("sqrt(1 - ln(1 - dt/tau)) - 1", "inf"),
            ("ln(1 - dt/tau)^2 - ln(1 - dt/tau)", "0"),
            ("-ln(1 - dt/tau) + ln(1 - ln(1 - dt/tau))", "1, about"),
            ("ln(1 - ln(1 - dt/tau))", "inf"),
            ("exp(dt/(tau - dt)) - 1", "0"),
        ] {
            assert_eq!(show(Custom::new(Subject::Kappa, kappa(text)).expect(text)), rate, "{text}");
        }
    }
}
