//! Values that are legal and probably not what was meant.

use crate::diagnostic::counted;
use crate::plant::Plant;
use crate::request::Spec;

/// Names in the plant that have no value, which may be misspelt states. Times in another unit are the report's to name.
pub(crate) fn unknown(spec: &Spec, plant: &Plant) -> Option<String> {
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
