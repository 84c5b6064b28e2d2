//! The closed-form inverse of an expression in which the unknown occurs once, or in one power of a
//! fraction that is linear above and below its bar.

use num_traits::ToPrimitive;

use super::field::{Field, Kernel};
use super::ratio::{Ratio, content};
use super::{Expression, Function, Node, Variable};
use crate::algebra::{BigRational, Monomial, Poly, Symbol, integer};
use crate::collect::set;
use crate::limits::ROOT;

/// The `unknown` for which `expression` is `target`, where undoing one operation after the other
/// finds it: the unknown occurs once, and each operation around it can be undone. Where a branch
/// must be chosen, it is the one on which a mapping lies: roots and bases are positive.
pub fn solve(expression: &Expression, unknown: Variable, target: Expression) -> Option<Expression> {
    let here = |e: &Expression| e.contains(unknown);
    let undo = |inner: &Expression, target| solve(inner, unknown, target);
    match expression.node() {
        Node::Variable(variable) if *variable == unknown => Some(target),
        Node::Neg(a) => undo(a, target.neg()),
        Node::Add(a, b) if !here(b) => undo(a, target.sub(b.clone())),
        Node::Add(a, b) if !here(a) => undo(b, target.sub(a.clone())),
        Node::Sub(a, b) if !here(b) => undo(a, target.add(b.clone())),
        Node::Sub(a, b) if !here(a) => undo(b, a.clone().sub(target)),
        Node::Mul(a, b) if !here(b) => undo(a, target.div(b.clone())),
        Node::Mul(a, b) if !here(a) => undo(b, target.div(a.clone())),
        Node::Div(a, b) if !here(b) => undo(a, target.mul(b.clone())),
        Node::Div(a, b) if !here(a) => undo(b, a.clone().div(target)),
        Node::Power(a, b) if !here(b) => {
            undo(a, target.power(Expression::integer(1).div(b.clone())))
        }
        Node::Call(function, a) => undo(a, inverse(*function, target)?),
        _ => unravel(expression, unknown, target),
    }
}

/// The same where the expression is ((a z^k + b)/(c z^k + d))^(1/q), z the unknown or an exponential
/// of it, which may occur in it any number of times.
pub(crate) fn unravel(
    expression: &Expression,
    unknown: Variable,
    target: Expression,
) -> Option<Expression> {
    let mut field = Field::of(expression);
    let ratio = field.fraction(expression)?;
    let (power, raised) = without_roots(&field, &ratio)?;
    let (over, under) = (raised.num.clone(), raised.denominator()?);
    let moves = |s: &Symbol| contains(&field, *s, unknown);
    let moving = set(over.symbols().into_iter().chain(under.symbols()).filter(moves));
    let [z] = moving.into_iter().collect::<Vec<_>>()[..] else { return None };
    let (over, under) = (over.collect(z), under.collect(z));
    let exponents = set(over.keys().chain(under.keys()).copied());
    let [low, high] = exponents.into_iter().collect::<Vec<_>>()[..] else { return None };
    let part = |side: &std::collections::BTreeMap<i32, Poly>, exponent| {
        field.sum_of(&vec![Ratio::of(side.get(&exponent).cloned().unwrap_or_default())])
    };
    let root = |degree: i32| Expression::from(BigRational::new(1.into(), degree.into()));
    let degree = high - low;
    let raised = target.clone().power(Expression::from(power.clone()));
    let value = if over.contains_key(&low) {
        let above = part(&under, low)?.mul(raised.clone()).sub(part(&over, low)?);
        let below = part(&over, high)?.sub(part(&under, high)?.mul(raised));
        above.div(below).power(root(degree))
    } else {
        // target^(q/k) stands outside of the root, where no square of it is rounded.
        let scale = under.get(&low)?.times(&over.get(&high)?.inverse()?);
        let scale = scale.root(u32::try_from(degree).ok()?)?;
        let scale = field.sum_of(&vec![Ratio::of(scale)])?;
        let share = part(&under, high)?.div(part(&over, high)?);
        let rest = Expression::integer(1).sub(share.mul(raised));
        let outer = target.power(Expression::from(power / integer(degree.into())));
        outer.mul(scale).mul(rest.power(root(-degree)))
    };
    match field.kernel(z)? {
        Kernel::Atom(atom) if *atom == unknown.into() => Some(value),
        Kernel::Exp(unit) => {
            let unit = field.sum_of(&vec![unit.clone()])?;
            solve(&unit, unknown, Expression::call(Function::Ln, value))
        }
        _ => None,
    }
}

