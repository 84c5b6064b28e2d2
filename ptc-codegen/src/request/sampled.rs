//! The request for a controller whose clock is in samples.

use std::sync::Arc;

use num_traits::{One, ToPrimitive, Zero};

use super::{Clock, EndLaw, Feedback, Flight, Keep, Observer, Spec};
use crate::algebra::BigRational;
use crate::expression::Expression;
use crate::expression::normal::normal;
use crate::linear::{
    Chains, Delay, Demand, Disturbance, Following, Linear, Matrix, Pair, Schedule, Several,
    Unscheduled, Weights,
};
use crate::model::{Coupled, Model};
use crate::parameter::{Fixed, Parameter};

/// Values that a controller in samples needs besides the law.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sampled {
    /// The time between a measurement and the input that follows from it.
    pub delay: Delay,
    /// The way in which the law knows the inputs under way.
    pub delay_law: DelayLaw,
    /// The plant where it is not a chain.
    pub linear: Option<Linear>,
    /// State and input for which its output follows a reference.
    pub follows: Option<Following>,
    /// A linear plant with several inputs, sampled exactly.
    pub exact: Option<Box<Exact>>,
    /// Constant input gain g of a chain.
    pub gain: BigRational,
    /// Values that are measured: x1..x_m of a chain, y = C x of another plant.
    pub measured: usize,
    /// What is added to u, and is estimated and cancelled.
    pub disturbance: Option<Disturbance>,
    /// The exponents of the controller; `None` if gains or a are open.
    pub exponents: Option<Exponents>,
    /// True if the plant is known at its samples alone, and is to be at rest some samples early.
    pub early: bool,
    /// The law that takes over towards the end, where it is given or chosen.
    pub end: Option<EndLaw>,
    /// The observer; `None` if every state is measured.
    pub observer: Option<Observer>,
    /// Changes while it runs; `None` where its deadline is that of `arm`.
    pub flight: Option<Flight>,
    /// The bounds that a filter keeps.
    pub keep: Option<Keep>,
    /// True if the law of the delay follows from the poles because it was left open.
    pub leaves_delay_law: bool,
    /// True if eps is 0 because it was left open.
    pub leaves_eps: bool,
}

/// The plant for which a law plans.
///
/// A delay is one of two loops. Extended, the inputs under way are states of it. Predicted, it is the plant alone, of
/// the x at the time from which the input of now acts: those inputs determine it,
/// x = Phi(delay) x_k + sum_i Gamma_i u_{k-i}.
pub(crate) struct Planned {
    /// The plant.
    pub(crate) pair: Pair,
    /// Its states, by those of now and the inputs under way.
    pub(crate) reach: Matrix,
    /// Powers of the period in the units of these.
    pub(crate) powers: Vec<i64>,
}

/// The law of a loop with a delay.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DelayLaw {
    /// That of a loop of a higher order, in which the inputs under way are states.
    Extend,
    /// That of the plant alone, of the state predicted for the time from which the input acts.
    Predict,
}

impl DelayLaw {
    /// The name of the law of a higher order.
    pub(crate) const EXTEND: &str = "extend";

    /// The name of the law that predicts.
    pub(crate) const PREDICT: &str = "predict";

    /// Returns its name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Extend => Self::EXTEND,
            Self::Predict => Self::PREDICT,
        }
    }

    /// Returns the states that a delay of so many inputs under way adds to the loop.
    pub(crate) fn states(self, inputs: usize) -> usize {
        match self {
            Self::Extend => inputs,
            Self::Predict => 0,
        }
    }
}

/// A linear plant with several inputs, and the chains of its outputs that inputs move exactly which are held for a
/// sample.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exact {
    /// The plant in numbers.
    pub plant: Several,
    /// Its chains, and the inputs that move them.
    pub chains: Chains,
    /// The same as expressions, in place of the outputs with their derivatives.
    pub coupled: Coupled,
}

/// The exponents p = -pole/a of a law with fixed gains.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exponents {
    /// The least real part; where no poles are given, the integer at or below it.
    pub least: BigRational,
    /// The greatest real part; where no poles are given, the integer at or above it.
    pub greatest: BigRational,
    /// True if they are consecutive integers.
    pub consecutive: bool,
}

