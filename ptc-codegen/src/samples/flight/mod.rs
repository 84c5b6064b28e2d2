//! A deadline that changes while the controller runs: the field `last`, the planned number of samples from the start to
//! rest, and the functions that change it, the target and the estimates.
//!
//! `bounds` are the tests that a deadline keeps the limits, `search` finds the soonest one, `replan` puts a deadline
//! off within `step`, `deadline` and `corrections` hold the functions.

mod bounds;
mod corrections;
mod deadline;
mod replan;
mod search;

pub(super) use replan::NOW;

use super::controller::Builder;
use super::ends::Ending;
use crate::code::{Expr, Function, Shape, Statement};
use crate::internal::fault;
use crate::linear::Horizon;
use crate::request::Flight;

/// The samples from the start to rest, as they are planned now.
pub(super) const LAST: &str = "last";

/// The samples of the observer's round that were left at the start.
pub(super) const ROUND: &str = "round";

/// The samples to go for which a plan is asked.
const AHEAD: &str = "ahead";

impl Builder<'_> {
    pub(super) fn flight(&self) -> Option<&Flight> {
        self.sampled.flight.as_ref()
    }

    /// The bounds of a plan, where deadlines are planned.
    fn horizon(&self) -> Option<Horizon> {
        self.sampled.horizon(self.spec)
    }

    /// Returns true if the round of an observer is counted from the start.
    pub(super) fn counts_round(&self) -> bool {
        self.flight().is_some() && self.round().is_some()
    }

    /// Samples by which the law plans to be at rest early.
    fn spare(&self) -> u32 {
        Ending::of(self.spec).map_or_else(|| fault("no clock in samples"), |ending| ending.spare)
    }

    /// Statements that set the flat coordinates, and what they are.
    fn coordinates(&mut self) -> (Vec<Statement>, Vec<Expr>) {
        let flat = self.flat();
        let mut body = Vec::new();
        let mut all = Vec::new();
        for i in 0..flat.order() {
            let name = format!("flat{}", i + 1);
            let value = self.flat_coordinate(&flat, i);
            body.push(Statement::Let(name.clone(), Shape::Real, value));
            all.push(Expr::local(name));
        }
        (body, all)
    }

    /// The functions beside `arm` and `step`.
    pub(super) fn in_flight(&mut self, start: &Expr) -> Vec<Function> {
        if self.flight().is_none() {
            return Vec::new();
        }
        let mut functions = vec![self.arm_for(start)];
        functions.extend(self.soonest());
        functions.push(self.deadline(start));
        functions.extend(self.corrections());
        functions
    }
}
