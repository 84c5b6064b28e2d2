//! What a step costs: its products and sums.

use std::fmt;
use std::ops::Add;

use crate::code::{Expr, Finish, Operator, Statement, Test};
use crate::request::Spec;
use crate::samples;

/// Number of operations on floating-point numbers. Comparisons and copies are not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Products and quotients.
    pub products: usize,
    /// Sums and differences.
    pub sums: usize,
}

impl Operations {
    /// Products and sums together.
    pub fn count(self) -> usize {
        self.products + self.sums
    }

    /// Returns those of the longest way through the emitted `step` of a design in samples.
    pub fn of(spec: &Spec) -> Self {
        let code = spec.sampled().map(|sampled| samples::controller(spec, sampled, Vec::new()));
        let step = code.as_ref().and_then(|code| code.function("step"));
        step.map_or_else(Self::default, |step| of_block(&step.body) + of_end(&step.finish))
    }

    fn longer(self, other: Self) -> Self {
        if other.count() > self.count() { other } else { self }
    }
}

impl Add for Operations {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { products: self.products + other.products, sums: self.sums + other.sums }
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} + {}", self.products, self.sums)
    }
}

fn of_block(statements: &[Statement]) -> Operations {
    statements.iter().map(of_statement).fold(Operations::default(), Add::add)
}

fn of_statement(statement: &Statement) -> Operations {
    match statement {
        Statement::If(test, yes, no) => of_test(test) + of_block(yes).longer(of_block(no)),
        Statement::Let(_, _, value) | Statement::Begin(_, _, value) | Statement::Set(_, value) => {
            of_value(value)
        }
        Statement::Require(test, _) => of_test(test),
        other => {
            let mut all = Operations::default();
            other.visit(&mut |value| all = all + of_operator(value));
            all
        }
    }
}

fn of_end(end: &Finish) -> Operations {
    match end {
        Finish::If(test, yes, no) => of_test(test) + of_end(yes).longer(of_end(no)),
        Finish::Give(values, _) => {
            values.iter().map(of_value).fold(Operations::default(), Add::add)
        }
        Finish::Fail(_) | Finish::Stands => Operations::default(),
    }
}

fn of_test(test: &Test) -> Operations {
    let mut all = Operations::default();
    test.visit(&mut |value| all = all + of_operator(value));
    all
}

fn of_value(value: &Expr) -> Operations {
    let mut all = Operations::default();
    value.visit(&mut |part| all = all + of_operator(part));
    all
}

/// The operation at the top of an expression.
fn of_operator(value: &Expr) -> Operations {
    match value {
        Expr::Binary(Operator::Add | Operator::Sub, ..) => Operations { products: 0, sums: 1 },
        Expr::Binary(Operator::Mul | Operator::Div, ..)
        | Expr::Quotient(..)
        | Expr::Pow(..)
        | Expr::Call(..) => Operations { products: 1, sums: 0 },
        Expr::Fused(_) => Operations { products: 1, sums: 1 },
        _ => Operations::default(),
    }
}
