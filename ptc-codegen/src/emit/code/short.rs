//! Short lines: parts of a long value get names of their own. Each operation stays what it is, in the
//! order it has, so that no bit changes.

use std::collections::{BTreeMap, BTreeSet};

use super::block::declared;
use crate::code::{Code, Expr, Operator, Shape, Statement, Test};
use crate::parameter::Precision;
use crate::program::number;

/// Longest value, in characters of a plain notation.
const WIDTH: usize = 56;

/// The same program in short lines.
pub(in crate::emit) fn short(mut code: Code) -> Code {
    let precision = code.precision;
    code.init = Short::new(precision, &code.init).block(std::mem::take(&mut code.init));
    for function in &mut code.functions {
        let body = std::mem::take(&mut function.body);
        let mut short = Short::new(precision, &body);
        short.used.extend(function.arguments.iter().map(|argument| argument.name.clone()));
        function.body = short.block(body);
        if let Some(values) = function.finish.results() {
            let mut values = values.to_vec();
            short.each(&mut values, &mut function.body);
            function.finish.give_all(&values);
        }
    }
    code
}

struct Short {
    precision: Precision,
    used: BTreeSet<String>,
    count: usize,
}

impl Short {
    fn new(precision: Precision, body: &[Statement]) -> Self {
        let mut locals = BTreeMap::new();
        declared(body, &mut locals);
        Self { precision, used: locals.into_keys().collect(), count: 0 }
    }

    fn block(&mut self, statements: Vec<Statement>) -> Vec<Statement> {
        let mut out = Vec::new();
        for statement in statements {
            let statement = match statement {
                Statement::Let(name, shape, value) => {
                    Statement::Let(name, shape, self.whole(value, &mut out))
                }
                Statement::Set(place, value) => Statement::Set(place, self.whole(value, &mut out)),
                Statement::Begin(name, shape, value) => {
                    Statement::Begin(name, shape, self.whole(value, &mut out))
                }
                Statement::For(mut each) => {
                    each.body = self.block(each.body);
                    Statement::For(each)
                }
                Statement::Array(name, mut values) => {
                    self.each(&mut values, &mut out);
                    Statement::Array(name, values)
                }
                Statement::Apply { name, subroutine, body, mut given } => {
                    // In the order in which they were computed.
                    given.iter_mut().rev().for_each(|values| self.each(values, &mut out));
                    Statement::Apply { name, subroutine, body, given }
                }
                Statement::Call { name, callback, array, mut times, count } => {
                    self.each(&mut times, &mut out);
                    Statement::Call { name, callback, array, times, count }
                }
                Statement::If(test, yes, no) => {
                    let (yes, no) = (self.block(yes), self.block(no));
                    Statement::If(test, yes, no)
                }
                other => other,
            };
            out.push(statement);
        }
        out
    }

    fn each(&mut self, values: &mut [Expr], out: &mut Vec<Statement>) {
        for value in values {
            let long = std::mem::replace(value, Expr::integer(0));
            *value = self.operand(long, out);
        }
    }

    /// A value that is assigned; a choice may be all of it, but no part of an operation.
    fn whole(&mut self, value: Expr, out: &mut Vec<Statement>) -> Expr {
        match value {
            Expr::Choose(mut test, yes, no) => {
                let [yes, no] = [yes, no].map(|branch| {
                    let short = self.operand((*branch).clone(), out);
                    let short = match short {
                        Expr::Binary(..) => self.named(short, out),
                        short => short,
                    };
                    if let Test::Less(a, b) | Test::AtMost(a, b) = &mut *test {
                        for side in [a, b].into_iter().filter(|side| **side == *branch) {
                            *side = short.clone();
                        }
                    }
                    Box::new(short)
                });
                Expr::Choose(test, yes, no)
            }
            value => self.value(value, out),
        }
    }

    fn operand(&mut self, value: Expr, out: &mut Vec<Statement>) -> Expr {
        let value = self.whole(value, out);
        if matches!(value, Expr::Choose(..)) { self.named(value, out) } else { value }
    }

