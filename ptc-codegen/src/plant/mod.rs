//! The plant that a controller is simulated with: x1' = x2, ..., xn' = f(x, u, t) + g(x, t) u.
//!
//! ```toml
//! [plant]
//! f = "-damping*x2 - gust*sin(3*t)"
//! g = "0.8"
//! damping = 0.4
//! gust = [0, 0.2]
//! ```
//!
//! f and g are the controller's own unless they are given; a g that differs is an error of the
//! gain, and what f is beside the controller's own is not cancelled. Every other name is a symbol of the plant: a number, or bounds within which it is not known.
//!
//! With a model the plant is the model, of which `[plant]` may give other rates under `dynamics`, and
//! other numbers for its parameters; of a mechanical one another `inertia` and `bias`. A robot may have another
//! `payload`, `rotor`, `damping`, `friction` and `friction_width`.
//!
//! A plant with other states than the law names them under `states`, with their rates and the outputs that the law is
//! given, or is the chain with one `resonance`.
//!
//! Of several axes f and g are those of each, or `dynamics` gives the rates of `x{i}_{j}`, state i of axis j,
//! with the inputs `u{j}`.

mod axes;
mod force;
mod larger;
mod model;
mod read;
mod resonance;
mod spring;

use std::collections::{BTreeMap, BTreeSet};

pub use axes::as_one;
#[cfg(feature = "lab")]
pub(crate) use force::{Bounded, force};
pub use read::{read, read_partly};

use crate::collect::{listed, set};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Expression, Variable};
use crate::linear::Side;
use crate::model::{Arm, Inverse};
use crate::parameter::{Fixed, Name, Parameter};
use crate::request::{self, Entry, LargerPlant, Spec};

/// The table of a design file that holds the plant.
pub const TABLE: &str = "plant";

/// Reads a design: its controller, which knows what the plant is bounded by, and the plant, if it has one.
///
/// # Errors
/// Every mistake in the controller, else every mistake in the table `[plant]`.
pub fn read_design(entries: &[Entry]) -> Result<(Spec, Option<Plant>), Vec<Diagnostic>> {
    with_plant(entries, request::read(entries)?)
}

/// The same of a controller that runs: see [`request::read_run`].
///
/// # Errors
/// As [`read_design`].
#[cfg(feature = "simulate")]
pub fn read_run(entries: &[Entry]) -> Result<(Spec, Option<Plant>), Vec<Diagnostic>> {
    with_plant(entries, request::read_run(entries)?)
}

fn with_plant(entries: &[Entry], mut spec: Spec) -> Result<(Spec, Option<Plant>), Vec<Diagnostic>> {
    let plant = read(entries, &spec)?;
    promised(&mut spec, plant.as_ref(), entries)?;
    Ok((spec, plant))
}

/// Gives a spec what the table `[plant]` promises of its loop.
///
/// # Errors
/// An input gain that is said twice.
pub(crate) fn promised(
    spec: &mut Spec,
    plant: Option<&Plant>,
    entries: &[Entry],
) -> Result<(), Vec<Diagnostic>> {
    if let (false, Some(g)) =
        (spec.promises.g_error.is_empty(), plant.and_then(|plant| plant.g.as_ref()))
    {
        let place = entries.iter().find(|entry| entry.key == "g_error");
        let mut found = Diagnostics::default();
        found.push(
            "conflict",
            "g_error",
            place.map(|entry| entry.value.place),
            format!("`g_error` and g = {g} of the plant both say what the true input gain is"),
            "leave one of them out; under [plant] an uncertain g is g = \"b\", b = [0.9, 1.1]",
        );
        return found.finish(None);
    }
    spec.promises.plant = plant.map(|plant| plant.bounds(spec, entries));
    spec.promises.resonance = plant.and_then(Plant::promised_resonance);
    Ok(())
}

