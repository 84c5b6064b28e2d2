//! The reader of the tables `[[event]]`.

mod each;

use std::collections::{BTreeMap, BTreeSet};

use num_traits::ToPrimitive;

use super::{Action, Event, Events, Planned, Quantity, samples};
use crate::diagnostic::{Diagnostic, Diagnostics, near_miss, shorten};
use crate::expression::constant::interval;
use crate::keys::EVENT_KEYS;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Entry, MAX_SAMPLES, Spec};
use crate::syntax::{Node, Value};

/// The name of the list of tables.
const TABLE: &str = "event";

/// Reads the events of a design.
///
/// # Errors
/// Every mistake in them.
pub fn read(entries: &[Entry], spec: &Spec) -> Result<Events, Vec<Diagnostic>> {
    tables(entries, spec, true)
}

/// Reads the events of a single run, in which every number is known.
///
/// # Errors
/// Every mistake in them.
pub fn read_numbers(entries: &[Entry], spec: &Spec) -> Result<Vec<Event>, Vec<Diagnostic>> {
    Ok(tables(entries, spec, false)?.with(&[]))
}

/// `draws`: whether a number may be an interval.
fn tables(entries: &[Entry], spec: &Spec, draws: bool) -> Result<Events, Vec<Diagnostic>> {
    let number = |entry: &Entry| {
        let rest = entry.key.strip_prefix(TABLE)?.strip_prefix('[')?;
        rest.split_once(']')?.0.parse::<usize>().ok()
    };
    let numbers: BTreeSet<_> = entries.iter().filter_map(number).collect();
    let mut reader = Reader { spec, draws, found: Diagnostics::default() };
    let mut events = Vec::new();
    for number in numbers {
        let table = format!("{TABLE}[{number}]");
        let own = |entry: &&Entry| entry.key.split_once('.').is_some_and(|(own, _)| own == table);
        let given = entries.iter().filter(own).collect();
        events.extend(reader.event(Table { number, key: &table }, given));
    }
    reader.found.finish(Some(Events(events)))
}

struct Reader<'a> {
    spec: &'a Spec,
    draws: bool,
    found: Diagnostics,
}

/// One table of the list, with its name in messages.
#[derive(Clone, Copy)]
struct Table<'a> {
    number: usize,
    key: &'a str,
}

/// The values of a table by their keys.
type Given<'e> = BTreeMap<&'e str, &'e Node>;

/// Values that a number may have, and their description.
type Legal = (fn(f64) -> bool, &'static str);

const ANY: Legal = (|_| true, "a finite number");
const TIME: Legal = (|time| time > 0.0, "a time > 0, in s");
const INSTANT: Legal = (|at| at >= 0.0, "a time >= 0, in s");

impl Reader<'_> {
    fn event(&mut self, table: Table<'_>, entries: Vec<&Entry>) -> Option<Planned> {
        let lines = entries.len();
        let given = self.keys(table.key, entries);
        if !given.contains_key("at") {
            let help = "give at = 0.4, the time after t0 in s".to_owned();
            let message = "an event without a time".to_owned();
            self.found.push("missing-key", format!("{}.at", table.key), None, message, help);
            return None;
        }
        let at = self.quantity(table, "at", &given, INSTANT)?;
        let mut actions = Vec::new();
        actions.extend(self.target(table, &given));
        actions.extend(self.armed(table.key, &given));
        actions.extend(self.deadline(table, &given));
        actions.extend(self.force(table, &given));
        if actions.is_empty() && lines < 2 {
            let message = "an event in which nothing happens".to_owned();
            let help = "give `tau`, `move`, `kick` with `for`, or arm = true".to_owned();
            self.found.push("missing-key", table.key, None, message, help);
        }
        Some(Planned { at, actions })
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

    /// A number of a key, or its interval; `None` where it is not given or wrong.
    fn quantity(
        &mut self,
        table: Table<'_>,
        key: &str,
        given: &Given<'_>,
        legal: Legal,
    ) -> Option<Quantity> {
        let name = format!("{TABLE}{}_{key}", table.number);
        self.quantity_of(table, key, given.get(key)?, name, legal)
    }

    /// The same of one value of the key.
    fn quantity_of(
        &mut self,
        table: Table<'_>,
        key: &str,
        node: &Node,
        name: String,
        (legal, wanted): Legal,
    ) -> Option<Quantity> {
        let text = shorten(&node.value.to_string());
        let (message, help) = match interval(node) {
            Some((low, high)) if low < high && !self.draws => (
                format!("{key} = {text} is an interval, and a run takes one number"),
                format!("give {wanted}; `verify` draws from an interval"),
            ),
            Some((low, high)) if low > high => (
                format!("the interval of {key} is empty: {low} > {high}"),
                "an interval is [lower, upper]".to_owned(),
            ),
            Some((low, high)) if legal(low) => return Some(Quantity { name, low, high }),
            None if matches!(node.value, Value::List(_)) => (
                format!("{key} = {text} is not an interval"),
                "an interval is [lower, upper] of finite numbers".to_owned(),
            ),
            _ => (format!("{key} = {text} is not {wanted}"), format!("give {wanted}")),
        };
        let key = format!("{}.{key}", table.key);
        self.found.push("bad-value", key, Some(node.place), message, help);
        None
    }

    fn needs(&mut self, table: &str, key: &str, node: &Node, has: bool, help: &str) -> bool {
        if !has {
            let message = format!("`{key}` of an event does not suit this controller");
            let key = format!("{table}.{key}");
            self.found.push("conflict", key, Some(node.place), message, help.to_owned());
        }
        has
    }

    fn armed(&mut self, table: &str, given: &Given<'_>) -> Option<Action> {
        let node = given.get("arm")?;
        match &node.value {
            Value::Word(word) if word == "true" => Some(Action::Arm),
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

    fn deadline(&mut self, table: Table<'_>, given: &Given<'_>) -> Option<Action> {
        let node = given.get("tau")?;
        let tau = self.quantity(table, "tau", given, TIME)?;
        let in_samples = self.spec.sampled();
        let flies = in_samples.map_or(self.spec.in_flight, |own| own.flight.is_some());
        let help = "a deadline changes with in_flight = true, or with `late`; arm = true starts with tau of the design again";
        if !self.needs(table.key, "tau", node, flies, help) {
            return None;
        }
        if in_samples.is_none() {
            return Some(Action::Deadline(tau, None));
        }
        let period = self.spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number)?;
        let period = period.to_f64()?;
        let legal = |tau: f64| (1..=MAX_SAMPLES).contains(&samples(tau, period));
        let help = "give at least one sample, and at most 2^31";
        let is_legal = legal(tau.low) && legal(tau.high);
        self.needs(table.key, "tau", node, is_legal, help)
            .then_some(Action::Deadline(tau, Some(period)))
    }
}
