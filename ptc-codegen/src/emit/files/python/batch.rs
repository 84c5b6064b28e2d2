//! Functions of many calls at a time: tests choose between values, and statuses between one another.

use super::super::gives::Gives;
use super::super::text::Text;
use super::{Python, word};
use crate::code::{Ending, Finish, Function, Owner, Shape, Statement, Status, Test};
use crate::internal::fault;

/// The result and the status of an end, as expressions.
struct End {
    value: Option<String>,
    status: String,
}

impl Python<'_> {
    pub(super) fn batch_function(&mut self, function: &Function) {
        self.gives = Gives::of(function);
        let result = match self.gives {
            Gives::Control => "Control",
            Gives::Rate => "Rate",
            Gives::Value | Gives::Values => "Value",
            Gives::Gains => "Gains",
            Gives::Axes => "Axes",
            _ => fault(format!("{} is no batch", function.name)),
        };
        let mut list = vec!["self".to_owned()];
        for argument in &function.arguments {
            let default = if argument.name == "f" { " = 0.0" } else { "" };
            let kind = if argument.shape == Shape::Count { "int" } else { "ArrayLike" };
            list.push(format!("{}: {kind}{default}", argument.name));
        }
        list.extend((!function.callbacks.is_empty()).then(|| "*".to_owned()));
        let called = function.callbacks.iter();
        list.extend(called.map(|c| {
            let given = ["Array"].repeat(if c.gives > 1 { 3 } else { 2 }).join(", ");
            format!("{}: Callable[[{given}], ArrayLike]", c.name)
        }));
        self.out.line("");
        self.out.open(format!("def {}({}) -> {result}:", function.name, list.join(", ")));
        self.out.words("", &format!("\"\"\"{}", function.about));
        let is_list = |name| {
            function.arguments.iter().any(|a| a.name == name && matches!(a.shape, Shape::Lists(..)))
        };
        let stand = match (is_list("x"), is_list("r")) {
            (true, _) => "axes and what each is given stand along the last two axes",
            (false, true) => "states stand along the last axis, r along the last two",
            (false, false) => "states stand along the last axis",
        };
        self.out.line(format!("\nEach argument may be a batch; {stand}."));
        for callback in &function.callbacks {
            self.out.line("");
            let (name, about) = (callback.name, callback.about);
            self.out.words("", &format!("{name} is called for the whole batch. {about}"));
        }
        self.out.line("\"\"\"");
        self.batch = true;
        for argument in &function.arguments {
            let name = &argument.name;
            match argument.shape {
                Shape::Reals(n) => {
                    let states: Vec<_> = (0..n).map(|j| self.element(name, j)).collect();
                    let comma = if n == 1 { "," } else { "" };
                    let states = states.join(", ");
                    let read = if name == "r" { "_reference" } else { "_states" };
                    self.out.line(format!("{states}{comma} = {read}({name}, \"{name}\")"));
                }
                Shape::Lists(count, length) => {
                    let given = format!("{name}, {count}, {length}, \"{name}\"");
                    self.out.line(format!("{name} = _of_axes({given})"));
                }
                Shape::Count => self.number_of_axis(name),
                _ => self.out.line(format!("{name} = np.asarray({name}, dtype=_R)")),
            }
        }
        self.out.open("with np.errstate(all=\"ignore\"):");
        let legal = function.body.iter().filter_map(|statement| match statement {
            Statement::Require(test, status) => Some((test, *status)),
            _ => None,
        });
        let legal: Vec<_> = legal.collect();
        if function.finish == Finish::Stands {
            self.unset_inputs();
        }
        for statement in &function.body {
            if !matches!(statement, Statement::Require(..)) {
                self.chosen(statement);
            }
        }
        match function.finish {
            Finish::Stands => self.inputs(&legal),
            _ => self.end(function, &legal),
        }
        self.out.leave();
        self.out.leave();
        self.batch = false;
    }

    /// The number of an axis, which as an index could count from the last one.
    fn number_of_axis(&mut self, name: &str) {
        let count = self.code.axes().unwrap_or_default();
        self.out.line(format!("{name} = {name}.__index__()"));
        self.out.open(format!("if not 0 <= {name} < {count}:"));
        let last = count.saturating_sub(1);
        self.out.line(format!("raise ValueError(f\"{name} is {{{name}}}; legal: 0..{last}\")"));
        self.out.leave();
    }

    fn end(&mut self, function: &Function, legal: &[(&Test, Status)]) {
        let mut count = 0;
        let mut end = match self.gives {
            Gives::Control | Gives::Value => self.ends(&function.finish, &mut count),
            _ => self.ends(&without_values(&function.finish), &mut count),
        };
        for (test, status) in legal.iter().rev() {
            let test = self.test(test);
            end.status = format!("np.where({test}, {}, Status.{})", end.status, word(*status));
        }
        self.out.line(format!("status = {}", end.status));
        if function.owner == Owner::Gains {
            self.out.line("status = np.where(self.status < 0, self.status, status)");
        }
        let zero = "_R(0.0)";
        match self.gives {
            Gives::Control | Gives::Value => {
                let class = if self.gives == Gives::Value { "Value" } else { "Control" };
                let u = end.value.unwrap_or_else(|| fault("a control without u"));
                self.out.line(format!(
                    "return {class}(np.where(status < 0, {zero}, {u}), status.astype(np.int8))"
                ));
            }
            Gives::Rate | Gives::Values => {
                let (class, name) = match self.gives {
                    Gives::Rate => ("Rate", "xi_dot"),
                    _ => ("Value", "value"),
                };
                let list = self.list(function.finish.every()).join(", ");
                self.out.line(format!("rates = np.broadcast_arrays({list}, status)[:-1]"));
                self.out.line(format!("{name} = np.where((status < 0)[..., np.newaxis], {zero}, np.stack(rates, axis=-1))"));
                self.out.line(format!("return {class}({name}, status.astype(np.int8))"));
            }
            _ => self.give_gains(self.list(function.finish.every())),
        }
    }

    fn give_gains(&mut self, values: Vec<String>) {
        let mut values = values.into_iter();
        let mut list = Vec::new();
        for field in &self.code.gains {
            match field.shape.length() {
                Some(n) => {
                    let own: Vec<_> = values.by_ref().take(n).collect();
                    let own = own.join(", ");
                    let name = &field.name;
                    self.out
                        .line(format!("{name} = np.stack(np.broadcast_arrays({own}), axis=-1)"));
                    list.push(name.clone());
                }
                None => {
                    let value = values.next().unwrap_or_else(|| fault("a gain without a value"));
                    list.push(format!("np.asarray({value})"));
                }
            }
        }
        self.out.line(format!("return Gains({}, status.astype(np.int8))", list.join(", ")));
    }

    /// The end of a call, each of its tests in a variable.
    fn ends(&mut self, finish: &Finish, count: &mut usize) -> End {
        match finish {
            Finish::Give(values, ending) => End {
                value: values.first().map(|value| self.alone(value)),
                status: match ending {
                    Ending::Known(status) => format!("Status.{}", word(*status)),
                    Ending::OfGains => "self.status".to_owned(),
                },
            },
            Finish::Stands => fault("several inputs are the whole of an end"),
            Finish::Fail(status) => {
                End { value: None, status: format!("Status.{}", word(*status)) }
            }
            Finish::If(test, yes, no) => {
                *count += 1;
                let name = format!("way{count}");
                let test = self.test(test);
                self.out.line(format!("{name} = {test}"));
                let (yes, no) = (self.ends(yes, count), self.ends(no, count));
                let status = format!("np.where({name}, {}, {})", yes.status, no.status);
                let value = match (yes.value, no.value) {
                    (Some(yes), Some(no)) if yes != no => {
                        Some(format!("np.where({name}, {yes}, {no})"))
                    }
                    (yes, no) => yes.or(no),
                };
                End { value, status }
            }
        }
    }
}

/// The same end without values, which are the same on every way.
fn without_values(finish: &Finish) -> Finish {
    match finish {
        Finish::If(test, yes, no) => {
            Finish::choose(test.clone(), without_values(yes), without_values(no))
        }
        Finish::Give(_, ending) => Finish::Give(Vec::new(), *ending),
        Finish::Fail(_) | Finish::Stands => finish.clone(),
    }
}
