//! The formulas of a design: plant, mapping, closed forms, law and gains.

mod closed;
mod coupled;
mod group;
mod law;
mod plant;

use crate::plant::Plant;
use crate::request::Spec;

use crate::cli::report::Failure;

pub(super) use group::Group;

/// All formulas of a design with its plant.
pub(super) fn groups(spec: &Spec, plant: &Plant) -> Result<Vec<Group>, Failure> {
    if let Some(coupled) = &spec.coupled {
        return coupled::groups((spec, coupled), plant);
    }
    let plant = match &spec.model {
        Some(model) => plant::of_model((spec, model), plant),
        None => plant::of_chain(spec, plant),
    };
    Ok(vec![plant, closed::mapping(spec), closed::r(spec)?, closed::matrix(spec)?, law::law(spec)?])
}
