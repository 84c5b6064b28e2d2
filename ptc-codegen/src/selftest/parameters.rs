//! Values for the parameters that are left to run time, within their domains and bounds.

use crate::controller::Controller;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::program::number::{round, settle};
use crate::program::range::{Range, rounded};
use crate::request::Spec;

/// Values of every parameter, fixed or chosen.
pub(super) struct Chosen<'a> {
    spec: &'a Spec,
    /// Every parameter, and those left to run time in the order of the emitted struct.
    all: Vec<Parameter>,
    run_time: Vec<Parameter>,
    /// The greatest a with which the design holds, beyond which `init` refuses.
    greatest: Option<(Parameter, f64)>,
}

impl<'a> Chosen<'a> {
    pub(super) fn new(controller: &Controller<'a>) -> Self {
        let spec = controller.spec();
        let bound = controller.report.greatest.as_ref();
        let greatest = bound.and_then(|(parameter, bound)| {
            Some((*parameter, round(bound.number()?, spec.precision)))
        });
        let (all, run_time) = (spec.parameters(), spec.run_time_parameters().collect());
        Self { spec, all, run_time, greatest }
    }

    /// The parameters left to run time, in the order of the emitted struct.
    pub(super) fn at_run_time(&self) -> &[Parameter] {
        &self.run_time
    }

    /// The place of a parameter in the emitted struct, where it is left to run time.
    pub(super) fn place(&self, wanted: Parameter) -> Option<usize> {
        self.run_time.iter().position(|parameter| *parameter == wanted)
    }

    /// The greatest value that a check allows a parameter.
    pub(super) fn greatest(&self, parameter: Parameter) -> Option<f64> {
        self.greatest.filter(|(own, _)| *own == parameter).map(|(_, bound)| bound)
    }

    /// The value that is fixed.
    pub(super) fn fixed(&self, parameter: Parameter) -> Option<f64> {
        self.spec.fixed.get(&parameter).map(|fixed| rounded(fixed, self.spec.precision))
    }

    /// The bounds that the user gave.
    pub(super) fn bounds(&self, parameter: Parameter) -> Option<(f64, f64)> {
        let (least, greatest) = self.spec.bounds.get(&parameter)?;
        let number = |fixed: &Fixed, infinite| {
            fixed.number().map_or(infinite, |value| round(value, self.spec.precision))
        };
        Some((number(least, f64::NEG_INFINITY), number(greatest, f64::INFINITY)))
    }

    /// `wanted` in the precision, as near as the domain of the parameter lets it be.
    pub(super) fn legal(&self, parameter: Parameter, wanted: f64) -> f64 {
        let wanted = in_order(self.spec, parameter, wanted);
        let mut value = settle(wanted, self.spec.precision);
        if let Some((least, greatest)) = self.bounds(parameter).or(self.spec.ends(parameter)) {
            value = value.max(least).min(greatest);
        }
        self.greatest(parameter).map_or(value, |bound| value.min(bound))
    }

    /// Returns the value for an undisturbed run; eps as a part of tau.
    fn usual(&self, parameter: Parameter, eps: f64) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let number = |i: usize| i as f64;
        let n = self.spec.n;
        match parameter {
            Parameter::Tau => 2.0,
            // The sum with tau has to be rounded, so that what is left out of it matters.
            Parameter::StartTime => 0.3,
            Parameter::Eps => eps * self.value(Parameter::Tau, eps),
            Parameter::UMax => f64::INFINITY,
            Parameter::UMin => f64::NEG_INFINITY,
            Parameter::A => 0.75,
            Parameter::M => 1.5,
            Parameter::Start => 0.25,
            Parameter::Samples => 1000.0,
            Parameter::SampleTime => 1e-3,
            Parameter::Deadbeat => 0.0,
            Parameter::Rate(i) => 0.375 * number(i) + 0.125,
            // Those of the poles -1.5, ..., -1.5: k_i = C(n, i-1) 1.5^(n+1-i).
            Parameter::Gain(i) => (1..i)
                .fold(1.5f64.powi(i32::try_from(n).unwrap_or(1)), |k, j| {
                    k * number(n + 1 - j) / (number(j) * 1.5)
                }),
            Parameter::Named(_) => {
                let index = self.all.iter().position(|p| *p == parameter).unwrap_or(0);
                0.5 + 0.125 * number(index)
            }
        }
    }

    /// The value of any parameter in an undisturbed run.
    pub(super) fn value(&self, parameter: Parameter, eps: f64) -> f64 {
        self.fixed(parameter).unwrap_or_else(|| self.legal(parameter, self.usual(parameter, eps)))
    }

    /// All run-time parameters in an undisturbed run, in the order of the emitted struct.
    pub(super) fn run_time(&self, eps: f64) -> Vec<f64> {
        self.run_time.iter().map(|p| self.value(*p, eps)).collect()
    }

    /// eps as a part of tau with which time-to-go is tracked all the way.
    pub(super) fn least_eps(&self) -> f64 {
        match self.spec.precision {
            Precision::F64 => 1e-13,
            Precision::F32 => 1e-7,
        }
    }
}

/// `wanted` for a limit of u, or, where the other limit is fixed and on the wrong side, a value beside it.
pub(super) fn in_order(spec: &Spec, parameter: Parameter, wanted: f64) -> f64 {
    if !spec.u_min {
        return wanted;
    }
    let Range { least, most } = Range::fixed(spec, 0);
    match parameter {
        Parameter::UMax if wanted <= least => least + least.abs() + 1.0,
        Parameter::UMin if wanted >= most => most - most.abs() - 1.0,
        _ => wanted,
    }
}
