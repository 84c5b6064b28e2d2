//! The tan family: th cot(th) for th in (0, pi/2], as a polynomial in z = (2 th/pi)^2.

use super::builder::Builder;
use super::coefficient::pi_power;
use crate::algebra::{BigInt, BigRational, Kind, Symbol};
use crate::expression::{Expression, Function, Node, Variable, normal};
use crate::parameter::{Fixed, Parameter, Precision};
use crate::program::Value;
use crate::syntax::number;

/// Chebyshev interpolation of (th cot(th) - 1)/z on z in [0, 1]; `tools/cotangent.py` computes the
/// digits. The error of the polynomial is below 1e-17 for doubles and 1e-9 for floats, under their
/// rounding; its value at z = 0 is exactly 1.
const DOUBLE: [&str; 16] = [
    "1",
    "-0.8224670334241132251796298",
    "-0.1352904042138891511353634",
    "-0.03179197068724655390115685",
    "-0.007844354338480026265218381",
    "-0.001955067633906800998450036",
    "-0.0004884004503196425541004726",
    "-0.0001220835203284645535345076",
    "-0.00003049467456647585869177472",
    "-0.000007696335899623562375345749",
    "-0.000001770960718378077593529401",
    "-0.0000006748341805449632731463499",
    "8.247582914168543903952877e-8",
    "-0.0000001686793943368802314616409",
    "5.218809974156137767076461e-8",
    "-1.491088565005930170909682e-8",
];

const SINGLE: [&str; 9] = [
    "1",
    "-0.8224670327180559214258792",
    "-0.1352904944127121567446691",
    "-0.03179009535467763703261663",
    "-0.007859068568899917047875992",
    "-0.001899098360419394660155544",
    "-0.0006016576053287794326543454",
    "-7.244605171761672856672724e-9",
    "-0.00009254479389159899052654278",
];

/// The coefficients by ascending power of z.
fn coefficients(precision: Precision) -> Vec<BigRational> {
    let digits: &[&str] = match precision {
        Precision::F64 => &DOUBLE,
        Precision::F32 => &SINGLE,
    };
    digits.iter().filter_map(|text| number(text)?.number().cloned()).collect()
}

impl Builder<'_> {
    /// 1/T^2 and th cot(th), th = pi T/(2 tau), whose products make up the tan family:
    /// (pi/(2 tau)) cot(th) = T (1/T^2) th cot(th), and its square is (1/T^2) (th cot(th))^2.
    ///
    /// th cot(th) is 1 at the deadline and smooth, so a polynomial in (T/tau)^2 gives it, and 1/T^2
    /// carries the digits there with two roundings, where 1/tan(th)^2 has nine. No library function
    /// is called, so every machine computes the same bits.
    pub(super) fn tangent_parts(&mut self) -> (Value, Value) {
        let (one, square, share) = (self.integer(1), self.late_squared(), self.late_share());
        let inverse = self.div(one, square);
        let inverse = self.name(inverse, "inv_T_squared", "1/T^2");
        let square = self.mul(share, share);
        let mut shape = one;
        for (index, coefficient) in coefficients(self.spec.precision).into_iter().rev().enumerate()
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

    /// cos(th)/sin(th) for that angle, without a library function; none of any other expression.
    pub(super) fn cotangent(&mut self, expression: &Expression) -> Option<Value> {
        let Node::Div(cos, sin) = expression.node() else { return None };
        let (Node::Call(Function::Cos, angle), Node::Call(Function::Sin, other)) =
            (cos.node(), sin.node())
        else {
            return None;
        };
        let tau = self.spec.fixed.get(&Parameter::Tau).and_then(Fixed::number);
        let tau = tau.map_or(Parameter::Tau.into(), |tau| Expression::from(tau.clone()));
        let quarter = Expression::pi().mul(Variable::TimeToGo.into());
        let share = Expression::integer(2).mul(tau).mul(angle.clone()).div(quarter);
        if angle != other || normal::normal(&share) != Expression::integer(1) {
            return None;
        }
        let rate = self.cotangent_rate();
        let scale = self.inverse_angle_rate();
        Some(self.mul(scale, rate))
    }

    /// 2 tau/pi.
    fn inverse_angle_rate(&mut self) -> Value {
        let inverse = (pi_power(1) / BigInt::from(2)).recip();
        let (inverse, tau) = (self.number(inverse), self.parameter(Parameter::Tau));
        let scale = self.mul(inverse, tau);
        self.name(scale, "inv_angle_rate", "2*tau/pi")
    }

    pub(super) fn cotangent_rate(&mut self) -> Value {
        let (inverse, shape) = self.tangent_parts();
        let time_to_go = self.time_to_go();
        let inverse = self.mul(time_to_go, inverse);
        self.mul(inverse, shape)
    }

    /// kappa'/a = pi/(2 tau) + (2 tau/pi) cot_rate^2.
    pub(super) fn slope(&mut self) -> Value {
        let half_pi = pi_power(1) / BigInt::from(2);
        let tau = self.parameter(Parameter::Tau);
        let quarter = self.number(half_pi);
        let first = self.div(quarter, tau);
        let first = self.name(first, "angle_rate", "pi/(2*tau)");
        let scale = self.inverse_angle_rate();
        let square = self.square(Symbol::plain(Kind::CotangentRate));
        let scaled = square.map(|square| self.mul(scale, square));
        self.sum(Some(first), scaled).unwrap_or(first)
    }
}

#[cfg(test)]
mod tests {
    use num_traits::ToPrimitive;

    use super::*;

    fn error(precision: Precision) -> f64 {
        let coefficients: Vec<f64> =
            coefficients(precision).iter().map(|c| c.to_f64().unwrap_or(f64::NAN)).collect();
        (1..=1000)
            .map(|i| {
                let z = f64::from(i) / 1000.0;
                let angle = std::f64::consts::FRAC_PI_2 * z.sqrt();
                let sum = coefficients.iter().rev().fold(0.0, |sum, c| sum * z + c);
                (sum - angle / angle.tan()).abs()
            })
            .fold(0.0, f64::max)
    }

    /// Against the library's tangent, whose own error and that of the angle is a few ulp of 1.
    #[test]
    fn the_polynomials_are_th_cot_th() {
        assert!(error(Precision::F64) < 5e-16, "{}", error(Precision::F64));
        assert!(error(Precision::F32) < 2e-9, "{}", error(Precision::F32));
    }
}
