//! Resonances with which the loop that stays is stable, of all that the design allows and around them.

use std::fmt;

use num_traits::ToPrimitive;

use super::super::gain::Gain;
use super::super::judge::Loop;
use super::Stays;
use super::plant::{Flexible, Plant};
use crate::algebra::BigRational;
use crate::diagnostic::{digits_down, digits_up};
use crate::linear::{Joint, Linear};
use crate::request::Resonance;

/// Step of the frequency, as a part of it, and of a turn in a sample.
const STEP: f64 = 0.03;
const TURN: f64 = 1.0 / 40.0;

/// Halvings between a frequency that is stable and one that is not.
const HALVINGS: u32 = 10;

/// Frequencies that are looked at around those of the design: from this part of the lowest one to the multiple of the
/// highest one, and to this multiple of the sampling frequency.
const BELOW: f64 = 0.5;
const ABOVE: f64 = 2.0;
const SAMPLED: f64 = 1.5;

/// The resonances that a design allows, with its plant.
#[derive(Clone, Debug)]
pub(super) struct Resonances {
    flexible: Flexible,
    frequency: [f64; 2],
    /// Ends and middle of damping, ratio of inertia and input gain.
    corners: Vec<(f64, f64, f64)>,
}

/// Frequencies in Hz, from the lower one to the higher one.
pub(crate) type Band = [f64; 2];

/// Resonances with which the loop with its final gains is stable.
#[derive(Clone, Debug, PartialEq)]
pub struct Damped {
    /// Frequencies of the design, lowest and highest one, in Hz.
    pub given: [f64; 2],
    /// Frequencies that were looked at.
    pub examined: [f64; 2],
    /// Ranges of them with which the loop is not stable.
    pub unstable: Vec<[f64; 2]>,
}

impl Resonances {
    /// Returns the resonances of a design; `None` without a resonance.
    pub(super) fn of(closed: &Loop<'_>) -> Option<Self> {
        let spec = closed.spec;
        let Resonance { frequency, damping, inertia_ratio, measured } =
            spec.promises.resonance.as_ref()?;
        let integrators = Linear::chain(spec.n, &BigRational::from_integer(1.into()), spec.n);
        let linear = spec.sampled().and_then(|own| own.linear.as_ref());
        let part = spec.promises.delay.clone().unwrap_or_default().part();
        let h = closed.period.middle();
        let flexible = Flexible::new(linear.unwrap_or(&integrators), h, &part, *measured);
        let gain: Gain = closed.gain();
        let number = |value: &BigRational| value.to_f64().unwrap_or(f64::NAN);
        let ends = |ends: &[BigRational; 2]| ends.each_ref().map(number);
        let gains = [1.0 - gain.error, 1.0 + gain.error];
        let all = [ends(damping), ends(inertia_ratio), gains];
        Some(Self {
            flexible: flexible.with_gain(gain.value.middle()),
            frequency: ends(frequency),
            corners: corners(all),
        })
    }

    /// The plants with a resonance of a frequency, each with a part of the input gain.
    fn plants(&self, frequency: f64) -> impl Iterator<Item = Option<(Plant, f64)>> {
        self.corners.iter().map(move |&(damping, inertia_ratio, gain)| {
            let joint = Joint { frequency, damping, inertia_ratio };
            Some((self.flexible.plant(joint)?, gain))
        })
    }

    /// Frequencies from one to another, both included, close enough to see what lies between.
    fn grid(&self, [low, high]: Band) -> Vec<f64> {
        let mut all = vec![low];
        let mut at = low;
        while at < high {
            at += (STEP * at).min(TURN / self.flexible.h);
            all.push(at.min(high));
        }
        all
    }
}

/// All ends, and the middle of all; one where nothing is uncertain.
fn corners(all: [[f64; 2]; 3]) -> Vec<(f64, f64, f64)> {
    let mut found = Vec::new();
    for damping in all[0] {
        for ratio in all[1] {
            for gain in all[2] {
                found.push((damping, ratio, gain));
            }
        }
    }
    let middle = all.map(|[low, high]| 0.5 * (low + high));
    found.push((middle[0], middle[1], middle[2]));
    found.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    found.dedup();
    found
}

