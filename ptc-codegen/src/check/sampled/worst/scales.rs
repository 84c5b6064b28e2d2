//! The scaling of the states in which errors fade.

use super::super::chain::Unit;
use super::super::transition::growth;
use super::super::trust::Fading;
use super::{Output, Sampled, earlier};

/// A scaling of the states at each sample.
pub(in crate::check::sampled) struct Scales {
    size: usize,
    all: Vec<f64>,
}

impl Scales {
    pub(in crate::check::sampled) fn at(&self, k: usize) -> &[f64] {
        &self.all[k * self.size..][..self.size]
    }

    fn at_mut(&mut self, k: usize) -> &mut [f64] {
        &mut self.all[k * self.size..][..self.size]
    }
}

impl Sampled {
    /// The scalings of s at samples 0..=at in which all states are alike: x_j in units of u times a power
    /// of the time scale of the gains.
    pub(in crate::check::sampled) fn scales(&self, at: usize) -> Scales {
        let size = self.size();
        let mut all = Vec::with_capacity((at + 1) * size);
        for k in 0..=at {
            let gain = self.chain.gain.abs();
            let row = self.of_u(k).0.iter().zip(&self.units);
            let pace = row.filter_map(|((value, _), unit)| match unit {
                Unit::Power(power) if *power > 0 => {
                    Some((value * gain).abs().powf(1.0 / f64::from(*power)))
                }
                Unit::Power(_) | Unit::Gain(_) => None,
            });
            let time = 1.0 / pace.fold(1.0 / (1e6 * self.chain.shares[1]), f64::max);
            let time = time.max(self.chain.shares[1]);
            let state = |unit: &Unit| match unit {
                Unit::Power(0) => 1.0,
                Unit::Power(power) => 1.0 / (time.powi(*power) * gain),
                Unit::Gain(j) => {
                    self.gains.get(j).map_or(1.0, |gains| gains[k.min(gains.len() - 1)])
                }
            };
            all.extend(self.units.iter().map(state));
        }
        Scales { size, all }
    }

    /// The bound of the transitions up to sample `at`, where what the output sees counts alike at
    /// every sample; with `None` all instants are seen alike.
    pub(in crate::check::sampled) fn fading(
        &self,
        output: Option<&Output>,
        at: usize,
    ) -> Option<Fading> {
        let mut scales = self.scales(at);
        if let Some(output) = output {
            let mut row = self.row(output, at);
            let mut room = vec![0.0; self.size()];
            let mut walk = self.walk(false);
            for k in (0..=at).rev() {
                let own = scales.at_mut(k);
                let seen: f64 = row.iter().zip(&*own).map(|(p, d)| (p / d).abs()).sum();
                let seen = seen.max(f64::MIN_POSITIVE * 1e30);
                own.iter_mut().for_each(|d| *d *= seen);
                if k > 0 {
                    earlier(&walk.at(k - 1).matrix, &mut row, &mut room);
                }
            }
        }
        let growth = growth(at, &mut self.walk(true), &scales)?;
        let mut walk = self.walk(true);
        let errors = (0..at).map(|k| walk.at(k).matrix.error_norm(scales.at(k + 1), scales.at(k)));
        Some(Fading { errors: errors.collect(), scales, growth })
    }
}
