//! What the head of an emitted file says of a plant with several inputs.

use crate::expression::Expression;
use crate::model::Coupled;
use crate::model::coupled::Inverse;

/// How u follows from what is wanted of the outputs.
pub(super) fn law(coupled: &Coupled) -> Vec<String> {
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
        Inverse::Inertia { .. } => {
            lines.push("u = M v + bias".to_owned());
        }
    }
    lines
}
