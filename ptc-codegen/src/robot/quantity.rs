//! What the functions of a robot compute.

use crate::keys::ROBOT_FUNCTIONS;
use crate::urdf::{Robot, plain};

/// What a function of a robot computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The forces of the joints that give accelerations.
    InverseDynamics,
    /// The mass matrix.
    MassMatrix,
    /// The Jacobian of the tip.
    Jacobian,
}

impl Quantity {
    /// All of them, in the order of [`ROBOT_FUNCTIONS`].
    pub const ALL: [Self; ROBOT_FUNCTIONS.len()] =
        [Self::InverseDynamics, Self::MassMatrix, Self::Jacobian];

    /// Its value of the key `what`.
    pub fn word(self) -> &'static str {
        ROBOT_FUNCTIONS[self as usize]
    }

    /// The name of its function, behind that of the robot.
    pub fn function(self) -> &'static str {
        match self {
            Self::InverseDynamics => "inverse_dynamics",
            Self::MassMatrix => "mass_matrix",
            Self::Jacobian => "jacobian",
        }
    }

    /// The number of arrays that the function is given: positions, velocities, accelerations.
    pub(super) fn arrays(self) -> usize {
        match self {
            Self::InverseDynamics => 3,
            Self::MassMatrix | Self::Jacobian => 1,
        }
    }

    /// The number of results of a robot with `n` joints.
    pub fn size(self, n: usize) -> usize {
        match self {
            Self::InverseDynamics => n,
            Self::MassMatrix => n * n,
            Self::Jacobian => 6 * n,
        }
    }

    /// Name and meaning of the result.
    pub(super) fn result(self) -> (&'static str, &'static str) {
        match self {
            Self::InverseDynamics => ("torque", "torques or forces of the joints, N m or N"),
            Self::MassMatrix => ("mass", "the mass matrix, row by row, in SI units"),
            Self::Jacobian => (
                "j",
                "the Jacobian, row by row: three rows of the velocity, three of the angular velocity",
            ),
        }
    }

    /// Describes the function in a sentence.
    pub(super) fn about(self, robot: &Robot) -> String {
        match self {
            Self::InverseDynamics => {
                "Torques with which the joints at q and v have the accelerations a.".to_owned()
            }
            Self::MassMatrix => {
                "Mass matrix M at q: the torques are M a and what does not depend on a.".to_owned()
            }
            Self::Jacobian => {
                let tip = robot.tip.as_ref().map_or("", |tip| tip.link.as_str());
                format!(
                    "Jacobian at q of the origin of `{}`, in the axes of `{}`.",
                    plain(tip),
                    plain(&robot.base)
                )
            }
        }
    }
}
