//! One run for one tau, kept for the CSV and the picture.

use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::diagnostic::digits;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::plant::Plant;
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{
    Accuracy, Cause, Continuous, Direct, Failure as Ended, Loop, Run as Instants, Sample, Sampled,
    Side, Values, grid, tracking_error,
};

use super::input::Asked;
use crate::cli::report::{self, Failure, Notice};

/// A run.
pub(super) struct Run {
    /// What tells it from the others.
    pub(super) label: String,
    pub(super) mapping: String,
    pub(super) tau: f64,
    /// The names of the states and of the inputs of the plant.
    pub(super) states: Vec<String>,
    pub(super) inputs: Vec<String>,
    pub(super) t0: f64,
    /// Bound of |u| of each input.
    pub(super) limits: Vec<f64>,
    /// What the checks say, where the emitted controller is in the loop.
    pub(super) report: Option<Report>,
    /// Whether u is held between the rows.
    pub(super) held: bool,
    pub(super) rows: Vec<Row>,
    /// The tracking error in the last row, where there is a reference.
    pub(super) error: Option<Vec<f64>>,
}

impl Run {
    /// A run of `spec`; `report` is that of the emitted controller, whose u may be held.
    fn new(
        (spec, values): (&Spec, &Values),
        (report, held): (Option<Report>, bool),
        rows: Vec<Row>,
    ) -> Result<Self, Failure> {
        let [tau, t0] = [Parameter::Tau, Parameter::StartTime].map(|p| values.get(p));
        let last = rows.last().map(|row| tracking_error(spec, values, row.t, &row.x));
        let error = last.transpose().map_err(|failure| ended(failure, tau))?.flatten();
        let (states, inputs) = (spec.state_names(), spec.input_names());
        let limits = values.limits(spec);
        let (label, mapping) = (format!("tau = {tau} s"), spec.mapping_name().to_owned());
        Ok(Self { label, mapping, tau, states, inputs, t0, limits, report, held, rows, error })
    }

    /// The tracking error in the end, in words.
    pub(super) fn tracking(&self) -> Option<String> {
        let (error, last) = (self.error.as_ref()?, self.rows.last()?);
        let one = |(i, e): (usize, &f64)| format!("e{i} = {e:.3e}");
        let all: Vec<_> = (1..).zip(error).map(one).collect();
        Some(format!("tracking error at t = {} s: {}", digits(last.t), all.join(", ")))
    }

    /// The columns of the CSV after tau and t. Only a sampled loop measures.
    pub(super) fn columns(&self) -> Vec<String> {
        let mut columns = self.states.clone();
        columns.extend(self.inputs.iter().cloned());
        if let (true, Some(row)) = (self.held, self.rows.first()) {
            columns.extend((1..=row.measured.len()).map(|j| format!("y{j}")));
            columns.push("status".to_owned());
        }
        columns
    }
}

/// An instant of it.
pub(super) struct Row {
    pub(super) t: f64,
    pub(super) stretched: f64,
    pub(super) x: Vec<f64>,
    /// The measurement and the status of `step`.
    pub(super) measured: Vec<f64>,
    pub(super) status: Status,
    pub(super) u: Vec<f64>,
    /// Whether the CSV holds it.
    pub(super) reported: bool,
}

impl Row {
    fn of(sample: Sample<'_>, reported: bool) -> Self {
        Self {
            t: sample.t,
            stretched: sample.stretched,
            x: sample.x.to_vec(),
            measured: sample.measured.to_vec(),
            status: sample.status,
            u: sample.u.to_vec(),
            reported,
        }
    }
}

/// The law of a chain at every instant, mapped back from infinite time, or the emitted controller of a
/// model.
pub(super) fn continuous(spec: &Spec, plant: &Plant, asked: &Asked) -> Result<Run, Failure> {
    if !spec.has_model() {
        let values = complete(spec, plant, false)?;
        let rows = along(Continuous::of(spec, plant), &values, asked)?;
        return Run::new((spec, &values), (None, false), rows);
    }
    let report = examined(spec);
    let spec = &report.spec;
    let values = complete(spec, plant, true)?;
    let rows = along(Direct::of(spec, plant), &values, asked)?;
    refused(spec, &rows, values.get(Parameter::Tau));
    Run::new((spec, &values), (Some(report.clone()), false), rows)
}

