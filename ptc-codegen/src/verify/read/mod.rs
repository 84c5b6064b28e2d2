//! From the entries of `[verify]`, `[disturbance]` and `[[objective]]` to a campaign: all mistakes at
//! once.

mod disturbance;
mod drawn;
mod integral;
mod objective;
mod running;
mod value;

use std::collections::{BTreeMap, BTreeSet};

use integral::Integral;
use value::{number, to_f64};

use super::{Campaign, Interval, Objective, Signal};
use crate::diagnostic::{Diagnostic, Diagnostics, Place, near_miss, shorten};
use crate::keys::verify::KEYS;
use crate::parameter::Parameter;
use crate::plant::{self, Plant};
use crate::request::{Entry, Spec, known};
use crate::simulate::Loop;
use crate::syntax::{Node, number as exact};

/// What stands at a key, and where the key is.
type Given<'a> = BTreeMap<&'a str, (Place, &'a Node)>;

/// Reads the campaign of a design whose controller is `spec`, with the mistakes in `[plant]` beside
/// those in its own tables.
///
/// # Errors
/// Every mistake in the tables.
pub fn read_with_plant(entries: &[Entry], spec: &Spec) -> Result<Campaign, Vec<Diagnostic>> {
    spec.needs_law("a campaign")?;
    spec.needs_known_reference("a campaign")?;
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
    match read(entries, spec, &plant) {
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

/// Code of a name without a value.
const UNVALUED: &str = "missing-value";

/// Reads the campaign of a controller and its plant.
///
/// # Errors
/// Every mistake in the tables.
pub fn read(entries: &[Entry], spec: &Spec, plant: &Plant) -> Result<Campaign, Vec<Diagnostic>> {
    let (found, integrals) = (Diagnostics::default(), Vec::new());
    let mut reader = Reader { spec, plant, found, integrals };
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
    if numbers.is_empty() {
        let message = "the design has no objective to verify";
        let help = "write `[[objective]]`, and under it `bound = \"state\"` and `sigma = 4`";
        reader.found.push("missing-key", "objective", None, message, help);
    }
    let disturbances = reader.disturbances(&of_disturbance);
    reader.valued(entries, &objectives, (&of_verify, &drawn));
    let whole: Vec<_> = objectives.into_iter().map(|(_, objective)| objective).collect();
    let campaign = reader.campaign(&of_verify, (drawn, disturbances), whole);
    reader.found.finish(campaign)
}

struct Reader<'a> {
    spec: &'a Spec,
    plant: &'a Plant,
    found: Diagnostics,
    /// Of all objectives together, each once.
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

    fn campaign(
        &mut self,
        given: &Given<'_>,
        (drawn, disturbances): (Drawn, Disturbances),
        objectives: Vec<Objective>,
    ) -> Option<Campaign> {
        let states = self.spec.state_names();
        let n = states.len();
        for state in states.iter().filter(|name| KEYS.iter().any(|info| info.key == **name)) {
            let message = format!("the state `{state}` has the name of a key of [verify]");
            self.found.push("conflict", "states", None, message, "call it something else");
        }
        let fixed = KEYS.iter().map(|info| info.key.to_owned());
        let legal: Vec<_> = self.quantities().into_iter().chain(fixed).collect();
        for (name, (place, _)) in given {
            if !legal.iter().any(|key| key == name) {
                self.unknown(&format!("verify.{name}"), *place, &legal);
            }
        }
        let missing: Vec<_> =
            states.iter().filter(|name| !given.contains_key(name.as_str())).cloned().collect();
        if !missing.is_empty() {
            let message = format!("[verify] has no interval of {}", missing.join(", "));
            let all = match self.spec.has_model() {
                true => states.join(", "),
                false => format!("x1..x{n}"),
            };
            let help =
                format!("give the box of initial states: one [lower, upper] for each of {all}");
            self.found.push("missing-key", "verify", None, message, help);
        }
        let x0: Vec<_> =
            states.iter().filter_map(|name| self.interval("verify", name, given)).collect();
        let fixed_tau = self.spec.fixed.get(&Parameter::Tau).and_then(to_f64);
        let tau = match (self.interval("verify", "tau", given), fixed_tau) {
            (Some((low, _)), _) if low <= 0.0 => {
                let place = given.get("tau").map(|(_, node)| node.place);
                self.wrong("verify.tau", place, "tau is not > 0".to_owned(), KEYS[0].legal);
                None
            }
            (Some(tau), _) => Some(tau),
            (None, Some(tau)) => Some((tau, tau)),
            (None, None) => {
                if !given.contains_key("tau") {
                    let message = "tau has no value";
                    let help = "give `tau = 1` in the design, or `tau = [0.5, 2]` under [verify]";
                    self.found.push("missing-key", "verify.tau", None, message, help);
                }
                None
            }
        };
        let scenarios = self.integer("scenarios", given, (1, 1_000_000_000_000), 10_000);
        let seed = self.integer("seed", given, (0, 1 << 53), 0);
        let search = self.integer("search", given, (0, 1_000_000_000), 2000);
        let around = Loop::of(self.spec);
        let until = match &around {
            Some(around) => self.end(given, tau, around.period),
            None => self.until(given, tau),
        };
        let tolerance = self.number("tolerance", given, &|t| t > 0.0).unwrap_or(1e-6);
        let varies: BTreeSet<_> = disturbances.iter().map(|(symbol, ..)| *symbol).collect();
        let constant = self.plant.bounds.iter().filter(|(symbol, _)| !varies.contains(symbol));
        let constant = constant
            .filter_map(|(symbol, (low, high))| Some((*symbol, (to_f64(low)?, to_f64(high)?))));
        let mut intervals: Vec<_> = constant.collect();
        let mut spec = self.spec.clone();
        if given.contains_key("tau") {
            spec.fixed.remove(&Parameter::Tau);
        }
        // Each of them may have told what is wrong with it.
        (x0.len() == n).then_some(())?;
        let tau = tau?;
        // What is one number is known, and what the controller is built with.
        let (known, drawn): (Vec<_>, Vec<_>) =
            drawn.into_iter().partition(|(_, (low, high))| low == high);
        for (symbol, (value, _)) in &known {
            spec.bounds.remove(symbol);
            spec.fixed.insert(*symbol, exact(&format!("{value:e}"))?);
        }
        if around.is_some() {
            spec = self.running(spec, &x0)?;
        }
        // An eps of the checks is that of the values that the design gives.
        for (symbol, _) in &drawn {
            spec.fixed.remove(symbol);
        }
        if known.iter().chain(&drawn).any(|(symbol, _)| matches!(symbol, Parameter::Gain(_))) {
            spec.poles.clear();
        }
        // What is both of the controller and of the plant is drawn once.
        let new = |(symbol, _): &(Parameter, _)| !self.plant.bounds.contains_key(symbol);
        intervals.extend(drawn.into_iter().filter(|own| new(own) || varies.contains(&own.0)));
        Some(Campaign {
            spec,
            plant: self.plant.clone(),
            around,
            scenarios: scenarios?,
            seed: seed?,
            search: usize::try_from(search?).ok()?,
            until: until?,
            tolerance,
            tau,
            x0,
            intervals,
            disturbances,
            integrals: self.integrands(),
            objectives,
        })
    }

    /// Order of the chain; several outputs are several chains, which have names of their own.
    fn order(&self) -> usize {
        if self.spec.coupled.is_some() { 0 } else { self.spec.n }
    }

    /// The parameters that an objective may name.
    fn known(&self) -> Vec<Parameter> {
        known(self.spec.time_mapping.parameters())
    }

    /// Every name has a value or an interval; one that has none is blamed on what uses it.
    fn valued(
        &mut self,
        entries: &[Entry],
        objectives: &[(usize, Objective)],
        (given, drawn): (&Given<'_>, &[(Parameter, Interval)]),
    ) {
        let (spec, plant) = (self.spec, self.plant);
        let integrands = self.integrands();
        let of_run = [Parameter::Tau, Parameter::Eps, Parameter::StartTime, Parameter::UMax];
        let lacks = |p: &Parameter| {
            let fixed = spec.fixed.contains_key(p) || plant.gives(*p);
            // One that is given and not legal has been reported.
            let drawn = drawn.iter().any(|(symbol, _)| symbol == p)
                || given.contains_key(p.spelling().as_str());
            !fixed && !drawn && !of_run.contains(p)
        };
        let mut told: BTreeSet<Parameter> = BTreeSet::new();
        let mut tell = |key: &str, used: &mut dyn Iterator<Item = Parameter>, help: &str| {
            let new: BTreeSet<_> = used.filter(lacks).filter(|p| told.insert(*p)).collect();
            if new.is_empty() {
                return;
            }
            let names: Vec<_> = new.into_iter().map(Parameter::spelling).collect();
            let place =
                entries.iter().find(|entry| entry.key == key).map(|entry| entry.value.place);
            let message = format!("{} without a value in the design", names.join(", "));
            self.found.push(UNVALUED, key, place, message, help);
        };
        let of_controller = "parameters of the controller have their values under [params], gains at `gains` or `poles`";
        tell("verify", &mut spec.parameters().into_iter(), of_controller);
        let of_plant = "a symbol of the plant has its value, or [lower, upper], under [plant]";
        for (key, expression) in plant.keyed() {
            tell(key, &mut expression.parameters().into_iter(), of_plant);
        }
        for integrand in &integrands {
            tell("objective", &mut integrand.parameters().into_iter(), of_controller);
        }
        for (number, objective) in objectives {
            for (name, expression) in objective.kind.expressions() {
                let key = format!("objective[{number}].{name}");
                tell(&key, &mut expression.parameters().into_iter(), of_controller);
            }
        }
    }

    fn until(&mut self, given: &Given<'_>, tau: Option<Interval>) -> Option<f64> {
        let tau = tau?.0;
        let eps =
            self.spec.fixed.get(&Parameter::Eps).and_then(to_f64).map_or(0.0, |eps| eps / tau);
        if !given.contains_key("until") {
            return Some(eps.max(1e-3));
        }
        let until = self.number("until", given, &|share| share > 0.0 && share < 1.0)?;
        if until < eps {
            let place = given.get("until").map(|(_, node)| node.place);
            let message =
                format!("until = {until} ends after the gains are held, from eps/tau = {eps} on");
            self.wrong(
                "verify.until",
                place,
                message,
                "Theorem 1 speaks of the law before eps: give a larger until, or a smaller eps",
            );
            return None;
        }
        Some(until)
    }
}
