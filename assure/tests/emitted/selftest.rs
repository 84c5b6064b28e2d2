//! Self-tests compile without a warning, pass, and fail where the controller is altered.

use crate::support;

use std::fs;
use std::path::{Path, PathBuf};

use ptc_codegen::emit::Language;
use ptc_codegen::generate_selftest;
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use support::specs::spec;
use support::{STRICT, c_compiler, folder, in_pairs, in_samples, run, write};

/// The self-test of `spec` in `folder`, linked with the controller there.
fn program(folder: &Path, spec: &Spec) -> PathBuf {
    let name = spec.name();
    for file in generate_selftest(spec).expect("a self-test") {
        fs::write(folder.join(file.name), file.text).expect("a file");
    }
    let main = format!(
        "#include \"{name}_selftest.h\"\n#include <stdio.h>\nint main(void)\n{{\n    const uint32_t \
         failures = {name}_selftest();\n    printf(\"%lu\", (unsigned long)failures);\n    return 0;\n}}\n"
    );
    fs::write(folder.join("main.c"), main).expect("a main program");
    let path = folder.join("program");
    let sources = ["main.c".to_owned(), format!("{name}.c"), format!("{name}_selftest.c")];
    run(c_compiler()
        .args(STRICT)
        .args(sources.map(|source| folder.join(source)))
        .arg("-o")
        .arg(&path)
        .arg("-lm"));
    path
}

fn failures(folder: &Path, spec: &Spec) -> u32 {
    let path = program(folder, spec);
    let told = run(&mut std::process::Command::new(path));
    String::from_utf8(told).expect("UTF-8").parse().expect("a number")
}

/// Controllers of every kind: what is latched, extern, fixed, bounded, single, trusted, iterated.
fn kinds() -> Vec<Spec> {
    let own = "-psi*xi1/(abs(xi1) - phi*abs(xi1_0))^2";
    let kinds: [&[(&str, &str)]; 31] = [
        &[("n", "2"), ("mu", "exp"), ("u_min", "runtime")],
        &[("n", "2"), ("mu", "rational"), ("u_max", "-1"), ("u_min", "-3"), ("poles", "-4,-5")],
        &[("n", "2"), ("mu", "exp"), ("u_min", "-inf"), ("guard", "result"), ("after", "zero")],
        &[("n", "3"), ("mu", "exp")],
        &[("n", "3"), ("mu", "tan"), ("in_flight", "true"), ("precision", "f32")],
        &[("n", "2"), ("mu", "power"), ("pi0", "-xi1 - xi2 + xi1_0"), ("in_flight", "true")],
        &[("n", "2"), ("mu", "soft"), ("axes", "2"), ("in_flight", "true"), ("guard", "none")],
        &[("n", "4"), ("mu", "rational"), ("precision", "f32")],
        &[("n", "2"), ("mu", "exp_sum")],
        &[("n", "3"), ("mu", "tan"), ("guard", "result")],
        &[("n", "3"), ("mu", "power"), ("guard", "none"), ("u_max", "inf")],
        &[
            ("n", "1"),
            ("mu", "exp(a=1)"),
            ("pi0", own),
            ("params.psi", "[1,20]"),
            ("params.phi", "1.1"),
        ],
        &[("n", "2"), ("mu", "algebraic"), ("pi0", "extern"), ("after", "extern")],
        &[("n", "3"), ("kappa", "dt/(a*(tau - dt)) + dt"), ("g", "-0.5"), ("after", "zero")],
        &[("n", "2"), ("mu", "tanh"), ("g", "x1"), ("precision", "f32"), ("after", "extern")],
        &[
            ("n", "2"),
            ("mu", "exp(a=1)"),
            ("gains", "12,7"),
            ("tau", "0.8"),
            ("eps", "0.01"),
            ("u_max", "4"),
        ],
        &[("n", "9"), ("kappa", "tau*dt/(tau - dt) + dt")],
        // Coefficients that leave single precision while u is kept within its bound.
        &[
            ("n", "6"),
            ("mu", "power(a=0.5,m=3)"),
            ("precision", "f32"),
            ("guard", "result"),
            ("u_max", "25"),
            ("poles", "-9,-10,-11,-12,-13,-14"),
            ("after", "extern"),
        ],
        // A law of stretched time, which an iteration finds.
        &[("n", "6"), ("mu", "exp_sum(2)"), ("tau", "1.75"), ("pi0", "extern")],
        // A g that is 0 in doubles where x1 is great.
        &[
            ("n", "2"),
            ("kappa", "atanh(dt/tau)"),
            ("poles", "-7,-3"),
            ("reference", "sin(t)"),
            ("g", "exp(-x1*x1)"),
            ("guard", "none"),
            ("allow", "growth,sampling,deadline,loop,envelope"),
        ],
        // Gains at eps that leave single precision.
        &[("n", "7"), ("mu", "exp"), ("precision", "f32"), ("tau", "49"), ("eps", "1e-9")],
        // 1 - T/tau at the start, where tau times its inverse is not 1.
        &[
            ("n", "6"),
            ("mu", "algebraic"),
            ("axes", "3"),
            ("g", "[1/(m1+m2),2,1/m]"),
            ("fma", "true"),
            ("u_max", "50"),
            ("params.m", "[0.5,3]"),
            ("sample_time", "0.003"),
        ],
        // Deadlines beyond the range, or next to the start.
        &[
            ("n", "1"),
            ("mu", "tau*(1 - exp(-a*t))"),
            ("precision", "f32"),
            ("u_max", "25"),
            ("pi0", "extern"),
            ("after", "zero"),
        ],
        // Every function of the law, and roots of 0, whose slope is infinite.
        &[
            ("n", "2"),
            ("mu", "exp"),
            ("pi0", "-asin(0.9*tanh(xi1)) - acos(0.9*tanh(xi2)) - cbrt(xi1) - atan2(xi2, xi1)"),
            ("g", "1 + hypot(x1, x2)"),
        ],
        &[("n", "2"), ("mu", "exp"), ("pi0", "-xi1 - sqrt(abs(xi2))"), ("precision", "f32")],
        // Sums that are 0 at the deadline, in closed forms of kappa and within an iteration.
        &[("n", "2"), ("mu", "tau*ln(2 - exp(-t))/ln(2)")],
        &[("n", "3"), ("mu", "tau*((2 - exp(-t))^1.3 - 1)/(2^1.3 - 1)")],
        &[("n", "2"), ("mu", "tau*(atan(2 - exp(-a*t)) - atan(1))/(atan(2) - atan(1))")],
        &[("n", "2"), ("mu", "tau*(1 - exp(-t))^1.5"), ("allow", "membership")],
        &[("n", "2"), ("mu", "tau*sin(1 - exp(-t))/sin(1)")],
        &[("n", "2"), ("mu", "tau*(exp(t/(1 + t)) - 1)/(exp(1) - 1)"), ("precision", "f32")],
    ];
    let named = |(index, keys): (usize, &&[(&str, &str)])| {
        let name = format!("kind{index}");
        let mut keys = keys.to_vec();
        keys.push(("name", &name));
        spec(&keys)
    };
    kinds.iter().enumerate().map(named).collect()
}

