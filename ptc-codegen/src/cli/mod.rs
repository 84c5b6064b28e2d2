//! The command line: flags and a design file in, files or text out; every mistake goes to the standard error.
//!
//! [`report`] has the exit codes.

pub(crate) mod args;
mod check;
mod compare;
#[cfg(feature = "campaign")]
mod design;
mod emit;
mod engine;
mod flags;
mod fmu;
mod list;
#[cfg(feature = "simulation")]
mod mathml;
mod new;
mod output;
#[cfg(feature = "simulation")]
mod page;
mod project;
mod read;
mod report;
mod show;
#[cfg(feature = "simulation")]
mod simulate;
mod source;
#[cfg(feature = "campaign")]
mod verify;
mod write;

use std::borrow::Cow;
use std::process::ExitCode;

use clap::Parser;

use args::{Command, CommandLine};
use ptc_codegen::diagnostic::visible;
use ptc_codegen::internal::guarded;
use report::Failure;

/// Runs the command that the process was started with.
pub(crate) fn run() -> ExitCode {
    let command = CommandLine::try_parse().unwrap_or_else(|wrong| refuse(&wrong)).command;
    #[cfg(feature = "symbolica")]
    if let Command::SymbolicaWorker = command {
        return engine::symbolica::worker::run();
    }
    // A panic is told as the fault that it is; of the hook's text its place is left.
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(|place| format!("at {place}:\n"));
        report::print_text(&place.unwrap_or_default());
    }));
    match guarded(|| execute(command)).unwrap_or_else(|fault| Err(Failure::internal(&fault))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            report::print(&failure.notices);
            ExitCode::from(failure.exit as u8)
        }
    }
}

/// Prints what is wrong with the words of the command line, or the help that they ask for, and ends.
fn refuse(wrong: &clap::Error) -> ! {
    let text = wrong.render().to_string();
    match visible(&text) {
        Cow::Owned(shown) if wrong.use_stderr() => {
            report::print_text(&shown);
            std::process::exit(wrong.exit_code())
        }
        _ => wrong.exit(),
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
