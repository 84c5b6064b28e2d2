//! Which closed forms an engine is asked for.

/// Which closed forms are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// r_k alone.
    R,
    /// r_k and B_{i,j}.
    All,
}
