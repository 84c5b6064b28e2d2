//! The mistakes of a design, as they are reported.

use super::{SYNTAX, UNREADABLE, canonical};
use crate::diagnostic::{Diagnostic, Place, first};
use crate::keys::{KEYS, KeyInfo};
use crate::plant;
use crate::request::{Entry, meant};
use crate::syntax::parse;

/// Returns true if a file, or a line of it, could not be read: it may have held any key.
fn hides_keys(found: &[Diagnostic]) -> bool {
    found.iter().any(|own| [SYNTAX, UNREADABLE].contains(&own.code))
}

/// The key itself, of one such as `mu.a` or `gains[0]`.
pub fn root(key: &str) -> &str {
    key.split(['.', '[']).next().unwrap_or(key)
}

/// Returns the mistakes in a text and in what its entries mean, in the order of the keys.
pub fn mistakes(
    text: &[Diagnostic],
    entries: &[Entry],
    meaning: Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    let mut all = independent(text, entries, meaning);
    all.extend(text.iter().cloned());
    all.sort_by_key(|d| KEYS.iter().position(|info| info.key == root(&d.key)));
    first(all)
}

/// Returns the mistakes in `meaning` that do not follow from others: a key whose value could not be read or is
/// not legal, or whose name is misspelt, is given and unknown. A mistake follows from such a key if it vanishes
/// with the example of its value.
pub fn independent(
    text: &[Diagnostic],
    entries: &[Entry],
    mut meaning: Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    if hides_keys(text) {
        meaning.retain(|own| own.code != MISSING);
    }
    // What could not be read is given.
    meaning
        .retain(|own| own.code != MISSING || !text.iter().any(|of| is_within(&of.key, &own.key)));
    if !text.is_empty() || meaning.iter().any(|own| own.code == "unknown-key") {
        // What could not be read may use it.
        meaning.retain(|own| own.code != UNUSED);
    }
    let unknown = unknown(text, entries, &meaning);
    let given = &with(entries, &unknown, 0);
    if !unknown.is_empty() {
        let most = unknown.iter().map(|key| examples(key).len()).max().unwrap_or(0);
        let readings: Vec<_> = (0..most).map(|at| read(&with(entries, &unknown, at))).collect();
        let without = read(entries);
        let stays = |own: &Diagnostic| readings.iter().any(|found| found.contains(own));
        meaning.retain(|own| is_name(own) || stays(own) || !without.contains(own));
    }
    let followers = followers(given, &meaning);
    let mut followers = followers.into_iter();
    meaning.retain(|_| !followers.next().unwrap_or(false));
    meaning
}

/// Returns true if a key is another one, or lies in a table or a list that it names.
fn is_within(key: &str, of: &str) -> bool {
    let rest = key.strip_prefix(of);
    !of.is_empty() && rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

fn read(entries: &[Entry]) -> Vec<Diagnostic> {
    plant::read_design(entries).err().unwrap_or_default()
}

/// Returns for each mistake whether it vanishes with a legal value of the key of another one.
fn followers(entries: &[Entry], meaning: &[Diagnostic]) -> Vec<bool> {
    let keys: Vec<_> = meaning.iter().map(|own| key_of(&own.key)).collect();
    let all = || 0..meaning.len();
    // Far too many mistakes are no follow-ups, and each takes a reading.
    if !(2..=MAX_FOLLOWED).contains(&meaning.len()) {
        return vec![false; meaning.len()];
    }
    let base = read(entries);
    let vanish = |at: usize| -> Vec<bool> {
        let is_given = entries.iter().any(|entry| entry.key == keys[at]);
        let most = if is_given { examples(keys[at]).len() } else { 0 };
        let key = [keys[at].to_owned()];
        let readings: Vec<_> = (0..most).map(|own| read(&with(entries, &key, own))).collect();
        let gone = |other: usize| {
            let own = &meaning[other];
            let stays = readings.iter().any(|found| found.contains(own));
            keys[other] != keys[at] && base.contains(own) && !readings.is_empty() && !stays
        };
        all().map(gone).collect()
    };
    let vanish: Vec<_> = all().map(vanish).collect();
    // Of two that vanish with each other the first one stays.
    let follows = |own: usize| all().any(|of| vanish[of][own] && (of < own || !vanish[own][of]));
    all().map(follows).collect()
}

/// Returns the entries with a legal value of each key that is not understood: of several the one at this place.
fn with(entries: &[Entry], keys: &[String], at: usize) -> Vec<Entry> {
    let example = |key: &String| {
        let all = examples(key);
        let text = all.get(at).or(all.last())?;
        let value = parse(key, text, &mut |_| NOWHERE).ok()?;
        Some(Entry { key: key.clone(), place: NOWHERE, value })
    };
    let others = entries.iter().filter(|entry| !keys.contains(&entry.key)).cloned();
    others.chain(keys.iter().filter_map(example)).collect()
}

/// Legal values of a key: several of a number on which the lengths of lists depend.
fn examples(key: &str) -> Vec<&'static str> {
    match KeyInfo::find(key) {
        _ if ["n", "axes"].contains(&key) => vec!["1", "2", "3", "4"],
        Some(info) => vec![info.example],
        None if key.starts_with("params.") => vec!["1"],
        None => Vec::new(),
    }
}

/// The key under which a mistake was made: `mu` of `mu.a`, `gains` of `gains[0]`.
fn key_of(key: &str) -> &str {
    let whole = key.split('[').next().unwrap_or(key);
    KeyInfo::find(root(key)).map_or(whole, |info| info.key)
}

/// Returns the keys that are given and unknown.
fn unknown(text: &[Diagnostic], entries: &[Entry], meaning: &[Diagnostic]) -> Vec<String> {
    let unread = text.iter().map(|own| own.key.split('[').next().unwrap_or_default());
    let misspelt = meaning.iter().filter(|own| is_name(own));
    let misspelt = misspelt.filter_map(|own| meant(own.key.rsplit('.').next()?));
    let mut all = Vec::<String>::new();
    for key in unread.chain(misspelt).map(canonical) {
        // The value of a misspelt key may be unreadable too.
        let key = match examples(key).is_empty() {
            true => key.rsplit('.').next().and_then(meant),
            false => Some(key),
        };
        let is_new = |key: &&str| {
            let given = entries.iter().any(|entry| entry.key == *key);
            !given && all.iter().all(|own| own != key)
        };
        if let Some(key) = key.filter(is_new) {
            all.push(key.to_owned());
        }
    }
    all
}

/// Most mistakes among which follow-ups are looked for.
const MAX_FOLLOWED: usize = 12;

/// Code of a key that is not given.
const MISSING: &str = "missing-key";

/// Code of a parameter that nothing uses.
const UNUSED: &str = "unused-parameter";

/// Returns true if it concerns a name without a meaning.
fn is_name(own: &Diagnostic) -> bool {
    ["unknown-key", UNUSED].contains(&own.code)
}

/// The place of an example.
const NOWHERE: Place = Place(usize::MAX);
