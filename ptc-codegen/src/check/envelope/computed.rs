//! Intervals that hold what a program computes, not what exact arithmetic would.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::expression::enclosure::Range;
use crate::expression::function::{Domain, Pieces};
use crate::parameter::Precision;
use crate::program::{self, Op, number};

/// Numbers within a range, and possibly infinities and NaN besides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Computed {
    pub(crate) range: Range,
    /// True if the value may be infinite or NaN.
    pub(crate) special: bool,
}

impl From<Range> for Computed {
    fn from(range: Range) -> Self {
        Self { range, special: !range.is_bounded() }
    }
}

impl Computed {
    /// Anything at all.
    pub(crate) const ANY: Self = Self { range: Range::WHOLE, special: true };

    /// The numbers from `low` to `high`.
    pub(crate) fn new(low: f64, high: f64) -> Self {
        Self::from(Range::new(low, high))
    }

    /// One number.
    pub(crate) fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// Returns true if every number is finite and within a domain; an end of an open domain belongs to it where a
    /// function may have its infinite limit.
    pub(crate) fn is_within(self, domain: Domain) -> bool {
        !self.special && self.within(domain) == Some(self)
    }

    /// The part within a domain; `None` if it is empty, or where a function has no bound.
    fn within(self, domain: Domain) -> Option<Self> {
        if domain == Domain::OffPoles {
            return Some(self).filter(|a| !turns(*a, FRAC_PI_2, PI));
        }
        let [low, high] = domain.edges();
        let [least, most] = self.range.ends();
        let mut part = [least, most];
        if let Some(edge) = low {
            let at = edge.at();
            if !edge.closed && least <= at || most < at {
                return None;
            }
            part[0] = least.max(at);
        }
        if let Some(edge) = high {
            let at = edge.at();
            if !edge.closed && most >= at || least > at {
                return None;
            }
            part[1] = most.min(at);
        }
        Some(Self { range: Range::new(part[0], part[1]), special: self.special })
    }
}

/// The results of `op` on operands from `operands`, in the order of [`Op::operands`]; for inputs, the
/// unknown and the root, which need more than operands, anything.
///
/// Each operation is monotone in each operand where it is defined, except for even powers and functions that turn,
/// which say where: extremes lie at the corners. Rounding to nearest is monotone too, so corners rounded as
/// the program rounds bound what it computes, with nothing to add. The functions of a library are
/// taken to be exact to two units in the last place.
pub(crate) fn apply(op: &Op, operands: &[Computed], precision: Precision) -> Computed {
    if matches!(op, Op::Input(_) | Op::Unknown | Op::Root(_) | Op::Law(_)) {
        return Computed::ANY;
    }
    let mut operands = operands.to_vec();
    let mut special = operands.iter().any(|operand| operand.special);
    match (op, operands.as_mut_slice()) {
        (Op::Div(..) | Op::Quotient(..), [_, divisor]) if divisor.range.has_zero() => {
            return Computed::ANY;
        }
        (Op::Pow(..), [a, ..]) if !a.range.is_positive() => return Computed::ANY,
        (Op::Call(function, _), [a]) => match a.within(function.row().domain) {
            None => return Computed::ANY,
            Some(within) => {
                special |= within != *a;
                *a = within;
            }
        },
        _ => {}
    }
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for corner in corners(op, &operands) {
        match program::apply(op, &corner, precision) {
            Some(value) if !value.is_nan() => {
                low = low.min(value);
                high = high.max(value);
            }
            _ => return Computed::ANY,
        }
    }
    let least = match op {
        Op::Call(function, _) if function.is_of_library() => {
            let positive = function.row().bounds[0].is_some_and(|least| least >= 0);
            Some(if positive { 0.0 } else { f64::NEG_INFINITY })
        }
        Op::Pow(..) => Some(0.0),
        _ => None,
    };
    if let Some(least) = least {
        for _ in 0..2 {
            low = down(low, precision).max(least);
            high = -down(-high, precision);
        }
    }
    if let (Op::Call(function, _), [a]) = (op, &operands[..])
        && let Pieces::Wave(quarters) = function.row().pieces
    {
        let most = f64::from(quarters) * FRAC_PI_2;
        low = if turns(*a, most - PI, TAU) { -1.0 } else { low.max(-1.0) };
        high = if turns(*a, most, TAU) { 1.0 } else { high.min(1.0) };
    }
    let computed = Computed::new(low, high);
    Computed { special: special || computed.special, ..computed }
}

