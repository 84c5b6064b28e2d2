//! Bounds of a loop whose gains are in a table: rows of a few samples on the way, in a table beside them.
//!
//! With M samples to go a signal has the rows r_j of all samples j to rest, x being the state and r_j x the signal. A few
//! of them bound the others: a row that is a combination of kept ones is bounded by the sum of the sizes of its factors.
//! The samples that are kept are chosen for each factor of 2 in M ([`knots`]), and their rows are interpolated in M. Every M
//! is then examined: all r_j are within the hull of the rows that are interpolated, which are scaled so that this is so,
//! and these are within the hull of all r_j times `growth`.
//!
//! All of it is done in doubles. A row that is wrong by a rounding is a row plus a small one, which the kept rows bound
//! as they bound any other: `slack` counts these.

mod closed;
mod hull;
mod knots;
mod known;
mod witness;

use num_traits::ToPrimitive;

use super::span::{Row, Span};
use super::{Bound, ROUNDED, Signal};
use crate::algebra::BigRational;
use crate::linear::{Matrix, Piece, Schedule};
use crate::parameter::Precision;
use closed::Closed;
use hull::{Basis, Hull};
use knots::{Knots, Way};
use witness::Witness;

/// Nodes for each factor of 2 in the samples to go.
pub(crate) const PER: u32 = 8;

/// Factor of the bounds at which no more rows are kept.
const ENOUGH: f64 = 1.03;

/// Rows beyond the order that are kept at most.
const MORE: usize = 9;

/// Cells of a piece for which its rows are chosen.
const LOOKED: usize = 4;

/// Roundings of each term of a bound: of the state, its row, the interpolation, the sum, the limit.
const EACH: f64 = 8.0;

/// A loop with a table of gains, and its signals that have limits.
pub(crate) struct Plan<'a> {
    /// Phi.
    pub(crate) phi: &'a Matrix,
    /// Gamma.
    pub(crate) gamma: &'a [BigRational],
    /// The gains.
    pub(crate) schedule: &'a Schedule,
    /// Samples to go at which the gains are held.
    pub(crate) held: u32,
    /// The signals.
    pub(crate) signals: Vec<Signal>,
    /// The precision of the table.
    pub(crate) precision: Precision,
}

/// The rows of one signal.
#[derive(Clone, Debug)]
pub(crate) struct Rows {
    /// The signal.
    pub(crate) signal: Signal,
    /// The number of rows for each node.
    pub(crate) count: usize,
    /// The first row of every node, then the second of every node, and so on: what |row x| may be is the limit.
    pub(crate) table: Vec<Row>,
}

/// The bounds of a table.
#[derive(Clone, Debug)]
pub(crate) struct Tabled {
    /// The parts of the table; each has its own last node, which is where the next one begins.
    pub(crate) pieces: Vec<Piece>,
    /// The number of nodes.
    pub(crate) nodes: usize,
    /// The rows of each signal.
    pub(crate) signals: Vec<Rows>,
    /// Samples to go at and below which the gains are held.
    pub(crate) rest: u32,
    /// Most samples to go.
    pub(crate) longest: u32,
    /// Factor by which a bound may grow on the way, at least 1.
    pub(crate) growth: f64,
    /// The signals once the gains are held.
    pub(super) held: Vec<Bound>,
    /// The part of a limit that roundings may take, in units of the last place.
    pub(super) slack: f64,
}

/// Results of the examination of every M.
struct Examined {
    /// The factors with which the rows bound the signal, and the signal bounds the rows, the largest of each piece.
    pieces: Vec<[f64; 2]>,
    /// The size of the terms of a row.
    terms: f64,
}

impl Tabled {
    /// The bounds of a plan; `None` where the held gains are not stable, or are all that there is.
    pub(super) fn new(plan: &Plan<'_>) -> Option<Self> {
        let pair = (plan.phi, plan.gamma);
        let closed = Closed::new(pair, plan.schedule, plan.held, plan.precision)?;
        let (rest, longest) = (closed.rest, plan.schedule.samples);
        if longest <= rest + 1 {
            return None;
        }
        let (pieces, nodes) = pieces(rest + 1, longest);
        let mut all = Self {
            nodes,
            pieces,
            signals: Vec::new(),
            rest,
            longest,
            growth: 1.0,
            held: Vec::new(),
            slack: 0.0,
        };
        let mut terms = 0.0_f64;
        for signal in &plan.signals {
            let held = all.hold(&closed, *signal)?;
            let mut rows = all.rows(&closed, *signal, &held);
            let found = all.examined(&closed, &held, &rows);
            all.enlarge(&mut rows, &found);
            terms = terms.max(found.terms);
            let scaled = |row: &mut Row| {
                row.iter_mut().zip(&closed.units).for_each(|(own, unit)| *own *= unit);
            };
            rows.table.iter_mut().for_each(scaled);
            all.signals.push(rows);
        }
        let order = closed.order().to_f64()?;
        // Roundings of the rows as they are carried from sample to sample, in doubles.
        let carried = 2.0 * f64::from(longest) * f64::EPSILON / plan.precision.epsilon();
        all.slack = terms * order * (EACH + carried);
        (all.growth * terms).is_finite().then_some(all)
    }

