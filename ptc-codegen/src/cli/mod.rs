//! The command line: flags and a design file in, files or text out; every mistake goes to the standard error.
//!
//! [`report`] has the exit codes.

pub(crate) mod args;
mod check;
#[cfg(feature = "campaign")]
mod design;
mod emit;
mod engine;
mod fmu;
mod list;
#[cfg(feature = "simulation")]
mod mathml;
mod new;
#[cfg(feature = "simulation")]
mod page;
mod project;
mod report;
mod show;
#[cfg(feature = "simulation")]
mod simulate;
mod source;
#[cfg(feature = "campaign")]
mod verify;
mod write;

use std::process::ExitCode;

use clap::Parser;

use args::{Command, CommandLine};
use report::Failure;

/// Runs the command that the process was started with.
pub(crate) fn run() -> ExitCode {
    let command = CommandLine::parse().command;
    #[cfg(feature = "symbolica")]
    if let Command::SymbolicaWorker = command {
        return engine::symbolica::worker::run();
    }
    match execute(command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            report::print(&failure.notices);
            ExitCode::from(failure.exit as u8)
        }
    }
}

/// Runs a command.
pub(crate) fn execute(command: Command) -> Result<(), Failure> {
    match command {
        Command::Emit(request) => emit::emit(&request),
        Command::Check(request) => check::check(&request),
        Command::Show(request) => write::to_stdout(&show::show(&request)?),
        #[cfg(feature = "simulation")]
        Command::Simulate(request) => simulate::simulate(&request),
        #[cfg(feature = "campaign")]
        Command::Verify(request) => verify::verify(&request),
        #[cfg(feature = "campaign")]
        Command::Design(request) => design::design(&request),
        Command::New(request) => new::new(&request),
        Command::List(request) => write::to_stdout(&list::list(request.format)),
        #[cfg(feature = "symbolica")]
        Command::SymbolicaWorker => Ok(()),
    }
}
