//! Controllers to measure, by family, order, precision and guard.

use ptc_codegen::emit::{File, Language};
use ptc_codegen::family::Family;
use ptc_codegen::parameter::{Fixed, Parameter, Precision};
use ptc_codegen::request::{Guard, Spec};
use ptc_codegen::syntax::number;
use serde::{Deserialize, Serialize};

use crate::failure::{Failure, Result};

/// The orders that are measured.
pub(crate) const ORDERS: [usize; 9] = [1, 2, 3, 4, 5, 6, 8, 10, 12];

/// The guards, the leanest first.
pub(crate) const GUARDS: [Guard; 3] = [Guard::None, Guard::Result, Guard::Full];

/// The precisions.
pub(crate) const PRECISIONS: [Precision; 2] = [Precision::F64, Precision::F32];

/// A family, or one of its forms with a parameter fixed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Variant {
    /// Name in tables and symbols.
    pub(crate) name: &'static str,
    pub(crate) family: Family,
    /// A parameter fixed at generation.
    fixed: Option<(Parameter, &'static str)>,
}

const fn plain(name: &'static str, family: Family) -> Variant {
    Variant { name, family, fixed: None }
}

/// Every family but soft, and power with m = 2 fixed as well.
pub(crate) const VARIANTS: [Variant; 8] = [
    plain("exp", Family::Exp),
    plain("rational", Family::Rational),
    plain("power", Family::Power),
    Variant { name: "power_m2", family: Family::Power, fixed: Some((Parameter::M, "2")) },
    plain("tan", Family::Tan),
    plain("tanh", Family::Tanh),
    plain("algebraic", Family::Algebraic),
    plain("exp_sum", Family::ExpSum),
];

/// One controller.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) variant: Variant,
    pub(crate) spec: Spec,
}

impl Case {
    /// Guard `none` has u_max fixed to inf; the others take it at run time.
    pub(crate) fn new(variant: Variant, n: usize, precision: Precision, guard: Guard) -> Self {
        let mut spec = Spec::new(n, variant.family);
        spec.precision = precision;
        spec.guard = guard;
        if guard == Guard::None {
            spec.fixed.insert(Parameter::UMax, Fixed::Infinite);
        }
        if let Some((parameter, text)) = variant.fixed {
            spec.fixed.extend(number(text).map(|value| (parameter, value)));
        }
        spec.name = Some(format!("{}_n{n}_{}", variant.name, guard_name(guard)));
        Self { variant, spec }
    }

    /// Prefix of every symbol.
    pub(crate) fn name(&self) -> String {
        self.spec.name()
    }

    /// The controller's source.
    pub(crate) fn files(&self, language: Language) -> Result<Vec<File>> {
        ptc_codegen::generate(&self.spec, language)
            .map_err(|found| Failure::new(format!("{}: {found:?}", self.name())))
    }

    /// The floating-point type in C.
    pub(crate) fn c_real(&self) -> &'static str {
        if self.spec.precision == Precision::F64 { "double" } else { "float" }
    }

    /// The floating-point type in Rust, which also names the precision.
    pub(crate) fn real(&self) -> &'static str {
        precision_name(self.spec.precision)
    }

    pub(crate) fn key(&self, language: &str) -> Key {
        Key {
            language: language.to_owned(),
            variant: self.variant.name.to_owned(),
            n: self.spec.n,
            precision: self.real().to_owned(),
            guard: guard_name(self.spec.guard).to_owned(),
        }
    }

    /// Values of the run-time parameters for counting, as `(field, elements)`: a deadline 8 s away,
    /// a bound that is not reached, and a
    /// rate at which n = 12 does not overflow in single precision.
    pub(crate) fn parameters(&self) -> Vec<(&'static str, Vec<f64>)> {
        let mut fields: Vec<(&'static str, Vec<f64>)> = Vec::new();
        for parameter in self.spec.run_time_parameters() {
            let value = match parameter {
                Parameter::Tau => 8.0,
                Parameter::StartTime => 0.5,
                Parameter::Eps => 0.001,
                Parameter::UMax => 1e37,
                Parameter::UMin => -1e37,
                Parameter::A => 8.0,
                Parameter::M => 1.5,
                Parameter::Start => 0.25,
                Parameter::Rate(i) => [0.75, 1.75][i % 2],
                Parameter::Named(_) => 1.0,
                Parameter::Samples => 1000.0,
                Parameter::SampleTime => 1e-3,
                Parameter::Deadbeat => 0.0,
                Parameter::Gain(i) => [2.5, 4.75, 1.25, 3.5][i % 4],
            };
            let field = parameter.key();
            match fields.last_mut() {
                Some((last, values)) if *last == field => values.push(value),
                _ => fields.push((field, vec![value])),
            }
        }
        fields
    }

    /// Returns true if `field` is an array in the emitted parameters.
    pub(crate) fn is_array(field: &str) -> bool {
        matches!(field, "k" | "rates")
    }
}

/// Identifies the controller of a measured number.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub(crate) struct Key {
    pub(crate) language: String,
    pub(crate) variant: String,
    pub(crate) n: usize,
    pub(crate) precision: String,
    pub(crate) guard: String,
}

pub(crate) fn guard_name(guard: Guard) -> &'static str {
    match guard {
        Guard::Full => "full",
        Guard::Result => "result",
        Guard::None => "none",
    }
}

pub(crate) fn precision_name(precision: Precision) -> &'static str {
    match precision {
        Precision::F32 => "f32",
        Precision::F64 => "f64",
    }
}
