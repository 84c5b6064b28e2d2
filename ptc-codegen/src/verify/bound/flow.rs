//! The infinite-time system xi' = A xi, enclosed at all of its times.

use std::collections::BTreeMap;
use std::ops::Add;
use std::rc::Rc;

use num_traits::{One, ToPrimitive};

use super::ball::Ball;
use crate::algebra::{BigRational, integer};
use crate::expression::interval::Interval;
use crate::expression::range::Range;

/// Rows of a matrix.
pub(super) type Rows = Vec<Vec<Range>>;

/// |A| times the distance of two nodes is at most this.
const STEP: f64 = 0.25;

/// The largest e^(At) is looked for at each of the first nodes, and then at every one after as many.
const FINE: u64 = 256;
const COARSE: u64 = 512;

/// Order up to which e^(At) e_n is taken around a node.
pub(super) const TERMS: usize = 8;

/// e^(At) e_n =: phi around a node, for xi_1..xi_n and the last row of A phi after them.
pub(super) struct Impulse {
    /// The Taylor coefficients of each.
    pub(super) terms: Rows,
    /// The greatest |phi_j| at the node.
    pub(super) size: Range,
}

/// The companion matrix A of gains, in units of time in which they are about 1, and e^(At) at the
/// nodes 2^-grid k.
pub(super) struct Flow {
    /// Units of time in one second of stretched time.
    pub(super) rate: BigRational,
    gains: Vec<Range>,
    norm: Range,
    grid: u32,
    doubled: Vec<Ball>,
    nodes: BTreeMap<u64, Ball>,
    /// The same, in doubles.
    rounded: BTreeMap<u64, Rows>,
    largest: Option<Range>,
    impulses: BTreeMap<u64, Rc<Impulse>>,
}

/// sum_j a_j b_j.
pub(super) fn dot<'a>(
    a: impl IntoIterator<Item = &'a Range>,
    b: impl IntoIterator<Item = &'a Range>,
) -> Range {
    let terms = a.into_iter().zip(b).map(|(a, b)| *a * *b);
    terms.reduce(Range::add).unwrap_or(Range::from(0.0))
}

