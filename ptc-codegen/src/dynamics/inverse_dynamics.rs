//! Inverse dynamics: the recursive Newton-Euler algorithm in the frames of the bodies.
//!
//! With angular velocity w and acceleration alpha of a body, the acceleration of its point r is a + U r with
//! U = \[alpha\]x + \[w\]x^2. Force and moment of a body follow from U, its mass m, its first moment h and its second
//! moments S: f = m a + U h, and n is h x a and the vector of the antisymmetric part of U S.

use super::model::{Joint, Joints, Model};
use super::tape::{Tape, Term};
use super::vector::{Matrix, Vector, known, known_matrix, zero};
use super::wrench::Wrench;
use crate::algebra::BigRational;
use crate::urdf::{Inertia, Motion};

/// Motion of a body in its own frame.
#[derive(Clone)]
struct Movement {
    angular_velocity: Vector,
    angular_acceleration: Vector,
    /// Acceleration of the origin, less gravity.
    acceleration: Vector,
    /// U; 0 for the base.
    field: Matrix,
}

/// The forces of the joints that give these accelerations.
pub(super) fn forces(
    tape: &mut Tape,
    model: &Model,
    joints: &Joints,
    gravity: &[BigRational; 3],
) -> Vec<Term> {
    let base = Movement {
        angular_velocity: zero(),
        angular_acceleration: zero(),
        acceleration: known(gravity).map(|own| -own),
        field: std::array::from_fn(|_| zero()),
    };
    let bodies = &model.bodies;
    let mut movements: Vec<Movement> = Vec::with_capacity(bodies.len());
    for (index, body) in bodies.iter().enumerate() {
        let parent = body.parent.map_or(&base, |parent| &movements[parent]).clone();
        movements.push(moved(tape, &joints.at(bodies, index), &parent));
    }
    let mut wrenches: Vec<Wrench> = vec![Wrench::none(); bodies.len()];
    let mut forces = vec![Term::zero(); bodies.len()];
    for (index, body) in bodies.iter().enumerate().rev() {
        let own = wrench(tape, &movements[index], &body.inertia);
        let all = wrenches[index].plus(tape, &own);
        let drive = joints.at(bodies, index).drive(tape);
        forces[index] = tape.add(&all.along(body.motion), &drive);
        if let Some(parent) = body.parent {
            let carried = all.in_parent(tape, &joints.at(bodies, index));
            wrenches[parent] = wrenches[parent].plus(tape, &carried);
        }
    }
    forces
}

/// The motion of a body from that of its parent.
fn moved(tape: &mut Tape, joint: &Joint<'_>, parent: &Movement) -> Movement {
    let shift = tape.apply(&parent.field, &known(&joint.body.placement.origin));
    let acceleration = tape.add_vectors(&parent.acceleration, &shift);
    let [mut angular_velocity, mut angular_acceleration, mut acceleration] =
        [&parent.angular_velocity, &parent.angular_acceleration, &acceleration]
            .map(|vector| joint.in_body(tape, vector));
    // w x z rate.
    let coupling = [
        tape.mul(&angular_velocity[1], joint.rate),
        tape.mul(&-angular_velocity[0].clone(), joint.rate),
        Term::zero(),
    ];
    let field = match joint.body.motion {
        Motion::Revolute => {
            angular_velocity[2] = tape.add(&angular_velocity[2], joint.rate);
            angular_acceleration = tape.add_vectors(&angular_acceleration, &coupling);
            angular_acceleration[2] = tape.add(&angular_acceleration[2], joint.acceleration);
            field(tape, &angular_velocity, &angular_acceleration)
        }
        Motion::Prismatic => {
            let field = field(tape, &angular_velocity, &angular_acceleration);
            let twice = coupling.each_ref().map(|own| tape.twice(own));
            acceleration = tape.add_vectors(&acceleration, &twice);
            let along = field.each_ref().map(|row| tape.mul(&row[2], joint.position));
            acceleration = tape.add_vectors(&acceleration, &along);
            acceleration[2] = tape.add(&acceleration[2], joint.acceleration);
            field
        }
    };
    Movement { angular_velocity, angular_acceleration, acceleration, field }
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
    let Movement { acceleration, field, .. } = movement;
    let (mass, first, second) =
        (Term::from(&inertia.mass), known(&inertia.first), known_matrix(&inertia.second));
    let weight = acceleration.each_ref().map(|own| tape.mul(&mass, own));
    let bent = tape.apply(field, &first);
    let force = tape.add_vectors(&weight, &bent);
    let lever = tape.cross(&first, acceleration);
    let square = movement.angular_velocity.each_ref().map(|own| tape.mul(own, own));
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
