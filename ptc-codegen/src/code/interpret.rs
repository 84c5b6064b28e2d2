//! The interpreter: whole controllers, in the operations and the precision of the emitted code.

use std::collections::BTreeMap;

use super::{
    Access, Code, Expr, Given, Operator, Outcomes, Place, Shape, Statement, Status, Test, Variable,
};
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::number;

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
}

/// What a call gave: its status, and its results, none of them where it failed.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Its status.
    pub status: Status,
    /// Its results by name.
    pub results: BTreeMap<String, Vec<f64>>,
}

/// The names that one call knows.
struct Frame<'a, 'b> {
    precision: Precision,
    fields: &'b mut BTreeMap<&'a str, Held>,
    parameters: BTreeMap<&'b str, Held>,
    locals: BTreeMap<&'b str, Held>,
}

impl<'a> Instance<'a> {
    /// The controller that `init` makes of the parameters, each a list of numbers; counts are given
    /// as numbers.
    ///
    /// # Errors
    /// The status with which `init` fails.
    pub fn new(code: &'a Code, parameters: &[Argument<'_>]) -> Result<Self, Status> {
        let mut fields: BTreeMap<&str, Held> = code
            .fields
            .iter()
            .map(|field| (field.name.as_str(), held(field, &[f64::NAN], code.precision)))
            .collect();
        let mut frame = Frame {
            precision: code.precision,
            fields: &mut fields,
            parameters: bound(&code.parameters, parameters, code.precision),
            locals: BTreeMap::new(),
        };
        match frame.block(&code.init) {
            Some(status) => Err(status),
            None => Ok(Self { code, fields }),
        }
    }

    /// Calls a function with its arguments.
    pub fn call(&mut self, name: &str, arguments: &[Argument<'_>]) -> Outcome {
        let Some(function) = self.code.function(name) else { fault(format!("no function {name}")) };
        let mut changed = self.fields.clone();
        let mut frame = Frame {
            precision: self.code.precision,
            fields: &mut changed,
            parameters: BTreeMap::new(),
            locals: bound(&function.arguments, arguments, self.code.precision),
        };
        if let Some(status) = frame.block(&function.body) {
            return Outcome { status, results: BTreeMap::new() };
        }
        let status = match &function.status {
            Outcomes::One(status) => *status,
            Outcomes::First(ways, last) => {
                ways.iter().find(|(test, _)| frame.test(test)).map_or(*last, |(_, status)| *status)
            }
        };
        let values = |given: &Given| given.values.iter().map(|value| frame.real(value)).collect();
        let results = function.results.iter();
        let given = results.map(|given| (given.variable.name.clone(), values(given))).collect();
        if function.access == Access::Change {
            self.fields = changed;
        }
        Outcome { status, results: given }
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
                    self.locals.insert(name, value);
                }
                Statement::Set(Place::Local(name), value) => {
                    let value = Held::Real(self.real(value));
                    self.locals.insert(name, value);
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
                Statement::Require(..) | Statement::Variable(..) | Statement::Note(_) => {}
            }
        }
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
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.real(a), self.real(b));
                round(match operator {
                    Operator::Add => a + b,
                    Operator::Sub => a - b,
                    Operator::Mul => a * b,
                    Operator::Div => a / b,
                })
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
            Test::All(tests) => tests.iter().all(|test| self.test(test)),
        }
    }
}
