//! The seams between commands and between checks, with random designs of every kind.

mod compiled;
mod contradictions;
mod design;
mod draw;
mod edges;
mod left_out;
mod one;
mod spelling;

use std::collections::BTreeMap;

use anyhow::Result;
use serde_json::json;

use super::command::generator;
use crate::context::Context;
use crate::harness::in_pairs;
use crate::harness::random::Random;
use crate::layer::{Finding, Layer, Table};
use crate::tool::GCC;
use design::Design;
use left_out::Said;
use one::{Answers, Defect, World};

pub(super) const LAYER: Layer = Layer {
    name: "seams",
    claim: "Of random designs of every kind all commands name one resolved design, its emitted C gives the bits of \
            the run that was judged, and `--resolved` gives it back; no two statements of a report, and of a run, \
            contradict; expressions rewritten by identities keep their verdicts; a key that is left out makes no \
            acceptance of a refusal; and a bound that is met exactly is neither kept nor exceeded.",
    tools: &[GCC],
    run,
};

/// Designs in a full run and in a brief one, and designs of known truth.
const FULL: [usize; 2] = [1000, 90];
const BRIEF: [usize; 2] = [60, 9];

/// Findings on one design.
struct Judged {
    kind: &'static str,
    /// Why it could not be read.
    unread: Option<String>,
    /// True if `check` accepts it, with nothing undecided.
    is_accepted: bool,
    answers: Option<Answers>,
    faults: Vec<String>,
}

fn run(context: &Context) -> Result<Finding> {
    let world = World { command: &generator()?, folder: context.scratch("seams") };
    let [count, edges] = if context.brief { BRIEF } else { FULL };
    let designs = draw::designs(context.seed, count);
    let all: Vec<_> = (0..).zip(&designs).collect();
    let judged = in_pairs(&all, |(index, design)| judged(&world, *index, design, context.seed));
    let mut finding = Finding::default();
    let mut rows = BTreeMap::<&str, [usize; 4]>::new();
    for one in &judged {
        let row = rows.entry(one.kind).or_default();
        row[0] += 1;
        row[1] += usize::from(one.unread.is_some());
        row[2] += usize::from(one.is_accepted);
        row[3] += one.faults.len();
        finding.failures.extend(one.faults.iter().cloned());
    }
    let unread = judged.iter().filter_map(|one| one.unread.as_deref());
    let reasons: Vec<_> = unread.collect();
    if reasons.len() * 20 > designs.len() {
        finding.failures.push(format!(
            "{} of {count} designs are not read: {}",
            reasons.len(),
            reasons.join("; ")
        ));
    }
    let (bounds, wrong) = edges::faults(&world, context.seed, edges, 1.0)?;
    finding.failures.extend(wrong);
    finding.summary =
        format!("{} designs, {bounds} bounds at the truth and beside it", count - reasons.len());
    finding.tables.push(Table {
        title: "Designs".to_owned(),
        head: vec!["kind", "drawn", "not read", "accepted", "faults"],
        rows: rows
            .iter()
            .map(|(kind, counts)| {
                [vec![(*kind).to_owned()], counts.iter().map(usize::to_string).collect()].concat()
            })
            .collect(),
    });
    seeds(&world, (&designs, &judged), context, &mut finding)?;
    Ok(finding)
}

fn judged(world: &World<'_>, index: usize, design: &Design, seed: u64) -> Judged {
    let none = Judged {
        kind: design.kind,
        unread: None,
        is_accepted: false,
        answers: None,
        faults: Vec::new(),
    };
    if let Err(why) = design.spec() {
        return Judged { unread: Some(why), ..none };
    }
    let shown = |fault: String| format!("{}: {fault}\n{}", design.kind, design.text());
    let answers = match world.answers(index, design, None) {
        Ok(answers) => answers,
        Err(error) => return Judged { faults: vec![shown(format!("{error:#}"))], ..none },
    };
    let mut faults: Vec<_> = one::faults(&answers).into_iter().map(shown).collect();
    faults.extend(contradictions::faults(&answers).into_iter().map(shown));
    let mut random = Random(seed ^ (index as u64) << 20);
    let other = design.spelled(&mut |text| spelling::rewritten(text, &mut random));
    if other.text() != design.text() {
        faults.extend(spelling::faults(design, &other));
    }
    faults.extend(left_out::faults(design, &said));
    Judged { is_accepted: answers.exit == 0, answers: Some(answers), faults, ..none }
}

