//! The picture of the feasible set, for `--plot`.

use std::path::Path;

use crate::check::sampled::{FeasibleSet, Outline};
use crate::diagnostic::digits;
use crate::plot::{Contour, Contours, Quantity};
use crate::request::Spec;

use crate::cli::output::{self, Outputs, Place};
use crate::cli::picture::{file_of, format_of};
use crate::cli::progress::checking;
use crate::cli::report::Failure;
use crate::plot::Format;

/// The file that `--plot` names.
pub(super) struct Plot {
    format: Format,
    place: Place,
}

impl Plot {
    /// Plans the file at `path` for the design at another one, if there is one.
    pub(super) fn of(design: Option<&Path>, path: Option<&Path>) -> Result<Option<Self>, Failure> {
        let Some(path) = path else { return Ok(None) };
        let format = format_of(path)?;
        let mut outputs = Outputs::default();
        design.into_iter().for_each(|path| outputs.reads("the design", path));
        Ok(Some(Self { format, place: outputs.file("--plot", path)? }))
    }

    /// Draws the feasible set of a design and writes it; returns what was written, in a line.
    pub(super) fn write(self, spec: &Spec) -> Result<String, Failure> {
        let set = checking(|| FeasibleSet::of(spec)).map_err(|unlimited| {
            Failure::because(format!("--plot draws no picture: {}", unlimited.why), unlimited.help)
        })?;
        let picture = file_of(self.format, &contours(spec, &set))?;
        output::write(&[(self.place, &picture)])
    }
}

fn contours(spec: &Spec, set: &FeasibleSet) -> Contours {
    let axis = |index: usize| {
        let Quantity { name, unit } = Quantity::states(spec).swap_remove(index);
        unit.map_or(name.clone(), |unit| format!("{name} in {unit}"))
    };
    let others = (3..=spec.n).map(|i| format!("x{i} = ")).collect::<String>();
    let others = if others.is_empty() { others } else { format!(", {others}0") };
    let flight = spec.sampled().and_then(|sampled| sampled.flight.as_ref());
    let reserve = match flight.is_some_and(|own| own.reserve != Default::default()) {
        true => ", without the reserve",
        false => "",
    };
    let contour =
        |label: String, outline: &Outline| Contour { label, points: outline.states.clone() };
    let level = |outline: &Outline| contour(format!("{} s", digits(outline.tau)), outline);
    Contours {
        title: format!("{}: deadlines within the limits{others}", spec.name()),
        across: axis(0),
        up: axis(1),
        meaning: format!("soonest deadline{reserve}:"),
        curves: set.soonest.iter().map(level).collect(),
        marked: contour(format!("kept at tau = {} s", digits(set.kept.tau)), &set.kept),
    }
}
