//! The worst switching of disturbances between their bounds, from the slopes of the loop along a run.
//!
//! What a disturbance moves x_n by at a moment moves x at a later instant by the loop's own transition
//! from the one to the other: the kernel. Along a run that is the product of the transitions over short
//! steps, each with the slopes of xn' there. For a direction in which x is to go, each disturbance is
//! worst at the bound for which its kernel points there: it switches where the kernel changes its sign.
//! In a loop that is linear in x that is the worst signal, and what it moves x by is known before it is
//! run; elsewhere it is a step towards one, repeated along the run that it makes.

mod rates;
mod step;

pub(super) use rates::Rates;
use step::{Step, dot};

use super::objective::norm;
use super::observer::Here;
use super::trial::Instant;
use super::{Campaign, Course, Kind, Scenario, Setting, Signal, Trial};
use crate::parameter::Parameter;

/// Parts of a step of the grid between which slopes are taken as constant, at least.
const PARTS: u32 = 8;

/// Largest transition of a step, as the norm of its exponent.
const REACH: f64 = 0.25;

/// Most steps of a part, and of a run.
const MOST: f64 = 20_000.0;

/// Instants that are made the worst ones.
const TARGETS: usize = 40;

/// Most switches of a signal: what is before them has decayed.
const SWITCHES: usize = 64;

/// A run with its steps; those before each instant.
struct Line {
    setting: Setting,
    instants: Vec<Instant>,
    steps: Vec<Vec<Step>>,
}

/// A way to make an objective worse.
struct Way {
    excess: f64,
    scenario: Scenario,
}

/// Scenarios in which `objective` may be worse than in `from`; none where the run has no slopes.
pub(super) fn worse(
    campaign: &Campaign,
    (trial, rates): (&mut Trial, &mut Rates),
    objective: usize,
    from: &Scenario,
) -> Option<Vec<Scenario>> {
    let line = Line::along(campaign, (trial, rates), from)?;
    let worst = |index: &usize| line.instants[*index].excess[objective];
    let last = line.instants.len() - 1;
    let at_end = matches!(campaign.objectives[objective].kind, Kind::Attractive { .. });
    let mut targets: Vec<_> = match at_end {
        true => vec![last],
        false => (1..=TARGETS).map(|i| i * last / TARGETS).filter(|i| *i > 0).collect(),
    };
    targets.extend((1..=last).reduce(|a, b| if worst(&b) > worst(&a) { b } else { a }));
    targets.sort_unstable();
    targets.dedup();
    let mut ways: [Option<Way>; 2] = [None, None];
    for target in targets {
        let found = line.ways(campaign, (trial, rates), (objective, target), from);
        for (best, way) in ways.iter_mut().zip(found) {
            if way
                .as_ref()
                .is_some_and(|way| best.as_ref().is_none_or(|best| way.excess > best.excess))
            {
                *best = way;
            }
        }
    }
    Some(ways.into_iter().flatten().map(|way| way.scenario).collect())
}

impl Line {
    fn along(
        campaign: &Campaign,
        (trial, rates): (&mut Trial, &mut Rates),
        from: &Scenario,
    ) -> Option<Self> {
        let setting = campaign.looked_at(from, PARTS);
        let mut instants: Vec<Instant> = Vec::new();
        // As far as it comes.
        let _ = trial.instants(&setting, &mut |instant| instants.push(instant));
        rates.start(&setting)?;
        let mut line = Self { setting, instants, steps: vec![Vec::new()] };
        let mut count = 0.0;
        for index in 1..line.instants.len() {
            let steps = line.between(campaign, rates, (from, index))?;
            #[allow(clippy::cast_precision_loss)]
            let more = steps.len() as f64;
            count += more;
            line.steps.push(steps);
            if count > MOST {
                return None;
            }
        }
        (line.instants.len() > 1).then_some(line)
    }

