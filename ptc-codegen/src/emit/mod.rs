//! Back ends: one staged program in, source text out.

/// A language to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Language {
    /// C99: a header and a source file.
    C,
    /// Rust, `no_std`: one file that stands alone.
    Rust,
}

/// A generated file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// File name, without a folder.
    pub name: String,
    /// Contents.
    pub text: String,
}
