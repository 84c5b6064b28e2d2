//! The search for the soonest deadline: from samples to go that are tried first it doubles until the limits are kept,
//! and halves the distance to what does not keep them. Where a later deadline may not be kept either, it is the distance
//! from the planned one that grows, by half, so that a deadline shortly behind it is found. Each candidate is tested by itself and for each axis, so that
//! nothing depends on whether a later deadline is easier to keep.

use num_traits::ToPrimitive;

use super::super::controller::Builder;
use super::bounds::{TRIED, all_fit, fits};
use super::{Chain, longest, rest};
use crate::algebra::BigRational;
use crate::code::{Expr, For, Index, Place, Shape, Statement, Test};
use crate::internal::fault;

/// The samples to go that keep the limits; 0 without any.
pub(super) const KEPT: &str = "kept";

/// Rounds of the search: doublings and halvings of 30 bits.
const ROUNDS: usize = 64;

/// The part of the limits that a plan may take, and its name beside a table of gains, where another one has it.
const PART: &str = "part";
const SHARE: &str = "share";

/// Search for the number of samples to go.
pub(super) struct Search {
    /// The samples to go that are tried first.
    pub(super) first: Expr,
    /// The samples to go that are not allowed, and none below.
    pub(super) below: Expr,
    /// True if the first may be those of held gains.
    pub(super) held: bool,
    /// True if the first may take all of the limits; others leave the reserve.
    pub(super) keeps_first: bool,
}

/// Returns true if a state has a limit, so that a later deadline may be impossible to keep: what a state moves on the way
/// grows with the time that it takes.
fn are_bounded(chains: &[Chain]) -> bool {
    chains.iter().any(|chain| chain.horizon.bounds_states())
}

/// Statements that set the samples to go that are tried next; `near` if their distance from the first ones grows.
fn next(search: &Search, near: bool) -> Vec<Statement> {
    let [low, half] = ["low", "half"].map(Expr::local);
    let try_at = |more: Expr| {
        let next = low.clone().count_add(more);
        vec![Statement::Set(Place::Local(TRIED.to_owned()), next)]
    };
    if !near {
        let doubles = Test::CountLess(low.clone(), half.clone());
        return vec![Statement::If(doubles, try_at(low.clone()), try_at(half))];
    }
    let behind = low.clone().count_left(search.first.clone()).count_over(2);
    let more = Statement::Let("more".to_owned(), Shape::Count, behind.count_add(Expr::Count(1)));
    let nothing = Test::CountEqual(Expr::local(KEPT), Expr::Count(0));
    let grows = nothing.and(Test::CountLess(Expr::local("more"), half.clone()));
    vec![more, Statement::If(grows, try_at(Expr::local("more")), try_at(half))]
}

impl Builder<'_> {
    /// Statements that set `kept` from the flat coordinates.
    pub(super) fn search(&mut self, chains: &[Chain], search: Search) -> Vec<Statement> {
        let [all, planned] = self.parts(chains);
        let longest = longest(chains, self.spec.precision);
        let begin = |name: &str, value| Statement::Begin(name.to_owned(), Shape::Count, value);
        let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
        let [low, top, tried] = ["low", "top", TRIED].map(Expr::local);
        let mut body = vec![
            begin("low", search.below.clone()),
            begin("top", Expr::Count(longest + 1)),
            begin(KEPT, Expr::Count(0)),
            begin(TRIED, search.first.clone()),
        ];
        let name = if self.spec.schedule().is_some() { SHARE } else { PART };
        let part = match search.keeps_first {
            true => {
                body.push(Statement::Begin(name.to_owned(), Shape::Real, all));
                Expr::local(name)
            }
            false => planned.clone(),
        };
        let (mut round, limits) = self.plan_limits(chains, &part, search.held);
        round.extend(fits(chains, &limits, search.held));
        let rest = Expr::Count(rest(chains));
        let refused = match search.held {
            true => {
                let above = Test::CountLess(rest.clone(), tried.clone());
                vec![Statement::If(above, vec![set("low", tried.clone())], vec![set("low", rest)])]
            }
            false => vec![set("low", tried.clone())],
        };
        let kept = vec![set(KEPT, tried.clone()), set("top", tried)];
        round.push(Statement::If(all_fit(chains), kept, refused));
        let gap = top.count_left(low);
        round.push(Statement::Let("gap".to_owned(), Shape::Count, gap));
        let near = Test::CountLess(Expr::local("gap"), Expr::Count(2));
        round.push(Statement::If(near, vec![Statement::Leave], Vec::new()));
        round.push(Statement::Let(
            "half".to_owned(),
            Shape::Count,
            Expr::local("gap").count_over(2),
        ));
        round.extend(next(&search, search.keeps_first && are_bounded(chains)));
        if search.keeps_first {
            round.push(set(name, planned));
        }
        let [from, to] = [0, ROUNDS].map(Index::at);
        body.push(Statement::For(For::each("attempt", from, to, round)));
        body
    }

    /// The parts of the limits that a deadline may take which is to stay, and a new one: half of the slack lies
    /// between, so that a plan is not put off by its own rounding, and what the bounds of a table may grow on the way.
    pub(super) fn parts(&self, chains: &[Chain]) -> [Expr; 2] {
        let slack = chains.iter().map(|chain| chain.horizon.slack).fold(0.0, f64::max);
        let slack = slack * self.spec.precision.epsilon();
        let reserve = self.flight().and_then(|flight| flight.reserve.to_f64()).unwrap_or(0.0);
        let growth = chains.iter().map(|chain| chain.horizon.growth()).fold(1.0, f64::max);
        [1.0 - slack, (1.0 - 2.0 * slack) * (1.0 - reserve) / growth].map(|part| {
            let exact = BigRational::from_float(part);
            Expr::Number(exact.unwrap_or_else(|| fault("the rounding of a plan is no number")))
        })
    }
}
