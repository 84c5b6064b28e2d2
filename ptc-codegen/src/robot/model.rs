//! The bodies of a robot with the least inertial parameters, and the inputs of its joints.

use super::tape::{Tape, Term};
use super::vector::Turn;
use crate::expression::Function;
use crate::program::Input;
use crate::urdf::{Body, Motion, Robot};

/// Bodies whose inertia acts on the joints as that of the robot does.
pub(super) struct Model {
    pub(super) bodies: Vec<Body>,
}

impl Model {
    /// The bodies of a robot, from the last to the first: what acts on a parent in the same way whatever the position of
    /// the joint becomes part of the parent. Seven of ten parameters of a body that turns remain.
    pub(super) fn of(robot: &Robot) -> Self {
        let mut bodies = robot.bodies.clone();
        for index in (0..bodies.len()).rev() {
            let body = &mut bodies[index];
            let taken = match body.motion {
                Motion::Revolute => body.inertia.take_on_axis(),
                Motion::Prismatic => body.inertia.take_second(),
            };
            let taken = taken.placed(&body.placement);
            if let Some(parent) = body.parent {
                bodies[parent].inertia.add(&taken);
            }
        }
        Self { bodies }
    }
}

/// Positions, velocities and accelerations of the joints.
pub(super) struct Joints {
    pub(super) positions: Vec<Term>,
    pub(super) rates: Vec<Term>,
    pub(super) accelerations: Vec<Term>,
    turns: Vec<Option<Turn>>,
}

impl Joints {
    /// The inputs x1, x2, ...: all positions, then the velocities and the accelerations.
    pub(super) fn of(tape: &mut Tape, bodies: &[Body]) -> Self {
        let n = bodies.len();
        let mut inputs = |first: usize| -> Vec<Term> {
            (1..=n).map(|j| tape.input(Input::State(first + j))).collect()
        };
        let [positions, rates, accelerations] = [0, n, 2 * n].map(&mut inputs);
        let turn = |(body, position): (&Body, &Term)| {
            (body.motion == Motion::Revolute).then(|| Turn {
                cosine: tape.call(Function::Cos, position),
                sine: tape.call(Function::Sin, position),
            })
        };
        let turns = bodies.iter().zip(&positions).map(turn).collect();
        Self { positions, rates, accelerations, turns }
    }

    /// The turn of a joint; `None` for one that slides.
    pub(super) fn turn(&self, joint: usize) -> Option<&Turn> {
        self.turns[joint].as_ref()
    }
}
