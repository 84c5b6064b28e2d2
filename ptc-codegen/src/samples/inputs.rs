//! `step` of a plant with several inputs.

use super::controller::Builder;
use super::model::AtSample;
use crate::code::{
    Access, Expr, Finish, Function, Inputs, Owner, Shape, Statement, Status, Test, Variable,
};
use crate::model::Coupled;
use crate::parameter::{Fixed, Name};

impl Builder<'_> {
    /// u of each input: the chains of the states, the law of each, and the inputs that give all of them.
    pub(super) fn step_of_inputs(
        &mut self,
        coupled: &Coupled,
        start: &Expr,
        samples: &Expr,
    ) -> Function {
        let (m, measured) = (coupled.inputs.len(), self.sampled.measured);
        let element = |j| Expr::Element("x".to_owned(), j);
        let mut body: Vec<_> = self.finite((0..measured).map(element)).into_iter().collect();
        body.push(Self::elapsed(start));
        let mut model = AtSample::new(self);
        body.push(Statement::Note("The chain of each output.".to_owned()));
        body.extend(model.chain(self));
        body.extend(self.laws(samples));
        body.push(Statement::Note("The inputs that give all of them.".to_owned()));
        let (before, inputs) = model.inputs(self);
        body.extend(before);
        let mut values = Vec::with_capacity(m);
        for (index, input) in (1..).zip(inputs) {
            let name = format!("control{index}");
            body.push(Statement::Let(name.clone(), Shape::Real, input));
            values.push(Expr::local(name));
        }
        let tracks = match self.hold() {
            Some(hold) => {
                let hold = self.keep("hold", "samples to go at which the gains are held", hold);
                Test::Less(hold, Expr::local("left").real())
            }
            None => Test::CountLess(Expr::local("elapsed"), samples.clone()),
        };
        let limits = (0..m).map(|index| self.limit_of(index)).collect();
        let [states, inputs] = [&coupled.states, &coupled.inputs].map(|all| Name::listed(all));
        Function {
            name: "step",
            about: format!(
                "u = ({inputs}) from tick `k`, which may wrap, and state x = ({states}). Where one of them is not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the status is SATURATED where one was clipped."
            ),
            owner: Owner::Controller,
            access: Access::Read,
            arguments: vec![
                Variable::new("k", Shape::Count, "tick"),
                Variable::new("x", Shape::Reals(measured), format!("state: {states}")),
            ],
            callbacks: Vec::new(),
            results: vec![
                Variable::new("u", Shape::Reals(m), format!("inputs of the plant: {inputs}")),
                Variable::new("axes", Shape::Statuses(m), "status of each input"),
            ],
            failures: match self.guarded() {
                true => vec![Status::Input, Status::Range],
                false => vec![Status::Range],
            },
            body,
            finish: Finish::Inputs(Box::new(Inputs { values, limits, tracks })),
            guarded: self.guarded(),
        }
    }

    /// The bound of one input, from 0.
    fn limit_of(&mut self, index: usize) -> Option<Expr> {
        let own = self.spec.axes.as_ref().and_then(|axes| axes.limits.get(index));
        match own.and_then(Fixed::number) {
            Some(limit) => Some(Expr::Number(limit.clone())),
            None => self.limit(),
        }
    }
}
