//! The calls of a self-test: every status, every branch, and time-to-go down to the last digits.

use std::collections::BTreeSet;

use super::overflow::{extreme, least};
use super::parameters::Chosen;
use super::trial::Trial;
use super::{Call, Draw, Session, Unreachable, greatest, own_law, own_rest};
use crate::emit::{Controller, checked_fields};
use crate::program::Op;
use crate::program::interpret::Decision;
use crate::program::number::settle;
use crate::reference::{self, Status, evaluate, tolerance};
use crate::spec::{After, Guard, Parameter, Precision, Spec};

/// Time-to-go as parts of tau, down to what is promised.
const APPROACH: [f64; 10] = [1.0, 0.75, 0.4, 0.1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
/// Random calls among which those are kept that take a branch no other took.
const CANDIDATES: usize = 400;
/// As many where an iteration has branches that few numbers take.
const ITERATED: usize = 4000;

/// What the sessions are made from.
struct Maker<'a> {
    controller: &'a Controller<'a>,
    chosen: &'a Chosen<'a>,
    /// The branches that were taken so far.
    taken: BTreeSet<Decision>,
}

/// The sessions of the self-test of a controller.
///
/// With them come the branches of the program that none of the calls takes.
pub(super) fn sessions(
    controller: &Controller<'_>,
    chosen: &Chosen<'_>,
) -> (Vec<Session>, Vec<Unreachable>) {
    let mut maker = Maker { controller, chosen, taken: BTreeSet::new() };
    let mut sessions = vec![maker.approach(), maker.hold(), maker.armed_again()];
    sessions.extend(maker.bounded());
    sessions.extend(maker.out_of_range());
    sessions.extend(maker.branches());
    sessions.retain(|session| !session.calls.is_empty());
    let never = maker.never();
    (sessions, never)
}

