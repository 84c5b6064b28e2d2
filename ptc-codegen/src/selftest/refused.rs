//! Parameters and states that `init` must refuse: each condition of a domain violated alone.

use super::parameters::Chosen;
use crate::controller::Controller;
use crate::parameter::{Domain, Parameter};
use crate::program::number::settle;
use crate::request::Spec;

/// Sets of run-time parameters, each with one illegal value.
pub(super) fn parameters(controller: &Controller<'_>, chosen: &Chosen<'_>) -> Vec<Vec<f64>> {
    let spec = controller.spec();
    let usual = chosen.run_time(0.0625);
    let mut refused = Vec::new();
    for (at, &parameter) in chosen.at_run_time().iter().enumerate() {
        for value in illegal(spec, chosen, parameter) {
            let mut set = usual.clone();
            set[at] = value;
            // An eps that is too great for this tau alone is the business of eps.
            if parameter == Parameter::Tau
                && let Some(eps) = chosen.place(Parameter::Eps)
                && value > 0.0
            {
                set[eps] = settle(value / 16.0, spec.precision);
            }
            refused.push(set);
        }
    }
    refused
}

fn illegal(spec: &Spec, chosen: &Chosen<'_>, parameter: Parameter) -> Vec<f64> {
    let (nan, inf) = (f64::NAN, f64::INFINITY);
    let tau = chosen.value(Parameter::Tau, 0.0625);
    let (least, greatest) = spec.ends(parameter).unwrap_or((0.0, inf));
    let (below, above) =
        (settle(0.75 * least, spec.precision), settle(1.25 * greatest, spec.precision));
    let mut values = match spec.domain(parameter) {
        Domain::Finite => vec![nan, inf, -inf],
        Domain::Positive => vec![nan, inf, 0.0, -1.0, below, above],
        Domain::PositiveOrInfinite => vec![nan, 0.0, -1.0, -inf],
        Domain::BelowUMax => vec![nan, inf, chosen.value(Parameter::UMax, 0.0625)],
        Domain::AboveUMin => vec![nan, -inf, chosen.value(Parameter::UMin, 0.0625)],
        Domain::BelowTau => {
            vec![nan, inf, 0.0, -1.0, below, tau, settle(2.0 * tau, spec.precision)]
        }
        Domain::Within => {
            let (least, greatest) = chosen.bounds(parameter).unwrap_or((-inf, inf));
            let outside =
                |bound: f64, by: f64| settle(bound + by * (1.0 + bound.abs()), spec.precision);
            vec![nan, inf, -inf, outside(least, -0.5), outside(greatest, 0.5)]
        }
    };
    let limit = chosen.greatest(parameter).filter(|_| spec.domain(parameter) == Domain::Positive);
    values.extend(limit.map(|limit| settle(1.5 * limit, spec.precision)));
    values
}

/// Durations that `arm_for` must refuse with the parameters of the first session.
pub(super) fn durations(controller: &Controller<'_>, chosen: &Chosen<'_>) -> Vec<f64> {
    if !controller.program.in_flight {
        return Vec::new();
    }
    let mut durations = illegal(controller.spec(), chosen, Parameter::Tau);
    durations.push(chosen.value(Parameter::Eps, chosen.least_eps()));
    durations
}

/// States that cannot be latched, each with a start: each x_j not finite, alone.
pub(super) fn states(spec: &Spec, start: f64) -> Vec<(f64, Vec<f64>)> {
    if !spec.latches() {
        return Vec::new();
    }
    let one = |j: usize, value: f64| {
        let mut x0 = vec![0.5; spec.states()];
        x0[j] = value;
        (start, x0)
    };
    (0..spec.states()).flat_map(|j| [one(j, f64::NAN), one(j, f64::INFINITY)]).collect()
}
