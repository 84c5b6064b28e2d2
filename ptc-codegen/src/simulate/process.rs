//! The process around a sampled controller: the plant with its sensors and its actuator.

use std::collections::VecDeque;

use super::between::{BETWEEN, Between, Held, Moved};
use super::control::Control;
use super::event_queue::EventQueue;
use super::frame::{Frame, Span};
#[cfg(feature = "lab")]
use super::held::Effect;
use super::held::Row;
use super::integrals::Integrals;
use super::linear::Linear;
use super::method::State;
use super::outputs::Outputs;
use super::plant::Motion;
use super::solver::First;
use super::switching::Walk;
use super::{Failure, Loop, Sample, Values};
use crate::expression::Expression;
use crate::parameter::{Fixed, Parameter};
use crate::plant::Plant;
use crate::request::Spec;

/// A plant that is sampled, with any controller.
#[derive(Clone, Debug)]
pub struct Process {
    n: usize,
    pub(super) inputs: usize,
    /// Number of measured values.
    pub(super) measured: usize,
    /// True if the clock of the controller is the number of the sample.
    pub(super) in_samples: bool,
    pub(super) moved: Moved,
    /// Inputs of the controller for a plant with other states than the law.
    pub(super) outputs: Option<Outputs>,
    pub(super) integrals: Option<Integrals>,
}

/// Most times tau, from where the controller was armed, for which a run follows a deadline that is put off.
pub(super) const LONGEST: f64 = 20.0;

/// Bounds of all states and of u below which they count as 0.
const NOTHING: [f64; 2] = [1e-100, 1e-80];

