//! The keys of a robot, and whether a design is of its controller or of functions alone.

use super::values::hyphenated;
use super::{Entry, Reader, items};
use crate::algebra::BigRational;
use crate::diagnostic::Diagnostics;
use crate::keys::ROBOT_FUNCTIONS;
use crate::parameter::Fixed;
use crate::syntax::{Node, Value};
use crate::urdf::Payload;

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
        for key in ["base", "tip", "gravity", "payload"] {
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

/// Message and help for a payload that nothing carries.
pub(crate) const NO_TIP: (&str, &str) =
    ("a payload needs one `tip` that moves", "give the link that carries it as `tip`");

pub(super) fn known(node: &Node) -> Option<BigRational> {
    match &node.value {
        Value::Number(own @ Fixed::Number { .. }) => own.number().cloned(),
        _ => None,
    }
}
