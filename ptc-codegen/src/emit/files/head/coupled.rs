//! Description of a plant with several inputs in the head of an emitted file.

use std::fmt::Display;

use num_traits::{Signed, ToPrimitive, Zero};

use crate::algebra::BigRational;
use crate::diagnostic::digits;
use crate::expression::Expression;
use crate::model::Coupled;
use crate::model::coupled::Inverse;
use crate::request::{Exact, Reference, Spec};

/// Describes the references of the outputs, and the tracking errors that the laws see.
pub(super) fn references(spec: &Spec) -> Vec<String> {
    if spec.reference == Some(Reference::Input) {
        return vec![
            "  e_i = x_i - r^(i-1) of each output, where row j of r holds r^(0)..r^(n) of output j, n its order".to_owned(),
        ];
    }
    let each = known_references(spec, "output");
    if each.is_empty() {
        return each;
    }
    [vec!["  e_i = x_i - r^(i-1) with the reference r of the output:".to_owned()], each].concat()
}

/// Describes the reference of each output, or axis, with its derivatives.
pub(super) fn known_references(spec: &Spec, each: &str) -> Vec<String> {
    let of_each = |(index, derivatives): (usize, &[Expression])| {
        let rates = (1..).zip(&derivatives[1..]).map(|(i, r)| format!(", r^({i}) = {r}"));
        format!("  of {each} {index}: r = {}{}", derivatives[0], rates.collect::<String>())
    };
    (1..).zip(spec.known_references()).map(of_each).collect()
}

/// The chains of a linear plant as they are sampled, and how u follows from what is wanted of them, in numbers of
/// four digits.
pub(super) fn sampled(exact: &Exact) -> Vec<String> {
    let (plant, chains) = (&exact.plant, &exact.chains);
    let sum = |row: &[BigRational]| sum(row, &exact.coupled.states);
    let mut rows = chains.coordinates.iter();
    let mut lines = Vec::new();
    for (index, order) in (1..).zip(&plant.orders) {
        lines.push(format!("Output {index}, of order n = {order}, to four digits:"));
        let own = (1..).zip(rows.by_ref().take(*order));
        lines.extend(own.map(|(j, row)| format!("  xi_{j} = {}", sum(row))));
        lines.push(format!("  f_{index} = {}", sum(&chains.drift[index - 1])));
    }
    lines.push("u = G^-1 w with w_i = v_i - f_i, to four digits:".to_owned());
    let row = |row: &Vec<BigRational>| {
        let all: Vec<_> = row.iter().map(number).collect();
        format!("[{}]", all.join(", "))
    };
    let rows: Vec<_> = chains.inverse.iter().map(row).collect();
    lines.push(format!("  G^-1 = [{}]", rows.join(", ")));
    lines
}

/// A sum of multiples, to four digits.
pub(super) fn sum(row: &[BigRational], states: &[impl Display]) -> String {
    let terms = row.iter().zip(states).filter(|(factor, _)| !factor.is_zero());
    let text = terms.fold(String::new(), |text, (factor, state)| {
        let sign = match (text.is_empty(), factor.is_negative()) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        match number(&factor.abs()).as_str() {
            "1" => format!("{text}{sign}{state}"),
            factor => format!("{text}{sign}{factor}*{state}"),
        }
    });
    if text.is_empty() { "0".to_owned() } else { text }
}

fn number(value: &BigRational) -> String {
    digits(value.to_f64().unwrap_or(f64::NAN))
}

/// Describes how u is computed from the wanted rates of the outputs.
pub fn law(coupled: &Coupled) -> Vec<String> {
    let zero = Expression::integer(0);
    let mut lines = Vec::new();
    for (index, output) in (1..).zip(&coupled.outputs) {
        lines.push(format!("Output {index}, of order n = {}:", output.coordinates.len()));
        let x = (1..).zip(&output.coordinates);
        lines.extend(x.map(|(j, e)| format!("  x_{j} = {}", coupled.text(e))));
        if output.drift != zero {
            lines.push(format!("  f_{index} = {}", coupled.text(&output.drift)));
        }
    }
    match &coupled.inverse {
        Inverse::Adjugate { determinant, adjugate, .. } => {
            lines.push("u = adj(D) w/det(D) with w_i = v_i - f_i:".to_owned());
            lines.push(format!("  det(D) = {}", coupled.text(determinant)));
            lines.push(format!("  adj(D) = {}", coupled.matrix(adjugate)));
        }
        Inverse::Elimination { matrix, .. } => {
            lines.push("u of D u = w with w_i = v_i - f_i, by elimination with pivots:".to_owned());
            lines.push(format!("  D = {}", coupled.matrix(matrix)));
        }
        Inverse::Inertia { .. } => {
            lines.push("u = M v + bias".to_owned());
        }
        Inverse::Robot(arm) => {
            lines.push("u by the recursive Newton-Euler algorithm: the torques with which the joints have the accelerations v.".to_owned());
            lines.push(arm.robot.left_out());
        }
    }
    lines
}
