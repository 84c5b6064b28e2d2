//! Deviation of the response of x and u to a bounded f from linear interpolation between two T/tau.

use super::cell::Loop;
use super::flow::{Rows, dot};
use super::forced::{ASKED, Block, LITTLE, Response, chosen, mapped};
use super::impulse::LAST;
use super::piece::{along, polynomial, sizes};
use crate::algebra::BigRational;
use crate::expression::enclosure::{Interval, Range};

/// Largest part of the sum of second derivatives, which count by the square of the width of a cell, that may be left
/// far back.
const LESS: f64 = 1.0 / 64.0;

impl Loop {
    /// Bounds the deviation of the response to an f of 1, within a cell of T/tau, from linear interpolation between its
    /// ends, of which the later one has the response `last`.
    ///
    /// The action at a lag that both ends know is within h^2/2 |H''| of it. At longer lags the kernel
    /// begins within the cell: with the integral of it at the later end taken out, and its range times
    /// the time put in, no more than what is linear is left there, and what kappa is bent.
    pub(super) fn beyond(
        &mut self,
        [low, high]: &[BigRational; 2],
        half: Range,
        table: &Rows,
        last: &Response,
        sum: Option<&[Range]>,
    ) -> Option<Vec<Range>> {
        if half == Range::from(0.0) {
            return Some(vec![half; last.size.len()]);
        }
        let share = Interval::between(low, Some(high));
        let [first_at, last_at] = [self.clock.stretched(high)?, self.clock.stretched(low)?];
        let during = first_at.hull(&last_at);
        let kappa = self.clock.derivatives(&share, &during)?;
        let inverse = Range::from(1.0) / Range::from(&share);
        let rows = chosen(mapped(table, self.n, &share), sum);
        let (early, late) = (Range::from(&first_at), Range::from(&last_at));
        let bent = self.bent(table, [early, late], &kappa, inverse, sum)?;
        // The range of the kernel at the lags that only the later end knows.
        let passed = (late - early).size();
        let weight = self.weight.clone()?;
        let [of_weight, ..] = weight.over(0.0, passed.high());
        let lags = early.hull(&late);
        let phi = self.range_of_phi(lags)?;
        let ranges: Vec<_> = rows.iter().map(|row| dot(row, &phi) * of_weight).collect();
        let little =
            |(range, size): (&Range, &Range)| (passed * range.size()).high() <= LITTLE * size.low();
        let taken = match ranges.iter().zip(&last.size).all(little) {
            true => None,
            false => {
                let at = Interval::exact(low);
                Some(self.response(&at, &last_at, Some(passed.middle()), sum)?)
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
                    signed.most(&(most - taken)) + moved * range.size()
                }
            };
            (square * (bent[r] + turn.size() * range.size()) + edge).both_signs()
        };
        Some((0..rows.len()).map(one).collect())
    }

    /// Bounds phi_1.. over a time.
    fn range_of_phi(&mut self, lags: Range) -> Option<Vec<Range>> {
        let step = self.flow.step();
        let place = (lags.middle() / step).round();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let node = (place < 1e15).then_some(place.max(0.0) as u64)?;
        let y = lags - Range::from(place.max(0.0) * step);
        if y.size().high() <= 8.0 * step {
            let impulse = self.flow.impulse(node);
            let left = self.flow.rest(&impulse, LAST + 1, y);
            let one =
                |(terms, left): (&Vec<Range>, Range)| polynomial(terms, y) + left.both_signs();
            return Some(impulse.terms.iter().zip(left).map(one).collect());
        }
        let bounds = self.flow.ever_after(lags.low())?;
        Some(bounds.iter().map(|bound| bound.both_signs()).collect())
    }

    /// Bounds of the integral of the size of the second derivative by T/tau of each kernel at a fixed
    /// lag, over all of a cell and the lags that both of its ends know.
    fn bent(
        &mut self,
        table: &Rows,
        [early, late]: [Range; 2],
        kappa: &[Range],
        inverse: Range,
        sum: Option<&[Range]>,
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
            let power = inverse.whole_power(i32::try_from(r + 2).unwrap_or(i32::MAX));
            let slopes = Range::from(2.0) * one * first + two * own;
            [second, slopes, one.square() * own].map(|part| part * power)
        };
        let part = |k: usize| {
            let rows = (0..=n).map(|r| (0..=n).map(|j| of(r, j)[k]).collect()).collect();
            chosen(rows, sum)
        };
        let parts = [0, 1, 2].map(part);
        let count = parts[0].len();
        let with = |[_, first, second]: [Range; 3], r: usize| -> Vec<Range> {
            let [a, b, c] = [0, 1, 2].map(|k: usize| parts[k][r].iter());
            a.zip(b).zip(c).map(|((a, b), c)| *a + first * *b + second * *c).collect()
        };
        let length = self.flow.length();
        let half = Range::from(0.5 * length);
        let mut bent = vec![zero; count];
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
                let mut left = vec![zero; count];
                for Block { ends: [from, to], bounds } in &blocks {
                    let over = weight.over(*from, to + passed);
                    let time = (Range::from(*to) - Range::from(*from)).size();
                    for (r, left) in left.iter_mut().enumerate() {
                        *left = *left + sizes(&with(over, r), bounds) * over[0] * time;
                    }
                }
                let is_little = |(left, sum): (&Range, &Range)| left.high() <= LESS * sum.high();
                if left.iter().zip(&bent).all(is_little) {
                    bent.iter_mut().zip(&left).for_each(|(sum, left)| *sum = *sum + *left);
                    return Some(bent);
                }
            }
            let impulse = self.flow.impulse_of(piece);
            let times = [early - Range::from(lag + length), late - Range::from(lag)];
            let over = weight.over(times[0].low().max(0.0), times[1].high());
            let left = self.flow.rest(&impulse, 4, half);
            for (r, sum) in bent.iter_mut().enumerate() {
                let row = with(over, r);
                let terms = along(&row, &impulse, 3);
                let [value, slope, second, third] = [0, 1, 2, 3].map(|l: usize| terms[l].size());
                let slope = slope * half;
                let cube = half.whole_power(2) * (Range::from(2.0) * second + half * third);
                let more = Range::from(2.0) * sizes(&row, &left) + cube;
                *sum = *sum + over[0] * half * (value + value.most(&slope) + more);
            }
            piece += 1;
        }
    }
}
