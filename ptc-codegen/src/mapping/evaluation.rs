//! In which quantities the rows of the law are evaluated.

use super::rings::{plain, term};
use crate::algebra::{Kind, Monomial, Poly, Symbol, integer};

/// The greatest order at which the shortest rows are taken. From n = 5 on polynomials of tanh in T, and from n = 7
/// on those of algebraic in h^2, have terms that cancel at the start: `ptc-bench accuracy` with 12 here leaves 7e-14 there at n = 12.
pub(super) const SHORT: usize = 4;

/// Evaluation of an atom: its replacement in the rows of the law.
#[derive(Clone, Debug)]
pub enum Evaluated {
    /// The atom is this.
    As(Symbol, Poly),
    /// Its square is this; a single power of it is left.
    Square(Symbol, Poly),
}

/// In which quantities rows are evaluated.
#[derive(Clone, Debug, Default)]
pub struct Evaluation {
    /// The single term `base` for which B_{i,j}/base^j holds no time but in the evaluated atoms, and
    /// the tick quantity equal to 1/base; `None` if time does not decide it.
    pub base: Option<(Poly, Symbol)>,
    /// Atoms that are evaluated in another quantity, one after the other.
    pub evaluated: Vec<Evaluated>,
}

impl Evaluated {
    /// The polynomial with it.
    pub fn apply(&self, poly: &Poly) -> Poly {
        let (atom, quantity) = match self {
            Self::As(atom, quantity) => {
                return poly.substitute(|s| (s == *atom).then(|| quantity.clone()));
            }
            Self::Square(atom, quantity) => (*atom, quantity),
        };
        let parts = poly.collect(atom).into_iter().map(|(exponent, coefficient)| {
            let squares = quantity.pow(exponent.div_euclid(2).unsigned_abs());
            let left = Monomial::power(atom, exponent.rem_euclid(2));
            coefficient.times(&squares).shifted(&left)
        });
        parts.fold(Poly::zero(), |sum, part| sum.plus(&part))
    }
}

impl Evaluation {
    /// Over `base`, whose inverse is a tick quantity.
    pub(super) fn over(base: Poly, inverse: Kind) -> Self {
        Self { base: Some((base, plain(inverse))), evaluated: Vec::new() }
    }

    /// tanh over T L. As E L = 1 - L, D (T L) = 2 a T L (1 - 2 L) and D L = 2 a L (1 - L): over a power of T L
    /// every B_{i,j} is a polynomial in L = 1 - T/(2 tau).
    pub(super) fn of_tanh() -> Self {
        let share = term(-1, &[(Kind::TimeToGo, 1), (Kind::Tau, -1)]).scaled(&integer(2).recip());
        let decay = term(1, &[(Kind::Logistic, -1)]).plus(&term(-1, &[]));
        let base = term(1, &[(Kind::TimeToGo, 1), (Kind::Logistic, 1)]);
        Self {
            evaluated: vec![
                Evaluated::As(plain(Kind::Decay), decay),
                Evaluated::As(plain(Kind::Logistic), Poly::one().plus(&share)),
            ],
            ..Self::over(base, Kind::InverseProduct)
        }
    }

    /// algebraic over h^3. With s = y h, D (h^m p(s)) = a h^(m+1) (h^2 p'(s) - m s p(s)), of the other parity in s:
    /// over a power of h^3 every B_{i,j} is a polynomial in h^2 = 1 - s^2, times y h^2 where i - j is odd.
    pub(super) fn of_algebraic() -> Self {
        let (y, h) = (plain(Kind::StretchedAngle), plain(Kind::Cosine));
        let square = term(1, &[(Kind::Cosine, -2)]).plus(&term(-1, &[]));
        let single = term(1, &[(Kind::AngleOverSquare, 1), (Kind::Cosine, -2)]);
        Self {
            evaluated: vec![
                Evaluated::Square(y, square),
                Evaluated::As(y, single),
                Evaluated::Square(h, term(1, &[(Kind::CosineSquare, 1)])),
            ],
            ..Self::over(term(1, &[(Kind::Cosine, 3)]), Kind::InverseCube)
        }
    }
}
