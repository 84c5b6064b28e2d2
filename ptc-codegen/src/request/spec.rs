//! A whole request: what of it is given, and what follows from it.

use std::collections::BTreeMap;

use super::{After, Axes, Clock, Feedback, Guard, LargerPlant, Promises, Reference, What};
use crate::algebra::BigRational;
use crate::collect::listed;
use crate::expression::{Expression, Variable};
use crate::family::Family;
use crate::mapping::{Custom, Mapping, TimeMapping};
use crate::model::{Coupled, Model};
use crate::parameter::{Fixed, Parameter, Precision, type_name};

/// One controller to generate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spec {
    /// Order n of the chain of integrators, `1..=MAX_ORDER`.
    pub n: usize,
    /// The time mapping.
    pub time_mapping: TimeMapping,
    /// Name of the controller: prefix of every emitted symbol, stem of the files.
    pub name: Option<String>,
    /// Unit of x1, where the design names it.
    pub units: Option<String>,
    /// Program to generate.
    pub what: What,
    /// Clock argument of a call, besides the state.
    pub clock: Clock,
    /// Floating-point type.
    pub precision: Precision,
    /// True if products and sums are fused: one rounding for both.
    pub fma: bool,
    /// True if polynomials are evaluated as trees: shorter chains of operations, a few more of them.
    pub latency: bool,
    /// Run-time checks.
    pub guard: Guard,
    /// The law of the infinite-time system.
    pub feedback: Feedback,
    /// Known part f(x, t) of the plant, which the law cancels; none for 0.
    pub drift: Option<Expression>,
    /// Input gain g(x, t) of the plant; none for g = 1.
    pub input_gain: Option<Expression>,
    /// Reference of x_1; `None` for 0.
    pub reference: Option<Reference>,
    /// The axes that share the deadline; none for one chain.
    pub axes: Option<Axes>,
    /// The model of the plant from which n, f and g follow; none where they were given.
    pub model: Option<Box<Model>>,
    /// The plant with several inputs and outputs, each of which is an axis.
    pub coupled: Option<Box<Coupled>>,
    /// A plant with other states than the law, where the design is seen with it; none for what emits.
    pub larger: Option<Box<LargerPlant>>,
    /// Behaviour after the deadline.
    pub after: After,
    /// Parameters fixed at generation; all others are run-time parameters.
    pub fixed: BTreeMap<Parameter, Fixed>,
    /// Bounds of run-time parameters that the user gave, least and greatest value.
    pub bounds: BTreeMap<Parameter, (Fixed, Fixed)>,
    /// True if tau may change while a controller with a clock in time runs; in samples see [`Flight`](super::Flight).
    pub in_flight: bool,
    /// True if u has a separate lower limit; otherwise it is -u_max.
    pub u_min: bool,
    /// The poles from which the gains were computed; empty where gains were given.
    pub poles: Vec<(BigRational, BigRational)>,
    /// Lists of numbers as they were written, by their keys, and the names of the states of a linear plant.
    pub written: BTreeMap<&'static str, String>,
    /// Promises that the checks examine.
    pub promises: Promises,
    /// The engine that expands a mapping of the user's, where it is not the library's own: the forms
    /// of a family are the same from every engine.
    pub engine: Option<&'static str>,
}

impl Spec {
    /// The spec of order `n` and `family` with every parameter left to run time.
    pub fn new(n: usize, family: Family) -> Self {
        let rates = if family == Family::ExpSum { 2 } else { 0 };
        Self::of(n, TimeMapping::Family { family, rates })
    }

    /// The spec of order `n` and a mapping with every parameter left to run time.
    pub fn of(n: usize, time_mapping: TimeMapping) -> Self {
        Self {
            n,
            time_mapping,
            name: None,
            units: None,
            what: What::Controller,
            clock: Clock::Time,
            precision: Precision::F64,
            fma: false,
            latency: false,
            guard: Guard::Full,
            feedback: Feedback::Linear,
            drift: None,
            input_gain: None,
            reference: None,
            axes: None,
            model: None,
            coupled: None,
            larger: None,
            after: After::Hold,
            fixed: BTreeMap::new(),
            bounds: BTreeMap::new(),
            in_flight: false,
            u_min: false,
            poles: Vec::new(),
            written: BTreeMap::new(),
            promises: Promises::default(),
            engine: None,
        }
    }

