//! What time decides: time-to-go and the quantities that the families are evaluated in.

use num_traits::ToPrimitive;

use super::builder::Builder;
use crate::algebra::{BigInt, BigRational, Kind, Symbol};
use crate::mapping::Family;
use crate::program::{Input, Op, Value};
use crate::spec::{Fixed, Parameter};

impl Builder<'_> {
    /// Time-to-go T, held at eps.
    ///
    /// The deadline is kept as the unevaluated sum `deadline + correction` = t0 + tau (two-sum).
    /// Near the deadline `deadline - t` is exact (Sterbenz: the two are within a factor of 2), so
    /// T has one rounding for any t0, where tau - (t - t0) loses as many digits as t0/T has.
    pub(super) fn time_to_go(&mut self) -> Value {
        if let Some(held) = self.held {
            return held;
        }
        let start = self.push(Op::Input(Input::StartTime));
        let tau = self.parameter(Parameter::Tau);
        let high = self.add(start, tau);
        let high = self.name(high, "deadline", "t0 + tau, rounded");
        let virtual_tau = self.sub(high, start);
        let virtual_start = self.sub(high, virtual_tau);
        let start_error = self.sub(start, virtual_start);
        let tau_error = self.sub(tau, virtual_tau);
        let low = self.add(start_error, tau_error);
        let low = self.name(low, "correction", "what the rounding of t0 + tau left out");
        let time = self.push(Op::Input(Input::Time));
        let difference = self.sub(high, time);
        let time_to_go = self.add(difference, low);
        let eps = self.parameter(Parameter::Eps);
        let held = self.push(Op::Hold(time_to_go, eps));
        let held = self.name(held, "T", "time-to-go, held at eps");
        self.held = Some(held);
        held
    }

    /// Whether a quantity has been computed.
    pub(super) fn has_quantity(&self, symbol: Symbol) -> bool {
        self.quantities.contains_key(&symbol)
    }

    /// The value of a quantity that time decides.
    pub(super) fn quantity(&mut self, symbol: Symbol) -> Value {
        if let Some(value) = self.quantities.get(&symbol) {
            return *value;
        }
        let value = match symbol.kind {
            Kind::InverseTimeToGo => self.inverse_time_to_go(),
            Kind::InversePowerRatio => self.inverse_power_ratio(),
            Kind::Decay => self.decay(),
            Kind::Secant => self.secant(),
            Kind::StretchedAngle if self.spec.family == Family::Tan => self.cotangent(),
            Kind::StretchedAngle => self.slope(),
            Kind::OnePlusDecay => self.one_plus(Kind::Decay, 1),
            Kind::OnePlusSquare => self.one_plus(Kind::StretchedAngle, 2),
            // The law leaves only the quantities above in its rows.
            _ => self.time_to_go(),
        };
        let meaning = match symbol.kind {
            Kind::InverseTimeToGo => "1/T",
            Kind::InversePowerRatio => "(T/tau)^-m",
            Kind::Decay => "exp(-2*a*t) = T/(2*tau - T)",
            Kind::Secant => "1/sqrt(T*(2*tau - T)) = sqrt(1 + y^2)/tau",
            Kind::StretchedAngle => "a*t, t the stretched time since t0",
            Kind::OnePlusDecay => "1 + E",
            _ => "1 + y^2",
        };
        let value = self.name(value, &symbol.text(), meaning);
        self.quantities.insert(symbol, value);
        value
    }

    fn inverse_time_to_go(&mut self) -> Value {
        if self.spec.family == Family::Tanh {
            // One division serves 1/T and E.
            let (inverse, rest) = self.inverse_product();
            return self.mul(inverse, rest);
        }
        let (one, time_to_go) = (self.integer(1), self.time_to_go());
        self.div(one, time_to_go)
    }

    /// 1/(T (2 tau - T)) and 2 tau - T.
    fn inverse_product(&mut self) -> (Value, Value) {
        let time_to_go = self.time_to_go();
        let rest = self.rest();
        let (one, product) = (self.integer(1), self.mul(time_to_go, rest));
        (self.div(one, product), rest)
    }

    /// 2 tau - T, between tau and 2 tau: nothing cancels.
    fn rest(&mut self) -> Value {
        let (two, tau) = (self.integer(2), self.parameter(Parameter::Tau));
        let double = self.mul(two, tau);
        let time_to_go = self.time_to_go();
        self.sub(double, time_to_go)
    }

    /// E = T/(2 tau - T) as T * (T * 1/(T (2 tau - T))), which cannot underflow on the way.
    fn decay(&mut self) -> Value {
        let (inverse, _) = self.inverse_product();
        let time_to_go = self.time_to_go();
        let ratio = self.mul(time_to_go, inverse);
        self.mul(time_to_go, ratio)
    }

    /// q = (tau/T)^m: a multiplication chain for integer m, with a root for half an integer.
    fn inverse_power_ratio(&mut self) -> Value {
        let tau = self.parameter(Parameter::Tau);
        let inverse = self.quantity(Symbol::plain(Kind::InverseTimeToGo));
        let ratio = self.mul(tau, inverse);
        let fixed = self.spec.fixed.get(&Parameter::M).and_then(Fixed::number);
        let small = |m: &BigRational| {
            m.is_integer().then(|| m.to_u32()).flatten().filter(|m| (1..=64).contains(m))
        };
        if let Some(m) = fixed.and_then(small) {
            return self.power(ratio, m);
        }
        if let Some(twice) = fixed.map(|m| m * BigInt::from(2)).as_ref().and_then(small) {
            let root = self.push(Op::Sqrt(ratio));
            return self.power(root, twice);
        }
        let exponent = self.parameter(Parameter::M);
        self.push(Op::Pow(ratio, exponent))
    }

    /// y = cot(th), th = pi T/(2 tau): T keeps its digits, so y does, up to the deadline.
    fn cotangent(&mut self) -> Value {
        let half_pi = super::coefficient::pi() / BigInt::from(2);
        let half_pi = self.number(half_pi);
        let tau = self.parameter(Parameter::Tau);
        let scale = self.div(half_pi, tau);
        let scale = self.name(scale, "angle_rate", "pi/(2*tau)");
        let time_to_go = self.time_to_go();
        let angle = self.mul(time_to_go, scale);
        let (one, tangent) = (self.integer(1), self.push(Op::Tan(angle)));
        self.div(one, tangent)
    }

    /// 1/sqrt(T (2 tau - T)).
    fn secant(&mut self) -> Value {
        let time_to_go = self.time_to_go();
        let rest = self.rest();
        let product = self.mul(time_to_go, rest);
        let (one, root) = (self.integer(1), self.push(Op::Sqrt(product)));
        self.div(one, root)
    }

    /// y = (tau - T)/sqrt(T (2 tau - T)).
    fn slope(&mut self) -> Value {
        let (tau, time_to_go) = (self.parameter(Parameter::Tau), self.time_to_go());
        let elapsed = self.sub(tau, time_to_go);
        let secant = self.quantity(Symbol::plain(Kind::Secant));
        self.mul(elapsed, secant)
    }

    fn one_plus(&mut self, kind: Kind, power: u32) -> Value {
        let variable = self.quantity(Symbol::plain(kind));
        let power = self.power(variable, power);
        let one = self.integer(1);
        self.add(one, power)
    }
}
