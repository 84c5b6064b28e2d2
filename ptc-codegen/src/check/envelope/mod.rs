//! Can any value of the controller overflow, for all inputs from given intervals?
//!
//! The staged program is computed on intervals, piece by piece of time-to-go. Where no bound leaves
//! the range of the program's precision, no input does; where one does, the bound may be too wide, so
//! a corner of the inputs is tried with the interpreter, and only what overflows there is refuted.
//!
//! Two things are taken on trust: that a library's functions are exact to two units in the last place,
//! and that an iteration ends no further from its root than its last step may be long.

pub(crate) mod bounds;
mod cells;
mod computed;
pub(super) mod regular;
mod report;
#[cfg(test)]
mod tests;

pub use computed::Computed;
#[cfg(feature = "lab")]
pub(crate) use computed::apply;
pub(crate) use computed::outward;

use bounds::Bounds;
#[cfg(feature = "lab")]
pub(crate) use report::describe;
#[cfg(not(feature = "lab"))]
use report::describe;
use report::input_name;

use crate::limits::CELLS;
use crate::parameter::Precision;
use crate::program::interpret::Interpreter;
use crate::program::{Input, Op, Program, Value, number};

/// A value that may leave the range.
#[derive(Clone, Debug, PartialEq)]
pub struct Excess {
    /// The value: the first in order of computation.
    pub value: Value,
    /// Its name, or the expression that it is.
    pub what: String,
    /// The piece of time-to-go.
    pub time_to_go: (f64, f64),
    /// The other inputs at which it may, with their names.
    pub inputs: Vec<(String, Computed)>,
    /// Inputs at which the decoupling matrix was not shown to be regular, if that is why.
    pub singular: Option<Vec<(String, Computed)>>,
    /// A time-to-go at which the interpreter overflows at one end of each input.
    pub refuted_at: Option<f64>,
}

/// Result of the range check of a program's values.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    /// Precision of the program.
    pub precision: Precision,
    /// Time-to-go that was covered.
    pub time_to_go: (f64, f64),
    /// Value that may leave the range in `step`, at the largest time-to-go at which one does.
    pub step: Option<Excess>,
    /// Value that may leave the range in `tick` or `axis`, which compute the gains alone.
    pub axis: Option<Excess>,
}

/// Scans time-to-go from `tau` down to `eps` in `pieces` of equal ratio. `input` bounds every input
/// but time and the gains, by numbers of the program's precision. Some 20 pieces per decade separate
/// what overflows and what does not in every family.
pub fn scan(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    eps: f64,
    tau: f64,
    pieces: u32,
) -> Envelope {
    let pieces = pieces.max(1);
    let mut early = Bounds::new(program, input);
    let singular = settle_divisors(program, input, &mut early);
    // The program's own time-to-go has a rounding or two, but is never below eps.
    let slack = 2.0 * program.precision.epsilon();
    let (mut step, mut axis) = (None, None);
    let controls = program.controls();
    let handed: Vec<_> = program.handed_over().copied().collect();
    let mut high = tau;
    for piece in 1..=pieces {
        let low = if piece == pieces {
            eps
        } else {
            tau * (eps / tau).powf(f64::from(piece) / f64::from(pieces))
        };
        let mut bounds = early.at((low * (1.0 - slack)).max(eps), high * (1.0 + slack));
        let found = |value: Value| Found { value, time_to_go: (low, high) };
        step = step.or_else(|| bounds.first_excess(&controls).map(found));
        axis = axis.or_else(|| {
            let gain = bounds.first_excess(&handed);
            bounds.hand_over_gains();
            gain.or_else(|| bounds.first_excess(program.axis.as_slice())).map(found)
        });
        if step.is_some() && axis.is_some() {
            break;
        }
        high = low;
    }
    let report = |found: Found, roots: &[Value]| {
        let at = |t, root: &Value| overflow(program, input, tau, t, *root);
        let overflow = |t| roots.iter().find_map(|root| at(t, root));
        Excess {
            value: found.value,
            what: describe(program, found.value),
            time_to_go: found.time_to_go,
            inputs: named_inputs(program, input),
            singular: singular
                .as_ref()
                .filter(|_| is_solution(program, found.value))
                .map(|cell| named(cell)),
            refuted_at: [found.time_to_go.0, eps].into_iter().find_map(overflow),
        }
    };
    Envelope {
        precision: program.precision,
        time_to_go: (eps, tau),
        step: step.map(|found| report(found, &controls)),
        axis: axis.zip(program.axis).map(|(found, root)| report(found, &[root])),
    }
}

