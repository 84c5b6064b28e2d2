//! What a spec fixes, as exact numbers and as doubles.

use num_traits::{Signed, ToPrimitive};

use crate::algebra::{BigRational, integer};
use crate::check::growth::Modes;
use crate::expression::leading::{Limit, limit, limit_at_zero};
use crate::expression::normal::normal;
use crate::expression::{Expression, Function, Variable};
use crate::mapping::{Family, Form};
use crate::spec::{Feedback, Fixed, Parameter, Spec, TimeMapping, number};

/// Whether a parameter is fixed.
pub(super) fn is_known(spec: &Spec, parameter: Parameter) -> bool {
    spec.fixed.contains_key(&parameter)
}

fn exact(spec: &Spec, parameter: Parameter) -> Option<BigRational> {
    spec.fixed.get(&parameter).and_then(Fixed::number).cloned()
}

/// The gains, where all of them are fixed.
pub(super) fn fixed_gains(spec: &Spec) -> Option<Vec<BigRational>> {
    (1..=spec.n).map(|i| exact(spec, Parameter::Gain(i))).collect()
}

/// The greatest value of a parameter: the fixed one, or the greater bound. What a pole has to pass
/// grows with the rate, so the greatest decides.
fn greatest(spec: &Spec, parameter: Parameter) -> Option<BigRational> {
    let bound = spec.bounds.get(&parameter).and_then(|(_, greatest)| greatest.number().cloned());
    exact(spec, parameter).or(bound)
}

/// The greatest decay rate of mu', where it is known, and what a pole at a multiple of it does.
pub(crate) fn decay_rate(spec: &Spec) -> (Option<BigRational>, Modes) {
    match &spec.time_mapping {
        TimeMapping::Family { family: Family::Exp, .. } => {
            (greatest(spec, Parameter::A), Modes::Polynomial)
        }
        TimeMapping::Family { family: Family::Tanh, .. } => {
            (greatest(spec, Parameter::A).map(|a| a * integer(2)), Modes::Analytic)
        }
        TimeMapping::Family { family: Family::ExpSum, rates } => {
            let rates: Option<Vec<_>> =
                (1..=*rates).map(|i| greatest(spec, Parameter::Rate(i))).collect();
            (rates.and_then(|rates| rates.into_iter().min()), Modes::Other)
        }
        TimeMapping::Family { .. } => (Some(integer(0)), Modes::Other),
        TimeMapping::Custom(custom) => {
            let rate = custom.decay_rate().and_then(|rate| evaluate(spec, &rate));
            // T decays at one rate from the start to the deadline: exp in another spelling.
            let uniform = matches!(&custom.form, Form::Kappa(kappa)
                if !kappa.rate.contains(Variable::TimeToGo));
            let modes = match &rate {
                _ if uniform => Modes::Polynomial,
                Some(rate) if rate.is_positive() && !is_exponential(spec, &custom.form, rate) => {
                    Modes::Open
                }
                _ => Modes::Other,
            };
            (rate, modes)
        }
    }
}

/// Whether T e^(rate t) is found to tend to a constant other than 0.
fn is_exponential(spec: &Spec, form: &Form, rate: &BigRational) -> bool {
    let fixed = |e: &Expression| match e {
        Expression::Parameter(parameter) => exact(spec, *parameter).map(Expression::Number),
        _ => None,
    };
    let rate = Expression::Number(rate.clone());
    match form {
        Form::Complement(falling) => {
            let t = Variable::SinceStart;
            let grown = Expression::call(Function::Exp, rate.mul(t.into()));
            let scaled = normal(&falling.substitute(&fixed).mul(grown));
            let zero = Expression::integer(0);
            matches!(limit(&scaled, t), Some(Limit::Finite(value)) if normal(&value) != zero)
        }
        // T falls at kappa.rate, whose difference from the rate must vanish like T.
        Form::Kappa(kappa) => {
            let to_go = Variable::TimeToGo;
            let share = kappa.rate.substitute(&fixed).sub(rate).div(to_go.into());
            matches!(limit_at_zero(&normal(&share), to_go), Some(Limit::Finite(_)))
        }
    }
}

/// The greatest value of an expression in positive parameters that are fixed or bounded; none
/// where it falls with a bounded one.
fn evaluate(spec: &Spec, expression: &Expression) -> Option<BigRational> {
    let falls = matches!(
        expression,
        Expression::Neg(_) | Expression::Sub(..) | Expression::Div(..) | Expression::Power(..)
    );
    if falls && expression.parameters().iter().any(|p| spec.bounds.contains_key(p)) {
        return None;
    }
    let of = |e: &Expression| evaluate(spec, e);
    match expression {
        Expression::Number(number) => Some(number.clone()),
        Expression::Parameter(parameter) => greatest(spec, *parameter),
        Expression::Neg(a) => of(a).map(|a| -a),
        Expression::Add(a, b) => Some(of(a)? + of(b)?),
        Expression::Sub(a, b) => Some(of(a)? - of(b)?),
        Expression::Mul(a, b) => Some(of(a)? * of(b)?),
        Expression::Div(a, b) => of(b).filter(|b| *b != integer(0)).and_then(|b| Some(of(a)? / b)),
        Expression::Min(a, b) => Some(of(a)?.min(of(b)?)),
        Expression::Max(a, b) => Some(of(a)?.max(of(b)?)),
        Expression::Power(a, b) => {
            let exponent = b.small_integer().filter(|k| (0..=64).contains(k))?;
            Some(of(a)?.pow(exponent))
        }
        Expression::Pi | Expression::Variable(_) | Expression::Call(..) => None,
    }
}

/// What the closed loop in numbers lacks, in words; none where nothing is missing.
pub(super) fn lacking(spec: &Spec) -> Option<String> {
    if spec.feedback != Feedback::Linear {
        return Some("a linear law".to_owned());
    }
    let needed = |p: &Parameter| {
        !matches!(p, Parameter::StartTime | Parameter::Eps | Parameter::UMax) && !is_known(spec, *p)
    };
    let of_gain = spec.input_gain.as_ref().map(Expression::parameters).unwrap_or_default();
    let open = spec.parameters().into_iter().filter(|p| !of_gain.contains(p)).find(needed)?;
    Some(match open {
        Parameter::Gain(_) => "gains or poles".to_owned(),
        open => format!("a value of `{}`", open.spelling()),
    })
}

/// A fixed value as a double; none for infinity.
pub(super) fn to_f64(value: &Fixed) -> Option<f64> {
    value.number().and_then(ToPrimitive::to_f64)
}

/// `value` to three significant digits from below, as a spec holds it.
pub(super) fn rounded_down(value: f64) -> Option<Fixed> {
    let text = format!("{value:.2e}");
    let near: f64 = text.parse().ok()?;
    let text = if near <= value { text } else { format!("{:.2e}", value * (1.0 - 5e-3)) };
    number(&text)
}
