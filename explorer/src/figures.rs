//! The numbers that a design is judged by: its worst case, its margins, the soonest deadline.

use num_traits::ToPrimitive;
use ptc_codegen::check::examine::Report;
use ptc_codegen::check::sampled::soonest_tau;
use ptc_codegen::parameter::{Fixed, Parameter};
use ptc_codegen::request::one_or_each;
use ptc_codegen::samples::Numbers;
use serde_json::{Value, json};

/// Figures of an examined design; null for those that are not known.
pub(crate) fn figures(report: &Report) -> Value {
    let spec = &report.spec;
    let number = |parameter| spec.fixed.get(&parameter).and_then(Fixed::number)?.to_f64();
    let worst = report.worst.as_ref().map(|worst| {
        let state = |(i, bound): (usize, &ptc_codegen::check::sampled::Bound)| {
            let most = one_or_each(&spec.promises.error, i);
            json!({ "name": spec.state_of_loop(i), "bound": bound.total(), "most": most })
        };
        json!({
            "states": worst.states.iter().enumerate().map(state).collect::<Vec<_>>(),
            "u": worst.way.as_ref().map(|way| way.u),
            "u_max": number(Parameter::UMax),
        })
    });
    let margins =
        report.stability().ok().map(|stable| json!({ "gain": stable.gain, "delay": stable.delay }));
    json!({ "worst": worst, "margins": margins, "soonest": soonest_tau(spec) })
}

/// The law in samples in numbers: z = S x, and the rows of Theorem 1; null for a clock in time.
pub(crate) fn law(report: &Report) -> Value {
    let Some(numbers) = Numbers::of(&report.spec) else { return Value::Null };
    let rows: Vec<_> = numbers.rows.iter().map(ToString::to_string).collect();
    json!({ "s": numbers.s, "rows": rows })
}
