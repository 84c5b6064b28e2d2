//! Whether an objective holds over a cell of T/tau and one of tau.

use std::ops::Add;

use super::Campaign;
use super::aim::Aim;
use super::cell::{Cell, Loop, half_of};
use super::flow::{Rows, dot};
use super::form::{Form, Linear, Part};
use super::norm::{is_contraction, norm_about};
use super::reason::{Why, below, squares, unknown};
use crate::algebra::{BigRational, integer};
use crate::expression::enclosure::{Interval, Range};
use crate::expression::evaluator::{Evaluator, Names};
use crate::expression::{Expression, Variable};
use crate::parameter::Parameter;
use crate::verify::linear::Values;

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

/// Part of the largest term of a sum below which the others are bounded apart from it.
const FEW: f64 = 1.0 / 128.0;

/// Order from which on the corners of a box are too many.
const MANY: usize = 9;

/// The end of a cell of T/tau to which a step of time leads: 0 for the least.
fn end_of(moved: Range) -> usize {
    usize::from(!moved.is_positive())
}

/// x and u over a cell of T/tau and one of tau, in the units of the plant.
///
/// To first order in T/tau and tau x and u move between those of the corners of both cells, of which
/// each holds the rest of second order. What is convex in them, as a norm or a sum is, is greatest at
/// one of the corners.
struct Point {
    corners: Vec<Corner>,
    names: Names,
    share: [BigRational; 2],
    /// tau, and its middle.
    tau: [Range; 2],
}

