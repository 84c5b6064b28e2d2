//! Whether an objective holds over a cell of T/tau and one of tau.

use super::cell::Cell;
use super::clock::values;
use super::flow::{Rows, dot};
use super::{Campaign, Kind};
use crate::algebra::{BigRational, integer};
use crate::check::membership::enclosure::{Evaluator, Names};
use crate::expression::interval::Interval;
use crate::expression::{Expression, Variable};
use crate::spec::Parameter;

/// What stands beside the loop in an objective.
pub(super) struct Bounds {
    n: usize,
    gain: Interval,
    start: Vec<Interval>,
    names: Names,
}

/// An exact double.
fn number(value: f64) -> Option<Interval> {
    BigRational::from_float(value).map(|value| Interval::exact(&value))
}

fn square(value: &Interval) -> Interval {
    value.whole_power(2)
}

fn sum(terms: impl Iterator<Item = Interval>) -> Interval {
    terms.fold(Interval::integer(0), |sum, term| sum.plus(&term))
}

/// x and u over a cell, in the units of the plant.
struct Point {
    /// x_1..x_n and u, each by its slope along x_1..x_n at t0.
    rows: Rows,
    names: Names,
}

impl Bounds {
    pub(super) fn new(campaign: &Campaign, gain: &BigRational) -> Option<Self> {
        let exact = BigRational::from_float;
        let start =
            |(low, high): &(f64, f64)| Some(Interval::between(&exact(*low)?, Some(&exact(*high)?)));
        let values = values(campaign).into_iter();
        let mut names: Names =
            values.map(|(name, value)| (name.into(), Interval::exact(&value))).collect();
        names.insert(Parameter::StartTime.into(), Interval::integer(0));
        Some(Self {
            n: campaign.spec.n,
            gain: Interval::exact(gain),
            start: campaign.x0.iter().map(start).collect::<Option<_>>()?,
            names,
        })
    }

    /// Whether what is to hold does so for all of a cell, and for all of `tau`.
    pub(super) fn holds(&self, kind: &Kind, cell: &Cell, tau: &[BigRational; 2]) -> bool {
        let point = self.point(cell, tau);
        let known = match kind {
            Kind::State { sigma, zeta } => self.state(&point, *sigma, zeta),
            Kind::Input { upsilon } => self.value(upsilon, &point.names).map(|most| {
                let u = self.along(&point.rows[self.n]);
                is_below(&u, &most) && is_below(&u.neg(), &most)
            }),
            Kind::Attractive { error } => number(*error).map(|error| {
                let x = point.rows[..self.n].iter().map(|row| square(&self.along(row)));
                is_below(&sum(x), &square(&error))
            }),
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
        names.insert(Variable::Time.into(), elapsed.clone());
        names.insert(Variable::Elapsed.into(), elapsed);
        let tau = within(&tau[0], &tau[1]);
        names.insert(Parameter::Tau.into(), tau.clone());
        // With tau = 1 x_j stands for tau^(j-1) x_j, and g u for tau^n g u.
        let power = |i: usize| i32::try_from(i).unwrap_or(i32::MAX);
        let mut rows = cell.rows.clone();
        for (i, row) in rows.iter_mut().enumerate() {
            for (c, entry) in row.iter_mut().enumerate() {
                *entry = entry.times(&tau.whole_power(power(c) - power(i)));
            }
        }
        rows[self.n].iter_mut().for_each(|entry| *entry = entry.over(&self.gain));
        for (j, row) in (1..).zip(&rows) {
            let name = if j > self.n { Variable::Control } else { Variable::State(j) };
            names.insert(name.into(), self.along(row));
        }
        Point { rows, names }
    }

    /// What a row is over the box of initial states.
    fn along(&self, row: &[Interval]) -> Interval {
        dot(row, &self.start)
    }

    fn value(&self, expression: &Expression, names: &Names) -> Option<Interval> {
        let value = Evaluator::new().value(expression, names)?;
        (!value.is_undefined && !value.may_divide_by_zero).then_some(value.interval)
    }

    /// |x| < sigma |x0| zeta: for the x0 of the box, or for all.
    fn state(&self, point: &Point, sigma: f64, zeta: &Expression) -> Option<bool> {
        let zeta = self.value(zeta, &point.names)?;
        let bound = square(&number(sigma)?.times(&zeta));
        let rows = &point.rows[..self.n];
        let least = sum(self.start.iter().map(square));
        let of_box = sum(rows.iter().map(|row| square(&self.along(row))));
        let proved = is_below(&of_box, &bound.times(&least)) || is_contraction(rows, &bound);
        Some(zeta.is_positive() && proved)
    }

    fn within(
        &self,
        point: &Point,
        h: &Expression,
        [low, high]: [&Option<Expression>; 2],
    ) -> Option<bool> {
        let h = self.linear(point, h).or_else(|| self.value(h, &point.names))?;
        let bound = |e: &Option<Expression>| match e {
            Some(e) => self.value(e, &point.names).map(Some),
            None => Some(None),
        };
        let (low, high) = (bound(low)?, bound(high)?);
        Some(
            low.is_none_or(|low| is_below(&low, &h)) && high.is_none_or(|high| is_below(&h, &high)),
        )
    }

    /// An h that is linear in x and u, along which states and control move together.
    fn linear(&self, point: &Point, h: &Expression) -> Option<Interval> {
        let names = (1..=self.n).map(Variable::State).chain([Variable::Control]);
        let moves = |e: &Expression| {
            matches!(e, Expression::Variable(Variable::State(_) | Variable::Control))
        };
        let mut row = vec![Interval::integer(0); self.n];
        for (name, own) in names.zip(&point.rows) {
            let slope = h.derivative(name);
            if slope.any(&moves) {
                return None;
            }
            let slope = self.value(&slope, &point.names)?;
            row.iter_mut().zip(own).for_each(|(sum, x)| *sum = sum.plus(&slope.times(x)));
        }
        let rest = h.substitute(&|e| moves(e).then(|| Expression::integer(0)));
        Some(self.along(&row).plus(&self.value(&rest, &point.names)?))
    }
}

fn is_below(a: &Interval, b: &Interval) -> bool {
    b.plus(&a.neg()).is_positive()
}

/// Whether |rows x|^2 < bound |x|^2 for all x: bound - rows^T rows is positive definite, by the
/// pivots of an elimination.
fn is_contraction(rows: &[Vec<Interval>], bound: &Interval) -> bool {
    let n = rows.len();
    let entry = |a: usize, b: usize| {
        let product = match a == b {
            true => sum(rows.iter().map(|row| square(&row[a]))),
            false => sum(rows.iter().map(|row| row[a].times(&row[b]))),
        };
        if a == b { bound.plus(&product.neg()) } else { product.neg() }
    };
    let mut matrix: Rows = (0..n).map(|a| (0..n).map(|b| entry(a, b)).collect()).collect();
    for pivot in 0..n {
        let first = matrix[pivot].clone();
        if !first[pivot].is_positive() {
            return false;
        }
        for row in &mut matrix[pivot + 1..] {
            let factor = row[pivot].over(&first[pivot]);
            for (entry, first) in row.iter_mut().zip(&first).skip(pivot) {
                *entry = entry.plus(&factor.times(first).neg());
            }
        }
    }
    true
}
