//! Generated controllers compiled and run as programs, on this machine and on others under QEMU:
//! shared by the tests and the layers of assurance. A compiler that fails is a fault of the
//! generator, and panics with what it said.

pub mod command;
pub mod cost;
pub mod cpp;
pub mod goldens;
pub mod in_samples;
pub mod inert;
pub mod injection;
pub mod machine;
pub mod net;
pub mod program;
pub mod random;
pub mod records;
pub mod runtime;
mod rust;
pub mod selftest;
pub mod specs;
pub mod tolerance;

pub use rust::ieee_addition;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::thread::ScopedJoinHandle;

use ptc_codegen::emit::Language;
use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::program::{Program, passes};
use ptc_codegen::request::Spec;

/// The strict C flags: generated code has no warning under any of them, and no contraction, for
/// Rust has none either.
pub const STRICT: [&str; 11] = [
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

/// The optimised program of `spec`, whose invariants hold after each pass. The generator itself tests them only where it
/// is compiled without optimisation.
pub fn optimised(spec: &Spec) -> Program {
    passes::optimise(lower(spec, &Law::of(spec)), &mut |pass, program| {
        assert_eq!(program.check(), Ok(()), "{spec:?}, after the pass {}", pass.name);
    })
}

/// `path` as an empty folder.
pub fn empty(path: &Path) -> PathBuf {
    let _ = fs::remove_dir_all(path);
    fs::create_dir_all(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    path.to_owned()
}

/// Writes the files of `spec` to `folder` and returns their paths.
pub fn write(folder: &Path, spec: &Spec, language: Language) -> Vec<PathBuf> {
    written(folder, ptc_codegen::generate(spec, language).expect("a legal spec"))
}

/// Writes the annotated C of `spec` and the harness of its proof to `folder`.
pub fn write_with_proof(folder: &Path, spec: &Spec) -> Vec<PathBuf> {
    written(folder, ptc_codegen::generate_with_proof(spec).expect("a legal spec"))
}

/// Writes files to `folder` and returns their paths.
pub fn written(folder: &Path, files: Vec<ptc_codegen::emit::File>) -> Vec<PathBuf> {
    let write = |file: ptc_codegen::emit::File| {
        let path = folder.join(file.name);
        fs::create_dir_all(path.parent().unwrap_or(folder)).expect("a folder");
        fs::write(&path, file.text).expect("a generated file");
        path
    };
    files.into_iter().map(write).collect()
}

/// The C compiler of this machine: `CC`, else gcc.
pub fn c_compiler() -> Command {
    Command::new(std::env::var_os("CC").unwrap_or_else(|| "gcc".into()))
}

/// The Rust compiler that cargo uses.
pub fn rustc() -> Command {
    let mut command = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    command.args(["--edition=2024", "-Dwarnings"]);
    command
}

/// Runs a command that must succeed.
pub fn run(command: &mut Command) -> Vec<u8> {
    let output = command.output().unwrap_or_else(|error| {
        let name = command.get_program().to_string_lossy();
        panic!("{name}: {error}. C is compiled here: install gcc, or name a compiler in CC")
    });
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {}\n{stderr}", output.status);
    output.stdout
}

/// `work` on each item, two at a time, in the order of the items. A panic of it goes on as it is.
pub fn in_pairs<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = Mutex::new(items.iter().enumerate());
    let take = || next.lock().expect("no panic").next();
    let worker = || {
        let mut done = Vec::new();
        while let Some((index, item)) = take() {
            done.push((index, work(item)));
        }
        done
    };
    let mut done = std::thread::scope(|scope| {
        let handles = [(); 2].map(|()| scope.spawn(worker));
        let join = |handle: ScopedJoinHandle<'_, _>| match handle.join() {
            Ok(done) => done,
            Err(panic) => std::panic::resume_unwind(panic),
        };
        handles.map(join).into_iter().flatten().collect::<Vec<_>>()
    });
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}
