//! Ends of all kinds against exact numbers, and functions against doubles.

use std::fmt::Debug;

use astro_float_num::RoundingMode::{self, Down, Up};
use astro_float_num::{BigFloat, Consts};
use num_traits::Signed;
use proptest::prelude::*;

use super::{Enclosure, End, FixedPoint, Interval, Range};
use crate::algebra::{BigRational, integer};
use crate::expression::{Expression, Function, Node, testing};

type Ends = Option<(BigRational, BigRational)>;

type Operand = (BigRational, BigRational, BigRational);

/// The results on operands from p to q of their numbers x, against exact ones.
fn compare<E: End + Debug>(
    (k, [(p, q, x), (r, s, y)]): &(i32, [Operand; 2]),
    of: fn(&BigRational) -> Enclosure<E>,
    ends: fn(&Enclosure<E>) -> Ends,
) {
    let [a, b] = [(p, q), (r, s)].map(|(p, q)| of(p).hull(&of(q)));
    let within = |found: Enclosure<E>, value: &BigRational| {
        let Some((low, high)) = ends(&found) else { return integer(0) };
        assert!(low <= *value && *value <= high, "{value} outside {found:?}");
        high - low
    };
    let holds = |found: Enclosure<E>, value: &BigRational| {
        let width = within(found, value);
        let size = integer(1) + value.abs();
        let close = width * integer(1 << 40) < size.clone() * size;
        assert!(close || p != q || r != s, "{value} of {x} and {y}");
    };
    holds(a.plus(&b), &(x + y));
    holds(a.minus(&b), &(x - y));
    holds(a.times(&b), &(x * y));
    holds(a.square(), &(x * x));
    holds(a.neg(), &-x);
    holds(a.size(), &x.abs());
    within(a.hull(&b), x);
    holds(a.least(&b), x.min(y));
    holds(a.most(&b), x.max(y));
    within(a.both_signs(), x);
    holds(a.common(&a.hull(&b)), x);
    let zero = integer(0);
    assert!(!a.is_positive() || *x > zero);
    assert!(!a.is_negative() || *x < zero);
    assert!(a.has_zero() || *x != zero);
    assert!(!a.is_below(&b) || x < y);
    assert!(!a.is_inside(&b) || r < x && x < s);
    if *y != zero {
        holds(a.over(&b), &(x / y));
        holds(b.whole_power(*k), &y.pow(*k));
    }
    if *r < zero && zero < *s {
        assert_eq!(a.over(&b), Enclosure::WHOLE);
    }
}

/// Products of infinite ends too are those of the corners.
fn corners<E: End + Debug>() {
    let (zero, one) = (Enclosure::from(E::from(0)), Enclosure::from(E::from(1)));
    let numbers = [E::from(2), E::from(1), E::from(0), -E::from(1), -E::from(2)];
    let ends: Vec<E> = numbers.into_iter().chain([E::BELOW, E::ABOVE]).collect();
    let pairs = ends.iter().flat_map(|low| ends.iter().map(move |high| (low, high)));
    let pairs: Vec<_> = pairs.filter(|(low, high)| low <= high).collect();
    for (a, b) in &pairs {
        for (c, d) in &pairs {
            let at = |side: RoundingMode| {
                [(a, c), (a, d), (b, c), (b, d)].map(|(p, q)| Enclosure::from(p.product(q, side)))
            };
            let [low, high] = [Down, Up].map(|side| at(side).into_iter().reduce(|p, q| p.hull(&q)));
            let (low, high) = (low.expect("four").low, high.expect("four").high);
            let [x, y] = [(a, b), (c, d)]
                .map(|(p, q)| Enclosure::from((*p).clone()).hull(&(*q).clone().into()));
            let expected =
                if x == zero || y == zero { zero.clone() } else { Enclosure::new(low, high) };
            assert_eq!(x.times(&y), expected, "{x:?} {y:?}");
            if y.low < E::from(0) && y.high > E::from(0) {
                assert_eq!(x.over(&y), Enclosure::WHOLE, "{x:?} {y:?}");
            }
        }
    }
    assert_eq!(one.over(&zero), Enclosure::WHOLE);
    assert_eq!(Enclosure::from(E::BELOW).plus(&E::ABOVE.into()), Enclosure::WHOLE);
    assert!(!Enclosure::<E>::WHOLE.is_bounded() && zero.is_bounded());
}

#[test]
fn products_are_those_of_the_corners() {
    corners::<f64>();
    corners::<BigFloat>();
    corners::<FixedPoint>();
}

