//! Supply chain of the generator, and a check that it gives the same bytes everywhere.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, bail};

use super::command::generator;
use crate::context::{Context, workspace};
use crate::harness::command::text;
use crate::harness::empty;
use crate::harness::goldens::of_axes;
use crate::layer::{Finding, Layer, Table};
use crate::tool::{ShownBy, Source, Tool};

const CARGO_DENY: Tool = Tool {
    name: "cargo-deny",
    shown_by: ShownBy::Command(&["cargo", "deny", "--version"]),
    source: Source::Cargo(&["cargo-deny"]),
};

const CARGO_SBOM: Tool = Tool {
    name: "cargo-sbom",
    shown_by: ShownBy::Command(&["cargo", "sbom", "--version"]),
    source: Source::Cargo(&["cargo-sbom"]),
};

pub(super) const LAYER: Layer = Layer {
    name: "supply",
    claim: "Every dependency has a permissive licence and comes from crates.io at the version of the \
            lock file, the bill of materials of a release names all of them, and the generator gives \
            the same bytes in any environment.",
    tools: &[CARGO_DENY, CARGO_SBOM],
    run,
};

fn run(context: &Context) -> Result<Finding> {
    let mut finding = Finding::default();
    let mut rows = Vec::new();
    let root = workspace();
    for check in ["licenses", "bans", "sources"] {
        for (folder, name) in [("", check.to_owned()), ("python", format!("{check} of the wheel"))]
        {
            let told = deny(&root.join(folder), &root.join("deny.toml"), check)?;
            rows.push(row(&name, if told.is_none() { "passed" } else { "FAILED" }));
            finding.failures.extend(told);
        }
    }
    let advisories = deny(root, &root.join("deny.toml"), "advisories")?;
    let unreachable = |told: &String| told.contains("failed to fetch advisory database");
    rows.push(match &advisories {
        None => row("advisories", "passed"),
        Some(told) if unreachable(told) => {
            row("advisories", "NOT RUN: the database cannot be fetched")
        }
        Some(_) => row("advisories", "FAILED"),
    });
    let lacks_database = advisories.as_ref().is_some_and(unreachable);
    if lacks_database {
        let note = "Advisories were NOT RUN: the database of RustSec cannot be fetched here, so that \
                    nothing is known of faults found in the dependencies since.";
        finding.notes.push(note.to_owned());
    }
    finding.failures.extend(advisories.filter(|told| !unreachable(told)));
    let locked = Command::new("cargo")
        .current_dir(root)
        .args(["metadata", "--locked", "--format-version=1", "--quiet"])
        .output()?;
    rows.push(row("lock file", if locked.status.success() { "complete" } else { "FAILED" }));
    if !locked.status.success() {
        finding.failures.push(String::from_utf8_lossy(&locked.stderr).into_owned());
    }
    let lacking = materials(root, &mut finding)?;
    rows.push(row("bill of materials", if lacking { "FAILED" } else { "complete" }));
    finding.tables.push(Table { title: "Checks".to_owned(), head: vec!["check", "result"], rows });
    seeded_licence(context, &mut finding)?;
    let controllers = reproduce(context, &mut finding)?;
    finding.summary = format!(
        "{} packages of the lock file{}; {controllers} controllers, the same bytes in {} environments",
        packages(root)?,
        if lacks_database { ", advisories NOT RUN" } else { "" },
        ENVIRONMENTS.len()
    );
    Ok(finding)
}

fn row(check: &str, result: &str) -> Vec<String> {
    vec![check.to_owned(), result.to_owned()]
}

/// The output of cargo-deny for a check that fails.
fn deny(root: &Path, config: &Path, check: &str) -> Result<Option<String>> {
    let output = Command::new("cargo")
        .current_dir(root)
        .args(["deny", "--workspace", "--log-level", "error", "--config"])
        .arg(config)
        .args(["check", "--hide-inclusion-graph", check])
        .output()
        .context("cargo deny")?;
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok((!output.status.success()).then_some(told))
}

fn seeded_licence(context: &Context, finding: &mut Finding) -> Result<()> {
    let config = fs::read_to_string(workspace().join("deny.toml"))?;
    let stricter = config.replace("\"MIT\", ", "");
    if stricter == config {
        bail!("deny.toml does not allow MIT in a list");
    }
    let path = context.scratch("supply").join("deny.toml");
    fs::write(&path, stricter)?;
    let told = deny(workspace(), &path, "licenses")?.unwrap_or_default();
    let caught = told.contains("rejected").then(|| "cargo-deny: rejected".to_owned());
    finding.seed("a dependency whose licence is not allowed (MIT taken from the list)", caught);
    Ok(())
}

