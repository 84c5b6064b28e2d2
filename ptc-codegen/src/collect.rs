//! Maps and sets that are filled entry by entry, and walks as lists: `collect` compiles a sort for each kind of
//! entry, for which the page of the explorer has no room.

use std::collections::{BTreeMap, BTreeSet};

/// The entries as a map, the last one of a key.
pub(crate) fn map<K: Ord, V>(entries: impl IntoIterator<Item = (K, V)>) -> BTreeMap<K, V> {
    let mut map = BTreeMap::new();
    for (key, value) in entries {
        map.insert(key, value);
    }
    map
}

/// The values as a set.
pub(crate) fn set<T: Ord>(values: impl IntoIterator<Item = T>) -> BTreeSet<T> {
    let mut set = BTreeSet::new();
    for value in values {
        set.insert(value);
    }
    set
}

/// The items of a walk as a list, so that its callers do not compile the walk, each with what they do of it.
pub(crate) fn listed<T>(walk: impl Iterator<Item = T>) -> std::vec::IntoIter<T> {
    let all: Vec<T> = walk.collect();
    all.into_iter()
}
