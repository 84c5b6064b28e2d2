//! One run, thinned out to what a picture shows.

use std::cell::RefCell;

use ptc_codegen::parameter::Parameter;
use ptc_codegen::plant::Plant;
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{
    Accuracy, Continuous, Controller, Direct, Event, Failure, Loop, Process, Run, Sample, Side,
    Tracking, Values, grid,
};
use serde_json::{Value, json};

use super::watched::{Estimates, Watched};

/// Most samples of a run: what is more takes seconds.
const SAMPLES: f64 = 200_000.0;

/// Rows that are handed to the page.
const ROWS: usize = 2000;

/// Length of a sampled run, as a fraction of tau; it shows the hold after the deadline too.
const UNTIL: f64 = 1.2;

/// Deadlines that are drawn; of more, the last one alone.
const DEADLINES: usize = 8;

/// Parameters, initial state, seed and events of a run.
pub(super) struct Around<'a> {
    pub(super) values: &'a Values,
    pub(super) x0: &'a [f64],
    pub(super) seed: u64,
    pub(super) events: &'a [Event],
    /// A force for all of the run, which does not make it longer.
    pub(super) force: Option<Event>,
    /// Input gain of a sampled loop, in parts of that of the plant.
    pub(super) gain: f64,
}

/// A run.
pub(super) struct Course {
    held: bool,
    /// Samples of which one is kept.
    every: usize,
    t: Vec<f64>,
    x: Vec<Vec<f64>>,
    u: Vec<Vec<f64>>,
    /// Estimates of the states from the first estimated one on, of a loop with an observer.
    estimates: Vec<Vec<f64>>,
    disturbance: Vec<f64>,
    tracking: Option<Tracking>,
    errors: Vec<Vec<f64>>,
    /// The instants at which the loop is to be at rest.
    deadlines: Vec<f64>,
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
        let tracking = Tracking::new(spec, around.values).map_err(|failure| told(&failure))?;
        let mut course = Self::new(spec, tracking);
        // The deadline that was asked for, which one in flight may leave at once.
        let [start, tau] = [Parameter::StartTime, Parameter::Tau].map(|p| around.values.get(p));
        course.deadlines.push(start + tau);
        match Loop::of(spec) {
            Some(looped) => sampled(&mut course, (spec, plant), around, looped),
            None if spec.has_model() => continuous(&mut course, Direct::of(spec, plant), around),
            None => continuous(&mut course, Continuous::of(spec, plant), around),
        }?;
        Ok(course)
    }

    /// Creates an empty course of a design.
    fn new(spec: &Spec, tracking: Option<Tracking>) -> Self {
        let (states, inputs) = (spec.states(), spec.input_names().len());
        Self {
            held: false,
            every: 1,
            t: Vec::new(),
            x: vec![Vec::new(); states],
            u: vec![Vec::new(); inputs],
            estimates: Vec::new(),
            disturbance: Vec::new(),
            tracking,
            errors: Vec::new(),
            deadlines: Vec::new(),
            at_deadline: (f64::NAN, Vec::new()),
            peak: vec![0.0; inputs],
            saturated: 0.0,
            failed: None,
        }
    }

    /// Notes an instant that lasts for `period`.
    fn note(&mut self, index: usize, sample: &Sample<'_>, seen: &Estimates, period: f64) {
        for (peak, u) in self.peak.iter_mut().zip(sample.u) {
            *peak = peak.max(u.abs());
        }
        let deadline = sample.t + sample.time_to_go;
        let near = |last: &f64| (last - deadline).abs() <= 0.5 * period + 1e-9 * deadline.abs();
        if !self.deadlines.last().is_some_and(near) {
            self.deadlines.push(deadline);
        }
        let before = sample.time_to_go >= -0.5 * period;
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
            self.keep(sample, seen);
        }
    }

    /// Keeps a row.
    fn keep(&mut self, sample: &Sample<'_>, seen: &Estimates) {
        self.t.push(sample.t);
        push(&mut self.x, sample.x);
        push(&mut self.u, sample.u);
        push(&mut self.estimates, &seen.states);
        self.disturbance.extend(seen.disturbance);
        if let Some(tracking) = &mut self.tracking {
            push(&mut self.errors, &tracking.at(sample.t, sample.x));
        }
    }

    /// For the page. Numbers that are not finite become null.
    pub(super) fn told(&self) -> Value {
        let count = self.deadlines.len();
        let late = if count > DEADLINES { count - 1 } else { 0 };
        json!({
            "held": self.held,
            "every": self.every,
            "t": self.t,
            "x": self.x,
            "u": self.u,
            "estimates": self.estimates,
            "disturbance": self.disturbance,
            "errors": self.errors,
            "deadlines": self.deadlines[late..],
            "end": { "t": self.at_deadline.0, "x": self.at_deadline.1 },
            "peak": self.peak,
            "saturated": self.saturated,
            "failed": self.failed.map(|(status, t)| json!({ "status": status, "t": t })),
        })
    }
}

/// Adds a value to each curve, of which there are as many as values.
fn push(curves: &mut Vec<Vec<f64>>, values: &[f64]) {
    curves.resize(values.len(), Vec::new());
    curves.iter_mut().zip(values).for_each(|(curve, value)| curve.push(*value));
}

/// The emitted controller at each sample.
fn sampled(
    course: &mut Course,
    (spec, plant): (&Spec, &Plant),
    around: &Around<'_>,
    looped: Loop,
) -> Result<(), String> {
    let (values, period) = (around.values, looped.period);
    let tau = values.get(Parameter::Tau);
    let looped = Loop { seed: around.seed, events: around.events.to_vec(), ..looped };
    let length = (UNTIL * tau).max(looped.planned(tau));
    let count = length / period;
    if count.is_nan() || count > SAMPLES {
        return Err(format!(
            "a sample period of {period} s makes more than {SAMPLES} samples in {length} s, which is more than a page runs: use `ptc-codegen simulate`"
        ));
    }
    // A deadline that is put off ends the run later.
    let moves = spec.sampled().is_some_and(|own| own.flight.is_some());
    let events = around.events.iter().copied().chain(around.force).collect();
    let gain = looped.gain.map(|end| end * around.gain);
    let looped = Loop { until: (!moves).then_some(length), events, gain, ..looped };
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let every = (count as usize / ROWS).max(1);
    (course.held, course.every) = (true, every);
    let seen = RefCell::default();
    let mut index = 0;
    let mut see = |sample: Sample<'_>| {
        course.note(index, &sample, &seen.borrow(), period);
        index += 1;
    };
    Controller::new(spec)
        .and_then(|controller| {
            let control = &mut Watched::new(controller, &seen);
            let process = &mut Process::new(spec, plant);
            process.run(control, values, &mut |_| None, around.x0, &looped, &mut see)
        })
        .map_err(|failure| told(&failure))
}

/// The law at every instant.
fn continuous<S: Side>(
    course: &mut Course,
    run: Result<Run<S>, Failure>,
    around: &Around<'_>,
) -> Result<(), String> {
    let seen = Estimates::default();
    run.and_then(|mut run| {
        run.run(around.values, around.x0, &grid(), Accuracy::default(), &mut |sample| {
            course.note(0, &sample, &seen, 0.0);
        })
    })
    .map_err(|failure| {
        format!("{}; with sample_time the emitted controller runs, sampled", told(&failure))
    })
}

fn told(failure: &Failure) -> String {
    format!("{}; {}", failure.message, failure.help)
}
