//! Random loops and their exact solutions: derivatives of kappa written down by hand, and the matrix
//! exponential of nalgebra in doubles.

use nalgebra::{DMatrix, DVector};

/// Numbers that look drawn, the same in each run.
pub(crate) struct Drawn(pub(crate) u64);

impl Drawn {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as f64 / f64::from(1u32 << 31)
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// A mapping: its words, and kappa with three derivatives by dt/tau at T/tau = w.
pub(crate) type Kappa = (String, fn(f64, f64) -> [f64; 4]);

pub(crate) fn of_mu(t: f64, m1: f64, m2: f64, m3: f64) -> [f64; 4] {
    [t, 1.0 / m1, -m2 / m1.powi(3), 3.0 * m2 * m2 / m1.powi(5) - m3 / m1.powi(4)]
}

pub(crate) fn root(c: impl Fn(f64) -> f64, w: f64) -> f64 {
    let (mut low, mut high) = (0.0, 100.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if c(middle) > w { low = middle } else { high = middle }
    }
    low
}

/// All of them of rate `a`.
pub(crate) fn mappings(a: f64) -> Vec<Kappa> {
    vec![
        (format!("mu = \"exp(a={a})\""), |w, a| {
            [-w.ln() / a, 1.0 / (a * w), 1.0 / (a * w * w), 2.0 / (a * w.powi(3))]
        }),
        (format!("mu = \"rational(a={a})\""), |w, a| {
            let one = 1.0 / (a * w * w);
            [(1.0 / w - 1.0) / a, one, 2.0 * one / w, 6.0 * one / (w * w)]
        }),
        (format!("mu = \"power(a={a}, m=0.5)\""), |w, a| {
            let one = w.powf(-1.5) / a;
            [(w.powf(-0.5) - 1.0) / (0.5 * a), one, 1.5 * one / w, 3.75 * one / (w * w)]
        }),
        (format!("mu = \"tan(a={a})\""), |w, a| {
            let c = std::f64::consts::FRAC_PI_2;
            let (sin, cos) = (c * w).sin_cos();
            let (cot, csc) = (cos / sin, 1.0 / (sin * sin));
            let third = 4.0 * csc * cot * cot + 2.0 * csc * csc;
            [cot / a, c * csc / a, 2.0 * c * c * csc * cot / a, c.powi(3) * third / a]
        }),
        (format!("mu = \"tanh(a={a})\""), |w, a| {
            let s = 1.0 - w;
            let v = w * (1.0 + s);
            let third = (2.0 + 6.0 * s * s) / v.powi(3);
            [s.atanh() / a, 1.0 / (a * v), 2.0 * s / (a * v * v), third / a]
        }),
        (format!("mu = \"algebraic(a={a})\""), |w, a| {
            let s = 1.0 - w;
            let v = w * (1.0 + s);
            let third = 3.0 * v.powf(-2.5) + 15.0 * s * s * v.powf(-3.5);
            [s / v.sqrt() / a, v.powf(-1.5) / a, 3.0 * s * v.powf(-2.5) / a, third / a]
        }),
        (format!("mu = \"exp_sum(rates=[{a}, 3])\""), |w, a| {
            let t = root(|t| 0.5 * ((-a * t).exp() + (-3.0 * t).exp()), w);
            let m = |k: i32| {
                -0.5 * ((-a).powi(k) * (-a * t).exp() + (-3f64).powi(k) * (-3.0 * t).exp())
            };
            of_mu(t, m(1), m(2), m(3))
        }),
        ("kappa = \"dt/(tau - dt) + dt/tau\"".to_owned(), |w, _| {
            [1.0 / w - w, 1.0 / (w * w) + 1.0, 2.0 / w.powi(3), 6.0 / w.powi(4)]
        }),
        ("mu = \"tau*(1 - exp(-t)/(1 + t))\"".to_owned(), |w, _| {
            let t = root(|t| (-t).exp() / (1.0 + t), w);
            let (e, p) = ((-t).exp(), 1.0 / (1.0 + t));
            let second = p + 2.0 * p * p + 2.0 * p.powi(3);
            let third = p + 3.0 * p * p + 6.0 * p.powi(3) + 6.0 * p.powi(4);
            of_mu(t, e * (p + p * p), -e * second, e * third)
        }),
    ]
}

/// k_1..k_n of conjugate pairs and real poles, and their words.
pub(crate) fn law(drawn: &mut Drawn, n: usize) -> (Vec<f64>, String) {
    let mut product = vec![1.0];
    let mut words = Vec::new();
    let times = |product: &[f64], factor: &[f64]| {
        let mut next = vec![0.0; product.len() + factor.len() - 1];
        for (i, a) in product.iter().enumerate() {
            factor.iter().enumerate().for_each(|(j, b)| next[i + j] += a * b);
        }
        next
    };
    // In eighths, which are exact.
    let mut eighth = |low: f64, high: f64| (8.0 * drawn.between(low, high)).round() / 8.0;
    let mut left = n;
    while left > 0 {
        let re = eighth(-5.0, -2.0);
        if left > 1 && eighth(0.0, 1.0) < 0.6 {
            let im = eighth(0.0, 3.0);
            product = times(&product, &[re * re + im * im, -2.0 * re, 1.0]);
            words.extend([format!("\"{re}+{im}i\""), format!("\"{re}-{im}i\"")]);
            left -= 2;
        } else {
            product = times(&product, &[-re, 1.0]);
            words.push(format!("{re}"));
            left -= 1;
        }
    }
    product.truncate(n);
    let gains: Vec<_> = product.iter().map(|k| format!("{k:?}")).collect();
    let by_gains = eighth(0.0, 1.0) < 0.5;
    let words = if by_gains {
        format!("gains = [{}]", gains.join(", "))
    } else {
        format!("poles = [{}]", words.join(", "))
    };
    (product, words)
}

/// x_1..x_n and g u from x at w = 1, for tau = 1: one row each.
pub(crate) fn transition(gains: &[f64], kappa: &Kappa, a: f64, w: f64) -> DMatrix<f64> {
    let n = gains.len();
    let companion = DMatrix::from_fn(n, n, |i, j| {
        if i + 1 == n { -gains[j] } else { f64::from(u8::from(j == i + 1)) }
    });
    let rows = |w: f64| {
        let [_, k1, k2, k3] = (kappa.1)(w, a);
        let table = [
            [1.0, 0.0, 0.0, 0.0],
            [0.0, k1, 0.0, 0.0],
            [0.0, k2, k1 * k1, 0.0],
            [0.0, k3, 3.0 * k1 * k2, k1.powi(3)],
        ];
        DMatrix::from_fn(n + 1, n + 1, |i, j| table[i][j])
    };
    let start = rows(1.0).view((0, 0), (n, n)).clone_owned().try_inverse().expect("an inverse");
    let xi = (companion * (kappa.1)(w, a)[0]).exp() * start;
    let law = -DVector::from_column_slice(gains).transpose() * &xi;
    let mut all = xi.clone().resize(n + 1, n, 0.0);
    all.set_row(n, &law.row(0));
    rows(w) * all
}

/// The same for a plant of another tau and gain.
pub(crate) fn in_units(mut rows: DMatrix<f64>, tau: f64, g: f64) -> DMatrix<f64> {
    let n = rows.ncols();
    for i in 0..=n {
        for c in 0..n {
            rows[(i, c)] *= tau.powf(c as f64 - i as f64) / if i == n { g } else { 1.0 };
        }
    }
    rows
}

/// Greatest values over the run: |u|, x1 + x2 (or x1), |x|/|x0|, and |x| at its end.
pub(crate) fn peaks(runs: &[Vec<DMatrix<f64>>], corners: &[DVector<f64>]) -> [f64; 4] {
    let mut peaks = [0.0_f64; 4];
    for run in runs {
        for (at, rows) in run.iter().enumerate() {
            let n = rows.ncols();
            let states = rows.view((0, 0), (n, n)).clone_owned();
            peaks[2] = peaks[2].max(states.clone().svd(false, false).singular_values[0]);
            for corner in corners {
                let all = rows * corner;
                peaks[0] = peaks[0].max(all[n].abs());
                peaks[1] = peaks[1].max(all[0] + if n > 1 { all[1] } else { 0.0 });
                if at + 1 == run.len() {
                    peaks[3] = peaks[3].max((states.clone() * corner).norm());
                }
            }
        }
    }
    peaks
}

pub(crate) fn corners(size: &[f64]) -> Vec<DVector<f64>> {
    let n = size.len();
    let sign = |corner: usize, j: usize| if corner >> j & 1 == 1 { 1.0 } else { -1.0 };
    (0..1 << n).map(|c| DVector::from_fn(n, |j, _| sign(c, j) * size[j])).collect()
}

/// T/tau from 1 to `until`, even in its logarithm.
pub(crate) fn until_share(until: f64, i: u32, last: u32) -> f64 {
    until.powf(f64::from(i) / f64::from(last))
}
