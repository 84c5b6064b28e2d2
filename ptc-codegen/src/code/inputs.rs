//! The end of a call that gives the inputs of one plant, as statements.

use super::{Bounds, Expr, Index, Place, Statement, Status, Test};

/// The inputs of one plant.
#[derive(Clone, Debug, PartialEq)]
pub struct Inputs {
    /// Each before it is clipped: a local value.
    pub values: Vec<Expr>,
    /// The limits of each.
    pub limits: Vec<Bounds>,
    /// Tests if the call tracks; otherwise the gains are held.
    pub tracks: Test,
    /// Tests of a call that tracks, and its status where one holds.
    pub planned: Vec<(Test, Status)>,
    /// Statements of a call that does not fail.
    pub changes: Vec<Statement>,
}

/// Whose status it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Whose {
    /// The call's.
    Call,
    /// The status of one of several inputs.
    Input(Index),
}

/// A status that is assigned.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Standing {
    /// A known one.
    Known(Status),
    /// The status of the call or of an input.
    Of(Whose),
}

impl Inputs {
    /// Description of the end of such a call.
    pub const ENDS: &'static str = "Where one of them is not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the status is SATURATED where one was clipped.";

    /// Each u within its bound and the status of each. Where one of them is no finite number, every u is 0, and the
    /// status of the call is that of range; else that u was clipped, where one was.
    pub fn statements(self) -> Vec<Statement> {
        let give = |index, value| Statement::Set(Place::Input(Index::at(index)), value);
        let settle = |whose, status| Statement::Settle(whose, Standing::Known(status));
        let of = |index| Whose::Input(Index::at(index));
        let same = |index| Statement::Settle(of(index), Standing::Of(Whose::Call));
        let finite = |value: &Expr| Test::Finite(value.clone());
        let every = Test::All(self.values.iter().map(finite).collect());

        let mut given = Vec::new();
        let mut refused = Vec::new();
        for (index, value) in self.values.iter().enumerate() {
            given.extend([give(index, value.clone()), same(index)]);
            let range = settle(of(index), Status::Range);
            refused.push(give(index, Expr::integer(0)));
            refused.push(Statement::If(finite(value), vec![same(index)], vec![range]));
        }
        for (index, (value, limit)) in self.values.iter().zip(&self.limits).enumerate() {
            let clipped = |bound: &Expr| {
                vec![
                    give(index, bound.clone()),
                    settle(of(index), Status::Saturated),
                    settle(Whose::Call, Status::Saturated),
                ]
            };
            let beyond: Vec<_> = limit.beyond(value).collect();
            given.extend(beyond.into_iter().rev().fold(Vec::new(), |rest, (test, limit)| {
                vec![Statement::If(test, clipped(&limit), rest)]
            }));
        }
        given.extend(self.changes);
        refused.push(settle(Whose::Call, Status::Range));
        let [mut tracking, held] =
            [Status::Ok, Status::Hold].map(|status| vec![settle(Whose::Call, status)]);
        for (test, status) in self.planned {
            tracking = vec![Statement::If(test, vec![settle(Whose::Call, status)], tracking)];
        }
        vec![Statement::If(self.tracks, tracking, held), Statement::If(every, given, refused)]
    }
}
