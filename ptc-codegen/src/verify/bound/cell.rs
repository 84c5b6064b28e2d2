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
use crate::algebra::{BigRational, integer};
use crate::expression::interval::Interval;
use crate::expression::range::Range;

/// Derivatives of x_1 beyond that of g u: cells are as wide as a Taylor series of as many allows.
pub(super) const BEYOND: usize = 6;

/// What is known of the loop over a cell: x_1..x_n and g u, each by its slope along x_1..x_n at t0.
pub(super) struct Cell {
    /// Least and greatest T/tau.
    pub(super) share: [BigRational; 2],
    /// Half its width.
    pub(super) half: Range,
    /// In the middle, and their derivatives there.
    pub(super) middle: [Rows; 2],
    /// All over the cell, with the first and the second derivative.
    pub(super) over: [Rows; 3],
    /// What f adds to each at the least T/tau and at the greatest, with what it may add beyond both
    /// between them; none where f is 0.
    pub(super) added: Option<[Vec<Range>; 2]>,
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
    /// What f adds at the T/tau that were asked for.
    driven: BTreeMap<BigRational, Rc<Vec<Range>>>,
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
        let (drift, driven, sources) = (None, BTreeMap::new(), Vec::new());
        let (known, left) = (BTreeMap::new(), cells);
        Some(Self { n, flow, clock, start, cells: known, left, drift, driven, sources })
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
        let rows = self.flow.derivatives(&wide, &over_cell, of_cell);
        let moved = Range::from(&point.plus(&wide.neg()));
        let rows = by_series(&centre, rows, moved);
        let n = self.n;
        let half = match low == high {
            true => Range::from(0.0),
            false => Range::from(&Interval::exact(&((high - low) / integer(2)))),
        };
        let added = match self.drift {
            None => None,
            Some(drift) => {
                let rest = self.beyond(drift, (share, half), (&here, around), over_cell)?;
                let with = |ends: &[Range]| {
                    ends.iter().zip(&rest).map(|(end, rest)| *end + *rest).collect()
                };
                let [last, first] = [self.added_at(low)?, self.added_at(high)?];
                Some([with(&last), with(&first)])
            }
        };
        let from = |rows: &Rows, first: usize| rows[first..=n + first].to_vec();
        Some(Cell {
            share: share.clone(),
            half,
            middle: [from(&centre, 0), from(&centre, 1)],
            over: [from(&rows, 0), from(&rows, 1), from(&rows, 2)],
            added,
        })
    }

    /// What f adds to x_1..x_n and g u at one T/tau.
    fn added_at(&mut self, share: &BigRational) -> Option<Rc<Vec<Range>>> {
        if let Some(known) = self.driven.get(share) {
            return Some(known.clone());
        }
        let [drift, most] = self.drift?;
        let here = self.clock.stretched(share)?;
        let mut table = self.table(&Interval::exact(share), &here)?;
        table.truncate(self.n + 1);
        let Response { signed, size } = self.response(share, &here, &table)?;
        let one = |(signed, size): (Range, Range)| drift * signed + (most * size).both_signs();
        let added = Rc::new(signed.into_iter().zip(size).map(one).collect::<Vec<_>>());
        self.driven.insert(share.clone(), added.clone());
        Some(added)
    }

    /// What f may add within a cell beyond what it adds at its ends. With the kernel G of x_i, for s
    /// before the cell G(t, s) is within h^2/2 |G''| of what is linear between the ends, of which the
    /// integral of the size is greatest at one of them. What acts within the cell adds at most |G|
    /// there over 2 h, once to what is left and once to what an end has of it.
    fn beyond(
        &mut self,
        [drift, most]: [Range; 2],
        (share, half): (&[BigRational; 2], Range),
        around: (&Interval, Range),
        table: Rows,
    ) -> Option<Vec<Range>> {
        if half == Range::from(0.0) {
            return Some(vec![half; self.n + 1]);
        }
        let (bent, within) = self.response_over(share, around, table)?;
        let all = drift.size() + most.size();
        let one = |(bent, within): (&Range, &Range)| {
            let bent = Range::from(0.5) * half * half * *bent;
            (all * (bent + Range::from(4.0) * half * *within)).both_signs()
        };
        Some(bent.iter().zip(&within).map(one).collect())
    }

    /// B_{i,j} w^i, for x_1 and its derivatives.
    fn table(&mut self, share: &Interval, stretched: &Interval) -> Option<Rows> {
        self.clock.bell(share, stretched)
    }
}

/// x_1 and its derivatives all over a cell, by the Taylor series of each around the middle, the last
/// derivative of which is that of the cell.
fn by_series(centre: &Rows, mut rows: Rows, moved: Range) -> Rows {
    let end = rows.len() - 1;
    for i in 0..end {
        for c in 0..rows[i].len() {
            let mut sum = rows[end][c];
            let mut order = f64::from(u32::try_from(end - i).unwrap_or(u32::MAX));
            for row in centre[i..end].iter().rev() {
                sum = row[c] + moved / Range::from(order) * sum;
                order -= 1.0;
            }
            rows[i][c] = rows[i][c].common(sum);
        }
    }
    rows
}
