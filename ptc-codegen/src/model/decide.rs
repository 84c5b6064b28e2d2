//! Decision on whether an expression is 0 for all states and parameters.

use super::Values;
use crate::algebra::BigRational;
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::{Evaluator, Existence, Names};
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};
use crate::limits::SIZE;

/// Points at which an expression that is not 0 is looked for.
const POINTS: i64 = 12;

/// Returns true if an expression vanishes wherever it exists; `None` if that is not decided. It does where its normal
/// form is 0, and does not where it is certainly not 0 at one point.
pub(super) fn is_zero(expression: &Expression, values: &Values) -> Option<bool> {
    let known = with(expression, values);
    let zero = |form: &Expression| form.number().map(|number| *number == BigRational::default());
    // The normal form of what is too long to be written out takes long, and a value away from 0 does not.
    let long = !SIZE.admits(known.size());
    let form = if long { known.clone() } else { normal(&known) };
    if let Some(decided) = zero(&form) {
        return Some(decided);
    }
    let names = names(std::slice::from_ref(&form));
    let apart = |point: i64| {
        let found = Evaluator::new().value(&form, &at(point, &names));
        found.is_some_and(|v| v.existence == Existence::Certain && !v.interval.has_zero())
    };
    if (0..POINTS).any(apart) {
        return Some(false);
    }
    if long { zero(&normal(&known)) } else { None }
}

/// Returns true if a matrix is certainly regular at one point: by elimination in intervals, no pivot of which holds 0.
pub(super) fn is_regular_at_a_point(matrix: &[Vec<Expression>], values: &Values) -> bool {
    let forms: Vec<_> = matrix.iter().flatten().map(|entry| with(entry, values)).collect();
    let names = names(&forms);
    (0..POINTS).any(|point| {
        let at = at(point, &names);
        let found = forms.iter().map(|form| {
            let found = Evaluator::new().value(form, &at)?;
            (found.existence == Existence::Certain).then_some(found.interval)
        });
        let found: Option<Vec<_>> = found.collect();
        found.is_some_and(|entries| has_pivots(entries, matrix.len()))
    })
}

/// Returns true if elimination of a matrix, row by row, finds a pivot without 0 in each column.
fn has_pivots(mut a: Vec<Interval>, m: usize) -> bool {
    for k in 0..m {
        // The one that is furthest from 0 in its middle is the most certain.
        let size = |i: &usize| a[i * m + k].about().iter().sum::<f64>().abs();
        let rows = (k..m).filter(|i| !a[i * m + k].has_zero());
        let Some(most) = rows.max_by(|i, j| size(i).total_cmp(&size(j))) else { return false };
        (0..m).for_each(|j| a.swap(k * m + j, most * m + j));
        for i in k + 1..m {
            let factor = a[i * m + k].over(&a[k * m + k]);
            for j in k + 1..m {
                a[i * m + j] = a[i * m + j].minus(&factor.times(&a[k * m + j]));
            }
        }
    }
    true
}

/// The names of some expressions: their parameters, states and input.
fn names(forms: &[Expression]) -> Vec<Expression> {
    let parameters = crate::collect::set(forms.iter().flat_map(Expression::parameters));
    // Several inputs are numbered behind the states.
    let most = crate::limits::STATES.size() + crate::limits::INPUTS.size();
    let variables = (1..=most).map(Variable::State);
    let variables = variables.chain([Variable::Control]);
    let variables = variables.filter(|v| forms.iter().any(|form| form.contains(*v)));
    parameters.into_iter().map(Expression::from).chain(variables.map(Expression::from)).collect()
}

/// Values of names at one of the points: parameters are positive, states of both signs.
fn at(point: i64, names: &[Expression]) -> Names {
    let at = |(index, name): (i64, &Expression)| {
        let value = BigRational::new((1 + (7 * index + 5 * point) % 13).into(), 8.into());
        let state = name.variable().is_some();
        let value = if state && (index + point) % 3 == 0 { -value } else { value };
        (name.clone(), Interval::exact(&value))
    };
    (0..).zip(names).map(at).collect()
}

/// The expression with the values that are known.
pub(super) fn with(expression: &Expression, values: &Values) -> Expression {
    expression.known(&|p| values.get(&p).cloned())
}