    /// Adds the bounds of a signal once the gains are held, and returns them as rows that the limit bounds.
    fn hold(&mut self, closed: &Closed, signal: Signal) -> Option<Vec<Row>> {
        let step = closed.step(self.rest);
        let span = Span::new(&closed.signal(signal, self.rest), &step, f64::from(self.rest))?;
        let share = if span.share < 1.0 + ROUNDED { 1.0 } else { span.share };
        let mut rows = Vec::new();
        for row in span.rows {
            let in_units = row.iter().zip(&closed.units).map(|(own, unit)| own * unit);
            let exact = in_units.map(BigRational::from_float).collect::<Option<Vec<_>>>()?;
            let share_of_limit = BigRational::from_float(share.recip())?;
            self.held.push(Bound {
                signal,
                row: exact,
                share: share_of_limit,
                is_signed: span.is_signed,
            });
            rows.push(row.iter().map(|own| own * share).collect());
        }
        Some(rows)
    }

    /// The rows of a signal at every node.
    fn rows(&self, closed: &Closed, signal: Signal, held: &[Row]) -> Rows {
        let most = closed.order() + MORE;
        let future = |left: u32| closed.future(signal, held, left);
        let mut of_pieces: Vec<Knots> = Vec::with_capacity(self.pieces.len());
        let ways = |index: usize| -> Vec<Way> {
            let spacing = self.pieces[index].spacing;
            let way = |left: u32| match spacing {
                1 => Way { own: future(left), beside: None },
                _ => {
                    let beside = Some([left, left + spacing].map(future));
                    Way { own: future((left + spacing / 2).max(self.rest + 1)), beside }
                }
            };
            self.looked(index).into_iter().map(way).collect()
        };
        for index in 0..self.pieces.len() {
            let mut knots = Knots::default();
            knots.choose(&ways(index), most, ENOUGH);
            of_pieces.push(knots);
        }
        // The same number everywhere, so that a row has one place.
        let count = of_pieces.iter().map(Knots::count).max().unwrap_or(0);
        let mut nodes: Vec<Vec<Row>> = Vec::with_capacity(self.nodes);
        for (index, knots) in of_pieces.iter_mut().enumerate() {
            if knots.count() < count {
                knots.choose(&ways(index), count, 1.0);
            }
            for left in self.nodes_of(index) {
                let mut own = knots.rows(&future(left));
                own.resize(count, vec![0.0; closed.order()]);
                nodes.push(own);
            }
        }
        nodes.extend(nodes.last().cloned());
        let table = (0..count).flat_map(|k| nodes.iter().map(move |own| own[k].clone())).collect();
        Rows { signal, count, table }
    }

    /// The nodes of a piece for which its rows are chosen, or behind which: evenly, and all where they are few.
    fn looked(&self, index: usize) -> Vec<u32> {
        let nodes: Vec<_> = self.nodes_of(index).collect();
        let last = nodes.len() - 1;
        match self.pieces[index].spacing {
            1 => nodes,
            _ => nodes[..last].iter().copied().step_by(last.div_ceil(LOOKED)).collect(),
        }
    }

    /// The samples to go behind which a piece ends.
    fn end(&self, index: usize) -> u32 {
        self.pieces.get(index + 1).map_or(self.longest, |next| next.from)
    }

    /// The samples to go of the nodes of a piece.
    fn nodes_of(&self, index: usize) -> impl Iterator<Item = u32> {
        let piece = self.pieces[index];
        (piece.from..=self.end(index)).step_by(piece.spacing as usize)
    }

    /// The node before so many samples to go, and the part of the way to the next one.
    fn place(&self, left: u32) -> (usize, f64) {
        let piece = self.pieces.iter().rev().find(|piece| piece.from <= left);
        let Some(Piece { from, spacing, row }) = piece.copied() else { return (0, 0.0) };
        let (cells, rest) = ((left - from) / spacing, (left - from) % spacing);
        ((row + cells) as usize, f64::from(rest) / f64::from(spacing))
    }

