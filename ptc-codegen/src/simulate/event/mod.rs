//! Events of a simulated run at times after t0, from the tables `[[event]]` of a design.
//!
//! ```toml
//! [[event]]
//! at = 0.4      # s after t0, from the next sample on
//! move = 0.05   # the target moves
//! tau = 0.6     # and the deadline is 0.6 s later
//! ```

mod each;

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{Signed, ToPrimitive};

use crate::algebra::BigRational;
use crate::diagnostic::{Diagnostic, Diagnostics, near_miss, shorten};
use crate::expression::constant::real;
use crate::keys::EVENT_KEYS;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Entry, MAX_SAMPLES, Spec};
use crate::syntax::{Node, Value};

/// Event of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Time after t0 in s; it happens at the next sample.
    pub at: f64,
    /// Its action.
    pub change: Change,
}

/// A change in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The controller is armed again.
    Arm,
    /// The deadline is so many samples later.
    Deadline(u32),
    /// The target of a chain moves.
    Target {
        /// The state that counts from it, from 0.
        state: usize,
        /// By how much.
        by: f64,
    },
    /// A force is added to u for so long, in s.
    Force {
        /// The input, from 0; `None` for every one.
        input: Option<usize>,
        /// The force, in units of u.
        size: f64,
        /// The time for which it acts.
        length: f64,
    },
}

/// The name of the list of tables.
const TABLE: &str = "event";

/// Reads the events of a design.
///
/// # Errors
/// Every mistake in them.
pub fn read(entries: &[Entry], spec: &Spec) -> Result<Vec<Event>, Vec<Diagnostic>> {
    let number = |entry: &Entry| {
        let rest = entry.key.strip_prefix(TABLE)?.strip_prefix('[')?;
        rest.split_once(']')?.0.parse::<usize>().ok()
    };
    let numbers: BTreeSet<_> = entries.iter().filter_map(number).collect();
    let mut reader = Reader { spec, found: Diagnostics::default() };
    let mut events = Vec::new();
    for number in numbers {
        let table = format!("{TABLE}[{number}]");
        let own = |entry: &&Entry| entry.key.split_once('.').is_some_and(|(own, _)| own == table);
        let given = entries.iter().filter(own).collect();
        events.extend(reader.event(&table, given));
    }
    reader.found.finish(Some(events))
}

struct Reader<'a> {
    spec: &'a Spec,
    found: Diagnostics,
}

impl Reader<'_> {
    fn event(&mut self, table: &str, entries: Vec<&Entry>) -> Vec<Event> {
        let lines = entries.len();
        let given = self.keys(table, entries);
        let Some(at) =
            self.number(table, "at", &given, |at| !at.is_negative(), "a time >= 0, in s")
        else {
            if !given.contains_key("at") {
                let help = "give at = 0.4, the time after t0 in s".to_owned();
                let message = "an event without a time".to_owned();
                self.found.push("missing-key", format!("{table}.at"), None, message, help);
            }
            return Vec::new();
        };
        let at = at.to_f64().unwrap_or(f64::NAN);
        let mut changes = Vec::new();
        changes.extend(self.target(table, &given));
        changes.extend(self.armed(table, &given));
        changes.extend(self.deadline(table, &given));
        changes.extend(self.force(table, &given));
        if changes.is_empty() && lines < 2 {
            let message = "an event in which nothing happens".to_owned();
            let help = "give `tau`, `move`, `kick` with `for`, or arm = true".to_owned();
            self.found.push("missing-key", format!("{table}.tau"), None, message, help);
        }
        changes.into_iter().map(|change| Event { at, change }).collect()
    }

    /// The values of a table by their keys.
    fn keys<'e>(&mut self, table: &str, entries: Vec<&'e Entry>) -> BTreeMap<&'e str, &'e Node> {
        let mut given = BTreeMap::new();
        for entry in entries {
            let name = entry.key.split_once('.').map_or("", |(_, name)| name);
            let known = EVENT_KEYS.iter().map(|info| info.key);
            if !known.clone().any(|key| key == name) {
                let help = match near_miss(name, known.clone()) {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => format!("the keys are {}", known.collect::<Vec<_>>().join(", ")),
                };
                let message = format!("unknown key `{}` of an event", shorten(name));
                self.found.push(
                    "unknown-key",
                    entry.key.as_str(),
                    Some(entry.place),
                    message,
                    help,
                );
            } else if given.insert(name, &entry.value).is_some() {
                let message = format!("key `{name}` of {table} is given twice");
                let help = "leave one of the two out".to_owned();
                self.found.push(
                    "repeated-key",
                    entry.key.as_str(),
                    Some(entry.place),
                    message,
                    help,
                );
            }
        }
        given
    }

    /// A number of a key; `None` where it is not given or wrong.
    fn number(
        &mut self,
        table: &str,
        key: &str,
        given: &BTreeMap<&str, &Node>,
        legal: impl Fn(&BigRational) -> bool,
        wanted: &str,
    ) -> Option<BigRational> {
        let node = given.get(key)?;
        let value = real(node).as_ref().and_then(Fixed::number).cloned().filter(|own| legal(own));
        if value.is_none() {
            let message = format!("{key} = {} is not {wanted}", shorten(&node.value.to_string()));
            let help = format!("give {wanted}");
            self.found.push("bad-value", format!("{table}.{key}"), Some(node.place), message, help);
        }
        value
    }

    fn needs(&mut self, table: &str, key: &str, node: &Node, has: bool, help: &str) -> bool {
        if !has {
            let message = format!("`{key}` of an event does not suit this controller");
            let key = format!("{table}.{key}");
            self.found.push("conflict", key, Some(node.place), message, help.to_owned());
        }
        has
    }

    fn armed(&mut self, table: &str, given: &BTreeMap<&str, &Node>) -> Option<Change> {
        let node = given.get("arm")?;
        match &node.value {
            Value::Word(word) if word == "true" => Some(Change::Arm),
            Value::Word(word) if word == "false" => None,
            other => {
                let message = format!("arm = {} is not true or false", shorten(&other.to_string()));
                let key = format!("{table}.arm");
                let help = "give arm = true, or leave it out".to_owned();
                self.found.push("bad-value", key, Some(node.place), message, help);
                None
            }
        }
    }

    fn deadline(&mut self, table: &str, given: &BTreeMap<&str, &Node>) -> Option<Change> {
        let node = given.get("tau")?;
        let tau = self.number(table, "tau", given, BigRational::is_positive, "a time > 0, in s")?;
        let flies = self.spec.sampled().is_some_and(|own| own.flight.is_some());
        let help = "a deadline changes with in_flight = true, or with `late`; arm = true starts with tau of the design again";
        if !self.needs(table, "tau", node, flies, help) {
            return None;
        }
        let period = self.spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number)?;
        let samples = (tau / period).round().to_integer().to_u32();
        let samples = samples.filter(|own| (1..=MAX_SAMPLES).contains(own));
        let help = "give at least one sample, and at most 2^31";
        self.needs(table, "tau", node, samples.is_some(), help);
        samples.map(Change::Deadline)
    }
}
