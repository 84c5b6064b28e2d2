//! The worst case of the loop of a design, with what it lacks to be known.

// Counts become numbers and polynomials small orders here.
#![allow(clippy::cast_precision_loss)]

use num_traits::{Signed, ToPrimitive};

use super::chain::{Chain, Gains};
use super::emitted;
use super::force::Force;
use super::gains::gains;
use super::trust::Trust;
use super::worst::{Bound, Output, Sampled};
use crate::algebra::BigRational;
use crate::check::examine::Numbers;
use crate::expansion::Expanded;
use crate::expression::interval::Interval;
use crate::expression::range::Range;
use crate::parameter::{Fixed, Parameter};
use crate::request::{PlantBounds, Spec};

/// Numbers that the matrices of all samples may hold together: some 300 MB.
const ENTRIES: f64 = 2e7;

/// Operations that the way to the deadline may take: seconds.
const OPERATIONS: f64 = 2e9;

/// The worst case of a sampled loop.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// Of each state at the deadline.
    pub states: Vec<Bound>,
    /// Samples from t0 to the deadline.
    pub samples: usize,
    /// On the way; `None` if there are too many samples to look at all of them.
    pub way: Option<Way>,
}

/// Bounds that hold from t0 to the deadline, of a chain between the samples too.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// Of each |x_i|.
    pub x: Vec<f64>,
    /// Of |u|.
    pub u: f64,
    /// What |u| reaches at least.
    pub u_attained: f64,
    /// The greatest standard deviation of u by random noise.
    pub u_rms: f64,
}

/// The loop of a design in numbers.
pub(crate) struct Loop<'a> {
    spec: &'a Spec,
    /// The closed forms of another engine.
    pub(super) expanded: Option<&'a Expanded>,
    period: Range,
    samples: usize,
    chain: Chain,
}

impl<'a> Loop<'a> {
    /// The sampled loop of `spec`, whose gains and tau are known.
    ///
    /// # Errors
    /// What it lacks, or why it is not looked at.
    pub(crate) fn new(spec: &'a Spec, expanded: Option<&'a Expanded>) -> Result<Self, String> {
        let promises = &spec.promises;
        let h = exact(promises.sample_time.as_ref()).ok_or("`sample_time` is not given")?;
        let tau = exact(spec.fixed.get(&Parameter::Tau)).ok_or("`tau` is left to run time")?;
        if promises.x0_max.is_empty() {
            return Err("`x0_max` is not given".to_owned());
        }
        let gain = match (&promises.plant, &spec.input_gain) {
            (Some(PlantBounds::Bounded { gain: Some(gain), .. }), _) => gain.clone(),
            (_, None) => BigRational::from_integer(1.into()),
            (_, Some(g)) => g.number().cloned().ok_or("the input gain g is not a number")?,
        };
        let count = &tau / &h;
        let samples = count.round();
        let near = (&count - &samples).abs() * BigRational::from_integer(1_000_000_000.into());
        if near > samples {
            return Err(format!(
                "tau is no multiple of the sample period: it is {} periods",
                count.to_f64().unwrap_or(f64::NAN)
            ));
        }
        let delay = promises.delay.unwrap_or(0);
        // The states, what is kept of them, and the causes.
        let kept = spec.sampled().filter(|own| own.observes()).map_or(0, |own| match own.linear {
            Some(_) => 2 * (spec.n + 1) + 1,
            None => spec.n + 2,
        });
        let size = (spec.n + delay + kept) as f64;
        let numbers = size * (size + spec.n as f64 + 1.0);
        let samples = samples.to_usize().filter(|count| *count as f64 * numbers <= ENTRIES);
        let Some(samples) = samples.filter(|count| *count > 0) else {
            return Err(format!(
                "{} samples are more than it looks at",
                crate::diagnostic::digits(count.to_f64().unwrap_or(f64::INFINITY))
            ));
        };
        let range = |value: &BigRational| Range::from(&Interval::exact(value));
        let period = range(&h);
        let chain = match spec.sampled().and_then(|own| own.linear.as_ref()) {
            Some(plant) => {
                Chain::linear(plant, &h, delay).ok_or("a mode is too fast for the sample period")?
            }
            None => Chain::new(spec.n, period, range(&gain), delay),
        };
        Ok(Self { spec, expanded, period, samples, chain })
    }

