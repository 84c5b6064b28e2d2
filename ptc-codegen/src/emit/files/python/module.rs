//! The module around the classes.

use super::super::text::{Text, capital};
use super::{Python, annotation};
use crate::code::{Expr, Owner, Shape, Variable};
use crate::parameter::type_name;

impl Python<'_> {
    pub(super) fn module(mut self) -> String {
        let code = self.code;
        let kind = type_name(&code.name);
        self.out.line("\"\"\"");
        for line in &code.head {
            self.out.line(line.replace('\\', "\\\\"));
        }
        self.out.line("\"\"\"\n\nfrom __future__ import annotations\n");
        let stateless = code.is_stateless();
        let controls = code.function("update").is_none() && !stateless;
        let lists = !code.subroutines().is_empty();
        let arrays = code.parameters.iter().any(|p| p.shape.length().is_some());
        let calls = code.functions.iter().any(|function| !function.callbacks.is_empty());
        let imported = [(calls, "Callable"), (arrays || lists, "Sequence")];
        let imported: Vec<_> =
            imported.iter().filter(|(used, _)| *used).map(|(_, name)| *name).collect();
        if !imported.is_empty() {
            self.out.line(format!("from collections.abc import {}", imported.join(", ")));
        }
        self.out.line("from dataclasses import dataclass\nfrom enum import IntEnum");
        self.out.line(if controls || stateless { "from typing import NamedTuple\n" } else { "" });
        self.out.line("import numpy as np\nfrom numpy.typing import ArrayLike, NDArray\n");
        let rate = code.function("rate").is_some();
        let mut public = vec!["Params", "Status", &kind];
        public.extend(controls.then_some("Control"));
        public.extend((!code.gains.is_empty()).then_some("Gains"));
        public.extend(stateless.then_some("Value"));
        public.extend(rate.then_some(["Rate", "Value"]).into_iter().flatten());
        public.extend(code.axes().map(|_| "Axes"));
        public.sort_unstable();
        self.out.line(format!("__all__ = [\"{}\"]\n", public.join("\", \"")));
        let real = self.real_type();
        self.out.line(format!("_R = np.{real}"));
        let mut counts = false;
        code.visit(&mut |value| counts |= matches!(value, Expr::CountSub(..)));
        if counts {
            self.out.line("_WRAP = 0xFFFFFFFF");
        }
        self.out.line(format!("Array = NDArray[np.{real}]\n"));
        self.out.line(format!("\n{}", include_str!("../../../../templates/status.py.txt")));
        if controls {
            let control = if code.start.is_some() { CONTROLS } else { CONTROL };
            self.out.line(control.replace("REAL", real));
        }
        if code.axes().is_some() {
            self.out.line(format!("\n{}", include_str!("../../../../templates/axes.py.txt")));
        }
        if rate {
            self.out.line(RATE);
        }
        if rate || stateless {
            let of_system = "What leads from the infinite-time system to the plant or back";
            let value = match stateless {
                true => VALUE
                    .replace(of_system, "What a function gives")
                    .replace("A time, or a state along", "The result along"),
                false => VALUE.to_owned(),
            };
            self.out.line(value);
        }
        self.out.line("\n@dataclass(frozen=True, kw_only=True)");
        self.out.open("class Params:");
        self.out.line("\"\"\"Run-time parameters.\"\"\"\n");
        for parameter in &code.parameters {
            let (name, kind) = (&parameter.name, annotation(parameter.shape));
            let default = default(parameter);
            self.out.line(format!("{name}: {kind}{default}\n\"\"\"{}\"\"\"", parameter.about));
        }
        self.out.leave();
        self.out.line("\n");
        self.helpers();
        if !code.gains.is_empty() {
            self.gains_class();
        }
        self.class(&kind);
        self.out.text()
    }

    fn helpers(&mut self) {
        let code = self.code;
        let arrays = |shape: Shape| shape.length().is_some();
        let given = code.parameters.iter().any(|p| arrays(p.shape));
        let latched = code.start.as_ref().is_some_and(|start| start.state.is_some());
        let stateless = code.is_stateless();
        if given || latched || (code.start.is_none() && !stateless) {
            self.out.line(format!("{NUMBERS}\n"));
        }
        if code.start.is_some() || stateless {
            let given = |of_states: bool| {
                let all = code.functions.iter().flat_map(|function| &function.arguments);
                let own = all.filter(|argument| (argument.name != "r") == of_states);
                let lengths = own.filter_map(|argument| match argument.shape {
                    Shape::Reals(length) => Some(length),
                    _ => None,
                });
                lengths.max()
            };
            let states = STATES.replace("LENGTH", &given(true).unwrap_or(1).to_string());
            self.out.line(format!("{states}\n"));
            if let Some(count) = given(false) {
                let reference = STATES.replace("LENGTH", &count.to_string());
                let reference = reference.replace("_states", "_reference");
                let reference =
                    reference.replace("The states", "The reference and its derivatives");
                self.out.line(format!("{}\n", reference.replace("the states", "r, r', ...")));
            }
        }
        let arguments = code.functions.iter().flat_map(|function| &function.arguments);
        if arguments.into_iter().any(|argument| matches!(argument.shape, Shape::Lists(..))) {
            self.out.line(include_str!("../../../../templates/of_axes.py.txt"));
            self.out.line("");
        }
        code.subroutines().into_iter().for_each(|of| self.subroutine(of));
        let constants = code.constants();
        for own in &constants {
            let (name, value) = (self.constant(own), self.literal_of(own));
            self.out.line(format!("# {}.", capital(&own.described())));
            let value = if own.count().is_some() { value } else { format!("_R({value})") };
            self.out.line(format!("{name} = {value}"));
        }
        if !constants.is_empty() {
            self.out.line("\n");
        }
        for table in &code.tables {
            let name = self.table(&table.name);
            self.out.line(format!("# {}.", capital(&table.about)));
            self.out.line(format!("{name} = np.array("));
            self.out.line("    [");
            for row in self.rows(table) {
                self.out.line(format!("        [{}],", row.join(", ")));
            }
            self.out.line("    ],\n    dtype=_R,\n)\n\n");
        }
    }

    fn gains_class(&mut self) {
        let code = self.code;
        self.out.open("class Gains:");
        self.out.line("\"\"\"Feedback gains at one or more times.\"\"\"\n");
        let list = code.gains.iter().map(|field| format!("{}: Array", field.name));
        let list = list.collect::<Vec<_>>().join(", ");
        self.out.open(format!("def __init__(self, {list}, status: NDArray[np.int8]) -> None:"));
        for field in &code.gains {
            let (name, about) = (&field.name, &field.about);
            let shape = match field.shape.length() {
                Some(n) => format!("; shape (..., {n})"),
                None => String::new(),
            };
            self.out.line(format!("self.{name} = {name}\n\"\"\"{about}{shape}\"\"\""));
        }
        self.out.line(
            "self.status = status\n\"\"\"OK or HOLD, INPUT where the time was not legal.\"\"\"",
        );
        self.out.leave();
        self.owner = "self.";
        for function in code.functions.iter().filter(|f| f.owner == Owner::Gains) {
            self.batch_function(function);
        }
        self.owner = "self._";
        self.out.leave();
        self.out.line("\n");
    }
}

