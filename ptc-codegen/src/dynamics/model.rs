//! The bodies of a robot with the least inertial parameters, and the inputs of its joints.

use super::tape::{Tape, Term};
use super::vector::{Turn, Vector, known_matrix};
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
    positions: Vec<Term>,
    rates: Vec<Term>,
    accelerations: Vec<Term>,
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

    /// The same with accelerations of 0.
    pub(super) fn at_constant_rates(mut self) -> Self {
        self.accelerations.fill(Term::zero());
        self
    }

    /// One of the joints of these bodies, by its index.
    pub(super) fn at<'a>(&'a self, bodies: &'a [Body], index: usize) -> Joint<'a> {
        Joint {
            body: &bodies[index],
            position: &self.positions[index],
            rate: &self.rates[index],
            acceleration: &self.accelerations[index],
            turn: self.turns[index].as_ref(),
        }
    }
}

/// A joint, with the body that it moves.
pub(super) struct Joint<'a> {
    pub(super) body: &'a Body,
    pub(super) position: &'a Term,
    pub(super) rate: &'a Term,
    pub(super) acceleration: &'a Term,
    /// `None` for one that slides.
    pub(super) turn: Option<&'a Turn>,
}

impl Joint<'_> {
    /// A vector of the parent in the frame of the body.
    pub(super) fn in_body(&self, tape: &mut Tape, vector: &Vector) -> Vector {
        let rotation = known_matrix(&self.body.placement.rotation);
        let fixed = tape.apply_transposed(&rotation, vector);
        match self.turn {
            Some(turn) => tape.turn_back(turn, &fixed),
            None => fixed,
        }
    }

    /// A vector of the body in the frame of its parent.
    pub(super) fn in_parent(&self, tape: &mut Tape, vector: &Vector) -> Vector {
        let rotation = known_matrix(&self.body.placement.rotation);
        match self.turn {
            Some(turn) => {
                let before = tape.turn(turn, vector);
                tape.apply(&rotation, &before)
            }
            None => tape.apply(&rotation, vector),
        }
    }

    /// The way of a joint that slides, along z.
    pub(super) fn slide(&self) -> Vector {
        [Term::zero(), Term::zero(), self.position.clone()]
    }
}
