//! The flags of `verify`.

use std::path::PathBuf;

use clap::Args;

use crate::cli::flags::{Design, SpecFlags};

pub(crate) const EXAMPLES: &str = "\
What is verified is in the design: under [plant] the plant, with [least, greatest] for each symbol
that is uncertain; under [disturbance] how those that vary do; under [verify] the boxes of x1..xn, or
of the states of the model, and tau; and in each [[objective]] what has to hold. Scenarios are drawn from all of it independently, each
of them a function of the seed and its index alone, and run on both sides of Theorem 1, which must
agree, or, with a sample period, in the loop that runs, or, with a model, with the emitted controller; so are the joint corners of all that is
uncertain, and what a search finds from the worst ones.

With --out one row per draw is kept as Parquet, and a run that was interrupted goes on where it was
when it is started again. Shards are parts of the same run: merged they are its bytes.

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
    /// Number of scenarios, in place of the design's
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true)]
    pub(crate) scenarios: Option<String>,
    /// Seed of all scenarios, in place of the design's
    #[arg(long, value_name = "SEED", allow_hyphen_values = true)]
    pub(crate) seed: Option<String>,
    /// Run the I-th of N parts only, I from 1; the verdict is that of --merge
    #[arg(long, value_name = "I/N", requires = "out", conflicts_with_all = ["merge", "scenario", "worst"])]
    pub(crate) shard: Option<String>,
    /// Put the parts of a run together and give the verdict, without running their scenarios
    #[arg(long, value_name = "FILES", num_args = 1.., conflicts_with = "scenario")]
    pub(crate) merge: Vec<PathBuf>,
    /// File for the rows, as Parquet; its folder is made if it is missing
    #[arg(short, long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// File for the worst trajectory of the objective that comes off worst, as CSV
    #[arg(long, value_name = "FILE", conflicts_with = "scenario")]
    pub(crate) worst: Option<PathBuf>,
    /// Report of design, formulas, checks, verdict, worst trajectory and code, as one page of HTML
    /// that needs nothing else
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scenario", "shard"])]
    pub(crate) report: Option<PathBuf>,
    /// Run one scenario and print its trajectory as CSV: a draw by its index, or one that is written
    /// out as it is printed
    #[arg(long, value_name = "SCENARIO", conflicts_with = "out")]
    pub(crate) scenario: Option<String>,
}
