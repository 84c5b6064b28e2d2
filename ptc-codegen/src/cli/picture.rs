//! Files of pictures.

use std::path::Path;

use crate::plot::{Format, Picture};

use super::report::Failure;

/// Format of a picture that a path asks for.
#[derive(Clone, Copy)]
pub(crate) struct Kind(Format);

impl Kind {
    /// The kind of the file at `path`.
    pub(crate) fn of(path: &Path) -> Result<Self, Failure> {
        let extension = path.extension().and_then(|extension| extension.to_str());
        extension.and_then(Format::of_extension).map(Self).ok_or_else(|| {
            Failure::because(
                format!("`{}`: unsupported image type", path.display()),
                "give a file that ends in .svg, .png or .pdf, for example --plot run.svg",
            )
        })
    }

    /// The file of a picture.
    pub(crate) fn file(self, figure: &impl Picture) -> Result<Vec<u8>, Failure> {
        self.0.file(figure).map_err(|wrong| undrawn(&wrong))
    }
}

/// A picture that cannot be drawn.
pub(crate) fn undrawn(wrong: &str) -> Failure {
    let help = "see with -o run.csv that the values are numbers of a size that can be drawn";
    Failure::because(format!("the picture cannot be drawn: {wrong}"), help)
}