impl Stays {
    /// Returns true if it is stable with every resonance of the design; `true` without one.
    pub(super) fn resists(&self) -> bool {
        let Some(resonances) = &self.resonances else { return true };
        // Frequencies that most often fail come first.
        let mut grid = resonances.grid(resonances.frequency);
        let middle = grid.len() / 2;
        grid.rotate_left(middle);
        grid.into_iter().all(|frequency| self.is_damped(resonances, frequency))
    }

    /// Returns the resonances with which it is stable: of the design alone, or also those around them.
    pub(super) fn damped(&self, around: bool) -> Option<Damped> {
        let resonances = self.resonances.as_ref()?;
        let [low, high] = resonances.frequency;
        let examined = match around {
            true => [BELOW * low, (ABOVE * high).max(SAMPLED / resonances.flexible.h)],
            false => [low, high],
        };
        let grid = resonances.grid(examined);
        let stable = |frequency: f64| self.is_damped(resonances, frequency);
        // The stable frequency closest to the unstable one.
        let edge = |mut good: f64, mut bad: f64| {
            for _ in 0..HALVINGS {
                let middle = (good * bad).sqrt();
                *(if stable(middle) { &mut good } else { &mut bad }) = middle;
            }
            good
        };
        let mut unstable: Vec<Band> = Vec::new();
        let mut before: Option<(f64, bool)> = None;
        for frequency in grid {
            let is_stable = stable(frequency);
            match before {
                None if !is_stable => unstable.push([frequency; 2]),
                Some((last, true)) if !is_stable => unstable.push([edge(last, frequency); 2]),
                Some((last, false)) if is_stable => {
                    let end = edge(frequency, last);
                    unstable.last_mut().into_iter().for_each(|band| band[1] = end);
                }
                _ => {}
            }
            if !is_stable && let Some(band) = unstable.last_mut() {
                band[1] = band[1].max(frequency);
            }
            before = Some((frequency, is_stable));
        }
        Some(Damped { given: resonances.frequency, examined, unstable })
    }

    /// Returns true if it is stable with all resonances of a frequency.
    fn is_damped(&self, resonances: &Resonances, frequency: f64) -> bool {
        let mut plants = resonances.plants(frequency);
        plants.all(|plant| plant.is_some_and(|(plant, gain)| self.is_stable_with(&plant, gain, 0)))
    }
}

impl Damped {
    /// Frequencies of the design with which the loop is not stable.
    pub fn exceeded(&self) -> Vec<[f64; 2]> {
        let [low, high] = self.given;
        let common = |band: &Band| [band[0].max(low), band[1].min(high)];
        let all = self.unstable.iter().map(common);
        all.filter(|band| band[0] <= band[1]).collect()
    }

    /// Part of the frequencies of the design, in their logarithm, with which the loop is stable.
    pub(super) fn share(&self) -> f64 {
        let [low, high] = self.given;
        let lost: f64 = self.exceeded().iter().map(|[a, b]| (b / a).ln()).sum();
        match (high / low).ln() {
            whole if whole > 0.0 => 1.0 - lost / whole,
            _ if self.exceeded().is_empty() => 1.0,
            _ => 0.0,
        }
    }

    /// The frequency above which every one that was looked at leaves the loop stable; `None` if the highest does not.
    pub fn above(&self) -> Option<f64> {
        let last = self.unstable.last()?[1];
        (last < self.examined[1]).then_some(last)
    }
}

/// Bands in words, with the word before them.
pub(crate) fn bands(all: &[Band]) -> String {
    let one = |[low, high]: &Band| match low < high {
        true => format!("from {} to {} Hz", digits_down(*low), digits_up(*high)),
        false => format!("at {} Hz", digits_down(*low)),
    };
    all.iter().map(one).collect::<Vec<_>>().join(", ")
}

impl fmt::Display for Damped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.unstable.is_empty() {
            return write!(f, "stable for resonances {}", bands(&[self.examined]));
        }
        write!(f, "unstable for resonances {}", bands(&self.unstable))?;
        if let Some(last) = self.above() {
            write!(f, ", and stable above {} Hz", digits_up(last))?;
        }
        write!(f, " (of those {})", bands(&[self.examined]))
    }
}
