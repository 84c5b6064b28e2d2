//! Changes of the plant of a design for one run: its gain, a constant force, friction, values of uncertain symbols.

use std::collections::BTreeMap;

use ptc_codegen::algebra::BigRational;
use ptc_codegen::expression::{Expression, Function, Variable};
use ptc_codegen::plant::Plant;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{Change, Event, Loop};
use serde_json::{Value, json};

use super::values::uncertain;

/// Changes of the plant, as the page sends them.
pub(super) struct Trial {
    /// Input gain in parts of that of the plant.
    pub(super) gain: f64,
    /// Force on every input from t0 on, in units of u.
    pub(super) force: f64,
    /// Coulomb friction of a chain of two, in units of u.
    pub(super) friction: f64,
    /// Values of uncertain symbols by their names.
    pub(super) symbols: BTreeMap<String, f64>,
}

impl Trial {
    pub(super) fn read(request: &Value) -> Self {
        let number = |key: &str| request[key].as_f64().unwrap_or(0.0);
        let symbols = request["symbols"].as_object().into_iter().flatten();
        let symbols = symbols.filter_map(|(name, value)| Some((name.clone(), value.as_f64()?)));
        Self {
            gain: request["gain"].as_f64().filter(|gain| *gain > 0.0).unwrap_or(1.0),
            force: number("force"),
            friction: number("friction").max(0.0),
            symbols: symbols.collect(),
        }
    }

    /// Describes what can be tried with a design.
    pub(super) fn offered(spec: &Spec, plant: &Plant) -> Value {
        let chain = is_chain(spec, plant);
        let acts = chain || Loop::of(spec).is_some();
        json!({
            "gain": acts,
            "force": acts,
            "friction": chain && spec.n == 2,
            "symbols": uncertain(spec, plant),
        })
    }

    /// The plant of the run. What the sampled loop applies itself is no part of it.
    pub(super) fn plant(&self, spec: &Spec, plant: &Plant) -> Plant {
        let mut plant = plant.clone();
        if !is_chain(spec, &plant) {
            return plant;
        }
        let sampled = Loop::of(spec).is_some();
        let [force, factor] = if sampled { [0.0, 1.0] } else { [self.force, self.gain] };
        let friction = if spec.n == 2 { self.friction } else { 0.0 };
        let [Some(force), Some(factor), Some(friction)] = [force, factor, friction].map(number)
        else {
            return plant;
        };
        let own = plant.g.clone().or_else(|| spec.input_gain.clone());
        let gain = own.unwrap_or(Expression::integer(1));
        if self.force != 0.0 || self.friction != 0.0 {
            let speed = Expression::call(Function::Sign, Variable::State(2).into());
            let acts = force.sub(friction.mul(speed));
            plant.f = plant.f.add(gain.clone().mul(acts));
        }
        if !sampled && self.gain != 1.0 {
            plant.g = Some(factor.mul(gain));
        }
        plant
    }

    /// The force as an event of the sampled loop.
    pub(super) fn event(&self) -> Option<Event> {
        let change = Change::Force { input: None, size: self.force, length: f64::MAX };
        (self.force != 0.0).then_some(Event { at: 0.0, change })
    }

    /// Says what is tried.
    pub(super) fn told(&self, offered: &Value) -> Vec<String> {
        let mut told = Vec::new();
        if self.gain != 1.0 && offered["gain"] == true {
            told.push(format!("{} times the input gain", self.gain));
        }
        if self.force != 0.0 && offered["force"] == true {
            told.push(format!("a force of {}", self.force));
        }
        if self.friction != 0.0 && offered["friction"] == true {
            told.push(format!("friction of {}", self.friction));
        }
        told
    }
}

/// Returns true for a single chain whose plant is f + g u.
fn is_chain(spec: &Spec, plant: &Plant) -> bool {
    let linear = spec.sampled().is_some_and(|sampled| sampled.linear.is_some());
    let other = plant.larger.is_some() || plant.resonance.is_some() || spec.axes.is_some();
    plant.is_chain() && !spec.has_model() && !linear && !other
}

fn number(value: f64) -> Option<Expression> {
    BigRational::from_float(value).map(Expression::from)
}
