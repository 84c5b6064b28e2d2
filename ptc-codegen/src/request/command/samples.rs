//! The flags of a clock in samples.

use num_traits::Zero;

use super::{list, rows_word, word, written};
use crate::algebra::BigRational;
use crate::linear::{Disturbance, Linear, Schedule};
use crate::parameter::Parameter;
use crate::request::{Flight, Gate, Keep, Lasting, Late, LeastEnergy, Observer, Sampled, Spec};
use crate::syntax::constant;

impl Spec {
    pub(super) fn sampled_words(&self, sampled: &Sampled) -> Vec<String> {
        if let Some(keep) = &sampled.keep {
            return keep_words(keep);
        }
        let mut words = vec!["--clock samples".to_owned()];
        if let Some(plant) = &sampled.linear {
            words.extend(self.linear_words(plant, sampled));
        }
        // A list of a pole for each state and each sample of delay extends by itself.
        let named = self.written.get("poles").is_some_and(|own| own.starts_with(LeastEnergy::NAME));
        if sampled.predicts() || (sampled.late_states() > 0 && named) {
            words.push(word("--delay-law", &sampled.delay_law.name()));
        }
        let deadbeat = self.fixed.get(&Parameter::Deadbeat);
        words.extend(deadbeat.map(|count| word("--deadbeat", count)));
        words.extend(sampled.end.iter().flat_map(|end| {
            let poles = format!("--poles-end=\"{}\"", end.law);
            [poles, format!("--end-samples={}", end.samples)]
        }));
        words.extend(sampled.flight.iter().flat_map(|flight| self.flight_words(flight)));
        if sampled.linear.is_none() && sampled.measured < self.n {
            let names: Vec<_> = (1..=sampled.measured).map(|j| format!("x{j}")).collect();
            words.push(format!("--measured={}", names.join(",")));
        }
        words.extend(sampled.disturbance.as_ref().map(|own| match own {
            Disturbance::Constant | Disturbance::Ramp => format!("--disturbance {own}"),
            Disturbance::Sine(_) => format!("--disturbance=\"{own}\""),
        }));
        if let Some(observer) = &sampled.observer {
            words.extend(self.observer_words(observer));
        }
        words
    }

    /// The flags of a deadline that may change.
    fn flight_words(&self, flight: &Flight) -> Vec<String> {
        let late = (flight.late != Late::Clip).then(|| word("--late", &flight.late.name()));
        let mut words: Vec<_> = late.into_iter().collect();
        if words.is_empty() {
            words.push("--in-flight".to_owned());
        }
        words.extend(flight.soonest.then(|| word("--pace", &"soonest")));
        let own = self.axes.as_ref().map(|axes| &axes.state_max).filter(|rows| !rows.is_empty());
        words.extend(match own {
            Some(rows) => Some(rows_word("--state-max", rows.iter().map(Vec::as_slice))),
            None => list(flight.state_max.iter()).map(|all| word("--state-max", &all)),
        });
        if !flight.reserve.is_zero() {
            words.push(word("--reserve", &constant::text(&flight.reserve)));
        }
        words
    }

    fn observer_words(&self, observer: &Observer) -> Vec<String> {
        let mut words = Vec::new();
        if let Some(round) = &observer.round {
            let poles = self.list_written("observer_poles", || written(&round.poles));
            words.push(word("--observer-poles", &poles));
            words.extend(round.samples.map(|samples| format!("--observer-samples={samples}")));
            words.extend(round.eps.iter().map(|eps| word("--observer-eps", eps)));
        }
        match &observer.lasting {
            Lasting::Held => {}
            Lasting::Poles(poles) => {
                let poles = self.list_written("after_observer", || written(poles));
                words.push(word("--after-observer", &poles));
            }
            Lasting::Stationary(own) => {
                let key = if observer.round.is_some() { "after-observer" } else { "observer" };
                words.push(format!("--{key}=stationary"));
                words.push(word("--disturbance-walk", &own.walk));
            }
        }
        words.extend(gate_words(&observer.gate));
        words
    }

    /// The flags of a linear plant.
    fn linear_words(&self, plant: &Linear, sampled: &Sampled) -> Vec<String> {
        let mut words = Vec::new();
        let row = |row: &[BigRational]| {
            let entries: Vec<_> = row.iter().map(constant::text).collect();
            format!("[{}]", entries.join(","))
        };
        let rows = |rows: &[Vec<BigRational>]| {
            format!("[{}]", rows.iter().map(|own| row(own)).collect::<Vec<_>>().join(","))
        };
        let row_of = |key, numbers: &[BigRational]| match self.written.get(key) {
            Some(text) => format!("[{text}]"),
            None => row(numbers),
        };
        let rows_of = |key, numbers: &[Vec<BigRational>]| {
            let text = self.written.get(key).filter(|text| text.starts_with('['));
            text.cloned().unwrap_or_else(|| rows(numbers))
        };
        let (a, b) = (rows_of("A", &plant.a), row_of("B", &plant.b));
        words.push(format!("--A=\"{a}\" --B=\"{b}\""));
        if !plant.measures_states() {
            words.push(format!("--C=\"{}\"", rows_of("C", &plant.c)));
        }
        words.extend(self.written.get("states").map(|names| format!("--states={names}")));
        let follows = sampled.follows.as_ref();
        words.extend(follows.map(|own| format!("--output=\"{}\"", row_of("output", own.output()))));
        words
    }
}

/// The flags of a table of gains.
pub(super) fn schedule_words(schedule: &Schedule) -> Vec<String> {
    let poles = LeastEnergy { weight: schedule.weights.law };
    let bytes = schedule.bytes.map(|bytes| format!("--gain-bytes={bytes}"));
    std::iter::once(word("--poles", &poles)).chain(bytes).collect()
}

/// The flags of a filter, which implies the clock and the mapping.
fn keep_words(keep: &Keep) -> Vec<String> {
    let bounds = [
        ("--keep-below", &keep.below),
        ("--keep-above", &keep.above),
        ("--keep-tolerance", &keep.tolerance),
    ];
    let bounds = bounds.into_iter().filter_map(|(flag, all)| Some(word(flag, &list(all.iter())?)));
    let poles: Vec<_> = keep.poles.iter().map(constant::text).collect();
    let poles = word("--keep-poles", &poles.join(","));
    let law = (keep.law.weight > 0).then(|| format!("--poles=\"{}\"", keep.law));
    bounds.chain([poles]).chain(law).collect()
}

/// The flags of the gate of an observer.
fn gate_words(gate: &Gate) -> Vec<String> {
    let bounds = [("--innovation-max", &gate.innovation), ("--measurement-max", &gate.range)];
    let bounds = bounds.into_iter().filter_map(|(flag, all)| Some(word(flag, &list(all.iter())?)));
    bounds.chain(gate.coasts().then(|| format!("--coast={}", gate.coast))).collect()
}
