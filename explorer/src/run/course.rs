//! One run, thinned out to what a picture shows.

use ptc_codegen::parameter::Parameter;
use ptc_codegen::plant::Plant;
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{
    Accuracy, Continuous, Direct, Failure, Loop, Run, Sample, Sampled, Side, Values, grid,
};
use serde_json::{Value, json};

/// Most samples of a run: what is more takes seconds.
const SAMPLES: f64 = 200_000.0;

/// Rows that are handed to the page.
const ROWS: usize = 2000;

/// Length of a sampled run, as a fraction of tau; it shows the hold after the deadline too.
const UNTIL: f64 = 1.2;

/// Parameters, initial state and seed of a run.
pub(super) struct Around<'a> {
    pub(super) values: &'a Values,
    pub(super) x0: &'a [f64],
    pub(super) seed: u64,
}

/// A run.
pub(super) struct Course {
    held: bool,
    /// Samples of which one is kept.
    every: usize,
    t: Vec<f64>,
    x: Vec<Vec<f64>>,
    u: Vec<Vec<f64>>,
    /// The state in the last row up to the deadline, with its time.
    at_deadline: (f64, Vec<f64>),
    /// The largest |u| of each input.
    peak: Vec<f64>,
    /// Time in which an input is at its bound, s.
    saturated: f64,
    /// The first call that fails, and when.
    failed: Option<(&'static str, f64)>,
}

impl Course {
    pub(super) fn of(spec: &Spec, plant: &Plant, around: &Around<'_>) -> Result<Self, String> {
        let page = "the page";
        for knows in [spec.needs_law(page), spec.needs_known_reference(page)] {
            knows.map_err(|found| found.into_iter().map(|one| one.message).collect::<String>())?;
        }
        let size = (spec.states(), spec.input_names().len());
        match Loop::of(spec) {
            Some(looped) => sampled(spec, plant, (around, size), looped),
            None if spec.has_model() => continuous(Direct::of(spec, plant), (around, size)),
            None => continuous(Continuous::of(spec, plant), (around, size)),
        }
    }

    /// Creates an empty course for the numbers of states and inputs.
    fn new(held: bool, every: usize, (states, inputs): (usize, usize)) -> Self {
        Self {
            held,
            every,
            t: Vec::new(),
            x: vec![Vec::new(); states],
            u: vec![Vec::new(); inputs],
            at_deadline: (f64::NAN, Vec::new()),
            peak: vec![0.0; inputs],
            saturated: 0.0,
            failed: None,
        }
    }

    /// Notes an instant that lasts for `period`.
    fn note(&mut self, index: usize, sample: &Sample<'_>, (end, period): (f64, f64)) {
        for (peak, u) in self.peak.iter_mut().zip(sample.u) {
            *peak = peak.max(u.abs());
        }
        let before = sample.t <= end + 0.5 * period;
        if before {
            self.at_deadline = (sample.t, sample.x.to_vec());
        }
        match sample.status {
            Status::Saturated if before => self.saturated += period,
            Status::Range | Status::Input if self.failed.is_none() => {
                self.failed = Some((sample.status.c_name(), sample.t));
            }
            _ => {}
        }
        if index.is_multiple_of(self.every) {
            self.t.push(sample.t);
            let all = self.x.iter_mut().chain(&mut self.u);
            for (all, value) in all.zip(sample.x.iter().chain(sample.u)) {
                all.push(*value);
            }
        }
    }

    /// For the page. Numbers that are not finite become null.
    pub(super) fn told(&self) -> Value {
        json!({
            "held": self.held,
            "every": self.every,
            "t": self.t,
            "x": self.x,
            "u": self.u,
            "end": { "t": self.at_deadline.0, "x": self.at_deadline.1 },
            "peak": self.peak,
            "saturated": self.saturated,
            "failed": self.failed.map(|(status, t)| json!({ "status": status, "t": t })),
        })
    }
}

/// The emitted controller at each sample.
fn sampled(
    spec: &Spec,
    plant: &Plant,
    (around, size): (&Around<'_>, (usize, usize)),
    looped: Loop,
) -> Result<Course, String> {
    let (values, period) = (around.values, looped.period);
    let tau = values.get(Parameter::Tau);
    let length = UNTIL * tau;
    let count = length / period;
    if count.is_nan() || count > SAMPLES {
        return Err(format!(
            "a sample period of {period} s makes more than {SAMPLES} samples in {length} s, which is more than a page runs: use `ptc-codegen simulate`"
        ));
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let every = (count as usize / ROWS).max(1);
    let looped = Loop { seed: around.seed, until: Some(length), ..looped };
    let mut course = Course::new(true, every, size);
    let mut index = 0;
    let end = values.get(Parameter::StartTime) + tau;
    let mut see = |sample: Sample<'_>| {
        course.note(index, &sample, (end, period));
        index += 1;
    };
    Sampled::new(spec, plant)
        .and_then(|mut run| run.run(values, around.x0, &looped, &mut see))
        .map_err(|failure| told(&failure))?;
    Ok(course)
}

/// The law at every instant.
fn continuous<S: Side>(
    run: Result<Run<S>, Failure>,
    (around, size): (&Around<'_>, (usize, usize)),
) -> Result<Course, String> {
    let values = around.values;
    let end = values.get(Parameter::StartTime) + values.get(Parameter::Tau);
    let mut course = Course::new(false, 1, size);
    run.and_then(|mut run| {
        run.run(values, around.x0, &grid(), Accuracy::default(), &mut |sample| {
            course.note(0, &sample, (end, 0.0));
        })
    })
    .map_err(|failure| told(&failure))?;
    Ok(course)
}

fn told(failure: &Failure) -> String {
    format!("{}; {}", failure.message, failure.help)
}
