//! Destination of the files of `emit`: the standard output, a folder, or the files that they are compared with.

use std::path::Path;

use super::args::Emit;
use crate::cli::compare::compare;
use crate::cli::output::{self, Outputs};
use crate::cli::project as folder;
use crate::cli::report::Failure;
use crate::cli::{fmu, read, write};
use crate::emit::{File, Language};

/// Prints, compares or writes the files of a language.
pub(super) fn place(
    request: &Emit,
    outputs: &mut Outputs,
    (name, language): (&str, Language),
    files: &[File],
) -> Result<(), Failure> {
    let out = request.out.as_deref().unwrap_or(Path::new("."));
    if request.check {
        return match (out.as_os_str() == "-", language.fmi()) {
            (true, _) => Err(Failure::because(
                "`--check` has no files to compare with where `--out` is `-`".to_owned(),
                "give the folder that holds them, for example -o out",
            )),
            (false, Some(_)) => fmu::check(out, name, files),
            (false, None) => compare_folder(out, files),
        };
    }
    let place = outputs.folder("--out", out)?;
    let told = match (place.is_stream(), language.fmi()) {
        (true, Some(_)) => return Err(unprintable("an FMU is an archive")),
        (true, None) => output::write(&[(place, joined(files, language).as_bytes())])?,
        (false, Some(version)) => {
            let (archive, content) = fmu::archive(name, version, files)?;
            outputs.write_in(out, &[(&archive, content)])?
        }
        (false, None) => {
            let files: Vec<_> = files.iter().map(|f| (f.name.as_str(), &f.text)).collect();
            outputs.write_in(out, &files)?
        }
    };
    write::to_stdout(&told)
}

/// Compares or writes the files of a project.
pub(super) fn make(
    request: &Emit,
    outputs: &mut Outputs,
    name: &str,
    files: &[File],
) -> Result<(), Failure> {
    let out = request.out.as_deref().unwrap_or(Path::new(name));
    if out.as_os_str() == "-" {
        return Err(unprintable("a project is a folder"));
    }
    if request.check {
        return compare_folder(out, files);
    }
    let place = outputs.folder("--out", out)?;
    if place.is_stream() {
        return Err(unprintable("a project is a folder"));
    }
    folder::write(&place, files)
}

fn unprintable(what: &str) -> Failure {
    Failure::because(
        format!("{what}, which is no text to print"),
        "give the folder to write to, for example -o out",
    )
}

/// All files in one text; a comment names each where there are several.
fn joined(files: &[File], language: Language) -> String {
    let (open, close) = language.comment();
    match files {
        [only] => only.text.clone(),
        _ => {
            files.iter().map(|f| format!("{open}---- {} ----{close}\n{}", f.name, f.text)).collect()
        }
    }
}

/// Compares the files with those in `folder`.
fn compare_folder(folder: &Path, files: &[File]) -> Result<(), Failure> {
    // A longer file shows the first line that differs.
    let most = |file: &File| file.text.len() as u64 + 4096;
    compare(folder, files, &mut |file| read::start(&folder.join(&file.name), most(file)))
}
