//! Position of the poles of a linear law in the complex plane, and the region that the check `growth` requires.

use num_traits::ToPrimitive;

use super::known::{decay, fixed_gains};
use crate::algebra::BigRational;
use crate::algebra::polynomial::Polynomial;
use crate::linear::{Complex, roots};
use crate::request::{Feedback, Spec};

/// The poles of the loop in stretched time, and the lines that they have to be left of.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// The poles.
    pub poles: Vec<Complex>,
    /// Left of it the state vanishes at the deadline, -(n-1) rho; `None` where rho is not known.
    pub state: Option<f64>,
    /// Left of it the control vanishes too, -n rho.
    pub control: Option<f64>,
}

/// The plane of a law whose gains are fixed; `None` for every other law.
pub fn plane(spec: &Spec) -> Option<Plane> {
    if spec.feedback != Feedback::Linear || !spec.has_law() {
        return None;
    }
    // In samples the order counts the samples of delay, as in the check.
    let spec = &Spec { n: spec.loop_order(), ..spec.clone() };
    let poles = match spec.poles.as_slice() {
        [] => roots(&Polynomial::characteristic(&fixed_gains(spec)?))?,
        poles => {
            let near = |value: &BigRational| value.to_f64().unwrap_or(f64::NAN);
            poles.iter().map(|(re, im)| Complex::new(near(re), near(im))).collect()
        }
    };
    let rate = decay(spec).greatest().and_then(|rate| rate.to_f64());
    let order = spec.n.to_f64().unwrap_or(f64::NAN);
    let line = |times: f64| rate.map(|rate| -times * rate);
    Some(Plane { poles, state: line(order - 1.0), control: line(order) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::family::Family;
    use crate::parameter::{Fixed, Parameter};
    use crate::syntax::number;

    fn fixed(text: &str) -> Fixed {
        number(text).expect("a number")
    }

    #[test]
    fn plane_shows_poles_of_gains_and_lines_of_the_rate() {
        let mut spec = Spec::new(2, Family::Tanh);
        assert_eq!(plane(&spec), None, "gains are left to run time");
        spec.fixed.insert(Parameter::Gain(1), fixed("20"));
        spec.fixed.insert(Parameter::Gain(2), fixed("9"));
        let open = plane(&spec).expect("a plane");
        assert_eq!((open.state, open.control), (None, None));
        let mut re: Vec<_> = open.poles.iter().map(|pole| pole.re).collect();
        re.sort_by(f64::total_cmp);
        assert!((re[0] + 5.0).abs() < 1e-12 && (re[1] + 4.0).abs() < 1e-12, "{re:?}");
        spec.fixed.insert(Parameter::A, fixed("0.5"));
        let known = plane(&spec).expect("a plane");
        assert_eq!((known.state, known.control), (Some(-1.0), Some(-2.0)), "rho = 2 a");
    }
}
