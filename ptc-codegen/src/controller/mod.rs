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
use plan::{Field, Phase, Plan, Routine};

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

/// The checks of functions on their results, each in their order: products that keep their digits, then fields that are
/// finite.
#[derive(Debug)]
pub struct Checks {
    /// Those of `init`.
    pub init: Vec<Condition>,
    /// Those of `arm`.
    pub arm: Vec<Condition>,
    /// Those of `arm_for`, where there is one; those of `arm` are among them.
    pub arm_for: Vec<Condition>,
}

impl Checks {
    /// The checks of all functions.
    #[cfg(feature = "files")]
    pub(crate) fn all(&self) -> impl Iterator<Item = &Vec<Condition>> {
        [&self.init, &self.arm, &self.arm_for].into_iter()
    }
}

/// Returns the checks of a controller.
pub fn checked(controller: &Controller<'_>) -> Checks {
    let program = controller.program;
    let plan = Plan::new(controller.spec(), program);
    let finite = |routine| {
        let fields = plan.set_by(routine).filter(|field| is_derived(program, field));
        fields.map(|field| Condition::Finite(field.value)).collect::<Vec<_>>()
    };
    let [init, duration] = digits::checks(controller.spec(), program);
    let arm_for = if program.in_flight { finite(Routine::ArmFor) } else { Vec::new() };
    Checks {
        init: [init, finite(Routine::Init)].concat(),
        arm: finite(Routine::Arm),
        arm_for: [duration, arm_for].concat(),
    }
}

/// Returns true if a field is to be checked: one that is a parameter as it was given has been checked by its domain,
/// the deadline is checked anyway, and the correction of its rounding is finite with it.
pub(crate) fn is_derived(program: &Program, field: &Field) -> bool {
    let value = program.get(field.value);
    let of_time = |name: &str| matches!(name, "deadline" | "correction");
    let is_time =
        field.phase == Phase::Start && value.name.as_ref().is_some_and(|(n, _)| of_time(n));
    let is_given = matches!(value.op, Op::Input(_));
    !is_time && !is_given
}
