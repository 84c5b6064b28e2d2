//! References of several outputs: the bits of a controller each, and what is left of the tracking errors.

use num_traits::{FromPrimitive, ToPrimitive, Zero};
use ptc_codegen::algebra::BigRational;
use ptc_codegen::code::{Code, Instance, Shape, Status};
use ptc_codegen::plant::{Plant, as_one, read_design};
use ptc_codegen::simulate::{Loop, Sampled, Values, tracking_error};

use super::{AT_RUN_TIME, axes, changed, code, decoupled, program};
use crate::support::{entries, example, spec};

/// tau and the sample period, exact in binary.
const TIME: [(&str, &str); 2] = [("tau", "0.5"), ("sample_time", "1/128")];

/// Any number for a place of a call.
fn number(k: u32, place: usize) -> f64 {
    (f64::from(k) * 0.7 + 1.3 * place as f64).sin() * (1.0 + place as f64)
}

fn started(code: &Code) -> Instance {
    Instance::new(code, &[]).expect("legal parameters")
}

#[test]
fn references_of_chains_apart_have_the_bits_of_a_controller_each() {
    let size = ("params.size", "[0.5, 2]");
    for (reference, each, further) in [
        ("input", ["input"; 2], vec![("poles", "[[-3,-4],[-3.5+i,-3.5-i]]")]),
        ("input", ["input"; 2], vec![("poles", "-3,-4"), ("eps", "0.1"), ("precision", "f32")]),
        ("sin(3*t), 1/(1 + t^2)", ["sin(3*t)", "1/(1 + t^2)"], vec![("poles", "-3.25,-4")]),
        // One of them rests, and both take the same sine.
        ("0, cos(t) + 3", ["0", "cos(t) + 3"], vec![("poles", "[[-3,-4],[-2.5,-7]]")]),
        (
            "sin(2*t) + t, 2*sin(2*t)",
            ["sin(2*t) + t", "2*sin(2*t)"],
            vec![("poles", "-3,-4"), ("deadbeat", "30"), ("precision", "f32")],
        ),
        ("size*dt^3, exp(-size*t)", ["size*dt^3", "exp(-size*t)"], vec![("poles", "-3,-4"), size]),
    ] {
        let both = [&TIME[..], &further, &[("reference", reference)]].concat();
        let mut plants = [decoupled(&both), axes(&both)].map(|code| (code, [0.75]));
        let alone = each.iter().zip([0, 1]).map(|(reference, index)| {
            let rows = ["-3,-4", "-3.5+i,-3.5-i", "-2.5,-7"];
            let own = further.iter().map(|(key, value)| match (*key, *value) {
                ("poles", "[[-3,-4],[-3.5+i,-3.5-i]]") => ("poles", rows[index]),
                ("poles", "[[-3,-4],[-2.5,-7]]") => ("poles", rows[2 * index]),
                other => other,
            });
            let own: Vec<_> = own.collect();
            code(&[&TIME[..], &own, &[("n", "2"), ("reference", *reference)]].concat())
        });
        let alone: Vec<_> = alone.collect();
        let given = reference == "input";
        let open = |code: &Code| !code.parameters.is_empty();
        for (plant, value) in &mut plants {
            let value: &[(&str, &[f64])] = &[("size", &value[..])];
            let values = |code: &Code| if open(code) { value } else { &[] };
            let mut all = Instance::new(plant, values(plant)).expect("legal parameters");
            let mut alone: Vec<_> = alone
                .iter()
                .map(|code| Instance::new(code, values(code)).expect("legal parameters"))
                .collect();
            let rows = plant.function("step").expect("step").arguments[1].shape;
            let is_axes = matches!(rows, Shape::Lists(2, 2));
            for k in 0..70_u32 {
                let x: [f64; 4] = [0, 1, 2, 3].map(|place| number(k, place));
                let r: [f64; 6] = [4, 5, 6, 7, 8, 9].map(|place| number(k, place));
                // Axes are given rows, and the plant positions before rates.
                let of_plant = [x[0], x[2], x[1], x[3]];
                let tick = [f64::from(k)];
                let mut call = vec![("k", &tick[..])];
                call.push(("x", if is_axes { &x } else { &of_plant }));
                call.extend(given.then_some(("r", &r[..])));
                let outcome = all.call("step", &call);
                for (index, own) in alone.iter_mut().enumerate() {
                    let mut call = vec![("k", &tick[..]), ("x", &x[2 * index..2 * index + 2])];
                    call.extend(given.then_some(("r", &r[3 * index..3 * index + 3])));
                    let own = own.call("step", &call);
                    let [u, wanted] = [outcome.results["u"][index], own.results["u"][0]];
                    assert_eq!(u.to_bits(), wanted.to_bits(), "{reference}, {k}, {index}");
                    assert_eq!(outcome.results["axes"][index], f64::from(own.status.number()));
                }
            }
        }
    }
}

