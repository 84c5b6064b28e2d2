//! The Taylor series of mu at the stretched time of a tick, for every mapping.

use super::builder::Builder;
use super::coefficients::Coefficient;
use super::exp_sum;
use super::soft;
use super::taylor::{Point, Series};
use crate::algebra::{BigRational, integer};
use crate::expansion::Expanded;
use crate::expansion::bell::factorials;
use crate::expression::vanishing::vanishing;
use crate::expression::{Expression, Function, Subject, Variable};
use crate::family::Family;
use crate::mapping::{Form, Kappa, TimeMapping, time};
use crate::parameter::{Parameter, Precision};
use crate::program::{Op, Root, Value, number};

/// Rounds of Newton's method for stretched time, before bisection. Where mu decays like an exponential
/// it converges in three; where it decays like a power of t each round multiplies t by the logarithm
/// that is left, and twelve reach T/tau = 1e-12; for a small power it never arrives.
const PROPOSALS: u32 = 40;

/// mu(t + z) - mu(t) = r_1 (z + sum_{l>=2} c_l unit^(l-1) z^l).
#[derive(Clone, Debug)]
pub(super) struct Taylor {
    /// r_1 = mu'.
    pub(super) r1: Value,
    /// 1/r_1 = kappa'.
    pub(super) base_inverse: Value,
    /// c_2, ..., c_n.
    pub(super) tail: Vec<Coefficient>,
    /// Factor raised to the order of a term less 1; 1 where it is absent.
    pub(super) unit: Option<Value>,
    /// Stretched time since the start.
    pub(super) stretched: Value,
}

/// The series of the spec's mapping at the current time, or at the start.
pub(super) fn taylor(b: &mut Builder<'_>) -> Taylor {
    let spec = b.spec;
    if let Some(complement) = b.followed().cloned() {
        return of_complement(b, &vanishing(&complement, Variable::SinceStart));
    }
    match &spec.time_mapping {
        TimeMapping::Family { family: Family::ExpSum, .. } => exp_sum::taylor(b),
        TimeMapping::Family { family: Family::Soft, .. } => soft::taylor(b),
        // At the start every other term of an odd mu is 0: its own series has exact zeros there,
        // where kappa's leaves roundings.
        TimeMapping::Family { family, .. } => match time::form(*family, Subject::Mu) {
            Some(mu) if b.is_at_start() => {
                of_complement(b, &Expression::from(Parameter::Tau).sub(mu))
            }
            _ => of_kappa(b, &Kappa::of(*family)),
        },
        TimeMapping::Custom(custom) => match (custom.form.kept(), b.expanded) {
            // They are of one order; an output of a higher one takes the series.
            (form, Some(Expanded::Custom(r))) if r.len() >= spec.n => of_closed_forms(b, &form, r),
            (Form::Complement(form), _) => of_complement(b, &form),
            (Form::Kappa(kappa), _) => of_kappa(b, &kappa),
        },
    }
}

/// From the closed forms r_1, ..., r_n of a mapping that the user wrote down.
fn of_closed_forms(b: &mut Builder<'_>, form: &Form, r: &[Expression]) -> Taylor {
    let (stretched, values): (_, Vec<_>) = match form {
        Form::Kappa(kappa) => {
            let stretched = b.scalar(&kappa.form);
            let values =
                r.iter().map(|r| Coefficient::Value(b.scalar(&vanishing(r, Variable::TimeToGo))));
            (stretched, values.collect())
        }
        Form::Complement(form) => {
            let stretched = if b.is_at_start() { None } else { Some(stretched_time(b, form)) };
            let point = around(1, stretched);
            let value = |r| {
                let series = b.series(r, &point);
                b.value_at(&series)
            };
            let values = r.iter().map(value).collect();
            (stretched.unwrap_or_else(|| b.integer(0)), values)
        }
    };
    let r1 = b.coefficient(&values[0]);
    let one = b.integer(1);
    let base_inverse = b.div(one, r1);
    let base_inverse = b.name(base_inverse, "inv_r1", "1/r1 = kappa'");
    let factorials = factorials(r.len()).into_iter().map(BigRational::from_integer);
    let tail = values
        .iter()
        .zip(factorials.skip(1))
        .skip(1)
        .map(|(value, factorial)| {
            let ratio = b.times(value, &Coefficient::Value(base_inverse));
            b.over(&ratio, &Coefficient::Exact(factorial))
        })
        .collect();
    Taylor { r1, base_inverse, tail, unit: None, stretched }
}

