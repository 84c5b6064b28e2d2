//! What a bounded f makes of x and u.
//!
//! An f of 1 for a moment ds of stretched time moves xi_n by m ds with the weight m = mu'^n. What comes
//! of it after the lag s is e^(A s) e_n =: phi(s) times that, mapped back: in row r of x_1..x_n and g u
//! the kernel H_r(w, s) = m(t - s) sum_j B_rj phi_{j+1}(s) at T/tau = w, t = kappa. Of all |f| <= D the
//! one that turns with H_r is the worst, with D times the integral of |H_r| over 0 <= s <= t.
//!
//! That is summed over pieces of s, over each of which phi and m are polynomials with a small rest. Far
//! back, where all that is left is little beside what is summed, it is bounded by the size of phi.
//! Between two w the kernel changes slowly at the same lag, however many time constants lie between
//! them, which is why bounds over a cell are formed there.

use super::cell::Loop;
use super::flow::{Impulse, Rows, TERMS, dot};
use super::weight::Leaf;
use crate::algebra::BigRational;
use crate::expression::interval::Interval;
use crate::expression::range::Range;

/// Nodes of the flow in a piece.
const NODES: u32 = 4;

/// What is left far back is at most this part of the sum.
const LITTLE: f64 = 1.0 / 4096.0;

/// The same of second derivatives, which count by the square of the width of a cell.
const LESS: f64 = 1.0 / 64.0;

/// Pieces after which it is asked whether what is left is little.
const ASKED: u64 = 8;

/// Parts of a piece in which a kernel has no sign.
const PARTS: u32 = 8;

/// Integrals of the kernels of x_1..x_n and g u for an f of 1, and of their sizes.
#[derive(Clone, Debug)]
pub(super) struct Response {
    pub(super) signed: Vec<Range>,
    pub(super) size: Vec<Range>,
}

fn real(value: usize) -> Range {
    Range::from(f64::from(u32::try_from(value).unwrap_or(u32::MAX)))
}

/// sum_j |a_j| b_j, with the first of `bounds` for all but the last column.
fn sizes(row: &[Range], bounds: [Range; 2]) -> Range {
    let last = row.len() - 1;
    let sum = row[..last].iter().fold(Range::from(0.0), |sum, entry| sum + entry.size());
    sum * bounds[0] + row[last].size() * bounds[1]
}

/// B_{r,j} of `table`, which has it times w^r.
fn mapped(table: &Rows, n: usize, share: &Interval) -> Rows {
    let inverse = Range::from(1.0) / Range::from(share);
    let full = |(r, row): (usize, &Vec<Range>)| {
        let power = inverse.power(i32::try_from(r).unwrap_or(i32::MAX));
        let entry = |j: usize| row.get(j).map_or(Range::from(0.0), |entry| *entry * power);
        (0..=n).map(entry).collect()
    };
    table.iter().take(n + 1).enumerate().map(full).collect()
}

/// Taylor coefficients of the sums of a row over phi, up to an order.
fn along(row: &[Range], impulse: &Impulse, order: usize) -> Vec<Range> {
    (0..=order).map(|l| dot(row, impulse.terms.iter().map(|terms| &terms[l]))).collect()
}

/// A piece of lags around a node of the flow: s = node + y for y between two ends.
struct Piece<'a> {
    impulse: &'a Impulse,
    ends: [Range; 2],
    /// The greatest |y|, and the length.
    away: Range,
    length: Range,
    /// The weight as a polynomial in y, and its rest.
    weight: Vec<Range>,
    rest: Range,
    /// What the Taylor series of phi leaves, for all but the last row and for that.
    left: [Range; 2],
}

