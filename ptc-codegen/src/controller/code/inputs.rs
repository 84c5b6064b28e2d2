//! `step` of a plant with several inputs.

use super::Builder;
use crate::code::{
    Access, Bounds, Expr, Finish, Function, Inputs, Operator, Owner, Shape, Statement, Status,
    Test, Variable,
};
use crate::controller::plan::Routine;
use crate::internal::fault;
use crate::model::Coupled;
use crate::parameter::Name;
use crate::request::Guard;

impl Builder<'_> {
    /// u of each input.
    pub(super) fn step_of_inputs(&self, coupled: &Coupled) -> Function {
        let m = coupled.inputs.len();
        let states = self.arrays();
        let mut statements = self.locals(&states);
        if self.guarded() {
            let finite = states.iter().map(|state| Test::Finite(self.local(*state)));
            let tests = self.legal_time().into_iter().chain(finite).collect();
            statements.push(Statement::Require(Test::All(tests), Status::Input));
        }
        let body = self.body(Routine::Step, &states);
        statements.extend(body.statements);
        let [controls @ .., late] = body.roots.as_slice() else { fault("a step without u") };
        let mut values = Vec::with_capacity(m);
        for (index, control) in (1..).zip(controls) {
            let mut value = control.clone();
            if self.spec.guard == Guard::Result {
                // t itself may cancel in u.
                let t = || Expr::local("t");
                let unknown = Expr::binary(Operator::Sub, t(), t());
                value = Expr::binary(Operator::Add, value, unknown);
            }
            let name = format!("control{index}");
            statements.push(Statement::Let(name.clone(), Shape::Real, value));
            values.push(Expr::local(name));
        }
        let tracks = Test::Less(late.clone(), self.field(self.limits.hold_from));
        let limits = (0..m).map(|index| self.limit_of(index)).collect();
        statements.extend(
            Inputs { values, limits, tracks, planned: Vec::new(), changes: Vec::new() }
                .statements(),
        );
        let inputs = Name::listed(&coupled.inputs);
        let reference = self.reference();
        Function {
            name: "step",
            about: format!(
                "u = ({inputs}) at time t [s]{}state x = ({}){}. {}",
                if reference.is_some() { ", " } else { " and " },
                Name::listed(&coupled.states),
                match reference.is_some() {
                    true => " and reference r = (r, r', ...) of each output",
                    false => "",
                },
                Inputs::ENDS
            ),
            owner: Owner::Controller,
            access: Access::Read,
            arguments: [
                Variable::new("t", Shape::Real, "time, s"),
                self.array("x", &format!("state: {}", Name::listed(&coupled.states))),
            ]
            .into_iter()
            .chain(reference)
            .collect(),
            callbacks: self.callbacks(),
            results: vec![
                Variable::new("u", Shape::Reals(m), format!("inputs of the plant: {inputs}")),
                Variable::new("axes", Shape::Statuses(m), "status of each input"),
            ],
            failures: self.failures(),
            body: statements,
            finish: Finish::Stands,
            guarded: self.guarded(),
        }
    }

    /// The limits of one input.
    fn limit_of(&self, index: usize) -> Bounds {
        self.spec.own_limits(index).map_or_else(|| self.bounds(), Bounds::of)
    }
}
