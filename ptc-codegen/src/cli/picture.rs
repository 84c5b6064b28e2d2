//! Files of pictures.

use std::path::Path;

use crate::plot::{Format, Picture};

use super::report::Failure;

/// The format of the picture at `path`.
///
/// # Errors
/// A file of another type.
pub(crate) fn format_of(path: &Path) -> Result<Format, Failure> {
    let extension = path.extension().and_then(|extension| extension.to_str());
    extension.and_then(Format::of_extension).ok_or_else(|| {
        Failure::because(
            format!("`{}`: unsupported image type", path.display()),
            "give a file that ends in .svg, .png or .pdf, for example --plot run.svg",
        )
    })
}

/// The file of a picture.
///
/// # Errors
/// A drawing that cannot be made.
pub(crate) fn file_of(format: Format, figure: &impl Picture) -> Result<Vec<u8>, Failure> {
    format.file(figure).map_err(|wrong| undrawn(&wrong))
}

/// A picture that cannot be drawn.
pub(crate) fn undrawn(wrong: &str) -> Failure {
    let help = "see with -o run.csv that the values are numbers of a size that can be drawn";
    Failure::because(format!("the picture cannot be drawn: {wrong}"), help)
}