/// One of the corners of a cell of T/tau and one of tau.
struct Corner {
    /// x_1..x_n and u, each by its slope along x_1..x_n at t0, and what f adds.
    rows: Rows,
    /// 0 at the least T/tau, 1 at the greatest.
    end: usize,
}

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

    /// What stands in the way of an objective over a cell and `tau`, with a u that is off by at most
    /// `rounding`; it holds on all of both where nothing does.
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

    fn point(&self, cell: &Cell, tau: &[BigRational; 2]) -> Point {
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

    /// What x_1..x_n are within over a cell of T/tau and one of tau, and about in the middle of both;
    /// none where they are not bounded.
    pub(super) fn states(&self, cell: &Cell, tau: &[BigRational; 2]) -> Option<[Vec<[f64; 2]>; 2]> {
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

    /// What row i of a point is over the box of initial states.
    fn of_row(&self, point: &Point, i: usize) -> Range {
        let values = point.corners.iter().map(|corner| self.along(&corner.rows[i]));
        values.reduce(|a, b| a.hull(&b)).unwrap_or(Range::WHOLE)
    }

    /// What a row is over the box of initial states.
    fn along(&self, row: &[Range]) -> Range {
        dot(row, &self.start)
    }

    /// The greatest |x|^2 over the box.
    fn greatest(&self, rows: &[Vec<Range>]) -> Range {
        let size =
            |corner: &Vec<Range>| rows.iter().map(|row| dot(row, corner).square()).sum::<Range>();
        let sizes = self.corners.iter().map(size);
        sizes.reduce(|a, b| a.most(&b)).unwrap_or(Range::WHOLE)
    }

    /// The values of an expression that certainly has one for all of a point's.
    fn value(&mut self, closed: &mut Loop, form: &Form, point: &Point) -> Result<Range, Why> {
        let mut of_part = |part: &Part| self.part(closed, part, point);
        for (part, condition, spelt) in &form.needs {
            if !condition.is_certain(&of_part(part)?) {
                return Err(Why::MayNotExist(spelt.clone()));
            }
        }
        let sign = |kink: Interval| match () {
            () if kink.is_positive() => Some(true),
            () if kink.is_negative() => Some(false),
            () => None,
        };
        let signs = form.kinks.iter().map(|kink| of_part(kink).ok().and_then(sign));
        let decided = form.decided(signs.collect());
        let value = of_part(&form.value);
        let value = match decided.map(|part| of_part(&part)) {
            Some(Ok(decided)) => value.map_or(decided.clone(), |value| value.common(&decided)),
            _ => value?,
        };
        let value = Range::from(&value);
        if value.is_bounded() { Ok(value) } else { Err(unknown(&form.value)) }
    }

    /// What holds the values of a part wherever they exist.
    fn part(&mut self, closed: &mut Loop, part: &Part, point: &Point) -> Result<Interval, Why> {
        let mut names = point.names.clone();
        for (k, linear) in part.linear.iter().enumerate() {
            let values = self.linear(closed, linear, point).ok_or_else(|| unknown(part))?;
            names.insert(Variable::Xi(k).into(), values.into());
        }
        let mut value = |e: &Expression| Some(self.evaluator.again().value(e, &names)?.interval);
        match (value(&part.normal), value(&part.given)) {
            (Some(normal), Some(given)) => Ok(normal.common(&given)),
            (Some(one), None) | (None, Some(one)) => Ok(one),
            (None, None) => Err(unknown(part)),
        }
    }

    /// A sum along which states and control move together.
    fn linear(&mut self, closed: &mut Loop, linear: &Linear, point: &Point) -> Option<Range> {
        let mut number =
            |e| Some(Range::from(&self.evaluator.again().value(e, &point.names)?.interval));
        let slopes =
            linear.slopes.iter().map(|(variable, slope)| Some((*variable, number(slope)?)));
        let slopes = slopes.collect::<Option<Vec<_>>>()?;
        let rest = number(&linear.rest)?;
        let added = self.added(closed, &slopes, point);
        let of_corner = |Corner { rows, end }: &Corner| {
            let mut row = vec![Range::from(0.0); self.n + 1];
            for (variable, slope) in &slopes {
                let own = match variable {
                    Variable::State(j) => &rows[j - 1],
                    Variable::Control => &rows[self.n],
                    Variable::StateAtStart(j) => {
                        row[j - 1] = row[j - 1] + *slope;
                        continue;
                    }
                    _ => return None,
                };
                row.iter_mut().zip(own).for_each(|(sum, x)| *sum = *sum + *slope * *x);
            }
            if let Some(added) = added {
                row[self.n] = row[self.n].common(&added[*end]);
            }
            Some(self.along(&row))
        };
        let values = point.corners.iter().map(of_corner).collect::<Option<Vec<_>>>()?;
        Some(rest + values.into_iter().reduce(|a, b| a.hull(&b))?)
    }

    /// What f adds at both ends of a cell to a sum of several of x_1..x_n and u, taken as one: with
    /// factors c_r about in the middle, where tau = 1, it adds what it does to sum c_r x_r, and to each
    /// x_r as much as its factor is beside c_r.
    fn added(
        &self,
        closed: &mut Loop,
        slopes: &[(Variable, Range)],
        point: &Point,
    ) -> Option<[Range; 2]> {
        let mut factors = vec![[Range::from(0.0); 2]; self.n + 1];
        for (variable, slope) in slopes {
            let (r, slope) = match variable {
                Variable::State(j) => (j - 1, *slope),
                Variable::Control => (self.n, *slope / self.gain),
                _ => continue,
            };
            let power = i32::try_from(self.n - r).ok()?;
            let [whole, middle] = point.tau.map(|tau| slope * tau.whole_power(power));
            factors[r] = [Range::from(middle.middle()), whole];
        }
        let zero = Range::from(0.0);
        let moved =
            factors.iter().filter(|[about, whole]| *about != zero || *whole != zero).count();
        let middles: Vec<_> = factors.iter().map(|[about, _]| *about).collect();
        let cell = closed.cell(&point.share)??;
        let each = cell.added.as_ref().filter(|_| moved > 1)?;
        // Next to the largest of them the others may add nothing that counts.
        let parts = factors
            .iter()
            .enumerate()
            .map(|(r, [_, whole])| (*whole * each[0][r].hull(&each[1][r])).size().high());
        let parts: Vec<_> = parts.collect();
        let most = parts.iter().copied().fold(0.0, f64::max);
        (parts.iter().sum::<f64>() > (1.0 + FEW) * most).then_some(())?;
        let sum = closed.of_sum(&point.share, &middles)?;
        let of_end = |end: usize| {
            let beside =
                |(r, [about, whole]): (usize, &[Range; 2])| (*whole - *about) * each[end][r];
            factors.iter().enumerate().map(beside).fold(sum[end], Range::add)
        };
        Some([0, 1].map(of_end))
    }

    /// |x| < sigma |x0| zeta: for the x0 of the box, or for all.
    fn state(&self, point: &Point, sigma: f64, zeta: Range) -> Result<(), Why> {
        let bound = Range::from(sigma) * zeta;
        if !zeta.is_positive() {
            return Err(Why::Exceeded("|x|/|x0|", 0.0, bound.low()));
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
            false => Err(Why::Exceeded("|x|/|x0|", norm_about(&of_box), bound.low())),
        }
    }
}
