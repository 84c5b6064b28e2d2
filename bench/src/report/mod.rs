//! `report`: the pages of docs/benchmarks and docs/benchmarks.svg from the last measurements.
//! docs/BENCHMARKS.md, their conclusions, is written by hand.

mod arrivals;
mod beside;
mod moves;
mod plot;
mod tables;

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
use crate::moves::Measured;
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
Counts of instructions repeat exactly on the same versions of compiler and mathematical library; times do not.
[All benchmarks](../BENCHMARKS.md).

| measured with |
| --- |
";

/// The table of campaigns, as the page has it.
pub(crate) fn campaigns(measured: Vec<Campaign>) -> String {
    section(measured, tables::campaigns)
}

/// The sections of motions, as the page has them.
pub(crate) fn moves(measured: &Measured) -> String {
    let mut text = String::new();
    moves::moves(&mut text, &measured.moves);
    arrivals::arrivals(&mut text, measured);
    text
}

/// Writes the pages of which something was measured, and the plot.
pub(crate) fn write() -> Result<()> {
    let docs = workspace().join("docs");
    std::fs::create_dir_all(docs.join("benchmarks"))?;
    let peers: Vec<Entry> = kept("peers")?.unwrap_or_default();
    if let Some(counts) = kept::<Vec<Count>>("counts")? {
        plot::plot(&docs.join("benchmarks.svg"), &counts, &peers)?;
        println!("wrote docs/benchmarks.svg");
    }
    let pages = [
        ("steps", "Code of a step", steps()?),
        ("generators", "Other generators", section(peers, beside::peers)),
        ("models", "Models", section(kept("models")?.unwrap_or_default(), beside::models)),
        ("moves", "Motions", kept("moves")?.as_ref().map_or_else(String::new, moves)),
        (
            "campaigns",
            "Verification campaigns",
            section(kept("campaigns")?.unwrap_or_default(), tables::campaigns),
        ),
        ("builds", "Generating and building", builds()?),
    ];
    for (name, title, sections) in pages.into_iter().filter(|(.., text)| !text.is_empty()) {
        let machine: String = machine().iter().map(|line| format!("| {line} |\n")).collect();
        let text = format!("# {title}\n\n{INTRODUCTION}{machine}{sections}");
        std::fs::write(docs.join("benchmarks").join(format!("{name}.md")), text)?;
        println!("wrote docs/benchmarks/{name}.md");
    }
    Ok(())
}

/// Returns the section of what was measured; without measurements it is empty.
fn section<T>(measured: Vec<T>, write: fn(&mut String, &[T])) -> String {
    let mut text = String::new();
    if !measured.is_empty() {
        write(&mut text, &measured);
    }
    text
}

/// Returns the sections of the page on the code of a step.
fn steps() -> Result<String> {
    let mut text = section(kept::<Vec<Count>>("counts")?.unwrap_or_default(), tables::counts);
    if !text.is_empty() {
        text.insert_str(0, "\n![Instructions per step over the order](../benchmarks.svg)\n");
    }
    text += &section(kept::<Vec<Step>>("axes")?.unwrap_or_default(), beside::axes);
    text += &section(kept::<Vec<Fused>>("fma")?.unwrap_or_default(), tables::fused);
    text += &section(kept::<Vec<Latency>>("latency")?.unwrap_or_default(), tables::latency);
    text += &section(kept::<Vec<Accuracy>>("accuracy")?.unwrap_or_default(), tables::accuracy);
    Ok(text)
}

/// Returns the sections of the page on the cost of generating and building.
fn builds() -> Result<String> {
    let mut text = section(kept::<Vec<Speed>>("generator")?.unwrap_or_default(), tables::generator);
    text += &section(kept::<Vec<Bell>>("bell")?.unwrap_or_default(), beside::bells);
    text += &section(kept::<Vec<Found>>("egg")?.unwrap_or_default(), beside::saturation);
    if let Some(cost) = kept::<Builds>("builds")? {
        tables::builds(&mut text, cost);
    }
    if let Ok(table) = std::fs::read_to_string(results()?.join("new-user.md")) {
        tables::new_user(&mut text, &table);
    }
    Ok(text)
}
