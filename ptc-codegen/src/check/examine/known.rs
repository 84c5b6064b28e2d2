//! Fixed values of a spec, as exact numbers and as doubles.

use num_traits::{Signed, ToPrimitive};

use crate::algebra::{BigRational, integer};
use crate::check::growth::Modes;
use crate::collect::map;
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::{Evaluator, Existence};
use crate::expression::{Expression, Node, Variable, leading};
use crate::family::Family;
use crate::mapping::{Form, TimeMapping};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Feedback, Spec};
use crate::syntax::number;

/// Returns true if a parameter is fixed.
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

/// From where to where the value of a parameter is known to lie: the fixed one, or its bounds.
pub(super) fn range(spec: &Spec, parameter: Parameter) -> Option<(BigRational, BigRational)> {
    let exact = |value: &Fixed| value.number().cloned();
    match (spec.fixed.get(&parameter), spec.bounds.get(&parameter)) {
        (Some(value), _) => exact(value).map(|value| (value.clone(), value)),
        (None, Some((least, most))) => exact(least).zip(exact(most)),
        (None, None) => None,
    }
}

/// Known bounds of the decay rate of mu'.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Rate {
    /// The greatest one.
    Exact(BigRational),
    /// All of them lie between two numbers; how it is spelt, where it is one.
    Between(BigRational, BigRational, Option<String>),
    /// mu' falls faster than every exponential.
    Infinite,
    /// It depends on parameters that are left to run time.
    Open,
    /// It is not found.
    NotFound,
}

/// The decay rate of mu', and what a pole at a multiple of it does.
#[derive(Clone, Debug)]
pub(crate) struct Decay {
    pub(crate) rate: Rate,
    pub(crate) modes: Modes,
}

impl Decay {
    fn of_family(rate: Option<BigRational>, modes: Modes) -> Self {
        Self { rate: rate.map_or(Rate::Open, Rate::Exact), modes }
    }

    /// The greatest rate, or a bound of it; `None` if there is none or it is not known.
    #[cfg(feature = "files")]
    pub(crate) fn greatest(self) -> Option<BigRational> {
        match self.rate {
            Rate::Exact(rate) | Rate::Between(_, rate, _) => Some(rate),
            Rate::Infinite | Rate::Open | Rate::NotFound => None,
        }
    }
}

/// Returns the decay rate of mu' and the kind of its modes.
pub(crate) fn decay(spec: &Spec) -> Decay {
    match &spec.time_mapping {
        TimeMapping::Family { family: Family::Exp, .. } => {
            Decay::of_family(greatest(spec, Parameter::A), Modes::Polynomial)
        }
        TimeMapping::Family { family: Family::Soft, .. } => {
            let start = exact(spec, Parameter::Start);
            let is_exp = start.is_some_and(|start| start == integer(1));
            let modes = if is_exp { Modes::Polynomial } else { Modes::Quadratic };
            Decay::of_family(greatest(spec, Parameter::A), modes)
        }
        TimeMapping::Family { family: Family::Tanh, .. } => {
            let rate = greatest(spec, Parameter::A).map(|a| a * integer(2));
            Decay::of_family(rate, Modes::Analytic)
        }
        TimeMapping::Family { family: Family::ExpSum, rates } => {
            let rates: Option<Vec<_>> =
                (1..=*rates).map(|i| greatest(spec, Parameter::Rate(i))).collect();
            Decay::of_family(rates.and_then(|rates| rates.into_iter().min()), Modes::Other)
        }
        TimeMapping::Family { .. } => Decay::of_family(Some(integer(0)), Modes::Other),
        TimeMapping::Custom(custom) => {
            let fixed = |e: &Expression| exact(spec, e.parameter()?).map(Expression::from);
            // Limits are found for positive parameters.
            let lowest = |p: &Parameter| match spec.bounds.get(p) {
                Some((least, _)) => least.number().cloned(),
                None => exact(spec, *p),
            };
            let positive = |p: &Parameter| lowest(p).is_none_or(|least| least.is_positive());
            let found = custom.parameters.iter().all(positive);
            let Some(found) = found.then(|| custom.decay(spec.n, &fixed)).flatten() else {
                return Decay { rate: Rate::NotFound, modes: Modes::Open };
            };
            // T decays at one rate from the start to the deadline: exp in another spelling.
            let uniform = matches!(&custom.form, Form::Kappa(kappa)
                if !kappa.rate.contains(Variable::TimeToGo));
            let rate = match found.rate {
                leading::Rate::Infinite => Rate::Infinite,
                leading::Rate::Finite(rate) => rate_of(spec, &rate),
            };
            let modes = match (uniform, found.pure || rate == Rate::Exact(integer(0))) {
                (true, _) => Modes::Polynomial,
                (false, true) => Modes::Other,
                (false, false) => Modes::Open,
            };
            Decay { rate, modes }
        }
    }
}

