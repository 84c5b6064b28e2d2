//! Whether an objective holds over a cell of T/tau and one of tau.

use std::ops::Add;

use super::cell::Cell;
use super::clock::values;
use super::flow::{Rows, dot};
use super::range::Range;
use super::{Campaign, Kind};
use crate::algebra::{BigRational, integer};
use crate::check::membership::enclosure::{Evaluator, Names};
use crate::expression::interval::Interval;
use crate::expression::{Expression, Variable};
use crate::spec::Parameter;

/// What stands beside the loop in an objective.
pub(super) struct Bounds {
    n: usize,
    gain: Range,
    start: Vec<Range>,
    /// The corners of the box, at one of which |x| is greatest; the box itself where they are many.
    corners: Rows,
    names: Names,
    evaluator: Evaluator,
}

/// Order from which on the corners of a box are too many.
const MANY: usize = 9;

fn sum(terms: impl Iterator<Item = Range>) -> Range {
    terms.fold(Range::from(0.0), Range::add)
}

/// x and u over a cell, in the units of the plant.
struct Point {
    /// x_1..x_n and u, each by its slope along x_1..x_n at t0, and what f adds.
    rows: Rows,
    names: Names,
}

impl Bounds {
    pub(super) fn new(campaign: &Campaign, gain: &BigRational) -> Option<Self> {
        let values = values(campaign).into_iter();
        let mut names: Names =
            values.map(|(name, value)| (name.into(), Interval::exact(&value))).collect();
        names.entry(Parameter::StartTime.into()).or_insert_with(|| Interval::integer(0));
        let ends = |(low, high): &(f64, f64)| [Range::from(*low), Range::from(*high)];
        let start = campaign.x0.iter().map(ends).map(|[low, high]| low.hull(high));
        // What f adds stands in a column of its own.
        let start = start.chain([Range::from(1.0)]).collect();
        let mut corners = vec![Vec::new()];
        for mut ends in campaign.x0.iter().map(ends).map(Vec::from) {
            ends.dedup();
            if campaign.spec.n >= MANY {
                ends = vec![ends[0].hull(ends[ends.len() - 1])];
            }
            let with = |corner: &Vec<_>, end| [&corner[..], &[end]].concat();
            let all = corners.iter().flat_map(|corner| ends.iter().map(|end| with(corner, *end)));
            corners = all.collect();
        }
        corners.iter_mut().for_each(|corner| corner.push(Range::from(1.0)));
        let gain = Range::from(&Interval::exact(gain));
        Some(Self { n: campaign.spec.n, gain, start, corners, names, evaluator: Evaluator::new() })
    }

    /// Whether what is to hold does so for all of a cell, and for all of `tau`.
    pub(super) fn holds(&mut self, kind: &Kind, cell: &Cell, tau: &[BigRational; 2]) -> bool {
        let point = self.point(cell, tau);
        let known = match kind {
            Kind::State { sigma, zeta } => self.state(&point, *sigma, zeta),
            Kind::Input { upsilon } => self.value(upsilon, &point.names).map(|most| {
                let u = self.along(&point.rows[self.n]);
                u.both_signs().is_below(most)
            }),
            Kind::Attractive { error } => {
                let most = Range::from(*error).square();
                Some(self.greatest(&point.rows[..self.n]).is_below(most))
            }
            Kind::Within { h, low, high } => self.within(&point, h, [low, high]),
        };
        known.unwrap_or(false)
    }

    fn point(&self, cell: &Cell, tau: &[BigRational; 2]) -> Point {
        let [low, high] = &cell.share;
        let within = |low: &BigRational, high: &BigRational| Interval::between(low, Some(high));
        let one = integer(1);
        let elapsed = within(&((&one - high) * &tau[0]), &((&one - low) * &tau[1]));
        let mut names = self.names.clone();
        names.insert(Variable::TimeToGo.into(), within(&(low * &tau[0]), &(high * &tau[1])));
        let time = names.get(&Parameter::StartTime.into()).map(|start| start.plus(&elapsed));
        names.extend(time.map(|time| (Variable::Time.into(), time)));
        names.insert(Variable::Elapsed.into(), elapsed);
        let tau = within(&tau[0], &tau[1]);
        let scale = Range::from(&tau);
        names.insert(Parameter::Tau.into(), tau);
        // With tau = 1 x_j stands for tau^(j-1) x_j, and g u for tau^n g u.
        let power = |i: usize| i32::try_from(i).unwrap_or(i32::MAX);
        let mut rows = cell.rows.clone();
        for (i, row) in rows.iter_mut().enumerate() {
            for (c, entry) in row.iter_mut().enumerate() {
                *entry = *entry * scale.power(power(c) - power(i));
            }
        }
        rows[self.n].iter_mut().for_each(|entry| *entry = *entry / self.gain);
        for (j, row) in (1..).zip(&rows) {
            let name = if j > self.n { Variable::Control } else { Variable::State(j) };
            names.insert(name.into(), self.along(row).into());
        }
        Point { rows, names }
    }

