//! Many scenarios at once: in lanes where both sides of Theorem 1 are smooth, else one by one.

use std::slice::from_ref;

use rayon::prelude::*;

use super::compiled::{Agreement, Compiled, Runner, agreement};
use super::exact::Exact;
use super::observer::{LaneObserver, Observer};
use super::samples::of_sample;
use super::settings::Settings;
use super::track::Track;
use super::trial::{ACCURACY, CLOSER, compared, is_blurred};
use super::{Campaign, Outcome, Scenario, Setting, Trial};
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::lanes::{
    DirectLanes, Instants, Job, LaneSide, RunningLanes, Sampling, StretchedLanes, run,
};
use crate::simulate::{Accuracy, Continuous, Direct, Run, Sampled};

/// Scenarios whose settings are held at a time.
pub(super) const HELD: usize = 64;

/// A loop in lanes, with the objectives.
#[derive(Clone, Debug)]
pub(super) struct InLanes {
    closed: Closed,
    observer: LaneObserver,
}

/// Loop in which a scenario is run.
#[derive(Clone, Debug)]
enum Closed {
    /// Both sides of Theorem 1.
    Theorem(Box<Sides>),
    /// The sampled loop.
    Running(Box<Running>),
}

/// The sampled loop: in lanes, or by a compiled program, where one was made.
#[derive(Clone, Debug)]
struct Running {
    lanes: RunningLanes,
    compiled: Option<Compiled>,
}

/// Both sides of Theorem 1 in lanes.
#[derive(Clone, Debug)]
struct Sides {
    stretched: StretchedLanes,
    direct: DirectLanes,
    /// The same without an integration, where the loop is linear in stretched time.
    exact: Option<Exact>,
}

impl InLanes {
    /// `None` where a loop is not smooth, or not in time alone.
    pub(super) fn of_theorem(
        (infinite, direct): (&Run<Continuous>, &Run<Direct>),
        observer: &Observer,
        campaign: &Campaign,
    ) -> Option<Self> {
        let sides = Sides {
            stretched: infinite.in_lanes()?,
            direct: direct.in_lanes()?,
            exact: Exact::of(campaign),
        };
        Some(Self { closed: Closed::Theorem(Box::new(sides)), observer: observer.in_lanes()? })
    }

    /// `None` where integrals are asked for, or an objective does not run in lanes.
    pub(super) fn of_running(
        sampled: &Sampled,
        observer: &Observer,
        campaign: &Campaign,
    ) -> Option<Self> {
        let lanes = sampled.in_lanes(!campaign.events.is_empty())?;
        let closed = Closed::Running(Box::new(Running { lanes, compiled: None }));
        Some(Self { closed, observer: observer.in_lanes()? })
    }

    /// Runs scenarios of the sampled loop by a compiled program from here on, and those of some settings both ways;
    /// `None` where the program runs none.
    pub(super) fn compiled(
        &mut self,
        mut compiled: Compiled,
        settings: &[Setting],
    ) -> Option<Agreement> {
        let Closed::Running(running) = &mut self.closed else { return None };
        let jobs = samplings(settings)?;
        let lanes = &mut running.lanes;
        let interpreted: Runner<'_> = &mut |jobs, see| Some(lanes.run(jobs, see));
        let agreement = agreement(&jobs, interpreted, &mut |jobs, see| compiled.run(jobs, see));
        running.compiled = Some(compiled);
        agreement
    }

    /// Runs scenarios in lanes again.
    pub(super) fn interpreted(&mut self) {
        if let Closed::Running(running) = &mut self.closed {
            running.compiled = None;
        }
    }

    /// Returns how the processes of a compiled program ended that scenarios ended.
    pub(super) fn faults(&self) -> Vec<String> {
        match &self.closed {
            Closed::Running(running) => {
                running.compiled.iter().flat_map(Compiled::faults).collect()
            }
            Closed::Theorem(_) => Vec::new(),
        }
    }

