//! The closed loop over a cell of T/tau, for a plant of tau = 1.
//!
//! x_{i+1} is the i-th derivative of x_1 = xi_1(kappa), and so is g u for i = n: with xi_{j+1} =
//! A xi_j from the first one on, all are sum_j B_{i,j}(kappa', kappa'', ...) xi_{j+1}. The derivative
//! after them bounds how far each moves within the cell.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::clock::Clock;
use super::flow::{Flow, Rows, dot};
use super::forced::Response;
use super::weight::Weight;
use crate::algebra::{BigRational, integer};
use crate::expression::enclosure::{Interval, Range};

/// Derivatives of x_1 beyond that of g u: cells are as wide as a Taylor series of as many allows.
pub(super) const BEYOND: usize = 6;

/// Enclosure of the loop over a cell: x_1..x_n and g u, each by its slope along x_1..x_n at t0.
pub(super) struct Cell {
    /// Least and greatest T/tau.
    pub(super) share: [BigRational; 2],
    /// Half its width.
    pub(super) half: Range,
    /// In the middle, and their derivatives there.
    pub(super) middle: [Rows; 2],
    /// All over the cell, with the first and the second derivative.
    pub(super) over: [Rows; 3],
    /// Contribution of f to each at the least T/tau and at the greatest, with what it may add beyond both between them;
    /// `None` where f is 0.
    pub(super) added: Option<[Vec<Range>; 2]>,
    /// About what f adds at most.
    pub(super) about: Vec<Range>,
}

/// A cell of T/tau, and the bits of factors.
type Sum = ([BigRational; 2], Vec<u64>);

/// Responses at the least T/tau of a cell and at the greatest.
type Ends = [Rc<Response>; 2];

/// The loop in units of tau.
pub(super) struct Loop {
    pub(super) n: usize,
    pub(super) flow: Flow,
    pub(super) clock: Clock,
    /// xi at t0, by its slope along x at t0.
    start: Rows,
    cells: BTreeMap<[BigRational; 2], Option<Rc<Cell>>>,
    left: usize,
    /// Bounds of f, where it is not 0.
    drift: Option<Drift>,
    /// Responses of the loop to f at the T/tau that were looked at, and in the sums by their factors.
    driven: BTreeMap<(BigRational, Vec<u64>), Rc<Response>>,
    /// Contributions of f to sums over cells.
    sums: BTreeMap<Sum, Option<[Range; 2]>>,
    pub(super) weight: Option<Rc<Weight>>,
    /// Pieces of lags that may be looked at.
    pub(super) pieces: u64,
}

/// Bounds of f.
#[derive(Clone, Copy)]
pub(super) struct Drift {
    /// Its middle.
    pub(super) middle: Range,
    /// Largest deviation of f from the middle that is constant over a run.
    pub(super) constant: Range,
    /// Largest further deviation of f, as any signal.
    pub(super) varying: Range,
}

impl Drift {
    /// Returns the contribution of f.
    fn of(self, signed: Range, size: Range) -> Range {
        self.middle * signed
            + (self.constant * signed).both_signs()
            + (self.varying * size).both_signs()
    }

    /// The greatest |f|.
    fn most(self) -> Range {
        self.middle.size() + self.constant + self.varying
    }
}

