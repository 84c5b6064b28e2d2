//! The plant between two samples, where its inputs are held.

use super::integrals::Integrals;
use super::linear::Linear;
use super::method::State;
use super::mode::Mode;
use super::plant::Motion;
use super::switching::Piecewise;
use super::{Accuracy, Failure};

/// The plant between samples.
#[derive(Clone, Debug)]
pub(super) enum Moved {
    /// A chain with f and g, or a model.
    Rates(Box<Motion>),
    Linear(Linear),
}

/// Accuracy of the motion between two samples, where u is constant.
pub(super) const BETWEEN: Accuracy = Accuracy { relative: 1e-9, absolute: 1e-12, steps: 10_000 };

/// The inputs between two samples: as they are given, and as they act on the plant.
#[derive(Clone, Copy)]
pub(super) struct Held<'a> {
    pub(super) u: &'a [f64],
    pub(super) acts: &'a [f64],
}

/// The plant between two samples, over the part of the time between them.
pub(super) struct Between<'a> {
    pub(super) moved: &'a mut Moved,
    pub(super) integrals: Option<&'a mut Integrals>,
    pub(super) held: Held<'a>,
    pub(super) from: f64,
    pub(super) length: f64,
    /// Time-to-go at the beginning.
    pub(super) time_to_go: f64,
    /// The state that was reached.
    pub(super) end: State,
}

impl Between<'_> {
    fn time(&self, s: f64) -> f64 {
        self.from + self.length * s
    }

    /// Number of kinks of the plant.
    fn of_plant(&self) -> usize {
        match &self.moved {
            Moved::Rates(motion) => motion.kinks(),
            Moved::Linear(_) => 0,
        }
    }
}

impl Piecewise for Between<'_> {
    fn order(&self) -> usize {
        match &self.moved {
            Moved::Rates(motion) => motion.order(),
            Moved::Linear(plant) => plant.order(),
        }
    }

    fn integrals(&self) -> usize {
        self.integrals.as_ref().map_or(0, |integrals| integrals.count())
    }

    fn rates(&mut self, s: f64, x: &State, rates: &mut State) {
        let at = (self.time(s), self.length);
        let (own, so_far) = x.as_slice().split_at(self.order());
        match &mut self.moved {
            Moved::Rates(motion) => motion.rates(at, own, self.held.acts, rates),
            Moved::Linear(plant) => plant.rates(self.length, own, self.held.acts[0], rates),
        }
        if let Some(integrals) = &mut self.integrals {
            let at = (self.time_to_go - self.length * s, self.length);
            let rates = &mut rates.as_mut_slice()[own.len()..];
            integrals.rates(at, (own, self.held.u), so_far, rates);
        }
    }

    fn kinks(&self) -> usize {
        self.of_plant() + self.kinks_of_integrals()
    }

    fn kinks_of_integrals(&self) -> usize {
        self.integrals.as_ref().map_or(0, |integrals| integrals.kinks())
    }

    fn distances(&mut self, s: f64, x: &State, into: &mut Vec<f64>) {
        let t = self.time(s);
        let (own, so_far) = x.as_slice().split_at(self.order());
        if let Moved::Rates(motion) = &mut self.moved {
            motion.at(t, own, self.held.acts);
            motion.distances(into);
        }
        if let Some(integrals) = self.integrals.as_mut().filter(|own| own.kinks() > 0) {
            let time_to_go = self.time_to_go - self.length * s;
            integrals.distances(time_to_go, (own, self.held.u), so_far, into);
        }
    }

    fn choose(&mut self, above: &[bool]) {
        let (of_plant, of_integrals) = above.split_at(self.of_plant());
        if let Moved::Rates(motion) = &mut self.moved {
            motion.choose(of_plant);
        }
        if let Some(integrals) = &mut self.integrals {
            integrals.choose(of_integrals);
        }
    }

    fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        match &self.moved {
            Moved::Rates(motion) if kink.is_none_or(|kink| kink < motion.kinks()) => {
                motion.barrier(kink)
            }
            _ => None,
        }
    }

    fn floors(&self) -> bool {
        false
    }

    fn nothing(&mut self, _: f64) -> f64 {
        BETWEEN.absolute
    }

    fn see(&mut self, _: usize, _: f64, x: &State, _: Option<(&Mode, f64)>) {
        self.end = *x;
    }
}
