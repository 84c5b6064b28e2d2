//! The guard that a wanted final error requires.
//!
//! The letter's practical prescribed-time convergence: the law is stopped at time-to-go eps, before
//! its gains blow up, and what is left of the state then has to be small. With the linear law
//! xi' = A_cl xi in stretched time, so x(T) = Phi(T) x(t0) with
//! `Phi(T) = BB_n[mu](T) exp(A_cl kappa(T)) BB_n[kappa](0)`, and
//! |x_i(T)| <= sum_j |Phi_ij| |x_j(t0)|, with equality for some signs of x(t0).
//!
//! *A numeric bound.* Phi is computed in doubles, and T is tried on a logarithmic grid from 1e-12 tau
//! up: a peak between two of its points is not seen, nor is what happens below it. exp has twice the
//! digits of a double, but gains are rounded to one, which moves poles that lie close together.
//! Disturbances, sampling and the limit of u are left out.

mod closed_loop;
mod exponential;

pub use closed_loop::ClosedLoop;

use super::{Outcome, Verdict, bounds, middle};
use crate::diagnostic::{digits, digits_down};

/// The grid begins at this share of tau.
const FLOOR: f64 = 1e-12;

/// Ratio of neighbouring points of the grid.
const STEP: f64 = 1.02;

/// Guard that a wanted final error requires.
#[derive(Clone, Debug, PartialEq)]
pub struct Deadline {
    /// The wanted bound of every |x_i|.
    pub error: f64,
    /// Settling time tau in s.
    pub tau: f64,
    /// The largest eps such that every |x_i| <= error for all T <= eps; `None` if the error is
    /// exceeded next to the deadline already.
    pub largest_eps: Option<f64>,
    /// The bounds of |x_i| at that eps; where there is none, at 1e-12 tau.
    pub bounds: Vec<f64>,
}

/// Finds the largest eps for which |x_i| <= `error` is kept from `x0_max`, the n bounds of |x_i(t0)|.
pub fn deadline(closed_loop: &ClosedLoop<'_>, x0_max: &[f64], error: f64) -> Deadline {
    let tau = closed_loop.tau;
    let start = closed_loop.start();
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
                    digits_down(largest)
                ),
                Some(format!(
                    "take eps <= {} s or place the poles further left",
                    digits_down(largest)
                )),
            ),
            (Some(largest), _) => (
                Verdict::Sound,
                format!("|x| <= {error} for every eps <= {} s", digits_down(largest)),
                None,
            ),
        };
        let at = digits(self.largest_eps.unwrap_or(FLOOR * self.tau));
        let bounds = bounds(self.bounds.iter().copied());
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

    /// r_k of exp: (-1)^(k-1) a^k T, a = 1.
    fn exp_r(t: f64) -> Vec<f64> {
        (1..=8).map(|k| -f64::powi(-1.0, k) * t).collect()
    }

    #[test]
    fn nonvanishing_state_has_no_eps() {
        let gains = [0.2, 1.2];
        let closed_loop =
            ClosedLoop { gains: &gains, tau: 1.0, r: &exp_r, stretched: &|t: f64| -t.ln() };
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
