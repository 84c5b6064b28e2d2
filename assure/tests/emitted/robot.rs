//! The functions of a robot in every language in which they are printed, against the interpreter.

use crate::support;

use std::fs;
use std::process::Command;

use ptc_assure::harness::cpp::{STRICT_CPP, cpp_compiler};
use ptc_codegen::code::Instance;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::{Language, emit_robot};
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Entry;
use ptc_codegen::robot::{self, Request, code};
use ptc_codegen::syntax::{Value, parse};
use ptc_codegen::urdf::Robot;
use support::folder;
use support::sampled::python_with;

/// A chain of all kinds of joints, with frames in general position.
const ARM: &str = r#"<robot name="arm">
<link name="base"/>
<link name="one"><inertial><origin xyz="0.1 0.02 -0.1" rpy="0.1 0.2 0.3"/><mass value="2"/>
<inertia ixx="0.03" iyy="0.02" izz="0.025" ixy="0.001" ixz="-0.002" iyz="0.0005"/></inertial></link>
<link name="two"><inertial><origin xyz="0 0.1 0.2"/><mass value="1.5"/>
<inertia ixx="0.013" iyy="0.012" izz="0.015" ixy="0" ixz="0.001" iyz="0"/></inertial></link>
<link name="three"><inertial><origin xyz="0.05 0 0.1"/><mass value="0.8"/>
<inertia ixx="0.003" iyy="0.002" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="first" type="revolute"><parent link="base"/><child link="one"/><origin xyz="0 0 0.3" rpy="0.2 -0.1 0"/><axis xyz="0 0 1"/></joint>
<joint name="second" type="prismatic"><parent link="one"/><child link="two"/><origin xyz="0.2 0 0" rpy="0 1.5708 0"/><axis xyz="0 1 0"/></joint>
<joint name="third" type="continuous"><parent link="two"/><child link="three"/><origin xyz="0 0.1 0.3"/><axis xyz="1 2 2"/></joint>
</robot>
"#;

const Q: [f64; 3] = [0.75, -0.25, 2.125];
const V: [f64; 3] = [1.125, 0.5, -3.0];
const A: [f64; 3] = [-2.0, 5.0, 0.375];

/// The functions of the arm, and what the interpreter computes, one after the other.
fn reference(precision: &str) -> (Request, Robot, Vec<f64>) {
    let pairs = [
        ("urdf", "arm.urdf"),
        ("rotor", "0.3"),
        ("damping", "0.7"),
        ("friction", "1.5"),
        ("what", "inverse-dynamics, mass-matrix, jacobian"),
        ("precision", precision),
    ];
    let entry = |(key, text): (&str, &str)| Entry {
        key: key.to_owned(),
        place: Place(0),
        value: parse(key, text, &mut |_| Place(0)).expect("a value"),
    };
    let mut entries = pairs.map(entry);
    entries[0].value.value = Value::File("arm.urdf".to_owned(), Ok(ARM.into()));
    let request = robot::read(&entries).expect("a request");
    let robot = request.robot().expect("a robot");
    let mut arm = Instance::new(&code(&request, &robot), &[]).expect("no parameters");
    let given = [("q", Q.as_slice()), ("v", V.as_slice()), ("a", A.as_slice())];
    let mut all = arm.call("inverse_dynamics", &given).results["torque"].clone();
    all.extend(&arm.call("mass_matrix", &given[..1]).results["mass"]);
    all.extend(&arm.call("jacobian", &given[..1]).results["j"]);
    (request, robot, all)
}

/// Writes the files of a language and a main program, runs the commands, and returns the numbers that it prints.
fn printed(
    language: Language,
    given: (&Request, &Robot),
    main: (&str, &str),
    commands: &mut [Command],
) -> Vec<f64> {
    let folder = folder(&format!("robot_{}_{}", language.name(), given.0.precision.name()));
    for file in emit_robot(given.0, given.1, language).expect("files") {
        fs::write(folder.join(&file.name), file.text).expect("writable");
    }
    let real = if given.0.precision == Precision::F32 {
        main.1.replace("double", "float").replace("f64", "f32")
    } else {
        main.1.to_owned()
    };
    fs::write(folder.join(main.0), real).expect("writable");
    let mut told = String::new();
    for command in commands {
        let done = command.current_dir(&folder).output().expect("a program");
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        told = String::from_utf8(done.stdout).expect("UTF-8");
    }
    told.split_whitespace().map(|word| word.parse().expect("a number")).collect()
}

fn in_shell(words: &str) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", words]);
    command
}

