//! The plant that a controller is simulated with: x1' = x2, ..., xn' = f(x, u, t) + g(x, t) u.
//!
//! ```toml
//! [plant]
//! f = "-damping*x2 - gust*sin(3*t)"
//! g = "0.8"
//! damping = 0.4
//! gust = [0, 0.2]
//! ```
//!
//! f and g are the controller's own unless they are given; a g that differs is an error of the
//! gain, and what f is beside the controller's own is not cancelled. Every other name is a symbol of the plant: a number, or bounds within which it is not known.

mod force;
mod read;

use std::collections::{BTreeMap, BTreeSet};

#[cfg(feature = "lab")]
pub(crate) use force::{Bounded, force};
pub use read::{read, read_partly};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::Expression;
use crate::parameter::{Fixed, Parameter};
use crate::request::{self, Entry, Spec};

/// The table of a design file that holds the plant.
pub const TABLE: &str = "plant";

/// Reads a design: its controller, which knows what the plant is bounded by, and the plant, if it has one.
///
/// # Errors
/// Every mistake in the controller, else every mistake in the table `[plant]`.
pub fn read_design(entries: &[Entry]) -> Result<(Spec, Option<Plant>), Vec<Diagnostic>> {
    let mut spec = request::read(entries)?;
    let plant = read(entries, &spec)?;
    promised(&mut spec, plant.as_ref(), entries)?;
    Ok((spec, plant))
}

/// Gives a spec what the table `[plant]` promises of its loop.
///
/// # Errors
/// An input gain that is said twice.
pub(crate) fn promised(
    spec: &mut Spec,
    plant: Option<&Plant>,
    entries: &[Entry],
) -> Result<(), Vec<Diagnostic>> {
    if let (false, Some(g)) =
        (spec.promises.g_error.is_empty(), plant.and_then(|plant| plant.g.as_ref()))
    {
        let place = entries.iter().find(|entry| entry.key == "g_error");
        let mut found = Diagnostics::default();
        found.push(
            "conflict",
            "g_error",
            place.map(|entry| entry.value.place),
            format!("`g_error` and g = {g} of the plant both say what the true input gain is"),
            "leave one of them out; under [plant] an uncertain g is g = \"b\", b = [0.9, 1.1]",
        );
        return found.finish(None);
    }
    spec.promises.plant = plant.map(|plant| plant.bounds(spec, entries));
    Ok(())
}

/// What moves the state of a chain of integrators.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plant {
    /// f(x, u, t), in units of xn per s.
    pub f: Expression,
    /// The true g(x, t); none for the controller's own.
    pub g: Option<Expression>,
    /// Symbols with a value.
    pub fixed: BTreeMap<Parameter, Fixed>,
    /// Symbols that are uncertain, with least and greatest value.
    pub bounds: BTreeMap<Parameter, (Fixed, Fixed)>,
}

impl Default for Plant {
    fn default() -> Self {
        let (fixed, bounds) = (BTreeMap::new(), BTreeMap::new());
        Self { f: Expression::integer(0), g: None, fixed, bounds }
    }
}

impl Plant {
    /// The plant that the controller of `spec` is made for.
    pub fn own(spec: &Spec) -> Self {
        let f = spec.drift.clone().unwrap_or(Expression::integer(0));
        Self { f, ..Self::default() }
    }

    /// The symbols of the plant that are no parameters of its controller.
    pub fn symbols(&self, spec: &Spec) -> BTreeSet<Parameter> {
        let of_controller: BTreeSet<_> = spec.parameters().into_iter().collect();
        let used = std::iter::once(&self.f).chain(&self.g).flat_map(Expression::parameters);
        used.filter(|parameter| !of_controller.contains(parameter)).collect()
    }
}
