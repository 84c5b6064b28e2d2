//! Controllers with user-defined laws and mappings: C, Rust and the interpreter give the same
//! bits and statuses, for latched states, input gains, functions of the user's, and after the
//! deadline.

use crate::support;

use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, Program};
use ptc_codegen::request::{After, Feedback, Spec};
use support::optimised;
use support::program::{self, Record, in_c, in_rust};
use support::random::Random;
use support::specs::{rounded, spec};
use support::{STRICT, c_compiler, folder, in_pairs, run, write};

const RECORDS: usize = 400;

/// Only functions that every library rounds alike, so that bits can be compared.
fn specs() -> Vec<Spec> {
    let kinds: [&[(&str, &str)]; 16] = [
        &[
            ("n", "1"),
            ("mu", "exp(a=1)"),
            ("pi0", "-psi*xi1/(abs(xi1) - phi*abs(xi1_0))^2"),
            ("g", "1"),
        ],
        &[
            ("n", "2"),
            ("mu", "rational"),
            ("pi0", "-k1*xi1 - k2*xi2*abs(xi2) - sign(xi1)"),
            ("g", "2 + x1*x1/(1 + x1*x1)"),
        ],
        &[("n", "3"), ("mu", "tanh"), ("pi0", "extern"), ("after", "zero")],
        &[
            ("n", "2"),
            ("mu", "rational"),
            ("pi0", "-k1*xi1 - k2*xi2*abs(xi2) - sign(xi1)"),
            ("g", "2 + x1*x1/(1 + x1*x1)"),
            ("fma", "true"),
            ("latency", "true"),
        ],
        &[
            ("n", "2"),
            ("mu", "algebraic"),
            ("pi0", "max(min(-xi1 - xi2, 3), x1_0 - t0 - dt*T)"),
            ("after", "extern"),
        ],
        &[("n", "3"), ("kappa", "dt/(a*(tau - dt))"), ("g", "x1"), ("guard", "result")],
        &[("n", "4"), ("kappa", "dt/(a*(tau - dt)) + (dt/tau)^3"), ("guard", "none")],
        &[("n", "3"), ("mu", "tau*(1 - exp(-a*t))"), ("g", "-0.5"), ("precision", "f32")],
        &[
            ("n", "2"),
            ("mu", "mean(rational(a=1), rational(a=b))"),
            ("pi0", "-xi1 - 2*xi2*xi1_0"),
            ("precision", "f32"),
            ("after", "zero"),
        ],
        &[
            ("n", "2"),
            ("mu", "power(m=2)"),
            ("pi0", "extern"),
            ("after", "extern"),
            ("precision", "f32"),
        ],
        &[("n", "2"), ("mu", "exp"), ("g", "gain"), ("after", "zero"), ("u_max", "inf")],
        &[("n", "1"), ("mu", "tau*a*t/sqrt(1 + (a*t)^2)"), ("u_max", "inf")],
        &[
            ("n", "2"),
            ("mu", "exp"),
            ("tau", "2"),
            ("t0", "0"),
            ("eps", "0.01"),
            ("u_max", "5"),
            ("poles", "-4,-5"),
            ("params.a", "1"),
            ("g", "2"),
        ],
        &[
            ("n", "2"),
            ("mu", "exp"),
            ("pi0", "-asin(tanh(xi1)) - acos(tanh(xi2)) - cbrt(xi1)"),
            ("g", "1 + hypot(x1, x2)"),
        ],
        &[("n", "2"), ("mu", "exp"), ("pi0", "-xi1 - atan2(xi2, xi1) - cbrt(xi2)")],
        &[("n", "2"), ("mu", "exp"), ("pi0", "-xi1*hypot(xi1, xi2) - xi2"), ("precision", "f32")],
    ];
    kinds
        .iter()
        .enumerate()
        .map(|(index, keys)| {
            let name = format!("law{index}_of_mine");
            let mut keys = keys.to_vec();
            keys.push(("name", &name));
            spec(&keys)
        })
        .collect()
}

