//! The variables of an FMU: inputs, outputs, tunable parameters and constants.

use super::super::example::Example;
use super::super::head::have_own;
use super::signals::{Signal, Signals};
use super::units::{exponent, unit_name};
use crate::parameter::{Domain, Fixed, Parameter, Precision};
use crate::program::number;
use crate::request::{Sampled, Spec};

/// A variable as both versions of modelDescription.xml describe it.
pub(super) struct Variable {
    pub(super) name: String,
    /// Value reference, and in FMI 2.0 the index; 0 is time in FMI 3.0.
    pub(super) reference: usize,
    pub(super) causality: &'static str,
    pub(super) variability: &'static str,
    pub(super) initial: Option<&'static str>,
    pub(super) description: String,
    /// Element in FMI 2.0.
    pub(super) kind2: &'static str,
    /// Element in FMI 3.0.
    pub(super) kind3: &'static str,
    pub(super) attributes: Vec<(&'static str, String)>,
    /// Value references of the inputs that it depends on.
    pub(super) dependencies: String,
    /// The parameter that it is.
    pub(super) parameter: Option<Parameter>,
    /// Member of the instance that stores it, if it can be set.
    pub(super) place: Option<String>,
    /// Power of s of its unit; none without a unit that is known.
    pub(super) exponent: Option<i64>,
}

/// The outputs.
pub(super) fn outputs(variables: &[Variable]) -> Vec<&Variable> {
    variables.iter().filter(|v| v.causality == "output").collect()
}

/// Returns the estimates of an observer, by name, in the order in which the controller returns them.
pub(super) fn estimates(spec: &Spec) -> Vec<(String, String)> {
    let Some(sampled) = spec.sampled().filter(|sampled| sampled.observes()) else {
        return Vec::new();
    };
    let states = (sampled.first_estimated()..=spec.n).map(|j| format!("xhat{j}"));
    let states = states.map(|name| {
        let about = format!("Estimate of the state x{}", &name["xhat".len()..]);
        (name, about)
    });
    let disturbance = sampled
        .disturbance
        .as_ref()
        .map(|own| ("d".to_owned(), format!("Estimate of the {} that is added to u", own.about())));
    states.chain(disturbance).collect()
}

impl Variable {
    /// A number that the importer sets, of a kind of FMI 3.0.
    fn blank(kind3: &'static str) -> Self {
        Self {
            name: String::new(),
            reference: 0,
            causality: "input",
            variability: "continuous",
            initial: None,
            description: String::new(),
            kind2: "Real",
            kind3,
            attributes: Vec::new(),
            dependencies: String::new(),
            parameter: None,
            place: None,
            exponent: None,
        }
    }

    fn input(signal: &Signal, kind3: &'static str) -> Self {
        Self {
            name: signal.name.clone(),
            description: signal.about.clone(),
            attributes: vec![("start", "0".to_owned())],
            place: Some(signal.place.clone()),
            ..Self::blank(kind3)
        }
    }

    /// An input that is 0 or 1.
    fn switch(signal: &Signal) -> Self {
        Self {
            variability: "discrete",
            kind2: "Integer",
            attributes: vec![
                ("min", "0".to_owned()),
                ("max", "1".to_owned()),
                ("start", "0".to_owned()),
            ],
            ..Self::input(signal, "Int32")
        }
    }

    /// An output that depends on all inputs, or on those of its axis.
    fn output(signal: &Signal, signals: &Signals, kind3: &'static str) -> Self {
        let depends = |input: &Signal| signal.axis.is_none() || input.axis == signal.axis;
        let inputs = (1..).zip(signals.inputs()).filter(|(_, input)| depends(input));
        let inputs: Vec<_> =
            inputs.map(|(reference, _): (usize, _)| reference.to_string()).collect();
        Self {
            name: signal.name.clone(),
            causality: "output",
            description: signal.about.clone(),
            dependencies: inputs.join(" "),
            ..Self::blank(kind3)
        }
    }