    /// The loop with what disturbs it.
    fn disturbed(&self, mut sampled: Sampled) -> Sampled {
        let promises = &self.spec.promises;
        sampled.x0 = promises.x0_max.iter().map(double).collect();
        let each = |bounds: &[Fixed], j: usize| {
            bounds.get(if bounds.len() == 1 { 0 } else { j }).map_or(0.0, double)
        };
        let noise = |j| each(&promises.noise, j) + each(&promises.sensor_step, j) / 2.0;
        sampled.noise = (0..self.chain.sensors()).map(noise).collect();
        let rms = |j| each(&promises.noise_rms, j);
        sampled.noise_rms = (0..self.chain.sensors()).map(rms).collect();
        sampled.actuator = promises.u_step.as_ref().map_or(0.0, double) / 2.0;
        sampled.force = self.force();
        sampled
    }

    /// What moves the plant beside u, if that is bounded and not 0.
    fn force(&self) -> Option<Force> {
        let Some(PlantBounds::Bounded { middle, constant, varying, .. }) =
            &self.spec.promises.plant
        else {
            return None;
        };
        let [middle, constant, varying] =
            [middle, constant, varying].map(|part| part.to_f64().unwrap_or(f64::INFINITY));
        let of_one = Chain::new(self.spec.n, self.period, Range::from(1.0), 0);
        let force = Force { middle, constant, varying, column: of_one.input };
        (force.most() > 0.0).then_some(force)
    }

    /// The loop with the emitted program.
    fn acting(&self) -> Result<Sampled, String> {
        let chain = self.chain.clone();
        let Some(own) = self.spec.sampled() else {
            let rows = gains(self.spec, self.expanded, self.period, self.samples)
                .ok_or("the gains of this mapping are not enclosed")?;
            return Ok(Sampled::new(chain, &rows));
        };
        if own.force != BigRational::default() {
            return Err("a loop with a known f is not examined".to_owned());
        }
        let (steps, acting, kept) = emitted::steps(self.spec, own, &chain, self.samples)
            .ok_or("the emitted program is not enclosed")?;
        Ok(Sampled::of(chain, steps, acting, &kept))
    }

    /// The worst case with the eps of the design, and on the way if `way` is set.
    ///
    /// # Errors
    /// A mapping whose gains are not enclosed, or a loop whose transitions are not bounded.
    pub(crate) fn worst(&self, way: bool) -> Result<Worst, String> {
        let sampled = self.disturbed(self.acting()?);
        let reach = sampled.reach(self.samples);
        // A loop that comes to rest sees nothing of its states before the last few samples, so that
        // a state cannot be scaled by what is seen of it.
        let rests = self.spec.sampled().filter(|_| reach.is_none());
        let rests = rests.map(|_| sampled.fading(None, self.samples));
        let state = |i: usize| {
            let output = sampled.state(i);
            if let Some(reach) = &reach {
                return Some(sampled.bound(&output, self.samples, Some(Trust::Reach(reach))));
            }
            let own = rests.is_none().then(|| sampled.fading(Some(&output), self.samples));
            let fading = own.as_ref().or(rests.as_ref())?.as_ref()?;
            Some(sampled.bound(&output, self.samples, Some(Trust::Fading(fading))))
        };
        let states: Option<Vec<_>> = (1..=self.spec.n).map(state).collect();
        let states =
            states.ok_or("an error of one sample may grow without a bound that is found")?;
        let way = if way { self.way(&sampled, reach.as_deref()) } else { None };
        Ok(Worst { states, samples: self.samples, way })
    }

    /// The bounds on the way, over all samples and the polynomials between them.
    fn way(&self, sampled: &Sampled, reach: Option<&[Vec<f64>]>) -> Option<Way> {
        let (n, size) = (self.spec.n, sampled.size());
        let outputs = n + 1 + n * (n - 1) / 2;
        let count = self.samples as f64;
        if 0.5 * count * count * (outputs * (size * size + 4 * size)) as f64 > OPERATIONS {
            return None;
        }
        let fading = match reach {
            Some(_) => None,
            None => Some(sampled.fading(None, self.samples)?),
        };
        let trust = reach.map(Trust::Reach).or(fading.as_ref().map(Trust::Fading));
        let mut way = Way { x: sampled.x0.clone(), u: 0.0, u_attained: 0.0, u_rms: 0.0 };
        let control = Output { row: vec![0.0; size], direct: 1.0 };
        for k in 0..=self.samples {
            if k < self.samples {
                let mut bound = sampled.bound(&control, k, trust);
                // The command, before the actuator rounds it.
                bound.actuator -= sampled.actuator;
                way.u = way.u.max(bound.total());
                way.u_attained = way.u_attained.max(bound.attained());
                way.u_rms = way.u_rms.max(bound.rms);
            }
            for i in 0..n {
                let total = |output: &Output| sampled.bound(output, k, trust).total();
                let here = reach.map(|reach| reach[k][i]);
                let mut most = here.unwrap_or_else(|| total(&sampled.state(i + 1)));
                // Between samples the states of a chain are polynomials, to which f adds at most what
                // it does in a whole sample.
                if k < self.samples && self.chain.outputs.is_none() {
                    let more = sampled.force.as_ref().map_or(0.0, |force| {
                        let (value, error) = force.column[i];
                        force.most() * (value + error)
                    });
                    let points = self.between(sampled, i);
                    most = points.iter().map(|point| total(point) + more).fold(most, f64::max);
                }
                way.x[i] = way.x[i].max(most);
            }
        }
        let finite = way.u.is_finite() && way.x.iter().all(|x| x.is_finite());
        finite.then_some(way)
    }

