//! The weight mu'^n of an f over stretched time: by as much an f of 1 moves xi_n in a unit of it.
//!
//! Stretched time is cut into leaves, over each of which the weight is a Taylor polynomial with a small
//! rest. The cuts are doubles, and a polynomial holds a little beyond its own.

use super::clock::Clock;
use crate::algebra::{BigRational, integer};
use crate::expression::enclosure::{Interval, Range};

/// Leaves of a run.
const MOST: usize = 4000;

/// Order of the rest of a leaf's polynomial.
const ORDER: usize = 6;

/// The rest of a leaf is at most this part of the weight.
const REST: f64 = 1.0 / 16384.0;

/// The weight varies by at most this factor over a leaf.
const STEEP: f64 = 2.0;

/// Relative distance beyond its cuts to which a leaf holds.
const BEYOND: f64 = 1.0 / 1_048_576.0;

/// The weight over a piece of stretched time.
pub(super) struct Leaf {
    pub(super) from: f64,
    pub(super) to: f64,
    /// Range of times for which its polynomial holds.
    holds: Range,
    middle: Range,
    /// The polynomial around the middle, and what is left of it.
    series: Vec<Range>,
    pub(super) rest: Range,
    /// The weight all over the leaf, and its first two derivatives as parts of it.
    over: [Range; 3],
}

/// The weight from t0 to the end of a run.
pub(super) struct Weight {
    leaves: Vec<Leaf>,
}

/// A piece of stretched time, by its greatest and least T/tau or by its ends.
enum Span {
    Share([BigRational; 2]),
    Time([f64; 2]),
}

impl Weight {
    /// Encloses the weight of a mapping until a T/tau; `None` where it is not enclosed.
    pub(super) fn new(clock: &mut Clock, n: usize, until: &BigRational) -> Option<Self> {
        let whole = if clock.is_of_mu() {
            Span::Time([0.0, Range::from(&clock.stretched(until)?).high()])
        } else {
            Span::Share([until.clone(), integer(1)])
        };
        let (mut leaves, mut left) = (Vec::new(), vec![whole]);
        while let Some(span) = left.pop() {
            (leaves.len() + left.len() < MOST).then_some(())?;
            match span.leaf(clock, n) {
                Some(leaf) => leaves.push(leaf),
                None => left.extend(span.halves()),
            }
        }
        Some(Self { leaves })
    }

    /// The index of the leaf that holds a time, the earlier one at a cut.
    pub(super) fn at(&self, t: f64) -> usize {
        self.leaves.partition_point(|leaf| leaf.to < t).min(self.leaves.len() - 1)
    }

    pub(super) fn leaf(&self, index: usize) -> &Leaf {
        &self.leaves[index]
    }

    /// The weight over a time, and its first two derivatives as parts of it.
    pub(super) fn over(&self, from: f64, to: f64) -> [Range; 3] {
        let last = self.at(to);
        let met = self.leaves[..=last].iter().rev().take_while(|leaf| leaf.to >= from);
        let met = met.map(|leaf| leaf.over).reduce(|a, b| [0, 1, 2].map(|k| a[k].hull(&b[k])));
        met.unwrap_or([Range::WHOLE; 3])
    }

    /// A bound of the integral of the weight over a time.
    pub(super) fn sum(&self, from: f64, to: f64) -> Range {
        let last = self.at(to);
        let met = self.leaves[..=last].iter().rev().take_while(|leaf| leaf.to >= from);
        let one = |leaf: &Leaf| {
            let length = Range::from(to.min(leaf.to)) - Range::from(from.max(leaf.from));
            length.size() * leaf.over[0]
        };
        met.map(one).sum()
    }
}

impl Span {
    fn halves(self) -> [Self; 2] {
        match self {
            // The earlier half is taken up first.
            Self::Share([low, high]) => {
                let middle = (&low + &high) / integer(2);
                [Self::Share([low, middle.clone()]), Self::Share([middle, high])]
            }
            Self::Time([from, to]) => {
                let middle = 0.5 * from + 0.5 * to;
                [Self::Time([middle, to]), Self::Time([from, middle])]
            }
        }
    }

    /// The leaf of a span; `None` where it is not enclosed closely.
    fn leaf(&self, clock: &mut Clock, n: usize) -> Option<Leaf> {
        let (from, to, holds, middle, around, share, during);
        match self {
            Self::Share([low, high]) => {
                let more = BigRational::from_float(BEYOND)?;
                let wider = [low - low * &more, (high + high * &more).min(integer(1))];
                let [last, first] = [clock.stretched(&wider[0])?, clock.stretched(&wider[1])?];
                // A double beside the time that is meant.
                let mut cut = |share: &BigRational| Some(clock.stretched(share)?.about()[0]);
                (to, from) = (cut(low)?, if *high == integer(1) { 0.0 } else { cut(high)? });
                during = first.hull(&last);
                let begin = if *high == integer(1) { 0.0 } else { Range::from(&first).high() };
                holds = Range::from(begin).hull(&Range::from(Range::from(&last).low()));
                let at = (low + high) / integer(2);
                middle = clock.stretched(&at)?;
                around = Interval::exact(&at);
                share = Interval::between(&wider[0], Some(&wider[1]));
            }
            Self::Time(ends) => {
                [from, to] = *ends;
                let more = BEYOND * (to - from);
                let ends = [(from - more).max(0.0), to + more];
                during = Range::new(ends[0], ends[1]).into();
                holds = Range::new(ends[0], ends[1]);
                let at = 0.5 * from + 0.5 * to;
                middle = Range::from(at).into();
                // T/tau is not looked at where mu is given.
                (around, share) = (Interval::integer(1), Interval::integer(1));
            }
        }
        (from < to && (from == 0.0 || holds.low() < from) && to < holds.high()).then_some(())?;
        let (scale, series) = clock.weight(n, ORDER, &around, &middle)?;
        let (over, terms) = clock.weight(n, ORDER, &share, &during)?;
        let middle = Range::from(&middle);
        let far = (Range::from(holds.high()) - middle)
            .size()
            .most(&(middle - Range::from(holds.low())).size());
        let rest = over * terms[ORDER] * far.whole_power(i32::try_from(ORDER).ok()?);
        let rest = rest.both_signs();
        let closely = over.is_positive()
            && over.high() <= STEEP * over.low()
            && rest.high() <= REST * scale.low();
        let series = series[..ORDER].iter().map(|term| scale * *term).collect();
        let over = [over, terms[1], Range::from(2.0) * terms[2]];
        closely.then_some(Leaf { from, to, holds, middle, series, rest, over })
    }
}

impl Leaf {
    /// The weight at `t` - y as a polynomial in y, where all of that is within the leaf.
    pub(super) fn before(&self, t: Range) -> Vec<Range> {
        let away = t - self.middle;
        let mut shifted = self.series.clone();
        let last = shifted.len() - 1;
        for k in 0..last {
            for l in (k..last).rev() {
                shifted[l] = shifted[l] + away * shifted[l + 1];
            }
        }
        shifted.iter_mut().skip(1).step_by(2).for_each(|term| *term = -*term);
        shifted
    }

    /// Returns true if its polynomial holds for a time.
    pub(super) fn holds(&self, t: Range) -> bool {
        self.holds.low() <= t.low() && t.high() <= self.holds.high()
    }
}
