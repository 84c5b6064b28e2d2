//! The reference at a sample: the tracking error in place of the state, and r^(n) beside the law.
//!
//! With e_i = x_i - r^(i-1) the chain is e_n' = f + g (u + d) - r^(n). The exact law in samples of e says what is
//! wanted of it, where each input counts less rho, which stands for r^(n) over the time in which the input acts.
//! What r^(n) differs from rho there is left: in a sample it moves e_i by its integral against
//! (time left)^(n-i)/(n-i)!. Of a known reference rho is r^(n) in the middle of that time, so that the integral of
//! r^(n+1) (t - middle) is 0 in e_n, and O(h^(n+2-i)) in e_i. What is left of e_n is O(h^3), where r^(n) at the
//! beginning of the time would leave O(h^2).

use std::ops::{Mul, Sub};

use super::controller::Builder;
use super::staged::{Names, Staged};
use crate::algebra::integer;
use crate::code::{Expr, Place, Shape, Statement, Variable};
use crate::lower::reference_at_sample;
use crate::parameter::Parameter;
use crate::request::Reference;

impl Builder<'_> {
    /// What a call is given of the reference, where it is.
    pub(super) fn reference(&self) -> Option<Variable> {
        let count = Some(self.spec.references()).filter(|count| *count > 0)?;
        let about = format!(
            "reference and its derivatives at tick `k`, up to that of order {}; the last one is that of order {} over the sample in which u acts: its mean, or that in the middle",
            count - 2,
            count - 1
        );
        Some(Variable::new("r", Shape::Reals(count), about))
    }

    /// The numbers of the reference that a call is given.
    pub(super) fn given_reference(&self) -> impl Iterator<Item = Expr> + use<> {
        (0..self.spec.references()).map(|j| Expr::Element("r".to_owned(), j))
    }

    /// State j, from 1, of the chain that the law brings to 0.
    pub(super) fn coordinate(&self, j: usize) -> Expr {
        let letter = if self.spec.reference.is_some() { "e" } else { "x" };
        Expr::local(self.named(&format!("{letter}{j}")))
    }

    /// rho of the input of `age` samples ago, 0 for that of now, as an input.
    pub(super) fn rate(&self, age: usize) -> Expr {
        match self.rates.get(age) {
            Some(rate) => Expr::Number(integer(1) / &self.sampled.gain).mul(rate.clone()),
            None => Expr::integer(0),
        }
    }

    /// Statements that set e1..en from x1..xn and the reference, which give [`rate`](Self::rate) its values.
    pub(super) fn follow(&mut self) -> Vec<Statement> {
        let inputs = self.sampled.delay.inputs();
        let (mut body, wanted) = match self.spec.reference {
            None => return Vec::new(),
            Some(Reference::Input) => {
                for age in 1..=inputs {
                    let about = format!("last one of r, {age} samples ago");
                    self.remember(&format!("rho{age}"), &about);
                }
                let mut given: Vec<_> = self.given_reference().collect();
                let wanted = given.drain(..self.spec.n).collect();
                let under_way = (1..=inputs).map(|age| Expr::field(format!("rho{age}")));
                self.rates = given.into_iter().chain(under_way).collect();
                (Vec::new(), wanted)
            }
            Some(Reference::Known(_)) => self.known_reference(),
        };
        body.insert(0, Statement::Note("The tracking error.".to_owned()));
        for (wanted, j) in wanted.into_iter().zip(1..) {
            let error = Expr::local(format!("x{j}")).sub(wanted);
            body.push(Statement::Let(format!("e{j}"), Shape::Real, error));
        }
        body
    }

    /// Statements before the values of a known reference, and r, r', ...
    fn known_reference(&mut self) -> (Vec<Statement>, Vec<Expr>) {
        let h = self.parameter(Parameter::SampleTime);
        let h = self.keep(Parameter::SampleTime.key(), Parameter::SampleTime.meaning(), h);
        let time = Expr::local("elapsed").real().mul(h);
        let of_time = (0..self.spec.n).map(|order| format!("reference{order}"));
        let names = of_time.chain((0..=self.sampled.delay.inputs()).map(|age| format!("rho{age}")));
        let program = reference_at_sample(self.spec, self.sampled);
        let names = Names { watched: names.collect(), wanted: Vec::new(), letters: ["c_r", "v_r"] };
        let (mut body, values) = Staged::new(program, names).watched(self);
        let mut values: Vec<_> = values.into_iter().map(|(_, value)| value).collect();
        if values.iter().any(|value| !value.is_constant()) {
            body.insert(0, Statement::Let("t".to_owned(), Shape::Real, time));
        }
        self.rates = values.split_off(self.spec.n);
        (body, values)
    }

    /// rho of the inputs under way, where each call is given it, is a sample older.
    pub(super) fn shift_rates(&self) -> Vec<Statement> {
        if self.spec.references() == 0 {
            return Vec::new();
        }
        let set = |age: usize| {
            Statement::Set(Place::Field(format!("rho{age}")), self.rates[age - 1].clone())
        };
        (1..self.rates.len()).rev().map(set).collect()
    }
}
