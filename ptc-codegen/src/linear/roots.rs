//! The roots of a polynomial with exact coefficients, as numbers.
//!
//! Aberth's iteration, on points of a grid fine enough for the smallest root. Values at the points are
//! exact and corrections are doubles, so that no digits are lost where roots lie close together. The
//! root of point i is in the disc of Smith (1970) around it, of radius n |p(z_i)| / prod |z_i - z_j|
//! for a leading coefficient of 1, if that meets no other disc.

use num_traits::{FromPrimitive, ToPrimitive, Zero};

use super::Complex;
use super::exponential::power;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::{BigInt, BigRational, whole};

/// Bits of each root that the discs guarantee.
const DIGITS: f64 = 60.0;

/// Bits of the first grid beyond those by which roots differ in size.
const BITS: i64 = 128;

/// Bits of the finest grid: doubles have to hold its points.
const FINEST: i64 = 960;

/// Sweeps on a grid; ten or twenty are usual.
const SWEEPS: usize = 200;

/// All roots, each as often as its multiplicity, rightmost first, conjugates in turn: to the last digit
/// of a double in their modulus, with an imaginary part of 0 where they are real. `None` for 0, and
/// where the roots are too close together or differ too much in size.
pub fn roots(p: &Polynomial) -> Option<Vec<Complex>> {
    p.degree()?;
    let (at_zero, mut rest) = p.without(&BigRational::zero());
    let mut found = vec![Complex::default(); at_zero];
    while rest.degree() > Some(0) {
        let simple = rest.radical();
        found.extend(simple_roots(&simple)?);
        rest = rest.divided(&simple)?.0;
    }
    found.sort_by(|a, b| {
        let aside = a.im.abs().total_cmp(&b.im.abs());
        b.re.total_cmp(&a.re).then(aside).then(b.im.total_cmp(&a.im))
    });
    Some(found)
}

/// The roots of a polynomial that has no multiple ones, nor 0.
fn simple_roots(p: &Polynomial) -> Option<Vec<Complex>> {
    let coefficients = whole(p.coefficients().iter());
    let starts = starts(&coefficients);
    let sizes = || starts.iter().map(|start| start.0);
    let (least, most) = (sizes().fold(f64::MAX, f64::min), sizes().fold(f64::MIN, f64::max));
    // Largest roots of a size of 1.
    let unit = most.ceil().to_i64()?;
    let scaled: Vec<_> = (0..).zip(p.coefficients()).map(|(k, c)| c * power(unit * k)).collect();
    let coefficients = whole(scaled.iter());
    let mut bits = BITS + (most - least).ceil().to_i64()?;
    while bits <= FINEST {
        if let Some(found) = Points::new(&coefficients, bits, &starts, unit)?.found() {
            let double = |part: BigInt| (BigRational::from(part) * power(unit - bits)).to_f64();
            let number = |(re, im)| Some(Complex::new(double(re)?, double(im)?));
            return found.into_iter().map(number).collect();
        }
        bits *= 2;
    }
    None
}

/// Returns the initial values of the iteration: log2 of the modulus, and the angle. The moduli are the slopes of the
/// Newton polygon (Bini 1996), within a factor of the degree of those of the roots.
#[allow(clippy::cast_precision_loss)]
fn starts(coefficients: &[BigInt]) -> Vec<(f64, f64)> {
    let n = coefficients.len() - 1;
    let mut starts = Vec::with_capacity(n);
    while starts.len() < n {
        let from = starts.len();
        let bits = |k: usize| coefficients[k].bits() as f64;
        let slope = |to: usize| (bits(from) - bits(to)) / (to - from) as f64;
        let others = (from + 1..=n).filter(|to| !coefficients[*to].is_zero());
        let Some(to) = others.rev().min_by(|a, b| slope(*a).total_cmp(&slope(*b))) else { break };
        let turn = |k: usize| (k - from) as f64 / (to - from) as f64 + from as f64 / n as f64;
        // Off the axis, so that conjugates part.
        let angle = |k: usize| std::f64::consts::TAU * turn(k) + 0.7;
        starts.extend((from..to).map(|k| (slope(to), angle(k))));
    }
    starts
}

/// A complex number on the grid, in units of the grid.
type Point = (BigInt, BigInt);

/// Approximations of the roots of a polynomial.
struct Points<'a> {
    coefficients: &'a [BigInt],
    bits: i64,
    points: Vec<Point>,
}

impl<'a> Points<'a> {
    fn new(
        coefficients: &'a [BigInt],
        bits: i64,
        starts: &[(f64, f64)],
        unit: i64,
    ) -> Option<Self> {
        let shift = (bits - unit).to_f64()?;
        let point = |(size, angle): &(f64, f64)| {
            let size = (size + shift).exp2();
            Some((BigInt::from_f64(size * angle.cos())?, BigInt::from_f64(size * angle.sin())?))
        };
        Some(Self { coefficients, bits, points: starts.iter().map(point).collect::<Option<_>>()? })
    }

