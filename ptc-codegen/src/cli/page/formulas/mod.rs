//! The formulas of a design: plant, mapping, closed forms, law and gains.

mod closed;
mod coupled;
mod group;
mod law;
mod plant;
mod samples;

use crate::check::examine::Report;
use crate::plant::Plant;

use crate::cli::report::Failure;

pub(super) use group::Group;

/// All formulas of a design with its plant.
pub(super) fn groups(report: &Report, plant: &Plant) -> Result<Vec<Group>, Failure> {
    let spec = &report.spec;
    if spec.sampled().is_some() {
        return Ok(in_samples(report, plant));
    }
    if let Some(coupled) = &spec.coupled {
        return coupled::groups((spec, coupled), plant);
    }
    let plant = match &spec.model {
        Some(model) => plant::of_model((spec, model), plant),
        None => plant::of_chain(spec, plant),
    };
    Ok(vec![plant, closed::mapping(spec), closed::r(spec)?, closed::matrix(spec)?, law::law(spec)?])
}

/// Returns the groups of a clock in samples, whose law is that of the emitted program. A linear plant is in the design
/// alone.
fn in_samples(report: &Report, plant: &Plant) -> Vec<Group> {
    let spec = &report.spec;
    let linear = spec.sampled().is_some_and(|sampled| sampled.linear.is_some());
    let plant = match (&spec.coupled, &spec.model) {
        (Some(coupled), _) => Some(coupled::group((spec, coupled), plant)),
        (None, Some(model)) => Some(plant::of_model((spec, model), plant)),
        (None, None) => (!linear).then(|| plant::of_chain(spec, plant)),
    };
    plant.into_iter().chain([samples::law(report)]).collect()
}