/// The rows of a run in which the control acts at every instant.
fn along<S: Side>(
    run: Result<Instants<S>, Ended>,
    values: &Values,
    asked: &Asked,
) -> Result<Vec<Row>, Failure> {
    let (tau, t0) = (values.get(Parameter::Tau), values.get(Parameter::StartTime));
    let mut shares = if asked.whole { grid() } else { Vec::new() };
    shares.extend(asked.at.iter().map(|(share, _)| share));
    shares.sort_by(|a, b| b.total_cmp(a));
    shares.dedup();
    let mut rows = Vec::with_capacity(shares.len());
    let mut index = 0;
    let end = run.and_then(|mut run| {
        run.run(values, &asked.x0, &shares, Accuracy::default(), &mut |sample| {
            let at = asked.at.iter().find(|(share, _)| *share == shares[index]);
            let t = at.map_or(sample.t, |(_, elapsed)| t0 + tau * elapsed);
            let reported = asked.at.is_empty() || at.is_some();
            rows.push(Row::of(Sample { t, ..sample }, reported));
            index += 1;
        })
    });
    end.map_err(|failure| ended(failure, tau))?;
    let finite = |row: &&Row| row.x.iter().chain(&row.u).all(|v| v.is_finite());
    if let Some(row) = rows.iter().find(|row| !finite(row)) {
        let title = format!("tau = {tau}: x or u leaves the range of numbers, at t = {} s", row.t);
        let help = "the loop is unstable with these values, or the gains of the law overflow so close to the deadline";
        return Err(Failure::refused(vec![Notice {
            help: Some(help.to_owned()),
            ..Notice::of(title)
        }]));
    }
    Ok(rows)
}

/// The emitted controller at each sample.
pub(super) fn sampled(
    spec: &Spec,
    plant: &Plant,
    asked: &Asked,
    around: &Loop,
) -> Result<Run, Failure> {
    let report = examined(spec);
    let spec = &report.spec;
    let values = complete(spec, plant, true)?;
    let tau = values.get(Parameter::Tau);
    let mut rows = Vec::new();
    let end = Sampled::new(spec, plant).and_then(|mut run| {
        run.run(&values, &asked.x0, around, &mut |sample| rows.push(Row::of(sample, true)))
    });
    end.map_err(|failure| ended(failure, tau))?;
    refused(spec, &rows, tau);
    Run::new((spec, &values), (Some(report.clone()), true), rows)
}

/// The checks of the emitted controller, which set eps where a sample period or an error is promised;
/// warns of what they refuse.
fn examined(spec: &Spec) -> Report {
    let report = examine(spec);
    let warned: Vec<_> = report
        .refusals()
        .map(|outcome| Notice {
            warns: true,
            help: outcome.fix.clone(),
            ..Notice::of(format!(
                "the check {} refuses the design: {}",
                outcome.name, outcome.summary
            ))
        })
        .collect();
    report::print(&warned);
    report
}

/// Warns of the first call that is refused.
fn refused(spec: &Spec, rows: &[Row], tau: f64) {
    let refused = |row: &&Row| matches!(row.status, Status::Range | Status::Input);
    if let Some(row) = rows.iter().find(refused) {
        let (name, t) = (row.status.c_name(), row.t);
        let title = format!("tau = {tau}: step returns {name} and u = 0, first at t = {t} s");
        let help = match spec.coupled {
            None => {
                "an actuator would see 0 there: see the checks of `check`, and the range of the states"
            }
            Some(_) => {
                "every actuator would see 0 there, as in a state in which the inputs do not decouple the outputs: see the checks of `check`, and the range of the states"
            }
        };
        report::print(&[Notice { warns: true, help: Some(help.to_owned()), ..Notice::of(title) }]);
    }
}

/// What a run needs and lacks, all at once.
fn complete(spec: &Spec, plant: &Plant, emitted: bool) -> Result<Values, Failure> {
    let values = Values::of(spec, plant);
    let missing = values.missing(spec, plant, emitted);
    if missing.is_empty() {
        return Ok(values);
    }
    let symbols = plant.symbols(spec);
    let (mut names, mut flags) = (Vec::<String>::new(), Vec::<String>::new());
    for parameter in missing {
        let name = parameter.spelling();
        let flag = match parameter {
            Parameter::Tau | Parameter::StartTime | Parameter::UMax => {
                format!("--{name} VALUE").replace('_', "-")
            }
            // A sample period is given, and eps does not follow from it.
            Parameter::Eps => "--eps VALUE".to_owned(),
            Parameter::Gain(_) => "--gains or --poles".to_owned(),
            Parameter::Samples => "--tau VALUE".to_owned(),
            Parameter::SampleTime => "--sample-time VALUE".to_owned(),
            _ if symbols.contains(&parameter) || plant.gives(parameter) => {
                format!("--plant {name}=VALUE")
            }
            _ => format!("--param {name}=VALUE"),
        };
        names.push(name);
        if !flags.contains(&flag) {
            flags.push(flag);
        }
    }
    let (verb, one) = if names.len() == 1 { ("has", "a value") } else { ("have", "values") };
    let title =
        format!("{} {verb} no value in the design, and a run needs {one}", names.join(", "));
    Err(Failure::because(title, &format!("give {}", flags.join(", "))))
}

/// Why a run ended early, with the tau of the run.
fn ended(failure: Ended, tau: f64) -> Failure {
    let title = match failure.cause {
        Cause::Unfinished => format!("undecided: tau = {tau}: {}", failure.message),
        Cause::Input | Cause::Range => format!("tau = {tau}: {}", failure.message),
    };
    let notices = vec![Notice { help: Some(failure.help), ..Notice::of(title) }];
    match failure.cause {
        Cause::Input => Failure::bad_input(notices),
        Cause::Range => Failure::refused(notices),
        Cause::Unfinished => Failure::undecided(notices),
    }
}
