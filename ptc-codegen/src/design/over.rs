//! Values that are given beside a design, each in place of the design's own.

/// Keys that say the same thing in other ways.
const ALTERNATIVES: [&[&str]; 4] =
    [&["mu", "kappa"], &["gains", "poles", "pi0"], &["u_max", "limits"], &["C", "measured"]];

/// Returns true if a value that is given apart, for `key`, overrides the design's entry `own`: they are
/// of one key, or two spellings of the same thing.
pub fn overrides(key: &str, own: &str) -> bool {
    // An item of a list goes with the list.
    let own = own.split('[').next().unwrap_or(own);
    key == own || ALTERNATIVES.iter().any(|group| group.contains(&key) && group.contains(&own))
}
