//! `cargo assure`: runs the layers of assurance and writes assurance/REPORT.md.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use anyhow::{Context as _, Result, anyhow, bail};
use clap::Parser;
use ptc_assure::context::{Context, workspace};
use ptc_assure::kept::Kept;
use ptc_assure::layer::{Layer, Outcome};
use ptc_assure::layers::{LAYERS, cost};
use ptc_assure::report::Entry;
use ptc_assure::{report, tool};
use ptc_codegen::diagnostic::{Diagnostic, Place};
use ptc_codegen::request::Spec;

/// Examines emitted code, layer by layer: what each one shows, of which files, by which tool.
///
/// Exit codes: 0 no layer failed (one that cannot run is reported as not run), 1 a layer failed, 2 bad
/// arguments.
#[derive(Debug, Parser)]
#[command(name = "cargo assure")]
struct CommandLine {
    /// The layers to run; all without one
    #[arg(value_name = "LAYER")]
    layers: Vec<String>,
    /// A layer to leave out; may be given again
    #[arg(long, value_name = "LAYER", conflicts_with_all = ["layers", "design"])]
    except: Vec<String>,
    /// Print the layers and what each shows
    #[arg(long)]
    list: bool,
    /// Seed of the random controllers and records
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Minutes for which the layer `fuzz` draws controllers; a third of one without it
    #[arg(long, value_name = "MINUTES")]
    minutes: Option<f64>,
    /// Measure what a step of the controller in this design file costs, print the table, and run no
    /// layer; `ptc-codegen emit --cost` takes the table
    #[arg(long, value_name = "FILE", conflicts_with = "layers")]
    design: Option<PathBuf>,
    /// Examine less: of the families orders up to 2, a quarter of the random controllers and of the
    /// records, and for proofs and rules a seventh, another one for another commit
    #[arg(long)]
    brief: bool,
    /// Reuse results of layers that passed in an earlier run of the same commit with the same options
    #[arg(long, conflicts_with = "design")]
    resume: bool,
    /// Install nothing: a layer that lacks a tool is not run
    #[arg(long)]
    no_install: bool,
    /// File of the report; by default assurance/REPORT.md where all layers run, else none
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

fn main() -> ExitCode {
    match execute(&CommandLine::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

/// Runs the layers; returns true if none failed.
fn execute(line: &CommandLine) -> Result<bool> {
    if line.list {
        for layer in LAYERS {
            println!("{:<12} {}", layer.name, layer.claim);
        }
        return Ok(true);
    }
    let wanted = if line.design.is_some() { vec!["cost".to_owned()] } else { line.layers.clone() };
    let chosen = chosen(&wanted, &line.except)?;
    if !line.no_install {
        let tools: Vec<_> = chosen.iter().flat_map(|layer| layer.tools).copied().collect();
        tool::install(&tools);
    }
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let target = std::path::absolute(target.unwrap_or_else(|| workspace().join("target")))?;
    let mut context = Context::new(&target, line.seed);
    context.brief = line.brief;
    if let Some(minutes) = line.minutes {
        context.time = Duration::try_from_secs_f64(60.0 * minutes)
            .with_context(|| format!("--minutes {minutes}: give a number from 0 on"))?;
    }
    if let Some(file) = &line.design {
        print!("{}", cost::table(&cost::costs(&context, &[design(file)?])?));
        return Ok(true);
    }
    let kept = Kept::new(&context);
    if line.resume {
        kept.resumes()?;
    }
    let mut entries: Vec<(&Layer, Entry)> = Vec::new();
    let mut failed = false;
    for layer in chosen {
        if let Some(entry) = kept.entry(layer.name).filter(|_| line.resume) {
            println!("{:<8} {:<12} kept    {}", entry.word, layer.name, entry.summary);
            entries.push((layer, entry));
            continue;
        }
        eprintln!("{} ...", layer.name);
        let (outcome, time) = layer.execute(&context);
        println!(
            "{:<8} {:<12} {:>4} s  {}",
            outcome.word(),
            layer.name,
            time.as_secs(),
            outcome.summary()
        );
        for failure in outcome.finding().into_iter().flat_map(|finding| &finding.failures) {
            eprintln!("{failure}");
        }
        let entry = Entry::of(&outcome);
        // A file that was changed meanwhile may have been examined.
        if matches!(outcome, Outcome::Passed(_)) && Kept::new(&context) == kept {
            kept.keep(layer.name, &entry)
                .with_context(|| format!("cannot keep the result of {}", layer.name))?;
        }
        failed |= matches!(outcome, Outcome::Failed(_));
        entries.push((layer, entry));
    }
    let all = line.layers.is_empty() && line.except.is_empty();
    let whole = all.then(|| workspace().join("assurance/REPORT.md"));
    if let Some(path) = line.report.clone().or(whole) {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        folder.map_or(Ok(()), fs::create_dir_all)?;
        fs::write(&path, report::report(&context, &entries))
            .with_context(|| format!("cannot write {}", path.display()))?;
        println!("written: {}", path.display());
    }
    Ok(!failed)
}

/// The controller of a design file.
fn design(file: &Path) -> Result<Spec> {
    let told = |found: &[Diagnostic]| {
        let first = found.first().map_or("", |one| &one.message);
        anyhow!("{}: {first}; `ptc-codegen check {0}` shows more", file.display())
    };
    let text = ptc_codegen::design::load(file).map_err(|wrong| told(&[wrong]))?;
    let (entries, found) = ptc_codegen::design::read(&text, &mut |_| Place(0));
    if !found.is_empty() {
        return Err(told(&found));
    }
    ptc_codegen::request::read(&entries).map_err(|found| told(&found))
}

/// The layers that were asked for, all where none was, without those to leave out, in the order in
/// which they run.
fn chosen(names: &[String], except: &[String]) -> Result<Vec<&'static Layer>> {
    let legal: Vec<_> = LAYERS.iter().map(|layer| layer.name).collect();
    let unknown = |name: &&String| !legal.contains(&name.as_str());
    if let Some(unknown) = names.iter().chain(except).find(unknown) {
        bail!("there is no layer `{unknown}`; the layers are {}", legal.join(", "));
    }
    let is_in = |list: &[String], layer: &Layer| list.iter().any(|name| name == layer.name);
    let wanted = |layer: &&Layer| names.is_empty() || is_in(names, layer);
    Ok(LAYERS.iter().filter(wanted).filter(|layer| !is_in(except, layer)).collect())
}
