//! Every u at 50 digits, and the error at the last sample.

use ptc_codegen::code::Instance;
use ptc_codegen::plant::{Plant, read_design};
use ptc_codegen::simulate::{Loop, Sampled, Values};
use serde_json::Value;

use super::{FOUR, changed, program};
use crate::support::{entries, example};

/// Inputs at 50 digits, from `tools/sampled_inputs.py`.
const REFERENCE: &str = include_str!("../../../../../tests/data/sampled_inputs.json");

/// Two axes of order 3.
const RAILS: &str = "n = 3\naxes = 2\ng = [2, -0.5]\n[params]\n";

/// Linear plants, which are sampled exactly.
const MASSES: &str = r#"
[model]
states = ["p", "q", "v", "w"]
inputs = ["F", "G"]
inertia = [[2, 0], [0, 1]]
bias = ["80*p - 50*q + (v - w)/2", "50*(q - p) + (w - v)/2"]
[params]
"#;
const TRAIN: &str = r#"
[model]
states = ["p", "v", "f", "q", "w"]
inputs = ["F", "G"]
outputs = ["p", "q + p/8"]
dynamics = { p = "v", v = "f - p", f = "F - 2*f + w", q = "w", w = "G + F/4 - 3*q + p/2 - c*v" }
[params]
c = 0.25
"#;
const LEVELS: &str = r#"
[model]
states = ["x", "y"]
inputs = ["u", "v"]
outputs = ["x + y/2", "y"]
dynamics = ["2*x - 5*y + u + v/4", "4*x + y/2 - u/2 + 2*v"]
[params]
"#;

/// Relative to the greatest input: chains, laws and their sums each round a few times.
const INPUT: f64 = 1e-12;

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn text(value: &Value) -> &str {
    value.as_str().expect("text")
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(|value| text(value).parse().expect("a number")).collect()
}

#[test]
fn inputs_are_those_of_the_reference() {
    let reference: Value = serde_json::from_str(REFERENCE).expect("JSON");
    for case in list(&reference) {
        let plant = text(&case["plant"]);
        let design = match plant {
            "four" => FOUR.to_owned(),
            "rails" => RAILS.to_owned(),
            "masses" => MASSES.to_owned(),
            "train" => TRAIN.to_owned(),
            "levels" => LEVELS.to_owned(),
            _ => example(&format!("{plant}.toml")),
        };
        let poles = case["poles"].to_string().replace('"', "");
        let (h, samples) = (text(&case["h"]), &case["samples"]);
        let tau: f64 = h.parse::<f64>().expect("a period") * samples.as_f64().expect("samples");
        let reference = match &case["reference"] {
            Value::Null => String::new(),
            reference => format!("\nreference = {reference}"),
        };
        let top = format!("mu = \"exp(a=1)\"\npoles = {poles}\nsample_time = {h}{reference}");
        let design = changed(&design, &top, &format!("tau = {tau}\nu_max = inf\neps = 0"));
        let code = program(&design.replace("limits =", "# "));
        let mut controller = Instance::new(&code, &[]).expect("legal parameters");
        for call in list(&case["calls"]) {
            let k = call["k"].as_f64().expect("a tick");
            let tick = [k];
            let (x, rows) = (numbers(&call["x"]), call["r"].as_array());
            let r: Vec<_> = rows.into_iter().flatten().flat_map(numbers).collect();
            let outcome = controller.call("step", &[("k", &tick[..]), ("x", &x), ("r", &r)]);
            let (found, wanted) = (&outcome.results["u"], numbers(&call["u"]));
            let size = wanted.iter().fold(0.0, |size: f64, u| size.max(u.abs()));
            for (found, wanted) in found.iter().zip(&wanted) {
                let off = (found - wanted).abs() / size;
                assert!(off < INPUT, "{plant}, {k}: {found}, not {wanted}: {off:e}");
            }
        }
    }
}

/// |x_i| at the last sample, for each of the coordinates i of the chains.
fn last(text: &str, h: f64, x0: &[f64], chain: fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
    let (spec, _) = read_design(&entries(text)).expect("a legal design");
    let plant = Plant::own(&spec);
    let (values, mut end) = (Values::of(&spec, &plant), Vec::new());
    let around = Loop { period: h, ..Loop::default() };
    let mut run = Sampled::new(&spec, &plant).expect("a loop");
    run.run(&values, x0, &around, &mut |sample| end = chain(sample.x)).expect("a run");
    end.into_iter().map(f64::abs).collect()
}

/// Changes of the plant within a sample leave x_i of an output of order n at O(h^(n+2-i)) or less.
#[test]
fn the_error_falls_with_the_period() {
    let tank = |x: &[f64]| vec![x[0], x[2], (x[1] - x[2]) * (1.0 + x[0])];
    let arm = |x: &[f64]| vec![x[0], x[2], x[1], x[3]];
    for (name, further, tau, periods, x0, chain, orders) in [
        (
            "tank.toml",
            "poles = [[-4], [-3, -4]]",
            4,
            [0.125, 0.0625, 0.03125],
            &[0.3, 10.0, 5.0][..],
            tank as fn(&[f64]) -> Vec<f64>,
            &[2, 3, 2][..],
        ),
        (
            "two_link.toml",
            "poles = [-3, -4]",
            1,
            [0.1, 0.05, 0.025],
            &[1.0, -0.5, 0.0, 0.0],
            arm,
            &[3, 2, 3, 2],
        ),
    ] {
        let errors = periods.map(|h| {
            let top = format!("mu = \"exp(a=1)\"\n{further}\nsample_time = {h:?}");
            let text = changed(&example(name), &top, &format!("tau = {tau}\neps = 0\nu_max = inf"));
            last(&text.replace("limits =", "# "), h, x0, chain)
        });
        for pair in errors.windows(2) {
            for ((coarse, fine), order) in pair[0].iter().zip(&pair[1]).zip(orders) {
                // Roundings leave some 1e-17.
                let bound = coarse / 2.0_f64.powi(*order) + 1e-16;
                assert!(*fine <= bound, "{name}: {errors:?}");
            }
        }
        assert!(errors[0].iter().any(|error| *error > 1e-9), "{name}: {errors:?}");
    }
}
