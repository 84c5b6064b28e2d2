//! The C of a filter, call by call against the interpreter.

use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Stdio};

use ptc_codegen::code::Status;
use ptc_codegen::emit::Language;
use ptc_codegen::generate;

use super::filter::{instance, keys, step};
use super::flight::Draw;
use super::read;
use crate::support;

const MAIN: &str = r#"#include "own_filter.h"
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
    static own_filter c;
    own_filter_params params;
    uint32_t k;
    memset(&params, 0, sizeof params);
    if (own_filter_init(&c, &params) != PTC_OK) { return 1; }
    while (scanf("%" SCNu32, &k) == 1) {
        double x[2] = { number(), number() }, nominal = number(), u = 0.0;
        int status = own_filter_step(&c, k, x, nominal, &u);
        uint64_t bits;
        memcpy(&bits, &u, sizeof bits);
        printf("%d %" PRIx64 "\n", status, bits);
    }
    return 0;
}
"#;

#[test]
fn c_gives_the_bits_of_the_interpreter() {
    let more = [
        ("keep_below", "0.5, 0.8"),
        ("keep_above", "-0.5, -0.8"),
        ("keep_poles", "-10, -30"),
        ("u_max", "10"),
        ("delay", "1.25"),
        ("f", "-0.5"),
    ];
    let keys = keys("2", &more);
    let spec = read(&keys).expect("a legal design");
    let folder = support::folder("filter_in_c");
    for file in generate(&spec, Language::C).expect("a legal design") {
        std::fs::write(folder.join(file.name), file.text).expect("a file");
    }
    std::fs::write(folder.join("main.c"), MAIN).expect("a file");
    let warn = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off"];
    let built = Command::new("gcc")
        .args(warn)
        .args(["-o", "run", "main.c", "own_filter.c", "-lm"])
        .current_dir(&folder)
        .status();
    assert!(built.expect("gcc").success());
    let (mut own, mut draw) = (instance(&keys), Draw(8));
    let (mut given, mut wanted) = (String::new(), String::new());
    let mut seen = Vec::new();
    for k in 0..2000 {
        let mut x = [draw.between(-0.6, 0.6), draw.between(-1.0, 1.0)];
        if k % 97 == 0 {
            x[0] = f64::NAN;
        }
        let nominal = draw.between(-12.0, 12.0);
        let (u, status) = step(&mut own, k, &x, nominal);
        let _ = writeln!(
            given,
            "{k} {:x} {:x} {:x}",
            x[0].to_bits(),
            x[1].to_bits(),
            nominal.to_bits()
        );
        let _ = writeln!(wanted, "{} {:x}", status.number(), u.to_bits());
        seen.push(status);
    }
    for status in [Status::Ok, Status::Saturated, Status::Infeasible, Status::Input] {
        assert!(seen.contains(&status), "{status:?} was not met");
    }
    let mut run = Command::new(folder.join("run"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program");
    run.stdin.take().expect("its input").write_all(given.as_bytes()).expect("written");
    let output = run.wait_with_output().expect("its output");
    assert_eq!(String::from_utf8_lossy(&output.stdout), wanted);
}