    /// The roots, where the iteration settles and the discs confirm it.
    fn found(mut self) -> Option<Vec<Point>> {
        for _ in 0..SWEEPS {
            let mut settled = true;
            for i in 0..self.points.len() {
                settled &= self.correct(i);
            }
            if settled {
                return self.confirmed();
            }
        }
        None
    }

    /// Moves point i towards a root of its own; whether it was there.
    fn correct(&mut self, i: usize) -> bool {
        let (value, slope) = self.at(&self.points[i]);
        if value.0.is_zero() && value.1.is_zero() {
            return true;
        }
        let ((value, low), (slope, high)) = (double(&value), double(&slope));
        let scale = (high - low).to_f64().map_or(f64::NAN, f64::exp2);
        let inverse = slope.over(value);
        let mut inverse = Complex::new(inverse.re * scale, inverse.im * scale);
        for j in (0..self.points.len()).filter(|j| *j != i) {
            let (apart, exponent) = double(&self.apart(i, j));
            let scale = exponent.to_f64().map_or(f64::NAN, |e| (-e).exp2());
            let push = Complex::new(scale, 0.0).over(apart);
            inverse = inverse.minus(push);
        }
        let step = Complex::new(1.0, 0.0).over(inverse);
        let whole = |part: f64| BigInt::from_f64(part.round());
        if let (Some(re), Some(im)) = (whole(step.re), whole(step.im)) {
            self.points[i].0 -= re;
            self.points[i].1 -= im;
        }
        step.norm() <= 2.0
    }

    /// p and p' at a point; their quotient is in units of the grid.
    fn at(&self, (re, im): &Point) -> (Point, Point) {
        let times = |(a, b): &Point| (a * re - b * im, a * im + b * re);
        let zero = || (BigInt::zero(), BigInt::zero());
        let (mut value, mut slope) = (zero(), zero());
        for (above, coefficient) in self.coefficients.iter().rev().enumerate() {
            slope = times(&slope);
            slope.0 += &value.0;
            slope.1 += &value.1;
            value = times(&value);
            value.0 += coefficient << (above * usize::try_from(self.bits).unwrap_or(0));
        }
        (value, slope)
    }

    fn apart(&self, i: usize, j: usize) -> Point {
        let (a, b) = (&self.points[i], &self.points[j]);
        (&a.0 - &b.0, &a.1 - &b.1)
    }

    /// The points, if the disc of each meets no other and is small beside its modulus, without parts
    /// that do not leave the disc. A real root has no imaginary part then: the conjugate of a root of
    /// a disc that meets the axis is within three radii of its centre, and no other disc is.
    fn confirmed(self) -> Option<Vec<Point>> {
        let n = self.points.len();
        let leading = size(&(self.coefficients[n].clone(), BigInt::zero()));
        let factor = n.to_f64()?.log2();
        let radius = |i: usize| {
            let others = (0..n).filter(|j| *j != i).map(|j| size(&self.apart(i, j)));
            // A bit for the rounding of the logarithms.
            size(&self.at(&self.points[i]).0) + factor + 1.0 - leading - others.sum::<f64>()
        };
        let radii: Vec<f64> = (0..n).map(radius).collect();
        let alone = |i: usize| {
            let far = |j: usize| size(&self.apart(i, j)) > radii[i].max(radii[j]) + 3.0;
            radii[i] <= size(&self.points[i]) - DIGITS && (0..n).all(|j| j == i || far(j))
        };
        if !(0..n).all(alone) {
            return None;
        }
        let visible = |part: BigInt, radius: f64| {
            let point = (part, BigInt::zero());
            if size(&point) > radius { point.0 } else { BigInt::zero() }
        };
        let number = |((re, im), radius)| (visible(re, radius), visible(im, radius));
        let all: Vec<Point> = self.points.into_iter().zip(radii).map(number).collect();
        // Conjugates of the same digits.
        let upper = all.into_iter().filter(|(_, im)| *im >= BigInt::zero());
        let pair = |(re, im): Point| match im.is_zero() {
            true => vec![(re, im)],
            false => vec![(re.clone(), -&im), (re, im)],
        };
        Some(upper.flat_map(pair).collect())
    }
}

/// The number as a double times a power of 2.
fn double((re, im): &Point) -> (Complex, i64) {
    let bits = re.bits().max(im.bits()).saturating_sub(64);
    let part = |of: &BigInt| (of >> bits).to_f64().unwrap_or(f64::NAN);
    (Complex::new(part(re), part(im)), i64::try_from(bits).unwrap_or(i64::MAX))
}

