//! Closed loops of a design and of the same design with other mappings.

mod course;
mod trial;
mod values;
mod watched;

use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::parameter::Parameter;
use ptc_codegen::plant::{self, Plant};
use ptc_codegen::request::{Spec, one_or_each};
use ptc_codegen::simulate::{Event, Loop, event};
use serde_json::{Value, json};

use crate::design::Design;
use course::{Around, Course};
use trial::Trial;
use values::Known;

/// Most mappings that are laid over a run; the page asks for no more (`page/link.js`).
pub(crate) const OVERLAYS: usize = 20;

/// A design that is run, with its plant and its name in the legend.
struct Case<'a> {
    label: &'a str,
    spec: Spec,
    plant: Plant,
    refused_by: Vec<&'static str>,
    events: Vec<Event>,
}

impl<'a> Case<'a> {
    fn new(
        label: &'a str,
        (report, plant): (&Report, Option<Plant>),
        design: &Design<'_>,
    ) -> Result<Self, String> {
        let refused_by = report.refusals().map(|outcome| outcome.name).collect();
        let (spec, plant) = plant::as_one(report.spec.clone(), plant);
        let plant = plant.unwrap_or_else(|| Plant::own(&spec));
        let events = event::read_numbers(design.entries(), &spec).map_err(|found| {
            found.into_iter().map(|one| one.message).collect::<Vec<_>>().join("; ")
        })?;
        if Loop::of(&spec).is_none() && !events.is_empty() {
            return Err("the events of the design need the sampled loop: give sample_time, or a clock in samples".to_owned());
        }
        Ok(Self { label, spec, plant, refused_by, events })
    }

    /// Its run, or the reason why it has none.
    fn run(&self, x0: &[f64], seed: u64, trial: &Trial) -> Value {
        let Self { label, spec, plant, refused_by, events } = self;
        let plant = trial.plant(spec, plant);
        let done = Known::of((spec, &plant), &trial.symbols).and_then(|known| {
            let (values, force) = (&known.values, trial.event());
            let around = Around { values, x0, seed, events, force, gain: trial.gain };
            Ok((Course::of(spec, &plant, &around)?, known))
        });
        let (course, known) = match done {
            Ok(done) => done,
            Err(problem) => return json!({ "label": label, "problem": problem }),
        };
        let mut told = course.told();
        told["label"] = json!(label);
        told["tau"] = json!(known.values.get(Parameter::Tau));
        told["t0"] = json!(known.values.get(Parameter::StartTime));
        // A bound that is infinite becomes null.
        let limits = known.values.limits(spec);
        told["u_max"] = json!(limits.iter().map(|limits| limits.most).collect::<Vec<_>>());
        told["u_min"] = json!(limits.iter().map(|limits| limits.least).collect::<Vec<_>>());
        told["refused_by"] = json!(refused_by);
        told["assumed"] = json!(known.assumed);
        told
    }
}

/// The runs that a request asks for, each with its course or with the reason why it has none.
pub(crate) fn runs(
    design: &Design<'_>,
    (report, plant): (&Report, Option<Plant>),
    request: &Value,
) -> Value {
    let trial = Trial::read(&request["trial"]);
    let seed = request["seed"].as_u64().unwrap_or(0);
    let own = match Case::new(report.spec.mapping_name(), (report, plant), design) {
        Ok(own) => own,
        Err(problem) => return json!({ "problem": problem }),
    };
    let spec = &own.spec;
    let offered = Trial::offered(spec, &own.plant);
    let x0 = match start(spec, request["x0"].as_str().unwrap_or_default()) {
        Ok(x0) => x0,
        Err(problem) => return json!({ "problem": problem, "offered": offered }),
    };
    let others = request["overlays"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let others = others.take(OVERLAYS).map(|text| {
        let other = design.with_mapping(text).and_then(|(spec, plant)| {
            let report = examine(&spec);
            Ok(Case::new(text, (&report, plant), design)?.run(&x0, seed, &trial))
        });
        other.unwrap_or_else(|problem| json!({ "label": text, "problem": problem }))
    });
    let series: Vec<_> = std::iter::once(own.run(&x0, seed, &trial)).chain(others).collect();
    let bounds: Vec<_> = (0..x0.len()).map(|j| one_or_each(&spec.promises.x_max, j)).collect();
    let tolerated: Vec<_> = (0..x0.len()).map(|j| one_or_each(&spec.promises.error, j)).collect();
    json!({
        "x0": x0,
        "states": spec.state_names(),
        "inputs": spec.input_names(),
        "chains": spec.names_of_chains(),
        "first_estimated": spec.sampled().map(|sampled| sampled.first_estimated()),
        "follows": !spec.has_model(),
        "x_max": bounds,
        "error": tolerated,
        "tried": trial.told(&offered),
        "offered": offered,
        "series": series,
    })
}

/// The state at the start: as it was typed, else at the bounds of the design, else 1 in the first state of each axis.
fn start(spec: &Spec, text: &str) -> Result<Vec<f64>, String> {
    let names = spec.state_names();
    if text.trim().is_empty() {
        return Ok(spec.example_start());
    }
    let number = |item: &str| item.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let x0: Option<Vec<f64>> = text.split(',').map(number).collect();
    x0.filter(|x0| x0.len() == names.len()).ok_or_else(|| {
        format!("x(0) needs {} numbers separated by commas: {}", names.len(), names.join(", "))
    })
}
