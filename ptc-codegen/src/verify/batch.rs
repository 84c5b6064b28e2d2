//! Many scenarios at once: in lanes where both sides of Theorem 1 are smooth, else one by one.

use std::slice::from_ref;

use rayon::prelude::*;

use super::exact::Exact;
use super::observer::{LaneObserver, Observer};
use super::trial::{ACCURACY, Track, compared, is_blurred};
use super::{Campaign, Outcome, Scenario, Setting, Trial};
use crate::simulate::lanes::{DirectLanes, Instants, Job, LaneSide, StretchedLanes, run};
use crate::simulate::{Continuous, Direct, Run};

/// Scenarios whose settings are held at a time.
pub(super) const HELD: usize = 64;

/// Both sides of Theorem 1 in lanes, with the objectives.
#[derive(Clone, Debug)]
pub(super) struct InLanes {
    stretched: StretchedLanes,
    direct: DirectLanes,
    observer: LaneObserver,
    /// The same without an integration, where the loop is linear in stretched time.
    pub(super) exact: Option<Exact>,
}

impl InLanes {
    /// `None` where a loop is not smooth, or not in time alone.
    pub(super) fn of(
        (infinite, direct): (&Run<Continuous>, &Run<Direct>),
        observer: &Observer,
        campaign: &Campaign,
    ) -> Option<Self> {
        Some(Self {
            exact: Exact::of(campaign),
            stretched: infinite.in_lanes()?,
            direct: direct.in_lanes()?,
            observer: observer.in_lanes()?,
        })
    }

    /// The outcomes of the scenarios that go smoothly to their end on both sides.
    fn run(&mut self, settings: &[Setting]) -> Vec<Option<Outcome>> {
        let Self { stretched, direct, observer, exact } = self;
        let mut found = match exact {
            Some(exact) => exact.run((stretched, direct), observer, settings),
            None => vec![None; settings.len()],
        };
        let left: Vec<_> = (0..settings.len()).filter(|index| found[*index].is_none()).collect();
        let others: Vec<_> = left.iter().map(|index| &settings[*index]).collect();
        let first = tracks(stretched, observer, &others);
        let second = tracks(direct, observer, &others);
        for (index, (first, second)) in left.into_iter().zip(first.into_iter().zip(second)) {
            let both = first.zip(second);
            found[index] = both.map(|(a, b)| compared((&a, &Ok(())), (&b, Ok(()))));
        }
        found
    }
}

/// What one side gives in each scenario that it takes to its end.
fn tracks<'a, S: LaneSide>(
    side: &mut S,
    observer: &mut LaneObserver,
    settings: &[&'a Setting],
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
    let done = run(side, &jobs, ACCURACY, &mut |instants: &Instants<'_>| {
        if let Some(job) = observer.meet(settings, &instants.jobs) {
            known[job] = false;
        }
        observer
            .look(instants, &mut |job, objective, excess| tracks[job].exceed(objective, excess));
        for (lane, job) in (0..).zip(&instants.jobs) {
            if let Some(job) = job {
                let numbers = instants.x.iter().chain([instants.u]).map(|pack| pack.0[lane]);
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
                Some(lanes) => lanes.run(settings),
                None => vec![None; settings.len()],
            };
            for (setting, found) in settings.iter().zip(found) {
                let found = found.filter(|outcome| !is_blurred(outcome, self.blur));
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
        let part = |trial: &mut Trial, part: &[Scenario]| {
            let settings: Vec<_> = part.iter().map(|scenario| self.setting(scenario)).collect();
            let outcomes = trial.run_all(&settings);
            part.iter().for_each(|_| done());
            outcomes
        };
        let parts = scenarios.par_chunks(share).map_init(|| trial.clone(), part);
        parts.collect::<Vec<_>>().into_iter().flatten().collect()
    }
}
