//! The search for an eps: the one with the smallest worst case, and those that keep a margin.

use std::collections::BTreeMap;

use super::effort::Effort;
use super::{Law, Trial};
use crate::check::examine::Numbers;
use crate::check::sampled::judge::Loop;
use crate::check::sampled::stability::Wanted;
use crate::parameter::Fixed;

/// An eps that may be chosen.
pub(crate) struct Candidate {
    pub(crate) eps: Fixed,
    /// The reason to choose it, in one sentence.
    pub(crate) reason: String,
    /// True if the worst case of the search is within `error`, if that is given.
    pub(crate) is_within: bool,
}

impl Loop<'_> {
    /// Returns the eps to choose from, the preferred one first: the one with the smallest final error that keeps the
    /// wanted margin, the one with the largest margin within `error`, and the one with the smallest final error.
    ///
    /// # Errors
    /// The search would take too long, or the loop has no bound.
    pub(crate) fn candidates(&self, numbers: &Numbers<'_>) -> Result<Vec<Candidate>, String> {
        let effort = Effort::of(self)?;
        let trial = Trial::new(self, numbers);
        let wanted = Wanted::of(self.spec);
        let (costs, kept) = (BTreeMap::new(), BTreeMap::new());
        let mut tried = Tried { trial: &trial, effort, costs, kept, wanted };
        let points: Vec<_> = trial.points(effort.points).collect();
        let zero = matches!(trial.law, Law::Samples { .. }).then_some(0.0);
        let Some(free) = tried.least(&points, zero, &mut |tried, eps| tried.cost(eps)) else {
            return Err("the loop has no bound with any of them".to_owned());
        };
        if tried.keeps(free) {
            let reason = format!("{LEAST} is smallest with it, and it keeps the margin: {wanted}");
            return Ok(tried.candidate(free, reason).into_iter().collect());
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
        Ok(all.filter_map(|(eps, reason)| tried.candidate(eps, reason)).collect())
    }
}

/// Objective of the search.
const LEAST: &str = "the worst |x| at the deadline";

/// The eps that were tried: whole periods are tried once.
struct Tried<'a> {
    trial: &'a Trial<'a>,
    effort: Effort,
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
        let reason = format!("{reason}{}", self.effort.note());
        Some(Candidate { eps: self.trial.exact(eps)?, reason, is_within })
    }

    /// The eps with the largest margin among those tried whose final error is within `error`, of equal margins the one
    /// with the smallest.
    fn widest(&self) -> Option<f64> {
        let within = self.costs.iter().filter(|(_, cost)| **cost <= 1.0);
        let shares = within.map(|(bits, cost)| {
            let eps = f64::from_bits(*bits);
            let found = self.trial.stays(eps).and_then(|stays| stays.stability(false));
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
        for _ in 0..self.effort.rounds {
            let (a, b) = (left + (right - left) / 3.0, right - (right - left) / 3.0);
            let [here, there] = [a, b].map(|x| self.trial.legal(x.exp()));
            let [of_here, of_there] = [here, there].map(|eps| cost(self, eps));
            for (eps, cost) in [(here, of_here), (there, of_there)] {
                if cost < least {
                    (best, least) = (eps, cost);
                }
            }
            // If neither is legal, the search moves towards the best eps so far.
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
