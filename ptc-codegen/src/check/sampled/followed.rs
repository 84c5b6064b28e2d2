//! Effect of a reference on the loop of a controller in samples: bounds of its derivatives over a run.
//!
//! In e_i = x_i - r^(i-1), and with inputs that count less rho, the loop is that of the law without a reference,
//! moved beside it by r^(n) - rho alone. With c the middle of the time in which an input acts, at which rho is
//! r^(n), that is r^(n+1)(c) (t - c) + rest, |rest| <= (t - c)^2/2 max |r^(n+2)|. Of a linear plant its states on the
//! reference are in place of r, ..., r^(n-1), and its input there of r^(n).

use num_traits::{ToPrimitive, Zero};

use super::chain::{Near, centre};
use super::judge::exact;
use super::model::divided;
use super::rounded::{ROUNDED, Rounded, StagedValues, unit_roundoff};
use crate::algebra::BigRational;
use crate::expression::enclosure::{Interval, Range};
use crate::lower::{plant, reference_at_sample};
use crate::parameter::Parameter;
use crate::program::{Input, Program, Stage, passes};
use crate::request::{Reference, Sampled, Spec, derivatives};

/// Cells into which the time of a run is divided.
const CELLS: usize = 100;

/// Samples up to which r^(n+1) is computed for each.
const KNOWN: usize = 20_000;

/// Roundings of the time of a call: of a count as a number, of h, and of their product, and more.
const OF_TIME: f64 = 4.0;

/// Bounds over a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Followed {
    /// Bounds of |r|, |r'|, ..., and of |rho|, or what replaces them, with the error of each as the program computes
    /// it.
    pub(super) numbers: Vec<Near>,
    /// Bound of |r^(n+1)|, where r^(n) - rho is proportional to it by the distance from the middle of a sample.
    pub(super) slope: f64,
    /// r^(n+1) and r^(n+2) in the middle of each sample until the deadline; empty where they are not known, or samples are
    /// many.
    pub(super) known: Vec<[Near; 2]>,
    /// Bound of |r^(n+2)|, and of the remainder of |r^(n) - rho| after both terms.
    pub(super) curve: f64,
    pub(super) left: f64,
    /// Bound of the remainder of |r^(n) - rho| after the term of r^(n+1).
    pub(super) rest: f64,
    /// Bound of all of |r^(n) - rho|.
    pub(super) most: f64,
}

impl Followed {
    /// The reference of a design whose numbers are known; `None` without one. One that each call is given counts
    /// as one whose r^(n) is constant over each sample, and as 0 where it rounds.
    ///
    /// # Errors
    /// Why it has no bounds.
    pub(super) fn new(spec: &Spec, own: &Sampled) -> Result<Option<Self>, String> {
        let n = spec.n;
        let jitter = exact(spec.promises.jitter.as_ref()).is_some_and(|jitter| !jitter.is_zero());
        if spec.reference.is_some() && jitter {
            return Err("what jitter leaves of a reference is not examined".to_owned());
        }
        if own.follows.is_some() && own.observes() {
            return Err("what an observer of a linear plant makes of a reference is not examined"
                .to_owned());
        }
        let given = match &spec.reference {
            None => return Ok(None),
            Some(Reference::Known(all)) => &all[0],
            Some(Reference::Input) if own.follows.is_some() => {
                return Err("what a reference that each call is given leaves of a linear plant is not examined".to_owned());
            }
            Some(Reference::Input) => {
                let numbers = vec![(0.0, 0.0); n + 1];
                return Ok(Some(Self { numbers, ..Self::default() }));
            }
        };
        let known = |value| exact(value).ok_or("tau or the sample period is left to run time");
        let h = known(spec.promises.sample_time.as_ref())?;
        let tau = known(spec.fixed.get(&Parameter::Tau))?;
        let lacks = |order: usize| {
            format!("no bound of derivative {order} of the reference is found over the run")
        };
        let all = derivatives(given, n + 2).map_err(lacks)?;
        // Until the last input before the deadline has acted.
        let samples = (&tau / &h).round().to_usize().filter(|samples| *samples <= KNOWN);
        let late = BigRational::from_integer((own.delay.inputs() + 2).into()) * &h;
        let period = Range::from(&Interval::exact(&h));
        let [h, end] = [h, tau + late].map(|time| Range::from(&Interval::exact(&time)).high());
        let cells = divided(Range::from(0.0).hull(&Range::from(end)), CELLS);
        let values = over(spec, reference_at_sample(spec, own), &cells).map_err(lacks)?;
        // Behind the derivatives up to n - 1 is that of order n for each input.
        let (below, rates) = values.split_at(n);
        let most = |a: Near, b: Near| (a.0.max(b.0), a.1.max(b.1));
        let rate = rates.iter().copied().fold((0.0, 0.0), most);
        let last = |rates: usize| own.followed(&all[rates..=rates + n]).pop();
        let further: Vec<_> = [1, 2].into_iter().filter_map(last).collect();
        let program = plant(spec, &further);
        let middles: Vec<_> = (0..samples.unwrap_or(0)).map(|k| middle_of(k) * period).collect();
        let at_middles = values_of(spec, program.clone(), &middles).unwrap_or_default();
        let known =
            at_middles.iter().map(|own| [0, 1].map(|order: usize| centre(own[order].exact, 0.0)));
        // What is left of both is that of one order more, where that has a bound.
        let third = derivatives(given, n + 3).ok();
        let third = third.map(|all| own.followed(&all[3..=n + 3]).pop().into_iter().collect());
        let third = third.and_then(|last: Vec<_>| over(spec, plant(spec, &last), &cells).ok());
        let third = third.and_then(|all| all.first().copied());
        let known: Vec<_> = if third.is_some() { known.collect() } else { Vec::new() };
        let further = over(spec, program, &cells);
        let further = further.map_err(|order| lacks(n + 1 + order.min(1)))?;
        let [slope, curve] = [0, 1].map(|order: usize| further[order].0);
        let most = 0.5 * h * slope * ROUNDED;
        let (slope, known, rest) = match own.delay.is_whole() {
            true => (slope, known, 0.125 * h * h * curve * ROUNDED),
            // Two inputs act in a sample, the older one from before the start on: any signal.
            false => (0.0, Vec::new(), most),
        };
        let left = third.map_or(0.0, |(third, _)| h * h * h * third / 48.0 * ROUNDED);
        let numbers = below.iter().copied().chain([rate]).collect();
        Ok(Some(Self { numbers, slope, known, curve, left, rest, most }))
    }

