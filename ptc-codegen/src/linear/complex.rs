//! Complex numbers in doubles.

use std::fmt;

use crate::diagnostic::digits;

/// Parts below this share of the modulus are left out of the text.
const VISIBLE: f64 = 1e-9;

/// A complex number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

impl Complex {
    /// re + im i.
    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// The modulus.
    pub fn norm(self) -> f64 {
        self.re.hypot(self.im)
    }

    /// Returns true if the text shows an imaginary part.
    pub fn is_complex(self) -> bool {
        self.im.abs() > VISIBLE * self.norm()
    }

    /// exp(self) - 1.
    pub(super) fn exp_m1(self) -> Self {
        let half = (self.im / 2.0).sin();
        let grown = self.re.exp();
        Self::new(self.re.exp_m1() - 2.0 * grown * half * half, grown * self.im.sin())
    }

    /// The difference.
    pub(super) fn minus(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }

    /// The quotient, as Smith (1962) forms it: without the square of the modulus, which may overflow.
    pub(super) fn over(self, by: Self) -> Self {
        if by.re.abs() < by.im.abs() {
            return Self::new(self.im, -self.re).over(Self::new(by.im, -by.re));
        }
        let ratio = by.im / by.re;
        let whole = by.re + by.im * ratio;
        Self::new((self.re + self.im * ratio) / whole, (self.im - self.re * ratio) / whole)
    }
}

impl fmt::Display for Complex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.is_complex() {
            return f.write_str(&digits(self.re));
        }
        let sign = if self.im < 0.0 { '-' } else { '+' };
        write!(f, "{}{sign}{}i", digits(self.re), digits(self.im.abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn complex_quotients_and_exponentials_are_accurate() {
        let (a, b) = (Complex::new(-5.0, 10.0), Complex::new(1.0, 2.0));
        assert_eq!(a.over(b), Complex::new(3.0, 4.0));
        assert_eq!(a.over(Complex::new(2.0, -1.0)), Complex::new(-4.0, 3.0));
        let far = Complex::new(1e-300, 1e-300);
        assert_eq!(far.over(far), Complex::new(1.0, 0.0));
        let turn = Complex::new(0.0, std::f64::consts::PI).exp_m1();
        assert!(turn.minus(Complex::new(-2.0, 0.0)).norm() < 1e-15);
        let small = Complex::new(1e-12, 1e-12);
        assert!(small.exp_m1().minus(small).norm() < 1e-23);
    }

    #[test]
    fn complex_numbers_print_real_and_imaginary_parts() {
        assert_eq!(Complex::new(-1.0, 7.0).to_string(), "-1+7i");
        assert_eq!(Complex::new(-1.0, -7.0).to_string(), "-1-7i");
        assert_eq!(Complex::new(-2.0, 1e-10).to_string(), "-2");
        assert_eq!(Complex::default().to_string(), "0");
    }
}