/// Shows that every control of a program that time does not enter stays in range.
///
/// # Errors
/// Returns what could not be shown.
pub(crate) fn covered(program: &Program, input: &dyn Fn(Input) -> Computed) -> Result<(), String> {
    let mut bounds = Bounds::new(program, input);
    let singular = settle_divisors(program, input, &mut bounds);
    let Some(value) = bounds.first_excess(&program.controls()) else { return Ok(()) };
    Err(match singular.filter(|_| is_solution(program, value)) {
        Some(cell) => {
            let cell = report::all_given(&named(&cell));
            format!("the decoupling matrix is not shown to be regular for {cell}")
        }
        None => format!("{} is not shown to be a number", describe(program, value)),
    })
}

/// Sets the bounds of what operations divide by, take roots or logarithms of, and of matrices, where one interval of
/// each input leaves their domain and smaller cells do not. Gives a cell in which a matrix may be singular.
fn settle_divisors(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    early: &mut Bounds<'_>,
) -> Option<cells::Cell> {
    let (mut done, mut work) = (Vec::new(), CELLS.size());
    for (value, need) in cells::critical(program) {
        if done.contains(&(value, need)) || !cells::is_bounded(program, &[value]) {
            continue;
        }
        done.push((value, need));
        if need.is_met(Bounds::only(program, input, &[value]).get(value)) {
            continue;
        }
        if let Some(bound) = cells::refined(program, input, (value, need), &mut work) {
            early.set(value, bound);
        }
    }
    let mut singular = None;
    for (index, definition) in program.values.iter().enumerate() {
        let Op::Elimination { matrix, .. } = &definition.op else { continue };
        if !cells::is_bounded(program, matrix) {
            continue;
        }
        match cells::regular(program, input, matrix, &mut work) {
            Ok(bounds) => early.set_regular(Value(index), bounds),
            Err(cell) => singular = Some(cell),
        }
    }
    singular
}

/// Returns true if a value is solved for by an elimination.
fn is_solution(program: &Program, value: Value) -> bool {
    let Op::Element(array, _) = program.get(value).op else { return false };
    matches!(program.get(array).op, Op::Elimination { .. })
}

/// Value whose bound left the range, and the piece of time-to-go.
#[derive(Clone, Copy)]
struct Found {
    value: Value,
    time_to_go: (f64, f64),
}

/// The time-to-go, next to the given one, at which `root` is not finite with parameters all at their
/// lower or all at their upper ends. States are at those ends that give all terms of u one sign; a
/// law or an input gain that is an expression has no such ends, and is tried at those of the
/// parameters and, as it may divide by a state, in the middle.
fn overflow(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    tau: f64,
    time_to_go: f64,
    root: Value,
) -> Option<f64> {
    let settle = |value| number::settle(value, program.precision);
    let corners = [(false, false), (true, false), (false, true)];
    corners.into_iter().find_map(|(upper, middle)| {
        let end =
            |bound: Computed, upper| if upper { bound.range.high() } else { bound.range.low() };
        let early = |asked: Input| match asked {
            Input::Time => {
                let start = end(input(Input::StartTime), upper);
                settle(settle(start + tau) - settle(time_to_go))
            }
            other => end(input(other), upper),
        };
        let mut interpreter = Interpreter::new(program, &early);
        let gains: Vec<_> = program.gains.iter().map(|gain| interpreter.value(*gain)).collect();
        let divisor = program.divisors.first().map(|value| interpreter.value(*value));
        let aligned = |asked: Input| match asked {
            Input::State(_) if middle => {
                settle(f64::midpoint(input(asked).range.low(), input(asked).range.high()))
            }
            Input::State(j) => {
                end(input(asked), gains.get(j - 1).map_or(upper, |gain| *gain >= 0.0))
            }
            Input::Gain(j) => gains.get(j - 1).copied().unwrap_or(f64::NAN),
            Input::Divisor => divisor.unwrap_or(f64::NAN),
            other => early(other),
        };
        let finite = Interpreter::new(program, &aligned).value(root).is_finite();
        (!finite).then(|| -interpreter.value(program.limits.late))
    })
}

/// Every input that u depends on but time, with its bounds.
fn named_inputs(program: &Program, input: &dyn Fn(Input) -> Computed) -> Vec<(String, Computed)> {
    let needed = program.needed(&program.controls()).into_iter();
    let given = needed.filter_map(|value| match program.get(value).op {
        Op::Input(Input::Time) => None,
        Op::Input(asked) => Some((asked, input(asked))),
        _ => None,
    });
    named(&given.collect::<Vec<_>>())
}

fn named(inputs: &[(Input, Computed)]) -> Vec<(String, Computed)> {
    inputs.iter().map(|(asked, bound)| (input_name(*asked), *bound)).collect()
}
