//! `verify`: objectives over all that is uncertain, by scenarios, a search and proofs.

mod args;
mod draws;
mod journal;
mod page;
mod parts;
mod program;
mod runner;

use std::ops::Range;

use crate::request;
use crate::verify::{self, Campaign, End, Known, Trial, csv, possible, shard, summary};

pub(crate) use args::{EXAMPLES, Verify};
use journal::Journal;
use parts::Rows;

use super::output::{self, Outputs};
use super::page as html;
use super::progress::{checking, progress};
use super::report::Failure;
use super::source::Source;
use super::write;

/// Runs `verify`.
pub(crate) fn verify(request: &Verify) -> Result<(), Failure> {
    html::named(request.report.as_deref())?;
    let mut outputs = Outputs::default();
    request.design.design.iter().for_each(|path| outputs.reads("the design", path));
    request.merge.iter().for_each(|path| outputs.reads("a part to merge", path));
    let out = Rows::plan(&mut outputs, request.out.as_deref())?;
    let worst_to = outputs.optional("--worst", request.worst.as_deref())?;
    let report = outputs.optional("--report", request.report.as_deref())?;
    let mut source = request.spec.0.with_design(request.design.design.as_deref())?;
    request.plant.iter().for_each(|text| source.give_plant(text));
    let campaign = campaign(request, &source)?;
    // Its folder is there as long as the processes of the trial.
    let _program;
    let mut trial = checking(|| Trial::new(&campaign))?;
    possible(&campaign, &mut trial)?;
    if let Some(text) = &request.scenario {
        return replay(&campaign, &mut trial, text);
    }
    let (drawn, journal) = match &request.shard {
        _ if !request.merge.is_empty() => parts::merge(&campaign, &request.merge, out.as_ref())?,
        given => {
            let range = match given {
                Some(text) => part(text, campaign.scenarios)?,
                None => 0..campaign.scenarios,
            };
            let scenarios = range.end - range.start;
            _program = runner::prepare(request.runner, &campaign, &mut trial, scenarios)?;
            parts::run(&campaign, &trial, range, out.as_ref())?
        }
    };
    if let (Some(shard), Some(out)) = (&request.shard, &request.out) {
        runner::faults(&trial);
        let count = drawn.tally.scenarios;
        outputs
            .tell(&format!("wrote {}, part {shard} with {count} scenarios\n", write::shown(out)))?;
        journal.into_iter().for_each(Journal::finish);
        return Ok(());
    }
    let bar = progress("searching", campaign.searched());
    let told = |runs| bar.inc(runs as u64);
    let known = Known::beyond(&campaign, &trial, &drawn.tally, &told);
    bar.finish_and_clear();
    runner::faults(&trial);
    let summary = summary(&campaign, &mut trial, &known);
    let mut files = Vec::new();
    if let (Some(place), Some(worst)) = (worst_to, known.foremost()) {
        let (csv, _) = csv(&campaign, &mut trial, &worst.scenario);
        files.push((place, csv));
    }
    if let Some(place) = report {
        files.push((
            place,
            page::text(request, &source, (&campaign, &mut trial), (&summary, &drawn))?,
        ));
    }
    let files: Vec<_> =
        files.iter().map(|(place, text)| (place.clone(), text.as_bytes())).collect();
    output::write(&files)?;
    outputs.tell(&summary.text(&campaign))?;
    journal.into_iter().for_each(Journal::finish);
    match summary.end() {
        End::Holds => Ok(()),
        End::Fails => Err(Failure::refused(Vec::new())),
        End::Undecided => Err(Failure::undecided(Vec::new())),
    }
}

/// Prints the trajectory of one scenario: a draw by its index, or any that is written out.
fn replay(campaign: &Campaign, trial: &mut Trial, text: &str) -> Result<(), Failure> {
    let scenario = match text.trim().parse() {
        Ok(index) => campaign.scenario(index),
        Err(_) => {
            campaign.replayed(text).map_err(|(message, help)| Failure::because(message, &help))?
        }
    };
    let (csv, ended) = csv(campaign, trial, &scenario);
    write::to_stdout(&csv)?;
    ended.map_or(Ok(()), |ended| Err(ended.into()))
}

fn campaign(request: &Verify, source: &Source) -> Result<Campaign, Failure> {
    let mut source = source.clone();
    let flags = [("scenarios", &request.scenarios), ("seed", &request.seed)];
    for (key, text) in flags {
        if let Some(text) = text {
            source.give_key(&format!("verify.{key}"), &format!("--{key}"), text);
        }
    }
    let parsed = source.parse();
    let read = request::read(&parsed.entries)
        .and_then(|spec| verify::read_with_plant(&parsed.entries, &spec));
    match read {
        Ok(campaign) => parsed.finish(Some(campaign), Vec::new()),
        Err(found) => parsed.finish(None, found),
    }
}

/// The scenarios of part I of N.
fn part(text: &str, scenarios: u64) -> Result<Range<u64>, Failure> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    numbers.and_then(|(i, n)| shard(i, n, scenarios)).ok_or_else(|| {
        Failure::because(
            format!("--shard {text} is not a part"),
            "write I/N, the I-th of N parts, I from 1 to N: --shard 3/64",
        )
    })
}