impl Flow {
    /// Of the gains k_1..k_n; none where they are no numbers of a usual size.
    pub(super) fn new(gains: &[BigRational]) -> Option<Self> {
        let n = gains.len();
        let rate = unit_rate(gains)?;
        let scaled = |j: usize| {
            let power = i32::try_from(n - j).unwrap_or(i32::MAX);
            &gains[j] / num_traits::Pow::pow(&rate, power)
        };
        let a = Ball::of(n, |i, j| match () {
            () if i + 1 == n => -scaled(j),
            () => integer(i64::from(j == i + 1)),
        });
        let norm = a.norm();
        let grid = (norm.high() / STEP).log2().ceil().max(0.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let grid = (grid < 64.0).then_some(grid as u32)?;
        let doubled = vec![a.exponential(grid)];
        let gains = (0..n).map(|j| Range::from(&Interval::exact(&scaled(j)))).collect();
        let (nodes, rounded, largest) = (BTreeMap::new(), BTreeMap::new(), None);
        let impulses = BTreeMap::new();
        let mut flow = Self { rate, gains, norm, grid, doubled, nodes, rounded, largest, impulses };
        flow.largest = flow.largest();
        Some(flow)
    }

    /// e^(A t) at t = 2^-grid k, k > 0.
    fn node(&mut self, k: u64) -> Ball {
        if let Some(node) = self.nodes.get(&k) {
            return node.clone();
        }
        let lowest = k.trailing_zeros() as usize;
        while self.doubled.len() <= lowest {
            let last = &self.doubled[self.doubled.len() - 1];
            self.doubled.push(last.times(last));
        }
        let rest = k & (k - 1);
        let node = match rest {
            0 => self.doubled[lowest].clone(),
            rest => self.node(rest).times(&self.doubled[lowest]),
        };
        self.nodes.insert(k, node.clone());
        node
    }

    /// A bound of |e^(At)| in the maximum norm over all t >= 0; none where it falls too slowly.
    fn largest(&mut self) -> Option<Range> {
        let mut most = Range::from(1.0);
        let falls = |norm: Range| norm.high() < 0.5;
        // Between two nodes it grows by e^STEP at most.
        let between = Range::from(4.0 / 3.0);
        for k in 1..=FINE {
            let norm = self.node(k).norm();
            if falls(norm) {
                return Some(most * between);
            }
            most = most.most(norm);
        }
        let (within, mut after) = (most * between, Range::from(1.0));
        for k in 1..=COARSE {
            let norm = self.node(k * FINE).norm();
            if falls(norm) {
                return Some(within * after);
            }
            after = after.most(norm);
        }
        None
    }

    /// e^(A t) `start` at a time that is known closely.
    pub(super) fn at(&mut self, t: &Interval, start: &Rows) -> Option<Rows> {
        let scale = 2f64.powi(i32::try_from(self.grid).ok()?);
        let place = (t.about()[0] * scale).floor().max(0.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let k = (place < 1e15).then_some(place as u64)?;
        let n = self.gains.len();
        let node = match k {
            0 => start.clone(),
            k => {
                if !self.rounded.contains_key(&k) {
                    let node = self.node(k);
                    let row = |i: usize| (0..n).map(|j| node.entry(i, j)).collect();
                    self.rounded.insert(k, (0..n).map(row).collect());
                }
                let columns = start.first()?.len();
                let times = |row: &Vec<Range>| {
                    let entry = |c: usize| dot(row, start.iter().map(|row| &row[c]));
                    (0..columns).map(entry).collect()
                };
                self.rounded.get(&k)?.iter().map(times).collect()
            }
        };
        let here = Interval::scaled(&k.into(), -i32::try_from(self.grid).ok()?);
        self.on(&node, Range::from(&t.plus(&here.neg())))
    }

    /// The distance of two nodes.
    pub(super) fn step(&self) -> f64 {
        2f64.powi(-i32::try_from(self.grid).unwrap_or(0))
    }

    /// e^(At) e_n around the node k.
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
        let size = chain.iter().map(|entry| entry.size()).fold(Range::from(0.0), Range::most);
        // Each component is the derivative of the one before.
        for at in 0..=TERMS {
            chain.push(-dot(&self.gains, &chain[at..at + n]));
        }
        let row = |j: usize| {
            let mut factorial = 1.0;
            let term = |(l, entry): (u32, &Range)| {
                factorial *= f64::from(l.max(1));
                *entry / Range::from(factorial)
            };
            (0..).zip(&chain[j..=j + TERMS]).map(term).collect()
        };
        let impulse = Rc::new(Impulse { terms: (0..=n).map(row).collect(), size });
        self.impulses.insert(k, impulse.clone());
        impulse
    }

    /// A bound of the sizes of phi_1..phi_n and of the last row of A phi at all times from a node on.
    pub(super) fn ever_after(&mut self, k: u64) -> Option<[Range; 2]> {
        let most = self.impulse(k).size * self.largest?;
        Some([most, most * self.norm])
    }

    /// Bounds of the part of order `order` of the Taylor series of the same around a node, over all
    /// times at most `away` from it: where that is the rest.
    pub(super) fn rest(&self, impulse: &Impulse, order: usize, away: Range) -> [Range; 2] {
        let reach = self.norm * away.size();
        let mut part = impulse.size * grown(reach);
        for k in 1..=order {
            part = part * reach / Range::from(f64::from(u32::try_from(k).unwrap_or(u32::MAX)));
        }
        [part, part * self.norm]
    }

    /// A times rows.
    fn rate_of(&self, rows: &Rows) -> Rows {
        let mut next = rows[1..].to_vec();
        next.push(self.last(rows));
        next
    }

    /// x_1 and its derivatives by time, from xi and B_{i,j} w^i.
    pub(super) fn derivatives(&self, share: &Interval, table: &Rows, mut xi: Rows) -> Rows {
        let n = xi.len();
        for i in 0..table.len() - n {
            let next = self.last(&xi[i..n + i]);
            xi.push(next);
        }
        let inverse = Range::from(1.0) / Range::from(share);
        let row = |(i, row): (i32, &Vec<Range>)| {
            let power = inverse.power(i);
            let entry = |c: usize| dot(row, xi.iter().map(|xi| &xi[c])) * power;
            (0..xi[0].len()).map(entry).collect()
        };
        (0..).zip(table).map(row).collect()
    }

    /// The last row of A times rows, -(k_1 xi_1 + ... + k_n xi_n).
    pub(super) fn last(&self, rows: &[Vec<Range>]) -> Vec<Range> {
        let columns = rows.first().map_or(0, Vec::len);
        let one = |c: usize| -dot(&self.gains, rows.iter().map(|row| &row[c]));
        (0..columns).map(one).collect()
    }

    /// e^(A t) `start` for all of a short time, by its Taylor series; none where it is long.
    pub(super) fn on(&self, start: &Rows, t: Range) -> Option<Rows> {
        let reach = self.norm * t.size();
        if reach.high() > 2.0 {
            return None;
        }
        let (mut sum, mut term) = (start.clone(), start.clone());
        let mut left = Range::from(1.0);
        for k in 1.. {
            let share = Range::from(f64::from(k));
            left = left * reach / share;
            let step = t / share;
            term = self.rate_of(&term);
            term.iter_mut().flatten().for_each(|entry| *entry = *entry * step);
            for (sum, term) in sum.iter_mut().flatten().zip(term.iter().flatten()) {
                *sum = *sum + *term;
            }
            // From here on the terms halve at least: what is left is less than this one.
            if k >= 6 && left.high() < 2f64.powi(-60) {
                break;
            }
        }
        for column in 0..start[0].len() {
            let size = start.iter().map(|row| row[column].size());
            let size = size.reduce(Range::most)?;
            let rest = (size * left).both_signs();
            sum.iter_mut().for_each(|row| row[column] = row[column] + rest);
        }
        Some(sum)
    }

    /// e^(A t) `start` for all t >= 0.
    pub(super) fn ever(&self, start: &Rows) -> Option<Rows> {
        let largest = self.largest?;
        let bound = |column: usize| {
            let size = start.iter().map(|row| row[column].size()).reduce(Range::most);
            size.map(|size| (size * largest).both_signs())
        };
        let row = (0..start.first()?.len()).map(bound).collect::<Option<Vec<_>>>()?;
        Some(vec![row; start.len()])
    }
}

/// A bound of e^x for small x.
fn grown(x: Range) -> Range {
    Range::from(x.high().exp() * (1.0 + 1e-12))
}

/// A power of two, by which the time of the gains is scaled so that |A| is least.
fn unit_rate(gains: &[BigRational]) -> Option<BigRational> {
    let n = i32::try_from(gains.len()).ok()?;
    let gains: Vec<f64> = gains.iter().map(ToPrimitive::to_f64).collect::<Option<_>>()?;
    let norm = |exponent: i32| {
        let rate = 2f64.powi(exponent);
        let row = gains.iter().zip(0..n).map(|(k, j)| k.abs() / rate.powi(n - j));
        rate * row.sum::<f64>().max(1.0)
    };
    let least = (-60..=60).rev().min_by(|a, b| norm(*a).total_cmp(&norm(*b)))?;
    let size = num_traits::pow(integer(2), usize::try_from(least.abs()).ok()?);
    norm(least).is_finite().then(|| if least < 0 { BigRational::one() / size } else { size })
}
