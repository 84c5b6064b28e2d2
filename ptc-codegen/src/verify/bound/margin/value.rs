//! The values of an expression over a point, where it certainly has some.

use std::ops::Add;

use super::super::cell::Loop;
use super::super::form::{Form, Linear, Part};
use super::super::reason::{Why, unknown};
use super::Bounds;
use super::point::{Corner, Point};
use crate::expression::enclosure::{Interval, Range};
use crate::expression::{Expression, Variable};

/// Part of the largest term of a sum below which the others are bounded apart from it.
const FEW: f64 = 1.0 / 128.0;

impl Bounds {
    /// The values of an expression that certainly has one for all of a point's.
    pub(super) fn value(
        &mut self,
        closed: &mut Loop,
        form: &Form,
        point: &Point,
    ) -> Result<Range, Why> {
        let mut of_part = |part: &Part| self.part(closed, part, point);
        for (part, condition, spelt) in &form.needs {
            if !condition.is_certain(&of_part(part)?) {
                return Err(Why::MayNotExist(spelt.clone()));
            }
        }
        let sign = |kink: Interval| {
            if kink.is_positive() {
                Some(true)
            } else if kink.is_negative() {
                Some(false)
            } else {
                None
            }
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

    /// Encloses the values of a part wherever they exist.
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

    /// Returns the contribution of f at both ends of a cell to a sum of several of x_1..x_n and u, taken as one: with
    /// factors c_r about in the middle, where tau = 1, it adds its contribution to sum c_r x_r, and to each x_r as much
    /// as its factor is beside c_r.
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
}