/// The value of a rate in the parameters that are not fixed.
fn rate_of(spec: &Spec, rate: &Expression) -> Rate {
    if let Some(greatest) = evaluate(spec, rate) {
        return Rate::Exact(greatest);
    }
    let range = |p: Parameter| {
        let (low, high) = range(spec, p)?;
        Some((Expression::from(p), Interval::between(&low, Some(&high))))
    };
    let Some(names) = rate.parameters().into_iter().map(range).collect::<Option<Vec<_>>>() else {
        return Rate::Open;
    };
    let names = map(names);
    let value = Evaluator::new().value(rate, &names);
    let defined = value.filter(|value| value.existence == Existence::Certain);
    match defined.and_then(|value| value.interval.ends()) {
        Some((low, high)) => {
            let spelling = names.is_empty().then(|| rate.to_string());
            Rate::Between(low, high, spelling)
        }
        None => Rate::NotFound,
    }
}

/// The greatest value of an expression in positive parameters that are fixed or bounded; none
/// where it falls with a bounded one.
fn evaluate(spec: &Spec, expression: &Expression) -> Option<BigRational> {
    let falls =
        matches!(expression.node(), Node::Neg(_) | Node::Sub(..) | Node::Div(..) | Node::Power(..));
    if falls && expression.parameters().iter().any(|p| spec.bounds.contains_key(p)) {
        return None;
    }
    let of = |e: &Expression| evaluate(spec, e);
    match expression.node() {
        Node::Number(number) => Some(number.clone()),
        Node::Parameter(parameter) => greatest(spec, *parameter),
        Node::Neg(a) => of(a).map(|a| -a),
        Node::Add(a, b) => Some(of(a)? + of(b)?),
        Node::Sub(a, b) => Some(of(a)? - of(b)?),
        Node::Mul(a, b) => Some(of(a)? * of(b)?),
        Node::Div(a, b) => of(b).filter(|b| *b != integer(0)).and_then(|b| Some(of(a)? / b)),
        Node::Min(a, b) => Some(of(a)?.min(of(b)?)),
        Node::Max(a, b) => Some(of(a)?.max(of(b)?)),
        Node::Power(a, b) => {
            let exponent = b.small_integer().filter(|k| (0..=64).contains(k))?;
            Some(of(a)?.pow(exponent))
        }
        Node::Pi | Node::Variable(_) | Node::Call(..) => None,
    }
}

/// Names the missing input of the numeric closed loop; `None` if nothing is missing.
pub(in crate::check) fn lacking(spec: &Spec) -> Option<String> {
    if !matches!(spec.feedback, Feedback::Linear | Feedback::LeastEnergy(_)) {
        return Some("a linear law".to_owned());
    }
    let needed = |p: &Parameter| {
        !matches!(p, Parameter::StartTime | Parameter::Eps) && !p.is_limit() && !is_known(spec, *p)
    };
    let of_plant = spec.drift.iter().chain(&spec.input_gain).chain(spec.derivative(0));
    let of_plant = crate::collect::set(of_plant.flat_map(Expression::parameters));
    let open = spec.parameters().into_iter().filter(|p| !of_plant.contains(p)).find(needed)?;
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
pub(crate) fn rounded_down(value: f64) -> Option<Fixed> {
    let text = format!("{value:.2e}");
    let near: f64 = text.parse().ok()?;
    let text = if near <= value { text } else { format!("{:.2e}", value * (1.0 - 5e-3)) };
    number(&text)
}
