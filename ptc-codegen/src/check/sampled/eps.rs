//! The eps of a law: what it makes of the worst case of its loop, and the one that leaves the least.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

use std::collections::BTreeMap;

use num_traits::ToPrimitive;

use super::chain::{Chain, Gains};
use super::emitted::{self, Steps};
use super::gain::{Gain, known_gain};
use super::judge::Loop;
use super::stability::{Stays, Wanted};
use super::worst::Sampled;
use crate::algebra::BigRational;
use crate::check::examine::{Numbers, rounded_down};
use crate::check::list;
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;
use crate::syntax::constant;

/// Points at which eps is tried first, on a logarithmic scale.
const POINTS: u32 = 32;

/// Rounds of the search between two of them.
const ROUNDS: u32 = 10;

/// Samples at which u is looked at for a curve.
const LOOKED_AT: usize = 150;

/// The loop with its gains held at an eps, without what an uncertain gain and jitter add.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// In s.
    pub eps: f64,
    /// What |x_i| at the deadline is at worst.
    pub x: Vec<f64>,
    /// What |u| is at worst, at some 150 samples and where the hold begins.
    pub u: f64,
}

/// The worst cases over eps > 0 of a law; empty where its loop is not known.
pub fn curve(spec: &Spec, expanded: Option<&Expanded>) -> Vec<Choice> {
    let Ok(closed) = Loop::new(spec, expanded) else { return Vec::new() };
    let numbers = Numbers::new(spec, expanded);
    let trial = Trial::new(&closed, &numbers);
    let mut points: Vec<_> = trial.points().collect();
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

/// What gives the gains at a sample.
enum Law {
    /// A law in continuous time, with the gains of each sample without a hold.
    Time { free: Vec<Vec<f64>> },
    /// A program in samples, which is the same before any hold; none where it is not enclosed.
    Samples { free: Option<Steps> },
}

impl<'a> Trial<'a> {
    fn new(closed: &'a Loop<'a>, numbers: &'a Numbers<'a>) -> Self {
        let h = closed.period.middle();
        let gain = closed.gain();
        let chain = closed.plant.with_gain(gain.value);
        let tau = closed.samples as f64 * h;
        let free = Vec::new();
        let mut trial = Self { closed, numbers, law: Law::Time { free }, tau, h, gain, chain };
        trial.law = if closed.spec.sampled().is_some() {
            let least = trial.least() as f64 * h;
            Law::Samples { free: trial.program(least, 0) }
        } else {
            let free = (0..closed.samples).map(|k| trial.gains(numbers, trial.to_go(k)));
            Law::Time { free: free.collect() }
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

    /// The samples to go of the shortest hold: with fewer a law in samples does not exist.
    fn least(&self) -> usize {
        if self.closed.spec.sampled().is_some() { self.closed.spec.loop_order() } else { 1 }
    }

    /// From the shortest hold to 0.9 of tau; none for a tau that is shorter.
    fn points(&self) -> impl Iterator<Item = f64> {
        let (low, high) = ((self.least() as f64 * self.h).ln(), (0.9 * self.tau).ln());
        let count = if low < high { POINTS + 1 } else { 0 };
        let point = move |i| (low + f64::from(i) / f64::from(POINTS) * (high - low)).exp();
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

    /// What the program in samples with an eps makes of the samples from `first` on.
    fn program(&self, eps: f64, first: usize) -> Option<Steps> {
        let mut spec = self.closed.spec.clone();
        spec.choose_eps(self.exact(eps)?);
        let own = spec.sampled()?;
        let followed = self.closed.followed.as_ref();
        emitted::steps(&spec, own, &self.chain, followed, first..=self.closed.samples)
    }

    /// The loop held at an eps.
    fn held(&self, eps: f64) -> Option<Sampled> {
        let chain = self.chain.clone();
        let sampled = match &self.law {
            Law::Time { free } => {
                let held = self.gains(self.numbers, eps);
                let row = |k: usize| {
                    let values = if self.to_go(k) > eps { &free[k] } else { &held }.clone();
                    Gains { errors: vec![0.0; values.len()], values }
                };
                let rows: Vec<_> = (0..self.closed.samples).map(row).collect();
                Sampled::new(chain, &rows)
            }
            Law::Samples { free } => {
                let (free, ..) = free.as_ref()?;
                let to_go = (eps / self.h).round().to_usize()?;
                // Without a hold deadbeat takes over at an end of its own.
                let first = if to_go == 0 { 0 } else { self.closed.samples.checked_sub(to_go)? };
                let (steps, acting, kept) = self.program(eps, first)?;
                let steps = free[..first].iter().cloned().chain(steps).collect();
                Sampled::of(chain, steps, acting, &kept)
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

    /// What an eps leaves at the deadline, and what the loop tolerates with it.
    fn described(&self, eps: f64) -> String {
        let finals = self.held(eps).map(|sampled| self.finals(&sampled)).unwrap_or_default();
        let nominal = match self.gain.error > 0.0 || self.closed.late.is_some() {
            true => ", with the nominal input gain and no jitter",
            false => "",
        };
        let stays = self.stays(eps).and_then(|stays| stays.stability());
        let stays = stays.map_or_else(
            || "not stable afterwards".to_owned(),
            |found| format!("stable for {found}"),
        );
        format!("|x| of about {}{nominal}, and {stays}", list(finals))
    }

    /// What |x_i| at the deadline is at worst.
    fn finals(&self, sampled: &Sampled) -> Vec<f64> {
        let state = |i| sampled.bound(&sampled.state(i), self.closed.samples, None).attained();
        (1..=self.closed.spec.n).map(state).collect()
    }

    /// The same in parts of what is wanted, of the state that is farthest from it.
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
        let looked_at = (0..count).step_by(count.div_ceil(LOOKED_AT)).chain(hold);
        let u = looked_at.map(|k| sampled.bound(&control, k, None).attained());
        Some(Choice { eps, x: self.finals(&sampled), u: u.fold(0.0, f64::max) })
    }
}

/// An eps that may be chosen.
pub(crate) struct Candidate {
    pub(crate) eps: Fixed,
    /// The reason to choose it, in one sentence.
    pub(crate) reason: String,
    /// Whether the worst case of the search is within `error`, if that is given.
    pub(crate) is_within: bool,
}

impl Loop<'_> {
    /// Returns the eps to choose from, the preferred one first: the one with the smallest final error that keeps the
    /// wanted margin, the one with the largest margin within `error`, and the one with the smallest final error.
    pub(crate) fn candidates(&self, numbers: &Numbers<'_>) -> Vec<Candidate> {
        let trial = Trial::new(self, numbers);
        let wanted = Wanted::of(self.spec);
        let mut tried =
            Tried { trial: &trial, costs: BTreeMap::new(), kept: BTreeMap::new(), wanted };
        let points: Vec<_> = trial.points().collect();
        let zero = matches!(trial.law, Law::Samples { .. }).then_some(0.0);
        let Some(free) = tried.least(&points, zero, &mut |tried, eps| tried.cost(eps)) else {
            return Vec::new();
        };
        if tried.keeps(free) {
            let reason = format!("{LEAST} is smallest with it, and it keeps the margin: {wanted}");
            return tried.candidate(free, reason).into_iter().collect();
        }
        let kept = tried.least(&points, zero, &mut |tried, eps| match tried.keeps(eps) {
            true => tried.cost(eps),
            false => f64::INFINITY,
        });
        let widest = if self.has_errors() { tried.widest() } else { None };
        let widest = widest.filter(|eps| Some(*eps) != kept && *eps != free);
        let of_free = trial.described(free);
        let without = trial.text(free).map_or_else(String::new, |text| {
            format!("; {LEAST} is smallest with eps = {text} s: {of_free}")
        });
        let lost = match kept {
            Some(_) => format!("the margin, {wanted}, would cost a bound of `loop`"),
            None => format!("no eps keeps the margin, {wanted}"),
        };
        let kept = kept.map(|eps| {
            let own = trial.described(eps);
            (eps, format!("{LEAST} is smallest with it among those that keep the margin, {wanted}: {own}{without}"))
        });
        let widest = widest.map(|eps| {
            let own = trial.described(eps);
            (eps, format!("{lost}; this eps has the largest margin within `error`: {own}{without}"))
        });
        let free = (free, format!("{LEAST} is smallest with it: {of_free}; {lost}"));
        let all = kept.into_iter().chain(widest).chain([free]);
        all.filter_map(|(eps, reason)| tried.candidate(eps, reason)).collect()
    }
}

/// What the search makes small.
const LEAST: &str = "the worst |x| at the deadline";

/// The eps that were tried: whole periods are tried once.
struct Tried<'a> {
    trial: &'a Trial<'a>,
    costs: BTreeMap<u64, f64>,
    kept: BTreeMap<u64, bool>,
    wanted: Wanted,
}

impl Tried<'_> {
    fn cost(&mut self, eps: f64) -> f64 {
        *self.costs.entry(eps.to_bits()).or_insert_with(|| self.trial.cost(eps))
    }

    fn keeps(&mut self, eps: f64) -> bool {
        let wanted = self.wanted;
        let keeps = || self.trial.stays(eps).is_some_and(|stays| stays.keeps(&wanted));
        *self.kept.entry(eps.to_bits()).or_insert_with(keeps)
    }

    fn candidate(&mut self, eps: f64, reason: String) -> Option<Candidate> {
        let is_within = !self.trial.closed.has_errors() || self.cost(eps) <= 1.0;
        Some(Candidate { eps: self.trial.exact(eps)?, reason, is_within })
    }

    /// The eps with the largest margin among those tried whose final error is within `error`, of equal margins the one
    /// with the smallest.
    fn widest(&self) -> Option<f64> {
        let within = self.costs.iter().filter(|(_, cost)| **cost <= 1.0);
        let shares = within.map(|(bits, cost)| {
            let eps = f64::from_bits(*bits);
            let found = self.trial.stays(eps).and_then(|stays| stays.stability());
            (eps, found.map_or(0.0, |found| found.share(&self.wanted)), *cost)
        });
        let best = shares.max_by(|a, b| a.1.total_cmp(&b.1).then(b.2.total_cmp(&a.2)));
        best.map(|(eps, ..)| eps)
    }

    /// The eps of the least finite cost: of some points, between the neighbours of the best one, and of `zero`.
    fn least(
        &mut self,
        points: &[f64],
        zero: Option<f64>,
        cost: &mut dyn FnMut(&mut Self, f64) -> f64,
    ) -> Option<f64> {
        let costs: Vec<_> = points.iter().map(|eps| cost(self, *eps)).collect();
        let (at, least) = costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        let (mut best, mut least) = (points[at], *least);
        let (mut left, mut right) =
            (points[at.saturating_sub(1)].ln(), points[(at + 1).min(points.len() - 1)].ln());
        for _ in 0..ROUNDS {
            let (a, b) = (left + (right - left) / 3.0, right - (right - left) / 3.0);
            let [here, there] = [a, b].map(|x| self.trial.legal(x.exp()));
            let [of_here, of_there] = [here, there].map(|eps| cost(self, eps));
            for (eps, cost) in [(here, of_here), (there, of_there)] {
                if cost < least {
                    (best, least) = (eps, cost);
                }
            }
            // Where neither is legal, the best one shows the way.
            let is_left = if of_here.is_finite() || of_there.is_finite() {
                of_here <= of_there
            } else {
                best.ln() < a
            };
            if is_left {
                right = b;
            } else {
                left = a;
            }
        }
        if let Some(zero) = zero {
            let of_zero = cost(self, zero);
            if of_zero <= least {
                (best, least) = (zero, of_zero);
            }
        }
        least.is_finite().then_some(best)
    }
}
