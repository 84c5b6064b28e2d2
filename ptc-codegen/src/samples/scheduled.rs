//! The law of a table of gains: those of two neighbouring nodes, by the samples to go.

use std::ops::{Add, Mul, Sub};

use num_traits::ToPrimitive;

use super::controller::Builder;
use super::ends::{Ending, held_samples};
use super::predicted::weighted;
use crate::algebra::BigRational;
use crate::code::{Expr, Place, Shape, Statement, Table, Test};
use crate::internal::fault;
use crate::linear::{Matrix, Piece, Schedule};
use crate::parameter::Parameter;

/// The table of gains.
const TABLE: &str = "gains";

/// The samples to go for which the gains are.
const COUNT: &str = "to_go";

/// The row of the node below, that of the next one, and the part of the way to it.
const ROW: &str = "row";
const ABOVE: &str = "above";
const PART: &str = "part";

impl Builder<'_> {
    /// v of the law of least energy of a linear plant.
    pub(super) fn scheduled(&mut self, schedule: &Schedule, samples: &Expr) -> Vec<Statement> {
        let planned = self.sampled.planned(self.spec.n, self.fixed(Parameter::SampleTime));
        let (Some(planned), Some(ending)) = (planned, Ending::of(self.spec)) else {
            fault("a linear plant without a sample period")
        };
        let law = self.wanted();
        let states = self.states_of_loop(planned.powers.len());
        let mut body = self.count_to_gains(schedule, &ending, samples);
        body.extend(located(&schedule.pieces));
        let reached = match self.sampled.predicts() {
            true => predicted(&planned.reach, &states, &mut body),
            false => states,
        };
        body.push(Statement::Note("The law of least energy.".to_owned()));
        let between = schedule.pieces.len() > 1;
        if between {
            let above = Expr::local(ROW).count_add(Expr::Count(1));
            body.push(Statement::Let(ABOVE.to_owned(), Shape::Count, above));
        }
        body.push(Statement::Variable(law.name.clone(), Shape::Real));
        let terms = (0..).zip(reached).map(|(j, state)| gain(j, between).mul(state));
        body.push(law.is(Expr::sum(terms)));
        self.tables.push(table(schedule));
        body
    }

    /// The samples to go for which the gains are: those to rest as it is planned, unless the gains are held.
    fn count_to_gains(
        &mut self,
        schedule: &Schedule,
        ending: &Ending,
        samples: &Expr,
    ) -> Vec<Statement> {
        let held = held_samples(self.spec).and_then(|held| held.to_integer().to_u32());
        let Some(held) = held else { fault("a table of gains with an eps at run time") };
        let least = Expr::Count(schedule.least().max(held));
        let left = Self::counted(samples).count_left(Expr::local("elapsed"));
        let mut body = vec![Statement::Let("left".to_owned(), Shape::Count, left)];
        let mut planned = Expr::local("left");
        if ending.spare > 0 {
            let own = planned.count_left(Expr::Count(ending.spare));
            body.push(Statement::Let("planned".to_owned(), Shape::Count, own));
            planned = Expr::local("planned");
        }
        body.push(Statement::Variable(COUNT.to_owned(), Shape::Count));
        let set = |value| vec![Statement::Set(Place::Local(COUNT.to_owned()), value)];
        let goes_on = Test::CountLess(least.clone(), planned.clone());
        body.push(Statement::If(goes_on, set(planned), set(least)));
        body
    }
}

/// The state from which the input of now acts, with the statements that set it.
fn predicted(reach: &Matrix, states: &[Expr], body: &mut Vec<Statement>) -> Vec<Expr> {
    body.push(Statement::Note("The state from which this input acts.".to_owned()));
    let mut all = Vec::with_capacity(reach.len());
    for (row, i) in reach.rows().iter().zip(1..) {
        let name = format!("p{i}");
        let sum = weighted(row, &|j| states[j].clone());
        body.push(Statement::Let(name.clone(), Shape::Real, sum));
        all.push(Expr::local(name));
    }
    all
}

/// Statements that find the nodes around the samples to go.
fn located(pieces: &[Piece]) -> Vec<Statement> {
    if let [only] = pieces {
        return vec![Statement::Let(ROW.to_owned(), Shape::Count, row_of(only))];
    }
    let mut body = vec![
        Statement::Note("Its place between the nodes of the table.".to_owned()),
        Statement::Variable(ROW.to_owned(), Shape::Count),
        Statement::Variable(PART.to_owned(), Shape::Real),
    ];
    let mut found = Vec::new();
    for (i, piece) in pieces.iter().enumerate().rev() {
        let own = within(piece);
        found = match pieces.get(i + 1) {
            None => own,
            Some(next) => {
                let test = Test::CountLess(Expr::local(COUNT), Expr::Count(next.from));
                vec![Statement::If(test, own, found)]
            }
        };
    }
    body.extend(found);
    body
}

/// The row within a piece.
fn row_of(piece: &Piece) -> Expr {
    let cells = || Expr::local(COUNT).count_over(piece.spacing);
    let before = piece.from / piece.spacing;
    match before.checked_sub(piece.row) {
        Some(less) => match less {
            0 => cells(),
            less => cells().count_sub(Expr::Count(less)),
        },
        None => cells().count_add(Expr::Count(piece.row - before)),
    }
}

/// Statements that set the row and the part within a piece.
fn within(piece: &Piece) -> Vec<Statement> {
    let part = match piece.spacing {
        1 => Expr::integer(0),
        spacing => {
            let cell = Expr::Number(BigRational::new(1.into(), spacing.into()));
            let cells = Expr::local(COUNT).count_over(spacing);
            Expr::local(COUNT).real().mul(cell).sub(cells.real())
        }
    };
    let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
    vec![set(ROW, row_of(piece)), set(PART, part)]
}

/// The gain of a state, in a line `between` two nodes where there is not one for each sample.
fn gain(j: usize, between: bool) -> Expr {
    let node = |row: &str| Expr::Tabulated(TABLE.to_owned(), Box::new(Expr::local(row)), j);
    match between {
        true => node(ROW).add(Expr::local(PART).mul(node(ABOVE).sub(node(ROW)))),
        false => node(ROW),
    }
}

fn table(schedule: &Schedule) -> Table {
    let negative = |row: &Vec<BigRational>| row.iter().map(|gain| -gain).collect();
    Table {
        name: TABLE.to_owned(),
        about: "gains of least energy of each state, a row for the samples to go of a node"
            .to_owned(),
        rows: schedule.gains.iter().map(negative).collect(),
    }
}