/// Returns true if an interval may hold `first` or a number that is a multiple of `period` away from it.
fn turns(a: Computed, first: f64, period: f64) -> bool {
    // Beyond it a turn in doubles has no digits left.
    const FAR: f64 = 1e6;
    // Far more than doubles of this size round.
    let [low, high] = a.range.ends().map(|end| (end - first) / period);
    a.range.ends().iter().any(|end| end.abs() > FAR) || (low - 1e-9).ceil() <= high + 1e-9
}

/// The points at which the extremes of `op` lie.
fn corners(op: &Op, operands: &[Computed]) -> Vec<Vec<f64>> {
    // The ends, and 0 between them.
    let turns = |a: &Computed| a.range.ends().into_iter().chain(a.range.has_zero().then_some(0.0));
    let ends = |a: &Computed| a.range.ends().into_iter();
    match (op, operands) {
        (Op::Call(function, _), [a]) if function.row().pieces == Pieces::Valley => {
            turns(a).map(|x| vec![x]).collect()
        }
        (Op::Power(..), [a]) => turns(a).map(|x| vec![x]).collect(),
        (Op::Mul(a, b), [x, _]) if a == b => turns(x).map(|x| vec![x, x]).collect(),
        (Op::Fused(a, b, _), [x, _, c]) if a == b => {
            turns(x).flat_map(|x| ends(c).map(move |c| vec![x, x, c])).collect()
        }
        (_, operands) => operands.iter().fold(vec![Vec::new()], |corners, operand| {
            let with = |corner: &Vec<f64>, end| [&corner[..], &[end]].concat();
            corners.iter().flat_map(|corner| ends(operand).map(|end| with(corner, end))).collect()
        }),
    }
}

/// The next number below in `precision`.
#[allow(clippy::cast_possible_truncation)]
fn down(value: f64, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => value.next_down(),
        Precision::F32 => f64::from((value as f32).next_down()),
    }
}

