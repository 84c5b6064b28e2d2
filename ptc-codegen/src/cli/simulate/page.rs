//! The report of the runs.

use crate::check::examine::{Report, examine_resolved};
use crate::check::resolved::Resolved;
use crate::parameter::{Fixed, Parameter};
use crate::plant::{self, Plant};
use crate::request::Spec;
use crate::simulate::record::Row;

use super::args::Simulate;
use super::merit;
use super::picture::figure;
use super::run::Run;
use crate::cli::page::{self, Content, Section, Svg, Table, command, reporting, short};
use crate::cli::progress::checking;
use crate::cli::report::Failure;
use crate::cli::source::Source;

/// Instants of a run that are shown by default.
const SHOWN: usize = 12;

/// The design of the last run, which draws all of them.
pub(super) struct Drawn {
    /// The request, before anything was chosen.
    pub(super) requested: Spec,
    pub(super) resolved: Resolved,
    /// The resolved design as it runs, with several axes as one plant.
    pub(super) spec: Spec,
    pub(super) plant: Plant,
}

/// The page.
pub(super) fn text(
    request: &Simulate,
    source: &Source,
    drawn: &Drawn,
    runs: &[Run],
) -> Result<String, Failure> {
    let Drawn { requested, resolved, spec, plant } = drawn;
    let of_design = |resolved: Resolved, joined: &dyn Fn(&Spec) -> Spec| {
        let report = checking(|| examine_resolved(resolved, None));
        Report { spec: joined(&report.spec), ..report }
    };
    let differ = runs.windows(2).any(|pair| pair[0].tau.to_bits() != pair[1].tau.to_bits());
    let report = match runs {
        [Run { report: Some(report), .. }] => report.clone(),
        _ if differ => {
            // One controller made all of them: the one that takes tau at run time.
            let mut open = requested.clone();
            open.fixed.remove(&Parameter::Tau);
            let resolved = checking(|| Resolved::of(&open));
            of_design(resolved, &|own| plant::as_one(own.clone(), None).0)
        }
        _ => of_design(resolved.clone(), &|_| spec.clone()),
    };
    let spec = &report.spec;
    let seed = (request.seed != 0).then(|| request.seed.to_string());
    let mut flags: Vec<_> = request.x0.iter().map(|x0| ("--x0", Some(x0.clone()))).collect();
    flags.extend([
        ("--at-fraction", request.at_fraction.clone()),
        ("--at-time", request.at_time.clone()),
        ("--seed", seed),
    ]);
    flags.extend([("--until", request.until.clone()), ("--arm-at", request.arm_at.clone())]);
    flags.push(("--log", request.log.then(String::new)));
    let content = Content {
        spec,
        report: &report,
        plant,
        source,
        command: reporting(&command("simulate", spec, source, &flags), spec),
        section: section(request, spec, runs)?,
    };
    page::html(&content)
}

fn section(request: &Simulate, spec: &Spec, runs: &[Run]) -> Result<Section, Failure> {
    let held = runs.iter().any(|run| run.held);
    let how = match (held, spec.has_model()) {
        (true, _) => "The emitted controller at each sample; its u is held until the next.",
        (false, true) => {
            "The emitted controller at every instant, down to T = 1e-9 tau; its gains are held from eps on."
        }
        (false, false) => {
            "The law at every instant: the associated infinite-time system [th:1-4] is integrated and \
             mapped back by [th:1-7], down to T = 1e-9 tau."
        }
    };
    let mut told = vec![how.to_owned()];
    if held {
        told.extend(around(request, spec));
    }
    let starts: Vec<_> =
        request.x0.iter().map(|x0| format!("({})", x0.replace(',', ", "))).collect();
    told.push(format!("The state at the start is x0 = {}.", starts.join(", ")));
    if request.at_fraction.is_none() && request.at_time.is_none() {
        told.push(format!("The table has {SHOWN} instants of a run at most; `-o` writes all."));
    }
    let drawn = figure(spec, runs, request.log);
    Ok(Section {
        title: "Simulation",
        told,
        verdicts: Vec::new(),
        caption: drawn.caption(),
        figure: Svg::of(&drawn)?,
        table: table(request.at_fraction.is_some() || request.at_time.is_some(), runs),
        parts: vec![merit::part(runs)],
    })
}

/// Describes the surroundings of the controller in a sampled loop.
fn around(request: &Simulate, spec: &Spec) -> Option<String> {
    let period = spec.promises.sample_time.as_ref()?;
    let mut parts = vec![format!("The sample period is {period} s")];
    let list =
        |bounds: &[Fixed]| bounds.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let promises = &spec.promises;
    if !promises.noise.is_empty() {
        let bounds = list(&promises.noise);
        parts.push(format!("measurement noise: uniform, +-{bounds} (seed {})", request.seed));
    }
    if !promises.noise_rms.is_empty() {
        let rms = list(&promises.noise_rms);
        parts.push(format!("random measurement noise: {rms} rms (seed {})", request.seed));
    }
    if !promises.sensor_step.is_empty() {
        parts.push(format!("sensor steps: {}", list(&promises.sensor_step)));
    }
    parts.extend(promises.u_step.as_ref().map(|step| format!("actuator step: {step}")));
    if let [least, most] = promises.g_error.as_slice() {
        let seed = request.seed;
        parts.push(format!("u acts {least} to {most} times as strong, constant (seed {seed})"));
    }
    parts.extend(
        promises.jitter.as_ref().map(|jitter| {
            format!("samples up to {jitter} s early or late (seed {})", request.seed)
        }),
    );
    parts.extend(request.until.as_ref().map(|until| format!("until {until} s after t0")));
    parts.extend(request.arm_at.as_ref().map(|at| format!("armed again at {at} s after t0")));
    parts.extend(promises.delay.as_ref().map(|delay| format!("delay in samples: {delay}")));
    Some(format!("{}.", parts.join(", ")))
}

fn table(asked: bool, runs: &[Run]) -> Table {
    let mut head = vec!["tau in s".to_owned(), "t in s".to_owned()];
    for run in runs.iter().take(1) {
        head.extend(run.states.iter().chain(&run.inputs).cloned());
    }
    let mut rows = Vec::new();
    for run in runs {
        let shown = if asked { run.kept.reported().collect() } else { run.kept.spread(SHOWN) };
        let line = |row: &Row| {
            let numbers = [run.tau, row.t].into_iter().chain(row.x.iter().copied());
            numbers.chain(row.u.iter().copied()).map(short).collect()
        };
        rows.extend(shown.into_iter().map(line));
    }
    Table { head, rows }
}
