//! Margins of the loop that stays: with the gains that are held from eps on, or those of deadbeat, which input gains
//! and how much more delay than the law knows leave it stable.
//!
//! An observer, and inputs that are kept, run as the law believes. So the plant moves by Phi x + g Gamma a, where a
//! is the input that acts, or acted some samples ago, and the rest of the sample is as it is.

mod design;
mod plant;
mod resonance;
mod wanted;

pub use design::{NoMargins, stability};
pub use resonance::Damped;
pub(crate) use resonance::bands;
pub(super) use wanted::Wanted;
pub(crate) use wanted::{Tolerance, smallest_tolerant, tolerance};

use std::fmt;

use num_traits::ToPrimitive;

use super::chain::{Chain, Gains, Step};
use super::emitted;
use super::gain::known_gain;
use super::judge::Loop;
use super::worst::Sampled;
use crate::algebra::BigRational;
use crate::check::examine::Numbers;
use crate::diagnostic::{digits_down, digits_up};
use crate::parameter::Fixed;
use plant::Plant;
use resonance::Resonances;

/// Largest factor of the gain that is tried, and one over the smallest; factors for each power of 2 between them.
const MOST: f64 = 64.0;
const EACH: i32 = 4;

/// Most samples of delay that are tried.
const LATE: usize = 16;

/// Halvings between a gain that is stable and one that is not.
const HALVINGS: u32 = 12;

/// Most transitions whose powers one loop takes: gains up and down, halvings, delays.
const TRIALS: u32 = 2 * (6 * EACH as u32 + HALVINGS) + LATE as u32 + 1;

/// Operations that the margins of a design may take: a second or two.
const OPERATIONS: f64 = 4e9;

/// Reasons why no margins are known.
const TOO_MANY: &str = "the loop has too many states to look at its margins";
const UNSTABLE: &str = "the loop is not stable with the final gains";

/// Squarings of a transition, and the size from which on it grows.
const SQUARINGS: u32 = 40;
const FAR: f64 = 1e120;

fn samples(count: usize) -> String {
    if count == 1 { "1 more sample".to_owned() } else { format!("{count} more samples") }
}

/// Margins of the loop with its final gains, one at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Stability {
    /// The least and the greatest true input gain, in parts of the known one, between which it is stable.
    pub gain: [f64; 2],
    /// Samples of delay beyond those of the design.
    pub delay: usize,
    /// Resonances; `None` if the design has none.
    pub resonance: Option<Damped>,
}

/// Input gains, in parts of the known one, and samples of more delay with which a loop is stable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// The least and the greatest gain between which it is stable.
    pub gain: [f64; 2],
    /// Samples of delay beyond those of the design.
    pub delay: usize,
}

/// Returns the margins of a loop, of which `is_stable` knows whether it is stable with a gain and so many more samples of
/// delay; `None` if it is not stable as it is.
pub fn margin_of(is_stable: &dyn Fn(f64, usize) -> bool) -> Option<Margin> {
    is_stable(1.0, 0).then_some(())?;
    let last = |end: f64| {
        let count = EACH * MOST.log2() as i32;
        let factor = |i: i32| end.powf(f64::from(i) / f64::from(count));
        let Some(bad) = (1..=count).find(|i| !is_stable(factor(*i), 0)) else {
            return end;
        };
        let (mut good, mut bad) = (factor(bad - 1), factor(bad));
        for _ in 0..HALVINGS {
            let middle = (good * bad).sqrt();
            *(if is_stable(middle, 0) { &mut good } else { &mut bad }) = middle;
        }
        good
    };
    let delay = (1..=LATE).take_while(|more| is_stable(1.0, *more)).count();
    Some(Margin { gain: [last(1.0 / MOST), last(MOST)], delay })
}

impl fmt::Display for Stability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // No gain beyond the limits is tried.
        let [low, high] = self.gain;
        let below = if low > 1.0 / MOST { "" } else { "<= " };
        let above = if high < MOST { "" } else { ">= " };
        let late = if self.delay < LATE { "" } else { ">= " };
        write!(
            f,
            "input gains from {below}{} to {above}{} times the nominal one, or {late}{} of delay",
            digits_up(low),
            digits_down(high),
            samples(self.delay)
        )?;
        match &self.resonance {
            Some(damped) => write!(f, "; with the nominal gain and delay {damped}"),
            None => Ok(()),
        }
    }
}

impl Stability {
    /// Returns the share of the wanted margins that it keeps, summed over gain, delay and resonance: 3 for all of them.
    pub(super) fn share(&self, wanted: &Wanted) -> f64 {
        let part =
            |found: f64, asked: f64| if asked > 0.0 { (found / asked).min(1.0) } else { 1.0 };
        let [low, high] = self.gain;
        #[allow(clippy::cast_precision_loss)]
        let delay = part(self.delay as f64, wanted.delay as f64);
        let resonance = self.resonance.as_ref().map_or(1.0, Damped::share);
        part((1.0 / low).min(high).ln(), wanted.gain.ln()) + delay + resonance
    }
}

/// The sample that repeats for ever.
pub(super) struct Stays {
    step: Step,
    rigid: Plant,
    acting: Option<usize>,
    resonances: Option<Resonances>,
}

