//! The harness with which Frama-C's plug-in Eva proves that the emitted C has no error at run time.

mod calls;
mod ranges;
mod samples;

pub(super) use samples::harness as in_samples;

use askama::Template;

use super::acsl::place;
use super::apart::apart;
use super::c::externs;
use super::outline::Outline;
use super::{Controller, File, literal, text_of, tidy};
use crate::code::{Code, Expr};
use crate::controller::checked;
use crate::expression::Function as Math;
use crate::parameter::{Domain, Fixed, Parameter, Precision};
use crate::program::digits::Condition;
use crate::program::number;
use crate::request::{Guard, Spec};
use calls::{Call, calls, handed};
use ranges::{Range, ranges, stem};

/// Bound of |x_i| and of what functions of the user give, where the design promises none.
const STATE: f64 = 10.0;
const LAW: f64 = 10.0;

/// Precision of Eva: enough separate states for all calls and cases, loops unrolled round by round, statuses kept
/// apart, expressions in which a variable occurs twice subdivided, and equalities tracked between copies of a value.
const OPTIONS: &str = "-eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all \
                       -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality";

/// A run-time parameter as a harness draws it.
struct Drawn {
    place: String,
    /// Stem of its range.
    stem: String,
    /// True for a count.
    count: bool,
    /// The function that draws it, up to the range.
    source: &'static str,
}

impl Drawn {
    fn new(spec: &Spec, prefix: &str, p: Parameter) -> Self {
        let count = p == Parameter::Samples;
        let source = match p {
            _ if count => "count(",
            Parameter::UMin => "limit(level, ",
            _ if is_compared(spec, p) => "number(level, ",
            _ => "draw(",
        };
        Self { place: place("params.", p), stem: stem(prefix, p), count, source }
    }
}

/// Returns true if a comparison alone shows the domain of a parameter.
fn is_compared(spec: &Spec, p: Parameter) -> bool {
    !matches!(spec.domain(p), Domain::Finite | Domain::Positive)
}

/// The harness of a controller, beside its annotated source.
pub(super) fn harness(controller: &Controller<'_>, program: &Code) -> File {
    let spec = controller.spec();
    let name = spec.name();
    let frame = &Outline::new(controller.spec(), program);
    let callbacks: Vec<_> = program.callbacks().into_iter().cloned().collect();
    let externs = &externs(&name, &callbacks);
    let prefix = format!("{}_EVA", name.to_uppercase());
    let text = |value: f64| literal(value, spec.precision);
    let ranges = ranges(controller, &prefix);
    let drawn = spec
        .run_time_parameters()
        .filter(|p| !matches!(p, Parameter::Tau | Parameter::StartTime | Parameter::UMax))
        .map(|p| Drawn::new(spec, &prefix, p))
        .collect();
    let promised = |bounds: &[Fixed], j: usize| bounds.get(j).map(|bound| rounded(bound, spec));
    let x_max = |j| promised(&spec.promises.x_max, j).unwrap_or(STATE);
    let x0_max = |j| promised(&spec.promises.x0_max, j).unwrap_or(x_max(j));
    let states = |of: &dyn Fn(usize) -> f64| (0..spec.states()).map(|j| text(of(j))).collect();
    let open = |p: Parameter| spec.run_time_parameters().any(|of| of == p);
    let run_time_limit = open(Parameter::UMax);
    let u_max = spec.fixed.get(&Parameter::UMax).filter(|fixed| fixed.number().is_some());
    let fixed_limit = u_max.map(|fixed| text(rounded(fixed, spec)));
    let lower = lower(spec, &prefix);
    let calls = calls(&name, frame, externs);
    let with = |argument: &str| {
        let having = calls.iter().filter(|call| call.arguments.iter().any(|a| a == argument));
        having.map(|call| call.text(&name, None)).collect()
    };
    let checks = checked(controller).init;
    let harness = Harness {
        name: &name,
        prefix: &prefix,
        frame,
        full: spec.guard == Guard::Full,
        starts: !checks.iter().any(|check| matches!(check, Condition::Kept(..))),
        finite_inputs: spec.guard == Guard::None,
        open_tau: open(Parameter::Tau),
        open_t0: open(Parameter::StartTime),
        run_time_limit,
        fixed_limit,
        lower,
        open_lower: open(Parameter::UMin),
        handed: handed(&name, externs),
        null_calls: calls
            .iter()
            .flat_map(|call| call.pointers.iter().map(|at| call.text(&name, Some(*at))))
            .collect(),
        without_contract: without_contract(program),
        state_calls: with("x"),
        timed_calls: with("t"),
        all_places: spec.run_time_parameters().map(|p| place("params.", p)).collect(),
        sees_all: spec.guard == Guard::Full || frame.associated,
        compared: spec.run_time_parameters().any(|p| is_compared(spec, p)),
        options: OPTIONS,
        ranges,
        drawn,
        x_max: states(&x_max),
        x0_max: states(&x0_max),
        r_max: vec![text(STATE); spec.references()],
        law: text(LAW),
        holds: program.fields.iter().any(|field| field.name == "hold_from"),
        abs: if spec.precision == Precision::F32 { "fabsf" } else { "fabs" },
        externs,
        zero: text(0.0),
        piece: text(1.05),
        ratio: text(0.6),
        sixteen: text(16.0),
        pattern: text(42.0),
        one: text(1.0),
        long: text(1e6),
    };
    apart(File { name: format!("{name}_eva.c"), text: tidy(&text_of(harness.render())) }, &name)
}

