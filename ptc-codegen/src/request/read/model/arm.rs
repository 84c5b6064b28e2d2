//! A robot from its URDF as the plant of a controller.

use super::super::Reader;
#[cfg(feature = "urdf")]
use super::super::urdf::{robot_of, robot_source};
#[cfg(feature = "urdf")]
use crate::diagnostic::counted;
#[cfg(feature = "urdf")]
use crate::limits::INPUTS;
use crate::model::Coupled;
#[cfg(feature = "urdf")]
use crate::model::{Arm, arm};

/// The key of the file.
const URDF: &str = "urdf";

/// Keys of other plants.
const OTHERS: [&str; 15] = [
    "states", "input", "inputs", "output", "outputs", "dynamics", "inertia", "bias", "axes", "f",
    "g", "A", "B", "C", "units",
];

impl Reader<'_> {
    /// Returns true if the plant is a robot.
    pub(in super::super) fn has_robot(&self) -> bool {
        self.keys.contains_key(URDF)
    }

    /// Refuses the first key of another plant beside a robot.
    fn robot_alone(&mut self) -> Option<()> {
        let other = OTHERS.into_iter().find_map(|key| Some((key, *self.keys.get(key)?)));
        let Some((key, node)) = other else { return Some(()) };
        let message = format!("`{key}` beside `urdf`, which gives the plant");
        let help = "leave it out, or [robot]: states are the positions and velocities of the joints, inputs their torques";
        self.found.push("conflict", key, Some(node.place), message, help);
        None
    }

    /// The plant of the joints of a robot; `None` if it cannot be read.
    #[cfg(feature = "urdf")]
    pub(super) fn robot(&mut self) -> Option<Coupled> {
        self.robot_alone()?;
        let (keys, node) = (&self.keys, *self.keys.get(URDF)?);
        let source = robot_source(&|key| keys.get(key).copied(), &mut self.found)?;
        let place = |key: &str| keys.get(key).map(|node| node.place);
        let robot = robot_of(node, &source, true, &place, &mut self.found)?;
        let joints = robot.bodies.len();
        if !INPUTS.admits(joints) {
            let message = format!("{} of a controller", counted(&joints, "joint"));
            let help = format!(
                "give `base` and `tip` of at most {} joints: several controllers may share t0 and tau",
                INPUTS.most
            );
            self.wrong(URDF, Some(node.place), message, help);
            return None;
        }
        let (states, inputs) = arm::names(joints)?;
        Some(Coupled::of_arm(states, inputs, Arm { source, robot }))
    }

    /// Refuses a robot where no files are read.
    #[cfg(not(feature = "urdf"))]
    pub(super) fn robot(&mut self) -> Option<Coupled> {
        self.robot_alone()?;
        let place = self.keys.get(URDF).map(|node| node.place);
        let message = "a robot is read from its URDF, which the macro does not read".to_owned();
        let help = "emit Rust with `ptc-codegen emit --lang rust`, and include the file";
        self.wrong(URDF, place, message, help.to_owned());
        None
    }
}
