//! Behaviour of a controller at its limits: after the deadline, at the bound of u, with wrong inputs.

use super::super::precision::{self, is_library};
use super::super::{Controller, Language, flight};
use crate::program::Op;
use crate::program::range::Range;
use crate::request::{After, Feedback, Guard, Spec};

pub(super) fn behaviour(controller: &Controller<'_>, language: Language) -> Vec<String> {
    let spec = controller.spec();
    let held = match spec.feedback {
        Feedback::Linear | Feedback::LeastEnergy(_) => "the gains of T = eps are held",
        Feedback::Expression(_) | Feedback::Extern => "T is held at eps in the law",
    };
    let mut lines = vec![String::new()];
    lines.push(match spec.after {
        After::Hold => {
            format!("From t0 + tau - eps on, and after the deadline, {held} (status HOLD).")
        }
        After::Zero => format!(
            "From t0 + tau - eps on, {held} (status HOLD). From t0 + tau on, u = 0 (status AFTER)."
        ),
        After::Extern => format!(
            "From t0 + tau - eps on, {held} (status HOLD). From t0 + tau on, u is the result of the user-defined function after (status AFTER)."
        ),
    });
    lines.extend(flight::of_duration(spec));
    lines.push(limits_of_u(spec, "Prolonged saturation voids the deadline."));
    let [given, any] = match spec.references() {
        0 => ["t and x", "t or x"],
        _ => ["t, x and r", "t, x or r"],
    };
    let pointers = language == Language::C;
    lines.push(match (spec.guard, pointers) {
        (Guard::Full, true) => format!("Guard full: {given} are finite, t >= t0 and no pointer is NULL, or the call is refused (status E_INPUT)."),
        (Guard::Full, false) => {
            format!("Guard full: {given} are finite and t >= t0, or the call is refused (INPUT).")
        }
        (Guard::Result, true) => format!("Guard result: {any} that is not finite is refused by one test on u (status E_RANGE). t >= t0 and valid pointers are the responsibility of the caller."),
        (Guard::Result, false) => format!("Guard result: {any} that is not finite is refused by one test on u (RANGE). t >= t0 is the responsibility of the caller."),
        (Guard::None, true) => format!("Guard none: finite {given}, t >= t0 and valid pointers are the responsibility of the caller."),
        (Guard::None, false) => {
            format!("Guard none: finite {given} and t >= t0 are the responsibility of the caller.")
        }
    });
    let library = controller.program.values.iter().any(|value| match value.op {
        Op::Call(function, _) => is_library(function),
        Op::Pow(..) => true,
        _ => false,
    });
    lines.push(precision::line(spec, library));
    lines
}

/// Describes where u is clipped, and the effect on the deadline.
pub(in crate::emit::files::head) fn limits_of_u(spec: &Spec, deadline: &str) -> String {
    if spec.is_unlimited() {
        return "u is not clipped.".to_owned();
    }
    if !spec.u_min {
        return format!("|u| <= u_max: u is clipped to it (status SATURATED). {deadline}");
    }
    let inputs = spec.input_names().len();
    let rests = (0..inputs).all(|index| Range::fixed(spec, index).contains(0.0));
    let outside = match rests {
        true => "",
        false => " Calls that fail give u = 0, which is outside of these limits.",
    };
    format!(
        "u_min <= u <= u_max: u is clipped to these limits (status SATURATED). {deadline}{outside}"
    )
}
