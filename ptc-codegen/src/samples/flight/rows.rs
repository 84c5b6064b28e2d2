//! The tests that a deadline keeps all limits, from a table of rows: of the two nodes around the samples to go that are
//! tried, each row times the state, and between them in a line.

use std::ops::{Add, Mul, Sub};

use super::super::controller::Builder;
use super::super::scheduled::Located;
use super::bounds::{Limits, TRIED};
use crate::algebra::{BigRational, integer};
use crate::code::{Expr, For, Index, Place, Shape, Statement, Table, Test};
use crate::linear::{Signal, Tabled};

/// The place in the table.
const PLACE: Located = Located { count: TRIED, row: "node", part: "beyond" };

/// The number of rows that are within the limits.
const BOUNDED: &str = "bounded";

/// The row of this node, and that of the next one.
const AT: &str = "at";
const NEXT: &str = "next";

/// Statements that count the rows within the limits, and the test that all are.
pub(super) fn within(table: &Tabled, state: &[Expr], limits: &Limits) -> (Vec<Statement>, Test) {
    let mut body = PLACE.statements(&table.pieces);
    body.push(Statement::Begin(BOUNDED.to_owned(), Shape::Count, Expr::Count(0)));
    body.push(Statement::Variable(AT.to_owned(), Shape::Count));
    let mut known = 0;
    for rows in &table.signals {
        let name = name(rows.signal);
        let value = between(table, state, &name);
        let tests = limits.admit_size(rows.signal, &integer(1), value);
        let one = Expr::local(BOUNDED).count_add(Expr::Count(1));
        let next = Expr::local(AT).count_add(Expr::Count(count(table.nodes)));
        let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
        let goes_on = vec![set(BOUNDED, one), set(AT, next)];
        let mut each = Vec::new();
        if Located::lies_between(&table.pieces) {
            let next = Expr::local(AT).count_add(Expr::Count(1));
            each.push(Statement::Let(NEXT.to_owned(), Shape::Count, next));
        }
        each.push(Statement::If(Test::All(tests), goes_on, vec![Statement::Leave]));
        let [from, to] = [0, rows.count].map(Index::at);
        let own = vec![
            set(AT, Expr::local(PLACE.row)),
            Statement::For(For::each("bound", from, to, each)),
        ];
        if known == 0 {
            body.extend(own);
        } else {
            let so_far = Test::CountEqual(Expr::local(BOUNDED), Expr::Count(known));
            body.push(Statement::If(so_far, own, Vec::new()));
        }
        known += count(rows.count);
    }
    (body, Test::CountEqual(Expr::local(BOUNDED), Expr::Count(known)))
}

/// The signal at the sample of a row.
fn between(table: &Tabled, state: &[Expr], name: &str) -> Expr {
    let at = |row: &str| {
        let term = |(j, state): (usize, &Expr)| {
            Expr::Tabulated(name.to_owned(), Box::new(Expr::local(row)), j).mul(state.clone())
        };
        Expr::sum(state.iter().enumerate().map(term))
    };
    match Located::lies_between(&table.pieces) {
        true => {
            let own = |part: Expr, row| part.mul(at(row));
            let beyond = Expr::local(PLACE.part);
            own(Expr::integer(1).sub(beyond.clone()), AT).add(own(beyond, NEXT))
        }
        false => at(AT),
    }
}

fn count(value: usize) -> u32 {
    u32::try_from(value).unwrap_or(u32::MAX)
}

/// The name of the table of a signal.
fn name(signal: Signal) -> String {
    match signal {
        Signal::Input => "bounds_u".to_owned(),
        Signal::State(i) => format!("bounds_x{}", i + 1),
    }
}

impl Builder<'_> {
    /// Adds the tables of bounds, once.
    pub(super) fn add_bounds(&mut self, table: &Tabled) {
        for rows in &table.signals {
            let name = name(rows.signal);
            if self.tables.iter().any(|known| known.name == name) {
                continue;
            }
            let signal = name.trim_start_matches("bounds_");
            let exact = |row: &Vec<f64>| {
                row.iter().map(|own| BigRational::from_float(*own).unwrap_or_default()).collect()
            };
            self.tables.push(Table {
                about: format!("{signal} at {} samples on the way to rest by the state, for each a row for the samples to go of a node", rows.count),
                rows: rows.table.iter().map(exact).collect(),
                name,
            });
        }
    }
}
