//! Values with which an example of a controller runs: what the design fixes, and a default for the
//! rest.

use std::collections::BTreeMap;

use num_traits::ToPrimitive;

use crate::algebra::{BigRational, integer};
use crate::check::examine::{Numbers, Report, decay, example};
use crate::check::{Outcome, Verdict};
use crate::parameter::{Fixed, Parameter, Precision};
use crate::program::number;
use crate::request::{Feedback, Spec};
use crate::request::{Pole, gains};
use crate::syntax::number as fixed;

/// The defaults of a clock in time, in words, one line each.
pub(super) const TIMED: [&str; 6] = [
    "tau = 1 s (100 eps where the design fixes an eps from 0.1 s on), t0 = 0, u_max = 1e30;",
    "a = 1, m = 1, a_i = i, a parameter of an expression 1, and of what has bounds the least;",
    "gains of the poles -(r + 1), ..., -(r + n), r the least integer from n rho on, or n, 2n or 4n",
    "more; eps what brings |x_i| from at most 1 to at most 0.01, else what the sample period asks",
    "for, else tau/100; the sample period that of the design, else tau/1000, or a half, a quarter,",
    "... of it. The longest period is taken that eps bears, and the first of these poles with it.",
];

/// The defaults of a clock in samples.
pub(super) const SAMPLED: [&str; 3] = [
    "N = 1000, h = 1e-3 s, u_max = 1e30, a = 1, eps = 0, deadbeat = 0; gains of the poles -(m + 2),",
    "-(m + 3), ..., -(2 m + 1), m the order of the loop, its delay counted; x1 = 1 at the start, or",
    "less, so that u stays within u_max.",
];

/// The bound of |u| where the design leaves it open: above whatever occurs, and finite in f32.
const UNBOUNDED: &str = "1e30";

/// Bound of |x_i| at the deadline, from which eps is chosen.
const ERROR: &str = "0.01";

/// The parameters, the sample period and the start of an example.
#[derive(Clone, Debug)]
pub(super) struct Example {
    values: BTreeMap<Parameter, Fixed>,
    precision: Precision,
    /// Sample period, s.
    pub(super) period: f64,
    /// True if the run with it is known to arrive.
    pub(super) arrives: bool,
}

impl Example {
    /// The example of a design.
    pub(super) fn of(report: &Report) -> Self {
        let mut spec = report.spec.clone();
        for parameter in spec.parameters() {
            let bound = spec.bounds.get(&parameter).map(|(least, _)| least.clone());
            let value = bound.or_else(|| default(&spec, parameter));
            let value = value.map(|value| match &report.greatest {
                Some((p, greatest)) if *p == parameter && greatest.number() < value.number() => {
                    greatest.clone()
                }
                _ => value,
            });
            if let (false, Some(value)) = (spec.fixed.contains_key(&parameter), value) {
                spec.fixed.insert(parameter, value);
            }
        }
        spec.bounds.clear();
        if spec.sampled().is_some() {
            return Self::in_samples(&spec);
        }
        let tau = spec.fixed.get(&Parameter::Tau).and_then(to_f64).unwrap_or(1.0);
        let (sampled, arrives) = sample(&spec, tau);
        let period = sampled.promises.sample_time.as_ref().and_then(to_f64);
        let period = period.unwrap_or(tau / 1000.0);
        Self { values: with_eps(sampled, tau).fixed, precision: spec.precision, period, arrives }
    }

    /// The same where the clock is in samples; only gains are open.
    fn in_samples(spec: &Spec) -> Self {
        let order = i64::try_from(spec.loop_order()).unwrap_or(1);
        let poles: Vec<_> = (2..=order + 1).map(|i| Pole::real(-integer(order + i))).collect();
        let placed = placed(spec, &poles).unwrap_or_else(|| spec.clone());
        let period = placed.fixed.get(&Parameter::SampleTime).and_then(to_f64);
        let period = period.unwrap_or(1e-3);
        Self { values: placed.fixed, precision: spec.precision, period, arrives: true }
    }

