//! A deadline in flight of several axes in the emitted C, against the interpreter: the same bits and statuses for random
//! calls.

use std::fmt::Write as _;

use ptc_codegen::code::Instance;

use super::flight::Draw;
use super::{flight_in_c, read};

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
static void show(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    printf(" %" PRIx64, bits);
}
int main(void) {
    static own c;
    own_params params;
    char call;
    memset(&params, 0, sizeof params);
    if (own_init(&c, &params) != PTC_OK) { return 1; }
    while (scanf(" %c", &call) == 1) {
        const uint32_t k = (uint32_t)number(), samples = (uint32_t)number();
        double x[3][2], u[3] = { 0.0, 0.0, 0.0 };
        ptc_status axes[3] = { PTC_OK, PTC_OK, PTC_OK };
        uint32_t count = 7U;
        int status = 0;
        for (int i = 0; i < 3; i++) { x[i][0] = number(); x[i][1] = number(); }
        switch (call) {
        case 's': status = own_step(&c, k, x, u, axes); break;
        case 'a': status = ARM; break;
        case 'n': status = own_soonest(&c, x, &count); break;
        default: status = own_deadline(&c, &count); break;
        }
        printf("%d %d %d %d %u", status, axes[0], axes[1], axes[2], (unsigned)count);
        for (int i = 0; i < 3; i++) { show(u[i]); }
        printf("\n");
    }
    return 0;
}
"#;

/// A call by its letter, the name of the function, the tick, the samples and the states.
struct Call {
    letter: char,
    name: &'static str,
    counts: [f64; 2],
    x: [f64; 6],
}

fn calls(draw: &mut Draw) -> Vec<Call> {
    let mut all = Vec::new();
    let mut x = [0.0; 6];
    for k in 0..2000_u32 {
        let k = f64::from(k);
        // From time to time other states, and on the way to rest from them.
        let jumps = draw.between(0.0, 60.0) < 1.0;
        for value in &mut x {
            *value = if jumps { draw.between(-0.4, 0.4) } else { 0.97 * *value };
        }
        let samples = draw.between(0.0, 400.0).floor();
        let mut add = |letter, name, x| all.push(Call { letter, name, counts: [k, samples], x });
        match draw.between(0.0, 30.0).floor() {
            0.0 | 1.0 => add('a', "arm_for", x),
            2.0 | 3.0 => add('n', "soonest", x),
            4.0 => add('s', "step", [f64::NAN; 6]),
            5.0 => add('s', "step", [0.0, 0.0, 1e308, 1e308, 0.0, 0.0]),
            _ => {}
        }
        add('s', "step", x);
        add('d', "deadline", x);
    }
    all
}

/// What the interpreter gives: a line for each call.
fn interpreted(own: &mut Instance, calls: &[Call], refuses: bool) -> String {
    let mut lines = String::new();
    for Call { name, counts: [k, samples], x, .. } in calls {
        let (k, samples) = ([*k], [*samples]);
        let given: Vec<(&str, &[f64])> = match *name {
            "step" => vec![("k", &k), ("x", x)],
            "arm_for" if refuses => vec![("k", &k), ("samples", &samples), ("x", x)],
            "arm_for" => vec![("k", &k), ("samples", &samples)],
            "soonest" => vec![("x", x)],
            _ => Vec::new(),
        };
        let outcome = own.call(name, &given);
        let all = |key: &str, none: f64, count: usize| {
            outcome.results.get(key).cloned().unwrap_or_else(|| vec![none; count])
        };
        // A count that is not given stays as it was.
        let count = match *name {
            "soonest" => all("samples", 7.0, 1),
            "deadline" => all("k", 7.0, 1),
            _ => vec![7.0],
        };
        let _ = write!(lines, "{}", outcome.status.number());
        all("axes", 0.0, 3).iter().for_each(|own| write!(lines, " {own}").expect("text"));
        let _ = write!(lines, " {}", count[0]);
        for u in all("u", 0.0, 3) {
            let _ = write!(lines, " {:x}", u.to_bits());
        }
        lines.push('\n');
    }
    lines
}

#[test]
fn c_of_axes_gives_the_bits_of_the_interpreter() {
    for (late, pace) in [("extend", "deadline"), ("extend", "soonest"), ("refuse", "deadline")] {
        let keys = [
            ("name", "own"),
            ("n", "2"),
            ("axes", "3"),
            ("mu", "exp(a=1)"),
            ("clock", "samples"),
            ("sample_time", "0.01"),
            ("tau", "1"),
            ("eps", "0.08"),
            ("limits", "[5, [-8, 3], 20]"),
            ("poles", "[[-2, -3], [-3, -4], [-2, -3]]"),
            ("poles_end", "least-energy(weight=1)"),
            ("end_samples", "30"),
            ("g", "[1, 1/2, 3]"),
            ("state_max", "[[inf, 0.8], [1, 2], [inf, inf]]"),
            ("reserve", "0.05"),
            ("late", late),
            ("pace", pace),
        ];
        let spec = read(&keys).expect("a legal design");
        let refuses = late == "refuse";
        let arm =
            if refuses { "own_arm_for(&c, k, samples, x)" } else { "own_arm_for(&c, k, samples)" };
        let calls = calls(&mut Draw(15));
        let mut text = String::new();
        for Call { letter, counts, x, .. } in &calls {
            let _ = write!(text, "{letter}");
            for value in counts.iter().chain(x) {
                let _ = write!(text, " {:x}", value.to_bits());
            }
            text.push('\n');
        }
        let name = format!("flight_axes_in_c_{late}_{pace}");
        let found = flight_in_c::run(&spec, &MAIN.replace("ARM", arm), text, &name);
        let sampled = spec.sampled().expect("a clock in samples");
        let code = ptc_codegen::samples::controller(&spec, sampled, Vec::new());
        let mut own = Instance::new(&code, &[]).expect("legal parameters");
        let wanted = interpreted(&mut own, &calls, refuses);
        for (i, (found, wanted)) in found.lines().zip(wanted.lines()).enumerate() {
            assert_eq!(found, wanted, "{late} {pace}: call {i}, {}", calls[i].name);
        }
        assert_eq!(found.lines().count(), calls.len());
        let status = if refuses { "-4 " } else { "5 " };
        assert!(wanted.lines().any(|line| line.starts_with(status)), "never {status}");
        assert!(wanted.lines().any(|line| line.starts_with("-3 ")), "never out of range");
    }
}
