//! One run for one tau, kept for the CSV and the picture.

use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::diagnostic::digits;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::plant::Plant;
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{
    Accuracy, Cause, Continuous, Failure as Ended, Loop, Sample, Sampled, Values, tracking_error,
};

use super::input::Asked;
use crate::cli::report::{self, Failure, Notice};

/// A run.
pub(super) struct Run {
    pub(super) tau: f64,
    pub(super) n: usize,
    pub(super) t0: f64,
    pub(super) u_max: f64,
    /// What the checks say, where the emitted controller is in the loop.
    pub(super) report: Option<Report>,
    pub(super) rows: Vec<Row>,
    /// The tracking error in the last row, where there is a reference.
    error: Option<Vec<f64>>,
}

impl Run {
    /// A run of `spec`; `report` is that of the emitted controller.
    fn new(
        spec: &Spec,
        values: &Values,
        report: Option<&Report>,
        rows: Vec<Row>,
    ) -> Result<Self, Ended> {
        let [tau, t0, u_max] =
            [Parameter::Tau, Parameter::StartTime, Parameter::UMax].map(|p| values.get(p));
        let last = rows.last().map(|row| tracking_error(spec, values, row.t, &row.x));
        let error = last.transpose()?.flatten();
        Ok(Self { tau, n: spec.n, t0, u_max, report: report.cloned(), rows, error })
    }

    /// The tracking error in the end, in words.
    pub(super) fn tracking(&self) -> Option<String> {
        let (error, last) = (self.error.as_ref()?, self.rows.last()?);
        let one = |(i, e): (usize, &f64)| format!("e{i} = {e:.3e}");
        let all: Vec<_> = (1..).zip(error).map(one).collect();
        Some(format!("tracking error at t = {} s: {}", digits(last.t), all.join(", ")))
    }

    /// Whether u is held between the rows.
    pub(super) fn is_held(&self) -> bool {
        self.report.is_some()
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
    pub(super) u: f64,
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
            u: sample.u,
            reported,
        }
    }
}

/// Time-to-go as parts of tau: even in time, and from 0.01 on even in its logarithm down to 1e-9.
fn grid() -> Vec<f64> {
    let even = (0..200).map(|i| f64::from(200 - i) / 200.0);
    let last = (1..=140).map(|i| 10f64.powf(-2.0 - f64::from(i) / 20.0));
    even.filter(|share| *share >= 0.01).chain(last).collect()
}

/// The law at every instant, mapped back from infinite time.
pub(super) fn continuous(spec: &Spec, plant: &Plant, asked: &Asked) -> Result<Run, Failure> {
    let values = complete(spec, plant, false)?;
    let (tau, t0) = (values.get(Parameter::Tau), values.get(Parameter::StartTime));
    let mut shares = if asked.whole { grid() } else { Vec::new() };
    shares.extend(asked.at.iter().map(|(share, _)| share));
    shares.sort_by(|a, b| b.total_cmp(a));
    shares.dedup();
    let mut rows = Vec::with_capacity(shares.len());
    let mut index = 0;
    let end = Continuous::of(spec, plant).and_then(|mut run| {
        run.run(&values, &asked.x0, &shares, Accuracy::default(), &mut |sample| {
            let at = asked.at.iter().find(|(share, _)| *share == shares[index]);
            let t = at.map_or(sample.t, |(_, elapsed)| t0 + tau * elapsed);
            let reported = asked.at.is_empty() || at.is_some();
            rows.push(Row::of(Sample { t, ..sample }, reported));
            index += 1;
        })
    });
    end.map_err(|failure| ended(failure, tau))?;
    if let Some(row) = rows.iter().find(|row| !row.x.iter().chain([&row.u]).all(|v| v.is_finite()))
    {
        let title = format!("tau = {tau}: x or u leaves the range of numbers, at t = {} s", row.t);
        let help = "the loop is unstable with these values, or the gains of the law overflow so close to the deadline";
        return Err(Failure::refused(vec![Notice {
            help: Some(help.to_owned()),
            ..Notice::of(title)
        }]));
    }
    Run::new(spec, &values, None, rows).map_err(|failure| ended(failure, tau))
}

/// The emitted controller at each sample.
pub(super) fn sampled(
    spec: &Spec,
    plant: &Plant,
    asked: &Asked,
    around: &Loop,
) -> Result<Run, Failure> {
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
    // The checks set eps where a sample period or an error is promised.
    let spec = &report.spec;
    let values = complete(spec, plant, true)?;
    let tau = values.get(Parameter::Tau);
    let mut rows = Vec::new();
    let end = Sampled::new(spec, plant).and_then(|mut run| {
        run.run(&values, &asked.x0, around, &mut |sample| rows.push(Row::of(sample, true)))
    });
    end.map_err(|failure| ended(failure, tau))?;
    let refused = |row: &&Row| matches!(row.status, Status::Range | Status::Input);
    if let Some(row) = rows.iter().find(refused) {
        let (name, t) = (row.status.c_name(), row.t);
        let title = format!("tau = {tau}: step returns {name} and u = 0, first at t = {t} s");
        let help =
            "an actuator would see 0 there: see the checks of `check`, and the range of the states";
        report::print(&[Notice { warns: true, help: Some(help.to_owned()), ..Notice::of(title) }]);
    }
    Run::new(spec, &values, Some(&report), rows).map_err(|failure| ended(failure, tau))
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
            _ if symbols.contains(&parameter) => format!("--plant {name}=VALUE"),
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
