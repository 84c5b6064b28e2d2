//! Statements.

use super::super::block::{Around, Block, Branch, Ends, either, refused};
use super::super::gives::Gives;
use super::super::legal::checks;
use super::super::text::{Lines, Text};
use super::{Python, boxed, refusal, word};
use crate::code::{Ending, Expr, For, Shape, Status, Subroutine, Test};

impl Block for Python<'_> {
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
        let joint = "\n    and ";
        Branch {
            open: "if ",
            not: "not ",
            turn: "elif ",
            then: ":",
            joint,
            otherwise: "else:",
            end: "",
        }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("# ", "")
    }

    /// The numbers of an array that changes are those of a batch, one by one.
    fn declare(&self, name: &str, shape: Shape) -> Option<String> {
        let length = shape.length()?;
        Some(format!("{name}: list[Array] = [np.asarray(_R(0.0))] * {length}"))
    }

    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} = {value}")
    }

    fn value(&self, value: &Expr) -> String {
        match value {
            Expr::Number(_) => boxed(&self.alone(value)),
            Expr::Neg(of) if matches!(**of, Expr::Number(_)) => boxed(&self.alone(value)),
            value => self.alone(value),
        }
    }

    /// In brackets where it takes several lines.
    fn opened(&self, start: &str, tests: &[&Test]) -> String {
        let parts = match tests {
            [test] => self.parts(test),
            tests => vec![either(self, tests)],
        };
        let line = self.out.joined(start, &parts, ("and", self.branch().joint), ":");
        match line.strip_prefix(start).and_then(|test| test.strip_suffix(':')) {
            Some(test) if test.contains('\n') => format!("{start}(\n    {test}\n):"),
            _ => line,
        }
    }

    fn refused(&self, test: &Test) -> String {
        let line = refused(self, test);
        match line.contains('\n') {
            true => line.replacen('(', "(\n    ", 1).replace("):", "\n):"),
            false => line,
        }
    }

    fn require(&mut self, test: &Test, status: Status) {
        let Some(wrong) = self.raises.clone() else {
            let line = self.refused(test);
            self.out.open(line);
            self.fail(status);
            return self.out.leave();
        };
        for check in checks(test, &self.copies) {
            let line = self.refused(&check.test);
            self.out.open(line);
            let name = match &check.parameter {
                Some((name, Some(index))) => format!("{name}[{index}]"),
                Some((name, None)) => name.clone(),
                None => String::new(),
            };
            self.out.line(match name.as_str() {
                "" => format!("raise ValueError(\"{wrong}\")"),
                name => {
                    format!(
                        "raise ValueError(f\"params.{name} is {{params.{name}}}; legal: {}\")",
                        check.legal
                    )
                }
            });
            self.out.leave();
        }
    }

    fn array(&mut self, name: &str, values: &[Expr]) {
        let list = self.list(values).join(", ");
        self.out.line(format!("{name} = np.stack(np.broadcast_arrays({list}), axis=-1)"));
    }

    fn apply(&mut self, name: &str, subroutine: Subroutine, given: &[Vec<Expr>; 2]) {
        let given = given.each_ref().map(|values| format!("[{}]", self.list(values).join(", ")));
        self.out.line(format!("{name} = _{}({})", subroutine.name(), given.join(", ")));
    }

    fn laws(&mut self, name: &str, callback: &str, [array, time, rate]: &[&str; 3], count: usize) {
        self.out.line(format!(
            "{name} = np.asarray({callback}({array}, np.asarray({time}), np.asarray({rate})), dtype=_R)"
        ));
        self.out.open(format!("if {name}.ndim == 0 or {name}.shape[-1] != {count}:"));
        self.out.line(format!(
            "raise ValueError(f\"{callback} gives shape {{{name}.shape}}; legal: (..., {count})\")"
        ));
        self.out.leave();
    }

    fn each(&self, each: &For) -> Around {
        let [from, to] = [&each.from, &each.to].map(|end| self.end(end, 0));
        let range = match (from.as_str(), each.step) {
            ("0", 1) => format!("range({to})"),
            (_, 1) => format!("range({from}, {to})"),
            (_, step) => format!("range({from}, {to}, {step})"),
        };
        let range = if each.down { format!("reversed({range})") } else { range };
        Around::new(format!("for {} in {range}:", each.named()), "")
    }

    fn leave(&self) -> &'static str {
        "break"
    }

    fn begin(&self, name: &str, _: Shape, value: &str) -> String {
        format!("{name} = np.asarray({value})")
    }
}

impl Ends for Python<'_> {
    fn as_ends(&mut self) -> &mut dyn Ends {
        self
    }

    fn give(&mut self, values: &[Expr], ending: Ending) {
        let list: Vec<_> = values.iter().map(|value| self.value(value)).collect();
        let list = list.join(", ");
        let status = match ending {
            Ending::Known(status) => format!("Status.{}", word(status)),
            Ending::OfGains => "self.status".to_owned(),
        };
        self.out.line(match self.gives {
            Gives::Nothing
            | Gives::Status
            | Gives::Gains
            | Gives::Rate
            | Gives::Value
            | Gives::Values
            | Gives::Axes => return,
            Gives::Count => format!("return int({list})"),
            Gives::Control => format!("return Control({list}, {status})"),
            Gives::Progress => format!("return {status}"),
            Gives::Array => format!("return np.array([{list}], dtype=_R)"),
            Gives::Number => format!("return {list}"),
        });
    }

    fn fail(&mut self, status: Status) {
        let word = word(status);
        self.out.line(match self.gives {
            Gives::Progress => format!("return Status.{word}"),
            Gives::Count => format!("raise ValueError(\"{}\")", refusal(status)),
            Gives::Axes => format!("return {}", self.refused_inputs(status)),
            _ => format!("return Control(_R(0.0), Status.{word})"),
        });
    }
}
