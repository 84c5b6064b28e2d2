//! The inputs of a plant with several of them, from what is wanted of each output.

mod cofactors;

use super::builder::Builder;
use super::plant::control;
use super::{rows, state};
use crate::dynamics::{Arithmetic, inverse_dynamics};
use crate::expression::{Expression, Variable};
use crate::law::Law;
use crate::model::Arm;
use crate::model::coupled::{Coupled, Inverse};
use crate::program::{Input, Op, Value};
use crate::request::{Feedback, Spec};

/// The first input, the others, and the determinant that they are divided by, if there is one. `law` is that of the first output.
pub(super) fn controls<'a>(
    b: &mut Builder<'a>,
    law: &Law,
    coupled: &Coupled,
    designs: &'a [Spec],
) -> (Value, Vec<Value>, Option<Value>) {
    let spec = b.spec;
    b.highest = designs.iter().max_by_key(|own| own.n);
    if spec.laws().next().is_some() || spec.feedback == Feedback::Extern {
        // A law knows the chains of all outputs.
        let mut all = Vec::new();
        for (index, own) in (1..).zip(designs) {
            b.of_axis(own, index);
            all.extend(state::stretched_state(b, ""));
        }
        b.states[0] = all;
    }
    let mut wanted = Vec::with_capacity(designs.len());
    for (index, own) in (1..).zip(designs) {
        b.of_axis(own, index);
        // The closed forms of another engine are those of one order.
        let of_order = (own.n != law.n).then(|| Law::of(own));
        let u = match rows(b, of_order.as_ref().unwrap_or(law)) {
            Some(rows) => rows.step(b, None),
            None => state::step(b),
        };
        // The gain of a plant is in its decoupling.
        let u = control(b, u);
        wanted.push(b.name(
            u,
            "wanted",
            "wanted of the last derivative of the output, less its drift",
        ));
    }
    b.of_all(spec);
    inputs(b, coupled, wanted)
}

/// The first input, the others, and the determinant, from what is wanted of the last rate of each output,
/// less its drift.
pub(super) fn inputs(
    b: &mut Builder<'_>,
    coupled: &Coupled,
    wanted: Vec<Value>,
) -> (Value, Vec<Value>, Option<Value>) {
    let by_jets = b.jets.as_ref().and_then(|jets| jets.gains.clone());
    let (mut controls, divisor) = match (&coupled.inverse, by_jets) {
        (Inverse::Adjugate { .. }, Some(matrix)) => cofactors::inputs(b, &matrix, &wanted),
        (Inverse::Adjugate { determinant, adjugate, .. }, None) => {
            let one = *determinant == Expression::integer(1);
            let determinant = (!one).then(|| b.scalar(determinant));
            let over = determinant.map(|value| over_determinant(b, value));
            let times = |row: &Vec<Expression>| {
                let sum = product(b, row, &wanted, None);
                over.map_or(sum, |over| b.mul(sum, over))
            };
            (adjugate.iter().map(times).collect(), determinant)
        }
        (Inverse::Elimination { .. }, Some(matrix)) => {
            let entries = matrix.iter().flatten().map(|entry| b.coefficient(entry)).collect();
            eliminated(b, entries, wanted)
        }
        (Inverse::Elimination { matrix, .. }, None) => {
            let entries = matrix.iter().flatten().map(|entry| b.scalar(entry)).collect();
            eliminated(b, entries, wanted)
        }
        (Inverse::Inertia { inertia, bias }, _) => {
            let force = |(row, bias): (&Vec<Expression>, &Expression)| {
                let bias = (*bias != Expression::integer(0)).then(|| b.of_mechanics(bias));
                product(b, row, &wanted, bias)
            };
            (inertia.iter().zip(bias).map(force).collect(), None)
        }
        (Inverse::Robot(arm), _) => (torques(b, arm, &wanted), None),
    };
    let first = controls.remove(0);
    (first, controls, divisor)
}

/// The torques that give the joints of a robot wanted accelerations: its inverse dynamics, operation by operation.
fn torques(b: &mut Builder<'_>, arm: &Arm, wanted: &[Value]) -> Vec<Value> {
    let arithmetic = Arithmetic { precision: b.spec.precision, fma: b.spec.fma };
    let program = inverse_dynamics(&arm.robot, &arm.source.gravity, arithmetic);
    let states = 2 * wanted.len();
    let mut values: Vec<Value> = Vec::with_capacity(program.values.len());
    for definition in &program.values {
        let value = match &definition.op {
            Op::Input(Input::State(j)) if *j > states => wanted[j - states - 1],
            Op::Input(Input::State(j)) => b.scalar(&Variable::State(*j).into()),
            op => b.push(op.map(|operand| values[operand.0])),
        };
        values.push(value);
    }
    program.watched.iter().map(|torque| values[torque.0]).collect()
}

/// The solution of the equations of more outputs than have a closed form, and their determinant.
fn eliminated(
    b: &mut Builder<'_>,
    matrix: Vec<Value>,
    wanted: Vec<Value>,
) -> (Vec<Value>, Option<Value>) {
    let m = wanted.len();
    let solved = b.push(Op::Elimination { matrix, right: wanted });
    let solved = b.name(solved, "inputs", "those that decouple the outputs");
    let divisor = b.push(Op::Element(solved, m));
    ((0..m).map(|index| b.push(Op::Element(solved, index))).collect(), Some(divisor))
}

/// The inverse of the determinant of the decoupling matrix.
fn over_determinant(b: &mut Builder<'_>, determinant: Value) -> Value {
    let value = b.name(determinant, "determinant", "determinant of the decoupling matrix");
    let one = b.integer(1);
    let inverse = b.push(Op::Quotient(one, value));
    b.name(inverse, "over_determinant", "its inverse: no number where it is 0")
}

/// A row times the wanted derivatives, and `more`.
fn product(
    b: &mut Builder<'_>,
    row: &[Expression],
    wanted: &[Value],
    more: Option<Value>,
) -> Value {
    let mut sum = None;
    for (entry, wanted) in row.iter().zip(wanted) {
        let term = match entry {
            zero if *zero == Expression::integer(0) => continue,
            one if *one == Expression::integer(1) => *wanted,
            entry => {
                let entry = b.of_mechanics(entry);
                b.mul(entry, *wanted)
            }
        };
        sum = b.sum(sum, Some(term));
    }
    b.sum(sum, more).unwrap_or_else(|| b.integer(0))
}
