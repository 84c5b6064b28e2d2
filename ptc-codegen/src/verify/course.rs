//! Variation of a disturbance within its bounds over a run.

use std::f64::consts::TAU;

use super::Interval;

/// Signal of a disturbance within its bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    /// One value throughout.
    Constant,
    /// A sine from bound to bound, of 1/2 to 50 periods per tau.
    Sine,
    /// From bound to bound, 1 to 16 times per tau.
    Square,
    /// Another value in each of 16 pieces of the run.
    Random,
    /// At one of the bounds throughout, with any switching between them.
    Worst,
}

impl Signal {
    /// All signals, by their numbers in a row.
    pub const ALL: [Self; 5] =
        [Self::Constant, Self::Sine, Self::Square, Self::Random, Self::Worst];

    /// Returns its number in a row: its place among all signals.
    pub fn code(self) -> f64 {
        match self {
            Self::Constant => 0.0,
            Self::Sine => 1.0,
            Self::Square => 2.0,
            Self::Random => 3.0,
            Self::Worst => 4.0,
        }
    }

    /// The word of the design file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Sine => "sine",
            Self::Square => "square",
            Self::Random => "random",
            Self::Worst => "worst",
        }
    }
}

/// One signal with its numbers, in the unit of the disturbance.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// This value throughout.
    Constant(f64),
    /// So many periods per tau, from a phase in turns.
    Sine(f64, f64),
    /// So many half periods per tau, from a phase in turns.
    Square(f64, f64),
    /// A level for each of the pieces.
    Random(Vec<f64>),
    /// From one bound to the other at each of these T/tau, which descend.
    Worst {
        /// True if it begins at the upper bound.
        high: bool,
        /// T/tau at which it switches.
        switches: Vec<f64>,
    },
}

/// Pieces of a random signal, and of a worst one as it is drawn.
pub(super) const PIECES: usize = 16;

/// T/tau where the pieces of a run to `until` begin: 8 even in time, then 8 even in its logarithm.
pub(super) fn share(until: f64, piece: usize) -> f64 {
    let half = PIECES / 2;
    #[allow(clippy::cast_precision_loss)]
    let part = |piece: usize| piece as f64 / half as f64;
    // Runs may end before the last eighth.
    let last = (1.0 / half as f64).max(until.sqrt());
    if piece <= half {
        1.0 - (1.0 - last) * part(piece)
    } else {
        last * (until / last).powf(part(piece - half))
    }
}

/// A part of an interval; both ends are met exactly.
pub(super) fn between((low, high): Interval, part: f64) -> f64 {
    low * (1.0 - part) + high * part
}

