//! Plants with several inputs: against one controller for each chain, against reference values of 50 digits,
//! and in the loop.

mod apart;
mod checks;
mod exact;
mod followed;
mod reference;
mod refusals;
mod run_time;

use ptc_codegen::code::Code;
use ptc_codegen::samples;

use super::{code, read};
use crate::support::spec;

/// Four outputs, whose inputs are solved for by elimination.
const FOUR: &str = r#"
mu = "exp(a=1)"
[model]
states = ["a", "b", "b1", "c", "d", "d1"]
inputs = ["A", "B", "C", "D"]
outputs = ["a", "b", "c", "d"]
dynamics = { a = "A*(2 + b^2) + B - a*c", b = "b1", b1 = "B*(3 + a) + C*d - b*d1", c = "C + D*a - c^2", d = "d1", d1 = "D*(2 - b) + A*c + a" }
"#;

/// Run-time parameters of two chains of order 2.
const AT_RUN_TIME: [(&str, &[f64]); 5] = [
    ("samples", &[64.0]),
    ("h", &[1.0 / 128.0]),
    ("a", &[1.0]),
    ("k", &[12.0, 7.0]),
    ("deadbeat", &[5.0]),
];

/// A design with other values of keys at its top and under [params].
fn changed(text: &str, top: &str, params: &str) -> String {
    let own = [top, params].join("\n");
    let keys: Vec<_> =
        own.lines().filter_map(|line| Some(line.split_once('=')?.0.trim())).collect();
    let is_own =
        |line: &&str| line.split_once('=').is_some_and(|(key, _)| keys.contains(&key.trim()));
    let kept: Vec<_> = text.lines().filter(|line| !is_own(line)).collect();
    let kept = kept.join("\n");
    let (head, tables) = kept.split_at(kept.find("\n[").expect("a table"));
    let tables = match tables.contains("[params]") {
        true => tables.replace("[params]", &format!("[params]\n{params}")),
        false => format!("\n[params]\n{params}{tables}"),
    };
    format!("{head}\nclock = \"samples\"\n{top}{tables}")
}

fn program(text: &str) -> Code {
    let spec = spec(text);
    let code = samples::controller(&spec, spec.sampled().expect("a clock in samples"), Vec::new());
    code.check().expect("a program in order");
    code
}

/// Two double integrators as one plant.
fn decoupled(further: &[(&str, &str)]) -> Code {
    let own = [
        ("states", "p, q, dp, dq"),
        ("inputs", "a, b"),
        ("outputs", "p, q"),
        ("dynamics", "dp, dq, a, b"),
    ];
    code(&[&own, further].concat())
}

/// The same as axes.
fn axes(further: &[(&str, &str)]) -> Code {
    code(&[&[("n", "2"), ("axes", "2")], further].concat())
}
