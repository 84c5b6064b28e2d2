//! A controller that is accepted and optimised: what self-tests and back ends start from.

pub(crate) mod code;
pub mod measured;
pub(crate) mod plan;

use crate::check::examine::Report;
use crate::law::Law;
use crate::program::{Op, Program, Value};
use crate::request::Spec;
use measured::Measured;
use plan::{Field, Plan};

/// Everything that a back end is given.
#[derive(Clone, Copy, Debug)]
pub struct Controller<'a> {
    /// What was asked for, and what the checks say of it.
    pub report: &'a Report,
    /// The law, for the documentation in the emitted code.
    pub law: &'a Law,
    /// The optimised program.
    pub program: &'a Program,
    /// What a step was measured to cost, for the head of the emitted files.
    pub measured: &'a [Measured],
}

impl<'a> Controller<'a> {
    /// What was asked for.
    pub fn spec(&self) -> &'a Spec {
        &self.report.spec
    }
}

/// What `init`, and then `arm`, must find finite: each value in the order of its check, with the
/// name of its field.
pub fn checked_fields(program: &Program) -> [Vec<(Value, String)>; 2] {
    let fields = Plan::new(program).fields;
    let derived = |field: &&Field| is_derived(program, field);
    [false, true].map(|armed| {
        let own = fields.iter().filter(|field| field.armed == armed).filter(derived);
        own.map(|field| (field.value, field.name.clone())).collect()
    })
}

/// Whether a field is to be checked: one that is a parameter as it was given has been checked by
/// its domain, the deadline is checked anyway, and what makes up its rounding is finite with it.
pub(crate) fn is_derived(program: &Program, field: &Field) -> bool {
    let value = program.get(field.value);
    let of_time = |name: &str| matches!(name, "deadline" | "correction");
    let is_time = field.armed && value.name.as_ref().is_some_and(|(n, _)| of_time(n));
    let is_given = matches!(value.op, Op::Input(_));
    !is_time && !is_given
}
