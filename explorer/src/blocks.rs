//! The loop of a design as blocks: from the law to the plant, and from its sensors back.

use num_traits::ToPrimitive;
use ptc_codegen::parameter::{Fixed, Parameter};
use ptc_codegen::request::{Reference, Spec, What};
use serde_json::{Value, json};

/// The blocks of a loop, and what acts on them; null for an observer or a filter alone.
pub(crate) fn of_loop(spec: &Spec) -> Value {
    if !matches!(spec.what, What::Controller) {
        return Value::Null;
    }
    let sampled = spec.promises.sample_time.is_some();
    let mut forward = vec![block("Law", &spec.order_text())];
    forward.extend(limit(spec));
    forward.extend(spec.promises.delay.as_ref().map(|delay| {
        block(
            "Delay",
            &format!("{delay} sample{}", if delay.to_string() == "1" { "" } else { "s" }),
        )
    }));
    if sampled {
        let period = spec.promises.sample_time.as_ref().and_then(number);
        forward
            .push(block("Hold", &period.map_or(String::new(), |period| format!("h = {period} s"))));
    }
    forward.push(block("Plant", &spec.state_names().join(", ")));
    let mut into = Vec::new();
    match &spec.reference {
        Some(Reference::Input) => into.push(json!({ "block": "Law", "text": "r of each call" })),
        Some(Reference::Known(_)) => into.push(json!({ "block": "Law", "text": "r(t)" })),
        None => {}
    }
    let own = spec.sampled();
    if own.is_some_and(|own| own.disturbance.is_some()) {
        into.push(json!({ "block": "Plant", "text": "unknown force d" }));
    }
    let mut back = vec![block("Sensors", &sensors(spec))];
    if own.is_some_and(|own| own.observes()) {
        let estimates = if own.is_some_and(|own| own.disturbance.is_some()) {
            "states and d"
        } else {
            "states"
        };
        back.push(block("Observer", estimates));
    }
    json!({ "forward": forward, "back": back, "into": into })
}

fn block(name: &str, text: &str) -> Value {
    json!({ "name": name, "text": text })
}

fn number(value: &Fixed) -> Option<f64> {
    value.number()?.to_f64()
}

/// The limit of u, where it is known.
fn limit(spec: &Spec) -> Option<Value> {
    let fixed = |parameter| spec.fixed.get(&parameter).and_then(number);
    let most = fixed(Parameter::UMax)?;
    Some(match fixed(Parameter::UMin) {
        Some(least) => block("Limit", &format!("{least} to {most}")),
        None => block("Limit", &format!("\u{b1}{most}")),
    })
}

/// Measured signals, with their errors.
fn sensors(spec: &Spec) -> String {
    let promises = &spec.promises;
    let disturbed = [
        (!promises.noise.is_empty() || !promises.noise_rms.is_empty(), "noise"),
        (!promises.sensor_step.is_empty(), "steps"),
    ];
    let disturbed: Vec<_> = disturbed.iter().filter(|(is, _)| *is).map(|(_, name)| *name).collect();
    let (measured, states) = (spec.measurements(), spec.states());
    match (measured == states, disturbed.is_empty()) {
        (true, true) => String::new(),
        (false, true) => format!("{measured} measured"),
        (true, false) => disturbed.join(", "),
        (false, false) => format!("{measured} with {}", disturbed.join(", ")),
    }
}
