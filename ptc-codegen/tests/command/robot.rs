//! `emit` of a robot: paths, files, and what the other commands say.

use crate::support;

use std::fs;
use std::path::Path;

use support::words::stderr;
use support::{command, folder};

/// A pendulum: torque = 2 a + 9.81 cos q.
const PENDULUM: &str = r#"<robot name="Pendulum 1">
<link name="wall"/>
<link name="rod"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>
<inertia ixx="0" iyy="1.5" izz="1.5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="hinge" type="continuous"><parent link="wall"/><child link="rod"/><axis xyz="0 -1 0"/></joint>
</robot>
"#;

const DESIGN: &str = "what = \"inverse-dynamics\"\n[robot]\nurdf = \"parts/pendulum.urdf\"\n";

fn written(name: &str) -> std::path::PathBuf {
    let folder = folder(name);
    fs::create_dir_all(folder.join("designs/parts")).expect("writable");
    fs::write(folder.join("designs/parts/pendulum.urdf"), PENDULUM).expect("writable");
    fs::write(folder.join("designs/pendulum.toml"), DESIGN).expect("writable");
    folder
}

fn run(folder: &Path, words: &[&str]) -> (bool, String) {
    let done = command(words).current_dir(folder).output().expect("the binary runs");
    let told = [done.stdout, done.stderr].concat();
    (done.status.success(), String::from_utf8(told).expect("UTF-8"))
}

#[test]
fn urdf_paths_are_relative_to_the_design_file() {
    let folder = written("robot_paths");
    let (good, told) = run(&folder, &["emit", "designs/pendulum.toml", "--lang", "c", "-o", "out"]);
    assert!(good, "{told}");
    let header = fs::read_to_string(folder.join("out/pendulum_1.h")).expect("a header");
    let line = "  ptc-codegen emit --lang c --what inverse-dynamics --urdf parts/pendulum.urdf --gravity=0,0,-9.81\n";
    assert!(header.contains(line), "{header}");
    // A flag is relative to the folder of the command.
    let flag = ["--urdf", "designs/parts/pendulum.urdf", "--name", "rod"];
    let words = ["emit", "designs/pendulum.toml", "--lang", "c", "-o", "out"];
    let (good, told) = run(&folder, &[&words[..], &flag].concat());
    assert!(good, "{told}");
    let (good, told) = run(&folder, &[&words[..], &["--urdf", "parts/pendulum.urdf"]].concat());
    assert!(!good && told.contains("cannot read parts/pendulum.urdf"), "{told}");
    let again = [&words[..], &["--check"]].concat();
    assert!(run(&folder, &again).0);
}

#[test]
fn emitted_torques_are_those_of_the_pendulum_and_0_on_failure() {
    let folder = written("robot_torque");
    let words = ["emit", "designs/pendulum.toml", "--lang", "c", "-o", "."];
    let (good, told) = run(&folder, &[&words[..], &["--name", "rod"]].concat());
    assert!(good, "{told}");
    let main = "#include \"rod.h\"\n#include <math.h>\n#include <stdio.h>\nint main(void)\n{\n\
        const double q[1] = {0.7}, v[1] = {3.0}, a[1] = {-1.3};\n double torque[1];\n rod arm;\n const rod_params none = {0};\n\
        if (rod_init(&arm, &none) != PTC_OK || rod_inverse_dynamics(&arm, q, v, a, torque) != PTC_OK) { return 1; }\n\
        if (fabs(torque[0] - (2.0 * a[0] + 9.81 * cos(q[0]))) > 1e-14) { return 2; }\n\
        const double wrong[1] = {NAN}, large[1] = {1.7e308};\n torque[0] = 7.0;\n\
        if (rod_inverse_dynamics(&arm, wrong, v, a, torque) != PTC_E_INPUT || torque[0] != 0.0) { return 3; }\n\
        torque[0] = 7.0;\n\
        return rod_inverse_dynamics(&arm, q, v, large, torque) == PTC_E_RANGE && torque[0] == 0.0 ? 0 : 4;\n}\n";
    fs::write(folder.join("main.c"), main).expect("writable");
    let compile = "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror rod.c main.c -o rod -lm && ./rod";
    let done = std::process::Command::new("sh").args(["-c", compile]).current_dir(&folder).output();
    let done = done.expect("a shell");
    assert!(done.status.success(), "{:?} {}", done.status, String::from_utf8_lossy(&done.stderr));
}

