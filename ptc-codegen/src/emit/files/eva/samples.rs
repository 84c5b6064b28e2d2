//! The harness of a controller in samples, or of an observer alone.
//!
//! A call changes the controller, so the proof is one of any call: from whatever the calls before it
//! may have left, within bounds in finite mode.

use askama::Template;

use super::{Call, Drawn, LAW, OPTIONS, Range, STATE, is_compared, literal, rounded, stem};
use crate::code::{Code, Shape, Statement, Variable};
use crate::emit::files::acsl::changed;
use crate::emit::files::apart::apart;
use crate::emit::files::outline::Outline;
use crate::emit::files::text_of;
use crate::emit::{File, tidy};
use crate::internal::fault;
use crate::parameter::{Parameter, Precision};
use crate::request::{Gate, Guard, Spec, What};

/// A field that a call changes, and the macro of its bound where it is a number.
struct Kept {
    name: String,
    bound: Option<String>,
}

/// A macro of a bound, and its default.
struct Bound {
    stem: String,
    value: String,
}

/// The harness, beside the annotated source.
pub(in crate::emit) fn harness(spec: &Spec, code: &Code) -> File {
    let name = spec.name();
    let prefix = format!("{}_EVA", name.to_uppercase());
    let text = |value: f64| literal(value, spec.precision);
    let limit = spec.fixed.get(&Parameter::UMax).filter(|fixed| fixed.number().is_some());
    let limit = limit.map(|fixed| rounded(fixed, spec));
    let open = |p: Parameter| spec.run_time_parameters().any(|of| of == p);
    let mut bounds = Vec::new();
    let mut bound = |of: &str, value: f64| {
        let stem = format!("{prefix}_{}_MAX", of.to_uppercase());
        bounds.push(Bound { stem: stem.clone(), value: text(value) });
        stem
    };
    let alone = spec.what == What::Observer;
    let measured = spec.sampled().map_or(0, |sampled| sampled.measured);
    let x_max = |j: usize| spec.promises.x_max.get(j).map_or(STATE, |bound| rounded(bound, spec));
    let y_max = match spec.sampled() {
        Some(sampled) if sampled.linear.is_none() => (0..measured).map(x_max).collect(),
        _ => vec![STATE; measured],
    };
    let y: Vec<_> = (1..).zip(&y_max).map(|(j, value)| bound(&format!("y{j}"), *value)).collect();
    let r = (0..spec.references()).map(|j| bound(&format!("r{j}"), STATE)).collect();
    let applied = alone.then(|| bound("applied", LAW));
    let changed = changed(code);
    let kept = code.fields.iter().filter(|field| changed.contains(field.name.as_str()));
    let kept = kept.map(|field| {
        let input = field.name.strip_prefix('u').is_some_and(|rest| rest.parse::<u32>().is_ok());
        let most = if input { most_input(spec).unwrap_or(LAW) } else { STATE };
        let number = field.shape == Shape::Real;
        Kept { name: field.name.clone(), bound: number.then(|| bound(&field.name, most)) }
    });
    let kept: Vec<_> = kept.collect();
    let calls: Vec<_> = code.functions.iter().map(call).collect();
    let (work, others): (Vec<_>, Vec<_>) =
        calls.iter().partition(|call| matches!(call.function, "step" | "update"));
    // The precision represents each count up to it exactly.
    let exact = if spec.precision == Precision::F32 { 1 << 24 } else { u32::MAX };
    let is_time = |one: &Statement| matches!(one, Statement::Let(name, ..) if name == "t");
    let timed = code.functions.iter().any(|function| function.body.iter().any(is_time));
    let ticks =
        timed.then(|| Bound { stem: format!("{prefix}_ELAPSED_MAX"), value: format!("{exact}U") });
    let text_of_call = |call: &&Call| call.text(&name, None);
    let parameters = spec.run_time_parameters().filter(|p| *p != Parameter::UMax);
    let full = spec.guard == Guard::Full;
    let gate = spec.sampled().and_then(|own| own.observer.as_ref()).map(|own| &own.gate);
    let harness = Harness {
        name: &name,
        options: OPTIONS,
        frame: &Outline::new(spec, code),
        ranges: ranges(spec, &prefix),
        ticks,
        bounds,
        parameters: parameters.map(|p| Drawn::new(spec, &prefix, p)).collect(),
        has_parameters: !code.parameters.is_empty(),
        compared: spec.run_time_parameters().any(|p| is_compared(spec, p)),
        run_time_limit: open(Parameter::UMax),
        limit_stem: stem(&prefix, Parameter::UMax),
        fixed_limit: limit.map(text),
        lower: super::lower(spec, &prefix),
        open_lower: open(Parameter::UMin),
        given: if spec.sampled().is_some_and(|s| s.measures_states()) { "x" } else { "y" },
        y,
        r,
        applied,
        kept,
        full,
        gated: gate.is_some_and(|gate| *gate != Gate::default()),
        trust: gate.filter(|gate| gate.coast > 0).map(|gate| format!("{}U", gate.coast + 1)),
        alone,
        work: work.first().map_or_else(|| fault("nothing to call"), text_of_call),
        results: results(code),
        reads: others.iter().filter(|call| call.function != "arm").map(text_of_call).collect(),
        null_calls: calls
            .iter()
            .flat_map(|call| call.pointers.iter().map(|at| call.text(&name, Some(*at))))
            .collect(),
        zero: text(0.0),
        one: text(1.0),
        pattern: text(42.0),
    };
    apart(File { name: format!("{name}_eva.c"), text: tidy(&text_of(harness.render())) }, &name)
}

