//! The calls of a self-test: every status, and time-to-go down to the last digits.

use std::cell::RefCell;
use std::collections::BTreeSet;

use super::maker::{Maker, state};
use super::parameters::Chosen;
use super::{Again, CANDIDATES, Call, Draw, Session, Trials, Unreachable};
use crate::controller::{Controller, checked};
use crate::parameter::Parameter;
use crate::program::digits::Condition;
use crate::program::machine::Machine;
use crate::program::number::settle;
use crate::program::range::Range;
use crate::reference::{Reference, Status};
use crate::request::Guard;

/// Time-to-go as parts of tau, down to what is promised.
const APPROACH: [f64; 10] = [1.0, 0.75, 0.4, 0.1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
/// The sessions of the self-test of a controller.
///
/// With them come the branches of the program that none of the calls takes.
pub(super) fn sessions(
    controller: &Controller<'_>,
    machine: &Machine,
    chosen: &Chosen<'_>,
    trials: &Trials,
) -> (Vec<Session>, Vec<Unreachable>) {
    let mut armed = controller.spec().clone();
    armed.fixed.remove(&Parameter::StartTime);
    let Some(reference) = Reference::within(&armed, trials.work.clone()) else {
        return (Vec::new(), Vec::new());
    };
    let reference = RefCell::new(reference);
    let checked = checked(controller);
    let mut maker =
        Maker { controller, machine, chosen, trials, reference, taken: BTreeSet::new(), checked };
    let mut sessions = vec![maker.approach(), maker.hold(), maker.armed_again()];
    sessions.extend(maker.armed_for());
    sessions.extend(maker.bounded());
    sessions.extend(maker.without_gains());
    sessions.extend(maker.out_of_range());
    sessions.extend(maker.branches());
    sessions.retain(|session| !session.calls.is_empty());
    let never = maker.never(&sessions);
    (sessions, never)
}

impl Maker<'_> {
    /// Tracking from the start to the last digits of time-to-go, and inputs that are refused.
    fn approach(&mut self) -> Session {
        let n = self.spec().given();
        let mut session = self.session(self.chosen.least_eps());
        let [tau, eps] = [Parameter::Tau, Parameter::Eps].map(|p| self.parameter(&session, p));
        for (index, share) in APPROACH.iter().enumerate() {
            let to_go = share * tau;
            if to_go < 2.0 * eps {
                break;
            }
            let t = self.time(&session, to_go);
            let sign = if index % 2 == 0 { 1.0 } else { -1.0 };
            let x = self.within(&session, t, &state(n, sign));
            self.ask(&mut session, t, &x);
        }
        // Each state alone, for its own coefficients.
        for (index, share) in [(0, 0.6), (1, 0.05)].into_iter().chain((2..n).map(|j| (j, 0.3))) {
            let t = self.time(&session, share * tau);
            for j in (0..n).filter(|j| index < 2 || *j == index) {
                let mut unit = vec![0.0; n];
                unit[j] = 1.0;
                let x = self.within(&session, t, &unit);
                self.ask(&mut session, t, &x);
            }
        }
        self.wrong_inputs(&mut session, tau);
        session
    }

    /// Held gains, the deadline, and what follows it.
    fn hold(&mut self) -> Session {
        let n = self.spec().given();
        let mut session = self.session(0.0625);
        let [tau, eps] = [Parameter::Tau, Parameter::Eps].map(|p| self.parameter(&session, p));
        for to_go in [2.0 * eps, 0.5 * eps, 0.0, -0.25 * tau, -10.0 * tau] {
            let t = self.time(&session, to_go);
            for sign in [1.0, -1.0] {
                let x = self.within(&session, t, &state(n, sign));
                self.ask(&mut session, t, &x);
            }
        }
        session
    }

    /// Another start than that of the parameters.
    fn armed_again(&mut self) -> Session {
        let n = self.spec().given();
        let mut session = self.session(0.0625);
        let start = settle(1000.1, self.spec().precision);
        session.again = Some(Again { start, duration: None, arms: true });
        let tau = self.parameter(&session, Parameter::Tau);
        for share in [1.0, 0.3, 0.0] {
            let t = self.time(&session, share * tau);
            let x = self.within(&session, t, &state(n, -1.0));
            self.ask(&mut session, t, &x);
        }
        let t = self.parameter(&self.session(0.0625), Parameter::StartTime);
        if self.spec().guard == Guard::Full && t < 1000.0 {
            let x = state(n, 1.0);
            self.ask(&mut session, t, &x);
        }
        session
    }

    /// Another duration than that of the parameters, which `arm` keeps.
    fn armed_for(&mut self) -> Vec<Session> {
        if !self.controller.program.in_flight {
            return Vec::new();
        }
        let n = self.spec().given();
        let mut sessions = Vec::new();
        for (start, share, arms) in [(-3.7, 0.4, false), (0.2, 1.7, true)] {
            let mut session = self.session(0.0625);
            let [tau, eps] = [Parameter::Tau, Parameter::Eps].map(|p| self.parameter(&session, p));
            let duration = self.chosen.legal(Parameter::Tau, eps + share * (tau - eps));
            if duration <= eps {
                continue;
            }
            let start = settle(start, self.spec().precision);
            session.again = Some(Again { start, duration: Some(duration), arms });
            for share in [1.0, 0.6, 0.25, 0.0] {
                let t = self.time(&session, share * duration);
                for sign in [1.0, -1.0] {
                    let x = self.within(&session, t, &state(n, sign));
                    self.ask(&mut session, t, &x);
                }
            }
            sessions.push(session);
        }
        sessions
    }

    /// Gains of 0, with which products in `init` are 0 by right.
    fn without_gains(&mut self) -> Option<Session> {
        let n = self.spec().given();
        self.checked
            .init
            .iter()
            .chain(&self.checked.arm_for)
            .find(|check| matches!(check, Condition::Kept(..)))?;
        let mut session = self.session(0.0625);
        for (value, parameter) in session.parameters.iter_mut().zip(self.chosen.at_run_time()) {
            if matches!(parameter, Parameter::Gain(_)) {
                *value = self.chosen.legal(*parameter, 0.0);
            }
        }
        if !self.is_taken(&session) {
            return None;
        }
        let tau = self.parameter(&session, Parameter::Tau);
        let t = self.time(&session, 0.5 * tau);
        let x = self.within(&session, t, &state(n, 1.0));
        self.ask(&mut session, t, &x);
        Some(session)
    }

    /// u at its bound from both sides, while tracking, in the hold and after the deadline.
    fn bounded(&mut self) -> Option<Session> {
        let spec = self.spec();
        let n = spec.given();
        let mut session = self.session(0.0625);
        let tau = self.parameter(&session, Parameter::Tau);
        let middle = self.time(&session, 0.5 * tau);
        let x = state(n, 1.0);
        if let Some(at) = self.chosen.place(Parameter::UMax) {
            let controls = self.controls(&session, middle, &x)?;
            let largest = controls.iter().fold(0.0f64, |most, u| most.max(u.abs()));
            let wanted = if largest == 0.0 { 1.0 } else { largest };
            session.parameters[at] = self.chosen.legal(Parameter::UMax, wanted);
        }
        if let Some(at) = self.chosen.place(Parameter::UMin) {
            // The farther limit is the fixed one, where one is.
            let most = self.parameter(&session, Parameter::UMax);
            let wanted = if most.is_finite() { most - 1.75 * most.abs().max(0.5) } else { -1.0 };
            session.parameters[at] = self.chosen.legal(Parameter::UMin, wanted);
        }
        let limits = self.limits(&session);
        let bounded = limits.iter().enumerate();
        let kinds: Vec<_> = bounded
            .flat_map(|(k, limit)| {
                let ends = [(k, true, limit.most), (k, false, limit.least)];
                ends.into_iter().filter(|end| end.2.is_finite()).map(|(k, above, _)| (k, above))
            })
            .collect();
        if kinds.is_empty() {
            return None;
        }
        let met = |call: &Call| -> Vec<(usize, bool)> {
            let each = call.inputs.iter().enumerate();
            let clipped = each.filter(|(_, one)| one.status == Status::Saturated);
            clipped.map(|(k, one)| (k, one.u >= limits[k].most)).collect()
        };
        for t in [middle, self.time(&session, 0.0), self.time(&session, -0.5 * tau)] {
            let mut missing = kinds.clone();
            // Just beyond it first: a bound that is taken too late must show.
            for factor in [0.25, 1.5, -1.5, 4.0, -4.0, 1e2, -1e2, 1e4, -1e4, 1e8, -1e8] {
                let units = self.controls(&session, t, &x);
                let sizes = limits.iter().map(|limit| size(*limit));
                let units = units.unwrap_or_else(|| sizes.clone().collect());
                // The input that is nearest to its bound.
                let pairs = units.iter().zip(sizes).map(|(u, limit)| (u.abs(), limit));
                let share = |(unit, limit): &(f64, f64)| unit / limit;
                let nearest = pairs.reduce(|a, b| if share(&b) > share(&a) { b } else { a });
                let (unit, limit) = nearest.unwrap_or((1.0, 1.0));
                let scale = factor * (limit / unit.max(limit * 1e-6));
                let x: Vec<_> = x.iter().map(|x| settle(scale * x, spec.precision)).collect();
                let Some(call) = self.call(&session, t, &x) else { continue };
                let inside = call.status != Status::Saturated && factor < 1.0 && factor > 0.0;
                if inside || met(&call).iter().any(|kind| missing.contains(kind)) {
                    missing.retain(|other| !met(&call).contains(other));
                    self.ask(&mut session, t, &x);
                }
            }
            // Where u does not grow with the state, another direction may do.
            let mut draw = Draw(4);
            let most = if missing.is_empty() { 0 } else { CANDIDATES / 4 };
            for _ in self.trials.rounds(most) {
                let size = draw.of(&[1e-3, 1.0, 1e3]);
                let x: Vec<_> =
                    (0..n).map(|_| settle(draw.between(-size, size), spec.precision)).collect();
                let Some(call) = self.call(&session, t, &x) else { continue };
                if met(&call).iter().any(|kind| missing.contains(kind)) {
                    missing.retain(|other| !met(&call).contains(other));
                    self.ask(&mut session, t, &x);
                }
            }
        }
        Some(session)
    }
}

/// Size of the limits, the nearest one to 0 that is not 0; infinite for none.
fn size(limits: Range) -> f64 {
    let sizes = limits.finite().map(f64::abs).filter(|size| *size > 0.0);
    sizes.min_by(f64::total_cmp).unwrap_or(f64::INFINITY)
}
