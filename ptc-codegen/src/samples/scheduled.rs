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

/// Names of a place in a table: the samples to go, the row of the node below, and the part of the way to the next one.
pub(super) struct Located {
    pub(super) count: &'static str,
    pub(super) row: &'static str,
    pub(super) part: &'static str,
}

const GAINS: Located = Located { count: COUNT, row: "row", part: "part" };

/// The row of the next node.
const ABOVE: &str = "above";

impl Builder<'_> {
    /// v of the law of least energy of a linear plant.
    pub(super) fn scheduled(&mut self, schedule: &Schedule, samples: &Expr) -> Vec<Statement> {
        let Some(ending) = Ending::of(self.spec) else { fault("a law in samples without a clock") };
        let law = self.wanted();
        let mut body = self.count_to_gains(schedule, &ending, samples);
        body.extend(GAINS.statements(&schedule.pieces));
        let (before, reached) = self.reached("p");
        body.extend(before);
        body.push(Statement::Note("The law of least energy.".to_owned()));
        let between = Located::lies_between(&schedule.pieces);
        if between {
            let above = Expr::local(GAINS.row).count_add(Expr::Count(1));
            body.push(Statement::Let(ABOVE.to_owned(), Shape::Count, above));
        }
        body.push(Statement::Variable(law.name.clone(), Shape::Real));
        let terms = (0..).zip(reached).map(|(j, state)| gain(j, between).mul(state));
        body.push(law.is(Expr::sum(terms)));
        self.tables.push(table(schedule));
        body
    }

    /// The state from which the input of now acts, and statements that set it where it is predicted, by names of a letter.
    pub(super) fn reached(&mut self, letter: &str) -> (Vec<Statement>, Vec<Expr>) {
        let planned = self.sampled.planned(self.spec.n, self.fixed(Parameter::SampleTime));
        let Some(planned) = planned else { fault("a linear plant without a sample period") };
        let states = self.states_of_loop(planned.powers.len());
        let mut body = Vec::new();
        match self.sampled.predicts() {
            true => {
                let all = predicted(&planned.reach, &states, letter, &mut body);
                (body, all)
            }
            false => (body, states),
        }
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
        let own = match self.replans() {
            // A call of an earlier tick may have more of them than the table.
            true => {
                let most = Expr::Count(schedule.samples);
                let beyond = Test::CountLess(most.clone(), planned.clone());
                vec![Statement::If(beyond, set(most), set(planned))]
            }
            false => set(planned),
        };
        body.push(Statement::If(goes_on, own, set(least)));
        body
    }
}

/// The state from which the input of now acts, with the statements that set it.
fn predicted(
    reach: &Matrix,
    states: &[Expr],
    letter: &str,
    body: &mut Vec<Statement>,
) -> Vec<Expr> {
    body.push(Statement::Note("The state from which this input acts.".to_owned()));
    let mut all = Vec::with_capacity(reach.len());
    for (row, i) in reach.rows().iter().zip(1..) {
        let name = format!("{letter}{i}");
        let sum = weighted(row, &|j| states[j].clone());
        body.push(Statement::Let(name.clone(), Shape::Real, sum));
        all.push(Expr::local(name));
    }
    all
}

impl Located {
    /// Statements that find the nodes around the samples to go.
    pub(super) fn statements(&self, pieces: &[Piece]) -> Vec<Statement> {
        if let [only @ Piece { spacing: 1, .. }] = pieces {
            return vec![Statement::Let(self.row.to_owned(), Shape::Count, self.row_of(only))];
        }
        let mut body = vec![
            Statement::Note("Its place between the nodes of the table.".to_owned()),
            Statement::Variable(self.row.to_owned(), Shape::Count),
            Statement::Variable(self.part.to_owned(), Shape::Real),
        ];
        let mut found = Vec::new();
        for (i, piece) in pieces.iter().enumerate().rev() {
            let own = self.within(piece);
            found = match pieces.get(i + 1) {
                None => own,
                Some(next) => {
                    let test = Test::CountLess(Expr::local(self.count), Expr::Count(next.from));
                    vec![Statement::If(test, own, found)]
                }
            };
        }
        body.extend(found);
        body
    }

    /// Returns true if there are rows between two nodes.
    pub(super) fn lies_between(pieces: &[Piece]) -> bool {
        pieces.iter().any(|piece| piece.spacing > 1)
    }

    /// The row within a piece.
    fn row_of(&self, piece: &Piece) -> Expr {
        let cells = || Expr::local(self.count).count_over(piece.spacing);
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
    fn within(&self, piece: &Piece) -> Vec<Statement> {
        let part = match piece.spacing {
            1 => Expr::integer(0),
            spacing => {
                let cell = Expr::Number(BigRational::new(1.into(), spacing.into()));
                let cells = Expr::local(self.count).count_over(spacing);
                Expr::local(self.count).real().mul(cell).sub(cells.real())
            }
        };
        let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
        vec![set(self.row, self.row_of(piece)), set(self.part, part)]
    }
}

/// The gain of a state, in a line `between` two nodes where there is not one for each sample.
fn gain(j: usize, between: bool) -> Expr {
    let node = |row: &str| Expr::Tabulated(TABLE.to_owned(), Box::new(Expr::local(row)), j);
    match between {
        true => node(GAINS.row).add(Expr::local(GAINS.part).mul(node(ABOVE).sub(node(GAINS.row)))),
        false => node(GAINS.row),
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
