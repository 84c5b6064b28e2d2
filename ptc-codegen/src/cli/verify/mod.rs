//! `verify`: objectives over all that is uncertain, by scenarios, a search and proofs.

mod args;
mod journal;
mod page;
mod parts;
mod report;

use std::ops::Range;

use indicatif::{ProgressBar, ProgressStyle};
use ptc_codegen::verify::{self, Campaign, Scenario, Trial};

pub(crate) use args::{EXAMPLES, Verify};
use journal::Journal;
use parts::Rows;
use report::Worst;
pub(crate) use report::against;

use super::output::{self, Outputs};
use super::page as html;
use super::report::{Failure, Notice};
use super::simulate::no_plant;
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
    let mut trial =
        Trial::new(&campaign).map_err(|wrong| Failure::because(wrong.message, &wrong.help))?;
    starts(&campaign, &mut trial)?;
    if let Some(index) = request.scenario {
        let scenario = campaign.scenario(index);
        return write::to_stdout(&report::csv(&campaign, &mut trial, &scenario)?);
    }
    let (tally, journal) = match &request.shard {
        _ if !request.merge.is_empty() => parts::merge(&campaign, &request.merge, out.as_ref())?,
        shard => {
            let range = match shard {
                Some(shard) => part(shard, campaign.scenarios)?,
                None => 0..campaign.scenarios,
            };
            parts::run(&campaign, &trial, range, out.as_ref())?
        }
    };
    if let (Some(shard), Some(out)) = (&request.shard, &request.out) {
        let count = tally.scenarios;
        outputs.tell(&format!("wrote {}, part {shard} with {count} scenarios\n", out.display()))?;
        journal.into_iter().for_each(Journal::finish);
        return Ok(());
    }
    let bar = progress("searching", searched(&campaign));
    let worst: Vec<_> = (0..campaign.objectives.len())
        .map(|objective| {
            let index = tally.excess[objective].index;
            let told = |runs| bar.inc(runs as u64);
            let found = verify::search::search(&campaign, &trial, (objective, index), &told);
            Worst { drawn: tally.excess[objective], found }
        })
        .collect();
    bar.finish_and_clear();
    let proved = verify::bound::proved(&campaign);
    let verdict = report::verdict(&campaign, &mut trial, &tally, (&worst, &proved))?;
    let mut files = Vec::new();
    if let (Some(place), Some(worst)) = (worst_to, report::foremost(&worst)) {
        files.push((place, report::csv(&campaign, &mut trial, &worst.found.scenario)?));
    }
    if let Some(place) = report {
        files.push((place, page::text(request, &source, (&campaign, &mut trial), &verdict)?));
    }
    let files: Vec<_> =
        files.iter().map(|(place, text)| (place.clone(), text.as_bytes())).collect();
    output::write(&files)?;
    outputs.tell(&verdict.text(&campaign))?;
    journal.into_iter().for_each(Journal::finish);
    if verdict.holds { Ok(()) } else { Err(Failure::refused(Vec::new())) }
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
    let (spec, plant) = parsed.read_with_plant()?;
    let plant = plant.ok_or_else(no_plant)?;
    match verify::read(&parsed.entries, &spec, &plant) {
        Ok(campaign) => parsed.finish(Some(campaign), Vec::new()),
        Err(found) => parsed.finish(None, found),
    }
}

/// An objective that fails at t0, whatever the control does, says nothing of the loop.
pub(crate) fn starts(campaign: &Campaign, trial: &mut Trial) -> Result<(), Failure> {
    let wrong =
        |wrong: ptc_codegen::simulate::Failure| Failure::because(wrong.message, &wrong.help);
    let of_gain = Campaign { objectives: vec![campaign.gain()], ..campaign.clone() };
    let mut gain = Trial::new(&of_gain).map_err(wrong)?;
    // Every fourth scenario is a corner of the boxes.
    for index in 0..campaign.scenarios.min(1024) {
        let scenario = campaign.scenario(index);
        let setting = campaign.setting(&scenario);
        if gain.at_start(&setting).map_err(wrong)?.iter().any(|excess| *excess >= 0.0) {
            return Err(Failure::because(
                format!(
                    "the gain of the plant is 0 or has another sign than g, at {}",
                    told(campaign, &scenario)
                ),
                "Theorem 1 asks for |b| < |g| of a gain that is not known: narrow its bounds under [plant]",
            ));
        }
        let excess = trial.at_start(&setting);
        let excess = excess.map_err(wrong)?;
        for (number, (objective, excess)) in (1..).zip(campaign.objectives.iter().zip(excess)) {
            if objective.is_of_state() && excess > 0.0 {
                return Err(Failure::because(
                    format!(
                        "objective {number}, {objective}, fails at t0 already, from x0 = {:?}",
                        setting.x0
                    ),
                    "whatever the control does: widen the bound at dt = 0, or narrow the box of initial states under [verify]",
                ));
            }
        }
    }
    Ok(())
}

/// The scenarios of part I of N.
fn part(text: &str, scenarios: u64) -> Result<Range<u64>, Failure> {
    let numbers = text.split_once('/').and_then(|(i, n)| {
        let (i, n) = (i.parse::<u64>().ok()?, n.parse::<u64>().ok()?);
        (1..=n).contains(&i).then_some((i, n))
    });
    let Some((i, n)) = numbers else {
        return Err(Failure::because(
            format!("--shard {text} is no part"),
            "write I/N, the I-th of N parts, I from 1 to N: --shard 3/64",
        ));
    };
    let at = |part: u64| {
        let share = u128::from(scenarios) * u128::from(part) / u128::from(n);
        u64::try_from(share).unwrap_or(scenarios)
    };
    Ok(at(i - 1)..at(i))
}

fn searched(campaign: &Campaign) -> u64 {
    (campaign.search * campaign.objectives.len()) as u64
}

/// A bar on the standard error, where that is a terminal.
pub(crate) fn progress(what: &'static str, count: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len}, {eta} left");
    let bar = ProgressBar::new(count).with_message(what);
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// The scenario of a search, as one would ask for it again.
pub(crate) fn told(campaign: &Campaign, scenario: &Scenario) -> String {
    let setting = campaign.setting(scenario);
    let mut parts =
        vec![format!("tau = {}", setting.values.get(ptc_codegen::spec::Parameter::Tau))];
    parts.extend((1..).zip(&setting.x0).map(|(j, x)| format!("x{j} = {x}")));
    for (symbol, _) in &campaign.intervals {
        parts.push(format!("{} = {}", symbol.spelling(), setting.values.get(*symbol)));
    }
    parts.extend(
        campaign
            .signals(scenario)
            .iter()
            .map(|(symbol, signal)| format!("{} {}", symbol.spelling(), signal.name())),
    );
    parts.join(", ")
}

fn unwritable(notice: Notice) -> Failure {
    Failure::bad_input(vec![notice])
}