#[test]
fn self_tests_pass() {
    let (home, kinds) = (
        folder("selftest"),
        [kinds(), in_samples::controllers(), in_samples::of_inputs()].concat(),
    );
    let counts = in_pairs(&kinds, |spec| {
        let folder = home.join(spec.name());
        fs::create_dir_all(&folder).expect("a folder");
        write(&folder, spec, Language::C);
        failures(&folder, spec)
    });
    for (spec, count) in kinds.iter().zip(counts) {
        assert_eq!(count, 0, "{}", spec.command());
    }
}

#[test]
fn an_altered_controller_fails() {
    let home = folder("selftest_altered");
    let altered = [
        (&[("n", "2"), ("mu", "rational")][..], "= -K2;", "= K2;"),
        (&[("n", "2"), ("mu", "exp")], " && PTC_FINITE_F64(x[1])", ""),
        (&[("n", "2"), ("mu", "exp")], "(past < self->hold_from) ? past : self->hold_from", "past"),
        (&[("n", "2"), ("mu", "exp")], "*u = self->u_max;", "*u = 2.0 * self->u_max;"),
        (&[("n", "2"), ("mu", "exp")], "(v > self->u_max)", "(v > (1.6 * self->u_max))"),
        (&[("n", "2"), ("mu", "exp")], "(v < -self->u_max)", "(v < (-1.6 * self->u_max))"),
        (&[("n", "2"), ("mu", "exp")], "PTC_FINITE_F64(deadline)", "PTC_FINITE_F64(t0)"),
        (&[("n", "2"), ("mu", "exp_sum"), ("pi0", "extern")], "(y + v20)", "y"),
        (&[("n", "2"), ("mu", "exp")], "&& (eps < tau)", ""),
        (&[("n", "2"), ("mu", "tan")], "const double c2_2 =", "const double c2_2 = 1e-12 + "),
        (
            &[("n", "2"), ("mu", "exp"), ("pi0", "extern")],
            "pi0(context, xi",
            "pi0((context == NULL) ? context : NULL, xi",
        ),
        (
            &[("n", "1"), ("mu", "exp"), ("after", "zero")],
            "if (past >= 0.0) {",
            "if (past >= 1.0) {",
        ),
    ];
    altered_fail(&home, &altered);
}

