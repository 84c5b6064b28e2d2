//! Reports of runs, opened in a browser.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};
use serde_json::Value;

use super::command::generator;
use crate::context::Context;
use crate::harness::command::{succeed, text};
use crate::harness::runtime;
use crate::layer::{Finding, Layer, Table};
use crate::tool::{CHROMIUM, PYTHON};

pub(super) const LAYER: Layer = Layer {
    name: "report",
    claim: "A report of `simulate` or `verify` opens in Chromium and requests nothing but itself; \
            its formulas and figures are laid out, light and dark, down to a width of 360 px.",
    tools: &[CHROMIUM, PYTHON],
    run,
};

const SCRIPT: &str = include_str!("report.py");

/// Package that drives the browser.
const PLAYWRIGHT: &str = "playwright==1.65.2";

/// Every family and a mapping of its own, with a plant.
const MAPPINGS: [&str; 9] = [
    "mu = \"exp(a=0.5)\"",
    "mu = \"rational(a=2)\"",
    "mu = \"power(a=1, m=2)\"",
    "mu = \"tan(a=1)\"",
    "mu = \"tanh(a=0.2)\"",
    "mu = \"algebraic(a=1)\"",
    "mu = \"exp_sum(rates=[0.2, 0.4])\"",
    "kappa = \"-ln(1 - dt/tau) + dt/tau\"",
    "mu = \"tau*(1 - exp(-t - t^2))\"",
];

const VERIFIED: &str = "[verify]\nx1 = [0.5, 1]\nx2 = 0\nx3 = 0\nscenarios = 8\nsearch = 10\n\
                        [[objective]]\nbound = \"state\"\nsigma = 200\n[[objective]]\n\
                        bound = \"input\"\nupsilon = \"400*exp(-dt/tau)\"\n[[objective]]\n\
                        bound = \"within\"\nh = \"x1\"\nlow = -2\nhigh = 2\n";

/// Least size of letters in a figure, in px.
const LETTERS: f64 = 9.0;

/// A picture that a page would ask the network for.
const PICTURE: &str = "<img src=\"http://example.com/x.png\" alt=\"\"/></body>";

fn design(mapping: &str) -> String {
    format!(
        "name = \"stage\"\nn = 3\n{mapping}\ngains = [40, 30, 10]\n[params]\ntau = 1\n[plant]\n\
         f = \"-0.3*x2*abs(x2) + 0.1*sin(3*t)\"\n"
    )
}

fn run(context: &Context) -> Result<Finding> {
    let python = runtime::python(&context.shared("playwright"), &[PLAYWRIGHT])?;
    let command = generator()?;
    let folder = context.scratch("report");
    let mut pages = Vec::new();
    for (index, mapping) in context.in_turn(MAPPINGS.to_vec()).into_iter().enumerate() {
        let name = format!("simulated{index}");
        let asked = ["simulate", "--x0", "1,0,0", "--at", "0,0.5,0.99"];
        pages.push(page(&command, &folder, &name, &design(mapping), &asked)?);
    }
    let verified = format!("{}{VERIFIED}", design(MAPPINGS[0]));
    pages.push(page(&command, &folder, "verified", &verified, &["verify"])?);
    let seeds = context.in_turn(seeds(&pages[0], &folder)?);
    let all: Vec<_> = pages.iter().chain(seeds.iter().map(|(_, path)| path)).collect();
    let script = folder.join("report.py");
    fs::write(&script, SCRIPT)?;
    let mut look = Command::new(&python);
    let told = text(look.arg(&script).arg("chromium").args(&all))?;
    let seen = told.lines().map(serde_json::from_str).collect::<Result<Vec<Value>, _>>()?;
    ensure!(seen.len() == all.len(), "{} pages were opened of {}", seen.len(), all.len());
    let mut finding = Finding::default();
    let mut rows = Vec::new();
    for (path, seen) in pages.iter().zip(&seen) {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        finding.failures.extend(faults(seen).into_iter().map(|fault| format!("{name}: {fault}")));
        let size = fs::metadata(path)?.len();
        let light = &seen["views"]["light.1400"];
        rows.push(vec![name.into_owned(), size.to_string(), light["formulas_seen"].to_string()]);
    }
    for ((defect, _), seen) in seeds.iter().zip(&seen[pages.len()..]) {
        finding.seed(defect, faults(seen).into_iter().next());
    }
    let formulas: u64 = seen[..pages.len()]
        .iter()
        .filter_map(|seen| seen["views"]["light.1400"]["formulas_seen"].as_u64())
        .sum();
    finding.summary = format!("{} reports, {formulas} formulas, no request", pages.len());
    finding.tables.push(Table {
        title: "Reports".to_owned(),
        head: vec!["report", "bytes", "formulas"],
        rows,
    });
    Ok(finding)
}

