//! Maker of the sessions of a self-test: parameters, times and states, and the results that the definition gives for
//! them.

use std::cell::RefCell;
use std::collections::BTreeSet;

use super::parameters::Chosen;
use super::trial::{Seen, Trial};
use super::{Again, Call, Session, Trials, Wanted, own_laws, own_rest};
use crate::controller::{Checks, Controller};
use crate::parameter::{Parameter, Precision};
use crate::program::interpret::Decision;
use crate::program::machine::Machine;
use crate::program::number::settle;
use crate::program::range::Range;
use crate::reference::{self, Outcome, Reference, Status, tolerance};
use crate::request::{After, Spec};

/// Maker of the sessions.
pub(super) struct Maker<'a> {
    pub(super) controller: &'a Controller<'a>,
    /// A machine of its program that has computed nothing yet.
    pub(super) machine: &'a Machine,
    pub(super) chosen: &'a Chosen<'a>,
    pub(super) trials: &'a Trials,
    /// The definition, with t0 as it is armed, whatever the parameter is.
    pub(super) reference: RefCell<Reference<'a>>,
    /// The branches that were taken so far.
    pub(super) taken: BTreeSet<Decision>,
    /// Checks of `init`, `arm` and `arm_for` on their results.
    pub(super) checked: Checks,
}