impl Sampled {
    /// Every parameter of the controller of `spec`, in the order in which it is emitted.
    pub(super) fn parameters(&self, spec: &Spec) -> Vec<Parameter> {
        use Parameter::{A, Deadbeat, Eps, Gain, SampleTime, Samples, UMax, UMin};
        if self.keep.is_some() {
            let limits = spec.u_min.then_some(UMin);
            return [Samples, SampleTime, UMax].into_iter().chain(limits).collect();
        }
        let mut all = vec![Samples, SampleTime, Eps, UMax];
        all.extend(spec.u_min.then_some(UMin));
        all.push(A);
        if spec.schedule().is_some() {
            return all;
        }
        all.extend((1..=spec.n + self.late_states()).map(Gain));
        // Known exponents need none, or give the end of their law.
        all.extend(self.exponents.is_none().then_some(Deadbeat));
        all
    }

    /// The plant of order `n` for which its law plans, sampled with period `h`; `None` where the period is too long for
    /// its modes, or one that is not a chain has none.
    pub(crate) fn planned(&self, n: usize, h: Option<&BigRational>) -> Option<Planned> {
        let (part, inputs) = (self.delay.part(), self.delay.inputs());
        let pair = match &self.linear {
            Some(plant) => Pair::linear(plant, h?, &part)?,
            None => Pair::chain(n, &self.gain, &part),
        };
        let late = pair.delayed(inputs);
        if !self.predicts() {
            return Some(Planned {
                reach: Matrix::identity(late.order()),
                powers: late.powers.clone(),
                pair: late,
            });
        }
        let part = match &self.linear {
            Some(plant) => Pair::linear(plant, &(h? * part), &BigRational::one())?,
            None => pair.over(&part),
        };
        Some(Planned { reach: pair.predicted(inputs, &part), powers: late.powers, pair })
    }

    /// The gains of least energy of its linear plant, in a table of at most so many bytes; `None` where tau or the
    /// period is no number.
    pub(crate) fn gains(
        &self,
        spec: &Spec,
        weights: Weights,
        bytes: Option<u32>,
    ) -> Option<Result<Schedule, Unscheduled>> {
        let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number);
        let samples = number(Parameter::Samples)?.to_u32()?;
        let planned = self.planned(spec.n, Some(number(Parameter::SampleTime)?))?;
        let demand = Demand {
            phi: &planned.pair.phi,
            gamma: &planned.pair.gamma,
            weights,
            samples: self.flight.as_ref().map_or(samples, |flight| flight.reach(samples)),
            most: bytes.map(|bytes| bytes as usize / spec.precision.bytes()),
        };
        Some(demand.schedule().map(|schedule| Schedule { bytes, ..schedule }))
    }

    /// The middle of the time in which the input of this sample acts, and of those of the inputs under way, the
    /// latest first, in samples from now.
    pub fn middles(&self) -> impl Iterator<Item = BigRational> {
        let whole = |count: usize| BigRational::from_integer(count.into());
        let half = BigRational::new(1.into(), 2.into());
        let inputs = self.delay.inputs();
        let latest = self.delay.part() + whole(inputs) - half;
        (0..=inputs).map(move |age| &latest - whole(age))
    }

    /// Returns the reference of the states, and r^(n) of a chain or the input on the reference, from r, r', ..., r^(n).
    pub fn followed(&self, derivatives: &[Expression]) -> Vec<Expression> {
        let Some(follows) = &self.follows else { return derivatives.to_vec() };
        let term = |(weight, r): (&BigRational, &Expression)| {
            Expression::from(weight.clone()).mul(r.clone())
        };
        let sum = |row: &Vec<BigRational>| {
            let terms =
                row.iter().zip(derivatives).filter(|(weight, _)| !weight.is_zero()).map(term);
            terms.reduce(Expression::add).unwrap_or_else(|| Expression::integer(0))
        };
        follows.rows().iter().map(sum).collect()
    }

    /// The letters of what the states follow and of what the inputs count less: x_r and u_r, where the reference is
    /// not that of the states.
    pub fn followed_letters(&self) -> [&'static str; 2] {
        if self.follows.is_some() { ["x_r", "u_r"] } else { ["reference", "rho"] }
    }

    /// Returns the states that the delay adds to the loop.
    pub(crate) fn late_states(&self) -> usize {
        self.delay_law.states(self.delay.inputs())
    }

    /// Returns true if the law is that of a predicted state.
    pub(crate) fn predicts(&self) -> bool {
        self.delay_law == DelayLaw::Predict && self.delay.inputs() > 0
    }

    /// Returns true if there is an observer.
    pub fn observes(&self) -> bool {
        self.observer.is_some()
    }

    /// Returns true if a reading that is not believed leaves the estimates as they are predicted.
    pub fn coasts(&self) -> bool {
        self.observer.as_ref().is_some_and(|observer| observer.gate.coasts())
    }

    /// The number of the first state that an observer estimates: of a chain the last one measured.
    pub fn first_estimated(&self) -> usize {
        if self.linear.is_some() { 1 } else { self.measured }
    }

    /// Returns true if the state itself is measured.
    pub fn measures_states(&self) -> bool {
        !self.observes() && self.linear.as_ref().is_none_or(Linear::measures_states)
    }

    /// The minimum N with which the loop of a plant of order `n` can end at rest.
    pub fn least_samples(&self, n: usize) -> u32 {
        let count = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        let order = count(n + self.delay.inputs());
        match self.observer.as_ref().and_then(|observer| observer.round.as_ref()) {
            None => order,
            Some(round) => match round.samples {
                Some(samples) => samples.saturating_add(order),
                None => 2 * order.max(count(round.poles.len())),
            },
        }
    }

    /// Samples after which the estimates are exact, where they are given.
    pub fn observer_samples(&self) -> Option<u32> {
        self.observer.as_ref().and_then(Observer::samples)
    }
}