/// With tau and all else left to run time.
#[test]
fn parameters_at_run_time_follow_as_fixed_ones() {
    let known = ("reference", "t^2, 3*t");
    for reference in [known, ("reference", "input")] {
        let further = [("poles", "-3,-4"), ("deadbeat", "5"), reference];
        let fixed =
            [decoupled(&[&TIME[..], &further].concat()), axes(&[&TIME[..], &further].concat())];
        let open = [("mu", "exp"), reference];
        let open = [decoupled(&open), axes(&open)];
        for (fixed, open) in fixed.iter().zip(&open) {
            let mut fixed = started(fixed);
            let mut open = Instance::new(open, &AT_RUN_TIME).expect("legal parameters");
            for k in 0..66_u32 {
                let tick = [f64::from(k)];
                let x: [f64; 4] = [0, 1, 2, 3].map(|place| number(k, place));
                let r: [f64; 6] = [4, 5, 6, 7, 8, 9].map(|place| number(k, place));
                let call = [("k", &tick[..]), ("x", &x), ("r", &r)];
                let call = if reference == known { &call[..2] } else { &call };
                let [found, wanted] = [&mut open, &mut fixed].map(|c| c.call("step", call));
                assert_eq!(found.status, wanted.status, "{k}");
                for (found, wanted) in found.results["u"].iter().zip(&wanted.results["u"]) {
                    let size = 1.0 + wanted.abs();
                    assert!((found - wanted).abs() < 1e-12 * size, "{k}: {found}, not {wanted}");
                }
            }
        }
    }
}

