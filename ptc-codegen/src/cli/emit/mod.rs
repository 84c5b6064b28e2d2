//! `emit`: the source of a controller, to files, to the standard output, or compared with files.

mod args;
mod destination;
mod robot;

use std::path::Path;

use crate::accepted::Accepted;
use crate::check::examine::examine_resolved;
use crate::check::resolved::Resolved;
use crate::controller::measured::Measured;
use crate::design;
use crate::diagnostic::{Diagnostic, Place};
use crate::emit::{File, Language, Project};
use crate::expansion::Expanded;
use crate::internal::fault;
use crate::plant;
use crate::request::{Spec, asks_for_functions};

pub(crate) use args::{EXAMPLES, Emit};
use destination::{make, place};

use super::output::{self, Outputs};
use super::progress::checking;
use super::read;
use super::report::{Failure, note};
use super::source::{Source, chosen};
use super::write;

/// Runs `emit`.
pub(crate) fn emit(request: &Emit) -> Result<(), Failure> {
    beside_c(request)?;
    let mut outputs = Outputs::default();
    let inputs = [("the design", &request.design.design), ("the table of --cost", &request.cost)];
    for (name, path) in inputs {
        path.iter().for_each(|path| outputs.reads(name, path));
    }
    if let (Some(out), false) = (&request.out, request.check) {
        // What can be no folder is found before the work.
        outputs.folder("--out", out)?;
    }
    let to =
        request.resolved.as_deref().map(|path| outputs.file("--resolved", path)).transpose()?;
    let mut source = request.spec.0.with_design(request.design.design.as_deref())?;
    let gives_precision = source.parse().entries.iter().any(|entry| entry.key == "precision");
    if request.project == Some(Project::Arduino) && !gives_precision {
        // double has 32 bits on boards with an AVR.
        source.give("precision", "f32");
    }
    let given = source.parse();
    if let Some(entry) = given.entries.iter().find(|entry| entry.key == "urdf") {
        outputs.reads("the URDF file", &source.file_of(entry));
    }
    if asks_for_functions(&given.entries) {
        return robot::emit(request, &mut outputs, &given);
    }
    let mut spec = given.read()?;
    let expanded = request.engine.engine.prepare(&mut spec)?;
    let dump = |pass: &str| crate::accepted::dump(&spec, expanded.as_ref(), pass);
    if let Some(program) = request.dump.as_deref().and_then(dump) {
        return write::to_stdout(&program);
    }
    let design = checking(|| Resolved::expanded(&spec, expanded.as_ref()));
    design.choices.iter().for_each(|choice| note(&choice.to_string()));
    let text = to.is_some().then(|| resolved(&source, &design)).transpose()?;
    match request.project {
        Some(kind) => match project(design, expanded, kind) {
            Ok(files) => make(request, &mut outputs, &spec.name(), &files),
            Err(found) => given.finish(None, found),
        },
        None => {
            // The grammar requires one of the two.
            let language = request.lang.unwrap_or(Language::C);
            let measured = measured(request.cost.as_deref(), &design.spec)?;
            match sources(request, (design, expanded), language, &measured) {
                Ok(files) => place(request, &mut outputs, (&spec.name(), language), &files),
                Err(found) => given.finish(None, found),
            }
        }
    }?;
    if let (Some(to), Some(text)) = (to, text) {
        write::to_stdout(&output::write(&[(to, text.as_bytes())])?)?;
    }
    Ok(())
}

/// The design file of a resolved design.
fn resolved(source: &Source, design: &Resolved) -> Result<String, Failure> {
    let fingerprint = design.spec.fingerprint();
    let text = source.completed(chosen(&design.choices));
    let (mut entries, found) = design::read(&text, &mut |_| Place(usize::MAX));
    design::with_files(&mut entries, &|entry| source.file_of(entry));
    let again = plant::read_design(&entries).ok().filter(|_| found.is_empty());
    match again.map(|(spec, _)| Resolved::of(&spec)) {
        Some(again) if again.choices.is_empty() && again.spec.fingerprint() == fingerprint => {
            Ok(text)
        }
        _ => fault("the resolved design is not read back"),
    }
}

/// Refuses flags of C with another language.
fn beside_c(request: &Emit) -> Result<(), Failure> {
    let given = [
        (request.acsl, "--acsl"),
        (request.selftest, "--selftest"),
        (request.cost.is_some(), "--cost"),
    ];
    let Some((_, flag)) = given.iter().find(|(given, _)| *given) else { return Ok(()) };
    let other = match (request.lang, request.project, &request.dump) {
        (Some(Language::C), _, None) => return Ok(()),
        (_, _, Some(_)) => "--dump".to_owned(),
        (Some(language), _, _) => format!("--lang {}", language.name()),
        (None, Some(project), _) => format!("--project {}", project.name()),
        (None, None, _) => return Ok(()),
    };
    Err(Failure::because(
        format!("`{flag}` needs C, not `{other}`"),
        &format!("give --lang c without --dump, or leave {flag} out"),
    ))
}

/// The files of a project.
fn project(
    design: Resolved,
    expanded: Option<Expanded>,
    kind: Project,
) -> Result<Vec<File>, Vec<Diagnostic>> {
    // What cannot stand alone is not checked first.
    kind.accepts(&design.spec)?;
    Accepted::of(checking(|| examine_resolved(design, expanded)))?.project(kind)
}

/// The files of a language, and what goes with them by flags.
fn sources(
    request: &Emit,
    (design, expanded): (Resolved, Option<Expanded>),
    language: Language,
    measured: &[Measured],
) -> Result<Vec<File>, Vec<Diagnostic>> {
    let accepted = Accepted::of(checking(|| examine_resolved(design, expanded)))?;
    let mut files = match request.acsl {
        true => accepted.files_with_proof()?,
        false => accepted.files(language, measured)?,
    };
    if request.selftest {
        files.extend(accepted.selftest()?);
    }
    Ok(files)
}

/// Most bytes of a table of costs.
const MAX_TABLE: u64 = 1 << 24;

/// Reads the measurements of the controller from the table in `file`; empty without a file.
fn measured(file: Option<&Path>, spec: &Spec) -> Result<Vec<Measured>, Failure> {
    let Some(file) = file else { return Ok(Vec::new()) };
    let text = read::text(file, MAX_TABLE)?;
    let mut table = Measured::table(&text).map_err(|wrong| {
        let help = "give a table as `cargo assure cost` writes it";
        Failure::because(format!("{} is not a table of costs: {wrong}", file.display()), help)
    })?;
    let command = spec.command();
    table.retain(|measured| measured.command == command);
    if table.is_empty() {
        return Err(Failure::because(
            format!("{} holds no cost of this controller, `{command}`", file.display()),
            "measure it, in the source of ptc: cargo assure --design DESIGN",
        ));
    }
    Ok(table)
}
