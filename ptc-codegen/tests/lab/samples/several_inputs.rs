//! Plants with several inputs: against one controller for each chain, against reference values of 50 digits,
//! and in the loop.

use num_traits::{FromPrimitive, Signed, ToPrimitive};
use ptc_codegen::algebra::BigRational;
use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Code, Instance, Status};
use ptc_codegen::plant::{Plant, read_design};
use ptc_codegen::samples;
use ptc_codegen::simulate::{Loop, Sampled, Values};
use serde_json::Value;

use super::{code, read};
use crate::support::{entries, example, spec};

/// Inputs at 50 digits, from `tools/sampled_inputs.py`.
const REFERENCE: &str = include_str!("../../../../tests/data/sampled_inputs.json");

/// Relative to the greatest input: chains, laws and their sums each round a few times.
const INPUT: f64 = 1e-12;

/// Four outputs, whose inputs are solved for by elimination.
const FOUR: &str = r#"
mu = "exp(a=1)"
[model]
states = ["a", "b", "b1", "c", "d", "d1"]
inputs = ["A", "B", "C", "D"]
outputs = ["a", "b", "c", "d"]
dynamics = { a = "A*(2 + b^2) + B - a*c", b = "b1", b1 = "B*(3 + a) + C*d - b*d1", c = "C + D*a - c^2", d = "d1", d1 = "D*(2 - b) + A*c + a" }
"#;

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

#[test]
fn chains_apart_have_the_bits_of_a_controller_each() {
    let time = [("tau", "0.5"), ("sample_time", "1/128")];
    for (both, each) in [
        (vec![("poles", "[[-3,-4],[-3.5+i,-3.5-i]]")], ["-3,-4", "-3.5+i,-3.5-i"]),
        (vec![("poles", "-3.25,-4")], ["-3.25,-4"; 2]),
        (vec![("poles", "[[-3,-4],[-6,-9.5]]"), ("eps", "0.1")], ["-3,-4", "-6,-9.5"]),
        (vec![("poles", "-3,-4"), ("deadbeat", "30")], ["-3,-4"; 2]),
        (vec![("poles", "[[-3,-4],[-2.5,-7]]"), ("precision", "f32")], ["-3,-4", "-2.5,-7"]),
        (vec![("poles", "[[-3,-4],[-2.5,-7]]"), ("limits", "2, 5")], ["-3,-4", "-2.5,-7"]),
    ] {
        let keys = [&time[..], &both].concat();
        let (plant, rows) = (decoupled(&keys), axes(&keys));
        let alone = each.iter().enumerate().map(|(index, poles)| {
            let mut keys = [&time[..], &[("n", "2"), ("poles", *poles)]].concat();
            let other = both.iter().filter(|(key, _)| !["poles", "limits"].contains(key));
            keys.extend(other);
            if both.contains(&("limits", "2, 5")) {
                keys.push(("u_max", ["2", "5"][index]));
            }
            code(&keys)
        });
        let alone: Vec<_> = alone.collect();
        let [mut plant, mut rows] =
            [&plant, &rows].map(|code| Instance::new(code, &[]).expect("legal parameters"));
        let mut alone: Vec<_> =
            alone.iter().map(|code| Instance::new(code, &[]).expect("legal parameters")).collect();
        for k in 0..70_u32 {
            let k = f64::from(k);
            let x = [0.3 - k / 100.0, (k * 0.7).sin(), 0.2 * k - 3.0, (k * 1.3).cos()];
            let outcome = plant.call("step", &[("k", &[k]), ("x", &x)]);
            let of_rows = [("k", &[k][..]), ("x", &[x[0], x[2], x[1], x[3]])];
            assert_eq!(rows.call("step", &of_rows), outcome, "{both:?}, {k}");
            for (index, own) in alone.iter_mut().enumerate() {
                let own = own.call("step", &[("k", &[k]), ("x", &[x[index], x[index + 2]])]);
                let [u, wanted] = [outcome.results["u"][index], own.results["u"][0]];
                assert_eq!(u.to_bits(), wanted.to_bits(), "{both:?}, {k}, {index}");
                let status = outcome.results["axes"][index];
                assert_eq!(status, f64::from(own.status.number()), "{both:?}, {k}, {index}");
            }
        }
    }
}

