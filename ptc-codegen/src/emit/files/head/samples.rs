//! The head of the files of a controller in samples.

use super::time::version;
use super::{
    Language, axes, coupled, end, filter, flight, followed, observed, plant, precision, time,
};
use crate::algebra::integer;
use crate::check::examine::Report;
use crate::code::Code;
use crate::diagnostic::counted;
use crate::linear::{Disturbance, Schedule};
use crate::model::Coupled;
use crate::parameter::Fixed;
use crate::parameter::Name;
use crate::request::{After, Exact, Guard, Lasting, Observer, Sampled, Spec, What};

/// Describes the goal of the plant and the law; empty for a stand-alone observer.
pub(in crate::emit) fn formulas(report: &Report) -> Vec<String> {
    let spec = &report.spec;
    match spec.sampled() {
        Some(sampled) if spec.what != What::Observer => purpose(spec, sampled),
        _ => Vec::new(),
    }
}

/// The plant, the law and the observer of a controller, as they are in the head of its files.
#[cfg(feature = "cli")]
pub(in crate::emit) fn law(spec: &Spec) -> Vec<String> {
    let Some(sampled) = spec.sampled() else { return Vec::new() };
    let mut lines = vec![plant_line(spec, sampled)];
    lines.extend(purpose(spec, sampled));
    lines.extend(sampled.observer.as_ref().map(estimates));
    lines
}

/// Lines of the head, without comment signs.
pub(in crate::emit) fn lines(
    report: &Report,
    sampled: &Sampled,
    code: &Code,
    language: Language,
) -> Vec<String> {
    let spec = &report.spec;
    let (name, n) = (spec.name(), spec.n);
    let alone = sampled.observer.as_ref().filter(|_| spec.what == What::Observer);
    let kind = match spec.what {
        What::Observer => "observer",
        What::Filter => "filter",
        What::Controller | What::Associated => "controller",
    };
    let order = match &spec.coupled {
        Some(coupled) => coupled.order_text(),
        None => format!("order n = {n}"),
    };
    let mut lines = vec![
        format!("Prescribed-time {kind} {name}: {order}, clock in samples."),
        String::new(),
        "DO NOT EDIT. Made by:".to_owned(),
        format!("  ptc-codegen emit --lang {} {}", language.name(), spec.command()),
    ];
    let mut rest = vec![version(spec), String::new()];
    rest.push(plant_line(spec, sampled));
    rest.extend(spec.units.as_ref().map(|_| {
        let input = if sampled.gain == integer(1) { "u" } else { "g u" };
        plant::units(spec, input)
    }));
    match alone {
        Some(observer) => rest.extend(observed::purpose(sampled, observer)),
        None => rest.extend(purpose(spec, sampled)),
    }
    rest.extend(axes::lines(spec));
    rest.push(String::new());
    rest.push("Parameters:".to_owned());
    for parameter in spec.parameters().into_iter().filter(|p| !axes::have_own(spec, *p)) {
        let unit = spec.unit(parameter);
        let (symbol, meaning) = (parameter.symbol(), spec.meaning(parameter));
        rest.push(match spec.fixed.get(&parameter) {
            Some(value) => format!("  {symbol} = {value} [{unit}], fixed: {meaning}"),
            None => format!("  {symbol} [{unit}]: {meaning}"),
        });
    }
    rest.extend(match alone {
        Some(observer) => observed::behaviour(spec, sampled, observer, language),
        None => behaviour(spec, sampled, language),
    });
    rest.push(precision::line(spec, precision::calls_library(code)));
    rest.extend(time::checks(report));
    lines.extend(rest.iter().flat_map(|line| time::wrap(line)));
    lines
}

/// The plant, and when the input acts on it.
fn plant_line(spec: &Spec, sampled: &Sampled) -> String {
    let late = match sampled.delay.to_string().as_str() {
        "0" => "u held from sample to sample".to_owned(),
        "1" => "u held from sample to sample, one sample late".to_owned(),
        d => format!("u held from sample to sample, {d} samples late"),
    };
    let late = match &sampled.linear {
        Some(plant) if !plant.measures_states() => format!("{late}, y = C x"),
        _ => late,
    };
    let plant = match (&spec.coupled, spec.model_in_samples()) {
        (Some(coupled), _) => {
            let inputs = Name::listed(&coupled.inputs);
            format!("the inputs {inputs}: {}", coupled.lines().join(", "))
        }
        (None, Some(model)) => format!("the input {}: {}", model.input, model.lines().join(", ")),
        (None, None) => plant::in_samples(spec, sampled),
    };
    let disturbance = match &sampled.disturbance {
        None => String::new(),
        Some(Disturbance::Constant) => ", d constant and unknown".to_owned(),
        Some(own @ (Disturbance::Ramp | Disturbance::Sine(_))) => format!(", d an unknown {own}"),
    };
    let given = if sampled.linear.is_some() { " of --A and --B above" } else { "" };
    format!("Plant: {plant}{disturbance}{given}; {late}.")
}

