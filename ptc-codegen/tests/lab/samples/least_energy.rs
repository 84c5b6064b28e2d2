//! Laws of least energy, and the ends of other laws.

use num_traits::{ToPrimitive, Zero};
use ptc_codegen::algebra::BigRational;
use ptc_codegen::code::{Code, Instance};

use super::{GAIN, code, read};

fn whole(value: u32) -> BigRational {
    BigRational::from_integer(value.into())
}

fn power(value: &BigRational, exponent: usize) -> BigRational {
    (0..exponent).fold(whole(1), |product, _| product * value)
}

fn factorial(n: usize) -> BigRational {
    (1..=n).fold(whole(1), |product, i| product * BigRational::from_integer(i.into()))
}

/// The effect on the chain at the end of an input that acts for a period with `left` samples to go, which is
/// Phi^(left-1) Gamma.
fn effect(n: usize, left: u32, h: &BigRational) -> Vec<BigRational> {
    let [begin, end] = [left, left - 1].map(|count| whole(count) * h);
    let entry = |i: usize| {
        let order = n - i;
        (power(&begin, order) - power(&end, order)) / factorial(order)
    };
    (0..n).map(entry).collect()
}

/// Solves a system of equations whose matrix is regular, by elimination.
fn solution(mut rows: Vec<Vec<BigRational>>) -> Vec<BigRational> {
    let n = rows.len();
    for column in 0..n {
        let pivot = (column..n).find(|row| !rows[*row][column].is_zero()).expect("regular");
        rows.swap(column, pivot);
        let first = rows[column].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != column {
                let factor = &row[column] / &first[column];
                row.iter_mut().zip(&first).for_each(|(own, value)| *own -= &factor * value);
            }
        }
    }
    (0..n).map(|i| &rows[i][n] / &rows[i][i]).collect()
}

/// The first input of the sequence that brings x to 0 in `left` samples with the least sum of u^2/w, w = M (M + 1) ..
/// (M + weight - 1): w_M B' W^-1 (-Phi^M x) with the Gramian W = sum of w B B' over the effects B.
pub(super) fn least(x: &[BigRational], left: u32, weight: u32, h: &BigRational) -> BigRational {
    let n = x.len();
    let rising = |left: u32| (0..weight).fold(whole(1), |product, i| product * whole(left + i));
    let mut rows = vec![vec![whole(0); n + 1]; n];
    for m in 1..=left {
        let own = effect(n, m, h);
        for (row, a) in rows.iter_mut().zip(&own) {
            row.iter_mut().zip(&own).for_each(|(sum, b)| *sum += rising(m) * a * b);
        }
    }
    let time = whole(left) * h;
    for (i, row) in rows.iter_mut().enumerate() {
        let drift = (i..n).map(|j| power(&time, j - i) / factorial(j - i) * &x[j]);
        row[n] = -drift.fold(whole(0), |sum, term| sum + term);
    }
    let costate = solution(rows);
    let product = effect(n, left, h).iter().zip(&costate).map(|(a, b)| a * b).sum::<BigRational>();
    rising(left) * product
}

fn law(n: usize, more: &[(&str, &str)]) -> Code {
    let n = n.to_string();
    let mut keys = vec![("n", n.as_str()), ("tau", "40/64"), ("sample_time", "1/64"), ("eps", "0")];
    keys.retain(|(key, _)| !more.iter().any(|(own, _)| own == key));
    keys.extend(more);
    code(&keys)
}

/// u of the states with one entry of 1, with `left` samples of 40 to go.
fn gains(code: &Code, n: usize, left: u32) -> Vec<f64> {
    let mut controller = Instance::new(code, &[]).expect("legal parameters");
    let mut gain = |j: usize| {
        let x: Vec<_> = (0..n).map(|i| f64::from(u8::from(i == j))).collect();
        controller.call("step", &[("k", &[f64::from(40 - left)]), ("x", &x)]).results["u"][0]
    };
    (0..n).map(&mut gain).collect()
}

/// The Gramian of the chain gives the same inputs as the rows of Theorem 1.
#[test]
fn inputs_are_those_of_the_gramian() {
    let h = BigRational::new(1.into(), 64.into());
    for n in 1..=4_usize {
        for weight in [0, 1, 2, 3] {
            let poles = format!("least-energy(weight={weight})");
            let code = law(n, &[("poles", &poles)]);
            for left in [n as u32, n as u32 + 1, 11, 40] {
                for (j, found) in gains(&code, n, left).into_iter().enumerate() {
                    let x: Vec<_> = (0..n).map(|i| whole(u32::from(i == j))).collect();
                    let wanted = least(&x, left, weight, &h).to_f64().expect("a double");
                    assert!(
                        (found / wanted - 1.0).abs() < GAIN,
                        "n = {n}, weight {weight}, {left} to go, x{}: {found}, not {wanted}",
                        j + 1
                    );
                }
            }
        }
    }
}

/// The poles are those of a list, whatever the rate.
#[test]
fn name_stands_for_its_poles() {
    for (name, a, poles) in [
        ("least-energy", "1", "-2,-3"),
        ("least-energy(2)", "1", "-4,-5"),
        ("least-energy(weight=1)", "3/2", "-4.5,-6"),
    ] {
        let mu = format!("exp(a={a})");
        let [named, listed] = [name, poles].map(|poles| law(2, &[("poles", poles), ("mu", &mu)]));
        assert_eq!(named.functions, listed.functions, "{name}");
    }
}

