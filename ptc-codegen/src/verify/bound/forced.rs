//! Response of x and u to a bounded f.
//!
//! An f of 1 for a moment ds of stretched time moves xi_n by m ds with the weight m = mu'^n. What comes
//! of it after the lag s is e^(A s) e_n =: phi(s) times that, mapped back: in row r of x_1..x_n and g u
//! the kernel H_r(w, s) = m(t - s) sum_j B_rj phi_{j+1}(s) at T/tau = w, t = kappa. Of all |f| <= D the
//! one that turns with H_r is the worst, with D times the integral of |H_r| over 0 <= s <= t.
//!
//! The integral is summed over pieces of s, over each of which phi and m are polynomials with a small rest. Far
//! back, where all that is left is little beside what is summed, it is bounded by the size of phi.
//! Between two w the kernel changes slowly at the same lag, however many time constants lie between
//! them, which is why bounds over a cell are formed there.

use super::cell::Loop;
use super::flow::{Rows, dot};
use super::impulse::TERMS;
use super::piece::{Piece, sizes};
use super::weight::Leaf;
use crate::expression::enclosure::{Interval, Range};

/// Largest part of the sum that is left far back.
pub(super) const LITTLE: f64 = 1.0 / 4096.0;

/// Pieces after which it is asked whether what is left is little.
pub(super) const ASKED: u64 = 4;

/// Integrals of the kernels of x_1..x_n and g u, or of a sum of them, for an f of 1, and of their sizes.
#[derive(Clone, Debug)]
pub(super) struct Response {
    pub(super) signed: Vec<Range>,
    pub(super) size: Vec<Range>,
}

/// Times that are far back, and bounds of phi_1.. at their lags.
pub(super) struct Block {
    pub(super) ends: [f64; 2],
    pub(super) bounds: Vec<Range>,
}

/// B_{r,j} of `table`, which has it times w^r.
pub(super) fn mapped(table: &Rows, n: usize, share: &Interval) -> Rows {
    let inverse = Range::from(1.0) / Range::from(share);
    let full = |(r, row): (usize, &Vec<Range>)| {
        let power = inverse.whole_power(i32::try_from(r).unwrap_or(i32::MAX));
        let entry = |j: usize| row.get(j).map_or(Range::from(0.0), |entry| *entry * power);
        (0..=n).map(entry).collect()
    };
    table.iter().take(n + 1).enumerate().map(full).collect()
}

/// One row for each of x_1..x_n and g u, or that of their sum with given factors.
pub(super) fn chosen(rows: Rows, sum: Option<&[Range]>) -> Rows {
    let Some(factors) = sum else { return rows };
    let column = |j: usize| dot(rows.iter().map(|row| &row[j]), factors);
    vec![(0..rows[0].len()).map(column).collect()]
}

impl Loop {
    /// Returns the blocks of all lags from that of the time `to` on. Blocks grow with the lag and at most halve the
    /// time, as the weight may fall like a power of time.
    pub(super) fn blocks(&mut self, now: f64, mut to: f64) -> Option<Vec<Block>> {
        let mut blocks = Vec::new();
        while to > 0.0 {
            let lag = now - to;
            let length = self.flow.length();
            let from =
                if to <= length { 0.0 } else { (to - (0.5 * lag).max(length)).max(0.5 * to) };
            blocks.push(Block { ends: [from, to], bounds: self.flow.ever_after(lag)? });
            to = from;
        }
        Some(blocks)
    }

    /// The response at one T/tau, to what acts until a stretched time: of x_1..x_n and g u, or of a
    /// sum of them.
    pub(super) fn response(
        &mut self,
        share: &Interval,
        here: &Interval,
        until: Option<f64>,
        sum: Option<&[Range]>,
    ) -> Option<Response> {
        let table = self.clock.bell(share, here)?;
        let rows = chosen(mapped(&table, self.n, share), sum);
        let t = Range::from(here);
        let weight = self.weight.clone()?;
        let now = t.middle();
        let length = self.flow.length();
        let mut late = until.map_or(t, Range::from);
        let mut leaf = weight.at(late.middle());
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let mut piece = ((now - late.middle()) / length).floor().clamp(0.0, 1e15) as u64;
        let zero = vec![Range::from(0.0); rows.len()];
        let mut response = Response { signed: zero.clone(), size: zero };
        let mut asked = piece + ASKED;
        while late.low() > 0.0 {
            self.pieces = self.pieces.checked_sub(1)?;
            #[allow(clippy::cast_precision_loss)]
            let [next, node] = [(piece + 1) as f64 * length, (piece as f64 + 0.5) * length];
            let own: &Leaf = weight.leaf(leaf);
            let (of_lag, of_leaf) = (now - next, own.from);
            let early = of_lag.max(of_leaf).max(0.0);
            if early < late.low() {
                let middle = t - Range::from(node);
                let ends = [middle - late, middle - Range::from(early)];
                own.holds(late.hull(&Range::from(early))).then_some(())?;
                let impulse = self.flow.impulse_of(piece);
                let away = ends[0].size().most(&ends[1].size());
                let over = Piece {
                    impulse: &impulse,
                    length: (late - Range::from(early)).size(),
                    ends,
                    away,
                    weight: own.before(middle),
                    rest: own.rest,
                    left: self.flow.rest(&impulse, TERMS + 1, away),
                };
                let (moments, greatest) = (over.moments(), over.greatest());
                for (r, row) in rows.iter().enumerate() {
                    let [signed, size] = over.of_row(row, &moments, greatest);
                    response.signed[r] = response.signed[r] + signed;
                    response.size[r] = response.size[r] + size;
                }
                late = Range::from(early);
            }
            if of_leaf > of_lag {
                leaf = leaf.saturating_sub(1);
            } else {
                piece += 1;
            }
            if piece >= asked && late.low() > 0.0 {
                asked = piece + ASKED;
                let Some(blocks) = self.blocks(now, late.middle()) else { continue };
                let left = |row: &Vec<Range>| {
                    let of_block = |Block { ends: [from, to], bounds }: &Block| {
                        sizes(row, bounds) * weight.sum(*from, *to)
                    };
                    blocks.iter().map(of_block).sum()
                };
                let left: Vec<_> = rows.iter().map(left).collect();
                let is_little = |(left, size): (&Range, &Range)| left.high() <= LITTLE * size.low();
                if left.iter().zip(&response.size).all(is_little) {
                    for (r, left) in left.iter().enumerate() {
                        response.signed[r] = response.signed[r] + left.both_signs();
                        response.size[r] = response.size[r] + *left;
                    }
                    break;
                }
            }
        }
        Some(response)
    }
}
