//! The associated infinite-time system: xi_i' = xi_{i+1}, xi_n' = mu'^n f + pi0(xi, t), in stretched
//! time t. What is lowered is xi_n'.

use super::builder::Builder;
use super::state;
use crate::expression::Variable;
use crate::law::Law;
use crate::program::{Input, Limits, Op, Program};
use crate::request::Spec;

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
    let start_time = Some(b.push(Op::Input(Input::StartTime)));
    let zero = b.integer(0);
    let limits = Limits {
        start_time,
        u_max: None,
        past: None,
        late: zero,
        hold_from: zero,
        eps: zero,
        elapsed: None,
    };
    Some(b.finish(last, limits))
}

#[cfg(test)]
mod tests {
    use crate::diagnostic::Place;
    use crate::law::Law;
    use crate::parameter::Parameter;
    use crate::program::interpret::Interpreter;
    use crate::program::{Input, passes};
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
            Input::Reference(_) | Input::Gain(_) | Input::Divisor | Input::Control => f64::NAN,
        };
        Interpreter::new(&program, &input).value(program.step)
    }

    #[test]
    fn a_drift_enters_with_the_square_of_the_slope() {
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
    fn the_law_is_that_of_stretched_time() {
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
}
