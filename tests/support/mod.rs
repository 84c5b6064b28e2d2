//! Generated controllers compiled and run as programs, shared by the tests.
// Each test file uses its own part of this module.
#![allow(dead_code)]

pub(crate) mod program;
pub(crate) mod random;
pub(crate) mod specs;
pub(crate) mod tolerance;
pub(crate) mod vectors;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

use ptc_codegen::emit::Language;
use ptc_codegen::spec::Spec;

/// The strict C flags: generated code has no warning under any of them, and no contraction, for
/// Rust has none either.
pub(crate) const STRICT: [&str; 11] = [
    "-std=c99",
    "-O2",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wfloat-equal",
    "-Wshadow",
    "-Werror",
    "-ffp-contract=off",
];

/// An empty folder of a test's own.
pub(crate) fn folder(test: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder for the test");
    path
}

/// Writes the files of `spec` to `folder` and returns their paths.
pub(crate) fn write(folder: &Path, spec: &Spec, language: Language) -> Vec<PathBuf> {
    let files = ptc_codegen::generate(spec, language).expect("a legal spec");
    let write = |file: ptc_codegen::emit::File| {
        let path = folder.join(file.name);
        fs::write(&path, file.text).expect("a generated file");
        path
    };
    files.into_iter().map(write).collect()
}

/// The C compiler: `CC`, else gcc.
pub(crate) fn c_compiler() -> Command {
    Command::new(std::env::var_os("CC").unwrap_or_else(|| "gcc".into()))
}

/// The Rust compiler that cargo uses.
pub(crate) fn rustc() -> Command {
    let mut command = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    command.args(["--edition=2024", "-Dwarnings"]);
    command
}

/// Runs a command that must succeed.
pub(crate) fn run(command: &mut Command) -> Vec<u8> {
    let output = command.output().unwrap_or_else(|error| {
        let name = command.get_program().to_string_lossy();
        panic!("{name}: {error}. These tests compile C: install gcc, or name a compiler in CC")
    });
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {}\n{stderr}", output.status);
    output.stdout
}

/// `work` on each item, two at a time, in the order of the items.
pub(crate) fn in_pairs<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = Mutex::new(items.iter().enumerate());
    let done = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let Some((index, item)) = next.lock().expect("no panic").next() else { break };
                    let result = work(item);
                    done.lock().expect("no panic").push((index, result));
                }
            });
        }
    });
    let mut done = done.into_inner().expect("no panic");
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}
