//! MATLAB and GNU Octave: a function file for each function. Integers saturate there, and a quotient
//! of them is rounded: differences of counts are taken in doubles, which hold them exactly.

mod axes;
mod functions;
mod helpers;
mod inputs;
mod target;

use std::collections::BTreeMap;

pub(in crate::emit) use target::TARGET;

use super::block::{Block, Branch};
use super::gives::Gives;
use super::legal::checks;
use super::literal::through_double;
use super::text::{Level, Lines, Text};
use crate::code::{AXIS, Code, Ending, Expr, Owner, Shape, Solve, Status, Test};
use crate::emit::File;
use crate::internal::fault;
use crate::parameter::Precision;

pub(super) struct Matlab<'a> {
    code: &'a Code,
    /// What leads to a field.
    owner: &'static str,
    /// Whether the function fails by an error, and what is wrong then.
    raises: Option<String>,
    /// The local values that are parameters.
    copies: BTreeMap<String, Expr>,
    /// What the function gives that is being printed, and the name of it.
    gives: Gives,
    result: String,
    out: Lines,
}

/// The function files of a controller.
pub(in crate::emit) fn files(code: &Code) -> Vec<File> {
    let printer = |owner| Matlab::new(code, owner);
    let file = |name: &str, mut text: String| {
        for helper in &helpers::HELPERS {
            if text.contains(&format!("{}(", helper.name)) {
                text.push_str(helper.text);
            }
        }
        File { name: format!("{}_{name}.m", code.name), text }
    };
    let functions = code.functions.iter().map(|f| file(f.name, printer(f.owner).function(f)));
    std::iter::once(file("init", printer(Owner::Controller).init())).chain(functions).collect()
}

impl Text for Matlab<'_> {
    fn as_text(&self) -> &dyn Text {
        self
    }

    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn literal(&self, digits: &str) -> String {
        match self.code.precision {
            Precision::F32 => format!("single({})", through_double(digits)),
            Precision::F64 => digits.to_owned(),
        }
    }

    fn count(&self, count: u32) -> String {
        format!("uint32({count})")
    }

    fn field(&self, name: &str) -> String {
        format!("{}{name}", self.owner)
    }

    fn parameter(&self, name: &str) -> String {
        format!("given.{name}")
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}({})", index + 1)
    }

    fn entry(&self, array: &str, row: usize, column: usize) -> String {
        format!("{array}({}, {})", row + 1, column + 1)
    }

    fn of_axis(&self, name: &str, stride: usize, index: usize) -> String {
        let place = match stride {
            1 => format!("{AXIS} + 1"),
            stride => format!("{stride} * {AXIS} + {}", index + 1),
        };
        format!("{}({place})", self.field(name))
    }

    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("uint32(mod(double({a}) - double({b}), 4294967296))"))
    }

    /// Saturates at 0.
    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Sum, format!("{a} - {b}"))
    }

    fn count_half(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("bitshift({count}, -1)"))
    }

    fn real(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("{}({count})", self.real_type()))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        (Level::Atom, format!("pick({test}, {yes}, {no})"))
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = match function {
            "sqrt" => "real_sqrt",
            "ln" => "real_log",
            "pow" => "real_pow",
            "atanh" => "real_atanh",
            function => function,
        };
        format!("{function}({})", arguments.join(", "))
    }

    fn fused(&self, _operands: &[String; 3]) -> Option<String> {
        None
    }

    fn abs(&self, a: &str) -> String {
        format!("abs({a})")
    }

    fn sign(&self, a: &str) -> (Level, String) {
        let (zero, one) = (self.literal("0.0"), self.literal("1.0"));
        (Level::Atom, format!("pick({a} > {zero}, {one}, pick({a} < {zero}, -{one}, {a}))"))
    }

    fn quotient(&self, a: &str, b: &str) -> (Level, String) {
        let (zero, real) = (self.literal("0.0"), self.real_type());
        let test = format!("({b} < {zero}) || ({b} > {zero})");
        (Level::Atom, format!("pick({test}, {a} / {b}, {real}(NaN))"))
    }

    fn callback(&self, name: &str, array: &str, time: &str) -> String {
        format!("{}({name}({array}, {time}))", self.real_type())
    }

    fn finite(&self, value: &str) -> String {
        format!("isfinite({value})")
    }

    fn not_number(&self, value: &str) -> String {
        format!("isnan({value})")
    }
}

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
        Branch { open: "if ", turn: "elseif ", then: "", joint, otherwise: "else", end: "end" }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("% ", "")
    }

    fn define(&self, name: &str, _shape: Shape, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn declare(&self, _name: &str, _shape: Shape) -> Option<String> {
        None
    }

    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} = {value};")
    }

    fn require(&mut self, test: &Test, status: Status) {
        let Some(wrong) = self.raises.clone() else {
            let line = self.unless("~", test, "");
            self.out.open(line);
            self.out.line(format!("status = int32({});\nreturn;", status.number()));
            return self.out.close("end");
        };
        let name = &self.code.name;
        for check in checks(test, &self.copies) {
            let line = self.unless("~", &check.test, "");
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

    fn rows(&mut self, name: &str, tail: &[Expr], weights: &[Expr]) {
        let [weights, tail] = [weights, tail].map(|values| self.list(values).join(", "));
        self.out.line(format!("{name} = row_sums([{weights}], [{tail}]);"));
    }

    fn elimination(&mut self, name: &str, matrix: &[Expr], right: &[Expr]) {
        let [matrix, right] = [matrix, right].map(|values| self.list(values).join(", "));
        self.out.line(format!("{name} = eliminate([{matrix}], [{right}]);"));
    }

    fn laws(&mut self, name: &str, callback: &str, given: &[&str; 3], _: usize) {
        let real = self.real_type();
        self.out.line(format!("{name} = {real}({callback}({}));", given.join(", ")));
    }

    fn rounds(&self, rounds: u32, _: bool) -> [String; 2] {
        let open = format!("for {} = uint32(0:{})", Solve::ROUND, rounds.saturating_sub(1));
        [open, "end".to_owned()]
    }

    fn leave(&self) -> &'static str {
        "break;"
    }

    fn begin(&self, name: &str, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn give(&mut self, values: &[Expr], ending: Ending) {
        let list = self.list(values);
        let result = &self.result;
        match self.gives {
            Gives::Nothing | Gives::Status => return,
            Gives::Progress => {}
            Gives::Control | Gives::Value | Gives::Number => {
                self.out.line(format!("{result} = {};", list.join("; ")));
            }
            Gives::Rate | Gives::Values | Gives::Array => {
                self.out.line(format!("{result} = [{}];", list.join("; ")))
            }
            Gives::Gains => {}
            Gives::Axes => fault("axes are the whole of a function"),
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

impl<'a> Matlab<'a> {
    pub(super) fn new(code: &'a Code, owner: Owner) -> Self {
        Self {
            code,
            owner: if owner == Owner::Gains { "gains." } else { "self." },
            raises: None,
            copies: BTreeMap::new(),
            gives: Gives::Status,
            result: String::new(),
            out: Lines::default(),
        }
    }

    fn real_type(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "single" } else { "double" }
    }

    fn list(&self, values: &[Expr]) -> Vec<String> {
        values.iter().map(|value| self.alone(value)).collect()
    }

    /// Whether a status is among the results.
    fn has_status(&self) -> bool {
        matches!(
            self.gives,
            Gives::Control | Gives::Rate | Gives::Gains | Gives::Progress | Gives::Axes
        )
    }
}
