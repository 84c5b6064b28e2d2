//! The function block and the types beside it.

use std::collections::BTreeMap;

use super::super::block::{Block, Ends, declared};
use super::super::text::{Lines, Text};
use super::library::{Kind, Library, Member, Scope, Section, Unit};
use super::target::{factors, literal};
use super::{StructuredText, helpers};
use crate::code::{Expr, Function, Shape, Start, Status};
use crate::internal::fault;

/// The input that holds the duration of `arm_for`.
const FOR_TAU: &str = "arm_for_tau";

impl StructuredText<'_> {
    fn function(&self, name: &str) -> &Function {
        let found = self.code.functions.iter().find(|function| function.name == name);
        found.unwrap_or_else(|| fault(format!("no function {name}")))
    }

    /// Returns true for an observer, whose u is an input.
    pub(super) fn observes(&self) -> bool {
        self.code.function("update").is_some()
    }

    /// The number of inputs, where the block gives an array of them.
    pub(super) fn several(&self) -> Option<usize> {
        self.code.axes()
    }

    /// Returns the function that a call runs unless it is `init` or `arm`.
    pub(super) fn call(&self) -> &Function {
        self.function(if self.observes() { "update" } else { "step" })
    }

    /// The block, and what goes with it.
    pub(super) fn library(mut self) -> Library {
        let code = self.code;
        let name = &code.name;
        let mut structures = Vec::new();
        if !code.parameters.is_empty() {
            let parameters = code.parameters.iter().map(|p| (p.name.clone(), p));
            structures.push(self.structure("params", parameters));
        }
        let fields = code.fields.iter().map(|field| (self.local(&field.name), field));
        structures.push(self.structure("fields", fields));
        let about = helpers::about(code, self.real, self.about_commands());
        let lines = code.head.iter().map(String::as_str).chain(["", about.trim_end()]);
        // A comment does not end in the middle.
        let about = lines.collect::<Vec<_>>().join("\n").replace("(*", "( *").replace("*)", "* )");
        let statements = self.body();
        let body = format!("{}{statements}", self.wide_numbers());
        let block =
            Unit { name: name.clone(), about, returns: None, sections: self.sections(), body };
        Library { vectors: self.vectors(), structures, functions: self.helpers(), block }
    }

    /// Statements that assign the numbers beyond the range of a REAL. Each is a product of powers
    /// of two and therefore exact, since some compilers read every literal as a REAL.
    fn wide_numbers(&self) -> String {
        let wide = self.wide.borrow();
        if wide.is_empty() {
            return String::new();
        }
        let mut out = Lines::default();
        out.open("IF init THEN");
        for (index, digits) in wide.iter().enumerate() {
            let before = format!("{} := ", helpers::wide(index));
            let factors = factors(digits);
            out.line(out.joined(&before, &factors, ("*", "\n    * "), ";"));
        }
        out.close("END_IF;");
        out.text()
    }

    /// The statements of the block.
    fn body(&mut self) -> String {
        match self.no_command() {
            None => self.no_input(),
            Some(test) => {
                self.out.open(format!("IF {test} THEN"));
                self.no_input();
                self.out.close("END_IF;");
            }
        }
        let (starting, step) = (self.starting().clone(), self.call().clone());
        self.start(&starting);
        self.out.turn("ELSIF NOT ready THEN");
        self.settle(Status::Input.number());
        self.owner = "self";
        self.run_commands();
        self.out.turn("ELSE");
        self.block(&step.body);
        self.give_outputs();
        if self.several().is_none() {
            self.finish(&step.finish);
        }
        self.out.close("END_IF;");
        self.out.text().trim_end().to_owned()
    }

    /// Returns the function that every start runs: `arm`, or `arm_for`, where `arm` gives it the tau that is kept.
    fn starting(&self) -> &Function {
        self.function(self.code.start.as_ref().map_or("arm", Start::function))
    }

    /// Prints `init` and `arm`: the fields are built separately, so that a call that fails changes nothing.
    fn start(&mut self, starting: &Function) {
        let code = self.code;
        self.out.open(match self.code.changes_duration() {
            true => "IF init OR arm OR arm_for THEN",
            false => "IF init OR arm THEN",
        });
        self.settle(Status::Param.number());
        self.owner = "built";
        self.out.open("IF init THEN");
        self.block(&code.init);
        if let Some(start) = &code.start {
            for (name, number) in ["t0", "tau"].into_iter().zip(start.numbers()) {
                let (own, number) = (self.local(name), self.alone(number));
                if own != number {
                    self.out.line(format!("{own} := {number};"));
                }
            }
        }
        self.out.turn("ELSIF ready THEN");
        self.out.line("built := self;");
        match code.start {
            Some(_) => self.out.line(format!("{} := start_time;", self.local("t0"))),
            None => self.block(&starting.body),
        }
        if self.code.changes_duration() {
            let tau = self.local("tau");
            self.out.open("IF arm_for THEN");
            self.out.line(format!("{tau} := {FOR_TAU};"));
            self.out.turn("ELSE");
            let kept = self.field("tau");
            self.out.line(format!("{tau} := {kept};"));
            self.out.close("END_IF;");
        }
        self.out.turn("ELSE");
        self.out.line("RETURN;");
        self.out.close("END_IF;");
        if code.start.is_some() {
            self.block(&starting.body);
        }
        self.out.line("self := built;");
        self.owner = "self";
        self.give_outputs();
        self.out.line("ready := TRUE;");
        self.settle(Status::Ok.number());
    }

    /// The variables of the block.
    fn sections(&self) -> Vec<Section> {
        let section = |scope, members| Section { scope, members };
        let fields = || Kind::Derived(format!("{}_fields", self.code.name));
        let mut kept = vec![
            Member::plain("ready", "BOOL"),
            Member::new("self", fields(), ""),
            Member::new("built", fields(), ""),
        ];
        kept.extend(self.wide.borrow().iter().enumerate().map(|(index, digits)| {
            let value = literal(digits, self.code.precision);
            Member::new(helpers::wide(index), Kind::Elementary(self.real), value)
        }));
        // Some compilers accept only elementary types among temporary variables.
        let is_plain = |member: &Member| matches!(member.kind, Kind::Elementary(_));
        let (temporary, derived) = self.temporary().into_iter().partition(is_plain);
        kept.extend::<Vec<_>>(derived);
        let all = [
            section(Scope::Input, self.inputs()),
            section(Scope::Output, self.given()),
            section(Scope::Constant, self.constants()),
            section(Scope::Local, kept),
            section(Scope::Temporary, temporary),
        ];
        let is_used = |own: &Section| own.scope != Scope::Constant || !own.members.is_empty();
        all.into_iter().filter(is_used).collect()
    }

    fn inputs(&self) -> Vec<Member> {
        let code = self.code;
        let flag = |name, about| Member::new(name, Kind::Elementary("BOOL"), about);
        let mut inputs = vec![flag("init", "take the parameters and start")];
        if !code.parameters.is_empty() {
            inputs.push(Member::new("params", Kind::Derived(format!("{}_params", code.name)), ""));
        }
        match &code.start {
            None => inputs.push(flag("arm", "start again at tick k")),
            Some(start) => {
                inputs.push(flag("arm", "start again at start_time"));
                if self.code.changes_duration() {
                    inputs.push(flag("arm_for", "start again at start_time for arm_for_tau"));
                }
                inputs.push(Member::new("start_time", Kind::Elementary(self.real), "s"));
                if self.code.changes_duration() {
                    inputs.push(Member::new(FOR_TAU, Kind::Elementary(self.real), "duration, s"));
                }
                inputs.extend(start.state.as_ref().map(|state| {
                    let about = format!("{}, latched by init and arm", state.about);
                    Member::new(state.name.clone(), self.kind(state.shape), about)
                }));
            }
        }
        inputs.extend(self.call().arguments.iter().map(|argument| {
            Member::new(self.local(&argument.name), self.kind(argument.shape), &argument.about)
        }));
        inputs.extend(self.inputs_of_commands());
        inputs
    }

    /// The local values, and the variables of the loops.
    fn temporary(&self) -> Vec<Member> {
        let (code, step, commands) = (self.code, self.call(), self.commands());
        let mut locals = BTreeMap::new();
        let own = [&code.init, &self.starting().body, &step.body];
        for body in own.into_iter().chain(commands.iter().map(|command| &command.body)) {
            declared(body, &mut locals);
        }
        if code.start.is_some() {
            locals.insert("t0".to_owned(), Shape::Real);
        }
        if self.code.changes_duration() {
            locals.insert("tau".to_owned(), Shape::Real);
        }
        let local =
            |(name, shape): (String, _)| Member::new(self.local(&name), self.kind(shape), "");
        let mut members: Vec<_> = locals.into_iter().map(local).collect();
        let mut own = BTreeMap::new();
        let called = std::iter::once(step).chain(&commands).flat_map(Function::subroutines);
        for subroutine in called {
            let [_, other] = subroutine.given();
            own.insert(other.name.to_owned(), Shape::Reals(other.length));
            declared(&subroutine.body(0), &mut own);
        }
        let local = |(name, shape): (String, Shape)| {
            Member::new(helpers::of_subroutine(&name), self.kind(shape), "")
        };
        members.extend(own.into_iter().map(local));
        members
    }

    /// Functions of numbers that the block calls.
    fn helpers(&self) -> Vec<Unit> {
        let name = &self.code.name;
        let (mut counts, mut quotients, mut divisors) = (false, false, false);
        let look = &mut |value: &Expr| match value {
            Expr::CountSub(..) | Expr::CountLeft(..) => counts = true,
            Expr::Quotient(..) => quotients = true,
            Expr::Divisor(_) => divisors = true,
            _ => {}
        };
        self.code.visit(look);
        let subroutines = self.code.subroutines();
        let bodies = subroutines.iter().flat_map(|subroutine| subroutine.body(0));
        bodies.for_each(|statement| statement.visit(look));
        let mut functions = Vec::new();
        if counts {
            functions.extend([helpers::ticks(name), helpers::left(name)]);
        }
        let [zero, huge] = ["0.0", "1e38"].map(|digits| literal(digits, self.code.precision));
        if quotients {
            functions.push(helpers::quotient(name, self.real, [&zero, &huge]));
        }
        if divisors {
            functions.push(helpers::divisor(name, self.real, [&zero, &huge]));
        }
        functions
    }
}
