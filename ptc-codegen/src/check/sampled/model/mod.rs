//! The worst case of a model that is not linear, whose f and g the law knows at the samples alone.
//!
//! Behind sample k the last rate of the chain is w_k + e(t), e(t) = (f + g u_k)(t) - (f + g u_k)(t_k): the
//! loop is that of a chain with an unknown force e. On the envelope |e| <= h max |d(f + g u)/dt|, with |u| at
//! most what |w|, f and g allow, and |w| and the chain within the bounds of the loop under such a force. A force that
//! is consistent with itself bounds the loop, by induction over time, as long as the states stay within the
//! envelope; they do where no state on its faces has a chain within the bounds that follow.

mod beside;
mod cell;
mod faces;
mod rates;

use num_traits::Zero;

use super::cells::Worst;
use super::followed::Followed;
use super::judge::Loop;
use super::outcome::{NAME, UNKNOWN, followed, split};
use crate::algebra::BigRational;
use crate::check::{Outcome, Verdict, list};
use crate::diagnostic::digits;
use crate::internal::fault;
use crate::model::Model;
use crate::parameter::{Fixed, Parameter};
use crate::program::number::round;
use crate::request::{After, Clock, PlantBounds, Promises, Reference, Spec, one_or_each};
use beside::Beside;
pub(super) use cell::divided;
use rates::{Rates, Sizes};

/// Rounds in which a force is widened until it is consistent with itself.
const ROUNDS: u32 = 10;

/// A force from which on none is consistent with itself.
const FAR: f64 = 1e100;

/// By how much more than needed, as a part of it.
const WIDER: f64 = 0.02;

/// The check of a design with such a model.
pub(super) fn outcome(spec: &Spec, model: &Model) -> Outcome {
    let found = Envelope::new(spec, model).and_then(|envelope| {
        let found = envelope.bounded(After::Zero, 0.0)?;
        let afterwards = envelope.afterwards(found.force);
        Ok((found, afterwards))
    });
    match found {
        Ok((found, afterwards)) => judged(spec, model, &found, afterwards.as_ref()),
        Err(Lacking::Value(reason)) => Outcome::not_checked(NAME, reason),
        Err(Lacking::Proof(reason)) => {
            Outcome { verdict: Verdict::Undecided, ..Outcome::not_checked(NAME, reason) }
        }
    }
}

/// Why there are no bounds: a value that is not given, or what is not shown.
enum Lacking {
    Value(String),
    Proof(String),
}

/// The bounds of a loop.
struct Bounded {
    /// Of the chain that w moves.
    worst: Worst,
    sizes: Sizes,
    /// Of e, errors of sensors, actuator and g, and rounding: the force.
    force: f64,
}

/// Of |x_i| and |u| from the deadline on.
type Afterwards = (Vec<f64>, f64);

/// What bounds the force on the envelope.
struct Envelope<'a> {
    spec: &'a Spec,
    model: &'a Model,
    rates: Rates<'a>,
    /// What is measured of the chain may be off by.
    sensors: Vec<f64>,
    followed: Option<Beside>,
}

impl<'a> Envelope<'a> {
    fn new(spec: &'a Spec, model: &'a Model) -> Result<Self, Lacking> {
        let promises = &spec.promises;
        let lacks =
            |key: &str, why: &str| Err(Lacking::Value(format!("`{key}` is not given{why}")));
        if promises.sample_time.is_none() {
            return lacks("sample_time", "");
        }
        if promises.x0_max.is_empty() {
            return lacks("x0_max", "");
        }
        if promises.x_max.is_empty() {
            return lacks("x_max", ", within which the rate of f + g u is bounded");
        }
        if promises.jitter.is_some() {
            let why = "what jitter leaves of a model that is not linear is not examined";
            return Err(Lacking::Proof(why.to_owned()));
        }
        if promises.plant.is_some() {
            let why = "the plant of [plant] may differ from the model, and what that leaves is not examined";
            return Err(Lacking::Proof(why.to_owned()));
        }
        if spec.reference == Some(Reference::Input) {
            return Err(Lacking::Proof(UNKNOWN.to_owned()));
        }
        let own = spec.sampled().unwrap_or_else(|| fault("a model in samples without samples"));
        let followed = Followed::new(spec, own).map_err(Lacking::Proof)?;
        let rates = Rates::new(spec, model).map_err(Lacking::Proof)?;
        let mut sensors = rates.sensors().map_err(Lacking::Proof)?;
        let followed = followed.map(|followed| Beside::new(spec, &followed));
        if let Some(beside) = &followed {
            sensors.iter_mut().zip(&beside.off).for_each(|(sensor, off)| *sensor += off);
        }
        Ok(Self { spec, model, rates, sensors, followed })
    }

    /// The bounds under a force that is consistent with itself, `from` or a larger one: to the deadline, or for
    /// as long as the law goes on.
    fn bounded(&self, after: After, from: f64) -> Result<Bounded, Lacking> {
        let mut force = from;
        for _ in 0..ROUNDS {
            let chain = Spec { after, ..chain(self.spec, &self.sensors, force) };
            let closed = Loop::new(&chain, None).map_err(Lacking::Value)?;
            let worst = closed.worst(true).map_err(Lacking::Proof)?;
            let (wanted, x) = reached(&worst, after).map_err(Lacking::Proof)?;
            let (wanted, x) = match &self.followed {
                Some(beside) => beside.of_plant(wanted, &x),
                None => (wanted, x),
            };
            let mut sizes = self.rates.sizes(wanted, &x).map_err(Lacking::Proof)?;
            if let Some(beside) = &self.followed {
                sizes.force += beside.force(wanted);
            }
            if sizes.force <= force {
                faces::stays(self.spec, self.model, &x).map_err(Lacking::Proof)?;
                return Ok(Bounded { worst, sizes, force });
            }
            force = (1.0 + WIDER) * sizes.force;
            if force > FAR {
                break;
            }
        }
        Err(Lacking::Proof(
            "what f + g u may change by between samples grows with the u that it takes: a shorter sample_time, or closer x_max and x0_max, may bound it".to_owned(),
        ))
    }

