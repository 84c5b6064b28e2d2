//! Controllers in time in lanes, by their program: what time alone decides is kept for the runs that share it.

use std::slice::from_ref;

use super::{Abreast, Now, Ticks};
use crate::program::lanes::Pack;
use crate::program::{Limits, Value};
use crate::request::After;
use crate::simulate::{Controller, Failure, Values};

/// The program of a controller in time in lanes.
#[derive(Clone, Debug)]
pub(in crate::simulate::lanes) struct OfProgram {
    law: Abreast,
    /// `None` where a tick is computed anew at each sample.
    ticks: Option<Ticks>,
    step: Value,
    limits: Limits,
    after: After,
    u: Pack,
}

impl OfProgram {
    /// `None` for several inputs, and where it does not run in lanes.
    pub(super) fn of(controller: &Controller) -> Option<Self> {
        let spec = controller.spec();
        let several = spec.axes.is_some() || spec.coupled.is_some();
        let (_, deadline) = controller.handles();
        let program = controller.program().filter(|_| !several && deadline.is_none())?;
        let limits = program.limits;
        let outputs = [Some(program.step), limits.past].into_iter().flatten().chain(limits.of_u());
        let outputs: Vec<_> = outputs.collect();
        let law = Abreast::new(program, &outputs, spec.states())?;
        let ticks = Ticks::of(&law, &outputs);
        Some(Self { ticks, law, step: program.step, limits, after: spec.after, u: Pack::all(0.0) })
    }

    pub(super) fn start(
        &mut self,
        lane: usize,
        values: &Values,
        x0: &[f64],
    ) -> Result<(), Failure> {
        self.law.start(lane, values, x0)
    }

    pub(super) fn begin(&mut self) {
        self.law.settle();
        self.ticks.iter_mut().for_each(|ticks| ticks.begin(&self.law));
    }

    pub(super) fn step(&mut self, now: &Now<'_>) -> &[Pack] {
        match &mut self.ticks {
            Some(ticks) => ticks.at(now.index as usize, &mut self.law, now.t),
            None => self.law.tick(now.t),
        }
        self.law.again(now.measured);
        self.u = self.given();
        from_ref(&self.u)
    }

    /// u of `step`.
    fn given(&self) -> Pack {
        let get = |value| self.law.lanes.get(value);
        let mut wanted = *get(self.step);
        if let Some(past) = self.limits.past.filter(|_| self.after != After::Hold) {
            let past = get(past);
            wanted = Pack::of(|lane| if past.0[lane] >= 0.0 { 0.0 } else { wanted.0[lane] });
        }
        if self.limits.of_u().next().is_none() {
            return wanted;
        }
        Pack::of(|lane| self.limits.range(|limit| get(limit).0[lane]).clip(wanted.0[lane]).0)
    }
}
