//! `check`: what every check says of a design.

use std::fmt::Write;

use ptc_codegen::check::Outcome;
use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use serde_json::json;

use super::args::{Check, ListFormat};
use super::report::Failure;
use super::write;

/// Runs `check`.
pub(crate) fn check(request: &Check) -> Result<(), Failure> {
    let source = request.spec.0.with_design(request.design.design.as_deref())?;
    let given = source.parse();
    let spec = request.engine.engine.prepare(given.read()?)?;
    let report = examine(&spec);
    let refused = report.refusals().next().is_some();
    write::to_stdout(&match request.format {
        ListFormat::Text => text(&report, refused),
        ListFormat::Json => json(&report, refused),
    })?;
    if refused {
        return Err(Failure::refused(Vec::new()));
    }
    // No check looks at coefficients that overflow.
    if let Err(found) = generate(&spec, Language::C) {
        return given.finish(None, found);
    }
    match report.undecided().next() {
        Some(_) => Err(Failure::undecided(Vec::new())),
        None => Ok(()),
    }
}

fn text(report: &Report, refused: bool) -> String {
    let spec = &report.spec;
    let mut out = format!("{}: order n = {}, {}\n", spec.name(), spec.n, spec.command());
    for outcome in &report.outcomes {
        let verdict = outcome.verdict.text();
        let _ = writeln!(out, "\n{:<11} {verdict}: {}", outcome.name, outcome.summary);
        for detail in &outcome.details {
            let _ = writeln!(out, "            - {detail}");
        }
        if let Some(fix) = &outcome.fix {
            let _ = writeln!(out, "            fix: {fix}");
        }
    }
    let names = |outcomes: &mut dyn Iterator<Item = &Outcome>| {
        outcomes.map(|outcome| outcome.name).collect::<Vec<_>>().join(", ")
    };
    let open = names(&mut report.undecided());
    let verdict = match (refused, open.is_empty()) {
        (true, _) => format!("refused: {}", names(&mut report.refusals())),
        (false, true) => "accepted".to_owned(),
        (false, false) => format!("accepted; undecided: {open}"),
    };
    let _ = writeln!(out, "\n{verdict}");
    out
}

fn json(report: &Report, refused: bool) -> String {
    let checks: Vec<_> = report
        .outcomes
        .iter()
        .map(|outcome| {
            json!({
                "name": outcome.name,
                "verdict": outcome.verdict.text(),
                "summary": outcome.summary,
                "details": outcome.details,
                "fix": outcome.fix,
            })
        })
        .collect();
    let design = json!({
        "name": report.spec.name(),
        "command": report.spec.command(),
        "accepted": !refused,
        "undecided": report.undecided().map(|outcome| outcome.name).collect::<Vec<_>>(),
        "checks": checks,
    });
    format!("{design}\n")
}
