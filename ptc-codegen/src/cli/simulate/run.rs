//! One run for one tau, written to the CSV and kept for the picture.

use crate::check::examine::{Report, examine_resolved};
use crate::check::resolved::Resolved;
use crate::diagnostic::digits;
use crate::parameter::Parameter;
use crate::plant::Plant;
use crate::plot::Drawn;
use crate::program::range::Range;
use crate::request::Spec;
use crate::simulate::kept::Kept;
use crate::simulate::record::{self, Asked, Row};
use crate::simulate::{Cause, Failure as Ended, Loop, Values, tracking_error};

use super::csv::{Common, Csv};
use crate::cli::progress::{checking, progress};
use crate::cli::report::{self, Failure, Notice};

/// Rows between two reports of progress.
const COUNTED: u64 = 1 << 12;

/// A run.
pub(super) struct Run {
    /// Label that distinguishes it from the others.
    pub(super) label: String,
    pub(super) mapping: String,
    pub(super) tau: f64,
    /// The names of the states and of the inputs of the plant.
    pub(super) states: Vec<String>,
    pub(super) inputs: Vec<String>,
    pub(super) t0: f64,
    /// Limits of each input.
    pub(super) limits: Vec<Range>,
    /// Results of the checks, where the emitted controller is in the loop.
    pub(super) report: Option<Report>,
    /// True if u is held between the rows.
    pub(super) held: bool,
    pub(super) kept: Kept,
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
        kept: Kept,
        armed: f64,
    ) -> Result<Self, Failure> {
        let [tau, t0] = [Parameter::Tau, Parameter::StartTime].map(|p| values.get(p));
        let last = kept.last();
        let last = last.map(|row| tracking_error(spec, values, row.t - armed, &row.x));
        let error = last.transpose().map_err(|failure| ended(failure, tau))?.flatten();
        let (states, inputs) = (spec.state_names(), spec.input_names());
        let limits = values.limits(spec);
        let names = spec.names_of_chains().into_iter().map(|name| format!("e{name}"));
        let error = error.map(|error| names.zip(error).collect());
        let (label, mapping) = (Drawn::label(tau), spec.mapping_name().to_owned());
        Ok(Self { label, mapping, tau, states, inputs, t0, limits, report, held, kept, error })
    }

    /// The tracking error in the end, in words.
    pub(super) fn tracking(&self) -> Option<String> {
        let (error, last) = (self.error.as_ref()?, self.kept.last()?);
        let all: Vec<_> = error.iter().map(|(name, e)| format!("{name} = {e:.3e}")).collect();
        Some(format!("tracking error at t = {} s: {}", digits(last.t), all.join(", ")))
    }
}

/// Sink of the rows of a run.
struct Taken<'a> {
    csv: &'a mut Csv,
    tau: f64,
    names: [Vec<String>; 2],
    held: bool,
    /// Number of measured values.
    measured: usize,
    kept: Kept,
}

impl<'a> Taken<'a> {
    fn new(csv: &'a mut Csv, spec: &Spec, values: &Values, held: bool) -> Self {
        let (tau, names) = (values.get(Parameter::Tau), [spec.state_names(), spec.input_names()]);
        csv.next_run();
        let (measured, kept) = (spec.measurements(), Kept::new(values.limits(spec)));
        Self { csv, tau, names, held, measured, kept }
    }

    fn take(&mut self, row: Row) {
        let Self { csv, tau, names, held, measured, kept } = self;
        csv.take(&Common { tau: *tau, names, held: *held, measured: *measured }, &row);
        kept.take(row);
    }
}

/// The law of a chain at every instant, mapped back from infinite time, or the emitted controller of a
/// model.
pub(super) fn continuous(
    (resolved, spec): (&Resolved, &Spec),
    plant: &Plant,
    asked: &Asked,
    csv: &mut Csv,
) -> Result<Run, Failure> {
    let report = spec.has_model().then(|| examined(resolved, spec));
    let values = complete(spec, plant, report.is_some())?;
    let mut taken = Taken::new(csv, spec, &values, false);
    record::continuous((spec, plant), &values, asked, &mut |row| taken.take(row))
        .map_err(|failure| ended(failure, taken.tau))?;
    refused(spec, &taken.kept, taken.tau);
    Run::new((spec, &values), (report.clone(), false), taken.kept, 0.0)
}

/// The emitted controller at each sample.
pub(super) fn sampled(
    (resolved, spec): (&Resolved, &Spec),
    plant: &Plant,
    asked: &Asked,
    around: &Loop,
    csv: &mut Csv,
) -> Result<Run, Failure> {
    let report = examined(resolved, spec);
    let values = complete(spec, plant, true)?;
    let mut taken = Taken::new(csv, spec, &values, true);
    let bar = progress("simulating", around.samples(taken.tau));
    let mut count = 0;
    let mut take = |row| {
        taken.take(row);
        count += 1;
        if count % COUNTED == 0 {
            bar.inc(COUNTED);
        }
    };
    let run = record::sampled((spec, plant), &values, (&asked.x0, around), &mut take);
    run.map_err(|failure| ended(failure, taken.tau))?;
    drop(bar);
    refused(spec, &taken.kept, taken.tau);
    // In samples the time of a reference counts from there.
    let end = taken.kept.last().map_or(0.0, |row| row.t);
    let armed = spec.sampled().map_or(0.0, |_| around.last_armed(end));
    Run::new((spec, &values), (Some(report.clone()), true), taken.kept, armed)
}

/// The checks of the emitted controller, whose design runs as `spec`; warns of what they refuse.
fn examined(resolved: &Resolved, spec: &Spec) -> Report {
    let report = checking(|| examine_resolved(resolved.clone(), None));
    let report = Report { spec: spec.clone(), ..report };
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
fn refused(spec: &Spec, kept: &Kept, tau: f64) {
    if let Some((status, t)) = kept.refused {
        let name = status.c_name();
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

/// Returns the values that a run needs; reports all missing ones at once.
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
            Parameter::Tau | Parameter::StartTime | Parameter::UMax | Parameter::UMin => {
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
    let help = format!("give {}", flags.join(", "));
    let of_plant = flags.iter().any(|flag| flag.starts_with("--plant"));
    let states = match of_plant && !spec.has_model() {
        true => {
            format!("; the states in plant.f and plant.g are {}", spec.state_names().join(", "))
        }
        false => String::new(),
    };
    Err(Failure::because(title, &(help + &states)))
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
