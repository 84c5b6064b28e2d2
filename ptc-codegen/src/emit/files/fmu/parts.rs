//! Contents of the templates of an FMU, from a design and its code.

use askama::Template as _;

use super::super::apart::apart;
use super::super::c::domain;
use super::super::example::Example;
use super::super::outline::Outline;
use super::super::{File, literal, text_of};
use super::signals::Signals;
use super::template::{
    Constant, Core, Fmi2, Fmi3, Judged, Kept, Model, Model2, Model3, Samples, Start,
};
use super::units::Unit;
use super::variables::{Variable, estimates, variables};
use super::{Version, file};
use crate::code::Code;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::program::number;
use crate::request::Spec;

/// A controller, and the variables of its FMU.
pub(super) struct Parts<'a> {
    spec: &'a Spec,
    program: &'a Code,
    version: Version,
    example: &'a Example,
    name: String,
    signals: Signals,
    variables: Vec<Variable>,
    frame: Outline,
}

impl<'a> Parts<'a> {
    pub(super) fn new(
        spec: &'a Spec,
        program: &'a Code,
        version: Version,
        example: &'a Example,
    ) -> Self {
        let signals = Signals::of(spec);
        Self {
            spec,
            program,
            version,
            example,
            name: spec.name(),
            variables: variables(spec, &signals, example),
            signals,
            frame: Outline::new(spec, program),
        }
    }

    /// modelDescription.xml and the source of the interface.
    pub(super) fn files(&self, token: &str) -> Vec<File> {
        let (name, frame) = (self.name.as_str(), &self.frame);
        let core = &text_of(self.core(token).render());
        let single = self.spec.precision == Precision::F32;
        let usage = &self.signals.usage();
        let model = &self.model(token);
        let (source, xml) = match self.version {
            Version::Two => {
                (Fmi2 { name, core, single, usage, frame }.render(), Model2 { model }.render())
            }
            Version::Three => {
                (Fmi3 { name, core, single, usage }.render(), Model3 { model }.render())
            }
        };
        vec![
            file("modelDescription.xml", xml),
            apart(file(&format!("sources/{name}_fmu.c"), source), name),
        ]
    }

    /// A number in C.
    fn real(&self, value: f64) -> String {
        literal::c(value, self.spec.precision)
    }

    /// The start value of a parameter.
    fn start(&self, parameter: Parameter) -> String {
        let value = self.example.value(parameter);
        match parameter {
            Parameter::Samples => format!("{value}u"),
            _ => self.real(value),
        }
    }

    /// A parameter in the code: what is fixed is a number, and what is not a member of the parameters.
    fn known(&self, parameter: Parameter) -> String {
        match self.spec.fixed.contains_key(&parameter) {
            true => self.start(parameter),
            false => format!("state->params.{}", parameter.key()),
        }
    }

    /// The variables that are numbers, without the number of samples.
    fn numbers(&self) -> impl Iterator<Item = &Variable> {
        self.variables.iter().filter(|v| v.kind2 == "Real")
    }

    /// The inputs that are 0 or 1.
    fn switches(&self) -> Vec<Kept> {
        let inputs = self.variables.iter().filter(|v| v.causality == "input" && v.kind2 != "Real");
        inputs.filter_map(kept).collect()
    }

    /// Returns the parts that both versions of the interface share.
    fn core(&self, token: &'a str) -> Core<'_> {
        let second = self.version == Version::Two;
        let count = self.variables.iter().find(|v| v.parameter == Some(Parameter::Samples));
        let of_start =
            |v: &&Variable| v.parameter == Some(Parameter::StartTime) && v.place.is_some();
        let start_reference = self.variables.iter().find(of_start).map(|v| v.reference);
        let conditions = domain(self.program);
        let judged = |condition| Judged::of(condition, &self.variables, self.spec);
        Core {
            name: &self.name,
            signals: &self.signals,
            version: if second { 2 } else { 3 },
            state_letter: if second { 's' } else { 'S' },
            logger: if second { "CallbackLogger" } else { "LogMessageCallback" },
            token,
            start: match start_reference {
                Some(_) => "state->params.t0".to_owned(),
                None => self.real(self.example.value(Parameter::StartTime)),
            },
            time_to_go: "-((t - state->controller.deadline) - state->controller.correction)",
            starts: self.starts(),
            conditions: conditions.iter().filter_map(judged).collect(),
            kept: self.numbers().filter_map(kept).collect(),
            switches: self.switches(),
            constants: self.constants(),
            start_reference,
            samples_reference: count.filter(|v| v.place.is_some()).map(|v| v.reference),
            samples_fixed: count
                .filter(|v| v.place.is_none())
                .map(|v| (v.reference, self.example.value(Parameter::Samples).to_string())),
            samples: self.spec.sampled().map(|_| Samples {
                count: self.known(Parameter::Samples),
                period: self.known(Parameter::SampleTime),
                estimates: estimates(self.spec).len(),
            }),
            disturbance: self.spec.sampled().is_some_and(|sampled| sampled.disturbance.is_some()),
            decouples: self.spec.rows_of_axes().is_none() && self.spec.coupled.is_some(),
            frame: &self.frame,
        }
    }

    /// The start values of the run-time parameters.
    fn starts(&self) -> Vec<Start> {
        let place = |parameter: Parameter| match parameter.index() {
            Some(index) => format!("{}[{index}]", parameter.key()),
            None => parameter.key().to_owned(),
        };
        let start = |parameter| Start { place: place(parameter), value: self.start(parameter) };
        self.spec.run_time_parameters().map(start).collect()
    }

    /// The parameters that the design fixes.
    fn constants(&self) -> Vec<Constant> {
        let constant = |v: &Variable| {
            let number = self.spec.fixed.get(&v.parameter?).and_then(Fixed::number)?;
            let literal = self.real(number::round(number, self.spec.precision));
            Some(Constant { reference: v.reference, literal })
        };
        self.numbers().filter_map(constant).collect()
    }

    /// Returns the contents of modelDescription.xml.
    fn model(&self, token: &'a str) -> Model<'_> {
        let (spec, example) = (self.spec, self.example);
        let period = example.period;
        let (start_time, length) = match spec.sampled() {
            Some(_) => (0.0, example.value(Parameter::Samples) * period),
            None => (example.value(Parameter::StartTime), example.value(Parameter::Tau)),
        };
        let variable_step = spec.sampled().is_none();
        let is_fixed = !variable_step && spec.fixed.contains_key(&Parameter::SampleTime);
        Model {
            name: &self.name,
            token,
            description: format!(
                "Prescribed-time controller of order {}, mapping {}. Design {}. Made by: ptc-codegen emit --lang {} {}",
                spec.n,
                spec.mapping_name(),
                spec.fingerprint(),
                self.version.target().name,
                spec.command()
            ),
            version: env!("CARGO_PKG_VERSION"),
            units: Unit::all(&self.variables),
            start_time,
            stop_time: start_time + length,
            period,
            variable_step,
            fixed_step: is_fixed.then_some(period),
            variables: &self.variables,
            outputs: super::variables::outputs(&self.variables),
        }
    }
}

/// Returns where an input or a parameter is kept.
fn kept(variable: &Variable) -> Option<Kept> {
    let place = variable.place.clone()?;
    Some(Kept { reference: variable.reference, place })
}
