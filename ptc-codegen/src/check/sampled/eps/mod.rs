//! Choice of eps: its effect on the worst case of the loop, and the eps with the smallest worst case.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

mod effort;
mod search;

pub(crate) use search::Candidate;

use std::sync::Arc;

use num_traits::ToPrimitive;

use super::chain::{Chain, Gains, Rows};
use super::emitted::{self, Samples};
use super::gain::{Gain, known_gain};
use super::judge::Loop;
use super::stability::Stays;
use super::worst::Sampled;
use crate::algebra::BigRational;
use crate::check::examine::{Numbers, rounded_down};
use crate::check::list;
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;
use crate::samples::Ending;
use crate::syntax::constant;

/// Points at which eps is tried first, on a logarithmic scale, beside the first one.
const POINTS: u32 = 32;

/// Samples at which u is looked at for a curve: the fewest, where samples are many, and the most.
const LOOKED_AT: [f64; 2] = [8.0, 150.0];

/// Operations that u of a curve may take: seconds.
const OPERATIONS: f64 = 4e9;

/// The loop with its gains held at an eps, without what an uncertain gain and jitter add.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// In s.
    pub eps: f64,
    /// Worst |x_i| at the deadline.
    pub x: Vec<f64>,
    /// Worst |u| at some 150 samples, fewer of very many, and where the hold begins.
    pub u: f64,
}

/// The worst cases over eps > 0 of a law; empty where its loop is not known.
pub fn curve(spec: &Spec, expanded: Option<&Expanded>) -> Vec<Choice> {
    let Ok(closed) = Loop::new(spec, expanded) else { return Vec::new() };
    let numbers = Numbers::new(spec, expanded);
    let trial = Trial::new(&closed, &numbers);
    let mut points: Vec<_> = trial.points(POINTS).collect();
    points.dedup();
    let all = points.into_iter().filter_map(|eps| trial.choice(eps));
    all.filter(|choice| choice.u.is_finite() && choice.x.iter().all(|x| x.is_finite())).collect()
}

/// A loop whose gains can be held at any eps.
struct Trial<'a> {
    closed: &'a Loop<'a>,
    numbers: &'a Numbers<'a>,
    law: Law,
    tau: f64,
    h: f64,
    gain: Gain,
    chain: Chain,
}

/// Source of the gains at a sample.
enum Law {
    /// A law in continuous time, with the gains of each sample without a hold.
    Time { free: Arc<[Rows]> },
    /// A program in samples, which is the same before any hold; `None` where it is not enclosed.
    Samples { free: Option<Arc<[Rows]>> },
}

impl<'a> Trial<'a> {
    fn new(closed: &'a Loop<'a>, numbers: &'a Numbers<'a>) -> Self {
        let h = closed.period.middle();
        let gain = closed.gain();
        let chain = closed.plant.with_gain(gain.value);
        let tau = closed.samples as f64 * h;
        let free = Arc::default();
        let mut trial = Self { closed, numbers, law: Law::Time { free }, tau, h, gain, chain };
        trial.law = if closed.spec.sampled().is_some() {
            let least = trial.least() as f64 * h;
            Law::Samples { free: trial.program(least, 0).map(|found| found.rows.into()) }
        } else {
            Law::Time {
                free: (0..closed.samples).map(|k| trial.free_row(trial.to_go(k))).collect(),
            }
        };
        trial
    }

    fn to_go(&self, k: usize) -> f64 {
        (self.closed.samples - k) as f64 * self.h
    }

    /// The gains of u at a time-to-go: those of the chain over the g by which the law divides.
    fn gains(&self, numbers: &Numbers<'_>, time_to_go: f64) -> Vec<f64> {
        let known = known_gain(self.closed.spec).ok().and_then(|g| g.to_f64()).unwrap_or(1.0);
        numbers.gains(time_to_go).iter().map(|gain| gain / known).collect()
    }

    /// The sample with the gains at a time-to-go.
    fn free_row(&self, time_to_go: f64) -> Rows {
        let values = self.gains(self.numbers, time_to_go);
        self.chain.closed(&Gains { errors: vec![0.0; values.len()], values })
    }

    /// The samples to go of the shortest hold: with fewer the gains of a law in samples are those without a hold.
    fn least(&self) -> usize {
        if self.closed.spec.sampled().is_some() { self.closed.spec.loop_order() + 1 } else { 1 }
    }

    /// From the shortest hold to 0.9 of tau, in `steps` steps; none for a tau that is shorter.
    fn points(&self, steps: u32) -> impl Iterator<Item = f64> {
        let (low, high) = ((self.least() as f64 * self.h).ln(), (0.9 * self.tau).ln());
        let count = if low < high { steps + 1 } else { 0 };
        let point = move |i| (low + f64::from(i) / f64::from(steps) * (high - low)).exp();
        (0..count).map(move |i| self.legal(point(i)))
    }

