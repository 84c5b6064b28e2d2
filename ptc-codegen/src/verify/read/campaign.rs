//! The keys of `[verify]`, and the campaign that all tables make.

use std::collections::BTreeSet;

use super::super::{Campaign, Interval, Objective};
use super::value::to_f64;
use super::{Disturbances, Drawn, Given, Reader};
use crate::keys::verify::KEYS;
use crate::parameter::Parameter;
use crate::simulate::{Events, Loop};
use crate::syntax::number as exact;

impl Reader<'_> {
    pub(super) fn campaign(
        &mut self,
        given: &Given<'_>,
        (drawn, disturbances, events): (Drawn, Disturbances, Events),
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
        // States that start at rest need no interval.
        let needed = states.iter().take(n - self.spec.states_at_rest());
        let missing: Vec<_> =
            needed.filter(|name| !given.contains_key(name.as_str())).cloned().collect();
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
        let interval = |(j, name): (usize, &String)| {
            let rests = j + self.spec.states_at_rest() >= n && !given.contains_key(name.as_str());
            if rests { Some((0.0, 0.0)) } else { self.interval("verify", name, given) }
        };
        let x0: Vec<_> = states.iter().enumerate().filter_map(interval).collect();
        let fixed_tau = self.spec.fixed.get(&Parameter::Tau).and_then(to_f64);
        let tau = match (self.interval("verify", "tau", given), fixed_tau) {
            (Some((low, _)), _) if low <= 0.0 => {
                let place = given.get("tau").map(|(_, node)| node.place);
                self.wrong("verify.tau", place, "tau is not > 0".to_owned(), KEYS[0].legal);
                None
            }
            (Some(ends), fixed) => {
                let fits = self.is_open(Parameter::Tau, ends, given);
                (fits || fixed.is_none()).then_some(ends)
            }
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
            Some(around) => self.end(given, tau, (around, &events)),
            None => self.until(given, tau),
        };
        let tolerance = self.number("tolerance", given, &|t| t > 0.0).unwrap_or(1e-6);
        let varies: BTreeSet<_> = disturbances.iter().map(|(symbol, ..)| *symbol).collect();
        let constant = self.plant.bounds.iter().filter(|(symbol, _)| !varies.contains(symbol));
        let constant = constant
            .filter_map(|(symbol, (low, high))| Some((*symbol, (to_f64(low)?, to_f64(high)?))));
        let mut intervals: Vec<_> = constant.collect();
        let mut spec = self.spec.clone();
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
            self.counts_to_one_tau()?;
        }
        // What is both of the controller and of the plant is drawn once.
        let new = |(symbol, _): &(Parameter, _)| !self.plant.bounds.contains_key(symbol);
        intervals.extend(drawn.into_iter().filter(|own| new(own) || varies.contains(&own.0)));
        Some(Campaign {
            design: self.design.clone(),
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
            events,
            integrals: self.integrands(),
            objectives,
        })
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