/// log2 of the modulus.
fn size(point: &Point) -> f64 {
    let (number, exponent) = double(point);
    number.norm().log2() + exponent.to_f64().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::algebra::integer;
    use crate::request::{Pole, gains};

    /// The polynomial with roots (re + im i)/1000.
    fn with(roots: &[(i64, i64)]) -> Polynomial {
        let thousandth = |of: i64| integer(of) / integer(1000);
        let pole = |(re, im): &(i64, i64)| Pole { re: thousandth(*re), im: thousandth(*im) };
        let gains = gains(&roots.iter().map(pole).collect::<Vec<_>>());
        Polynomial::characteristic(&gains.expect("conjugate pairs"))
    }

    /// Each part is within a few units of the last digit of the modulus.
    fn check(p: &Polynomial, expected: &[(f64, f64)]) {
        let found = roots(p).expect("roots");
        assert_eq!(found.len(), expected.len());
        for (found, (re, im)) in found.iter().zip(expected) {
            let off = found.minus(Complex::new(*re, *im)).norm();
            assert!(off <= 2.0 * f64::EPSILON * re.hypot(*im), "{found:?} for {re}{im:+}i");
        }
    }

    #[test]
    fn roots_reproduce_given_roots() {
        let given = [(-1000, 7000), (-1000, -7000), (-2000, 0), (-300_000, 0), (-4_000_000, 0)];
        check(&with(&given), &given.map(|(re, im)| (re as f64 / 1e3, im as f64 / 1e3)));
        check(
            &Polynomial::new([0, 0, 6, 5, 1].map(integer).to_vec()),
            &[(0.0, 0.0), (0.0, 0.0), (-2.0, 0.0), (-3.0, 0.0)],
        );
        assert_eq!(roots(&Polynomial::new(Vec::new())), None);
        assert_eq!(roots(&Polynomial::one()), Some(Vec::new()));
    }

    #[test]
    fn multiple_and_close_roots_are_found() {
        check(&with(&[(-2000, 0); 16]), &[(-2.0, 0.0); 16]);
        let pair = [(-1000, 5000), (-1000, -5000)];
        let both = [(-1.0, 5.0), (-1.0, 5.0), (-1.0, -5.0), (-1.0, -5.0)];
        check(&with(&[pair, pair].concat()), &both);
        let close: Vec<_> = (0..16).map(|i| (-16_000 - 137 * i, 0)).collect();
        let expected: Vec<_> = close.iter().map(|(re, _)| (*re as f64 / 1e3, 0.0)).collect();
        check(&with(&close), &expected);
        // Real roots 1e-40 apart, which a double does not tell from one.
        let apart = power(-133);
        let p = Polynomial::linear(&integer(-3)).times(&Polynomial::linear(&(integer(-3) - apart)));
        check(&p, &[(-3.0, 0.0), (-3.0, 0.0)]);
    }

    #[test]
    fn roots_on_the_unit_circle_and_the_axis_are_found() {
        for n in 2..=16 {
            let mut cycle = vec![integer(0); n + 1];
            (cycle[0], cycle[n]) = (integer(-1), integer(1));
            let angle = |k: usize| std::f64::consts::TAU * k as f64 / n as f64;
            let found = roots(&Polynomial::new(cycle)).expect("roots");
            for k in 0..n {
                let expected = Complex::new(angle(k).cos(), angle(k).sin());
                assert!(found.iter().any(|root| root.minus(expected).norm() < 2e-15), "{n} {k}");
            }
        }
        check(&Polynomial::new([4, 0, 1].map(integer).to_vec()), &[(0.0, 2.0), (0.0, -2.0)]);
    }

    #[test]
    fn roots_of_widely_different_size_are_found() {
        let (small, large) = (power(-300), power(300));
        let root = |of: &BigRational| Polynomial::linear(&-of.clone());
        let p = root(&small).times(&root(&integer(1))).times(&root(&large));
        check(&p, &[(-f64::exp2(-300.0), 0.0), (-1.0, 0.0), (-f64::exp2(300.0), 0.0)]);
        let far = root(&power(-2000)).times(&root(&integer(1)));
        assert_eq!(roots(&far), None);
    }

    proptest! {
        #[test]
        fn real_and_complex_roots_are_found(
            real in prop::collection::vec(-9000i64..0, 0..5),
            pairs in prop::collection::vec((-9000i64..0, 1i64..9000), 1..4),
        ) {
            let conjugates = pairs.iter().flat_map(|(re, im)| [(*re, *im), (*re, -im)]);
            let mut all: Vec<_> = real.iter().map(|re| (*re, 0)).chain(conjugates).collect();
            all.sort_by_key(|(re, im)| (-re, im.abs(), -im));
            let expected: Vec<_> =
                all.iter().map(|(re, im)| (*re as f64 / 1e3, *im as f64 / 1e3)).collect();
            check(&with(&all), &expected);
        }
    }
}
