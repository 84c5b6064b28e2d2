//! The soft family: E = e^{-a t} = w (1 + c (1 - w)), w = T/tau, c = 1 - start, S = dE/dw.

use super::builder::Builder;
use super::coefficients::Coefficient;
use super::mapping::Taylor;
use crate::algebra::{BigRational, Kind, Monomial, Symbol, integer};
use crate::expansion::bell::factorials;
use crate::expression::Function;
use crate::family::Family;
use crate::mapping::Mapping;
use crate::parameter::Parameter;
use crate::program::{Input, Op, Value};

/// Values that depend on one time.
struct Point {
    /// tau^2 E = T (tau + c Dt).
    decay: Value,
    /// tau S = start tau + 2 c Dt: a sum of two positive terms, where 1 + c - 2 c w cancels at the
    /// start.
    slope: Value,
}

impl Builder<'_> {
    /// c = 1 - start.
    fn softness(&mut self) -> Value {
        let (one, start) = (self.integer(1), self.parameter(Parameter::Start));
        let softness = self.sub(one, start);
        self.name(softness, "softness", "1 - start")
    }

    /// Elapsed time Dt, held with the time-to-go. It is taken from t - t0, which has one rounding
    /// at the start, where tau - T has that of tau.
    fn held_elapsed(&mut self) -> Value {
        if self.counts_down() || self.followed().is_some() {
            return self.elapsed_of_plant();
        }
        let (time, start) = (Op::Input(Input::Time), Op::Input(Input::StartTime));
        let (time, start) = (self.push(time), self.push(start));
        let since = self.sub(time, start);
        let (tau, eps) = (self.parameter(Parameter::Tau), self.parameter(Parameter::Eps));
        let last = self.sub(tau, eps);
        let last = self.name(last, "hold_after", "tau - eps: the gains are held from there on");
        let elapsed = self.push(Op::Min(since, last));
        self.elapsed = Some((elapsed, tau));
        self.name(elapsed, "elapsed", "time since the start, held at tau - eps")
    }

    /// E and S of the current time, or of the start.
    fn soft(&mut self) -> Point {
        let tau = self.parameter(Parameter::Tau);
        let start = self.parameter(Parameter::Start);
        let first = self.mul(start, tau);
        let first = self.name(first, "first_slope", "start*tau");
        if self.is_at_start() {
            return Point { decay: self.mul(tau, tau), slope: first };
        }
        let (softness, two) = (self.softness(), self.integer(2));
        let (elapsed, time_to_go) = (self.held_elapsed(), self.time_to_go());
        let more = self.mul(softness, elapsed);
        let rest = self.add(tau, more);
        let decay = self.mul(time_to_go, rest);
        let decay = self.name(decay, "decay", "tau^2*E, E = exp(-a*t)");
        let twice = self.mul(two, more);
        let slope = self.add(first, twice);
        Point { decay, slope: self.name(slope, "fall", "tau*S, S = tau*dE/dT") }
    }

    /// 1/H = S/(tau E).
    pub(super) fn inverse_lag(&mut self) -> Value {
        let Point { decay, slope } = self.soft();
        self.div(slope, decay)
    }

    /// y = c E/S^2 = c H/(tau S): the square of tau S alone would leave the range where tau is small.
    pub(super) fn bend(&mut self) -> Value {
        let Point { decay, slope } = self.soft();
        let inverse = if self.is_at_start() {
            self.div(slope, decay)
        } else {
            self.quantity(Symbol::plain(Kind::InverseLag))
        };
        let (softness, square) = (self.softness(), self.mul(slope, inverse));
        self.div(softness, square)
    }
}

/// r_l/(r_1 l!) = a^(l-1) p_l(y)/l!, by the closed forms.
pub(super) fn taylor(b: &mut Builder<'_>) -> Taylor {
    let n = b.spec.n;
    let (bend, lag) = (Symbol::plain(Kind::Bend), Symbol::plain(Kind::Lag));
    // Those of the start are no quantities of a tick.
    let [y, inverse] = if b.is_at_start() {
        [b.bend(), b.inverse_lag()]
    } else {
        [bend, Symbol::plain(Kind::InverseLag)].map(|symbol| b.quantity(symbol))
    };
    let ring = Mapping::of(Family::Soft, 0);
    let mut r = ring.r1.clone();
    let mut tail = Vec::with_capacity(n);
    for (l, factorial) in factorials(n).into_iter().enumerate().skip(2) {
        r = ring.derive(&r);
        let exponent = i32::try_from(l).unwrap_or(i32::MAX);
        let common =
            Monomial::power(Symbol::plain(Kind::A), exponent).times(&Monomial::power(lag, 1));
        let share = BigRational::from_integer(factorial).recip();
        let weights = r.shifted(&common.pow(-1)).scaled(&share);
        let mut sum: Option<Value> = None;
        for power in (0..exponent).rev() {
            let weight = weights.coefficient(&Monomial::power(bend, power));
            debug_assert!(weight != integer(0), "p_l has every power below l");
            let weight = b.number(weight);
            sum = Some(match sum {
                Some(sum) => {
                    let shifted = b.mul(sum, y);
                    b.add(shifted, weight)
                }
                None => weight,
            });
        }
        tail.extend(sum.map(Coefficient::Value));
    }
    let a = b.parameter(Parameter::A);
    let (decay, tau) = (b.soft().decay, b.parameter(Parameter::Tau));
    let stretched = if b.is_at_start() {
        b.integer(0)
    } else {
        let square = b.mul(tau, tau);
        let share = b.div(decay, square);
        let phase = b.push(Op::Call(Function::Ln, share));
        let phase = b.push(Op::Neg(phase));
        b.div(phase, a)
    };
    let base_inverse = b.div(inverse, a);
    let base_inverse = b.name(base_inverse, "inv_r1", "1/r1 = kappa'");
    let r1 = b.div(a, inverse);
    Taylor { r1, base_inverse, tail, unit: Some(a), stretched }
}
