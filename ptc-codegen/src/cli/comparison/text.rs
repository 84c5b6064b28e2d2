//! A comparison as text.

use std::fmt::Write;

use super::args::Compare;
use crate::cli::report::quoted;
use crate::compare::{Comparison, Scenes};
use crate::simulate::Loop;
use crate::verify::Campaign;

pub(super) fn text(
    request: &Compare,
    campaign: &Campaign,
    scenes: &Scenes,
    comparison: &Comparison,
) -> String {
    let states = campaign.spec.state_names();
    let mut out = String::new();
    let _ = writeln!(out, "{}: worst of {}", campaign.spec.name(), counted(campaign, scenes));
    let behind = comparison.behind(&states);
    match behind.is_empty() {
        true => out.push_str("\nThe design is behind in no column.\n"),
        false => out.push_str("\nThe design is behind in:\n"),
    }
    behind.iter().for_each(|line| _ = writeln!(out, "- {line}"));
    let _ = write!(out, "\n{}", comparison.table(&states));
    let rule = match request.bandwidth {
        Some(_) => "the others have the bandwidth of --bandwidth".to_owned(),
        None => format!("the others: {}", Comparison::rule()),
    };
    let _ = writeln!(out, "\n- {rule}");
    comparison.notes().iter().for_each(|note| _ = writeln!(out, "- {note}"));
    let _ = writeln!(out, "- {}", again(request, campaign, comparison));
    out
}

/// The number of scenarios.
fn counted(campaign: &Campaign, scenes: &Scenes) -> String {
    let draws = scenes.all.len() - scenes.corners;
    let corners = match scenes.corners {
        1 => "1 start".to_owned(),
        count => format!("{count} corners"),
    };
    match draws {
        0 => corners,
        _ => format!("{corners} and {draws} draws (seed {})", campaign.seed),
    }
}

/// Returns the command that runs the loop of the design in its worst scenario.
fn again(request: &Compare, campaign: &Campaign, comparison: &Comparison) -> String {
    let scenario = campaign.text_of(&comparison.worst);
    let constants = comparison.worst.point.get(1 + campaign.x0.len()..).unwrap_or_default();
    let known: Vec<_> = campaign.intervals.iter().map(|(symbol, _)| symbol.spelling()).collect();
    let is_drawn = constants.len() != known.len()
        || !campaign.disturbances.is_empty()
        || campaign.around.as_ref().is_some_and(Loop::is_drawn);
    // Only a scenario of the design's own box can be verified again.
    let replays = !campaign.objectives.is_empty() && request.x0.is_none();
    let command = if replays { "verify" } else { "simulate" };
    let mut words = vec![format!("ptc-codegen {command}")];
    words.extend(request.design.design.iter().map(|path| quoted(&path.display().to_string())));
    words.extend(request.spec.0.flags().map(|(name, text)| format!("{name}={}", quoted(text))));
    let given = request.plant.iter().filter(|text| {
        let name = text.split('=').next().unwrap_or_default();
        replays || known.iter().all(|own| own != name.trim())
    });
    words.extend(given.map(|text| format!("--plant {}", quoted(text))));
    if replays {
        return format!("its worst loop: {} --scenario {}", words.join(" "), quoted(&scenario));
    }
    if is_drawn {
        return format!("its worst scenario: {scenario}");
    }
    let values = known.iter().zip(constants);
    words.extend(values.map(|(name, value)| format!("--plant {name}={value}")));
    let x0 = &comparison.worst.point[1..=campaign.x0.len()];
    let x0: Vec<_> = x0.iter().map(ToString::to_string).collect();
    format!("its worst loop: {} --x0={}", words.join(" "), x0.join(","))
}