/// Equations of a plant: f and g for a chain of integrators, `dynamics` for a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plant {
    /// f(x, u, t), in units of xn per s.
    pub f: Expression,
    /// The true g(x, t); none for the controller's own.
    pub g: Option<Expression>,
    /// The rate of each state of a model, in place of f and g; empty for a chain.
    pub dynamics: Vec<Expression>,
    /// The equations of motion of a mechanical plant, in place of `dynamics`.
    pub mechanics: Option<Mechanics>,
    /// The states that `dynamics` is of, where they are not those of the law.
    pub larger: Option<LargerPlant>,
    /// The side that is measured of a plant with a resonance.
    pub resonance: Option<Side>,
    /// Symbols with a value.
    pub fixed: BTreeMap<Parameter, Fixed>,
    /// Symbols that are uncertain, with least and greatest value.
    pub bounds: BTreeMap<Parameter, (Fixed, Fixed)>,
}

/// M q'' + bias = u.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mechanics {
    /// Inertia and bias as expressions.
    Equations(Equations),
    /// Rigid bodies of a robot.
    Robot(Box<Arm>),
}

/// The equations of motion as expressions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equations {
    /// M.
    pub inertia: Vec<Vec<Expression>>,
    /// Inputs that hold q'' = 0.
    pub bias: Vec<Expression>,
}

impl Mechanics {
    /// The equations, where they are expressions.
    pub fn equations(&self) -> Option<&Equations> {
        match self {
            Self::Equations(equations) => Some(equations),
            Self::Robot(_) => None,
        }
    }
}

impl Equations {
    /// M, row by row, and the bias.
    pub fn expressions(&self) -> impl Iterator<Item = &Expression> {
        listed(self.inertia.iter().flatten().chain(&self.bias))
    }
}

impl Default for Plant {
    fn default() -> Self {
        let (fixed, bounds) = (BTreeMap::new(), BTreeMap::new());
        let f = Expression::integer(0);
        Self {
            f,
            g: None,
            dynamics: Vec::new(),
            mechanics: None,
            larger: None,
            resonance: None,
            fixed,
            bounds,
        }
    }
}

impl Plant {
    /// The plant that the controller of `spec` is made for.
    pub fn own(spec: &Spec) -> Self {
        if let Some(model) = &spec.model {
            return Self { dynamics: model.dynamics.clone(), ..Self::default() };
        }
        if let Some(coupled) = &spec.coupled {
            let own = match &coupled.inverse {
                Inverse::Adjugate { dynamics, .. } | Inverse::Elimination { dynamics, .. } => {
                    (dynamics.clone(), None)
                }
                Inverse::Inertia { inertia, bias } => {
                    let (inertia, bias) = (inertia.clone(), bias.clone());
                    (Vec::new(), Some(Mechanics::Equations(Equations { inertia, bias })))
                }
                Inverse::Robot(arm) => (Vec::new(), Some(Mechanics::Robot(arm.clone()))),
            };
            return Self { dynamics: own.0, mechanics: own.1, ..Self::default() };
        }
        let f = spec.drift.clone().unwrap_or(Expression::integer(0));
        Self { f, ..Self::default() }
    }

    /// The symbols of the plant that are no parameters of its controller.
    pub fn symbols(&self, spec: &Spec) -> BTreeSet<Parameter> {
        let of_controller = spec.parameters();
        let used = self.expressions().flat_map(Expression::parameters);
        set(used.filter(|parameter| !of_controller.contains(parameter)))
    }

    /// Returns true for a chain of integrators, with f and g.
    pub fn is_chain(&self) -> bool {
        self.dynamics.is_empty() && self.mechanics.is_none()
    }

    /// Returns the expressions that move it, as they were written.
    pub fn expressions(&self) -> impl Iterator<Item = &Expression> {
        listed(self.keyed().map(|(_, expression)| expression))
    }

