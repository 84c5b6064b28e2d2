//! The closed loop for a simulation: the plant with the law of Theorem 1 at a state x, beside the
//! associated infinite-time system there, [th:1-4]; the way back from xi to x, [th:1-7]; and the
//! plant by itself.
//!
//! Time of the closed loop is the time-to-go T, so that no digit is lost near the deadline. Its
//! derivatives are by sigma = -ln(T/tau), the stretched time of `exp` with a = 1, which takes every
//! mapping to its deadline: dt/dsigma = T and dt_kappa/dsigma = T kappa'.

use super::builder::{Builder, PlantPoint};
use super::input_gain::over_input_gain;
use super::mapping::Taylor;
use super::plant::without_drift;
use super::{series, state};
use crate::expression::Expression;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, Least, Limits, Op, Program, Value};
use crate::request::{MAX_ORDER, Spec};

/// The closed loop as a program: inputs are T as the time, x as the state, x(t0), t0 and parameters.
#[derive(Clone, Debug)]
pub struct ClosedLoop {
    /// The program; its step is dx_n/dsigma.
    pub program: Program,
}

impl ClosedLoop {
    /// dt_kappa/dsigma, so that dxi_i/dsigma is this times xi_{i+1}.
    pub fn pace(&self) -> Value {
        self.program.watched[0]
    }

    /// dxi_n/dsigma.
    pub fn associated(&self) -> Value {
        self.program.watched[1]
    }

    /// Stretched time since the start, kappa(Dt).
    pub fn stretched(&self) -> Value {
        self.program.watched[2]
    }

    /// u, clipped to u_max.
    pub fn control(&self) -> Value {
        self.program.watched[3]
    }

    /// u before it is clipped from below, and before it is clipped at all.
    pub fn wanted(&self) -> [Value; 2] {
        [self.program.watched[4], self.program.watched[5]]
    }

    /// g u of the law, before it is clipped.
    pub fn free(&self) -> Value {
        self.program.watched[6]
    }

    /// The states of the other side of Theorem 1: xi_1..xi_n of a loop in x, and x_1..x_n of one in xi.
    pub fn other(&self) -> &[Value] {
        &self.program.watched[7..]
    }
}

/// The closed loop of the law of `spec` with the plant xn' = f + g u; without `g` it is the
/// controller's own.
pub fn closed_loop(spec: &Spec, f: &Expression, g: Option<&Expression>) -> ClosedLoop {
    let mut b = Builder::new(spec);
    let states: Vec<_> = (1..=spec.n).map(|j| b.push(Op::Input(Input::State(j)))).collect();
    b.plant = Some(PlantPoint { states: states.clone(), control: None });
    let taylor = b.taylor();
    let xi = (1..=spec.n).map(|j| b.xi(j)).collect();
    let law = state::law(&mut b);
    let free = series::wanted(&mut b, &taylor, law, &|b, j| {
        let x = b.coordinate(j);
        (1..j).fold(x, |x, _| b.mul(x, taylor.r1))
    });
    of_law(b, &taylor, (law, free), (states, xi), (f, g))
}

/// The same with xi as the state, whose rates take x on their way.
pub fn associated_loop(spec: &Spec, f: &Expression, g: Option<&Expression>) -> ClosedLoop {
    let mut b = Builder::new(spec);
    b.plant = Some(PlantPoint::default());
    let taylor = b.taylor();
    let law = state::law(&mut b);
    let scaled = series::scaled_states(&mut b, &taylor);
    let free = series::wanted(&mut b, &taylor, law, &|_, j| scaled[j - 1]);
    let x = states(&mut b, &scaled, taylor.base_inverse);
    b.plant = Some(PlantPoint { states: x.clone(), control: None });
    of_law(b, &taylor, (law, free), (x.clone(), x), (f, g))
}

/// The loop of a `law`, and of the g u that it wants, at the states of the plant, with those of the
/// `other` side.
fn of_law(
    mut b: Builder<'_>,
    taylor: &Taylor,
    (law, free): (Value, Value),
    (states, other): (Vec<Value>, Vec<Value>),
    (f, g): (&Expression, Option<&Expression>),
) -> ClosedLoop {
    let spec = b.spec;
    let less = without_drift(&mut b, free);
    let wanted = over_input_gain(&mut b, less);
    let (below, control) = clipped(&mut b, wanted);
    b.plant = Some(PlantPoint { states, control: Some(control) });
    // What is left of f where its known part is cancelled, so that nothing is subtracted from itself.
    let own = spec.drift.as_ref();
    let (f, left) = match own {
        None => {
            let f = b.scalar(f);
            (f, f)
        }
        Some(own) => {
            let left = if own == f { b.integer(0) } else { b.scalar(&f.clone().sub(own.clone())) };
            (b.scalar(f), left)
        }
    };
    let acceleration = gained(&mut b, g.or(spec.input_gain.as_ref()), control);
    let motion = b.add(f, acceleration);
    let added = match g.is_none() || g == spec.input_gain.as_ref() {
        true if control == wanted => left,
        true => {
            let missing = b.sub(control, wanted);
            let missing = gained(&mut b, spec.input_gain.as_ref(), missing);
            b.add(left, missing)
        }
        false => {
            let other = b.sub(acceleration, less);
            b.add(left, other)
        }
    };
    let order = u32::try_from(spec.n).unwrap_or(u32::MAX);
    let slope = b.power(taylor.r1, order);
    let drift = b.mul(slope, added);
    let last = b.add(drift, law);
    let time_to_go = b.time_to_go();
    let pace = b.mul(time_to_go, taylor.base_inverse);
    let associated = b.mul(pace, last);
    let rate = b.mul(time_to_go, motion);
    let mut watched = vec![pace, associated, taylor.stretched, control, below, wanted, free];
    watched.extend(other);
    let limits = no_limits(&mut b);
    let program = Program { watched, ..b.finish(rate, limits) };
    ClosedLoop { program }
}

