//! The quantities that the families are evaluated in, once time is given.

use num_traits::ToPrimitive;

use super::builder::Builder;
use crate::algebra::{BigInt, BigRational, Kind, Symbol};
use crate::expression::Function;
use crate::family::Family;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Op, Value};

impl Builder<'_> {
    /// Returns true if a quantity has been computed.
    pub(super) fn has_quantity(&self, symbol: Symbol) -> bool {
        self.quantities.contains_key(&symbol)
    }

    /// The value of a quantity that time decides.
    pub(super) fn quantity(&mut self, symbol: Symbol) -> Value {
        if let Some(value) = self.quantities.get(&symbol) {
            return *value;
        }
        if let Some(own) = self.values.get(&symbol).cloned() {
            let value = self.scalar(&own);
            let value = match symbol.kind {
                Kind::Kernel => value,
                _ => self.name(value, &symbol.text(), &own.to_string()),
            };
            self.quantities.insert(symbol, value);
            return value;
        }
        let value = match symbol.kind {
            Kind::InverseTimeToGo => self.inverse_time_to_go(),
            Kind::InverseSquare => self.inverse_square(),
            Kind::InversePowerRatio => self.inverse_power_ratio(),
            Kind::Decay => self.decay(),
            Kind::Secant => self.secant(),
            Kind::StretchedAngle => self.algebraic_angle(),
            Kind::OnePlusDecay => self.one_plus_decay(),
            Kind::OnePlusSquare => self.one_plus_square(),
            Kind::InverseProduct => self.inverse_product(),
            Kind::CosineSquare => self.cosine_square(),
            Kind::AngleOverSquare => self.angle_over_square(),
            Kind::InverseCube => self.inverse_cube(),
            Kind::CotangentRate => self.cotangent_rate(),
            Kind::Slope => self.slope(),
            Kind::InverseLag => self.inverse_lag(),
            Kind::Bend => self.bend(),
            other => {
                debug_assert_eq!(other, Kind::TimeToGo, "the law leaves no other in its rows");
                self.time_to_go()
            }
        };
        let meaning = symbol.definition().unwrap_or(match symbol.kind {
            Kind::Decay => "exp(-2*a*t) = T/(2*tau - T)",
            Kind::Bend => "(1 - start)*E/S^2, E = exp(-a*t), S = tau*dE/dT",
            _ => "a*t, t the stretched time since t0",
        });
        let value = self.name(value, &symbol.text(), meaning);
        self.quantities.insert(symbol, value);
        value
    }

    fn inverse_time_to_go(&mut self) -> Value {
        if self.spec.family() == Some(Family::Power) {
            let (ratio, inverse_tau) = (self.inverse_share(), self.inverse_tau());
            return self.mul(ratio, inverse_tau);
        }
        let (minus_one, late) = (self.integer(-1), self.late());
        self.div(minus_one, late)
    }

    /// 1/T^2, of the time past the deadline, whose square it shares.
    fn inverse_square(&mut self) -> Value {
        let (one, square) = (self.integer(1), self.late_squared());
        self.div(one, square)
    }

    /// E = T/(2 tau - T), by a division of its own: it waits for none other, and has two roundings.
    fn decay(&mut self) -> Value {
        let (late, rest) = (self.late(), self.minus_rest());
        self.div(late, rest)
    }

    /// 2 tau/(T (2 tau - T)), three roundings: no sum in it cancels.
    fn inverse_product(&mut self) -> Value {
        let (late, rest, double) = (self.late(), self.minus_rest(), self.two_tau());
        let product = self.mul(late, rest);
        self.div(double, product)
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
            let root = self.push(Op::Call(Function::Sqrt, ratio));
            return self.power(root, twice);
        }
        let exponent = self.parameter(Parameter::M);
        self.push(Op::Pow(ratio, exponent))
    }

    /// 1 + y^2 = tau^2/(T (2 tau - T)) as (tau/2)/T + (tau/2)/(2 tau - T): the first has one
    /// rounding and leads near the deadline, where the product form has four.
    fn one_plus_square(&mut self) -> Value {
        let (late, tau) = (self.late(), self.parameter(Parameter::Tau));
        let rest = self.rest();
        let half = self.number(BigRational::new(1.into(), 2.into()));
        let half_tau = self.mul(half, tau);
        let half_tau = self.name(half_tau, "half_tau", "tau/2");
        let (near, far) = (self.div(half_tau, late), self.div(half_tau, rest));
        self.sub(far, near)
    }

    /// sqrt(1 + y^2).
    fn secant(&mut self) -> Value {
        let square = self.quantity(Symbol::plain(Kind::OnePlusSquare));
        self.push(Op::Call(Function::Sqrt, square))
    }

    /// y = (1 - T/tau) sqrt(1 + y^2), the first factor as (tau - T)/tau: no rounding of 1/tau is left of it at the
    /// start, where it is 0.
    fn algebraic_angle(&mut self) -> Value {
        let (late, tau, inverse) =
            (self.late(), self.parameter(Parameter::Tau), self.inverse_tau());
        let elapsed = self.add(tau, late);
        let elapsed = self.mul(elapsed, inverse);
        let secant = self.quantity(Symbol::plain(Kind::Secant));
        self.mul(elapsed, secant)
    }

    /// h^2 = w (2 - w) with w = T/tau: no sum in it cancels, so it has the digits of w.
    fn cosine_square(&mut self) -> Value {
        let (minus_two, share) = (self.integer(-2), self.late_share());
        let rest = self.sub(minus_two, share);
        self.mul(share, rest)
    }

    /// 1/h^2 and 1/h: their product leaves the range where u does, h^3 sooner.
    fn inverse_cosines(&mut self) -> (Value, Value) {
        let (one, square) = (self.integer(1), self.quantity(Symbol::plain(Kind::CosineSquare)));
        let inverse = self.div(one, square);
        (inverse, self.push(Op::Call(Function::Sqrt, inverse)))
    }

    /// 1/h^3: one and a half times the error of h^2, and two roundings.
    fn inverse_cube(&mut self) -> Value {
        let (square, single) = self.inverse_cosines();
        self.mul(square, single)
    }

    /// y h^2 = (1 - w) h: the difference is as exact as time is.
    fn angle_over_square(&mut self) -> Value {
        let (one, share) = (self.integer(1), self.late_share());
        let elapsed = self.add(share, one);
        let square = self.quantity(Symbol::plain(Kind::CosineSquare));
        let (_, inverse) = self.inverse_cosines();
        let cosine = self.mul(square, inverse);
        let cosine = self.name(cosine, "h", "1/sqrt(1 + y^2)");
        self.mul(elapsed, cosine)
    }

    /// The square of a quantity in which rows are evaluated by their even and odd parts; none
    /// for one in which they are not.
    pub(super) fn square(&mut self, symbol: Symbol) -> Option<Value> {
        if let Some(square) = self.squares.get(&symbol) {
            return Some(*square);
        }
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
        let square = self.name(square, &name, &format!("{}^2", symbol.text()));
        self.squares.insert(symbol, square);
        Some(square)
    }

    fn one_plus_decay(&mut self) -> Value {
        let (one, decay) = (self.integer(1), self.quantity(Symbol::plain(Kind::Decay)));
        self.add(one, decay)
    }
}
