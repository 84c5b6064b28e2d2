//! Contribution of a reference to a sum over the states of a loop of e.
//!
//! R = (r, r', ...) moves by R_{k+1} = Phi R_k + Gamma rho_k + res_k, res_i the integral of (r^(n) - rho) against
//! (time left)^(n-i)/(n-i)!, and e_{k+1} = Phi e_k + Gamma w_k - res_k. An observer sees the true input and does
//! not see res: an estimate that a controller keeps counts less Phi^-1 (R_{k+1} - Gamma rho_k), so that its
//! prediction is one of e, and Phi^-1 res_k, the integral against (-time gone)^(n-i)/(n-i)!, moves it.
//!
//! For a linear plant R are the states on the reference, rho is the input there, v, and res is the integral of
//! v - rho against exp(A (time left)) B.

use num_traits::{One, Zero};

use super::chain::{Chain, Near, Unit, along, centre};
use super::followed::Followed;
use super::force;
use super::gain::Gain;
use super::rounded::ROUNDED;
use super::worst::Sampled;
use crate::algebra::BigRational;
use crate::expression::enclosure::{Interval, Range};
use crate::linear::{self, Delay, Linear, zero_order_hold};

/// Disturbance of a loop of e by a reference, and its share of u.
#[derive(Clone, Debug)]
pub(super) struct Moved {
    /// Contribution of r^(n+1) = 1 to each state in a sample, by the distance from the middle.
    slanted: Vec<Near>,
    /// The most that |r^(n) - rho| <= 1 adds, and of the plant alone.
    whole: Vec<Near>,
    plant: Vec<Near>,
    /// Places of the kept estimates of a chain, with the state of each; `None` for another plant.
    estimates: Option<Vec<(usize, usize)>>,
    slope: f64,
    /// r^(n+1) and r^(n+2) in the middle of each sample, where they are known.
    known: Vec<[Near; 2]>,
    /// Contribution of r^(n+2) = 1 to each state in a sample, by the square of that distance; `None` for another plant
    /// than a chain, where any signal replaces it.
    bent: Option<Vec<Near>>,
    curve: f64,
    /// Bound of what is left of |r^(n) - rho| beside both.
    left: f64,
    rest: f64,
    /// Contribution of rho where the input gain is not that of the law.
    wrong: f64,
    /// Bound of rho as an input, and of what that is with the gain of the plant.
    pub(super) input: f64,
    pub(super) acting: f64,
    /// Largest distance of each state of the plant, between two samples, from where the input alone brings it.
    pub(super) between: Vec<f64>,
}

/// Response of a linear plant to an input in a sample.
#[derive(Clone, Debug)]
pub(super) struct Response {
    /// Response to an input that is the time from the middle.
    slanted: Vec<Near>,
    /// Largest response to any input signal of size at most 1.
    most: Vec<Near>,
}

impl Response {
    /// `None` if a mode is too fast for the period `h`.
    pub(super) fn new(plant: &Linear, h: &BigRational) -> Option<Self> {
        let n = plant.b.len();
        // The input is the last state of a plant whose input is its rate: it is what is left of the time, twice.
        let mut a = plant.a.clone();
        a.iter_mut().zip(&plant.b).for_each(|(row, b)| row.push(b.clone()));
        a.push(vec![BigRational::zero(); n + 1]);
        let mut b = vec![BigRational::zero(); n + 1];
        b[n] = BigRational::one();
        let ramp = zero_order_hold(&Linear { a, b, c: Vec::new() }, h, &Delay::default())?;
        let half = h / BigRational::from_integer(2.into());
        let near = |value: &BigRational| centre(Range::from(&Interval::exact(value)), 0.0);
        let slanted = (0..n).map(|i| &ramp.newer[i] + &ramp.older[i] - &ramp.phi[i][n] * &half);
        // |exp(A s) B| at no time of the sample is more than this.
        let kick = linear::Between::new(plant, h)?.kick(plant, &BigRational::zero())?;
        Some(Self {
            slanted: slanted.map(|value| near(&value)).collect(),
            most: kick.iter().map(|kick| near(&(kick * h))).collect(),
        })
    }
}

impl Moved {
    /// Computes the effect on a loop of a linear plant.
    pub(super) fn of_plant(
        followed: &Followed,
        sampled: &Sampled,
        response: &Response,
        gain: &Gain,
    ) -> Self {
        let filled = |column: &[Near]| {
            let mut column = column.to_vec();
            column.resize(sampled.size(), (0.0, 0.0));
            column
        };
        let input = followed.size(response.most.len());
        let wrong = off(gain, Range::from(1.0)) * input;
        let beside = 2.0 * (followed.most + wrong) * ROUNDED;
        Self {
            slanted: filled(&response.slanted),
            whole: filled(&response.most),
            plant: filled(&response.most),
            estimates: None,
            slope: followed.slope,
            bent: None,
            curve: 0.0,
            left: 0.0,
            known: followed.known.clone(),
            rest: followed.rest,
            wrong,
            input,
            acting: (input + wrong) * ROUNDED,
            between: response
                .most
                .iter()
                .map(|(most, error)| beside * (most + error) * ROUNDED)
                .collect(),
        }
    }