/// From `end_samples` on the gains are those of the other poles, and before those of its own.
#[test]
fn poles_of_the_end_take_over() {
    let both =
        [("poles", "least-energy"), ("poles_end", "least-energy(weight=1)"), ("end_samples", "15")];
    let (both, listed) = (law(3, &both), law(3, &[both[0], ("poles_end", "-4,-5,-6"), both[2]]));
    assert_eq!(both.functions, listed.functions);
    let [first, last] = ["-3,-4,-5", "-4,-5,-6"].map(|poles| law(3, &[("poles", poles)]));
    for (left, own) in [(40, &first), (16, &first), (15, &last), (3, &last), (1, &last)] {
        assert_eq!(gains(&both, 3, left), gains(own, 3, left), "{left} samples to go");
    }
}

/// u from x = (1, 0, ...) in the loop with the chain, in doubles.
fn run(code: &Code, n: usize) -> Vec<f64> {
    let mut controller = Instance::new(code, &[]).expect("legal parameters");
    let mut x = vec![0.0; n];
    x[0] = 1.0;
    let h: f64 = 1.0 / 64.0;
    let mut step = |k: u32| {
        let u = controller.call("step", &[("k", &[f64::from(k)]), ("x", &x)]).results["u"][0];
        for i in 0..n {
            let (mut sum, mut share) = (0.0, 1.0);
            for (power, value) in (1..).zip(x[i..].iter().copied().chain([u])) {
                sum += value * share;
                share *= h / f64::from(power);
            }
            x[i] = sum;
        }
        u.abs()
    };
    (0..40).map(&mut step).collect()
}

/// Poles that do not end at rest by themselves get an end that takes no more u than the law before it.
#[test]
fn default_end_does_not_raise_the_peak() {
    for (n, poles) in
        [(2, "-2,-4"), (2, "-2,-30"), (2, "-2.2,-3.7"), (3, "-4,-5,-9"), (4, "-4,-5,-6,-8")]
    {
        let u = run(&law(n, &[("poles", poles)]), n);
        let end = poles.split(',').filter_map(|p| p[1..].parse::<f64>().ok()).fold(0.0, f64::max);
        let from = (end.ceil() as usize + n - 1).max(2 * n);
        let [before, after] =
            [&u[..40 - from], &u[40 - from..]].map(|u| u.iter().copied().fold(0.0, f64::max));
        assert!(after <= before, "{poles}: {after} from {from} samples to go on, {before} before");
    }
}

#[test]
fn mistakes_of_least_energy_are_named() {
    let stage = [
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("clock", "samples"),
        ("sample_time", "0.01"),
        ("tau", "1"),
    ];
    let cases: [(&[(&str, &str)], &str); 11] = [
        (&[("poles", "least-energy(w=1)")], "an integer W from 0 to 1000"),
        (&[("poles", "least-energy(weight=1.5)")], "not the weight of least energy"),
        (&[("poles", "least-energy(1, 2)")], "not the weight of least energy"),
        (&[("poles", "most-energy")], "poles"),
        (&[("poles", "least-energy"), ("mu", "exp")], "mu = exp with a number for a"),
        (&[("poles", "-3,-4"), ("poles_end", "-2,-3")], "belong together"),
        (&[("poles", "-3,-4"), ("end_samples", "9")], "belong together"),
        (
            &[("poles", "-3,-4"), ("poles_end", "-2,-4"), ("end_samples", "9")],
            "not those of least energy",
        ),
        (
            &[("poles", "-3,-4"), ("poles_end", "-1,-2"), ("end_samples", "9")],
            "not those of least energy",
        ),
        (&[("poles", "-3,-4"), ("poles_end", "-2,-3"), ("end_samples", "1")], "at least 2"),
        (
            &[("poles", "-3,-4"), ("poles_end", "-2,-3"), ("end_samples", "9"), ("deadbeat", "5")],
            "two ends",
        ),
    ];
    for (more, wanted) in cases {
        let mut keys: Vec<_> = stage.to_vec();
        keys.retain(|(key, _)| !more.iter().any(|(own, _)| own == key));
        keys.extend(more);
        let found = read(&keys).expect_err(&format!("{more:?}"));
        assert!(found.contains(wanted), "{more:?}: {found}");
    }
    let open = [&stage[..], &[("poles_end", "-2,-3"), ("end_samples", "9")]].concat();
    assert!(read(&open).expect_err("open gains").contains("left to run time"));
    let plant = [&stage[1..], &[("A", "[[0, 1], [0, -1]]"), ("B", "[0, 1]")]].concat();
    let weighted = [&plant[..], &[("poles", "least-energy(weight=101)")]].concat();
    assert!(read(&weighted).expect_err("a weight").contains("at most 100"));
}

/// Outputs of several orders have the poles of theirs.
#[test]
fn outputs_of_other_orders_have_their_own_poles() {
    let model = "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\n[params]\ntau = 1\n[model]\n\
                 states = [\"p\", \"q\", \"v\"]\ninputs = [\"a\", \"b\"]\noutputs = [\"p\", \"q\"]\n\
                 dynamics = { p = \"a + q\", q = \"v\", v = \"b - p\" }\n";
    let spec = |poles: &str| crate::support::spec(&format!("poles = {poles}\n{model}"));
    let [named, listed] = ["\"least-energy(weight=1)\"", "[[-2], [-3, -4]]"].map(spec);
    assert_eq!(named.fingerprint(), listed.fingerprint());
}
