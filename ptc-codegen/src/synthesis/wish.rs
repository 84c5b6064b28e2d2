//! Requirements of a design file, and what it leaves open.

use num_traits::ToPrimitive;

use super::candidate::Candidate;
use super::probe::Refused;
use crate::algebra::polynomial::Polynomial;
use crate::check::examine::{Report, decay, examine};
use crate::check::resolved::Resolved;
use crate::diagnostic::{Diagnostic, Place};
use crate::keys::KeyInfo;
use crate::linear::roots;
use crate::parameter::{Fixed, Parameter};
use crate::plant;
use crate::request::{self, DelayLaw, Entry, Feedback, Spec};
use crate::syntax::{Node, Value, number, parse};
use crate::verify::{self, Campaign};

/// The clock in samples, as a design spells it.
pub(super) const SAMPLES: &str = "samples";

/// A design file of which the clock, the mapping, the law and eps may be missing.
#[derive(Debug)]
pub struct Wish<'a> {
    entries: &'a [Entry],
    /// The design, with a mapping and poles in place of what is missing.
    spec: Spec,
    campaign: Campaign,
    /// Number of poles in samples, where the clock is open and that one is legal too.
    order_in_samples: Option<usize>,
}

/// Chosen values, as a design file spells them, without those given there.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Choice {
    /// The clock, where it is not that of time.
    pub clock: Option<String>,
    /// The mapping with its rate.
    pub mu: Option<String>,
    /// The poles: one list, or one for each output of a plant whose outputs differ in order.
    pub poles: Option<Vec<Vec<String>>>,
    /// The guard that the sample period or the wanted error requires.
    pub eps: Option<String>,
}

impl Choice {
    /// The poles as the items of a list.
    pub(super) fn poles_text(&self) -> Option<String> {
        let each = self.poles.as_ref()?.iter().map(|own| own.join(", "));
        Some(match each.collect::<Vec<_>>().as_slice() {
            [one] => one.clone(),
            several => format!("[{}]", several.join("], [")),
        })
    }

    fn entries(&self) -> Vec<Entry> {
        let poles = self.poles_text();
        let given =
            [("clock", &self.clock), ("mu", &self.mu), ("poles", &poles), ("eps", &self.eps)];
        let entry = |(key, text): (&str, &Option<String>)| {
            let value = parse(key, text.as_ref()?, &mut |_| NOWHERE).ok()?;
            Some(Entry { key: key.to_owned(), place: NOWHERE, value })
        };
        given.into_iter().filter_map(entry).collect()
    }
}

impl std::fmt::Display for Choice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let clock = self.clock.as_ref().map(|clock| format!("clock = \"{clock}\""));
        let mu = self.mu.as_ref().map(|mu| format!("mu = \"{mu}\""));
        let poles = self.poles_text().map(|poles| format!("poles = [{poles}]"));
        let eps = self.eps.as_ref().map(|eps| format!("eps = {eps}"));
        let all: Vec<_> = [clock, mu, poles, eps].into_iter().flatten().collect();
        f.write_str(&if all.is_empty() { "nothing".to_owned() } else { all.join(", ") })
    }
}

/// The place of what no file holds.
const NOWHERE: Place = Place(usize::MAX);

fn node(value: Value) -> Node {
    Node { value, place: NOWHERE }
}

fn gives(entries: &[Entry], keys: &[&str]) -> bool {
    entries.iter().any(|entry| keys.contains(&entry.key.as_str()))
}

/// Refuses values under [verify] of what is to be chosen, before the stand-ins for it are taken for what the design gives.
fn needs_what_it_draws(entries: &[Entry], spec: &Spec) -> Result<(), Vec<Diagnostic>> {
    let leaves = |keys: &[&str]| !gives(entries, keys);
    let (law, mapping) = (leaves(LAW), leaves(MAPPING));
    let of_mapping = spec.time_mapping.parameters();
    let found = spec.fixed.keys().find_map(|symbol| {
        let name = symbol.spelling();
        let help = match symbol {
            Parameter::Gain(_) if law => {
                "leave it out: `design` chooses the gains, and `verify` takes intervals of them"
                    .to_owned()
            }
            symbol if mapping && of_mapping.contains(symbol) => {
                format!("leave it out, or give a `mu` without {name} in the design")
            }
            _ => return None,
        };
        let key = format!("verify.{name}");
        let place = entries.iter().find(|entry| entry.key == key)?.place;
        let message = format!("`{name}` is to be chosen, and has a value under [verify]");
        Some(Diagnostic { code: "conflict", key, place: Some(place), message, help })
    });
    found.map_or(Ok(()), |found| Err(vec![found]))
}

/// The keys that give the law.
const LAW: &[&str] = &["gains", "poles", "pi0"];

/// The keys that give the mapping.
const MAPPING: &[&str] = &["mu", "kappa"];

