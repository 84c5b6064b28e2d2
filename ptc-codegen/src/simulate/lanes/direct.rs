//! The plant with the emitted program in lanes.

use super::along::{Abreast, Kinks};
use super::flow::{Tick, Which};
use super::{At, LaneSide};
use crate::program::kink::Kink;
use crate::program::lanes::Pack;
use crate::program::{Limits, Program, Value};
use crate::simulate::{Control, Controller, Failure, Values};

/// The same loop as [`Direct`](crate::simulate::Direct), where u stays within its bound.
#[derive(Clone, Debug)]
pub struct DirectLanes {
    /// Controller whose `init` performs the checks.
    controller: Controller,
    step: Value,
    limits: Limits,
    law: Abreast,
    motion: Abreast,
    /// x_n'.
    rate: Value,
    kinks: [Kinks; 2],
    x: Vec<Pack>,
}

impl DirectLanes {
    /// The programs of the controller and of the plant, each with its kinks; `None` where they do not
    /// run in lanes.
    pub fn of(
        controller: &Controller,
        (law, of_law): (&Program, &[Kink]),
        (motion, of_motion): (&Program, &[Kink]),
    ) -> Option<Self> {
        let (n, rate) = (motion.watched.len(), *motion.watched.last()?);
        let limits = law.limits;
        let outputs: Vec<_> = [law.step].into_iter().chain(limits.of_u()).collect();
        Some(Self {
            controller: controller.clone(),
            step: law.step,
            limits,
            law: Abreast::new(law, &outputs, n)?,
            motion: Abreast::new(motion, &[rate], n)?,
            rate,
            kinks: [Kinks::of(law, of_law.to_vec())?, Kinks::of(motion, of_motion.to_vec())?],
            x: vec![Pack::all(0.0); n],
        })
    }

    fn of_plant(&mut self) -> [&mut Abreast; 2] {
        [&mut self.motion, &mut self.kinks[1].along]
    }

    fn of_controller(&mut self) -> [&mut Abreast; 2] {
        [&mut self.law, &mut self.kinks[0].along]
    }
}

impl LaneSide for DirectLanes {
    fn order(&self) -> usize {
        self.x.len()
    }

    /// x_i goes like T^(p - i).
    fn slant(&self) -> f64 {
        1.0
    }

    fn start(&mut self, lane: usize, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.controller.init(values, x0)?;
        self.of_controller().into_iter().try_for_each(|one| one.start(lane, values, x0))?;
        self.of_plant().into_iter().try_for_each(|one| one.start(lane, values, x0))
    }

    fn give(&mut self, lane: usize, values: &Values) -> Result<(), Failure> {
        self.of_plant().into_iter().try_for_each(|one| one.give(lane, values))
    }

    fn settle(&mut self) {
        self.of_controller().into_iter().for_each(Abreast::settle);
        self.of_plant().into_iter().for_each(Abreast::settle);
    }

    fn kinks_between(&mut self, from: &At, to: &At) -> Which {
        let [law, motion] = &mut self.kinks;
        let [law, motion] = [law, motion].map(|kinks| kinks.between(&from.t, &to.t));
        std::array::from_fn(|lane| law[lane] || motion[lane])
    }

    fn is_in_time(&self) -> bool {
        true
    }

    fn begin(&mut self, _: &At, x0: &[Pack]) -> Vec<Pack> {
        x0.to_vec()
    }

    fn last(&mut self, at: &At, state: &[Pack], tick: Tick) -> [Pack; 2] {
        self.law.go(tick, &at.t, state);
        let u = std::slice::from_ref(self.law.lanes.get(self.step));
        self.motion.inputs(state.len(), u);
        self.motion.go(tick, &at.t, state);
        let own = self.motion.lanes.get(self.rate);
        let rate = Pack::of(|lane| at.time_to_go.0[lane] * own.0[lane]);
        [at.time_to_go, rate]
    }

    fn tell(&mut self, at: &At, state: &[Pack]) -> (&[Pack], &Pack) {
        self.law.at(&at.t, state);
        self.x.copy_from_slice(state);
        (&self.x, self.law.lanes.get(self.step))
    }

    fn bound(&self) -> Option<Pack> {
        self.limits.of_u().next()?;
        let get = |lane: usize| move |limit| self.law.lanes.get(limit).0[lane];
        Some(Pack::of(|lane| self.limits.range(get(lane)).radius()))
    }
}