/// Pieces of lags for all cells.
const PIECES: u64 = 3_000_000;

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
        let (drift, driven, weight, pieces) = (None, BTreeMap::new(), None, PIECES);
        let (known, sums, left) = (BTreeMap::new(), BTreeMap::new(), cells);
        Some(Self {
            n,
            flow,
            clock,
            start,
            cells: known,
            left,
            drift,
            driven,
            sums,
            weight,
            pieces,
        })
    }

    /// The same with an f between two bounds, in a run to `until`.
    pub(super) fn with_drift(mut self, drift: Drift, until: &BigRational) -> Option<Self> {
        self.weight = Some(Rc::new(Weight::new(&mut self.clock, self.n, until)?));
        self.drift = Some(drift);
        Some(self)
    }

    /// Returns the enclosure over a cell, if one exists; `None` where no more cells may be looked at.
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
        let around = Range::from(&during.minus(&here));
        let of_cell = match self.flow.on(&at_middle, around) {
            Some(rows) => Some(rows),
            None => self.flow.during(&during, &self.start),
        };
        let of_cell = match of_cell {
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
        let moved = Range::from(&point.minus(&wide));
        let rows = by_series(&centre, rows, moved);
        let n = self.n;
        let half = half_of(share);
        let mut about = vec![Range::from(0.0); n + 1];
        let added = match self.drift {
            None => None,
            Some(drift) => {
                let (ends, added) = self.added(drift, share, &over_cell, None)?;
                for (i, about) in about.iter_mut().enumerate() {
                    let [last, first] =
                        ends.each_ref().map(|end| drift.of(end.signed[i], end.size[i]));
                    *about = last.hull(&first);
                }
                Some(added)
            }
        };
        let from = |rows: &Rows, first: usize| rows[first..=n + first].to_vec();
        Some(Cell {
            share: share.clone(),
            half,
            middle: [from(&centre, 0), from(&centre, 1)],
            over: [from(&rows, 0), from(&rows, 1), from(&rows, 2)],
            added,
            about,
        })
    }

    /// Returns the contribution of f to the sum of x_1..x_n and g u with these factors over a cell, as in
    /// [`Cell::added`]: less than the sum of its contributions to each, as no one signal is worst for all.
    pub(super) fn of_sum(
        &mut self,
        share: &[BigRational; 2],
        factors: &[Range],
    ) -> Option<[Range; 2]> {
        let drift = self.drift?;
        let key = (share.clone(), bits(factors));
        if let Some(known) = self.sums.get(&key) {
            return *known;
        }
        // Half of what may be looked at is left to bounds that have to do without.
        (self.pieces > PIECES / 2).then_some(())?;
        let sum = self.added_to(drift, share, factors);
        self.sums.insert(key, sum);
        sum
    }

    fn added_to(
        &mut self,
        drift: Drift,
        share: &[BigRational; 2],
        factors: &[Range],
    ) -> Option<[Range; 2]> {
        let [low, high] = share;
        let during = self.clock.stretched(high)?.hull(&self.clock.stretched(low)?);
        let table = self.table(&Interval::between(low, Some(high)), &during)?;
        let (_, [last, first]) = self.added(drift, share, &table, Some(factors))?;
        Some([last[0], first[0]])
    }

    /// Returns the responses of the loop to f at the least and at the greatest T/tau of a cell, and the contributions
    /// of f at both. These include the part that f may add between them.
    fn added(
        &mut self,
        drift: Drift,
        share: &[BigRational; 2],
        table: &Rows,
        sum: Option<&[Range]>,
    ) -> Option<(Ends, [Vec<Range>; 2])> {
        let [low, high] = share;
        let half = half_of(share);
        let ends = [self.answer(low, sum)?, self.answer(high, sum)?];
        let rest = self.beyond(share, half, table, &ends[0], sum)?;
        let with = |end: &Rc<Response>| {
            let row = |(i, rest): (usize, &Range)| {
                drift.of(end.signed[i], end.size[i]) + (drift.most() * *rest).both_signs()
            };
            rest.iter().enumerate().map(row).collect()
        };
        let added = ends.each_ref().map(with);
        Some((ends, added))
    }

    /// Returns the response of x_1..x_n and g u, or of a sum of them, to f at one T/tau.
    fn answer(&mut self, share: &BigRational, sum: Option<&[Range]>) -> Option<Rc<Response>> {
        let key = (share.clone(), sum.map(bits).unwrap_or_default());
        if let Some(known) = self.driven.get(&key) {
            return Some(known.clone());
        }
        let here = self.clock.stretched(share)?;
        let answer = Rc::new(self.response(&Interval::exact(share), &here, None, sum)?);
        self.driven.insert(key, answer.clone());
        Some(answer)
    }

    /// B_{i,j} w^i, for x_1 and its derivatives.
    fn table(&mut self, share: &Interval, stretched: &Interval) -> Option<Rows> {
        self.clock.bell(share, stretched)
    }
}

/// Half the width of a cell.
pub(super) fn half_of([low, high]: &[BigRational; 2]) -> Range {
    match low == high {
        true => Range::from(0.0),
        false => Range::from(&Interval::exact(&((high - low) / integer(2)))),
    }
}

/// Factors that are doubles, for a key.
fn bits(factors: &[Range]) -> Vec<u64> {
    factors.iter().map(|factor| factor.low().to_bits()).collect()
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
            rows[i][c] = rows[i][c].common(&sum);
        }
    }
    rows
}
