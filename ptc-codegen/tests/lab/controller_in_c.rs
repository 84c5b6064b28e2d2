//! The controller of a simulation against the emitted C, compiled by gcc: the same bits of u and the same status for
//! any call, legal or not, and the same parameters refused.

use std::fmt::Write;
use std::fs;
use std::io::Write as _;
use std::process::{Command, Stdio};

use ptc_codegen::check::examine::examine;
use ptc_codegen::code;
use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::plant::as_one;
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{Control, Controller, Values};

use crate::support::{QUADROTOR, UNICYCLE, design, example, folder};

/// The state at the start, where it is latched.
const START: [f64; 2] = [0.3, -0.7];

/// A call: of `arm` with a start and no state, or of `step` with a time and the states.
type Call = (f64, Option<Vec<f64>>);

/// The emitted C behind a main function that reads the bits of parameters and calls.
struct InC {
    folder: std::path::PathBuf,
    states: usize,
}

impl InC {
    #[track_caller]
    fn new(test: &str, spec: &Spec) -> Self {
        let (folder, name) = (folder(test), spec.name());
        for file in generate(spec, Language::C).expect("a legal design") {
            fs::write(folder.join(file.name), file.text).expect("a file");
        }
        let real = if spec.precision == Precision::F32 { "float" } else { "double" };
        let (one, _) = as_one(spec.clone(), None);
        let (m, states) = (one.input_names().len(), one.states());
        let several = spec.axes.is_some() || spec.coupled.is_some();
        let x = match spec.rows_of_axes() {
            Some((count, n)) => format!("x[{count}][{n}]"),
            None => format!("x[{states}]"),
        };
        let given = if several { "u, axes" } else { "&u[0]" };
        let start = if spec.latches() { ", start" } else { "" };
        let mut main = format!(
            "#include \"{name}.h\"\n#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n\
             static double number(void)\n{{\n    uint64_t bits = 0;\n    double value;\n\
             \x20   if (scanf(\"%\" SCNx64, &bits) != 1) {{ bits = 0; }}\n\
             \x20   memcpy(&value, &bits, sizeof value);\n    return value;\n}}\n\
             int main(void)\n{{\n    static {name} c;\n    {name}_params p;\n    char call;\n\
             \x20   {real} {x}, u[{m}];\n    ptc_status axes[{m}];\n\
             \x20   const {real} start[2] = {{ ({real}){}, ({real}){} }};\n\
             \x20   memset(&p, 0, sizeof p);\n    (void)axes, (void)start;\n",
            START[0], START[1]
        );
        for parameter in spec.run_time_parameters() {
            let _ = writeln!(main, "    p.{} = ({real})number();", parameter.key());
        }
        let _ = write!(
            main,
            "    if ({name}_init(&c, &p{start}) != PTC_OK) {{ puts(\"refused\"); return 0; }}\n\
             \x20   while (scanf(\" %c\", &call) == 1) {{\n        {real} t = ({real})number();\n\
             \x20       int status;\n        memset(u, 0, sizeof u);\n        if (call == 'a') {{\n\
             \x20           status = (int){name}_arm(&c, t{start});\n        }} else {{\n\
             \x20           for (int i = 0; i < {states}; i++) {{ (({real} *)x)[i] = ({real})number(); }}\n\
             \x20           status = (int){name}_step(&c, t, x, {given});\n        }}\n\
             \x20       printf(\"%d\", status);\n        for (int i = 0; i < {m}; i++) {{\n\
             \x20           uint64_t bits;\n            double value = (double)u[i];\n\
             \x20           memcpy(&bits, &value, sizeof bits);\n            printf(\" %\" PRIx64, bits);\n\
             \x20       }}\n        puts(\"\");\n    }}\n    return 0;\n}}\n"
        );
        fs::write(folder.join("main.c"), main).expect("a file");
        let built = Command::new("gcc")
            .args(["-std=c99", "-O1", "-ffp-contract=off", "-o", "run", "main.c"])
            .args([&format!("{name}.c"), "-lm"])
            .current_dir(&folder)
            .output()
            .expect("gcc");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        Self { folder, states }
    }

