//! The closed loop in numbers, by the interpreter: gains, r_k and stretched time at a time-to-go.

use std::cell::{OnceCell, RefCell};

use super::known::to_f64;
use crate::expansion::Expanded;
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Parameter, Precision};
use crate::program::interpret::Interpreter;
use crate::program::{Input, Program, passes};
use crate::request::{After, Feedback, Guard, Spec, What};

/// A linear design with all its numbers.
pub(crate) struct Numbers<'a> {
    spec: &'a Spec,
    pub(crate) tau: f64,
    expanded: Option<&'a Expanded>,
    /// Its law, made where it is asked for: one in samples has no continuous time.
    linear: OnceCell<Program>,
    /// The same mapping under a law that only looks at xi and stretched time.
    observer: OnceCell<Program>,
}

impl<'a> Numbers<'a> {
    /// The numbers of a spec that lacks none.
    pub(crate) fn new(spec: &'a Spec, expanded: Option<&'a Expanded>) -> Self {
        let tau = spec.fixed.get(&Parameter::Tau).and_then(to_f64).unwrap_or(f64::NAN);
        Self { spec, tau, expanded, linear: OnceCell::new(), observer: OnceCell::new() }
    }

    /// The program of the design with another law.
    fn program(&self, feedback: Feedback) -> Program {
        let mut linear = Spec {
            feedback,
            precision: Precision::F64,
            guard: Guard::None,
            what: What::Controller,
            drift: None,
            input_gain: None,
            reference: None,
            model: None,
            coupled: None,
            larger: None,
            after: After::Hold,
            ..self.spec.clone()
        };
        // The guard is what is sought: nothing is held here.
        linear.fixed.remove(&Parameter::Eps);
        passes::optimise(lower(&linear, &Law::from(&linear, self.expanded)), &mut |_, _| {})
    }

    fn input(&self, input: Input, time_to_go: f64, state: &dyn Fn(usize) -> f64) -> f64 {
        match input {
            Input::Parameter(Parameter::Eps) => 0.0,
            Input::Parameter(p) => self.spec.fixed.get(&p).and_then(to_f64).unwrap_or(0.0),
            // The deadline is at 0, so that time is -T without a rounding.
            Input::StartTime => -self.tau,
            Input::Time => -time_to_go,
            Input::State(j) | Input::StateAtStart(j) => state(j),
            Input::Reference(_)
            | Input::ReferenceOf(..)
            | Input::Gain(_)
            | Input::Divisor
            | Input::Drift
            | Input::Control
            | Input::Wanted(_) => f64::NAN,
        }
    }

    /// Feedback gains of u = sum gain_j x_j.
    pub(crate) fn gains(&self, time_to_go: f64) -> Vec<f64> {
        let input = |input| self.input(input, time_to_go, &|_| 0.0);
        let linear = self.linear.get_or_init(|| self.program(self.spec.feedback.clone()));
        let mut interpreter = Interpreter::new(linear, &input);
        linear.gains.iter().map(|gain| interpreter.value(*gain)).collect()
    }

    /// Gains k_1..k_n of the law in stretched time.
    pub(super) fn feedback(&self) -> Vec<f64> {
        let gain = |i| self.spec.fixed.get(&Parameter::Gain(i)).and_then(to_f64);
        (1..=self.spec.n).map(|i| gain(i).unwrap_or(f64::NAN)).collect()
    }

    /// xi for the state that is 1 in x_2 and 0 elsewhere, and stretched time.
    fn observed(&self, time_to_go: f64) -> Vec<f64> {
        let seen = RefCell::new(Vec::new());
        let look = |arguments: &[f64]| {
            seen.borrow_mut().extend_from_slice(arguments);
            0.0
        };
        let unit = |j| f64::from(u8::from(j == 2));
        let input = |input| self.input(input, time_to_go, &unit);
        let observer = self.observer.get_or_init(|| self.program(Feedback::Extern));
        Interpreter::new(observer, &input).with_law(&look).value(observer.step);
        seen.into_inner()
    }

    /// r_1, ..., r_(n-1): the second column of BB_n, whose entries are B_{i,1} = r_i.
    pub(super) fn r(&self, time_to_go: f64) -> Vec<f64> {
        let seen = self.observed(time_to_go);
        seen.get(1..self.spec.n).map(<[f64]>::to_vec).unwrap_or_default()
    }

    /// Stretched time since the start.
    pub(super) fn stretched(&self, time_to_go: f64) -> f64 {
        // `t_kappa` counts from t0 = -tau.
        self.observed(time_to_go).last().map_or(f64::NAN, |time| time + self.tau)
    }
}
