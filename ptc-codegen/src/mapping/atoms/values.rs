//! Values of the generator in the time-to-go.

use crate::expression::{Expression, Function, Node, Variable, normal, solve};

/// A mu whose kappa is `kappa`, but for a constant: only its slope is wanted, so that any branch of an
/// inverse tangent will do.
pub(super) fn inverse(kappa: &Expression, t: Expression) -> Option<Expression> {
    let mut tangent = None;
    kappa.each(&mut |e| {
        if let Node::Call(Function::Tan, angle) = e.node() {
            tangent = Some((e.clone(), angle.clone()));
        }
    });
    let Some((tangent, angle)) = tangent else { return solve(kappa, Variable::Elapsed, t) };
    let place = Variable::Control;
    let outer = kappa.substitute(&|e| (*e == tangent).then(|| place.into()));
    let angle_at = Expression::call(Function::Atan, solve(&outer, place, t)?);
    (!outer.contains(Variable::Elapsed)).then(|| solve(&angle, Variable::Elapsed, angle_at))?
}

/// e^(-rate t) for the stretched time t: a power where that is a logarithm.
pub(super) fn decay(t: &Expression, rate: &Expression) -> Expression {
    let moves = |e: &Expression| e.contains(Variable::TimeToGo);
    let exponent = t.clone().mul(rate.clone()).neg();
    match normal::as_logarithm(&exponent, &moves) {
        Some((base, power)) if !moves(&power) => normal::normal(&base.power(power)),
        _ => normal::normal(&Expression::call(Function::Exp, exponent)),
    }
}
