//! The guard that a wanted final error asks for.
//!
//! The letter's practical prescribed-time convergence: the law is stopped at time-to-go eps, before
//! its gains blow up, and what is left of the state then has to be small. With the linear law
//! xi' = A_cl xi in stretched time, so x(T) = Phi(T) x(t0) with
//! `Phi(T) = BB_n[mu](T) exp(A_cl kappa(T)) BB_n[kappa](0)`, and
//! |x_i(T)| <= sum_j |Phi_ij| |x_j(t0)|, with equality for some signs of x(t0).
//!
//! *A numeric bound.* Phi is computed in doubles, and T is tried on a logarithmic grid from 1e-12 tau
//! up: a peak between two of its points is not seen, nor is what happens below it. Where n poles of
//! high order lie close together it holds to few digits once |x| is far below rounding. Disturbances,
//! sampling and the limit of u are left out.

use nalgebra::{DMatrix, DVector};

use super::{Outcome, Verdict, digits, list, middle};

/// The grid begins at this share of tau.
const FLOOR: f64 = 1e-12;

/// Ratio of neighbouring points of the grid.
const STEP: f64 = 1.02;

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

/// What a wanted final error asks of the guard.
#[derive(Clone, Debug, PartialEq)]
pub struct Deadline {
    /// The wanted bound of every |x_i|.
    pub error: f64,
    /// Settling time tau in s.
    pub tau: f64,
    /// The largest eps such that every |x_i| <= error for all T <= eps; none where the error is
    /// exceeded next to the deadline already.
    pub largest_eps: Option<f64>,
    /// The bounds of |x_i| at that eps; where there is none, at 1e-12 tau.
    pub bounds: Vec<f64>,
}

/// Finds the largest eps for which |x_i| <= `error` is kept from `x0_max`, the n bounds of |x_i(t0)|.
pub fn deadline(closed_loop: &ClosedLoop<'_>, x0_max: &[f64], error: f64) -> Deadline {
    let tau = closed_loop.tau;
    let start = bell(&(closed_loop.r)(tau), closed_loop.gains.len());
    let bounds = |time_to_go: f64| closed_loop.bounds(&start, x0_max, time_to_go);
    // A bound that is not a number is no bound.
    let kept = |time_to_go: f64| bounds(time_to_go).iter().all(|bound| *bound <= error);
    let mut eps = FLOOR * tau;
    if !kept(eps) {
        return Deadline { error, tau, largest_eps: None, bounds: bounds(eps) };
    }
    while eps < tau && kept((eps * STEP).min(tau)) {
        eps = (eps * STEP).min(tau);
    }
    if eps < tau {
        let mut beyond = (eps * STEP).min(tau);
        for _ in 0..40 {
            let between = middle(eps, beyond);
            if kept(between) {
                eps = between;
            } else {
                beyond = between;
            }
        }
    }
    Deadline { error, tau, largest_eps: Some(eps), bounds: bounds(eps) }
}

impl ClosedLoop<'_> {
    /// The bounds of |x_i| at time-to-go T; infinite where they cannot be computed. `start` is
    /// BB_n[kappa](0).
    fn bounds(&self, start: &DMatrix<f64>, x0_max: &[f64], time_to_go: f64) -> Vec<f64> {
        let n = self.gains.len();
        let stretched = (self.stretched)(time_to_go);
        let here = bell(&(self.r)(time_to_go), n);
        let state = here.solve_lower_triangular(&(self.transition(stretched) * start));
        let Some(transition) = state else { return vec![f64::INFINITY; n] };
        let bounds = transition.abs() * DVector::from_fn(n, |j, _| x0_max[j].abs());
        bounds.iter().map(|b| if b.is_nan() { f64::INFINITY } else { *b }).collect()
    }

    /// exp(A_cl t) in stretched time t, with A_cl the companion matrix of the gains. Time is taken in
    /// units of the poles' size, a power of 2 so that scaling rounds nothing: all entries are of one
    /// size then.
    fn transition(&self, stretched: f64) -> DMatrix<f64> {
        let n = self.gains.len();
        let root = |(k, order): (&f64, i32)| k.abs().powf(1.0 / f64::from(order));
        let size = self.gains.iter().zip(orders(n)).map(root).fold(0.0, f64::max);
        let size = if size > 0.0 { size.log2().round().exp2() } else { 1.0 };
        let powers: Vec<f64> = (0..).map(|i| size.powi(i)).take(n).collect();
        let scaled: Vec<f64> =
            self.gains.iter().zip(orders(n)).map(|(k, order)| k / size.powi(order)).collect();
        let companion = DMatrix::from_fn(n, n, |i, j| match (i + 1 == n, j == i + 1) {
            (true, _) => -scaled[j],
            (false, true) => 1.0,
            (false, false) => 0.0,
        });
        let transition = exponential(&companion, size * stretched);
        DMatrix::from_fn(n, n, |i, j| transition[(i, j)] * (powers[i] / powers[j]))
    }
}

/// n, n-1, ..., 1: the orders of k_1..k_n in the poles.
fn orders(n: usize) -> impl Iterator<Item = i32> {
    (1..=i32::try_from(n).unwrap_or(i32::MAX)).rev()
}

