//! The reference at a sample: the tracking error in place of the state, and r^(n) beside the law.
//!
//! With e_i = x_i - r^(i-1) the chain is e_n' = f + g (u + d) - r^(n). The exact law in samples of e says what is
//! wanted of it, where each input counts less rho, which stands for r^(n) over the time in which the input acts.
//! What r^(n) differs from rho there is left: in a sample it moves e_i by its integral against
//! (time left)^(n-i)/(n-i)!. Of a known reference rho is r^(n) in the middle of that time, so that the integral of
//! r^(n+1) (t - middle) is 0 in e_n, and O(h^(n+2-i)) in e_i. What is left of e_n is O(h^3), where r^(n) at the
//! beginning of the time would leave O(h^2).
//!
//! Of a linear plant the states on the reference are in place of r, ..., r^(n-1), and its input there of r^(n).

use std::ops::{Mul, Sub};

use super::controller::Builder;
use super::predicted::weighted;
use super::staged::{Names, Staged};
use crate::algebra::{BigRational, integer};
use crate::code::{Cell, Expr, Index, Place, Shape, Statement, Variable};
use crate::lower::reference_at_sample;
use crate::parameter::Parameter;
use crate::request::{Reference, Spec};

impl Builder<'_> {
    /// Returns the reference argument of a call, if it has one.
    pub(super) fn reference(&self) -> Option<Variable> {
        let count = Some(self.spec.references()).filter(|count| *count > 0)?;
        if self.designs.is_empty() {
            let about = format!(
                "reference and its derivatives at tick `k`, up to that of order {}; the last one is that of order {} over the sample in which u acts: its mean, or that in the middle",
                count - 2,
                count - 1
            );
            return Some(Variable::new("r", Shape::Reals(count), about));
        }
        let orders: Vec<_> = self.designs.iter().map(|own| own.n.to_string()).collect();
        let each = if self.spec.decoupled().is_some() { "output" } else { "axis" };
        let about = format!(
            "for each {each} its reference and the derivatives at tick `k`, and behind them, in the place of its order, {}, that of this order over the sample in which u acts: its mean, or that in the middle",
            orders.join(", ")
        );
        Some(Variable::new("r", Shape::Lists(orders.len(), count), about))
    }

    /// Returns the elements of the reference of each output that a call is given and reads: up to that of its order.
    pub(super) fn given_references(&self) -> Vec<Vec<Expr>> {
        let columns = self.spec.references();
        let r = || "r".to_owned();
        let of_row = |(row, own): (usize, &Spec)| {
            let cell = |column| Cell { row: Index::at(row), column, columns };
            (0..=own.n).map(|column| Expr::Entry(r(), cell(column))).collect()
        };
        match self.designs {
            _ if columns == 0 => Vec::new(),
            [] => vec![(0..columns).map(|j| Expr::Element(r(), j)).collect()],
            all => all.iter().enumerate().map(of_row).collect(),
        }
    }

    /// State j, from 1, of the chain that the law brings to 0.
    pub(super) fn coordinate(&self, j: usize) -> Expr {
        let letter = if self.spec.reference.is_some() { "e" } else { "x" };
        Expr::local(self.named(&format!("{letter}{j}")))
    }

    /// rho of the input of `age` samples ago, 0 for that of now, as an input.
    pub(super) fn rate(&self, age: usize) -> Expr {
        let output = self.output.map_or(0, |output| output - 1);
        match self.rates.get(output).and_then(|rates| rates.get(age)) {
            Some(rate) => Expr::Number(integer(1) / &self.sampled.gain).mul(rate.clone()),
            None => Expr::integer(0),
        }
    }

    /// Statements that set e1..en of each output from x1..xn and its reference, which give [`rate`](Self::rate)
    /// its values.
    pub(super) fn follow(&mut self) -> Vec<Statement> {
        let (mut body, wanted) = match self.spec.reference {
            None => return Vec::new(),
            Some(Reference::Input) => self.remembered_references(),
            Some(Reference::Known(_)) => self.known_references(),
        };
        body.insert(0, Statement::Note("The tracking error.".to_owned()));
        let orders = self.orders();
        for ((mut wanted, n), output) in wanted.into_iter().zip(orders).zip(1..) {
            self.rates.push(wanted.split_off(n));
            for (wanted, j) in wanted.into_iter().zip(1..) {
                let error = Expr::local(self.of_output(&format!("x{j}"), output)).sub(wanted);
                let name = self.of_output(&format!("e{j}"), output);
                body.push(Statement::Let(name, Shape::Real, error));
            }
        }
        body
    }

    /// The order of each output, or of the only one.
    fn orders(&self) -> Vec<usize> {
        match self.designs {
            [] => vec![self.spec.n],
            all => all.iter().map(|own| own.n).collect(),
        }
    }

    /// The name of a value of an output, from 1.
    fn of_output(&self, name: &str, output: usize) -> String {
        match self.designs {
            [] => name.to_owned(),
            _ => format!("{name}_{output}"),
        }
    }

    /// Statements before what a call is given of each reference, and this with rho of the inputs under way.
    fn remembered_references(&mut self) -> (Vec<Statement>, Vec<Vec<Expr>>) {
        let mut given = self.given_references();
        let mut body = Vec::new();
        let mut last = "last one of r";
        if let Some((rows, given)) = self.on_given_reference().zip(given.first_mut()) {
            let followed = rows.iter().map(|row| weighted(row, &|l| given[l].clone()));
            let mut followed: Vec<_> = followed.collect();
            if let Some(input) = followed.last_mut() {
                let mean = std::mem::replace(input, Expr::local("u_r"));
                body.push(Statement::Let("u_r".to_owned(), Shape::Real, mean));
            }
            *given = followed;
            last = "input on the reference";
        }
        // Several inputs are not late.
        let inputs = self.sampled.delay.inputs();
        let [_, letter] = self.sampled.followed_letters();
        for age in 1..=inputs {
            self.remember(&format!("{letter}{age}"), &format!("{last}, {age} samples ago"));
        }
        let under_way = (1..=inputs).map(|age| Expr::field(format!("{letter}{age}")));
        given.iter_mut().take(1).for_each(|first| first.extend(under_way.clone()));
        (body, given)
    }

    /// The states of a linear plant on the reference and the mean of its input there while that of this sample acts,
    /// over what a call is given of the reference.
    fn on_given_reference(&self) -> Option<Vec<Vec<BigRational>>> {
        let follows = self.sampled.follows.as_ref()?;
        let begin = self.sampled.middles().next()? - BigRational::new(1.into(), 2.into());
        Some(follows.mean(self.fixed(Parameter::SampleTime)?, &begin))
    }

    /// Statements before the values of known references, and r, r', ..., rho of each.
    fn known_references(&mut self) -> (Vec<Statement>, Vec<Vec<Expr>>) {
        let h = self.parameter(Parameter::SampleTime);
        let h = self.keep(Parameter::SampleTime.key(), Parameter::SampleTime.meaning(), h);
        let time = Expr::local("elapsed").real().mul(h);
        let (orders, inputs) = (self.orders(), self.sampled.delay.inputs());
        let mut watched = Vec::new();
        for (n, output) in orders.iter().zip(1..) {
            let [of_state, of_input] = self.sampled.followed_letters();
            let first = usize::from(self.sampled.follows.is_some());
            let of_time = (first..n + first).map(|order| format!("{of_state}{order}"));
            let names = of_time.chain((0..=inputs).map(|age| format!("{of_input}{age}")));
            watched.extend(names.map(|name| self.of_output(&name, output)));
        }
        let program = reference_at_sample(self.spec, self.sampled);
        let names = Names { watched, wanted: Vec::new(), letters: ["c_r", "v_r"] };
        let (mut body, values) = Staged::new(program, names).watched(self);
        let values: Vec<_> = values.into_iter().map(|(_, value)| value).collect();
        if values.iter().any(|value| !value.is_constant()) {
            body.insert(0, Statement::Let("t".to_owned(), Shape::Real, time));
        }
        let mut values = values.into_iter();
        let each = orders.iter().map(|n| values.by_ref().take(n + inputs + 1).collect()).collect();
        (body, each)
    }

    /// rho of the inputs under way, where each call is given it, is a sample older.
    pub(super) fn shift_rates(&self) -> Vec<Statement> {
        let Some(rates) = self.rates.first().filter(|_| self.spec.references() > 0) else {
            return Vec::new();
        };
        let [_, letter] = self.sampled.followed_letters();
        let field = |age: usize| Place::Field(format!("{letter}{age}"));
        let set = |age: usize| Statement::Set(field(age), rates[age - 1].clone());
        (1..rates.len()).rev().map(set).collect()
    }
}
