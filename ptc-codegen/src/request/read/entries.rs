//! Which entries there are: known keys, each once.

use super::values::suggestion;
use super::{Entry, Reader};
use crate::diagnostic::{Place, near_miss, shorten};
use crate::keys::{KEYS, KeyInfo};

impl<'a> Reader<'a> {
    pub(super) fn admit(&mut self, entry: &'a Entry) {
        let (table, name) = match entry.key.split_once('.') {
            Some((table, name)) => (Some(table), name),
            None => (None, entry.key.as_str()),
        };
        // Outside a design file a key needs no table.
        let info = KeyInfo::find(name).filter(|info| table.is_none() || table == info.table());
        match (info, table) {
            (Some(info), _) => {
                if self.keys.insert(info.key, &entry.value).is_some() {
                    self.twice(info.key, entry.place);
                }
            }
            (None, Some("params")) => {
                if self.params.insert(name, (entry.place, &entry.value)).is_some() {
                    self.twice(&entry.key, entry.place);
                }
            }
            // What moves the plant is no part of the controller, nor is what is verified: `plant::read`
            // and `verify::read` read them.
            (None, Some("plant" | "disturbance" | "verify")) => {}
            (None, Some(table)) if table.starts_with("objective[") => {}
            (None, _) => self.unknown(&entry.key, entry.place, name),
        }
    }

    fn twice(&mut self, key: &str, place: Place) {
        self.found.push(
            "repeated-key",
            key,
            Some(place),
            format!("key `{key}` is given twice"),
            "leave one of the two out",
        );
    }

    /// `name` is what `key` is called in its table.
    pub(super) fn unknown(&mut self, key: &str, place: Place, name: &str) {
        let names = KEYS.iter().map(|info| info.key);
        let legal = names.clone().collect::<Vec<_>>().join(", ");
        let help = match KeyInfo::find(name).map(KeyInfo::table) {
            Some(Some(table)) => format!("`{name}` belongs in [{table}]"),
            Some(None) => format!("`{name}` belongs at the top, before the first table"),
            None => suggestion(near_miss(name, names), &format!("the keys are {legal}")),
        };
        self.found.push(
            "unknown-key",
            key,
            Some(place),
            format!("unknown key `{}`", shorten(key)),
            help,
        );
    }
}