impl Process {
    /// The process of the controller of `spec`, to be run with many values.
    pub fn new(spec: &Spec, plant: &Plant) -> Self {
        let outputs = Outputs::new(spec);
        let linear = spec.sampled().and_then(|sampled| sampled.linear.as_ref());
        let moved = match linear.filter(|_| outputs.is_none()) {
            Some(plant) => {
                let h = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number);
                Moved::Linear(Linear::new(plant, h))
            }
            None => Moved::Rates(Box::new(Motion::new(spec, &known(spec, plant)))),
        };
        Self {
            n: spec.states(),
            inputs: spec.input_names().len(),
            measured: spec.measurements(),
            in_samples: spec.sampled().is_some(),
            moved,
            outputs,
            integrals: None,
        }
    }

    /// The same with integrals over the run beside it.
    pub(super) fn with_integrals(self, spec: &Spec, integrands: &[Expression]) -> Self {
        Self { integrals: Integrals::new(spec, integrands), ..self }
    }

    /// Runs `control` from `x0` at t0 to the end of the loop and hands over every sample, with the u that acts
    /// from it on, and the state at the end. `change` gives other values of the plant's symbols where they change, by
    /// the time after t0.
    ///
    /// # Errors
    /// A parameter without a value, or a loop that leaves the range of numbers.
    pub fn run<'a>(
        &mut self,
        control: &mut dyn Control,
        values: &Values,
        change: &mut dyn FnMut(f64) -> Option<&'a Values>,
        x0: &[f64],
        around: &Loop,
        visit: &mut dyn FnMut(Sample<'_>),
    ) -> Result<(), Failure> {
        let given = self.start(values, x0)?;
        control.init(values, &given)?;
        let behind = self.n + self.integrals.as_ref().map_or(0, Integrals::count);
        let (tau, t0) = (values.get(Parameter::Tau), values.get(Parameter::StartTime));
        let mut frame = Frame::new(around, tau);
        let none = vec![0.0; self.inputs];
        let mut late = VecDeque::from(vec![none.clone(); around.delay.inputs()]);
        let mut x = State::zeros();
        x.as_mut_slice()[..self.n].copy_from_slice(x0);
        let mut events = EventQueue::new(&around.events);
        let (mut deadline, mut longest) = (tau, LONGEST * tau);
        let mut walk = Walk::default();
        loop {
            let index = frame.index;
            let (since, _) = frame.since();
            let t = t0 + since;
            if let Some(values) = change(since) {
                self.give(values)?;
            }
            let now = if self.in_samples { f64::from(index) } else { t };
            let happens = events.at(since);
            happens.move_targets(control, x.as_mut_slice());
            let state = &x.as_slice()[..self.n];
            let measured = self.measured(&mut frame, t, state);
            if let Some(rest) = happens.arm(control, (now, t), &measured, around.period)? {
                deadline = since + rest.unwrap_or(tau);
                longest = since + LONGEST * tau.max(rest.unwrap_or(tau));
                frame.extend(deadline);
            }
            let (u, status) = control.step(now, &measured);
            late.push_back(u.iter().map(|u| frame.actuated(*u)).collect());
            if let Some(sample) = control.deadline() {
                deadline = sample * around.period;
                frame.extend(deadline.min(longest));
            }
            let (_, last) = frame.since();
            let u = late.pop_front().unwrap_or_else(|| none.clone());
            let newer = late.front().unwrap_or(&u);
            visit(Sample {
                t,
                time_to_go: deadline - since,
                stretched: f64::NAN,
                x: state,
                measured: &measured,
                u: &u,
                integrals: &x.as_slice()[self.n..behind],
                status,
                last,
            });
            if last {
                break;
            }
            events.end_forces(since);
            let Span { from, over, to } = frame.next();
            for (u, from, to) in [(&u, from, over), (newer, over, to)] {
                let forces = (0..).map(|input| events.force(input));
                let acts: Vec<_> =
                    u.iter().zip(forces).map(|(u, force)| frame.gain * u + force).collect();
                let held = Held { u, acts: &acts };
                let at = |part: u32| match part == around.parts {
                    true => to,
                    false => from + (to - from) * f64::from(part) / f64::from(around.parts),
                };
                for part in (0..around.parts).filter(|_| from < to) {
                    let ends = (t0 + at(part), t0 + at(part + 1));
                    let moved = self.between(&mut walk, x, held, (ends, deadline - at(part)));
                    x = moved.map_err(|failure| failure.at(t, format_args!("t = {t} s")))?;
                    if part + 1 < around.parts {
                        visit(Sample {
                            t: ends.1,
                            time_to_go: deadline - at(part + 1),
                            stretched: f64::NAN,
                            x: &x.as_slice()[..self.n],
                            measured: &measured,
                            u,
                            integrals: &x.as_slice()[self.n..behind],
                            status,
                            last: false,
                        });
                    }
                }
            }
        }
        Ok(())
    }

    /// Number of states of the plant.
    pub(super) fn states(&self) -> usize {
        self.n
    }

    /// Begins a run from `x0`, and returns the state that the controller is given.
    pub(super) fn start(&mut self, values: &Values, x0: &[f64]) -> Result<Vec<f64>, Failure> {
        if let Moved::Rates(motion) = &mut self.moved {
            motion.init(values, x0)?;
        }
        if let Some(integrals) = &mut self.integrals {
            integrals.start(values, x0)?;
        }
        let Some(outputs) = &mut self.outputs else { return Ok(x0.to_vec()) };
        outputs.init(values, x0)?;
        Ok(outputs.at(values.get(Parameter::StartTime), x0).to_vec())
    }

    /// Gives the plant's symbols other values; a linear plant has none.
    pub(super) fn give(&mut self, values: &Values) -> Result<(), Failure> {
        if let Moved::Rates(motion) = &mut self.moved {
            motion.give(values)?;
            if let Some(outputs) = &mut self.outputs {
                outputs.give(values)?;
            }
        }
        Ok(())
    }

    /// The measurement of a state at time `t`.
    fn measured(&mut self, frame: &mut Frame<'_>, t: f64, state: &[f64]) -> Vec<f64> {
        let mut measured = self.sensed(t, state);
        frame.measure(&mut measured);
        // A chain's other states reach no sensor.
        measured.truncate(self.measured);
        measured
    }

    /// Returns true if sensors without errors give the state itself.
    pub(super) fn gives_state(&self) -> bool {
        self.outputs.is_none() && matches!(self.moved, Moved::Rates(_))
    }

    /// What sensors without errors give in a state at time `t`.
    pub(super) fn sensed(&mut self, t: f64, state: &[f64]) -> Vec<f64> {
        match (&mut self.outputs, &self.moved) {
            (Some(outputs), _) => outputs.at(t, state).to_vec(),
            (None, Moved::Rates(_)) => state.to_vec(),
            (None, Moved::Linear(plant)) => plant.measured(state),
        }
    }

    /// The rows of the plant over a time in which its inputs are held, and the length to which they belong; `None` where
    /// only [`Self::between`] moves it.
    pub(super) fn rows(&mut self, length: f64) -> Option<(f64, Vec<Row<'_>>)> {
        match &mut self.moved {
            Moved::Rates(motion) => motion.rows(length).map(|(own, rows)| (own, rows.collect())),
            Moved::Linear(plant) => plant.known(length),
        }
    }

    /// Returns true if the plant is moved by an integration alone.
    #[cfg(feature = "lab")]
    pub(super) fn is_integrated(&self) -> bool {
        matches!(&self.moved, Moved::Rates(motion) if motion.is_integrated())
    }

    /// The effect on the plant of a time in which its inputs are held; `None` where an integration moves it.
    #[cfg(feature = "lab")]
    pub(super) fn effect(&mut self, length: f64) -> Option<Effect> {
        match &mut self.moved {
            Moved::Rates(motion) => motion.effect(length),
            Moved::Linear(plant) => plant.effect(length),
        }
    }

    /// Forgets the effects of lengths that were asked for.
    #[cfg(feature = "lab")]
    pub(super) fn forget(&mut self) {
        if let Moved::Rates(motion) = &mut self.moved {
            motion.forget();
        }
    }

    /// Appends what each sine of time adds to each state in `length` s from `t` on.
    #[cfg(feature = "lab")]
    pub(super) fn waves(&mut self, t: f64, length: f64, into: &mut Vec<f64>) -> Option<()> {
        match &mut self.moved {
            Moved::Rates(motion) => motion.waves(t, length, into),
            Moved::Linear(_) => Some(()),
        }
    }

    /// Returns the rows of y = C x; none where the states are measured.
    #[cfg(feature = "lab")]
    pub(super) fn output_rows(&self) -> Vec<Vec<f64>> {
        match &self.moved {
            Moved::Rates(_) => Vec::new(),
            Moved::Linear(plant) => plant.output_rows().clone(),
        }
    }

    /// Number of values that sensors give, of which a controller may be given fewer.
    #[cfg(feature = "lab")]
    pub(super) fn sensed_values(&self) -> usize {
        match &self.moved {
            Moved::Rates(_) => self.n,
            Moved::Linear(plant) => plant.output_rows().len(),
        }
    }

    /// The state at the end of a time in which u is constant, at whose beginning `time_to_go` is left.
    pub(super) fn between(
        &mut self,
        walk: &mut Walk,
        x: State,
        Held { u, acts }: Held<'_>,
        ((from, to), time_to_go): ((f64, f64), f64),
    ) -> Result<State, Failure> {
        let Self { n, moved, integrals, .. } = self;
        let exact = match moved {
            Moved::Rates(motion) => motion.after(&x, acts, (from, to)),
            Moved::Linear(plant) => Some(plant.after(x, acts[0], to - from)?),
        };
        if exact.is_some_and(|next| next.iter().any(|x| !x.is_finite())) {
            return Err(Failure::range());
        }
        if let (Some(exact), None) = (exact, &integrals) {
            return Ok(exact);
        }
        // Of states that have died out the errors of a step would underflow.
        let nothing = is_at_rest(x.iter().take(*n).copied(), acts.iter().copied());
        let rest = vec![0.0; acts.len()];
        let (mut begin, held) = (x, Held { u, acts: if nothing { &rest } else { acts } });
        if nothing {
            begin.as_mut_slice()[..*n].fill(0.0);
        }
        let length = to - from;
        let integrals = integrals.as_mut();
        let mut between = Between { moved, integrals, held, from, length, time_to_go, end: begin };
        let done = walk.on(&mut between, begin, &[0.0, 1.0], (First::Fifth, BETWEEN));
        let mut end = between.end;
        if let Err((_, failure)) = done {
            let of_integral = |own: &Integrals| own.failure(failure.clone());
            return Err(self.integrals.as_ref().map_or_else(|| failure.clone(), of_integral));
        }
        if let Some(exact) = exact {
            end.as_mut_slice()[..*n].copy_from_slice(&exact.as_slice()[..*n]);
        }
        Ok(end)
    }
}

/// Returns true if states and inputs are so small that they count as 0.
pub(super) fn is_at_rest(
    mut x: impl Iterator<Item = f64>,
    mut acts: impl Iterator<Item = f64>,
) -> bool {
    x.all(|x| x.abs() < NOTHING[0]) && acts.all(|u| u.abs() < NOTHING[1])
}

/// A chain has the f that its controller knows, where a plant is not given.
fn known(spec: &Spec, plant: &Plant) -> Plant {
    match spec.drift.clone().filter(|_| spec.sampled().is_some() && *plant == Plant::default()) {
        Some(f) => Plant { f, ..Plant::default() },
        None => plant.clone(),
    }
}
