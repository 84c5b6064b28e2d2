//! The controller by its definition, in long arithmetic: what the emitted code should have given.
//!
//! Nothing here is shared with the way from a spec to code. The mapping is evaluated as it is
//! defined, its derivatives are Taylor coefficients in long arithmetic, the Bell polynomials come
//! from their recurrence, and the law is Theorem 1 as it stands. Every result is computed at two
//! precisions, and again with more digits until both agree far beyond a double.

pub mod call;
mod law;
mod long;
mod mapping;
mod series;
pub mod tolerance;
mod work;

use std::collections::VecDeque;
use std::rc::Rc;

use astro_float_num::BigFloat;

use crate::code;
use crate::expression::{Expression, Variable};
use crate::parameter::{Domain, Fixed, Parameter, Precision};
use crate::request::{After, Feedback, Spec};
use law::{Leaves, Term, larger};
use long::{Arithmetic, below, double, is_finite, nearest};
use mapping::{Mapping, Point};
pub(crate) use work::Work;

/// Bits of the first of the precisions, each of which has twice those of the one before.
const FIRST_BITS: usize = 192;
/// Bits beyond which no agreement is sought.
const MAX_BITS: usize = 16384;
/// Two results agree where they differ by less than 2^-AGREED of the scale.
const AGREED: i32 = 140;
/// Decimal digits that agree at least: 140 bits.
pub const DIGITS: usize = 42;

/// Outcome of a call, by the names and numbers of the emitted C.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// u is not finite.
    Range = -3,
    /// Time or state is not finite, or t before t0.
    Input = -2,
    /// A parameter is outside its domain.
    Param = -1,
    /// Tracking.
    Ok = 0,
    /// Time-to-go is held at eps.
    Hold = 1,
    /// u is clipped.
    Saturated = 2,
    /// The deadline is over, and another law than the controller's gives u.
    After = 3,
}

impl From<code::Status> for Status {
    fn from(status: code::Status) -> Self {
        match status {
            code::Status::Ok => Self::Ok,
            code::Status::Hold => Self::Hold,
            code::Status::Saturated => Self::Saturated,
            code::Status::After => Self::After,
            code::Status::Param => Self::Param,
            code::Status::Input => Self::Input,
            code::Status::Range => Self::Range,
        }
    }
}

impl Status {
    /// Its name in C.
    pub fn c_name(self) -> &'static str {
        match self {
            Self::Range => "PTC_E_RANGE",
            Self::Input => "PTC_E_INPUT",
            Self::Param => "PTC_E_PARAM",
            Self::Ok => "PTC_OK",
            Self::Hold => "PTC_HOLD",
            Self::Saturated => "PTC_SATURATED",
            Self::After => "PTC_AFTER",
        }
    }

    /// Its number in C.
    pub fn code(self) -> i32 {
        self as i32
    }
}

/// One call of `init` and `step`. Every number is exact in the precision of the spec.
pub struct Call<'a> {
    /// The value of each parameter that is left to run time.
    pub parameter: &'a dyn Fn(Parameter) -> f64,
    /// The latched state `x_1..x_n` at the start; empty where none is latched.
    pub x0: &'a [f64],
    /// Time, s.
    pub t: f64,
    /// State `x_1..x_n`.
    pub x: &'a [f64],
    /// The law of the infinite-time system where it is a function of the user's program.
    pub law: Option<&'a Expression>,
    /// What the user's own function gives after the deadline.
    pub after: f64,
}

/// u before it is clipped, known far beyond the precision of any controller.
#[derive(Clone, Debug)]
pub struct Control {
    value: BigFloat,
    scale: BigFloat,
}

impl Control {
    /// The double nearest to u.
    pub fn u(&self) -> f64 {
        nearest(&self.value)
    }

    /// The sum of the absolute values of the terms of u, by which errors are measured.
    pub fn scale(&self) -> f64 {
        nearest(&self.scale)
    }

