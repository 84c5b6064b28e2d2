//! The closed forms at numeric points: against the reference vectors, and in the identities that
//! tie a mapping to its inverse.

use crate::support;

use nalgebra::{DMatrix, DVector};
use ptc_codegen::algebra::{Kind, Poly, Symbol};
use ptc_codegen::expansion::{self, letter};
use ptc_codegen::family::Family;
use ptc_codegen::mapping::Mapping;
use ptc_codegen::parameter::Precision;
use ptc_codegen::program::number::round;
use support::tolerance::IDENTITY;
use support::vectors::{Vector, read};

/// The value of a symbol at the time of a vector.
fn symbol(vector: &Vector, to_go: f64, symbol: Symbol) -> f64 {
    let Vector { a, m, tau, .. } = *vector;
    let w = to_go / tau;
    let v = w * (2.0 - w);
    let s = (vector.t - vector.t0) / tau;
    let angle = std::f64::consts::PI * to_go / (2.0 * tau);
    let index = usize::from(symbol.index);
    match symbol.kind {
        Kind::Pi => std::f64::consts::PI,
        Kind::Tau => tau,
        Kind::A => a,
        Kind::M => m,
        Kind::Rate => vector.rates[index - 1],
        Kind::TimeToGo => to_go,
        Kind::PowerRatio => w.powf(m),
        Kind::Decay => w / (2.0 - w),
        Kind::Logistic => (2.0 - w) / 2.0,
        // s keeps its digits at the start, w at the deadline.
        Kind::StretchedAngle if vector.family == Family::Tan && s < 0.5 => {
            (std::f64::consts::FRAC_PI_2 * s).tan()
        }
        Kind::StretchedAngle if vector.family == Family::Tan => 1.0 / angle.tan(),
        Kind::StretchedAngle => s / v.sqrt(),
        Kind::Lorentz => angle.sin().powi(2),
        Kind::Cosine => v.sqrt(),
        Kind::Mode => (-vector.rates[index - 1] * stretched(vector, w)).exp(),
        kind => panic!("{kind:?} is no atom"),
    }
}

/// The root t of mean_i e^(-a_i t) = w, by halving.
fn stretched(vector: &Vector, w: f64) -> f64 {
    let rates = DVector::from_column_slice(&vector.rates);
    let (mut low, mut high) = (0.0, -w.ln() / rates.min());
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if rates.map(|a| (-a * middle).exp()).mean() > w { low = middle } else { high = middle }
    }
    low
}

/// A matrix and, entry by entry, the sum of the absolute values of the terms: what the entry's
/// rounding is measured by.
type Scaled = (DMatrix<f64>, DMatrix<f64>);

fn evaluate(poly: &Poly, value: &dyn Fn(Symbol) -> f64) -> f64 {
    poly.terms()
        .map(|(monomial, coefficient)| {
            let factors = monomial.factors().iter().map(|(s, e)| value(*s).powi(*e));
            factors.product::<f64>() * round(coefficient, Precision::F64)
        })
        .sum()
}

/// The sum of the absolute values of the terms.
fn magnitude(poly: &Poly, value: &dyn Fn(Symbol) -> f64) -> f64 {
    poly.terms()
        .map(|(monomial, coefficient)| {
            let factors = monomial.factors().iter().map(|(s, e)| value(*s).abs().powi(*e));
            factors.product::<f64>() * round(coefficient, Precision::F64).abs()
        })
        .sum()
}

/// BB_n[kappa] at a vector, over b_n[kappa].
fn bell(vector: &Vector) -> Scaled {
    let mapping = Mapping::of(vector.family, vector.rates.len());
    let to_go = vector.time_to_go();
    let value = |s| symbol(vector, to_go, s);
    let mut rows = expansion::matrix(&mapping, vector.n);
    rows.push(expansion::b(&mapping, vector.n));
    let matrix = |entry: fn(&Poly, &dyn Fn(Symbol) -> f64) -> f64| {
        DMatrix::from_fn(vector.n + 1, vector.n, |i, j| entry(&rows[i][j], &value))
    };
    (matrix(evaluate), matrix(magnitude))
}

/// BB_n[mu] at a vector, over b_n[mu]: from the derivatives r_k of mu by the letter's sum.
fn inverse_bell(vector: &Vector) -> Scaled {
    let mapping = Mapping::of(vector.family, vector.rates.len());
    let to_go = vector.time_to_go();
    let r = expansion::r(&mapping, vector.n + 1);
    let table = letter::table(vector.n);
    let matrix = |entry: fn(&Poly, &dyn Fn(Symbol) -> f64) -> f64| {
        let r: Vec<_> = r.iter().map(|r| entry(r, &|s| symbol(vector, to_go, s))).collect();
        // A single term, so that it is its own magnitude in a denominator.
        let derivative = |s: Symbol| r[usize::from(s.index) - 1];
        DMatrix::from_fn(vector.n + 1, vector.n, |i, j| {
            table[i].get(j).map_or(0.0, |poly| entry(poly, &derivative))
        })
    };
    (matrix(evaluate), matrix(magnitude))
}

/// Residue of an exact 0 in a reference of 120 digits.
const ZERO: f64 = 1e-100;

fn assert_near(found: f64, wanted: f64, scale: f64, what: &str, vector: &Vector) {
    let error = (found - wanted).abs() / scale.max(ZERO);
    assert!(error <= IDENTITY, "{what} is wrong by {error:.1e}: {found:e}, {wanted:e}\n{vector:?}");
}

#[test]
fn closed_forms_give_the_vectors() {
    for vector in read("vectors.jsonl") {
        let (bell, magnitude) = bell(&vector);
        let x = DVector::from_column_slice(&vector.x);
        let (xi, scale) = (&bell * &x, &magnitude * x.abs());
        for i in 0..vector.n {
            assert_near(xi[i], vector.xi[i], scale[i], "xi", &vector);
            let last = (vector.n, i);
            assert_near(bell[last], vector.b[i], magnitude[last], "b", &vector);
        }
    }
}

/// BB_n[mu] BB_n[kappa] = I and mu'^n b_n[mu]^T xi = -b_n[kappa]^T x at matching times.
#[test]
fn the_expansions_of_a_mapping_and_its_inverse_undo_each_other() {
    for vector in read("vectors.jsonl") {
        let n = vector.n;
        let ((kappa, kappa_scale), (mu, mu_scale)) = (bell(&vector), inverse_bell(&vector));
        let product = mu.rows(0, n) * kappa.rows(0, n);
        let scale = mu_scale.rows(0, n) * kappa_scale.rows(0, n);
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let unit = f64::from(u8::from(i == j));
            assert_near(product[(i, j)], unit, scale[(i, j)], "BB BB", &vector);
        }
        let x = DVector::from_column_slice(&vector.x);
        let mu_prime = mu_prime_at(&vector).powi(i32::try_from(n).expect("a small order"));
        let of_mu = mu_prime * (mu.row(n) * (kappa.rows(0, n) * &x))[0];
        let of_kappa = (kappa.row(n) * &x)[0];
        let scale = (kappa_scale.row(n) * x.abs())[0]
            + mu_prime * (mu_scale.row(n) * (kappa_scale.rows(0, n) * x.abs()))[0];
        assert_near(of_mu, -of_kappa, scale, "b", &vector);
    }
}

/// r_1 = mu' at the time of a vector.
fn mu_prime_at(vector: &Vector) -> f64 {
    let mapping = Mapping::of(vector.family, vector.rates.len());
    let to_go = vector.time_to_go();
    evaluate(&mapping.r1, &|s| symbol(vector, to_go, s))
}
