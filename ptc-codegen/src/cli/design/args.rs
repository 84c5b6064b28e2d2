//! The flags of `design`.

use std::path::PathBuf;

use clap::Args;

pub(crate) const EXAMPLES: &str = "\
The objectives are in a design file as for `verify`, in which the mapping (mu or kappa), the law
(poles, gains or pi0) and, with clock = samples, an observer may be missing: these are chosen, and
given values are kept. With sample_time or error, eps is set too. In samples the law of least energy
is tried first. The result is a design that `verify` confirms, and that emit, check and simulate
accept.

Exit codes: 0 the chosen design meets every objective; 1 no choice was found, and nothing is
written; 2 bad input; 3 a run could not be finished with any choice; 130 interrupted by Ctrl-C, and
the best choice so far is printed.

Examples:
  ptc-codegen design wish.toml -o roll.toml
  ptc-codegen design wish.toml --tries 500 > roll.toml";

/// What is asked of a choice.
#[derive(Debug, Args)]
pub(crate) struct Request {
    /// Design file, TOML, in which the mapping, the law and the observer may be missing
    #[arg(value_name = "DESIGN")]
    pub(crate) design: PathBuf,
    /// File for the design, its folder made if it is missing; `-` is the standard output
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    pub(crate) out: PathBuf,
    /// Most tries: a choice that is run, on few scenarios or on all, is one
    #[arg(long, value_name = "COUNT", default_value_t = 250, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) tries: u32,
}
