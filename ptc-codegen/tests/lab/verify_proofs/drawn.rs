//! Bounds just above and just below the greatest values of random loops.

use nalgebra::{DMatrix, DVector};

use super::loops::*;
use super::proved;

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
        // A bound of u comes first.
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
