//! A controller as one imperative program: what it is given, what it keeps, and what each of its
//! functions does, in statements that every language has.
//!
//! The printers of [`emit`](crate::emit) and the interpreter run the same statements, so that what is
//! simulated and tested is what is emitted. A function fails before it has changed anything:
//! [`Code::check`] refuses a [`Statement::Require`] behind an assignment to a field.

mod branch;
mod check;
mod expression;
mod function;
#[cfg(feature = "files")]
mod interpret;
mod operation;
mod visit;

pub use branch::{Branch, Condition, Taken};
pub use expression::{AXIS, Cell, Expr, Operator, Test};
pub use function::{Access, Axes, Callback, Ending, Finish, Function, Inputs, Owner};
#[cfg(feature = "files")]
pub use interpret::{Argument, Called, Instance, Outcome};

use crate::expression::Function as Call;
#[cfg(feature = "files")]
use crate::internal::fault;
use crate::parameter::{Parameter, Precision};
use crate::program::{Root, number};

/// Outcome of a call, with the words of the emitted interfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Tracking.
    Ok,
    /// Time-to-go is held, or the deadline is over.
    Hold,
    /// |u| was clipped to `u_max`.
    Saturated,
    /// The deadline is over, and u is 0.
    After,
    /// A parameter outside its domain, or a coefficient that overflows.
    Param,
    /// An argument that is not finite.
    Input,
    /// A result that is not finite.
    Range,
}

impl Status {
    /// Its name in the languages that begin it with a capital.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ok => "Ok",
            Self::Hold => "Hold",
            Self::Saturated => "Saturated",
            Self::After => "After",
            Self::Param => "Param",
            Self::Input => "Input",
            Self::Range => "Range",
        }
    }

    /// The status with a number, as an array of them holds it.
    #[cfg(feature = "files")]
    pub(crate) fn of_number(number: f64) -> Self {
        let all = [
            Self::Ok,
            Self::Hold,
            Self::Saturated,
            Self::After,
            Self::Param,
            Self::Input,
            Self::Range,
        ];
        let found = all.into_iter().find(|status| f64::from(status.number()) == number);
        found.unwrap_or_else(|| fault(format!("no status has the number {number}")))
    }

    /// Its number in the languages without names for it: negative where the call failed.
    pub fn number(self) -> i32 {
        match self {
            Self::Ok => 0,
            Self::Hold => 1,
            Self::Saturated => 2,
            Self::After => 3,
            Self::Param => -1,
            Self::Input => -2,
            Self::Range => -3,
        }
    }
}

/// The values that a name can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A floating-point number.
    Real,
    /// An unsigned integer of 32 bits, which wraps.
    Count,
    /// An array of floating-point numbers.
    Reals(usize),
    /// An array of arrays: so many of so many numbers each.
    Lists(usize, usize),
    /// The statuses of so many axes.
    Statuses(usize),
    /// The gains at one time, [`Code::gains`], and their status.
    Gains,
}

/// A parameter, an argument, a result or a field.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Its name in every language.
    pub name: String,
    /// What it holds.
    pub shape: Shape,
    /// Meaning, unit and domain.
    pub about: String,
}

/// A place to which a function assigns.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A local variable.
    Local(String),
    /// A field of the controller.
    Field(String),
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// A local value that does not change.
    Let(String, Shape, Expr),
    /// A local variable that changes; the statements behind it set it on every way.
    Variable(String, Shape),
    /// An assignment.
    Set(Place, Expr),
    /// Statements for either outcome of a test; the second may be empty.
    If(Test, Vec<Statement>, Vec<Statement>),
    /// The call ends with a negative status, nothing being changed, unless the test holds.
    Require(Test, Status),
    /// A local array that does not change.
    Array(String, Vec<Expr>),
    /// A local value: the root of a residual.
    Solve(Box<Solve>),
    /// A local array: the rows that [`program::rows`](crate::program::rows) forms by loops.
    Rows {
        /// Its name.
        name: String,
        /// Coefficients of z^2, z^3, ...
        tail: Vec<Expr>,
        /// Weights of z, z^2, ...
        weights: Vec<Expr>,
        /// Whether each product and its sum are rounded once.
        fused: bool,
    },
    /// A local array: the solution of a x = b that [`program::elimination`](crate::program::elimination) gives.
    Elimination {
        /// Its name.
        name: String,
        /// a, row by row.
        matrix: Vec<Expr>,
        /// b.
        right: Vec<Expr>,
    },
    /// A local array: what a function of the user's gives for an array, a time and kappa'.
    Call {
        /// Its name.
        name: String,
        /// The function.
        callback: &'static str,
        /// What it is given: an array, and two numbers.
        array: String,
        /// Time, and kappa'.
        times: [Expr; 2],
        /// How many numbers it gives.
        count: usize,
    },
    /// Says why the next statements are here.
    Note(String),
}

/// A bracketed iteration for a root, as [`program::Root`](crate::program::Root) says.
#[derive(Clone, Debug, PartialEq)]
pub struct Solve {
    /// The unknown, and then the root.
    pub unknown: String,
    /// Where it starts.
    pub start: Expr,
    /// Lower end of the bracket.
    pub low: Expr,
    /// Upper end of the bracket.
    pub high: Expr,
    /// What a round computes first.
    pub body: Vec<Statement>,
    /// The residual: positive where the root lies right of the unknown.
    pub residual: Expr,
    /// Proposed next unknown.
    pub next: Expr,
    /// Size of the proposed step.
    pub size: Expr,
    /// Size at which the iteration ends.
    pub tolerance: Expr,
    /// Rounds in which `next` counts; those after it take the geometric middle.
    pub proposals: u32,
    /// Bound on the number of rounds.
    pub rounds: u32,
}

