//! The flags of `new`.

use std::path::PathBuf;

use crate::design::STARTS;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};

use crate::cli::catalogue::ENTRIES;
use crate::cli::flags::help;

pub(crate) const EXAMPLES: &str = "\
The file is a valid design, short, with the units in its comments: `check` accepts it as it is.
With --all it holds every key, with its legal values. With --from it is a published controller, and
its head names the paper. A robot needs its URDF file: docs/guide/robots.md has a design for one.

Examples:
  ptc-codegen new belt                      belt.toml, a stage: a mass that a force moves
  ptc-codegen new belt --limit 100          the same with u_max = 100
  ptc-codegen new wheel --plant motor       wheel.toml, a linear plant x' = A x + B u
  ptc-codegen new -                         to the standard output
  ptc-codegen new roll --all                roll.toml, with every key explained
  ptc-codegen new --from power_scaling      after Song et al. 2017
  ptc-codegen new yaw --from power_scaling  the same as yaw.toml";

/// The flags of `new`.
#[derive(Debug, Args)]
pub(crate) struct New {
    /// Name of the controller, and of the file before `.toml`; `-` prints to the standard output
    #[arg(value_name = "NAME")]
    pub(crate) name: Option<String>,
    /// Kind of plant to start from; a stage if not given
    #[arg(
        long,
        value_name = "PLANT",
        value_parser = PossibleValuesParser::new(plants())
    )]
    pub(crate) plant: Option<String>,
    #[command(flatten)]
    pub(crate) values: Values,
    /// Write every key with its meaning and its legal values
    #[arg(long, conflicts_with_all = ["plant", "from"])]
    pub(crate) all: bool,
    /// Start from a published controller, by its name in `list --catalogue`
    #[arg(
        long,
        value_name = "CONTROLLER",
        value_parser = PossibleValuesParser::new(ENTRIES.iter().map(|entry| entry.name)),
        hide_possible_values = true,
        conflicts_with = "plant"
    )]
    pub(crate) from: Option<String>,
    /// Folder to write to, made if it is missing; `-` prints to the standard output
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    pub(crate) out: PathBuf,
}

/// Values of the design that flags give.
#[derive(Debug, Args)]
pub(crate) struct Values {
    #[arg(long, value_name = "STATES", conflicts_with_all = ["all", "from"], help = help("measured"))]
    measured: Option<String>,
    #[arg(
        long,
        alias = "u-max",
        value_name = "U_MAX",
        allow_hyphen_values = true,
        conflicts_with_all = ["all", "from"],
        help = help("u_max")
    )]
    limit: Option<String>,
    #[arg(
        long,
        value_name = "TAU",
        allow_hyphen_values = true,
        conflicts_with_all = ["all", "from"],
        help = help("tau")
    )]
    tau: Option<String>,
}

impl Values {
    /// Returns the values that are given: key, flag and text of each.
    pub(super) fn given(&self) -> impl Iterator<Item = (&'static str, &'static str, &str)> {
        let all = [
            ("measured", "--measured", &self.measured),
            ("u_max", "--limit", &self.limit),
            ("tau", "--tau", &self.tau),
        ];
        all.into_iter().filter_map(|(key, flag, text)| Some((key, flag, text.as_deref()?)))
    }
}

/// The kinds of plants by name.
fn plants() -> impl Iterator<Item = PossibleValue> {
    STARTS.iter().map(|start| PossibleValue::new(start.name).help(start.about()))
}
