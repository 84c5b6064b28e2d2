//! The functions of a deadline in flight in the emitted C, compiled by gcc, against the interpreter: the same bits and
//! statuses for random calls.

use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Stdio};

use ptc_codegen::code::Instance;
use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::request::Spec;

use super::flight::Draw;
use super::read;
use crate::support;

const MAIN: &str = r#"#include "own.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
static double number(void) {
    uint64_t bits = 0;
    double value;
    if (scanf("%" SCNx64, &bits) != 1) { bits = 0; }
    memcpy(&value, &bits, sizeof value);
    return value;
}
int main(void) {
    static own c;
    own_params params;
    char call;
    memset(&params, 0, sizeof params);
    if (own_init(&c, &params) != PTC_OK) { return 1; }
    while (scanf(" %c", &call) == 1) {
        double a = number(), b = number(), result = 0.0;
        double pair[2] = { a, b };
        uint32_t count = 7U;
        int status = 0;
        switch (call) {
        case 's': status = own_step(&c, (uint32_t)a, &b, &result); break;
        case 'a': status = own_arm_for(&c, (uint32_t)a, (uint32_t)b); break;
        case 'n': status = own_soonest(&c, &count); result = count; break;
        case 'd': status = own_deadline(&c, &count); result = count; break;
        case 'm': status = own_move(&c, a); break;
        case 'x': status = own_assume(&c, pair); break;
        case 'f': status = own_assume_disturbance(&c, a); break;
        default: status = own_applied(&c, a); break;
        }
        uint64_t bits;
        memcpy(&bits, &result, sizeof bits);
        printf("%d %" PRIx64 "\n", status, bits);
    }
    return 0;
}
"#;

/// A call by its letter, the name of the function, and its two numbers.
type Call = (char, &'static str, [f64; 2]);

fn calls(draw: &mut Draw) -> Vec<Call> {
    let mut all = Vec::new();
    for k in 0..3000_u32 {
        let number = draw.between(-0.3, 0.3);
        let other = draw.between(-0.3, 0.3);
        let k = f64::from(k);
        match draw.between(0.0, 40.0).floor() {
            0.0 => all.push(('a', "arm_for", [k, draw.between(0.0, 400.0).floor()])),
            1.0 => all.push(('n', "soonest", [0.0; 2])),
            2.0 => all.push(('m', "move", [number, 0.0])),
            3.0 => all.push(('x', "assume", [number, other])),
            4.0 => all.push(('f', "assume_disturbance", [number, 0.0])),
            5.0 => all.push(('u', "applied", [number, 0.0])),
            6.0 => all.push(('s', "step", [k, f64::NAN])),
            _ => {}
        }
        all.push(('s', "step", [k, 0.2 * number]));
        all.push(('d', "deadline", [0.0; 2]));
    }
    all
}

/// What the interpreter gives: a line for each call.
fn interpreted(own: &mut Instance, calls: &[Call]) -> String {
    let mut lines = String::new();
    for (_, name, [a, b]) in calls {
        let (a, b) = ([*a], [*b]);
        let both = [a[0], b[0]];
        let given: Vec<(&str, &[f64])> = match *name {
            "step" => vec![("k", &a), ("y", &b)],
            "arm_for" => vec![("k", &a), ("samples", &b)],
            "move" => vec![("dx", &a)],
            "assume" => vec![("xhat", &both)],
            "assume_disturbance" => vec![("d", &a)],
            "applied" => vec![("u", &a)],
            _ => Vec::new(),
        };
        let outcome = own.call(name, &given);
        // A count that is not given stays as it was.
        let nothing = if *name == "soonest" { 7.0 } else { 0.0 };
        let result = outcome.results.values().next().map_or(nothing, |all| all[0]);
        let _ = writeln!(lines, "{} {:x}", outcome.status.number(), result.to_bits());
    }
    lines
}

/// What the emitted C prints with this `main`, compiled by gcc, for the calls in `text`.
pub(super) fn run(spec: &Spec, main: &str, text: String, name: &str) -> String {
    let folder = support::folder(name);
    for file in generate(spec, Language::C).expect("a legal design") {
        std::fs::write(folder.join(file.name), file.text).expect("a file");
    }
    std::fs::write(folder.join("main.c"), main).expect("a file");
    let built = Command::new("gcc")
        .args(["-std=c99", "-O2", "-ffp-contract=off", "-o", "run", "main.c", "own.c", "-lm"])
        .current_dir(&folder)
        .status();
    assert!(built.expect("gcc").success());
    let mut run = Command::new(folder.join("run"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("a program");
    let mut given = run.stdin.take().expect("a pipe");
    let writer = std::thread::spawn(move || given.write_all(text.as_bytes()).expect("a pipe"));
    let output = run.wait_with_output().expect("an end");
    writer.join().expect("all written");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn c_gives_the_bits_of_the_interpreter() {
    for late in ["extend", "clip"] {
        let keys = [
            ("name", "own"),
            ("n", "2"),
            ("mu", "exp(a=1)"),
            ("clock", "samples"),
            ("sample_time", "0.01"),
            ("tau", "1"),
            ("eps", "0.08"),
            ("u_max", "5"),
            ("poles", "least-energy"),
            ("poles_end", "least-energy(weight=1)"),
            ("end_samples", "30"),
            ("delay", "1"),
            ("measured", "[x1]"),
            ("disturbance", "constant"),
            ("observer_poles", "[-4, -5, -6]"),
            ("observer_samples", "40"),
            ("late", late),
            ("in_flight", "true"),
        ];
        let spec = read(&keys).expect("a legal design");
        let calls = calls(&mut Draw(5));
        let mut text = String::new();
        for (letter, _, [a, b]) in &calls {
            let _ = writeln!(text, "{letter} {:x} {:x}", a.to_bits(), b.to_bits());
        }
        let found = run(&spec, MAIN, text, &format!("flight_in_c_{late}"));
        let sampled = spec.sampled().expect("a clock in samples");
        let code = ptc_codegen::samples::controller(&spec, sampled, Vec::new());
        let mut own = Instance::new(&code, &[]).expect("legal parameters");
        let wanted = interpreted(&mut own, &calls);
        for (i, (found, wanted)) in found.lines().zip(wanted.lines()).enumerate() {
            assert_eq!(found, wanted, "{late}: call {i}, {:?}", calls[i]);
        }
        assert_eq!(found.lines().count(), calls.len());
        if late == "extend" {
            assert!(wanted.lines().any(|line| line.starts_with("5 ")), "never late");
        }
    }
}