/// Returns true if u depends on the library in its last bit: by logarithms of an iteration, or functions of the law.
fn calls_a_library(spec: &Spec) -> bool {
    let law = match &spec.feedback {
        Feedback::Expression(law) => law.to_string(),
        _ => String::new(),
    };
    spec.is_iterated() || ["atan(", "asin(", "acos(", "cbrt("].iter().any(|call| law.contains(call))
}

fn records(spec: &Spec, random: &mut Random) -> Vec<Record> {
    let round = |value| rounded(value, spec.precision);
    let mut records = Vec::new();
    for _ in 0..RECORDS {
        let tau = if spec.fixed.contains_key(&Parameter::Tau) { 2.0 } else { 3.0 };
        let t0 = if spec.fixed.contains_key(&Parameter::StartTime) { 0.0 } else { 1.5 };
        let mut value = |p: Parameter| match p {
            Parameter::Tau => tau,
            Parameter::StartTime => t0,
            Parameter::Eps => 0.01,
            Parameter::UMax => 50.0,
            _ => random.between(0.5, 2.5),
        };
        let parameters: Vec<_> = spec.run_time_parameters().map(|p| round(value(p))).collect();
        let state = |random: &mut Random| match random.below(20) {
            0 => 0.0,
            1 => f64::NAN,
            _ => round(random.sign() * random.magnitude(1e-2, 10.0)),
        };
        let finite = |x: f64| if x.is_nan() { 1.0 } else { x };
        let latched = if spec.latches() { spec.n } else { 0 };
        let x0 = (0..latched).map(|_| finite(state(random))).collect();
        let trusting = spec.guard == ptc_codegen::request::Guard::None;
        let x = (0..spec.n)
            .map(|_| {
                let x = state(random);
                if trusting { finite(x) } else { x }
            })
            .collect();
        let t = round(
            t0 + tau
                * match random.below(6) {
                    0 => 1.0,
                    1 => 1.0 + random.magnitude(1e-3, 1e3),
                    2 => 1.0 - random.magnitude(1e-6, 1e-2),
                    3 => 0.0,
                    _ => random.between(0.0, 1.0),
                },
        );
        records.push(Record { parameters, x0, t, x });
    }
    records
}

/// Status and u: `-1` for what `init` refuses.
type Outcome = (i32, u64);

const LAW: [f64; 2] = [-1.5, 0.125];

/// The law that stands for a user's: -1.5 (xi_1 + ... + xi_n) + t/8.
fn user_law(arguments: &[f64], precision: Precision) -> f64 {
    let settle = |x| rounded(x, precision);
    let (time, xi) = arguments.split_last().expect("time comes last");
    let sum = xi.iter().fold(0.0, |sum, xi| settle(sum + settle(LAW[0] * xi)));
    settle(sum + settle(LAW[1] * time))
}

fn interpreted(program: &Program, spec: &Spec, record: &Record) -> Outcome {
    let parameter = |p: Parameter| {
        let at = spec.run_time_parameters().position(|own| own == p);
        at.map_or(0.0, |at| record.parameters[at])
    };
    let input = |input| match input {
        Input::Parameter(p) => parameter(p),
        Input::StartTime if spec.fixed.contains_key(&Parameter::StartTime) => 0.0,
        Input::StartTime => parameter(Parameter::StartTime),
        Input::Time => record.t,
        Input::State(j) => record.x[j - 1],
        Input::StateAtStart(j) => record.x0[j - 1],
        Input::Reference(_)
        | Input::ReferenceOf(..)
        | Input::Gain(_)
        | Input::Divisor
        | Input::Drift
        | Input::Control
        | Input::Wanted(_) => f64::NAN,
    };
    if spec.guard == ptc_codegen::request::Guard::Full && record.x.iter().any(|x| x.is_nan()) {
        return (-2, 0);
    }
    let law = |arguments: &[f64]| user_law(arguments, spec.precision);
    let mut interpreter = Interpreter::new(program, &input).with_law(&law);
    let mut u = interpreter.value(program.step);
    let limits = program.limits;
    let over = limits.past.is_some_and(|past| interpreter.value(past) >= 0.0);
    if over {
        u = if spec.after == After::Extern { -record.x[0] } else { 0.0 };
    }
    if spec.guard == ptc_codegen::request::Guard::Result && record.x.iter().any(|x| x.is_nan()) {
        return (-3, 0);
    }
    let held = interpreter.value(limits.late) >= interpreter.value(limits.hold_from);
    match limits.u_max.map(|limit| interpreter.value(limit)) {
        Some(limit) if u > limit => (2, limit.to_bits()),
        Some(limit) if u < -limit => (2, (-limit).to_bits()),
        _ if !u.is_finite() => (-3, 0),
        _ => (if over { 3 } else { i32::from(held) }, u.to_bits()),
    }
}

