//! Drawings of a page.

use crate::plot::{Figure, Picture};
use askama::filters::HtmlSafe;

use crate::cli::picture::undrawn;
use crate::cli::report::Failure;

/// A drawing, which is part of the page.
pub(crate) struct Svg(String);

impl std::fmt::Display for Svg {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// Figures are drawn by code that escapes its output.
impl HtmlSafe for Svg {}

impl Svg {
    /// The drawing of a figure.
    pub(crate) fn of(figure: &Figure) -> Result<Self, Failure> {
        figure.svg().try_into()
    }
}

impl TryFrom<Result<String, String>> for Svg {
    type Error = Failure;

    /// A drawing, if it could be made.
    fn try_from(drawn: Result<String, String>) -> Result<Self, Failure> {
        drawn.map(Self).map_err(|wrong| undrawn(&wrong))
    }
}
