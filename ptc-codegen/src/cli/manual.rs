//! `completions` and `man`: shell completions and manual pages, generated from the flags.

use clap::{Args, Command};
use clap_complete::Shell;
use clap_mangen::Man;

use super::report::Failure;

pub(crate) const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  ptc-codegen completions bash > ~/.local/share/bash-completion/completions/ptc-codegen
  ptc-codegen completions fish > ~/.config/fish/completions/ptc-codegen.fish";

pub(crate) const MAN_EXAMPLES: &str = "\
Examples:
  ptc-codegen man > ptc-codegen.1
  ptc-codegen man emit | man -l -";

/// The flags of `completions`.
#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

/// The flags of `man`.
#[derive(Debug, Args)]
pub(crate) struct Page {
    /// A subcommand; without one, the page of ptc-codegen itself
    subcommand: Option<String>,
}

/// The script of a shell for `command`.
pub(crate) fn completions(request: &Completions, mut command: Command) -> String {
    let mut text = Vec::new();
    let name = command.get_name().to_owned();
    clap_complete::generate(request.shell, &mut command, name, &mut text);
    String::from_utf8_lossy(&text).into_owned()
}

/// The page of `command`, or of one of its subcommands.
///
/// # Errors
/// There is no such subcommand.
pub(crate) fn page(request: &Page, mut command: Command) -> Result<String, Failure> {
    command.build();
    let page = match &request.subcommand {
        None => command,
        Some(name) => match command.find_subcommand(name) {
            Some(own) => own.clone().name(format!("{}-{name}", command.get_name())),
            None => {
                let names = command.get_subcommands().map(|own| own.get_name());
                let legal = names.collect::<Vec<_>>().join(", ");
                return Err(Failure::because(
                    format!("there is no subcommand `{name}`"),
                    &format!("legal: {legal}"),
                ));
            }
        },
    };
    let mut text = Vec::new();
    // A write into memory does not fail.
    let _ = Man::new(page).render(&mut text);
    Ok(String::from_utf8_lossy(&text).into_owned())
}
