//! The sampled loop: the emitted C in it bit for bit, and what an actuator and a sensor add.

use crate::support;

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::reference::Status;
use ptc_codegen::simulate::{Loop, Sampled, Values};
use support::design;

/// t, x and u with the status of the controller.
type Seen = Vec<(f64, Vec<f64>, f64, Status)>;

fn run(text: &str, x0: &[f64], around: &Loop) -> Seen {
    let (spec, plant) = design(text);
    let values = Values::of(&spec, &plant);
    let mut seen = Vec::new();
    let end = Sampled::new(&spec, &plant).expect("a loop").run(&values, x0, around, &mut |s| {
        seen.push((s.t, s.x.to_vec(), s.u[0], s.status));
    });
    end.unwrap_or_else(|failure| panic!("{text}: {failure}"));
    seen
}

/// Returns the bits of u and the status that the emitted C gives for each call, from the exact bits of t and x.
fn in_c(name: &str, text: &str, calls: &Seen) -> Vec<(u64, i32)> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).expect("a folder");
    let (spec, _) = design(text);
    for file in generate(&spec, Language::C).expect("a controller") {
        fs::write(folder.join(&file.name), &file.text).expect("writable");
    }
    let n = spec.n;
    let real = if spec.precision == Precision::F32 { "float" } else { "double" };
    let main = format!(
        "#include \"axis.h\"\n#include <stdio.h>\nint main(void) {{\n\
         axis c; const axis_params p = {{ .t0 = 0.25 }}; double in[{n} + 1];\n\
         if (axis_init(&c, &p) != PTC_OK) return 1;\n\
         for (;;) {{ {real} x[{n}], u; int status;\n\
         for (int i = 0; i <= {n}; i++) if (scanf(\"%la\", &in[i]) != 1) return 0;\n\
         for (int i = 0; i < {n}; i++) x[i] = ({real})in[i + 1];\n\
         status = (int)axis_step(&c, ({real})in[0], x, &u);\n\
         printf(\"%a %d\\n\", (double)u, status); }} }}\n"
    );
    fs::write(folder.join("main.c"), main).expect("writable");
    let compiled = Command::new("cc")
        .args(["-std=c99", "-O2", "-ffp-contract=off", "-o", "run", "main.c", "axis.c", "-lm"])
        .current_dir(&folder)
        .status();
    assert!(compiled.expect("a C compiler").success());
    let mut lines = String::new();
    for (t, x, ..) in calls {
        std::iter::once(t).chain(x).for_each(|value| {
            let _ = write!(lines, "{} ", hexadecimal(*value));
        });
    }
    let mut child = Command::new(folder.join("run"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it runs");
    let mut stdin = child.stdin.take().expect("a pipe");
    let writer = std::thread::spawn(move || stdin.write_all(lines.as_bytes()).expect("it reads"));
    let output = child.wait_with_output().expect("it ends");
    writer.join().expect("written");
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let one = |line: &str| {
        let (u, status) = line.split_once(' ').expect("two words");
        (from_hexadecimal(u).to_bits(), status.parse().expect("a status"))
    };
    text.lines().map(one).collect()
}

/// As C's %a writes it.
fn hexadecimal(value: f64) -> String {
    let bits = value.to_bits();
    let (sign, exponent, part) = (
        if value.is_sign_negative() { "-" } else { "" },
        (bits >> 52) & 0x7ff,
        bits & ((1 << 52) - 1),
    );
    match exponent {
        0 if part == 0 => format!("{sign}0x0p+0"),
        0 => format!("{sign}0x0.{part:013x}p-1022"),
        _ => {
            format!("{sign}0x1.{part:013x}p{:+}", i64::try_from(exponent).expect("11 bits") - 1023)
        }
    }
}

fn from_hexadecimal(text: &str) -> f64 {
    let (sign, text) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (digits, exponent) = text.trim_start_matches("0x").split_once('p').expect("an exponent");
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let digit = |text: &str| u64::from_str_radix(&format!("0{text}"), 16).expect("digits");
    #[allow(clippy::cast_precision_loss)]
    let value = digit(whole) as f64
        + digit(part) as f64 / 16f64.powi(i32::try_from(part.len()).expect("short"));
    let exponent: i32 = exponent.parse().expect("a number");
    // In two steps, as 2^1074 is no double.
    sign * value * 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2)
}

const BASE: &str = "name = \"axis\"\ntau = 1.5\nallow = [\"growth\", \"sampling\", \"deadline\"]\n";

const PLANT: &str = "[plant]\nf = \"0.2*sin(3*t) - 0.1*x2 + bias\"\nbias = 0.05\n";

