//! What a choice of poles costs: peak and energy of u beside those of the law of least energy.

use num_traits::ToPrimitive;

use super::peaks::Responses;
use crate::diagnostic::digits;
use crate::expansion::Expanded;
use crate::linear::Weights;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Clock, DelayLaw, Exponents, LeastEnergy, Sampled, Spec, gains};
use crate::syntax::constant;

/// The law with the least sum of u^2.
const LEAST: LeastEnergy = LeastEnergy { weight: 0 };

/// The least relative difference that is reported.
const APART: f64 = 0.005;

/// Peak and energy of u.
#[derive(Clone, Copy)]
struct Effort {
    peak: f64,
    energy: f64,
}

impl Effort {
    /// The parts of another one, of which both are larger than 0.
    fn by(self, other: Self) -> Self {
        Self { peak: self.peak / other.peak, energy: self.energy / other.energy }
    }
}

/// Compares the effort of a law in samples with that of least energy, from the start of the design, or
/// from each x_i alone without one; `None` where it is this law, or one of the two loops is not known.
pub(super) fn compared(spec: &Spec, expanded: Option<&Expanded>) -> Option<String> {
    let least = with_least_energy(spec)?;
    let own = Responses::of(spec, expanded)?.of_state;
    let best = Responses::of(&least, expanded)?.of_state;
    let parts: Vec<_> = starts(spec)
        .iter()
        .map(|start| worst(&own, start).by(worst(&best, start)))
        .filter(|part| part.peak.is_finite() && part.energy.is_finite())
        .collect();
    let greatest = |value: fn(&Effort) -> f64| parts.iter().map(value).fold(f64::NAN, f64::max);
    let [peak, energy] = [greatest(|part| part.peak), greatest(|part| part.energy)];
    let is_apart = [peak, energy].iter().any(|part| (part - 1.0).abs() > APART);
    is_apart.then(|| {
        format!(
            "peak of |u| {} and energy {} times those of the law of least energy",
            digits(peak),
            digits(energy)
        )
    })
}

/// The same design with the law of least energy, by prediction where there is a delay.
fn with_least_energy(spec: &Spec) -> Option<Spec> {
    let sampled =
        spec.sampled().filter(|own| own.exponents.is_some() || spec.schedule().is_some())?;
    if spec.axes.is_some() || spec.has_model() || spec.promises.resonance.is_some() {
        return None;
    }
    if sampled.linear.is_some() {
        return with_least_gains(spec, sampled);
    }
    let rate = spec.fixed.get(&Parameter::A).and_then(Fixed::number)?;
    let poles = LEAST.poles(spec.n, rate);
    let gains = gains(&poles).ok()?;
    let mut least = spec.clone();
    least.fixed.retain(|p, _| !matches!(p, Parameter::Gain(_) | Parameter::Deadbeat));
    let number = |value| Fixed::Number { text: constant::text(&value), value };
    least.fixed.extend((1..).zip(gains).map(|(i, gain)| (Parameter::Gain(i), number(gain))));
    least.poles = poles.into_iter().map(|pole| (pole.re, pole.im)).collect();
    let mut all = LEAST.exponents(spec.n);
    let first = all.next()?;
    let greatest = all.last().unwrap_or_else(|| first.clone());
    let exponents = Exponents { least: first, greatest, consecutive: true };
    least.clock = Clock::Samples(Box::new(Sampled {
        exponents: Some(exponents),
        end: None,
        delay_law: DelayLaw::Predict,
        ..sampled.clone()
    }));
    Some(least)
}

/// The same of a linear plant.
fn with_least_gains(spec: &Spec, sampled: &Sampled) -> Option<Spec> {
    let sampled =
        Sampled { exponents: None, end: None, delay_law: DelayLaw::Predict, ..sampled.clone() };
    let schedule = sampled.gains(spec, Weights { law: LEAST.weight, end: None }, None)?.ok()?;
    let mut least = spec.clone();
    least.follow(schedule);
    least.clock = Clock::Samples(Box::new(sampled));
    Some(least)
}

/// The largest x of each state at the start, or each of them alone at 1.
fn starts(spec: &Spec) -> Vec<Vec<f64>> {
    let bounds = &spec.promises.x0_max;
    let double = |bound: &Fixed| bound.number().and_then(ToPrimitive::to_f64);
    let given: Vec<_> = bounds.iter().map(|own| double(own).unwrap_or(f64::NAN)).collect();
    if given.len() == spec.n && given.iter().all(|x| x.is_finite()) {
        return vec![given];
    }
    let alone = |i: usize| (0..spec.n).map(|j| f64::from(u8::from(i == j))).collect();
    (0..spec.n).map(alone).collect()
}

/// The largest peak and the largest energy over the box of a start.
fn worst(of_state: &[Vec<f64>], start: &[f64]) -> Effort {
    let samples = 0..of_state.first().map_or(0, Vec::len);
    let at = |k: usize| of_state.iter().zip(start).map(|(u, x)| u[k].abs() * x).sum::<f64>();
    let peak = samples.map(at).fold(0.0, f64::max);
    let product = |(a, x): (&Vec<f64>, &f64), (b, y): (&Vec<f64>, &f64)| {
        x * y * a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>()
    };
    let all = || of_state.iter().zip(start);
    let squares: Vec<Vec<_>> =
        all().map(|own| all().map(|other| product(own, other)).collect()).collect();
    let corner = |signs: usize| {
        let sign = |j: usize| if signs >> j & 1 == 0 { 1.0 } else { -1.0 };
        let row = |(i, row): (usize, &Vec<f64>)| {
            row.iter().enumerate().map(|(j, square)| sign(i) * sign(j) * square).sum::<f64>()
        };
        squares.iter().enumerate().map(row).sum()
    };
    // Opposite corners need the same.
    let corners = 0..1_usize << start.len().saturating_sub(1);
    Effort { peak, energy: corners.map(corner).fold(0.0, f64::max) }
}
