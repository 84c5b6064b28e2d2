//! What a bounded f makes of x and u.
//!
//! An f of 1 for a moment dt' at T/tau = w' moves x_n by dt', and so xi_n by kappa'^-(n-1) dt'. What comes
//! of it at w is e^(A (t_kappa - t'_kappa)) times that, mapped back: the kernel G_i of each of x_1..x_n
//! and g u. Of all |f| <= D the one that turns with G_i is the worst, with D times the integral of |G_i|.
//! That is summed over sources, the cells of w': over each of which G_i is integrated to second order
//! where it keeps its sign, and bounded where it does not.

use super::cell::Loop;
use super::flow::Rows;
use crate::algebra::{BigRational, integer};
use crate::expression::interval::Interval;
use crate::expression::range::Range;

/// Sources of a run.
const MOST: usize = 1000;

/// What acts over a cell of w', as xi at the middle of it.
pub(super) struct Source {
    low: BigRational,
    middle: Interval,
    length: Range,
    /// xi of a moment of it, as its series in the moment: value and slope in the middle, and half the
    /// bend all over it.
    series: Rows,
}

impl Source {
    /// The integral of a kernel and that of its size, from the series of the kernel.
    fn integrals(&self, series: &[Range]) -> [Range; 2] {
        let length = self.length;
        let [value, slope, bend] = [series[0], series[1], series[2]];
        let bend = length.power(3) / Range::from(12.0) * bend;
        let signed = length * value + bend;
        let away = length / Range::from(2.0) * slope.size()
            + length.square() / Range::from(4.0) * series[2].size();
        if away.is_below(value.size()) {
            return [signed, signed.size()];
        }
        let quarter = length.square() / Range::from(4.0) * slope.size();
        [signed, (length * value).size() + quarter + bend.size()]
    }
}

/// Integrals of the kernel of each of x_1.. and its derivatives, and of its size.
pub(super) struct Response {
    pub(super) signed: Vec<Range>,
    pub(super) size: Vec<Range>,
}

impl Loop {
    /// The sources of all of a run.
    pub(super) fn sources(&mut self, until: &BigRational) -> Option<Vec<Source>> {
        let (mut sources, mut left) = (Vec::new(), vec![[until.clone(), integer(1)]]);
        while let Some([low, high]) = left.pop() {
            (sources.len() + left.len() < MOST).then_some(())?;
            let during = self.clock.stretched(&low)?.plus(&self.clock.stretched(&high)?.neg());
            if self.flow.reach(Range::from(&during)) < 0.2 && &high / &low < integer(2) {
                sources.push(self.source(&low, &high)?);
                continue;
            }
            let middle = (&low + &high) / integer(2);
            left.extend([[low, middle.clone()], [middle, high]]);
        }
        Some(sources)
    }

    /// An f of 1 from one T/tau to a smaller one.
    fn source(&mut self, low: &BigRational, high: &BigRational) -> Option<Source> {
        let at = (low + high) / integer(2);
        let middle = self.clock.stretched(&at)?;
        let during = self.clock.stretched(high)?.hull(&self.clock.stretched(low)?);
        let wide = Interval::between(low, Some(high));
        let back = Range::from(&middle.plus(&during.neg()));
        let mut series = self.impulse(&Interval::exact(&at), &middle)?;
        let over_all = self.impulse(&wide, &during)?;
        let bend = self.flow.on(&over_all, back)?;
        series.iter_mut().zip(&bend).for_each(|(row, bend)| row[2] = bend[2]);
        let length = Range::from(&Interval::exact(&(high - low)));
        Some(Source { low: low.clone(), middle, length, series })
    }

