//! Chains that are long, and plants in which much occurs often.

use std::collections::BTreeMap;

use num_traits::ToPrimitive;

use super::*;
use crate::expression::{Found, Function, Node};

fn z(j: usize) -> Expression {
    Variable::State(j).into()
}

fn sin(e: Expression) -> Expression {
    Expression::call(Function::Sin, e)
}

fn cos(e: Expression) -> Expression {
    Expression::call(Function::Cos, e)
}

fn sum(terms: impl IntoIterator<Item = Expression>) -> Expression {
    terms.into_iter().reduce(Expression::add).unwrap_or(Expression::integer(0))
}

/// The chain of an output of a plant whose states are a1, a2, ... and whose input is u.
fn chain(output: &Expression, rates: &[Expression]) -> Result<Chain, Ill> {
    let names: Vec<_> =
        (1..=rates.len()).map(|j| Name::new(&format!("a{j}")).expect("a name")).collect();
    let input = Name::new("u").expect("a name");
    Chain::new((&names, input), output, rates, &BTreeMap::new())
}

/// A value at a state, each part computed once.
fn value(e: &Expression, state: &[f64], found: &mut Found<f64>) -> f64 {
    if let Some(known) = found.get(e) {
        return *known;
    }
    let mut of = |e: &Expression| value(e, state, found);
    let own = match e.node() {
        Node::Number(number) => number.to_f64().expect("a float"),
        Node::Variable(Variable::State(j)) => state[j - 1],
        Node::Neg(a) => -of(a),
        Node::Add(a, b) => of(a) + of(b),
        Node::Sub(a, b) => of(a) - of(b),
        Node::Mul(a, b) => of(a) * of(b),
        Node::Div(a, b) => of(a) / of(b),
        Node::Power(a, b) => of(a).powf(of(b)),
        Node::Call(Function::Sin, a) => of(a).sin(),
        Node::Call(Function::Cos, a) => of(a).cos(),
        _ => panic!("{e}"),
    };
    found.insert(e.clone(), own);
    own
}

fn at(e: &Expression, state: &[f64]) -> f64 {
    value(e, state, &mut Found::default())
}

fn near(got: f64, wanted: f64, what: &str) {
    assert!((got - wanted).abs() <= 1e-9 * (1.0 + wanted.abs()), "{what}: {got}, not {wanted}");
}

/// z_j' = z_(j+1) + sin z_j, and u in place of the state after the last.
fn nonlinear(order: usize) -> Vec<Expression> {
    let next = |j| if j < order { z(j + 1) } else { Variable::Control.into() };
    (1..=order).map(|j| Expression::add(next(j), sin(z(j)))).collect()
}

/// The derivatives of z_1 along the nonlinear chain with u = 0, from its Taylor series.
fn derivatives(state: &[f64]) -> Vec<f64> {
    let n = state.len();
    let mut series: Vec<Vec<f64>> = state.iter().map(|z| vec![*z]).collect();
    let mut sines: Vec<[Vec<f64>; 2]> =
        state.iter().map(|z| [vec![z.sin()], vec![z.cos()]]).collect();
    for k in 0..n {
        let slope = |j: usize| sines[j][0][k] + if j + 1 < n { series[j + 1][k] } else { 0.0 };
        let next: Vec<f64> = (0..n).map(|j| slope(j) / (k + 1) as f64).collect();
        for (j, next) in next.into_iter().enumerate() {
            series[j].push(next);
            // s' = c z', c' = -s z'.
            let product = |of: &[f64]| {
                let term = |i: usize| i as f64 * series[j][i] * of[k + 1 - i];
                (1..=k + 1).map(term).sum::<f64>() / (k + 1) as f64
            };
            let (s, c) = (product(&sines[j][1]), -product(&sines[j][0]));
            sines[j][0].push(s);
            sines[j][1].push(c);
        }
    }
    let factorial = |k: usize| (1..=k).map(|k| k as f64).product::<f64>();
    (0..=n).map(|k| factorial(k) * series[0][k]).collect()
}

