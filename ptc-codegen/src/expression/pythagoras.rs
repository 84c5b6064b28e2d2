//! cos^2 + sin^2 = 1 and cosh^2 - sinh^2 = 1, wherever both squares are terms of one sum.
//!
//! The sum of the squares would be formed from rounded ones, and its series from terms that cancel.

use super::field::{Field, Kernel};
use super::function::{Parity, Slope};
use super::ratio::Ratio;
use super::{Expression, Function, Node};
use crate::algebra::{BigRational, Monomial, Poly, Symbol};

impl Field {
    /// The fraction with squares that add up to 1 replaced by it in the numerator.
    pub(super) fn with_unit_squares(&self, mut ratio: Ratio) -> Option<Ratio> {
        let mut changed = false;
        for (first, second, same_sign) in self.pairs(&ratio.num) {
            // Each turn leaves one term less.
            while let Some((monomial, c)) = unit_square(&ratio.num, first, second, same_sign) {
                let square = |symbol| monomial.times(&Monomial::power(symbol, 2));
                let other = if same_sign { -c.clone() } else { c.clone() };
                ratio.num.add_term(-c.clone(), square(first));
                ratio.num.add_term(other, square(second));
                ratio.num.add_term(c, monomial);
                changed = true;
            }
        }
        if changed { ratio.cancelled() } else { Some(ratio) }
    }

    /// The symbols of cos(u) and sin(u), or cosh(u) and sinh(u), that occur in a polynomial, and
    /// whether their squares are added.
    fn pairs(&self, poly: &Poly) -> Vec<(Symbol, Symbol, bool)> {
        let calls: Vec<_> = poly
            .symbols()
            .into_iter()
            .filter_map(|symbol| match self.kernel(symbol) {
                Some(Kernel::Atom(atom)) => match atom.node() {
                    Node::Call(function, u) => Some((symbol, *function, u)),
                    _ => None,
                },
                _ => None,
            })
            .collect();
        let partner = |wanted: Function, of: &Expression| {
            calls.iter().find(|(_, f, u)| *f == wanted && *u == of).map(|(symbol, ..)| *symbol)
        };
        // With f' = s g and g' = f, f^2 - s g^2 is constant: f(0)^2, which is 1 for the even one.
        let pair = |(symbol, function, u): &(Symbol, Function, &Expression)| {
            let row = function.row();
            match (row.slope, row.parity) {
                (Slope::Partner(other, sign), Some(Parity::Even)) => {
                    Some((*symbol, partner(other, u)?, sign < 0))
                }
                _ => None,
            }
        };
        calls.iter().filter_map(pair).collect()
    }
}

/// m and c where `poly` has the terms c m first^2 and c m second^2, or -c m second^2.
fn unit_square(
    poly: &Poly,
    first: Symbol,
    second: Symbol,
    same_sign: bool,
) -> Option<(Monomial, BigRational)> {
    poly.terms().find_map(|(own, c)| {
        let monomial = own.times(&Monomial::power(first, -2));
        let other = monomial.times(&Monomial::power(second, 2));
        let wanted = if same_sign { c.clone() } else { -c.clone() };
        poly.terms().any(|(m, c)| *m == other && *c == wanted).then(|| (monomial, c.clone()))
    })
}

#[cfg(test)]
mod tests {
    use crate::expression::normal::normal;
    use crate::expression::testing::mu;

    #[test]
    fn squares_add_up_to_1() {
        for (text, form) in [
            ("sin(a*t)^2 + cos(a*t)^2", "1"),
            ("3*t*cos(t)^2 + 3*t*sin(t)^2 + t", "4*t"),
            ("1/(tau + tau*cos(t)^2/sin(t)^2)", "sin(t)^2/tau"),
            ("cosh(t)^4 - cosh(t)^2*sinh(t)^2", "cosh(t)^2"),
            ("sin(t)^2 - cos(t)^2", "sin(t)^2 - cos(t)^2"),
            ("sin(t)^2 + cos(2*t)^2", "sin(t)^2 + cos(2*t)^2"),
            ("cosh(t)^2 + sinh(t)^2", "cosh(t)^2 + sinh(t)^2"),
        ] {
            assert_eq!(normal(&mu(text)).to_string(), form, "{text}");
        }
    }
}