impl Piece<'_> {
    /// Integrals of the powers of y times the polynomial of the weight over the piece.
    fn moments(&self) -> Vec<Range> {
        let count = TERMS + self.weight.len();
        let [mut low, mut high] = [Range::from(1.0); 2];
        let mut moments = Vec::with_capacity(count);
        for l in 1..=count {
            (low, high) = (low * self.ends[0], high * self.ends[1]);
            moments.push((high - low) / real(l));
        }
        (0..=TERMS).map(|l| dot(&self.weight, &moments[l..])).collect()
    }

    /// A bound of the polynomial of the weight.
    fn greatest(&self) -> Range {
        let horner = |sum: Range, term: &Range| sum * self.away + term.size();
        self.weight.iter().rev().fold(Range::from(0.0), horner)
    }

    /// The integrals of m times a row over phi, and of its size.
    fn of_row(&self, row: &[Range], moments: &[Range], greatest: Range) -> [Range; 2] {
        let terms = along(row, self.impulse, TERMS);
        let left = sizes(row, self.left);
        // The rests of both are beside the sum of the row, of which the terms may cancel.
        let far = terms[1..]
            .iter()
            .rev()
            .fold(Range::from(0.0), |sum, term| (sum + term.size()) * self.away);
        let most = terms[0].size() + far;
        let rest = (self.rest * (most + left) + left * greatest) * self.length;
        let signed = dot(&terms, moments) + rest.both_signs();
        if (far + left).is_below(terms[0].size()) {
            return [signed, signed.size()];
        }
        [signed, self.in_parts(&terms, left)]
    }

    /// A bound of the integral of the size of a polynomial with a rest, times m.
    fn in_parts(&self, terms: &[Range], left: Range) -> Range {
        let [low, high] = [self.ends[0].low(), self.ends[1].high()];
        let bent =
            terms.iter().enumerate().skip(2).rev().fold(Range::from(0.0), |sum, (l, term)| {
                sum * self.away + term.size() * real(l) * real(l - 1)
            });
        let width = (high - low) / f64::from(PARTS);
        let part = |k: u32| {
            let ends = [0, 1].map(|end| match k + end {
                PARTS => high,
                k => low + f64::from(k) * width,
            });
            let y = Range::from(0.5 * ends[0] + 0.5 * ends[1]);
            let within = Range::from(ends[0]).hull(Range::from(ends[1]));
            let half = (within - y).size();
            let horner = |terms: &[Range], y: Range| {
                terms.iter().rev().fold(Range::from(0.0), |sum, term| sum * y + *term)
            };
            let slopes: Vec<_> =
                terms.iter().enumerate().skip(1).map(|(l, term)| *term * real(l)).collect();
            let (value, slope) = (horner(terms, y).size(), horner(&slopes, y).size());
            let rest = left + Range::from(0.5) * bent * half * half;
            let area = half * (value + value.most(slope * half)) + Range::from(2.0) * half * rest;
            area * (horner(&self.weight, within).size() + self.rest)
        };
        (0..PARTS).map(part).fold(Range::from(0.0), |sum, area| sum + area)
    }
}

impl Loop {
    /// The node of the flow that is not after a lag by much less than it, of few.
    fn node_before(&self, lag: f64) -> u64 {
        let place = (lag / self.flow.step()).floor();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let k = if place > 1.0 && place < 1e15 { place as u64 - 1 } else { 0 };
        let dropped = (64 - k.leading_zeros()).saturating_sub(4);
        k >> dropped << dropped
    }

    /// What is left of all lags from that of the time `to` on, in blocks that double.
    fn blocks(&mut self, now: f64, mut to: f64) -> Option<Vec<([f64; 2], [Range; 2])>> {
        let mut blocks = Vec::new();
        while to > 0.0 {
            let lag = now - to;
            let from = (to - lag.max(self.flow.step())).max(0.0);
            let node = self.node_before(lag);
            blocks.push(([from, to], self.flow.ever_after(node)?));
            to = from;
        }
        Some(blocks)
    }

