//! The flags of `show`.

use clap::{Args, ValueEnum};

use crate::cli::flags::{Design, EngineFlag, help};

pub(crate) const EXAMPLES: &str = "\
Without --mu the mapping s = kappa is abstract and its derivatives s', s'', s^(3), ... stay symbols
(n up to 30; law up to 16). With --mu the forms are those of a family (n up to 16) or, for a mapping
given as an expression, in r_1, r_2, ..., which follow as expressions.

JSON: each form is a list of terms, {\"coefficient\":\"-3/2\",\"exponents\":{\"T\":2}}, its coefficient
exact. Exponents are keyed by the order of the derivative of s, by k for r_k in the abstract
B_{i,j}, and by the symbol's text for all others. With a design file \"fingerprint\" names the
resolved design, \"chosen\" and \"follows\" list what was open in it. The subjects give
  r       {\"r\":[{\"k\":1,\"terms\":[...]},...]}
  R       {\"R\":[{\"k\":0,\"m\":0,\"terms\":[...]},...]}
  bell    {\"B\":[{\"i\":0,\"j\":0,\"terms\":[...]},...]}
  matrix  {\"BB\":[{\"i\":1,\"j\":1,\"terms\":[...]},...],\"b\":[{\"j\":1,\"terms\":[...]},...]}
  law     {\"law\":\"...\",\"K\":[{\"i\":1,\"terms\":[...]},...],\"row\":[{\"j\":1,\"terms\":[...]},...]};
          for exp_sum {\"law\":\"...\",\"r\":[{\"k\":1,\"terms\":[...]},...]}
          for a mapping given as an expression with \"r\":[{\"k\":1,\"expression\":\"...\"},...] besides
          for a clock in samples {\"law\":\"...\",\"S\":[[1,0],...],\"row\":[...]}, where
          its numbers are known
  tables  {\"A1\":[{\"k\":0,\"m\":0,\"terms\":[...]},...],\"A2\":[{\"k\":1,\"terms\":[...]},...]}

LaTeX is a fragment for a document that uses the package amsmath.

Examples:
  ptc-codegen show r --n 4
  ptc-codegen show bell --n 3 --mu \"exp(a=1)\"
  ptc-codegen show law roll.toml
  ptc-codegen show tables --n 5 --format latex
  ptc-codegen show r --n 8 --format json";

/// What is asked of a print.
#[derive(Debug, Args)]
pub(crate) struct Show {
    /// What to print
    #[arg(value_enum)]
    pub(crate) subject: Subject,
    #[command(flatten)]
    pub(crate) design: Design,
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        help = "Order of the chain of integrators"
    )]
    pub(crate) n: Option<String>,
    #[arg(long, value_name = "MU", allow_hyphen_values = true, help = help("mu"))]
    pub(crate) mu: Option<String>,
    #[command(flatten)]
    pub(crate) engine: EngineFlag,
    /// Notation
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: Format,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Subject {
    /// r_1..r_n, the derivatives of mu at the stretched time
    #[value(name = "r")]
    SmallR,
    /// R_{k,m} for 0 <= m <= k < n, in the derivatives of the abstract mapping
    #[value(name = "R")]
    BigR,
    /// The partial Bell polynomials B_{i,j} for 0 <= j <= i <= n
    Bell,
    /// The matrix BB_n and the row b_n
    Matrix,
    /// The linear law
    Law,
    /// R_{k,m} and r_k as two tables, for the abstract mapping
    Tables,
}

impl Subject {
    /// Name on the command line.
    pub(super) fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Format {
    Text,
    Latex,
    Json,
}
