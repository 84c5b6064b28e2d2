//! The interpreter: whole controllers, in the operations and the precision of the emitted code.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::{
    Access, Code, Ending, Expr, Finish, Operator, Place, Shape, Solve, Statement, Status, Test,
    Variable,
};
use crate::internal::fault;
use crate::parameter::{Parameter, Precision};
use crate::program::{Op, Value, apply, number, rows::rows};

/// What a name holds.
#[derive(Clone, Debug, PartialEq)]
enum Held {
    Real(f64),
    Count(u32),
    Reals(Vec<f64>),
}

/// A value handed to a call or given by it.
pub type Argument<'a> = (&'a str, &'a [f64]);

/// A controller that runs.
#[derive(Clone, Debug)]
pub struct Instance<'a> {
    code: &'a Code,
    fields: BTreeMap<&'a str, Held>,
    /// The status of gains; that of a controller is not asked for.
    status: Status,
}

/// What a call gave: its status, and its results, none of them where it failed.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Its status.
    pub status: Status,
    /// Its results by name; those of gains by the names in them.
    pub results: BTreeMap<String, Vec<f64>>,
}

/// A function of the user's: its name, and what it gives for an array and a time.
pub type Called<'a> = (&'a str, &'a dyn Fn(&[f64], f64) -> f64);

/// The names that one call knows.
struct Frame<'a, 'b> {
    precision: Precision,
    fields: &'b mut BTreeMap<&'a str, Held>,
    parameters: BTreeMap<&'b str, Held>,
    locals: BTreeMap<Cow<'b, str>, Held>,
    callbacks: &'b [Called<'b>],
}

impl<'a> Instance<'a> {
    /// The controller that `init` makes of the parameters, each a list of numbers; counts are given
    /// as numbers. A state that is latched is given by its name too.
    ///
    /// # Errors
    /// The status with which `init` fails.
    pub fn new(code: &'a Code, given: &[Argument<'_>]) -> Result<Self, Status> {
        let mut fields: BTreeMap<&str, Held> = code
            .fields
            .iter()
            .map(|field| (field.name.as_str(), held(field, &[f64::NAN], code.precision)))
            .collect();
        let mut frame = Frame {
            precision: code.precision,
            fields: &mut fields,
            parameters: bound(&code.parameters, given, code.precision),
            locals: BTreeMap::new(),
            callbacks: &[],
        };
        if let Some(status) = frame.block(&code.init) {
            return Err(status);
        }
        let time = code.start.as_ref().map(|start| frame.real(&start.time));
        let mut built = Self { code, fields, status: Status::Ok };
        if let (Some(time), Some(start)) = (time, &code.start) {
            let x0 = start.state.as_ref().and_then(|state| {
                given.iter().find(|(name, _)| *name == state.name).map(|(_, values)| *values)
            });
            let outcome = built.call("arm", &[("t0", &[time]), ("x0", x0.unwrap_or_default())]);
            if outcome.status.number() < 0 {
                return Err(outcome.status);
            }
        }
        Ok(built)
    }

    /// The controller that `init` makes of its run-time parameters; the elements of an array are in
    /// their order.
    ///
    /// # Errors
    /// The status with which `init` fails.
    pub fn with_parameters(
        code: &'a Code,
        values: impl IntoIterator<Item = (Parameter, f64)>,
    ) -> Result<Self, Status> {
        let mut given: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
        for (parameter, value) in values {
            given.entry(parameter.key()).or_default().push(value);
        }
        let given: Vec<_> = given.iter().map(|(key, values)| (*key, values.as_slice())).collect();
        Self::new(code, &given)
    }

    /// The gains that a call gave, for the functions that belong to them.
    pub fn gains(&self, outcome: &Outcome) -> Self {
        let values = |name: &str| outcome.results.get(name).map_or(&[][..], Vec::as_slice);
        let field =
            |of: &'a Variable| (of.name.as_str(), held(of, values(&of.name), self.code.precision));
        let fields = self.code.gains.iter().map(field).collect();
        Self { code: self.code, fields, status: outcome.status }
    }

    /// Calls a function with its arguments.
    pub fn call(&mut self, name: &str, arguments: &[Argument<'_>]) -> Outcome {
        self.call_with(name, arguments, &[])
    }

    /// Calls a function with its arguments and the functions that it calls.
    pub fn call_with(
        &mut self,
        name: &str,
        arguments: &[Argument<'_>],
        callbacks: &[Called<'_>],
    ) -> Outcome {
        let Some(function) = self.code.function(name) else { fault(format!("no function {name}")) };
        let mut changed = self.fields.clone();
        let mut frame = Frame {
            precision: self.code.precision,
            fields: &mut changed,
            parameters: BTreeMap::new(),
            locals: bound(&function.arguments, arguments, self.code.precision)
                .into_iter()
                .map(|(name, held)| (Cow::from(name), held))
                .collect(),
            callbacks,
        };
        let failed = |status| Outcome { status, results: BTreeMap::new() };
        if let Some(status) = frame.block(&function.body) {
            return failed(status);
        }
        let mut finish = &function.finish;
        let (values, status) = loop {
            match finish {
                Finish::If(test, yes, no) => finish = if frame.test(test) { yes } else { no },
                Finish::Give(values, Ending::Known(status)) => break (values, *status),
                Finish::Give(values, Ending::OfGains) => break (values, self.status),
                Finish::Fail(status) => return failed(*status),
            }
        };
        let mut values = values.iter().map(|value| frame.real(value));
        let parts = function.results.iter().flat_map(|result| match result.shape {
            Shape::Gains => self.code.gains.iter().collect(),
            _ => vec![result],
        });
        let mut results = BTreeMap::new();
        for part in parts {
            let count = part.shape.length().unwrap_or(1);
            results.insert(part.name.clone(), values.by_ref().take(count).collect());
        }
        drop(values);
        if function.access == Access::Change {
            self.fields = changed;
        }
        Outcome { status, results }
    }

    /// What a field holds, as a number.
    pub fn field(&self, name: &str) -> Option<f64> {
        match self.fields.get(name)? {
            Held::Real(value) => Some(*value),
            Held::Count(count) => Some(f64::from(*count)),
            Held::Reals(_) => None,
        }
    }
}

/// `values` as `variable` holds them.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn held(variable: &Variable, values: &[f64], precision: Precision) -> Held {
    let first = values.first().copied().unwrap_or(f64::NAN);
    match variable.shape {
        Shape::Real => Held::Real(number::settle(first, precision)),
        // A count beyond 2^32 is given modulo 2^32, as a counter wraps.
        Shape::Count => Held::Count(first as u64 as u32),
        Shape::Reals(_) => {
            Held::Reals(values.iter().map(|v| number::settle(*v, precision)).collect())
        }
        Shape::Gains => fault("gains are no value".to_owned()),
    }
}

fn bound<'b>(
    variables: &'b [Variable],
    given: &[Argument<'_>],
    precision: Precision,
) -> BTreeMap<&'b str, Held> {
    let value = |variable: &'b Variable| {
        let values = given.iter().find(|(name, _)| *name == variable.name).map(|(_, v)| *v);
        (variable.name.as_str(), held(variable, values.unwrap_or_default(), precision))
    };
    variables.iter().map(value).collect()
}

