//! Deadlines that keep limits: bounds of u and of states from now to rest, linear in the flat coordinates.
//!
//! Under a law with consecutive integer exponents every signal is a polynomial in the samples to go M ([`Course`]), so
//! its Bernstein coefficients bound it from the first sample to where another law takes over. From there on the time is
//! known, and so are the coefficients, as sums of the coordinates; gains that are held are bounded by the few rows of
//! [`span`]. What all bounds admit is kept at every sample, up to the rounding that `slack` allows for.
//!
//! A table of rows bounds the signals of a loop with a table of gains ([`tabled`]).

mod bernstein;
mod course;
mod slack;
mod span;
mod tabled;
mod values;

use std::sync::Arc;

use num_traits::{ToPrimitive, Zero};

pub(crate) use course::Course;
pub(crate) use tabled::{Plan as TabledPlan, Tabled, node_from};
pub(crate) use values::Peak;

use super::Matrix;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::{BigRational, integer};
use crate::parameter::Precision;
use course::whole;
use span::{Row, Span};

/// Part of a number that is rounding.
const ROUNDED: f64 = 1e-12;

/// A signal of the loop that has limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Signal {
    /// u, less what is added to it in the plant.
    Input,
    /// A state, from 0.
    State(usize),
}

/// A loop in flat coordinates, and the signals that have limits.
pub(crate) struct Plan<'a> {
    /// The coefficients of the coordinates in the difference of the last one.
    pub(crate) drift: &'a [BigRational],
    /// The least exponent of its law.
    pub(crate) least: u32,
    /// The samples to go from which on another law ends it, and the least exponent of that.
    pub(crate) end: Option<(u32, u32)>,
    /// Samples to go at which the gains are held.
    pub(crate) held: BigRational,
    /// The rows that give the states with limits from the coordinates.
    pub(crate) states: Vec<(usize, Vec<BigRational>)>,
}

/// A sum of numbers, each times its factor, whose size is bounded by `share` of the limit of a signal.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bound {
    /// The signal.
    pub(crate) signal: Signal,
    /// The factors.
    pub(crate) row: Vec<BigRational>,
    /// Share of its limits that it may take.
    pub(crate) share: BigRational,
    /// True if every value that it stands for lies between 0 and the sum, so that each is kept by the limit on its side;
    /// otherwise values may have the other sign.
    pub(crate) is_signed: bool,
}

/// Coefficients of a signal from the first sample on, as a polynomial in the part of the way that is left.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Curve {
    /// The signal.
    pub(crate) signal: Signal,
    /// For each power of the part of the way, and of its length in samples, the factors of the w_j.
    pub(crate) powers: Vec<Vec<BigRational>>,
    /// The rows of its Bernstein coefficients, over the powers.
    pub(crate) bernstein: Vec<Vec<BigRational>>,
}

/// Signals to be kept from any M above `above`, under one law.
#[derive(Clone, Debug)]
pub(crate) struct Stretch {
    /// The law.
    pub(crate) course: Course,
    /// The samples to go above which it is this law.
    pub(crate) above: u32,
    /// A_j = w_j (M + s)^(p_j), by z_{i+1} (M + s)^(i).
    pub(crate) amplitudes: Matrix,
    /// The signals down to M = `above` + 1.
    pub(crate) curves: Vec<Curve>,
    /// The signals behind it, by the w_j.
    pub(crate) behind: Vec<Bound>,
}

/// All that is to be kept from now to rest.
#[derive(Clone, Debug)]
pub(crate) struct Horizon {
    /// The laws, the first one first; none of a table.
    pub(crate) stretches: Vec<Stretch>,
    /// The bounds of a loop with a table of gains.
    pub(crate) table: Option<Arc<Tabled>>,
    /// The signals once the gains are held, by the coordinates.
    pub(crate) held: Vec<Bound>,
    /// The part of a limit that roundings may take, in units of the last place of a number.
    pub(crate) slack: f64,
}

impl Horizon {
    /// Returns the bounds of a plan; `None` where the loop of held gains is not stable.
    pub(crate) fn new(plan: &Plan<'_>) -> Option<Self> {
        let order = plan.drift.len();
        let least = BigRational::from_integer(order.into());
        let from = plan.held.clone().max(least);
        let rest = from.floor().to_integer().to_u32()?;
        let end = plan.end.filter(|(samples, _)| *samples > rest);
        let course = |least| Course { least, drift: plan.drift.to_vec() };
        let last = end.map_or(plan.least, |(_, least)| least);
        let held = held_bounds(plan, &course(last), &from)?;
        let mut stretches = vec![Stretch::new(plan, course(last), rest, &held)?];
        if let Some((samples, _)) = end {
            let behind = stretches[0].known(samples)?;
            stretches.insert(0, Stretch::new(plan, course(plan.least), samples, &behind)?);
        }
        let slack = stretches.iter().map(slack::slack).collect::<Option<Vec<_>>>()?;
        let slack = slack.into_iter().fold(0.0, f64::max);
        Some(Self { stretches, table: None, held, slack })
    }

    /// Returns the bounds of a loop with a table of gains; `None` where the loop of held gains is not stable.
    pub(crate) fn tabled(plan: &TabledPlan<'_>) -> Option<Self> {
        let table = Tabled::known(plan)?;
        let (held, slack) = (table.held.clone(), table.slack);
        Some(Self { stretches: Vec::new(), table: Some(table), held, slack })
    }

    /// Samples to go at and below which the gains are held.
    pub(crate) fn rest(&self) -> u32 {
        match &self.table {
            Some(table) => table.rest,
            None => self.stretches.last().map_or(0, |stretch| stretch.above),
        }
    }

