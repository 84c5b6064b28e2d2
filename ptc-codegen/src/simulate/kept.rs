//! Rows of a run kept in memory: all of a short one, and of a long one those that a picture can show.

use super::record::Row;
use crate::program::range::Range;
use crate::reference::Status;

/// Most parts of a run, an even number. A run that acts at every instant has fewer rows.
const PARTS: usize = 1 << 14;

/// A u this near to a limit, relative to it, is at the limit.
const AT_LIMIT: f64 = 1e-9;

/// Rows in a row of which the first is kept, with the bounds of what all of them hold.
struct Part {
    first: Row,
    /// The least and the greatest of each state and each input, where there are several rows.
    within: Option<Vec<(f64, f64)>>,
}

/// A run.
pub struct Kept {
    parts: Vec<Part>,
    /// Rows of a part.
    stride: usize,
    count: usize,
    last: Option<Row>,
    limits: Vec<Range>,
    /// The largest size of each input, and when.
    pub peaks: Vec<(f64, f64)>,
    /// Time for which an input is at its bound, counted from each instant to the next, in s.
    pub saturated: f64,
    /// The first call that the controller refused, and when.
    pub refused: Option<(Status, f64)>,
}

impl Kept {
    /// A run of no row as yet, of inputs with these limits.
    pub fn new(limits: Vec<Range>) -> Self {
        Self {
            parts: Vec::new(),
            stride: 1,
            count: 0,
            last: None,
            limits,
            peaks: Vec::new(),
            saturated: std::iter::empty::<f64>().sum(),
            refused: None,
        }
    }

    /// Takes the next row.
    pub fn take(&mut self, row: Row) {
        let sizes = row.u.iter().map(|u| (u.abs(), row.t));
        if self.peaks.is_empty() {
            self.peaks = sizes.collect();
        } else {
            let larger = |(peak, own): (&mut (f64, f64), (f64, f64))| {
                if own.0 > peak.0 {
                    *peak = own;
                }
            };
            self.peaks.iter_mut().zip(sizes).for_each(larger);
        }
        if let Some(last) = self.last.as_ref().filter(|last| self.is_at_bound(last)) {
            self.saturated += row.t - last.t;
        }
        if row.is_refused() {
            self.refused.get_or_insert((row.status, row.t));
        }
        self.put(&row);
        self.last = Some(row);
    }

    fn put(&mut self, row: &Row) {
        let index = self.count / self.stride;
        self.count += 1;
        match self.parts.get_mut(index) {
            None => self.parts.push(Part { first: row.clone(), within: None }),
            Some(part) => part.widen(values(row).map(|value| (value, value))),
        }
        if self.count == PARTS * self.stride {
            self.halve();
        }
    }

    /// Joins the parts by twos.
    fn halve(&mut self) {
        let mut joined = Vec::with_capacity(PARTS / 2);
        for part in std::mem::take(&mut self.parts) {
            let index = joined.len();
            match joined.last_mut() {
                Some((one, false)) => {
                    let one: &mut Part = one;
                    one.widen(part.bounds().into_iter());
                    joined[index - 1].1 = true;
                }
                _ => joined.push((part, false)),
            }
        }
        self.parts = joined.into_iter().map(|(part, _)| part).collect();
        self.stride *= 2;
    }

    fn is_at_bound(&self, row: &Row) -> bool {
        let mut all = row.u.iter().zip(&self.limits);
        all.any(|(u, limits)| limits.nears(*u, AT_LIMIT))
    }

    /// The last row.
    pub fn last(&self) -> Option<&Row> {
        self.last.as_ref()
    }

    /// The rows that were asked for, of a run that acts at every instant.
    pub fn reported(&self) -> impl Iterator<Item = &Row> {
        self.parts.iter().map(|part| &part.first).filter(|row| row.reported)
    }

    /// So many rows evenly spread over the run, the last one included.
    pub fn spread(&self, most: usize) -> Vec<&Row> {
        let last = self.count.saturating_sub(1);
        let mut indices: Vec<_> = (0..most).map(|k| k * last / (most - 1)).collect();
        indices.dedup();
        let row = |index: usize| match index == last {
            true => self.last.as_ref(),
            false => self.parts.get(index / self.stride).map(|part| &part.first),
        };
        indices.into_iter().filter_map(row).collect()
    }

