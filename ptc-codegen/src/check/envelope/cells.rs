//! Bounds of a value over cells of the inputs, for what one interval of each is too wide.
//!
//! The divisor 2 + 3 cos(q) sin(q) is far from 0 at every q, while its interval over a whole turn holds 0.
//! A cell in which the domain of an operation may be left is halved in the input in which it is widest;
//! where no such cell remains, the hull of the bounds is one of the value.

use super::bounds::Bounds;
use super::computed::Computed;
use crate::expression::Function;
use crate::program::{Input, Op, Program, Value};

/// What an operation needs of one operand.
type Domain = fn(Computed) -> bool;

/// The operands that decide whether operations have a value, with what is needed of them.
pub(super) fn critical(program: &Program) -> Vec<(Value, Domain)> {
    let mut found: Vec<(Value, Domain)> = Vec::new();
    for definition in program.values.iter().filter(|definition| !definition.looped) {
        let (value, domain): (Value, Domain) = match definition.op {
            Op::Div(_, b) | Op::Quotient(_, b) => (b, |x| !x.special && !x.range.has_zero()),
            Op::Pow(a, _) | Op::Call(Function::Ln, a) => {
                (a, |x| !x.special && x.range.is_positive())
            }
            Op::Call(Function::Sqrt, a) => (a, |x| !x.special && x.range.is_not_negative()),
            _ => continue,
        };
        found.push((value, domain));
    }
    found
}

/// Whether a value is computed from inputs that have bounds, without a loop and without the time-to-go,
/// which is bounded piece by piece.
pub(super) fn is_bounded(program: &Program, value: Value) -> bool {
    let limits = &program.limits;
    let of_pieces =
        |v: Value| v == limits.late || limits.elapsed.is_some_and(|(elapsed, _)| v == elapsed);
    program.needed(&[value]).into_iter().all(|value| match program.get(value).op {
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

/// A bound of `value` in the domain; none where the cells do not show one. `work` is what may be done.
pub(super) fn refined(
    program: &Program,
    input: &dyn Fn(Input) -> Computed,
    (value, domain): (Value, Domain),
    work: &mut usize,
) -> Option<Computed> {
    let needed = program.needed(&[value]);
    let asked = |value: &Value| match program.get(*value).op {
        Op::Input(asked) => Some(asked),
        _ => None,
    };
    let inputs: Vec<Input> = needed.iter().filter_map(asked).collect();
    let whole: Vec<Computed> = inputs.iter().map(|asked| input(*asked)).collect();
    let (mut left, mut hull) = (vec![whole.clone()], None::<Computed>);
    while let Some(cell) = left.pop() {
        *work = work.checked_sub(program.values.len())?;
        let of_cell = |asked: Input| {
            let own = inputs.iter().position(|input| *input == asked);
            own.map_or(Computed::ANY, |index| cell[index])
        };
        let bound = Bounds::of(program, &of_cell, value);
        if domain(bound) {
            hull = Some(hull.map_or(bound, |hull| hull.range.hull(&bound.range).into()));
        } else {
            left.extend(halves(&whole, &cell)?);
        }
    }
    hull.filter(|hull| domain(*hull))
}

/// The halves of a cell, cut where it is widest in parts of the whole; none where that is a number.
fn halves(whole: &[Computed], cell: &[Computed]) -> Option<[Vec<Computed>; 2]> {
    let share = |index: usize| {
        let width = |x: &Computed| x.range.high() - x.range.low();
        if width(&whole[index]) > 0.0 { width(&cell[index]) / width(&whole[index]) } else { 0.0 }
    };
    let widest = (0..cell.len()).max_by(|a, b| share(*a).total_cmp(&share(*b)))?;
    let [low, high] = cell[widest].range.ends();
    let middle = f64::midpoint(low, high);
    if !middle.is_finite() || middle <= low || middle >= high {
        return None;
    }
    let with = |from: f64, to: f64| {
        let mut half = cell.to_vec();
        half[widest] = Computed::new(from, to);
        half
    };
    Some([with(low, middle), with(middle, high)])
}