    /// Factor by which a bound may grow on the way to rest, at least 1.
    pub(crate) fn growth(&self) -> f64 {
        self.table.as_ref().map_or(1.0, |table| table.growth)
    }

    /// Returns true if a state has a limit.
    pub(crate) fn bounds_states(&self) -> bool {
        let curves = self.stretches.iter().flat_map(|stretch| &stretch.curves);
        let rows = self.table.iter().flat_map(|table| &table.signals);
        let mut signals = curves.map(|own| own.signal).chain(rows.map(|own| own.signal));
        signals.any(|signal| signal != Signal::Input)
    }

    /// Most samples to a deadline that is planned: beyond, numbers leave the range of the precision.
    pub(crate) fn longest(&self, precision: Precision) -> u32 {
        const MOST: u32 = 1 << 30;
        if let Some(table) = &self.table {
            return table.longest;
        }
        let exponents = self.stretches.iter().map(|stretch| {
            let course = &stretch.course;
            course.exponent(course.order() - 1)
        });
        let exponent = exponents.max().unwrap_or(1);
        let digits = match precision {
            Precision::F64 => 290.0,
            Precision::F32 => 30.0,
        };
        let samples = 10f64.powf(digits / f64::from(exponent));
        // Single precision holds whole numbers to 2^24.
        let exact = if precision == Precision::F32 { 1 << 24 } else { MOST };
        if samples < f64::from(exact) { samples.floor().to_u32().unwrap_or(exact) } else { exact }
    }
}

impl Stretch {
    fn new(plan: &Plan<'_>, course: Course, above: u32, behind: &[Bound]) -> Option<Self> {
        let curve = |signal: Signal, polynomials: &[Polynomial]| {
            let powers = bernstein::from(polynomials, above + 1);
            Curve { signal, bernstein: bernstein::rows(powers.len() - 1), powers }
        };
        let mut curves = vec![curve(Signal::Input, &course.input())];
        for (i, row) in &plan.states {
            curves.push(curve(Signal::State(*i), &course.signal(row)));
        }
        let state = course.state(above);
        let behind = behind
            .iter()
            .map(|bound| Bound { row: state.after_row(&bound.row), ..bound.clone() })
            .collect();
        Some(Self { amplitudes: course.amplitudes()?, above, curves, behind, course })
    }

    /// The bounds from M = `left` on, which is known, by the coordinates.
    fn known(&self, left: u32) -> Option<Vec<Bound>> {
        let weights = self.course.weights(left)?;
        let length = whole(left - self.above - 1);
        let mut all = Vec::new();
        for curve in &self.curves {
            let mut scale = integer(1);
            let mut scaled = Vec::with_capacity(curve.powers.len());
            for factors in &curve.powers {
                scaled.push(factors.iter().map(|factor| factor * &scale).collect::<Vec<_>>());
                scale *= &length;
            }
            for row in &curve.bernstein {
                let sum = |j: usize| {
                    row.iter().zip(&scaled).map(|(own, power)| own * &power[j]).sum::<BigRational>()
                };
                let of_weights: Vec<_> = (0..self.course.order()).map(sum).collect();
                let row = weights.after_row(&of_weights);
                all.push(Bound { signal: curve.signal, row, share: integer(1), is_signed: true });
            }
        }
        all.extend(self.behind.iter().map(|bound| {
            let row = weights.after_row(&bound.row);
            Bound { row, ..bound.clone() }
        }));
        Some(all)
    }
}

/// The bounds of the signals while the gains of a law are held, which they are from M = `from` on.
fn held_bounds(plan: &Plan<'_>, course: &Course, from: &BigRational) -> Option<Vec<Bound>> {
    let order = course.order();
    let gains: Vec<BigRational> = gains(course, from)?;
    let number = |value: &BigRational| value.to_f64();
    let row = |all: &[BigRational]| all.iter().map(number).collect::<Option<Row>>();
    let own = row(&gains)?;
    let mut phi: Vec<Row> = (0..order)
        .map(|i| (0..order).map(|j| f64::from(u8::from(j == i || j == i + 1))).collect())
        .collect();
    for (j, entry) in phi[order - 1].iter_mut().enumerate() {
        *entry += plan.drift[j].to_f64()? + own[j];
    }
    let mut spans = vec![(Signal::Input, own)];
    for (i, own) in &plan.states {
        spans.push((Signal::State(*i), row(own)?));
    }
    let mut all = Vec::new();
    for (signal, own) in spans {
        let span = Span::new(&own, &phi, from.to_f64()?)?;
        // A share that only rounding takes from 1 is 1.
        let share = if span.share < 1.0 + ROUNDED { 1.0 } else { span.share };
        let share = BigRational::from_float(share.recip())?;
        for row in span.rows {
            let row = row.into_iter().map(BigRational::from_float).collect::<Option<Vec<_>>>()?;
            all.push(Bound { signal, row, share: share.clone(), is_signed: span.is_signed });
        }
    }
    Some(all)
}

/// The gains of a law with `left` samples to go, which may be no whole number, of the coordinates.
fn gains(course: &Course, left: &BigRational) -> Option<Vec<BigRational>> {
    // u = sum_j of what each w_j adds, at the w_j of the coordinates.
    let amplitudes = course.amplitudes()?;
    let input = course.input();
    let by_weight: Vec<_> = input
        .iter()
        .enumerate()
        .map(|(j, own)| own.at(left) / course.power(left, course.exponent(j)))
        .collect();
    let by_scaled = amplitudes.after_row(&by_weight);
    let scaled = by_scaled.iter().enumerate();
    let gains: Vec<_> =
        scaled.map(|(i, own)| own * course.power(left, u32::try_from(i).unwrap_or(0))).collect();
    gains.iter().any(|gain| !gain.is_zero()).then_some(gains)
}

#[cfg(test)]
mod tests;
