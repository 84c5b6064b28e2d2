//! The closed forms that an engine must give.

/// The closed forms that are needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// r_k alone.
    R,
    /// r_k and B_{i,j}.
    All,
}