    /// Bound of |r^(order)|, and of |rho| for n.
    pub(super) fn size(&self, order: usize) -> f64 {
        self.numbers[order].0
    }

    /// Bound of the size of what the kept estimate of x_j is in e: the prediction without an error ends at 0.
    /// `shares` are h^m/m!.
    pub(super) fn of_estimate(&self, j: usize, shares: &[f64]) -> f64 {
        let terms =
            (j - 1..self.numbers.len()).map(|order| shares[order + 1 - j] * self.size(order));
        terms.sum::<f64>() * ROUNDED
    }
}

/// The middle of sample k, in periods.
fn middle_of(k: usize) -> Range {
    #[allow(clippy::cast_precision_loss)]
    Range::from(k as f64 + 0.5)
}

/// Bounds of the values that a program watches over cells of time, and of what rounding does to them.
///
/// # Errors
/// The first that has none.
fn over(spec: &Spec, program: Program, cells: &[Range]) -> Result<Vec<Near>, usize> {
    let all = values_of(spec, program, cells)?;
    let most = |(value, error): Near, own: &Rounded| {
        (value.max(own.exact.size().high()), error.max(own.error))
    };
    let count = all.first().map_or(0, Vec::len);
    Ok((0..count).map(|i| all.iter().map(|cell| &cell[i]).fold((0.0, 0.0), most)).collect())
}

/// The values that a program watches over each of some cells of time.
///
/// # Errors
/// The first that has none.
fn values_of(spec: &Spec, program: Program, cells: &[Range]) -> Result<Vec<Vec<Rounded>>, usize> {
    let program = passes::optimise(program, &mut |_, _| {});
    let mut values = StagedValues::new(&program, &program.watched).ok_or(0_usize)?;
    let nothing = Rounded::of(Range::from(0.0));
    let early = |input: Input| match input {
        Input::Parameter(asked) => {
            Some(Rounded::number(spec.fixed.get(&asked)?.number()?, spec.precision))
        }
        // Time counts from the start.
        Input::StartTime => Some(nothing),
        _ => None,
    };
    for stage in [Stage::Generation, Stage::Init, Stage::Arm] {
        values.run(stage, &early);
    }
    let unit = OF_TIME * unit_roundoff(spec.precision);
    let mut found = Vec::with_capacity(cells.len());
    for cell in cells {
        let time = Rounded { exact: *cell, error: (unit * cell.high()).next_up() };
        values.run(Stage::Tick, &|input| match input {
            Input::Time => Some(time),
            other => early(other),
        });
        let watched = program.watched.iter().enumerate();
        let all = watched.map(|(order, value)| values.get(*value).ok_or(order));
        found.push(all.collect::<Result<Vec<_>, _>>()?);
    }
    Ok(found)
}
