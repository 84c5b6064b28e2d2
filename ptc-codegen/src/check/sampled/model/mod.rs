//! The worst case of models that are not linear, or have several inputs, whose f and g the law knows at the samples
//! alone.
//!
//! Behind sample k the last rate of the chain is w_k + e(t), e(t) = (f + g u_k)(t) - (f + g u_k)(t_k): the
//! loop is that of a chain with an unknown force e. On the envelope |e| <= h max |d(f + g u)/dt|, with |u| at
//! most what |w|, f and g allow, and |w| and the chain within the bounds of the loop under such a force. A force that
//! is consistent with itself bounds the loop, by induction over time, as long as the states stay within the
//! envelope; they do where no state on its faces has a chain within the bounds that follow.
//!
//! Several outputs have a chain and a force each, f is the vector of their drifts and g the decoupling matrix. All
//! u, and so each force, follow from all w: the forces have to be consistent together. The chains of a linear plant with
//! several inputs are exact at the samples ([`exact`]).

mod beside;
mod cell;
mod chain;
mod exact;
mod faces;
mod forces;
mod motion;
mod rates;
mod report;

use super::cells::Worst;
use super::followed::Followed;
use super::judge::Loop;
use super::outcome::{NAME, UNKNOWN};
use crate::check::{Outcome, Verdict};
use crate::internal::fault;
use crate::request::{After, Reference, Spec};
use beside::Beside;
pub(super) use cell::divided;
use chain::{chain, few_samples};
use motion::Motion;
use rates::{Rates, Reached};

/// Rounds in which forces are widened until they are consistent with themselves.
const ROUNDS: u32 = 10;

/// A force from which on none is consistent with itself.
const FAR: f64 = 1e100;

/// Relative excess over the required value.
const WIDER: f64 = 0.02;

/// The check of a design with such a model.
pub(super) fn outcome(spec: &Spec) -> Outcome {
    if let Some(exact) = spec.sampled_exactly() {
        return exact::outcome(spec, exact).unwrap_or_else(Lacking::outcome);
    }
    if spec.arm().is_some() {
        let reason = "the loop of a robot has no bounds yet: run `simulate` and `verify`";
        return Outcome::not_checked(NAME, reason);
    }
    let motion = Motion::new(spec).unwrap_or_else(|| fault("a loop of a model without a model"));
    let found = Envelope::new(spec, &motion).and_then(|envelope| {
        let from = vec![0.0; envelope.outputs.len()];
        let found = envelope.bounded(After::Zero, from)?;
        let afterwards = envelope.afterwards(&found.force);
        Ok(report::judged(spec, &motion, (&envelope.outputs, &found), afterwards.as_ref()))
    });
    found.unwrap_or_else(Lacking::outcome)
}

/// Why there are no bounds: a value that is not given, or what is not shown.
enum Lacking {
    Value(String),
    Proof(String),
}

impl Lacking {
    fn outcome(self) -> Outcome {
        match self {
            Self::Value(reason) => Outcome::not_checked(NAME, reason),
            Self::Proof(reason) => {
                Outcome { verdict: Verdict::Undecided, ..Outcome::not_checked(NAME, reason) }
            }
        }
    }
}

/// The bounds of the loops.
struct Bounded {
    /// Worst case of the chain of each output, which w moves.
    worst: Vec<Worst>,
    /// Bound of |u| for each input.
    u: Vec<f64>,
    /// Bound of the force on each chain: e, errors of sensors, actuator and g, and rounding.
    force: Vec<f64>,
}

/// Bounds of |x_i| of each output, and of |u| of each input, from the deadline on.
type Afterwards = (Vec<Vec<f64>>, Vec<f64>);

/// One output, whose chain its law moves.
struct Output {
    spec: Spec,
    /// Error bounds of the measured coordinates of the chain.
    sensors: Vec<f64>,
    followed: Option<Beside>,
}

/// Basis for bounds of the forces on the envelope.
struct Envelope<'a> {
    spec: &'a Spec,
    motion: &'a Motion,
    rates: Rates<'a>,
    outputs: Vec<Output>,
}

