//! Test whether an objective holds over a cell of T/tau and one of tau.

mod point;
mod value;

use super::Campaign;
use super::aim::Aim;
use super::cell::{Cell, Loop};
use super::flow::Rows;
use super::norm::{is_contraction, norm_about};
use super::reason::{Why, below, squares};
use crate::algebra::BigRational;
use crate::expression::enclosure::{Interval, Range};
use crate::expression::evaluator::{Evaluator, Names};
use crate::parameter::Parameter;
use crate::verify::linear::Values;
use point::{Corner, Point};

/// Inputs of an objective other than the loop: the input gain, the box of initial states and the values of names.
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

impl Bounds {
    pub(super) fn new(campaign: &Campaign, values: &Values, gain: &BigRational) -> Self {
        let values = values.iter();
        let mut names: Names =
            values.map(|(name, value)| ((*name).into(), Interval::exact(value))).collect();
        names.entry(Parameter::StartTime.into()).or_insert_with(|| Interval::integer(0));
        let ends = |(low, high): &(f64, f64)| [Range::from(*low), Range::from(*high)];
        let start = campaign.x0.iter().map(ends).map(|[low, high]| low.hull(&high));
        // What f adds stands in a column of its own.
        let start = start.chain([Range::from(1.0)]).collect();
        let mut corners = vec![Vec::new()];
        for mut ends in campaign.x0.iter().map(ends).map(Vec::from) {
            ends.dedup();
            if campaign.spec.n >= MANY {
                ends = vec![ends[0].hull(&ends[ends.len() - 1])];
            }
            let with = |corner: &Vec<_>, end| [&corner[..], &[end]].concat();
            let all = corners.iter().flat_map(|corner| ends.iter().map(|end| with(corner, *end)));
            corners = all.collect();
        }
        corners.iter_mut().for_each(|corner| corner.push(Range::from(1.0)));
        let gain = Range::from(&Interval::exact(gain));
        Self { n: campaign.spec.n, gain, start, corners, names, evaluator: Evaluator::new() }
    }

    /// Succeeds if an objective holds over a cell and `tau`, with a u that is off by at most `rounding`; otherwise
    /// returns the obstacle.
    pub(super) fn holds(
        &mut self,
        closed: &mut Loop,
        aim: &Aim,
        (cell, tau): (&Cell, &[BigRational; 2]),
        rounding: f64,
    ) -> Result<(), Why> {
        let point = self.point(cell, tau);
        let mut value = |form| self.value(closed, form, &point);
        match aim {
            Aim::State { sigma, zeta } => {
                let zeta = value(zeta)?;
                self.state(&point, *sigma, zeta)
            }
            Aim::Input { upsilon } => {
                let most = value(upsilon)?;
                let u = self.of_row(&point, self.n).both_signs() + Range::from(rounding);
                below("|u|", u, most)
            }
            Aim::Attractive { error } => {
                point.corners.iter().try_for_each(|Corner { rows, .. }| {
                    let size = self.greatest(&rows[..self.n]);
                    squares("|x|", size, Range::from(*error).square())
                })
            }
            Aim::AttractiveEach { errors } => {
                errors.iter().enumerate().try_for_each(|(i, error)| {
                    let x = self.of_row(&point, i).both_signs();
                    below(&format!("|x{}|", i + 1), x, Range::from(*error))
                })
            }
            Aim::Within { h, low, high } => {
                let h = value(h)?;
                if let Some(low) = low {
                    below("-h", -h, -value(low)?)?;
                }
                match high {
                    Some(high) => below("h", h, value(high)?),
                    None => Ok(()),
                }
            }
        }
    }

    /// |x| < sigma |x0| zeta: for the x0 of the box, or for all.
    fn state(&self, point: &Point, sigma: f64, zeta: Range) -> Result<(), Why> {
        let bound = Range::from(sigma) * zeta;
        if !zeta.is_positive() {
            return Err(Why::Exceeded("|x|/|x0|".to_owned(), 0.0, bound.low()));
        }
        let mut corners = point.corners.iter();
        corners.try_for_each(|corner| self.state_at(&corner.rows[..self.n], bound))
    }

    fn state_at(&self, rows: &[Vec<Range>], bound: Range) -> Result<(), Why> {
        // What is 0 at t0 is no direction of the box.
        let directions = (0..self.n).filter(|c| self.start[*c] != Range::from(0.0));
        let directions: Vec<_> = directions.chain([self.n]).collect();
        let along = |row: &Vec<Range>| directions.iter().map(|c| row[*c]).collect();
        let of_box: Rows = rows.iter().map(along).collect();
        if is_contraction(&of_box, bound.square()) {
            return Ok(());
        }
        let least: Range = self.start[..self.n].iter().map(|x| x.square()).sum();
        let driven = rows.iter().any(|row| row[self.n] != Range::from(0.0));
        match driven {
            _ if least.is_positive() => squares("|x|", self.greatest(rows), bound.square() * least),
            true => Err(Why::AtRest),
            false => Err(Why::Exceeded("|x|/|x0|".to_owned(), norm_about(&of_box), bound.low())),
        }
    }
}
