//! Search for a point at which a continuous expression passes through 0.
//!
//! Points of a box are tried until two have values of certain, opposite signs; where all have one, a
//! descent from the smallest values looks for the other. Halving the stretch
//! between them, as far as signs are certain, leaves a short one, over which the expression is proved
//! to be continuous: by the intermediate value theorem it is 0 there. At a pole or a jump that proof
//! fails, and nothing is claimed.

use super::enclosure::{Interval, Range};
use super::evaluator::{Evaluator, Existence, Names};
pub(crate) use super::points::Free;
use super::points::{Point, distance, midpoint, points};
use super::{Expression, Function, Node};

/// More halvings than a double has bits gain nothing.
const HALVINGS: u32 = 60;
/// Points from which a descent starts, and the step at which it ends, as a part of each range.
const DESCENTS: usize = 3;
const LAST_STEP: f64 = 1e-5;
/// Halvings of a stretch over which continuity is not seen at once.
const SPLITS: u32 = 6;

/// Location of a zero of an expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Zero {
    /// At this point, exactly.
    At(Point),
    /// Next to this point, between values of opposite signs.
    Near(Point),
}

/// Finds a zero of `expression`, for `free` in its box and `given` as they are; `None` if the search fails.
pub(crate) fn crossing(expression: &Expression, free: &[Free], given: &Names) -> Option<Zero> {
    let mut search = Search { expression, free, given, evaluator: Evaluator::new() };
    let mut tried = Vec::new();
    for point in points(free) {
        if let Some(zero) = search.next(point, &mut tried)? {
            return Some(zero);
        }
    }
    // All values have one sign: from where they are smallest, a descent looks for the other one.
    tried.sort_unstable_by(|a: &Tried, b| a.value.abs().total_cmp(&b.value.abs()));
    tried.truncate(DESCENTS);
    for mut best in tried {
        let mut step = 0.25;
        while step > LAST_STEP {
            match search.down(&best, step)? {
                Move::Zero(zero) => return Some(zero),
                Move::Better(next) => best = next,
                Move::None => step *= 0.5,
            }
        }
    }
    None
}

/// A point with a value whose sign is certain.
#[derive(Clone)]
struct Tried {
    point: Point,
    value: f64,
}

/// Outcome of a step of a descent.
enum Move {
    Zero(Zero),
    Better(Tried),
    None,
}

/// Certain knowledge of the sign of a value.
#[derive(Clone, Copy, PartialEq)]
enum Sign {
    /// It is not 0; a number near it has its sign.
    Of(f64),
    Zero,
    Open,
}

struct Search<'a> {
    expression: &'a Expression,
    free: &'a [Free],
    given: &'a Names,
    evaluator: Evaluator,
}