/// A controller.
#[derive(Clone, Debug, PartialEq)]
pub struct Code {
    /// Prefix of every emitted symbol.
    pub name: String,
    /// Type of its numbers.
    pub precision: Precision,
    /// The head of the file, in lines without comment signs.
    pub head: Vec<String>,
    /// The parameters left to run time.
    pub parameters: Vec<Variable>,
    /// What it keeps; `init` sets all of it.
    pub fields: Vec<Variable>,
    /// The gains that a function gives and another one takes; `None` if there are none.
    pub gains: Vec<Variable>,
    /// What `init` does: parameters in, fields out.
    pub init: Vec<Statement>,
    /// How `init` ends, where that is not by its statements alone.
    pub start: Option<Start>,
    /// All other functions.
    pub functions: Vec<Function>,
}

/// The call of `arm` that ends `init`.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// The start time.
    pub time: Expr,
    /// The state that is latched, which `init` is given too.
    pub state: Option<Variable>,
}

impl Solve {
    /// The local values of an iteration beside the unknown, by the suffixes of their names.
    pub const LOCALS: [&'static str; 4] = ["low", "high", "next", "size"];

    /// The number of a round, from 0.
    pub const ROUND: &'static str = "attempt";

    /// The geometric middle of the bracket, as [`program::Root::middle`](crate::program::Root::middle)
    /// computes it, and the test that holds in the rounds that take it; `None` without such rounds.
    pub fn bisection(&self, precision: Precision) -> Option<(Test, Expr)> {
        let last = self.proposals.checked_sub(1).filter(|_| self.proposals < self.rounds)?;
        let [low, high] = ["low", "high"].map(|end| Expr::local(format!("{}_{end}", self.unknown)));
        let [lower, _] = Root::range(precision);
        let lower = Expr::Number(number::finite(lower));
        let above = Expr::binary(Operator::Add, low, lower);
        let root = |value| Expr::Call(Call::Sqrt, Box::new(value));
        let middle = Expr::binary(Operator::Mul, root(above), root(high));
        Some((Test::CountLess(Expr::Count(last), Expr::local(Self::ROUND)), middle))
    }
}

impl Shape {
    /// The number of all elements of an array; none for one value.
    pub fn length(self) -> Option<usize> {
        match self {
            Self::Reals(length) | Self::Statuses(length) => Some(length),
            Self::Lists(count, length) => Some(count * length),
            Self::Real | Self::Count | Self::Gains => None,
        }
    }
}

impl Variable {
    /// A variable.
    pub fn new(name: impl Into<String>, shape: Shape, about: impl Into<String>) -> Self {
        Self { name: name.into(), shape, about: about.into() }
    }
}

impl Code {
    /// What `init` does, in a sentence.
    pub fn starts(&self) -> String {
        let Some(start) = &self.start else {
            return "Takes the parameters and arms at tick 0.".to_owned();
        };
        let latching = match &start.state {
            Some(state) => format!(", latching the state {}", state.name),
            None => String::new(),
        };
        format!("Takes the parameters and arms at params.t0 (or the fixed t0){latching}.")
    }

    /// What it is, in a word.
    pub fn noun(&self) -> &'static str {
        if self.function("update").is_some() { "observer" } else { "controller" }
    }

    /// The number of its axes, or of the inputs of its plant, where `step` is that of several.
    pub fn axes(&self) -> Option<usize> {
        match &self.function("step")?.finish {
            Finish::Axes(axes) => Some(axes.count),
            Finish::Inputs(inputs) => Some(inputs.values.len()),
            _ => None,
        }
    }

    /// Whether its axes are the inputs of one plant, which `step` computes together.
    pub fn has_inputs(&self) -> bool {
        self.function("step").is_some_and(|step| matches!(step.finish, Finish::Inputs(_)))
    }

    /// Whether `axis` is given the number of its axis, which has gains, limits or g of its own.
    pub fn numbers_axes(&self) -> bool {
        let axis = self.function("axis");
        axis.is_some_and(|axis| axis.arguments.iter().any(|a| a.shape == Shape::Count))
    }

    /// The functions of the user's program that it calls, each once.
    pub fn callbacks(&self) -> Vec<&Callback> {
        let mut all: Vec<&Callback> = Vec::new();
        for callback in self.functions.iter().flat_map(|function| &function.callbacks) {
            if !all.iter().any(|known| known.name == callback.name) {
                all.push(callback);
            }
        }
        all
    }

    /// The function called `name`.
    pub fn function(&self, name: &str) -> Option<&Function> {
        self.functions.iter().find(|function| function.name == name)
    }
}

/// Name of a parameter as a local value, in every language.
pub(crate) fn parameter_name(parameter: Parameter) -> String {
    match parameter {
        Parameter::Gain(i) => format!("k{i}"),
        Parameter::Rate(i) => format!("a{i}"),
        // Apart from the names of the code itself.
        Parameter::Named(name) => format!("p_{name}"),
        parameter => parameter.key().to_owned(),
    }
}