/// Default arguments of `simulate`: a start at 0, and u without a bound.
fn default(parameter: &Variable) -> &'static str {
    match (parameter.name.as_str(), parameter.shape.length()) {
        ("t0", None) => " = 0.0",
        ("u_max", None) => " = np.inf",
        ("u_min", None) => " = -np.inf",
        _ => "",
    }
}

const CONTROL: &str = "
class Control(NamedTuple):
    \"\"\"Result of a step.\"\"\"

    u: np.REAL
    \"\"\"Input of the plant.\"\"\"
    status: Status
    \"\"\"Its Status.\"\"\"
";

const CONTROLS: &str = "
class Control(NamedTuple):
    \"\"\"Result of a step, for each time and state of the batch.\"\"\"

    u: Array
    \"\"\"Input of the plant.\"\"\"
    status: NDArray[np.int8]
    \"\"\"Its Status.\"\"\"
";

const RATE: &str = "
class Rate(NamedTuple):
    \"\"\"What the infinite-time system gives, for each time and state of the batch.\"\"\"

    xi_dot: Array
    \"\"\"Derivatives of the state along the last axis; 0 on a negative status.\"\"\"
    status: NDArray[np.int8]
    \"\"\"Its Status.\"\"\"
";

const VALUE: &str = "
class Value(NamedTuple):
    \"\"\"What leads from the infinite-time system to the plant or back, for each time and state of the batch.\"\"\"

    value: Array
    \"\"\"A time, or a state along the last axis; 0 on a negative status.\"\"\"
    status: NDArray[np.int8]
    \"\"\"Its Status.\"\"\"
";

const NUMBERS: &str = "\
def _numbers(given: ArrayLike, length: int, name: str) -> Array:
    \"\"\"The numbers of a sequence of this length.\"\"\"
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape != (length,):
        raise ValueError(f\"{name} has shape {numbers.shape}; legal: ({length},)\")
    return numbers

";

const STATES: &str = "\
def _states(x: ArrayLike, name: str) -> tuple[Array, ...]:
    \"\"\"The states along the last axis, one by one.\"\"\"
    states = np.asarray(x, dtype=_R)
    if states.ndim == 0 or states.shape[-1] != LENGTH:
        raise ValueError(f\"{name} has shape {states.shape}; legal: (..., LENGTH), the states along the last axis\")
    return tuple(np.moveaxis(states, -1, 0))

";
