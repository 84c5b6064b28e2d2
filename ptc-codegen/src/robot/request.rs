//! What a design asks for of a robot.

use super::Quantity;
use crate::algebra::BigRational;
use crate::diagnostic::{Diagnostic, Diagnostics, Place};
use crate::parameter::{Precision, is_reserved};
use crate::request::{Guard, LONGEST_NAME};
use crate::syntax::constant;
use crate::urdf::{self, Ends, Robot};

/// Functions of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Path of the URDF file, as it is given.
    pub urdf: String,
    /// Place of the path.
    pub place: Place,
    /// The links between which the robot is taken.
    pub ends: Ends,
    /// Acceleration of gravity in the frame of the base, m/s^2.
    pub gravity: [BigRational; 3],
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
        let quoted = |text: &str| match text
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || "_-./,".contains(c))
        {
            true => text.to_owned(),
            false => format!("\"{text}\""),
        };
        let mut words = vec![
            format!("--what {}", quantities.join(",")),
            format!("--urdf {}", quoted(&self.urdf)),
        ];
        words.extend(self.ends.base.iter().map(|base| format!("--base {}", quoted(base))));
        let tips = self.ends.tips.join(",");
        words.extend((!tips.is_empty()).then(|| format!("--tip {}", quoted(&tips))));
        let gravity: Vec<_> = self.gravity.iter().map(constant::text).collect();
        words.push(format!("--gravity={}", gravity.join(",")));
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

    /// The robot of the text of its file.
    ///
    /// # Errors
    /// The first mistake in the text, or what the functions lack.
    pub fn robot(&self, text: &str) -> Result<Robot, Vec<Diagnostic>> {
        let mut found = Diagnostics::default();
        let robot = match urdf::read(text, &self.ends) {
            Ok(robot) => Some(robot),
            Err(wrong) => {
                let line = wrong.line.map(|line| format!(", line {line}")).unwrap_or_default();
                let message = format!("{}{line}: {}", self.urdf, wrong.message);
                found.push("bad-value", "urdf", Some(self.place), message, wrong.help);
                None
            }
        };
        let dynamic = self.quantities.iter().any(|own| *own != Quantity::Jacobian);
        if let Some(joint) = robot.as_ref().and_then(Robot::without_mass).filter(|_| dynamic) {
            let message = format!("{}: what joint `{joint}` moves has no inertia", self.urdf);
            let help = "give <inertial> with <mass> and <inertia> to its child link, or to a link that is fixed to it";
            found.push("bad-value", "urdf", Some(self.place), message, help);
        }
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
