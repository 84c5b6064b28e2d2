//! `step` of several axes: what `tick` computes once, and what `axis` does, in loops over all axes.

use super::Builder;
use super::body::{PARTS, body};
use super::given::{Given, OfAll};
use crate::code::{
    AXIS, Access, Expr, Finish, For, Function, Index, Owner, Place, Shape, Standing, Statement,
    Status, Test, Variable, Whose,
};
use crate::controller::plan::Routine;
use crate::internal::fault;

/// u of each axis before it is clipped: an array of its own, as u may lie where x does.
pub(super) const WANTED: &str = "wanted";

impl Builder<'_> {
    /// `step` of all axes.
    pub(super) fn all_axes(&self, count: usize) -> Function {
        let axis = self.axis();
        let rows = axis.arguments.into_iter().filter_map(|argument| match argument.shape {
            Shape::Reals(length) => Some(Variable {
                shape: Shape::Lists(count, length),
                about: format!("for each axis its {}", argument.about),
                ..argument
            }),
            _ => None,
        });
        let time = Variable::new("t", Shape::Real, "time, s");
        Function {
            name: "step",
            about: match self.reference() {
                None => format!(
                    "u of {count} axes at time t [s], from the state x = (x1, x1', ...) of each."
                ),
                Some(_) => format!(
                    "u of {count} axes at time t [s], from the state x = (x1, x1', ...) and the reference r = (r, r', ...) of each."
                ),
            } + " Its status is that of the first axis that fails, and then every u is 0; else SATURATED where an axis is.",
            owner: Owner::Controller,
            access: Access::Read,
            arguments: std::iter::once(time).chain(rows).collect(),
            callbacks: Vec::new(),
            results: vec![
                Variable::new("u", Shape::Reals(count), "inputs of the plants"),
                Variable::new("axes", Shape::Statuses(count), "status of each axis"),
            ],
            failures: axis.failures,
            body: self.steps_of_axes(count),
            finish: Finish::Stands,
            guarded: self.guarded(),
        }
    }

    fn steps_of_axes(&self, count: usize) -> Vec<Statement> {
        let mut statements = Vec::new();
        if self.guarded() {
            statements.push(Statement::Require(Test::All(self.legal_time()), Status::Input));
        }
        let body = self.body(Routine::Tick, &[]);
        statements.extend(body.statements);
        let Some((late, values)) = body.roots.split_last() else { fault("a tick without gains") };
        let mut values = values.to_vec();
        for variable in self.gains() {
            // A bound that all share is a field.
            let count = variable.shape.length().unwrap_or(1).min(values.len());
            if count > 0 {
                statements.extend(local(&variable, values.drain(..count).collect()));
            }
        }
        let settle = |status| vec![Statement::Settle(Whose::Call, Standing::Known(status))];
        let tracks = Test::Less(late.clone(), self.field(self.limits.hold_from));
        statements.push(Statement::If(tracks, settle(Status::Ok), settle(Status::Hold)));
        statements.extend(self.wanted(count, body.temporaries));
        statements.extend(self.clipped_axes(count));
        statements
    }

    /// u of all axes before it is clipped. Sums that stand in arrays are formed for all axes before those made of
    /// them, which compilers turn into vector instructions. Without such sums lines for each axis take fewer
    /// instructions than a loop with -O2; the tests of a quotient are written once.
    fn wanted(&self, count: usize, temporaries: usize) -> Vec<Statement> {
        let program = self.program;
        let parts = &program.parts;
        let wanted = |axis| Place::Element(WANTED.to_owned(), axis);
        let array = Statement::Variable(WANTED.to_owned(), Shape::Reals(count));
        let body = |of_all, temporaries| {
            let given = Given { of_all: Some(of_all), parts, temporaries, ..Given::default() };
            let mut body = body(&self.plan, Routine::Axis, given);
            let Some(value) = body.roots.pop() else { fault("an axis without u") };
            (body.statements, value, body.temporaries)
        };
        if parts.is_empty() && program.divisors.is_empty() {
            let mut statements = vec![array];
            let mut temporaries = temporaries;
            for axis in 0..count {
                let (own, value, last) = body(OfAll::One(axis), temporaries);
                temporaries = last;
                statements.extend(own);
                statements.push(Statement::Set(wanted(Index::at(axis)), value));
            }
            return statements;
        }
        let (mut rest, value, _) = body(OfAll::Each, temporaries);
        let mut statements = Vec::new();
        for (level, name) in parts.iter().zip(PARTS) {
            let is_of_level = |statement: &Statement| match statement {
                Statement::Set(Place::Element(own, _), _) => own == name,
                _ => false,
            };
            let behind = rest.iter().rposition(is_of_level).map_or(0, |last| last + 1);
            let further = rest.split_off(behind);
            let sums = Shape::Reals(count * level.len());
            statements.push(Statement::Variable(name.to_owned(), sums));
            statements.push(each(count, rest));
            rest = further;
        }
        statements.push(array);
        rest.push(Statement::Set(wanted(Index::of(AXIS)), value));
        statements.push(each(count, rest));
        statements
    }
}

/// Values as a local value or array.
fn local(variable: &Variable, values: Vec<Expr>) -> Vec<Statement> {
    let name = || variable.name.clone();
    if variable.shape == Shape::Real {
        let define = |value| Statement::Let(name(), Shape::Real, value);
        return values.into_iter().map(define).collect();
    }
    let mut statements = vec![Statement::Variable(name(), variable.shape)];
    for (place, value) in values.into_iter().enumerate() {
        statements.push(Statement::Set(Place::Element(name(), Index::at(place)), value));
    }
    statements
}

/// For every axis.
pub(super) fn each(count: usize, body: Vec<Statement>) -> Statement {
    Statement::For(For::each(AXIS, Index::at(0), Index::at(count), body))
}
