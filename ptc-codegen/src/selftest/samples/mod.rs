//! Self-test of a controller in samples, and its expected results.
//!
//! Its operations are those of IEEE 754 alone, so the interpreter of the whole program gives every
//! bit that a target must. What it decides besides is which calls are worth asking: those that take a
//! branch of the program which no other takes.

mod commands;
mod inputs;
mod parameters;
mod search;

use crate::code::{Branch, Code, Condition, Expr, Status};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Expression, Function, Node};
use crate::request::Spec;

pub use commands::{Command, commands, count, is_measured, numbers};

/// A call of `step`, or of `update`, and of the functions that give the estimates.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// The tick at which the controller is armed before it, if it is.
    pub start: Option<u32>,
    /// The function of a deadline in flight that is called before it.
    pub before: Option<Command>,
    /// The tick.
    pub k: u32,
    /// Measurement; behind it the reference and its derivatives, where each call is given them.
    pub y: Vec<f64>,
    /// The input of the tick before, which `update` takes.
    pub applied: Option<f64>,
    /// The status that it must give.
    pub status: Status,
    /// Every u that it must give; none of an observer alone.
    pub u: Vec<f64>,
    /// The status of each input, where there are several.
    pub axes: Vec<Status>,
    /// The estimates that it must leave, the disturbance last; empty without an observer.
    pub estimates: Vec<f64>,
}

/// Parameters that `init` takes, and calls one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Session {
    /// Run-time parameters in the order of the emitted struct.
    pub parameters: Vec<f64>,
    /// The calls, at least one.
    pub calls: Vec<Call>,
}

/// A way out of a condition that no call tried took.
#[derive(Clone, Debug, PartialEq)]
pub struct Untaken {
    /// The condition.
    pub condition: Condition,
    /// Reason, as far as it is known.
    pub reason: String,
}

/// A self-test.
#[derive(Clone, Debug, PartialEq)]
pub struct SelfTest {
    /// Sessions that must succeed, the first of them a round to the deadline and beyond.
    pub sessions: Vec<Session>,
    /// Parameters that `init` must refuse.
    pub refused: Vec<Vec<f64>>,
    /// Conditions that were tested with one outcome only.
    pub untaken: Vec<Untaken>,
}

impl SelfTest {
    /// The self-test of a controller in samples, or of an observer alone, by its program.
    ///
    /// # Errors
    /// That it calls a function of a mathematical library, whose last bits differ.
    pub fn new(spec: &Spec, code: &Code) -> Result<Self, Vec<Diagnostic>> {
        if let Some(function) = library_function(code) {
            let mut found = Diagnostics::default();
            let calls = |e: &Expression| {
                e.any(&|e| matches!(e.node(), Node::Call(own, _) if own.name() == function))
            };
            let of_reference = spec.known_references().flatten().any(calls);
            let (key, what) = match of_reference || !spec.has_model() {
                true => ("reference", "reference"),
                false => ("dynamics", "model"),
            };
            found.push(
                "unsupported",
                key,
                None,
                format!("a self-test in samples compares every bit, and the {what} calls {function}, whose last bits differ by library"),
                "run the emitted step beside `simulate`, or take a clock in time, whose self-test has tolerances",
            );
            found.finish(Some(()))?;
        }
        let mut search = search::Search::new(spec, code);
        search.round();
        search.parameters();
        search.inputs();
        search.commands();
        let search::Search { sessions, refused, taken, sets, tried, .. } = search;
        let left = |branch: &Branch| !taken.has(branch);
        let untaken = code.branches().into_iter().filter(left).map(|branch| Untaken {
            reason: match (branch.function, branch.holds) {
                ("init", false) => {
                    format!("held with each of {sets} sets of parameters that passed the tests before it")
                }
                ("init", true) => format!("held with none of {sets} sets of parameters"),
                (_, false) => format!("never false in {tried} calls"),
                (_, true) => format!("never true in {tried} calls"),
            },
            condition: branch.condition,
        });
        Ok(Self { sessions, refused, untaken: untaken.collect() })
    }
}

/// A function in the code whose result is not that of IEEE 754.
fn library_function(code: &Code) -> Option<&'static str> {
    let mut found = None;
    code.visit(&mut |e| match e {
        Expr::Call(Function::Sqrt | Function::Abs | Function::Sign, _) => {}
        Expr::Call(function, _) => found = found.or(Some(function.name())),
        Expr::Pow(..) => found = found.or(Some("pow")),
        _ => {}
    });
    found
}
