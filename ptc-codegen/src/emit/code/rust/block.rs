//! Statements in Rust.

use super::super::block::{Around, Block, Branch, Ends, either, refused};
use super::super::gives::Gives;
use super::super::text::{Level, Lines, Text};
use super::text::typed;
use super::{CHOICE, Rust};
use crate::code::{Ending, Expr, For, Shape, Status, Subroutine, Test};
use crate::internal::fault;

impl Block for Rust<'_> {
    fn as_block(&mut self) -> &mut dyn Block {
        self
    }

    fn out(&mut self) -> &mut Lines {
        &mut self.out
    }

    fn lines(&self) -> &Lines {
        &self.out
    }

    fn branch(&self) -> Branch {
        let joint = "\n    && ";
        let (otherwise, end) = ("} else {", "}");
        Branch { open: "if ", not: "!", turn: "} else if ", then: " {", joint, otherwise, end }
    }

    /// With its type if the value holds only literals, which have no type.
    fn defined(&self, name: &str, shape: Shape, value: &Expr) -> String {
        match value.is_constant() {
            true => format!("{name}: {}", self.type_of(shape)),
            false => name.to_owned(),
        }
    }

    fn define(&self, name: &str, _shape: Shape, value: &str) -> String {
        format!("let {name} = {value};")
    }

    fn declare(&self, name: &str, shape: Shape) -> Option<String> {
        Some(match shape {
            Shape::Reals(length) => format!("let mut {name} = [0.0; {length}];"),
            shape => format!("let {name}: {};", self.type_of(shape)),
        })
    }

    /// A choice is a block each way where rustfmt makes it one.
    fn value(&self, value: &Expr) -> String {
        let text = self.alone(value);
        let (test, yes, no) = match value {
            _ if text.len() <= CHOICE => return text,
            Expr::Choose(test, yes, no) => (self.test(test), self.alone(yes), self.alone(no)),
            Expr::Quotient(a, b) => {
                let [a, b] = [a, b].map(|side| self.within(side, Level::Atom));
                (self.not_zero(&b), format!("{a} / {b}"), self.nan())
            }
            Expr::Divisor(a) => {
                let a = self.within(a, Level::Atom);
                (self.not_zero(&a), a, self.nan())
            }
            _ => return text,
        };
        format!("if {test} {{\n    {yes}\n}} else {{\n    {no}\n}}")
    }

    fn require(&mut self, test: &Test, status: Status) {
        let line = self.refused(test);
        self.out.open(line);
        let failed = if self.gives == Gives::Axes { "failed" } else { "Err" };
        self.out.line(format!("return {failed}({}Error::{});", self.runtime, status.name()));
        self.out.close("}");
    }

    fn refused(&self, test: &Test) -> String {
        let one = format!("if !({})", self.parts(test).join(" && "));
        self.with_brace(refused(self, test), one)
    }

    fn opened(&self, start: &str, tests: &[&Test]) -> String {
        let parts = match tests {
            [test] => self.parts(test),
            tests => vec![either(self, tests)],
        };
        let lead = if self.lead.0 == self.out.here() { self.lead.1 } else { "" };
        let before = format!("{lead}{start}");
        let line = self.out.joined(&before, &parts, ("&&", self.branch().joint), " {");
        let line = self.with_brace(line, format!("{before}{}", parts.join(" && ")));
        line.strip_prefix(lead).map_or(line.clone(), str::to_owned)
    }

    fn array(&mut self, name: &str, values: &[Expr]) {
        let list = self.list(values);
        let line = self.array_text(&format!("let {name} = &["), &list, "];");
        self.out.line(line);
    }

    fn apply(&mut self, name: &str, subroutine: Subroutine, given: &[Vec<Expr>; 2]) {
        let own = subroutine.arguments(name);
        for (own, values) in own.iter().zip(given) {
            let list = self.list(values);
            let line = self.array_text(&format!("let {own} = ["), &list, "];");
            self.out.line(line);
        }
        let (called, given) = (subroutine.name(), own.join(", "));
        self.out.line(format!("let {name} = Self::{called}({given});"));
    }

    fn view(&self, name: &str, array: &str, first: bool) -> String {
        format!("{}{name} = &{array};", if first { "let mut " } else { "" })
    }

    fn laws(&mut self, name: &str, callback: &str, given: &[&str; 3], _: usize) {
        self.out.line(format!("let {name} = {callback}({});", given.join(", ")));
    }

    fn each(&self, each: &For) -> Around {
        let [from, to] = [&each.from, &each.to].map(|end| self.end(end, 0));
        let range = match (each.step, each.down) {
            (1, false) => format!("{from}..{to}"),
            (_, true) => format!("({from}..{to}).rev()"),
            (step, _) => format!("({from}..{to}).step_by({step})"),
        };
        Around::new(format!("for {} in {range} {{", each.named()), "}")
    }

    fn begin(&self, name: &str, _: Shape, value: &str) -> String {
        format!("let mut {name} = {};", typed(value))
    }
}

impl Ends for Rust<'_> {
    fn as_ends(&mut self) -> &mut dyn Ends {
        self
    }

    fn give(&mut self, values: &[Expr], ending: Ending) {
        let runtime = self.runtime;
        let list = self.list(values);
        let status = match ending {
            Ending::Known(status) => format!("{runtime}Status::{}", status.name()),
            Ending::OfGains => "self.status".to_owned(),
        };
        match self.gives {
            Gives::Nothing => {}
            Gives::Status => self.out.line("Ok(())"),
            Gives::Progress => self.out.line(format!("Ok({status})")),
            Gives::Control if self.together => {
                self.out.line(format!("({}, {status})", list.join(", ")));
            }
            Gives::Control | Gives::Gains => self.out.line(status),
            Gives::Rate | Gives::Values | Gives::Array => {
                let (before, behind) =
                    if self.gives == Gives::Array { ("[", "]") } else { ("Ok([", "])") };
                let line = self.array_text(before, &list, behind);
                self.out.line(line);
            }
            Gives::Value | Gives::Count => {
                self.out.line(format!("Ok({})", list.join(", ")));
            }
            Gives::Number => self.out.line(list.join(", ")),
            Gives::Axes => fault("several inputs are the whole of a function"),
        }
    }

    fn fail(&mut self, status: Status) {
        let error = format!("Err({}Error::{})", self.runtime, status.name());
        // What is chosen is a value, unless the choice ends the call.
        self.out.line(match self.gives {
            Gives::Control | Gives::Gains => format!("return {error};"),
            _ => error,
        });
    }
}
