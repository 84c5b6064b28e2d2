//! e^(At) e_n =: phi, what an impulse makes of xi: around the nodes of the flow, and at all times from
//! one on.
//!
//! Each component of phi is the derivative of the one before, so that phi_1, phi_2, ... at a node,
//! continued by the last row of A phi and its derivatives, are the Taylor coefficients of them all.
//! Bounds are formed for each component alone: where the gains are far from 1 in the units of the flow
//! the components differ by powers of ten, and one norm of all of them says little of the smallest.

use std::rc::Rc;

use super::flow::{Flow, Rows, dot};
use crate::expression::enclosure::Range;

/// Nodes of the flow in a piece of lags for each order, and most of them. The poles have the sum k_n, and
/// a mean of at most |A|/n: the higher the order, the slower is phi beside the flow.
const NODES: usize = 4;
const MOST: usize = 16;

/// Order up to which phi is taken around a node.
pub(super) const TERMS: usize = 8;

/// Order up to which its coefficients are known; what is beyond them is next to nothing in any norm.
pub(super) const LAST: usize = 24;

/// Most pieces over which phi is looked at.
const LONGEST: usize = 8192;

/// Powers of 2 by which phi has to fall in a period of its bounds, if it can.
const STEEP: f64 = 16.0;

/// Powers of 2 beyond which it is not said to fall.
const FALLEN: f64 = 900.0;

/// phi is looked at until all of it is at most this part of its greatest.
const FADED: f64 = 1.0 / (1_u64 << 60) as f64;

/// phi around a node, for xi_1..xi_n and the last row of A phi after them.
pub(super) struct Impulse {
    /// The Taylor coefficients of each, up to the order `LAST`.
    pub(super) terms: Rows,
    /// The greatest |phi_j| at the node.
    size: Range,
}

/// Bounds of |phi_1|..|phi_n| and of the size of the last row of A phi.
pub(super) struct Tail {
    /// At all times from the start of each piece on, and at last from the end of them.
    from: Rows,
    /// In as many pieces what is left after all of these falls by as many powers of 2.
    period: usize,
    octaves: f64,
}

impl Flow {
    /// Nodes in a piece of lags.
    fn nodes(&self) -> u32 {
        let nodes = (NODES * self.gains.len()).min(MOST);
        u32::try_from(nodes).unwrap_or(u32::MAX)
    }

    /// The length of a piece of lags.
    pub(super) fn length(&self) -> f64 {
        self.step() * f64::from(self.nodes())
    }

    /// phi around the middle of a piece of lags.
    pub(super) fn impulse_of(&mut self, piece: u64) -> Rc<Impulse> {
        let nodes = u64::from(self.nodes());
        self.impulse(piece * nodes + nodes / 2)
    }

    /// phi around the node k.
    pub(super) fn impulse(&mut self, k: u64) -> Rc<Impulse> {
        if let Some(known) = self.impulses.get(&k) {
            return known.clone();
        }
        let n = self.gains.len();
        let mut chain: Vec<Range> = match k {
            0 => (1..=n).map(|j| Range::from(f64::from(u8::from(j == n)))).collect(),
            k => {
                let node = self.node(k);
                (0..n).map(|j| node.entry(j, n - 1)).collect()
            }
        };
        let size = chain.iter().map(|entry| entry.size()).fold(Range::from(0.0), |a, b| a.most(&b));
        for at in 0..=LAST {
            chain.push(-dot(&self.gains, &chain[at..at + n]));
        }
        let row = |j: usize| {
            let mut factorial = 1.0;
            let term = |(l, entry): (u32, &Range)| {
                factorial *= f64::from(l.max(1));
                *entry / Range::from(factorial)
            };
            (0..).zip(&chain[j..=j + LAST]).map(term).collect()
        };
        let impulse = Rc::new(Impulse { terms: (0..=n).map(row).collect(), size });
        self.impulses.insert(k, impulse.clone());
        impulse
    }

