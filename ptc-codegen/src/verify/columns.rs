//! Columns of the rows of a campaign: their names and units, and the numbers of a scenario.

use super::course::{PIECES, share};
use super::{Campaign, Course, GAIN, Interval, Outcome, Scenario, Signal};
use crate::parameter::Parameter;
use crate::plot::Quantity;

/// Column of the seed of what sensors and sampling draw.
const SEED: &str = "seed";

/// Columns of one disturbance. Names of symbols have no dot, so that no other column has one of these names.
struct SignalColumns<'a> {
    symbol: Parameter,
    bounds: Interval,
    legal: &'a [Signal],
}

impl SignalColumns<'_> {
    /// Returns true if any of the signals may be drawn.
    fn draws(&self, signals: &[Signal]) -> bool {
        signals.iter().any(|signal| self.legal.contains(signal))
    }

    fn quantities(&self) -> Vec<Quantity> {
        let name = self.symbol.spelling();
        let named = |what: &str| Quantity::plain(format!("{name}.{what}"));
        let mut all = vec![named("signal")];
        if self.draws(&[Signal::Constant]) {
            all.push(named("value"));
        }
        if self.draws(&[Signal::Sine, Signal::Square]) {
            all.push(Quantity { unit: Some("1/tau".to_owned()), ..named("periods") });
            all.push(Quantity { unit: Some("turn".to_owned()), ..named("phase") });
        }
        if self.draws(&[Signal::Random, Signal::Worst]) {
            all.extend((1..=PIECES).map(|piece| named(&piece.to_string())));
        }
        all
    }

    /// Returns the numbers of a signal; those that it does not have are NaN.
    fn numbers(&self, course: &Course, until: f64) -> Vec<f64> {
        let mut numbers = vec![course.signal().code()];
        if self.draws(&[Signal::Constant]) {
            numbers.push(if let Course::Constant(value) = course { *value } else { f64::NAN });
        }
        if self.draws(&[Signal::Sine, Signal::Square]) {
            numbers.extend(match course {
                Course::Sine(periods, phase) => [*periods, *phase],
                Course::Square(halves, phase) => [0.5 * halves, *phase],
                _ => [f64::NAN; 2],
            });
        }
        if self.draws(&[Signal::Random, Signal::Worst]) {
            let middle = |piece| 0.5 * (share(until, piece) + share(until, piece + 1));
            numbers.extend((0..PIECES).map(|piece| match course {
                Course::Random(_) | Course::Worst { .. } => {
                    course.value(self.bounds, until, middle(piece))
                }
                _ => f64::NAN,
            }));
        }
        numbers
    }
}

impl Campaign {
    /// Returns the columns of a row, after the index, with their units where the design gives them.
    pub fn quantities(&self) -> Vec<Quantity> {
        let named = |name: &str| Quantity::plain(name);
        let seconds = |name: &str| Quantity { unit: Some("s".to_owned()), ..named(name) };
        let mut all = vec![seconds("tau")];
        let of_state = |state: Quantity| Quantity { name: format!("{}_0", state.name), ..state };
        all.extend(Quantity::states(&self.spec).into_iter().map(of_state));
        all.extend(self.intervals.iter().map(|(symbol, _)| named(&symbol.spelling())));
        all.extend(self.gains().map(|_| named(GAIN)));
        all.extend(self.events.uncertain().map(|own| named(&own.name)));
        all.extend(self.signal_columns().flat_map(|own| own.quantities()));
        all.extend(self.is_drawn().then(|| named(SEED)));
        let objectives = 1..=self.objectives.len();
        all.extend(objectives.clone().map(|i| named(&format!("excess{i}"))));
        if self.has_sides() {
            all.extend(objectives.map(|i| named(&format!("excess{i}_direct"))));
            all.push(named("difference"));
        }
        all.push(named("status"));
        all
    }

    /// The columns of each disturbance.
    fn signal_columns(&self) -> impl Iterator<Item = SignalColumns<'_>> {
        self.disturbances.iter().map(|(symbol, bounds, legal)| SignalColumns {
            symbol: *symbol,
            bounds: *bounds,
            legal,
        })
    }

    /// Returns the names of these.
    pub fn columns(&self) -> Vec<String> {
        self.quantities().into_iter().map(|own| own.name).collect()
    }

    /// Returns the place of the kind of signal of a disturbance in a row.
    pub(super) fn place_of_signal(&self, disturbance: usize) -> usize {
        let before = self.signal_columns().take(disturbance).map(|own| own.quantities().len());
        self.sides().count() + before.sum::<usize>()
    }

    /// Returns the numbers of a scenario and its outcome, one for each column.
    pub fn numbers(&self, scenario: &Scenario, outcome: Outcome) -> Vec<f64> {
        let status = outcome.status().code();
        let mut numbers = Vec::with_capacity(scenario.point.len() + 2 * outcome.excess.len() + 2);
        numbers.extend(&scenario.point);
        let signals = self.signal_columns().zip(&scenario.courses);
        let until = self.span();
        numbers.extend(signals.flat_map(|(own, course)| own.numbers(course, until)));
        // Seeds are below 2^53.
        #[allow(clippy::cast_precision_loss)]
        numbers.extend(self.is_drawn().then_some(scenario.seed as f64));
        numbers.extend(outcome.excess);
        if let Some(direct) = outcome.direct {
            numbers.extend(direct.excess);
            numbers.push(direct.difference);
        }
        numbers.push(status);
        numbers
    }
}
