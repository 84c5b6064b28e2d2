//! The files of generated/ are laid out as their languages' own programs lay them out.

use std::fs;
use std::process::{Command, Output};

use crate::support;
use ptc_assure::context::workspace;
use support::goldens::{FEW, controllers};
use support::in_samples;
use support::specs::spec;

/// The files in a folder of generated/, by name.
fn goldens(language: &str) -> Vec<(String, String)> {
    let folder = workspace().join("generated").join(language);
    let entries = fs::read_dir(folder).expect("a folder of goldens");
    let file = |entry: fs::DirEntry| {
        let name = entry.file_name().to_string_lossy().into_owned();
        (name, fs::read_to_string(entry.path()).expect("a text"))
    };
    entries.map(|entry| file(entry.expect("an entry"))).collect()
}

#[test]
fn goldens_in_rust_are_formatted() {
    formatted(("rustfmt", ""), &goldens("rust"), &["--check", "--edition", "2024"]);
}

/// In the style of .clang-format, as version 14 of the program reads it.
#[test]
fn c_and_cpp_are_formatted() {
    let plain = controllers().into_iter().filter(|spec| FEW.contains(&&*spec.name()));
    let one_law = spec(&[("n", "2"), ("axes", "2"), ("mu", "exp"), ("pi0", "extern")]);
    let in_samples = [in_samples::controllers(), in_samples::of_inputs()].concat();
    let selftests = plain.chain(in_samples).chain([one_law]).flat_map(|spec| {
        let files = ptc_codegen::generate_selftest(&spec).expect("a self-test");
        files.into_iter().map(|file| (file.name, file.text))
    });
    let files: Vec<_> = goldens("c").into_iter().chain(goldens("cpp")).chain(selftests).collect();
    let style = format!("--style=file:{}/.clang-format", workspace().display());
    formatted(("clang-format", "version 14."), &files, &["--dry-run", "--Werror", &style]);
}

/// A program of this version that lays out sources has nothing to change in these files.
fn formatted((program, version): (&str, &str), files: &[(String, String)], arguments: &[&str]) {
    let told = Command::new(program).arg("--version").output();
    let has = |run: &Output| String::from_utf8_lossy(&run.stdout).contains(version);
    if !told.is_ok_and(|run| run.status.success() && has(&run)) {
        return eprintln!("NOT RUN: {program} {version} cannot be had");
    }
    // Apart from the workspace, whose style is its own.
    let folder = std::env::temp_dir().join(format!("ptc_{program}_{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let files: Vec<_> = files
        .iter()
        .map(|(name, text)| {
            let file = folder.join(name);
            fs::write(&file, text).expect("a file");
            file
        })
        .collect();
    let told = Command::new(program).args(arguments).args(&files).output().expect(program);
    assert!(
        !files.is_empty() && told.status.success(),
        "{}{}",
        String::from_utf8_lossy(&told.stdout),
        String::from_utf8_lossy(&told.stderr)
    );
    fs::remove_dir_all(&folder).expect("its end");
}
