//! The signals that are worst along a run, by where the kernels point.

use super::super::observer::Here;
use super::super::trial::Instant;
use super::super::{Campaign, Course, Scenario, Signal, Trial};
use super::step::{Step, dot};
use super::{Line, Rates, SWITCHES, Way, slopes};

impl Line {
    /// The best switching of the disturbances for an objective at an instant: by itself, and with x0 in
    /// the corner that goes with it.
    pub(super) fn ways(
        &self,
        campaign: &Campaign,
        (trial, rates): (&mut Trial, &mut Rates),
        (objective, target): (usize, usize),
        from: &Scenario,
    ) -> [Option<Way>; 2] {
        let Instant { t, time_to_go, x, integrals, .. } = &self.instants[target];
        let n = x.len();
        let whole: usize = self.setting.pieces.iter().map(|(shares, _)| shares.len()).sum();
        let last = target + 1 == whole;
        let (kernels, at_start) = self.kernels(target, n);
        let mut setting = self.setting.clone();
        let mut excess = |x0: &[f64], x: &[f64], rates: &mut Rates| {
            let u = [rates.control(*t, x)];
            setting.x0.copy_from_slice(x0);
            let here = Here { time_to_go: *time_to_go, x, u: &u, integrals };
            let excess = trial.excess_at(&setting, here, (objective, last));
            excess.unwrap_or(f64::NEG_INFINITY)
        };
        let x0 = &self.setting.x0;
        let here = excess(x0, x, rates);
        let own = slopes(x, *time_to_go, here, &mut |moved| excess(x0, moved, rates));
        let unit = |j: usize, sign: f64| (0..n).map(|i| if i == j { sign } else { 0.0 }).collect();
        let mut directions: Vec<Vec<f64>> =
            (0..n).flat_map(|j| [unit(j, 1.0), unit(j, -1.0)]).collect();
        directions.push(own.iter().map(|slope| -slope).collect());
        directions.push(own);
        let mut ways = [None, None];
        for direction in directions {
            for (with_x0, best) in ways.iter_mut().enumerate() {
                let mut direction = direction.clone();
                // The direction turns with where x goes, as that of |x| does.
                for _ in 0..3 {
                    let mut moved = x.clone();
                    let mut start = x0.clone();
                    if with_x0 == 1 {
                        let Some(at_start) = &at_start else { break };
                        for (j, (low, high)) in campaign.x0.iter().enumerate() {
                            let along = dot(&direction, (0..n).map(|i| at_start[i * n + j]));
                            start[j] = if along >= 0.0 { *high } else { *low };
                            let change = start[j] - x0[j];
                            (0..n).for_each(|i| moved[i] += at_start[i * n + j] * change);
                        }
                    }
                    for (step, kernel) in self.before(target).zip(&kernels) {
                        let along = dot(&direction, kernel.iter().copied());
                        for (d, changes) in step.changes.iter().enumerate() {
                            if !campaign.disturbances[d].2.contains(&Signal::Worst) {
                                continue;
                            }
                            let change = changes[usize::from(is_high(along, *changes))];
                            (0..n).for_each(|i| moved[i] += kernel[i] * change);
                        }
                    }
                    let value = excess(&start, &moved, rates);
                    let better =
                        |best: &Option<Way>| best.as_ref().is_none_or(|b| value > b.excess);
                    if !value.is_finite() || !better(best) {
                        break;
                    }
                    let mut point = from.point.clone();
                    point[1..=n].copy_from_slice(&start);
                    let courses = self.courses(campaign, (target, &kernels), &direction, from);
                    let scenario = Scenario { point, courses, seed: 0, at: from.at };
                    *best = Some(Way { excess: value, scenario });
                    direction = slopes(&moved, *time_to_go, value, &mut |moved| {
                        excess(&start, moved, rates)
                    });
                }
            }
        }
        ways
    }

    /// The steps before an instant, the last one first.
    fn before(&self, target: usize) -> impl Iterator<Item = &Step> {
        self.steps[..=target].iter().rev().flat_map(|steps| steps.iter().rev())
    }

    /// Returns the movements of x at an instant by a change of xn' over each of the steps before it, the last one
    /// first, until they have decayed; and the transition from t0, where they have not.
    fn kernels(&self, target: usize, n: usize) -> (Vec<Vec<f64>>, Option<Vec<f64>>) {
        let mut transition: Vec<f64> =
            (0..n * n).map(|at| f64::from(u8::from(at % (n + 1) == 0))).collect();
        let (mut kernels, mut total) = (Vec::new(), vec![0.0; n]);
        for step in self.before(target) {
            let kernel = step.impulse(&transition, n);
            step.pass(&mut transition, n);
            let size = |k: &f64| k.abs();
            total.iter_mut().zip(&kernel).for_each(|(total, own)| *total += size(own));
            let decayed = kernel.iter().zip(&total).all(|(own, total)| size(own) <= 1e-12 * total);
            kernels.push(kernel);
            if decayed {
                return (kernels, None);
            }
        }
        (kernels, Some(transition))
    }

    /// The courses in which each disturbance is at the bound towards which its kernel points.
    fn courses(
        &self,
        campaign: &Campaign,
        (target, kernels): (usize, &[Vec<f64>]),
        direction: &[f64],
        from: &Scenario,
    ) -> Vec<Course> {
        let of = |(d, own): (usize, &Course)| {
            if !campaign.disturbances[d].2.contains(&Signal::Worst) {
                return own.clone();
            }
            // From the last step back to where it has decayed.
            let (mut high, mut before): (Option<bool>, Option<(f64, f64)>) = (None, None);
            let mut switches: Vec<f64> = Vec::new();
            for (step, kernel) in self.before(target).zip(kernels) {
                let along = dot(direction, kernel.iter().copied());
                let [low, upper] = step.changes[d];
                let force = along / step.length * (upper - low);
                let here = is_high(along, step.changes[d]);
                if let (Some(after), Some((share, last))) = (high, before)
                    && after != here
                {
                    if switches.len() == SWITCHES {
                        break;
                    }
                    // Where the kernel passes through 0 between the two.
                    let part = if last == force { 0.5 } else { last / (last - force) };
                    let at = share + part.clamp(0.0, 1.0) * (step.share - share);
                    let short = rounded(at);
                    let at = if campaign.until < short && short < 1.0 { short } else { at };
                    // Twice at once is not at all.
                    if switches.last() == Some(&at) {
                        switches.pop();
                    } else {
                        switches.push(at);
                    }
                }
                (high, before) = (Some(here), Some((step.share, force)));
            }
            switches.reverse();
            Course::Worst { high: high.unwrap_or(true), switches }
        };
        from.courses.iter().enumerate().map(of).collect()
    }
}

/// To six digits: the kernel is 0 where a signal switches, so that no more are needed.
fn rounded(share: f64) -> f64 {
    format!("{share:.5e}").parse().unwrap_or(share)
}

/// Returns true if the upper bound moves further along than the lower one.
fn is_high(along: f64, [low, high]: [f64; 2]) -> bool {
    along * high >= along * low
}
