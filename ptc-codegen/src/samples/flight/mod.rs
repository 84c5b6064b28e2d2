//! A deadline that changes while the controller runs: the field `last`, the planned number of samples from the start to
//! rest, and the functions that change it, the target and the estimates.
//!
//! `bounds` are the tests that a deadline keeps the limits, of the signals of `stretch` or the table of `rows`, `search` finds the soonest one,
//! `replan` puts a deadline off within `step`, `deadline` and `corrections` hold the functions. Several axes come to rest
//! at one sample: a deadline is tested for each of them.

mod bounds;
mod corrections;
mod deadline;
mod replan;
mod rows;
mod search;
mod stretch;

use super::controller::Builder;
use super::ends::Ending;
use crate::code::{Expr, Function, Shape, Statement};
use crate::internal::fault;
use crate::linear::Horizon;
use crate::parameter::Precision;
use crate::request::Flight;

/// The samples from the start to rest, as they are planned now.
pub(super) const LAST: &str = "last";

/// The samples of the observer's round that were left at the start.
pub(super) const ROUND: &str = "round";

/// The samples to go for which a plan is asked.
const AHEAD: &str = "ahead";

/// A chain with limits, whose deadline is planned.
struct Chain {
    /// The output or axis, where there are several.
    output: Option<usize>,
    /// The bounds of its signals.
    horizon: Horizon,
    /// Its flat coordinates; beside a table of gains the state from which the next input acts.
    flat: Vec<Expr>,
}

/// Samples to go at and below which the gains of a chain are held.
fn rest(chains: &[Chain]) -> u32 {
    chains.iter().map(|chain| chain.horizon.rest()).max().unwrap_or_default()
}

/// Most samples to a deadline that is planned.
fn longest(chains: &[Chain], precision: Precision) -> u32 {
    let each = chains.iter().map(|chain| chain.horizon.longest(precision));
    each.min().unwrap_or_default()
}

impl Builder<'_> {
    pub(super) fn flight(&self) -> Option<&Flight> {
        self.sampled.flight.as_ref()
    }

    /// The chains with limits, where deadlines are planned, and statements that set their coordinates.
    fn chains(&mut self) -> Option<(Vec<Statement>, Vec<Chain>)> {
        let each = self.of_each_law(|own| {
            let horizon = own.sampled.horizon(own.spec)?;
            if !own.has_limits() {
                return Some(None);
            }
            if let Some(table) = &horizon.table {
                own.add_bounds(table);
            }
            let (body, flat) = own.coordinates();
            Some(Some((body, Chain { output: own.output, horizon, flat })))
        });
        let each: Option<Vec<_>> = each.into_iter().collect();
        let (body, chains): (Vec<_>, Vec<_>) = each?.into_iter().flatten().unzip();
        Some((body.concat(), chains))
    }

    /// The chains of a controller that plans its deadline.
    fn planned_chains(&mut self) -> (Vec<Statement>, Vec<Chain>) {
        self.chains().unwrap_or_else(|| fault("a deadline without a plan"))
    }

    /// Returns true if u or a state has a limit.
    fn has_limits(&mut self) -> bool {
        let bounds = self.limits();
        let flight = self.flight();
        let of_state =
            (0..self.spec.n).any(|i| flight.is_some_and(|own| own.state_max(i).is_some()));
        bounds.least.is_some() || bounds.most.is_some() || of_state
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
        if self.spec.schedule().is_some() {
            return self.reached("q");
        }
        let flat = self.flat();
        let mut body = Vec::new();
        let mut all = Vec::new();
        for i in 0..flat.order() {
            let name = self.named(&format!("flat{}", i + 1));
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