/// exp(A t): by nalgebra on a stretch of moderate norm, squared from there on, so that powers of t
/// stay finite for any t.
fn exponential(matrix: &DMatrix<f64>, time: f64) -> DMatrix<f64> {
    let (mut stretch, mut squarings) = (time, 0);
    while stretch.abs() > 1.0 && squarings < 1100 {
        stretch *= 0.5;
        squarings += 1;
    }
    let mut result = (matrix * stretch).exp();
    for _ in 0..squarings {
        result = &result * &result;
    }
    result
}

/// BB_n with entries (i, j) = B_{i-1,j-1}(r_1, ...), by the Bell recurrence
/// B_{i,j} = sum_l C(i-1, l-1) r_l B_{i-l,j-1}.
fn bell(r: &[f64], n: usize) -> DMatrix<f64> {
    let mut entries = DMatrix::zeros(n, n);
    for i in 0..n {
        for j in 0..=i {
            if i == 0 || j == 0 {
                entries[(i, j)] = if i == j { 1.0 } else { 0.0 };
                continue;
            }
            let (mut binomial, mut sum) = (1.0, 0.0);
            for l in 1..=(i - j + 1) {
                sum += binomial * r[l - 1] * entries[(i - l, j - 1)];
                binomial *= to_f64(i - l) / to_f64(l);
            }
            entries[(i, j)] = sum;
        }
    }
    entries
}

#[allow(clippy::cast_precision_loss)]
fn to_f64(count: usize) -> f64 {
    count as f64
}

impl Deadline {
    /// The outcome for a guard `eps` that the design has chosen, if it has.
    pub fn outcome(&self, eps: Option<f64>) -> Outcome {
        let error = digits(self.error);
        let (verdict, summary, fix) = match (self.largest_eps, eps) {
            (None, _) => (
                Verdict::Unsound,
                format!("|x| exceeds {error} next to the deadline already"),
                Some("place the poles further left or allow a larger error".to_owned()),
            ),
            (Some(largest), Some(eps)) if eps > largest => (
                Verdict::Unsound,
                format!(
                    "eps = {} s is too early to stop: |x| <= {error} from {} s on",
                    digits(eps),
                    digits(largest)
                ),
                Some(format!("take eps <= {} s or place the poles further left", digits(largest))),
            ),
            (Some(largest), _) => (
                Verdict::Sound,
                format!("|x| <= {error} for every eps <= {} s", digits(largest)),
                None,
            ),
        };
        let at = digits(self.largest_eps.unwrap_or(FLOOR * self.tau));
        let bounds = list(self.bounds.iter().copied());
        let details = vec![format!("numeric bounds of |x_i| at T = {at} s: {bounds}")];
        Outcome { name: "deadline", verdict, summary, details, fix }
    }
}

impl From<&Deadline> for Outcome {
    fn from(deadline: &Deadline) -> Self {
        deadline.outcome(None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let n = closed_loop.gains.len();
        let start = bell(&(closed_loop.r)(closed_loop.tau), n);
        let mut x0 = vec![0.0; n];
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
        let start = bell(&exp_r(1.0)(1.0), 8);
        let x0 = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for (t, tolerance) in [(0.1f64, 1e-8), (1e-3, 1e-4), (1e-6, 0.1)] {
            let term = |pi: &f64| {
                let others = p.iter().filter(|pj| *pj != pi);
                t.powf(*pi) * others.map(|pj| pj / (pj - pi)).product::<f64>()
            };
            let exact: f64 = p.iter().map(term).sum();
            let found = closed_loop.bounds(&start, &x0, t)[0];
            // Eight poles so close together have a condition number of about 1e9, and each squaring
            // of exp(A t) doubles what it makes of the rounding; |x| itself is 1e-50 at the last T.
            assert!(
                (found - exact).abs() < tolerance * exact.abs(),
                "{found:e} for {exact:e} at {t}"
            );
        }
    }

    #[test]
    fn a_state_that_does_not_vanish() {
        let gains = [0.2, 1.2];
        let closed_loop =
            ClosedLoop { gains: &gains, tau: 1.0, r: &exp_r(1.0), stretched: &|t: f64| -t.ln() };
        let found = deadline(&closed_loop, &[1.0, 0.0], 0.1);
        assert_eq!(found.largest_eps, None);
        assert_eq!(Outcome::from(&found).summary, "|x| exceeds 0.1 next to the deadline already");
        let wide = deadline(&ClosedLoop { gains: &[6.0, 5.0], ..closed_loop }, &[1.0, 0.0], 10.0);
        assert_eq!(wide.largest_eps, Some(1.0));
        let narrow = deadline(&ClosedLoop { gains: &[6.0, 5.0], ..closed_loop }, &[1.0, 0.0], 0.06);
        let told = narrow.outcome(Some(0.1));
        assert_eq!(told.summary, "eps = 0.1 s is too early to stop: |x| <= 0.06 from 0.0101 s on");
        assert_eq!(told.details, ["numeric bounds of |x_i| at T = 0.0101 s: 3.041e-4, 0.06"]);
    }
}
