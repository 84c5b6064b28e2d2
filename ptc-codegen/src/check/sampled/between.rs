//! Bounds of the states between two samples, where they are linear in the loop too.

use super::chain::{Near, centre};
use super::relative::upper;
use super::span::Span;
use super::trust::Trust;
use super::worst::{Output, Sampled};
use crate::algebra::BigRational;
use crate::expression::enclosure::{Interval, Range};
use crate::linear;

/// A plant between two samples, over x and an input of gain 1.
#[derive(Clone, Debug)]
pub(super) struct Between {
    parts: Vec<Part>,
    /// Largest distance of x from its control points, over the sizes of x and u at the start of a part.
    rest: Vec<Vec<f64>>,
    /// True if u counts at all: in a chain it does at the ends alone.
    counts_input: bool,
}

#[derive(Clone, Debug)]
struct Part {
    start: Vec<Vec<Near>>,
    inner: Vec<Vec<Vec<Near>>>,
}

impl Between {
    pub(super) fn new(plant: &linear::Between) -> Self {
        let near = |value: &BigRational| centre(Range::from(&Interval::exact(value)), 0.0);
        let n = plant.rest.len();
        let row = |row: &Vec<BigRational>| row.iter().map(near).collect();
        let part = |part: &linear::Part| Part {
            start: (0..n).map(|i| (0..=n).map(|j| near(part.start.at(i, j))).collect()).collect(),
            inner: part.inner.iter().map(|points| points.iter().map(row).collect()).collect(),
        };
        let rest: Vec<Vec<_>> =
            (0..n).map(|i| (0..=n).map(|j| upper(plant.rest.at(i, j))).collect()).collect();
        let parts: Vec<_> = plant.parts.iter().map(part).collect();
        let inner = parts.iter().flat_map(|part| part.inner.iter().flatten());
        let counts_input = parts.len() > 1
            || rest.iter().any(|row| row[n] > 0.0)
            || inner.into_iter().any(|row| row[n] != (0.0, 0.0));
        Self { parts, rest, counts_input }
    }

    /// Number of outputs that are bounded for each sample.
    pub(super) fn outputs(&self) -> usize {
        let starts = (self.parts.len() - 1) * self.rest.len();
        let inner = |part: &Part| part.inner.iter().map(Vec::len).sum::<usize>();
        usize::from(self.counts_input) + starts + self.parts.iter().map(inner).sum::<usize>()
    }
}

impl Sampled {
    /// Bounds each x_i from sample `k` to the next one, where `ends` are the bounds at both. In a part of the sample
    /// x_i is a convex combination of its values at both ends and the inner control points, up to the rest: what the
    /// polynomial is off at the end is taken out of it, and leaves no more of it.
    pub(super) fn until_next(
        &self,
        between: &Between,
        k: usize,
        ends: [&[Span]; 2],
        trust: Option<Trust<'_>>,
    ) -> Vec<Span> {
        let n = self.chain.n;
        let acting = || self.bound(&self.acts(), k, trust).total() + self.actuator;
        let input = if between.counts_input { self.greatest_gain() * acting() } else { 0.0 };
        let start = ends[0][..n].iter().copied();
        let bounds: Vec<_> = start.chain([Span::of_size(input)]).collect();
        let seen = |row: &Vec<Near>| {
            let all = row.iter().zip(&bounds);
            let inexact = all.map(|((_, error), z)| error * z.size()).sum::<f64>();
            // The gain is rounded, and may be another one.
            let off = self.chain.gain.abs() * self.of_gain(trust, k) + ROUNDED * input;
            let span = self.bound(&self.over(row), k, trust).span();
            span.wider(inexact + row[n].0.abs() * off)
        };
        let mut most = ends[1][..n].to_vec();
        for (at, part) in between.parts.iter().enumerate() {
            let here: Vec<Span> = match at {
                0 => bounds.clone(),
                _ => part.start.iter().map(seen).chain([Span::of_size(input)]).collect(),
            };
            for (i, most) in most.iter_mut().enumerate() {
                let inner = part.inner[i].iter().map(seen).fold(here[i], Span::hull);
                let rest: f64 = between.rest[i].iter().zip(&here).map(|(r, z)| r * z.size()).sum();
                *most = most.hull(inner.wider(rest));
            }
        }
        let beside = |i: usize| self.moved.as_ref().map_or(0.0, |moved| moved.between[i]);
        let own = |(i, most): (usize, &Span)| most.wider(self.of_switches(i, k, trust) + beside(i));
        most.iter().enumerate().map(own).collect()
    }

    /// A sum over x and the input that acts.
    fn over(&self, row: &[Near]) -> Output {
        let n = self.chain.n;
        let mut output = Output { row: vec![0.0; self.size()], direct: 0.0, change: false };
        output.row.iter_mut().zip(&row[..n]).for_each(|(sum, (weight, _))| *sum = *weight);
        let weight = row[n].0 * self.chain.gain;
        match self.acting() {
            None => output.direct = weight,
            Some(kept) => output.row[kept] += weight,
        }
        output
    }
}

/// More than the rounding of a gain and of a product with it.
const ROUNDED: f64 = 1e-15;