/// The report of a design, and its path.
fn page(
    command: &Path,
    folder: &Path,
    name: &str,
    design: &str,
    asked: &[&str],
) -> Result<PathBuf> {
    let path = folder.join(format!("{name}.html"));
    let file = format!("{name}.toml");
    fs::write(folder.join(&file), design)?;
    let mut run = Command::new(command);
    run.args(asked).arg(&file).arg("--report").arg(&path).current_dir(folder);
    succeed(&mut run)?;
    Ok(path)
}

/// The first report with defects put in on purpose.
fn seeds(page: &Path, folder: &Path) -> Result<Vec<(&'static str, PathBuf)>> {
    let good = fs::read_to_string(page)?;
    let policy = good.lines().find(|line| line.contains("Content-Security-Policy"));
    let policy = policy.context("a report has a policy")?;
    let with_picture = good.replace("</body>", PICTURE);
    let defects = [
        ("a picture from the network, without the policy", with_picture.replace(policy, "")),
        ("a picture from the network, which the policy refuses", with_picture),
        ("formulas that are not shown", good.replace("math { ", "math { display: none; ")),
        ("a figure that stays white on a dark page", good.replace("fill:#161b22", "")),
        ("a figure that shrinks with the page", good.replace("figure svg {", ".none {")),
        ("a line that is wider than the page", good.replace("overflow-x: auto", "")),
    ];
    let written = defects.into_iter().enumerate().map(|(index, (defect, bad))| {
        ensure!(bad != good, "no place for the defect: {defect}");
        let path = folder.join(format!("defect{index}.html"));
        fs::write(&path, bad)?;
        Ok((defect, path))
    });
    written.collect()
}

/// Lists the faults of a page, from the view of the browser.
fn faults(seen: &Value) -> Vec<String> {
    let mut faults = Vec::new();
    for (key, told) in [("requests", "requests"), ("refused", "the browser says")] {
        let texts = seen[key].as_array().into_iter().flatten().filter_map(Value::as_str);
        faults.extend(texts.map(|text| format!("{told} {text}")));
    }
    let mut papers = BTreeSet::new();
    for (view, looked) in seen["views"].as_object().into_iter().flatten() {
        let count = |key: &str| looked[key].as_u64().unwrap_or(0);
        let (all, shown) = (count("formulas"), count("formulas_seen"));
        if all == 0 || shown < all {
            faults.push(format!("{view}: {shown} of {all} formulas have a size"));
        }
        if count("figures_seen") == 0 || count("text") < 1000 {
            faults.push(format!("{view}: no figure, or next to no text"));
        }
        let letters = looked["letters"].as_f64().unwrap_or(0.0);
        if letters < LETTERS {
            faults.push(format!("{view}: letters of {letters:.1} px in a figure"));
        }
        if looked["too_wide"] != Value::Bool(false) {
            faults.push(format!("{view}: wider than the page"));
        }
        if looked["paper"] != looked["figure_paper"] {
            faults.push(format!("{view}: {} on {}", looked["figure_paper"], looked["paper"]));
        }
        papers.insert(looked["paper"].to_string());
    }
    if papers.len() != 2 {
        faults.push(format!("light and dark pages are {papers:?}"));
    }
    if seen["printed"].as_u64().unwrap_or(0) < 10_000 {
        faults.push("next to nothing is printed".to_owned());
    }
    faults
}
