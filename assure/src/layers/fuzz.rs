//! Random controllers: C, Rust and the interpreter give the same bits, and all of them what the
//! definition gives in long arithmetic.

mod compare;
mod draw;

use std::fs;
use std::path::Path;
use std::time::Instant;

use anyhow::Result;
use ptc_codegen::check::examine::examine;
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use self::compare::{Counts, Difference, compare};
use self::draw::{Keys, keys, simpler, spec};
use super::seeded::with_defect;
use crate::context::Context;
use crate::harness::machine::Machine;
use crate::harness::program::{Program, in_c, in_c_from, in_rust};
use crate::harness::random::Random;
use crate::harness::records::records;
use crate::harness::{STRICT, empty, in_pairs};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{GCC, RUSTC};

pub(super) const LAYER: Layer = Layer {
    name: "fuzz",
    claim: "For random controllers, C and Rust give the bits of the interpreter where no function of \
            a library is called, and u is that of the definition, in long arithmetic, to within the \
            accuracy that is promised.",
    tools: &[GCC, RUSTC],
    run,
};

/// Controllers of a round, all of one kind of mapping and one precision: one Rust program.
const ROUND: usize = 16;
/// Records of a controller.
const RECORDS: usize = 300;
/// Number of differences that are shrunk and reported before it ends.
const ENOUGH: usize = 3;

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("fuzz");
    let mut random = Random(context.seed);
    let mut finding = Finding::default();
    let (mut counts, mut rounds) = (Counts::default(), 0);
    let began = Instant::now();
    while began.elapsed() < context.time && finding.failures.len() < ENOUGH {
        rounds += 1;
        let drawn = round(&mut random);
        counts.refused += ROUND - drawn.len();
        let specs: Vec<_> = drawn.iter().map(|(_, spec)| spec.clone()).collect();
        let found = examined(&folder, &specs, random.bits(), &mut counts);
        for (index, difference) in found.into_iter().take(ENOUGH) {
            let (keys, difference) = shrunk(&folder, drawn[index].0.clone(), difference);
            let command = spec(&keys).map(|spec| spec.command()).unwrap_or_default();
            finding.failures.push(format!("ptc-codegen emit --lang c {command}\n{difference}"));
        }
    }
    let Counts { specs, refused, calls, references, statuses, worst } = &counts;
    finding.summary = format!(
        "{specs} random controllers, {calls} calls in both languages, {references} of them against the \
         definition, {} differences",
        finding.failures.len()
    );
    let row = |(status, count): (&i32, &usize)| vec![status.to_string(), count.to_string()];
    finding.tables.push(Table {
        title: "Calls of step by status (-1 from init)".to_owned(),
        head: vec!["status", "calls"],
        rows: statuses.iter().map(row).collect(),
    });
    let row = |(kind, share): (&(String, &'static str), &f64)| {
        vec![kind.0.clone(), kind.1.to_owned(), format!("{share:.2}")]
    };
    finding.tables.push(Table {
        title: "Worst error of u, as a part of what is allowed".to_owned(),
        head: vec!["mapping", "precision", "part"],
        rows: worst.iter().map(row).collect(),
    });
    finding.notes.push(format!(
        "{rounds} rounds; {refused} of the random designs were refused by the checks. The number of \
         rounds depends on the machine: `cargo assure fuzz --minutes 10 --seed 7` draws for longer."
    ));
    seeded(context, &folder, &mut finding)?;
    Ok(finding)
}

/// The controllers of a round, as keys and as specs; those that the checks refuse are left out.
fn round(random: &mut Random) -> Vec<(Keys, Spec)> {
    let kind = draw::Kind::new(random);
    let all = (0..ROUND).map(|index| keys(random, kind, &format!("fuzzed{index}")));
    all.filter_map(|keys| Some((keys.clone(), spec(&keys)?))).collect()
}

/// The differences that a set of controllers shows, with the index of each controller.
fn examined(
    folder: &Path,
    specs: &[Spec],
    seed: u64,
    counts: &mut Counts,
) -> Vec<(usize, Difference)> {
    let folder = empty(&folder.join("round"));
    let programs: Vec<_> =
        specs.iter().zip(in_c(&folder, specs)).zip(in_rust(&folder, specs)).enumerate().collect();
    let told = in_pairs(&programs, |(index, ((spec, c), rust))| {
        let records = records(spec, &mut Random(seed ^ *index as u64), RECORDS);
        compare(spec, &records, &c.run(&records), &rust.run(&records))
    });
    let mut found = Vec::new();
    for (index, (own, difference)) in told.into_iter().enumerate() {
        counts.add(own);
        found.extend(difference.map(|difference| (index, difference)));
    }
    found
}

/// A simpler controller that shows a difference too, and that difference.
fn shrunk(folder: &Path, mut keys: Keys, mut difference: Difference) -> (Keys, Difference) {
    while let Some((next, other)) = simpler(&keys).into_iter().find_map(|keys| {
        let spec = spec(&keys)?;
        let found = examined(folder, &[spec], 1, &mut Counts::default());
        Some((keys, found.into_iter().next()?.1))
    }) {
        (keys, difference) = (next, other);
    }
    (keys, difference)
}

/// Text of the emitted C of the example, what takes its place, and what it is.
const DEFECTS: [(&str, &str, &str); 3] = [
    ("inv_T) + (self->c2 * x[1])", "inv_T) - (self->c2 * x[1])", "one operation changed in step"),
    ("k1 / (a * a)", "k1 / a / a", "one rounding more in a coefficient"),
    ("(past < self->hold_from)", "(past <= 2.0 * self->hold_from)", "the hold begun too early"),
];

fn seeded(context: &Context, folder: &Path, finding: &mut Finding) -> Result<()> {
    let spec = examine(&context.example()).spec;
    let records = records(&spec, &mut Random(context.seed), 10 * RECORDS);
    let rust: Vec<Program> =
        in_rust(&empty(&folder.join("seeded_rust")), std::slice::from_ref(&spec));
    for (index, defect) in DEFECTS.into_iter().enumerate() {
        let folder = folder.join(format!("seeded{index}"));
        let files = with_defect(&folder, &spec, Language::C, defect)?;
        let sources: Vec<_> =
            files.into_iter().filter(|file| file.extension().is_some_and(|e| e == "c")).collect();
        let c = in_c_from(Machine::Host, &folder, &spec, &sources, &STRICT.map(str::to_owned));
        let (_, told) = compare(&spec, &records, &c.run(&records), &rust[0].run(&records));
        finding.seed(defect.2, told.map(|difference| difference.kind().to_owned()));
    }
    // The same defect on both sides, which only the definition reveals.
    let outcomes = rust[0].run(&records);
    let bent: Vec<_> = outcomes
        .iter()
        .map(|outcome| {
            let mut outcome = *outcome;
            outcome.step.1 *= 1.0 + 1e-12;
            outcome
        })
        .collect();
    let told = compare::against_definition(&spec, &records, &bent);
    finding.seed("u wrong by 1e-12 in both languages", told.map(|found| found.kind().to_owned()));
    let _ = fs::remove_dir_all(folder.join("round"));
    Ok(())
}