impl Stays {
    /// Returns the loop whose gains are held at eps; 0 is deadbeat.
    pub(super) fn new(
        closed: &Loop<'_>,
        numbers: &Numbers<'_>,
        chain: &Chain,
        eps: &BigRational,
    ) -> Option<Self> {
        let spec = closed.spec;
        let Some(own) = spec.sampled() else {
            let known = known_gain(spec).ok().and_then(|g| g.to_f64()).unwrap_or(1.0);
            let values: Vec<_> =
                numbers.gains(eps.to_f64()?).iter().map(|gain| gain / known).collect();
            let gains = Gains { errors: vec![0.0; values.len()], values };
            return Some(Self::of(closed, &Sampled::new(chain.clone(), &[gains])));
        };
        let mut held = spec.clone();
        let text = crate::syntax::constant::text(eps);
        held.choose_eps(Fixed::Number { text, value: eps.clone() });
        let last = closed.samples.saturating_sub(1);
        let own = held.sampled().unwrap_or(own);
        let found = emitted::samples(&held, own, chain, None, last..=last)?;
        Some(Self::of(closed, &found.closed(chain.clone())))
    }

    fn of(closed: &Loop<'_>, sampled: &Sampled) -> Self {
        Self {
            step: sampled.step(usize::MAX),
            rigid: Plant::rigid(&sampled.chain),
            acting: sampled.acting(),
            resonances: Resonances::of(closed),
        }
    }

    /// Operations that its margins may take.
    #[allow(clippy::cast_precision_loss)]
    fn operations(&self) -> f64 {
        let size = (self.step.matrix.size + LATE) as f64;
        f64::from(SQUARINGS * TRIALS) * size.powi(3)
    }

    /// Returns its margins, for the resonances of the design or also those `around` them; `None` if it is not stable as
    /// it is.
    pub(super) fn stability(&self, around: bool) -> Option<Stability> {
        let Margin { gain, delay } = margin_of(&|gain, more| self.is_stable(gain, more))?;
        Some(Stability { gain, delay, resonance: self.damped(around) })
    }

    /// Returns true if it is stable within all wanted margins.
    pub(super) fn keeps(&self, wanted: &Wanted) -> bool {
        let steps = (f64::from(EACH) * wanted.gain.log2()).ceil().max(1.0);
        #[allow(clippy::cast_possible_truncation)]
        let steps = steps.min(200.0) as i32;
        let gain = |i: i32| wanted.gain.powf(f64::from(i) / f64::from(steps));
        (0..=wanted.delay).all(|more| self.is_stable(1.0, more))
            && (-steps..=steps).all(|i| self.is_stable(gain(i), 0))
            && self.resists()
    }

    /// Returns true if the loop is stable with a true input gain of `gain` times the known one, that acts `more`
    /// samples later.
    fn is_stable(&self, gain: f64, more: usize) -> bool {
        self.is_stable_with(&self.rigid, gain, more)
    }

    /// The same with another plant.
    fn is_stable_with(&self, plant: &Plant, gain: f64, more: usize) -> bool {
        let (mut matrix, size) = self.matrix(plant, gain, more);
        for _ in 0..SQUARINGS {
            let rows =
                matrix.chunks_exact(size).map(|row| row.iter().map(|x| x.abs()).sum::<f64>());
            let norm = rows.fold(0.0, f64::max);
            if norm < 1.0 {
                return true;
            }
            if norm.is_nan() || norm >= FAR {
                return false;
            }
            let square = |at: usize| {
                let (i, j) = (at / size, at % size);
                (0..size).map(|k| matrix[i * size + k] * matrix[k * size + j]).sum()
            };
            matrix = (0..size * size).map(square).collect();
        }
        false
    }

    /// The transition, with the other states of the plant and then the inputs that are late behind the states.
    fn matrix(&self, plant: &Plant, gain: f64, more: usize) -> (Vec<f64>, usize) {
        let (own, n) = (self.step.matrix.size, plant.n);
        let first = own + plant.others;
        let size = first + more;
        let mut matrix = vec![0.0; size * size];
        let acts = |j: usize| match self.acting {
            Some(kept) => f64::from(u8::from(kept == j)),
            None => self.step.u.of_state[j].0,
        };
        let place = |i: usize| if i < n { i } else { own + i - n };
        let states = n + plant.others;
        for i in 0..states {
            let row = place(i) * size;
            for j in 0..states {
                matrix[row + place(j)] = plant.motion[i * states + j];
            }
            let input = gain * plant.input[i];
            match more {
                0 => (0..own).for_each(|j| matrix[row + j] += input * acts(j)),
                _ => matrix[row + first] += input,
            }
        }
        for i in n..own {
            for j in 0..own {
                matrix[i * size + j] = self.step.matrix.entries[i * own + j];
            }
        }
        // The one that acts next stands first, the one that was computed last behind all.
        for late in 0..more {
            match late + 1 < more {
                true => matrix[(first + late) * size + first + late + 1] = 1.0,
                false => (0..own).for_each(|j| matrix[(first + late) * size + j] = acts(j)),
            }
        }
        (matrix, size)
    }
}
