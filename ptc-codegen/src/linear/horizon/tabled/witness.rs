//! A few rows of the way from now to rest that stand for all of them.
//!
//! Each bounds itself, and times its own factor a part of those that were left out: a row r_j is left out if it is within
//! the hull of the others, whose factors grow by what is missing. What is within a hull stays there as all rows are
//! carried on by the same matrix, so that errors do not add up from sample to sample.

use super::super::span::times;
use super::Row;
use super::hull::Hull;

/// Most factor of a row.
const MOST: f64 = 1.003;

/// Rows from now to rest, the latest last.
pub(super) struct Witness {
    /// Each row, and its factor.
    rows: Vec<(Row, f64)>,
    /// The row that is looked at next.
    next: usize,
}

impl Witness {
    pub(super) fn new(rows: &[Row]) -> Self {
        Self { rows: rows.iter().map(|row| (row.clone(), 1.0)).collect(), next: 0 }
    }

    /// Carries all rows on to a sample earlier, whose own row is `row`.
    pub(super) fn advance(&mut self, step: &[Row], row: Row) {
        for (own, _) in &mut self.rows {
            *own = times(own, step);
        }
        self.rows.push((row, 1.0));
        let before = self.rows.len() - 2;
        self.leave_out(before);
        self.next = if self.next < self.rows.len() { self.next } else { 0 };
        if !self.leave_out(self.next) {
            self.next += 1;
        }
    }

    /// The rows, each times its factor: they bound every signal.
    pub(super) fn outer(&self) -> impl Iterator<Item = Row> {
        self.rows.iter().map(|(row, factor)| row.iter().map(|own| own * factor).collect())
    }

    /// The rows themselves: each is one of the signal's.
    pub(super) fn inner(&self) -> impl Iterator<Item = &Row> + Clone {
        self.rows.iter().map(|(row, _)| row)
    }

    /// Leaves a row out that the others bound; false if they do not.
    fn leave_out(&mut self, index: usize) -> bool {
        if index + 1 >= self.rows.len() {
            return false;
        }
        let outer: Vec<Row> = self.outer().collect();
        let others = outer.iter().enumerate().filter(|(i, _)| *i != index).map(|(_, row)| row);
        let hull = Hull::new(outer[index].len(), others);
        let found = hull.bound(&outer[index], &mut hull.basis());
        let own = |i: usize| if i < index { i } else { i + 1 };
        let used = || found.each.iter().filter(|(_, factor)| *factor != 0.0).map(|(i, _)| own(*i));
        let larger = found.sum.max(1.0);
        // Rows behind the last are those of the box, which bound nothing.
        let admits = |i: usize| self.rows.get(i).is_some_and(|(_, own)| own * larger <= MOST);
        if found.sum > MOST || larger > 1.0 && !used().all(admits) {
            return false;
        }
        if larger > 1.0 {
            for i in used().collect::<Vec<_>>() {
                self.rows[i].1 *= larger;
            }
        }
        self.rows.remove(index);
        true
    }
}
