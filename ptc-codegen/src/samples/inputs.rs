//! `step` of a plant with several inputs, or of several axes.

use super::controller::Builder;
use super::model::AtSample;
use crate::code::{
    Access, Bounds, Cell, Expr, Finish, Function, Index, Inputs, Owner, Shape, Statement, Status,
    Test, Variable,
};
use crate::parameter::Name;

impl Builder<'_> {
    /// Every u at a tick.
    pub(super) fn step_of_inputs(&mut self, start: &Expr, samples: &Expr) -> Function {
        let m = self.designs.len();
        let states = (0..self.sampled.measured).map(|place| self.state(place));
        let given = states.chain(self.given_references().into_iter().flatten());
        let mut body: Vec<_> = self.finite(given).into_iter().collect();
        body.push(Self::elapsed(start));
        let (statements, values) = match self.spec.decoupled() {
            Some(_) => self.of_plant(samples),
            None => self.of_axes(samples),
        };
        body.extend(statements);
        let tracks = match self.hold() {
            Some(hold) => {
                let hold = self.keep("hold", "samples to go at which the gains are held", hold);
                Test::Less(hold, Expr::local("left").real())
            }
            None => Test::CountLess(Expr::local("elapsed"), samples.clone()),
        };
        let limits = (0..m).map(|index| self.limit_of(index)).collect();
        body.extend(Inputs { values, limits, tracks }.statements());
        let [about, x, u] = self.about();
        let shape = match self.spec.decoupled() {
            Some(_) => Shape::Reals(self.sampled.measured),
            None => Shape::Lists(m, self.spec.n),
        };
        Function {
            name: "step",
            about,
            owner: Owner::Controller,
            access: Access::Read,
            arguments: [Variable::new("k", Shape::Count, "tick"), Variable::new("x", shape, x)]
                .into_iter()
                .chain(self.reference())
                .collect(),
            callbacks: Vec::new(),
            results: vec![
                Variable::new("u", Shape::Reals(m), u),
                Variable::new("axes", Shape::Statuses(m), "status of each input"),
            ],
            failures: match self.guarded() {
                true => vec![Status::Input, Status::Range],
                false => vec![Status::Range],
            },
            body,
            finish: Finish::Stands,
            guarded: self.guarded(),
        }
    }

    /// The chain of each output, its law, and the inputs that give all of them.
    fn of_plant(&mut self, samples: &Expr) -> (Vec<Statement>, Vec<Expr>) {
        let mut model = AtSample::new(self);
        let note = match self.spec.sampled_exactly() {
            Some(_) => "The chain of each output as it is sampled.",
            None => "The chain of each output.",
        };
        let mut body = vec![Statement::Note(note.to_owned())];
        body.extend(model.chain(self));
        body.extend(self.follow());
        body.extend(self.laws(samples));
        body.push(Statement::Note("The inputs that give all of them.".to_owned()));
        let (before, inputs) = model.inputs(self);
        body.extend(before);
        let mut values = Vec::with_capacity(inputs.len());
        for (index, input) in (1..).zip(inputs) {
            let name = format!("control{index}");
            body.push(Statement::Let(name.clone(), Shape::Real, input));
            values.push(Expr::local(name));
        }
        (body, values)
    }

    /// The chain of each axis, and its law, which is its input.
    fn of_axes(&mut self, samples: &Expr) -> (Vec<Statement>, Vec<Expr>) {
        let n = self.spec.n;
        let local = |place: usize| {
            let name = format!("x{}_{}", place % n + 1, place / n + 1);
            Statement::Let(name, Shape::Real, self.state(place))
        };
        let mut body: Vec<_> = (0..self.sampled.measured).map(local).collect();
        body.extend(self.follow());
        body.extend(self.laws(samples));
        let law = |axis| Expr::local(format!("law_{axis}"));
        (body, (1..=self.designs.len()).map(law).collect())
    }

    /// Describes the function, its argument and its result in words.
    fn about(&self) -> [String; 3] {
        let follows = self.spec.references() > 0;
        let Some(coupled) = self.spec.decoupled() else {
            let given = match follows {
                true => "the state x = (x1, x1', ...) and the reference r of each",
                false => "the state x = (x1, x1', ...) of each",
            };
            return [
                format!(
                    "u of each axis from tick `k`, which may wrap, and {given}. Where one of them is not finite, every u is 0; else the status is SATURATED where one was clipped."
                ),
                "state of each axis: x1, its rate, ...".to_owned(),
                "input of each axis".to_owned(),
            ];
        };
        let [states, inputs] = [&coupled.states, &coupled.inputs].map(|all| Name::listed(all));
        [
            format!(
                "u = ({inputs}) from tick `k`, which may wrap, {}state x = ({states}){}. {}",
                if follows { "" } else { "and " },
                if follows { " and the reference r of each output" } else { "" },
                Inputs::ENDS
            ),
            format!("state: {states}"),
            format!("inputs of the plant: {inputs}"),
        ]
    }

    /// A state, which those of axes are given in rows.
    fn state(&self, place: usize) -> Expr {
        let columns = self.spec.n;
        match self.spec.decoupled() {
            Some(_) => Expr::Element("x".to_owned(), place),
            None => {
                let (row, column) = (Index::at(place / columns), place % columns);
                Expr::Entry("x".to_owned(), Cell { row, column, columns })
            }
        }
    }

    /// The limits of one input, from 0.
    fn limit_of(&mut self, index: usize) -> Bounds {
        let own = self.spec.own_limits(index).map(Bounds::of);
        own.unwrap_or_else(|| self.limits())
    }
}
