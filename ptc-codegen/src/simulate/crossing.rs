//! Detection of functions that are positive at the begin of a step and become negative in it.

/// Points of a step at which its functions are known, evenly from its begin to its end.
pub(super) const NODES: usize = 7;

/// Rounding of the parts of a slide, which may be sums of terms that cancel.
pub(super) const PART: f64 = 1e-11;

/// Rounding of a function, as a part of its size.
const ROUNDED: f64 = 1e-9;

/// Observation of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Step {
    /// Every function stays positive.
    Clear,
    /// A function may become negative between the nodes.
    Coarse,
    /// A function has no value.
    NoNumber,
    /// Some are the first to become negative: before this node, and not before the node before it.
    Event { node: usize },
}

/// Looks at the values of all functions at each node.
///
/// `slides` says that the last two functions are the parts of a slide, which are near 1 where they are not near 0.
pub(super) fn look(table: &[Vec<f64>], slides: bool) -> Step {
    let count = table.first().map_or(0, Vec::len);
    let of_slide = count - if slides { 2.min(count) } else { 0 };
    let mut first: Option<usize> = None;
    let functions = (0..count).map(|which| std::array::from_fn(|node| table[node][which]));
    for (which, values) in functions.enumerate() {
        let values: [f64; NODES] = values;
        if values.iter().any(|value| value.is_nan()) {
            return Step::NoNumber;
        }
        // What is not positive at the begin is a rounding of the event that led there.
        let negative = (1..NODES).find(|node| values[*node] < 0.0);
        let before = negative.unwrap_or(NODES);
        if is_coarse(&values, before, if which < of_slide { 0.0 } else { PART / ROUNDED }) {
            return Step::Coarse;
        }
        first = first.into_iter().chain(negative).min();
    }
    first.map_or(Step::Clear, |node| Step::Event { node })
}

/// Returns true if the cubic through every other node misses the nodes between by so much that the sign before node
/// `before` is not certain. The rounding of a function is that of a size of at least `least`; one that is infinite
/// somewhere counts as it is at the nodes.
pub(super) fn is_coarse(values: &[f64; NODES], before: usize, least: f64) -> bool {
    if !values.iter().all(|value| value.is_finite()) {
        return false;
    }
    let [a, b, c, d] = [values[0], values[2], values[4], values[6]];
    let between = [
        (5.0 * a + 15.0 * b - 5.0 * c + d) / 16.0,
        (-a + 9.0 * b + 9.0 * c - d) / 16.0,
        (a - 5.0 * b + 15.0 * c + 5.0 * d) / 16.0,
    ];
    let off = between.iter().zip([1, 3, 5]).map(|(value, node)| (value - values[node]).abs());
    let off = off.fold(0.0, f64::max);
    let size = values.iter().fold(least, |most: f64, value| most.max(value.abs()));
    if off <= ROUNDED * size {
        return false;
    }
    if before < NODES {
        return off > 0.05 * size;
    }
    let least = values[1..].iter().copied().fold(f64::INFINITY, f64::min);
    least <= 2.0 * off
}
