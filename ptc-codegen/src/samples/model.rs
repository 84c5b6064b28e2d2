//! A model that is not linear, or has several inputs, at a sample: the chain x1..xn of each output before the
//! law, and u after it.
//!
//! The law is exact for a chain that w moves. With u = (w - f)/g of the states at a sample the last rate of the
//! chain is w there, and w + (f + g u) - (f + g u at the sample) behind it: what is not held moves x_i by
//! O(h^(n+2-i)) in a sample. Of several outputs g is the decoupling matrix.

use std::collections::{BTreeMap, BTreeSet};

use super::controller::Builder;
use crate::code::{Expr, Shape, Statement, parameter_name};
use crate::internal::fault;
use crate::lower::at_sample;
use crate::program::{Input, Op, Program, Stage, Value, passes};

/// What is computed of the model so far.
pub(super) struct AtSample {
    program: Program,
    /// Users of each value.
    uses: BTreeMap<Value, usize>,
    known: BTreeMap<Value, Expr>,
    /// All that has been known, given away or not.
    done: BTreeSet<Value>,
    /// Names of the coordinates of the chains, one output after the other.
    coordinates: Vec<String>,
    /// Names of what the law of each output wants.
    wanted: Vec<String>,
    /// How many have a name of their own.
    named: usize,
}

impl AtSample {
    /// Of the model of the builder's spec.
    pub(super) fn new(builder: &Builder<'_>) -> Self {
        let program = passes::optimise(at_sample(builder.spec), &mut |_, _| {});
        let mut uses: BTreeMap<_, usize> = BTreeMap::new();
        let roots = [program.watched.clone(), program.controls()].concat();
        roots.iter().for_each(|root| *uses.entry(*root).or_default() += 1);
        for value in program.needed(&roots) {
            let op = &program.get(value).op;
            for operand in op.operands() {
                *uses.entry(operand).or_default() += Expr::writes(op);
            }
        }
        let (coordinates, wanted) = match builder.spec.decoupled() {
            None => (
                (1..=program.watched.len()).map(|j| format!("x{j}")).collect(),
                vec!["w".to_owned()],
            ),
            Some(coupled) => (
                coupled.names_of_chains().map(|name| format!("x{name}")).collect(),
                (1..=coupled.outputs.len()).map(|output| format!("law_{output}")).collect(),
            ),
        };
        let (known, done) = (BTreeMap::new(), BTreeSet::new());
        Self { program, uses, known, done, coordinates, wanted, named: 0 }
    }

    /// Statements that set the coordinates of the chains.
    pub(super) fn chain(&mut self, builder: &mut Builder<'_>) -> Vec<Statement> {
        let roots = self.program.watched.clone();
        let mut body = self.body(builder, &roots);
        for (name, root) in self.coordinates.clone().into_iter().zip(roots) {
            let value = self.expression(root);
            if value != Expr::local(&name) {
                body.push(Statement::Let(name, Shape::Real, value));
            }
        }
        body
    }

    /// Statements before u, and u, from the local value w.
    pub(super) fn input(&mut self, builder: &mut Builder<'_>) -> (Vec<Statement>, Expr) {
        let root = self.program.step;
        (self.body(builder, &[root]), self.expression(root))
    }

    /// The same of every input.
    pub(super) fn inputs(&mut self, builder: &mut Builder<'_>) -> (Vec<Statement>, Vec<Expr>) {
        let roots = self.program.controls();
        let body = self.body(builder, &roots);
        (body, roots.into_iter().map(|root| self.expression(root)).collect())
    }

    /// What stands for a value. That of the only user is given away: the terms of a sum would be copied
    /// with each term that is added.
    fn expression(&mut self, value: Value) -> Expr {
        let known = match self.uses.get(&value) {
            Some(1) => self.known.remove(&value),
            _ => self.known.get(&value).cloned(),
        };
        known.unwrap_or_else(|| fault(format!("value {} is used before it is computed", value.0)))
    }

    /// Statements of what `roots` need and is not known yet.
    fn body(&mut self, builder: &mut Builder<'_>, roots: &[Value]) -> Vec<Statement> {
        let mut body = Vec::new();
        for value in self.program.needed(roots) {
            if self.done.insert(value) {
                let known = self.value(builder, value, &mut body);
                self.known.insert(value, known);
            }
        }
        body
    }

    fn value(
        &mut self,
        builder: &mut Builder<'_>,
        value: Value,
        body: &mut Vec<Statement>,
    ) -> Expr {
        let definition = self.program.get(value);
        let (op, stage) = (definition.op.clone(), definition.stage);
        let expression = match &op {
            Op::Input(Input::State(j)) => Expr::Element("x".to_owned(), j - 1),
            Op::Input(Input::Wanted(output)) => {
                return Expr::local(self.wanted[output - 1].clone());
            }
            Op::Input(Input::Parameter(parameter)) => {
                let given = builder.parameter(*parameter);
                let name = parameter_name(*parameter);
                return builder.keep(&name, parameter.meaning(), given);
            }
            Op::Number(number) => return Expr::Number(number.clone()),
            Op::Elimination { matrix, right } => return self.eliminated(matrix, right, body),
            Op::Element(array, index) => match self.expression(*array) {
                Expr::Local(array) => return Expr::Element(array, *index),
                other => fault(format!("{other:?} is no array")),
            },
            op => Expr::of(op, &mut |operand| self.expression(*operand))
                .unwrap_or_else(|| fault(format!("{op:?} of a model at a sample"))),
        };
        if stage <= Stage::Init {
            self.named += 1;
            return builder.keep(
                &format!("c{}", self.named),
                "derived from the parameters",
                expression,
            );
        }
        let name = match self.program.watched.iter().position(|watched| *watched == value) {
            Some(place) => self.coordinates[place].clone(),
            None if self.uses.get(&value).is_some_and(|uses| *uses > 1)
                && !matches!(op, Op::Input(_)) =>
            {
                self.named += 1;
                format!("v{}", self.named)
            }
            None => return expression,
        };
        body.push(Statement::Let(name.clone(), Shape::Real, expression));
        Expr::local(name)
    }

    /// The local array that solves a system.
    fn eliminated(&mut self, matrix: &[Value], right: &[Value], body: &mut Vec<Statement>) -> Expr {
        let [matrix, right] =
            [matrix, right].map(|all| all.iter().map(|value| self.expression(*value)).collect());
        self.named += 1;
        let name = format!("v{}", self.named);
        body.push(Statement::Elimination { name: name.clone(), matrix, right });
        Expr::local(name)
    }
}
