//! `egg`: what equality saturation finds beyond the passes, for small kernels.
//!
//! The operations of `step` that time or the state decide go into an e-graph; what is known earlier
//! are its leaves, and what can be computed from leaves alone costs nothing, because it belongs in
//! `init`. The rewrites are those of the real numbers, so a result need not keep the bits.

use std::time::{Duration, Instant};

use egg::{Id, RecExpr, Runner};
use ptc_codegen::family::Family;
use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::program::cost::{X86_64, count};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, Op, Program, Stage, Value, passes};
use ptc_codegen::request::Guard;
use serde::{Deserialize, Serialize};

use crate::case::{Case, VARIANTS};
use crate::extract::extract;
use crate::failure::{Failure, Result};
use crate::rewrites::{Early, Node, rules};

/// Limits at which an e-graph stops growing.
const NODES: usize = 100_000;
const ITERATIONS: usize = 30;
const SECONDS: u64 = 20;

/// Results for one kernel.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Found {
    pub(crate) family: String,
    pub(crate) n: usize,
    /// Cycles of the model, as the passes leave the kernel.
    pub(crate) before: usize,
    /// With the time-to-go as the program computes it.
    pub(crate) kept: Outcome,
    /// With the time-to-go rewritten too.
    pub(crate) free: Outcome,
}

/// Outcome of one e-graph.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Outcome {
    /// Cycles of the best expression found.
    pub(crate) after: usize,
    pub(crate) nodes: usize,
    pub(crate) classes: usize,
    pub(crate) seconds: f64,
    pub(crate) stopped: String,
    /// Worst relative difference from the program at a few points down to T/tau = 1e-9.
    pub(crate) difference: f64,
}

/// Saturates each kernel.
pub(crate) fn measure() -> Result<Vec<Found>> {
    let mut found = Vec::new();
    for family in [Family::Exp, Family::Rational, Family::Tanh] {
        let variant = VARIANTS.into_iter().find(|variant| variant.family == family);
        let variant = variant.ok_or_else(|| Failure::new("a family is not measured"))?;
        for n in 2..=4 {
            let spec = Case::new(variant, n, Precision::F64, Guard::None).spec;
            let law = Law::of(&spec);
            let program = passes::optimise(lower(&spec, &law), &mut |_, _| {});
            found.push(Found {
                family: family.name().to_owned(),
                n,
                before: count(&program, &[program.step], Stage::Tick).cycles(&X86_64),
                kept: saturate(&program, true)?,
                free: saturate(&program, false)?,
            });
        }
    }
    Ok(found)
}

fn saturate(program: &Program, keep_time: bool) -> Result<Outcome> {
    let start = Instant::now();
    let expression = expression(program, keep_time)?;
    let runner = Runner::<Node, Early>::new(Early)
        .with_expr(&expression)
        .with_node_limit(NODES)
        .with_iter_limit(ITERATIONS)
        .with_time_limit(Duration::from_secs(SECONDS))
        .run(&rules());
    let best = extract(&runner.egraph, &expression);
    let (after, best) = best.ok_or_else(|| Failure::new("nothing to extract"))?;
    let time = count(program, &[program.limits.late], Stage::Tick).cycles(&X86_64);
    let stopped = match runner.stop_reason {
        Some(egg::StopReason::Saturated) => "saturated",
        Some(egg::StopReason::NodeLimit(_)) => "nodes",
        Some(egg::StopReason::TimeLimit(_)) => "time",
        _ => "rounds",
    };
    Ok(Outcome {
        after: after + if keep_time { time } else { 0 },
        nodes: runner.egraph.total_number_of_nodes(),
        classes: runner.egraph.number_of_classes(),
        seconds: start.elapsed().as_secs_f64(),
        stopped: stopped.to_owned(),
        difference: difference(program, &best),
    })
}

