//! x and u over a cell of T/tau and one of tau.

use super::super::cell::{Cell, half_of};
use super::super::flow::{Rows, dot};
use super::Bounds;
use crate::algebra::{BigRational, integer};
use crate::expression::Variable;
use crate::expression::enclosure::{Interval, Range};
use crate::expression::evaluator::Names;
use crate::parameter::Parameter;

/// The end of a cell of T/tau to which a step of time leads: 0 for the least.
fn end_of(moved: Range) -> usize {
    usize::from(!moved.is_positive())
}

/// x and u over a cell of T/tau and one of tau, in the units of the plant.
///
/// To first order in T/tau and tau x and u move between those of the corners of both cells, of which
/// each holds the rest of second order. What is convex in them, as a norm or a sum is, is greatest at
/// one of the corners.
pub(super) struct Point {
    pub(super) corners: Vec<Corner>,
    pub(super) names: Names,
    pub(super) share: [BigRational; 2],
    /// tau, and its middle.
    pub(super) tau: [Range; 2],
}

/// One of the corners of a cell of T/tau and one of tau.
pub(super) struct Corner {
    /// x_1..x_n and u, each by its slope along x_1..x_n at t0, and what f adds.
    pub(super) rows: Rows,
    /// 0 at the least T/tau, 1 at the greatest.
    pub(super) end: usize,
}

impl Bounds {
    pub(super) fn point(&self, cell: &Cell, tau: &[BigRational; 2]) -> Point {
        let [low, high] = &cell.share;
        let within = |low: &BigRational, high: &BigRational| Interval::between(low, Some(high));
        let one = integer(1);
        let mut names = self.names.clone();
        names.insert(Variable::TimeToGo.into(), within(low, high));
        names.insert(Variable::Elapsed.into(), within(&(&one - high), &(&one - low)));
        let scale = within(&tau[0], &tau[1]);
        names.insert(Parameter::Tau.into(), scale.clone());
        let middle = Interval::exact(&((&tau[0] + &tau[1]) / integer(2)));
        let wide = half_of(tau);
        let tau = [Range::from(&scale), Range::from(&middle)];
        let corners = self.moved(cell, tau, wide);
        let mut point = Point { corners, names, share: cell.share.clone(), tau };
        for j in 1..=self.n + 1 {
            let name = if j > self.n { Variable::Control } else { Variable::State(j) };
            let values = self.of_row(&point, j - 1);
            point.names.insert(name.into(), values.into());
        }
        for (j, start) in (1..).zip(&self.start[..self.n]) {
            point.names.insert(Variable::StateAtStart(j).into(), (*start).into());
        }
        point
    }

    /// Bounds x_1..x_n over a cell of T/tau and one of tau, and approximately in the middle of both; `None` where they
    /// are not bounded.
    pub(in crate::verify::bound) fn states(
        &self,
        cell: &Cell,
        tau: &[BigRational; 2],
    ) -> Option<[Vec<[f64; 2]>; 2]> {
        let point = self.point(cell, tau);
        let here = point.tau[1];
        let power = |i: usize| i32::try_from(i).unwrap_or(i32::MAX);
        let middle = |i: usize| {
            let scaled = |c: usize, entry: Range| entry * here.whole_power(power(c) - power(i));
            let entry = |c: usize| scaled(c, cell.middle[0][i][c]);
            let about = scaled(self.n, cell.about[i]);
            let row: Vec<_> = (0..self.n).map(entry).chain([about]).collect();
            self.along(&row)
        };
        let ends = |x: Range| x.is_bounded().then(|| [x.low(), x.high()]);
        let of = |state: &dyn Fn(usize) -> Range| {
            (0..self.n).map(|i| ends(state(i))).collect::<Option<Vec<_>>>()
        };
        Some([of(&|i| self.of_row(&point, i))?, of(&middle)?])
    }

    /// The corners of a [`Point`], from tau, its middle and half its width. With tau = 1 entry c of x_i stands for tau^(i-c) times it, and g u
    /// for tau^n g u. The rest is half the second derivative by both times both widths.
    fn moved(&self, cell: &Cell, [scale, here]: [Range; 2], wide: Range) -> Vec<Corner> {
        let half = cell.half;
        let both = |width: Range| match width == Range::from(0.0) {
            true => vec![width],
            false => vec![width, -width],
        };
        let power = |i: usize| i32::try_from(i).unwrap_or(i32::MAX);
        let entry = |(i, c): (usize, usize), (first, second): (Range, Range)| {
            // What f adds stands at the end of the cell already.
            let zero = Range::from(0.0);
            let of_f = |at: &[Vec<Range>; 2]| (at[end_of(first)][i], at[0][i].hull(&at[1][i]));
            let (middle, slope, [over, slopes, bend]) = match &cell.added {
                _ if c < self.n => {
                    let [middle, slope] = [0, 1].map(|k| cell.middle[k][i][c]);
                    (middle, slope, [0, 1, 2].map(|k| cell.over[k][i][c].size()))
                }
                Some(added) => {
                    let (here, over) = of_f(added);
                    (here, zero, [over.size(), zero, zero])
                }
                None => return zero,
            };
            let q = power(c) - power(i);
            let [one, two] = [f64::from(q), f64::from(q) * f64::from(q - 1)].map(Range::from);
            let linear = (middle + first * slope) * here.whole_power(q)
                + second * one * middle * here.whole_power(q - 1);
            let rest = half * half * bend * scale.whole_power(q)
                + Range::from(2.0) * half * wide * slopes * one.size() * scale.whole_power(q - 1)
                + wide * wide * over * two.size() * scale.whole_power(q - 2);
            let whole = linear + (Range::from(0.5) * rest).both_signs();
            if i == self.n { whole / self.gain } else { whole }
        };
        let row = |i: usize, moved: (Range, Range)| {
            (0..=self.n).map(|c| entry((i, c), moved)).collect::<Vec<_>>()
        };
        let corner = |moved: (Range, Range)| {
            let rows = (0..=self.n).map(|i| row(i, moved)).collect();
            Corner { rows, end: end_of(moved.0) }
        };
        let moves = both(half)
            .into_iter()
            .flat_map(|first| both(wide).into_iter().map(move |second| (first, second)));
        moves.map(corner).collect()
    }

    /// Bounds row i of a point over the box of initial states.
    pub(super) fn of_row(&self, point: &Point, i: usize) -> Range {
        let values = point.corners.iter().map(|corner| self.along(&corner.rows[i]));
        values.reduce(|a, b| a.hull(&b)).unwrap_or(Range::WHOLE)
    }

    /// Bounds a row over the box of initial states.
    pub(super) fn along(&self, row: &[Range]) -> Range {
        dot(row, &self.start)
    }

    /// The greatest |x|^2 over the box.
    pub(super) fn greatest(&self, rows: &[Vec<Range>]) -> Range {
        let size =
            |corner: &Vec<Range>| rows.iter().map(|row| dot(row, corner).square()).sum::<Range>();
        let sizes = self.corners.iter().map(size);
        sizes.reduce(|a, b| a.most(&b)).unwrap_or(Range::WHOLE)
    }
}
