//! The table against finite differences, values at a few points and its own fields.

use super::{Function, Parity, Pieces, Slope};
use crate::expression::Expression;
use crate::expression::testing::evaluate;

/// Arguments in the domain of every function.
const POINTS: [f64; 6] = [0.02, 0.11, 0.3, 0.47, 0.71, 0.95];

#[test]
fn rows_are_in_the_order_of_the_enum() {
    for (at, (name, function)) in Function::ALL.into_iter().enumerate() {
        assert_eq!((function as usize, function.name()), (at, name));
        assert_eq!(function.row().function, function);
    }
}

#[test]
fn slopes_are_those_of_the_values() {
    let mut symbolic = super::Symbolic;
    for (name, function) in Function::ALL {
        let t = Expression::from(crate::expression::Variable::SinceStart);
        let slope = function.slope(&mut symbolic, &t);
        for x in POINTS {
            let h = 1e-5;
            let value = function.row().double;
            let wanted = (value(x + h) - value(x - h)) / (2.0 * h);
            let got = evaluate(&slope, x);
            assert!((got - wanted).abs() < 1e-6 * (1.0 + wanted.abs()), "{name}' at {x}: {got}");
        }
    }
}

#[test]
fn values_have_the_parity_pieces_and_bounds_of_their_row() {
    for (name, function) in Function::ALL {
        let row = function.row();
        let value = row.double;
        for x in POINTS {
            // atanh of the platform is odd but for its last bit.
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-15 * b.abs();
            match row.parity {
                Some(Parity::Even) => assert!(near(value(-x), value(x)), "{name}"),
                Some(Parity::Odd) => assert!(near(value(-x), -value(x)), "{name}"),
                None => {}
            }
            let single = f64::from((row.single)(x as f32));
            assert!((single - value(x)).abs() < 1e-5 * value(x).abs().max(0.01), "{name}({x})");
            let [low, high] = row.bounds.map(|bound| bound.map(|b| b as f64));
            assert!(low.is_none_or(|low| low <= value(x)), "{name}({x})");
            assert!(high.is_none_or(|high| value(x) <= high), "{name}({x})");
        }
        let rises = POINTS.windows(2).all(|pair| value(pair[0]) <= value(pair[1]));
        let falls = POINTS.windows(2).all(|pair| value(pair[0]) > value(pair[1]));
        match row.pieces {
            Pieces::Wave(_) => {}
            Pieces::Falling => assert!(falls, "{name}"),
            Pieces::Rising | Pieces::Valley | Pieces::Branches => assert!(rises, "{name}"),
        }
        for [at, known] in row.known {
            assert_eq!(value(*at as f64), *known as f64, "{name}({at})");
        }
        if let Some(back) = row.inverse {
            let there_and_back = (back.row().double)(value(0.3));
            assert!((there_and_back - 0.3).abs() < 1e-15, "{name}");
        }
        if let Slope::Partner(partner, sign) = row.slope {
            let Slope::Partner(own, back) = partner.row().slope else { panic!("{name}") };
            assert_eq!((own, function.hyperbolic().is_some()), (function, sign * back > 0));
        }
    }
}