    /// An output that is a status.
    fn status(signal: &Signal, signals: &Signals) -> Self {
        Self { variability: "discrete", kind2: "Integer", ..Self::output(signal, signals, "Int32") }
    }
}

/// All variables but time, by their value references from 1.
pub(super) fn variables(spec: &Spec, signals: &Signals, example: &Example) -> Vec<Variable> {
    let kind3 = if spec.precision == Precision::F32 { "Float32" } else { "Float64" };
    let switches = signals.switches();
    let numbers = signals.inputs().take(signals.given() - switches.len());
    let mut all: Vec<_> = numbers.map(|input| Variable::input(input, kind3)).collect();
    all.extend(switches.iter().map(Variable::switch));
    all.extend(outputs_of_calls(spec, signals, kind3));
    all.extend(parameters(spec, example, kind3));
    for (index, variable) in all.iter_mut().enumerate() {
        variable.reference = index + 1;
        if let Some(exponent) = variable.exponent {
            variable.attributes.push(("unit", unit_name(exponent)));
        }
    }
    all
}

/// Every u, time-to-go, the statuses and the estimates.
fn outputs_of_calls(spec: &Spec, signals: &Signals, kind3: &'static str) -> Vec<Variable> {
    let of_call = |name: &str, about: &str| Signal {
        name: name.to_owned(),
        place: String::new(),
        about: about.to_owned(),
        axis: None,
    };
    let controls = signals.controls.iter();
    let mut all: Vec<_> = controls.map(|u| Variable::output(u, signals, kind3)).collect();
    all.push(Variable {
        name: "time_to_go".to_owned(),
        causality: "output",
        dependencies: match signals.steering {
            Some(_) => Variable::output(&of_call("", ""), signals, kind3).dependencies,
            None => String::new(),
        },
        description: "Time left until the deadline t0 + tau [s], 0 after it".to_owned(),
        exponent: Some(1),
        ..Variable::blank(kind3)
    });
    let status = of_call("status", &status(spec, signals));
    let statuses = std::iter::once(&status).chain(&signals.statuses);
    all.extend(statuses.map(|status| Variable::status(status, signals)));
    let estimates = estimates(spec).into_iter();
    all.extend(
        estimates.map(|(name, about)| Variable::output(&of_call(&name, &about), signals, kind3)),
    );
    if let Some(steering) = &signals.steering {
        let planned =
            of_call("deadline_planned", "Time from the start to rest, as planned now [s]");
        let soonest = of_call("soonest", SOONEST);
        let outputs = [Some(planned), steering.soonest.map(|_| soonest)].into_iter().flatten();
        all.extend(
            outputs.map(|own| Variable {
                exponent: Some(1),
                ..Variable::output(&own, signals, kind3)
            }),
        );
    }
    all
}

const SOONEST: &str = "Soonest deadline, as a time from the start, that keeps the limits for sure: `deadline` may be set to it at the next sample; -1 without one";

/// The numbers of a status that this controller gives.
fn status(spec: &Spec, signals: &Signals) -> String {
    let gated = spec.sampled().is_some_and(Sampled::coasts);
    let plans = signals.steering.as_ref().is_some_and(|own| !own.in_time);
    let known = "0 tracking, 1 gains held at time-to-go eps, 2 u clipped to its limits, 3 after the deadline";
    let all = [
        (true, known),
        (gated, "4 a reading not believed, u by prediction"),
        (
            plans,
            "5 the deadline was put off, 6 no deadline was found that keeps the limits, -4 the deadline asked for is too soon and was not taken",
        ),
    ];
    let given: Vec<_> =
        all.into_iter().filter(|(given, _)| *given).map(|(_, words)| words).collect();
    given.join(", ")
}

/// The tunable parameters, and those that the design fixes.
fn parameters(spec: &Spec, example: &Example, kind3: &'static str) -> Vec<Variable> {
    let order = spec.loop_order();
    let (free, fixed): (Vec<_>, Vec<_>) =
        spec.parameters().into_iter().partition(|p| !spec.fixed.contains_key(p));
    let of_parameter = |parameter: Parameter, range: &str| {
        let (meaning, unit) = (spec.meaning(parameter), spec.unit(parameter));
        let count = parameter == Parameter::Samples;
        let value = example.value(parameter);
        let shown = if count { value.to_string() } else { example.literal(parameter) };
        Variable {
            name: parameter.spelling(),
            description: format!("{meaning} [{unit}], {range}"),
            kind2: if count { "Integer" } else { "Real" },
            attributes: vec![("start", shown)],
            parameter: Some(parameter),
            exponent: exponent(parameter, order).filter(|_| !count),
            ..Variable::blank(if count { "Int32" } else { kind3 })
        }
    };
    let tunable = free.into_iter().map(|parameter| {
        let mut variable = of_parameter(parameter, &spec.legal(parameter));
        variable.attributes.extend(ends(spec, parameter));
        let place = match parameter.index() {
            Some(index) => format!("params.{}[{index}]", parameter.key()),
            None => format!("params.{}", parameter.key()),
        };
        Variable { causality: "parameter", variability: "tunable", place: Some(place), ..variable }
    });
    // Infinity, which fixes that u is not bounded, is no value that every importer reads; what each
    // axis has of its own is not one value.
    let is_one = |p: &Parameter| example.value(*p).is_finite() && !have_own(spec, *p);
    let constants = fixed.into_iter().filter(is_one).map(|parameter| Variable {
        causality: "local",
        variability: "constant",
        initial: Some("exact"),
        ..of_parameter(parameter, "fixed")
    });
    tunable.chain(constants).collect()
}

/// The least and the greatest value of a parameter, as attributes.
fn ends(spec: &Spec, parameter: Parameter) -> Vec<(&'static str, String)> {
    let round = |bound: &Fixed| {
        let rounded = bound.number().map(|exact| number::round(exact, spec.precision));
        rounded.map(|value| number::literal(value, spec.precision))
    };
    if let Some((least, greatest)) = spec.bounds.get(&parameter) {
        let (least, greatest) = (round(least), round(greatest));
        let least = least.map(|least| ("min", least));
        return least.into_iter().chain(greatest.map(|greatest| ("max", greatest))).collect();
    }
    if let Some((least, greatest)) = spec.ends(parameter) {
        let end = |value| number::literal(value, spec.precision);
        return vec![("min", end(least)), ("max", end(greatest))];
    }
    match spec.domain(parameter) {
        Domain::Finite | Domain::BelowUMax | Domain::AboveUMin => Vec::new(),
        _ => vec![("min", "0".to_owned())],
    }
}