const C: &str = r#"#include "arm.h"
#include <stdio.h>
int main(void)
{
    const double q[3] = {Q}, v[3] = {V}, a[3] = {A};
    const arm_params none = {0};
    double torque[3], mass[9], j[18];
    arm own;
    if (arm_init(&own, &none) != PTC_OK || arm_inverse_dynamics(&own, q, v, a, torque) != PTC_OK
        || arm_mass_matrix(&own, q, mass) != PTC_OK || arm_jacobian(&own, q, j) != PTC_OK) {
        return 1;
    }
    for (int i = 0; i < 3; i++) { printf("%.17g ", (double)torque[i]); }
    for (int i = 0; i < 9; i++) { printf("%.17g ", (double)mass[i]); }
    for (int i = 0; i < 18; i++) { printf("%.17g ", (double)j[i]); }
    return 0;
}
"#;

const CPP: &str = r#"#include "arm.hpp"
#include <cstdio>
int main()
{
    ptc::Arm own;
    if (own.init({}) != ptc::Status::Ok) { return 1; }
    const std::array<double, 3> q{{Q}}, v{{V}}, a{{A}};
    for (auto value : own.inverse_dynamics(q, v, a).value) { std::printf("%.17g ", static_cast<decltype(1.0)>(value)); }
    for (auto value : own.mass_matrix(q).value) { std::printf("%.17g ", static_cast<decltype(1.0)>(value)); }
    for (auto value : own.jacobian(q).value) { std::printf("%.17g ", static_cast<decltype(1.0)>(value)); }
    return 0;
}
"#;

const RUST: &str = r#"#[path = "arm.rs"]
mod arm;
fn main() {
    let own = arm::Arm::new(arm::ArmParams {}).expect("no parameters");
    let (q, v, a): ([f64; 3], [f64; 3], [f64; 3]) = ([Q], [V], [A]);
    own.inverse_dynamics(&q, &v, &a).expect("finite").iter().for_each(|value| print!("{value:e} "));
    own.mass_matrix(&q).expect("finite").iter().for_each(|value| print!("{value:e} "));
    own.jacobian(&q).expect("finite").iter().for_each(|value| print!("{value:e} "));
}
"#;

const PYTHON: &str = r#"import numpy as np
from arm import Arm, Params
own = Arm(Params())
q, v, a = np.array([Q]), np.array([V]), np.array([A])
found = own.inverse_dynamics(np.stack([q, q]), np.stack([v, v]), a)
assert found.value.shape == (2, 3) and (found.status == 0).all()
for result in (found.value[1], own.mass_matrix(q).value, own.jacobian(q).value):
    print(*(repr(float(value)) for value in result))
assert own.jacobian([np.nan, 0.0, 0.0]).status == -2
"#;

fn filled(text: &str) -> String {
    let list = |values: [f64; 3], suffix: &str| {
        values.map(|value| format!("{value:?}{suffix}")).join(", ")
    };
    [("{Q}", Q), ("{V}", V), ("{A}", A), ("[Q]", Q), ("[V]", V), ("[A]", A)].iter().fold(
        text.to_owned(),
        |text, (name, values)| {
            let [open, close] = [&name[..1], &name[2..]];
            text.replace(name, &format!("{open}{}{close}", list(*values, "")))
        },
    )
}

fn close(found: &[f64], expected: &[f64], most: f64) -> bool {
    found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= most * b.abs().max(1.0))
}

#[test]
fn robots_compute_the_same_in_every_language() {
    for (precision, most) in [("f64", 1e-14), ("f32", 1e-5)] {
        let (request, robot, expected) = reference(precision);
        let given = (&request, &robot);
        let strict = "cc -std=c99 -O2 -Wall -Wextra -Werror -ffp-contract=off arm.c main.c -o program -lm && ./program";
        let found = printed(Language::C, given, ("main.c", &filled(C)), &mut [in_shell(strict)]);
        assert!(close(&found, &expected, most), "C {precision}: {found:?} {expected:?}");
        let mut compiler = cpp_compiler();
        compiler.args(STRICT_CPP).args(["main.cpp", "-o", "program"]);
        let found = printed(
            Language::Cpp,
            given,
            ("main.cpp", &filled(CPP)),
            &mut [compiler, in_shell("./program")],
        );
        assert!(close(&found, &expected, most), "C++ {precision}: {found:?} {expected:?}");
        let rust = "rustc --edition 2021 -O main.rs -o program && ./program";
        let found =
            printed(Language::Rust, given, ("main.rs", &filled(RUST)), &mut [in_shell(rust)]);
        assert!(close(&found, &expected, most), "Rust {precision}: {found:?} {expected:?}");
        if let Some(python) = python_with("import numpy") {
            let mut command = Command::new(python);
            command.arg("main.py");
            let found =
                printed(Language::Python, given, ("main.py", &filled(PYTHON)), &mut [command]);
            assert!(close(&found, &expected, most), "Python {precision}: {found:?} {expected:?}");
        }
    }
}
