//! Values that fill the templates of an FMU.

use askama::Template;

use super::super::c::Condition;
use super::super::outline::Outline;
use super::signals::Signals;
use super::units::Unit;
use super::variables::Variable;
use crate::request::Spec;

/// The start value of a run-time parameter.
pub(super) struct Start {
    pub(super) place: String,
    pub(super) value: String,
}

/// An input or a parameter by its value reference.
pub(super) struct Kept {
    pub(super) reference: usize,
    pub(super) place: String,
}

/// A fixed parameter by its value reference.
pub(super) struct Constant {
    pub(super) reference: usize,
    pub(super) literal: String,
}

/// A condition on a parameter, and the message if it is not met.
pub(super) struct Judged {
    pub(super) name: String,
    pub(super) place: String,
    pub(super) test: String,
    pub(super) legal: String,
}

impl Judged {
    pub(super) fn of(condition: &Condition, variables: &[Variable], spec: &Spec) -> Option<Self> {
        let Condition { test, parameter, legal } = condition;
        let place = format!("params.{parameter}");
        let variable = variables.iter().find(|v| v.place.as_ref() == Some(&place))?;
        let about = variable.parameter?;
        Some(Self {
            name: variable.name.clone(),
            place,
            test: test.clone(),
            legal: format!("{} [{}], {legal}", spec.meaning(about), spec.unit(about)),
        })
    }
}

#[derive(Template)]
#[template(path = "fmu/core.c.txt", escape = "none")]
pub(super) struct Core<'a> {
    pub(super) name: &'a str,
    pub(super) signals: &'a Signals,
    pub(super) version: u8,
    /// `s` or `S`, as the interface spells `GetFMUstate`.
    pub(super) state_letter: char,
    pub(super) logger: &'static str,
    pub(super) token: &'a str,
    /// The start time, as an expression.
    pub(super) start: String,
    pub(super) time_to_go: &'static str,
    pub(super) starts: Vec<Start>,
    pub(super) conditions: Vec<Judged>,
    pub(super) kept: Vec<Kept>,
    /// The inputs that are 0 or 1.
    pub(super) switches: Vec<Kept>,
    pub(super) constants: Vec<Constant>,
    pub(super) start_reference: Option<usize>,
    /// Value reference of the number of samples, or its value where it is fixed.
    pub(super) samples_reference: Option<usize>,
    pub(super) samples_fixed: Option<(usize, String)>,
    pub(super) samples: Option<Samples>,
    /// True if the last estimate is that of the disturbance.
    pub(super) disturbance: bool,
    /// True if the inputs follow from the laws of the outputs by a matrix of the plant.
    pub(super) decouples: bool,
    pub(super) frame: &'a Outline,
}

/// A clock in samples: N and the period, as expressions.
pub(super) struct Samples {
    pub(super) count: String,
    pub(super) period: String,
    /// Values that an observer estimates, that of the disturbance last.
    pub(super) estimates: usize,
}

#[derive(Template)]
#[template(path = "fmu/fmi2.c.txt", escape = "none")]
pub(super) struct Fmi2<'a> {
    pub(super) name: &'a str,
    pub(super) core: &'a str,
    pub(super) single: bool,
    /// Instructions for the importer at each communication point.
    pub(super) usage: &'a str,
    pub(super) frame: &'a Outline,
}

#[derive(Template)]
#[template(path = "fmu/fmi3.c.txt", escape = "none")]
pub(super) struct Fmi3<'a> {
    pub(super) name: &'a str,
    pub(super) core: &'a str,
    pub(super) single: bool,
    /// Instructions for the importer at each communication point.
    pub(super) usage: &'a str,
}

/// Contents of modelDescription.xml.
pub(super) struct Model<'a> {
    pub(super) name: &'a str,
    pub(super) token: &'a str,
    pub(super) description: String,
    /// Version of the generator.
    pub(super) version: &'static str,
    pub(super) units: Vec<Unit>,
    pub(super) start_time: f64,
    pub(super) stop_time: f64,
    pub(super) period: f64,
    pub(super) variable_step: bool,
    /// The sample period of a clock in samples, where it is fixed.
    pub(super) fixed_step: Option<f64>,
    pub(super) variables: &'a [Variable],
    pub(super) outputs: Vec<&'a Variable>,
}

#[derive(Template)]
#[template(path = "fmu/modelDescription2.xml", escape = "html")]
pub(super) struct Model2<'a> {
    pub(super) model: &'a Model<'a>,
}

#[derive(Template)]
#[template(path = "fmu/modelDescription3.xml", escape = "html")]
pub(super) struct Model3<'a> {
    pub(super) model: &'a Model<'a>,
}

#[derive(Template)]
#[template(path = "fmu/buildDescription.xml", escape = "html")]
pub(super) struct Build<'a> {
    pub(super) name: &'a str,
}
