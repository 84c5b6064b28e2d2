//! The user's request. Every front end ends in a [`Spec`].

mod axes;
mod command;
mod legal;
mod needs;
mod plant;
mod poles;
mod promises;
mod read;
mod sampled;
mod units;

pub use axes::Axes;
pub use poles::{Pole, PoleError, gains};
pub(crate) use promises::exact_one_or_each;
pub use promises::{PlantBounds, Promises, one_or_each};
pub(crate) use read::derivatives;
pub use read::{Entry, read};
pub(crate) use read::{items, known};
pub use sampled::{Exact, Observer, Sampled};

use std::collections::BTreeMap;

use crate::algebra::BigRational;
use crate::collect::set;
use crate::expression::{Expression, Variable};
use crate::family::Family;
use crate::mapping::{Custom, Mapping, TimeMapping};
use crate::model::{Coupled, Model};
use crate::parameter::{Fixed, Parameter, Precision, type_name};

/// Largest order that is generated. The expansions are exact for any order; beyond this one the
/// rounding of the law in double precision (growing with n) leaves the accuracy that is promised.
pub const MAX_ORDER: usize = 16;

/// Largest number of rates of `exp_sum`.
pub const MAX_RATES: usize = 16;

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

/// The law pi0(xi, t) of the infinite-time system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Feedback {
    /// pi0 = -(k_1 xi_1 + ... + k_n xi_n).
    Linear,
    /// An expression.
    Expression(Expression),
    /// A function of the user's program.
    Extern,
}

/// What follows the deadline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum After {
    /// The gains stay as they are at time-to-go eps.
    Hold,
    /// u = 0.
    Zero,
    /// A law of the user's program.
    Extern,
}

/// What is generated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum What {
    /// The controller.
    Controller,
    /// The right-hand side of the associated infinite-time system, on which pi0 is designed.
    Associated,
    /// The observer in samples alone, for a user-defined law.
    Observer,
}

/// What `x_1` follows in place of 0: the law sees the tracking error `e_i = x_i - r^(i-1)(t)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reference {
    /// r(t) and its derivatives up to that of order n.
    Known(Vec<Expression>),
    /// Each call is given them.
    Input,
}

impl Reference {
    /// Whether it changes with time, as far as is known.
    pub fn moves(&self) -> bool {
        match self {
            Self::Known(derivatives) => {
                derivatives[1..].iter().any(|e| *e != Expression::integer(0))
            }
            Self::Input => true,
        }
    }
}

