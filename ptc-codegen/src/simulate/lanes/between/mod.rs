//! The plants of all lanes over the time between two samples, where a run by itself integrates them: by the one step
//! that this takes as a rule. What takes more, or comes to a kink, is left to the run by itself.

mod accelerations;
mod kinks;
mod step;
mod tableau;
#[cfg(test)]
mod tests;

use super::along::Abreast;
use super::flow::Which;
use super::plants::Times;
use crate::program::Value;
use crate::program::lanes::Pack;
use crate::request::MAX_ORDER;
use crate::simulate::pass::share;
use crate::simulate::plant::Motion;
use crate::simulate::process::is_at_rest;
use crate::simulate::{Failure, Values};
use accelerations::Accelerations;
use kinks::Kinks;
use step::Step;

/// The rates of the plants of all lanes.
#[derive(Clone, Debug)]
pub(super) struct Motions {
    rates: Rates,
    step: Step,
}

/// The compiled rates, and the kinks that their values are held against.
#[derive(Clone, Debug)]
struct Rates {
    along: Abreast,
    values: Vec<Value>,
    /// The rates of a mechanical plant, which follow from the values.
    accelerations: Option<Accelerations>,
    u: Vec<Pack>,
    kinks: Kinks,
    /// True if what parameters decide is not computed yet.
    is_due: bool,
}

/// The time of a step in every lane.
struct Span {
    from: Pack,
    length: Pack,
}

impl Motions {
    /// `None` where no step moves the plant, or where it does not run in lanes.
    pub(super) fn of(motion: &Motion) -> Option<Self> {
        if !motion.is_integrated() {
            return None;
        }
        let ((program, kinks), mechanics) = (motion.program(), motion.mechanics());
        let operands = kinks.iter().flat_map(|kink| kink.operands());
        let outputs: Vec<_> = program.watched.iter().copied().chain(operands).collect();
        let rates = Rates {
            along: Abreast::new(program, &outputs, MAX_ORDER)?,
            values: program.watched.clone(),
            accelerations: mechanics.map(Accelerations::new),
            u: Vec::new(),
            kinks: Kinks::new(kinks, mechanics.is_some()),
            is_due: true,
        };
        Some(Self { rates, step: Step::new(motion.order()) })
    }

    /// Begins a run in a lane.
    pub(super) fn start(
        &mut self,
        lane: usize,
        values: &Values,
        x0: &[f64],
    ) -> Result<(), Failure> {
        self.rates.is_due = true;
        self.rates.along.start(lane, values, x0)
    }

    /// Other values of a lane from here on.
    pub(super) fn give(&mut self, lane: usize, values: &Values) -> Result<(), Failure> {
        self.rates.is_due = true;
        self.rates.along.give(lane, values)
    }

    /// Moves the states of some lanes, and writes them to `into`; the lanes in which one step is all.
    pub(super) fn after(
        &mut self,
        x: &[Pack],
        u: &[Pack],
        times: &Times,
        lanes: &Which,
        into: &mut [Pack],
    ) -> Which {
        let Self { rates, step } = self;
        rates.begin(x.len(), u);
        let length = Pack::of(|lane| times.to.0[lane] - times.from.0[lane]);
        let span = Span { from: times.from, length };
        let mut at =
            |part: f64, state: &[Pack], into: &mut [Pack]| rates.at(&span, part, state, into);
        let error = step.take(x, &mut at);
        if rates.kinks.any() {
            rates.watch(step, x, &span);
        }
        let end = step.end();
        let all = std::array::from_fn(|lane| {
            let own = |pack: &Pack| pack.0[lane];
            let finite = end.iter().all(|x| own(x).is_finite());
            let rests = is_at_rest(x.iter().map(own), u.iter().map(own));
            lanes[lane] && finite && !rests && error.0[lane] <= 1.0 && rates.kinks.keep(lane)
        });
        into.iter_mut().zip(end).for_each(|(into, end)| into.take(end, &all));
        all
    }
}

impl Rates {
    /// Before a step under some inputs.
    fn begin(&mut self, states: usize, u: &[Pack]) {
        if self.is_due {
            self.along.settle();
            self.is_due = false;
        }
        self.along.inputs(states, u);
        self.u.clear();
        self.u.extend_from_slice(u);
        self.kinks.begin();
    }

    /// The rates at a part of a span, times its length.
    fn at(&mut self, span: &Span, part: f64, state: &[Pack], into: &mut [Pack]) {
        self.look(span, part, state);
        let scaled = |rate: &Pack| Pack::of(|lane| span.length.0[lane] * rate.0[lane]);
        if let Some(accelerations) = &self.accelerations {
            let rates = accelerations.rates(state);
            into.iter_mut().zip(rates).for_each(|(into, rate)| *into = scaled(rate));
            return;
        }
        for (into, value) in into.iter_mut().zip(&self.values) {
            *into = scaled(self.along.lanes.get(*value));
        }
    }

    /// Computes all at a part of a span.
    fn look(&mut self, span: &Span, part: f64, state: &[Pack]) {
        let time = Pack::of(|lane| span.from.0[lane] + span.length.0[lane] * part);
        self.along.at(&time, state);
        if let Some(accelerations) = &mut self.accelerations {
            accelerations.solve(&self.along.lanes, &self.u);
        }
        let determinant = self.accelerations.as_ref().map(|own| &own.determinant);
        self.kinks.pass(&self.along.lanes, determinant);
    }

    /// Looks for kinks within a step.
    fn watch(&mut self, step: &mut Step, x: &[Pack], span: &Span) {
        step.densify(x, &mut |part, state, into| self.at(span, part, state, into));
        self.kinks.note(kinks::LAST);
        for node in 1..kinks::LAST {
            let part = share(node);
            self.look(span, part, step.within(part));
            self.kinks.note(node);
        }
    }
}