    /// The family of the mapping; none for one that the user wrote down.
    pub fn family(&self) -> Option<Family> {
        match self.time_mapping {
            TimeMapping::Family { family, .. } => Some(family),
            TimeMapping::Custom(_) => None,
        }
    }

    /// The mapping that the user wrote down.
    pub fn custom(&self) -> Option<&Custom> {
        match &self.time_mapping {
            TimeMapping::Family { .. } => None,
            TimeMapping::Custom(custom) => Some(custom),
        }
    }

    /// Number of rates of `exp_sum`.
    pub fn rates(&self) -> usize {
        match self.time_mapping {
            TimeMapping::Family { rates, .. } => rates,
            TimeMapping::Custom(_) => 0,
        }
    }

    /// Returns true if stretched time is the root of an equation, found by an iteration.
    pub fn is_iterated(&self) -> bool {
        match &self.time_mapping {
            TimeMapping::Family { family, .. } => family.is_iterated(),
            TimeMapping::Custom(custom) => custom.is_iterated(),
        }
    }

    /// The mapping's name in a few letters.
    pub fn mapping_name(&self) -> &'static str {
        self.family().map_or("custom", Family::name)
    }

    /// The order of the longest chain: that of the plant, or of an output of several.
    pub fn highest_order(&self) -> usize {
        let orders = self.coupled.iter().flat_map(|coupled| coupled.orders());
        orders.max().unwrap_or(self.n)
    }

    /// The expressions for pi0: one, or one for each output of a plant with several.
    pub fn laws(&self) -> impl Iterator<Item = &Expression> {
        let one = match (&self.feedback, &self.axes) {
            (Feedback::Expression(law), None) => Some(law),
            _ => None,
        };
        listed(one.into_iter().chain(self.axes.iter().flat_map(|axes| &axes.laws)))
    }

    /// Every expression that a controller is computed from.
    pub fn expressions(&self) -> impl Iterator<Item = &Expression> {
        let law = self.laws();
        let given = self.custom().map(|custom| &custom.given);
        let model = self.model.iter().flat_map(|model| &model.coordinates);
        let reference = self.known_references().flatten();
        let of_plant = model.chain(&self.drift).chain(&self.input_gain);
        let of_axes = self.axes.iter().flat_map(|axes| &axes.input_gains);
        let coupled = self.coupled.iter().flat_map(|coupled| coupled.expressions());
        listed(
            given
                .into_iter()
                .chain(law)
                .chain(of_plant)
                .chain(of_axes)
                .chain(coupled)
                .chain(reference),
        )
    }

    /// Returns true if states are latched at the start.
    pub fn latches(&self) -> bool {
        self.expressions().any(|e| {
            e.any(&|e| {
                matches!(e.variable(), Some(Variable::StateAtStart(_) | Variable::XiAtStart(_)))
            })
        })
    }

    /// Name of what is generated: for a controller the given one, else `ptc_<family><n>`; with a
    /// suffix for what is generated of the same design beside it.
    pub fn name(&self) -> String {
        let own = format!("ptc_{}{}", self.mapping_name(), self.n);
        let name = self.name.clone().unwrap_or(own);
        match self.what {
            What::Controller => name,
            What::Associated => format!("{name}_associated"),
            What::Observer => format!("{name}_observer"),
            What::Filter => format!("{name}_filter"),
        }
    }

    /// Name of the controller's type in Rust: `ptc_exp3` -> `PtcExp3`.
    pub fn type_name(&self) -> String {
        type_name(&self.name())
    }

    /// The time mapping as a differential ring; none for one that the user wrote down.
    pub fn ring(&self) -> Option<Mapping> {
        match self.time_mapping {
            TimeMapping::Family { family, rates } => Some(Mapping::of(family, rates)),
            TimeMapping::Custom(_) => None,
        }
    }
}
