//! The steps of one call in all lanes.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::Set;
use crate::code::interpret::tape::{Address, Ended, Question, Step};
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::lanes::{LANES, Pack, apply, vectorized};
use crate::program::{Arithmetic, number};

/// One call under way.
pub(super) struct Run<'r> {
    precision: Precision,
    memory: &'r mut [Pack],
    /// The slot for what not all lanes take.
    spare: usize,
    /// Lanes that hold a controller.
    live: Set,
    /// Lanes that take the next step, and where it is.
    going: Set,
    next: usize,
    /// The step at which each other lane waits; beyond all steps for one at its end.
    waiting: [usize; LANES],
    /// The earliest of these steps.
    nearest: usize,
}

/// The step of a lane at its end.
const ENDED: usize = usize::MAX;

impl<'r> Run<'r> {
    pub(super) fn new(memory: &'r mut [Pack], precision: Precision, live: Set) -> Self {
        let (waiting, spare) = ([ENDED; LANES], memory.len() - 1);
        Self { precision, memory, spare, live, going: live, next: 0, waiting, nearest: ENDED }
    }

    /// Takes steps until every lane is at its end.
    #[inline(always)]
    pub(super) fn steps(&mut self, steps: &[Step]) {
        loop {
            if self.next >= self.nearest {
                self.regroup(self.next);
            }
            let Some(step) = steps.get(self.next) else { fault("a call without an end") };
            self.next += 1;
            match step {
                Step::Compute(operation, to) => self.compute(operation, *to),
                Step::Unless(question, other) => self.branch(*question, *other),
                Step::Go(other) => self.next = *other,
                Step::Give(Ended::Known(_) | Ended::OfGains) | Step::Stands(_) => {
                    if self.nearest == ENDED {
                        return;
                    }
                    self.regroup(ENDED);
                }
                other => self.other(other),
            }
        }
    }

    #[inline(always)]
    fn compute(&mut self, operation: &Arithmetic, to: usize) {
        let into = if self.going == self.live { to } else { self.spare };
        match self.precision {
            Precision::F64 => apply(operation, self.memory, into),
            Precision::F32 => self.single(operation, into),
        }
        if into != to {
            self.blend(self.memory[into], to);
        }
    }

    /// An operation on floats.
    #[inline(never)]
    fn single(&mut self, operation: &Arithmetic, to: usize) {
        // A sum, a product or a quotient of floats is the rounded one of doubles.
        match operation {
            Arithmetic::Add(..)
            | Arithmetic::Sub(..)
            | Arithmetic::Mul(..)
            | Arithmetic::Div(..)
            | Arithmetic::Neg(_)
            | Arithmetic::Copy(_)
            | Arithmetic::Max(..)
            | Arithmetic::Min(..) => {
                vectorized!({
                    apply(operation, self.memory, to);
                    self.memory[to] =
                        self.memory[to].map(|own| number::settle(own, Precision::F32));
                });
            }
            _ => {
                let at = |lane: usize| {
                    operation.result(|slot| self.memory[slot].0[lane], Precision::F32)
                };
                self.memory[to] = Pack::of(at);
            }
        }
    }

    /// Steps that are rare.
    #[inline(never)]
    fn other(&mut self, step: &Step) {
        let memory = &*self.memory;
        match step {
            Step::Count(operation, to) => {
                let count = Pack::of(|lane| operation.result(|slot| memory[slot].0[lane]));
                self.set(*to, count);
            }
            Step::Round(count, to) => {
                let rounded = memory[*count].map(|own| number::settle(own, self.precision));
                self.set(*to, rounded);
            }
            Step::Divisor(divisor, to) => {
                let divisor = memory[*divisor];
                self.set(*to, divisor.map(|own| if own == 0.0 { f64::NAN } else { own }));
            }
            Step::Place(address, to) => {
                let index = self.index(address);
                self.set(*to, index);
            }
            Step::Load(address, to) => self.load(address, *to),
            Step::Store(from, address) => self.store(*from, address),
            Step::Copy { from, to, count } => {
                for place in 0..*count {
                    self.set(to + place, self.memory[from + place]);
                }
            }
            step => fault(format!("{step:?} does not run in lanes")),
        }
    }