impl<'a> Envelope<'a> {
    fn new(spec: &'a Spec, motion: &'a Motion) -> Result<Self, Lacking> {
        let promises = &spec.promises;
        let lacks =
            |key: &str, why: &str| Err(Lacking::Value(format!("`{key}` is not given{why}")));
        if promises.sample_time.is_none() {
            return lacks("sample_time", "");
        }
        if promises.x0_max.is_empty() {
            return lacks("x0_max", "");
        }
        let several = motion.inputs.len() > 1;
        if promises.x_max.is_empty() {
            let of =
                if several { "the last rates of the chains are" } else { "the rate of f + g u is" };
            return lacks("x_max", &format!(", within which {of} bounded"));
        }
        let unproved = |why: &str| Err(Lacking::Proof(why.to_owned()));
        if promises.jitter.is_some() {
            return unproved("what jitter leaves of a model that is not linear is not examined");
        }
        if promises.plant.is_some() {
            return unproved(
                "the plant of [plant] may differ from the model, and what that leaves is not examined",
            );
        }
        let designs = spec.designs();
        if spec.reference == Some(Reference::Input) {
            return unproved(UNKNOWN);
        }
        if several {
            few_samples(&designs)?;
        }
        let rates = Rates::new(spec, motion).map_err(Lacking::Proof)?;
        let sensors = rates.sensors().map_err(Lacking::Proof)?;
        let mut sensors = sensors.into_iter();
        let outputs = designs.into_iter().map(|own| {
            let sensors = sensors.by_ref().take(own.n).collect();
            Output::new(own, sensors).map_err(Lacking::Proof)
        });
        let outputs = outputs.collect::<Result<_, _>>()?;
        Ok(Self { spec, motion, rates, outputs })
    }

    /// The bounds under forces that are consistent with themselves, `force` or larger ones: to the deadline, or for
    /// as long as the law goes on.
    fn bounded(&self, after: After, mut force: Vec<f64>) -> Result<Bounded, Lacking> {
        for _ in 0..ROUNDS {
            let loops = self.outputs.iter().zip(&force);
            let loops = loops.map(|(output, force)| output.reached(after, &output.sensors, *force));
            let loops = loops.collect::<Result<Vec<_>, _>>()?;
            let (worst, loops): (Vec<_>, Vec<_>) = loops.into_iter().unzip();
            let (wanted, chains): (Vec<_>, Vec<_>) = loops.into_iter().unzip();
            let reached = Reached { wanted, chains: chains.concat(), force };
            let mut sizes = self.rates.sizes(&reached).map_err(Lacking::Proof)?;
            let all = self.outputs.iter().zip(&reached.wanted).zip(&mut sizes.force);
            for ((output, wanted), force) in all {
                *force += output.followed.as_ref().map_or(0.0, |own| own.force(*wanted));
            }
            if sizes.force.iter().zip(&reached.force).all(|(needed, force)| needed <= force) {
                faces::stays(self.spec, self.motion, &reached.chains).map_err(Lacking::Proof)?;
                return Ok(Bounded { worst, u: sizes.u, force: reached.force });
            }
            force = sizes.force.iter().map(|needed| (1.0 + WIDER) * needed).collect();
            if force.iter().any(|force| *force > FAR) {
                break;
            }
        }
        let what = if self.outputs.len() > 1 {
            "what the last rates of the chains may change by between samples grows"
        } else {
            "what f + g u may change by between samples grows"
        };
        Err(Lacking::Proof(format!(
            "{what} with the u that it takes: a shorter sample_time, or closer x_max and x0_max, may bound it"
        )))
    }

    /// Returns the bounds that hold from the deadline on, where they are known; with a reference, only those before the
    /// deadline are.
    fn afterwards(&self, from: &[f64]) -> Option<Afterwards> {
        let follows = self.outputs.iter().any(|output| output.spec.reference.is_some());
        if self.spec.after != After::Hold || follows {
            return None;
        }
        let Bounded { worst, force, .. } = self.bounded(After::Hold, from.to_vec()).ok()?;
        let after = worst.into_iter().map(|worst| worst.after).collect::<Option<Vec<_>>>()?;
        let (chains, wanted): (Vec<_>, Vec<_>) =
            after.into_iter().map(|after| (after.x, after.u)).unzip();
        let u = self.rates.sizes(&Reached { wanted, chains: chains.concat(), force }).ok()?.u;
        Some((chains, u))
    }
}

impl Output {
    /// # Errors
    /// Why what it follows has no bounds.
    fn new(spec: Spec, mut sensors: Vec<f64>) -> Result<Self, String> {
        let own = spec.sampled().unwrap_or_else(|| fault("a model in samples without samples"));
        let followed = Followed::new(&spec, own)?;
        let followed = followed.map(|followed| Beside::new(&spec, &followed));
        if let Some(beside) = &followed {
            sensors.iter_mut().zip(&beside.off).for_each(|(sensor, off)| *sensor += off);
        }
        Ok(Self { spec, sensors, followed })
    }

    /// The loop under such a force with such errors of what is measured, and what is wanted of the last rate of the plant, and its chain, in it.
    fn reached(
        &self,
        after: After,
        sensors: &[f64],
        force: f64,
    ) -> Result<(Worst, (f64, Vec<f64>)), Lacking> {
        let chain = Spec { after, ..chain(&self.spec, sensors, force) };
        let closed = Loop::new(&chain, None).map_err(Lacking::Value)?;
        let worst = closed.worst(true).map_err(Lacking::Proof)?;
        let (wanted, x) = reached(&worst, after).map_err(Lacking::Proof)?;
        let of_plant = match &self.followed {
            Some(beside) => beside.of_plant(wanted, &x),
            None => (wanted, x),
        };
        Ok((worst, of_plant))
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
