//! What a design asks for of a robot.

use std::collections::BTreeMap;

use super::Quantity;
use crate::diagnostic::{Diagnostic, Diagnostics, Place};
use crate::parameter::{Precision, is_reserved};
use crate::request::{Guard, LONGEST_NAME, robot_of};
use crate::syntax::Node;
use crate::urdf::{Robot, Source};

/// Functions of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The source of the robot.
    pub source: Source,
    /// Path of the file with its text.
    pub(super) file: Node,
    /// Places of all keys.
    pub(super) places: BTreeMap<String, Place>,
    /// What is generated.
    pub quantities: Vec<Quantity>,
    /// Floating-point type.
    pub precision: Precision,
    /// Run-time checks.
    pub guard: Guard,
    /// True if products and sums are fused.
    pub fma: bool,
    /// Prefix of every emitted symbol; `None` for the name in the file.
    pub(super) name: Option<String>,
}

impl Request {
    /// The command line (without the program's name and `--lang`) that gives the functions.
    pub fn command(&self) -> String {
        let quantities: Vec<_> = self.quantities.iter().map(|own| own.word()).collect();
        let mut words = vec![format!("--what {}", quantities.join(","))];
        words.extend(self.source.words());
        words.extend(self.name.iter().map(|name| format!("--name {name}")));
        words.extend((self.precision == Precision::F32).then(|| "--precision f32".to_owned()));
        match self.guard {
            Guard::Full => {}
            Guard::Result => words.push("--guard result".to_owned()),
            Guard::None => words.push("--guard none".to_owned()),
        }
        words.extend(self.fma.then(|| "--fma".to_owned()));
        words.join(" ")
    }

    /// The prefix of every emitted symbol.
    pub fn name(&self, robot: &Robot) -> String {
        if let Some(name) = &self.name {
            return name.clone();
        }
        let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
        let name: String =
            robot.name.chars().map(letter).take(LONGEST_NAME - "robot_".len()).collect();
        let legal = name.starts_with(|c: char| c.is_ascii_alphabetic()) && !is_reserved(&name);
        if legal && !name.contains("__") { name } else { "robot".to_owned() }
    }

    /// The robot of its file.
    ///
    /// # Errors
    /// The first mistake in the text, or what the functions lack.
    pub fn robot(&self) -> Result<Robot, Vec<Diagnostic>> {
        let mut found = Diagnostics::default();
        let has_inertia = self.quantities.iter().any(|own| *own != Quantity::Jacobian);
        let place = |key: &str| self.places.get(key).copied();
        let robot = robot_of(&self.file, &self.source, has_inertia, &place, &mut found);
        let needs_tip = self.quantities.contains(&Quantity::Jacobian);
        if needs_tip && robot.as_ref().is_some_and(|robot| robot.tip.is_none()) {
            let message = "the Jacobian needs one `tip`: the robot has several ends";
            found.push(
                "missing-key",
                "tip",
                None,
                message,
                "give the link whose motion it describes",
            );
        }
        found.finish(robot)
    }
}