impl<'a> Maker<'a> {
    pub(super) fn spec(&self) -> &'a Spec {
        self.controller.spec()
    }

    pub(super) fn session(&self, eps: f64) -> Session {
        let spec = self.spec();
        let x0 = if spec.latches() { state(spec.states(), 0.5) } else { Vec::new() };
        Session { parameters: self.chosen.run_time(eps), x0, again: None, calls: Vec::new() }
    }

    pub(super) fn parameter(&self, session: &Session, wanted: Parameter) -> f64 {
        let at = self.chosen.place(wanted);
        match (wanted, session.again) {
            (Parameter::StartTime, Some(Again { start, .. })) => start,
            (Parameter::Tau, Some(Again { duration: Some(tau), .. })) => tau,
            _ => at.map_or_else(|| self.chosen.value(wanted, 0.0), |at| session.parameters[at]),
        }
    }

    /// The run-time parameters as they are after every start.
    fn parameters(&self, session: &Session) -> Vec<f64> {
        let all = self.chosen.at_run_time().iter().zip(&session.parameters);
        let own = |(parameter, value): (&Parameter, &f64)| match parameter {
            Parameter::Tau => self.parameter(session, *parameter),
            _ => *value,
        };
        all.map(own).collect()
    }

    /// The time at which so much is left.
    pub(super) fn time(&self, session: &Session, to_go: f64) -> f64 {
        let [start, tau] =
            [Parameter::StartTime, Parameter::Tau].map(|p| self.parameter(session, p));
        settle(start + (tau - to_go), self.spec().precision).max(start)
    }

    /// Returns the outcome of a call by the definition; `None` if it is not certain.
    pub(super) fn expected(&self, session: &Session, t: f64, x: &[f64]) -> Option<Vec<Outcome>> {
        let spec = self.spec();
        let laws = own_laws(spec);
        let call = reference::Call {
            parameter: &|p| self.parameter(session, p),
            x0: &session.x0,
            t,
            x,
            laws: &laws,
            after: settle(own_rest(t, x), spec.precision),
        };
        self.reference.borrow_mut().evaluate_each(&call)
    }

    /// Every u before it is clipped; `None` where a call does not evaluate the law, or rounding decides.
    pub(super) fn controls(&self, session: &Session, t: f64, x: &[f64]) -> Option<Vec<f64>> {
        let expected = self.expected(session, t, x)?;
        expected.iter().map(|one| Some(one.control.as_ref()?.u())).collect()
    }

    /// Number of inputs.
    pub(super) fn inputs(&self) -> usize {
        self.spec().coupled.as_ref().map_or(1, |coupled| coupled.inputs.len())
    }

    /// The limits of each u.
    pub(super) fn limits(&self, session: &Session) -> Vec<Range> {
        let given = |parameter| self.parameter(session, parameter);
        (0..self.inputs()).map(|index| Range::of(self.spec(), index, &given)).collect()
    }

    /// The call, with what it must give.
    pub(super) fn call(&self, session: &Session, t: f64, x: &[f64]) -> Option<Call> {
        let expected = self.expected(session, t, x)?;
        // The status of the call is that of an input that is clipped or not finite.
        let rank = |one: &&Outcome| {
            [Status::Saturated, Status::Range].iter().position(|s| *s == one.status)
        };
        let status = expected.iter().max_by_key(rank)?.status;
        if status == Status::Saturated && !self.is_in_range(session, t, x, &expected) {
            return None;
        }
        let limits = self.limits(session);
        let both = expected.iter().zip(limits);
        let inputs = both.map(|(one, limit)| self.wanted(session, (t, x), one, limit));
        let inputs = inputs.collect::<Option<Vec<_>>>()?;
        let axis = self.controller.program.axis.map(|_| status);
        Some(Call { t, x: x.to_vec(), status, inputs, axis })
    }

    /// Returns true if the program has a number for each input that the definition clips: a g that the definition
    /// keeps, exp(-x1^2) of a great x1, may be 0 in its precision, and gains with which u is a sum may leave it.
    fn is_in_range(&self, session: &Session, t: f64, x: &[f64], expected: &[Outcome]) -> bool {
        let seen = self.trial(session, t, x);
        let each = seen.each.iter().map(|(status, _)| *status);
        let mut clipped = each.zip(expected).filter(|(_, one)| one.status == Status::Saturated);
        clipped.all(|(status, _)| status != Status::Range) && seen.axis != Some(Status::Range)
    }

    /// Returns the expected value of an input; `None` where rounding decides it.
    fn wanted(
        &self,
        session: &Session,
        (t, x): (f64, &[f64]),
        expected: &Outcome,
        limits: Range,
    ) -> Option<Wanted> {
        let spec = self.spec();
        let relative = tolerance::of(spec);
        let last_place = spec.precision.epsilon();
        let allowed = match (expected.status, &expected.control) {
            (Status::Ok | Status::Hold, Some(control)) => {
                // Beyond it the powers of which u consists may not all fit.
                // Gains are formed by products of which one may lie above the gain itself: six digits off
                // the end are a margin for those, not a bound.
                let excess = self.gain(session, t, x) > 1e-6 * spec.precision.greatest();
                if excess || control.scale() > spec.precision.greatest().sqrt() {
                    return None;
                }
                relative * control.scale() + last_place * expected.u.abs()
            }
            (Status::After, _) if spec.after == After::Extern => {
                4.0 * last_place * (x[0].abs() + t.abs())
            }
            (Status::Range, _) => return None,
            _ => 0.0,
        };
        // A u on the edge of a limit may be clipped or not.
        let edge = expected.control.as_ref().map_or(0.0, |c| 4.0 * relative * c.scale());
        let u = expected.control.as_ref().map_or(expected.u, reference::Control::u);
        if limits.finite().any(|limit| (u - limit).abs() <= edge) {
            return None;
        }
        Some(Wanted {
            status: expected.status,
            u: settle(expected.u, spec.precision),
            tolerance: up(allowed, spec.precision),
        })
    }

    /// The size of u where the greatest |x_j| is 1: a state that is small leaves u small, yet not the
    /// coefficients by which it is multiplied. 0 where x is no smaller.
    pub(super) fn gain(&self, session: &Session, t: f64, x: &[f64]) -> f64 {
        let largest = x.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        if largest >= 1.0 {
            return 0.0;
        }
        let lift = |x: &f64| if largest == 0.0 { 1.0 } else { x / largest };
        let unit: Vec<_> = x.iter().map(|x| settle(lift(x), self.spec().precision)).collect();
        let expected = self.expected(session, t, &unit);
        let scale = |one: &Outcome| one.control.as_ref().map_or(f64::INFINITY, |c| c.scale());
        expected.map_or(f64::INFINITY, |all| all.iter().map(scale).fold(0.0, f64::max))
    }

    /// Adds a call where the definition says what it gives; notes the branches that it takes.
    pub(super) fn ask(&mut self, session: &mut Session, t: f64, x: &[f64]) -> Option<Status> {
        let call = self.call(session, t, x)?;
        let status = call.status;
        if !matches!(status, Status::Input | Status::Param) {
            let decisions = self.trial(session, t, x).decisions;
            self.taken.extend(decisions);
        }
        session.calls.push(call);
        Some(status)
    }

    /// Returns true if `init` accepts the parameters: neither a coefficient nor the deadline leaves the range.
    pub(super) fn is_taken(&self, session: &Session) -> bool {
        let zeros = vec![0.0; self.spec().given()];
        let start = self.parameter(session, Parameter::StartTime);
        let deadline =
            settle(start + self.parameter(session, Parameter::Tau), self.spec().precision);
        let (controller, chosen) = (self.controller, self.chosen);
        let (machine, x0) = (self.machine, session.x0.as_slice());
        let parameters = &self.parameters(session);
        let trial =
            Trial { controller, chosen, machine, parameters, x0, start, t: start, x: &zeros };
        let legal = |p: Parameter| self.spec().keeps_digits(p, self.parameter(session, p));
        let [tau, eps] = [Parameter::Tau, Parameter::Eps].map(|p| self.parameter(session, p));
        let in_domain = eps < tau && self.chosen.at_run_time().iter().copied().all(legal);
        in_domain
            && deadline.is_finite()
            && self.checked.all().all(|checks| trial.first_failure(checks).is_none())
    }

    pub(super) fn trial(&self, session: &Session, t: f64, x: &[f64]) -> Seen {
        let start = self.parameter(session, Parameter::StartTime);
        let (controller, chosen) = (self.controller, self.chosen);
        let (machine, x0) = (self.machine, session.x0.as_slice());
        let parameters = &self.parameters(session);
        Trial { controller, chosen, machine, parameters, x0, start, t, x }.run()
    }

    /// A state along `x` with which u is half its bound at most, as far as u is affine in the state: a
    /// law of stretched time gives a u to the state 0 too, which the state then makes up for.
    pub(super) fn within(&self, session: &Session, t: f64, x: &[f64]) -> Vec<f64> {
        let halves: Vec<_> = self.limits(session).iter().map(|limit| limit.scaled(0.5)).collect();
        let controls =
            |x: &[f64]| self.controls(session, t, x).unwrap_or_else(|| vec![0.0; halves.len()]);
        let u = controls(x);
        if u.iter().zip(&halves).all(|(u, half)| !half.clip(*u).1) {
            return x.to_vec();
        }
        let at_rest = controls(&vec![0.0; x.len()]);
        let each = u.iter().zip(at_rest).zip(&halves).filter(|((u, _), half)| half.clip(**u).1);
        let shares = each.map(|((u, at_rest), half)| {
            let at_rest = if at_rest.is_finite() { at_rest } else { 0.0 };
            (half.clip(*u).0 - at_rest) / (u - at_rest)
        });
        let share = shares.min_by(f64::total_cmp).unwrap_or(1.0);
        if !share.is_finite() {
            return x.to_vec();
        }
        x.iter().map(|x| settle(share * x, self.spec().precision)).collect()
    }
}

/// A state of n numbers near 1, of both signs.
pub(super) fn state(n: usize, factor: f64) -> Vec<f64> {
    [0.75, -1.25, 0.5, 1.5].iter().cycle().take(n).map(|x| factor * x).collect()
}

/// The least number of the precision that is not below `value`, or the next.
fn up(value: f64, precision: Precision) -> f64 {
    if value == 0.0 { 0.0 } else { after(settle(value, precision), precision) }
}

/// The least number of the precision above `value`, which is one of them.
pub(super) fn after(value: f64, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => value.next_up(),
        #[allow(clippy::cast_possible_truncation)]
        Precision::F32 => f64::from((value as f32).next_up()),
    }
}
