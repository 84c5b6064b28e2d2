//! Dynamics and kinematics of a robot as staged programs, in which its numbers are folded.
//!
//! Inputs are the positions x1, ..., xn of the joints, then their velocities and their accelerations. The results are
//! watched.

mod drive;
mod inverse_dynamics;
mod jacobian;
mod mass_matrix;
mod model;
mod tape;
mod vector;
mod wrench;

use crate::algebra::BigRational;
use crate::parameter::Precision;
use crate::program::Program;
use crate::urdf::{Robot, Tip};
use model::{Joints, Model};
use tape::Tape;

/// Rounding of a program.
#[derive(Clone, Copy, Debug)]
pub struct Arithmetic {
    /// Floating-point type.
    pub precision: Precision,
    /// True if products and sums are fused.
    pub fma: bool,
}

impl Arithmetic {
    /// Double precision with a rounding for each operation.
    pub const F64: Self = Self { precision: Precision::F64, fma: false };

    fn tape(self) -> Tape {
        Tape::new(self.precision, self.fma)
    }
}

/// The forces of the joints that give them accelerations, by the recursive Newton-Euler algorithm.
pub fn inverse_dynamics(
    robot: &Robot,
    gravity: &[BigRational; 3],
    arithmetic: Arithmetic,
) -> Program {
    let mut tape = arithmetic.tape();
    let joints = Joints::of(&mut tape, &robot.bodies);
    let forces = inverse_dynamics::forces(&mut tape, &Model::of(robot), &joints, gravity);
    tape.finish(&forces)
}

/// The mass matrix, row by row, by composite rigid bodies.
pub fn mass_matrix(robot: &Robot, arithmetic: Arithmetic) -> Program {
    let mut tape = arithmetic.tape();
    let joints = Joints::of(&mut tape, &robot.bodies);
    let entries = mass_matrix::entries(&mut tape, &Model::of(robot), &joints);
    tape.finish(&entries)
}

/// The equations of motion M a + bias = torque in double precision: M, row by row, and the bias behind it.
pub fn equations(robot: &Robot, gravity: &[BigRational; 3]) -> Program {
    let mut tape = Arithmetic::F64.tape();
    let joints = Joints::of(&mut tape, &robot.bodies);
    let model = Model::of(robot);
    let mut all = mass_matrix::entries(&mut tape, &model, &joints);
    all.extend(inverse_dynamics::forces(&mut tape, &model, &joints.at_constant_rates(), gravity));
    tape.finish(&all)
}

/// The Jacobian of the tip, row by row: three rows of its velocity, three of its angular velocity.
pub fn jacobian(robot: &Robot, tip: &Tip, arithmetic: Arithmetic) -> Program {
    let mut tape = arithmetic.tape();
    let joints = Joints::of(&mut tape, &robot.bodies);
    let entries = jacobian::entries(&mut tape, &robot.bodies, tip, &joints);
    tape.finish(&entries)
}
