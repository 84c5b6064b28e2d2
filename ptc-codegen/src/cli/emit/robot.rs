//! `emit` of a robot: its functions.

use super::args::Emit;
use super::destination::place;
use crate::cli::output::Outputs;
use crate::cli::report::Failure;
use crate::cli::source::Parsed;
use crate::diagnostic::Diagnostic;
use crate::emit::{File, Language, emit_robot};
use crate::robot::{self, Request};

/// Runs `emit` of a robot.
pub(super) fn emit(
    given: &Emit,
    outputs: &mut Outputs,
    parsed: &Parsed<'_>,
) -> Result<(), Failure> {
    beside_functions(given)?;
    let wanted = match robot::read(&parsed.entries) {
        Ok(wanted) => parsed.finish(Some(wanted), Vec::new())?,
        Err(found) => return parsed.finish(None, found),
    };
    // The grammar requires a language, or a project, which is refused.
    let language = given.lang.unwrap_or(Language::C);
    match files(&wanted, language) {
        Ok((name, files)) => place(given, outputs, (&name, language), &files),
        Err(found) => parsed.finish(None, found),
    }
}

fn files(wanted: &Request, language: Language) -> Result<(String, Vec<File>), Vec<Diagnostic>> {
    let robot = wanted.robot()?;
    Ok((wanted.name(&robot), emit_robot(wanted, &robot, language)?))
}

/// Refuses flags that are of a controller.
fn beside_functions(given: &Emit) -> Result<(), Failure> {
    let flags = [
        (given.acsl, "--acsl"),
        (given.selftest, "--selftest"),
        (given.cost.is_some(), "--cost"),
        (given.dump.is_some(), "--dump"),
        (given.resolved.is_some(), "--resolved"),
        (given.project.is_some(), "--project"),
    ];
    let Some((_, flag)) = flags.iter().find(|(given, _)| *given) else { return Ok(()) };
    Err(Failure::because(
        format!("`{flag}` is of a controller, and a robot has functions alone"),
        &format!("leave {flag} out"),
    ))
}
