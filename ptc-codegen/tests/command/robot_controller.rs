//! The controller of a robot as it is emitted, compiled and run.

use crate::support;

use std::fs;
use std::path::Path;
use std::process::Command;

use support::{example, folder, run_in};

/// The arm of the example `two_link.toml`, whose joints have names that are no identifiers.
const ARM: &str = r#"<robot name="two link">
<link name="wall"/>
<link name="upper/arm"><inertial><origin xyz="0.6 0 0"/><mass value="2"/>
<inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="for"><inertial><origin xyz="0.5 0 0"/><mass value="1.5"/>
<inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="*/ Schulter-1ä" type="revolute"><parent link="wall"/><child link="upper/arm"/><axis xyz="0 0 2"/></joint>
<joint name="int" type="continuous"><parent link="upper/arm"/><child link="for"/><origin xyz="0.6 0 0"/><axis xyz="0 0 1"/></joint>
</robot>
"#;

const MAIN: &str = r#"#include "of_model.h"
#include "of_robot.h"
#include <math.h>
#include <stdio.h>
int main(void)
{
    const of_model_params model_params = {0};
    const of_robot_params robot_params = {0};
    of_model model;
    of_robot robot;
    if (of_model_init(&model, &model_params) != PTC_OK || of_robot_init(&robot, &robot_params) != PTC_OK) { return 1; }
    for (int k = 0; k < 40; k++) {
        const double t = 0.5 * k;
        const double x[4] = {0.7 - 0.02 * k, 1.9 - 0.07 * k, 1.1 * sin(k), 0.9 * cos(2.0 * k)};
        double u[2], own[2];
        ptc_status axes[2];
        if (of_model_step(&model, t, x, u, axes) < 0 || of_robot_step(&robot, t, x, own, axes) < 0) { return 2; }
        const double size = fabs(u[0]) + fabs(u[1]);
        if (!(fabs(u[0] - own[0]) + fabs(u[1] - own[1]) <= 4e-15 * size)) { printf("%g %g\n", u[0] - own[0], u[1] - own[1]); return 3; }
        printf("%.17g %.17g\n", own[0], own[1]);
    }
    return 0;
}
"#;

const MAIN_IN_RUST: &str = r#"#[allow(dead_code, unexpected_cfgs)]
mod of_robot;
fn main() {
    let robot = of_robot::OfRobot::new(of_robot::OfRobotParams {}).expect("no parameters");
    for k in 0..40 {
        let at = f64::from(k);
        let x = [0.7 - 0.02 * at, 1.9 - 0.07 * at, 1.1 * at.sin(), 0.9 * (2.0 * at).cos()];
        let [first, second] = robot.step(0.5 * at, &x).u;
        println!("{first:?} {second:?}");
    }
}
"#;

fn emit(folder: &Path, words: &[&str]) {
    let (code, _, told) = run_in(folder, &[&["emit"], words, &["-o", "."]].concat());
    assert_eq!(code, Some(0), "{told}");
}

fn shell(folder: &Path, script: &str) -> String {
    let done = Command::new("sh").args(["-c", script]).current_dir(folder).output();
    let done = done.expect("a shell");
    let told = String::from_utf8_lossy(&done.stdout).into_owned();
    assert!(done.status.success(), "{told}{}", String::from_utf8_lossy(&done.stderr));
    told
}

