//! A controller as one imperative program: what it is given, what it keeps, and what each of its
//! functions does, in statements that every language has.
//!
//! The printers of [`emit`](crate::emit) and the interpreter run the same statements, so that what is
//! simulated and tested is what is emitted. A function fails before it has changed anything:
//! [`Code::check`] refuses a [`Statement::Require`] behind an assignment to a field.

mod check;
mod expression;
mod interpret;

pub use expression::{Expr, Operator, Test};
pub use interpret::{Argument, Instance, Outcome};

use crate::parameter::Precision;

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
    /// Says why the next statements stand here.
    Note(String),
}

/// What a function does with the controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Reads it.
    Read,
    /// Changes it.
    Change,
}

/// A function of the controller.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Its name, behind the controller's.
    pub name: &'static str,
    /// What it does, and the unit of what it gives.
    pub about: String,
    /// Whether it changes the controller.
    pub access: Access,
    /// What it is given.
    pub arguments: Vec<Variable>,
    /// What it gives beside the status, once the body is through.
    pub results: Vec<Given>,
    /// The statuses with which it can fail.
    pub failures: Vec<Status>,
    /// What it does.
    pub body: Vec<Statement>,
    /// The status once the body is through.
    pub status: Outcomes,
    /// Whether arguments are checked; without it pointers are trusted too.
    pub guarded: bool,
}

/// A result of a function: one value, or one for each element.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// Its name and shape.
    pub variable: Variable,
    /// Its values.
    pub values: Vec<Expr>,
}

/// The status of a call that does not fail.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcomes {
    /// Always the same.
    One(Status),
    /// The first whose test holds, else the last one.
    First(Vec<(Test, Status)>, Status),
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
    /// What `init` does: parameters in, fields out.
    pub init: Vec<Statement>,
    /// All other functions.
    pub functions: Vec<Function>,
}

impl Variable {
    /// A variable.
    pub fn new(name: impl Into<String>, shape: Shape, about: impl Into<String>) -> Self {
        Self { name: name.into(), shape, about: about.into() }
    }
}

impl Code {
    /// The function called `name`.
    pub fn function(&self, name: &str) -> Option<&Function> {
        self.functions.iter().find(|function| function.name == name)
    }
}
