//! The steps of one call.

use super::Called;
use super::tape::{Address, Callback, Counting, Ended, Question, Step};
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
            Step::Count(operation, to) => self.memory[*to] = self.counted(*operation),
            Step::Round(count, to) => {
                self.memory[*to] = number::settle(self.memory[*count], self.precision);
            }
            Step::Place(address, to) => self.memory[*to] = self.index(address),
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
        let at = |slot: usize| self.memory[slot];
        match question {
            Question::Less(a, b) => at(a) < at(b),
            Question::AtMost(a, b) => at(a) <= at(b),
            #[allow(clippy::float_cmp)]
            Question::Equal(a, b) => at(a) == at(b),
            Question::Finite(a) => at(a).is_finite(),
            Question::NotNumber(a) => at(a).is_nan(),
        }
    }

    fn note(&mut self, at: At, holds: bool) {
        if let Some(taken) = &mut self.taken {
            taken.insert(at, holds);
        }
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn counted(&self, operation: Counting) -> f64 {
        let at = |slot: usize| self.memory[slot] as u32;
        match operation {
            // A loop may count beyond its last index, and no other sum reaches 2^32.
            Counting::Add(a, b) => self.memory[a] + self.memory[b],
            Counting::Sub(a, b) => f64::from(at(a).wrapping_sub(at(b))),
            Counting::Left(a, b) => f64::from(at(a).saturating_sub(at(b))),
            Counting::Over(a, by) => f64::from(at(a) / by),
        }
    }

    /// The sum of indices.
    fn index(&self, address: &Address) -> f64 {
        let term = |(factor, slot): &(f64, usize)| factor * self.memory[*slot];
        address.terms.iter().map(term).sum::<f64>() + address.constant
    }

    /// The slot of an element.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn place(&self, address: &Address) -> usize {
        let index = self.index(address);
        if index < 0.0 {
            fault(format!("element {index} of an array"));
        }
        address.array.element(index as usize)
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
