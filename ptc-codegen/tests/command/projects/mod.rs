//! Projects as they are written: their files, the same bytes twice, folders of others, refusals; the
//! library and the sketch compiled and run here. `cargo assure projects` runs the firmware.

mod compiled;
mod folders;
mod refusals;
use crate::support;

use std::path::Path;
use std::process::{Command, Output};

fn emit(kind: &str, arguments: &[&str], out: Option<&Path>, from: &Path) -> Output {
    let mut command = support::command(&["emit", "--project", kind]);
    command.args(arguments).current_dir(from);
    if let Some(out) = out {
        command.arg("-o").arg(out);
    }
    command.output().expect("the binary runs")
}

/// Makes a project without a warning; what is printed.
fn made(kind: &str, arguments: &[&str], out: &Path) -> String {
    let output = emit(kind, arguments, Some(out), Path::new("/"));
    let told = support::without_design(&String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success() && told.is_empty(), "{kind} {arguments:?}: {told}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn told(output: &Output, code: i32) -> String {
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{text}");
    text
}

fn run(command: &mut Command) -> String {
    let output = command.output().expect("it runs");
    let told = support::without_design(&String::from_utf8_lossy(&output.stderr));
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{command:?}: {printed}{told}");
    assert_eq!(told, "", "{command:?}");
    printed
}

const DESIGN: [&str; 3] = ["--n=2", "--mu=exp", "--name=stage"];

const KINDS: [(&str, &[&str]); 4] = [
    (
        "arduino",
        &[
            "README.md",
            "examples/run/config.h",
            "examples/run/run.ino",
            "library.properties",
            "src/stage.c",
            "src/stage.h",
        ],
    ),
    (
        "cmake",
        &[
            "CMakeLists.txt",
            "README.md",
            "cmake/stageConfig.cmake.in",
            "example/config.h",
            "example/main.c",
            "include/stage.h",
            "src/stage.c",
        ],
    ),
    (
        "cortex-m",
        &[
            "Makefile",
            "README.md",
            "linker.ld",
            "src/config.h",
            "src/main.c",
            "src/stage.c",
            "src/stage.h",
            "src/startup.c",
        ],
    ),
    (
        "rust-embedded",
        &[
            ".cargo/config.toml",
            "Cargo.toml",
            "README.md",
            "build.rs",
            "memory.x",
            "src/config.rs",
            "src/main.rs",
            "src/stage.rs",
        ],
    ),
];