/// Greatest size of an input within its limits, where both are fixed.
fn most_input(spec: &Spec) -> Option<f64> {
    let most = crate::program::range::Range::fixed(spec, 0).largest();
    most.is_finite().then_some(most)
}

/// Range of each open parameter in finite mode.
fn ranges(spec: &Spec, prefix: &str) -> Vec<Range> {
    let least = spec.sampled().map_or(1, |sampled| sampled.least_samples(spec.highest_order()));
    let range = |p: Parameter| {
        let number = |value: f64| literal(value, spec.precision);
        let (least, greatest) = match p {
            Parameter::Samples => {
                (format!("{least}U"), format!("{}U", least.saturating_mul(2).max(1000)))
            }
            Parameter::SampleTime => (number(1e-2), number(1e-2)),
            Parameter::Eps | Parameter::Deadbeat => (number(0.0), number(0.0)),
            Parameter::UMax => (number(LAW), number(LAW)),
            Parameter::UMin => (number(-LAW), number(-LAW)),
            Parameter::Gain(_) => (number(-100.0), number(100.0)),
            _ => (number(1.0), number(1.0)),
        };
        Range { stem: stem(prefix, p), least, greatest, open: true }
    };
    spec.run_time_parameters().map(range).collect()
}

/// Results of the functions besides u.
fn results(code: &Code) -> Vec<Variable> {
    let results = code.functions.iter().flat_map(|function| &function.results);
    results.filter(|result| result.name != "u").cloned().collect()
}

/// A function with what it is called with.
fn call(function: &crate::code::Function) -> Call {
    let mut arguments = vec!["self".to_owned()];
    let mut pointers = vec![0];
    for argument in &function.arguments {
        if argument.shape.length().is_some() {
            pointers.push(arguments.len());
        }
        arguments.push(argument.name.clone());
    }
    for result in &function.results {
        pointers.push(arguments.len());
        arguments.push(match result.shape.length() {
            Some(_) => result.name.clone(),
            None => format!("&{}", result.name),
        });
    }
    Call { function: function.name, arguments, pointers }
}

#[derive(Template)]
#[template(path = "eva/samples.c.txt", escape = "none")]
struct Harness<'a> {
    name: &'a str,
    options: &'static str,
    frame: &'a Outline,
    ranges: Vec<Range>,
    /// Upper bound of the ticks since the start, where time itself is computed.
    ticks: Option<Bound>,
    bounds: Vec<Bound>,
    parameters: Vec<Drawn>,
    has_parameters: bool,
    compared: bool,
    /// True if u_max is left to run time; then the stem of its range, and its value where it is fixed.
    run_time_limit: bool,
    limit_stem: String,
    fixed_limit: Option<String>,
    /// Lower limit of u in the assertion, as an expression.
    lower: String,
    /// True if u_min is left to run time.
    open_lower: bool,
    /// Measurement: its name, and the macros of its bounds.
    given: &'static str,
    y: Vec<String>,
    /// The macros of the bounds of the reference and its derivatives.
    r: Vec<String>,
    /// The macro of the bound of the input that an observer alone is given.
    applied: Option<String>,
    /// Fields that calls change.
    kept: Vec<Kept>,
    /// True if every pointer and input is checked.
    full: bool,
    /// True if a gate refuses readings.
    gated: bool,
    /// Value of the field `trust` after a reading that was believed, where the observer may predict alone.
    trust: Option<String>,
    alone: bool,
    /// The call of `step` or `update`, and those that give the estimates with their results.
    work: String,
    results: Vec<Variable>,
    reads: Vec<String>,
    /// Calls in which one pointer is NULL.
    null_calls: Vec<String>,
    zero: String,
    one: String,
    /// Value of fields that nothing has set.
    pattern: String,
}
