//! A compiled program that is looked at along the runs of all lanes.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use crate::program::kink::{Kink, steady};
use crate::program::lanes::{LANES, Lanes, Pack, Register, vectorized};
use crate::program::{Input, Program, Stage, Value};
use crate::simulate::values::Given;
use crate::simulate::{Failure, Values};

use super::flow::{Tick, Which};

/// A program in lanes with the registers of what changes along a run.
#[derive(Clone, Debug)]
pub struct Abreast {
    pub lanes: Lanes,
    given: Given<Register>,
    /// The state at the start.
    start: Vec<(usize, Register)>,
    time: Option<Register>,
    state: Vec<Option<Register>>,
    control: Option<Register>,
    kept: Kept,
}

/// Results of a tick at the stored times.
#[derive(Clone, Debug)]
struct Kept {
    /// The registers that are read later; `None` where a tick is more than arithmetic.
    read: Option<Vec<Register>>,
    numbers: Vec<Pack>,
}

impl Abreast {
    /// `program` of order `n`, of which `outputs` are looked at; `None` where it does not run in lanes.
    pub fn new(program: &Program, outputs: &[Value], n: usize) -> Option<Self> {
        let lanes = Lanes::new(program, outputs)?;
        let of_start = |(input, register): (Input, Register)| match input {
            Input::StateAtStart(j) => Some((j - 1, register)),
            _ => None,
        };
        Some(Self {
            given: Given::default(),
            start: lanes.inputs().filter_map(of_start).collect(),
            time: lanes.register(Input::Time),
            state: (1..=n).map(|j| lanes.register(Input::State(j))).collect(),
            control: lanes.register(Input::Control),
            kept: Kept { read: lanes.read_after(Stage::Tick, outputs), numbers: Vec::new() },
            lanes,
        })
    }

    /// Parameters of a lane.
    ///
    /// # Errors
    /// One that has no value.
    pub fn give(&mut self, lane: usize, values: &Values) -> Result<(), Failure> {
        let Self { lanes, given, .. } = self;
        given.find(values, || lanes.inputs())?;
        given.of(values).for_each(|(register, value)| lanes.set(register, lane, value));
        Ok(())
    }

    /// Parameters of a lane, and its state at the start.
    ///
    /// # Errors
    /// A parameter that has no value.
    pub fn start(&mut self, lane: usize, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        for (place, register) in &self.start {
            if let Some(x) = x0.get(*place) {
                self.lanes.set(*register, lane, *x);
            }
        }
        self.give(lane, values)
    }

    /// Computes what depends on parameters and the start alone.
    pub fn settle(&mut self) {
        self.lanes.run(Stage::Init);
        self.lanes.run(Stage::Arm);
    }

    /// Computes the rest at a time and a state.
    pub fn at(&mut self, time: &Pack, state: &[Pack]) {
        self.tick(time);
        self.again(state);
    }

    /// Computes what time decides.
    pub(super) fn tick(&mut self, time: &Pack) {
        self.lanes.fill(self.time, time);
        self.lanes.run(Stage::Tick);
    }

    /// The same at another state.
    #[inline]
    pub fn again(&mut self, state: &[Pack]) {
        for (register, x) in self.state.iter().zip(state) {
            self.lanes.fill(*register, x);
        }
        self.lanes.run(Stage::Step);
    }

    /// The same at a time that is kept, or may be.
    pub(super) fn go(&mut self, tick: Tick, time: &Pack, state: &[Pack]) {
        match tick {
            Tick::New => self.tick(time),
            Tick::Again => {}
            Tick::Kept(place) => {
                self.tick(time);
                self.keep(place);
            }
            Tick::Of(place) => self.recall(place, time),
        }
        self.again(state);
    }

    fn keep(&mut self, place: usize) {
        let Kept { read: Some(read), numbers } = &mut self.kept else { return };
        let end = (place + 1) * read.len();
        if numbers.len() < end {
            numbers.resize(end, Pack::all(0.0));
        }
        for (own, register) in numbers[place * read.len()..].iter_mut().zip(read) {
            *own = *self.lanes.at(*register);
        }
    }

    fn recall(&mut self, place: usize, time: &Pack) {
        let Kept { read: Some(read), numbers } = &self.kept else { return self.tick(time) };
        let lanes = &mut self.lanes;
        vectorized!(lanes.recall(read, &numbers[place * read.len()..]));
    }

    /// The inputs from here on. Several are variables behind so many states.
    pub fn inputs(&mut self, states: usize, inputs: &[Pack]) {
        for (register, u) in self.state.iter().skip(states).zip(inputs) {
            self.lanes.fill(*register, u);
        }
        if let Some(u) = inputs.first() {
            self.lanes.fill(self.control, u);
        }
    }
}

/// Kinks at places in time alone, such as where the gains are held: a run that does not come to them
/// is smooth.
#[derive(Clone, Debug)]
pub(super) struct Kinks {
    kinks: Vec<Kink>,
    pub(super) along: Abreast,
}

impl Kinks {
    /// `None` where a kink depends on the state, or comes and goes.
    pub(super) fn of(program: &Program, kinks: Vec<Kink>) -> Option<Self> {
        let operands: Vec<_> = kinks.iter().flat_map(Kink::operands).collect();
        let steady = steady(program);
        if !operands.iter().all(|value| steady[value.0]) {
            return None;
        }
        Some(Self { along: Abreast::new(program, &operands, 0)?, kinks })
    }

    /// The lanes on whose way between two times a kink is, or may be.
    pub(super) fn between(&mut self, from: &Pack, to: &Pack) -> Which {
        let mut met = [false; LANES];
        let [from, to] = [from, to].map(|time| {
            self.along.at(time, &[]);
            let distance = |kink: &Kink| distances(kink, &self.along.lanes);
            self.kinks.iter().map(distance).collect::<Vec<_>>()
        });
        for (from, to) in from.iter().zip(&to) {
            for lane in 0..LANES {
                let both = from.0[lane] * to.0[lane];
                met[lane] |= both.is_nan() || both <= 0.0;
            }
        }
        met
    }
}

/// The distances from a kink in each lane, signed.
pub(super) fn distances(kink: &Kink, lanes: &Lanes) -> Pack {
    let mut operands = kink.operands().map(|value| *lanes.get(value));
    let left = operands.next().unwrap_or(Pack::all(0.0));
    match operands.next() {
        Some(right) => Pack::of(|lane| left.0[lane] - right.0[lane]),
        None => left,
    }
}