    /// Bounds of what the Taylor polynomials of an order below `order` leave of each component, at all
    /// times at most `away` from the node: the terms from there on, and after `LAST` of them
    /// |A|^k |y|^k/k! e^(|A| |y|) |phi|, with |A| once more for the last row.
    pub(super) fn rest(&self, impulse: &Impulse, order: usize, away: Range) -> Vec<Range> {
        let away = away.size();
        let reach = self.norm * away;
        let mut beyond = impulse.size * Range::from(reach.high().exp() * (1.0 + 1e-12));
        for k in 1..=LAST + 1 {
            beyond = beyond * reach / Range::from(f64::from(u32::try_from(k).unwrap_or(u32::MAX)));
        }
        let power = away.whole_power(i32::try_from(order).unwrap_or(i32::MAX));
        let count = impulse.terms.len();
        let one = |(j, terms): (usize, &Vec<Range>)| {
            let from = terms.iter().skip(order).rev();
            let sum = from.fold(Range::from(0.0), |sum, term| sum * away + term.size());
            let beyond = if j + 1 == count { beyond * self.norm } else { beyond };
            (sum * power + beyond).size()
        };
        impulse.terms.iter().enumerate().map(one).collect()
    }

    /// Bounds of |phi_1|.. at all times from a lag on; `None` where phi falls too slowly.
    pub(super) fn ever_after(&mut self, lag: f64) -> Option<Vec<Range>> {
        if self.tail.is_none() {
            self.tail = Some(self.tail().map(Rc::new));
        }
        let tail = self.tail.clone()??;
        // Half a node less holds what the lag was rounded by.
        let place = ((lag - 0.5 * self.step()) / self.length()).floor().max(0.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let piece = if place < 1e12 { place as usize } else { 0 };
        let end = tail.from.len() - 1;
        #[allow(clippy::cast_precision_loss)]
        let periods = (piece.saturating_sub(end) / tail.period) as f64;
        let part = Range::from((-periods * tail.octaves).max(-FALLEN).exp2());
        Some(tail.from[piece.min(end)].iter().map(|bound| *bound * part).collect())
    }

    /// The bounds over pieces until phi has faded.
    ///
    /// Let |phi| <= u for each component over a time as long as `period`, and |E| u <= q u with
    /// E = e^(A period). As phi(t + period) = E phi(t), |phi| <= q u over the next such time, q^2 u over
    /// that after it, and so on; the same holds of c u for any c > 0, and of phi', which has the same A.
    /// q is a power of 2: a small one, if there is one, as what is lost of it counts in each period.
    fn tail(&mut self) -> Option<Tail> {
        let n = self.gains.len();
        let half = Range::from(0.5 * self.length());
        let mut over = Rows::new();
        let look = |flow: &mut Self, over: &mut Rows| {
            let piece = u64::try_from(over.len()).unwrap_or(u64::MAX);
            let impulse = flow.impulse_of(piece);
            over.push(flow.rest(&impulse, 0, half));
        };
        let greatest = |over: &[Vec<Range>]| -> Vec<Range> {
            let column =
                |j: usize| over.iter().map(|row| row[j]).fold(Range::from(0.0), |a, b| a.most(&b));
            (0..=n).map(column).collect()
        };
        let (mut period, mut best) = (8, None);
        while period < LONGEST {
            period *= 2;
            while over.len() < period {
                look(self, &mut over);
            }
            let most = greatest(&over);
            let node = self.node(u64::try_from(period).ok()? * u64::from(self.nodes()));
            let falls = |of: &[Range]| {
                let part = |j: usize| {
                    let row: Vec<_> = (0..n).map(|i| node.entry(j, i).size()).collect();
                    dot(&row, of) / of[j]
                };
                (0..n).map(part).fold(Range::from(0.0), |a, b| a.most(&b)).high()
            };
            // What the logarithm is rounded by is less than what is cut off, or the bound is not used.
            let octaves = (-falls(&most[..n]).max(falls(&most[1..])).log2() - 1e-9).floor();
            if octaves >= 1.0 {
                best = Some((period, octaves, most));
            }
            if octaves >= STEEP {
                break;
            }
        }
        let (period, octaves, most) = best?;
        // The greatest part of u that phi has over the last period.
        let left = |over: &Rows| {
            let late = greatest(&over[over.len() - period..]);
            let parts = late.iter().zip(&most).map(|(late, most)| *late / *most);
            parts.fold(Range::from(0.0), |a, b| a.most(&b))
        };
        while over.len() < LONGEST && left(&over).high() > FADED {
            for _ in 0..period.min(LONGEST - over.len()) {
                look(self, &mut over);
            }
        }
        let part = left(&over) * Range::from((-octaves).exp2());
        let mut after: Vec<Range> = most.iter().map(|most| *most * part).collect();
        let mut from = vec![after.clone()];
        for row in over.iter().rev() {
            after = after.iter().zip(row).map(|(after, own)| after.most(own)).collect();
            from.push(after.clone());
        }
        from.reverse();
        Some(Tail { from, period, octaves })
    }
}

#[cfg(test)]
mod tests {
    use num_traits::ToPrimitive;

