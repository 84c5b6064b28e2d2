//! A function of the controller: what it is given, does and gives.

use super::{Expr, Statement, Status, Test, Variable};
use crate::internal::fault;

/// Access of a function to the controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Reads it.
    Read,
    /// Changes it.
    Change,
}

/// Whose fields a function knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// The controller.
    Controller,
    /// The gains at one time, [`Code::gains`](super::Code::gains).
    Gains,
}

/// A function of the user's program that a function calls: a number from an array and a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Callback {
    /// Its name.
    pub name: &'static str,
    /// The array that it is given.
    pub array: &'static str,
    /// Length of that array.
    pub length: usize,
    /// Number of its results. A function with several is also given kappa'.
    pub gives: usize,
    /// Description of its result.
    pub about: &'static str,
}

/// A function of the controller.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Its name, behind the controller's.
    pub name: &'static str,
    /// Description, and the unit of its result.
    pub about: String,
    /// Whose fields it knows.
    pub owner: Owner,
    /// Access to these fields.
    pub access: Access,
    /// Arguments.
    pub arguments: Vec<Variable>,
    /// User-defined functions that it calls.
    pub callbacks: Vec<Callback>,
    /// Results besides the status.
    pub results: Vec<Variable>,
    /// The statuses with which it can fail.
    pub failures: Vec<Status>,
    /// Statements.
    pub body: Vec<Statement>,
    /// Result after the body.
    pub finish: Finish,
    /// True if arguments are checked; otherwise pointers are trusted too.
    pub guarded: bool,
}

/// The end of a call.
#[derive(Clone, Debug, PartialEq)]
pub enum Finish {
    /// The first where the test holds, else the second.
    If(Test, Box<Finish>, Box<Finish>),
    /// The results, those of arrays and gains one after the other, and the status.
    Give(Vec<Expr>, Ending),
    /// A negative status; the results are 0.
    Fail(Status),
    /// The results and the status are what statements have set.
    Stands,
}

/// The status of a call that does not fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// A known one.
    Known(Status),
    /// The status of the gains.
    OfGains,
}

impl Function {
    /// Returns true if it is given the duration, of which it tests the domain.
    pub fn takes_duration(&self) -> bool {
        self.arguments.iter().any(|argument| argument.name == "tau")
    }
}

impl Finish {
    /// One of two ends.
    pub fn choose(test: Test, yes: Self, no: Self) -> Self {
        Self::If(test, Box::new(yes), Box::new(no))
    }

    /// The end of a function that gives nothing but its status.
    pub fn done() -> Self {
        Self::give(Vec::new(), Status::Ok)
    }

    /// Results with a known status.
    pub fn give(values: Vec<Expr>, status: Status) -> Self {
        Self::Give(values, Ending::Known(status))
    }

    /// The results, where they are the same on every way on which the call does not fail.
    pub fn results(&self) -> Option<&[Expr]> {
        let mut all = Vec::new();
        self.each(&mut |end| {
            if let Self::Give(values, _) = end {
                all.push(values.as_slice());
            }
        });
        let (first, rest) = all.split_first()?;
        rest.iter().all(|values| values == first).then_some(first)
    }

    /// The results of a function whose ends all give the same.
    pub fn every(&self) -> &[Expr] {
        self.results().unwrap_or_else(|| fault("the ends of a function give different results"))
    }

    /// Puts other results in the place of those of every end.
    pub fn give_all(&mut self, results: &[Expr]) {
        match self {
            Self::If(_, yes, no) => {
                yes.give_all(results);
                no.give_all(results);
            }
            Self::Give(values, _) => *values = results.to_vec(),
            Self::Fail(_) | Self::Stands => {}
        }
    }

    /// Calls `look` on every end.
    pub fn each<'a>(&'a self, look: &mut dyn FnMut(&'a Self)) {
        match self {
            Self::If(_, yes, no) => {
                yes.each(look);
                no.each(look);
            }
            end => look(end),
        }
    }
}
