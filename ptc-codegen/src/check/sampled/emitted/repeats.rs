//! Samples that repeat the one before: a program that decides alike and makes the same numbers of its counts computes
//! the same.

use std::cell::{Cell, RefCell};

use super::Held;
use super::sample::Sample;
use crate::code::{Expr, Test};

/// Record of the computations of a sample with its counts, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct Trace<'a> {
    entries: RefCell<Vec<Entry<'a>>>,
    /// Comparisons of numbers within which an expression is: there the outcome counts alone.
    compared: Cell<u32>,
    /// Numbers made of counts within the outermost of them.
    within: Cell<u32>,
}

#[derive(Clone, Debug)]
enum Entry<'a> {
    /// A count that gets a name.
    Count(&'a str, &'a Expr),
    /// A comparison of counts, or of numbers that are made of them.
    Test(&'a Test, bool),
    /// A count that becomes a number.
    Number(&'a Expr, u32),
}

impl<'a> Trace<'a> {
    fn push(&self, entry: Entry<'a>) {
        self.entries.borrow_mut().push(entry);
    }

    pub(super) fn count(&self, name: &'a str, value: &'a Expr) {
        self.push(Entry::Count(name, value));
    }

    pub(super) fn test(&self, test: &'a Test, outcome: bool) {
        self.push(Entry::Test(test, outcome));
    }

    pub(super) fn number(&self, count: &'a Expr, value: u32) {
        match self.compared.get() {
            0 => self.push(Entry::Number(count, value)),
            _ => self.within.set(self.within.get() + 1),
        }
    }

    /// Notes a comparison of numbers if it depends on counts.
    pub(super) fn compare(
        &self,
        test: &'a Test,
        outcome: impl FnOnce() -> Option<bool>,
    ) -> Option<bool> {
        let before = self.within.get();
        self.compared.set(self.compared.get() + 1);
        let outcome = outcome();
        self.compared.set(self.compared.get() - 1);
        if self.within.get() > before {
            self.test(test, outcome?);
        }
        outcome
    }
}

impl<'a> Sample<'a> {
    /// Returns true if sample `k` does the same as another one, judged by the trace of that one. Numbers that are not
    /// made of counts are the same where all before them is; a comparison of counts with others is not repeated, as
    /// their names are not known here.
    pub(super) fn repeats(&self, trace: &Trace<'a>, k: usize) -> bool {
        let repeated = || {
            let mut counts = self.counts(k)?;
            for entry in trace.entries.borrow().iter() {
                let same = match entry {
                    Entry::Count(name, value) => {
                        let count = Held::Count(counts.count(value)?);
                        counts.locals.insert(name, count);
                        true
                    }
                    Entry::Test(test, outcome) => counts.test(test)? == *outcome,
                    Entry::Number(count, value) => counts.count(count)? == *value,
                };
                same.then_some(())?;
            }
            Some(())
        };
        repeated().is_some()
    }
}
