//! The associated infinite-time system in stretched time t: xi_i' = xi_{i+1}, xi_n' = mu'^n f + pi0(xi, t),
//! [th:1-4], and the ways between it and the plant: x = BB_n[mu] xi, u and time at mu, [th:1-5] to
//! [th:1-8], and xi(t0) = BB_n[kappa](0) x(t0). What is lowered as the step is xi_n'.

use super::builder::{Builder, PlantPoint};
use super::closed_loop::states;
use super::plant::control;
use super::{series, state};
use crate::expression::Variable;
use crate::law::Law;
use crate::program::{Input, Least, Limits, Op, Program, Value};
use crate::request::Spec;

/// The values of the program beside xi_n'.
pub(crate) struct Plant<'a> {
    /// x_1..x_n at mu(t).
    pub(crate) states: &'a [Value],
    /// u there, before it is clipped.
    pub(crate) control: Value,
    /// Its time.
    pub(crate) time: Value,
    /// xi_1..xi_n at the start, of the plant's state there.
    pub(crate) start: &'a [Value],
}

impl<'a> Plant<'a> {
    /// Returns the values of the associated system; `None` for another program.
    pub(crate) fn of(program: &'a Program) -> Option<Self> {
        let order = program.watched.len().checked_sub(2)? / 2;
        let (states, rest) = program.watched.split_at_checked(order)?;
        let ([control, time], start) = rest.split_first_chunk()?;
        Some(Self { states, control: *control, time: *time, start })
    }

    /// Returns the values that a call at a time computes.
    pub(crate) fn at_a_time(&self) -> Vec<Value> {
        [self.states, &[self.control, self.time]].concat()
    }
}

/// The program of the associated system; `None` if mu is not found in closed form.
pub(super) fn lower(spec: &Spec, law: &Law) -> Option<Program> {
    let complement = spec.time_mapping.complement()?;
    let mut b = Builder::of(spec, law);
    b.follow(complement.clone());
    let slope = complement.derivative(Variable::SinceStart).neg();
    let slope = b.scalar(&slope);
    let slope = b.name(slope, "r1", "mu' at this time");
    let factor = b.power(slope, u32::try_from(spec.n).unwrap_or(u32::MAX));
    let drift = b.push(Op::Input(Input::Drift));
    let drift = b.mul(factor, drift);
    let law = state::law(&mut b);
    let last = b.add(drift, law);
    let mut watched = of_plant(&mut b, law);
    b.plant = None;
    watched.extend((1..=spec.n).map(|j| b.xi_at_start(j)));
    let start_time = Some(b.push(Op::Input(Input::StartTime)));
    let zero = b.integer(0);
    let limits = Limits {
        start_time,
        u_max: None,
        u_min: Least::Opposite,
        past: None,
        late: zero,
        hold_from: zero,
        eps: zero,
        elapsed: None,
    };
    Some(Program { watched, ..b.finish(last, limits) })
}