    /// Returns true if both sides of Theorem 1 can be run without an integration.
    pub(super) fn propagates(&self) -> bool {
        matches!(&self.closed, Closed::Theorem(sides) if sides.exact.is_some())
    }

    /// The outcomes of the scenarios that go smoothly to their end. Where the sides differ by more than `blur`, they are
    /// run again, more closely.
    fn run(&mut self, settings: &[Setting], blur: f64) -> Vec<Option<Outcome>> {
        let Self { closed, observer } = self;
        let Sides { stretched, direct, exact } = match closed {
            Closed::Theorem(sides) => &mut **sides,
            Closed::Running(own) => return own.run(observer, settings),
        };
        let mut found = match exact {
            Some(exact) => exact.run((stretched, direct), observer, settings),
            None => vec![None; settings.len()],
        };
        let mut due: Vec<_> = (0..found.len()).filter(|index| found[*index].is_none()).collect();
        for accuracy in [ACCURACY, CLOSER] {
            let others: Vec<_> = due.iter().map(|index| &settings[*index]).collect();
            let first = tracks(stretched, observer, &others, accuracy);
            let second = tracks(direct, observer, &others, accuracy);
            for (index, (first, second)) in due.into_iter().zip(first.into_iter().zip(second)) {
                let both = first.zip(second);
                found[index] = both.map(|(a, b)| compared((&a, &Ok(())), (&b, Ok(()))));
            }
            let blurred = |own: &Outcome| is_blurred(own, blur);
            let is_blurred = |index: &usize| found[*index].as_ref().is_some_and(blurred);
            due = (0..found.len()).filter(is_blurred).collect();
        }
        due.into_iter().for_each(|index| found[index] = None);
        found
    }
}

impl Running {
    fn run(&mut self, observer: &mut LaneObserver, settings: &[Setting]) -> Vec<Option<Outcome>> {
        let unknown = || vec![None; settings.len()];
        let Some(jobs) = samplings(settings) else { return unknown() };
        let both = (settings, jobs.as_slice());
        let Self { lanes, compiled } = self;
        let by_program = compiled
            .as_mut()
            .and_then(|own| running(&mut |jobs, see| own.run(jobs, see), observer, both));
        if let Some(found) = by_program {
            return found;
        }
        let in_lanes: Runner<'_> = &mut |jobs, see| Some(lanes.run(jobs, see));
        running(in_lanes, observer, both).unwrap_or_else(unknown)
    }
}

/// The settings as the loop that runs takes them.
fn samplings(settings: &[Setting]) -> Option<Vec<Sampling<'_>>> {
    fn sampling(setting: &Setting) -> Option<Sampling<'_>> {
        let Setting { values, x0, pieces, around } = setting;
        Some(Sampling { values, x0, pieces, around: around.as_ref()? })
    }
    settings.iter().map(sampling).collect()
}

