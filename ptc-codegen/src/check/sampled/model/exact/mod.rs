//! The worst case of linear plants with several inputs, whose chains inputs move exactly which are held.
//!
//! At the samples the chain of each output is one of integrators that v moves, with no error but those of
//! what is measured, of the inputs as they act, and of rounding: G times what an input is off is a force on the chains,
//! which is constant over a sample, and F times what the states are off is one, too. What the kept constants
//! leave of the chains counts as errors of them and as a force ([`Left`]). All of these follow from
//! how large the chains and v become, and these from them: bounds that are consistent with themselves hold, by
//! induction over the samples. They need no bounds of the states, as everything is linear in them.
//!
//! The outputs with their derivatives are sums of the coordinates of the chains, at the samples and between them.

mod between;
mod given;
mod maps;
mod needed;
mod report;

use super::chain::few_samples;
use super::{FAR, Lacking, Output, ROUNDS, WIDER};
use crate::algebra::BigRational;
use crate::check::Outcome;
use crate::check::sampled::cells::Worst;
use crate::linear::Left;
use crate::lower::at_sample;
use crate::parameter::Fixed;
use crate::program::{Program, passes};
use crate::request::{After, Exact, Spec, exact_one_or_each};
use between::{AtSample, between};
use given::{doubles, fractions, gain_error, with_starts};
use maps::{Maps, both, summed};

/// The check of a design with such a plant.
pub(super) fn outcome(spec: &Spec, exact: &Exact) -> Result<Outcome, Lacking> {
    let of_plant = Exactly::new(spec, exact)?;
    let found = of_plant.bounded(After::Zero, of_plant.measured())?;
    let afterwards = match spec.after {
        After::Hold => of_plant.bounded(After::Hold, found.errors.clone()).ok(),
        After::Zero | After::Extern => None,
    };
    Ok(report::judged(&of_plant, &found, afterwards.as_ref()))
}

/// Error bounds of the chains, one for each coordinate.
#[derive(Clone)]
struct Errors {
    /// Force on each chain in addition to v.
    forces: Vec<f64>,
    /// Error of each xi as the law sees it.
    sensors: Vec<f64>,
    /// Distance of each xi from the chain that v and the force move.
    apart: Vec<f64>,
}

/// The bounds of the loops.
struct Bounded {
    /// Worst case of the chain of each output.
    worst: Vec<Worst>,
    errors: Errors,
    sizes: Sizes,
}

/// Bounds of the signals of a loop.
struct Sizes {
    /// Bounds of xi at the samples.
    chains: Vec<BigRational>,
    /// Bounds of v.
    wanted: Vec<BigRational>,
    /// Bounds of u as it is computed, and as it acts.
    u: Vec<BigRational>,
    acting: Vec<BigRational>,
    /// Bounds of the difference of u from G^-1 (v - F x).
    errors: Vec<BigRational>,
}

/// A plant, its loops and what is given of them.
struct Exactly<'a> {
    spec: &'a Spec,
    exact: &'a Exact,
    h: BigRational,
    outputs: Vec<Output>,
    maps: Maps,
    left: Left,
    /// The chains, and the inputs from v, as they are emitted.
    emitted: Program,
    /// Error bound of each measured state.
    noise: Vec<BigRational>,
    /// Error bound of an input, and relative error bound of its gain.
    step: BigRational,
    gain: BigRational,
}

