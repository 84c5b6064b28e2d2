//! The plant of one chain.

use crate::expression::Expression;
use crate::model::Model;
use crate::parameter::Name;
use crate::plant::Plant;
use crate::request::Spec;

use super::group::{Group, n};
use crate::cli::mathml::{
    Math, dot, equal, name, number, of_expression, operator, product, relation, row, sub, words,
};

/// The plant with a model, and the chain that the law takes its output to be.
pub(super) fn of_model((spec, model): (&Spec, &Model), plant: &Plant) -> Group {
    let of = |e: &Expression| of_expression(&model.named(e));
    let rates = |rates: &[Expression], at: &dyn Fn(Math) -> Math| {
        let all = model.states.iter().zip(rates);
        let all = all.map(|(state, rate)| equal(at(dot(name(state.text()))), of(rate)));
        all.collect::<Vec<_>>()
    };
    let mut formulas = definitions(model.definitions());
    formulas.extend(rates(&plant.dynamics, &|rate| rate));
    let mut told = "The plant, and the chain of its output that the law brings to rest.".to_owned();
    if plant.dynamics != model.dynamics {
        formulas.extend(rates(&model.dynamics, &|rate| sub(rate, words("model"))));
        told.push_str(" The controller takes other rates than the plant has, those of the model.");
    }
    let coordinates = (1..).zip(&model.coordinates);
    formulas.extend(coordinates.map(|(j, e)| equal(sub(name("x"), number(j)), of(e))));
    let known = [("f", &spec.drift), ("g", &spec.input_gain)];
    formulas.extend(known.into_iter().filter_map(|(f, e)| Some(equal(name(f), of(e.as_ref()?)))));
    told.push_str(&format!(" The u of the law is {}.", model.input));
    Group { title: "Plant", told, formulas }
}

/// The intermediate values of a model.
pub(super) fn definitions(values: Vec<(Name, Expression)>) -> Vec<Math> {
    let values = values.iter();
    values.map(|(own, value)| equal(name(own.text()), of_expression(value))).collect()
}

pub(super) fn of_chain(spec: &Spec, plant: &Plant) -> Group {
    let rate = |index: Math| sub(dot(name("x")), index);
    let state = |j: usize| sub(name("x"), number(j));
    let mut formulas = Vec::new();
    let index = name("j");
    match spec.n {
        1 => {}
        2 => formulas.push(equal(rate(number(1)), state(2))),
        n => formulas.push(row([
            rate(index.clone()),
            operator("="),
            sub(name("x"), relation(index.clone(), "+", number(1))),
            operator(","),
            words("  "),
            index,
            operator("="),
            row([number(1), operator(","), name("\u{2026}"), operator(","), number(n - 1)]),
        ])),
    }
    let control = name("u");
    let last = relation(name("f"), "+", product(name("g"), control));
    formulas.push(equal(rate(n(spec)), last));
    formulas.push(equal(name("f"), of_expression(&plant.f)));
    let own = spec.input_gain.clone().unwrap_or(Expression::integer(1));
    let g = plant.g.as_ref().unwrap_or(&own);
    formulas.push(equal(name("g"), of_expression(g)));
    let told = match &plant.g {
        Some(g) if *g != own => {
            formulas.push(equal(sub(name("g"), words("law")), of_expression(&own)));
            "The controller takes another g than the plant has, the last one.".to_owned()
        }
        _ => "A chain of integrators, moved by f and by u.".to_owned(),
    };
    Group { title: "Plant", told, formulas }
}