/// x_1..x_n, u and the time of the plant, for the value `law` of pi0.
fn of_plant(b: &mut Builder<'_>, law: Value) -> Vec<Value> {
    let taylor = b.taylor();
    let scaled = series::scaled_states(b, &taylor);
    let mut watched = states(b, &scaled, taylor.base_inverse);
    let free = series::wanted(b, &taylor, law, &|_, j| scaled[j - 1]);
    b.plant = Some(PlantPoint { states: watched.clone(), control: None });
    watched.push(control(b, free));
    watched.push(b.time_of_plant());
    watched
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Place;
    use crate::parameter::Parameter;
    use crate::program::interpret::Interpreter;
    use crate::program::passes;
    use crate::request::{Entry, read};
    use crate::syntax::parse;

    /// xi_2' at t = 0.9 with t0 = 0.2, tau = 2, a = 0.75, m = 1.5, rates 0.75 and 2.
    fn rate(mapping: (&str, &str), law: (&str, &str), f: f64, xi: [f64; 2]) -> f64 {
        let keys = [("n", "2"), ("what", "associated"), mapping, law];
        let entries = keys.map(|(key, text)| Entry {
            key: key.to_owned(),
            place: Place(0),
            value: parse(key, text, &mut |_| Place(0)).expect("a value"),
        });
        let spec = read(&entries).expect("a spec");
        let program = passes::optimise(crate::lower::lower(&spec, &Law::of(&spec)), &mut |_, _| {});
        let input = |input| match input {
            Input::Parameter(Parameter::Tau) => 2.0,
            Input::Parameter(Parameter::M) => 1.5,
            Input::Parameter(Parameter::Start) => 0.25,
            Input::Parameter(Parameter::Rate(2)) => 2.0,
            Input::Parameter(Parameter::Gain(i)) => [20.0, 9.0][i - 1],
            Input::Parameter(_) => 0.75,
            Input::StartTime => 0.2,
            Input::Time => 0.9,
            Input::State(j) => xi[j - 1],
            Input::StateAtStart(j) => [1.0, -3.0][j - 1],
            Input::Drift => f,
            Input::Reference(_)
            | Input::ReferenceOf(..)
            | Input::Gain(_)
            | Input::Divisor
            | Input::Control
            | Input::Wanted(_) => f64::NAN,
        };
        Interpreter::new(&program, &input).value(program.step)
    }

    #[test]
    fn drift_is_scaled_by_the_squared_slope() {
        let (y, tau, a) = (0.75f64 * 0.7, 2.0, 0.75);
        let decay = (-y).exp();
        for (mapping, slope) in [
            (("mu", "exp"), tau * a * decay),
            (("mu", "rational"), tau * a / (1.0 + y).powi(2)),
            (("mu", "power"), tau * a * (1.0 + 1.5 * y).powf(-1.0 - 1.0 / 1.5)),
            (("mu", "tan"), 2.0 * tau * a / std::f64::consts::PI / (1.0 + y * y)),
            (("mu", "tanh"), tau * a / y.cosh().powi(2)),
            (("mu", "algebraic"), tau * a * (1.0 + y * y).powf(-1.5)),
            (("mu", "soft"), {
                let root = (0.25f64.powi(2) + 3.0 * (1.0 - decay)).sqrt();
                tau * a * decay / root
            }),
            (("mu", "exp_sum"), tau * (a * decay + 2.0 * (-1.4f64).exp()) / 2.0),
            (("mu", "tau*(1 - exp(-a*t))"), tau * a * decay),
            (("kappa", "-ln(1 - dt/tau)/a"), tau * a * decay),
        ] {
            let found = rate(mapping, ("gains", "20,9"), 3.0, [0.0, 0.0]);
            let wanted = 3.0 * slope * slope;
            assert!((found - wanted).abs() < 1e-13 * wanted, "{mapping:?}: {found} {wanted}");
        }
    }

    #[test]
    fn associated_law_is_evaluated_in_stretched_time() {
        assert_eq!(rate(("mu", "exp"), ("gains", "20,9"), 0.0, [2.0, -3.0]), -13.0);
        let law = ("pi0", "xi1*t + xi2*t0 + x2_0");
        assert_eq!(rate(("mu", "exp"), law, 0.0, [2.0, -3.0]), 2.0 * 0.9 - 3.0 * 0.2 - 3.0);
        // dt is the plant's elapsed time mu(t - t0), and xi(t0) = BB_2 x(t0) holds r_1 = tau a.
        let elapsed = 2.0 * (1.0 - (-0.525f64).exp());
        let found = rate(("mu", "exp"), ("pi0", "dt + xi2_0 + xi1*0"), 0.0, [2.0, -3.0]);
        assert!((found - (elapsed - 4.5)).abs() < 1e-14, "{found}");
        // T is the plant's time-to-go, tau - mu(t - t0).
        let found = rate(("mu", "exp"), ("pi0", "T + xi1*0"), 0.0, [2.0, -3.0]);
        assert!((found - (2.0 - elapsed)).abs() < 1e-14, "{found}");
    }

    const MAPPINGS: [(&str, &str); 10] = [
        ("mu", "exp"),
        ("mu", "rational"),
        ("mu", "power"),
        ("mu", "tan"),
        ("mu", "tanh"),
        ("mu", "algebraic"),
        ("mu", "soft"),
        ("mu", "exp_sum"),
        ("mu", "tau*(1 - exp(-a*t)*(1 + a*t/3))"),
        ("kappa", "-ln(1 - dt/tau)/a"),
    ];

    /// The spec of order 3 with these keys.
    fn third(keys: &[(&str, &str)]) -> Spec {
        let all = [("n", "3"), ("eps", "1e-9"), ("u_max", "inf")];
        let entry = |(key, text): &(&str, &str)| Entry {
            key: (*key).to_owned(),
            place: Place(0),
            value: parse(key, text, &mut |_| Place(0)).expect("a value"),
        };
        read(&all.iter().chain(keys).map(entry).collect::<Vec<_>>()).expect("a spec")
    }

    fn number(input: Input, t: f64, x: [f64; 3]) -> f64 {
        match input {
            Input::Parameter(Parameter::Tau) => 2.0,
            Input::Parameter(Parameter::M) => 1.5,
            Input::Parameter(Parameter::Start) => 0.25,
            Input::Parameter(Parameter::Rate(i)) => [0.75, 2.0][i - 1],
            Input::Parameter(Parameter::Gain(i)) => [24.0, 26.0, 9.0][i - 1],
            Input::Parameter(_) => 0.75,
            Input::StartTime => 0.2,
            Input::Time => t,
            Input::State(j) | Input::StateAtStart(j) => x[j - 1],
            _ => 0.0,
        }
    }

    /// [th:1-7] against [th:1-1]: u of the associated system is that of the controller at the same state
    /// and time of the plant, for laws of both kinds and a plant with f and g.
    #[test]
    fn associated_u_equals_u_of_the_controller() {
        let laws: [&[(&str, &str)]; 3] = [
            &[("gains", "24,26,9")],
            &[("gains", "24,26,9"), ("g", "2 + sin(x1 + t)"), ("f", "x2*dt + x3")],
            &[("pi0", "-24*xi1 - sinh(xi2) - 9*xi3*t"), ("g", "3 + cos(t_kappa)")],
        ];
        let (x0, t) = ([0.7, -1.3, 0.4], 1.1);
        for mapping in MAPPINGS {
            for law in laws {
                let keys = [&[mapping], law].concat();
                let system = third(&[&keys[..], &[("what", "associated")]].concat());
                let program = crate::lower::lower(&system, &Law::of(&system));
                let program = passes::optimise(program, &mut |_, _| {});
                let plant = Plant::of(&program).expect("the way back");
                let at = |t: f64, x: [f64; 3], values: &[Value]| -> Vec<f64> {
                    let input = |input| number(input, t, x);
                    let mut interpreter = Interpreter::new(&program, &input);
                    values.iter().map(|value| interpreter.value(*value)).collect()
                };
                let of = |values: Vec<f64>| [values[0], values[1], values[2]];
                // The iteration of the mappings without a kappa ends at 1e-9, after which Newton's next step
                // is exact to 1e-17; what is left is a hundred roundings, divided by mu'^3.
                let close = |a: f64, b: f64, size: f64| (a - b).abs() <= 1e-11 * size.max(1.0);
                // At the start there and back again.
                let xi0 = of(at(0.2, x0, plant.start));
                for (back, x) in at(0.2, xi0, plant.states).iter().zip(x0) {
                    assert!(close(*back, x, 1.0), "{keys:?}: {back} {x}");
                }
                let xi = [0.6, -0.2, 0.9];
                let x = of(at(t, xi, plant.states));
                let [u, time] = at(t, xi, &[plant.control, plant.time])[..] else { panic!() };
                let controller = third(&keys);
                let own = crate::lower::lower(&controller, &Law::of(&controller));
                let input = |input| number(input, time, x);
                let wanted = Interpreter::new(&own, &input).value(own.step);
                assert!(close(u, wanted, wanted.abs()), "{keys:?}: {u} {wanted}");
            }
        }
    }
}