/// Status and u of `step`, or the status of `init` where it refused.
fn of(outcome: &program::Outcome) -> Outcome {
    match outcome.init {
        0 => (outcome.step.0, outcome.step.1.to_bits()),
        refused => (refused, 0),
    }
}

#[test]
fn languages_agree_on_laws_of_the_user() {
    let specs = specs();
    let home = folder("laws");
    let programs = in_c(&home, &specs).into_iter().zip(in_rust(&home, &specs));
    let indexed: Vec<_> = specs.iter().zip(programs).enumerate().collect();
    let seen = in_pairs(&indexed, |(index, (spec, (c, rust)))| {
        let records = records(spec, &mut Random(*index as u64));
        let [c, rust] = [c, rust].map(|side| side.run(&records).iter().map(of).collect::<Vec<_>>());
        let program = optimised(spec);
        for ((record, c), rust) in records.iter().zip(&c).zip(&rust) {
            if calls_a_library(spec) {
                assert_eq!(c.0, rust.0, "{spec:?}\n{record:?}");
                let (a, b) = (f64::from_bits(c.1), f64::from_bits(rust.1));
                assert!((a - b).abs() <= 1e-12 * a.abs(), "{a} {b}");
                continue;
            }
            assert_eq!(c, rust, "C and Rust: {spec:?}\n{record:?}");
            let wanted = interpreted(&program, spec, record);
            assert_eq!(*c, wanted, "C and the interpreter: {spec:?}\n{record:?}");
        }
        c.iter().map(|(status, _)| *status).collect::<std::collections::BTreeSet<_>>()
    });
    let seen: std::collections::BTreeSet<_> = seen.into_iter().flatten().collect();
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), [-3, -2, 0, 1, 2, 3], "every status but -1");
}

/// The associated system as it is emitted, run in stretched time from x0 and led back to the plant, against
/// the closed loop of the emitted controller run in time: two programs and two clocks.
#[test]
fn the_infinite_time_system_is_the_closed_loop() {
    let folder = folder("both_sides");
    let keys = [
        ("n", "2"),
        ("mu", "tanh(a=1)"),
        ("gains", "20,9"),
        ("tau", "2"),
        ("eps", "1e-6"),
        ("u_max", "inf"),
        ("t0", "0.25"),
        ("g", "2 + sin(x1)"),
        ("name", "swing"),
    ];
    let system = [&keys[..], &[("what", "associated")]].concat();
    let mut sources = Vec::new();
    for keys in [&keys[..], &system] {
        let files = write(&folder, &spec(keys), ptc_codegen::emit::Language::C);
        sources.extend(files.into_iter().filter(|file| file.extension().is_some_and(|e| e == "c")));
    }
    let main = folder.join("main.c");
    std::fs::write(&main, BOTH_SIDES).expect("a program");
    let program = folder.join("main");
    run(c_compiler()
        .args(STRICT)
        .arg("-I")
        .arg(&folder)
        .arg(&main)
        .args(&sources)
        .arg("-o")
        .arg(&program)
        .arg("-lm"));
    run(&mut std::process::Command::new(&program));
}

