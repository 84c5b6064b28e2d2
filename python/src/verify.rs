//! The campaign of a design, and its verdict.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use ptc_codegen::internal::fault;
use ptc_codegen::plot::Quantity;
use ptc_codegen::request;
use ptc_codegen::simulate::Failure;
use ptc_codegen::verify::record::{Row, hash};
use ptc_codegen::verify::{
    Campaign, Drawn, ENGINE, End, Instant, Judged, Known, Objective, Signal, Summary, Trial,
    chunks, possible, read_with_plant, sample, shard, summary, threaded,
};
use pyo3::prelude::*;
use pyo3::types::PyByteArray;

use crate::design::Design;
use crate::failure::{ended, mistake};
use crate::simulate::bytes;
use crate::watch::{self, Watch};

/// The arguments of `ptc_codegen.Objective`.
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

/// The arguments of `ptc_codegen.Trajectory`.
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

/// The arguments of `ptc_codegen.Verdict`.
#[derive(IntoPyObject)]
pub(crate) struct Verdict<'py> {
    holds: Option<bool>,
    objectives: Vec<Told>,
    text: String,
    columns: Vec<String>,
    /// The unit of each column, where it is known.
    units: Vec<Option<String>>,
    rows: Option<Bound<'py, PyByteArray>>,
    states: Vec<String>,
    inputs: Vec<String>,
    /// The unit of each state and of each input, where it is known.
    units_of_run: Vec<Option<String>>,
    worst: Option<Worst<'py>>,
}

/// The draws of a part of a campaign: the first index, the first beyond it, the hash of the campaign that they are
/// of, and their numbers.
type Part<'py> = (u64, u64, String, Bound<'py, PyByteArray>);

/// The same as it is given back.
type GivenPart = (u64, u64, String, Vec<u8>);

fn campaign(py: Python<'_>, design: &Design, given: &[(String, String)]) -> PyResult<Campaign> {
    let entries = design.with(py, given)?;
    let campaign = request::read(&entries).and_then(|spec| read_with_plant(&entries, &spec));
    campaign.map_err(|found| design.wrong(py, found))
}

/// The names of the signals of disturbances, by their numbers in a row.
#[pyfunction]
pub(crate) fn signals() -> Vec<&'static str> {
    Signal::ALL.map(Signal::name).to_vec()
}

/// What the rows of a campaign depend on.
fn identity(campaign: &Campaign) -> String {
    hash(format!("{ENGINE}\n{}", campaign.text()).as_bytes())
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
    let campaign = campaign(py, design, &given)?;
    let total = campaign.scenarios + campaign.searched();
    let work = |watch: &Watch| threaded(|| judge(&campaign, rows, watch));
    let done = watch::run(py, (progress, total), work)?;
    let (summary, kept) = done.map_err(|failure| ended(py, failure))?;
    Ok(verdict(py, &campaign, &summary, rows.then_some(&kept)))
}

/// Runs the draws of part `index` of `count` of a campaign.
#[pyfunction]
pub(crate) fn part<'py>(
    py: Python<'py>,
    design: &Design,
    given: Vec<(String, String)>,
    place: (u64, u64),
    progress: Option<Py<PyAny>>,
) -> PyResult<Part<'py>> {
    let campaign = campaign(py, design, &given)?;
    let (index, count) = place;
    let Some(range) = shard(index, count, campaign.scenarios) else {
        let message = format!("shard = ({index}, {count}) is not a part");
        let help = "give (i, n), the i-th of n parts, i from 1 to n".to_owned();
        return Err(mistake(py, "bad-value", message, help));
    };
    let work = |watch: &Watch| {
        threaded(|| {
            let mut trial = Trial::new(&campaign)?;
            possible(&campaign, &mut trial)?;
            Ok(draws((&campaign, &trial), range.clone(), true, watch).1)
        })
    };
    let done = watch::run(py, (progress, range.end - range.start), work)?;
    let rows = done.map_err(|failure| ended(py, failure))?;
    let numbers = rows.iter().flat_map(|row| row.numbers.iter().copied());
    Ok((range.start, range.end, identity(&campaign), bytes(py, numbers)))
}