    /// Returns a line for each call, or one that `init` refuses the parameters.
    fn lines(&self, given: &[f64], calls: &[Call]) -> Vec<String> {
        let mut text = String::new();
        let bits = |value: &f64| format!(" {:x}", value.to_bits());
        given.iter().for_each(|value| text += &bits(value));
        for (t, x) in calls {
            text += if x.is_some() { " s" } else { " a" };
            std::iter::once(t).chain(x.iter().flatten()).for_each(|value| text += &bits(value));
        }
        let mut child = Command::new(self.folder.join("run"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("it runs");
        let mut stdin = child.stdin.take().expect("a pipe");
        // It does not read the calls of one that is refused.
        let writer = std::thread::spawn(move || drop(stdin.write_all(text.as_bytes())));
        let output = child.wait_with_output().expect("it ends");
        writer.join().expect("written");
        String::from_utf8(output.stdout).expect("text").lines().map(str::to_owned).collect()
    }
}

/// The number of a status in C.
fn number(status: Status) -> i32 {
    use code::Status::{After, Hold, Input, Ok, Range, Saturated};
    let all = [Ok, Hold, Saturated, After, Input, Range];
    let own = all.into_iter().find(|own| Status::from(*own) == status);
    own.expect("a status of `step`").number()
}

/// The same lines of the simulated controller.
fn simulated(spec: &Spec, values: &Values, calls: &[Call]) -> Vec<String> {
    let (one, _) = as_one(spec.clone(), None);
    let mut controller = Controller::new(&one).expect("a controller");
    if controller.init(values, &START).is_err() {
        return vec!["refused".to_owned()];
    }
    let m = one.input_names().len();
    let line = |(t, x): &Call| {
        let (u, status) = match x {
            Some(x) => {
                let (u, status) = controller.step(*t, x);
                (u.to_vec(), number(status))
            }
            None => (vec![0.0; m], if controller.arm(*t, &START) { 0 } else { -1 }),
        };
        u.iter().fold(status.to_string(), |line, u| format!("{line} {:x}", u.to_bits()))
    };
    calls.iter().map(line).collect()
}

/// Pseudo-random numbers from a linear congruence.
struct Draw(u64);

impl Draw {
    /// A number between -1 and 1.
    fn even(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 33).expect("31 bits")) / f64::from(1_u32 << 30) - 1.0
    }

    fn of(&mut self, all: &[f64]) -> f64 {
        let place = (self.0 >> 40) as usize % all.len();
        self.even();
        all[place]
    }
}

const ODD: [f64; 12] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    f64::MAX,
    -1e300,
    1e39,
    -1e30,
    5e-324,
    1e-310,
    1e-45,
];

/// Calls around the start and the deadline, of which some have odd times, states, or both, and some arm again.
fn calls(states: usize, times: [f64; 2], scale: f64) -> Vec<Call> {
    let [t0, tau] = times;
    let mut draw = Draw(7);
    let mut start = t0;
    let mut all = Vec::new();
    for index in 0..1500 {
        if index % 300 == 299 {
            let next = draw.of(&[f64::NAN, f64::INFINITY, t0 + 0.5, f64::MAX, t0]);
            all.push((next, None));
            start = if next.abs() < 1e30 { next } else { start };
        }
        let edges = [start, start.next_down(), start + tau, (start + tau).next_down(), start + 1e9];
        let t = match index % 7 {
            0 => draw.of(&edges),
            1 if index % 3 == 0 => draw.of(&ODD),
            _ => start + tau * (0.55 + 0.6 * draw.even()),
        };
        let mut x: Vec<_> = (0..states).map(|_| scale * draw.even()).collect();
        if index % 5 == 0 {
            let place = index % states;
            x[place] = draw.of(&ODD);
        }
        all.push((t, Some(x)));
    }
    all
}

/// Compares every line of a design whose parameters are fixed; how often each status was met.
fn agree(test: &str, text: &str, scale: f64, met: &mut [usize; 7]) {
    let (spec, plant) = design(text);
    let spec = examine(&spec).spec;
    let values = Values::of(&spec, &plant);
    let in_c = InC::new(test, &spec);
    let [t0, tau] = [Parameter::StartTime, Parameter::Tau].map(|own| values.get(own));
    let calls = calls(in_c.states, [t0, tau], scale);
    let given: Vec<_> = spec.run_time_parameters().map(|own| values.get(own)).collect();
    let [emitted, simulated] = [in_c.lines(&given, &calls), simulated(&spec, &values, &calls)];
    assert_eq!(emitted.len(), calls.len(), "{text}");
    for ((emitted, simulated), call) in emitted.iter().zip(&simulated).zip(&calls) {
        assert_eq!(emitted, simulated, "{call:?} of\n{text}");
        let status: i32 = emitted.split(' ').next().expect("a status").parse().expect("a number");
        met[usize::try_from(status + 3).expect("a status")] += 1;
    }
}

