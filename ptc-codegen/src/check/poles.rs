//! The poles that gains place, as numbers for a report.

use nalgebra::{Complex, DMatrix};
use num_traits::ToPrimitive;

use super::{exponent, to_f64};
use crate::algebra::BigRational;
use crate::diagnostic::digits;
use crate::linear::eigenvalues;

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
    use crate::request::{Pole, gains};

    #[test]
    fn there_and_back() {
        let given = [(-1, 7), (-1, -7), (-2, 0), (-300, 0), (-4000, 0)];
        let gains = gains(&given.map(|(re, im)| Pole { re: integer(re), im: integer(im) }))
            .expect("conjugate pairs");
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