impl<'a> Maker<'a> {
    fn spec(&self) -> &'a Spec {
        self.controller.spec()
    }

    fn session(&self, eps: f64) -> Session {
        let spec = self.spec();
        let x0 = if spec.latches() { state(spec.n, 0.5) } else { Vec::new() };
        Session { parameters: self.chosen.run_time(eps), x0, again: None, calls: Vec::new() }
    }

    fn parameter(&self, session: &Session, wanted: Parameter) -> f64 {
        let at = self.spec().run_time_parameters().position(|p| p == wanted);
        match (wanted, session.again) {
            (Parameter::StartTime, Some(start)) => start,
            _ => at.map_or_else(|| self.chosen.value(wanted, 0.0), |at| session.parameters[at]),
        }
    }

    /// The time at which so much is left.
    fn time(&self, session: &Session, to_go: f64) -> f64 {
        let [start, tau] =
            [Parameter::StartTime, Parameter::Tau].map(|p| self.parameter(session, p));
        settle(start + (tau - to_go), self.spec().precision).max(start)
    }

    /// What the definition says of a call; none where it does not say it for certain.
    fn expected(&self, session: &Session, t: f64, x: &[f64]) -> Option<reference::Outcome> {
        // Armed again, t0 is what `arm` was given, whatever the parameter is.
        let mut spec = self.spec().clone();
        spec.fixed.remove(&Parameter::StartTime);
        let law = own_law(spec.n);
        let call = reference::Call {
            parameter: &|p| self.parameter(session, p),
            x0: &session.x0,
            t,
            x,
            law: Some(&law),
            after: settle(own_rest(t, x), spec.precision),
        };
        evaluate(&spec, &call)
    }

    /// The call, with what it must give.
    fn call(&self, session: &Session, t: f64, x: &[f64]) -> Option<Call> {
        let spec = self.spec();
        let expected = self.expected(session, t, x)?;
        let relative = tolerance::of(spec);
        let last_place = match spec.precision {
            Precision::F64 => f64::EPSILON,
            Precision::F32 => f64::from(f32::EPSILON),
        };
        let allowed = match (expected.status, &expected.control) {
            (Status::Ok | Status::Hold, Some(control)) => {
                // Beyond it the powers of which u consists may not all fit.
                // Gains are formed by products of which one may lie above the gain itself: six digits off
                // the end are a margin for those, not a bound.
                let excess = self.gain(session, t, x) > 1e-6 * greatest(spec);
                if excess || control.scale() > greatest(spec).sqrt() {
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
        // A u on the edge of the bound may be clipped or not.
        let u_max = self.parameter(session, Parameter::UMax);
        let edge = expected.control.as_ref().map_or(0.0, |c| 4.0 * relative * c.scale());
        let u = expected.control.as_ref().map_or(expected.u, reference::Control::u);
        if (u.abs() - u_max).abs() <= edge {
            return None;
        }
        let has_axis = self.controller.program.axis.is_some();
        Some(Call {
            t,
            x: x.to_vec(),
            status: expected.status,
            u: settle(expected.u, spec.precision),
            tolerance: up(allowed, spec.precision),
            axis: has_axis.then_some(expected.status),
        })
    }

    /// The size of u where the greatest |x_j| is 1: a state that is small leaves u small, yet not the
    /// coefficients by which it is multiplied. 0 where x is no smaller.
    fn gain(&self, session: &Session, t: f64, x: &[f64]) -> f64 {
        let largest = x.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        if largest >= 1.0 {
            return 0.0;
        }
        let lift = |x: &f64| if largest == 0.0 { 1.0 } else { x / largest };
        let unit: Vec<_> = x.iter().map(|x| settle(lift(x), self.spec().precision)).collect();
        let control = self.expected(session, t, &unit).and_then(|outcome| outcome.control);
        control.map_or(f64::INFINITY, |control| control.scale())
    }

    /// Adds a call where the definition says what it gives; notes the branches that it takes.
    fn ask(&mut self, session: &mut Session, t: f64, x: &[f64]) -> Option<Status> {
        let call = self.call(session, t, x)?;
        let status = call.status;
        if !matches!(status, Status::Input | Status::Param) {
            let decisions = self.trial(session, t, x).decisions;
            self.taken.extend(decisions);
        }
        session.calls.push(call);
        Some(status)
    }

    /// Whether `init` takes the parameters: neither a coefficient nor the deadline overflows.
    fn is_taken(&self, session: &Session) -> bool {
        let zeros = vec![0.0; self.spec().n];
        let start = self.parameter(session, Parameter::StartTime);
        let deadline =
            settle(start + self.parameter(session, Parameter::Tau), self.spec().precision);
        let (controller, x0) = (self.controller, session.x0.as_slice());
        let parameters = &session.parameters;
        let trial = Trial { controller, parameters, x0, start, t: start, x: &zeros };
        let [fields, armed] = checked_fields(controller.program);
        let excess = trial.first_excess(&fields).or_else(|| trial.first_excess(&armed));
        deadline.is_finite() && excess.is_none()
    }

    fn trial(&self, session: &Session, t: f64, x: &[f64]) -> super::trial::Seen {
        let start = self.parameter(session, Parameter::StartTime);
        let (controller, x0) = (self.controller, session.x0.as_slice());
        Trial { controller, parameters: &session.parameters, x0, start, t, x }.run()
    }

    /// A state along `x` with which u is half its bound at most, as far as u is affine in the state: a
    /// law of stretched time gives a u to the state 0 too, which the state then makes up for.
    fn within(&self, session: &Session, t: f64, x: &[f64]) -> Vec<f64> {
        let half = 0.5 * self.parameter(session, Parameter::UMax);
        let control = |x: &[f64]| {
            let control = self.expected(session, t, x).and_then(|outcome| outcome.control);
            control.map_or(0.0, |control| control.u())
        };
        let u = control(x);
        if u.abs() <= half {
            return x.to_vec();
        }
        let at_rest = control(&vec![0.0; x.len()]);
        let at_rest = if at_rest.is_finite() { at_rest } else { 0.0 };
        let share = (half.copysign(u) - at_rest) / (u - at_rest);
        if !share.is_finite() {
            return x.to_vec();
        }
        x.iter().map(|x| settle(share * x, self.spec().precision)).collect()
    }

    /// Tracking from the start to the last digits of time-to-go, and inputs that are refused.
    fn approach(&mut self) -> Session {
        let n = self.spec().n;
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

    /// Inputs that are not finite or before the start, as far as the guard catches them.
    fn wrong_inputs(&mut self, session: &mut Session, tau: f64) {
        let (guard, n) = (self.spec().guard, self.spec().n);
        let t = self.time(session, 0.5 * tau);
        let x = self.within(session, t, &state(n, 1.0));
        let status = match guard {
            Guard::Full => Status::Input,
            Guard::Result => Status::Range,
            Guard::None => return,
        };
        let has_axis = self.controller.program.axis.is_some();
        let mut refuse = |t: f64, x: Vec<f64>, axis: bool| {
            let axis = (has_axis && axis).then_some(status);
            session.calls.push(Call { t, x, status, u: 0.0, tolerance: 0.0, axis });
        };
        let full = guard == Guard::Full;
        // Behind the result alone, an infinite state is clipped and a tick without time is held.
        let wrong: &[f64] =
            if full { &[f64::NAN, f64::INFINITY, f64::NEG_INFINITY] } else { &[f64::NAN] };
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            refuse(value, x.clone(), full);
        }
        for value in wrong {
            for j in 0..n {
                let mut x = x.clone();
                x[j] = *value;
                refuse(t, x, true);
            }
        }
        if full {
            let start = self.parameter(session, Parameter::StartTime);
            let early = settle(start - 0.5 * tau, self.spec().precision);
            session.calls.push(Call {
                t: early,
                x,
                status,
                u: 0.0,
                tolerance: 0.0,
                axis: has_axis.then_some(status),
            });
        }
    }

    /// Held gains, the deadline, and what follows it.
    fn hold(&mut self) -> Session {
        let n = self.spec().n;
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
        let n = self.spec().n;
        let mut session = self.session(0.0625);
        session.again = Some(settle(1000.1, self.spec().precision));
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

    /// u at its bound from both sides, while tracking, in the hold and after the deadline.
    fn bounded(&mut self) -> Option<Session> {
        let spec = self.spec();
        let n = spec.n;
        let mut session = self.session(0.0625);
        let tau = self.parameter(&session, Parameter::Tau);
        let middle = self.time(&session, 0.5 * tau);
        let x = state(n, 1.0);
        if let Some(at) = spec.run_time_parameters().position(|p| p == Parameter::UMax) {
            let control = self.expected(&session, middle, &x)?.control?;
            let wanted = if control.u() == 0.0 { 1.0 } else { control.u().abs() };
            session.parameters[at] = self.chosen.legal(Parameter::UMax, wanted);
        }
        if self.parameter(&session, Parameter::UMax).is_infinite() {
            return None;
        }
        let u_max = self.parameter(&session, Parameter::UMax);
        for t in [middle, self.time(&session, 0.0), self.time(&session, -0.5 * tau)] {
            let mut missing = vec![(Status::Saturated, true), (Status::Saturated, false)];
            // Just beyond it first: a bound that is taken too late must show.
            for factor in [0.25, 1.5, -1.5, 4.0, -4.0, 1e2, -1e2, 1e4, -1e4, 1e8, -1e8] {
                let unit = self.expected(&session, t, &x).and_then(|outcome| outcome.control);
                let unit = unit.map_or(u_max, |control| control.u().abs()).max(u_max * 1e-6);
                let scale =
                    factor * if u_max < unit { u_max / unit } else { unit.max(u_max) / unit };
                let x: Vec<_> = x.iter().map(|x| settle(scale * x, spec.precision)).collect();
                let Some(call) = self.call(&session, t, &x) else { continue };
                let kind = (call.status, call.u > 0.0);
                let inside = call.status != Status::Saturated && factor < 1.0 && factor > 0.0;
                if inside || missing.contains(&kind) {
                    missing.retain(|other| *other != kind);
                    self.ask(&mut session, t, &x);
                }
            }
            // Where u does not grow with the state, another direction may do.
            let mut draw = Draw(4);
            for _ in 0..if missing.is_empty() { 0 } else { CANDIDATES / 4 } {
                let size = draw.of(&[1e-3, 1.0, 1e3]);
                let x: Vec<_> =
                    (0..n).map(|_| settle(draw.between(-size, size), spec.precision)).collect();
                let Some(call) = self.call(&session, t, &x) else { continue };
                let kind = (call.status, call.u > 0.0);
                if missing.contains(&kind) {
                    missing.retain(|other| *other != kind);
                    self.ask(&mut session, t, &x);
                }
            }
        }
        Some(session)
    }

    /// A u that is no number, or that overflows without a bound: found by trial, as it is the
    /// order of the operations that decides.
    fn out_of_range(&mut self) -> Vec<Session> {
        let spec = self.spec();
        let mut draw = Draw(2);
        let largest = greatest(spec);
        let all: Vec<_> = spec.run_time_parameters().collect();
        let mut found = Vec::new();
        let mut kinds = vec![(true, true), (true, false)];
        for round in 0..2 * CANDIDATES {
            let mut session = self.session(if round % 2 == 0 { 0.0625 } else { 1e-4 });
            if round < CANDIDATES {
                self.at_the_ends(&mut session, round);
            } else {
                // Each parameter alone at its ends, then all of them anywhere.
                let round = (round - CANDIDATES) % (8 * all.len().max(1));
                let usual = session.parameters;
                session.parameters = extreme(spec, self.chosen, &usual, round, &mut draw);
            }
            let tau = self.parameter(&session, Parameter::Tau);
            let mut t = self.time(&session, draw.of(&[0.0, 0.02, 0.5]) * tau);
            if spec.after != After::Hold && t >= self.time(&session, 0.0) {
                let start = self.parameter(&session, Parameter::StartTime);
                t = start.max(-after(-t, spec.precision));
            }
            let sizes = [largest, -largest, 0.75 * largest, 1.0, -1.0, 0.0];
            let x: Vec<_> = (0..spec.n).map(|_| settle(draw.of(&sizes), spec.precision)).collect();
            let seen = self.trial(&session, t, &x);
            let range = |status: Status| status == Status::Range;
            let kind = (range(seen.step.0), seen.axis.is_some_and(range));
            // A bound says nothing of the digits: what stays in range is asked elsewhere.
            // A branch counts as taken where `tick`, which has its own code, takes it too.
            let whole = kind.1 || seen.axis.is_none();
            let is_new = kinds.contains(&kind) || (whole && !seen.decisions.is_subset(&self.taken));
            if !kind.0 || !is_new || !self.is_taken(&session) {
                continue;
            }
            let axis = seen.axis.filter(|status| range(*status));
            kinds.retain(|other| *other != kind);
            if whole {
                self.taken.extend(seen.decisions);
            }
            session.calls.push(Call { t, x, status: Status::Range, u: 0.0, tolerance: 0.0, axis });
            found.push(session);
        }
        found
    }

    /// Some run-time parameters at the ends of what they may be, by turns.
    fn at_the_ends(&self, session: &mut Session, round: usize) {
        let spec = self.spec();
        let largest = greatest(spec);
        let all: Vec<_> = spec.run_time_parameters().collect();
        for (at, parameter) in all.iter().enumerate() {
            let value = match parameter {
                Parameter::UMax if round % 3 == 1 => 1.0,
                // A time-to-go that has no reciprocal, and no share of tau.
                Parameter::Eps if round % 4 == 3 => least(spec),
                Parameter::Tau if round % 4 == 3 && round % 16 > 8 => largest / 8.0,
                Parameter::Tau if round % 4 == 3 && round % 16 > 4 => 8.0 * least(spec),
                Parameter::Gain(_) if round % 8 == 7 => 0.0,
                _ => continue,
            };
            session.parameters[at] = self.chosen.legal(*parameter, value);
        }
        // A deadline at 0, up to which time has all its digits.
        let at = all.iter().position(|p| *p == Parameter::StartTime);
        if let Some(at) = at.filter(|_| round % 4 == 3) {
            let start = -self.parameter(session, Parameter::Tau);
            session.parameters[at] = self.chosen.legal(Parameter::StartTime, start);
        }
    }

    /// The branches of iterations and divisions that no call takes.
    fn never(&self) -> Vec<Unreachable> {
        let program = self.controller.program;
        let mut never = Vec::new();
        let mut add = |condition: String, what: &str| {
            let tried = if self.spec().is_iterated() { ITERATED } else { CANDIDATES };
            let reason = format!("{what} in {tried} random calls, nor at the ends of the range");
            never.push(Unreachable { condition, reason });
        };
        for value in program.needed(&[program.step]) {
            let missing = |way| !self.taken.contains(&(value, way));
            match &program.get(value).op {
                Op::Root(root) => {
                    let name = program.get(value).name.as_ref().map_or("y", |(name, _)| name);
                    if missing("exhausted") {
                        let condition = format!("round < {}U", root.rounds);
                        add(condition, "the iteration used no more rounds than it has");
                    }
                    if missing("before") {
                        add(
                            format!("({name}_next >= {name}_low)"),
                            "no step went below the bracket",
                        );
                    }
                    if missing("beyond") {
                        add(
                            format!("({name}_next <= {name}_high)"),
                            "no step went above the bracket",
                        );
                    }
                }
                Op::Quotient(_, divisor) => {
                    let name = program.get(*divisor).name.as_ref();
                    let name = name.map_or("input_gain", |(name, _)| name);
                    if missing("negative") {
                        add(format!("({name} < 0.0"), "g was not negative");
                    }
                    if missing("zero") {
                        add(format!("({name} > 0.0"), "g was not 0");
                    }
                }
                _ => {}
            }
        }
        never
    }

    /// Random calls that take a branch of the code which none before took.
    fn branches(&mut self) -> Vec<Session> {
        let spec = self.spec();
        let mut draw = Draw(3);
        let all: Vec<_> = spec.run_time_parameters().collect();
        let mut found = Vec::new();
        let iterated = self.spec().is_iterated();
        for round in 0..if iterated { ITERATED } else { CANDIDATES } {
            let eps = draw.of(&[1e-3, 0.05, 0.3]);
            let mut session = self.session(eps);
            for (at, parameter) in all.iter().enumerate() {
                if round % 2 == 0
                    || matches!(parameter, Parameter::StartTime | Parameter::UMax | Parameter::Eps)
                {
                    continue;
                }
                // Equal ones, now and then: brackets of no width.
                let size = if round % 3 == 0 { 0.875 } else { draw.between(0.2, 3.0) };
                let signed = spec.domain(*parameter) == crate::spec::Domain::Finite;
                let value = match draw.of(&[0, 1, 2, 3]) {
                    0 if signed => 0.0,
                    1 if signed => -size,
                    _ => size,
                };
                session.parameters[at] = self.chosen.legal(*parameter, value);
            }
            let tau = self.parameter(&session, Parameter::Tau);
            if let Some(at) = all.iter().position(|p| *p == Parameter::Eps) {
                session.parameters[at] = self.chosen.legal(Parameter::Eps, eps * tau);
            }
            if self.parameter(&session, Parameter::Eps) >= tau {
                continue;
            }
            for x0 in &mut session.x0 {
                *x0 = settle(draw.between(-2.0, 2.0), spec.precision);
            }
            let share = draw.between(0.0, 1.0);
            let t = self.time(&session, draw.of(&[share, share, 1.0, 0.999_999]) * tau);
            let size = draw.of(&[1.0, 1e-3, 1e2, 1e6]);
            let x: Vec<_> = (0..spec.n)
                .map(|_| {
                    settle(draw.of(&[0.0, 1.0, 1.0]) * draw.between(-size, size), spec.precision)
                })
                .collect();
            let seen = self.trial(&session, t, &x);
            if seen.decisions.is_subset(&self.taken) || !self.is_taken(&session) {
                continue;
            }
            let zero_gain = seen.step.1.is_nan() && seen.step.0 == Status::Range;
            if zero_gain {
                // A division by g = 0, which is no number.
                let axis = None;
                session.calls.push(Call {
                    t,
                    x,
                    status: Status::Range,
                    u: 0.0,
                    tolerance: 0.0,
                    axis,
                });
                self.taken.extend(seen.decisions);
            } else {
                self.ask(&mut session, t, &x);
            }
            found.push(session);
        }
        found
    }
}

/// A state of n numbers near 1, of both signs.
fn state(n: usize, factor: f64) -> Vec<f64> {
    [0.75, -1.25, 0.5, 1.5].iter().cycle().take(n).map(|x| factor * x).collect()
}

/// The least number of the precision that is not below `value`, or the next.
fn up(value: f64, precision: Precision) -> f64 {
    if value == 0.0 { 0.0 } else { after(settle(value, precision), precision) }
}

/// The least number of the precision above `value`, which is one of them.
fn after(value: f64, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => value.next_up(),
        #[allow(clippy::cast_possible_truncation)]
        Precision::F32 => f64::from((value as f32).next_up()),
    }
}
