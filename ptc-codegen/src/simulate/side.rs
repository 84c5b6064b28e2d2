//! Common part of both sides of Theorem 1: a run in sigma = -ln(T/tau) that stops where it is looked at.

use super::integrals::Integrals;
use super::method::State;
use super::mode::Mode;
use super::solver::First;
use super::switching::{Piecewise, Walk};
use super::{Accuracy, Failure, Sample, Values};
use crate::expression::Expression;
use crate::parameter::Parameter;
use crate::request::Spec;

/// One side of Theorem 1: what is integrated, and what is reported of it.
pub trait Side {
    /// Its state at t0, of a plant in `x0`.
    ///
    /// # Errors
    /// A parameter without a value, or outside its domain.
    fn start(&mut self, values: &Values, x0: &[f64]) -> Result<State, Failure>;

    /// Other values from here on.
    ///
    /// # Errors
    /// A parameter without a value.
    fn give(&mut self, values: &Values) -> Result<(), Failure>;

    /// Computes the rates of the `order` components by sigma, with the kinks held as chosen.
    fn rates(&mut self, at: At, state: &State, rates: &mut State);

    /// Number of components.
    fn order(&self) -> usize;

    /// Number of kinks of the plant and the law.
    fn kinks(&self) -> usize;

    /// The distances from the kinks.
    fn distances(&mut self, at: At, state: &State, into: &mut Vec<f64>);

    /// Holds every kink above or below 0.
    fn choose(&mut self, above: &[bool]);

    /// Why no run goes on across a kink, or, without one, where its integration stops; `None` where
    /// one does.
    fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        let _ = kink;
        None
    }

    /// The form in which a state is integrated from here on, where it may slide along a jump, and for
    /// how long in sigma at most.
    fn form(&mut self, at: At, state: &State, slides: bool) -> (State, f64) {
        let _ = (at, slides);
        (*state, f64::INFINITY)
    }

    /// The plant's state and its inputs where the rates, or the distances, were computed last.
    fn acting<'a>(&'a mut self, at: At, state: &'a State) -> (&'a [f64], &'a [f64]);

    /// Hands over the plant and its control.
    fn tell(&mut self, at: At, state: &State, visit: &mut dyn FnMut(Sample<'_>));

    /// Returns true if an error below the relative accuracy of the states before it counts as nothing.
    fn floors(&self) -> bool;

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

/// A side with its progress.
#[derive(Clone, Debug)]
pub struct Run<S> {
    side: S,
    integrals: Option<Integrals>,
    sigma: f64,
    state: State,
    walk: Walk,
}

impl<S: Side> Run<S> {
    pub(super) fn of(side: S) -> Self {
        let walk = Walk::default();
        Self { side, integrals: None, sigma: 0.0, state: State::zeros(), walk }
    }

    /// The same with integrals over the run beside it.
    #[must_use]
    pub fn with_integrals(self, spec: &Spec, integrands: &[Expression]) -> Self {
        Self { integrals: Integrals::new(spec, integrands), ..self }
    }

    pub(super) fn side(&self) -> &S {
        &self.side
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
        if let Some(integrals) = &mut self.integrals {
            integrals.start(values, x0)?;
        }
        self.sigma = 0.0;
        self.walk = Walk::default();
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
        let (start, most) = (self.state, self.state.rows(0, self.side.order()).amax());
        // A run begins where the last one ended, whether or not that is looked at.
        let mut points = vec![self.sigma];
        points.extend(shares.iter().map(|share| -share.ln()));
        let Self { side, integrals, sigma, state, walk } = self;
        let mut system = OnSigma {
            side,
            integrals: integrals.as_mut(),
            tau,
            t0,
            most,
            shares,
            reached: (sigma, state),
            visit,
        };
        let end = walk.on(&mut system, start, &points, (First::Eighth, accuracy));
        end.map_err(|(sigma, failure)| {
            let of_integral = |own: &Integrals| own.failure(failure.clone());
            let failure = integrals.as_ref().map_or_else(|| failure.clone(), of_integral);
            let share = (-sigma).exp();
            let t = t0 + tau * (1.0 - share);
            failure.at(t, format_args!("t = {t} s, T/tau = {share:.2e}"))
        })
    }
}

/// A side over sigma.
struct OnSigma<'a, S> {
    side: &'a mut S,
    integrals: Option<&'a mut Integrals>,
    tau: f64,
    t0: f64,
    most: f64,
    /// T/tau at which the state is handed over.
    shares: &'a [f64],
    /// Position of the run.
    reached: (&'a mut f64, &'a mut State),
    visit: &'a mut dyn FnMut(Sample<'_>),
}