#[test]
fn an_altered_controller_in_samples_fails() {
    let stage = |more: &[(&'static str, &'static str)]| [&in_samples::STAGE[..], more].concat();
    let fixed = stage(&in_samples::FIXED);
    let open = [("n", "2"), ("mu", "exp"), ("clock", "samples"), ("name", "stage")];
    let alone = stage(&[("what", "observer"), ("observer_samples", "30")]);
    let altered = [
        (&fixed[..], "k - self->start", "k"),
        (&fixed, "self->start = k", "self->start = k + 1U"),
        (&fixed, "self->u1 = u_now", "self->u1 = v"),
        (&fixed, "u_now = -STAGE_U_MAX", "u_now = STAGE_U_MAX"),
        (&fixed, "PTC_FINITE_F64(y[0])", "(y[0] < 1e300)"),
        (&fixed, "self->d_hat = d;", "self->d_hat = 0.5 * d;"),
        (&fixed, "self->seen = 1U", "self->seen = 0U"),
        (&fixed, "status = PTC_HOLD", "status = PTC_OK"),
        (&open[..], "(params->u_max > 0.0)", "(params->u_max > -1.0)"),
        (&open, "(params->samples > 1U)", "(params->samples > 0U)"),
        (&open, "(params->deadbeat >= 0.0)", "(params->deadbeat >= -2.0)"),
        (&alone, "PTC_FINITE_F64(u)", "(u < 1e300)"),
        (&alone, "self->u1 = u;", "self->u1 = 1.0;"),
    ];
    altered_fail(&folder("selftest_altered_samples"), &altered);
}

/// Keys of a design, and what replaces what in its C.
type Defect<'a> = (&'a [(&'a str, &'a str)], &'a str, &'a str);

/// Each defect put into a controller makes its self-test fail.
fn altered_fail(home: &Path, altered: &[Defect<'_>]) {
    for (index, (keys, good, bad)) in altered.iter().enumerate() {
        let (spec, folder) = (spec(keys), home.join(index.to_string()));
        fs::create_dir_all(&folder).expect("a folder");
        write(&folder, &spec, Language::C);
        let source = folder.join(format!("{}.c", spec.name()));
        let text = fs::read_to_string(&source).expect("the source");
        assert!(text.contains(*good), "{good} in {}\n{text}", spec.name());
        fs::write(&source, text.replacen(good, bad, 1)).expect("an altered source");
        assert!(failures(&folder, &spec) > 0, "{good} -> {bad}");
    }
}

#[test]
fn every_status_is_asked_for() {
    let text = generate_selftest(&spec(&[("n", "2"), ("mu", "exp"), ("after", "zero")]))
        .expect("a self-test")[1]
        .text
        .clone();
    use Status::{After, Hold, Input, Ok, Param, Range, Saturated};
    for status in [Ok, Hold, Saturated, After, Input, Param, Range] {
        let asked = [format!(".status = {}", status.c_name()), format!("!= {}", status.c_name())];
        assert!(asked.iter().any(|asked| text.contains(asked)), "{status:?}");
    }
}

/// Behind the guard `none` a u that is no number comes of legal numbers alone: of two terms that are
/// infinite.
#[test]
fn trusted_inputs_are_tried_up_to_their_ends() {
    let ends = [("guard", "none"), ("u_max", "25"), ("tau", "1.75")];
    let of_time =
        [("n", "2"), ("mu", "power(a=0.5,m=1.5)"), ("pi0", "extern"), ("after", "extern")];
    let of_state = [
        ("n", "1"),
        ("mu", "(tau*t/(1 + t) + tau*b*t/(1 + b*t))*(1/2)"),
        ("t0", "0.5"),
        ("eps", "0.001"),
        ("pi0", "-xi1 - xi1*abs(xi1) + xi1^3"),
    ];
    let home = folder("selftest_ends");
    for (index, keys) in [&of_time[..], &of_state].into_iter().enumerate() {
        let (spec, folder) = (spec(&[&ends, keys].concat()), home.join(index.to_string()));
        fs::create_dir_all(&folder).expect("a folder");
        write(&folder, &spec, Language::C);
        assert_eq!(failures(&folder, &spec), 0, "{}", spec.command());
        let source = folder.join(format!("{}_selftest.c", spec.name()));
        let text = fs::read_to_string(source).expect("the self-test");
        for status in [Status::Range, Status::Hold] {
            assert!(text.contains(&format!(".status = {}", status.c_name())), "{status:?}");
        }
    }
}
