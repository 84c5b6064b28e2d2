//! Whether an expression is 0 for all states and parameters.

use super::Values;
use crate::algebra::BigRational;
use crate::expression::enclosure::{Evaluator, Existence, Names};
use crate::expression::interval::Interval;
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};

/// Points at which an expression that is not 0 is looked for.
const POINTS: i64 = 12;

/// Whether an expression vanishes wherever it exists; `None` if that is not decided. It does where
/// its normal form is 0, and does not where it is certainly not 0 at one point.
pub(super) fn is_zero(expression: &Expression, values: &Values) -> Option<bool> {
    let known = with(expression, values);
    let form = normal(&known);
    if let Some(number) = form.number() {
        return Some(*number == BigRational::default());
    }
    let mut names: Vec<_> = form.parameters().into_iter().map(Expression::from).collect();
    let variables = (1..=crate::limits::STATES.size()).map(Variable::State);
    let variables = variables.chain([Variable::Control]).filter(|v| form.contains(*v));
    names.extend(variables.map(Expression::from));
    let apart = |point: i64| {
        let at = |(index, name): (i64, &Expression)| {
            let value = BigRational::new((1 + (7 * index + 5 * point) % 13).into(), 8.into());
            let state = name.variable().is_some();
            let value = if state && (index + point) % 3 == 0 { -value } else { value };
            (name.clone(), Interval::exact(&value))
        };
        let names: Names = (0..).zip(&names).map(at).collect();
        let found = Evaluator::new().value(&form, &names);
        found.is_some_and(|v| v.existence == Existence::Certain && !v.interval.has_zero())
    };
    (0..POINTS).any(apart).then_some(false)
}

/// The expression with the values that are known.
pub(super) fn with(expression: &Expression, values: &Values) -> Expression {
    expression.substitute(&|e| values.get(&e.parameter()?).cloned().map(Expression::from))
}
