//! Statements.

use super::super::block::{Around, Block, Branch, Ends};
use super::super::gives::Gives;
use super::super::legal::checks;
use super::super::text::{Lines, Text, bracketed};
use super::Matlab;
use crate::code::{Ending, Expr, For, Shape, Status, Subroutine, Test};
use crate::internal::fault;

impl Block for Matlab<'_> {
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
        let joint = " ...\n    && ";
        Branch {
            open: "if ",
            not: "~",
            turn: "elseif ",
            then: "",
            joint,
            otherwise: "else",
            end: "end",
        }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("% ", "")
    }

    fn declare(&self, name: &str, shape: Shape) -> Option<String> {
        let (length, real) = (shape.length()?, self.real_type());
        Some(format!("{name} = zeros(1, {length}, '{real}');"))
    }

    fn require(&mut self, test: &Test, status: Status) {
        let Some(wrong) = self.raises.clone() else {
            let line = self.refused(test);
            self.out.open(line);
            self.out.line(format!("status = int32({});\nreturn;", status.number()));
            return self.out.close("end");
        };
        let name = &self.code.name;
        for check in checks(test, &self.copies) {
            let line = self.refused(&check.test);
            self.out.open(line);
            let parameter = check.parameter.map(|(name, index)| match index {
                Some(index) => format!("{name}({})", index + 1),
                None => name,
            });
            self.out.line(match parameter {
                None => format!("error('{name}:param', '{wrong}');"),
                Some(parameter) => format!("error('{name}:param', 'params.{parameter} is %g; legal: {}', params.{parameter});", check.legal),
            });
            self.out.close("end");
        }
    }

    fn array(&mut self, name: &str, values: &[Expr]) {
        let list = self.list(values).join("; ");
        self.out.line(format!("{name} = [{list}];"));
    }

    fn apply(&mut self, name: &str, subroutine: Subroutine, given: &[Vec<Expr>; 2]) {
        let given = given.each_ref().map(|values| format!("[{}]", self.list(values).join(", ")));
        self.out.line(format!("{name} = {}({});", subroutine.name(), given.join(", ")));
    }

    fn laws(&mut self, name: &str, callback: &str, given: &[&str; 3], _: usize) {
        let real = self.real_type();
        self.out.line(format!("{name} = {real}({callback}({}));", given.join(", ")));
    }

    fn each(&self, each: &For) -> Around {
        let (from, last) = (self.end(&each.from, 0), self.end(&each.to, -1));
        let [from, last] = [from, last].map(|end| bracketed(&end));
        let range = match (each.step, each.down) {
            (1, false) => format!("{from}:{last}"),
            (_, true) => format!("{last}:-1:{from}"),
            (step, _) => format!("{from}:{step}:{last}"),
        };
        Around::new(format!("for {} = {range}", each.index), "end")
    }
}

impl Ends for Matlab<'_> {
    fn as_ends(&mut self) -> &mut dyn Ends {
        self
    }

    fn give(&mut self, values: &[Expr], ending: Ending) {
        let list = self.list(values);
        let result = &self.result;
        match self.gives {
            Gives::Nothing | Gives::Status => return,
            Gives::Progress => {}
            Gives::Control | Gives::Value | Gives::Number | Gives::Count => {
                self.out.line(format!("{result} = {};", list.join("; ")));
            }
            Gives::Rate | Gives::Values | Gives::Array => {
                self.out.line(format!("{result} = [{}];", list.join("; ")))
            }
            Gives::Gains => {}
            Gives::Axes => fault("several inputs are the whole of a function"),
        }
        match ending {
            _ if !self.has_status() => {}
            Ending::Known(status) => self.out.line(format!("status = int32({});", status.number())),
            Ending::OfGains => self.out.line("status = gains.status;"),
        }
    }

    /// u is 0 from the start.
    fn fail(&mut self, status: Status) {
        self.out.line(format!("status = int32({});", status.number()));
    }
}
