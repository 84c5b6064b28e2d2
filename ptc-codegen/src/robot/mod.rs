//! Functions of a robot from its URDF: inverse dynamics, the mass matrix, the Jacobian of the tip.
//!
//! Each is one staged program, in which the numbers of the robot are folded, and becomes a function of
//! [`Code`](crate::code::Code) that every back end prints. [`read()`] gives what a design asks for, [`code`] makes the functions.

mod functions;
mod inverse_dynamics;
mod jacobian;
mod mass_matrix;
mod model;
mod quantity;
mod read;
mod request;
mod tape;
mod vector;
mod wrench;

pub use functions::code;
pub use quantity::Quantity;
pub(crate) use quantity::plain;
pub use read::{is_described, read};
pub use request::Request;

use crate::internal::fault;
use crate::program::Program;
use crate::urdf::Robot;
use model::{Joints, Model};
use tape::Tape;

/// The staged program of a quantity, whose inputs are the positions x1, ..., xn, then velocities and accelerations.
pub fn staged(request: &Request, robot: &Robot, quantity: Quantity) -> Program {
    let mut tape = Tape::new(request.precision, request.fma);
    let joints = Joints::of(&mut tape, &robot.bodies);
    let results = match quantity {
        Quantity::InverseDynamics => {
            inverse_dynamics::forces(&mut tape, &Model::of(robot), &joints, &request.gravity)
        }
        Quantity::MassMatrix => mass_matrix::entries(&mut tape, &Model::of(robot), &joints),
        Quantity::Jacobian => {
            let Some(tip) = &robot.tip else { fault("a Jacobian without a tip") };
            jacobian::entries(&mut tape, &robot.bodies, tip, &joints)
        }
    };
    tape.finish(&results)
}