/// Two rounds of deadbeat leave the square of a rounding.
#[test]
fn chains_apart_are_at_rest_at_the_last_sample() {
    let all =
        decoupled(&[("tau", "0.5"), ("sample_time", "1/128"), ("poles", "[[-3,-4],[-5.5,-6]]")]);
    let mut controller = Instance::new(&all, &[]).expect("legal parameters");
    let number = |value: f64| BigRational::from_f64(value).expect("a number");
    let h = number(1.0 / 128.0);
    let mut x = [0.3, -1.25, 2.0, 0.7].map(number);
    for k in 0..64_u32 {
        let given = x.each_ref().map(|x| x.to_f64().expect("a double"));
        let outcome = controller.call("step", &[("k", &[f64::from(k)]), ("x", &given)]);
        assert_eq!(outcome.status, Status::Ok, "sample {k}");
        for index in 0..2 {
            let u = number(outcome.results["u"][index]);
            let moved = &x[index] + &h * &x[index + 2] + &h * &h / number(2.0) * &u;
            x[index] = moved;
            x[index + 2] = &x[index + 2] + &h * u;
        }
    }
    let rest = x.iter().map(Signed::abs).max().expect("a state");
    assert!(rest < number(1e-28), "{:?}", rest.to_f64());
    let hold = controller.call("step", &[("k", &[64.0]), ("x", &[0.0; 4])]);
    assert_eq!(hold.status, Status::Hold);
}

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
            _ => example(&format!("{plant}.toml")),
        };
        let poles = case["poles"].to_string().replace('"', "");
        let (h, samples) = (text(&case["h"]), &case["samples"]);
        let tau: f64 = h.parse::<f64>().expect("a period") * samples.as_f64().expect("samples");
        let top = format!("mu = \"exp(a=1)\"\npoles = {poles}\nsample_time = {h}");
        let design = changed(&design, &top, &format!("tau = {tau}\nu_max = inf\neps = 0"));
        let code = program(&design.replace("limits =", "# "));
        let mut controller = Instance::new(&code, &[]).expect("legal parameters");
        for call in list(&case["calls"]) {
            let k = call["k"].as_f64().expect("a tick");
            let outcome = controller.call("step", &[("k", &[k]), ("x", &numbers(&call["x"]))]);
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

/// What is not held leaves x_i of an output of order n at O(h^(n+2-i)), or less.
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

/// The same plant in other coordinates and inputs, spelt oddly.
#[test]
fn spellings_and_coordinates_do_not_matter() {
    let time = [("tau", "0.5"), ("sample_time", "1/128"), ("poles", "[[-3,-4],[-6,-9.5]]")];
    let mixed = [
        ("states", "p, q, dp, dq"),
        ("inputs", "a, b"),
        ("outputs", "p + (q)*1^2, q - 2*p + 0*dp"),
        ("dynamics", "dp/1, -(-dq), sqrt(4)*a + b + 0.0, ((b)) - a^1"),
    ];
    let mixed = code(&[&time[..], &mixed].concat());
    let apart = decoupled(&time);
    let [mut mixed, mut apart] =
        [&mixed, &apart].map(|code| Instance::new(code, &[]).expect("legal parameters"));
    for k in 0..70_u32 {
        let k = f64::from(k);
        let x = [0.3 - k / 100.0, (k * 0.7).sin(), 0.2 * k - 3.0, (k * 1.3).cos()];
        let chain = [x[0] + x[1], x[1] - 2.0 * x[0], x[2] + x[3], x[3] - 2.0 * x[2]];
        let u = mixed.call("step", &[("k", &[k]), ("x", &x)]).results["u"].clone();
        let wanted = apart.call("step", &[("k", &[k]), ("x", &chain)]).results["u"].clone();
        // p'' + q'' = a + 2 b, q'' - 2 p'' = -5 a - b.
        let found = [u[0] + 2.0 * u[1], -5.0 * u[0] - u[1]];
        let size = wanted.iter().fold(0.0, |size: f64, w| size.max(w.abs()));
        for (found, wanted) in found.iter().zip(&wanted) {
            assert!((found - wanted).abs() <= 1e-13 * size, "{k}: {found}, not {wanted}");
        }
    }
}

#[test]
fn inputs_that_do_not_decouple_are_refused_at_run_time() {
    let tank = changed(&example("tank.toml"), "sample_time = 0.25", "");
    let code = program(&tank);
    let mut controller = Instance::new(&code, &[]).expect("legal parameters");
    let mut call = |x: &[f64]| {
        let outcome = controller.call("step", &[("k", &[3.0]), ("x", x)]);
        (outcome.status, outcome.results["u"].clone(), outcome.results["axes"].clone())
    };
    let number = |status: Status| f64::from(status.number());
    // The determinant is 1 + h.
    let (status, u, _) = call(&[-1.0, 3.0, 2.0]);
    assert_eq!((status, u), (Status::Range, vec![0.0; 2]));
    let (status, u, axes) = call(&[0.5, f64::NAN, 2.0]);
    assert_eq!((status, u, axes), (Status::Input, vec![0.0; 2], vec![number(Status::Input); 2]));
    let (status, u, axes) = call(&[0.5, 1e3, 2.0]);
    assert_eq!((status, u[1].abs()), (Status::Saturated, 50.0));
    assert_eq!(axes, [number(Status::Ok), number(Status::Saturated)]);
    let mut four = program(&changed(
        FOUR,
        "poles = [[-4], [-3, -4], [-5], [-2.5, -6]]\nsample_time = 0.02",
        "tau = 1\nu_max = inf",
    ));
    four.head.clear();
    let mut four = Instance::new(&four, &[]).expect("legal parameters");
    let outcome = four.call("step", &[("k", &[3.0]), ("x", &[0.0, 2.0, 1.0, 0.0, 0.5, 0.0])]);
    assert_eq!((outcome.status, &outcome.results["u"]), (Status::Range, &vec![0.0; 4]));
}

#[test]
fn parameters_at_run_time_act_as_fixed_ones() {
    let fixed = decoupled(&[("tau", "0.5"), ("sample_time", "1/128"), ("poles", "-3,-4")]);
    let open = decoupled(&[("mu", "exp")]);
    let given: [(&str, &[f64]); 5] = [
        ("samples", &[64.0]),
        ("h", &[1.0 / 128.0]),
        ("a", &[1.0]),
        ("k", &[12.0, 7.0]),
        ("deadbeat", &[5.0]),
    ];
    let mut fixed = Instance::new(&fixed, &[]).expect("legal parameters");
    let mut open = Instance::new(&open, &given).expect("legal parameters");
    for k in 0..66_u32 {
        let given = [("k", &[f64::from(k)][..]), ("x", &[0.3, -1.0, 2.0, 0.5])];
        let [found, wanted] = [&mut open, &mut fixed].map(|c| c.call("step", &given));
        assert_eq!(found.status, wanted.status, "{k}");
        for (found, wanted) in found.results["u"].iter().zip(&wanted.results["u"]) {
            assert!((found / wanted - 1.0).abs() < 1e-14, "{k}: {found}, not {wanted}");
        }
    }
    let short = [("samples", &[1.0][..]), given[1], given[2], given[3], given[4]];
    let open = decoupled(&[("mu", "exp")]);
    assert_eq!(Instance::new(&open, &short).err(), Some(Status::Param));
}

#[test]
fn what_needs_one_input_is_refused() {
    let plant = [
        ("mu", "exp(a=1)"),
        ("clock", "samples"),
        ("sample_time", "0.01"),
        ("tau", "1"),
        ("poles", "-3,-4"),
        ("states", "p, q, dp, dq"),
        ("inputs", "a, b"),
        ("outputs", "p, q"),
        ("dynamics", "dp, dq, a - q^3, b"),
    ];
    read(&plant).expect("a legal design");
    read(
        &[&plant[..], &[("measured", "p, q, dp, dq"), ("disturbance", "none"), ("delay", "0")]]
            .concat(),
    )
    .expect("a legal design");
    for (key, value, wanted) in [
        (
            "delay",
            "1",
            "the prediction over a delay needs a linear plant of one input; leave `delay` out",
        ),
        (
            "measured",
            "p, q",
            "an observer needs a linear plant of one input; leave `measured` out: `step` takes all states, p, q, dp, dq",
        ),
        ("disturbance", "constant", "an observer needs a linear plant of one input"),
        ("observer_poles", "-3,-4", "`observer_poles` without an observer"),
        ("reference", "input", "a reference needs a clock in time"),
        ("pi0", "extern", "a clock in samples needs a linear law"),
        ("mu", "tanh(a=1)", "an exact law for the mapping exp alone"),
        ("t0", "1", "arm the controller at the tick"),
        ("after", "zero", "the outputs hold their gains after the deadline"),
        ("guard", "result", "has the guards full and none"),
        ("fma", "true", "no fused multiply-add yet"),
        ("what", "observer", "such a plant is of a controller"),
        ("tau", "0.01", "too few to come to rest"),
        ("deadbeat", "1", "an integer of at least 2"),
        ("poles", "[[-3,-4],[-3]]", "1 pole for order n = 2"),
        ("limits", "1,2,3", "3 values of `limits` for 2 axes"),
        ("axes", "2", "`axes` beside `inputs` and `outputs`"),
    ] {
        let mut keys: Vec<_> = plant.iter().copied().filter(|(own, _)| *own != key).collect();
        if key == "pi0" {
            keys.retain(|(own, _)| *own != "poles");
        }
        keys.push((key, value));
        let found = read(&keys).expect_err(&format!("{key} = {value}"));
        assert!(found.contains(wanted), "{key} = {value}: {found}");
    }
}

/// The command of a design gives it back.
#[test]
fn the_command_gives_the_design() {
    for (name, top) in [
        ("tank.toml", "poles = [[-4], [-3, -4]]\nsample_time = 0.25\ndeadbeat = 12"),
        (
            "two_link.toml",
            "mu = \"exp(a=1.25)\"\nsample_time = 0.05\nprecision = \"f32\"\nguard = \"none\"",
        ),
    ] {
        let wanted = spec(&changed(&example(name), top, ""));
        let found = crate::command::spec_of(&wanted.command()).expect("a legal command");
        assert_eq!(found, wanted, "{}", wanted.command());
    }
}

/// What is not proved is not called sound.
#[test]
fn the_checks_say_what_they_do_not_know() {
    let report = |text: &str| examine(&spec(text));
    let of = |text: &str, name: &str| {
        let outcome = report(text).outcomes.into_iter().find(|outcome| outcome.name == name);
        outcome.expect("a check")
    };
    let tank = |x_max: &str, limit: &str| {
        let top = format!("sample_time = 0.05\nx_max = {x_max}\nnoise = [1e-3, 0.1, 0.1]");
        changed(&example("tank.toml"), &top, limit)
    };
    for name in ["sampling", "deadline", "loop"] {
        let found = of(&tank("[0.9, 50, 50]", ""), name);
        assert_eq!(found.verdict, Verdict::NotChecked, "{name}: {}", found.summary);
        assert!(found.summary.contains("several inputs"), "{name}: {}", found.summary);
    }
    let arm = |mass: &str| {
        let top = "mu = \"exp(a=1)\"\npoles = [-3, -4]\nsample_time = 0.05\nx0_max = [1, 1]\nerror = 0.1\nx_max = [3, 3, 9, 9]";
        changed(&example("two_link.toml"), top, mass)
    };
    for (text, verdict, summary) in [
        (tank("[0.9, 50, 50]", ""), Verdict::NotChecked, "within `x_max` it divides by no 0"),
        (tank("[1, 50, 50]", ""), Verdict::Refuted, "1 + h, is 0 at h = -1: the law divides by it"),
        (arm("m2 = 1.5"), Verdict::NotChecked, "within `x_max` it divides by no 0"),
        (
            changed(
                FOUR,
                "poles = [[-4], [-3, -4], [-5], [-2.5, -6]]\nsample_time = 0.01\nx_max = [1, 1, 9, 1, 1, 9]",
                "tau = 1",
            ),
            Verdict::NotChecked,
            "within `x_max` it divides by no 0",
        ),
        (
            changed(
                FOUR,
                "poles = [[-4], [-3, -4], [-5], [-2.5, -6]]\nsample_time = 0.01\nx_max = [4, 3, 9, 1, 1, 9]",
                "tau = 1",
            ),
            Verdict::Refuted,
            "the law divides by it",
        ),
    ] {
        let found = of(&text, "envelope");
        assert_eq!(found.verdict, verdict, "{text}: {}", found.summary);
        assert!(found.summary.contains(summary), "{}", found.summary);
    }
    let looped = of(&arm("m2 = 1.5"), "loop");
    assert_eq!(looped.verdict, Verdict::NotChecked, "{}", looped.summary);
    // What is left to run time may be anything, unless it has bounds.
    let open =
        tank("[0.5, 50, 50]", "").replace("e = \"(c - e)*(1 + h)\"", "e = \"(c - e)*(k + h)\"");
    for (text, verdict, summary) in [
        (open.clone(), Verdict::NotChecked, "`k` is left to run time without bounds"),
        (
            open.replace("[params]", "[params]\nk = [0.6, 2]"),
            Verdict::NotChecked,
            "divides by no 0",
        ),
        (
            open.replace("[params]", "[params]\nk = [0.4, 2]"),
            Verdict::Refuted,
            "the law divides by it",
        ),
    ] {
        let found = of(&text, "envelope");
        assert_eq!(found.verdict, verdict, "{text}: {}", found.summary);
        assert!(found.summary.contains(summary), "{}", found.summary);
    }
}

/// Each axis has its own input gain, and a reader refuses what axes in samples lack.
#[test]
fn axes_are_chains_with_gains_of_their_own() {
    let time = [("tau", "0.5"), ("sample_time", "1/128"), ("poles", "[[-3,-4],[-5,-6.5]]")];
    let all = axes(&[&time[..], &[("g", "[2, -0.5]")]].concat());
    let mut all = Instance::new(&all, &[]).expect("legal parameters");
    let alone = [("-3,-4", "2"), ("-5,-6.5", "-0.5")]
        .map(|(poles, g)| code(&[&time[..2], &[("n", "2"), ("poles", poles), ("g", g)]].concat()));
    let mut alone = alone.each_ref().map(|code| Instance::new(code, &[]).expect("legal"));
    for k in 0..66_u32 {
        let k = f64::from(k);
        let x = [0.3 - k / 100.0, (k * 0.7).sin(), 0.2 * k - 3.0, (k * 1.3).cos()];
        let outcome = all.call("step", &[("k", &[k]), ("x", &x)]);
        for (index, own) in alone.iter_mut().enumerate() {
            let own = own.call("step", &[("k", &[k]), ("x", &x[2 * index..2 * index + 2])]);
            let [u, wanted] = [outcome.results["u"][index], own.results["u"][0]];
            assert_eq!(u.to_bits(), wanted.to_bits(), "{k}, {index}");
        }
    }
    let keys = [("n", "2"), ("axes", "2"), ("mu", "exp(a=1)"), ("clock", "samples")];
    read(&[&keys[..], &[("measured", "x1, x2"), ("disturbance", "none")]].concat())
        .expect("a legal design");
    for (key, value, wanted) in [
        ("delay", "1", "axes in samples keep no inputs under way"),
        ("measured", "x1", "axes in samples have no observers"),
        ("disturbance", "constant", "axes in samples have no observers"),
        ("A", "[[0,1],[0,0]]", "the axes are chains"),
        ("g", "[2, m]", "g is not a number"),
        ("f", "3", "f depends on the state of one axis"),
        ("pi0", "extern", "a clock in samples needs a linear law"),
        ("after", "zero", "axes hold their gains after the deadline"),
        ("what", "observer", "axes are of a controller"),
        ("reference", "input", "a reference needs a clock in time"),
    ] {
        let found = read(&[&keys[..], &[(key, value)]].concat()).expect_err(key);
        assert!(found.contains(wanted), "{key} = {value}: {found}");
    }
}