impl<'a> Exactly<'a> {
    fn new(spec: &'a Spec, exact: &'a Exact) -> Result<Self, Lacking> {
        let promises = &spec.promises;
        let lacks = |key: &str| Lacking::Value(format!("`{key}` is not given"));
        let unproved = |why: &str| Lacking::Proof(why.to_owned());
        let h = promises.sample_time.as_ref().and_then(Fixed::number).cloned();
        let h = h.ok_or_else(|| lacks("sample_time"))?;
        if promises.x0_max.is_empty() {
            return Err(lacks("x0_max"));
        }
        if promises.jitter.is_some() {
            return Err(unproved(
                "what jitter leaves of a plant with several inputs is not examined",
            ));
        }
        if promises.plant.is_some() {
            return Err(unproved(
                "the plant of [plant] may differ from the model, and what that leaves is not examined",
            ));
        }
        let designs = spec.designs();
        few_samples(&designs)?;
        let singular = || unproved("the chains of the outputs are not enclosed");
        let maps = Maps::new(exact).ok_or_else(singular)?;
        let left = Left::new(&exact.plant, &h, &exact.chains).ok_or_else(singular)?;
        let outputs = with_starts(designs, &maps)?;
        let two = BigRational::from_integer(2.into());
        let number =
            |bounds: &[Fixed], j: usize| exact_one_or_each(bounds, j).cloned().unwrap_or_default();
        let noise = (0..spec.states())
            .map(|j| number(&promises.noise, j) + number(&promises.sensor_step, j) / &two);
        Ok(Self {
            noise: noise.collect(),
            step: number(promises.u_step.as_slice(), 0) / &two,
            gain: gain_error(&promises.g_error),
            emitted: passes::optimise(at_sample(spec), &mut |_, _| {}),
            spec,
            exact,
            h,
            outputs,
            maps,
            left,
        })
    }

    /// Returns the errors of the sensors alone.
    fn measured(&self) -> Errors {
        let sensors = doubles(&summed(&self.maps.coordinates, &self.noise));
        Errors { forces: vec![0.0; self.outputs.len()], apart: vec![0.0; sensors.len()], sensors }
    }

    /// The bounds under errors that are consistent with themselves, these or larger ones.
    fn bounded(&self, after: After, mut errors: Errors) -> Result<Bounded, Lacking> {
        for _ in 0..ROUNDS {
            let mut from = 0;
            let loops = self.outputs.iter().zip(&errors.forces).map(|(output, force)| {
                let sensors = &errors.sensors[from..][..output.spec.n];
                from += output.spec.n;
                output.reached(after, sensors, *force)
            });
            let loops = loops.collect::<Result<Vec<_>, _>>()?;
            let (worst, loops): (Vec<_>, Vec<_>) = loops.into_iter().unzip();
            let (wanted, chains): (Vec<_>, Vec<_>) = loops.into_iter().unzip();
            let chains = both(fractions(&chains.concat())?, &fractions(&errors.apart)?);
            let (needed, sizes) = self.needed(chains, fractions(&wanted)?)?;
            if needed.is_within(&errors) {
                return Ok(Bounded { worst, errors, sizes });
            }
            errors = needed.wider();
            if errors.all().any(|error| error.is_nan() || error > FAR) {
                break;
            }
        }
        Err(Lacking::Proof(
            "rounding, and what is given of sensors and inputs, grows with the u that it takes: closer x0_max, or a longer sample_time, may bound it".to_owned(),
        ))
    }

    /// The outputs with their derivatives where the chains are so large at a sample.
    fn at_sample(&self, chains: &[BigRational]) -> Vec<Vec<f64>> {
        self.of_each(&doubles(&summed(&self.maps.outputs, chains)))
    }

    /// The same on the way, and whether it holds between the samples, too.
    fn on_the_way(&self, sizes: &Sizes) -> (Vec<Vec<f64>>, bool) {
        let here = AtSample {
            chains: &sizes.chains,
            wanted: &sizes.wanted,
            errors: &sizes.errors,
            inputs: &sizes.acting,
        };
        match between(self.exact, &self.maps, &self.h, &here) {
            Some(most) => (self.of_each(&doubles(&most)), true),
            None => (self.at_sample(&sizes.chains), false),
        }
    }

    /// Splits `all` into the values of each output.
    fn of_each(&self, all: &[f64]) -> Vec<Vec<f64>> {
        let mut rest = all;
        let own = self.outputs.iter().map(|output| {
            let (own, others) = rest.split_at(output.spec.n);
            rest = others;
            own.to_vec()
        });
        own.collect()
    }
}

impl Errors {
    fn all(&self) -> impl Iterator<Item = f64> {
        [&self.forces, &self.sensors, &self.apart].into_iter().flatten().copied()
    }

    fn is_within(&self, other: &Self) -> bool {
        self.all().zip(other.all()).all(|(own, other)| own <= other)
    }

    fn wider(self) -> Self {
        let wider = |all: Vec<f64>| all.into_iter().map(|error| (1.0 + WIDER) * error).collect();
        Self { forces: wider(self.forces), sensors: wider(self.sensors), apart: wider(self.apart) }
    }
}
