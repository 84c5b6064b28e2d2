//! The tables of a design file: what each holds, and its keys.

use super::verify::{self, DISTURBANCE, INITIAL_STATE, OBJECTIVE_KEYS, PARAMETER};
use super::{EVENT_KEYS, KEYS, KeyInfo, PLANT_KEYS};

/// A table of a design file.
#[derive(Debug)]
pub struct TableInfo {
    /// Its name.
    pub name: &'static str,
    /// Its contents in words.
    pub meaning: &'static str,
    /// True if names of the design stand in it beside its keys.
    pub open: bool,
    /// The least contents of each, of a table that a design may have several times.
    pub each: Option<&'static str>,
    /// Keys that stand for names of the design, such as those of its states.
    names: &'static [&'static KeyInfo],
    /// Keys that only this table has.
    own: &'static [KeyInfo],
}

/// All tables, in the order of the documentation. All other keys are above the first one.
pub static TABLES: [TableInfo; 9] = [
    TableInfo { open: true, ..TableInfo::once("params", "values of parameters, by their names") },
    TableInfo::once("envelope", "what the inputs of the controller are within"),
    TableInfo::once("model", "a model of the plant, from which n, f and g follow"),
    TableInfo::once("robot", "a robot from its URDF: the plant, or functions of it"),
    TableInfo {
        own: &PLANT_KEYS,
        open: true,
        ..TableInfo::once("plant", "the plant; every other name is a symbol of f and g")
    },
    TableInfo {
        names: &[&DISTURBANCE],
        open: true,
        ..TableInfo::once("disturbance", DISTURBANCE.meaning)
    },
    TableInfo {
        names: &[&INITIAL_STATE, &PARAMETER],
        own: &verify::KEYS,
        open: true,
        ..TableInfo::once("verify", "what is drawn, and how much")
    },
    TableInfo {
        each: Some("`bound = \"state\"` and `sigma = 4`"),
        own: &OBJECTIVE_KEYS,
        ..TableInfo::once("objective", "what has to hold")
    },
    TableInfo {
        each: Some("`at = 0.4` and `tau = 0.6`"),
        own: &EVENT_KEYS,
        ..TableInfo::once("event", "what happens in a run of simulate or verify")
    },
];

/// The tables of which a design has one at most, by name.
pub fn single() -> impl Iterator<Item = &'static str> + Clone {
    TABLES.iter().filter(|own| own.each.is_none()).map(|own| own.name)
}

/// Returns the least contents of each of the tables called `name`, of which a design may have several.
pub fn each(name: &str) -> Option<&'static str> {
    TABLES.iter().find(|own| own.name == name)?.each
}

impl TableInfo {
    const fn once(name: &'static str, meaning: &'static str) -> Self {
        Self { name, meaning, open: false, each: None, names: &[], own: &[] }
    }

    /// Returns its keys: those of a controller that it holds, then those that only it has.
    pub fn keys(&self) -> impl Iterator<Item = &'static KeyInfo> + use<> {
        let (name, own) = (self.name, self.own);
        KEYS.iter().filter(move |info| info.table() == Some(name)).chain(own)
    }

    /// Returns the keys that stand for names of the design.
    pub fn names(&self) -> impl Iterator<Item = &'static KeyInfo> + use<> {
        self.names.iter().copied()
    }
}
