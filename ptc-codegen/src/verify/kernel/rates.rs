//! x_n' of the closed loop as a compiled program.

use crate::expression::Expression;
use crate::lower;
use crate::parameter::{Parameter, Precision};
use crate::program::machine::Slot;
use crate::program::{Input, Value, passes};
use crate::request::Spec;
use crate::simulate::{Along, Control, Controller};
use crate::verify::{Campaign, Setting};

/// xn' with the control in it, compiled.
#[derive(Clone, Debug)]
pub(in crate::verify) struct Rates {
    controller: Controller,
    along: Along,
    watched: Vec<Value>,
    disturbances: Vec<Option<Slot>>,
}

impl Rates {
    /// Returns the rates of a campaign; `None` if its law cannot be run.
    pub(in crate::verify) fn new(campaign: &Campaign) -> Option<Self> {
        let spec = Spec { precision: Precision::F64, ..campaign.spec.clone() };
        let plant = &campaign.plant;
        spec.sampled().is_none().then_some(())?;
        let own = || spec.input_gain.clone().unwrap_or(Expression::integer(1));
        let g = plant.g.clone().unwrap_or_else(own);
        let program = lower::observed(&spec, &[&plant.f, &g]);
        let program = passes::optimise(program, &mut |_, _| {});
        let along = Along::new(&program, &program.watched, spec.n);
        let of = |(symbol, ..): &(Parameter, _, _)| along.machine.slot(Input::Parameter(*symbol));
        Some(Self {
            controller: Controller::new(&spec).ok()?,
            disturbances: campaign.disturbances.iter().map(of).collect(),
            watched: program.watched,
            along,
        })
    }

    pub(super) fn start(&mut self, setting: &Setting) -> Option<()> {
        self.controller.init(&setting.values, &setting.x0).ok()?;
        self.along.start(&setting.x0);
        // The disturbances have no value in a setting: they are given by `disturb`.
        let mut values = setting.values.clone();
        for (input, _) in self.along.machine.inputs().collect::<Vec<_>>() {
            if let Input::Parameter(symbol) = input
                && values.get(symbol).is_nan()
            {
                values.set(symbol, 0.0);
            }
        }
        values.give(&mut self.along.machine).ok()
    }

    pub(super) fn disturb(&mut self, levels: &[f64]) {
        for (slot, level) in self.disturbances.iter().zip(levels) {
            self.along.machine.set(*slot, *level);
        }
        self.along.settle();
    }

    pub(super) fn control(&mut self, t: f64, x: &[f64]) -> f64 {
        self.controller.step(t, x).0[0]
    }

    /// xn' at a time t, of which `time_to_go` is left.
    pub(super) fn last(&mut self, (t, time_to_go): (f64, f64), x: &[f64]) -> f64 {
        let u = self.control(t, x);
        self.along.at(time_to_go, x, &[u]);
        let [f, g] = [0, 1].map(|place| self.along.machine.get(self.watched[place]));
        f + g * u
    }
}
