//! From the entries of `[verify]`, `[disturbance]` and `[[objective]]` to a campaign: all mistakes at
//! once.

mod campaign;
mod disturbance;
mod drawn;
mod events;
mod integral;
mod objective;
mod running;
mod value;
mod valued;

use std::collections::{BTreeMap, BTreeSet};

use super::{Campaign, Interval, Signal};
use crate::check::resolved::Resolved;
use crate::diagnostic::{Diagnostic, Diagnostics, Place, near_miss, shorten};
use crate::parameter::Parameter;
use crate::plant::{self, Plant};
use crate::request::{Entry, Spec, known};
use crate::simulate::{Events, Loop};
use crate::syntax::Node;
use integral::Integral;
use value::{number, to_f64};
use valued::UNVALUED;

/// Node and place of each key.
type Given<'a> = BTreeMap<&'a str, (Place, &'a Node)>;

/// Reads the campaign of a design whose controller is `spec`, with the mistakes in `[plant]` beside
/// those in its own tables.
///
/// # Errors
/// Every mistake in the tables.
pub fn read_with_plant(entries: &[Entry], spec: &Spec) -> Result<Campaign, Vec<Diagnostic>> {
    spec.needs_law("a campaign")?;
    spec.needs_known_reference("a campaign")?;
    with_plant(entries, spec, Objectives::Required)
}

/// The same for its scenarios alone, without the events: a design without objectives is no mistake.
///
/// # Errors
/// Every mistake in the tables.
pub fn read_scenarios(entries: &[Entry], spec: &Spec) -> Result<Campaign, Vec<Diagnostic>> {
    with_plant(entries, spec, Objectives::Optional)
}

/// Need of a campaign for an objective.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Objectives {
    Required,
    Optional,
}

fn with_plant(
    entries: &[Entry],
    spec: &Spec,
    objectives: Objectives,
) -> Result<Campaign, Vec<Diagnostic>> {
    let (plant, mut found) = plant::read_partly(entries, spec);
    let mut spec = spec.clone();
    let twice = plant::promised(&mut spec, plant.as_ref(), entries);
    found.extend(twice.err().unwrap_or_default());
    let (spec, plant) = plant::as_one(spec, plant);
    let spec = &spec;
    // What has a sample period runs with a chain, or with the plant that it was designed for.
    let knows = Loop::of(spec).is_some() || spec.has_model();
    let plant = plant.or_else(|| knows.then(|| Plant::own(spec)));
    let Some(plant) = plant else {
        found.push(Diagnostic {
            code: "missing-key",
            key: plant::TABLE.to_owned(),
            place: None,
            message: "the design has no plant".to_owned(),
            help:
                "write `[plant]`, and under it `f = \"...\"`, or `f = 0` for a chain of integrators"
                    .to_owned(),
        });
        return Err(found);
    };
    match tables(entries, (spec, &plant), objectives) {
        Ok(campaign) if found.is_empty() => Ok(campaign),
        Ok(_) => Err(found),
        Err(more) => {
            // What is wrong in [plant] explains what it seems to lack.
            let follows = |wrong: &Diagnostic| {
                wrong.code == UNVALUED
                    || wrong.key.starts_with("disturbance.") && wrong.code == "unknown-key"
            };
            let explained = !found.is_empty();
            found.extend(more.into_iter().filter(|wrong| !(explained && follows(wrong))));
            Err(found)
        }
    }
}

/// Reads the campaign of a controller and its plant.
///
/// # Errors
/// Every mistake in the tables.
pub fn read(entries: &[Entry], spec: &Spec, plant: &Plant) -> Result<Campaign, Vec<Diagnostic>> {
    tables(entries, (spec, plant), Objectives::Required)
}

