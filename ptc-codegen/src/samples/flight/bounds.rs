//! The tests that a deadline keeps all limits, from the flat coordinates and the samples to go.

use std::ops::{Add, Mul, Neg};

use super::super::controller::Builder;
use super::super::predicted::weighted;
use super::Chain;
use super::rows::within;
use super::stretch::Writer;
use crate::algebra::BigRational;
use crate::code::{Expr, Place, Shape, Statement, Test};
use crate::expression::Function;
use crate::linear::{Bound, Horizon, Signal};

/// The samples to go that are tried.
pub(super) const TRIED: &str = "tried";

/// The number of chains, one after the other, whose limits are kept.
const FITS: &str = "fits";

/// The limits of the signals, as statements have set them.
pub(super) struct Limits {
    /// Lower and upper limit of the law.
    input: [Option<Expr>; 2],
    /// The smaller of their distances from 0.
    within: Option<Expr>,
    /// True if the limits of the law are one another's opposite, so that a size decides both.
    is_even: bool,
    /// The bounds of the states.
    states: Vec<Option<Expr>>,
}

impl Limits {
    /// Tests that a value of a signal is within its limits.
    pub(super) fn admit(&self, signal: Signal, value: &Expr) -> Vec<Test> {
        let [least, most] = match signal {
            Signal::Input => self.input.clone(),
            Signal::State(i) => {
                let most = self.states[i].clone();
                [most.clone().map(Neg::neg), most]
            }
        };
        let least = least.map(|least| Test::AtMost(least, value.clone()));
        let most = most.map(|most| Test::AtMost(value.clone(), most));
        least.into_iter().chain(most).collect()
    }

    /// Tests that a bound keeps the limits of its signal, with `set` to name a value that is used twice.
    pub(super) fn admit_bound(
        &self,
        bound: &Bound,
        value: Expr,
        set: &mut dyn FnMut(Expr) -> Expr,
    ) -> Vec<Test> {
        if bound.is_signed && !self.decides_by_size(bound.signal) {
            self.admit(bound.signal, &set(value))
        } else {
            self.admit_size(bound.signal, &bound.share, value)
        }
    }

    /// Returns true if a size decides both limits of a signal.
    fn decides_by_size(&self, signal: Signal) -> bool {
        signal != Signal::Input || self.is_even
    }

    /// Tests that the size of a sum is within a share of the limits of its signal.
    pub(super) fn admit_size(&self, signal: Signal, share: &BigRational, value: Expr) -> Vec<Test> {
        let limit = match signal {
            Signal::Input => self.within.clone(),
            Signal::State(i) => self.states[i].clone(),
        };
        let size = || Expr::Call(Function::Abs, Box::new(value.clone()));
        let share = |limit: Expr| Expr::Number(share.clone()).mul(limit);
        limit.map(|limit| Test::AtMost(size(), share(limit))).into_iter().collect()
    }
}

impl Builder<'_> {
    /// The limits of each chain, a part of those of the design: what roundings and the reserve leave; and statements that
    /// set them. `held` if the samples to go may be those of held gains.
    pub(super) fn plan_limits(
        &mut self,
        chains: &[Chain],
        part: &Expr,
        held: bool,
    ) -> (Vec<Statement>, Vec<Limits>) {
        let each = self.of_each_law(|own| {
            let chain = chains.iter().find(|chain| chain.output == own.output)?;
            Some(own.limits_of_chain(&chain.horizon, part, held))
        });
        let (body, limits): (Vec<_>, Vec<_>) = each.into_iter().flatten().unzip();
        (body.concat(), limits)
    }

    fn limits_of_chain(
        &mut self,
        horizon: &Horizon,
        part: &Expr,
        held: bool,
    ) -> (Vec<Statement>, Limits) {
        let offset = self.offset();
        let bounds = self.limits();
        let is_even = bounds.is_symmetric() && offset.is_zero();
        let mut body = Vec::new();
        let mut named = |name: String, value: Expr| {
            body.push(Statement::Let(name.clone(), Shape::Real, value));
            Expr::local(name)
        };
        let scaled = |limit: &Expr| limit.clone().mul(part.clone()).add(offset.clone());
        let [least, most, within] = ["least", "most", "within"].map(|name| self.named(name));
        let least = bounds.least.as_ref().map(|limit| named(least, scaled(limit)));
        let most = bounds.most.as_ref().map(|limit| named(most, scaled(limit)));
        let within = match (least.clone(), most.clone()) {
            _ if !sizes(horizon, held, is_even) => None,
            (_, most) if is_even => most,
            (Some(least), Some(most)) => {
                let below = least.neg();
                let test = Test::Less(below.clone(), most.clone());
                Some(named(within, Expr::choose(test, below, most)))
            }
            (least, most) => most.or_else(|| least.map(Neg::neg)),
        };
        let states = (0..self.spec.n).map(|i| {
            let bound = self.flight().and_then(|flight| flight.state_max(i)).cloned();
            let name = self.named(&format!("most{}", i + 1));
            bound.map(|bound| named(name, Expr::Number(bound).mul(part.clone())))
        });
        let states = states.collect();
        (body, Limits { input: [least, most], within, is_even, states })
    }
}

