//! One closed loop of a design with its plant.

use ptc_codegen::check::examine::{Report, examine_resolved};
use ptc_codegen::check::resolved::Resolved;
use ptc_codegen::internal::guarded;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::plant::{self, Plant};
use ptc_codegen::plot::Quantity;
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::record::{self, Asked, Row, instant};
use ptc_codegen::simulate::{Change, Event, Failure, Loop, Values, grid, tracking_error};
use ptc_codegen::syntax::number;
use pyo3::prelude::*;
use pyo3::types::PyByteArray;

use crate::design::Design;
use crate::failure::{ended, internal, mistake};
use crate::watch;

/// Doubles as NumPy reads them from a buffer.
pub(crate) fn bytes<'py>(
    py: Python<'py>,
    numbers: impl IntoIterator<Item = f64>,
) -> Bound<'py, PyByteArray> {
    let bytes: Vec<u8> = numbers.into_iter().flat_map(f64::to_ne_bytes).collect();
    PyByteArray::new(py, &bytes)
}

/// The arguments of `ptc_codegen.Run`, and what it warns of.
#[derive(IntoPyObject)]
pub(crate) struct Told<'py> {
    tau: f64,
    t0: f64,
    states: Vec<String>,
    inputs: Vec<String>,
    /// The unit of each state and of each input, where it is known.
    units: Vec<Option<String>>,
    t: Bound<'py, PyByteArray>,
    stretched: Bound<'py, PyByteArray>,
    x: Bound<'py, PyByteArray>,
    u: Bound<'py, PyByteArray>,
    /// Of the sampled loop.
    y: Option<Bound<'py, PyByteArray>>,
    /// Where the emitted controller is in the loop.
    status: Option<Vec<i8>>,
    error: Option<Vec<f64>>,
    warnings: Vec<String>,
}

/// What is run.
struct Course {
    spec: Spec,
    plant: Plant,
    values: Values,
    asked: Asked,
    around: Option<Loop>,
}

/// The rows that were asked for, a column each: a row by itself takes several times as much memory.
#[derive(Default)]
struct Kept {
    t: Vec<f64>,
    stretched: Vec<f64>,
    x: Vec<f64>,
    u: Vec<f64>,
    measured: Vec<f64>,
    status: Vec<i8>,
    /// The first call that is refused, of all rows, and when.
    refused: Option<(Status, f64)>,
    /// Time and state of the last row.
    last: Option<(f64, Vec<f64>)>,
}

impl Kept {
    fn take(&mut self, row: Row) {
        if row.is_refused() {
            self.refused.get_or_insert((row.status, row.t));
        }
        if row.reported {
            self.t.push(row.t);
            self.stretched.push(row.stretched);
            self.x.extend(&row.x);
            self.u.extend(&row.u);
            self.measured.extend(&row.measured);
            self.status.push(row.status as i8);
        }
        self.last = Some((row.t, row.x));
    }
}

/// Runs the closed loop of a design from `x0`.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub(crate) fn simulate<'py>(
    py: Python<'py>,
    design: &Design,
    x0: Vec<f64>,
    at: Option<Vec<f64>>,
    seed: u64,
    until: Option<f64>,
    arm_at: Vec<f64>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Told<'py>> {
    let spec = &design.spec;
    let knows = spec.needs_law("simulate").and_then(|()| spec.needs_known_reference("simulate"));
    knows.map_err(|found| design.wrong(py, found))?;
    // The emitted controller, with what the checks choose where the design leaves it open.
    let resolved =
        py.detach(|| guarded(|| Resolved::of(spec))).map_err(|fault| internal(&fault))?;
    let (spec, plant) = plant::as_one(resolved.spec.clone(), design.plant.clone());
    let spec = &spec;
    let plant = plant.unwrap_or_else(|| Plant::own(spec));
    let wrong = |message: String, help: &str| mistake(py, "bad-value", message, help.to_owned());
    let between = at.is_some() && !design.gives("sample_time");
    let around = around((spec, between), (seed, until, arm_at), &wrong)?;
    if let (Some(_), Some(_)) = (&at, &around) {
        let help = "the sampled loop reports every sample: leave `at` out";
        return Err(wrong("`at` gives instants between the samples".to_owned(), help));
    }
    let asked = asked(spec, (x0, at.as_deref()), &wrong)?;
    let emitted = around.is_some() || spec.has_model();
    let report = match emitted {
        true => {
            let report = py.detach(|| guarded(|| examine_resolved(resolved, None)));
            Some(report.map_err(|fault| internal(&fault))?)
        }
        false => None,
    };
    let values = Values::of(spec, &plant);
    let missing = values.missing(spec, &plant, emitted);
    if !missing.is_empty() {
        let names: Vec<_> = missing.iter().map(|parameter| parameter.spelling()).collect();
        let message = format!("a run needs a value for {}", names.join(", "));
        let help = "give them in the design, or as arguments of `Design`: tau=0.5, gains=[12, 7], params={\"a\": 2}, plant={\"damping\": 0.4}";
        return Err(mistake(py, "missing-value", message, help.to_owned()));
    }
    let course = Course { spec: spec.clone(), plant, values, asked, around };
    let (kept, error) = watch::run(py, (progress, course.rows()), |watch| course.run(watch))?
        .map_err(|failure| ended(py, failure))?;
    let held = course.around.is_some();
    let warnings = warnings(report.as_ref(), kept.refused);
    let Kept { t, stretched, x, u, measured, status, .. } = kept;
    let quantities = Quantity::states(spec).into_iter().chain(Quantity::inputs(spec));
    Ok(Told {
        tau: course.values.get(Parameter::Tau),
        t0: course.values.get(Parameter::StartTime),
        states: spec.state_names(),
        inputs: spec.input_names(),
        units: quantities.map(|own| own.unit).collect(),
        t: bytes(py, t),
        stretched: bytes(py, stretched),
        x: bytes(py, x),
        u: bytes(py, u),
        y: held.then(|| bytes(py, measured)),
        status: emitted.then_some(status),
        error,
        warnings,
    })
}

