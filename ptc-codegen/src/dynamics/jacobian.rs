//! The geometric Jacobian of the tip: its velocity and angular velocity, in the axes of the base, for each joint.

use super::model::{Joint, Joints};
use super::tape::{Tape, Term};
use super::vector::{Matrix, Vector, known, known_matrix, zero};
use crate::urdf::{Body, Motion, Placement, Tip};

/// A body in the base.
struct Pose {
    rotation: Matrix,
    origin: Vector,
}

/// The entries, row by row: three rows of velocity, then three of angular velocity.
pub(super) fn entries(tape: &mut Tape, bodies: &[Body], tip: &Tip, joints: &Joints) -> Vec<Term> {
    let mut way = Vec::new();
    let mut at = tip.body;
    while let Some(index) = at {
        way.push(index);
        at = bodies[index].parent;
    }
    way.reverse();
    let mut pose = None;
    let mut axes = Vec::with_capacity(way.len());
    for index in way {
        let body = &bodies[index];
        let before = placed(tape, pose.as_ref(), &body.placement);
        let axis = before.rotation.each_ref().map(|row| row[2].clone());
        let after = before.behind(tape, &joints.at(bodies, index), &axis);
        axes.push((index, axis, after.origin.clone()));
        pose = Some(after);
    }
    let end = placed(tape, pose.as_ref(), &tip.placement).origin;
    let n = bodies.len();
    let mut entries = vec![Term::zero(); 6 * n];
    for (index, axis, origin) in axes {
        let (linear, angular) = match bodies[index].motion {
            Motion::Revolute => {
                let lever = std::array::from_fn(|i| tape.sub(&end[i], &origin[i]));
                (tape.cross(&axis, &lever), axis)
            }
            Motion::Prismatic => (axis, zero()),
        };
        for (row, entry) in linear.into_iter().chain(angular).enumerate() {
            entries[row * n + index] = entry;
        }
    }
    entries
}

/// A frame of a body in the base; the body is the base where there is none.
fn placed(
    tape: &mut Tape,
    pose: Option<&Pose>,
    Placement { rotation, origin }: &Placement,
) -> Pose {
    let Some(pose) = pose else {
        return Pose { rotation: known_matrix(rotation), origin: known(origin) };
    };
    let shift = tape.apply(&pose.rotation, &known(origin));
    let rotation = known_matrix(rotation);
    Pose {
        rotation: pose.rotation.each_ref().map(|row| tape.apply_transposed(&rotation, row)),
        origin: tape.add_vectors(&pose.origin, &shift),
    }
}

impl Pose {
    /// The frame behind the motion of a joint, whose axis is given in the base.
    fn behind(self, tape: &mut Tape, joint: &Joint<'_>, axis: &Vector) -> Self {
        match joint.turn {
            Some(turn) => {
                let rotation = self.rotation.each_ref().map(|row| tape.turn_back(turn, row));
                Self { rotation, ..self }
            }
            None => {
                let along = axis.each_ref().map(|own| tape.mul(own, joint.position));
                Self { origin: tape.add_vectors(&self.origin, &along), ..self }
            }
        }
    }
}
