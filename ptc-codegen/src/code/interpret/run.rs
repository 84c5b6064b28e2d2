//! The steps of one call.

use super::Called;
use super::tape::{Address, Callback, Ended, Question, Step};
use crate::code::Status;
use crate::code::branch::{At, Taken};
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::number;

/// One call under way.
pub(super) struct Run<'r> {
    pub(super) precision: Precision,
    pub(super) memory: &'r mut [f64],
    pub(super) callbacks: &'r [Called<'r>],
    /// The status of the gains.
    pub(super) standing: Status,
    /// The branches taken so far, where they are recorded.
    pub(super) taken: Option<&'r mut Taken>,
}

impl Run<'_> {
    /// Runs steps to the end of the call; its status.
    pub(super) fn steps(&mut self, steps: &[Step]) -> Status {
        let mut divided_by_zero = false;
        let mut next = 0;
        while let Some(step) = steps.get(next) {
            next += 1;
            match step {
                Step::Compute(operation, to) => {
                    self.memory[*to] = operation.result(|slot| self.memory[slot], self.precision);
                }
                Step::Unless(question, other) => {
                    if !self.asks(*question) {
                        next = *other;
                    }
                }
                Step::Go(other) => next = *other,
                Step::Give(Ended::Known(status)) => return *status,
                Step::Give(Ended::OfGains) => return self.standing,
                Step::Stands(slot) => return Status::of_number(self.memory[*slot]),
                Step::Divisor(divisor, to) => {
                    let divisor = self.memory[*divisor];
                    divided_by_zero |= divisor == 0.0;
                    self.memory[*to] = if divisor == 0.0 { f64::NAN } else { divisor };
                }
                Step::Regular(at) => {
                    self.note(*at, !divided_by_zero);
                    divided_by_zero = false;
                }
                other => self.other(other),
            }
        }
        fault("a call without an end")
    }

    /// Steps that are rare.
    fn other(&mut self, step: &Step) {
        match step {
            Step::Count(operation, to) => {
                self.memory[*to] = operation.result(|slot| self.memory[slot]);
            }
            Step::Round(count, to) => {
                self.memory[*to] = number::settle(self.memory[*count], self.precision);
            }
            Step::Place(address, to) => {
                self.memory[*to] = address.index(|slot| self.memory[slot]);
            }
            Step::Load(address, to) => self.memory[*to] = self.memory[self.place(address)],
            Step::Store(from, address) => self.memory[self.place(address)] = self.memory[*from],
            Step::Copy { from, to, count } => self.memory.copy_within(*from..from + count, *to),
            Step::Callback(callback) => self.call(callback),
            Step::Note(question, at) => {
                let holds = self.asks(*question);
                self.note(*at, holds);
            }
            step => fault(format!("{step:?} ends a call")),
        }
    }

    fn asks(&self, question: Question) -> bool {
        question.holds(|slot| self.memory[slot])
    }

    fn note(&mut self, at: At, holds: bool) {
        if let Some(taken) = &mut self.taken {
            taken.insert(at, holds);
        }
    }

    /// The slot of an element.
    fn place(&self, address: &Address) -> usize {
        address.slot(address.index(|slot| self.memory[slot]))
    }

    /// Calls a function; one of several values is asked for them one at a time.
    fn call(&mut self, callback: &Callback) {
        let Callback { name, array, time, rate, to } = callback;
        let Some((_, called)) = self.callbacks.iter().find(|(known, _)| known == name) else {
            fault(format!("no function {name}"))
        };
        let mut given = self.memory[array.range()].to_vec();
        let time = self.memory[*time];
        let behind = rate.map(|rate| self.memory[rate]);
        given.extend(behind.into_iter().chain(behind.map(|_| 0.0)));
        for (place, slot) in (0_u32..).zip(to.range()) {
            if let (Some(last), Some(_)) = (given.last_mut(), behind) {
                *last = f64::from(place);
            }
            self.memory[slot] = number::settle(called(&given, time), self.precision);
        }
    }
}