#[test]
fn no_number_and_next_to_nothing() {
    assert_eq!(Range::from(f64::NAN), Range::WHOLE);
    assert_eq!(Interval::from(Range::new(f64::NAN, 1.0)), Interval::WHOLE);
    assert!(Range::from(1e-320).whole_power(2).high() > 0.0);
}

fn operand() -> impl Strategy<Value = Operand> {
    let number = || (-900_i64..900, 1_i64..90).prop_map(|(p, q)| integer(p) / integer(q));
    let width = prop_oneof![Just(integer(0)), number().prop_map(|x| x.abs())];
    (number(), width, 0_i64..=8).prop_map(|(low, width, part)| {
        let within = &low + &width * integer(part) / integer(8);
        (low.clone(), low + width, within)
    })
}

proptest! {
    #[test]
    fn exact_results_are_within(case in (-4..=5, [operand(), operand()])) {
        compare(&case, |x| Range::from(&Interval::exact(x)), |found| Interval::from(*found).ends());
        compare(&case, Interval::exact, Interval::ends);
        compare(&case, |x| Enclosure::<FixedPoint>::from(x), |found| {
            let exact = |end: &FixedPoint| match (end, FixedPoint::from(1)) {
                (FixedPoint::Number(x), FixedPoint::Number(unit)) => {
                    Some(BigRational::new(x.clone(), unit))
                }
                _ => None,
            };
            Some((exact(&found.low)?, exact(&found.high)?))
        });
    }
}

fn number(value: f64) -> BigRational {
    BigRational::from_float(value).expect("a finite number")
}

fn holds(interval: &Interval, value: f64) -> bool {
    let slack = 1e-14 * value.abs() + 1e-300;
    let value = Interval::between(&number(value - slack), Some(&number(value + slack)));
    interval.minus(&value).has_zero()
}

#[test]
fn every_function_is_enclosed_closely() {
    let mut cache = Consts::new().expect("constants");
    for (name, function) in Function::ALL {
        for at in
            [-700.5, -3.0, -1.0, -0.4, -1e-30, 0.0, 1e-200, 1e-9, 0.5, 1.0, 1.5, 2.0, 40.0, 1e5]
        {
            let call = Expression::call(function, Expression::from(number(at)));
            let value = testing::evaluate(&call, 0.0);
            let got = Interval::exact(&number(at)).call(function, &mut cache);
            let jumps = function == Function::Sign && at == 0.0;
            if value.is_finite() && !jumps {
                assert!(holds(&got, value), "{name}({at}) = {value} in {got:?}");
                let close = Interval::between(
                    &number(value - 1e-12 * (1.0 + value.abs())),
                    Some(&number(value + 1e-12 * (1.0 + value.abs()))),
                );
                assert!(got.is_inside(&close), "{name}({at}) = {value} in {got:?}");
            }
        }
    }
}

#[test]
fn wide_arguments_are_enclosed() {
    let mut cache = Consts::new().expect("constants");
    for (name, function) in Function::ALL {
        for (low, width) in [(-4.0, 9.0), (0.1, 0.7), (-0.9, 1.8), (3.0, 0.5), (1.0, 700.0)] {
            let wide = Interval::between(&number(low), Some(&number(low + width)));
            let got = wide.call(function, &mut cache);
            for step in 0..=40 {
                let at = number(low + width * f64::from(step) / 40.0);
                let value = testing::evaluate(&Node::Call(function, at.into()).into(), 0.0);
                assert!(!value.is_finite() || holds(&got, value), "{name} from {low}: {value}");
            }
        }
    }
}

#[test]
fn ends_may_be_infinite_and_huge() {
    let mut cache = Consts::new().expect("constants");
    let unbounded = Interval::between(&integer(5), None);
    assert!(unbounded.neg().call(Function::Exp, &mut cache).is_not_negative());
    assert!(unbounded.call(Function::Exp, &mut cache).is_positive());
    for (_, function) in Function::ALL {
        for x in [Interval::WHOLE, unbounded.clone(), unbounded.neg()] {
            let once = x.call(function, &mut cache);
            let _ = once.call(Function::Exp, &mut cache).call(function, &mut cache);
        }
    }
    let huge = Interval::exact(&num_traits::pow(integer(10), 3000));
    assert!(huge.is_positive() && huge.over(&huge).is_not_negative());
    assert!(Interval::exact(&num_traits::pow(integer(10), 300).recip()).is_positive());
    let third = Interval::exact(&(integer(1) / integer(3)));
    assert!(third.times(&Interval::integer(3)).plus(&Interval::integer(-1)).has_zero());
    assert!(unbounded.power(&third, &mut cache).is_positive());
    assert!(Interval::integer(-2).whole_power(-3).is_negative());
}
