//! Sums over the states of a chain of integrators and the input that acts, between the samples too.
//!
//! Within a sample such a sum is a polynomial of the degree of the chain, and within its control points in Bernstein's
//! form. Each is a sum over the states at the sample and its input, so that its worst case is that of an output: terms
//! that cancel in the sum cancel in its bound. The movement of the plant beside u within the sample is added to each.

use super::span::Span;
use super::trust::Trust;
use super::worst::{Output, Sampled};

/// A sum over x_1..x_n and the input that acts.
#[derive(Clone, Debug, PartialEq)]
pub struct Sum {
    /// Weight of each state.
    pub states: Vec<f64>,
    /// Weight of the input, as the actuator resolves it.
    pub input: f64,
}

/// More than the rounding of a weight of a control point, as a part of its terms.
const ROUNDED: f64 = 1e-13;

impl Sampled {
    /// Bounds that an instant or a sample takes for all sums.
    pub(super) fn outputs_of_sums(&self) -> usize {
        if self.knows_sums() { self.sums.len() * (self.chain.n + 1) } else { 0 }
    }

    /// Returns true if the plant is a chain whose inputs are switched in time.
    pub(super) fn knows_sums(&self) -> bool {
        self.chain.outputs.is_none()
            && self.between.is_some()
            && self.late.is_none()
            && self.moved.is_none()
    }

    /// Bounds each sum at sample `k`, where the states are within `here`, and up to the next one if `on` is set.
    pub(super) fn sums(
        &self,
        k: usize,
        on: bool,
        here: &[Span],
        trust: Option<Trust<'_>>,
    ) -> Vec<Span> {
        let n = self.chain.n;
        let input = self.bound(&self.acts(), k, trust).total() + self.actuator;
        let sizes: Vec<_> = here[..n].iter().map(|span| span.size()).chain([input]).collect();
        let last = if on { n } else { 0 };
        let points = |sum: &Sum| {
            let all = (0..=last).map(|m| self.control_point(sum, m, (k, &sizes), trust));
            all.reduce(Span::hull).unwrap_or_default()
        };
        self.sums.iter().map(points).collect()
    }

    /// Bounds control point `m` of a sum in sample `k`, whose states and input have these sizes.
    fn control_point(
        &self,
        sum: &Sum,
        m: usize,
        (k, sizes): (usize, &[f64]),
        trust: Option<Trust<'_>>,
    ) -> Span {
        let (n, gain) = (self.chain.n, self.chain.gain);
        let weights = self.weights(&sum.states, m);
        let mut output = Output { row: vec![0.0; self.size()], direct: 0.0, change: false };
        output.row[..n].copy_from_slice(&weights[..n]);
        let direct = weights[n] * gain + sum.input;
        match self.acting() {
            None => output.direct = direct,
            Some(kept) => output.row[kept] += direct,
        }
        let terms: Vec<_> = sum.states.iter().map(|weight| weight.abs()).collect();
        let terms = self.weights(&terms, m);
        let of_input = terms[n] * self.greatest_gain() + sum.input.abs();
        let states = terms[..n].iter().zip(sizes).map(|(term, size)| term * size).sum::<f64>();
        let rounding = ROUNDED * (states + of_input * sizes[n]);
        let of_gain = terms[n] * gain.abs() * self.of_gain(trust, k);
        let span = self.bound(&output, k, trust).span();
        span.wider(rounding + of_gain + self.beside(&terms, m, of_input))
    }

    /// Returns the weights in control point `m`: those of the states at the sample, then that of the movement of x_n by
    /// the input.
    fn weights(&self, states: &[f64], m: usize) -> Vec<f64> {
        let n = self.chain.n;
        let mut weights = vec![0.0; n + 1];
        // binom(m, l)/binom(n, l) h^l/l!
        let mut part = 1.0;
        for l in 0..=m {
            for (i, weight) in states.iter().enumerate().take(n + 1 - l) {
                weights[i + l] += part * self.chain.shares[l] * weight;
            }
            #[allow(clippy::cast_precision_loss)]
            if l < m {
                part *= (m - l) as f64 / (n - l) as f64;
            }
        }
        weights
    }

    /// Bounds the contribution of f and the actuator within a sample, which is not part of the states at its start.
    fn beside(&self, terms: &[f64], m: usize, of_input: f64) -> f64 {
        // A kept input is the input before the actuator.
        let actuator = self.acting().map_or(0.0, |_| of_input * self.actuator);
        let force = self.force.as_ref().filter(|_| m > 0).map_or(0.0, |force| {
            let n = self.chain.n;
            // Effect of a force of 1 on the weighted states.
            let moved: f64 = (0..n).map(|i| terms[i] * self.chain.shares[n - i]).sum();
            moved * force.most()
        });
        (actuator + force) * (1.0 + ROUNDED)
    }
}
