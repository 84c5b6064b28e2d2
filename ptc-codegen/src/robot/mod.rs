//! Functions of a robot from its URDF: inverse dynamics, the mass matrix, the Jacobian of the tip.
//!
//! Each is one staged program, in which the numbers of the robot are folded, and becomes a function of
//! [`Code`](crate::code::Code) that every back end prints. [`read()`] gives what a design asks for, [`code`] makes the functions.

mod functions;
mod quantity;
mod read;
mod request;

pub use functions::code;
pub use quantity::Quantity;
pub use read::read;
pub use request::Request;

use crate::dynamics::{self, Arithmetic};
use crate::internal::fault;
use crate::program::Program;
use crate::urdf::Robot;

/// The staged program of a quantity, whose inputs are the positions x1, ..., xn, then velocities and accelerations.
pub fn staged(request: &Request, robot: &Robot, quantity: Quantity) -> Program {
    let arithmetic = Arithmetic { precision: request.precision, fma: request.fma };
    match quantity {
        Quantity::InverseDynamics => {
            dynamics::inverse_dynamics(robot, &request.source.gravity, arithmetic)
        }
        Quantity::MassMatrix => dynamics::mass_matrix(robot, arithmetic),
        Quantity::Jacobian => {
            let Some(tip) = &robot.tip else { fault("a Jacobian without a tip") };
            dynamics::jacobian(robot, tip, arithmetic)
        }
    }
}
