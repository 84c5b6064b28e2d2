//! Values that are legal and probably not what was meant.

use num_traits::ToPrimitive;

use crate::diagnostic::{counted, digits};
use crate::parameter::{Fixed, Parameter};
use crate::plant::Plant;
use crate::request::Spec;

/// From so many samples on, tau may have been given in another unit.
const MANY: f64 = 1e6;

/// Below so many samples, a delay may have been given in seconds.
const SHORT: f64 = 0.01;

/// Returns a note for each value of a design that was probably meant otherwise.
pub(crate) fn doubts(spec: &Spec, plant: Option<&Plant>) -> Vec<String> {
    let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number)?.to_f64();
    let period = spec.promises.sample_time.as_ref().and_then(Fixed::number);
    let period = period.and_then(ToPrimitive::to_f64);
    let mut all = Vec::new();
    if let (Some(tau), Some(period)) = (spec.fixed.get(&Parameter::Tau), period) {
        let samples = number(Parameter::Tau).unwrap_or(0.0) / period;
        if samples >= MANY {
            all.push(format!("tau is {} samples: is tau = {tau} in s?", samples.round()));
        }
    }
    let delay = spec.promises.delay.as_ref().map_or(0.0, |delay| delay.samples());
    if delay > 0.0 && delay < SHORT {
        all.push(format!("is delay = {} in samples? It is not in s", digits(delay)));
    }
    all.extend(plant.and_then(|plant| unknown(spec, plant)));
    all
}

/// Names in the plant that have no value, which may be misspelt states.
fn unknown(spec: &Spec, plant: &Plant) -> Option<String> {
    let symbols = plant.symbols(spec);
    let open = symbols.iter().filter(|symbol| !plant.gives(**symbol));
    let names: Vec<_> = open.map(|symbol| format!("`{}`", symbol.spelling())).collect();
    let name = counted(&names.len(), "name");
    let noun = name.split_once(' ').map_or("name", |(_, noun)| noun);
    (!names.is_empty()).then(|| {
        format!(
            "unknown {noun} {} in plant.f or plant.g, without a value under [plant]; the states are {}",
            names.join(", "),
            spec.state_names().join(", ")
        )
    })
}
