//! A run with its objectives, instant by instant.

use super::super::Setting;
use super::super::observer::{Here, Observer};
use super::super::samples::of_sample;
use super::Instant;
use crate::parameter::Parameter;
use crate::reference::Status;
use crate::simulate::{Accuracy, Changes, Failure, Run, Sample, Sampled, Side};

/// One side with its objectives, instant by instant: the first call that the emitted program refuses, if it does.
pub(super) fn along<S: Side>(
    run: &mut Run<S>,
    (observer, objectives): (&mut Observer, usize),
    (setting, accuracy): (&Setting, Accuracy),
    visit: &mut dyn FnMut(Instant),
) -> Result<Option<Failure>, Failure> {
    run.start(&setting.values, &setting.x0)?;
    let mut watch = Watch::new(observer, setting, objectives)?;
    let mut left: usize = setting.pieces.iter().map(|(shares, _)| shares.len()).sum();
    let mut refused = None;
    setting.pieces.iter().try_for_each(|(shares, values)| {
        let seen = &mut |sample: Sample<'_>| {
            left -= 1;
            if matches!(sample.status, Status::Range | Status::Input) {
                refused.get_or_insert(Failure::refused(sample.status.c_name(), sample.t));
            }
            visit(watch.instant(sample, left == 0));
        };
        run.advance(values, shares, accuracy, seen)
    })?;
    Ok(refused)
}

/// The loop that runs with its objectives, instant by instant. A signal jumps at the first sample after
/// the place of its jump.
pub(super) fn running(
    sampled: &mut Sampled,
    (observer, objectives): (&mut Observer, usize),
    setting: &Setting,
    visit: &mut dyn FnMut(Instant),
) -> Result<(), Failure> {
    let Setting { values, x0, around, .. } = setting;
    let around = around.clone().unwrap_or_default();
    let mut watch = Watch::new(observer, setting, objectives)?;
    let tau = values.get(Parameter::Tau);
    let mut changes = Changes::of(&setting.pieces, around.planned(tau));
    sampled.run_along(values, &mut |since| changes.next(since), x0, &around, &mut |sample| {
        let time_to_go = of_sample(sample.time_to_go, tau);
        let at_end = time_to_go <= 0.0 || sample.last;
        visit(watch.instant(Sample { time_to_go, ..sample }, at_end));
    })
}

/// The objectives along one run.
struct Watch<'a> {
    observer: &'a mut Observer,
    objectives: usize,
}

impl<'a> Watch<'a> {
    fn new(
        observer: &'a mut Observer,
        setting: &Setting,
        objectives: usize,
    ) -> Result<Self, Failure> {
        observer.start(&setting.values, &setting.x0)?;
        Ok(Self { observer, objectives })
    }

    fn instant(&mut self, sample: Sample<'_>, at_end: bool) -> Instant {
        let Sample { t, time_to_go, x, u, integrals, .. } = sample;
        let mut excess = vec![f64::NEG_INFINITY; self.objectives];
        let here = Here { time_to_go, x, u, integrals };
        self.observer.excess(here, at_end, &mut |i, value| excess[i] = value);
        let errors = self.observer.errors().collect();
        let [x, u, integrals] = [x, u, integrals].map(<[f64]>::to_vec);
        Instant { t, time_to_go, x, u, errors, integrals, excess, at_end }
    }
}
