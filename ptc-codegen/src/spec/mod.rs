//! What the user asked for. Every front end ends in a [`Spec`].

mod keys;
mod parameter;
mod read;
mod reserved;
mod value;

pub use keys::{KEYS, KeyInfo};
pub use parameter::{Domain, Fixed, Parameter};
pub use read::{Entry, read};
pub use value::{Argument, Node, Value, number, parse};

use std::collections::BTreeMap;

use crate::mapping::{Family, Mapping};

/// Largest order that is generated. The expansions are exact for any order; beyond this one the
/// rounding of the law in double precision (growing with n) leaves the accuracy that is promised.
pub const MAX_ORDER: usize = 16;

/// Largest number of rates of `exp_sum`.
pub const MAX_RATES: usize = 16;

/// Floating-point type of the emitted code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Precision {
    /// IEEE 754 binary32.
    F32,
    /// IEEE 754 binary64.
    F64,
}

/// Which run-time checks of the inputs of `step` are emitted. A result that is not finite is
/// [`PTC_E_RANGE`](crate::emit) under each of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Guard {
    /// Every input and pointer is checked.
    Full,
    /// One test on the result catches non-finite x and t; pointers and t < t0 are trusted.
    Result,
    /// Inputs and pointers are trusted.
    None,
}

/// One controller to generate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spec {
    /// Order n of the chain of integrators, `1..=MAX_ORDER`.
    pub n: usize,
    /// Family of the time mapping.
    pub family: Family,
    /// Number of rates of `exp_sum`; 0 for the other families.
    pub rates: usize,
    /// Name of the controller: prefix of every emitted symbol, stem of the files.
    pub name: Option<String>,
    /// Floating-point type.
    pub precision: Precision,
    /// Run-time checks.
    pub guard: Guard,
    /// Parameters fixed at generation; all others are run-time parameters.
    pub fixed: BTreeMap<Parameter, Fixed>,
}

impl Spec {
    /// The spec of order `n` and `family` with every parameter left to run time.
    pub fn new(n: usize, family: Family) -> Self {
        Self {
            n,
            family,
            rates: if family == Family::ExpSum { 2 } else { 0 },
            name: None,
            precision: Precision::F64,
            guard: Guard::Full,
            fixed: BTreeMap::new(),
        }
    }

    /// Name of the controller: the given one, else `ptc_<family><n>`.
    pub fn name(&self) -> String {
        self.name.clone().unwrap_or_else(|| format!("ptc_{}{}", self.family.name(), self.n))
    }

    /// Name of the controller's type in Rust: `ptc_exp3` -> `PtcExp3`.
    pub fn type_name(&self) -> String {
        type_name(&self.name())
    }

    /// Every parameter of the controller, fixed or not, in the order in which it is emitted.
    pub fn parameters(&self) -> Vec<Parameter> {
        let mut all = vec![Parameter::Tau, Parameter::StartTime, Parameter::Eps, Parameter::UMax];
        match self.family {
            Family::ExpSum => all.extend((1..=self.rates).map(Parameter::Rate)),
            Family::Power => all.extend([Parameter::A, Parameter::M]),
            _ => all.push(Parameter::A),
        }
        all.extend((1..=self.n).map(Parameter::Gain));
        all
    }

    /// The parameters that are left to run time.
    pub fn run_time_parameters(&self) -> impl Iterator<Item = Parameter> {
        self.parameters().into_iter().filter(|p| !self.fixed.contains_key(p))
    }

    /// The time mapping as a differential ring.
    pub fn mapping(&self) -> Mapping {
        self.family.mapping(self.rates)
    }

    /// The command line (without the program's name and `--lang`) that gives this spec.
    pub fn command(&self) -> String {
        let mut words = vec![format!("--n {}", self.n), format!("--mu {}", self.mu())];
        if let Some(name) = &self.name {
            words.push(format!("--name {name}"));
        }
        if self.precision == Precision::F32 {
            words.push("--precision f32".to_owned());
        }
        match self.guard {
            Guard::Full => {}
            Guard::Result => words.push("--guard result".to_owned()),
            Guard::None => words.push("--guard none".to_owned()),
        }
        for (parameter, flag) in [
            (Parameter::Tau, "--tau"),
            (Parameter::StartTime, "--t0"),
            (Parameter::Eps, "--eps"),
            (Parameter::UMax, "--u-max"),
        ] {
            if let Some(value) = self.fixed.get(&parameter) {
                words.push(format!("{flag}={value}"));
            }
        }
        let gains: Vec<_> =
            (1..=self.n).filter_map(|i| self.fixed.get(&Parameter::Gain(i))).collect();
        if !gains.is_empty() {
            let gains: Vec<_> = gains.iter().map(ToString::to_string).collect();
            words.push(format!("--gains={}", gains.join(",")));
        }
        words.join(" ")
    }

    /// The mapping as it is written for `--mu`, quoted for a shell where it must be.
    fn mu(&self) -> String {
        let name = self.family.name();
        let mut arguments = Vec::new();
        for (parameter, key) in [(Parameter::A, "a"), (Parameter::M, "m")] {
            if let Some(value) = self.fixed.get(&parameter) {
                arguments.push(format!("{key}={value}"));
            }
        }
        if self.family == Family::ExpSum {
            let rates: Vec<_> = (1..=self.rates)
                .filter_map(|i| self.fixed.get(&Parameter::Rate(i)))
                .map(ToString::to_string)
                .collect();
            arguments.push(if rates.is_empty() {
                self.rates.to_string()
            } else {
                format!("rates=[{}]", rates.join(","))
            });
        }
        if arguments.is_empty() {
            name.to_owned()
        } else {
            format!("\"{name}({})\"", arguments.join(","))
        }
    }
}

/// The name of the Rust type for a controller's name.
pub fn type_name(name: &str) -> String {
    let capitalised = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase().to_string() + letters.as_str())
    };
    name.split('_').filter_map(capitalised).collect()
}
