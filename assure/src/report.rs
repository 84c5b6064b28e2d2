//! assurance/REPORT.md: what was shown, of which code, by which tool of which version. It holds no
//! times, so that the same code and tools give the same report.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use crate::context::{Context, TIME, workspace};
use crate::layer::{Finding, Layer, NOT_RUN, Outcome, Table};

/// Entry of the report for a layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Outcome, in a word.
    pub word: &'static str,
    /// The same in a line.
    pub summary: String,
    /// Failures, defects, tables and notes.
    pub details: String,
}

impl Entry {
    /// Returns the entry of an outcome.
    pub fn of(outcome: &Outcome) -> Self {
        let mut text = String::new();
        if let Some(finding) = outcome.finding() {
            details(&mut text, finding);
        }
        Self { word: outcome.word(), summary: outcome.summary().to_owned(), details: text }
    }
}

/// The text of the report.
pub fn report(context: &Context, layers: &[(&Layer, Entry)]) -> String {
    let (seed, brief) = (context.seed, if context.brief { " --brief" } else { "" });
    let minutes = match context.time {
        TIME => String::new(),
        time => format!(" --minutes {}", time.as_secs_f64() / 60.0),
    };
    let mut text = format!(
        "# Assurance\n\nWritten by `cargo assure --seed {seed}{minutes}{brief}`, every number by that run. It \
         examines what ptc-codegen {} emits: the controllers of `generated/`, every family at \
         several orders in both precisions, and random ones of that seed.\nEach layer also \
         examines code with defects put in on purpose, and fails where it does not see them.\n\n\
         | layer | shows that | result | |\n| --- | --- | --- | --- |\n",
        env!("CARGO_PKG_VERSION")
    );
    for (layer, entry) in layers {
        let cells = [layer.name, layer.claim, entry.word, &*entry.summary].map(cell);
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text.push_str("\n## Tools\n\n| tool | version |\n| --- | --- |\n");
    let ran = layers.iter().filter(|(_, entry)| entry.word != NOT_RUN);
    let tools: BTreeMap<_, _> = ran
        .flat_map(|(layer, _)| layer.tools)
        .map(|tool| (tool.name, tool.version()))
        .filter(|(_, version)| !version.is_empty())
        .collect();
    for (name, version) in tools {
        let _ = writeln!(text, "| {name} | {} |", cell(&version));
    }
    for (layer, Entry { word, summary, details }) in layers {
        let _ =
            write!(text, "\n## {}\n\n{} **{word}**: {summary}\n{details}", layer.name, layer.claim);
    }
    without_folders(&text, &[context.target(), workspace()])
}

/// The same from every machine: paths in what tools say begin in these folders.
fn without_folders(text: &str, folders: &[&Path]) -> String {
    let cut = |text: String, folder: &&Path| text.replace(&format!("{}/", folder.display()), "");
    folders.iter().fold(text.to_owned(), cut)
}

fn details(text: &mut String, finding: &Finding) {
    for failure in &finding.failures {
        let _ = write!(text, "\nFailure:\n\n```text\n{}\n```\n", failure.trim_end());
    }
    if !finding.seeded.is_empty() {
        let row = |seeded: &crate::layer::Seeded| {
            let caught = seeded.caught.clone().unwrap_or_else(|| "NOT CAUGHT".to_owned());
            vec![seeded.defect.clone(), caught]
        };
        let rows = finding.seeded.iter().map(row).collect();
        let title = "Defects put in on purpose".to_owned();
        table(text, &Table { title, head: vec!["defect", "what told of it"], rows });
    }
    for one in &finding.tables {
        table(text, one);
    }
    for note in &finding.notes {
        let _ = write!(text, "\n{note}\n");
    }
}

fn table(text: &mut String, table: &Table) {
    let _ = write!(text, "\n{}:\n\n| {} |\n|", table.title, table.head.join(" | "));
    text.push_str(&" --- |".repeat(table.head.len()));
    text.push('\n');
    for row in &table.rows {
        let cells: Vec<_> = row.iter().map(|text| cell(text)).collect();
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
}

/// A text as a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}
