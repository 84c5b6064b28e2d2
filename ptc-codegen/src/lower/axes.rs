//! What `tick` computes for all axes, and u of one of them from it.

use super::builder::Builder;
use super::input_gain::{input_gain, over_number};
use super::rows;
use super::rows::Rows;
use crate::algebra::BigRational;
use crate::expression::{Expression, Node};
use crate::law::Law;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, Op, Value};
use crate::request::{After, Reference, Spec};

/// What `tick` hands over, and what `axis` makes of it.
#[derive(Default)]
pub(super) struct Shared {
    pub(super) gains: Vec<Value>,
    pub(super) divisors: Vec<Value>,
    pub(super) bounds: Vec<Value>,
    pub(super) axis: Option<Value>,
}

/// Whether what depends on time serves several axes: gains that are held after the deadline, with no
/// f(x, t), g(x, t) and r(t) of one axis.
pub(super) fn shares_time(spec: &Spec) -> bool {
    let constant = |g: &Expression| !g.any(&|e| matches!(e.node(), Node::Variable(_)));
    spec.drift.is_none()
        && spec.model.is_none()
        && spec.input_gain.as_ref().is_none_or(constant)
        && !matches!(spec.reference, Some(Reference::Known(_)))
        && spec.after == After::Hold
}

/// The gains of `shared`, or those of the `designs` of each axis, with the input gains and bounds that
/// are its own.
pub(super) fn shared<'a>(
    b: &mut Builder<'a>,
    law: &Law,
    designs: &'a [Spec],
    shared: &Rows,
) -> Shared {
    let spec = b.spec;
    let Some(axes) = spec.axes.as_ref().filter(|axes| axes.differ()) else {
        let gains = shared.gains(b);
        let number = spec.input_gain.as_ref().and_then(Expression::number);
        let gain = spec.input_gain.as_ref().filter(|_| number.is_none());
        let divisor = gain.map(|gain| input_gain(b, gain));
        let axis = Some(axis(b, number, divisor.is_some()));
        let divisors = divisor.into_iter().collect();
        return Shared { gains, divisors, bounds: Vec::new(), axis };
    };
    let one = b.integer(1);
    let mut all = Shared::default();
    if axes.gains.is_empty() {
        all.gains = shared.gains(b);
    }
    for (index, own) in (1..).zip(designs) {
        b.of_axis(own, index);
        if !axes.gains.is_empty() {
            let gains = rows(b, law).map(|rows| rows.gains(b));
            all.gains.extend(gains.unwrap_or_default());
        }
        if !axes.input_gains.is_empty() || (index == 1 && spec.input_gain.is_some()) {
            let gain = own.input_gain.as_ref();
            all.divisors.push(gain.map_or(one, |gain| input_gain(b, gain)));
        }
        let limit = own.fixed.get(&Parameter::UMax).and_then(Fixed::number);
        if let Some(limit) = limit.filter(|_| !axes.limits.is_empty()) {
            all.bounds.push(b.number(limit.clone()));
        }
    }
    b.of_all(spec);
    all.axis = Some(axis(b, None, !all.divisors.is_empty()));
    all
}

/// u = sum_j gain_j x_j, of the tracking error where there is a reference, over g: a number, or what
/// `tick` handed over.
fn axis(b: &mut Builder<'_>, number: Option<&BigRational>, handed_over: bool) -> Value {
    let mut sum = None;
    for j in 1..=b.spec.n {
        let gain = b.push(Op::Input(Input::Gain(j)));
        let x = b.coordinate(j);
        let product = b.mul(gain, x);
        sum = b.sum(sum, Some(product));
    }
    let sum = sum.unwrap_or_else(|| b.integer(0));
    let wanted = match b.reference(b.spec.n) {
        Some(rate) => b.add(sum, rate),
        None => sum,
    };
    match number {
        Some(number) => over_number(b, wanted, number),
        None if handed_over => {
            let divisor = b.push(Op::Input(Input::Divisor));
            b.push(Op::Quotient(wanted, divisor))
        }
        None => wanted,
    }
}
