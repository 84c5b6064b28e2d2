//! The state of a closed loop at any time-to-go, in closed form.

use super::super::to_f64;
use super::exponential::{Square, exponential};

/// A closed loop in the numbers that its state at the deadline depends on.
#[derive(Clone, Copy)]
pub struct ClosedLoop<'a> {
    /// Gains k_1..k_n.
    pub gains: &'a [f64],
    /// Settling time tau in s.
    pub tau: f64,
    /// r_1..r_n, the derivatives of mu at the stretched time of time-to-go T. Those beyond r_(n-1) are
    /// not used.
    pub r: &'a dyn Fn(f64) -> Vec<f64>,
    /// Stretched time kappa since t0 at time-to-go T.
    pub stretched: &'a dyn Fn(f64) -> f64,
}

impl ClosedLoop<'_> {
    /// BB_n[kappa](0).
    pub(super) fn start(&self) -> Square {
        bell(&(self.r)(self.tau), self.gains.len())
    }

    /// The bounds of |x_i| at time-to-go T; infinite where they cannot be computed. `start` is
    /// BB_n[kappa](0).
    pub(super) fn bounds(&self, start: &Square, x0_max: &[f64], time_to_go: f64) -> Vec<f64> {
        let n = self.gains.len();
        let stretched = (self.stretched)(time_to_go);
        let here = bell(&(self.r)(time_to_go), n);
        let state = solved(&here, times(&self.transition(stretched), start));
        let bound = |row: &Vec<f64>| row.iter().zip(x0_max).map(|(x, most)| (x * most).abs()).sum();
        let bounds = state.iter().map(bound);
        bounds.map(|bound: f64| if bound.is_nan() { f64::INFINITY } else { bound }).collect()
    }

    /// exp(A_cl t) in stretched time t, with A_cl the companion matrix of the gains. Time is taken in
    /// units of the poles' size, a power of 2 so that scaling rounds nothing: all entries are of one
    /// size then.
    fn transition(&self, stretched: f64) -> Square {
        let n = self.gains.len();
        let root = |(k, order): (&f64, i32)| k.abs().powf(1.0 / f64::from(order));
        let size = self.gains.iter().zip(orders(n)).map(root).fold(0.0, f64::max);
        let size = if size > 0.0 { size.log2().round().exp2() } else { 1.0 };
        let powers: Vec<f64> = (0..).map(|i| size.powi(i)).take(n).collect();
        let scaled: Vec<f64> =
            self.gains.iter().zip(orders(n)).map(|(k, order)| k / size.powi(order)).collect();
        let companion = square(n, |i, j| match (i + 1 == n, j == i + 1) {
            (true, _) => -scaled[j],
            (false, true) => 1.0,
            (false, false) => 0.0,
        });
        let transition = exponential(&companion, size * stretched);
        square(n, |i, j| transition[i][j] * (powers[i] / powers[j]))
    }
}

/// n, n-1, ..., 1: the orders of k_1..k_n in the poles.
fn orders(n: usize) -> impl Iterator<Item = i32> {
    (1..=i32::try_from(n).unwrap_or(i32::MAX)).rev()
}

/// BB_n with entries (i, j) = B_{i-1,j-1}(r_1, ...), by the Bell recurrence
/// B_{i,j} = sum_l C(i-1, l-1) r_l B_{i-l,j-1}.
fn bell(r: &[f64], n: usize) -> Square {
    let mut entries = square(n, |i, j| if i == 0 && j == 0 { 1.0 } else { 0.0 });
    for i in 1..n {
        for j in 1..=i {
            let (mut binomial, mut sum) = (1.0, 0.0);
            for l in 1..=(i - j + 1) {
                sum += binomial * r[l - 1] * entries[i - l][j - 1];
                binomial *= to_f64(i - l) / to_f64(l);
            }
            entries[i][j] = sum;
        }
    }
    entries
}

