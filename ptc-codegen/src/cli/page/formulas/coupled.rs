//! The formulas of plants with several inputs, and of several axes.

use crate::expression::Expression;
use crate::model::{Coupled, Inverse};
use crate::parameter::Name;
use crate::plant::{Mechanics, Plant};
use crate::request::{Feedback, Spec};

use super::closed::{mapping, matrix, r};
use super::group::Group;
use super::law::law;
use super::plant::definitions;
use crate::cli::mathml::{
    Math, dot, equal, fraction, name, number, of_expression, operator, product, relation, row, sub,
};
use crate::cli::report::Failure;

/// Returns the groups of a plant with several inputs: the plant, the mapping, and the law of each output.
pub(super) fn groups(
    (spec, coupled): (&Spec, &Coupled),
    plant: &Plant,
) -> Result<Vec<Group>, Failure> {
    let designs = spec.designs();
    let highest = designs.iter().max_by_key(|design| design.n).unwrap_or(spec);
    let mut groups = vec![group((spec, coupled), plant), mapping(spec), r(highest)?];
    groups.push(matrix(highest)?);
    let law_of = |design: &Spec| {
        (design.n, design.fixed.clone(), design.drift.clone(), design.feedback.clone())
    };
    let alike = designs.windows(2).all(|pair| law_of(&pair[0]) == law_of(&pair[1]));
    for (i, design) in (1..).zip(&designs).take(if alike { 1 } else { designs.len() }) {
        let feedback = match &design.feedback {
            Feedback::Expression(law) => Feedback::Expression(coupled.law_named(law)),
            other => other.clone(),
        };
        let mut own = law(&Spec { feedback, ..design.clone() })?;
        let (one, told) = match spec.joins_axes() {
            true => ("axis", "x and u are its own"),
            false => ("output", "x is the output with its derivatives, and u stands for w"),
        };
        let of = if alike { format!("Each {one}") } else { format!("Of {one} {i}") };
        own.told = format!("{of}: {told}. {}", own.told);
        groups.push(own);
    }
    Ok(groups)
}

/// M w + b.
fn mechanical() -> Math {
    relation(product(name("M"), name("w")), "+", name("b"))
}

/// The plant with several inputs, and how these follow from what the laws want.
pub(super) fn group((spec, coupled): (&Spec, &Coupled), plant: &Plant) -> Group {
    let of = |e: &Expression| of_expression(&coupled.named(e));
    let named_rows = |symbol: &str, rows: &[Vec<Expression>]| -> Vec<Math> {
        let entry = |i: usize, j: usize, e: &Expression| {
            equal(sub(name(symbol), row([number(i), operator(","), number(j)])), of(e))
        };
        let of_row = |(i, row): (usize, &Vec<Expression>)| {
            (1..).zip(row).map(|(j, e)| entry(i, j, e)).collect::<Vec<_>>()
        };
        (1..).zip(rows).flat_map(of_row).collect()
    };
    let each = |symbol: &str, all: &[Expression]| -> Vec<Math> {
        (1..).zip(all).map(|(i, e)| equal(sub(name(symbol), number(i)), of(e))).collect()
    };
    let rates = coupled.states.iter().zip(&plant.dynamics);
    let mut formulas = definitions(coupled.definitions());
    formulas.extend(rates.map(|(state, rate)| equal(dot(name(state.text())), of(rate))));
    let own =
        Plant { fixed: plant.fixed.clone(), bounds: plant.bounds.clone(), ..Plant::own(spec) };
    if spec.joins_axes() {
        let mut told = "The axes, each with its own states and input.".to_owned();
        if *plant != own {
            told.push_str(" The controller takes each for a chain of integrators.");
        }
        return Group { title: "Plant", told, formulas };
    }
    let outputs = coupled.outputs.iter().map(|output| output.coordinates[0].clone());
    let law = match &coupled.inverse {
        Inverse::Adjugate { determinant, adjugate, .. } => {
            formulas.extend(each("y", &outputs.collect::<Vec<_>>()));
            formulas.push(equal(name("d"), of(determinant)));
            formulas.extend(named_rows("A", adjugate));
            equal(name("u"), product(fraction(name("A"), name("d")), name("w")))
        }
        Inverse::Elimination { matrix, .. } => {
            formulas.extend(each("y", &outputs.collect::<Vec<_>>()));
            formulas.extend(named_rows("D", matrix));
            equal(product(name("D"), name("u")), name("w"))
        }
        Inverse::Inertia { inertia, bias } => {
            let own = plant.mechanics.as_ref().and_then(Mechanics::equations);
            let (true_inertia, true_bias) =
                own.map_or((inertia, bias), |own| (&own.inertia, &own.bias));
            formulas.extend(named_rows("M", true_inertia));
            formulas.extend(each("b", true_bias));
            equal(name("u"), mechanical())
        }
        Inverse::Robot(_) => equal(name("u"), mechanical()),
    };
    formulas.push(law);
    let mut told = match &coupled.inverse {
        Inverse::Adjugate { .. } => {
            "The plant with its outputs y, and the inputs that follow from w, what the laws want of the last derivatives: A is the adjugate of the decoupling matrix and d its determinant.".to_owned()
        }
        Inverse::Elimination { .. } => {
            "The plant with its outputs y, and the inputs of which the decoupling matrix D makes w, what the laws want of the last derivatives.".to_owned()
        }
        Inverse::Inertia { .. } => {
            let q = Name::listed(&coupled.states[..coupled.inputs.len()]);
            format!("The plant M q'' + b = u with q = ({q}), and the inputs that follow from w, what the laws want of q''.")
        }
        Inverse::Robot(arm) => {
            let lines = arm.lines().join("; ");
            format!("The plant M q'' + b = u of rigid bodies, and the torques that follow from w, what the laws want of q'', by the recursive Newton-Euler algorithm, without M or b: {lines}.")
        }
    };
    if spec.sampled_exactly().is_some() {
        told.push_str(" The controller moves the chains of the outputs as they are sampled, which are the outputs with their derivatives up to O(h): the head of the emitted files has their numbers.");
    }
    if *plant != own {
        told.push_str(
            " The controller takes other equations than the plant has, those of the model.",
        );
    }
    Group { title: "Plant", told, formulas }
}