    /// What a row is over the box of initial states.
    fn along(&self, row: &[Range]) -> Range {
        dot(row, &self.start)
    }

    /// The greatest |x|^2 over the box.
    fn greatest(&self, rows: &[Vec<Range>]) -> Range {
        let size = |corner: &Vec<Range>| sum(rows.iter().map(|row| dot(row, corner).square()));
        let sizes = self.corners.iter().map(size);
        sizes.reduce(Range::most).unwrap_or(Range::WHOLE)
    }

    fn value(&mut self, expression: &Expression, names: &Names) -> Option<Range> {
        Some(Range::from(&self.evaluator.sound(expression, names)?))
    }

    /// |x| < sigma |x0| zeta: for the x0 of the box, or for all.
    fn state(&mut self, point: &Point, sigma: f64, zeta: &Expression) -> Option<bool> {
        let zeta = self.value(zeta, &point.names)?;
        let bound = (Range::from(sigma) * zeta).square();
        let rows = &point.rows[..self.n];
        let least = sum(self.start[..self.n].iter().map(|x| x.square()));
        let of_box = self.greatest(rows).is_below(bound * least);
        let proved = of_box || is_contraction(rows, bound);
        Some(zeta.is_positive() && proved)
    }

    fn within(
        &mut self,
        point: &Point,
        h: &Expression,
        [low, high]: [&Option<Expression>; 2],
    ) -> Option<bool> {
        let h = match self.linear(point, h) {
            Some(h) => h,
            None => self.value(h, &point.names)?,
        };
        let mut bound = |e: &Option<Expression>| match e {
            Some(e) => self.value(e, &point.names).map(Some),
            None => Some(None),
        };
        let (low, high) = (bound(low)?, bound(high)?);
        Some(low.is_none_or(|low| low.is_below(h)) && high.is_none_or(|high| h.is_below(high)))
    }

    /// An h that is linear in x and u, along which states and control move together.
    fn linear(&mut self, point: &Point, h: &Expression) -> Option<Range> {
        let names = (1..=self.n).map(Variable::State).chain([Variable::Control]);
        let moves = |e: &Expression| {
            matches!(e, Expression::Variable(Variable::State(_) | Variable::Control))
        };
        let mut row = vec![Range::from(0.0); self.n + 1];
        for (name, own) in names.zip(&point.rows) {
            let slope = h.derivative(name);
            if slope.any(&moves) {
                return None;
            }
            let slope = self.value(&slope, &point.names)?;
            row.iter_mut().zip(own).for_each(|(sum, x)| *sum = *sum + slope * *x);
        }
        let rest = h.substitute(&|e| moves(e).then(|| Expression::integer(0)));
        Some(self.along(&row) + self.value(&rest, &point.names)?)
    }
}

/// Whether |rows x|^2 < bound |x|^2 for all x, where f adds nothing: bound - rows^T rows is positive
/// definite, by the pivots of an elimination.
fn is_contraction(rows: &[Vec<Range>], bound: Range) -> bool {
    let n = rows.len();
    if rows.iter().any(|row| row[n] != Range::from(0.0)) {
        return false;
    }
    let entry = |a: usize, b: usize| {
        let product = match a == b {
            true => sum(rows.iter().map(|row| row[a].square())),
            false => sum(rows.iter().map(|row| row[a] * row[b])),
        };
        if a == b { bound - product } else { -product }
    };
    let mut matrix: Rows = (0..n).map(|a| (0..n).map(|b| entry(a, b)).collect()).collect();
    for pivot in 0..n {
        let first = matrix[pivot].clone();
        if !first[pivot].is_positive() {
            return false;
        }
        for row in &mut matrix[pivot + 1..] {
            let factor = row[pivot] / first[pivot];
            for (entry, first) in row.iter_mut().zip(&first).skip(pivot) {
                *entry = *entry - factor * *first;
            }
        }
    }
    true
}