#[test]
fn the_controller_in_the_loop_is_the_emitted_c() {
    let mut seen = std::collections::BTreeSet::new();
    for (index, own) in [
        "n = 2\nmu = \"exp(a=1)\"\ngains = [12, 7]\neps = 0.02\nu_max = 4\n",
        "n = 2\nmu = \"exp(a=1)\"\ngains = [12, 7]\neps = 0.02\nu_max = 4\nu_min = -0.5\n",
        "n = 3\nmu = \"rational(a=2)\"\npoles = [-2, -3, -4]\neps = 0.05\nu_max = inf\nafter = \"zero\"\n",
        "n = 2\nmu = \"tanh(a=0.5)\"\npoles = [-5, -6]\ng = \"2 + x1^2\"\neps = 0.02\nu_max = 9\nprecision = \"f32\"\n",
        "n = 2\nmu = \"power(a=1,m=2)\"\npi0 = \"-3*xi1 - 4*xi2 - xi1_0*0\"\neps = 0.1\nu_max = 30\nguard = \"result\"\n",
    ]
    .into_iter()
    .enumerate()
    {
        let text = format!("{BASE}{own}{PLANT}");
        let around = Loop { period: 0.004, until: Some(1.1 * 1.5), ..Loop::default() };
        let (spec, plant) = design(&text);
        let mut calls = Vec::new();
        let values = Values::of(&spec, &plant).with(Parameter::StartTime, 0.25);
        let x0 = [1.0, -0.7, 0.3];
        Sampled::new(&spec, &plant)
            .expect("a loop")
            .run(&values, &x0[..spec.n], &around, &mut |s| {
                calls.push((s.t, s.x.to_vec(), s.u[0], s.status));
            })
            .unwrap_or_else(|failure| panic!("{text}: {failure}"));
        assert!(calls.len() > 400, "{}", calls.len());
        let found: Vec<_> = calls.iter().map(|(.., u, status)| (u.to_bits(), *status as i32)).collect();
        assert_eq!(found, in_c(&format!("sampled_{index}"), &text, &calls), "{text}");
        seen.extend(found.into_iter().map(|(_, status)| status));
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), [0, 1, 2, 3], "every status");
}

const STAGE: &str = "name = \"axis\"\nn = 2\nmu = \"exp(a=1)\"\ngains = [12, 7]\ntau = 1\nt0 = 0\neps = 0.02\nu_max = 4\n[plant]\nf = 0\n";

/// Between samples the double integrator moves along an exact parabola.
#[test]
fn u_is_held_between_samples() {
    let around = Loop { period: 0.01, ..Loop::default() };
    let seen = run(STAGE, &[1.0, 0.5], &around);
    assert_eq!(seen.len(), 101);
    for pair in seen.windows(2) {
        let ((t, x, u, _), (later, next, ..)) = (&pair[0], &pair[1]);
        let h = later - t;
        let wanted = [x[0] + h * (x[1] + h * u / 2.0), x[1] + h * u];
        for (found, wanted) in next.iter().zip(wanted) {
            assert!((found - wanted).abs() <= 1e-12, "{t}: {found} {wanted}");
        }
        assert!(u.abs() <= 4.0);
    }
    assert!(seen.iter().any(|(.., status)| *status == Status::Saturated));
}

/// With friction in proportion to the speed it moves along exponentials, from slow ones to those that end
/// within a sample, whatever t0 makes of the length of a sample.
#[test]
fn friction_between_samples_is_an_exponential() {
    for (friction, force, length) in [
        (0.7, 0.3, 0.01),
        (1e-9, -2.0, 0.01),
        (150.0, 0.3, 0.01),
        (2e4, 1e3, 0.02),
        (40.0, 0.0, 0.005),
    ] {
        let text = STAGE.replace("f = 0", &format!("f = \"{force} - {friction}*x2\""));
        for t0 in ["0", "1000"] {
            let text = text.replace("t0 = 0", &format!("t0 = {t0}"));
            let seen = run(&text, &[1.0, 0.5], &Loop { period: length, ..Loop::default() });
            for pair in seen.windows(2) {
                let ((t, x, u, _), (_, next, ..)) = (&pair[0], &pair[1]);
                let (ended, z) = (-(-friction * length).exp_m1() / friction, friction * length);
                // (h - ended)/friction; by its series where that would cancel.
                let series = 0.5 - z / 6.0 + z * z / 24.0;
                let rest =
                    if z < 1e-3 { length * length * series } else { (length - ended) / friction };
                let push = u + force;
                let wanted = [
                    x[0] + ended * x[1] + rest * push,
                    x[1] * (-friction * length).exp() + ended * push,
                ];
                let size = 1.0 + push.abs() * length;
                for (found, wanted) in next.iter().zip(wanted) {
                    let apart = (found - wanted).abs();
                    assert!(apart <= 1e-12 * size, "{text}\n{t}: {found} {wanted}");
                }
            }
        }
    }
}

