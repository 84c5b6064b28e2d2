//! MATLAB and GNU Octave: a function file for each function. Integers saturate there, and a quotient
//! of them is rounded: differences of counts are taken in doubles, which hold them exactly.

use super::block::{Block, Branch, checks};
use super::text::{Level, Lines, Text, length};
use crate::code::{Access, Code, Function, Shape, Status, Test};
use crate::emit::{File, print::through_double};
use crate::parameter::Precision;

struct Matlab<'a> {
    code: &'a Code,
    /// Whether it is `init` that fails.
    raises: bool,
    out: Lines,
}

/// The function files of a controller.
pub(in crate::emit) fn files(code: &Code) -> Vec<File> {
    let printer = || Matlab { code, raises: false, out: Lines::default() };
    let file = |name: &str, text: String| {
        let text = if text.contains("pick(") { format!("{text}{PICK}") } else { text };
        File { name: format!("{}_{name}.m", code.name), text }
    };
    let functions = code.functions.iter().map(|f| file(f.name, printer().function(f)));
    std::iter::once(file("init", printer().init())).chain(functions).collect()
}

impl Text for Matlab<'_> {
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
        format!("self.{name}")
    }

    fn parameter(&self, name: &str) -> String {
        format!("given.{name}")
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}({})", index + 1)
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

    fn finite(&self, value: &str) -> String {
        format!("isfinite({value})")
    }
}

impl Block for Matlab<'_> {
    fn out(&mut self) -> &mut Lines {
        &mut self.out
    }

    fn lines(&self) -> &Lines {
        &self.out
    }

    fn branch(&self) -> Branch {
        Branch { open: "if ", turn: "elseif ", then: "", otherwise: "else", end: "end" }
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
        if !self.raises {
            let line = self.unless("~", test, " ...\n    && ", "");
            self.out.open(line);
            self.out.line(format!("status = int32({});\nreturn;", status.number()));
            return self.out.close("end");
        }
        let name = &self.code.name;
        for check in checks(test) {
            let line = self.unless("~", &check.test, " ...\n    && ", "");
            self.out.open(line);
            let parameter = check.parameter.map(|(name, index)| match index {
                Some(index) => format!("{name}({})", index + 1),
                None => name,
            });
            self.out.line(match parameter {
                None => format!("error('{name}:param', 'the coefficients overflow: take smaller gains, or rates and sample periods nearer to 1');"),
                Some(parameter) => format!("error('{name}:param', 'params.{parameter} is %g; legal: {}', params.{parameter});", check.legal),
            });
            self.out.close("end");
        }
    }
}