/// What a call of the controller is given beside the state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Clock {
    /// Time t.
    Time,
    /// The number of the sample.
    Samples(Box<Sampled>),
}

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
    /// What is generated.
    pub what: What,
    /// What a call is given beside the state.
    pub clock: Clock,
    /// Floating-point type.
    pub precision: Precision,
    /// Whether products and sums are fused: one rounding for both.
    pub fma: bool,
    /// Whether polynomials are evaluated as trees: shorter chains of operations, a few more of them.
    pub latency: bool,
    /// Run-time checks.
    pub guard: Guard,
    /// The law of the infinite-time system.
    pub feedback: Feedback,
    /// Known part f(x, t) of the plant, which the law cancels; none for 0.
    pub drift: Option<Expression>,
    /// Input gain g(x, t) of the plant; none for g = 1.
    pub input_gain: Option<Expression>,
    /// What x_1 follows; none for 0.
    pub reference: Option<Reference>,
    /// The axes that share the deadline; none for one chain.
    pub axes: Option<Axes>,
    /// The model of the plant from which n, f and g follow; none where they were given.
    pub model: Option<Box<Model>>,
    /// The plant with several inputs and outputs, each of which is an axis.
    pub coupled: Option<Box<Coupled>>,
    /// What follows the deadline.
    pub after: After,
    /// Parameters fixed at generation; all others are run-time parameters.
    pub fixed: BTreeMap<Parameter, Fixed>,
    /// Bounds of run-time parameters that the user gave, least and greatest value.
    pub bounds: BTreeMap<Parameter, (Fixed, Fixed)>,
    /// The poles from which the gains were computed; empty where gains were given.
    pub poles: Vec<(BigRational, BigRational)>,
    /// What the checks hold the design to.
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
            after: After::Hold,
            fixed: BTreeMap::new(),
            bounds: BTreeMap::new(),
            poles: Vec::new(),
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

    /// Whether stretched time is the root of an equation, found by an iteration.
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

    /// How many values of the reference a call is given: r and its derivatives, or none. Of several
    /// outputs it is given so many for each, as many as the highest order takes.
    pub fn references(&self) -> usize {
        if self.reference != Some(Reference::Input) {
            return 0;
        }
        self.highest_order() + 1
    }

    /// The order of the longest chain: that of the plant, or of an output of several.
    pub fn highest_order(&self) -> usize {
        let orders = self.coupled.iter().flat_map(|coupled| coupled.orders());
        orders.max().unwrap_or(self.n)
    }

    /// The references that are known, each with its derivatives: one, or those of several outputs.
    pub fn known_references(&self) -> impl Iterator<Item = &[Expression]> {
        let own = self.axes.iter().flat_map(|axes| &axes.references).map(Vec::as_slice);
        let one = match &self.reference {
            Some(Reference::Known(all)) if !self.axes.iter().any(|a| !a.references.is_empty()) => {
                Some(all.as_slice())
            }
            _ => None,
        };
        own.chain(one)
    }

    /// How many numbers a call is given beside time: the state, and behind it the reference, or that of each
    /// output.
    pub fn given(&self) -> usize {
        let outputs = self.coupled.as_ref().map_or(1, |coupled| coupled.outputs.len());
        self.states() + outputs * self.references()
    }

    /// Whether a call reads the one of these at `place`: all outputs are given as much of a reference as the
    /// highest order takes.
    pub fn reads(&self, place: usize) -> bool {
        let behind = place.checked_sub(self.states());
        let (Some(coupled), Some(behind)) = (&self.coupled, behind) else { return true };
        let row = self.references();
        coupled.orders().get(behind / row).is_some_and(|order| behind % row <= *order)
    }

    /// The derivative of this order, from 0, of the reference; none where it is not known or 0.
    pub fn derivative(&self, order: usize) -> Option<&Expression> {
        match &self.reference {
            Some(Reference::Known(all)) => all.get(order).filter(|e| **e != Expression::integer(0)),
            Some(Reference::Input) | None => None,
        }
    }

    /// The expressions for pi0: one, or one for each output of a plant with several.
    pub fn laws(&self) -> impl Iterator<Item = &Expression> {
        let one = match (&self.feedback, &self.axes) {
            (Feedback::Expression(law), None) => Some(law),
            _ => None,
        };
        one.into_iter().chain(self.axes.iter().flat_map(|axes| &axes.laws))
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
        given.into_iter().chain(law).chain(of_plant).chain(of_axes).chain(coupled).chain(reference)
    }

    /// Whether states are latched at the start.
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
        }
    }

    /// Name of the controller's type in Rust: `ptc_exp3` -> `PtcExp3`.
    pub fn type_name(&self) -> String {
        type_name(&self.name())
    }

    /// Every parameter of the controller, fixed or not, in the order in which it is emitted.
    pub fn parameters(&self) -> Vec<Parameter> {
        if let Clock::Samples(sampled) = &self.clock {
            return match self.what {
                What::Observer => vec![Parameter::SampleTime, Parameter::A],
                What::Controller | What::Associated => {
                    let named = self.named_parameters();
                    sampled.parameters(self.n).into_iter().chain(named).collect()
                }
            };
        }
        let mut all = vec![Parameter::Tau, Parameter::StartTime];
        if self.what == What::Controller {
            all.extend([Parameter::Eps, Parameter::UMax]);
        }
        all.extend(self.time_mapping.parameters());
        if self.feedback == Feedback::Linear {
            all.extend((1..=self.n).map(Parameter::Gain));
        }
        all.extend(self.named_parameters());
        all
    }

    /// The user's parameters that occur in its expressions.
    fn named_parameters(&self) -> impl Iterator<Item = Parameter> {
        let named = set(self.expressions().flat_map(Expression::parameters));
        named.into_iter().filter(|p| matches!(p, Parameter::Named(_)))
    }

    /// The parameters that are left to run time.
    pub fn run_time_parameters(&self) -> impl Iterator<Item = Parameter> {
        self.parameters().into_iter().filter(|p| !self.fixed.contains_key(p))
    }

    /// The time mapping as a differential ring; none for one that the user wrote down.
    pub fn ring(&self) -> Option<Mapping> {
        match self.time_mapping {
            TimeMapping::Family { family, rates } => Some(Mapping::of(family, rates)),
            TimeMapping::Custom(_) => None,
        }
    }
}
