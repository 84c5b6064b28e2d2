//! The parameters, and `init`: their tests, the fields, and the tests of these.

use super::controller::Builder;
use crate::algebra::{BigRational, integer};
use crate::code::{Expr, Place, Shape, Statement, Status, Test, Variable, limits_in_order};
use crate::internal::fault;
use crate::parameter::Parameter;
use crate::program::digits::least;

impl Builder<'_> {
    /// The parameters left to run time.
    pub(super) fn parameters(&self) -> Vec<Variable> {
        let mut variables: Vec<Variable> = Vec::new();
        for parameter in self.spec.run_time_parameters() {
            let domain = match parameter {
                Parameter::Samples => {
                    format!("at least {}", self.sampled.least_samples(self.spec.highest_order()))
                }
                parameter => self.spec.legal(parameter),
            };
            let unit = self.spec.unit(parameter);
            let about = format!("{} [{unit}], {domain}", self.spec.meaning(parameter));
            let shape = match parameter {
                Parameter::Samples => Shape::Count,
                Parameter::Gain(_) => Shape::Reals(self.spec.loop_order()),
                _ => Shape::Real,
            };
            if variables.last().is_none_or(|last| last.name != parameter.key()) {
                variables.push(Variable::new(parameter.key(), shape, about));
            }
        }
        variables
    }

    /// `init`: tests of the parameters, the fields, tests of these.
    pub(super) fn init(&self) -> Vec<Statement> {
        let mut tests: Vec<Test> = Vec::new();
        let zero = Expr::integer(0);
        for parameter in self.spec.run_time_parameters() {
            let value = self.parameter(parameter);
            match parameter {
                Parameter::Samples => {
                    let least = self.sampled.least_samples(self.spec.highest_order());
                    tests.push(Test::CountLess(Expr::Count(least - 1), value));
                }
                Parameter::SampleTime | Parameter::A => {
                    let (least, greatest) = self.spec.ends(parameter).unwrap_or((0.0, f64::MAX));
                    tests.push(Test::AtMost(number(least), value.clone()));
                    tests.push(Test::AtMost(value, number(greatest)));
                }
                Parameter::UMax if !self.spec.u_min => tests.push(Test::Less(zero.clone(), value)),
                Parameter::UMax | Parameter::UMin => {}
                Parameter::Deadbeat => {
                    tests.push(Test::Finite(value.clone()));
                    tests.push(Test::AtMost(zero.clone(), value));
                }
                parameter => {
                    match self.spec.bounds.get(&parameter).map(|(l, g)| (l.number(), g.number())) {
                        Some((Some(least), Some(greatest))) => {
                            tests.push(Test::AtMost(Expr::Number(least.clone()), value.clone()));
                            tests.push(Test::AtMost(value, Expr::Number(greatest.clone())));
                        }
                        _ => tests.push(Test::Finite(value)),
                    }
                }
            }
        }
        let of = |parameter| self.parameter(parameter);
        tests.extend(limits_in_order(self.spec, &of));
        let mut body = Vec::new();
        if !tests.is_empty() {
            body.push(Statement::Require(Test::All(tests), Status::Param));
        }
        let mut finite = Vec::new();
        for (name, shape, value) in &self.values {
            if value.number().is_none() && !matches!(value, Expr::Count(_)) {
                body.push(Statement::Let(name.clone(), *shape, value.local_fields()));
                let given = matches!(value, Expr::Parameter(_));
                if *shape == Shape::Real && !given {
                    finite.push(Test::Finite(Expr::local(name.clone())));
                }
            }
        }
        // The weights hold the period in powers up to the order, of either sign: one that is too large
        // is not finite, one that is too small shows by its power alone.
        if self.fixed(Parameter::SampleTime).is_none() {
            let order = i64::try_from(self.spec.highest_order()).unwrap_or(i64::MAX);
            for power in [order, -order] {
                finite.push(Test::AtMost(number(least(self.spec.precision)), self.period(power)));
            }
        }
        // Below this the gains of the observer do not exist.
        if self.fields.iter().any(|field| field.name == "hold_o") {
            let order = self.round().map_or(0, |round| round.poles.len());
            let least = integer(i64::try_from(order).unwrap_or(0));
            finite.push(Test::AtMost(Expr::Number(least), Expr::local("hold_o")));
        }
        if !finite.is_empty() {
            body.push(Statement::Require(Test::All(finite), Status::Param));
        }
        for (name, _, value) in &self.values {
            let value = match value {
                Expr::Number(_) | Expr::Count(_) => value.clone(),
                _ => Expr::local(name.clone()),
            };
            body.push(Statement::Set(Place::Field(name.clone()), value));
        }
        body
    }
}

/// A finite number.
fn number(value: f64) -> Expr {
    match BigRational::from_float(value) {
        Some(exact) => Expr::Number(exact),
        None => fault("a bound that is not finite"),
    }
}
