//! The flags of `verify`.

use std::path::PathBuf;

use clap::Args;

use super::runner::Runner;
use crate::cli::flags::{Design, SpecFlags};

pub(crate) const EXAMPLES: &str = "\
The design holds what is verified: under [plant] the plant, with bounds [lower, upper] of each
uncertain symbol; under [disturbance] how symbols vary; under [verify] the boxes of x1..xn, or of
the states of the model, and tau; in each [[objective]] what has to hold. Scenarios are independent
draws, each a function of the seed and its index, and run on both sides of Theorem 1, which must
agree; with a sample period in the loop that runs; with a model with the emitted controller. The
joint corners of all uncertainties are run too, and a search starts from the worst scenarios.

With --out one row per draw is written as Parquet, and the same command resumes an interrupted run.
Shards are parts of one run: merged, they have its bytes.

Exit codes: 0 every objective holds, or the shard is done; 1 an objective fails; 2 bad input; 3 none
fails and one is undecided: a run could not be finished, or the two sides differ.

Examples:
  ptc-codegen verify roll.toml --scenarios 100000 --seed 7
  ptc-codegen verify roll.toml --out roll.parquet --worst worst.csv
  ptc-codegen verify roll.toml --report roll.html
  ptc-codegen verify roll.toml --shard 3/64 --out part3.parquet
  ptc-codegen verify roll.toml --merge part*.parquet --out roll.parquet
  ptc-codegen verify roll.toml --scenario 8123
  ptc-codegen verify roll.toml --scenario \"tau = 2, x1 = -1, x2 = 1, gust = worst(0.1, 0.4)\"";

/// What is asked of a verification.
#[derive(Debug, Args)]
pub(crate) struct Verify {
    #[command(flatten)]
    pub(crate) design: Design,
    #[command(flatten)]
    pub(crate) spec: SpecFlags,
    /// A key of [plant]: f, g, dynamics, inertia, bias, or a symbol that they use; repeatable
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) plant: Vec<String>,
    /// Number of scenarios; overrides the design
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true)]
    pub(crate) scenarios: Option<String>,
    /// Seed of all scenarios; overrides the design
    #[arg(long, value_name = "SEED", allow_hyphen_values = true)]
    pub(crate) seed: Option<String>,
    /// Run only part I of N, I from 1; --merge gives the verdict
    #[arg(long, value_name = "I/N", requires = "out", conflicts_with_all = ["merge", "scenario", "worst"])]
    pub(crate) shard: Option<String>,
    /// Run scenarios by the interpreter of the emitted code or by the emitted C, compiled by the C
    /// compiler that CC names, or cc; the rows are the same
    #[arg(long, value_enum, value_name = "WAY", default_value_t = Runner::Auto, conflicts_with_all = ["merge", "scenario"])]
    pub(crate) runner: Runner,
    /// Merge the parts of a run and give the verdict, without running their scenarios
    #[arg(long, value_name = "FILES", num_args = 1.., conflicts_with = "scenario")]
    pub(crate) merge: Vec<PathBuf>,
    /// File for the rows, as Parquet; its folder is made if it is missing
    #[arg(short, long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// File for the worst trajectory of the worst objective, as CSV
    #[arg(long, value_name = "FILE", conflicts_with = "scenario")]
    pub(crate) worst: Option<PathBuf>,
    /// Report of design, formulas, checks, verdict, worst trajectory and code, as one self-contained
    /// page of HTML
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scenario", "shard"])]
    pub(crate) report: Option<PathBuf>,
    /// Run one scenario and print its trajectory as CSV: a draw by its index, or one that is written
    /// out as it is printed
    #[arg(long, value_name = "SCENARIO", conflicts_with = "out")]
    pub(crate) scenario: Option<String>,
}
