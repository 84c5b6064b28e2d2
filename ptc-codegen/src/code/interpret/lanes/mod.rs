//! Controllers of several runs at once: each slot holds a pack of numbers, one for each lane.
//!
//! All lanes take the same steps together. Where a branch parts them, those at the earliest step go on, and the others
//! wait until these have come to where they are. A lane has the bits of an [`Instance`] by itself.

mod run;

use std::sync::Arc;

use super::tape::{Named, Tape};
use super::{Handle, Instance, held};
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::lanes::{Pack, vectorized};
use run::Run;

/// Lanes as bits.
type Set = u8;

/// A controller in each lane.
#[derive(Clone, Debug)]
pub struct InstanceLanes {
    tape: Arc<Tape>,
    /// The slots, and behind them one for what not all lanes take.
    memory: Vec<Pack>,
    /// Lanes that hold a controller; what is in the others counts for nothing.
    live: Set,
}

impl InstanceLanes {
    /// Lanes for copies of a controller, all empty. Functions of the user's program do not run in them.
    pub fn of(instance: &Instance) -> Self {
        let tape = Arc::clone(&instance.tape);
        Self { memory: vec![Pack::all(f64::NAN); tape.image.len() + 1], tape, live: 0 }
    }

    /// Puts a controller into a lane.
    pub fn put(&mut self, lane: usize, instance: &Instance) {
        self.live |= 1 << lane;
        for (slot, own) in self.memory.iter_mut().zip(&instance.memory) {
            slot.0[lane] = *own;
        }
    }

    /// Gives an instance the memory of a lane.
    pub fn take(&self, lane: usize, instance: &mut Instance) {
        for (slot, own) in self.memory.iter().zip(&mut instance.memory) {
            *own = slot.0[lane];
        }
    }

    /// Empties a lane.
    pub fn leave(&mut self, lane: usize) {
        self.live &= !(1 << lane);
    }

    /// Calls a function in all lanes, with its arguments in their order.
    pub fn perform(&mut self, Handle(index): Handle, arguments: &[&[Pack]]) {
        let Self { tape, memory, live } = self;
        let Some(routine) = tape.routines.get(index) else { fault("no such function") };
        for (argument, values) in routine.arguments.iter().zip(arguments) {
            give(memory, argument, values, tape.precision);
        }
        if *live != 0 {
            let mut run = Run::new(memory, tape.precision, *live);
            vectorized!(run.steps(&routine.steps));
        }
    }

    /// Returns the first result of the last call of a function: 0 where it failed.
    pub fn result(&self, Handle(index): Handle) -> &[Pack] {
        let result = self.tape.routines[index].results.first();
        result.map_or(&[], |result| &self.memory[result.slots.range()])
    }
}

/// Writes what a variable is given to its slots.
fn give(memory: &mut [Pack], to: &Named, values: &[Pack], precision: Precision) {
    for (slot, value) in memory[to.slots.range()].iter_mut().zip(values) {
        *slot = value.map(|own| held(own, to.shape, precision));
    }
}
