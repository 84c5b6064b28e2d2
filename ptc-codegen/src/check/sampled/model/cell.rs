//! Values of a program over a cell of states.

use super::super::rounded::{Rounded, StagedValues, unit_roundoff};
use crate::expression::enclosure::Range;
use crate::program::{Input, Program, Stage, Value};
use crate::request::Spec;

/// Values of a program, as the states go over cells, and what is held within bounds.
pub(super) struct OnCells<'a> {
    enclosure: StagedValues<'a>,
    values: Vec<Value>,
    /// Largest distance of each state from the cell.
    errors: &'a [f64],
    unit: f64,
}

impl<'a> OnCells<'a> {
    /// # Errors
    /// Fails if memory is lacking.
    pub(super) fn new(
        spec: &Spec,
        program: &'a Program,
        values: &[Value],
        errors: &'a [f64],
    ) -> Result<Self, String> {
        let enclosure = StagedValues::new(program, values);
        let mut enclosure = enclosure.ok_or("memory for constants is lacking")?;
        let early = |input: Input| match input {
            Input::Parameter(asked) => {
                Some(Rounded::number(spec.fixed.get(&asked)?.number()?, spec.precision))
            }
            _ => None,
        };
        for stage in [Stage::Generation, Stage::Init, Stage::Arm, Stage::Tick] {
            enclosure.run(stage, &early);
        }
        let unit = unit_roundoff(spec.precision);
        Ok(Self { enclosure, values: values.to_vec(), errors, unit })
    }

    /// The values in a cell, with what is held, or wanted, within bounds; `None` where one is not enclosed.
    pub(super) fn at(&mut self, cell: &[Range], held: &[Range]) -> Vec<Option<Rounded>> {
        let (errors, unit) = (self.errors, self.unit);
        let of = |j: usize| held.get(j).copied().map(Rounded::of);
        self.enclosure.run(Stage::Step, &|input| match input {
            // Inputs stand behind the states.
            Input::State(j) if j > cell.len() => of(j - cell.len() - 1),
            Input::State(j) => {
                let around = Range::from(errors.get(j - 1).copied().unwrap_or(0.0)).both_signs();
                let exact = *cell.get(j - 1)? + around;
                Some(Rounded { exact, error: (unit * exact.size().high()).next_up() })
            }
            Input::Control => of(0),
            Input::Wanted(output) => of(output - 1),
            _ => None,
        });
        self.values.iter().map(|value| self.enclosure.get(*value)).collect()
    }

    /// Returns true if one of the values is beyond its bound in all of a cell.
    pub(super) fn is_beyond(&mut self, cell: &[Range], bounds: &[f64]) -> bool {
        let found = self.at(cell, &[]);
        found
            .iter()
            .zip(bounds)
            .any(|(value, bound)| value.is_some_and(|value| value.exact.size().low() > *bound))
    }
}

/// A bound by what is known of a value; infinite where nothing is.
pub(super) fn size(value: &Option<Rounded>, of: impl Fn(&Rounded) -> f64) -> f64 {
    value.as_ref().map_or(f64::INFINITY, of)
}

/// A box in at most `most` equal cells.
pub(super) fn cells(around: &[Range], most: usize) -> Vec<Vec<Range>> {
    let mut parts = 1;
    while (parts + 1_usize).pow(u32::try_from(around.len()).unwrap_or(u32::MAX)) <= most {
        parts += 1;
    }
    around.iter().fold(vec![Vec::new()], |all, range| {
        let cut = divided(*range, parts);
        all.iter()
            .flat_map(|cell| cut.iter().map(|part| [cell.as_slice(), &[*part]].concat()))
            .collect()
    })
}

/// An interval in equal parts, which share their ends.
#[allow(clippy::cast_precision_loss)]
pub(in crate::check::sampled) fn divided(range: Range, parts: usize) -> Vec<Range> {
    let width = range.high() - range.low();
    let at = |i: usize| match i {
        0 => range.low(),
        i if i == parts => range.high(),
        i => range.low() + width * (i as f64 / parts as f64),
    };
    (0..parts).map(|i| Range::from(at(i)).hull(&Range::from(at(i + 1)))).collect()
}