/// Runge and Kutta's method for both, whose error is some 1e-14 at these steps.
const BOTH_SIDES: &str = r#"
#include <math.h>
#include <stddef.h>
#include "swing.h"
#include "swing_associated.h"

static swing plant;
static swing_associated far;

static int moved(int stretched, double t, const double x[2], double rate[2])
{
    double u = 0.0;
    if (stretched) {
        return swing_associated_rate(&far, t, x, 0.0, rate) != PTC_OK;
    }
    const int failed = swing_step(&plant, t, x, &u) != PTC_OK;
    rate[0] = x[1];
    rate[1] = (2.0 + sin(x[0])) * u;
    return failed;
}

static int advance(int stretched, double t, double h, double x[2])
{
    double k[4][2];
    double y[2];
    int failed = moved(stretched, t, x, k[0]);
    for (int stage = 1; stage < 4; stage += 1) {
        const double part = (stage == 3) ? h : 0.5 * h;
        for (int i = 0; i < 2; i += 1) {
            y[i] = x[i] + part * k[stage - 1][i];
        }
        failed |= moved(stretched, t + part, y, k[stage]);
    }
    for (int i = 0; i < 2; i += 1) {
        x[i] += h / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
    }
    return failed;
}

int main(void)
{
    const double x0[2] = {0.8, -1.5};
    double x[2] = {0.8, -1.5};
    double xi[2];
    double back[2];
    double there = 0.0;
    double u = 0.0;
    double u_back = 0.0;
    const int steps = 20000;
    const double end = 1.5;
    int failed = swing_init(&plant, NULL) != PTC_OK || swing_associated_init(&far, NULL) != PTC_OK;
    failed |= swing_associated_start(&far, x0, xi) != PTC_OK;
    for (int k = 0; k < steps; k += 1) {
        failed |= advance(1, 0.25 + end * k / steps, end / steps, xi);
    }
    failed |= swing_associated_time(&far, 0.25 + end, &there) != PTC_OK;
    failed |= swing_associated_state(&far, 0.25 + end, xi, back) != PTC_OK;
    failed |= swing_associated_control(&far, 0.25 + end, xi, &u_back) != PTC_OK;
    /* mu(1.5) = 2 tanh(1.5). */
    failed |= fabs(there - (0.25 + 2.0 * tanh(1.5))) > 1e-15;
    for (int k = 0; k < steps; k += 1) {
        failed |= advance(0, 0.25 + (there - 0.25) * k / steps, (there - 0.25) / steps, x);
    }
    failed |= swing_step(&plant, there, x, &u) != PTC_OK;
    for (int i = 0; i < 2; i += 1) {
        failed |= !(fabs(back[i] - x[i]) <= 1e-12);
    }
    failed |= !(fabs(u_back - u) <= 1e-11 * fabs(u));
    /* What is no number is refused, and the state is 0. */
    const double wrong[2] = {NAN, 0.0};
    back[0] = 42.0;
    failed |= swing_associated_state(&far, 0.25, wrong, back) != PTC_E_INPUT;
    failed |= fabs(back[0]) > 0.0;
    back[1] = 42.0;
    failed |= swing_associated_state(&far, 0.25, NULL, back) != PTC_E_INPUT;
    failed |= fabs(back[1]) > 0.0;
    failed |= swing_associated_time(&far, 0.0, &there) != PTC_E_INPUT;
    failed |= swing_associated_start(&far, wrong, back) != PTC_E_INPUT;
    return failed;
}
"#;

/// The system hands xi to the user's law as it was given.
#[test]
fn the_infinite_time_system_calls_the_law_of_the_user() {
    let folder = folder("system");
    let keys = [("n", "2"), ("mu", "tanh"), ("what", "associated"), ("pi0", "extern")];
    for file in write(&folder, &spec(&keys), ptc_codegen::emit::Language::C) {
        if file.extension().is_some_and(|e| e == "c") {
            run(c_compiler().args(STRICT).arg("-c").arg(&file).arg("-o").arg(folder.join("s.o")));
        }
    }
}
