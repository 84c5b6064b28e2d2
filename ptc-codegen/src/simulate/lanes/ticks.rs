//! Values that a law computes from time alone at each sample, kept for runs that have their parameters and their times
//! in common.

use super::along::Abreast;
use crate::program::lanes::{Pack, Register};
use crate::program::{Stage, Value};

/// Samples that are kept.
const KEPT: usize = 1024;

/// The ticks of runs that begin together, by sample.
#[derive(Clone, Debug)]
pub(super) struct Ticks {
    /// The registers that decide a tick beside its time, and what they were in the last runs.
    before: Vec<Register>,
    parameters: Vec<Pack>,
    /// The registers of a tick that are read after it.
    read: Vec<Register>,
    /// True if the last runs had the parameters of those before.
    shared: bool,
    times: Vec<Pack>,
    /// The numbers of the registers at each sample.
    numbers: Vec<Pack>,
}

impl Ticks {
    /// Creates the ticks of a law of which `outputs` are looked at; `None` where a tick is more than arithmetic.
    pub(super) fn of(law: &Abreast, outputs: &[Value]) -> Option<Self> {
        Some(Self {
            before: law.lanes.before(Stage::Tick).collect(),
            parameters: Vec::new(),
            read: law.lanes.read_after(Stage::Tick, outputs)?,
            shared: false,
            times: Vec::new(),
            numbers: Vec::new(),
        })
    }

    /// Before the runs of a law that has its parameters.
    pub(super) fn begin(&mut self, law: &Abreast) {
        let now = || self.before.iter().map(|register| law.lanes.at(*register));
        let same = self.parameters.len() == self.before.len();
        self.shared = same && self.parameters.iter().zip(now()).all(|(a, b)| has_bits(a, b));
        if !self.shared {
            self.parameters = now().copied().collect();
            self.times.clear();
            self.numbers.clear();
        }
    }

    /// Computes the tick of a sample, or takes the one that was kept.
    pub(super) fn at(&mut self, sample: usize, law: &mut Abreast, time: &Pack) {
        let width = self.read.len();
        if self.times.get(sample).is_some_and(|own| has_bits(own, time)) {
            let numbers = &self.numbers[sample * width..][..width];
            for (register, own) in self.read.iter().zip(numbers) {
                law.lanes.fill(Some(*register), own);
            }
            return;
        }
        law.tick(time);
        if self.shared && sample == self.times.len() && sample < KEPT {
            self.times.push(*time);
            self.numbers.extend(self.read.iter().map(|register| *law.lanes.at(*register)));
        }
    }
}

/// Returns true if two packs are the same bit by bit.
fn has_bits(a: &Pack, b: &Pack) -> bool {
    let differing = a.0.iter().zip(&b.0).fold(0, |all, (a, b)| all | (a.to_bits() ^ b.to_bits()));
    differing == 0
}