/// The numbers of `precision` nearest to `low` and `high` that hold both between them.
pub(crate) fn outward(low: f64, high: f64, precision: Precision) -> Computed {
    let below = |value: f64| {
        let rounded = number::settle(value, precision);
        if rounded <= value { rounded } else { down(rounded, precision) }
    };
    Computed::new(below(low), -below(-high))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::algebra::integer;
    use crate::expression::Function;
    use crate::program::Value;

    const A: Value = Value(0);
    const B: Value = Value(1);
    const C: Value = Value(2);

    fn on(op: &Op, operands: &[(f64, f64)]) -> Computed {
        let operands: Vec<_> = operands.iter().map(|(a, b)| Computed::new(*a, *b)).collect();
        apply(op, &operands, Precision::F64)
    }

    #[test]
    fn operations_enclose_corners_and_extremes() {
        assert_eq!(on(&Op::Sub(A, B), &[(1.0, 2.0), (5.0, 7.0)]), Computed::new(-6.0, -3.0));
        assert_eq!(on(&Op::Mul(A, B), &[(-1.0, 2.0), (-3.0, 5.0)]), Computed::new(-6.0, 10.0));
        assert_eq!(on(&Op::Mul(A, A), &[(-1.0, 2.0), (-1.0, 2.0)]), Computed::new(0.0, 4.0));
        let fused = [(-1.0, 2.0), (-3.0, 5.0), (-1.0, 0.5)];
        assert_eq!(on(&Op::Fused(A, B, C), &fused), Computed::new(-7.0, 10.5));
        let square = [(-1.0, 2.0), (-1.0, 2.0), (-1.0, 0.5)];
        assert_eq!(on(&Op::Fused(A, A, C), &square), Computed::new(-1.0, 4.5));
        assert_eq!(on(&Op::Power(A, 2), &[(-3.0, 2.0)]), Computed::new(0.0, 9.0));
        assert_eq!(on(&Op::Power(A, 3), &[(-3.0, 2.0)]), Computed::new(-27.0, 8.0));
        assert_eq!(on(&Op::Call(Function::Abs, A), &[(-3.0, 2.0)]), Computed::new(0.0, 3.0));
        assert_eq!(on(&Op::Min(A, B), &[(-3.0, 2.0), (0.0, 1.0)]), Computed::new(-3.0, 1.0));
        assert_eq!(on(&Op::Number(integer(3)), &[]), Computed::point(3.0));
    }

    #[test]
    fn sine_and_cosine_ranges_include_their_extremes() {
        for (function, shift) in [(Function::Sin, 0.0), (Function::Cos, -FRAC_PI_2)] {
            for turn in [-40.0, -1.0, 0.0, 1.0, 300.0] {
                let at = |low: f64, high: f64| {
                    let by = std::f64::consts::TAU * turn + shift;
                    let found = on(&Op::Call(function, A), &[(low + by, high + by)]);
                    found.range.ends()
                };
                let close = |found: [f64; 2], least: f64, most: f64| {
                    let within = found[0] <= least + 1e-12 && most - 1e-12 <= found[1];
                    assert!(within, "{function:?} {turn}: {found:?}");
                    let apart = (found[0] - least).abs().max((found[1] - most).abs());
                    assert!(apart < 1e-12, "{function:?} {turn}: {found:?}");
                };
                close(at(0.1, 1.5), 0.1f64.sin(), 1.5f64.sin());
                close(at(1.5, 1.6), 1.6f64.sin().min(1.5f64.sin()), 1.0);
                close(at(2.0, 4.0), 4f64.sin(), 2f64.sin());
                close(at(3.0, 5.0), -1.0, 3f64.sin());
                close(at(-0.5, 0.25), -0.5f64.sin(), 0.25f64.sin());
                close(at(1.0, 5.0), -1.0, 1.0);
                close(at(0.0, 7.0), -1.0, 1.0);
                close(at(FRAC_PI_2, FRAC_PI_2), 1.0, 1.0);
            }
            let far = on(&Op::Call(function, A), &[(1e17, 1e17)]);
            assert_eq!(far, Computed::new(-1.0, 1.0));
        }
    }

    #[test]
    fn results_outside_the_domain_are_special() {
        assert_eq!(on(&Op::Div(A, B), &[(1.0, 2.0), (-1.0, 1.0)]), Computed::ANY);
        assert_eq!(on(&Op::Call(Function::Ln, A), &[(0.0, 2.0)]), Computed::ANY);
        let root = on(&Op::Call(Function::Sqrt, A), &[(-1.0, 4.0)]);
        assert_eq!(root, Computed { special: true, ..Computed::new(0.0, 2.0) });
        assert!(on(&Op::Call(Function::Exp, A), &[(0.0, 800.0)]).special);
        let infinite = Computed::new(0.0, f64::INFINITY);
        assert!(apply(&Op::Call(Function::Sin, A), &[infinite], Precision::F64).special);
        let huge = Computed::new(0.0, 1e30);
        assert!(apply(&Op::Power(A, 2), &[huge], Precision::F32).special);
        assert!(!apply(&Op::Power(A, 2), &[huge], Precision::F64).special);
        let never = Computed { special: true, ..huge };
        assert!(apply(&Op::Neg(A), &[never], Precision::F64).special, "once lost, always lost");
    }

    #[test]
    fn ends_are_rounded_outward() {
        let tenth = outward(0.1, 0.1, Precision::F32);
        let [low, high] = tenth.range.ends();
        assert!(low < 0.1 && 0.1 < high && high - low < 1e-8);
        assert_eq!(outward(0.1, 0.1, Precision::F64), Computed::point(0.1));
    }

    proptest! {
        #[test]
        fn computed_results_lie_within_the_enclosure(
            a in (-9.0..9.0f64, 0.0..4.0f64, 0.0..=1.0f64),
            b in (-9.0..9.0f64, 0.0..4.0f64, 0.0..=1.0f64),
            c in (-9.0..9.0f64, 0.0..4.0f64, 0.0..=1.0f64),
        ) {
            let ops = [
                Op::Neg(A), Op::Power(A, 2), Op::Power(A, 5), Op::Add(A, B), Op::Sub(A, B),
                Op::Mul(A, B), Op::Div(A, B), Op::Quotient(A, B), Op::Max(A, B), Op::Min(A, B),
                Op::Pow(A, B), Op::Fused(A, B, C), Op::Fused(A, A, C),
            ];
            let calls = Function::ALL.map(|(_, function)| Op::Call(function, A));
            for precision in [Precision::F64, Precision::F32] {
                for op in ops.iter().chain(&calls) {
                    let draw = |(low, width, share): (f64, f64, f64)| {
                        let settle = |x| number::settle(x, precision);
                        let (low, high) = (settle(low), settle(low + width));
                        (Computed::new(low, high), settle(low + share * (high - low)))
                    };
                    let own = op.operands().into_iter().map(|v| draw([a, b, c][v.0]));
                    let drawn: Vec<_> = own.collect();
                    let (boxes, points): (Vec<_>, Vec<_>) = drawn.into_iter().unzip();
                    let bound = apply(op, &boxes, precision);
                    let value = program::apply(op, &points, precision).expect("numbers");
                    let [low, high] = bound.range.ends();
                    prop_assert!(
                        (low <= value && value <= high) || (bound.special && !value.is_finite()),
                        "{op:?} {boxes:?} {points:?}: {value} outside {bound:?}"
                    );
                }
            }
        }
    }
}