    /// |u - reference|/scale of a u that is a decimal number, to as many digits as it has.
    pub fn error_of_text(&self, u: &str) -> Option<f64> {
        let (mantissa, exponent) = u.split_once('e').unwrap_or((u, "0"));
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: crate::algebra::BigInt = format!("{whole}{part}").parse().ok()?;
        let places: i32 = exponent.parse::<i32>().ok()? - i32::try_from(part.len()).ok()?;
        let ten = num_traits::pow(crate::algebra::integer(10), usize::try_from(places.abs()).ok()?);
        let exact = crate::algebra::integer(1) * digits;
        let exact = if places < 0 { exact / ten } else { exact * ten };
        let arithmetic = Arithmetic::new(2 * FIRST_BITS)?;
        Some(self.scaled(&arithmetic.exact(&exact), &arithmetic))
    }

    /// |u - reference|/scale.
    pub fn error(&self, u: f64) -> f64 {
        match Arithmetic::new(2 * FIRST_BITS) {
            Some(arithmetic) => self.scaled(&arithmetic.double(u), &arithmetic),
            None => f64::NAN,
        }
    }

    fn scaled(&self, u: &BigFloat, arithmetic: &Arithmetic) -> f64 {
        let off = arithmetic.sub(u, &self.value).abs();
        if off.is_zero() { 0.0 } else { nearest(&arithmetic.div(&off, &self.scale)) }
    }
}

/// What a call should give.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The status.
    pub status: Status,
    /// u as it is returned; 0 for a negative status.
    pub u: f64,
    /// The law's own u, where the law was asked.
    pub control: Option<Control>,
    /// Time-to-go before it is held, s.
    pub time_to_go: f64,
}

impl Outcome {
    fn refused(status: Status) -> Self {
        Self { status, u: 0.0, control: None, time_to_go: f64::NAN }
    }
}

/// What a call of the controller of `spec` should give; `None` where more digits than any decide.
pub fn evaluate(spec: &Spec, call: &Call<'_>) -> Option<Outcome> {
    Reference::new(spec)?.evaluate(call)
}

/// The definition of one controller. What calls have in common is computed once: the constants of
/// each precision, and the mapping at the last few times.
pub struct Reference<'a> {
    spec: &'a Spec,
    /// What `init` checks of them counts for each call.
    run_time: Vec<Parameter>,
    mapping: Mapping,
    /// Exact for every sum of three doubles.
    exact: Arithmetic,
    /// By the doublings of [`FIRST_BITS`].
    precisions: Vec<Kept>,
    work: Work,
}

impl<'a> Reference<'a> {
    /// The definition of the controller of `spec`; `None` where there is no memory for it.
    pub fn new(spec: &'a Spec) -> Option<Self> {
        Self::within(spec, Work::unlimited())
    }

    /// The same with a bound of its work, beyond which no call is known.
    pub(crate) fn within(spec: &'a Spec, work: Work) -> Option<Self> {
        Some(Self {
            spec,
            run_time: spec.run_time_parameters().collect(),
            mapping: Mapping::new(spec),
            exact: Arithmetic::new(4352)?,
            precisions: Vec::new(),
            work,
        })
    }

    /// What a call should give; `None` where more digits than any decide.
    pub fn evaluate(&mut self, call: &Call<'_>) -> Option<Outcome> {
        let (spec, exact) = (self.spec, &self.exact);
        let parameter = |p| value_of(spec, p, call.parameter);
        if self.run_time.iter().any(|p| !admitted(spec, *p, &parameter)) {
            return Some(Outcome::refused(Status::Param));
        }
        let [tau, start, eps] =
            [Parameter::Tau, Parameter::StartTime, Parameter::Eps].map(parameter);
        let finite = call.t.is_finite() && call.x.iter().all(|x| x.is_finite());
        if !finite || call.t < start {
            return Some(Outcome::refused(Status::Input));
        }
        let deadline = exact.add(&exact.double(start), &exact.double(tau));
        let to_go = exact.sub(&deadline, &exact.double(call.t));
        let over = !to_go.is_positive() || to_go.is_zero();
        let tracking = below(&exact.double(eps), &to_go);
        let held = if tracking { to_go.clone() } else { exact.double(eps) };
        let time_to_go = nearest(&to_go);
        if over && spec.after != After::Hold {
            let u = if spec.after == After::Extern { call.after } else { 0.0 };
            return Some(clipped(
                spec,
                Outcome { status: Status::After, u, control: None, time_to_go },
                &parameter,
            ));
        }
        let control = self.agreed(call, &held, &parameter)?;
        let status = if tracking { Status::Ok } else { Status::Hold };
        let u = control.u();
        let outcome = Outcome { status, u, control: Some(control), time_to_go };
        Some(clipped(spec, outcome, &parameter))
    }