/// Describes the goal of the plant, the law and, with a reference, the tracking error.
fn purpose(spec: &Spec, sampled: &Sampled) -> Vec<String> {
    if let Some(keep) = &sampled.keep {
        return filter::purpose(spec, keep);
    }
    let plant = match (spec.sampled_exactly(), &spec.coupled) {
        (Some(exact), _) => sampled_exactly(spec, exact),
        (None, Some(coupled)) => of_outputs(spec, coupled),
        (None, None) => of_chain(spec, sampled).to_vec(),
    };
    [plant, followed::lines(spec, sampled)].concat()
}

/// The state of a law that predicts over its delay.
const PREDICTED: &str =
    " of the state x predicted for the time from which u acts, by x and the inputs under way";

fn of_chain(spec: &Spec, sampled: &Sampled) -> [String; 2] {
    let (n, order) = (spec.n, spec.loop_order());
    let [to_go, end] = end::of_loop(spec, order);
    if spec.model_in_samples().is_some() {
        let last = n - 1;
        return [
            format!(
                "Goal: the output and its derivatives up to order {last}, x, are 0 at sample N after the start, from any state, as long as u is not clipped and the plant is the model. f and g are known at the samples alone, which leaves an error of order h^({}-i) in x_i.",
                n + 2
            ),
            format!(
                "Law: with {to_go} and z = S x, w h^{n} = sum of row_j z_j h^(j-1)/((M-j+1)...(M-{last})), and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. {end}"
            ),
        ];
    }
    let goal = "Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any sample period, as long as u is not clipped and nothing else acts on the plant.";
    let goal = match sampled.disturbance.as_ref().is_some_and(Disturbance::moves) {
        true => {
            format!("{goal} What d does within a sample remains, of order h^({}-i) in x_i.", n + 2)
        }
        false => goal.to_owned(),
    };
    let of = if sampled.predicts() { PREDICTED } else { "" };
    if let Some(schedule) = spec.schedule() {
        return [goal, of_schedule(spec, schedule, of, &end)];
    }
    let law = match &sampled.linear {
        Some(_) => format!(
            "Law{of}: with {to_go} and z = S x, the differences of a flat output, u = sum of row_j z_j/((M-j+1)...(M-{})) less the drift of z; the rows are those of Theorem 1 for the mapping exp. {end}",
            order - 1
        ),
        None => format!(
            "Law{of}: with {to_go} and z = S x, u h^{order} = sum of row_j z_j h^(j-1)/((M-j+1)...(M-{})); the rows are those of Theorem 1 for the mapping exp. {end}",
            order - 1
        ),
    };
    [goal, law]
}

/// The law of a table of gains.
fn of_schedule(spec: &Spec, schedule: &Schedule, of: &str, end: &str) -> String {
    let weighted = |weight: u32| match weight {
        0 => "u^2".to_owned(),
        1 => "u^2/M".to_owned(),
        more => format!("u^2/(M ... (M+{}))", more - 1),
    };
    let ends = schedule.weights.end.map(|(samples, weight)| {
        format!(" From {samples} samples to go on it is that of {}.", weighted(weight))
    });
    let exact = schedule.pieces.get(1).map(|piece| piece.from);
    let exact = match exact {
        Some(exact) => format!(
            "exact below {exact} samples to go, and before it those of a grid of {} nodes, interpolated in a line",
            schedule.gains.len()
        ),
        None => "a row for each of them".to_owned(),
    };
    format!(
        "Law{of}: u = -K_M x with M samples to go, of all inputs that end at rest those with the least sum of {}.{} The gains are a table of {} bytes: {exact}. {end}",
        weighted(schedule.weights.law),
        ends.unwrap_or_default(),
        schedule.numbers() * spec.precision.bytes(),
    )
}

/// The same of a plant with several inputs.
fn of_outputs(spec: &Spec, coupled: &Coupled) -> Vec<String> {
    let mut lines = vec![
        "Goal: every output with its derivatives is 0 at sample N after the start, from any state, as long as no u is clipped and the plant is the model. The plant is known at the samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order n.".to_owned(),
        format!("Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp. v_i is law_i in step. {}", end::of_outputs(spec)),
    ];
    lines.extend(coupled::law(coupled));
    lines
}

/// The same of one that is linear.
fn sampled_exactly(spec: &Spec, exact: &Exact) -> Vec<String> {
    let mut lines = vec![
        "Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as no u is clipped and nothing else acts on the plant.".to_owned(),
        format!("Law of each output, of order n, in its chain xi as it is sampled, which is the output with its derivatives up to O(h), and which held inputs move exactly: with M - s samples to go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is law_i. {}", end::of_outputs(spec)),
    ];
    lines.extend(coupled::sampled(exact));
    lines
}