    use super::super::piece::polynomial;
    use super::*;
    use crate::algebra::integer;

    /// phi_1.. and the last row of A phi at a time in units of the flow, for poles -1, -3 and -40.
    fn exact(rate: f64, t: f64) -> [f64; 4] {
        let poles = [1.0, 3.0, 40.0].map(|pole| pole / rate);
        let mut phi = [0.0; 4];
        for (i, pole) in poles.iter().enumerate() {
            let others = poles.iter().enumerate().filter(|(j, _)| *j != i);
            let share = others.map(|(_, other)| 1.0 / (other - pole)).product::<f64>();
            for (k, phi) in (0..).zip(&mut phi) {
                *phi += share * (-pole).powi(k) * (-pole * t).exp();
            }
        }
        phi
    }

    fn flow() -> (Flow, f64) {
        let flow = Flow::new(&[integer(120), integer(163), integer(44)]).expect("usual gains");
        let rate = flow.rate.to_f64().expect("a power of two");
        (flow, rate)
    }

    #[test]
    fn impulse_tail_bounds_are_tight_per_component() {
        let (mut flow, rate) = flow();
        let length = flow.length();
        for piece in [0.0, 1.0, 7.0, 40.0, 300.0, 4000.0] {
            // From the start of the piece that holds the lag.
            let lag = piece * length;
            let bounds = flow.ever_after(lag + 0.5 * length).expect("it falls");
            let later = (0..4000).map(|i| exact(rate, lag + f64::from(i) * 0.05 * length));
            let most = later.reduce(|a, b| [0, 1, 2, 3].map(|j| a[j].abs().max(b[j].abs())));
            for (most, bound) in most.expect("many").iter().zip(bounds) {
                // What has faded in doubles has an error of its own.
                assert!(*most <= bound.high() + 1e-13, "{piece}: {most} > {}", bound.high());
                assert!(bound.high() <= 3.0 * most + 1e-13, "{piece}: {} for {most}", bound.high());
            }
        }
    }

    #[test]
    fn rest_bounds_the_truncation_error_of_the_polynomial() {
        let (mut flow, rate) = flow();
        let half = 0.5 * flow.length();
        for node in [0_u64, 8, 200] {
            let impulse = flow.impulse(node);
            #[allow(clippy::cast_precision_loss)]
            let at = node as f64 * flow.step();
            for order in [1, 4, 9] {
                let rest = flow.rest(&impulse, order, Range::from(half));
                for y in (-20..=20).map(|i| half * f64::from(i) / 20.0) {
                    let truth = exact(rate, at + y);
                    for j in 0..4 {
                        let terms = &impulse.terms[j][..order];
                        let about = polynomial(terms, Range::from(y)).middle();
                        let left = (truth[j] - about).abs();
                        assert!(left <= rest[j].high() + 1e-13, "{node}, {order}, {y}: {left}");
                    }
                }
            }
        }
    }
}