impl<'a> Wish<'a> {
    /// Reads a wish.
    ///
    /// # Errors
    /// Every mistake in the entries.
    pub fn read(entries: &'a [Entry]) -> Result<Self, Vec<Diagnostic>> {
        let clock = entries.iter().find(|entry| entry.key == "clock");
        let in_samples = clock.is_some_and(
            |entry| matches!(&entry.value.value, Value::Word(word) if word == SAMPLES),
        );
        let first = stand_in(entries, in_samples)?;
        let (spec, all) = read_spec(entries, &first)?;
        needs_what_it_draws(entries, &spec)?;
        let campaign = verify::read_with_plant(&all, &spec)?;
        let mut wish = Self { entries, spec, campaign, order_in_samples: None };
        // A clock is chosen with its law, for a loop whose samples are known.
        if clock.is_none() && wish.leaves_law() && wish.campaign.around.is_some() {
            let first = stand_in(entries, true).ok();
            let legal = first.and_then(|first| {
                let choice = Choice { clock: Some(SAMPLES.to_owned()), ..first };
                read(entries, &choice).ok()
            });
            wish.order_in_samples = legal.map(|(spec, _)| spec.loop_order());
        }
        Ok(wish)
    }

    /// Returns the campaign to verify, with a mapping and poles in place of the missing ones.
    pub fn campaign(&self) -> &Campaign {
        &self.campaign
    }

    /// Number of poles of each output: the order n, and in samples the inputs that are under way.
    pub(super) fn orders(&self) -> Vec<usize> {
        orders(&self.spec)
    }

    /// Number of poles in samples, where the clock is to be chosen and may be in samples.
    pub(super) fn order_in_samples(&self) -> Option<usize> {
        self.order_in_samples
    }

    /// Returns true if the given clock is in samples.
    pub fn is_in_samples(&self) -> bool {
        self.spec.sampled().is_some()
    }

    /// Returns true if the mapping is to be chosen.
    pub fn leaves_mapping(&self) -> bool {
        !gives(self.entries, MAPPING)
    }

    /// Returns true if the poles are to be chosen.
    pub fn leaves_law(&self) -> bool {
        !gives(self.entries, LAW)
    }

    /// The distance of the slowest pole of the given law from 0; 1 where that is not known.
    pub(super) fn slowest_pole(&self) -> f64 {
        let of = |spec: &Spec| -> f64 {
            let gain = |i| spec.fixed.get(&Parameter::Gain(i)).and_then(Fixed::number).cloned();
            let gains: Option<Vec<_>> = (1..=spec.loop_order()).map(gain).collect();
            let gains = gains.filter(|_| spec.feedback == Feedback::Linear);
            let poles = gains.and_then(|gains| roots(&Polynomial::characteristic(&gains)));
            let poles = poles.unwrap_or_default();
            poles.iter().map(|pole| -pole.re).fold(f64::INFINITY, f64::min)
        };
        let slowest = self.spec.designs().iter().map(of).fold(f64::INFINITY, f64::min);
        if slowest > 0.0 && slowest.is_finite() { slowest } else { 1.0 }
    }

    /// The rate of the given mapping, and the decay rate of its mu' at a rate of 1.
    pub(super) fn rate(&self) -> (f64, f64) {
        let decay = decay(&self.spec).greatest().and_then(|rate| rate.to_f64()).unwrap_or(0.0);
        let rate = self.spec.fixed.get(&Parameter::A).and_then(Fixed::number);
        match rate.and_then(ToPrimitive::to_f64) {
            Some(rate) if self.spec.family().is_some() => (rate, decay / rate),
            _ if decay > 0.0 => (decay, 1.0),
            _ => (1.0, 0.0),
        }
    }

    /// A candidate at a speed, with the guard that goes with it.
    pub(super) fn choice(&self, candidate: &Candidate, speed: f64) -> Choice {
        let mut choice = candidate.at(speed);
        let promises = &self.spec.promises;
        let asked = promises.sample_time.is_some() || !promises.error.is_empty();
        if asked && self.spec.leaves_eps() {
            let resolved = self.least(&choice).map(|spec| Resolved::of(&spec).spec);
            let eps = resolved.and_then(|spec| spec.fixed.get(&Parameter::Eps).cloned());
            choice.eps = eps.map(|eps| eps.to_string());
        }
        choice
    }

    /// The speeds of a candidate at which no check refuses it. The faster the poles, the shorter is
    /// the sample period that they need and the greater are the gains.
    pub(super) fn admitted(&self, candidate: &Candidate) -> (f64, f64) {
        let accepts = |speed: f64| {
            let report = self.examined(&self.choice(candidate, speed));
            report.is_some_and(|report| report.refusals().next().is_none())
        };
        let (slowest, fastest) = candidate.range;
        if accepts(fastest) {
            return candidate.range;
        }
        let Some(mut good) = [candidate.first, slowest].into_iter().find(|s| accepts(*s)) else {
            return (candidate.first, candidate.first);
        };
        let mut bad = fastest;
        while bad > 1.02 * good {
            let middle = (good * bad).sqrt();
            *(if accepts(middle) { &mut good } else { &mut bad }) = middle;
        }
        (slowest, good)
    }

