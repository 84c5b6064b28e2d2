//! `compare`: a design beside the controllers that engineers use instead.

mod args;
mod json;
mod picture;
mod text;

use crate::compare::{Comparison, Nominal, Scenes};
use crate::limits::RIVALS;
use crate::request;
use crate::simulate::Failure as Ended;
use crate::verify::{self, Campaign};

pub(crate) use args::{Compare, EXAMPLES};

use super::flags::ListFormat;
use super::output::{self, Outputs};
use super::picture::{file_of, format_of};
use super::progress::{checking, progress};
use super::report::{Failure, note};
use super::source::Source;

/// Draws that are run where no flag says how many.
const DRAWS: u64 = 256;

/// Runs `compare`.
pub(crate) fn compare(request: &Compare) -> Result<(), Failure> {
    let format = request.plot.as_deref().map(format_of).transpose()?;
    let bandwidth = request.bandwidth.as_deref().map(bandwidth).transpose()?;
    let mut outputs = Outputs::default();
    request.design.design.iter().for_each(|path| outputs.reads("the design", path));
    let plot = outputs.optional("--plot", request.plot.as_deref())?;
    let mut source = request.spec.0.with_design(request.design.design.as_deref())?;
    request.plant.iter().for_each(|text| source.give_plant(text));
    let campaign = campaign(request, source)?;
    let scenes = scenes(request, &campaign)?;
    let comparison = compared(&campaign, &scenes, bandwidth)?;
    if let (Some(place), Some(format)) = (plot, format) {
        let file = file_of(format, &picture::figure(&campaign, &comparison)?)?;
        output::write(&[(place, &file)])?;
    }
    outputs.tell(&match request.format {
        ListFormat::Text => text::text(request, &campaign, &scenes, &comparison),
        ListFormat::Json => json::json(&campaign, &scenes, &comparison),
    })
}

fn compared(
    campaign: &Campaign,
    scenes: &Scenes,
    bandwidth: Option<f64>,
) -> Result<Comparison, Ended> {
    let bar = progress("comparing", scenes.all.len() as u64);
    Comparison::new(campaign, scenes, bandwidth, &|| bar.inc(1))
}

/// The campaign of a design, with the start that a flag gives.
fn campaign(request: &Compare, mut source: Source) -> Result<Campaign, Failure> {
    let given = source.parse();
    let spec = given.read()?;
    if let Err(found) = spec.needs_law("compare") {
        return given.finish(None, found);
    }
    // A plant that is not supported comes before a key that is missing.
    Nominal::of(&spec)?;
    let states = spec.state_names();
    if let Some(text) = &request.x0 {
        let given: Vec<_> = text.split(',').collect();
        if given.len() != states.len() {
            let message = format!("--x0 {text}: {} values", given.len());
            let help = format!("give {}: {}", states.len(), states.join(", "));
            return Err(Failure::because(message, &help));
        }
        for (state, value) in states.iter().zip(given) {
            source.give_key(&format!("verify.{state}"), "--x0", value);
        }
    }
    for (key, text) in [("scenarios", &request.scenarios), ("seed", &request.seed)] {
        if let Some(text) = text {
            source.give_key(&format!("verify.{key}"), &format!("--{key}"), text);
        }
    }
    let parsed = source.parse();
    let has_start = parsed.entries.iter().any(|entry| entry.key.starts_with("verify."));
    if !has_start {
        let message = "the design has no state to start from".to_owned();
        let help = format!(
            "give --x0 {}, or the box of initial states under [verify]",
            vec!["0.1"; states.len()].join(",")
        );
        return Err(Failure::because(message, &help));
    }
    if parsed.entries.iter().any(|entry| entry.key.starts_with("event[")) {
        note("the events of the design are of `simulate` and `verify`: they are left out here");
    }
    let read = request::read(&parsed.entries)
        .and_then(|spec| checking(|| verify::read_scenarios(&parsed.entries, &spec)));
    match read {
        Ok(campaign) => parsed.finish(Some(campaign), Vec::new()),
        Err(found) => parsed.finish(None, found),
    }
}

/// The scenarios that are run.
fn scenes(request: &Compare, campaign: &Campaign) -> Result<Scenes, Failure> {
    let draws = match request.scenarios {
        Some(_) => campaign.scenarios,
        None => campaign.scenarios.min(DRAWS),
    };
    if draws > RIVALS.most {
        let size = usize::try_from(draws).unwrap_or(usize::MAX);
        return Err(Failure::because(RIVALS.exceeded("--scenarios", size), RIVALS.fix));
    }
    Ok(Scenes::of(campaign, draws))
}

/// A bandwidth in rad/s.
fn bandwidth(text: &str) -> Result<f64, Failure> {
    let number = text.trim().parse().ok().filter(|own: &f64| own.is_finite() && *own > 0.0);
    number.ok_or_else(|| {
        Failure::because(
            format!("--bandwidth {text} is not a number > 0"),
            "give rad/s, for example --bandwidth 80; without the flag the rule chooses it",
        )
    })
}
