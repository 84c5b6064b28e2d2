//! Integrals over a piece of lags, over which the kernel of an f is a polynomial with a small rest.

use super::flow::dot;
use super::impulse::{Impulse, TERMS};
use super::series::integer;
use crate::expression::enclosure::Range;

/// Parts of a piece in which a kernel has no sign.
const PARTS: u32 = 8;

/// A piece of lags around a node of the flow: s = node + y for y between two ends.
pub(super) struct Piece<'a> {
    pub(super) impulse: &'a Impulse,
    pub(super) ends: [Range; 2],
    /// The greatest |y|, and the length.
    pub(super) away: Range,
    pub(super) length: Range,
    /// The weight as a polynomial in y, and its rest.
    pub(super) weight: Vec<Range>,
    pub(super) rest: Range,
    /// Remainders of the Taylor series of phi_1..
    pub(super) left: Vec<Range>,
}

impl Piece<'_> {
    /// Integrals of the powers of y times the polynomial of the weight over the piece.
    pub(super) fn moments(&self) -> Vec<Range> {
        let count = TERMS + self.weight.len();
        let [mut low, mut high] = [Range::from(1.0); 2];
        let mut moments = Vec::with_capacity(count);
        for l in 1..=count {
            (low, high) = (low * self.ends[0], high * self.ends[1]);
            moments.push((high - low) / integer(l));
        }
        (0..=TERMS).map(|l| dot(&self.weight, &moments[l..])).collect()
    }

    /// A bound of the polynomial of the weight.
    pub(super) fn greatest(&self) -> Range {
        polynomial(&of_size(&self.weight), self.away)
    }

    /// The integrals of m times a row over phi, and of its size.
    pub(super) fn of_row(&self, row: &[Range], moments: &[Range], greatest: Range) -> [Range; 2] {
        let terms = along(row, self.impulse, TERMS);
        let left = sizes(row, &self.left);
        // The rests of both are beside the sum of the row, of which the terms may cancel.
        let far = polynomial(&of_size(&terms[1..]), self.away) * self.away;
        let most = terms[0].size() + far;
        let rest = (self.rest * (most + left) + left * greatest) * self.length;
        let signed = dot(&terms, moments) + rest.both_signs();
        if (far + left).is_below(&terms[0].size()) {
            return [signed, signed.size()];
        }
        [signed, self.in_parts(&terms, left)]
    }

    /// A bound of the integral of the size of a polynomial with a rest, times m.
    fn in_parts(&self, terms: &[Range], left: Range) -> Range {
        let [low, high] = [self.ends[0].low(), self.ends[1].high()];
        let slopes = derivative(terms);
        let bent = polynomial(&of_size(&derivative(&slopes)), self.away);
        let width = (high - low) / f64::from(PARTS);
        let part = |k: u32| {
            let ends = [0, 1].map(|end| match k + end {
                PARTS => high,
                k => low + f64::from(k) * width,
            });
            let y = Range::from(0.5 * ends[0] + 0.5 * ends[1]);
            let within = Range::new(ends[0], ends[1]);
            let half = (within - y).size();
            let (value, slope) = (polynomial(terms, y).size(), polynomial(&slopes, y).size());
            let rest = left + Range::from(0.5) * bent * half * half;
            let area =
                half * (value + value.most(&(slope * half))) + Range::from(2.0) * half * rest;
            area * (polynomial(&self.weight, within).size() + self.rest)
        };
        (0..PARTS).map(part).sum()
    }
}

/// sum_j |a_j| b_j.
pub(super) fn sizes(row: &[Range], bounds: &[Range]) -> Range {
    row.iter().zip(bounds).map(|(entry, bound)| entry.size() * *bound).sum()
}

/// Taylor coefficients of the sums of a row over phi, up to an order.
pub(super) fn along(row: &[Range], impulse: &Impulse, order: usize) -> Vec<Range> {
    (0..=order).map(|l| dot(row, impulse.terms.iter().map(|terms| &terms[l]))).collect()
}

/// A polynomial of the order 0 on.
pub(super) fn polynomial(terms: &[Range], y: Range) -> Range {
    terms.iter().rev().fold(Range::from(0.0), |sum, term| sum * y + *term)
}

/// Its derivative.
fn derivative(terms: &[Range]) -> Vec<Range> {
    terms.iter().enumerate().skip(1).map(|(l, term)| *term * integer(l)).collect()
}

fn of_size(terms: &[Range]) -> Vec<Range> {
    terms.iter().map(|term| term.size()).collect()
}