/// From kappa in the time-to-go, by the stretched-time derivative D = r_1 d/dDt. With T (1 - s) in
/// place of T it is unit (1 - s) g(s) d/ds, where unit = r_1/T now and g(0) = 1: everything has the
/// size of mu's own series, where powers of 1/T would leave the range. So r_k = T unit^k f_k(0) with
/// f_1 = (1 - s) g and f_(k+1) = f_1 f_k'.
fn of_kappa(b: &mut Builder<'_>, kappa: &Kappa) -> Taylor {
    let time_to_go = b.time_to_go();
    let n = b.spec.n;
    let scale = Some(time_to_go);
    let series = Series { offset: None, scale, terms: leading_terms(n, 1, -1) };
    let own = series.terms.clone();
    let point = Point::of(Variable::TimeToGo, series);
    let stretched = b.scalar(&kappa.form);
    let rate = b.series(&kappa.rate, &point);
    let (unit, rate) = b.leading(rate);
    let unit = b.name(unit, "unit", "r1/T");
    let first = b.product(&own, &rate);
    let mut tail = Vec::with_capacity(n);
    let mut last = first.clone();
    for l in 2..=n {
        let slope: Vec<_> =
            (1..last.len()).map(|k| b.times(&Coefficient::index(k), &last[k])).collect();
        last = b.product(&slope, &first[..slope.len()]);
        let factorial = Coefficient::Exact(BigRational::from_integer(factorials(l)[l].clone()));
        tail.push(b.over(&last[0], &factorial));
    }
    let r1 = b.mul(time_to_go, unit);
    let one = b.integer(1);
    let base_inverse = b.div(one, r1);
    let base_inverse = b.name(base_inverse, "inv_r1", "1/r1 = kappa'");
    Taylor { r1, base_inverse, tail, unit: Some(unit), stretched }
}

/// From the complement c(t) = tau - mu(t). At the stretched time c is the time-to-go, so where c is
/// one scale times exact terms, the scale is known without that time.
fn of_complement(b: &mut Builder<'_>, form: &Expression) -> Taylor {
    let stretched = match (b.is_at_start(), b.followed()) {
        (true, _) => None,
        (false, Some(_)) => Some(b.since_start()),
        (false, None) => Some(stretched_time(b, form)),
    };
    let point = around(b.spec.n, stretched);
    let mut series = b.series(form, &point);
    if let (None, Coefficient::Exact(first)) = (series.offset, &series.terms[0])
        && *first != integer(0)
    {
        let (share, time_to_go) = (b.number(first.recip()), b.time_to_go());
        series.scale = Some(b.mul(share, time_to_go));
    }
    let slope = b.negative(&series.terms[1]);
    let r1 = b.scaled(series.scale, &slope);
    let r1 = b.coefficient(&r1);
    let (one, zero) = (b.integer(1), b.integer(0));
    let base_inverse = b.div(one, r1);
    Taylor {
        r1,
        base_inverse: b.name(base_inverse, "inv_r1", "1/r1 = kappa'"),
        tail: ratios(b, &series.terms),
        unit: None,
        stretched: stretched.unwrap_or(zero),
    }
}

/// The series of t at `at`; none for 0.
fn around(n: usize, at: Option<Value>) -> Point {
    let series = Series { offset: at, scale: None, terms: leading_terms(n, 0, 1) };
    Point::of(Variable::SinceStart, series)
}

fn leading_terms(n: usize, first: i64, second: i64) -> Vec<Coefficient> {
    let mut terms = vec![Coefficient::integer(0); n + 1];
    terms[0] = Coefficient::integer(first);
    terms[1] = Coefficient::integer(second);
    terms
}

/// a_l/a_1 for l = 2..n.
fn ratios(b: &mut Builder<'_>, terms: &[Coefficient]) -> Vec<Coefficient> {
    let one = Coefficient::integer(1);
    // A slope that is 0 at generation belongs to no mapping; the program then gives no number.
    let inverse = match &terms[1] {
        zero if zero.is_zero() => Coefficient::integer(0),
        first => b.over(&one, first),
    };
    terms[2..].iter().map(|term| b.times(term, &inverse)).collect()
}

/// Stretched time: the root y of ln(c(y)/T), which decreases, by Newton's method within a bracket.
fn stretched_time(b: &mut Builder<'_>, form: &Expression) -> Value {
    let target = b.time_to_go();
    let (low, start) = (b.integer(0), b.integer(0));
    let [_, far] = Root::range(b.spec.precision);
    let small = match b.spec.precision {
        Precision::F64 => 9,
        Precision::F32 => 4,
    };
    let ten = |exponent| num_traits::pow(BigRational::from_integer(10.into()), exponent);
    let (high, tolerance) = (b.number(number::finite(far)), b.number(ten(small).recip()));
    let unknown = b.push(Op::Unknown);
    let unknown = b.name(unknown, "y", "stretched time since t0");
    let series = b.series(form, &around(1, Some(unknown)));
    let value = b.value_at(&series);
    let value = b.coefficient(&value);
    let slope = b.scaled(series.scale, &series.terms[1]);
    let slope = b.coefficient(&slope);
    let share = b.div(value, target);
    let residual = b.push(Op::Call(Function::Ln, share));
    let period = b.div(value, slope);
    let step = b.mul(residual, period);
    let next = b.sub(unknown, step);
    let size = b.push(Op::Call(Function::Abs, residual));
    let proposals = PROPOSALS;
    let rounds = proposals + Root::bisections(b.spec.precision);
    b.push(Op::Root(Root {
        unknown,
        start,
        low,
        high,
        residual,
        next,
        size,
        tolerance,
        proposals,
        rounds,
    }))
}
