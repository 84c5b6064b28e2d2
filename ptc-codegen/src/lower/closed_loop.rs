//! The closed loop for a simulation: the associated infinite-time system, [th:1-4], with the way back
//! to the plant, [th:1-7]; and the plant by itself.
//!
//! Time of the closed loop is the time-to-go T, so that no digit is lost near the deadline, and its
//! state is xi. Its derivatives are by sigma = -ln(T/tau), the stretched time of `exp` with a = 1,
//! which takes every mapping to its deadline: dt_kappa/dsigma = T kappa'.

use super::builder::{Builder, PlantPoint};
use super::{series, state};
use crate::expression::Expression;
use crate::program::{Input, Limits, Op, Program, Value};
use crate::spec::{Fixed, Parameter, Spec};

/// The closed loop as a program: inputs are T as the time, xi as the state, x(t0), t0 and parameters.
#[derive(Clone, Debug)]
pub struct ClosedLoop {
    /// The program; its step is dxi_n/dsigma.
    pub program: Program,
    n: usize,
}

impl ClosedLoop {
    /// dt_kappa/dsigma, so that dxi_i/dsigma is this times xi_{i+1}.
    pub fn pace(&self) -> Value {
        self.program.watched[0]
    }

    /// u, clipped to u_max.
    pub fn control(&self) -> Value {
        self.program.watched[1]
    }

    /// Stretched time since the start, kappa(Dt).
    pub fn stretched(&self) -> Value {
        self.program.watched[2]
    }

    /// x_1..x_n.
    pub fn states(&self) -> &[Value] {
        &self.program.watched[3..3 + self.n]
    }

    /// xi_1..xi_n at the start.
    pub fn xi_at_start(&self) -> &[Value] {
        &self.program.watched[3 + self.n..]
    }
}

/// The closed loop of the law of `spec` with the plant xn' = f + g u; without `g` it is the
/// controller's own.
pub fn closed_loop(spec: &Spec, f: &Expression, g: Option<&Expression>) -> ClosedLoop {
    let mut b = Builder::new(spec);
    b.plant = Some(PlantPoint::default());
    let taylor = b.taylor();
    let scaled = series::scaled_states(&mut b, &taylor);
    let states = states(&mut b, &scaled, taylor.base_inverse);
    b.plant = Some(PlantPoint { states: states.clone(), control: None });
    let law = state::law(&mut b);
    let sum = series::drift_rows(&mut b, &taylor).into_iter().zip(&scaled).fold(
        law,
        |sum, (row, scaled)| match row {
            Some(row) => {
                let term = b.mul(row, *scaled);
                b.add(sum, term)
            }
            None => sum,
        },
    );
    let free = (0..spec.n).fold(sum, |u, _| b.mul(u, taylor.base_inverse));
    let wanted = super::over_input_gain(&mut b, free);
    let control = clipped(&mut b, wanted);
    b.plant = Some(PlantPoint { states: states.clone(), control: Some(control) });
    let drift = drift(&mut b, f, g, (free, wanted, control));
    let order = u32::try_from(spec.n).unwrap_or(u32::MAX);
    let slope = b.power(taylor.r1, order);
    let drift = b.mul(slope, drift);
    let last = b.add(drift, law);
    let time_to_go = b.time_to_go();
    let pace = b.mul(time_to_go, taylor.base_inverse);
    let rate = b.mul(pace, last);
    let mut watched = vec![pace, control, taylor.stretched];
    watched.extend(states);
    watched.extend((1..=spec.n).map(|j| b.xi_at_start(j)));
    let limits = no_limits(&mut b);
    let program = Program { watched, ..b.finish(rate, Vec::new(), None, limits) };
    ClosedLoop { program, n: spec.n }
}

/// The plant by itself: its step is f + g u, of the states, the time and the control.
pub fn plant(spec: &Spec, f: &Expression, g: Option<&Expression>) -> Program {
    let mut b = Builder::new(spec);
    let control = b.push(Op::Input(Input::Control));
    let drift = b.scalar(f);
    let acceleration = gained(&mut b, g.or(spec.input_gain.as_ref()), control);
    let sum = b.add(drift, acceleration);
    let limits = no_limits(&mut b);
    b.finish(sum, Vec::new(), None, limits)
}

/// `expressions` of the plant's time, state and control, all watched: inputs are T as the time, x as
/// the state, and u.
pub fn observed(spec: &Spec, expressions: &[&Expression]) -> Program {
    let mut b = Builder::new(spec);
    let states = (1..=spec.n).map(|j| b.push(Op::Input(Input::State(j)))).collect();
    b.plant = Some(PlantPoint { states, control: None });
    let watched = expressions.iter().map(|expression| b.scalar(expression)).collect();
    let limits = no_limits(&mut b);
    let step = limits.late;
    Program { watched, ..b.finish(step, Vec::new(), None, limits) }
}

/// x_j = r_1^-(j-1) times its scaled value.
fn states(b: &mut Builder<'_>, scaled: &[Value], base_inverse: Value) -> Vec<Value> {
    let power = |b: &mut Builder<'_>, (j, scaled): (usize, &Value)| {
        (0..j).fold(*scaled, |x, _| b.mul(x, base_inverse))
    };
    scaled.iter().enumerate().map(|one| power(b, one)).collect()
}

/// u within u_max, where that is no infinity.
fn clipped(b: &mut Builder<'_>, wanted: Value) -> Value {
    if matches!(b.spec.fixed.get(&Parameter::UMax), Some(Fixed::Infinite)) {
        return wanted;
    }
    let most = b.parameter(Parameter::UMax);
    let least = b.push(Op::Neg(most));
    let below = b.push(Op::Min(wanted, most));
    b.push(Op::Max(below, least))
}

/// What moves the plant beside the u of the law: f, and what the actuator and a gain that differs
/// from the controller's add to it.
fn drift(
    b: &mut Builder<'_>,
    f: &Expression,
    g: Option<&Expression>,
    (free, wanted, control): (Value, Value, Value),
) -> Value {
    let spec = b.spec;
    let own = spec.input_gain.as_ref();
    let drift = b.scalar(f);
    let same = g.is_none() || g == own;
    let added = if same && control == wanted {
        return drift;
    } else if same {
        let missing = b.sub(control, wanted);
        gained(b, own, missing)
    } else {
        let true_u = gained(b, g, control);
        b.sub(true_u, free)
    };
    b.add(drift, added)
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

fn no_limits(b: &mut Builder<'_>) -> Limits {
    let zero = b.integer(0);
    Limits { start_time: None, u_max: None, past: None, late: zero, hold_from: zero, eps: zero }
}
