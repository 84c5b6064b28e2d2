//! The feasible set in the plane of x1 and x2: from where which deadline keeps the limits.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::{Limited, Unlimited};
use crate::linear::Peak;
use crate::request::Spec;

/// Directions in which an outline is looked for.
const DIRECTIONS: u32 = 360;

/// Halvings of the distance to an outline.
const HALVINGS: u32 = 16;

/// Doublings of that distance, after which a set has no end.
const DOUBLINGS: u32 = 60;

/// The longest deadline that is drawn, in parts of tau.
const FARTHEST: f64 = 1.25;

/// The states from which deadlines keep the limits, with the other states at 0.
#[derive(Clone, Debug, PartialEq)]
pub struct FeasibleSet {
    /// From where tau of the design keeps the limits.
    pub kept: Outline,
    /// From where the soonest deadline is at most some others, which ascend.
    pub soonest: Vec<Outline>,
}

/// The outline of a set of states that belongs to a deadline.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// The deadline in s.
    pub tau: f64,
    /// The states, x1 and x2, once around.
    pub states: Vec<(f64, f64)>,
}

impl FeasibleSet {
    /// Computes the set of a design.
    ///
    /// # Errors
    /// Why there is none.
    pub fn of(spec: &Spec) -> Result<Self, Unlimited> {
        if spec.n < 2 && spec.sampled().is_some() {
            return Err(Unlimited {
                why: "a chain of order 1 has no plane of two states",
                help: "leave --plot out: `check` prints the largest |x1|, and the soonest tau",
            });
        }
        let limited = Limited::new(spec)?;
        let left = limited.samples().and_then(|own| own.checked_sub(limited.spare));
        let Some(left) = left.filter(|left| *left > limited.horizon.rest()) else {
            return Err(Unlimited {
                why: "tau has no value, or is shorter than the held gains",
                help: "give tau, the deadline for which the limits are marked",
            });
        };
        Plane::new(&limited).set(left).ok_or(Unlimited {
            why: "the limits bound no set around rest in the plane of x1 and x2",
            help: "give limits that u and the states may reach",
        })
    }
}

/// The plane, with what limits have to admit of unit states 1 and 2, by the samples to go.
struct Plane<'a> {
    limited: &'a Limited<'a>,
    known: BTreeMap<u32, Vec<[Peak; 2]>>,
}

impl<'a> Plane<'a> {
    fn new(limited: &'a Limited<'a>) -> Self {
        Self { limited, known: BTreeMap::new() }
    }

    /// Returns true if the limits are kept from a state with `left` samples to go.
    fn keeps(&mut self, x: (f64, f64), left: u32) -> bool {
        let limited = self.limited;
        let all = self.known.entry(left).or_insert_with(|| {
            let mut units = limited.units.iter().take(2).map(|z| limited.horizon.values(z, left));
            let (first, second) = (units.next(), units.next());
            let pairs = first.into_iter().flatten().zip(second.into_iter().flatten());
            pairs.map(|(first, second)| [first, second]).collect()
        });
        all.iter().all(|[first, second]| {
            let (limits, value) =
                (limited.limits(first.signal), x.0 * first.value + x.1 * second.value);
            match first.is_signed {
                true => limits.contains(value),
                false => value.abs() <= limits.radius(),
            }
        })
    }

    /// Returns the soonest deadline from a state, in samples to go.
    fn soonest(&mut self, x: (f64, f64)) -> Option<u32> {
        let limited = self.limited;
        limited.search(&mut |left| self.keeps(x, left))
    }

    /// The outlines for `left` samples to tau.
    fn set(&mut self, left: u32) -> Option<FeasibleSet> {
        let alone = self.limited.alone(left);
        let even = [[alone[0], 0.0], [0.0, alone[1]]];
        if !alone[..2].iter().all(|most| most.is_finite() && *most > 0.0) {
            return None;
        }
        // Directions that are even around a long set meet its ends as often as its sides.
        let first = outline(&even, &mut |x| self.keeps(x, left))?;
        let axes = axes(&first);
        let kept = Outline {
            tau: self.limited.tau(left)?,
            states: outline(&axes, &mut |x| self.keeps(x, left))?,
        };
        let mut soonest = Vec::new();
        for most in self.levels(left)? {
            let within = &mut |x| self.soonest(x).is_some_and(|found| found <= most);
            let states = outline(&axes, within)?;
            soonest.push(Outline { tau: self.limited.tau(most)?, states });
        }
        Some(FeasibleSet { kept, soonest })
    }

    /// The samples to go of the deadlines that are drawn: at round times, other than tau.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn levels(&self, left: u32) -> Option<Vec<u32>> {
        let (tau, period) = (self.limited.tau(left)?, self.limited.period()?);
        let step = round(0.25 * tau);
        let count = (FARTHEST * tau / step * (1.0 + 1e-9)).floor() as u32;
        let samples = (1..=count).map(|k| (f64::from(k) * step / period).round() as u32);
        let to_go = samples.filter_map(|own| own.checked_sub(self.limited.spare));
        let rest = self.limited.horizon.rest();
        let mut levels: Vec<_> = to_go.filter(|own| *own > rest && *own != left).collect();
        levels.dedup();
        Some(levels)
    }
}

/// The outline of a set that contains every state between one of its own and 0, along directions around an ellipse
/// with these axes; `None` if it has no end, or is empty.
///
/// The deadlines that keep the limits from a state keep them from each part of it, and with more of them the search
/// ends at one that is as soon, or sooner.
fn outline(
    axes: &[[f64; 2]; 2],
    contains: &mut dyn FnMut((f64, f64)) -> bool,
) -> Option<Vec<(f64, f64)>> {
    if !contains((0.0, 0.0)) {
        return None;
    }
    let mut states = Vec::new();
    for index in 0..DIRECTIONS {
        let (sine, cosine) = (TAU * f64::from(index) / f64::from(DIRECTIONS)).sin_cos();
        let along = |i: usize| cosine * axes[i][0] + sine * axes[i][1];
        let at = |part: f64| (part * along(0), part * along(1));
        let (mut low, mut high) = (0.0, 1.0);
        let doubled = (0..DOUBLINGS).any(|_| {
            let is_outside = !contains(at(high));
            if !is_outside {
                (low, high) = (high, 2.0 * high);
            }
            is_outside
        });
        if !doubled {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            match contains(at(middle)) {
                true => low = middle,
                false => high = middle,
            }
        }
        states.push(at(low));
    }
    Some(states)
}

/// Axes of an ellipse as long and wide as an outline: a square root of its second moments.
fn axes(outline: &[(f64, f64)]) -> [[f64; 2]; 2] {
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| {
        outline.iter().map(of).sum::<f64>() / f64::from(DIRECTIONS)
    };
    let (a, b, c) = (mean(&|x| x.0 * x.0), mean(&|x| x.0 * x.1), mean(&|x| x.1 * x.1));
    let first = a.sqrt();
    let second = b / first;
    [[first, 0.0], [second, (c - second * second).max(0.0).sqrt()]]
}

/// The number of 1, 2, 2.5 or 5 times a power of ten that is nearest to a value > 0.
fn round(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    let near = |a: &f64, b: &f64| (a * power - value).abs().total_cmp(&(b * power - value).abs());
    [1.0, 2.0, 2.5, 5.0, 10.0].into_iter().min_by(near).unwrap_or(1.0) * power
}
