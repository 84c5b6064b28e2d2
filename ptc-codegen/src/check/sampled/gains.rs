//! The gains with which the emitted program acts at each sample.

use super::chain::Gains;
use super::rounded::{Rounded, StagedValues, unit_roundoff};
use crate::expansion::Expanded;
use crate::expression::enclosure::Range;
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::Parameter;
use crate::program::{Input, Program, Stage, passes};
use crate::request::{After, Spec};

/// The rows of gains of samples 0..=`last` with period `h`, the last ones held from there on; none
/// where a value of the program is not enclosed.
pub(super) fn gains(
    spec: &Spec,
    expanded: Option<&Expanded>,
    h: Range,
    last: usize,
) -> Option<Vec<Gains>> {
    // What follows the deadline is no part of the law before it.
    let spec = Spec { after: After::Hold, ..spec.clone() };
    let program = passes::optimise(lower(&spec, &Law::from(&spec, expanded)), &mut |_, _| {});
    Acting::new(&spec, &program)?.rows(h, last)
}

struct Acting<'a> {
    spec: &'a Spec,
    program: &'a Program,
    enclosure: StagedValues<'a>,
    start: Rounded,
}

impl<'a> Acting<'a> {
    fn new(spec: &'a Spec, program: &'a Program) -> Option<Self> {
        let enclosure = StagedValues::new(program, &[program.step])?;
        let start = parameter(spec, Parameter::StartTime).unwrap_or(Rounded::of(Range::from(0.0)));
        Some(Self { spec, program, enclosure, start })
    }

    fn rows(mut self, h: Range, last: usize) -> Option<Vec<Gains>> {
        let early = |input: Input| match input {
            Input::Parameter(Parameter::StartTime) | Input::StartTime => Some(self.start),
            Input::Parameter(asked) => parameter(self.spec, asked),
            _ => None,
        };
        for stage in [Stage::Generation, Stage::Init, Stage::Arm] {
            self.enclosure.run(stage, &early);
        }
        let unit = unit_roundoff(self.program.precision);
        (0..=last).map(|k| self.row(k, h, unit)).collect()
    }

    fn row(&mut self, k: usize, h: Range, unit: f64) -> Option<Gains> {
        #[allow(clippy::cast_precision_loss)]
        let t = self.start.exact + Range::from(k as f64) * h;
        // The caller's clock gives the nearest number at best.
        let time = Rounded { exact: t, error: (unit * t.size().high()).next_up() };
        let at = |input: Input| (input == Input::Time).then_some(time);
        self.enclosure.run(Stage::Tick, &at);
        let mut row = Vec::new();
        for j in 1..=self.spec.n {
            let state = |input: Input| match input {
                Input::State(i) if i == j => Some(Rounded { exact: Range::from(1.0), error: unit }),
                Input::State(_) => Some(Rounded::of(Range::from(0.0))),
                _ => None,
            };
            self.enclosure.run(Stage::Step, &state);
            row.push(self.enclosure.get(self.program.step)?);
        }
        Some(Gains::new(&row))
    }
}

/// A fixed parameter as the emitted code has it.
fn parameter(spec: &Spec, parameter: Parameter) -> Option<Rounded> {
    let exact = spec.fixed.get(&parameter)?.number()?;
    Some(Rounded::number(exact, spec.precision))
}
