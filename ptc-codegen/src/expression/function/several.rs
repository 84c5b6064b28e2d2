//! Functions of two numbers, each by those of one.
//!
//! No language, analysis or series has to know them: what holds of the parts holds of the whole.

use crate::expression::Expression;

use super::Function;

/// A function of two expressions.
type OfTwo = fn(Expression, Expression) -> Expression;

/// The functions of two numbers, by the names that users write.
pub(crate) const OF_TWO: [(&str, OfTwo); 2] = [("atan2", atan2), ("hypot", hypot)];

fn call(function: Function, a: Expression) -> Expression {
    Expression::call(function, a)
}

/// sqrt(a^2 + b^2).
fn hypot(a: Expression, b: Expression) -> Expression {
    let square = |e: Expression| e.power(Expression::integer(2));
    call(Function::Sqrt, square(a).add(square(b)))
}

/// The angle of the point (x, y), from -pi to pi, which is pi where y is 0 and x < 0.
///
/// With r = hypot(x, y) it is half = 2 atan(y/(r + |x|)) for x >= 0, whose divisor never cancels, and pi - half, or
/// -pi - half for y < 0, to the left. At the origin, where it has no limit, it has no value.
fn atan2(y: Expression, x: Expression) -> Expression {
    let (one, two) = (|| Expression::integer(1), || Expression::integer(2));
    let under = hypot(x.clone(), y.clone()).add(call(Function::Abs, x.clone()));
    let half = two().mul(call(Function::Atan, y.clone().div(under)));
    let side = call(Function::Sign, x);
    // 1 for y = 0 too.
    let above = call(Function::Sign, two().mul(call(Function::Sign, y)).add(one()));
    let turn = Expression::pi().mul(one().sub(side.clone())).div(two());
    side.mul(half).add(turn.mul(above))
}