fn square(n: usize, entry: impl Fn(usize, usize) -> f64) -> Square {
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

fn times(a: &Square, b: &Square) -> Square {
    square(a.len(), |i, j| a[i].iter().zip(b).map(|(x, row)| x * row[j]).sum())
}

/// L^-1 R for a lower triangular L, by substitution.
fn solved(lower: &Square, mut right: Square) -> Square {
    for (i, lower) in lower.iter().enumerate() {
        let (above, below) = right.split_at_mut(i);
        for (j, entry) in below[0].iter_mut().enumerate() {
            let known: f64 = lower.iter().zip(above.iter()).map(|(l, row)| l * row[j]).sum();
            *entry = (*entry - known) / lower[i];
        }
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::deadline::deadline;

    /// r_k of exp: (-1)^(k-1) a^k T.
    fn exp_r(a: f64) -> impl Fn(f64) -> Vec<f64> {
        move |t| (1..=8).map(|k| -(-a).powi(k) * t).collect()
    }

    /// r_k of rational: (-1)^(k-1) k! (a/tau)^k T^(k+1), a = 1.
    fn rational_r(tau: f64) -> impl Fn(f64) -> Vec<f64> {
        move |t| {
            let factorial = |k| (1..=k).map(f64::from).product::<f64>();
            (1..=8).map(|k| -(-1.0 / tau).powi(k) * factorial(k) * t.powi(k + 1)).collect()
        }
    }

    fn check_exact(closed_loop: &ClosedLoop<'_>, exact: impl Fn(f64) -> Vec<f64>, j: usize) {
        let start = closed_loop.start();
        let mut x0 = vec![0.0; closed_loop.gains.len()];
        x0[j] = 1.0;
        for share in [1.0, 0.7, 0.1, 1e-3, 1e-6] {
            let t = share * closed_loop.tau;
            for (found, x) in closed_loop.bounds(&start, &x0, t).iter().zip(exact(t)) {
                // A squaring doubles the relative error: rounding grows by the size of A t, 1e2.
                assert!(
                    (found - x.abs()).abs() <= 1e-10 * x.abs() + 1e-14,
                    "{found} for {x} at {t}"
                );
            }
        }
    }

    #[test]
    fn exact_solution_of_order_1() {
        let closed_loop = ClosedLoop {
            gains: &[1.0],
            tau: 1.0,
            r: &exp_r(0.1),
            stretched: &|t: f64| -t.ln() / 0.1,
        };
        check_exact(&closed_loop, |t| vec![t.powi(10)], 0);
        let found = deadline(&closed_loop, &[1.0], 1e-3);
        // T^10 = 1e-3.
        let eps = found.largest_eps.expect("converges");
        assert!((eps - 10f64.powf(-0.3)).abs() < 1e-9, "{eps}");
    }

    #[test]
    fn exact_solution_of_order_2() {
        let closed_loop = ClosedLoop {
            gains: &[6.0, 5.0],
            tau: 1.0,
            r: &exp_r(1.0),
            stretched: &|t: f64| -t.ln(),
        };
        check_exact(
            &closed_loop,
            |t| vec![3.0 * t * t - 2.0 * t.powi(3), -6.0 * t + 6.0 * t * t],
            0,
        );
        let found = deadline(&closed_loop, &[1.0, 0.0], 0.06);
        // x_2 = -6T + 6T^2 decides: T - T^2 = 0.01.
        let exact = (1.0 - 0.96f64.sqrt()) / 2.0;
        assert!((found.largest_eps.expect("converges") - exact).abs() < 1e-9);
        assert!((found.bounds[1] - 0.06).abs() < 1e-9);
    }

    #[test]
    fn exact_solution_of_the_rational_family() {
        let stretched = |t: f64| (10.0 - t) / t;
        let closed_loop = ClosedLoop {
            gains: &[1.0, 2.0],
            tau: 10.0,
            r: &rational_r(10.0),
            stretched: &stretched,
        };
        // From x0 = (1, 0), xi = (1, 0): x_1 = (1 + s) e^-s, x_2 = -kappa' s e^-s.
        let exact = |t: f64| {
            let s = stretched(t);
            vec![(1.0 + s) * (-s).exp(), -10.0 / (t * t) * s * (-s).exp()]
        };
        check_exact(&closed_loop, exact, 0);
        // From x0 = (0, 1), xi = (0, 10): x_1 = 10 s e^-s, x_2 = 10 kappa' (1 - s) e^-s.
        let exact = |t: f64| {
            let s = stretched(t);
            vec![10.0 * s * (-s).exp(), 100.0 / (t * t) * (1.0 - s) * (-s).exp()]
        };
        check_exact(&closed_loop, exact, 1);
        let found = deadline(&closed_loop, &[1.0, 1.0], 1e-6);
        assert!(found.largest_eps.is_some_and(|eps| eps > 0.1 && eps < 1.0), "{found:?}");
    }

    #[test]
    fn poles_of_order_8() {
        // x_1 from (1, 0, ...) is sum_i T^(p_i) prod_(j != i) p_j/(p_j - p_i) for poles -p_i.
        let p: Vec<f64> = (9..=16).map(f64::from).collect();
        let gains = {
            let mut c = vec![1.0];
            for pole in &p {
                let lower = c.iter().map(|c| c * pole).chain([0.0]);
                c = lower
                    .zip(std::iter::once(0.0).chain(c.iter().copied()))
                    .map(|(a, b)| a + b)
                    .collect();
            }
            c.pop();
            c
        };
        let closed_loop =
            ClosedLoop { gains: &gains, tau: 1.0, r: &exp_r(1.0), stretched: &|t: f64| -t.ln() };
        let start = closed_loop.start();
        let x0 = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for t in [0.1f64, 1e-3, 1e-6] {
            let term = |pi: &f64| {
                let others = p.iter().filter(|pj| *pj != pi);
                t.powf(*pi) * others.map(|pj| pj / (pj - pi)).product::<f64>()
            };
            let exact: f64 = p.iter().map(term).sum();
            let found = closed_loop.bounds(&start, &x0, t)[0];
            // |x| itself is 1e-50 at the last T.
            assert!((found - exact).abs() < 1e-11 * exact.abs(), "{found:e} for {exact:e} at {t}");
        }
    }
}