    /// u at two precisions that agree.
    fn agreed(
        &mut self,
        call: &Call<'_>,
        to_go: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Control> {
        let mut last: Option<Term> = None;
        let bits = std::iter::successors(Some(FIRST_BITS), |bits| Some(2 * bits));
        for (index, bits) in bits.take_while(|bits| *bits <= MAX_BITS).enumerate() {
            if self.precisions.len() == index {
                self.precisions.push(Kept::new(bits, self.work.clone())?);
            }
            let kept = &mut self.precisions[index];
            let next = kept.control((self.spec, &self.mapping), call, to_go, parameter);
            if self.work.is_spent() {
                return None;
            }
            let arithmetic = &kept.arithmetic;
            if let (Some(last), Some(next)) = (&last, &next) {
                let off = arithmetic.sub(&last.value, &next.value).abs();
                let allowed = arithmetic.mul(&next.size, &arithmetic.two_to(-AGREED));
                let same = is_finite(&next.value) && !below(&allowed, &off);
                // A division by 0 stays one with any number of digits.
                let without = !is_finite(&next.value) && !is_finite(&last.value);
                if same || without {
                    return Some(Control { value: next.value.clone(), scale: next.size.clone() });
                }
            }
            last = next;
        }
        None
    }
}

/// Times at which the mapping is kept: those of a call and of the start, and the calls before.
const POINTS: usize = 4;

/// One precision, with the mapping at the last times.
struct Kept {
    arithmetic: Arithmetic,
    points: VecDeque<(At, Option<Rc<Point>>)>,
}

/// What the mapping depends on: time-to-go, and the bits of its parameters.
type At = (BigFloat, Vec<u64>);

/// The value of a parameter: as it is fixed, rounded, or as the call gives it.
fn value_of(spec: &Spec, parameter: Parameter, given: &dyn Fn(Parameter) -> f64) -> f64 {
    match spec.fixed.get(&parameter) {
        Some(Fixed::Infinite) => f64::INFINITY,
        Some(Fixed::Number { value, .. }) => crate::program::number::round(value, spec.precision),
        None => given(parameter),
    }
}

fn admitted(spec: &Spec, parameter: Parameter, value: &dyn Fn(Parameter) -> f64) -> bool {
    let own = value(parameter);
    match spec.domain(parameter) {
        Domain::Finite => own.is_finite(),
        Domain::Positive => spec.keeps_digits(parameter, own),
        Domain::PositiveOrInfinite => own > 0.0,
        Domain::BelowTau => spec.keeps_digits(parameter, own) && own < value(Parameter::Tau),
        Domain::Within => spec.bounds.get(&parameter).is_some_and(|(least, greatest)| {
            let bound = |bound: &Fixed| {
                bound.number().map(|n| crate::program::number::round(n, spec.precision))
            };
            bound(least).is_none_or(|b| own >= b) && bound(greatest).is_none_or(|b| own <= b)
        }),
    }
}

/// The outcome within u_max and the range of the precision.
fn clipped(spec: &Spec, outcome: Outcome, parameter: &dyn Fn(Parameter) -> f64) -> Outcome {
    let u_max = parameter(Parameter::UMax);
    let greatest = match spec.precision {
        Precision::F64 => f64::MAX,
        Precision::F32 => f64::from(f32::MAX),
    };
    match outcome.u {
        u if u > u_max => Outcome { status: Status::Saturated, u: u_max, ..outcome },
        u if u < -u_max => Outcome { status: Status::Saturated, u: -u_max, ..outcome },
        u if u.is_nan() || u.abs() > greatest => {
            Outcome { status: Status::Range, u: 0.0, ..outcome }
        }
        _ => outcome,
    }
}

impl Kept {
    fn new(bits: usize, work: Work) -> Option<Self> {
        Some(Self { arithmetic: Arithmetic::within(bits, work)?, points: VecDeque::new() })
    }

