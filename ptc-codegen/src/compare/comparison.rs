//! A comparison: every controller in every scenario, and the worst of each figure.

use rayon::prelude::*;

use super::entrant::{Entrant, Entrants, Omitted};
use super::figures::{Figures, Record, measured, recorded};
use super::nominal::Nominal;
use super::soonest::{Soonest, soonest};
use crate::program::range::Range;
use crate::simulate::{Failure, Loop, Process};
use crate::verify::{Campaign, Scenario};

/// The scenarios of a comparison: the corners of a campaign, and its first draws.
#[derive(Clone, Debug)]
pub struct Scenes {
    /// All of them, corners first.
    pub all: Vec<Scenario>,
    /// Number of corners.
    pub corners: usize,
}

impl Scenes {
    /// Returns the corners of a campaign and at most `draws` draws, none where no quantity is uncertain.
    pub fn of(campaign: &Campaign, draws: u64) -> Self {
        let mut all = campaign.corners();
        let corners = all.len();
        let is_uncertain = campaign.uncertain().any(|(_, (low, high))| low < high)
            || campaign.disturbances.iter().any(|(_, (low, high), _)| low < high)
            || campaign.around.as_ref().is_some_and(Loop::is_drawn);
        if is_uncertain {
            all.extend((0..draws.min(campaign.scenarios)).map(|index| campaign.scenario(index)));
        }
        Self { all, corners }
    }
}

/// A controller and its worst figures.
#[derive(Clone, Debug)]
pub struct Row {
    /// The controller.
    pub entrant: Entrant,
    /// The worst of each figure, or why a run has none.
    pub figures: Result<Figures, Failure>,
}

/// All controllers, that of the design first.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The controllers.
    pub rows: Vec<Row>,
    /// Rivals that did not run.
    pub omitted: Vec<Omitted>,
    /// The soonest deadline from the corners of the start, with the known plant.
    pub soonest: Soonest,
    /// The scenario in which the design ends farthest from 0.
    pub worst: Scenario,
    /// Samples until the deadline.
    pub(super) samples: usize,
    process: Process,
}

impl Comparison {
    /// Runs every controller in every scenario. The rivals have the bandwidth in rad/s that is `given`, or that of the
    /// rule. `done` is called after each scenario.
    ///
    /// # Errors
    /// A design that is not supported, or whose own controller does not run.
    pub fn new(
        campaign: &Campaign,
        scenes: &Scenes,
        given: Option<f64>,
        done: &(dyn Fn() + Sync),
    ) -> Result<Self, Failure> {
        let nominal = Nominal::of(&campaign.spec)?;
        let Entrants { all, omitted } = Entrants::new(&campaign.spec, &nominal, given)?;
        let process = Process::new(&campaign.spec, &campaign.disturbed());
        let stroke = campaign.x0.first().map_or(0.0, |(low, high)| low.abs().max(high.abs()));
        let runs: Vec<Vec<_>> = scenes
            .all
            .par_iter()
            .map_init(
                || (process.clone(), all.clone()),
                |(process, all), scene| {
                    let setting = campaign.setting(scene);
                    let figures = all.iter_mut();
                    let figures = figures.map(|own| {
                        measured(process, &mut own.control, &setting, (&nominal, stroke))
                    });
                    let figures = figures.collect();
                    done();
                    figures
                },
            )
            .collect();
        let worst = farthest(&runs);
        let rows = all.into_iter().enumerate().map(|(i, entrant)| {
            let figures = runs.iter().map(|of_scene| of_scene[i].clone());
            Row { entrant, figures: figures.reduce(both).unwrap_or(Ok(Figures::default())) }
        });
        let rows: Vec<_> = rows.collect();
        if let Some(Err(failure)) = rows.first().map(|own| &own.figures) {
            return Err(failure.clone());
        }
        let soonest = soonest_of(campaign, &nominal, &scenes.all[..scenes.corners]);
        let worst = scenes.all[worst].clone();
        let samples = nominal.samples(campaign.tau.1)?;
        Ok(Self { rows, omitted, soonest, worst, samples, process })
    }

    /// Returns the run of a controller in the worst scenario of the design.
    ///
    /// # Errors
    /// A loop that leaves the range of numbers.
    pub fn record(&self, campaign: &Campaign, row: &Row) -> Result<Record, Failure> {
        let setting = campaign.setting(&self.worst);
        recorded(&mut self.process.clone(), &mut row.entrant.control.clone(), &setting)
    }
}

/// The worst of two results; a failure is the worst one.
fn both(
    one: Result<Figures, Failure>,
    other: Result<Figures, Failure>,
) -> Result<Figures, Failure> {
    Ok(one?.worst(other?))
}

/// The place of the scenario in which the first controller ends farthest from 0 in x_1.
fn farthest(runs: &[Vec<Result<Figures, Failure>>]) -> usize {
    let error = |run: &[Result<Figures, Failure>]| {
        run.first()
            .and_then(|own| own.as_ref().ok()?.error.first().copied())
            .unwrap_or(f64::INFINITY)
    };
    let all = runs.iter().map(|run| error(run)).enumerate();
    all.reduce(|a, b| if b.1 > a.1 { b } else { a }).map_or(0, |(place, _)| place)
}

/// The soonest deadline from each start, the longest of them.
fn soonest_of(campaign: &Campaign, nominal: &Nominal, corners: &[Scenario]) -> Soonest {
    corners
        .iter()
        .map(|corner| {
            let setting = campaign.setting(corner);
            let limits = setting.values.limits(&campaign.spec);
            soonest(nominal, limits.first().copied().unwrap_or(Range::ALL), &setting.x0)
        })
        .try_fold(0.0, |most: f64, time| Ok(most.max(time?)))
}
