//! The controller by its definition, in long arithmetic: what the emitted code should have given.
//!
//! Nothing here but the table of functions, which its tests compare with finite differences, is shared with the way
//! from a spec to code. The mapping is evaluated as it is
//! defined, its derivatives are Taylor coefficients in long arithmetic, the Bell polynomials come
//! from their recurrence, and the law is Theorem 1 as it stands. Every result is computed at two
//! precisions, and again with more digits until both agree far beyond a double.

mod algebra;
pub mod call;
mod control;
mod coupled;
mod kept;
mod law;
mod long;
mod mapping;
mod outcome;
mod series;
pub mod tolerance;
mod work;

use astro_float_num::BigFloat;

use crate::expression::Expression;
use crate::parameter::{Domain, Fixed, Parameter, Precision};
use crate::program::range::{Range, rounded};
use crate::request::{After, Spec};
use kept::Kept;
use law::Term;
use long::{Arithmetic, below, is_finite, nearest};
use mapping::Mapping;
pub use outcome::{Control, Outcome, Status};
pub(crate) use work::Work;

/// Bits of the first of the precisions, each of which has twice those of the one before.
const FIRST_BITS: usize = 192;
/// Bits beyond which no agreement is sought.
const MAX_BITS: usize = 16384;
/// Two results agree where they differ by less than 2^-AGREED of the scale.
const AGREED: i32 = 140;
/// Decimal digits that agree at least: 140 bits.
pub const DIGITS: usize = 42;

/// One call of `init` and `step`. Every number is exact in the precision of the spec.
pub struct Call<'a> {
    /// The value of each parameter that is left to run time.
    pub parameter: &'a dyn Fn(Parameter) -> f64,
    /// The latched state `x_1..x_n` at the start; empty where none is latched.
    pub x0: &'a [f64],
    /// Time, s.
    pub t: f64,
    /// State `x_1..x_n`; behind it the reference and its derivatives, where each call is given them.
    pub x: &'a [f64],
    /// The law of the infinite-time system where it is a function of the user's program: one, or that of each
    /// output.
    pub laws: &'a [Expression],
    /// Result of the user-defined function after the deadline.
    pub after: f64,
}

/// Returns the expected outcome of a call of the controller of `spec`, of one input; `None` where no number of digits
/// decides it.
pub fn evaluate(spec: &Spec, call: &Call<'_>) -> Option<Outcome> {
    Reference::new(spec)?.evaluate(call)
}

/// The definition of one controller. What calls have in common is computed once: the constants of
/// each precision, and the mapping at the last few times.
pub struct Reference<'a> {
    spec: &'a Spec,
    /// Design of each chain.
    designs: Vec<Spec>,
    /// Run-time parameters: a value that `init` would refuse fails each call.
    run_time: Vec<Parameter>,
    mapping: Mapping,
    /// Exact for every sum of three doubles.
    exact: Arithmetic,
    /// Caches, indexed by the doublings of [`FIRST_BITS`].
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
        let designs = match &spec.coupled {
            Some(coupled) => (0..coupled.outputs.len()).map(|index| spec.axis(index)).collect(),
            None => vec![spec.clone()],
        };
        let order = designs.iter().map(|own| own.n).max().unwrap_or(spec.n);
        Some(Self {
            spec,
            run_time: spec.run_time_parameters().collect(),
            mapping: Mapping::new(spec, order),
            designs,
            exact: Arithmetic::new(4352)?,
            precisions: Vec::new(),
            work,
        })
    }

    /// Returns the expected outcome of a call of a controller of one input; `None` where no number of digits decides
    /// it.
    pub fn evaluate(&mut self, call: &Call<'_>) -> Option<Outcome> {
        self.evaluate_each(call)?.into_iter().next()
    }

    /// Returns the expected outcome of a call for each input; `None` where no number of digits decides it.
    pub fn evaluate_each(&mut self, call: &Call<'_>) -> Option<Vec<Outcome>> {
        let (spec, exact) = (self.spec, &self.exact);
        let parameter = |p| value_of(spec, p, call.parameter);
        if self.run_time.iter().any(|p| !admitted(spec, *p, &parameter)) {
            return Some(self.refused(Status::Param));
        }
        let [tau, start, eps] =
            [Parameter::Tau, Parameter::StartTime, Parameter::Eps].map(parameter);
        let mut given = call.x.iter().enumerate();
        let finite = call.t.is_finite() && given.all(|(at, x)| !spec.reads(at) || x.is_finite());
        if !finite || call.t < start {
            return Some(self.refused(Status::Input));
        }
        let deadline = exact.add(&exact.double(start), &exact.double(tau));
        let to_go = exact.sub(&deadline, &exact.double(call.t));
        let over = !to_go.is_positive() || to_go.is_zero();
        let tracking = below(&exact.double(eps), &to_go);
        let held = if tracking { to_go.clone() } else { exact.double(eps) };
        let time_to_go = nearest(&to_go);
        if over && spec.after != After::Hold {
            let u = if spec.after == After::Extern { call.after } else { 0.0 };
            let after = Outcome { status: Status::After, u, control: None, time_to_go };
            return Some(vec![clipped(spec, after, Range::of(spec, 0, &parameter))]);
        }
        let controls = self.agreed(call, &held, &parameter)?;
        let status = if tracking { Status::Ok } else { Status::Hold };
        let each = controls.into_iter().map(|control| {
            let u = control.u();
            Outcome { status, u, control: Some(control), time_to_go }
        });
        let mut all: Vec<_> = each.collect();
        // All inputs are 0 where one that follows from all outputs is not finite, whatever its limit is.
        if spec.decoupled().is_some() && all.iter().any(|one| is_beyond(spec, one.u)) {
            for one in &mut all {
                one.status = if is_beyond(spec, one.u) { Status::Range } else { status };
                one.u = 0.0;
            }
            return Some(all);
        }
        let limits = self.designs.iter().map(|own| Range::of(own, 0, call.parameter));
        let each = all.into_iter().zip(limits);
        let mut all: Vec<_> = each.map(|(one, limit)| clipped(spec, one, limit)).collect();
        // An axis that fails ends all.
        if all.iter().any(|one| one.status == Status::Range) {
            all.iter_mut().for_each(|one| one.u = 0.0);
        }
        Some(all)
    }

    fn refused(&self, status: Status) -> Vec<Outcome> {
        let inputs = self.spec.coupled.as_ref().map_or(1, |coupled| coupled.inputs.len());
        vec![Outcome::refused(status); inputs]
    }

    /// Every u at two precisions that agree.
    fn agreed(
        &mut self,
        call: &Call<'_>,
        to_go: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Vec<Control>> {
        let mut last: Option<Vec<Term>> = None;
        let bits = std::iter::successors(Some(FIRST_BITS), |bits| Some(2 * bits));
        for (index, bits) in bits.take_while(|bits| *bits <= MAX_BITS).enumerate() {
            if self.precisions.len() == index {
                self.precisions.push(Kept::new(bits, self.work.clone())?);
            }
            let kept = &mut self.precisions[index];
            let how = (self.spec, self.designs.as_slice(), &self.mapping);
            let next = kept.controls(how, call, to_go, parameter);
            if self.work.is_spent() {
                return None;
            }
            let arithmetic = &kept.arithmetic;
            let agree = |last: &Term, next: &Term| {
                let off = arithmetic.sub(&last.value, &next.value).abs();
                let allowed = arithmetic.mul(&next.size, &arithmetic.two_to(-AGREED));
                let same = is_finite(&next.value) && !below(&allowed, &off);
                // A division by 0 stays one with any number of digits.
                same || (!is_finite(&next.value) && !is_finite(&last.value))
            };
            if let (Some(last), Some(next)) = (&last, &next)
                && last.iter().zip(next).all(|(last, next)| agree(last, next))
            {
                let one = |u: &Term| Control { value: u.value.clone(), scale: u.size.clone() };
                return Some(next.iter().map(one).collect());
            }
            last = next;
        }
        None
    }
}

