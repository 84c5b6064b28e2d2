//! What a design asks for of a robot, and its reader.

use num_traits::Zero;

use crate::algebra::BigRational;
use crate::diagnostic::{Diagnostic, Diagnostics, Place, near_miss};
use crate::keys::{KeyInfo, ROBOT_FUNCTIONS};
use crate::parameter::{Fixed, Precision, is_reserved};
use crate::request::{Entry, Guard};
use crate::syntax::{Node, Operator, Value, constant, number};
use crate::urdf::{self, Ends, Robot};

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

/// A name of a URDF file in characters that every comment can hold.
pub(crate) fn plain(name: &str) -> String {
    let legal = |c: char| c.is_ascii_alphanumeric() || "_-.+: ".contains(c);
    name.chars().map(|c| if legal(c) { c } else { '_' }).collect()
}

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
    name: Option<String>,
}

/// The keys that a robot takes.
const KEYS: [&str; 9] =
    ["name", "what", "precision", "guard", "fma", "urdf", "base", "tip", "gravity"];

/// Returns true if entries describe a robot.
pub fn is_described(entries: &[Entry]) -> bool {
    entries.iter().any(|entry| entry.key == "urdf")
}

/// Reads what entries ask for of a robot.
///
/// # Errors
/// Every mistake in them.
pub fn read(entries: &[Entry]) -> Result<Request, Vec<Diagnostic>> {
    let mut reader = Reader { entries, found: Diagnostics::default() };
    let request = reader.request();
    reader.found.finish(request)
}

struct Reader<'a> {
    entries: &'a [Entry],
    found: Diagnostics,
}

impl<'a> Reader<'a> {
    fn request(&mut self) -> Option<Request> {
        self.only_own_keys();
        let urdf = self.entry("urdf")?;
        let path = urdf.value.value.to_string();
        if path.is_empty() {
            self.wrong("urdf", urdf.value.place, "urdf is empty", "give the path of a URDF file");
        }
        let quantities = self.quantities();
        let gravity = self.gravity();
        let base = self.entry("base").map(|entry| entry.value.value.to_string());
        let tips = self.entry("tip").map(|entry| names(&entry.value)).unwrap_or_default();
        let ends = Ends { base, tips };
        let precision =
            self.choice("precision", &[("f64", Precision::F64), ("f32", Precision::F32)]);
        let guard = [("full", Guard::Full), ("result", Guard::Result), ("none", Guard::None)];
        let guard = self.choice("guard", &guard);
        let fma = self.choice("fma", &[("true", true), ("false", false)]);
        Some(Request {
            urdf: path,
            place: urdf.value.place,
            ends,
            gravity: gravity?,
            quantities: quantities?,
            precision: precision.unwrap_or(Precision::F64),
            guard: guard.unwrap_or(Guard::Full),
            fma: fma.unwrap_or(false),
            name: self.name(),
        })
    }

