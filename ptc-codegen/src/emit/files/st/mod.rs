//! IEC 61131-3 Structured Text: a function block. Counts never overflow in it, for what becomes of
//! them then depends on the controller.

mod block;
mod commands;
mod helpers;
mod library;
mod outputs;
mod target;
mod text;
mod types;

use std::cell::RefCell;
use std::collections::BTreeSet;

use super::block::{Around, Block, Branch, Ends};
use super::gives::Gives;
use super::text::{Lines, Text};
use crate::code::{Code, Ending, Expr, For, Shape, Status, Subroutine, Test};
use crate::emit::File;
use crate::internal::fault;
use crate::parameter::Precision;
pub(in crate::emit) use library::{Kind, Library, Scope, Unit};
pub(in crate::emit) use target::{TARGET, names_itself};

pub(super) struct StructuredText<'a> {
    code: &'a Code,
    real: &'static str,
    /// The structure whose fields are set.
    owner: &'static str,
    /// In the statements of a subroutine, the array that it changes, and the one that stands for it.
    applied: Option<(&'static str, String)>,
    /// Arguments of the command that is printed, with the inputs that hold them, and the output of its result.
    given: Vec<(String, String)>,
    found: Option<String>,
    /// Shapes of the arrays, each of which is a type.
    arrays: RefCell<BTreeSet<Shape>>,
    /// Digits of the numbers that no REAL can hold, in the order in which they are used.
    wide: RefCell<Vec<String>>,
    out: Lines,
}

/// The file of a controller.
pub(in crate::emit) fn file(code: &Code) -> File {
    File { name: format!("{}.st", code.name), text: library(code).text() }
}

/// Returns the contents of that file.
pub(in crate::emit) fn library(code: &Code) -> Library {
    StructuredText::new(code).library()
}

impl Block for StructuredText<'_> {
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
        let joint = "\n    AND ";
        let (otherwise, end) = ("ELSE", "END_IF;");
        Branch { open: "IF ", not: "NOT ", turn: "ELSIF ", then: " THEN", joint, otherwise, end }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("(* ", " *)")
    }

    /// All variables are declared before the statements.
    fn declare(&self, _name: &str, _shape: Shape) -> Option<String> {
        None
    }

    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} := {value};")
    }

    fn require(&mut self, test: &Test, status: Status) {
        let line = self.refused(test);
        self.out.open(line);
        self.settle(status.number());
        self.out.line("RETURN;");
        self.out.close("END_IF;");
    }

    fn array(&mut self, name: &str, values: &[Expr]) {
        let name = self.local(name);
        for (index, value) in values.iter().enumerate() {
            let value = self.alone(value);
            self.out.line(format!("{name}[{}] := {value};", index + 1));
        }
    }

    /// A function gives no array, so the statements are written where they are needed.
    fn apply(&mut self, name: &str, subroutine: Subroutine, given: &[Vec<Expr>; 2]) {
        let [changed, other] = subroutine.given().map(|own| own.name);
        self.array(name, &given[0]);
        self.applied = Some((changed, name.to_owned()));
        let other = self.local(other);
        self.applied = None;
        self.array(&other, &given[1]);
        self.applied = Some((changed, name.to_owned()));
        self.block(&subroutine.body(0));
        self.applied = None;
    }

    fn laws(&mut self, _: &str, callback: &str, _: &[&str; 3], _: usize) {
        fault(format!("{callback} gives several values, and such laws are refused"))
    }

    /// A loop that may have one round is written as WHILE: MatIEC leaves out the body of a FOR whose
    /// ends are equal.
    fn each(&self, each: &For) -> Around {
        let index = self.local(&each.index);
        let (from, last) = (self.end(&each.from, 0), self.end(&each.to, -1));
        if each.down {
            // A count does not pass below 0.
            let (behind, first) = (self.end(&each.to, 0), self.end(&each.from, 0));
            return Around {
                before: Some(format!("{index} := {behind};")),
                first: Some(format!("{index} := {index} - {};", self.whole(1))),
                ..Around::new(format!("WHILE {index} > {first} DO"), "END_WHILE;")
            };
        }
        let known = each.from.terms.is_empty() && each.to.terms.is_empty();
        let rounds = i64::from(each.to.constant) - i64::from(each.from.constant);
        if !known || rounds <= i64::from(each.step) {
            let step = self.whole(each.step);
            return Around {
                before: Some(format!("{index} := {from};")),
                last: Some(format!("{index} := {index} + {step};")),
                ..Around::new(format!("WHILE {index} <= {last} DO"), "END_WHILE;")
            };
        }
        let by = match each.step {
            1 => String::new(),
            step => format!(" BY {}", self.whole(step)),
        };
        Around::new(format!("FOR {index} := {from} TO {last}{by} DO"), "END_FOR;")
    }

    fn leave(&self) -> &'static str {
        "EXIT;"
    }
}

impl Ends for StructuredText<'_> {
    fn as_ends(&mut self) -> &mut dyn Ends {
        self
    }

    fn give(&mut self, values: &[Expr], ending: Ending) {
        if let [value] = values {
            let value = self.alone(value);
            let place = self.found.as_deref().unwrap_or("u");
            self.out.line(format!("{place} := {value};"));
        }
        if let Ending::Known(status) = ending {
            self.out.line(format!("status := {};", status.number()));
        }
    }

    /// u is 0 from the start.
    fn fail(&mut self, status: Status) {
        self.out.line(format!("status := {};", status.number()));
    }
}

impl<'a> StructuredText<'a> {
    pub(super) fn new(code: &'a Code) -> Self {
        let real = if code.precision == Precision::F32 { "REAL" } else { "LREAL" };
        Self {
            code,
            real,
            owner: "self",
            applied: None,
            given: Vec::new(),
            found: None,
            arrays: RefCell::default(),
            wide: RefCell::default(),
            out: Lines::default(),
        }
    }
}
