//! Values that are given beside a design, each in place of the design's own.

/// Whether a value that is given apart, for `key`, overrides the design's entry `own`: they are
/// of one key, or two spellings of the same thing.
pub fn overrides(key: &str, own: &str) -> bool {
    let groups = [["mu", "kappa", ""], ["gains", "poles", "pi0"]];
    // An item of a list goes with the list.
    let own = own.split('[').next().unwrap_or(own);
    key == own || groups.iter().any(|group| group.contains(&key) && group.contains(&own))
}
