//! The campaign of a design, and its verdict.

use std::sync::{Mutex, PoisonError};

use ptc_codegen::request;
use ptc_codegen::simulate::Failure;
use ptc_codegen::verify::record::Row;
use ptc_codegen::verify::{
    Campaign, Drawn, End, Instant, Judged, Known, Objective, Summary, Trial, chunks, possible,
    read_with_plant, sample, summary,
};
use pyo3::prelude::*;
use pyo3::types::PyByteArray;

use crate::design::Design;
use crate::failure::ended;
use crate::simulate::bytes;
use crate::watch::{self, Watch};

/// The arguments of `ptc.Objective`.
#[derive(IntoPyObject)]
pub(crate) struct Told {
    text: String,
    holds: Option<bool>,
    verdict: String,
    excess: f64,
    worst: String,
    details: Vec<String>,
}

impl Told {
    fn new((objective, judged): (&Objective, &Judged)) -> Self {
        Self {
            text: objective.to_string(),
            holds: match judged.verdict {
                verdict if verdict.holds() => Some(true),
                ptc_codegen::verify::Verdict::Fails => Some(false),
                _ => None,
            },
            verdict: judged.verdict(),
            excess: judged.excess,
            worst: judged.worst.clone(),
            details: judged.details.clone(),
        }
    }
}

/// The arguments of `ptc.Trajectory`.
#[derive(IntoPyObject)]
pub(crate) struct Worst<'py> {
    scenario: String,
    t: Bound<'py, PyByteArray>,
    time_to_go: Bound<'py, PyByteArray>,
    x: Bound<'py, PyByteArray>,
    u: Bound<'py, PyByteArray>,
    excess: Bound<'py, PyByteArray>,
    states: usize,
    ended: Option<String>,
}

/// The arguments of `ptc.Verdict`.
#[derive(IntoPyObject)]
pub(crate) struct Verdict<'py> {
    holds: Option<bool>,
    objectives: Vec<Told>,
    text: String,
    columns: Vec<String>,
    rows: Option<Bound<'py, PyByteArray>>,
    worst: Option<Worst<'py>>,
}

/// Runs the campaign of a design; `given` overrides values under `[verify]`.
#[pyfunction]
pub(crate) fn verify<'py>(
    py: Python<'py>,
    design: &Design,
    given: Vec<(String, String)>,
    rows: bool,
    progress: Option<Py<PyAny>>,
) -> PyResult<Verdict<'py>> {
    let entries = design.with(py, &given)?;
    let campaign = request::read(&entries).and_then(|spec| read_with_plant(&entries, &spec));
    let campaign = campaign.map_err(|found| design.wrong(py, found))?;
    let total = campaign.scenarios + campaign.searched();
    let (summary, kept) = watch::run(py, (progress, total), |watch| judge(&campaign, rows, watch))?
        .map_err(|failure| ended(py, failure))?;
    let worst = summary.trajectory.as_ref().map(|worst| {
        let each = |of: &dyn Fn(&Instant) -> f64| bytes(py, worst.instants.iter().map(of));
        let all = |of: fn(&Instant) -> &Vec<f64>| {
            bytes(py, worst.instants.iter().flat_map(|instant| of(instant).iter().copied()))
        };
        Worst {
            scenario: worst.told.clone(),
            t: each(&|instant| instant.t),
            time_to_go: each(&|instant| instant.time_to_go),
            x: all(|instant| &instant.x),
            u: all(|instant| &instant.u),
            excess: all(|instant| &instant.excess),
            states: campaign.spec.states(),
            ended: worst.ended.clone(),
        }
    });
    let numbers = || bytes(py, kept.iter().flat_map(|row| row.numbers.iter().copied()));
    Ok(Verdict {
        holds: match summary.end() {
            End::Holds => Some(true),
            End::Fails => Some(false),
            End::Undecided => None,
        },
        objectives: campaign.objectives.iter().zip(&summary.objectives).map(Told::new).collect(),
        text: summary.text(&campaign),
        columns: campaign.columns(),
        rows: rows.then(numbers),
        worst,
    })
}

/// All that the command does of a campaign in one piece: its report, and the rows of its draws.
fn judge(campaign: &Campaign, keeps: bool, watch: &Watch) -> Result<(Summary, Vec<Row>), Failure> {
    let mut trial = Trial::new(campaign)?;
    possible(campaign, &mut trial)?;
    let total = Mutex::new((Drawn::new(campaign), Vec::new()));
    let ran = sample(campaign, &trial, &chunks(0..campaign.scenarios), &|chunk, rows| {
        let mut drawn = Drawn::new(campaign);
        rows.iter().for_each(|row| drawn.add(campaign, row));
        let (all, kept) = &mut *total.lock().unwrap_or_else(PoisonError::into_inner);
        *all = std::mem::replace(all, Drawn::new(campaign)).merge(&drawn);
        if keeps {
            kept.extend(rows);
        }
        watch.add(chunk.end - chunk.start)
    });
    if ran.is_err() {
        watch.tick(0);
    }
    let (drawn, mut rows) = total.into_inner().unwrap_or_else(PoisonError::into_inner);
    rows.sort_by_key(|row| row.index);
    let known = Known::beyond(campaign, &trial, &drawn.tally, &|runs| watch.tick(runs as u64));
    Ok((summary(campaign, &mut trial, &known), rows))
}
