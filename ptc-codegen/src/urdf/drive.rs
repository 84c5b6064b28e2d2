//! What the drive of a joint adds to rigid bodies: the inertia of its rotor, viscous and dry friction.

use std::collections::BTreeMap;

use num_traits::Zero;

use super::Robot;
use crate::algebra::BigRational;
#[cfg(feature = "urdf")]
use crate::algebra::integer;
use crate::syntax::constant;

/// The drive of a joint, with force rotor a + damping v + friction v/sqrt(v^2 + width^2).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drive {
    /// Inertia of the rotor behind its gear, kg m^2; a mass, kg, of a joint that slides.
    pub rotor: BigRational,
    /// Viscous friction, N m s/rad or N s/m.
    pub damping: BigRational,
    /// Dry friction, N m or N.
    pub friction: BigRational,
    /// Velocity at which dry friction has 0.71 of its value, rad/s or m/s.
    pub width: BigRational,
}

impl Drive {
    /// A drive without inertia and friction.
    #[cfg(feature = "urdf")]
    pub(crate) fn none() -> Self {
        let [rotor, damping, friction] = [0; 3].map(integer);
        Self { rotor, damping, friction, width: integer(1) / integer(100) }
    }

    /// Prints the parts that are not 0.
    pub(crate) fn text(&self) -> Option<String> {
        let parts = [("rotor", &self.rotor), ("damping", &self.damping)];
        let shown = parts.into_iter().filter(|(_, value)| !value.is_zero());
        let mut words: Vec<_> =
            shown.map(|(name, value)| format!("{name} {}", constant::text(value))).collect();
        if !self.friction.is_zero() {
            let [friction, width] = [&self.friction, &self.width].map(constant::text);
            words.push(format!("friction {friction} within {width}"));
        }
        (!words.is_empty()).then(|| words.join(", "))
    }

    /// Returns a part.
    pub(crate) fn value(&self, part: Part) -> &BigRational {
        match part {
            Part::Rotor => &self.rotor,
            Part::Damping => &self.damping,
            Part::Friction => &self.friction,
            Part::Width => &self.width,
        }
    }

    fn part(&mut self, part: Part) -> &mut BigRational {
        match part {
            Part::Rotor => &mut self.rotor,
            Part::Damping => &mut self.damping,
            Part::Friction => &mut self.friction,
            Part::Width => &mut self.width,
        }
    }
}

/// A part of a drive that a design gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// Inertia of the rotor.
    Rotor,
    /// Viscous friction.
    Damping,
    /// Dry friction.
    Friction,
    /// Velocity within which dry friction rises.
    Width,
}

impl Part {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Rotor, Self::Damping, Self::Friction, Self::Width];

    /// Returns the key of a design that gives it.
    pub fn key(self) -> &'static str {
        match self {
            Self::Rotor => "rotor",
            Self::Damping => "damping",
            Self::Friction => "friction",
            Self::Width => "friction_width",
        }
    }

    /// Returns the part that a key gives.
    pub fn of(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|part| part.key() == key)
    }
}

/// Parts of drives that are given in place of those of the file: a number for all joints, or one for each.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Drives(pub BTreeMap<Part, Vec<BigRational>>);

impl Drives {
    /// Returns the flags that give them.
    pub(super) fn words(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(|(part, numbers)| {
            let numbers: Vec<_> = numbers.iter().map(constant::text).collect();
            format!("--{}={}", part.key().replace('_', "-"), numbers.join(","))
        })
    }

    /// These, and where they give nothing those of `others`.
    pub(crate) fn or(&self, others: &Self) -> Self {
        let mut all = others.clone();
        all.0.extend(self.0.clone());
        all
    }
}

impl Robot {
    /// Puts parts of its drives in place of its own.
    ///
    /// # Errors
    /// The first part with neither one number nor one for each joint.
    pub(crate) fn driven(&self, drives: &Drives) -> Result<Self, Part> {
        let mut robot = self.clone();
        for (part, numbers) in &drives.0 {
            if numbers.len() != 1 && numbers.len() != robot.bodies.len() {
                return Err(*part);
            }
            for (body, number) in robot.bodies.iter_mut().zip(numbers.iter().cycle()) {
                body.drive.part(*part).clone_from(number);
            }
        }
        Ok(robot)
    }

    /// Describes what the equations of motion leave out.
    #[cfg_attr(not(feature = "files"), allow(dead_code))]
    pub(crate) fn left_out(&self) -> String {
        let any = |part: Part| self.bodies.iter().any(|body| !body.drive.value(part).is_zero());
        let rotor = any(Part::Rotor);
        let friction = any(Part::Damping) || any(Part::Friction);
        let missing = match (rotor, friction) {
            (false, false) => "friction, springs, the inertia of rotors, and limits of positions",
            (true, false) => "friction, springs and limits of positions",
            (false, true) => "springs, the inertia of rotors, and limits of positions",
            (true, true) => "springs and limits of positions",
        };
        format!("Rigid bodies: {missing} are not modelled.")
    }
}