    /// The sum of indices in each lane.
    fn index(&self, address: &Address) -> Pack {
        Pack::of(|lane| address.index(|slot| self.memory[slot].0[lane]))
    }

    /// The slot of an element that is the same one in all lanes, or the slots of each.
    fn places(&self, address: &Address) -> Result<usize, [usize; LANES]> {
        let index = self.index(address);
        let first = index.0[self.going.trailing_zeros() as usize];
        if self.all().all(|lane| index.0[lane].to_bits() == first.to_bits()) {
            return Ok(address.slot(first));
        }
        let mut slots = [self.spare; LANES];
        self.all().for_each(|lane| slots[lane] = address.slot(index.0[lane]));
        Err(slots)
    }

    fn load(&mut self, address: &Address, to: usize) {
        let value = match self.places(address) {
            Ok(slot) => self.memory[slot],
            Err(slots) => Pack::of(|lane| self.memory[slots[lane]].0[lane]),
        };
        self.set(to, value);
    }

    fn store(&mut self, from: usize, address: &Address) {
        match self.places(address) {
            Ok(slot) => self.set(slot, self.memory[from]),
            Err(slots) => {
                for lane in self.all() {
                    self.memory[slots[lane]].0[lane] = self.memory[from].0[lane];
                }
            }
        }
    }

    /// The lanes that go on.
    fn all(&self) -> impl Iterator<Item = usize> + use<> {
        let going = self.going;
        (0..LANES).filter(move |lane| going & (1 << lane) != 0)
    }

    /// Gives the lanes that go on another value.
    #[inline]
    fn set(&mut self, to: usize, value: Pack) {
        if self.going == self.live {
            self.memory[to] = value;
        } else {
            self.blend(value, to);
        }
    }

    #[inline(never)]
    fn blend(&mut self, value: Pack, to: usize) {
        for lane in self.all() {
            self.memory[to].0[lane] = value.0[lane];
        }
    }

    #[inline(always)]
    fn branch(&mut self, question: Question, other: usize) {
        let yes = answers(question, self.memory);
        let no = self.going & !yes;
        if no == 0 {
            return;
        }
        if no == self.going {
            self.next = other;
            return;
        }
        for lane in self.all().filter(|lane| no & (1 << lane) != 0) {
            self.waiting[lane] = other;
        }
        self.going &= yes;
        self.nearest = self.nearest.min(other);
    }

    /// Goes on with the lanes at the earliest step, where those that went on so far are at `here`.
    #[inline(never)]
    fn regroup(&mut self, here: usize) {
        for lane in self.all() {
            self.waiting[lane] = here;
        }
        self.next = self.waiting.into_iter().min().unwrap_or(ENDED);
        (self.going, self.nearest) = (0, ENDED);
        for (lane, place) in self.waiting.iter_mut().enumerate() {
            if *place == self.next {
                self.going |= 1 << lane;
                *place = ENDED;
            } else {
                self.nearest = self.nearest.min(*place);
            }
        }
    }
}

/// The lanes in which the answer is yes.
#[inline(always)]
fn answers(question: Question, memory: &[Pack]) -> Set {
    match question {
        Question::Less(a, b) => lanes(&memory[a], &memory[b], |a, b| a < b),
        Question::AtMost(a, b) => lanes(&memory[a], &memory[b], |a, b| a <= b),
        #[allow(clippy::float_cmp)]
        Question::Equal(a, b) => lanes(&memory[a], &memory[b], |a, b| a == b),
        Question::Finite(a) => lanes(&memory[a], &memory[a], |a, _| a.is_finite()),
        Question::NotNumber(a) => lanes(&memory[a], &memory[a], |a, _| a.is_nan()),
    }
}

#[inline(always)]
fn lanes(a: &Pack, b: &Pack, holds: impl Fn(f64, f64) -> bool) -> Set {
    let mut set = 0;
    for lane in 0..LANES {
        set |= Set::from(holds(a.0[lane], b.0[lane])) << lane;
    }
    set
}
