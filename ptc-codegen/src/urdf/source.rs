//! The source of a robot: its file, the part that is taken, and its gravity.

use num_traits::Zero;

use super::{Drives, Part, Payload, Robot};
use crate::algebra::BigRational;
use crate::syntax::constant;

/// The links between which a robot is taken from its file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ends {
    /// Link that does not move; `None` for the root of the file.
    pub base: Option<String>,
    /// Links at the ends of chains; empty for all that the base carries.
    pub tips: Vec<String>,
}

/// Keys of a robot in a design.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Path of the URDF file, as it is given.
    pub urdf: String,
    /// The links between which the robot is taken.
    pub ends: Ends,
    /// Acceleration of gravity in the frame of the base, m/s^2.
    pub gravity: [BigRational; 3],
    /// Body that the tip carries.
    pub payload: Option<Payload>,
    /// Parts of the drives that the file does not decide.
    pub drives: Drives,
}

impl Source {
    /// Returns the flags that give it.
    pub fn words(&self) -> Vec<String> {
        let mut words = vec![format!("--urdf {}", quoted(&self.urdf))];
        words.extend(self.ends.base.iter().map(|base| format!("--base {}", quoted(base))));
        let tips = self.ends.tips.join(",");
        words.extend((!tips.is_empty()).then(|| format!("--tip {}", quoted(&tips))));
        words.push(format!("--gravity={}", self.gravity_text(",")));
        words.extend(self.payload.as_ref().map(|own| format!("--payload={}", payload_text(own))));
        words.extend(self.drives.words());
        words
    }

    /// Returns the parts of the drives of its robot that are those of its file, and not 0.
    pub(crate) fn of_file<'a>(
        &'a self,
        robot: &'a Robot,
    ) -> impl Iterator<Item = (Part, String)> + 'a {
        let of_file = [Part::Damping, Part::Friction].into_iter();
        let of_file = of_file.filter(|part| !self.drives.0.contains_key(part));
        of_file.filter_map(move |part| {
            let values: Vec<_> = robot.bodies.iter().map(|body| body.drive.value(part)).collect();
            let all: Vec<_> = values.iter().map(|own| constant::text(own)).collect();
            let given = values.iter().any(|own| !own.is_zero());
            given.then(|| (part, format!("[{}]", all.join(", "))))
        })
    }

    /// Returns the components of gravity with `between` in between.
    pub fn gravity_text(&self, between: &str) -> String {
        let all: Vec<_> = self.gravity.iter().map(constant::text).collect();
        all.join(between)
    }
}

/// Returns the numbers of a payload with commas in between.
pub(crate) fn payload_text(payload: &Payload) -> String {
    payload.numbers().map(constant::text).collect::<Vec<_>>().join(",")
}

/// A word of a command line, in quotes where a shell would read more into it. Characters that the comments of emitted
/// files cannot hold are replaced.
fn quoted(text: &str) -> String {
    let legal = |c: char| c.is_ascii_graphic() && !"*\"".contains(c) || c == ' ';
    let text: String = text.chars().map(|c| if legal(c) { c } else { '_' }).collect();
    let plain = text.chars().all(|c| c.is_ascii_alphanumeric() || "_-./,".contains(c));
    if plain { text } else { format!("\"{text}\"") }
}
