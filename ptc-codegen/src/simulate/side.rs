//! What both sides of Theorem 1 share: a run in sigma = -ln(T/tau) that stops where it is looked at.

use std::cell::RefCell;

use super::solver::{Rates, State, integrate};
use super::{Accuracy, Failure, Sample, Values};
use crate::spec::Parameter;

/// One side of Theorem 1: what is integrated, and what is told of it.
pub trait Side {
    /// The state in which it stands at t0, of a plant in `x0`.
    ///
    /// # Errors
    /// A parameter without a value, or outside its domain.
    fn start(&mut self, values: &Values, x0: &[f64]) -> Result<State, Failure>;

    /// Other values from here on.
    ///
    /// # Errors
    /// A parameter without a value.
    fn give(&mut self, values: &Values) -> Result<(), Failure>;

    /// What is integrated: `order` components, by sigma.
    fn rates(&mut self, at: At, state: &State, rates: &mut State);

    /// Number of components.
    fn order(&self) -> usize;

    /// Hands over the plant and its control.
    fn tell(&mut self, at: At, state: &State, visit: &mut dyn FnMut(Sample<'_>));

    /// An error that counts as nothing where the loop is stiff, of a run that began with `most`.
    fn nothing(&mut self, at: At, most: f64) -> f64;
}

/// An instant of a run.
#[derive(Clone, Copy, Debug)]
pub struct At {
    /// Time t in s.
    pub t: f64,
    /// Time-to-go T in s.
    pub time_to_go: f64,
}

/// A side with where it stands.
#[derive(Clone, Debug)]
pub struct Run<S> {
    side: S,
    sigma: f64,
    state: State,
}

impl<S: Side> Run<S> {
    pub(super) fn of(side: S) -> Self {
        Self { side, sigma: 0.0, state: State::zeros() }
    }

    /// Runs from `x0` at t0 and hands over the state at each time-to-go `shares` tau, which descend
    /// from at most 1 and end above 0.
    ///
    /// # Errors
    /// A parameter without a value, or a loop that leaves the range of numbers.
    pub fn run(
        &mut self,
        values: &Values,
        x0: &[f64],
        shares: &[f64],
        accuracy: Accuracy,
        visit: &mut dyn FnMut(Sample<'_>),
    ) -> Result<(), Failure> {
        self.start(values, x0)?;
        self.advance(values, shares, accuracy, visit)
    }

    /// Stands at t0 in `x0`.
    ///
    /// # Errors
    /// A parameter without a value, or outside its domain.
    pub fn start(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.state = self.side.start(values, x0)?;
        self.sigma = 0.0;
        Ok(())
    }

    /// Goes on from where it stands, with the plant's `values` from there on: as [`run`](Self::run),
    /// to which a disturbance that jumps is several pieces.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn advance(
        &mut self,
        values: &Values,
        shares: &[f64],
        accuracy: Accuracy,
        visit: &mut dyn FnMut(Sample<'_>),
    ) -> Result<(), Failure> {
        self.side.give(values)?;
        let (tau, t0) = (values.get(Parameter::Tau), values.get(Parameter::StartTime));
        let at = |share: f64| At { t: t0 + (tau - tau * share), time_to_go: tau * share };
        let (start, most) = (self.state, self.state.amax());
        // A run begins where it stands, whether or not it is asked for.
        let mut points = vec![self.sigma];
        points.extend(shares.iter().map(|share| -share.ln()));
        let order = self.side.order();
        let here = RefCell::new(self);
        let rates = |sigma: f64, state: &State, rates: &mut State| {
            here.borrow_mut().side.rates(at((-sigma).exp()), state, rates);
        };
        let nothing = |sigma: f64| here.borrow_mut().side.nothing(at((-sigma).exp()), most);
        let mut seen = |index: usize, sigma, state: &State| {
            let mut here = here.borrow_mut();
            (here.sigma, here.state) = (sigma, *state);
            if let Some(share) = index.checked_sub(1).and_then(|index| shares.get(index)) {
                here.side.tell(at(*share), state, visit);
            }
        };
        let system = Rates { order, rates };
        let end = integrate(&system, start, &points, accuracy, &nothing, &mut seen);
        end.map_err(|(sigma, failure)| {
            let share = (-sigma).exp();
            let t = t0 + tau * (1.0 - share);
            failure.at(t, format_args!("t = {t} s, T/tau = {share:.2e}"))
        })
    }
}