    /// The control points of x_{i+1} between two samples in Bernstein's form, of which it is a convex
    /// combination: the inner ones, as the others are its values at the samples. With an f, which those
    /// at the end of the sample hold, the last one too.
    fn between(&self, sampled: &Sampled, i: usize) -> Vec<Output> {
        let (n, size) = (self.spec.n, sampled.size());
        let degree = n - i;
        let choose = |n: usize, k: usize| {
            (0..k).fold(1.0, |product, j| product * (n - j) as f64 / (j + 1) as f64)
        };
        let point = |r: usize| {
            let mut output = Output { row: vec![0.0; size], direct: 0.0 };
            for l in 0..=r {
                let weight = choose(r, l) / choose(degree, l) * self.chain.shares[l];
                if i + l < n {
                    output.row[i + l] += weight;
                } else {
                    match sampled.acting {
                        None => output.direct += weight * self.chain.gain,
                        Some(kept) => output.row[kept] += weight * self.chain.gain,
                    }
                }
            }
            output
        };
        let last = degree + usize::from(sampled.force.is_some());
        (usize::from(sampled.force.is_none())..last).map(point).collect()
    }

    /// The eps whose worst final error is least, in parts of `error` where that is given.
    pub(crate) fn best_eps(&self, numbers: &Numbers<'_>) -> Option<f64> {
        let h = 0.5 * (self.period.low() + self.period.high());
        let tau = numbers.tau;
        let free: Vec<_> =
            (0..self.samples).map(|k| numbers.gains((self.samples - k) as f64 * h)).collect();
        let errors = self.errors();
        let cost = |eps: f64| {
            let held = numbers.gains(eps);
            let row = |k: usize| {
                let go = (self.samples - k) as f64 * h;
                let values = if go > eps { free[k].clone() } else { held.clone() };
                Gains { errors: vec![0.0; values.len()], values }
            };
            let rows: Vec<_> = (0..self.samples).map(row).collect();
            let sampled = self.disturbed(Sampled::new(self.chain.clone(), &rows));
            let share = |i: usize| {
                let bound = sampled.bound(&sampled.state(i + 1), self.samples, None);
                bound.attained() / errors[i]
            };
            (0..self.spec.n).map(share).fold(0.0, f64::max)
        };
        let (low, high) = (h.ln(), (0.9 * tau).ln());
        if low >= high {
            return None;
        }
        let at = |share: f64| low + share * (high - low);
        let costs: Vec<_> =
            (0..=POINTS).map(|i| cost(at(f64::from(i) / f64::from(POINTS)).exp())).collect();
        let (best, _) = costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        let step = 1.0 / f64::from(POINTS);
        let (mut left, mut right) =
            (at((best as f64 - 1.0) * step).max(low), at((best as f64 + 1.0) * step).min(high));
        for _ in 0..ROUNDS {
            let (a, b) = (left + (right - left) / 3.0, right - (right - left) / 3.0);
            if cost(a.exp()) <= cost(b.exp()) {
                right = b;
            } else {
                left = a;
            }
        }
        Some((0.5 * (left + right)).exp())
    }

    /// The wanted bound of each state; 1 where it is not given.
    pub(super) fn errors(&self) -> Vec<f64> {
        let errors = &self.spec.promises.error;
        let one = |i: usize| errors.get(if errors.len() == 1 { 0 } else { i });
        (0..self.spec.n).map(|i| one(i).map_or(1.0, double)).collect()
    }
}

/// Points at which eps is tried first, on a logarithmic scale.
const POINTS: u32 = 32;

/// Rounds of the search between two of them.
const ROUNDS: u32 = 10;

fn exact(value: Option<&Fixed>) -> Option<BigRational> {
    value.and_then(Fixed::number).cloned()
}

fn double(value: &Fixed) -> f64 {
    value.number().and_then(ToPrimitive::to_f64).unwrap_or(f64::INFINITY)
}
