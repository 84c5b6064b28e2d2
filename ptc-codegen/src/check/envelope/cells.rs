//! Bounds of a value over cells of the inputs, for what one interval of each is too wide.
//!
//! The divisor 2 + 3 cos(q) sin(q) is far from 0 at every q, while its interval over a whole turn holds 0.
//! A cell in which the domain of an operation may be left, or a matrix be singular, is halved in the input that helps
//! most; where no such cell remains, the hull of the bounds is one of the value.

use super::bounds::Bounds;
use super::computed::Computed;
use super::regular::Regular;
use crate::expression::function::Domain;
use crate::program::{Input, Op, Program, Value};

/// Requirement of an operation on one operand.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Need {
    /// A divisor that is not 0.
    NotZero,
    Within(Domain),
}

impl Need {
    /// Returns true if every number of an operand meets it.
    pub(super) fn is_met(self, operand: Computed) -> bool {
        match self {
            Self::NotZero => !operand.special && !operand.range.has_zero(),
            Self::Within(domain) => operand.is_within(domain),
        }
    }
}

/// Largest ratio of the widths of a cell, each relative to the whole interval.
const FLATTEST: f64 = 256.0;

/// Inputs with their intervals.
pub(super) type Cell = Vec<(Input, Computed)>;

/// The operands that decide whether operations have a value, with what is needed of them.
pub(super) fn critical(program: &Program) -> Vec<(Value, Need)> {
    let mut found = Vec::new();
    for definition in program.values.iter().filter(|definition| !definition.looped) {
        found.push(match definition.op {
            Op::Div(_, b) | Op::Quotient(_, b) => (b, Need::NotZero),
            Op::Pow(a, _) => (a, Need::Within(Domain::Positive)),
            Op::Call(function, a) if function.row().domain != Domain::Everywhere => {
                (a, Need::Within(function.row().domain))
            }
            _ => continue,
        });
    }
    found
}

/// Returns true if values are computed from bounded inputs only, without a loop and without the time-to-go, which is
/// bounded piece by piece.
pub(super) fn is_bounded(program: &Program, values: &[Value]) -> bool {
    let limits = &program.limits;
    let of_pieces =
        |v: Value| v == limits.late || limits.elapsed.is_some_and(|(elapsed, _)| v == elapsed);
    program.needed(values).into_iter().all(|value| match program.get(value).op {
        _ if of_pieces(value) => false,
        Op::Input(
            Input::Parameter(_)
            | Input::StartTime
            | Input::Time
            | Input::State(_)
            | Input::StateAtStart(_),
        ) => true,
        Op::Input(_) | Op::Unknown | Op::Root(_) | Op::Law(_) => false,
        _ => !program.get(value).looped,
    })
}

/// A bound of `value` as it is needed; `None` where the cells do not show one. `work` is what may be done.
pub(super) fn refined(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    (value, need): (Value, Need),
    work: &mut usize,
) -> Option<Computed> {
    let mut hull = None::<Computed>;
    let mut miss = |bounds: &Bounds<'_>| {
        let bound = bounds.get(value);
        if !need.is_met(bound) {
            return f64::INFINITY;
        }
        hull = Some(hull.map_or(bound, |hull| hull.range.hull(&bound.range).into()));
        0.0
    };
    cover(program, input, &[value], &mut miss, work).ok()?;
    hull.filter(|hull| need.is_met(*hull))
}

/// Bounds of all matrices with these entries; else a cell in which one may be singular.
pub(super) fn regular(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    matrix: &[Value],
    work: &mut usize,
) -> Result<Regular, Cell> {
    let mut all = None::<Regular>;
    let mut miss = |bounds: &Bounds<'_>| match Regular::of(&bounds.all(matrix), program.precision) {
        Ok(found) => {
            all = Some(all.map_or(found, |all| all.with(found)));
            0.0
        }
        Err(miss) => miss,
    };
    cover(program, input, matrix, &mut miss, work)?;
    all.ok_or_else(Cell::new)
}

/// Cuts the inputs of values into cells until the bounds of each miss nothing; else a cell whose bounds do.
fn cover(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    values: &[Value],
    miss: &mut dyn FnMut(&Bounds<'_>) -> f64,
    work: &mut usize,
) -> Result<(), Cell> {
    let needed = program.needed(values);
    let asked = |value: &Value| match program.get(*value).op {
        Op::Input(asked) => Some(asked),
        _ => None,
    };
    let inputs: Vec<Input> = needed.iter().filter_map(asked).collect();
    let whole: Vec<Computed> = inputs.iter().map(|asked| input(*asked)).collect();
    let mut of = |cell: &[Computed]| {
        let of_cell = |asked: Input| {
            let own = inputs.iter().position(|input| *input == asked);
            own.map_or(Computed::ANY, |index| cell[index])
        };
        *work = work.checked_sub(needed.len() + values.len())?;
        Some(miss(&Bounds::only(program, &of_cell, values)))
    };
    let mut left = vec![whole.clone()];
    while let Some(cell) = left.pop() {
        match of(&cell) {
            Some(miss) if miss <= 0.0 => continue,
            Some(_) => {}
            None => return Err(inputs.into_iter().zip(cell).collect()),
        }
        match halves(&whole, &cell, &mut of) {
            Some(halves) => left.extend(halves),
            None => return Err(inputs.into_iter().zip(cell).collect()),
        }
    }
    Ok(())
}

/// The halves of a cell, cut in the input at whose middle least is missed, of equals where it is widest in parts of
/// the whole; `None` where that is a number.
fn halves(
    whole: &[Computed],
    cell: &[Computed],
    miss: &mut dyn FnMut(&[Computed]) -> Option<f64>,
) -> Option<[Vec<Computed>; 2]> {
    let width = |x: &Computed| x.range.high() - x.range.low();
    let share = |index: usize| {
        if width(&whole[index]) > 0.0 { width(&cell[index]) / width(&whole[index]) } else { 0.0 }
    };
    let middle = |index: usize| {
        let [low, high] = cell[index].range.ends();
        f64::midpoint(low, high)
    };
    let mut tried: Vec<_> = (0..cell.len()).filter(|index| width(&cell[*index]) > 0.0).collect();
    tried.sort_by(|a, b| share(*b).total_cmp(&share(*a)));
    // At a zero nothing helps but a small cell.
    let widest = share(*tried.first()?);
    tried.retain(|index| share(*index) * FLATTEST >= widest);
    let mut least = (f64::INFINITY, *tried.first()?);
    for index in tried {
        let mut flat = cell.to_vec();
        flat[index] = Computed::point(middle(index));
        let missed = miss(&flat)?;
        if missed < least.0 {
            least = (missed, index);
        }
    }
    let cut = least.1;
    let ([low, high], middle) = (cell[cut].range.ends(), middle(cut));
    if !middle.is_finite() || middle <= low || middle >= high {
        return None;
    }
    let with = |from: f64, to: f64| {
        let mut half = cell.to_vec();
        half[cut] = Computed::new(from, to);
        half
    };
    Some([with(low, middle), with(middle, high)])
}
