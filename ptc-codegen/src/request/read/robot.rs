//! The keys of a robot, which is not a controller.

use super::values::hyphenated;
use super::{Entry, Reader};
use crate::diagnostic::Diagnostics;
use crate::keys::ROBOT_FUNCTIONS;

impl Reader<'_> {
    /// Returns true if a design is that of a robot, and refuses it: only `emit` knows it.
    pub(super) fn is_robot(&mut self, entries: &[Entry]) -> bool {
        let given = |key: &str| entries.iter().find(|entry| entry.key == key);
        if let Some(urdf) = given("urdf") {
            let message = "a robot has functions, and no controller yet";
            let help = format!(
                "generate them with `ptc-codegen emit` and what = {}",
                ROBOT_FUNCTIONS.join(", ")
            );
            // Its other keys are not examined.
            self.found = Diagnostics::default();
            self.found.push("conflict", "urdf", Some(urdf.place), message, help);
            return true;
        }
        for key in ["base", "tip", "gravity"] {
            if let Some(entry) = given(key) {
                let message = format!("`{key}` without a robot");
                let help = "give urdf, the file of the robot, or leave it out";
                self.found.push("conflict", key, Some(entry.place), message, help);
            }
        }
        let what = given("what").map(|entry| hyphenated(&entry.value));
        let function = what.filter(|what| ROBOT_FUNCTIONS.contains(&what.as_str()));
        if let (Some(what), Some(entry)) = (function, given("what")) {
            let message = format!("what = {what} without a robot");
            let help = "give urdf, the file of the robot";
            self.found.push("missing-key", "urdf", Some(entry.place), message, help);
            return true;
        }
        false
    }
}
