//! Distribution of the draws, in words.

use super::super::{Campaign, Signal};

/// Whose state the initial one is, where there are two.
const FOLLOWS: &str = "of the plant, and not of its tracking error e";

/// Describes the distribution of the draws.
pub(super) fn distribution(campaign: &Campaign) -> String {
    let drawn = campaign.uncertain().filter(|(_, (low, high))| low < high);
    let names: Vec<_> = drawn.map(|(name, _)| name).collect();
    let mut parts = Vec::new();
    if !names.is_empty() {
        let boxes = if names.len() == 1 { "its interval" } else { "their intervals" };
        parts.push(format!("{} uniform in {boxes}", listed(&names)));
    }
    for (symbol, _, signals) in &campaign.disturbances {
        let words: Vec<_> =
            signals.iter().map(|signal: &Signal| signal.name().to_owned()).collect();
        let likely = match words.len() {
            1 => words[0].clone(),
            _ => format!("one of {}, each as likely", listed(&words)),
        };
        parts.push(format!("{} {likely}", symbol.spelling()));
    }
    if let Some(around) = campaign.around.as_ref().filter(|around| around.is_drawn()) {
        let sensors =
            [(&around.noise, "noise even within its bounds"), (&around.noise_rms, "normal noise")];
        let given = sensors.into_iter().filter(|(sizes, _)| sizes.iter().any(|size| *size > 0.0));
        parts.extend(given.map(|(_, told)| format!("{told} at each sample")));
        if around.jitter > 0.0 {
            parts.push("samples early or late, evenly within jitter".to_owned());
        }
    }
    if parts.is_empty() {
        parts.push("nothing is drawn".to_owned());
    }
    if campaign.spec.reference.is_some() {
        parts.push(format!("{} at t0 {FOLLOWS}", listed(&campaign.spec.state_names())));
    }
    parts.join("; ")
}

fn listed(words: &[String]) -> String {
    match words {
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
        [] => String::new(),
    }
}
