//! What `verify` proves, against dense samples of exact solutions: derivatives of kappa written down by
//! hand, and the matrix exponential of nalgebra in doubles.

mod support;

use nalgebra::{DMatrix, DVector};
use ptc_codegen::verify::bound::Proof;
use ptc_codegen::verify::{self, Campaign, Trial};

/// Whether each objective is proved.
fn proved(text: &str) -> Vec<bool> {
    verify::bound::proved(&campaign(text)).iter().map(Proof::is_proved).collect()
}

/// Why the first objective is not proved.
fn why(text: &str) -> String {
    match &verify::bound::proved(&campaign(text))[0] {
        Proof::NotProved { why } => why.clone(),
        proved => panic!("{proved:?}: {text}"),
    }
}

fn campaign(text: &str) -> Campaign {
    let (spec, plant) = support::design(text);
    let read = verify::read(&support::entries(text), &spec, &plant);
    read.unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"))
}

/// Numbers that look drawn, the same in each run.
struct Drawn(u64);

impl Drawn {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as f64 / f64::from(1u32 << 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// A mapping: its words, and kappa with three derivatives by dt/tau at T/tau = w.
type Kappa = (String, fn(f64, f64) -> [f64; 4]);

fn of_mu(t: f64, m1: f64, m2: f64, m3: f64) -> [f64; 4] {
    [t, 1.0 / m1, -m2 / m1.powi(3), 3.0 * m2 * m2 / m1.powi(5) - m3 / m1.powi(4)]
}

fn root(c: impl Fn(f64) -> f64, w: f64) -> f64 {
    let (mut low, mut high) = (0.0, 100.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if c(middle) > w { low = middle } else { high = middle }
    }
    low
}

/// All of them of rate `a`.
fn mappings(a: f64) -> Vec<Kappa> {
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
fn law(drawn: &mut Drawn, n: usize) -> (Vec<f64>, String) {
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
fn transition(gains: &[f64], kappa: &Kappa, a: f64, w: f64) -> DMatrix<f64> {
    let n = gains.len();
    let companion = DMatrix::from_fn(n, n, |i, j| match () {
        () if i + 1 == n => -gains[j],
        () => f64::from(u8::from(j == i + 1)),
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
fn in_units(mut rows: DMatrix<f64>, tau: f64, g: f64) -> DMatrix<f64> {
    let n = rows.ncols();
    for i in 0..=n {
        for c in 0..n {
            rows[(i, c)] *= tau.powf(c as f64 - i as f64) / if i == n { g } else { 1.0 };
        }
    }
    rows
}

/// Greatest values over the run: |u|, x1 + x2 (or x1), |x|/|x0|, and |x| at its end.
fn peaks(runs: &[Vec<DMatrix<f64>>], corners: &[DVector<f64>]) -> [f64; 4] {
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

fn corners(size: &[f64]) -> Vec<DVector<f64>> {
    let n = size.len();
    let sign = |corner: usize, j: usize| if corner >> j & 1 == 1 { 1.0 } else { -1.0 };
    (0..1 << n).map(|c| DVector::from_fn(n, |j, _| sign(c, j) * size[j])).collect()
}

#[test]
fn what_is_proved_is_what_dense_samples_show() {
    let mut drawn = Drawn(4);
    for round in 0..18 {
        let n = 1 + round % 3;
        let a = (8.0 * drawn.between(0.5, 1.2)).round() / 8.0;
        let kappa = &mappings(a)[(round / 3 + round) % 9];
        // To where e^(At) still has digits in doubles.
        let until = [0.02, 0.1, 0.3].into_iter().find(|w| (kappa.1)(*w, a)[0] < 8.0).expect("one");
        let (gains, words) = law(&mut drawn, n);
        let g = 0.5;
        let size: Vec<_> = (0..n).map(|_| (4.0 * drawn.between(0.25, 2.0)).round() / 4.0).collect();
        let shares = (0..800).map(|i| until_share(until, i, 799));
        let runs: Vec<_> = shares.map(|w| transition(&gains, kappa, a, w)).collect();
        let of = |tau: f64| -> Vec<_> {
            runs.iter().map(|rows| in_units(rows.clone(), tau, g)).collect()
        };
        let runs: Vec<_> = [0.75, 0.8, 1.0, 1.2, 1.25].map(of).into();
        let peaks = peaks(&runs, &corners(&size));
        let h = if n > 1 { "x1 + x2" } else { "x1" };
        let mut text =
            format!("n = {n}\n{}\ng = {g}\n{words}\n[params]\n[plant]\nf = 0\n[verify]\n", kappa.0);
        text.push_str(&format!("tau = [0.75, 1.25]\nuntil = {until}\n"));
        (1..).zip(&size).for_each(|(j, s)| text.push_str(&format!("x{j} = [-{s}, {s}]\n")));
        for factor in [1.1, 0.98] {
            let [u, h_most, sigma, error] = peaks.map(|peak| factor * peak);
            text.push_str(&format!("[[objective]]\nbound = \"input\"\nupsilon = {u}\n"));
            text.push_str(&format!(
                "[[objective]]\nbound = \"within\"\nh = \"{h}\"\nhigh = {h_most}\n"
            ));
            text.push_str(&format!("[[objective]]\nbound = \"state\"\nsigma = {sigma}\n"));
            text.push_str(&format!("[[objective]]\nbound = \"attractive\"\nerror = {error}\n"));
        }
        let found = proved(&text);
        let expected = [[true; 4], [false; 4]].concat();
        assert_eq!(found, expected, "round {round}, peaks {peaks:?}\n{text}");
        // A bound of u stands before all.
        if round % 4 > 0 {
            continue;
        }
        for (factor, expected) in [(1.1, &[true, true, true, true][..]), (0.98, &[false; 4])] {
            let bounded =
                text.replace("[params]\n", &format!("[params]\nu_max = {}\n", factor * peaks[0]));
            let found = proved(&bounded);
            assert_eq!(&found[..4], expected, "round {round}, u_max\n{bounded}");
        }
    }
}

#[test]
fn a_disturbance_is_held_against_its_worst_signal() {
    let mut drawn = Drawn(9);
    for round in 0..6 {
        let n = 1 + round % 3;
        let kappa = &mappings(0.75)[[0, 4, 6, 1, 0, 8][round]];
        let until = [0.05, 0.3].into_iter().find(|w| (kappa.1)(*w, 0.75)[0] < 5.0).expect("one");
        let (gains, words) = law(&mut drawn, n);
        let (tau, g, share) = (1.5, 2.0, 0.5);
        // f is between -0.7 and 1.3 times it, in the middle of which the loop is driven too.
        let (middle, most) = (0.3 * share, share);
        let count = 300;
        let shares: Vec<_> = (0..=count).map(|i| until_share(until, i, count)).collect();
        let rows: Vec<_> =
            shares.iter().map(|w| in_units(transition(&gains, kappa, 0.75, *w), tau, g)).collect();
        let last = DVector::from_fn(n, |i, _| f64::from(u8::from(i + 1 == n)));
        let back = |rows: &DMatrix<f64>| {
            let states = rows.view((0, 0), (n, n)).clone_owned();
            states.try_inverse().expect("an inverse") * &last
        };
        let back: Vec<_> = rows.iter().map(back).collect();
        let mut peaks = [0.0_f64; 4];
        for (at, rows) in rows.iter().enumerate() {
            // The worst f turns with the kernel of what it acts on: x_1, or u. A constant one does not.
            for (k, i) in [0, n].into_iter().enumerate() {
                let kernel = |k: usize| (rows * &back[k])[i];
                let area = |f: fn(f64) -> f64| -> f64 {
                    let mean = |k: usize| 0.5 * (f(kernel(k)) + f(kernel(k + 1)));
                    (0..at).map(|k| mean(k) * tau * (shares[k] - shares[k + 1])).sum()
                };
                let (signed, size) = (area(|x| x), area(f64::abs));
                // From x0 = (1, 0, ...).
                let alone = rows[(i, 0)] + middle * signed;
                peaks[k] = peaks[k].max(alone.abs() + most * size);
                peaks[k + 2] = peaks[k + 2].max(alone.abs() + most * signed.abs());
            }
        }
        let design = |signal: &str, more: &str| {
            let zeros: String = (2..=n).map(|j| format!("x{j} = 0\n")).collect();
            format!(
                "n = {n}\n{}\ng = {g}\n{words}\n[params]\ntau = {tau}\n[plant]\nf = \"{share}*d\"\n\
                 d = [-0.7, 1.3]\n[disturbance]\nd = \"{signal}\"\n[verify]\nuntil = {until}\nx1 = 1\n{zeros}{more}",
                kappa.0
            )
        };
        for (signal, peaks) in [("any", &peaks[..2]), ("constant", &peaks[2..])] {
            let mut objectives = String::new();
            for factor in [1.05, 0.98] {
                let [x, u] = [0, 1].map(|k| factor * peaks[k]);
                objectives.push_str(&format!(
                    "[[objective]]\nbound = \"within\"\nh = \"x1\"\nlow = -{x}\nhigh = {x}\n\
                     [[objective]]\nbound = \"input\"\nupsilon = {u}\n"
                ));
            }
            let text = design(signal, &objectives);
            let found = proved(&text);
            assert_eq!(found, [true, true, false, false], "round {round}, {peaks:?}\n{text}");
        }
    }
}

/// With n = 1 and pole -2, f = 1 makes x the integral of e^(-2 s) mu'(t - s), which is mu'/2 (1 + d/2 +
/// ...) with the decay d = -mu''/mu' of mu', where the stretched time t is long.
#[test]
fn a_disturbance_is_followed_through_thousands_of_time_constants() {
    let c = std::f64::consts::FRAC_PI_2;
    let w = 1e-3_f64;
    for (mapping, slope, decay) in [
        ("rational(a=1)", w * w, 2.0 * w),
        ("power(a=1,m=2)", w.powi(3), 3.0 * w * w),
        ("tan(a=1)", (c * w).sin().powi(2) / c, (2.0 * c * w).sin()),
    ] {
        let x = 0.5 * slope * (1.0 + 0.5 * decay);
        let text = |tau: &str| {
            format!(
                "n = 1\nmu = \"{mapping}\"\npoles = [-2]\n[plant]\nf = \"d\"\nd = [-1, 1]\n\
                 [disturbance]\nd = \"any\"\n[verify]\nuntil = {w}\ntau = {tau}\nx1 = [-1, 1]\n\
                 [[objective]]\nbound = \"attractive\"\nerror = {}\n\
                 [[objective]]\nbound = \"attractive\"\nerror = {}\n",
                1.001 * x,
                0.999 * x
            )
        };
        assert_eq!(proved(&text("1")), [true, false], "{mapping}");
        // x is as long as tau.
        assert_eq!(proved(&text("[0.5, 1]")), [true, false], "{mapping}");
    }
}

/// T/tau from 1 to `until`, even in its logarithm.
fn until_share(until: f64, i: u32, last: u32) -> f64 {
    until.powf(f64::from(i) / f64::from(last))
}

/// u is 3 - 6T and 1 - 3T from (1, 0) and (0, 1): at most 5 - dt in size together.
#[test]
fn bounds_in_t_begin_at_t0() {
    let of = |upsilon: &str| {
        let text = format!(
            "n = 2\nmu = \"exp(a=1)\"\ng = 2\npoles = [-2, -3]\n[params]\ntau = 1\nt0 = 10\n\
             [plant]\nf = 0\n[verify]\nx1 = [-1, 1]\nx2 = [-1, 1]\n\
             [[objective]]\nbound = \"input\"\nupsilon = \"{upsilon}\"\n"
        );
        proved(&text)
    };
    assert_eq!(of("15.001 - t"), [true]);
    assert_eq!(of("5.001 - (t - t0)"), [true]);
    assert_eq!(of("5.001 - t"), [false]);
    assert_eq!(of("14.99 - t"), [false]);
}

/// The loop of which x1 = x1_0 (5 T^4 - 4 T^5) and x2 = x1_0 (-20 T^3 + 20 T^4), so that x2 = -2.109375
/// at T = 3/4, its least.
fn of_two(objectives: &str) -> String {
    format!(
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 1\n[plant]\nf = 0\n[verify]\n\
         x1 = [-1, 1]\nx2 = 0\n{objectives}"
    )
}

fn within(h: &str, bounds: &str) -> String {
    of_two(&format!("[[objective]]\nbound = \"within\"\nh = \"{h}\"\n{bounds}"))
}

#[test]
fn what_jumps_or_has_no_value_is_not_proved() {
    for h in [
        "sign(-2.1093745 - x2)",
        "sqrt(x2 + 2.1093745)",
        "sqrt(x2 + 2.1093745)^2",
        "ln(x2 + 2.1093745)",
        "exp(ln(x2 + 2.1093745))",
        "(x2 + 2.1093745)^0.5",
        "(x2 + 2.1093745)^1.5",
        "(x2 + 2.1093745)^pi",
        "0.1*atan(1/(x2 + 2.109375))",
        "(x2 + 2)/(x2 + 2)",
        "(x2 + 2)^2*(x2 + 2)^(-2)",
        "x2*ln(x2 + 2.1093745)/ln(x2 + 2.1093745)",
        "0*x1 + x2 - x2 + atanh(x2/2.1093745)/1e9",
        "tan(x2)/1e9",
        "1/x2",
        "max(0, sqrt(x2 + 2.1093745))",
        "min(0, ln(x2 + 2.1093745))",
        "atan(1/x1)",
        "exp(-1/x1^2)",
        "x1^(-2) - x1^(-2)",
        "abs(x2 + 2.1093745)/(x2 + 2.1093745)",
        "max(x2, -2.1093745)/(x2 + 2.1093745) - 1",
        "tanh(1/(x1 - 0.5))",
        "0*ln(0.9 - x1)",
        "ln(0.9 - x1)*0",
        "ln(0.9 - x1)^0",
        "-(0*x2)*sqrt(0.9 - x1)",
        "(0*sqrt(0.9 - x1))^0",
        "min(0, 0*sqrt(0.9 - x1))",
        "mean(1, 0*ln(0.9 - x1))",
        "atanh(x1/0.9)*0",
        "0*(1/x1)",
        "(x1/x1)^(1 - 1)",
        "0*tan(2*x1)",
        "0/(x1 - 0.5)",
        "0*x1^(-1)",
        "0*(0.9 - x1)^x2",
        "exp(0*ln(0.9 - x1)) - 1",
    ] {
        let text = within(h, "high = 2.5");
        if h.starts_with("sign") {
            assert_eq!(proved(&within(h, "high = 0.5")), [false], "{h}");
        } else {
            assert_eq!(proved(&text), [false], "{h}");
        }
    }
    // The same functions where they exist.
    for (h, high) in [
        ("sign(-2.2 - x2)", 0.5),
        ("sqrt(x2 + 2.2)", 2.2),
        ("sqrt(x2 + 2.2)^2", 4.6),
        ("ln(x2 + 2.2)", 1.5),
        ("(x2 + 2.2)^1.5", 9.5),
        ("1/(x2 + 2.2)", 12.0),
        ("(x2 + 2.2)/(x2 + 2.2)", 1.001),
        ("tan(x2/2)", 2.0),
        ("atanh(x2/2.2)", 2.0),
        ("abs(x1 + x2)", 1.7),
        ("max(x1, x2)", 2.2),
        ("exp(-x2)", 8.5),
        ("x1^2", 1.01),
        ("x2^2/x1_0^2*x1_0^2 - 1", 3.6),
        ("0*ln(1.1 - x1)", 0.001),
        ("sqrt(1.1 - x1)^0", 1.001),
        ("0*abs(x2) + (x1 - x2)^0", 1.001),
    ] {
        let expected = !h.contains("x1_0");
        assert_eq!(proved(&within(h, &format!("high = {high}"))), [expected], "{h}");
    }
    for bound in ["sqrt(T/tau - 0.5)", "ln(dt)", "1/(T - 0.5*tau)", "(t - 0.5)^0.5", "tan(3*dt)"] {
        for (kind, rest) in [("input", "upsilon"), ("state", "sigma = 1e9\nzeta")] {
            let text = format!("[[objective]]\nbound = \"{kind}\"\n{rest} = \"1e9 + {bound}\"\n");
            assert_eq!(proved(&of_two(&text)), [false], "{kind} {bound}");
        }
        assert_eq!(proved(&within("x1", &format!("high = \"1e9 + {bound}\""))), [false], "{bound}");
        assert_eq!(proved(&within("x1", &format!("low = \"{bound} - 1e9\""))), [false], "{bound}");
    }
    // What is multiplied by 0 has to exist too.
    for bound in ["0*ln(dt)", "ln(T - 0.5)^0", "0*sqrt(T/tau - 0.5)"] {
        for (kind, rest) in [("input", "upsilon"), ("state", "sigma = 1e9\nzeta")] {
            let text = format!("[[objective]]\nbound = \"{kind}\"\n{rest} = \"1e9 + {bound}\"\n");
            assert_eq!(proved(&of_two(&text)), [false], "{kind} {bound}");
        }
    }
    let least = within("x2", "low = \"-3 + sqrt(dt) + 0*ln(t + 1)\"");
    assert_eq!(proved(&least), [true], "{}", why(&least));
    let text = within("sqrt(x2 + 2.1093745)", "high = 2.5");
    assert!(why(&text).contains(") may have no value at T/tau = 0.7"), "{}", why(&text));
}

/// A sample at which a value or a bound is no number fails, whatever stands around it.
#[test]
fn what_has_no_value_fails_a_sample() {
    for (h, bounds) in [
        ("max(0, sqrt(x2 + 2))", "high = 9"),
        ("min(1, ln(x2 + 2))", "high = 9"),
        ("atan(1/(x1 - x1))", "high = 9"),
        ("sqrt(x2 + 2)^2", "high = 9"),
        ("0*sqrt(x2 + 2)", "high = 9"),
        ("ln(x2 + 2)^0", "high = 9"),
        ("x1", "low = \"ln(-1 - dt)\"\nhigh = 9"),
        ("x1", "low = -9\nhigh = \"max(9, sqrt(T - 0.5))\""),
    ] {
        let campaign = campaign(&within(h, bounds));
        let mut trial = Trial::new(&campaign).expect("a trial");
        // Scenario 0 is a corner of the box.
        let outcome = trial.run(&campaign.setting(&campaign.scenario(0)));
        let failed = outcome.excess[0] == f64::INFINITY;
        let from_one = campaign.setting(&campaign.scenario(0)).x0[0] == 1.0;
        assert!(failed || !from_one && h.contains("x2"), "{h} {bounds}: {outcome:?}");
    }
}

#[test]
fn the_same_bound_has_the_same_verdict_in_every_spelling() {
    for (zeta, expected) in [("T/tau", false), ("sqrt(T/tau)", true)] {
        for share in
            ["T/tau", "(1 - dt/tau)", "(tau - dt)/tau", "(1 - (t - t0)/tau)", "(t0 + tau - t)/tau"]
        {
            let zeta = zeta.replace("T/tau", share);
            let text = of_two(&format!(
                "[[objective]]\nbound = \"state\"\nsigma = 3\nzeta = \"{zeta}\"\n"
            ));
            let several = text
                .replace("[params]\ntau = 1\n", "[params]\n")
                .replace("x2 = 0\n", "x2 = 0\ntau = [0.9, 1.1]\n");
            assert_eq!(proved(&text), [expected], "{zeta}");
            assert_eq!(proved(&several), [expected], "{zeta}, several tau");
        }
    }
    for h in [
        "x1 + x2",
        "x2 - (-x1)",
        "2*(x1/2 + x2/2)",
        "(x1 + x2)^2 - (x1 + x2)^2 + x1 + x2",
        "(x1 + x2)*T/tau + dt/tau*(x2 + x1)",
    ] {
        assert_eq!(proved(&within(h, "high = 1.65")), [true], "{h}");
        assert_eq!(proved(&within(h, "high = 1.5")), [false], "{h}");
    }
    assert_eq!(proved(&within("(x1^2 - x2^2)/(x1 - x2)", "high = 9")), [false], "it divides by 0");
}

#[test]
fn what_is_not_proved_says_why() {
    let with = |from: &str, to: &str| {
        why(&of_two("[[objective]]\nbound = \"input\"\nupsilon = 100\n").replace(from, to))
    };
    let u_max = "[params]\nu_max = 1\n";
    for (from, to, expected) in [
        ("poles = [-4, -5]", "pi0 = \"-20*xi1 - 9*xi2 - xi1^3\"", "pi0 is not a sum of gains"),
        ("f = 0", "f = \"x2\"", "f = x2 is not a sum of bounded symbols"),
        ("f = 0", "f = \"0*sqrt(x1)\"", "f = 0*sqrt(x1) is not a sum of bounded symbols"),
        ("f = 0", "f = 0\ng = \"1 + 0*ln(x1)\"", "the plant's g = 1 + 0*ln(x1) is not the number"),
        ("f = 0", "f = 0\ng = 2", "the plant's g = 2 is not the number"),
        ("upsilon = 100", "upsilon = 19", "no room is left at T/tau = "),
        ("upsilon = 100", "upsilon = \"100 + ln(T - 0.5)\"", "may have no value at T/tau = "),
        ("[params]\n", u_max, "u may be clipped by u_max: no room is left"),
    ] {
        let why = with(from, to);
        assert!(why.contains(expected), "{to}: {why}");
    }
}

#[test]
fn a_proof_is_about_the_emitted_program() {
    let of = |precision: &str, upsilon: &str| {
        let text = of_two(&format!("[[objective]]\nbound = \"input\"\nupsilon = {upsilon}\n"));
        format!("precision = \"{precision}\"\n{text}")
    };
    // |u| is 20 at t0, which f32 rounds by some 1e-6.
    assert_eq!(proved(&of("f64", "20.000002")), [true]);
    assert_eq!(proved(&of("f32", "20.000002")), [false]);
    assert_eq!(proved(&of("f32", "20.1")), [true]);
    for (precision, least, most) in [("f32", 1e-7, 1e-3), ("f64", 1e-16, 1e-12)] {
        let found = &verify::bound::proved(&campaign(&of(precision, "21")))[0];
        let Proof::Proved { scope } = found else { panic!("{found:?}") };
        let words: Vec<_> = scope.split(' ').collect();
        let number = words.iter().position(|word| *word == "within").expect("a bound") + 1;
        let error: f64 = words[number].parse().expect("a number");
        assert!(
            scope
                .contains(&format!("the emitted {precision} program stays in range there, within"))
        );
        assert!((least..most).contains(&error), "{scope}");
    }
    // K/T^4 is beyond f32 throughout.
    let fast = |precision: &str| {
        format!(
            "n = 4\nprecision = \"{precision}\"\nmu = \"exp(a=1)\"\npoles = [-5, -6, -7, -8]\n[params]\n\
             tau = 1e-9\n[plant]\nf = 0\n[verify]\nx1 = [-1, 1]\nx2 = 0\nx3 = 0\nx4 = 0\n\
             [[objective]]\nbound = \"within\"\nh = \"x1\"\nhigh = 2\n"
        )
    };
    assert_eq!(proved(&fast("f64")), [true]);
    assert!(why(&fast("f32")).contains("may leave the range of f32"), "{}", why(&fast("f32")));
    let iterated = of("f64", "1e3").replace("exp(a=1)", "exp_sum(rates=[1, 2])");
    let found = &verify::bound::proved(&campaign(&iterated))[0];
    let Proof::Proved { scope } = found else { panic!("{found:?}") };
    assert!(scope.contains("the rounding of its iteration is not included"), "{scope}");
}

#[test]
fn a_mapping_that_is_written_out_is_proved_as_its_family_is() {
    for (mapping, family, a) in [
        ("kappa = \"tan(pi/2*dt/tau)/0.44\"", "tan", "0.44"),
        ("mu = \"2*tau/pi*atan(2.12*t)\"", "tan", "2.12"),
        ("mu = \"tau*0.81*t/sqrt(1 + (0.81*t)^2)\"", "algebraic", "0.81"),
    ] {
        for (tau, t0, precision) in
            [("tau = 1.52", 0.0, "f64"), ("tau = 2.3", 7.7, "f32"), ("tau = 2.3", -0.6, "f64")]
        {
            let of = |mapping: &str| {
                format!(
                    "n = 3\n{mapping}\nprecision = \"{precision}\"\npoles = [-2, -3, -4]\n[params]\n\
                     {tau}\nt0 = {t0}\n[plant]\nf = 0\n[verify]\nuntil = 0.05\nx1 = [-0.8, 0.8]\nx2 = 0\n\
                     x3 = [-1.2, 1.2]\n[[objective]]\nbound = \"state\"\nsigma = 100\n"
                )
            };
            for text in [of(&format!("mu = \"{family}(a={a})\"")), of(mapping)] {
                let found = verify::bound::proved(&campaign(&text));
                assert!(found[0].is_proved(), "{found:?}\n{text}");
            }
        }
    }
}

#[test]
fn a_stretched_time_that_is_iterated_is_bounded_from_t0_on() {
    for (mapping, precision) in [
        ("mu = \"tau*(1 - (exp(-1.95*t) + exp(-0.76*t))/2)\"", "f32"),
        ("mu = \"tau*(1 - exp(-t)/(1 + t))\"", "f64"),
        ("mu = \"tau*(1 - (1 + 1.73*3*t)^(-1/3))\"", "f64"),
    ] {
        let text = format!(
            "n = 1\n{mapping}\nprecision = \"{precision}\"\npoles = [-2]\n[params]\ntau = 6.2\n\
             [plant]\nf = 0\n[verify]\nuntil = 0.1\nx1 = [-0.8, 0.8]\n\
             [[objective]]\nbound = \"state\"\nsigma = 1.05\n"
        );
        let found = verify::bound::proved(&campaign(&text));
        assert!(found[0].is_proved(), "{found:?}\n{text}");
    }
}
