//! The closed loop over a cell of T/tau, for a plant of tau = 1.
//!
//! x_{i+1} is the i-th derivative of x_1 = xi_1(kappa), and so is g u for i = n: with xi_{j+1} =
//! A xi_j from the first one on, all are sum_j B_{i,j}(kappa', kappa'', ...) xi_{j+1}. The derivative
//! after them bounds how far each moves within the cell.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::clock::Clock;
use super::flow::{Flow, Rows, dot};
use super::forced::{Response, Source};
use super::range::Range;
use crate::algebra::{BigRational, integer};
use crate::expression::interval::Interval;

/// What is known of the loop over a cell.
pub(super) struct Cell {
    /// Least and greatest T/tau.
    pub(super) share: [BigRational; 2],
    /// x_1..x_n and g u over the cell, each by its slope along x_1..x_n at t0, and what f adds.
    pub(super) rows: Rows,
}

/// The loop in units of tau.
pub(super) struct Loop {
    pub(super) n: usize,
    pub(super) flow: Flow,
    pub(super) clock: Clock,
    /// xi at t0, by its slope along x at t0.
    start: Rows,
    cells: BTreeMap<[BigRational; 2], Option<Rc<Cell>>>,
    left: usize,
    /// The middle of f and its distance from there, where it is not 0.
    drift: Option<[Range; 2]>,
    pub(super) sources: Vec<Source>,
}

impl Loop {
    /// The loop of a flow and a mapping, of which at most so many cells may be looked at.
    pub(super) fn new(flow: Flow, mut clock: Clock, n: usize, cells: usize) -> Option<Self> {
        let table = clock.bell(&Interval::integer(1), &Interval::integer(0))?;
        let mut start = Rows::new();
        for i in 0..n {
            let entry = |c: usize| {
                let unit = Range::from(f64::from(u8::from(i == c)));
                let known = dot(&table[i][..i], start.iter().map(|row: &Vec<_>| &row[c]));
                (unit - known) / table[i][i]
            };
            let row = (0..n).map(entry).collect();
            start.push(row);
        }
        let (cells, left, sources) = (BTreeMap::new(), cells, Vec::new());
        Some(Self { n, flow, clock, start, cells, left, drift: None, sources })
    }

    /// The same with an f between two bounds, in a run to `until`.
    pub(super) fn with_drift(mut self, drift: [Range; 2], until: &BigRational) -> Option<Self> {
        self.sources = self.sources(until)?;
        self.drift = Some(drift);
        Some(self)
    }

    /// What is known over a cell, if anything; none where no more cells may be looked at.
    #[allow(clippy::option_option)]
    pub(super) fn cell(&mut self, share: &[BigRational; 2]) -> Option<Option<Rc<Cell>>> {
        if let Some(known) = self.cells.get(share) {
            return Some(known.clone());
        }
        self.left = self.left.checked_sub(1)?;
        let cell = self.enclosed(share).map(Rc::new);
        self.cells.insert(share.clone(), cell.clone());
        Some(cell)
    }

    fn enclosed(&mut self, share: &[BigRational; 2]) -> Option<Cell> {
        let [low, high] = share;
        let middle = (low + high) / integer(2);
        let wide = Interval::between(low, Some(high));
        let [first, last] = [self.clock.stretched(high)?, self.clock.stretched(low)?];
        let here = self.clock.stretched(&middle)?;
        let during = first.hull(&last);
        let at_middle = self.flow.at(&here, &self.start)?;
        let around = Range::from(&during.plus(&here.neg()));
        let of_cell = match self.flow.on(&at_middle, around) {
            Some(rows) => rows,
            None => {
                let at_start = self.flow.at(&first, &self.start)?;
                self.flow.ever(&at_start)?
            }
        };
        let point = Interval::exact(&middle);
        let at_point = self.table(&point, &here)?;
        let over_cell = self.table(&wide, &during)?;
        let centre = self.flow.derivatives(&point, &at_point, at_middle);
        let mut rows = self.flow.derivatives(&wide, &over_cell, of_cell);
        let moved = Range::from(&point.plus(&wide.neg()));
        for i in (0..rows.len() - 1).rev() {
            for c in 0..rows[i].len() {
                let by_slope = centre[i][c] + moved * rows[i + 1][c];
                rows[i][c] = rows[i][c].common(by_slope);
            }
        }
        let added = match self.drift {
            None => vec![Range::from(0.0); rows.len()],
            Some([drift, most]) => {
                let Response { mut signed, mut size } = self.response(&middle, &here, &at_point)?;
                let (last, at_once) = self.response_over(share, (&here, around), &over_cell)?;
                let end = rows.len() - 1;
                (signed[end], size[end]) = (last.both_signs(), last);
                for i in (0..end).rev() {
                    signed[i] = signed[i] + moved * (at_once[i] + signed[i + 1]);
                    size[i] = size[i] + moved.size() * (at_once[i].size() + size[i + 1]);
                }
                let one =
                    |(signed, size): (Range, Range)| drift * signed + (most * size).both_signs();
                signed.into_iter().zip(size).map(one).collect()
            }
        };
        rows.iter_mut().zip(added).for_each(|(row, added)| row.push(added));
        rows.pop();
        Some(Cell { share: share.clone(), rows })
    }

    /// B_{i,j} w^i, for x_1 and its first n + 1 derivatives.
    fn table(&mut self, share: &Interval, stretched: &Interval) -> Option<Rows> {
        let mut table = self.clock.bell(share, stretched)?;
        table.truncate(self.n + 2);
        Some(table)
    }
}