#[test]
fn derivatives_of_a_nonlinear_chain_of_order_12_are_correct() {
    let order = 12;
    let found = chain(&z(1), &nonlinear(order)).expect("a chain");
    let state: Vec<f64> =
        (0..order).map(|j| 0.3 + 0.17 * j as f64 - 0.02 * (j * j) as f64).collect();
    let wanted = derivatives(&state);
    for (k, coordinate) in found.coordinates.iter().enumerate() {
        near(at(coordinate, &state), wanted[k], &format!("derivative {k}"));
    }
    near(at(&found.drift, &state), wanted[order], "the last one");
    assert_eq!(found.gain, Expression::integer(1));
    assert!(!found.drift.is_written(), "{}", found.drift.size());
    let size = (found.drift.nodes(), found.drift.height());
    assert_eq!(size, (1883, 79));
}

/// Links of the arm, each of 1 m and 1 kg at its end.
const LINKS: usize = 7;

/// An operation on two numbers or expressions.
type Operation<'a, T> = &'a dyn Fn(&T, &T) -> T;

/// Weights and torques of the arm for absolute angles and their rates: M, and c with M a'' = t - c. The
/// links weigh on each that is before them.
fn arm<T: Clone>(
    angles: &[T],
    rates: &[T],
    [sin, cos]: [&dyn Fn(&T) -> T; 2],
    [minus, times, plus]: [Operation<'_, T>; 3],
    number: &dyn Fn(i64) -> T,
) -> (Vec<Vec<T>>, Vec<T>) {
    let beyond = |k: usize| number(i64::try_from(LINKS - k).expect("few"));
    let gap = |i: usize, j: usize| minus(&angles[i], &angles[j]);
    let entry = |i: usize, j: usize| times(&beyond(i.max(j)), &cos(&gap(i, j)));
    let row = |i: usize| (0..LINKS).map(|j| entry(i, j)).collect();
    let turned = |i: usize| {
        let weight = times(&times(&beyond(i), &number(10)), &sin(&angles[i]));
        (0..LINKS).filter(|j| *j != i).fold(weight, |total, j| {
            let square = times(&rates[j], &rates[j]);
            plus(&total, &times(&times(&beyond(i.max(j)), &sin(&gap(i, j))), &square))
        })
    };
    ((0..LINKS).map(row).collect(), (0..LINKS).map(turned).collect())
}

/// The solution of M a = b by elimination.
fn solved<T: Clone>(
    mut m: Vec<Vec<T>>,
    mut b: Vec<T>,
    [minus, times, over]: [Operation<'_, T>; 3],
) -> Vec<T> {
    for k in 0..LINKS {
        for i in k + 1..LINKS {
            let factor = over(&m[i][k], &m[k][k]);
            let above = m[k].clone();
            for (entry, above) in m[i].iter_mut().zip(&above).skip(k + 1) {
                *entry = minus(entry, &times(&factor, above));
            }
            b[i] = minus(&b[i], &times(&factor, &b[k]));
        }
    }
    for i in (0..LINKS).rev() {
        for j in i + 1..LINKS {
            b[i] = minus(&b[i], &times(&m[i][j], &b[j]));
        }
        b[i] = over(&b[i], &m[i][i]);
    }
    b
}

/// The torque of joint `joint` on the links.
fn torque<T>(joint: usize, u: &T, negative: &T, none: &T) -> Vec<T>
where
    T: Clone,
{
    let of = |link: usize| match link {
        _ if link == joint => u,
        _ if link + 1 == joint => negative,
        _ => none,
    };
    (0..LINKS).map(|link| of(link).clone()).collect()
}

/// Converts values of links into those of joints.
fn of_joints<T: Clone>(links: Vec<T>, minus: &dyn Fn(&T, &T) -> T) -> Vec<T> {
    let of = |j: usize| if j == 0 { links[0].clone() } else { minus(&links[j], &links[j - 1]) };
    (0..LINKS).map(of).collect()
}

/// The rates of the joint angles z_1..z_7 and their rates z_8..z_14 with the torque u at one joint.
fn of_arm(joint: usize) -> Vec<Expression> {
    let to = |from: usize| move |i: usize| sum((0..=i).map(|k| z(from + k)));
    let [angles, rates] = [1, LINKS + 1].map(|from| (0..LINKS).map(to(from)).collect::<Vec<_>>());
    let minus = |a: &Expression, b: &Expression| a.clone().sub(b.clone());
    let plus = |a: &Expression, b: &Expression| a.clone().add(b.clone());
    let times = |a: &Expression, b: &Expression| a.clone().mul(b.clone());
    let over = |a: &Expression, b: &Expression| a.clone().div(b.clone());
    let circular: [&dyn Fn(&Expression) -> Expression; 2] =
        [&|e| sin(e.clone()), &|e| cos(e.clone())];
    let (m, c) = arm(&angles, &rates, circular, [&minus, &times, &plus], &Expression::integer);
    let u = Expression::from(Variable::Control);
    let b = torque(joint, &u, &u.clone().neg(), &Expression::integer(0));
    let b = b.iter().zip(&c).map(|(b, c)| minus(b, c)).collect();
    let turned = of_joints(solved(m, b, [&minus, &times, &over]), &minus);
    (1..=LINKS).map(|j| z(LINKS + j)).chain(turned).collect()
}

/// The second derivatives of the joint angles at a state, by numbers.
fn accelerations(state: &[f64], joint: usize, u: f64) -> Vec<f64> {
    let to = |from: usize| move |i: usize| state[from..=from + i].iter().sum::<f64>();
    let [angles, rates] = [0, LINKS].map(|from| (0..LINKS).map(to(from)).collect::<Vec<_>>());
    let minus = |a: &f64, b: &f64| a - b;
    let circular: [&dyn Fn(&f64) -> f64; 2] = [&|e| e.sin(), &|e| e.cos()];
    let (m, c) =
        arm(&angles, &rates, circular, [&minus, &|a, b| a * b, &|a, b| a + b], &|n| n as f64);
    let b = torque(joint, &u, &-u, &0.0);
    let b = b.iter().zip(&c).map(|(b, c)| b - c).collect();
    of_joints(solved(m, b, [&minus, &|a, b| a * b, &|a, b| a / b]), &minus)
}

#[test]
fn derivatives_of_each_joint_of_a_seven_link_arm_are_correct() {
    let state: Vec<f64> =
        (0..2 * LINKS).map(|j| 0.4 - 0.11 * j as f64 + 0.013 * (j * j) as f64).collect();
    for joint in 0..LINKS {
        let rates = of_arm(joint);
        let found = chain(&z(joint + 1), &rates).expect("a chain");
        assert_eq!(found.coordinates, [z(joint + 1), z(LINKS + joint + 1)]);
        let [rest, driven] = [0.0, 1.0].map(|u| accelerations(&state, joint, u)[joint]);
        near(at(&found.drift, &state), rest, "the drift");
        near(at(&found.gain, &state), driven - rest, "the gain");
        // Written out it has up to six million operations.
        assert!(found.drift.nodes() < 700, "{}", found.drift.nodes());
        assert!(found.drift.size() > 200_000, "{}", found.drift.size());
    }
}

#[test]
fn derivatives_of_the_hand_height_are_correct() {
    let to = |i: usize| sum((1..=i).map(z));
    let height = sum((1..=LINKS).map(|i| cos(to(i))));
    let rates = of_arm(0);
    let found = chain(&height, &rates).expect("a chain");
    assert_eq!(found.coordinates.len(), 2);
    let state: Vec<f64> = (0..2 * LINKS).map(|j| 0.2 + 0.07 * j as f64).collect();
    let total = |from: usize, i: usize| state[from..=from + i].iter().sum::<f64>();
    let second = |u: f64| {
        let turned = accelerations(&state, 0, u);
        let term = |i: usize| {
            let (angle, rate) = (total(0, i), total(LINKS, i));
            let bent = turned[..=i].iter().sum::<f64>();
            -angle.cos() * rate * rate - angle.sin() * bent
        };
        (0..LINKS).map(term).sum::<f64>()
    };
    near(at(&found.drift, &state), second(0.0), "the drift");
    near(at(&found.gain, &state), second(1.0) - second(0.0), "the gain");
}
