//! What time decides: time-to-go and the quantities that the families are evaluated in.

use num_traits::ToPrimitive;

use super::builder::Builder;
use crate::algebra::{BigInt, BigRational, Kind, Symbol};
use crate::mapping::Family;
use crate::program::{Input, Op, Value};
use crate::spec::{Fixed, Parameter};

impl Builder<'_> {
    /// Time past the deadline, -T, held at -eps.
    ///
    /// The deadline is kept as the unevaluated sum `deadline + correction` = t0 + tau (two-sum).
    /// Near the deadline `t - deadline` is exact (Sterbenz: the two are within a factor of 2), so
    /// -T has one rounding for any t0, where tau - (t - t0) loses as many digits as t0/T has.
    pub(super) fn late(&mut self) -> Value {
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
        let past = self.sub(time, high);
        let past = self.sub(past, low);
        let past = self.name(past, "past", "time past the deadline, negative before it");
        let hold_from = self.hold_from();
        let late = self.push(Op::Min(past, hold_from));
        self.name(late, "late", "-T: time past the deadline, held at -eps")
    }

    /// -eps, where the hold begins.
    pub(super) fn hold_from(&mut self) -> Value {
        let eps = self.parameter(Parameter::Eps);
        let hold_from = self.push(Op::Neg(eps));
        self.name(hold_from, "hold_from", "-eps: later than this the gains are held")
    }

    /// Time-to-go T, held at eps.
    pub(super) fn time_to_go(&mut self) -> Value {
        let late = self.late();
        let time_to_go = self.push(Op::Neg(late));
        self.name(time_to_go, "T", "time-to-go, held at eps")
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
            Kind::CotangentRate => self.cotangent_rate(),
            Kind::Slope => self.slope(),
            Kind::StretchedAngle => self.algebraic_angle(),
            Kind::OnePlusDecay => self.one_plus_decay(),
            Kind::OnePlusSquare => self.one_plus_square(),
            // The law leaves only the quantities above in its rows.
            _ => self.time_to_go(),
        };
        let meaning = symbol.definition().unwrap_or(match symbol.kind {
            Kind::Decay => "exp(-2*a*t) = T/(2*tau - T)",
            _ => "a*t, t the stretched time since t0",
        });
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
        if self.spec.family == Family::Power {
            let (ratio, inverse_tau) = (self.inverse_share(), self.inverse_tau());
            return self.mul(ratio, inverse_tau);
        }
        let (minus_one, late) = (self.integer(-1), self.late());
        self.div(minus_one, late)
    }

    /// 1/(T (2 tau - T)) and 2 tau - T.
    fn inverse_product(&mut self) -> (Value, Value) {
        let late = self.late();
        let rest = self.rest();
        let (minus_one, product) = (self.integer(-1), self.mul(late, rest));
        (self.div(minus_one, product), rest)
    }

    /// 2 tau - T, between tau and 2 tau: nothing cancels.
    fn rest(&mut self) -> Value {
        let (two, tau) = (self.integer(2), self.parameter(Parameter::Tau));
        let double = self.mul(two, tau);
        let double = self.name(double, "two_tau", "2*tau");
        let late = self.late();
        self.add(double, late)
    }

    /// E = T/(2 tau - T) as T * (T * 1/(T (2 tau - T))), which cannot underflow on the way.
    fn decay(&mut self) -> Value {
        let (inverse, _) = self.inverse_product();
        let late = self.late();
        let ratio = self.mul(late, inverse);
        self.mul(late, ratio)
    }

    /// tau/T with one rounding, for the power family raises it to the power m (n+1-j).
    fn inverse_share(&mut self) -> Value {
        let (tau, late) = (self.parameter(Parameter::Tau), self.late());
        let minus_tau = self.push(Op::Neg(tau));
        let minus_tau = self.name(minus_tau, "minus_tau", "-tau");
        let ratio = self.div(minus_tau, late);
        self.name(ratio, "inv_w", "tau/T")
    }

    /// 1/tau.
    fn inverse_tau(&mut self) -> Value {
        let (one, tau) = (self.integer(1), self.parameter(Parameter::Tau));
        let inverse_tau = self.div(one, tau);
        self.name(inverse_tau, "inv_tau", "1/tau")
    }

    /// q = (tau/T)^m: a multiplication chain for integer m, with a root for half an integer.
    fn inverse_power_ratio(&mut self) -> Value {
        let ratio = self.inverse_share();
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

    /// 1/T^2 and th cot(th), th = pi T/(2 tau), whose products make up the tan family:
    /// (pi/(2 tau)) cot(th) = T (1/T^2) th cot(th), and its square is (1/T^2) (th cot(th))^2.
    ///
    /// th cot(th) is 1 at the deadline and smooth, so a polynomial in (T/tau)^2 gives it, and 1/T^2
    /// carries the digits there with two roundings, where 1/tan(th)^2 has nine. No library function
    /// is called, so every machine computes the same bits.
    fn tangent_parts(&mut self) -> (Value, Value) {
        let (one, late, share) = (self.integer(1), self.late(), self.late_share());
        let square = self.mul(late, late);
        let inverse = self.div(one, square);
        let inverse = self.name(inverse, "inv_T_squared", "1/T^2");
        let square = self.mul(share, share);
        let mut shape = one;
        for (index, coefficient) in
            super::cotangent::coefficients(self.spec.precision).into_iter().rev().enumerate()
        {
            let coefficient = self.number(coefficient);
            shape = if index == 0 {
                coefficient
            } else {
                let shifted = self.mul(shape, square);
                self.add(shifted, coefficient)
            };
        }
        let shape = self.name(shape, "th_cot_th", "th*cot(th), th = pi*T/(2*tau)");
        (inverse, shape)
    }

    fn cotangent_rate(&mut self) -> Value {
        let (inverse, shape) = self.tangent_parts();
        let time_to_go = self.time_to_go();
        let inverse = self.mul(time_to_go, inverse);
        self.mul(inverse, shape)
    }

    /// kappa'/a = pi/(2 tau) + (2 tau/pi) cot_rate^2.
    fn slope(&mut self) -> Value {
        let half_pi = super::coefficient::pi_power(1) / BigInt::from(2);
        let tau = self.parameter(Parameter::Tau);
        let (quarter, inverse) = (self.number(half_pi.clone()), self.number(half_pi.recip()));
        let first = self.div(quarter, tau);
        let first = self.name(first, "angle_rate", "pi/(2*tau)");
        let scale = self.mul(inverse, tau);
        let scale = self.name(scale, "inv_angle_rate", "2*tau/pi");
        let square = self.square(Symbol::plain(Kind::CotangentRate));
        let scaled = square.map(|square| self.mul(scale, square));
        self.sum(Some(first), scaled).unwrap_or(first)
    }

    /// 1 + y^2 = tau^2/(T (2 tau - T)) as (tau/2)/T + (tau/2)/(2 tau - T): the first has one
    /// rounding and leads near the deadline, where the product form has four.
    fn one_plus_square(&mut self) -> Value {
        let (time_to_go, tau) = (self.time_to_go(), self.parameter(Parameter::Tau));
        let rest = self.rest();
        let half = self.number(BigRational::new(1.into(), 2.into()));
        let half_tau = self.mul(half, tau);
        let half_tau = self.name(half_tau, "half_tau", "tau/2");
        let (near, far) = (self.div(half_tau, time_to_go), self.div(half_tau, rest));
        self.add(near, far)
    }

    /// -T/tau.
    fn late_share(&mut self) -> Value {
        let (late, inverse_tau) = (self.late(), self.inverse_tau());
        self.mul(late, inverse_tau)
    }

    /// sqrt(1 + y^2).
    fn secant(&mut self) -> Value {
        let square = self.quantity(Symbol::plain(Kind::OnePlusSquare));
        self.push(Op::Sqrt(square))
    }

    /// y = (1 - T/tau) sqrt(1 + y^2).
    fn algebraic_angle(&mut self) -> Value {
        let (one, share) = (self.integer(1), self.late_share());
        let elapsed = self.add(share, one);
        let secant = self.quantity(Symbol::plain(Kind::Secant));
        self.mul(elapsed, secant)
    }

    /// The square of a quantity in which rows are evaluated by their even and odd parts; none
    /// for one in which they are not.
    pub(super) fn square(&mut self, symbol: Symbol) -> Option<Value> {
        let square = match symbol.kind {
            Kind::CotangentRate => {
                let (inverse, shape) = self.tangent_parts();
                let shape_squared = self.mul(shape, shape);
                self.mul(inverse, shape_squared)
            }
            Kind::StretchedAngle => {
                let (one, sum) =
                    (self.integer(1), self.quantity(Symbol::plain(Kind::OnePlusSquare)));
                self.sub(sum, one)
            }
            _ => return None,
        };
        let name = format!("{}_squared", symbol.text());
        Some(self.name(square, &name, &format!("{}^2", symbol.text())))
    }

    fn one_plus_decay(&mut self) -> Value {
        let (one, decay) = (self.integer(1), self.quantity(Symbol::plain(Kind::Decay)));
        self.add(one, decay)
    }
}
