//! A staged program within the program of a controller in samples: what is known before a call goes into
//! fields, the rest into statements of the call.

use std::collections::BTreeSet;

use super::controller::Builder;
use crate::code::{Expr, Shape, Statement, Subroutine, Written, parameter_name};
use crate::internal::fault;
use crate::program::{Input, Op, Program, Stage, Value, passes};

/// The names of what a program computes, and is given.
pub(super) struct Names {
    /// Names of the values that it watches.
    pub(super) watched: Vec<String>,
    /// Names of the local values for the wanted rate of each output.
    pub(super) wanted: Vec<String>,
    /// Prefixes of the numbers of other values: of fields, and of local values.
    pub(super) letters: [&'static str; 2],
}

/// State of the computation of a program.
pub(super) struct Staged {
    program: Program,
    names: Names,
    written: Written,
    /// All that has been known, given away or not.
    done: BTreeSet<Value>,
    /// Number of values with their own name.
    named: usize,
}

impl Staged {
    /// Begins the computation of a program whose time is the local value t.
    pub(super) fn new(program: Program, names: Names) -> Self {
        let program = passes::optimise(program, &mut |_, _| {});
        let roots = [program.watched.clone(), program.controls()].concat();
        let written = Written::of(&program, &roots, 1);
        Self { program, names, written, done: BTreeSet::new(), named: 0 }
    }

    /// Statements before the values that it watches, and these with their names.
    pub(super) fn watched(
        &mut self,
        builder: &mut Builder<'_>,
    ) -> (Vec<Statement>, Vec<(String, Expr)>) {
        let roots = self.program.watched.clone();
        let (body, values) = self.values(builder, &roots);
        (body, self.names.watched.iter().cloned().zip(values).collect())
    }

    /// Statements before its step and the other inputs, and these.
    pub(super) fn controls(&mut self, builder: &mut Builder<'_>) -> (Vec<Statement>, Vec<Expr>) {
        self.values(builder, &self.program.controls())
    }

    fn values(
        &mut self,
        builder: &mut Builder<'_>,
        roots: &[Value],
    ) -> (Vec<Statement>, Vec<Expr>) {
        let body = self.body(builder, roots);
        (body, roots.iter().map(|root| self.written.expression(*root)).collect())
    }

    /// Statements of what `roots` need and is not known yet.
    fn body(&mut self, builder: &mut Builder<'_>, roots: &[Value]) -> Vec<Statement> {
        let mut body = Vec::new();
        for value in self.program.needed(roots) {
            if self.done.insert(value) {
                let known = self.value(builder, value, &mut body);
                self.written.insert(value, known);
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
        let [field, local] = self.names.letters;
        let expression = match &op {
            Op::Input(Input::State(j)) => Expr::Element("x".to_owned(), j - 1),
            Op::Input(Input::Wanted(output)) => {
                return Expr::local(self.names.wanted[output - 1].clone());
            }
            Op::Input(Input::Time) => Expr::local("t"),
            Op::Input(Input::Parameter(parameter)) => {
                let given = builder.parameter(*parameter);
                let name = parameter_name(*parameter);
                return builder.keep(&name, parameter.meaning(), given);
            }
            Op::Number(number) => return Expr::Number(number.clone()),
            Op::Elimination { matrix, right } => return self.eliminated(matrix, right, body),
            Op::Element(array, index) => match self.written.expression(*array) {
                Expr::Local(array) => return Expr::Element(array, *index),
                other => fault(format!("{other:?} is no array")),
            },
            op => Expr::of(op, &mut |operand| self.written.expression(*operand))
                .unwrap_or_else(|| fault(format!("{op:?} at a sample"))),
        };
        if stage <= Stage::Init {
            self.named += 1;
            let name = format!("{field}{}", self.named);
            return builder.keep(&name, "derived from the parameters", expression);
        }
        let name = match self.program.watched.iter().position(|watched| *watched == value) {
            Some(place) => self.names.watched[place].clone(),
            None if self.written.is_shared(value) && !matches!(op, Op::Input(_)) => {
                self.named += 1;
                format!("{local}{}", self.named)
            }
            None => return expression,
        };
        body.push(Statement::Let(name.clone(), Shape::Real, expression));
        Expr::local(name)
    }

    /// The local array that solves a system.
    fn eliminated(&mut self, matrix: &[Value], right: &[Value], body: &mut Vec<Statement>) -> Expr {
        let [matrix, right]: [Vec<Expr>; 2] = [matrix, right]
            .map(|all| all.iter().map(|value| self.written.expression(*value)).collect());
        self.named += 1;
        let name = format!("{}{}", self.names.letters[1], self.named);
        let elimination = Subroutine::Elimination(right.len());
        body.push(elimination.apply(name.clone(), [right, matrix]));
        Expr::local(name)
    }
}