    /// The response at one T/tau, to what acts until a stretched time.
    pub(super) fn response(
        &mut self,
        share: &Interval,
        here: &Interval,
        until: Option<f64>,
    ) -> Option<Response> {
        let table = self.clock.bell(share, here)?;
        let rows = mapped(&table, self.n, share);
        let t = Range::from(here);
        let weight = self.weight.clone()?;
        let now = t.middle();
        let step = self.flow.step();
        let length = step * f64::from(NODES);
        let mut late = until.map_or(t, Range::from);
        let mut leaf = weight.at(late.middle());
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let mut piece = ((now - late.middle()) / length).floor().clamp(0.0, 1e15) as u64;
        let zero = vec![Range::from(0.0); self.n + 1];
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
                own.holds(late.hull(Range::from(early))).then_some(())?;
                let impulse = self.flow.impulse(piece * u64::from(NODES) + u64::from(NODES / 2));
                let away = ends[0].size().most(ends[1].size());
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
                    let of_block = |([from, to], bounds): &([f64; 2], [Range; 2])| {
                        sizes(row, *bounds) * weight.sum(*from, *to)
                    };
                    blocks.iter().map(of_block).fold(Range::from(0.0), |sum, block| sum + block)
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

    /// How far the response to an f of 1 may be, within a cell of T/tau, from what is linear between
    /// its ends, of which the later one has the response `last`.
    ///
    /// What acts at a lag that both ends know is within h^2/2 |H''| of it. At longer lags the kernel
    /// begins within the cell: with the integral of it at the later end taken out, and its range times
    /// the time put in, no more than what is linear is left there, and what kappa is bent.
    pub(super) fn beyond(
        &mut self,
        [low, high]: &[BigRational; 2],
        half: Range,
        table: &Rows,
        last: &Response,
    ) -> Option<Vec<Range>> {
        let n = self.n;
        if half == Range::from(0.0) {
            return Some(vec![half; n + 1]);
        }
        let share = Interval::between(low, Some(high));
        let [first_at, last_at] = [self.clock.stretched(high)?, self.clock.stretched(low)?];
        let during = first_at.hull(&last_at);
        let kappa = self.clock.derivatives(&share, &during)?;
        let inverse = Range::from(1.0) / Range::from(&share);
        let rows = mapped(table, n, &share);
        let (early, late) = (Range::from(&first_at), Range::from(&last_at));
        let bent = self.bent(table, [early, late], &kappa, inverse)?;
        // The range of the kernel at the lags that only the later end knows.
        let passed = (late - early).size();
        let weight = self.weight.clone()?;
        let [of_weight, ..] = weight.over(0.0, passed.high());
        let lags = early.hull(late);
        let phi = self.range_of_phi(lags)?;
        let ranges: Vec<_> = rows.iter().map(|row| dot(row, &phi) * of_weight).collect();
        let little =
            |(range, size): (&Range, &Range)| (passed * range.size()).high() <= LITTLE * size.low();
        let taken = match ranges.iter().zip(&last.size).all(little) {
            true => None,
            false => {
                let at = Interval::exact(low);
                Some(self.response(&at, &last_at, Some(passed.middle()))?)
            }
        };
        let moved = (passed - Range::from(passed.middle())).size();
        let turn = Range::from(2.0) * kappa[1] * inverse.square();
        let square = Range::from(0.5) * half * half;
        let one = |r: usize| {
            let range = ranges[r];
            let most = passed * range.size();
            let edge = match &taken {
                None => most,
                Some(taken) => {
                    let signed = (passed * range - taken.signed[r]).size();
                    let taken = Range::from(taken.signed[r].size().low());
                    signed.most(most - taken) + moved * range.size()
                }
            };
            (square * (bent[r] + turn.size() * range.size()) + edge).both_signs()
        };
        Some((0..=n).map(one).collect())
    }

    /// What phi_1.. are within over a time.
    fn range_of_phi(&mut self, lags: Range) -> Option<Vec<Range>> {
        let step = self.flow.step();
        let place = (lags.middle() / step).round();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let node = (place < 1e15).then_some(place.max(0.0) as u64)?;
        let y = lags - Range::from(place.max(0.0) * step);
        if y.size().high() <= 8.0 * step {
            let impulse = self.flow.impulse(node);
            let left = self.flow.rest(&impulse, TERMS + 1, y);
            let count = impulse.terms.len();
            let one = |(j, terms): (usize, &Vec<Range>)| {
                let sum = terms.iter().rev().fold(Range::from(0.0), |sum, term| sum * y + *term);
                sum + left[usize::from(j + 1 == count)].both_signs()
            };
            return Some(impulse.terms.iter().enumerate().map(one).collect());
        }
        let node = self.node_before(lags.low());
        let [all, last] = self.flow.ever_after(node)?;
        let entry = |j: usize| if j == self.n { last } else { all };
        Some((0..=self.n).map(|j| entry(j).both_signs()).collect())
    }

    /// Bounds of the integral of the size of the second derivative by T/tau of each kernel at a fixed
    /// lag, over all of a cell and the lags that both of its ends know.
    fn bent(
        &mut self,
        table: &Rows,
        [early, late]: [Range; 2],
        kappa: &[Range],
        inverse: Range,
    ) -> Option<Vec<Range>> {
        let n = self.n;
        let weight = self.weight.clone()?;
        let zero = Range::from(0.0);
        let [one, two] = [kappa[0], Range::from(2.0) * kappa[1]];
        // w^r B_{r,j}, and 0 beside the table.
        let at = |r: usize, j: usize, less: usize| {
            let column = j.checked_sub(less);
            column.and_then(|j| table.get(r)?.get(j).copied()).unwrap_or(zero)
        };
        // B'' + 2 B' kappa' m'/m + B (kappa'^2 m''/m + kappa'' m'/m), times w^(r+2).
        let of = |r: usize, j: usize| {
            let first = at(r + 1, j, 0) - one * at(r, j, 1);
            let second =
                at(r + 2, j, 0) - Range::from(2.0) * one * at(r + 1, j, 1) - two * at(r, j, 1)
                    + one.square() * at(r, j, 2);
            let own = at(r, j, 0);
            let power = inverse.power(i32::try_from(r + 2).unwrap_or(i32::MAX));
            let slopes = Range::from(2.0) * one * first + two * own;
            [second, slopes, one.square() * own].map(|part| part * power)
        };
        let parts: Vec<Vec<[Range; 3]>> =
            (0..=n).map(|r| (0..=n).map(|j| of(r, j)).collect()).collect();
        let with = |[_, first, second]: [Range; 3], r: usize| -> Vec<Range> {
            parts[r].iter().map(|[a, b, c]| *a + first * *b + second * *c).collect()
        };
        let step = self.flow.step();
        let length = step * f64::from(NODES);
        let half = Range::from(0.5 * length);
        let mut bent = vec![zero; n + 1];
        let mut piece = 0_u64;
        loop {
            #[allow(clippy::cast_precision_loss)]
            let lag = piece as f64 * length;
            if lag >= early.high() {
                return Some(bent);
            }
            self.pieces = self.pieces.checked_sub(1)?;
            if piece > 0
                && piece.is_multiple_of(ASKED)
                && let Some(blocks) = self.blocks(early.high(), early.high() - lag)
            {
                // A lag is at a time as much later as the cell is long.
                let passed = (late - early).size().high();
                let mut left = vec![zero; n + 1];
                for ([from, to], bounds) in &blocks {
                    let over = weight.over(*from, to + passed);
                    let time = (Range::from(*to) - Range::from(*from)).size();
                    for (r, left) in left.iter_mut().enumerate() {
                        *left = *left + sizes(&with(over, r), *bounds) * over[0] * time;
                    }
                }
                let is_little = |(left, sum): (&Range, &Range)| left.high() <= LESS * sum.high();
                if left.iter().zip(&bent).all(is_little) {
                    bent.iter_mut().zip(&left).for_each(|(sum, left)| *sum = *sum + *left);
                    return Some(bent);
                }
            }
            let impulse = self.flow.impulse(piece * u64::from(NODES) + u64::from(NODES / 2));
            let times = [early - Range::from(lag + length), late - Range::from(lag)];
            let over = weight.over(times[0].low().max(0.0), times[1].high());
            let left = self.flow.rest(&impulse, 4, half);
            for (r, sum) in bent.iter_mut().enumerate() {
                let row = with(over, r);
                let terms = along(&row, &impulse, 3);
                let [value, slope, second, third] = [0, 1, 2, 3].map(|l: usize| terms[l].size());
                let slope = slope * half;
                let cube = half.power(2) * (Range::from(2.0) * second + half * third);
                let more = Range::from(2.0) * sizes(&row, left) + cube;
                *sum = *sum + over[0] * half * (value + value.most(slope) + more);
            }
            piece += 1;
        }
    }
}