    /// The rows of a signal with so many samples to go.
    fn at<'a>(&self, rows: &'a Rows, left: u32) -> impl Iterator<Item = Row> + use<'a> {
        let (node, part) = self.place(left);
        let nodes = self.nodes;
        (0..rows.count).map(move |k| {
            let [a, b] = [&rows.table[k * nodes + node], &rows.table[k * nodes + node + 1]];
            a.iter().zip(b).map(|(a, b)| a + part * (b - a)).collect()
        })
    }

    /// The values that the limits of their signals have to admit for a new plan.
    pub(super) fn values(&self, x: &[f64], left: u32) -> Vec<(Signal, f64)> {
        let value = |row: Row| row.iter().zip(x).map(|(row, x)| row * x).sum::<f64>() * self.growth;
        let of_signal = |rows| self.at(rows, left).map(move |row| (rows.signal, value(row)));
        self.signals.iter().flat_map(of_signal).collect()
    }

    /// Scales the rows of each piece so that they bound the signal.
    fn enlarge(&mut self, rows: &mut Rows, found: &Examined) {
        for (index, [factor, growth]) in found.pieces.iter().enumerate() {
            let first = self.pieces[index].row as usize;
            let last = self.pieces.get(index + 1).map_or(self.nodes, |next| next.row as usize);
            let nodes = (0..rows.count).flat_map(|k| (first..last).map(move |node| (k, node)));
            for (k, node) in nodes {
                rows.table[k * self.nodes + node].iter_mut().for_each(|own| *own *= factor);
            }
            self.growth = self.growth.max(factor * growth);
        }
    }

    /// Holds the rows against the signal, for every M.
    fn examined(&self, closed: &Closed, held: &[Row], rows: &Rows) -> Examined {
        let n = closed.order();
        let unit = |i: usize| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect::<Row>();
        let units: Vec<Row> = (0..n).map(unit).collect();
        let mut witness = Witness::new(held);
        let mut found = Examined { pieces: vec![[1.0; 2]; self.pieces.len()], terms: 0.0 };
        let mut known: Option<Basis> = None;
        for left in self.rest + 1..=self.longest {
            let step = closed.step(left);
            witness.advance(&step, closed.signal(rows.signal, left));
            let own: Vec<Row> = self.at(rows, left).collect();
            let hull = Hull::new(n, own.iter());
            let mut basis = known.map_or_else(|| hull.basis(), |basis| hull.renewed(&basis));
            let mut most = |row: &Row| hull.bound(row, &mut basis).sum;
            let factor = witness.outer().map(|row| most(&row)).fold(0.0, f64::max);
            let sizes: Vec<f64> = units.iter().map(most).collect();
            let terms = |row: &Row| row.iter().zip(&sizes).map(|(a, b)| a.abs() * b).sum::<f64>();
            let carried = |row: &Row| -> Row {
                let size = |j: usize| row.iter().zip(&step).map(|(a, b)| (a * b[j]).abs()).sum();
                (0..n).map(size).collect()
            };
            let of_rows = own.iter().map(terms);
            let of_witness = witness.outer().map(|row| terms(&carried(&row)));
            found.terms = of_rows.chain(of_witness).fold(found.terms, f64::max);
            known = Some(basis);
            let inner = Hull::new(n, witness.inner());
            let mut basis = inner.basis();
            let growth = own.iter().map(|row| inner.bound(row, &mut basis).sum);
            let growth = growth.fold(1.0, f64::max);
            let piece = self.pieces.iter().rposition(|piece| piece.from <= left).unwrap_or(0);
            let [most, grown] = &mut found.pieces[piece];
            (*most, *grown) = (most.max(factor), grown.max(growth));
        }
        found
    }
}

/// Pieces from one number of samples to go to another one, and the number of their nodes.
fn pieces(first: u32, longest: u32) -> (Vec<Piece>, usize) {
    let (mut pieces, mut row) = (Vec::new(), 0);
    let mut from = first;
    while from < longest || pieces.is_empty() {
        let spacing = spacing(from);
        from -= if pieces.is_empty() { from % spacing } else { 0 };
        let behind = (from + 1).next_power_of_two().max(2 * PER);
        let end = behind.min(longest);
        pieces.push(Piece { from, spacing, row });
        row += (end - from) / spacing + 1;
        from = end;
    }
    // The last one stands twice, as there is one behind every place.
    (pieces, row as usize + 1)
}

/// The distance of the nodes around so many samples to go.
fn spacing(left: u32) -> u32 {
    (1 << left.max(1).ilog2()) / PER.min(1 << left.max(1).ilog2())
}

/// The samples to go of the first node that is not before these.
pub(crate) fn node_from(left: u32) -> u32 {
    left.next_multiple_of(spacing(left))
}

#[cfg(test)]
mod tests;