/// Puts the parts of a campaign together.
#[pyfunction]
pub(crate) fn merge<'py>(
    py: Python<'py>,
    design: &Design,
    given: Vec<(String, String)>,
    mut parts: Vec<GivenPart>,
    rows: bool,
    progress: Option<Py<PyAny>>,
) -> PyResult<Verdict<'py>> {
    let campaign = campaign(py, design, &given)?;
    parts.sort_by_key(|part| part.0);
    joined(&campaign, &parts)
        .map_err(|(message, help)| mistake(py, "bad-value", message, help.to_owned()))?;
    let work = |watch: &Watch| {
        threaded(|| {
            let mut trial = Trial::new(&campaign)?;
            possible(&campaign, &mut trial)?;
            let all: Vec<_> = parts.iter().flat_map(|part| rows_of(&campaign, part)).collect();
            let mut drawn = Drawn::new(&campaign);
            all.iter().for_each(|row| drawn.add(&campaign, row));
            Ok((known((&campaign, &mut trial), &drawn, watch), all))
        })
    };
    let done = watch::run(py, (progress, campaign.searched()), work)?;
    let (summary, kept) = done.map_err(|failure| ended(py, failure))?;
    Ok(verdict(py, &campaign, &summary, rows.then_some(&kept)))
}

/// Whether parts in their order are all draws of a campaign.
fn joined(campaign: &Campaign, parts: &[GivenPart]) -> Result<(), (String, &'static str)> {
    let help =
        "give each part once, all of one division into parts, of this design, scenarios and seed";
    let identity = identity(campaign);
    let mut next = 0;
    for (start, end, of, numbers) in parts {
        let length =
            (end.saturating_sub(*start)).saturating_mul(8 * campaign.columns().len() as u64);
        if *of != identity {
            return Err((
                format!("the part from scenario {start} on is of another campaign"),
                help,
            ));
        }
        if *start != next || end < start || numbers.len() as u64 != length {
            return Err((format!("expected scenario {next}, found a part from {start} on"), help));
        }
        next = *end;
    }
    if next != campaign.scenarios {
        let message = format!("no part holds the scenarios from {next} on");
        return Err((message, help));
    }
    Ok(())
}

/// The rows of a part.
fn rows_of(campaign: &Campaign, (start, end, _, bytes): &GivenPart) -> Vec<Row> {
    let double = |bytes: &[u8]| match bytes.try_into() {
        Ok(bytes) => f64::from_ne_bytes(bytes),
        Err(_) => fault("a number of a part has no 8 bytes"),
    };
    let rows = bytes.chunks_exact(8 * campaign.columns().len());
    let numbers = |row: &[u8]| row.chunks_exact(8).map(double).collect();
    (*start..*end).zip(rows).map(|(index, row)| Row { index, numbers: numbers(row) }).collect()
}

/// A verdict as plain values.
fn verdict<'py>(
    py: Python<'py>,
    campaign: &Campaign,
    summary: &Summary,
    rows: Option<&Vec<Row>>,
) -> Verdict<'py> {
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
    let numbers =
        |rows: &Vec<Row>| bytes(py, rows.iter().flat_map(|row| row.numbers.iter().copied()));
    let of_run = Quantity::states(&campaign.spec).into_iter();
    let of_run = of_run.chain(Quantity::inputs(&campaign.spec));
    Verdict {
        holds: match summary.end() {
            End::Holds => Some(true),
            End::Fails => Some(false),
            End::Undecided => None,
        },
        objectives: campaign.objectives.iter().zip(&summary.objectives).map(Told::new).collect(),
        text: summary.text(campaign),
        columns: campaign.columns(),
        units: campaign.quantities().into_iter().map(|own| own.unit).collect(),
        rows: rows.map(numbers),
        states: campaign.spec.state_names(),
        inputs: campaign.spec.input_names(),
        units_of_run: of_run.map(|own| own.unit).collect(),
        worst,
    }
}

/// All that the command does of a campaign in one piece: its report, and the rows of its draws.
fn judge(campaign: &Campaign, keeps: bool, watch: &Watch) -> Result<(Summary, Vec<Row>), Failure> {
    let mut trial = Trial::new(campaign)?;
    possible(campaign, &mut trial)?;
    let (drawn, rows) = draws((campaign, &trial), 0..campaign.scenarios, keeps, watch);
    Ok((known((campaign, &mut trial), &drawn, watch), rows))
}

/// The draws of a range, and their rows in order where they are to be kept.
fn draws(
    (campaign, trial): (&Campaign, &Trial),
    range: Range<u64>,
    keeps: bool,
    watch: &Watch,
) -> (Drawn, Vec<Row>) {
    let total = Mutex::new((Drawn::new(campaign), Vec::new()));
    let ran = sample(campaign, trial, &chunks(range), &|chunk, rows| {
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
    (drawn, rows)
}

/// The report of a campaign whose draws are known.
fn known((campaign, trial): (&Campaign, &mut Trial), drawn: &Drawn, watch: &Watch) -> Summary {
    let known = Known::beyond(campaign, trial, &drawn.tally, &|runs| watch.tick(runs as u64));
    summary(campaign, trial, &known)
}
