//! A filter: u as near to that of any controller as the bounds of the states allow.
//!
//! A sample is safe if it lies in the cone of [`crate::request::Keep`], as far as that is known. There u is held to the last
//! member q_m of each chain, which keeps the next sample in it. Elsewhere u is held to the law that brings the state
//! back to its bounds within the samples of `tau` too.

use std::ops::{Add, Div, Mul, Sub};

use super::controller::Builder;
use super::rows::rows_of_least_energy;
use crate::algebra::{BigRational, integer};
use crate::code::{
    Access, Expr, Finish, Function, NOMINAL, Owner, Place, Shape, Statement, Status, Test, Variable,
};
use crate::linear::power_of_period;
use crate::request::{Edge, Keep, product_of_rates};

/// The u that is given.
const GIVEN: &str = "u_now";

/// The tick of the last safe sample, or of the start.
const SINCE: &str = "since";

/// 1 in a safe sample, else 0.
const SAFE: &str = "safe";

/// The chain of a state with bounds: z_i, ..., z_n, u.
struct Chain {
    /// Its state, from 0.
    i: usize,
    /// Its order.
    m: usize,
    /// Bounds in units of z, where they are, with their names and their tolerance.
    edges: Vec<(Edge, BigRational)>,
    /// The tolerance of these bounds in units of z.
    tolerance: BigRational,
    /// The rates of its cone.
    rates: Vec<BigRational>,
}

impl Chain {
    /// The name of the limit of u that follows from a bound.
    fn limit(&self, edge: Edge) -> String {
        let side = if edge == Edge::Below { "high" } else { "low" };
        format!("{side}{}", self.i + 1)
    }

    /// The name of q_j.
    fn member(&self, j: usize) -> String {
        match j {
            0 => format!("z{}", self.i + 1),
            _ => format!("q{}_{j}", self.i + 1),
        }
    }

    /// a_i ... a_{i+j-1}.
    fn scale(&self, j: usize) -> BigRational {
        self.rates[..j].iter().fold(integer(1), |product, rate| product * rate)
    }

    /// Statements of q_1, ..., q_m, the last one without u.
    fn members(&self) -> impl Iterator<Item = Statement> + '_ {
        (1..=self.m).map(|j| {
            let factors = product_of_rates(&self.rates[..j]);
            let terms =
                factors.iter().enumerate().filter(|(k, _)| j - k < self.m).map(|(k, factor)| {
                    let z = Expr::local(format!("z{}", self.i + j - k + 1));
                    if k == 0 { z } else { Expr::Number(factor.clone()).mul(z) }
                });
            Statement::Let(self.member(j), Shape::Real, Expr::sum(terms))
        })
    }

    /// Tests that hold where the state is safe.
    fn tests(&self) -> impl Iterator<Item = Test> + '_ {
        let members = (0..self.m).map(|j| (Expr::local(self.member(j)), self.scale(j)));
        members.flat_map(move |(member, scale)| {
            self.edges.iter().map(move |(edge, bound)| match edge {
                Edge::Below => {
                    Test::AtMost(member.clone(), Expr::Number((bound + &self.tolerance) * &scale))
                }
                Edge::Above => {
                    Test::AtMost(Expr::Number((bound - &self.tolerance) * &scale), member.clone())
                }
            })
        })
    }
}

