//! Arithmetic that writes a staged program: numbers that are known are folded, zeros and ones leave no operation.

use std::collections::HashMap;

use num_traits::{One, Signed, Zero};

use crate::algebra::{BigRational, integer};
use crate::expression::Function;
use crate::parameter::Precision;
use crate::program::passes::append;
use crate::program::{Input, Op, Program, Value};

/// A number of a program that is being written.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Term {
    /// A number that is known.
    Known(BigRational),
    /// A value of the program, or its opposite.
    Value {
        /// True for the opposite.
        negative: bool,
        /// The value.
        value: Value,
    },
}

impl Term {
    /// Zero.
    pub(super) fn zero() -> Self {
        Self::Known(BigRational::zero())
    }

    /// Returns true if it is known to be 0.
    pub(super) fn is_zero(&self) -> bool {
        matches!(self, Self::Known(number) if number.is_zero())
    }
}

impl From<&BigRational> for Term {
    fn from(number: &BigRational) -> Self {
        Self::Known(number.clone())
    }
}

impl std::ops::Neg for Term {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            Self::Known(number) => Self::Known(-number),
            Self::Value { negative, value } => Self::Value { negative: !negative, value },
        }
    }
}

/// A program under construction. An operation that stands already is not written again.
pub(super) struct Tape {
    program: Program,
    written: HashMap<Op, Value>,
}

impl Tape {
    pub(super) fn new(precision: Precision, fma: bool) -> Self {
        let program = Program { fma, ..Program::empty(precision) };
        let mut tape = Self { program, written: HashMap::new() };
        // The roles of a controller, which a robot does not have, are 0.
        tape.write(Op::Number(BigRational::zero()));
        tape
    }

    fn write(&mut self, op: Op) -> Value {
        if let Some(value) = self.written.get(&op) {
            return *value;
        }
        let value = append(&mut self.program, op.clone(), None);
        self.written.insert(op, value);
        value
    }

    /// The program of these results.
    pub(super) fn finish(mut self, results: &[Term]) -> Program {
        let values = results.iter().map(|result| self.value(result)).collect();
        Program { watched: values, ..self.program }
    }

    /// A term as a value.
    fn value(&mut self, term: &Term) -> Value {
        match term {
            Term::Known(number) => self.write(Op::Number(number.clone())),
            Term::Value { negative: false, value } => *value,
            Term::Value { negative: true, value } => self.write(Op::Neg(*value)),
        }
    }

    fn term(&mut self, op: Op) -> Term {
        Term::Value { negative: false, value: self.write(op) }
    }

    pub(super) fn input(&mut self, input: Input) -> Term {
        self.term(Op::Input(input))
    }

    pub(super) fn call(&mut self, function: Function, term: &Term) -> Term {
        let value = self.value(term);
        self.term(Op::Call(function, value))
    }

    /// a + b.
    pub(super) fn add(&mut self, a: &Term, b: &Term) -> Term {
        match (a, b) {
            (Term::Known(a), Term::Known(b)) => Term::Known(a + b),
            (zero, other) | (other, zero) if zero.is_zero() => other.clone(),
            (
                Term::Value { negative: true, value: x },
                Term::Value { negative: true, value: y },
            ) => -self.sum(*x, *y),
            (Term::Value { negative: true, value }, other) => {
                let (a, b) = (self.value(other), *value);
                self.difference(a, b)
            }
            (other, Term::Value { negative: true, value }) => {
                let (a, b) = (self.value(other), *value);
                self.difference(a, b)
            }
            (a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.sum(a, b)
            }
        }
    }

    fn sum(&mut self, a: Value, b: Value) -> Term {
        self.term(Op::Add(a.min(b), a.max(b)))
    }

    /// a - b, or the opposite of b - a where that stands already.
    fn difference(&mut self, a: Value, b: Value) -> Term {
        if a == b {
            return Term::zero();
        }
        match self.written.get(&Op::Sub(b, a)) {
            Some(value) => Term::Value { negative: true, value: *value },
            None => self.term(Op::Sub(a, b)),
        }
    }

    /// a - b.
    pub(super) fn sub(&mut self, a: &Term, b: &Term) -> Term {
        self.add(a, &-b.clone())
    }

    /// a b.
    pub(super) fn mul(&mut self, a: &Term, b: &Term) -> Term {
        match (a, b) {
            (Term::Known(a), Term::Known(b)) => Term::Known(a * b),
            (Term::Known(number), other) | (other, Term::Known(number)) => {
                self.scaled(number, other)
            }
            (
                Term::Value { negative: first, value: a },
                Term::Value { negative: second, value: b },
            ) => {
                let value = self.write(Op::Mul(*a.min(b), *a.max(b)));
                Term::Value { negative: first != second, value }
            }
        }
    }

    fn scaled(&mut self, number: &BigRational, other: &Term) -> Term {
        if number.is_zero() {
            return Term::zero();
        }
        if number.is_negative() {
            return -self.scaled(&-number, other);
        }
        if number.is_one() {
            return other.clone();
        }
        let Term::Value { negative, value } = other else {
            return self.mul(other, &Term::from(number));
        };
        let number = self.write(Op::Number(number.clone()));
        let value = self.write(Op::Mul(number, *value));
        Term::Value { negative: *negative, value }
    }

    /// a / b, where b is not 0.
    pub(super) fn quotient(&mut self, a: &Term, b: &Term) -> Term {
        let (a, b) = (self.value(a), self.value(b));
        self.term(Op::Div(a, b))
    }

    /// 2 a.
    pub(super) fn twice(&mut self, a: &Term) -> Term {
        self.mul(&Term::Known(integer(2)), a)
    }

    /// The sum of products.
    pub(super) fn products(&mut self, all: &[(&Term, &Term)]) -> Term {
        let mut sum = Term::zero();
        for (a, b) in all {
            let product = self.mul(a, b);
            sum = self.add(&sum, &product);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Input;

    #[test]
    fn zeros_ones_and_signs_leave_no_operation() {
        let mut tape = Tape::new(Precision::F64, false);
        let [x, y] = [1, 2].map(|j| tape.input(Input::State(j)));
        let one = Term::Known(integer(1));
        assert_eq!(tape.mul(&one, &x), x);
        assert_eq!(tape.mul(&Term::zero(), &x), Term::zero());
        assert_eq!(tape.add(&x, &Term::zero()), x);
        assert_eq!(tape.mul(&-one, &x), -x.clone());
        assert_eq!(tape.sub(&x, &x), Term::zero());
        let product = tape.mul(&x, &y);
        assert_eq!(tape.mul(&-y.clone(), &x), -product);
        let difference = tape.sub(&x, &y);
        assert_eq!(tape.sub(&y, &x), -difference);
        // Zero, two inputs, a product, a difference.
        assert_eq!(tape.program.values.len(), 5);
    }
}
