//! Outline of the emitted C for the templates around it.

use super::c;
use crate::code::{Code, Expr, Statement, Variable};
use crate::parameter::Precision;
use crate::request::{Feedback, Guard, Spec, What};

/// The types and members of a controller in C.
pub(super) struct Outline {
    pub(super) n: usize,
    /// Number of inputs of the plant, where `step` returns a list of them.
    pub(super) inputs: Option<usize>,
    /// The shape of the state: its length, or rows and their length.
    pub(super) shape: String,
    /// Numbers of the reference that a call is given, of each output; 0 for none.
    pub(super) references: usize,
    pub(super) real: &'static str,
    pub(super) zero: &'static str,
    pub(super) guard: Guard,
    /// True if the state at the start is latched.
    pub(super) latches: bool,
    /// True for the associated system, in place of the controller.
    pub(super) associated: bool,
    /// True if the law is a user-defined function.
    pub(super) extern_law: bool,
    /// True if the gains hold u_max, u_min, and g.
    pub(super) run_time_limit: bool,
    pub(super) run_time_lower: bool,
    pub(super) divides: bool,
    /// The run-time parameters one by one: local name, and place in the parameters.
    pub(super) locals: Vec<Local>,
    pub(super) fields: Vec<Variable>,
    pub(super) gains: Vec<Variable>,
}

/// A local copy of a parameter.
pub(super) struct Local {
    pub(super) name: String,
    pub(super) value: String,
}

impl Outline {
    pub(super) fn new(spec: &Spec, program: &Code) -> Self {
        let copy = |statement: &Statement| match statement {
            Statement::Let(name, _, Expr::Parameter(key)) => {
                Some(Local { name: name.clone(), value: key.clone() })
            }
            Statement::Let(name, _, Expr::ParameterElement(key, index)) => {
                Some(Local { name: name.clone(), value: format!("{key}[{index}]") })
            }
            _ => None,
        };
        Self {
            n: spec.states(),
            shape: match spec.rows_of_axes() {
                Some((count, order)) => format!("[{count}][{order}]"),
                None => format!("[{}]", spec.states()),
            },
            inputs: spec.axes.as_ref().map(|axes| axes.count),
            references: spec.references(),
            real: c::real(spec.precision),
            zero: if spec.precision == Precision::F32 { "0.0f" } else { "0.0" },
            guard: spec.guard,
            latches: spec.latches(),
            associated: spec.what == What::Associated,
            extern_law: spec.feedback == Feedback::Extern,
            run_time_limit: program.gains.iter().any(|field| field.name == "u_max"),
            run_time_lower: program.gains.iter().any(|field| field.name == "u_min"),
            divides: program.gains.iter().any(|field| field.name == "input_gain"),
            locals: program.init.iter().filter_map(copy).collect(),
            fields: program.fields.clone(),
            gains: program.gains.clone(),
        }
    }
}
