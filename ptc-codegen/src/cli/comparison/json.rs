//! A comparison as JSON.

use serde_json::{Value, json};

use crate::compare::{Comparison, Row, Scenes};
use crate::verify::Campaign;

pub(super) fn json(campaign: &Campaign, scenes: &Scenes, comparison: &Comparison) -> String {
    let omitted = comparison.omitted.iter();
    let omitted = omitted.map(|own| json!({ "name": own.name, "why": own.why }));
    let found = json!({
        "name": campaign.spec.name(),
        "fingerprint": campaign.design.spec.fingerprint(),
        "corners": scenes.corners,
        "draws": scenes.all.len() - scenes.corners,
        "seed": campaign.seed,
        "behind": comparison.behind(&campaign.spec.state_names()),
        "controllers": comparison.rows.iter().map(row).collect::<Vec<_>>(),
        "omitted": omitted.collect::<Vec<_>>(),
        "soonest": comparison.soonest.as_ref().ok(),
        "scenario": campaign.text_of(&comparison.worst),
    });
    format!("{found}\n")
}

fn row(row: &Row) -> Value {
    let figures = row.figures.as_ref().ok();
    let margin = row.entrant.margin;
    json!({
        "name": row.entrant.name,
        "error": figures.map(|own| &own.error),
        "peak": figures.map(|own| own.peak),
        "energy": figures.map(|own| own.energy),
        "ripple": figures.map(|own| own.ripple),
        "settling": figures.map(|own| own.settling),
        "gain": margin.map(|own| own.gain),
        "delay": margin.map(|own| own.delay),
        "products": row.entrant.operations.products,
        "sums": row.entrant.operations.sums,
        "bandwidth": row.entrant.bandwidth,
        "failed": row.figures.as_ref().err().map(|failure| &failure.message),
    })
}