/// The exact chains of axes of orders 1 to 3 meet polynomials of their order, at sample N.
#[test]
fn axes_meet_polynomials_of_their_order() {
    // r of axis 1 is 1 + t + ... + t^n, and of axis 2 its negative half.
    let h = BigRational::new(1.into(), 64.into());
    let double = |value: &BigRational| value.to_f64().expect("a double");
    for n in 1..=3_usize {
        let r = |axis: usize, order: usize, t: &BigRational| {
            let term = |j: usize| {
                let factor = (j - order + 1..=j).product::<usize>();
                num_traits::pow(t.clone(), j - order) * BigRational::from_integer(factor.into())
            };
            let sum = (order..=n).map(term).fold(BigRational::zero(), |sum, term| sum + term);
            if axis == 0 { sum } else { sum / BigRational::from_integer((-2).into()) }
        };
        let text = (0..=n).map(|j| format!("t^{j}")).collect::<Vec<_>>().join(" + ");
        let poles: Vec<_> = (0..n).map(|i| format!("-{}", n + 1 + i)).collect();
        let (order, poles) = (n.to_string(), poles.join(","));
        for reference in [format!("{text}, -({text})/2"), "input".to_owned()] {
            let keys = [
                ("n", order.as_str()),
                ("axes", "2"),
                ("poles", &poles),
                ("g", "[2, -4]"),
                ("sample_time", "1/64"),
                ("tau", "60/64"),
                ("reference", &reference),
            ];
            let code = code(&keys);
            let mut controller = started(&code);
            let at = |k: u32| BigRational::from_integer(k.into()) * &h;
            let start = |axis: usize, i: usize| {
                BigRational::new(1.into(), (i + 2).into()) + r(axis, i, &at(0))
            };
            let mut x: Vec<Vec<_>> =
                (0..2).map(|axis| (0..n).map(|i| start(axis, i)).collect()).collect();
            for k in 0..60 {
                let given: Vec<_> = x.iter().flatten().map(double).collect();
                let wanted = (0..2).flat_map(|axis| (0..=n).map(move |order| (axis, order)));
                let wanted: Vec<_> = wanted.map(|(axis, i)| double(&r(axis, i, &at(k)))).collect();
                let tick = [f64::from(k)];
                let mut call = vec![("k", &tick[..]), ("x", &given)];
                call.extend((reference == "input").then_some(("r", &wanted[..])));
                let outcome = controller.call("step", &call);
                assert_eq!(outcome.status, Status::Ok, "sample {k}");
                for (axis, (own, gain)) in x.iter_mut().zip([2, -4]).enumerate() {
                    let u = BigRational::from_f64(outcome.results["u"][axis]).expect("a finite u");
                    let acts = u * BigRational::from_integer(gain.into());
                    for i in 0..n {
                        let mut share = h.clone();
                        for power in 1..n - i {
                            let next = &own[i + power] * &share;
                            own[i] += next;
                            share *= &h / BigRational::from_integer((power + 1).into());
                        }
                        own[i] += &acts * share;
                    }
                }
            }
            for (axis, own) in x.iter().enumerate() {
                for (i, x) in own.iter().enumerate() {
                    let left = double(&(x - r(axis, i, &at(60)))).abs() / 64_f64.powi(i as i32);
                    assert!(left <= 2e-15, "n = {n}, {reference}: e{} = {left:e}", i + 1);
                }
            }
        }
    }
}

/// |e_i| of each chain at the last sample, one output after the other.
fn last(text: &str, h: f64, x0: &[f64]) -> Vec<f64> {
    let (spec, plant) = read_design(&entries(text)).expect("a legal design");
    let (spec, _) = as_one(spec, plant);
    let plant = Plant::own(&spec);
    let (values, mut end) = (Values::of(&spec, &plant), Vec::new());
    let around = Loop { period: h, ..Loop::default() };
    let mut run = Sampled::new(&spec, &plant).expect("a loop");
    let mut visit = |sample: ptc_codegen::simulate::Sample<'_>| {
        end = tracking_error(&spec, &values, sample.t, sample.x)
            .expect("values")
            .expect("a reference");
    };
    run.run(&values, x0, &around, &mut visit).expect("a run");
    end.into_iter().map(f64::abs).collect()
}

