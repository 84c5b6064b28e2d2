//! Chains of high order and wide models, whose derivatives are long as expressions.

use std::time::{Duration, Instant};

use super::{folder_with, run_in, spec};

/// z_i' = z_(i+1) + 0.3 sin(z_i) z_1 with u in the last rate.
fn design(r: usize) -> String {
    let next = |i: usize| if i == r { "u".to_owned() } else { format!("z{}", i + 1) };
    let rates = (1..=r).map(|i| format!("z{i} = \"{} + 0.3*sin(z{i})*z1\"", next(i)));
    let names: Vec<_> = (1..=r).map(|i| format!("\"z{i}\"")).collect();
    format!(
        "{}[model]\nstates = [{}]\ninput = \"u\"\noutput = \"z1\"\ndynamics = {{ {} }}\n",
        head(r),
        names.join(", "),
        rates.collect::<Vec<_>>().join(", "),
    )
}

/// A long duration, with which the law wants little beside what moves the chain.
fn head(r: usize) -> String {
    let poles: Vec<_> = (1..=r).map(|i| format!("-{}", r + i)).collect();
    format!(
        "name = \"chain\"\nmu = \"exp(a=1)\"\npoles = [{}]\n[params]\ntau = 100\nt0 = 0\neps = 1\nu_max = inf\n",
        poles.join(", ")
    )
}

/// The derivatives of z_1 along the chain with u = 0, from its Taylor series.
fn derivatives(state: &[f64]) -> Vec<f64> {
    let r = state.len();
    let mut z: Vec<Vec<f64>> = state.iter().map(|z| vec![*z]).collect();
    let mut sine: Vec<_> = state.iter().map(|z| vec![z.sin()]).collect();
    let mut cosine: Vec<_> = state.iter().map(|z| vec![z.cos()]).collect();
    for k in 0..r {
        let product: Vec<f64> =
            (0..r).map(|i| (0..=k).map(|j| sine[i][j] * z[0][k - j]).sum()).collect();
        for i in 0..r {
            let next = if i + 1 < r { z[i + 1][k] } else { 0.0 };
            z[i].push((next + 0.3 * product[i]) / (k + 1) as f64);
        }
        for i in 0..r {
            // s' = c z', c' = -s z'.
            let of = |with: &[f64]| {
                let terms = (1..=k + 1).map(|j| j as f64 * z[i][j] * with[k + 1 - j]);
                terms.sum::<f64>() / (k + 1) as f64
            };
            let (s, c) = (of(&cosine[i]), -of(&sine[i]));
            sine[i].push(s);
            cosine[i].push(c);
        }
    }
    let mut factorial = 1.0;
    (0..=r)
        .map(|k| {
            factorial *= k.max(1) as f64;
            factorial * z[0][k]
        })
        .collect()
}

/// u at the start of a run from a state.
fn at_start(test: &str, design: &str, x: &[f64]) -> f64 {
    let folder = folder_with(&format!("long_chains_{test}"), "plant.toml", design);
    let at: Vec<_> = x.iter().map(ToString::to_string).collect();
    let x0 = format!("--x0={}", at.join(","));
    let (code, csv, stderr) = run_in(&folder, &["simulate", "plant.toml", &x0, "--at", "0"]);
    assert_eq!(code, Some(0), "{stderr}");
    let last = csv.trim_end().rsplit(',').next().expect("u");
    last.parse().expect("a number")
}

#[test]
fn input_of_a_long_chain_follows_from_its_taylor_series() {
    for r in [8, 12, 16] {
        let z: Vec<f64> = (0..r).map(|i| 0.5 * f64::cos(1.7 * i as f64)).collect();
        let x = derivatives(&z);
        let (x, drift) = x.split_at(r);
        let chain = head(r).replace("name", &format!("n = {r}\nname"));
        let law = at_start(&format!("law{r}"), &chain, x);
        let wanted = law - drift[0];
        let found = at_start(&format!("model{r}"), &design(r), &z);
        assert!(law.abs() < drift[0].abs(), "{r}: {law} beside {}", drift[0]);
        assert!((found - wanted).abs() < 1e-11 * drift[0].abs(), "{r}: {found}, not {wanted}");
    }
}

/// Sixteen states and eight inputs, each rate of three states of other chains; one more of either is refused.
#[test]
fn wide_models_take_bounded_time() {
    let wide = |m: usize| {
        let around = |j: usize| j % m + 1;
        let rates = (1..=m).map(|j| {
            let (k, l) = (around(j), around(j + 2));
            format!(
                "a{j} = \"b{j} + 0.2*sin(a{k})*a{j}*cos(a{l})\", b{j} = \"(2 + cos(a{k}))*u{j} + 0.1*a{l}*u{k} + b{j}*exp(-a{k}^2)*b{l}\""
            )
        });
        let list = |stems: &[&str]| {
            let of = |j: usize| stems.iter().map(move |stem| format!("\"{stem}{j}\""));
            (1..=m).flat_map(of).collect::<Vec<_>>().join(", ")
        };
        format!(
            "name = \"wide\"\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n[params]\ntau = 2\nt0 = 0\neps = 0.02\nu_max = inf\n\
             [model]\nstates = [{}]\ninputs = [{}]\noutputs = [{}]\ndynamics = {{ {} }}\n",
            list(&["a", "b"]),
            list(&["u"]),
            list(&["a"]),
            rates.collect::<Vec<_>>().join(", "),
        )
    };
    let since = Instant::now();
    let orders = spec(&wide(8)).coupled.expect("a plant").orders();
    assert_eq!(orders, [2; 8]);
    let folder = folder_with("long_chains_wide", "plant.toml", wide(8));
    let (code, _, stderr) = run_in(&folder, &["emit", "plant.toml", "--lang", "c"]);
    assert_eq!(code, Some(0), "{stderr}");
    assert!(since.elapsed() < Duration::from_secs(60));
    let folder = folder_with("long_chains_wider", "plant.toml", wide(9));
    let (code, _, stderr) = run_in(&folder, &["emit", "plant.toml", "--lang", "c"]);
    assert!(code == Some(2) && stderr.contains("9 inputs of a model"), "{stderr}");
}

/// A derivative that is too long ends the work with a message.
#[test]
fn derivatives_beyond_the_limit_are_refused() {
    let dense = |text: String, i: usize| {
        let all: Vec<_> = (1..=i).map(|j| format!("sin(z{j})")).collect();
        let factor = format!("exp(-({})^2)*sin(z{i})", all.join(" + "));
        text.replace(&format!("0.3*sin(z{i})"), &factor)
    };
    let text = (1..=16).fold(design(16), dense);
    let folder = folder_with("long_chains_dense", "plant.toml", text);
    let since = Instant::now();
    let (code, _, stderr) = run_in(&folder, &["emit", "plant.toml", "--lang", "c"]);
    assert!(since.elapsed() < Duration::from_secs(120), "{:?}", since.elapsed());
    assert_eq!(code, Some(2), "{stderr}");
    assert!(stderr.contains("of the output is larger than an expression may be"), "{stderr}");
}