    /// The value of a parameter, in the precision of the controller.
    pub(super) fn value(&self, parameter: Parameter) -> f64 {
        match self.values.get(&parameter).and_then(Fixed::number) {
            Some(exact) => number::round(exact, self.precision),
            None if parameter == Parameter::UMin => f64::NEG_INFINITY,
            None => f64::INFINITY,
        }
    }

    /// The same as a decimal literal.
    pub(super) fn literal(&self, parameter: Parameter) -> String {
        number::literal(self.value(parameter), self.precision)
    }
}

/// The default of a parameter; none for gains and eps, which depend on the others.
fn default(spec: &Spec, parameter: Parameter) -> Option<Fixed> {
    match parameter {
        Parameter::Tau => {
            let eps = spec.fixed.get(&Parameter::Eps).and_then(Fixed::number);
            let long = eps.map(|eps| eps * integer(100)).filter(|tau| *tau >= integer(10));
            long.as_ref().map_or(Some(1.into()), exact)
        }
        Parameter::StartTime => Some(0.into()),
        Parameter::UMax => fixed(UNBOUNDED),
        Parameter::UMin => fixed(UNBOUNDED).map(|most| most.opposite()),
        Parameter::A | Parameter::M | Parameter::Named(_) => Some(1.into()),
        Parameter::Start => fixed("0.1"),
        Parameter::Rate(i) => exact(&integer(i64::try_from(i).unwrap_or(1))),
        Parameter::Samples => Some(1000.into()),
        Parameter::SampleTime => fixed("1e-3"),
        Parameter::Deadbeat => Some(0.into()),
        Parameter::Eps if spec.sampled().is_some() => Some(0.into()),
        Parameter::Eps | Parameter::Gain(_) => None,
    }
}

fn exact(value: &BigRational) -> Option<Fixed> {
    Some(Fixed::Number { value: value.clone(), text: format!("{}", value.to_f64()?) })
}

fn to_f64(value: &Fixed) -> Option<f64> {
    value.number().and_then(ToPrimitive::to_f64)
}

/// Gains of the poles -(r + 1), ..., -(r + n), r the least integer from n rho on and `left` more,
/// where the design leaves them open; `None` if it does not.
fn with_poles(spec: &Spec, left: i64) -> Option<Spec> {
    let n = i64::try_from(spec.n).ok()?;
    // Where no rate is found, that of the common mappings is taken.
    let rate = decay(spec).greatest().unwrap_or_else(|| integer(1));
    let right = (rate * integer(n)).ceil() + integer(left);
    let poles: Vec<_> = (1..=n).map(|i| Pole::real(-(&right + integer(i)))).collect();
    placed(spec, &poles)
}

/// The design with the gains of `poles`; `None` if it does not leave them open.
fn placed(spec: &Spec, poles: &[Pole]) -> Option<Spec> {
    if spec.feedback != Feedback::Linear || spec.fixed.contains_key(&Parameter::Gain(1)) {
        return None;
    }
    let gains = gains(poles).ok()?;
    let mut spec = spec.clone();
    let gains = (1..).zip(&gains).filter_map(|(i, gain)| Some((Parameter::Gain(i), exact(gain)?)));
    spec.fixed.extend(gains);
    Some(spec)
}

/// The design with gains, a sample period and an eps where they are open: the longest period with
/// which the state comes from |x_i| <= 1 to |x_i| <= [`ERROR`] with one of the sets of poles; and whether that is known.
fn sample(spec: &Spec, tau: f64) -> (Spec, bool) {
    let n = i64::try_from(spec.n).unwrap_or(1);
    let placed: Vec<_> = [0, n, 2 * n, 4 * n].iter().filter_map(|l| with_poles(spec, *l)).collect();
    let designs = if placed.is_empty() { vec![spec.clone()] } else { placed };
    let promises = &spec.promises;
    let free = !spec.fixed.contains_key(&Parameter::Eps) && promises.error.is_empty();
    let halves = if promises.sample_time.is_some() { 1 } else { 12 };
    let judged = |h: i32, ends: bool, wanted: &'static [Verdict]| {
        let period = tau / 1000.0 / f64::from(1 << h);
        designs.iter().filter_map(move |design| borne(design, period, ends, wanted))
    };
    let first = |ends, wanted| (0..halves).find_map(|h| judged(h, ends, wanted).next());
    let ended = || if free { first(true, PROVED) } else { None };
    // What no check decides is run.
    let arriving = |design: &Spec| arrives(&with_eps(design.clone(), tau), tau);
    let run = || (0..halves).find_map(|h| judged(h, false, OPEN).find(arriving));
    let known = ended().or_else(|| first(false, PROVED)).or_else(run);
    let arrives = known.is_some();
    let found = known.or_else(|| first(false, OPEN)).or_else(|| designs.first().cloned());
    (found.unwrap_or_else(|| spec.clone()), arrives)
}

