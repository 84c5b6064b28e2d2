//! Expressions that are periodic in time, and what holds of them at every angle.

use num_traits::ToPrimitive;

use super::enclosure::Range;
use super::evaluator::{Evaluator, Names};
use super::existence::Condition;
use super::normal::normal;
use super::{Expression, Function, Node, Variable};
use crate::algebra::{BigRational, integer};

/// Angle to which a period is examined: a circle, and a little more than doubles lose of it.
const CIRCLE: f64 = std::f64::consts::TAU * (1.0 + 1e-9);

/// Pieces of a period that are not halved any more.
const LEAST: f64 = 1e-3;

/// Periodic expression, as a function of an angle.
struct Periodic {
    of_angle: Expression,
    /// Variable that represents the angle.
    angle: Variable,
    /// Circles in a period.
    circles: f64,
}

/// Returns true if a periodic expression is shown to meet a condition at every angle, by pieces of a period.
pub(crate) fn is_met_all_round(part: &Expression, condition: Condition, names: &Names) -> bool {
    let Some(Periodic { of_angle, angle, circles }) = periodic(part) else { return false };
    let (mut names, mut evaluator) = (names.clone(), Evaluator::new());
    let mut open = vec![(0.0, CIRCLE * circles)];
    while let Some((low, high)) = open.pop() {
        names.insert(angle.into(), Range::new(low, high).into());
        let value = evaluator.value(&of_angle, &names);
        if value.is_some_and(|value| condition.is_met(&value.interval)) {
            continue;
        }
        let middle = 0.5 * (low + high);
        if high - low < LEAST || evaluator.is_spent() {
            return false;
        }
        open.extend([(low, middle), (middle, high)]);
    }
    true
}

/// Returns an expression as a function of one angle, in units of which all its angles have whole or rational speeds;
/// `None` if time does anything else in it.
///
/// `2*sin(w*t/2)*cos(w*t/2)` becomes `2*sin(dt)*cos(dt)`, dt the angle, and repeats after a circle.
fn periodic(e: &Expression) -> Option<Periodic> {
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
    // Another variable than time, so that time is seen wherever it is left.
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
