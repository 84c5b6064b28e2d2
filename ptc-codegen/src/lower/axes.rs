//! Computations of `tick` for all axes, and of u of one of them.

use super::builder::Builder;
use super::input_gain::{input_gain, over_number};
use super::rows;
use super::rows::Rows;
use crate::algebra::BigRational;
use crate::expression::{Expression, Node};
use crate::internal::fault;
use crate::law::Law;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, Op, Value};
use crate::request::{After, Reference, Spec};

/// Values that `tick` hands over, and the result of `axis`.
#[derive(Default)]
pub(super) struct Shared {
    pub(super) gains: Vec<Value>,
    pub(super) divisors: Vec<Value>,
    pub(super) bounds: Vec<Value>,
    pub(super) lower: Vec<Value>,
    pub(super) axis: Option<Value>,
    pub(super) parts: Vec<Vec<Value>>,
}

/// From this order on, where four divides it, u of one of several axes is a sum of four sums. Each takes every
/// fourth state, so that compilers put four that are adjacent into a vector as they lie, where those of
/// different axes would have to be gathered: `ptc-bench axes` counts 8 axes of order 12. At order 8 it is a loss
/// with -O2, and without vectors it always is, as the sums go through memory.
const ORDER_OF_PARTS: usize = 12;

/// Returns true if the values that depend on time serve several axes: gains that are held after the deadline, with no
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
        let (axis, parts) = axis(b, number, divisor.is_some());
        let divisors = divisor.into_iter().collect();
        return Shared { gains, divisors, axis: Some(axis), parts, ..Shared::default() };
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
        let number = |parameter| own.fixed.get(&parameter).and_then(Fixed::number);
        if let Some(limit) = number(Parameter::UMax).filter(|_| !axes.limits.is_empty()) {
            all.bounds.push(b.number(limit.clone()));
        }
        if let Some(limit) = number(Parameter::UMin).filter(|_| !axes.lower.is_empty()) {
            all.lower.push(b.number(limit.clone()));
        }
    }
    b.of_all(spec);
    let (axis, parts) = axis(b, None, !all.divisors.is_empty());
    (all.axis, all.parts) = (Some(axis), parts);
    all
}

/// u = sum_j gain_j x_j, of the tracking error where there is a reference, over g: a number, or what
/// `tick` handed over. Behind it stand its parts.
fn axis(
    b: &mut Builder<'_>,
    number: Option<&BigRational>,
    handed_over: bool,
) -> (Value, Vec<Vec<Value>>) {
    let n = b.spec.n;
    let in_parts = b.spec.axes.is_some() && n >= ORDER_OF_PARTS && n.is_multiple_of(4);
    let mut sums = vec![None; if in_parts { 4 } else { 1 }];
    let count = sums.len();
    for j in 1..=n {
        let gain = b.push(Op::Input(Input::Gain(j)));
        let x = b.coordinate(j);
        let product = b.mul(gain, x);
        let sum = &mut sums[(j - 1) % count];
        *sum = b.sum(*sum, Some(product));
    }
    let sums: Vec<_> = sums.into_iter().flatten().collect();
    let (sum, parts) = match sums.as_slice() {
        [first, second, third, fourth] => {
            let halves = [b.add(*first, *third), b.add(*second, *fourth)];
            (b.add(halves[0], halves[1]), vec![sums, halves.to_vec()])
        }
        [sum] => (*sum, Vec::new()),
        _ => fault("an axis without a sum"),
    };
    let wanted = match b.reference(n) {
        Some(rate) => b.add(sum, rate),
        None => sum,
    };
    let u = match number {
        Some(number) => over_number(b, wanted, number),
        None if handed_over => {
            let divisor = b.push(Op::Input(Input::Divisor));
            b.push(Op::Quotient(wanted, divisor))
        }
        None => wanted,
    };
    (u, parts)
}