#[test]
fn one_input_gives_the_bits_of_c_with_every_frame() {
    let mut met = [0; 7];
    for guard in ["none", "result", "full"] {
        for after in ["hold", "zero"] {
            for (limit, limits) in
                ["u_max = inf", "u_max = 3", "u_max = 3\nu_min = -1"].iter().enumerate()
            {
                let precision =
                    if (limit + guard.len() + after.len()) % 2 == 0 { "f32" } else { "f64" };
                let text = format!(
                    "name = \"ctl\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nguard = \"{guard}\"\nafter = \"{after}\"\n\
                     precision = \"{precision}\"\n[params]\ntau = 1\nt0 = 0.25\neps = 0.02\n{limits}\n"
                );
                agree(&format!("{guard}_{after}_{limit}"), &text, 1.5, &mut met);
            }
        }
    }
    let latched = "name = \"ctl\"\nn = 2\nmu = \"exp(a=1)\"\npi0 = \"-20*xi1 - 9*xi2 - xi2_0\"\n[params]\n\
                   tau = 1\nt0 = 0.25\neps = 0.02\nu_max = 30\n";
    agree("latched", latched, 1.5, &mut met);
    // E_RANGE, E_INPUT, E_PARAM, OK, HOLD, SATURATED and AFTER.
    for (place, met) in met.iter().enumerate() {
        assert!(*met > 20, "{met} at {place}");
    }
}

#[test]
fn several_inputs_give_the_bits_of_c() {
    let arm = example("two_link.toml");
    let shared = "name = \"shared\"\nn = 2\naxes = 2\nmu = \"rational(a=1)\"\npoles = [-4, -5]\n[params]\n\
                  tau = 1\nt0 = 0\neps = 0.01\nu_max = inf\n";
    let gantry = example("gantry.toml");
    let mut met = [0; 7];
    for (test, text, scale) in [
        ("two_link", arm.clone(), 3.0),
        (
            "two_link_result",
            arm.replace("name =", "guard = \"result\"\nprecision = \"f32\"\nname ="),
            3.0,
        ),
        ("barrier", example("barrier_arm.toml"), 1.5),
        ("tank", example("tank.toml"), 30.0),
        ("unicycle", UNICYCLE.to_owned(), 2.0),
        ("unicycle_limited", UNICYCLE.replace("u_max = inf", "u_max = 12"), 2.0),
        ("quadrotor", QUADROTOR.to_owned(), 1.0),
        ("quadrotor_f32", QUADROTOR.replace("name =", "precision = \"f32\"\nname ="), 2.0),
        ("gantry", gantry.clone(), 4.0),
        ("gantry_none", gantry.replace("name =", "guard = \"none\"\nname ="), 4.0),
        ("shared", shared.to_owned(), 1e300),
    ] {
        agree(test, &text, scale, &mut met);
    }
    // No law follows the deadline.
    for place in [0, 1, 2, 3, 4, 5] {
        assert!(met[place] > 10, "{} at {place}", met[place]);
    }
}

#[test]
fn parameters_are_refused_as_in_c_and_the_message_names_one() {
    let text = "name = \"ctl\"\nn = 2\nmu = \"tanh\"\ngains = [6, 5]\nu_min = \"runtime\"\nafter = \"zero\"\n\
                allow = [\"growth\"]\n";
    let (spec, plant) = design(text);
    let in_c = InC::new("open", &spec);
    let legal = [
        (Parameter::Tau, 1.0),
        (Parameter::StartTime, 0.25),
        (Parameter::Eps, 0.02),
        (Parameter::UMax, 3.0),
        (Parameter::UMin, -2.0),
        (Parameter::A, 1.5),
    ];
    let values = |changed: Option<(Parameter, f64)>| {
        let all = legal.into_iter().chain(changed);
        all.fold(Values::of(&spec, &plant), |values, (own, value)| values.with(own, value))
    };
    let (t0, tau) = (0.25, 1.0);
    let calls = calls(2, [t0, tau], 1.5);
    let given = |values: &Values| -> Vec<_> {
        spec.run_time_parameters().map(|own| values.get(own)).collect()
    };
    assert_eq!(in_c.lines(&given(&values(None)), &calls), simulated(&spec, &values(None), &calls));
    let mut refused = 0;
    for (parameter, _) in legal {
        for value in ODD.into_iter().chain([-1.0, 1.0, 2.0, 1e-160, 1e160, 1e-120, 1e120]) {
            let values = values(Some((parameter, value)));
            let emitted = in_c.lines(&given(&values), &[(0.5, Some(vec![0.1, 0.2]))]);
            let mut controller = Controller::new(&spec).expect("a controller");
            let begun = controller.init(&values, &[]);
            assert_eq!(emitted == ["refused"], begun.is_err(), "{parameter:?} = {value}");
            let Err(failure) = begun else { continue };
            refused += 1;
            let names = failure.message.contains(" = ") || failure.message.contains("coefficient");
            assert!(names, "{parameter:?} = {value}: {failure}");
        }
    }
    assert!(refused > 40, "{refused}");
    let late = Controller::new(&spec)
        .expect("a controller")
        .init(&values(Some((Parameter::Eps, 2.0))), &[]);
    assert!(late.expect_err("eps above tau").message.starts_with("eps = 2 is outside"));
}
