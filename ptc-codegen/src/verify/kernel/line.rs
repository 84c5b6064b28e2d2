//! A run as instants, with the steps between them.

use super::super::trial::Instant;
use super::super::{Campaign, Scenario, Trial};
use super::step::Step;
use super::{Line, MOST, PARTS, REACH, Rates, slopes};
use crate::parameter::Parameter;

impl Line {
    pub(super) fn along(
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

    /// T/tau of an instant.
    pub(super) fn share(&self, index: usize) -> f64 {
        self.instants[index].time_to_go / self.setting.values.get(Parameter::Tau)
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
}
