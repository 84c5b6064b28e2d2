//! The command line: flags and a design file in, files or text out; every mistake goes to the standard error.
//!
//! [`report`] has the exit codes.

pub(crate) mod args;
mod catalogue;
mod check;
mod compare;
#[cfg(feature = "lab")]
mod comparison;
mod compiler;
#[cfg(feature = "lab")]
mod design;
mod doubts;
mod emit;
mod engine;
mod explain;
mod flags;
mod fmu;
mod greek;
#[cfg(feature = "lab")]
mod lab;
#[cfg(not(feature = "lab"))]
#[path = "without_lab.rs"]
mod lab;
mod list;
mod manual;
#[cfg(feature = "lab")]
mod mathml;
mod new;
mod output;
#[cfg(feature = "lab")]
mod page;
#[cfg(feature = "lab")]
mod picture;
mod progress;
mod project;
mod read;
mod report;
mod schema;
mod show;
#[cfg(feature = "lab")]
mod simulate;
mod source;
#[cfg(feature = "lab")]
mod verify;
mod write;

use std::borrow::Cow;
use std::ffi::OsString;
use std::io::IsTerminal;

use clap::{CommandFactory, Parser};

use crate::diagnostic::visible;
use crate::internal::guarded;
use args::{Command, CommandLine};
#[cfg(feature = "lab")]
pub use page::{Shown, card};
use report::Failure;

/// Runs the command of a command line, its own name first: the exit code.
pub(crate) fn run(line: impl IntoIterator<Item = OsString>) -> u8 {
    let command = CommandLine::try_parse_from(line).unwrap_or_else(|wrong| refuse(&wrong)).command;
    // A panic is reported as an internal fault; of the hook's text only its place is kept.
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(|place| format!("at {place}:\n"));
        report::print_text(&place.unwrap_or_default());
    }));
    match guarded(|| execute(command)).unwrap_or_else(|fault| Err(Failure::internal(&fault))) {
        Ok(()) => 0,
        Err(failure) => {
            report::print(&failure.notices);
            failure.exit as u8
        }
    }
}

/// Prints what is wrong with the command line, or the help that it requests, and exits.
fn refuse(wrong: &clap::Error) -> ! {
    let text = wrong.render();
    let plain = text.to_string();
    let code = match visible(&plain) {
        Cow::Owned(shown) if wrong.use_stderr() => {
            report::print_text(&shown);
            wrong.exit_code()
        }
        _ if wrong.use_stderr() => wrong.exit(),
        // In colours where they are seen, and an error where it cannot be written.
        _ => {
            let is_seen = std::io::stdout().is_terminal();
            let printed = match is_seen {
                true => wrong.print().map_err(|error| write::unprinted(&error)),
                false => write::to_stdout(&plain),
            };
            printed.map_or_else(
                |failure| {
                    report::print(&failure.notices);
                    failure.exit as i32
                },
                |()| wrong.exit_code(),
            )
        }
    };
    std::process::exit(code)
}

/// Runs a command.
pub(crate) fn execute(command: Command) -> Result<(), Failure> {
    match command {
        Command::Emit(request) => emit::emit(&request),
        Command::Check(request) => check::check(&request),
        Command::Show(request) => write::to_stdout(&show::show(&request)?),
        Command::Simulate(request) => lab::simulate(&request),
        Command::Verify(request) => lab::verify(&request),
        Command::Design(request) => lab::design(&request),
        Command::Compare(request) => lab::compare(&request),
        Command::New(request) => new::new(&request),
        Command::Completions(request) => {
            write::to_stdout(&manual::completions(&request, CommandLine::command()))
        }
        Command::Man(request) => write::to_stdout(&manual::page(&request, CommandLine::command())?),
        Command::Explain(request) => write::to_stdout(&explain::explain(&request)?),
        Command::Schema => write::to_stdout(&schema::schema()),
        Command::List(request) => write::to_stdout(&list::list(&request)),
    }
}
