//! The infinite-time system xi' = A xi, enclosed at all of its times.

use std::collections::BTreeMap;
use std::rc::Rc;

use num_traits::{One, ToPrimitive};

use super::impulse::{Impulse, Tail};
use super::square::Square;
use crate::algebra::{BigRational, integer};
use crate::expression::enclosure::{Interval, Range};

/// Rows of a matrix.
pub(super) type Rows = Vec<Vec<Range>>;

/// |A| times the distance of two nodes is at most this.
const STEP: f64 = 0.25;

/// Nodes in a piece of a long time, and most of these pieces.
const PIECE: u32 = 4;
const MANY: f64 = 24.0;

/// The largest e^(At) is looked for at each of the first nodes, and then at every one after as many.
const FINE: u64 = 256;
const COARSE: u64 = 512;

/// The companion matrix A of gains, in units of time in which they are about 1, and e^(At) at the
/// nodes 2^-grid k.
pub(super) struct Flow {
    /// Units of time in one second of stretched time.
    pub(super) rate: BigRational,
    pub(super) gains: Vec<Range>,
    pub(super) norm: Range,
    grid: u32,
    doubled: Vec<Square>,
    nodes: BTreeMap<u64, Square>,
    /// The same, in doubles.
    rounded: BTreeMap<u64, Rows>,
    largest: Option<Range>,
    pub(super) impulses: BTreeMap<u64, Rc<Impulse>>,
    /// Bounds of the impulses at all later times, computed on demand; `None` where they fall too slowly.
    pub(super) tail: Option<Option<Rc<Tail>>>,
}

/// sum_j a_j b_j.
pub(super) fn dot<'a>(
    a: impl IntoIterator<Item = &'a Range>,
    b: impl IntoIterator<Item = &'a Range>,
) -> Range {
    a.into_iter().zip(b).map(|(a, b)| *a * *b).sum()
}

impl Flow {
    /// Returns the flow of the gains k_1..k_n; `None` where they are not numbers of a usual size.
    pub(super) fn new(gains: &[BigRational]) -> Option<Self> {
        let n = gains.len();
        let rate = unit_rate(gains)?;
        let scaled = |j: usize| {
            let power = i32::try_from(n - j).unwrap_or(i32::MAX);
            &gains[j] / num_traits::Pow::pow(&rate, power)
        };
        let a = Square::of(
            n,
            |i, j| if i + 1 == n { -scaled(j) } else { integer(i64::from(j == i + 1)) },
        );
        let norm = a.norm();
        let grid = (norm.high() / STEP).log2().ceil().max(0.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let grid = (grid < 64.0).then_some(grid as u32)?;
        let doubled = vec![a.exponential(grid)];
        let gains = (0..n).map(|j| Range::from(&Interval::exact(&scaled(j)))).collect();
        let (nodes, rounded, largest) = (BTreeMap::new(), BTreeMap::new(), None);
        let (impulses, tail) = (BTreeMap::new(), None);
        let mut flow =
            Self { rate, gains, norm, grid, doubled, nodes, rounded, largest, impulses, tail };
        flow.largest = flow.largest();
        Some(flow)
    }

    /// e^(A t) at t = 2^-grid k, k > 0.
    pub(super) fn node(&mut self, k: u64) -> Square {
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

    /// A bound of |e^(At)| in the maximum norm over all t >= 0; `None` where it falls too slowly.
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
            most = most.most(&norm);
        }
        let (within, mut after) = (most * between, Range::from(1.0));
        for k in 1..=COARSE {
            let norm = self.node(k * FINE).norm();
            if falls(norm) {
                return Some(within * after);
            }
            after = after.most(&norm);
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
        self.on(&node, Range::from(&t.minus(&here)))
    }

    /// The distance of two nodes.
    pub(super) fn step(&self) -> f64 {
        2f64.powi(-i32::try_from(self.grid).unwrap_or(0))
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
            let power = inverse.whole_power(i);
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

    /// e^(A t) `start` for all of a short time, by its Taylor series; `None` where it is long.
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
            let size = size.reduce(|a, b| a.most(&b))?;
            let rest = (size * left).both_signs();
            sum.iter_mut().for_each(|row| row[column] = row[column] + rest);
        }
        Some(sum)
    }

    /// e^(A t) `start` for all of a time, piece by piece; `None` where it is long.
    pub(super) fn during(&mut self, time: &Interval, start: &Rows) -> Option<Rows> {
        let [first, last] = [Range::from(time).low().max(0.0), Range::from(time).high()];
        let length = f64::from(PIECE) * self.step();
        let ends = [first, last].map(|end| (end / length).floor());
        (ends[1] - ends[0] < MANY && ends[1] < 1e15).then_some(())?;
        let (mut rows, mut from) = (None::<Rows>, first);
        let mut place = ends[0];
        while from < last {
            place += 1.0;
            let to = (place * length).min(last);
            if to <= from {
                continue;
            }
            let here = self.at(&Range::new(from, to).into(), start)?;
            rows = Some(match rows {
                None => here,
                Some(mut rows) => {
                    let pairs = rows.iter_mut().flatten().zip(here.iter().flatten());
                    pairs.for_each(|(all, own)| *all = all.hull(own));
                    rows
                }
            });
            from = to;
        }
        rows
    }

    /// e^(A t) `start` for all t >= 0.
    pub(super) fn ever(&self, start: &Rows) -> Option<Rows> {
        let largest = self.largest?;
        let bound = |column: usize| {
            let size = start.iter().map(|row| row[column].size()).reduce(|a, b| a.most(&b));
            size.map(|size| (size * largest).both_signs())
        };
        let row = (0..start.first()?.len()).map(bound).collect::<Option<Vec<_>>>()?;
        Some(vec![row; start.len()])
    }
}

/// A power of two, by which the time of the gains is scaled so that |A| is least.
pub(in crate::verify) fn unit_rate(gains: &[BigRational]) -> Option<BigRational> {
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
