//! Inputs that are not finite or before the start, as far as the guard catches them.

use super::maker::{Maker, state};
use super::{Call, Session, Wanted};
use crate::parameter::Parameter;
use crate::program::number::settle;
use crate::reference::Status;
use crate::request::Guard;

/// Values that are not finite numbers.
const WRONG: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

impl Maker<'_> {
    /// Calls with such inputs.
    pub(super) fn wrong_inputs(&mut self, session: &mut Session, tau: f64) {
        let (spec, n) = (self.spec(), self.spec().given());
        let full = spec.guard == Guard::Full;
        let status = match spec.guard {
            Guard::Full => Status::Input,
            Guard::Result => Status::Range,
            Guard::None => return,
        };
        let t = self.time(session, 0.5 * tau);
        let x = self.within(session, t, &state(n, 1.0));
        let all = vec![Wanted::none(status); self.inputs()];
        let Some(beside) = self.beside(session, (t, &x), &all) else { return };
        let early = self.parameter(session, Parameter::StartTime) - 0.5 * tau;
        let early = settle(early, spec.precision);
        let has_axis = self.controller.program.axis.is_some();
        let mut refuse = |t: f64, x: Vec<f64>, inputs: Vec<Wanted>, axis: bool| {
            let axis = (has_axis && axis).then_some(status);
            session.calls.push(Call { t, x, status, inputs, axis });
        };
        // Behind the result alone, an infinite state is clipped, and a tick without time is held, as is that of
        // several axes.
        let times = if spec.joins_axes() && !full { 0 } else { WRONG.len() };
        for t in &WRONG[..times] {
            refuse(*t, x.clone(), all.clone(), full);
        }
        // The definition does not say which of several inputs a state turns into NaN.
        let places = if all.len() > 1 && !full { 0 } else { n };
        for wrong in &WRONG[..if full { WRONG.len() } else { 1 }] {
            for place in (0..places).filter(|place| spec.reads(*place)) {
                let (mut x, mut inputs) = (x.clone(), beside.clone());
                x[place] = *wrong;
                let of_axis = self.axis_of(place).map_or(0..inputs.len(), |axis| axis..axis + 1);
                inputs[of_axis].fill(Wanted::none(status));
                refuse(t, x, inputs, true);
            }
        }
        if full {
            refuse(early, x, all, true);
        }
    }

    /// Returns the expected results of a call with a wrong argument: an axis whose own state is finite has its own
    /// status. `None` where rounding decides it.
    fn beside(
        &self,
        session: &Session,
        (t, x): (f64, &[f64]),
        all: &[Wanted],
    ) -> Option<Vec<Wanted>> {
        if !self.spec().joins_axes() {
            return Some(all.to_vec());
        }
        let call = self.call(session, t, x)?;
        Some(call.inputs.iter().map(|one| Wanted::none(one.status)).collect())
    }

    /// The axis that is given the number at a place, of axes that know nothing of one another.
    fn axis_of(&self, place: usize) -> Option<usize> {
        let spec = self.spec();
        spec.joins_axes().then(|| match place.checked_sub(spec.states()) {
            None => place / spec.n,
            Some(behind) => behind / spec.references(),
        })
    }
}