/// The lower limit of u where u_max is `limit`; one that is left to run time has that of its range.
fn lower(spec: &Spec, prefix: &str) -> String {
    if !spec.u_min {
        return "-limit".to_owned();
    }
    match spec.fixed.get(&Parameter::UMin) {
        Some(Fixed::MinusInfinite) => "\\minus_infinity".to_owned(),
        Some(fixed) => literal(rounded(fixed, spec), spec.precision),
        None => format!("{}_MIN", stem(prefix, Parameter::UMin)),
    }
}

fn literal(value: f64, precision: Precision) -> String {
    literal::c(value, precision)
}

fn rounded(value: &Fixed, spec: &Spec) -> f64 {
    value.number().map_or(f64::INFINITY, |value| number::round(value, spec.precision))
}

/// Functions of the C library that the code calls and Frama-C has no contract for.
fn without_contract(program: &Code) -> Vec<String> {
    let suffix = if program.precision == Precision::F32 { "f" } else { "" };
    let mut called = Vec::new();
    program.visit(&mut |value| {
        if let Expr::Call(function, _) = value {
            called.push(*function);
        }
    });
    let all = Math::ALL.into_iter().map(|(_, function)| function);
    let all = all.filter(|function| !function.words().contract && called.contains(function));
    all.map(|function| format!("{}{suffix}", function.name())).collect()
}

#[derive(Template)]
#[template(path = "eva/time.c.txt", escape = "none")]
struct Harness<'a> {
    name: &'a str,
    /// Prefix of macros.
    prefix: &'a str,
    frame: &'a Outline,
    /// True if every pointer and input is checked.
    full: bool,
    /// True if `init` accepts all legal parameters: none makes a product too small that may also be 0, which an
    /// interval of gains would include.
    starts: bool,
    /// True if x and t are trusted to be finite.
    finite_inputs: bool,
    /// True if tau, t0 and u_max are left to run time.
    open_tau: bool,
    open_t0: bool,
    run_time_limit: bool,
    /// A bound of |u| that the design fixes.
    fixed_limit: Option<String>,
    /// Lower limit of u in the assertion, as an expression.
    lower: String,
    /// True if u_min is left to run time.
    open_lower: bool,
    /// Arguments between state and u.
    handed: String,
    /// Functions of the C library that lack a contract.
    without_contract: Vec<String>,
    /// Calls in which one pointer is NULL, for each that is checked.
    null_calls: Vec<String>,
    /// Calls that take the state, and those that take time.
    state_calls: Vec<String>,
    timed_calls: Vec<String>,
    /// Places of all run-time parameters.
    all_places: Vec<String>,
    /// True if comparisons alone show the domain of any parameter.
    compared: bool,
    options: &'static str,
    /// True if Eva sees that u is finite for any inputs. A guard without checks compares v - v, and NaN takes the right
    /// branch; Eva does not see that.
    sees_all: bool,
    ranges: Vec<Range>,
    drawn: Vec<Drawn>,
    x_max: Vec<String>,
    x0_max: Vec<String>,
    /// Bounds of the reference and its derivatives, where each call is given them.
    r_max: Vec<String>,
    law: String,
    /// True if the hold begins at a field, which is negative.
    holds: bool,
    /// The function of the C library for |x|.
    abs: &'static str,
    externs: &'a [(String, &'static str)],
    zero: String,
    /// Ratio of the ends of a piece of tau.
    piece: String,
    /// Ratio of the ends of a piece of time-to-go.
    ratio: String,
    sixteen: String,
    /// Value of fields that nothing has set.
    pattern: String,
    one: String,
    /// A time long after the deadline, s.
    long: String,
}
