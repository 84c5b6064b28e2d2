//! Sums of x and u under a bounded force, of which no signal is worst for all of them at once.

use super::proved;

/// Effect of an impulse at T/tau = w0 on x1, x2 and u at w, for tau = 1: the loop of exp(a=1) with the poles -4 and -5
/// has x1 = a w^4 + b w^5, and the impulse x1 = 0, x2 = 1.
fn kernel(w: f64, w0: f64) -> [f64; 3] {
    let [cube, fourth] = [w0.powi(3), w0.powi(4)];
    [
        w.powi(4) / cube - w.powi(5) / fourth,
        -4.0 * w.powi(3) / cube + 5.0 * w.powi(4) / fourth,
        12.0 * w.powi(2) / cube - 20.0 * w.powi(3) / fourth,
    ]
}

/// The greatest sum, and the greatest sum of the sizes, over a run with |f| <= 1; the factors depend on
/// the time-to-go.
fn greatest(factors: &dyn Fn(f64) -> [f64; 3], tau: [f64; 2]) -> [f64; 2] {
    let mut most = [0.0_f64; 2];
    for k in 0..=8 {
        let tau = tau[0] + (tau[1] - tau[0]) * f64::from(k) / 8.0;
        for w in (1..200).map(|i| f64::from(i) / 200.0) {
            let [a, b, c] = factors(w * tau);
            let row = [a * tau * tau, b * tau, c];
            let (mut sum, mut sizes) = (0.0, [0.0; 3]);
            let parts = 2000;
            for i in 0..parts {
                let width = (1.0 - w) / f64::from(parts);
                let own = kernel(w, w + (f64::from(i) + 0.5) * width);
                let terms = [0, 1, 2].map(|r| row[r] * own[r] * width);
                sum += terms.iter().sum::<f64>().abs();
                sizes.iter_mut().zip(terms).for_each(|(size, term)| *size += term.abs());
            }
            most = [most[0].max(sum), most[1].max(sizes.iter().sum())];
        }
    }
    most
}

fn is_proved(h: &str, high: f64, tau: [f64; 2]) -> bool {
    let text = format!(
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[plant]\nf = \"d\"\nd = [-1, 1]\n\
         [disturbance]\nd = \"any\"\n[verify]\nx1 = 0\nx2 = 0\ntau = {tau:?}\n\
         [[objective]]\nbound = \"within\"\nh = \"{h}\"\nhigh = {high:?}\n"
    );
    proved(&text) == [true]
}

#[test]
fn a_sum_is_bounded_as_one() {
    type Factors<'a> = &'a dyn Fn(f64) -> [f64; 3];
    let cases: [(&str, Factors); 3] = [
        ("5*x1 + x2", &|_| [5.0, 1.0, 0.0]),
        ("2*x1 + x2*T", &|left| [2.0, left, 0.0]),
        ("8*x1 + 3*x2 + u*T", &|left| [8.0, 3.0, left]),
    ];
    for (h, factors) in cases {
        for tau in [[1.0, 1.0], [1.0, 1.5]] {
            let [truth, apart] = greatest(factors, tau);
            assert!(apart > 1.06 * truth, "{h}: {apart} is no more than {truth}");
            assert!(is_proved(h, 1.04 * truth, tau), "{h} < 1.04 {truth}, {tau:?}");
            assert!(!is_proved(h, 0.995 * truth, tau), "{h} < 0.995 {truth}, {tau:?}");
        }
    }
}