/// Changes of r^(n) and the plant over a sample leave e_i of an output of order n at O(h^(n+2-i)) or less.
#[test]
fn the_tracking_error_falls_with_the_period() {
    let axes = "name = \"pair\"\nn = 2\naxes = 2\nmu = \"exp(a=1)\"\ng = [2, -0.5]\n[params]\n";
    let (tank, arm) = (example("tank.toml"), example("two_link.toml"));
    for (text, top, tau, periods, x0, orders) in [
        (
            axes,
            "poles = [[-4,-5],[-3,-6]]\nreference = [\"0.3*sin(3*t + 0.3)\", \"0.2*cos(2*t)\"]",
            1,
            [0.0625, 0.03125, 0.015625],
            &[0.3, 0.0, 0.5, 1.0][..],
            &[3, 2, 3, 2][..],
        ),
        (
            &tank,
            "poles = [[-4], [-3, -4]]\nreference = [\"0.3*t\", \"2*sin(0.3*t + 2)\"]",
            4,
            [0.0625, 0.03125, 0.015625],
            &[0.3, 10.0, 5.0],
            &[2, 3, 2],
        ),
        (
            &arm,
            "poles = [-3, -4]\nreference = [\"0.5*sin(t)\", \"cos(1.5*t)\"]",
            1,
            [0.05, 0.025, 0.0125],
            &[1.0, -0.5, 0.0, 0.0],
            &[3, 2, 3, 2],
        ),
    ] {
        let errors = periods.map(|h| {
            let top = format!("mu = \"exp(a=1)\"\n{top}\nsample_time = {h:?}");
            let text = changed(text, &top, &format!("tau = {tau}\neps = 0\nu_max = inf"));
            last(&text.replace("limits =", "# "), h, x0)
        });
        for pair in errors.windows(2) {
            for ((coarse, fine), order) in pair[0].iter().zip(&pair[1]).zip(orders) {
                // By a fifth from the limit of short periods; roundings leave some 1e-16.
                let bound = 1.2 * coarse / 2.0_f64.powi(*order) + 1e-15;
                assert!(*fine <= bound, "{top}: {errors:?}");
            }
        }
        assert!(errors[0].iter().any(|error| *error > 1e-9), "{top}: {errors:?}");
    }
}

/// Reference values beyond the order of an output may be anything; values that it reads may not.
#[test]
fn a_row_is_read_up_to_its_order() {
    let text = changed(&example("tank.toml"), "sample_time = 0.25\nreference = \"input\"", "");
    let code = program(&text);
    let mut controller = started(&code);
    let mut call = |r: &[f64; 6]| {
        let given = [("k", &[3.0][..]), ("x", &[0.5, 3.0, 2.0]), ("r", r)];
        let outcome = controller.call("step", &given);
        (outcome.status, outcome.results["u"].clone())
    };
    let wanted = call(&[0.1, 0.2, 0.0, 0.3, 0.4, 0.5]);
    assert_eq!(wanted.0, Status::Ok);
    assert_eq!(call(&[0.1, 0.2, f64::NAN, 0.3, 0.4, 0.5]), wanted);
    for place in [0, 1, 3, 4, 5] {
        let mut r = [0.1, 0.2, 0.0, 0.3, 0.4, 0.5];
        r[place] = f64::INFINITY;
        assert_eq!(call(&r), (Status::Input, vec![0.0; 2]), "{place}");
        r[place] = 0.6;
        assert_ne!(call(&r).1, wanted.1, "{place}");
    }
}

/// Once armed again, known references begin anew.
#[test]
fn time_of_references_counts_from_the_start() {
    let keys = [("poles", "-3,-4"), ("reference", "t^2, sin(t)")];
    for code in [decoupled(&[&TIME[..], &keys].concat()), axes(&[&TIME[..], &keys].concat())] {
        let mut controller = started(&code);
        let at = |controller: &mut Instance, k: f64| {
            let given = [("k", &[k][..]), ("x", &[1.0, 0.5, -1.0, 2.0])];
            controller.call("step", &given).results["u"].clone()
        };
        let first = [0.0, 7.0, 64.0].map(|k| at(&mut controller, k));
        controller.call("arm", &[("k", &[100.0])]);
        assert_eq!([100.0, 107.0, 164.0].map(|k| at(&mut controller, k)), first);
        assert_ne!(first[0], first[1]);
    }
}

/// The command of a design gives it back.
#[test]
fn the_command_gives_the_references() {
    for reference in ["[\"t + sin(2*t)\", \"0\"]", "\"input\""] {
        let top = format!("sample_time = 0.25\nreference = {reference}");
        let plant = changed(&example("tank.toml"), &top, "");
        let chains = "n = 2\naxes = 2\nmu = \"exp(a=1)\"\n[params]\neps = 0.5\n";
        for text in [plant, changed(chains, &top, "")] {
            let wanted = spec(&text);
            let found = crate::command::spec_of(&wanted.command()).expect("a legal command");
            assert_eq!(found, wanted, "{}", wanted.command());
        }
    }
}