/// x_1..x_n, all watched, of T as the time and xi as the state.
pub fn mapped_back(spec: &Spec) -> Program {
    let mut b = Builder::new(spec);
    b.plant = Some(PlantPoint::default());
    let taylor = b.taylor();
    let scaled = series::scaled_states(&mut b, &taylor);
    let watched = states(&mut b, &scaled, taylor.base_inverse);
    let limits = no_limits(&mut b);
    let step = limits.late;
    Program { watched, ..b.finish(step, limits) }
}

/// The plant by itself: the `rates` of its states, of the states, the time and the control, all watched.
pub fn plant(spec: &Spec, rates: &[Expression]) -> Program {
    let mut b = Builder::new(spec);
    let watched = rates.iter().map(|rate| b.scalar(rate)).collect();
    let limits = no_limits(&mut b);
    let step = limits.late;
    Program { watched, ..b.finish(step, limits) }
}

/// `expressions` of the plant's time, state and inputs, all watched: inputs are T as the time, x as
/// the state, and u, of which several stand behind x, and behind these what is accumulated along the run.
pub fn observed(spec: &Spec, expressions: &[&Expression]) -> Program {
    let mut b = Builder::new(spec);
    let states =
        (1..=spec.variables() + MAX_ORDER).map(|j| b.push(Op::Input(Input::State(j)))).collect();
    b.plant = Some(PlantPoint { states, control: None });
    let watched = expressions.iter().map(|expression| b.scalar(expression)).collect();
    let limits = no_limits(&mut b);
    let step = limits.late;
    Program { watched, ..b.finish(step, limits) }
}

/// x_j = r_1^-(j-1) times its scaled value, with the reference that it follows.
pub(super) fn states(b: &mut Builder<'_>, scaled: &[Value], base_inverse: Value) -> Vec<Value> {
    let power = |b: &mut Builder<'_>, (j, scaled): (usize, &Value)| {
        let x = (0..j).fold(*scaled, |x, _| b.mul(x, base_inverse));
        b.reference(j).map_or(x, |wanted| b.add(x, wanted))
    };
    scaled.iter().enumerate().map(|one| power(b, one)).collect()
}

/// u within its limits, where these are no infinities: clipped from above, and from both sides.
fn clipped(b: &mut Builder<'_>, wanted: Value) -> (Value, Value) {
    let (most, least) = limits_of_u(b);
    let below = most.map_or(wanted, |most| b.push(Op::Min(wanted, most)));
    let least = match (least, most) {
        (Least::Own(least), _) => Some(least),
        (Least::Opposite, Some(most)) => Some(b.push(Op::Neg(most))),
        (Least::Opposite, None) | (Least::Infinite, _) => None,
    };
    (below, least.map_or(below, |least| b.push(Op::Max(below, least))))
}

/// The limits of u, as parameters.
pub(super) fn limits_of_u(b: &mut Builder<'_>) -> (Option<Value>, Least) {
    let fixed = |b: &Builder<'_>, parameter| b.spec.fixed.get(&parameter).cloned();
    let most = match fixed(b, Parameter::UMax) {
        Some(Fixed::Infinite) => None,
        _ => Some(b.parameter(Parameter::UMax)),
    };
    let least = match fixed(b, Parameter::UMin) {
        _ if !b.spec.u_min => Least::Opposite,
        Some(Fixed::MinusInfinite) => Least::Infinite,
        _ => Least::Own(b.parameter(Parameter::UMin)),
    };
    (most, least)
}

/// gain * value, where none is 1.
fn gained(b: &mut Builder<'_>, gain: Option<&Expression>, value: Value) -> Value {
    match gain {
        Some(gain) => {
            let gain = b.scalar(gain);
            b.mul(gain, value)
        }
        None => value,
    }
}

pub(super) fn no_limits(b: &mut Builder<'_>) -> Limits {
    let zero = b.integer(0);
    Limits {
        start_time: None,
        u_max: None,
        u_min: Least::Opposite,
        past: None,
        late: zero,
        hold_from: zero,
        eps: zero,
        elapsed: None,
    }
}
