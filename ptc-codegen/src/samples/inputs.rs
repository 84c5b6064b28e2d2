//! `step` of a plant with several inputs, or of several axes.

use super::controller::Builder;
use super::flight::LAST;
use super::model::AtSample;
use crate::code::{
    Access, Bounds, Cell, Expr, Finish, Function, Index, Inputs, Owner, Place, Shape, Statement,
    Status, Test, Variable,
};
use crate::parameter::Name;

impl Builder<'_> {
    /// Every u at a tick.
    pub(super) fn step_of_inputs(&mut self, start: &Expr, samples: &Expr) -> Function {
        let m = self.designs.len();
        let states = self.states_of_axes();
        let given = states.chain(self.given_references().into_iter().flatten());
        let mut body: Vec<_> = self.finite(given).into_iter().collect();
        body.push(Self::elapsed(start));
        let (statements, values, samples) = match self.spec.decoupled() {
            Some(_) => {
                let (statements, values) = self.of_plant(samples);
                (statements, values, samples.clone())
            }
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
        let planned = self.outcomes_of_plan();
        let changes = match self.replans() {
            true => vec![Statement::Set(Place::Field(LAST.to_owned()), samples.clone())],
            false => Vec::new(),
        };
        let access = if changes.is_empty() { Access::Read } else { Access::Change };
        body.extend(Inputs { values, limits, tracks, planned, changes }.statements());
        let [about, u] = self.about();
        let x = match self.spec.decoupled() {
            Some(coupled) => {
                let about = format!("state: {}", Name::listed(&coupled.states));
                Variable::new("x", Shape::Reals(self.sampled.measured), about)
            }
            None => self.argument_of_axes(),
        };
        Function {
            name: "step",
            about,
            owner: Owner::Controller,
            access,
            arguments: [Variable::new("k", Shape::Count, "tick"), x]
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

    /// The chain of each axis, and its law, which is its input, and the samples from the start to rest.
    fn of_axes(&mut self, samples: &Expr) -> (Vec<Statement>, Vec<Expr>, Expr) {
        let mut body = self.chains_of_axes();
        body.extend(self.follow());
        let (planned, samples) = self.samples_now(samples);
        body.extend(planned);
        body.extend(self.laws(&samples));
        let law = |axis| Expr::local(format!("law_{axis}"));
        (body, (1..=self.designs.len()).map(law).collect(), samples)
    }

    /// The states of all axes, as a call is given them.
    pub(super) fn argument_of_axes(&self) -> Variable {
        let shape = Shape::Lists(self.designs.len(), self.spec.n);
        Variable::new("x", shape, "state of each axis: x1, its rate, ...")
    }

    /// The states of the plant, or of all axes.
    pub(super) fn states_of_axes(&self) -> impl Iterator<Item = Expr> {
        (0..self.sampled.measured).map(|place| self.state(place))
    }

    /// Statements that set the states of the chain of each axis.
    pub(super) fn chains_of_axes(&self) -> Vec<Statement> {
        let n = self.spec.n;
        let local = |(place, state): (usize, Expr)| {
            let name = format!("x{}_{}", place % n + 1, place / n + 1);
            Statement::Let(name, Shape::Real, state)
        };
        self.states_of_axes().enumerate().map(local).collect()
    }

    /// Describes the function and its result in words.
    fn about(&self) -> [String; 2] {
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
