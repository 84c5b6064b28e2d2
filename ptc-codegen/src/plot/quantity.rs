//! Title of a panel.

use crate::request::Spec;

/// A state or an input: its name, and its unit where the design tells.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: Option<String>,
}

impl Quantity {
    /// One whose unit is not known.
    pub fn plain(name: impl Into<String>) -> Self {
        Self { name: name.into(), unit: None }
    }

    /// The states of the plant of `spec`.
    pub fn states(spec: &Spec) -> Vec<Self> {
        let unit = |place| spec.units.as_ref().map(|_| spec.chain_unit(place));
        let names = spec.state_names().into_iter().zip(1..);
        names.map(|(name, place)| Self { name, unit: unit(place) }).collect()
    }

    /// Its inputs.
    pub fn inputs(spec: &Spec) -> Vec<Self> {
        let unit = || spec.input_unit();
        spec.input_names().into_iter().map(|name| Self { name, unit: unit() }).collect()
    }
}