    /// What holds from the deadline on, where it is known; of a reference what it does before the deadline
    /// alone is.
    fn afterwards(&self, from: f64) -> Option<Afterwards> {
        if self.spec.after != After::Hold || self.spec.reference.is_some() {
            return None;
        }
        let after = self.bounded(After::Hold, from).ok()?.worst.after?;
        let u = self.rates.sizes(after.u, &after.x).ok()?.u;
        Some((after.x, u))
    }
}

/// Bounds of w and of the chain, to the deadline or for as long as the law goes on, between the samples too.
fn reached(worst: &Worst, after: After) -> Result<(f64, Vec<f64>), String> {
    let way = worst.way.as_ref().filter(|way| way.between);
    let way = way.ok_or("there are too many samples to bound the way to the deadline")?;
    if after != After::Hold {
        return Ok((way.u, way.x.clone()));
    }
    let after = worst.after.as_ref().filter(|after| after.between);
    let after = after.ok_or("no bounds are known to hold for ever")?;
    let both = way.x.iter().zip(&after.x);
    Ok((way.u.max(after.u), both.map(|(a, b)| a.max(*b)).collect()))
}

/// The chain that w moves, under a force that is any signal within a bound.
fn chain(spec: &Spec, sensors: &[f64], force: f64) -> Spec {
    // Bounds that are not finite are refused where they arise.
    let exact = |value: f64| {
        BigRational::from_float(value).unwrap_or_else(|| fault("a bound that is not finite"))
    };
    let fixed = |value: f64| Fixed::Number { value: exact(value), text: value.to_string() };
    let zero = BigRational::zero;
    let mut chain = Spec {
        model: None,
        drift: None,
        input_gain: None,
        reference: None,
        promises: Promises {
            noise: sensors.iter().copied().map(fixed).collect(),
            noise_rms: Vec::new(),
            sensor_step: Vec::new(),
            u_step: None,
            g_error: Vec::new(),
            x_max: Vec::new(),
            plant: (force > 0.0).then(|| PlantBounds::Bounded {
                middle: zero(),
                constant: zero(),
                varying: exact(force),
                gain: None,
            }),
            ..spec.promises.clone()
        },
        ..spec.clone()
    };
    // u is clipped, not w.
    chain.fixed.insert(Parameter::UMax, Fixed::Infinite);
    if let Clock::Samples(sampled) = &mut chain.clock {
        sampled.measured = spec.n;
    }
    chain
}

fn judged(spec: &Spec, model: &Model, found: &Bounded, afterwards: Option<&Afterwards>) -> Outcome {
    let Bounded { worst, sizes, force } = found;
    let totals: Vec<_> = worst.states.iter().map(|bound| bound.total()).collect();
    let errors = &spec.promises.error;
    let error = |i: usize| one_or_each(errors, i).unwrap_or(f64::INFINITY);
    let above = (0..spec.n).find(|i| totals[*i] > error(*i));
    let limit = spec.fixed.get(&Parameter::UMax).and_then(Fixed::number);
    let limit = limit.map(|limit| round(limit, spec.precision));
    let clipped = limit.is_some_and(|limit| sizes.u >= limit);
    let all = format!("at the deadline |x| <= {}", list(totals.iter().copied()));
    let (verdict, summary) = match above {
        _ if errors.is_empty() => (Verdict::NotChecked, format!("`error` is not given: {all}")),
        _ if clipped => (
            Verdict::Undecided,
            format!("|u| is only known to be below {}, above u_max", digits(sizes.u)),
        ),
        Some(i) => (
            Verdict::Undecided,
            format!("{all}, above error = {} for x{}", digits(error(i)), i + 1),
        ),
        None => (Verdict::Sound, all),
    };
    let n = spec.n;
    let mut details = vec![
        format!(
            "the model over {} samples, from states within x_max whose chain is within x0_max, at any tick",
            worst.samples
        ),
        format!(
            "between samples {} is within {} of what it was at the sample, which leaves an error of order h^({}-i) in x_i",
            if spec.reference.is_some() { "f + g u - r^(n)" } else { "f + g u" },
            digits(*force),
            n + 2
        ),
    ];
    details.extend(followed(spec));
    if !spec.fixed.contains_key(&Parameter::UMax) {
        details.push("without a limit of u, which is left to run time".to_owned());
    }
    details.extend((0..n).map(|i| split(spec, worst, i)));
    if let Some(way) = &worst.way {
        let x = list(way.x.iter().copied());
        let states = model.states.iter().map(|state| state.text()).collect::<Vec<_>>().join(", ");
        details.push(format!(
            "on the way, between samples too, |x| <= {x}, |{}| <= {}, and {states} stay within x_max",
            model.input,
            digits(sizes.u)
        ));
    }
    if let Some((x, u)) =
        afterwards.filter(|(_, u)| !clipped && limit.is_none_or(|limit| *u < limit))
    {
        let x = list(x.iter().copied());
        details.push(format!(
            "from the deadline on |x| <= {x}, |{}| <= {}",
            model.input,
            digits(*u)
        ));
    }
    Outcome { name: NAME, verdict, summary, details, fix: None }
}