    /// xi after a moment of f as its series in the moment, to the second order, seen from a fixed time.
    fn impulse(&mut self, share: &Interval, stretched: &Interval) -> Option<Rows> {
        let slopes = self.clock.derivatives(share, stretched)?;
        let share = Range::from(1.0) / Range::from(share);
        let slope = |k: usize| slopes[k - 1] * share.power(i32::try_from(k).unwrap_or(0));
        let [one, two, three] = [slope(1), slope(2), slope(3)];
        let n = self.n;
        #[allow(clippy::cast_precision_loss)]
        let order = (n - 1) as f64;
        // kappa'^-(n-1) = first + second y + third y^2.
        let first = one.power(-i32::try_from(n - 1).ok()?);
        let (turn, bend) = (Range::from(2.0) * two / one, Range::from(3.0) * three / one);
        let second = -(first * Range::from(order) * turn);
        let half = Range::from(0.5 * order * (order + 1.0));
        let third = first * (half * turn.square() - Range::from(order) * bend);
        let unit = |i: usize| vec![Range::from(f64::from(u8::from(i + 1 == n)))];
        let unit: Rows = (0..n).map(unit).collect();
        let once = self.flow.rate_of(&unit);
        let twice = self.flow.rate_of(&once);
        let (linear, square) =
            (one * second + two * first, one.square() * first * Range::from(0.5));
        let row = |i: usize| {
            let [unit, once, twice] = [unit[i][0], once[i][0], twice[i][0]];
            let slope = second * unit - one * first * once;
            vec![first * unit, slope, third * unit - linear * once + square * twice]
        };
        Some((0..n).map(row).collect())
    }

    /// The integrals of the kernels up to the middle `at` of a cell.
    pub(super) fn response(
        &mut self,
        at: &BigRational,
        here: &Interval,
        table: &Rows,
    ) -> Option<Response> {
        let count = self.sources.iter().take_while(|source| source.low >= *at).count();
        let edge = count.checked_sub(1).map_or(integer(1), |last| self.sources[last].low.clone());
        let last = if edge > *at { Some(self.source(at, &edge)?) } else { None };
        let share = Interval::exact(at);
        let zero = vec![Range::from(0.0); table.len()];
        let mut response = Response { signed: zero.clone(), size: zero };
        for source in self.sources[..count].iter().chain(&last) {
            let since = here.plus(&source.middle.neg());
            let series = self.flow.at(&since, &source.series)?;
            let kernels = self.flow.derivatives(&share, table, series);
            for (i, kernel) in kernels.iter().enumerate() {
                let [signed, size] = source.integrals(kernel);
                response.signed[i] = response.signed[i] + signed;
                response.size[i] = response.size[i] + size;
            }
        }
        Some(response)
    }

    /// Over a cell of `share` around `here`: bounds of the integral of the size of the second
    /// derivative of the kernel of each of x_1.. and g u, for what acts before the cell, and of the
    /// size of each kernel for what acts within it.
    pub(super) fn response_over(
        &mut self,
        [low, high]: &[BigRational; 2],
        (here, around): (&Interval, Range),
        mut table: Rows,
    ) -> Option<(Vec<Range>, Vec<Range>)> {
        table.truncate(self.n + 3);
        let count = self.sources.iter().take_while(|source| source.low >= *high).count();
        let edge = count.checked_sub(1).map_or(integer(1), |last| self.sources[last].low.clone());
        let last = if edge > *high { Some(self.source(high, &edge)?) } else { None };
        let share = Interval::between(low, Some(high));
        let mut bent = vec![Range::from(0.0); self.n + 1];
        for source in self.sources[..count].iter().chain(&last) {
            let series = self.flow.at(&here.plus(&source.middle.neg()), &source.series)?;
            let kernels = self.flow.derivatives(&share, &table, self.flow.on(&series, around)?);
            for (sum, kernel) in bent.iter_mut().zip(&kernels[2..]) {
                *sum = *sum + source.integrals(kernel)[1];
            }
        }
        let (from, to) = (self.clock.stretched(high)?, self.clock.stretched(low)?);
        let moment = self.impulse(&share, &from.hull(&to))?;
        let since = Range::from(&to.plus(&from.neg())).hull(Range::from(0.0));
        table.truncate(self.n + 1);
        let kernels = self.flow.derivatives(&share, &table, self.flow.on(&moment, since)?);
        Some((bent, kernels.iter().map(|row| row[0].size()).collect()))
    }
}
