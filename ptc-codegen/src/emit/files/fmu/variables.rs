//! The variables of an FMU: inputs, outputs, tunable parameters and constants.

use super::super::example::Example;
use crate::parameter::{Domain, Fixed, Parameter, Precision};
use crate::program::number;
use crate::request::{Spec, chain_unit};

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
    exponent: Option<i64>,
}

/// The inputs: how many, and the letter of their names.
pub(super) struct Inputs {
    pub(super) count: usize,
    pub(super) letter: char,
}

impl Inputs {
    pub(super) fn of(spec: &Spec) -> Self {
        match spec.sampled() {
            Some(sampled) if !sampled.measures_states() => {
                Self { count: sampled.measured, letter: 'y' }
            }
            _ => Self { count: spec.states(), letter: 'x' },
        }
    }
}

/// A unit that is a power of s.
pub(super) struct Unit {
    pub(super) name: String,
    pub(super) exponent: i64,
}

impl Unit {
    /// The units of all variables, each once.
    pub(super) fn all(variables: &[Variable]) -> Vec<Self> {
        let exponents = variables.iter().filter_map(|v| v.exponent);
        let units = crate::collect::map(exponents.map(|e| (-e, unit_name(e))));
        units.into_iter().map(|(e, name)| Self { name, exponent: -e }).collect()
    }
}

fn unit_name(exponent: i64) -> String {
    match exponent {
        1 => "s".to_owned(),
        -1 => "1/s".to_owned(),
        0 => "1".to_owned(),
        exponent => format!("s^{exponent}"),
    }
}

/// The power of s of a parameter's unit.
fn exponent(parameter: Parameter, n: usize) -> Option<i64> {
    let order = |i: usize| i64::try_from(i).ok();
    match parameter {
        Parameter::Tau | Parameter::StartTime | Parameter::Eps | Parameter::SampleTime => Some(1),
        Parameter::A | Parameter::Rate(_) => Some(-1),
        Parameter::M | Parameter::Start | Parameter::Samples | Parameter::Deadbeat => Some(0),
        Parameter::Gain(i) => Some(order(i)? - 1 - order(n)?),
        Parameter::UMax | Parameter::UMin | Parameter::Named(_) => None,
    }
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
    let disturbance = ("d".to_owned(), "Estimate of the constant that is added to u".to_owned());
    states.chain(sampled.disturbance.then_some(disturbance)).collect()
}

/// All variables but time, by their value references from 1.
pub(super) fn variables(spec: &Spec, example: &Example) -> Vec<Variable> {
    let kind3 = if spec.precision == Precision::F32 { "Float32" } else { "Float64" };
    let (order, chain) = (spec.loop_order(), spec.sampled().is_none_or(|s| s.linear.is_none()));
    let Inputs { count, letter } = Inputs::of(spec);
    let blank = || Variable {
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
    };
    let mut all = Vec::new();
    let unit = |place| chain_unit(spec.units.as_deref().unwrap_or("unit"), place);
    for j in 1..=count {
        let unit = if chain { format!(" [{}]", unit(j)) } else { String::new() };
        let what = if letter == 'x' { "State" } else { "Measurement" };
        all.push(Variable {
            name: format!("{letter}{j}"),
            description: match &spec.model {
                Some(model) => format!("State {} of the plant", model.states[j - 1]),
                None => format!("{what} {letter}{j} of the plant{unit}"),
            },
            attributes: vec![("start", "0".to_owned())],
            place: Some(format!("x[{}]", j - 1)),
            ..blank()
        });
    }
    for order in 0..spec.references() {
        let unit = match spec.model {
            Some(_) => String::new(),
            None => format!(" [{}]", unit(order + 1)),
        };
        all.push(Variable {
            name: format!("r{order}"),
            description: match order {
                0 => format!("Reference that the output follows{unit}"),
                order if order == spec.n && spec.sampled().is_some() => {
                    format!("Its derivative of order {order} over the sample in which u acts{unit}")
                }
                order => format!("Its derivative of order {order}{unit}"),
            },
            attributes: vec![("start", "0".to_owned())],
            place: Some(format!("r[{order}]")),
            ..blank()
        });
    }
    let every: Vec<_> = (1..=all.len()).map(|j| j.to_string()).collect();
    all.push(Variable {
        name: "u".to_owned(),
        causality: "output",
        description: match spec.input_unit() {
            Some(unit) => format!("Input of the plant [{unit}]"),
            None => "Input of the plant".to_owned(),
        },
        dependencies: every.join(" "),
        ..blank()
    });
    all.push(Variable {
        name: "time_to_go".to_owned(),
        causality: "output",
        description: "Time left until the deadline t0 + tau [s], 0 after it".to_owned(),
        exponent: Some(1),
        ..blank()
    });
    all.push(Variable {
        name: "status".to_owned(),
        causality: "output",
        variability: "discrete",
        description:
            "0 tracking, 1 gains held at time-to-go eps, 2 u clipped to its limits, 3 after the deadline"
                .to_owned(),
        kind2: "Integer",
        kind3: "Int32",
        dependencies: every.join(" "),
        ..blank()
    });
    for (name, description) in estimates(spec) {
        all.push(Variable {
            name,
            causality: "output",
            description,
            dependencies: every.join(" "),
            ..blank()
        });
    }
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
            kind3: if count { "Int32" } else { kind3 },
            attributes: vec![("start", shown)],
            parameter: Some(parameter),
            exponent: exponent(parameter, order).filter(|_| !count),
            ..blank()
        }
    };
    for parameter in free {
        let mut variable = of_parameter(parameter, &spec.legal(parameter));
        let attributes = &mut variable.attributes;
        let round = |bound: &Fixed| {
            bound
                .number()
                .map(|exact| number::literal(number::round(exact, spec.precision), spec.precision))
        };
        if let Some((least, greatest)) = spec.bounds.get(&parameter) {
            attributes.extend(round(least).map(|least| ("min", least)));
            attributes.extend(round(greatest).map(|greatest| ("max", greatest)));
        } else if let Some((least, greatest)) = spec.ends(parameter) {
            let end = |value| number::literal(value, spec.precision);
            attributes.extend([("min", end(least)), ("max", end(greatest))]);
        } else if !matches!(
            spec.domain(parameter),
            Domain::Finite | Domain::BelowUMax | Domain::AboveUMin
        ) {
            attributes.push(("min", "0".to_owned()));
        }
        let place = match parameter.index() {
            Some(index) => format!("params.{}[{index}]", parameter.key()),
            None => format!("params.{}", parameter.key()),
        };
        all.push(Variable {
            causality: "parameter",
            variability: "tunable",
            place: Some(place),
            ..variable
        });
    }
    // Infinity, which fixes that u is not bounded, is no value that every importer reads.
    for parameter in fixed.into_iter().filter(|p| example.value(*p).is_finite()) {
        all.push(Variable {
            causality: "local",
            variability: "constant",
            initial: Some("exact"),
            ..of_parameter(parameter, "fixed")
        });
    }
    for (index, variable) in all.iter_mut().enumerate() {
        variable.reference = index + 1;
        if let Some(exponent) = variable.exponent {
            variable.attributes.push(("unit", unit_name(exponent)));
        }
    }
    all
}
