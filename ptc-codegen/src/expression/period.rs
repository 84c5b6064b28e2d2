//! Expressions in which time turns angles and nothing else.

use num_traits::ToPrimitive;

use super::normal::normal;
use super::{Expression, Function, Node, Variable};
use crate::algebra::{BigRational, integer};

/// Expression that repeats, as a function of an angle.
pub(crate) struct Periodic {
    pub(crate) of_angle: Expression,
    /// Variable that represents the angle.
    pub(crate) angle: Variable,
    /// Circles until it repeats.
    pub(crate) circles: f64,
}

/// Returns an expression as a function of one angle, in units of which all its angles have whole or rational speeds;
/// `None` if time does anything else in it.
///
/// `2*sin(w*t/2)*cos(w*t/2)` becomes `2*sin(dt)*cos(dt)`, dt the angle, and repeats after a circle.
pub(crate) fn periodic(e: &Expression) -> Option<Periodic> {
    let times = [Variable::Time, Variable::Elapsed];
    let mut times = times.into_iter().filter(|time| e.contains(*time));
    let (time, None) = (times.next()?, times.next()) else { return None };
    let speed = |angle: &Expression| {
        let speed = normal(&angle.derivative(time));
        (!speed.contains(time) && speed != Expression::integer(0)).then_some(speed)
    };
    let mut unit = None;
    e.each(&mut |part| unit = unit.take().or_else(|| speed(turned(part)?.1)));
    let unit: Expression = unit?;
    let ratio = |angle: &Expression| normal(&speed(angle)?.div(unit.clone())).number().cloned();
    let mut circles = integer(1);
    e.each(&mut |part| {
        if let Some(ratio) = turned(part).and_then(|(_, angle)| ratio(angle)) {
            // The least common multiple: a fraction is in lowest terms.
            let own = BigRational::from(ratio.denom().clone());
            let missing = (&circles / &own).numer().clone();
            circles = own * missing;
        }
    });
    let start = |angle: &Expression| {
        angle.substitute(&|part| (part.variable() == Some(time)).then(|| Expression::integer(0)))
    };
    // Another variable than time, which shows whether all of that is gone.
    let turned_by = if time == Variable::Time { Variable::Elapsed } else { Variable::Time };
    let of_angle = e.substitute(&|part| {
        let (function, angle) = turned(part)?;
        let turned = Expression::from(ratio(angle)?).mul(turned_by.into());
        Some(Expression::call(function, start(angle).add(turned)))
    });
    let circles = circles.to_f64()?;
    (!of_angle.contains(time)).then_some(Periodic { of_angle, angle: turned_by, circles })
}

/// The function and the angle, of one that repeats.
fn turned(e: &Expression) -> Option<(Function, &Expression)> {
    match e.node() {
        Node::Call(function @ (Function::Sin | Function::Cos | Function::Tan), angle) => {
            Some((*function, angle))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::periodic;
    use crate::expression::testing::{evaluate, kappa};

    #[test]
    fn rationally_related_frequencies_are_periodic() {
        for (text, circles) in [
            ("3/2 + 2*sin(dt/2)*cos(dt/2)", 1.0),
            ("sin(dt) + cos(dt/3)", 3.0),
            ("exp(sin(m*dt + a))*cos(2*m*dt/5 - a)", 5.0),
            ("tan(sin(dt))", 1.0),
        ] {
            let e = kappa(text);
            let found = periodic(&e).expect(text);
            assert_eq!(found.circles, circles, "{text}");
            // The first angle has the speed 1, or m = 1/2.
            let is_slow = text.contains("m*dt") || text.contains("dt/2");
            let speed = if is_slow { 0.5 } else { 1.0 };
            for at in [0.0, 0.3, 7.0, -2.0] {
                let [of_time, of_angle] = [evaluate(&e, at), evaluate(&found.of_angle, speed * at)];
                assert!((of_time - of_angle).abs() < 1e-12, "{text} {at}: {of_time} {of_angle}");
                let circle = found.circles * 2.0 * std::f64::consts::PI;
                let later = evaluate(&found.of_angle, speed * at + circle);
                assert!((later - of_angle).abs() < 1e-11, "{text} {at}: {later} {of_angle}");
            }
        }
        for text in [
            "sin(dt) + dt",
            "sin(dt^2)",
            "sin(dt)*sin(pi*dt)",
            "exp(dt)",
            "sin(m*dt) + sin(a*dt)",
            "a",
        ] {
            assert!(periodic(&kappa(text)).is_none(), "{text}");
        }
    }
}
