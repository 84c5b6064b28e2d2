//! Statements in C++.

use super::super::block::{Around, Block, Branch, Ends, counted};
use super::super::gives::Gives;
use super::super::text::{Lines, Text};
use super::{Cpp, word};
use crate::code::{Ending, Expr, For, Shape, Status, Subroutine, Test};
use crate::internal::fault;

/// The type of indices.
const INDEX: &str = "std::uint32_t";

impl Block for Cpp<'_> {
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
        Branch { open: "if (", not: "!", turn: "} else if (", then: ") {", joint, otherwise, end }
    }

    fn joint_of_not(&self) -> &'static str {
        "\n        && "
    }

    fn define(&self, name: &str, shape: Shape, value: &str) -> String {
        format!("const {} {name} = {value};", self.type_of(shape))
    }

    /// With a value, which a constant function of C++17 needs.
    fn declare(&self, name: &str, shape: Shape) -> Option<String> {
        Some(format!("{} {name}{{}};", self.type_of(shape)))
    }

    fn require(&mut self, test: &Test, status: Status) {
        let line = self.refused(test);
        self.out.open(line);
        self.fail(status);
        self.out.close("}");
    }

    fn array(&mut self, name: &str, values: &[Expr]) {
        let values: Vec<_> = values.iter().map(|value| self.alone(value)).collect();
        let before = format!("const {} {name}{{{{", self.type_of(Shape::Reals(values.len())));
        let line = self.out.list(&before, &values, "}};");
        self.out.line(line);
    }

    fn apply(&mut self, name: &str, subroutine: Subroutine, given: &[Vec<Expr>; 2]) {
        let own = subroutine.arguments(name);
        let both = own.iter().zip(given).rev();
        both.for_each(|(own, values)| self.array(own, values));
        let (called, given) = (subroutine.name(), own.join(", "));
        self.out.line(format!("const auto {name} = {called}({given});"));
    }

    fn view(&self, name: &str, array: &str, first: bool) -> String {
        let kind = format!("const {}* ", self.real_type());
        format!("{}{name} = {array}.data();", if first { kind.as_str() } else { "" })
    }

    fn laws(&mut self, name: &str, callback: &str, given: &[&str; 3], count: usize) {
        let kind = self.type_of(Shape::Reals(count));
        self.out.line(format!("const {kind} {name} = {callback}({});", given.join(", ")));
    }

    fn each(&self, each: &For) -> Around {
        counted(self, each, INDEX)
    }

    fn begin(&self, name: &str, shape: Shape, value: &str) -> String {
        format!("{} {name} = {value};", self.type_of(shape))
    }
}

impl Ends for Cpp<'_> {
    fn as_ends(&mut self) -> &mut dyn Ends {
        self
    }

    fn give(&mut self, values: &[Expr], ending: Ending) {
        let values: Vec<_> = values.iter().map(|value| self.alone(value)).collect();
        let values = values.join(", ");
        let status = match ending {
            Ending::Known(status) => word(status),
            Ending::OfGains => "status".to_owned(),
        };
        self.out.line(match self.gives {
            Gives::Nothing => return,
            Gives::Status | Gives::Progress => format!("return {status};"),
            Gives::Control | Gives::Value | Gives::Count => {
                format!("return {{{values}, {status}}};")
            }
            Gives::Rate | Gives::Values => format!("return {{{{{{{values}}}}}, {status}}};"),
            Gives::Gains => format!("gains.status = {status};"),
            Gives::Array => format!("return {{{{{values}}}}};"),
            Gives::Number => format!("return {values};"),
            Gives::Axes => fault("several inputs are the whole of a function"),
        });
    }

    fn fail(&mut self, status: Status) {
        let (word, zero) = (word(status), self.literal("0.0"));
        self.out.line(match self.gives {
            Gives::Control | Gives::Value => format!("return {{{zero}, {word}}};"),
            Gives::Rate | Gives::Values => format!("return {{{{}}, {word}}};"),
            Gives::Count => format!("return {{0, {word}}};"),
            Gives::Gains => "return {};".to_owned(),
            Gives::Axes => {
                let each = vec![word.as_str(); self.code.axes().unwrap_or_default()].join(", ");
                format!("return {{{{}}, {{{{{each}}}}}, {word}}};")
            }
            _ => format!("return {word};"),
        });
    }
}