#[test]
fn the_actuator_has_steps_and_may_be_late() {
    let plain = run(STAGE, &[0.1, 0.0], &Loop { period: 0.01, ..Loop::default() });
    let stepped = run(STAGE, &[0.1, 0.0], &Loop { period: 0.01, u_step: 0.25, ..Loop::default() });
    assert!(stepped.iter().all(|(.., u, _)| (u / 0.25).fract() == 0.0));
    assert!((stepped[0].2 - plain[0].2).abs() <= 0.125);
    assert_ne!(plain[0].2, stepped[0].2);
    let late = run(STAGE, &[0.1, 0.0], &Loop { period: 0.01, delay: 1.into(), ..Loop::default() });
    assert_eq!(late[0].2, 0.0, "nothing has been computed yet");
    assert_eq!(late[1].2.to_bits(), plain[0].2.to_bits());
}

#[test]
fn noise_is_what_its_seed_makes_it() {
    let noise = |seed| Loop { period: 0.01, noise: vec![1e-3, 1e-2], seed, ..Loop::default() };
    let [one, again, other] = [7, 7, 8].map(|seed| run(STAGE, &[0.1, 0.0], &noise(seed)));
    assert_eq!(one, again);
    assert_ne!(one, other);
    // u(0) = -(12 xi1 + 7 xi2) + x2 with xi2 = x2, tau = 1: what noise of these bounds moves it by.
    let plain = run(STAGE, &[0.1, 0.0], &Loop { period: 0.01, ..Loop::default() });
    let off = (one[0].2 - plain[0].2).abs();
    assert!(off > 0.0 && off <= 12.0 * 1e-3 + 7.0 * 1e-2, "{off}");
    // The stream is part of the promise: the first draws of this seed, for good.
    let first = one[0].2;
    assert!((first - FIRST).abs() < 1e-15, "{first:?}");
}

/// Noise so small that u is never clipped. Over many seeds x at the deadline varies by as much as the check `loop` says.
#[test]
fn random_noise_spreads_x_as_the_check_says() {
    let seeds = 600;
    let around = |seed| Loop { period: 0.01, noise_rms: vec![1e-7, 1e-6], seed, ..Loop::default() };
    let plain = run(STAGE, &[0.0, 0.0], &Loop { period: 0.01, ..Loop::default() });
    let centre = plain.last().expect("a run").1.clone();
    let mut squares = [0.0; 2];
    for seed in 0..seeds {
        let seen = run(STAGE, &[0.0, 0.0], &around(seed));
        let x = &seen.last().expect("a run").1;
        squares
            .iter_mut()
            .zip(x.iter().zip(&centre))
            .for_each(|(sum, (x, c))| *sum += (x - c).powi(2));
    }
    let (mut spec, _) = design(STAGE);
    let all = |text: &str| ptc_codegen::syntax::number(text).expect("a number");
    spec.promises.sample_time = Some(all("0.01"));
    spec.promises.x0_max = vec![all("1"), all("1")];
    spec.promises.noise_rms = vec![all("1e-7"), all("1e-6")];
    let worst = ptc_codegen::check::examine::examine(&spec).worst.expect("a loop");
    for (bound, sum) in worst.states.iter().zip(squares) {
        let spread = (sum / f64::from(seeds as u32)).sqrt();
        // 600 draws know a standard deviation to 3 %.
        assert!((spread / bound.rms - 1.0).abs() < 0.12, "{spread} {bound:?}");
    }
}

/// u(0) under the noise of seed 7.
const FIRST: f64 = -1.2017054025949903;

/// Between samples a mass with dry friction decelerates evenly, stops, and sticks or turns.
#[test]
fn dry_friction_sticks_between_samples() {
    let (friction, push) = (0.8, 0.1);
    let text = STAGE.replace("f = 0", &format!("f = \"{push} - {friction}*sign(x2)\""));
    let seen = run(&text, &[0.004, 0.03], &Loop { period: 0.01, ..Loop::default() });
    let mut at_rest = 0;
    for pair in seen.windows(2) {
        let ((t, x, u, _), (later, next, ..)) = (&pair[0], &pair[1]);
        let mut wanted = [x[0], x[1]];
        let mut left = later - t;
        let mut go = |wanted: &mut [f64; 2], a: f64, h: f64| {
            wanted[0] += h * (wanted[1] + h * a / 2.0);
            wanted[1] += h * a;
            left -= h;
            left
        };
        if x[1] != 0.0 {
            let a = u + push - friction * x[1].signum();
            let stop = -x[1] / a;
            let h = if stop > 0.0 { stop.min(later - t) } else { later - t };
            go(&mut wanted, a, h);
            if h == stop {
                wanted[1] = 0.0;
            }
        }
        let rest = go(&mut wanted, 0.0, 0.0);
        let force = u + push;
        if wanted[1] == 0.0 && force.abs() > friction {
            go(&mut wanted, force - friction * force.signum(), rest);
        }
        at_rest += usize::from(wanted[1] == 0.0);
        for (found, wanted) in next.iter().zip(wanted) {
            assert!((found - wanted).abs() <= 1e-11, "{t}: {found} {wanted}");
        }
    }
    assert!((5..95).contains(&at_rest), "it sticks and slips: {at_rest} of 100 samples");
}