impl<S: Side> OnSigma<'_, S> {
    fn at(&self, sigma: f64) -> At {
        self.at_share((-sigma).exp())
    }

    fn at_share(&self, share: f64) -> At {
        At { t: self.t0 + (self.tau - self.tau * share), time_to_go: self.tau * share }
    }

    /// Hands over a point; along a jump u is what keeps the state there.
    fn tell(&mut self, at: At, state: &State, slide: Option<(&Mode, f64)>) {
        let beyond = slide.and_then(|(mode, part)| {
            self.choose(&mode.slide.as_ref()?.beyond);
            let mut u = Vec::new();
            self.side.tell(at, state, &mut |sample| u = sample.u.to_vec());
            self.choose(&mode.above);
            Some((u, part))
        });
        let behind = self.side.order();
        let integrals = &state.as_slice()[behind..behind + self.integrals()];
        let visit = &mut *self.visit;
        self.side.tell(at, state, &mut |sample| {
            let sample = Sample { integrals, ..sample };
            let Some((beyond, part)) = &beyond else { return visit(sample) };
            let both = sample.u.iter().zip(beyond);
            let u: Vec<_> = both.map(|(u, beyond)| u + part * (beyond - u)).collect();
            visit(Sample { u: &u, ..sample });
        });
    }
}

impl<S: Side> Piecewise for OnSigma<'_, S> {
    fn order(&self) -> usize {
        self.side.order()
    }

    fn integrals(&self) -> usize {
        self.integrals.as_ref().map_or(0, |integrals| integrals.count())
    }

    fn rates(&mut self, sigma: f64, state: &State, rates: &mut State) {
        let at = self.at(sigma);
        self.side.rates(at, state, rates);
        let behind = self.side.order();
        if let Some(integrals) = &mut self.integrals {
            let acting = self.side.acting(at, state);
            let (so_far, rates) =
                (&state.as_slice()[behind..], &mut rates.as_mut_slice()[behind..]);
            integrals.rates((at.time_to_go, at.time_to_go), acting, so_far, rates);
        }
    }

    fn kinks(&self) -> usize {
        self.side.kinks() + self.kinks_of_integrals()
    }

    fn kinks_of_integrals(&self) -> usize {
        self.integrals.as_ref().map_or(0, |integrals| integrals.kinks())
    }

    fn distances(&mut self, sigma: f64, state: &State, into: &mut Vec<f64>) {
        let at = self.at(sigma);
        self.side.distances(at, state, into);
        let behind = self.side.order();
        if let Some(integrals) = self.integrals.as_mut().filter(|own| own.kinks() > 0) {
            let acting = self.side.acting(at, state);
            integrals.distances(at.time_to_go, acting, &state.as_slice()[behind..], into);
        }
    }

    fn choose(&mut self, above: &[bool]) {
        let (of_side, of_integrals) = above.split_at(self.side.kinks());
        self.side.choose(of_side);
        if let Some(integrals) = &mut self.integrals {
            integrals.choose(of_integrals);
        }
    }

    fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        let own = kink.is_none_or(|kink| kink < self.side.kinks());
        if own { self.side.barrier(kink) } else { None }
    }

    fn form(&mut self, sigma: f64, state: &State, slides: bool) -> (State, f64) {
        let (mut formed, length) = self.side.form(self.at(sigma), state, slides);
        let behind = self.side.order();
        formed.as_mut_slice()[behind..].copy_from_slice(&state.as_slice()[behind..]);
        (formed, length)
    }

    fn floors(&self) -> bool {
        self.side.floors()
    }

    fn nothing(&mut self, sigma: f64) -> f64 {
        self.side.nothing(self.at(sigma), self.most)
    }

    fn see(&mut self, index: usize, sigma: f64, state: &State, slide: Option<(&Mode, f64)>) {
        (*self.reached.0, *self.reached.1) = (sigma, *state);
        // The first point is where the run begins.
        if let Some(share) = index.checked_sub(1).and_then(|index| self.shares.get(index)) {
            self.tell(self.at_share(*share), state, slide);
        }
    }
}
