//! Helpers of the tests of expressions.

use num_traits::ToPrimitive;

use super::{Expression, Function, Node, Scope, Subject, Variable, resolve};
use crate::diagnostic::{Diagnostics, Place};
use crate::parameter::Parameter;
use crate::syntax::parse;

fn read(text: &str, subject: Subject) -> Expression {
    let node = parse(subject.key(), text, &mut |_| Place(0)).expect(text);
    let scope = Scope { subject, n: 3, known: &[Parameter::Tau], own: &[] };
    let mut found = Diagnostics::default();
    resolve(&node, scope, &mut found).unwrap_or_else(|| panic!("{text}"))
}

/// The expression in `t` that `text` spells.
pub(crate) fn mu(text: &str) -> Expression {
    read(text, Subject::Mu)
}

/// The expression in `dt` that `text` spells.
pub(crate) fn kappa(text: &str) -> Expression {
    read(text, Subject::Kappa)
}

/// Its value with every variable at `at`, tau = 2, m = 1/2, any other parameter 3/4.
pub(crate) fn evaluate(expression: &Expression, at: f64) -> f64 {
    let value = |e: &Expression| evaluate(e, at);
    match expression.node() {
        Node::Number(number) => number.to_f64().expect("a float"),
        Node::Pi => std::f64::consts::PI,
        Node::Parameter(Parameter::Tau) => 2.0,
        Node::Parameter(p) if p.spelling() == "m" => 0.5,
        Node::Parameter(_) => 0.75,
        Node::Variable(_) => at,
        Node::Neg(a) => -value(a),
        Node::Add(a, b) => value(a) + value(b),
        Node::Sub(a, b) => value(a) - value(b),
        Node::Mul(a, b) => value(a) * value(b),
        Node::Div(a, b) => value(a) / value(b),
        Node::Power(a, b) => value(a).powf(value(b)),
        Node::Min(a, b) => value(a).min(value(b)),
        Node::Max(a, b) => value(a).max(value(b)),
        Node::Call(function, a) => (function.row().double)(value(a)),
    }
}

/// Returns the error of a form of an expression at t, relative to its value plus 1/100; `None` where a small change of
/// t changes it by more than the test of forms allows, as rounding does too.
pub(crate) fn error(plain: &Expression, form: &Expression, t: f64) -> Option<f64> {
    let (truth, near) = (evaluate(plain, t), evaluate(plain, t * (1.0 + 1e-12)));
    let steady = truth.abs() < 1e9 && (near - truth).abs() <= 1e-9 * truth.abs();
    steady.then(|| (evaluate(form, t) - truth).abs() / (1e-2 + truth.abs()))
}

/// A random expression in t, tau and a, from a linear congruential generator.
pub(crate) fn random(seed: &mut u64, height: u32) -> Expression {
    let mut next = |below: i64| {
        *seed =
            seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from(*seed >> 33).expect("31 bits") % below
    };
    let kind = next(if height == 0 { 5 } else { 14 });
    let choice = next(i64::try_from(Function::ALL.len()).expect("few"));
    let mut inner = || random(seed, height.saturating_sub(1));
    match kind {
        0 => Expression::integer(choice - 4),
        1 => Parameter::Tau.into(),
        2 => mu("a"),
        3 | 4 => Variable::SinceStart.into(),
        5 | 6 => inner().add(inner()),
        7 => inner().sub(inner()),
        8 | 9 => inner().mul(inner()),
        10 => inner().div(inner()),
        11 if choice % 3 == 0 => {
            inner().power(Expression::integer(choice - 6).div(Expression::integer(2)))
        }
        11 => inner().power(Expression::integer(choice - 6)),
        _ => Expression::call(Function::ALL[usize::try_from(choice).expect("an index")].1, inner()),
    }
}
