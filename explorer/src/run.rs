//! Closed loops of a design and of the same design with other mappings.

mod course;

use num_traits::ToPrimitive;
use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::parameter::{Fixed, Parameter};
use ptc_codegen::plant::{self, Plant};
use ptc_codegen::request::{Spec, one_or_each};
use ptc_codegen::simulate::{Loop, Values};
use serde_json::{Value, json};

use crate::design::Design;
use course::{Around, Course};

/// Most mappings that are laid over a run; the page asks for no more (`page/link.js`).
pub(crate) const OVERLAYS: usize = 20;

/// The runs that a request asks for, each with its course or with the reason why it has none.
pub(crate) fn runs(
    design: &Design<'_>,
    (report, plant): (&Report, Option<Plant>),
    request: &Value,
) -> Value {
    let (spec, plant) = plant::as_one(report.spec.clone(), plant);
    let x0 = match start(&spec, request["x0"].as_str().unwrap_or_default()) {
        Ok(x0) => x0,
        Err(problem) => return json!({ "problem": problem }),
    };
    let seed = request["seed"].as_u64().unwrap_or(0);
    let refused = |report: &Report| report.refusals().map(|outcome| outcome.name).collect();
    let own = one(spec.mapping_name(), (&spec, refused(report)), plant, (&x0, seed));
    let others = request["overlays"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let others = others.take(OVERLAYS).map(|text| match design.with_mapping(text) {
        Ok((spec, plant)) => {
            let report = examine(&spec);
            let refused = refused(&report);
            let (spec, plant) = plant::as_one(report.spec, plant);
            one(text, (&spec, refused), plant, (&x0, seed))
        }
        Err(problem) => json!({ "label": text, "problem": problem }),
    });
    let series: Vec<_> = std::iter::once(own).chain(others).collect();
    let bounds: Vec<_> = (0..x0.len()).map(|j| one_or_each(&spec.promises.x_max, j)).collect();
    json!({
        "x0": x0,
        "states": spec.state_names(),
        "inputs": spec.input_names(),
        "x_max": bounds,
        "series": series,
    })
}

/// The state at the start: as it was typed, else at the bounds of the design, else 1 in the first state.
fn start(spec: &Spec, text: &str) -> Result<Vec<f64>, String> {
    let names = spec.state_names();
    if text.trim().is_empty() {
        let bounds = &spec.promises.x0_max;
        let unit = |j| if j == 0 { 1.0 } else { 0.0 };
        return Ok((0..names.len()).map(|j| one_or_each(bounds, j).unwrap_or(unit(j))).collect());
    }
    let number = |item: &str| item.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let x0: Option<Vec<f64>> = text.split(',').map(number).collect();
    x0.filter(|x0| x0.len() == names.len()).ok_or_else(|| {
        format!("x(0) needs {} numbers separated by commas: {}", names.len(), names.join(", "))
    })
}

/// A run, with its label.
fn one(
    label: &str,
    (spec, refusals): (&Spec, Vec<&str>),
    plant: Option<Plant>,
    (x0, seed): (&[f64], u64),
) -> Value {
    let plant = plant.unwrap_or_else(|| Plant::own(spec));
    match values(spec, &plant).and_then(|(values, assumed)| {
        let course = Course::of(spec, &plant, &Around { values: &values, x0, seed })?;
        Ok((course, values, assumed))
    }) {
        Ok((course, values, assumed)) => {
            let mut told = course.told();
            told["label"] = json!(label);
            told["tau"] = json!(values.get(Parameter::Tau));
            told["t0"] = json!(values.get(Parameter::StartTime));
            // A bound that is infinite becomes null.
            let limits = values.limits(spec);
            told["u_max"] = json!(limits.iter().map(|limits| limits.most).collect::<Vec<_>>());
            told["u_min"] = json!(limits.iter().map(|limits| limits.least).collect::<Vec<_>>());
            told["refused_by"] = json!(refusals);
            told["assumed"] = json!(assumed);
            told
        }
        Err(problem) => json!({ "label": label, "problem": problem }),
    }
}

/// The values of the loop; what has bounds alone is in their middle, and named.
fn values(spec: &Spec, plant: &Plant) -> Result<(Values, Vec<String>), String> {
    let emitted = spec.has_model() || Loop::of(spec).is_some();
    let mut values = Values::of(spec, plant);
    let mut assumed = Vec::new();
    for parameter in values.missing(spec, plant, emitted) {
        let bounds = plant.bounds.get(&parameter).or_else(|| spec.bounds.get(&parameter));
        let ends = bounds.and_then(|(least, most)| Some((to_f64(least)?, to_f64(most)?)));
        if let Some((least, most)) = ends {
            let middle = 0.5 * (least + most);
            values.set(parameter, middle);
            assumed.push(format!("{} = {middle}", parameter.spelling()));
        }
    }
    let missing = values.missing(spec, plant, emitted);
    if missing.is_empty() {
        return Ok((values, assumed));
    }
    let names: Vec<_> = missing.iter().map(|parameter| parameter.spelling()).collect();
    Err(format!("a run needs values that the design leaves open: {}", names.join(", ")))
}

fn to_f64(value: &Fixed) -> Option<f64> {
    value.number().and_then(ToPrimitive::to_f64)
}