    /// The same, each with its key.
    pub(crate) fn keyed(&self) -> impl Iterator<Item = (&'static str, &Expression)> {
        let chain = self.is_chain();
        let of_chain = std::iter::once(("plant.f", &self.f));
        let of_chain = of_chain.chain(self.g.iter().map(|g| ("plant.g", g)));
        let dynamics = self.dynamics.iter().map(|rate| ("plant.dynamics", rate));
        let equations = self.mechanics.as_ref().and_then(Mechanics::equations);
        let inertia = equations.into_iter().flat_map(|own| own.inertia.iter().flatten());
        let bias = equations.into_iter().flat_map(|own| &own.bias);
        let mechanics =
            inertia.map(|e| ("plant.inertia", e)).chain(bias.map(|e| ("plant.bias", e)));
        let larger = self.larger.iter().flat_map(|larger| &larger.outputs);
        let outputs = larger.map(|output| ("plant.outputs", output));
        listed(of_chain.filter(move |_| chain).chain(dynamics).chain(mechanics).chain(outputs))
    }

    /// The same with `to` in place of the leaves for which it gives something.
    #[must_use]
    pub fn substitute(&self, to: &dyn Fn(&Expression) -> Option<Expression>) -> Self {
        let all = |e: &Expression| e.substitute(to);
        let each = |list: &Vec<Expression>| list.iter().map(all).collect();
        Self {
            f: all(&self.f),
            g: self.g.as_ref().map(all),
            dynamics: each(&self.dynamics),
            mechanics: self.mechanics.as_ref().map(|mechanics| match mechanics {
                Mechanics::Equations(Equations { inertia, bias }) => {
                    let inertia = inertia.iter().map(each).collect();
                    Mechanics::Equations(Equations { inertia, bias: each(bias) })
                }
                Mechanics::Robot(arm) => Mechanics::Robot(arm.clone()),
            }),
            larger: self.larger.as_ref().map(|larger| LargerPlant {
                outputs: each(&larger.outputs),
                coordinates: each(&larger.coordinates),
                ..larger.clone()
            }),
            ..self.clone()
        }
    }

    /// The rate of each state of a plant that has no mechanics; those of a chain are the next state, and f + g u.
    pub fn rates(&self, spec: &Spec) -> Vec<Expression> {
        if !self.dynamics.is_empty() {
            return self.dynamics.clone();
        }
        let own = || spec.input_gain.clone().unwrap_or(Expression::integer(1));
        let input = self.g.clone().unwrap_or_else(own).mul(Variable::Control.into());
        let next = (2..=spec.n).map(|j| Variable::State(j).into());
        next.chain([self.f.clone().add(input)]).collect()
    }

    /// Prints the equations that move it, a line each.
    pub fn lines(&self, spec: &Spec) -> Vec<String> {
        if let Some(larger) = &self.larger {
            let rates = larger.states.iter().zip(&self.dynamics);
            let rates = rates.map(|(name, rate)| format!("{name}' = {}", larger.text(rate)));
            let law = spec.clone().apart().state_names();
            let outputs = law.into_iter().zip(&larger.outputs);
            let outputs = outputs.map(|(name, output)| (name, larger.text(output)));
            let shown = outputs.filter(|(name, output)| name != output);
            let shown = shown.map(|(name, output)| format!("{name} = {output}"));
            return rates.chain(shown).collect();
        }
        if let Some(model) = &spec.model {
            let rate =
                |(name, rate): (&Name, &Expression)| format!("{name}' = {}", model.text(rate));
            return model.states.iter().zip(&self.dynamics).map(rate).collect();
        }
        if let Some(coupled) = &spec.coupled {
            return match &self.mechanics {
                None => coupled.rates(&self.dynamics),
                Some(Mechanics::Equations(own)) => coupled.motion(&own.inertia, &own.bias),
                Some(Mechanics::Robot(arm)) => arm.lines(),
            };
        }
        let g = self.g.iter().map(|g| format!("g = {g}"));
        std::iter::once(format!("f = {}", self.f)).chain(g).collect()
    }

    /// Returns true if the plant itself gives this symbol a value or bounds.
    pub fn gives(&self, symbol: Parameter) -> bool {
        self.fixed.contains_key(&symbol) || self.bounds.contains_key(&symbol)
    }
}
