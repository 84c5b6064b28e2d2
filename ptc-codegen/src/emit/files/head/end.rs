//! The end of a law in samples, in words.

use crate::algebra::integer;
use crate::diagnostic::counted;
use crate::request::{Sampled, Spec};
use crate::samples::{Ending, Terminal, held_samples};
use crate::syntax::constant;

/// Returns the samples to go, by the M of the formula, and a sentence about the last ones, of one loop.
pub(super) fn of_loop(spec: &Spec, order: usize) -> [String; 2] {
    let Some(ending) = Ending::of(spec) else { return [String::new(), String::new()] };
    let to_go = match i64::from(ending.shift) - i64::from(ending.spare) {
        0 => "M samples to go".to_owned(),
        less @ 1.. => format!("M - {less} samples to go"),
        more => format!("M + {} samples to go", -more),
    };
    let held = held_samples(spec);
    let end = match &ending.terminal {
        Terminal::LeastEnergy(end)
            if held.as_ref().is_none_or(|held| *held <= integer(end.samples.into())) =>
        {
            let shift = end.law.shift(order);
            let exponents: Vec<_> = end.law.exponents(order).map(|own| own.to_string()).collect();
            format!(
                "From {} samples to go on these are M - {shift} and the exponents {}, those of least energy. ",
                end.samples,
                exponents.join(", ")
            )
        }
        Terminal::Deadbeat(from) => {
            let from = from
                .as_ref()
                .map(|from| format!(", with {from} samples to go"))
                .unwrap_or_default();
            return [to_go, format!("Close to the end{from} deadbeat takes over.")];
        }
        _ => String::new(),
    };
    let predicts = spec.sampled().is_some_and(Sampled::predicts);
    // The predicted state has so many samples less to go.
    let late = if predicts { ending.spare } else { 0 };
    let least = counted(&(order + late as usize), "sample");
    let last = match held {
        None => format!("The gains of time-to-go eps stay, or those of {least} to go."),
        Some(held) if ending.is_held(order, &held) => {
            let held = held + integer(late.into());
            format!("The gains of {} samples to go stay.", constant::text(&held))
        }
        _ => format!("The gains of {least} to go stay: they are deadbeat."),
    };
    let early = match ending.spare - late {
        0 => String::new(),
        spare => format!(
            " Rest is planned {} early, and the last gains bring down what f and g did between samples.",
            counted(&spare, "sample")
        ),
    };
    [to_go, format!("{end}{last}{early}")]
}

/// Returns a sentence about the shifts and the ends of several outputs.
pub(super) fn of_outputs(spec: &Spec) -> String {
    let designs = spec.designs();
    let endings: Vec<_> = designs.iter().filter_map(Ending::of).collect();
    let less = |ending: &Ending| i64::from(ending.shift) - i64::from(ending.spare);
    let shifts: Vec<_> = endings.iter().map(|ending| less(ending).to_string()).collect();
    let mut all = format!("s = {}.", shifts.join(", "));
    for (design, output) in designs.iter().zip(1..) {
        let [_, end] = of_loop(design, design.loop_order());
        all.push_str(&format!(" Output {output}: {end}"));
    }
    all
}