fn tables(
    entries: &[Entry],
    (spec, plant): (&Spec, &Plant),
    wanted: Objectives,
) -> Result<Campaign, Vec<Diagnostic>> {
    let (found, integrals) = (Diagnostics::default(), Vec::new());
    let design = Resolved::of(&spec.clone().apart());
    let joined =
        if spec.joins_axes() { design.spec.clone().as_one_plant() } else { design.spec.clone() };
    let joined = joined.with_larger(plant.larger.as_ref());
    let mut reader = Reader { design, spec: &joined, plant, found, integrals };
    let table = |name: &str| -> Vec<&Entry> {
        let own = |entry: &&Entry| entry.key.split_once('.').is_some_and(|(own, _)| own == name);
        entries.iter().filter(own).collect()
    };
    let of_verify = reader.table(&table("verify"));
    let drawn = reader.drawn(&of_verify);
    let of_disturbance = reader.table(&table("disturbance"));
    let number = |entry: &Entry| {
        let rest = entry.key.strip_prefix("objective[")?;
        rest.split_once(']')?.0.parse::<usize>().ok()
    };
    let numbers: BTreeSet<_> = entries.iter().filter_map(number).collect();
    let mut objectives = Vec::new();
    for number in &numbers {
        let own = table(&format!("objective[{number}]"));
        let given = reader.table(&own);
        objectives.extend(reader.objective(*number, &given).map(|objective| (*number, objective)));
    }
    if numbers.is_empty() && wanted == Objectives::Required {
        let message = "the design has no objective to verify";
        let help = "write `[[objective]]`, and under it `bound = \"state\"` and `sigma = 4`";
        reader.found.push("missing-key", "objective", None, message, help);
    }
    let disturbances = reader.disturbances(&of_disturbance);
    let events = match wanted {
        Objectives::Required => reader.events(entries),
        Objectives::Optional => Events::default(),
    };
    reader.names_apart(entries, &events);
    reader.objectives_suit(entries, &objectives, &events);
    reader.valued(entries, &objectives, (&of_verify, &drawn));
    let whole: Vec<_> = objectives.into_iter().map(|(_, objective)| objective).collect();
    let campaign = reader.campaign(&of_verify, (drawn, disturbances, events), whole);
    reader.found.finish(campaign)
}

struct Reader<'a> {
    design: Resolved,
    spec: &'a Spec,
    plant: &'a Plant,
    found: Diagnostics,
    /// Integrals of all objectives together, each once.
    integrals: Vec<Integral>,
}

type Drawn = Vec<(Parameter, Interval)>;

type Disturbances = Vec<(Parameter, Interval, Vec<Signal>)>;

impl Reader<'_> {
    fn table<'b>(&mut self, entries: &[&'b Entry]) -> Given<'b> {
        let mut given = Given::new();
        for entry in entries {
            let name = entry.key.split_once('.').map_or("", |(_, name)| name);
            if given.insert(name, (entry.place, &entry.value)).is_some() {
                let message = format!("key `{}` is given twice", entry.key);
                let help = "leave one of the two out";
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

    fn wrong(&mut self, key: &str, place: Option<Place>, message: String, help: &str) {
        self.found.push("bad-value", key, place, message, help);
    }

    fn unknown(&mut self, key: &str, place: Place, legal: &[String]) {
        let (table, name) = key.split_once('.').unwrap_or(("", key));
        let meant = near_miss(name, legal.iter().map(String::as_str));
        let meant = meant.map(|meant| format!("did you mean `{meant}`? ")).unwrap_or_default();
        let help = format!("{meant}the keys are {}", legal.join(", "));
        let message = match table.strip_prefix("objective[").and_then(|rest| rest.strip_suffix(']'))
        {
            Some(number) => format!("unknown key `{}` of objective {number}", shorten(name)),
            None => format!("unknown key `{}`", shorten(key)),
        };
        self.found.push("unknown-key", key, Some(place), message, help);
    }

    /// Order of the chain; several outputs are several chains, which have names of their own.
    fn order(&self) -> usize {
        if self.spec.coupled.is_some() { 0 } else { self.spec.n }
    }

    /// The parameters that an objective may name.
    fn known(&self) -> Vec<Parameter> {
        known(self.spec.time_mapping.parameters())
    }
}
