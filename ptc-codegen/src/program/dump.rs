//! A program as text, one value a line, for `emit --dump PASS`.

use std::fmt::Write;

use super::{Input, Op, Program, Stage, Value, number};

/// The program's values with their stages and names, then its outputs.
pub fn dump(program: &Program) -> String {
    let mut out = String::new();
    for (index, definition) in program.values.iter().enumerate() {
        let stage = match definition.stage {
            Stage::Generation => "generation",
            Stage::Init => "init",
            Stage::Arm => "arm",
            Stage::Tick => "tick",
            Stage::Step => "step",
        };
        let loops = if definition.looped { " (loop)" } else { "" };
        let name =
            definition.name.as_ref().map(|(name, _)| format!("  ; {name}")).unwrap_or_default();
        let operation = operation(program, &definition.op);
        let _ = writeln!(out, "{:<5} {stage:<10} {operation}{loops}{name}", format!("v{index}"));
    }
    let _ = writeln!(out, "step  = {}", show(program.step));
    let gains: Vec<_> = program.gains.iter().map(|v| show(*v)).collect();
    let _ = writeln!(out, "gains = {}", gains.join(" "));
    if let Some(axis) = program.axis {
        let _ = writeln!(out, "axis  = {}", show(axis));
    }
    out
}

fn show(value: Value) -> String {
    format!("v{}", value.0)
}

fn operation(program: &Program, op: &Op) -> String {
    let operands: Vec<_> = op.operands().into_iter().map(show).collect();
    let word = match op {
        Op::Number(value) => {
            let rounded = number::round(value, program.precision);
            return number::literal(rounded, program.precision);
        }
        Op::Input(input) => return input_text(*input),
        Op::Power(base, exponent) => return format!("power {} {exponent}", show(*base)),
        Op::Element(array, index) => return format!("element {} {index}", show(*array)),
        Op::Neg(_) => "neg",
        Op::Add(..) => "add",
        Op::Sub(..) => "sub",
        Op::Mul(..) => "mul",
        Op::Fused(..) => "fused",
        Op::Div(..) => "div",
        Op::Quotient(..) => "quotient",
        Op::Max(..) => "max",
        Op::Min(..) => "min",
        Op::Call(function, _) => function.name(),
        Op::Law(_) => "law",
        Op::Pow(..) => "pow",
        Op::Rows { .. } => "rows",
        Op::Elimination { .. } => "elimination",
        Op::Unknown => "unknown",
        Op::Root(_) => "root",
    };
    std::iter::once(word.to_owned()).chain(operands).collect::<Vec<_>>().join(" ")
}

fn input_text(input: Input) -> String {
    match input {
        Input::Parameter(parameter) => match parameter.index() {
            Some(index) => format!("parameter {}[{index}]", parameter.key()),
            None => format!("parameter {}", parameter.key()),
        },
        Input::StartTime => "start time t0".to_owned(),
        Input::Time => "time t".to_owned(),
        Input::State(j) => format!("state x{j}"),
        Input::StateAtStart(j) => format!("state x{j} at the start"),
        Input::Reference(order) => format!("reference r{order}"),
        Input::ReferenceOf(output, order) => format!("reference r{order}_{output}"),
        Input::Drift => "drift f".to_owned(),
        Input::Control => "control u".to_owned(),
        Input::Wanted(output) => format!("wanted w_{output}"),
        Input::Gain(j) => format!("gain {j}"),
        Input::Divisor => "input gain g".to_owned(),
    }
}
