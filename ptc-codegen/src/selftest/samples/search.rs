//! The search for sets of parameters and for calls that take each branch.

use super::super::Draw;
use super::commands::Request;
use super::inputs::{Ends, anything, arriving};
use super::parameters::Sets;
use super::{Call, Session};
use crate::code::{Code, Instance, Status, Taken};
use crate::parameter::{Fixed, Parameter};
use crate::program::number::settle;
use crate::request::{Guard, Spec, What};

/// Random sets of parameters that are tried.
const SETS: usize = 3000;

/// Random calls that are tried with each set that is looked at closely.
const CALLS: usize = 400;

/// A measurement above which the next call meets a controller that begins anew.
const LARGE: f64 = 1e6;

/// Most readings that are lost in a row.
const LOST: u32 = 64;

/// State of the search.
pub(super) struct Search<'a> {
    pub(super) spec: &'a Spec,
    pub(super) code: &'a Code,
    pub(super) choice: Sets<'a>,
    /// Numbers that are measured, and those of the reference that a call is given.
    measured: usize,
    references: usize,
    pub(super) draw: Draw,
    pub(super) sessions: Vec<Session>,
    pub(super) refused: Vec<Vec<f64>>,
    pub(super) taken: Taken,
    /// Sets of parameters and calls that were tried.
    pub(super) sets: usize,
    pub(super) tried: usize,
}

/// A controller between two calls, and the calls so far.
#[derive(Clone)]
pub(super) struct Life {
    instance: Instance,
    /// The branches that `init` took.
    begun: Taken,
    session: Session,
    start: u32,
    pub(super) ends: Ends,
}

/// Arguments of a call.
#[derive(Default)]
pub(super) struct Input {
    pub(super) start: Option<u32>,
    pub(super) before: Option<Request>,
    pub(super) elapsed: u32,
    pub(super) y: Vec<f64>,
    pub(super) applied: f64,
}

impl<'a> Search<'a> {
    pub(super) fn new(spec: &'a Spec, code: &'a Code) -> Self {
        Self {
            spec,
            code,
            choice: Sets::new(spec),
            measured: spec.sampled().map_or(0, |sampled| sampled.measured),
            references: spec.references() * spec.axes.as_ref().map_or(1, |axes| axes.count),
            draw: Draw(1),
            sessions: Vec::new(),
            refused: Vec::new(),
            taken: Taken::default(),
            sets: 0,
            tried: 0,
        }
    }

    /// A round from tick 0, where `init` arms, and one over which the counter wraps, with what is not
    /// a number in it.
    pub(super) fn round(&mut self) {
        let Some(mut life) = self.begin(&self.choice.usual()) else { return };
        for start in [None, Some(u32::MAX - 2)] {
            for (index, elapsed) in life.ends.ladder().into_iter().enumerate() {
                let start = start.filter(|_| index == 0);
                let y = arriving(self.spec, self.count(), elapsed, life.ends);
                let applied = settle(-0.25 * y[0], self.spec.precision);
                self.ask(&mut life, Input { start, elapsed, y, applied, ..Input::default() }, true);
                if index == 2 && self.spec.guard == Guard::Full {
                    self.without_numbers(&mut life, elapsed);
                    self.without_readings(&mut life, elapsed);
                }
            }
        }
        self.end(life);
    }