impl Builder<'_> {
    /// The function `step`.
    pub(super) fn filter(&mut self, keep: &Keep, start: &Expr) -> Function {
        let (body, finish) = self.filtered(keep, start);
        let n = self.spec.n;
        let once = if self.remembered() > 0 { " Call it once for each tick." } else { "" };
        Function {
            name: "step",
            about: format!(
                "u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may wrap, and {}.{once}",
                self.given()
            ),
            owner: Owner::Controller,
            access: Access::Change,
            arguments: vec![
                Variable::new("k", Shape::Count, "tick"),
                Variable::new("x", Shape::Reals(n), self.given()),
                Variable::new(NOMINAL, Shape::Real, "u of the controller that is filtered"),
            ],
            callbacks: Vec::new(),
            results: vec![Variable::new("u", Shape::Real, "input of the plant")],
            failures: match self.guarded() {
                true => vec![Status::Input, Status::Range],
                false => vec![Status::Range],
            },
            body,
            finish,
            guarded: self.guarded(),
        }
    }

    /// The statements of `step`, and its end.
    fn filtered(&mut self, keep: &Keep, start: &Expr) -> (Vec<Statement>, Finish) {
        let n = self.spec.n;
        let nominal = Expr::local(NOMINAL);
        let mut body: Vec<_> = self.legal("x", n, vec![nominal.clone()]).into_iter().collect();
        self.remember_inputs(1);
        let states = self.states("x").into_iter().zip(1..);
        body.extend(states.map(|(value, j)| Statement::Let(format!("x{j}"), Shape::Real, value)));
        let flat = self.flat();
        for i in 0..n {
            // In units of x_i over g, in which the chain of its bound has u with weight 1.
            let power = i64::try_from(n - i).unwrap_or(0);
            let unit = power_of_period(self.spec.period_of_filter(), power);
            let value = self.flat_coordinate_times(&unit, &flat, i);
            body.push(Statement::Let(format!("z{}", i + 1), Shape::Real, value));
        }
        let chains = self.chains_of(keep);
        body.push(Statement::Note("The limits of u that keep a safe state safe.".to_owned()));
        for chain in &chains {
            body.extend(chain.members());
            body.extend(self.limits_of(chain));
        }
        body.extend(self.outside(keep, &chains, start));
        body.push(Statement::Note("u within them, the bounds of x1 last.".to_owned()));
        body.extend(self.clipped(&chains));
        let finite = Test::Finite(Expr::local(GIVEN));
        let finite = std::iter::once(finite).chain(chains.iter().flat_map(limits_are_finite));
        body.push(Statement::Require(Test::All(finite.collect()), Status::Range));
        let finish = self.status(&chains);
        body.extend(self.shift_inputs(&Expr::local(GIVEN)));
        body.push(Statement::Set(Place::Field("start".to_owned()), Expr::local(SINCE)));
        (body, finish)
    }

    /// The chains of the states with bounds, in the order of precedence.
    fn chains_of(&self, keep: &Keep) -> Vec<Chain> {
        let (n, gain) = (self.spec.n, &self.sampled.gain);
        let rates = keep.rates(self.spec.period_of_filter());
        let chain = |i: usize| {
            // z is in units of x/g, so that a negative g exchanges the bounds.
            let turned = *gain < integer(0);
            let edges = [Edge::Above, Edge::Below].into_iter().filter_map(|edge| {
                let own = if turned { edge.other() } else { edge };
                Some((edge, keep.bound(i, own)? / gain))
            });
            let size = if turned { -gain } else { gain.clone() };
            Chain {
                i,
                m: n - i,
                edges: edges.collect(),
                tolerance: keep.tolerance(i, self.spec.precision) / size,
                rates: rates[i..].to_vec(),
            }
        };
        (0..n).filter(|i| keep.is_bounded(*i)).map(chain).collect()
    }

    /// The limits of u by the cone of a chain.
    fn limits_of(&mut self, chain: &Chain) -> Vec<Statement> {
        let offset = self.offset();
        let limit = |(edge, bound): &(Edge, BigRational)| {
            let most = Expr::Number(bound * chain.scale(chain.m)).sub(offset.clone());
            let value = most.sub(Expr::local(chain.member(chain.m)));
            Statement::Begin(chain.limit(*edge), Shape::Real, value)
        };
        chain.edges.iter().map(limit).collect()
    }

    /// A sample that is safe begins to count anew; in any other one u is held to the law of return too.
    fn outside(&mut self, keep: &Keep, chains: &[Chain], start: &Expr) -> Vec<Statement> {
        let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
        let tests = chains.iter().flat_map(Chain::tests).collect();
        let count = u32::try_from(self.sampled.delay.inputs()).unwrap_or(u32::MAX);
        let elapsed = Expr::local("k").count_sub(Expr::local(SINCE));
        let left = self.asked().count_left(Expr::Count(count)).count_left(elapsed).real();
        let mut returns = vec![
            set(SAFE, Expr::Count(0)),
            Statement::Note("Outside: u is held to the law of return too.".to_owned()),
            Statement::Let("left".to_owned(), Shape::Real, left),
        ];
        for chain in chains {
            returns.extend(self.law_of_return(keep, chain));
        }
        vec![
            Statement::Begin(SINCE.to_owned(), Shape::Count, start.clone()),
            Statement::Begin(SAFE.to_owned(), Shape::Count, Expr::Count(1)),
            Statement::If(Test::All(tests), vec![set(SINCE, Expr::local("k"))], returns),
        ]
    }

    /// The law of least energy of the chain of a state less its bound, as a limit of u.
    fn law_of_return(&mut self, keep: &Keep, chain: &Chain) -> Vec<Statement> {
        let (m, name) = (chain.m, |letter: &str| format!("{letter}{}", chain.i + 1));
        let h = self.spec.period_of_filter().clone();
        let offset = self.offset();
        let shift = i64::from(keep.law.shift(m));
        let rows: Vec<_> = rows_of_least_energy(keep.law, m)
            .into_iter()
            .zip(0..)
            .map(|(row, j)| row * power_of_period(&h, j - i64::try_from(m).unwrap_or(0)))
            .collect();
        // From m samples to go on the gains are those of deadbeat.
        let whole = i64::try_from(m).unwrap_or(0);
        let to_go = Expr::local("left").max(Expr::integer(whole));
        let mut body = vec![Statement::Let(name("t"), Shape::Real, to_go)];
        let divisor = |j: i64| Expr::local(name("t")).add(Expr::integer(shift - j));
        let law = rows.iter().zip(0..).fold(Expr::integer(0), |sum, (row, j)| {
            let z = Expr::local(format!("z{}", chain.i + 1 + usize::try_from(j).unwrap_or(0)));
            sum.add(Expr::Number(row.clone()).mul(z)).div(divisor(j))
        });
        let weight = (0..whole).fold(Expr::Number(rows[0].clone()), |sum, j| sum.div(divisor(j)));
        body.push(Statement::Let(name("law"), Shape::Real, law.sub(offset)));
        body.push(Statement::Let(name("weight"), Shape::Real, weight));
        for (edge, bound) in &chain.edges {
            let back = format!("{}_back", chain.limit(*edge));
            let value = Expr::local(name("law"))
                .sub(Expr::local(name("weight")).mul(Expr::Number(bound.clone())));
            body.push(Statement::Let(back.clone(), Shape::Real, value));
            let (limit, back) = (Expr::local(chain.limit(*edge)), Expr::local(back));
            let nearer = match edge {
                Edge::Below => Test::Less(back.clone(), limit),
                Edge::Above => Test::Less(limit, back.clone()),
            };
            let set = Statement::Set(Place::Local(chain.limit(*edge)), back);
            body.push(Statement::If(nearer, vec![set], Vec::new()));
        }
        body
    }

    /// u, clipped to the limits of the chains, the first of them last, and then to its own.
    fn clipped(&mut self, chains: &[Chain]) -> Vec<Statement> {
        let (u, nominal) = (Expr::local(GIVEN), Expr::local(NOMINAL));
        let set = |value: Expr| vec![Statement::Set(Place::Local(GIVEN.to_owned()), value)];
        let mut body = vec![Statement::Begin(GIVEN.to_owned(), Shape::Real, nominal)];
        for chain in chains.iter().rev() {
            for (edge, _) in &chain.edges {
                let limit = Expr::local(chain.limit(*edge));
                let test = beyond(*edge, &u, &limit);
                body.push(Statement::If(test, set(limit), Vec::new()));
            }
        }
        let own: Vec<_> = self.limits().beyond(&u).collect();
        body.extend(
            own.into_iter().map(|(test, limit)| Statement::If(test, set(limit), Vec::new())),
        );
        body
    }

    /// The end of `step`.
    fn status(&self, chains: &[Chain]) -> Finish {
        let (u, nominal) = (Expr::local(GIVEN), Expr::local(NOMINAL));
        let give = |status| Finish::give(vec![u.clone()], status);
        let clipped = Finish::choose(
            Test::Less(u.clone(), nominal.clone()),
            give(Status::Saturated),
            Finish::choose(
                Test::Less(nominal, u.clone()),
                give(Status::Saturated),
                give(Status::Ok),
            ),
        );
        // A state that is safe up to the tolerance stays so within limits that are as much wider.
        let limits = chains.iter().flat_map(|chain| {
            let wider = Expr::Number(&chain.tolerance * chain.scale(chain.m));
            chain.edges.iter().map(move |(edge, _)| {
                let limit = Expr::local(chain.limit(*edge));
                match edge {
                    Edge::Below => (*edge, limit.add(wider.clone())),
                    Edge::Above => (*edge, limit.sub(wider.clone())),
                }
            })
        });
        let kept = limits.fold(clipped, |kept, (edge, limit)| {
            Finish::choose(beyond(edge, &u, &limit), give(Status::Infeasible), kept)
        });
        let unsafe_ = Test::CountEqual(Expr::local(SAFE), Expr::Count(0));
        Finish::choose(unsafe_, give(Status::Infeasible), kept)
    }
}

/// Holds where u is beyond a limit.
fn beyond(edge: Edge, u: &Expr, limit: &Expr) -> Test {
    match edge {
        Edge::Below => Test::Less(limit.clone(), u.clone()),
        Edge::Above => Test::Less(u.clone(), limit.clone()),
    }
}

/// Limits that are no numbers would not clip.
fn limits_are_finite(chain: &Chain) -> impl Iterator<Item = Test> + '_ {
    chain.edges.iter().map(|(edge, _)| Test::Finite(Expr::local(chain.limit(*edge))))
}
