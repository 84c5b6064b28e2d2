//! x_n' of the closed loop as a compiled program.

use crate::expression::Expression;
use crate::lower;
use crate::parameter::{Parameter, Precision};
use crate::program::machine::{Machine, Slot};
use crate::program::{Input, Stage, Value, passes};
use crate::request::Spec;
use crate::simulate::Controller;
use crate::verify::{Campaign, Setting};

/// xn' with the control in it, compiled.
#[derive(Clone, Debug)]
pub(in crate::verify) struct Rates {
    controller: Controller,
    machine: Machine,
    watched: Vec<Value>,
    time: Option<Slot>,
    state: Vec<Option<Slot>>,
    control: Option<Slot>,
    disturbances: Vec<Option<Slot>>,
}

impl Rates {
    /// Those of a campaign; none where its law cannot be run.
    pub(in crate::verify) fn new(campaign: &Campaign) -> Option<Self> {
        let spec = Spec { precision: Precision::F64, ..campaign.spec.clone() };
        let plant = &campaign.plant;
        let own = || spec.input_gain.clone().unwrap_or(Expression::integer(1));
        let g = plant.g.clone().unwrap_or_else(own);
        let program = lower::observed(&spec, &[&plant.f, &g]);
        let program = passes::optimise(program, &mut |_, _| {});
        let machine = Machine::new(&program, &program.watched);
        let of = |(symbol, ..): &(Parameter, _, _)| machine.slot(Input::Parameter(*symbol));
        Some(Self {
            controller: Controller::new(&spec).ok()?,
            time: machine.slot(Input::Time),
            state: (1..=spec.n).map(|j| machine.slot(Input::State(j))).collect(),
            control: machine.slot(Input::Control),
            disturbances: campaign.disturbances.iter().map(of).collect(),
            watched: program.watched,
            machine,
        })
    }

    pub(super) fn start(&mut self, setting: &Setting) -> Option<()> {
        self.controller.init(&setting.values, &setting.x0).ok()?;
        for (j, x) in (1..).zip(&setting.x0) {
            let slot = self.machine.slot(Input::StateAtStart(j));
            self.machine.set(slot, *x);
        }
        // The disturbances have no value in a setting: they are given by `disturb`.
        let mut values = setting.values.clone();
        for (input, _) in self.machine.inputs().collect::<Vec<_>>() {
            if let Input::Parameter(symbol) = input
                && values.get(symbol).is_nan()
            {
                values.set(symbol, 0.0);
            }
        }
        values.give(&mut self.machine).ok()
    }

    pub(super) fn disturb(&mut self, levels: &[f64]) {
        for (slot, level) in self.disturbances.iter().zip(levels) {
            self.machine.set(*slot, *level);
        }
        self.machine.run(Stage::Init, None);
        self.machine.run(Stage::Arm, None);
    }

    pub(super) fn control(&mut self, t: f64, x: &[f64]) -> f64 {
        self.controller.step(t, x).0
    }

    /// xn' at a time t, of which `time_to_go` is left.
    pub(super) fn last(&mut self, (t, time_to_go): (f64, f64), x: &[f64]) -> f64 {
        let u = self.control(t, x);
        self.machine.set(self.time, time_to_go);
        self.machine.run(Stage::Tick, None);
        for (slot, x) in self.state.iter().zip(x) {
            self.machine.set(*slot, *x);
        }
        self.machine.set(self.control, u);
        self.machine.run(Stage::Step, None);
        let [f, g] = [0, 1].map(|place| self.machine.get(self.watched[place]));
        f + g * u
    }
}
