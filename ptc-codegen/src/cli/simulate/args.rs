//! The flags of `simulate`.

use std::path::PathBuf;

use clap::{ArgAction, ArgGroup, Args};

use crate::cli::flags::{Design, SpecFlags};

pub(crate) const ABOUT: &str = "\
The plant xn' = f + g*u is in the design, under [plant]: f and g are expressions in x1..xn, t
and, f only, u. Every other name in them is a symbol of the plant, with its value there too.
Without [plant], f is 0. With a [model] the plant is the model; [plant] may give other values of its
parameters, and other rates under `dynamics`, for a mechanical one another `inertia` and `bias`.

Run-time parameters need values: --tau, --eps, --t0 (default 0), --u-max (default inf), --gains,
and --param NAME=VALUE for all others, such as a.

Without a sample period the law acts at every instant, with a model the emitted controller, and
time-to-go falls to 1e-9 tau. With --sample-time, --noise, --sensor-step, --u-step or --delay (the
last four also as keys of the design) the emitted controller itself is in the loop, bit for bit, and
u is held in between; every sample is reported. Noise is uniform within its bounds.

--tau may list several values, --x0 and --mu may be given several times: a run for each combination,
all in one picture.

CSV: a line `tau,t,x1,...,xn,u`, of a model the names of its states and inputs, then one line for
each instant; all numbers read back as they were. With several --x0 or --mu the first column is the
number of the run.
The sampled loop adds the measurements y1,...,ym and the status of step; u is the input that acts.";

pub(crate) const EXAMPLES: &str = "\
Examples:
  ptc-codegen simulate stage.toml --x0 0.1,0 -o run.csv --plot run.svg
  ptc-codegen simulate stage.toml --x0 0.1,0 --tau 0.5,1,2 --at-fraction 0.1,0.5,0.9
  ptc-codegen simulate stage.toml --x0 0.1,0 --mu 'exp(a=1)' --mu 'tan(a=2)' --plot run.pdf
  ptc-codegen simulate stage.toml --x0 0.1,0 --plot run.svg --log
  ptc-codegen simulate stage.toml --x0 0.1,0 --at-fraction 0,0.5,0.9,0.999999 --report run.html
  ptc-codegen simulate stage.toml --x0 0.1,0 --sample-time 1e-3 --noise 1e-4,1e-3 --seed 7
  ptc-codegen simulate stage.toml --x0 0.1,0 --sample-time 1e-3 --until 3 --arm-at 2
  ptc-codegen simulate --n 2 --mu \"exp(a=1)\" --gains 12,7 --tau 1 --plant f=-0.5*x2 --x0 1,0";

/// Headings of the help.
const RUN: &str = "Run";
const OUTPUT: &str = "Output";

/// The flags of `simulate`.
#[derive(Debug, Args)]
#[command(mut_arg("mu", |mu| mu.action(ArgAction::Append)))]
#[command(group(ArgGroup::new("drawn").args(["plot", "report"]).multiple(true)))]
pub(crate) struct Simulate {
    #[command(flatten)]
    pub(crate) design: Design,
    /// State at the start: x1..xn, or the states of the model in their order; repeatable, a run each
    #[arg(long, value_name = "X1,...,XN", allow_hyphen_values = true, required = true)]
    pub(crate) x0: Vec<String>,
    #[command(flatten)]
    pub(crate) spec: SpecFlags,
    /// A key of [plant]: f, g, dynamics, inertia, bias, or a symbol that they use; repeatable
    #[arg(help_heading = RUN, long, value_name = "NAME=VALUE")]
    pub(crate) plant: Vec<String>,
    /// Report only at these fractions of tau, each from 0 to below 1
    #[arg(
        help_heading = OUTPUT,
        long,
        alias = "at",
        value_name = "FRACTIONS",
        allow_hyphen_values = true
    )]
    pub(crate) at_fraction: Option<String>,
    /// Report only at these times after t0, in s, each before the deadline
    #[arg(
        help_heading = OUTPUT,
        long,
        value_name = "TIMES",
        allow_hyphen_values = true,
        conflicts_with = "at_fraction"
    )]
    pub(crate) at_time: Option<String>,
    /// File for the CSV, its folder made if it is missing; `-` is the standard output
    #[arg(help_heading = OUTPUT, short, long, value_name = "FILE", default_value = "-")]
    pub(crate) out: PathBuf,
    /// Picture of the runs: states, u and bounds over time and, of a continuous run, x1 in stretched
    /// time; .svg, .png or .pdf
    #[arg(help_heading = OUTPUT, long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// Report of design, formulas, checks, runs and code, as one self-contained page of HTML
    #[arg(help_heading = OUTPUT, long, value_name = "FILE")]
    pub(crate) report: Option<PathBuf>,
    /// Draw |x_i| and |u| on logarithmic axes in the picture and the report
    #[arg(help_heading = OUTPUT, long, requires = "drawn")]
    pub(crate) log: bool,
    /// Sampled loop: seed of the noise
    #[arg(help_heading = RUN, long, value_name = "SEED", default_value_t = 0)]
    pub(crate) seed: u64,
    /// Sampled loop: time after t0 at which the run ends, in s [default: tau]
    #[arg(help_heading = RUN, long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) until: Option<String>,
    /// Sampled loop: times after t0, in s, at whose next sample the controller is armed again
    #[arg(help_heading = RUN, long, value_name = "TIMES", allow_hyphen_values = true)]
    pub(crate) arm_at: Option<String>,
}
