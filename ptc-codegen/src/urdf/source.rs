//! The source of a robot: its file, the part that is taken, and its gravity.

use super::Payload;
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
        words
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