impl Spec {
    /// Order of the loop that the gains close: a sample of delay is a state more, unless the law predicts over it.
    pub fn loop_order(&self) -> usize {
        match &self.clock {
            Clock::Time => self.n,
            Clock::Samples(sampled) => self.n + sampled.late_states(),
        }
    }

    /// Makes the law that of a table of gains.
    pub(crate) fn follow(&mut self, schedule: Schedule) {
        self.feedback = Feedback::LeastEnergy(Arc::new(schedule));
        self.poles.clear();
        self.fixed.retain(|p, _| !matches!(p, Parameter::Gain(_) | Parameter::Deadbeat));
    }

    /// The gains of the law by the samples to go, where it has a table of them.
    pub fn schedule(&self) -> Option<&Schedule> {
        match &self.feedback {
            Feedback::LeastEnergy(schedule) => Some(schedule),
            Feedback::Linear | Feedback::Expression(_) | Feedback::Extern => None,
        }
    }

    /// Returns the number of measurements that a call is given: y1..y_m.
    pub fn measurements(&self) -> usize {
        let all = || if self.larger.is_some() { self.n } else { self.states() };
        self.sampled().map_or_else(all, |own| own.measured)
    }

    /// Returns the values of a controller in samples; `None` if the clock is time.
    pub fn sampled(&self) -> Option<&Sampled> {
        match &self.clock {
            Clock::Time => None,
            Clock::Samples(sampled) => Some(sampled),
        }
    }

    /// The input gain of a chain, where the fixed parameters make a number other than 0 of it; 1 without one.
    pub(crate) fn known_gain(&self) -> Option<BigRational> {
        let gain = self.input_gain.as_ref().unwrap_or(&Expression::integer(1)).clone();
        let known = gain.known(&|p| self.fixed.get(&p).and_then(Fixed::number).cloned());
        normal(&known).number().filter(|gain| !gain.is_zero()).cloned()
    }

    /// f where it is a known number, 0 without one; `None` where it depends on more than fixed parameters.
    pub(crate) fn known_force(&self) -> Option<BigRational> {
        let Some(force) = &self.drift else { return Some(BigRational::default()) };
        let known = force.known(&|p| self.fixed.get(&p).and_then(Fixed::number).cloned());
        normal(&known).number().cloned()
    }

    /// The model whose f and g a controller in samples knows at the samples alone: one that is not linear.
    pub fn model_in_samples(&self) -> Option<&Model> {
        self.model.as_deref().filter(|_| self.sampled().is_some())
    }

    /// The linear plant with several inputs that is sampled exactly.
    pub fn sampled_exactly(&self) -> Option<&Exact> {
        self.decoupled()?;
        self.sampled()?.exact.as_deref()
    }

    /// Returns true if the states of a linear plant follow a reference of its output.
    pub fn states_follow(&self) -> bool {
        self.sampled().is_some_and(|own| own.follows.is_some())
    }

    /// Returns true if eps is left to the checks.
    pub fn leaves_eps(&self) -> bool {
        match self.sampled() {
            Some(sampled) => sampled.leaves_eps,
            None => !self.fixed.contains_key(&Parameter::Eps),
        }
    }

    /// Sets the eps that was left open.
    pub(crate) fn choose_eps(&mut self, eps: Fixed) {
        self.fixed.insert(Parameter::Eps, eps);
        if let Clock::Samples(sampled) = &mut self.clock {
            sampled.leaves_eps = false;
        }
    }
}
