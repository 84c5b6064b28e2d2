//! The loops of [`Op::Rows`](super::Op::Rows), on whatever stands for numbers.

/// sum_i weights_i \[z^(i+1)\] p^(j+1) for j = 0, 1, ..., with p(z) = z + sum_d tail_d z^(d+2).
///
/// Multiplication by p, transposed, takes the weights to those for the powers that are left, one less
/// in number. Each round does so in place, and leaves its first weight, that of p^j alone, as element j.
/// No power is formed. `sum` gives a + b * c, rounded twice.
pub fn rows<T: Copy>(tail: &[T], weights: &[T], mut sum: impl FnMut(T, T, T) -> T) -> Vec<T> {
    let mut rows = weights.to_vec();
    for first in 0..tail.len() {
        for at in first..tail.len() {
            for (later, coefficient) in (at + 1..rows.len()).zip(tail) {
                rows[at] = sum(rows[at], *coefficient, rows[later]);
            }
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_weighted_coefficients_of_powers() {
        let (tail, weights) = ([2, 3, 5], [1, 10, 100, 1000]);
        // p = z + 2 z^2 + 3 z^3 + 5 z^4, p^2 = z^2 + 4 z^3 + 10 z^4, p^3 = z^3 + 6 z^4, p^4 = z^4.
        let expected = [5321, 10410, 6100, 1000];
        assert_eq!(rows(&tail, &weights, |a, b, c| a + b * c), expected);
    }
}