impl Search<'_> {
    fn names(&self, from: &[f64], to: &[f64]) -> Names {
        let ends = from.iter().zip(to);
        let range = ends.map(|(a, b)| Interval::from(Range::new(a.min(*b), a.max(*b))));
        let free = self.free.iter().map(|(name, ..)| name.clone());
        let mut names = self.given.clone();
        free.zip(range).for_each(|(name, range)| _ = names.insert(name, range));
        names
    }

    /// Returns the certain sign of the value at a point; `None` if the work budget is used up.
    fn sign(&mut self, at: &[f64]) -> Option<Sign> {
        let value = self.evaluator.value(self.expression, &self.names(at, at))?;
        let [low, high] = value.interval.about();
        Some(match value.interval {
            _ if value.existence != Existence::Certain => Sign::Open,
            v if v.is_positive() => Sign::Of(f64::midpoint(low, high).max(f64::MIN_POSITIVE)),
            v if v.is_negative() => Sign::Of(f64::midpoint(low, high).min(-f64::MIN_POSITIVE)),
            v if v.ends() == Interval::integer(0).ends() => Sign::Zero,
            _ => Sign::Open,
        })
    }

    /// Tries one more point, against the nearest of those with the other sign.
    fn next(&mut self, point: Point, tried: &mut Vec<Tried>) -> Option<Option<Zero>> {
        let value = match self.sign(&point)? {
            Sign::Zero => return Some(Some(Zero::At(point))),
            Sign::Open => return Some(None),
            Sign::Of(value) => value,
        };
        let others = tried.iter().filter(|other| other.value.signum() != value.signum());
        let far = |other: &&Tried| distance(self.free, &other.point, &point);
        let nearest = others.min_by(|a, b| far(a).total_cmp(&far(b)));
        let zero = match nearest.cloned() {
            Some(other) => self.between(&point, &other.point)?,
            None => None,
        };
        tried.push(Tried { point, value });
        Some(zero)
    }

    /// The first neighbour of a point, `step` of the range of a name away, at which the value is
    /// nearer to the other sign.
    fn down(&mut self, best: &Tried, step: f64) -> Option<Move> {
        for (j, (_, low, high)) in self.free.iter().enumerate() {
            for way in [-step, step] {
                let mut point = best.point.clone();
                point[j] = (point[j] + way * (high - low)).clamp(*low, *high);
                match self.sign(&point)? {
                    Sign::Zero => return Some(Move::Zero(Zero::At(point))),
                    Sign::Of(value) if value.signum() != best.value.signum() => {
                        if let Some(zero) = self.between(&best.point, &point)? {
                            return Some(Move::Zero(zero));
                        }
                    }
                    Sign::Of(value) if value.abs() < best.value.abs() => {
                        return Some(Move::Better(Tried { point, value }));
                    }
                    Sign::Of(_) | Sign::Open => {}
                }
            }
        }
        Some(Move::None)
    }

    /// A zero on the stretch between two points with values of opposite signs.
    fn between(&mut self, a: &[f64], b: &[f64]) -> Option<Option<Zero>> {
        let (mut a, mut b) = (a.to_vec(), b.to_vec());
        let Sign::Of(of_a) = self.sign(&a)? else { return Some(None) };
        for _ in 0..HALVINGS {
            let middle = midpoint(&a, &b);
            if middle == a || middle == b {
                break;
            }
            match self.sign(&middle)? {
                Sign::Zero => return Some(Some(Zero::At(middle))),
                Sign::Open => break,
                Sign::Of(value) if value.signum() == of_a.signum() => a = middle,
                Sign::Of(_) => b = middle,
            }
        }
        let proved = self.is_continuous(&a, &b, SPLITS)?;
        Some(proved.then(|| Zero::Near(midpoint(&a, &b))))
    }

    /// Returns true if the expression is proved to be continuous from one point to another; `None` if no work is left.
    fn is_continuous(&mut self, a: &[f64], b: &[f64], splits: u32) -> Option<bool> {
        let names = self.names(a, b);
        let exists = self.evaluator.value(self.expression, &names)?.existence;
        if exists == Existence::Certain && !self.jumps(&names)? {
            return Some(true);
        }
        let middle = midpoint(a, b);
        if splits == 0 || middle == a || middle == b {
            return Some(false);
        }
        let first = self.is_continuous(a, &middle, splits - 1)?;
        Some(first && self.is_continuous(&middle, b, splits - 1)?)
    }

    /// Returns true if a sign in it may change; `None` if no work is left.
    fn jumps(&mut self, names: &Names) -> Option<bool> {
        let mut signed = Vec::new();
        self.expression.each(&mut |e| match e.node() {
            Node::Call(Function::Sign, a) if !signed.contains(a) => signed.push(a.clone()),
            _ => {}
        });
        for a in &signed {
            if self.evaluator.value(a, names)?.interval.has_zero() {
                return Some(true);
            }
        }
        Some(false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::testing::mu;

    /// `t` from `low` to `high`.
    fn zero(text: &str, low: f64, high: f64) -> Option<f64> {
        let t = mu("t");
        let found = crossing(&mu(text), &[(t, low, high)], &Names::new())?;
        let (Zero::At(point) | Zero::Near(point)) = found;
        Some(point[0])
    }

    #[test]
    fn zeros_of_continuous_expressions_are_found() {
        use std::f64::consts::{FRAC_PI_2, PI};
        for (text, low, high, at) in [
            ("t - 1/3", -1.0, 1.0, 1.0 / 3.0),
            ("cos(t)", 0.0, 3.0, FRAC_PI_2),
            ("2 + 2.1*cos(t) + 0*t", 0.0, 3.1, (-2.0_f64 / 2.1).acos()),
            ("exp(t) - 1000", 0.0, 10.0, 1000_f64.ln()),
            ("abs(t) - 0.25", 0.0, 9.0, 0.25),
            ("sin(t)/(5 + t)", 1.0, 5.0, PI),
            ("max(t, -1) - 0.1", -4.0, 4.0, 0.1),
        ] {
            let found = zero(text, low, high).expect(text);
            assert!((found - at).abs() < 1e-9, "{text}: {found}");
        }
    }

    #[test]
    fn tangent_zero_is_found_only_at_an_exact_double() {
        assert_eq!(zero("t^2", -1.0, 1.0), Some(0.0));
        assert_eq!(zero("(t - 0.1)^2", -1.0, 1.0), None, "met at no double");
    }

    #[test]
    fn poles_jumps_and_gaps_are_not_zeros() {
        for (text, low, high) in [
            ("1/(t - 0.3)", -1.0, 1.0),
            ("tan(t) + 3", 1.5, 1.7),
            ("sign(t - 0.3) + 0.5", -1.0, 1.0),
            ("sign(t - 0.3)*(2 + t)", -1.0, 1.0),
            ("1/(t - 0.3)^3", -1.0, 1.0),
            ("sqrt(t) + 1", -1.0, 1.0),
            ("2 + cos(t)", -9.0, 9.0),
            ("1e-300 + t^2", -1.0, 1.0),
            ("1/abs(t - 0.3) - 1e-3", -1.0, 1.0),
        ] {
            assert_eq!(zero(text, low, high), None, "{text}");
        }
    }

    #[test]
    fn narrow_sign_change_is_found() {
        let found = zero("1 + 2*(t - 0.7)^2 - 1.0001*exp(-(t - 0.1234)^2*1e3) + 0*t", -1.0, 1.0);
        assert_eq!(found, None, "2*(0.1234 - 0.7)^2 is more than 1e-4");
        let found = zero("1 - 1.0001*exp(-(t - 0.1234)^2*1e3)", -1.0, 1.0);
        assert!((found.expect("a zero") - 0.1234).abs() < 1e-3);
    }

    #[test]
    fn crossing_is_found_in_a_box_of_many_parameters() {
        let sum = "t + a + b - 2.9";
        let e = mu(sum);
        let free: Vec<Free> = e.parameters().into_iter().map(|p| (p.into(), 0.0, 1.0)).collect();
        let free = [free, vec![(mu("t"), 0.0, 1.0)]].concat();
        let found = crossing(&e, &free, &Names::new()).expect("a corner is above");
        let (Zero::At(point) | Zero::Near(point)) = found;
        assert!((point.iter().sum::<f64>() - 2.9).abs() < 1e-9, "{point:?}");
    }
}