/// The value of a parameter: as it is fixed, rounded, or as the call gives it.
fn value_of(spec: &Spec, parameter: Parameter, given: &dyn Fn(Parameter) -> f64) -> f64 {
    match spec.fixed.get(&parameter) {
        Some(fixed) => rounded(fixed, spec.precision),
        None => given(parameter),
    }
}

fn admitted(spec: &Spec, parameter: Parameter, value: &dyn Fn(Parameter) -> f64) -> bool {
    let own = value(parameter);
    match spec.domain(parameter) {
        Domain::Finite => own.is_finite(),
        Domain::Positive => spec.keeps_digits(parameter, own),
        Domain::PositiveOrInfinite => own > 0.0,
        Domain::BelowUMax | Domain::AboveUMin => {
            spec.admits_limits(value(Parameter::UMin), value(Parameter::UMax))
        }
        Domain::BelowTau => spec.keeps_digits(parameter, own) && own < value(Parameter::Tau),
        Domain::Within => spec.bounds.get(&parameter).is_some_and(|(least, greatest)| {
            let bound = |bound: &Fixed| {
                bound.number().map(|n| crate::program::number::round(n, spec.precision))
            };
            bound(least).is_none_or(|b| own >= b) && bound(greatest).is_none_or(|b| own <= b)
        }),
    }
}

/// Returns true if u is not a finite number of the precision.
fn is_beyond(spec: &Spec, u: f64) -> bool {
    let greatest = match spec.precision {
        Precision::F64 => f64::MAX,
        Precision::F32 => f64::from(f32::MAX),
    };
    u.is_nan() || u.abs() > greatest
}

/// The outcome within the limits of u and the range of the precision.
fn clipped(spec: &Spec, outcome: Outcome, limits: Range) -> Outcome {
    match outcome.u {
        u if is_beyond(spec, u) => Outcome { status: Status::Range, u: 0.0, ..outcome },
        u if u > limits.most => Outcome { status: Status::Saturated, u: limits.most, ..outcome },
        u if u < limits.least => Outcome { status: Status::Saturated, u: limits.least, ..outcome },
        _ => outcome,
    }
}

#[cfg(test)]
mod tests {
    use super::kept::POINTS;
    use super::*;
    use crate::diagnostic::Place;
    use crate::request::{Entry, read};
    use crate::syntax::parse;

    /// Whatever was asked before, in whatever order: the mapping is kept by all that it depends on.
    #[test]
    fn results_do_not_depend_on_earlier_calls() {
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
            let call = Call { parameter: &parameter, x0: &x0, t, x: &x, laws: &[], after: 0.0 };
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
