//! The keys of a robot, and whether a design is of its controller or of functions alone.

use super::values::hyphenated;
use super::{Entry, Reader, items};
use num_traits::Signed;

use crate::algebra::{BigRational, integer};
use crate::diagnostic::{Diagnostics, Place, counted};
use crate::keys::ROBOT_FUNCTIONS;
use crate::parameter::Fixed;
use crate::syntax::{Node, Value};
use crate::urdf::{Drives, Part, Payload, Robot, plain};

impl Reader<'_> {
    /// Refuses a design of functions of a robot, which only `emit` generates, and returns true if it is one.
    pub(super) fn is_robot(&mut self, entries: &[Entry]) -> bool {
        let given = |key: &str| entries.iter().find(|entry| entry.key == key);
        let what = given("what").map(|entry| (entry.value.place, asked_for(entry)));
        let function = what.filter(|(_, what)| ROBOT_FUNCTIONS.contains(&what.as_str()));
        let urdf = given("urdf");
        if let (Some(_), Some((place, function))) = (urdf, &function) {
            let message = format!("what = {function} is of `emit`");
            let help = "generate functions of a robot with `ptc-codegen emit`, or leave `what` out for its controller";
            // Its other keys are not examined.
            self.found = Diagnostics::default();
            self.found.push("conflict", "what", Some(*place), message, help);
            return true;
        }
        let of_drives = Part::ALL.map(Part::key);
        for key in ["base", "tip", "gravity", "payload"].into_iter().chain(of_drives) {
            if let (Some(entry), None) = (given(key), urdf) {
                let message = format!("`{key}` without a robot");
                let help = "give urdf, the file of the robot, or leave it out";
                self.found.push("conflict", key, Some(entry.place), message, help);
            }
        }
        if let (Some((place, what)), None) = (function, urdf) {
            let message = format!("what = {what} without a robot");
            let help = "give urdf, the file of the robot";
            self.found.push("missing-key", "urdf", Some(place), message, help);
            return true;
        }
        false
    }
}

/// The first value of `what`.
pub(super) fn asked_for(entry: &Entry) -> String {
    items(&entry.value).first().map(hyphenated).unwrap_or_default()
}

/// The payload that a value is.
pub(crate) fn payload_of(node: &Node, key: &str, found: &mut Diagnostics) -> Option<Payload> {
    let numbers: Option<Vec<BigRational>> = items(node).iter().map(known).collect();
    let payload = numbers.and_then(|numbers| Payload::of(&numbers));
    if payload.is_none() {
        let message = format!("{key} = {}", node.value);
        let help = "give its mass in kg and its centre in the frame of the tip in m, 0.5, 0, 0, 0.1, and behind them, if it is known, its inertia about the centre, ixx, iyy, izz, ixy, ixz, iyz in kg m^2, which is negative about no axis";
        found.push("bad-value", key, Some(node.place), message, help);
    }
    payload
}

/// The numbers of a part of the drives: one for all joints, or one for each.
pub(crate) fn part_of(
    part: Part,
    node: &Node,
    key: &str,
    found: &mut Diagnostics,
) -> Option<Vec<BigRational>> {
    let legal = |number: &BigRational| match part {
        Part::Width => *number >= narrowest(),
        _ => !number.is_negative(),
    };
    let numbers: Option<Vec<BigRational>> = items(node).iter().map(known).collect();
    let numbers = numbers.filter(|all| !all.is_empty() && all.iter().all(legal));
    if numbers.is_none() {
        let message = format!("{key} = {}", node.value);
        let (least, unit) = match part {
            Part::Rotor => ("0", "kg m^2, or kg of a joint that slides"),
            Part::Damping => ("0", "N m s/rad, or N s/m of a joint that slides"),
            Part::Friction => ("0", "N m, or N of a joint that slides"),
            Part::Width => ("1e-6", "rad/s, or m/s of a joint that slides"),
        };
        let help = format!(
            "give one number >= {least} for all joints, or a list with one for each, in {unit}"
        );
        found.push("bad-value", key, Some(node.place), message, help);
    }
    numbers
}

/// Least width of dry friction: its square is a number of single precision.
fn narrowest() -> BigRational {
    integer(1) / integer(1_000_000)
}

/// The robot with these drives; `at` gives the key of each part, and its place.
pub(crate) fn driven(
    robot: &Robot,
    drives: &Drives,
    at: &dyn Fn(&str) -> (String, Option<Place>),
    found: &mut Diagnostics,
) -> Option<Robot> {
    let wrong = match robot.driven(drives) {
        Ok(robot) => return Some(robot),
        Err(wrong) => wrong,
    };
    let (key, place) = at(wrong.key());
    let count = drives.0.get(&wrong).map_or(0, Vec::len);
    let (numbers, joints) = (counted(&count, "number"), counted(&robot.bodies.len(), "joint"));
    let names: Vec<_> = robot.joints().map(plain).collect();
    let message = format!("{key} has {numbers}, and the robot {joints}");
    let help = format!("give one number for all joints, or one for each: {}", names.join(", "));
    found.push("bad-value", key, place, message, help);
    None
}

/// Message and help for a payload that nothing carries.
pub(crate) const NO_TIP: (&str, &str) =
    ("a payload needs one `tip` that moves", "give the link that carries it as `tip`");

pub(super) fn known(node: &Node) -> Option<BigRational> {
    match &node.value {
        Value::Number(own @ Fixed::Number { .. }) => own.number().cloned(),
        _ => None,
    }
}