    fn entry(&self, key: &str) -> Option<&'a Entry> {
        self.entries.iter().find(|entry| entry.key == key)
    }

    fn wrong(
        &mut self,
        key: &str,
        place: Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.found.push("bad-value", key, Some(place), message, help);
    }

    /// Refuses what is of a controller, and a key that is given twice.
    fn only_own_keys(&mut self) {
        for (index, entry) in self.entries.iter().enumerate() {
            let key = entry.key.as_str();
            if self.entries[..index].iter().any(|other| other.key == key) {
                let message = format!("key `{key}` is given twice");
                self.found.push(
                    "repeated-key",
                    key,
                    Some(entry.place),
                    message,
                    "leave one of the two out",
                );
            } else if !KEYS.contains(&key) {
                let message = format!("`{key}` beside `urdf`");
                let help = format!(
                    "the functions of a robot have no law; their keys are {}",
                    KEYS.join(", ")
                );
                self.found.push("conflict", key, Some(entry.place), message, help);
            }
        }
    }

    fn quantities(&mut self) -> Option<Vec<Quantity>> {
        let legal = format!("give one or several of {}", ROBOT_FUNCTIONS.join(", "));
        let Some(entry) = self.entry("what") else {
            let message = "`what` is missing: a robot has no controller yet";
            self.found.push("missing-key", "what", None, message, legal);
            return None;
        };
        let items = match &entry.value.value {
            Value::List(items) => items.as_slice(),
            _ => std::slice::from_ref(&entry.value),
        };
        let mut all: Vec<Quantity> = Vec::new();
        for item in items {
            let word = hyphenated(item);
            match Quantity::ALL.into_iter().find(|own| own.word() == word) {
                Some(own) if !all.contains(&own) => all.push(own),
                Some(_) => {}
                None => {
                    let help = match near_miss(&word, ROBOT_FUNCTIONS) {
                        Some(near) => format!("did you mean {near}?"),
                        None => legal.clone(),
                    };
                    self.wrong("what", item.place, format!("what = {word} of a robot"), help);
                }
            }
        }
        (!all.is_empty()).then_some(all)
    }

    fn gravity(&mut self) -> Option<[BigRational; 3]> {
        let Some(entry) = self.entry("gravity") else {
            let down = number("-9.81").and_then(|own| own.number().cloned())?;
            return Some([BigRational::zero(), BigRational::zero(), down]);
        };
        let numbers: Option<Vec<BigRational>> = match &entry.value.value {
            Value::List(items) => items.iter().map(known).collect(),
            _ => None,
        };
        let vector = numbers.and_then(|own| <[BigRational; 3]>::try_from(own).ok());
        if vector.is_none() {
            let message = format!("gravity = {}", entry.value.value);
            let help =
                "give three numbers in m/s^2 along the axes of the base, for example 0, 0, -9.81";
            self.wrong("gravity", entry.value.place, message, help);
        }
        vector
    }

    fn choice<T: Copy>(&mut self, key: &str, legal: &[(&str, T)]) -> Option<T> {
        let entry = self.entry(key)?;
        let word = entry.value.value.to_string();
        if let Some((_, value)) = legal.iter().find(|(name, _)| *name == word) {
            return Some(*value);
        }
        let names: Vec<_> = legal.iter().map(|(name, _)| *name).collect();
        let message = format!("{key} = {word} is not one of {}", names.join(", "));
        self.wrong(key, entry.value.place, message, format!("legal: {}", names.join(", ")));
        None
    }

    fn name(&mut self) -> Option<String> {
        let entry = self.entry("name")?;
        match &entry.value.value {
            Value::Word(word) if word.len() <= LONGEST && !is_reserved(word) => Some(word.clone()),
            other => {
                let message = format!("{other} cannot name a robot");
                let legal = KeyInfo::find("name").map_or("", |info| info.legal);
                self.wrong("name", entry.value.place, message, format!("a name is {legal}"));
                None
            }
        }
    }
}

/// Most letters of a name.
const LONGEST: usize = 48;

/// A word that may have hyphens, which read as differences.
fn hyphenated(node: &Node) -> String {
    match &node.value {
        Value::Binary(Operator::Sub, a, b) => format!("{}-{}", hyphenated(a), hyphenated(b)),
        other => other.to_string(),
    }
}

/// The names in a list, or in a text with commas.
fn names(node: &Node) -> Vec<String> {
    match &node.value {
        Value::List(items) => items.iter().flat_map(names).collect(),
        other => other.to_string().split(',').map(|name| name.trim().to_owned()).collect(),
    }
}

fn known(node: &Node) -> Option<BigRational> {
    match &node.value {
        Value::Number(own @ Fixed::Number { .. }) => own.number().cloned(),
        _ => None,
    }
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
        let name: String = robot.name.chars().map(letter).take(LONGEST - "robot_".len()).collect();
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
