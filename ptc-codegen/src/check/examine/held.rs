//! Range of the gains held at eps: overflow where x has no bounds.
//!
//! The emitted `step` multiplies the states by the gains factor by factor, so that no gain is a value of it. A gain overflows
//! where u does for a state of 1 alone.

use num_traits::ToPrimitive;

use super::envelope::{NAME, round};
use super::known::{lacking, to_f64};
use super::numbers::Numbers;
use crate::check::{Outcome, Verdict, middle};
use crate::diagnostic::{digits, digits_up};
use crate::expansion::Expanded;
use crate::expression::Expression;
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Parameter, Precision};
use crate::program::interpret::Interpreter;
use crate::program::{Input, number, passes};
use crate::request::{Spec, What};

/// Halvings after which the smallest eps is known to its digits.
const HALVINGS: u32 = 40;

/// Safety factor: covers the rounding of the gains in the emitted program relative to those in doubles.
const ROOM: f64 = 1.001;

/// The outcome of `envelope` where a gain overflows at eps; `None` where none does, or a number is left to run time.
pub(super) fn overflow(spec: &Spec, expanded: Option<&Expanded>) -> Option<Outcome> {
    let [eps, tau] = [Parameter::Eps, Parameter::Tau].map(|p| spec.fixed.get(&p).and_then(to_f64));
    let (eps, tau) = (eps?, tau?);
    let is_one_chain = spec.axes.is_none() && spec.coupled.is_none();
    if spec.what != What::Controller || !is_one_chain || lacking(spec).is_some() {
        return None;
    }
    let lost = overflowing(spec, expanded);
    let first = *lost.first()?;
    let name = spec.precision.name();
    let most = spec.precision.greatest();
    let wider = Spec { precision: Precision::F64, ..spec.clone() };
    let numbers = Numbers::new(&wider, expanded);
    let divisor = constant_gain(spec).and_then(|g| g.number()?.to_f64()).unwrap_or(1.0);
    let of_u = |eps| numbers.gains(eps).iter().map(|gain| gain / divisor).collect::<Vec<_>>();
    let gains = of_u(eps);
    let about = |j: &usize| match gains.get(j - 1) {
        Some(gain) if gain.is_finite() => format!("|x{j}| = {}", digits((most / gain).abs())),
        _ => format!("|x{j}| = 0"),
    };
    let from: Vec<_> = lost.iter().map(about).collect();
    let limited = "`step` then clips u to u_max, or gives u = 0 and PTC_E_RANGE if u_max is infinite or terms of both signs overflow";
    let fits = spec.precision == Precision::F32 && overflowing(&wider, expanded).is_empty();
    let wider = if fits { "precision = \"f64\", " } else { "" };
    let larger = smallest_eps(&of_u, (eps, tau), most)
        .map(|least| format!("eps of at least {} s, ", digits_up(ROOM * least)));
    Some(Outcome {
        name: NAME,
        verdict: Verdict::Undecided,
        summary: format!(
            "the gain of x{first} overflows {name} where it is held, at T = eps = {} s: the largest finite number is {}",
            digits(eps),
            digits(most)
        ),
        details: vec![format!("u overflows there from {} on: {limited}", from.join(", "))],
        fix: Some(format!(
            "take an {}{wider}or larger units of u; with `x_max` the check decides",
            larger.unwrap_or_else(|| "larger eps, ".to_owned())
        )),
    })
}

/// The states, from 1, of which 1 alone makes u of the emitted program no number where the gains are held. Of g a number
/// counts; f, a reference and a model move u by what is no gain.
fn overflowing(spec: &Spec, expanded: Option<&Expanded>) -> Vec<usize> {
    let chain = Spec {
        drift: None,
        input_gain: constant_gain(spec).cloned(),
        reference: None,
        model: None,
        ..spec.clone()
    };
    let program = passes::optimise(lower(&chain, &Law::from(&chain, expanded)), &mut |_, _| {});
    let parameter = |p| chain.fixed.get(&p).map_or(0.0, |value| round(&chain, value));
    let settle = |value| number::settle(value, chain.precision);
    let start = parameter(Parameter::StartTime);
    let is_lost = |state: &usize| {
        let input = |asked| match asked {
            Input::Parameter(p) => parameter(p),
            Input::StartTime => start,
            Input::Time => settle(start + parameter(Parameter::Tau)),
            Input::State(j) | Input::StateAtStart(j) => f64::from(u8::from(j == *state)),
            _ => f64::NAN,
        };
        !Interpreter::new(&program, &input).value(program.step).is_finite()
    };
    (1..=chain.n).filter(is_lost).collect()
}

/// g, where it is a number.
fn constant_gain(spec: &Spec) -> Option<&Expression> {
    spec.input_gain.as_ref().filter(|g| g.number().is_some())
}

/// The smallest eps up to tau from which on all gains are at most `most`, if there is one.
fn smallest_eps(gains: &dyn Fn(f64) -> Vec<f64>, (eps, tau): (f64, f64), most: f64) -> Option<f64> {
    let fits = |eps: f64| gains(eps).iter().all(|gain| gain.abs() <= most);
    let (mut low, mut high) = (eps, tau * (1.0 - f64::EPSILON));
    fits(high).then_some(())?;
    for _ in 0..HALVINGS {
        let between = middle(low, high);
        *(if fits(between) { &mut high } else { &mut low }) = between;
    }
    (high > eps).then_some(high)
}
