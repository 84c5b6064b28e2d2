//! The flags of `compare`.

use std::path::PathBuf;

use clap::Args;

use crate::cli::flags::{Design, ListFormat, SpecFlags};

pub(crate) const EXAMPLES: &str = "\
Runs, on the plant of the design and in the scenarios of `verify`, the emitted controller and those
that engineers use instead: a minimum-jerk profile with a PID, and with an observer; a jerk-limited
profile with the observer; a finite-horizon LQR. The output begins with the columns in which the
design is behind. docs/compare.md says how the others are tuned.

Supported: clock = \"samples\", one input, a whole number of samples of delay, and a plant that is a
chain of order 2 or 3, or A and B.

JSON: {\"name\":\"...\",\"behind\":[...],\"controllers\":[{\"name\":\"the design\",\"error\":[...],
\"peak\":...,\"energy\":...,\"ripple\":...,\"settling\":...,\"gain\":[...],\"delay\":...,\"products\":...,
\"sums\":...,\"bandwidth\":null},...],\"omitted\":[...],\"soonest\":...,\"scenario\":\"...\"}

Examples:
  ptc-codegen compare stage.toml --x0 0.1,0
  ptc-codegen compare stage.toml --x0 0.1,0 --plot compared.svg
  ptc-codegen compare stage.toml --scenarios 1000 --format json
  ptc-codegen compare stage.toml --bandwidth 80";

/// Flags of a comparison.
#[derive(Debug, Args)]
pub(crate) struct Compare {
    #[command(flatten)]
    pub(crate) design: Design,
    #[command(flatten)]
    pub(crate) spec: SpecFlags,
    /// A key of [plant]: f, g, or a symbol that they use; repeatable
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) plant: Vec<String>,
    /// State at the start, x1..xn, in place of the box under [verify]
    #[arg(long, value_name = "X1,...,XN", allow_hyphen_values = true)]
    pub(crate) x0: Option<String>,
    /// Draws to run besides the corners [default: 256, or fewer if the design says so]
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true)]
    pub(crate) scenarios: Option<String>,
    /// Seed of all draws; overrides the design
    #[arg(long, value_name = "SEED", allow_hyphen_values = true)]
    pub(crate) seed: Option<String>,
    /// Bandwidth of the other controllers in rad/s, in place of the largest that keeps the margin
    #[arg(long, value_name = "RAD/S", allow_hyphen_values = true)]
    pub(crate) bandwidth: Option<String>,
    /// Picture of x and u of each controller, in the scenario in which the design ends farthest from
    /// 0; .svg, .png or .pdf
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// Notation
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: ListFormat,
}