impl<'b> Frame<'_, 'b> {
    /// Runs statements; the status where one of them fails.
    fn block(&mut self, statements: &'b [Statement]) -> Option<Status> {
        for statement in statements {
            match statement {
                Statement::Let(name, shape, value) => {
                    let value = self.value(value, *shape);
                    self.locals.insert(Cow::from(name), value);
                }
                Statement::Set(Place::Local(name), value) => {
                    let value = Held::Real(self.real(value));
                    self.locals.insert(Cow::from(name), value);
                }
                Statement::Set(Place::Field(name), value) => {
                    let shape = match self.fields.get(name.as_str()) {
                        Some(Held::Count(_)) => Shape::Count,
                        _ => Shape::Real,
                    };
                    let value = self.value(value, shape);
                    if let Some(field) = self.fields.get_mut(name.as_str()) {
                        *field = value;
                    }
                }
                Statement::If(test, then, otherwise) => {
                    let block = if self.test(test) { then } else { otherwise };
                    if let Some(status) = self.block(block) {
                        return Some(status);
                    }
                }
                Statement::Require(test, status) if !self.test(test) => return Some(*status),
                Statement::Array(name, values) => {
                    let values = values.iter().map(|value| self.real(value)).collect();
                    self.locals.insert(Cow::from(name), Held::Reals(values));
                }
                Statement::Rows { name, tail, weights } => {
                    let [tail, weights]: [Vec<f64>; 2] =
                        [tail, weights].map(|list| list.iter().map(|v| self.real(v)).collect());
                    let values = self.rows(&tail, &weights);
                    self.locals.insert(Cow::from(name), Held::Reals(values));
                }
                Statement::Solve(solve) => {
                    if let Some(status) = self.solve(solve) {
                        return Some(status);
                    }
                }
                Statement::Require(..) | Statement::Variable(..) | Statement::Note(_) => {}
            }
        }
        None
    }

    fn rows(&self, tail: &[f64], weights: &[f64]) -> Vec<f64> {
        let settle = |value| number::settle(value, self.precision);
        rows(tail, weights, |a, b| settle(a + b), |a, b| settle(a * b))
    }

    /// The rounds of an iteration, the root of which is left in its unknown.
    fn solve(&mut self, solve: &'b Solve) -> Option<Status> {
        let [mut y, mut low, mut high, tolerance] =
            [&solve.start, &solve.low, &solve.high, &solve.tolerance].map(|value| self.real(value));
        let settle = |value, precision| number::settle(value, precision);
        for _ in 0..solve.rounds {
            self.locals.insert(Cow::from(&solve.unknown), Held::Real(y));
            if let Some(status) = self.block(&solve.body) {
                return Some(status);
            }
            let [residual, next, size] =
                [&solve.residual, &solve.next, &solve.size].map(|value| self.real(value));
            if residual > 0.0 {
                low = y;
            } else {
                high = y;
            }
            y = match next >= low && next <= high {
                true => next,
                false => settle(0.5 * settle(low + high, self.precision), self.precision),
            };
            if size <= tolerance {
                break;
            }
        }
        self.locals.insert(Cow::from(&solve.unknown), Held::Real(y));
        None
    }

    fn value(&self, value: &Expr, shape: Shape) -> Held {
        match shape {
            Shape::Count => Held::Count(self.count(value)),
            _ => Held::Real(self.real(value)),
        }
    }

    fn real(&self, value: &Expr) -> f64 {
        let round = |result| number::settle(result, self.precision);
        match value {
            Expr::Number(value) => number::round(value, self.precision),
            Expr::Neg(a) => -self.real(a),
            Expr::Binary(operator, a, b) => match operator {
                Operator::Add => self.apply(Op::Add, a, b),
                Operator::Sub => self.apply(Op::Sub, a, b),
                Operator::Mul => self.apply(Op::Mul, a, b),
                Operator::Div => self.apply(Op::Div, a, b),
            },
            Expr::Quotient(a, b) => self.apply(Op::Quotient, a, b),
            Expr::Pow(a, b) => self.apply(Op::Pow, a, b),
            Expr::Call(function, a) => {
                let result = apply(&Op::Call(*function, Value(0)), &[self.real(a)], self.precision);
                result.unwrap_or(f64::NAN)
            }
            Expr::Callback(name, array, time) => {
                let Some((_, called)) = self.callbacks.iter().find(|(known, _)| known == name)
                else {
                    fault(format!("no function {name}"))
                };
                match self.locals.get(array.as_str()) {
                    Some(Held::Reals(values)) => round(called(values, self.real(time))),
                    _ => fault(format!("{array} is no array")),
                }
            }
            Expr::Real(a) => round(f64::from(self.count(a))),
            Expr::Choose(test, a, b) => self.real(if self.test(test) { a } else { b }),
            Expr::Count(_) | Expr::CountSub(..) | Expr::CountLeft(..) | Expr::CountHalf(_) => {
                f64::from(self.count(value))
            }
            name => match self.held(name) {
                (Held::Real(value), _) => *value,
                (Held::Reals(values), index) => values.get(index).copied().unwrap_or(f64::NAN),
                (Held::Count(count), _) => f64::from(*count),
            },
        }
    }

    fn apply(&self, op: fn(Value, Value) -> Op, a: &Expr, b: &Expr) -> f64 {
        let operands = [self.real(a), self.real(b)];
        apply(&op(Value(0), Value(1)), &operands, self.precision).unwrap_or(f64::NAN)
    }

    fn count(&self, value: &Expr) -> u32 {
        match value {
            Expr::Count(count) => *count,
            Expr::CountSub(a, b) => self.count(a).wrapping_sub(self.count(b)),
            Expr::CountLeft(a, b) => self.count(a).saturating_sub(self.count(b)),
            Expr::CountHalf(a) => self.count(a) / 2,
            name => match self.held(name) {
                (Held::Count(count), _) => *count,
                _ => fault("a number is used as a count".to_owned()),
            },
        }
    }

    fn held(&self, name: &Expr) -> (&Held, usize) {
        let (found, index) = match name {
            Expr::Local(name) => (self.locals.get(name.as_str()), 0),
            Expr::Element(name, index) => (self.locals.get(name.as_str()), *index),
            Expr::Field(name) => (self.fields.get(name.as_str()), 0),
            Expr::FieldElement(name, index) => (self.fields.get(name.as_str()), *index),
            Expr::Parameter(name) => (self.parameters.get(name.as_str()), 0),
            Expr::ParameterElement(name, index) => (self.parameters.get(name.as_str()), *index),
            _ => (None, 0),
        };
        match found {
            Some(held) => (held, index),
            None => fault(format!("{name:?} is not known")),
        }
    }

    fn test(&self, test: &Test) -> bool {
        match test {
            Test::Less(a, b) => self.real(a) < self.real(b),
            Test::AtMost(a, b) => self.real(a) <= self.real(b),
            Test::CountLess(a, b) => self.count(a) < self.count(b),
            Test::CountEqual(a, b) => self.count(a) == self.count(b),
            Test::Finite(a) => self.real(a).is_finite(),
            Test::NotNumber(a) => self.real(a).is_nan(),
            Test::All(tests) => tests.iter().all(|test| self.test(test)),
        }
    }
}
