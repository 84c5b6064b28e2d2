//! A controller that is accepted and optimised: what self-tests and back ends start from.

pub(crate) mod code;
pub mod measured;
pub(crate) mod plan;

use crate::check::examine::Report;
use crate::law::Law;
use crate::program::digits::{self, Condition};
use crate::program::{Op, Program};
use crate::request::Spec;
#[cfg(feature = "simulate")]
pub(crate) use code::of_program;
pub use code::whole;
use measured::Measured;
use plan::{Field, Plan};

/// Everything that a back end is given.
#[derive(Clone, Copy, Debug)]
pub struct Controller<'a> {
    /// The spec, and the report of its checks.
    pub report: &'a Report,
    /// The law, for the documentation in the emitted code.
    pub law: &'a Law,
    /// The optimised program.
    pub program: &'a Program,
    /// Measured costs of a step, for the head of the emitted files.
    pub measured: &'a [Measured],
}

impl<'a> Controller<'a> {
    /// The spec.
    pub fn spec(&self) -> &'a Spec {
        &self.report.spec
    }
}

/// Returns the checks of `init`, and then of `arm`, on their results, in the order of the checks: products that keep
/// their digits, then fields that are finite.
pub fn checked(controller: &Controller<'_>) -> [Vec<Condition>; 2] {
    let program = controller.program;
    let plan = Plan::new(program);
    let finite = |armed: bool| {
        let fields = plan.fields.iter().filter(move |field| field.armed == armed);
        fields.filter(|f| is_derived(program, f)).map(|f| Condition::Finite(f.value))
    };
    let kept = digits::checks(controller.spec(), program);
    [kept.into_iter().chain(finite(false)).collect(), finite(true).collect()]
}

/// Returns true if a field is to be checked: one that is a parameter as it was given has been checked by its domain,
/// the deadline is checked anyway, and the correction of its rounding is finite with it.
pub(crate) fn is_derived(program: &Program, field: &Field) -> bool {
    let value = program.get(field.value);
    let of_time = |name: &str| matches!(name, "deadline" | "correction");
    let is_time = field.armed && value.name.as_ref().is_some_and(|(n, _)| of_time(n));
    let is_given = matches!(value.op, Op::Input(_));
    !is_time && !is_given
}