#[test]
fn c_and_rust_give_the_torques_of_inertia_and_bias() {
    let folder = folder("torques");
    let text = example("two_link.toml");
    let (head, _) = text.split_once("[params]").expect("parameters");
    let robot = format!(
        "{head}[params]\ntau = 20\neps = 1\n[robot]\nurdf = \"arm.urdf\"\ngravity = [0, -9.81, 0]\n"
    );
    fs::write(folder.join("arm.urdf"), ARM).expect("writable");
    fs::write(folder.join("model.toml"), text).expect("writable");
    fs::write(folder.join("robot.toml"), robot).expect("writable");
    fs::write(folder.join("main.c"), MAIN).expect("writable");
    fs::write(folder.join("main.rs"), MAIN_IN_RUST).expect("writable");
    let start = ["--t0", "0", "--lang", "c", "--name"];
    emit(&folder, &[&["model.toml"], &start[..], &["of_model"]].concat());
    emit(&folder, &[&["robot.toml"], &start[..], &["of_robot"]].concat());
    emit(&folder, &["robot.toml", "--t0", "0", "--lang", "rust", "--name", "of_robot"]);
    emit(&folder, &["robot.toml", "--t0", "0", "--lang", "python", "--name", "of_robot"]);
    emit(&folder, &["robot.toml", "--t0", "0", "--lang", "cpp", "--name", "of_robot"]);
    let flags = "-std=c99 -O2 -Wall -Wextra -Wpedantic -Wconversion -Werror";
    let in_c =
        shell(&folder, &format!("cc {flags} of_model.c of_robot.c main.c -o main -lm && ./main"));
    let in_rust = shell(&folder, "rustc --edition 2024 -O main.rs -o rust 2>&1 && ./rust");
    let numbers = |text: &str| -> Vec<f64> {
        text.split_whitespace().map(|word| word.parse().expect("a number")).collect()
    };
    let (in_c, in_rust) = (numbers(&in_c), numbers(&in_rust));
    assert_eq!(in_c.len(), 80);
    for (a, b) in in_c.iter().zip(&in_rust) {
        assert!((a - b).abs() <= 1e-13 * a.abs().max(1.0), "{a} {b}");
    }
    shell(&folder, "c++ -std=c++17 -Wall -Wextra -Werror -fsyntax-only -x c++ of_robot.hpp");
    shell(&folder, "python3 -m py_compile of_robot.py");
    // A design is named by the bodies, and not by what else the file says.
    let of = |text: &str| {
        fs::write(folder.join("arm.urdf"), text).expect("writable");
        let (code, told, _) = run_in(&folder, &["check", "robot.toml"]);
        assert_eq!(code, Some(0), "{told}");
        let line = told.lines().find(|line| line.starts_with("design ")).map(str::to_owned);
        line.expect("a fingerprint")
    };
    let own = of(ARM);
    assert_eq!(
        own,
        of(&ARM.replace("<link name=\"wall\"/>", "<!-- a wall --><link name=\"wall\"/>"))
    );
    assert_ne!(own, of(&ARM.replace("value=\"1.5\"", "value=\"1.6\"")));
}

#[test]
fn robot_controllers_refuse_missing_features_by_name() {
    let folder = folder("refused");
    fs::write(folder.join("arm.urdf"), ARM).expect("writable");
    let text = "mu = \"exp(a=1)\"\npoles = [-3, -4]\n[params]\ntau = 1\nt0 = 0\neps = 0.01\nu_max = inf\n[robot]\nurdf = \"arm.urdf\"\n";
    fs::write(folder.join("arm.toml"), text).expect("writable");
    let sampled =
        format!("clock = \"samples\"\nsample_time = 0.001\n{}", text.replace("t0 = 0\n", ""));
    fs::write(folder.join("sampled.toml"), sampled).expect("writable");
    for (words, expected) in [
        (
            vec!["emit", "arm.toml", "--lang", "c", "--selftest"],
            "error[selftest]: a robot has no self-test",
        ),
        (
            vec!["emit", "arm.toml", "--lang", "c", "--acsl"],
            "error[axes]: a proof does not know a plant of several inputs yet",
        ),
        (
            vec!["emit", "arm.toml", "--project", "cmake"],
            "error[not-alone]: the plant of a project is x_n' = g u",
        ),
        (
            vec!["emit", "arm.toml", "--lang", "c", "--urdf", "none.urdf"],
            "error[bad-value]: cannot read none.urdf",
        ),
        (
            vec!["simulate", "arm.toml", "--x0", "1,1,0,0", "--plant", "m=1"],
            "error[conflict]: `m` under [plant] of a robot",
        ),
        (
            vec!["simulate", "arm.toml", "--x0", "1,1,0,0", "--plant", "rotor=1,2,3"],
            "error[bad-value]: plant.rotor has 3 numbers, and the robot 2 joints",
        ),
        (
            vec!["simulate", "arm.toml", "--x0", "1,1,0,0", "--plant", "damping=-1"],
            "error[bad-value]: plant.damping = -1",
        ),
    ] {
        let (code, _, told) = run_in(&folder, &words);
        assert!(code != Some(0) && told.starts_with(expected), "{words:?}: {told}");
    }
    let (_, told, _) = run_in(&folder, &["check", "sampled.toml"]);
    assert!(
        told.contains("loop        not checked: the loop of a robot has no bounds yet"),
        "{told}"
    );
    assert!(told.contains("springs and limits of positions are not looked at"), "{told}");
}
