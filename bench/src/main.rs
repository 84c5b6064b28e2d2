//! Measures the generated code and the generator. Without a sub-command everything but the cost
//! of builds is measured, and the pages of docs/benchmarks and docs/benchmarks.svg are written.

mod accuracy;
mod axes;
mod builds;
mod c;
mod callgrind;
mod calls;
mod campaigns;
mod case;
mod counts;
mod equality;
mod evaluate;
mod extract;
mod failure;
mod fused;
mod gate;
mod generator;
mod latency;
mod models;
mod moves;
mod peers;
mod report;
mod rewrites;
mod samples;
mod tools;
mod vectors;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use failure::Result;

/// Measures the generated code and the generator.
///
/// Without a command: counts, axes, fma, latency, accuracy, peers, models, moves, generator, egg, then report.
#[derive(Debug, Parser)]
#[command(name = "ptc-bench")]
struct CommandLine {
    #[command(subcommand)]
    command: Option<Command>,
    /// Folder of the peers' generated code, one folder a peer, in it `MAPPING_nN.c` or `.cc`;
    /// without it the one that bench/peers/generate.py writes
    #[arg(long, global = true, value_name = "DIR")]
    contestants: Option<PathBuf>,
    /// Measure also what builds cost; takes minutes
    #[arg(long, global = true)]
    builds: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Instructions a call, code and stack of every family, order, precision, guard and language
    Counts,
    /// Instructions a step of several axes, with the flags with which compilers make vectors of it
    Axes,
    /// Instructions a step with fused products and sums, with and without the processor's own
    Fma,
    /// Nanoseconds from t to u, and instructions, with and without polynomials as trees, and by hand
    Latency,
    /// The worst scaled error of every family and order against tests/data
    Accuracy,
    /// The C of other generators beside ours
    Peers,
    /// A step of designs with a model, beside the C that other tools write of the same plant
    Models,
    /// Motions to rest by designs of ours and by other controllers; prints the section of the page
    Moves,
    /// Instructions and time of generating; with --builds also those of the command and of a crate with the macro
    Generator,
    /// What equality saturation finds beyond the passes, for small kernels
    Egg,
    /// Print the instructions a step with a clock in samples, the table in docs/benchmarks/samples.md
    Samples,
    /// Processor time and instructions a scenario of `verify`, threads and memory; builds the laboratory
    Campaigns {
        /// Measure the designs whose name has this text in it, and print their rows alone
        #[arg(long, value_name = "TEXT")]
        only: Option<String>,
    },
    /// Write the pages of docs/benchmarks and docs/benchmarks.svg from the last measurements
    Report,
    /// Expand the Bell polynomials and end, for the profiler
    #[command(name = generator::PROBE, hide = true)]
    ProbeBell,
    /// Fail (exit code 1) when a count of a small subset rose 2 % above bench/baseline.json
    Gate {
        /// Write bench/baseline.json from the counts of now
        #[arg(long)]
        update: bool,
    },
}

fn main() -> ExitCode {
    match execute(&CommandLine::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {}", failure.message);
            ExitCode::from(failure.exit)
        }
    }
}

fn execute(line: &CommandLine) -> Result<()> {
    match &line.command {
        Some(Command::Gate { update }) => gate::gate(*update),
        Some(Command::ProbeBell) => {
            println!("{} rows", generator::ptc_bench_bell());
            Ok(())
        }
        Some(Command::Counts) => report::keep("counts", &counts::measure()?),
        Some(Command::Axes) => report::keep("axes", &axes::measure()?),
        Some(Command::Fma) => report::keep("fma", &fused::measure()?),
        Some(Command::Latency) => report::keep("latency", &latency::measure()?),
        Some(Command::Accuracy) => report::keep("accuracy", &accuracy::measure()?),
        Some(Command::Peers) => peers(line),
        Some(Command::Models) => models(line),
        Some(Command::Moves) => {
            let measured = moves::measure()?;
            report::keep("moves", &measured)?;
            print!("{}", report::moves(&measured));
            Ok(())
        }
        Some(Command::Generator) => generator(line),
        Some(Command::Egg) => report::keep("egg", &equality::measure()?),
        Some(Command::Samples) => samples::table(),
        Some(Command::Campaigns { only: None }) => {
            report::keep("campaigns", &campaigns::measure("")?)
        }
        Some(Command::Campaigns { only: Some(text) }) => {
            print!("{}", report::campaigns(campaigns::measure(text)?));
            Ok(())
        }
        Some(Command::Report) => report::write(),
        None => {
            report::keep("counts", &counts::measure()?)?;
            report::keep("axes", &axes::measure()?)?;
            report::keep("fma", &fused::measure()?)?;
            report::keep("latency", &latency::measure()?)?;
            report::keep("accuracy", &accuracy::measure()?)?;
            peers(line)?;
            models(line)?;
            report::keep("moves", &moves::measure()?)?;
            generator(line)?;
            report::keep("egg", &equality::measure()?)?;
            report::write()
        }
    }
}

fn peers(line: &CommandLine) -> Result<()> {
    report::keep("peers", &peers::measure(line.contestants.as_deref())?)
}

fn models(line: &CommandLine) -> Result<()> {
    report::keep("models", &models::measure(line.contestants.as_deref())?)
}

fn generator(line: &CommandLine) -> Result<()> {
    report::keep("generator", &generator::measure()?)?;
    report::keep("bell", &generator::bells()?)?;
    if line.builds {
        report::keep("builds", &builds::measure()?)?;
    }
    Ok(())
}
