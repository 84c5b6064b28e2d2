//! Requirements of a design file, and what it leaves open.

use num_traits::ToPrimitive;

use super::candidate::Candidate;
use super::choice::{Choice, Key, Value};
use super::numbers::Numbers;
use super::probe::Refused;
use super::stand_in::stand_in;
use crate::algebra::polynomial::Polynomial;
use crate::check::examine::{Report, decay, examine};
use crate::check::resolved::Resolved;
use crate::diagnostic::Diagnostic;
use crate::linear::roots;
use crate::parameter::{Fixed, Parameter};
use crate::plant;
use crate::request::{Entry, Feedback, Spec};
use crate::syntax::{self, number};
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
    /// Values in place of the missing ones.
    stand_in: Choice,
    /// The same in samples, where the clock is open and that one is legal too.
    in_samples: Option<Spec>,
}

pub(super) fn gives(entries: &[Entry], keys: &[&str]) -> bool {
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
pub(super) const LAW: &[&str] = &["gains", "poles", "pi0"];

/// The keys that give the mapping.
pub(super) const MAPPING: &[&str] = &["mu", "kappa"];

impl<'a> Wish<'a> {
    /// Reads a wish.
    ///
    /// # Errors
    /// Every mistake in the entries.
    pub fn read(entries: &'a [Entry]) -> Result<Self, Vec<Diagnostic>> {
        let clock = entries.iter().find(|entry| entry.key == "clock");
        let in_samples = clock.is_some_and(
            |entry| matches!(&entry.value.value, syntax::Value::Word(word) if word == SAMPLES),
        );
        let first = stand_in(entries, in_samples)?;
        let (spec, all) = read_spec(entries, &first)?;
        needs_what_it_draws(entries, &spec)?;
        let campaign = campaign_of(&all, &spec)?;
        let mut wish = Self { entries, spec, campaign, stand_in: first, in_samples: None };
        // A clock is chosen with its law, for a loop whose samples are known.
        if clock.is_none() && wish.leaves_law() && wish.campaign.around.is_some() {
            let first = stand_in(entries, true).ok();
            wish.in_samples = first.and_then(|first| {
                let choice = first.word(Key::Clock, SAMPLES);
                let (spec, all) = read_spec(entries, &choice).ok()?;
                campaign_of(&all, &spec).ok()?;
                Some(spec)
            });
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
        self.in_samples.as_ref().map(Spec::loop_order)
    }

    /// The numbers of the loop in samples: of the given clock, or of the one that may be chosen.
    pub(super) fn numbers(&self) -> Option<Numbers> {
        let spec = self.in_samples.as_ref().unwrap_or(&self.spec);
        Numbers::of(spec, self.campaign.tau.0)
    }

    /// Returns true if a key is left open.
    pub(super) fn leaves(&self, key: Key) -> bool {
        !gives(self.entries, &[key.name()])
    }

    /// Returns true if the design cannot be read without a value of a key, which is to be chosen.
    pub(super) fn lacks(&self, key: Key) -> bool {
        self.stand_in.get(key).is_some()
    }

    /// Returns true if the poles of an observer, or the drift that a stationary one assumes, are to be chosen.
    pub fn leaves_observer(&self) -> bool {
        self.lacks(Key::ObserverPoles) || self.lacks(Key::DisturbanceWalk)
    }

    /// Returns true if the end of the law is to be chosen.
    pub(super) fn leaves_end(&self) -> bool {
        !gives(self.entries, &["poles_end", "end_samples", "deadbeat"])
    }

    /// Returns true if something is to be chosen.
    pub fn leaves_something(&self) -> bool {
        self.leaves_mapping() || self.leaves_law() || self.leaves_observer()
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
            if let Some(eps) = eps {
                choice = choice.with(Key::Eps, Value::Number(eps.to_string()));
            }
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

    /// The campaign of a choice.
    ///
    /// # Errors
    /// Why the reader refuses the choice.
    pub(super) fn with(&self, choice: &Choice) -> Result<Campaign, Refused> {
        let read = read_spec(self.entries, choice)
            .and_then(|(spec, all)| verify::read_with_plant(&all, &spec));
        read.map_err(|found| {
            let why = found.first().map(|wrong| wrong.message.clone()).unwrap_or_default();
            Refused::Reader(why)
        })
    }

    /// The check that refuses the design with a choice, if one does.
    pub(super) fn refusal(&self, choice: &Choice) -> Option<Refused> {
        let report = self.examined(choice)?;
        report.refusals().next().cloned().map(Refused::Check)
    }
}

/// Number of poles of each output.
pub(super) fn orders(spec: &Spec) -> Vec<usize> {
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

fn read_spec(entries: &[Entry], choice: &Choice) -> Result<(Spec, Vec<Entry>), Vec<Diagnostic>> {
    let all: Vec<_> = entries.iter().cloned().chain(choice.entries()).collect();
    plant::read_design(&all).map(|(spec, _)| (spec, all))
}

/// The campaign of stand-ins. Its eps is given, as a search for one takes long and nothing depends on it.
fn campaign_of(all: &[Entry], spec: &Spec) -> Result<Campaign, Vec<Diagnostic>> {
    if spec.sampled().is_none() || !spec.leaves_eps() {
        return verify::read_with_plant(all, spec);
    }
    let eps = Choice::default().with(Key::Eps, Value::Number("0".to_owned()));
    let all: Vec<_> = all.iter().cloned().chain(eps.entries()).collect();
    let (spec, _) = plant::read_design(&all)?;
    verify::read_with_plant(&all, &spec)
}
