//! The controllers of all lanes: as a program of time where nothing but time and state decides u, else as they are
//! emitted.

mod code;
mod program;

use super::along::Abreast;
use super::ticks::Ticks;
use crate::program::lanes::Pack;
use crate::simulate::{Controller, Failure, Values};
use code::OfCode;
use program::OfProgram;

/// A controller for each lane.
#[derive(Clone, Debug)]
pub(super) enum Controls {
    Program(Box<OfProgram>),
    Code(Box<OfCode>),
}

/// A sample of all lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Now<'a> {
    /// Its number.
    pub(super) index: u32,
    /// Its times in s.
    pub(super) t: &'a Pack,
    pub(super) measured: &'a [Pack],
}

impl Controls {
    /// The lanes of a controller, whose runs may have events.
    pub(super) fn of(controller: &Controller, events: bool) -> Self {
        let program = if events { None } else { OfProgram::of(controller) };
        match program {
            Some(program) => Self::Program(Box::new(program)),
            None => Self::Code(Box::new(OfCode::of(controller))),
        }
    }

    /// Begins a run in a lane.
    pub(super) fn start(
        &mut self,
        lane: usize,
        controller: &mut Controller,
        values: &Values,
        given: &[f64],
    ) -> Result<(), Failure> {
        use crate::simulate::Control as _;
        controller.init(values, given)?;
        match self {
            Self::Program(own) => own.start(lane, values, given),
            Self::Code(own) => {
                own.put(lane, controller);
                Ok(())
            }
        }
    }

    /// Before the first samples of runs that begin together.
    pub(super) fn begin(&mut self) {
        if let Self::Program(own) = self {
            own.begin();
        }
    }

    /// Ends the run of a lane.
    pub(super) fn leave(&mut self, lane: usize) {
        if let Self::Code(own) = self {
            own.leave(lane);
        }
    }

    /// Computes every u of a sample.
    pub(super) fn step(&mut self, now: &Now<'_>) -> &[Pack] {
        match self {
            Self::Program(own) => own.step(now),
            Self::Code(own) => own.step(now),
        }
    }

    /// The sample at which each loop is to be at rest, where the controllers may change it.
    pub(super) fn deadline(&mut self) -> Option<Pack> {
        match self {
            Self::Program(_) => None,
            Self::Code(own) => own.deadline(),
        }
    }

    /// Hands over the controller of a lane, for what happens in its run alone; `None` where nothing may happen.
    pub(super) fn alone<R>(
        &mut self,
        lane: usize,
        controller: &mut Controller,
        visit: impl FnOnce(&mut Controller) -> R,
    ) -> Option<R> {
        match self {
            Self::Program(_) => None,
            Self::Code(own) => {
                own.take(lane, controller);
                let found = visit(controller);
                own.put(lane, controller);
                Some(found)
            }
        }
    }
}
