//! The rows of the law in samples: those that Theorem 1 gives for the mapping `exp`.
//!
//! The solutions of the loop are T^(p), with p = -lambda/a for each pole lambda and falling powers in
//! place of powers. The indicial polynomials are the same as in continuous time, so are the rows.

use std::ops::{Div, Mul};

use crate::algebra::{BigInt, BigRational, Kind, Monomial, Poly, integer};
use crate::code::Expr;
use crate::family::Family;
use crate::internal::fault;
use crate::law::{Form, Law};
use crate::linear::binomial;
use crate::mapping::Mapping;
use crate::request::{LeastEnergy, gains};

/// row_1..row_m of the gains k_1..k_m and the rate a.
pub(super) fn rows(gains: &[Expr], a: &Expr) -> Vec<Expr> {
    let m = gains.len();
    // K_i = k_i/a^(m+1-i).
    let mut scaled = vec![Expr::integer(1); m];
    let mut power = Expr::integer(1);
    for i in (0..m).rev() {
        power = power.mul(a.clone());
        scaled[i] = gains[i].clone().div(power.clone());
    }
    let Form::Rows { rows, .. } = Law::new(m, &Mapping::of(Family::Exp, 0), None).form else {
        fault("the law of `exp` has no rows")
    };
    let row = |row: &Poly| {
        let term = |(monomial, number): (&Monomial, &BigRational)| match monomial.factors() {
            [] => Expr::Number(number.clone()),
            [(gain, 1)] if gain.kind == Kind::ScaledGain => {
                let gain = scaled[usize::from(gain.index) - 1].clone();
                Expr::Number(number.clone()).mul(gain)
            }
            _ => fault("a row of `exp` is not linear in the gains"),
        };
        Expr::sum(row.terms().map(term))
    };
    rows.iter().map(row).collect()
}

/// The rows of gains and a rate that are numbers.
pub(crate) fn rows_of_numbers(gains: &[BigRational], a: &BigRational) -> Vec<BigRational> {
    let gains: Vec<_> = gains.iter().cloned().map(Expr::Number).collect();
    let rows = rows(&gains, &Expr::Number(a.clone()));
    rows.iter().filter_map(Expr::number).cloned().collect()
}

/// The rows of a law of least energy in a loop of order `m`.
pub(super) fn rows_of_least_energy(law: LeastEnergy, m: usize) -> Vec<BigRational> {
    let one = integer(1);
    let gains = gains(&law.poles(m, &one));
    rows_of_numbers(&gains.unwrap_or_else(|_| fault("real poles have gains")), &one)
}

/// Deadbeat, E^m y = 0, in place of row_j/((M-j+1)...(M-m+1)).
pub(super) fn deadbeat(m: usize) -> Vec<BigRational> {
    (0..m).map(|j| -binomial(m, j)).collect()
}

/// Samples to go at which deadbeat takes over from the law of order `m`, by the greatest real part
/// of the exponents p: below, T^(p) changes its sign. Two rounds of deadbeat at least, since one
/// leaves the roundings of what it found.
pub(super) fn deadbeat_from(m: usize, greatest: &BigRational) -> BigInt {
    let order = BigInt::from(m);
    (greatest.ceil().to_integer() + &order - BigInt::from(1)).max(order * 2)
}