fn behaviour(spec: &Spec, sampled: &Sampled, language: Language) -> Vec<String> {
    let mut lines = vec![String::new()];
    if sampled.keep.is_some() {
        lines.extend(filter::behaviour());
        lines.push(time::limits_of_u(spec, "This goes before all bounds."));
        let given = ["x and u_nominal are finite", "states and u_nominal"];
        lines.push(guard(spec, language, given));
        return lines;
    }
    lines.push("k counts samples and may wrap; arm again within 2^32 - N samples.".to_owned());
    lines.push(
        match spec.after {
            After::Zero => "From sample N on u = 0 (status AFTER).",
            After::Hold | After::Extern => {
                "From sample N on the last gains are held (status HOLD)."
            }
        }
        .to_owned(),
    );
    if let Some(observer) = &sampled.observer {
        lines.push(estimates(observer));
    }
    lines.extend(sampled.observer.iter().flat_map(gate));
    lines.extend(flight::lines(spec, sampled));
    lines.push(time::limits_of_u(spec, "Clipping voids the deadline where it lasts."));
    let coasts = sampled.coasts();
    let given = match (spec.references(), coasts) {
        (0, false) => ["what is measured is finite", "measurements"],
        (_, false) => {
            ["what is measured and the reference are finite", "measurements and references"]
        }
        (0, true) => ["what is measured passes this gate", "measurements"],
        (_, true) => [
            "what is measured passes this gate, the reference is finite",
            "measurements and references",
        ],
    };
    lines.push(guard(spec, language, given));
    lines
}

/// From when on the estimates are exact, and what follows.
fn estimates(observer: &Observer) -> String {
    let then = then(observer);
    let Some(round) = &observer.round else {
        return format!("The estimates approach the state from the first sample on: {then}.");
    };
    let until = round.samples.map_or("N/2".to_owned(), |samples| samples.to_string());
    format!(
        "The estimates are exact from sample {until} after the start on where the measurement is; {then}."
    )
}

/// Describes which readings the observer accepts, and how it treats a sample with another one.
pub(super) fn gate(observer: &Observer) -> Option<String> {
    let gate = &observer.gate;
    let listed = |bounds: &[Fixed]| {
        let all: Vec<_> = bounds.iter().map(ToString::to_string).collect();
        all.join(", ")
    };
    let range = match listed(&gate.range) {
        none if none.is_empty() => String::new(),
        most => format!(" or beyond +-{most}"),
    };
    if !gate.coasts() {
        let refused = "counts as not finite";
        return (!range.is_empty())
            .then(|| format!("A reading beyond +-{} {refused}.", listed(&gate.range)));
    }
    let far = match listed(&gate.innovation) {
        none if none.is_empty() => String::new(),
        most => format!(" or further than {most} from its prediction"),
    };
    let samples = counted(&gate.coast, "sample");
    Some(format!(
        "Gate: a reading that is not finite{range}{far} is not believed, and the estimates are predicted alone (status GATED) for at most {samples} in a row. Then the call is refused (E_INPUT) until a reading is believed or arm starts the estimates anew. The first reading has no prediction."
    ))
}

/// Describes the phase after an observer has converged.
pub(super) fn then(observer: &Observer) -> &'static str {
    match (&observer.lasting, &observer.round) {
        (Lasting::Held, _) => {
            "with noise or sensor_step given, or observer_eps, the gains of the observer are then held below deadbeat"
        }
        (Lasting::Poles(_), _) => "from there on the observer has the poles after_observer",
        (Lasting::Stationary(_), Some(_)) => {
            "from there on the observer has the gains of the stationary Kalman filter for the noise and disturbance_walk"
        }
        (Lasting::Stationary(_), None) => {
            "the observer has the gains of the stationary Kalman filter for the noise and disturbance_walk"
        }
    }
}

/// Describes the checks of the arguments, in two grammars.
pub(super) fn guard(spec: &Spec, language: Language, [given, arguments]: [&str; 2]) -> String {
    let pointers = language == Language::C;
    match (spec.guard, pointers) {
        (Guard::Full, true) => format!(
            "Guard full: {given} and no pointer is NULL, or the call is refused (status E_INPUT)."
        ),
        (Guard::Full, false) => {
            format!("Guard full: {given}, or the call is refused (INPUT).")
        }
        (Guard::Result | Guard::None, true) => format!(
            "Guard none: finite {arguments} and valid pointers are the responsibility of the caller."
        ),
        (Guard::Result | Guard::None, false) => {
            format!("Guard none: finite {arguments} are the responsibility of the caller.")
        }
    }
}