impl Course {
    /// One of the `legal` signals, each as likely, with numbers drawn evenly from \[0, 1).
    pub(super) fn drawn(
        (legal, bounds): (&[Signal], Interval),
        until: f64,
        even: &mut dyn FnMut() -> f64,
    ) -> Self {
        #[allow(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss
        )]
        let place = (even() * legal.len() as f64) as usize;
        match legal.get(place).copied().unwrap_or(Signal::Constant) {
            Signal::Constant => Self::Constant(between(bounds, even())),
            Signal::Sine => Self::Sine(0.5 * 100f64.powf(even()), even()),
            Signal::Square => Self::Square(1.0 + (16.0 * even()).floor(), even()),
            Signal::Random => Self::Random((0..PIECES).map(|_| between(bounds, even())).collect()),
            Signal::Worst => {
                let levels: Vec<_> = (0..PIECES).map(|_| even() >= 0.5).collect();
                let switches = (1..PIECES).filter(|i| levels[*i] != levels[i - 1]);
                let switches = switches.map(|piece| share(until, piece)).collect();
                Self::Worst { high: levels[0], switches }
            }
        }
    }

    /// Returns the course that stays nearest to a bound throughout, for the first of the `legal` signals that does so
    /// best.
    pub(super) fn extreme((legal, (low, high)): (&[Signal], Interval), upper: bool) -> Self {
        let bound = if upper { high } else { low };
        let phase = if upper { 0.0 } else { 0.5 };
        let best = [Signal::Constant, Signal::Worst, Signal::Random, Signal::Square, Signal::Sine];
        match best.into_iter().find(|signal| legal.contains(signal)) {
            Some(Signal::Worst) => Self::Worst { high: upper, switches: Vec::new() },
            Some(Signal::Random) => Self::Random(vec![bound; PIECES]),
            // Half a period.
            Some(Signal::Square) => Self::Square(1.0, phase),
            Some(Signal::Sine) => Self::Sine(0.5, phase),
            _ => Self::Constant(bound),
        }
    }

    /// Returns the kind of signal.
    pub fn signal(&self) -> Signal {
        match self {
            Self::Constant(_) => Signal::Constant,
            Self::Sine(..) => Signal::Sine,
            Self::Square(..) => Signal::Square,
            Self::Random(_) => Signal::Random,
            Self::Worst { .. } => Signal::Worst,
        }
    }

    /// T/tau where it jumps.
    pub(super) fn jumps(&self, until: f64) -> Vec<f64> {
        match self {
            Self::Constant(_) | Self::Sine(..) => Vec::new(),
            Self::Square(count, phase) => {
                (0..=18).map(|k| 1.0 - (f64::from(k) - 2.0 * phase) / count).collect()
            }
            Self::Random(_) => (1..PIECES).map(|piece| share(until, piece)).collect(),
            Self::Worst { switches, .. } => switches.clone(),
        }
    }

    /// Its value at a T/tau at which it does not jump.
    pub(super) fn value(&self, (low, high): Interval, until: f64, at: f64) -> f64 {
        let bound = |upper: bool| if upper { high } else { low };
        match self {
            Self::Constant(value) => *value,
            Self::Sine(periods, phase) => {
                let turn = TAU * (periods * (1.0 - at) + phase);
                0.5 * (low + high) + 0.5 * (high - low) * turn.sin()
            }
            Self::Square(count, phase) => {
                bound((count * (1.0 - at) + 2.0 * phase).floor() % 2.0 == 0.0)
            }
            Self::Random(levels) => {
                let piece = (1..PIECES).filter(|piece| share(until, *piece) >= at).count();
                levels[piece]
            }
            Self::Worst { high: first, switches } => {
                let passed = switches.iter().filter(|switch| **switch >= at).count();
                bound(*first == (passed % 2 == 0))
            }
        }
    }

    /// The courses next to it at a distance of `size`, a part of what each of its numbers may be.
    pub(super) fn moved(&self, (low, high): Interval, size: f64) -> Vec<Self> {
        let level = |value: f64| {
            let steps = [value + size * (high - low), value - size * (high - low)];
            steps.map(|value| value.clamp(low, high)).into_iter().filter(move |new| *new != value)
        };
        let turned = |phase: f64| [phase + size, phase - size].map(|phase| phase.rem_euclid(1.0));
        match self {
            Self::Constant(value) => level(*value).map(Self::Constant).collect(),
            Self::Sine(periods, phase) => {
                let steps = [100f64.powf(size), 100f64.powf(-size)];
                let faster = steps.map(|factor| (periods * factor).clamp(0.5, 50.0));
                let faster = faster.into_iter().filter(|new| new != periods);
                let faster = faster.map(|periods| Self::Sine(periods, *phase));
                faster.chain(turned(*phase).map(|phase| Self::Sine(*periods, phase))).collect()
            }
            Self::Square(count, phase) => {
                let step = (15.0 * size).round().max(1.0);
                let more = [count + step, count - step].map(|count| count.clamp(1.0, 16.0));
                let more = more.into_iter().filter(|new| new != count);
                let more = more.map(|count| Self::Square(count, *phase));
                more.chain(turned(*phase).map(|phase| Self::Square(*count, phase))).collect()
            }
            Self::Random(levels) => {
                let one = |(place, value): (usize, &f64)| {
                    level(*value).map(move |value| (place, value)).collect::<Vec<_>>()
                };
                let all = levels.iter().enumerate().flat_map(one);
                let with = |(place, value)| {
                    let mut levels = levels.clone();
                    levels[place] = value;
                    Self::Random(levels)
                };
                all.map(with).collect()
            }
            // Its switching follows from the run: see `kernel`.
            Self::Worst { .. } => Vec::new(),
        }
    }

    /// A worst course that is at the other bound in each of the pieces, one at a time.
    pub(super) fn flipped(&self, until: f64) -> Vec<Self> {
        let Self::Worst { high, switches } = self else { return Vec::new() };
        let flip = |piece: usize| {
            let mut switches = switches.clone();
            let edges = [share(until, piece), share(until, piece + 1)];
            for edge in edges.into_iter().filter(|edge| until < *edge && *edge < 1.0) {
                match switches.iter().position(|switch| *switch == edge) {
                    Some(place) => drop(switches.remove(place)),
                    None => switches.push(edge),
                }
            }
            switches.sort_by(|a, b| b.total_cmp(a));
            Self::Worst { high: *high != (piece == 0), switches }
        };
        (0..PIECES).map(flip).collect()
    }
}