/// The design with the eps of an example where no check sets one.
fn with_eps(mut spec: Spec, tau: f64) -> Spec {
    let eps = fixed(&format!("{}", tau / 100.0));
    spec.fixed.entry(Parameter::Eps).or_insert(eps.unwrap_or(Fixed::Infinite));
    spec
}

/// The verdicts of a period that is known to be short enough, and of one that may be.
const PROVED: &[Verdict] = &[Verdict::Sound];
const OPEN: &[Verdict] =
    &[Verdict::Sound, Verdict::Undecided, Verdict::NotChecked, Verdict::NotNeeded];

/// Most steps of a run that is tried: a second or two with the mappings that take longest.
const STEPS: f64 = 16_000.0;

/// The part of the largest state of a run at which a project says that it has arrived.
pub(super) const ARRIVED: f64 = 0.01;

/// Returns true if the run of a project from x1 = 1 arrives, with a linear law and without a bound of u that clips.
fn arrives(spec: &Spec, tau: f64) -> bool {
    if let Some(axes) = &spec.axes {
        return (0..axes.count).all(|axis| arrives(&spec.axis(axis), tau));
    }
    let value = |parameter| spec.fixed.get(&parameter).and_then(to_f64);
    let period = spec.promises.sample_time.as_ref().and_then(to_f64);
    let (Some(period), Some(eps)) = (period, value(Parameter::Eps)) else { return false };
    let unbounded = fixed(UNBOUNDED).as_ref().and_then(to_f64);
    let radius = spec.radius(0).and_then(|limit| limit.to_f64());
    let clips = radius.is_some_and(|limit| Some(limit) < unbounded);
    let steps = (tau / period).round();
    if spec.feedback != Feedback::Linear || clips || steps > STEPS {
        return false;
    }
    let numbers = Numbers::new(spec, None);
    let h = tau / steps;
    let mut x = vec![0.0; spec.n];
    x[0] = 1.0;
    let (mut largest, mut size, mut step) = (1.0_f64, 1.0_f64, 0.0);
    while step < steps {
        let gains = numbers.gains((tau - h * step).max(eps));
        let u: f64 = gains.iter().zip(&x).map(|(gain, x)| gain * x).sum();
        // Exact: x_i is a polynomial in time.
        for i in 0..spec.n {
            let behind = (1..=spec.n - i).rev();
            #[allow(clippy::cast_precision_loss)]
            let moved = behind.fold(u, |sum, k| x[i + k - 1] + h * sum / k as f64);
            x[i] = moved;
        }
        size = x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        largest = largest.max(size);
        step += 1.0;
    }
    size <= ARRIVED * largest
}

/// The design with `period`, where it gives none, if its checks of eps have one of the verdicts
/// `wanted`; with an eps that bounds |x_i| at the deadline, where it `ends`.
fn borne(spec: &Spec, period: f64, ends: bool, wanted: &[Verdict]) -> Option<Spec> {
    let mut spec = spec.clone();
    if spec.promises.sample_time.is_none() {
        spec.promises.sample_time = fixed(&format!("{period}"));
    }
    if ends {
        spec.promises.error = fixed(ERROR).into_iter().collect();
        spec.promises.x0_max = vec![1.into(); spec.n];
    }
    let (spec, sampling, deadline) = example(&spec);
    let good = |outcome: &Outcome| wanted.contains(&outcome.verdict);
    (good(&sampling) && (!ends || good(&deadline))).then_some(spec)
}
