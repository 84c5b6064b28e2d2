//! The class of the controller: its constructor, and functions of one call at a time.

use super::super::block::{Block, Ends};
use super::super::gives::{Gives, required};
use super::super::legal::copies;
use super::super::text::Text;
use super::{Python, annotation};
use crate::code::{Finish, Function, Owner, Shape};
use crate::parameter::Precision;

const OVERFLOW: &str =
    "the coefficients leave the range of numbers; take gains, rates and sample periods nearer to 1";

impl Python<'_> {
    pub(super) fn class(&mut self, kind: &str) {
        let code = self.code;
        self.out.open(format!("class {kind}:"));
        self.out.line(format!("\"\"\"The {}. {}\n\nValueError where a parameter is outside its domain, or the coefficients leave the range of numbers.\n\"\"\"\n", code.noun(), code.starts()));
        self.init();
        for function in code.functions.iter().filter(|f| f.owner == Owner::Controller) {
            match code.start {
                Some(_) if Gives::of(function) != Gives::Status => self.batch_function(function),
                None if code.is_stateless() => self.batch_function(function),
                _ => self.function(function),
            }
        }
        self.out.leave();
    }

    fn init(&mut self) {
        let code = self.code;
        let mut list = vec!["self".to_owned(), "params: Params".to_owned()];
        let start = code.start.as_ref();
        let state = start.and_then(|start| start.state.as_ref());
        list.extend(state.map(|state| format!("{}: ArrayLike", state.name)));
        self.out.open(format!("def __init__({}) -> None:", list.join(", ")));
        self.out.open("with np.errstate(all=\"ignore\"):");
        for parameter in &code.parameters {
            self.given(&parameter.name, parameter.shape);
        }
        self.raises = Some(OVERFLOW.to_owned());
        self.copies = copies(&code.init);
        self.block(&code.init);
        self.copies.clear();
        self.raises = None;
        let nothing = code.parameters.is_empty() && code.init.is_empty();
        if nothing {
            self.out.line("pass");
        }
        self.out.leave();
        if let Some(start) = start {
            let mut list: Vec<_> = start.numbers().map(|number| self.alone(number)).collect();
            list.extend(state.map(|state| state.name.clone()));
            self.out.line(format!("self.{}({})", start.function(), list.join(", ")));
        }
        self.out.leave();
    }

    /// A parameter in its own type.
    fn given(&mut self, name: &str, shape: Shape) {
        match shape {
            Shape::Real => self.out.line(format!("given_{name} = _R(params.{name})")),
            Shape::Reals(length) => self.out.line(format!(
                "given_{name} = _numbers(params.{name}, {length}, \"params.{name}\")"
            )),
            Shape::Count => {
                self.out.line(format!("given_{name} = params.{name}.__index__()"));
                self.out.open(format!("if given_{name} != given_{name} & _WRAP:"));
                self.out.line(format!(
                    "raise ValueError(f\"params.{name} is {{params.{name}}}; legal: 0..2^32 - 1\")"
                ));
                self.out.leave();
            }
            Shape::Gains | Shape::Lists(..) | Shape::Statuses(_) => {}
        }
    }

    fn function(&mut self, function: &Function) {
        self.gives = Gives::of(function);
        let of_count = function.results.first().is_some_and(|own| own.shape == Shape::Count);
        if of_count {
            self.gives = Gives::Count;
        }
        let real = self.real_type();
        let result = match self.gives {
            Gives::Nothing | Gives::Status => "None".to_owned(),
            Gives::Control => "Control".to_owned(),
            Gives::Progress => "Status".to_owned(),
            Gives::Array => "Array".to_owned(),
            Gives::Number => format!("np.{real}"),
            Gives::Count => "int".to_owned(),
            Gives::Axes => "Axes".to_owned(),
            Gives::Rate | Gives::Value | Gives::Values | Gives::Gains => {
                crate::internal::fault("one of a batch")
            }
        };
        let mut list = vec!["self".to_owned()];
        for argument in &function.arguments {
            let kind = match argument.shape {
                Shape::Reals(_) | Shape::Lists(..) => "ArrayLike",
                // A float64 is a float, a float32 is none.
                Shape::Real if self.code.precision == Precision::F32 => "float | np.float32",
                shape => annotation(shape),
            };
            list.push(format!("{}: {kind}", argument.name));
        }
        self.out.line("");
        let name = function.name;
        self.out.open(format!("def {name}({}) -> {result}:", list.join(", ")));
        let line = format!("\"\"\"{}\"\"\"", function.about.trim_end());
        if function.failures.is_empty() && self.out.has_room(&line) {
            self.out.line(line);
        } else {
            self.out.words("", &format!("\"\"\"{}", function.about));
            self.out.line(match self.gives {
                Gives::Status if function.takes_duration() => "\nValueError where an argument or what follows from it is not finite, or tau is outside its\ndomain; the controller is left as it was.",
                Gives::Status => "\nValueError where an argument or what follows from it is not finite; the controller\nis left as it was.",
                Gives::Count => "\nValueError where an argument is not finite, or where there is none.",
                Gives::Progress => "\nOn a negative status nothing has changed.",
                _ => "\nOn a negative status u is 0 and nothing has changed.",
            });
            self.out.line("\"\"\"");
        }
        let computes = !function.body.is_empty() && !function.failures.is_empty();
        if computes {
            self.out.open("with np.errstate(all=\"ignore\"):");
        }
        for argument in &function.arguments {
            let name = &argument.name;
            match argument.shape {
                Shape::Count => self.out.line(format!("{name} = {name}.__index__() & _WRAP")),
                Shape::Reals(length) => {
                    self.out.line(format!("{name} = _numbers({name}, {length}, \"{name}\")"));
                }
                Shape::Lists(count, length) => {
                    let given = format!("{name}, {count}, {length}, \"{name}\"");
                    self.out.line(format!("{name} = _of_axes({given})"));
                }
                _ => self.out.line(format!("{name} = _R({name})")),
            }
        }
        if self.gives == Gives::Status {
            self.raises = Some(required(function));
        }
        let inputs = self.code.axes().filter(|_| function.finish == Finish::Stands);
        if let Some(count) = inputs {
            self.out.line(format!("u = np.zeros({count}, dtype=_R)"));
            self.out.line(format!("axes = np.zeros({count}, dtype=np.int8)"));
        }
        self.block(&function.body);
        self.raises = None;
        match inputs {
            Some(_) => self.out.line("return Axes(u, axes, np.asarray(status, dtype=np.int8))"),
            None => self.finish(&function.finish),
        }
        if computes {
            self.out.leave();
        }
        self.out.leave();
    }
}
