//! The loops over the powers of a series.

use super::{at, each, set, set_at};
use crate::code::{Expr, For, Index, Operator, Shape, Statement, Test};

pub(super) struct Rows {
    pub(super) weights: usize,
    pub(super) fused: bool,
}

impl Rows {
    /// `row` becomes the rows, by p and q = p^2 without the leading power.
    pub(super) fn body(&self, written: usize) -> Vec<Statement> {
        let mut body = self.square(written);
        let rounds = if written > 0 { self.written_out(written) } else { self.in_loops() };
        let tail = Index::at(self.weights - 1);
        let all = For { step: 2, ..For::each("round", Index::at(0), tail, rounds) };
        body.push(Statement::For(all));
        body
    }

    /// q, as long as p, so that one may stand for the other: its last element is not needed.
    fn square(&self, written: usize) -> Vec<Statement> {
        let (tail, part) = (self.weights - 1, self.weights - 2);
        let mut body = vec![Statement::Variable("q".to_owned(), Shape::Reals(tail))];
        let twice = |k: Index| Expr::binary(Operator::Add, at("p", k.clone()), at("p", k));
        let short = part.min(written + 1);
        for k in 0..short {
            body.push(set_at("q", Index::at(k), twice(Index::at(k))));
            body.extend((0..k).map(|m| {
                let [a, b] = [m, k - m - 1].map(|place| at("p", Index::at(place)));
                set_at("q", Index::at(k), self.more(at("q", Index::at(k)), a, b))
            }));
        }
        if short < part {
            let [k, m] = ["k", "m"].map(Index::of);
            let [a, b] = [m.clone(), k.clone() - m - Index::at(1)].map(|place| at("p", place));
            let sum = vec![set("v", self.more(Expr::local("v"), a, b))];
            body.push(each(
                "k",
                Index::at(short),
                Index::at(part),
                vec![
                    begin("v", twice(k.clone())),
                    each("m", Index::at(0), k.clone(), sum),
                    set_at("q", k, Expr::local("v")),
                ],
            ));
        }
        body
    }

    /// The sum at `k`, by the power that `power` holds.
    fn sum(&self, [sum, power]: [&str; 2], k: &Index) -> Vec<Statement> {
        let behind = k.clone() + Index::at(1);
        let m = Index::of("m");
        let [a, b] = [at(power, m.clone() - behind.clone()), at("row", m)];
        let more = vec![set(sum, self.more(Expr::local(sum), a, b))];
        vec![
            begin(sum, at("row", k.clone())),
            each("m", behind, Index::at(self.weights), more),
            set_at("row", k.clone(), Expr::local(sum)),
        ]
    }

    /// A round: the first sum by p, all others by q.
    fn in_loops(&self) -> Vec<Statement> {
        let (first, k) = (Index::of("round"), Index::of("k"));
        let mut round = self.sum(["v", "p"], &first);
        let behind = first + Index::at(1);
        let others = self.sum(["w", "q"], &k);
        round.push(each("k", behind, Index::at(self.weights - 1), others));
        round
    }

    /// A round, of which sums of up to `written` products are written out, for all rounds that have them.
    fn written_out(&self, written: usize) -> Vec<Statement> {
        let tail = self.weights - 1;
        let view = |array: &str, first| Statement::View {
            name: "f".to_owned(),
            array: array.to_owned(),
            first,
        };
        let long = tail.saturating_sub(written).next_multiple_of(2);
        // Without a further sum in the round, f would always be p.
        let changes = tail > 2 || long > 0;
        let power = if changes { "f" } else { "p" };
        let mut round: Vec<_> = changes.then(|| view("p", true)).into_iter().collect();
        if long > 0 {
            let mut sum = self.sum(["v", power], &Index::of("k"));
            sum.push(view("q", false));
            round.push(each("k", Index::of("round"), Index::at(long), sum));
        }
        for at in (long..tail).step_by(2) {
            let both = [("v", power, at), ("w", "q", at + 1)].into_iter();
            let mut pair: Vec<_> = both
                .filter(|(.., at)| *at < tail)
                .flat_map(|(sum, power, at)| self.written_sum([sum, power], at))
                .collect();
            // No round is behind the last sums.
            if at + 2 >= tail {
                round.extend(pair);
                continue;
            }
            pair.push(view("q", false));
            let own = Expr::local("round");
            let test = match u32::try_from(at).unwrap_or(u32::MAX) {
                0 => Test::CountEqual(own, Expr::Count(0)),
                at => Test::CountLess(own, Expr::Count(at + 2)),
            };
            round.push(Statement::If(test, pair, Vec::new()));
        }
        round
    }

    fn written_sum(&self, [sum, power]: [&str; 2], k: usize) -> Vec<Statement> {
        let mut all = vec![begin(sum, at("row", Index::at(k)))];
        all.extend((k + 1..self.weights).map(|m| {
            let [a, b] = [at(power, Index::at(m - k - 1)), at("row", Index::at(m))];
            set(sum, self.more(Expr::local(sum), a, b))
        }));
        all.push(set_at("row", Index::at(k), Expr::local(sum)));
        all
    }

    /// sum + a b.
    fn more(&self, sum: Expr, a: Expr, b: Expr) -> Expr {
        match self.fused {
            true => Expr::Fused(Box::new([a, b, sum])),
            false => Expr::binary(Operator::Add, sum, Expr::binary(Operator::Mul, a, b)),
        }
    }
}

fn begin(name: &str, value: Expr) -> Statement {
    Statement::Begin(name.to_owned(), Shape::Real, value)
}
