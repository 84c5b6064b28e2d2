//! The table of the nodes in use, and what is found of expressions by their hashes.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};
use std::sync::{Arc, Mutex, Weak};

use super::{Expression, Node, Shared};

/// The hash of what has hashed itself.
#[derive(Default)]
pub(crate) struct Hashed(u64);

impl Hasher for Hashed {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = self.0.rotate_left(8) ^ u64::from(*byte);
        }
    }

    fn write_u64(&mut self, hash: u64) {
        self.0 = hash;
    }
}

/// Results by expression, to be looked up and never listed.
pub(crate) type Found<T> = HashMap<Expression, T, BuildHasherDefault<Hashed>>;

/// Parts of the table, so that threads seldom wait for each other.
pub(super) const SHARDS: usize = 16;

/// Entries from which on a part of the table is rid of what is no longer in use.
const FEW: usize = 1024;

pub(super) static TABLE: [Mutex<Table>; SHARDS] = [const { Mutex::new(Table::new()) }; SHARDS];

/// The nodes in use, by their hashes.
pub(super) struct Table {
    entries: HashMap<u64, Entry, BuildHasherDefault<Hashed>>,
    /// Entries at which it is swept: twice those that were in use the last time.
    most: usize,
}

/// The nodes of one hash: almost always one.
struct Entry {
    first: Weak<Shared>,
    more: Vec<Weak<Shared>>,
}

impl Table {
    const fn new() -> Self {
        Self { entries: HashMap::with_hasher(BuildHasherDefault::new()), most: FEW }
    }

    /// The expression of a node, which is the one that is there.
    pub(super) fn interned(&mut self, node: Node, hash: u64) -> Expression {
        if let Some(entry) = self.entries.get(&hash) {
            let all = std::iter::once(&entry.first).chain(&entry.more);
            if let Some(there) = all.filter_map(Weak::upgrade).find(|there| there.node == node) {
                return Expression(there);
            }
        }
        let shared = Arc::new(Shared::of(node, hash));
        self.insert(Arc::downgrade(&shared), hash);
        Expression(shared)
    }

    fn insert(&mut self, weak: Weak<Shared>, hash: u64) {
        if self.entries.len() >= self.most {
            self.entries.retain(|_, entry| entry.is_used());
            self.most = FEW.max(2 * self.entries.len());
        }
        match self.entries.get_mut(&hash) {
            Some(entry) if entry.first.strong_count() > 0 => entry.more.push(weak),
            Some(entry) => entry.first = weak,
            None => {
                self.entries.insert(hash, Entry { first: weak, more: Vec::new() });
            }
        }
    }
}

impl Entry {
    /// Returns true if one of its nodes is in use; drops the others.
    fn is_used(&mut self) -> bool {
        self.more.retain(|weak| weak.strong_count() > 0);
        self.first.strong_count() > 0 || !self.more.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::super::Variable;
    use super::*;

    #[test]
    fn table_size_follows_the_nodes_in_use() {
        let mut table = Table::new();
        for round in 0..200 {
            let mut node = |k: usize| {
                let index = k + 2000 * round;
                table.interned(Node::Variable(Variable::State(index)), index as u64)
            };
            let kept: Vec<_> = (0..2000).map(&mut node).collect();
            assert_eq!(kept[7], node(7));
        }
        // Of 400 000 nodes 2000 are in use at a time, and it is swept at twice as many.
        assert!(table.entries.len() <= 4 * 2000, "{}", table.entries.len());
    }
}
