//! Instructions, in all lanes.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::tape::{Instruction, Loop, Work};
use super::{LANES, Pack, vectorized};
use crate::expression::Function;
use crate::parameter::Precision;
use crate::program::Root;
use crate::program::arithmetic::{Arithmetic, of_platform};
use crate::program::rows::rows;

/// In order.
pub(super) fn perform(due: &[Instruction], registers: &mut [Pack], arrays: &mut [Vec<Pack>]) {
    vectorized!(all(due, registers, arrays));
}

#[inline(always)]
fn all(due: &[Instruction], registers: &mut [Pack], arrays: &mut [Vec<Pack>]) {
    for Instruction { to, work } in due {
        let to = *to;
        match work {
            Work::Arithmetic(operation) => apply(operation, registers, to),
            Work::Plus(of) => registers[to] = three(registers, of, |a, b, c| a * b + c),
            Work::Minus(of) => registers[to] = three(registers, of, |a, b, c| a * b - c),
            Work::Less(of) => registers[to] = three(registers, of, |a, b, c| c - a * b),
            Work::Element(array, element) => registers[to] = arrays[*array][*element],
            Work::Rows { tail, weights, fused } => {
                arrays[to] = of_rows(tail, weights, *fused, registers);
                // An array is no number.
                registers[to] = Pack::all(f64::NAN);
            }
            Work::Root(root) => registers[to] = solve(root, registers, arrays),
        }
    }
}

#[inline(never)]
fn of_rows(tail: &[usize], weights: &[usize], fused: bool, registers: &[Pack]) -> Vec<Pack> {
    let [tail, weights] =
        [tail, weights].map(|places| places.iter().map(|p| registers[*p]).collect::<Vec<_>>());
    let more = |a: Pack, b: Pack, c: Pack| match fused {
        true => Pack::of(|lane| a.0[lane].mul_add(b.0[lane], c.0[lane])),
        false => two(&c, &two(&a, &b, mul), add),
    };
    rows(&tail, &weights, |a, b| two(&a, &b, add), more)
}

#[inline(always)]
fn two(a: &Pack, b: &Pack, f: impl Fn(f64, f64) -> f64) -> Pack {
    let mut out = Pack::all(0.0);
    for lane in 0..LANES {
        out.0[lane] = f(a.0[lane], b.0[lane]);
    }
    out
}

#[inline(always)]
fn three(registers: &[Pack], of: &[usize; 3], f: impl Fn(f64, f64, f64) -> f64) -> Pack {
    let [a, b, c] = of;
    let [a, b, c] = [&registers[*a], &registers[*b], &registers[*c]];
    Pack::of(
        #[inline(always)]
        |lane| f(a.0[lane], b.0[lane], c.0[lane]),
    )
}

#[inline(always)]
fn add(a: f64, b: f64) -> f64 {
    a + b
}

#[inline(always)]
fn mul(a: f64, b: f64) -> f64 {
    a * b
}

/// An operation in each lane; those that are loops of a compiler's vectors are written out. Each writes its
/// own result: one that all hand over would be copied once more.
#[inline(always)]
pub(crate) fn apply(operation: &Arithmetic, registers: &mut [Pack], to: usize) {
    let at = |place: usize| &registers[place];
    match *operation {
        Arithmetic::Number(value) => registers[to] = Pack::all(value),
        Arithmetic::Neg(a) => registers[to] = two(at(a), at(a), |a, _| -a),
        Arithmetic::Add(a, b) => registers[to] = two(at(a), at(b), add),
        Arithmetic::Sub(a, b) => registers[to] = two(at(a), at(b), |a, b| a - b),
        Arithmetic::Mul(a, b) => registers[to] = two(at(a), at(b), mul),
        Arithmetic::Div(a, b) => registers[to] = two(at(a), at(b), |a, b| a / b),
        Arithmetic::Fused(a, b, c) => {
            registers[to] = three(registers, &[a, b, c], |a, b, c| a.mul_add(b, c));
        }
        Arithmetic::Max(a, b) => {
            registers[to] = two(at(a), at(b), |a, b| if a < b { b } else { a });
        }
        Arithmetic::Min(a, b) => {
            registers[to] = two(at(a), at(b), |a, b| if a < b { a } else { b });
        }
        Arithmetic::Call(Function::Sqrt, a) => registers[to] = two(at(a), at(a), |a, _| a.sqrt()),
        Arithmetic::Copy(a) => registers[to] = *at(a),
        operation => registers[to] = one_by_one(&operation, registers),
    }
}

#[inline(never)]
fn one_by_one(operation: &Arithmetic, registers: &[Pack]) -> Pack {
    // The function is found once for all lanes.
    if let Arithmetic::Call(function, a) = *operation {
        return registers[a].map(of_platform(function).0);
    }
    Pack::of(|lane| operation.result(|place| registers[place].0[lane], Precision::F64))
}

/// The rounds that the slowest lane takes; one whose step is small enough keeps its root meanwhile.
#[inline(never)]
fn solve(root: &Loop, registers: &mut [Pack], arrays: &mut [Vec<Pack>]) -> Pack {
    let [mut y, mut low, mut high] =
        [root.start, root.low, root.high].map(|place| registers[place]);
    let tolerance = registers[root.tolerance];
    let mut done = [false; LANES];
    for round in 0..root.rounds {
        registers[root.unknown] = y;
        perform(&root.body, registers, arrays);
        for lane in 0..LANES {
            if done[lane] {
                continue;
            }
            let at = |place: usize| registers[place].0[lane];
            let bound = if at(root.residual) > 0.0 { &mut low } else { &mut high };
            bound.0[lane] = y.0[lane];
            let (low, high, next) = (low.0[lane], high.0[lane], at(root.next));
            let inside = next >= low && next <= high;
            y.0[lane] = if inside { next } else { 0.5 * (low + high) };
            done[lane] = at(root.size) <= tolerance.0[lane];
            if !done[lane] && round >= root.proposals {
                y.0[lane] = Root::middle(low, high, Precision::F64);
            }
        }
        if done.iter().all(|done| *done) {
            break;
        }
    }
    y
}