    /// A curve of the picture: a value of each row by its place among states and inputs. Of a part of several rows
    /// it has two, the least and the greatest.
    pub fn curve(&self, place: usize) -> Vec<f64> {
        let both = |part: &Part| match &part.within {
            None => vec![values(&part.first).nth(place).unwrap_or(f64::NAN)],
            Some(within) => vec![within[place].0, within[place].1],
        };
        self.parts.iter().flat_map(both).collect()
    }

    /// The same of what a part has once, its time: twice where it has several rows.
    pub fn instants(&self, of: impl Fn(&Row) -> f64) -> Vec<f64> {
        let each = |part: &Part| vec![of(&part.first); 1 + usize::from(part.within.is_some())];
        self.parts.iter().flat_map(each).collect()
    }
}

impl Part {
    fn bounds(&self) -> Vec<(f64, f64)> {
        let own = || values(&self.first).map(|value| (value, value)).collect();
        self.within.clone().unwrap_or_else(own)
    }

    fn widen(&mut self, others: impl Iterator<Item = (f64, f64)>) {
        let mut within = self.bounds();
        for (own, other) in within.iter_mut().zip(others) {
            *own = (own.0.min(other.0), own.1.max(other.1));
        }
        self.within = Some(within);
    }
}

/// The states and the inputs.
fn values(row: &Row) -> impl Iterator<Item = f64> {
    row.x.iter().chain(&row.u).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(index: u32) -> Row {
        let t = f64::from(index);
        // A peak of one row, which no row that is kept has.
        let u = if index == 77_777 { -9.0 } else { (t / 1000.0).sin() };
        Row {
            t,
            stretched: 0.0,
            x: vec![t],
            measured: vec![t],
            status: if index == 50_001 { Status::Input } else { Status::Ok },
            u: vec![u],
            reported: true,
        }
    }

    #[test]
    fn long_runs_keep_their_peaks_in_few_parts() {
        let mut kept = Kept::new(vec![Range::symmetric(8.0)]);
        let count = 100_000;
        (0..count).for_each(|index| kept.take(row(index)));
        assert!(kept.parts.len() < PARTS && kept.parts.len() >= PARTS / 2);
        assert_eq!(kept.peaks, [(9.0, 77_777.0)]);
        assert!((kept.saturated - 1.0).abs() < 1e-12, "{}", kept.saturated);
        assert_eq!(kept.refused, Some((Status::Input, 50_001.0)));
        assert_eq!(kept.last(), Some(&row(count - 1)));
        let (u, t) = (kept.curve(1), kept.instants(|row| row.t));
        assert_eq!(u.len(), t.len());
        assert_eq!(u.iter().copied().fold(0.0, f64::min), -9.0);
        assert!(t.is_sorted());
        // Every row is in one part: the bounds of x go on without a gap.
        let x = kept.curve(0);
        let ends = x.chunks(2).map(|own| (own[0], own[own.len() - 1])).collect::<Vec<_>>();
        assert!(ends.windows(2).all(|pair| pair[1].0 - pair[0].1 == 1.0));
        let spread: Vec<_> = kept.spread(12).iter().map(|row| row.t).collect();
        assert_eq!((spread.len(), spread[0], spread[11]), (12, 0.0, 99_999.0));
        assert!((0..12).all(|k| (spread[k] - 99_999.0 * k as f64 / 11.0).abs() <= 16.0));
    }

    #[test]
    fn short_runs_keep_each_row() {
        let mut kept = Kept::new(vec![Range::symmetric(f64::INFINITY)]);
        (0..1000).for_each(|index| kept.take(row(index)));
        let all: Vec<_> = (0..1000).map(row).collect();
        assert_eq!(kept.reported().cloned().collect::<Vec<_>>(), all);
        assert_eq!(kept.curve(0), (0..1000).map(f64::from).collect::<Vec<_>>());
        assert_eq!(kept.saturated, 0.0);
    }
}