/// Returns the report of the checks on a design.
fn said(design: &Design) -> Option<Said> {
    Some(Said::of(&design.report()?))
}

/// Defects of each kind, each in the first design in which it counts.
fn seeds(
    world: &World<'_>,
    (designs, judged): (&[Design], &[Judged]),
    context: &Context,
    finding: &mut Finding,
) -> Result<()> {
    let accepted = || designs.iter().zip(judged).filter(|(_, judged)| judged.is_accepted);
    for (defect, told) in [
        (Defect::OtherValue, "verify chooses a value of its own"),
        (
            Defect::OtherConstant,
            "a constant of the emitted C that differs from the verdict's in one digit",
        ),
    ] {
        let mut caught = None;
        for (index, (design, _)) in accepted().take(8).enumerate() {
            caught = caught
                .or(one::faults(&world.answers(index, design, Some(defect))?).into_iter().next());
        }
        finding.seed(told, caught);
    }
    let reports = || judged.iter().filter_map(|judged| judged.answers.as_ref());
    for (told, change) in CONTRADICTIONS {
        let changed = reports().filter_map(|answers| {
            let mut answers = answers.clone();
            change(&mut answers);
            contradictions::faults(&answers).into_iter().next()
        });
        finding.seed(told, changed.into_iter().next());
    }
    let others = designs.iter().filter(|design| design.report().is_some());
    let wrong =
        others.map(|design| (design, design.spelled(&mut |text| format!("exp(3*({text}))"))));
    let caught = wrong.filter(|(design, other)| design.text() != other.text());
    let caught = caught.flat_map(|(design, other)| spelling::faults(design, &other));
    finding.seed("a rewriting that is not an identity", caught.into_iter().next());
    let accepts = |design: &Design| {
        let mut said = said(design)?;
        if !design.gives("error") || !design.gives("x0_max") {
            said.accept();
        }
        Some(said)
    };
    let caught = designs.iter().flat_map(|design| left_out::faults(design, &accepts)).next();
    finding.seed("a check that accepts where it lacks a key", caught);
    for scale in context.in_turn(vec![1.001, 0.999]) {
        let (_, wrong) = edges::faults(world, context.seed, 3, scale)?;
        finding.seed(&format!("a truth that is multiplied by {scale}"), wrong.into_iter().next());
    }
    Ok(())
}

/// Name of a contradiction in answers, and the change that causes it.
type Contradiction = (&'static str, fn(&mut Answers));

/// Changes of answers that make them contradict themselves.
const CONTRADICTIONS: [Contradiction; 6] = [
    ("growth refuses what loop proves", |answers| set(answers, "growth", "unsound")),
    ("an undecided check that the report does not list", |answers| {
        set(answers, "membership", "undecided");
    }),
    ("a bound of the loop beyond the error that it holds", |answers| {
        answers.error.iter_mut().for_each(|error| *error = 0.0);
    }),
    ("verify fails what loop proves", |answers| answers.verdicts = vec!["fails".to_owned()]),
    ("verify proves what loop excludes", |answers| {
        answers.verdicts = ["", "holds, proved by the worst case"].map(str::to_owned).to_vec();
    }),
    ("a run beyond the bounds of the loop", |answers| {
        answers.run.iter_mut().for_each(|row| row.u.iter_mut().for_each(|u| *u *= 1e6));
    }),
];

fn set(answers: &mut Answers, name: &str, verdict: &str) {
    for check in answers.report["checks"].as_array_mut().into_iter().flatten() {
        if check["name"] == name {
            check["verdict"] = json!(verdict);
        }
    }
}
