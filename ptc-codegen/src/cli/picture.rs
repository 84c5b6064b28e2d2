//! Files of pictures.

use std::path::Path;

use crate::plot::Picture;

use super::report::Failure;

/// Format of a picture.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    Svg,
    Png,
    Pdf,
}

impl Kind {
    /// The kind of the file at `path`.
    pub(crate) fn of(path: &Path) -> Result<Self, Failure> {
        let extension = path.extension().map(|extension| extension.to_ascii_lowercase());
        match extension.as_ref().and_then(|extension| extension.to_str()) {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            Some("pdf") => Ok(Self::Pdf),
            _ => Err(Failure::because(
                format!("`{}`: unsupported image type", path.display()),
                "give a file that ends in .svg, .png or .pdf, for example --plot run.svg",
            )),
        }
    }

    /// The file of a picture.
    pub(crate) fn file(self, figure: &impl Picture) -> Result<Vec<u8>, Failure> {
        let drawn = match self {
            Self::Svg => figure.svg().map(String::into_bytes),
            Self::Png => figure.png(),
            Self::Pdf => figure.pdf(),
        };
        drawn.map_err(|wrong| undrawn(&wrong))
    }
}

/// A picture that cannot be drawn.
pub(crate) fn undrawn(wrong: &str) -> Failure {
    let help = "see with -o run.csv that the values are numbers of a size that can be drawn";
    Failure::because(format!("the picture cannot be drawn: {wrong}"), help)
}
