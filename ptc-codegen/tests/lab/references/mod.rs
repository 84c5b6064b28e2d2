//! Controllers that follow a reference: against formulas by hand, and in closed loop with the emitted C.

mod by_hand;
mod closed_loop;
use crate::models::in_c;
mod mistakes;
use crate::support;
mod told;

use support::{example, spec};

/// x^(n) that the law of the mapping exp with a = 1 wants of x, x', ... at the time-to-go `to_go`, under
/// which the pole -p leaves x = T^p: the product of T d/dT - p over all poles is 0 on x.
fn wanted(poles: &[f64], x: &[f64], to_go: f64) -> f64 {
    let n = poles.len();
    // The product as a sum of c_k T^k (d/dT)^k: its differences at 0, 1, ... over k!.
    let mut differences: Vec<f64> =
        (0..=n).map(|at| poles.iter().map(|p| at as f64 - p).product()).collect();
    let mut factorial = 1.0;
    let mut sum = 0.0;
    for (k, x) in x.iter().enumerate() {
        factorial *= if k == 0 { 1.0 } else { k as f64 };
        let c = differences[0] / factorial;
        let sign = if (n - k).is_multiple_of(2) { -1.0 } else { 1.0 };
        sum += sign * c * x * to_go.powi(k as i32 - n as i32);
        differences = differences.windows(2).map(|pair| pair[1] - pair[0]).collect();
    }
    sum
}

/// A reference whose derivatives are known: sines, a fading exponential and a polynomial.
struct Known {
    /// Amplitude, angular rate and phase of each sine.
    sines: Vec<[f64; 3]>,
    /// Size and rate.
    fading: [f64; 2],
    /// Coefficients of 1, t, t^2, ...
    polynomial: Vec<f64>,
}

impl Known {
    fn text(&self) -> String {
        let sines = self.sines.iter().map(|[a, w, p]| format!("({a})*sin({w}*t + ({p}))"));
        let powers = (0..).zip(&self.polynomial).map(|(k, c)| format!("({c})*t^{k}"));
        let fading = format!("({})*exp(-{}*t)", self.fading[0], self.fading[1]);
        sines.chain([fading]).chain(powers).collect::<Vec<_>>().join(" + ")
    }

    /// Its derivative of this order: a sine is turned by a right angle each time.
    fn derivative(&self, order: i32, t: f64) -> f64 {
        let turned = f64::from(order) * std::f64::consts::FRAC_PI_2;
        let sine = |[a, w, p]: &[f64; 3]| a * w.powi(order) * (w * t + p + turned).sin();
        let [size, rate] = self.fading;
        let power = |(k, c): (i32, &f64)| match k < order {
            true => 0.0,
            false => (0..order).map(|i| f64::from(k - i)).product::<f64>() * c * t.powi(k - order),
        };
        self.sines.iter().map(sine).sum::<f64>()
            + size * (-rate).powi(order) * (-rate * t).exp()
            + (0..).zip(&self.polynomial).map(power).sum::<f64>()
    }
}