    /// Every input alone is no number or infinite: the call is refused, and changes nothing.
    fn without_numbers(&mut self, life: &mut Life, elapsed: u32) {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for j in 0..=self.count() {
                let mut input =
                    Input { elapsed, y: vec![0.5; self.count()], applied: 0.5, ..Input::default() };
                match input.y.get_mut(j) {
                    Some(y) => *y = value,
                    None if self.spec.what == What::Observer => input.applied = value,
                    None => continue,
                }
                self.ask(life, input, true);
            }
        }
    }

    /// Readings that are lost until an observer may predict no longer, and `arm` behind them.
    fn without_readings(&mut self, life: &mut Life, elapsed: u32) {
        let observer = self.spec.sampled().and_then(|sampled| sampled.observer.as_ref());
        let Some(coast) = observer.map(|own| own.gate.coast).filter(|coast| *coast > 0) else {
            return;
        };
        let given = |y: f64| {
            let mut all = vec![0.5; self.count()];
            all[..self.measured].fill(y);
            all
        };
        let lost = (0..=coast.min(LOST)).map(|_| (None, f64::NAN));
        let all = std::iter::once((None, 0.5)).chain(lost).chain([(Some(life.start), 0.25)]);
        let all: Vec<_> = all.map(|(start, y)| (start, given(y))).collect();
        for (start, y) in all {
            self.ask(life, Input { start, elapsed, y, applied: 0.25, ..Input::default() }, true);
        }
    }

    /// Parameters that `init` refuses, and others that it takes by another way.
    pub(super) fn parameters(&mut self) {
        for set in self.choice.edges() {
            self.try_set(set, true);
        }
        for _ in 0..if self.choice.open.is_empty() { 0 } else { SETS } {
            let set = self.choice.anywhere(&mut self.draw);
            self.try_set(set, false);
        }
    }

    fn try_set(&mut self, set: Vec<f64>, alone: bool) {
        self.sets += 1;
        let (built, taken) = self.watched(&set);
        let adds = taken.adds_to(&self.taken);
        match built {
            Err(_) if adds || alone => {
                self.refused.push(set);
                self.taken.extend(&taken);
            }
            Ok(_) if adds => {
                let Some(mut life) = self.begin(&set) else { return };
                let y = vec![0.0; self.count()];
                self.ask(&mut life, Input { y, ..Input::default() }, true);
                self.end(life);
            }
            _ => {}
        }
    }

    /// Calls at every sample at which a gain may change, and random ones, of which those stay that
    /// take a branch no other took.
    pub(super) fn inputs(&mut self) {
        let most = self.spec.precision.greatest();
        let sizes = [0.0, 1e-3, 1.0, 1e3, most.sqrt(), most / 1e6, most];
        for set in std::iter::once(self.choice.usual()).chain(self.choice.others()) {
            let Some(mut life) = self.begin(&set) else { continue };
            for elapsed in life.ends.near() {
                let y = anything(self.spec, self.count(), 1.0, &mut self.draw);
                self.ask(&mut life, Input { elapsed, y, applied: 0.25, ..Input::default() }, false);
            }
            let ticks = [life.ends.ladder(), life.ends.near()].concat();
            for _ in 0..CALLS {
                let size = self.draw.of(&sizes);
                let [before, input] = [(); 2].map(|()| self.any_input(&life, &ticks, size));
                let mut later = life.clone();
                // Some branches are taken from a state alone that is large already.
                let known = self.taken.clone();
                if self.draw.of(&[true, false]) {
                    self.ask(&mut later, before, true);
                }
                if !self.ask(&mut later, input, false) {
                    self.taken = known;
                    continue;
                }
                life = later;
                if size > LARGE {
                    self.end(life);
                    let Some(next) = self.begin(&set) else { return };
                    life = next;
                }
            }
            if self.spec.axes.is_some() {
                self.scattered(&mut life, &ticks, &sizes);
            }
            self.end(life);
        }
    }

    /// Calls of several inputs with states of different sizes, 0 and small whole numbers among them: one input
    /// alone is clipped or no number, and what is divided by may be 0.
    fn scattered(&mut self, life: &mut Life, ticks: &[u32], sizes: &[f64]) {
        for _ in 0..CALLS {
            let mut input = self.any_input(life, ticks, 1.0);
            for y in &mut input.y {
                let size = self.draw.of(sizes);
                let whole = self.draw.of(&[0.0, 0.5, 1.0, 2.0]);
                let of_size = self.draw.of(&[-1.0, 1.0]) * self.draw.between(0.25, 1.0) * size;
                let sign = self.draw.of(&[-1.0, 1.0]);
                *y = settle(self.draw.of(&[sign * whole, of_size]), self.spec.precision);
            }
            self.ask(life, input, false);
        }
    }

    fn any_input(&mut self, life: &Life, ticks: &[u32], size: f64) -> Input {
        Input {
            start: self.draw.of(&[None, Some(life.start), Some(u32::MAX - 5)]),
            elapsed: self.draw.of(ticks),
            y: anything(self.spec, self.count(), size, &mut self.draw),
            applied: settle(self.draw.of(&[0.0, 0.5, size]), self.spec.precision),
            ..Input::default()
        }
    }

    /// Numbers that a call is given in arrays.
    pub(super) fn count(&self) -> usize {
        self.measured + self.references
    }

    fn watched(&self, set: &[f64]) -> (Result<Instance, Status>, Taken) {
        Instance::watched(self.code, self.choice.open.iter().copied().zip(set.iter().copied()))
    }

    /// A controller with these parameters; `None` if `init` refuses them.
    pub(super) fn begin(&self, set: &[f64]) -> Option<Life> {
        let (built, taken) = self.watched(set);
        let instance = built.ok()?;
        let session = Session { parameters: set.to_vec(), calls: Vec::new() };
        Some(Life { instance, begun: taken, session, start: 0, ends: self.ends(set) })
    }

    /// A session without calls tests nothing.
    pub(super) fn end(&mut self, life: Life) {
        if !life.session.calls.is_empty() {
            self.taken.extend(&life.begun);
            self.sessions.push(life.session);
        }
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn ends(&self, set: &[f64]) -> Ends {
        let at = self.choice.open.iter().position(|open| *open == Parameter::Samples);
        let fixed = || {
            let fixed = self.spec.fixed.get(&Parameter::Samples).and_then(Fixed::number);
            fixed.map(|number| crate::program::number::round(number, self.spec.precision))
        };
        let samples = at.map(|at| set[at]).or_else(fixed).map(|samples| samples as u32);
        let given = self.spec.sampled().and_then(|sampled| sampled.observer_samples());
        let last = samples.or(given).unwrap_or(1);
        Ends { last, observer: given.unwrap_or(last / 2) }
    }

    /// Calls the controller, and keeps the call where it is asked for or takes another branch, if
    /// what it gives can be compared. Says whether it was kept.
    pub(super) fn ask(&mut self, life: &mut Life, input: Input, always: bool) -> bool {
        self.tried += 1;
        let mut trial = life.instance.clone();
        let start = input.start.unwrap_or(life.start);
        if input.start.is_some() {
            trial.call("arm", &[("k", &[f64::from(start)])]);
        }
        let Some(call) = self.called(&mut trial, start, input) else { return false };
        let taken = trial.taken().cloned().unwrap_or_default();
        if !always && !taken.adds_to(&self.taken) {
            return false;
        }
        self.taken.extend(&taken);
        life.instance = trial;
        life.start = start;
        life.session.calls.push(call);
        true
    }

    /// A call, with what it gives; `None` if an estimate is not finite.
    fn called(&self, trial: &mut Instance, start: u32, input: Input) -> Option<Call> {
        let Input { start: armed, before, elapsed, y, applied } = input;
        let k = start.wrapping_add(elapsed);
        let before = before.map(|request| request.asked(trial, k, &y[..self.measured]));
        let alone = self.spec.what == What::Observer;
        let states = self.spec.sampled().is_some_and(|sampled| sampled.measures_states());
        let (tick, last) = ([f64::from(k)], [applied]);
        let (measured, reference) = y.split_at(self.measured);
        let mut given = vec![("k", &tick[..]), (if states { "x" } else { "y" }, measured)];
        given.extend((self.references > 0).then_some(("r", reference)));
        given.extend(alone.then_some(("u", &last[..])));
        let outcome = trial.call(if alone { "update" } else { "step" }, &given);
        let inputs = self.spec.axes.as_ref().map(|axes| axes.count);
        let of = |name: &str| outcome.results.get(name).cloned();
        let mut estimates = Vec::new();
        for function in ["estimate", "disturbance"] {
            if self.code.function(function).is_some() {
                estimates.extend(trial.call(function, &[]).results.into_values().flatten());
            }
        }
        let call = Call {
            start: armed,
            before,
            k,
            y,
            applied: alone.then_some(applied),
            status: outcome.status,
            // A call that fails gives 0.
            u: match alone {
                true => Vec::new(),
                false => of("u").unwrap_or_else(|| vec![0.0; inputs.unwrap_or(1)]),
            },
            axes: of("axes").into_iter().flatten().map(Status::of_number).collect(),
            estimates,
        };
        call.estimates.iter().chain(&call.u).all(|value| value.is_finite()).then_some(call)
    }
}
