//! Sines and cosines of sums of angles by the addition theorem: two products in place of a call, where the sines and
//! cosines of the parts are computed anyway.
//!
//! Near a zero of the sine the products cancel, and leave an error of the size of a rounding of 1. In the inertia and
//! the bias of a mechanical plant that does not matter; in a state, which gains multiply that grow without bound, it would.

use super::builder::Builder;
use crate::expression::{Expression, Function, Node};
use crate::model::Inverse;
use crate::program::{Op, Value};
use crate::request::Spec;

/// Returns true if a mechanical plant has a sine or a cosine of a sum of what varies.
pub(super) fn has_angle_sums(spec: &Spec) -> bool {
    let Some(Inverse::Inertia { inertia, bias }) = spec.decoupled().map(|own| &own.inverse) else {
        return false;
    };
    let is_sum = |e: &Expression| match e.node() {
        Node::Call(Function::Sin | Function::Cos, a) => match a.node() {
            Node::Add(a, b) | Node::Sub(a, b) => a.varies() && b.varies(),
            _ => false,
        },
        _ => false,
    };
    inertia.iter().flatten().chain(bias).any(|e| e.any(&is_sum))
}

impl Builder<'_> {
    /// An entry of the inertia or the bias of a mechanical plant.
    pub(super) fn of_mechanics(&mut self, expression: &Expression) -> Value {
        self.splits_sums = self.splits_angles;
        let value = self.scalar(expression);
        self.splits_sums = false;
        value
    }

    /// A sine or a cosine of a sum from those of its parts; `None` if the operation is something else.
    pub(super) fn of_angle_sum(&mut self, op: &Op) -> Option<Value> {
        let Op::Call(function @ (Function::Sin | Function::Cos), a) = op else { return None };
        let (a, b, adds) = match *self.operation_of(*a) {
            Op::Add(a, b) => (a, b, true),
            Op::Sub(a, b) => (a, b, false),
            _ => return None,
        };
        if !self.is_of_tick(a) || !self.is_of_tick(b) {
            return None;
        }
        let [sin_a, cos_a, sin_b, cos_b] =
            [(Function::Sin, a), (Function::Cos, a), (Function::Sin, b), (Function::Cos, b)]
                .map(|(function, angle)| self.push(Op::Call(function, angle)));
        let (left, right, adds) = match function {
            Function::Sin => (self.mul(sin_a, cos_b), self.mul(cos_a, sin_b), adds),
            _ => (self.mul(cos_a, cos_b), self.mul(sin_a, sin_b), !adds),
        };
        Some(if adds { self.add(left, right) } else { self.sub(left, right) })
    }
}
