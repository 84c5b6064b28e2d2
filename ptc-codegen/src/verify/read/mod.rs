//! From the entries of `[verify]`, `[disturbance]` and `[[objective]]` to a campaign: all mistakes at
//! once.

mod disturbance;
mod objective;

use std::collections::{BTreeMap, BTreeSet};

use num_traits::ToPrimitive;

use super::keys::KEYS;
use super::{Campaign, Interval, Objective, Signal};
use crate::diagnostic::{Diagnostic, Diagnostics, Place, near_miss};
use crate::plant::Plant;
use crate::spec::{Entry, Fixed, Node, Parameter, Spec, Value, real, shorten};

/// What stands at a key, and where the key is.
type Given<'a> = BTreeMap<&'a str, (Place, &'a Node)>;

/// Reads the campaign of a controller and its plant.
///
/// # Errors
/// Every mistake in the tables.
pub fn read(entries: &[Entry], spec: &Spec, plant: &Plant) -> Result<Campaign, Vec<Diagnostic>> {
    let mut reader = Reader { spec, plant, found: Diagnostics::default() };
    let table = |name: &str| -> Vec<&Entry> {
        let own = |entry: &&Entry| entry.key.split_once('.').is_some_and(|(own, _)| own == name);
        entries.iter().filter(own).collect()
    };
    let of_verify = reader.table(&table("verify"));
    let of_disturbance = reader.table(&table("disturbance"));
    let mut objectives = Vec::new();
    for index in 0.. {
        let own = table(&format!("objective[{index}]"));
        if own.is_empty() {
            break;
        }
        let given = reader.table(&own);
        objectives.extend(reader.objective(index, &given));
    }
    if objectives.is_empty() && reader.found.is_empty() {
        let message = "the design has no objective to verify";
        let help = "write `[[objective]]`, and under it `bound = \"state\"` and `sigma = 4`";
        reader.found.push("missing-key", "objective", None, message, help);
    }
    let disturbances = reader.disturbances(&of_disturbance);
    let campaign = reader.campaign(&of_verify, disturbances, objectives);
    reader.found.finish(campaign)
}

struct Reader<'a> {
    spec: &'a Spec,
    plant: &'a Plant,
    found: Diagnostics,
}

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
        let name = key.split_once('.').map_or(key, |(_, name)| name);
        let meant = near_miss(name, legal.iter().map(String::as_str));
        let meant = meant.map(|meant| format!("did you mean `{meant}`? ")).unwrap_or_default();
        let help = format!("{meant}the keys are {}", legal.join(", "));
        let message = format!("unknown key `{}`", shorten(key));
        self.found.push("unknown-key", key, Some(place), message, help);
    }

    fn campaign(
        &mut self,
        given: &Given<'_>,
        disturbances: Vec<(Parameter, Interval, Vec<Signal>)>,
        objectives: Vec<Objective>,
    ) -> Option<Campaign> {
        let n = self.spec.n;
        let states: Vec<_> = (1..=n).map(|j| format!("x{j}")).collect();
        let legal: Vec<_> =
            states.iter().cloned().chain(KEYS.iter().map(|info| info.key.to_owned())).collect();
        for (name, (place, _)) in given {
            if !legal.iter().any(|key| key == name) {
                self.unknown(&format!("verify.{name}"), *place, &legal);
            }
        }
        let missing: Vec<_> =
            states.iter().filter(|name| !given.contains_key(name.as_str())).cloned().collect();
        if !missing.is_empty() {
            let message = format!("[verify] has no interval of {}", missing.join(", "));
            let help = format!(
                "give the box of initial states: one [least, greatest] for each of x1..x{n}"
            );
            self.found.push("missing-key", "verify", None, message, help);
        }
        let x0 = states.iter().filter_map(|name| self.interval("verify", name, given)).collect();
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
        let until = self.until(given, tau);
        let tolerance = self.number("tolerance", given, &|t| t > 0.0).unwrap_or(1e-6);
        let varies: BTreeSet<_> = disturbances.iter().map(|(symbol, ..)| *symbol).collect();
        let constant = self.plant.bounds.iter().filter(|(symbol, _)| !varies.contains(symbol));
        let intervals = constant
            .filter_map(|(symbol, (low, high))| Some((*symbol, (to_f64(low)?, to_f64(high)?))))
            .collect();
        let mut spec = self.spec.clone();
        if given.contains_key("tau") {
            spec.fixed.remove(&Parameter::Tau);
        }
        let campaign = Campaign {
            spec,
            plant: self.plant.clone(),
            scenarios: scenarios?,
            seed: seed?,
            search: usize::try_from(search?).ok()?,
            until: until?,
            tolerance,
            tau: tau?,
            x0,
            intervals,
            disturbances,
            objectives,
        };
        self.complete(&campaign);
        Some(campaign)
    }

    /// Every symbol has a value or an interval.
    fn complete(&mut self, campaign: &Campaign) {
        let drawn: BTreeSet<_> = campaign
            .intervals
            .iter()
            .map(|(symbol, _)| *symbol)
            .chain(campaign.disturbances.iter().map(|(symbol, ..)| *symbol))
            .chain([Parameter::Tau, Parameter::Eps, Parameter::StartTime, Parameter::UMax])
            .collect();
        let of_objectives = campaign.objectives.iter().flat_map(Objective::parameters);
        let mut needed: BTreeSet<_> = self.spec.parameters().into_iter().collect();
        needed.extend(self.plant.symbols(self.spec));
        needed.extend(of_objectives);
        let missing: Vec<_> = needed
            .into_iter()
            .filter(|p| !self.spec.fixed.contains_key(p) && !self.plant.fixed.contains_key(p))
            .filter(|p| !drawn.contains(p))
            .map(Parameter::spelling)
            .collect();
        if !missing.is_empty() {
            let message = format!("{} without a value in the design", missing.join(", "));
            let help = "parameters of the controller have their values under [params], gains at `gains` or `poles`; symbols of the plant have theirs, or [least, greatest], under [plant]";
            self.found.push("missing-key", "verify", None, message, help);
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

    /// `[least, greatest]`, or one number for both.
    fn interval(&mut self, table: &str, name: &str, given: &Given<'_>) -> Option<Interval> {
        let (_, node) = given.get(name)?;
        let ends = match &node.value {
            Value::List(items) => match items.as_slice() {
                [low, high] => number(low).zip(number(high)),
                _ => None,
            },
            _ => number(node).map(|value| (value, value)),
        };
        match ends {
            Some((low, high)) if low <= high => return Some((low, high)),
            Some((low, high)) => self.wrong(
                &format!("{table}.{name}"),
                Some(node.place),
                format!("the interval of {name} is empty: {low} > {high}"),
                "an interval is [least, greatest]",
            ),
            None => self.wrong(
                &format!("{table}.{name}"),
                Some(node.place),
                format!("{table}.{name} is no interval"),
                "an interval is [least, greatest] of finite numbers, or one number",
            ),
        }
        None
    }

    fn integer(
        &mut self,
        key: &'static str,
        given: &Given<'_>,
        (least, most): (u64, u64),
        otherwise: u64,
    ) -> Option<u64> {
        let Some((_, node)) = given.get(key) else { return Some(otherwise) };
        let value = real(node).and_then(|value| value.number().cloned());
        let whole = value.filter(|value| value.is_integer()).and_then(|value| value.to_u64());
        let legal = whole.filter(|value| (least..=most).contains(value));
        if legal.is_none() {
            self.legal(key, node.place);
        }
        legal
    }

    fn number(
        &mut self,
        key: &'static str,
        given: &Given<'_>,
        legal: &dyn Fn(f64) -> bool,
    ) -> Option<f64> {
        let (_, node) = given.get(key)?;
        let value = number(node).filter(|value| legal(*value));
        if value.is_none() {
            self.legal(key, node.place);
        }
        value
    }

    fn legal(&mut self, key: &'static str, place: Place) {
        let info = KEYS.iter().find(|info| info.key == key);
        let legal = info.map_or("", |info| info.legal);
        self.wrong(
            &format!("verify.{key}"),
            Some(place),
            format!("verify.{key} is not legal"),
            &format!("{key} is {legal}"),
        );
    }
}

fn number(node: &Node) -> Option<f64> {
    real(node).as_ref().and_then(to_f64).filter(|value| value.is_finite())
}

fn to_f64(value: &Fixed) -> Option<f64> {
    value.number().and_then(ToPrimitive::to_f64)
}