/// The sampled loop, if a run of the design is one.
fn around(
    (spec, between): (&Spec, bool),
    (seed, until, arm_at): (u64, Option<f64>, Vec<f64>),
    wrong: &dyn Fn(String, &str) -> PyErr,
) -> PyResult<Option<Loop>> {
    let Some(asked) = Loop::asked(spec, between) else {
        if until.is_some() || !arm_at.is_empty() {
            let help = "give `Design` a sample_time, or a clock in samples: the law itself ends at the deadline, where its gains are infinite";
            return Err(wrong("`until` and `arm_at` need the sampled loop".to_owned(), help));
        }
        return Ok(None);
    };
    let Some(around) = Loop::of(spec) else {
        let message = format!("`{asked}` needs the sampled loop, which has no sample period");
        return Err(wrong(message, "give `Design` a sample_time"));
    };
    if until.is_some_and(|end| !(end > 0.0 && end.is_finite())) {
        return Err(wrong("`until` is not one time > 0".to_owned(), "give a time after t0, in s"));
    }
    if arm_at.iter().any(|t| !(*t >= 0.0 && t.is_finite())) {
        return Err(wrong(
            "`arm_at` holds a time before t0".to_owned(),
            "give times after t0, in s",
        ));
    }
    let arm = |at| Event { at, change: Change::Arm };
    let events = arm_at.into_iter().map(arm).collect();
    let around = Loop { seed, until, events, ..around };
    match around.too_long(spec) {
        Some(message) => Err(wrong(message, "give `Design` a longer sample_time")),
        None => Ok(Some(around)),
    }
}

fn asked(
    spec: &Spec,
    (x0, at): (Vec<f64>, Option<&[f64]>),
    wrong: &dyn Fn(String, &str) -> PyErr,
) -> PyResult<Asked> {
    let states = spec.state_names();
    if x0.len() != states.len() || x0.iter().any(|x| !x.is_finite()) {
        let message = format!("x0 is not {} finite numbers", states.len());
        let help = format!("give one for each of {}", states.join(", "));
        return Err(wrong(message, &help));
    }
    let share = |fraction: &f64| {
        // The shortest decimal number that reads as the double, as it is typed on a command line.
        let exact = number(&format!("{fraction:?}"));
        exact.and_then(|exact| instant(exact.number()?)).ok_or_else(|| {
            let help = "0 is the start, and 1 the deadline, where the gains are infinite; 0.999999999 is as near as any";
            wrong(format!("`at` holds {fraction:?}, a fraction of tau outside [0, 1)"), help)
        })
    };
    let at: Vec<_> = at.unwrap_or_default().iter().map(share).collect::<PyResult<_>>()?;
    Ok(Asked { x0, whole: at.is_empty(), at })
}

impl Course {
    /// How many rows there will be.
    fn rows(&self) -> u64 {
        match &self.around {
            None if self.asked.whole => grid().len() as u64,
            None => self.asked.at.len() as u64,
            Some(around) => around.samples(self.values.get(Parameter::Tau)),
        }
    }

    /// The rows, and the tracking error in the last one.
    fn run(&self, watch: &watch::Watch) -> Result<(Kept, Option<Vec<f64>>), Failure> {
        let Self { spec, plant, values, asked, around } = self;
        let mut kept = Kept::default();
        let take = &mut |row| {
            kept.take(row);
            watch.tick(1);
        };
        match around {
            None => record::continuous((spec, plant), values, asked, take)?,
            Some(around) => record::sampled((spec, plant), values, (&asked.x0, around), take)?,
        }
        let last = kept.last.as_ref();
        let error = last.map(|(t, x)| tracking_error(spec, values, *t, x)).transpose()?.flatten();
        Ok((kept, error))
    }
}

/// The checks that refuse the emitted controller, and its first call that is refused.
fn warnings(report: Option<&Report>, refused: Option<(Status, f64)>) -> Vec<String> {
    let Some(report) = report else { return Vec::new() };
    let refusals = report.refusals().map(|outcome| {
        let fix = outcome.fix.iter().map(|fix| format!("; {fix}")).collect::<String>();
        format!("the check {} refuses the design: {}{fix}", outcome.name, outcome.summary)
    });
    let refused = refused.map(|(status, t)| {
        format!("step returns {} and u = 0, first at t = {t} s", status.c_name())
    });
    refusals.chain(refused).collect()
}
