//! Gains from the poles of the closed loop in stretched time, and back.

use std::fmt;

use nalgebra::{Complex, DMatrix};
use num_traits::{ToPrimitive, Zero};

use super::eigenvalues::eigenvalues;
use super::polynomial::Polynomial;
use super::{digits, exponent, to_f64};
use crate::algebra::{BigInt, BigRational};

/// A pole re + im i of the closed loop in stretched time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pole {
    /// Real part.
    pub re: BigRational,
    /// Imaginary part.
    pub im: BigRational,
}

impl Pole {
    /// A real pole.
    pub fn real(re: BigRational) -> Self {
        Self { re, im: BigRational::zero() }
    }

    /// re - im i.
    #[must_use]
    pub fn conjugate(&self) -> Self {
        Self { re: self.re.clone(), im: -&self.im }
    }
}

impl fmt::Display for Pole {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |value: &BigRational| value.to_f64().unwrap_or(f64::NAN);
        match (self.re.is_zero(), self.im.is_zero()) {
            (_, true) => write!(f, "{}", part(&self.re)),
            (true, false) => write!(f, "{}i", part(&self.im)),
            (false, false) => write!(f, "{}{:+}i", part(&self.re), part(&self.im)),
        }
    }
}

/// A complex pole that stands more often than its conjugate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PoleError {
    /// The pole without a partner, boxed as most calls succeed.
    pub pole: Box<Pole>,
}

impl fmt::Display for PoleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (pole, partner) = (&self.pole, self.pole.conjugate());
        write!(f, "the pole {pole} has no partner {partner}, and real gains need both")
    }
}

impl std::error::Error for PoleError {}

/// The gains k_1..k_n with s^n + k_n s^(n-1) + ... + k_1 = prod (s - pole), exactly.
///
/// # Errors
/// The first complex pole whose conjugate is not given as often as it is.
pub fn gains(poles: &[Pole]) -> Result<Vec<BigRational>, PoleError> {
    let count = |pole: &Pole| poles.iter().filter(|other| *other == pole).count();
    let mut product = Polynomial::one();
    for pole in poles {
        if count(pole) > count(&pole.conjugate()) {
            return Err(PoleError { pole: Box::new(pole.clone()) });
        }
        let factor = if pole.im.is_zero() {
            Polynomial::linear(&pole.re)
        } else if pole.im > BigRational::zero() {
            let square = &pole.re * &pole.re + &pole.im * &pole.im;
            let twice = &pole.re * BigInt::from(-2);
            Polynomial::new(vec![square, twice, BigInt::from(1).into()])
        } else {
            continue;
        };
        product = product.times(&factor);
    }
    let mut coefficients = product.coefficients().to_vec();
    coefficients.pop();
    Ok(coefficients)
}

/// The poles that `gains` k_1..k_n place, rightmost first: numbers for a report, from which nothing
/// is decided. Empty where a gain overflows a double.
pub fn numeric(gains: &[BigRational]) -> Vec<Complex<f64>> {
    let n = gains.len();
    let gains: Vec<f64> = gains.iter().map(|k| k.to_f64().unwrap_or(f64::INFINITY)).collect();
    // With poles in units of their size every coefficient is at most 1.
    let size = gains.iter().zip((1..=n).rev()).map(|(k, order)| k.abs().powf(1.0 / to_f64(order)));
    let size = size.fold(0.0, f64::max);
    if size == 0.0 {
        return vec![Complex::new(0.0, 0.0); n];
    }
    let companion = DMatrix::from_fn(n, n, |i, j| {
        if i + 1 == n {
            -gains[j] / size.powi(exponent(n - j))
        } else if j == i + 1 {
            1.0
        } else {
            0.0
        }
    });
    let mut poles = eigenvalues(companion).unwrap_or_default();
    for pole in &mut poles {
        *pole *= size;
    }
    poles.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    poles
}

/// A pole of a report.
pub(super) fn text(pole: Complex<f64>) -> String {
    if pole.im.abs() <= 1e-9 * pole.norm() {
        return digits(pole.re);
    }
    let sign = if pole.im < 0.0 { '-' } else { '+' };
    format!("{}{sign}{}i", digits(pole.re), digits(pole.im.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::integer;

    fn pole(re: i64, im: i64) -> Pole {
        Pole { re: integer(re), im: integer(im) }
    }

    #[test]
    fn gains_of_real_and_complex_poles() {
        let k = gains(&[pole(-4, 0), pole(-5, 0), pole(-6, 0)]).expect("conjugate pairs");
        assert_eq!(k, [120, 74, 15].map(integer));
        let k = gains(&[pole(-1, 2), pole(-3, 0), pole(-1, -2)]).expect("conjugate pairs");
        assert_eq!(k, [15, 11, 5].map(integer));
        let k = gains(&[pole(-1, 2), pole(-1, 2), pole(-1, -2), pole(-1, -2)])
            .expect("conjugate pairs");
        assert_eq!(k, [25, 20, 14, 4].map(integer));
    }

    #[test]
    fn a_pole_without_its_conjugate_is_named() {
        for poles in [vec![pole(-1, 2)], vec![pole(-1, 2), pole(-1, 2), pole(-1, -2)]] {
            let wrong = gains(&poles).expect_err("one stands alone");
            assert_eq!(
                wrong.to_string(),
                "the pole -1+2i has no partner -1-2i, and real gains need both"
            );
        }
        let half = Pole { re: BigRational::new((-1).into(), 2.into()), im: integer(-3) };
        assert_eq!(half.to_string(), "-0.5-3i");
        assert_eq!(pole(0, 1).to_string(), "1i");
    }

    #[test]
    fn there_and_back() {
        let given = [(-1, 7), (-1, -7), (-2, 0), (-300, 0), (-4000, 0)];
        let gains = gains(&given.map(|(re, im)| pole(re, im))).expect("conjugate pairs");
        for (found, (re, im)) in numeric(&gains).iter().zip(given) {
            let off = found - Complex::new(re as f64, im as f64);
            // The rounding of the companion's entries is relative to the largest pole.
            assert!(off.norm() < 4000.0 * 1e-13, "{found} for {re}{im:+}i");
        }
        assert_eq!(numeric(&[0, 0].map(integer)), [Complex::new(0.0, 0.0); 2]);
        assert_eq!(text(numeric(&gains)[0]), "-1+7i");
        assert_eq!(text(numeric(&gains)[2]), "-2");
    }

    #[test]
    fn eight_poles_on_a_circle() {
        let mut gains = vec![integer(0); 8];
        gains[0] = integer(256);
        assert!(numeric(&gains).iter().all(|pole| (pole.norm() - 2.0).abs() < 1e-12));
    }
}