impl Matlab<'_> {
    fn real_type(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "single" } else { "double" }
    }

    fn init(mut self) -> String {
        let code = self.code;
        let (name, upper) = (&code.name, code.name.to_uppercase());
        let params = if code.parameters.is_empty() { "~" } else { "params" };
        self.out.line(format!("function self = {name}_init({params}) %#codegen"));
        self.out.line(format!("%{upper}_INIT  Takes the parameters and arms at tick 0.\n%"));
        self.out.words("%   ", &format!("self = {name}_init(params) is the controller, for the functions that stand beside this one. A parameter outside its domain, or coefficients that overflow, raise an error {name}:param, which names what is wrong and what is legal."));
        if !code.parameters.is_empty() {
            self.out.line("%\n%   params is a struct:");
        }
        for parameter in &code.parameters {
            let list = length(parameter.shape).map(|n| format!("(1:{n})")).unwrap_or_default();
            self.out.line(format!("%     {}{list}: {}", parameter.name, parameter.about));
        }
        self.out.line("");
        for line in &code.head {
            self.out.line(format!("% {line}").trim_end());
        }
        self.out.line("");
        for parameter in &code.parameters {
            self.given(&parameter.name, parameter.shape);
        }
        self.raises = true;
        self.block(&code.init);
        self.out.line("end");
        self.out.text()
    }

    /// A parameter in its own type, if it has one.
    fn given(&mut self, name: &str, shape: Shape) {
        let (own, real) = (&self.code.name, self.real_type());
        let kind = if shape == Shape::Count { "uint32" } else { real };
        self.out.line(format!("given.{name} = {kind}(params.{name});"));
        let (test, legal) = match shape {
            Shape::Real => return,
            Shape::Count => {
                let exact = format!("given.{name} ~= params.{name}");
                (exact, format!("'params.{name} is %g; legal: 0..2^32 - 1', params.{name}"))
            }
            Shape::Reals(n) => {
                let count = format!("numel(params.{name})");
                let legal = format!("'params.{name} has %d numbers; legal: {n}', {count}");
                (format!("{count} ~= {n}"), legal)
            }
        };
        let error = format!("error('{own}:param', {legal});");
        self.out.open(format!("if {test}"));
        self.out.line(error);
        self.out.close("end");
    }

    fn function(mut self, function: &Function) -> String {
        let code = self.code;
        let (name, upper) = (&code.name, code.name.to_uppercase());
        let (called, step) = (function.name, function.name == "step");
        let changes = function.access == Access::Change;
        let result = function.results.first();
        let mut gives: Vec<_> = result.iter().map(|given| given.variable.name.as_str()).collect();
        gives.extend(step.then_some("status"));
        gives.extend(changes.then_some("self"));
        let gives = match gives.as_slice() {
            [one] => (*one).to_owned(),
            several => format!("[{}]", several.join(", ")),
        };
        let list = function.arguments.iter().map(|argument| argument.name.as_str());
        let list = std::iter::once("self").chain(list).collect::<Vec<_>>().join(", ");
        let signature = format!("{gives} = {name}_{called}({list})");
        self.out.line(format!("function {signature} %#codegen"));
        let about = format!("{upper}_{}  {}", called.to_uppercase(), function.about);
        self.out.words("%", &about.replace("  ", " "));
        let kept = if changes { " Keep self: it is what the next call needs." } else { "" };
        self.out.line("%");
        self.out.words("%   ", &format!("{signature}, with self from {name}_init.{kept}"));
        if step {
            self.out.line(STATUSES);
        }
        self.out.line("");
        if let Some(given) = result.filter(|_| step) {
            self.out.line(format!("{} = {};", given.variable.name, self.literal("0.0")));
        }
        for argument in &function.arguments {
            let (real, name) = (self.real_type(), &argument.name);
            match argument.shape {
                Shape::Count => self.tick(name, step),
                _ => self.out.line(format!("{name} = {real}({name});")),
            }
        }
        self.block(&function.body);
        if let Some(given) = result {
            let values: Vec<_> = given.values.iter().map(|value| self.alone(value)).collect();
            self.out.line(match values.as_slice() {
                [one] => format!("{} = {one};", given.variable.name),
                several => format!("{} = [{}];", given.variable.name, several.join("; ")),
            });
        }
        if step {
            let set = |status: Status| format!("status = int32({});", status.number());
            self.outcomes(&function.status, &set);
        }
        self.out.line("end");
        self.out.text()
    }

    /// A tick of any numeric type, modulo 2^32.
    fn tick(&mut self, name: &str, step: bool) {
        self.out.line(format!("{name} = double({name});"));
        self.out.open(format!("if ~(isfinite({name}) && ({name} == floor({name})))"));
        match step {
            true => self.out.line(format!("status = int32({});\nreturn;", Status::Input.number())),
            false => {
                let own = &self.code.name;
                let error = format!("error('{own}:param', '{name} is %g; legal: whole', {name});");
                self.out.line(error);
            }
        }
        self.out.close("end");
        self.out.line(format!("{name} = uint32(mod({name}, 4294967296));"));
    }
}

/// There is no conditional expression.
const PICK: &str = "
function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
";

const STATUSES: &str = "\
%
%   status (int32); u is 0 on a negative one, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to u_max; wins over 1 and 3
%      3  after: the deadline is over, u is 0
%     -2  a measurement is not finite, or the tick is not whole
%     -3  u not finite";
