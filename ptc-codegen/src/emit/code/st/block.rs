//! The function block and the types beside it.

use std::collections::BTreeMap;

use super::super::block::{Block, declared};
use super::super::text::Text;
use super::{Gives, StructuredText, helpers};
use crate::code::{Expr, Finish, Function, Owner, Shape, Statement, Variable};
use crate::internal::fault;

impl StructuredText<'_> {
    pub(super) fn type_of(&self, shape: Shape) -> String {
        match shape {
            Shape::Count => "UDINT".to_owned(),
            Shape::Real => self.real.to_owned(),
            Shape::Reals(length) => format!("ARRAY[1..{length}] OF {}", self.real),
            Shape::Gains | Shape::Lists(..) | Shape::Statuses(_) => {
                fault("a function block gives no gains")
            }
        }
    }

    fn function(&self, name: &str) -> &Function {
        let found = self.code.functions.iter().find(|function| function.name == name);
        found.unwrap_or_else(|| fault(format!("no function {name}")))
    }

    /// Whether it is an observer, whose u is an input.
    pub(super) fn observes(&self) -> bool {
        self.code.function("update").is_some()
    }

    /// What a call does beside `init` and `arm`.
    fn call(&self) -> &Function {
        self.function(if self.observes() { "update" } else { "step" })
    }

    /// The functions that give what the controller keeps: outputs of the function block.
    pub(super) fn outputs(&self) -> impl Iterator<Item = &Function> {
        let kept = |gives| matches!(gives, Gives::Array | Gives::Number);
        let outputs = self.code.functions.iter().filter(move |f| kept(Gives::of(f)));
        outputs.filter(|f| f.owner == Owner::Controller).inspect(|function| {
            if !function.body.is_empty() || !function.arguments.is_empty() {
                fault(format!("{} does more than to give what is kept", function.name));
            }
        })
    }

    pub(super) fn text(mut self) -> String {
        let code = self.code;
        let name = &code.name;
        self.out.line("(*");
        let about = helpers::about(code, self.real);
        for line in code.head.iter().map(String::as_str).chain(["", about.trim_end()]) {
            let line = line.replace("(*", "( *").replace("*)", "* )");
            self.out
                .line(line.split('\n').map(|l| format!("  {l}")).collect::<Vec<_>>().join("\n"));
        }
        self.out.line("*)\n");
        if !code.parameters.is_empty() {
            self.structure("params", code.parameters.iter().map(|p| (p.name.clone(), p)));
        }
        let fields = code.fields.iter().map(|field| (self.local(&field.name), field));
        let fields: Vec<_> = fields.collect();
        self.structure("fields", fields.into_iter());
        self.helpers();
        self.out.line(format!("FUNCTION_BLOCK {name}"));
        self.variables();
        if !self.observes() {
            self.out.line(format!("u := {};", self.literal("0.0")));
        }
        let (arm, step) = (self.function("arm").clone(), self.call().clone());
        self.start(&arm);
        self.out.turn("ELSIF NOT ready THEN");
        self.out.line("status := -2;");
        self.out.turn("ELSE");
        self.owner = "self";
        self.block(&step.body);
        self.give_outputs();
        self.finish(&step.finish);
        self.out.close("END_IF;");
        self.out.line("END_FUNCTION_BLOCK");
        self.out.text()
    }

    /// What `init` and `arm` do: the fields are built apart, so that a call that fails changes
    /// nothing.
    fn start(&mut self, arm: &Function) {
        let code = self.code;
        self.out.open("IF init OR arm THEN");
        self.out.line("status := -1;");
        self.owner = "built";
        self.out.open("IF init THEN");
        self.block(&code.init);
        if let Some(start) = &code.start {
            let (t0, time) = (self.local("t0"), self.alone(&start.time));
            if t0 != time {
                self.out.line(format!("{t0} := {time};"));
            }
        }
        self.out.turn("ELSIF ready THEN");
        self.out.line("built := self;");
        match code.start {
            Some(_) => self.out.line(format!("{} := start_time;", self.local("t0"))),
            None => self.block(&arm.body),
        }
        self.out.turn("ELSE");
        self.out.line("RETURN;");
        self.out.close("END_IF;");
        if code.start.is_some() {
            self.block(&arm.body);
        }
        self.out.line("self := built;");
        self.owner = "self";
        self.give_outputs();
        self.out.line("ready := TRUE;\nstatus := 0;");
    }

    fn structure<'v>(&mut self, kind: &str, members: impl Iterator<Item = (String, &'v Variable)>) {
        self.out.line(format!("TYPE {}_{kind} :", self.code.name));
        self.out.open("STRUCT");
        for (name, member) in members {
            let (kind, about) = (self.type_of(member.shape), &member.about);
            self.out.line(format!("{name} : {kind}; (* {about} *)"));
        }
        self.out.close("END_STRUCT\nEND_TYPE\n");
    }

    fn variables(&mut self) {
        let (code, name) = (self.code, &self.code.name);
        let (arm, step) = (self.function("arm").clone(), self.call().clone());
        let real = self.real;
        self.out.open("VAR_INPUT");
        self.out.line("init : BOOL; (* take the parameters and start *)");
        if !code.parameters.is_empty() {
            self.out.line(format!("params : {name}_params;"));
        }
        match &code.start {
            None => self.out.line("arm : BOOL; (* start again at tick k *)"),
            Some(start) => {
                self.out.line("arm : BOOL; (* start again at start_time *)");
                self.out.line(format!("start_time : {real}; (* s *)"));
                if let Some(state) = &start.state {
                    let kind = self.type_of(state.shape);
                    self.out.line(format!(
                        "{} : {kind}; (* {}, latched by init and arm *)",
                        state.name, state.about
                    ));
                }
            }
        }
        for argument in &step.arguments {
            let (name, about) = (self.local(&argument.name), &argument.about);
            self.out.line(format!("{name} : {}; (* {about} *)", self.type_of(argument.shape)));
        }
        self.out.close("END_VAR");
        self.out.open("VAR_OUTPUT");
        if !self.observes() {
            self.out.line(format!("u : {real}; (* input of the plant *)"));
        }
        self.out.line("status : INT; (* see the head *)");
        let outputs: Vec<_> = self.outputs().cloned().collect();
        for function in &outputs {
            if let Some(given) = function.results.first() {
                let (kind, about) = (self.type_of(given.shape), &function.about);
                self.out.line(format!("{} : {kind}; (* {about} *)", function.name));
            }
        }
        self.out.close("END_VAR");
        self.out.open("VAR");
        self.out.line(format!("ready : BOOL;\nself : {name}_fields;"));
        self.out.close("END_VAR");
        self.out.open("VAR_TEMP");
        self.out.line(format!("built : {name}_fields;"));
        let mut locals = BTreeMap::new();
        for body in [&code.init, &arm.body, &step.body] {
            declared(body, &mut locals);
        }
        if code.start.is_some() {
            locals.insert("t0".to_owned(), Shape::Real);
        }
        for (name, shape) in locals {
            self.out.line(format!("{} : {};", self.local(&name), self.type_of(shape)));
        }
        self.counters(&step);
        self.out.close("END_VAR\n");
    }

    /// The variables of the loops.
    fn counters(&mut self, step: &Function) {
        if step.has(|statement| matches!(statement, Statement::Solve(_))) {
            self.out.line("attempt : DINT;");
        }
        let weights = step.body.iter().find_map(|statement| match statement {
            Statement::Rows { weights, .. } => Some(weights.len()),
            _ => None,
        });
        if let Some(weights) = weights {
            let real = self.real;
            self.out.line("row_k : DINT;\nrow_m : DINT;\nrow_first : DINT;");
            self.out.line(format!("row_v : {real};"));
            for (array, length) in [("p", weights - 1), ("q", weights - 2)] {
                self.out.line(format!("{array} : ARRAY[1..{length}] OF {real};"));
            }
        }
    }

    /// Sets the outputs that show what is kept.
    fn give_outputs(&mut self) {
        let outputs: Vec<_> = self.outputs().cloned().collect();
        for function in outputs {
            let (Some(given), Finish::Give(values, _)) =
                (function.results.first(), &function.finish)
            else {
                continue;
            };
            for (index, value) in values.iter().enumerate() {
                let place = match given.shape.length() {
                    Some(_) => self.element(function.name, index),
                    None => function.name.to_owned(),
                };
                let value = self.alone(value);
                self.out.line(format!("{place} := {value};"));
            }
        }
    }

    /// Functions of numbers that the block calls.
    fn helpers(&mut self) {
        let (code, name) = (self.code, &self.code.name);
        let (mut counts, mut divides) = (false, false);
        code.visit(&mut |value| match value {
            Expr::CountSub(..) | Expr::CountLeft(..) => counts = true,
            Expr::Quotient(..) => divides = true,
            _ => {}
        });
        if counts {
            self.out.line(helpers::COUNTS.replace("NAME", name));
        }
        if divides {
            let (real, zero) = (self.real, self.literal("0.0"));
            let huge = match code.precision {
                crate::parameter::Precision::F32 => self.literal("1e38"),
                crate::parameter::Precision::F64 => self.literal("1e308"),
            };
            let text = helpers::QUOTIENT.replace("NAME", name).replace("REAL", real);
            self.out.line(text.replace("ZERO", &zero).replace("HUGE", &huge));
        }
    }
}