    /// u at time-to-go `to_go`.
    fn control(
        &mut self,
        reference: (&Spec, &Mapping),
        call: &Call<'_>,
        to_go: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Term> {
        let (spec, mapping) = reference;
        let to_go = self.arithmetic.add(to_go, &self.arithmetic.integer(0));
        let point = self.point(mapping, &to_go, parameter)?;
        let at_start = if call.x0.is_empty() {
            point.clone()
        } else {
            let tau = self.arithmetic.double(parameter(Parameter::Tau));
            self.point(mapping, &tau, parameter)?
        };
        self.arithmetic.control(spec, call, &to_go, [&point, &at_start], parameter)
    }

    /// The mapping at time-to-go `to_go`.
    fn point(
        &mut self,
        mapping: &Mapping,
        to_go: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Rc<Point>> {
        let values = mapping.parameters.iter().map(|p| parameter(*p).to_bits());
        let at = (to_go.clone(), values.collect());
        if let Some((_, point)) = self.points.iter().find(|(other, _)| *other == at) {
            return point.clone();
        }
        let point = self.arithmetic.point(mapping, to_go, parameter).map(Rc::new);
        self.points.truncate(POINTS - 1);
        self.points.push_front((at, point.clone()));
        point
    }
}

impl Arithmetic {
    /// Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x), with the mapping at the time of
    /// the call and, where a state is latched, at the start.
    fn control(
        &mut self,
        spec: &Spec,
        call: &Call<'_>,
        to_go: &BigFloat,
        [point, at_start]: [&Point; 2],
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Term> {
        let n = spec.n;
        let xi = self.stretched_state(point, call.x);
        let starts = self.stretched_state(at_start, call.x0);
        let start = self.double(parameter(Parameter::StartTime));
        let stretched = Term {
            value: self.add(&point.stretched, &start),
            size: self.add(&point.stretched.abs(), &start.abs()),
        };
        let time = self.double(call.t);
        let elapsed = self.sub(&time, &start);
        let bits = self.bits();
        let states = |x: &[f64], j: usize| double(x[j - 1], bits);
        let number = |p| double(parameter(p), bits);
        let variable = |v: Variable| match v {
            Variable::SinceStart => Term::given(point.stretched.clone()),
            Variable::StretchedTime => stretched.clone(),
            Variable::Time => Term::given(time.clone()),
            Variable::Elapsed => Term::given(elapsed.clone()),
            Variable::TimeToGo => Term::given(to_go.clone()),
            // No expression of a controller knows its own result.
            Variable::Control => Term::given(double(f64::NAN, bits)),
            Variable::State(j) => Term::given(states(call.x, j)),
            Variable::StateAtStart(j) => Term::given(states(call.x0, j)),
            Variable::Xi(j) => xi[j - 1].clone(),
            Variable::XiAtStart(j) => starts[j - 1].clone(),
        };
        let leaves = Leaves { parameter: &number, variable: &variable };
        let law = match (&spec.feedback, call.law) {
            (Feedback::Linear, _) => linear(n),
            (Feedback::Expression(law), _) => law.clone(),
            (Feedback::Extern, law) => law?.clone(),
        };
        let mut u = self.term(&law, &leaves);
        // A law that is a number alone is still a term of u.
        u.size = larger(&u.size, &u.value);
        let drift = (1..=n).map(|j| self.mul(&point.bell[n][j - 1], &self.double(call.x[j - 1])));
        let drift: Vec<_> = drift.collect();
        for term in &drift {
            u.value = self.sub(&u.value, term);
            u.size = self.add(&u.size, &term.abs());
        }
        let factor = (0..n).fold(self.integer(1), |power, _| self.mul(&power, &point.slope));
        u = Term { value: self.mul(&factor, &u.value), size: self.mul(&factor, &u.size).abs() };
        if let Some(gain) = &spec.input_gain {
            let gain = self.term(gain, &leaves);
            let value = self.div(&u.value, &gain.value);
            let by_gain = self.mul(&value, &gain.size).abs();
            let size = self.div(&self.add(&u.size, &by_gain), &gain.value.abs());
            u = Term { value, size };
        }
        Some(u)
    }

    /// xi = BB_n x.
    fn stretched_state(&self, point: &Point, x: &[f64]) -> Vec<Term> {
        let entry = |i: usize, j: usize| self.mul(&point.bell[i][j], &self.double(x[j]));
        let zero = || Term { value: self.integer(0), size: self.integer(0) };
        let row = |i: usize| {
            (0..=i).map(|j| entry(i, j)).fold(zero(), |sum, term| Term {
                value: self.add(&sum.value, &term),
                size: self.add(&sum.size, &term.abs()),
            })
        };
        (0..x.len()).map(row).collect()
    }
}

/// pi0 = -(k_1 xi_1 + ... + k_n xi_n).
fn linear(n: usize) -> Expression {
    let term = |i| Expression::from(Parameter::Gain(i)).mul(Variable::Xi(i).into());
    (1..=n).map(term).reduce(Expression::add).unwrap_or(Expression::integer(0)).neg()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Place;
    use crate::request::{Entry, read};
    use crate::syntax::parse;

    /// Whatever was asked before, in whatever order: the mapping is kept by all that it depends on.
    #[test]
    fn calls_do_not_change_one_another() {
        let keys = [("n", "2"), ("mu", "tau*b*t/(1 + b*t)"), ("pi0", "-b*xi1*x1_0 - xi2")];
        let entry = |(key, text): (&str, &str)| {
            let value = parse(key, text, &mut |_| Place(0)).expect(text);
            Entry { key: key.to_owned(), place: Place(0), value }
        };
        let spec = read(&keys.map(entry)).expect("a spec");
        let mut kept = Reference::new(&spec).expect("memory");
        let mut seen = Vec::new();
        for index in 0..120 {
            // Time-to-go is 0.5 or 0.25 for every tau and b.
            let [tau, to_go] = [[1.0, 2.0, 4.0][index % 3], [0.5, 0.25][index / 3 % 2]];
            let b = [0.5, 0.75, 1.5, 3.0, 7.0][index / 6 % 5];
            let parameter = |p: Parameter| match p.spelling().as_str() {
                "tau" => tau,
                "t0" => 0.0,
                "b" => b,
                "eps" => 0.125,
                _ => f64::INFINITY,
            };
            let (x0, x) = ([1.0 + tau, 0.5], [0.75, if index < 60 { 1.0 } else { -2.0 }]);
            let t = tau - to_go;
            let call = Call { parameter: &parameter, x0: &x0, t, x: &x, law: None, after: 0.0 };
            let [own, alone] = [kept.evaluate(&call), evaluate(&spec, &call)].map(|outcome| {
                let outcome = outcome.expect("enough digits");
                let scale = outcome.control.map(|control| control.scale().to_bits());
                (outcome.status, outcome.u.to_bits(), scale)
            });
            assert_eq!(own, alone, "call {index}");
            seen.push(own.1);
        }
        seen.sort_unstable();
        seen.dedup();
        assert!(seen.len() > 50, "{} values of u", seen.len());
        assert!(kept.precisions.iter().all(|kept| kept.points.len() == POINTS));
    }
}