    fn value(&mut self, value: Expr, out: &mut Vec<Statement>) -> Expr {
        match value {
            Expr::Neg(a) => Expr::Neg(Box::new(self.operand(*a, out))),
            Expr::Binary(operator, a, b) => {
                let (mut a, mut b) = (self.operand(*a, out), self.operand(*b, out));
                for _ in 0..2 {
                    if self.width(&a) + self.width(&b) <= WIDTH {
                        break;
                    }
                    let long = if self.width(&a) < self.width(&b) { &mut b } else { &mut a };
                    let part = std::mem::replace(long, Expr::integer(0));
                    *long = self.named(part, out);
                }
                Expr::Binary(operator, Box::new(a), Box::new(b))
            }
            Expr::Fused(operands) => {
                let mut operands = operands.map(|operand| self.operand(operand, out));
                for _ in 0..operands.len() {
                    let widths = operands.each_ref().map(|operand| self.width(operand));
                    if widths.iter().sum::<usize>() <= WIDTH {
                        break;
                    }
                    let longest = (0..widths.len()).max_by_key(|i| widths[*i]).unwrap_or(0);
                    let part = std::mem::replace(&mut operands[longest], Expr::integer(0));
                    operands[longest] = self.named(part, out);
                }
                Expr::Fused(Box::new(operands))
            }
            Expr::Call(function, a) => Expr::Call(function, Box::new(self.operand(*a, out))),
            Expr::Pow(a, b) => {
                let [a, b] = [a, b].map(|side| Box::new(self.operand(*side, out)));
                Expr::Pow(a, b)
            }
            // Its divisor is written several times.
            Expr::Quotient(a, b) => {
                let (a, b) = (self.operand(*a, out), self.operand(*b, out));
                let b = if self.width(&b) > 12 { self.named(b, out) } else { b };
                Expr::Quotient(Box::new(a), Box::new(b))
            }
            other => other,
        }
    }

    fn named(&mut self, value: Expr, out: &mut Vec<Statement>) -> Expr {
        let name = loop {
            self.count += 1;
            let name = format!("s{}", self.count);
            if self.used.insert(name.clone()) {
                break name;
            }
        };
        out.push(Statement::Let(name.clone(), Shape::Real, value));
        Expr::Local(name)
    }

    fn width(&self, value: &Expr) -> usize {
        match value {
            Expr::Number(value) => {
                number::literal(number::round(value, self.precision), self.precision).len()
            }
            Expr::Constant(own) => own.name.len() + 8,
            Expr::Count(_) => 5,
            Expr::Local(name) => name.len(),
            Expr::Element(name, _) => name.len() + 3,
            Expr::Field(name) | Expr::Entry(name, _) => name.len() + 6,
            Expr::FieldElement(name, _) => name.len() + 9,
            Expr::OfAxis(name, ..) => name.len() + 20,
            Expr::Call(function, a) => function.name().len() + self.width(a) + 2,
            Expr::Fused(operands) => {
                operands.iter().map(|operand| self.width(operand)).sum::<usize>() + 19
            }
            Expr::Pow(a, b) => self.width(a) + self.width(b) + 7,
            Expr::Quotient(a, b) => self.width(a) + 3 * self.width(b) + 30,
            Expr::Callback(name, array, time) => name.len() + array.len() + self.width(time) + 13,
            Expr::Parameter(name) => name.len() + 8,
            Expr::ParameterElement(name, _) => name.len() + 11,
            Expr::At(name, _) => name.len() + 12,
            Expr::Divisor(a) => 3 * self.width(a) + 27,
            Expr::Neg(a) | Expr::CountOver(a, _) => self.width(a) + 4,
            Expr::CountAdd(a, b) => self.width(a) + self.width(b) + 3,
            Expr::Tabulated(name, row, _) => name.len() + self.width(row) + 10,
            Expr::Real(a) => self.width(a) + 8,
            Expr::Binary(operator, a, b) => {
                let brackets = match operator {
                    Operator::Add | Operator::Sub => 0,
                    Operator::Mul | Operator::Div => [a, b]
                        .iter()
                        .filter(|side| {
                            matches!(****side, Expr::Binary(Operator::Add | Operator::Sub, ..))
                        })
                        .count(),
                };
                self.width(a) + self.width(b) + 3 + 2 * brackets
            }
            Expr::CountSub(a, b) | Expr::CountLeft(a, b) => self.width(a) + self.width(b) + 20,
            Expr::Choose(_, a, b) => self.width(a) + self.width(b) + 20,
        }
    }
}
