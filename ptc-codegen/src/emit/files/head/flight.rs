//! The head's lines about a deadline that changes in flight, with either clock.

use num_traits::Zero;

use crate::parameter::Fixed;
use crate::request::{Flight, Late, Sampled, Spec};
use crate::syntax::constant;

/// Describes a duration that changes, with a clock in time.
pub(super) fn of_duration(spec: &Spec) -> Option<String> {
    spec.changes_duration().then(|| {
        "In flight: arm_for starts again at t0 for another tau, at any time, and computes what follows from tau. arm keeps the tau last used: at first that of the parameters.".to_owned()
    })
}

/// Describes what may change in flight, and the theorem from which deadlines are planned.
pub(super) fn lines(spec: &Spec, sampled: &Sampled) -> Vec<String> {
    let Some(flight) = &sampled.flight else { return Vec::new() };
    let exact = match spec.model.is_some() || spec.coupled.is_some() && sampled.exact.is_none() {
        true => "",
        false => "; rest is exact from any state, so all else stays as it is",
    };
    let mut lines = vec![format!("In flight: arm_for sets another deadline at any tick{exact}.")];
    let Some(horizons) = sampled.horizons(spec) else { return lines };
    let kept = states(spec, flight);
    lines.push(match horizons.first().and_then(|own| own.table.as_ref()) {
        Some(table) => format!(
            "Plan: with M samples to go a table holds u{kept} at some samples of the way to rest, as rows times x; those at all others are combinations of these whose factors add up to at most 1 in size, which was examined for each M up to {}. If the rows are within the limits, the smaller one of u_min and u_max, u{kept} stay there at every sample to rest, where plant and state are as they are known. A new plan leaves {:.1} % of the limits, by which rows between the samples may grow on the way.",
            table.longest,
            100.0 * (1.0 - table.growth.recip())
        ),
        None => format!(
            "Plan: on the way to rest u and the states are sums of falling powers of the samples to go, so their Bernstein coefficients, linear in z, bound them. If these are within the limits, u{kept} stay there at every sample to rest, where plant and state are as they are known."
        ),
    });
    if spec.axes.is_some() {
        lines.push("Axes: all come to rest at the same sample, and each deadline is tested for every one of them.".to_owned());
    }
    lines.extend(match flight.late {
        Late::Clip => None,
        Late::Refuse => Some("late refuse: arm_for refuses a deadline without such a plan (status E_SOON).".to_owned()),
        Late::Extend => Some(format!(
            "late extend: a step without such a plan raises N to the soonest that has one (status LATE; deadline gives its tick){}. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N stays, and u is clipped; states may leave their bounds then.",
            if flight.soonest { ", and others lower N, by at most a sixteenth of the samples to go" } else { "" }
        )),
    });
    if !flight.reserve.is_zero() {
        lines.push(format!(
            "reserve: a new deadline leaves {} of each limit free.",
            constant::text(&flight.reserve)
        ));
    }
    lines
}

/// The bounds of the states, behind `u`.
fn states(spec: &Spec, flight: &Flight) -> String {
    if spec.axes.as_ref().is_some_and(|axes| !axes.state_max.is_empty()) {
        return " and the states".to_owned();
    }
    let bound = |(i, own): (usize, &Fixed)| own.number().map(|_| format!("|x{}| <= {own}", i + 1));
    let all: Vec<_> = flight.state_max.iter().enumerate().filter_map(bound).collect();
    match all.as_slice() {
        [] => String::new(),
        all => format!(" and {}", all.join(" and ")),
    }
}
