//! Flags that several commands have. Those of a spec are plain text here: what their values mean,
//! and what is wrong with them, the library says; their help comes from its table of keys.

use std::path::PathBuf;

use crate::keys::{GROUPS, Group, KEYS, KeyInfo};
use clap::{Arg, ArgAction, ArgMatches, Args, FromArgMatches, ValueEnum};

use super::engine::Engine;
use super::report::quoted;
use super::source::{Source, flag};

/// The engine of a command that needs closed forms.
#[derive(Debug, Args)]
pub(crate) struct EngineFlag {
    /// What expands the closed forms; see docs/engines.md
    #[arg(long, value_enum, value_name = "ENGINE", default_value = "ptc", hide_short_help = true)]
    pub(crate) engine: Engine,
}

/// The design file of a command that can have one.
#[derive(Debug, Args)]
pub(crate) struct Design {
    /// Design file, TOML; flags override its keys
    #[arg(value_name = "DESIGN")]
    pub(crate) design: Option<PathBuf>,
}

/// Place of the flags of help among the others.
const LAST: usize = 999;

/// The flag of parameters by name.
const PARAM: &str = "param";

/// The flags of a spec, one for each key of the library's table, and `--param`.
#[derive(Debug)]
pub(crate) struct SpecFlags(pub(crate) Source);

impl FromArgMatches for SpecFlags {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut flags = Self(Source::default());
        flags.update_from_arg_matches(matches)?;
        Ok(flags)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        for info in &KEYS {
            for text in matches.get_many::<String>(info.key).into_iter().flatten() {
                self.0.give(info.key, text);
            }
        }
        for text in matches.get_many::<String>(PARAM).into_iter().flatten() {
            self.0.give_parameter(text);
        }
        Ok(())
    }
}

impl Args for SpecFlags {
    fn augment_args(command: clap::Command) -> clap::Command {
        let keys = GROUPS.iter().flat_map(|group| group.keys().map(|key| key_flag(group, key)));
        let parameter = Arg::new(PARAM)
            .long(PARAM)
            .value_name("NAME=VALUE")
            .action(ArgAction::Append)
            .help("A parameter by its name, as under [params] in a design file; repeatable");
        command.disable_help_flag(true).args(keys).arg(parameter).args(help_flags())
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        Self::augment_args(command)
    }
}

/// The flag of a key.
fn key_flag(group: &Group, key: &KeyInfo) -> Arg {
    let flag = Arg::new(key.key)
        .long(flag(key.key).trim_start_matches('-').to_owned())
        .value_name(key.key.to_uppercase())
        .allow_hyphen_values(true)
        .help_heading(group.title)
        .hide_short_help(group.is_rare(key))
        .help(help(key.key));
    match key.is_switch() {
        true => flag.num_args(0..=1).require_equals(true).default_missing_value("true"),
        false => flag,
    }
}

/// The flags of help, after all others: the short one omits the rare flags.
fn help_flags() -> [Arg; 2] {
    let short = Arg::new("help").short('h').long("help").action(ArgAction::HelpShort);
    let long = Arg::new("help-all").long("help-all").action(ArgAction::HelpLong);
    [short.help("Print help"), long.help("Print help on every flag, the rare ones too")]
        .map(|flag| flag.display_order(LAST))
}

/// The help of a key's flag.
pub(crate) fn help(key: &str) -> String {
    KeyInfo::find(key)
        .map(|info| {
            let (first, rest) = info.meaning.split_at(1);
            let (legal, example) = (info.legal, quoted(info.example));
            format!("{}{rest} [legal: {legal}] [example: {example}]", first.to_uppercase())
        })
        .unwrap_or_default()
}

/// The notation of a command that prints text.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum ListFormat {
    Text,
    Json,
}