    /// The checks of the design with a choice, for the least tau that it is used with.
    fn examined(&self, choice: &Choice) -> Option<Report> {
        self.least(choice).map(|spec| examine(&spec))
    }

    /// The design with a choice, for the least tau that it is used with.
    fn least(&self, choice: &Choice) -> Option<Spec> {
        let (mut spec, _) = read_spec(self.entries, choice).ok()?;
        if let Some(tau) = number(&format!("{:e}", self.campaign.tau.0)) {
            spec.fixed.entry(Parameter::Tau).or_insert(tau);
        }
        Some(spec)
    }

    /// The campaign of a choice, and why it is none, if it is not.
    pub(super) fn with(&self, choice: &Choice) -> (Campaign, Option<Refused>) {
        match read(self.entries, choice) {
            Ok((_, campaign)) => {
                let report = self.examined(choice);
                let refusal = report.and_then(|report| report.refusals().next().cloned());
                (campaign, refusal.map(Refused::Check))
            }
            Err(found) => {
                let why = found.first().map(|wrong| wrong.message.clone()).unwrap_or_default();
                (self.campaign.clone(), Some(Refused::Guard(why)))
            }
        }
    }
}

/// Number of poles of each output.
fn orders(spec: &Spec) -> Vec<usize> {
    let several = spec.coupled.as_ref().map(|coupled| coupled.orders());
    several.unwrap_or_else(|| vec![spec.loop_order()])
}

/// So many of `poles` for each output; outputs of one order share them.
pub(super) fn for_each(orders: &[usize], pole: &dyn Fn(usize) -> String) -> Vec<Vec<String>> {
    let list = |order: &usize| (0..*order).map(pole).collect();
    match orders {
        [first, others @ ..] if others.iter().all(|order| order == first) => vec![list(first)],
        all => all.iter().map(list).collect(),
    }
}

/// A mapping and poles in place of what is missing.
///
/// # Errors
/// A model of which no orders follow.
fn stand_in(entries: &[Entry], in_samples: bool) -> Result<Choice, Vec<Diagnostic>> {
    let mu = (!gives(entries, MAPPING)).then(|| "exp(a=1)".to_owned());
    let mut choice = Choice { mu, ..Choice::default() };
    if gives(entries, LAW) {
        return Ok(choice);
    }
    let of_model =
        |entry: &Entry| KeyInfo::find(&entry.key).and_then(KeyInfo::table) == Some("model");
    if entries.iter().any(of_model) {
        // A law without poles, from which the number of poles of each output follows.
        let entry =
            |key: &str, value| Entry { key: key.to_owned(), place: NOWHERE, value: node(value) };
        let law = match (in_samples, gives(entries, &["inputs"])) {
            (true, _) => (!gives(entries, &["clock"]))
                .then(|| entry("clock", Value::Word(SAMPLES.to_owned()))),
            (false, true) => Some(entry("pi0", Value::Word("extern".to_owned()))),
            (false, false) => {
                let xi = node(Value::Word("xi1".to_owned()));
                Some(entry("pi0", Value::Negative(Box::new(xi))))
            }
        };
        let all: Vec<_> = entries.iter().cloned().chain(choice.entries()).chain(law).collect();
        let orders = orders(&request::read(&all)?);
        choice.poles = Some(for_each(&orders, &|i| format!("-{}", request::MAX_ORDER + 1 + i)));
        return Ok(choice);
    }
    let count = |key: &str| {
        let entry = entries.iter().find(|entry| entry.key == key)?;
        match &entry.value.value {
            Value::Number(value) => value.number()?.ceil().to_usize(),
            _ => None,
        }
    };
    // A law of a higher order places a pole for each input under way too.
    let extends = entries.iter().any(|entry| {
        entry.key == "delay_law" && entry.value.value == Value::Word(DelayLaw::EXTEND.to_owned())
    });
    let late = if in_samples && extends { count("delay").unwrap_or(0) } else { 0 };
    let late = late.min(request::MAX_ORDER);
    let order = count("n").unwrap_or(1).clamp(1, request::MAX_ORDER) + late;
    choice.poles = Some(for_each(&[order], &|i| format!("-{}", order + 1 + i)));
    Ok(choice)
}

fn read_spec(entries: &[Entry], choice: &Choice) -> Result<(Spec, Vec<Entry>), Vec<Diagnostic>> {
    let all: Vec<_> = entries.iter().cloned().chain(choice.entries()).collect();
    plant::read_design(&all).map(|(spec, _)| (spec, all))
}

fn read(entries: &[Entry], choice: &Choice) -> Result<(Spec, Campaign), Vec<Diagnostic>> {
    let (spec, all) = read_spec(entries, choice)?;
    let campaign = verify::read_with_plant(&all, &spec)?;
    Ok((spec, campaign))
}