/// The outcomes of the scenarios that the loop that runs takes to their end; `None` where it runs none.
fn running(
    run: Runner<'_>,
    observer: &mut LaneObserver,
    (settings, jobs): (&[Setting], &[Sampling<'_>]),
) -> Option<Vec<Option<Outcome>>> {
    let all: Vec<_> = settings.iter().collect();
    let taus: Vec<_> = settings.iter().map(|own| own.values.get(Parameter::Tau)).collect();
    let mut known = vec![true; settings.len()];
    let mut found: Vec<Option<Vec<f64>>> = vec![None; settings.len()];
    observer.forget();
    let done = run(jobs, &mut |instants: &Instants<'_>| {
        if let Some(job) = observer.meet(&all, &instants.jobs) {
            known[job] = false;
        }
        let tau = |lane: usize| instants.jobs[lane].map_or(1.0, |job| taus[job]);
        let time_to_go = Pack::of(|lane| of_sample(instants.time_to_go.0[lane], tau(lane)));
        let is_end = |lane: usize| instants.last[lane] || time_to_go.0[lane] <= 0.0;
        let last = std::array::from_fn(is_end);
        let at = Instants { last, time_to_go: &time_to_go, ..*instants };
        let worst = observer.worst(&at);
        for lane in (0..LANES).filter(|lane| instants.last[*lane]) {
            if let Some(job) = instants.jobs[lane] {
                found[job] = Some(worst.iter().map(|worst| worst.0[lane]).collect());
            }
        }
    })?;
    let all = done.into_iter().zip(known).zip(found);
    let outcome = |excess| Outcome { excess, direct: None, ended: None };
    let found = all.map(|((done, known), excess)| excess.filter(|_| done && known).map(outcome));
    Some(found.collect())
}

/// Runs one side in each scenario, and returns its track where it comes to the end.
fn tracks<'a, S: LaneSide>(
    side: &mut S,
    observer: &mut LaneObserver,
    settings: &[&'a Setting],
    accuracy: Accuracy,
) -> Vec<Option<Track>> {
    if settings.is_empty() {
        return Vec::new();
    }
    let job = |setting: &&'a Setting| Job {
        values: &setting.values,
        x0: &setting.x0,
        pieces: &setting.pieces,
    };
    let jobs: Vec<_> = settings.iter().map(job).collect();
    let of_setting = |setting: &&Setting| Track::new(setting, observer.objectives(), 0);
    let mut tracks: Vec<_> = settings.iter().map(of_setting).collect();
    let mut known = vec![true; settings.len()];
    observer.forget();
    let done = run(side, &jobs, accuracy, &mut |instants: &Instants<'_>| {
        if let Some(job) = observer.meet(settings, &instants.jobs) {
            known[job] = false;
        }
        observer
            .look(instants, &mut |job, objective, excess| tracks[job].exceed(objective, excess));
        for (lane, job) in (0..).zip(&instants.jobs) {
            if let Some(job) = job {
                let numbers = instants.x.iter().chain(instants.u).map(|pack| pack.0[lane]);
                tracks[*job].push(numbers);
            }
        }
    });
    let done = done.into_iter().zip(known).zip(tracks);
    done.map(|((done, known), track)| (done && known).then_some(track)).collect()
}

impl Trial {
    /// The outcome that a scenario has in a campaign, in whatever company.
    pub fn run_one(&mut self, setting: &Setting) -> Outcome {
        self.run_all(from_ref(setting)).pop().unwrap_or_else(|| self.run(setting))
    }

    /// The outcomes of scenarios: in lanes where they go smoothly to their end and their sides agree,
    /// else of [`run`](Self::run).
    pub fn run_all(&mut self, settings: &[Setting]) -> Vec<Outcome> {
        let mut outcomes = Vec::with_capacity(settings.len());
        for settings in settings.chunks(HELD) {
            let found = match &mut self.lanes {
                Some(lanes) => lanes.run(settings, self.blur),
                None => vec![None; settings.len()],
            };
            for (setting, found) in settings.iter().zip(found) {
                outcomes.push(found.unwrap_or_else(|| self.run(setting)));
            }
        }
        outcomes
    }
}

impl Campaign {
    /// The outcomes of scenarios in their order, on all cores. `done` is called after each.
    pub(crate) fn outcomes(
        &self,
        trial: &Trial,
        scenarios: &[Scenario],
        done: &(dyn Fn() + Sync),
    ) -> Vec<Outcome> {
        let share = scenarios.len().div_ceil(rayon::current_num_threads());
        let share = if trial.lanes.is_some() { share.clamp(1, HELD) } else { 1 };
        let all = Settings::of(self, 1);
        let part = |trial: &mut Trial, part: &[Scenario]| {
            let settings: Vec<_> = part.iter().map(|scenario| all.setting(scenario)).collect();
            let outcomes = trial.run_all(&settings);
            part.iter().for_each(|_| done());
            outcomes
        };
        let parts = scenarios.par_chunks(share).map_init(|| trial.clone(), part);
        parts.collect::<Vec<_>>().into_iter().flatten().collect()
    }
}