    /// Computes the effect on a loop of a chain whose law divides by `known`, of a plant with a `gain`.
    pub(super) fn new(followed: &Followed, sampled: &Sampled, known: Range, gain: &Gain) -> Self {
        let chain = &sampled.chain;
        let (n, h) = (chain.moved, chain.shares[1]);
        let size = sampled.size();
        let estimates = (chain.n..size).filter_map(|place| {
            let state = match sampled.unit(place) {
                Unit::Gain(j) => j,
                Unit::Power(power) => (n + 1).checked_sub(usize::try_from(power).ok()?)?,
            };
            (1..=n).contains(&state).then_some((place, state))
        });
        let estimates: Vec<_> = estimates.collect();
        let plant: Vec<_> = (1..=n).map(|state| (state - 1, state)).collect();
        let of = |places: &[(usize, usize)], value: &dyn Fn(usize) -> f64| {
            let mut column = vec![(0.0, 0.0); size];
            for (place, state) in places {
                let value = value(n - state);
                column[*place] = (value, 4.0 * f64::EPSILON * value.abs());
            }
            column
        };
        let share = |m: usize| chain.shares[m + 1];
        // The integral of (s - h/2) against s^m/m!, with the sign of the time left or gone.
        let slant = |m: usize| {
            let count = real(m);
            h * h * chain.shares[m] * count / (2.0 * (count + 1.0) * (count + 2.0))
        };
        let mut slanted = of(&plant, &|m| -slant(m));
        let turned = |m: usize| if m.is_multiple_of(2) { slant(m) } else { -slant(m) };
        let kept = of(&estimates, &turned);
        slanted[chain.n..].copy_from_slice(&kept[chain.n..]);
        // The integral of (s - h/2)^2/2 against s^m/m!.
        let bend = |m: usize| {
            let [one, two, three] = [1, 2, 3].map(|more| real(m + more));
            h * h * h * chain.shares[m] * (1.0 / three - 1.0 / two + 0.25 / one) / 2.0
        };
        let turned = |m: usize| if m.is_multiple_of(2) { bend(m) } else { -bend(m) };
        let kept = of(&estimates, &turned);
        let mut bent = of(&plant, &bend);
        bent[chain.n..].copy_from_slice(&kept[chain.n..]);
        // The sum cancels.
        bent.iter_mut()
            .for_each(|(value, error)| *error += 1e-14 * h * h * h + 1e-13 * value.abs());
        let all = [plant.as_slice(), &estimates].concat();
        let rate = followed.size(n);
        let wrong = off(gain, known) * rate;
        let beside = 2.0 * (followed.most + wrong);
        Self {
            slanted,
            whole: of(&all, &share),
            plant: of(&plant, &share),
            estimates: Some(estimates),
            slope: followed.slope,
            bent: Some(bent),
            curve: followed.curve,
            left: followed.left,
            known: followed.known.clone(),
            rest: followed.rest,
            wrong,
            input: (Range::from(rate) / known.size()).high(),
            acting: (rate + wrong) * ROUNDED,
            between: (1..=n).map(|state| beside * share(n - state) * ROUNDED).collect(),
        }
    }

    /// Returns the contribution to what `row` sees in sample `k`: a value, and the largest deviation from it.
    pub(super) fn adds(&self, chain: &Chain, row: &[f64], k: usize) -> (f64, f64) {
        let any = |size: f64, estimates: &[(usize, usize)]| match (size, &self.estimates) {
            (0.0, _) => 0.0,
            (size, Some(_)) => size * force::most(chain, row, estimates)[1],
            (size, None) => {
                let parts = row.iter().zip(&self.whole);
                size * parts.map(|(p, (most, error))| p.abs() * (most + error)).sum::<f64>()
                    * ROUNDED
            }
        };
        let slanted = along(row, &self.slanted);
        let estimates = self.estimates.as_deref().unwrap_or_default();
        let wrong = any(self.wrong, &[]);
        match (self.known.get(k), &self.bent) {
            (Some([(slope, about), (curve, near)]), Some(bent)) => {
                let bent = along(row, bent);
                let most = about * slanted.abs() + near * bent.abs() + any(self.left, estimates);
                (slope * slanted + curve * bent, most + wrong)
            }
            (Some([(slope, about), _]), None) => {
                (slope * slanted, about * slanted.abs() + any(self.rest, estimates) + wrong)
            }
            (None, _) => (0.0, self.slope * slanted.abs() + any(self.rest, estimates) + wrong),
        }
    }

    /// The columns of its causes with their bounds.
    pub(super) fn causes(&self) -> Vec<(&Vec<Near>, f64)> {
        let bent = self.bent.iter().map(|bent| (bent, self.curve));
        let all =
            [(&self.slanted, self.slope), (&self.whole, self.rest), (&self.plant, self.wrong)];
        all.into_iter().chain(bent).collect()
    }
}

/// Bounds the relative difference of the input gain of a plant from the `known` one. Two ranges of the same number are
/// a rounding apart.
fn off(gain: &Gain, known: Range) -> f64 {
    let ends = [-1.0, 1.0].map(|side| gain.value * Range::from(1.0 + side * gain.error));
    let [low, high] = ends.map(|end| (end / known - Range::from(1.0)).size().high());
    low.max(high)
}

#[allow(clippy::cast_precision_loss)]
pub(super) fn real(count: usize) -> f64 {
    count as f64
}
