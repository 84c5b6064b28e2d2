//! Random records for a controller, of every kind that it must handle.

use ptc_codegen::parameter::{Domain, Fixed, Parameter, Precision};
use ptc_codegen::request::{Guard, Spec};

use super::program::Record;
use super::random::Random;
use super::specs::rounded;

/// Calls with the same parameters.
const CALLS: usize = 25;

/// `count` records: parameters of which some are refused, times before the start, at it, up to the
/// deadline and long after it, and states that are zero, huge, tiny and not finite. What a guard
/// trusts is kept.
pub fn records(spec: &Spec, random: &mut Random, count: usize) -> Vec<Record> {
    let mut records = Vec::with_capacity(count);
    while records.len() < count {
        let drawn = Drawn::new(spec, random);
        for _ in 0..CALLS.min(count - records.len()) {
            let t = time(spec, &drawn, random);
            let mut states = |n| (0..n).map(|_| state(spec, random)).collect::<Vec<_>>();
            let latched = states(if spec.latches() { spec.n } else { 0 });
            let x = states(spec.given());
            let x0 = latched.into_iter().map(|x| if x.is_finite() { x } else { 1.0 }).collect();
            records.push(Record { parameters: drawn.parameters.clone(), x0, t, x });
        }
    }
    records
}

/// The parameters of some calls, and those of them that the times depend on.
struct Drawn {
    tau: f64,
    t0: f64,
    parameters: Vec<f64>,
}

impl Drawn {
    fn new(spec: &Spec, random: &mut Random) -> Self {
        let round = |value| rounded(value, spec.precision);
        let fixed = |parameter| {
            let number = spec.fixed.get(&parameter).and_then(Fixed::number);
            number.map(|number| ptc_codegen::program::number::round(number, spec.precision))
        };
        let tau = fixed(Parameter::Tau).unwrap_or_else(|| round(random.magnitude(1e-3, 1e3)));
        let start = [0.0, random.between(-30.0, 30.0), 1e4][choice(random, 3)];
        let t0 = fixed(Parameter::StartTime).unwrap_or_else(|| round(start));
        let free: Vec<_> = spec.run_time_parameters().collect();
        let mut parameters: Vec<_> =
            free.iter().map(|p| round(value(spec, *p, tau, t0, random))).collect();
        // Now and then one that `init` refuses, or whose coefficients overflow.
        if !free.is_empty() && random.below(5) == 0 {
            let odd = [-1.0, f64::NAN, f64::INFINITY, 0.0, 1e-37, tau];
            parameters[choice(random, free.len())] = round(odd[choice(random, odd.len())]);
        }
        let drawn = |wanted, other| {
            free.iter().position(|p| *p == wanted).map_or(other, |at| parameters[at])
        };
        Self { tau: drawn(Parameter::Tau, tau), t0: drawn(Parameter::StartTime, t0), parameters }
    }
}

/// A legal value of a run-time parameter.
fn value(spec: &Spec, parameter: Parameter, tau: f64, t0: f64, random: &mut Random) -> f64 {
    if let Some((least, greatest)) = spec.bounds.get(&parameter) {
        let bound = |b: &Fixed, other: f64| b.number().map_or(other, as_f64);
        return random.between(bound(least, 0.1), bound(greatest, 10.0));
    }
    match parameter {
        Parameter::Tau => tau,
        Parameter::StartTime => t0,
        Parameter::Eps => tau * random.magnitude(1e-6, 0.5),
        Parameter::UMax => [f64::INFINITY, random.magnitude(1e-3, 1e6)][choice(random, 2)],
        Parameter::UMin => [f64::NEG_INFINITY, -random.magnitude(1e-3, 1e6)][choice(random, 2)],
        Parameter::M => random.between(0.5, 4.0),
        Parameter::Start => random.between(0.05, 1.0),
        Parameter::Gain(_) => random.sign() * random.magnitude(1e-3, 1e3),
        parameter if spec.domain(parameter) == Domain::Finite => random.between(-3.0, 3.0),
        _ => random.magnitude(0.05, 20.0),
    }
}

fn as_f64(number: &ptc_codegen::algebra::BigRational) -> f64 {
    ptc_codegen::program::number::round(number, Precision::F64)
}

fn choice(random: &mut Random, count: usize) -> usize {
    usize::try_from(random.below(count as u64)).expect("a small number")
}

fn time(spec: &Spec, drawn: &Drawn, random: &mut Random) -> f64 {
    let (tau, t0) = (drawn.tau, drawn.t0);
    let trusted = spec.guard != Guard::Full;
    let t = match random.below(16) {
        0 => t0,
        1 => t0 + tau,
        2 => t0 + tau * random.magnitude(1.0, 1e20),
        3 => t0 + tau * (1.0 - random.magnitude(1e-12, 1e-3)),
        4 if !trusted => t0 - random.magnitude(1e-3, 1e3),
        5 if !trusted => f64::NAN,
        6 if !trusted => random.sign() * f64::INFINITY,
        _ => t0 + tau * random.between(0.0, 1.0),
    };
    let t = rounded(t, spec.precision);
    if trusted { t.max(t0) } else { t }
}

fn state(spec: &Spec, random: &mut Random) -> f64 {
    let (huge, tiny) = match spec.precision {
        Precision::F64 => (1e300, 1e-315),
        Precision::F32 => (1e37, 1e-42),
    };
    let x = match random.below(99) {
        0 => 0.0,
        1 => huge,
        2 => tiny,
        3 if spec.guard == Guard::Full => f64::NAN,
        4 if spec.guard == Guard::Full => f64::INFINITY,
        _ => random.magnitude(1e-3, 1e3),
    };
    rounded(random.sign() * x, spec.precision)
}
