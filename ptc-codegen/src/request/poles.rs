//! Gains from the poles of the closed loop in stretched time.

use std::fmt;

use num_traits::{ToPrimitive, Zero};

use crate::algebra::polynomial::Polynomial;
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

/// A complex pole that occurs more often than its conjugate.
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
}
