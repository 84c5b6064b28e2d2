//! The grammar of the command line: one subcommand each, whose flags are beside its code.

use clap::{Parser, Subcommand};

use super::report::with_exit_codes;

/// Generates prescribed-time controllers: closed forms for an order and a time mapping, as source
/// code in C, Rust, C++, MATLAB, Python, Structured Text or PLCopen XML.
#[derive(Debug, Parser)]
#[command(name = "ptc-codegen", version, arg_required_else_help = true, after_help = with_exit_codes(EXAMPLES))]
pub(crate) struct CommandLine {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  ptc-codegen list                                    the families of time mappings
  ptc-codegen emit --lang c --n 3 --mu exp -o out     out/ptc_exp3.h and out/ptc_exp3.c
  ptc-codegen new roll                                roll.toml, a design file to begin with
  ptc-codegen check roll.toml                         does the design keep its promise?
  ptc-codegen emit roll.toml --lang c -o out          out/roll.h and out/roll.c
  ptc-codegen simulate roll.toml --x0 0.1,0           its closed loop, as CSV
  ptc-codegen verify roll.toml                        its objectives, over scenarios
  ptc-codegen design wish.toml -o roll.toml           chooses mapping and poles for them
  ptc-codegen compare roll.toml                       beside a PID, a profile, an LQR
  ptc-codegen show matrix --n 4 --mu tanh             the matrix BB_4 and the row b_4
  ptc-codegen explain missing-key                     what a message means, and its fix

simulate, verify, design and compare need a build with `--features lab`.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Generate the source of a controller
    #[command(
        after_help = with_exit_codes(super::emit::EXAMPLES),
        override_usage = "ptc-codegen emit --lang <LANGUAGE> --n <N> --mu <MU> [OPTIONS]\n       \
                          ptc-codegen emit <DESIGN> --lang <LANGUAGE> [OPTIONS]\n       \
                          ptc-codegen emit <DESIGN> --project <PROJECT> [-o <DIR>] [OPTIONS]"
    )]
    Emit(super::emit::Emit),
    /// Check a design: its mapping, its gains at the deadline, sampling, final error and overflow
    #[command(
        after_help = with_exit_codes(super::check::EXAMPLES),
        override_usage = "ptc-codegen check <DESIGN> [OPTIONS]\n       \
                          ptc-codegen check --n <N> --mu <MU> [OPTIONS]"
    )]
    Check(super::check::Check),
    /// Print the expansions behind a controller
    #[command(
        after_help = with_exit_codes(super::show::EXAMPLES),
        override_usage = "ptc-codegen show <SUBJECT> --n <N> [--mu <MU>] [--format <FORMAT>]\n       \
                          ptc-codegen show <SUBJECT> <DESIGN> [--format <FORMAT>]"
    )]
    Show(super::show::Show),
    /// Run the closed loop of a design with its plant
    #[command(
        after_help = with_exit_codes(super::lab::SIMULATE_EXAMPLES),
        after_long_help = with_exit_codes(&[super::lab::SIMULATE_ABOUT, super::lab::SIMULATE_EXAMPLES].join("\n\n")),
        override_usage = "ptc-codegen simulate <DESIGN> --x0 <X1,...,XN> [OPTIONS]\n       \
                          ptc-codegen simulate --n <N> --mu <MU> --plant <NAME=VALUE> --x0 <X1,...,XN> [OPTIONS]"
    )]
    Simulate(super::lab::Simulate),
    /// Verify the closed loop against its objectives under all uncertainties
    #[command(
        after_help = with_exit_codes(super::lab::VERIFY_EXAMPLES),
        override_usage = "ptc-codegen verify <DESIGN> [OPTIONS]\n       \
                          ptc-codegen verify <DESIGN> --shard <I/N> --out <FILE> [OPTIONS]\n       \
                          ptc-codegen verify <DESIGN> --merge <FILES>... [OPTIONS]"
    )]
    Verify(super::lab::Verify),
    /// Choose the mapping and the poles of a design so that it meets its objectives
    #[command(
        after_help = with_exit_codes(super::lab::DESIGN_EXAMPLES),
        override_usage = "ptc-codegen design <DESIGN> [-o <FILE>] [--tries <COUNT>]"
    )]
    Design(super::lab::Design),
    /// Compare a design with the controllers that engineers use instead
    #[command(
        after_help = with_exit_codes(super::lab::COMPARE_EXAMPLES),
        override_usage = "ptc-codegen compare <DESIGN> [OPTIONS]\n       \
                          ptc-codegen compare <DESIGN> --x0 <X1,...,XN> [OPTIONS]"
    )]
    Compare(super::lab::Compare),
    /// Write a design file to start from
    #[command(after_help = with_exit_codes(super::new::EXAMPLES))]
    New(super::new::New),
    /// Explain a message, a check or a status: what it means, an example, and its fix
    #[command(after_help = with_exit_codes(super::explain::EXAMPLES))]
    Explain(super::explain::Explain),
    /// Print the completion script of a shell
    #[command(after_help = with_exit_codes(super::manual::COMPLETIONS_EXAMPLES))]
    Completions(super::manual::Completions),
    /// Print a manual page, in roff
    #[command(after_help = with_exit_codes(super::manual::MAN_EXAMPLES))]
    Man(super::manual::Page),
    /// Print a JSON schema of design files, with which editors complete and explain keys
    #[command(after_help = with_exit_codes(super::schema::EXAMPLES))]
    Schema,
    /// Print the families of time mappings and their parameters
    #[command(after_help = with_exit_codes(super::list::EXAMPLES))]
    List(super::list::List),
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::CommandLine;

    /// clap breaks lines at 100 columns, and would break longer ones a second time.
    #[test]
    fn help_is_wrapped_once() {
        let command = CommandLine::command();
        for own in command.get_subcommands().chain([&command]) {
            let told = own.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(told.contains("Exit codes"), "{}", own.get_name());
            let long = own.get_after_long_help().map(ToString::to_string).unwrap_or_default();
            let told = format!("{told}\n{long}");
            for line in told.lines() {
                assert!(line.chars().count() <= 100, "{}: {line}", own.get_name());
            }
        }
    }
}
