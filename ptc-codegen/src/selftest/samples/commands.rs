//! Functions of a deadline in flight, before calls of `step`.

use super::search::{Input, Search};
use crate::code::{Code, Function, Instance, Outcome, Shape, Status};
use crate::program::number::settle;

/// Requests that are tried.
const REQUESTS: usize = 3000;

/// A call of a function of a deadline in flight, and its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// The function.
    pub name: &'static str,
    /// The samples that it is given.
    pub samples: u32,
    /// The numbers that it is given, those of arrays one after the other, but for what is measured.
    pub given: Vec<f64>,
    /// The status that it must give.
    pub status: Status,
    /// The count that it must give; 0 where it fails or gives none.
    pub found: u32,
}

/// Arguments of such a call.
pub(super) struct Request {
    name: &'static str,
    /// The arguments, in their order.
    arguments: Vec<(String, Shape)>,
    samples: u32,
    given: Vec<f64>,
}

/// The functions of a deadline in flight.
pub fn commands(code: &Code) -> impl Iterator<Item = &Function> {
    let is_asked = |name| name == "deadline" || code.commands().any(|own| own.name == name);
    code.functions.iter().filter(move |function| is_asked(function.name))
}

/// The numbers that a command is given beside the tick, the samples and what is measured.
pub fn numbers(function: &Function) -> usize {
    let own = |shape: Shape, name: &str| match shape {
        Shape::Real => 1,
        _ if is_measured(name) => 0,
        shape => count(shape),
    };
    function.arguments.iter().map(|argument| own(argument.shape, &argument.name)).sum()
}

/// The numbers in an argument.
pub fn count(shape: Shape) -> usize {
    shape.length().unwrap_or_else(|| usize::from(shape == Shape::Real))
}

/// Returns true for an argument that holds what is measured.
pub fn is_measured(name: &str) -> bool {
    matches!(name, "x" | "y")
}

impl Request {
    /// Calls the function at tick `k`.
    pub(super) fn asked(self, trial: &mut Instance, k: u32, measured: &[f64]) -> Command {
        let Self { name, arguments, samples, given } = self;
        let counts = [f64::from(k), f64::from(samples)];
        let mut rest = &given[..];
        let mut values = Vec::new();
        for (argument, shape) in &arguments {
            let value = match (argument.as_str(), shape) {
                ("k", _) => &counts[..1],
                (_, Shape::Count) => &counts[1..],
                (own, _) if is_measured(own) => measured,
                (_, shape) => {
                    let (own, behind) = rest.split_at(count(*shape));
                    rest = behind;
                    own
                }
            };
            values.push((argument.as_str(), value));
        }
        let outcome = trial.call(name, &values);
        Command { name, samples, given, status: outcome.status, found: found(&outcome) }
    }
}

/// The count among the results.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn found(outcome: &Outcome) -> u32 {
    let counts = outcome.results.values().flatten();
    if outcome.status.number() < 0 {
        0
    } else {
        counts.map(|count| *count as u32).next().unwrap_or(0)
    }
}

impl Search<'_> {
    /// Calls of the functions of a deadline in flight: each once, and those that take a branch no other took.
    pub(super) fn commands(&mut self) {
        let functions: Vec<_> = commands(self.code).cloned().collect();
        let Some(mut life) = self.begin(&self.choice.usual()).filter(|_| !functions.is_empty())
        else {
            return;
        };
        for index in 0..REQUESTS {
            let first = index < functions.len();
            let function = match first {
                true => &functions[index],
                false => self.draw.of(&functions.iter().collect::<Vec<_>>()),
            };
            let before = Some(self.request(function, first));
            let elapsed = self.draw.of(&[1, 2, 7, life.ends.last / 2, life.ends.last]);
            let y = (0..self.count()).map(|_| self.number(&[1e-3, 0.1, 1.0, 100.0], !first));
            let y = y.collect();
            self.ask(&mut life, Input { before, elapsed, y, ..Input::default() }, first);
        }
        self.end(life);
    }

    fn request(&mut self, function: &Function, first: bool) -> Request {
        let given = (0..numbers(function)).map(|_| self.number(&[0.0, 1e-3, 0.1, 1.0], !first));
        let given = given.collect();
        let samples = match first {
            true => 1 << 10,
            false => self.draw.of(&[0, 1, 3, 10, 40, 200, 3000, 1 << 20, 1 << 31, u32::MAX]),
        };
        let arguments = function.arguments.iter();
        let arguments = arguments.map(|own| (own.name.clone(), own.shape)).collect();
        Request { name: function.name, arguments, samples, given }
    }

    /// A number of one of the sizes, or, where `odd` allows, one that is none or too large.
    fn number(&mut self, sizes: &[f64], odd: bool) -> f64 {
        let greatest = self.spec.precision.greatest();
        match odd && self.draw.of(&[true, false, false, false, false, false, false, false]) {
            true => self.draw.of(&[f64::NAN, f64::INFINITY, greatest, -greatest]),
            false => {
                let size = self.draw.of(sizes);
                settle(self.draw.between(-1.0, 1.0) * size, self.spec.precision)
            }
        }
    }
}
