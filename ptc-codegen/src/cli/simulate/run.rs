//! One run for one tau, kept for the CSV and the picture.

use crate::check::examine::{Report, examine};
use crate::diagnostic::digits;
use crate::parameter::Parameter;
use crate::plant::Plant;
use crate::request::Spec;
use crate::simulate::record::{self, Asked, Row};
use crate::simulate::{Cause, Failure as Ended, Loop, Values, tracking_error};

use crate::cli::progress::checking;
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
    /// The tracking error in the last row by its names, where there is a reference: `e2_1` is the rate of
    /// that of output 1.
    pub(super) error: Option<Vec<(String, f64)>>,
}

impl Run {
    /// A run of `spec`; `report` is that of the emitted controller, whose u may be held. From `armed` after
    /// t0 on the reference counts.
    fn new(
        (spec, values): (&Spec, &Values),
        (report, held): (Option<Report>, bool),
        rows: Vec<Row>,
        armed: f64,
    ) -> Result<Self, Failure> {
        let [tau, t0] = [Parameter::Tau, Parameter::StartTime].map(|p| values.get(p));
        let last = rows.last();
        let last = last.map(|row| tracking_error(spec, values, row.t - armed, &row.x));
        let error = last.transpose().map_err(|failure| ended(failure, tau))?.flatten();
        let (states, inputs) = (spec.state_names(), spec.input_names());
        let limits = values.limits(spec);
        let names = spec.names_of_chains().into_iter().map(|name| format!("e{name}"));
        let error = error.map(|error| names.zip(error).collect());
        let (label, mapping) = (format!("tau = {tau} s"), spec.mapping_name().to_owned());
        Ok(Self { label, mapping, tau, states, inputs, t0, limits, report, held, rows, error })
    }

    /// The tracking error in the end, in words.
    pub(super) fn tracking(&self) -> Option<String> {
        let (error, last) = (self.error.as_ref()?, self.rows.last()?);
        let all: Vec<_> = error.iter().map(|(name, e)| format!("{name} = {e:.3e}")).collect();
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

/// The law of a chain at every instant, mapped back from infinite time, or the emitted controller of a
/// model.
pub(super) fn continuous(spec: &Spec, plant: &Plant, asked: &Asked) -> Result<Run, Failure> {
    let report = spec.has_model().then(|| examined(spec));
    let spec = report.as_ref().map_or(spec, |report| &report.spec);
    let values = complete(spec, plant, report.is_some())?;
    let tau = values.get(Parameter::Tau);
    let rows = record::continuous((spec, plant), &values, asked, &mut || ())
        .map_err(|failure| ended(failure, tau))?;
    if report.is_some() {
        refused(spec, &rows, tau);
    }
    Run::new((spec, &values), (report.clone(), false), rows, 0.0)
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
    let rows = record::sampled((spec, plant), &values, (&asked.x0, around), &mut || ())
        .map_err(|failure| ended(failure, tau))?;
    refused(spec, &rows, tau);
    // In samples the time of a reference counts from there.
    let end = rows.last().map_or(0.0, |row| row.t);
    let armed = spec.sampled().map_or(0.0, |_| around.last_armed(end));
    Run::new((spec, &values), (Some(report.clone()), true), rows, armed)
}

/// The checks of the emitted controller, which set eps where a sample period or an error is promised;
/// warns of what they refuse.
fn examined(spec: &Spec) -> Report {
    let report = checking(|| examine(spec));
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
    if let Some(row) = rows.iter().find(|row| row.is_refused()) {
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
