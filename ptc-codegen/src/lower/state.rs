//! A law that is not a sum of gains: u = kappa'^n pi0(BB_n x, t_kappa) - kappa'^n b_n^T x.

use super::builder::Builder;
use super::coefficients::Coefficient;
use super::mapping::{self, Taylor};
use super::rows::{Factor, Rows};
use super::series;
use crate::algebra::BigRational;
use crate::expansion::bell::factorials;
use crate::expression::{Expression, Variable};
use crate::internal::fault;
use crate::parameter::Parameter;
use crate::program::{Input, Op, Value};
use crate::request::Feedback;

/// u before the input gain divides it.
pub(super) fn step(b: &mut Builder<'_>) -> Value {
    let taylor = b.taylor();
    let law = law(b);
    let rows = series::drift_rows(b, &taylor);
    Rows { base: Some(Factor::Multiply(taylor.base_inverse)), rows }.step(b, Some(law))
}

/// pi0 at this state and stretched time.
pub(super) fn law(b: &mut Builder<'_>) -> Value {
    let spec = b.spec;
    let law = match &spec.feedback {
        Feedback::Expression(law) => b.scalar(law),
        Feedback::Extern => {
            // Of several outputs the law knows all, and more of time than one chain has a use for.
            let all = b.states[0].len().max(spec.n);
            let several = b.axis.filter(|_| b.outputs > 1);
            let xi = (1..=all).map(Variable::Xi);
            let times = [Variable::StretchedTime, Variable::KappaRate];
            let times = times.into_iter().take(if several.is_some() { 2 } else { 1 });
            let mut arguments: Vec<_> = xi.chain(times).map(|v| b.scalar(&v.into())).collect();
            if let Some(output) = several {
                let place = b.number(BigRational::from_integer((output - 1).into()));
                arguments.push(place);
            }
            b.push(Op::Law(arguments))
        }
        Feedback::Linear => {
            let term = |i| Expression::from(Parameter::Gain(i)).mul(Variable::Xi(i).into());
            let sum = (1..=spec.n).map(term).reduce(Expression::add);
            b.scalar(&sum.unwrap_or(Expression::integer(0)).neg())
        }
        Feedback::LeastEnergy(_) => fault("a table of gains in continuous time"),
    };
    b.name(law, "law", "pi0 at this state and stretched time")
}

/// xi = BB_n x of a chain, with names that end in `tail`.
pub(super) fn stretched_state(b: &mut Builder<'_>, tail: &str) -> Vec<Value> {
    let taylor = b.taylor();
    series::xi(b, &taylor, &|i| format!("xi{i}{tail}"))
}

impl Builder<'_> {
    /// The Taylor series of mu at the current time, or at the start, up to the order; once each.
    pub(super) fn taylor(&mut self) -> Taylor {
        let key = (self.spec.n, self.is_at_start());
        if let Some(known) = self.taylors.get(&key) {
            return known.clone();
        }
        let taylor = mapping::taylor(self);
        self.taylors.insert(key, taylor.clone());
        taylor
    }

    /// The same up to an order of at least `k`, of which there is an output.
    fn taylor_to(&mut self, k: usize) -> Taylor {
        let own = self.spec;
        self.spec = self.highest.filter(|_| k > own.n).unwrap_or(own);
        let taylor = self.taylor();
        self.spec = own;
        taylor
    }

    /// Stretched time since the start.
    pub(super) fn stretched(&mut self) -> Value {
        self.taylor().stretched
    }

    /// r_k = mu^(k) at the stretched time.
    pub(super) fn r(&mut self, k: usize) -> Value {
        let taylor = self.taylor_to(k);
        let value = match k {
            1 => taylor.r1,
            _ => {
                let factorial = factorials(k)[k].clone().into();
                let mut value = self.times(&taylor.tail[k - 2], &Coefficient::Exact(factorial));
                if let Some(unit) = taylor.unit {
                    let unit = self.power(unit, u32::try_from(k - 1).unwrap_or(u32::MAX));
                    value = self.times(&value, &Coefficient::Value(unit));
                }
                let value = self.times(&value, &Coefficient::Value(taylor.r1));
                self.coefficient(&value)
            }
        };
        self.name(value, &format!("r_{k}"), &format!("derivative {k} of mu"))
    }

    /// State xi_j of the infinite-time system; where there are several chains, j counts through all.
    pub(super) fn xi(&mut self, j: usize) -> Value {
        if self.is_of_infinite_time() {
            return self.push(Op::Input(Input::State(j)));
        }
        let index = usize::from(self.is_at_start());
        if self.states[index].is_empty() {
            let tail = if index == 1 { "_0" } else { "" };
            self.states[index] = stretched_state(self, tail);
        }
        self.states[index][j - 1]
    }

    /// State x_j of the chain, at the current time or at the start; where there is a reference, the
    /// tracking error in its place.
    pub(super) fn coordinate(&mut self, j: usize) -> Value {
        if self.is_at_start() {
            return self.push(Op::Input(Input::StateAtStart(j)));
        }
        let x = self.state(j);
        let Some(wanted) = self.reference(j - 1) else { return x };
        let error = self.sub(x, wanted);
        self.name(error, &format!("e{j}"), &format!("tracking error of x{j}"))
    }

    /// Derivative of this order, from 0, of the reference; none where it is 0.
    pub(super) fn reference(&mut self, order: usize) -> Option<Value> {
        if self.spec.references() > 0 {
            let given = match self.axis {
                Some(output) => Input::ReferenceOf(output, order),
                None => Input::Reference(order),
            };
            return Some(self.push(Op::Input(given)));
        }
        let wanted = self.spec.derivative(order)?;
        let value = self.scalar(wanted);
        // A literal is shared with whatever else is that number.
        if wanted.number().is_some() {
            return Some(value);
        }
        let rate = match order {
            0 => "the reference".to_owned(),
            order => format!("derivative {order} of the reference"),
        };
        Some(self.name(value, &format!("reference{order}"), &rate))
    }

    /// State x_j of the chain at the current time.
    fn state(&mut self, j: usize) -> Value {
        let Some(model) = &self.spec.model else {
            return self.push(Op::Input(Input::State(j)));
        };
        let meaning = format!("x{j} of the chain: {}", model.text(&model.coordinates[j - 1]));
        let value = self.chain(j);
        self.name(value, &format!("chain{j}"), &meaning)
    }

    /// Coordinate x_j of the chain of a model, in the form that is computed.
    pub(super) fn chain(&mut self, j: usize) -> Value {
        if let Some(derivative) = self.derivative(j - 1) {
            return self.coefficient(&derivative);
        }
        let own = self.form.as_ref().and_then(|form| form.coordinates.get(j - 1));
        let of_model = || self.spec.model.as_ref()?.coordinates.get(j - 1);
        match own.or_else(of_model).cloned() {
            Some(coordinate) => self.scalar(&coordinate),
            None => fault("a coordinate beyond the chain of a model"),
        }
    }

    /// State xi_j at the start, from the latched state of the plant.
    pub(super) fn xi_at_start(&mut self, j: usize) -> Value {
        self.at_start(|b| b.xi(j))
    }
}
