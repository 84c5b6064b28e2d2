//! `report`: docs/BENCHMARKS.md and docs/benchmarks.svg from what was measured last.

mod beside;
mod moves;
mod plot;
mod tables;

use std::fmt::Write as _;

use serde::de::DeserializeOwned;

use crate::accuracy::Accuracy;
use crate::axes::Step;
use crate::builds::Builds;
use crate::campaigns::Campaign;
use crate::counts::Count;
use crate::equality::Found;
use crate::failure::Result;
use crate::fused::Fused;
use crate::generator::{Bell, Speed};
use crate::latency::Latency;
use crate::models::Model;
use crate::moves::Move;
use crate::peers::Entry;
use crate::tools::{machine, results, workspace};

/// Keeps what was measured under `name` for the report.
pub(crate) fn keep(name: &str, measured: &impl serde::Serialize) -> Result<()> {
    let path = results()?.join(format!("{name}.json"));
    std::fs::write(&path, serde_json::to_string(measured)?)?;
    println!("{name}: kept in {} (`report` writes it into the docs)", path.display());
    Ok(())
}

/// Returns the stored results called `name`; `None` if there are none.
fn kept<T: DeserializeOwned>(name: &str) -> Result<Option<T>> {
    match std::fs::read_to_string(results()?.join(format!("{name}.json"))) {
        Ok(text) => Ok(Some(serde_json::from_str(&text)?)),
        Err(_) => Ok(None),
    }
}

const INTRODUCTION: &str = "\
# Benchmarks

How much the generated code costs, how accurate it is, and how fast it is generated. One command
measures everything and writes this page and its plot again:

    cargo run --release -p ptc-bench

It needs gcc and valgrind, and for the other generators Python, set up as below. Counts of
instructions repeat exactly on the same versions of compiler and mathematical library; times do not.
";

/// The table of campaigns, as the page has it.
pub(crate) fn campaigns(measured: &[Campaign]) -> String {
    let mut text = String::new();
    tables::campaigns(&mut text, measured);
    text
}

/// The section of motions, as the page has it.
pub(crate) fn moves(measured: &[Move]) -> String {
    let mut text = String::new();
    moves::moves(&mut text, measured);
    text
}

/// Writes both files.
pub(crate) fn write() -> Result<()> {
    let mut text = String::from(INTRODUCTION);
    text.push_str("\n| measured with |\n| --- |\n");
    for line in machine() {
        let _ = writeln!(text, "| {line} |");
    }
    let counts: Option<Vec<Count>> = kept("counts")?;
    let peers: Option<Vec<Entry>> = kept("peers")?;
    let docs = workspace().join("docs");
    std::fs::create_dir_all(&docs)?;
    if let Some(counts) = &counts {
        text.push_str("\n![Instructions per step over the order](benchmarks.svg)\n");
        tables::counts(&mut text, counts);
        plot::plot(&docs.join("benchmarks.svg"), counts, peers.as_deref().unwrap_or(&[]))?;
    }
    if let Some(steps) = kept::<Vec<Step>>("axes")? {
        beside::axes(&mut text, &steps);
    }
    if let Some(fused) = kept::<Vec<Fused>>("fma")? {
        tables::fused(&mut text, &fused);
    }
    if let Some(latency) = kept::<Vec<Latency>>("latency")? {
        tables::latency(&mut text, &latency);
    }
    if let Some(accuracy) = kept::<Vec<Accuracy>>("accuracy")? {
        tables::accuracy(&mut text, &accuracy);
    }
    beside::peers(&mut text, peers.as_deref().unwrap_or(&[]));
    if let Some(models) = kept::<Vec<Model>>("models")? {
        beside::models(&mut text, &models);
    }
    if let Some(measured) = kept::<Vec<Move>>("moves")? {
        moves::moves(&mut text, &measured);
    }
    if let Some(speeds) = kept::<Vec<Speed>>("generator")? {
        tables::generator(&mut text, &speeds);
    }
    if let Some(campaigns) = kept::<Vec<Campaign>>("campaigns")? {
        tables::campaigns(&mut text, &campaigns);
    }
    if let Some(bells) = kept::<Vec<Bell>>("bell")? {
        beside::bells(&mut text, &bells);
    }
    if let Some(found) = kept::<Vec<Found>>("egg")? {
        beside::saturation(&mut text, &found);
    }
    if let Some(cost) = kept::<Builds>("builds")? {
        tables::builds(&mut text, cost);
    }
    if let Ok(table) = std::fs::read_to_string(results()?.join("new-user.md")) {
        tables::new_user(&mut text, &table);
    }
    std::fs::write(docs.join("BENCHMARKS.md"), text)?;
    println!("wrote docs/BENCHMARKS.md and docs/benchmarks.svg");
    Ok(())
}
