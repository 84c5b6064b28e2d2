//! A controller as one imperative program: what it is given, what it keeps, and what each of its
//! functions does, in statements that every language has.
//!
//! The printers of [`emit`](crate::emit) and the interpreter run the same statements, so that what is
//! simulated and tested is what is emitted. A function fails before it has changed anything:
//! [`Code::check`] refuses a [`Statement::Require`] behind an assignment to a field.

mod bounds;
mod branch;
mod check;
mod constant;
mod expression;
mod function;
mod index;
mod inputs;
#[cfg(feature = "files")]
mod interpret;
mod iteration;
mod map;
mod operation;
mod statement;
mod status;
mod subroutine;
mod table;
mod unused;
mod visit;

pub use bounds::{Bounds, limits_in_order};
pub use branch::{Branch, Condition, Taken};
pub use constant::Constant;
pub use expression::{AXIS, Cell, Expr, Operator, Test};
pub use function::{Access, Callback, Ending, Finish, Function, Owner};
pub use index::Index;
pub use inputs::{Inputs, Standing, Whose};
#[cfg(feature = "simulate")]
pub use interpret::InstanceLanes;
#[cfg(feature = "files")]
pub use interpret::{Argument, Called, Handle, Instance, Outcome, Slot};
pub use iteration::Iteration;
pub(crate) use operation::Written;
pub use statement::{For, Place, Statement};
pub use status::Status;
pub use subroutine::{Given, Subroutine};
pub use table::Table;

use crate::parameter::{Parameter, Precision};

/// The values that a name can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
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
    /// Shape of its value.
    pub shape: Shape,
    /// Meaning, unit and domain.
    pub about: String,
}

/// The argument of a filter that is the u of a controller.
pub const NOMINAL: &str = "u_nominal";

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
    /// Fields; `init` sets all of them.
    pub fields: Vec<Variable>,
    /// The gains that a function gives and another one takes; `None` if there are none.
    pub gains: Vec<Variable>,
    /// Constant tables that its functions read.
    pub tables: Vec<Table>,
    /// Statements of `init`: parameters in, fields out.
    pub init: Vec<Statement>,
    /// End of `init`, where that is not by its statements alone.
    pub start: Option<Start>,
    /// All other functions.
    pub functions: Vec<Function>,
}

/// The call of `arm`, or of `arm_for` where the duration changes in flight, that ends `init`.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// The start time.
    pub time: Expr,
    /// The duration that `arm_for` is given.
    pub duration: Option<Expr>,
    /// The state that is latched, which `init` is given too.
    pub state: Option<Variable>,
}

impl Start {
    /// Returns the name of the function that is called.
    pub fn function(&self) -> &'static str {
        if self.duration.is_some() { "arm_for" } else { "arm" }
    }

    /// The numbers that it is given, before the state that is latched.
    pub fn numbers(&self) -> impl Iterator<Item = &Expr> {
        std::iter::once(&self.time).chain(&self.duration)
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
    /// Returns true if its functions depend on their arguments alone: they are those of a robot.
    pub fn is_stateless(&self) -> bool {
        self.fields.is_empty() && self.start.is_none() && !self.functions.iter().any(changes)
    }

    /// Returns what it is, for a title.
    pub fn title(&self) -> String {
        match self.is_stateless() {
            true => "Functions of the robot".to_owned(),
            false => format!("Prescribed-time {}", self.noun()),
        }
    }

    /// Describes `init` in a sentence.
    pub fn starts(&self) -> String {
        if self.is_stateless() {
            return "Has nothing to compute: every number of the robot is fixed.".to_owned();
        }
        let Some(start) = &self.start else {
            return "Takes the parameters and arms at tick 0.".to_owned();
        };
        let latching = match &start.state {
            Some(state) => format!(", latching the state {}", state.name),
            None => String::new(),
        };
        let duration = if start.duration.is_some() { " for params.tau" } else { "" };
        format!("Takes the parameters and arms at params.t0 (or the fixed t0){duration}{latching}.")
    }

    /// Returns true if a start may be given another duration.
    pub fn changes_duration(&self) -> bool {
        self.start.as_ref().is_some_and(|start| start.duration.is_some())
    }

    /// Returns its noun in descriptions.
    pub fn noun(&self) -> &'static str {
        if self.function("update").is_some() {
            return "observer";
        }
        if self.is_stateless() {
            return "robot";
        }
        if self.is_filter() { "filter" } else { "controller" }
    }

    /// Returns true if `step` takes the u of a controller, which it filters.
    pub fn is_filter(&self) -> bool {
        let step = self.function("step");
        step.is_some_and(|step| step.arguments.iter().any(|argument| argument.name == NOMINAL))
    }

    /// The number of its axes, or of the inputs of its plant, where `step` is that of several.
    pub fn axes(&self) -> Option<usize> {
        let step = self.function("step").filter(|step| step.finish == Finish::Stands)?;
        step.results.first()?.shape.length()
    }

    /// Returns true if `axis` takes the number of its axis, because gains, limits or g differ between axes.
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

    /// The functions of a clock in samples that may fail and are not the call of each tick.
    pub fn commands(&self) -> impl Iterator<Item = &Function> {
        let in_samples = self.start.is_none();
        let is_command = |function: &&Function| {
            !function.failures.is_empty() && !matches!(function.name, "step" | "update")
        };
        self.functions.iter().filter(move |_| in_samples).filter(is_command)
    }

    /// The function called `name`.
    pub fn function(&self, name: &str) -> Option<&Function> {
        self.functions.iter().find(|function| function.name == name)
    }
}

fn changes(function: &Function) -> bool {
    function.access == Access::Change
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