/// Statements that set `fits` for the samples to go that are tried; `held` if they may be those of held gains. A chain is
/// tested only if those before it keep their limits.
pub(super) fn fits(chains: &[Chain], limits: &[Limits], held: bool) -> Vec<Statement> {
    let mut body = vec![Statement::Begin(FITS.to_owned(), Shape::Count, Expr::Count(0))];
    for (before, (chain, limits)) in (0..).zip(chains.iter().zip(limits)) {
        let tests = tests(chain, limits, held, before);
        if before == 0 {
            body.extend(tests);
        } else {
            let kept = Test::CountEqual(Expr::local(FITS), Expr::Count(before));
            body.push(Statement::If(kept, tests, Vec::new()));
        }
    }
    body
}

/// Tests that all chains keep their limits.
pub(super) fn all_fit(chains: &[Chain]) -> Test {
    let count = u32::try_from(chains.len()).unwrap_or(u32::MAX);
    Test::CountEqual(Expr::local(FITS), Expr::Count(count))
}

/// Statements that add a chain to `fits`, which is the number of those before it.
fn tests(chain: &Chain, limits: &Limits, held: bool, before: u32) -> Vec<Statement> {
    let horizon = &chain.horizon;
    let tried = || Expr::local(TRIED);
    let mut all = match held {
        true => {
            let mut writer = Writer::new(chain.output);
            let mut tests = Vec::new();
            for bound in &horizon.held {
                let value = weighted(&bound.row, &|i| chain.flat[i].clone());
                tests.extend(limits.admit_bound(bound, value, &mut |value| writer.end(value)));
            }
            [writer.body, settle(tests, before)].concat()
        }
        false => Vec::new(),
    };
    if let Some(table) = &horizon.table {
        let (mut own, test) = within(table, &chain.flat, limits);
        own.extend(settle(vec![test], before));
        return match held {
            true => {
                let above = Test::CountLess(Expr::Count(table.rest), tried());
                vec![Statement::If(above, own, all)]
            }
            false => own,
        };
    }
    for stretch in horizon.stretches.iter().rev() {
        let mut writer = Writer::new(chain.output);
        let tests = writer.within(stretch, &chain.flat, limits);
        let own = [writer.body, settle(tests, before)].concat();
        all = match all.is_empty() {
            true => own,
            false => {
                let above = Test::CountLess(Expr::Count(stretch.above), tried());
                vec![Statement::If(above, own, all)]
            }
        };
    }
    all
}

/// Returns true if u is bounded by its size.
fn sizes(horizon: &Horizon, held: bool, is_even: bool) -> bool {
    let behind = horizon.stretches.iter().flat_map(|stretch| &stretch.behind);
    let of_held = horizon.held.iter().filter(|_| held);
    let by_size = behind.chain(of_held).filter(|bound| is_even || !bound.is_signed);
    let of_table = horizon.table.iter().flat_map(|table| &table.signals).map(|own| own.signal);
    by_size.map(|bound| bound.signal).chain(of_table).any(|own| own == Signal::Input)
}

/// The statement that adds a chain to `fits` where all tests hold.
fn settle(tests: Vec<Test>, before: u32) -> Vec<Statement> {
    let set = Statement::Set(Place::Local(FITS.to_owned()), Expr::Count(before + 1));
    vec![Statement::If(Test::All(tests), vec![set], Vec::new())]
}