/// The mass matrix of one joint is a number, of which nothing has to be tested.
#[test]
fn constant_results_compile() {
    let folder = written("robot_constant");
    let emit = ["emit", "designs/pendulum.toml", "--what", "mass-matrix", "--name", "rod"];
    for language in ["c", "rust", "python"] {
        let (good, told) = run(&folder, &[&emit[..], &["--lang", language, "-o", "."]].concat());
        assert!(good, "{told}");
    }
    let main = "#include \"rod.h\"\nint main(void)\n{\n const double q[1] = {0.7};\n double mass[1] = {0.0};\n\
        rod arm;\n const rod_params none = {0};\n\
        return rod_init(&arm, &none) == PTC_OK && rod_mass_matrix(&arm, q, mass) == PTC_OK && mass[0] == 2.0 ? 0 : 1;\n}\n";
    fs::write(folder.join("main.c"), main).expect("writable");
    let check = "cc -std=c99 -Wall -Wextra -Wpedantic -Werror rod.c main.c -o rod -lm && ./rod && \
        rustc --edition 2021 --crate-type lib rod.rs --out-dir . && python3 -m py_compile rod.py";
    let done = std::process::Command::new("sh").args(["-c", check]).current_dir(&folder).output();
    let done = done.expect("a shell");
    assert!(done.status.success(), "{:?} {}", done.status, String::from_utf8_lossy(&done.stderr));
}

#[test]
fn flags_and_commands_of_controllers_are_refused() {
    let folder = written("robot_refused");
    let words = |more: &[&'static str]| [&["emit", "designs/pendulum.toml"], more].concat();
    for (words, expected) in [
        (
            vec!["check", "designs/pendulum.toml"],
            "error[conflict]: what = inverse-dynamics is of `emit`",
        ),
        (
            vec!["simulate", "designs/pendulum.toml", "--x0", "1"],
            "error[conflict]: what = inverse-dynamics is of `emit`",
        ),
        (
            words(&["--lang", "c", "--selftest"]),
            "error: `--selftest` is of a controller, and a robot has functions alone",
        ),
        (
            words(&["--lang", "c", "--acsl"]),
            "error: `--acsl` is of a controller, and a robot has functions alone",
        ),
        (
            words(&["--lang", "matlab"]),
            "error[unsupported]: the functions of a robot are not printed in matlab",
        ),
        (
            words(&["--lang", "python", "--fma"]),
            "error[unsupported]: python has no fused multiply-add",
        ),
        (
            words(&["--lang", "c", "--what", "inertia"]),
            "error[bad-value]: what = inertia of a robot",
        ),
        (
            words(&["--lang", "c", "--tip", "rood"]),
            "error[bad-value]: parts/pendulum.urdf: there is no link `rood`, which `tip` names",
        ),
    ] {
        let (good, told) = run(&folder, &words);
        assert!(!good && told.starts_with(expected), "{words:?}: {told}");
    }
    let told = stderr(&["emit", "--lang", "c", "--what", "mass-matrix"], 2);
    assert!(told.starts_with("error[missing-key]: what = mass-matrix without a robot"), "{told}");
    let told = stderr(&["emit", "--lang", "c", "--n", "2", "--mu", "exp", "--tip", "hand"], 2);
    assert!(told.starts_with("error[conflict]: `tip` without a robot"), "{told}");
}
