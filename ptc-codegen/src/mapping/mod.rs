//! Class K/M time mappings as differential rings.
//!
//! A mapping is given by a few *atoms* that the stretched-time derivative D = (1/kappa') d/dDt
//! maps to polynomials in themselves, and by r_1 = 1/kappa' = mu'. Every r_k, B_{i,j} and b_n
//! then is a polynomial in the atoms, by D alone.

mod atoms;
mod custom;
mod derivatives;
mod evaluation;
mod rings;
pub(crate) mod time;

pub use atoms::Atoms;
pub use custom::{Custom, Form, Kappa};
pub use evaluation::{Evaluated, Evaluation};
pub use time::TimeMapping;

use crate::algebra::{Kind, Monomial, Poly, Symbol, integer};

/// Evaluation of a negative power of an atom: `atom^-power = by`, which is also `expansion` where that is a polynomial
/// in another atom.
#[derive(Clone, Debug)]
pub struct Reciprocal {
    /// The atom.
    pub atom: Symbol,
    /// The power of it that has a name.
    pub power: i32,
    /// `atom^-power` in a quantity that is computed.
    pub by: Poly,
    /// `atom^-power` as a polynomial in the other atoms.
    pub expansion: Option<Poly>,
}

/// A mapping, closed under the stretched-time derivative.
#[derive(Clone, Debug)]
pub struct Mapping {
    /// r_1 = mu' = 1/kappa'.
    pub r1: Poly,
    /// D atom, for each atom.
    pub derivations: Vec<(Symbol, Poly)>,
    /// Names for negative powers of atoms.
    pub reciprocals: Vec<Reciprocal>,
    /// The rate of stretched time, a single term: B_{i,j} is rate^i times something free of it.
    pub rate: Poly,
    /// Evaluation of rows of any order.
    pub evaluation: Evaluation,
    /// Evaluation of those of low orders, where that takes fewer operations.
    pub short: Option<Evaluation>,
}

impl Mapping {
    /// Returns the evaluation of the rows of order `n`.
    pub fn evaluation(&self, n: usize) -> &Evaluation {
        self.short.as_ref().filter(|_| n <= evaluation::SHORT).unwrap_or(&self.evaluation)
    }

    /// D applied to a polynomial in the atoms, in canonical form.
    pub fn derive(&self, poly: &Poly) -> Poly {
        let find = |s| self.derivations.iter().find(|(atom, _)| *atom == s).map(|(_, d)| d.clone());
        self.canonical(&poly.derive(find))
    }

    /// The one form of a polynomial in the atoms: the relation `atom^-power = expansion` is used
    /// to bring all terms to the highest power of that atom, so equal elements look the same.
    pub fn canonical(&self, poly: &Poly) -> Poly {
        let mut result = poly.clone();
        for reciprocal in &self.reciprocals {
            let highest = result.terms().map(|(m, _)| m.exponent(reciprocal.atom)).max();
            if let (Some(_), Some(top)) = (&reciprocal.expansion, highest) {
                let lift = Monomial::power(reciprocal.atom, top);
                result = expand(&result.shifted(&lift.pow(-1)), reciprocal).shifted(&lift);
            }
        }
        result
    }

    /// A mapping of which nothing is known but r_1, ..., r_order: its B_{i,j} are the Bell
    /// polynomials in free r_k, for D r_k = r_{k+1}.
    pub fn free(order: usize) -> Self {
        let r = |k| Symbol::indexed(Kind::R, k);
        Self {
            r1: Poly::symbol(r(1)),
            derivations: (1..=order).map(|k| (r(k), Poly::symbol(r(k + 1)))).collect(),
            reciprocals: Vec::new(),
            rate: Poly::one(),
            evaluation: Evaluation::default(),
            short: None,
        }
    }

    /// An abstract mapping s = kappa whose derivatives s', s'', ..., s^(order) stay symbols.
    pub fn symbolic(order: usize) -> Self {
        let s = |k| Poly::symbol(Symbol::indexed(Kind::Derivative, k));
        let r1 = Poly::term(integer(1), Monomial::power(Symbol::indexed(Kind::Derivative, 1), -1));
        let derivations = (1..=order)
            .map(|k| (Symbol::indexed(Kind::Derivative, k), s(k + 1).times(&r1)))
            .collect();
        Self {
            r1,
            derivations,
            reciprocals: Vec::new(),
            rate: Poly::one(),
            evaluation: Evaluation::default(),
            short: None,
        }
    }
}

/// Replaces `atom^(-power * e)` by `expansion^e` in every term.
pub(crate) fn expand(poly: &Poly, reciprocal: &Reciprocal) -> Poly {
    let Some(expansion) = &reciprocal.expansion else { return poly.clone() };
    let mut result = Poly::zero();
    for (exponent, coefficient) in poly.collect(reciprocal.atom) {
        let times = (-exponent).div_euclid(reciprocal.power);
        let rest = exponent + times * reciprocal.power;
        let Ok(times) = u32::try_from(times) else {
            result = result.plus(&coefficient.shifted(&Monomial::power(reciprocal.atom, exponent)));
            continue;
        };
        let left = Monomial::power(reciprocal.atom, rest);
        result = result.plus(&coefficient.times(&expansion.pow(times)).shifted(&left));
    }
    result
}