/// The least power of a fraction that has no roots but within sums, and that power.
fn without_roots(field: &Field, ratio: &Ratio) -> Option<(BigRational, Ratio)> {
    let (_, common) = content(&ratio.num);
    let index = |symbol: Symbol| match field.kernel(symbol) {
        Some(Kernel::Root(base, index)) => Some((base, index.number()?)),
        _ => None,
    };
    let mut power = integer(1);
    for (symbol, _) in common.factors() {
        if let Some((_, index)) = index(*symbol) {
            power *= integer((index * &power).denom().to_i64()?);
        }
    }
    ROOT.admits(power.to_usize()?).then_some(())?;
    let rest = Ratio { num: ratio.num.shifted(&common.pow(-1)), den: ratio.den.clone() };
    let mut raised = rest.pow(power.to_i32()?)?;
    for (symbol, exponent) in common.factors() {
        let times = integer(i64::from(*exponent)) * &power;
        let factor = match index(*symbol) {
            Some((base, index)) => base.pow((times * index).to_i32()?)?,
            None => {
                let own = Monomial::power(*symbol, times.to_i32()?);
                Ratio::of(Poly::term(integer(1), own))
            }
        };
        raised = raised.times(&factor)?;
    }
    Some((power, raised))
}

/// Returns true if the kernel of a symbol depends on a variable.
pub(super) fn contains(field: &Field, symbol: Symbol, variable: Variable) -> bool {
    depends(field, symbol, &|e| e.contains(variable))
}

/// Returns true if the kernel of a symbol contains an expression for which `does` holds.
pub(super) fn depends(field: &Field, symbol: Symbol, does: &dyn Fn(&Expression) -> bool) -> bool {
    let inner = |poly: &Poly| poly.symbols().into_iter().any(|s| depends(field, s, does));
    let ratio = |r: &Ratio| inner(&r.num) || r.den.iter().any(|(factor, _)| inner(factor));
    match field.kernel(symbol) {
        Some(Kernel::Atom(atom)) => does(atom),
        Some(Kernel::Exp(unit)) => ratio(unit),
        Some(Kernel::Root(base, index)) => ratio(base) || does(index),
        None => false,
    }
}

fn inverse(function: Function, target: Expression) -> Option<Expression> {
    match function {
        Function::Sqrt => return Some(target.power(Expression::integer(2))),
        Function::Cbrt => return Some(target.power(Expression::integer(3))),
        _ => {}
    }
    Some(Expression::call(function.row().inverse?, target))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::normal::normal;
    use crate::expression::testing::mu;
    use crate::expression::{Subject, family_form};
    use crate::family::FAMILIES;

    #[test]
    fn variable_that_occurs_once_is_solved_for() {
        let mu = family_form(&FAMILIES[0], Subject::Mu).expect("a form");
        let found = solve(&mu, Variable::SinceStart, Variable::TimeToGo.into());
        assert_eq!(found.expect("an inverse").to_string(), "ln(1 - T/tau)/-a");
    }

    #[test]
    fn linear_fractions_are_solved() {
        for (text, inverse) in [
            ("tau*a*t/(1 + a*t)", "T/(a*(tau - T))"),
            ("tau*a*t/sqrt(1 + (a*t)^2)", "T/(a*sqrt(tau^2 - T^2))"),
            ("tau*(exp(a*t) - 1)/(exp(a*t) + 1)", "ln((tau + T)/(tau - T))/a"),
        ] {
            let found = solve(&mu(text), Variable::SinceStart, Variable::TimeToGo.into());
            assert_eq!(normal(&found.expect(text)).to_string(), inverse, "{text}");
        }
        for text in ["tau*t/(1 + t + t^2)", "tau*(1 - (exp(-t) + exp(-2*t))/2)", "t*exp(-t)"] {
            assert_eq!(solve(&mu(text), Variable::SinceStart, Variable::TimeToGo.into()), None);
        }
    }
}
