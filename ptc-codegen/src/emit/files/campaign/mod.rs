//! A program in C that runs scenarios of a sampled loop: the emitted controller with a plant that is linear between
//! samples, whose numbers it reads.

use askama::Template;

use super::{File, Language, c, program, program_in_samples, text_of};
use crate::check::examine::Report;
use crate::code::{Code, Expr, Shape};
use crate::controller::Controller;
use crate::diagnostic::Diagnostic;
use crate::emit::tidy;
use crate::parameter::Parameter;

/// Sizes of a loop.
#[derive(Clone, Debug, PartialEq)]
pub struct Sizes {
    /// States of the plant.
    pub states: usize,
    /// Its inputs.
    pub inputs: usize,
    /// Measured values that the controller is given.
    pub measured: usize,
    /// Rows of y = C x; empty where the states themselves are measured.
    pub outputs: Vec<Vec<f64>>,
    /// Inputs that are computed and do not act yet.
    pub late: usize,
    /// Parts of a sample in which other inputs act: 1, or 2 where a delay ends between two samples.
    pub parts: usize,
    /// Run-time parameters of the controller, in the order in which their values are read.
    pub parameters: Vec<Parameter>,
    /// True if the clock of the controller is the number of the sample.
    pub in_samples: bool,
}

/// The files of the program.
#[derive(Clone, Debug)]
pub struct Program {
    /// Those of the controller, as it is emitted, and [`MAIN`].
    pub files: Vec<File>,
    /// True if the controller calls a function that libraries compute with errors of their own.
    pub calls_library: bool,
}

/// The file to compile, which includes the others.
pub const MAIN: &str = "main.c";

/// The program of a controller in time; `None` for a controller that is called with more than its clock and what is
/// measured.
///
/// # Errors
/// As of the emission of C.
pub fn in_time(
    controller: &Controller<'_>,
    sizes: &Sizes,
) -> Result<Option<Program>, Vec<Diagnostic>> {
    let code = program(controller, Language::C);
    around(&code, super::emit(controller, Language::C)?, sizes)
}

/// The same of a controller in samples.
///
/// # Errors
/// As [`in_time`].
pub fn in_samples(report: &Report, sizes: &Sizes) -> Result<Option<Program>, Vec<Diagnostic>> {
    let code = program_in_samples(report, Language::C);
    around(&code, super::emit_sampled(report, Language::C)?, sizes)
}

fn around(
    code: &Code,
    mut files: Vec<File>,
    sizes: &Sizes,
) -> Result<Option<Program>, Vec<Diagnostic>> {
    let Some(main) = main(code, sizes) else { return Ok(None) };
    files.push(main);
    let mut calls_library = false;
    code.visit(&mut |value| {
        calls_library |= match value {
            Expr::Call(function, _) => function.is_of_library(),
            value => matches!(value, Expr::Pow(..)),
        }
    });
    Ok(Some(Program { files, calls_library }))
}

/// The source of the program, which includes that of the controller; `None` for a controller that is called with more
/// than its clock and what is measured.
fn main(code: &Code, sizes: &Sizes) -> Option<File> {
    let step = code.function("step").filter(|step| step.callbacks.is_empty())?;
    let [_, measured] = step.arguments.as_slice() else { return None };
    let (u, rest) = step.results.split_first()?;
    let real = c::real(code.precision);
    let state = code.start.as_ref().and_then(|start| start.state.as_ref());
    let places = sizes.parameters.iter().map(|parameter| Place::of(code, *parameter));
    let source = Source {
        name: &code.name,
        real,
        sums: (0..sizes.states).map(|state| next(state, sizes)).collect(),
        outputs: sizes.outputs.iter().map(|row| output(row)).collect(),
        argument: argument("given", measured.shape, real),
        several: u.shape.length().is_some(),
        statuses: rest.iter().any(|result| matches!(result.shape, Shape::Statuses(_))),
        latches: state.is_some(),
        start: state.map_or_else(String::new, |state| argument("begin", state.shape, real)),
        places: places.collect::<Option<_>>()?,
        sizes,
    };
    let fits = code.parameters.iter().map(|own| own.shape.length().unwrap_or(1)).sum::<usize>();
    let file = File { name: MAIN.to_owned(), text: tidy(&text_of(source.render())) };
    (fits == sizes.parameters.len()).then_some(file)
}

/// A run-time parameter: its member, and its type.
struct Place {
    name: String,
    kind: &'static str,
}

impl Place {
    fn of(code: &Code, parameter: Parameter) -> Option<Self> {
        let own = code.parameters.iter().find(|own| own.name == parameter.key())?;
        let name = match (parameter.index(), own.shape.length()) {
            (Some(index), Some(_)) => format!("{}[{index}]", own.name),
            _ => own.name.clone(),
        };
        let kind = if own.shape == Shape::Count { "uint32_t" } else { c::real(code.precision) };
        Some(Self { name, kind })
    }
}

/// An array as a function takes it.
fn argument(name: &str, shape: Shape, real: &str) -> String {
    match shape {
        Shape::Lists(_, columns) => format!("(const {real} (*)[{columns}]){name}"),
        _ => name.to_owned(),
    }
}

/// A row of C x, summed from the first state on.
fn output(row: &[f64]) -> String {
    let terms = row.iter().enumerate().map(|(i, c)| format!("{c:?} * x[{i}]"));
    terms.collect::<Vec<_>>().join(" + ")
}

#[derive(Template)]
#[template(path = "campaign/main.c.txt", escape = "none")]
struct Source<'a> {
    name: &'a str,
    real: &'static str,
    sizes: &'a Sizes,
    /// The states at the end of a time.
    sums: Vec<String>,
    outputs: Vec<String>,
    /// What is measured, as `step` takes it.
    argument: String,
    /// True if `step` gives a list of inputs, and statuses beside it.
    several: bool,
    statuses: bool,
    /// True if `init` is given the state, and that as it takes it.
    latches: bool,
    start: String,
    places: Vec<Place>,
}

/// The state of an index at the end of a time: its row of E, that of F B and the number of F c.
fn next(state: usize, sizes: &Sizes) -> String {
    let from = state * (sizes.states + sizes.inputs + 1);
    let sum = |vector: &str, from: usize, length: usize| {
        let terms = (0..length).map(|j| format!("row[{}] * {vector}[{j}]", from + j));
        terms.collect::<Vec<_>>().join(" + ")
    };
    let (whole, acting) =
        (sum("x", from, sizes.states), sum("u", from + sizes.states, sizes.inputs));
    format!("({whole}) + ({acting} + row[{}])", from + sizes.states + sizes.inputs)
}

/// Flags with which a C compiler makes the program, so that its bits are those of the interpreter: no product is fused with a
/// sum, and no call is replaced by the compiler's own mathematics.
pub const FLAGS: [&str; 3] = ["-O2", "-std=c99", "-ffp-contract=off"];

/// Functions of the mathematical library that a compiler could compute by itself.
const CALLED: [&str; 17] = [
    "acos", "acosh", "asin", "asinh", "atan", "atanh", "cos", "cosh", "exp", "expm1", "log",
    "log1p", "pow", "sin", "sinh", "tan", "tanh",
];

/// All flags of the compiler.
pub fn flags() -> Vec<String> {
    let own = CALLED
        .iter()
        .flat_map(|name| ["", "f"].map(|suffix| format!("-fno-builtin-{name}{suffix}")));
    FLAGS.iter().map(|flag| (*flag).to_owned()).chain(own).collect()
}
