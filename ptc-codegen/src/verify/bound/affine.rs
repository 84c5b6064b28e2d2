//! Sums over x and u that the worst case of the loop that runs bounds.

use super::form::Linear;
use super::running::number_of;
use crate::check::sampled::{Span, Sum};
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};

/// More than the rounding of a dozen products and sums in doubles.
const ROUNDED: f64 = 1e-14;

/// A sum over x_1..x_n and u, plus a constant.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Affine {
    states: Vec<f64>,
    input: f64,
    rest: f64,
}

impl Affine {
    /// The affine sum of an expression; `None` if it is not one, or depends on time.
    pub(super) fn of(h: &Expression, n: usize) -> Option<Self> {
        let linear = Linear::of(&normal(h)).or_else(|| Linear::of(h))?;
        let rest = number_of(&linear.rest)?;
        let mut affine = Self { states: vec![0.0; n], input: 0.0, rest };
        for (variable, slope) in &linear.slopes {
            let slope = number_of(slope)?;
            match variable {
                Variable::State(j) => *affine.states.get_mut(j - 1)? = slope,
                Variable::Control => affine.input = slope,
                _ => return None,
            }
        }
        let is_finite = affine.parts().chain([rest]).all(f64::is_finite);
        is_finite.then_some(affine)
    }

    /// u.
    pub(super) fn control() -> Self {
        Self { states: Vec::new(), input: 1.0, rest: 0.0 }
    }

    fn parts(&self) -> impl Iterator<Item = f64> {
        self.states.iter().copied().chain([self.input])
    }

    /// Returns true if at most one of x and u counts.
    pub(super) fn is_of_one(&self) -> bool {
        self.parts().filter(|part| *part != 0.0).count() <= 1
    }

    /// Returns true if a state counts.
    pub(super) fn has_states(&self) -> bool {
        self.states.iter().any(|part| *part != 0.0)
    }

    /// The sum without the constant.
    pub(super) fn sum(&self) -> Sum {
        Sum { states: self.states.clone(), input: self.input }
    }

    /// Returns the interval of the function where its sum is within a span.
    pub(super) fn moved(&self, sum: Span) -> Span {
        if self.rest == 0.0 {
            return sum;
        }
        let moved = Span { low: sum.low + self.rest, high: sum.high + self.rest };
        moved.wider(ROUNDED * (sum.size() + self.rest.abs()))
    }

    /// Returns the interval of the function where x and u are within spans, each by itself.
    pub(super) fn over(&self, states: &[Span], input: Span) -> Span {
        let nowhere = Span { low: f64::NEG_INFINITY, high: f64::INFINITY };
        let states = (0..self.states.len()).map(|i| states.get(i).copied().unwrap_or(nowhere));
        let parts = self.parts().zip(states.chain([input])).filter(|(part, _)| *part != 0.0);
        let mut sum = Span::default();
        let mut sizes = 0.0;
        for (part, span) in parts {
            let [a, b] = [part * span.low, part * span.high];
            sum = Span { low: sum.low + a.min(b), high: sum.high + a.max(b) };
            sizes += part.abs() * span.size();
        }
        // One part of weight 1 is not rounded.
        let is_exact = self.is_of_one() && self.parts().all(|part| part == 0.0 || part == 1.0);
        self.moved(if is_exact { sum } else { sum.wider(ROUNDED * sizes) })
    }
}