    /// An eps as a design has it: in time to its digits, in samples whole periods.
    fn legal(&self, eps: f64) -> f64 {
        match self.law {
            Law::Time { .. } => {
                let exact = rounded_down(eps);
                exact.as_ref().and_then(Fixed::number).and_then(ToPrimitive::to_f64).unwrap_or(eps)
            }
            Law::Samples { .. } => (eps / self.h).round() * self.h,
        }
    }

    /// The same, as a design has it.
    fn exact(&self, eps: f64) -> Option<Fixed> {
        match self.law {
            Law::Time { .. } => rounded_down(eps * (1.0 + 1e-9)),
            Law::Samples { .. } => {
                let h = self.closed.spec.fixed.get(&Parameter::SampleTime)?.number()?;
                let value = BigRational::from_float((eps / self.h).round())? * h;
                Some(Fixed::Number { text: constant::text(&value), value })
            }
        }
    }

    /// Evaluates the program in samples with an eps, from sample `first` on.
    fn program(&self, eps: f64, first: usize) -> Option<Samples> {
        let mut spec = self.closed.spec.clone();
        spec.choose_eps(self.exact(eps)?);
        let own = spec.sampled()?;
        let followed = self.closed.followed.as_ref();
        emitted::samples(&spec, own, &self.chain, followed, first..=self.closed.samples)
    }

    /// The loop held at an eps.
    fn held(&self, eps: f64) -> Option<Sampled> {
        let chain = self.chain.clone();
        let sampled = match &self.law {
            Law::Time { free } => {
                let first = free.iter().zip(0..).take_while(|(_, k)| self.to_go(*k) > eps).count();
                let held = if first < free.len() { vec![self.free_row(eps)] } else { Vec::new() };
                Sampled::shared(chain, free, first, held)
            }
            Law::Samples { free } => {
                let to_go = (eps / self.h).round().to_usize()?;
                // Without a hold, deadbeat takes over at another sample, so that every sample is evaluated.
                let early = Ending::of(self.closed.spec).map_or(0, |ending| ending.spare as usize);
                let first = match to_go {
                    0 => 0,
                    _ => self.closed.samples.checked_sub(to_go)?.saturating_sub(early),
                };
                self.program(eps, first)?.after(chain, free.as_ref()?, first)
            }
        };
        Some(self.closed.disturbed(sampled, &self.gain))
    }

    /// The loop that stays with an eps.
    fn stays(&self, eps: f64) -> Option<Stays> {
        let exact = match self.law {
            Law::Time { .. } => BigRational::from_float(eps)?,
            Law::Samples { .. } => self.exact(eps)?.number()?.clone(),
        };
        Stays::new(self.closed, self.numbers, &self.chain, &exact)
    }

    /// An eps as a design has it.
    fn text(&self, eps: f64) -> Option<String> {
        Some(self.exact(eps)?.to_string())
    }

    /// Describes the worst case at the deadline with an eps, and the stability margins with it.
    fn described(&self, eps: f64) -> String {
        let finals = self.held(eps).map(|sampled| self.finals(&sampled)).unwrap_or_default();
        let nominal = match self.gain.error > 0.0 || self.closed.late.is_some() {
            true => ", with the nominal input gain and no jitter",
            false => "",
        };
        let stays = self.stays(eps).and_then(|stays| stays.stability(false));
        let stays = stays.map_or_else(
            || "not stable afterwards".to_owned(),
            |found| format!("stable for {found}"),
        );
        format!("|x| of about {}{nominal}, and {stays}", list(finals))
    }

    /// Returns the worst |x_i| at the deadline.
    fn finals(&self, sampled: &Sampled) -> Vec<f64> {
        let state = |i| sampled.bound(&sampled.state(i), self.closed.samples, None).attained();
        (1..=self.closed.spec.n).map(state).collect()
    }

    /// Returns the largest ratio of a final |x_i| to its required bound.
    fn cost(&self, eps: f64) -> f64 {
        let Some(sampled) = self.held(eps) else { return f64::INFINITY };
        let finals = self.finals(&sampled);
        let shares = finals.iter().zip(self.closed.errors()).map(|(x, error)| x / error);
        shares.fold(0.0, f64::max)
    }

    fn choice(&self, eps: f64) -> Option<Choice> {
        let sampled = self.held(eps)?;
        let count = self.closed.samples;
        let hold = (0..count).find(|k| self.to_go(*k) <= eps);
        let control = sampled.control();
        let looked_at = (0..count).step_by(count.div_ceil(looked_at(&sampled, count))).chain(hold);
        let u = looked_at.map(|k| sampled.bound(&control, k, None).attained());
        Some(Choice { eps, x: self.finals(&sampled), u: u.fold(0.0, f64::max) })
    }
}

/// Returns how many of `count` samples are examined for each point of a curve.
fn looked_at(sampled: &Sampled, count: usize) -> usize {
    let [size, count] = [sampled.size(), count].map(|count| count as f64);
    let of_each = 0.5 * count * size * (size + 4.0) * f64::from(POINTS);
    let [fewest, most] = LOOKED_AT;
    (OPERATIONS / of_each).clamp(fewest, most).to_usize().unwrap_or(1)
}
