//! exp(A t) of a small matrix, with twice the digits of a double on the way: the relative error of
//! a short time doubles with each squaring.

use super::super::to_f64;

/// A square matrix, by its rows.
pub(super) type Square = Vec<Vec<f64>>;

/// Terms of the series: the rest is below 1e-33 for a norm of 2^-4.
const TERMS: usize = 17;

/// log2 of the norm for which the series is summed.
const SHORT: f64 = -4.0;

/// Halvings of the time, after which any is short.
const HALVINGS: usize = 2100;

/// exp(A t): by its series for a short time, squared from there on, so that powers of t stay finite
/// for any t.
pub(super) fn exponential(matrix: &Square, time: f64) -> Square {
    let norm = matrix.iter().map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max);
    let (mut stretch, mut halvings) = (time, 0);
    while stretch.abs() * norm > SHORT.exp2() && halvings < HALVINGS {
        stretch *= 0.5;
        halvings += 1;
    }
    let short = mapped(matrix, |_, _, x| Long::from(*x).times(Long::from(stretch)));
    let one = |i: usize, j: usize| Long::from(if i == j { 1.0 } else { 0.0 });
    let mut result = mapped(matrix, |i, j, _| one(i, j));
    for k in (1..=TERMS).rev() {
        let term = times(&short, &result);
        result = mapped(&term, |i, j, term| one(i, j).plus(term.over(to_f64(k))));
    }
    for _ in 0..halvings {
        result = times(&result, &result);
    }
    mapped(&result, |_, _, x| x.high)
}

/// The matrix with `entry(i, j, x)` in place of each entry x.
fn mapped<A, B>(of: &[Vec<A>], entry: impl Fn(usize, usize, &A) -> B) -> Vec<Vec<B>> {
    let row =
        |(i, row): (usize, &Vec<A>)| row.iter().enumerate().map(|(j, x)| entry(i, j, x)).collect();
    of.iter().enumerate().map(row).collect()
}

fn times(a: &[Vec<Long>], b: &[Vec<Long>]) -> Vec<Vec<Long>> {
    mapped(a, |i, j, _| {
        let products = a[i].iter().zip(b).map(|(x, row)| x.times(row[j]));
        products.fold(Long::from(0.0), Long::plus)
    })
}

/// The unevaluated sum of two doubles, the lower one within the rounding of the higher one.
#[derive(Clone, Copy)]
struct Long {
    high: f64,
    low: f64,
}

impl From<f64> for Long {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Long {
    /// high + low, high being the larger one.
    fn of(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }

    /// The sum, as Knuth forms it.
    fn plus(self, other: Self) -> Self {
        let sum = self.high + other.high;
        let part = sum - self.high;
        let rest = (self.high - (sum - part)) + (other.high - part);
        Self::of(sum, rest + (self.low + other.low))
    }

    fn times(self, other: Self) -> Self {
        let product = self.high * other.high;
        let rest = self.high.mul_add(other.high, -product);
        Self::of(product, rest + (self.high * other.low + self.low * other.high))
    }

    fn over(self, by: f64) -> Self {
        let quotient = self.high / by;
        let rest = quotient.mul_add(-by, self.high) + self.low;
        Self::of(quotient, rest / by)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_equal_poles() {
        // (A + 1)^8 = 0: the corner is t^7/7! e^-t, some 1e-38 of what cancels in doubles.
        let gains = [1.0, 8.0, 28.0, 56.0, 70.0, 56.0, 28.0, 8.0];
        let companion: Square = (0..8)
            .map(|i| {
                let shift = |j: usize| if j == i + 1 { 1.0 } else { 0.0 };
                (0..8).map(|j| if i == 7 { -gains[j] } else { shift(j) }).collect()
            })
            .collect();
        for t in [1e-3f64, 0.7, 20.0, 60.0] {
            let exact = t.powi(7) / 5040.0 * f64::exp(-t);
            let found = exponential(&companion, t)[0][7];
            assert!((found / exact - 1.0).abs() < 1e-9, "{found:e} for {exact:e} at {t}");
        }
    }

    #[test]
    fn beyond_the_range_of_doubles() {
        assert_eq!(exponential(&vec![vec![-1.0]], 1e300), [[0.0]]);
        assert!(!exponential(&vec![vec![1.0]], 1e300)[0][0].is_finite());
        assert_eq!(exponential(&vec![vec![0.0]], f64::INFINITY).len(), 1);
    }
}