    /// The steps from an instant to the next.
    fn between(
        &self,
        campaign: &Campaign,
        rates: &mut Rates,
        (from, index): (&Scenario, usize),
    ) -> Option<Vec<Step>> {
        let [a, b] = [&self.instants[index - 1], &self.instants[index]];
        let tau = self.setting.values.get(Parameter::Tau);
        let start = self.setting.values.get(Parameter::StartTime);
        let length = a.time_to_go - b.time_to_go;
        let mut at = |part: f64| {
            let time_to_go = a.time_to_go - part * length;
            let x: Vec<_> = a.x.iter().zip(&b.x).map(|(a, b)| a + part * (b - a)).collect();
            let share = time_to_go / tau;
            let courses = campaign.disturbances.iter().zip(&from.courses);
            let levels: Vec<_> = courses
                .map(|((_, bounds, _), course)| course.value(*bounds, campaign.until, share))
                .collect();
            let time = (start + (tau - time_to_go), time_to_go);
            rates.disturb(&levels);
            let now = rates.last(time, &x);
            let slopes = slopes(&x, time_to_go, now, &mut |x| rates.last(time, x));
            let changes = campaign.disturbances.iter().enumerate().map(|(d, (_, bounds, _))| {
                [bounds.0, bounds.1].map(|bound| {
                    let mut changed = levels.clone();
                    changed[d] = bound;
                    rates.disturb(&changed);
                    rates.last(time, &x) - now
                })
            });
            let changes = changes.collect();
            Step { share, length, slopes, changes }
        };
        let middle = at(0.5);
        let n = i32::try_from(middle.slopes.len()).unwrap_or(i32::MAX);
        let scaled =
            (1..).zip(&middle.slopes).map(|(j, slope)| (slope * b.time_to_go.powi(n - j)).abs());
        let exponent = length * scaled.sum::<f64>().max(1.0 / b.time_to_go);
        let count = (exponent / REACH).ceil().max(1.0);
        if count.is_nan() || count > MOST {
            return None;
        }
        if count <= 1.0 {
            return Some(vec![middle]);
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let count = count as u32;
        let part = |i: u32| (f64::from(i) + 0.5) / f64::from(count);
        let steps = (0..count).map(|i| Step { length: length / f64::from(count), ..at(part(i)) });
        Some(steps.collect())
    }

    /// The best switching of the disturbances for an objective at an instant: by itself, and with x0 in
    /// the corner that goes with it.
    fn ways(
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
                    *best =
                        Some(Way { excess: value, scenario: Scenario { point, courses, seed: 0 } });
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

    /// What a change of xn' over each of the steps before an instant, the last one first, moves x there
    /// by, until that has decayed; and the transition from t0, where it has not.
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

/// Whether the upper bound moves further along than the lower one.
fn is_high(along: f64, [low, high]: [f64; 2]) -> bool {
    along * high >= along * low
}

/// Slopes of a function of x whose value there is `here`, by differences in proportion to what x is.
fn slopes(x: &[f64], time_to_go: f64, here: f64, value: &mut dyn FnMut(&[f64]) -> f64) -> Vec<f64> {
    // T^(j-1) x_j are of one size.
    let powers: Vec<_> = (0..).take(x.len()).map(|j| time_to_go.powi(j)).collect();
    let scaled: Vec<_> = x.iter().zip(&powers).map(|(x, power)| x * power).collect();
    let size = norm(scaled.iter().copied()).max(1e-6 * powers[x.len() - 1]);
    let mut moved = x.to_vec();
    let slope = |j: usize| {
        let step = 1e-6 * x[j].abs().max(1e-3 * size / powers[j]);
        moved[j] = x[j] + step;
        let slope = (value(&moved) - here) / (moved[j] - x[j]);
        moved[j] = x[j];
        if slope.is_finite() { slope } else { 0.0 }
    };
    (0..x.len()).map(slope).collect()
}
