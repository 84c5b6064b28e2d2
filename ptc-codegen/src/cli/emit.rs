//! `emit`: the source of a controller, to files, to the standard output, or compared with files.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use ptc_codegen::emit::File;
use ptc_codegen::{generate, generate_with_proof};

use super::args::{Emit, Lang};
use super::report::{Failure, Notice};
use super::write;

/// Runs `emit`.
pub(crate) fn emit(request: &Emit) -> Result<(), Failure> {
    if request.acsl {
        acsl_fits(request)?;
    }
    let source = request.spec.0.with_design(request.design.design.as_deref())?;
    let given = source.parse();
    let spec = given.read()?;
    if let Some(program) = request.dump.as_deref().and_then(|pass| ptc_codegen::dump(&spec, pass)) {
        return write::to_stdout(&program);
    }
    let generated = match request.acsl {
        true => generate_with_proof(&spec),
        false => generate(&spec, request.lang.into()),
    };
    let files = match generated {
        Ok(files) => files,
        Err(found) => return given.finish(None, found),
    };
    match (request.out.as_os_str() == "-", request.check) {
        (true, true) => Err(Failure::because(
            "`--check` has no files to compare with where `--out` is `-`".to_owned(),
            "give the folder that holds them, for example -o out",
        )),
        (true, false) => write::to_stdout(&joined(&files)),
        (false, true) => check(&request.out, &files),
        (false, false) => write::to_stdout(&write::files(&request.out, &files)?),
    }
}

/// Contracts are for C alone, and the program of a pass has none.
fn acsl_fits(request: &Emit) -> Result<(), Failure> {
    let other = match (request.lang, &request.dump) {
        (Lang::Rust, _) => "`--lang rust`",
        (Lang::C, Some(_)) => "`--dump`",
        (Lang::C, None) => return Ok(()),
    };
    Err(Failure::because(
        format!("`--acsl` annotates C, and {other} asks for no C"),
        "give --lang c without --dump, or leave --acsl out",
    ))
}

/// All files in one text; a comment names each where there are several.
fn joined(files: &[File]) -> String {
    match files {
        [only] => only.text.clone(),
        _ => files.iter().map(|f| format!("/* ---- {} ---- */\n{}", f.name, f.text)).collect(),
    }
}

/// Compares the files with what is in `folder`.
fn check(folder: &Path, files: &[File]) -> Result<(), Failure> {
    let mut notices = Vec::new();
    let mut same = String::new();
    for file in files {
        let path = folder.join(&file.name);
        match fs::read(&path) {
            Ok(there) if there == file.text.as_bytes() => {
                same.push_str(&format!("up to date: {}\n", path.display()));
            }
            Ok(there) => notices.push(difference(&path, &there, &file.text)),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                notices.push(drift(format!("{} is missing", path.display()), Vec::new()));
            }
            Err(error) => return Err(write::failed("cannot read", &path, &error)),
        }
    }
    if notices.is_empty() { write::to_stdout(&same) } else { Err(Failure::drift(notices)) }
}

fn difference(path: &Path, there: &[u8], generated: &str) -> Notice {
    let there = String::from_utf8_lossy(there);
    // By `\n` alone, so that a changed line end or a missing last one is a difference too.
    let mut left = there.split('\n');
    let mut right = generated.split('\n');
    let mut number = 0;
    loop {
        number += 1;
        let (old, new) = (left.next(), right.next());
        if old != new || old.is_none() {
            let title = format!("{} differs from line {number} on", path.display());
            let notes = vec![format!("it has {}", shown(old)), format!("not  {}", shown(new))];
            return drift(title, notes);
        }
    }
}

fn shown(line: Option<&str>) -> String {
    match line {
        None => "the end of the file".to_owned(),
        Some(line) if line.chars().count() > 90 => {
            format!("{:?}...", line.chars().take(87).collect::<String>())
        }
        Some(line) => format!("{line:?}"),
    }
}

fn drift(title: String, notes: Vec<String>) -> Notice {
    let help = "run the same command without `--check` to write it".to_owned();
    Notice { code: Some("drift"), title, quote: None, notes, help: Some(help) }
}
