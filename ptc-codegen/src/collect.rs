//! Maps that are filled entry by entry: `collect` compiles a sort for each kind of iterator, for which the page
//! of the explorer has no room.

use std::collections::BTreeMap;

/// The entries as a map, the last one of a key.
pub(crate) fn map<K: Ord, V>(entries: impl IntoIterator<Item = (K, V)>) -> BTreeMap<K, V> {
    let mut map = BTreeMap::new();
    for (key, value) in entries {
        map.insert(key, value);
    }
    map
}
