//! Inverse dynamics: the recursive Newton-Euler algorithm in the frames of the bodies.
//!
//! With angular velocity w and acceleration alpha of a body, the acceleration of its point r is a + U r with
//! U = \[alpha\]x + \[w\]x^2. Force and moment of a body follow from U, its mass m, its first moment h and its second
//! moments S: f = m a + U h, and n is h x a and the vector of the antisymmetric part of U S.

use super::model::{Joints, Model};
use super::tape::{Tape, Term};
use super::vector::{Matrix, Vector, known, known_matrix, zero};
use crate::algebra::BigRational;
use crate::urdf::{Body, Inertia, Motion};

/// Motion of a body in its own frame.
#[derive(Clone)]
struct Movement {
    /// Angular velocity.
    turning: Vector,
    /// Angular acceleration.
    angular: Vector,
    /// Acceleration of the origin, less gravity.
    linear: Vector,
    /// U; 0 for the base.
    field: Matrix,
}

/// Force and moment about the origin of a frame.
#[derive(Clone)]
struct Wrench {
    force: Vector,
    moment: Vector,
}

impl Wrench {
    fn none() -> Self {
        Self { force: zero(), moment: zero() }
    }
}

/// The forces of the joints that give these accelerations.
pub(super) fn forces(
    tape: &mut Tape,
    model: &Model,
    joints: &Joints,
    gravity: &[BigRational; 3],
) -> Vec<Term> {
    let base = Movement {
        turning: zero(),
        angular: zero(),
        linear: known(gravity).map(|own| -own),
        field: std::array::from_fn(|_| zero()),
    };
    let mut movements: Vec<Movement> = Vec::with_capacity(model.bodies.len());
    for (index, body) in model.bodies.iter().enumerate() {
        let parent = body.parent.map_or(&base, |parent| &movements[parent]).clone();
        movements.push(moved(tape, body, joints, (index, &parent)));
    }
    let mut wrenches: Vec<Wrench> = vec![Wrench::none(); model.bodies.len()];
    let mut forces = vec![Term::zero(); model.bodies.len()];
    for (index, body) in model.bodies.iter().enumerate().rev() {
        let own = wrench(tape, &movements[index], &body.inertia);
        let all = std::mem::replace(&mut wrenches[index], Wrench::none());
        let all = sum(tape, &all, &own);
        forces[index] = match body.motion {
            Motion::Revolute => all.moment[2].clone(),
            Motion::Prismatic => all.force[2].clone(),
        };
        if let Some(parent) = body.parent {
            let carried = carried(tape, body, joints, (index, &all));
            wrenches[parent] = sum(tape, &wrenches[parent].clone(), &carried);
        }
    }
    forces
}

/// The motion of a body from that of its parent.
fn moved(
    tape: &mut Tape,
    body: &Body,
    joints: &Joints,
    (index, parent): (usize, &Movement),
) -> Movement {
    let rotation = known_matrix(&body.placement.rotation);
    let shift = tape.apply(&parent.field, &known(&body.placement.origin));
    let linear = tape.add_vectors(&parent.linear, &shift);
    let into = |tape: &mut Tape, vector: &Vector| {
        let fixed = tape.apply_transposed(&rotation, vector);
        match joints.turn(index) {
            Some(turn) => tape.turn_back(turn, &fixed),
            None => fixed,
        }
    };
    let [mut turning, mut angular, mut linear] =
        [&parent.turning, &parent.angular, &linear].map(|vector| into(tape, vector));
    let (rate, acceleration) = (&joints.rates[index], &joints.accelerations[index]);
    // w x z rate.
    let coupling =
        [tape.mul(&turning[1], rate), tape.mul(&-turning[0].clone(), rate), Term::zero()];
    match body.motion {
        Motion::Revolute => {
            turning[2] = tape.add(&turning[2], rate);
            angular = tape.add_vectors(&angular, &coupling);
            angular[2] = tape.add(&angular[2], acceleration);
            let field = field(tape, &turning, &angular);
            Movement { turning, angular, linear, field }
        }
        Motion::Prismatic => {
            let field = field(tape, &turning, &angular);
            let position = &joints.positions[index];
            let twice = coupling.each_ref().map(|own| tape.twice(own));
            linear = tape.add_vectors(&linear, &twice);
            let along = field.each_ref().map(|row| tape.mul(&row[2], position));
            linear = tape.add_vectors(&linear, &along);
            linear[2] = tape.add(&linear[2], acceleration);
            Movement { turning, angular, linear, field }
        }
    }
}

/// U of an angular velocity and acceleration.
fn field(tape: &mut Tape, w: &Vector, alpha: &Vector) -> Matrix {
    let square = w.each_ref().map(|own| tape.mul(own, own));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i == j {
                let (a, b) = ((i + 1) % 3, (i + 2) % 3);
                return -tape.add(&square[a.min(b)], &square[a.max(b)]);
            }
            let product = tape.mul(&w[i.min(j)], &w[i.max(j)]);
            let third = alpha[3 - i - j].clone();
            tape.add(&product, &if (i + 1) % 3 == j { -third } else { third })
        })
    })
}

/// Force and moment that move a body.
fn wrench(tape: &mut Tape, movement: &Movement, inertia: &Inertia) -> Wrench {
    let Movement { linear, field, .. } = movement;
    let (mass, first, second) =
        (Term::from(&inertia.mass), known(&inertia.first), known_matrix(&inertia.second));
    let weight = linear.each_ref().map(|own| tape.mul(&mass, own));
    let bent = tape.apply(field, &first);
    let force = tape.add_vectors(&weight, &bent);
    let lever = tape.cross(&first, linear);
    let square = movement.turning.each_ref().map(|own| tape.mul(own, own));
    let spun = std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        // U_kk - U_jj = w_k^2 - w_j^2.
        let differ = tape.sub(&square[k], &square[j]);
        tape.products(&[
            (&second[i][j], &field[k][i]),
            (&-second[i][k].clone(), &field[j][i]),
            (&second[j][j], &field[k][j]),
            (&-second[k][k].clone(), &field[j][k]),
            (&second[j][k], &differ),
        ])
    });
    Wrench { force, moment: tape.add_vectors(&lever, &spun) }
}

/// Force and moment of a body on its parent, in the frame of the parent.
fn carried(
    tape: &mut Tape,
    body: &Body,
    joints: &Joints,
    (index, own): (usize, &Wrench),
) -> Wrench {
    let rotation = known_matrix(&body.placement.rotation);
    let mut own = own.clone();
    if body.motion == Motion::Prismatic {
        let position = &joints.positions[index];
        let lever = [
            tape.mul(&-own.force[1].clone(), position),
            tape.mul(&own.force[0], position),
            Term::zero(),
        ];
        own.moment = tape.add_vectors(&own.moment, &lever);
    }
    let out = |tape: &mut Tape, vector: &Vector| {
        let before = match joints.turn(index) {
            Some(turn) => tape.turn(turn, vector),
            None => vector.clone(),
        };
        tape.apply(&rotation, &before)
    };
    let [force, moment] = [&own.force, &own.moment].map(|vector| out(tape, vector));
    let lever = tape.cross(&known(&body.placement.origin), &force);
    Wrench { moment: tape.add_vectors(&moment, &lever), force }
}

fn sum(tape: &mut Tape, a: &Wrench, b: &Wrench) -> Wrench {
    Wrench {
        force: tape.add_vectors(&a.force, &b.force),
        moment: tape.add_vectors(&a.moment, &b.moment),
    }
}
