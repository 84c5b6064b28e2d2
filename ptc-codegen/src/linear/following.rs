//! A linear plant whose output follows a reference r: its state then, and the input that keeps it there.
//!
//! With c B = ... = c A^(n-2) B = 0 the rows T = (c, c A, ..., c A^(n-1)) give y, y', ..., y^(n-1), and y^(n) is
//! c A^n x + g u with g = c A^(n-1) B. So y = r where x = T^-1 (r, r', ..., r^(n-1)) and u = (r^(n) - c A^n x)/g.

use num_traits::Zero;

use super::{Linear, Matrix, dot, factorial};
use crate::algebra::{BigRational, integer};

/// State and input of a plant whose output is r, in rows over r, r', ..., r^(n).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Following {
    output: Vec<BigRational>,
    rows: Vec<Vec<BigRational>>,
}

impl Linear {
    /// Returns the state and the input for which the output `c` x of the plant follows a reference.
    ///
    /// # Errors
    /// The relative degree of the output where it is not the order of the plant: 0 where no input reaches it.
    pub(crate) fn following(&self, c: &[BigRational]) -> Result<Following, usize> {
        let n = self.b.len();
        let a = Matrix::of(self.a.clone());
        let mut rows = vec![c.to_vec()];
        for i in 0..n {
            rows.push(a.after_row(&rows[i]));
        }
        let gains = rows[..n].iter().map(|row| dot(row.iter().zip(&self.b)));
        let reached = gains.enumerate().find(|(_, gain)| !gain.is_zero());
        let (degree, gain) = reached.map_or((0, integer(0)), |(i, gain)| (i + 1, gain));
        let last = rows.pop().filter(|_| degree == n).ok_or(degree)?;
        let states = Matrix::of(rows).inverse().ok_or(degree)?;
        let input = states.after_row(&last).into_iter().map(|of| -of / &gain);
        let input = input.chain([integer(1) / &gain]).collect();
        let zero = |row: &Vec<BigRational>| [row.as_slice(), &[integer(0)]].concat();
        let rows = states.rows().iter().map(zero).chain([input]).collect();
        Ok(Following { output: c.to_vec(), rows })
    }
}

impl Following {
    /// The output, over the states.
    pub(crate) fn output(&self) -> &[BigRational] {
        &self.output
    }

    /// The states, then the input, each over r, r', ..., r^(n).
    pub(crate) fn rows(&self) -> &[Vec<BigRational>] {
        &self.rows
    }

    /// The same with the mean of the input over a sample of length `h` that begins `late` samples from now, where
    /// r, ..., r^(n-1) are those of now, and r^(n) is its mean in that sample.
    pub(crate) fn mean(&self, h: &BigRational, late: &BigRational) -> Vec<Vec<BigRational>> {
        let mut rows = self.rows.clone();
        let Some(input) = rows.pop() else { return rows };
        let n = rows.len();
        let end = late + integer(1);
        // The mean of what is now t^j/j!.
        let share = |j: usize| {
            let power = |base: &BigRational| num_traits::pow(base.clone(), j + 1);
            num_traits::pow(h.clone(), j) * (power(&end) - power(late)) / factorial(j + 1)
        };
        let of = |l: usize| {
            let below = (0..=l.min(n - 1)).map(|i| &input[i] * share(l - i));
            below.sum::<BigRational>() + if l == n { input[n].clone() } else { integer(0) }
        };
        rows.push((0..=n).map(of).collect());
        rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(a: i64, b: i64) -> BigRational {
        BigRational::new(a.into(), b.into())
    }

    /// theta' = w, w' = 10 i - w, i' = 100 u - 2 w - 50 i, y = theta: by hand w = r', i = (r'' + r')/10 and
    /// u = (i' + 2 w + 50 i)/100.
    #[test]
    fn motor_states_on_the_reference_match_hand_results() {
        let row = |row: [i64; 3]| row.map(integer).to_vec();
        let plant = Linear {
            a: vec![row([0, 1, 0]), row([0, -1, 10]), row([0, -2, -50])],
            b: row([0, 0, 100]),
            c: vec![row([1, 0, 0])],
        };
        let found = plant.following(&plant.c[0]).expect("flat");
        let tenth = ratio(1, 10);
        assert_eq!(found.rows()[2], [integer(0), tenth.clone(), tenth, integer(0)]);
        let input = [integer(0), ratio(7, 100), ratio(51, 1000), ratio(1, 1000)];
        assert_eq!(found.rows()[3], input);
        assert_eq!(plant.following(&row([0, 1, 0])), Err(2));
        // r = t^3: r''' = 6, and the mean of r'' = 6 t and r' = 3 t^2 over the sample from 2 h to 3 h.
        let h = ratio(1, 5);
        let mean = &found.mean(&h, &integer(2))[3];
        let wanted = &input[3] * integer(6)
            + &input[2] * integer(6) * &h * ratio(5, 2)
            + &input[1] * (&h * &h) * (integer(27) - integer(8));
        assert_eq!(&mean[3] * integer(6), wanted);
    }
}