/// The operations of `step` from the time on, or from the time-to-go on.
fn expression(program: &Program, keep_time: bool) -> Result<RecExpr<Node>> {
    let mut nodes = RecExpr::default();
    let mut ids = vec![Id::from(0); program.values.len()];
    let late = program.limits.late;
    let hidden = if keep_time { program.needed(&[late]) } else { Vec::new() };
    for value in program.needed(&[program.step]) {
        let definition = program.get(value);
        if definition.stage >= Stage::Tick && value != late && hidden.contains(&value) {
            continue;
        }
        let id = |v: &Value| ids[v.0];
        let node = match &definition.op {
            Op::Number(one) if *one == ptc_codegen::algebra::integer(1) => Node::One(1),
            Op::Number(one) if *one == ptc_codegen::algebra::integer(-1) => Node::One(-1),
            _ if definition.stage < Stage::Tick => Node::Leaf(format!("v{}", value.0).into()),
            Op::Input(_) => Node::Leaf(format!("late{}", value.0).into()),
            _ if keep_time && value == late => Node::Leaf(format!("late{}", value.0).into()),
            Op::Add(a, b) => Node::Add([id(a), id(b)]),
            Op::Sub(a, b) => Node::Sub([id(a), id(b)]),
            Op::Mul(a, b) => Node::Mul([id(a), id(b)]),
            Op::Div(a, b) => Node::Div([id(a), id(b)]),
            Op::Neg(a) => Node::Neg(id(a)),
            Op::Min(a, b) => Node::Min([id(a), id(b)]),
            op => return Err(Failure::new(format!("no rewrites for {op:?}"))),
        };
        ids[value.0] = nodes.add(node);
    }
    Ok(nodes)
}

/// Compares the program with what was extracted from it.
fn difference(program: &Program, best: &RecExpr<Node>) -> f64 {
    let mut worst = 0.0_f64;
    for point in 0_u8..10 {
        let input = |input| match input {
            Input::Parameter(Parameter::Tau) => 0.7,
            Input::Parameter(Parameter::Eps) => 1e-11,
            Input::Parameter(Parameter::Gain(i)) => 1.5 + i as f64,
            Input::Parameter(_) => 1.25,
            Input::StartTime => 1000.1,
            Input::Reference(_)
            | Input::ReferenceOf(..)
            | Input::Divisor
            | Input::Drift
            | Input::Control
            | Input::Wanted(_) => 0.0,
            Input::Time => 1000.8 - 0.7 * 10.0_f64.powi(-i32::from(point)),
            Input::State(j) | Input::StateAtStart(j) | Input::Gain(j) => 0.7 + 0.3 * j as f64,
        };
        let mut interpreter = Interpreter::new(program, &input);
        let mut known: Vec<f64> = Vec::new();
        for node in best.as_ref() {
            let at = |id: &Id| known[usize::from(*id)];
            known.push(match node {
                Node::Add([a, b]) => at(a) + at(b),
                Node::Sub([a, b]) => at(a) - at(b),
                Node::Mul([a, b]) => at(a) * at(b),
                Node::Div([a, b]) => at(a) / at(b),
                Node::Neg(a) => -at(a),
                Node::Min([a, b]) => at(a).min(at(b)),
                Node::One(one) => f64::from(*one),
                Node::Leaf(name) => {
                    let index = name.as_str().trim_start_matches(char::is_alphabetic).parse();
                    index.map_or(f64::NAN, |index| interpreter.value(Value(index)))
                }
            });
        }
        let u = interpreter.value(program.step);
        worst = worst.max(known.last().map_or(f64::INFINITY, |other| ((other - u) / u).abs()));
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_common_factor_is_found_and_parameters_cost_nothing() {
        let written = "(+ (* (+ v1 v2) late1) (* late2 late1))";
        let expression: RecExpr<Node> = written.parse().expect("it is an expression");
        let runner = Runner::<Node, Early>::new(Early).with_expr(&expression).run(&rules());
        let (cycles, best) = extract(&runner.egraph, &expression).expect("there is one");
        // One addition and one multiplication; v1 + v2 is known before the time is.
        assert_eq!(cycles, 8, "{best}");
    }
}