/// Makes the bill of materials of the command as a release does; whether it lacks a package that is
/// built into it.
fn materials(root: &Path, finding: &mut Finding) -> Result<bool> {
    let run = |words: &[&str]| text(Command::new("cargo").current_dir(root).args(words));
    let format = ["--output-format", "cyclone_dx_json_1_5"];
    let bill = run(&[&["sbom", "--cargo-package", "ptc-codegen"][..], &format].concat())?;
    let tree = ["tree", "--locked", "-p", "ptc-codegen", "-e", "normal", "--prefix", "none"];
    let tree = run(&tree)?;
    let built: BTreeSet<_> =
        tree.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let bill: serde_json::Value = serde_json::from_str(&bill)?;
    let listed: BTreeSet<_> = bill["components"]
        .as_array()
        .context("no components in the bill of materials")?
        .iter()
        .filter_map(|component| component["name"].as_str())
        .chain(["ptc-codegen"])
        .collect();
    let lacks = |listed: &BTreeSet<&str>| -> Vec<String> {
        built.difference(listed).map(|name| format!("{name} is not in the bill")).collect()
    };
    let mut fewer = listed.clone();
    fewer.remove("askama");
    finding.seed("a package left out of the bill of materials", lacks(&fewer).first().cloned());
    finding.failures.extend(lacks(&listed));
    Ok(!lacks(&listed).is_empty())
}

/// Packages in the lock file.
fn packages(root: &Path) -> Result<usize> {
    Ok(fs::read_to_string(root.join("Cargo.lock"))?.matches("[[package]]").count())
}

/// Variables of each environment; each also has a folder, a path of the binary and a set of
/// processors of its own.
const ENVIRONMENTS: [&[(&str, &str)]; 2] = [
    &[("LC_ALL", "C"), ("TZ", "UTC"), ("HOME", "/root")],
    &[
        ("LC_ALL", "tr_TR.UTF-8"),
        ("LANG", "de_DE.UTF-8"),
        ("TZ", "Pacific/Auckland"),
        ("HOME", "/nonexistent"),
        ("USER", "somebody"),
        ("COLUMNS", "20"),
        ("SOURCE_DATE_EPOCH", "0"),
    ],
];

/// Emits every golden from the command in each environment, and compares with generated/.
fn reproduce(context: &Context, finding: &mut Finding) -> Result<usize> {
    let root = workspace();
    let scratch = context.scratch("reproduce");
    let binary = generator()?;
    let mut goldens = context.goldens();
    goldens.extend(of_axes());
    let processors = std::thread::available_parallelism()?.get();
    for (index, variables) in ENVIRONMENTS.iter().enumerate() {
        let home = empty(&scratch.join(format!("place {index}")));
        let copy = home.join("the command");
        fs::copy(&binary, &copy)?;
        for spec in &goldens {
            // The command that every emitted file names as the way to make it.
            let line = format!(
                "exec taskset -c {} './the command' emit --lang c -o out {}",
                index % processors,
                spec.command()
            );
            let output = Command::new("sh")
                .args(["-c", &line])
                .current_dir(&home)
                .env_clear()
                .env("PATH", "/usr/bin:/bin")
                .envs(variables.iter().copied())
                .output()?;
            if !output.status.success() {
                let told = String::from_utf8_lossy(&output.stderr);
                finding.failures.push(format!("{line}: {told}"));
            }
        }
        finding.failures.extend(differences(&home.join("out"), &root.join("generated/c"))?);
    }
    let changed = empty(&scratch.join("changed"));
    fs::write(changed.join("ptc_exp1.h"), "another text\n")?;
    let told = differences(&changed, &root.join("generated/c"))?;
    finding.seed("one file of other bytes", told.first().cloned());
    Ok(goldens.len())
}

/// The files that are in one of two folders only, or of other bytes.
fn differences(found: &Path, wanted: &Path) -> Result<Vec<String>> {
    let names = |folder: &Path| -> Result<BTreeSet<PathBuf>> {
        let entries = fs::read_dir(folder).with_context(|| folder.display().to_string())?;
        entries.map(|entry| Ok(PathBuf::from(entry?.file_name()))).collect()
    };
    let all: BTreeSet<_> = names(found)?.union(&names(wanted)?).cloned().collect();
    let differs =
        |name: &PathBuf| fs::read(found.join(name)).ok() != fs::read(wanted.join(name)).ok();
    Ok(all
        .iter()
        .filter(|name| differs(name))
        .map(|name| format!("{} differs", name.display()))
        .collect())
}
